(** * Points of polygons, as the checker sees them

    A polygon is the union of the kept triangles of its domain in the plane ([Polygons.v]): so a
    point of space is in it if it is in its plane and seen in one of them ([in_piece]), and is not
    if it is seen in none ([off_polygon_sound]). *)
From Coq Require Import Rbase Rfunctions Lra List Arith Lia ZArith Bool.
From Circumspect Require Import GivenDomain Numbering.
From Circumspect Require Import Vectors Frame Orientation Integers Accepted RefutationSigns.
From Circumspect Require Import Combinations Shadow KeptMesh KeptCells Polygons Balls DomainRefuted.
From Circumspect Require Import Definitions Domains.
Import ListNotations.
Open Scope R_scope.

Section Polygon.
Variable D : domain_certificate.
Notation c := (whole_mesh D).
Notation r := (unit_of c).
Hypothesis unit_positive : 0 < r.
Hypothesis spots_of_mesh : forall j q, Table.find j (points_of (mesh_of c)) = Some q ->
  spot 3 c j = place_of r q.
Variable f : polygon_entry.
Hypothesis shape : check_shape c (mesh_of c) f = Accepted.
Notation p2 := (plane_mesh f).
Notation part2 := (plane_part f).
Notation n := (integer_point 3 (normal f)).
Notation o := (r * IZR (offset f)).
Lemma M2 : measured orient2 plane_predicates (unit_of p2).
Proof. rewrite (same_unit c f shape). apply measured_plane, unit_positive. Qed.

Lemma in_plane_seen q w : (0 < w)%Z -> in_plane f q w = true ->
  flat n o (place_over r q w) /\ shadow (axis f) (place_over r q w) = place_over (unit_of p2)
    (seen f q) w.
Proof.
  intros Pw H. destruct (Polygons.polygon_parts c f shape) as (_ & _ & Ln & Ax & _).
  apply IZR_lt in Pw.
  destruct (over_spec f _ _ _ H Ln Ax (r / IZR w)) as (F & Sh & _).
  unfold flat, place_over, place_of. split.
  - rewrite F. field. lra.
  - rewrite Sh, (same_unit c f shape). reflexivity.
Qed.
Lemma flat_in_plane q w : (0 < w)%Z -> well_shaped 3 q -> flat n o (place_over r q w) ->
  in_plane f q w = true.
Proof.
  intros Pw Sq F. destruct (Polygons.polygon_parts c f shape) as (_ & _ & Ln & _).
  apply IZR_lt in Pw.
  unfold in_plane, over, along_axis. rewrite same_integers_refl. unfold well_shaped in Sq.
  rewrite Sq. cbn [Nat.eqb andb].
  rewrite !andb_true_r. apply Z.eqb_eq, eq_IZR. unfold flat, place_over, place_of in F.
  rewrite inner_scale_r in F.
  rewrite (inner_of_integers 3 _ _ Ln Sq) in F. rewrite mult_IZR.
  apply Rmult_eq_reg_l with (r / IZR w).
  - rewrite F. field. lra.
  - apply Rgt_not_eq, Rlt_gt, Rdiv_lt_0_compat; [exact unit_positive|assumption].
Qed.

Lemma piece_places l Y : find_all (Table.of_list position (points p2)) l = Some Y ->
  map (place_of (unit_of p2)) Y = map (Definitions.spot 2 p2) l /\ length Y = length l /\
    Forall (well_shaped 2) Y.
Proof.
  revert Y. induction l as [|k l IH]; intros Y E; cbn [find_all] in E.
  - injection E as <-. repeat constructor.
  - rewrite table_find in E. destruct (numbered (points p2) k) as [e|] eqn:Ek; [|discriminate].
    cbn [option_map] in E.
    destruct (find_all _ l) as [Z|]; [|discriminate]. injection E as <-.
    destruct (IH Z eq_refl) as (Pl & L & Sh).
    cbn [map length]. rewrite Pl, L, (spot_numbered 2 p2 k e Ek). repeat split.
    constructor; [|assumption].
    assert (Fk : Table.find k (points_of (mesh_of p2)) = Some (site_of (claimed p2) e))
      by (rewrite (find_point (c := p2)), Ek; reflexivity).
    destruct (point_known plane_computes p2 (plane_mesh_accepted _ _ _ (plane_ok c f shape)) k _ Fk)
      as (_ & W & _).
    unfold well_shaped in *. now rewrite coordinates_site_of in W.
