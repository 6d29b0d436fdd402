#!/usr/bin/env python
# A client of a reconfigurable node, in Python.
#
# expect: subscriber /planner/parameter_updates dynamic_reconfigure/Config implicit
# expect: service_client /planner/set_parameters dynamic_reconfigure/Reconfigure implicit
import dynamic_reconfigure.client
import rospy


def on_config(config):
    rospy.loginfo(config)


rospy.init_node("tuner")
client = dynamic_reconfigure.client.Client("/planner", timeout=30, config_callback=on_config)
client.update_configuration({"speed": 1.0})
rospy.spin()
