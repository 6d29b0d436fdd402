# A loop whose rounds come to another one that goes on as long as a flag says so does not go round evenly; one that counts lets it.
#
# expect: unsteady(C, "a loop within its rounds may go on"), location(C, _, 28, _)
# expect-not: unsteady(C, "a loop within its rounds may go on"), location(C, _, 37, _)
import rospy
from std_msgs.msg import Bool


class Lamp:
    def __init__(self):
        self.night = False
        self.pub = rospy.Publisher("/lamp", Bool, queue_size=1)
        rospy.Subscriber("/night", Bool, self.on_night)

    def on_night(self, msg):
        self.night = msg.data

    def blink(self):
        rate = rospy.Rate(2)
        while self.night and not rospy.is_shutdown():
            self.pub.publish(True)
            rate.sleep()

    def run(self):
        while not rospy.is_shutdown():
            self.pub.publish(False)
            self.blink()
            rospy.sleep(1.0)


def count(pub):
    while not rospy.is_shutdown():
        left = 3
        while left > 0 and not rospy.is_shutdown():
            left -= 1
        pub.publish(True)
        rospy.sleep(1.0)


rospy.init_node("lamp")
lamp = Lamp()
lamp.run()
count(rospy.Publisher("/count", Bool, queue_size=1))
