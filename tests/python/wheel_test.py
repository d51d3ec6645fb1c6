#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The wheel: made, installed into an environment of its own, used there; and its version is the project's.

    wheel_test.py BUILD_DIR SOURCE_DIR      (status 77, skipped, without venv and pip)
"""
import importlib.util
import os
import re
import subprocess
import sys
import tempfile
import tomllib


def main(build, source):
    if not all(importlib.util.find_spec(name) for name in ("venv", "ensurepip", "numpy")):
        return 77
    with open(os.path.join(source, "tools", "python", "pyproject.toml"), "rb") as file:
        version = tomllib.load(file)["project"]["version"]
    with open(os.path.join(source, "CMakeLists.txt"), encoding="utf-8") as file:
        assert re.search(r"project\(tetrarch VERSION (\S+)", file.read())[1] == version, "pyproject.toml has another version"
    with tempfile.TemporaryDirectory() as folder:
        wheel = subprocess.run([sys.executable, os.path.join(source, "tools", "python", "make_wheel"), build, folder], check=True,
                               capture_output=True, text=True).stdout.strip()
        print(os.path.basename(wheel), os.path.getsize(wheel) // 1000, "kB")
        place = os.path.join(folder, "place")
        subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", place], check=True)
        subprocess.run([os.path.join(place, "bin", "pip"), "install", "--no-index", "--no-deps", "-q", wheel], check=True)
        code = ("import tetrarch as tt, tetrarch.commands; print(tt.__file__, tt.__version__, tt.Manifold('m004').identify().name, "
                "len(tt.Mesh.read('samples/cube.off').points))")
        environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
        said = subprocess.run([os.path.join(place, "bin", "python"), "-c", code], check=True, capture_output=True, text=True,
                              cwd=folder, env=environment).stdout
        assert said.startswith(place) and version in said and "m004" in said and said.endswith(" 8\n"), said
        listed = subprocess.run([os.path.join(place, "bin", "pip"), "show", "-f", "tetrarch"], check=True, capture_output=True,
                                text=True).stdout
        assert "tetrarch/py.typed" in listed and "tetrarch/commands.pyi" in listed, listed
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
