# Names that mean something else when they are asked again: a local that is given another value, one of a function that is called; not a message that
# is handed on, be it by several calls, nor a local that keeps its value. What calls give a parameter of another name may differ.
#
# expect: unsteady_name("ok")
# expect: unsteady_name("d")
# expect: unsteady_name("text")
# expect: 3 = count : { unsteady_name(_) }
import random

import rospy
from std_msgs.msg import Empty, Float64


class Node:
    def __init__(self):
        self.pub = rospy.Publisher("out", Empty, queue_size=1)
        rospy.Subscriber("in", Float64, self.on_in)
        rospy.Subscriber("joy", Float64, self.on_joy)

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

    def on_joy(self, joy):
        if joy.data > 7:
            self.run(joy, "high")
        elif joy.data < 1:
            self.run(joy, "low")
        self.pub.publish(Empty())

    def run(self, joy, text):
        if joy.data != 0:
            self.pub.publish(Empty())
        if text == "low":
            self.pub.publish(Empty())

    def deep(self):
        d = random.random()
        if d < 0.5:
            self.pub.publish(Empty())


rospy.init_node("node")
Node()
rospy.spin()
