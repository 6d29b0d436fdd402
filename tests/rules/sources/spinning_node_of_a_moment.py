# An executor of rclpy holds its nodes.
#
# expect-not: runs_too_little(_, _)
import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Bool


class Lamp(Node):
    def __init__(self):
        super().__init__("lamp")
        self.sub = self.create_subscription(Bool, "on", print, 10)


rclpy.init()
executor = SingleThreadedExecutor()
executor.add_node(Lamp())
executor.spin()
