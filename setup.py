"""Builds the extension circumspect._core by CMake, and collects the licences of what is compiled into it. All else is
in pyproject.toml.

CIRCUMSPECT_BUILD names a build that has been configured with -DCIRCUMSPECT_BUILD_PYTHON=ON, which is then used.
"""
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent
VERSION = re.search(r"VERSION (\S+) LANGUAGES", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]


def require_what_makes_wheels():
    """setuptools does so by itself since 70.1; before, the package wheel does, and pip's own message does not say so."""
    if any(importlib.util.find_spec(name) for name in ("setuptools.command.bdist_wheel", "wheel")):
        return
    raise SystemExit(f"expected setuptools of 70.1 or later, or the package wheel, beside {sys.executable}; found "
                     "neither. Debian's Python has it (/usr/bin/python3, python3-wheel); any other Python gets it from "
                     "pip, without --no-build-isolation")


class BuildByCMake(build_ext):
    """Configures, builds, and takes what was built."""

    def build_extension(self, ext):
        build = os.environ.get("CIRCUMSPECT_BUILD")
        if build is None:
            build = ROOT / "build" / "python"
            subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                            f"-DPython3_EXECUTABLE={sys.executable}", "-DCIRCUMSPECT_QUICK_BUILD=ON",
                            "-DCIRCUMSPECT_BUILD_PYTHON=ON", "-DCIRCUMSPECT_BUILD_TESTS=OFF",
                            "-DCIRCUMSPECT_BUILD_COMMAND=OFF"], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "circumspect_python"], check=True)
        built = next(pathlib.Path(build, "python", "circumspect").glob("_core.*.so"))
        target = pathlib.Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(built, target)
        subprocess.run(["strip", "--strip-unneeded", target], check=True)
        self.collect_licences(target.parent / "licences")

    def collect_licences(self, folder):
        """Puts the licences of what is compiled into the extension beside it."""
        made = subprocess.run([ROOT / "cmake" / "licences.sh", "wheel", folder], check=False)
        if made.returncode != 0:
            shutil.rmtree(folder, ignore_errors=True)
            print("warning: this build lacks the licences of its libraries, so it is not to be passed on", file=sys.stderr)


if "sdist" not in sys.argv:
    require_what_makes_wheels()
setup(version=VERSION, ext_modules=[Extension("circumspect._core", [])], cmdclass={"build_ext": BuildByCMake})
