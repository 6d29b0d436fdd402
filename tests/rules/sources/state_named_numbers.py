# Constants that stand for numbers, and those that stand for one of several states.
#
# expect: named_number(_, "LIMIT", _), named_number(_, "self.MOST", _), named_number(_, "Node.MOST", _)
# expect: 0 = count : { named_number(_, "IDLE", _) }, 0 = count : { named_number(_, "BUSY", _) }, 0 = count : { named_number(_, "RAISED", _) }
import rclpy
import rclpy.node
from std_msgs.msg import Empty

LIMIT = 3
RAISED = 3
IDLE = 0
BUSY = 1


class Node(rclpy.node.Node):
    MOST = 2

    def __init__(self):
        super().__init__("node")
        self.mode = IDLE
        self.count = 0
        self.raised = 0
        self.pub = self.create_publisher(Empty, "out", 1)
        self.create_subscription(Empty, "in", self.on_in, 1)
        self.create_subscription(Empty, "mode", self.on_mode, 1)

    def on_in(self, _):
        global RAISED
        self.count += 1
        self.raised += 1
        if self.count == LIMIT:
            self.pub.publish(Empty())
        if self.count >= self.MOST:
            self.count = 0
        if self.raised > RAISED:
            RAISED = 5
            self.pub.publish(Empty())

    def on_mode(self, _):
        if self.mode == BUSY:
            self.mode = IDLE
        else:
            self.mode = BUSY
            self.pub.publish(Empty())


rclpy.init()
rclpy.spin(Node())
