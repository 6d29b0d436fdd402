#!/usr/bin/env python
# Arguments of the function that a thread runs.
#
# expect: publisher first
# expect: publisher second
# expect: publisher third
# expect-only: publisher
# expect: periodic first 5 Hz
# expect: periodic second 20 Hz
# expect-only: periodic
# expect: 7 = count : { as_given(_, _, _) }, 1 = count : { sleeps_within(_) }
import _thread
import threading

import rospy
from std_msgs.msg import String


class Talker:
    def __init__(self):
        publisher = rospy.Publisher("first", String, queue_size=1)
        self.thread = threading.Thread(target=self.talk, args=(publisher, 5))
        self.thread.start()

    def talk(self, publisher, frequency):
        rate = rospy.Rate(frequency)
        while not rospy.is_shutdown():
            publisher.publish("talk")
            rate.sleep()


def repeat(publisher, period):
    while True:
        publisher.publish("again")
        rospy.sleep(period)


def tell(publisher):
    publisher.publish("once")


rospy.init_node("threads")
Talker()
threading.Thread(None, repeat, "repeating", [rospy.Publisher("second", String, queue_size=1), 0.05]).start()
_thread.start_new_thread(tell, (rospy.Publisher("third", String, queue_size=1),))
rospy.spin()
