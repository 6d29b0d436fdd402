# A function that is taken by its name from all that the function around it declares.
#
# expect-only: publisher
import rospy
from std_msgs.msg import Float32


class Driver:
    def step(self, data):
        def fill_temperature(value):
            self.warm = rospy.Publisher("warm", Float32, queue_size=1)  # expect: publisher warm

        def fill_pressure(value):
            def fill(value):
                self.dense = rospy.Publisher("dense", Float32, queue_size=1)  # expect: publisher dense

            locals()[value](value)

        for name, value in data.items():
            locals()["fill_" + name](value)

    def other(self):
        def fill_cold(value):
            self.cold = rospy.Publisher("cold", Float32, queue_size=1)


if __name__ == "__main__":
    rospy.init_node("driver")
    driver = Driver()
    driver.step(rospy.get_param("~data"))
    driver.other()
