#!/usr/bin/env python3
"""Holds circumspect-verified to the oracle, on drawn domains and point sets, and on forged files about them.

    proofs/forgeries.py CIRCUMSPECT CIRCUMSPECT_VERIFIED [--domains N] [--impossible N] [--points N] [--alone N]
        [--hulls N] [--flats N] [--surfaces N] [--periodic N] [--forgeries N] [--seed S]

Each domain and each point set is drawn by `circumspect generate` and meshed by `circumspect build`; half of the meshes are
then broken, and three quarters of those that are judged alone, as complexes. What `circumspect certify` writes of such a mesh
has to be verified, and compared with the user's own files; so has the proof that `inspect --refutations` writes where a domain
has no triangulation or no CDT.

Each of these files is then forged: numbers, lines, sections and the claim are changed, or come from another file; or its mesh is
changed, and all that points into it is made anew (rebuilding.py). A forgery may be verified, as not every number matters: then
what it says has to be so. What is so is asked of the oracle by the definitions, of the user's own mesh and domain, with which the
forgery is compared; one that is not compared with a mesh is asked for its own.

It prints what it counted. Exit code 1: a file of ours is not verified, or a forgery is and should not be; the file is kept.
"""
import argparse
import collections
import functools
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time

import drawing
import rebuilding

CLAIMS_ABOUT_DOMAINS = ("plc-triangulation", "steiner-triangulation", "conforming-delaunay", "cdt", "steiner-cdt")
CLAIMS = {"points": ("triangulation", "delaunay"), "alone": ("complex",), "domain": CLAIMS_ABOUT_DOMAINS,
          "hulls": ("convex-hull",), "flats": ("triangulation", "delaunay"), "surfaces": ("surface-delaunay",),
          "periodic": ("periodic-delaunay",)}
# How many faults a mesh gets; of others none or one.
FAULTS = {"alone": (0, 1, 2, 3), "hulls": (0, 1), "surfaces": (0, 1, 2)}
KEPT = pathlib.Path("forgeries-failed")
# What the oracle does not take: no claim holds of equal points, no simplices, or a simplex of more
# than D+1 vertices, which are no simplex of R^D.
NOTHING_HOLDS = "expected (distinct points|simplices, found none|at most [0-9]+ vertices of a simplex in dimension)"
# Of what it takes nobody asks it (docs/theory/definitions.md), or it is beyond what it takes.
NOT_ASKED = "the lattice moves none to another|expected offsets of at most 2\\^32"


class Wrong(Exception):
    """A file of ours that is not verified, or a forgery that is and should not be."""


