from typing import Any

class Parameter:
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
