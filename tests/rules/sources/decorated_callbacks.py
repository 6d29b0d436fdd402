# Decorators of the source put functions around callbacks: these decide whether they run.
# expect-only: reactive * -> *
# expect: always_reacts([_, _, "logged"], [_, _, "a"]); always_reacts([_, _, "noted"], [_, _, "f"])
# expect-not: always_reacts([_, _, "guarded"], _); always_reacts([_, _, "seldom"], _); always_reacts([_, _, "both"], _)
# expect-not: always_reacts([_, _, "free"], _)
# expect-not: port_flow([_, _, "guarded"], [_, _, "a"], _, _); port_flow([_, _, "both"], [_, _, "b"], _, _)
# expect: port_flow([_, _, "logged"], [_, _, "a"], "data", _); port_flow([_, _, "both"], [_, _, "d"], "data", _)
import functools
import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32

NOTED = []


def positive(callback):
    @functools.wraps(callback)
    def inner(self, msg):
        if msg.data > 0:
            callback(self, msg)

    return inner


def logged(level):
    """What is called is said."""

    def around(callback):
        def inner(self, *args, **kwargs):
            self.get_logger().log(callback.__name__, level)
            result = callback(self, *args, **kwargs)
            return result

        return inner

    return around


def seldom(hz):
    def around(callback):
        last = [0.0]

        def inner(*args):
            if time.time() - last[0] > 1.0 / hz:
                last[0] = time.time()
                callback(*args)

        return inner

    return around


def noted(callback):
    NOTED.append(callback)
    return callback


@positive
def free(node, msg):
    node.pe.publish(msg)  # expect: reactive free -> e when="msg.data > 0"


class Decorated(Node):
    def __init__(self):
        super().__init__("decorated")
        self.pa = self.create_publisher(Int32, "a", 1)
        self.pb = self.create_publisher(Int32, "b", 1)
        self.pc = self.create_publisher(Int32, "c", 1)
        self.pd = self.create_publisher(Int32, "d", 1)
        self.pe = self.create_publisher(Int32, "e", 1)
        self.pf = self.create_publisher(Int32, "f", 1)
        self.create_subscription(Int32, "logged", self.on_logged, 1)
        self.create_subscription(Int32, "guarded", self.on_guarded, 1)
        self.create_subscription(Int32, "seldom", self.on_seldom, 1)
        self.create_subscription(Int32, "both", self.on_both, 1)
        self.create_subscription(Int32, "free", lambda msg: free(self, msg), 1)
        self.create_subscription(Int32, "noted", self.on_noted, 1)

    @logged("info")
    def on_logged(self, msg):
        self.pa.publish(msg)  # expect: reactive logged -> a

    @positive
    def on_guarded(self, msg):
        self.pb.publish(msg)  # expect: reactive guarded -> b when="msg.data > 0"

    @seldom(2)
    def on_seldom(self, msg):
        self.pc.publish(msg)  # expect: reactive seldom -> c

    @logged("warn")
    @positive
    def on_both(self, msg):
        self.pd.publish(msg)  # expect: reactive both -> d when="msg.data > 0"

    @noted
    def on_noted(self, msg):
        self.pf.publish(msg)  # expect: reactive noted -> f


rclpy.init()
rclpy.spin(Decorated())
