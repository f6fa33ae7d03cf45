(** * Definitions: everything that the main theorems speak of

    [MainTheorems.v] says, in these words, what a line of [circumspect-verified] means; that file's
    theorems about completeness use [completeness/Honest.v] as well.  Nothing here is proved, and
    nothing here computes a verdict.  First what the two kinds of files say, as records; then the
    book's words (Cheng, Dey and Shewchuk, "Delaunay Mesh Generation"; the numbers are those of its
    definitions and sections), for points of R^d with any d; then what the files are about. *)
From Coq Require Import String Rbase Rfunctions List ZArith.
From Coq Require Vector.
Import ListNotations.
Open Scope R_scope.

(** ** Certificates and refutations, as they stand in a file

    [CERTIFICATE.md] describes the files.  Points, simplices and hull facets are numbered from 1 in
    the order of their lists; vertices, facets and ridges from 0. *)

Inductive claim := Triangulation | Delaunay | WeightedDelaunay.
(** D of the first line: the dimension of space and of the points. *)
Inductive plane_or_space := Plane | Space.

(** A point with integer coordinates and an integer weight. *)
Record site := Site { coordinates : list Z; weight : Z }.

(** A point ([weight] is read only if the claim is [WeightedDelaunay]); T; I, or [None] for -. *)
Record point_entry := PointEntry {
  position : site; home : positive; home_vertex : option nat }.
(** Fi: [Neighbour T J], or [OnHull H]. *)
Inductive wall := Neighbour (t : positive) (j : nat) | OnHull (h : positive).
(** The numbers of the vertices; the Fi; S. *)
Record simplex_entry := SimplexEntry {
  corners : list positive; walls : list wall; away : option nat }.
(** T; I; the Ra, each [(G, B)]. *)
Record hull_entry := HullEntry {
  carrier : positive; apex : nat; ridges : list (positive * nat) }.
Record certificate := Certificate {
  claimed : claim;
  numerator : Z; denominator : Z;                              (* scale P Q *)
  points : list point_entry;
  simplices : list simplex_entry;
  hull : list hull_entry;
  sample_simplex : positive; sample : site; sample_denominator : Z   (* the weight is not read *)
}.

(** For example the triangle with the vertices (0, 0), (1, 0) and (0, 1/2), as text and as a record:
<<
      circumspect-certificate 1 delaunay 2
      scale 1 2
      points 3
      0 0  1 0  7
      0 1  1 2  9
      2 0  1 1  8
      simplices 1
      1 3 2  - 1 - 2 - 3  -
      hull 3
      1 0  2 0 3 0
      1 1  1 0 3 1
      1 2  1 1 2 1
      sample 1 2 1 3
      end
>>
    The last token of a point is the index that its user knows it by, which is not part of the
    record. [MainTheorems.v] begins with what the acceptance of this certificate says. *)
Definition worked_triangle : certificate := Certificate Delaunay 1 2
  [PointEntry (Site [0; 0]%Z 0) 1 (Some 0%nat);
   PointEntry (Site [0; 1]%Z 0) 1 (Some 2%nat);
   PointEntry (Site [2; 0]%Z 0) 1 (Some 1%nat)]
  [SimplexEntry [1; 3; 2]%positive [OnHull 1; OnHull 2; OnHull 3] None]
  [HullEntry 1 0 [(2, 0%nat); (3, 0%nat)]%positive;
   HullEntry 1 1 [(1, 0%nat); (3, 1%nat)]%positive;
   HullEntry 1 2 [(1, 1%nat); (2, 1%nat)]%positive]
  1 (Site [2; 1]%Z 0) 3.

(** A refutation is the mesh as its author wrote it down, d+1 of its points that are affinely
    independent, and one line of evidence: where to look. *)

(** The entries of a simplex; an integer that is not positive is [None], and names no point, as
    does a number beyond the points. *)
Definition row := list (option positive).

