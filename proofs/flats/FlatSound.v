(** * What an accepted certificate of points of a plane in space says *)
From Coq Require Import Rbase Rfunctions Lra Lia List ZArith Bool.
From Circumspect Require Import FlatChecker Numbering.
From Circumspect Require Import Definitions Flats Vectors Affine Faces Orientation Integers
  Incidence Accepted Soundness PackedCheck Judged Shadow Picture.
Import ListNotations.
Open Scope R_scope.

(** ** The points in space and in the picture *)

Section Points.
Variables (i : nat) (n : list Z) (m : Z) (r : R).
Hypothesis axis : (i < 3)%nat.
Hypothesis shape : length n = 3%nat.
Hypothesis seen : nth i n 0%Z <> 0%Z.
Notation normal := (integer_point 3 n).
Notation offset := (r * IZR m).

Lemma normal_seen : axis_of i normal <> 0.
Proof.
  destruct n as [|a [|e [|g [|h l]]]]; try discriminate shape.
  destruct i as [|[|[|k]]]; [| | |lia]; cbn in *; unfold axis_of, abscissa, ordinate, height; cbn;
    now apply not_0_IZR.
Qed.
Lemma seen_flat s z : well_shaped 2 s -> inner_product n (coordinates (with_unseen i s z)) = m ->
  flat normal offset (place_of r (with_unseen i s z)).
Proof.
  intros Sh E. apply (f_equal IZR) in E. unfold flat. rewrite <- E. clear E.
  destruct (shape2 s Sh) as (x & y & w & ->).
  destruct n as [|a [|e [|g [|h l]]]]; try discriminate shape.
  rewrite inner_3. destruct i as [|[|[|k]]]; [| | |lia]; cbn; integers; ring.
Qed.
Lemma seen_place s z : well_shaped 2 s -> shadow i (place_of r (with_unseen i s z)) = place_of r s.
Proof.
  intros Sh. destruct (shape2 s Sh) as (x & y & w & ->).
  destruct i as [|[|[|k]]]; [| | |lia]; apply point2_ext; reflexivity.
Qed.
Lemma raised_seen s z : well_shaped 2 s -> inner_product n (coordinates (with_unseen i s z)) = m ->
  raised i normal offset (place_of r s) = place_of r (with_unseen i s z).
Proof.
  intros Sh E. rewrite <- (seen_place s z Sh). apply (raised_shadow _ _ _ normal_seen).
  now apply seen_flat.
Qed.
Lemma height_unseen s z : well_shaped 2 s -> weight s = (- (z * z))%Z ->
  norm2 (@place_of 3 r (with_unseen i s z)) = norm2 (@place_of 2 r s) - r ^ 2 * IZR (weight s).
Proof.
  clear seen shape. intros Sh W. rewrite W. destruct (shape2 s Sh) as (x & y & w & ->).
  rewrite norm2_2, norm2_3.
  destruct i as [|[|[|k]]]; [| | |lia]; cbn; integers; ring.
Qed.
End Points.

Section Flat.
Variables (p : packed) (x : flat_certificate).
Notation c := (unpacked Plane p).
Notation r := (unit_of c).
Notation n := (integer_point 3 (flat_normal x)).
Notation b := (r * IZR (flat_offset x)).
Notation up := (raised (unseen_axis x) n b).
Hypothesis accepts : check Plane c = Accepted.
Hypothesis accepts_flat : check_flat p x = Accepted.

Lemma unseen_spec : forall l zs k, check_unseen p x k l zs = Accepted ->
  length zs = length l /\ forall e z, In (e, z) (combine l zs) -> placed x e z = true /\
    home_vertex e <> None /\ (claimed c = WeightedDelaunay -> weight (position e) = (- (z * z))%Z).
Proof.
  induction l as [|e l IH]; intros [|z zs] k A; cbn [check_unseen] in A; try discriminate.
  - split; [reflexivity|intros e z []].
  - destruct (check_seen p x k e z) eqn:E; [|discriminate]. destruct (IH zs _ A) as [L G].
    split; [cbn; now rewrite L|]. intros e' z' [I|I]; [|now apply G]. injection I as <- <-.
    unfold check_seen in E. destruct (placed x e z) eqn:P; [|discriminate].
    destruct (home_vertex e) eqn:V; [|discriminate]. split; [reflexivity|]. split; [discriminate|].
    cbn [unpacked claimed]. intros W. rewrite W in E.
    destruct (Z.eqb_spec (weight (position e)) (- (z * z))); [assumption|discriminate].
