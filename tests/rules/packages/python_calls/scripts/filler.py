#!/usr/bin/env python3
# Messages whose fields are missed or filled with other things, calls and callbacks that do not fit.
import time

import rclpy
from geometry_msgs.msg import PoseArray, PoseStamped, Twist, Vector3
from python_calls.msg import Level
from rclpy.node import Node
from std_msgs.msg import Header, String
from std_srvs.srv import SetBool
from tf2_ros import Buffer


class Filler(Node):
    def __init__(self):
        super().__init__('filler')
        self.pub = self.create_publisher(Level, 'level')  # expect: finding call-refused "/filler calls create_publisher without qos_profile: it raises an exception"
        self.words = self.create_publisher(String, 'words', queue_size=1)  # expect: finding call-refused "*queue_size, which it does not know*"
        self.text = self.create_publisher(String, 'text', 10)
        self.sub = self.create_subscription(PoseStamped, 'pose', self.on_pose, 10)
        self.client = self.create_client(SetBool, 'go')
        self.server = self.create_service(SetBool, 'stop', self.on_stop)  # expect: finding callback-misfit "/filler passes a callback that takes 1 arguments, but is called with 2"
        self.timer = self.create_timer(0.1, self.tick)  # expect: finding callback-misfit "/filler passes a callback that takes 1 arguments, but is called with 0"
        self.other = self.create_subscription(String, 'other', lambda: None, 10)  # expect: finding callback-misfit "*takes 0 arguments*called with 1"
        self.buffer = Buffer()
        self.buffer.lookup_transform('map', 'base')  # expect: finding call-refused "*lookup_transform without time*"
        self.last = None
        self.last = Twist()

    def on_pose(self, msg):
        print(msg.header.stamp.secs)  # expect: finding field-absent "/filler uses secs of a builtin_interfaces/Time, which has no such field"
        print(msg.header.stamp.to_sec())  # expect: finding field-absent "*to_sec*"
        self.last.linear.up = msg.pose.position.x  # expect: finding field-absent "*up of a geometry_msgs/Vector3*"
        kept = msg
        print(kept.position)  # expect: finding field-absent "*position of a geometry_msgs/PoseStamped*"

    def on_stop(self, request):
        print(request.now)  # expect: finding field-absent "*now of a std_srvs/SetBoolRequest*"
        return SetBool.Response(successful=True)  # expect: finding field-absent "*successful*"

    def tick(self, event):
        level = Level(height=2)  # expect: finding field-misgiven "/filler sets python_calls/Level.height, which is float64, to a value that is int"
        level.past = 1.0  # expect: finding field-misgiven "*past, which is a list of float64, to a value that is float"
        level.name = 4 - 1  # expect: finding field-misgiven "*name, which is string, to a value that is int"
        level.full = 1  # expect: finding field-misgiven "*full, which is bool*"
        level.height = -1  # expect: finding field-misgiven "*height*int"
        level.header.stamp = self.get_clock().now()  # expect: finding field-misgiven "*stamp, which is builtin_interfaces/Time, to a value that is a Time of rclpy"
        header = Header()
        header.stamp = time.time()  # expect: finding field-misgiven "*stamp*float"
        half = 1 / 2
        level.name = half  # expect: finding field-misgiven "*name*float"
        level.header = String()  # expect: finding field-misgiven "*header, which is std_msgs/Header, to a value that is a message of std_msgs/String"
        level.height = 1,  # expect: finding field-misgiven "*height*list"
        poses = PoseArray()
        for pose in poses.poses:
            pose.place.x = 1.0  # expect: finding field-absent "*place*"
        poses.poses[0].place = 3  # expect: finding field-absent "*place*"
        self.text.publish('text')  # expect: finding sent-misfit "/filler sends std_msgs/String on /text, but is given str"
        self.text.publish(Twist())  # expect: finding sent-misfit "*a message of geometry_msgs/Twist"
        self.text.publish(String('text'))  # expect: finding message-misbuilt "/filler constructs a std_msgs/String from 1 positional values, but its class takes 0"
        self.client.call_async(SetBool.Response())  # expect: finding sent-misfit "*SetBoolRequest*SetBoolResponse"


def main():
    rclpy.init()
    rclpy.spin(Filler())


if __name__ == '__main__':
    main()
