# Callbacks that functions make, each of which calls the one that it was given.
# expect-only: reactive * -> *
# expect: port_flow([_, _, "scan"], [_, _, "near"], "data", _)
# expect: port_flow([_, _, "odom"], [_, _, "pose"], "data", _)
# expect-not: port_flow([_, _, "scan"], [_, _, "pose"], _, _); port_flow([_, _, "odom"], [_, _, "near"], _, _)
# expect: port_flow([_, _, "mark"], [_, _, "last"], _, _)
# expect-not: port_flow([_, _, "odom"], [_, _, "last"], _, _)
# expect: perhaps_always([_, _, "scan"], [_, _, "near"])
# expect: always_reacts([_, _, "alone"], [_, _, "only"])
import rospy
from std_msgs.msg import String


class Robot:
    def __init__(self):
        self.last = ""
        self.near = rospy.Publisher("near", String, queue_size=1)
        self.pose = rospy.Publisher("pose", String, queue_size=1)
        self.only = rospy.Publisher("only", String, queue_size=1)
        self.kept = rospy.Publisher("last", String, queue_size=1)
        rospy.Subscriber("scan", String, self.counted(self.on_scan))
        counted = self.counted(self.on_odom)
        rospy.Subscriber("odom", String, counted)
        rospy.Subscriber("mark", String, self.counted(self.on_mark))
        rospy.Subscriber("alone", String, self.plain(self.on_alone))
        rospy.Timer(rospy.Duration(1), self.tell)

    def counted(self, callback):
        def inner(message):
            callback(message)

        return lambda message: inner(message)

    def plain(self, callback):
        def inner(message):
            callback(message)

        return inner

    def on_scan(self, message):
        self.near.publish(message)  # expect: reactive scan -> near

    def on_odom(self, message):
        self.pose.publish(message)  # expect: reactive odom -> pose

    def on_mark(self, message):
        self.last = message.data

    def on_alone(self, message):
        self.only.publish(message)  # expect: reactive alone -> only

    def tell(self, _):
        self.kept.publish(self.last)


rospy.init_node("robot")
Robot()
rospy.spin()
