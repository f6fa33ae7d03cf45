#!/usr/bin/env python3
"""Runs what the GitHub Action runs, as the runner would: action_test.py COMMAND"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tarfile
import tempfile
import textwrap
import unittest
import xml.etree.ElementTree as xml
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
PEERS = HERE.parent / "corpus" / "peers" / "tetgen"
GOOD = f"'{PEERS}/random-3d-500.1.ele'"
BAD = f"'{PEERS}/hunted-tetgen-covered-twice-3d.1.ele'"
COMMAND = sys.argv.pop() if len(sys.argv) > 1 else ""


class Action(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def act(self, **inputs):
        """The exit code, and what is printed."""
        given = {"COMMAND": COMMAND, "OUTPUT": str(self.folder / "output"), **inputs}
        env = {**os.environ, **{f"CIRCUMSPECT_{name}": value for name, value in given.items()},
               "GITHUB_OUTPUT": str(self.folder / "outputs"), "GITHUB_STEP_SUMMARY": str(self.folder / "summary"),
               "RUNNER_TEMP": str(self.folder), "RUNNER_TOOL_CACHE": str(self.folder / "tools")}
        ran = subprocess.run([HERE / "run.sh"], env=env, cwd=self.folder, text=True, capture_output=True, timeout=60)
        self.said = ran.stdout + ran.stderr
        return ran.returncode

    def report(self, name):
        return (self.folder / "output" / name).read_text(encoding="utf-8")

    def matched(self):
        """What the problem matchers make of the lines that were printed."""
        found = []
        for matcher in json.loads((HERE / "problem-matcher.json").read_text())["problemMatcher"]:
            pattern = matcher["pattern"][0]
            for line in self.said.splitlines():
                match = re.search(pattern["regexp"], line)
                if match:
                    found.append({key: match[pattern[key]] for key in ("file", "line", "message", "code") if key in pattern})
        return found

    def test_meshes_that_hold(self):
        self.assertEqual(self.act(RUN="check", ARGUMENTS=GOOD), 0, self.said)
        self.assertEqual(self.matched(), [])
        self.assertIn("exit-code=0\nverdict=holds: delaunay ", (self.folder / "outputs").read_text())
        suite = xml.fromstring(self.report("junit.xml"))[0]
        self.assertEqual((suite.get("tests"), suite.get("failures"), suite.get("errors")), ("1", "0", "0"))
        self.assertEqual(json.loads(self.report("report.sarif"))["runs"][0]["results"], [])

    def test_meshes_that_fail_or_cannot_be_read(self):
        broken = self.folder / "x y.node"
        broken.write_text("1 2\n0 0\n")
        self.assertEqual(self.act(RUN="check", ARGUMENTS=f"{GOOD} {BAD} '{broken}' --points '{broken}'"), 3, self.said)
        self.assertEqual(self.act(RUN="check", ARGUMENTS=f"{GOOD} {BAD} '{broken}'"), 3, self.said)
        suite = xml.fromstring(self.report("junit.xml"))[0]
        self.assertEqual((suite.get("tests"), suite.get("failures"), suite.get("errors")), ("3", "1", "1"))
        self.assertIn("covered-twice", suite.find(".//failure").get("message"))
        results = json.loads(self.report("report.sarif"))["runs"][0]["results"]
        self.assertEqual([one["ruleId"] for one in results], ["triangulation.covered-twice", "input"])
        self.assertIn("fails: delaunay ", (self.folder / "summary").read_text())
        fails, fault = self.matched()
        self.assertEqual(fails["code"], "triangulation.covered-twice")
        self.assertTrue(fails["file"].endswith("hunted-tetgen-covered-twice-3d.1.ele"))
        self.assertRegex(fault["message"], "^expected a file with the simplices of ")

    def test_causes_come_after_the_rules(self):
        rows = (PEERS / "random-3d-500.1.ele").read_text().splitlines()
        count, *rest = rows[0].split()
        (self.folder / "x.ele").write_text("\n".join([" ".join([str(int(count) - 1), *rest]), *rows[2:]]) + "\n")
        points = PEERS / "random-3d-500.1.node"
        self.assertEqual(self.act(RUN="check", ARGUMENTS=f"x.ele --points '{points}'"), 1, self.said)
        results = json.loads(self.report("report.sarif"))["runs"][0]["results"]
        self.assertEqual((results[-1]["ruleId"], results[-1]["level"]), ("cause.missing-simplex", "note"))
        self.assertIn("1 tetrahedron is missing: ", results[-1]["message"]["text"])
        self.assertEqual({one["level"] for one in results[:-1]}, {"error"})
        self.assertIn("cause: 1 tetrahedron is missing: ", self.said)

    def test_lines_of_a_file_at_fault(self):
        (self.folder / "x.node").write_text("3 2\n0 0 0\n1 red 0\n2 0 1\n")
        (self.folder / "x.ele").write_text("1 3\n0 0 1 2\n")
        self.assertEqual(self.act(RUN="check", ARGUMENTS="x.ele"), 3)
        self.assertEqual([(one["file"], one["line"]) for one in self.matched()], [("x.node", "3")])

    def test_campaign(self):
        self.assertEqual(self.act(RUN="campaign", ARGUMENTS="--cases 2 --jobs 1 --minimize-runs 20 --families integers --full-dimension "
                                  "-- false {points} {mesh}"), 1, self.said)
        self.assertRegex(self.said, "(?m)^::error file=")
        self.assertIn("<failure", self.report("junit.xml"))
        self.assertEqual(len(json.loads(self.report("report.sarif"))["runs"][0]["results"]), 1)
        self.assertTrue((self.folder / "output" / "findings").is_dir())

    def test_archive(self):
        with tarfile.open(self.folder / "circumspect.tar.gz", "w:gz", compresslevel=1) as archive:
            archive.add(os.path.realpath(COMMAND), "circumspect-1-linux/bin/circumspect")
        self.assertEqual(self.act(RUN="check", ARGUMENTS=GOOD, COMMAND="", TARBALL="circumspect.tar.gz"), 0, self.said)

    def wheel(self):
        """A wheel that calls the command."""
        path = self.folder / "circumspect-0.1.0-py3-none-any.whl"
        calls = f"import os, sys\n\n\ndef run():\n    os.execv({os.path.realpath(COMMAND)!r}, sys.argv)\n"
        files = {"circumspect/__init__.py": "", "circumspect/__main__.py": calls,
                 "circumspect-0.1.0.dist-info/METADATA": "Metadata-Version: 2.1\nName: circumspect\nVersion: 0.1.0\n",
                 "circumspect-0.1.0.dist-info/WHEEL": "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n"}
        with zipfile.ZipFile(path, "w") as archive:
            for name, text in files.items():
                archive.writestr(name, text)
            archive.writestr("circumspect-0.1.0.dist-info/RECORD", "".join(f"{name},,\n" for name in files))
        return path

    def test_wheel(self):
        """It is installed once."""
        given = {"RUN": "check", "ARGUMENTS": GOOD, "COMMAND": "", "WHEEL": str(self.wheel())}
        self.assertEqual(self.act(**given), 0, self.said)
        self.assertIn("::group::Installing", self.said)
        self.assertEqual(self.act(**given), 0, self.said)
        self.assertNotIn("::group::", self.said)
        self.assertIn("</html>", self.report("page.html"))
        absent = str(self.folder / "absent.whl")
        self.assertEqual(self.act(**{**given, "WHEEL": absent}), 2)
        self.assertIn(f"expected a wheel that pip installs, found none for '{absent}'", self.said)
        self.assertEqual(self.act(**{**given, "WHEEL": ""}), 2)
        self.assertIn("expected a wheel, a tarball or a command", self.said)

    def test_gitlab(self):
        """The lines of the template, as its runner would run them where the command is installed."""
        template = (HERE.parent / "docs" / "gitlab-ci.yml").read_text(encoding="utf-8")
        script = textwrap.dedent(template[template.index("  script:\n"):template.index("  artifacts:")].partition("\n")[2])
        lines = "\n".join(line.removeprefix("- ") for line in script.splitlines())
        declared = dict(re.findall(r"^    (CIRCUMSPECT_\w+): (.*)$", template, re.M))
        for mesh, code, junit in ((GOOD, 0, '"0"'), (BAD, 1, '"1"')):
            env = {**os.environ, **declared, "CIRCUMSPECT_ARGUMENTS": mesh.strip("'"),
                   "PATH": f"{os.path.dirname(os.path.realpath(COMMAND))}:{os.environ['PATH']}"}
            ran = subprocess.run(["sh", "-ec", lines], env=env, cwd=self.folder, text=True, capture_output=True, timeout=60)
            self.assertEqual(ran.returncode, code, ran.stdout + ran.stderr)
            folder = self.folder / declared["CIRCUMSPECT_OUTPUT"]
            self.assertIn(f"failures={junit}", (folder / "junit.xml").read_text())
            self.assertTrue((folder / "report.sarif").exists() and (folder / "page.html").exists())

    def test_wrong_inputs(self):
        self.assertEqual(self.act(RUN="chek", ARGUMENTS=GOOD), 2)
        self.assertIn("expected 'check' or 'campaign' for the input 'run', found 'chek'", self.said)
        self.assertEqual(self.act(ARGUMENTS=""), 2)
        self.assertEqual(self.act(ARGUMENTS="'x"), 2)
        self.assertEqual(self.act(ARGUMENTS="--nonsense"), 2)
        self.assertEqual(self.act(ARGUMENTS="$(touch started) `touch started` ;touch started"), 3)
        self.assertFalse((self.folder / "started").exists())

    def test_a_name_gives_the_runner_no_command(self):
        self.act(ARGUMENTS=f"{GOOD} '::add-mask::x'")
        lines = self.said.splitlines()
        stopped = next(i for i, line in enumerate(lines) if line.startswith("::stop-commands::"))
        self.assertIn(f"::{lines[stopped].rsplit(':', 1)[1]}::", lines[stopped:])

    def test_actions_of_others_are_named_by_their_commits(self):
        """A tag is whatever its owner makes of it tomorrow. The comment says which one it was."""
        files = [HERE.parent / "action.yml", *(HERE.parent / "docs").glob("*.yml"), *(HERE.parent / ".ci").rglob("*.yml"),
                 *(HERE.parent / ".github").rglob("*.yml")]
        used = [(file.name, line.strip()) for file in files for line in file.read_text().splitlines()
                if re.search(r"^[^#]*\buses:", line)]
        self.assertGreaterEqual(len(used), 4)
        for file, line in used:
            self.assertRegex(line, r"uses: [\w./-]+@[0-9a-f]{40} +# v\d+\.\d+\.\d+$", file)

    def test_the_builds_elsewhere_are_those_of_the_page(self):
        """Nobody runs that workflow here: its commands are those of a page, and name what there is."""
        root = HERE.parent
        text = (root / ".github" / "workflows" / "builds.yml").read_text(encoding="utf-8")
        page = (root / "docs" / "platforms.md").read_text(encoding="utf-8").splitlines()
        targets = set(re.search(r"^\.PHONY: ((?:.*\\\n)*.*)", (root / "Makefile").read_text(), re.M)[1].split())
        built = "".join(file.read_text() for file in [root / "CMakeLists.txt", *root.glob("*/CMakeLists.txt"), *root.glob("cmake/*.cmake")])
        commands = [line for line in re.findall(r"^ +(?:- )?run: (.+)$", text, re.M) if not line.startswith(("apt-get ", "git "))]
        self.assertGreaterEqual(len(commands), 18)
        for command in commands:
            if not re.fullmatch(r"make \w+", command):  # which the page has within a sentence
                self.assertTrue(command in page, f"expected in docs/platforms.md: {command}")
            words = command.split()
            for target in words[1:] if words[0] == "make" else []:
                self.assertTrue(target in targets, f"expected a target {target} in the Makefile")
            for name in re.findall(r"\bcircumspect_\w+", command):
                self.assertTrue(re.search(rf"(add_executable|circumspect_add_archive)\({name} ", built), f"expected a target {name}")
            for name in re.findall(r"-D(CIRCUMSPECT_\w+)", command):
                self.assertTrue(f"option({name} " in built, f"expected an option {name}")
            for path in re.findall(r"(?:^|\s)(?:cmake|corpus)/\S+", command):
                self.assertTrue((root / path.strip()).is_file(), path)
        try:
            import yaml  # pylint: disable=import-outside-toplevel
        except ImportError:
            self.skipTest("PyYAML is not there: the workflow was not parsed")
        jobs = yaml.safe_load(text)["jobs"]
        for name, job in jobs.items():
            self.assertIn("runs-on", job, name)
            self.assertIn(job.get("needs", name), list(jobs))
            self.assertTrue(all(("run" in step) != ("uses" in step) for step in job["steps"]), name)

    def test_one_version(self):
        """What is installed by its version is that of these sources."""
        version = re.search(r"VERSION (\S+) LANGUAGES", (HERE.parent / "CMakeLists.txt").read_text())[1]
        for file in ("action.yml", "docs/gitlab-ci.yml", "docs/pre-commit-config.yaml"):
            named = re.findall(r"circumspect==([\w.]+)", (HERE.parent / file).read_text())
            self.assertEqual(named, [version], file)
        self.assertIn(f'\nversion = "{version}"\n', (HERE.parent / "rust" / "Cargo.toml").read_text())
        for page in (HERE.parent / "docs").glob("*.md"):  # whose commands are those of any version
            if page.name != "releasing.md":
                self.assertIsNone(re.search(r"circumspect[a-z-]*[-_]\d+\.\d+\.\d", page.read_text(encoding="utf-8")), page)

    def test_the_action_passes_on_what_it_declares(self):
        action = (HERE.parent / "action.yml").read_text()
        declared = set(re.findall(r"^  ([a-z-]+):$", action[action.index("inputs:"):action.index("outputs:")], re.M))
        self.assertEqual(set(re.findall(r"inputs\.([a-z-]+)", action)), declared)
        script = (HERE / "run.sh").read_text()
        passed = set(re.findall(r"^ +(CIRCUMSPECT_[A-Z]+): ", action, re.M))
        self.assertEqual(passed, set(re.findall(r"CIRCUMSPECT_[A-Z]+", script)))


if __name__ == "__main__":
    unittest.main()
