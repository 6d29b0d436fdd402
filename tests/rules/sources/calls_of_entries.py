# Callbacks in dictionaries, asked for by constants, and by what may be any of them.
# expect-only: reactive * -> *
# expect: reactive in_a -> a
# expect: reactive in_b -> b
# expect: reactive in_any -> a
# expect: reactive in_any -> b
# expect: reactive in_named -> a
# expect: reactive in_named -> b
# expect: reactive in_else -> a
# expect: reactive in_else -> b
import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32


class Table(Node):
    def __init__(self):
        super().__init__("table")
        self.pa = self.create_publisher(Int32, "a", 1)
        self.pb = self.create_publisher(Int32, "b", 1)
        table = {"a": self.on_a, "b": self.on_b}
        self.create_subscription(Int32, "in_a", table["a"], 1)
        self.create_subscription(Int32, "in_b", table.get("b"), 1)
        changed = {"a": self.on_a, "b": self.on_a}
        changed["b"] = self.on_b
        self.create_subscription(Int32, "in_any", changed["b"], 1)
        self.create_subscription(Int32, "in_named", table[self.get_name()], 1)
        self.create_subscription(Int32, "in_else", table.get(self.get_name(), self.on_b), 1)

    def on_a(self, msg):
        self.pa.publish(msg)

    def on_b(self, msg):
        self.pb.publish(msg)


rclpy.init()
rclpy.spin(Table())
