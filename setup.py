"""The build: the folders that are packages, and the rules compiled, so that the user who installs a wheel need not do it."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from setuptools import find_packages, setup
from setuptools.command.build_py import build_py

NO_PACKAGES = ["benchmarks", "build", "docs", "examples", "tests"]
FOUND = [name for name in find_packages() if name.partition(".")[0] not in NO_PACKAGES]


class BuildWithRules(build_py):
    """Builds the packages, then runs them on their rules."""

    def run(self) -> None:
        super().run()
        if not self.editable_mode:
            with tempfile.TemporaryDirectory() as cache:
                required = os.environ.get("PYTHONPATH")  # what the build requires, as pip passes it
                path = os.pathsep.join(filter(None, [str(Path(self.build_lib).absolute()), required]))
                variables = {"PYTHONPATH": path, "ROSARCH_CACHE_DIR": cache}
                subprocess.run([sys.executable, "-m", "rosarch.rule_programs.compile"], env=os.environ | variables, check=True)


setup(
    # each folder with an __init__.py is a package of this name below rosarch: cli/ is rosarch.cli
    packages=[f"rosarch.{name}" for name in FOUND],
    package_dir={f"rosarch.{name}": name for name in FOUND if "." not in name},
    cmdclass={"build_py": BuildWithRules},
)
