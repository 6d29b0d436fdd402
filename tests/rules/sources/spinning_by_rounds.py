# The main loop spins the node once in each round, and adds it again by that: what a callback spins takes it away for no longer than that.
#
# expect-not: spins_again(_, _)
import rclpy
from rclpy.node import Node
from std_srvs.srv import Empty


class Robot(Node):
    def __init__(self):
        super().__init__("robot")
        self.client = self.create_client(Empty, "clear")
        self.create_service(Empty, "reset", self.on_reset)

    def on_reset(self, request, response):
        future = self.client.call_async(Empty.Request())
        rclpy.spin_until_future_complete(self, future)
        return response


def main():
    rclpy.init()
    robot = Robot()
    while rclpy.ok():
        rclpy.spin_once(robot, timeout_sec=0.1)


if __name__ == "__main__":
    main()
