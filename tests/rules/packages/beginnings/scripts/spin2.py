#!/usr/bin/env python3
import rclpy


def main():
    rclpy.init()
    a = rclpy.create_node('a')
    b = rclpy.create_node('b')
    rclpy.spin(a)
    rclpy.spin(b)  # expect: finding after-spin "*spins another node*"


if __name__ == '__main__':
    main()
