# What Python gives a parameter without an argument is evaluated where the function is defined: a variable may have changed since.
#
# expect: argument_given(_, _, "limit", _)
# expect: 0 = count : { argument_given(_, _, "was", _) }
# expect: transition(_, V, _), variable_name(V, "on")
import rospy
from std_msgs.msg import Bool, Empty


class Node:
    def __init__(self):
        self.on = False
        self.pub = rospy.Publisher("out", Empty, queue_size=1)
        rospy.Subscriber("in", Bool, self.on_in)
        rospy.Subscriber("set", Bool, self.on_set)

    def on_set(self, message):
        setattr(self, "o" + "n", message.data)

    def on_in(self, message):
        def go(was=self.on):
            if was and not self.on:
                self.pub.publish(Empty())

        go()
        self.limited()

    def limited(self, limit=3):
        if limit > 2:
            self.pub.publish(Empty())


rospy.init_node("node")
Node()
rospy.spin()
