#!/usr/bin/env python3
"""Runs campaigns for hours, on workers and on hostile programs together, and looks whether anything grows or is left.

    long_campaign.py COMMAND [--hours H] [--folder NEW] [--every SECONDS]

Two campaigns run at a time, of one program at a time each. One goes through the adapters in Python, C++ and JavaScript,
with the exhaustive triangulators of fuzz/adapters/adapters_test.py. The other runs the programs of hostile_programs.py, each
case another one, half of the time `circumspect build`, which is right. Once a minute it prints one line about each campaign.

What it holds them to: the memory of a campaign's last third is that of its middle third, or less than a tenth more; afterwards
there is no process, no file in TMPDIR, and no finding but those that the programs have earned. Exit code 1: something else.
"""
import argparse
import fractions
import itertools
import json
import os
import pathlib
import shlex
import statistics
import subprocess
import sys
import tempfile
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "adapters")]
import adapters_test  # noqa: E402
import hostile_programs  # noqa: E402
from hostile_programs import NAMESPACES, SUPERVISOR, processes_in  # noqa: E402

# Programs that would starve what else runs on a machine for hours, or that need a limit of their
# own.
LEFT_OUT = {"is a fork bomb", "is a fork bomb, each process of which begins a session",
            "starts processes and never asks how they ended", "kills all processes that it sees",
            "stops them all the time", "writes a mesh that takes long to judge"}
STARTS_MANY = "starts too many processes"  # only where the kernel keeps them together
MINUTES_OF_LIFE = 3  # in which a campaign's memory may grow: it fills its buffers
GROWTH, SLACK = 1.1, 1024  # of the last third to the middle one; kilobytes


class Campaign:
    """One command that runs for its time, and the samples of it."""

    def __init__(self, name, arguments, explains):
        self.name, self.arguments, self.explains = name, arguments, explains
        self.samples, self.process, self.answer, self.code, self.took = [], None, {}, None, 0.0


def adapter_campaign(command, folder, language):
    """The adapter of this language in a campaign, on integers so small that the triangulator computes exactly."""
    make = adapters_test.LANGUAGES[language][1]
    home = folder / language
    home.mkdir()
    text = subprocess.run([command, "adapter", language], check=True, capture_output=True, text=True).stdout
    worker = make(str(home), text, False)
    arguments = ["--worker", "--dimension", "2", "--families", "uniform", "--max-points", "9", "--integers", "11",
                 "--full-dimension", "--limit-memory", "0", "--limit-time", "100s", "--minimize-runs", "100", "--", *worker]
    return Campaign(language, arguments, lambda finding, signature: is_degenerate(finding))


def is_degenerate(finding):
    """Do three points lie on a line or four on a circle? Of those the triangulator of adapters_test.py lists too many triangles."""
    points = [[fractions.Fraction(x) for x in line.split()[1:3]]
              for line in (finding / "minimal.node").read_text(encoding="utf-8").splitlines()[1:] if line[:1].isdigit()]

    def lifted(p, q):
        x, y = p[0] - q[0], p[1] - q[1]
        return x, y, x * x + y * y

    for p, q, r in itertools.combinations(points, 3):
        if (q[0] - p[0]) * (r[1] - p[1]) == (r[0] - p[0]) * (q[1] - p[1]):
            return True
    for four in itertools.combinations(points, 4):
        (a, b, c), (d, e, f), (g, h, i) = (lifted(p, four[3]) for p in four[:3])
        if a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g) == 0:
            return True
    return False


