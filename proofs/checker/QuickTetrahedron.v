(** * What the quick check finds of a tetrahedron *)
From Coq Require Import ZArith List Bool Lia.
From Circumspect Require Import Numbering Accepted Integers.
From Circumspect Require Import Quick Estimates Rounded QuickSound QuickFacets.
From Circumspect Require Import Word.
Import ListNotations.
Open Scope Z_scope.

Lemma small_sums : add zero one = 1 /\ add one one = 2 /\ add two one = 3 /\
  add four 0 = five - 1 /\ add four 1 = five /\ add four 2 = six /\ add four 3 = seven.
Proof.
  unfold add, zero, one, two, four, five, six, seven. rewrite !wrap_small by lia. repeat split.
Qed.

Section Tetrahedron.
Variables (p : packed) (s : Word.t) (asked : option standing) (X0 Y0 Z0 : Z).
Notation c := (frame p).
Notation pr := space_predicates.
Notation m := (packed_mesh Space p).
Notation N := (count_of (points c)).
Notation rows := (rows_of p).
Notation places := (places_of s (points c)).
Notation w := (sample_denominator c).
Notation here := (Arrow (Z.shiftr X0 s) (Z.shiftr Y0 s) (Z.shiftr Z0 s)).
Hypothesis in_words : within_words Space p s.
Hypothesis sample_shape : coordinates (sample c) = [X0; Y0; Z0].
Hypothesis sample_fits : fits s X0 = true /\ fits s Y0 = true /\ fits s Z0 = true.
Hypothesis sample_small : 0 < w <= 8.

Lemma point_known v : known N v = true ->
  exists q, Table.find (to_pos v) (points_of m) = Some q /\ rounded s q (arrow_to places v).
Proof.
  apply (known_point s (points c) _ _ (shapes _ _ _ in_words) (all_fit _ _ _ in_words)
    (few_points _ _ _ in_words) (unweighted _ _ _ in_words)).
Qed.

(** ** Across a facet *)

Lemma quick_wall_sound t i i_is_odd k0 k1 k2 x apex_ok K X n a :
  Zpos t <= simplex_count p -> 0 <= i <= 3 -> i_is_odd = Nat.odd (Z.to_nat i) ->
  0 < k0 -> 0 < k1 -> 0 < k2 -> k0 <> k1 -> k0 <> k2 -> k1 <> k2 ->
  K = at_place (Z.to_nat i) a [to_pos k0; to_pos k1; to_pos k2] ->
  - 2 ^ 62 <= x < 2 ^ 62 ->
  (forall u v q, apex_ok u v = true -> Table.find (to_pos v) (points_of m) = Some q ->
     rounded s q (arrow_to places v) -> delaunay_claimed m = true -> Pos.ltb t (to_pos u) = true ->
     depth pr X n q <= 0 /\ forall st, asked = Some st ->
       settled pr st K X n (to_pos v) q = true) ->
  quick_wall m (simplex_count p) N rows t i i_is_odd k0 k1 k2 x apex_ok = true ->
  check_wall pr m t K X n (Z.to_nat i) (wall_of x) = Accepted /\
  (delaunay_claimed m = true -> forall st, asked = Some st ->
    settled_wall pr m st t K X n (wall_of x) = true).
