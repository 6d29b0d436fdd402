# A lock that a `with` statement takes keeps the callbacks and a thread apart.
#
# expect-not: changed_at_once(_, _, _)
# expect: state_variable(V), variable_name(V, "count")
import threading

import rospy
from std_msgs.msg import Int32

LOCK = threading.RLock()


class Counter:
    def __init__(self):
        self.count = 0
        self.pub = rospy.Publisher("out", Int32, queue_size=1)
        rospy.Subscriber("in", Int32, self.on_in)
        threading.Thread(target=self.work).start()

    def on_in(self, message):
        with LOCK:
            self.count += message.data

    def work(self):
        while not rospy.is_shutdown():
            with LOCK:
                self.count += 1
                if self.count > 9:
                    self.pub.publish(self.count)


if __name__ == "__main__":
    rospy.init_node("counter")
    counter = Counter()
    rospy.spin()
