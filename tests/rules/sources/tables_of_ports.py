#!/usr/bin/env python3
# Tables that loops take apart: what stands in one row belongs together.
#
# expect: publisher left std_msgs/Bool
# expect: publisher right std_msgs/String
# expect: publisher lamp/red std_msgs/Bool
# expect: publisher lamp/text std_msgs/String
# expect: publisher wheel0 std_msgs/Bool
# expect: publisher wheel1 std_msgs/Bool
# expect: publisher arm_1 std_msgs/Bool
# expect: publisher arm_2 std_msgs/Bool
# expect: publisher first std_msgs/Bool
# expect: publisher second std_msgs/String
# expect: publisher ?/of_program std_msgs/Bool
# expect: publisher ?/asked std_msgs/Bool
# expect: publisher numbered std_msgs/String
# expect: publisher /rosout rcl_interfaces/Log
# expect: publisher /parameter_events rcl_interfaces/ParameterEvent
# expect-only: publisher
# expect: subscriber a std_msgs/Bool callback=Board::on_a
# expect: subscriber b std_msgs/String callback=Board::on_b
# expect: subscriber c std_msgs/Bool callback=Board::on_a
# expect-only: subscriber
# expect: reactive a -> left
# expect: reactive b -> right
# expect: reactive c -> left
# expect-only: reactive * -> *
# expect: param rate = 5 type=int
# expect: param frame = map type=string
# expect: param gains = "[1.0, 2.0]"
# expect-only: param
import sys

import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool, String

SIDES = ("left", "right")
LAMPS = {"red": Bool, "text": String}
COUNT = 2


class Board(Node):
    def __init__(self):
        super().__init__("board")
        first, second = SIDES
        self.left, self.right = self.create_publisher(Bool, first, 1), self.create_publisher(String, second, 1)
        for kind, name, callback in [(Bool, "a", self.on_a), (String, "b", self.on_b)]:
            self.create_subscription(kind, name, callback, 1)
        added = []
        added.append((Bool, "c", self.on_a))
        for kind, name, callback in added:
            self.create_subscription(kind, name, callback, 1)
        for name, value in (("rate", 5), ("frame", "map"), ("gains", [1.0, 2.0])):
            self.declare_parameter(name, value)
        self.lamps = [self.create_publisher(kind, f"lamp/{name}", 1) for name, kind in LAMPS.items()]
        self.wheels = [self.create_publisher(Bool, f"wheel{index}", 1) for index in range(COUNT)]
        for index in range(1, 3):
            self.create_publisher(Bool, "arm_" + str(index), 1)
        for name, kind in zip(["first", "second"], [Bool, String], strict=True):
            self.create_publisher(kind, name, 1)
        for index in range(len(sys.argv)):
            self.create_publisher(Bool, f"{index}/of_program", 1)
        for index in range(int(sys.argv[1]), 3):
            self.create_publisher(Bool, f"{index}/asked", 1)
        for index, (name, kind) in enumerate([("numbered", String)]):
            self.create_publisher(kind, name, index)

    def on_a(self, message):
        self.left.publish(message)

    def on_b(self, message):
        self.right.publish(message)


rclpy.init()
rclpy.spin(Board())
