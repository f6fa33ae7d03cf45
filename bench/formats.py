#!/usr/bin/env python3
"""What `check` takes on one mesh in every format, beside the same mesh in NumPy's arrays (docs/performance.md):

    bench/formats.py build/release/bin/circumspect [--points N] [--rounds N] [--only ENDING ...]

TetGen (in PATH) makes the Delaunay mesh of N random points (150,000: a million tetrahedra), whose claim is `delaunay`; formats of
surfaces get a wavy square of about as many triangles, whose claim is `complex`. Times are of the processor, files included, the
least of some rounds in turns on one thread, and memory is the most that was resident; both are divided by those of the `.npy`
of the same mesh. Of VTK, meshio and Gmsh, those that are installed read the files too; their times are of reading alone, without
the start of Python. The exit code is 1 if a format in binary takes more than 1.3 times its time, one in text more than twice, or
either more than 1.5 times its memory.
"""
import argparse
import array
import base64
import dataclasses
import math
import os
import pathlib
import random
import struct
import subprocess
import sys
import tempfile
import zlib

import taken

GOALS = {"binary": 1.3, "text": 2.0}
MEMORY = 1.5

# How the libraries of others read a file, for READ, which prints what that takes: nothing if
# they do not read such files.
PEERS = {"VTK": """
from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOGeometry import vtkOBJReader
readers = {".vtk": vtkUnstructuredGridReader, ".vtu": vtkXMLUnstructuredGridReader, ".ply": vtkPLYReader, ".obj": vtkOBJReader}
def read(path, end):
    reader = readers[end]()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput().GetNumberOfCells()
""", "meshio": """
import meshio
readers = {".vtk", ".vtu", ".msh", ".mesh", ".ply", ".obj", ".off", ".ele"}
def read(path, end):
    return sum(len(block.data) for block in meshio.read(path).cells)
""", "Gmsh": """
import gmsh
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
readers = {".msh", ".mesh", ".vtk", ".off", ".obj", ".ply"}
def read(path, end):
    gmsh.open(path)
    return sum(len(tags) for tags in gmsh.model.mesh.getElements()[1])
"""}
READ = """import pathlib, sys, time
%s
path, end = sys.argv[1], pathlib.Path(sys.argv[1]).suffix
if end in readers:
    start = time.process_time()
    count = read(path, end)
    if count >= int(sys.argv[2]):
        print("seconds", time.process_time() - start)"""


def npy(path, kind, values, columns):
    shape = f"({len(values) // columns}, {columns})"
    head = f"{{'descr': '<{kind}', 'fortran_order': False, 'shape': {shape}, }}"
    head += " " * (63 - (10 + len(head)) % 64) + "\n"
    path.write_bytes(b"\x93NUMPY\1\0" + struct.pack("<H", len(head)) + head.encode() + values.tobytes())


def swapped(kind, values):
    turned = array.array(kind, values)
    turned.byteswap()
    return turned.tobytes()


def rows(values, columns, before="", after=""):
    texts = [repr(x) for x in values]
    return "".join(f"{before}{' '.join(texts[i:i + columns])}{after}\n" for i in range(0, len(texts), columns))


