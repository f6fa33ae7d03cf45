(** * The optimality of the Delaunay triangulation in R^d  (Book: Section 4.3)

    Lifted, a Delaunay triangulation is the underside of conv S^+, and no triangulation of the same
    points passes below it: so it interpolates |p|^2 best at every point (Prop. 4.5).  Over one
    simplex the error is r^2 - d(o,p)^2; its maximum is the squared radius of the min-containment
    ball (Prop. 4.6, with [Nearest.v]); so the largest such ball is smallest for the Delaunay
    triangulation (Prop. 4.7).  Heights are arbitrary in the first, hence weighted and anisotropic
    too. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Adjacency LiftingMap Nearest.
Import ListNotations.
Open Scope R_scope.

Section Optimality.
Context {d : nat}.
Implicit Types (p q o c v : point d) (h : point d -> R) (S : list (point d)) (s t u : simplex d)
  (T U : list (simplex d)).

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

(** At every point of conv S a (weighted) Delaunay triangulation minimises the interpolated height
    T^+(p) among all triangulations. *)
Lemma lowest h S T U : (forall t, In t T -> witness_plane h S t) -> fills S U ->
  forall t u p a b a' b', In t T -> In u U -> conv t p -> conv u p ->
    interpolates h t a b -> interpolates h u a' b' -> plane a b p <= plane a' b' p.
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

Theorem proposition_4_5_heights h S T U p e e' :
  (forall t, In t T -> witness_plane h S t) -> fills S U ->
  interpolation_error h T p e -> interpolation_error h U p e' -> e <= e'.
Proof.
  intros W F (t & a & b & Ht & C & V & ->) (u & a' & b' & Hu & C' & V' & ->).
  pose proof (lowest h S T U W F t u p a b a' b' Ht Hu C C' V V'). lra.
Qed.

(** A triangulation has exactly one error at each point, since it agrees with itself on faces. *)
Theorem one_error h S T p : fills S T -> conv S p -> exists! e, interpolation_error h T p e.
Proof.
  intros F C. assert (F' := F). destruct F' as (L & (_ & _ & M) & _ & _ & U). apply U in C.
  assert (K : forall t, In t T -> faces_of T t).
  { intros t Ht. split; [now apply L|]. split; [|exists t; split; [assumption|apply incl_refl]].
    intros ->. destruct (L [] Ht). discriminate. }
  destruct C as (t & Ht & C). destruct (fills_frame S T t F Ht) as (g & E).
  destruct (witness_affine h g) as (a & b & W). exists (plane a b p - h p).
  assert (I : interpolates h t a b).
  { intros v Hv. rewrite <- W. rewrite <- E in Hv. apply in_vertices in Hv.
    destruct Hv as (i & Hi & ->). now apply witness_vertex. }
  split; [now exists t, a, b|]. intros e (u & a' & b' & Hu & C' & I' & ->).
  destruct (M t u (K t Ht) (K u Hu)) as (f & Ft & Fu & Cf). specialize (Cf p C C').
  assert (plane a b p <= plane a' b' p).
  { apply (conv_le f); auto using affine_plane. intros v Hv. rewrite I, I' by auto. lra. }
  assert (plane a' b' p <= plane a b p).
  { apply (conv_le f); auto using affine_plane. intros v Hv. rewrite I, I' by auto. lra. }
  lra.
Qed.

(** ** Balls *)

Lemma dist2_difference_affine c o : affine (fun p => dist2 c p - dist2 o p).
Proof.
  exists (scale 2 (minus o c)), (norm2 c - norm2 o). intros p. rewrite !dist2_expand.
  unfold plane. rewrite inner_scale, inner_minus. ring.
Qed.

(** The paraboloid is convex: interpolation overestimates. *)
Lemma error_nonnegative T p e : interpolation_error norm2 T p e -> 0 <= e.
Proof.
  intros (t & a & b & _ & C & V & ->). destruct (plane_ball a b) as (c & r2 & E).
  assert (B : circumball t c r2) by (apply circumball_plane; intros; rewrite E; auto).
  pose proof (ball_plane_power c r2 p) as P. rewrite E in P.
  assert (H : 0 <= r2 - (dist2 c p - dist2 p p)).
  { assert (A : affine (fun q => 1 * r2 + -1 * (dist2 c q - dist2 p q)))
      by auto using affine_combine, affine_const, dist2_difference_affine.
    apply Rle_trans with (1 * r2 + -1 * (dist2 c p - dist2 p p)); [|lra].
    apply (affine_conv _ t _ A); [|assumption].
    intros v Hv. rewrite (B v Hv). pose proof (norm2_nonneg (minus p v)). unfold dist2 in *. lra. }
  assert (Z : dist2 p p = 0) by (unfold dist2; rewrite minus_self; apply inner_origin). lra.
Qed.

(** Prop. 4.5: of all triangulations of S the Delaunay triangulation has the least error at every
    point of conv S. *)
Theorem proposition_4_5 S T U p e e' : delaunay_triangulation S T -> triangulation S U ->
  interpolation_error norm2 T p e -> interpolation_error norm2 U p e' -> 0 <= e <= e'.
Proof.
  intros [_ D] [F _] E E'. split; [exact (error_nonnegative T p e E)|].
  apply (proposition_4_5_heights norm2 S T U p); auto.
  intros t Ht. apply delaunay_witness_plane. auto.
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

(** The point q of a Delaunay simplex is in a simplex of U that no ball contains which is smaller
    than the ball of Prop. 4.6. *)
Lemma no_smaller_ball S T U : delaunay_triangulation S T -> fills S U ->
  forall t o r2 q, In t T -> circumball t o r2 -> (forall p, In p S -> ~ dist2 o p < r2) ->
    conv t q ->
    exists u, In u U /\ forall c r2', contains c r2' u -> r2 - dist2 o q <= r2'.
Proof.
  intros ((FT & _) & _) FU t o r2 q Ht O Empty Cq.
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

(** Prop. 4.7: of all triangulations of S the Delaunay triangulation minimises the largest
    min-containment ball: every triangulation has for each Delaunay simplex one whose
    min-containment ball is no smaller. *)
Theorem proposition_4_7 S T U : delaunay_triangulation S T -> fills S U ->
  forall t c r2, In t T -> min_containment_ball t c r2 ->
    exists u, In u U /\ forall c' r2', contains c' r2' u -> r2 <= r2'.
Proof.
  intros D F t c r2 Ht [_ M]. assert (D' := D). destruct D' as [[FT _] DT].
  destruct (DT t Ht) as (o & R2 & O & Empty).
  destruct (fills_frame S T t FT Ht) as (g & E). destruct (nearest_point g o) as (q & Cq & Nq).
  rewrite E in Cq, Nq. destruct (proposition_4_6 t o R2 q O Cq Nq) as [B _].
  destruct (no_smaller_ball S T U D F t o R2 q Ht O Empty Cq) as (u & Hu & Min).
  exists u. split; [assumption|]. intros c' r2' C'. specialize (Min c' r2' C').
  destruct (M q (R2 - dist2 o q) B). lra.
Qed.

(** Every d-simplex has a min-containment ball, and only one. *)
Theorem one_min_containment_ball S T t : fills S T -> In t T ->
  exists c r2, min_containment_ball t c r2 /\
    forall c' r2', min_containment_ball t c' r2' -> c' = c /\ r2' = r2.
Proof.
  intros F Ht. destruct (fills_frame S T t F Ht) as (g & E).
  destruct (circumball_frame g) as (o & R2 & O & _).
  destruct (nearest_point g o) as (q & Cq & Nq). rewrite E in O, Cq, Nq.
  pose proof (proposition_4_6 t o R2 q O Cq Nq) as B. exists q, (R2 - dist2 o q).
  split; [assumption|]. intros c' r2' [C' M']. destruct B as [B M].
  destruct (M c' r2' C') as [L1 Eq], (M' q _ B) as [L2 _].
  assert (R2 - dist2 o q = r2') by lra. auto.
Qed.
End Optimality.