Proof.
  intros Ht Hi Odd P0 P1 P2 N01 N02 N12 -> Rx Deep H. cbv delta [quick_wall] in H. cbv beta in H.
  unfold wall_of. destruct (ltb x zero) eqn:Lx.
  { unfold check_wall. change (index i) with (Z.to_nat i) in H. rewrite H. split; reflexivity. }
  open_lets H.
  assert (K1 : known (simplex_count p) u = true) by assumption.
  assert (K2 : leb j three = true) by assumption.
  assert (K3 : eqb (get rows (add r (add four j))) (add (mul eight (of_pos t)) i) = true)
    by assumption.
  assert (K4 : known N v = true) by assumption.
  assert (K5 : negb (eqb v k0) = true) by assumption.
  assert (K6 : negb (eqb v k1) = true) by assumption.
  assert (K7 : negb (eqb v k2) = true) by assumption.
  assert (K8 : (if Bool.eqb i_is_odd (is_odd j) then reflected k0 k1 k2 l0 l1 l2 else
    rotated k0 k1 k2 l0 l1 l2) = true) by assumption.
  apply Z.ltb_ge in Lx. destruct (wall_parts x (conj Lx (proj2 Rx))) as (Bu & Ej & Bj).
  fold u in Bu, Ej. fold j in Ej. apply leb_le' in K2. apply eqb_eq' in K3.
  assert (J : j = 0 \/ j = 1 \/ j = 2 \/ j = 3) by (unfold three in K2; lia).
  fold u j. clearbody u j. pose proof (find_simplex Space p u K1) as F.
  destruct (point_known v K4) as (q & Fq & Rq).
  apply unlike in K5, K6, K7. apply known_positive in K4. apply known_positive in K1.
  assert (Mf := matched_across i j i_is_odd k0 k1 k2 l0 l1 l2 v a Hi J Odd P0 P1 P2 N01 N02 N12 K4
    K5 K6 K7 K8).
  assert (B : nth_error (walls (entry_of Space rows (to_pos u))) (Z.to_nat j) = Some
    (Neighbour t (Z.to_nat i)) /\
    corners (entry_of Space rows (to_pos u)) = at_place (Z.to_nat j) (to_pos v) [to_pos l0;
      to_pos l1; to_pos l2]).
  { rewrite <- (wall_back t i (Z.le_trans _ _ _ Ht (few_simplices _ _ _ in_words)) Hi), <- K3.
    unfold entry_of, corners_of. rewrite (of_to_pos u) by lia.
    unfold v, l0, l1, l2, other_corner. fold r.
    pose proof small_sums as (S0 & S1 & S2 & S3 & S4 & S5 & S6). change (five - 1) with four in S3.
    clear - J S0 S1 S2 S3 S4 S5 S6. destruct J as [->|[->|[->| ->]]];
      cbn [leb Z.leb zero one two three Z.compare Pos.compare Pos.compare_cont];
      rewrite ?S0, ?S1, ?S2, ?S3, ?S4, ?S5, ?S6; split; reflexivity. }
  destruct B as [Bw Bc].
  eapply neighbour_accepted with (v := to_pos v);
    [exact F|now rewrite Bc|exact Bw| |exact Fq|].
  - rewrite Bc. clear - J. destruct J as [->|[->|[->| ->]]]; reflexivity.
  - intros Q1 Q2. exact (Deep u v q H Fq Rq Q1 Q2).
Qed.

(** The determinants of [Predicates.v], of edges. *)
Lemma side_at i qa qb qc qd : (exists x y z, qa = Site [x; y; z] 0) ->
  (exists x y z, qb = Site [x; y; z] 0) ->
  (exists x y z, qc = Site [x; y; z] 0) -> (exists x y z, qd = Site [x; y; z] 0) ->
  let u := difference qa qd in let v := difference qb qd in let x := difference qc qd in
  side pr i [qa; qb; qc; qd] (sample c) w =
  match i with
  | 0%nat => inner3 (from3 w qd (sample c)) (cross3 v x)
  | 1%nat => inner3 (from3 w qd (sample c)) (cross3 x u)
  | 2%nat => inner3 (from3 w qd (sample c)) (cross3 u v)
  | 3%nat => - (inner3 (from3 w qa (sample c)) (cross3 v x) + inner3 (from3 w qa (sample c))
      (cross3 x u) +
                inner3 (from3 w qa (sample c)) (cross3 u v))
  | _ => 0
  end.
Proof.
  intros (xa & ya & za & ->) (xb & yb & zb & ->) (xc & yc & zc & ->) (xd & yd & zd & ->).
  destruct i as [|[|[|[|i]]]]; try reflexivity. cbn [side space_predicates side3 difference].
  unfold det3, from3.
  rewrite sample_shape. cbn. ring.
Qed.

Lemma depth_at qa qb qc qd q : (exists x y z, qa = Site [x; y; z] 0) ->
  (exists x y z, qb = Site [x; y; z] 0) ->
  (exists x y z, qc = Site [x; y; z] 0) -> (exists x y z, qd = Site [x; y; z] 0) ->
    (exists x y z, q = Site [x; y; z] 0) ->
  depth pr [qa; qb; qc; qd] (slope pr [qa; qb; qc; qd]) q =
  inner3 (slope_vector (difference qa qd) (difference qb qd) (difference qc qd)) (difference q qd) -
  det3 (difference qa qd) (difference qb qd) (difference qc qd) * inner3 (difference q qd)
    (difference q qd).
