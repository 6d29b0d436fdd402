"""A rate of rclpy where another thread spins."""

# expect: 0 = count : { sleeps_for_ever(_) }
# expect: subscriber level
import threading

import rclpy
from std_msgs.msg import Int32


def main():
    rclpy.init()
    node = rclpy.create_node("level")
    node.create_subscription(Int32, "level", print, 10)
    threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
    rate = node.create_rate(5)
    while rclpy.ok():
        rate.sleep()


main()
