(** * Domains: everything that the theorems about domains speak of

    The words of Definitions.v go on here: first what a certificate about a domain says beside that
    of its mesh, as records; then the book's Sections 2.10 and 4.5.1, for R^d; then what the files
    are about.  Nothing here is proved, and nothing here computes a verdict. *)
From Coq Require Import String Rbase Rfunctions List ZArith.
From Circumspect Require Import Definitions.
Import ListNotations.
Open Scope R_scope.

(** ** Certificates about domains, as they stand in a file

    A domain is given by vertices, segments, polygons (in space) and hole points.  A certificate
    about it begins with one for a mesh of a whole convex hull, that of the domain or a greater one.
    Some of its simplices are kept: these are the mesh that the certificate is about. *)

Inductive domain_claim :=
  PlcTriangulation | SteinerTriangulation | ConformingDelaunay | Cdt | SteinerCdt.
(** What the domain fills: what its walls enclose, or the convex hull of its vertices. *)
Inductive domain_kind := Enclosed | Hull.

(** What a point of the mesh is: a vertex of the domain, and of the kept simplex T; or another, of
    which the kind [Hull] wants to know that it is a combination of the vertices. *)
Inductive role := Corner (t : positive) | Steiner (w : list (Z * positive)).
(** A step along a segment: to the point, by an edge of the simplex T (in the plane, its facet
    I). *)
Record link := Link { reached : positive; link_simplex : positive; link_facet : nat }.
Record segment_entry := SegmentEntry { from : positive; links : list link }.
(** How one gets out of a simplex that is not kept: it holds hole H; through facet I, which is on
    the hull; through facet I into a simplex of smaller rank. *)
Inductive way := InHole (h : positive) | OutOfHull (i : nat) | Across (i : nat).
(** Is the simplex kept; which of its facets are walls: part of segment K, or piece U of polygon
    K. *)
Record mark := Mark {
  kept : bool; flags : list (option (positive * positive)); way_out : way; rank : positive }.
(** The point [hole_point] / [hole_w], in simplex T. *)
Record hole_entry := HoleEntry { hole_point : site; hole_w : Z; hole_simplex : positive }.
Record part := Part {
  roles : list role;               (* one a point *)
  segments : list segment_entry;
  holes : list hole_entry;
  marks : list mark                (* one a simplex *)
}.
(** A polygon in space: the plane where <normal, p> = offset, and seen along an axis a domain in the
    plane, with its own certificate; which point of the mesh is above which of its points; where in
    the mesh its kept triangles are; and its hole points, whose projections are those of that
    domain. *)
Record polygon_entry := PolygonEntry {
  normal : list Z; offset : Z; axis : nat;
  plane_mesh : certificate; plane_part : part;
  above : list positive;
  tiles : list (positive * nat);
  seeds : list (site * Z)
}.
Record domain_certificate := DomainCertificate {
  domain_claimed : domain_claim;
  kind : domain_kind;
  whole_mesh : certificate;
  domain_part : part;
  polygons : list polygon_entry    (* none in the plane *)
}.

(** What shows that the domain of a certificate is a piecewise linear complex.  A face of the mesh
    (a vertex, an edge, in polygons a triangle) in a segment or a polygon is held by it: in no other
    segment or polygon is there this face, but that polygons may have segments in them; a vertex of
    the domain need not be held. *)
Inductive holder := InSegment (k : positive) | InPolygon (k : positive).
(** The face with these vertices and the one, of a smaller number, at which the entry stands. *)
Record face_entry := FaceEntry { others : list positive; face_holder : holder }.
(** Of a polygon: for each of its own segments which segment of the domain this is, and whether the
    polygon is on one side of it only; and all the segments of the domain in it, for each of their
    steps with a piece of the polygon that has it for an edge. *)
Record polygon_faces := PolygonFaces {
  rim_segments : list (positive * bool);
  segments_in : list (positive * list positive)
}.
Record complex_part := ComplexPart {
  faces : list (list face_entry);  (* one list a point *)
  one_sided : list bool;           (* one a wall: is the domain on one side of it only? *)
  polygon_parts : list polygon_faces
}.

Definition domain_claim_name (c : domain_claim) : string :=
  match c with
  | PlcTriangulation => "plc-triangulation"
  | SteinerTriangulation => "steiner-triangulation"
  | ConformingDelaunay => "conforming-delaunay"
  | Cdt => "cdt"
  | SteinerCdt => "steiner-cdt"
  end%string.

Section Book.
Context {d : nat}.

(** ** What walls enclose *)

(** The point that divides the segment from [x] to [y] in the ratio s : 1 - s. *)
Definition between (x y : point d) (s : R) : point d := plus (scale (1 - s) x) (scale s y).

