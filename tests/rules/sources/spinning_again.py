#!/usr/bin/env python3
# A callback of an action server that spins its own node takes it from its executor; one that names the executor does not, nor one that spins another node; one that never ends spins it again and again.
#
# expect: spins_again(C, "removed"), expr_function(C, F), function_name(F, Name), match(".*Delegate::execute", Name)
# expect: 1 = count : { spins_again(_, _) }
import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Bool
from tf2_msgs.action import LookupTransform


class Delegate(Node):
    def __init__(self):
        super().__init__("delegate")
        self.helper = rclpy.create_node("helper")
        self.client = ActionClient(self, LookupTransform, "look")
        self.server = ActionServer(self, LookupTransform, "delegated", self.execute)
        self.sub = self.create_subscription(Bool, "step", self.on_step, 10)
        self.timer = self.create_timer(1.0, self.on_timer)

    def execute(self, goal):
        sent = self.client.send_goal_async(LookupTransform.Goal())
        rclpy.spin_until_future_complete(self, sent)
        return LookupTransform.Result()

    def on_step(self, msg):
        rclpy.spin_once(self, executor=self.executor)
        rclpy.spin_once(self.helper, timeout_sec=0.1)

    def on_timer(self):
        while rclpy.ok():
            rclpy.spin_once(self)


def main():
    rclpy.init()
    executor = MultiThreadedExecutor()
    executor.add_node(Delegate())
    executor.spin()


main()
