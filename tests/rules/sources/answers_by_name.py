#!/usr/bin/env python3
# Answers that are given to a method whose name a parameter has.
#
# expect: runs_any_method(C, Class), location(C, _, 23, _)
# expect: 1 = count : { runs_any_method(_, _) }
# expect: 0 = count : { sends_nothing(_) }
import rclpy
from rclpy.node import Node
from std_msgs.msg import Empty
from std_srvs.srv import Trigger


class Asker(Node):
    def __init__(self):
        super().__init__("asker")
        self.declare_parameter("handler", "on_open")
        self.client = self.create_client(Trigger, "open")
        self.moves = self.create_publisher(Empty, "moves", 1)
        self.create_subscription(Empty, "order", self.on_order, 1)

    def on_order(self, message):
        handler = getattr(self, self.get_parameter("handler").value)
        self.client.call_async(Trigger.Request()).add_done_callback(handler)

    def on_open(self, future):
        self.moves.publish(Empty())


def main():
    rclpy.init()
    rclpy.spin(Asker())


if __name__ == "__main__":
    main()
