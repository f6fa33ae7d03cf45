(** * The orientation of a simplex with a frame is not zero

    [Orientation.v] gives a frame to points whose orientation is not zero; this is the converse.
    So points whose orientation is zero are not affinely independent. *)
From Coq Require Import Rbase Rfunctions Lra Lia List Arith.
From Circumspect Require Import Definitions Vectors Affine Frame Orientation.
Import ListNotations.
Open Scope R_scope.

(** The gradients of the barycentric coordinates and the edges of the simplex are matrices inverse
    to each other: the product of their determinants is 1. *)
Lemma bary_gradient {d} (t : frame d) : exists a : nat -> point d,
  forall i k, (i < d)%nat -> (k < d)%nat ->
    inner (a i) (vertex t k) - inner (a i) (vertex t d) = if Nat.eq_dec i k then 1 else 0.
Proof.
  assert (H : forall n, (n <= d)%nat -> exists a : nat -> point d, forall i, (i < n)%nat ->
            exists b, forall p, bary t i p = plane (a i) b p).
  { induction n as [|n IH]; intros Hn; [exists (fun _ => origin); intros; lia|].
    destruct IH as (a & A); [lia|]. destruct (bary_affine t n) as (g & b & G); [lia|].
    exists (fun i => if Nat.eq_dec i n then g else a i). intros i Hi.
    destruct (Nat.eq_dec i n) as [->|N]; [now exists b|]. apply A. lia. }
  destruct (H d (le_n d)) as (a & A). exists a. intros i k Hi Hk.
  destruct (A i Hi) as (b & B). pose proof (B (vertex t k)) as Bk.
  pose proof (B (vertex t d)) as Bd.
  rewrite bary_vertex in Bk, Bd by lia. unfold plane in *.
  destruct (Nat.eq_dec i d); [lia|]. destruct (Nat.eq_dec i k); lra.
Qed.

Lemma spans2 (t : frame 2) : orient2 (vertices t) <> 0.
Proof.
  destruct (bary_gradient t) as (g & G). cbn [vertices seq map orient2]. intros Z.
  assert (E : forall i k, (i < 2)%nat -> (k < 2)%nat ->
    abscissa (g i) * (abscissa (vertex t k) - abscissa (vertex t 2)) +
    ordinate (g i) * (ordinate (vertex t k) - ordinate (vertex t 2)) =
      if Nat.eq_dec i k then 1 else 0).
  { intros i k Hi Hk. rewrite <- G, !inner2 by assumption. ring. }
  clear G. assert (E00 := E 0%nat 0%nat ltac:(lia) ltac:(lia)).
  assert (E01 := E 0%nat 1%nat ltac:(lia) ltac:(lia)).
  assert (E10 := E 1%nat 0%nat ltac:(lia) ltac:(lia)).
  assert (E11 := E 1%nat 1%nat ltac:(lia) ltac:(lia)). clear E. cbn in E00, E01, E10, E11.
  change (Vector.t R 2) with (point 2) in *.
  set (ux := abscissa (vertex t 0) - abscissa (vertex t 2)) in *.
  set (uy := ordinate (vertex t 0) - ordinate (vertex t 2)) in *.
  set (vx := abscissa (vertex t 1) - abscissa (vertex t 2)) in *.
  set (vy := ordinate (vertex t 1) - ordinate (vertex t 2)) in *.
  set (a := g 0%nat) in *. set (b := g 1%nat) in *.
  assert (X : (abscissa a * ordinate b - ordinate a * abscissa b) * (ux * vy - uy * vx) =
    (abscissa a * ux + ordinate a * uy) * (abscissa b * vx + ordinate b * vy) -
    (abscissa a * vx + ordinate a * vy) * (abscissa b * ux + ordinate b * uy)) by ring.
  rewrite E00, E01, E10, E11, Z in X. lra.
Qed.

Lemma spans3 (t : frame 3) : orient3 (vertices t) <> 0.
Proof.
  destruct (bary_gradient t) as (g & G). cbn [vertices seq map orient3]. unfold determinant.
  intros Z.
  assert (E : forall i k, (i < 3)%nat -> (k < 3)%nat ->
    abscissa (g i) * (abscissa (vertex t k) - abscissa (vertex t 3)) +
    ordinate (g i) * (ordinate (vertex t k) - ordinate (vertex t 3)) +
    height (g i) * (height (vertex t k) - height (vertex t 3)) =
      if Nat.eq_dec i k then 1 else 0).
  { intros i k Hi Hk. rewrite <- G, !inner_3 by assumption. ring. }
  clear G.
  assert (E00 := E 0%nat 0%nat ltac:(lia) ltac:(lia)).
  assert (E01 := E 0%nat 1%nat ltac:(lia) ltac:(lia)).
  assert (E02 := E 0%nat 2%nat ltac:(lia) ltac:(lia)).
  assert (E10 := E 1%nat 0%nat ltac:(lia) ltac:(lia)).
  assert (E11 := E 1%nat 1%nat ltac:(lia) ltac:(lia)).
  assert (E12 := E 1%nat 2%nat ltac:(lia) ltac:(lia)).
  assert (E20 := E 2%nat 0%nat ltac:(lia) ltac:(lia)).
  assert (E21 := E 2%nat 1%nat ltac:(lia) ltac:(lia)).
  assert (E22 := E 2%nat 2%nat ltac:(lia) ltac:(lia)).
  clear E. cbn in E00, E01, E02, E10, E11, E12, E20, E21, E22.
  set (ux := abscissa (vertex t 0) - abscissa (vertex t 3)) in *.
  set (uy := ordinate (vertex t 0) - ordinate (vertex t 3)) in *.
  set (uz := height (vertex t 0) - height (vertex t 3)) in *.
  set (vx := abscissa (vertex t 1) - abscissa (vertex t 3)) in *.
  set (vy := ordinate (vertex t 1) - ordinate (vertex t 3)) in *.
  set (vz := height (vertex t 1) - height (vertex t 3)) in *.
  set (wx := abscissa (vertex t 2) - abscissa (vertex t 3)) in *.
  set (wy := ordinate (vertex t 2) - ordinate (vertex t 3)) in *.
  set (wz := height (vertex t 2) - height (vertex t 3)) in *.
  set (a := g 0%nat) in *. set (b := g 1%nat) in *. set (c := g 2%nat) in *.
  assert (X : determinant (abscissa a) (ordinate a) (height a) (abscissa b) (ordinate b) (height b)
      (abscissa c) (ordinate c) (height c) * determinant ux uy uz vx vy vz wx wy wz = determinant
      (abscissa a * ux + ordinate a * uy + height a * uz)
      (abscissa a * vx + ordinate a * vy + height a * vz)
      (abscissa a * wx + ordinate a * wy + height a * wz)
      (abscissa b * ux + ordinate b * uy + height b * uz)
      (abscissa b * vx + ordinate b * vy + height b * vz)
      (abscissa b * wx + ordinate b * wy + height b * wz)
      (abscissa c * ux + ordinate c * uy + height c * uz)
      (abscissa c * vx + ordinate c * vy + height c * vz)
      (abscissa c * wx + ordinate c * wy + height c * wz)) by (unfold determinant; ring).
  rewrite E00, E01, E02, E10, E11, E12, E20, E21, E22 in X.
  unfold determinant in X. rewrite Z in X. lra.
Qed.
