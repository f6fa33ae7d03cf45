(** * What the acceptance of a refutation means

    The evidence of an accepted refutation shows a broken rule of the caller's own points and
    simplices ([evidence_breach]); and so they are not what they claim to be ([refute_sound]).
    Nothing is assumed of the caller's mesh. *)
From Coq Require Import Rbase Rfunctions Lra Lia List Arith ZArith Bool.
From Circumspect Require Import Refutation Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Faces LiftingMap Breach.
From Circumspect Require Import Orientation Integers RefutationSigns CallerMesh EvidenceSound
  Broken.
Import ListNotations.
Open Scope R_scope.

(** ** The whole *)

Section Whole.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis M : forall r, 0 < r -> measured orient pr r.
Variable c : refutation.
Hypothesis accepted : refute_in pr c = true.

Let r := refuted_unit c.
Let P := map (site_for (refuted c)) (sites c).

Lemma place_site_for p : @place_of d r (site_for (refuted c) p) = place_of r p.
Proof. unfold site_for. now destruct (weights_of (refuted c)). Qed.
Lemma points_site_for : @caller_points d r P = caller_points r (sites c).
Proof. unfold caller_points, P. rewrite map_map. apply map_ext, place_site_for. Qed.
Lemma rows_site_for : @caller_rows d r P (rows c) = caller_rows r (sites c) (rows c).
Proof.
  unfold caller_rows. apply map_ext. intros x. apply map_ext. intros [k|]; [|reflexivity].
  cbn. unfold P, numbered. rewrite nth_error_map.
  destruct (nth_error (sites c) _); [|reflexivity]. cbn. now rewrite place_site_for.
Qed.

Lemma sites_shaped : 0 < r -> forallb (shaped pr) (sites c) = true -> Forall (well_shaped d) P.
Proof.
  intros Pr Sh. apply Forall_forall. intros p Hp. apply in_map_iff in Hp.
  destruct Hp as (q & <- & Hq). rewrite forallb_forall in Sh. specialize (Sh q Hq).
  apply Nat.eqb_eq in Sh. rewrite (dimension_d (M r Pr)) in Sh.
  unfold well_shaped, site_for. now destruct (weights_of (refuted c)).
Qed.
Lemma sites_found k : Table.find k (Table.of_list (site_for (refuted c)) (sites c)) =
  numbered P k.
Proof. rewrite table_find. unfold P, numbered. now rewrite nth_error_map. Qed.

Lemma rows_found t : Table.find t (Table.of_list (@Datatypes.id row) (rows c)) =
  numbered (rows c) t.
Proof. rewrite table_find. now destruct (numbered _ _). Qed.

Theorem accepted_breach (w : point d -> R) :
  (refuted c = WeightedDelaunay ->
   forall p, In p (sites c) -> w (place_of r p) = r ^ 2 * IZR (weight p)) ->
  concerns (because c) (refuted c) = true /\
  broken (refuted c) (lifted (refuted c) w) (caller_points r (sites c))
    (caller_rows r (sites c) (rows c)) (rule_of (because c)).
Proof.
  intros W. assert (A := accepted). unfold refute_in in A. rewrite !andb_true_iff in A.
  destruct A as [[[[[Co Pn] Pd] Sh] _] H]. split; [assumption|].
  rewrite <- points_site_for, <- rows_site_for.
  apply Z.ltb_lt, IZR_lt in Pn, Pd.
  assert (Pr : 0 < r) by (unfold r, refuted_unit; now apply Rdiv_lt_0_compat).
  pose proof (sites_shaped Pr Sh). pose proof sites_found.
  eapply (evidence_breach (M r Pr)); try eassumption.
  - exact rows_found.
  - intros p Hp. apply in_map_iff in Hp. destruct Hp as (q & <- & Hq).
    rewrite place_site_for. unfold height_of. rewrite place_site_for. unfold lifted, site_for.
    destruct (refuted c); cbn [weights_of weight]; [ring..|]. now rewrite W.
  - now intros ->.
Qed.

(** Whatever the weights are. *)
Theorem accepted_spans : spans (@caller_points d r (sites c)).
Proof.
  assert (A := accepted). unfold refute_in in A. rewrite !andb_true_iff in A.
  destruct A as [[[[[_ Pn] Pd] Sh] Ba] _]. rewrite <- points_site_for.
  apply Z.ltb_lt, IZR_lt in Pn, Pd.
  assert (Pr : 0 < r) by (unfold r, refuted_unit; now apply Rdiv_lt_0_compat).
  exact (basis_spans (M r Pr) P _ _ _ (sites_shaped Pr Sh) sites_found rows_found (basis c) Ba).
Qed.
Theorem accepted_refuted (w : point d -> R) :
  (refuted c = WeightedDelaunay ->
   forall p, In p (sites c) -> w (place_of r p) = r ^ 2 * IZR (weight p)) ->
  ~ claims (refuted c) w (caller_points r (sites c)) (caller_rows r (sites c) (rows c)).
Proof. intros W. destruct (accepted_breach w W) as (C & B). eapply broken_refutes; eassumption. Qed.
End Whole.

(** The caller's points span R^d, ... *)
Theorem refute_spans D c : refute D c = true -> spans (refuted_points D c).
Proof.
  intros A. unfold refuted_points.
  destruct D; cbn [dimension_of] in *.
  - now apply (accepted_spans measured_plane c).
  - now apply (accepted_spans measured_space c).
Qed.
(** ... and what he has claimed is not so. *)
Theorem refute_sound D c : refute D c = true -> ~ refuted_claim D c.
Proof.
  intros A. unfold refuted_claim, refuted_weights, refuted_points, refuted_simplices.
  assert (H : forall w : point (dimension_of D) -> R, (refuted c = WeightedDelaunay -> forall p,
      In p (sites c) -> w (place_of (refuted_unit c) p) = refuted_unit c ^ 2 * IZR (weight p)) ->
    ~ claims (refuted c) w (caller_points (refuted_unit c) (sites c))
        (caller_rows (refuted_unit c) (sites c) (rows c))).
  { destruct D; cbn [dimension_of] in *; intros w.
    - now apply (accepted_refuted measured_plane c).
    - now apply (accepted_refuted measured_space c). }
  destruct (refuted c); cbn [claims] in H.
  - apply (H (fun _ => 0)). discriminate.
  - apply (H (fun _ => 0)). discriminate.
  - intros (w & W & C). now apply (H w).
Qed.

(** Why not: the evidence names a breach. *)
Theorem refute_breach D c (w : point (dimension_of D) -> R) : refute D c = true ->
  (refuted c = WeightedDelaunay -> refuted_weights D c w) ->
  broken (refuted c) (lifted (refuted c) w) (refuted_points D c) (refuted_simplices D c)
    (rule_of (because c)).
Proof.
  intros A W. unfold refuted_weights, refuted_points, refuted_simplices in *.
  destruct D; cbn [dimension_of] in *.
  - now apply (accepted_breach measured_plane c).
  - now apply (accepted_breach measured_space c).
Qed.
