from actionlib import *
