#!/usr/bin/env python
# Names that are parts of texts: what a slice leaves of a text, and which of two names is taken by how a text begins.
#
# expect: publisher /copies/scan
# expect: publisher /copies/map
# expect: publisher camera
# expect: publisher cam
# expect: publisher raw_image
# expect: publisher part/ima
# expect: publisher none/
# expect: publisher /odom
# expect: publisher /imu
# expect: publisher left/a
# expect: publisher left/b
# expect-only: publisher
import rospy
from std_msgs.msg import String


def copy_of(topic):
    topic = topic if topic[0] != "/" else topic[1:]
    rospy.Publisher(f"/copies/{topic}", String, queue_size=1)


def absolute(topic):
    rospy.Publisher(topic if topic.startswith("/") else "/" + topic, String, queue_size=1)


rospy.init_node("pieces")
copy_of("/scan")
copy_of("map")
absolute("/odom")
absolute("imu")
name = "/camera"
rospy.Publisher(name[1:], String, queue_size=1)
rospy.Publisher(name[1:4], String, queue_size=1)
image = "image"
rospy.Publisher("raw_" + image[:20], String, queue_size=1)
rospy.Publisher("part/" + image[:-2], String, queue_size=1)
rospy.Publisher("none/" + image[3:1], String, queue_size=1)
# elements of a list are not told apart
names = ["a", "b"]
rospy.Publisher("left/" + names[1:][0], String, queue_size=1)
rospy.spin()
