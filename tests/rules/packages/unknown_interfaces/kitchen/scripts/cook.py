#!/usr/bin/env python3
# What the package of messages does not define; what is made of its definitions, what a package may make by other means, and what the program can do without.
# expect-not: finding unknown-interface "*Meal*"
# expect-not: finding unknown-interface "*Made*"
import rospy
from kitchen_msgs.msg import Meal, Menu  # expect: finding unknown-interface "/cook needs the message kitchen_msgs/Menu, which kitchen_msgs does not define"
from kitchen_msgs.msg import ServeAction, ServeActionGoal, ServeFeedback, ServeGoal, ServeResult
from kitchen_msgs.srv import Cook, CookRequest, CookResponse
from kitchen_msgs.srv import Boil  # expect: finding unknown-interface "/cook needs the service kitchen_msgs/Boil, which kitchen_msgs does not define"
from kitchen_msgs.srv import _Cook
from made_msgs.msg import Made, MadeByProgram

try:
    from kitchen_msgs.msg import OldMenu
except ImportError:
    OldMenu = None

rospy.init_node("cook")
pub = rospy.Publisher("meal", Meal, queue_size=1)
rospy.spin()