Inductive evidence :=
  | WrongDimension (t : positive)
  | UnknownVertex (t : positive) (i : nat)
  | RepeatedVertex (t : positive) (i j : nat)
  | Degenerate (t : positive)
  | DuplicateSimplex (t u : positive)
  | FacetOverused (t : positive) (i : nat) (u : positive) (j : nat) (v : positive) (k : nat)
  (* the point q / w; the weight of q is not read *)
  | Overlap (t u : positive) (q : site) (w : Z)
  | CoveredTwice (t u : positive) (q : site) (w : Z)
  | UnusedPoint (p : positive)
  (* the point is beyond one facet of each simplex *)
  | UncoveredPoint (p : positive) (facets : list nat)
  | HullNotConvex (t : positive) (i : nat) (p : positive)
  | HullNotClosed (t : positive) (i : nat) (u : positive) (j : nat) (v : positive) (k : nat)
  | VertexInBall (t p : positive)
  | FacetNotLocal (t : positive) (i : nat) (u : positive) (j : nat)
  | PointBelowPlane (t p : positive)
  | VertexSubmerged (t : positive) (i : nat) (X : list positive).

Record refutation := Refutation {
  refuted : claim;
  unit_numerator : Z; unit_denominator : Z;                    (* scale P Q *)
  sites : list site;               (* the weight is read only if the claim is [WeightedDelaunay] *)
  rows : list row;
  basis : list positive;                                       (* spans p0 .. pD *)
  because : evidence
}.

(** The rules, by the names that are printed. *)
Inductive rule :=
  | simplex_wrong_dimension | triangulation_unknown_vertex | simplex_repeated_vertex
  | simplex_degenerate | complex_duplicate_simplex | complex_facet_overused | complex_overlap
  | triangulation_covered_twice | triangulation_unused_point | triangulation_hull_not_convex
  | triangulation_hull_not_closed | delaunay_vertex_in_ball | delaunay_facet_not_local
  | weighted_point_below_plane | weighted_vertex_submerged.
Definition rule_of (e : evidence) : rule :=
  match e with
  | WrongDimension _ => simplex_wrong_dimension
  | UnknownVertex _ _ => triangulation_unknown_vertex
  | RepeatedVertex _ _ _ => simplex_repeated_vertex
  | Degenerate _ => simplex_degenerate
  | DuplicateSimplex _ _ => complex_duplicate_simplex
  | FacetOverused _ _ _ _ _ _ => complex_facet_overused
  | Overlap _ _ _ _ => complex_overlap
  | CoveredTwice _ _ _ _ => triangulation_covered_twice
  | UnusedPoint _ | UncoveredPoint _ _ => triangulation_unused_point
  | HullNotConvex _ _ _ => triangulation_hull_not_convex
  | HullNotClosed _ _ _ _ _ _ => triangulation_hull_not_closed
  | VertexInBall _ _ => delaunay_vertex_in_ball
  | FacetNotLocal _ _ _ _ => delaunay_facet_not_local
  | PointBelowPlane _ _ => weighted_point_below_plane
  | VertexSubmerged _ _ _ => weighted_vertex_submerged
  end.
Definition rule_name (r : rule) : string :=
  match r with
  | simplex_wrong_dimension => "simplex.wrong-dimension"
  | triangulation_unknown_vertex => "triangulation.unknown-vertex"
  | simplex_repeated_vertex => "simplex.repeated-vertex"
  | simplex_degenerate => "simplex.degenerate"
  | complex_duplicate_simplex => "complex.duplicate-simplex"
  | complex_facet_overused => "complex.facet-overused"
  | complex_overlap => "complex.overlap"
  | triangulation_covered_twice => "triangulation.covered-twice"
  | triangulation_unused_point => "triangulation.unused-point"
  | triangulation_hull_not_convex => "triangulation.hull-not-convex"
  | triangulation_hull_not_closed => "triangulation.hull-not-closed"
  | delaunay_vertex_in_ball => "delaunay.vertex-in-ball"
  | delaunay_facet_not_local => "delaunay.facet-not-local"
  | weighted_point_below_plane => "weighted.point-below-plane"
  | weighted_vertex_submerged => "weighted.vertex-submerged"
  end%string.
Definition claim_name (c : claim) : string :=
  match c with
  | Triangulation => "triangulation"
  | Delaunay => "delaunay"
  | WeightedDelaunay => "weighted-delaunay"
  end%string.

(** ** Points *)

