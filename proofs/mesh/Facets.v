(** * Facets: the facet opposite a vertex, and simplices that share one

    The barycentric coordinates opposite a shared facet are multiples of each other
    ([facet_multiple]); the facet's relative interior is the same in both simplices
    ([facet_interior]), so simplices on the same side of it share interior points
    ([same_side_overlap]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Matched Faces.
Import ListNotations.
Open Scope R_scope.

Section Facets.
Context {d : nat}.
Implicit Types (t u : frame d) (p q v : point d) (f : simplex d).

Definition indices_but (i : nat) : list nat := seq 0 i ++ seq (S i) (d - i).
(** The facet opposite vertex i. *)
Definition facet_of t i : simplex d := map (vertex t) (indices_but i).

Lemma indices_split i : (i <= d)%nat -> seq 0 (S d) = seq 0 i ++ i :: seq (S i) (d - i).
Proof. intros Hi. replace (S d) with (i + S (d - i))%nat by lia. now rewrite seq_app. Qed.
Lemma in_indices_but i k : (i <= d)%nat -> In k (indices_but i) <-> (k <= d)%nat /\ k <> i.
Proof. intros. unfold indices_but. rewrite in_app_iff, !in_seq. lia. Qed.
Lemma in_facet_of t i v : (i <= d)%nat ->
  In v (facet_of t i) <-> exists k, (k <= d)%nat /\ k <> i /\ v = vertex t k.
Proof.
  intros Hi. unfold facet_of. rewrite in_map_iff. split.
  - intros (k & <- & Hk). apply (in_indices_but i k Hi) in Hk. exists k. tauto.
  - intros (k & Hk & N & ->). exists k. split; [reflexivity|]. now apply in_indices_but.
Qed.
Lemma facet_of_incl t i : (i <= d)%nat -> incl (facet_of t i) (vertices t).
Proof. intros Hi v Hv. apply (in_facet_of t i v Hi) in Hv. destruct Hv as (k & Hk & _ & ->).
  apply in_vertices. eauto. Qed.
Lemma facet_of_length t i : (i <= d)%nat -> length (facet_of t i) = d.
Proof. intros. unfold facet_of, indices_but. rewrite map_length, app_length, !seq_length. lia. Qed.
Lemma facet_of_NoDup t i : (i <= d)%nat -> NoDup (facet_of t i).
Proof.
  intros Hi. pose proof (vertices_NoDup t) as N. unfold vertices in N.
  rewrite (indices_split i Hi), map_app in N. cbn [map] in N. apply NoDup_remove_1 in N.
  unfold facet_of, indices_but. now rewrite map_app.
Qed.
Lemma not_in_facet_of t i : (i <= d)%nat -> ~ In (vertex t i) (facet_of t i).
Proof. intros Hi H. apply (in_facet_of t i _ Hi) in H. destruct H as (k & Hk & N & E).
  apply N. symmetry. now apply (vertex_inj t). Qed.

(** d different vertices are a facet. *)
Lemma facet_index t f : NoDup f -> length f = d -> incl f (vertices t) ->
  exists i, (i <= d)%nat /\ same f (facet_of t i).
Proof.
  intros N L I.
  destruct (Forall_dec (fun v => In v f) (fun v => in_points v f) (vertices t)) as [F|F].
  - exfalso. rewrite Forall_forall in F. assert (H : incl (vertices t) f) by exact F.
    apply (NoDup_incl_length (vertices_NoDup t)) in H. rewrite vertices_length, L in H. lia.
  - apply neg_Forall_Exists_neg in F; [|intros v; apply in_points].
    apply Exists_exists in F. destruct F as (v & Hv & Nv). apply in_vertices in Hv.
    destruct Hv as (i & Hi & ->). exists i. split; [assumption|].
    assert (J : incl f (facet_of t i)).
    { intros v Hv. pose proof (I v Hv) as V. apply in_vertices in V. destruct V as (k & Hk & ->).
      apply in_facet_of; [assumption|]. exists k. split; [assumption|]. split; [|reflexivity].
      now intros ->. }
    split; [assumption|]. apply NoDup_length_incl; [assumption| |assumption].
    rewrite facet_of_length, L by assumption. constructor.
Qed.

Lemma opposite_facets t i u j : opposite t i u j <->
  (i <= d)%nat /\ (j <= d)%nat /\ same (facet_of t i) (facet_of u j) /\ bary t i (vertex u j) < 0.
Proof.
  split.
  - intros (Hi & Hj & TU & UT & Neg). split; [assumption|]. split; [assumption|].
    split; [|assumption]. split; intros v Hv.
    + apply (in_facet_of t i v Hi) in Hv. destruct Hv as (k & Hk & N & ->).
      apply in_facet_of; auto.
    + apply (in_facet_of u j v Hj) in Hv. destruct Hv as (k & Hk & N & ->).
      apply in_facet_of; auto.
  - intros (Hi & Hj & [TU UT] & Neg). split; [assumption|]. split; [assumption|].
    split; [|split; [|assumption]]; intros k Hk N.
    + apply (in_facet_of u j _ Hj), TU, in_facet_of; eauto.
    + apply (in_facet_of t i _ Hi), UT, in_facet_of; eauto.
Qed.
Lemma opposite_dec t i u j : {opposite t i u j} + {~ opposite t i u j}.
Proof.
  assert (I : forall X Y : simplex d, {incl X Y} + {~ incl X Y}).
  { intros X Y. destruct (Forall_dec (fun v => In v Y) (fun v => in_points v Y) X) as [F|F];
      rewrite Forall_forall in F; [left|right]; assumption. }
  destruct (le_dec i d) as [Hi|N]; [|right; rewrite opposite_facets; tauto].
  destruct (le_dec j d) as [Hj|N]; [|right; rewrite opposite_facets; tauto].
  destruct (I (facet_of t i) (facet_of u j)) as [TU|N];
    [|right; rewrite opposite_facets; unfold same; tauto].
  destruct (I (facet_of u j) (facet_of t i)) as [UT|N];
    [|right; rewrite opposite_facets; unfold same; tauto].
  destruct (Rlt_dec (bary t i (vertex u j)) 0) as [Neg|N];
    [left|right; rewrite opposite_facets; tauto].
  rewrite opposite_facets. unfold same. tauto.
Qed.

(** The coordinates opposite a shared facet are multiples of each other. *)
Lemma facet_multiple t i u j : (i <= d)%nat -> (j <= d)%nat -> same (facet_of t i) (facet_of u j) ->
  forall p, bary t i p = bary t i (vertex u j) * bary u j p.
Proof.
  intros Hi Hj [_ UT] p. rewrite (interpolation u (bary t i) p (bary_affine t i Hi)). unfold sum.
  rewrite (sum_one _ _ j); [ring | apply seq_NoDup | now apply in_seq_d |].
  intros l Hl N. apply in_seq_d in Hl.
  assert (V : In (vertex u l) (facet_of t i)) by (apply UT, in_facet_of; eauto).
  apply (in_facet_of t i _ Hi) in V. destruct V as (k & Hk & Nk & ->).
  rewrite bary_other by auto. ring.
Qed.
Lemma facet_multiple_nonzero t i u j : (i <= d)%nat -> (j <= d)%nat ->
  same (facet_of t i) (facet_of u j) -> bary t i (vertex u j) <> 0.
Proof.
  intros Hi Hj E Z. pose proof (facet_multiple t i u j Hi Hj E (vertex t i)) as M.
  rewrite Z, bary_own in M by assumption. lra.
Qed.

(** A point in the relative interior of a facet: its other coordinates are the same. *)
Definition facet_centre t i : point d := mix (vertex t i) (barycentre t) (INR (S d) / INR d).
Lemma bary_facet_centre t i : (1 <= d)%nat -> (i <= d)%nat -> bary t i (facet_centre t i) = 0.
Proof.
  intros D Hi. assert (0 < INR d) by (apply lt_0_INR; lia). unfold facet_centre.
  rewrite affine_mix by now apply bary_affine.
  rewrite bary_own, bary_barycentre, S_INR by assumption. field. lra.
Qed.
Lemma bary_facet_centre_other t i k : (1 <= d)%nat -> (i <= d)%nat -> (k <= d)%nat -> k <> i ->
  0 < bary t k (facet_centre t i).
Proof.
  intros D Hi Hk N. assert (0 < INR d) by (apply lt_0_INR; lia). unfold facet_centre.
  rewrite affine_mix by now apply bary_affine.
  rewrite bary_other, bary_barycentre, S_INR by assumption.
  replace ((1 - (INR d + 1) / INR d) * 0 + (INR d + 1) / INR d * / (INR d + 1)) with (/ INR d)
    by (field; lra).
  now apply Rinv_0_lt_compat.
Qed.
Lemma facet_centre_closed t i : (1 <= d)%nat -> (i <= d)%nat -> inside_closed t (facet_centre t i).
Proof.
  intros D Hi k Hk. destruct (Nat.eq_dec k i) as [->|N].
  - rewrite bary_facet_centre by assumption. lra.
  - left. now apply bary_facet_centre_other.
Qed.

(** On the plane of a shared facet the relative interiors are the same. *)
Lemma facet_interior t i u j q : (i <= d)%nat -> (j <= d)%nat ->
  same (facet_of t i) (facet_of u j) -> bary t i q = 0 ->
  (forall k, (k <= d)%nat -> k <> i -> 0 < bary t k q) ->
  forall l, (l <= d)%nat -> l <> j -> 0 < bary u l q.
Proof.
  intros Hi Hj [TU UT] Z X l Hl N.
  rewrite (interpolation t (bary u l) q (bary_affine u l Hl)). unfold sum.
  assert (V : In (vertex u l) (facet_of t i)) by (apply UT, in_facet_of; eauto).
  apply (in_facet_of t i _ Hi) in V. destruct V as (k & Hk & Nk & E).
  apply sum_pos with k; [|now apply in_seq_d|].
  - intros k' Hk'. apply in_seq_d in Hk'. destruct (Nat.eq_dec k' i) as [->|Nk'].
    + rewrite Z. lra.
    + assert (V : In (vertex t k') (facet_of u j)) by (apply TU, in_facet_of; eauto).
      apply (in_facet_of u j _ Hj) in V. destruct V as (l' & Hl' & _ & ->).
      apply Rmult_le_pos; [left; auto|]. rewrite bary_vertex by assumption.
      destruct (Nat.eq_dec l l'); lra.
  - rewrite <- E, bary_own by assumption. rewrite Rmult_1_r. auto.
Qed.

(** Two simplices on the same side of a shared facet share interior points. *)
Lemma same_side_overlap t i u j : (1 <= d)%nat -> (i <= d)%nat -> (j <= d)%nat ->
  same (facet_of t i) (facet_of u j) -> 0 < bary t i (vertex u j) ->
  exists y, inside t y /\ inside u y.
Proof.
  intros D Hi Hj E P. set (q := facet_centre t i).
  assert (Z : bary t i q = 0) by now apply bary_facet_centre.
  assert (Q : forall k, (k <= d)%nat -> k <> i -> 0 < bary t k q).
  { intros. now apply bary_facet_centre_other. }
  pose proof (facet_interior t i u j q Hi Hj E Z Q) as R.
  destruct (nearby (map (bary t) (indices_but i) ++ map (bary u) (indices_but j)) q (vertex t i))
    as (e & He & K).
  { intros g Hg. apply in_app_or in Hg. destruct Hg as [Hg|Hg]; apply in_map_iff in Hg;
      destruct Hg as (k & <- & Hk); apply in_indices_but in Hk; try assumption;
      destruct Hk as [Hk N]; (split; [now apply bary_affine|auto]). }
  assert (Pt : bary t i (mix q (vertex t i) e) = e).
  { rewrite affine_mix, Z, bary_own by (assumption || now apply bary_affine). ring. }
  exists (mix q (vertex t i) e). split; intros k Hk.
  - destruct (Nat.eq_dec k i) as [->|N]; [rewrite Pt; lra|].
    apply (K e); [lra|]. apply in_or_app. left. now apply in_map, in_indices_but.
  - destruct (Nat.eq_dec k j) as [->|N].
    + pose proof (facet_multiple t i u j Hi Hj E (mix q (vertex t i) e)) as M. rewrite Pt in M.
      apply (Rmult_lt_reg_l _ _ _ P). lra.
    + apply (K e); [lra|]. apply in_or_app. right. now apply in_map, in_indices_but.
Qed.

(** If a whole simplex lies on the inner side of a facet's hyperplane, then its interior points lie
    strictly there. *)
Lemma strictly_inner t i u q : (i <= d)%nat -> inside u q ->
  (forall k, (k <= d)%nat -> 0 <= bary t i (vertex u k)) -> 0 < bary t i q.
Proof.
  intros Hi I N.
  destruct (Exists_dec (fun k => 0 < bary t i (vertex u k)) (seq 0 (S d))) as [X|X].
  - intros k. apply Rlt_dec.
  - apply Exists_exists in X. destruct X as (k & Hk & Pk). apply in_seq_d in Hk.
    rewrite (interpolation u (bary t i) q (bary_affine t i Hi)).
    apply sum_pos with k; [|now apply in_seq_d|].
    + intros l Hl. apply in_seq_d in Hl. apply Rmult_le_pos; [left|]; auto.
    + apply Rmult_lt_0_compat; auto.
  - exfalso. pose proof (bary_own t i Hi) as B.
    rewrite (interpolation u (bary t i) _ (bary_affine t i Hi)) in B.
    unfold sum in B. rewrite sum_zero in B; [lra|]. intros k Hk.
    destruct (Rlt_dec 0 (bary t i (vertex u k))) as [Y|Y].
    + exfalso. apply X, Exists_exists. eauto.
    + apply in_seq_d in Hk. pose proof (N k Hk).
      replace (bary t i (vertex u k)) with 0 by lra. ring.
Qed.
End Facets.
