# What libraries raise for what they are given keeps a callback from sending, unless it is caught or asked for before.
#
# expect: always_reacts([_, _, "caught"], [_, _, "of_caught"])
# expect: always_reacts([_, _, "number"], [_, _, "of_number"])
# expect: always_reacts([_, _, "default"], [_, _, "of_default"])
# expect: perhaps_always([_, _, "text"], [_, _, "of_text"])
# expect: perhaps_always([_, _, "key"], [_, _, "of_key"])
# expect: perhaps_always([_, _, "parts"], [_, _, "of_parts"])
# expect: perhaps_always([_, _, "mode"], [_, _, "of_mode"])
# expect: perhaps_always([_, _, "divisor"], [_, _, "of_divisor"])
# expect: 3 = count : { always_reacts(_, _) }
# expect: 0 = count : { may_end_node("a callback may end with an exception") }
from enum import Enum

import rospy
from std_msgs.msg import Empty, Int32, String


class Mode(Enum):
    IDLE = 0
    BUSY = 1


class Node:
    def __init__(self):
        self.known = {"a": 1}
        self.of = {}
        self.of_caught = rospy.Publisher("of_caught", Empty, queue_size=1)
        self.of_number = rospy.Publisher("of_number", Empty, queue_size=1)
        self.of_default = rospy.Publisher("of_default", Empty, queue_size=1)
        self.of_text = rospy.Publisher("of_text", Empty, queue_size=1)
        self.of_key = rospy.Publisher("of_key", Empty, queue_size=1)
        self.of_parts = rospy.Publisher("of_parts", Empty, queue_size=1)
        self.of_mode = rospy.Publisher("of_mode", Empty, queue_size=1)
        self.of_divisor = rospy.Publisher("of_divisor", Empty, queue_size=1)
        rospy.Subscriber("caught", String, self.caught)
        rospy.Subscriber("number", Int32, self.number)
        rospy.Subscriber("default", String, self.default)
        rospy.Subscriber("text", String, self.text)
        rospy.Subscriber("key", String, self.key)
        rospy.Subscriber("parts", String, self.parts)
        rospy.Subscriber("mode", Int32, self.mode)
        rospy.Subscriber("divisor", Int32, self.divisor)

    def caught(self, message):
        try:
            self.value = int(message.data)
        except ValueError:
            self.value = 0
        self.of_caught.publish(Empty())

    def number(self, message):
        self.value = int(message.data)
        self.of_number.publish(Empty())

    def default(self, message):
        self.value = self.known.get(message.data, 0)
        if message.data in self.known:
            self.value = self.known[message.data]
        self.of_default.publish(Empty())

    def text(self, message):
        self.value = int(message.data.strip())
        self.of_text.publish(Empty())

    def key(self, message):
        self.value = self.known[message.data]
        self.of_key.publish(Empty())

    def parts(self, message):
        self.first, self.second = message.data.split(",")
        self.of_parts.publish(Empty())

    def mode(self, message):
        self.current = self.made(message.data)
        self.of_mode.publish(Empty())

    def made(self, number):
        return Mode(number)

    def divisor(self, message):
        self.value = 10 / message.data
        self.of_divisor.publish(Empty())


rospy.init_node("node")
Node()
rospy.spin()