(** A point of R^d: its d coordinates. *)
Definition point (d : nat) := Vector.t R d.

Section Book.
Context {d : nat}.

Definition origin : point d := Vector.const 0 d.
Definition plus (p q : point d) : point d := Vector.map2 Rplus p q.
Definition scale (a : R) (p : point d) : point d := Vector.map (Rmult a) p.
Definition minus (p q : point d) : point d := plus p (scale (-1) q).
Definition inner (p q : point d) : R := Vector.fold_right2 (fun x y s => x * y + s) 0 d p q.

(** The squares of the norm and of the distance. *)
Definition norm2 (p : point d) : R := inner p p.
Definition dist2 (p q : point d) : R := norm2 (minus p q).

(** ** Convexity *)

(** The sum of the coefficients of [l], and the point that [l] combines. *)
Definition total (l : list (R * point d)) : R := fold_right (fun ap s => fst ap + s) 0 l.
Definition combination (l : list (R * point d)) : point d :=
  fold_right (fun ap s => plus (scale (fst ap) (snd ap)) s) origin l.

(** [conv X q]: the point [q] is in the convex hull of the points of [X].  (Section 1.3) *)
Definition conv (X : list (point d)) (q : point d) : Prop :=
  exists l, (forall a p, In (a, p) l -> 0 <= a /\ In p X) /\ total l = 1 /\ combination l = q.

(** No point of [X] is an affine combination of the others.  (Section 1.3) *)
Definition affinely_independent (X : list (point d)) : Prop :=
  forall a : list R, length a = length X ->
    total (combine a X) = 0 -> combination (combine a X) = origin -> forall c, In c a -> c = 0.

(** ** Simplices and complexes *)

(** A simplex is known by its vertices, listed in any order; the simplex itself is their convex
    hull.  Two lists with the same members are the same simplex. *)
Definition simplex := list (point d).
Definition same (s t : simplex) : Prop := incl s t /\ incl t s.

(** Definition 1.5: a simplicial complex is a set of simplices that contains every face of each
    of its simplices, and in which two simplices meet in a shared face or not at all.  ([f] may be
    empty, and then so is its convex hull.  The book's set is finite; all that follows is about the
    faces of a list, which are finitely many.) *)
Definition simplicial_complex (K : simplex -> Prop) : Prop :=
  (forall s, K s -> affinely_independent s) /\
  (forall s f, K s -> incl f s -> NoDup f -> f <> [] -> K f) /\
  (forall s t, K s -> K t ->
     exists f, incl f s /\ incl f t /\ forall q, conv s q -> conv t q -> conv f q).

(** The simplices of a list and all their faces. *)
Definition faces_of (T : list simplex) (s : simplex) : Prop :=
  NoDup s /\ s <> [] /\ exists t, In t T /\ incl s t.

(** ** Triangulations of a point set *)

(** [S] spans R^d: d+1 of its points are affinely independent.  Where the book speaks of a
    k-dimensional point set in R^d, k is d here: for points of a hyperplane it has triangulations
    of lower dimension, which are not spoken of. *)
Definition spans (S : list (point d)) : Prop :=
  exists X, incl X S /\ length X = Datatypes.S d /\ affinely_independent X.

(** The simplices of [T], each listed by its d+1 different vertices and none listed twice, are the
    d-simplices of a complex and fill conv S; all their vertices are in [S]. *)
Definition fills (S : list (point d)) (T : list simplex) : Prop :=
  (forall t, In t T -> NoDup t /\ length t = Datatypes.S d) /\
  simplicial_complex (faces_of T) /\
  ForallOrdPairs (fun s t => ~ same s t) T /\
  (forall t, In t T -> incl t S) /\
  (forall q, conv S q <-> exists t, In t T /\ conv t q).

(** Definition 2.1: a triangulation of S is a simplicial complex whose vertices are exactly the
    points of S and whose union is conv S.  ([T] lists the d-simplices.  S is meant to span R^d:
    if it does not, and is not empty, then it has no triangulation in this sense.) *)
Definition triangulation (S : list (point d)) (T : list simplex) : Prop :=
  fills S T /\ (forall p, In p S -> exists t, In t T /\ In p t).

(** ** Delaunay *)

