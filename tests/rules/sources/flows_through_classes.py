# What belongs to the class of an object is found in the object.
#
# expect: port_flow([_, _, "off"], [_, _, "out"], "control", _)
# expect: port_flow([_, _, "fast"], [_, _, "out"], "data", _)
import rospy
from std_msgs.msg import Bool, Int32


class Robot:
    enabled = True
    speed = 1

    def __init__(self):
        self.out = rospy.Publisher("out", Int32, queue_size=1)
        rospy.Subscriber("off", Bool, self.on_off)
        rospy.Subscriber("fast", Int32, self.on_fast)
        rospy.Timer(rospy.Duration(1), self.tick)

    def on_off(self, msg):
        type(self).enabled = not msg.data

    def on_fast(self, msg):
        self.__class__.speed = msg.data

    def tick(self, _):
        if self.enabled:
            self.out.publish(self.speed)


rospy.init_node("robot")
Robot()
rospy.spin()
