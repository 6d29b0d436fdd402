#!/usr/bin/env python3
# Parameters, answers and buffers that are used wrongly, each beside what is right.
#
# expect: 2 = count : { misused(_, "object for value", "rate") }
# expect: 1 = count : { misused(_, "object for value", "debug") }
# expect: 3 = count : { misused(_, "object for value", _) }
# expect: 1 = count : { misused(_, "value of another type", _) }
# expect: misused(_, "value of another type", "rate as integer, and it is declared as float")
# expect: 1 = count : { misused(_, "no result", "a SetParametersResult") }
# expect: 1 = count : { misused(_, "no result", _) }
# expect: 1 = count : { misused(_, "answer too early", _) }
# expect: 2 = count : { misused(_, "two clocks", _) }
# expect-not: misused(_, "buffer alone", _); misused(_, "goal not ended", _); misused(_, "lookup of now", _)
import rclpy
from example_interfaces.action import Fibonacci
from rcl_interfaces.msg import SetParametersResult
from rclpy.action import ActionServer
from rclpy.clock import Clock
from rclpy.node import Node
from rclpy.time import Time
from std_srvs.srv import Trigger
from tf2_ros import Buffer, TransformListener


class Lamp(Node):
    def __init__(self):
        super().__init__("lamp")
        self.declare_parameter("rate", 2.0)
        self.declare_parameter("debug", False)
        self.declare_parameter("steps", 3)
        self.declare_parameter("level", 3)
        rate = self.get_parameter("rate")
        self.half = rate / 2
        self.timer = self.create_timer(1.0 / self.get_parameter("rate"), self.tick)
        self.other = self.create_timer(1.0 / self.get_parameter("rate").value, self.tick)
        self.whole = self.get_parameter("rate").get_parameter_value().integer_value
        self.right = self.get_parameter("rate").get_parameter_value().double_value
        self.steps = self.get_parameter("steps").get_parameter_value().integer_value
        asked = self.get_parameter("level").get_parameter_value().type == 3
        self.level = self.get_parameter("level").get_parameter_value().double_value if asked else None
        self.add_on_set_parameters_callback(self.changed)
        self.add_on_set_parameters_callback(self.accepted)
        self.client = self.create_client(Trigger, "reset")
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.last = self.get_clock().now()
        self.early = Clock().now()
        self.server = ActionServer(self, Fibonacci, "count", self.run)

    def run(self, goal_handle):
        goal_handle.succeed()
        return Fibonacci.Result()

    def changed(self, parameters):
        self.get_logger().info(str(parameters))

    def accepted(self, parameters):
        return SetParametersResult(successful=True)

    def tick(self):
        if self.get_parameter("debug"):
            self.get_logger().info("tick")
        if self.get_parameter("debug").value:
            self.get_logger().info("tick")
        age = self.get_clock().now() - self.last
        wrong = self.get_clock().now() - self.early
        older = self.get_clock().now() - Clock().now()
        future = self.client.call_async(Trigger.Request())
        self.on = future.result().success
        asked = self.client.call_async(Trigger.Request())
        rclpy.spin_until_future_complete(self, asked)
        self.on = asked.result().success
        self.buffer.lookup_transform("odom", "base_link", Time())
        self.buffer.lookup_transform("odom", "base_link", self.get_clock().now(), rclpy.duration.Duration(seconds=1.0))
        self.get_logger().info(f"{age} {wrong} {older}")


def main():
    rclpy.init()
    rclpy.spin(Lamp())


if __name__ == "__main__":
    main()
