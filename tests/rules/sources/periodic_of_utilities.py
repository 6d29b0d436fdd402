# A loop that asks whether the node is still there by the name that this has in its own module.
#
# expect: periodic chat mechanism=sleep
import time

import rclpy
import rclpy.utilities
from rclpy.node import Node
from std_msgs.msg import String


class Poller(Node):
    def __init__(self):
        super().__init__("poller")
        self.pub = self.create_publisher(String, "chat", 1)

    def poll(self):
        self.pub.publish(String())


def main():
    rclpy.init()
    poller = Poller()
    due = time.time()
    while rclpy.utilities.ok():
        rclpy.spin_once(poller, timeout_sec=0)
        poller.poll()
        due += 0.1
        time.sleep(max(0, due - time.time()))


if __name__ == "__main__":
    main()
