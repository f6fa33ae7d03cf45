/* The C interface, which other languages call.
 *
 *   double points[] = {0, 0, 1, 0, 0, 1, 0.9, 0.9};
 *   int32_t triangles[] = {0, 1, 3, 0, 3, 2};
 *   circumspect_mesh mesh = CIRCUMSPECT_MESH;
 *   mesh.dimension = 2;
 *   mesh.point_count = 4;
 *   mesh.coordinates = points;
 *   mesh.simplex_count = 2;
 *   mesh.vertices_of_simplex = 3;
 *   mesh.simplices = triangles;
 *   circumspect_verdict* verdict = NULL;
 *   if (circumspect_check("delaunay", &mesh, NULL, NULL, &verdict) != CIRCUMSPECT_OK) {
 *     fputs(circumspect_last_error(), stderr);
 *   } else if (!circumspect_verdict_holds(verdict)) {
 *     fputs(circumspect_verdict_text(verdict), stdout);
 *   }
 *   circumspect_verdict_free(verdict);
 *
 * Link with -lcircumspect. Every function may be called by any number of threads at the same time;
 * a verdict may be read by several threads, and is freed once. No function throws, prints, ends the
 * process or keeps a pointer to its arguments. Exact numbers are texts in lowest terms: "7",
 * "-1/3". A returned pointer belongs to the handle that was passed, and lives as long as the
 * handle.
 *
 * Memory: if the C++ runtime finds none, the function returns CIRCUMSPECT_OUT_OF_MEMORY. Two
 * third-party libraries end the process instead: GMP, if exact numbers are too large for memory,
 * and the JSON writer, which is started only if a megabyte is left; `without_json` avoids it,
 * unless there are pictures. */
#ifndef CIRCUMSPECT_CIRCUMSPECT_H
#define CIRCUMSPECT_CIRCUMSPECT_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define CIRCUMSPECT_API __attribute__((visibility("default")))
#else
#define CIRCUMSPECT_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* "0.1.0" */
CIRCUMSPECT_API const char* circumspect_version(void);

typedef enum circumspect_status {
  CIRCUMSPECT_OK = 0,
  /* The call is wrong: a NULL, a negative count, an unknown claim. */
  CIRCUMSPECT_INVALID_ARGUMENT = 1,
  /* The input is at fault, not the mesh: a coordinate that is not finite, a domain that is not a
   * piecewise linear complex. The command exits with 3. */
  CIRCUMSPECT_INPUT_FAULT = 2,
  /* What was asked for does not exist: the domain has no (canonical) constrained Delaunay
   * triangulation. */
  CIRCUMSPECT_NONE = 3,
  /* No answer was found within the limits of the judge, or of circumspect_end_calls_after(). */
  CIRCUMSPECT_UNDECIDED = 4,
  CIRCUMSPECT_OUT_OF_MEMORY = 5,
  CIRCUMSPECT_INTERNAL_ERROR = 6
} circumspect_status;

/* Why the last call of this thread that returned a status failed, for people: what was expected and
 * what was found, on one line without control characters. Empty if it did not fail. Lives until the
 * thread's next call. Never NULL. */
CIRCUMSPECT_API const char* circumspect_last_error(void);
/* For bindings, which have words of their own for options: circumspect_last_fault is the same line
 * without advice, and circumspect_last_option names the member of circumspect_options that would
 * settle it, such as "merge_equal_points"; empty if there is none. Both live until the next call of
 * the thread. Never NULL. */
CIRCUMSPECT_API const char* circumspect_last_fault(void);
CIRCUMSPECT_API const char* circumspect_last_option(void);

/* From now on, each long call of this thread ends with CIRCUMSPECT_UNDECIDED soon after so many
 * seconds, or after another thread has set *stop to a value other than 0, for example at Ctrl-C.
 * seconds ≤ 0: no limit. stop NULL: no stop flag; otherwise *stop must live until this is called
 * again. A new thread has neither. */
CIRCUMSPECT_API void circumspect_end_calls_after(double seconds, const int32_t* stop);

