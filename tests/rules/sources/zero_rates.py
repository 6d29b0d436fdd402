# Timers and rates of parameters that may not be zero.
#
# expect: refuses_number(_, "hz", "value", "==", "0")
# expect: refuses_number(_, "rate", "value", "<=", "0")
# expect: period_of_parameter(_, "period")
# expect: 2 = count : { refuses_number(_, _, _, _, _) }
# expect: 1 = count : { period_of_parameter(_, _) }
import rclpy
from rclpy.node import Node


class Pump(Node):
    def __init__(self):
        super().__init__("pump")
        hz = self.declare_parameter("hz", 10.0).value
        self.timer = self.create_timer(1.0 / hz, self.tick)
        self.declare_parameter("rate", 5.0)
        self.rate = self.create_rate(self.get_parameter("rate").value)
        self.period = self.declare_parameter("period", 0.5).value
        self.slow = self.create_timer(self.period, self.tick)
        # where it is zero, there is no timer
        often = self.declare_parameter("often", 1.0).value
        if often > 0:
            self.often = self.create_timer(1.0 / often, self.tick)
        # something else is taken then
        seldom = self.declare_parameter("seldom", 1.0).value
        if seldom <= 0:
            seldom = 1.0
        self.seldom = self.create_timer(1.0 / seldom, self.tick)
        capped = self.declare_parameter("capped", 1.0).value
        self.capped = self.create_timer(1.0 / max(capped, 0.1), self.tick)
        tried = self.declare_parameter("tried", 1.0).value
        try:
            self.tried = self.create_timer(1.0 / tried, self.tick)
        except ZeroDivisionError:
            self.tried = None

    def tick(self):
        pass


def main():
    rclpy.init()
    rclpy.spin(Pump())


main()
