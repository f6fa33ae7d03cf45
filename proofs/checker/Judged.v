(** * What the quick check finds of a tetrahedron, and the verdict *)
From Coq Require Import ZArith List Bool Lia.
From Circumspect Require Import Numbering Accepted Integers.
From Circumspect Require Import Quick Estimates Rounded QuickSound.
From Circumspect Require Import Word.
Import ListNotations.
Open Scope Z_scope.

Section Tetrahedron.
Variables (p : packed) (s : Word.t) (asked : option standing) (X0 Y0 Z0 : Z).
Notation c := (frame p).
Notation pr := space_predicates.
Notation m := (packed_mesh Space p).
Notation N := (count_of (points c)).
Notation rows := (rows_of p).
Notation places := (of_list (shifted s) (flat_map (fun e => coordinates (position e)) (points c))).
Notation w := (sample_denominator c).
Notation here := (Arrow (Z.shiftr X0 s) (Z.shiftr Y0 s) (Z.shiftr Z0 s)).
Hypothesis in_words : within_words p s.
Hypothesis sample_shape : coordinates (sample c) = [X0; Y0; Z0].
Hypothesis sample_fits : fits s X0 = true /\ fits s Y0 = true /\ fits s Z0 = true.
Hypothesis sample_small : 0 < w <= 8.

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

Lemma placed_at k q : placed N k = true -> Table.find k (points_of m) = Some q ->
  rounded s q (place_at places k).
