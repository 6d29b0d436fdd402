# Values that a callback of parameters refuses before they are declared.
#
# expect: refuses_number(_, "gain", "value", ">", "10.0")
# expect: refuses_number(_, "low", "value", "<", "0")
# expect: refuses_number(_, "low", "value", ">", "5")
# expect: refuses_number(_, "kept", "value", "<", "1")
# expect: 4 = count : { refuses_number(_, _, _, _, _) }
import rclpy
from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node


class Amp(Node):
    def __init__(self):
        super().__init__("amp")
        self.declare_parameter("early", 1.0)
        self.add_on_set_parameters_callback(self.check)
        self.declare_parameter("gain", 1.0)
        self.declare_parameter("low", 1)
        self.declare_parameter("mode", 1)
        self.declare_parameter("kept", 1)

    def check(self, parameters):
        for p in parameters:
            if p.name == "gain" and p.value > 10.0:
                return SetParametersResult(successful=False, reason="too loud")
            if p.name == "low":
                self.low = p.value
                if p.value < 0 or p.value > 5:
                    return SetParametersResult(successful=False)
            if p.name == "early" and p.value > 10.0:
                return SetParametersResult(successful=False)
            if p.name == "mode" and p.value > 10 and self.strict:
                return SetParametersResult(successful=False)
            if p.name == "kept":
                kept = p.value
                if not p.value >= 1 and self.strict:
                    return SetParametersResult(successful=False)
                if kept < 1:
                    return SetParametersResult(successful=False)
        return SetParametersResult(successful=True)


def main():
    rclpy.init()
    rclpy.spin(Amp())


main()
