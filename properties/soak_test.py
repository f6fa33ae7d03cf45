#!/usr/bin/env python3
"""Tests properties/soak.py on folders of tests that take a moment."""

import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

SOAK = pathlib.Path(__file__).with_name("soak.py")
# Tries ten inputs, a tenth of a second each, for as long as it is told.
TIMED = """#!/bin/bash
tried=0
while [ $tried -lt 10 ] && [ ${SECONDS:-0} -lt $CIRCUMSPECT_SECONDS ]; do sleep 0.1; tried=$((tried + 1)); done
echo "inputs: $tried of 10"
echo "test cases: 1 | 1 passed"
"""


class Folder:
    """A build folder with tests; each is a script, in `tests` if it shares the time."""

    def __init__(self, root):
        self.root = pathlib.Path(root)
        (self.root / "tests").mkdir()
        self.lines = []
        self.write()

    def write(self):
        (self.root / "CTestTestfile.cmake").write_text("\n".join(self.lines) + "\n")

    def add(self, name, script, where=".", facts='LABELS "soak"'):
        path = self.root / where / name
        path.write_text(script)
        path.chmod(0o755)
        self.lines += [f'add_test({name} "{path}")', f"set_tests_properties({name} PROPERTIES {facts})"]
        self.write()

    def totals(self):
        rows = (self.root / "soak.tsv").read_text().splitlines()[1:]
        return {row.split("\t")[0]: [int(n) for n in row.split("\t")[1:]] for row in rows}

    def soak(self, minutes="0.06"):
        return subprocess.run([str(SOAK), str(self.root), minutes], capture_output=True, text=True,
                              env={**os.environ, "SOAK_TOTALS": str(self.root / "soak.tsv")})


def row_of(done, name):
    return next((line for line in done.stdout.splitlines() if line.startswith(f"  {name} ")), "")


def test_all_run_and_say_what_they_did(folder):
    folder.add("timed", TIMED, "tests")
    folder.add("whole", "#!/bin/sh\nsleep 0.6\n")
    done = folder.soak()
    assert done.returncode == 0, done.stdout + done.stderr
    assert " of " in row_of(done, "timed") and "inputs" in row_of(done, "timed")
    assert "1 run, 1 s" in row_of(done, "whole"), done.stdout
    assert "soak: nothing failed" in done.stdout
    assert re.search(r"^soak: 0\.0 of 0\.06 minutes, \d+ runs; now .*timed", done.stdout, re.MULTILINE), done.stdout
    runs, inputs, faults, seconds = folder.totals()["timed"]
    assert runs >= 1 and 1 <= inputs <= 10 * runs and faults == 0 and seconds == 0
    assert folder.totals()["whole"] == [1, 0, 0, 1]


def test_what_a_whole_one_took_the_last_time_counts(folder):
    folder.add("whole", "#!/bin/sh\nsleep 0.2\n")
    folder.add("skipped", "#!/bin/sh\nexit 77\n", facts='LABELS "soak" SKIP_RETURN_CODE 77')
    (folder.root / "soak.tsv").write_text("# what all soaks did\nskipped\t1\t0\t0\t1\nwhole\t1\t0\t0\t2\n")
    assert folder.soak().returncode == 0
    assert folder.totals()["whole"] == [2, 0, 0, 0] and folder.totals()["skipped"] == [2, 0, 0, 1]


def test_one_that_is_too_long_is_left_out(folder):
    folder.add("timed", TIMED, "tests")
    folder.add("long", "#!/bin/sh\nexit 1\n")
    (folder.root / "soak.tsv").write_text("# what all soaks did\nlong\t1\t0\t0\t600\n")
    done = folder.soak()
    assert done.returncode == 0, done.stdout
    assert "left out: it takes 600 s" in row_of(done, "long")
    assert folder.totals()["long"] == [1, 0, 0, 600]


def test_one_that_does_not_end_is_cut_off(folder):
    folder.add("endless", "#!/bin/sh\nsleep 77 & wait\n")
    begun = time.monotonic()
    done = folder.soak()
    assert time.monotonic() - begun < 12
    assert done.returncode == 0 and "cut off" in row_of(done, "endless"), done.stdout
    assert folder.totals()["endless"][3] >= 2  # a longer soak is asked for next time