class Mesh:
    """Points of space and simplices, flat."""

    def __init__(self, points, cells, size):
        self.points, self.cells, self.size = points, cells, size
        self.count, self.cells_count = len(points) // 3, len(cells) // size
        self.vtk, self.gmsh = (10, 4) if size == 4 else (5, 2)

    def write_npy(self, folder):
        npy(folder / "points.npy", "f8", self.points, 3)
        npy(folder / "cells.npy", "i4", self.cells, self.size)
        return [str(folder / "cells.npy"), "--points", str(folder / "points.npy")]

    def from_1(self):
        return array.array("i", (v + 1 for v in self.cells))

    def vtk_text(self):
        return ("# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                f"POINTS {self.count} double\n" + rows(self.points, 3) +
                f"CELLS {self.cells_count} {len(self.cells) + self.cells_count}\n" +
                rows(self.cells, self.size, f"{self.size} ") +
                f"CELL_TYPES {self.cells_count}\n" + f"{self.vtk}\n" * self.cells_count).encode()

    def vtk_binary(self):
        cells = array.array("i")
        for i in range(0, len(self.cells), self.size):
            cells.append(self.size)
            cells.extend(self.cells[i:i + self.size])
        return (b"# vtk DataFile Version 3.0\nt\nBINARY\nDATASET UNSTRUCTURED_GRID\n"
                + f"POINTS {self.count} double\n".encode() + swapped("d", self.points)
                + f"\nCELLS {self.cells_count} {len(cells)}\n".encode() + swapped("i", cells)
                + f"\nCELL_TYPES {self.cells_count}\n".encode()
                + swapped("i", array.array("i", [self.vtk]) * self.cells_count))

    def vtk_binary_5(self):
        offsets = array.array("q", range(0, len(self.cells) + 1, self.size))
        return (b"# vtk DataFile Version 5.1\nt\nBINARY\nDATASET UNSTRUCTURED_GRID\n"
                + f"POINTS {self.count} double\n".encode() + swapped("d", self.points)
                + f"\nCELLS {len(offsets)} {len(self.cells)}\nOFFSETS vtktypeint64\n".encode() + swapped("q", offsets)
                + b"\nCONNECTIVITY vtktypeint64\n" + swapped("q", array.array("q", self.cells))
                + f"\nCELL_TYPES {self.cells_count}\n".encode()
                + swapped("i", array.array("i", [self.vtk]) * self.cells_count))

    def vtu(self, how):
        arrays = [("Points", "Float64", self.points, 'NumberOfComponents="3"'),
                  ("connectivity", "Int64", array.array("q", self.cells), ""),
                  ("offsets", "Int64", array.array("q", range(self.size, len(self.cells) + 1, self.size)), ""),
                  ("types", "UInt8", array.array("B", [self.vtk]) * self.cells_count, "")]
        appended, elements = bytearray(b"_"), []
        for name, kind, values, more in arrays:
            text = ""
            head = f'<DataArray type="{kind}" Name="{name}" {more} '
            if how == "ascii":
                text = "\n" + rows(values, 3 if name == "Points" else self.size)
                head += 'format="ascii">'
            elif how == "base64":
                data = values.tobytes()
                text = base64.b64encode(struct.pack("<Q", len(data)) + data).decode()
                head += 'format="binary">'
            else:
                head += f'format="appended" offset="{len(appended) - 1}">'
                data = values.tobytes()
                if how == "zlib":
                    whole = 1 << 15
                    blocks = [zlib.compress(data[i:i + whole], 5) for i in range(0, len(data), whole)]
                    appended += struct.pack(f"<{3 + len(blocks)}Q", len(blocks), whole, len(data) % whole,
                                            *map(len, blocks)) + b"".join(blocks)
                else:
                    appended += struct.pack("<Q", len(data)) + data
            elements.append(head + text + "</DataArray>\n")
        packs = ' compressor="vtkZLibDataCompressor"' if how == "zlib" else ""
        tail = b'<AppendedData encoding="raw">\n' + bytes(appended) + b"\n</AppendedData>\n" if len(appended) > 1 else b""
        return (f'<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" '
                f'header_type="UInt64"{packs}>\n<UnstructuredGrid>\n<Piece NumberOfPoints="{self.count}" '
                f'NumberOfCells="{self.cells_count}">\n<Points>\n{elements[0]}</Points>\n<Cells>\n'
                f'{"".join(elements[1:])}</Cells>\n</Piece>\n</UnstructuredGrid>\n').encode() + tail + b"</VTKFile>\n"

    def msh_2(self):
        texts = [repr(x) for x in self.points]
        lines = ["$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n%d\n" % self.count]
        lines += ["%d %s %s %s\n" % (i + 1, *texts[3 * i:3 * i + 3]) for i in range(self.count)]
        lines.append("$EndNodes\n$Elements\n%d\n" % self.cells_count)
        cells = self.from_1()
        lines += ["%d %d 2 1 1 %s\n" % (i + 1, self.gmsh, " ".join(map(str, cells[self.size * i:self.size * (i + 1)])))
                  for i in range(self.cells_count)]
        return ("".join(lines) + "$EndElements\n").encode()

    def msh_4(self, is_binary):
        cells, size = self.from_1(), self.size
        if not is_binary:
            texts = [repr(x) for x in self.points]
            return ("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 %d 1 %d\n3 1 0 %d\n" % ((self.count,) * 3)
                    + "".join("%d\n" % (i + 1) for i in range(self.count))
                    + "".join("%s %s %s\n" % tuple(texts[3 * i:3 * i + 3]) for i in range(self.count))
                    + "$EndNodes\n$Elements\n1 %d 1 %d\n3 1 %d %d\n" % (self.cells_count, self.cells_count, self.gmsh,
                                                                       self.cells_count)
                    + "".join("%d %s\n" % (i + 1, " ".join(map(str, cells[size * i:size * (i + 1)])))
                              for i in range(self.cells_count)) + "$EndElements\n").encode()
        elements = array.array("q")
        for i in range(self.cells_count):
            elements.append(i + 1)
            elements.extend(array.array("q", cells[size * i:size * (i + 1)]))
        return (b"$MeshFormat\n4.1 1 8\n\1\0\0\0\n$EndMeshFormat\n$Nodes\n"
                + struct.pack("<4Q3iQ", 1, self.count, 1, self.count, 3, 1, 0, self.count)
                + array.array("q", range(1, self.count + 1)).tobytes() + self.points.tobytes() + b"\n$EndNodes\n$Elements\n"
                + struct.pack("<4Q3iQ", 1, self.cells_count, 1, self.cells_count, 3, 1, self.gmsh, self.cells_count)
                + elements.tobytes() + b"\n$EndElements\n")

    def medit(self):
        return (f"MeshVersionFormatted 2\nDimension 3\nVertices\n{self.count}\n" + rows(self.points, 3, after=" 0")
                + f"{'Tetrahedra' if self.size == 4 else 'Triangles'}\n{self.cells_count}\n"
                + rows(self.from_1(), self.size, after=" 0") + "End\n").encode()

    def tet(self, is_binary):
        head = f"{self.count} vertices\n{self.cells_count} tets\n"
        if is_binary:
            return head.encode() + self.points.tobytes() + self.cells.tobytes()
        return (head + rows(self.points, 3) + rows(self.cells, 4, "4 ")).encode()

    def off(self):
        return (f"OFF\n{self.count} {self.cells_count} 0\n" + rows(self.points, 3) + rows(self.cells, 3, "3 ")).encode()

    def obj(self):
        return (rows(self.points, 3, "v ") + rows(self.from_1(), 3, "f ")).encode()

    def ply(self, is_binary):
        head = (f"ply\nformat {'binary_little_endian' if is_binary else 'ascii'} 1.0\nelement vertex {self.count}\n"
                "property double x\nproperty double y\nproperty double z\n"
                f"element face {self.cells_count}\nproperty list uchar int vertex_indices\nend_header\n")
        if not is_binary:
            return (head + rows(self.points, 3) + rows(self.cells, 3, "3 ")).encode()
        faces = b"".join(b"\3" + self.cells[i:i + 3].tobytes() for i in range(0, len(self.cells), 3))
        return head.encode() + self.points.tobytes() + faces


