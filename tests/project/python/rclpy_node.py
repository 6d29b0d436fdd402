# A node of ROS 2: parameters, quality of service, timers, services, actions.
#
# expect: component rclpy_node node_name=minder
# expect: periodic state 4 Hz mechanism=timer if "self.ready and self.count > 2"
# expect: state Minder::ready = False
# expect: reactive scan -> alarm may if "min(scan.ranges) < 0.5"
import rclpy
from action_tutorials_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from rclpy.action import ActionClient
from rclpy.node import Node
from rclpy.qos import QoSProfile, qos_profile_sensor_data
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool, String


class Minder(Node):
    def __init__(self):
        super().__init__('minder')
        self.declare_parameter('topic', 'alarm')  # expect: param topic = alarm op=declare
        self.ready = False
        self.count = 0
        self.alarm = self.create_publisher(Bool, 'alarm', QoSProfile(depth=7))  # expect: publisher alarm std_msgs/Bool queue=7
        self.state = self.create_publisher(String, 'state', 10)  # expect: publisher state std_msgs/String queue=10
        # expect: subscriber scan sensor_msgs/LaserScan queue=5 callback=Minder::on_scan
        self.create_subscription(LaserScan, 'scan', self.on_scan, qos_profile=qos_profile_sensor_data)
        self.create_service(AddTwoInts, '~/add', self.add)  # expect: service_server ~add example_interfaces/AddTwoInts
        self.action = ActionClient(self, Fibonacci, 'fibonacci')  # expect: action_client fibonacci action_tutorials_interfaces/Fibonacci
        self.timer = self.create_timer(0.25, self.tick)

    def on_scan(self, scan):
        self.ready = True  # expect: transition Minder::ready = True on scan
        if min(scan.ranges) < 0.5:
            self.alarm.publish(Bool(data=True))

    def tick(self):
        if not self.ready:
            return
        self.count += 1  # expect: transition Minder::count if self.ready
        if self.count > 2:
            self.state.publish(String(data=str(self.count)))

    def add(self, request, response):
        response.sum = request.a + request.b
        return response


def main(args=None):
    rclpy.init(args=args)
    node = Minder()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    finally:
        node.destroy_node()


if __name__ == '__main__':
    main()
