"""A rate of rclpy in a callback and in the loop of the program: one thread sleeps and spins."""

# expect: 2 = count : { sleeps_for_ever(_) }
import rclpy
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
    node = Level()
    while rclpy.ok():
        rclpy.spin_once(node)
        node.rate.sleep()


main()