(** The ball with centre [c] and squared radius [r2] is a circumball of [s]: its boundary passes
    through the vertices of [s].  (Definition 1.18) *)
Definition circumball (s : simplex) (c : point d) (r2 : R) : Prop :=
  forall v, In v s -> dist2 c v = r2.

(** Section 4.2: a simplex is Delaunay if some open circumball of it contains no point of S.  (Its
    vertices are meant to be points of S, which these definitions do not say; the theorems do.) *)
Definition delaunay (S : list (point d)) (s : simplex) : Prop :=
  exists c r2, circumball s c r2 /\ forall p, In p S -> ~ dist2 c p < r2.

(** Section 4.2: strongly Delaunay, if some closed one has none but the vertices of [s]. *)
Definition strongly_delaunay (S : list (point d)) (s : simplex) : Prop :=
  exists c r2, circumball s c r2 /\ forall p, In p S -> dist2 c p <= r2 -> In p s.

(** Definition 4.1. *)
Definition delaunay_triangulation (S : list (point d)) (T : list simplex) : Prop :=
  triangulation S T /\ forall t, In t T -> delaunay S t.

(** Definition 4.2, for a point set that spans R^d (the book's k is d): no d+2 points of S lie on
    the boundary of a single ball. *)
Definition generic (S : list (point d)) : Prop :=
  forall X, NoDup X -> incl X S -> length X = Datatypes.S (Datatypes.S d) ->
    ~ exists c r2, circumball X c r2.

(** Section 4.2: a facet is a (d-1)-simplex of the triangulation. *)
Definition facet (T : list simplex) (f : simplex) : Prop :=
  NoDup f /\ length f = d /\ exists t, In t T /\ incl f t.

(** Section 4.2: a facet is locally Delaunay if it is a face of fewer than two d-simplices, or it
    has an open circumball that contains no vertex of the two.  (In a triangulation no three
    d-simplices share a facet; of others this definition asks it of every two.) *)
Definition locally_delaunay (T : list simplex) (f : simplex) : Prop :=
  forall s t, In s T -> In t T -> incl f s -> incl f t -> ~ same s t ->
    exists c r2, circumball f c r2 /\ forall v, In v s \/ In v t -> ~ dist2 c v < r2.

(** ** Heights: weighted points and perturbed points *)

(** Section 2.8: a hyperplane that is not vertical is the graph of p |-> <a, p> + b. *)
Definition plane (a : point d) (b : R) (p : point d) : R := inner a p + b.

(** Section 2.8: lift each point p to the height [h p].  A hyperplane is a witness plane of a
    simplex if it contains the lifted vertices of the simplex and no lifted point of S is strictly
    below it.  A simplex that has one is weighted Delaunay for h(p) = |p|^2 - w(p). *)
Definition witness_plane (h : point d -> R) (S : list (point d)) (s : simplex) : Prop :=
  exists a b, (forall v, In v s -> plane a b v = h v) /\ (forall p, In p S -> plane a b p <= h p).

Definition weighted_delaunay (w : point d -> R) (S : list (point d)) (s : simplex) : Prop :=
  witness_plane (fun p => norm2 p - w p) S s.

(** Section 2.8: a weighted Delaunay triangulation fills conv S; a point of S that is not a vertex
    is submerged: its lifted companion is on or above every witness plane. *)
Definition weighted_delaunay_triangulation (w : point d -> R) (S : list (point d))
    (T : list simplex) : Prop :=
  fills S T /\ forall t, In t T -> weighted_delaunay w S t.

(** Two lists of simplices with the same members. *)
Definition same_simplices (T U : list simplex) : Prop :=
  (forall s, In s T -> exists r, In r U /\ same s r) /\
  (forall s, In s U -> exists r, In r T /\ same s r).

(** Section 2.9, symbolic perturbation: lower the height of point number i of [S], counted from 1,
    by e^i.  T is canonical if it has witness planes over all such heights with a small e > 0. *)
Definition lowered (S : list (point d)) (h : point d -> R) (e : R) (k : point d -> R) : Prop :=
  forall i p, nth_error S i = Some p -> k p = h p - e ^ Datatypes.S i.
Definition canonical_triangulation (S : list (point d)) (h : point d -> R) (T : list simplex) :
  Prop :=
  fills S T /\ exists e0, 0 < e0 /\ forall e k, 0 < e < e0 -> lowered S h e k ->
    forall t, In t T -> witness_plane k S t.

(** ** Optimality *)

(** The hyperplane (a, b) contains the lifted vertices of s: over s it is the interpolant of h. *)
Definition interpolates (h : point d -> R) (s : simplex) (a : point d) (b : R) : Prop :=
  forall v, In v s -> plane a b v = h v.

(** Section 4.3: [e] is the error at p of the piecewise linear function that interpolates h at the
    vertices of T.  (With h(p) = |p|^2 it is the book's e(p) = T^+(p) - |p|^2.) *)
Definition interpolation_error (h : point d -> R) (T : list simplex) (p : point d) (e : R) : Prop :=
  exists t a b, In t T /\ conv t p /\ interpolates h t a b /\ e = plane a b p - h p.

(** The closed ball with centre [c] and squared radius [r2] contains s. *)
Definition contains (c : point d) (r2 : R) (s : simplex) : Prop :=
  forall v, In v s -> dist2 c v <= r2.

(** Definition 1.20: the smallest closed ball that contains s. *)
Definition min_containment_ball (s : simplex) (c : point d) (r2 : R) : Prop :=
  contains c r2 s /\ forall c' r2', contains c' r2' s -> r2 <= r2' /\ (r2 = r2' -> c' = c).

(** ** Rules that a mesh may break

    [L] lists the simplices as their author wrote them down: a vertex that names no point is [None].
    A breach says that some simplices and points break the rule, not which; whoever has [S] and [L]
    can look.  Points are their coordinates: a point that is listed twice is one point. *)

Implicit Types (S : list (point d)) (L : list (list (option (point d)))) (s t u f : simplex).

(** What is claimed: all vertices are known, and the simplices are a triangulation. *)
Definition claims_triangulation S L : Prop :=
  exists T, L = map (map Some) T /\ triangulation S T.
Definition claims_delaunay S L : Prop :=
  exists T, L = map (map Some) T /\ delaunay_triangulation S T.
Definition claims_weighted_delaunay w S L : Prop :=
  exists T, L = map (map Some) T /\ weighted_delaunay_triangulation w S T.

Definition listed L s : Prop := In (map Some s) L.
(** [s] is listed, and it is a d-simplex. *)
Definition listed_simplex L s : Prop :=
  listed L s /\ length s = Datatypes.S d /\ affinely_independent s.
(** The point is in the simplex and in no proper face of it: in its interior. *)
Definition strictly_inside s (q : point d) : Prop :=
  conv s q /\ forall f, incl f s -> conv f q -> incl s f.
(** A hyperplane contains [f] and has [p] and [q] strictly on different sides. *)
Definition on_opposite_sides f (p q : point d) : Prop := exists a b,
  (forall v, In v f -> plane a b v = 0) /\ 0 < plane a b p /\ plane a b q < 0.
(** [f] is a facet of the simplex [s] and of no other: a facet of the boundary. *)
Definition boundary_facet L s f : Prop := listed_simplex L s /\
  NoDup f /\ length f = d /\ incl f s /\ forall t, listed L t -> incl f t -> same s t.

Definition wrong_dimension L : Prop :=
  exists r : list (option (point d)), In r L /\ length r <> Datatypes.S d.
Definition unknown_vertex L : Prop :=
  exists r : list (option (point d)), In r L /\ In None r.
Definition repeated_vertex L : Prop := exists (r : list (option (point d))) i j p, In r L /\
  i <> j /\ nth_error r i = Some (Some p) /\ nth_error r j = Some (Some p).
Definition degenerate L : Prop := exists s, listed L s /\ ~ affinely_independent s.
Definition duplicate_simplex L : Prop := exists L1 L2 L3 s t,
  L = (L1 ++ map Some s :: L2 ++ map Some t :: L3)%list /\
  length s = Datatypes.S d /\ length t = Datatypes.S d /\ same s t.
(** A facet of three different simplices. *)
Definition facet_overused L : Prop := exists s t u f,
  listed L s /\ listed L t /\ listed L u /\ ~ same s t /\ ~ same t u /\ ~ same s u /\
  NoDup f /\ length f = d /\ incl f s /\ incl f t /\ incl f u.
(** Two simplices meet in more than a common face: in a point that is in no shared face. *)
Definition overlap L : Prop := exists s t q, listed L s /\ listed L t /\ conv s q /\ conv t q /\
  forall f, incl f s -> incl f t -> ~ conv f q.
(** A point of the interior of one simplex is in another as well. *)
Definition covered_twice L : Prop := exists s t q,
  listed_simplex L s /\ listed_simplex L t /\ ~ same s t /\ strictly_inside s q /\ conv t q.
Definition unused_point S L : Prop := exists p, In p S /\
  forall r : list (option (point d)), In r L -> ~ In (Some p) r.
(** With weights a point need not be a vertex, but it has to be covered. *)
Definition uncovered_point S L : Prop := exists p, In p S /\
  (forall r : list (option (point d)), In r L -> ~ In (Some p) r) /\
  forall s, listed L s -> ~ conv s p.
(** A point lies beyond a facet of the boundary. *)
Definition hull_not_convex S L : Prop := exists s f v p, boundary_facet L s f /\
  In v s /\ In p S /\ on_opposite_sides f v p.
(** A ridge is shared by three facets of the boundary, or more. *)
Definition hull_not_closed L : Prop := exists r s t u f f' f'',
  boundary_facet L s f /\ boundary_facet L t f' /\ boundary_facet L u f'' /\
  ~ same f f' /\ ~ same f' f'' /\ ~ same f f'' /\
  NoDup r /\ Datatypes.S (length r) = d /\ incl r f /\ incl r f' /\ incl r f''.
(** A point in every open circumball of a simplex.  (Here and in what follows the first simplex is
    a d-simplex: it has exactly one ball or plane.) *)
Definition vertex_in_ball S L : Prop := exists s p, listed_simplex L s /\ In p S /\
  forall c r2, circumball s c r2 -> dist2 c p < r2.
(** Two simplices share a facet, and the apex of the second, on the other side of it, is in every
    open circumball of the first. *)
Definition facet_not_local L : Prop := exists s t f p v, listed_simplex L s /\ listed L t /\
  NoDup f /\ length f = d /\ incl f s /\ incl f t /\ In p s /\ In v t /\
  on_opposite_sides f p v /\ forall c r2, circumball s c r2 -> dist2 c v < r2.
(** The same with heights: the lifted apex is below every hyperplane through the lifted vertices. *)
Definition facet_below_plane (h : point d -> R) L : Prop := exists s t f p v,
  listed_simplex L s /\ listed L t /\ NoDup f /\ length f = d /\ incl f s /\ incl f t /\
  In p s /\ In v t /\ on_opposite_sides f p v /\
  forall a b, (forall q, In q s -> plane a b q = h q) -> h v < plane a b v.
(** A lifted point is below the witness plane of a simplex. *)
Definition point_below_plane (h : point d -> R) S L : Prop := exists s p,
  listed_simplex L s /\ In p S /\
  forall a b, (forall v, In v s -> plane a b v = h v) -> h p < plane a b p.
(** A lifted vertex is strictly above a lifted simplex of points. *)
Definition vertex_submerged (h : point d -> R) S L : Prop := exists s v X, listed L s /\ In v s /\
  incl X S /\ conv X v /\ forall a b, (forall p, In p X -> plane a b p <= h p) -> plane a b v < h v.

(** The rule is broken; with weights, which [h] knows, two rules read as they say above. *)
Definition broken (c : claim) (h : point d -> R) S L (r : rule) : Prop :=
  match r with
  | simplex_wrong_dimension => wrong_dimension L
  | triangulation_unknown_vertex => unknown_vertex L
  | simplex_repeated_vertex => repeated_vertex L
  | simplex_degenerate => degenerate L
  | complex_duplicate_simplex => duplicate_simplex L
  | complex_facet_overused => facet_overused L
  | complex_overlap => overlap L
  | triangulation_covered_twice => covered_twice L
  | triangulation_unused_point =>
      match c with WeightedDelaunay => uncovered_point S L | _ => unused_point S L end
  | triangulation_hull_not_convex => hull_not_convex S L
  | triangulation_hull_not_closed => hull_not_closed L
  | delaunay_vertex_in_ball => vertex_in_ball S L
  | delaunay_facet_not_local =>
      match c with WeightedDelaunay => facet_below_plane h L | _ => facet_not_local L end
  | weighted_point_below_plane => point_below_plane h S L
  | weighted_vertex_submerged => vertex_submerged h S L
  end.
(** The heights: |p|^2, less the weight if the claim has weights. *)
Definition lifted (c : claim) (w : point d -> R) : point d -> R :=
  match c with WeightedDelaunay => fun p => norm2 p - w p | _ => norm2 end.
End Book.
Arguments simplex d : clear implicits.

(** ** What the files are about, in the caller's coordinates *)

Definition dimension_of (D : plane_or_space) : nat := match D with Plane => 2 | Space => 3 end.

(** The first d of the integers, as a point; and [r] times the point. *)
Fixpoint integer_point (d : nat) (l : list Z) : point d :=
  match d with
  | O => Vector.nil R
  | S d' => Vector.cons R (IZR (hd 0%Z l)) d' (integer_point d' (tl l))
  end.
Definition place_of {d : nat} (r : R) (s : site) : point d :=
  scale r (integer_point d (coordinates s)).
(** The member of [l] with number [k], counted from 1. *)
Definition numbered {A} (l : list A) (k : positive) : option A :=
  nth_error l (pred (Pos.to_nat k)).

Section Certificate.
Variables (d : nat) (c : certificate).

(** P/Q: the points are the integer points times P/Q, the weights those times (P/Q)^2. *)
Definition unit_of : R := IZR (numerator c) / IZR (denominator c).
Definition points_of_certificate : list (point d) :=
  map (fun e => place_of unit_of (position e)) (points c).
(** The point with number [k].  (A number that names no point would mean the origin; accepted
    certificates have none.) *)
Definition spot (k : positive) : point d :=
  nth (pred (Pos.to_nat k)) points_of_certificate origin.
Definition simplices_of_certificate : list (simplex d) :=
  map (fun e => map spot (corners e)) (simplices c).
(** The function [w] gives the points the weights of the certificate. *)
Definition weights_given (w : point d -> R) : Prop := forall e, In e (points c) ->
  w (place_of unit_of (position e)) = unit_of ^ 2 * IZR (weight (position e)).
End Certificate.

Section Caller.
Context {d : nat}.
Variables (r : R) (P : list site) (l : list row).

(** Equal points are one point, and whoever lists one of them lists the other.  (A list of points
    that has one twice is the input's fault, not the mesh's.  If equal points had different weights,
    no function would give the weights, and nothing would be claimed that could be true.) *)
Definition caller_points : list (point d) := map (place_of r) P.
Definition caller_entry (n : option positive) : option (point d) :=
  match n with Some k => option_map (place_of r) (numbered P k) | None => None end.
Definition caller_rows : list (list (option (point d))) := map (map caller_entry) l.
End Caller.

Section Refuted.
Variables (D : plane_or_space) (c : refutation).

(** P/Q, and the caller's points, simplices and weights, as for certificates. *)
Definition refuted_unit : R := IZR (unit_numerator c) / IZR (unit_denominator c).
Definition refuted_points : list (point (dimension_of D)) := caller_points refuted_unit (sites c).
Definition refuted_simplices : list (list (option (point (dimension_of D)))) :=
  caller_rows refuted_unit (sites c) (rows c).
Definition refuted_weights (w : point (dimension_of D) -> R) : Prop :=
  forall p, In p (sites c) -> w (place_of refuted_unit p) = refuted_unit ^ 2 * IZR (weight p).

(** What the refutation says is not so. *)
Definition refuted_claim : Prop :=
  match refuted c with
  | Triangulation => claims_triangulation refuted_points refuted_simplices
  | Delaunay => claims_delaunay refuted_points refuted_simplices
  | WeightedDelaunay => exists w, refuted_weights w /\
      claims_weighted_delaunay w refuted_points refuted_simplices
  end.
End Refuted.
