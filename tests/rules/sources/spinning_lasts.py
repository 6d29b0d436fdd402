"""Programs of rospy that go on: in a window that is not seen."""

# expect: 0 = count : { runs_too_little(_, _) }
# expect: subscriber level
from tkinter import Tk

import rospy
from std_msgs.msg import Int32

rospy.init_node("level")
rospy.Subscriber("level", Int32, print)
window = Tk()
window.mainloop()
