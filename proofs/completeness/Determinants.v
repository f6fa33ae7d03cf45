(** * A simplex with a frame is not flat: its orientation is not zero

    The matrix of the gradients of the barycentric coordinates is the inverse of the matrix of the
    edges, so the product of their determinants is 1. *)
From Coq Require Import Rbase Rfunctions Lra List Lia.
From Circumspect Require Import Checker Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Orientation Incidence.
Import ListNotations.
Open Scope R_scope.

(** Coordinate i grows along the edge from the last vertex to vertex k by 1 if i = k, else by 0. *)
Lemma gradient {d} (t : frame d) i : (i <= d)%nat -> exists a : point d, forall k, (k <= d)%nat ->
  inner a (vertex t k) - inner a (vertex t d) =
  (if Nat.eq_dec i k then 1 else 0) - (if Nat.eq_dec i d then 1 else 0).
Proof.
  intros Hi. destruct (bary_affine t i Hi) as (a & b & E). exists a. intros k Hk.
  rewrite <- (bary_vertex t i k), <- (bary_vertex t i d), !E by auto. unfold plane. ring.
Qed.

Theorem not_flat2 X (t : frame 2) : lists X t -> orient2 X <> 0.
Proof.
  intros (L & V) Z. destruct X as [|x [|y [|z [|w X]]]]; try discriminate L.
  pose proof (V 0%nat ltac:(lia)) as V0. pose proof (V 1%nat ltac:(lia)) as V1.
  pose proof (V 2%nat ltac:(lia)) as V2. cbn in V0, V1, V2.
  injection V0 as ->. injection V1 as ->. injection V2 as ->.
  destruct (gradient t 0 ltac:(lia)) as (a & A). destruct (gradient t 1 ltac:(lia)) as (b & B).
  pose proof (A 0%nat ltac:(lia)) as A0. pose proof (A 1%nat ltac:(lia)) as A1.
  pose proof (B 0%nat ltac:(lia)) as B0. pose proof (B 1%nat ltac:(lia)) as B1.
  rewrite !inner2 in *. cbn in A0, A1, B0, B1.
  set (p := vertex t 0) in *. set (q := vertex t 1) in *. set (r := vertex t 2) in *.
  assert (E : (abscissa a * ordinate b - ordinate a * abscissa b) * orient2 [p; q; r] =
    (abscissa a * abscissa p + ordinate a * ordinate p -
       (abscissa a * abscissa r + ordinate a * ordinate r)) *
    (abscissa b * abscissa q + ordinate b * ordinate q -
       (abscissa b * abscissa r + ordinate b * ordinate r)) -
    (abscissa a * abscissa q + ordinate a * ordinate q -
       (abscissa a * abscissa r + ordinate a * ordinate r)) *
    (abscissa b * abscissa p + ordinate b * ordinate p -
       (abscissa b * abscissa r + ordinate b * ordinate r))) by (cbn; ring).
  rewrite A0, A1, B0, B1, Z in E. lra.
Qed.

Theorem not_flat3 X (t : frame 3) : lists X t -> orient3 X <> 0.
Proof.
  intros (L & V) Z. destruct X as [|x [|y [|z [|w [|e X]]]]]; try discriminate L.
  pose proof (V 0%nat ltac:(lia)) as V0. pose proof (V 1%nat ltac:(lia)) as V1.
  pose proof (V 2%nat ltac:(lia)) as V2. pose proof (V 3%nat ltac:(lia)) as V3.
  cbn in V0, V1, V2, V3.
  injection V0 as ->. injection V1 as ->. injection V2 as ->. injection V3 as ->.
  destruct (gradient t 0 ltac:(lia)) as (a & A). destruct (gradient t 1 ltac:(lia)) as (b & B).
  destruct (gradient t 2 ltac:(lia)) as (c & C).
  pose proof (A 0%nat ltac:(lia)) as A0. pose proof (A 1%nat ltac:(lia)) as A1.
  pose proof (A 2%nat ltac:(lia)) as A2.
  pose proof (B 0%nat ltac:(lia)) as B0. pose proof (B 1%nat ltac:(lia)) as B1.
  pose proof (B 2%nat ltac:(lia)) as B2.
  pose proof (C 0%nat ltac:(lia)) as C0. pose proof (C 1%nat ltac:(lia)) as C1.
  pose proof (C 2%nat ltac:(lia)) as C2.
  clear A B C V L. rewrite !inner_3 in *.
  set (p := vertex t 0) in *. set (q := vertex t 1) in *. set (r := vertex t 2) in *.
  set (s := vertex t 3) in *. clearbody p q r s.
  set (f (u v : point 3) := abscissa u * (abscissa v - abscissa s) + ordinate u * (ordinate v -
    ordinate s) +
    height u * (height v - height s)).
  assert (E : determinant (abscissa a) (ordinate a) (height a) (abscissa b) (ordinate b) (height b)
      (abscissa c) (ordinate c) (height c) * orient3 [p; q; r; s] =
    determinant (f a p) (f a q) (f a r) (f b p) (f b q) (f b r) (f c p) (f c q) (f c r)).
  { unfold f. cbn [orient3]. unfold determinant. ring. }
  assert (G : forall u v x, abscissa u * abscissa v + ordinate u * ordinate v + height u * height v
    -
     (abscissa u * abscissa s + ordinate u * ordinate s + height u * height s) = x -> f u v = x).
  { intros u v x <-. unfold f. ring. }
  apply G in A0, A1, A2, B0, B1, B2, C0, C1, C2. cbn in A0, A1, A2, B0, B1, B2, C0, C1, C2.
  rewrite A0, A1, A2, B0, B1, B2, C0, C1, C2, Z in E. unfold determinant in E. lra.
Qed.
