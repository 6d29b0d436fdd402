# Accepted goals that code which is not seen gets.
#
# expect: !misused(_, "goal not executed", _)
import asyncio

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.node import Node


class Dock(Node):
    def __init__(self):
        super().__init__("dock")
        self.goals = []
        self.server = ActionServer(self, Fibonacci, "dock", self.run, handle_accepted_callback=self.accepted)

    def accepted(self, goal_handle):
        self.goals.append(goal_handle)

    async def run(self, goal_handle):
        await asyncio.sleep(1.0)
        goal_handle.succeed()
        return Fibonacci.Result()


async def main():
    rclpy.init()
    rclpy.spin(Dock())


asyncio.run(main())