class Programs:
    """The two programs, and what the oracle said before; and how often the definitions took too long.

    A program takes longer to start than to check a small file. So `answers`, which make builds beside circumspect-verified of the
    same sources, answers in its place; of one file in SELDOM, and of all of ours, the program itself is asked, too.
    """
    SELDOM = 25

    def __init__(self, circumspect, verified):
        self.circumspect, self.verified = circumspect, verified
        self.truths = {}
        self.by_lemma = 0
        answers = pathlib.Path(verified).with_name("answers")
        self.answers = subprocess.Popen([answers], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) if answers.exists() else None
        self.asked = 0

    def run(self, *arguments):
        return subprocess.run([self.circumspect, *map(str, arguments)], capture_output=True, text=True)

    def answer_by_itself(self, *arguments):
        """What circumspect-verified prints, and its exit code."""
        ended = subprocess.run([self.verified, *map(str, arguments)], capture_output=True, text=True)
        if ended.returncode not in (0, 1, 3):
            raise Wrong(f"exit code {ended.returncode}: {ended.stdout}{ended.stderr}")
        return ended.stdout.strip(), ended.returncode

    def answer(self, *arguments):
        """The same, in most cases of `answers`."""
        self.asked += 1
        if self.answers is None:
            return self.answer_by_itself(*arguments)
        self.answers.stdin.write("\t".join(map(str, arguments)) + "\n")
        self.answers.stdin.flush()
        lines = []
        while not lines or not re.match("[0-9]+ ", lines[-1]):
            lines.append(self.answers.stdout.readline())
            if not lines[-1]:
                raise Wrong(f"`answers` ended: {arguments}")
        code, last = lines.pop().split(" ", 1)
        answer = ("".join(lines).removesuffix("\n") + last).strip(), int(code)
        if self.asked % self.SELDOM == 0 and (itself := self.answer_by_itself(*arguments)) != answer:
            raise Wrong(f"`answers` says {answer}, circumspect-verified {itself}: {arguments}")
        return answer

    def truth(self, claim, *arguments):
        """The verdict by the definitions: its JSON."""
        key = (claim, *map(str, arguments))
        if key not in self.truths:
            asked = ("check", *arguments, "--claim", claim, "--format", "json", "--max-errors", 0)
            ended = self.run(*asked, "--by", "definition", "--limit", "60s")
            if ended.returncode == 4:  # a lattice with a long vector takes the definitions long
                self.by_lemma += 1
                ended = self.run(*asked)
            if ended.returncode == 3 and re.search(NOTHING_HOLDS, ended.stderr):
                self.truths[key] = {"verdict": "input", "rules": []}
            elif ended.returncode == 3 and re.search(NOT_ASKED, ended.stderr):
                self.truths[key] = {"verdict": "not asked", "rules": []}
            elif ended.returncode not in (0, 1):
                raise Wrong(f"check {key}: {ended.stderr}")
            else:
                self.truths[key] = json.loads(ended.stdout)["results"][0]
        return self.truths[key]

    def learn(self, questions):
        """Asks at once what differs in the mesh alone; what cannot be told at once is asked by itself later (`truth`)."""
        meshes = collections.defaultdict(dict)
        for claim, mesh, *options in questions:
            if (claim, str(mesh), *map(str, options)) not in self.truths:
                meshes[claim, *map(str, options)][str(mesh)] = None
        for (claim, *options), paths in meshes.items():
            ended = self.run("check", *paths, *options, "--claim", claim, "--format", "json", "--max-errors", 0, "--by", "definition",
                             "--limit", "10s")
            for result in json.loads(ended.stdout)["results"]:
                if "verdict" in result:
                    self.truths[(claim, result["mesh"], *options)] = result


class Subject:
    """A file that circumspect-verified reads, the user's files it is about, and what is so of these."""

    def __init__(self, programs, file, own, judge, kind=None):
        self.programs, self.file, self.own, self.judge = programs, file, own, judge
        self.kind = kind  # of a domain

    def hold(self):
        line, code = self.programs.answer_by_itself(self.file, *self.own)
        if code != 0:
            raise Wrong(f"{self.file} of {self.own}: {line}")
        truth = self.judge(line)
        rules = re.match("verified: not [a-z-]+, ([a-z.-]+(?: or [a-z.-]+)*)", line)
        broken_rules = {each["rule"] for each in truth["rules"]} if truth else set()
        names_same = not line.startswith("verified: not periodic-delaunay")  # docs/certificates.md: its rules are others
        if truth and rules and names_same and broken_rules.isdisjoint(rules[1].split(" or ")):
            raise Wrong(f"{line} -- by the definitions other rules are broken: {broken_rules}")


def are_in_space(mesh):
    """Whether the points of a mesh have three coordinates in its file."""
    if mesh.suffix == ".json":
        points = json.loads(mesh.read_text())["points"]
        return bool(points) and len(points[0]) == 3
    return mesh.with_suffix(".node").read_text().split(None, 2)[1] == "3"


def question(line, mesh, domain, kind):
    """What the oracle is asked about a line: the claim, the mesh and options."""
    stated = re.match("verified: (?:not )?([a-z-]+)", line)
    if stated is None:
        raise Wrong(line)
    # `check` leaves out a third coordinate that is the same for all points.
    about = [stated[1], mesh, *(["--dimension", 3] if are_in_space(mesh) else [])]
    if domain is not None:  # a refutation that looks at vertices and segments alone names no kind
        filled = re.search("domain: (enclosed|hull)", line)
        about += ["--domain", domain, "--domain-kind", filled[1] if filled else kind]
    lattice = re.search("; lattice: ([^:]+)(:|$)", line)  # which is in no file of the user's
    return about + (["--lattice", lattice[1]] if lattice else [])


def judge_line(programs, line, mesh, domain, kind):
    """Whether a line of circumspect-verified is so, of this mesh: the oracle's verdict."""
    truth = programs.truth(*question(line, mesh, domain, kind))
    if truth["verdict"] == "not asked":
        return truth
    says_that_it_holds = not line.startswith("verified: not ")
    if (truth["verdict"] == "holds") != says_that_it_holds:
        raise Wrong(f"{line} -- by the definitions it {truth['verdict']}: {truth['rules']}")
    if domain is None and says_that_it_holds:
        for standing in ("unique", "canonical"):
            if f", {standing}" in line and not truth[standing]:
                raise Wrong(f"{line} -- it is not {standing}")
    return truth


