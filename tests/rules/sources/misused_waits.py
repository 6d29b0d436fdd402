# A program that waits for an answer and never spins.
#
# expect: 2 = count : { misused(_, "waits unspun", _) }
import time

import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


def main():
    rclpy.init()
    node = Node("asker")
    client = node.create_client(Trigger, "reset")
    client.wait_for_service()
    first = client.call_async(Trigger.Request())
    while not first.done():
        time.sleep(0.1)
    second = client.call_async(Trigger.Request())
    while rclpy.ok() and not second.done():
        pass
    other = 3
    while not other:
        time.sleep(0.1)


main()
