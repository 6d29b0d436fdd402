#!/usr/bin/env python3
# Messages that are sent without a stamp, a frame or a rotation, in rclpy. What sets them, or may, silences.
#
# expect: 3 = count : { sent_without(_, _, _) }
# expect: sent_without(_, [_, _, "plain"], "header")
# expect: sent_without(_, [_, _, "set"], "header.frame_id")
# expect: sent_without(_, [_, "tf_broadcaster", _], "transform.rotation")
import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from sensor_msgs.msg import Range
from std_msgs.msg import Float64, Header
from tf2_ros import TransformBroadcaster


def stamp(node, message):
    message.header.stamp = node.get_clock().now().to_msg()


class Sensors(Node):
    def __init__(self):
        super().__init__("sensors")
        self.broadcaster = TransformBroadcaster(self)
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
        given.header.frame_id = "front"
        stamp(self, given)
        self.given.publish(given)

        unturned = TransformStamped()
        unturned.header.frame_id = "base"
        unturned.transform.translation.x = distance.data
        self.broadcaster.sendTransform(unturned)
        turned = TransformStamped()
        turned.transform.rotation.w = 1.0
        self.broadcaster.sendTransform(turned)
        framed = Range()
        framed.header.stamp = self.get_clock().now().to_msg()
        framed.header.frame_id = "front"
        self.set.publish(framed)

    def on_range(self, message):
        whole = Range()
        whole.header = message.header
        self.whole.publish(whole)
        copied = message
        copied.range = 1.0
        self.copied.publish(copied)


rclpy.init()
rclpy.spin(Sensors())
