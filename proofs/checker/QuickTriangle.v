(** * What the quick check finds of a triangle *)
From Coq Require Import ZArith List Bool Lia.
From Circumspect Require Import Numbering Accepted Integers.
From Circumspect Require Import QuickPlane Estimates Rounded EstimatesPlane QuickSound.
From Circumspect Require Import Word.
Import ListNotations.
Open Scope Z_scope.

(** ** Across a side *)

(** The three vertices of the triangle, if [k0] and [k1] are those but number [i]. *)
Definition at_corner (i : nat) (a : positive) (k0 k1 : positive) : list positive :=
  match i with 0%nat => [a; k0; k1] | 1%nat => [k0; a; k1] | _ => [k0; k1; a] end.

Lemma matched_sides i j i_is_odd k0 k1 l0 l1 v a : i = 0 \/ i = 1 \/ i = 2 ->
  j = 0 \/ j = 1 \/ j = 2 -> i_is_odd = Nat.odd (Z.to_nat i) ->
  0 < k0 -> 0 < k1 -> k0 <> k1 -> 0 < v -> v <> k0 -> v <> k1 ->
  (if Bool.eqb i_is_odd (is_odd j) then eqb k0 l1 && eqb k1 l0 else eqb k0 l0 && eqb k1 l1) =
    true ->
  matched_facet (at_corner (Z.to_nat i) a (to_pos k0) (to_pos k1))
    (at_corner (Z.to_nat j) (to_pos v) (to_pos l0) (to_pos l1)) (Z.to_nat i) (Z.to_nat j) = true.
