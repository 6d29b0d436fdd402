# A message that is made with its fields by name has in it what they are given.
#
# expect: port_flow([_, _, "in"], [_, _, "out"], "data", "deferred")
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class Holder(Node):
    def __init__(self):
        super().__init__("holder")
        self.value = 0.0
        self.pub = self.create_publisher(Float64, "out", 1)
        self.create_subscription(Float64, "in", self.on_in, 1)
        self.create_timer(0.1, self.tick)

    def on_in(self, msg):
        self.value = msg.data

    def tick(self):
        self.pub.publish(Float64(data=self.value))


rclpy.init()
rclpy.spin(Holder())
