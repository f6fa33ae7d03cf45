"""Builds the extension circumspect._core by CMake, and collects the licences of what is in it. All else is in
pyproject.toml.

These variables are for those who have built something already:
  CIRCUMSPECT_BUILD     a build that was configured with -DCIRCUMSPECT_BUILD_PYTHON=ON: it is used instead of one here
  CIRCUMSPECT_VERIFIED  circumspect-verified, linked with the C library alone, which goes along
  CIRCUMSPECT_PLATFORM  a tag such as "manylinux_2_34_x86_64", on which the wheel runs (packaging/wheel.sh)
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
VERIFIED = os.environ.get("CIRCUMSPECT_VERIFIED")
PLATFORM = os.environ.get("CIRCUMSPECT_PLATFORM")
VERSION = re.search(r"VERSION (\S+) LANGUAGES", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
SOURCE = re.search(r'Source = "(\S+)"', (ROOT / "pyproject.toml").read_text(encoding="utf-8"))[1]
HAS_STABLE_INTERFACE = sys.version_info >= (3, 11)  # with arrays; one wheel then serves all later Pythons


def readme():
    """As an index shows it: links lead to the sources of this version, and pictures are shown."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    text = re.sub(r"(!\[[^\]]*\]\()(?!https?://|#)", rf"\1{SOURCE}/raw/v{VERSION}/", text)
    return re.sub(r"((?<!!)\[[^\]]*\]\()(?!https?://|#)", rf"\1{SOURCE}/blob/v{VERSION}/", text)


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
                            "-DCIRCUMSPECT_BUILD_PYTHON=ON", "-DCIRCUMSPECT_PYTHON_COMMAND=ON",
                            "-DCIRCUMSPECT_BUILD_TESTS=OFF"], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "circumspect_python"], check=True)
        built = next(pathlib.Path(build, "python", "circumspect").glob("_core.*.so"))
        target = pathlib.Path(self.get_ext_fullpath(ext.name)).with_name(built.name)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(built, target)
        subprocess.run(["strip", "--strip-unneeded", target], check=True)
        if VERIFIED:
            program = target.parent / "bin" / "circumspect-verified"
            program.parent.mkdir(exist_ok=True)
            shutil.copy(VERIFIED, program)
            subprocess.run(["strip", program], check=True)
        self.collect_licences(target.parent / "licences")

    def collect_licences(self, folder):
        """Puts the licences of all that is linked beside it."""
        made = subprocess.run([ROOT / "cmake" / "licences.sh", "archive" if VERIFIED else "wheel", folder], check=False)
        if made.returncode != 0:
            shutil.rmtree(folder, ignore_errors=True)
            print("warning: this build lacks the licences of its libraries, so it is not to be passed on", file=sys.stderr)


if "sdist" not in sys.argv:
    require_what_makes_wheels()
tag = {**({"py_limited_api": "cp311"} if HAS_STABLE_INTERFACE else {}), **({"plat_name": PLATFORM} if PLATFORM else {})}
setup(version=VERSION, long_description=readme(), long_description_content_type="text/markdown",
      ext_modules=[Extension("circumspect._core", [], py_limited_api=HAS_STABLE_INTERFACE)],
      cmdclass={"build_ext": BuildByCMake}, options={"bdist_wheel": tag} if tag else {})
