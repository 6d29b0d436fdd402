# Handlers in a table: what the loop calls hangs on the state, and so does what that sends.
#
# expect: 3 = count : { entered_by_choice(C, _, Index, Key), expr_text(Index, "self.state"), expr_text(Key, _) }
# expect: state_variable(V), variable_name(V, "state")
# expect: port_flow([_, _, "begin"], [_, _, "cmd"], "control", _)
# expect: periodic cmd 10 Hz
# expect: transition machine::Machine::state = State.DONE trigger=periodic if "self.state == State.MOVING and self.steps == 5"
# expect-not: round_always(_, _)
from enum import Enum

import rospy
from std_msgs.msg import Empty, String


class State(Enum):
    IDLE = 0
    MOVING = 1
    DONE = 2


class Machine:
    def __init__(self):
        self.state = State.IDLE
        self.handlers = {State.IDLE: self.idle, State.MOVING: self.moving, State.DONE: self.done}
        self.cmd = rospy.Publisher("cmd", String, queue_size=1)
        self.end = rospy.Publisher("end", Empty, queue_size=1)
        self.steps = 0
        rospy.Subscriber("begin", Empty, self.begin)

    def begin(self, msg):
        if self.state == State.IDLE:
            self.state = State.MOVING
            self.steps = 0

    def idle(self):
        pass

    def moving(self):
        self.cmd.publish("step")
        self.steps += 1
        if self.steps == 5:
            self.state = State.DONE

    def done(self):
        self.end.publish(Empty())
        self.state = State.IDLE

    def run(self):
        rate = rospy.Rate(10)
        while not rospy.is_shutdown():
            self.handlers[self.state]()
            rate.sleep()


if __name__ == "__main__":
    rospy.init_node("machine")
    Machine().run()
