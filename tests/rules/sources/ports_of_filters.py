#!/usr/bin/env python3
# Filters of messages in Python, which are given lists of filters; of ROS 2, the node comes first.
#
# expect: subscriber image sensor_msgs/Image queue= callback=Both::both
# expect: subscriber info sensor_msgs/CameraInfo queue=5 callback=Both::both
# expect: subscriber left sensor_msgs/Image callback=Both::sides
# expect: subscriber right sensor_msgs/Image callback=Both::sides
# expect: subscriber kept sensor_msgs/Image callback=
# expect: subscriber held sensor_msgs/Image callback=Both::both
# expect: reactive image -> out
# expect: reactive info -> out
# expect: reactive left -> sides
# expect: reactive right -> sides
# expect: reactive held -> out
# expect: port_quality([_, "subscriber", "image"], "reliability", "reliable"), port_quality([_, "subscriber", "info"], "reliability", "best_effort")
# expect-only: reactive * -> *
import rclpy
from message_filters import ApproximateTimeSynchronizer, Cache, Subscriber, TimeSynchronizer
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import CameraInfo, Image


class Both(Node):
    def __init__(self):
        super().__init__("both")
        self.out = self.create_publisher(Image, "out", 1)
        self.pair = self.create_publisher(Image, "sides", 1)
        self.image = Subscriber(self, Image, "image")
        self.info = Subscriber(self, CameraInfo, "info", qos_profile=qos_profile_sensor_data)
        self.sync = TimeSynchronizer([self.image, self.info], 10)
        self.sync.registerCallback(self.both)
        sides = [Subscriber(self, Image, side) for side in ("left", "right")]
        near = ApproximateTimeSynchronizer(sides, 10, 0.1)
        near.registerCallback(self.sides)
        self.cache = Cache(Subscriber(self, Image, "kept"), 5)
        self.given = []
        self.given.append(Subscriber(self, Image, "held"))
        late = TimeSynchronizer(self.given, 2)
        late.registerCallback(self.both)

    def both(self, *messages):
        self.out.publish(Image())

    def sides(self, left, right):
        self.pair.publish(left)


rclpy.init()
rclpy.spin(Both())
