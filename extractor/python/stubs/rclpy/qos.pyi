from enum import Enum
from typing import Any

class QoSProfile:
    def __init__(
        self, *, history: Any = ..., depth: int = ..., reliability: Any = ..., durability: Any = ..., lifespan: Any = ..., deadline: Any = ..., liveliness: Any = ...,
        liveliness_lease_duration: Any = ..., avoid_ros_namespace_conventions: bool = ...,
    ) -> None: ...
    history: Any
    depth: int
    reliability: Any
    durability: Any
    lifespan: Any
    deadline: Any
    liveliness: Any
    liveliness_lease_duration: Any

class HistoryPolicy(Enum):
    SYSTEM_DEFAULT = 0
    KEEP_LAST = 1
    KEEP_ALL = 2
    UNKNOWN = 3

class ReliabilityPolicy(Enum):
    SYSTEM_DEFAULT = 0
    RELIABLE = 1
    BEST_EFFORT = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4

class DurabilityPolicy(Enum):
    SYSTEM_DEFAULT = 0
    TRANSIENT_LOCAL = 1
    VOLATILE = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4

class LivelinessPolicy(Enum):
    SYSTEM_DEFAULT = 0
    AUTOMATIC = 1
    MANUAL_BY_TOPIC = 3
    UNKNOWN = 4
    BEST_AVAILABLE = 5

QoSHistoryPolicy = HistoryPolicy
QoSReliabilityPolicy = ReliabilityPolicy
QoSDurabilityPolicy = DurabilityPolicy
QoSLivelinessPolicy = LivelinessPolicy
qos_profile_unknown: QoSProfile
qos_profile_default: QoSProfile
qos_profile_system_default: QoSProfile
qos_profile_sensor_data: QoSProfile
qos_profile_services_default: QoSProfile
qos_profile_parameters: QoSProfile
qos_profile_parameter_events: QoSProfile
qos_profile_best_available: QoSProfile
qos_profile_action_status_default: QoSProfile
