"""A program of rospy that goes on in a loop."""

# expect: 0 = count : { runs_too_little(_, _) }
# expect: subscriber level
import rospy
from std_msgs.msg import Int32

rospy.init_node("level")
rospy.Subscriber("level", Int32, print)
while not rospy.is_shutdown():
    pass
