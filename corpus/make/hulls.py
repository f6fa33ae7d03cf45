"""Lists of facets, judged with the claim `convex-hull`: in the plane edges or a cyclic list, in space triangles."""
from files import Entry
from mesh_alone import outwards
from point_sets import CUBE
from reject import cube_surface, reject

HOUSE = [(0, 0), (4, 0), (4, 3), (2, 5), (0, 3), (2, 0), (2, 2)]
WITHOUT = [(0, 1), (1, 2), (2, 3), (3, 4), (4, 0)]
WITH = [(0, 5), (5, 1), *WITHOUT[1:]]


def accept(name, what, points, facets, *claims):
    return Entry(f"accept/{name}", what, points, facets, [(" ".join(["convex-hull", *one]), "holds") for one in claims or [()]])


def hull(rule, what, points, facets, *options):
    claims = [(" ".join(["convex-hull", *options]), rule.split("--")[0])]
    return reject(rule, what, points, facets, claims=claims + ([("convex-hull", "holds")] if options else []))


def entries():
    yield accept("hull-2d", "five edges around seven points, one of them in an edge and one inside", HOUSE, WITHOUT, (), ("--only-extreme",))
    yield accept("hull-2d-all-points", "the same with the point in the edge", HOUSE, WITH, ("--all-boundary-points",), ("--oriented",))
    yield accept("hull-2d-cyclic", "the same as vertices in their cyclic order, one a row", HOUSE, [(v,) for v in (4, 3, 2, 1, 0)])
    yield accept("hull-cube", "the surface of a cube, and a point inside", CUBE + [(0.5, 0.25, 0.25)], outwards(cube_surface()),
                 ("--oriented",), ("--all-boundary-points --only-extreme",))
    yield hull("hull.facet-not-supporting", "the surface of a cube, and a point a little above one of its faces, which nobody used",
               CUBE + [(0.5, 0.5, 1.125)], cube_surface())
    yield hull("hull.facet-not-supporting--left-out-2d", "the topmost point was left out", HOUSE, [(0, 1), (1, 2), (2, 4), (4, 0)])
    yield hull("hull.uncovered", "the surface of a cube without one triangle", CUBE, cube_surface()[1:])
    yield hull("hull.boundary-point-left-out", "a point in an edge, which is not a vertex", HOUSE, WITHOUT, "--all-boundary-points")
    yield hull("hull.vertex-not-extreme", "a vertex between two others", HOUSE, WITH, "--only-extreme")
