# Objects that are made in a loop or a comprehension: the name of a port says which of them it belongs to.
#
# expect-only: reactive * -> *
# expect: reactive a/target -> a/taken must
# expect: reactive b/target -> b/taken must
# expect: reactive lift/target -> lift/taken must
# expect: round_always(_, [_, "publisher", "a/effort"]), period_for_sink(_, [_, "publisher", "a/effort"], "0.1", 1, "")
# expect: round_always(_, [_, "publisher", "lift/effort"]), period_for_sink(_, [_, "publisher", "lift/effort"], "0.5", 1, "")
# expect: 3 = count : { period_for_sink(_, _, _, _, _) }
# expect: port_flow([_, _, "a/target"], [_, _, "a/effort"], "data", "deferred"), port_flow([_, _, "b/target"], [_, _, "b/effort"], "data", "deferred")
# expect: 0 = count : { port_flow([_, _, "a/target"], [_, _, "b/effort"], _, _) }, 0 = count : { port_flow([_, _, "lift/target"], [_, _, "a/effort"], _, _) }
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class Motor:
    def __init__(self, node, name, period):
        self.target = 0.0
        self.effort = node.create_publisher(Float64, f"{name}/effort", 10)
        self.taken = node.create_publisher(Float64, f"{name}/taken", 10)
        self.sub = node.create_subscription(Float64, f"{name}/target", self.on_target, 10)
        self.timer = node.create_timer(period, self.tick)

    def on_target(self, msg):
        self.target = msg.data
        self.taken.publish(msg)

    def tick(self):
        self.effort.publish(Float64(data=self.target))


class Motors(Node):
    def __init__(self):
        super().__init__("motors")
        self.motors = [Motor(self, name, 0.1) for name in ("a", "b")]
        self.extra = {"lift": Motor(self, "lift", 0.5)}


rclpy.init()
rclpy.spin(Motors())
