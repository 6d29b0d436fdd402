# Proxies that are made by a function; one is only named as global.
# expect: service_client fill
import rospy
from std_srvs.srv import SetBool

fill = None


def setup():
    global fill, shut, late
    fill = rospy.ServiceProxy("fill", SetBool)
    late = rospy.ServiceProxy("late", SetBool)


setup()
