"""The report in a real browser: every page and control, by mouse and keyboard, light and dark, narrow, with hostile names."""

from __future__ import annotations

import base64
import json
import math
import re
import shutil
import subprocess
import sys
import urllib.error
import urllib.request
import zlib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from rosarch.reports.html.page import page_text

playwright = pytest.importorskip("playwright.sync_api")
axe = pytest.importorskip("axe_playwright_python.sync_playwright")
expect = playwright.expect

BROWSER = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
pytestmark = [pytest.mark.slow, pytest.mark.skipif(BROWSER is None, reason="needs Chromium")]

HOSTILE = "</script><img src=x onerror=window.pwned=1>\"'`${window.pwned=2}{{3&lt;\u202e"
LONG = "/" + "a" * 10_000
NODE = """\
#include <ros/ros.h>
#include <std_msgs/String.h>
ros::Publisher pub;
void onTimer(const ros::TimerEvent&) {{ pub.publish(std_msgs::String()); }}
bool seen_ = false;
void onText(const std_msgs::String::ConstPtr& text)
{{
  if (text->data == "{bad}") {{ seen_ = true; pub.publish(text); }}
}}
int main(int argc, char** argv)
{{
  ros::init(argc, argv, "hostile");
  ros::NodeHandle nh;
  std::string name;
  ros::param::param<std::string>("~{bad}", name, "{bad}");
  ros::Subscriber sub = nh.subscribe("{bad}", 1, onText);
  pub = nh.advertise<std_msgs::String>("{long}", 10);
  ros::Timer timer = nh.createTimer(ros::Duration(2.0), onTimer, true);
  ros::spin();
}}
"""


def hostile_package(folder: Path) -> None:
    from xml.sax.saxutils import quoteattr

    folder.mkdir()
    (folder / "package.xml").write_text(
        '<package format="2"><name>hostile</name><version>1.0.0</version><description>d</description>'
        '<maintainer email="m@example.com">m</maintainer><license>BSD</license><buildtool_depend>catkin</buildtool_depend></package>\n'
    )
    (folder / "CMakeLists.txt").write_text(
        "project(hostile)\nfind_package(catkin)\ncatkin_package()\nadd_executable(hostile hostile.cpp)\n"
    )
    (folder / "hostile.cpp").write_text(NODE.format(bad=HOSTILE.replace('"', '\\"'), long=LONG))
    name = quoteattr(HOSTILE)
    (folder / "hostile.launch").write_text(
        f'<launch><node name="h" pkg="hostile" type="hostile"><param name="k" value={name}/></node>'
        f"<node name={quoteattr(LONG[1:])} pkg={name} type={name}/><include file={name}/></launch>\n"
    )


@pytest.fixture(scope="module")
def report(examples: Path, tmp_path_factory: pytest.TempPathFactory) -> str:
    """The address of a report on a workspace with mistakes, state machines, chains, and names that nobody means well with."""
    from rosarch.cli.main import main

    workspace = tmp_path_factory.mktemp("browser") / "workspace"
    for example in ("delivery_robot", "docking_states", "elevator"):
        shutil.copytree(examples / example / "src", workspace / example)
    hostile_package(workspace / "hostile")
    out = workspace.parent / "report.html"
    assert main(["report", str(workspace), "-o", str(out), "--source-url", "https://example.org/{path}#L{line}"]) == 0
    return out.as_uri()


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with playwright.sync_playwright() as started:
        browser = started.chromium.launch(executable_path=BROWSER, args=["--no-sandbox"])
        yield browser
        browser.close()


class Reader:
    """A page, and all that it should not do."""

    def __init__(self, page: Any, address: str) -> None:
        self.page, self.address = page, address
        self.wrong: list[str] = []
        page.set_default_timeout(10_000)
        page.on("console", lambda message: self.wrong.append(message.text))
        page.on("pageerror", lambda error: self.wrong.append(str(error)))
        page.on("dialog", lambda dialog: self.wrong.append(dialog.message))
        page.on("request", lambda request: request.url.startswith(("file:", "blob:")) or self.wrong.append(request.url))

    def open(self, where: str) -> Any:
        self.page.goto(f"{self.address}#/{where}")
        expect(self.page.locator("h1").first).to_be_attached()
        if where.startswith("graph"):
            expect(self.page.locator(".stage[aria-busy=false] svg.graph .box").first).to_be_attached(timeout=60_000)
        return self.page

    def check(self) -> None:
        assert self.page.evaluate("window.pwned") is None
        assert self.wrong == []


