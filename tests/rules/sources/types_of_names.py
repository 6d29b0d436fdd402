#!/usr/bin/env python
# Classes of messages under other names, entries of dictionaries and of parameters that have others in them.
#
# expect: publisher global std_msgs/String
# expect: publisher local std_msgs/Bool
# expect: publisher assigned std_msgs/Int32
# expect: publisher member std_msgs/Float32
# expect: publisher imported std_msgs/UInt8
# expect: publisher left_topic std_msgs/String
# expect: publisher assigned_topic std_msgs/String
# expect: publisher ? std_msgs/String from_param=~settings unknown="named by parameter ~settings"
# expect: publisher given_default std_msgs/String from_param=~default
# expect-only: publisher
# expect: N = count : { untyped_map_access(_, _) }, N = 1, 2 = count : { field_of_this(_) }
# expect-not: _result(_, _)
import rospy
import std_msgs.msg
from std_msgs.msg import Bool, Float32, String
from std_msgs.msg import UInt8 as Small

Text = String
TOPICS = {"left": "left_topic", "right": "never_right"}


class Node:
    def __init__(self):
        self.kind = Float32
        rospy.Publisher("member", self.kind, queue_size=1)


def main():
    rospy.init_node("types")
    rospy.Publisher("global", Text, queue_size=1)
    Kind = Bool
    rospy.Publisher("local", Kind, queue_size=1)
    Other = None
    Other = std_msgs.msg.Int32
    if Other == Bool:
        return
    rospy.Publisher("assigned", Other, queue_size=1)
    rospy.Publisher("imported", Small, queue_size=1)
    rospy.Publisher(TOPICS["left"], String, queue_size=1)
    names = {}
    names["one"] = "assigned_topic"
    names["two"] = "never_two"
    rospy.Publisher(names["one"], String, queue_size=1)
    settings = rospy.get_param("~settings")
    rospy.Publisher(settings["topic"], String, queue_size=1)
    default = rospy.get_param("~default", "given_default")
    rospy.Publisher(default, String, queue_size=1)
    Node()
    rospy.spin()


main()
