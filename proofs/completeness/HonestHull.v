(** * The hull facets of an honest certificate

    What an honest certificate says of ridges: the cones over the two hull facets are opposite
    ([Ridges.v]), so the checker finds the permutation that it looks for, and each ridge names the
    other in return. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith.
From Circumspect Require Import Checker Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Facets Matched Adjacency.
From Circumspect Require Import Cone Orientation Integers Incidence Honest Permutations ListedMesh.
From Circumspect Require Import HonestMesh.
From Circumspect Require Import Ridges.
Import ListNotations.
Open Scope R_scope.

(** The facet of a cone that lies over a ridge. *)
Lemma ridge_of_cone {d : nat} (X : list (point d)) t (c : frame d) i a o p :
  lists X t -> (i <= d)%nat -> (a < d)%nat -> cone_of t i o c ->
  (In p (facet_of c (skip i a)) <-> p = o \/ In p (remove a (remove i X))).
Proof.
  intros (L & V) Hi Ha C. pose proof (skip_le i a d Ha) as Hk.
  pose proof (remove_length_pred i X d L Hi) as LR. rewrite (in_facet_of _ _ _ Hk). split.
  - intros (m & Hm & N & ->). destruct (Nat.eq_dec m i) as [->|Nm].
    + left. now apply (cone_apex t).
    + right. rewrite (cone_vertex t c i o C m Hm Nm).
      destruct (skip_onto i m d Hm Hi Nm) as (b & Hb & <-).
      assert (Nb : b <> a) by (intros ->; now apply N).
      destruct (skip_onto a b (pred d)) as (e & He & <-); [lia..|assumption|].
      apply nth_error_In with e. rewrite !remove_nth by lia. now apply V.
  - intros [->|I].
    + exists i. split; [assumption|]. split; [intros E; symmetry in E; now apply (skip_ne i a)|].
      symmetry. now apply (cone_apex t).
    + apply In_nth_error in I. destruct I as (e & Ee).
      assert (He : (e < length (remove a (remove i X)))%nat) by (apply nth_error_Some; congruence).
      rewrite (remove_length_pred a (remove i X) (pred d)) in He by lia.
      rewrite !remove_nth in Ee by lia.
      assert (Hae : (skip a e < d)%nat) by (pose proof (skip_le a e (pred d) He); lia).
      exists (skip i (skip a e)). pose proof (skip_le i (skip a e) d Hae) as Hm.
      split; [assumption|]. split.
      * intros E. apply skip_inj in E. now apply (skip_ne a e).
      * rewrite (cone_vertex t c i o C) by auto using skip_ne.
        rewrite V in Ee by assumption. congruence.
Qed.

Section HonestHull.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis Or : oriented orient.
Hypothesis Co : computes orient pr.
Hypothesis not_flat : forall X (t : frame d), lists X t -> orient X <> 0.
Hypothesis positive_d : (1 <= d)%nat.
Variable c : certificate.
Hypothesis H : honest orient c.
Let HL : well_listed orient c := honest_listed _ _ H.
Notation P := (points_of_certificate d c).
Notation spot := (spot d c).
Notation simplex_at t s := (numbered (Definitions.simplices c) t = Some s).
Notation hull_at h f := (numbered (Definitions.hull c) h = Some f).
Notation tets := (numbers (Definitions.simplices c)).
Notation o := (sample_point (d := d) c).
Variable geo : positive -> frame d.
Hypothesis G : described c geo.

Definition cone (t : positive) (i : nat) : frame d := cone_over (geo t) i o.
Notation facet := (hull_facet tets geo (outer tets geo)).

Lemma facet_sample t i : facet t i -> 0 < bary (geo t) i o.
Proof. intros (Ht & Hi & O). exact (sample_inside_facet positive_d c H geo G t i Ht Hi O). Qed.
Lemma facet_cone t i : facet t i -> cone_of (geo t) i o (cone t i).
Proof.
  intros Ft. pose proof (facet_sample t i Ft). apply cone_over_cone; [apply Ft|lra].
Qed.
Lemma facet_supporting : supporting tets geo (outer tets geo) (fun p => In p P).
Proof.
  intros t i Ht Hi O p Hp. exact (hull_supported positive_d c geo G t i p Ht Hi O Hp).
Qed.

Lemma entry_facet h f : hull_at h f -> exists s, simplex_at (Definitions.carrier f) s /\
  nth_error (walls s) (apex f) = Some (OnHull h) /\ facet (Definitions.carrier f) (apex f).
Proof.
  intros E. destruct (honest_hull _ _ H h f E) as (s & Es & W). exists s.
  split; [assumption|]. split; [assumption|].
  destruct (on_hull_outer Co positive_d c H geo G (Definitions.carrier f) s (apex f) h Es W)
    as (Hi &
    O).
  split; [now apply (in_tets c _ s Es)|]. now split.
Qed.
Lemma entry_once h f g f' : hull_at h f -> hull_at g f' ->
  Definitions.carrier f = Definitions.carrier f' ->
  apex f = apex f' -> h = g.
Proof.
  intros E E' C A. destruct (entry_facet h f E) as (s & Es & W & _).
  destruct (entry_facet g f' E') as (s' & Es' & W' & _). congruence.
Qed.

(** A ridge and the one that it names. *)
Lemma ridge_named h f s a g b : hull_at h f -> simplex_at (Definitions.carrier f) s ->
  nth_error (ridges f) a = Some (g, b) -> exists f' s', hull_at g f' /\
    simplex_at (Definitions.carrier f') s' /\ (a < d)%nat /\ (b < d)%nat /\
    shared (remove a (remove (apex f) (corners s))) (remove b (remove (apex f') (corners s'))) /\
    opposite (cone (Definitions.carrier f) (apex f)) (skip (apex f) a)
             (cone (Definitions.carrier f') (apex f')) (skip (apex f') b).
Proof.
  intros Ef Es Er. destruct (honest_ridge _ _ H h f s a g b Ef Es Er)
    as (N & f' & s' & Ef' & Es' & S). exists f', s'.
  split; [assumption|]. split; [assumption|].
  destruct (entry_facet h f Ef) as (s2 & Es2 & _ & Ft). replace s2 with s in * by congruence.
  destruct (entry_facet g f' Ef') as (s3 & Es3 & _ & Fu). replace s3 with s' in * by congruence.
  clear s2 s3 Es2 Es3. pose proof Ft as (_ & Hi & _). pose proof Fu as (_ & Hj & _).
  pose proof (corners_length c geo G _ s Es) as L.
  pose proof (corners_length c geo G _ s' Es') as L'.
  assert (Ha : (a < d)%nat).
  { rewrite <- (honest_ridges _ _ H h f Ef). apply nth_error_Some. congruence. }
  assert (Hb : (b < d)%nat).
  { destruct (lt_dec b d) as [|Nb]; [assumption|exfalso].
    pose proof (remove_length_pred _ _ d L Hi) as LR.
    pose proof (remove_length_pred _ _ d L' Hj) as LR'.
    rewrite (remove_none b) in S by lia.
    assert (I : incl (remove (apex f') (corners s')) (remove a (remove (apex f) (corners s))))
      by (intros k; apply S).
    apply NoDup_incl_length in I;
      [|apply remove_NoDup; exact (corners_NoDup c geo G _ s' Es')].
    rewrite (remove_length_pred a _ (pred d)) in I by lia. lia. }
  split; [assumption|]. split; [assumption|]. split; [assumption|].
  apply (ridge_sides tets geo P positive_d (described_agree _ _ G) (described_different _ _ G)
    (described_in _ _ G) facet_supporting o cone facet_sample facet_cone);
    auto using skip_le.
  - intros [Ec Ea]. apply N. now apply (entry_once h f g f').
  - pose proof (described_frame _ _ G _ s Es) as LK.
    pose proof (described_frame _ _ G _ s' Es') as LL.
    split; intros p;
      rewrite (ridge_of_cone _ _ _ _ a o p LK Hi Ha (facet_cone _ _ Ft)),
        (ridge_of_cone _ _ _ _ b o p LL Hj Hb (facet_cone _ _ Fu)), <- !remove_map, !in_map_iff;
      (intros [->|(k & <- & I)]; [now left|right; exists k; split; [reflexivity|now apply S]]).
Qed.
Lemma ridge_matched h f s a g b f' s' : hull_at h f -> simplex_at (Definitions.carrier f) s ->
  nth_error (ridges f) a = Some (g, b) -> hull_at g f' -> simplex_at (Definitions.carrier f') s' ->
  matched_ridge (remove (apex f) (corners s)) (remove (apex f') (corners s'))
    (apex f) (apex f') a b = true.
Proof.
  intros Ef Es Er Ef' Es'. destruct (ridge_named h f s a g b Ef Es Er)
    as (f2 & s2 & Ef2 & Es2 & Ha & Hb & S & O).
  replace f2 with f' in * by congruence. replace s2 with s' in * by congruence.
  clear f2 s2 Ef2 Es2.
  destruct (entry_facet h f Ef) as (_ & _ & _ & Ft).
  destruct (entry_facet g f' Ef') as (_ & _ & _ & Fu).
  pose proof Ft as (_ & Hi & _). pose proof Fu as (_ & Hj & _).
  apply (opposite_matched_ridge Or spot (corners s) (corners s') (geo (Definitions.carrier f))
    (geo (Definitions.carrier f')) (apex f) (apex f')
    (described_frame _ _ G _ s Es) (described_frame _ _ G _ s' Es')
    (positive_listed not_flat c HL geo G _ s Es) (positive_listed not_flat c HL geo G _ s' Es')
    (corners_NoDup c geo G _ s Es) (corners_NoDup c geo G _ s' Es') Hi Hj a b
    (cone (Definitions.carrier f) (apex f)) (cone (Definitions.carrier f') (apex f')) o); auto using
      facet_sample, facet_cone.
  destruct O as (_ & Hl & _ & _ & Neg).
  rewrite (cone_vertex _ _ _ _ (facet_cone _ _ Fu)) in Neg; auto using skip_ne.
Qed.
Lemma ridge_back h f s a g b f' : hull_at h f -> simplex_at (Definitions.carrier f) s ->
  nth_error (ridges f) a = Some (g, b) -> hull_at g f' -> nth_error (ridges f') b = Some (h, a).
Proof.
  intros Ef Es Er Ef'. destruct (ridge_named h f s a g b Ef Es Er)
    as (f2 & s' & Ef2 & Es' & Ha & Hb & _ & O).
  replace f2 with f' in * by congruence. clear f2 Ef2.
  destruct (nth_error (ridges f') b) as [[h' a']|] eqn:Er'.
  - destruct (ridge_named g f' s' b h' a' Ef' Es' Er')
      as (f2 & s2 & Ef2 & Es2 & Ha' & _ & _ & O').
    destruct (entry_facet h f Ef) as (_ & _ & _ & Ft).
    destruct (entry_facet h' f2 Ef2) as (_ & _ & _ & Ft').
    apply opposite_sym in O'.
    destruct (ridge_of_two tets geo P positive_d (described_agree _ _ G)
      (described_different _ _ G) (described_in _ _ G) facet_supporting o cone facet_sample
      facet_cone _ _ _ _ _ _ _ _ _ Ft Ft' O O') as (Ec & Ea & Ek).
    rewrite <- Ea in Ek. apply skip_inj in Ek. subst a'.
    now rewrite (entry_once h f h' f2 Ef Ef2 Ec Ea).
  - apply nth_error_None in Er'. rewrite (honest_ridges _ _ H g f' Ef') in Er'. lia.
Qed.
End HonestHull.
