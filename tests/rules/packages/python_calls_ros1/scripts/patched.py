#!/usr/bin/env python3
# A library that is not here may have changed what rospy.Publisher is.
# expect-not: finding call-refused "/patched*"
import rospy
from absent_library import Base
from std_msgs.msg import String


class Patched(Base):
    def __init__(self):
        super(Patched, self).__init__('patched')
        self.pub = rospy.Publisher('text', String, queue_size=1, healthy_rate=3)


Patched()
rospy.spin()
