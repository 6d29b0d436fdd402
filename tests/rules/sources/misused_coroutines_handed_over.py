# Coroutines of a node that code gets which was not seen: it may run them in an event loop.
#
# expect: 0 = count : { awaits_without_loop(_) }
import asyncio

import rclpy
from absent_loops import serve
from rclpy.node import Node
from std_msgs.msg import Bool


class Lamp(Node):
    def __init__(self):
        super().__init__("lamp")
        self.dim = self.create_subscription(Bool, "dim", self.fade, 10)

    async def fade(self, msg):
        await asyncio.sleep(0.5)
        self.get_logger().info(str(msg.data))


def main():
    rclpy.init()
    lamp = Lamp()
    serve(lamp)
    rclpy.spin(lamp)


main()
