// What a container holds goes elsewhere: it is swapped, or moved, and begins anew.
//
// expect: transition(E, V, _), assignment(E, V, "argument"), variable_name(V, "swapped_")
// expect: transition(E, V, _), assignment(E, V, "argument"), variable_name(V, "exchanged_")
// expect: transition(E, V, _), assignment(E, V, "argument"), variable_name(V, "moved_")
#include <utility>
#include <vector>
#include <ros/ros.h>
#include <std_msgs/Int32.h>

class Batches {
public:
  Batches() {
    out_ = nh_.advertise<std_msgs::Int32>("out", 1);
    in_ = nh_.subscribe("in", 1, &Batches::onIn, this);
  }

private:
  void onIn(const std_msgs::Int32& message) {
    swapped_.push_back(message.data);
    exchanged_.push_back(message.data);
    moved_.push_back(message.data);
    if (swapped_.size() == 3) {
      out_.publish(message);
      std::vector<int> batch;
      batch.swap(swapped_);
    }
    if (exchanged_.size() == 4) {
      out_.publish(message);
      std::vector<int> batch;
      std::swap(batch, exchanged_);
    }
    if (moved_.size() == 5) {
      out_.publish(message);
      last_ = std::move(moved_);
    }
  }
  ros::NodeHandle nh_;
  ros::Publisher out_;
  ros::Subscriber in_;
  std::vector<int> swapped_, exchanged_, moved_, last_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "batches");
  Batches batches;
  ros::spin();
}
