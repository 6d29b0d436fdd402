"""Absent headers: what clang would drop for a name that nothing declares is in the facts all the same."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

from rosarch.extractor.cxx import libclang, translation_unit
from rosarch.extractor.cxx.heal import healed, without_unknown
from rosarch.extractor.cxx.includes import SHIPPED_DIRS
from rosarch.extractor.cxx.kept_calls import CallPlaces, keeps_calls
from rosarch.extractor.cxx.translation_unit import BASE_ARGUMENTS
from rosarch.extractor.cxx.wanted import UNKNOWN, Wanted


@pytest.fixture
def extract(extract, monkeypatch: pytest.MonkeyPatch):
    """The common fixture, with healing."""
    monkeypatch.setitem(translation_unit.extract_unit.__kwdefaults__, "heal", True)
    return extract


OUT = "struct Out { void send(int x); void text(const char* s); };\n"


def bound(facts) -> list[str]:
    """The callees of calls that clang bound, in source order."""
    unresolved = {call for call, _ in facts["call_unresolved"]}
    return [name for call, name in facts.calls().items() if call not in unresolved]


@pytest.mark.parametrize(
    ("case", "source"),
    [
        ("base class of an unknown namespace", "struct N : public far::Base { Out out; void go() { out.send(rate()); } };"),
        ("unknown base class", "struct N : public Base { Out out; void go() { if (ready_) out.send(1 + level_); } };"),
        ("member of an unknown base", "struct N : public far::Base { Out out; }; void f(N n) { n.out.send(n.level_); }"),
        ("field of an unknown type", "struct N { far::Thing thing_; Out out; void go() { out.send(thing_.size()); } };"),
        ("pointer to an unknown type", "struct N { far::Thing* thing_; Out out; void go() { out.send(thing_->size()); } };"),
        ("unknown class template", "struct N { far::Box<int> box_; Out out; void go() { out.send(box_.get()); } };"),
        ("template with a number", "struct N { far::Box<int, 3> box_; Out out; void go() { out.send(box_.get()); } };"),
        ("unknown function", "void f(Out out) { out.send(measure(3)); }"),
        ("unknown function of a namespace", "void f(Out out) { out.send(far::measure(3)); }"),
        ("static function of an unknown class", "void f(Out out) { out.send(far::Clock::now()); }"),
        ("unknown variable", "void f(Out out) { out.send(limit); }"),
        ("unknown constant in a condition", "void f(Out out, int x) { if (x == LIMIT) { out.send(1); } }"),
        ("unknown type after using namespace", "using namespace far; void f(Out out, far::A a) { Thing t; out.send(t.size()); }"),
        (
            "unknown namespace in one that using namespace brings",
            "using namespace far; struct N : public wide::Base { wide::Thing thing_; Out out; void go() { far::wide::open(); out.send(thing_.size()); } };",
        ),
        ("unknown type by using", "using far::Thing; void f(Out out) { Thing t; out.send(t.size()); }"),
        (
            "global name like that of the namespace around",
            "namespace near { namespace far { struct N { ::far::Thing thing_; Out out; void go() { out.send(thing_.size()); } }; } }",
        ),
        ("unknown macro before a declaration", "EXPORT_ALL struct N { Out out; void go(int x) { out.send(x); } };"),
        ("unknown attribute macro", "__host__ __device__ void f(Out out) { out.send(unheard(1)); }"),
        ("unknown macro called as a statement", "void f(Out out, int x) { CHECK_POSITIVE(x); out.send(unheard(x)); }"),
        ("unknown loop macro", "void f(Out out, int x) { FOREVER(x) { out.send(unheard(x)); } }"),
        ("range of unknown type", "void f(Out out, far::List list) { for (auto& x : list) { out.send(x.id); } }"),
        ("switch over an unknown value", "void f(Out out, far::Event e) { switch (e.kind) { case far::Start: out.send(1); } }"),
        ("unknown type by using, with members", "using far::msg::Point; void f(Out out, const Point& p) { Point q = p; out.send(q.x); }"),
        ("type first met as a namespace", "void f(Out out, far::format x) { if (x == far::format::RAW) out.send(far::format::ANY); }"),
        ("address of an unknown value", "void fill(int* x); void f(Out out, far::Thing t) { fill(&t.size); out.send(1); }"),
        (
            "text from an unknown value",
            "#include <string>\nvoid f(Out out) { std::string s; s = far::name(); out.send(std::string(far::name()).size()); }",
        ),
        ("key of unknown type", "#include <map>\nvoid f(Out out, std::map<int, int>& m) { out.send(m[far::key()]); }"),
        (
            "parts of a constant",
            "#include <array>\n#include <tuple>\nvoid f(Out out, std::array<int, 2> x) { const auto [a, b] = x; out.send(a); }",
        ),
        ("parts of an unknown tuple", "#include <tuple>\nvoid f(Out out) { const auto x = std::get<0>(far::pair()); out.send(x.size()); }"),
        ("catch of an unknown type", "void f(Out out) { try { out.send(1); } catch (far::Error& e) { out.text(e.what()); } }"),
        ("stream of an unknown value", "#include <iostream>\nvoid f(Out out, far::A a) { std::cout << a.x << 3; out.send(a.x); }"),
        ("arithmetic", "void f(Out out, far::A a) { double d = 3 * a.x + 2.0 - a.y[1]; d += a.z; out.send(int(d) + a.x); }"),
        ("member template of an unknown value", "void f(Out out, far::A a) { out.send(a.at<int>(3) + a.at<int>(4)); }"),
        ("member template behind a member", "void f(Out out, far::A a) { out.send(a.b.at<int>(3)); }"),
        ("list by commas", "void f(Out out) { far::Vec v((far::Vec(3) << 1, 2, 3).finished()); out.send(v.size()); }"),
        (
            "name in a namespace with a capital",
            "namespace Far { struct A {}; } struct N { Far::B b; Far::C<int> c; void f(Out out) { out.send(b.size()); } };",
        ),
        ("macro behind a member", "struct N { int x_ GUARDED_BY(m_); void go(Out out) LOCKS(m_) { out.send(x_ + unheard(1)); } };"),
        (
            "macro in front of a derived class",
            "struct Base { Out out; }; class MY_LIBRARY_EXPORT N : public Base { void go() { out.send(unheard(1)); } };",
        ),
        ("macro in front of a class", "class MY_LIBRARY_PUBLIC N final { void go(Out out); }; void N::go(Out out) { out.send(1); }"),
        (
            "macro in place of a declaration",
            "struct N { A_PROPERTY(int, x)\n void go(Out out) { out.send(1); } };\nASSUME_OF(N)\nvoid f(Out out) { N n; out.send(2); }",
        ),
        (
            "struct of a namespace",
            "namespace c_library {} struct Base { Out out; }; struct N : Base { struct c_library::state state_; void go() { out.send(state_.x); } };",
        ),
        ("macro behind a variable", "int x ALIGNED(8); void f(Out out) NOTHROW; void f(Out out) { out.send(x); }"),
        ("base class from the global namespace", "struct N : public ::far::Base { void go(Out out) override { out.send(level_); } };"),
        (
            "enumerator that is an unknown constant",
            "enum E { FIRST = far::START, SECOND }; void f(Out out, E e) { if (e == SECOND) out.send(FIRST); }",
        ),
        (
            "class template by using, within a container",
            "#include <deque>\nusing far::Mean; struct N : Out { std::deque<Mean<double>> means_; void go() { means_.push_back(Mean<double>()); send(1); } };",
        ),
        ("class that is only declared", "namespace ui { class Window; } void f(Out out, ui::Window* w) { out.send(w->size()); }"),
    ],
)
def test_a_call_survives(extract, case: str, source: str) -> None:
    facts = extract(OUT + source)
    assert "Out::send" in bound(facts), case
    assert [row for row in facts["call_unresolved"] if row[1] == "recovered"] == []


def test_the_called_names_are_those_of_the_source(extract) -> None:
    facts = extract(OUT + "void f(Out out) { out.send(far::measure(3)); out.send(near(4)); out.send(far::Clock::now()); }")
    assert bound(facts) == ["Out::send", "far::measure", "Out::send", "near", "Out::send", "far::Clock::now"]


def test_fields_of_a_message_of_which_only_the_name_is_known(extract) -> None:
    source = "#include <my_msgs/Level.h>\nvoid f(Out out, const my_msgs::Level::ConstPtr& msg) { if (msg->value > 3) out.send(msg->header.stamp.toSec()); }"
    facts = extract(OUT + source)
    assert "Out::send" in bound(facts)
    assert ("my_msgs::Level_", "message", "my_msgs/Level") in facts["message_class"]
    assert ("my_msgs::Level_::value", "value") in facts["variable_name"]


def test_type_of_a_field_of_a_message_of_which_only_the_name_is_known(extract) -> None:
    source = "#include <my_msgs/Level.h>\nstruct N { Out out; my_msgs::Level::_value_type last_; void go(my_msgs::Level m) { if (m.value == last_) out.send(1); last_ = m.value; } };"
    facts = extract(OUT + source)
    assert bound(facts) == ["Out::send"]
    assert ("N::last_", "N") in [(field.partition("@")[0], owner) for field, owner in facts["field_class"]]


def test_type_of_a_field_that_is_seen_first_where_it_could_be_a_value(extract) -> None:
    source = """#include <my_msgs/Level.h>
        #include <functional>
        struct Base { void say(int); };
        struct N : Base { std::function<void(my_msgs::Level::_value_type)> done_; my_msgs::Level::_value_type last_; Out out;
          void set(my_msgs::Level::_value_type value); void go() { set(my_msgs::Level::HIGH); say(1); } };
        void N::set(my_msgs::Level::_value_type value) { out.send(1); }"""
    assert bound(extract(OUT + source)) == ["N::set", "Base::say", "Out::send"]


def test_what_a_template_takes_for_a_type_is_one(extract) -> None:
    source = "#include <utility>\nstruct Base { void say(int); };\nstruct N : Base { std::pair<far::Box, unsigned> box_; void go() { say(1); } };"
    assert bound(extract(source)) == ["Base::say"]


def test_members_of_a_message_that_no_header_of_the_source_declares(tmp_path: Path) -> None:
    stand_in = tmp_path / "absent" / "2" / "my_msgs" / "msg" / "level.hpp"  # made for another source
    stand_in.parent.mkdir(parents=True)
    stand_in.write_text("namespace my_msgs { namespace msg {\nstruct Level_ {\n};\n}}\n")
    wanted = Wanted(tmp_path)
    wanted.member("my_msgs::msg::Level_", "size", "value")
    wanted.name(["my_msgs", "msg", "Level"], "class")
    wanted.member("my_msgs::msg::Level", "value", "value")
    assert list(wanted.messages.values()) == [{"size": "value"}]
    assert wanted.find(["my_msgs", "msg", "Level", "value"]) is not None


def test_constants_of_a_message_select_a_case_and_have_no_value(extract) -> None:
    facts = extract(
        OUT + "#include <my_msgs/Level.h>\nvoid f(Out out, my_msgs::Level m) {"
        " switch (m.kind) { case my_msgs::Level::LOW: out.send(1); break; case my_msgs::Level::HIGH: out.send(2); } }"
    )
    assert bound(facts).count("Out::send") == 2
    assert len(facts["block_case"]) == 2
    assert facts["expr_constant"] == []
    assert sorted(value for _, _, value in facts["literal"]) == ["1", "2"]


def test_request_and_response_of_an_unknown_service(extract) -> None:
    facts = extract(OUT + "#include <my_srvs/Set.h>\nvoid f(Out out, my_srvs::Set::Request& q) { out.send(q.level); }")
    assert "Out::send" in bound(facts)


def test_an_unknown_value_has_no_type(extract) -> None:
    facts = extract(OUT + "void f(Out out) { out.send(measure(3)); }")
    assert [row for row in facts["expr_type"] if "rosarch_healed" in str(row[1])] == []


def test_what_the_source_declares_itself_is_not_declared_again(extract) -> None:
    facts = extract(OUT + "void f(Out out) { out.send(later(3)); out.send(unheard(4)); }\nstruct later { int x; };\nlater g();")
    assert "Out::send" in bound(facts)
    assert ("later", "struct") in facts["class"]


def test_a_message_that_is_included_behind_its_use_has_a_type(extract) -> None:
    use = "void f(const geometry_msgs::Wrench& w) { Out out; out.send(w.force.x); spin(a, b, c, d, e); }\n"
    facts = extract(f"{OUT}namespace geometry_msgs {{}}\n{use}#include <geometry_msgs/Wrench.h>\n")
    types = dict(facts["variable_type"])
    assert [types[variable] for variable, name in facts["variable_name"] if name == "w"] == ["const geometry_msgs::Wrench &"]


@pytest.mark.parametrize("header", ["", "#include <trouble.h>\n"])
def test_a_source_without_errors_of_its_own_is_parsed_once(extract, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, header: str) -> None:
    outside = tmp_path / "elsewhere"
    outside.mkdir()
    (outside / "trouble.h").write_text("far::Thing thing;")
    monkeypatch.setattr(Wanted, "write", lambda _self: pytest.fail("healed"))
    assert bound(extract(f"{header}{OUT}void f(Out out) {{ out.send(1); }}", include_dirs=(outside,))) == ["Out::send"]


def test_the_first_parse_is_kept_when_healing_would_lose_a_call(extract, monkeypatch: pytest.MonkeyPatch) -> None:
    source = f'{OUT}void f(Out out) {{ out.send(unheard(2)); if (LIMIT) {{\n#ifndef LIMIT\nout.text("x");\n#endif\n}} }}'
    assert bound(extract(source)) == ["Out::send", "unheard", "Out::text"]
    monkeypatch.setattr(Wanted, "write", _losing)
    kept: list[bool] = []
    monkeypatch.setattr(translation_unit, "keeps_calls", lambda *rows: kept.append(keeps_calls(*rows)) or kept[-1])
    facts = extract(source)
    assert kept == [False]
    assert "Out::text" in bound(facts)
    assert "unheard" not in bound(facts)


def _losing(wanted: Wanted) -> Path:
    """A header that declares what is missing, but by a macro that the source tests."""
    folder = wanted.scratch / "losing"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "healed.h").write_text("template <typename... A> int unheard(A&&...);\n#define LIMIT 1\n")
    return folder


def test_few_calls_may_be_lost_where_many_more_are_found() -> None:
    first = Counter({("n.cpp", 1): 2, ("n.cpp", 9): 1})
    assert keeps_calls(first, first)
    assert not keeps_calls(first, Counter({("n.cpp", 1): 2}))
    assert not keeps_calls(first, Counter({("n.cpp", 1): 1, ("n.cpp", 9): 1, ("n.cpp", 5): 3}))
    assert keeps_calls(first, Counter({("n.cpp", 1): 1, ("n.cpp", 9): 1, ("n.cpp", 5): 4}))


def test_operators_are_no_calls(extract, monkeypatch: pytest.MonkeyPatch) -> None:
    places: list[CallPlaces] = []
    monkeypatch.setattr(translation_unit, "keeps_calls", lambda *given: places.extend(given) or True)
    code = """
        struct Sum { Sum operator+(const Sum&); operator int(); int operator()(int); };
        int plain(int);
        template <typename T> void f(Sum s, T t) { plain(s + s); s(1); t.later(2) * unheard(3); t * t; }
    """
    extract(code)
    found = [[code[begin:].partition("(")[0] for _, begin in sorted(each)] for each in places]
    assert found == [["plain", "s", "t.later"], ["plain", "s", "t.later", "unheard"]]


def test_types_of_unknown_values_are_taken_back() -> None:
    rows = {"expr_type": {("a", "int"), ("b", f"{UNKNOWN} &")}}
    without_unknown(rows)
    assert rows["expr_type"] == {("a", "int")}


def test_the_header_is_the_same_for_the_same_names(tmp_path: Path) -> None:
    texts = set()
    for order in (1, -1):
        wanted = Wanted(tmp_path)
        for path in [["far", "Thing"], ["far", "near", "Box"], ["Plain"]][::order]:
            wanted.name(path, "class")
        for name in ["stamp", "id"][::order]:
            wanted.member(UNKNOWN, name, "value")
        folder = wanted.write()
        texts.add((folder, (folder / "healed.h").read_text()))
    ((folder, text),) = texts
    assert folder.parent == tmp_path / "healed"
    assert "namespace far {" in text
    assert "static unknown id; static unknown stamp;" in text


@pytest.mark.parametrize(
    ("kinds", "kind"), [(["value", "class"], "class"), (["template", "class"], "template"), (["class", "namespace"], "class")]
)
def test_the_more_telling_use_of_a_name_decides(tmp_path: Path, kinds: list[str], kind: str) -> None:
    wanted = Wanted(tmp_path)
    for each in kinds:
        wanted.name(["Thing"], each)
    node = wanted.find(["Thing"])
    assert node is not None and node.kind == kind


def test_keywords_and_operators_are_no_names(tmp_path: Path) -> None:
    wanted = Wanted(tmp_path)
    for name in ("void", "operator", "a b", "~X"):
        wanted.name([name], "class")
    assert wanted.top == {} and not wanted.changed


def test_fewer_errors_or_nothing(tmp_path: Path) -> None:
    source = tmp_path / "n.cpp"
    source.write_text("void f() { int x = ; }")
    arguments = [*BASE_ARGUMENTS, *(word for folder in SHIPPED_DIRS for word in ("-isystem", str(folder)))]
    with libclang.Unit(source, arguments) as first, healed(source, arguments, first, tmp_path) as better:
        assert better is None
    source.write_text("void f() { far::go(); }")
    with libclang.Unit(source, arguments) as first, healed(source, arguments, first, tmp_path) as better:
        assert better is not None and not [severity for severity, *_ in better.unit.diagnostics if severity >= 3]