Proof.
  intros (xa & ya & za & ->) (xb & yb & zb & ->) (xc & yc & zc & ->) (xd & yd & zd & ->)
    (x & y & z & ->).
  cbv [depth slope space_predicates depth3 slope3 slope_vector difference minus3 det3 inner3 cross3
    height3 coordinates weight].
  ring.
Qed.

Lemma rounded_site q P : rounded s q P -> exists x y z, q = Site [x; y; z] 0.
Proof. intros (x & y & z & -> & _). eauto. Qed.

Section Edges.
Variables (t : positive) (n : Z) (qa qb qc qd : site) (pa pb pc pd : arrow).
Hypotheses (Ra : rounded s qa pa) (Rb : rounded s qb pb) (Rc : rounded s qc pc)
  (Rd : rounded s qd pd).
Hypothesis fine_n : fine s n = true.
Notation u := (leveled n (arrow_from pa pd)).
Notation v := (leveled n (arrow_from pb pd)).
Notation x := (leveled n (arrow_from pc pd)).
Hypotheses (Iu : inside (up one n) (arrow_from pa pd) = true)
  (Iv : inside (up one n) (arrow_from pb pd) = true)
  (Iw : inside (up one n) (arrow_from pc pd) = true).

Lemma edge q P : rounded s q P -> inside (up one n) (arrow_from P pd) = true ->
  estimated (unit s n) 134217728 1 (times (factor n) (difference q qd))
    (leveled n (arrow_from P pd)).
Proof.
  intros R I. pose proof (fine_parts s n fine_n) as [Rn _]. destruct (up_one n ltac:(lia)) as [E _].
  rewrite E in I. apply (edge_estimated s n fine_n q qd P pd 1 R Rd (or_introl eq_refl)).
  now rewrite Z.mul_1_l.
Qed.
Let Eu := edge _ _ Ra Iu.
Let Ev := edge _ _ Rb Iv.
Let Ew := edge _ _ Rc Iw.
Let Fp := factor_positive s n fine_n.

Lemma positive_here : ltb orientation_margin (dot u (crossed v x)) = true ->
  positive_simplex pr [qa; qb; qc; qd] = true.
Proof.
  intros H. apply Z.ltb_lt. exact (orientation_positive _ _ _ _ _ _ _ _ Fp Eu Ev Ew H).
Qed.

Lemma outside_here a away : quick_outside m s here w t pa pd (crossed v x) (crossed x u)
  (crossed u v) a = true ->
  away = away_of a -> outside_sample pr m t [qa; qb; qc; qd] away = true.
