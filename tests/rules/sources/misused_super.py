# The type super in the place of the object that super() gives.
#
# expect: 1 = count : { base_not_made(_) }
import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool


class Left(Node):
    def __init__(self):
        super.__init__("left")
        self.pub = self.create_publisher(Bool, "left", 1)


class Right(Node):
    def __init__(self):
        super().__init__("right")
        self.pub = self.create_publisher(Bool, "right", 1)


rclpy.init()
Left()
rclpy.spin(Right())
