(** * Theorems of the book: Chapter 4, for points of R^d with any d

    The notions are those of [Definitions.v], and the following.
    - [frame] ([mesh/Frame.v]): a d-simplex, as its vertices and its barycentric coordinates.
    - [above h t p] ([book/Perturbation.v]): how far the lifted point p is above the witness plane
      of t; [perturbed S h e]: the heights h, point number i of S lowered by e^i;
      [coefficients S h t p]: of the polynomial in e that [above] is for these heights; [lead]: the
      first of them that is not zero, the symbolic sign. *)
From Coq Require Import Rbase Rfunctions List.
From Circumspect Require Import Definitions Domains DomainRules.
From Circumspect Require Perturbation EveryPointSet Halfspaces LiftingMap BookLemma Uniqueness
  Existence Optimality Solid ConstrainedLemma PolygonEdges ConstrainedOptimality.
Import ListNotations.
Open Scope R_scope.

Section Book.
Context {d : nat}.
Implicit Types (S : list (point d)) (T U : list (simplex d)).

(** Lemma 2.1, the Lifting Lemma: the height of a lifted point above the hyperplane of a ball is the
    power of the point with respect to the ball. (So the point is inside, on or outside the sphere
    if and only if its lifted companion is below, on or above the hyperplane.) *)
Theorem lifting_lemma (c : point d) (r2 : R) p :
  norm2 p - plane (scale 2 c) (r2 - norm2 c) p = dist2 c p - r2.
Proof. apply LiftingMap.ball_plane_power. Qed.

(** Lemma 4.1, the Delaunay Lemma: the three statements are equivalent. *)
Theorem delaunay_lemma S T : (1 <= d)%nat -> triangulation S T ->
  ((forall t, In t T -> delaunay S t) <-> (forall f, facet T f -> delaunay S f)) /\
  ((forall t, In t T -> delaunay S t) <-> (forall f, facet T f -> locally_delaunay T f)).
Proof. intros D. now apply BookLemma.lemma_4_1. Qed.

(** Proposition 4.2. *)
Theorem proposition_4_2 S s t : incl s S -> incl t S -> strongly_delaunay S s -> delaunay S t ->
  exists f, incl f s /\ incl f t /\ forall q, (conv s q /\ conv t q) <-> conv f q.
Proof. apply Uniqueness.proposition_4_2. Qed.

(** Proposition 4.3. *)
Theorem proposition_4_3 S T s : delaunay_triangulation S T ->
  incl s S -> s <> [] -> affinely_independent s -> strongly_delaunay S s -> faces_of T s.
Proof. apply Uniqueness.proposition_4_3. Qed.

(** Theorem 4.4: a generic point set has exactly one Delaunay triangulation, which consists of the
    strongly Delaunay simplices. (S spans R^d.) *)
Theorem theorem_4_4 S : spans S -> generic S -> exists T, delaunay_triangulation S T /\
  (forall s, faces_of T s <->
     s <> [] /\ incl s S /\ affinely_independent s /\ strongly_delaunay S s) /\
  forall U, delaunay_triangulation S U -> forall s, faces_of T s <-> faces_of U s.
Proof. apply Existence.theorem_4_4_exactly_one. Qed.

(** Section 2.9, symbolic perturbation: every point set has a Delaunay triangulation, and exactly
    one is canonical. Which one depends on the order of the list S (the oracle's is
    lexicographic). *)
Theorem canonical S : NoDup S -> spans S -> exists T,
  delaunay_triangulation S T /\ canonical_triangulation S norm2 T /\
  forall U, canonical_triangulation S norm2 U -> same_simplices T U.
Proof. apply EveryPointSet.every_point_set. Qed.

(** And no list of points has two, with any heights. *)
Theorem canonical_once S h T U : NoDup S -> spans S -> canonical_triangulation S h T ->
  canonical_triangulation S h U -> same_simplices T U.
Proof. apply EveryPointSet.canonical_once. Qed.

(** The symbolic signs are the numeric signs for all small e, the same e for all. *)
Theorem perturbation_sound S h (ts : list (Frame.frame d)) : exists e0, 0 < e0 /\
  forall e, 0 < e < e0 -> forall t p, In t ts -> In p S ->
    (0 < Perturbation.lead (Perturbation.coefficients S h t p) <->
     0 < Perturbation.above (Perturbation.perturbed S h e) t p) /\
    (Perturbation.lead (Perturbation.coefficients S h t p) < 0 <->
     Perturbation.above (Perturbation.perturbed S h e) t p < 0).