@pytest.fixture
def reader(browser: Any, report: str, request: pytest.FixtureRequest) -> Iterator[Reader]:
    options = {"viewport": {"width": 1280, "height": 800}} | getattr(request, "param", {})
    context = browser.new_context(**options)
    reader = Reader(context.new_page(), report)
    yield reader
    reader.check()
    context.close()


DELIVERY = "delivery_robot/delivery_bringup/launch/delivery.launch"
ELEVATOR = "elevator/elevator/launch/elevator.launch.xml"
PAGES = (
    "", "component/elevator/panel", "components", "component/delivery_robot/courier", "component/auto_docking/docking", "component/hostile/hostile", "component/no/such",
    "findings", f"graph?system={DELIVERY}", "graph?system=hostile/hostile.launch&implicit=1&kinds=topic,service,action,tf", "launch",
    "launch?system=hostile/hostile.launch", f"timing?system={DELIVERY}", "nowhere",
)  # fmt: skip
DARK = ("", "component/auto_docking/docking", "findings", f"graph?system={DELIVERY}&at=node:0", f"timing?system={DELIVERY}")
"""Pages that have all colours between them."""
THEMES = [({"color_scheme": "light"}, PAGES), ({"color_scheme": "dark"}, DARK)]


@pytest.mark.parametrize(("reader", "pages"), THEMES, indirect=["reader"], ids=["light", "dark"])
def test_every_page_is_accessible(reader: Reader, pages: tuple[str, ...]) -> None:
    for where in pages:
        page = reader.open(where)
        if where.endswith("docking"):
            expect(page.locator("svg.machine")).to_be_visible()
        page.evaluate("for (const fold of [...document.querySelectorAll('main details')].slice(0, 4)) fold.open = true")
        assert violations(page) == {}, where
    page = reader.open("component/auto_docking/docking")
    for button in (page.locator("#ports .place").first, page.locator("#ports .why").first):
        button.click()
        expect(page.get_by_role("dialog").locator(".excerpt, .proof-tree").first).to_be_visible()
        assert violations(page) == {}
        page.keyboard.press("Escape")


def violations(page: Any) -> dict[str, list[str]]:
    """What axe finds serious: the rule, and examples."""
    found = [each for each in axe.Axe().run(page).response["violations"] if each["impact"] in ("serious", "critical")]
    return {each["id"]: [node["html"][:160] for node in each["nodes"][:3]] for each in found}


@pytest.mark.parametrize("reader", [{"viewport": {"width": 360, "height": 740}}], indirect=True, ids=["narrow"])
def test_narrow_windows_show_everything(reader: Reader) -> None:
    for where in PAGES:
        page = reader.open(where)
        assert page.evaluate("document.documentElement.scrollWidth <= innerWidth"), where
    page = reader.open(f"graph?system={DELIVERY}")
    page.locator(".box", has_text="/courier").click()
    panel = page.get_by_role("complementary").bounding_box()
    assert panel["x"] >= 0 and panel["x"] + panel["width"] <= 360


def test_graph_shows_ports_connectors_and_details(reader: Reader) -> None:
    page = reader.open(f"graph?system={DELIVERY}")
    courier = page.locator(".box", has_text="/courier")
    expect(courier.locator(".port")).to_have_count(5)
    expect(courier.locator(".port.hollow")).to_have_count(3)
    expect(page.locator(".connector.kind-service.one-sided", has_text="/open_box").first).to_be_attached()
    page.locator(".connector", has_text="/battery").hover()
    expect(page.get_by_role("tooltip")).to_contain_text("std_msgs/Float32")
    expect(page.get_by_role("tooltip")).to_contain_text("courier.cpp:18")
    expect(page.locator(".box.lit")).to_have_count(2)
    courier.click()
    details = page.get_by_role("complementary")
    expect(details).to_contain_text("sensor_msgs/BatteryState")
    expect(page).to_have_url(re.compile("at=node"))
    details.get_by_role("button", name="Only what is near").click()
    expect(page.locator(".box", has_text="/obstacle_detector")).to_have_count(0)
    page.reload()
    expect(page.locator(".box.selected", has_text="/courier")).to_have_count(1)
    page.get_by_label("How many connectors away").select_option("3")
    page.get_by_role("button", name="Show all").click()
    expect(page.locator(".box", has_text="/obstacle_detector")).to_have_count(1)
    details.get_by_role("link", name="Open component").click()
    expect(page.get_by_role("heading", level=1)).to_have_text("courier")


