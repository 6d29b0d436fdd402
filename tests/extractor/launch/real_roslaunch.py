"""Record what the real roslaunch makes of the launch files in features/, as expected.jsonl has it.

    python3 real_roslaunch.py > expected.jsonl

Needs a Python that has roslaunch (Debian: python3-roslaunch), and none of the project. What differs between machines is replaced: the folder
is ROOT, an anonymous name is $(anon name).
"""

import contextlib
import io
import json
import logging
import os
import re
import sys
from pathlib import Path

FEATURES = Path(__file__).resolve().parent / "features"
ENVIRONMENT = {"LAUNCH_TEST_SET": "set", "ROS_MASTER_URI": "http://localhost:11311", "ROS_PACKAGE_PATH": str(FEATURES)}
ARGUMENTS = (
    ("alpha/launch/args.launch", ["plain:=2", "declared_only:=x", "undeclared:=y"]),
    ("alpha/launch/args.launch", ["empty:=a b", "spaces:=$(find alpha)/x"]),
    ("alpha/launch/args.launch", ["__ns:=robot", "_private:=1", "not an argument"]),
    ("alpha/launch/args.launch", ["fixed:=3"]),
    ("alpha/launch/args_special.launch", ["quotes:=$(arg unicode)"]),
    ("alpha/launch/conditions.launch", ["yes:=0", "no:=True"]),
    ("alpha/launch/conditions.launch", ["yes:=maybe"]),
    ("alpha/launch/eval.launch", ["number:=4", "real:=2.0", "word:=5", "flag:=0", "list:=x,y"]),
    ("alpha/launch/include.launch", ["robot:=other", "__ns:=/deep/er/"]),
    ("alpha/launch/include_pass_all.launch", ["robot:=other", "more:=1"]),
    ("alpha/launch/refused_arg_missing.launch", ["robot:=true"]),
    ("alpha/launch/refused_include_needs.launch", ["robot:=true"]),
    ("alpha/launch/rosparam_subst.launch", ["number:=[1, 2]", "robot:=a: b"]),
    ("beta/launch/part.launch", ["robot:=r9"]),
)


def load(path, arguments):
    """What roslaunch has in its memory after loading a file."""
    import roslaunch.config
    import roslaunch.xmlloader

    loader = roslaunch.xmlloader.XmlLoader(resolve_anon=False)
    loader.ignore_unset_args = False
    config = roslaunch.config.ROSLaunchConfig()
    loader.load(str(path), config, verbose=False, argv=arguments)
    plain = (str, int, float, bool, list, dict)
    return {
        "nodes": [
            {
                "package": node.package,
                "type": node.type,
                "name": node.name,
                "namespace": node.namespace,
                "remap": [list(pair) for pair in node.remap_args],
                "args": node.args,
                "respawn": bool(node.respawn),
                "required": bool(node.required),
                "machine": node.machine_name,
                "output": node.output,
                "launch_prefix": node.launch_prefix,
            }
            for node in config.nodes
        ],
        "params": {key: param.value if isinstance(param.value, plain) else str(param.value) for key, param in config.params.items()},
        "tests": len(config.tests),
    }


def stable(record):
    """A record as text, without what differs between machines and runs."""
    text = json.dumps(record, sort_keys=True, ensure_ascii=False).replace(str(FEATURES), "ROOT")
    text = re.sub(r"((?:talker|with_dash_dot|inner|evaluated|n))_\w+?_\d+_\d{10,}", lambda match: f"$(anon {match[1]})", text)
    return text.replace("$(anon with_dash_dot)", "$(anon with-dash.dot)")


def main():
    """Print one record per launch file, and per case of ARGUMENTS."""
    os.environ.update(ENVIRONMENT)
    os.environ.pop("ROS_NAMESPACE", None)
    os.environ.pop("LAUNCH_TEST_UNSET", None)
    logging.disable(logging.CRITICAL)
    cases = [(str(path.relative_to(FEATURES)), None) for path in sorted(FEATURES.rglob("*.launch"))]
    for file, arguments in [*cases, *ARGUMENTS]:
        record = {"file": file} if arguments is None else {"file": file, "arguments": arguments}
        try:
            with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
                record.update(load(FEATURES / file, arguments or []))
        except Exception as error:
            record["exception"] = f"{type(error).__name__}: {str(error).replace(str(FEATURES), 'ROOT')[:300]}"
        sys.stdout.buffer.write((stable(record) + "\n").encode())


if __name__ == "__main__":
    main()
