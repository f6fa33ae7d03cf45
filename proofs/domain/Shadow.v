(** * A plane in space, seen along an axis

    If the normal of a plane is not orthogonal to an axis, the plane is seen along it in the same
    way: what is a hull, a segment or enclosed in the plane is so in the picture. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Coq Require Vector.
From Circumspect Require Import DomainChecker.
From Circumspect Require Import Definitions Domains Vectors Affine Faces Orientation Combinations.
Import ListNotations.
Open Scope R_scope.

Definition pair_of (x y : R) : point 2 := Vector.cons _ x _ (Vector.cons _ y _ (Vector.nil _)).
Definition triple_of (x y z : R) : point 3 := Vector.cons _ x _ (pair_of y z).

Lemma point2_ext (p q : point 2) : abscissa p = abscissa q -> ordinate p = ordinate q -> p = q.
Proof.
  intros X Y. apply affine_separate. intros f (a & b & F). rewrite !F. unfold plane.
  rewrite !inner2, X, Y. reflexivity.
Qed.
Lemma point3_ext (p q : point 3) : abscissa p = abscissa q -> ordinate p = ordinate q ->
  height p = height q -> p = q.
Proof.
  intros X Y Z. apply affine_separate. intros f (a & b & F). rewrite !F. unfold plane.
  rewrite !inner_3, X, Y, Z. reflexivity.
Qed.
Lemma affine_abscissa2 : affine (fun p : point 2 => abscissa p).
Proof. apply affine_ext with (2 := affine2 1 0 0). intros; ring. Qed.
Lemma affine_ordinate2 : affine (fun p : point 2 => ordinate p).
Proof. apply affine_ext with (2 := affine2 0 1 0). intros; ring. Qed.
Lemma affine_abscissa3 : affine (fun p : point 3 => abscissa p).
Proof. apply affine_ext with (2 := affine3 1 0 0 0). intros; ring. Qed.
Lemma affine_ordinate3 : affine (fun p : point 3 => ordinate p).
Proof. apply affine_ext with (2 := affine3 0 1 0 0). intros; ring. Qed.
Lemma affine_height3 : affine (fun p : point 3 => height p).
Proof. apply affine_ext with (2 := affine3 0 0 1 0). intros; ring. Qed.

Section Shadow.
Variables (i : nat) (n : point 3) (o : R).
Definition axis_of (q : point 3) : R :=
  match i with 0%nat => abscissa q | 1%nat => ordinate q | _ => height q end.
Hypothesis seen : axis_of n <> 0.

Definition flat (q : point 3) : Prop := inner n q = o.
Definition shadow (q : point 3) : point 2 :=
  match i with
  | 0%nat => pair_of (ordinate q) (height q)
  | 1%nat => pair_of (abscissa q) (height q)
  | _ => pair_of (abscissa q) (ordinate q)
  end.
Definition raised (p : point 2) : point 3 :=
  let u := abscissa p in let v := ordinate p in
  match i with
  | 0%nat => triple_of ((o - ordinate n * u - height n * v) / abscissa n) u v
  | 1%nat => triple_of u ((o - abscissa n * u - height n * v) / ordinate n) v
  | _ => triple_of u v ((o - abscissa n * u - ordinate n * v) / height n)
  end.

Lemma shadow_between x y s : shadow (between x y s) = between (shadow x) (shadow y) s.
Proof.
  change (between (d := 3)) with (mix (d := 3)). change (between (d := 2)) with (mix (d := 2)).
  apply point2_ext; rewrite ?(affine_mix _ _ _ _ affine_abscissa2),
    ?(affine_mix _ _ _ _ affine_ordinate2);
    unfold shadow; destruct i as [|[|k]];
      cbn [abscissa ordinate pair_of Vector.hd Vector.tl Vector.caseS];
    unfold abscissa, ordinate, pair_of; cbn [Vector.hd Vector.tl Vector.caseS];
    first [exact (affine_mix _ x y s affine_abscissa3)|exact (affine_mix _ x y s affine_ordinate3)|
           exact (affine_mix _ x y s affine_height3)].
Qed.
Lemma raised_flat p : flat (raised p).
Proof.
  unfold flat, raised, axis_of in *. rewrite inner_3.
  destruct i as [|[|k]]; unfold abscissa, ordinate, height, triple_of, pair_of in *;
    cbn [Vector.hd Vector.tl Vector.caseS]; field; exact seen.
Qed.
Lemma shadow_raised p : shadow (raised p) = p.
Proof. unfold shadow, raised. destruct i as [|[|k]]; apply point2_ext; reflexivity. Qed.
Lemma raised_shadow q : flat q -> raised (shadow q) = q.
Proof.
  unfold flat. rewrite inner_3. intros F. unfold axis_of in seen. unfold raised, shadow.
  destruct i as [|[|k]]; apply point3_ext; try reflexivity;
    unfold abscissa, ordinate, height, triple_of, pair_of in *;
      cbn [Vector.hd Vector.tl Vector.caseS];
    rewrite <- F; field; exact seen.
Qed.
Lemma flat_between x y s : flat x -> flat y -> flat (between x y s).
Proof.
  unfold flat, between. intros X Y. rewrite inner_plus_r, !inner_scale_r, X, Y. ring.
Qed.
Lemma raised_between x y s : raised (between x y s) = between (raised x) (raised y) s.
Proof.
  rewrite <- (raised_shadow (between (raised x) (raised y) s)).
  - now rewrite shadow_between, !shadow_raised.
  - apply flat_between; apply raised_flat.
Qed.
Lemma shadow_norm q : norm2 (shadow q) <= norm2 q.
Proof.
  unfold norm2. rewrite inner_3, inner2. unfold shadow.
  pose proof (Rle_0_sqr (abscissa q)) as X. pose proof (Rle_0_sqr (ordinate q)) as Y.
  pose proof (Rle_0_sqr (height q)) as Z. unfold Rsqr in X, Y, Z.
  destruct i as [|[|k]].
  - change (ordinate q * ordinate q + height q * height q <=
      abscissa q * abscissa q + ordinate q * ordinate q + height q * height q). lra.
  - change (abscissa q * abscissa q + height q * height q <=
      abscissa q * abscissa q + ordinate q * ordinate q + height q * height q). lra.
  - change (abscissa q * abscissa q + ordinate q * ordinate q <=
      abscissa q * abscissa q + ordinate q * ordinate q + height q * height q). lra.
Qed.
Lemma three_squares a b c : (a + b + c) * (a + b + c) <= 3 * (a * a + b * b + c * c).
Proof.
  pose proof (Rle_0_sqr (a - b)) as X. pose proof (Rle_0_sqr (a - c)) as Y.
  pose proof (Rle_0_sqr (b - c)) as Z. unfold Rsqr in *. lra.
Qed.
Lemma raised_norm r : exists b, forall p, norm2 p <= r -> norm2 (raised p) <= b.
Proof.
  assert (G : forall a1 a2 a0 e, e <> 0 -> exists b, forall u v, u * u + v * v <= r ->
    u * u + v * v + (a0 - a1 * u - a2 * v) / e * ((a0 - a1 * u - a2 * v) / e) <= b).
  { intros a1 a2 a0 e E.
    exists (r + 3 * ((a0 / e) * (a0 / e) + (a1 / e) * (a1 / e) * r + (a2 / e) * (a2 / e) * r)).
    intros u v H.
    replace ((a0 - a1 * u - a2 * v) / e) with (a0 / e + (- (a1 / e) * u) + (- (a2 / e) * v))
      by (field; lra).
    pose proof (three_squares (a0 / e) (- (a1 / e) * u) (- (a2 / e) * v)) as S.
    set (x := a1 / e) in *. set (y := a2 / e) in *. set (z := a0 / e) in *.
    pose proof (Rle_0_sqr u) as U. pose proof (Rle_0_sqr v) as V. unfold Rsqr in U, V.
    assert (x * x * (u * u) <= x * x * r) by (apply Rmult_le_compat_l; [apply Rle_0_sqr|lra]).
    assert (y * y * (v * v) <= y * y * r) by (apply Rmult_le_compat_l; [apply Rle_0_sqr|lra]).
    lra. }
  unfold axis_of in seen. unfold raised.
  destruct i as [|[|k]].
  - destruct (G (ordinate n) (height n) o (abscissa n) seen) as (b & B). exists b. intros p.
    unfold norm2. rewrite inner2, inner_3. intros H. specialize (B _ _ H).
    unfold abscissa, ordinate, height, triple_of, pair_of in *;
      cbn [Vector.hd Vector.tl Vector.caseS] in *. lra.
  - destruct (G (abscissa n) (height n) o (ordinate n) seen) as (b & B). exists b. intros p.
    unfold norm2. rewrite inner2, inner_3. intros H. specialize (B _ _ H).
    unfold abscissa, ordinate, height, triple_of, pair_of in *;
      cbn [Vector.hd Vector.tl Vector.caseS] in *. lra.
  - destruct (G (abscissa n) (ordinate n) o (height n) seen) as (b & B). exists b. intros p.
    unfold norm2. rewrite inner2, inner_3. intros H. specialize (B _ _ H).
    unfold abscissa, ordinate, height, triple_of, pair_of in *;
      cbn [Vector.hd Vector.tl Vector.caseS] in *. lra.
Qed.

(** A hull in the plane, and its picture. *)
Lemma conv_shadow X q : (forall x, In x X -> flat x) -> conv X q <-> flat q /\
  conv (map shadow X) (shadow q).
Proof.
  intros F. split.
  - intros C. split; [|now apply (conv_map shadow shadow_between)].
    assert (A : affine (fun x => inner n x - o)).
    { exists n, (- o). intros x. unfold plane. ring. }
    assert (P1 : 0 <= inner n q - o).
    { apply (affine_conv _ X q A); [|assumption]. intros x Ix. specialize (F x Ix).
      unfold flat in F. lra. }
    assert (P2 : 0 <= - (inner n q - o)).
    { apply (affine_conv (fun x => - (inner n x - o)) X q (affine_opp _ A)); [|assumption].
      intros x Ix. specialize (F x Ix). unfold flat in F. lra. }
    unfold flat. lra.
  - intros [Fq C]. apply (conv_map raised raised_between) in C.
    rewrite raised_shadow in C by assumption.
    rewrite map_map in C. replace (map (fun x => raised (shadow x)) X) with X in C; [assumption|].
    clear C. induction X as [|x X IH]; [reflexivity|]. cbn. rewrite <- IH.
    + f_equal. symmetry. apply raised_shadow, F. now left.
    + intros y Iy. apply F. now right.
Qed.

(** What is enclosed, and its picture. *)
Section Enclosed.
Variables (W : point 3 -> Prop) (W' : point 2 -> Prop).
Variables (holes : list (point 3)) (holes' : list (point 2)).
Hypothesis walls_shadow : forall q, flat q -> W q <-> W' (shadow q).
Hypothesis holes_flat : forall h, In h holes -> flat h /\ In (shadow h) holes'.
Hypothesis holes_all : forall h', In h' holes' -> exists h, In h holes /\ shadow h = h'.
Notation everywhere := (fun _ : point 2 => True).

Lemma clear_shadow x y : flat x -> flat y -> clear W x y <-> clear W' (shadow x) (shadow y).
Proof.
  intros X Y. split; intros C s Hs N; apply (C s Hs).
  - apply walls_shadow; [now apply flat_between|]. now rewrite shadow_between.
  - rewrite <- shadow_between. apply walls_shadow; [now apply flat_between|assumption].
Qed.
Lemma connected_shadow x y : flat x -> connected flat W x y ->
  flat y /\ connected everywhere W' (shadow x) (shadow y).
Proof.
  intros X C. induction C as [|y z C IH F Cl]; [split; [assumption|apply here]|].
  destruct IH as [Y IH]. split; [assumption|]. apply further with (shadow y); [assumption|exact I|].
  now apply clear_shadow.
Qed.
Lemma connected_raised x p : flat x -> connected everywhere W' (shadow x) p ->
  connected flat W x (raised p).
Proof.
  intros X C. induction C as [|p q C IH F Cl].
  - rewrite raised_shadow by assumption. apply here.
  - apply further with (raised p); [assumption|apply raised_flat|].
    apply clear_shadow; try apply raised_flat. now rewrite !shadow_raised.
Qed.
Theorem enclosed_shadow q : flat q ->
  enclosed flat W holes q <-> enclosed everywhere W' holes' (shadow q).
Proof.
  intros Q.
  assert (U : unbounded flat W q <-> unbounded everywhere W' (shadow q)).
  { split; intros U r.
    - destruct (raised_norm r) as (b & B). destruct (U b) as (y & C & L).
      destruct (connected_shadow q y Q C) as [Y C']. exists (shadow y). split; [assumption|].
      destruct (Rlt_dec r (norm2 (shadow y))) as [|N]; [assumption|exfalso].
      specialize (B (shadow y) ltac:(lra)). rewrite raised_shadow in B by assumption. lra.
    - destruct (U r) as (p & C & L). exists (raised p). split; [now apply connected_raised|].
      pose proof (shadow_norm (raised p)) as S. rewrite shadow_raised in S. lra. }
  unfold enclosed. rewrite (walls_shadow q Q), U.
  assert (H : (forall h, In h holes -> ~ connected flat W q h) <->
    (forall h', In h' holes' -> ~ connected everywhere W' (shadow q) h')).
  { split.
    - intros H h' Ih C. destruct (holes_all h' Ih) as (h & Ih3 & <-). apply (H h Ih3).
      destruct (holes_flat h Ih3) as [Fh _]. rewrite <- (raised_shadow h Fh).
      now apply connected_raised.
    - intros H h Ih C. destruct (holes_flat h Ih) as [Fh Is]. apply (H _ Is).
      now apply connected_shadow in C. }
  rewrite H. tauto.
Qed.
End Enclosed.
End Shadow.
