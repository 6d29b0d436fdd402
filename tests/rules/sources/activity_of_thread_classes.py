# A class of threads says in its method `run` what its objects do, in a loop whose length nobody tells.
#
# expect: transition Worker::ready = True trigger=thread
# expect: state Worker::ready = False
# expect: transition Owner::known = 1 trigger=thread guard="name not in self.owner.known"
import threading

import rospy
from std_msgs.msg import Empty, String


class Worker(threading.Thread):
    def __init__(self, owner):
        super().__init__()
        self.owner = owner
        self.ready = False
        self.pub = rospy.Publisher("out", Empty, queue_size=3)

    def run(self):
        while not rospy.is_shutdown():
            for name in rospy.get_published_topics():
                if name not in self.owner.known:
                    self.owner.add(name)
            if self.ready:
                self.pub.publish()
            self.ready = True


class Owner:
    def __init__(self):
        self.known = {}
        self.pub = rospy.Publisher("known", String, queue_size=3)

    def add(self, name):
        self.known[name] = 1

    def tell(self, message):
        for name in self.known:
            self.pub.publish(name)


def start():
    rospy.init_node("owner")
    owner = Owner()
    Worker(owner).start()
    rospy.Subscriber("tell", Empty, owner.tell)
    rospy.spin()


if __name__ == "__main__":
    start()
