#!/usr/bin/env python3
# Measurements that are sent without a stamp, in rclpy. What sets the header, or may, silences.
#
# expect: 1 = count : { sent_unstamped(_, _) }
# expect: sent_unstamped(_, [_, _, "plain"])
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import Range
from std_msgs.msg import Float64, Header


def stamp(node, message):
    message.header.stamp = node.get_clock().now().to_msg()


class Sensors(Node):
    def __init__(self):
        super().__init__("sensors")
        self.plain = self.create_publisher(Range, "plain", 1)
        self.named = self.create_publisher(Range, "named", 1)
        self.set = self.create_publisher(Range, "set", 1)
        self.whole = self.create_publisher(Range, "whole", 1)
        self.given = self.create_publisher(Range, "given", 1)
        self.copied = self.create_publisher(Range, "copied", 1)
        self.sub = self.create_subscription(Float64, "distance", self.on_distance, 1)
        self.range_sub = self.create_subscription(Range, "range", self.on_range, 1)

    def on_distance(self, distance):
        plain = Range()
        plain.range = distance.data
        self.plain.publish(plain)
        named = Range(header=Header(stamp=self.get_clock().now().to_msg()), range=distance.data)
        self.named.publish(named)
        set_ = Range()
        set_.header.stamp = self.get_clock().now().to_msg()
        self.set.publish(set_)
        given = Range()
        stamp(self, given)
        self.given.publish(given)

    def on_range(self, message):
        whole = Range()
        whole.header = message.header
        self.whole.publish(whole)
        copied = message
        copied.range = 1.0
        self.copied.publish(copied)


rclpy.init()
rclpy.spin(Sensors())
