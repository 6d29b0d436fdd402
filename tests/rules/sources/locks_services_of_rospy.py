#!/usr/bin/env python3
# rospy serves each request in a thread of its own: a callback may wait for a service of its own node.
#
# expect-not: call_blocks(_, _, _)
# expect: service_server /reset
# expect: service_client /reset
import rospy
from std_srvs.srv import Empty, EmptyResponse


def reset(_request):
    return EmptyResponse()


def check(_event):
    rospy.ServiceProxy("/reset", Empty)()


rospy.init_node("base")
rospy.Service("/reset", Empty, reset)
rospy.Timer(rospy.Duration(1), check)
rospy.spin()
