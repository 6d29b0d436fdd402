#!/usr/bin/env python3
# The elements of a list that a loop goes through part where they are compared: each takes its own way.
#
# expect: publisher guidance/los
# expect: publisher pose
# expect: publisher twist
# expect: publisher wheels/left
# expect: publisher wheels/right
# expect: publisher arm/status
# expect: publisher lamps/front
# expect: publisher lamps/rear
# expect: publisher spare/front
# expect: publisher spare/rear
# expect: publisher spare/top
# expect-only: publisher
import rospy
from std_msgs.msg import Empty

EXTRA = ["top"]


class Board:
    def __init__(self):
        self.out = []
        for topic in ["pose", "los", "twist"]:
            if topic == "los":
                self.out.append(rospy.Publisher("guidance/" + topic, Empty, queue_size=1))
                continue
            self.out.append(rospy.Publisher(topic, Empty, queue_size=1))
        for part in ("left", "arm", "right"):
            if part not in ("left", "right"):
                self.out.append(rospy.Publisher(part + "/status", Empty, queue_size=1))
            else:
                self.out.append(rospy.Publisher("wheels/" + part, Empty, queue_size=1))
        for lamp in ["front", "rear", "top"]:
            if lamp != "top":
                self.out.append(rospy.Publisher("lamps/" + lamp, Empty, queue_size=1))
            if lamp in ["rear", *EXTRA]:
                self.out.append(rospy.Publisher("spare/" + lamp, Empty, queue_size=1))


rospy.init_node("board")
board = Board()
rospy.spin()
