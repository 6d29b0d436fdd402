import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool


class Keeper(Node):
    """Backs off from what is too near, and stops the rover where that does not help."""

    def __init__(self):
        super().__init__("keeper")
        self.distance = self.declare_parameter("distance", 0.5).value
        self.back_off = self.create_publisher(Twist, "keeper/cmd_vel", 1)
        self.stop = self.create_publisher(Bool, "stop", 1)
        self.create_subscription(LaserScan, "scan", self.on_scan, qos_profile_sensor_data)

    def on_scan(self, scan):
        nearest = min(scan.ranges)
        self.stop.publish(Bool(data=nearest < self.distance / 2))
        if nearest < self.distance:
            command = Twist()
            command.linear.x = -0.1
            self.back_off.publish(command)


def main():
    rclpy.init()
    rclpy.spin(Keeper())
