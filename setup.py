"""The build: what pyproject.toml says, and the rules compiled, so that whoever installs a wheel need not do it."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from setuptools import setup
from setuptools.command.build_py import build_py


class BuildWithRules(build_py):
    """Builds the packages, then runs them on their rules."""

    def run(self) -> None:
        super().run()
        if not self.editable_mode:
            with tempfile.TemporaryDirectory() as cache:
                required = os.environ.get("PYTHONPATH")  # what the build requires, as pip tells it
                path = os.pathsep.join(filter(None, [str(Path(self.build_lib).absolute()), required]))
                variables = {"PYTHONPATH": path, "ROSARCH_CACHE_DIR": cache}
                subprocess.run([sys.executable, "-m", "rosarch.models.compile_rules"], env=os.environ | variables, check=True)


setup(cmdclass={"build_py": BuildWithRules})
