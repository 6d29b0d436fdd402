# A call that waits for its answer where code has the node that was not seen: it may spin it.
#
# expect: 0 = count : { misused(_, "waits unspun", _) }
import rclpy
from absent_threads import spin_beside
from rclpy.node import Node
from std_srvs.srv import Trigger


class Tea(Node):
    def __init__(self):
        super().__init__("tea")
        self.client = self.create_client(Trigger, "boil")
        self.timer = self.create_timer(1.0, self.again)
        spin_beside(self)

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
