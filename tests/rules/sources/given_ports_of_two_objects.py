# Two objects of one class that read the same topic and send through topics of their own: both send what they read.
#
# expect: port_flow([_, _, "tick"], [_, _, "first"], "data", "reactive")
# expect: port_flow([_, _, "tick"], [_, _, "second"], "data", "reactive")
# expect: reacts([_, _, "tick"], [_, _, "first"], _)
# expect-not: port_flow([_, _, "left"], [_, _, "to_right"], _, _)
# expect: port_flow([_, _, "left"], [_, _, "to_left"], _, _)
import rospy
from std_msgs.msg import Empty


class Divider:
    def __init__(self, source, target):
        self.pub = rospy.Publisher(target, Empty, queue_size=1)
        rospy.Subscriber(source, Empty, self.on_message)

    def on_message(self, message):
        self.pub.publish(message)


class Side:
    def __init__(self, source, target):
        self.pub = rospy.Publisher(target, Empty, queue_size=1)
        rospy.Subscriber(source, Empty, self.on_message)

    def on_message(self, message):
        self.pub.publish(message)


rospy.init_node("dividers")
one = Divider("tick", "first")
two = Divider("tick", "second")
left = Side("left", "to_left")
right = Side("right", "to_right")
rospy.spin()
