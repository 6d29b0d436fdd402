"""ROS 2 launch files in XML, YAML and Python: what `ros2 launch` would start and set, without running anything.

All three come to the same actions (`values.Made`), which `actions` carries out as launch does: in their order, with configurations,
namespaces, remappings and parameters that a group keeps to itself. A `launch.py` is interpreted over its syntax tree (`interpreter`); what
cannot be known stays symbolic, and conditions on it give both alternatives.

Sources: the behaviour of launch 3.x and launch_ros 0.26 (docs.ros.org/en/rolling/p/launch, .../p/launch_ros), rcl's parameter files.
"""
