// Who drags a marker, or chooses from the menu of one, makes a function run that the server or the menu was given.
//
// expect: subscriber markers/feedback visualization_msgs/InteractiveMarkerFeedback implicit
// expect: reactive markers/feedback -> moved
// expect: reactive markers/feedback -> chosen
// expect: reactive markers/feedback -> deeper
// expect: reactive markers/feedback -> set
// expect: 4 = count : { port_callback(_, _) }
// expect: 4 = count : { reacts(_, _, _) }
#include <interactive_markers/interactive_marker_server.h>
#include <interactive_markers/menu_handler.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>

using visualization_msgs::InteractiveMarkerFeedbackConstPtr;

class Markers {
public:
  Markers() : server_(new interactive_markers::InteractiveMarkerServer("markers")) {
    moved_ = nh_.advertise<std_msgs::Empty>("moved", 1);
    chosen_ = nh_.advertise<std_msgs::Empty>("chosen", 1);
    deeper_ = nh_.advertise<std_msgs::Empty>("deeper", 1);
    set_ = nh_.advertise<std_msgs::Empty>("set", 1);
    visualization_msgs::InteractiveMarker marker;
    server_->insert(marker, boost::bind(&Markers::onDrag, this, _1));
    server_->setCallback("other", boost::bind(&Markers::onSet, this, _1));
    interactive_markers::MenuHandler::EntryHandle parent = menu_.insert("go", boost::bind(&Markers::onChoice, this, _1));
    menu_.insert(parent, "far", boost::bind(&Markers::onDeeper, this, _1));
    menu_.apply(*server_, "marker");
    server_->applyChanges();
  }

private:
  void onDrag(const InteractiveMarkerFeedbackConstPtr& feedback) { moved_.publish(std_msgs::Empty()); }
  void onSet(const InteractiveMarkerFeedbackConstPtr& feedback) { set_.publish(std_msgs::Empty()); }
  void onChoice(const InteractiveMarkerFeedbackConstPtr& feedback) { chosen_.publish(std_msgs::Empty()); }
  void onDeeper(const InteractiveMarkerFeedbackConstPtr& feedback) { deeper_.publish(std_msgs::Empty()); }

  ros::NodeHandle nh_;
  ros::Publisher moved_, chosen_, deeper_, set_;
  boost::shared_ptr<interactive_markers::InteractiveMarkerServer> server_;
  interactive_markers::MenuHandler menu_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "markers");
  Markers markers;
  ros::spin();
}
