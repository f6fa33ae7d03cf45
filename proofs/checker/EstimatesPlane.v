(** * What the quick check's estimates amount to in the plane

    As [Estimates.v] and [Rounded.v] have it in space. *)
From Coq Require Import ZArith List Bool Lia.
From Circumspect Require Import Numbering Integers.
From Circumspect Require Import QuickPlane Estimates Rounded.
From Circumspect Require Import Word.
Import ListNotations.
Open Scope Z_scope.

(** ** Estimates in the plane *)

Definition estimated_step (S M e : Z) (v : Z * Z) (p : step) : Prop :=
  let '(x, y) := v in estimate S x M e (east p) /\ estimate S y M e (north p).
Definition times2 (a : Z) (v : Z * Z) : Z * Z := let '(x, y) := v in (a * x, a * y).
Definition square2 (v : Z * Z) : Z := let '(x, y) := v in x * x + y * y.
Definition less2 (v u : Z * Z) : Z * Z :=
  let '(x, y) := v in let '(x', y') := u in (x - x', y - y').

Lemma estimated_turn S T u v M N e f p q : estimated_step S M e u p -> estimated_step T N f v q ->
  (M * N + M * N <? 4611686018427387904) = true -> 0 <= M * N ->
  estimate (S * T) (det2 u v) (M * N + M * N)
    ((M * f + N * e + e * f) + (M * f + N * e + e * f)) (turn p q).
