(** * A broken rule refutes the claims that its evidence is about *)
From Coq Require Import Rbase Rfunctions List ZArith.
From Circumspect Require Import Refutation.
From Circumspect Require Import Definitions Breach HullBreach.
Import ListNotations.
Open Scope R_scope.

Section Breaches.
Context {d : nat}.

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

Theorem broken_refutes c w S L e : concerns e c = true ->
  broken c (lifted c w) S L (rule_of e) -> ~ claims c w S L.
Proof.
  intros C B H. assert (F := claims_fill c w S L H).
  assert (Cx := claims_fill_complex S L F). destruct e; cbn in B.
  - now apply (wrong_dimension_refutes L).
  - now apply (unknown_vertex_refutes L).
  - now apply (repeated_vertex_refutes L).
  - now apply (degenerate_refutes L).
  - now apply (duplicate_simplex_refutes L).
  - now apply (facet_overused_refutes S L).
  - now apply (overlap_refutes L).
  - now apply (covered_twice_refutes L).
  - destruct c; try discriminate; apply (unused_point_refutes S L B); [assumption|].
    now apply claims_delaunay_triangulation.
  - destruct c; try discriminate. now apply (uncovered_point_refutes S L).
  - now apply (hull_not_convex_refutes S L).
  - now apply (hull_not_closed_refutes S L).
  - destruct c; try discriminate. now apply (vertex_in_ball_refutes S L).
  - destruct c; try discriminate.
    + now apply (facet_not_local_refutes S L).
    + now apply (facet_below_plane_refutes S L w).
  - destruct c; try discriminate. now apply (point_below_plane_refutes S L w).
  - destruct c; try discriminate. now apply (vertex_submerged_refutes S L w).
Qed.
End Breaches.