def hostile_campaign(command, folder, way, hanging):
    """The hostile programs that are tried in this way, in one campaign; those that wait for ever in one of their own."""
    programs = [p for p in hostile_programs.PROGRAMS
                if way in p.ways and p.does not in LEFT_OUT and (p.reported[way] == "hang") == hanging
                and (way == NAMESPACES or p.does != STARTS_MANY)]
    home = folder / f"{way}-{'hanging' if hanging else 'others'}"
    home.mkdir()
    for number, program in enumerate(programs):
        (home / str(number)).write_text(program.script, encoding="utf-8")
    # The points choose the program, so that each of them always meets the same one.
    (home / "choose.sh").write_text(
        'n=$(cksum < "$1"); n=${n%% *}; n=$((n %% %d))\n' % (2 * len(programs))
        + '[ $n -ge %d ] && exec %s build delaunay "$1" -o "$2"\n' % (len(programs), shlex.quote(command))
        + 'script=$(cat "%s/$n")\nexec /bin/sh -c "$script" "$1" "$2" /bin/sh "$script"\n' % home, encoding="utf-8")

    def explains(finding, signature):
        chosen = crc(finding / "minimal.node") % (2 * len(programs))
        return chosen < len(programs) and programs[chosen].reported[way] == signature

    arguments = ["--families", "uniform", "--max-points", "20", "--full-dimension", "--minimize-runs", "20",
                 "--containment", way, "--limit-time", "2s" if hanging else "100s", *hostile_programs.LIMITS,
                 "--", "/bin/sh", str(home / "choose.sh"), "{points}", "{mesh}"]
    return Campaign(home.name, arguments, explains)


def crc(path):
    """What cksum prints of a file: the CRC of POSIX, of its bytes and its length."""
    text = subprocess.run(["cksum", path], check=True, capture_output=True, text=True).stdout
    return int(text.split()[0])


def status(process, keys):
    """The numbers behind these keys in /proc/PROCESS/status; 0 where the process is gone."""
    try:
        lines = pathlib.Path("/proc", str(process), "status").read_text(encoding="utf-8", errors="replace").splitlines()
    except OSError:
        return [0] * len(keys)
    values = dict(line.split(":", 1) for line in lines if ":" in line)
    return [int(values.get(key, "0").split()[0]) for key in keys]


def tree_of(process):
    """The processes that this one started, and those which they started."""
    children = {}
    for entry in pathlib.Path("/proc").glob("[0-9]*"):
        children.setdefault(status(entry.name, ["PPid"])[0], []).append(int(entry.name))
    found, level = [], [process]
    while level:
        level = [child for parent in level for child in children.get(parent, [])]
        found += level
    return found


def files_in(folder):
    return sum(len(files) + len(folders) for _, folders, files in os.walk(folder))


def is_of(command, process):
    try:
        return os.path.samefile(f"/proc/{process}/exe", command)
    except OSError:
        return False


