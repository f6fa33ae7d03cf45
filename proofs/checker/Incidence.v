(** * From index lists to facets and ridges that are matched

    A simplex is listed as numbers of points; [spot k] is the point with number k.  If its points
    have positive orientation it has a frame, and barycentric coordinates are quotients of
    orientations ([frame_bary]).  So which side of a facet a point is on is told by a permutation's
    parity: the conditions [facet-matched] and [ridge-matched] of the checker say that facets of
    simplices, and of cones, are opposite ([facets_opposite], [ridges_opposite]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Checker Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Matched Cone Orientation.
Import ListNotations.
Open Scope R_scope.

Section Incidence.
Context {d : nat} {orient : list (point d) -> R}.
Hypothesis Or : oriented orient.

(** [X] lists the vertices of [t]. *)
Definition lists (X : list (point d)) (t : frame d) : Prop :=
  length X = S d /\ forall i, (i <= d)%nat -> nth_error X i = Some (vertex t i).

Lemma lists_in X t p : lists X t -> (In p X <-> exists i, (i <= d)%nat /\ p = vertex t i).
Proof.
  intros (L & N). split.
  - intros I. apply In_nth_error in I. destruct I as (i & E).
    assert (i <= d)%nat. { assert (nth_error X i <> None) by congruence.
      apply nth_error_Some in H. lia. }
    exists i. split; [assumption|]. rewrite N in E by assumption. congruence.
  - intros (i & Hi & ->). apply nth_error_In with i. auto.
Qed.
Lemma lists_vertices X t : lists X t -> vertices t = X.
Proof.
  intros (L & N). unfold vertices. rewrite <- L in *.
  assert (G : forall Y s, (forall i, (i < length Y)%nat -> nth_error Y i = Some (vertex t (s + i)))
    -> map (vertex t) (seq s (length Y)) = Y).
  { clear. induction Y as [|y Y IH]; intros s H; cbn; [reflexivity|]. f_equal.
    - specialize (H O ltac:(cbn; lia)). cbn in H. rewrite Nat.add_0_r in H. congruence.
    - apply IH. intros i Hi. rewrite Nat.add_succ_comm. apply (H (S i)). cbn. lia. }
  apply G. intros i Hi. apply N. lia.
Qed.

Lemma lists_exists X : orient X <> 0 -> exists t, lists X t.
Proof.
  intros N. destruct (orient_frame _ Or X N) as (t & V & _). exists t. split; [|exact V].
  now apply (orient_length _ Or).
Qed.

(** Barycentric coordinates are quotients of orientations. *)
Lemma frame_bary X t i p : lists X t -> orient X <> 0 -> (i <= d)%nat ->
  bary t i p * orient X = orient (replace i p X).
Proof.
  intros (L & V) N Hi. destruct (orient_frame _ Or X N) as (u & W & B).
  transitivity (bary u i p * orient X); [|rewrite B by assumption; now field]. f_equal.
  assert (E : forall k, (k <= d)%nat -> vertex t k = vertex u k).
  { intros k Hk. specialize (V k Hk). specialize (W k Hk). congruence. }
  rewrite (interpolation u (bary t i) p (bary_affine t i Hi)). unfold sum.
  rewrite (sum_one _ _ i); [|apply seq_NoDup|now apply in_seq_d|].
  - rewrite <- E, bary_own by assumption. ring.
  - intros k Hk Nk. apply in_seq_d in Hk. rewrite <- E, bary_other by auto. ring.
Qed.

(** Two facets with the same vertices and with the apex of the second beyond the first. *)
Lemma opposite_intro X Y t u i j : lists X t -> lists Y u -> (i <= d)%nat -> (j <= d)%nat ->
  (forall p, In p (replace i (vertex u j) X) <-> In p Y) -> bary t i (vertex u j) < 0 ->
  opposite t i u j.
Proof.
  intros LX LY Hi Hj E Neg. pose proof (proj1 LX) as Len.
  split; [|split; [|split; [|split]]]; auto.
  - intros k Hk N.
    assert (I : In (vertex t k) Y).
    { apply E. apply nth_error_In with k. rewrite replace_other by assumption.
      now apply LX. }
    apply (lists_in Y u _ LY) in I. destruct I as (l & Hl & El). exists l.
    repeat split; auto. intros ->. rewrite <- El in Neg. rewrite bary_other in Neg by auto. lra.
  - intros l Hl N.
    assert (I : In (vertex u l) (replace i (vertex u j) X)).
    { apply E. apply (lists_in Y u _ LY). eauto. }
    apply In_nth_error in I. destruct I as (k & Ek).
    assert (Hk : (k <= d)%nat).
    { assert (K : nth_error (replace i (vertex u j) X) k <> None) by congruence.
      apply nth_error_Some in K. rewrite replace_length in K. lia. }
    destruct (Nat.eq_dec k i) as [->|Nk].
    + rewrite replace_same in Ek by lia. injection Ek as Ek. apply vertex_inj in Ek; congruence.
    + rewrite replace_other in Ek by assumption. exists k. repeat split; auto.
      rewrite (proj2 LX k Hk) in Ek. congruence.
Qed.

(** ** Lists of numbers *)

Variable spot : positive -> point d.

Lemma spots_in k l s : parity k l = Some s ->
  forall p, In p (map spot k) <-> In p (map spot l).
Proof.
  intros E p. rewrite !in_map_iff. pose proof (parity_in k l s E) as P.
  split; intros (x & Hx & I); exists x; split; auto; now apply P.
Qed.

Theorem facets_opposite K L t u i j : lists (map spot K) t -> lists (map spot L) u ->
  0 < orient (map spot K) -> 0 < orient (map spot L) -> (i <= d)%nat ->
  matched_facet K L i j = true -> opposite t i u j.
Proof.
  intros LK LL PK PL Hi M. unfold matched_facet in M.
  destruct (nth_error L j) as [v|] eqn:Ev; [|discriminate].
  destruct (parity (replace i v K) L) as [[|]|] eqn:P; try discriminate.
  assert (Hj : (j <= d)%nat).
  { assert (N : nth_error L j <> None) by congruence. apply nth_error_Some in N.
    pose proof (proj1 LL) as Len. rewrite map_length in Len. lia. }
  assert (V : vertex u j = spot v).
  { pose proof (proj2 LL j Hj) as E. rewrite (map_nth_error spot j L Ev) in E. congruence. }
  apply (opposite_intro (map spot K) (map spot L)); auto.
  - rewrite V, <- replace_map. apply (spots_in _ _ _ P).
  - pose proof (frame_bary _ t i (vertex u j) LK ltac:(lra) Hi) as B.
    rewrite V, <- replace_map in B.
    rewrite (parity_sign (fun l => orient (map spot l))
      (alternating_map spot _ (orient_swap _ Or)) _ _ _ P) in B.
    cbn in B. rewrite V. nra.
Qed.

(** ** Cones *)

Lemma cone_lists X t i o c : lists X t -> (i <= d)%nat -> cone_of t i o c ->
  lists (replace i o X) c.
Proof.
  intros (L & V) Hi C. split; [now rewrite replace_length|]. intros k Hk.
  rewrite C by assumption. destruct (Nat.eq_dec k i) as [->|N].
  - apply replace_same. lia.
  - rewrite replace_other by assumption. auto.
Qed.

Theorem ridges_opposite K L t u i j a b c e o : lists (map spot K) t -> lists (map spot L) u ->
  0 < orient (map spot K) -> 0 < orient (map spot L) -> (i <= d)%nat -> (j <= d)%nat ->
  0 < bary t i o -> 0 < bary u j o -> cone_of t i o c -> cone_of u j o e -> (a < d)%nat ->
  matched_ridge (remove i K) (remove j L) i j a b = true ->
  opposite c (skip i a) e (skip j b).
Proof.
  intros LK LL PK PL Hi Hj Bi Bj C E Ha M. unfold matched_ridge in M.
  destruct (nth_error (remove j L) b) as [v|] eqn:Ev; [|discriminate].
  destruct (parity (replace a v (remove i K)) (remove j L)) as [s|] eqn:P; [|discriminate].
  pose proof (proj1 LK) as LenK. rewrite map_length in LenK.
  pose proof (proj1 LL) as LenL. rewrite map_length in LenL.
  assert (Hb : (b < d)%nat).
  { assert (N : nth_error (remove j L) b <> None) by congruence. apply nth_error_Some in N.
    pose proof (remove_length j L ltac:(lia)). lia. }
  pose proof (skip_le i a d Ha) as Hka. pose proof (skip_le j b d Hb) as Hkb.
  pose proof (cone_lists _ _ _ _ _ LK Hi C) as LC. pose proof (cone_lists _ _ _ _ _ LL Hj E) as LE.
  assert (V : vertex e (skip j b) = spot v).
  { rewrite (cone_vertex u e j o E) by auto using skip_ne.
    rewrite remove_nth in Ev by lia.
    pose proof (proj2 LL (skip j b) Hkb) as Q. rewrite (map_nth_error spot _ L Ev) in Q.
    congruence. }
  (* the simplex with o in the place of vertex i, as a function of the other vertices *)
  set (f l := orient (o :: map spot l)).
  assert (Al : alternating f).
  { apply (alternating_map spot (fun l => orient (o :: l))), alternating_cons, (orient_swap _ Or). }
  assert (F : forall n X, (n < length X)%nat ->
    orient (replace n o (map spot X)) = sign (Nat.odd n) * f (remove n X)).
  { intros n X Hn. rewrite (front_sign orient (orient_swap _ Or)) by now rewrite map_length.
    now rewrite <- remove_map. }
  assert (PC : 0 < orient (replace i o (map spot K))).
  { rewrite <- (frame_bary _ t i o LK) by (auto; lra). nra. }
  assert (PE : 0 < orient (replace j o (map spot L))).
  { rewrite <- (frame_bary _ u j o LL) by (auto; lra). nra. }
  assert (Swap : replace (skip i a) (spot v) (replace i o (map spot K)) =
    replace i o (map spot (replace (skip i a) v K))).
  { rewrite replace_map. symmetry. apply replace_replace. intros Q. symmetry in Q.
    revert Q. apply skip_ne. }
  apply (opposite_intro _ _ c e (skip i a) (skip j b) LC LE Hka Hkb); rewrite V.
  - intros p. rewrite Swap. rewrite !in_replace by (rewrite map_length, ?replace_length; lia).
    rewrite <- !remove_map, remove_replace by lia. now rewrite (spots_in _ _ _ P p).
  - pose proof (frame_bary _ c (skip i a) (spot v) LC ltac:(lra) Hka) as B.
    rewrite Swap, (F i (replace (skip i a) v K)), remove_replace in B
      by (rewrite ?replace_length; lia).
    rewrite (parity_sign f Al _ _ _ P) in B.
    rewrite F in PE by lia. cbv beta in B.
    assert (S1 : sign s * sign (Nat.odd i) * sign (Nat.odd j) = -1).
    { rewrite Rmult_assoc, <- !sign_xorb, M. reflexivity. }
    assert (Q : bary c (skip i a) (spot v) * orient (replace i o (map spot K)) =
      - (sign (Nat.odd j) * f (remove j L))).
    { rewrite B. pose proof (sign_square (Nat.odd j)) as S2.
      transitivity (sign s * sign (Nat.odd i) * (sign (Nat.odd j) * sign (Nat.odd j))
        * f (remove j L)); [rewrite S2; ring|].
      transitivity ((sign s * sign (Nat.odd i) * sign (Nat.odd j)) * sign (Nat.odd j)
        * f (remove j L)); [ring|]. rewrite S1. ring. }
    nra.
Qed.
End Incidence.
