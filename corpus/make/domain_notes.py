"""What is known of other programs' meshes of domains: why a verdict is not `holds`, why there is no mesh."""

OFF_SEGMENT = "Steiner points on segments are rounded to doubles and lie off them, by at most {}; every other vertex is where it belongs"

NOTES = {
    "tetgen/dangling-square.1.ele": "the square and its two outer vertices are discarded with the outside (kept with `-c`: see "
                                    "`dangling-square--hull`); neither the .ele nor the .face file has them",
    "tetgen/figure-4-10-schonhardt.1.ele": OFF_SEGMENT.format("7.3e-16"),
    "tetgen/figure-4-10-schonhardt--hull.1.ele": OFF_SEGMENT.format("7.3e-16"),
    "tetgen/figure-4-10-schonhardt--quality.1.ele": "the same, 27 on segments and 2 in polygons, by at most 1.7e-15",
    "tetgen/cube-with-diagonal.1.ele": OFF_SEGMENT.format("1.9e-16") + " (without Steiner points there is a CDT, "
                                       "`accept/cube-around-diagonal`)",
    "tetgen/cube-with-diagonal-and-floor.1.ele": "the part of the floor outside, and its two vertices, are discarded",
    "tetgen/schonhardt-with-centre.1.ele": OFF_SEGMENT.format("6.8e-16") + " (without Steiner points there is a triangulation, "
                                           "`accept/schonhardt-with-centre`, which is not constrained Delaunay)",
    "tetgen/figure-4-13-chazelle-2.1.ele": OFF_SEGMENT.format("1.7e-16"),
    "tetgen/figure-4-13-chazelle-3.1.ele": OFF_SEGMENT.format("3.6e-16"),
    "tetgen/chazelle-outer-notches.1.ele": OFF_SEGMENT.format("2.9e-16"),
    "tetgen/exercise-5-5-open.1.ele": OFF_SEGMENT.format("6.3e-15") + "; there is a CDT without Steiner points",
    "tetgen/exercise-5-5-closed.1.ele": OFF_SEGMENT.format("6.3e-15"),
    "tetgen/landscape.1.ele": OFF_SEGMENT.format("4.7e-16"),
    "tetgen/joint.1.ele": "151 of the 152 missing segments lie between triangles that are coplanar, or nearly: TetGen merges such "
                          "facets, within a tolerance, unless `-M` is given. One is a crease with a Steiner point 8.3e-19 off it",
    "gmsh/landscape.mesh": "6 vertices of the domain are off by one unit in the last place: Gmsh writes 6.988 for the double "
                           "6.9879999999999995. Of its Steiner points 4 are off their segments, 1 off its polygon, by at most 8.1e-16",
    "gmsh/thin-wedge.failed": "the angle between two facets, 0.056 degrees, is below `Mesh.AngleToleranceFacetOverlap`, 0.1 by default; with 0.001 there is a mesh",
    "gmsh/figure-4-13-chazelle-3.failed": "an assertion of its boundary recovery fails: see below",
    "gmsh/chazelle-outer-notches.failed": "the same",
    "tetgen/unlisted-vertex.failed": "an assertion fails: see below",
    "tetgen/segment-listed-twice.failed": "an assertion fails: see below",
    "tetgen/needle.failed": "its triangle encloses nothing, and `-c` was not asked for",
    "tetgen/two-triangles.failed": "an assertion fails: see below",
    "tetgen/one-segment--quality.1.ele": "after refinement TetGen optimizes the shapes of tetrahedra and gives the property up; "
                                         "without (`O0`: `one-segment--unoptimized`) it holds",
    "tetgen/pig.failed": "the surface intersects itself (`plc.segment-pierces-polygon`): no mesh is right, though an uncaught exception says little",
    "tetgen/fan-of-rooms--quality.failed": "no end within 10 seconds: angles of 0.22 degrees between facets, which no refinement removes",
}
