# Ports that are made in other ways than by a call in a node's constructor.
import contextlib

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger

# An action is made of services and topics of ROS 2.
# expect: service_server wind_up/_action/send_goal example_interfaces/Fibonacci_SendGoal implicit
# expect: publisher wind_up/_action/status action_msgs/GoalStatusArray implicit
# expect-not: publisher wind_up/status
# expect: service_server ~describe_parameters implicit


class ClientOf:
    clients = {}

    def __new__(cls, node, name):
        if name not in cls.clients:
            cls.clients[name] = node.create_client(Trigger, name)  # expect: service_client cook std_srvs/Trigger
        return cls.clients[name]


class Hall:
    only = None

    def __new__(cls, *arguments):
        if cls.only is None:
            cls.only = super().__new__(cls)
        return cls.only

    def __init__(self, node):
        self.bell = node.create_publisher(String, 'bell', 1)  # expect: publisher bell std_msgs/String


class Task:
    topic = None
    kind = String

    def __init__(self, node):
        self.out = node.create_publisher(self.kind, self.topic, 1)  # expect: publisher sweep std_msgs/String


class Sweep(Task):
    topic = 'sweep'


class Session:
    def __enter__(self):
        return Node('indirect')

    def __exit__(self, *reason):
        rclpy.shutdown()


@contextlib.contextmanager
def light(node):
    yield node.create_publisher(String, 'light', 1)  # expect: publisher light std_msgs/String


def main():
    rclpy.init()
    with Session() as node:
        server = ActionServer(node, Fibonacci, 'wind_up', lambda goal: None)  # expect: action_server wind_up example_interfaces/Fibonacci
        ClientOf(node, 'cook').call_async(Trigger.Request())
        Hall(node).bell.publish(String())
        tasks = [task(node) for task in Task.__subclasses__()]
        getattr(node, 'create_subscription')(String, 'light', print, 1)  # expect: subscriber light std_msgs/String
        with light(node) as publisher:
            publisher.publish(String())
        rclpy.spin(node)


main()