Proof.
  intros H F. apply andb_prop in H. destruct H as [K E]. apply Pos.eqb_eq in E.
  destruct (point_known p s in_words (of_pos k) K) as (q' & F' & R). rewrite E, F in F'.
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
  apply andb_prop in H. destruct H as [H Q]. apply andb_prop in H. destruct H as [H Pd].
  apply andb_prop in H. destruct H as [H Pc]. apply andb_prop in H. destruct H as [Pa Pb].
  assert (F : forall k, placed N k = true -> forall z, Table.find k (points_of m) = Some z ->
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

Lemma known_positive v : known N v = true -> 0 < v.
Proof. intros K. apply known_spec in K. clear - K. lia. Qed.

Lemma some_is {A} (x y : A) : Some x = Some y -> x = y.
Proof. now intros [= E]. Qed.

(** The four walls are those of [entry_of].  (Nothing here is to be computed.) *)
Opaque wrap add sub mul of_pos up down size leb ltb eqb get.
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
  assert (Nab : a <> b) by (apply unlike; assumption).
  assert (Nac : a <> c0) by (apply unlike; assumption).
  assert (Nad : a <> d) by (apply unlike; assumption).
  assert (Nbc : b <> c0) by (apply unlike; assumption).
  assert (Nbd : b <> d) by (apply unlike; assumption).
  assert (Ncd : c0 <> d) by (apply unlike; assumption).
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
  pose proof (point_known p s in_words) as Known.
  destruct (Known a Ka) as (qa & Fa & Ra). destruct (Known b Kb) as (qb & Fb & Rb).
  destruct (Known c0 Kc) as (qc & Fc & Rc). destruct (Known d Kd) as (qd & Fd & Rd).
  pose proof (positive_here n qa qb qc qd pa (arrow_to places b) (arrow_to places c0) pd Ra Rb Rc Rd
    Fi Iu Iv Iw Or) as Pos.
  pose proof (outside_here t n qa qb qc qd pa (arrow_to places b) (arrow_to places c0) pd Ra Rb Rc
    Rd Fi Iu Iv Iw _ _ Ou eq_refl) as Out.
  assert (Co : corners (entry_of Space rows t) = [to_pos a; to_pos b; to_pos c0; to_pos d])
    by reflexivity.
  assert (Wa : walls (entry_of Space rows t) = [wall_of (get rows (add r four));
    wall_of (get rows (add r five));
    wall_of (get rows (add r six)); wall_of (get rows (add r seven))]) by reflexivity.
  assert (Aw : away (entry_of Space rows t) = away_of (get rows (add r eight))) by reflexivity.
  assert (Fs : find_all (points_of m) (corners (entry_of Space rows t)) = Some [qa; qb; qc; qd])
    by (rewrite Co; cbn [find_all]; now rewrite Fa, Fb, Fc, Fd).
  assert (Deep : forall sl, (delaunay_claimed m = true -> sl = slope pr [qa; qb; qc; qd]) ->
    forall u v q, below u v = true -> Table.find (to_pos v) (points_of m) = Some q ->
    rounded s q (arrow_to places v) -> delaunay_claimed m = true -> Pos.ltb t (to_pos u) = true ->
    depth pr [qa; qb; qc; qd] sl q <= 0 /\ forall st, asked = Some st ->
      settled pr st [to_pos a; to_pos b; to_pos c0; to_pos d] [qa; qb; qc;
        qd] sl (to_pos v) q = true).
  { intros sl Sl u1 v1 q B Fq Rq Q1 Q2. rewrite (Sl Q1). unfold below in B. rewrite Q1, Q2 in B.
    cbn [negb orb] in B.
    unfold settled. apply orb_prop in B. destruct B as [B|B].
    - pose proof (below_here n qa qb qc qd pa (arrow_to places b) (arrow_to places c0) pd Ra Rb Rc
        Rd Fi Iu Iv Iw q _ Rq B) as L.
      split; [now apply Z.lt_le_incl|]. intros st _. apply Z.ltb_lt in L. now rewrite L.
    - unfold Table.once, exactly_below, exact_plane in B. rewrite <- Co, Fs, Fq, Co in B.
      set (z := depth pr _ _ q) in *. clearbody z. clear - B. apply orb_prop in B.
      destruct B as [B|B].
      + split; [apply Z.ltb_lt in B; now apply Z.lt_le_incl|]. intros st _. now rewrite B.
      + apply andb_prop in B. destruct B as [B D]. split; [apply Z.eqb_eq in B; now rewrite B|].
        intros st E. rewrite B, E in *. destruct st; [now rewrite D, orb_true_r|discriminate]. }
  assert (Pa := known_positive a Ka). assert (Pb := known_positive b Kb).
  assert (Pc := known_positive c0 Kc). assert (Pd := known_positive d Kd).
  assert (R : forall k, - 2 ^ 62 <= get rows k < 2 ^ 62) by apply get_range.
  pose proof (quick_wall_sound p s asked in_words t) as Wall.
  clear Or Ou Iu Iv Iw. clearbody below. clearbody a b c0 d r.
  assert (H00 : 0 <= zero <= 3) by (split; discriminate).
  assert (H01 : 0 <= one <= 3) by (split; discriminate).
  assert (H02 : 0 <= two <= 3) by (split; discriminate).
  assert (H03 : 0 <= three <= 3) by (split; discriminate).
  assert (Walls : forall sl, (delaunay_claimed m = true -> sl = slope pr [qa; qb; qc; qd]) ->
    forall i f, nth_error (walls (entry_of Space rows t)) i = Some f ->
    check_wall pr m t [to_pos a; to_pos b; to_pos c0; to_pos d] [qa; qb; qc;
      qd] sl i f = Accepted /\
    (delaunay_claimed m = true -> forall st, asked = Some st ->
       settled_wall pr m st t [to_pos a; to_pos b; to_pos c0; to_pos d] [qa; qb; qc;
         qd] sl f = true)).
  { intros sl Sl i f E. rewrite Wa in E.
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
        eq_refl (R _) (Deep sl Sl) W3). }
  split.
  - unfold check_simplex. rewrite Fs, Pos, Wa, Aw, Out.
    cbn [length Nat.eqb dimension space_predicates]. rewrite <- Wa, Co.
    set (sl := if delaunay_claimed m then slope pr [qa; qb; qc; qd] else []).
    assert (Sl : delaunay_claimed m = true -> sl = slope pr [qa; qb; qc; qd]) by (intros E;
      unfold sl; now rewrite E).
    clearbody sl. specialize (Walls sl Sl). rewrite Wa in *. cbn [each_index].
    destruct (Walls 0%nat _ eq_refl) as [-> _]. destruct (Walls 1%nat _ eq_refl) as [-> _].
    destruct (Walls 2%nat _ eq_refl) as [-> _]. now destruct (Walls 3%nat _ eq_refl) as [-> _].
  - intros Cl st As. unfold settled_simplex. rewrite Fs, Co.
    specialize (Walls _ (fun _ => eq_refl)). rewrite Wa in *.
    cbn [forallb]. destruct (Walls 0%nat _ eq_refl) as [_ ->]; [|exact Cl|exact As].
    destruct (Walls 1%nat _ eq_refl) as [_ ->]; [|exact Cl|exact As].
    destruct (Walls 2%nat _ eq_refl) as [_ ->]; [|exact Cl|exact As].
    now destruct (Walls 3%nat _ eq_refl) as [_ ->]; [|exact Cl|exact As].
