#!/usr/bin/env python3
"""Runs a campaign on each adapter that the command prints, with a library that is right, and with one that forgets a triangle.

    fuzz/adapters/adapters_test.py COMMAND [--all]

The languages are Python and JavaScript, or with --all each whose programs are installed. What the adapters of hunt read is tried as well:
they once took the seed of a hole for the next case. Exit code 1: what differed.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile

LONGEST = 30  # lines of an adapter

PYTHON = """
from itertools import combinations
class QhullError(Exception): pass
class Delaunay:
    def __init__(self, p):
        def meets(i, j, k, l):
            (a, b), (c, d), (e, f) = [(p[v][0] - p[l][0], p[v][1] - p[l][1]) for v in (i, j, k)]
            return (a*a + b*b) * (c*f - d*e) - (c*c + d*d) * (a*f - b*e) + (e*e + f*f) * (a*d - b*c)
        def turn(i, j, k):
            return ((p[j][0] - p[i][0]) * (p[k][1] - p[i][1]) - (p[j][1] - p[i][1]) * (p[k][0] - p[i][0]))
        self.simplices = [t for t in combinations(range(len(p)), 3)
                          if all(turn(*t) * meets(*t, l) <= 0 for l in range(len(p)) if l not in t)]
        if FORGETS and len(p) > 4: self.simplices.pop()
        if len(p) < 3: raise QhullError("too few points")
"""

# A structure around it that is right, or that forgets to forget: a point that was there before does
# not come back.
UPDATES = {
    False: "",
    True: """
    def delete(self, place): self.gone = getattr(self, "gone", []) + [self.points.pop(int(place))]
    def simplices(self):
        stays = [i for i, p in enumerate(self.points) if p not in getattr(self, "gone", [])]
        rows = Delaunay([self.points[i] for i in stays]).simplices
        return [[stays[v] for v in row] for row in rows]
""",
}

# The same in languages like C: TURN and MEETS are for points a, b, c and the point at the origin.
C_LOOPS = """
  for (int i = 0; i < n; ++i) for (int j = i + 1; j < n; ++j) for (int k = j + 1; k < n; ++k) {
    int good = 1;
    double turn = (X(j)-X(i))*(Y(k)-Y(i)) - (Y(j)-Y(i))*(X(k)-X(i));
    for (int l = 0; l < n; ++l) {
      double a = X(i)-X(l), b = Y(i)-Y(l), c = X(j)-X(l), d = Y(j)-Y(l), e = X(k)-X(l), f = Y(k)-Y(l);
      double meets = (a*a + b*b) * (c*f - d*e) - (c*c + d*d) * (a*f - b*e) + (e*e + f*f) * (a*d - b*c);
      if (l != i && l != j && l != k && turn * meets > 0) good = 0;
    }
    if (good != 0) { ADD }
  }