Qed.
Lemma parts_of_flat : (unseen_axis x < 3)%nat /\ length (flat_normal x) = 3%nat /\
  nth (unseen_axis x) (flat_normal x) 0%Z <> 0%Z /\ claimed c <> Delaunay /\
  length (unseen x) = length (points c) /\
  forall e z, In (e, z) (combine (points c) (unseen x)) -> placed x e z = true /\
    home_vertex e <> None /\ (claimed c = WeightedDelaunay -> weight (position e) = (- (z * z))%Z).
Proof.
  pose proof accepts_flat as A. unfold check_flat in A. accepted. apply unseen_spec in A.
  apply andb_prop in Heqb. destruct Heqb as [F Z]. apply andb_prop in F. destruct F as [I L].
  apply Nat.ltb_lt in I. apply Nat.eqb_eq in L. apply negb_true_iff, Z.eqb_neq in Z.
  destruct A as [Len All]. split; [assumption|]. split; [assumption|]. split; [assumption|].
  split; [|split; assumption]. cbn [unpacked claimed]. intros E. now rewrite E in Heqb0.
Qed.

Lemma shaped e : In e (points c) -> well_shaped 2 (position e).
Proof.
  intros I. destruct (points_shaped_distinct (pr := plane_predicates) eq_refl accepts) as [F _].
  rewrite Forall_forall in F. now apply F.
Qed.
Lemma axis_seen : axis_of (unseen_axis x) n <> 0.
Proof. destruct parts_of_flat as (I & L & Z & _). now apply normal_seen. Qed.

Lemma points_up : flat_points c x = map up (points_of_certificate 2 c).
Proof.
  destruct parts_of_flat as (I & L & Z & _ & Len & All).
  unfold flat_points, points_of_certificate. rewrite map_map. pose proof shaped as Sh.
  revert Len All Sh. generalize (points c), (unseen x).
  induction l as [|e l IH]; intros [|z zs] Len All Sh; cbn [combine map]; try discriminate;
    [reflexivity|].
  f_equal.
  - symmetry. apply raised_seen; try assumption; [apply Sh; now left|].
    destruct (All e z (or_introl eq_refl)) as [P _]. now apply Z.eqb_eq in P.
  - apply IH; [now injection Len|intros e' z' Ie; apply All; now right|intros; apply Sh; now right].
Qed.
Lemma simplices_up : flat_simplices c x = map (map up) (simplices_of_certificate 2 c).
Proof.
  unfold flat_simplices, simplices_of_certificate. rewrite map_map. apply map_ext_in.
  intros e Ie. apply in_numbered in Ie. destruct Ie as (t & Et). rewrite map_map.
  apply map_ext_in. intros k Ik.
  destruct (simplex_accepted (pr := plane_predicates) eq_refl accepts t e Et) as (Known & _).
  destruct (Known k Ik) as (q & Eq). rewrite points_up, (spot_numbered 2 c k q Eq).
  apply nth_error_nth. apply (map_nth_error up). unfold points_of_certificate.
  exact (map_nth_error (fun e => @place_of 2 (unit_of c) (position e)) _ _ Eq).
Qed.

Lemma every_point_used q : In q (points_of_certificate 2 c) ->
  exists t, In t (simplices_of_certificate 2 c) /\ In q t.
Proof.
  intros I. apply in_points in I. destruct I as (k & e & E & ->).
  destruct parts_of_flat as (_ & _ & _ & _ & Len & All).
  assert (V : home_vertex e <> None).
  { apply numbered_in in E. destruct (In_nth _ _ e E) as (j & Hj & Ej).
    apply (All e (nth j (unseen x) 0%Z)). rewrite <- Ej at 1. rewrite <- combine_nth by congruence.
    apply nth_In. rewrite combine_length. lia. }
  destruct (check_parts accepts) as (_ & _ & P & _).
  pose proof (each_accepted _ _ P k e E) as U. unfold check_point, used in U.
  rewrite find_simplex in U.
  destruct (numbered (simplices c) (home e)) as [t|] eqn:Et; [|discriminate].
  destruct (home_vertex e) as [j|]; [|contradiction].
  destruct (nth_error (corners t) j) as [v|] eqn:Ev; [|discriminate].
  destruct (Pos.eqb_spec v k) as [->|]; [|discriminate].
  exists (map (Definitions.spot 2 c) (corners t)). split.
  - apply in_map_iff. exists t. split; [reflexivity|]. now apply numbered_in with (home e).
  - rewrite <- (spot_numbered 2 c k e E). apply in_map. now apply nth_error_In with j.
