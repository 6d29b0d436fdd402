# Timers of Python that wait.
import time

import rclpy
from rclpy.node import Node


class Slow(Node):
    def __init__(self):
        super().__init__('slow')
        self.create_timer(0.1, self.step)
        self.create_timer(0.5, self.rest)

    def step(self):
        time.sleep(0.1)  # expect: finding timer-overrun "*/slow_script waits 100.0 ms*every 100.0 ms"

    def rest(self):
        time.sleep(0.1)  # expect-not: finding timer-overrun


def main():
    rclpy.init()
    rclpy.spin(Slow())


main()
