#!/usr/bin/env python3
# Parameters whose default is None have no value unless they are set, and then any.
#
# expect: publisher ?/command from_param=~axle
# expect: reactive trigger -> ?/command if "self.axle and message is not None"
import rospy
from std_msgs.msg import Empty


def command_publisher(name):
    if not name:
        return None
    return rospy.Publisher(name + "/command", Empty, queue_size=1)


class Controller:
    def __init__(self):
        self.axle = command_publisher(rospy.get_param("~axle", None))
        rospy.Subscriber("trigger", Empty, self.callback)

    def callback(self, message):
        # fmt: off
        if self.axle and \
                message is not None:
            self.axle.publish(message)
        # fmt: on


rospy.init_node("controller")
controller = Controller()
rospy.spin()
