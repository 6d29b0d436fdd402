// Ports that libraries make: of actions, of reconfigurable parameters, of updaters and listeners.
//
// expect: N = count : { implicit_port(_, _) }, N = 32
// expect: N = count : { implicit_port_callback(_, _) }, N = 3
// expect: N = count : { hidden_site(_, _) }, N = 4
// expect: N = count : { hidden_namespace(_, _) }, N = 4
// expect: subscriber move/goal move_base_msgs/MoveBaseActionGoal implicit callback=Node::onGoal
// expect: subscriber move/cancel actionlib_msgs/GoalID implicit callback=Node::onPreempt
// expect: subscriber dock/result move_base_msgs/MoveBaseActionResult implicit callback=Node::onDone
// expect: service_server ~set_parameters implicit
// expect: service_server set_parameters implicit
// expect: service_server tuned/set_parameters implicit
// expect: service_server ~load_nodelet nodelet/NodeletLoad implicit
// expect: 3 = count : { message_arrives(_, _) }
// expect: N = count : { port_callback(_, _) }, N = 4
#include <actionlib/client/simple_action_client.h>
#include <actionlib/server/simple_action_server.h>
#include <diagnostic_updater/diagnostic_updater.h>
#include <dynamic_reconfigure/server.h>
#include <interactive_markers/interactive_marker_server.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <nodelet/loader.h>
#include <ros/ros.h>
#include <tf2_ros/transform_listener.h>
#include <tuning/TuneConfig.h>

typedef actionlib::SimpleActionServer<move_base_msgs::MoveBaseAction> Server;
typedef actionlib::SimpleActionClient<move_base_msgs::MoveBaseAction> Client;

class Node
{
public:
  Node() : server_(nh_, "move", false), other_(nh_, "other", boost::bind(&Node::execute, this, _1), false), client_("dock", true), markers_("markers")
  {
    server_.registerGoalCallback(boost::bind(&Node::onGoal, this));
    server_.registerPreemptCallback(boost::bind(&Node::onPreempt, this));
    server_.start();
  }
  void send()
  {
    client_.sendGoal(move_base_msgs::MoveBaseGoal(), boost::bind(&Node::onDone, this, _1, _2));
  }

private:
  void onGoal()
  {
    send();
  }
  void onPreempt()
  {
  }
  void execute(const move_base_msgs::MoveBaseGoalConstPtr& goal)
  {
  }
  void onDone(const actionlib::SimpleClientGoalState& state, const move_base_msgs::MoveBaseResultConstPtr& result)
  {
  }

  ros::NodeHandle nh_;
  Server server_, other_;
  Client client_;
  diagnostic_updater::Updater updater_;
  interactive_markers::InteractiveMarkerServer markers_;
  tf2_ros::Buffer buffer_;
};

void never()
{
  Client client("never", true);
  diagnostic_updater::Updater updater;
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  Node node;
  tf2_ros::Buffer buffer;
  tf2_ros::TransformListener listener(buffer);
  nodelet::Loader loader;
  nodelet::Loader silent(false);
  ros::NodeHandle nh, tuned("tuned");
  dynamic_reconfigure::Server<tuning::TuneConfig> own;
  dynamic_reconfigure::Server<tuning::TuneConfig> global(nh);
  dynamic_reconfigure::Server<tuning::TuneConfig> named(tuned);
  ros::spin();
}
