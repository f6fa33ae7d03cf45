#!/usr/bin/env python3
"""The tests of what has changed since the last green run: `make check`.

    check.py BUILD_FOLDER [--jobs N]      builds what they need, runs them; green if all pass
    check.py BUILD_FOLDER --green         remembers that everything is green now (`make test` does)

Each test is about some files. A unit test is about the folder that it stands in, a property about the folders
whose headers it includes. If one of these files has changed, or the test itself, the test runs. The tests of the
command, of the corpus, of the pages and of Python start what is shipped, so any change there concerns them, from a
distance. The quickest of these distant tests run, as many as FAR_SECONDS allow. The others are left to `make test`,
which runs everything, and `make check` names them until it has. Tests labelled `slow` are left to it, too.
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
SHIPPED = ("platform/", "kernel/", "reference/", "construct/", "inputs/", "oracle/", "fuzz/campaign/", "fuzz/process/", "command/")
# How long the distant tests may take on each processor. Compiling and linking takes about thirty seconds before that.
FAR_SECONDS = 12
NEAR, FAR = "near", "far"
REGISTERED = re.compile(r'"([^"]*)"')
LOGGED = re.compile(r"^\d+/\d+ Test: (\S+)$.*?^Test time =\s+([\d.]+) sec$", re.MULTILINE | re.DOTALL)


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


def distance(test, changed):
    """NEAR if the test is about one of the changed files, FAR if one is part of what the test starts, else None."""
    source = test["name"] + ".cpp"
    if source in changed:
        return NEAR
    if not (ROOT / source).is_file():  # scripts: the corpus, the pages, the examples
        scripts = {os.path.relpath(word, ROOT) for word in test.get("command", []) if word.startswith(f"{ROOT}/")}
        if scripts & changed:
            return NEAR
        return FAR if any(path.startswith(DATA + SHIPPED) for path in changed) else None
    room = folder(source)
    code = [path for path in changed if path.endswith((".hpp", ".cpp", ".h"))
            and not path.endswith(("_test.cpp", "_property.cpp"))]
    if room.startswith(("corpus", "command")):
        if any(folder(path) == room for path in code):
            return NEAR
        return FAR if any(path.startswith(SHIPPED + ("corpus/",)) for path in changed) else None
    rooms = included_folders(source, set()) | {room}
    return NEAR if any(folder(path) in rooms for path in code) else None


def choose(found, changed, seconds, jobs):
    """The tests that run, and the names of the distant ones that are left out. SECONDS has what each took when it
    last ran. Of the distant tests the quickest run, so that as many as possible do; one that never ran comes first."""
    by_distance = {NEAR: [], FAR: []}
    for test in found:
        how_far = distance(test, changed)
        if how_far:
            by_distance[how_far].append(test)
    chosen, left_out, total = by_distance[NEAR], [], 0.0
    for test in sorted(by_distance[FAR], key=lambda test: seconds.get(test["name"], 0)):
        total += seconds.get(test["name"], 0)
        if total <= FAR_SECONDS * jobs:
            chosen.append(test)
        else:
            left_out.append(test["name"])
    return chosen, left_out


def times(build):
    """What each test of ctest's last run took."""
    log = pathlib.Path(build) / "Testing" / "Temporary" / "LastTest.log"
    text = log.read_text(encoding="utf-8", errors="replace") if log.is_file() else ""
    return {name: float(seconds) for name, seconds in LOGGED.findall(text)}


def tests(build):
    """Every test that is neither slow nor for soaking, as ctest describes it."""
    text = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], check=True,
                          capture_output=True, text=True).stdout
    for test in json.loads(text)["tests"]:
        labels = next((one["value"] for one in test["properties"] if one["name"] == "LABELS"), [])
        if not {"slow", "soak"} & set(labels):
            yield test


def targets(test, build):
    """What has to be built for a test. CTest does not say what starts a test whose program was never built."""
    if "command" not in test:
        registered = "".join(file.read_text(encoding="utf-8") for file in pathlib.Path(build).rglob("CTestTestfile.cmake"))
        test = test | {"command": REGISTERED.findall(registered.partition(f"add_test([=[{test['name']}]=]")[2])[:1]}
    found = {"circumspect_python"} if test["name"].startswith("python/") else set()
    for word in test["command"]:
        path = pathlib.Path(os.path.relpath(word, os.path.abspath(build)))
        if str(path) in (".", "tests"):  # it looks for programs there by itself
            return {"all"}
        if str(path.parent) in ("tests", "bin"):
            found.add({"circumspect": "circumspect_cli"}.get(path.name, path.name.replace("-", "_")))
    return found


def built_and_passed(build, chosen, jobs):
    """Builds what the tests need, and runs them."""
    needed = {"circumspect_cli"}.union(*(targets(test, build) for test in chosen))
    if subprocess.run(["cmake", "--build", build, "-j", str(jobs), "--target", *sorted(needed)],
                      check=False).returncode != 0:
        return False
    names = "|".join(re.escape(test["name"]) for test in chosen)
    return subprocess.run(["ctest", "--test-dir", build, "-j", str(jobs), "--output-on-failure",
                           "-R", f"^({names})$"], check=False).returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--green", action="store_true")
    options = parser.parse_args()
    stamp = pathlib.Path(options.build) / "green.json"
    green = {"files": {}, "seconds": {}, "left out": []}
    if stamp.is_file():
        green |= json.loads(stamp.read_text(encoding="utf-8"))

    def remember(files, left_out):
        seconds = green["seconds"] | times(options.build)
        stamp.write_text(json.dumps({"files": files, "seconds": seconds, "left out": left_out}), encoding="utf-8")

    now = digests()
    if options.green:
        remember(now, [])
        return 0
    before = green["files"]
    changed = {path for path in now.keys() | before.keys() if now.get(path) != before.get(path)}
    chosen, left_out = choose(list(tests(options.build)), changed, green["seconds"], options.jobs)
    left_out = sorted({*green["left out"], *left_out} - {test["name"] for test in chosen})
    print(f"check: {len(changed)} files have changed since the last green run; {len(chosen)} tests run", flush=True)
    passed = not chosen or built_and_passed(options.build, chosen, options.jobs)
    remember(now if passed else before, left_out if passed else green["left out"])
    if left_out:
        print(f"check: left to `make test`: what is slow, and {len(left_out)} tests that see the change from a "
              f"distance: {', '.join(left_out)}")
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
