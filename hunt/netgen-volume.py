"""Netgen's mesher of volumes, in a closed surface of triangles and convex polygons: a worker for domains in space (docs/workers.md)."""
import os
import sys
from collections import defaultdict
from fractions import Fraction

from netgen.meshing import Element2D, FaceDescriptor, Mesh, MeshingParameters, MeshPoint, NgException, Pnt, SetMessageImportance


class Refused(Exception):
    """The surface is of no kind that GenerateVolumeMesh takes, or it reports an error."""


def cross(p, q, r):
    (a, b, c), (d, e, f) = [[Fraction(x) - Fraction(y) for x, y in zip(s, p)] for s in (q, r)]
    return [b * f - c * e, c * d - a * f, a * e - b * d]


def fan(corners, points):
    turns = [cross(*(points[v] for v in three)) for three in zip(corners, corners[1:] + corners[:1], corners[2:] + corners[:2])]
    if any(sum(x * y for x, y in zip(turns[0], turn)) <= 0 for turn in turns):
        raise Refused("a polygon is not convex")
    return [[corners[0], b, c] for b, c in zip(corners[1:], corners[2:])]


def outward(triangles, points):
    """Each counterclockwise as seen from outside, if they are one closed surface."""
    at = defaultdict(list)
    for i, triangle in enumerate(triangles):
        for a, b in zip(triangle, triangle[1:] + triangle[:1]):
            at[frozenset((a, b))].append((i, a))
    if not triangles or any(len(both) != 2 for both in at.values()):
        raise Refused("the polygons are not a closed surface")
    is_turned, waiting = {0: False}, [0]
    while waiting:
        i = waiting.pop()
        for a, b in zip(triangles[i], triangles[i][1:] + triangles[i][:1]):
            for j, start in at[frozenset((a, b))]:
                if j != i and j not in is_turned:
                    is_turned[j] = is_turned[i] ^ (start == a)
                    waiting.append(j)
    if len(is_turned) < len(triangles):
        raise Refused("several surfaces")
    turned = [t[::-1] if is_turned[i] else t for i, t in enumerate(triangles)]
    volume = sum(x * Fraction(y) for t in turned for x, y in zip(cross([0, 0, 0], points[t[0]], points[t[1]]), points[t[2]]))
    return turned if volume > 0 else [t[::-1] for t in turned]


def triangulate(points, segments, facets):
    triangles = []
    for lines, seeds in facets:
        if seeds or len(lines) != 1 or len(lines[0]) < 3:
            raise Refused("a facet has a hole, or is a segment")
        triangles += fan(lines[0], points)
    triangles = outward(triangles, points)
    edges = {frozenset(two) for t in triangles for two in zip(t, t[1:] + t[:1])}
    if {v for t in triangles for v in t} != set(range(len(points))) or not edges.issuperset(map(frozenset, segments)):
        raise Refused("a vertex or a segment is not on the surface")
    mesh = Mesh(dim=3)
    own = [mesh.Add(MeshPoint(Pnt(*p))) for p in points]
    face = mesh.Add(FaceDescriptor(surfnr=1, domin=1, domout=0, bc=1))
    for t in triangles:
        mesh.Add(Element2D(face, [own[v] for v in t]))
    try:
        mesh.GenerateVolumeMesh(mp=MeshingParameters(maxh=max(max(c) - min(c) for c in zip(*points))))
    except NgException as error:
        raise Refused(error)
    return [p.p for p in mesh.Points()], [[v.nr - 1 for v in e.vertices] for e in mesh.Elements3D()]


def main():
    out = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # it prints what it likes
    SetMessageImportance(0)
    words = lambda kind: list(map(kind, sys.stdin.readline().split()))
    while counts := words(int):
        points = [words(float) for _ in range(counts[0])]
        segments = [words(int) for _ in range(counts[3])]
        facets = []
        for _ in range(counts[4]):
            lines, seeds = words(int)
            facets.append(([words(int)[1:] for _ in range(lines)], [words(float) for _ in range(seeds)]))
        holes = [words(float) for _ in range(counts[5])]
        try:
            if holes:
                raise Refused("a hole")
            vertices, tetrahedra = triangulate(points, segments, facets)
            rows = [" ".join(map(repr, p)) for p in vertices] + ["4 " + " ".join(map(str, t)) for t in tetrahedra]
            out.write("\n".join([f"{len(vertices)} vertices", f"{len(tetrahedra)} tets", *rows]) + "\n")
        except Refused as refusal:
            out.write("error " + str(refusal).split("\n")[0] + "\n")
        out.flush()


main()
