# expect: keeps_value_of("quiet", "~quiet")
# expect: N = count : { keeps_value_of(_, _) }, N = 1
import rospy
from std_msgs.msg import Empty


def main():
    rospy.init_node("logger")
    quiet = rospy.get_param("~quiet", False)
    line = rospy.Publisher("line", Empty, queue_size=1)
    rate = rospy.Rate(5)
    while not rospy.is_shutdown():
        if not quiet:
            line.publish(Empty())
        rate.sleep()


if __name__ == "__main__":
    main()
