(** * Vectors: R^d is a vector space with an inner product *)
From Coq Require Import Rbase Rfunctions Lra List.
From Coq Require Vector.
From Circumspect Require Import Definitions.
Import ListNotations.
Open Scope R_scope.

Section Vectors.
Context {d : nat}.
Implicit Types p q r : point d.

Lemma plus_comm p q : plus p q = plus q p.
Proof. apply Vector.eq_nth_iff. intros i j <-. unfold plus.
  rewrite !(Vector.nth_map2 _ _ _ i i i) by reflexivity. ring. Qed.
Lemma plus_assoc p q r : plus p (plus q r) = plus (plus p q) r.
Proof. apply Vector.eq_nth_iff. intros i j <-. unfold plus.
  rewrite !(Vector.nth_map2 _ _ _ i i i) by reflexivity. ring. Qed.
Lemma plus_origin p : plus p origin = p.
Proof. apply Vector.eq_nth_iff. intros i j <-. unfold plus, origin.
  rewrite !(Vector.nth_map2 _ _ _ i i i), Vector.const_nth by reflexivity. ring. Qed.
Lemma origin_plus p : plus origin p = p.
Proof. rewrite plus_comm. apply plus_origin. Qed.
Lemma scale_plus a p q : scale a (plus p q) = plus (scale a p) (scale a q).
Proof. apply Vector.eq_nth_iff. intros i j <-. unfold plus, scale.
  rewrite !(Vector.nth_map2 _ _ _ i i i), !(Vector.nth_map _ _ i i),
    !(Vector.nth_map2 _ _ _ i i i) by reflexivity. ring. Qed.
Lemma plus_scale a b p : scale (a + b) p = plus (scale a p) (scale b p).
Proof. apply Vector.eq_nth_iff. intros i j <-. unfold plus, scale.
  rewrite !(Vector.nth_map2 _ _ _ i i i), !(Vector.nth_map _ _ i i) by reflexivity. ring. Qed.
Lemma scale_scale a b p : scale a (scale b p) = scale (a * b) p.
Proof. apply Vector.eq_nth_iff. intros i j <-. unfold scale.
  rewrite !(Vector.nth_map _ _ i i) by reflexivity. ring. Qed.
Lemma scale_one p : scale 1 p = p.
Proof. apply Vector.eq_nth_iff. intros i j <-. unfold scale.
  rewrite !(Vector.nth_map _ _ i i) by reflexivity. ring. Qed.
Lemma scale_zero p : scale 0 p = origin.
Proof. apply Vector.eq_nth_iff. intros i j <-. unfold scale, origin.
  rewrite !(Vector.nth_map _ _ i i), Vector.const_nth by reflexivity. ring. Qed.
Lemma scale_origin a : scale a (@origin d) = origin.
Proof. apply Vector.eq_nth_iff. intros i j <-. unfold scale, origin.
  rewrite !(Vector.nth_map _ _ i i), Vector.const_nth by reflexivity. ring. Qed.

Lemma minus_self p : minus p p = origin.
Proof. unfold minus. rewrite <- (scale_one p) at 1. rewrite <- plus_scale.
  replace (1 + -1) with 0 by lra. apply scale_zero. Qed.
Lemma minus_plus p q : plus (minus p q) q = p.
Proof. unfold minus. rewrite <- (scale_one q) at 2. rewrite <- plus_assoc, <- plus_scale.
  replace (-1 + 1) with 0 by lra. rewrite scale_zero. apply plus_origin. Qed.
End Vectors.

Section Inner.
Lemma inner_comm {d} (p q : point d) : inner p q = inner q p.
Proof.
  unfold inner. refine (Vector.rect2 (fun d p q => Vector.fold_right2 _ 0 d p q =
    Vector.fold_right2 _ 0 d q p) eq_refl _ p q).
  intros n v w IH x y. cbn. rewrite IH. ring.
Qed.
Lemma inner_scale {d} a (p q : point d) : inner (scale a p) q = a * inner p q.
Proof.
  refine (Vector.rect2 (fun d (p q : point d) => inner (scale a p) q = a * inner p q) _ _ p q).
  - cbn. ring.
  - intros n v w IH x y. unfold inner, scale in *. cbn. rewrite IH. ring.
Qed.
Lemma inner_plus {d} (p q r : point d) : inner (plus p q) r = inner p r + inner q r.
Proof.
  revert r. refine (Vector.rect2 (fun d (p q : point d) => forall r, inner (plus p q) r =
    inner p r + inner q r) _ _ p q).
  - intros r. pattern r. apply Vector.case0. cbn. ring.
  - intros n v w IH x y r. pattern r. apply Vector.caseS'. intros z r'.
    specialize (IH r'). unfold inner, plus in *. cbn. rewrite IH. ring.
Qed.
Lemma inner_plus_r {d} (p q r : point d) : inner p (plus q r) = inner p q + inner p r.
Proof. now rewrite inner_comm, inner_plus, (inner_comm q), (inner_comm r). Qed.
Lemma inner_scale_r {d} a (p q : point d) : inner p (scale a q) = a * inner p q.
Proof. now rewrite inner_comm, inner_scale, inner_comm. Qed.
Lemma inner_minus {d} (p q r : point d) : inner (minus p q) r = inner p r - inner q r.
Proof. unfold minus. rewrite inner_plus, inner_scale. ring. Qed.
Lemma inner_minus_r {d} (p q r : point d) : inner p (minus q r) = inner p q - inner p r.
Proof. unfold minus. rewrite inner_plus_r, inner_scale_r. ring. Qed.
Lemma inner_origin {d} (p : point d) : inner origin p = 0.
Proof. rewrite <- (scale_zero p), inner_scale. ring. Qed.
Lemma inner_origin_r {d} (p : point d) : inner p origin = 0.
Proof. rewrite inner_comm. apply inner_origin. Qed.
Lemma norm2_nonneg {d} (p : point d) : 0 <= norm2 p.
Proof.
  unfold norm2, inner. induction p as [|x n v IH]; cbn; [lra|].
  pose proof (Rle_0_sqr x) as X. unfold Rsqr in X. lra.
Qed.
Lemma norm2_zero {d} (p : point d) : norm2 p = 0 -> p = origin.
Proof.
  unfold norm2, inner, origin. induction p as [|x n v IH]; cbn; intros H; [reflexivity|].
  pose proof (Rle_0_sqr x) as X. unfold Rsqr in X.
  pose proof (norm2_nonneg v) as N. unfold norm2, inner in N.
  rewrite IH by lra. f_equal. assert (x * x = 0) by lra. apply Rmult_integral in H0.
  destruct H0; lra.
Qed.
Lemma dist2_expand {d} (p q : point d) : dist2 p q = norm2 p - 2 * inner p q + norm2 q.
Proof.
  unfold dist2, norm2. rewrite inner_minus, !inner_minus_r, (inner_comm q p). ring.
Qed.
Lemma dist2_comm {d} (p q : point d) : dist2 p q = dist2 q p.
Proof. rewrite !dist2_expand, (inner_comm p q). ring. Qed.
End Inner.

Lemma combination_cons {d} a (p : point d) l :
  combination ((a, p) :: l) = plus (scale a p) (combination l).
Proof. reflexivity. Qed.
Lemma total_cons {d} a (p : point d) l : total ((a, p) :: l) = a + total l.
Proof. reflexivity. Qed.