def near(transform: str) -> re.Pattern[str]:
    """The same but for what is lost by rounding to whole pixels of the drawing."""
    x, y = re.findall(r"-?[0-9.]+", transform)[:2]
    around = [f"(?:{'|'.join(str(math.floor(float(value)) + step) for step in (-1, 0, 1, 2))})" for value in (x, y)]
    return re.compile(rf"translate\({around[0]}(?:\.\d+)? {around[1]}(?:\.\d+)?\) scale")


def settled(page: Any) -> str:
    """Where the graph lies once it is laid out and fitted."""
    expect(page.locator(".stage[aria-busy=false] svg.graph")).to_be_visible(timeout=60_000)
    page.get_by_role("button", name="Fit").click()
    return str(page.locator("svg.graph > g").get_attribute("transform"))


def test_graph_controls(reader: Reader) -> None:
    page = reader.open(f"graph?system={DELIVERY}")
    boxes, connectors = page.locator(".box"), page.locator(".connector")
    page.get_by_role("button", name="services").click()
    expect(page.locator(".connector.kind-service")).to_have_count(0)
    page.get_by_text("View", exact=True).click()
    page.get_by_label("Connectors with a sender or a receiver only").uncheck()
    expect(page.locator(".one-sided")).to_have_count(0)
    page.get_by_label("Only nodes with findings").check()
    expect(page.locator(".box:not(:has(.flag))")).to_have_count(0)
    page.get_by_label("Only nodes with findings").uncheck()
    page.get_by_label("Group nodes by").select_option("package")
    frame = page.locator(".frame-title", has_text="delivery_robot")
    frame.press("Enter")
    expect(page.locator(".box.group")).to_have_count(1)
    page.locator(".box.group").click()
    page.get_by_role("button", name="Open the group").click()
    expect(frame).to_be_visible()
    page.get_by_label("Find name, type, package").fill("std_msgs/Float32")
    expect(page.locator(".connector:not(.pale)")).to_have_count(1)
    page.get_by_role("button", name="only these").click()
    expect(boxes).to_have_count(2)
    assert connectors.count() >= 1
    before = settled(page)
    for name in ("Zoom in", "Zoom out", "Fit"):
        page.get_by_role("button", name=name).click()
    page.mouse.move(640, 500)
    page.mouse.wheel(0, -300)
    page.mouse.down()
    page.mouse.move(700, 550)
    page.mouse.up()
    moved = page.locator("svg.graph > g").get_attribute("transform")
    assert moved != before
    page.wait_for_url("**view=*")
    page.reload()
    expect(page.locator("svg.graph > g")).to_have_attribute("transform", near(moved), timeout=60_000)
    page.get_by_role("button", name="Fit").click()
    expect(page.locator("svg.graph > g")).to_have_attribute("transform", near(before))
    expect(page).not_to_have_url(re.compile("view="))
    page.get_by_role("combobox", name="System", exact=True).select_option("hostile/hostile.launch")
    expect(page.locator(".stage[aria-busy=false] svg.graph")).to_be_visible()


def test_keyboard_alone_leads_everywhere(reader: Reader) -> None:
    page = reader.open("")
    keys = page.keyboard
    keys.press("Tab")
    expect(page.locator(":focus")).to_have_text("Skip to content")
    for _ in range(3):
        keys.press("Tab")
    expect(page.locator(":focus")).to_have_text("Graph")
    keys.press("Enter")
    expect(page.locator(".stage[aria-busy=false] svg.graph .box").first).to_be_attached(timeout=60_000)
    keys.press("/")
    expect(page.locator(":focus")).to_have_attribute("aria-label", "Find name, type, package")
    page.locator("svg.graph").focus()
    scene = page.locator("svg.graph > g")
    seen = []
    for key in ("+", "-", "ArrowLeft", "ArrowDown", "0"):
        keys.press(key)
        seen.append(scene.get_attribute("transform"))
    assert len(set(seen)) >= 4
    keys.press("Tab")
    assert page.locator(":focus").get_attribute("data-id")
    keys.press(" ")
    expect(page.locator(".selected")).to_have_count(1)
    keys.press("Escape")
    expect(page.locator(".selected")).to_have_count(0)
    page.locator(".box", has_text="/courier").focus()
    keys.press("Enter")
    expect(page.get_by_role("heading", level=1)).to_have_text("courier")
    page.locator("#ports .place").first.focus()
    keys.press("Enter")
    dialog = page.get_by_role("dialog")
    expect(dialog).to_contain_text("advertise")
    keys.press("Escape")
    expect(dialog).to_be_hidden()


