"""ROS interfaces of a workspace and the common ones: definitions, C++ headers, C++ class names.

`load_messages` makes the store; `header_text` and `header_index` give headers on demand, `generate_headers` writes them to a folder.
"""

from rosarch.extractor.messages.classes import MessageClass, message_classes
from rosarch.extractor.messages.headers import generate_headers, header_index, header_text
from rosarch.extractor.messages.interfaces import Interfaces
from rosarch.extractor.messages.model import (
    Action,
    Config,
    ConfigConstant,
    ConfigParameter,
    Constant,
    Field,
    Message,
    MessageStore,
    Service,
)
from rosarch.extractor.messages.store import load_messages

__all__ = [
    "Action",
    "Config",
    "ConfigConstant",
    "ConfigParameter",
    "Constant",
    "Field",
    "Interfaces",
    "Message",
    "MessageClass",
    "MessageStore",
    "Service",
    "generate_headers",
    "header_index",
    "header_text",
    "load_messages",
    "message_classes",
]
