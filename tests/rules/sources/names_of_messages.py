# What conditions call a message that was given to a callback: not what a local of what it calls is called too, nor what the callback changes.
#
# expect: names_message([_, _, "a"], "kept")
# expect: N = count : { names_message(_, _) }, N = 1
import rospy
from std_msgs.msg import String


class Listener:
    def __init__(self):
        self.last = None
        self.pub = rospy.Publisher("last", String, queue_size=1)
        rospy.Subscriber("a", String, self.on_a)
        rospy.Subscriber("b", String, self.on_b)
        rospy.Subscriber("c", String, self.on_c)

    def on_a(self, kept):
        self.last = kept

    def on_b(self, shared):
        self.last = shared
        self.other()

    def on_c(self, changed):
        if changed.data == "":
            changed = None
        self.last = changed

    def other(self):
        shared = String("other")
        self.pub.publish(shared)


rospy.init_node("listener")
Listener()
rospy.spin()