class Case:
    """A mesh, what is claimed of it and, for a claim about one, its domain."""

    def __init__(self, mesh, claim, domain=None, kind=None, options=()):
        self.mesh, self.claim, self.domain, self.kind = mesh, claim, domain, kind
        self.options = [*options, *(["--domain", domain, "--domain-kind", kind] if domain else [])]

    def own(self):
        return [self.mesh.with_suffix(".node"), self.mesh, *([self.domain] if self.domain else [])]


def meshed(programs, kind, folder, number, dice, counts):
    """What is drawn, and a mesh of it, if there is one."""
    if kind == "periodic":
        mesh, lattice = drawing.repeated(folder, dice)
        return Case(mesh, "periodic-delaunay", options=["--lattice", lattice])
    path = drawing.drawn(programs, kind, folder, number, dice)
    if path is None:
        counts[f"{kind}: not drawn"] += 1
        return None
    mesh = folder / "mesh.ele"
    if kind == "domain":
        which = dice.choice(("enclosed", "enclosed", "hull"))
        if dice.randrange(4) == 0:
            drawing.let_dangle(path, dice)
        case = Case(mesh, dice.choice(CLAIMS[kind]), path, which)
        is_planar = path.read_text().split(None, 2)[1] == "2"
        construction = "planar-cdt" if is_planar else dice.choice(("cdt", "steiner-cdt", "conforming-delaunay"))
        ended = programs.run("build", construction, path, "--domain-kind", which, "-o", mesh, "--quiet", "--limit", "5s")
    else:
        if kind == "flats":
            drawing.tilted(path, dice)
        weighted = path.read_text().split(None, 3)[2] == "1"
        case = Case(mesh, "weighted-delaunay" if weighted else dice.choice(CLAIMS[kind]))
        ended = programs.run("build", "weighted-delaunay" if weighted else "delaunay", path, "-o", mesh, "--quiet")
    if ended.returncode != 0:
        counts[f"{kind}: not meshed"] += 1
        return None
    if kind in ("hulls", "surfaces"):
        is_planar = drawing.leave_facets(mesh) == 2
        if is_planar and dice.randrange(2):
            drawing.list_as_cycle(mesh)
    return case


def certified(programs, kind, folder, number, dice, counts):
    """What certify writes of a drawn mesh, whole or broken, if there is one."""
    case = meshed(programs, kind, folder, number, dice, counts)
    if case is None:
        return None
    for _ in range(dice.choice(FAULTS.get(kind, (0, 1)))):
        # Of a hull it is refuted that a facet is missing, and hardly anything else.
        drawing.broken(case.mesh, dice, 0 if kind == "hulls" and dice.randrange(4) else dice.randrange(4))
    file = folder / "file"
    ended = programs.run("certify", case.mesh, *case.options, "--claim", case.claim, "--by", "definition", "--quiet", "-o", file,
                         "--limit", "20s")
    lacking = re.search("there is no (certificate|refutation) of this mesh: (.*)", ended.stderr)
    if ended.returncode == 2 and lacking:
        counts[f"{kind}: no {lacking[1]}: {re.sub('[0-9]+', 'N', lacking[2])}"] += 1
        return None
    if ended.returncode in (2, 3, 4):  # what no file can be about: points of a plane, equal points
        counts[f"{kind}: refused"] += 1
        return None
    if ended.returncode not in (0, 1):
        raise Wrong(f"certify {case.mesh} {case.options}: {ended.stderr}")
    counts[f"{kind}: {'certificates' if ended.returncode == 0 else 'refutations'}"] += 1
    return Subject(programs, file, case.own(), lambda line: judge_line(programs, line, case.mesh, case.domain, case.kind), case.kind)


