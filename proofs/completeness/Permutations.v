(** * Facets and ridges that share their vertices have the right permutation

    The converse of [Incidence.v]: if facets of two simplices, or of two cones, are opposite, then
    the permutation that the checker looks at is there, and it is odd or even as it should be. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia Permutation Bool.
From Circumspect Require Import Checker Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Matched Cone Orientation.
From Circumspect Require Import Incidence Honest.
Import ListNotations.
Open Scope R_scope.

(** ** A permutation has a parity *)

Lemma pull_exists a l : In a l -> exists s r, pull a l = Some (s, r) /\ Permutation l (a :: r).
Proof.
  induction l as [|b l IH]; intros I; [destruct I|]. cbn [pull].
  destruct (Pos.eqb_spec a b) as [->|N]; [eauto|].
  destruct IH as (s & r & -> & P); [destruct I; [congruence|assumption]|].
  exists (negb s), (b :: r). split; [reflexivity|].
  apply perm_trans with (b :: a :: r); [now constructor|apply perm_swap].
Qed.
Lemma parity_exists k l : Permutation k l -> exists s, parity k l = Some s.
Proof.
  revert l. induction k as [|a k IH]; intros l P; cbn [parity].
  - apply Permutation_nil in P. subst. eauto.
  - destruct (pull_exists a l) as (s & r & -> & Q).
    { apply (Permutation_in a P). now left. }
    destruct (IH r) as (s' & ->); [|eauto].
    apply Permutation_cons_inv with a. now apply perm_trans with l.
Qed.

Lemma replace_perm {A} i (a : A) l : (i < length l)%nat ->
  Permutation (replace i a l) (a :: remove i l).
Proof.
  revert i. induction l as [|b l IH]; intros [|i] H; cbn in *; try lia; [reflexivity|].
  apply perm_trans with (b :: a :: remove i l); [|apply perm_swap]. constructor. apply IH. lia.
Qed.
Lemma remove_perm {A} i (a : A) l : nth_error l i = Some a -> Permutation l (a :: remove i l).
Proof.
  revert i. induction l as [|b l IH]; intros [|i] H; cbn in *; try discriminate.
  - injection H as ->. reflexivity.
  - apply perm_trans with (b :: a :: remove i l); [|apply perm_swap]. constructor. now apply IH.
Qed.
Lemma remove_NoDup {A} i (l : list A) : NoDup l -> NoDup (remove i l).
Proof.
  intros N. destruct (nth_error l i) as [a|] eqn:E.
  - apply (Permutation_NoDup (remove_perm i a l E)) in N. now inversion N.
  - replace (remove i l) with l; [assumption|]. clear N. revert i E.
    induction l as [|b l IH]; intros [|i] E; cbn in *; try discriminate; auto.
    f_equal. auto.
Qed.

(** Two lists that differ in one place. *)
Lemma exchange K L i j v : NoDup K -> NoDup L -> (i < length K)%nat -> nth_error L j = Some v ->
  shared (remove i K) (remove j L) -> exists s, parity (replace i v K) L = Some s.
Proof.
  intros NK NL Hi Ev S. apply parity_exists.
  apply perm_trans with (v :: remove i K); [now apply replace_perm|].
  apply perm_trans with (v :: remove j L); [|now apply Permutation_sym, remove_perm].
  constructor. apply NoDup_Permutation; auto using remove_NoDup.
Qed.
Lemma shared_sym K L : shared K L -> shared L K.
Proof. intros S k. symmetry. apply S. Qed.

Lemma sign_negative s : sign s < 0 -> s = true.
Proof. destruct s; cbn; [reflexivity|lra]. Qed.

(** The entries of a list of vertices. *)
Lemma listed_corner {d : nat} (spot : positive -> point d) L u l : lists (map spot L) u ->
  (l <= d)%nat -> exists v, nth_error L l = Some v /\ vertex u l = spot v.
Proof.
  intros (Len & V) Hl. rewrite map_length in Len. destruct (nth_error L l) as [v|] eqn:E.
  - exists v. split; [reflexivity|]. specialize (V l Hl).
    rewrite (map_nth_error spot _ _ E) in V. congruence.
  - apply nth_error_None in E. lia.
Qed.

Section Permutations.
Context {d : nat} {orient : list (point d) -> R}.
Hypothesis Or : oriented orient.
Variable spot : positive -> point d.
Variables (K L : list positive) (t u : frame d) (i j : nat).
Hypothesis LK : lists (map spot K) t.
Hypothesis LL : lists (map spot L) u.
Hypothesis PK : 0 < orient (map spot K).
Hypothesis PL : 0 < orient (map spot L).
Hypothesis NK : NoDup K.
Hypothesis NL : NoDup L.
Hypothesis Hi : (i <= d)%nat.
Hypothesis Hj : (j <= d)%nat.

Lemma length_K : length K = S d.
Proof. pose proof (proj1 LK) as E. now rewrite map_length in E. Qed.
Lemma length_L : length L = S d.
Proof. pose proof (proj1 LL) as E. now rewrite map_length in E. Qed.
(** Conversely to [facets_opposite]. *)
Theorem opposite_matched : shared (remove i K) (remove j L) -> bary t i (vertex u j) < 0 ->
  matched_facet K L i j = true.
Proof.
  intros S Neg. destruct (listed_corner spot L u j LL Hj) as (v & Ev & V).
  destruct (exchange K L i j v NK NL) as (s & P); auto; [rewrite length_K; lia|].
  unfold matched_facet. rewrite Ev, P. replace s with true; [reflexivity|].
  symmetry. apply sign_negative.
  pose proof (frame_bary Or _ t i (vertex u j) LK ltac:(lra) Hi) as B.
  rewrite V, <- replace_map in B.
  rewrite (parity_sign (fun l => orient (map spot l))
    (alternating_map spot _ (orient_swap _ Or)) _ _ _ P) in B.
  rewrite V in Neg. nra.
Qed.

(** Conversely to [ridges_opposite]. *)
Theorem opposite_matched_ridge a b c e o : 0 < bary t i o -> 0 < bary u j o ->
  cone_of t i o c -> cone_of u j o e -> (a < d)%nat -> (b < d)%nat ->
  shared (remove a (remove i K)) (remove b (remove j L)) ->
  bary c (skip i a) (vertex u (skip j b)) < 0 ->
  matched_ridge (remove i K) (remove j L) i j a b = true.
Proof.
  intros Bi Bj C E Ha Hb S Neg. pose proof length_K as LenK. pose proof length_L as LenL.
  pose proof (skip_le i a d Ha) as Hka. pose proof (skip_le j b d Hb) as Hkb.
  pose proof (remove_length i K ltac:(lia)) as RK.
  destruct (listed_corner spot L u (skip j b) LL Hkb) as (v & Ev & V).
  assert (Ev' : nth_error (remove j L) b = Some v) by (rewrite remove_nth; auto; lia).
  destruct (exchange (remove i K) (remove j L) a b v) as (s & P); auto using remove_NoDup; [lia|].
  unfold matched_ridge. rewrite Ev', P. apply sign_negative.
  pose proof (cone_lists _ _ _ _ _ LK Hi C) as LC. pose proof (cone_lists _ _ _ _ _ LL Hj E) as LE.
  set (f l := orient (o :: map spot l)).
  assert (Al : alternating f).
  { apply (alternating_map spot (fun l => orient (o :: l))), alternating_cons, (orient_swap _ Or). }
  assert (F : forall n X, (n < length X)%nat ->
    orient (replace n o (map spot X)) = sign (Nat.odd n) * f (remove n X)).
  { intros n X Hn. rewrite (front_sign orient (orient_swap _ Or)) by now rewrite map_length.
    now rewrite <- remove_map. }
  assert (PC : 0 < orient (replace i o (map spot K))).
  { rewrite <- (frame_bary Or _ t i o LK) by (auto; lra). nra. }
  assert (PE : 0 < orient (replace j o (map spot L))).
  { rewrite <- (frame_bary Or _ u j o LL) by (auto; lra). nra. }
  assert (Swap : replace (skip i a) (spot v) (replace i o (map spot K)) =
    replace i o (map spot (replace (skip i a) v K))).
  { rewrite replace_map. symmetry. apply replace_replace. intros Q. symmetry in Q.
    revert Q. apply skip_ne. }
  pose proof (frame_bary Or _ c (skip i a) (spot v) LC ltac:(lra) Hka) as B.
  rewrite Swap, (F i (replace (skip i a) v K)), remove_replace in B
    by (rewrite ?replace_length; lia).
  rewrite (parity_sign f Al _ _ _ P) in B. rewrite F in PE by lia.
  rewrite V in Neg. rewrite !sign_xorb.
  pose proof (sign_square (Nat.odd j)) as S2.
  assert (Q : bary c (skip i a) (spot v) * orient (replace i o (map spot K)) =
    (sign s * (sign (Nat.odd i) * sign (Nat.odd j))) * (sign (Nat.odd j) * f (remove j L))).
  { rewrite B. transitivity ((sign (Nat.odd j) * sign (Nat.odd j)) *
      (sign s * sign (Nat.odd i) * f (remove j L))); [rewrite S2|]; ring. }
  nra.
Qed.
End Permutations.
