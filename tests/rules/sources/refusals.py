# Values of parameters that a node of Python refuses when it starts, by lists of texts and by comparisons.
#
# expect: refuses_other_text(_, "style", "hard")
# expect: refuses_other_text(_, "style", "soft")
# expect: refuses_other_text(_, "side", "left")
# expect: refuses_number(_, "joints", "length", "<", "2")
# expect: refuses_number(_, "limit", "value", "<", "0.5")
# expect: 3 = count : { refuses_other_text(_, _, _) }
# expect: 2 = count : { refuses_number(_, _, _, _, _) }
import rclpy
from rclpy.node import Node


class Mover(Node):
    def __init__(self):
        super().__init__("mover")
        style = self.declare_parameter("style", "soft").value
        if style not in ("hard", "soft"):
            raise ValueError("style")
        self.declare_parameter("side", "left")
        self.side = self.get_parameter("side").get_parameter_value().string_value
        if not self.side == "left":
            raise ValueError("side")
        self.joints = self.declare_parameter("joints", ["a", "b"]).value
        if len(self.joints) < 2:
            raise ValueError("joints")
        self.limit = self.declare_parameter("limit", 1.0).value
        if self.limit < 0.5:
            raise ValueError("limit")
        other = self.declare_parameter("other", 1).value
        if other in (1, 2):
            raise ValueError("other")


def main():
    rclpy.init()
    rclpy.spin(Mover())


if __name__ == "__main__":
    main()
