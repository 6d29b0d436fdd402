#!/usr/bin/env python3
# A function that declares only what is no structure declares under a condition: of its call it is not known that the parameter has no value.
#
# expect: 1 = count : { declares_without_default(_) }
import dataclasses

import rclpy
from rclpy.node import Node


@dataclasses.dataclass
class Gains:
    p: float = 0.0
    i: float = 0.0


class Controller(Node):
    def __init__(self):
        super().__init__("controller")
        self.gains = self.declare_all(Gains(), "gains")
        self.declare_parameter("rate", rclpy.Parameter.Type.DOUBLE)
        self.period = 1.0 / self.get_parameter("rate").value

    def declare_all(self, data, name):
        if not dataclasses.is_dataclass(data):
            self.declare_parameter(name)
            return self.get_parameter(name).value
        for field in dataclasses.fields(data):
            setattr(data, field.name, self.declare_all(getattr(data, field.name), f"{name}.{field.name}"))
        return data


def main():
    rclpy.init()
    rclpy.spin(Controller())


if __name__ == "__main__":
    main()
