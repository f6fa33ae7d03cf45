(** * The point of a simplex nearest to a given point

    It exists, without compactness.  The nearest point of an affine subspace is found by orthogonal
    projection, one equation at a time ([projection]).  Of the points in which the coordinates off
    some vertices vanish, either the projection is in the simplex and is the nearest; or the
    segment from any point to the projection leaves the simplex through a facet, at a point that
    is nearer, so that the nearest of the facets' nearest points is nearest of all. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Caratheodory.
Import ListNotations.
Open Scope R_scope.

Section Nearest.
Context {d : nat}.
Implicit Types (p q o x z : point d) (F : list (point d -> R)) (t : frame d).

Definition zeros F x : Prop := forall f, In f F -> f x = 0.

(** The step from p along the vector from z to q, [s] times. *)
Definition step p z q (s : R) : point d := plus p (scale s (minus q z)).
Lemma affine_step f p z q s : affine f -> f (step p z q s) = f p + s * (f q - f z).
Proof.
  intros (a & b & H). rewrite !H. unfold plane, step.
  rewrite inner_plus_r, inner_scale_r, inner_minus_r. ring.
Qed.

Lemma projection F z o : (forall f, In f F -> affine f) -> zeros F z ->
  exists p, zeros F p /\ forall x, zeros F x -> inner (minus o p) (minus x p) = 0.
Proof.
  revert o. induction F as [|f F IH]; intros o A Z.
  - exists o. split; [intros f []|]. intros x _. now rewrite minus_self, inner_origin.
  - assert (A' : forall g, In g F -> affine g) by (intros; apply A; now right).
    assert (Z' : zeros F z) by (intros g Hg; apply Z; now right).
    assert (Fz : f z = 0) by (apply Z; now left).
    destruct (A f (or_introl eq_refl)) as (a & b & E). unfold plane in E.
    destruct (IH o A' Z') as (p & Zp & Op).
    destruct (IH (plus z a) A' Z') as (q & Zq & Oq).
    pose proof (Oq z Z') as Qz. set (n := norm2 (minus q z)).
    assert (Nf : f q = n).
    { pose proof (E q) as Eq. pose proof (E z) as Ez. unfold n, norm2. revert Qz.
      repeat rewrite ?inner_minus, ?inner_minus_r, ?inner_plus. rewrite (inner_comm z q).
      intros. lra. }
    destruct (Req_dec n 0) as [N|N].
    + (* f is constant where the others vanish *)
      apply norm2_zero in N. assert (Q : q = z).
      { rewrite <- (minus_plus q z), N. apply origin_plus. }
      exists p. split.
      * intros g [<-|Hg]; [|now apply Zp]. pose proof (Oq p Zp) as K. subst q.
        pose proof (E p) as Ep. pose proof (E z) as Ez. revert K.
        repeat rewrite ?inner_minus, ?inner_minus_r, ?inner_plus. intros. lra.
      * intros x Hx. apply Op. intros g Hg. apply Hx. now right.
    + exists (step p z q (- f p / n)). split.
      * intros g [<-|Hg].
        -- rewrite affine_step, Nf, Fz by (apply A; now left). field. assumption.
        -- rewrite affine_step, Zp, Zq, Z' by auto. ring.
      * intros x Hx. assert (Zx : zeros F x) by (intros g Hg; apply Hx; now right).
        assert (Fx : f x = 0) by (apply Hx; now left).
        pose proof (Op x Zx) as P1. pose proof (Oq x Zx) as P2. pose proof (Oq p Zp) as P3.
        assert (Zs : zeros F (step p z q (- f p / n))).
        { intros g Hg. rewrite affine_step, Zp, Zq, Z' by auto. ring. }
        set (s := - f p / n) in *. pose proof (Op _ Zs) as P4. pose proof (Oq _ Zs) as P5.
        assert (Fs : f (step p z q s) = 0).
        { rewrite affine_step, Nf, Fz by (apply A; now left). unfold s. field. assumption. }
        pose proof (E x) as Ex. rewrite Fx in Ex. pose proof (E (step p z q s)) as Es.
        rewrite Fs in Es. set (y := step p z q s) in *.
        assert (D : inner (minus q z) (minus x y) = 0).
        { revert P2 P5 Ex Es.
          repeat rewrite ?inner_minus, ?inner_minus_r, ?inner_plus. intros. lra. }
        assert (Y : forall v, inner (minus o y) v = inner (minus o p) v - s * inner (minus q z) v).
        { intros v. unfold y, step. rewrite !inner_minus, inner_plus, inner_scale, inner_minus.
          ring. }
        rewrite Y, D. revert P1 P4. rewrite !inner_minus_r. intros. lra.
Qed.

Lemma projection_distance o p x : inner (minus o p) (minus x p) = 0 ->
  dist2 o x = dist2 o p + dist2 p x.
Proof.
  rewrite !dist2_expand, inner_minus, !inner_minus_r. unfold norm2. intros. lra.
Qed.
Lemma dist2_nonneg p q : 0 <= dist2 p q.
Proof. apply norm2_nonneg. Qed.

(** ** Faces, by the indices of their vertices *)

Variable t : frame d.
Variable o : point d.

Definition off (K : list nat) : list nat :=
  filter (fun i => if in_dec Nat.eq_dec i K then false else true) (seq 0 (S d)).
Lemma in_off K i : In i (off K) <-> (i <= d)%nat /\ ~ In i K.
Proof.
  unfold off. rewrite filter_In, in_seq_d. destruct (in_dec Nat.eq_dec i K);
    intuition discriminate.
Qed.
Definition in_face (K : list nat) x : Prop := inside_closed t x /\ zeros (map (bary t) (off K)) x.
Definition nearest_in (K : list nat) q : Prop :=
  in_face K q /\ forall x, in_face K x -> dist2 o q <= dist2 o x.

Definition without (i : nat) (K : list nat) : list nat := remove Nat.eq_dec i K.
Lemma in_without i k K : In k (without i K) <-> In k K /\ k <> i.
Proof.
  split; [intros H; now apply in_remove in H|]. intros [H N]. now apply in_in_remove.
Qed.
Lemma in_face_without i K x : (i <= d)%nat -> bary t i x = 0 -> in_face K x ->
  in_face (without i K) x.
Proof.
  intros Hi Z [I H]. split; [assumption|]. intros f Hf. apply in_map_iff in Hf.
  destruct Hf as (k & <- & Hk). apply in_off in Hk. destruct Hk as [Dk Nk].
  destruct (Nat.eq_dec k i) as [->|N]; [assumption|]. apply H, in_map, in_off.
  split; [assumption|]. intros X. apply Nk, in_without. now split.
Qed.
Lemma in_face_weaken i K x : in_face (without i K) x -> in_face K x.
Proof.
  intros [I H]. split; [assumption|]. intros f Hf. apply in_map_iff in Hf.
  destruct Hf as (k & <- & Hk). apply in_off in Hk. apply H, in_map, in_off.
  split; [apply Hk|]. intros X. apply in_without in X. now apply Hk.
Qed.

Lemma face_vertex K i : (i <= d)%nat -> In i K -> in_face K (vertex t i).
Proof.
  intros Hi HK. split.
  - intros k Hk. rewrite bary_vertex by assumption. destruct (Nat.eq_dec k i); lra.
  - intros f Hf. apply in_map_iff in Hf. destruct Hf as (k & <- & Hk). apply in_off in Hk.
    apply bary_other; try apply Hk; auto. intros ->. now apply Hk.
Qed.
Lemma face_nonempty K x : in_face K x -> exists i, (i <= d)%nat /\ In i K.
Proof.
  intros [I Z]. pose proof (bary_sum t x) as B.
  destruct (positive_term (seq 0 (S d)) (fun i => bary t i x)) as (i & Hi & P).
  { unfold sum in B. rewrite B. lra. }
  apply in_seq_d in Hi. exists i. split; [assumption|].
  destruct (in_dec Nat.eq_dec i K) as [|N]; [assumption|].
  rewrite (Z (bary t i)) in P by (now apply in_map, in_off). lra.
Qed.

(** The points of the face, towards the projection: they leave it through a facet, nearer to o. *)
Lemma leaves K p x : zeros (map (bary t) (off K)) p ->
  (forall y, zeros (map (bary t) (off K)) y -> inner (minus o p) (minus y p) = 0) ->
  ~ inside_closed t p -> in_face K x ->
  exists i y, (i <= d)%nat /\ In i K /\ in_face (without i K) y /\ dist2 o y <= dist2 o x.
Proof.
  intros Zp Op Np [Ix Zx].
  set (bad := filter (fun i => if Rlt_dec (bary t i p) 0 then true else false) (seq 0 (S d))).
  assert (B : forall i, In i bad <-> (i <= d)%nat /\ bary t i p < 0).
  { intros i. unfold bad. rewrite filter_In, in_seq_d. destruct (Rlt_dec (bary t i p) 0);
      intuition discriminate. }
  assert (NE : bad <> []).
  { intros E. apply Np. intros i Hi. destruct (Rlt_dec (bary t i p) 0) as [L|]; [|lra].
    assert (X : In i bad) by now apply B. rewrite E in X. destruct X. }
  destruct (smallest (fun i => bary t i x / (bary t i x - bary t i p)) bad NE) as (i & Hi & M).
  apply B in Hi. destruct Hi as [Hi Ni]. pose proof (Ix i Hi) as Xi.
  set (e := bary t i x / (bary t i x - bary t i p)) in *.
  assert (E : e * (bary t i x - bary t i p) = bary t i x) by (unfold e; field; lra).
  assert (He : 0 <= e <= 1) by (split; nra).
  set (y := mix x p e).
  assert (Zy : zeros (map (bary t) (off K)) y).
  { intros f Hf. pose proof (Zp f Hf) as Z1. pose proof (Zx f Hf) as Z2.
    apply in_map_iff in Hf. destruct Hf as (k & <- & Hk). apply in_off in Hk.
    unfold y. rewrite affine_mix by (now apply bary_affine). rewrite Z1, Z2. ring. }
  assert (Fy : in_face K y).
  { split; [|assumption]. intros k Hk. unfold y. rewrite affine_mix by (now apply bary_affine).
    pose proof (Ix k Hk) as Xk. destruct (Rlt_dec (bary t k p) 0) as [L|L].
    - assert (X : In k bad) by now apply B. specialize (M k X).
      assert (Q : e * (bary t k x - bary t k p) <= bary t k x).
      { replace (bary t k x) with
          (bary t k x / (bary t k x - bary t k p) * (bary t k x - bary t k p)) at 2
          by (field; lra).
        apply Rmult_le_compat_r; lra. }
      lra.
    - assert (0 <= (1 - e) * bary t k x) by (apply Rmult_le_pos; lra).
      assert (0 <= e * bary t k p) by (apply Rmult_le_pos; lra). lra. }
  exists i, y. split; [assumption|]. split; [|split].
  - destruct (in_dec Nat.eq_dec i K) as [|N]; [assumption|].
    rewrite (Zp (bary t i)) in Ni by (now apply in_map, in_off). lra.
  - apply in_face_without; auto. unfold y. rewrite affine_mix by (now apply bary_affine). lra.
  - rewrite (projection_distance o p x), (projection_distance o p y) by auto.
    assert (X : dist2 p y = (1 - e) * (1 - e) * dist2 p x).
    { unfold y, mix. rewrite !dist2_expand. unfold norm2.
      repeat rewrite ?inner_plus, ?inner_plus_r, ?inner_scale, ?inner_scale_r.
      rewrite (inner_comm x p). ring. }
    assert (Q : (1 - e) * (1 - e) <= 1) by nra.
    pose proof (Rmult_le_compat_r _ _ _ (dist2_nonneg p x) Q). lra.
Qed.

Lemma nearest_face n : forall K, (length K <= n)%nat -> (exists i, (i <= d)%nat /\ In i K) ->
  exists q, nearest_in K q.
Proof.
  induction n as [|n IH]; intros K L (i0 & D0 & H0).
  { destruct K; [destruct H0|cbn in L; lia]. }
  destruct (projection (map (bary t) (off K)) (vertex t i0) o) as (p & Zp & Op).
  { intros f Hf. apply in_map_iff in Hf. destruct Hf as (k & <- & Hk). apply in_off in Hk.
    now apply bary_affine. }
  { now apply face_vertex. }
  destruct (Forall_Exists_dec (fun i => 0 <= bary t i p)
    (fun i => Rle_dec 0 (bary t i p)) (seq 0 (S d))) as [Y|N].
  - assert (I : inside_closed t p).
    { intros i Hi. apply (proj1 (Forall_forall _ _) Y i). now apply in_seq_d. }
    exists p. split; [now split|]. intros x [_ Zx]. rewrite (projection_distance o p x) by auto.
    pose proof (dist2_nonneg p x). lra.
  - assert (I : ~ inside_closed t p).
    { intros I. apply Exists_exists in N. destruct N as (i & Hi & N). apply N, I.
      now apply in_seq_d. }
    (* the nearest points of the facets of the face *)
    assert (C : forall J, incl J K -> exists Q, (forall q, In q Q -> in_face K q) /\
      forall i x, In i J -> in_face (without i K) x ->
        exists q, In q Q /\ dist2 o q <= dist2 o x).
    { induction J as [|i J IJ]; intros IK; [exists []; split; [intros q []|intros i x []]|].
      destruct IJ as (Q & HQ & NQ); [intros k Hk; apply IK; now right|].
      destruct (Exists_dec (fun k => (k <= d)%nat) (without i K)
        (fun k => le_dec k d)) as [Ex|No].
      - apply Exists_exists in Ex. destruct Ex as (k & Hk & Dk).
        destruct (IH (without i K)) as (q & Fq & Mq); [|now exists k|].
        { assert (length (without i K) < length K)%nat; [|lia].
          apply remove_length_lt, IK. now left. }
        exists (q :: Q). split.
        + intros r [<-|Hr]; [now apply in_face_weaken in Fq|auto].
        + intros j x [<-|Hj] Fx; [exists q; split; [now left|auto]|].
          destruct (NQ j x Hj Fx) as (r & Hr & Mr). exists r. split; [now right|assumption].
      - exists Q. split; [assumption|]. intros j x [<-|Hj] Fx; [|now apply (NQ j x)].
        exfalso. apply No, Exists_exists. apply face_nonempty in Fx.
        destruct Fx as (k & Dk & Hk). now exists k. }
    destruct (C K (incl_refl K)) as (Q & HQ & NQ).
    assert (NE : Q <> []).
    { intros ->. destruct (leaves K p (vertex t i0)) as (i & y & _ & Hi & Fy & _); auto.
      { now apply face_vertex. }
      destruct (NQ i y Hi Fy) as (q & [] & _). }
    destruct (smallest (dist2 o) Q NE) as (q & Hq & M). exists q. split; [auto|].
    intros x Fx. destruct (leaves K p x Zp Op I Fx) as (i & y & _ & Hi & Fy & D).
    destruct (NQ i y Hi Fy) as (r & Hr & Dr). specialize (M r Hr). lra.
Qed.

(** Every d-simplex has a point nearest to o. *)
Theorem nearest_point : exists q, conv (vertices t) q /\
  forall x, conv (vertices t) x -> dist2 o q <= dist2 o x.
Proof.
  assert (A : forall x, in_face (seq 0 (S d)) x <-> conv (vertices t) x).
  { intros x. rewrite conv_vertices. split; [now intros [I _]|]. intros I. split; [assumption|].
    intros f Hf. apply in_map_iff in Hf. destruct Hf as (k & _ & Hk). apply in_off in Hk.
    exfalso. apply Hk, in_seq_d, Hk. }
  destruct (nearest_face _ (seq 0 (S d)) (le_n _)) as (q & Fq & M).
  { exists 0%nat. split; [lia|]. apply in_seq_d. lia. }
  exists q. split; [now apply A|]. intros x Hx. now apply M, A.
Qed.
End Nearest.
