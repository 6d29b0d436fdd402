# Programs of rospy that are started twice, and timers without a duration.
#
# expect: 1 = count : { misused(_, "started twice", "rospy::init_node") }
# expect: call_refused(_, "Timer", "with a number where it takes a rospy.Duration")
# expect: 2 = count : { call_refused(_, _, _) }
# expect: 1 = count : { misused(_, "goal too early", _) }
import actionlib
import rospy
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from std_msgs.msg import Bool


class Gripper:
    def __init__(self):
        rospy.init_node("gripper")
        self.pub = rospy.Publisher("close", Bool, queue_size=1)


class Wrist:
    def __init__(self):
        rospy.init_node("arm")
        self.pub = rospy.Publisher("turn", Bool, queue_size=1)


class Arm:
    def __init__(self):
        rospy.init_node("arm")
        self.gripper = Gripper()
        self.wrist = Wrist()
        self.first = rospy.Timer(0.1, self.tick)
        self.second = rospy.Timer(2, self.tick)
        self.third = rospy.Timer(rospy.Duration(1), self.tick)

    def tick(self, event):
        pass


Arm()
client = actionlib.SimpleActionClient("move_base", MoveBaseAction)
client.send_goal(MoveBaseGoal())
rospy.sleep(1)
client.send_goal(MoveBaseGoal())
rospy.spin()