def test_findings_lead_to_the_source(reader: Reader) -> None:
    page = reader.open("findings")
    page.get_by_role("button", name="warnings").click()
    page.get_by_role("button", name="notes").click()
    expect(page.locator(".finding.error").first).to_be_visible()
    expect(page.locator(".finding.warning, .finding.note")).to_have_count(0)
    page.get_by_label("Check", exact=True).select_option("topic-type-mismatch")
    page.get_by_label("Filter by text").fill("battery")
    expect(page.locator(".finding")).to_have_count(1)
    page.reload()
    page.locator(".finding > summary").click()
    expect(page.locator(".finding mark").first).to_have_text("nh_.subscribe")
    expect(page.locator(".hint")).to_contain_text("Use one message type")
    link = page.locator(".finding a.place").first
    assert link.get_attribute("href") == "https://example.org/delivery_robot/delivery_robot/src/courier.cpp#L18"
    page.get_by_text("The rules and facts that tell this").click()
    expect(page.locator(".proof-tree").first).to_contain_text("rules/checks/topic-type-mismatch.dl")
    link.click()
    expect(page.get_by_role("dialog")).to_contain_text("battery_sub_")
    page.get_by_role("button", name="Close").click()
    page.get_by_label("System", exact=True).select_option(DELIVERY)
    page.get_by_label("Check", exact=True).select_option("")
    page.get_by_label("Filter by text").fill("no such thing")
    expect(page.locator(".finding")).to_have_count(0)


def test_state_machines_lead_to_the_source(reader: Reader) -> None:
    page = reader.open("component/auto_docking/docking")
    machine = page.locator("svg.machine")
    expect(machine.locator(".state .title")).to_have_text(["IDLE", "SEARCHING", "APPROACHING", "FAILED", "DOCKED", "any state"])
    beacon = machine.locator(".effect", has_text="beacon").first
    expect(beacon.locator("text")).to_have_text(["beacon", "[beacon->point.x < range_]", "→ ~state"])
    beacon.press("Enter")
    expect(page.get_by_role("dialog")).to_contain_text("docking.cpp:51")
    page.get_by_role("button", name="Close").click()
    page.get_by_role("button", name="Why: publisher ~state").click()
    expect(page.get_by_role("dialog").locator(".proof-tree").first).to_contain_text("rules/core/ports/ports.dl")
    page.locator("dialog .proof > summary").nth(1).press("Enter")
    expect(page.get_by_role("dialog")).to_contain_text("api_port(")
    page.keyboard.press("Escape")
    page.get_by_text("Transitions as a table").click()
    expect(page.get_by_role("table").filter(has_text="stays").first).to_be_visible()


WITHOUT_PROOF = """async () => {
  const failed = [];
  const wait = () => new Promise((done) => setTimeout(done, 10));
  const until = async (holds) => { for (let tries = 0; !holds() && tries < 500; tries++) await wait(); };
  const dialog = () => document.querySelector('dialog[open]');
  const buttons = [...document.querySelectorAll('main button.why')];
  for (const button of buttons) {
    button.click();
    await until(() => dialog()?.querySelector('.proof-body') && !/Reading the proofs/.test(dialog().textContent));
    if (!dialog().querySelector('.proof-tree')) failed.push(button.ariaLabel);
    dialog().querySelector('button').click();
    await until(() => !dialog());
  }
  return [buttons.length, failed];
}"""
"""How many things of a page have a button that asks why, and those whose question has no answer."""


