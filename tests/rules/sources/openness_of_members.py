# A method whose name is not known: of a class whose methods are all called otherwise nothing is unseen; a member that is no function opens nothing.
#
# expect: unseen("ports", "member", "__main__::Commands", _, 28, _)
# expect: unseen("ports", "member", "__main__::Commands", _, 29, _)
# expect: Count = count : { unseen("ports", _, _, _, _, _) }, Count = 2
import rospy
from std_msgs.msg import String


class Commands:
    def publish(self, topic):
        rospy.Publisher(topic, String, queue_size=1)


class Steps:
    def first(self, name):
        rospy.loginfo(name)


class Server:
    def __init__(self):
        self.commands, self.level = Commands(), 1
        self.steps = Steps()
        rospy.Subscriber("/in", String, self.on)

    def on(self, msg):
        function = getattr(self.commands, msg.data)
        function(topic="x")
        getattr(self.commands, msg.data)("y")
        level = getattr(self, msg.data)
        self.steps.first(level)
        getattr(self.steps, msg.data)("z")

    def idle(self):
        rospy.Publisher("/idle", String, queue_size=1)


if __name__ == "__main__":
    rospy.init_node("n")
    Server()
    rospy.spin()
