#!/usr/bin/env python3
# Services that are asked by calling what stands for them.
#
# expect-only: reactive * -> *
import rospy
from std_msgs.msg import Empty
from std_srvs.srv import Trigger


def ask(proxy):
    proxy()  # expect: reactive handed_on -> handed must


class Asker:
    def __init__(self):
        self.member = rospy.ServiceProxy("member", Trigger)
        self.table = {"key": rospy.ServiceProxy("element", Trigger)}
        rospy.Subscriber("by_member", Empty, self.by_member)
        rospy.Subscriber("by_element", Empty, self.by_element)
        rospy.Subscriber("by_local", Empty, self.by_local)
        rospy.Subscriber("at_once", Empty, self.at_once)
        rospy.Subscriber("handed_on", Empty, self.handed_on)

    def by_member(self, _):
        self.member()  # expect: reactive by_member -> member must

    def by_element(self, _):
        self.table["key"]()  # expect: reactive by_element -> element must

    def by_local(self, _):
        local = rospy.ServiceProxy("local", Trigger)
        local()  # expect: reactive by_local -> local must

    def at_once(self, _):
        rospy.ServiceProxy("once", Trigger)()  # expect: reactive at_once -> once must

    def handed_on(self, _):
        ask(rospy.ServiceProxy("handed", Trigger))


rospy.init_node("asker")
asker = Asker()
rospy.spin()
