# What a state of smach returns decides which state does something next.
#
# expect: port_flow([_, _, "part"], [_, _, "grip"], "control", _)
# expect: port_flow([_, _, "part"], [_, _, "placed"], "control", _)
# expect-not: port_flow([_, _, "other"], _, _, _)
import rospy
import smach
from std_msgs.msg import Bool, Empty


class Wait(smach.State):
    def __init__(self):
        smach.State.__init__(self, outcomes=["seen", "stopped"])
        self.seen = self.other = False
        rospy.Subscriber("part", Bool, self.on_part)
        rospy.Subscriber("other", Bool, self.on_other)

    def on_part(self, msg):
        self.seen = msg.data

    def on_other(self, msg):
        self.other = msg.data

    def execute(self, userdata):
        while not rospy.is_shutdown():
            if self.seen:
                return "seen"
            rospy.sleep(0.1)
        return "stopped"


class Grip(smach.State):
    def __init__(self):
        smach.State.__init__(self, outcomes=["done"])
        self.pub = rospy.Publisher("grip", Empty, queue_size=1)

    def execute(self, userdata):
        self.pub.publish()
        return "done"


class Place(smach.State):
    def __init__(self):
        smach.State.__init__(self, outcomes=["done"])
        self.pub = rospy.Publisher("placed", Empty, queue_size=1)

    def execute(self, userdata):
        self.pub.publish()
        return "done"


rospy.init_node("picker")
machine = smach.StateMachine(outcomes=["end"])
with machine:
    smach.StateMachine.add("WAIT", Wait(), transitions={"seen": "GRIP", "stopped": "end"})
    smach.StateMachine.add("GRIP", Grip(), transitions={"done": "PLACE"})
    smach.StateMachine.add("PLACE", Place(), transitions={"done": "WAIT"})
machine.execute()