/* Structs grow only at their end. A struct that was initialised by the macro of an earlier version
 * is accepted; members that it lacks have the values that the macro sets. */

/* A view of a mesh in memory. Begin with CIRCUMSPECT_MESH, which is the empty mesh, and set the
 * members that apply. Coordinates are doubles if `coordinates` is set, else the texts of
 * `exact_coordinates`: "1/3", "0x1.8p-3", and "0.1", which is 1/10. The same holds for weights. */
typedef struct circumspect_mesh {
  size_t struct_size;                   /* set by CIRCUMSPECT_MESH */
  int64_t dimension;                    /* d, of the points: at least 1, at most 64 */
  int64_t point_count;                  /* n */
  const double* coordinates;            /* n·d, point after point, all finite */
  const char* const* exact_coordinates; /* n·d */
  const double* weights;                /* n, or NULL; they count only in "weighted-delaunay" */
  const char* const* exact_weights;     /* n, or NULL */
  int64_t simplex_count;                /* m */
  int64_t vertices_of_simplex;          /* d+1; k+1 where the points span a flat of dimension k */
  int64_t index_bytes;                  /* 4 (the default): int32_t; 8: int64_t */
  const void* simplices;                /* m·vertices_of_simplex indices of points, from 0 */
  /* NULL, or the simplex opposite each vertex, −1 for none; for claims about triangulations. */
  const void* neighbors;
  /* For a mesh of a domain, and for the demand "faces" of "complex": triangles (in space) and edges
   * that a program lists beside the simplices. */
  int64_t triangle_count;
  const int64_t* triangles;
  int64_t edge_count;
  const int64_t* edges;
} circumspect_mesh;

#define CIRCUMSPECT_MESH \
  { sizeof(circumspect_mesh), 0, 0, NULL, NULL, NULL, NULL, 0, 0, 4, NULL, NULL, 0, NULL, 0, NULL }

typedef enum circumspect_domain_kind {
  /* Enclosed if walls (segments in the plane, polygons in space) enclose anything; the convex hull
   * if there are no walls; CIRCUMSPECT_INPUT_FAULT if there are walls that enclose nothing. */
  CIRCUMSPECT_KIND_BY_WALLS = 0,
  CIRCUMSPECT_ENCLOSED = 1,
  CIRCUMSPECT_HULL = 2,
  /* A part of what is enclosed: the regions entered from outside through an odd number of walls; or
   * the regions that the walls, as they are oriented, wind around. The latter gives
   * CIRCUMSPECT_INPUT_FAULT if the walls around a region are not all oriented the same way. */
  CIRCUMSPECT_EVEN_ODD = 3,
  CIRCUMSPECT_WINDING = 4
} circumspect_domain_kind;

/* A piecewise linear complex. In the plane, polygons are rings: each covers what an odd number of its
 * lines enclose, the edges of its lines are segments, and CIRCUMSPECT_KIND_BY_WALLS fills what they cover.
 * Polygon p has the lines polygon_starts[p] … polygon_starts[p+1] − 1, and line l the
 * corners line_starts[l] … line_starts[l+1] − 1: closed lines of three corners or more
 * (outline and holes), segments of two, isolated vertices of one. */
