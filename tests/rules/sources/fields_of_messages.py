# A field that the message does not have is asked for; a method that is called by its class is none of the message that it gets.
#
# expect: 1 = count : { field_absent(_, _, _) }
# expect: field_absent(_, "geometry_msgs/Point", "w")
import rospy
from geometry_msgs.msg import Point


class Track:
    def unpack(point: Point):
        return Track(), point.x


class Node:
    def __init__(self):
        self.sub = rospy.Subscriber("in", Point, self.on_in)

    def on_in(self, message):
        self.track, self.x = Track.unpack(message)
        self.w = message.w


if __name__ == "__main__":
    rospy.init_node("node")
    node = Node()
    rospy.spin()
