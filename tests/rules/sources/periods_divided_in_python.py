# A period that is one by a whole number: Python divides it as other numbers.
#
# expect: periodic out 4 Hz
# expect: period(_, "(1.0)/(4)", 1, "hz")
import rclpy
from rclpy.node import Node
from std_msgs.msg import Empty


def main():
    rclpy.init()
    node = Node("sampler")
    hz = node.declare_parameter("hz", 4).value
    pub = node.create_publisher(Empty, "out", 10)
    node.create_timer(1 / hz, lambda: pub.publish(Empty()))
    rclpy.spin(node)


main()
