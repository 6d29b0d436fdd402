#!/usr/bin/env python3
# Members of modules that nothing defines; what may be there, what is set from outside, and what the program can do without. Calls of services with both kinds of arguments.
# expect: 3 = count : { member_absent(_, _, _) }, 2 = count : { mixed_arguments(_, _) }
import rospy
from pantry import everything, opened, services
from std_msgs.msg import Header

services.added = 1
rospy.init_node("stock")
services.fill(True)
services.fill(data=True)
services.fill(True, data=True)  # expect: finding mixed-arguments "/stock calls fill with positional and keyword arguments, which rospy rejects with a TypeError"
pub = rospy.Publisher("stock", Header, queue_size=1)
pub.publish(1, frame_id="x")  # expect: finding mixed-arguments "/stock calls publish with positional and keyword arguments, which rospy rejects with a TypeError"
pub.publish(*[1], frame_id="x")
services.late(True)
services.added += 1
services.shut(data=True)  # expect: finding module-member-absent "/stock uses shut of the module pantry.services, which defines no such name"
opened.fill(True)
everything.join("a", "b")
services.__name__
if hasattr(services, "old"):
    services.old(True)
try:
    services.newer(True)
except AttributeError:
    pass
try:
    services.other(True)  # expect: finding module-member-absent "/stock uses other of the module pantry.services, which defines no such name"
except rospy.ServiceException:
    pass
rospy.loginfo(services.limit)  # expect: finding module-member-absent "/stock uses limit of the module pantry.services, which defines no such name"
rospy.spin()
