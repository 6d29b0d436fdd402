# A call that waits for its answer in a program that spins only after it.
#
# expect: 1 = count : { misused(_, "waits unspun", _) }
import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


class Tea(Node):
    def __init__(self):
        super().__init__("tea")
        self.client = self.create_client(Trigger, "boil")
        self.timer = self.create_timer(1.0, self.again)

    def boil(self):
        return self.client.call(Trigger.Request())

    def again(self):
        self.client.call(Trigger.Request())


def main():
    rclpy.init()
    node = Tea()
    node.boil()
    rclpy.spin(node)


main()