typedef struct circumspect_domain {
  size_t struct_size; /* set by CIRCUMSPECT_DOMAIN */
  int64_t dimension;  /* 2 or 3 */
  int64_t point_count;
  const double* coordinates;
  const char* const* exact_coordinates;
  int64_t segment_count;
  const int64_t* segments;       /* two indices of points each */
  int64_t polygon_count;
  const int64_t* polygon_starts; /* polygon_count + 1, ascending from 0 */
  const int64_t* line_starts;    /* as many as there are lines, + 1, ascending from 0 */
  const int64_t* corners;
  int64_t hole_count;
  const double* hole_seeds; /* a point in each hole */
  int32_t kind;             /* circumspect_domain_kind */
  /* Holes of polygons. A closed line within a polygon bounds a hole only if a seed lies in it. */
  int64_t polygon_hole_count;
  const int64_t* polygons_of_holes; /* the polygon that each is a hole of */
  const double* polygon_hole_seeds; /* a point of its plane in each: three coordinates */
  /* Seeds as texts, if those of doubles are NULL: in a tilted plane, a hole may contain no point
   * with double coordinates. */
  const char* const* exact_hole_seeds;
  const char* const* exact_polygon_hole_seeds;
  /* If there are any: a point in each enclosed region that is filled; no other region is. */
  int64_t region_count;
  const double* region_seeds;
  const char* const* exact_region_seeds;
  int32_t merge_coplanar; /* not 0: coplanar polygons that share an edge count as one */
  /* Not 0: segments may cross, touch and repeat; where they meet is a vertex, numbered after all others, and
   * equal points count as one. */
  int64_t resolve;
} circumspect_domain;

#define CIRCUMSPECT_DOMAIN                                                                     \
  {                                                                                            \
    sizeof(circumspect_domain), 0, 0, NULL, NULL, 0, NULL, 0, NULL, NULL, NULL, 0, NULL, 0, 0, \
        NULL, NULL, NULL, NULL, 0, NULL, NULL, 0, 0                                            \
  }

/* A Voronoi diagram. The cell of site s has the corners cell_starts[s] … cell_starts[s+1] − 1, each an index
 * of a vertex, or −1 if it is unbounded. Unbounded cells need the ridges: pairs of sites with a common one. */
typedef struct circumspect_voronoi {
  size_t struct_size; /* set by CIRCUMSPECT_VORONOI */
  int64_t dimension;  /* 2 or 3 */
  int64_t site_count;
  const double* sites;
  int64_t vertex_count;
  const double* vertices;
  const int64_t* cell_starts; /* site_count + 1, ascending from 0 */
  const int64_t* corners;
  int64_t ridge_count;
  const int64_t* ridges;
  const double* box; /* NULL for the usual one, or the least and then the largest coordinates */
  /* For the demand "structure", else NULL: ridge r has the ends ridge_starts[r] … ridge_starts[r+1] − 1, as the
   * corners of cells. */
  const int64_t* ridge_starts; /* ridge_count + 1, ascending from 0 */
  const int64_t* ridge_ends;
} circumspect_voronoi;

#define CIRCUMSPECT_VORONOI \
  { sizeof(circumspect_voronoi), 0, 0, NULL, 0, NULL, NULL, NULL, 0, NULL, NULL, NULL, NULL }

typedef struct circumspect_options {
  size_t struct_size;     /* set by CIRCUMSPECT_OPTIONS */
  int64_t threads;        /* 0: as many as the machine has; the answer is the same */
  int64_t max_violations; /* witnesses that are kept; 0: all */
  int32_t by_definition;  /* not 0: judge by the definitions, slowly */
  int32_t oriented;       /* not 0: demand one consistent orientation */
  const char* within;     /* NULL, or how far cells of the domain may be moved: "1e-9" */
  const char* mesh_name;  /* for text and JSON; NULL: "mesh" */
  int32_t without_json;   /* not 0: circumspect_verdict_json is empty */
  int64_t with_pictures;  /* not 0: the verdict keeps what circumspect_verdict_page shows */
  int32_t
      merge_equal_points; /* not 0: equal points count as one, the first (if weights count, the heaviest) */
  int32_t allow_empty; /* not 0: a mesh without points and simplices is judged */
  const char*
      demands; /* NULL, or what is demanded beside the claim, as the command's options: "only-extreme" */
  /* What is demanded of the shape of every simplex, each as "min-angle:20.7deg" or "radius-edge <= sqrt(2)"; and
   * NULL, or an angle as "60deg": simplices that touch both sides of a sharper one are set aside. */
  int64_t require_count;
  const char* const* require;
  const char* except_sharp;
  /* For "periodic-delaunay", else NULL: the vectors along which the mesh repeats, one after the other; and for
   * each corner of each simplex, which multiples of them, as many as there are, move its point there. */
  const double* lattice;  /* d·d */
  const int64_t* offsets; /* m·vertices_of_simplex·d */
} circumspect_options;

