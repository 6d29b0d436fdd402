# States of smach_ros listen, ask and send goals; a state of the program's own runs when its machine is executed.
#
# expect: subscriber battery std_msgs/Float32
# expect: service_client recharge std_srvs/Empty
# expect: action_client move_base move_base_msgs/MoveBaseAction
# expect: publisher move_base/goal move_base_msgs/MoveBaseActionGoal implicit
# expect: publisher patrol/smach/container_status smach_msgs/SmachContainerStatus implicit
# expect: publisher done std_msgs/Empty
# expect: 0 = count : { unseen(_, _, _, _, _, _) }
# expect: sent_by_itself([_, "publisher", "done"])
# expect: 0 = count : { sends_nothing([_, "action_client", _]) }
import rospy
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from smach import State, StateMachine
from smach_ros import IntrospectionServer, MonitorState, ServiceState, SimpleActionState
from std_msgs.msg import Empty, Float32
from std_srvs.srv import Empty as EmptySrv


class Tell(State):
    def __init__(self):
        State.__init__(self, outcomes=["succeeded"])
        self.pub = rospy.Publisher("done", Empty, queue_size=1)

    def execute(self, userdata):
        self.pub.publish(Empty())
        return "succeeded"


def low(userdata, message):
    return message.data < 20


def arrived(userdata, status, result):
    rospy.loginfo("arrived")


def main():
    rospy.init_node("patrol")
    machine = StateMachine(outcomes=[])
    with machine:
        StateMachine.add("WATCH", MonitorState("battery", Float32, low), transitions={"invalid": "CHARGE"})
        StateMachine.add("CHARGE", ServiceState("recharge", EmptySrv), transitions={"succeeded": "GO"})
        StateMachine.add(
            "GO", SimpleActionState("move_base", MoveBaseAction, goal=MoveBaseGoal(), result_cb=arrived), transitions={"succeeded": "TELL"}
        )
        StateMachine.add("TELL", Tell(), transitions={"succeeded": "WATCH"})
    server = IntrospectionServer("patrol", machine, "/ROOT")
    server.start()
    machine.execute()
    server.stop()


if __name__ == "__main__":
    main()
