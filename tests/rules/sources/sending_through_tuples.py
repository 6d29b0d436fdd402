#!/usr/bin/env python3
# Publishers in tuples, and in what has tuples in it: of a tuple, the part that is asked for.
#
# expect-only: reactive * -> *
from collections import deque

import rospy
from std_msgs.msg import Empty


def make(name):
    return rospy.Publisher(name, Empty, queue_size=1)


def pair():
    return rospy.Publisher("pair_left", Empty, queue_size=1), rospy.Publisher("pair_right", Empty, queue_size=1)


def send_all(publishers):
    for publisher in publishers:
        publisher.publish(Empty())  # expect: reactive given -> left


class Sender:
    annotated: "dict[str, rospy.Publisher]"

    def __init__(self):
        self.left, self.right = (make("left"), make("right"))
        self.pair_left, self.pair_right = pair()
        self.both = (make("both_left"), make("both_right"))
        self.count, *self.others = (2, make("second"), make("third"))
        self.named = [("named", make("named")), ("also_named", make("also_named"))]
        self.appended = []
        self.appended.append(("appended", make("appended")))
        self.listed = [(name, make(name)) for name in ("listed_here", "listed_there")]
        self.keyed = {"keyed": make("keyed")}
        self.filled = {}
        for name in ("filled_here", "filled_there"):
            self.filled[name] = make(name)
        self.annotated = {}
        self.annotated["annotated"] = make("annotated")
        self.nested = [("nested", (make("nested"), Empty()))]
        self.sides = [(make("side_left"), make("side_right"))]
        self.waiting = deque([make("waiting")])
        rospy.Subscriber("of_tuple", Empty, self.of_tuple)
        rospy.Subscriber("of_function", Empty, self.of_function)
        rospy.Subscriber("by_index", Empty, self.by_index)
        rospy.Subscriber("of_rest", Empty, self.of_rest)
        rospy.Subscriber("of_pairs", Empty, self.of_pairs)
        rospy.Subscriber("of_appended", Empty, self.of_appended)
        rospy.Subscriber("of_listed", Empty, self.of_listed)
        rospy.Subscriber("of_items", Empty, self.of_items)
        rospy.Subscriber("of_filled", Empty, self.of_filled)
        rospy.Subscriber("of_annotated", Empty, self.of_annotated)
        rospy.Subscriber("of_nested", Empty, self.of_nested)
        rospy.Subscriber("of_sides", Empty, self.of_sides)
        rospy.Subscriber("numbered", Empty, self.numbered)
        rospy.Subscriber("side_by_side", Empty, self.side_by_side)
        rospy.Subscriber("given", Empty, self.given)
        rospy.Subscriber("taken", Empty, self.taken)
        rospy.Subscriber("by_key", Empty, self.by_key)

    def of_tuple(self, message):
        self.right.publish(message)  # expect: reactive of_tuple -> right must

    def of_function(self, message):
        self.pair_right.publish(message)  # expect: reactive of_function -> pair_right must

    def by_index(self, message):
        self.both[1].publish(message)  # expect: reactive by_index -> both_right must

    # expect: reactive of_rest -> second
    # expect: reactive of_rest -> third
    def of_rest(self, message):
        for publisher in self.others:
            publisher.publish(message)

    # expect: reactive of_pairs -> named
    # expect: reactive of_pairs -> also_named
    def of_pairs(self, message):
        for _, publisher in self.named:
            publisher.publish(message)

    def of_appended(self, message):
        for _, publisher in self.appended:
            publisher.publish(message)  # expect: reactive of_appended -> appended

    # expect: reactive of_listed -> listed_here
    # expect: reactive of_listed -> listed_there
    def of_listed(self, message):
        for _, publisher in self.listed:
            publisher.publish(message)

    def of_items(self, message):
        for _, publisher in self.keyed.items():
            publisher.publish(message)  # expect: reactive of_items -> keyed

    # expect: reactive of_filled -> filled_here
    # expect: reactive of_filled -> filled_there
    def of_filled(self, message):
        for _, publisher in self.filled.items():
            publisher.publish(message)

    def of_annotated(self, message):
        for _, publisher in self.annotated.items():
            publisher.publish(message)  # expect: reactive of_annotated -> annotated

    def of_nested(self, _):
        for _, (publisher, message) in self.nested:
            publisher.publish(message)  # expect: reactive of_nested -> nested

    def of_sides(self, message):
        for _, right in self.sides:
            right.publish(message)  # expect: reactive of_sides -> side_right

    def numbered(self, message):
        for _, publisher in enumerate([self.left]):
            publisher.publish(message)  # expect: reactive numbered -> left

    def side_by_side(self, message):
        for publisher, _ in zip(self.waiting, (1, 2), strict=False):
            publisher.publish(message)  # expect: reactive side_by_side -> waiting

    def given(self, _):
        send_all([self.left])

    def taken(self, message):
        self.waiting.popleft().publish(message)  # expect: reactive taken -> waiting

    def by_key(self, message):
        self.keyed.get("keyed").publish(message)  # expect: reactive by_key -> keyed must


rospy.init_node("sender")
sender = Sender()
rospy.spin()
