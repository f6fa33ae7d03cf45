#!/usr/bin/env python3
"""The tests of what has changed since the last green run: `make check`.

    check.py BUILD_FOLDER [--jobs N]      builds what they need, runs them; green if all pass
    check.py BUILD_FOLDER --green         remembers that everything is green now (`make test` does)

Each test is about some files. A unit test is about the folder that it stands in, a property about the folders
whose headers it includes, the tests of the corpus and of the pages about everything that the command links.
A test runs if a file has changed that it is about, or the test itself. Slow tests are left to `make test`,
which runs everything.
"""
import argparse
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys

import tidy

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([\w./]+/[\w.]+)[">]', re.MULTILINE)
# What the tests of the command, of the corpus, of the pages and of Python see, beside the folders below.
DATA = ("corpus/", "docs/", "README.md", "tidy/", "c/", "python/", "include/", "examples/")
SHIPPED = ("reference/", "inputs/", "oracle/", "fuzz/campaign/", "fuzz/process/", "oracle/", "command/")


def digests():
    """The content of every file of the project, by its path."""
    return {path: hashlib.sha1((ROOT / path).read_bytes()).hexdigest()
            for path in tidy.files(str(ROOT)) if not path.startswith("proofs/")}


def folder(path):
    return path.rpartition("/")[0]


def included_folders(path, seen):
    """The folders of the headers that a file includes, through headers of its own folder too."""
    folders = set()
    if path in seen or not (ROOT / path).is_file():
        return folders
    seen.add(path)
    for target in INCLUDE.findall((ROOT / path).read_text(encoding="utf-8")):
        if target.startswith("circumspect/"):
            target = "include/" + target
            folders.add("fuzz/harness")
        folders.add(folder(target))
        if folder(target) == folder(path):
            folders |= included_folders(target, seen)
    return folders


def is_about(test, changed):
    """Is the test about one of the changed files?"""
    source = test["name"] + ".cpp"
    if source in changed:
        return True
    if not (ROOT / source).is_file():  # scripts: the corpus, the pages, the examples
        return any(path.startswith(DATA + SHIPPED) for path in changed)
    room = folder(source)
    if room.startswith(("corpus", "command")):
        return any(path.startswith(SHIPPED + ("corpus/",)) for path in changed)
    rooms = included_folders(source, set()) | {room}
    return any(folder(path) in rooms and path.endswith((".hpp", ".cpp", ".h")) for path in changed
               if not path.endswith(("_test.cpp", "_property.cpp")))


def tests(build):
    """Every test that is neither slow nor for soaking, as ctest describes it."""
    text = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], check=True,
                          capture_output=True, text=True).stdout
    for test in json.loads(text)["tests"]:
        labels = next((one["value"] for one in test["properties"] if one["name"] == "LABELS"), [])
        if not {"slow", "soak"} & set(labels):
            yield test


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("--jobs", default=str(os.cpu_count()))
    parser.add_argument("--green", action="store_true")
    options = parser.parse_args()
    stamp = pathlib.Path(options.build) / "green.json"
    now = digests()
    if options.green:
        stamp.write_text(json.dumps(now), encoding="utf-8")
        return 0
    before = json.loads(stamp.read_text(encoding="utf-8")) if stamp.is_file() else {}
    changed = {path for path in now.keys() | before.keys() if now.get(path) != before.get(path)}
    chosen = [test for test in tests(options.build) if is_about(test, changed)]
    print(f"check: {len(changed)} files have changed since the last green run, {len(chosen)} tests are about them")
    if chosen:
        programs = {pathlib.Path(test["command"][0]).name for test in chosen if "command" in test}
        known = subprocess.run(["cmake", "--build", options.build, "--target", "help"], check=True,
                               capture_output=True, text=True).stdout
        targets = sorted(name for name in programs if re.search(rf"^{re.escape(name)}: ", known, re.MULTILINE))
        if any(test["name"].startswith("python/") for test in chosen):
            targets.append("circumspect_python")
        built = subprocess.run(["cmake", "--build", options.build, "-j", options.jobs,
                                "--target", "circumspect_cli", *targets], check=False)
        names = "|".join(re.escape(test["name"]) for test in chosen)
        if built.returncode != 0 or subprocess.run(
                ["ctest", "--test-dir", options.build, "-j", options.jobs, "--output-on-failure",
                 "-R", f"^({names})$"], check=False).returncode != 0:
            return 1
    stamp.write_text(json.dumps(now), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
