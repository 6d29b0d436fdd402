#!/usr/bin/env python3
# Parts of messages that have another name.
# expect-not: content_given(_, "linear.x", D, _), location(D, _, 20, _)
# expect-not: content_given(_, "linear.x", D, _), location(D, _, 26, _)
# expect: content_given(_, "angular.z", D, _), location(D, _, 21, _)
import rospy
from geometry_msgs.msg import Twist


class Teller:
    def __init__(self):
        self.speed = rospy.Publisher("speed", Twist, queue_size=1)
        rospy.Subscriber("in", Twist, self.on_in)

    def slow(self, part):
        part.x = 0.5

    def on_in(self, given):
        message = Twist()
        message.linear.x = 1.0
        message.angular.z = 1.0
        part = message.linear
        part.x = given.linear.x
        self.speed.publish(message)
        other = Twist()
        other.linear.x = 1.0
        self.slow(other.linear)
        self.speed.publish(other)


if __name__ == "__main__":
    rospy.init_node("teller")
    Teller()
    rospy.spin()
