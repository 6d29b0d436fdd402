# expect: names_number("MOST", "3")
# expect: N = count : { names_number(_, _) }, N = 1
import rospy
from std_msgs.msg import Empty

MOST = 3
CHANGED = 4


class Counter:
    def __init__(self):
        self.n = 0
        self.out = rospy.Publisher("out", Empty, queue_size=1)
        rospy.Subscriber("in", Empty, self.on_in)
        rospy.Subscriber("more", Empty, self.on_more)

    def on_more(self, _msg):
        global CHANGED
        CHANGED += 1

    def on_in(self, msg):
        self.n += 1
        if self.n >= MOST and self.n != CHANGED:
            self.n = 0
            self.out.publish(msg)


if __name__ == "__main__":
    rospy.init_node("counter")
    counter = Counter()
    rospy.spin()
