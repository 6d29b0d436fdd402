# Nodes that give themselves to the executor that the program spins.
#
# expect: 0 = count : { runs_too_little(_, _) }
import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Bool


class Lamp(Node):
    def __init__(self, name, executor):
        super().__init__(name)
        self.sub = self.create_subscription(Bool, "on", self.switch, 10)
        executor.add_node(self)

    def switch(self, msg):
        self.get_logger().info(str(msg.data))


def main():
    rclpy.init()
    executor = SingleThreadedExecutor()
    left = Lamp("left", executor)  # noqa: F841
    right = Lamp("right", executor)  # noqa: F841
    executor.spin()


main()
