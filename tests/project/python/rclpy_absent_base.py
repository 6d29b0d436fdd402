# A node whose base class is not there, and objects of which nothing is known but what is called on them.
#
# expect: 0 = count : { node_name(_) }
# expect-not: service_client
import boto3
import rclpy
from robot_base.node import RobotNode
from std_msgs.msg import String
from std_srvs.srv import Trigger


class Base(RobotNode):
    def __init__(self, context):
        super().__init__('settings.yaml')
        self.speed = self.declare_parameter('speed', 1.0).value  # expect: param speed = 1.0 op=declare
        self.pub = self.create_publisher(String, 'said', 10)  # expect: publisher said std_msgs/String queue=10
        self.node = context.node
        self.node.create_service(Trigger, 'stop', self.on_stop)  # expect: service_server stop std_srvs/Trigger callback=Base::on_stop
        self.store = boto3.session().create_client('s3', 'us-east-1')

    def on_stop(self, request, response):
        self.pub.publish(String())
        return response


def main():
    rclpy.init()
    rclpy.spin(Base(unknown()))


main()
