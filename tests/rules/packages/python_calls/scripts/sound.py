#!/usr/bin/env python3
# The same, as it is meant, and what nobody can know.
# expect-not: finding field-absent "/sound*"
# expect-not: finding field-misgiven "/sound*"
# expect-not: finding call-refused "/sound*"
# expect-not: finding callback-misfit "/sound*"
# expect-not: finding sent-misfit "/sound*"
# expect-not: finding message-misbuilt "/sound*"
import rclpy
from absent_package import decorated, something
from geometry_msgs.msg import PoseStamped, Twist, Vector3
from python_calls.msg import Level
from rclpy.node import Node
from rclpy.timer import TimerInfo
from std_msgs.msg import String
from std_srvs.srv import SetBool


class Sound(Node):
    def __init__(self):
        super().__init__('sound')
        self.pub = self.create_publisher(Level, 'level', qos_profile=1)
        self.text = self.create_publisher(String, 'text', 10)
        self.sub = self.create_subscription(PoseStamped, 'pose', self.on_pose, 10)
        self.told = self.create_subscription(PoseStamped, 'pose', self.on_pose_with, 10)
        self.raw = self.create_subscription(PoseStamped, 'pose', self.on_raw, 10, raw=True)
        self.server = self.create_service(SetBool, 'stop', self.on_stop)
        self.timer = self.create_timer(0.1, self.tick)
        self.slow = self.create_timer(1.0, self.tock)
        self.odd = self.create_timer(1.0, self.wrapped)
        self.last = something()
        self.last = Twist()
        self.options = self.create_subscription(*something())

    def on_pose(self, msg):
        print(msg.header.stamp.sec, msg.get_fields_and_field_types(), msg.__class__)
        if hasattr(msg, 'orientation'):
            print(msg.orientation)
        msg = msg.pose
        print(msg.position)
        self.helper(msg)

    def on_pose_with(self, msg, info):
        self.last.anything = 1
        try:
            print(msg.position)
        except AttributeError:
            pass

    def on_raw(self, data):
        print(data.anything)

    def helper(self, part):
        print(part.anything)

    def on_stop(self, request, response):
        response.success = request.data
        response.message = str(1)
        return response

    def tick(self, *args):
        level = Level(height=2.0, name='x', check_fields=True)
        level.past = [1.0]
        level.height = float(1)
        level.height = something()
        level.header.stamp = self.get_clock().now().to_msg()
        level.full = level.height > Level.LOW
        total = 0
        total += something()
        level.height = total
        self.text.publish(String(data='text'))
        self.text.publish(something())
        Twist(linear=Vector3(x=1.0))

    def tock(self, info: TimerInfo):
        pass

    @decorated
    def wrapped(self, one, two):
        pass


def main():
    rclpy.init()
    rclpy.spin(Sound())


if __name__ == '__main__':
    main()
