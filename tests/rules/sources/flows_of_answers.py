# A service answers what it is asked, another one what it was asked before or was told on a topic, which decides under a condition.
#
# expect: port_flow([_, _, "plain"], [_, _, "plain"], "data", _)
# expect: keeps_requests([_, _, "last"])
# expect: 1 = count : { keeps_requests(_) }
# expect: port_flow([_, "subscriber", "armed"], [_, _, "last"], _, _)
# expect-not: port_flow([_, "subscriber", "armed"], [_, _, "plain"], _, _)
import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool
from std_srvs.srv import SetBool


class Calculator(Node):
    def __init__(self):
        super().__init__("calculator")
        self.last = False
        self.armed = False
        self.asked = 0
        self.create_subscription(Bool, "armed", self.arm, 1)
        self.create_service(SetBool, "plain", self.plain)
        self.create_service(SetBool, "last", self.answer)

    def arm(self, message):
        self.armed = message.data

    def plain(self, request, response):
        response.success = not request.data
        return response

    def answer(self, request, response):
        if self.armed:
            response.success = self.last
        self.last = request.data
        return response


def main():
    rclpy.init()
    rclpy.spin(Calculator())


main()
