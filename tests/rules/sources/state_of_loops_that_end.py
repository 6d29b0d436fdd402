#!/usr/bin/env python
# What arrives while a program goes through its steps decides how long it sends; what it only tests before it sends anything does not.
#
# expect: state angle = 0
# expect: transition angle = message.data on angle
# expect-only: state
# expect: 14 = count : { evaluable(_) }
import rospy
from std_msgs.msg import Float32, String


class Turn:
    def __init__(self):
        self.angle = 0
        self.level = 0
        rospy.Subscriber("angle", Float32, self.on_angle)
        rospy.Subscriber("level", Float32, self.on_level)
        self.pub = rospy.Publisher("turn", String, queue_size=1)

    def on_angle(self, message):
        self.angle = message.data

    def on_level(self, message):
        self.level = message.data

    def align(self):
        angle = self.angle
        while angle < -0.1 or angle > 0.1:
            self.pub.publish("on")
            rospy.sleep(0.05)
            angle = self.angle

    def start(self):
        if self.level > 0:
            self.pub.publish("start")


rospy.init_node("turn")
turn = Turn()
turn.start()
turn.align()
