#!/usr/bin/env python3
# A module whose name is made up at run time may do anything with the node; one that has messages does nothing.
#
# expect: open_at("ports", _, ["import", "import_module"])
# expect: open_at("params", _, ["import", "__import__"])
# expect: Count = count : { open_at("params", C, ["import", Name]) }, Count = 2
import importlib
from importlib import import_module

import rospy


class Server:
    def __init__(self, package):
        name = rospy.get_param("~handlers")
        importlib.import_module(name)
        __import__(name, fromlist=[""])
        import_module("os.path")
        import_module(package + ".msg")
        import_module(f"{package}.srv")


rospy.init_node("server")
server = Server(rospy.get_param("~package"))
rospy.spin()
