#!/usr/bin/env python3
# Loops that wait for what is left of a period, and periods that are bounded.
#
# expect: periodic rest 2 Hz mechanism=sleep
# expect: periodic local 4 Hz mechanism=sleep
# expect: periodic longest 5 Hz mechanism=sleep
# expect: periodic shortest 10 Hz mechanism=sleep
import time

import rospy
from std_msgs.msg import Bool


def rest(period):
    publisher = rospy.Publisher("rest", Bool, queue_size=1)
    while not rospy.is_shutdown():
        start = time.time()
        publisher.publish(True)
        left = period - (time.time() - start)
        if left > 0:
            time.sleep(left)


def local():
    publisher = rospy.Publisher("local", Bool, queue_size=1)
    while not rospy.is_shutdown():
        start = time.monotonic()
        publisher.publish(True)
        passed = time.monotonic() - start
        time.sleep(0.25 - passed)


def bounded(period):
    longest = rospy.Publisher("longest", Bool, queue_size=1)
    while not rospy.is_shutdown():
        longest.publish(True)
        time.sleep(max(0.2, period))


def bounded_below(period):
    shortest = rospy.Publisher("shortest", Bool, queue_size=1)
    while not rospy.is_shutdown():
        shortest.publish(True)
        time.sleep(min(1.0, period))


rospy.init_node("waits")
rest(0.5)
local()
bounded(0.1)
bounded_below(0.1)
