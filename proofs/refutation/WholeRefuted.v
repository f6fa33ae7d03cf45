(** * The evidence of a refutation that speaks of the whole domain shows the rule *)
From Coq Require Import Rbase Rfunctions Lra Psatz Lia List Arith ZArith Bool.
From Circumspect Require Import WholeRefutation Numbering.
From Circumspect Require Import Vectors Affine Frame Faces Facets LiftingMap Breach.
From Circumspect Require Import Orientation Integers RefutationSigns CallerMesh EvidenceSound
  RefutationSound.
From Circumspect Require Import Combinations Lists Accepted KeptMesh Necessary ConstrainedLemma
  DomainBroken Dangling Balls DomainRefuted PolygonPoints GivenSound DanglingSeen.
From Circumspect Require Import Definitions Domains DomainRules.
Import ListNotations.
Open Scope R_scope.

Lemma connected_first {d} (W : point d -> Prop) x y z : clear W x y ->
  connected (fun _ => True) W y z ->
  connected (fun _ => True) W x z.
Proof.
  intros Cl C. induction C as [|u z C IH _ Cu].
  - apply further with x; [apply here|exact I|assumption].
  - now apply further with u.
Qed.

Section Shown.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis measured_all : forall r, 0 < r -> measured orient pr r.

(** ** Outside *)

Section Outside.
Variable D : domain_certificate.
Hypothesis about_ok : check_about pr D = Accepted.
Hypothesis known : polygons_known d D.
Notation c := (whole_mesh D).
Notation r := (unit_of c).
Notation P := (domain_of_certificate d D).
Notation connected := (connected (fun _ => True) (walls_of P)).
Let unit_positive := GivenSound.unit_positive D about_ok.
Let M := measured_all r unit_positive.

Lemma leg_free q w a : well_shaped d q -> (0 < w)%Z ->
  clear_leg pr D (given_vertices D) q w (leg_end a) (leg_w a) (leg_planes a) = true ->
  well_shaped d (leg_end a) /\ (0 < leg_w a)%Z /\
  clear (walls_of P) (place_over r q w) (place_over r (leg_end a) (leg_w a)) /\
  forall X, In X (low_cells P) -> ~ X (place_over r q w).
Proof.
  intros Sq Pw Cl. pose proof Cl as Wr. unfold clear_leg in Wr. apply andb_prop in Wr.
  destruct Wr as [Wr _].
  apply (written M) in Wr. destruct Wr as [Se Pe]. split; [assumption|]. split; [assumption|].
  assert (K := leg_clear measured_all D about_ok known q w Sq Pw (leg_end a) (leg_w a)
    (leg_planes a)). split.
  - intros s Hs W. apply walls_are_cells in W. destruct W as (X & IX & Xs).
    exact (K X s Cl (walls_low P X IX) Hs Xs).
  - intros X IX Xq. apply (K X 0 Cl IX); [lra|]. now rewrite between_start.
Qed.
Lemma at_the_end_connected legs : forall q w e v, well_shaped d q -> (0 < w)%Z ->
  at_the_end pr D q w legs = Some (e, v) ->
  well_shaped d e /\ (0 < v)%Z /\ connected (place_over r q w) (place_over r e v) /\
  (legs <> [] -> forall X, In X (low_cells P) -> ~ X (place_over r q w)) /\
    (legs = [] -> q = e /\ w = v).
Proof.
  induction legs as [|a legs IH]; intros q w e v Sq Pw H; cbn [at_the_end] in H.
  - injection H as <- <-. split; [assumption|]. split; [assumption|]. split; [apply here|].
    split; [now intros []|auto].
  - destruct (clear_leg pr D (given_vertices D) q w (leg_end a) (leg_w a) (leg_planes a)) eqn:Cl;
      [|discriminate].
    destruct (leg_free q w a Sq Pw Cl) as (Se & Pe & Cw & Off).
    destruct (IH _ _ e v Se Pe H) as (S1 & P1 & C1 & _ & _).
    split; [assumption|]. split; [assumption|].
    split; [now apply connected_first with (place_over r (leg_end a) (leg_w a))|].
    split; [auto|discriminate].
