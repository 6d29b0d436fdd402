# A node that is made and not spun.
#
# expect: 1 = count : { runs_too_little(_, "left_out") }
import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool


class Lamp(Node):
    def __init__(self, name):
        super().__init__(name)
        self.sub = self.create_subscription(Bool, "on", self.switch, 10)

    def switch(self, msg):
        self.get_logger().info(str(msg.data))


def main():
    rclpy.init()
    left = Lamp("left")
    right = Lamp("right")  # noqa: F841
    rclpy.spin(left)


main()
