"""smach_ros (http://docs.ros.org/en/noetic/api/smach_ros/html/python/): states that use topics, services and actions."""

from typing import Any, Callable

from smach import Container, State

class MonitorState(State):
    def __init__(
        self, topic: str, msg_type: type, cond_cb: Callable, max_checks: int = ..., input_keys: list = ..., output_keys: list = ...,
    ) -> None: ...

class ConditionState(State):
    def __init__(self, cond_cb: Callable, input_keys: list = ..., poll_rate: Any = ..., timeout: Any = ..., max_checks: int = ...) -> None: ...

class ServiceState(State):
    def __init__(
        self, service_name: str, service_spec: type, request: Any = ..., request_cb: Callable = ..., request_cb_args: list = ...,
        request_cb_kwargs: dict = ..., request_key: str = ..., request_slots: list = ..., response_cb: Callable = ...,
        response_cb_args: list = ..., response_cb_kwargs: dict = ..., response_key: str = ..., response_slots: list = ..., input_keys: list = ...,
        output_keys: list = ..., outcomes: list = ...,
    ) -> None: ...

class SimpleActionState(State):
    def __init__(
        self, action_name: str, action_spec: type, goal: Any = ..., goal_key: str = ..., goal_slots: list = ..., goal_cb: Callable = ...,
        goal_cb_args: list = ..., goal_cb_kwargs: dict = ..., result_key: str = ..., result_slots: list = ..., result_cb: Callable = ...,
        result_cb_args: list = ..., result_cb_kwargs: dict = ..., input_keys: list = ..., output_keys: list = ..., outcomes: list = ...,
        exec_timeout: Any = ..., preempt_timeout: Any = ..., server_wait_timeout: Any = ...,
    ) -> None: ...

class ActionServerWrapper:
    def __init__(
        self, server_name: str, action_spec: type, wrapped_container: Container, succeeded_outcomes: list = ..., aborted_outcomes: list = ...,
        preempted_outcomes: list = ..., goal_key: str = ..., feedback_key: str = ..., result_key: str = ..., goal_slots_map: dict = ...,
        feedback_slots_map: dict = ..., result_slots_map: dict = ..., expand_goal_slots: bool = ..., pack_result_slots: bool = ...,
    ) -> None: ...
    def run_server(self) -> None: ...

class IntrospectionServer:
    def __init__(self, server_name: str, state: State, path: str) -> None: ...
    def start(self) -> None: ...
    def stop(self) -> None: ...

def set_preempt_handler(sc: Container) -> None: ...
