(** * Rules of domains: what the theorems about refutations of claims about domains speak of

    The words of Definitions.v and Domains.v go on here.  A refutation is the caller's mesh and what
    it says of the domain: its vertices and some of its segments.  Whatever else the domain has, the
    claim is false of it.  At the end is what shows that a domain has no triangulation.  Nothing is
    proved here. *)
From Coq Require Import String Rbase Rfunctions List ZArith.
From Circumspect Require Import Definitions Domains.
Import ListNotations.
Open Scope R_scope.

(** ** Refutations, as they stand in a file *)

(** What shows a broken rule; simplices, points, vertices and segments are counted from 1, the
    entries of a simplex from 0. *)
Inductive domain_evidence :=
  | VertexMissing (v : positive)                     (* of the domain *)
  | SteinerForbidden (t : positive) (i : nat)
  | SegmentMissing (k : positive) (q : site) (w : Z) (* the point q / w of segment K *)
  (* entry I of simplex T is on segment S, between entries J and K of simplex U *)
  | VertexInEdge (t : positive) (i : nat) (u : positive) (j k : nat) (s : positive)
  (* U dangles; with these weights its vertices and the points of the mesh sum up to nothing, and
     their squares to less *)
  | NoEmptyBall (u : positive) (own : list Z) (others : list (positive * Z))
  | OfMesh.                                          (* the evidence that is about the mesh alone *)
(** The caller's triangles and edges that may be faces of no simplex: the entries of each, and which
    of the [pads], points of no mesh that are counted on after the caller's, make a d-simplex of it,
    to see where it is. *)
