"""What all tests share: a cache of their own, and the command line in this process."""

from __future__ import annotations

import gc
import os
import time
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from pathlib import Path

import pytest

from rosarch.base.limits import LIMITS, Limits
from rosarch.extractor.underlay import VARIABLES

ROOT = Path(__file__).resolve().parent.parent


FEW = 2  # cases of a test that a quick run has


def pytest_addoption(parser: pytest.Parser) -> None:
    """The option `--quick`."""
    parser.addoption("--quick", action="store_true", help="leave out tests that are marked as slow, and all but a few cases of each other")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """With `--quick`, a few cases of each test that is not slow, as far apart as there are."""
    if not config.getoption("quick"):
        return
    cases: dict[str, list[pytest.Item]] = {}
    for item in items:
        if item.get_closest_marker("slow") is None:
            cases.setdefault(item.nodeid.partition("[")[0], []).append(item)
    chosen = {id(item) for found in cases.values() for item in found[:: -(-len(found) // FEW)]}
    config.hook.pytest_deselected(items=[item for item in items if id(item) not in chosen])
    items[:] = [item for item in items if id(item) in chosen]


@dataclass(frozen=True)
class Outcome:
    """What a command ended with and wrote."""

    code: int
    out: str
    err: str


@pytest.fixture(scope="session", autouse=True)
def nothing_installed() -> Iterator[None]:
    """What is installed on the machine that tests run on is not seen."""
    with pytest.MonkeyPatch.context() as patch:
        for name in (*VARIABLES, "ROS_DISTRO"):
            patch.delenv(name, raising=False)
        patch.setattr("rosarch.extractor.underlay.DISTRIBUTIONS", "/nowhere")
        yield


@pytest.fixture(scope="session", autouse=True)
def cache_folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """What rosarch keeps is kept for this run of the tests, once for all its workers, apart from the user's own."""
    own = tmp_path_factory.getbasetemp()
    folder = (own.parent if "PYTEST_XDIST_WORKER" in os.environ else own) / "cache"
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("ROSARCH_CACHE_DIR", str(folder))
        yield folder


@pytest.fixture(scope="session")
def examples() -> Path:
    """The folder of the example workspaces."""
    return ROOT / "examples"


@pytest.fixture
def rosarch(capfd: pytest.CaptureFixture[str]) -> Callable[..., Outcome]:
    """Run the command line with the given arguments."""
    from rosarch.cli.main import main

    def run(*arguments: object) -> Outcome:
        capfd.readouterr()
        code = main([str(argument) for argument in arguments])
        captured = capfd.readouterr()
        return Outcome(code, captured.out, captured.err)

    return run


@contextmanager
def _at_most(seconds: float) -> Iterator[None]:
    gc.disable()
    start = time.thread_time()
    try:
        yield
        cost = time.thread_time() - start
    finally:
        gc.enable()
    assert cost < seconds


@pytest.fixture
def at_most() -> Callable[[float], AbstractContextManager[None]]:
    """What is done within takes less than some seconds of this thread's processor time.

    Neither other processes count nor the collection of garbage that other tests left, which may take seconds.
    """
    return _at_most


@pytest.fixture
def limits(monkeypatch: pytest.MonkeyPatch) -> Limits:
    """The limits of worker processes, as they were when the test is over."""
    for name, value in vars(LIMITS).items():
        monkeypatch.setattr(LIMITS, name, value)
    return LIMITS


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """A workspace with one package, `talker`, and one node of the same name."""
    package = tmp_path / "ws" / "talker"
    package.mkdir(parents=True)
    (package / "package.xml").write_text(
        '<package format="2"><name>talker</name><version>1.0.0</version><description>d</description>'
        '<maintainer email="m@example.com">m</maintainer><license>BSD</license><buildtool_depend>catkin</buildtool_depend></package>\n'
    )
    (package / "CMakeLists.txt").write_text("project(talker)\nfind_package(catkin)\ncatkin_package()\nadd_executable(talker talker.cpp)\n")
    (package / "talker.cpp").write_text(
        "#include <ros/ros.h>\n"
        "#include <std_msgs/String.h>\n"
        "\n"
        "int main(int argc, char** argv)\n"
        "{\n"
        '  ros::init(argc, argv, "talker");\n'
        "  ros::NodeHandle nh;\n"
        '  ros::Publisher pub = nh.advertise<std_msgs::String>("chatter", 10);\n'
        "  ros::spin();\n"
        "}\n"
    )
    return tmp_path / "ws"
