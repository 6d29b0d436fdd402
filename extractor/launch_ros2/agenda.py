"""What follows a launch description: timers fire, processes start and end, and what waits for that is carried out.

Launch visits a description, with all that it includes, before the first event: what an event starts sees configurations, namespaces,
remappings and parameters as they are then, not those of the group that registered it. How long processes run is not known: they are taken
to end well, after `LIFETIME`, which orders what waits for it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from heapq import heappop, heappush
from typing import TYPE_CHECKING, Any

from rosarch.extractor.launch.model import Condition
from rosarch.extractor.launch_ros2.context import Context, Moment
from rosarch.extractor.launch_ros2.values import Bound, Function, Instance, Made, Unknown, cases, is_derived

if TYPE_CHECKING:
    from rosarch.extractor.launch_ros2.world import World

LIFETIME = 15.0
START, EXIT, COMPLETION = "OnProcessStart", "OnProcessExit", "OnExecutionComplete"
_EVENTS = (START, EXIT, COMPLETION)


@dataclass(frozen=True, eq=False)
class _Handler:
    made: Made
    moment: Moment
    handle: Callable[[], None]


class Agenda:
    """The events to come, in the order of their time, and the handlers that wait for them."""

    def __init__(self, world: World) -> None:
        self.world, self.now = world, 0.0
        self._queue: list[tuple[float, int, Callable[[], None]]] = []
        self._handlers: list[_Handler] = []
        self._number = 0
        self._handled: set[tuple[int, int]] = set()
        self.known: list[Made] = []
        """The handlers that are registered, whatever they wait for."""

    def put(self, seconds: float, happens: Callable[[], None]) -> None:
        """Let something happen in some seconds."""
        self._number += 1
        heappush(self._queue, (self.now + seconds, self._number, happens))

    def run(self) -> None:
        """Let all happen that is to come."""
        while self._queue:
            self.now, _, happens = heappop(self._queue)
            happens()

    def register(self, handler: Made, context: Context, handle: Callable[[], None]) -> None:
        """Let a handler wait for its event; one of which this is not known follows without."""
        if handler.kind in _EVENTS and not isinstance(_target(handler), Unknown):
            self._handlers.append(_Handler(handler, context.moment(), handle))
        else:
            moment = context.moment()
            self.put(0.0, lambda: self._resumed(context, moment, handle) if handler in self.known else None)

    def forget(self, handler: Made) -> bool:
        """Let a handler wait no more; whether it was registered."""
        if handler not in self.known:
            return False
        self.known.remove(handler)
        self._handlers = [one for one in self._handlers if one.made is not handler or handler in self.known]
        return True

    def started(self, action: Made, context: Context) -> None:
        """A process starts, and ends some time."""
        moment = context.moment()
        self.put(0.0, lambda: self._happen(START, action, moment, context))
        self.put(LIFETIME, lambda: self._happen(EXIT, action, moment, context))

    def carried_out(self, action: Made, context: Context) -> None:
        """An action has been carried out, which is an event if what was registered before waits for it."""
        waiting = (handler.made for handler in self._handlers if handler.made.kind == COMPLETION)
        if any(True for handler in waiting for _ in self._matches(_target(handler), action)):
            moment = context.moment()
            seconds = LIFETIME if is_derived(action.kind, "ExecuteLocal") else 0.0
            self.put(seconds, lambda: self._happen(COMPLETION, action, moment, context))

    def _happen(self, event: str, action: Made, moment: Moment, context: Context) -> None:
        """Carry out what waits for an event, the last that was registered first. What an action started again is not followed twice."""
        for handler in [*reversed(self._handlers)]:
            key = id(handler.made), id(action)
            if handler.made.kind != event or key in self._handled or handler not in self._handlers:
                continue
            for conditions in self._matches(_target(handler.made), action):
                self._handled.add(key)
                if handler.made.arguments.get("handle_once") is True:
                    self._handlers.remove(handler)
                self._resumed(context, handler.moment.within(moment.conditions, conditions), handler.handle, anew=event == EXIT)

    def _matches(self, target: Any, action: Made) -> Iterator[tuple[Condition, ...]]:
        """The conditions under which an action is the one that a handler waits for."""
        for conditions, one in cases(target):
            if isinstance(one, (Function, Bound)):
                run = self.world.interpreter
                matching = run.truth(run.apply(one, [action], {})) is not False
            else:
                matching = one is None or (one.made if isinstance(one, Instance) else one) is action
            if matching:
                yield conditions

    @staticmethod
    def _resumed(context: Context, moment: Moment, handle: Callable[[], None], *, anew: bool = False) -> None:
        with context.resumed(moment, anew=anew):
            handle()


def _target(handler: Made) -> Any:
    return handler.get("target_action", "action_matcher")
