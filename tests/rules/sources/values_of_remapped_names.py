# A name that is asked for with its remapping is the name itself: what remaps it is in the launch file.
#
# expect: service_client camera/set_camera_info
# expect-only: service_client
import rospy
from sensor_msgs.srv import SetCameraInfo

rospy.init_node("calibrator")
camera = rospy.remap_name("camera")
info = rospy.ServiceProxy(camera + "/set_camera_info", SetCameraInfo)
