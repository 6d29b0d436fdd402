#!/usr/bin/env python
# Functions and globals, a loop with a rate, a callback that sets a flag.
#
# expect: component rospy_functions kind=python_node node_name=gate
# expect: periodic out 10 Hz mechanism=rate if "is_open"
# expect: state is_open = False
# expect-only: *
import rospy
from std_msgs.msg import Bool, String

TOPIC = 'out'
is_open = False


def on_gate(message):
    global is_open
    is_open = message.data  # expect: transition is_open = message.data on gate


def main():
    rospy.init_node('gate')
    out = rospy.Publisher(TOPIC, String, queue_size=5)  # expect: publisher out std_msgs/String queue=5
    rospy.Subscriber('gate', Bool, on_gate, queue_size=1)  # expect: subscriber gate std_msgs/Bool queue=1 callback=on_gate
    rate = rospy.Rate(10)
    while not rospy.is_shutdown():
        if is_open:
            out.publish(String('open'))
        rate.sleep()


if __name__ == '__main__':
    main()
