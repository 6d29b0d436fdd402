"""A goal that gives way to other callbacks while it is carried out."""

# expect-not: cancel_unseen(_)
import asyncio

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.node import Node


class Count(Node):
    def __init__(self):
        super().__init__("count")
        self.server = ActionServer(self, Fibonacci, "count", self.execute)

    async def execute(self, goal):
        if goal.is_cancel_requested:  # in no loop: before the goal began
            return Fibonacci.Result()
        for _ in range(goal.request.order):
            if goal.is_cancel_requested:
                goal.canceled()
                return Fibonacci.Result()
            await self.moment()
        goal.succeed()
        return Fibonacci.Result()

    async def moment(self):
        await asyncio.sleep(0)


rclpy.init()
rclpy.spin(Count())
