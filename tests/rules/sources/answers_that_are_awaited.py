#!/usr/bin/env python3
# A callback that gives way until an answer is there, by itself and in a function that it awaits; a timer that does.
#
# expect: 3 = count : { awaited(_) }
# expect: continues_with(E, W), location(E, _, 41, _), location(W, _, 40, _)
# expect: continues_with(E, W), location(E, _, 35, _), location(W, _, 34, _)
# expect: done_at_once(E), location(E, _, 39, _)
# expect: 0 = count : { done_at_once(E), location(E, _, 41, _) }
# expect: 2 = count : { gives_way([_, "subscriber", "order"], _) }
# expect: gives_way_otherwise(W), location(W, _, 44, _)
# expect: 1 = count : { gives_way_otherwise(_) }
import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool, Empty
from std_srvs.srv import Trigger


class Asker(Node):
    def __init__(self):
        super().__init__("asker")
        self.busy = False
        self.client = self.create_client(Trigger, "open")
        self.moves = self.create_publisher(Empty, "moves", 1)
        self.create_subscription(Bool, "order", self.on_order, 1)
        self.create_timer(1.0, self.on_timer)

    def start(self):
        self.busy = True

    def stop(self):
        self.busy = False

    async def open(self):
        await self.client.call_async(Trigger.Request())
        self.moves.publish(Empty())

    async def on_order(self, message):
        if not self.busy:
            self.start()
            await self.open()
            self.stop()

    async def on_timer(self):
        await self.client.call_async(Trigger.Request())
        self.moves.publish(Empty())


def main():
    rclpy.init()
    rclpy.spin(Asker())


if __name__ == "__main__":
    main()
