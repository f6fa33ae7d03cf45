#!/usr/bin/env python3
"""circumspect-mpi says what circumspect check says, byte for byte, for any number of ranks and any file that it reads.

    mpi_test.py CIRCUMSPECT_MPI CIRCUMSPECT CORPUS [--all]

With --all every .ele file of the corpus is judged, on one, two, three and five ranks; without, some on three.

Open MPI 4 sometimes takes a rank that has ended well for one that ended without MPI_Finalize, and ends with 1 (issue 7833 of open-mpi/ompi, which is
not to be mended before Open MPI 5). So each rank says with what code it ended; where all said 0, and mpirun complains of just that, it is run again.
It also kills all ranks as soon as one ends with 1, and once in some thousand runs what they printed is lost: nothing of a verdict is there.
Then it is run again, too. And where a rank is killed before it has come to MPI_Init, mpirun sometimes waits for ever, if the machine is busy:
what has not ended by then is run again, and has to end one of three times.
"""
import concurrent.futures
import os
import pathlib
import random
import re
import struct
import subprocess
import sys
import tempfile

MPIRUN = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n"]
SAYING_ITS_CODE = ["sh", "-c", '"$@"; code=$?; echo "a rank ended with $code" >&2; exit $code', "sh"]
ALL_AGAIN = 3
WORKERS = 4  # of --all; mpirun mostly sleeps
SOME = ["peers/tetgen/hunted-tetgen-covered-twice-3d.1.ele", "peers/tetgen/random-3d-500.1.ele"]


class Failed(Exception):
    """What was found where something else was expected."""


def expect(what, found, expected):
    if found != expected:
        raise Failed(f"{what}: expected {expected!r}, found {found!r}")


def mpirun_alone_failed(ended, ranks):
    """All ranks said that they ended with 0, and mpirun says that one of them ended before its time."""
    return (ended.returncode != 0 and ended.stderr.count("a rank ended with 0\n") == ranks and
            "exiting improperly" in ended.stderr)


def mpirun_lost_what_was_printed(ended):
    return ended.returncode == 1 and not ended.stdout and "a rank ended with 1\n" in ended.stderr


