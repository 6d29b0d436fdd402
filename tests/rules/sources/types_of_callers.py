# Which class belongs to which name is known by the call that gives both, however many functions pass them on.
import rclpy
from rclpy.node import Node
from std_srvs.srv import Empty, SetBool, Trigger

# expect: service_client manager/clear std_srvs/Empty
# expect: service_client manager/enable std_srvs/SetBool
# expect: service_client manager/save std_srvs/Trigger
# expect-not: service_client manager/save std_srvs/Empty


class Caller:
    known = None

    def __new__(cls, node, kind, name):
        if cls.known is None:
            cls.known = node.create_client(kind, name)
        return cls.known


def call(node, name, kind, request):
    client = Caller(node, kind, name)
    future = client.call_async(request)
    rclpy.spin_until_future_complete(node, future)
    return future.result()


def clear(node, manager):
    return call(node, f"{manager}/clear", Empty, Empty.Request())


def enable(node, manager):
    return call(node, f"{manager}/enable", SetBool, SetBool.Request())


def save(node, manager):
    return call(node, f"{manager}/save", Trigger, Trigger.Request())


def main():
    rclpy.init()
    node = Node("caller")
    clear(node, "manager")
    enable(node, "manager")
    save(node, "manager")


main()
