#!/usr/bin/env python3
# A function that declares what it is given: each parameter is of the type that its own call gives, none of that of another call.
#
# expect: parameter_access_type(_, "rate", "float")
# expect: parameter_access_type(_, "verbose", "boolean")
# expect-not: parameter_access_type(_, "rate", "boolean"); parameter_access_type(_, "verbose", "float"); parameter_access_type(_, "bus", _)
import rclpy
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node


class Driver(Node):
    def __init__(self, defaults, bus):
        super().__init__("driver")
        self.defaults = defaults
        self.rate = self.declare("rate", 10.0).value
        self.verbose = self.declare("verbose", False).value
        self.bus = self.declare("bus", bus).value

    def declare(self, name: str, value, description: str = ""):
        if name in self.defaults:
            value = self.defaults[name]
        return self.declare_parameter(name, value, ParameterDescriptor(description=description))


def main():
    rclpy.init()
    rclpy.spin(Driver({}, "can0"))


if __name__ == "__main__":
    main()
