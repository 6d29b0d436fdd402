# A node that spins itself in a thread.
#
# expect: 0 = count : { runs_too_little(_, _) }
import threading

import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool


class Lamp(Node):
    def __init__(self, name):
        super().__init__(name)
        self.sub = self.create_subscription(Bool, "on", self.switch, 10)
        if name == "right":
            threading.Thread(target=self.run).start()

    def run(self):
        rclpy.spin(self)

    def switch(self, msg):
        self.get_logger().info(str(msg.data))


def main():
    rclpy.init()
    left = Lamp("left")
    right = Lamp("right")  # noqa: F841
    rclpy.spin(left)


main()
