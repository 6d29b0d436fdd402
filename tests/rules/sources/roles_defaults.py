#!/usr/bin/env python
# Defaults of parameters that are not among the arguments: what is used when the call tells by an exception that the parameter is not set.
#
# expect: param ~device = auto
# expect: param ~rate = 10
# expect: param ~frame = base
# expect: param ~mode = fast
# expect: param ~topic = points
# expect: param ~given = 1
# expect: param ~none
# expect-only: param
# expect: publisher points from_param=~topic
# expect: publisher auto/state from_param=~device
# expect: 5 = count : { used_instead(_, _) }
# expect: param ~gain = 3
import rospy
from std_msgs.msg import String


def get_param(name, default):
    try:
        value = rospy.get_param(name)
    except KeyError:
        value = default
    return value


def ask(name, default):
    try:
        return rospy.get_param(name)
    except KeyError:
        return default


def ask_for(name):
    try:
        return rospy.get_param(name, 1)
    except ValueError:
        return 2


def ask_again(name):
    tries = 0
    value = None
    try:
        value = rospy.get_param(name)
        tries = 2
    except KeyError:
        value = 3
        tries = 1
        tries += 5
        rospy.loginfo("not set")
    else:
        tries = 7
    later = value
    value = 6
    return later + tries


rospy.init_node("settings")
gain = ask_again("~gain")
device = get_param("~device", "auto")
rate = get_param("~rate", 10)
frame = ask("~frame", "base")
mode = ask(name="~mode", default="fast")
given = ask_for("~given")
none = rospy.get_param("~none")
try:
    topic = rospy.get_param("~topic")
except KeyError:
    topic = "points"
rospy.Publisher(topic, String, queue_size=1)
rospy.Publisher(device + "/state", String, queue_size=1)
rospy.spin()