Qed.

Lemma flat_holds : let S := flat_points c x in let T := flat_simplices c x in
  NoDup S /\ lie_in_hyperplane 2 n b S /\
  match claimed c with
  | WeightedDelaunay => flat_delaunay_triangulation 2 S T
  | _ => flat_triangulation 2 S T
  end.
Proof.
  cbv zeta. rewrite points_up, simplices_up. pose proof axis_seen as Ax.
  destruct (check_sound Plane c accepts) as [N Sound]. cbn [dimension_of] in N, Sound.
  destruct parts_of_flat as (I & L & Z & Cl & Len & All).
  assert (F : fills (points_of_certificate 2 c) (simplices_of_certificate 2 c)).
  { destruct (claimed c); [apply Sound|now destruct Cl|]. destruct Sound as ((w & W) & F).
    apply (F w W). }
  assert (Tr : triangulation (points_of_certificate 2 c) (simplices_of_certificate 2 c)).
  { split; [assumption|]. exact every_point_used. }
  split; [now apply NoDup_up|]. split.
  - split; [|split].
    + intros E. apply Ax. rewrite E. unfold axis_of. now destruct (unseen_axis x) as [|[|k]].
    + intros q Iq. apply in_map_iff in Iq. destruct Iq as (q' & <- & _). now apply raised_flat.
    + destruct (sample_accepted (pr := plane_predicates) eq_refl accepts) as (e & Ee & _).
      set (t := map (Definitions.spot 2 c) (corners e)).
      assert (It : In t (simplices_of_certificate 2 c)).
      { apply in_map_iff. exists e. split; [reflexivity|]. now apply numbered_in in Ee. }
      destruct F as (Fl & (Ind & _) & _ & Vs & _). destruct (Fl t It) as [Nt Lt].
      exists (map up t). split; [now apply incl_up, Vs|]. split; [now rewrite map_length|].
      apply independent_up; [assumption|]. apply Ind. split; [assumption|].
      split; [now intros Et; rewrite Et in Lt|]. exists t. split; [assumption|apply incl_refl].
  - pose proof (triangulation_up (unseen_axis x) n b Ax _ _ Tr) as Up.
    destruct (claimed c) eqn:C; [assumption|now destruct Cl|]. split; [assumption|].
    intros t It. apply in_map_iff in It. destruct It as (u & <- & Iu).
    destruct Sound as ((w & W) & Sound). destruct (Sound w W) as [_ D].
    destruct F as (_ & _ & _ & Vs & _).
    apply (delaunay_up (unseen_axis x) n b Ax); [now apply Vs|].
    destruct (D u Iu) as (a & e & On & Below).
    assert (H : forall q, In q (points_of_certificate 2 c) -> norm2 (up q) = norm2 q - w q).
    { intros q Iq. apply in_points in Iq. destruct Iq as (k & en & E & ->).
      pose proof (numbered_in _ _ _ E) as Ie. destruct (In_nth _ _ en Ie) as (j & Hj & Ej).
      set (z := nth j (unseen x) 0%Z).
      destruct (All en z) as (P & _ & We).
      { unfold z. rewrite <- Ej at 1. rewrite <- combine_nth by congruence.
        apply nth_In. rewrite combine_length. lia. }
      apply Z.eqb_eq in P. rewrite (raised_seen _ _ _ _ I L Z _ z (shaped en Ie) P).
      rewrite (W en Ie). apply (height_unseen (unseen_axis x)); try assumption;
        [now apply shaped|now apply We]. }
    exists a, e. split.
    + intros v Iv. rewrite (On v Iv). symmetry. now apply H, (Vs u).
    + intros q Iq. rewrite H by assumption. now apply Below.
Qed.
End Flat.

Theorem judge_flat_sound p x s : judge_flat p x s = Holds ->
  let c := unpacked Plane p in
  let S := flat_points c x in let T := flat_simplices c x in
  NoDup S /\
  lie_in_hyperplane 2 (integer_point 3 (flat_normal x)) (unit_of c * IZR (flat_offset x)) S /\
  match claimed c with
  | WeightedDelaunay => flat_delaunay_triangulation 2 S T
  | _ => flat_triangulation 2 S T
  end.
Proof.
  intros A. unfold judge_flat in A. destruct (judge Plane p None s) eqn:J; try discriminate.
  destruct (check_flat p x) eqn:Fl; [|discriminate].
  destruct (judge_holds Plane p None s J) as [Ac _]. exact (flat_holds p x Ac Fl).
Qed.
