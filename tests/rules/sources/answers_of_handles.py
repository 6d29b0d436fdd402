#!/usr/bin/env python3
# What becomes of a goal: its handle is asked for the result, which is given to a function by itself, bound or written in its place.
#
# expect: 6 = count : { answer_callback(C, F) }
# expect: in_callback([_, "action_client", "dock"], F, E), function_name(F, Name), match(".*on_dock_result", Name)
# expect: 0 = count : { in_callback([_, "service_client", _], F, E) }
# expect-only: reactive * -> *
# expect-only: transition *
from functools import partial

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.node import Node
from std_msgs.msg import Bool, Empty
from std_srvs.srv import Trigger


class Asker(Node):
    def __init__(self):
        super().__init__("asker")
        self.busy = False
        self.dock = ActionClient(self, Fibonacci, "dock")
        self.lift = ActionClient(self, Fibonacci, "lift")
        self.open = self.create_client(Trigger, "open")
        self.moves = self.create_publisher(Empty, "moves", 1)
        self.lifted = self.create_publisher(Empty, "lifted", 1)
        self.stopped = self.create_publisher(Empty, "stopped", 1)
        self.create_subscription(Bool, "order", self.on_order, 1)

    def on_order(self, message):
        if not self.busy:
            self.dock.send_goal_async(Fibonacci.Goal()).add_done_callback(self.on_dock)  # expect: reactive order -> dock
            self.future = self.lift.send_goal_async(Fibonacci.Goal())  # expect: reactive order -> lift
            self.future.add_done_callback(partial(self.on_lift, 3))

    def on_dock(self, future):
        handle = future.result()
        if handle.accepted:
            self.busy = True  # expect: transition busy = True on dock
            self.result = handle.get_result_async()
            self.result.add_done_callback(self.on_dock_result)

    def on_dock_result(self, future):
        self.busy = False  # expect: transition busy = False on dock
        self.moves.publish(Empty())  # expect: reactive dock -> moves must

    def on_lift(self, height, future):
        self.handle = future.result()
        self.handle.get_result_async().add_done_callback(lambda done: self.on_lift_result(height, done))
        self.handle.cancel_goal_async().add_done_callback(self.on_stopped)

    def on_lift_result(self, height, future):
        self.lifted.publish(Empty())  # expect: reactive lift -> lifted must
        self.ask_for(self.open)

    def ask_for(self, client):
        self.watch(client.call_async(Trigger.Request()))  # expect: reactive lift -> open must

    def watch(self, future):
        future.add_done_callback(self.on_open)

    def on_open(self, future):
        self.busy = future.result().success  # expect: transition busy = future.result().success on open

    def on_stopped(self, future):
        self.stopped.publish(Empty())  # expect: reactive lift -> stopped must


def main():
    rclpy.init()
    rclpy.spin(Asker())


if __name__ == "__main__":
    main()
