# Accepted goals that nobody carries out, and coroutines that need an event loop.
#
# expect: 1 = count : { misused(_, "goal not executed", _) }
# expect: 2 = count : { misused(_, "without event loop", _) }
import asyncio

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.node import Node


class Dock(Node):
    def __init__(self):
        super().__init__("dock")
        self.current = None
        self.server = ActionServer(self, Fibonacci, "dock", self.run, handle_accepted_callback=self.accepted)
        self.other = ActionServer(self, Fibonacci, "other", self.run)
        self.timer = self.create_timer(1.0, self.tick)

    def accepted(self, goal_handle):
        self.current = goal_handle

    async def run(self, goal_handle):
        await self.pause()
        goal_handle.succeed()
        return Fibonacci.Result()

    async def pause(self):
        await asyncio.sleep(1.0)

    async def tick(self):
        await asyncio.wait_for(self.never_awaited, 1.0)
        await self.quiet()

    async def quiet(self):
        await self.future

    async def unused(self):
        await asyncio.sleep(1.0)


def main():
    rclpy.init()
    rclpy.spin(Dock())


if __name__ == "__main__":
    main()
