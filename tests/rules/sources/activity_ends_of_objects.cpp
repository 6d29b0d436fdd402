// What objects do at their end: those of a block when it is left, whichever way; not those that live as long as the component.
//
// expect: enters(C, F), function_name(F, "Worker::Stopwatch::~Stopwatch")
// expect: reactive /in -> /taken must
// expect: reactive /in -> /last must
// expect: reactive /in -> /out may
// expect-only: reactive /in -> *
#include <memory>
#include <ros/ros.h>
#include <std_msgs/Int32.h>

struct Last {
  ~Last();
  ros::Publisher* last_pub_;
};

Last::~Last() { last_pub_->publish(std_msgs::Int32()); }

struct Later : Last {
  explicit Later(ros::Publisher* last_pub) { last_pub_ = last_pub; }
};

class Worker {
public:
  Worker() {
    taken_pub_ = nh_.advertise<std_msgs::Int32>("/taken", 1);
    last_pub_ = nh_.advertise<std_msgs::Int32>("/last", 1);
    out_pub_ = nh_.advertise<std_msgs::Int32>("/out", 1);
    kept_pub_ = nh_.advertise<std_msgs::Int32>("/kept", 1);
    sub_ = nh_.subscribe("/in", 1, &Worker::onIn, this);
  }

private:
  class Stopwatch {
  public:
    explicit Stopwatch(Worker& worker) : worker_(worker) {}
    ~Stopwatch() { worker_.tell(); }

  private:
    Worker& worker_;
  };

  struct Kept {
    explicit Kept(Worker& worker) : worker_(worker) {}
    ~Kept() { worker_.kept_pub_.publish(std_msgs::Int32()); }
    Worker& worker_;
  };

  void tell() { taken_pub_.publish(std_msgs::Int32()); }

  void onIn(const std_msgs::Int32ConstPtr& message) {
    Stopwatch watch(*this);
    Later later(&last_pub_);
    kept_ = std::make_shared<Kept>(*this);
    std::shared_ptr<Kept> other = kept_;
    if (message->data < 0) return;
    out_pub_.publish(*message);
  }

  ros::NodeHandle nh_;
  ros::Publisher taken_pub_, last_pub_, out_pub_, kept_pub_;
  ros::Subscriber sub_;
  std::shared_ptr<Kept> kept_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "worker");
  Worker worker;
  ros::spin();
}
