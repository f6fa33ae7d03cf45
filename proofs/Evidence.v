(** * What a refutation says

    Every kind of evidence names a breach in the words of [Breach.v]: a breach of the caller's own
    points and simplices, which are defined here; and each breach refutes the claims that
    CERTIFICATE.md says it refutes ([breach_refutes]). *)
From Coq Require Import Reals List ZArith.
From Circumspect Require Import Refutation Numbering.
From Circumspect Require Import Definitions Breach Meaning.
Import ListNotations.
Open Scope R_scope.

Section Breaches.
Context {d : nat}.

(** [h] gives the heights of the points.  The numbers in the evidence say where the checker looked;
    they are not part of the breach, which says that there is such a place. *)
Definition breach (c : claim) (h : point d -> R) (S : list (point d))
    (L : list (list (option (point d)))) (e : evidence) : Prop :=
  match e with
  | WrongDimension _ => wrong_dimension L
  | UnknownVertex _ _ => unknown_vertex L
  | RepeatedVertex _ _ _ => repeated_vertex L
  | Degenerate _ => degenerate L
  | DuplicateSimplex _ _ => duplicate_simplex L
  | FacetOverused _ _ _ _ _ _ => facet_overused L
  | Overlap _ _ _ _ => overlap L
  | UnusedPoint _ => unused_point S L
  | Uncovered _ _ _ _ => uncovered S L
  | VertexInBall _ _ => vertex_in_ball S L
  | FacetNotLocal _ _ _ _ => match c with
                             | WeightedDelaunay => facet_below_plane h L
                             | _ => facet_not_local L
                             end
  | PointBelowPlane _ _ => point_below_plane h S L
  | VertexSubmerged _ _ _ => vertex_submerged h S L
  end.

Definition claims (c : claim) (w : point d -> R) (S : list (point d))
    (L : list (list (option (point d)))) : Prop :=
  match c with
  | Triangulation => claims_triangulation S L
  | Delaunay => claims_delaunay S L
  | WeightedDelaunay => claims_weighted_delaunay w S L
  end.
Lemma claims_fill c w S L : claims c w S L -> claims_to_fill S L.
Proof.
  destruct c; cbn; intros H.
  - now apply claims_triangulation_fill.
  - now apply claims_triangulation_fill, claims_delaunay_triangulation.
  - now apply claims_weighted_delaunay_fill in H.
Qed.

(** The heights: |p|^2, less the weight if the claim has weights. *)
Definition lifted (c : claim) (w : point d -> R) : point d -> R :=
  match c with WeightedDelaunay => fun p => norm2 p - w p | _ => norm2 end.

Theorem breach_refutes c w S L e : concerns e c = true ->
  breach c (lifted c w) S L e -> ~ claims c w S L.
Proof.
  intros C B H. assert (F := claims_fill c w S L H). destruct e; cbn in B.
  - now apply (wrong_dimension_refutes S L).
  - now apply (unknown_vertex_refutes S L).
  - now apply (repeated_vertex_refutes S L).
  - now apply (degenerate_refutes S L).
  - now apply (duplicate_simplex_refutes S L).
  - now apply (facet_overused_refutes S L).
  - now apply (overlap_refutes S L).
  - destruct c; try discriminate; apply (unused_point_refutes S L B); [assumption|].
    now apply claims_delaunay_triangulation.
  - now apply (uncovered_refutes S L).
  - destruct c; try discriminate. now apply (vertex_in_ball_refutes S L).
  - destruct c; try discriminate.
    + now apply (facet_not_local_refutes S L).
    + now apply (facet_below_plane_refutes S L w).
  - destruct c; try discriminate. now apply (point_below_plane_refutes S L w).
  - destruct c; try discriminate. now apply (vertex_submerged_refutes S L w).
Qed.
End Breaches.

(** ** The caller's points and simplices

    The theorems are about the set of the caller's points: two that are equal are one point, and
    whoever lists one of them lists the other.  A list of points that has one twice is the input's
    fault, not the mesh's; the program that writes refutations refuses it or merges them.  If equal
    points were given different weights, then no function would give the weights, and
    nothing would be claimed that could be true. *)

Section Caller.
Context {d : nat}.
Variables (r : R) (P : list site) (l : list row).

Definition caller_points : list (point d) := map (place_of r) P.
Definition caller_entry (n : option positive) : option (point d) :=
  match n with Some k => option_map (place_of r) (numbered P k) | None => None end.
Definition caller_rows : list (list (option (point d))) := map (map caller_entry) l.
End Caller.

(** P/Q *)
Definition refuted_unit (c : refutation) : R := IZR (unit_numerator c) / IZR (unit_denominator c).

(** The caller's points are the integer points times P/Q; the simplices list points by number. *)
Definition refuted_points (D : plane_or_space) (c : refutation) : list (point (dimension_of D)) :=
  caller_points (refuted_unit c) (sites c).
Definition refuted_simplices (D : plane_or_space) (c : refutation) :
    list (list (option (point (dimension_of D)))) :=
  caller_rows (refuted_unit c) (sites c) (rows c).
(** The weights are functions of the point, the integer weights times the square of P/Q. *)
Definition refuted_weights (D : plane_or_space) (c : refutation)
    (w : point (dimension_of D) -> R) : Prop :=
  forall p, In p (sites c) -> w (place_of (refuted_unit c) p) = refuted_unit c ^ 2 * IZR (weight p).

(** What the refutation says is not so. *)
Definition refuted_claim (D : plane_or_space) (c : refutation) : Prop :=
  match refuted c with
  | Triangulation => claims_triangulation (refuted_points D c) (refuted_simplices D c)
  | Delaunay => claims_delaunay (refuted_points D c) (refuted_simplices D c)
  | WeightedDelaunay => exists w, refuted_weights D c w /\
      claims_weighted_delaunay w (refuted_points D c) (refuted_simplices D c)
  end.
