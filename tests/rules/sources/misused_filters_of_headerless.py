# Synchronisers of messages that have no header.
#
# expect: headerless_dropped(_, "std_msgs/Float32")
# expect: headerless_dropped(_, "std_msgs/Bool")
# expect: 2 = count : { headerless_dropped(_, _) }
import message_filters
import rospy
from sensor_msgs.msg import Range
from std_msgs.msg import Bool, Float32


def fuse(*messages):
    rospy.loginfo(len(messages))


rospy.init_node("fuse")
ground = message_filters.Subscriber("range", Range)
heat = message_filters.Subscriber("heat", Float32)
lamp = message_filters.Subscriber("lamp", Bool)
dropping = message_filters.ApproximateTimeSynchronizer([ground, heat], 10, 0.1)
dropping.registerCallback(fuse)
exact = message_filters.TimeSynchronizer([ground, lamp], 10)
exact.registerCallback(fuse)
taking = message_filters.ApproximateTimeSynchronizer([ground, heat], 10, 0.1, allow_headerless=True)
taking.registerCallback(fuse)
other = message_filters.ApproximateTimeSynchronizer([heat, lamp], 10, 0.1, True)
other.registerCallback(fuse)
arriving = message_filters.ApproximateTimeSynchronizer([heat, lamp], 10, 0.1, sync_arrival_time=True)
arriving.registerCallback(fuse)
at_once = message_filters.TimeSynchronizer([heat, lamp], 10, sync_arrival_time=True)
at_once.registerCallback(fuse)
rospy.spin()
