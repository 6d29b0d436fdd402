#!/usr/bin/env python3
# What messages hold that are made where they are sent, or of what rospy is given.
#
# expect: content_given(C, "data", C, V), location(C, _, 26, _), expr_text(V, "True")
# expect: content_given(K, "data", K, V), content_sent(C, K), location(C, _, 28, _), expr_text(V, "self.mode")
# expect: content_given(K, "data", K, V), content_sent(C, K), location(C, _, 30, _), expr_text(V, "self.mode + 1")
# expect-not: content_sent(C, _), location(C, _, 31, _)
# expect: constant_called("STOP", "3")
# expect: sends_constants([S, "publisher", "mode"])
# expect-not: sends_constants([S, "publisher", "next"])
import rospy
from std_msgs.msg import Bool, UInt8

STOP = 3


class Teller:
    def __init__(self):
        self.mode = STOP
        self.flag = rospy.Publisher("flag", Bool, queue_size=1)
        self.out = rospy.Publisher("mode", UInt8, queue_size=1)
        self.next = rospy.Publisher("next", UInt8, queue_size=1)
        rospy.Subscriber("in", UInt8, self.on_in)

    def on_in(self, msg):
        self.flag.publish(True)
        self.mode = STOP
        self.out.publish(UInt8(self.mode))
        if msg.data:
            self.next.publish(UInt8(data=self.mode + 1))
        self.next.publish(msg)


if __name__ == "__main__":
    rospy.init_node("teller")
    Teller()
    rospy.spin()
