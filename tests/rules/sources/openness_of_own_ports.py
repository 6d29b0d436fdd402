# Code that was not read makes ports in the node of the program: a library known to, and base classes of modules of nobody's.
#
# expect: M = count : { unseen("ports", "makes", _, _, _, _) }, M = 1
# expect: unseen("ports", "makes", "moveit_commander::MoveGroupCommander", _, 33, _)
# expect: M = count : { unseen("ports", "base", _, _, _, _) }, M = 1
# expect: unseen("ports", "base", "eyes::Eye", _, 34, _)
import threading

import moveit_commander
import numpy as np
import rospy
from eyes import Eye
from PyQt5.QtWidgets import QWidget


class Watcher(Eye):
    def process(self, image):
        return np.array(image)


class Window(QWidget):
    pass


class Worker(threading.Thread):
    pass


class Unused(Eye):
    pass


arm = moveit_commander.MoveGroupCommander("arm")
watcher = Watcher()
window = Window()
worker = Worker()
rospy.spin()
