#!/usr/bin/env python
# rospy takes what follows a tilde for an absolute name when it begins with a slash.
#
# expect: param /joy/kind = pad
# expect: param ~rate = 10
# expect: param ~frame = odom
# expect: publisher /said
# expect: publisher ~heard
# expect-only: publisher param
import rospy
from std_msgs.msg import String

rospy.init_node("joy")
rospy.get_param("~/joy/kind", "pad")
rospy.get_param("~rate", 10)
rospy.get_param(rospy.get_name() + "/frame", "odom")
rospy.Publisher("~/said", String, queue_size=1)
rospy.Publisher("~heard", String, queue_size=1)
