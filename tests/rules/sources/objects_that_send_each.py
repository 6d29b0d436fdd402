# Objects of one class: each has its own timer, and its own publisher or, under one name or handed to it, the same as the others.
#
# expect: sent_by_several([_, "publisher", "shared"])
# expect: sent_by_several([_, "publisher", "given"])
# expect: sent_by_several([_, "publisher", "listed"])
# expect: sent_by_several([_, "publisher", "timed"])
# expect: 4 = count : { sent_by_several(_) }
# expect: round_sends(_, [_, "publisher", "left"], "1")
# expect: round_sends(_, [_, "publisher", "shared"], "many")
# expect: answers_most(_, [_, "publisher", "given"], "many")
import rclpy
from rclpy.node import Node
from std_msgs.msg import Empty


class Beat:
    def __init__(self, node, name):
        self.out = node.create_publisher(Empty, name, 1)
        self.timer = node.create_timer(0.1, self.tick)

    def tick(self):
        self.out.publish(Empty())


class Answer:
    def __init__(self, node, out):
        self.out = out
        node.create_subscription(Empty, "in", self.answer, 1)

    def answer(self, message):
        self.out.publish(message)


class Lone:
    def __init__(self, node):
        self.out = node.create_publisher(Empty, "lone", 1)
        self.timer = node.create_timer(0.1, self.tick)

    def tick(self):
        self.out.publish(Empty())


class Robot(Node):
    def __init__(self):
        super().__init__("robot")
        self.beats = [Beat(self, "left"), Beat(self, "right"), Beat(self, "shared"), Beat(self, "shared")]
        self.lists = [Beat(self, "listed") for _ in range(3)]
        given = self.create_publisher(Empty, "given", 1)
        self.answers = [Answer(self, given), Answer(self, given)]
        self.timed = self.create_publisher(Empty, "timed", 1)
        for _ in range(2):
            self.create_timer(0.1, self.tick)
        self.lone = Lone(self)

    def tick(self):
        self.timed.publish(Empty())


rclpy.init()
rclpy.spin(Robot())
