"""A program of rospy that subscribes, and ends: nothing in it waits."""

# expect: 2 = count : { runs_too_little(_, "ends") }
import rospy
from std_msgs.msg import Int32


class Level:
    def __init__(self):
        self.pub = rospy.Publisher("half", Int32, queue_size=1)
        self.sub = rospy.Subscriber("level", Int32, self.heard)
        self.timer = rospy.Timer(rospy.Duration(1), self.tick)

    def heard(self, msg):
        self.pub.publish(Int32(msg.data // 2))

    def tick(self, event):
        while not rospy.is_shutdown():
            rospy.sleep(1)


def main():
    rospy.init_node("level")
    level = Level()
    rospy.loginfo("ready %s", level)


if __name__ == "__main__":
    main()
