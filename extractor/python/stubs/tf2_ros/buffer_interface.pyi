from tf2_ros import *