def test_whatever_is_shown_leads_to_its_derivation(reader: Reader) -> None:
    least = {
        "component/auto_docking/docking": 20,
        "component/hostile/hostile": 5,
        "component/elevator/cabin_node": 10,
        f"graph?system={DELIVERY}&at=connector:topic:/battery": 2,
        f"graph?system={DELIVERY}&at=node:0": 3,
        f"launch?system={DELIVERY}": 3,
        f"timing?system={DELIVERY}": 3,
    }
    for where, most in least.items():
        page = reader.open(where)
        page.locator("main button.why").first.wait_for(state="attached")
        asked, failed = page.evaluate(WITHOUT_PROOF)
        assert (asked >= most, failed) == (True, []), where


def test_nodes_of_ros_2_have_their_qualities(reader: Reader) -> None:
    page = reader.open("component/elevator/cabin_node")
    expect(page.locator(".lead")).to_contain_text("component of ROS 2")
    expect(page.locator("main")).to_contain_text("elevator::Cabin")
    cells = page.get_by_role("region", name="Ports", exact=True).locator("tr", has_text="floor").locator("td")
    expect(cells.nth(3)).to_have_text("last 1, transient local")
    page = reader.open("component/elevator/door")
    expect(page.locator(".lead")).to_contain_text("lifecycle node of ROS 2")
    page = reader.open("component/elevator/panel")
    expect(page.locator("main")).to_contain_text("The program makes 2 nodes: buttons, display")
    expect(page.locator(".started li")).to_have_count(2)
    page.get_by_role("link", name="display", exact=True).click()
    expect(page.locator("main")).to_contain_text("One of the nodes of the program panel")
    page = reader.open("components?filter=lifecycle")
    expect(page.locator("tbody tr")).to_have_count(1)
    page = reader.open(f"graph?system={ELEVATOR}&at=connector:topic:/floor")
    expect(page.get_by_role("complementary")).to_contain_text("last 1")


def test_timers_that_run_once(reader: Reader) -> None:
    page = reader.open("component/hostile/hostile")
    cells = page.get_by_role("region", name="Timers that run once").locator("tbody td")
    expect(cells.nth(0)).to_have_text("2 s")
    expect(cells.nth(2)).to_have_text("always")


def test_chains_are_found_and_lit(reader: Reader, report: str, tmp_path: Path) -> None:
    page = reader.open(f"timing?system={DELIVERY}")
    expect(page.locator("main")).to_contain_text("--chains")
    reader.address = changed(report, tmp_path / "chains.html", add_step)
    page = reader.open(f"timing?system={DELIVERY}")
    page.get_by_label("What passes through").select_option(label="/drive /battery")
    page.get_by_label("has an influence on").select_option(label="/courier /battery")
    expect(page.locator(".chain > li")).to_have_count(1)
    page.locator(".chain .why").click()
    expect(page.get_by_role("dialog").locator(".proof-tree").first).to_contain_text("connected(")
    page.get_by_role("dialog").get_by_role("link", name="drive.cpp:1").click()
    expect(page.get_by_role("dialog", name="Source")).to_contain_text("drive.cpp")
    page.keyboard.press("Escape")
    page.keyboard.press("Escape")
    page.get_by_label("Filter by topic").fill("battery")
    expect(page.get_by_role("region", name="Rates of topics").locator("tbody tr")).to_have_count(1)
    page.get_by_role("link", name="Show it in the graph").click()
    expect(page.locator(".box.lit")).to_have_count(2, timeout=60_000)
    page.get_by_role("button", name="Clear").click()
    expect(page.locator(".lit")).to_have_count(0)


def add_step(document: Any) -> None:
    """A chain: the battery's messages arrive, with a proof of that."""
    system = next(system for system in document["systems"] if system["name"] == DELIVERY)
    battery = next(connector for connector in system["connectors"] if connector["name"] == "/battery")
    ends = (battery["sources"][0], battery["sinks"][0])
    system["steps"] = [[*ends, "data", "connection", True]]
    nodes = [(system["nodes"][node], system["nodes"][node]["ports"][port]) for node, port in ends]
    key = " > ".join(f"{node['id']} {node['component']}#{port['id']}" for node, port in nodes)
    steps = [["chain_step(...)", "rules/system/chains.dl:1", [1], 0], ["connected(...)", "input", [], 0, 0]]
    document["proofs"] = {"steps": steps, "roots": {DELIVERY: {f"chain_step {key}": 0}}, "places": ["drive.cpp:1"]}


