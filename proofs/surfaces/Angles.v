(** * The sum of two angles: what the integers of the checker say of it *)
From Coq Require Import Rbase Rfunctions Lra Psatz List ZArith Bool.
From Circumspect Require Import SurfaceChecker Vectors Definitions Orientation Integers.
From Circumspect Require Balls.
Import ListNotations.
Open Scope R_scope.

(** ** Cosines *)

(** The checker's integers tell the sign of a sum of two fractions. *)
Lemma sum_sign (x a y b : R) : 0 < a -> 0 < b ->
  (0 <= x * Rabs x * (y * y + b) + y * Rabs y * (x * x + a) <->
   if Rle_dec 0 x then 0 <= y \/ y * y * a <= x * x * b
   else 0 <= y /\ x * x * b <= y * y * a).
Proof.
  intros A B. assert (X : 0 <= x * x) by nra. assert (Y : 0 <= y * y) by nra.
  destruct (Rle_dec 0 x) as [Px|Px];
    [rewrite (Rabs_pos_eq x Px)|apply Rnot_le_lt in Px; rewrite (Rabs_left x Px)];
    (destruct (Rle_dec 0 y) as [Py|Py];
      [rewrite (Rabs_pos_eq y Py)|apply Rnot_le_lt in Py; rewrite (Rabs_left y Py)]).
  - split; [intros _; now left|intros _].
    apply Rplus_le_le_0_compat; apply Rmult_le_pos; lra.
  - replace (x * x * (y * y + b) + y * - y * (x * x + a)) with (x * x * b - y * y * a) by ring.
    split; [intros H; right; lra|intros [H|H]; lra].
  - replace (x * - x * (y * y + b) + y * y * (x * x + a)) with (y * y * a - x * x * b) by ring.
    split; [intros H; split; lra|intros [_ H]; lra].
  - split; [|intros [H _]; lra]. intros H. exfalso. assert (0 < x * x) by nra.
    assert (0 < x * x * (y * y + b)) by (apply Rmult_lt_0_compat; lra).
    assert (0 <= y * y * (x * x + a)) by (apply Rmult_le_pos; lra). nra.
Qed.
Lemma sum_of_fractions (x m y n : R) : 0 < m -> 0 < n ->
  (0 <= x / m + y / n <-> 0 <= x * n + y * m).
Proof.
  intros M N. replace (x / m + y / n) with ((x * n + y * m) / (m * n)) by (field; lra).
  assert (K : 0 < m * n) by now apply Rmult_lt_0_compat. split; intros H.
  - apply (Rmult_le_compat_r (m * n)) in H; [|lra]. unfold Rdiv in H.
    rewrite Rmult_assoc, Rinv_l in H; lra.
  - apply Rmult_le_pos; [assumption|]. left. now apply Rinv_0_lt_compat.
Qed.

(** ** Vectors *)

Lemma angle_sym {d} (o p q : point d) : signed_cos2 o p q = signed_cos2 o q p.
Proof.
  unfold signed_cos2. cbv zeta. rewrite (inner_comm (minus p o)), (Rmult_comm (dist2 p o)).
  reflexivity.
Qed.

Section Places.
Context {d : nat} (r : R).
Hypothesis unit_positive : 0 < r.
Notation place := (@place_of d r).

Lemma minus_places : forall p q : site, well_shaped d p -> well_shaped d q ->
  minus (place p) (place q) =
    scale r (integer_point d (differences (coordinates p) (coordinates q))).
Proof.
  unfold well_shaped, place_of. intros p q. generalize (coordinates p), (coordinates q).
  clear p q. induction d as [|n IH]; intros [|x p] [|y q] P Q; try discriminate; [reflexivity|].
  injection P as P. injection Q as Q. specialize (IH p q P Q).
  cbn [differences integer_point hd tl]. unfold minus, plus, scale in *.
  cbn [Vector.map Vector.map2]. rewrite Vector.map_map in *. cbn. f_equal; [|exact IH].
  rewrite minus_IZR. ring.
Qed.
Lemma differences_length p q : length p = d -> length q = d -> length (differences p q) = d.
Proof.
  clear r unit_positive. revert p q. induction d as [|n IH]; intros [|x p] [|y q] P Q;
    try discriminate; [reflexivity|]. cbn in *. f_equal. apply IH; lia.
Qed.
Lemma inner_places o p q : well_shaped d o -> well_shaped d p -> well_shaped d q ->
  inner (minus (place p) (place o)) (minus (place q) (place o)) =
    r * r * IZR (inner_product (differences (coordinates p) (coordinates o))
      (differences (coordinates q) (coordinates o))).
Proof.
  intros O P Q. rewrite !minus_places, inner_scale, inner_scale_r by assumption.
  rewrite Balls.inner_of_integers by now apply differences_length. ring.
Qed.

(** ** The two together *)

Section Cosine.
Variables o p q : site.
Hypotheses (O : well_shaped d o) (P : well_shaped d p) (Q : well_shaped d q).
Notation x := (IZR (fst (cotangent o p q))).
Notation a := (IZR (snd (cotangent o p q))).
Hypothesis proper : (0 < snd (cotangent o p q))%Z.

Lemma signed_cos2_places :
  signed_cos2 (place o) (place p) (place q) = x * Rabs x / (x * x + a).
Proof.
  pose proof (IZR_lt _ _ proper) as A.
  unfold signed_cos2, dist2, norm2. cbv zeta. rewrite !inner_places by assumption.
  unfold cotangent in *. cbn [fst snd] in *. rewrite minus_IZR, !mult_IZR in *.
  generalize dependent (IZR (inner_product (differences (coordinates p) (coordinates o))
    (differences (coordinates p) (coordinates o)))).
  generalize dependent (IZR (inner_product (differences (coordinates q) (coordinates o))
    (differences (coordinates q) (coordinates o)))).
  generalize (IZR (inner_product (differences (coordinates p) (coordinates o))
    (differences (coordinates q) (coordinates o)))). intros X V U A.
  assert (K : 0 < U * V) by nra.
  assert (U <> 0) by (intros Z; rewrite Z in K; lra).
  assert (V <> 0) by (intros Z; rewrite Z in K; lra).
  rewrite Rabs_mult, (Rabs_pos_eq (r * r)) by nra.
  replace (X * X + (U * V - X * X)) with (U * V) by ring. field. repeat split; lra || assumption.
Qed.
End Cosine.

Lemma angles_decided a p q b p' q' :
  (forall s, In s [a; p; q; b; p'; q'] -> well_shaped d s) ->
  (0 < snd (cotangent a p q))%Z -> (0 < snd (cotangent b p' q'))%Z ->
  (at_most_pi (cotangent a p q) (cotangent b p' q') = true <->
  0 <= signed_cos2 (place a) (place p) (place q) + signed_cos2 (place b) (place p') (place q')).
Proof.
  intros W A B.
  assert (Wa : well_shaped d a) by (apply W; cbn; auto 10).
  assert (Wp : well_shaped d p) by (apply W; cbn; auto 10).
  assert (Wq : well_shaped d q) by (apply W; cbn; auto 10).
  assert (Wb : well_shaped d b) by (apply W; cbn; auto 10).
  assert (Wp' : well_shaped d p') by (apply W; cbn; auto 10).
  assert (Wq' : well_shaped d q') by (apply W; cbn; auto 10).
  rewrite (signed_cos2_places a p q Wa Wp Wq A), (signed_cos2_places b p' q' Wb Wp' Wq' B).
  apply IZR_lt in A, B. destruct (cotangent a p q) as [x e], (cotangent b p' q') as [y f].
  cbn [fst snd] in *.
  rewrite sum_of_fractions, (sum_sign (IZR x) (IZR e) (IZR y) (IZR f) A B) by nra.
  assert (L : forall z, (0 <=? z)%Z = true <-> 0 <= IZR z).
  { intros z. rewrite Z.leb_le. split; [apply IZR_le|apply le_IZR]. }
  assert (C : forall z k, (z <=? k)%Z = true <-> IZR z <= IZR k).
  { intros z k. rewrite Z.leb_le. split; [apply IZR_le|apply le_IZR]. }
  unfold at_most_pi. destruct (Rle_dec 0 (IZR x)) as [X|X].
  - now rewrite (proj2 (L x) X), orb_true_iff, L, C, !mult_IZR.
  - destruct (0 <=? x)%Z eqn:E; [exfalso; apply X; now apply L|].
    now rewrite andb_true_iff, L, C, !mult_IZR.
Qed.
End Places.

(** ** Three points on a line *)

Section Line.
Context {d : nat}.
Variables o p q : point d.
Notation u := (minus p o).
Notation v := (minus q o).
Notation gram := (inner u u * inner v v - inner u v * inner u v).

(** The combination without the coefficient of [o], which is that of the sum 0. *)
Lemma combination_inner a b c w : total (combine [a; b; c] [o; p; q]) = 0 ->
  inner (combination (combine [a; b; c] [o; p; q])) w = b * inner u w + c * inner v w.
Proof.
  cbn [combine]. rewrite !total_cons, !combination_cons. cbn [total fold_right].
  change (combination (@nil (R * point d))) with (@origin d). intros Z.
  rewrite !inner_plus, !inner_scale, inner_origin, !inner_minus.
  replace a with (- b - c) by lra. ring.
Qed.

Lemma gram_independent : gram <> 0 -> affinely_independent [o; p; q].
Proof.
  intros G l L Z E. destruct l as [|a [|b [|c [|? ?]]]]; try discriminate.
  pose proof (fun w => combination_inner a b c w Z) as K. rewrite E in K.
  pose proof (K u) as Ku. pose proof (K v) as Kv. rewrite inner_origin, (inner_comm v u) in Ku.
  rewrite inner_origin in Kv. cbn [combine] in Z. rewrite !total_cons in Z.
  cbn [total fold_right] in Z.
  assert (B : b * gram = 0).
  { replace (b * gram) with ((b * inner u u + c * inner u v) * inner v v -
      (b * inner u v + c * inner v v) * inner u v) by ring. rewrite <- Ku, <- Kv. ring. }
  assert (C : c * gram = 0).
  { replace (c * gram) with ((b * inner u v + c * inner v v) * inner u u -
      (b * inner u u + c * inner u v) * inner u v) by ring. rewrite <- Ku, <- Kv. ring. }
  apply Rmult_integral in B, C. destruct B as [->|B]; [|contradiction].
  destruct C as [->|C]; [|contradiction].
  intros x [<-|[<-|[<-|[]]]]; lra.
Qed.
End Line.

Section Gram.
Context {d : nat}.
Implicit Types o p q : point d.

Definition gram o p q : R := inner (minus p o) (minus p o) * inner (minus q o) (minus q o) -
  inner (minus p o) (minus q o) * inner (minus p o) (minus q o).
Lemma gram_swap o p q : gram o p q = gram o q p /\ gram o p q = gram p o q.
Proof.
  unfold gram. rewrite !inner_minus, !inner_minus_r, (inner_comm q p), (inner_comm o p),
    (inner_comm o q). split; ring.
Qed.
End Gram.

(** The vertex with number [i] of three, and the others. *)
Section Split.
Context {A : Type}.

Lemma split3_three i (l : list A) o p q : split3 i l = Some (o, p, q) ->
  length l = 3%nat /\ (i < 3)%nat /\ (forall x, In x l <-> x = o \/ x = p \/ x = q) /\
  (NoDup l -> o <> p /\ o <> q /\ p <> q).
Proof.
  destruct l as [|x [|y [|z [|? ?]]]]; try discriminate.
  destruct i as [|[|[|i]]]; try discriminate; cbn; intros E; injection E as <- <- <-;
    (split; [reflexivity|]; split; [lia|]; split; [intuition congruence|]);
    intros N; inversion_clear N as [|? ? Nx N']; inversion_clear N' as [|? ? Ny _]; cbn in Nx, Ny;
    repeat split; intros E; subst; tauto.
Qed.
Lemma split3_related {B} (R : A -> B -> Prop) i l m o p q : Forall2 R l m ->
  split3 i l = Some (o, p, q) -> exists o' p' q', split3 i m = Some (o', p', q') /\
    R o o' /\ R p p' /\ R q q'.
Proof.
  intros F E. destruct l as [|x [|y [|z [|? ?]]]]; try discriminate.
  inversion F as [|? x' ? m1 Rx F1]; subst. inversion F1 as [|? y' ? m2 Ry F2]; subst.
  inversion F2 as [|? z' ? m3 Rz F3]; subst. inversion F3; subst.
  destruct i as [|[|[|i]]]; try discriminate; cbn in E |- *; injection E as <- <- <-;
    repeat eexists; assumption.
Qed.
(** Whatever three different members are called, one is opposite the two others. *)
Lemma split3_of {B} (f : A -> B) l a p q : length l = 3%nat -> In a (map f l) -> In p (map f l) ->
  In q (map f l) -> a <> p -> a <> q -> p <> q ->
  exists i o x y, split3 i l = Some (o, x, y) /\ f o = a /\
    (f x = p /\ f y = q \/ f x = q /\ f y = p).
Proof.
  destruct l as [|x [|y [|z [|? ?]]]]; try discriminate. intros _.
  intros [<-|[<-|[<-|[]]]] [<-|[<-|[<-|[]]]] [<-|[<-|[<-|[]]]] N N' N''; try congruence;
    [exists 0%nat, x, y, z|exists 0%nat, x, y, z|exists 1%nat, y, x, z|exists 1%nat, y, x, z|
     exists 2%nat, z, x, y|exists 2%nat, z, x, y]; auto.
Qed.
End Split.

Section Triangles.
Context {d : nat} (r : R).
Hypothesis unit_positive : 0 < r.
Notation place := (@place_of d r).

Lemma cotangent_gram o p q : well_shaped d o -> well_shaped d p -> well_shaped d q ->
  gram (place o) (place p) (place q) = (r * r) * (r * r) * IZR (snd (cotangent o p q)).
Proof.
  intros O P Q. unfold gram. rewrite !inner_places by assumption.
  unfold cotangent. cbn [snd]. rewrite minus_IZR, !mult_IZR. ring.
Qed.
Lemma cotangent_positive o p q : well_shaped d o -> well_shaped d p -> well_shaped d q ->
  ((0 < snd (cotangent o p q))%Z <-> 0 < gram (place o) (place p) (place q)).
Proof.
  intros O P Q. rewrite cotangent_gram by assumption. set (z := snd _).
  assert (K : 0 < r * r * (r * r)) by (repeat apply Rmult_lt_0_compat; assumption). split.
  - intros Z. apply IZR_lt in Z. now apply Rmult_lt_0_compat.
  - intros Z. apply lt_IZR. apply (Rmult_lt_reg_l _ _ _ K). lra.
Qed.

Lemma on_no_line_split X i o p q : Forall (well_shaped d) X -> on_no_line X = true ->
  split3 i X = Some (o, p, q) ->
  (0 < snd (cotangent o p q))%Z /\ (0 < snd (cotangent o q p))%Z.
Proof.
  intros F L E. destruct X as [|x [|y [|z [|? ?]]]]; try discriminate.
  inversion_clear F as [|? ? Wx F1]. inversion_clear F1 as [|? ? Wy F2].
  inversion_clear F2 as [|? ? Wz _]. cbn in L. apply Z.ltb_lt in L.
  change (0 < snd (cotangent x y z))%Z in L. apply cotangent_positive in L; try assumption.
  pose proof (gram_swap (place x) (place y) (place z)) as [A B].
  pose proof (gram_swap (place x) (place z) (place y)) as [_ C].
  pose proof (gram_swap (place y) (place x) (place z)) as [D _].
  pose proof (gram_swap (place z) (place x) (place y)) as [H _].
  destruct i as [|[|[|i]]]; try discriminate; cbn in E; injection E as <- <- <-;
    rewrite !cotangent_positive by assumption; lra.
Qed.
Lemma on_no_line_independent X : Forall (well_shaped d) X -> on_no_line X = true ->
  length X = 3%nat /\ affinely_independent (map place X).
Proof.
  intros F L. destruct X as [|x [|y [|z [|? ?]]]]; try discriminate. split; [reflexivity|].
  inversion_clear F as [|? ? Wx F1]. inversion_clear F1 as [|? ? Wy F2].
  inversion_clear F2 as [|? ? Wz _]. cbn in L. apply Z.ltb_lt in L.
  change (0 < snd (cotangent x y z))%Z in L. apply cotangent_positive in L; try assumption.
  apply gram_independent. unfold gram in L. lra.
Qed.
End Triangles.
