#!/usr/bin/env python
# Messages are imported from the modules that are generated for each of them, by the generators of ROS 1 and of ROS 2.
#
# expect: publisher left sensor_msgs/CompressedImage
# expect: subscriber right sensor_msgs/Image
import rospy
from sensor_msgs.msg._CompressedImage import CompressedImage
from sensor_msgs.msg._image import Image


def on_image(image):
    pass


rospy.init_node("camera")
pub = rospy.Publisher("left", CompressedImage, queue_size=1)
sub = rospy.Subscriber("right", Image, on_image)
rospy.spin()
