(** * What an accepted refutation of a surface says *)
From Coq Require Import Rbase Rfunctions Lra List Arith Lia ZArith Bool.
From Circumspect Require Import SurfaceRefutation Numbering.
From Circumspect Require Import Definitions Surfaces Vectors Faces Orientation Integers
  RefutationSigns CallerMesh EvidenceSound Angles.
Import ListNotations.
Open Scope R_scope.

Lemma mapped_at {A B} (f : A -> B) l k y : nth_error (map f l) k = Some y ->
  exists x, nth_error l k = Some x /\ y = f x.
Proof.
  rewrite nth_error_map. destruct (nth_error l k) as [x|]; [|discriminate]. intros E.
  injection E as <-. eauto.
Qed.

(** The rule contradicts the claim. *)
Lemma edge_no_claim {d} (S : list (point d)) L : edge_not_delaunay L -> ~ claims_surface S L.
Proof.
  intros (i & j & s & t & p & q & a & b & N & [Dif Two] & Es & Et & _ & _ & _ & _ & Os & Ot & Neg)
    (T & -> & H).
  assert (At : forall k r, nth_error (map (map Some) T) k = Some (map Some r) ->
    nth_error T k = Some r).
  { intros k r E. apply mapped_at in E. destruct E as (u & E & Eu).
    apply Breach.map_some_inj in Eu. rewrite Eu. exact E. }
  assert (0 <= signed_cos2 a p q + signed_cos2 b p q); [|lra].
  apply (angles_small S T H i j s t p q a b N); auto. split; [assumption|]. intros k.
  rewrite <- Two. split.
  - intros (r & E & Ip & Iq). exists (map Some r).
    split; [exact (map_nth_error (map Some) k T E)|]. split; now apply in_map.
  - intros (r & E & Ip & Iq). apply mapped_at in E. destruct E as (u & E & ->). exists u.
    split; [assumption|]. apply in_map_iff in Ip, Iq.
    destruct Ip as (v & Ev & Ip), Iq as (w & Ew & Iq).
    injection Ev as ->. injection Ew as ->. now split.
Qed.

Section Refuted.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis M : forall r, 0 < r -> measured orient pr r.
Variables (m : refutation) (ti uj : positive * nat).
Notation r := (refuted_unit m).
Hypothesis accepted : refute_surface_in pr m ti uj = true.
Notation place := (@place_of d r).
Notation entry_of := (@caller_entry d r (sites m)).
Notation LS := (@caller_rows d r (sites m) (rows m)).
Notation points_table := (Table.of_list id (sites m)).

Notation find_site := (find_id (sites m)).
Notation find_row := (find_id (rows m)).

Lemma parts : 0 < r /\ Forall (well_shaped d) (sites m) /\ wide_at m ti uj = true.
Proof.
  pose proof accepted as A. unfold refute_surface_in in A. rewrite !andb_true_iff in A.
  destruct A as [[[Pn Pd] Ss] W]. apply Z.ltb_lt, IZR_lt in Pn, Pd.
  assert (U : 0 < r) by (unfold refuted_unit; now apply Rdiv_lt_0_compat).
  split; [assumption|]. split; [|assumption]. apply Forall_forall. intros s I.
  rewrite forallb_forall in Ss. specialize (Ss s I). unfold shaped in Ss. apply Nat.eqb_eq in Ss.
  now rewrite (dimension_d (M r U)) in Ss.
Qed.
Notation unit_positive := (proj1 parts).
Notation shaped_sites := (proj1 (proj2 parts)).

(** A triangle, as the evidence names it. *)
Record shown (tk : positive * nat) (X : list site) (o p q : site) : Prop := {
  shown_row : nth_error LS (pred (Pos.to_nat (fst tk))) = Some (map Some (map place X));
  shown_sites : incl X (sites m);
  shown_proper : on_no_line X = true;
  shown_split : split3 (snd tk) X = Some (o, p, q)
}.
Lemma side_at_shown tk f : side_at m tk f = true ->
  exists X o p q, shown tk X o p q /\ f o p q = true.
