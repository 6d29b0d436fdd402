"""A rate of rclpy in a callback of an executor with several threads."""

# expect: 0 = count : { sleeps_for_ever(_) }
# expect: subscriber level
import rclpy
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Int32


class Level(Node):
    def __init__(self):
        super().__init__("level")
        self.rate = self.create_rate(5)
        self.sub = self.create_subscription(Int32, "level", self.heard, 10)

    def heard(self, msg):
        self.rate.sleep()


def main():
    rclpy.init()
    executor = MultiThreadedExecutor()
    executor.add_node(Level())
    executor.spin()


main()
