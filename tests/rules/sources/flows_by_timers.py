# What arrives starts a timer that runs once, held or not, a timer that another one starts, or a thread: it has an influence on what these send.
#
# expect: port_flow([_, _, "home"], [_, _, "arrived"], "control", _)
# expect: port_flow([_, _, "later"], [_, _, "done"], "control", _)
# expect: port_flow([_, _, "home"], [_, _, "after"], "control", _)
# expect: port_flow([_, _, "go"], [_, _, "worked"], _, _)
# expect-not: port_flow([_, _, "home"], [_, _, "done"], _, _)
# expect-not: port_flow([_, _, "later"], [_, _, "arrived"], _, _)
import threading

import rospy
from std_msgs.msg import Empty


class Arm:
    def __init__(self):
        self.arrived = rospy.Publisher("arrived", Empty, queue_size=1)
        self.done = rospy.Publisher("done", Empty, queue_size=1)
        self.after = rospy.Publisher("after", Empty, queue_size=1)
        self.worked = rospy.Publisher("worked", Empty, queue_size=1)
        rospy.Subscriber("home", Empty, self.on_home)
        rospy.Subscriber("later", Empty, self.on_later)
        rospy.Subscriber("go", Empty, self.on_go)

    def on_home(self, message):
        self.timer = threading.Timer(5.0, self.at_home)
        self.timer.start()

    def at_home(self):
        self.arrived.publish()
        self.next = rospy.Timer(rospy.Duration(1), self.afterwards, oneshot=True)

    def afterwards(self, event):
        self.after.publish()

    def on_later(self, message):
        rospy.Timer(rospy.Duration(2), self.finish, oneshot=True)

    def finish(self, event):
        self.done.publish()

    def on_go(self, message):
        threading.Thread(target=self.work).start()

    def work(self):
        self.worked.publish()


rospy.init_node("arm")
Arm()
rospy.spin()
