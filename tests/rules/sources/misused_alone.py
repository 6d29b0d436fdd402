#!/usr/bin/env python3
# A buffer that nothing fills, a server that ends no goal, a transform of the present moment, and options that are not those of a callback.
#
# expect: 1 = count : { misused(_, "buffer alone", _) }
# expect: 1 = count : { misused(_, "goal not ended", "count") }
# expect: 1 = count : { misused(_, "lookup of now", _) }
# expect: misused(_, "no result", "the result of the goal")
# expect: misused(_, "no result", "a GoalResponse")
# expect: 2 = count : { misused(_, "no result", _) }
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.node import Node
from tf2_ros import Buffer


class Count(Node):
    def __init__(self):
        super().__init__("count")
        self.buffer = Buffer()
        self.server = ActionServer(self, Fibonacci, "count", self.run, goal_callback=self.asked)
        self.timer = self.create_timer(1.0, self.tick)

    def asked(self, goal):
        self.get_logger().info("asked")

    def run(self, goal_handle):
        self.get_logger().info("run")

    def tick(self):
        self.buffer.lookup_transform("odom", "base_link", self.get_clock().now())


def main():
    rclpy.init()
    rclpy.spin(Count())


if __name__ == "__main__":
    main()
