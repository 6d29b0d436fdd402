#!/usr/bin/env python3
# A class of nodes that code that is not there makes: a process library is given the class.
#
# expect: publisher status
# expect: subscriber cmd std_msgs/String callback=Robot::on_cmd
# expect-only: publisher subscriber
# expect: open_at("ports", _, ["handed", "fleet.process::spin"])
import rclpy
from fleet.node import Node
from fleet.process import spin
from std_msgs.msg import String


class Robot(Node):
    def __init__(self, **kwargs):
        super().__init__("robot", **kwargs)
        self.pub = self.create_publisher(String, "status", 1)
        self.create_subscription(String, "cmd", self.on_cmd, 1)

    def on_cmd(self, msg):
        self.pub.publish(msg)


class Other(Node):
    def __init__(self):
        super().__init__("other")
        self.create_publisher(String, "never", 1)


def main():
    spin(Robot)
    print(isinstance(rclpy.ok(), Other))


main()
