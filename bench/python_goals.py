#!/usr/bin/env python3
"""Measures the goals of the Python package, and prints the table of docs/python.md:

    PYTHONPATH=build/release/python /usr/bin/python3 bench/python_goals.py build/release [POINTS]

BUILD has the targets circumspect_python and circumspect_archive. All times are processor time, so that other work on the
machine counts little. A million points take SciPy a minute or two.
"""
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np
import scipy.spatial

import circumspect

ROOT = pathlib.Path(__file__).resolve().parent.parent
ROUNDS = 9

# The same judge, called from C++ on the same arrays: the least processor time of some rounds.
CALL = r"""
#include <circumspect/check.hpp>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>

template <class Value>
std::vector<Value> read(const char* path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  std::vector<Value> values(static_cast<std::size_t>(file.tellg()) / sizeof(Value));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(Value)));
  return values;
}

int main(int, char** argv) {
  const auto points = read<double>(argv[1]);
  const auto simplices = read<std::int32_t>(argv[2]), neighbors = read<std::int32_t>(argv[3]);
  const circumspect::MeshArrays<std::int32_t> mesh{
      .dimension = 3, .coordinates = points, .simplices = simplices, .neighbors = neighbors};
  double least = 1e9;
  for (int i = 0; i < std::atoi(argv[4]); ++i) {
    const std::clock_t start = std::clock();
    if (!circumspect::judge("delaunay", mesh).holds) return 1;
    least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::printf("%f\n", least);
}
"""


def least(call, rounds=ROUNDS):
    """The least processor time of some calls, and what the last one returned."""
    times = []
    for _ in range(rounds):
        start = time.process_time()
        result = call()
        times.append(time.process_time() - start)
    return min(times), result


def cpp_seconds(build, mesh):
    """The C++ call on the arrays of a mesh."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "call.cpp").write_text(CALL)
        for name, array in (("points", mesh.points), ("simplices", mesh.simplices), ("neighbors", mesh.neighbors)):
            np.ascontiguousarray(array).tofile(folder / name)
        libraries = ["fmt", "tbb", "gmpxx", "gmp", "mpfr", "pugixml", "z"]
        subprocess.run(["g++", "-std=c++20", "-O2", f"-I{ROOT}/include", "-o", folder / "call", folder / "call.cpp",
                        f"{build}/libcircumspect-check.a", *(f"-l{name}" for name in libraries), "-pthread"], check=True)
        arguments = [folder / "call", folder / "points", folder / "simplices", folder / "neighbors", str(ROUNDS)]
        return float(subprocess.run(arguments, check=True, capture_output=True, text=True).stdout)


def import_seconds():
    """A fresh Python that imports the package and nothing else."""
    line = "import time; start = time.process_time(); import circumspect; print(time.process_time() - start)"
    return min(float(subprocess.run([sys.executable, "-c", line], check=True, capture_output=True, text=True).stdout)
               for _ in range(ROUNDS))


def orient_seconds():
    """One call."""
    corners = ((0.0, 0.0), (1.0, 0.25), (0.5, 1.0))
    return least(lambda: [circumspect.orient(*corners) for _ in range(10_000)])[0] / 10_000


def cases_per_second():
    """Cases that are drawn, triangulated by SciPy and judged, of up to 20 points in space."""
    calls = 0

    def triangulate(points):
        nonlocal calls
        calls += 1
        return scipy.spatial.Delaunay(points).simplices

    start = time.process_time()
    found = circumspect.campaign(triangulate, cases=3000, families=["uniform"])
    assert found, found
    return calls / (time.process_time() - start)


def main(build, count):
    points = np.random.default_rng(1).random((count, 3))
    start = time.process_time()
    mesh = scipy.spatial.Delaunay(points)
    made = time.process_time() - start
    judged, verdict = least(lambda: circumspect.check(mesh))
    assert verdict, verdict
    call = cpp_seconds(build, mesh)
    print("| | goal | measured |\n| --- | --- | --- |")
    print(f"| SciPy's Delaunay triangulation of {count:,} points ({len(mesh.simplices):,} tetrahedra), `check` | "
          f"≤ 1.1 times the C++ call | {judged:.2f} s, {judged / call:.2f} times its {call:.2f} s |")
    print(f"| the same against SciPy's {made:.0f} s | ≤ 2 % | {100 * judged / made:.1f} % |")
    print(f"| `import circumspect` | ≤ 30 ms | {1e3 * import_seconds():.0f} ms |")
    print(f"| `orient` of three points, as tuples of floats | ≤ 2 µs | {1e6 * orient_seconds():.2f} µs |")
    print(f"| a campaign against SciPy, of sets of up to 20 points in space, SciPy's time included | ≥ 500 cases a second | {cases_per_second():.0f} |")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve(), int(sys.argv[2]) if len(sys.argv) > 2 else 1_000_000)
