#!/usr/bin/env python3
# Messages, calls and callbacks of rospy that do not fit, and others that do.
import time

import rospy
from geometry_msgs.msg import Point, PoseStamped, Twist
from std_msgs.msg import Float64, Header, String
from std_srvs.srv import SetBool, SetBoolRequest, SetBoolResponse
from visualization_msgs.msg import Marker


def on_pose(msg):
    print(msg.header.seq, msg.header.stamp.to_sec(), msg.header.stamp.secs)
    print(msg.header.stamp.sec)  # expect: finding field-absent "/filler uses sec of a time, which has no such field"


def on_text(msg, extra):
    pass


def on_go(request, response):
    return SetBoolResponse(True, '')


def tick():
    pass


rospy.init_node('filler')
text = rospy.Publisher('text', String, queue_size=1)
twist = rospy.Publisher('twist', Twist, queue_size=1)
number = rospy.Publisher('number', Float64, queue_size=1)
bare = rospy.Publisher('bare', queue_size=1)  # expect: finding call-refused "*Publisher without data_class*"
rospy.Subscriber('pose', PoseStamped, on_pose)
rospy.Subscriber('text', String, on_text, 1)
rospy.Subscriber('words', String, on_text)  # expect: finding callback-misfit "*takes 2 arguments*called with 1"
rospy.Service('go', SetBool, on_go)  # expect: finding callback-misfit "*takes 2 arguments*called with 1"
rospy.Timer(rospy.Duration(1), tick)  # expect: finding callback-misfit "*takes 0 arguments*called with 1"
go = rospy.ServiceProxy('other', SetBool)
text.publish('text')
text.publish(4)  # expect: finding sent-misfit "*is given int"
number.publish(4)
number.publish('4')  # expect: finding sent-misfit "*is given str"
twist.publish(1.0)  # expect: finding sent-misfit "/filler sends geometry_msgs/Twist on /twist, but is given float"
twist.publish(1, 2, 3)  # expect: finding sent-misfit "*is given 3 values"
twist.publish(Twist())
print(go(True).success)
print(go(True).done)  # expect: finding field-absent "*done of a std_srvs/SetBoolResponse*"
go(SetBoolRequest(True))
go(True, False)  # expect: finding sent-misfit "*2 values"
header = Header()
header.stamp = rospy.Time.now()
header.stamp = time.time()  # expect: finding field-misgiven "*stamp, which is time, to a value that is float"
point = Point(1, 2, 3)
point = Point(1, 2)  # expect: finding message-misbuilt "*from 2 positional values, but its class takes 3"
point.x = 1
point.x = Point  # expect: finding field-misgiven "*x, which is float64, to a value that is the class geometry_msgs/Point"
point.x = '1'  # expect: finding field-misgiven "*x, which is float64, to a value that is str"
marker = Marker()
marker.action = Marker.ADD  # expect-not: finding field-misgiven "/filler sets visualization_msgs/Marker.action*"
first = rospy.wait_for_message('pose', PoseStamped)
print(first.position)  # expect: finding field-absent "*position of a geometry_msgs/PoseStamped*"
rospy.spin()
