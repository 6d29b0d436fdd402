#!/usr/bin/env python3
import rclpy
from rclpy.node import Node


class A(Node):
    def __init__(self):
        super().__init__('noinit')
        rate = 20
        self.t = self.create_timer(1 // rate, self.tick)  # expect: finding period-of-zero "/noinit makes a timer whose period is zero*"
    def tick(self):
        pass


def main():
    rclpy.spin(A())  # expect: finding library-not-started "/noinit uses rclpy, which nothing in its program initialises"


if __name__ == '__main__':
    main()
