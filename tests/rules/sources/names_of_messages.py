# What conditions call a message that was given to a callback: not what the callback changes, nor what a local of what it calls is called too, unless no
# condition asks for that, or it is the message.
#
# expect: names_message([_, _, "a"], "kept")
# expect: names_message([_, _, "d"], "sent")
# expect: names_message([_, _, "e"], "given")
# expect: N = count : { names_message(_, _) }, N = 3
import rospy
from std_msgs.msg import String


class Listener:
    def __init__(self):
        self.last = None
        self.pub = rospy.Publisher("last", String, queue_size=1)
        rospy.Subscriber("a", String, self.on_a)
        rospy.Subscriber("b", String, self.on_b)
        rospy.Subscriber("c", String, self.on_c)
        rospy.Subscriber("d", String, self.on_d)
        rospy.Subscriber("e", String, self.on_e)

    def on_a(self, kept):
        self.last = kept

    def on_b(self, shared):
        self.last = shared
        self.other()

    def on_c(self, changed):
        if changed.data == "":
            changed = None
        self.last = changed

    def on_d(self, sent):
        if sent.data == "now":
            self.tell()

    def on_e(self, given):
        self.handle(given)

    def handle(self, given):
        if given.data == "now":
            self.tell()

    def other(self):
        shared = String(str(self.pub.get_num_connections()))
        if shared.data != "0":
            self.pub.publish(shared)

    def tell(self):
        sent = String("told")
        self.pub.publish(sent)


rospy.init_node("listener")
Listener()
rospy.spin()
