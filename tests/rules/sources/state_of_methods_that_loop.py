# A function makes an object and calls its method, whose loop goes on: what the method assigns is no set-up of a new object.
#
# expect: state Beat::even = True
# expect: transition Beat::even = "not self.even" trigger=periodic
import rospy
from std_msgs.msg import Empty


class Beat:
    def __init__(self):
        self.even = True
        self.odd = rospy.Publisher("odd", Empty, queue_size=3)

    def run(self):
        while not rospy.is_shutdown():
            if not self.even:
                self.odd.publish()
            self.even = not self.even
            rospy.sleep(0.5)


def beat():
    node = Beat()
    node.run()


if __name__ == "__main__":
    rospy.init_node("beat")
    beat()