Section Enclosed.
(** All this happens in a plane, or in all of R^d: [flat] are its points. *)
Variable flat : point d -> Prop.
Variable walls : point d -> Prop.
Variable hole_points : list (point d).
(** From [x] one gets to [y] along segments that meet no wall. *)
Definition clear (x y : point d) : Prop := forall s, 0 <= s <= 1 -> ~ walls (between x y s).
Inductive connected (x : point d) : point d -> Prop :=
  | here : connected x x
  | further y z : connected x y -> flat z -> clear y z -> connected x z.
(** Points as far away as one likes are connected with [x]. *)
Definition unbounded (x : point d) : Prop := forall r, exists y, connected x y /\ r < norm2 y.
(** The walls and the bounded components of what they leave over, but for those with a hole
    point. *)
Definition enclosed (q : point d) : Prop := flat q /\
  (walls q \/ ~ unbounded q /\ forall h, In h hole_points -> ~ connected q h).
End Enclosed.

(** ** Domains *)

(** The points of one of the segments. *)
Definition on_segments (E : list (point d * point d)) (q : point d) : Prop :=
  exists a b, In (a, b) E /\ conv [a; b] q.

(** A polygon: the part of a hyperplane (a plane, if d is 3) that its segments enclose: its outline,
    the outlines of its holes, its slits. *)
Record polygon := Polygon {
  plane_normal : point d; plane_offset : R;
  rim : list (point d * point d);
  gaps : list (point d)
}.
Definition polygon_points (f : polygon) : point d -> Prop :=
  enclosed (fun q => inner (plane_normal f) q = plane_offset f) (on_segments (rim f)) (gaps f).

(** In the plane the segments are the walls of a domain, else its polygons. *)
Record domain := Domain {
  what_it_fills : domain_kind;
  domain_vertices : list (point d);
  domain_segments : list (point d * point d);
  domain_polygons : list polygon;
  domain_holes : list (point d)
}.
Definition walls_of (P : domain) (q : point d) : Prop :=
  match d with
  | 2%nat => on_segments (domain_segments P) q
  | _ => exists f, In f (domain_polygons P) /\ polygon_points f q
  end.
(** The same, one by one. *)
Definition wall_cells (P : domain) : list (point d -> Prop) :=
  match d with
  | 2%nat => map (fun ab q => conv [fst ab; snd ab] q) (domain_segments P)
  | _ => map polygon_points (domain_polygons P)
  end.
(** In the plane there are no polygons; a polygon has a plane.  (The domain of every certificate
    that is accepted is one of these.) *)
Definition proper_domain (P : domain) : Prop :=
  (d = 2%nat -> domain_polygons P = []) /\ forall f, In f (domain_polygons P) ->
    plane_normal f <> origin.
(** The polyhedra (in the plane, the polygons), as one cell: linear cells need not be connected. *)
Definition region (P : domain) : point d -> Prop :=
  match what_it_fills P with
  | Enclosed => enclosed (fun _ => True) (walls_of P) (domain_holes P)
  | Hull => conv (domain_vertices P)
  end.
(** The linear cells, as the sets of their points. *)
Definition cells (P : domain) : list (point d -> Prop) :=
  map (fun v q => q = v) (domain_vertices P) ++
  map (fun ab q => conv [fst ab; snd ab] q) (domain_segments P) ++
  map polygon_points (domain_polygons P) ++ [region P].
(** |P| *)
Definition underlying (P : domain) (q : point d) : Prop := exists X, In X (cells P) /\ X q.

(** ** Definition 4.3

    A linear cell, with its dimension and its affine hull.  What the domain fills is a cell if walls
    enclose it; the hull of its vertices is none, since its boundary is not listed. *)
Record linear_cell := LinearCell {
  cell_dimension : nat; affine_hull : point d -> Prop; cell_points : point d -> Prop }.
Definition linear_cells (P : domain) : list linear_cell :=
  map (fun v => LinearCell 0 (fun q => q = v) (fun q => q = v)) (domain_vertices P) ++
  map (fun ab => LinearCell 1 (fun q => exists s, q = between (fst ab) (snd ab) s)
    (conv [fst ab; snd ab]))
    (domain_segments P) ++
  map (fun f => LinearCell 2 (fun q => inner (plane_normal f) q = plane_offset f)
    (polygon_points f))
    (domain_polygons P) ++
  match what_it_fills P with
  | Enclosed => [LinearCell d (fun _ => True) (region P)]
  | Hull => []
  end.
(** The boundary of a union of finitely many convex polytopes: the points from which one gets out of
    it, within its affine hull, along a segment that has nothing else in common with it. *)
