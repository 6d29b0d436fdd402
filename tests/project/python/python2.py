#!/usr/bin/env python
# Python 2, with tabs.
#
# expect: component python2 node_name=old
# expect: reactive in -> out may
import rospy
from std_msgs.msg import String


def callback(message):
	try:
		print 'got', message.data
		pub.publish(message)
	except rospy.ROSException, error:
		print >>sys.stderr, error
	if {}.has_key(1) and 1 <> 2:
		exec 'pass'


try:
	device = rospy.get_param('~device')  # expect: param ~device = auto
except KeyError:
	device = 'auto'
rospy.init_node('old')
pub = rospy.Publisher('out', String)  # expect: publisher out
rospy.Subscriber('in', String, callback)  # expect: subscriber in
rospy.spin()
