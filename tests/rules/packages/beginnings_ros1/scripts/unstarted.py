#!/usr/bin/env python3
import rospy
from std_msgs.msg import String

pub = rospy.Publisher('x', String, queue_size=1)
rospy.Subscriber('y', String, print)
rospy.spin()  # expect: finding library-not-started "/unstarted uses rospy, which nothing in its program initialises"
