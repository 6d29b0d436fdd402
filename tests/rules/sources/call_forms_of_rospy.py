#!/usr/bin/env python3
# Publishers of rospy with and without a queue, and action servers that constructors start.
#
# expect: 2 = count : { made_without_queue(_) }, 3 = count : { starts_in_constructor(_, _, _) }
# expect: made_without_queue(S), port([S, _, "plain"])
# expect: made_without_queue(S), port([S, _, "none"])
# expect: starts_in_constructor(S, S, "told"), port([S, _, "by_default"])
# expect: starts_in_constructor(S, S, "told"), port([S, _, "by_flag"])
# expect: starts_in_constructor(S, S, "told"), port([S, _, "any"])
import actionlib
import rospy
from actionlib_tutorials.msg import FibonacciAction
from std_msgs.msg import Bool


class Cook:
    def __init__(self, later, options):
        self.plain = rospy.Publisher("plain", Bool)
        self.none = rospy.Publisher("none", Bool, latch=True, queue_size=None)
        self.one = rospy.Publisher("one", Bool, queue_size=1)
        self.placed = rospy.Publisher("placed", Bool, None, False, False, None, 5)
        self.unpacked = rospy.Publisher("unpacked", Bool, **options)
        self.by_default = actionlib.SimpleActionServer("by_default", FibonacciAction, self.on_goal)
        self.by_flag = actionlib.SimpleActionServer("by_flag", FibonacciAction, self.on_goal, True)
        self.any = actionlib.ActionServer("any", FibonacciAction, self.on_goal, self.on_goal)
        self.off = actionlib.SimpleActionServer("off", FibonacciAction, execute_cb=self.on_goal, auto_start=False)
        self.later = actionlib.SimpleActionServer("later", FibonacciAction, self.on_goal, auto_start=later)
        self.rest = actionlib.SimpleActionServer("rest", FibonacciAction, self.on_goal, **options)

    def on_goal(self, _goal):
        self.one.publish(True)


rospy.init_node("cook")
cook = Cook(rospy.get_param("~later"), rospy.get_param("~options"))
outside = actionlib.SimpleActionServer("outside", FibonacciAction, cook.on_goal)
rospy.spin()
