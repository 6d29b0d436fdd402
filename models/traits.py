"""What rules say of a component for the sake of the systems that it becomes part of."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from rosarch.base.places import Place

# of the flow of data, which has to be asked for
FLOW_TRAITS = {
    "flows_analysed": ("text",),
    "port_flow": ("port", "port", "text", "text"),
    "flow_variable": ("port", "port", "variable"),
    "flow_filter": ("port", "port", "variable"),
    "flow_always": ("port", "port", "text"),
    "keeps_requests": ("port",),
    "flow_needs": ("port", "port", "variable", "text"),
    "keeps_parameter_named": ("variable", "text"),
}
# relations of components and what their columns are; of systems they are called `interface_...` and begin with the component
TRAITS = {
    "sent_at_start": ("port", "place"),
    "sent_in_a_row": ("port", "place"),
    "serves_callbacks": ("place",),
    "serves_one": ("place",),
    "awaits": ("port", "port", "variable"),
    "never_is": ("place", "variable", "text"),
    "changed_at_once": ("variable", "place", "place"),
    "remade_at_once": ("text", "place", "place"),
    "call_blocks": ("port", "port", "place"),
    "names_nothing": ("place", "text", "port"),
    "sends_frame": ("place", "text", "text"),
    "may_send_frame": ("place", "text", "text"),
    "sends_from_frame": ("place", "text", "text"),
    "sent_in_frame": ("place", "port", "text", "text"),
    "period_of_parameter": ("place", "text"),
    "asks_transport": ("port", "text"),
    "sent_where_made": ("port", "place"),
    "sends_other_frame": ("place",),
    "looks_up_frame": ("place", "text", "text", "text"),
    "answers_most": ("port", "port", "text"),
    "round_sends": ("place", "port", "text"),
    "answers_least": ("port", "port", "text"),
    "round_least": ("place", "port", "text"),
    "round_always": ("place", "port"),
    "round_without_wait": ("place",),
    "round_waits": ("place", "place", "text", "text", "text"),
    "round_of_each": ("place",),
    "sent_untimed": ("port",),
    "sent_otherwise": ("port",),
    "sent_by_itself": ("port",),
    "sends_nothing": ("port",),
    "given_away": ("port",),
    "unsteady": ("place", "text"),
    "unheard": ("port", "text"),
    "callback_unseen": ("port",),
    "held_up": ("text",),
    "may_be_missed": ("place",),
    "perhaps_always": ("port", "port"),
    "asks_message": ("port", "port"),
    "sends_constants": ("port",),
    "rejects_goals": ("port",),
    "sleeps_for_each": ("port", "text", "text"),
    "synchronised": ("port", "port"),
    "waits_for": ("place", "port"),
    "provides_after": ("port", "place"),
    "sends_in_burst": ("place", "port", "text"),
    "begins_in": ("variable", "text"),
    "field_begins": ("variable", "text", "text"),
    "moves_on": ("port", "variable", "text", "text"),
    "moves_freely": ("variable", "text", "text"),
    "asks_for": ("place", "variable", "text"),
    "ignores": ("port", "variable", "text"),
    "answers_in": ("port", "port", "variable", "text"),
    "answer_kept_out": ("port", "place", "text"),
    "declares_without_default": ("place",),
    "of_inner_node": ("port",),
    "beside": ("port", "port", "text"),
    "takes_given_name": ("place", "text"),
    "node_namespace": ("place", "text"),
    "parameter_bounded": ("place", "text", "text", "text"),
    "parameter_clamped": ("place", "text", "text", "text"),
    "moves_managed": ("place",),
    "stamped_now": ("port",),
    "reads_clock": ("place",),
    "synchronised_exactly": ("port", "port"),
    "sent_inactive": ("port", "place", "text"),
    "sent_unmade": ("place", "text"),
    "ends_too_early": ("place", "text"),
    "loops_for_callback": ("place", "text"),
    "undeclared_read": ("place", "text", "text"),
    "refuses_other_text": ("place", "text", "text"),
    "refuses_number": ("place", "text", "text", "text", "text"),
    "refuses_pair": ("place", "text", "text", "text"),
    "shared_too_early": ("place",),
    "declared_twice": ("place", "place", "text"),
    "declared_by_setting": ("place", "text"),
    "never_spun": ("place",),
    "interface_absent": ("place", "text", "text"),
    "mixed_arguments": ("place", "text"),
    "member_absent": ("place", "text", "text"),
    "field_absent": ("place", "text", "text"),
    "field_misgiven": ("place", "text", "text", "text"),
    "message_misbuilt": ("place", "text", "text", "text"),
    "sent_misfit": ("place", "port", "text", "text"),
    "call_refused": ("place", "text", "text"),
    "callback_misfit": ("place", "place", "text", "text"),
    "never_started": ("place", "text"),
    "started_late": ("place", "place", "text"),
    "after_spin": ("place", "place", "text"),
    "base_not_made": ("place",),
    "base_made_late": ("place", "place"),
    "period_divided_away": ("place", "place"),
    "rate_of_zero": ("place",),
    "answers_nothing": ("port", "place"),
    "callback_called": ("place",),
    "refuses_slash": ("place",),
    "joins_endless": ("place", "place", "text"),
    "read_for_another": ("place", "text", "text", "text"),
    "sent_without": ("place", "port", "text"),
    "made_without_queue": ("place",),
    "starts_in_constructor": ("place", "place", "text"),
    "spins_again": ("place", "text"),
    "runs_too_little": ("place", "text"),
    "sleeps_for_ever": ("place",),
    "plugin_named": ("place", "text", "text", "text", "text"),
    "misused": ("place", "text", "text"),
    "timer_waits": ("place", "place", "text", "text"),
    "keeps_value_of": ("text", "text"),
    "begins_with_value_of": ("variable", "text"),
    "names_number": ("text", "text"),
    "repeated": ("place",),
    "names_message": ("port", "text"),
    "unsteady_name": ("text",),
    "gives_another": ("text",),
    "registers_tree_node": ("text",),
    "port_for_plugin": ("port", "text", "text"),
    "plugin_derives": ("text",),
    "plugin_hears": ("text",),
    "keeps_moment": ("variable",),
    "converted": ("place",),
    "of_several_objects": ("variable",),
    "changed_by_several": ("variable",),
    "sent_by_several": ("port",),
    "least_gap": ("port", "port", "text", "text"),
    "answers_surely": ("port",),
    "in_callback": ("port", "place", "place"),
    "continues_with": ("place", "place"),
    "done_at_once": ("place",),
    "gives_way": ("port", "place"),
    "gives_way_otherwise": ("place",),
    "runs_any_method": ("place", "text"),
    **FLOW_TRAITS,
}


@dataclass(frozen=True, order=True)
class Trait:
    """A row of the relation `name`: ids of ports, places, names of variables, texts."""

    name: str
    values: tuple[str | Place, ...]


def traits(
    relations: Mapping[str, Iterable[tuple[Any, ...]]], ports: Mapping[Any, str], places: Mapping[str, Place], variables: Mapping[str, str]
) -> tuple[Trait, ...]:
    """The traits of a component; rows about things that its model does not have are left out."""
    known: dict[str, Mapping[Any, Any]] = {"port": ports, "place": places, "variable": variables}
    found = set()
    for name, kinds in TRAITS.items():
        for row in relations.get(name, ()):
            values = [known[kind].get(value) if kind in known else value for kind, value in zip(kinds, row, strict=True)]
            if None not in values:
                found.add(Trait(name, tuple(value if isinstance(value, Place) else str(value) for value in values)))
    return tuple(sorted(found))
