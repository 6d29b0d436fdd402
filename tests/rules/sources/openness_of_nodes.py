#!/usr/bin/env python3
# What gets a node of Python and was not seen; built-in functions, the standard library and what is known of ROS leave it closed.
#
# expect: open_at("ports", C, ["handed", "absent_b::Helper"])
# expect: open_at("ports", C, ["handed", "absent_b::attach"])
# expect: open_at("ports", C, ["handed", "absent_b::Helper::start"])
# expect: open_at("ports", C, ["given", "node"])
# expect: open_at("ports", C, ["base", "absent_d::BaseNode"])
# expect: Count = count : { open_at("params", C, ["handed", Name]) }, Count = 3
import functools
import threading

import absent_c.tools as tools
import rclpy
from absent_b import Helper, attach
from absent_d import BaseNode, Mixin
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from tf2_ros import Buffer, TransformListener


class One(Node, Mixin):
    def __init__(self):
        super().__init__("one")
        self.helper = Helper(self)
        attach(self, "x")
        tools.Thing(node=self)
        self.helper.start(self)
        print(self)
        if hasattr(self, "x") and isinstance(self, Node):
            setattr(self, self.get_name(), 1)
        functools.partial(self.go, self)
        self.listener = TransformListener(Buffer(), self)
        threading.Thread(target=self.go, args=(self,)).start()
        tools.draw(3)

    def go(self, *given):
        pass


class Two(BaseNode):
    def __init__(self):
        super().__init__("two")


def main():
    rclpy.init()
    executor = MultiThreadedExecutor()
    executor.add_node(One())
    executor.add_node(Two())
    executor.spin()


if __name__ == "__main__":
    main()
