# A node of rclpy makes another publisher each time, which no subscriber is connected to yet.
#
# expect: sent_where_made([_, _, "alarm"], _)
# expect: 1 = count : { sent_where_made(_, _) }
import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool, Float32


class Watch(Node):
    def __init__(self):
        super().__init__("watch")
        self.create_subscription(Float32, "heat", self.on_heat, 1)

    def on_heat(self, heat):
        pub = self.create_publisher(Bool, "alarm", 1)
        pub.publish(Bool(data=heat.data > 90))


rclpy.init()
rclpy.spin(Watch())
