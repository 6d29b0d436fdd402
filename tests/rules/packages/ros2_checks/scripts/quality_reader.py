# What Python reads: two topics with more than is offered, the others with as much or less.
import rclpy
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy, qos_profile_sensor_data
from std_msgs.msg import String


class Reader(Node):
    def __init__(self):
        super().__init__('reader')
        lasting = QoSProfile(depth=1)
        lasting.durability = DurabilityPolicy.TRANSIENT_LOCAL
        self.create_subscription(String, 'image', self.on_text, 10)  # expect: finding incompatible-qos "/reader reads /image as reliable, but /sender publishes it as best effort"
        self.create_subscription(String, 'goal', self.on_text, lasting)  # expect: finding incompatible-qos "/reader reads /goal as transient local, but /sender publishes it as volatile"
        self.create_subscription(String, 'map', self.on_text, lasting)  # expect-not: finding incompatible-qos
        self.create_subscription(String, 'status', self.on_text, qos_profile_sensor_data)  # expect-not: finding incompatible-qos
        self.create_subscription(String, 'chosen', self.on_text, QoSProfile(depth=1, reliability=ReliabilityPolicy.RELIABLE))

    def on_text(self, text):
        self.get_logger().info(text.data)


def main():
    rclpy.init()
    rclpy.spin(Reader())


main()