Qed.

(** Beyond a plane that all vertices are behind one gets as far as one likes. *)
Section BeyondAll.
Variables (n : list Z) (o : Z).
Hypothesis length_n : length n = d.
Hypothesis positive_n : (0 < inner_product n n)%Z.
Hypothesis all_behind : all_off D (given_vertices D) (behind n o) = true.
Notation far := (beyond_plane (d := d) D (n, o)).
Lemma low_behind X y : In X (low_cells P) -> X y -> far y <= 0.
Proof.
  intros IX Xy. destruct (all_off_part measured_all D about_ok known _ X y all_behind IX Xy)
    as (K & B & Sh & C).
  now apply (behind_plane D about_ok (n, o) K).
Qed.
Lemma unbounded_beyond e : 0 < far e -> unbounded (fun _ => True) (walls_of P) e.
Proof.
  intros Fe R. set (N := integer_point d n). set (b := inner e N).
  set (s := Rabs R + 2 * Rabs b + 1).
  assert (NN : 1 <= norm2 N).
  { unfold norm2, N. rewrite (inner_of_integers d n n length_n length_n). apply IZR_le. lia. }
  pose proof (Rabs_pos R) as Rp. pose proof (Rabs_pos b) as Bp.
  assert (Sp : 0 < s) by (unfold s; lra).
  exists (plus e (scale s N)). split.
  - apply further with e; [apply here|exact I|]. intros t Ht W. apply walls_are_cells in W.
    destruct W as (X & IX & Xt).
    pose proof (low_behind X _ (walls_low P X IX) Xt) as B.
    change (between (d := d)) with (mix (d := d)) in B.
    rewrite affine_mix in B by apply beyond_plane_affine.
    assert (E : far (plus e (scale s N)) = far e + s * norm2 N).
    { unfold beyond_plane. cbn [fst snd]. fold N. rewrite inner_plus_r, inner_scale_r. unfold norm2.
      ring. }
    rewrite E in B.
    assert (0 <= t * (s * norm2 N)) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]). lra.
  - assert (E : norm2 (plus e (scale s N)) = norm2 e + 2 * s * b + s * s * norm2 N).
    { unfold norm2, b. repeat rewrite ?inner_plus, ?inner_plus_r, ?inner_scale, ?inner_scale_r.
      rewrite (inner_comm N e). ring. }
    rewrite E. pose proof (norm2_nonneg e) as Ne.
    assert (- Rabs b <= b) by (unfold Rabs; destruct (Rcase_abs b); lra).
    assert (R <= Rabs R) by apply Rle_abs.
    assert (K1 : s * s <= s * s * norm2 N) by nra.
    assert (K2 : s * (s - 2 * Rabs b) <= s * s + 2 * s * b) by nra.
    assert (K3 : Rabs R + 1 <= s * (s - 2 * Rabs b)) by (unfold s; nra). lra.
Qed.
End BeyondAll.

Lemma connected_back x y z : connected x y -> connected y z -> connected x z.
Proof. intros A B. induction B as [|u z B IH _ C]; [assumption|now apply further with u]. Qed.
Theorem is_outside_sound q w legs out : well_shaped d q -> (0 < w)%Z ->
  is_outside pr D q w legs out = true ->
  ~ underlying P (place_over r q w).
