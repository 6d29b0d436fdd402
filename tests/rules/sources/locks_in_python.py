# Threads beside the callbacks: an attribute gets a new value in one step of the interpreter; what is made from the value that it has, or changes within it, is lost or torn.
# What callbacks make again and again are different objects.
#
# expect: changed_at_once(V, _, _), variable_name(V, "count")
# expect: changed_at_once(V, _, _), variable_name(V, "level")
# expect: changed_at_once(V, _, _), variable_name(V, "seen")
# expect-not: changed_at_once(V, _, _), variable_name(V, "wanted")
# expect-not: changed_at_once(V, _, _), variable_name(V, "height")
# expect: state_variable(V), variable_name(V, "height")
import threading

import rospy
from std_msgs.msg import Int32


class Part:
    def __init__(self):
        self.height = 0

    def grow(self, pub):
        self.height += 1
        if self.height > 1:
            pub.publish(self.height)


class Worker:
    def __init__(self):
        self.count = 0
        self.level = 0.0
        self.seen = {}
        self.wanted = 0
        self.pub = rospy.Publisher("out", Int32, queue_size=1)
        rospy.Subscriber("in", Int32, self.on_in)
        threading.Thread(target=self.work).start()

    def on_in(self, message):
        self.count += 1
        self.level = 0.9 * self.level + 0.1 * message.data
        self.seen[message.data] = 1
        self.wanted = message.data
        Part().grow(self.pub)

    def work(self):
        while not rospy.is_shutdown():
            if self.count > 1 and self.level > 2.0 and self.seen and self.wanted > 3:
                self.pub.publish(1)
            self.count = 0
            self.level = 0.0
            self.seen[0] = 2
            self.wanted = -1
            Part().grow(self.pub)


if __name__ == "__main__":
    rospy.init_node("worker")
    worker = Worker()
    rospy.spin()