def tetrahedra(folder, count):
    draw = random.Random(1)
    (folder / "x.node").write_text(f"{count} 3 0 0\n" + "".join(
        f"{i} {draw.random()!r} {draw.random()!r} {draw.random()!r}\n" for i in range(count)))
    subprocess.run(["tetgen", "-Q", "x.node"], cwd=folder, check=True, capture_output=True)
    points, cells = array.array("d"), array.array("i")
    for line in (folder / "x.1.node").read_text().splitlines()[1:-1]:
        points.extend(map(float, line.split()[1:4]))
    for line in (folder / "x.1.ele").read_text().splitlines()[1:-1]:
        cells.extend(map(int, line.split()[1:5]))
    return Mesh(points, cells, 4)


def triangles(count):
    side = math.isqrt(count // 2)
    draw = random.Random(2)
    points, cells = array.array("d"), array.array("i")
    for i in range(side + 1):
        for j in range(side + 1):
            points.extend((i / side, j / side, 0.1 * draw.random()))
    for i in range(side):
        for j in range(side):
            a = i * (side + 1) + j
            b = a + side + 1
            cells.extend((a, b, a + 1, b, b + 1, a + 1))
    return Mesh(points, cells, 3)


FORMS = {
    4: [(".node, .ele", "text", None), (".vtk", "text", Mesh.vtk_text), (".vtk", "binary", Mesh.vtk_binary),
        (".vtk 5.1", "binary", Mesh.vtk_binary_5), (".vtu", "text", lambda mesh: mesh.vtu("ascii")),
        (".vtu base 64", "binary", lambda mesh: mesh.vtu("base64")), (".vtu raw", "binary", lambda mesh: mesh.vtu("raw")),
        (".vtu zlib", "binary", lambda mesh: mesh.vtu("zlib")), (".msh 2.2", "text", Mesh.msh_2),
        (".msh 4.1", "text", lambda mesh: mesh.msh_4(False)), (".msh 4.1", "binary", lambda mesh: mesh.msh_4(True)),
        (".mesh", "text", Mesh.medit), (".tet", "text", lambda mesh: mesh.tet(False)),
        (".tet", "binary", lambda mesh: mesh.tet(True))],
    3: [(".off", "text", Mesh.off), (".obj", "text", Mesh.obj), (".ply", "text", lambda mesh: mesh.ply(False)),
        (".ply", "binary", lambda mesh: mesh.ply(True))]}


def held(command, arguments):
    """Seconds of the processor, and MB at most resident."""
    seconds, megabytes, code, out = taken.taken([command, "check", *arguments, "--threads", "1"])
    if code != 0:
        raise SystemExit(f"bench/formats.py: expected that {arguments} holds, found\n{out[-500:]}")
    return seconds, megabytes


@dataclasses.dataclass
class Measured:
    """A format: seconds and MB, how many times those of the arrays, and the seconds of other readers."""
    name: str
    kind: str
    seconds: float
    memory: float
    times: float
    memory_times: float
    peers: dict


def written(mesh, folder, only=()):
    """(name, binary or text, arguments of check) of the mesh in each format; first the arrays."""
    forms = [("`.npy`", "binary", mesh.write_npy(folder))]
    for i, (name, kind, write) in enumerate(FORMS[mesh.size]):
        path = folder / ("x.1.ele" if write is None else f"mesh{i}{name.split()[0]}")
        if only and name.split()[0] not in only or write is None and not path.exists():
            continue
        if write is not None:
            path.write_bytes(write(mesh))
        forms.append((f"`{name}`", kind, [str(path)]))
    return forms


def peers_seconds(path, cells):
    """What those of the others that are installed take, each once."""
    found = {}
    for name, reads in PEERS.items():
        ended = subprocess.run(["/usr/bin/python3", "-c", READ % reads, path, str(cells)], capture_output=True, text=True)
        words = ended.stdout.split()
        if ended.returncode == 0 and "seconds" in words:
            found[name] = float(words[words.index("seconds") + 1])
    return found


def measured(command, mesh, folder, claim, rounds, only=(), with_peers=True):
    """The formats of a mesh, of which the first is that of the arrays."""
    forms = written(mesh, folder, only)
    best = {}
    for _ in range(rounds):
        for i, (_, _, arguments) in enumerate(forms):
            seconds, megabytes = held(command, [*arguments, *claim])
            old = best.get(i, (math.inf, math.inf))
            best[i] = (min(old[0], seconds), min(old[1], megabytes))
    return [Measured(name, kind, *best[i], best[i][0] / best[0][0], best[i][1] / best[0][1],
                     peers_seconds(arguments[0], mesh.cells_count) if with_peers and i > 0 else {})
            for i, (name, kind, arguments) in enumerate(forms)]


def print_table(mesh, found):
    noun = "tetrahedra" if mesh.size == 4 else "triangles"
    print(f"\n| {mesh.cells_count:,} {noun} | | seconds | × `.npy` | MB | × `.npy` | {' | '.join(PEERS)} |\n"
          f"| --- | --- | --- | --- | --- | --- |{' --- |' * len(PEERS)}")
    for one in found:
        others = " | ".join(f"{one.peers[name]:.2f}" if name in one.peers else "" for name in PEERS)
        print(f"| {one.name} | {one.kind} | {one.seconds:.2f} | {one.times:.2f} | {one.memory:.0f} | {one.memory_times:.2f} | {others} |",
              flush=True)


def made(folder, points):
    """A mesh of space and one of a surface, each with its claim."""
    return [(tetrahedra(folder, points), ["--claim", "delaunay"]), (triangles(7 * points), ["--claim", "complex"])]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("command", type=os.path.abspath)
    parser.add_argument("--points", type=int, default=150_000, metavar="N")
    parser.add_argument("--rounds", type=int, default=3, metavar="N")
    parser.add_argument("--only", nargs="*", metavar="ENDING")
    options = parser.parse_args()
    is_met = True
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for mesh, claim in made(folder, options.points):
            found = measured(options.command, mesh, folder, claim, options.rounds, options.only or ())
            print_table(mesh, found)
            is_met &= all(one.times <= GOALS[one.kind] and one.memory_times <= MEMORY for one in found)
    return 0 if is_met else 1


if __name__ == "__main__":
    sys.exit(main())