Qed.
(** The triangle of the plane, as points and as sites. *)
Lemma piece_framed u e Y : numbered (simplices p2) u = Some e ->
  find_all (Table.of_list position (points p2)) (corners e) = Some Y ->
  proper plane_predicates Y = true -> exists g, RefutationSigns.framed orient2 plane_predicates
    (unit_of p2) Y g /\
    map (place_of (unit_of p2)) Y = map (Definitions.spot 2 p2) (corners e).
Proof.
  intros E FY Pr. destruct (piece_places _ _ FY) as (Pl & L & Sh).
  destruct (proper_framed M2 Y Sh) as (g & G); [|assumption|eauto].
  unfold proper in Pr. apply negb_true_iff, Z.eqb_neq in Pr.
  destruct Y as [|y1 [|y2 [|y3 [|y4 Y]]]]; try reflexivity; exfalso; now apply Pr.
Qed.
Lemma kept_piece t : In t (part_simplices 2 p2 part2) <->
  exists u e, numbered (simplices p2) u = Some e /\
  kept_at (Table.of_list Datatypes.id (marks part2)) u = true /\
    t = map (Definitions.spot 2 p2) (corners e).
Proof.
  apply (kept_members oriented2 plane_computes p2 (plane_mesh_accepted _ _ _ (plane_ok c f shape))
    part2 true Enclosed _
    (plane_part_accepted _ _ _ (plane_ok c f shape))).
Qed.

Lemma in_piece u Y q w : well_shaped 3 q -> (0 < w)%Z ->
  piece_of (Table.of_list Datatypes.id (simplices p2)) (Table.of_list position (points p2)) u = Some
    Y ->
  kept_at (Table.of_list Datatypes.id (marks part2)) u = true -> in_plane f q w = true ->
  proper plane_predicates Y = true -> in_simplex plane_predicates Y (seen f q) w = true ->
  polygon_points (polygon_of 3 D f) (place_over r q w).
Proof.
  intros Sq Pw Pi K Ip Pr In_. destruct (in_plane_seen q w Pw Ip) as [F Sh].
  apply (polygon_at c spots_of_mesh D eq_refl f shape _ F). rewrite Sh.
  unfold piece_of in Pi. rewrite find_id in Pi. destruct (numbered (simplices p2) u) as [e|] eqn:E;
    [|discriminate].
  destruct (piece_framed u e Y E Pi Pr) as (g & G & Pl).
  exists (map (Definitions.spot 2 p2) (corners e)).
  split; [apply kept_piece; eauto|]. rewrite <- Pl. apply (in_simplex_conv M2 Y g G (seen f q) w);
    [|assumption..].
  destruct (Polygons.polygon_parts c f shape) as (_ & _ & _ & Ax & _).
  unfold well_shaped, seen, along_axis in *. cbn [coordinates].
  destruct (coordinates q) as [|y1 [|y2 [|y3 [|? ?]]]]; try discriminate Sq.
  destruct (axis f) as [|[|[|k]]]; [reflexivity..|lia].
Qed.

