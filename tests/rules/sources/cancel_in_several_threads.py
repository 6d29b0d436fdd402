"""A goal that is carried out while another thread takes the request to cancel it."""

# expect-not: cancel_unseen(_)
import time

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node


class Count(Node):
    def __init__(self):
        super().__init__("count")
        self.server = ActionServer(self, Fibonacci, "count", self.execute)

    def execute(self, goal):
        if goal.is_cancel_requested:  # in no loop: before the goal began
            return Fibonacci.Result()
        for _ in range(goal.request.order):
            if goal.is_cancel_requested:
                goal.canceled()
                return Fibonacci.Result()
            time.sleep(1)
        goal.succeed()
        return Fibonacci.Result()


rclpy.init()
executor = MultiThreadedExecutor()
executor.add_node(Count())
executor.spin()
