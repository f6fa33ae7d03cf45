(** * The pieces of polygons in the mesh

    The kept triangles of a polygon's own domain are seen where facets of the mesh are: of these the
    polygon is the union, and they are its walls. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Bool.
From Circumspect Require Import DomainChecker Numbering.
From Circumspect Require Import Vectors Affine Frame Faces Combinations Shadow.
From Circumspect Require Import Orientation Integers Accepted.
From Circumspect Require Import KeptMesh KeptCells Definitions Domains.
From Circumspect Require Export Polygons.
Import ListNotations.
Open Scope R_scope.

(** Its place in the mesh. *)
Section Polygon.
Context {loose loose_tiles : bool}.
Variables (kind : domain_kind) (c : certificate) (p : part).
Hypothesis accepts : check_in space_predicates c = Accepted.
Variable shown : list positive -> nat -> positive * positive -> bool.
Hypothesis part_accepts : check_part space_predicates loose false kind c p shown = Accepted.
Variable D : domain_certificate.
Hypothesis of_D : whole_mesh D = c.
Variable f : polygon_entry.
Hypothesis polygon_accepts : check_polygon loose_tiles kind c (mesh_of c)
  (mark_table p) f = Accepted.

Notation spot := (spot 3 c).
Notation p2 := (plane_mesh f).
Notation part2 := (plane_part f).
Notation spot2 := (Definitions.spot 2 p2).
Notation sh := (shadow (axis f)).

Lemma spots_known j q : Table.find j (points_of (mesh_of c)) = Some q ->
  spot j = place_of (unit_of c) q.
Proof. intros Q. apply (point_known space_computes c accepts j q Q). Qed.
Lemma shape_ok : check_shape c (mesh_of c) f = Accepted.
Proof. pose proof polygon_accepts as H. unfold check_polygon in H. now accepted. Qed.
Let flat_ok := plane_ok c f shape_ok.
Let named_spec := named_spec c spots_known f shape_ok.
Let polygon_covered := polygon_covered c spots_known D of_D f shape_ok.

Lemma tile_at u s : numbered (simplices p2) u = Some s -> kept_at (mark_table part2) u = true ->
  exists t i e, numbered (tiles f) u = Some (t, i) /\ numbered (simplices c) t = Some e /\
    (loose_tiles = false -> kept_at (mark_table p) t = true) /\ (i <= 3)%nat /\
    (kind = Enclosed -> flagged_at (mark_table p) t i = true) /\
    forall x, In x (named_above (Table.of_list Datatypes.id (above f)) (corners s)) <->
      In x (Checker.remove i (corners e)).
Proof.
  intros E K. pose proof polygon_accepts as H. unfold check_polygon in H. cbv zeta in H.
  destruct (check_shape c (mesh_of c) f); [|discriminate]. apply each_pair_accepted in H.
  destruct H as [L H].
  destruct (mark_of p2 part2 true Enclosed _ (plane_part_accepted _ _ _ flat_ok) u s E)
    as (k & Ek & Kt & _).
  assert (Eb : numbered (combine (simplices p2) (marks part2)) u = Some (s, k)).
  { unfold numbered in *. now apply nth_error_combine. }
  destruct (numbered_beside _ _ _ _ L Eb) as (ti & Ti). specialize (H u _ ti Eb Ti).
  unfold check_tile in H. accepted. cbn [fst snd] in Heqb. rewrite <- Kt, K in Heqb.
  cbn [negb orb] in Heqb.
  apply andb_prop in Heqb. destruct Heqb as [Hk M]. apply andb_prop in Hk. destruct Hk as [Hk Fl].
  rewrite (find_simplex (c := c)) in M.
  destruct (numbered (simplices c) (fst ti)) as [e|] eqn:Ee; [|discriminate].
  apply andb_prop in M. destruct M as [Fa M]. exists (fst ti), (snd ti), e.
  split; [now rewrite <- surjective_pairing|].
  split; [assumption|]. split; [intros Q; now rewrite Q in Hk|]. split; [|split].
  - apply (CertifiedMesh.wall_index space_computes c accepts (fst ti) e); [assumption|].
    unfold has_facet in Fa. destruct (nth_error (walls e) (snd ti)); discriminate.
  - intros Kd. now rewrite Kd in Fl.
  - now apply same_members_spec.
Qed.

Lemma tile_spec u s : numbered (simplices p2) u = Some s -> kept_at (mark_table part2) u = true ->
  exists t i e, numbered (simplices c) t = Some e /\
    (loose_tiles = false -> kept_at (mark_table p) t = true) /\ (i <= 3)%nat /\
    (kind = Enclosed -> flagged_at (mark_table p) t i = true) /\
    forall x, In x (named_above (Table.of_list Datatypes.id (above f)) (corners s)) <->
      In x (Checker.remove i (corners e)).
Proof. intros E K. destruct (tile_at u s E K) as (t & i & e & _ & H). eauto. Qed.

Lemma spots_above u s : numbered (simplices p2) u = Some s ->
  map spot (named_above (Table.of_list Datatypes.id (above f)) (corners s)) =
    map (spot_above 3 c f) (corners s).
Proof.
  intros E. destruct (simplex_accepted (d := 2) (pr := plane_predicates) eq_refl
    (plane_mesh_accepted _ _ _ flat_ok) u s E) as (Known & _).
  unfold named_above. revert Known. generalize (corners s) as l. clear E.
  assert (G : forall l, (forall k, In k l -> exists e, numbered (points p2) k = Some e) ->
    exists k, find_all (Table.of_list Datatypes.id (above f)) l = Some k /\
      map spot k = map (spot_above 3 c f) l).
  { induction l as [|x l IH]; intros Known; [now exists []|].
    destruct IH as (k & Fa & M); [intros; apply Known; now right|].
    destruct (Known x (or_introl eq_refl)) as (e & E).
    destruct (above_spec c spots_known f shape_ok x e E) as (j & J & _). exists (j :: k).
    cbn [find_all map]. rewrite find_id, J, Fa, M. split; [reflexivity|].
    unfold spot_above. now rewrite J. }
  intros l Known. destruct (G l Known) as (k & -> & M). exact M.
Qed.
Lemma in_pieces x : In x (pieces_of 3 D f) <-> exists u s, numbered (simplices p2) u = Some s /\
  kept_at (mark_table part2) u = true /\
  x = map spot (named_above (Table.of_list Datatypes.id (above f)) (corners s)).
Proof.
  unfold pieces_of. rewrite of_D, in_flat_map. split.
  - intros ((s & k) & I & X). cbn [fst snd] in X. destruct (kept k) eqn:K; [|destruct X].
    destruct X as [<-|[]]. apply In_nth_error in I. destruct I as (i & I).
    apply nth_error_combine in I. destruct I as [Is Ik]. exists (Pos.of_succ_nat i), s.
    assert (Es : numbered (simplices p2) (Pos.of_succ_nat i) = Some s).
    { unfold numbered. now rewrite SuccNat2Pos.id_succ. }
    split; [assumption|]. split; [|symmetry; now apply spots_above with (Pos.of_succ_nat i)].
    unfold kept_at. rewrite find_id. unfold numbered. rewrite SuccNat2Pos.id_succ. cbn [pred].
    now rewrite Ik.
  - intros (u & s & E & K & ->).
    destruct (mark_of p2 part2 true Enclosed _ (plane_part_accepted _ _ _ flat_ok) u s E)
      as (k & Ek & Kt & _).
    exists (s, k). split.
    + unfold numbered in E, Ek. apply nth_error_In with (pred (Pos.to_nat u)).
      now apply nth_error_combine.
    + cbn [fst snd]. rewrite <- Kt, K. left. symmetry. now apply spots_above with u.
Qed.
(** A piece is a facet of the mesh, and of the kept one if no tile is loose. *)
Lemma piece_in_facet x : In x (pieces_of 3 D f) -> NoDup x /\ length x = 3%nat /\
  exists t i e, numbered (simplices c) t = Some e /\
    (loose_tiles = false -> kept_at (mark_table p) t = true) /\ (i <= 3)%nat /\
    (kind = Enclosed -> flagged_at (mark_table p) t i = true) /\
    same x (map spot (Checker.remove i (corners e))).
Proof.
  intros Ix. apply in_pieces in Ix. destruct Ix as (u & s & E & K & ->).
  destruct (tile_spec u s E K) as (t & i & e & Ee & Kt & Hi & Fl & M).
  destruct (named_spec u s E) as [_ Sh].
  destruct (kept_complex oriented2 plane_computes p2 (plane_mesh_accepted _ _ _ flat_ok)
    part2 true Enclosed _ (plane_part_accepted _ _ _ flat_ok)) as (Nd & _).
  destruct (Nd (map spot2 (corners s))) as [N2 L2].
  { apply (kept_members oriented2 plane_computes p2 (plane_mesh_accepted _ _ _ flat_ok) part2 true
      Enclosed _ (plane_part_accepted _ _ _ flat_ok)). eauto. }
  split; [apply (NoDup_map_inv sh); now rewrite Sh|].
  split; [rewrite <- Sh, map_length in L2; exact L2|].
  exists t, i, e. repeat (split; [assumption|]). split; intros v Iv; apply in_map_iff in Iv;
    destruct Iv as (k & <- & Ik); apply in_map; now apply M.
Qed.
Lemma pieces_cover q : polygon_points (polygon_of 3 D f) q <->
  exists x, In x (pieces_of 3 D f) /\ conv x q.
Proof.
  rewrite polygon_covered. split.
  - intros (u & s & E & K & C). eexists. split; [apply in_pieces; eauto|exact C].
  - intros (x & Ix & C). apply in_pieces in Ix. destruct Ix as (u & s & E & K & ->). eauto.
Qed.
Theorem polygon_union : loose_tiles = false -> union_of_simplices (part_simplices 3 c p)
  (polygon_points (polygon_of 3 D f)).
Proof.
  intros Tight. exists (pieces_of 3 D f). split; [|apply pieces_cover].
  intros x Ix. destruct (piece_in_facet x Ix) as (Nd & L & t & i & e & Ee & Kt & _ & _ & S & _).
  split; [assumption|]. split; [now intros ->|]. exists (map spot (corners e)). split.
  - apply (kept_members oriented3 space_computes c accepts p false kind _ part_accepts).
    exists t, e. auto.
  - intros y Iy. apply S, in_map_iff in Iy. destruct Iy as (k & <- & Ik). apply in_map.
    apply in_remove in Ik. destruct Ik as (j & _ & Ej). now apply nth_error_In with j.
Qed.
Lemma polygon_flagged q : kind = Enclosed -> polygon_points (polygon_of 3 D f) q ->
  flagged_points (d := 3) c p q.
Proof.
  intros K H. apply polygon_covered in H. destruct H as (u & s & E & Ku & C).
  destruct (tile_spec u s E Ku) as (t & i & e & Ee & Kt & Hi & Fl & M). exists t, e, i.
  split; [assumption|]. split; [assumption|]. split; [now apply Fl|].
  apply (conv_incl (map spot (named_above (Table.of_list Datatypes.id (above f)) (corners s))));
    [|assumption].
  intros v Iv. apply in_map_iff in Iv. destruct Iv as (k & <- & Ik). apply in_map. now apply M.
Qed.
End Polygon.

(** What a certificate says of its polygons' points and of its walls. *)
Section Walls_in_space.
Variable c : domain_certificate.
Hypothesis accepts : check_in space_predicates (whole_mesh c) = Accepted.
Variable loose_tiles : bool.
Notation mesh := (whole_mesh c).

Lemma piece_point f : check_polygon loose_tiles (kind c) mesh (mesh_of mesh)
    (mark_table (domain_part c)) f = Accepted ->
  forall u s k, numbered (simplices (plane_mesh f)) u = Some s -> In k (corners s) ->
  exists j, numbered (above f) k = Some j /\ spot_above 3 mesh f k = spot 3 mesh j /\
    exists q, Table.find j (points_of (mesh_of mesh)) = Some q.
Proof.
  intros Pf u s k E Ik. pose proof (shape_ok (kind c) mesh (domain_part c) f Pf) as Sh.
  destruct (simplex_accepted (d := 2) (pr := plane_predicates) eq_refl
    (plane_mesh_accepted _ _ _ (plane_ok mesh f Sh)) u s E) as (Known & _).
  destruct (Known k Ik) as (e & Ee).
  destruct (polygon_parts mesh f Sh) as (_ & _ & _ & _ & _ & _ & H & _).
  apply each_pair_accepted in H. destruct H as [L H].
  destruct (numbered_beside _ _ _ _ L Ee) as (j & J). exists j. split; [assumption|].
  split; [unfold spot_above; now rewrite J|]. specialize (H k e j Ee J). unfold check_above in H.
  accepted. destruct (Table.find j (points_of (mesh_of mesh))) as [q|]; [eauto|discriminate].
Qed.
Lemma shown_piece : (forall k f, numbered (polygons c) k = Some f -> check_polygon loose_tiles
    (kind c) mesh (mesh_of mesh) (mark_table (domain_part c)) f = Accepted) ->
  forall N i w, shown_by_polygon (Table.of_list tables_of (polygons c)) N i w = true ->
  exists g, In g (polygons c) /\
    within (conv (map (spot 3 mesh) (Checker.remove i N))) (polygon_points (polygon_of 3 c g)).
Proof.
  intros Poly N i w Sh. unfold shown_by_polygon in Sh. rewrite table_find in Sh.
  destruct (numbered (polygons c) (fst w)) as [g|] eqn:G; [|discriminate].
  cbn [option_map] in Sh.
  cbn [pieces piece_marks aboves tables_of] in Sh. rewrite find_id in Sh.
  apply andb_prop in Sh. destruct Sh as [Kt Sh].
  destruct (numbered (simplices (plane_mesh g)) (snd w)) as [s|] eqn:Es; [|discriminate].
  exists g. split; [now apply numbered_in with (fst w)|]. intros x C.
  apply (polygon_covered mesh (spots_known _ accepts) c eq_refl g
    (shape_ok _ _ _ g (Poly _ g G)) x).
  exists (snd w), s. split; [assumption|]. split; [assumption|].
  apply (conv_incl (map (spot 3 mesh) (Checker.remove i N))); [|assumption].
  intros v Iv. apply in_map_iff in Iv. destruct Iv as (j & <- & Ij). apply in_map.
  now apply (same_members_spec _ _ Sh).
Qed.
End Walls_in_space.
