# A variable that keeps a parameter, however it is taken out of the object that declaring and getting it give.
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, String


# expect: configuration low = 1.5 from_param=low
# expect: configuration high = 2.5 from_param=high
# expect: configuration most = 9.0 from_param=most
class Guard(Node):
    def __init__(self):
        super().__init__("guard")
        self.declare_parameter("high", 2.5)
        self.low = self.declare_parameter("low", 1.5).value
        self.high = self.get_parameter("high").value
        self.most = self.declare_parameter("most", 9.0).get_parameter_value().double_value
        self.pub = self.create_publisher(String, "alarm", 10)  # expect: publisher alarm std_msgs/String
        self.create_subscription(Float32, "level", self.on_level, 10)  # expect: subscriber level std_msgs/Float32

    def on_level(self, message):
        if self.low < message.data < self.high:
            self.pub.publish(String())  # expect: reactive level -> alarm must=false
        if message.data > self.most:
            self.pub.publish(String(data="most"))


def main():
    rclpy.init()
    rclpy.spin(Guard())


main()
