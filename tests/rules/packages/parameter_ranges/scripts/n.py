#!/usr/bin/env python3
# expect: component n package=parameter_ranges
import rclpy
from rclpy.node import Node
from rcl_interfaces.msg import ParameterDescriptor, FloatingPointRange, IntegerRange


class N(Node):
    def __init__(self):
        super().__init__('n')
        self.declare_parameter('speed', 1.0, ParameterDescriptor(floating_point_range=[FloatingPointRange(from_value=0.0, to_value=5.0)]))
        d = ParameterDescriptor()
        r = IntegerRange()
        r.from_value = 0
        r.to_value = 5
        d.integer_range.append(r)
        self.declare_parameter('turn', 1, d)
        d3 = ParameterDescriptor(description='x', integer_range=[IntegerRange(from_value=-1, to_value=1, step=1)])
        self.declare_parameter('d3', 1, descriptor=d3)


def main():
    rclpy.init()
    rclpy.spin(N())


if __name__ == '__main__':
    main()
