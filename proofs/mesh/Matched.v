(** * Matched meshes: what a linear-time checker can look at

    A mesh is a list of simplices, each with a frame, in which every facet is either matched with a
    facet of one other simplex, on its other side, or called a hull facet.  Nothing here says that
    simplices do not overlap or that their union is convex: that is what [Mesh.v] and [Hull.v]
    prove from conditions that concern a simplex and its neighbours only, and one sample point. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame.
Import ListNotations.
Open Scope R_scope.

Section Matched.
Context {d : nat}.

(** The facet of [t] opposite vertex i is the facet of [u] opposite vertex j, and the two simplices
    lie on different sides of it. *)
Definition opposite (t : frame d) (i : nat) (u : frame d) (j : nat) : Prop :=
  (i <= d)%nat /\ (j <= d)%nat /\
  (forall k, (k <= d)%nat -> k <> i -> exists l, (l <= d)%nat /\ l <> j /\
    vertex t k = vertex u l) /\
  (forall l, (l <= d)%nat -> l <> j -> exists k, (k <= d)%nat /\ k <> i /\
    vertex u l = vertex t k) /\
  bary t i (vertex u j) < 0.

(** [T] names the simplices, [tets] lists them, [geo t] is the frame of t, [adj t i u j] says that
    facet i of t is matched with facet j of u, [hull t i] that facet i of t is a hull facet. *)
Record matched {T : Type} (tets : list T) (geo : T -> frame d) (adj : T -> nat -> T -> nat -> Prop)
    (hull : T -> nat -> Prop) : Prop := {
  matched_in : forall t i u j, In t tets -> adj t i u j -> In u tets;
  matched_opposite : forall t i u j, In t tets -> adj t i u j -> opposite (geo t) i (geo u) j;
  (* no facet is matched with two *)
  matched_once : forall t i t' i' u j, In t tets -> In t' tets -> adj t i u j -> adj t' i' u j ->
    t = t';
  matched_or_hull : forall t i, In t tets -> (i <= d)%nat -> (exists u j, adj t i u j) \/ hull t i
}.

(** All points of [S] are on the inner side of all hull facets: the hull facets support conv S. *)
Definition supporting {T} (tets : list T) (geo : T -> frame d) (hull : T -> nat -> Prop)
    (S : point d -> Prop) : Prop :=
  forall t i, In t tets -> (i <= d)%nat -> hull t i -> forall p, S p -> 0 <= bary (geo t) i p.

(** The sample point [o] is in the interior of the simplex [t0], and in no other closed simplex. *)
Definition covered_once {T} (tets : list T) (geo : T -> frame d) (o : point d) (t0 : T) : Prop :=
  In t0 tets /\ inside (geo t0) o /\
  forall t, In t tets -> t <> t0 -> exists i, (i <= d)%nat /\ bary (geo t) i o < 0.

(** The points that are vertices of the mesh. *)
Definition vertex_of {T} (tets : list T) (geo : T -> frame d) (p : point d) : Prop :=
  exists t i, In t tets /\ (i <= d)%nat /\ p = vertex (geo t) i.

(** Across a matched facet one coordinate is a negative multiple of the other. *)
Lemma opposite_multiple t i u j : opposite t i u j ->
  exists c, 0 < c /\ forall p, bary u j p = - c * bary t i p.
Proof.
  intros (Hi & Hj & TU & UT & Neg).
  set (m := bary t i (vertex u j)) in *.
  assert (E : forall p, bary t i p = m * bary u j p).
  { intros p. rewrite (interpolation u (bary t i) p (bary_affine t i Hi)). unfold sum.
    rewrite (sum_one _ _ j); [unfold m; ring | apply seq_NoDup | now apply in_seq_d |].
    intros l Hl N. apply in_seq_d in Hl. destruct (UT l Hl N) as (k & Hk & Nk & ->).
    rewrite bary_other by auto. ring. }
  exists (- / m). split.
  - pose proof (Rinv_lt_0_compat m Neg). lra.
  - intros p. rewrite E. field. lra.
Qed.

Lemma opposite_sym t i u j : opposite t i u j -> opposite u j t i.
Proof.
  intros O. destruct (opposite_multiple t i u j O) as (c & C & E).
  destruct O as (Hi & Hj & TU & UT & Neg). repeat split; auto.
  rewrite E, bary_own by assumption. lra.
Qed.

(** A point in the relative interior of a matched facet is in that of the other simplex's. *)
Lemma opposite_through t i u j q : opposite t i u j -> bary t i q = 0 ->
  (forall k, (k <= d)%nat -> k <> i -> 0 < bary t k q) ->
  forall l, (l <= d)%nat -> l <> j -> 0 < bary u l q.
Proof.
  intros (Hi & Hj & TU & UT & Neg) Z X l Hl N.
  rewrite (interpolation t (bary u l) q (bary_affine u l Hl)). unfold sum.
  assert (V : forall k, (k <= d)%nat -> k <> i -> 0 <= bary u l (vertex t k)).
  { intros k Hk Nk. destruct (TU k Hk Nk) as (l' & Hl' & _ & ->).
    rewrite bary_vertex by assumption. destruct (Nat.eq_dec l l'); lra. }
  destruct (UT l Hl N) as (k & Hk & Nk & E).
  apply sum_pos with k.
  - intros k' Hk'. apply in_seq_d in Hk'. destruct (Nat.eq_dec k' i) as [->|Nk'].
    + rewrite Z. lra.
    + apply Rmult_le_pos; [left|]; auto.
  - now apply in_seq_d.
  - rewrite <- E, bary_own by assumption. rewrite Rmult_1_r. auto.
Qed.
End Matched.
