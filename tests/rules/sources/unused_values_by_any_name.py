# A parameter that is read by a name which is not known.
#
# expect: 0 = count : { parameter_value_unused(_, _) }
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Drive(Node):
    def __init__(self):
        super().__init__("drive")
        self.speed = self.declare_parameter("speed", 1.0)
        self.publisher = self.create_publisher(String, "values", 10)
        self.create_subscription(String, "ask", self.answer, 10)

    def answer(self, msg):
        self.publisher.publish(String(data=str(self.get_parameter(msg.data).value)))


def main():
    rclpy.init()
    rclpy.spin(Drive())


main()
