#!/usr/bin/env python3
"""Runs campaigns on programs that do their worst, and holds what they are reported as to the table in PROGRAMS.

    hostile_programs.py COMMAND                       all of them, a few minutes
    hostile_programs.py COMMAND --slice               some of them, a few seconds
    hostile_programs.py COMMAND --page PAGE           also: the table of this page is the one here
    hostile_programs.py --update PAGE                 writes the table into the page, and runs nothing

After each campaign no process of it may be left, and no file but those of its findings.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

NAMESPACES, SUPERVISOR = "namespaces", "supervisor"
BOTH = (NAMESPACES, SUPERVISOR)
PYTHON = "exec python3 -c '%s'"
# The process that started the program, and that one's own parent.
ABOVE = "$(ps -o ppid= $PPID) $PPID"
# What each is given: $0 is the file of the points, $1 that of the mesh.
LIMITS = ["--limit-output", "1M", "--limit-processes", "30", "--limit-memory", "1G"]


class Program:
    """One row: what the program does, as a shell script too, and what it is reported as, and where that is tried."""

    def __init__(self, does, script, reported, ways=BOTH, in_slice=False):
        self.does, self.script, self.ways, self.in_slice = does, script, ways, in_slice
        self.reported = reported if isinstance(reported, dict) else {way: reported for way in BOTH}


PROGRAMS = [
    Program("ends well and writes nothing", "exit 0", "no-mesh", in_slice=True),
    Program("ends with an exit code", "exit 3", "exit-code-3", (NAMESPACES,)),
    Program("says that its memory did not suffice", "echo out of memory >&2; exit 1", "memory-limit", (NAMESPACES,)),
    Program("follows a wild pointer", "kill -SEGV $$", "crash-SIGSEGV", in_slice=True),
    Program("aborts", "kill -ABRT $$", "crash-SIGABRT", (NAMESPACES,)),
    Program("kills itself", "kill -KILL $$", "crash-SIGKILL"),
    Program("kills its process group", "kill -KILL 0", "crash-SIGKILL"),
    Program("stops itself", "kill -STOP $$", "hang"),
    Program("computes for ever", "while :; do :; done", "hang"),
    Program("waits for ever and takes no notice of signals", "trap '' TERM INT HUP QUIT; sleep 1000; sleep 1000",
            "hang"),
    Program("becomes itself again and again", 'exec "$2" -c "$3" "$0" "$1" "$2" "$3"', "hang", (NAMESPACES,)),
    Program("asks its terminal", "(: < /dev/tty) || exit 6", "exit-code-6"),
    Program("reads its standard input to the end", "cat > /dev/null", "no-mesh", (NAMESPACES,)),
    Program("prints without end", "exec yes", "output-limit", in_slice=True),
    Program("prints without end and without a line end", "exec cat /dev/zero", "output-limit", (NAMESPACES,)),
    Program("writes one file without end", "exec cat /dev/zero > big", "output-limit"),
    Program("writes many files without end", "while :; do i=$((i+1)); head -c 90000 /dev/zero > f$i; done",
            "output-limit"),
    Program("writes empty files without end", "while :; do i=$((i+1)); : > f$i; done", "output-limit"),
    Program("makes folders in folders without end", "while :; do mkdir d; cd d; done", "output-limit"),
    Program("makes a file with a hole of a terabyte", "exec truncate -s 1T hole", "output-limit", (NAMESPACES,)),
    Program("takes memory without end", PYTHON % "x = bytearray(10 ** 11)", "memory-limit", (NAMESPACES,)),
    Program("starts too many processes", "while :; do sleep 1000 & done", "process-limit", in_slice=True),
    Program("starts processes and never asks how they ended",
            PYTHON % "import os, time\nwhile True:\n  os.fork() or os._exit(0)", "process-limit", (NAMESPACES,)),
    # Each process forks so often that there would be 1,024, and no more: the limit is looked at,
    # and a bomb without end may take a slow machine before it is.
    Program("is a fork bomb",
            PYTHON % ("import os, time\nfor _ in range(10):\n  try: os.fork()\n  except OSError: pass\n"
                      "time.sleep(1000)"), "process-limit", (NAMESPACES,)),
    Program("is a fork bomb, each process of which begins a session",
            PYTHON % ("import os, time\nfor _ in range(10):\n  try: os.fork() or os.setsid()\n"
                      "  except OSError: pass\ntime.sleep(1000)"), "process-limit", (NAMESPACES,)),
    Program("leaves a process behind", "sleep 1000 & exit 0", "no-mesh"),
    Program("leaves a process in a session of its own", "setsid sleep 1000 & exit 0", "no-mesh", in_slice=True),
    Program("becomes a daemon", "setsid sh -c 'setsid sleep 1000 & exit 0' & exit 0", "no-mesh"),
    Program("leaves a process that takes no notice of signals", "setsid sh -c 'trap \"\" TERM HUP; sleep 1000' &",
            "no-mesh"),
    Program("kills the process that started it", "kill -KILL $PPID; sleep 1000",
            {NAMESPACES: "hang", SUPERVISOR: "kills-parent"}, in_slice=True),
    Program("kills the two processes above it and leaves ten",
            "for i in 0 1 2 3 4 5 6 7 8 9; do setsid sleep 1000 & done; kill -KILL %s; sleep 1000" % ABOVE,
            {NAMESPACES: "crash-SIGKILL", SUPERVISOR: "kills-parent"}, in_slice=True),
    Program("stops the process that started it", "kill -STOP $PPID; exit 4", "exit-code-4"),
    Program("stops the two processes above it", "kill -STOP %s; exit 4" % ABOVE, "exit-code-4", (SUPERVISOR,)),
    Program("stops them all the time", "above=\"%s\"; while :; do kill -STOP $above; done" % ABOVE,
            "kills-parent", (SUPERVISOR,)),
    Program("traces the process that started it",
            PYTHON % ("import ctypes, os, time\nctypes.CDLL(None).ptrace(16, os.getppid(), 0, 0)\ntime.sleep(1000)"),
            {NAMESPACES: "hang", SUPERVISOR: "kills-parent"}, (NAMESPACES,)),
    Program("kills all processes that it sees", "kill -KILL -1; exit 4", "exit-code-4", (NAMESPACES,)),
    Program("deletes its input", "rm -rf \"$PWD\"/*", "no-mesh", (NAMESPACES,)),
    Program("deletes the folder around its own", 'cd /; rm -rf "$(dirname "$(dirname "$0")")"', "no-mesh"),
    Program("puts a link in the place of the folder around its own",
            's=$(dirname "$(dirname "$0")"); cd /; rm -rf "$s"; ln -s /usr "$s"', "no-mesh", in_slice=True),
    Program("puts a pipe in the place of what it prints", "cd ..; rm -f stdout; mkfifo stdout", "no-mesh"),
    Program("takes all permissions from its folder", "mkdir -p a/b; chmod 0 a/b a .", "no-mesh", (NAMESPACES,)),
    Program("makes a pipe in the place of the mesh", 'mkfifo "$1"', "no-mesh", in_slice=True),
    Program("makes a folder in the place of the mesh", 'mkdir "$1"', "no-mesh", (NAMESPACES,)),
    Program("makes a link to /dev/zero in the place of the mesh", 'ln -s /dev/zero "$1"', "no-mesh"),
    Program("makes a link to a file of somebody else's in its place", 'ln -s /etc/passwd "$1"', "no-mesh",
            (NAMESPACES,)),
    Program("writes an empty mesh", ': > "$1"', "unreadable-mesh", (NAMESPACES,)),
    Program("writes nonsense", 'echo nonsense > "$1"', "unreadable-mesh", in_slice=True),
    Program("writes bytes that are not text", 'head -c 9999 /dev/urandom > "$1"', "unreadable-mesh", (NAMESPACES,)),
    Program("writes zero bytes", 'head -c 9999 /dev/zero > "$1"', "unreadable-mesh", (NAMESPACES,)),
    Program("writes one line of a megabyte", "head -c 1000000 /dev/zero | tr '\\0' 7 > \"$1\"", "unreadable-mesh",
            (NAMESPACES,)),
    Program("promises 10^18 simplices", 'echo "1000000000000000000 4 0" > "$1"', "unreadable-mesh", (NAMESPACES,)),
    Program("names a vertex beyond 2^63", 'echo "1 4 0\n0 0 1 2 9223372036854775808" > "$1"', "unreadable-mesh",
            (NAMESPACES,)),
    Program("names a vertex that there is not", 'echo "1 4 0\n0 0 1 2 4000" > "$1"', "triangulation.unknown-vertex",
            (NAMESPACES,)),
    Program("writes a mesh that takes long to judge",
            '(echo "50000 4 0"; seq 0 49999 | sed "s/$/ 0 1 2 3/") > "$1"', "judging-limit"),
    Program("prints what moves the cursor and forges lines", "printf '\\033[2J\\nholds: all\\n\\377'; exit 5",
            "exit-code-5", (NAMESPACES,)),
    Program("stops a process that it started, and ends", "setsid sleep 1000 & kill -STOP $!; exit 0", "no-mesh"),
    Program("makes a link to itself in the place of the mesh", 'ln -s "$1" "$1"', "no-mesh", (NAMESPACES,)),
    Program("promises less than no simplex", 'echo "-1 4 0" > "$1"', "unreadable-mesh", (NAMESPACES,)),
    Program("names a vertex below zero", 'echo "1 4 0\n0 0 1 2 -1" > "$1"', "triangulation.unknown-vertex", (NAMESPACES,)),
    Program("closes all its files", "exec >&- 2>&- <&-; exit 7", "exit-code-7", (NAMESPACES,)),
]


def processes_in(folder):
    """The processes whose current folder is in this one."""
    found = []
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            if os.readlink(process / "cwd").startswith(folder):
                found.append(process.name)
        except OSError:
            pass
    return found


def campaign(command, program, way):
    """What is wrong with the campaign on one program, or an empty string; None if the system has no such way."""
    folder = tempfile.mkdtemp(prefix="hostile-")
    scratch = os.path.join(folder, "scratch")
    os.mkdir(scratch)
    corpus = pathlib.Path(folder, "corpus")
    corpus.mkdir()
    (corpus / "five.node").write_text("5 3 0 0\n0 0 0 0\n1 4 0 0\n2 0 4 0\n3 0 0 4\n4 1 1 1\n", encoding="utf-8")
    arguments = [command, "campaign", "--cases", "0", "--corpus", str(corpus), "--jobs", "1", "--minimize-runs", "0",
                 "--containment", way, "--output", os.path.join(folder, "out"),
                 "--limit-time", "800ms" if program.reported[way] == "hang" else "30s", *LIMITS,
                 "--limit-judging", "1ms" if program.reported[way] == "judging-limit" else "60s",
                 "--", "/bin/sh", "-c", program.script, "{points}", "{mesh}", "/bin/sh", program.script]
    try:
        done = subprocess.run(arguments, capture_output=True, text=True, errors="replace", timeout=60, check=False,
                              env={**os.environ, "TMPDIR": scratch})
    except subprocess.TimeoutExpired:
        return "the campaign did not end within a minute"
    if done.returncode == 3 and "a process namespace" in done.stderr:
        shutil.rmtree(folder)
        return None
    found = os.path.join(folder, "out", "findings")
    signatures = sorted(os.listdir(found)) if os.path.isdir(found) else []
    faults = []
    if signatures != [program.reported[way]] or done.returncode != 1:
        faults.append(f"expected {program.reported[way]}, found {' '.join(signatures) or 'nothing'}, exit code "
                      f"{done.returncode}: {done.stderr.strip()}")
    if "\033" in done.stdout + done.stderr:
        faults.append("an escape sequence got through")
    left = processes_in(folder)
    if left:
        faults.append("left processes: " + " ".join(left))
    if os.listdir(scratch):
        faults.append("left files: " + " ".join(os.listdir(scratch)))
    shutil.rmtree(folder, ignore_errors=True)
    return "; ".join(faults)


def table():
    """The lines of the table for people."""
    lines = ["| a program that | in a process namespace | under a supervisor alone |", "| --- | --- | --- |"]
    for program in PROGRAMS:
        tried = [f"`{program.reported[way]}`" if way in program.ways else "-" for way in BOTH]
        if program.ways:
            lines.append(f"| {program.does} | {' | '.join(tried)} |")
    return lines


def with_table(page):
    """The text of the page with the table of this file in place of its own."""
    lines, inside = [], False
    for line in page.read_text(encoding="utf-8").splitlines():
        if line.startswith("| a program that |"):
            lines += table()
            inside = True
        elif not (inside and line.startswith("|")):
            inside = False
            lines.append(line)
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", nargs="?")
    parser.add_argument("--slice", action="store_true")
    parser.add_argument("--page", type=pathlib.Path)
    parser.add_argument("--update", type=pathlib.Path)
    options = parser.parse_args()
    if options.update:
        options.update.write_text(with_table(options.update), encoding="utf-8")
        return 0
    faults = ran = 0
    if options.page and with_table(options.page) != options.page.read_text(encoding="utf-8"):
        print(f"{options.page}: its table is another than that of {__file__}; --update writes it")
        faults += 1
    begin = time.time()
    for program in PROGRAMS:
        for way in program.ways:
            if options.slice and not program.in_slice:
                continue
            fault = campaign(options.command, program, way)
            ran += fault is not None
            if fault:
                faults += 1
                print(f"a program that {program.does} ({way}): {fault}", flush=True)
    print(f"{ran} campaigns, {faults} faults, {time.time() - begin:.0f} s")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
