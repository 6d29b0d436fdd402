"""Macros of absent headers: what stands around them and behind them is still there."""

from __future__ import annotations

import pytest

from rosarch.extractor.cxx import translation_unit
from rosarch.extractor.cxx.recover import hide
from rosarch.extractor.cxx.undefined_macros import undefined_macros


@pytest.fixture
def extract(extract, monkeypatch: pytest.MonkeyPatch):
    """The common fixture, with healing."""
    monkeypatch.setitem(translation_unit.extract_unit.__kwdefaults__, "heal", True)
    return extract


OUT = "#include <vector>\nstruct Out { void send(int x); void text(const char* s); };\n"


@pytest.mark.parametrize(
    ("case", "source"),
    [
        ("member", "struct N { Out out; DECLARE(int, x, 5) N() {  out.send(2); }  void go() { out.send(3); } };"),
        ("member before a method", "struct N { Out out;  N() {  out.send(2); } DECLARE(int, x, 5) void go() { out.send(3); } };"),
        ("member with a text", 'struct N { Out out; DECLARE("a") N() {  out.send(2); } DECLARE("b") void go() { out.send(3); } };'),
        (
            "member with a type",
            "struct N { Out out; DECLARE(std::vector<int>, x, y) N() {  out.send(2); } DECLARE(std::vector<int>, x, y) void go() { out.send(3); } };",
        ),
        (
            "method with a body",
            'struct N { Out out; DECLARE(a) { int x; } N() {  out.send(2); } DECLARE(b) { out.text("x"); } void go() { out.send(3); } };',
        ),
        ("statement", "struct N { Out out;  N() { LOAD(*this, out, x, int, 50) out.send(2); }  void go() { out.send(3); } };"),
        ("statement with an unknown name", "struct N { Out out;  N() { LOAD(weird)\n out.send(2); }  void go() { out.send(3); } };"),
        ("word on a line", "struct N { Out out;  N() { LOAD\n out.send(2); }  void go() { out.send(3); } };"),
        ("begin and end", 'struct N { Out out;  N() { TRY_BEGIN out.text("x"); TRY_END out.send(2); }  void go() { out.send(3); } };'),
        (
            "statements as an argument",
            'struct N { Out out;  N() { IF_DEBUG(out.text("x"); out.text("y");) out.send(2); }  void go() { out.send(3); } };',
        ),
        (
            "block as an argument",
            'struct N { Out out;  N() { IF_DEBUG({ out.text("x"); out.text("y"); }); out.send(2); }  void go() { out.send(3); } };',
        ),
        (
            "block as a second argument",
            'struct N { Out out;  N() { ONCE(3, { out.text("x"); out.text("y"); }) out.send(2); }  void go() { out.send(3); } };',
        ),
        ("loop", 'struct N { Out out;  N() { LOOP_OVER(x, 3) { out.text("x"); } out.send(2); }  void go() { out.send(3); } };'),
        (
            "loop in small letters",
            'struct N { Out out;  N() { foreach (int x, far::things()) { out.text("x"); } out.send(2); }  void go() { out.send(3); } };',
        ),
        ("block behind a word", 'struct N { Out out;  N() { ATOMIC { out.text("x"); } out.send(2); }  void go() { out.send(3); } };'),
        ("guard", 'struct N { Out out;  N() { LOCK(m_) out.text("x"); out.send(2); }  void go() { out.send(3); } };'),
        (
            "branch without semicolon",
            "struct N { Out out;  N() { if (1) LOAD(out) else out.send(4); out.send(2); }  void go() { out.send(3); } };",
        ),
        (
            "behind a parameter",
            "struct N { Out out;  N() {  out.send(2); } void a(int x UNUSED) { out.send(x); } void go() { out.send(3); } };",
        ),
        (
            "around a parameter",
            "struct N { Out out;  N() {  out.send(2); } void a(UNUSED(int x)) { out.send(x); } void go() { out.send(3); } };",
        ),
        (
            "around the name of a parameter",
            "struct N { Out out;  N() {  out.send(2); } void a(int UNUSED(x)) { out.send(x); } void go() { out.send(3); } };",
        ),
        (
            "behind a method",
            "struct N { Out out;  N() {  out.send(2); } void a() NOEXCEPT_ON { out.send(1); } void go() { out.send(3); } };",
        ),
        (
            "behind a constant method",
            "struct N { Out out;  N() {  out.send(2); } void a() const REQUIRES(m_) { Out().send(1); } void go() { out.send(3); } };",
        ),
        (
            "in front of a method, with a text",
            'struct N { Out out;  N() {  out.send(2); } DEPRECATED("x") void a() { out.send(1); } void go() { out.send(3); } };',
        ),
        (
            "between type and method",
            "struct N { Out out;  N() {  out.send(2); } void API_CALL a() { out.send(1); } void go() { out.send(3); } };",
        ),
        ("in front of a class, with an argument", "class MY_API(foo) N { Out out; N() { out.send(1); } };"),
        ("behind the name of a class", "class N MY_FINAL : public Out { N() { send(1); } };"),
        ("namespace", "NS_BEGIN\nstruct N { Out out; N() { out.send(1); } };\nNS_END\n"),
        ("namespace with an argument", "NS_BEGIN(far)\nstruct N { Out out; N() { out.send(1); } };\nNS_END(far)\n"),
        ("function with a body", 'TEST_CASE("far") { Out out; out.send(1); }\nvoid g(Out out) { out.send(4); }'),
        ("in front of a field", "struct N { Out out; ALIGN(16) int a; ALIGN16 int b; ALIGNAS int c[3]; N() : a(3) { out.send(a); } };"),
        (
            "list of items",
            "#define LIST ITEM(int, a, 3) ITEM(double, b, 4)\nstruct P {\n#define ITEM(t, n, d) DEFINE(t, n, d)\n LIST\n#undef ITEM\n};\nstruct N { Out out; P p; N() {\n#define ITEM(t, n, d) LOAD(*this, p, t, n)\n SETUP(LIST, x)\n#undef ITEM\n out.send(1); } };",
        ),
        (
            "within a macro of the source",
            "#define MY_FIELD(t, n) FAR_FIELD(t, n)\nstruct N { Out out; MY_FIELD(int, x) N() { out.send(x); } };",
        ),
        (
            "in a lambda expression",
            "template <typename F> void call(F f); struct N { Out out; N() { call([this]() { LOAD(out) out.send(1); }); } };",
        ),
        (
            "in front of and behind methods",
            "struct N { Out out; VIRT void a() OVERRIDE { out.send(1); } void b() CONST_ OVERRIDE { out.send(2); } void c() NOTHROW = 0; void d() { out.send(3); } };",
        ),
        (
            "in front of a method outside of its class",
            "struct N { Out out; N(int x); void a(); }; API_DEF N::N(int x) { out.send(x); } void API_CALL N::a() { out.send(2); }",
        ),
        ("in a switch", "void f(Out out, int x) { switch (x) { CASE(1) out.send(1); break; case 2: out.send(2); } out.send(3); }"),
    ],
)
def test_no_call_is_lost(extract, case: str, source: str) -> None:
    facts = extract(OUT + source)
    recovered = {call for call, reason in facts["call_unresolved"] if reason == "recovered"}
    bound = [name for call, name in facts.calls().items() if call not in recovered and name in ("Out::send", "Out::text")]
    assert len(bound) == source.count("send(") + source.count("text("), case
    assert not facts["source_lost"]


