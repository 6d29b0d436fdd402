# What a program does at its start that its client library does not allow, or too early.
#
# expect: 1 = count : { misused(_, "started twice", "rclpy::init") }
# expect: 1 = count : { misused(_, "started twice", _) }
# expect: 3 = count : { misused(_, "member overwritten", _) }
# expect: misused(_, "member overwritten", "timers"); misused(_, "member overwritten", "clients")
# expect: 1 = count : { misused(_, "two executors", _) }
# expect: 1 = count : { misused(_, "no result", _) }
# expect: misused(_, "no result", "a TransitionCallbackReturn from on_configure")
# expect: call_refused(_, "QoSProfile", "without depth or history")
# expect: call_refused(_, "imgmsg_to_cv2", "with the encoding rgb, which it does not know")
# expect: call_refused(_, "cv2_to_imgmsg", "with the encoding grey, which it does not know")
# expect: 3 = count : { call_refused(_, _, _) }
# expect: 1 = count : { misused(_, "goal too early", _) }
# expect-not: misused(_, "waits unspun", _)
import rclpy
from cv_bridge import CvBridge
from nav2_msgs.action import NavigateToPose
from rclpy.action import ActionClient
from rclpy.executors import SingleThreadedExecutor
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy
from std_msgs.msg import Float32


class Timed(Node):
    def timers(self):
        return []


class Mine(Timed):
    def __init__(self):
        super().__init__("mine")
        self.timers = []  # a class between them says otherwise
        self.outputs = []


class Drone(Node):
    def __init__(self):
        rclpy.init()
        super().__init__("drone")
        self.timers = []
        self.clients, self.others = None, {}
        self.clients = {}
        self.others = {}
        self.bridge = CvBridge()
        self.pub = self.create_publisher(Float32, "a", QoSProfile(reliability=ReliabilityPolicy.BEST_EFFORT))
        self.pub2 = self.create_publisher(Float32, "b", QoSProfile(depth=1))
        self.pub3 = self.create_publisher(Float32, "c", QoSProfile(history=1))
        self.timer = self.create_timer(1.0, self.look)
        self.move = ActionClient(self, NavigateToPose, "navigate_to_pose")
        self.move.send_goal_async(NavigateToPose.Goal())

    def look(self):
        self.bridge.imgmsg_to_cv2(None, desired_encoding="rgb")
        self.bridge.imgmsg_to_cv2(None, "bgr8")
        self.bridge.imgmsg_to_cv2(None, "16UC1")
        self.bridge.cv2_to_imgmsg(None, "grey")
        self.bridge.cv2_to_imgmsg(None, encoding="mono8")


class Gauge(LifecycleNode):
    def on_configure(self, state):
        self.get_logger().info("configured")

    def on_activate(self, state):
        return TransitionCallbackReturn.SUCCESS


def main():
    rclpy.init()
    Mine()
    drone = Drone()
    gauge = Gauge("gauge")
    executor = SingleThreadedExecutor()
    executor.add_node(drone)
    executor.add_node(gauge)
    executor.remove_node(gauge)
    rclpy.spin_once(gauge)
    rclpy.spin_once(drone)
    rclpy.spin_once(drone, executor=executor)
    executor.spin()
    rclpy.shutdown()


main()
