"""Frames that Python sends: fields of a message, arguments of tf's broadcaster, and one that nothing tells."""

# expect: Count = count : { sends_frame(C, Child, P) }, Count = 2
# expect: sends_frame(_, "base", "")
# expect: sends_frame(_, "laser", "")
# expect: may_send_frame(_, "odom", "")
# expect: Count = count : { sends_other_frame(C) }, Count = 1
import rospy
import tf
import tf2_ros
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry


class Base:
    def __init__(self):
        self.broadcaster = tf2_ros.TransformBroadcaster()
        self.old = tf.TransformBroadcaster()
        rospy.Subscriber("odom", Odometry, self.moved)

    def moved(self, odometry):
        transform = TransformStamped()
        transform.header.frame_id = "odom"
        transform.child_frame_id = "base"
        self.broadcaster.sendTransform(transform)
        self.old.sendTransform((0, 0, 1), (0, 0, 0, 1), rospy.Time.now(), "laser", "base")
        other = TransformStamped()
        other.child_frame_id = odometry.child_frame_id
        self.broadcaster.sendTransform(other)


rospy.init_node("base")
Base()
rospy.spin()
