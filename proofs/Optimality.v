(** * The optimality of the Delaunay triangulation in R^d  (Book: Section 4.3)

    Lifted, a Delaunay triangulation is the underside of conv S^+, and no triangulation of the same
    points passes below it: so it interpolates |p|^2 best at every point (Prop. 4.5).  Over one
    simplex the error is r^2 - d(o,p)^2; its maximum is the squared radius of the min-containment
    ball (Prop. 4.6); so the largest such ball is smallest for the Delaunay triangulation
    (Prop. 4.7).  Heights are arbitrary in the first, hence weighted and anisotropic too. *)
From Coq Require Import Reals Lra Psatz List.
From Circumspect Require Import Definitions Vectors Affine Frame Faces.
Import ListNotations.
Open Scope R_scope.

Section Optimality.
Context {d : nat}.
Implicit Types (p q o c v : point d) (h : point d -> R) (S : list (point d)) (s t u : simplex d)
  (T U : list (simplex d)).

(** The plane (a, b) passes through the lifted vertices of s: over s it is the interpolant T^+. *)
Definition interpolates h s (a : point d) (b : R) : Prop := forall v, In v s -> plane a b v = h v.

Lemma plane_minus a b a' b' p : plane a b p - plane a' b' p = plane (minus a a') (b - b') p.
Proof. unfold plane. rewrite inner_minus. ring. Qed.

Lemma conv_le s f g p : affine f -> affine g -> (forall v, In v s -> f v <= g v) ->
  conv s p -> f p <= g p.
Proof.
  intros F G H C.
  assert (0 <= 1 * g p + (-1) * f p); [|lra].
  apply (affine_conv (fun p => 1 * g p + (-1) * f p) s).
  - now apply affine_combine.
  - intros v Hv. specialize (H v Hv). lra.
  - assumption.
Qed.

(** Prop. 4.5: at every point of conv S a (weighted) Delaunay triangulation minimises the
    interpolated height T^+(p), and with it the error T^+(p) - h(p), among all triangulations. *)
Theorem proposition_4_5 h S T U : (forall t, In t T -> witness_plane h S t) -> fills S U ->
  forall t u p a b a' b', In t T -> In u U -> conv t p -> conv u p ->
    interpolates h t a b -> interpolates h u a' b' ->
    plane a b p - h p <= plane a' b' p - h p.
Proof.
  intros W (_ & _ & _ & V & _) t u p a b a' b' Ht Hu Ct Cu It Iu.
  destruct (W t Ht) as (a0 & b0 & E & L).
  assert (plane a b p <= plane a0 b0 p).
  { apply (conv_le t); auto using affine_plane. intros v Hv. rewrite It, E by assumption. lra. }
  assert (plane a0 b0 p <= plane a' b' p).
  { apply (conv_le u); auto using affine_plane. intros v Hv. rewrite Iu by assumption.
    apply L. exact (V u Hu v Hv). }
  lra.
Qed.

(** ** Balls *)

Definition contains c (r2 : R) s : Prop := forall v, In v s -> dist2 c v <= r2.

(** Definition 1.20: the smallest closed ball that contains s. *)
Definition min_containment_ball s c (r2 : R) : Prop :=
  contains c r2 s /\ forall c' r2', contains c' r2' s -> r2 <= r2' /\ (r2 = r2' -> c' = c).

Lemma dist2_difference_affine c o : affine (fun p => dist2 c p - dist2 o p).
Proof.
  exists (scale 2 (minus o c)), (norm2 c - norm2 o). intros p. rewrite !dist2_expand.
  unfold plane. rewrite inner_scale, inner_minus. ring.
Qed.

(** The mean of the squared distances from c to the vertices of a convex combination. *)
Lemma mean_distance l c o (r2 : R) : total l = 1 ->
  (forall a v, In (a, v) l -> dist2 o v = r2) ->
  sum_over l (fun av => fst av * dist2 c (snd av)) =
    r2 + dist2 c (combination l) - dist2 o (combination l).
Proof.
  intros H O.
  pose proof (affine_combination _ l (dist2_difference_affine c o) H) as E. cbn beta in E.
  assert (K : sum_over l (fun av => fst av * (dist2 c (snd av) - dist2 o (snd av))) =
              sum_over l (fun av => fst av * dist2 c (snd av)) + (- r2) * total l).
  { clear E H. induction l as [|[a v] l IH]; [cbn; ring|].
    cbn [sum_over fst snd]. rewrite total_cons, IH by (intros; eapply O; right; eauto).
    rewrite (O a v) by now left. ring. }
  rewrite K, H in E. lra.
Qed.

Lemma mean_le l f (r2 : R) : total l = 1 -> (forall a v, In (a, v) l -> 0 <= a /\ f v <= r2) ->
  sum_over l (fun av : R * point d => fst av * f (snd av)) <= r2.
Proof.
  intros H O. replace r2 with (total l * r2) by (rewrite H; ring). clear H.
  induction l as [|[a v] l IH]; [cbn; lra|]. cbn [sum_over fst snd]. rewrite total_cons.
  destruct (O a v (or_introl eq_refl)) as [A F].
  specialize (IH (fun a v H => O a v (or_intror H))).
  assert (a * f v <= a * r2) by now apply Rmult_le_compat_l. lra.
Qed.

(** The nearest point q of a convex set: no vertex is on o's side of the plane through q
    orthogonal to oq. *)