Definition boundary (f : linear_cell) (q : point d) : Prop := cell_points f q /\
  exists r, affine_hull f r /\ forall s, 0 < s <= 1 -> ~ cell_points f (between q r s).
Definition within (X Y : point d -> Prop) : Prop := forall q, X q -> Y q.

Record piecewise_linear_complex (P : domain) : Prop := {
  (** The vertices and segments form a simplicial complex. *)
  complex_of_segments : simplicial_complex (fun s => NoDup s /\
    ((exists v, In v (domain_vertices P) /\ same s [v]) \/
     exists a b, In (a, b) (domain_segments P) /\ same s [a; b]));
  (** The boundary of each cell is a union of cells. *)
  boundary_of_cells : forall f q, In f (linear_cells P) -> boundary f q ->
    exists g, In g (linear_cells P) /\ cell_points g q /\ within (cell_points g) (boundary f);
  (** Where two cells meet, if they are not the same, is a union of cells, each of a lower dimension
      than one of the two. *)
  meeting_cells : forall f g q, In f (linear_cells P) -> In g (linear_cells P) ->
    ~ (within (cell_points f) (cell_points g) /\ within (cell_points g) (cell_points f)) ->
    cell_points f q -> cell_points g q ->
    exists h, In h (linear_cells P) /\ cell_points h q /\
      within (cell_points h) (cell_points f) /\ within (cell_points h) (cell_points g) /\
      (cell_dimension h < cell_dimension f \/ cell_dimension h < cell_dimension g)%nat
}.

(** ** Triangulations of domains

    [K] lists simplices of any dimension, which with their faces are the complex: all of it,
    whatever dangles.  (A list also says how often.  The d-simplices are listed once.) *)
Definition union_of_simplices (K : list (simplex d)) (X : point d -> Prop) : Prop :=
  exists F, (forall s, In s F -> faces_of K s) /\ forall q, X q <-> exists s, In s F /\ conv s q.

(** Definition 4.5: a Steiner triangulation of P is a simplicial complex that contains every vertex
    of P, and possibly more; every linear cell of P is a union of simplices of the complex, and
    these fill |P|. *)
Definition steiner_triangulation (P : domain) (K : list (simplex d)) : Prop :=
  (forall s, In s K -> NoDup s /\ s <> [] /\ (length s <= S d)%nat) /\
  ForallOrdPairs (fun s t => length s = S d -> ~ same s t) K /\
  simplicial_complex (faces_of K) /\
  (forall v, In v (domain_vertices P) -> exists s, In s K /\ In v s) /\
  (forall X, In X (cells P) -> union_of_simplices K X) /\
  (forall q, underlying P q <-> exists s, In s K /\ conv s q).

(** Definition 4.4: in a triangulation of P, P and the complex have the same vertices. *)
Definition plc_triangulation (P : domain) (K : list (simplex d)) : Prop :=
  steiner_triangulation P K /\ forall s v, In s K -> In v s -> In v (domain_vertices P).

(** Definition 4.5: in a conforming Delaunay triangulation every simplex is Delaunay, with respect
    to the vertices of the complex. *)
Definition conforming_delaunay (P : domain) (K : list (simplex d)) : Prop :=
  steiner_triangulation P K /\ forall s, In s K -> delaunay (concat K) s.

(** Nothing dangles: each simplex is a face of a d-simplex, for only these are listed. *)
Definition solid (K : list (simplex d)) : Prop := forall s, In s K -> length s = S d.

(** ** Constrained Delaunay *)

(** Definition 2.11: a simplex respects a domain if it is in |P|, and what it has in common with
    each cell is a union of its faces. *)
Definition union_of_faces (X : point d -> Prop) (s : simplex d) : Prop :=
  exists F, (forall f, In f F -> incl f s) /\ forall q, X q <-> exists f, In f F /\ conv f q.
Definition respects (P : domain) (s : simplex d) : Prop :=
  (forall q, conv s q -> underlying P q) /\
  (forall X, In X (cells P) -> union_of_faces (fun q => X q /\ conv s q) s).

(** Definition 2.13. *)
Definition visible (P : domain) (x y : point d) : Prop := respects P [x; y].

(** Definition 4.6, for the vertices [V]: those of the domain or, with Steiner points, of the
    mesh. *)
Definition constrained_delaunay (V : list (point d)) (P : domain) (s : simplex d) : Prop :=
  incl s V /\ respects P s /\
  exists c r2, circumball s c r2 /\ forall v x, In v V -> strictly_inside s x -> visible P x v ->
    ~ dist2 c v < r2.

(** Definition 4.7: a CDT is a triangulation of P in which every tetrahedron is constrained
    Delaunay, and every dangling triangle, one that is not a face of any tetrahedron.  (In the
    plane: every triangle.)  And a Steiner CDT. *)
