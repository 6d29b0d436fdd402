# Callbacks of Python that wait for answers.
# expect-not: finding callback-deadlock "*/later,*"
# expect: 7 = count : { future_of(_, _) }, 1 = count : { value_leaves(_, _, _) }
import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger


class Asker(Node):
    def __init__(self):
        super().__init__('asker')
        self.any = ReentrantCallbackGroup()
        self.one = MutuallyExclusiveCallbackGroup()
        self.same = self.create_client(Trigger, 'same')
        self.later = self.create_client(Trigger, 'later')
        self.reentrant = self.create_client(Trigger, 'reentrant', callback_group=self.any)
        self.grouped = self.create_client(Trigger, 'grouped', callback_group=self.one)
        self.create_subscription(String, 'go', self.on_go, 10)
        self.create_timer(1.0, self.on_timer, callback_group=self.one)

    def on_go(self, text):
        self.same.call(Trigger.Request())  # expect: finding callback-deadlock "a callback of /script waits for the response of /same,*one callback group*"
        self.reentrant.call(Trigger.Request())  # expect: finding callback-deadlock "*/reentrant,*one thread*"
        self.spin_until(self.same.call_async(Trigger.Request()))

    def spin_until(self, future):
        rclpy.spin_until_future_complete(self, future)  # expect: finding callback-deadlock "*/same,*"

    def on_timer(self):
        self.grouped.call(Trigger.Request())  # expect: finding callback-deadlock "*/grouped,*"
        future = self.later.call_async(Trigger.Request())
        future.add_done_callback(self.on_answer)

    def on_answer(self, future):
        self.get_logger().info(future.result().message)


def main():
    rclpy.init()
    node = Asker()
    first = node.same.call_async(Trigger.Request())
    rclpy.spin_until_future_complete(node, first)  # expect-not: finding callback-deadlock
    rclpy.spin(node)


main()
