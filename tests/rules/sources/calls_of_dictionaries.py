#!/usr/bin/env python3
# Functions that dictionaries hold, and publishers: those under the key that is asked for, all under one that is not known. A library calls the methods
# of a class of which it has the base.
#
# expect: Count = count : { calls(C, F), function_name(F, Name), match(".*on_left", Name) }, Count = 2
# expect: Count = count : { calls(C, F), function_name(F, Name), match(".*on_right", Name) }, Count = 2
# expect-only: publisher *
# expect-only: reactive * -> *
# expect: 2 = count : { function_holder(_, _) }, 6 = count : { port_holder(_, _) }
import absent
import rospy
from std_msgs.msg import Empty, String


def on_left(text):
    rospy.Publisher("from_left", Empty, queue_size=1)  # expect: publisher from_left


def on_right(text):
    rospy.Publisher("from_right", Empty, queue_size=1)  # expect: publisher from_right


class Sorter:
    def __init__(self):
        self.handlers = {"left": on_left, "right": on_right}
        self.pubs = {
            "left": rospy.Publisher("left", Empty, queue_size=1),  # expect: publisher left
            "right": rospy.Publisher("right", Empty, queue_size=1),  # expect: publisher right
        }
        other = {
            "up": rospy.Publisher("up", Empty, queue_size=1),  # expect: publisher up
            "down": rospy.Publisher("down", Empty, queue_size=1),  # expect: publisher down
        }
        self.other = other
        rospy.Subscriber("text", String, self.on_text)
        rospy.Subscriber("lefts", String, self.on_left_text)
        rospy.Subscriber("ups", String, lambda message: other["up"].publish(Empty()))

    def on_text(self, message):
        self.handlers[message.data](message.data)
        self.pubs[message.data].publish(Empty())
        # expect: reactive text -> left may
        # expect: reactive text -> right may

    def on_left_text(self, message):
        self.pubs["left"].publish(Empty())  # expect: reactive lefts -> left must
        self.handlers["left"](message.data)
        # expect: reactive ups -> up must


class Foreign(absent.Runner):
    def on_run(self):
        rospy.Publisher("run", Empty, queue_size=1)  # expect: publisher run

    @staticmethod
    def make():
        rospy.Publisher("never", Empty, queue_size=1)


class Unmade(absent.Runner):
    def on_run(self):
        rospy.Publisher("never", Empty, queue_size=1)


def main():
    rospy.init_node("sorter")
    Sorter()
    Foreign()
    rospy.spin()


if __name__ == "__main__":
    main()
