# Publishers of a managed node in Python: those of its base class only send while the node is active.
# expect-not: writable(_)
import rclpy
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from std_msgs.msg import String


class Managed(LifecycleNode):
    def __init__(self):
        super().__init__('managed')
        self.plain = self.create_publisher(String, 'plain', 1)

    def on_configure(self, state):
        self.managed = self.create_lifecycle_publisher(String, 'managed', 1)
        self.plain.publish(String())  # expect-not: finding publisher-inactive
        self.managed.publish(String())  # expect: finding publisher-inactive "*/managed_script publishes /managed before*"
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state):
        self.managed.publish(String())  # expect-not: finding publisher-inactive
        return super().on_activate(state)


def main():
    rclpy.init()
    rclpy.spin(Managed())


main()
