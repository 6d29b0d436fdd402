# A constant of a message is no class of messages.
#
# expect: Count = count : { value_kind(E, Kind), contains("the class", Kind), location(E, _, Line, _), Line > 11 }, Count = 1
import rospy
from std_msgs.msg import Header
from visualization_msgs.msg import Marker

rospy.init_node("m")
pub = rospy.Publisher("marker", Marker, queue_size=1)
marker = Marker()
marker.type = Marker.SPHERE
marker.action = Marker.ADD
pub.publish(Marker(type=Marker.SPHERE))
marker.header = Header
pub.publish(marker)
