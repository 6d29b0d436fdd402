"""Which source lines make a port: found in its text alone, by the names of the libraries' functions and classes and of what is declared of them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

NODE = "(?:Lifecycle)?Node"
ACTION_SERVER = "SimpleActionServer|ActionServer|BufferServer"
ACTION_CLIENT = "SimpleActionClient|ActionClient|BufferClient"

# the functions and classes that make ports of each kind
MAKERS = {
    "publisher": "create_publisher|advertise(?:Camera)?|RealtimePublisher|Player",
    "subscriber": "create_subscription|subscribe(?:Camera)?|Subscriber|SubscriberFilter|waitForMessage|Recorder",
    "service_server": "create_service|advertiseService",
    "service_client": "create_client|serviceClient|createClient|service::call",
    "action_server": ACTION_SERVER,
    "action_client": ACTION_CLIENT,
    "tf_broadcaster": "(?:Static)?TransformBroadcaster",
    "tf_listener": "TransformListener",
    "dynamic_reconfigure_server": "dynamic_reconfigure::Server",
}

# the classes that make ports inside themselves, by the ports' names
HIDDEN = {
    r"/rosout|/parameter_events|~(?:describe|get|list)_parameter\w*|~set_parameters_atomically|~(?:get|change)_\w*|~transition_event": NODE,
    r"/diagnostics": "Updater",
    r"/tf_static": "TransformListener",
    r"/clock|~pause_playback": "Player",
    r"~parameter_descriptions|~parameter_updates|~set_parameters": f"dynamic_reconfigure::Server|{NODE}",
    r"~list|~load_nodelet|~unload_nodelet": "nodelet::Loader",
    r"camera/set_camera_info": "CameraInfoManager",
    r"controller_manager/\w+": "ControllerManager",
    r"parts/(?:update|update_full|feedback)": "InteractiveMarkerServer",
    r".+/(?:goal|cancel|status|feedback|result)": f"{ACTION_SERVER}|{ACTION_CLIENT}",
}


def making_line(port: Mapping[str, Any], file: Path, headers: Iterable[Path]) -> re.Pattern[str]:
    """Matches the lines of `file` that name what makes `port`, or a variable or type that is declared, there or in `headers`, with that name."""
    names = _maker(port)
    declared = "\n".join(path.read_text() for path in (file, *headers))
    names = "|".join([names, *re.findall(rf"^\s*typedef\s[^;]*\b(?:{names})\b[^;]*\b(\w+);", declared, re.MULTILINE)])
    lists = re.findall(rf"^\s*[\w:<]*\b(?:{names})\b(?:<[^;()]*>)?[>*&\s]+(\w+(?:, \w+)*)[;({{]", declared, re.MULTILINE)
    names = "|".join([names, *(name for variables in lists for name in variables.split(", "))])
    return re.compile(rf"\b(?:{names})\b")


def _maker(port: Mapping[str, Any]) -> str:
    if not port.get("implicit"):
        return MAKERS[port["kind"]]
    return next(maker for names, maker in HIDDEN.items() if re.fullmatch(names, port["name"]))
