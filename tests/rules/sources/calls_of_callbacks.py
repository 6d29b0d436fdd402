#!/usr/bin/env python
# Arguments that go with a callback: behind what it is called with.
#
# expect: publisher left/value
# expect: publisher right/value
# expect: publisher method/value
# expect: publisher filtered/first
# expect: publisher filtered/second
# expect-only: publisher
# expect-not: _result(_, _); _assigned(_); _passed_to(_, _); _assigned_place(_, _)

import message_filters
import rospy
from std_msgs.msg import Empty, String


def send(name):
    rospy.Publisher(name + "/value", Empty, queue_size=1)


def on_side(message, side):
    send(side)


def on_filtered(message, first, second):
    rospy.Publisher("filtered/" + first, Empty, queue_size=1)
    rospy.Publisher("filtered/" + second, Empty, queue_size=1)


class Node:
    def __init__(self):
        rospy.Subscriber("in", String, self.on_message, "method")

    def on_message(self, message, name):
        send(name)


rospy.init_node("bound")
rospy.Subscriber("in", String, on_side, "left")
rospy.Subscriber("in", String, callback=on_side, callback_args="right")
filtered = message_filters.Subscriber("filter", String)
filtered.registerCallback(on_filtered, "first", "second")
node = Node()
rospy.spin()
