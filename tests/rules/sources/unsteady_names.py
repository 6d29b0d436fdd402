# Names that mean something else when they are asked again: a local that is given another value, one of a function that is called; not a message that
# is handed on, nor a local that keeps its value.
#
# expect: unsteady_name("ok")
# expect: unsteady_name("d")
# expect: 2 = count : { unsteady_name(_) }
import random

import rospy
from std_msgs.msg import Empty, Float64


class Node:
    def __init__(self):
        self.pub = rospy.Publisher("out", Empty, queue_size=1)
        rospy.Subscriber("in", Float64, self.on_in)

    def on_in(self, msg):
        ok = random.random() > 0.5
        if ok:
            ok = random.random() > 0.5
            if not ok:
                self.pub.publish(Empty())
        kept = msg.data
        if kept > 3:
            self.pub.publish(Empty())
        elif kept > 2:
            self.handle(msg)
        d = random.random()
        if d > 0.5:
            self.deep()

    def handle(self, msg):
        if msg.data > 5:
            self.pub.publish(Empty())

    def deep(self):
        d = random.random()
        if d < 0.5:
            self.pub.publish(Empty())


rospy.init_node("node")
Node()
rospy.spin()