def sample(command, campaign, folder, minute):
    """One line of the table, and what it says for later."""
    main = campaign.process.pid
    below = tree_of(main)
    supervisors = [p for p in below if is_of(command, p)]
    resident = status(main, ["VmRSS"])[0]
    try:
        descriptors = len(os.listdir(f"/proc/{main}/fd"))
    except OSError:
        return
    journal = folder / "out" / campaign.name / "journal.tsv"
    row = {"resident": resident, "supervisors": sum(status(p, ["VmRSS"])[0] for p in supervisors),
           "processes": 1 + len(below), "descriptors": descriptors,
           "scratch": files_in(folder / "tmp" / campaign.name), "output": files_in(folder / "out" / campaign.name),
           "journal": journal.stat().st_size // 1024 if journal.is_file() else 0}
    campaign.samples.append(row)
    print(f"| {minute:.0f} | {campaign.name} | " + " | ".join(str(value) for value in row.values()) + " |", flush=True)


def lane(command, folder, campaigns, shares, seconds, every, began):
    """Runs these campaigns one after another, each for its share of the time."""
    for number, campaign in enumerate(campaigns):
        share = (began + seconds - time.time()) * shares[number] / sum(shares[number:])
        scratch, out = folder / "tmp" / campaign.name, folder / "out" / campaign.name
        scratch.mkdir(parents=True)
        start = time.time()
        with open(folder / f"{campaign.name}.json", "wb") as answer, open(folder / f"{campaign.name}.err", "wb") as said:
            campaign.process = subprocess.Popen(
                [command, "campaign", "--time", f"{int(share)}s", "--seed", "20", "--jobs", "1", "--format", "json",
                 "--output", str(out), *campaign.arguments], stdout=answer, stderr=said, stdin=subprocess.DEVNULL,
                env={**os.environ, "TMPDIR": str(scratch), "PYTHONPATH": str(folder / campaign.name)})
            while True:
                try:
                    campaign.code = campaign.process.wait(every)
                    break
                except subprocess.TimeoutExpired:
                    sample(command, campaign, folder, (time.time() - began) / 60)
        campaign.took = time.time() - start


def faults_of(campaign, folder, every):
    """What is wrong with a campaign that has ended."""
    faults = []
    try:
        campaign.answer = json.loads((folder / f"{campaign.name}.json").read_text(encoding="utf-8"))
    except ValueError as error:
        said = (folder / f"{campaign.name}.err").read_text(encoding="utf-8", errors="replace")
        faults.append(f"no report ({error}): {said.strip()[-400:]}")
    if campaign.code not in (0, 1):
        faults.append(f"exit code {campaign.code}")
    findings = folder / "out" / campaign.name / "findings"
    for finding in sorted(findings.iterdir()) if findings.is_dir() else []:
        signature = finding.name
        try:
            if not campaign.explains(finding, signature):
                faults.append(f"a finding that the program has not earned: {finding}")
        except (OSError, ValueError) as error:
            faults.append(f"a finding that cannot be read: {finding}: {error}")
    left = os.listdir(folder / "tmp" / campaign.name)
    if left:
        faults.append("left files: " + " ".join(left[:20]))
    grown = campaign.samples[int(MINUTES_OF_LIFE * 60 / every):]
    if len(grown) >= 6:
        for key in ("resident", "descriptors"):
            thirds = [statistics.median(row[key] for row in part)
                      for part in (grown[len(grown) // 3:2 * len(grown) // 3], grown[2 * len(grown) // 3:])]
            if thirds[1] > thirds[0] * GROWTH + (SLACK if key == "resident" else 2):
                faults.append(f"{key} grew: {thirds[0]:.0f} in the middle third, {thirds[1]:.0f} in the last")
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command")
    parser.add_argument("--hours", type=float, default=2.0)
    parser.add_argument("--folder", type=pathlib.Path, help="a new folder for it all; without it one that is removed")
    parser.add_argument("--every", type=float, default=60.0, help="seconds between two samples")
    options = parser.parse_args()
    command = os.path.abspath(options.command)
    temporary = None
    if options.folder:
        folder = options.folder.resolve()
        folder.mkdir(parents=True)
    else:
        temporary = tempfile.TemporaryDirectory(prefix="long-campaign-")
        folder = pathlib.Path(temporary.name).resolve()
    os.environ["PATH"] = "/usr/bin:/bin:" + os.environ.get("PATH", "")
    workers = [adapter_campaign(command, folder, language) for language in ("python", "c++", "javascript")]
    hostile = [hostile_campaign(command, folder, NAMESPACES, False), hostile_campaign(command, folder, SUPERVISOR, False),
               hostile_campaign(command, folder, NAMESPACES, True)]
    print("| minute | campaign | kB | kB of supervisors | processes | descriptors | files in TMPDIR | files of the output | kB of the journal |\n"
          "| --: | --- | --: | --: | --: | --: | --: | --: | --: |", flush=True)
    began = time.time()
    seconds = options.hours * 3600
    lanes = [threading.Thread(target=lane, args=(command, folder, *which, seconds, options.every, began))
             for which in ((workers, (1 / 3, 1 / 3, 1 / 3)), (hostile, (0.5, 0.3, 0.2)))]
    for thread in lanes:
        thread.start()
    for thread in lanes:
        thread.join()
    faults = 0
    print("\n| campaign | minutes | cases | findings, all explained | kB at first | kB at last | processes at most |\n"
          "| --- | --: | --: | --: | --: | --: | --: |")
    wrong = []
    for campaign in workers + hostile:
        found = faults_of(campaign, folder, options.every)
        wrong += [f"{campaign.name}: {fault}" for fault in found]
        findings = folder / "out" / campaign.name / "findings"
        resident = [row["resident"] for row in campaign.samples] or [0]
        print(f"| {campaign.name} | {campaign.took / 60:.0f} | {campaign.answer.get('results', [{}])[0].get('cases')} | "
              f"{len(list(findings.iterdir())) if findings.is_dir() else 0} | {resident[0]} | {resident[-1]} | "
              f"{max((row['processes'] for row in campaign.samples), default=0)} |")
    left = processes_in(str(folder))
    if left:
        wrong.append("left processes: " + " ".join(left))
    faults = len(wrong)
    print("\n".join(["", *wrong, f"{len(workers + hostile)} campaigns in {(time.time() - began) / 60:.0f} minutes, {faults} faults"]), flush=True)
    if temporary:
        temporary.cleanup()
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
