(** * What the quick check's estimates amount to

    An integer [x] is estimated by a word [m] in units of [S], with an error of no more than [e]
    units; and the word is no greater than [M] in absolute value, so that sums and products of such
    words can be seen not to wrap round ([estimate]).  From the rules for sums, products and shifts
    the margins of [Quick.v] follow: the constants are computed by Coq. *)
From Coq Require Import ZArith List Bool Lia Psatz.
From Circumspect Require Import Quick.
From Circumspect Require Import Word.
Import ListNotations.
Open Scope Z_scope.

Lemma wrap_small z : - 2 ^ 62 <= z < 2 ^ 62 -> wrap z = z.
Proof. intros H. unfold wrap. rewrite Z.mod_small; lia. Qed.

(** Of all words: what is to be compared need not be computed. *)
Lemma ltb_less x y : ltb x y = true -> x < y.
Proof. apply Z.ltb_lt. Qed.

Definition estimate (S x M e : Z) (m : Word.t) : Prop :=
  0 < S /\ Z.abs (x - S * m) <= S * e /\ Z.abs m <= M.

Lemma estimate_add S x y M N e f m n : estimate S x M e m -> estimate S y N f n ->
  (M + N <? 4611686018427387904) = true -> estimate S (x + y) (M + N) (e + f) (add m n).
Proof.
  intros (P & A & B) (_ & C & D) L. apply Z.ltb_lt in L. unfold add. rewrite wrap_small by lia.
  split; [assumption|]. split; [|lia].
  replace (x + y - S * (m + n)) with ((x - S * m) + (y - S * n)) by ring. lia.
Qed.
Lemma estimate_sub S x y M N e f m n : estimate S x M e m -> estimate S y N f n ->
  (M + N <? 4611686018427387904) = true -> estimate S (x - y) (M + N) (e + f) (sub m n).
Proof.
  intros (P & A & B) (_ & C & D) L. apply Z.ltb_lt in L. unfold sub. rewrite wrap_small by lia.
  split; [assumption|]. split; [|lia].
  replace (x - y - S * (m - n)) with ((x - S * m) - (y - S * n)) by ring. lia.
Qed.
Lemma product_small S m M b B : 0 < S -> Z.abs m <= M -> Z.abs b <= B ->
  S * Z.abs m * Z.abs b <= S * M * B.
Proof.
  intros P Hm Hb.
  apply Z.mul_le_mono_nonneg; [|now apply Z.mul_le_mono_nonneg_l;
    [apply Z.lt_le_incl|]|apply Z.abs_nonneg|exact Hb].
  apply Z.mul_nonneg_nonneg; [now apply Z.lt_le_incl|apply Z.abs_nonneg].
Qed.
Lemma estimate_mul S T x y M N e f m n : estimate S x M e m -> estimate T y N f n ->
  (M * N <? 4611686018427387904) = true -> estimate (S * T) (x * y) (M * N) (M * f + N * e + e * f)
    (mul m n).
Proof.
  intros (P & A & B) (Q & C & D) L. apply Z.ltb_lt in L.
  assert (K : Z.abs (m * n) <= M * N) by (rewrite Z.abs_mul; apply Z.mul_le_mono_nonneg; lia).
  unfold mul. rewrite wrap_small by lia. split; [lia|]. split; [|exact K].
  replace (x * y - S * T * (m * n))
    with ((S * m) * (y - T * n) + (T * n) * (x - S * m) + (x - S * m) * (y - T * n)) by ring.
  set (a := x - S * m) in *. set (b := y - T * n) in *.
  assert (E1 : Z.abs (S * m * b) <= (S * M) * (T * f)).
  { rewrite !Z.abs_mul, (Z.abs_eq S) by lia. now apply product_small. }
  assert (E2 : Z.abs (T * n * a) <= (T * N) * (S * e)).
  { rewrite !Z.abs_mul, (Z.abs_eq T) by lia. now apply product_small. }
  assert (E3 : Z.abs (a * b) <= (S * e) * (T * f)).
  { rewrite Z.abs_mul. apply Z.mul_le_mono_nonneg; auto using Z.abs_nonneg. }
  replace (S * T * (M * f + N * e + e * f)) with (S * M * (T * f) + T * N * (S * e) + S * e *
    (T * f)) by ring.
  eapply Z.le_trans; [apply Z.abs_triangle|]. apply Z.add_le_mono; [|exact E3].
  eapply Z.le_trans; [apply Z.abs_triangle|]. now apply Z.add_le_mono.
