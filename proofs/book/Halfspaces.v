(** * Two forms of the convex hull

    The definitions say that a point is in conv S if it is a convex combination of points of S. The
    checkers ask whether it is on the inner side of every hull facet. For a point set that has a
    triangulation the two agree: conv S is the intersection of the half-spaces that contain S
    ([conv_halfspaces]); the proof uses those of the hull facets only. *)
From Coq Require Import Rbase Rfunctions List Arith Lia.
From Circumspect Require Import Definitions Affine Frame Matched Faces Mesh Adjacency.
Open Scope R_scope.

Section Halfspaces.
Context {d : nat}.
Implicit Types (S : list (point d)) (T : list (simplex d)) (q : point d).

Theorem conv_halfspaces S T : (1 <= d)%nat -> fills S T -> T <> nil ->
  forall q, conv S q <->
    (forall a b, (forall p, In p S -> 0 <= plane a b p) -> 0 <= plane a b q).
Proof.
  intros D F N q. split.
  - intros C a b H. apply (affine_conv (plane a b) S); auto. apply affine_plane.
  - intros H. destruct (triangulation_matched S T D F N) as (geo & V & M & Sup & _).
    destruct F as (_ & _ & _ & I & U).
    assert (VS : forall t i, In t (seq 0 (length T)) -> (i <= d)%nat -> In (vertex (geo t) i) S).
    { intros t i Ht Hi. apply in_seq in Ht. apply (I (nth t T nil)); [apply nth_In; lia|].
      rewrite <- V by lia. apply in_vertices. eauto. }
    destruct (mesh_covers M VS Sup q) as (t & Ht & Q).
    + destruct T; [contradiction|]. discriminate.
    + intros t i Ht Hi O. destruct (bary_affine (geo t) i Hi) as (a & b & E). rewrite E.
      apply H. intros p Hp. rewrite <- E. exact (Sup t i Ht Hi O p Hp).
    + apply U. apply in_seq in Ht. exists (nth t T nil). split; [apply nth_In; lia|].
      rewrite <- V by lia. now apply conv_vertices.
Qed.
End Halfspaces.
