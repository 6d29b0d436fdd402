#!/usr/bin/env python3
# A function inside of another sees what a variable of that has when it is called: no value of a loop that is over, and none of a later one.
# One that is handed on may be called whenever.
#
# expect-only: param * = 2
# expect: param c.x = 2
# expect: param d.x = 2
# expect: param c.y = 2
# expect: param d.y = 2
# expect-only: param * = 3
# expect: param early = 3
# expect: param late = 3
# expect-only: param * = 4
# expect: param at_call = 4
import rclpy
from rclpy.node import Node


class Parameters(Node):
    def __init__(self):
        super().__init__("parameters")
        for name in ["a", "b"]:
            self.declare_parameter(name, 1)
        for name in ["c", "d"]:

            def declare(part):
                self.declare_parameter(name + "." + part, 2)  # noqa: B023

            declare("x")
            declare("y")
        kind = "early"

        def later():
            self.declare_parameter(kind, 3)

        self.timer = self.create_timer(1.0, later)
        kind = "late"
        role = "before"

        def once():
            self.declare_parameter(role, 4)

        role = "at_call"
        once()
        role = "after"


rclpy.init()
rclpy.spin(Parameters())
