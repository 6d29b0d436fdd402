// A macro that nothing defines may do in a method of a node what the method could; the head of a loop does not, nor does what stands in other code.
//
// expect: open_line("ports", F, 18, ["macro", "ABSENT_PARAMETERS"])
// expect: open_line("params", F, 18, ["macro", "ABSENT_PARAMETERS"])
// expect: Count = count : { open_line("ports", F, Line, ["macro", Name]) }, Count = 1
#include <absent_a/macros.hpp>
#include <rclcpp/rclcpp.hpp>

struct Plain
{
  int work(int x) { ABSENT_STEP(x) return x; }
};

class One : public rclcpp::Node
{
public:
  One() : rclcpp::Node("one") { init(); }
  void init() { ABSENT_PARAMETERS(rate_, validate) plain_.work(rate_); }
  void validate()
  {
    ABSENT_EACH(i, rate_) { plain_.work(i); }
    EIGEN_ABSENT(rate_) plain_.work(1);
  }

private:
  void never_called() { ABSENT_NEVER(rate_) plain_.work(2); }

  int rate_;
  Plain plain_;
};

int main(int argc, char** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<One>());
}
