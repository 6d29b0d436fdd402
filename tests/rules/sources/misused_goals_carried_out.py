# Accepted goals that are carried out by a thread, and an event loop that the program runs itself.
#
# expect: !misused(_, "goal not executed", _)
# expect: !misused(_, "without event loop", _)
import asyncio
import threading

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.node import Node


class Dock(Node):
    def __init__(self):
        super().__init__("dock")
        self.server = ActionServer(self, Fibonacci, "dock", self.run, handle_accepted_callback=self.accepted)

    def accepted(self, goal_handle):
        self.thread = threading.Thread(target=goal_handle.execute)

    async def run(self, goal_handle):
        await asyncio.sleep(1.0)
        goal_handle.succeed()
        return Fibonacci.Result()


async def spin(node):
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0.0)
        await asyncio.sleep(0.01)


def main():
    rclpy.init()
    asyncio.get_event_loop().run_until_complete(spin(Dock()))


if __name__ == "__main__":
    main()