Lemma nearest_obtuse s o q : conv s q -> (forall x, conv s x -> dist2 o q <= dist2 o x) ->
  forall v, In v s -> inner (minus o q) (minus v q) <= 0.
Proof.
  intros Cq N v Hv.
  destruct (Rle_lt_dec (inner (minus o q) (minus v q)) 0) as [|P]; [assumption|exfalso].
  set (a := inner (minus o q) (minus v q)) in *. set (n := norm2 (minus v q)).
  assert (Nn : 0 <= n) by apply norm2_nonneg.
  set (e := a / (a + n)).
  assert (E : e * (a + n) = a) by (unfold e; field; lra).
  assert (He : 0 < e <= 1) by (split; nra).
  specialize (N _ (conv_mix s q v e Cq Hv ltac:(lra))).
  assert (X : dist2 o (mix q v e) = dist2 o q - 2 * e * a + e * e * n).
  { unfold a, n. rewrite !dist2_expand. unfold norm2, mix, minus.
    repeat rewrite ?inner_plus, ?inner_plus_r, ?inner_scale, ?inner_scale_r.
    rewrite ?(inner_comm v q), ?(inner_comm q o), ?(inner_comm v o). ring. }
  rewrite X in N. assert (e * e * n <= e * a) by nra. nra.
Qed.

(** Prop. 4.6: o and r2 belong to a circumball of s, and q is the point of s nearest to o; then q
    is the centre of the min-containment ball, and its squared radius is r^2 - d(o,q)^2. *)
Theorem proposition_4_6 s o r2 q : circumball s o r2 -> conv s q ->
  (forall x, conv s x -> dist2 o q <= dist2 o x) ->
  min_containment_ball s q (r2 - dist2 o q).
Proof.
  intros O Cq N. split.
  - intros v Hv. pose proof (nearest_obtuse s o q Cq N v Hv) as P.
    assert (X : dist2 o v = dist2 o q + dist2 q v - 2 * inner (minus o q) (minus v q)).
    { rewrite !dist2_expand. rewrite inner_minus, !inner_minus_r. unfold norm2. ring. }
    rewrite (O v Hv) in X. lra.
  - intros c' r2' C'. destruct Cq as (l & L & H & E).
    pose proof (mean_distance l c' o r2 H (fun a v I => O v (proj2 (L a v I)))) as M.
    pose proof (mean_le l (dist2 c') r2' H
      (fun a v I => conj (proj1 (L a v I)) (C' v (proj2 (L a v I))))) as B.
    rewrite E in M. pose proof (norm2_nonneg (minus c' q)) as D. fold (dist2 c' q) in D.
    split; [lra|]. intros Q. assert (Z : norm2 (minus c' q) = 0) by (fold (dist2 c' q); lra).
    apply norm2_zero in Z. rewrite <- (minus_plus c' q), Z. apply origin_plus.
Qed.

(** Prop. 4.7: among all triangulations of S the Delaunay triangulation minimises the largest
    min-containment ball: for each of its simplices t, with the ball of Prop. 4.6, every
    triangulation U has a simplex that no smaller ball contains. *)
Theorem proposition_4_7 S T U : delaunay_triangulation S T -> fills S U ->
  forall t o r2 q, In t T -> circumball t o r2 -> (forall p, In p S -> ~ dist2 o p < r2) ->
    conv t q -> (forall x, conv t x -> dist2 o q <= dist2 o x) ->
    exists u, In u U /\ forall c r2', contains c r2' u -> r2 - dist2 o q <= r2'.
Proof.
  intros ((FT & _) & _) FU t o r2 q Ht O Empty Cq _.
  destruct FT as (_ & _ & _ & _ & UT). destruct FU as (_ & _ & _ & VU & UU).
  assert (CS : conv S q) by (apply UT; eauto).
  apply UU in CS. destruct CS as (u & Hu & Cu). exists u. split; [assumption|].
  intros c r2' B. destruct Cu as (l & L & H & <-).
  (* the mean over u's vertices of the power with respect to the ball (o, r2), which is empty *)
  pose proof (affine_combination _ l (dist2_difference_affine c o) H) as E. cbn beta in E.
  pose proof (mean_le l (dist2 c) r2' H
    (fun a v I => conj (proj1 (L a v I)) (B v (proj2 (L a v I))))) as M.
  assert (K : sum_over l (fun av => fst av * (dist2 c (snd av) - dist2 o (snd av))) <=
              sum_over l (fun av => fst av * dist2 c (snd av)) - r2 * total l).
  { assert (G : forall m, (forall a v, In (a, v) m -> 0 <= a /\ r2 <= dist2 o v) ->
      sum_over m (fun av => fst av * (dist2 c (snd av) - dist2 o (snd av))) <=
      sum_over m (fun av => fst av * dist2 c (snd av)) - r2 * total m).
    { clear. induction m as [|[a v] m IH]; intros X; [cbn; lra|]. cbn [sum_over fst snd].
      rewrite total_cons. destruct (X a v (or_introl eq_refl)) as [A F].
      specialize (IH (fun a v H => X a v (or_intror H))).
      assert (a * r2 <= a * dist2 o v) by now apply Rmult_le_compat_l. lra. }
    apply G. intros a v I. destruct (L a v I) as [A V]. split; [assumption|].
    specialize (Empty v (VU u Hu v V)). lra. }
  rewrite H in K. pose proof (norm2_nonneg (minus c (combination l))) as D.
  fold (dist2 c (combination l)) in D. lra.
Qed.
End Optimality.
