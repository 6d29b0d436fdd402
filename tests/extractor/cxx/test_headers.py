"""The stand-in headers: each parses alone and without errors, and calls of the ROS API resolve to the real names."""

from __future__ import annotations

from pathlib import Path

import clang.cindex as cindex
import pytest
from clang.cindex import CursorKind, TranslationUnit

import rosarch.extractor.cxx as cxx
from rosarch.extractor.cxx.includes import HeaderFinder
from rosarch.extractor.messages.headers import header_index, header_text
from rosarch.extractor.messages.store import load_messages

HEADERS = Path(cxx.__file__).parent / "headers"
GROUPS = ("ros", "third_party", "std")
KEEP_GOING = 0x200
# What clang says of a template used with a local type; harmless, since nothing is ever linked.
HARMLESS = "does not have linkage"


@pytest.fixture(scope="session")
def flags(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """The flags of a parse, with the generated headers of the common messages in a folder."""
    folder = tmp_path_factory.mktemp("messages")
    store = load_messages([])
    for name in header_index(store):
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(header_text(store, name) or "", encoding="utf-8")
    return [
        *("-x", "c++", "-std=gnu++17", "--target=x86_64-unknown-linux-gnu", "-nostdinc", "-nostdinc++", "-Wno-everything"),
        *("-fno-access-control", "-fno-spell-checking", "-ferror-limit=0"),
        *(flag for group in GROUPS for flag in ("-isystem", str(HEADERS / group))),
        *("-isystem", str(folder)),
    ]  # fmt: skip


def _parse(text: str, flags: list[str]) -> TranslationUnit:
    return cindex.Index.create().parse("snippet.cpp", flags, unsaved_files=[("snippet.cpp", text)], options=KEEP_GOING)


def _errors(unit: TranslationUnit) -> list[str]:
    return [
        f"{item.location.file}:{item.location.line}: {item.spelling}"
        for item in unit.diagnostics
        if item.severity >= cindex.Diagnostic.Error and HARMLESS not in item.spelling
    ]


def _names() -> list[str]:
    """Every header as code includes it, without the fragments (`.inc`)."""
    return sorted(
        path.relative_to(HEADERS / group).as_posix()
        for group in GROUPS
        for path in (HEADERS / group).rglob("*")
        if path.is_file() and path.suffix != ".inc"
    )


def _qualified(cursor: cindex.Cursor) -> str:
    names = []
    while cursor is not None and cursor.kind != CursorKind.TRANSLATION_UNIT:
        names.append(cursor.spelling)
        cursor = cursor.semantic_parent
    return "::".join(reversed(names))


def _calls(unit: TranslationUnit) -> list[tuple[str, str]]:
    """Qualified callee and canonical result type of the calls in the main file, in order; an unresolved callee is empty."""
    return [
        (_qualified(cursor.referenced) if cursor.referenced else "", cursor.type.get_canonical().spelling)
        for cursor in unit.cursor.walk_preorder()
        if cursor.kind == CursorKind.CALL_EXPR and cursor.location.file and cursor.location.file.name == "snippet.cpp"
    ]


PARTS = 8


@pytest.mark.slow
@pytest.mark.parametrize("part", range(PARTS))
def test_every_header_parses_alone(part: int, flags: list[str]) -> None:
    allowed = (str(HEADERS), flags[-1])
    problems: list[str] = []
    for name in _names()[part::PARTS]:
        unit = _parse(f"#include <{name}>\n", flags)
        problems += [f"<{name}> {error}" for error in _errors(unit)]
        problems += [f"<{name}> includes {i.include.name}" for i in unit.get_includes() if not i.include.name.startswith(allowed)]
    assert problems == []


def test_all_headers_parse_together(flags: list[str]) -> None:
    assert _errors(_parse("".join(f"#include <{name}>\n" for name in _names()), flags)) == []


def test_the_prelude_can_be_precompiled(flags: list[str], tmp_path: Path) -> None:
    unit = cindex.Index.create().parse(str(HEADERS / "prelude.h"), ["-x", "c++-header", *flags[2:]], options=KEEP_GOING | 0x4)
    assert _errors(unit) == []
    unit.save(str(tmp_path / "prelude.pch"))
    snippet = _parse("void f(ros::NodeHandle n) { n.shutdown(); }", [*flags, "-include-pch", str(tmp_path / "prelude.pch")])
    assert _errors(snippet) == []
    assert _calls(snippet)[0][0] == "ros::NodeHandle::shutdown"


ROS = """
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_srvs/SetBool.h>
using std_msgs::Bool;
struct C {
  void plain(const Bool::ConstPtr&);  void value(Bool);  void event(const ros::MessageEvent<Bool const>&);  void constant(const Bool&) const;
  void both(const Bool::ConstPtr&);   void both(int);
  void tick(const ros::TimerEvent&);  bool serve(std_srvs::SetBool::Request&, std_srvs::SetBool::Response&);
};
void free_callback(const Bool::ConstPtr&);
void f(ros::NodeHandle n, C* c, boost::shared_ptr<C> p, std::string name, std::vector<bool> bits, std::vector<double> list, double d) { %s }
"""

NODE = "ros::NodeHandle::"
RESOLVED = [
    ('n.advertise<Bool>("t", 1);', NODE + "advertise", "ros::Publisher"),
    ('n.advertise<Bool>(name + "/t", d, true);', NODE + "advertise", "ros::Publisher"),
    ('n.advertise<Bool>("t", 1, [](const ros::SingleSubscriberPublisher&) {});', NODE + "advertise", "ros::Publisher"),
    ('n.subscribe("t", 1, &C::plain, c);', NODE + "subscribe", "ros::Subscriber"),
    ('n.subscribe("t", 1, &C::value, c, ros::TransportHints().tcpNoDelay());', NODE + "subscribe", "ros::Subscriber"),
    ('n.subscribe(name, 1, &C::event, p);', NODE + "subscribe", "ros::Subscriber"),
    ('n.subscribe("t", 1, &C::constant, c);', NODE + "subscribe", "ros::Subscriber"),
    ('n.subscribe<Bool>("t", 1, &C::both, c);', NODE + "subscribe", "ros::Subscriber"),
    ('n.subscribe<Bool, C>("t", 1, &C::plain, c);', NODE + "subscribe", "ros::Subscriber"),
    ('n.subscribe("t", 1, free_callback);', NODE + "subscribe", "ros::Subscriber"),
    ('n.subscribe<Bool>("t", 1, boost::bind(&C::plain, c, _1));', NODE + "subscribe", "ros::Subscriber"),
    ('n.subscribe<Bool>("t", 1, std::bind(&C::plain, c, std::placeholders::_1));', NODE + "subscribe", "ros::Subscriber"),
    ('n.subscribe<Bool>("t", 1, [&](const Bool::ConstPtr& m) { d = m->data; });', NODE + "subscribe", "ros::Subscriber"),
    ('n.advertiseService("s", &C::serve, c);', NODE + "advertiseService", "ros::ServiceServer"),
    ('n.serviceClient<std_srvs::SetBool>("s");', NODE + "serviceClient", "ros::ServiceClient"),
    ("n.createTimer(ros::Duration(0.1), &C::tick, c);", NODE + "createTimer", "ros::Timer"),
    ("n.createTimer(ros::Rate(10), [](const ros::TimerEvent&) {}, false, true);", NODE + "createTimer", "ros::Timer"),
    ('n.param("p", d, 1);', NODE + "param", "bool"),
    ('n.param<double>("p", d, 1);', NODE + "param", "bool"),
    ('n.param("p", bits[0], true);', NODE + "param", "bool"),
    ('n.param("p", list, {1.0});', NODE + "param", "bool"),
    ('n.param<std::string>("p", "x");', NODE + "param", "std::basic_string<char>"),
    ('n.param("p", 1.5);', NODE + "param", "double"),
    ('n.getParam(name + "p", d);', NODE + "getParam", "bool"),
    ('n.setParam("p", 1);', NODE + "setParam", "void"),
    ('ros::param::get("p", d);', "ros::param::get", "bool"),
    ('ros::topic::waitForMessage<Bool>("t", n);', "ros::topic::waitForMessage", "boost::shared_ptr<const std_msgs::Bool_>"),
    ('ros::service::waitForService("s", ros::Duration(1));', "ros::service::waitForService", "bool"),
    ("ros::spinOnce();", "ros::spinOnce", "void"),
    ("ros::ok();", "ros::ok", "bool"),
    ('ROS_INFO("%d of %s", 1, name.c_str());', "ros::console::print", "void"),
    ('ROS_WARN_THROTTLE(1.0, "%f", d);', "ros::console::print", "void"),
]  # fmt: skip


@pytest.mark.parametrize(("statement", "name", "result"), RESOLVED)
def test_calls_of_the_client_library_resolve(statement: str, name: str, result: str, flags: list[str]) -> None:
    unit = _parse(ROS % statement, flags)
    assert _errors(unit) == []
    assert _calls(unit)[0] == (name, result)


LIBRARIES = [
    ("tf/transform_listener.h", "tf::TransformListener l; tf::StampedTransform s; l.lookupTransform(\"a\", \"b\", ros::Time(0), s);", "tf::Transformer::lookupTransform"),
    ("tf/transform_broadcaster.h", "tf::TransformBroadcaster b; b.sendTransform(tf::StampedTransform(tf::Transform(), ros::Time::now(), \"a\", \"b\"));", "tf::TransformBroadcaster::sendTransform"),
    ("tf2_ros/transform_listener.h", "tf2_ros::Buffer b; tf2_ros::TransformListener l(b); b.lookupTransform(\"a\", \"b\", ros::Time(0));", "tf2_ros::Buffer::lookupTransform"),
    ("actionlib/server/simple_action_server.h", "actionlib::SimpleActionServer<actionlib::TestAction> s(\"a\", false); s.start();", "actionlib::SimpleActionServer::start"),
    ("actionlib/client/simple_action_client.h", "actionlib::SimpleActionClient<actionlib::TestAction> c(\"a\", true); actionlib::TestGoal g; c.sendGoal(g);", "actionlib::SimpleActionClient::sendGoal"),
    ("image_transport/image_transport.h", "image_transport::ImageTransport t(n); t.advertise(\"i\", 1);", "image_transport::ImageTransport::advertise"),
    ("diagnostic_updater/diagnostic_updater.h", "diagnostic_updater::Updater u; u.add(\"x\", [](diagnostic_updater::DiagnosticStatusWrapper&) {});", "diagnostic_updater::DiagnosticTaskVector::add"),
    ("nodelet/nodelet.h", "struct N : nodelet::Nodelet { void onInit() { NODELET_INFO(\"x\"); getPrivateNodeHandle(); } };", "nodelet::Nodelet::getPrivateNodeHandle"),
    ("rosbag/bag.h", "rosbag::Bag b; b.write(\"t\", ros::Time(1), 5);", "rosbag::Bag::write"),
    ("tl_expected/expected.hpp", "tl::expected<int, std::string> e = tl::unexpected(\"none\"); if (e) *e += e.value(); e.error();", "tl::expected::error"),
    ("boost/geometry/index/rtree.hpp", "namespace bgi = boost::geometry::index; bgi::rtree<int, bgi::rstar<16>> t; for (int i : t) ros::ok(); t.query(bgi::nearest(1, 2), std::back_inserter(*new std::vector<int>));", "boost::geometry::index::rtree::query"),
]  # fmt: skip
TEST_ACTION = """
#include <ros/message_prelude.h>
namespace actionlib {
struct TestGoal { int goal; };
struct TestAction { struct { TestGoal goal; } action_goal; struct { TestGoal result; } action_result; struct { TestGoal feedback; } action_feedback; };
}
"""


@pytest.mark.parametrize(("header", "body", "name"), LIBRARIES, ids=[name for _, _, name in LIBRARIES])
def test_calls_of_ros_libraries_resolve(header: str, body: str, name: str, flags: list[str]) -> None:
    unit = _parse(f"{TEST_ACTION}#include <{header}>\n#include <ros/ros.h>\nvoid f(ros::NodeHandle n) {{ {body} }}", flags)
    assert _errors(unit) == []
    assert name in [call for call, _ in _calls(unit)]


def test_filters_keep_their_callback(flags: list[str]) -> None:
    unit = _parse(
        """
        #include <message_filters/subscriber.h>
        #include <message_filters/synchronizer.h>
        #include <message_filters/sync_policies/approximate_time.h>
        #include <std_msgs/Bool.h>
        typedef message_filters::sync_policies::ApproximateTime<std_msgs::Bool, std_msgs::Bool> Policy;
        struct C {
          void both(const std_msgs::BoolConstPtr&, const std_msgs::BoolConstPtr&);
          void f(ros::NodeHandle n) {
            message_filters::Subscriber<std_msgs::Bool> a(n, "a", 1), b(n, "b", 1);
            message_filters::Synchronizer<Policy> sync(Policy(10), a, b);
            sync.registerCallback(boost::bind(&C::both, this, _1, _2));
          }
        };""",
        flags,
    )
    assert _errors(unit) == []
    assert "message_filters::Synchronizer::registerCallback" in [name for name, _ in _calls(unit)]


def test_plugin_exports_leave_two_typedefs(flags: list[str]) -> None:
    text = "#include <pluginlib/class_list_macros.h>\nstruct B {}; struct P : B {};\nPLUGINLIB_EXPORT_CLASS(P, B)\n"
    unit = _parse(text, flags)
    typedefs = [c for c in unit.cursor.walk_preorder() if c.kind == CursorKind.TYPEDEF_DECL and c.spelling.startswith("rosarch_plugin")]
    assert [(c.spelling.rpartition("_")[0], c.underlying_typedef_type.spelling) for c in typedefs] == [
        ("rosarch_plugin_class", "P"),
        ("rosarch_plugin_base", "B"),
    ]


def test_foreach_is_a_loop_with_its_body(flags: list[str]) -> None:
    text = "#include <boost/foreach.hpp>\n#include <vector>\nvoid g(int);\nvoid f(std::vector<int> v) { BOOST_FOREACH(int x, v) { g(x); } }"
    unit = _parse(text, flags)
    assert _errors(unit) == []
    assert "g" in [name for name, _ in _calls(unit)]


def test_a_callback_parameter_has_its_message_type(flags: list[str]) -> None:
    unit = _parse("#include <std_msgs/Bool.h>\nvoid f(const std_msgs::Bool::ConstPtr& m);", flags)
    (function,) = [c for c in unit.cursor.get_children() if c.spelling == "f"]
    assert next(function.get_arguments()).type.get_canonical().spelling == "const boost::shared_ptr<const std_msgs::Bool_> &"


@pytest.mark.parametrize(
    ("text", "predictable"),
    [
        ('#include <a.h>\n#  include "b.h"\n#define X \\\n  1\n#ifdef A /* c */\n#endif\n', True),
        ("#include H\n", False),
        ("#  \\\ninclude H\n", False),
        ("#include \\\n H\n", False),
        ("#inc\\\nlude H\n", False),
        ("# /* c */ include H\n", False),
        ("#include/**/H\n", False),
        ("/* c */ #include H\n", False),
        ("%:include H\n", False),
        ("#include_next H\n", False),
        ("#ifndef A__TIME_H_\n#ifdef __has_include\n#if __has_include(<a.h>)\n#include <a.h>\n#endif\n#endif\n#endif\n", True),
        ("#if __has_include(<a.h>)\n#include <b.h>\n#endif\n", False),
        ("#if __has_include(H)\n#endif\n", False),
        ("const char* built = __DATE__ __TIME__;\n", False),
    ],
)
def test_includes_that_macros_decide(tmp_path: Path, text: str, predictable: bool) -> None:
    (tmp_path / "a.cpp").write_text(text)
    finder = HeaderFinder(tmp_path, tmp_path / "scratch", lambda _name: None)
    assert finder.closure(tmp_path / "a.cpp").predictable is predictable


@pytest.mark.parametrize("made_by_rosserial", [True, False])
def test_headers_for_microcontrollers_are_none_of_roscpp(tmp_path: Path, made_by_rosserial: bool) -> None:
    library = tmp_path / "firmware" / "ros_lib"
    for name in ("my_msgs/Wheel.h", *(("ros/msg.h",) if made_by_rosserial else ())):
        (library / name).parent.mkdir(parents=True, exist_ok=True)
        (library / name).write_text("")
    (tmp_path / "a.cpp").write_text("#include <my_msgs/Wheel.h>\n")
    missing = HeaderFinder(tmp_path, tmp_path / "scratch", lambda _name: None).closure(tmp_path / "a.cpp").missing
    assert [one.header for one in missing] == (["my_msgs/Wheel.h"] if made_by_rosserial else [])


def test_flags_of_the_command_line_are_variables_with_a_value(flags: list[str]) -> None:
    text = (
        '#include <glog/logging.h>\nDEFINE_string(topic, "scan", "Topic.");\nDEFINE_double(rate, 10., "Rate.");\n'
        "int main(int argc, char** argv) { google::InitGoogleLogging(argv[0]); google::ParseCommandLineFlags(&argc, &argv, true);\n"
        'CHECK(!FLAGS_topic.empty()) << "no topic"; CHECK_GT(FLAGS_rate, 0.); LOG(INFO) << FLAGS_rate; }'
    )
    unit = _parse(text, flags)
    assert _errors(unit) == []
    variables = {cursor.spelling: cursor for cursor in unit.cursor.get_children() if cursor.kind == CursorKind.VAR_DECL}
    literals = [cursor.spelling for cursor in variables["FLAGS_topic"].walk_preorder() if cursor.kind == CursorKind.STRING_LITERAL]
    assert literals == ['"scan"']
    assert variables["FLAGS_rate"].type.spelling == "double"


def test_a_value_of_unknown_type_can_be_handed_over(flags: list[str]) -> None:
    text = f'#include "{HEADERS}/healing.h"\n#include <memory>\nstruct N {{ N(std::unique_ptr<int>, int); }};\nvoid f(rosarch_healed::unknown u) {{ N n(std::move(u), 1); }}'
    assert _errors(_parse(text, flags)) == []