Qed.
(** A division by K, which rounds down. *)
Lemma estimate_div K S x M e m M' e' : estimate S x M e m -> 0 < K ->
  (M <=? K * M') && (e + K - 1 <=? K * e') = true -> estimate (S * K) x M' e' (m / K).
Proof.
  intros (P & A & B) HK L. apply andb_prop in L. destruct L as [L1 L2].
  apply Z.leb_le in L1, L2.
  pose proof (Z.div_mod m K ltac:(lia)) as E. pose proof (Z.mod_pos_bound m K HK) as R.
  split; [nia|]. split.
  - replace (x - S * K * (m / K)) with ((x - S * m) + S * (m mod K)) by (rewrite E at 1; ring).
    assert (0 <= S * (m mod K) <= S * (K - 1)) by nia.
    assert (S * (e + K - 1) <= S * (K * e')) by nia. lia.
  - apply Z.abs_le. split.
    + apply Z.div_le_lower_bound; [lia|]. lia.
    + apply Z.div_le_upper_bound; [lia|]. lia.
Qed.
(** Bounds that are simpler, or about another unit. *)
Lemma estimate_weaken S x M e m M' e' : estimate S x M e m -> (M <=? M') && (e <=? e') = true ->
  estimate S x M' e' m.
Proof.
  intros (P & A & B) L. apply andb_prop in L. destruct L as [L1 L2]. apply Z.leb_le in L1, L2.
  split; [assumption|]. split; [nia|lia].
Qed.
Lemma estimate_unit S S' x x' M e m : estimate S x M e m -> S = S' -> x = x' ->
  estimate S' x' M e m.
Proof. now intros H <- <-. Qed.

(** What an estimate says of a sign. *)
Lemma estimate_positive S x M e m : estimate S x M e m -> e < m -> 0 < x.
Proof. intros (P & A & B) L. apply Z.abs_le in A. assert (S * e < S * m) by nia. lia. Qed.
Lemma estimate_negative S x M e m : estimate S x M e m -> m < - e -> x < 0.
Proof. intros (P & A & B) L. apply Z.abs_le in A. assert (S * m < S * - e) by nia. lia. Qed.

Lemma estimates_differ S x y M e m N f n margin : estimate S x M e m -> estimate S y N f n ->
  (0 <=? margin) && (M + margin <? 4611686018427387904) && (e + f <=? margin) = true ->
  ltb (add m margin) n = true -> x < y.
Proof.
  intros (P & A & B) (_ & C & D) L H. apply andb_prop in L. destruct L as [L L3].
  apply andb_prop in L. destruct L as [L1 L2]. apply Z.leb_le in L1, L3. apply Z.ltb_lt in L2.
  apply ltb_less in H. unfold add in H. rewrite wrap_small in H by lia.
  apply Z.abs_le in A, C. assert (S * (m + e) < S * (n - f)) by (apply Z.mul_lt_mono_pos_l; lia).
  lia.
Qed.

(** ** Arrows *)

Definition vector := (Z * Z * Z)%type.
Definition estimated (S M e : Z) (v : vector) (p : arrow) : Prop :=
  let '(x, y, z) := v in
  estimate S x M e (along_x p) /\ estimate S y M e (along_y p) /\ estimate S z M e (along_z p).
Definition times (a : Z) (v : vector) : vector := let '(x, y, z) := v in (a * x, a * y, a * z).

Lemma estimated_dot S T u v M N e f p q : estimated S M e u p -> estimated T N f v q ->
  (M * N + M * N + M * N <? 4611686018427387904) = true -> 0 <= M * N ->
  estimate (S * T) (inner3 u v) (M * N + M * N + M * N)
    ((M * f + N * e + e * f) + (M * f + N * e + e * f) + (M * f + N * e + e * f)) (dot p q).
Proof.
  destruct u as [[ux uy] uz], v as [[vx vy] vz]. intros (A & B & C) (A' & B' & C') L P.
  assert (L1 : (M * N <? 4611686018427387904) = true) by (apply Z.ltb_lt in L; apply Z.ltb_lt; lia).
  assert (L2 : (M * N + M * N <? 4611686018427387904) = true) by (apply Z.ltb_lt in L;
    apply Z.ltb_lt; lia).
  unfold dot, inner3. apply estimate_add; [|now apply estimate_mul|assumption].
  apply estimate_add; [now apply estimate_mul|now apply estimate_mul|assumption].
Qed.

Lemma estimate_crossed_one S x y x' y' M e m n m' n' :
  estimate S x M e m -> estimate S y M e n -> estimate S x' M e m' -> estimate S y' M e n' ->
  (M <=? 134217728) && (e <=? 1) && (0 <=? e) = true ->
  estimate (S * S * 67108864) (x * y' - y * x') (536870912) 10 (down26 (sub (mul m n') (mul n m'))).
Proof.
  intros A B A' B' L. apply andb_prop in L. destruct L as [L L3]. 
  assert (W : forall z k, estimate S z M e k -> estimate S z (134217728) 1 k)
    by (intros z k H; now apply (estimate_weaken _ _ _ _ _ _ _ H)).
  apply W in A, B, A', B'. unfold down26.
  eapply estimate_div; [|lia|].
  - apply estimate_sub; [now apply estimate_mul; [eassumption|eassumption|]
                        |now apply estimate_mul; [eassumption|eassumption|]|]; reflexivity.
  - reflexivity.
Qed.
Lemma estimated_crossed S u v p q : estimated S (134217728) 1 u p ->
  estimated S (134217728) 1 v q ->
  estimated (S * S * 67108864) (536870912) 10 (cross3 u v) (crossed p q).
Proof.
  destruct u as [[ux uy] uz], v as [[vx vy] vz]. intros (A & B & C) (A' & B' & C').
  unfold estimated, cross3. split; [|split]; cbn [crossed along_x along_y along_z].
  all: eapply estimate_crossed_one; eassumption || reflexivity.
Qed.

(** ** Levelling *)

Section Level.
Variables (s n : Z).
Hypothesis fine_n : fine s n = true.

(** The factor by which an integer is multiplied, and the unit in which that is estimated. *)
Definition factor : Z := if n <=? 27 then 2 ^ (27 - n) else 1.
Definition unit : Z := if n <=? 27 then 1 else 2 ^ (n - 27) * 2 ^ s.

Lemma fine_parts : 0 <= n <= 60 /\ (s = 0 \/ 30 <= n).
Proof.
  pose proof fine_n as H. unfold fine in H. apply andb_prop in H. destruct H as [H K].
  apply andb_prop in H. destruct H as [H1 H2]. apply Z.leb_le in H1, H2.
  change (n <= 60) in H2. split; [easy|]. apply orb_prop in K. destruct K as [K|K].
  - left. now apply Z.eqb_eq in K.
  - right. now apply Z.leb_le in K.
Qed.
Lemma factor_positive : 0 < factor.
Proof. destruct fine_parts. unfold factor. destruct (n <=? 27) eqn:E; [|lia].
  apply Z.leb_le in E. apply Z.pow_pos_nonneg; lia. Qed.

(** [x] is [z] without its last s digits, up to c units; of [x] there are b times 2^n. *)
Lemma estimate_level z x b c : 0 <= s -> 1 <= b <= 2 -> 0 <= c <= 8 -> (s = 0 -> z = x) ->
  Z.abs (z - 2 ^ s * x) <= 2 ^ s * c -> Z.abs x <= b * 2 ^ n ->
  estimate unit (factor * z) (b * 134217728) (if c <=? 1 then 1 else 2) (level n x).
Proof.
  intros Hs Hb Hc Exact Near Most. destruct fine_parts as [Rn Rs].
  unfold level. change (leb n c27) with (n <=? 27). unfold unit, factor.
  destruct (n <=? 27) eqn:E.
  - apply Z.leb_le in E. destruct Rs as [->|Rs]; [|lia]. rewrite (Exact eq_refl).
    unfold up, sub. change c27 with 27. rewrite (wrap_small (27 - n)) by lia.
    assert (G : (0 <=? 27 - n) && (27 - n <=? 62) = true)
      by (apply andb_true_intro; split; apply Z.leb_le; lia).
    rewrite G.
    assert (Q : 0 < 2 ^ (27 - n)) by (apply Z.pow_pos_nonneg; lia).
    assert (Q' : 2 ^ n * 2 ^ (27 - n) = 134217728) by (rewrite <- Z.pow_add_r by lia;
      now replace (n + (27 - n)) with 27 by lia).
    assert (R : Z.abs (x * 2 ^ (27 - n)) <= b * 134217728).
    { rewrite Z.abs_mul, (Z.abs_eq (2 ^ (27 - n))), <- Q' by lia. nia. }
    assert (b * 134217728 <= 268435456) by lia.
    rewrite wrap_small by lia. split; [lia|]. split; [|exact R].
    replace (2 ^ (27 - n) * x - 1 * (x * 2 ^ (27 - n))) with 0 by ring. destruct (c <=? 1); lia.
  - apply Z.leb_gt in E. unfold down, sub. change c27 with 27. rewrite (wrap_small (n - 27)) by lia.
    assert (G : (0 <=? n - 27) && (n - 27 <=? 62) = true)
      by (apply andb_true_intro; split; apply Z.leb_le; lia).
    rewrite G. set (K := 2 ^ (n - 27)).
    assert (HK : 0 < K) by (apply Z.pow_pos_nonneg; lia).
    assert (Q' : 2 ^ n = K * 134217728) by (unfold K; change 134217728 with (2 ^ 27);
      rewrite <- Z.pow_add_r by lia; f_equal; lia).
    assert (P : 0 < 2 ^ s) by (apply Z.pow_pos_nonneg; lia).
    pose proof (Z.div_mod x K ltac:(lia)) as D. pose proof (Z.mod_pos_bound x K HK) as R.
    split; [nia|]. split.
    + replace (1 * z - K * 2 ^ s * (x / K)) with ((z - 2 ^ s * x) + 2 ^ s * (x mod K))
        by (rewrite D at 1; ring).
      destruct Rs as [->|Rs].
      * rewrite (Exact eq_refl). destruct (c <=? 1); nia.
      * assert (8 <= K).
        { change 8 with (2 ^ 3). apply Z.pow_le_mono_r; lia. }
        assert (0 <= 2 ^ s * (x mod K) <= 2 ^ s * (K - 1))
          by (split; [apply Z.mul_nonneg_nonneg|apply Z.mul_le_mono_nonneg_l]; lia).
        assert (2 ^ s * c <= 2 ^ s * K) by (apply Z.mul_le_mono_nonneg_l; lia).
        apply Z.abs_le in Near. apply Z.abs_le. destruct (c <=? 1) eqn:C; [|lia].
        apply Z.leb_le in C. assert (2 ^ s * c <= 2 ^ s * 1) by (apply Z.mul_le_mono_nonneg_l; lia).
        lia.
    + rewrite Q' in Most. apply Z.abs_le in Most. apply Z.abs_le. split.
      * apply Z.div_le_lower_bound; [lia|]. nia.
      * apply Z.div_le_upper_bound; [lia|]. nia.
Qed.
End Level.

(** ** The three signs *)

Lemma factor_out k x y : 0 < k -> k * x < k * y -> x < y.
Proof. intros P H. now apply Z.mul_lt_mono_pos_l in H. Qed.
Lemma cube_positive a : 0 < a -> 0 < a ^ 3 /\ 0 < a ^ 5.
Proof. intros H. split; apply Z.pow_pos_nonneg; lia. Qed.
Lemma product_positive a b : 0 < a -> 0 < b -> 0 < b * a * a.
Proof. intros A B. now repeat apply Z.mul_pos_pos. Qed.
Lemma of_pos_small p : (Zpos p <? 4611686018427387904) = true -> of_pos p = Zpos p.
Proof. intros H. apply Z.ltb_lt in H. unfold of_pos. apply wrap_small. lia. Qed.
Lemma orientation_margin_is : orientation_margin = 5905580032.
Proof. now apply of_pos_small. Qed.
Lemma side_margin_is : side_margin = 22011707392.
Proof. now apply of_pos_small. Qed.
Lemma minus_side_margin : sub zero side_margin = -22011707392.
Proof. rewrite side_margin_is. unfold sub, zero. now rewrite wrap_small by lia. Qed.
Lemma depth_margin_is : depth_margin = 274877906944.
Proof. now apply of_pos_small. Qed.

Section Signs.
Variables (S a : Z) (u v w : vector) (u' v' w' : arrow).
Hypothesis a_positive : 0 < a.
Hypothesis u_estimated : estimated S (134217728) 1 (times a u) u'.
Hypothesis v_estimated : estimated S (134217728) 1 (times a v) v'.
Hypothesis w_estimated : estimated S (134217728) 1 (times a w) w'.

Let vw := estimated_crossed _ _ _ _ _ v_estimated w_estimated.
Let wu := estimated_crossed _ _ _ _ _ w_estimated u_estimated.
Let uv := estimated_crossed _ _ _ _ _ u_estimated v_estimated.

Ltac flat := destruct u as [[? ?] ?], v as [[? ?] ?], w as [[? ?] ?]; cbn [times cross3 inner3];
  ring.

Lemma det_estimated : estimate (S * S * S * 67108864) (a ^ 3 * det3 u v w) (216172782113783808)
  (5637144606)
  (dot u' (crossed v' w')).
Proof.
  eapply estimate_unit; [eapply estimate_weaken; [eapply estimated_dot|]| |].
  - exact u_estimated.
  - exact vw.
  - reflexivity.
  - lia.
  - reflexivity.
  - ring.
  - unfold det3. flat.
Qed.
Lemma orientation_positive : ltb orientation_margin (dot u' (crossed v' w')) = true ->
  0 < det3 u v w.
Proof.
  intros H. apply ltb_less in H. rewrite orientation_margin_is in H.
  assert (P : 0 < a ^ 3 * det3 u v w) by (eapply estimate_positive; [exact det_estimated|lia]).
  apply (factor_out (a ^ 3)); [now apply cube_positive|]. now rewrite Z.mul_0_r.
Qed.

(** [side], opposite the end of u, v and w, and opposite the point that they begin at. *)
Lemma side_negative S' b q q' i n : 0 < b -> estimated S' (134217728) 2 (times b q) q' ->
  estimated (S * S * 67108864) (536870912) 10 (times (a * a) i) n ->
  ltb (dot q' n) (sub zero side_margin) = true -> inner3 q i < 0.
Proof.
  intros Hb Hq Hi H. apply ltb_less in H. rewrite minus_side_margin in H.
  assert (P : inner3 (times b q) (times (a * a) i) < 0).
  { eapply estimate_negative; [eapply estimated_dot; [exact Hq|exact Hi|reflexivity|lia]|]. lia. }
  replace (inner3 (times b q) (times (a * a) i)) with (b * a * a * inner3 q i) in P
    by (destruct q as [[? ?] ?], i as [[? ?] ?]; cbn [times inner3]; ring).
  apply (factor_out (b * a * a)); [now apply product_positive|]. now rewrite Z.mul_0_r.
Qed.
Lemma crossed_at x y x' y' : estimated S (134217728) 1 (times a x) x' ->
  estimated S (134217728) 1 (times a y) y' ->
  estimated (S * S * 67108864) (536870912) 10 (times (a * a) (cross3 x y)) (crossed x' y').
Proof.
  intros Hx Hy. pose proof (estimated_crossed _ _ _ _ _ Hx Hy) as H.
  replace (times (a * a) (cross3 x y)) with (cross3 (times a x) (times a y)); [exact H|].
  destruct x as [[? ?] ?], y as [[? ?] ?]. cbn [times cross3]. f_equal; [f_equal|]; ring.
Qed.
Lemma last_side_positive S' b q q' : 0 < b -> estimated S' (134217728) 2 (times b q) q' ->
  ltb side_margin (add (add (dot q' (crossed v' w')) (dot q' (crossed w' u')))
    (dot q' (crossed u' v'))) = true ->
  0 < inner3 q (cross3 v w) + inner3 q (cross3 w u) + inner3 q (cross3 u v).
Proof.
  intros Hb Hq H. apply ltb_less in H. rewrite side_margin_is in H.
  assert (P : 0 < inner3 (times b q) (cross3 (times a v) (times a w)) +
    inner3 (times b q) (cross3 (times a w) (times a u)) + inner3 (times b q)
      (cross3 (times a u) (times a v))).
  { eapply estimate_positive.
    - eapply estimate_add; [eapply estimate_add|..].
      + eapply estimated_dot; [exact Hq|exact vw|reflexivity|lia].
      + eapply estimated_dot; [exact Hq|exact wu|reflexivity|lia].
      + reflexivity.
      + eapply estimated_dot; [exact Hq|exact uv|reflexivity|lia].
      + reflexivity.
    - lia. }
  match type of P with 0 < ?p => replace p with
    (b * a * a * (inner3 q (cross3 v w) + inner3 q (cross3 w u) + inner3 q (cross3 u v))) in P end.
  - apply (factor_out (b * a * a)); [now apply product_positive|]. now rewrite Z.mul_0_r.
  - destruct q as [[? ?] ?]. flat.
Qed.

(** The slope and the depth of [Predicates.v], without weights. *)
Definition slope_vector : vector :=
  let f := inner3 u u in let g := inner3 v v in let h := inner3 w w in
  let '(ux, uy, uz) := cross3 v w in
  let '(vx, vy, vz) := cross3 w u in
  let '(wx, wy, wz) := cross3 u v in
  (f * ux + g * vx + h * wx, f * uy + g * vy + h * wy, f * uz + g * vz + h * wz).

Lemma square_estimated x x' : estimated S (134217728) 1 (times a x) x' ->
  estimate (S * S * 67108864) (inner3 (times a x) (times a x)) (805306368) 14 (down26 (dot x' x')).
Proof.
  intros H. eapply estimate_div; [|lia|].
  - eapply estimated_dot; [exact H|exact H|reflexivity|lia].
  - reflexivity.
Qed.
Lemma scaled_square k x y z : inner3 (k * x, k * y, k * z) (k * x, k * y, k * z) = k * k * inner3
  (x, y, z) (x, y, z).
Proof. cbn [inner3]. ring. Qed.
Lemma scaled_difference k b c d e : k * b * (k * c) - k * d * (k * e) = k * k * (b * c - d * e).
Proof. ring. Qed.
Ltac without_scale := rewrite !scaled_square, !scaled_difference; ring.
Lemma slope_one {f g h x y z f' g' h' x' y' z' T} :
  estimate T f (805306368) 14 f' -> estimate T g (805306368) 14 g' ->
    estimate T h (805306368) 14 h' ->
  estimate T x (536870912) 10 x' -> estimate T y (536870912) 10 y' ->
    estimate T z (536870912) 10 z' ->
  estimate (T * T * 268435456) (f * x + g * y + h * z) (4831838208) 176
    (down28 (add (add (mul f' x') (mul g' y')) (mul h' z'))).
Proof.
  intros F G H X Y Z'. eapply estimate_div; [|lia|].
  - eapply estimate_add; [eapply estimate_add|..].
    + eapply estimate_mul; [exact F|exact X|reflexivity].
    + eapply estimate_mul; [exact G|exact Y|reflexivity].
    + reflexivity.
    + eapply estimate_mul; [exact H|exact Z'|reflexivity].
    + reflexivity.
  - reflexivity.
Qed.

Lemma depth_negative p p' : estimated S (268435456) 1 (times a p) p' ->
  ltb (add (dot (slope_of (down26 (dot u' u')) (down26 (dot v' v')) (down26 (dot w' w'))
               (crossed v' w') (crossed w' u') (crossed u' v')) p') depth_margin)
    (mul (down28 (dot u' (crossed v' w'))) (down26 (dot p' p'))) = true ->
  inner3 slope_vector p - det3 u v w * inner3 p p < 0.
Proof.
  intros Hp H.
  set (slope' := slope_of _ _ _ _ _ _) in H.
  assert (Sl : estimated ((S * S * 67108864) * (S * S * 67108864) * 268435456) (4831838208) 176
    (times (a ^ 4) slope_vector) slope').
  { pose proof (square_estimated _ _ u_estimated) as F.
    pose proof (square_estimated _ _ v_estimated) as G.
    pose proof (square_estimated _ _ w_estimated) as H'.
    pose proof vw as A. pose proof wu as B. pose proof uv as C.
    unfold slope', slope_of, slope_vector.
    destruct u as [[? ?] ?], v as [[? ?] ?], w as [[? ?] ?].
    cbn [times cross3] in *. destruct A as (A1 & A2 & A3), B as (B1 & B2 & B3), C as (C1 & C2 & C3).
    unfold estimated, times. split; [|split]; cbn [along_x along_y along_z].
    - eapply estimate_unit; [exact (slope_one F G H' A1 B1 C1)|reflexivity|without_scale].
    - eapply estimate_unit; [exact (slope_one F G H' A2 B2 C2)|reflexivity|without_scale].
    - eapply estimate_unit; [exact (slope_one F G H' A3 B3 C3)|reflexivity|without_scale]. }
  assert (Up : estimate (S ^ 5 * 2 ^ 80) (a ^ 5 * inner3 slope_vector p) (3891110078048108544)
    (156229435920) (dot slope' p')).
  { eapply estimate_unit;
      [eapply estimate_weaken;
      [eapply estimated_dot; [exact Sl|exact Hp|reflexivity|lia]|reflexivity]
                          |ring|].
    destruct slope_vector as [[? ?] ?], p as [[? ?] ?]. cbn [times inner3]. ring. }
  assert (Down : estimate (S ^ 5 * 2 ^ 80) (a ^ 5 * (det3 u v w * inner3 p p)) (2594073385365405696)
    (95026152022)
    (mul (down28 (dot u' (crossed v' w'))) (down26 (dot p' p')))).
  { eapply estimate_unit; [eapply estimate_weaken; [eapply estimate_mul|]| |].
    - eapply (estimate_div (268435456) _ _ _ _ _ (805306368) 23);
        [exact det_estimated|lia|reflexivity].
    - eapply (estimate_div (67108864) _ _ _ _ _ (3221225472) 26);
        [eapply estimated_dot; [exact Hp|exact Hp|reflexivity|lia]|lia|reflexivity].
    - reflexivity.
    - reflexivity.
    - ring.
    - destruct p as [[? ?] ?]. cbn [times inner3]. ring. }
  rewrite depth_margin_is in H.
  assert (Q : a ^ 5 * inner3 slope_vector p < a ^ 5 * (det3 u v w * inner3 p p))
    by (eapply estimates_differ; [exact Up|exact Down| |exact H]; reflexivity).
  apply (factor_out (a ^ 5)) in Q; [|now apply cube_positive]. now apply Z.lt_sub_0.
Qed.
End Signs.