Qed.
End Tetrahedron.

(** ** The whole *)

Lemma is_accepted_spec r : is_accepted r = true -> r = Accepted.
Proof. now destruct r. Qed.

Lemma settled_as_some standing m t e st : settled_as standing m t e = true -> standing = Some st ->
  settled_simplex space_predicates m st t e = true.
Proof. intros H E. rewrite E in H. exact H. Qed.

Lemma each_weaker {A} (f g : positive -> A -> result) (l : list A) :
  (forall k a, f k a = Accepted -> g k a = Accepted) ->
  forall k, each f k l = Accepted -> each g k l = Accepted.
Proof.
  intros H. induction l as [|a l IH]; intros k E; cbn [each] in *; [reflexivity|].
  destruct (f k a) eqn:Fa; [|discriminate]. rewrite (H k a Fa). now apply IH.
Qed.

Theorem quick_sound p standing s : quick p standing s = true ->
  check Space (unpacked Space p) = Accepted /\
  forall st, standing = Some st -> settle Space (unpacked Space p) st = Settled.
Proof.
  intros H. cbv delta [quick] in H. cbv beta in H. open_lets H.
  subst places here w points_count c pr m.
  repeat match goal with A : context [all_coordinates _] |- _ => rewrite all_coordinates_are in
    A end.
  assert (Un : negb (weights_of (claimed (frame p))) = true) by assumption.
  apply negb_true_iff in Un.
  assert (St : match standing with None => true | Some _ =>
    delaunay_of (claimed (frame p)) end = true) by assumption.
  assert (Sc : scaled (frame p) = true) by assumption.
  assert (Cp : is_accepted (check_points space_predicates (points (frame p))) = true) by assumption.
  assert (Fit : forallb (fun e => forallb (fits s) (coordinates (position e))) (points (frame p)) =
    true) by assumption.
  assert (Fs : forallb (fits s) (coordinates (sample (frame p))) = true) by assumption.
  assert (Fw : fits zero (sample_denominator (frame p)) = true) by assumption.
  assert (Sw : leb (shifted zero (sample_denominator (frame p))) eight = true) by assumption.
  assert (Ms : leb (simplex_count p) many = true) by assumption.
  assert (Mp : leb (count_of (points (frame p))) many = true) by assumption.
  assert (Ep : is_accepted (each (check_point space_predicates (packed_mesh Space p)) 1
    (points (frame p))) = true) by assumption.
  assert (In_ : inside_sample space_predicates (packed_mesh Space p) = true) by assumption.
  match goal with A : all _ _ = true |- _ => rename A into Al end. rename H into Eh.
  apply is_accepted_spec in Cp, Ep, Eh. apply leb_le' in Ms, Mp, Sw. rewrite many_is in Ms, Mp.
  assert (W : shifted zero (sample_denominator (frame p)) = sample_denominator (frame p))
    by (unfold shifted; rewrite Fw; apply Z.shiftr_0_r).
  assert (Sh : well_shaped 3 (sample (frame p)) /\ 0 < sample_denominator (frame p)).
  { unfold inside_sample in In_. apply andb_prop in In_. destruct In_ as [In_ _].
    apply andb_prop in In_.
    destruct In_ as [I1 I2]. apply Nat.eqb_eq in I1. apply Z.ltb_lt in I2. now split. }
  destruct Sh as [Sh Pw]. unfold well_shaped in Sh.
  assert (Shapes : Forall (fun e => well_shaped 3 (position e)) (points (frame p))).
  { destruct (points (frame p)) as [|e l] eqn:E; [constructor|]. cbn [check_points] in Cp.
    destruct (shaped space_predicates (position e)) eqn:S1; [|discriminate].
    constructor; [now apply Nat.eqb_eq in S1|].
    apply (@increase_spec 3 space_predicates eq_refl) in Cp. destruct Cp as [Cp _].
    eapply Forall_impl; [|exact Cp]. cbn. tauto. }
  destruct (coordinates (sample (frame p))) as [|X0 [|Y0 [|Z0 [|? ?]]]] eqn:Co; try discriminate Sh.
  clear Sh.
  cbn [forallb] in Fs. apply andb_prop in Fs. destruct Fs as [F1 Fs]. apply andb_prop in Fs.
  destruct Fs as [F2 Fs].
  apply andb_prop in Fs. destruct Fs as [F3 _].
  assert (Each : forall t, Zpos t <= simplex_count p ->
    check_simplex space_predicates (packed_mesh Space p) t (entry_of Space (rows_of p) t) = Accepted
      /\
    forall st, standing = Some st -> settled_simplex space_predicates (packed_mesh Space p) st t
      (entry_of Space (rows_of p) t) = true).
  { intros t Ht. unfold all in Al. rewrite forallb_forall in Al.
    specialize (Al t (proj2 (upto_spec _ _) Ht)). cbv beta in Al.
    apply orb_prop in Al. destruct Al as [Q|Q].
    - rewrite W in Q. unfold sample_arrow in Q. rewrite Co in Q. unfold shifted at 2 3 4 in Q.
      rewrite F1, F2, F3 in Q.
      destruct (simplex_here p s standing X0 Y0 Z0 (Build_within_words p s Un Shapes Fit Mp Ms) Co
        (conj F1 (conj F2 F3))
        (conj Pw (Z.le_trans _ _ _ (Z.eq_le_incl _ _ (eq_sym W)) Sw)) t Ht Q) as [Ac Be].
      split; [exact Ac|]. intros st E. apply Be; [now rewrite E in St|exact E].
    - cbv zeta in Q. apply andb_prop in Q. destruct Q as [Q1 Q2]. apply is_accepted_spec in Q1.
      split; [exact Q1|]. intros st E. exact (settled_as_some _ _ _ _ _ Q2 E). }
  assert (Eh' : each (check_hull space_predicates (packed_mesh Space p)) 1 (hull (frame p)) =
    Accepted).
  { revert Eh. apply each_weaker. intros h f E. destruct (quick_hull _ _ _ _ h f) eqn:Q; [|exact E].
    exact (hull_here p s (Build_within_words p s Un Shapes Fit Mp Ms) h f Q). }
  pose proof (packed_mesh_is Space p) as M.
  split.
  - change (check Space (unpacked Space p)) with (check_in space_predicates (unpacked Space p)).
    unfold check_in. rewrite <- M.
    change (scaled (unpacked Space p)) with (scaled (frame p)). rewrite Sc.
    change (points (unpacked Space p)) with (points (frame p)). rewrite Cp, Ep, In_.
    change (hull (unpacked Space p)) with (hull (frame p)). rewrite Eh'.
    change (simplices (unpacked Space p))
      with (map (entry_of Space (rows_of p)) (upto (simplex_count p))).
    rewrite each_upto; [reflexivity|]. intros t Ht. now apply Each.
  - intros st E.
    change (settle Space (unpacked Space p) st)
      with (settle_in space_predicates (unpacked Space p) st). unfold settle_in. rewrite <- M.
    subst standing. change (claimed (unpacked Space p)) with (claimed (frame p)). rewrite St.
    change (simplices (unpacked Space p))
      with (map (entry_of Space (rows_of p)) (upto (simplex_count p))).
    rewrite settled_upto by (intros t Ht; now apply Each).
    change (points (unpacked Space p)) with (points (frame p)).
    assert (G : forall l k, each (check_point space_predicates (packed_mesh Space p)) k l = Accepted
      -> all_settled (settled_point space_predicates (packed_mesh Space p) st) AtPoint k l =
      Settled).
    { induction l as [|e l IH]; intros k E; cbn [each all_settled] in *; [reflexivity|].
      destruct (check_point space_predicates (packed_mesh Space p) k e) eqn:Ck; [|discriminate].
      unfold check_point in Ck.
      destruct (used space_predicates (packed_mesh Space p) k e) eqn:Us; [|discriminate].
      unfold used in Us. unfold settled_point.
      destruct (Table.find (home e) (simplices_of (packed_mesh Space p))); [|discriminate].
      destruct (home_vertex e); [now apply IH|].
      change (weights_claimed (packed_mesh Space p)) with (weights_of (claimed (frame p))) in Us.
      now rewrite Un in Us. }
    now apply G.
Qed.

Theorem judge_holds D p standing s : judge D p standing s = Holds ->
  check D (unpacked D p) = Accepted /\
  forall st, standing = Some st -> settle D (unpacked D p) st = Settled.
Proof.
  unfold judge. intros H.
  destruct (match D with Space => quick p standing s | Plane => false end) eqn:Q.
  - destruct D; [discriminate|]. now apply quick_sound with s.
  - rewrite check_packed_is in H. destruct (check D (unpacked D p)); [|discriminate].
    split; [reflexivity|]. intros st ->.
    rewrite settle_packed_is in H. now destruct (settle D (unpacked D p) st).
Qed.
