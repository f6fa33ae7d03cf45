(** * Affine functions, and points in general position

    An affine function is p |-> <a, p> + b.  Finitely many affine functions that are positive at a
    point stay so nearby ([nearby]), and there one finds points at which finitely many other affine
    functions, none of them identically zero, do not vanish ([general_position]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List.
From Circumspect Require Import Definitions Vectors.
Import ListNotations.
Open Scope R_scope.

(** The sum of f(i) over i in [l]; [sum n f] is that over i < n. *)
Fixpoint sum_over {A} (l : list A) (f : A -> R) : R :=
  match l with [] => 0 | i :: l' => f i + sum_over l' f end.
Definition sum (n : nat) (f : nat -> R) : R := sum_over (seq 0 n) f.

Section Sums.
Context {A : Type}.
Implicit Types (l : list A) (f g : A -> R).
Lemma sum_ext l f g : (forall i, In i l -> f i = g i) -> sum_over l f = sum_over l g.
Proof. induction l as [|a l IH]; intros H; cbn; [reflexivity|].
  rewrite (H a), IH; auto; [intros; apply H; now right | now left]. Qed.
Lemma sum_plus l f g : sum_over l (fun i => f i + g i) = sum_over l f + sum_over l g.
Proof. induction l; cbn; [ring|]. rewrite IHl. ring. Qed.
Lemma sum_scale l c f : sum_over l (fun i => c * f i) = c * sum_over l f.
Proof. induction l; cbn; [ring|]. rewrite IHl. ring. Qed.
Lemma sum_zero l f : (forall i, In i l -> f i = 0) -> sum_over l f = 0.
Proof. intros H. rewrite (sum_ext l f (fun _ => 0)) by assumption.
  clear H. induction l; cbn; lra. Qed.
Lemma sum_nonneg l f : (forall i, In i l -> 0 <= f i) -> 0 <= sum_over l f.
Proof. induction l as [|a l IH]; intros H; cbn; [lra|].
  pose proof (H a (or_introl eq_refl)). specialize (IH (fun i Hi => H i (or_intror Hi))). lra. Qed.
Lemma sum_pos l f k : (forall i, In i l -> 0 <= f i) -> In k l -> 0 < f k -> 0 < sum_over l f.
Proof. induction l as [|a l IH]; intros H Hk P; [destruct Hk|]. destruct Hk as [->|Hk]; cbn.
  - pose proof (sum_nonneg l f (fun i Hi => H i (or_intror Hi))). lra.
  - pose proof (H a (or_introl eq_refl)). specialize (IH (fun i Hi => H i (or_intror Hi)) Hk P).
    lra.
Qed.
(** All terms but one vanish. *)
Lemma sum_one l f k : NoDup l -> In k l -> (forall i, In i l -> i <> k -> f i = 0) ->
  sum_over l f = f k.
Proof.
  induction l as [|a l IH]; intros N Hk H; [destruct Hk|].
  destruct Hk as [->|Hk]; cbn; inversion N; subst.
  - rewrite (sum_zero l f); [ring|]. intros i Hi. apply H; [now right|]. now intros ->.
  - rewrite IH; auto; [|intros; apply H; [now right|assumption]].
    rewrite (H a); [ring|now left|]. now intros ->.
Qed.
End Sums.

(** ** Affine functions *)
Section Affine.
Context {d : nat}.
Implicit Types (p q x y : point d) (f g : point d -> R).

Definition affine f : Prop := exists a b, forall p, f p = plane a b p.

(** The point that divides the segment pq in the ratio s : 1 - s. *)
Definition mix p q (s : R) : point d := plus (scale (1 - s) p) (scale s q).

Lemma affine_mix f p q s : affine f -> f (mix p q s) = (1 - s) * f p + s * f q.
Proof. intros (a & b & H). rewrite !H. unfold plane, mix.
  rewrite inner_plus_r, !inner_scale_r. ring. Qed.
Lemma affine_combine f g c e : affine f -> affine g -> affine (fun p => c * f p + e * g p).
Proof. intros (a & b & H) (a' & b' & H').
  exists (plus (scale c a) (scale e a')), (c * b + e * b'). intros p. rewrite H, H'.
  unfold plane. rewrite inner_plus, !inner_scale. ring. Qed.
Lemma affine_opp f : affine f -> affine (fun p => - f p).
Proof. intros (a & b & H). exists (scale (-1) a), (- b). intros p. rewrite H. unfold plane.
  rewrite inner_scale. ring. Qed.
Lemma affine_const c : affine (fun _ => c).
Proof. exists origin, c. intros p. unfold plane. rewrite inner_origin. ring. Qed.
Lemma affine_scale f c : affine f -> affine (fun p => c * f p).
Proof. intros (a & b & H). exists (scale c a), (c * b). intros p. rewrite H. unfold plane.
  rewrite inner_scale. ring. Qed.
Lemma affine_plane a b : affine (plane a b).
Proof. now exists a, b. Qed.
Lemma affine_ext f g : (forall p, f p = g p) -> affine f -> affine g.
Proof. intros E (a & b & H). exists a, b. intros p. now rewrite <- E. Qed.
Lemma affine_sum {A} (l : list A) (F : A -> point d -> R) : (forall i, In i l -> affine (F i)) ->
  affine (fun p => sum_over l (fun i => F i p)).
Proof.
  induction l as [|a l IH]; intros H; cbn; [apply affine_const|].
  apply affine_ext with (fun p => 1 * F a p + 1 * sum_over l (fun i => F i p)).
  - intros; ring.
  - apply affine_combine; [apply H; now left | apply IH; intros; apply H; now right].
Qed.

(** Affine functions tell points apart. *)
Lemma affine_separate p q : (forall f, affine f -> f p = f q) -> p = q.
Proof.
  intros H. pose proof (H (plane (minus p q) 0) (affine_plane _ _)) as E. unfold plane in E.
  assert (Z : norm2 (minus p q) = 0) by (unfold norm2; rewrite inner_minus_r; lra).
  apply norm2_zero in Z. rewrite <- (minus_plus p q), Z. apply origin_plus.
Qed.

Lemma affine_combination f l : affine f -> total l = 1 ->
  f (combination l) = sum_over l (fun ap => fst ap * f (snd ap)).
Proof.
  intros (a & b & H) T. rewrite H. unfold plane.
  assert (G : forall m, inner a (combination m) + total m * b =
                   sum_over m (fun ap => fst ap * f (snd ap))).
  { induction m as [|[c p] m IH].
    - cbn [sum_over total combination fold_right]. rewrite inner_origin_r. ring.
    - rewrite combination_cons, total_cons, inner_plus_r, inner_scale_r.
      cbn [sum_over fst snd]. rewrite <- IH, H. unfold plane. ring. }
  rewrite <- G, T. ring.
Qed.

(** An affine function that is non-negative on [X] is non-negative on conv X. *)
Lemma affine_conv f X q : affine f -> (forall p, In p X -> 0 <= f p) -> conv X q -> 0 <= f q.
Proof.
  intros A H (l & Hl & T & <-). rewrite (affine_combination f l A T).
  apply sum_nonneg. intros [a p] I. destruct (Hl a p I). cbn.
  apply Rmult_le_pos; auto.
Qed.

(** ** General position *)

Lemma nearby (G : list (point d -> R)) y p : (forall g, In g G -> affine g /\ 0 < g y) ->
  exists e0, 0 < e0 < 1 /\ forall e, 0 <= e <= e0 -> forall g, In g G -> 0 < g (mix y p e).
Proof.
  induction G as [|g G IH]; intros H.
  - exists (1/2). split; [lra|]. intros e _ g [].
  - destruct IH as (e1 & H1 & K1). { intros; apply H; now right. }
    destruct (H g) as [Ag Pg]; [now left|].
    set (q := Rabs (g p) + 1).
    assert (Q : 0 < q /\ - q < g p).
    { unfold q. pose proof (Rabs_pos (g p)). unfold Rabs in *. destruct (Rcase_abs (g p)); lra. }
    set (e2 := g y / (g y + q)).
    assert (E2 : e2 * (g y + q) = g y) by (unfold e2; field; lra).
    assert (0 < e2) by nra.
    exists (Rmin e1 e2). split.
    + split; [apply Rmin_glb_lt; lra | pose proof (Rmin_l e1 e2); lra].
    + intros e He g' [<-|Hg'].
      * rewrite (affine_mix _ _ _ _ Ag). pose proof (Rmin_r e1 e2). pose proof (Rmin_l e1 e2).
        assert (e <= e2) by lra. assert (e < 1) by lra.
        (* (1-e) g y + e g p > (1-e) g y - e q = g y - e (g y + q) >= 0 *)
        destruct (Rle_lt_or_eq_dec 0 e ltac:(lra)) as [Pe|<-]; nra.
      * apply K1; auto. pose proof (Rmin_l e1 e2). lra.
Qed.

Lemma general_position (F : list (point d -> R)) : forall (G : list (point d -> R)) y0,
  (forall f, In f F -> affine f /\ exists p, f p <> 0) ->
  (forall g, In g G -> affine g /\ 0 < g y0) ->
  exists y, (forall g, In g G -> 0 < g y) /\ (forall f, In f F -> f y <> 0).
Proof.
  induction F as [|f F IH]; intros G y0 HF HG.
  - exists y0. split; [intros; now apply HG | intros f []].
  - destruct (HF f (or_introl eq_refl)) as [Af [p Hp]].
    assert (exists y1, (forall g, In g G -> 0 < g y1) /\ f y1 <> 0) as (y1 & HG1 & Hf1).
    { destruct (Req_dec (f y0) 0) as [Z|N].
      - destruct (nearby G y0 p HG) as (e & He & K). exists (mix y0 p e). split.
        + apply K; lra.
        + rewrite (affine_mix _ _ _ _ Af), Z. nra.
      - exists y0. split; [intros; now apply HG|assumption]. }
    destruct (Rlt_dec (f y1) 0) as [Neg|Pos].
    + destruct (IH ((fun q => - f q) :: G) y1) as (y & Y1 & Y2).
      * intros; apply HF; now right.
      * intros g [<-|Hg]; [split; [now apply affine_opp|lra]|]. split; [now apply HG|auto].
      * exists y. split; [intros; apply Y1; now right|].
        intros f' [<-|Hf']; [|auto]. specialize (Y1 _ (or_introl eq_refl)). simpl in Y1. lra.
    + destruct (IH (f :: G) y1) as (y & Y1 & Y2).
      * intros; apply HF; now right.
      * intros g [<-|Hg]; [split; [assumption|lra]|]. split; [now apply HG|auto].
      * exists y. split; [intros; apply Y1; now right|].
        intros f' [<-|Hf']; [|auto]. specialize (Y1 _ (or_introl eq_refl)). lra.
Qed.

End Affine.
