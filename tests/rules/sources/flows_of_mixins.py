# Objects have the method of the class that Python looks in first: a mixin goes before the base that makes the port. `super()` in it
# means what is behind it in the object's class.
#
# expect: port_callback([_, _, "guarded"], F), function_class(F, C), match(".*::Mixin.*", C)
# expect-not: port_callback([_, _, "guarded"], F), function_class(F, C), match(".*::Base.*", C)
# expect: port_flow([_, _, "guarded"], [_, _, "out"], _, _)
# expect-not: always_reacts([_, _, "guarded"], [_, _, "out"])
# expect: port_flow([_, _, "side"], [_, _, "side_out"], _, _)
import rospy
from std_msgs.msg import Int32


class Base:
    def __init__(self):
        self.publisher = rospy.Publisher("out", Int32, queue_size=1)
        rospy.Subscriber("guarded", Int32, self.on_message)

    def on_message(self, message):
        self.publisher.publish(message)


class Mixin:
    def on_message(self, message):
        if message.data > 3:
            super().on_message(message)


class Node(Mixin, Base):
    def __init__(self):
        super().__init__()


class Top:
    def on_side(self, message):
        pass


class Left(Top):
    def on_side(self, message):
        super().on_side(message)


class Right(Top):
    def on_side(self, message):
        rospy.Publisher("side_out", Int32, queue_size=1).publish(message)


class Both(Left, Right):
    def __init__(self):
        rospy.Subscriber("side", Int32, self.on_side)


rospy.init_node("node")
Node()
Both()
rospy.spin()