Definition has_to_be_constrained_delaunay (K : list (simplex d)) (s : simplex d) : Prop :=
  length s = S d \/ length s = 3%nat /\ forall t, In t K -> length t = S d -> ~ incl s t.
Definition cdt (P : domain) (K : list (simplex d)) : Prop :=
  plc_triangulation P K /\
  forall s, In s K -> has_to_be_constrained_delaunay K s ->
    constrained_delaunay (domain_vertices P) P s.
Definition steiner_cdt (P : domain) (K : list (simplex d)) : Prop :=
  steiner_triangulation P K /\
  forall s, In s K -> has_to_be_constrained_delaunay K s -> constrained_delaunay (concat K) P s.

(** What a claim says of a domain and a complex. *)
Definition holds_of_complex (c : domain_claim) : domain -> list (simplex d) -> Prop :=
  match c with
  | PlcTriangulation => plc_triangulation
  | SteinerTriangulation => steiner_triangulation
  | ConformingDelaunay => conforming_delaunay
  | Cdt => cdt
  | SteinerCdt => steiner_cdt
  end.
End Book.
Arguments polygon d : clear implicits.
Arguments domain d : clear implicits.

(** ** What the files are about, in the caller's coordinates *)

Section Part.
Variables (d : nat) (c : certificate) (p : part).
Notation spot := (spot d c).

Definition part_vertices : list (point d) :=
  flat_map (fun pr => match snd pr with Corner _ => [place_of (unit_of c) (position (fst pr))]
                                      | Steiner _ => [] end) (combine (points c) (roles p)).
Definition segment_ends (s : segment_entry) : point d * point d :=
  (spot (from s), spot (last (map reached (links s)) (from s))).
Definition part_segments : list (point d * point d) := map segment_ends (segments p).
Definition seed_point (x : site) (w : Z) : point d := place_of (unit_of c / IZR w) x.
Definition part_holes : list (point d) :=
  map (fun h => seed_point (hole_point h) (hole_w h)) (holes p).
(** The steps from [u] on. *)
Fixpoint edges_from (u : positive) (l : list link) : list (list positive) :=
  match l with [] => [] | s :: l' => [u; reached s] :: edges_from (reached s) l' end.
Definition part_steps : list (simplex d) :=
  flat_map (fun s => map (map spot) (edges_from (from s) (links s))) (segments p).
(** The kept simplices. *)
Definition part_simplices : list (simplex d) :=
  flat_map (fun em => if kept (snd em) then [map spot (corners (fst em))] else [])
    (combine (simplices c) (marks p)).
End Part.

(** The point of the mesh that is above a point of the polygon. *)
Definition spot_above (d : nat) (c : certificate) (f : polygon_entry) (k : positive) : point d :=
  match numbered (above f) k with Some j => spot d c j | None => origin end.

Section Domain.
Variables (d : nat) (c : domain_certificate).
Notation mesh := (whole_mesh c).

(** The segments of a polygon: those of its certificate, between the points of the mesh above. *)
Definition polygon_of (f : polygon_entry) : polygon d :=
  let up := spot_above d mesh f in
  {| plane_normal := integer_point d (normal f);
     plane_offset := unit_of mesh * IZR (offset f);
     rim := map (fun s => (up (from s), up (last (map reached (links s)) (from s))))
              (segments (plane_part f));
     gaps := map (fun s => seed_point d mesh (fst s) (snd s)) (seeds f) |}.
Definition domain_of_certificate : domain d :=
  {| what_it_fills := kind c;
     domain_vertices := part_vertices d mesh (domain_part c);
     domain_segments := part_segments d mesh (domain_part c);
     domain_polygons := map polygon_of (polygons c);
     domain_holes := part_holes d mesh (domain_part c) |}.
Definition mesh_of_domain : list (simplex d) := part_simplices d mesh (domain_part c).
(** Where something may dangle, the complex also lists the vertices of the domain, the steps along
    its segments, and the pieces of its polygons.  (Those that are faces of kept simplices do not
    dangle, and to list them changes no complex.) *)
Definition pieces_of (f : polygon_entry) : list (simplex d) :=
  flat_map (fun em => if kept (snd em) then [map (spot_above d mesh f) (corners (fst em))] else [])
    (combine (simplices (plane_mesh f)) (marks (plane_part f))).
Definition faces_of_domain : list (simplex d) :=
  flat_map pieces_of (polygons c) ++ part_steps d mesh (domain_part c) ++
  map (fun v => [v]) (part_vertices d mesh (domain_part c)).
Definition mesh_with_faces : list (simplex d) := mesh_of_domain ++ faces_of_domain.
End Domain.
