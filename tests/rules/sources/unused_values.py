# Parameters that are read into what nothing uses.
#
# expect: parameter_value_unused(_, "limit")
# expect: parameter_value_unused(_, "gain")
# expect: parameter_value_unused(_, "offset")
# expect: 3 = count : { parameter_value_unused(_, Name) }
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class Drive(Node):
    def __init__(self):
        super().__init__("drive")
        self.limit = self.declare_parameter("limit", 2.0).value
        self.declare_parameter("gain", 1.0)
        gain = self.get_parameter("gain").get_parameter_value().double_value  # noqa: F841
        self.offset = self.declare_parameter("offset", 1.0).value
        self.offset = 2.0
        self.scale = self.declare_parameter("scale", 1.0).value
        self.declare_parameter("alone", 1.0)
        self.known = self.declare_parameter("known", 1.0).value
        self.get_logger().info(str(self.get_parameter("known").value))
        self.pair = (self.declare_parameter("first", 1.0).value, 2.0)
        period = self.declare_parameter("period", 0.1).value
        self.timer = self.create_timer(period, self.tick)
        self.pub = self.create_publisher(Float64, "speed", 10)

    def tick(self):
        self.pub.publish(Float64(data=self.scale))


def main():
    rclpy.init()
    rclpy.spin(Drive())


main()
