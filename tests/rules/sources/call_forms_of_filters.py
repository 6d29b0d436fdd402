# Callbacks of filters: called with a message of each input, and with what is registered beside them.
#
# expect: 2 = count : { callback_misfit(_, _, _, _) }
# expect: callback_misfit(_, _, "1", "2"); callback_misfit(_, _, "3", "2")
import message_filters
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import CameraInfo, Image


class Paint(Node):
    def __init__(self):
        super().__init__("paint")
        self.color = message_filters.Subscriber(self, Image, "color")
        self.depth = message_filters.Subscriber(self, Image, "depth")
        self.pair = message_filters.ApproximateTimeSynchronizer([self.color, self.depth], 10, 0.1)
        self.pair.registerCallback(self.on_one)
        self.equal = message_filters.TimeSynchronizer([self.color, self.depth], 10)
        self.equal.registerCallback(self.on_three)
        self.fit = message_filters.TimeSynchronizer([self.color, self.depth], 10)
        self.fit.registerCallback(self.on_two)
        self.named = message_filters.TimeSynchronizer([self.color, self.depth], 10)
        self.named.registerCallback(self.on_three, "stereo")
        self.listed = message_filters.TimeSynchronizer([self.color, *self.others()], 10)
        self.listed.registerCallback(self.on_three)
        self.color.registerCallback(self.on_one)

    def others(self):
        return [self.depth, message_filters.Subscriber(self, CameraInfo, "info")]

    def on_one(self, color):
        pass

    def on_two(self, color, depth):
        pass

    def on_three(self, color, depth, info):
        pass


rclpy.init()
rclpy.spin(Paint())
