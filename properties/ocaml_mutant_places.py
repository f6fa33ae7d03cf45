"""Where generated_mutants.py may break a reader of certificates: ocaml_mutant_places.ml finds the places in the compiler's
typed tree.

A mutant changes a comparison, `&&` or `||`, a sum to a difference, a sign, `not`, an integer, true to false, the lesser to the
larger, all to some, or the order of two arguments of one type; or it leaves out a statement, or what an `if` or a `when` does.
"""
import atexit
import functools
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from mutant_places import NEVER, NOTHING, ROOT, Mutant

PROOFS = ROOT / "build/proofs"  # `make verified` fills it
WITHOUT = ["circumspect-verified", "quick-test", "answers"]
ASKED = """let active = match Sys.getenv_opt "CIRCUMSPECT_MUTANT" with Some n -> int_of_string n | None -> 0
let reached = Bytes.make {size} ' '
let at n = Bytes.unsafe_set reached n '!'; n = active
let () = Option.iter (fun name -> at_exit (fun () ->
    let lines = List.filter_map (fun n -> if Bytes.get reached n = '!' then Some (string_of_int n ^ "\\n") else None)
        (List.init {size} Fun.id) in
    let file = open_out_gen [Open_append; Open_creat; Open_wronly] 0o600 name in
    output_string file (String.concat "" lines);
    close_out file)) (Sys.getenv_opt "CIRCUMSPECT_REACHED")
"""


class OCamlMutant(Mutant):
    """An expression of OCaml asks in its way."""

    def asked(self, expression):
        text = {NOTHING: "()", NEVER: "false"}.get(self.other, self.text)
        return f"(if Mutated.at {self.number} then ({text}) else ({expression}))"


@functools.cache
def places_program():
    """Compiled in a folder that goes when this process does."""
    folder = pathlib.Path(tempfile.mkdtemp())
    atexit.register(shutil.rmtree, folder)
    shutil.copy(ROOT / "properties/ocaml_mutant_places.ml", folder / "places.ml")
    subprocess.run(["ocamlopt", "-I", "+compiler-libs", "ocamlcommon.cmxa", "places.ml", "-o", "places"], cwd=folder, check=True)
    return folder / "places"


def generated(file):
    """The mutants of a file, in the order of their places."""
    if not (PROOFS / "extracted.cmi").is_file():
        sys.exit(f"generated_mutants: expected the compiled proofs in {PROOFS}, found none: make verified")
    source = (ROOT / file).read_bytes().decode("latin-1")
    with tempfile.TemporaryDirectory() as folder:
        tree = pathlib.Path(folder) / pathlib.Path(file).with_suffix(".cmo").name
        subprocess.run(["ocamlc", "-bin-annot", "-w", "-a", "-I", PROOFS, "-I", "+zarith", "-c", ROOT / file, "-o", tree], cwd=folder,
                       check=True)
        lines = subprocess.run([places_program(), tree.with_suffix(".cmt")], check=True, capture_output=True, text=True).stdout
    found = {}
    for line in lines.splitlines():
        mutant = mutant_at(file, source, *line.split(" "))
        found.setdefault(mutant.key(), mutant)
    return sorted(found.values(), key=lambda m: (m.place, -m.end, m.text))


def mutant_at(file, source, what, *words):
    """The mutant of a line of the program."""
    word = words[-1]
    start, stop, *rest = map(int, words[:-1] if what == "replace" else words)
    if what == "leave":
        return OCamlMutant(file, source, start, stop, "", (start, stop - start), NOTHING)
    if what == "never":
        at = max(source.rfind("if", 0, start), source.rfind("when", 0, start))
        return OCamlMutant(file, source, start, stop, "", (at, re.match("if|when", source[at:]).end()), NEVER)
    if what == "swap":
        first, last, again, until = rest
        text = source[start:first] + source[again:until] + source[last:again] + source[first:last] + source[until:stop]
        return OCamlMutant(file, source, start, stop, text, (first, until - first), "swapped")
    first, last = rest
    return OCamlMutant(file, source, start, stop, source[start:first] + word + source[last:stop], (first, last - first), word)


def without_comments(text):
    """The text as far as it matters to the compiler."""
    return re.sub(r"\(\*.*?\*\)|\s+", " ", text, flags=re.S)


def with_what_asks(text):
    """A source that may call Mutated.at: nothing is to be added."""
    return text


def write_what_asks(work, size):
    """The module Mutated, and the rule that compiles it first."""
    (work / "proofs/ocaml/mutated.ml").write_text(ASKED.format(size=size), encoding="utf-8")
    rules = (ROOT / "proofs/Makefile").read_text(encoding="utf-8")
    (work / "proofs/Makefile").write_text(rules.replace("-c big.ml", "-c mutated.ml big.ml").replace(" big.cmx", " mutated.cmx big.cmx"),
                                          encoding="utf-8")


def build(work):
    """Compiles them; what Coq extracted is taken from here. What the compiler says if it fails, else nothing."""
    own = work / "build/proofs"
    own.mkdir(parents=True, exist_ok=True)
    for name in ("extracted.ml", "depend"):
        shutil.copy(PROOFS / name, own / name)
    kept = [word for name in ("extracted.ml", "depend") for word in ("-o", own / name)]
    run = subprocess.run(["make", "-C", "proofs", *kept, f"OUT={own}", "WARNINGS=-w -a", *(own / name for name in WITHOUT)], cwd=work,
                         check=False, capture_output=True, text=True)
    return "" if run.returncode == 0 else run.stdout + run.stderr