Proof. apply Perturbation.perturbation_sound. Qed.

(** At every point of conv S a triangulation has exactly one interpolation error. *)
Theorem one_interpolation_error h S T p : fills S T -> conv S p ->
  exists! e, interpolation_error h T p e.
Proof. apply Optimality.one_error. Qed.

(** Proposition 4.5: at every point the Delaunay triangulation has the least interpolation error. *)
Theorem proposition_4_5 S T U p e e' : delaunay_triangulation S T -> triangulation S U ->
  interpolation_error norm2 T p e -> interpolation_error norm2 U p e' -> 0 <= e <= e'.
Proof. apply Optimality.proposition_4_5. Qed.

(** Hence it has the least norm of the error, for every norm that is monotonic in the error. For
    example every norm L_q over conv S, q from 1 to infinity. *)
Theorem proposition_4_5_norms S T U (norm : (point d -> R) -> R) (e e' : point d -> R) :
  (forall f g, (forall p, conv S p -> 0 <= f p <= g p) -> norm f <= norm g) ->
  delaunay_triangulation S T -> triangulation S U ->
  (forall p, conv S p -> interpolation_error norm2 T p (e p)) ->
  (forall p, conv S p -> interpolation_error norm2 U p (e' p)) -> norm e <= norm e'.
Proof.
  intros M D Tr E E'. apply M. intros p Hp.
  exact (proposition_4_5 S T U p (e p) (e' p) D Tr (E p Hp) (E' p Hp)).
Qed.

(** The same for any heights, hence for weighted points (the error may be negative). *)
Theorem proposition_4_5_heights h S T U p e e' :
  (forall t, In t T -> witness_plane h S t) -> fills S U ->
  interpolation_error h T p e -> interpolation_error h U p e' -> e <= e'.
Proof. apply Optimality.proposition_4_5_heights. Qed.

(** Every d-simplex of a triangulation has exactly one min-containment ball. *)
Theorem one_min_containment_ball S T t : fills S T -> In t T ->
  exists c r2, min_containment_ball t c r2 /\
    forall c' r2', min_containment_ball t c' r2' -> c' = c /\ r2' = r2.
Proof. apply Optimality.one_min_containment_ball. Qed.

(** Proposition 4.6: the centre q of the min-containment ball is the point of the simplex nearest to
    the circumcentre o. *)
Theorem proposition_4_6 (s : simplex d) (o : point d) (r2 : R) q : circumball s o r2 -> conv s q ->
  (forall x, conv s x -> dist2 o q <= dist2 o x) ->
  min_containment_ball s q (r2 - dist2 o q).
Proof. apply Optimality.proposition_4_6. Qed.

(** Proposition 4.7: no triangulation has a smaller largest min-containment ball: for every Delaunay
    simplex t it has a simplex u that no ball smaller than that of t contains. *)
Theorem proposition_4_7 S T U : delaunay_triangulation S T -> fills S U ->
  forall t c r2, In t T -> min_containment_ball t c r2 ->
    exists u, In u U /\ forall c' r2', contains c' r2' u -> r2 <= r2'.
Proof. apply Optimality.proposition_4_7. Qed.

(** Section 4.5.3: *A three-dimensional PLC is edge-protected if every edge in it is strongly
    Delaunay.* Theorem 4.9, the CDT Theorem: *every edge-protected PLC has a CDT.*  This is what it
    says here.  It is not proved, and nothing rests on it; README.md, "Theorem 4.9", says which
    lemma is missing. *)
Definition edge_protected (P : domain 3) : Prop :=
  forall p q, In (p, q) (domain_segments P) -> strongly_delaunay (domain_vertices P) [p; q].
Definition theorem_4_9 : Prop := forall P : domain 3, proper_domain P ->
  what_it_fills P = Enclosed ->
  piecewise_linear_complex P -> edge_protected P -> exists K, cdt P K.

(** Lemma 4.10, the Constrained Delaunay Lemma, of what walls enclose: the three statements are
    equivalent.  The vertices [V] are those of the mesh; of a triangulation without Steiner points
    they are those of the domain.  ([solid]: nothing dangles.  The domain need not be a piecewise
    linear complex.) *)
Theorem constrained_delaunay_lemma P (T : list (simplex d)) V : (2 <= d)%nat -> proper_domain P ->
  what_it_fills P = Enclosed ->
  steiner_triangulation P T -> solid T -> (forall v, In v V <-> exists t, In t T /\ In v t) ->
  ((forall t, In t T -> constrained_delaunay V P t) <->
   (forall f, facet T f -> in_no_wall P f -> constrained_delaunay V P f)) /\
  ((forall t, In t T -> constrained_delaunay V P t) <->
   (forall f, facet T f -> in_no_wall P f -> locally_delaunay T f)).
Proof.
  intros D Pr K Steiner So Ve. pose proof (proj2 (Solid.solid_steiner P T) (conj Steiner So)) as St.
  pose proof (ConstrainedLemma.constrained_local D P T V Pr St Ve) as A.
  pose proof (ConstrainedLemma.local_constrained D P T V Pr St Ve K) as B.
  pose proof (ConstrainedLemma.local_facets D P T V Pr St Ve K) as C.
  pose proof (ConstrainedLemma.facets_local D P T V Pr St Ve) as E. split; split; auto.
Qed.

(** Proposition 4.11, at an edge: let two triangles [a; b; v1] and [a; b; v2] of a CDT of a
    piecewise linear complex be in one of its polygons, and their common edge in no segment.  Then
    an open circumball of the first does not contain v2, so none does: in the plane of the triangle
    all have the same part.  (That this local property makes the triangles in a polygon constrained
    Delaunay in its plane is Lemma 4.10 there, and is not stated.) *)
Theorem proposition_4_11_at_edges (P : domain 3) (T : list (simplex 3)) V f a b v1 v2 :
  proper_domain P -> piecewise_linear_complex P ->
  steiner_triangulation P T -> solid T -> (forall v, In v V <-> exists t, In t T /\ In v t) ->
  (forall t, In t T -> constrained_delaunay V P t) -> In f (domain_polygons P) ->
  (forall p q, In (p, q) (domain_segments P) -> ~ within (conv [a; b]) (conv [p; q])) ->
  faces_of T [a; b; v1] -> within (conv [a; b; v1]) (polygon_points f) ->
  faces_of T [a; b; v2] -> within (conv [a; b; v2]) (polygon_points f) ->
  exists c r2, circumball [a; b; v1] c r2 /\ ~ dist2 c v2 < r2.
Proof.
  intros Pr Plc St So. apply PolygonEdges.polygon_edge_local; try assumption.
  now apply Solid.solid_steiner.
Qed.

(** Proposition 4.12: a generic domain has at most one constrained Delaunay triangulation, of those
    in which nothing dangles. *)
Theorem proposition_4_12 P (T U : list (simplex d)) : (2 <= d)%nat -> proper_domain P ->
  generic (domain_vertices P) ->
  cdt P T -> solid T -> cdt P U -> solid U -> same_simplices T U.
Proof.
  intros D Pr G CT ST CU SU. apply (ConstrainedOptimality.proposition_4_12 D P Pr T U G);
    now apply Solid.solid_cdts.
Qed.

(** Proposition 4.13, of the criteria of Propositions 4.5 and 4.7: among all triangulations of the
    domain in which nothing dangles, a CDT has at every point the least interpolation error, *)
Theorem proposition_4_13 P (T U : list (simplex d)) p e e' : (2 <= d)%nat -> proper_domain P ->
  cdt P T -> solid T -> plc_triangulation P U -> solid U ->
  interpolation_error norm2 T p e -> interpolation_error norm2 U p e' -> e <= e'.
Proof.
  intros D Pr CT ST PU SU. apply (ConstrainedOptimality.proposition_4_13_error D P Pr);
    [now apply Solid.solid_cdts|now apply Solid.solid_plc].
Qed.
(** and for each of its simplices every triangulation has one with a min-containment ball that is no
    smaller. *)
Theorem proposition_4_13_balls P (T U : list (simplex d)) t c r2 : (2 <= d)%nat ->
  proper_domain P ->
  cdt P T -> solid T -> plc_triangulation P U -> solid U -> In t T -> min_containment_ball t c r2 ->
  exists u, In u U /\ forall c' r2', contains c' r2' u -> r2 <= r2'.
Proof.
  intros D Pr CT ST PU SU. apply (ConstrainedOptimality.proposition_4_13_balls D P Pr);
    [now apply Solid.solid_cdts|now apply Solid.solid_plc].
Qed.

(** The convex hull by convex combinations is the convex hull by half-spaces. *)
Theorem conv_halfspaces S T : (1 <= d)%nat -> fills S T -> T <> [] -> forall q, conv S q <->
  (forall a b, (forall p, In p S -> 0 <= plane a b p) -> 0 <= plane a b q).
Proof. apply Halfspaces.conv_halfspaces. Qed.
End Book.
