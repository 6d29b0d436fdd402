#!/usr/bin/env python3
# A default says of which type a parameter is, but for an empty text: that is for nothing.
#
# expect: parameter_access_type(_, "~rate", "integer")
# expect: parameter_access_type(_, "~title", "string")
# expect-not: parameter_access_type(_, "/joints", _)
# expect: param /joints
import rospy

rospy.init_node("driver")
rate = rospy.Rate(rospy.get_param("~rate", 10))
title = rospy.get_param("~title", "driver")
for joint in rospy.get_param("/joints", ""):
    print(title, joint)
rospy.spin()
