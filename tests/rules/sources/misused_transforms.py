# Transforms that are sent while a program begins and never again: that of a static broadcaster is kept for whoever comes later.
#
# expect: 1 = count : { misused(_, "sent once", _) }
import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros import StaticTransformBroadcaster, TransformBroadcaster


class Camera(Node):
    def __init__(self):
        super().__init__("camera")
        self.broadcaster = TransformBroadcaster(self)
        self.broadcaster.sendTransform(TransformStamped())
        self.fixed = StaticTransformBroadcaster(self)
        self.fixed.sendTransform(TransformStamped())


rclpy.init()
camera = Camera()
rclpy.spin(camera)
