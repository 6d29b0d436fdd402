#!/usr/bin/env python3
import rclpy
from std_msgs.msg import String
def tick():
    pass


def main():
    rclpy.init()
    node = rclpy.create_node('late')
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    node.create_subscription(String, 'x', print, 1)  # expect: finding after-spin "/late makes this only after its spin has ended"
    node.create_timer(1.0, tick)  # expect: finding after-spin "*makes this*"
    rclpy.shutdown()


if __name__ == '__main__':
    main()