class Commands:
    def __init__(self, mpi, check):
        self.mpi, self.check = mpi, check

    def on_ranks(self, ranks, *words, program=None):
        command = [*MPIRUN, str(ranks), *(program or [*SAYING_ITS_CODE, self.mpi]), *map(str, words)]
        return self.run_again_where_mpirun_alone_failed(command, ranks)

    def with_other_words(self, *words_of_ranks, seconds=60):
        """One rank for each list of words, which mpirun starts with those; `folder` may come first, as a path."""
        command = [*MPIRUN[:-1]]
        for words in words_of_ranks:
            folder = ["-wdir", str(words[0])] if isinstance(words[0], pathlib.Path) else []
            command += [*([":"] if words is not words_of_ranks[0] else []), "-n", "1", *folder, *SAYING_ITS_CODE, self.mpi,
                        *map(str, words[len(folder) // 2:])]
        return self.run_again_where_mpirun_alone_failed(command, len(words_of_ranks), seconds)

    @staticmethod
    def run_again_where_mpirun_alone_failed(command, ranks, seconds=100):
        for tries_left in reversed(range(ALL_AGAIN)):
            # Every mpirun of a user has its sessions in one folder of this one, and removes it at
            # its end, with those of others.
            with tempfile.TemporaryDirectory(prefix="mpi", ignore_cleanup_errors=True) as own:
                try:
                    ended = subprocess.run(command, capture_output=True, text=True, timeout=seconds, check=False,
                                           env={**os.environ, "TMPDIR": own})
                except subprocess.TimeoutExpired:
                    if not tries_left:
                        raise
                    print(f"{' '.join(command)}: no end within {seconds} s")
                    continue
            if not mpirun_alone_failed(ended, ranks) and not mpirun_lost_what_was_printed(ended):
                break
            print(f"{' '.join(command)}: mpirun alone ended with {ended.returncode}, and said {ended.stderr!r}")
        return ended

    def by_one(self, *words):
        ended = subprocess.run([self.check, "check", *map(str, words)], capture_output=True, text=True, timeout=600,
                               check=False)
        ended.stdout = without_what_needs_it_whole(ended.stdout)
        return ended

    def same(self, ranks, *words):
        """The same standard output and exit code; of an error also the same line. Returns the exit code."""
        one, all_ranks = self.by_one(*words), self.on_ranks(ranks, *words)
        all_ranks.stdout = without_what_needs_it_whole(all_ranks.stdout)
        what = f"{ranks} ranks, {' '.join(map(str, words))}"
        if all_ranks.returncode != one.returncode or all_ranks.stdout != one.stdout:
            print(f"{what}: standard error was {all_ranks.stderr!r}")
        expect(what, (all_ranks.returncode, all_ranks.stdout), (one.returncode, one.stdout))
        if one.returncode == 3:
            line = one.stderr.replace("circumspect: ", "circumspect-mpi: ", 1)
            expect(what, line in all_ranks.stderr, True)
        return one.returncode


def without_what_needs_it_whole(text):
    """Causes are looked for in a whole mesh alone, and whether it is a complex at least; on ranks a note names that claim."""
    if not text.startswith("{"):
        return "".join(line for line in text.splitlines(True)
                       if "--claim complex" not in line and "the others " not in line and not line.startswith("cause: "))
    text = re.sub(r',?\s*"[^"]*--claim complex[^"]*"', "", text)
    return re.sub(r'\n      "causes": \[.*?\n      \],', "", text, flags=re.DOTALL)


def npy(path, kind, columns, rows, fortran=False):
    """Writes rows of numbers as numpy.save does; `kind` is NumPy's name of the type, such as '<f8'."""
    code = kind[0].replace("|", "<") + {"f8": "d", "f4": "f", "i8": "q", "i4": "i", "u8": "Q", "i2": "h"}[kind[1:]]
    head = repr({"descr": kind, "fortran_order": fortran, "shape": (len(rows), columns)})
    head += " " * (63 - (10 + len(head)) % 64) + "\n"
    values = [row[j] for j in range(columns) for row in rows] if fortran else [x for row in rows for x in row]
    path.write_bytes(b"\x93NUMPY\x01\0" + struct.pack("<H", len(head)) + head.encode() +
                     b"".join(struct.pack(code, x) for x in values))
    return path


def rows_of(path, number):
    """The rows of a .node or .ele file without their indices, which are from 0."""
    lines = [line.split() for line in path.read_text().splitlines() if line.strip() and line[0] != "#"]
    width = {".node": 3, ".ele": 4}[path.suffix]
    return [tuple(map(number, line[1:1 + width])) for line in lines[1:]]


def arrays(commands, corpus, folder):
    """Arrays of every type and order, right and wrong."""
    mesh = corpus / "peers/tetgen/random-3d-500.1.ele"
    points, listed = rows_of(mesh.with_suffix(".node"), float), rows_of(mesh, int)
    simplices = [tuple(v - 1 for v in row) for row in listed]  # the file counts from 1
    p, s = folder / "p.npy", folder / "s.npy"
    for kind_of_p, kind_of_s, fortran in [("<f8", "<i8", False), (">f8", "<i4", True), ("<f8", ">i2", True)]:
        npy(p, kind_of_p, 3, points, fortran)
        npy(s, kind_of_s, 4, simplices, fortran)
        expect("arrays", commands.same(3, s, "--points", p), 0)
    expect("a claim", commands.same(2, s, "--points", p, "--claim", "triangulation"), 0)
    npy(s, "<i4", 4, listed)
    expect("points of text", commands.same(3, s, "--points", mesh.with_suffix(".node")), 0)
    npy(s, "<i8", 4, simplices[:700] + [(1, 2, 3, 500), (-7, 2, 3, 2 ** 62)] + simplices[700:])
    expect("indices of no points", commands.same(3, s, "--points", p), 1)
    npy(s, "<i8", 4, simplices[:-1])
    for form in ("text", "json"):
        expect("one missing", commands.same(3, s, "--points", p, "--max-errors", "1", "--format", form), 1)
    expect("shuffled", commands.same(3, npy(s, "<i8", 4, random.Random(1).sample(simplices, len(simplices))),
                                     "--points", p), 0)
    npy(s, "<i8", 4, simplices)
    npy(p, "<f8", 3, points[:-1] + [points[3]])
    equal = commands.on_ranks(3, s, "--points", p)
    expect("equal points", (equal.returncode, "found points 3 and 499 equal" in equal.stderr), (3, True))
    npy(p, "<f8", 3, points[:400] + [(0.5, float("nan"), 0)] + points[401:])
    expect("not a number", commands.same(3, s, "--points", p), 3)
    npy(p, "<f8", 3, points)
    s.write_bytes(npy(s, "<i8", 4, simplices).read_bytes()[:-4000])
    expect("a file cut off", commands.same(3, s, "--points", p), 3)
    expect("no file", commands.same(2, folder / "none.npy", "--points", p, "--format", "json"), 3)


def parts(commands, corpus, folder):
    """A mesh in three parts, each numbering its points for itself: as the whole, one part after the other."""
    mesh = corpus / "peers/tetgen/random-3d-500.1.ele"
    points = rows_of(mesh.with_suffix(".node"), float)
    simplices = [tuple(v - 1 for v in row) for row in rows_of(mesh, int)]
    words = [folder / "part-%d.npy", "--points", folder / "part-%d.points.npy", "--indices", folder / "part-%d.indices.npy"]

    def write(wrong=None):
        for part, (begin, end) in enumerate([(0, 900), (900, 900), (900, len(simplices))]):
            own = sorted({v for row in simplices[begin:end] for v in row}, reverse=True)
            number = {v: i for i, v in enumerate(own)}
            rows = [tuple(number[v] for v in row) for row in simplices[begin:end]]
            at = [points[v] for v in own]
            if part == 2 and wrong == "vertex":
                rows[5] = (len(own), *rows[5][1:])
            if part == 2 and wrong == "moved":
                at[7] = (9.0, 9.0, 9.0)
            if part == 2 and wrong == "missing":
                own[-1] += 1000
            if part == 2 and wrong == "gap":  # the parts have points enough, but one index is in none
                own = [v + 2 * (v == len(points) - 1) for v in own]
            npy(folder / f"part-{part}.npy", "<i4", 4, rows)
            npy(folder / f"part-{part}.points.npy", "<f8", 3, at)
            npy(folder / f"part-{part}.indices.npy", "<i8", 1, [(v,) for v in own])
            header = folder / f"part-{part}.indices.npy"
            header.write_bytes(header.read_bytes().replace(f"({len(own)}, 1)".encode(), f"({len(own)},)  ".encode()))

    for drop in (0, 1):
        simplices = simplices[drop:]
        write()
        p, s = npy(folder / "p.npy", "<f8", 3, points), npy(folder / "s.npy", "<i4", 4, simplices)
        one, all_ranks = commands.by_one(s, "--points", p), commands.on_ranks(3, *words)
        expect("parts", (all_ranks.returncode, without_what_needs_it_whole(all_ranks.stdout.replace("part-%d.npy", "s.npy"))), (drop, without_what_needs_it_whole(one.stdout)))
    expect("more parts than ranks", commands.on_ranks(2, *words).returncode, 3)
    for wrong, said in [("vertex", "part-2.npy: expected vertices from 0 to"), ("moved", "the same coordinates"),
                        ("missing", "all indices from 0 to the largest"), ("gap", f"no point of index {len(points)}")]:
        write(wrong)
        ended = commands.on_ranks(3, *words)
        expect(f"parts, {wrong}", (ended.returncode, said in ended.stderr), (3, True))


def ranks_that_are_asked_otherwise(commands, corpus, _folder):
    """Nothing is judged where ranks are asked other questions, and no rank waits for one that has ended."""
    mesh = str(corpus / SOME[0])
    for other in (["--claim", "triangulation"], ["--help"], ["--version"], ["--nonsense"], ["--max-errors", "1"]):
        for words in ([[mesh], [mesh, *other]], [[mesh, *other], [mesh]]):
            ended = commands.with_other_words(*words)
            expect(f"one rank with {other}", (ended.returncode, ended.stdout, "the same program and arguments" in ended.stderr),
                   (2, "", True))


def points_and_simplices(corpus):
    whole = corpus / "peers/tetgen/random-3d-500.1.ele"
    points, simplices = rows_of(whole.with_suffix(".node"), float), [tuple(v - 1 for v in row) for row in rows_of(whole, int)]
    return points, simplices


def files_that_differ_at_an_end(commands, corpus, folder):
    """Nothing is judged where ranks see other files."""
    (points, simplices), here, there = points_and_simplices(corpus), folder / "here", folder / "there"
    moved = [(points[0][0] + 2 ** -20, *points[0][1:]), *points[1:]]
    for what, others in [("fewer points", points[:-9]), ("more points", points + points[:7]), ("a moved point", moved)]:
        for place, some in ((here, points), (there, others)):
            place.mkdir(exist_ok=True)
            npy(place / "p.npy", "<f8", 3, some)
            npy(place / "s.npy", "<i4", 4, simplices)
        for folders in ((here, there), (there, here)):
            ended = commands.with_other_words(*([place, "s.npy", "--points", "p.npy"] for place in folders))
            expect(what, (ended.returncode, ended.stdout, "p.npy: expected the same file at all ranks" in ended.stderr), (3, "", True))
    npy(there / "s.npy", "<i4", 4, simplices[1:])
    ended = commands.with_other_words(*([place, "s.npy", "--points", "p.npy"] for place in (here, there)))
    expect("fewer simplices", (ended.returncode, ended.stdout, "s.npy: expected the same file at all ranks" in ended.stderr), (3, "", True))
    (there / "s.npy").unlink()
    expect("no file at one rank", commands.with_other_words(*([place, "s.npy", "--points", "p.npy"] for place in (here, there))).returncode, 3)


def files_that_differ_in_the_middle(commands, corpus, folder):
    """As large and with the same ends, wherever the ranks are that have the other file, and whoever reads the place; copies are the same."""
    (points, simplices), here, there = points_and_simplices(corpus), folder / "here", folder / "there"
    other_points = [*points[:250], tuple(-x for x in points[250]), *points[251:]]  # three bits, one in each of three words in a row
    other_simplices = [*simplices[:1500], (*simplices[1500][1:], simplices[1500][0]), *simplices[1501:]]
    for name, other_p, other_s in [("p.npy", other_points, simplices), ("s.npy", points, other_simplices), ("", points, simplices)]:
        for place, p, s in ((here, points, simplices), (there, other_p, other_s)):
            place.mkdir(exist_ok=True)
            npy(place / "p.npy", "<f8", 3, p)
            npy(place / "s.npy", "<i4", 4, s)
        for folders in ((here, there), (here, here, here, there), (there, here, there, here, there)):
            ended = commands.with_other_words(*([place, "s.npy", "--points", "p.npy"] for place in folders))
            what = f"{name or 'copies'} of {len(folders)} ranks"
            expect(what, (ended.returncode, ended.stdout.startswith("holds: delaunay s.npy 500 points")), (3, False) if name else (0, True))
            expect(what, name + ": expected the same file at all ranks" in ended.stderr, bool(name))


def one_dies(commands, mesh):
    """If a rank is killed, the others end."""
    script = 'if [ "$OMPI_COMM_WORLD_RANK" = 1 ]; then kill -9 $$; fi; exec "$@"'
    ended = commands.on_ranks(3, mesh, program=["sh", "-c", script, "sh", commands.mpi])
    expect("one of three is killed", (ended.returncode != 0, ended.stdout), (True, ""))


def statistics(commands, mesh):
    said = commands.on_ranks(3, mesh, "--statistics").stderr
    for rank in range(3):
        expect("statistics", f"| {rank} | facets between ranks |" in said, True)


def on_all_ranks(commands, mesh, claim):
    one = commands.by_one(mesh, "--claim", claim)
    for ranks in (1, 2, 3, 5):
        ended = commands.on_ranks(ranks, mesh, "--claim", claim)
        if ended.returncode == 3 and one.returncode != 3:
            # What is left to circumspect check is said to be.
            expect(str(mesh), "circumspect check" in ended.stderr or "vertices" in ended.stderr, True)
            return
        what = f"{ranks} ranks, {mesh}, which said {ended.stderr!r} on standard error"
        expect(what, (ended.returncode, without_what_needs_it_whole(ended.stdout)), (one.returncode, one.stdout))


def whole_corpus(commands, corpus):
    draw = random.Random(1)
    with concurrent.futures.ThreadPoolExecutor(WORKERS) as pool:
        running = [pool.submit(on_all_ranks, commands, mesh, draw.choice(["triangulation", "delaunay"]))
                   for mesh in sorted(corpus.rglob("*.ele")) if mesh.with_suffix(".node").exists()]
        faults = [str(one.exception()) for one in running if one.exception()]
    print(f"{len(running)} meshes, {len(faults)} at fault")
    if faults:
        raise Failed("\n".join(faults))


def main(words):
    commands, corpus = Commands(os.path.abspath(words[0]), os.path.abspath(words[1])), pathlib.Path(words[2])
    if "--all" in words:
        whole_corpus(commands, corpus)
        return 0
    # mpirun takes a third of a second to start, and most of that it sleeps.
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor() as pool:
        running = [pool.submit(commands.same, 3, corpus / mesh) for mesh in SOME]
        for test in (arrays, parts, ranks_that_are_asked_otherwise, files_that_differ_at_an_end, files_that_differ_in_the_middle):
            (pathlib.Path(folder) / test.__name__).mkdir()
            running.append(pool.submit(test, commands, corpus, pathlib.Path(folder) / test.__name__))
        running += [pool.submit(test, commands, corpus / SOME[1]) for test in (one_dies, statistics)]
        for one in running:
            one.result()
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except Failed as failure:
        print(failure)
        sys.exit(1)