#define CIRCUMSPECT_OPTIONS                                                                      \
  {                                                                                              \
    sizeof(circumspect_options), 0, 20, 0, 0, NULL, NULL, 0, 0, 0, 0, NULL, 0, NULL, NULL, NULL, \
        NULL                                                                                     \
  }

typedef struct circumspect_verdict circumspect_verdict;

/* Judges, exactly, a claim about a mesh: "triangulation", "delaunay", "weighted-delaunay", "complex",
 * "convex-hull" (of a list of facets), "surface-delaunay" (of triangles), or, with a domain,
 * "plc-triangulation", "steiner-triangulation", "cdt", "steiner-cdt", "conforming-delaunay". NULL means
 * what the command means where no claim is named: "delaunay"; with a domain "cdt" if the mesh has the
 * points of the domain (with `within`, as many), else "steiner-cdt". Equal points are CIRCUMSPECT_INPUT_FAULT unless they are to be merged, and
 * so is a mesh without points and simplices, the usual output of a program that failed, unless it
 * is allowed. An index that names no point is the mesh's fault, and the verdict says so. For
 * "complex", equal points break a rule, and a mesh without simplices is CIRCUMSPECT_INPUT_FAULT.
 * `options`: NULL for the defaults. *verdict is set if CIRCUMSPECT_OK is returned, else to NULL. */
CIRCUMSPECT_API circumspect_status circumspect_check(const char* claim,
                                                     const circumspect_mesh* mesh,
                                                     const circumspect_domain* domain,
                                                     const circumspect_options* options,
                                                     circumspect_verdict** verdict);
/* Judges, exactly, whether the cells are the Voronoi cells of the sites, within a box, and within the
 * distance that `within` of the options names (NULL: 0); with the demand "structure" also whether the vertices
 * and the ridges are those of the diagram. Equal sites are CIRCUMSPECT_INPUT_FAULT. */
CIRCUMSPECT_API circumspect_status circumspect_check_voronoi(const circumspect_voronoi* diagram,
                                                             const circumspect_options* options,
                                                             circumspect_verdict** verdict);
CIRCUMSPECT_API void circumspect_verdict_free(circumspect_verdict* verdict); /* NULL is ignored */

/* 1 or 0; −1: not known, or the verdict is NULL. Unique and canonical are facts about a Delaunay
 * claim that holds: there is no other such triangulation; it is the one in which ties are broken
 * canonically. */
CIRCUMSPECT_API int circumspect_verdict_holds(const circumspect_verdict* verdict);
CIRCUMSPECT_API int circumspect_verdict_unique(const circumspect_verdict* verdict);
CIRCUMSPECT_API int circumspect_verdict_canonical(const circumspect_verdict* verdict);
/* The claim that was judged, by its name. Never NULL; empty if the verdict is. */
CIRCUMSPECT_API const char* circumspect_verdict_claim(const circumspect_verdict* verdict);
/* What the command prints: witnesses and the line of the verdict; the JSON document, one result. Never
 * NULL; empty if the verdict is. */
CIRCUMSPECT_API const char* circumspect_verdict_text(const circumspect_verdict* verdict);
CIRCUMSPECT_API const char* circumspect_verdict_json(const circumspect_verdict* verdict);
/* Notes for people on what was judged differently from what was passed in, such as merged points.
 * NULL if `index` is out of range. */
CIRCUMSPECT_API int64_t circumspect_verdict_note_count(const circumspect_verdict* verdict);
CIRCUMSPECT_API const char* circumspect_verdict_note(const circumspect_verdict* verdict,
                                                     int64_t index);

typedef struct circumspect_document circumspect_document;

/* The page that `--html` of the command writes, with a picture of each witness: one file of HTML, which loads
 * nothing. CIRCUMSPECT_NONE if the verdict was asked for without `with_pictures`. */