Proof.
  destruct u as [x y], v as [x' y']. intros (A & B) (A' & B') L P.
  assert (L' : (M * N <? 4611686018427387904) = true)
    by (apply Z.ltb_lt in L; apply Z.ltb_lt; lia).
  unfold turn, det2. apply estimate_sub; [now apply estimate_mul|now apply estimate_mul|exact L].
Qed.
Lemma estimated_square S v M e p : estimated_step S M e v p ->
  (M * M + M * M <? 4611686018427387904) = true -> 0 <= M * M ->
  estimate (S * S) (square2 v) (M * M + M * M)
    ((M * e + M * e + e * e) + (M * e + M * e + e * e)) (square p).
Proof.
  destruct v as [x y]. intros (A & B) L P.
  assert (L' : (M * M <? 4611686018427387904) = true)
    by (apply Z.ltb_lt in L; apply Z.ltb_lt; lia).
  unfold square, square2.
  apply estimate_add; [now apply estimate_mul|now apply estimate_mul|exact L].
Qed.
Lemma estimated_difference S u v p q : estimated_step S 134217728 1 u p ->
  estimated_step S 134217728 1 v q -> estimated_step S 268435456 2 (less2 v u) (step_from q p).
Proof.
  destruct u as [x y], v as [x' y']. intros (A & B) (A' & B'). unfold less2, step_from. split.
  - exact (estimate_sub _ _ _ _ _ _ _ _ _ A' A eq_refl).
  - exact (estimate_sub _ _ _ _ _ _ _ _ _ B' B eq_refl).
Qed.

Lemma turn_margin_is : turn_margin = 805306368.
Proof. now apply of_pos_small. Qed.
Lemma minus_away_margin : sub zero away_margin = -1879048192.
Proof.
  unfold away_margin. rewrite of_pos_small by easy. unfold sub, zero. now rewrite wrap_small by lia.
Qed.
Lemma circle_margin_is : circle_margin = 68719476736.
Proof. now apply of_pos_small. Qed.

Section Signs.
Variables (S a : Z) (u v : Z * Z) (u' v' : step).
Hypothesis a_positive : 0 < a.
Hypothesis u_estimated : estimated_step S 134217728 1 (times2 a u) u'.
Hypothesis v_estimated : estimated_step S 134217728 1 (times2 a v) v'.

Ltac flat := repeat match goal with |- context [times2 _ ?x] => is_var x; destruct x as [? ?] end;
  cbn [times2 det2 less2]; ring.

Lemma turn_estimated : estimate (S * S) (a ^ 2 * det2 u v) 36028797018963968 536870914 (turn u' v').
Proof.
  eapply estimate_unit; [eapply estimate_weaken;
    [eapply estimated_turn; [exact u_estimated|exact v_estimated|reflexivity|lia]|reflexivity]
    |reflexivity|flat].
Qed.
Lemma turn_positive : ltb turn_margin (turn u' v') = true -> 0 < det2 u v.
Proof.
  intros H. apply ltb_less in H. rewrite turn_margin_is in H.
  assert (P : 0 < a ^ 2 * det2 u v) by (eapply estimate_positive; [exact turn_estimated|lia]).
  apply (factor_out (a ^ 2)); [apply Z.pow_pos_nonneg; lia|]. now rewrite Z.mul_0_r.
Qed.

(** [side], opposite each vertex. *)
Section Sides.
Variables (S' b : Z) (q : Z * Z) (q' : step).
Hypothesis b_positive : 0 < b.
Hypothesis q_estimated : estimated_step S' 134217728 2 (times2 b q) q'.

Lemma side_below T x d : estimate T (b * a * x) (2 * (268435456 * 134217728)) 1610612744 d ->
  ltb d (sub zero away_margin) = true -> x < 0.
Proof.
  intros E H. apply ltb_less in H. rewrite minus_away_margin in H.
  assert (P : b * a * x < 0) by (eapply estimate_negative; [exact E|lia]).
  apply (factor_out (b * a)); [now apply Z.mul_pos_pos|]. now rewrite Z.mul_0_r.
Qed.
Lemma side_of_first : ltb (turn q' v') (sub zero away_margin) = true -> det2 q v < 0.
Proof.
  apply side_below with (S' * S).
  eapply estimate_unit; [eapply estimate_weaken;
    [eapply estimated_turn; [exact q_estimated|exact v_estimated|reflexivity|lia]|reflexivity]
    |reflexivity|flat].
Qed.
Lemma side_of_second : ltb (turn u' q') (sub zero away_margin) = true -> det2 u q < 0.
Proof.
  apply side_below with (S * S').
  eapply estimate_unit; [eapply estimate_weaken;
    [eapply estimated_turn; [exact u_estimated|exact q_estimated|reflexivity|lia]|reflexivity]
    |reflexivity|flat].
Qed.
Lemma side_of_third : ltb (turn (step_from v' u') q') (sub zero away_margin) = true ->
  det2 (less2 v u) q < 0.
Proof.
  apply side_below with (S * S').
  pose proof (estimated_difference _ _ _ _ _ u_estimated v_estimated).
  eapply estimate_unit; [eapply estimate_weaken;
    [eapply estimated_turn; [eassumption|exact q_estimated|reflexivity|lia]|reflexivity]
    |reflexivity|flat].
Qed.
End Sides.

(** The slope and the depth of [Predicates.v], without weights. *)
Definition slope_step : Z * Z :=
  let '(ux, uy) := u in let '(vx, vy) := v in
  (square2 u * vy - square2 v * uy, square2 v * ux - square2 u * vx).

Lemma height_estimated x x' : estimated_step S 134217728 1 (times2 a x) x' ->
  estimate (S * S * 67108864) (a ^ 2 * square2 x) 536870912 10 (down26 (square x')).
Proof.
  intros H. eapply estimate_unit; [eapply estimate_div; [|lia|]| |].
  - eapply estimated_square; [exact H|reflexivity|lia].
  - reflexivity.
  - reflexivity.
  - destruct x as [? ?]. cbn [times2 square2]. ring.
Qed.
Lemma slope_one h k x y h' k' x' y' T :
  estimate T h 536870912 10 h' -> estimate T k 536870912 10 k' ->
  estimate S x 134217728 1 x' -> estimate S y 134217728 1 y' ->
  estimate (T * S * 67108864) (h * x - k * y) 2147483648 58
    (down26 (sub (mul h' x') (mul k' y'))).
Proof.
  intros H K X Y. eapply estimate_div; [|lia|].
  - eapply estimate_sub; [now eapply estimate_mul; [exact H|exact X|]
      |now eapply estimate_mul; [exact K|exact Y|]|reflexivity].
  - reflexivity.
Qed.
Lemma slope_estimated : estimated_step (S ^ 3 * 2 ^ 52) 2147483648 58 (times2 (a ^ 3) slope_step)
  (slope_at (down26 (square u')) (down26 (square v')) u' v').
Proof.
  pose proof (height_estimated _ _ u_estimated) as H.
  pose proof (height_estimated _ _ v_estimated) as K.
  unfold slope_step, slope_at. destruct u as [ux uy], v as [vx vy].
  destruct u_estimated as [Ux Uy], v_estimated as [Vx Vy]. split; cbn [east north].
  - eapply estimate_unit; [exact (slope_one _ _ _ _ _ _ _ _ _ H K Vy Uy)|ring|].
    cbn [times2]. ring.
  - eapply estimate_unit; [exact (slope_one _ _ _ _ _ _ _ _ _ K H Ux Vx)|ring|].
    cbn [times2]. ring.
Qed.

Definition inner2 (x y : Z * Z) : Z := let '(a, b) := x in let '(c, d) := y in a * c + b * d.
Lemma circle_negative q q' : estimated_step S 268435456 1 (times2 a q) q' ->
  (let n := slope_at (down26 (square u')) (down26 (square v')) u' v' in
   ltb (add (add (mul (east n) (east q')) (mul (north n) (north q'))) circle_margin)
     (mul (down26 (turn u' v')) (down26 (square q')))) = true ->
  inner2 slope_step q - det2 u v * square2 q < 0.
Proof.
  intros Hq H. cbv zeta in H. pose proof slope_estimated as Sl.
  set (n := slope_at _ _ _ _) in *. clearbody n.
  assert (Up : estimate (S ^ 4 * 2 ^ 52) (a ^ 4 * inner2 slope_step q) 1152921504606846976
    (2 * (2147483648 * 1 + 268435456 * 58 + 58 * 1))
    (add (mul (east n) (east q')) (mul (north n) (north q')))).
  { destruct slope_step as [nx ny], q as [x y]. destruct Sl as [Nx Ny], Hq as [X Y].
    eapply estimate_unit; [eapply estimate_weaken; [eapply estimate_add;
      [now eapply estimate_mul; [exact Nx|exact X|]|now eapply estimate_mul; [exact Ny|exact Y|]
      |reflexivity]|reflexivity]|ring|]. cbn [inner2]. ring. }
  assert (Down : estimate (S ^ 4 * 2 ^ 52) (a ^ 4 * (det2 u v * square2 q)) 1152921504606846976
    (536870912 * 18 + 2147483648 * 10 + 10 * 18)
    (mul (down26 (turn u' v')) (down26 (square q')))).
  { eapply estimate_unit; [eapply estimate_weaken; [eapply estimate_mul|]| |].
    - eapply (estimate_div 67108864 _ _ _ _ _ 536870912 10);
        [exact turn_estimated|lia|reflexivity].
    - eapply (estimate_div 67108864 _ _ _ _ _ 2147483648 18);
        [eapply estimated_square; [exact Hq|reflexivity|lia]|lia|reflexivity].
    - reflexivity.
    - reflexivity.
    - ring.
    - destruct q as [x y]. cbn [times2 square2]. ring. }
  rewrite circle_margin_is in H.
  assert (Q : a ^ 4 * inner2 slope_step q < a ^ 4 * (det2 u v * square2 q))
    by (eapply estimates_differ; [exact Up|exact Down| |exact H]; reflexivity).
  apply (factor_out (a ^ 4)) in Q; [lia|]. apply Z.pow_pos_nonneg; lia.
Qed.
End Signs.

(** ** Coordinates as words *)

Definition rounded_step (s : Z) (q : site) (P : step) : Prop :=
  exists x y, q = Site [x; y] 0 /\ fits s x = true /\ fits s y = true /\
    P = Step (Z.shiftr x s) (Z.shiftr y s).

Lemma plain_site s q P : rounded_step s q P -> exists x y, q = Site [x; y] 0.
Proof. intros (x & y & -> & _). eauto. Qed.

Section Differences.
Variables (s n : Z).
Hypothesis fine_n : fine s n = true.
Notation F := (factor n).
Notation U := (unit s n).

Lemma in_square_spec most p : 0 <= most < 2 ^ 62 -> in_square most p = true ->
  Z.abs (east p) <= most /\ Z.abs (north p) <= most.
Proof. intros B. unfold in_square. intros H. ands. auto using at_most_spec. Qed.
Lemma step_estimated p q P Q b : rounded_step s p P -> rounded_step s q Q -> (b = 1 \/ b = 2) ->
  in_square (b * 2 ^ n) (step_from P Q) = true ->
  estimated_step U (b * 134217728) 1 (times2 F (minus2 p q)) (leveled_step n (step_from P Q)).
Proof.
  intros (x & y & -> & Fx & Fy & ->) (x' & y' & -> & Fx' & Fy' & ->) Hb I.
  apply in_square_spec in I; [|now apply (doubled_small s)]. destruct I as (Ix & Iy).
  split; now apply edge_coordinate.
Qed.
Lemma sample_step_estimated sample_site p P x y w : 0 < w <= 8 -> rounded_step s p P ->
  coordinates sample_site = [x; y] -> fits s x = true -> fits s y = true ->
  let q := Step (sub (Z.shiftr x s) (mul w (east P))) (sub (Z.shiftr y s) (mul w (north P))) in
  in_square (2 ^ n) q = true ->
  estimated_step U 134217728 2 (times2 F (from2 w p sample_site)) (leveled_step n q).
Proof.
  intros Hw (x' & y' & -> & Fx' & Fy' & ->) Co Fx Fy q I.
  apply in_square_spec in I;
    [|rewrite <- (Z.mul_1_l (2 ^ n)); apply (doubled_small s); [exact fine_n|now left]].
  destruct I as (Ix & Iy). unfold from2. rewrite Co. cbn [coordinates].
  split; now apply sample_coordinate.
Qed.
End Differences.

Lemma known_step s l cl v : Forall (fun e => well_shaped 2 (position e)) l ->
  forallb (fun e => forallb (fits s) (coordinates (position e))) l = true ->
  count_of l <= 2 ^ 58 -> weights_of cl = false -> known (count_of l) v = true ->
  exists q, Table.find (to_pos v) (Table.of_list (site_of cl) l) = Some q /\
    rounded_step s q (step_to (places_of s l) v).
Proof.
  intros Sh Fit Few Cl K. destruct (known_entry 2 s l Sh Fit cl v Cl K) as (e & E & F & L & Fe).
  apply known_spec in K.
  pose proof (fun k => get_place 2 s l Sh Fit Few v k e K) as G. change (Z.of_nat 2) with 2 in G.
  pose proof (G 0 ltac:(lia) E) as G0. pose proof (G 1 ltac:(lia) E) as G1. clear G.
  eexists. split; [exact F|].
  destruct (coordinates (position e)) as [|x [|y [|? ?]]]; try discriminate L.
  exists x, y. cbn [forallb] in Fe. ands. repeat (split; [assumption || reflexivity|]).
  unfold step_to. rewrite (sub_small v one (v - 1) eq_refl) by lia.
  rewrite (mul_small two (v - 1) (2 * (v - 1) + 0)) by (unfold two; lia).
  rewrite (add_small _ one (2 * (v - 1) + 1)) by (unfold one; lia).
  now rewrite G0, G1.
Qed.
