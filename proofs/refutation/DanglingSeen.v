(** * A triangle that dangles and is not constrained Delaunay, as the checker finds it

    A vertex that is in all its circumballs ([Balls.v]) is seen from a point inside: the way there
    stays in a polygon, and is parted from all other cells, as those of the domain without this
    polygon. *)
From Coq Require Import Rbase Rfunctions Lra Psatz Lia List Arith ZArith Bool.
From Circumspect Require Import WholeRefutation Numbering.
From Circumspect Require Import Vectors Affine Frame Faces LiftingMap Breach.
From Circumspect Require Import Orientation Integers RefutationSigns CallerMesh EvidenceSound
  RefutationSound.
From Circumspect Require Import Combinations Lists Accepted KeptMesh Necessary ConstrainedLemma
  DomainBroken Dangling Balls DomainRefuted PolygonPoints GivenSound.
From Circumspect Require Import Definitions Domains DomainRules.
Import ListNotations.
Open Scope R_scope.

(** One of a list, or one of the others. *)
Lemma one_or_other {A} (l : list A) : forall n a b, nth_error l n = Some a -> In b l ->
  b = a \/ In b (firstn n l ++ skipn (Datatypes.S n) l).
Proof.
  induction l as [|c l IH]; intros n a b E I; [destruct I|].
  destruct n as [|n]; cbn [nth_error] in E.
  - injection E as ->. destruct I as [->|I]; [now left|right; exact I].
  - destruct I as [->|I]; [right; now left|].
    destruct (IH n a b E I) as [H|H]; [now left|right; now right].
Qed.

Section Seen.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis measured_all : forall r, 0 < r -> measured orient pr r.
Variable D : domain_certificate.
Hypothesis about_ok : check_about pr D = Accepted.
Hypothesis known : polygons_known d D.
Notation c := (whole_mesh D).
Notation r := (unit_of c).
Notation P := (domain_of_certificate d D).
Let unit_positive := GivenSound.unit_positive D about_ok.
Let Mr := measured_all r unit_positive.

Lemma is_in_piece_spec f u q w : is_in_piece pr (in_tables f) u q w = true ->
  exists Y, well_shaped d q /\ (0 < w)%Z /\
  piece_of (Table.of_list Datatypes.id (simplices (plane_mesh f)))
    (Table.of_list position (points (plane_mesh f))) u = Some Y /\
  kept_at (Table.of_list Datatypes.id (marks (plane_part f))) u = true /\ in_plane f q w = true /\
  proper plane_predicates Y = true /\ in_simplex plane_predicates Y (seen f q) w = true.
Proof.
  unfold is_in_piece, in_tables. intros H.
  destruct (piece_of _ _ u) as [Y|] eqn:Pi; [|discriminate].
  rewrite !andb_true_iff in H. destruct H as [[[[Wr K] Ip] Pr] In_]. apply (written Mr) in Wr.
  destruct Wr as [Sq Pw].
  exists Y. auto 8.
Qed.
Lemma piece_between f u q w q' w' s : In f (polygons D) ->
  is_in_piece pr (in_tables f) u q w = true ->
  is_in_piece pr (in_tables f) u q' w' = true -> 0 <= s <= 1 ->
  polygon_points (polygon_of d D f) (between (place_over r q w) (place_over r q' w') s).
Proof.
  intros If H H' Hs. apply is_in_piece_spec in H, H'.
  destruct H as (Y & Sq & Pw & Pi & K & Ip & Pr & In_).
  destruct H' as (Y' & Sq' & Pw' & Pi' & _ & Ip' & _ & In'). rewrite Pi in Pi'. injection Pi' as <-.
  now apply (known_between d D known f u Y q w q' w' s).