def impossible(programs, folder, number, dice, counts):
    """The proof that a drawn domain has no triangulation or no CDT, if it has none."""
    path = drawing.drawn(programs, "impossible", folder, number, dice)
    if path is None:
        counts["impossible: not drawn"] += 1
        return None
    found = {}

    def lacks(what, kind):
        if kind not in found:
            found[kind] = programs.run("inspect", path, "--domain-kind", kind, "--refutations", folder / f"proof-{kind}", "--limit",
                                       "60s").stdout
        return f"{what}: none (proved)" in found[kind]

    def judge(line):
        stated = re.match("verified: no (triangulation|CDT) without Steiner points; domain: (enclosed|hull)", line)
        names = {"CDT": "constrained Delaunay triangulation", "triangulation": "triangulation without Steiner points"}
        if stated is None or not (lacks(names[stated[1]], stated[2]) or lacks(names["triangulation"], stated[2])):
            raise Wrong(f"{line} -- {found}")

    kind = dice.choice(("enclosed", "hull"))
    lacks("triangulation", kind)
    for name in ("triangulation", "cdt"):
        file = folder / f"proof-{kind}-{name}.proof"
        if file.exists():
            counts["impossible: proofs"] += 1
            return Subject(programs, file, [path], judge)
    counts["impossible: there is one"] += 1
    return None


NUMBER = re.compile("-?[0-9]+|-")
HEAD = re.compile("[a-z][a-z.-]*")


def a_number(lines, dice):
    """One of those in a file, but for the longest."""
    row = dice.choice([row for row in lines if row] or [["1"]])
    return next((token for token in dice.sample(row, len(row)) if token != "-" and len(token) <= 30 and NUMBER.fullmatch(token)), "1")


def changed_number(token, lines, dice):
    if token == "-":
        return a_number(lines, dice)
    value = int(token)
    return str(dice.choice((value + 1, value - 1, -value, 0, 2 * value, int(a_number(lines, dice)))))


def forged(text, others, dice):
    """One to three changes, each of one place."""
    lines = [line.split() for line in text.splitlines()]
    for _ in range(dice.choice((1, 1, 1, 2, 3))):
        heads = [i for i, line in enumerate(lines) if line and HEAD.fullmatch(line[0])]
        row = dice.randrange(len(lines))
        line = lines[row]
        how = dice.randrange(16)
        if how <= 9 and line:  # a number
            places = [i for i, token in enumerate(line) if NUMBER.fullmatch(token)]
            if places:
                i = dice.choice(places)
                line[i] = changed_number(line[i], lines, dice)
        elif how == 10 and len(line) > 1:  # two tokens of a line change places
            i, j = dice.sample(range(len(line)), 2)
            line[i], line[j] = line[j], line[i]
        elif how == 11 and row + 1 < len(lines):  # two lines change places
            lines[row], lines[row + 1] = lines[row + 1], line
        elif how == 12:  # a line goes or comes twice, and is counted
            begin = max((i for i in heads if i <= row), default=0)
            more = dice.choice((-1, 1))
            lines[row:row + 1] = [] if more < 0 else [line, list(line)]
            if begin != row and len(lines[begin]) > 1 and lines[begin][-1].isdigit():
                lines[begin][-1] = str(max(0, int(lines[begin][-1]) + more))
        elif how == 13:  # kept, or not
            signs = [(i, token) for i, token in enumerate(line[:1]) if token in "+-"]
            if signs:
                line[0] = "-" if line[0] == "+" else "+"
        elif how == 14:  # what is claimed
            first = lines[0]
            place = dice.randrange(2, len(first) + 1) if len(first) > 2 else len(first)
            word = dice.choice(("delaunay", "triangulation", "2", "3", "unique", "canonical", "plc", "enclosed", "hull", "complex",
                                *CLAIMS_ABOUT_DOMAINS))
            first[place:place + dice.randrange(2)] = [word]
        elif others and heads:  # a section of another file
            other = [each.split() for each in dice.choice(others).splitlines()]
            section = lines[dice.choice(heads)][:1]
            begins = [i for i, each in enumerate(other) if each[:1] == section]
            if begins:
                begin = begins[0]
                end = next((i for i in range(begin + 1, len(other))
                            if other[i] and HEAD.fullmatch(other[i][0])), len(other))
                own = next(i for i, each in enumerate(lines) if each[:1] == section)
                own_end = next((i for i in heads if i > own), len(lines))
                lines[own:own_end] = other[begin:end]
        if not lines:
            return text
    return "\n".join(" ".join(line) for line in lines) + "\n"


