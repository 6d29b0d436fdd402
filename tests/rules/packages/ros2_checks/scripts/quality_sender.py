# What Python publishes, each topic with another quality of service.
# expect-not: finding incompatible-qos "*/map*"
# expect-not: finding incompatible-qos "*/status*"
# expect-not: finding incompatible-qos "*/chosen*"
import rclpy
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy, qos_profile_sensor_data, qos_profile_system_default
from std_msgs.msg import String


class Sender(Node):
    def __init__(self):
        super().__init__('sender')
        lasting = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL, reliability=ReliabilityPolicy.RELIABLE)
        self.image = self.create_publisher(String, 'image', qos_profile_sensor_data)
        self.goal = self.create_publisher(String, 'goal', 10)
        self.map = self.create_publisher(String, 'map', lasting)
        self.status = self.create_publisher(String, 'status', 10)
        self.chosen = self.create_publisher(String, 'chosen', qos_profile_system_default)


def main():
    rclpy.init()
    rclpy.spin(Sender())


main()
