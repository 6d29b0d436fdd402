# A coroutine that lets others go on: this needs no event loop of asyncio.
#
# expect: awaits_without_loop(_)
# expect: 1 = count : { awaits_without_loop(_) }
import asyncio

import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool


class Lamp(Node):
    def __init__(self):
        super().__init__("lamp")
        self.sub = self.create_subscription(Bool, "on", self.switch, 10)
        self.dim = self.create_subscription(Bool, "dim", self.fade, 10)

    async def switch(self, msg):
        await asyncio.sleep(0)
        self.get_logger().info(str(msg.data))

    async def fade(self, msg):
        await asyncio.sleep(0.5)
        self.get_logger().info(str(msg.data))


def main():
    rclpy.init()
    rclpy.spin(Lamp())


main()
