#include <map>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <std_srvs/Empty.h>

static void fill(ros::Publisher &publisher, ros::NodeHandle &node)
{
  publisher = node.advertise<std_msgs::Empty>("filled", 1);
}

class Reporter
{
public:
  Reporter()
  {
    made_ = node_.advertise<std_msgs::Empty>("made", 1);
    fill(filled_, node_);
    table_["key"] = made_;
    subscriber_ = node_.subscribe("reported", 1, &Reporter::callback, this);
  }

private:
  void callback(const std_msgs::Empty &message)
  {
    if (forgotten_.getNumSubscribers() > 0)
      forgotten_.publish(message);  // expect: finding publisher-not-made "* sends through forgotten_, which is never assigned"
    std_srvs::Empty request;
    client_.call(request);          // expect: finding publisher-not-made "* sends through client_, which is never assigned"
    made_.publish(message);         // expect-not: finding publisher-not-made
    filled_.publish(message);       // expect-not: finding publisher-not-made
    table_["key"].publish(message); // expect-not: finding publisher-not-made
    given_->publish(message);       // expect-not: finding publisher-not-made
  }

public:
  ros::Publisher *given_;

private:
  ros::NodeHandle node_;
  ros::Publisher made_, filled_, forgotten_;
  ros::ServiceClient client_;
  ros::Subscriber subscriber_;
  std::map<std::string, ros::Publisher> table_;
};

int main(int argc, char **argv)
{
  ros::init(argc, argv, "reporter");
  ros::NodeHandle node;
  ros::Publisher given = node.advertise<std_msgs::Empty>("given", 1);
  Reporter reporter;
  reporter.given_ = &given;
  ros::spin();
}
