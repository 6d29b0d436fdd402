# Calls in conditions that give something else when they are asked again: random numbers, the time, elements that are taken out, a method that
# asks for such; not the size of a list.
#
# expect: gives_another("self.waiting.popleft()")
# expect: gives_another("random.random()")
# expect: gives_another("self.is_lucky()")
# expect: 3 = count : { gives_another(_) }
import random
from collections import deque

import rospy
from std_msgs.msg import Empty


class Node:
    def __init__(self):
        self.waiting = deque()
        self.pub = rospy.Publisher("out", Empty, queue_size=1)
        rospy.Subscriber("in", Empty, self.on_in)

    def on_in(self, msg):
        self.waiting.append(1)
        if len(self.waiting) > 1 and self.waiting.popleft() == 1:
            self.pub.publish(Empty())
        if random.random() > 0.5:
            self.pub.publish(Empty())
        if self.is_lucky():
            self.pub.publish(Empty())

    def is_lucky(self):
        return random.random() > 0.5


rospy.init_node("node")
Node()
rospy.spin()