Proof.
  unfold side_at. intros H.
  apply (row_at_in (M r unit_positive) (sites m) (rows m) _ _ shaped_sites find_site find_row) in H.
  destruct H as (x & E & _ & H). apply andb_prop in H. destruct H as [_ H].
  destruct (all_named _ x) as [X|] eqn:A; [|discriminate].
  apply andb_prop in H. destruct H as [Nl H].
  destruct (split3 (snd tk) X) as [[[o p] q]|] eqn:S; [|discriminate].
  apply (all_named_rows (M r unit_positive) (sites m) (rows m) _ (Table.of_list id (rows m))
    shaped_sites find_site find_row) in A. destruct A as [A I].
  exists X, o, p, q. split; [|assumption]. split; auto. rewrite <- A.
  unfold caller_rows. now apply (map_nth_error (map entry_of)).
Qed.
Lemma shown_facts tk X o p q : shown tk X o p q -> Forall (well_shaped d) X /\
  length (map place X) = 3%nat /\ affinely_independent (map place X) /\ place p <> place q /\
  opposite (map place X) (place p) (place q) (place o) /\ In p X /\ In q X /\
  (0 < snd (cotangent o p q))%Z.
Proof.
  intros [_ I L S].
  assert (Sh : Forall (well_shaped d) X) by (eapply incl_Forall; eauto using shaped_sites).
  destruct (on_no_line_independent r unit_positive X Sh L) as [Le In_].
  destruct (on_no_line_split r unit_positive X _ o p q Sh L S) as [C _].
  destruct (split3_three _ _ _ _ _ S) as (_ & _ & J & _).
  assert (Io : In o X /\ In p X /\ In q X) by (repeat split; apply J; auto).
  pose proof (independent_NoDup _ In_) as N.
  assert (S' : split3 (snd tk) (map place X) = Some (place o, place p, place q)).
  { clear - S. destruct X as [|a [|b [|e [|? ?]]]]; try discriminate.
    destruct (snd tk) as [|[|[|k]]]; try discriminate; cbn in S |- *; now injection S as <- <- <-. }
  destruct (split3_three _ _ _ _ _ S') as (_ & _ & _ & D). destruct (D N) as (D1 & D2 & D3).
  destruct Io as (Io & Ip & Iq).
  split; [assumption|]. split; [now rewrite map_length|]. repeat (split; [assumption|]).
  split; [|auto]. split; [now apply in_map|now split].
Qed.

Lemma no_third_spec t u p q l : forall k, no_third m t u p q k l = true ->
  forall i x, nth_error l i = Some x -> has_edge m p q x = true ->
  Pos.of_nat (Pos.to_nat k + i) = t \/ Pos.of_nat (Pos.to_nat k + i) = u.
Proof.
  induction l as [|y l IH]; intros k H [|i] x E Ed; try discriminate; cbn [no_third] in H;
    apply andb_prop in H; destruct H as [H H'].
  - injection E as ->. rewrite Ed in H. cbn in H. rewrite orb_false_r in H.
    rewrite Nat.add_0_r, Pos2Nat.id. apply orb_prop in H.
    destruct H as [H|H]; apply Pos.eqb_eq in H; auto.
  - replace (Pos.to_nat k + S i)%nat with (Pos.to_nat (Pos.succ k) + i)%nat by lia.
    now apply (IH _ H' i x).
Qed.
Lemma entry_lists p x : In p (sites m) -> In (Some (place p)) (map entry_of x) ->
  lists points_table p x = true.
Proof.
  intros Ip I. apply in_map_iff in I. destruct I as (n & E & In_).
  pose proof (caller_named (M r unit_positive) (sites m) (rows m) _ (Table.of_list id (rows m))
    shaped_sites find_site find_row n) as C. rewrite C in E.
  destruct (named points_table n) as [s|] eqn:Es; [|discriminate]. injection E as E.
  unfold lists. apply existsb_exists. exists n. split; [assumption|]. rewrite Es.
  pose proof shaped_sites as Sh. rewrite Forall_forall in Sh.
  apply (same_place_place (M r unit_positive)); [now apply Sh| |congruence].
  apply Sh. exact (named_in (M r unit_positive) (sites m) (rows m) _ (Table.of_list id (rows m))
    shaped_sites find_site find_row n s Es).
Qed.

Theorem edge_shown : edge_not_delaunay LS.
Proof.
  destruct parts as (U & Sh & W). unfold wide_at in W. apply andb_prop in W. destruct W as [Dif W].
  apply negb_true_iff, Pos.eqb_neq in Dif.
  apply side_at_shown in W. destruct W as (X & a & p & q & SX & W).
  apply side_at_shown in W. destruct W as (Y & b & p' & q' & SY & W).
  rewrite !andb_true_iff in W. destruct W as [[En Wide] No].
  destruct (shown_facts _ _ _ _ _ SX) as (ShX & LX & IX & Npq & OX & Ip & Iq & CX).
  destruct (shown_facts _ _ _ _ _ SY) as (ShY & LY & IY & _ & OY & Ip' & Iq' & CY).
  pose proof (proj1 (Forall_forall _ _) ShX) as WX.
  pose proof (proj1 (Forall_forall _ _) ShY) as WY.
  assert (Same : forall s u, In s X -> In u Y -> same_place s u = true -> place s = place u).
  { intros s u Is Iu E. apply (same_place_place (M r U)); auto. }
  assert (Ends : place p = place p' /\ place q = place q' \/
    place p = place q' /\ place q = place p').
  { unfold same_ends in En. apply orb_prop in En.
    destruct En as [En|En]; apply andb_prop in En; destruct En; [left|right]; split; auto. }
  assert (Angle : signed_cos2 (place a) (place p) (place q) +
    signed_cos2 (place b) (place p) (place q) < 0).
  { assert (E : signed_cos2 (place b) (place p) (place q) =
      signed_cos2 (place b) (place p') (place q')).
    { destruct Ends as [[-> ->]|[-> ->]]; [reflexivity|apply angle_sym]. }
    rewrite E. apply Rnot_le_lt. intros H. apply negb_true_iff in Wide.
    destruct (split3_three _ _ _ _ _ (shown_split _ _ _ _ _ SX)) as (_ & _ & JX & _).
    destruct (split3_three _ _ _ _ _ (shown_split _ _ _ _ _ SY)) as (_ & _ & JY & _).
    assert (at_most_pi (cotangent a p q) (cotangent b p' q') = true); [|congruence].
    apply (angles_decided (d := d) r U); try assumption.
    intros s [<-|[<-|[<-|[<-|[<-|[<-|[]]]]]]]; try (apply WX, JX; auto; fail);
      apply WY, JY; auto. }
  exists (pred (Pos.to_nat (fst ti))), (pred (Pos.to_nat (fst uj))), (map place X), (map place Y),
    (place p), (place q), (place a), (place b).
  assert (OY' : opposite (map place Y) (place p) (place q) (place b)).
  { destruct Ends as [[-> ->]|[-> ->]]; [assumption|]. destruct OY as (A & B & C). now split. }
  assert (On : forall Z : list site, In (place p) (map place Z) -> In (place q) (map place Z) ->
    In (Some (place p)) (map Some (map place Z)) /\ In (Some (place q)) (map Some (map place Z))).
  { intros Z A B. split; now apply in_map. }
  split; [assumption|]. split; 
    [|repeat split; try assumption; try apply SX; try apply SY; apply OX || apply OY'].
  split; [lia|]. intros k. split.
  - intros (x & E & A & B). apply mapped_at in E. destruct E as (y & Ey & ->).
    assert (Ed : has_edge m p q y = true).
    { unfold has_edge. rewrite !entry_lists; auto; now apply (shown_sites _ _ _ _ _ SX). }
    destruct (no_third_spec _ _ _ _ _ _ No k y Ey Ed) as [<-|<-]; [left|right];
      rewrite Nat2Pos.id; lia.
  - intros [->| ->].
    + exists (map Some (map place X)). split; [apply SX|]. apply On; now apply in_map.
    + exists (map Some (map place Y)). split; [apply SY|]. apply On;
        destruct Ends as [[E1 E2]|[E1 E2]]; rewrite ?E1, ?E2; now apply in_map.
Qed.
End Refuted.

(** Whatever is accepted: the claim is false, because the edge is not Delaunay. *)
Theorem refute_surface_rule D x : refute_surface D x = true ->
  edge_not_delaunay (refuted_simplices D (surface_mesh x)) /\
  ~ claims_surface (refuted_points D (surface_mesh x)) (refuted_simplices D (surface_mesh x)).
Proof.
  intros A. assert (E : edge_not_delaunay (refuted_simplices D (surface_mesh x))).
  { destruct D;
      [exact (edge_shown measured_plane _ _ _ A)|exact (edge_shown measured_space _ _ _ A)]. }
  split; [assumption|]. now apply edge_no_claim.
Qed.
