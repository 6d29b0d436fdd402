# Callbacks of parameters that refuse a value at times only.
#
# expect: 0 = count : { refuses_number(_, _, _, _, _) }
import rclpy
from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node


class Amp(Node):
    def __init__(self):
        super().__init__("amp")
        self.running = False
        self.add_on_set_parameters_callback(self.check_later)
        self.add_on_set_parameters_callback(self.check_twice)
        self.declare_parameter("gain", 1.0)
        self.declare_parameter("low", 1)
        self.running = True

    def check_later(self, parameters):
        if not self.running:
            return SetParametersResult(successful=True)
        for p in parameters:
            if p.name == "gain" and p.value > 10.0:
                return SetParametersResult(successful=False)
        return SetParametersResult(successful=True)

    def check_twice(self, parameters):
        result = SetParametersResult(successful=True)
        for p in parameters:
            if p.name == "low" and p.value < 0:
                result.successful = False
        if not self.running:
            result.successful = True
        return result


def main():
    rclpy.init()
    rclpy.spin(Amp())


main()
