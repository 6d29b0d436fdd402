# What is collected under a condition, and chosen of it, is decided by that.
#
# expect: port_flow([_, _, "left"], [_, _, "cmd"], "data", _)
# expect: port_flow([_, _, "left"], [_, _, "active"], "control", _)
# expect-not: port_flow([_, _, "other"], _, _, _)
from dataclasses import dataclass

import rospy
from std_msgs.msg import Int32, String


@dataclass
class Source:
    name: str
    priority: int
    last: Int32 = None


class Arbiter:
    def __init__(self):
        self.left = Source("left", 1)
        self.right = Source("right", 2)
        self.sources = [self.left, self.right]
        self.other = None
        self.cmd = rospy.Publisher("cmd", Int32, queue_size=1)
        self.active = rospy.Publisher("active", String, queue_size=1)
        rospy.Subscriber("left", Int32, self.on_left)
        rospy.Subscriber("other", Int32, self.on_other)
        rospy.Timer(rospy.Duration(1), self.tick)

    def on_left(self, msg):
        self.left.last = msg

    def on_other(self, msg):
        self.other = msg

    def tick(self, _):
        live = [source for source in self.sources if source.last is not None]
        if not live:
            return
        best = max(live, key=lambda source: source.priority)
        self.active.publish(best.name)
        self.cmd.publish(best.last)


rospy.init_node("arbiter")
Arbiter()
rospy.spin()