def test_groups_have_the_flag_of_their_worst_finding(reader: Reader, report: str, tmp_path: Path) -> None:
    reader.address = changed(report, tmp_path / "flags.html", only_the_last_node_has_errors)
    page = reader.open(f"graph?system={DELIVERY}&by=package&groups=delivery_robot")
    expect(page.locator(".box.group .flag.error")).to_have_count(1)


def only_the_last_node_has_errors(document: Any) -> None:
    for finding in document["findings"]["shown"]:
        finding["severity"] = "error" if finding["check"] == "duplicate-node" else "note"


def test_what_a_timed_loop_calls_is_shown_with_what_it_publishes(reader: Reader, report: str, tmp_path: Path) -> None:
    def add_call(document: Any) -> None:
        (component,) = (each for each in document["components"] if each["name"] == "auto_docking/docking")
        (called,) = (port["id"] for port in component["ports"] if port["name"] == "~cancel")
        component["periodic"][0]["calls"] = [called]

    reader.address = changed(report, tmp_path / "calls.html", add_call)
    page = reader.open("component/auto_docking/docking")
    expect(page.get_by_label("Timed loops and timers").locator("tbody td").nth(2)).to_have_text("cmd_vel, ~cancel")


def changed(report: str, out: Path, change: Callable[[Any], None]) -> str:
    """The address of a report whose document is another."""
    block = re.search(r'id="document">([^<]*)<', Path(report.removeprefix("file://")).read_text(encoding="utf-8"))
    document = json.loads(zlib.decompress(base64.b64decode(block[1])))  # type: ignore[index]
    change(document)
    out.write_text(page_text(document), encoding="utf-8")
    return out.as_uri()


def test_themes_can_be_chosen_and_pages_printed(reader: Reader) -> None:
    page = reader.open("component/auto_docking/docking")
    body, color = page.locator("body"), "background-color"
    light = page.evaluate("getComputedStyle(document.body).backgroundColor")
    page.locator("button.theme").click()
    expect(body).to_have_css(color, light)
    page.locator("button.theme").click()
    expect(body).not_to_have_css(color, light)
    page.reload()
    expect(body).not_to_have_css(color, light)
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    expect(page.locator("main details:not([open], .proof)")).to_have_count(0)
    page.emulate_media(media="print")
    expect(page.locator("header.top")).to_be_hidden()
    expect(body).to_have_css(color, "rgb(255, 255, 255)")
    assert len(page.pdf()) > 10_000


def test_hostile_names_are_texts(reader: Reader) -> None:
    page = reader.open("component/hostile/hostile")
    expect(page.locator("#ports")).to_contain_text("</script><img src=x onerror=window.pwned=1>")
    assert page.locator("main img").count() == 0
    assert all(box["height"] < 400 for box in (row.bounding_box() for row in page.locator("#ports tr").all()))
    page = reader.open("graph?system=hostile/hostile.launch")
    expect(page.locator(".box", has_text="</script>")).to_have_count(1)
    assert max(box.bounding_box()["width"] for box in page.locator(".box").all()) < 600


def test_served_reports_follow_what_is_saved(browser: Any, examples: Path, tmp_path: Path) -> None:
    pytest.importorskip("watchfiles")
    workspace = shutil.copytree(examples / "mobile_base", tmp_path / "workspace")
    command = [sys.executable, "-m", "rosarch.cli", "serve", str(workspace), "--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as serving:
        try:
            address = serving.stdout.readline().strip()  # type: ignore[union-attr]
            page = browser.new_page()
            page.goto(f"{address}#/component/base_driver/base_driver")
            expect(page.locator("#ports")).to_contain_text("wheel_ticks", timeout=60_000)
            source = workspace / "src/base_driver/src/base_driver.cpp"
            text = source.read_text()
            source.write_text(text.replace('"wheel_ticks"', '"encoder_ticks"'))
            expect(page.locator("#ports")).to_contain_text("encoder_ticks", timeout=60_000)
            (workspace / ".rosarch.yml").write_text("nonsense: 1\n")
            expect(page.get_by_role("alert")).to_contain_text("unknown setting `nonsense`", timeout=60_000)
            expect(page.locator("#ports")).to_contain_text("encoder_ticks")
            request = urllib.request.Request(address, headers={"Host": "elsewhere.example"})
            with pytest.raises(urllib.error.HTTPError, match="403"):
                urllib.request.urlopen(request)
            page.close()
        finally:
            serving.terminate()
