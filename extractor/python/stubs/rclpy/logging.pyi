from typing import Any

from rclpy.impl.rcutils_logger import RcutilsLogger

def get_logger(name: str) -> RcutilsLogger: ...