Record dangling_part := DanglingPart { pads : list site; dangling : list (row * row) }.
Record domain_refutation := DomainRefutation {
  domain_refuted : domain_claim;
  (* the caller's points, simplices and, for [OfMesh], evidence *)
  mesh_refuted : refutation;
  dangling_refuted : dangling_part;   (* its rows are counted on after the simplices *)
  vertices_given : list site;
  segments_given : list (positive * positive);
  domain_because : domain_evidence
}.

(** Some rules speak of the whole domain: it is that of a certificate whose points are its vertices,
    and which has no simplices, or of one of another mesh.  A point of it: vertex K; the point q / w
    of segment K, or of triangle U of polygon K. *)
Inductive domain_point :=
  | AtCorner (k : positive)
  | AlongSegment (k : positive) (q : site) (w : Z)
  | InPiece (k u : positive) (q : site) (w : Z).
(** How one gets from a point out of the domain: along straight legs, each with planes <n, p> = o
    that part it from all cells but what is filled, to a hole point, or beyond a plane <n, p> = o
    that all vertices are behind. *)
Record leg := Leg { leg_end : site; leg_w : Z; leg_planes : list (list Z * Z) }.
Inductive way_off := IntoHole (h : positive) | Beyond (n : list Z) (o : Z).
Inductive whole_evidence :=
  (* q / w is inside facet I of simplex T, which is facet J of U, and in no wall *)
  | FacetInNoWall (t : positive) (i : nat) (u : positive) (j : nat) (q : site) (w : Z)
  (* from q / w, inside simplex T, one looks at vertex V of the mesh *)
  | BallSeen (t v : positive) (q : site) (w : Z) (planes : list (list Z * Z))
  | NotTiled (k u : positive) (q : site) (w : Z)
  | NotCovered (x : domain_point)
  (* q / w, in simplex T, is outside *)
  | Strays (t : positive) (q : site) (w : Z) (legs : list leg) (out : way_off)
  (* q / w is in simplex T, and the end of the leg in none *)
  | Gap (t : positive) (q : site) (w : Z) (l : leg)
  (* of a mesh that is to fill a hull: evidence about its boundary, as of points *)
  | OfHull (e : evidence)
  (* the domain comes with another mesh of it, and q / w is in its kept simplex T *)
  | CoveredElsewhere (t : positive) (q : site) (w : Z)
  (* the triangle U dangles; with these weights its vertices and V sum up to nothing, and their
     squares to less.  From q / w, inside, one gets to V in polygon K, from point to point in its
     pieces; the planes part the way from all other cells *)
  | DanglingSees (u v : positive) (own : list Z) (other : Z) (k : positive) (q : site) (w : Z)
      (bends : list (positive * (site * Z))) (last : positive) (planes : list (list Z * Z)).
Record whole_refutation := WholeRefutation {
  (* the caller's points and simplices; its evidence is not read *)
  mesh_against : refutation;
  dangling_against : dangling_part;
  about_domain : domain_certificate;  (* and the claim that is refuted *)
  shown_by : whole_evidence
}.

Inductive domain_rule :=
  | domain_vertex_missing | domain_steiner_forbidden | domain_segment_missing
  | domain_vertex_in_edge | domain_polygon_not_tiled
  | domain_uncovered | domain_outside | domain_uncovered_or_outside | delaunay_no_empty_ball
  | cdt_facet_not_local | cdt_visible_vertex_in_ball | cdt_dangling_not_delaunay
  | mesh_rule (r : rule).
Definition whole_rule_of (c : whole_refutation) : domain_rule :=
  match shown_by c with
  | FacetInNoWall _ _ _ _ _ _ => cdt_facet_not_local
  | BallSeen _ _ _ _ _ => cdt_visible_vertex_in_ball
  | NotTiled _ _ _ _ => domain_polygon_not_tiled
  | NotCovered _ => domain_uncovered
  | Strays _ _ _ _ _ => domain_outside
  | Gap _ _ _ _ => domain_uncovered_or_outside
  | OfHull e => mesh_rule (rule_of e)
  | CoveredElsewhere _ _ _ => domain_uncovered
  | DanglingSees _ _ _ _ _ _ _ _ _ _ => cdt_dangling_not_delaunay
  end.
Definition domain_rule_of (c : domain_refutation) : domain_rule :=
  match domain_because c with
  | VertexMissing _ => domain_vertex_missing
  | SteinerForbidden _ _ => domain_steiner_forbidden
  | SegmentMissing _ _ _ => domain_segment_missing
  | VertexInEdge _ _ _ _ _ _ => domain_vertex_in_edge
  | NoEmptyBall _ _ _ => delaunay_no_empty_ball
  | OfMesh => mesh_rule (rule_of (because (mesh_refuted c)))
  end.
Definition domain_rule_name (r : domain_rule) : string :=
  match r with
  | domain_vertex_missing => "domain.vertex-missing"
  | domain_steiner_forbidden => "domain.steiner-forbidden"
  | domain_segment_missing => "domain.segment-missing"
  | domain_vertex_in_edge => "domain.vertex-in-edge"
  | domain_polygon_not_tiled => "domain.polygon-not-tiled"
  | domain_uncovered => "domain.uncovered"
  | domain_outside => "domain.outside"
  | domain_uncovered_or_outside => "domain.uncovered or domain.outside"
  | delaunay_no_empty_ball => "delaunay.no-empty-ball"
  | cdt_facet_not_local => "cdt.facet-not-local"
  | cdt_visible_vertex_in_ball => "cdt.visible-vertex-in-ball"
  | cdt_dangling_not_delaunay => "cdt.dangling-not-delaunay"
  | mesh_rule r => rule_name r
  end%string.

(** ** The rules *)

Section Rules.
Context {d : nat}.
Implicit Types (P : domain d) (L : list (list (option (point d)))).

(** What is claimed: all vertices are known, and of the simplices [L] and what dangles, [M], the
    claim holds.  (Which file a row stands in does not matter: a triangle or an edge may stand among
    the simplices.) *)
Definition claims_of_domain (c : domain_claim) P L M : Prop :=
  exists K, (L ++ M)%list = map (map Some) K /\ holds_of_complex c P K.

(** A row lists no vertex, or more than a simplex has.  (If it lists fewer than d+1, it may
    dangle.) *)
Definition no_simplex L : Prop := exists r : list (option (point d)), In r L /\
  (r = [] \/ (S d < length r)%nat).
(** A vertex of the domain is a vertex of no simplex. *)
Definition vertex_missing P L : Prop := exists v, In v (domain_vertices P) /\
  forall r : list (option (point d)), In r L -> ~ In (Some v) r.
(** A vertex of a simplex is none of the domain. *)
Definition steiner_forbidden P L : Prop := exists (r : list (option (point d))) v,
  In r L /\ In (Some v) r /\ ~ In v (domain_vertices P).
(** A point of a segment is in no face, of a simplex of the mesh, that is in the segment. *)
Definition segment_missing P L : Prop := exists a b q, In (a, b) (domain_segments P) /\
  conv [a; b] q /\
  forall s f, listed L s -> incl f s -> conv f q -> ~ within (conv f) (conv [a; b]).

(** A vertex of a simplex is on a segment and inside an edge of another. *)
Definition vertex_in_edge P L : Prop := exists (r : list (option (point d))) s v a b e f, In r L /\
  In (Some v) r /\
  listed L s /\ In e s /\ In f s /\ v <> e /\ v <> f /\ conv [e; f] v /\
  In (a, b) (domain_segments P) /\ conv [a; b] v.
(** A point of a polygon is in no face, of a simplex of the mesh, that is in the polygon. *)
Definition polygon_not_tiled P L : Prop := exists f q, In f (domain_polygons P) /\
  polygon_points f q /\
  forall s g, listed L s -> incl g s -> conv g q -> ~ within (conv g) (polygon_points f).
(** A point of the domain is in no simplex; a point of a simplex is not in the domain. *)
Definition uncovered P L : Prop := exists q, underlying P q /\ forall s, listed L s -> ~ conv s q.
Definition outside P L : Prop := exists s q, listed L s /\ conv s q /\ ~ underlying P q.
(** The facet is in no wall. *)
Definition in_no_wall P (f : simplex d) : Prop := forall X, In X (wall_cells P) ->
  ~ within (conv f) X.
(** Two simplices share a facet that is in no wall, and the apex of the second, on the other side of
    it, is in every open circumball of the first. *)
Definition constrained_facet_not_local P L : Prop := exists s t f p v, listed_simplex L s /\
  listed L t /\
  NoDup f /\ length f = d /\ incl f s /\ incl f t /\ In p s /\ In v t /\
  on_opposite_sides f p v /\ (forall c r2, circumball s c r2 -> dist2 c v < r2) /\ in_no_wall P f.
(** The cells but for what the domain fills. *)
Definition low_cells P : list (point d -> Prop) :=
  map (fun v q => q = v) (domain_vertices P) ++
  map (fun ab q => conv [fst ab; snd ab] q) (domain_segments P) ++ map polygon_points
    (domain_polygons P).
(** A vertex of the mesh is in every open circumball of a simplex, and on the way to it from a point
    inside there is no vertex, no segment and no polygon but at its end.  (So it is visible, if the
    simplex is in the domain.) *)
Definition visible_vertex_in_ball P L : Prop := exists s v x, listed_simplex L s /\
  (exists r : list (option (point d)), In r L /\ In (Some v) r) /\ strictly_inside s x /\
  (forall X e, In X (low_cells P) -> 0 <= e < 1 -> ~ X (between x v e)) /\
  forall c r2, circumball s c r2 -> dist2 c v < r2.

(** The vertices of the mesh. *)
Definition entries L : list (point d) :=
  flat_map (flat_map (fun o => match o with Some v => [v] | None => [] end)) L.
(** A simplex dangles: it is a face of no d-simplex.  And every open circumball of it contains a
    vertex of the mesh, or of the domain (which is to be one of the mesh). *)
Definition no_empty_ball P L M : Prop := exists s, listed M s /\ affinely_independent s /\
  (forall t, listed L t -> ~ incl s t) /\
  forall c r2, circumball s c r2 -> exists v, (In v (entries (L ++ M)) \/
    In v (domain_vertices P)) /\ dist2 c v < r2.
(** A triangle dangles, and a vertex of the mesh is in every open circumball of it: so it is in
    their plane, and in the open circumdisk.  It is visible from a point inside: the way there is in
    a polygon, and none of it but its end is in another polygon, in a segment or a vertex. *)
Definition dangling_not_delaunay P L M : Prop := exists s v x f, listed M s /\ length s = 3%nat /\
  affinely_independent s /\
  (forall t, listed (L ++ M) t -> length t = S d -> ~ incl s t) /\ In v (entries (L ++ M)) /\
    strictly_inside s x /\
  In f (domain_polygons P) /\ (forall e, 0 <= e <= 1 -> polygon_points f (between x v e)) /\
  (forall X e, In X (low_cells P) -> 0 <= e < 1 -> X (between x v e) -> X = polygon_points f) /\
  forall c r2, circumball s c r2 -> dist2 c v < r2.
(** The rule is broken; of the mesh's own rules those of simplices alone are used, two about balls
    and, where the domain is a hull, two about the boundary of the mesh.  (Its points are then the
    vertices of the mesh; what is in a ball may be a vertex of the domain, too, which is to be one
    of the mesh.) *)
Definition broken_of_domain P L M (r : domain_rule) : Prop :=
  match r with
  | domain_vertex_missing => vertex_missing P (L ++ M)
  | domain_steiner_forbidden => steiner_forbidden P (L ++ M)
  | domain_segment_missing => segment_missing P (L ++ M)
  | domain_vertex_in_edge => vertex_in_edge P (L ++ M)
  | domain_polygon_not_tiled => polygon_not_tiled P (L ++ M)
  | domain_uncovered => uncovered P (L ++ M)
  | domain_outside => outside P (L ++ M)
  | domain_uncovered_or_outside => ~ (~ uncovered P (L ++ M) /\ ~ outside P (L ++ M))
  | delaunay_no_empty_ball => no_empty_ball P L M
  | cdt_facet_not_local => constrained_facet_not_local P L
  | cdt_visible_vertex_in_ball => visible_vertex_in_ball P L
  | cdt_dangling_not_delaunay => dangling_not_delaunay P L M
  | mesh_rule simplex_wrong_dimension => no_simplex L
  | mesh_rule complex_overlap => overlap (L ++ M)
  | mesh_rule delaunay_vertex_in_ball => vertex_in_ball (entries (L ++ M) ++ domain_vertices P) L
  | mesh_rule r => broken Delaunay norm2 (entries (L ++ M)) L r
  end.
End Rules.

(** ** What the files are about *)

(** The caller's triangles and edges. *)
Definition dangling_simplices (D : plane_or_space) (c : refutation) (x : dangling_part) :
    list (list (option (point (dimension_of D)))) :=
  caller_rows (refuted_unit c) (sites c) (map fst (dangling x)).

Section Refuted.
Variables (D : plane_or_space) (c : domain_refutation).
Notation r := (refuted_unit (mesh_refuted c)).
Definition vertex_given (k : positive) : option (point (dimension_of D)) :=
  option_map (place_of r) (numbered (vertices_given c) k).
(** The domain has these vertices, and among its segments these. *)
Definition described (P : domain (dimension_of D)) : Prop :=
  (forall v, In v (domain_vertices P) <-> In v (map (place_of r) (vertices_given c))) /\
  forall j k a b, In (j, k) (segments_given c) -> vertex_given j = Some a ->
    vertex_given k = Some b ->
    In (a, b) (domain_segments P).
End Refuted.

(** ** That a domain in space has no triangulation, or no CDT, as it stands in a file

    Which of the two is what the certificate claims to the contrary.  The domain is that of a
    certificate whose points are its vertices, and which has no simplices.  Candidates are all sets
    of four vertices, in lexicographic order. *)

(** The four points are in a plane; a cell with this point is not a union of faces of the candidate;
    it is not constrained Delaunay, for from its point q / w one sees vertex V, in its ball (planes
    <n, p> = o part the way from all cells); or nothing of that. *)
Inductive fate :=
  | Flat | Pierced (x : domain_point)
  | Encroached (v : positive) (q : site) (w : Z) (planes : list (list Z * Z))
  | MayBeChosen.
(** Why a clause holds of every triangulation: one of its simplices contains the point; two
    candidates overlap at the point q / w; or candidate S has a neighbour across its facet I, with
    the point q / w, in no wall: one of these. *)
Inductive reason :=
  | OneCovers (x : domain_point)
  | NotBoth (s u : positive) (q : site) (w : Z)
  | OneBeside (s : positive) (i : nat) (q : site) (w : Z) (l : list positive).
(** Candidate K is chosen, or is not. *)
Definition literal := (bool * positive)%type.
Definition clause := list literal.
(** A clause that follows from others, by their numbers. *)
Record proof_step := ProofStep { derived : clause; hints : list positive }.
(** And a mesh of the same domain, with vertices of its own, in which nothing dangles. *)
Record impossibility := Impossibility {
  about : domain_certificate; some_mesh : domain_certificate;
  fates : list fate; reasons : list reason; steps : list proof_step }.
