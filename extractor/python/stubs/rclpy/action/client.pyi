from rclpy.action import *
