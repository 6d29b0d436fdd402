# setattr changes fields of the object that it is given: of another object than the node, none of the node's.
#
# expect: assignment(E, V, "call"), location(E, _, 31, _), variable_name(V, "report_")
# expect: 1 = count : { assignment(E, _, _), location(E, _, 31, _) }
# expect: assignment(E, V, "call"), location(E, _, 33, _), variable_name(V, "ready_")
# expect: assignment(E, V, "call"), location(E, _, 33, _), variable_name(V, "report_")
import rospy
from std_msgs.msg import Bool, String


class Report:
    def __init__(self):
        self.state = "idle"


class Teller:
    def __init__(self):
        self.ready_ = False
        self.report_ = Report()
        self.pub = rospy.Publisher("report", String, queue_size=1)
        rospy.Subscriber("field", String, self.on_field)
        rospy.Subscriber("ready", Bool, self.on_ready)

    def on_ready(self, msg):
        self.ready_ = msg.data
        if self.ready_ and self.report_.state:
            self.pub.publish(self.report_.state)

    def on_field(self, msg):
        name = msg.data
        setattr(self.report_, name, "new")
        if self.ready_:
            setattr(self, name, True)


rospy.init_node("teller")
Teller()
rospy.spin()
