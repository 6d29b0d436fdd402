#!/usr/bin/env python3
# expect-not: finding after-spin "*good.py*"
# expect-not: finding after-spin "/good*"
# expect-not: finding base-not-made "*good.py*"
# expect-not: finding base-not-made "/good*"
# expect-not: finding period-of-zero "*good.py*"
# expect-not: finding period-of-zero "/good*"
# expect-not: finding library-not-started "*good.py*"
# expect-not: finding library-not-started "/good*"
# expect: component good package=beginnings
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Mix:
    pass


class A(Mix, Node):
    def __init__(self):
        Node.__init__(self, 'good')
        self.pub = self.create_publisher(String, 'x', 1)
        self.t = self.create_timer(1 / 20, self.tick)
        self.u = self.create_timer(20 // 3, self.tick)
    def tick(self):
        pass


class B(A):
    pass


def main():
    rclpy.init()
    a = B()
    while rclpy.ok():
        rclpy.spin(a)
        a.create_timer(1.0, a.tick)


if __name__ == '__main__':
    main()
