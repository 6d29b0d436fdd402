import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool, Float64


class BaseDriver(Node):
    """Drives the wheels and reports how fast it goes."""

    def __init__(self):
        super().__init__('base_driver')
        self.declare_parameter('port', '/dev/ttyS0')
        self.declare_parameter('max_speed', 0.5)
        rate = self.declare_parameter('rate', 10.0).value
        self.stopped = False
        self.speed_pub = self.create_publisher(Float64, '~/speed', 10)
        self.create_subscription(Bool, 'stop', self.on_stop, 1)
        self.create_timer(1.0 / rate, self.on_timer)

    def on_stop(self, message):
        self.stopped = message.data

    def on_timer(self):
        speed = 0.0 if self.stopped else self.get_parameter('max_speed').value
        self.speed_pub.publish(Float64(data=speed))


def main():
    rclpy.init()
    rclpy.spin(BaseDriver())


if __name__ == '__main__':
    main()
