# expect: keeps_moment(V), variable_name(V, "last")
# expect: keeps_moment(V), variable_name(V, "heard")
# expect: N = count : { keeps_moment(_) }, N = 2
import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Empty


class Slow(Node):
    def __init__(self):
        super().__init__("slow")
        self.last = self.get_clock().now()
        self.heard = 0.0
        self.pub = self.create_publisher(Empty, "out", 1)
        self.create_subscription(Empty, "in", self.on_in, 1)

    def on_in(self, msg):
        now = self.get_clock().now()
        if (now - self.last).nanoseconds < 2e8 or time.time() - self.heard > 3.0:
            return
        self.last = now
        self.heard = time.time()
        self.pub.publish(Empty())


def main():
    rclpy.init()
    rclpy.spin(Slow())


if __name__ == "__main__":
    main()