CIRCUMSPECT_API circumspect_status circumspect_verdict_page(const circumspect_verdict* verdict,
                                                            circumspect_document** page);

/* The broken rules, in the order in which they are judged, and how often each is broken. NULL and 0 where
 * `index` is out of range. */
CIRCUMSPECT_API int64_t circumspect_verdict_rule_count(const circumspect_verdict* verdict);
CIRCUMSPECT_API const char* circumspect_verdict_rule(const circumspect_verdict* verdict,
                                                     int64_t index, int64_t* count);

/* An exact number, and the double next to it (ties to even; infinite beyond the doubles). */
typedef struct circumspect_value {
  const char* name;
  const char* exact;
  double nearest;
} circumspect_value;

/* One witness. Members that a rule does not need are NULL and 0. Simplex s has the vertices
 * simplex_starts[s] … simplex_starts[s+1] − 1 of `simplices`, as the mesh lists them. */
typedef struct circumspect_violation {
  const char* rule;    /* "delaunay.facet-not-local": never changes its meaning */
  const char* meaning; /* one clause */
  int64_t simplex_count;
  const int64_t* simplex_starts;
  const int64_t* simplices;
  int64_t face_size;
  const int64_t* face;
  int64_t vertex_count;
  const int64_t* vertices;
  int64_t point_size; /* coordinates of a point that decides without being a vertex */
  const circumspect_value* point;
  int64_t centre_size; /* coordinates of the centre of the ball */
  const circumspect_value* centre;
  const circumspect_value* squared_radius;
  int64_t value_count;
  const circumspect_value* values;
} circumspect_violation;

CIRCUMSPECT_API int64_t circumspect_verdict_violation_count(const circumspect_verdict* verdict);
/* `size`: sizeof(circumspect_violation); later versions have more members behind these. */
CIRCUMSPECT_API circumspect_status circumspect_verdict_violation(const circumspect_verdict* verdict,
                                                                 int64_t index,
                                                                 circumspect_violation* violation,
                                                                 size_t size);

typedef struct circumspect_drawing circumspect_drawing;

/* The points that a seed stands for, the same on every machine and the same as the command draws.
 * `family` is one of the families of points that `circumspect generate --list` names, such as
 * "sphere+ulp". `points`: how many are drawn, from 1 to 1000000; equal ones count once unless the
 * family repeats points. CIRCUMSPECT_INVALID_ARGUMENT if there is no such family, or not in that
 * dimension. */
CIRCUMSPECT_API circumspect_status circumspect_generate(const char* family, int64_t dimension,
                                                        int64_t points, uint64_t seed,
                                                        circumspect_drawing** drawing);
/* The same for domains. `points`: about how many are drawn. */
CIRCUMSPECT_API circumspect_status circumspect_generate_domain(const char* family, int64_t points,
                                                               uint64_t seed,
                                                               circumspect_drawing** drawing);
/* The domain, which lives as long as the drawing; NULL for a drawing of points, and for NULL. A
 * family may draw coplanar points and ask for their hull, which is CIRCUMSPECT_INPUT_FAULT when it
 * is to be filled. */
CIRCUMSPECT_API const circumspect_domain* circumspect_drawing_domain(
    const circumspect_drawing* drawing);
/* A mesh of these points, all doubles, and of their weights if the family has weights, without
 * simplices. It lives as long as the drawing; you may add simplices to a copy and have it judged.
 * NULL for NULL. */
CIRCUMSPECT_API const circumspect_mesh* circumspect_drawing_mesh(
    const circumspect_drawing* drawing);
CIRCUMSPECT_API void circumspect_drawing_free(circumspect_drawing* drawing);

typedef struct circumspect_triangulation circumspect_triangulation;

/* The canonical Delaunay triangulation of the points of a mesh (weighted, if it has weights),
 * whatever their order, by exact arithmetic: a reference, not a fast implementation. The simplices
 * of the mesh are ignored. Equal points are CIRCUMSPECT_INPUT_FAULT. Book: Sections 4.2, 5.2. */
