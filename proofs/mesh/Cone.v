(** * Cones from the sample point over the hull facets, and ridges

    A ridge of a hull facet is what the facet has in common with the next hull facet around a
    corner: it is opposite one of the facet's vertices.  A linear-time checker looks at each ridge
    once: the two hull facets that share it are matched, and the far vertex of the one is not
    strictly outside the other ([convex_at_ridges] below).

    The cone of a hull facet is the d-simplex with the sample point o in the place of the vertex
    opposite the facet.  A ridge is then a facet of two cones, on different sides of it.  [Hull.v]
    walks over the cones; what it needs of each crossing is proved here.  In a cone, 1 minus the
    coordinate of o is the affine function that is 0 at o and 1 on the facet, and a convex ridge
    says that it does not grow less when the ridge is crossed ([ridge_convex]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Matched.
Import ListNotations.
Open Scope R_scope.

Section Cone.
Context {d : nat}.
Implicit Types (o p q : point d).

(** [c] is the cone from [o] over the facet of [t] opposite vertex i. *)
Definition cone_of (t : frame d) (i : nat) o (c : frame d) : Prop :=
  forall l, (l <= d)%nat -> vertex c l = if Nat.eq_dec l i then o else vertex t l.

Definition hull_facet {T} (tets : list T) (geo : T -> frame d) (hull : T -> nat -> Prop)
    (t : T) (i : nat) : Prop :=
  In t tets /\ (i <= d)%nat /\ hull t i.

(** The conditions on hull facets and ridges.  [cone t i] is the cone of hull facet i of t, and
    [ridge t i k t' i' k'] says: the ridge of hull facet i of t opposite its vertex k is matched
    with the ridge of hull facet i' of t' opposite vertex k'. *)
Record convex_at_ridges {T : Type} (tets : list T) (geo : T -> frame d)
    (adj : T -> nat -> T -> nat -> Prop) (hull : T -> nat -> Prop) (o : point d)
    (cone : T -> nat -> frame d) (ridge : T -> nat -> nat -> T -> nat -> nat -> Prop) : Prop := {
  (* a hull facet is not matched with the facet of a simplex, too *)
  hull_unmatched : forall t i u j, hull_facet tets geo hull t i -> In u tets -> ~ adj u j t i;
  (* the sample point is strictly on the inner side of each hull facet *)
  sample_inner : forall t i, hull_facet tets geo hull t i -> 0 < bary (geo t) i o;
  hull_cone : forall t i, hull_facet tets geo hull t i -> cone_of (geo t) i o (cone t i);
  (* each ridge of a hull facet is matched, ... *)
  ridge_matched : forall t i k, hull_facet tets geo hull t i -> (k <= d)%nat -> k <> i ->
    exists t' i' k', ridge t i k t' i' k';
  (* ... with a ridge of a hull facet that has the same vertices, *)
  ridge_hull : forall t i k t' i' k', hull_facet tets geo hull t i -> k <> i ->
    ridge t i k t' i' k' -> hull_facet tets geo hull t' i';
  (* the cones being on different sides of the hyperplane through it and the sample point; *)
  ridge_opposite : forall t i k t' i' k', hull_facet tets geo hull t i -> k <> i ->
    ridge t i k t' i' k' -> opposite (cone t i) k (cone t' i') k';
  (* no ridge is matched with two, *)
  ridge_once : forall t1 i1 k1 t2 i2 k2 t' i' k', hull_facet tets geo hull t1 i1 ->
    hull_facet tets geo hull t2 i2 -> k1 <> i1 -> k2 <> i2 ->
    ridge t1 i1 k1 t' i' k' -> ridge t2 i2 k2 t' i' k' -> t1 = t2 /\ i1 = i2;
  (* and the far vertex of the second facet is not strictly outside the first *)
  locally_convex : forall t i k t' i' k', hull_facet tets geo hull t i -> k <> i ->
    ridge t i k t' i' k' -> 0 <= bary (geo t) i (vertex (geo t') k')
}.

(** ** The coordinates of a cone *)

Section OneCone.
Variables (t c : frame d) (i : nat) (o : point d).
Hypothesis Hi : (i <= d)%nat.
Hypothesis C : cone_of t i o c.

Lemma cone_apex : vertex c i = o.
Proof. rewrite C by assumption. destruct (Nat.eq_dec i i); congruence. Qed.
Lemma cone_vertex l : (l <= d)%nat -> l <> i -> vertex c l = vertex t l.
Proof. intros Hl N. rewrite C by assumption. destruct (Nat.eq_dec l i); congruence. Qed.

Lemma cone_height p : bary t i p = bary c i p * bary t i o.
Proof.
  rewrite (interpolation c (bary t i) p (bary_affine t i Hi)). unfold sum.
  rewrite (sum_one _ _ i); [now rewrite cone_apex | apply seq_NoDup | now apply in_seq_d |].
  intros l Hl N. apply in_seq_d in Hl. rewrite cone_vertex, bary_other by auto. ring.
Qed.
Lemma cone_bary k p : (k <= d)%nat -> k <> i ->
  bary c k p = bary t k p - bary c i p * bary t k o.
Proof.
  intros Hk N.
  set (f := fun p => bary t k p - bary t k o * bary c i p).
  assert (A : affine f).
  { apply affine_ext with (fun p => 1 * bary t k p + (- bary t k o) * bary c i p).
    - intros; unfold f; ring.
    - apply affine_combine; now apply bary_affine. }
  transitivity (f p); [|unfold f; ring].
  rewrite (interpolation c f p A). unfold sum. rewrite (sum_one _ _ k).
  - unfold f. rewrite bary_other, cone_vertex, bary_own by auto. ring.
  - apply seq_NoDup.
  - now apply in_seq_d.
  - intros l Hl Nl. apply in_seq_d in Hl. unfold f. destruct (Nat.eq_dec l i) as [->|M].
    + rewrite bary_own, cone_apex by assumption. ring.
    + rewrite (bary_other c), cone_vertex, bary_other by auto. ring.
Qed.
End OneCone.

(** The point o need only be off the hyperplane of the facet for there to be a cone. *)
Lemma cone_exists (t : frame d) i o : (i <= d)%nat -> bary t i o <> 0 -> {c | cone_of t i o c}.
Proof.
  intros Hi Z.
  set (v := fun l => if Nat.eq_dec l i then o else vertex t l).
  set (r := fun p => bary t i p / bary t i o).
  set (b := fun l p => if Nat.eq_dec l i then r p else bary t l p - r p * bary t l o).
  assert (Ar : affine r).
  { apply affine_ext with (fun p => / bary t i o * bary t i p); [intros; unfold r, Rdiv; ring|].
    apply affine_scale. now apply bary_affine. }
  assert (A : forall l, (l <= d)%nat -> affine (b l)).
  { intros l Hl. unfold b. destruct (Nat.eq_dec l i); [assumption|].
    apply affine_ext with (fun p => 1 * bary t l p + (- bary t l o) * r p); [intros; ring|].
    apply affine_combine; [now apply bary_affine|assumption]. }
  assert (V : forall l k, (l <= d)%nat -> (k <= d)%nat ->
    b l (v k) = if Nat.eq_dec l k then 1 else 0).
  { intros l k Hl Hk. unfold b, v, r.
    destruct (Nat.eq_dec l i) as [->|Nl], (Nat.eq_dec k i) as [->|Nk];
      try (rewrite (bary_other t i) by auto); try (destruct (Nat.eq_dec i i); [|congruence]);
      try (destruct (Nat.eq_dec l i); [congruence|]); try (now field).
    - destruct (Nat.eq_dec i k); [congruence|]. now field.
    - rewrite bary_vertex by assumption. destruct (Nat.eq_dec l k); now field. }
  assert (I : forall f p, affine f -> f p = sum (S d) (fun l => b l p * f (v l))).
  { intros f p F. transitivity (f p - r p * f o + r p * f o); [ring|].
    rewrite (interpolation t f p F) at 1. rewrite (interpolation t f o F) at 1.
    transitivity (sum (S d) (fun l => bary t l p * f (vertex t l) +
      - r p * (bary t l o * f (vertex t l))) + r p * f o).
    { unfold sum. rewrite sum_plus, sum_scale. ring. }
    assert (O : r p * f o = sum (S d) (fun l => if Nat.eq_dec l i then r p * f o else 0)).
    { unfold sum. rewrite (sum_one _ _ i); [|apply seq_NoDup|now apply in_seq_d|].
      - destruct (Nat.eq_dec i i); congruence.
      - intros l _ N. destruct (Nat.eq_dec l i); congruence. }
    rewrite O at 1. unfold sum. rewrite <- sum_plus. apply sum_ext. intros l Hl.
    unfold b, v. destruct (Nat.eq_dec l i) as [->|N]; [|ring]. unfold r. now field. }
  now exists (Frame d v b A V I).
Qed.

(** ** Crossing a ridge *)

Section Ridge.
Variables (t t' c c' : frame d) (i i' k k' : nat) (o : point d).
Hypothesis Hi : (i <= d)%nat.
Hypothesis Hi' : (i' <= d)%nat.
Hypothesis C : cone_of t i o c.
Hypothesis C' : cone_of t' i' o c'.
Hypothesis Nk : k <> i.
Hypothesis O : opposite c k c' k'.

Lemma ridge_index : k' <> i'.
Proof.
  destruct O as (Hk & Hk' & TU & _). destruct (TU i Hi) as (l & Hl & N & E); [congruence|].
  rewrite (cone_apex t c i o Hi C), <- (cone_apex t' c' i' o Hi' C') in E.
  apply vertex_inj in E; congruence.
Qed.

(** The functions that are 1 at o and 0 on the facets agree on the ridge's hyperplane, hence
    differ by a multiple of its function. *)
Lemma ridge_apex p : bary c i p = bary c' i' p + bary c' k' p * bary c i (vertex t' k').
Proof.
  pose proof ridge_index as Nk'. destruct O as (Hk & Hk' & TU & UT & _).
  set (f := fun p => bary c i p - bary c' i' p).
  assert (A : affine f).
  { apply affine_ext with (fun p => 1 * bary c i p + (-1) * bary c' i' p);
      [intros; unfold f; ring|].
    apply affine_combine; now apply bary_affine. }
  assert (E : f p = bary c' k' p * f (vertex c' k')).
  { rewrite (interpolation c' f p A). unfold sum. rewrite (sum_one _ _ k'); auto.
    - apply seq_NoDup.
    - now apply in_seq_d.
    - intros l Hl N. apply in_seq_d in Hl. unfold f. destruct (Nat.eq_dec l i') as [->|M].
      + rewrite bary_own, (cone_apex t' c' i' o Hi' C') by assumption.
        rewrite <- (cone_apex t c i o Hi C), bary_own by assumption. ring.
      + rewrite (bary_other c') by auto. destruct (UT l Hl N) as (m & Hm & Nm & E).
        rewrite E, bary_other; auto; [ring|]. intros ->. rewrite (cone_apex t c m o Hi C) in E.
        rewrite <- (cone_apex t' c' i' o Hi' C') in E. apply vertex_inj in E; congruence. }
  unfold f in E. rewrite (bary_other c' i'), (cone_vertex t' c' i' o C' k') in E by auto. lra.
Qed.

(** What leaves the cone through the relative interior of a ridge's wall enters the other cone,
    and stays beyond the facets or on the inner side of them.  (The walls run on, beyond the facets
    and through o: move the point towards o to come to the ridge's own facet of the cones.) *)
Lemma ridge_through q : bary c k q = 0 ->
  (forall l, (l <= d)%nat -> l <> i -> l <> k -> 0 < bary c l q) ->
  bary c' i' q = bary c i q /\
  forall l, (l <= d)%nat -> l <> i' -> l <> k' -> 0 < bary c' l q.
Proof.
  intros Z X. pose proof ridge_index as Nk'.
  destruct (opposite_multiple _ _ _ _ O) as (m & _ & M).
  split; [rewrite (ridge_apex q), M, Z; ring|].
  pose proof O as (Hk & Hk' & _).
  set (h := bary c i q).
  set (s := / (1 + Rabs (h - 1))).
  assert (P : 0 < 1 + Rabs (h - 1)) by (pose proof (Rabs_pos (h - 1)); lra).
  assert (S : 0 < s) by now apply Rinv_0_lt_compat.
  assert (T : 0 < bary c i (mix o q s)).
  { rewrite (affine_mix _ _ _ _ (bary_affine c i Hi)). fold h.
    rewrite <- (cone_apex t c i o Hi C), bary_own by assumption.
    assert (s * (1 + Rabs (h - 1)) = 1) by (unfold s; field; lra).
    assert (- Rabs (h - 1) <= h - 1) by (unfold Rabs; destruct (Rcase_abs (h - 1)); lra). nra. }
  intros l Hl Nl Ml.
  assert (Y : 0 < bary c' l (mix o q s)).
  { apply (opposite_through c k c' k'); auto.
    - rewrite (affine_mix _ _ _ _ (bary_affine c k Hk)), Z.
      rewrite <- (cone_apex t c i o Hi C), bary_other by auto. ring.
    - intros a Ha Na. destruct (Nat.eq_dec a i) as [->|Ma]; [exact T|].
      rewrite (affine_mix _ _ _ _ (bary_affine c a Ha)).
      rewrite <- (cone_apex t c i o Hi C), bary_other by auto.
      pose proof (Rmult_lt_0_compat _ _ S (X a Ha Ma Na)). lra. }
  rewrite (affine_mix _ _ _ _ (bary_affine c' l Hl)) in Y.
  rewrite <- (cone_apex t' c' i' o Hi' C'), bary_other in Y by auto. nra.
Qed.

(** A convex ridge: the coordinate of o does not grow when the ridge is crossed. *)
Lemma ridge_convex p : 0 < bary t i o -> 0 <= bary t i (vertex t' k') -> 0 < bary c' k' p ->
  bary c' i' p <= bary c i p.
Proof.
  intros B L P. rewrite (ridge_apex p). rewrite (cone_height t c i o Hi C) in L.
  assert (0 <= bary c i (vertex t' k')).
  { apply Rmult_le_reg_r with (bary t i o); [assumption|]. lra. }
  pose proof (Rmult_le_pos _ _ (Rlt_le _ _ P) H). lra.
Qed.

(** So a checker may test a ridge from one of its sides. *)
Lemma ridge_convex_sym : 0 < bary t i o -> 0 < bary t' i' o ->
  0 <= bary t i (vertex t' k') -> 0 <= bary t' i' (vertex t k).
Proof.
  intros B B' L. rewrite (cone_height t c i o Hi C) in L. rewrite (cone_height t' c' i' o Hi' C').
  pose proof O as (Hk & _). pose proof (opposite_sym _ _ _ _ O) as (_ & _ & _ & _ & Neg).
  rewrite (cone_vertex t c i o C k Hk Nk) in Neg.
  pose proof (ridge_apex (vertex t k)) as E. rewrite <- (cone_vertex t c i o C k Hk Nk) in E at 1.
  rewrite bary_other in E by auto. apply Rmult_le_pos; [|lra].
  assert (0 <= bary c i (vertex t' k')).
  { apply Rmult_le_reg_r with (bary t i o); [assumption|]. lra. }
  nra.
Qed.
End Ridge.
End Cone.
