(** * Ridges: where two hull facets of a triangulation meet

    The converse of [Hull.v].  The cones from a point o in the interior over the hull facets do not
    overlap ([cones_apart]), since a ray from o leaves conv S once; so hull facets that share a
    ridge lie on different sides of the hyperplane through it and o ([ridge_sides]), and no three
    share one ([ridge_of_two]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Facets Matched Adjacency.
From Circumspect Require Import Cone.
Import ListNotations.
Open Scope R_scope.

(** ** The radial projection of a point of a cone onto the facet *)
Section Radial.
Context {d : nat}.
Implicit Types (t c : frame d) (o y : point d).

(** How far y is along its ray from o (0) to the facet (1). *)
Definition progress c i y : R := 1 - bary c i y.
Definition radial c i o y : point d := mix o y (/ progress c i y).

Lemma progress_positive c i k y : (i <= d)%nat -> (k <= d)%nat -> k <> i ->
  inside_closed c y -> 0 < bary c k y -> 0 < progress c i y.
Proof.
  intros Hi Hk N I P. unfold progress.
  pose proof (bary_sum c y) as E. unfold sum in E.
  assert (0 < sum_over (seq 0 (S d)) (fun l => if Nat.eq_dec l i then 0 else bary c l y)) as Q.
  { apply sum_pos with k; [|now apply in_seq_d|destruct (Nat.eq_dec k i);
      [contradiction|assumption]].
    intros l Hl. apply in_seq_d in Hl. destruct (Nat.eq_dec l i); [lra|auto]. }
  rewrite (sum_ext _ (fun l => bary c l y) (fun l => (if Nat.eq_dec l i then 0 else bary c l y) +
    (if Nat.eq_dec l i then bary c i y else 0))), sum_plus in E.
  - assert (Z : sum_over (seq 0 (S d)) (fun l => if Nat.eq_dec l i then bary c i y else 0) =
      bary c i y).
    { rewrite (sum_one _ _ i); [|apply seq_NoDup|now apply in_seq_d|].
      - destruct (Nat.eq_dec i i); congruence.
      - intros l _ Nl. destruct (Nat.eq_dec l i); congruence. }
    lra.
  - intros l _. destruct (Nat.eq_dec l i) as [->|]; ring.
Qed.

Variables (t c : frame d) (i : nat) (o : point d).
Hypothesis Hi : (i <= d)%nat.
Hypothesis C : cone_of t i o c.

Lemma cone_at_origin k : (k <= d)%nat -> k <> i -> bary c k o = 0.
Proof. intros Hk N. rewrite <- (cone_apex t c i o Hi C) at 1. now apply bary_other. Qed.
Lemma along_ray y s : bary t i (mix o y s) = bary t i o * (1 - s * progress c i y).
Proof.
  rewrite affine_mix by now apply bary_affine. rewrite (cone_height t c i o Hi C y).
  unfold progress. ring.
Qed.
Lemma on_facet y : 0 < progress c i y -> bary t i (radial c i o y) = 0.
Proof. intros P. unfold radial. rewrite along_ray, Rinv_l by lra. ring. Qed.
Lemma radial_coordinate k y : bary t i o <> 0 -> (k <= d)%nat -> k <> i -> 0 < progress c i y ->
  bary t k (radial c i o y) = / progress c i y * bary c k y.
Proof.
  intros B Hk N P. pose proof (cone_bary t c i o Hi C k (radial c i o y) Hk N) as E.
  assert (Z : bary c i (radial c i o y) = 0).
  { pose proof (cone_height t c i o Hi C (radial c i o y)) as X.
    rewrite on_facet in X by assumption.
    symmetry in X. apply Rmult_integral in X. destruct X; [assumption|contradiction]. }
  rewrite Z in E. unfold radial in E at 1. rewrite affine_mix in E by now apply bary_affine.
  rewrite cone_at_origin in E by assumption. lra.
Qed.
Lemma radial_closed y : bary t i o <> 0 -> inside_closed c y -> 0 < progress c i y ->
  inside_closed t (radial c i o y).
Proof.
  intros B I P k Hk. destruct (Nat.eq_dec k i) as [->|N]; [rewrite on_facet by assumption; lra|].
  rewrite radial_coordinate by assumption. apply Rmult_le_pos; [|now apply I].
  left. now apply Rinv_0_lt_compat.
Qed.
End Radial.

(** The cone, where there is one. *)
Definition cone_over {d : nat} (t : frame d) (i : nat) (o : point d) : frame d :=
  match le_dec i d, Req_EM_T (bary t i o) 0 with
  | left Hi, right N => proj1_sig (cone_exists t i o Hi N)
  | _, _ => t
  end.
Lemma cone_over_cone {d : nat} (t : frame d) i o : (i <= d)%nat -> bary t i o <> 0 ->
  cone_of t i o (cone_over t i o).
Proof.
  intros Hi N. unfold cone_over. destruct (le_dec i d) as [L|]; [|contradiction].
  destruct (Req_EM_T (bary t i o) 0); [contradiction|]. apply proj2_sig.
Qed.

Section Ridges.
Context {d : nat} {A : Type} (tets : list A) (geo : A -> frame d) (V : list (point d)).
Hypothesis positive : (1 <= d)%nat.
Hypothesis agreeing : forall t u, In t tets -> In u tets -> agree (geo t) (geo u).
Hypothesis different : forall t u, In t tets -> In u tets ->
  same (vertices (geo t)) (vertices (geo u)) -> t = u.
Hypothesis in_V : forall t, In t tets -> incl (vertices (geo t)) V.
Notation hull_facet := (hull_facet tets geo (outer tets geo)).
Hypothesis support : supporting tets geo (outer tets geo) (fun p => In p V).
Variables (o : point d) (cone : A -> nat -> frame d).
Hypothesis interior : forall t i, hull_facet t i -> 0 < bary (geo t) i o.
Hypothesis cones : forall t i, hull_facet t i -> cone_of (geo t) i o (cone t i).

Lemma support_conv t i x : hull_facet t i -> conv V x -> 0 <= bary (geo t) i x.
Proof.
  intros (Ht & Hi & O) C. apply (affine_conv (bary (geo t) i) V x); auto using bary_affine.
Qed.
Lemma closed_conv t x : In t tets -> inside_closed (geo t) x -> conv V x.
Proof. intros Ht I. apply (conv_incl (vertices (geo t))); [now apply in_V|].
  now apply conv_vertices. Qed.

(** A facet of the same simplex with the same vertices is the same. *)
Lemma facet_same_index (t : frame d) i j : (i <= d)%nat -> (j <= d)%nat ->
  incl (facet_of t i) (facet_of t j) -> i = j.
Proof.
  intros Hi Hj I. destruct (Nat.eq_dec i j) as [|N]; [assumption|exfalso].
  apply (not_in_facet_of t j Hj), I, in_facet_of; eauto.
Qed.
Lemma hull_facet_unique t i u j : hull_facet t i -> hull_facet u j ->
  same (facet_of (geo t) i) (facet_of (geo u) j) -> t = u /\ i = j.
Proof.
  intros (Ht & Hi & O) (Hu & Hj & _) E.
  destruct (one_side tets geo positive agreeing different t i u j Ht Hu Hi Hj E).
  - pose proof (facet_multiple_nonzero _ _ _ _ Hi Hj E) as N.
    destruct (Rlt_dec 0 (bary (geo t) i (vertex (geo u) j))) as [|NP]; [assumption|exfalso].
    apply (O u j). split; [assumption|]. split; [assumption|]. apply opposite_facets.
    split; [assumption|]. split; [assumption|]. split; [assumption|lra].
  - split; [reflexivity|]. apply (facet_same_index (geo t)); auto. apply E.
Qed.

(** A ray leaves conv V at the first hull facet. *)
Lemma progress_le t i u j y : hull_facet t i -> hull_facet u j ->
  inside_closed (cone u j) y -> 0 < progress (cone u j) j y ->
  progress (cone t i) i y <= progress (cone u j) j y.
Proof.
  intros Ft Fu I P. pose proof Fu as (Hu & Hj & _). pose proof Ft as (Ht & Hi & _).
  assert (Bu := interior u j Fu). assert (Bt := interior t i Ft).
  pose proof (radial_closed (geo u) (cone u j) j o Hj (cones u j Fu) y ltac:(lra) I P) as R.
  pose proof (support_conv t i _ Ft (closed_conv u _ Hu R)) as Q.
  unfold radial in Q. rewrite (along_ray (geo t) (cone t i) i o Hi (cones t i Ft)) in Q.
  apply Rmult_le_reg_r with (/ progress (cone u j) j y); [now apply Rinv_0_lt_compat|].
  rewrite Rinv_r by lra. nra.
Qed.

(** A point in two closed cones: then its radial projections on the two facets are the same. *)
Lemma radial_shared t i u j y : hull_facet t i -> hull_facet u j ->
  inside_closed (cone t i) y -> inside_closed (cone u j) y ->
  0 < progress (cone t i) i y -> 0 < progress (cone u j) j y ->
  radial (cone t i) i o y = radial (cone u j) j o y.
Proof.
  intros Ft Fu It Iu Pt Pu. unfold radial. do 2 f_equal.
  apply Rle_antisym; now apply progress_le.
Qed.
(** So the vertices of t's facet with positive coordinate in the cone are vertices of u's. *)
Lemma cones_agree t i u j y k : hull_facet t i -> hull_facet u j ->
  inside_closed (cone t i) y -> inside_closed (cone u j) y ->
  0 < progress (cone t i) i y -> 0 < progress (cone u j) j y ->
  (k <= d)%nat -> k <> i -> 0 < bary (cone t i) k y ->
  In (vertex (geo t) k) (facet_of (geo u) j).
Proof.
  intros Ft Fu It Iu Pt Pu Hk N P. pose proof Fu as (Hu & Hj & _). pose proof Ft as (Ht & Hi & _).
  assert (Bu := interior u j Fu). assert (Bt := interior t i Ft).
  pose proof (radial_shared t i u j y Ft Fu It Iu Pt Pu) as E.
  set (x := radial (cone t i) i o y) in *.
  assert (Xt : inside_closed (geo t) x).
  { apply (radial_closed (geo t) (cone t i) i o Hi (cones t i Ft)); auto. lra. }
  assert (Xu : inside_closed (geo u) x).
  { rewrite E. apply (radial_closed (geo u) (cone u j) j o Hj (cones u j Fu)); auto. lra. }
  destruct (agreeing t u Ht Hu x Xt Xu k Hk) as (l & Hl & El & Pl).
  { unfold x. rewrite (radial_coordinate (geo t) (cone t i) i o Hi (cones t i Ft)); auto; [|lra].
    apply Rmult_lt_0_compat; [now apply Rinv_0_lt_compat|assumption]. }
  apply in_facet_of; [assumption|]. exists l. split; [assumption|]. split; [|assumption].
  intros ->. rewrite E, (on_facet (geo u) (cone u j) j o Hj (cones u j Fu)) in Pl; [lra|auto].
Qed.

(** The cones over different hull facets do not overlap. *)
Theorem cones_apart t i u j y : hull_facet t i -> hull_facet u j ->
  inside (cone t i) y -> inside (cone u j) y -> t = u /\ i = j.
Proof.
  intros Ft Fu It Iu. apply hull_facet_unique; [assumption..|].
  assert (It' : inside_closed (cone t i) y) by (intros k Hk; left; auto).
  assert (Iu' : inside_closed (cone u j) y) by (intros k Hk; left; auto).
  assert (K : forall v m, hull_facet v m -> inside (cone v m) y -> 0 < progress (cone v m) m y).
  { intros v m (_ & Hm & _) I.
    apply progress_positive with (if Nat.eq_dec m 0 then 1%nat else 0%nat); try assumption;
      [destruct (Nat.eq_dec m 0); lia..| |].
    - intros k Hk. left. auto.
    - apply I. destruct (Nat.eq_dec m 0); lia. }
  pose proof (K t i Ft It) as Pt. pose proof (K u j Fu Iu) as Pu.
  pose proof Fu as (_ & Hj & _). pose proof Ft as (_ & Hi & _).
  split; intros v Hv; (apply in_facet_of in Hv; [|assumption]); destruct Hv as (k & Hk & N & ->).
  - apply (cones_agree t i u j y); auto.
  - apply (cones_agree u j t i y); auto.
Qed.

(** Different hull facets that share a ridge are on different sides of it, seen from o, ... *)
Theorem ridge_sides t i k u j l : hull_facet t i -> hull_facet u j -> ~ (t = u /\ i = j) ->
  (k <= d)%nat -> (l <= d)%nat -> same (facet_of (cone t i) k) (facet_of (cone u j) l) ->
  opposite (cone t i) k (cone u j) l.
Proof.
  intros Ft Fu N Hk Hl E. apply opposite_facets. split; [assumption|]. split; [assumption|].
  split; [assumption|]. pose proof (facet_multiple_nonzero _ _ _ _ Hk Hl E) as NZ.
  destruct (Rlt_dec 0 (bary (cone t i) k (vertex (cone u j) l))) as [P|]; [exfalso|lra].
  destruct (same_side_overlap _ _ _ _ positive Hk Hl E P) as (y & It & Iu).
  apply N. now apply (cones_apart t i u j y).
Qed.
(** ... so no three share one. *)
Theorem ridge_of_two t i k t' i' k' u j l : hull_facet t i -> hull_facet t' i' ->
  opposite (cone t i) k (cone u j) l -> opposite (cone t' i') k' (cone u j) l ->
  t = t' /\ i = i' /\ k = k'.
Proof.
  intros Ft Ft' O O'. destruct (opposite_multiple _ _ _ _ O) as (a & Pa & M).
  destruct (opposite_multiple _ _ _ _ O') as (b & Pb & M').
  apply opposite_facets in O, O'. destruct O as (Hk & Hl & [TU UT] & _).
  destruct O' as (Hk' & _ & [TU' UT'] & _).
  assert (E : same (facet_of (cone t i) k) (facet_of (cone t' i') k')).
  { split; eapply incl_tran; eassumption. }
  assert (Pos : 0 < bary (cone t i) k (vertex (cone t' i') k')).
  { pose proof (M (vertex (cone t' i') k')) as X. rewrite M', bary_own in X by assumption. nra. }
  destruct (same_side_overlap _ _ _ _ positive Hk Hk' E Pos) as (y & It & It').
  destruct (cones_apart t i t' i' y Ft Ft' It It') as [<- <-].
  split; [reflexivity|]. split; [reflexivity|].
  apply (facet_same_index (cone t i)); auto. apply E.
Qed.
End Ridges.