CIRCUMSPECT_API circumspect_status circumspect_delaunay(const circumspect_mesh* points,
                                                        circumspect_triangulation** triangulation);
/* The canonical constrained Delaunay triangulation of a domain; CIRCUMSPECT_NONE if there is none;
 * circumspect_last_error() then has the reason. Book: Sections 3.10, 4.5, 5.6. */
CIRCUMSPECT_API circumspect_status circumspect_constrained_delaunay(
    const circumspect_domain* domain, circumspect_triangulation** triangulation);
CIRCUMSPECT_API void circumspect_triangulation_free(circumspect_triangulation* triangulation);
/* The dimension of its simplices: that of the points' affine hull; −1 if there are none, or for
NULL. */
CIRCUMSPECT_API int64_t
circumspect_triangulation_dimension(const circumspect_triangulation* triangulation);
/* How many simplices there are with `vertices` vertices each, positively oriented if they have the
 * triangulation's dimension; those with fewer are the dangling ones of a domain. *indices is set to
 * them, NULL if there are none. */
CIRCUMSPECT_API int64_t circumspect_triangulation_simplices(
    const circumspect_triangulation* triangulation, int64_t vertices, const int64_t** indices);

/* The sign of det(p_0 − p_d, …, p_{d−1} − p_d): −1, 0 or 1. `coordinates`: d+1 points. In the plane
 * positive if counterclockwise. Book: Section 3.1. */
CIRCUMSPECT_API circumspect_status circumspect_orientation(int64_t dimension,
                                                           const double* coordinates, int* sign);
/* Is the last of d+2 points inside (1), on (0) or outside (−1) the circumsphere of the others? However
 * these are oriented. CIRCUMSPECT_INPUT_FAULT if they are affinely dependent. */
CIRCUMSPECT_API circumspect_status circumspect_in_ball(int64_t dimension, const double* coordinates,
                                                       int* sign);
/* The same for exact numbers, as in circumspect_mesh. */
CIRCUMSPECT_API circumspect_status circumspect_orientation_exact(int64_t dimension,
                                                                 const char* const* coordinates,
                                                                 int* sign);
CIRCUMSPECT_API circumspect_status circumspect_in_ball_exact(int64_t dimension,
                                                             const char* const* coordinates,
                                                             int* sign);

/* Are two meshes the same complex, whatever their numbering? *same is 1 or 0, and the document
 * lists in JSON what only one of the meshes has: {"same", "only_in_a": {"points", "simplices"},
 * "only_in_b"}. Equal points are CIRCUMSPECT_INPUT_FAULT, and so is a mesh without points and
 * simplices. */
CIRCUMSPECT_API circumspect_status circumspect_compare(const circumspect_mesh* a,
                                                       const circumspect_mesh* b, int* same,
                                                       circumspect_document** document);
/* What proves a verdict to circumspect-verified: a certificate if the claim holds (*holds is 1), else a
 * refutation. For the claims without a domain; CIRCUMSPECT_NONE if there is none. Equal points are
 * CIRCUMSPECT_INPUT_FAULT, and so is a mesh without points and simplices. */
CIRCUMSPECT_API circumspect_status circumspect_certify(const char* claim,
                                                       const circumspect_mesh* mesh, int* holds,
                                                       circumspect_document** document);
/* Facts about the points of a mesh (weighted, if it has weights), in JSON: {"points", "dimension"
 * (of their affine hull, −1 if there are none), "repeated" (pairs of indices of equal points),
 * "unique", "cospherical"}. *unique is 1 if there is only one Delaunay triangulation; else
 * "cospherical" has k+2 points on the boundary of one empty ball. Builds the triangulation. Book:
 * Section 4.2. */
CIRCUMSPECT_API circumspect_status circumspect_inspect(const circumspect_mesh* points, int* unique,
                                                       circumspect_document** document);
CIRCUMSPECT_API const char* circumspect_document_text(const circumspect_document* document);
CIRCUMSPECT_API void circumspect_document_free(circumspect_document* document);

#ifdef __cplusplus
}
#endif

#endif