(** Two points in the same piece, and what is between them. *)
Lemma in_piece_between u Y q w q' w' s : well_shaped 3 q -> (0 < w)%Z -> well_shaped 3 q' ->
  (0 < w')%Z ->
  piece_of (Table.of_list Datatypes.id (simplices p2)) (Table.of_list position (points p2)) u = Some
    Y ->
  kept_at (Table.of_list Datatypes.id (marks part2)) u = true -> proper plane_predicates Y = true ->
  in_plane f q w = true -> in_simplex plane_predicates Y (seen f q) w = true ->
  in_plane f q' w' = true -> in_simplex plane_predicates Y (seen f q') w' = true -> 0 <= s <= 1 ->
  polygon_points (polygon_of 3 D f) (between (place_over r q w) (place_over r q' w') s).
Proof.
  intros Sq Pw Sq' Pw' Pi K Pr Ip In_ Ip' In' Hs.
  destruct (in_plane_seen q w Pw Ip) as [F Sh]. destruct (in_plane_seen q' w' Pw' Ip') as [F' Sh'].
  assert (Fb : flat n o (between (place_over r q w) (place_over r q' w') s)).
  { unfold flat, between in *. rewrite inner_plus_r, !inner_scale_r, F, F'. ring. }
  apply (polygon_at c spots_of_mesh D eq_refl f shape _ Fb). rewrite shadow_between, Sh, Sh'.
  unfold piece_of in Pi. rewrite find_id in Pi. destruct (numbered (simplices p2) u) as [e|] eqn:E;
    [|discriminate].
  destruct (piece_framed u e Y E Pi Pr) as (g & G & Pl).
  exists (map (Definitions.spot 2 p2) (corners e)).
  split; [apply kept_piece; eauto|]. rewrite <- Pl.
  assert (S2 : forall y, well_shaped 3 y -> well_shaped 2 (seen f y)).
  { intros y Sy. destruct (Polygons.polygon_parts c f shape) as (_ & _ & _ & Ax & _).
    unfold well_shaped, seen, along_axis in *. cbn [coordinates].
    destruct (coordinates y) as [|y1 [|y2 [|y3 [|? ?]]]]; try discriminate Sy.
    destruct (axis f) as [|[|[|k]]]; [reflexivity..|lia]. }
  apply (conv_conv [place_over (unit_of p2) (seen f q) w; place_over (unit_of p2) (seen f q') w']);
    [|apply conv_two; eauto].
  intros y [<-|[<-|[]]]; apply (in_simplex_conv M2 Y g G); auto.
Qed.

Lemma off_pieces_numbered points2 q w l : forall l', off_pieces points2 q w l l' = true ->
  forall i e m, nth_error l i = Some e -> nth_error l' i = Some m -> kept m = true ->
  exists Y j, find_all points2 (corners e) = Some Y /\ proper plane_predicates Y = true /\
    beyond plane_predicates Y q w j = true.
Proof.
  induction l as [|a l IH]; intros [|a' l'] H i e m E E' K; try (destruct i; discriminate).
  cbn [off_pieces] in H. apply andb_prop in H. destruct H as [H R].
  destruct i as [|i]; cbn in E, E'.
  - injection E as ->. injection E' as ->. rewrite K in H. cbn [negb orb] in H.
    destruct (find_all points2 (corners e)) as [Y|]; [|discriminate]. apply andb_prop in H.
    destruct H as [Pr B].
    apply existsb_exists in B. destruct B as (j & _ & B). exists Y, j. auto.
  - now apply (IH l' R i e m).
Qed.
Lemma off_polygon_sound q w : well_shaped 3 q -> (0 < w)%Z ->
  off_polygon q w (in_tables f) = true ->
  ~ polygon_points (polygon_of 3 D f) (place_over r q w).
Proof.
  intros Sq Pw Off H. pose proof (polygon_is_flat c D eq_refl f _ H) as F.
  pose proof (flat_in_plane q w Pw Sq F) as Ip. destruct (in_plane_seen q w Pw Ip) as [_ Sh].
  apply (polygon_at c spots_of_mesh D eq_refl f shape _ F) in H. rewrite Sh in H.
  destruct H as (t & It & C).
  apply kept_piece in It. destruct It as (u & e & E & K & ->).
  unfold off_polygon, in_tables in Off. rewrite Ip in Off. cbn [negb orb] in Off.
  destruct (mark_of p2 part2 true Enclosed _ (plane_part_accepted _ _ _ (plane_ok c f shape)) u e E)
    as (m & Em & Km & _).
  unfold numbered in E, Em.
  destruct (off_pieces_numbered _ _ _ _ _ Off _ e m E Em) as (Y & j & FY & Pr & B); [congruence|].
  destruct (piece_framed u e Y E FY Pr) as (g & G & Pl). rewrite <- Pl in C.
  apply (beyond_not_conv M2 Y g G (seen f q) w j) in C; try assumption.
  destruct (Polygons.polygon_parts c f shape) as (_ & _ & _ & Ax & _).
  unfold well_shaped, seen, along_axis in *. cbn [coordinates].
  destruct (coordinates q) as [|y1 [|y2 [|y3 [|? ?]]]]; try discriminate Sq.
  destruct (axis f) as [|[|[|k]]]; [reflexivity..|lia].
Qed.
End Polygon.
