#!/usr/bin/env python3
import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32


class Placed(Node):
    def __init__(self):
        super().__init__('placed_py', namespace='/jet')
        self.sub = self.create_subscription(Int32, 'cmd', print, 1)  # expect: finding topic-type-mismatch "/jet/placed_py reads /jet/cmd as std_msgs/Int32, but /jet/placed publishes it as std_msgs/String"


def main():
    rclpy.init()
    rclpy.spin(Placed())


if __name__ == '__main__':
    main()