@pytest.mark.parametrize(
    "source",
    [
        "class EKF { public: EKF(int x); EKF(double x) : x_(x) {} ~EKF(); private: double x_; };",
        "struct N { URL get() const; const URL& path() const; static URL make(std::string URL); unsigned long ABC; };",
        "enum class Mode { OFF, AUTO = 2, LAST_MODE }; Mode MODE = Mode::OFF;",
        "void f() { POINT p; POINT q(1); POINT r = POINT(2); if (ANY(p)) { SEND(q); } else return; for (auto x : LIST) SEND(x); }",
        "void f() { call([&](int x) { return LIMIT + x; }, FIRST(1)); std::vector<int> x{1, 2}; auto y = POINT{1}; }",
        "template <typename T, class ALLOC> T read(ALLOC a) { return a.get(); }  // MACRO(x) {",
        "using PTR = std::shared_ptr<int>; typedef int INT32; extern INT32 LIMIT; INT32 GET(INT32 x); INT32 N::GET(INT32 x) { return x; }",
    ],
)
def test_what_is_no_macro(source: str) -> None:
    text = source.encode()
    assert undefined_macros(text, hide(text), frozenset()).bodies("unknown") == {}


def test_where_a_macro_stands_for_something(extract) -> None:
    facts = extract("struct N {\n  DECLARE(int, x)\n  N() {\n    LOAD(x)\n  }\n  void f() API;\n};\nREGISTER(N)\n")
    assert facts["macro_undefined"] == [("@", 2, "DECLARE", "class"), ("@", 4, "LOAD", "function"), ("@", 8, "REGISTER", "namespace")]


def test_a_macro_of_a_branch_that_is_not_compiled(extract) -> None:
    assert not extract("void f() {\n  unheard();\n#ifdef OTHER\n  LOAD(x)\n#endif\n}\n")["macro_undefined"]


def test_a_body_that_is_lost(extract) -> None:
    facts = extract(
        'typedef int T;\nint T::f() {\n  return 1 + one::twice<std::vector<int>>("g(");  // h(\n}\nint g() {\n  return k(2);\n}\n'
    )
    assert facts["source_lost"] == [("@", 2, 4, "'T' (aka 'int') is not a class, namespace, or enumeration")]
    assert facts["lost_call"] == [("@", 3, "twice")]
