# What is in `finally` is done on every way out; an exception goes on after it.
# expect: always_reacts([_, _, "returns"], [_, _, "a"]); always_reacts([_, _, "caught"], [_, _, "c"])
# expect-not: always_reacts([_, _, "raises"], [_, _, "b"]); always_reacts([_, _, "rounds"], [_, _, "e"])
# expect: always_reacts([_, _, "rounds"], [_, _, "d"])
import rospy
from std_msgs.msg import Int32


class Robot:
    def __init__(self):
        self.busy = False
        self.pa = rospy.Publisher("a", Int32, queue_size=1)
        self.pb = rospy.Publisher("b", Int32, queue_size=1)
        self.pc = rospy.Publisher("c", Int32, queue_size=1)
        self.pd = rospy.Publisher("d", Int32, queue_size=1)
        self.pe = rospy.Publisher("e", Int32, queue_size=1)
        rospy.Subscriber("returns", Int32, self.on_returns)
        rospy.Subscriber("raises", Int32, self.on_raises)
        rospy.Subscriber("caught", Int32, self.on_caught)
        rospy.Subscriber("rounds", Int32, self.on_rounds)

    def on_returns(self, msg):
        try:
            if msg.data < 0:
                return
            self.busy = True
        finally:
            self.pa.publish(msg)

    def on_raises(self, msg):
        try:
            self.busy = True
            if msg.data < 0:
                raise ValueError("less than none")
        finally:
            self.busy = False
        self.pb.publish(msg)

    def on_caught(self, msg):
        try:
            if msg.data < 0:
                raise ValueError("less than none")
        except ValueError:
            return
        finally:
            self.pc.publish(msg)

    def on_rounds(self, msg):
        while True:
            try:
                if msg.data < 0:
                    break
                if msg.data > 9:
                    return
            finally:
                self.pd.publish(msg)
        self.pe.publish(msg)


rospy.init_node("robot")
Robot()
rospy.spin()
