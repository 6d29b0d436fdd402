import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool, Float64

SLOW = 0.1


class ShelfCarrier(Node):
    """Lifts a shelf when the base stands, and holds the base meanwhile."""

    def __init__(self):
        super().__init__('shelf_carrier')
        self.declare_parameter('lift_height', 0.2)
        self.stop_pub = self.create_publisher(Bool, 'stop', 1)
        self.create_subscription(Float64, 'speed', self.on_speed, 10)

    def on_speed(self, message):
        if abs(message.data) < SLOW:
            self.stop_pub.publish(Bool(data=True))


def main():
    rclpy.init()
    rclpy.spin(ShelfCarrier())


if __name__ == '__main__':
    main()