def test_one_that_takes_too_much_leaves_the_others_their_turn(folder):
    folder.add("greedy", "#!/bin/sh\nsleep 77 & wait\n", "tests", 'LABELS "soak" PROCESSORS 99')
    folder.add("timed", TIMED, "tests")
    done = folder.soak("0.1")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "cut off" in row_of(done, "greedy"), done.stdout
    assert " of " in row_of(done, "timed") and "not reached" not in row_of(done, "timed"), done.stdout


def test_a_whole_one_is_cut_off_long_after_its_time(folder):
    folder.add("whole", "#!/bin/sh\nsleep 77 & wait\n")
    (folder.root / "soak.tsv").write_text("# what all soaks did\nwhole\t1\t0\t0\t1\n")
    begun = time.monotonic()
    done = folder.soak("0.5")
    assert time.monotonic() - begun < 25, done.stdout
    assert "cut off" in row_of(done, "whole"), done.stdout
    assert folder.totals()["whole"][3] >= 6


def test_a_failure_says_how_to_repeat_it_and_the_others_go_on(folder):
    folder.add("a_wrong", "#!/bin/sh\necho what went wrong\nexit 3\n", "tests")
    folder.add("timed", TIMED, "tests")
    done = folder.soak()
    assert done.returncode == 1
    assert "what went wrong" in done.stdout and "FAILED: a_wrong, exit code 3, seed" in done.stdout
    assert "RC_PARAMS=seed=" in done.stdout and "-R '^a_wrong$'" in done.stdout
    assert "FAILED" in row_of(done, "a_wrong") and "FAILED" not in row_of(done, "timed")
    assert folder.totals()["a_wrong"][:3] == [1, 0, 1] and folder.totals()["timed"][1] > 0


def test_a_file_without_test_cases_fails(folder):
    folder.add("empty", "#!/bin/sh\necho 'test cases: 0 | 0 passed'\n", "tests")
    done = folder.soak("5")
    assert done.returncode == 1 and "ran no test case" in done.stdout


def test_what_hangs_fails(folder):
    folder.add("hung", "#!/bin/sh\nsleep 66\n", facts='LABELS "property" TIMEOUT 0.3')
    done = folder.soak("5")
    assert done.returncode == 1 and "FAILED: hung, ran out of time" in done.stdout


def test_what_is_skipped_is_not_a_failure(folder):
    folder.add("skipped", "#!/bin/sh\nexit 77\n", facts='LABELS "soak" SKIP_RETURN_CODE 77')
    done = folder.soak()
    assert done.returncode == 0 and "skipped" in row_of(done, "skipped"), done.stdout


def test_an_interrupt_ends_it_with_all_that_it_started(folder):
    mark = folder.root / "child"
    folder.add("endless", f"#!/bin/sh\necho $$ >{mark}\nsleep 55\n")
    process = subprocess.Popen([str(SOAK), str(folder.root), "5"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                               env={**os.environ, "SOAK_TOTALS": str(folder.root / "soak.tsv")},
                               preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler))
    while not mark.exists() or not mark.read_text().endswith("\n"):
        time.sleep(0.02)
    process.send_signal(signal.SIGINT)
    output, errors = process.communicate(timeout=20)
    assert process.returncode == 130 and "interrupted" in errors and "cut off" in output, output + errors
    assert not pathlib.Path(f"/proc/{mark.read_text().strip()}").exists()


def test_wrong_usage(folder):
    for arguments in ([], [str(folder.root), "x"], [str(folder.root), "0"], [str(folder.root)], ["/nowhere"]):
        done = subprocess.run([str(SOAK), *arguments], capture_output=True, text=True)
        assert done.returncode == 2 and "usage: properties/soak.py" in done.stderr, arguments


def main():
    for name, test in sorted(globals().items()):
        if name.startswith("test_"):
            with tempfile.TemporaryDirectory() as root:
                test(Folder(root))
            print(f"{name}: passed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
