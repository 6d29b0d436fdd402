#!/usr/bin/env python3
# A default says of which type a parameter is, but for an empty text, which is for nothing, and where the value is made a number.
#
# expect: parameter_access_type(_, "~rate", "integer")
# expect: parameter_access_type(_, "~title", "string")
# expect-not: parameter_access_type(_, "/joints", _)
# expect-not: parameter_access_type(_, "~alone", _)
# expect: param /joints
import rospy

rospy.init_node("driver")
rate = rospy.Rate(rospy.get_param("~rate", 10))
title = rospy.get_param("~title", "driver")
for joint in rospy.get_param("/joints", ""):
    print(title, joint)
alone = bool(rospy.get_param("~alone", "True"))
rospy.spin()
