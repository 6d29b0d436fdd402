#!/usr/bin/env python
# Options of the command line: what a program declares for them is what they are, unless they are given.
#
# expect: publisher plain_text
# expect: publisher dest_name
# expect: publisher max_speed_text
# expect: publisher short_x
# expect: publisher long_wins
# expect: publisher optparse_text
# expect: publisher positional_text
# expect: publisher ?
# expect: publisher if_quiet
# expect: publisher if_not_loud
# expect-only: publisher
# expect: param ~quiet = false
# expect: param ~loud = true
# expect: param ~said = true
# expect: param ~nothing
# expect: Count = count : { option_declared(C, Name) }, Count = 12
# expect: option_declared(_, "max_speed")
# expect: option_declared(_, "least_count_ever")
# expect: Count = count : { default_truth(E, Value) }, Count = 8
# expect: default_truth(E, "false"), expr_text(E, "arguments.quiet")
# expect: default_truth(E, "true"), expr_text(E, "arguments.loud")
# expect: default_truth(E, "true"), expr_text(E, "arguments.said")
# expect: default_truth(E, "false"), expr_text(E, "arguments.nothing")
import argparse
import optparse

import rospy
from std_msgs.msg import String


def send(name):
    return rospy.Publisher(name, String, queue_size=1)


def send_if(name, enabled):
    if enabled:
        rospy.Publisher(name, String, queue_size=1)


def main():
    rospy.init_node("options")
    parser = argparse.ArgumentParser()
    parser.add_argument("--plain", default="plain_text")
    parser.add_argument("--other", dest="elsewhere", default="dest_name")
    parser.add_argument("--max-speed", default="max_speed_text")
    parser.add_argument("-x", default="short_x")
    parser.add_argument("-l", "--long-one", default="long_wins")
    parser.add_argument("where", nargs="?", default="positional_text")
    parser.add_argument("--nothing")
    parser.add_argument("--quiet", action="store_true")
    parser.add_argument("--loud", action="store_false")
    parser.add_argument("--said", action="store_true", default=True)
    parser.add_argument("--least-count-ever", action="store", type=int)
    arguments = parser.parse_args()
    send(arguments.plain)
    send(arguments.elsewhere)
    send(arguments.max_speed)
    send(arguments.x)
    send(arguments.long_one)
    send(arguments.where)
    send(arguments.nothing)
    send_if("if_quiet", arguments.quiet)
    send_if("if_not_loud", not arguments.loud)
    send_if("never_if", False)
    rospy.get_param("~quiet", arguments.quiet)
    rospy.get_param("~loud", arguments.loud)
    rospy.get_param("~said", arguments.said)
    rospy.get_param("~nothing", arguments.nothing)

    old = optparse.OptionParser()
    old.add_option("-t", "--topic", default="optparse_text")
    options, _ = old.parse_args()
    send(options.topic)
    rospy.spin()


main()
