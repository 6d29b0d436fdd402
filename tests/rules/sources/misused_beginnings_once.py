# Libraries that are started again where they may be, transforms that are sent again, goals whose server was waited for.
#
# expect-not: misused(_, _, _)
import rclpy
from geometry_msgs.msg import TransformStamped
from nav2_msgs.action import NavigateToPose
from rclpy.action import ActionClient
from rclpy.context import Context
from rclpy.node import Node
from tf2_ros import TransformBroadcaster


class Arm(Node):
    def __init__(self):
        super().__init__("arm")
        self.broadcaster = TransformBroadcaster(self)
        self.broadcaster.sendTransform(TransformStamped())
        self.move = ActionClient(self, NavigateToPose, "navigate_to_pose")
        self.move.wait_for_server()
        self.move.send_goal_async(NavigateToPose.Goal())
        self.timer = self.create_timer(1.0, self.tick)

    def tick(self):
        self.broadcaster.sendTransform(TransformStamped())


def again():
    rclpy.shutdown()
    rclpy.init()


def main():
    rclpy.init()
    rclpy.init(context=Context())
    again()
    rclpy.spin(Arm())


main()