Proof.
  intros H ->. cbv delta [quick_outside] in H. cbv beta in H. unfold outside_sample.
  apply orb_prop in H. destruct H as [H|H]; [now rewrite H|]. apply orb_true_intro. right.
  open_lets H.
  assert (Fi : fine s n0 = true) by assumption.
  assert (In_ : inside (up one n0) q = true) by assumption.
  pose proof (fine_parts s n0 Fi) as [Rn _]. destruct (up_one n0 ltac:(lia)) as [E _].
  rewrite E in In_.
  pose proof (side_at) as Si.
  assert (Sh := conj (rounded_site _ _ Ra)
    (conj (rounded_site _ _ Rb) (conj (rounded_site _ _ Rc) (rounded_site _ _ Rd)))).
  destruct Sh as (Sa & Sb & Sc & Sd).
  destruct sample_fits as (F1 & F2 & F3).
  assert (Es : forall z P, rounded s z P -> base = P ->
    estimated (unit s n0) 134217728 2 (times (factor n0) (from3 w z (sample c))) q').
  { intros z P Rz B. rewrite <- B in Rz. clear B. clearbody base.
    exact (sample_estimated s n0 Fi (sample c) z base X0 Y0 Z0 w sample_small Rz sample_shape F1 F2
      F3 In_). }
  pose proof (factor_positive s n0 Fi) as Fq.
  assert (D : a = 0 \/ a = 1 \/ a = 2 \/ a = 3).
  { match goal with A : eqb a zero || eqb a one || eqb a two || eqb a three = true |- _ =>
      clear - A end.
    repeat (apply orb_prop in A; destruct A as [A|A]); apply eqb_eq' in A; auto. }
  assert (W : forall i, away_of a = Some i -> side pr i [qa; qb; qc; qd] (sample c) w < 0 ->
    match away_of a with Some i => side pr i [qa; qb; qc; qd] (sample_of m) (sample_w m) <? 0 | None
      => false end = true).
  { intros i -> L. now apply Z.ltb_lt. }
  destruct (eqb a zero) eqn:G0; [|destruct (eqb a one) eqn:G1; [|destruct (eqb a two) eqn:G2]].
  - apply eqb_eq' in G0. assert (B : base = pd) by (unfold base; now rewrite G0).
    clearbody q' base. apply (W 0%nat); [now rewrite G0|]. rewrite (Si 0%nat _ _ _ _ Sa Sb Sc Sd).
    pose proof (Es _ _ Rd B) as Hq. pose proof (crossed_at _ _ _ _ _ _ Ev Ew) as Hc.
    refine (side_negative _ _ Fp _ _ _ _ _ _ Fq Hq Hc H).
  - apply eqb_eq' in G1. assert (B : base = pd) by (unfold base; now rewrite G1).
    clearbody q' base. apply (W 1%nat); [now rewrite G1|]. rewrite (Si 1%nat _ _ _ _ Sa Sb Sc Sd).
    pose proof (Es _ _ Rd B) as Hq. pose proof (crossed_at _ _ _ _ _ _ Ew Eu) as Hc.
    refine (side_negative _ _ Fp _ _ _ _ _ _ Fq Hq Hc H).
  - apply eqb_eq' in G2. assert (B : base = pd) by (unfold base; now rewrite G2).
    clearbody q' base. apply (W 2%nat); [now rewrite G2|]. rewrite (Si 2%nat _ _ _ _ Sa Sb Sc Sd).
    pose proof (Es _ _ Rd B) as Hq. pose proof (crossed_at _ _ _ _ _ _ Eu Ev) as Hc.
    refine (side_negative _ _ Fp _ _ _ _ _ _ Fq Hq Hc H).
  - assert (G3 : a = 3) by (destruct D as [->|[->|[->|D]]];
      [discriminate|discriminate|discriminate|exact D]).
    assert (B : base = pa) by (unfold base; now rewrite G3).
    clearbody q' base. apply (W 3%nat); [now rewrite G3|]. rewrite (Si 3%nat _ _ _ _ Sa Sb Sc Sd).
    pose proof (Es _ _ Ra B) as Hq.
    apply Z.opp_neg_pos. refine (last_side_positive _ _ _ _ _ _ _ _ Fp Eu Ev Ew _ _ _ _ Fq Hq H).
Qed.

Lemma below_here q P : rounded s q P ->
  quick_below n pd (slope_of (down26 (dot u u)) (down26 (dot v v)) (down26 (dot x x)) (crossed v x)
    (crossed x u) (crossed u v))
    (down28 (dot u (crossed v x))) P = true ->
  depth pr [qa; qb; qc; qd] (slope pr [qa; qb; qc; qd]) q < 0.
Proof.
  intros R H. cbv delta [quick_below] in H. cbv beta in H. open_lets H.
  rewrite depth_at by eauto using rounded_site.
  refine (depth_negative _ _ _ _ _ _ _ _ Fp Eu Ev Ew _ e' _ H).
  pose proof (fine_parts s n fine_n) as [Rn _].
  change 268435456 with (2 * 134217728).
  apply (edge_estimated s n fine_n q qd P pd 2 R Rd (or_intror eq_refl)).
  assert (I : inside (up one (add n one)) e = true) by assumption.
  rewrite (add_small n one (n + 1)) in I by (unfold one; lia).
  destruct (up_one (n + 1) ltac:(lia)) as [E _].
  rewrite E, Z.pow_add_r in I by lia. now rewrite Z.mul_comm.
Qed.
End Edges.

(** ** Hull facets *)

Lemma placed_at k q : counted N k = true -> Table.find k (points_of m) = Some q ->
  rounded s q (place_at places k).
Proof.
  intros H F. apply andb_prop in H. destruct H as [K E]. apply Pos.eqb_eq in E.
  destruct (point_known (of_pos k) K) as (q' & F' & R). rewrite E, F in F'.
  now injection F' as ->.
Qed.
Lemma positive_quickly qa qb qc qd pa pb pc pd : rounded s qa pa -> rounded s qb pb ->
  rounded s qc pc -> rounded s qd pd ->
  quick_positive s pa pb pc pd = true -> 0 < orientation pr [qa; qb; qc; qd].
Proof.
  intros Ra Rb Rc Rd H. cbv delta [quick_positive] in H. cbv beta in H. open_lets H.
  apply Z.ltb_lt. change (positive_simplex pr [qa; qb; qc; qd] = true).
  assert (Fi : fine s n = true) by assumption. assert (Iu : inside most eu = true) by assumption.
  assert (Iv : inside most ev = true) by assumption.
  assert (Iw : inside most ew = true) by assumption.
  exact (positive_here n qa qb qc qd pa pb pc pd Ra Rb Rc Rd Fi Iu Iv Iw H).
Qed.
Lemma side_quickly E i v X q : find_all (points_of m) E = Some X ->
  Table.find v (points_of m) = Some q ->
  quick_side N places s E i v = true -> 0 <= side pr i X q 1.
Proof.
  intros Fe Fv H. unfold quick_side in H.
  destruct (replace i v E) as [|a [|b [|c0 [|d [|? ?]]]]] eqn:R; try discriminate H.
  apply andb_prop in H. destruct H as [H Q]. cbn [forallb] in H. ands.
  assert (F : forall k, counted N k = true -> forall z, Table.find k (points_of m) = Some z ->
    rounded s z (place_at places k))
    by (intros k K z; now apply placed_at).
  destruct E as [|a0 [|b0 [|c1 [|d0 [|? ?]]]]]; destruct i as [|[|[|[|[|i]]]]]; cbn [replace] in R;
    try discriminate R.
  all: injection R; intros; subst; cbn [find_all] in Fe.
  all: repeat match type of Fe with context [match Table.find ?k ?T with _ => _ end] =>
    let G := fresh "G" in destruct (Table.find k T) eqn:G; [|discriminate Fe] end.
  all: injection Fe as <-.
  5-6: reflexivity.
  all: apply Z.lt_le_incl.
  all: lazymatch type of Q with quick_positive _ (place_at _ ?ka) (place_at _ ?kb) (place_at _ ?kc)
    (place_at _ ?kd) = true =>
    match goal with Ga : Table.find ka _ = Some ?qa, Gb : Table.find kb _ = Some ?qb,
      Gc : Table.find kc _ = Some ?qc,
      Gd : Table.find kd _ = Some ?qd |- _ =>
      let Ra := fresh "Ra" in pose proof (F ka ltac:(assumption) qa Ga) as Ra;
      let Rb := fresh "Rb" in pose proof (F kb ltac:(assumption) qb Gb) as Rb;
      let Rc := fresh "Rc" in pose proof (F kc ltac:(assumption) qc Gc) as Rc;
      let Rd := fresh "Rd" in pose proof (F kd ltac:(assumption) qd Gd) as Rd;
      pose proof (positive_quickly _ _ _ _ _ _ _ _ Ra Rb Rc Rd Q) as O;
      apply rounded_site in Ra; apply rounded_site in Rb; apply rounded_site in Rc;
        apply rounded_site in Rd;
      destruct Ra as (xa & ya & za & ->), Rb as (xb & yb & zb & ->), Rc as (xc & yc & zc & ->),
        Rd as (xd & yd & zd & ->)
    end end.
  all: cbn [side orientation space_predicates side3 orientation3] in *; unfold det3, inner3, cross3,
    from3, minus3 in *;
    cbn [coordinates] in *; clear - O; lia.
Qed.

Lemma every_index_each {A} (f : nat -> A -> bool) (g : nat -> A -> result) (l : list A) :
  (forall k a, f k a = true -> g k a = Accepted) -> forall k, every_index f k l = true ->
    each_index g k l = Accepted.
Proof.
  intros H. induction l as [|a l IH]; intros k E; cbn [every_index each_index] in *; [reflexivity|].
  apply andb_prop in E. destruct E as [E E']. now rewrite (H k a E), IH.
Qed.
Lemma hull_here h f : quick_hull m N places s h f = true -> check_hull pr m h f = Accepted.
Proof.
  unfold quick_hull, check_hull. destruct (Table.find (carrier f) (simplices_of m)) as [e|];
    [|discriminate].
  intros H. apply andb_prop in H. destruct H as [-> H].
  destruct (find_all (points_of m) (corners e)) as [X|] eqn:Fe; [|discriminate].
  apply andb_prop in H. destruct H as [H R]. apply andb_prop in H. destruct H as [-> L].
  cbn [dimension space_predicates]. rewrite L.
  revert R. apply every_index_each. intros a [g b] Q. unfold quick_ridge in Q. unfold check_ridge.
  destruct (Table.find g (hull_of m)) as [f'|]; [|discriminate].
  destruct (Table.find (carrier f') (simplices_of m)) as [u|]; [|discriminate]. cbv zeta in *.
  apply andb_prop in Q. destruct Q as [Q V]. apply andb_prop in Q. destruct Q as [-> ->].
  destruct (nth_error (remove (apex f') (corners u)) b) as [v|]; [|discriminate].
  destruct (Table.find v (points_of m)) as [q|] eqn:Fv; [|discriminate].
  assert (G : locally_convex pr (apex f) X q = true).
  { apply orb_prop in V. destruct V as [V|V]; [|exact V]. apply Z.leb_le.
    exact (side_quickly _ _ _ _ _ Fe Fv V). }
  now rewrite G.
Qed.

Lemma some_is {A} (x y : A) : Some x = Some y -> x = y.
Proof. now intros [= E]. Qed.

(** The four walls are those of [entry_of].  (Nothing here is to be computed.) *)
Local Opaque wrap add sub mul of_pos up down size leb ltb eqb get.
Lemma simplex_here t : Zpos t <= simplex_count p ->
  quick_simplex m (simplex_count p) N rows places s here w asked t = true ->
  check_simplex pr m t (entry_of Space rows t) = Accepted /\
  (delaunay_claimed m = true -> forall st, asked = Some st ->
    settled_simplex pr m st t (entry_of Space rows t) = true).
Proof.
  intros Ht H. cbv delta [quick_simplex] in H. cbv beta in H. open_lets H. rename c into c0.
  rename w into ew'.
  assert (Ka : known N a = true) by assumption. assert (Kb : known N b = true) by assumption.
  assert (Kc : known N c0 = true) by assumption. assert (Kd : known N d = true) by assumption.
  assert (Ne : a <> b /\ a <> c0 /\ a <> d /\ b <> c0 /\ b <> d /\ c0 <> d)
    by (repeat split; apply unlike; assumption).
  destruct Ne as (Nab & Nac & Nad & Nbc & Nbd & Ncd).
  assert (Fi : fine s n = true) by assumption.
  assert (Iu : inside most eu = true) by assumption.
  assert (Iv : inside most ev = true) by assumption.
  assert (Iw : inside most ew = true) by assumption.
  assert (Or : ltb orientation_margin det = true) by assumption.
  assert (Ou : quick_outside m s here w t pa pd vw wu uv (get rows (add r eight)) = true)
    by assumption.
  assert (W0 : quick_wall m (simplex_count p) N rows t zero false b c0 d (get rows (add r four))
    below = true) by assumption.
  assert (W1 : quick_wall m (simplex_count p) N rows t one true a c0 d (get rows (add r five)) below
    = true) by assumption.
  assert (W2 : quick_wall m (simplex_count p) N rows t two false a b d (get rows (add r six)) below
    = true) by assumption.
  rename H into W3.
  destruct (point_known a Ka) as (qa & Fa & Ra). destruct (point_known b Kb) as (qb & Fb & Rb).
  destruct (point_known c0 Kc) as (qc & Fc & Rc). destruct (point_known d Kd) as (qd & Fd & Rd).
  pose proof (positive_here n qa qb qc qd pa (arrow_to places b) (arrow_to places c0) pd Ra Rb Rc Rd
    Fi Iu Iv Iw Or) as Pos.
  pose proof (outside_here t n qa qb qc qd pa (arrow_to places b) (arrow_to places c0) pd Ra Rb Rc
    Rd Fi Iu Iv Iw _ _ Ou eq_refl) as Out.
  assert (Co : corners (entry_of Space rows t) = [to_pos a; to_pos b; to_pos c0; to_pos d])
    by reflexivity.
  assert (Wa : walls (entry_of Space rows t) = [wall_of (get rows (add r four));
    wall_of (get rows (add r five)); wall_of (get rows (add r six));
    wall_of (get rows (add r seven))]) by reflexivity.
  assert (Aw : away (entry_of Space rows t) = away_of (get rows (add r eight))) by reflexivity.
  assert (Fs : find_all (points_of m) (corners (entry_of Space rows t)) = Some [qa; qb; qc; qd])
    by (rewrite Co; cbn [find_all]; now rewrite Fa, Fb, Fc, Fd).
  assert (Deep : forall sl, (delaunay_claimed m = true -> sl = slope pr [qa; qb; qc; qd]) ->
    forall u v q, below u v = true -> Table.find (to_pos v) (points_of m) = Some q ->
    rounded s q (arrow_to places v) -> delaunay_claimed m = true -> Pos.ltb t (to_pos u) = true ->
    depth pr [qa; qb; qc; qd] sl q <= 0 /\ forall st, asked = Some st -> settled pr st
      [to_pos a; to_pos b; to_pos c0; to_pos d] [qa; qb; qc; qd] sl (to_pos v) q = true).
  { intros sl Sl u1 v1 q B Fq Rq Q1 Q2. rewrite (Sl Q1). unfold below in B. rewrite Q1, Q2 in B.
    rewrite Co in Fs. refine (below_enough Space p asked _ _ _ _ _ Fs Fq _ B).
    exact (below_here n qa qb qc qd pa (arrow_to places b) (arrow_to places c0) pd Ra Rb Rc Rd Fi Iu
      Iv Iw q _ Rq). }
  assert (Pa := known_positive _ a Ka). assert (Pb := known_positive _ b Kb).
  assert (Pc := known_positive _ c0 Kc). assert (Pd := known_positive _ d Kd).
  assert (R : forall k, - 2 ^ 62 <= get rows k < 2 ^ 62) by apply get_range.
  pose proof (quick_wall_sound t) as Wall.
  clear Or Ou Iu Iv Iw. clearbody below. clearbody a b c0 d r.
  assert (In4 : 0 <= zero <= 3 /\ 0 <= one <= 3 /\ 0 <= two <= 3 /\ 0 <= three <= 3)
    by (repeat split; discriminate).
  destruct In4 as (H00 & H01 & H02 & H03).
  apply (simplex_accepted Space p asked t _ _ Fs Pos); [reflexivity|now rewrite Aw|].
  intros sl Sl i f E. rewrite Wa in E. rewrite Co.
  destruct i as [|[|[|[|i]]]]; cbn [nth_error] in E.
  5: now destruct i.
  all: apply some_is in E; subst f.
  - exact (Wall zero false b c0 d _ below _ _ sl (to_pos a) Ht H00 eq_refl Pb Pc Pd Nbc Nbd Ncd
      eq_refl (R _) (Deep sl Sl) W0).
  - exact (Wall one true a c0 d _ below _ _ sl (to_pos b) Ht H01 eq_refl Pa Pc Pd Nac Nad Ncd
      eq_refl (R _) (Deep sl Sl) W1).
  - exact (Wall two false a b d _ below _ _ sl (to_pos c0) Ht H02 eq_refl Pa Pb Pd Nab Nad Nbd
      eq_refl (R _) (Deep sl Sl) W2).
  - exact (Wall three true a b c0 _ below _ _ sl (to_pos d) Ht H03 eq_refl Pa Pb Pc Nab Nac Nbc
      eq_refl (R _) (Deep sl Sl) W3).
Qed.
End Tetrahedron.
