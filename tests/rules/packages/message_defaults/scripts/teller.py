#!/usr/bin/env python3
# Of a field that has a default, what it begins with is not claimed.
# expect: content_begins(_, "number", _)
# expect: content_given(_, "mode", _, _)
# expect-not: content_begins(_, "mode", _)
import rclpy
from message_defaults.msg import Mode
from rclpy.node import Node


class Teller(Node):
    def __init__(self):
        super().__init__('teller')
        self.pub = self.create_publisher(Mode, 'mode', 10)
        self.sub = self.create_subscription(Mode, 'wanted', self.on_wanted, 10)

    def on_wanted(self, wanted):
        told = Mode()
        if wanted.number > 3:
            told.mode = 3
            told.number = 3
        self.pub.publish(told)


def main():
    rclpy.init()
    rclpy.spin(Teller())


if __name__ == '__main__':
    main()
