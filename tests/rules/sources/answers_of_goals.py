#!/usr/bin/env python3
# What a goal gives back while it is carried out: the function is named, or stands in its place.
#
# expect: action_client dock
# expect: Count = count : { answer_callback(C, F) }, Count = 2
# expect-only: reactive * -> *
# expect-only: transition *
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.node import Node
from std_msgs.msg import Bool, Empty


class Asker(Node):
    def __init__(self):
        super().__init__("asker")
        self.busy = False
        self.dock = ActionClient(self, Fibonacci, "dock")
        self.lift = ActionClient(self, Fibonacci, "lift")
        self.moves = self.create_publisher(Empty, "moves", 1)
        self.create_subscription(Bool, "order", self.on_order, 1)

    def on_order(self, message):
        if self.busy:
            self.lift.send_goal_async(Fibonacci.Goal(), feedback_callback=self.on_lift)  # expect: reactive order -> lift
        else:
            self.dock.send_goal_async(Fibonacci.Goal(), self.on_dock)  # expect: reactive order -> dock

    def on_dock(self, message):
        self.busy = True  # expect: transition busy = True on dock

    def on_lift(self, message):
        self.moves.publish(Empty())  # expect: reactive lift -> moves must


def main():
    rclpy.init()
    rclpy.spin(Asker())


if __name__ == "__main__":
    main()