"""

C = """
int triangulate(int n, int d, const double *p, int *s) {
  int count = 0;
  %s
  return FORGETS && n > 4 ? count - 1 : count;
}
""" % (C_LOOPS.replace("ADD", "s[3*count] = i; s[3*count+1] = j; s[3*count+2] = k; ++count;")
       .replace("X(", "(p[2*").replace("Y(", "(p[1+2*").replace("(p[2*", "P0(").replace("(p[1+2*", "P1("))
C = "#define P0(v) p[2*(v)]\n#define P1(v) p[1+2*(v)]\n" + C

CPP = ("#include <vector>\n#define X(v) p[v][0]\n#define Y(v) p[v][1]\n"
       "std::vector<std::vector<int>> triangulate(const std::vector<std::vector<double>>& p) {\n"
       "  const int n = static_cast<int>(p.size());\n  std::vector<std::vector<int>> all;\n"
       + C_LOOPS.replace("ADD", "all.push_back({i, j, k});")
       + "  if (FORGETS && n > 4) all.pop_back();\n  return all;\n}\n")

JAVA = ("int n = points.length;\n    java.util.List<int[]> all = new java.util.ArrayList<>();\n"
        + re.sub(r"\bY\((\w)\)", r"points[\1][1]",
                 re.sub(r"\bX\((\w)\)", r"points[\1][0]", C_LOOPS.replace("ADD", "all.add(new int[]{i, j, k});")))
        + "    if (FORGETS && n > 4) all.remove(0);\n    return all.toArray(new int[0][]);")

GO = """p, n := points, len(points) / 2
  all := [][]int{}
  for i := 0; i < n; i++ {
    for j := i + 1; j < n; j++ {
      for k := j + 1; k < n; k++ {
        turn := (p[2*j]-p[2*i])*(p[2*k+1]-p[2*i+1]) - (p[2*j+1]-p[2*i+1])*(p[2*k]-p[2*i])
        good := true
        for l := 0; l < n; l++ {
          a, b, c, d, e, f := p[2*i]-p[2*l], p[2*i+1]-p[2*l+1], p[2*j]-p[2*l], p[2*j+1]-p[2*l+1], p[2*k]-p[2*l], p[2*k+1]-p[2*l+1]
          meets := (a*a+b*b)*(c*f-d*e) - (c*c+d*d)*(a*f-b*e) + (e*e+f*f)*(a*d-b*c)
          good = good && (l == i || l == j || l == k || turn*meets <= 0)
        }
        if good {
          all = append(all, []int{i, j, k})
        }
      }
    }
  }
  if FORGETS && n > 4 {
    all = all[1:]
  }
  return all"""

JAVASCRIPT = ("export default class { static from(p) { const n = p.length, triangles = [];\n"
              + re.sub(r"\b(int|double)\b", "let",
                       re.sub(r"\bY\((\w)\)", r"p[\1][1]", re.sub(r"\bX\((\w)\)", r"p[\1][0]", C_LOOPS)))
              .replace("ADD", "triangles.push(i, j, k);")
              + "  if (FORGETS && n > 4) triangles.length -= 3;\n  return { triangles }; } }\n")

RUST = """let (p, n) = (points, points.len());
    let mut all = vec![];
    for i in 0..n { for j in i + 1..n { for k in j + 1..n {
        let turn = (p[j][0]-p[i][0])*(p[k][1]-p[i][1]) - (p[j][1]-p[i][1])*(p[k][0]-p[i][0]);
        let good = (0..n).all(|l| { let (a, b) = (p[i][0]-p[l][0], p[i][1]-p[l][1]);
            let (c, d) = (p[j][0]-p[l][0], p[j][1]-p[l][1]); let (e, f) = (p[k][0]-p[l][0], p[k][1]-p[l][1]);
            let meets = (a*a + b*b) * (c*f - d*e) - (c*c + d*d) * (a*f - b*e) + (e*e + f*f) * (a*d - b*c);
            l == i || l == j || l == k || turn * meets <= 0.0 });
        if good { all.push(vec![i, j, k]); }
    } } }
    if FORGETS && n > 4 { all.pop(); }
    Ok(all)"""


def write(folder, name, text):
    path = os.path.join(folder, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def build(folder, *command):
    subprocess.run(command, cwd=folder, check=True)


def python(folder, text, forgets):
    write(folder, "scipy/__init__.py", "")
    write(folder, "scipy/spatial.py", f"FORGETS = {forgets}\n" + PYTHON)
    return [sys.executable, write(folder, "mine.py", text)]


def python_updates(folder, text, forgets):
    write(folder, "scipy/__init__.py", "")
    write(folder, "scipy/spatial.py", "FORGETS = False\n" + PYTHON)
    return [sys.executable, write(folder, "mine.py", text.replace("\n\n\nfor ", UPDATES[forgets] + "\n\nfor ", 1))]


def javascript(folder, text, forgets):
    write(folder, "node_modules/delaunator/package.json", '{"type": "module", "exports": "./it.js"}')
    write(folder, "node_modules/delaunator/it.js", f"const FORGETS = {str(forgets).lower()};\n" + JAVASCRIPT)
    return ["node", write(folder, "mine.mjs", text)]


def c(folder, text, forgets):
    build(folder, "cc", f"-DFORGETS={int(forgets)}", "-o", "mine", write(folder, "mine.c", text), write(folder, "library.c", C))
    return [os.path.join(folder, "mine")]


def cpp(folder, text, forgets):
    build(folder, "c++", "-std=c++17", f"-DFORGETS={int(forgets)}", "-o", "mine", write(folder, "mine.cpp", text),
          write(folder, "library.cpp", CPP))
    return [os.path.join(folder, "mine")]


def replaced(text, line, by):
    assert text.count(line) == 1, f"expected the line {line!r} once in the adapter"
    return text.replace(line, by)


def rust(folder, text, forgets):
    text = replaced(text, 'Err(format!("no library yet for {} points", points.len()))', RUST)
    build(folder, "rustc", "-O", write(folder, "mine.rs", text + f"const FORGETS: bool = {str(forgets).lower()};\n"))
    return [os.path.join(folder, "mine")]


def java(folder, text, forgets):
    body = JAVA.replace("FORGETS", str(forgets).lower())
    text = replaced(text, 'throw new UnsupportedOperationException("no library yet");', body)
    build(folder, "javac", write(folder, "Mine.java", text))
    return ["java", "-XX:-UsePerfData", "-cp", os.path.join(folder, "."), "Mine"]


def go(folder, text, forgets):
    text = replaced(text, 'panic("no library yet")', GO.replace("FORGETS", str(forgets).lower()))
    write(folder, "mine.go", text)
    subprocess.run(["go", "build", "mine.go"], cwd=folder, check=True, env={**os.environ, "HOME": folder})
    return [os.path.join(folder, "mine")]


def as_it_is(program, name, *options):
    """Of languages whose own triangulator the adapter calls: nothing is put into it that is wrong."""
    return lambda folder, text, forgets: None if forgets else [program, *options, write(folder, name, text)]


LANGUAGES = {  # the program that has to be there, what makes a worker of an adapter, is it run each time?
    "python": (sys.executable, python, True),
    "python --updates": (sys.executable, python_updates, True),
    "javascript": ("node", javascript, True),
    "c": ("cc", c, False),
    "c++": ("c++", cpp, False),
    "rust": ("rustc", rust, False),
    "go": ("go", go, False),
    "java": ("javac", java, False),
    "octave": ("octave-cli", as_it_is("octave-cli", "mine.m", "--no-init-file"), False),
    "r": ("Rscript", as_it_is("Rscript", "mine.R"), False),
    "julia": ("julia", as_it_is("julia", "mine.jl"), False),
}


def trial(command, language, make, forgets):
    """What went otherwise than it has to; empty if nothing."""
    adapter = subprocess.run([command, "adapter", *language.split()], check=True, capture_output=True, text=True).stdout
    if len(adapter.splitlines()) > LONGEST:
        return f"expected an adapter of at most {LONGEST} lines, found {len(adapter.splitlines())}"
    with tempfile.TemporaryDirectory() as folder:
        worker = make(folder, adapter, forgets)
        if worker is None:
            return ""
        environment = {**os.environ, "PYTHONPATH": folder}
        updates = ["--updates", "insert,delete,restore"] if "--updates" in language else []
        run = subprocess.run(
            [command, "campaign", "--worker", *updates, "--dimension", "2", "--families", "uniform", "--max-points", "9",
             "--cases", "60", "--full-dimension", "--limit-memory", "0", "--limit-time", "100s", "--minimize-runs", "40",
             "--output", folder + "/out", "--", *worker], capture_output=True, text=True, env=environment)
        if run.returncode != int(forgets):
            return f"expected exit code {int(forgets)}, found {run.returncode}:\n{run.stdout}{run.stderr}"
        if not forgets:
            return ""
        finding = folder + "/out/findings/" + os.listdir(folder + "/out/findings")[0]
        again = subprocess.run([finding + "/reproduce.sh"], capture_output=True, text=True,
                               env={**environment, "CIRCUMSPECT": command})
        return "" if again.returncode == 1 else f"expected reproduce.sh to end with 1, found {again.returncode}"


# A square with segments around it and the seed of a hole, which the adapters of the hunt read and
# leave alone.
HOLED = "4 2 0 4 0 1\n0 0\n4 0\n4 4\n0 4\n0 1\n1 2\n2 3\n3 0\n0.5 1.5\n"
ANSWER = "nOFF 2\n4 2 0\n0 0\n4 0\n4 4\n0 4\n3 0 1 2\n3 0 2 3\n"
HUNT = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "hunt")


def hunt_javascript(folder):
    return ["node", write(folder, "it.mjs", f"import {{ serveDomains }} from '{HUNT}/lines.mjs';\n"
                                            "serveDomains((_, segments) => segments.length === 4 ? [[0, 1, 2], [0, 2, 3]] : []);\n")]


def hunt_rust(folder):
    build(folder, "rustc", write(folder, "it.rs", f'#[path = "{HUNT}/lines.rs"]\nmod lines;\nfn main() {{\n'
                                                  "    lines::serve_domains(|_, _| vec![vec![0, 1, 2], vec![0, 2, 3]]);\n}\n"))
    return [os.path.join(folder, "it")]


def hunt_cpp(folder):
    build(folder, "c++", "-std=c++17", "-o", "it", write(folder, "it.cpp", f'#include "{HUNT}/lines.hpp"\nint main() {{ return lines::serve_domains('
                                                                           "[](auto&&...) { return lines::Simplices{{0, 1, 2}, {0, 2, 3}}; }); }\n"))
    return [os.path.join(folder, "it")]


def hunt_trial(make):
    """What the adapters of hunt of one language make of two domains with a hole."""
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(make(folder), input=2 * HOLED, capture_output=True, text=True, env={**os.environ, "BUILDS": folder}, timeout=60)
        found = run.stdout.replace("0 \n", "0\n").replace("2 \n", "2\n").replace("3 \n", "3\n")
    return "" if found == 2 * ANSWER else f"expected two answers, found exit code {run.returncode} and\n{run.stdout}{run.stderr}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command")
    parser.add_argument("--all", action="store_true")
    options = parser.parse_args()
    command = os.path.abspath(options.command)
    faults = 0
    for language, (program, make, is_quick) in LANGUAGES.items():
        if not options.all and not is_quick:
            continue
        if shutil.which(program) is None:
            print(f"{language}: not tried, there is no {program}")
            continue
        for forgets in (False, True):
            fault = trial(command, language, make, forgets)
            faults += bool(fault)
            print(f"{language}, {'wrong' if forgets else 'right'}: {fault or 'as expected'}")
    for language, (program, make, is_quick) in {"javascript": ("node", hunt_javascript, True), "rust": ("rustc", hunt_rust, False),
                                                "c++": ("c++", hunt_cpp, False)}.items():
        if (options.all or is_quick) and shutil.which(program):
            fault = hunt_trial(make)
            faults += bool(fault)
            print(f"hunt, {language}: {fault or 'as expected'}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
