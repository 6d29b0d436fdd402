#!/usr/bin/env python3
# Timers of Python's library: they run once, and again when what they run makes the next one.
#
# expect: periodic beat 2 Hz mechanism=timer
# expect: one_shot late 3 s
# expect: 1 = count : { one_shot(_) }
# expect-not: periodic late
import threading

import rospy
from std_msgs.msg import Bool, String


class Beacon:
    def __init__(self):
        self.on = False
        self.beat = rospy.Publisher("beat", Bool, queue_size=1)
        self.late = rospy.Publisher("late", String, queue_size=1)
        rospy.Subscriber("go", Bool, self.go)
        self.tick()

    def tick(self):
        self.beat.publish(self.on)
        self.next()

    def next(self):
        self.timer = threading.Timer(0.5, self.tick)
        self.timer.start()

    def go(self, message):
        threading.Timer(3.0, self.end, ["late"]).start()

    def end(self, text):
        if not self.on:
            self.late.publish(text)
        self.on = True  # expect: transition Beacon::on = True


rospy.init_node("beacon")
Beacon()
rospy.spin()