Proof.
  intros Sq Pw H (X & IX & Xq). apply low_or_region in IX. unfold is_outside in H.
  destruct out as [k|n o].
  - destruct legs as [|a legs]; [discriminate|].
    destruct (at_the_end pr D q w (a :: legs)) as [(e, v)|] eqn:E; [|discriminate].
    destruct (at_the_end_connected (a :: legs) q w e v Sq Pw E) as (Se & Pv & Co & Off & Same).
    specialize (Off ltac:(discriminate)).
    apply andb_prop in H. destruct H as [K H]. destruct IX as [IX| ->]; [exact (Off X IX Xq)|].
    destruct (kind D) eqn:Kd; [|discriminate]. rewrite find_id in H.
    destruct (numbered (holes (domain_part D)) k) as [x|] eqn:Ex; [|discriminate].
    apply numbered_in in Ex.
    destruct (GivenSound.about_parts D about_ok) as (_ & _ & _ & _ & Ho & _). specialize (Ho x Ex).
    unfold check_hole_point in Ho. accepted. apply andb_prop in Heqb. destruct Heqb as [Sx Px].
    unfold shaped in Sx. apply Nat.eqb_eq in Sx. rewrite (dimension_d M) in Sx.
    apply Z.ltb_lt in Px.
    unfold region in Xq. cbn [domain_of_certificate what_it_fills] in Xq. rewrite Kd in Xq.
    destruct Xq as [_ [W|[_ Nh]]].
    + apply walls_are_cells in W. destruct W as (Y & IY & Yq). exact (Off Y (walls_low P Y IY) Yq).
    + apply (Nh (seed_point d c (hole_point x) (hole_w x))).
      * cbn [domain_of_certificate domain_holes]. unfold part_holes.
        apply (in_map (fun h => seed_point d c (hole_point h) (hole_w h))). assumption.
      * replace (seed_point d c (hole_point x) (hole_w x)) with (place_over (d := d) r e v);
          [assumption|].
        unfold same_place in H. apply same_numbers_eq in H. unfold seed_point.
        destruct (times_place d (r / IZR v) (hole_w x) e Px Se) as [_ T1].
        destruct (times_place d (r / IZR (hole_w x)) v (hole_point x) Pv Sx) as [_ T2].
        unfold place_over. rewrite <- T1, <- T2. unfold place_of. rewrite H. f_equal.
        apply IZR_lt in Px, Pv. field. lra.
  - destruct (at_the_end pr D q w legs) as [(e, v)|] eqn:E; [|discriminate].
    destruct (at_the_end_connected legs q w e v Sq Pw E) as (Se & Pv & Co & Off & Same).
    assert (H' : (kind D = Hull -> legs = []) /\ length n = d /\ (0 < inner_product n n)%Z /\
      (v * o < inner_product n (coordinates e))%Z /\
        all_off D (given_vertices D) (behind n o) = true).
    { destruct legs as [|a legs]; rewrite !andb_true_iff in H; destruct H as [[[[K L] Pn] B] Al];
        apply Nat.eqb_eq in L; rewrite (dimension_d M) in L; apply Z.ltb_lt in Pn, B; repeat split;
          try assumption; try easy.
      intros Kd. rewrite Kd in K. discriminate. }
    clear H. destruct H' as (Hl & Ln & Pn & B & Al).
    pose proof (beyond_plane_positive D about_ok (n, o) e v Ln Se Pv B) as Fe.
    assert (Start : forall Y, In Y (low_cells P) -> ~ Y (place_over r q w)).
    { destruct legs as [|a legs]; [|apply Off; discriminate]. destruct (Same eq_refl) as [-> ->].
      intros Y IY Yq. pose proof (low_behind n o Ln Al Y _ IY Yq). lra. }
    destruct IX as [IX| ->]; [exact (Start X IX Xq)|].
    unfold region in Xq. cbn [domain_of_certificate what_it_fills] in Xq. destruct (kind D) eqn:Kd.
    + destruct Xq as [_ [W|[Nu _]]].
      * apply walls_are_cells in W. destruct W as (Y & IY & Yq).
        exact (Start Y (walls_low P Y IY) Yq).
      * apply Nu. intros R.
        destruct (unbounded_beyond n o Ln Pn Al (place_over r e v) Fe R) as (y & Cy & Ny).
        exists y. split; [now apply connected_back with (place_over r e v)|assumption].
    + rewrite (Hl eq_refl) in *. destruct (Same eq_refl) as [-> ->].
      enough (0 <= - beyond_plane (d := d) D (n, o) (place_over r e v)) by lra.
      apply (affine_conv (fun y => - beyond_plane (d := d) D (n, o) y) (domain_vertices P));
        [apply affine_opp, beyond_plane_affine| |exact Xq].
      intros y Iy. enough (beyond_plane (d := d) D (n, o) y <= 0) by lra.
      apply (low_behind n o Ln Al (fun q => q = y)); [|reflexivity].
      unfold low_cells. apply in_or_app. left. now apply (in_map (fun v q => q = v)).
Qed.
(** What is enclosed goes on to the end of a leg. *)
Lemma underlying_along q w a : kind D = Enclosed -> well_shaped d q -> (0 < w)%Z ->
  clear_leg pr D (given_vertices D) q w (leg_end a) (leg_w a) (leg_planes a) = true ->
  underlying P (place_over r q w) -> underlying P (place_over r (leg_end a) (leg_w a)).
Proof.
  intros K Sq Pw Cl (X & IX & Xq). destruct (leg_free q w a Sq Pw Cl) as (_ & _ & Cw & Off).
  apply low_or_region in IX. destruct IX as [IX| ->]; [exfalso; exact (Off X IX Xq)|].
  exists (region P). split; [apply low_or_region; now right|]. unfold region in *.
  cbn [domain_of_certificate what_it_fills] in *. rewrite K in *.
  now apply (enclosed_along _ _ (place_over r q w)).
Qed.
End Outside.

(** ** Of all that is listed *)

Section Listed.
Variable m : refutation.
Notation r := (refuted_unit m).
Hypothesis unit_positive : 0 < r.
Hypothesis delaunay : refuted m = Delaunay.
Hypothesis shaped_sites : forallb (shaped pr) (sites m) = true.
Notation PS := (map (site_for Delaunay) (sites m)).
Notation S := (site_table m).
Let M := measured_all r unit_positive.
Lemma own_shaped : Forall (well_shaped d) PS.
Proof.
  pose proof (RefutationSound.sites_shaped measured_all m unit_positive shaped_sites) as H.
  now rewrite delaunay in H.
Qed.
Lemma own_sites k : Table.find k S = numbered PS k.
Proof. pose proof (RefutationSound.sites_found m k) as H. now rewrite delaunay in H. Qed.
Lemma listed_frame y s X : map (@caller_entry d r (sites m)) y = map Some s ->
  proper_simplex_of pr S y = Some X ->
  s = map (place_of r) X /\ exists g, RefutationSigns.framed orient pr r X g.
Proof.
  intros E Px. apply (proper_simplex_of_frame M PS (rows m) S _ own_shaped own_sites (rows_found m))
    in Px.
  destruct Px as (Vx & g & G). pose proof (vertices_rows _ y X Vx) as Er.
  rewrite (map_ext _ _ (entry_site_for m (sites m))), E in Er. apply map_some_inj in Er.
  split; [assumption|now exists g].
Qed.

Lemma missed q w : forallb (misses pr S q w) (rows m) = true -> well_shaped d q -> (0 < w)%Z ->
  forall s, listed (@caller_rows d r (sites m) (rows m)) s -> ~ conv s (place_over r q w).
Proof.
  intros Al Sq Pw s Ls C. apply in_map_iff in Ls. destruct Ls as (y & E & Iy).
  rewrite forallb_forall in Al. specialize (Al y Iy). unfold misses in Al.
  destruct (proper_simplex_of pr S y) as [X|] eqn:Px; [|discriminate].
  destruct (listed_frame y s X E Px) as (-> & g & G).
  rewrite <- (framed_vertices X g G) in C. rewrite (conv_in_simplex M X g G q w Sq Pw C) in Al.
  discriminate.
Qed.
Lemma left_by_all y X : forallb (leaves pr S y) (rows m) = true -> well_shaped d (cell_site y) ->
  (0 < cell_w y)%Z ->
  (forall v, well_shaped d v -> beside y v = true -> ~ X (place_of r v)) ->
  forall s g, listed (@caller_rows d r (sites m) (rows m)) s -> incl g s ->
    conv g (place_over r (cell_site y) (cell_w y)) ->
  ~ within (conv g) X.
Proof.
  intros H Sq Pw Off s g Ls Ig Cg Wi. apply in_map_iff in Ls. destruct Ls as (z & E & Iz).
  rewrite forallb_forall in H. specialize (H z Iz). unfold leaves in H.
  destruct (proper_simplex_of pr S z) as [Y|] eqn:Px; [|discriminate].
  destruct (listed_frame z s Y E Px) as (-> & a & FX).
  rewrite <- (framed_vertices Y a FX) in Ig. pose proof Cg as Ca. apply (conv_face a g _ Ig) in Ca.
  destruct Ca as [Ia Car].
  apply orb_true_iff in H. destruct H as [N|H].
  - rewrite (conv_in_simplex M Y a FX _ _ Sq Pw) in N; [discriminate|]. now apply conv_vertices.
  - apply existsb_exists in H. destruct H as (v & Iv & B).
    assert (Sv : well_shaped d v).
    { apply carrier_of_incl in Iv. pose proof (framed_shaped Y a FX) as Sx.
      rewrite Forall_forall in Sx. now apply Sx. }
    apply (Off v Sv B), Wi, conv_point.
    assert (Cv : In (place_of r v) (Faces.carrier a (place_over r (cell_site y) (cell_w y)))).
    { apply (carrier_of_carrier M Y a FX _ _ Sq Pw). now apply in_map. }
    apply in_carrier in Cv. destruct Cv as (n & Hn & Pn & Ev). pose proof (Car n Hn Pn) as Ic.
    rewrite <- Ev in Ic. exact Ic.
Qed.
End Listed.

(** ** The evidence shows the rule *)

Variable x : whole_refutation.
Notation m := (mesh_against x).
Notation dangles := (dangling_against x).
Notation D := (about_domain x).
Notation c := (whole_mesh D).
Notation P := (domain_of_certificate d D).
Hypothesis polygons_of_space : forall D, check_about pr D = Accepted -> polygons_known d D.

Theorem shown_whole_rule : refute_whole_in pr x = true ->
  broken_of_domain P (@caller_rows d (refuted_unit m) (sites m) (rows m))
    (@caller_rows d (refuted_unit m) (sites m) (map fst (dangling dangles))) (whole_rule_of x) /\
      proper_domain P.
Proof.
  intros H. unfold refute_whole_in in H. cbv zeta in H. rewrite !andb_true_iff in H.
  destruct H as [[[[[Rf Un] Ud] Ab] Shp] H].
  assert (R : refuted m = Delaunay) by (destruct (refuted m); try discriminate; reflexivity).
  assert (A : check_about pr D = Accepted) by (destruct (check_about pr D);
    [reflexivity|discriminate]). clear Ab Rf.
  pose proof (polygons_of_space D A) as known.
  split; [|exact (given_proper measured_all D A known)].
  apply Z.eqb_eq in Un, Ud.
  assert (Eu : refuted_unit m = unit_of c) by (unfold refuted_unit, unit_of; now rewrite Un, Ud).
  pose proof (GivenSound.unit_positive D A) as Pr. pose proof (measured_all _ Pr) as M.
  assert (Prm : 0 < refuted_unit m) by (now rewrite Eu).
  assert (Sh : forallb (shaped pr) (sites m) = true).
  { rewrite padded_sites, forallb_app in Shp. now apply andb_prop in Shp. }
  assert (MissedBy : forall q w, all_of m dangles (fun S => misses pr S q w) = true ->
    well_shaped d q -> (0 < w)%Z ->
    forall s, listed (@caller_rows d (refuted_unit m) (sites m) (rows m) ++
      @caller_rows d (refuted_unit m) (sites m) (map fst (dangling dangles))) s ->
        ~ conv s (place_over (unit_of c) q w)).
  { intros q w Al Sq Pw. unfold all_of in Al. apply andb_prop in Al. destruct Al as [K Al].
    rewrite <- Eu.
    apply (in_none_of_fuller _ _ (fuller m dangles K)). now apply (missed (padded m dangles)). }
  assert (InOwn : forall t q w, in_simplex_of_all pr m dangles t q w = true -> well_shaped d q ->
    (0 < w)%Z ->
    exists s, listed (@caller_rows d (refuted_unit m) (sites m) (rows m) ++
      @caller_rows d (refuted_unit m) (sites m) (map fst (dangling dangles))) s /\
        conv s (place_over (unit_of c) q w)).
  { intros t q w I Sq Pw. unfold in_simplex_of_all in I.
    apply (own_found measured_all m dangles Prm R Shp) in I.
    destruct I as (X & g & n & G & LX & I). exists (map (place_of (refuted_unit m)) (firstn n X)).
    split; [assumption|].
    rewrite <- Eu. now apply (in_own_conv measured_all m Prm X g). }
  assert (Tiled : forall y X, all_of m dangles (fun S => leaves pr S y) = true ->
    well_shaped d (cell_site y) -> (0 < cell_w y)%Z ->
    (forall v, well_shaped d v -> beside y v = true -> ~ X (place_of (unit_of c) v)) ->
    forall s g, listed (@caller_rows d (refuted_unit m) (sites m) (rows m) ++
      @caller_rows d (refuted_unit m) (sites m) (map fst (dangling dangles))) s -> incl g s ->
    conv g (place_over (unit_of c) (cell_site y) (cell_w y)) -> ~ within (conv g) X).
  { intros y X Al Sq Pw Off s g Ls Ig. unfold all_of in Al. apply andb_prop in Al.
    destruct Al as [K Al].
    destruct (fuller m dangles K s Ls) as (t & Lt & St). rewrite <- Eu in *.
    apply (left_by_all (padded m dangles) Prm R Shp y X Al Sq Pw Off t g Lt).
    now apply incl_tran with s. }
  pose proof (rows_site_for (d := d) m) as Rows.
  pose proof (RefutationSound.sites_shaped measured_all m) as ShS.
  pose proof (RefutationSound.sites_found m) as Fs. rewrite Eu in *. specialize (ShS Pr Sh).
  rewrite R in Rows, ShS, Fs.
  pose proof (RefutationSound.rows_found m) as Fr.
  set (S := Table.of_list (site_for Delaunay) (sites m)) in *.
  set (PS := map (site_for Delaunay) (sites m)) in *. set (r := unit_of c) in *.
  assert (He : heights_of r (norm2 (d := d)) PS).
  { intros p Ip. unfold PS in Ip. apply in_map_iff in Ip. destruct Ip as (y & <- & _).
    unfold height_of, site_for.
    cbn [weights_of weight]. ring. }
  assert (Shaped : forall p, In p PS -> well_shaped d p) by (apply Forall_forall; assumption).
  unfold whole_rule_of.
  destruct (shown_by x) as [t i u j q w|t v q w planes|k u q w|z|t q w legs out|t q w a|e|t q w|u v
    own z k q w bends last planes] eqn:Be;
    cbn [broken_of_domain]; cbn [whole_holds] in H.
  - rewrite <- Rows. unfold site_table in H. fold S in H. rewrite !andb_true_iff in H.
    destruct H as [[[[_ Wr] _] H] Off]. apply (written M) in Wr. destruct Wr as [Sq Pw].
    apply (proper_at_in M PS (rows m) S _ ShS Fs Fr) in H. destruct H as (X & a & FX & IX & LX & H).
    rewrite !andb_true_iff in H. destruct H as [[Hi In_] H].
    apply (proper_at_in M PS (rows m) S _ ShS Fs Fr) in H. destruct H as (Y & b & FY & IY & LY & H).
    apply Nat.ltb_lt in Hi. rewrite (dimension_d M) in Hi. assert (Hi' : (i <= d)%nat) by lia.
    destruct (not_local_found M PS (rows m) S _ ShS Fs Fr norm2 He X Y a b i j FX FY IX IY LX LY H)
      as (y & v & Lx & Ly & Nf & Lf & Fx & Fy & Iy & Iv & O & B).
    exists (map (place_of r) X), (map (place_of r) Y), (map (place_of r) (Checker.remove i X)), y,
      v.
    do 9 (split; [assumption|]). split; [now apply below_in_balls|].
    pose proof (inside_facet_in M X a FX q w i Sq Pw Hi' In_) as Fq.
    intros X0 IX0 W. apply (off_walls_off measured_all D A known q w Sq Pw Off X0 IX0), W.
    apply (conv_incl (facet_of a i)).
    + intros p Ip. apply in_facet_of in Ip; [|assumption]. destruct Ip as (k & Hk & Nk & ->).
      destruct (nth_error X k) as [p|] eqn:Ep.
      * destruct (framed_vertex X a FX k p Ep) as [_ ->]. apply in_map, Lists.in_remove. eauto.
      * apply nth_error_None in Ep. rewrite (framed_length X a FX) in Ep. lia.
    + apply conv_facet; [assumption|apply Fq|now apply in_facet_closed with i].
  - rewrite <- Rows. unfold site_table in H. fold S in H. rewrite !andb_true_iff in H.
    destruct H as [[[_ Wr] _] H]. apply (written M) in Wr. destruct Wr as [Sq Pw].
    apply (proper_at_in M PS (rows m) S _ ShS Fs Fr) in H. destruct H as (X & a & FX & IX & LX & H).
    apply andb_prop in H. destruct H as [In_ H].
    apply (point_at_in M PS (rows m) S _ ShS Fs Fr) in H. destruct H as (p & Ip & H).
    rewrite !andb_true_iff in H. destruct H as [[Bl Li] Se].
    exists (map (place_of r) X), (place_of r p), (place_over r q w).
    split; [|split; [|split; [|split]]].
    + split; [assumption|]. rewrite <- (framed_vertices X a FX).
      split; [apply vertices_length|apply vertices_independent].
    + apply existsb_exists in Li. destruct Li as (y & Iy & Li).
      exists (map (@caller_entry d r PS) y). split; [now apply in_map|].
      apply existsb_exists in Li. destruct Li as (n & In_n & Hn).
      destruct (named S n) as [p'|] eqn:Ep; [|discriminate].
      assert (Ip' : In p' PS) by now apply (named_in M PS (rows m) S _ ShS Fs Fr n).
      apply (same_place_place M) in Hn; [|now apply Shaped..]. apply in_map_iff. exists n.
      split; [|assumption].
      rewrite (caller_named M PS (rows m) S _ ShS Fs Fr), Ep. cbn [option_map]. now f_equal.
    + now apply (strictly_in_simplex_inside M X a FX).
    + intros X0 e IX0 Hs.
      now apply (way_free measured_all D A known q w Sq Pw p planes X0 e (Shaped p Ip) Se).
    + rewrite <- (framed_vertices X a FX). apply below_in_balls, below_all_planes.
      apply (below_witness M X a FX); [|now apply Shaped|assumption].
      intros y [<-|Iy]; apply He; auto.
  - destruct (given_point pr D (InPiece k u q w)) as [y|] eqn:Ey; [|discriminate].
    destruct (cell_point_spec measured_all D A known _ y Ey) as (Sq & Pw & X & [_ IX] & Xq & Off).
    apply in_map_iff in IX. destruct IX as (f & <- & If).
    exists f, (place_over r (cell_site y) (cell_w y)).
    split; [assumption|]. split; [assumption|]. now apply Tiled.
  - destruct (given_point pr D z) as [y|] eqn:Ey; [|discriminate].
    destruct (cell_point_spec measured_all D A known _ y Ey) as (Sq & Pw & X & [IX _] & Xq & _).
    exists (place_over r (cell_site y) (cell_w y)). split; [exists X; auto|]. now apply MissedBy.
  - rewrite !andb_true_iff in H. destruct H as [[Wr H] Out]. apply (written M) in Wr.
    destruct Wr as [Sq Pw].
    destruct (InOwn t q w H Sq Pw) as (s & Ls & Cs). exists s, (place_over r q w).
    split; [assumption|]. split; [assumption|].
    now apply (is_outside_sound D A known q w legs out).
  - rewrite !andb_true_iff in H. destruct H as [[[[K Wr] H] Cl] Al]. apply (written M) in Wr.
    destruct Wr as [Sq Pw].
    destruct (kind D) eqn:Kd; [|discriminate].
    destruct (leg_free D A known q w a Sq Pw Cl) as (Se & Pe & _).
    destruct (InOwn t q w H Sq Pw) as (s & Ls & Cs).
    intros [NU NO]. apply NO. exists s, (place_over r q w). split; [assumption|].
    split; [assumption|]. intros U. apply NU.
    exists (place_over r (leg_end a) (leg_w a)). split; [|now apply MissedBy].
    now apply (underlying_along D A known q w a Kd).
  - rewrite !andb_true_iff in H. destruct H as [[[_ _] Li] H]. rewrite <- Rows.
    unfold site_table in H. fold S in H.
    destruct e; try discriminate; cbn [holds] in H.
    + assert (Pm : 0 < refuted_unit m) by (rewrite Eu; exact Pr).
      destruct (listed_entry measured_all m p R Li Pm Sh) as (y & Ey & Iy). rewrite Eu in Iy.
      apply (proper_at_in M PS (rows m) S _ ShS Fs Fr) in H.
      destruct H as (X & a & FX & IX & LX & H).
      unfold point_at in H. rewrite Fs in H. unfold numbered in H, Ey. unfold PS in H.
      rewrite nth_error_map, Ey in H.
      cbn [option_map] in H. apply andb_prop in H. destruct H as [Bo Be'].
      assert (Ip : In (site_for Delaunay y) PS) by (apply in_map; now apply nth_error_In in Ey).
      apply (boundary_breach M PS (rows m) S _ ShS Fs Fr X a i FX IX LX) in Bo.
      destruct Bo as [_ Bo].
      apply (beyond_opposite M PS (rows m) S _ ShS Fs Fr X a i _ FX Ip) in Be'.
      destruct Be' as (v & Hv & _ & O).
      exists (map (place_of r) X), (map (place_of r) (Checker.remove i X)), v,
        (place_of r (site_for Delaunay y)).
      split; [assumption|]. split; [assumption|]. split; [|assumption].
      unfold entries. rewrite flat_map_app. apply in_or_app. left. rewrite Rows. exact Iy.
    + apply (proper_at_in M PS (rows m) S _ ShS Fs Fr) in H.
      destruct H as (X & a & FX & IX & LX & H).
      apply (proper_at_in M PS (rows m) S _ ShS Fs Fr) in H.
      destruct H as (Y & b & FY & IY & LY & H).
      apply (proper_at_in M PS (rows m) S _ ShS Fs Fr) in H.
      destruct H as (Z & g & FZ & IZ & LZ & H).
      exact (closed_breach M PS (rows m) S _ ShS Fs Fr X Y Z a b g i j k FX FY FZ IX IY IZ LX LY LZ
        H).
  - discriminate.
  - rewrite !andb_true_iff in H. destruct H as [[[_ Wr] Li] H]. apply (written M) in Wr.
    destruct Wr as [Sq Pw].
    assert (Pm : 0 < refuted_unit m) by (rewrite Eu; exact Pr).
    assert (Sh' : forallb (shaped pr) (sites (as_listed m dangles)) = true) by exact Sh.
    destruct (listed_entry measured_all (as_listed m dangles) v R Li Pm Sh') as (y & Ey & Iy).
    change (refuted_unit (as_listed m dangles)) with (refuted_unit m) in Iy.
    rewrite (listed_rows (d := d) m dangles) in Iy.
    unfold site_table in H. fold S in H. unfold point_at in H. rewrite Fs in H.
    unfold numbered in H, Ey. unfold PS in H.
    cbn [as_listed with_rows sites] in Ey. rewrite nth_error_map, Ey in H. cbn [option_map] in H.
    apply andb_prop in H. destruct H as [Tr Se].
    assert (Sp : well_shaped d (site_for Delaunay y)) by (apply Shaped; unfold PS; apply in_map;
      now apply nth_error_In in Ey).
    destruct (triangle_shown measured_all m dangles Pm R Shp u own z _ q w Sp Sq Pw Tr)
      as (s & Ls & Len & Ind & Alone & In_ & B).
    destruct (seen_in_polygon_spec measured_all D A known k _ q w bends last planes
      polygons_of_space Sp Sq Pw Se) as (f & If & Way & Oth).
    rewrite Eu in *. exists s, (place_of r (site_for Delaunay y)), (place_over r q w), f.
    do 4 (split; [assumption|]). split; [exact Iy|]. do 4 (split; [assumption|]). exact B.
Qed.
End Shown.
