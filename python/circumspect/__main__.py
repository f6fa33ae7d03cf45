"""The judge on the command line: python3 -m circumspect check MESH [--claim CLAIM] [--domain FILE].

MESH is any file that meshio reads, or an .npz file with the arrays points and simplices. The command
`circumspect` reads its own formats, exactly, and does much more: where it is in the package, it gets the
words.
"""
import argparse
import os
import pathlib
import signal
import sys

import circumspect
from circumspect import _core

# Which meshio reads and the command does not.
FILES_OF_MESHIO = (".ex2", ".cgns", ".h5m", ".med", ".avs", ".f3grid", ".hmf", ".tec",
                   ".ugrid", ".post", ".post.gz", ".dato", ".dato.gz")
VERIFIED = pathlib.Path(__file__).with_name("bin") / "circumspect-verified"


def loaded(path: str):
    """A mesh, and a note how exact its reader is."""
    if path.endswith(".npz"):
        import numpy as np

        with np.load(path, allow_pickle=False) as arrays:
            if "points" not in arrays or "simplices" not in arrays:
                raise ValueError(f"{path}: expected the arrays points and simplices, found {sorted(arrays)}")
            return arrays["points"], arrays["simplices"], "NumPy reads doubles as they were written"
    try:
        import meshio
    except ImportError:
        raise ValueError(f"{path}: expected meshio to be installed, which reads such files "
                         "(Debian: python3-meshio); the command circumspect reads many without it") from None
    try:
        mesh = meshio.read(path)
    except (Exception, SystemExit) as error:  # meshio's readers raise whatever happens to them, or end the process
        raise ValueError(f"{path}: expected a mesh that meshio reads, found none: {error}") from None
    return mesh, None, (f"meshio {meshio.__version__} read the points as {mesh.points.dtype}; what its reader or the "
                        "program that wrote the file rounded is judged as it is now")


def is_for_command(words) -> bool:
    """Is the command in the package, and does it read the files that are named?"""
    return hasattr(_core, "command") and not (words[:1] == ["check"] and any(
        word.endswith(FILES_OF_MESHIO) for word in words[1:]))


def command(words) -> int:
    """The command itself, in this process, which then handles signals as any program does."""
    for name in ("SIGINT", "SIGPIPE", "SIGXFSZ"):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), signal.SIG_DFL)
    return _core.command(["circumspect", *words])


def verified() -> None:
    """circumspect-verified, which checks certificates, where it came with the package."""
    if not VERIFIED.exists():
        sys.exit("circumspect: expected circumspect-verified in the package, found none: a wheel has it, and `make verified` "
                 "in the sources builds it from its proof")
    os.execv(VERIFIED, ["circumspect-verified", *sys.argv[1:]])


def main(arguments=None) -> int:
    """0: all claims hold; 1: one does not; 2: usage; 3: an input is at fault; 4: not decided, within the limit or before an interrupt."""
    words = sys.argv[1:] if arguments is None else list(arguments)
    return command(words) if is_for_command(words) else judged_here(words)


def judged_here(words) -> int:
    """What Python reads, and all where the command is not in the package; answers as `main`."""
    parser = argparse.ArgumentParser(prog="python3 -m circumspect", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--version", action="version", version=f"circumspect {circumspect.__version__}")
    commands = parser.add_subparsers(dest="command", required=True)
    check = commands.add_parser("check", help="judge meshes")
    check.add_argument("mesh", nargs="+")
    check.add_argument("--claim")
    check.add_argument("--domain", metavar="FILE", help="a surface of triangles")
    check.add_argument("--duplicates", choices=("reject", "merge"), default="reject",
                       help="reject a mesh with equal points (default), or take them for one")
    check.add_argument("--allow-empty", action="store_true", help="judge a mesh without points and simplices")
    check.add_argument("--limit", type=float, metavar="SECONDS", help="end without an answer after so long (exit code 4)")
    check.add_argument("--format", choices=("text", "json"), default="text")
    options = parser.parse_args(words)
    codes = set()
    for path in options.mesh:
        try:
            mesh, simplices, note = loaded(path)
            domain = None if options.domain is None else loaded(options.domain)[0]
            verdict = circumspect.check(mesh, simplices, options.claim, domain=domain, name=path, limit=options.limit,
                                        duplicates=options.duplicates, allow_empty=options.allow_empty)
        except (ValueError, TypeError, OSError, circumspect.Undecided) as error:
            what = str(error).removeprefix(f"{path}: ")
            for keyword, option in (('give duplicates="merge"', "add --duplicates merge"),
                                    ("give allow_empty=True", "add --allow-empty")):
                what = what.replace(keyword, option)
            print(f"circumspect: {path}: {what}", file=sys.stderr)
            codes.add(4 if isinstance(error, circumspect.Undecided) else 3)
            continue
        for each in (note, *verdict.notes):
            print(f"note: {each}", file=sys.stderr)
        print(verdict.json if options.format == "json" else verdict.text.rstrip("\n"))
        codes.add(0 if verdict else 1)
    return next(code for code in (3, 1, 4, 0) if code in codes)


def run() -> None:
    """The program."""
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        print("circumspect: interrupted", file=sys.stderr)
        sys.exit(4)


if __name__ == "__main__":
    run()
