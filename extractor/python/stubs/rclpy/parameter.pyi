from enum import Enum
from typing import Any

class Parameter:
    class Type(Enum):
        NOT_SET = 0
        BOOL = 1
        INTEGER = 2
        DOUBLE = 3
        STRING = 4
        BYTE_ARRAY = 5
        BOOL_ARRAY = 6
        INTEGER_ARRAY = 7
        DOUBLE_ARRAY = 8
        STRING_ARRAY = 9

    def __init__(self, name: str, type_: Any = ..., value: Any = ...) -> None: ...
    name: str
    type_: Any
    value: Any
    def get_parameter_value(self) -> ParameterValue: ...
    def to_parameter_msg(self) -> Any: ...

class ParameterValue:
    bool_value: bool
    integer_value: int
    double_value: float
    string_value: str
    byte_array_value: list
    bool_array_value: list
    integer_array_value: list
    double_array_value: list
    string_array_value: list