Proof.
  intros I J -> P0 P1 N Pv V0 V1 H. apply unlike_pos in N, V0, V1; try assumption.
  apply Pos.eqb_neq in N, V0, V1. pose proof N as N'. rewrite Pos.eqb_sym in N'.
  pose proof V0 as V0'. pose proof V1 as V1'. rewrite Pos.eqb_sym in V0', V1'.
  destruct I as [->|[->| ->]], J as [->|[->| ->]]; cbn in H; apply andb_prop in H;
    destruct H as [H H']; apply eqb_eq' in H, H'; subst; unfold matched_facet;
    change (Z.to_nat 0) with 0%nat; change (Z.to_nat 1) with 1%nat; change (Z.to_nat 2) with 2%nat;
    cbn;
    repeat (rewrite ?Pos.eqb_refl, ?N, ?N', ?V0, ?V1, ?V0', ?V1'; cbn); reflexivity.
Qed.

Section Triangle.
Variables (p : packed) (s : Word.t) (asked : option standing) (X0 Y0 : Z).
Notation c := (frame p).
Notation pr := plane_predicates.
Notation m := (packed_mesh Plane p).
Notation N := (count_of (points c)).
Notation rows := (rows_of p).
Notation places := (places_of s (points c)).
Notation w := (sample_denominator c).
Notation here := (Step (Z.shiftr X0 s) (Z.shiftr Y0 s)).
Hypothesis in_words : within_words Plane p s.
Hypothesis sample_shape : coordinates (sample c) = [X0; Y0].
Hypothesis sample_fits : fits s X0 = true /\ fits s Y0 = true.
Hypothesis sample_small : 0 < w <= 8.

Lemma point_at v : known N v = true ->
  exists q, Table.find (to_pos v) (points_of m) = Some q /\ rounded_step s q (step_to places v).
Proof.
  apply (known_step s (points c) _ _ (shapes _ _ _ in_words) (all_fit _ _ _ in_words)
    (few_points _ _ _ in_words) (unweighted _ _ _ in_words)).
Qed.

Lemma small_sums : add zero one = 1 /\ add one one = 2 /\ add three 0 = three /\
  add three 1 = four /\ add three 2 = five.
Proof.
  unfold add, zero, one, three, four, five. rewrite !wrap_small by lia. repeat split.
Qed.

Lemma quick_side_wall_sound t i i_is_odd k0 k1 x apex_ok K X n a :
  Zpos t <= simplex_count p -> i = 0 \/ i = 1 \/ i = 2 -> i_is_odd = Nat.odd (Z.to_nat i) ->
  0 < k0 -> 0 < k1 -> k0 <> k1 -> K = at_corner (Z.to_nat i) a (to_pos k0) (to_pos k1) ->
  - 2 ^ 62 <= x < 2 ^ 62 ->
  (forall u v q, apex_ok u v = true -> Table.find (to_pos v) (points_of m) = Some q ->
     rounded_step s q (step_to places v) -> delaunay_claimed m = true ->
     Pos.ltb t (to_pos u) = true ->
     depth pr X n q <= 0 /\ forall st, asked = Some st ->
       settled pr st K X n (to_pos v) q = true) ->
  quick_side_wall m (simplex_count p) N rows t i i_is_odd k0 k1 x apex_ok = true ->
  check_wall pr m t K X n (Z.to_nat i) (wall_of x) = Accepted /\
  (delaunay_claimed m = true -> forall st, asked = Some st ->
    settled_wall pr m st t K X n (wall_of x) = true).
Proof.
  intros Ht I Odd P0 P1 N01 -> Rx Deep H. cbv delta [quick_side_wall] in H. cbv beta in H.
  unfold wall_of. destruct (ltb x zero) eqn:Lx.
  { unfold check_wall. change (index i) with (Z.to_nat i) in H. rewrite H. split; reflexivity. }
  open_lets H.
  assert (K1 : known (simplex_count p) u = true) by assumption.
  assert (K2 : leb j two = true) by assumption.
  assert (K3 : eqb (get rows (add r (add three j))) (add (mul eight (of_pos t)) i) = true)
    by assumption.
  assert (K4 : known N v = true) by assumption.
  assert (K5 : negb (eqb v k0) = true) by assumption.
  assert (K6 : negb (eqb v k1) = true) by assumption.
  assert (K7 : (if Bool.eqb i_is_odd (is_odd j) then eqb k0 l1 && eqb k1 l0
    else eqb k0 l0 && eqb k1 l1) = true) by assumption.
  apply Z.ltb_ge in Lx. destruct (wall_parts x (conj Lx (proj2 Rx))) as (Bu & Ej & Bj).
  fold u in Bu, Ej. fold j in Ej. apply leb_le' in K2. apply eqb_eq' in K3.
  assert (J : j = 0 \/ j = 1 \/ j = 2) by (unfold two in K2; lia).
  fold u j. clearbody u j. pose proof (find_simplex Plane p u K1) as F.
  destruct (point_at v K4) as (q & Fq & Rq).
  apply unlike in K5, K6. apply known_positive in K4. apply known_positive in K1.
  assert (Mf := matched_sides i j i_is_odd k0 k1 l0 l1 v a I J Odd P0 P1 N01 K4 K5 K6 K7).
  assert (B : nth_error (walls (entry_of Plane rows (to_pos u))) (Z.to_nat j) = Some
    (Neighbour t (Z.to_nat i)) /\
    corners (entry_of Plane rows (to_pos u)) =
      at_corner (Z.to_nat j) (to_pos v) (to_pos l0) (to_pos l1)).
  { rewrite <- (wall_back t i (Z.le_trans _ _ _ Ht (few_simplices _ _ _ in_words))), <- K3 by lia.
    unfold entry_of, corners_of. rewrite (of_to_pos u) by lia.
    unfold v, l0, l1, other_corner. fold r.
    pose proof small_sums as (S0 & S1 & S2 & S3 & S4).
    clear - J S0 S1 S2 S3 S4. destruct J as [->|[->| ->]];
      cbn [leb Z.leb zero one two Z.compare Pos.compare Pos.compare_cont];
      rewrite ?S0, ?S1, ?S2, ?S3, ?S4; split; reflexivity. }
  destruct B as [Bw Bc].
  eapply neighbour_accepted with (v := to_pos v); [exact F|now rewrite Bc|exact Bw| |exact Fq|].
  - rewrite Bc. clear - J. destruct J as [->|[->| ->]]; reflexivity.
  - intros Q1 Q2. exact (Deep u v q H Fq Rq Q1 Q2).
Qed.

(** ** A triangle *)

(** The determinants of [Predicates.v], of edges. *)
Lemma side_at i qa qb qc : (exists x y, qa = Site [x; y] 0) -> (exists x y, qb = Site [x; y] 0) ->
  (exists x y, qc = Site [x; y] 0) ->
  let u := minus2 qa qc in let v := minus2 qb qc in
  side pr i [qa; qb; qc] (sample c) w =
  match i with
  | 0%nat => det2 (from2 w qc (sample c)) v
  | 1%nat => det2 u (from2 w qc (sample c))
  | 2%nat => det2 (less2 v u) (from2 w qa (sample c))
  | _ => 0
  end.
Proof.
  intros (xa & ya & ->) (xb & yb & ->) (xc & yc & ->).
  destruct i as [|[|[|i]]]; try reflexivity. cbn [side plane_predicates side2].
  unfold from2. rewrite sample_shape. cbn. ring.
Qed.
Lemma depth_at qa qb qc q : (exists x y, qa = Site [x; y] 0) ->
  (exists x y, qb = Site [x; y] 0) -> (exists x y, qc = Site [x; y] 0) ->
  (exists x y, q = Site [x; y] 0) ->
  depth pr [qa; qb; qc] (slope pr [qa; qb; qc]) q =
  inner2 (slope_step (minus2 qa qc) (minus2 qb qc)) (minus2 q qc) -
  det2 (minus2 qa qc) (minus2 qb qc) * square2 (minus2 q qc).
Proof.
  intros (xa & ya & ->) (xb & yb & ->) (xc & yc & ->) (x & y & ->).
  cbv [depth slope plane_predicates depth2 slope2 slope_step minus2 det2 inner2 square2 height2
    coordinates weight]. ring.
Qed.

Section Edges.
Variables (t : positive) (n : Z) (qa qb qc : site) (pa pb pc : step).
Hypotheses (Ra : rounded_step s qa pa) (Rb : rounded_step s qb pb) (Rc : rounded_step s qc pc).
Hypothesis fine_n : fine s n = true.
Notation u := (leveled_step n (step_from pa pc)).
Notation v := (leveled_step n (step_from pb pc)).
Hypotheses (Iu : in_square (up one n) (step_from pa pc) = true)
  (Iv : in_square (up one n) (step_from pb pc) = true).

Lemma edge q P : rounded_step s q P -> in_square (up one n) (step_from P pc) = true ->
  estimated_step (unit s n) 134217728 1 (times2 (factor n) (minus2 q qc))
    (leveled_step n (step_from P pc)).
Proof.
  intros R I. pose proof (fine_parts s n fine_n) as [Rn _]. destruct (up_one n ltac:(lia)) as [E _].
  rewrite E in I. apply (step_estimated s n fine_n q qc P pc 1 R Rc (or_introl eq_refl)).
  now rewrite Z.mul_1_l.
Qed.
Let Eu := edge _ _ Ra Iu.
Let Ev := edge _ _ Rb Iv.
Let Fp := factor_positive s n fine_n.
Let Sa := plain_site _ _ _ Ra.
Let Sb := plain_site _ _ _ Rb.
Let Sc := plain_site _ _ _ Rc.

Lemma positive_here : ltb turn_margin (turn u v) = true ->
  positive_simplex pr [qa; qb; qc] = true.
Proof. intros H. apply Z.ltb_lt. exact (turn_positive _ _ _ _ _ _ Fp Eu Ev H). Qed.

Lemma away_here a : quick_away m s here w t pa pc u v a = true ->
  outside_sample pr m t [qa; qb; qc] (away_of a) = true.
Proof.
  intros H. cbv delta [quick_away] in H. cbv beta in H. unfold outside_sample.
  apply orb_prop in H. destruct H as [H|H]; [now rewrite H|]. apply orb_true_intro. right.
  open_lets H.
  assert (Fi : fine s n0 = true) by assumption.
  assert (In_ : in_square (up one n0) q = true) by assumption.
  pose proof (fine_parts s n0 Fi) as [Rn _]. destruct (up_one n0 ltac:(lia)) as [E _].
  rewrite E in In_. destruct sample_fits as (F1 & F2).
  assert (Es : forall z P, rounded_step s z P -> base = P ->
    estimated_step (unit s n0) 134217728 2 (times2 (factor n0) (from2 w z (sample c))) q').
  { intros z P Rz B. rewrite <- B in Rz.
    exact (sample_step_estimated s n0 Fi (sample c) z base X0 Y0 w sample_small Rz sample_shape F1
      F2 In_). }
  pose proof (factor_positive s n0 Fi) as Fq.
  assert (D : a = 0 \/ a = 1 \/ a = 2).
  { match goal with A : eqb a zero || eqb a one || eqb a two = true |- _ => clear - A end.
    repeat (apply orb_prop in A; destruct A as [A|A]); apply eqb_eq' in A; auto. }
  assert (W : forall i, away_of a = Some i -> side pr i [qa; qb; qc] (sample c) w < 0 ->
    match away_of a with Some i => side pr i [qa; qb; qc] (sample_of m) (sample_w m) <? 0
      | None => false end = true).
  { intros i -> L. now apply Z.ltb_lt. }
  destruct (eqb a zero) eqn:G0; [|destruct (eqb a one) eqn:G1].
  - apply eqb_eq' in G0. assert (B : base = pc) by (unfold base; now rewrite G0).
    clearbody q' base. apply (W 0%nat); [now rewrite G0|].
    rewrite (side_at 0%nat _ _ _ Sa Sb Sc). pose proof (Es _ _ Rc B) as Hq.
    exact (side_of_first _ _ _ _ Fp Ev _ _ _ _ Fq Hq H).
  - apply eqb_eq' in G1. assert (B : base = pc) by (unfold base; now rewrite G1).
    clearbody q' base. apply (W 1%nat); [now rewrite G1|].
    rewrite (side_at 1%nat _ _ _ Sa Sb Sc). pose proof (Es _ _ Rc B) as Hq.
    exact (side_of_second _ _ _ _ Fp Eu _ _ _ _ Fq Hq H).
  - assert (G2 : a = 2) by (destruct D as [->|[->|D]]; [discriminate|discriminate|exact D]).
    assert (B : base = pa) by (unfold base; now rewrite G2).
    clearbody q' base. apply (W 2%nat); [now rewrite G2|].
    rewrite (side_at 2%nat _ _ _ Sa Sb Sc). pose proof (Es _ _ Ra B) as Hq.
    exact (side_of_third _ _ _ _ _ _ Fp Eu Ev _ _ _ _ Fq Hq H).
Qed.

Lemma beyond_here q P : rounded_step s q P ->
  quick_beyond n pc (slope_at (down26 (square u)) (down26 (square v)) u v) (down26 (turn u v)) P =
    true ->
  depth pr [qa; qb; qc] (slope pr [qa; qb; qc]) q < 0.
Proof.
  intros R H. cbv delta [quick_beyond] in H. cbv beta in H. open_lets H.
  pose proof (plain_site _ _ _ R) as Sq. rewrite depth_at by assumption.
  refine (circle_negative _ _ _ _ _ _ Fp Eu Ev _ e' _ H).
  pose proof (fine_parts s n fine_n) as [Rn _].
  change 268435456 with (2 * 134217728).
  apply (step_estimated s n fine_n q qc P pc 2 R Rc (or_intror eq_refl)).
  assert (I : in_square (up one (add n one)) e = true) by assumption.
  rewrite (add_small n one (n + 1)) in I by (unfold one; lia).
  destruct (up_one (n + 1) ltac:(lia)) as [E _].
  rewrite E, Z.pow_add_r in I by lia. now rewrite Z.mul_comm.
Qed.
End Edges.

(** The three walls are those of [entry_of].  (Nothing here is to be computed.) *)
Local Opaque wrap add sub mul of_pos up down size leb ltb eqb get.
Lemma triangle_here t : Zpos t <= simplex_count p ->
  quick_triangle m (simplex_count p) N rows places s here w asked t = true ->
  check_simplex pr m t (entry_of Plane rows t) = Accepted /\
  (delaunay_claimed m = true -> forall st, asked = Some st ->
    settled_simplex pr m st t (entry_of Plane rows t) = true).
Proof.
  intros Ht H. cbv delta [quick_triangle] in H. cbv beta in H. open_lets H. rename c into c0.
  assert (Ka : known N a = true) by assumption. assert (Kb : known N b = true) by assumption.
  assert (Kc : known N c0 = true) by assumption.
  assert (Nab : a <> b) by (apply unlike; assumption).
  assert (Nac : a <> c0) by (apply unlike; assumption).
  assert (Nbc : b <> c0) by (apply unlike; assumption).
  assert (Fi : fine s n = true) by assumption.
  assert (Iu : in_square most eu = true) by assumption.
  assert (Iv : in_square most ev = true) by assumption.
  assert (Or : ltb turn_margin det = true) by assumption.
  assert (Ou : quick_away m s here w t pa pc u v (get rows (add r six)) = true) by assumption.
  assert (W0 : quick_side_wall m (simplex_count p) N rows t zero false b c0 (get rows (add r three))
    below = true) by assumption.
  assert (W1 : quick_side_wall m (simplex_count p) N rows t one true a c0 (get rows (add r four))
    below = true) by assumption.
  rename H into W2.
  destruct (point_at a Ka) as (qa & Fa & Ra). destruct (point_at b Kb) as (qb & Fb & Rb).
  destruct (point_at c0 Kc) as (qc & Fc & Rc).
  pose proof (positive_here n qa qb qc pa (step_to places b) pc Ra Rb Rc Fi Iu Iv Or) as Pos.
  pose proof (away_here t n qa qb qc pa (step_to places b) pc Ra Rb Rc Fi Iu Iv _ Ou) as Out.
  assert (Co : corners (entry_of Plane rows t) = [to_pos a; to_pos b; to_pos c0]) by reflexivity.
  assert (Wa : walls (entry_of Plane rows t) = [wall_of (get rows (add r three));
    wall_of (get rows (add r four)); wall_of (get rows (add r five))]) by reflexivity.
  assert (Aw : away (entry_of Plane rows t) = away_of (get rows (add r six))) by reflexivity.
  assert (Fs : find_all (points_of m) (corners (entry_of Plane rows t)) = Some [qa; qb; qc])
    by (rewrite Co; cbn [find_all]; now rewrite Fa, Fb, Fc).
  assert (Deep : forall sl, (delaunay_claimed m = true -> sl = slope pr [qa; qb; qc]) ->
    forall u v q, below u v = true -> Table.find (to_pos v) (points_of m) = Some q ->
    rounded_step s q (step_to places v) -> delaunay_claimed m = true ->
    Pos.ltb t (to_pos u) = true ->
    depth pr [qa; qb; qc] sl q <= 0 /\ forall st, asked = Some st ->
      settled pr st [to_pos a; to_pos b; to_pos c0] [qa; qb; qc] sl (to_pos v) q = true).
  { intros sl Sl u1 v1 q B Fq Rq Q1 Q2. rewrite (Sl Q1). unfold below in B. rewrite Q1, Q2 in B.
    rewrite Co in Fs. refine (below_enough Plane p asked _ _ _ _ _ Fs Fq _ B).
    exact (beyond_here n qa qb qc pa (step_to places b) pc Ra Rb Rc Fi Iu Iv q _ Rq). }
  assert (Pa := known_positive _ a Ka). assert (Pb := known_positive _ b Kb).
  assert (Pc := known_positive _ c0 Kc).
  assert (R : forall k, - 2 ^ 62 <= get rows k < 2 ^ 62) by apply get_range.
  pose proof (quick_side_wall_sound t) as Wall.
  clear Or Ou Iu Iv. clearbody below. clearbody a b c0 r.
  apply (simplex_accepted Plane p asked t _ _ Fs Pos); [reflexivity|now rewrite Aw|].
  intros sl Sl i f E. rewrite Wa in E. rewrite Co.
  destruct i as [|[|[|i]]]; cbn [nth_error] in E.
  4: now destruct i.
  all: injection E as <-.
  - exact (Wall zero false b c0 _ below _ _ sl (to_pos a) Ht ltac:(now left) eq_refl Pb Pc Nbc
      eq_refl (R _) (Deep sl Sl) W0).
  - exact (Wall one true a c0 _ below _ _ sl (to_pos b) Ht ltac:(now right; left) eq_refl Pa Pc Nac
      eq_refl (R _) (Deep sl Sl) W1).
  - exact (Wall two false a b _ below _ _ sl (to_pos c0) Ht ltac:(now right; right) eq_refl Pa Pb
      Nab eq_refl (R _) (Deep sl Sl) W2).
Qed.
End Triangle.
