# A call that waits for its answer while a thread spins.
#
# expect: !misused(_, "waits unspun", _)
import threading

import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


def main():
    rclpy.init()
    node = Node("tea")
    client = node.create_client(Trigger, "boil")
    threading.Thread(target=rclpy.spin, args=(node,)).start()
    client.call(Trigger.Request())


main()