def hold_forgeries(subject, count, others, folder, dice, counts):
    """Forgeries of one file, each compared with the user's files or, now and then, with no mesh."""
    programs, text = subject.programs, subject.file.read_text()
    of_mesh = not text.startswith("circumspect-impossibility")
    domain = subject.own[2:]
    stated, meshes = [], {}
    for number in range(count):
        file = folder / f"forgery-{number}"
        forgery = rebuilding.rebuilt(text, dice) if of_mesh and dice.random() < 0.5 else None
        is_rebuilt = forgery is not None
        file.write_text(forgery if is_rebuilt else forged(text, others, dice))
        # Of a mesh that is another the user's own would tell.
        own = domain if of_mesh and (is_rebuilt or dice.random() < 0.3) else subject.own
        if own is not subject.own and text.split(None, 3)[2] == "periodic-delaunay":  # of offsets no mesh.json tells
            own = rebuilding.files_of_cells(file, folder / f"forged-{number}") or subject.own
        line, code = programs.answer(file, *own)
        word = line.split(":", 1)[0] if code != 0 else "verified, and so"
        counts[f"{'rebuilt' if is_rebuilt else 'forgeries'}: {word}"] += 1
        if code != 0:
            continue
        if own == domain:
            mesh = folder / f"forged-{number}.json"
            mesh.write_text(programs.answer("--mesh", file)[0])
            own = [mesh]
        # Many forgeries are about the same mesh.
        same = None if own == subject.own else meshes.setdefault(tuple(each.read_text() for each in own), own[-1])
        stated.append((file.name, line, same))
    about_domain = domain[0] if domain else None, subject.kind
    programs.learn([question(line, same, *about_domain) for _, line, same in stated if same])
    for name, line, same in stated:
        try:
            judge_line(programs, line, same, *about_domain) if same else subject.judge(line)
        except Wrong as wrong:
            raise Wrong(f"{name}: {wrong}") from wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("circumspect")
    parser.add_argument("verified")
    for name, default in (("domains", 60), ("impossible", 12), ("points", 40), ("alone", 20), ("hulls", 20), ("flats", 10), ("surfaces", 10),
                          ("periodic", 10), ("forgeries", 8), ("seed", 1)):
        parser.add_argument(f"--{name}", type=int, default=default)
    asked = parser.parse_args()
    programs = Programs(str(pathlib.Path(asked.circumspect).resolve()), str(pathlib.Path(asked.verified).resolve()))
    if "CIRCUMSPECT_SOAK" in os.environ:  # others each time (properties/soak.py)
        asked.seed += int(re.search("seed=([0-9]+)", os.environ["RC_PARAMS"])[1]) % 10**12
    ends = time.monotonic() + float(os.environ.get("CIRCUMSPECT_SECONDS", "inf"))
    dice = random.Random(asked.seed)
    counts, others = collections.Counter(), []
    makers = {kind: functools.partial(certified, programs, kind) for kind in CLAIMS}
    makers["impossible"] = functools.partial(impossible, programs)
    numbers = {"domain": asked.domains, "impossible": asked.impossible, "points": asked.points, "alone": asked.alone, "hulls": asked.hulls,
               "flats": asked.flats, "surfaces": asked.surfaces, "periodic": asked.periodic}
    work = [kind for kind, number in numbers.items() for _ in range(number)]
    dice.shuffle(work)
    with tempfile.TemporaryDirectory() as scratch:
        for number, kind in enumerate(work):
            if time.monotonic() > ends:
                break
            counts["inputs"] += 1
            folder = pathlib.Path(scratch) / str(number)
            folder.mkdir()
            programs.truths.clear()
            try:
                subject = makers[kind](folder, asked.seed * 1000003 + number, dice, counts)
                if subject is not None:
                    subject.hold()
                    hold_forgeries(subject, asked.forgeries, others, folder, dice, counts)
                    others = (others + [subject.file.read_text()])[-30:]
            except Wrong as wrong:
                shutil.rmtree(KEPT, ignore_errors=True)
                shutil.copytree(folder, KEPT)
                print(f"{kind} {number} of seed {asked.seed}, kept in {KEPT}: {wrong}", file=sys.stderr)
                counts["wrong"] += 1
                break
            shutil.rmtree(folder)
    counts["judged by the lemmas"] = programs.by_lemma
    print(f"inputs: {counts.pop('inputs')} of {len(work)}")
    for what, count in sorted(counts.items()):
        print(f"{what}: {count}")
    return 1 if counts["wrong"] else 0


if __name__ == "__main__":
    sys.exit(main())
