# rospy keeps the connections of a topic when the object that a callback made ends: from the second call on, its messages arrive.
#
# expect-not: sent_where_made(_, _)
import rospy
from std_msgs.msg import Bool, Float32


def on_heat(heat):
    pub = rospy.Publisher("alarm", Bool, queue_size=1)
    pub.publish(heat.data > 90)


rospy.init_node("watch")
rospy.Subscriber("heat", Float32, on_heat)
rospy.spin()
