from rclpy.lifecycle import *