Qed.
Lemma over_over q w w' : well_shaped d q -> (0 < w)%Z -> (0 < w')%Z ->
  well_shaped d (times w' q) /\ @place_of d (r / IZR (w * w')) (times w' q) = place_over r q w.
Proof.
  intros Sq Pw Pw'. destruct (times_place d (r / IZR w) w' q Pw' Sq) as [S E]. split; [assumption|].
  unfold place_over. rewrite <- E. f_equal. apply IZR_lt in Pw, Pw'. rewrite mult_IZR. field. lra.
Qed.
Lemma stays_in f v last : In f (polygons D) -> well_shaped d v -> forall bends q w,
  stays pr (in_tables f) v q w bends last = true -> forall s, 0 <= s <= 1 ->
  polygon_points (polygon_of d D f) (between (place_over r q w) (place_of r v) s).
Proof.
  intros If Sv. induction bends as [|(u, (q', w')) rest IH]; intros q w H s Hs; cbn [stays] in H.
  - apply andb_prop in H. destruct H as [H H']. rewrite <- (place_over_one (r := r)).
    now apply (piece_between f last).
  - rewrite !andb_true_iff in H. destruct H as [[[H H'] On] Rest].
    destruct (is_in_piece_spec f u q w H) as (_ & Sq & Pw & _).
    destruct (is_in_piece_spec f u q' w' H') as (_ & Sq' & Pw' & _).
    destruct (over_over q w w' Sq Pw Pw') as [S1 E1].
    destruct (over_over q' w' w Sq' Pw' Pw) as [S2 E2].
    assert (Pww : (0 < w * w')%Z) by lia. destruct (times_place d r (w * w') v Pww Sv) as [S3 E3].
    destruct (on_segment_between d (r / IZR (w * w')) _ _ _ S1 S3 S2 On) as [Ht Eq].
    rewrite (Z.mul_comm w' w) in E2. rewrite E1, E2, E3 in Eq. set (t := ratio _ _ _) in *.
    clearbody t.
    specialize (IH q' w' Rest). set (a := place_over r q w) in *. set (b := place_of r v) in *.
    set (e := place_over r q' w') in *.
    destruct (Rle_dec s t) as [L|N].
    + assert (C : conv [between a b 0; between a b t] (between a b s)) by (apply conv_part; lra).
      rewrite between_start, <- Eq in C. apply conv_two in C. destruct C as (s' & Hs' & ->).
      now apply (piece_between f u).
    + assert (C : conv [between a b t; between a b 1] (between a b s)) by (apply conv_part; lra).
      rewrite between_end, <- Eq in C. apply conv_two in C. destruct C as (s' & Hs' & ->).
      now apply IH.
Qed.

Lemma seen_in_polygon_spec k p q w bends last planes :
  (forall D', check_about pr D' = Accepted -> polygons_known d D') -> well_shaped d p ->
    well_shaped d q -> (0 < w)%Z ->
  seen_in_polygon pr D k p q w bends last planes = true -> exists f, In f (domain_polygons P) /\
  (forall e, 0 <= e <= 1 -> polygon_points f (between (place_over r q w) (place_of r p) e)) /\
  forall X e, In X (low_cells P) -> 0 <= e < 1 -> X (between (place_over r q w) (place_of r p) e) ->
    X = polygon_points f.
Proof.
  intros Known Sp Sq Pw H. unfold seen_in_polygon in H. rewrite find_id in H.
  destruct (numbered (given_polygons D) k) as [y|] eqn:E; [|discriminate].
  unfold given_polygons, numbered in E.
  rewrite nth_error_map in E. destruct (nth_error (polygons D) _) as [f|] eqn:Ef; [|discriminate].
  injection E as <-.
  rewrite !andb_true_iff in H. destruct H as [[St Ch] Se]. set (D' := without_polygon D k) in *.
  assert (A : check_about pr D' = Accepted) by (destruct (check_about pr D');
    [reflexivity|discriminate]). clear Ch.
  pose proof (nth_error_In _ _ Ef) as If. exists (polygon_of d D f).
  split; [now apply (in_map (polygon_of d D))|].
  split; [now apply (stays_in f p last If Sp bends)|].
  intros X e IX He Xe.
  assert (K : In X (low_cells (domain_of_certificate d D')) \/
    X = polygon_points (polygon_of d D f)).
  { unfold low_cells in *. apply in_app_or in IX.
    destruct IX as [IX|IX]; [left; apply in_or_app; now left|].
    apply in_app_or in IX.
    destruct IX as [IX|IX]; [left; apply in_or_app; right; apply in_or_app; now left|].
    apply in_map_iff in IX. destruct IX as (z & <- & Iz). apply in_map_iff in Iz.
    destruct Iz as (g & <- & Ig).
    destruct (one_or_other _ _ f g Ef Ig) as [->|I]; [now right|]. left. apply in_or_app. right.
    apply in_or_app. right.
    apply in_map. apply (in_map (polygon_of d D') _ g). unfold D', without_polygon, other_polygons.
    cbn [polygons].
    replace (Pos.to_nat k) with (Datatypes.S (pred (Pos.to_nat k))) at 2
      by (pose proof (Pos2Nat.is_pos k); lia). exact I. }
  destruct K as [IX'|E]; [exfalso|exact E].
  exact (way_free measured_all D' A (Known D' A) q w Sq Pw p planes X e Sp Se IX' He Xe).
Qed.
End Seen.

Section Shown.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis measured_all : forall r, 0 < r -> measured orient pr r.
Variables (m : refutation) (x : dangling_part).
Notation r := (refuted_unit m).
Hypothesis unit_positive : 0 < r.
Hypothesis delaunay : refuted m = Delaunay.
Hypothesis shaped_sites : forallb (shaped pr) (sites (padded m x)) = true.
Notation L := (@caller_rows d r (sites m) (rows m)).
Notation U := (@caller_rows d r (sites m) (map fst (dangling x))).
Let Mr := measured_all r unit_positive.

(** A triangle that dangles, a point inside it, and a vertex in all its circumballs. *)
Lemma triangle_shown u own z p q w : well_shaped d p -> well_shaped d q -> (0 < w)%Z ->
  own_simplex_at m x pr u (fun X n => in_dangling_triangle pr m x X n q w &&
    no_ball pr (combine own (firstn n X)) [(z, p)]) = true ->
  exists s, listed U s /\ length s = 3%nat /\ affinely_independent s /\
    (forall t, listed (L ++ U) t -> length t = S d -> ~ incl s t) /\
    strictly_inside s (place_over r q w) /\ forall o r2, circumball s o r2 ->
      dist2 o (place_of r p) < r2.
Proof.
  intros Sp Sq Pw H. apply (own_found_known measured_all m x unit_positive delaunay shaped_sites) in
    H.
  destruct H as (X & g & n & G & LX & H & IX). apply andb_prop in H. destruct H as [H B].
  unfold in_dangling_triangle in H. rewrite !andb_true_iff in H.
  destruct H as [[[[[N Len] In_] Po] Al] Short]. apply Nat.eqb_eq in N, Len. subst n.
  pose proof (in_no_row_alone measured_all m x unit_positive delaunay shaped_sites X 3 IX Al)
    as Alone.
  set (s := map (@place_of d r) (firstn 3 X)) in *. exists s.
  assert (Ls : listed U s).
  { unfold listed in *. apply in_app_or in LX. destruct LX as [LX|LX]; [|assumption].
    destruct (Alone _ LX). apply incl_refl. }
  pose proof (framed_shaped X g G) as SX. rewrite Forall_forall in SX.
  split; [assumption|]. split; [unfold s; now rewrite map_length|].
  split; [now apply (own_independent (orient := orient) (pr := pr) _ X g 3)|].
  split.
  { intros t Lt Full. unfold listed in Lt. apply in_app_or in Lt.
    destruct Lt as [Lt|Lt]; [now apply Alone|exfalso].
    apply in_map_iff in Lt. destruct Lt as (a & Ea & Ia). apply in_map_iff in Ia.
    destruct Ia as (ab & <- & Ia).
    unfold shorter_rows in Short. rewrite forallb_forall in Short. specialize (Short ab Ia).
    rewrite (dimension_d Mr) in Short.
    assert (Lm : length (fst ab) = S d) by (rewrite <- (map_length (@caller_entry d r (sites m))),
      Ea, map_length; exact Full).
    apply Bool.diff_true_false. rewrite <- Short. apply has_at_most_less.
    exact (eq_ind_r (fun n => (d < n)%nat) (Nat.lt_succ_diag_r d) Lm). }
  split.
  - split; [now apply (in_own_conv measured_all m unit_positive X g)|].
    intros f If Cf v Iv. assert (If' : incl f (vertices g)).
    { rewrite (framed_vertices X g G). apply incl_tran with (1 := If). apply incl_map. intros y.
      apply incl_firstn. }
    apply (conv_face g f _ If') in Cf. destruct Cf as [_ Car]. unfold s in Iv.
    apply in_map_iff in Iv. destruct Iv as (y & <- & Iy).
    apply In_nth_error in Iy. destruct Iy as (i & Ei).
    assert (Hi : (i < 3)%nat) by (pose proof (nth_error_Some (firstn 3 X) i) as K; rewrite Ei in K;
      pose proof (firstn_le_length 3 X);
      apply Nat.lt_le_trans with (length (firstn 3 X)); [apply K; discriminate|assumption]).
    assert (Ex : nth_error X i = Some y).
    { rewrite <- (firstn_skipn 3 X). rewrite nth_error_app1; [assumption|]. apply nth_error_Some.
      now rewrite Ei. }
    destruct (framed_vertex X g G i y Ex) as [Hid <-]. apply Car; [assumption|].
    apply (coordinate_positive Mr X g G q w i Hid Sq Pw). rewrite forallb_forall in Po. apply Po.
    destruct i as [|[|[|i]]]; [cbn; tauto..|lia].
  - intros o r2 Ci.
    destruct (no_ball_inside Mr unit_positive (combine own (firstn 3 X)) [(z, p)] o r2 B)
      as (z' & p' & Ip & Dp).
    + rewrite map_app. apply Forall_app. split; [|now repeat constructor]. apply Forall_forall.
      intros y Iy.
      apply in_map_iff in Iy. destruct Iy as ((a, y') & <- & Iy). apply in_combine_r in Iy.
      apply SX. now apply (incl_firstn 3).
    + intros v Iv. apply in_map_iff in Iv. destruct Iv as (y & <- & Iy). apply in_map_iff in Iy.
      destruct Iy as ((a, y') & <- & Iy).
      apply in_combine_r in Iy. apply Ci. now apply in_map.
    + destruct Ip as [Ip|[]]. injection Ip as <- <-. exact Dp.
Qed.
End Shown.
