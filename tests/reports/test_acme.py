"""The description in Acme: it follows the grammar, its names are unique, and what it attaches is there."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest
from lark import Lark, Token, Tree
from systems import at, made, node, port, small, system

from rosarch.models.system.model import SystemModel
from rosarch.reports.acme import acme_text

GRAMMAR = Lark(Path(__file__).with_name("acme.lark").read_text(encoding="utf-8"), parser="lalr")


def name(tree: Tree[Token]) -> str:
    return str(tree.children[0])


def names(tree: Tree[Token], kind: str) -> list[str]:
    return [name(found) for found in tree.find_data(kind)]


def read(model: SystemModel) -> Tree[Token]:
    tree = GRAMMAR.parse(acme_text(model))
    top = names(tree, "component") + names(tree, "connector")
    assert max(Counter(top).values(), default=1) == 1
    inside = {
        kind: {name(found): names(found, part) for found in tree.find_data(kind)}
        for kind, part in (("component", "port"), ("connector", "role"))
    }
    for found in inside.values():
        assert all(max(Counter(parts).values(), default=1) == 1 for parts in found.values())
    attached = [[str(child) for child in found.children] for found in tree.find_data("attachment")]
    assert all(p in inside["component"][c] and role in inside["connector"][k] for c, p, k, role in attached)
    assert sorted((k, role) for _, _, k, role in attached) == sorted(
        (k, role) for k, roles in inside["connector"].items() for role in roles
    )
    return tree


def test_a_whole_description() -> None:
    nodes = (
        node("/base/talker", [port("publisher", "/chatter", "std_msgs/String")], lines=(at("a.launch", 2), at("b.launch", 3))),
        node("/listener", [port("subscriber", "/chatter", "std_msgs/String"), port("service_server", "/go", "std_srvs/Empty")]),
        node("/caller", [port("service_client", "/go", "std_srvs/Empty")], origin="unknown"),
    )
    assert (
        acme_text(system(nodes))
        == """\
import families/ROSFam.acme;
system robot : ROSFam = new ROSFam extended with {
  component base_talker : ROSNodeCompT = new ROSNodeCompT extended with {
    port chatter_pub : TopicAdvertisePortT = new TopicAdvertisePortT extended with {
      property topic = "/chatter";
      property msg_type = "std_msgs/String";
    };
    property name = "/base/talker";
    property launchedBy = "b.launch";
  };
  component listener : ROSNodeCompT = new ROSNodeCompT extended with {
    port chatter_sub : TopicSubscribePortT = new TopicSubscribePortT extended with {
      property topic = "/chatter";
      property msg_type = "std_msgs/String";
    };
    port go_svc : ServiceProviderPortT = new ServiceProviderPortT extended with {
      property name : string = "/go";
      property svc_type : string = "std_srvs/Empty";
      property args : string = "";
    };
    property name = "/listener";
    property launchedBy = "unknown";
  };
  component caller : ROSNodeCompT, PlaceholderT = new ROSNodeCompT, PlaceholderT extended with {
    port go_call : ServiceClientPortT = new ServiceClientPortT extended with {
      property name : string = "/go";
      property svc_type : string = "std_srvs/Empty";
    };
    property name = "/caller";
    property placeholder = true;
    property launchedBy = "unknown";
  };
  connector go_conn : ServiceConnT = new ServiceConnT extended with {
    role caller_call : ROSServiceCallerRoleT = new ROSServiceCallerRoleT;
    role listener_svc : ROSServiceResponderRoleT = new ROSServiceResponderRoleT;
  };
  connector chatter_conn : TopicConnectorT = new TopicConnectorT extended with {
    role base_talker_pub : ROSTopicAdvertiserRoleT = new ROSTopicAdvertiserRoleT;
    role listener_sub : ROSTopicSubscriberRoleT = new ROSTopicSubscriberRoleT;
    property msg_type = "std_msgs/String";
    property topic = "/chatter";
  };
  attachment caller.go_call to go_conn.caller_call;
  attachment listener.go_svc to go_conn.listener_svc;
  attachment base_talker.chatter_pub to chatter_conn.base_talker_pub;
  attachment listener.chatter_sub to chatter_conn.listener_sub;
}
"""
    )
    read(system(nodes))


@pytest.mark.parametrize("model", [small(), made(40), system([])], ids=["small", "made", "empty"])
def test_it_follows_the_grammar(model: SystemModel) -> None:
    assert len(names(read(model), "component")) == len(model.nodes)


def test_what_is_connected() -> None:
    assert set(names(read(small()), "connector")) == {
        "base_ticks_conn",
        "cmd_vel_conn",
        "odom_conn",
        "plan_conn",
        "base_reset_conn",
        "tf_conn",
    }


def test_ports_that_libraries_make_are_left_out() -> None:
    assert not [n for n in names(read(small()), "port") if "status" in n or "diagnostics" in n]


def test_names_are_made_legal_and_unique() -> None:
    written = ["/a/b", "/a_b", "/A/b", "/system", "/2d", "/$(arg x)/é", "/$(arg y)/è", "/"]
    ports = [port("publisher", topic, "T") for topic in ("/x/y", "/x_y", "x y", "?")]
    tree = read(system([node(n, ports) for n in written], name="system"))
    assert names(tree, "component") == ["a_b", "a_b_2", "A_b_3", "system_2", "n_2d", "arg_x", "arg_y", "unnamed"]
    assert names(next(tree.find_data("component")), "port") == ["x_y_pub", "x_y_pub_2", "x_y_pub_3", "pub"]


def test_texts_end_where_they_should() -> None:
    tree = read(system([node('/a"b\\', [port("publisher", 'x"\n;}', '"', conditional="c")], package='p"')]))
    assert [str(child) for found in tree.find_data("property") for child in found.children] == [
        "topic", "\"x' ;}\"", "msg_type", "\"'\"", "name", "\"/a'b/\"", "launchedBy", '"unknown"',
    ]  # fmt: skip


@pytest.mark.parametrize(("types", "written"), [(("A", "A"), "A"), (("A", None), "any"), (("*", "A"), "any"), (("A", "B"), "A")])
def test_the_type_of_a_connector(types: tuple[str | None, str | None], written: str) -> None:
    ends = (node("/a", [port("publisher", "/x", types[0])]), node("/b", [port("subscriber", "/x", types[1])]))
    (connector,) = read(system(ends)).find_data("connector")
    assert str(next(connector.find_data("property")).children[1]) == f'"{written}"'
