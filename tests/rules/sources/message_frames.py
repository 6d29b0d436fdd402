# The frames that messages say to be in.
#
# expect: sent_in_frame(_, [_, _, "cloud"], "lidar", "")
# expect: sent_in_frame(_, [_, _, "scan"], "laser", "frame")
# expect: 2 = count : { sent_in_frame(_, _, _, _) }
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import LaserScan, PointCloud2


class Lidar(Node):
    def __init__(self):
        super().__init__("lidar")
        self.frame = self.declare_parameter("frame", "laser").value
        self.cloud = self.create_publisher(PointCloud2, "cloud", 10)
        self.scan = self.create_publisher(LaserScan, "scan", 10)
        self.either = self.create_publisher(LaserScan, "either", 10)
        self.passed = self.create_subscription(LaserScan, "in", self.on_scan, 10)
        self.timer = self.create_timer(0.1, self.tick)

    def tick(self):
        cloud = PointCloud2()
        cloud.header.frame_id = "lidar"
        self.cloud.publish(cloud)
        scan = LaserScan()
        scan.header.frame_id = self.frame
        self.scan.publish(scan)

    def on_scan(self, scan):
        # one of two
        if scan.ranges:
            scan.header.frame_id = "front"
        else:
            scan.header.frame_id = "back"
        self.either.publish(scan)


def main():
    rclpy.init()
    rclpy.spin(Lidar())


main()
