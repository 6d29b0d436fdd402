#!/usr/bin/env python3
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class A(Node):
    def __init__(self):  # expect: finding base-not-made "*does not call the constructor of its base class, super().__init__"
        self.pub = self.create_publisher(String, 'x', 1)


class B(Node):
    def __init__(self):
        self.pub = self.create_publisher(String, 'x', 1)  # expect: finding base-not-made "*uses the node before super().__init__ has made it"
        super().__init__('b')


def main():
    rclpy.init()
    a = A()
    b = B()
    rclpy.spin(a)


if __name__ == '__main__':
    main()
