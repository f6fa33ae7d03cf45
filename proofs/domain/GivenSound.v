(** * A domain that is given without a mesh: what the checks of its points mean

    They are the same in the plane, where there are no polygons, and in space, where a polygon is
    the union of the kept triangles of its own domain ([PolygonPoints.v]): what is needed of
    polygons is [polygons_known]. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Bool.
From Circumspect Require Import GivenDomain Numbering.
From Circumspect Require Import Vectors Affine Frame Faces Facets LiftingMap Breach Necessary.
From Circumspect Require Import Orientation Integers Accepted RefutationSigns.
From Circumspect Require Import Combinations Lists KeptMesh KeptCells Pieces Balls DomainRefuted
  PolygonPoints.
From Circumspect Require Import Definitions Domains DomainRules.
Import ListNotations.
Open Scope R_scope.

(** ** Signs, the other way round *)

Section Signs.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates} {r : R}.
Hypothesis M : measured orient pr r.
Variables (X : list site) (g : frame d).
Hypothesis F : framed orient pr r X g.
Lemma conv_in_simplex q w : well_shaped d q -> (0 < w)%Z -> conv (vertices g) (place_over r q w) ->
  in_simplex pr X q w = true.
Proof.
  intros Sq Pw C. apply conv_vertices in C. pose proof (square_positive X g F).
  apply IZR_lt in Pw as PwR.
  apply forallb_forall. intros i Hi. unfold corners_numbered in Hi. rewrite (dimension_d M) in Hi.
  apply in_seq_d in Hi.
  apply Z.leb_le, le_IZR. rewrite (coordinate_sign_bary M X g F q w i Hi Sq Pw).
  specialize (C i Hi). apply Rmult_le_pos; [nra|assumption].
Qed.
Lemma negative_beyond q w i : well_shaped d q -> (0 < w)%Z -> (i <= d)%nat ->
  bary g i (place_over r q w) < 0 ->
  beyond pr X q w i = true.
Proof.
  intros Sq Pw Hi N. pose proof (square_positive X g F). apply IZR_lt in Pw as PwR.
  unfold beyond. rewrite (dimension_d M). apply andb_true_intro. split; [apply Nat.ltb_lt; lia|].
  apply Z.ltb_lt, lt_IZR. rewrite (coordinate_sign_bary M X g F q w i Hi Sq Pw).
  assert (0 < IZR w * (IZR (orientation pr X) * IZR (orientation pr X)))
    by (apply Rmult_lt_0_compat; assumption). nra.
Qed.
Lemma zero_sign q w i : well_shaped d q -> (0 < w)%Z -> (i <= d)%nat ->
  coordinate_sign pr X q w i = 0%Z ->
  bary g i (place_over r q w) = 0.
Proof.
  intros Sq Pw Hi Z. pose proof (coordinate_sign_bary M X g F q w i Hi Sq Pw) as E. rewrite Z in E.
  pose proof (square_positive X g F). apply IZR_lt in Pw as PwR.
  assert (0 < IZR w * (IZR (orientation pr X) * IZR (orientation pr X)))
    by (apply Rmult_lt_0_compat; assumption).
  symmetry in E. apply Rmult_integral in E. destruct E; [lra|assumption].
Qed.
Lemma inside_facet_in q w i : well_shaped d q -> (0 < w)%Z -> (i <= d)%nat ->
  inside_facet pr X i q w = true ->
  in_facet g i (place_over r q w).
Proof.
  intros Sq Pw Hi Fc. unfold inside_facet in Fc. rewrite forallb_forall in Fc.
  unfold corners_numbered in Fc.
  rewrite (dimension_d M) in Fc. split.
  - specialize (Fc i). rewrite Nat.eqb_refl in Fc. apply (zero_sign q w i Sq Pw Hi).
    apply Z.eqb_eq, Fc. now apply in_seq_d.
  - intros j Hj Nj. specialize (Fc j). apply Nat.eqb_neq in Nj. rewrite Nj in Fc.
    apply (coordinate_positive M X g F q w j Hj Sq Pw), Fc. now apply in_seq_d.
Qed.
End Signs.

(** What is known of the polygons of a domain. *)
Record polygons_known (d : nat) (D : domain_certificate) : Prop := {
  known_planes : forall f, In f (polygons D) -> plane_normal (polygon_of d D f) <> origin;
  known_points : forall f u Y q w, In f (polygons D) -> well_shaped d q -> (0 < w)%Z ->
    piece_of (Table.of_list Datatypes.id (simplices (plane_mesh f)))
      (Table.of_list position (points (plane_mesh f))) u = Some Y ->
    kept_at (Table.of_list Datatypes.id (marks (plane_part f))) u = true -> in_plane f q w = true ->
    proper plane_predicates Y = true -> in_simplex plane_predicates Y (seen f q) w = true ->
    polygon_points (polygon_of d D f) (place_over (unit_of (whole_mesh D)) q w);
  known_between : forall f u Y q w q' w' s, In f (polygons D) -> well_shaped d q -> (0 < w)%Z ->
    well_shaped d q' -> (0 < w')%Z ->
    piece_of (Table.of_list Datatypes.id (simplices (plane_mesh f)))
      (Table.of_list position (points (plane_mesh f))) u = Some Y ->
    kept_at (Table.of_list Datatypes.id (marks (plane_part f))) u = true ->
      proper plane_predicates Y = true ->
    in_plane f q w = true -> in_simplex plane_predicates Y (seen f q) w = true ->
    in_plane f q' w' = true -> in_simplex plane_predicates Y (seen f q') w' = true -> 0 <= s <= 1 ->
    polygon_points (polygon_of d D f) (between (place_over (unit_of (whole_mesh D)) q w)
      (place_over (unit_of (whole_mesh D)) q' w') s);
  known_off : forall f q w, In f (polygons D) -> well_shaped d q -> (0 < w)%Z ->
    off_polygon q w (in_tables f) = true ->
    ~ polygon_points (polygon_of d D f) (place_over (unit_of (whole_mesh D)) q w);
  known_pieces : forall f q, In f (polygons D) -> polygon_points (polygon_of d D f) q ->
    exists i e m,
    nth_error (simplices (plane_mesh f)) i = Some e /\
      nth_error (marks (plane_part f)) i = Some m /\ kept m = true /\
    conv (map (spot d (whole_mesh D)) (named_above (Table.of_list Datatypes.id (above f))
      (corners e))) q
}.

Lemma spots_of_mesh {d} D j q : Table.find j (points_of (mesh_of (whole_mesh D))) = Some q ->
  spot d (whole_mesh D) j = place_of (unit_of (whole_mesh D)) q.
Proof.
  rewrite (find_point (c := whole_mesh D)).
  destruct (numbered (points (whole_mesh D)) j) as [e|] eqn:E; [|discriminate].
  intros H. injection H as <-. rewrite (spot_numbered d _ j e E). symmetry. apply place_site_of.
Qed.

Section Given.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis measured_all : forall r, 0 < r -> measured orient pr r.
Variable D : domain_certificate.
Hypothesis accepts : check_about pr D = Accepted.
Notation c := (whole_mesh D).
Notation P := (domain_of_certificate d D).
Notation spot := (spot d c).
Notation r := (unit_of c).
Notation vertices_of := (Table.of_list bare (points c)).
Notation segments_of := (Table.of_list Datatypes.id (segments (domain_part D))).
Notation polygons_listed := (map in_tables (polygons D)).
Notation polygons_of := (Table.of_list Datatypes.id polygons_listed).
Notation cell_point_of := (cell_point_of pr vertices_of segments_of polygons_of).

(** ** The domain *)

Lemma about_parts : 0 < r /\
  each_pair vertices_listed AtPoint (check_corner pr) 1 (points c) (roles (domain_part D)) =
    Accepted /\
  (polygons D = [] \/ dimension pr = 3%nat) /\
  (forall s, In s (segments (domain_part D)) -> check_ends vertices_of 1 s = Accepted) /\
  (forall h, In h (holes (domain_part D)) -> check_hole_point pr 1 h = Accepted) /\
  forall f, In f (polygons D) -> check_shape c (mesh_of c) f = Accepted.
Proof.
  pose proof accepts as H. unfold check_about in H. accepted.
  repeat match goal with |- _ /\ _ => split end.
  - apply andb_prop in Heqb. destruct Heqb as [N E]. apply Z.ltb_lt, IZR_lt in N, E.
    unfold unit_of. now apply Rdiv_lt_0_compat.
  - reflexivity.
  - destruct (polygons D); [now left|right; now apply Nat.eqb_eq].
  - intros s I. apply in_numbered in I. destruct I as (k & K).
    match goal with E : each (check_ends _) _ _ = Accepted |- _ => apply (each_accepted _ _ E) in
      K end.
    revert K. unfold check_ends. destruct (Table.find (from s) _); [|discriminate].
    now destruct (Table.find (last _ _) _).
  - intros s I. apply in_numbered in I. destruct I as (k & K).
    match goal with E : each (check_hole_point _) _ _ = Accepted |- _ => apply (each_accepted _ _ E)
      in K end.
    revert K. unfold check_hole_point. now destruct (shaped pr (hole_point s) && _)%bool.
  - intros f I. apply in_numbered in I. destruct I as (k & K). apply (each_accepted _ _ H) in K.
    unfold in_polygon in K. destruct (check_shape c (mesh_of c) f); [reflexivity|discriminate].
Qed.
Lemma unit_positive : 0 < r.
Proof. apply about_parts. Qed.
Lemma shape f : In f (polygons D) -> check_shape c (mesh_of c) f = Accepted.
Proof. apply about_parts. Qed.
Let M : measured orient pr r := measured_all r unit_positive.
Notation framed := (framed orient pr r).

Lemma vertex_spec k p : Table.find k vertices_of = Some p ->
  spot k = place_of r p /\ well_shaped d p /\ In (spot k) (domain_vertices P).
Proof.
  rewrite table_find. destruct (numbered (points c) k) as [e|] eqn:E; [|discriminate].
  cbn [option_map]. intros H. injection H as <-. split; [now apply spot_numbered|].
  destruct about_parts as (_ & A & _). apply each_pair_accepted in A. destruct A as [L A].
  destruct (numbered_beside _ _ _ _ L E) as (ro & Ro). specialize (A k e ro E Ro).
  unfold check_corner in A. accepted.
  apply andb_prop in Heqb. destruct Heqb as [Sh Co]. unfold shaped in Sh. apply Nat.eqb_eq in Sh.
  rewrite (dimension_d M) in Sh.
  split; [exact Sh|]. cbn [domain_of_certificate domain_vertices]. unfold part_vertices.
  apply in_flat_map.
  exists (e, ro). split.
  - unfold numbered in *. apply nth_error_In with (pred (Pos.to_nat k)).
    now apply nth_error_combine.
  - cbn [fst snd]. destruct ro; [|discriminate]. left. symmetry. now apply spot_numbered.
Qed.
Lemma vertex_found v : In v (domain_vertices P) -> exists k p, numbered (points c) k = Some p /\
  v = spot k.
Proof.
  cbn [domain_of_certificate domain_vertices]. unfold part_vertices. rewrite in_flat_map.
  intros ((e & ro) & I & H). cbn [fst snd] in H. apply in_combine_l in I. apply in_numbered in I.
  destruct I as (k & K). exists k, e. split; [assumption|]. destruct ro; [|destruct H].
  destruct H as [<-|[]]. symmetry. now apply spot_numbered.
Qed.
Lemma find_vertex k e : numbered (points c) k = Some e -> Table.find k vertices_of = Some (bare e).
Proof. intros E. rewrite table_find, E. reflexivity. Qed.
Lemma vertex_height k p : Table.find k vertices_of = Some p ->
  norm2 (place_of (d := d) r p) = height_of (d := d) r p.
Proof.
  rewrite table_find. destruct (numbered (points c) k) as [e|]; [|discriminate]. intros H.
  injection H as <-.
  unfold height_of. cbn [bare weight]. ring.
Qed.
Lemma find_vertices K X : find_all vertices_of K = Some X ->
  map (place_of r) X = map spot K /\ Forall (well_shaped d) X /\ length X = length K /\
  forall p, In p X -> norm2 (place_of (d := d) r p) = height_of (d := d) r p.
Proof.
  revert X. induction K as [|k K IH]; intros X E; cbn [find_all] in E.
  - injection E as <-. repeat split; [constructor|]. intros p [].
  - destruct (Table.find k vertices_of) as [p|] eqn:Fp; [|discriminate].
    destruct (find_all vertices_of K) as [Y|]; [|discriminate]. injection E as <-.
    destruct (IH Y eq_refl) as (Pl & Sh & L & Hy). destruct (vertex_spec k p Fp) as (S & W & _).
    cbn [map length]. rewrite Pl, S, L. repeat split; [now constructor|].
    intros y [<-|Iy]; [exact (vertex_height k p Fp)|auto].
Qed.
Hypothesis known : polygons_known d D.

(** ** Points of cells *)

Lemma cell_point_spec y z : cell_point_of y = Some z ->
  well_shaped d (cell_site z) /\ (0 < cell_w z)%Z /\
  exists X, (In X (cells P) /\ match y with InPiece _ _ _ _ =>
    In X (map polygon_points (domain_polygons P)) | _ => True end) /\
    X (place_over r (cell_site z) (cell_w z)) /\
    forall p, well_shaped d p -> beside z p = true -> ~ X (place_of r p).
Proof.
  destruct y as [k|k q w|k u q w]; cbn [GivenDomain.cell_point_of]; intros H.
  - destruct (Table.find k vertices_of) as [v|] eqn:E; [|discriminate]. injection H as <-.
    cbn [cell_site cell_w beside].
    destruct (vertex_spec k v E) as (S & W & I). split; [assumption|]. split; [lia|].
    exists (fun q => q = spot k). split; [|split].
    + split; [|exact Logic.I]. unfold cells. apply in_or_app. left.
      now apply (in_map (fun v q => q = v)).
    + now rewrite place_over_one.
    + intros p Sp B E'. apply negb_true_iff in B. rewrite S in E'.
      apply (same_place_place M p v Sp W) in E'. congruence.
  - rewrite find_id in H. destruct (numbered (segments (domain_part D)) k) as [s|] eqn:Es;
      [|discriminate].
    destruct (Table.find (from s) vertices_of) as [a|] eqn:Ea; [|discriminate].
    destruct (Table.find (last (map reached (links s)) (from s)) vertices_of) as [b|] eqn:Eb;
      [|discriminate].
    destruct (point_written pr q w && on_segment (times w a) (times w b) q) eqn:B; [|discriminate].
    injection H as <-. cbn [cell_site cell_w beside]. apply andb_prop in B. destruct B as [Wr On].
    apply (written M) in Wr. destruct Wr as [Sq Pw]. split; [assumption|]. split; [assumption|].
    destruct (vertex_spec _ a Ea) as (Pa & Sa & _). destruct (vertex_spec _ b Eb) as (Pb & Sb & _).
    exists (fun q => conv [fst (segment_ends d c s); snd (segment_ends d c s)] q). split; [|split].
    + split; [|exact Logic.I]. unfold cells. apply in_or_app. right. apply in_or_app. left.
      apply (in_map (fun ab q => conv [fst ab; snd ab] q)). apply in_map.
      now apply numbered_in with k.
    + unfold segment_ends. cbn [fst snd]. rewrite Pa, Pb.
      destruct (times_place d r w a Pw Sa) as [Sta Ta].
      destruct (times_place d r w b Pw Sb) as [Stb Tb].
      destruct (on_segment_between d (r / IZR w) _ _ q Sta Stb Sq On) as [Ht Eq].
      rewrite Ta, Tb in Eq.
      apply conv_two. eexists. split; [exact Ht|exact Eq].
    + intros p Sp B C. unfold segment_ends in C. cbn [fst snd] in C. rewrite Pa, Pb in C.
      apply conv_two in C.
      destruct C as (t & Ht & Et). apply negb_true_iff in B.
      rewrite (on_segment_complete d r a b p t unit_positive Sa Sb Sp
        (on_segment_different a b q w On) Ht Et) in B. discriminate.
  - rewrite find_id in H. unfold numbered in H.
    destruct (nth_error polygons_listed (pred (Pos.to_nat k))) as [y|] eqn:Ef; [|discriminate].
    apply nth_error_In, in_map_iff in Ef. destruct Ef as (f & <- & If). unfold in_tables in H.
    cbv beta iota in H.
    destruct (piece_of _ _ u) as [Y|] eqn:Pi; [|discriminate].
    match type of H with (if ?b then _ else _) = _ => destruct b eqn:B; [|discriminate] end.
    injection H as <-. cbn [cell_site cell_w beside].
    do 4 (apply andb_prop in B; let K := fresh in destruct B as [B K]).
    apply (written M) in B. destruct B as [Sq Pw]. split; [assumption|]. split; [assumption|].
    exists (polygon_points (polygon_of d D f)). split; [|split].
    + split; [|now apply in_map, in_map].
      unfold cells. apply in_or_app. right. apply in_or_app. right. apply in_or_app. left.
      now apply in_map, in_map.
    + now apply (known_points d D known f u Y).
    + intros p Sp B C. rewrite <- (place_over_one (r := r)) in C.
      now apply (known_off d D known f p 1 If Sp eq_refl B).
Qed.

(** ** Ways *)

Lemma off_kept_numbered off above_of l : forall l', off_kept vertices_of off above_of l l' = true ->
  forall i e m, nth_error l i = Some e -> nth_error l' i = Some m -> kept m = true ->
  exists Y, find_all vertices_of (named_above above_of (corners e)) = Some Y /\ off Y = true.
Proof.
  induction l as [|a l IH]; intros [|a' l'] H i e m E E' K; try (destruct i; discriminate).
  cbn [off_kept] in H. apply andb_prop in H. destruct H as [H R]. destruct i as [|i]; cbn in E, E'.
  - injection E as ->. injection E' as ->. rewrite K in H. cbn [negb orb] in H.
    destruct (find_all vertices_of _) as [Y|]; [|discriminate]. eauto.
  - now apply (IH l' R i e m).
Qed.
Lemma all_off_part off X y : all_off D vertices_of off = true -> In X (low_cells P) -> X y ->
  exists K, off K = true /\ Forall (well_shaped d) K /\ conv (map (place_of r) K) y.
Proof.
  intros H IX Xy. unfold all_off in H. apply andb_prop in H. destruct H as [H Pg].
  apply andb_prop in H. destruct H as [Vx Sg].
  unfold low_cells in IX. apply in_app_or in IX.
  destruct IX as [IX|IX]; [|apply in_app_or in IX; destruct IX as [IX|IX]].
  - apply in_map_iff in IX. destruct IX as (z & <- & Iz).
    destruct (vertex_found z Iz) as (k & e & Ee & ->).
    destruct (vertex_spec k _ (find_vertex k e Ee)) as (Sp & W & _). rewrite forallb_forall in Vx.
    exists [bare e].
    split; [apply Vx; now apply numbered_in with k|]. split; [now repeat constructor|].
    cbn [map]. apply conv_singleton. congruence.
  - apply in_map_iff in IX. destruct IX as (ab & <- & I). apply in_map_iff in I.
    destruct I as (g & <- & Ig).
    rewrite forallb_forall in Sg. specialize (Sg g Ig).
    destruct (Table.find (from g) vertices_of) as [a|] eqn:Ea; [|discriminate].
    destruct (Table.find (last (map reached (links g)) (from g)) vertices_of) as [b|] eqn:Eb;
      [|discriminate].
    destruct (vertex_spec _ a Ea) as (Pa & Sa & _). destruct (vertex_spec _ b Eb) as (Pb & Sb & _).
    unfold segment_ends in Xy. cbn [fst snd] in Xy. rewrite Pa, Pb in Xy. exists [a; b].
    split; [assumption|].
    split; [now repeat constructor|assumption].
  - apply in_map_iff in IX. destruct IX as (z & <- & I). apply in_map_iff in I.
    destruct I as (f & <- & If).
    destruct (known_pieces d D known f y If Xy) as (i & e & m & E & Em & Km & C).
    rewrite forallb_forall in Pg. specialize (Pg f If).
    destruct (off_kept_numbered _ _ _ _ Pg i e m E Em Km) as (Y & FY & Off).
    destruct (find_vertices _ Y FY) as (Pl & Sh & _). rewrite <- Pl in C. exists Y. auto.
Qed.
(** A function that is positive where the plane says so. *)
Definition beyond_plane (h : list Z * Z) (y : point d) : R :=
  inner (integer_point d (fst h)) y - r * IZR (snd h).
Lemma beyond_plane_affine h : affine (beyond_plane h).
Proof.
  exists (integer_point d (fst h)), (- (r * IZR (snd h))). intros y. unfold beyond_plane, plane.
  ring.
Qed.
Lemma beyond_plane_at h p w : length (fst h) = d -> well_shaped d p -> (0 < w)%Z ->
  beyond_plane h (place_over r p w) = r / IZR w * (IZR (inner_product (fst h) (coordinates p)) - IZR
    w * IZR (snd h)).
Proof.
  intros Ln Sp Pw. apply IZR_lt in Pw. unfold beyond_plane, place_over, place_of.
  rewrite inner_scale_r, (inner_of_integers _ _ _ Ln Sp). field. lra.
Qed.
Lemma beyond_plane_positive h p w : length (fst h) = d -> well_shaped d p -> (0 < w)%Z ->
  (w * snd h < inner_product (fst h) (coordinates p))%Z -> 0 < beyond_plane h (place_over r p w).
Proof.
  intros Ln Sp Pw L. rewrite beyond_plane_at by assumption. apply IZR_lt in Pw, L.
  rewrite mult_IZR in L.
  apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat; [exact unit_positive|assumption]|lra].
Qed.
Lemma behind_plane h K y : length (fst h) = d -> Forall (well_shaped d) K ->
  forallb (fun k => (inner_product (fst h) (coordinates k) <=? snd h)%Z) K = true ->
    conv (map (place_of r) K) y ->
  beyond_plane h y <= 0.
Proof.
  intros Ln Sh Ks C. enough (0 <= - beyond_plane h y) by lra.
  apply (affine_conv (fun y => - beyond_plane h y) (map (place_of r) K));
    [apply affine_opp, beyond_plane_affine| |assumption].
  intros z Iz. apply in_map_iff in Iz. destruct Iz as (p & <- & Ip). rewrite forallb_forall in Ks.
  specialize (Ks p Ip).
  apply Z.leb_le, IZR_le in Ks. rewrite Forall_forall in Sh.
  rewrite <- (place_over_one (r := r)), beyond_plane_at by (auto; lia). pose proof unit_positive.
  replace (r / 1) with r by field. nra.
Qed.
Section Ways.
Variables (q : site) (w : Z).
Hypothesis shape_q : well_shaped d q.
Hypothesis positive_w : (0 < w)%Z.

(** The way to a vertex, which need not be strictly beyond the planes. *)
Lemma way_free v planes X s : well_shaped d v -> sees pr D vertices_of v q w planes = true ->
  In X (low_cells P) ->
  0 <= s < 1 -> ~ X (between (place_over r q w) (place_of r v) s).
Proof.
  intros Sv H IX Hs Xy. destruct (all_off_part _ X _ H IX Xy) as (K & Off & Sh & C).
  apply existsb_exists in Off. destruct Off as (h & _ & Off). unfold parts_from in Off.
  apply andb_prop in Off. destruct Off as [Off Ks]. apply andb_prop in Off.
  destruct Off as [Off Hv].
  apply andb_prop in Off. destruct Off as [Ln Hq]. apply Nat.eqb_eq in Ln.
  rewrite (dimension_d M) in Ln.
  apply Z.ltb_lt in Hq. apply Z.leb_le, IZR_le in Hv.
  pose proof (behind_plane h K _ Ln Sh Ks C) as B.
  change (between (d := d)) with (mix (d := d)) in B.
  rewrite affine_mix in B by apply beyond_plane_affine.
  pose proof (beyond_plane_positive h q w Ln shape_q positive_w Hq) as Fq.
  assert (Fv : 0 <= beyond_plane h (place_of r v)).
  { rewrite <- (place_over_one (r := r)), beyond_plane_at by (auto; lia). pose proof unit_positive.
    replace (r / 1) with r by field. apply Rmult_le_pos; lra. }
  nra.
Qed.
(** The way to another point, which is. *)
Lemma leg_clear q' w' planes X s : clear_leg pr D vertices_of q w q' w' planes = true ->
  In X (low_cells P) -> 0 <= s <= 1 ->
  ~ X (between (place_over r q w) (place_over r q' w') s).
Proof.
  intros H IX Hs Xy. unfold clear_leg in H. apply andb_prop in H. destruct H as [Wr H].
  apply (written M) in Wr. destruct Wr as [Sq Pw].
  destruct (all_off_part _ X _ H IX Xy) as (K & Off & Sh & C).
  apply existsb_exists in Off. destruct Off as (h & _ & Off). unfold parts_leg in Off.
  apply andb_prop in Off. destruct Off as [Off Ks]. apply andb_prop in Off.
  destruct Off as [Off Hv].
  apply andb_prop in Off. destruct Off as [Ln Hq]. apply Nat.eqb_eq in Ln.
  rewrite (dimension_d M) in Ln.
  apply Z.ltb_lt in Hq, Hv.
  pose proof (behind_plane h K _ Ln Sh Ks C) as B.
  change (between (d := d)) with (mix (d := d)) in B.
  rewrite affine_mix in B by apply beyond_plane_affine.
  pose proof (beyond_plane_positive h q w Ln shape_q positive_w Hq) as Fq.
  pose proof (beyond_plane_positive h q' w' Ln Sq Pw Hv) as Fv. nra.
Qed.
(** A point in no wall. *)
Lemma off_walls_off : off_walls pr D vertices_of polygons_listed q w = true ->
  forall X, In X (wall_cells P) -> ~ X (place_over r q w).
Proof.
  intros H X IX Xq. unfold off_walls in H. rewrite (dimension_d M) in H.
  assert (Sg : forallb (off_segment vertices_of q w) (segments (domain_part D)) = true ->
    In X (map (fun ab q => conv [fst ab; snd ab] q) (domain_segments P)) -> False).
  { clear H. intros H I. apply in_map_iff in I. destruct I as (ab & <- & I).
    cbn [domain_of_certificate domain_segments] in I.
    apply in_map_iff in I. destruct I as (g & <- & Ig). rewrite forallb_forall in H.
    specialize (H g Ig). unfold off_segment in H.
    destruct (Table.find (from g) vertices_of) as [a|] eqn:Ea; [|discriminate].
    destruct (Table.find (last (map reached (links g)) (from g)) vertices_of) as [b|] eqn:Eb;
      [|discriminate].
    destruct (vertex_spec _ a Ea) as (Pa & Sa & _). destruct (vertex_spec _ b Eb) as (Pb & Sb & _).
    apply andb_prop in H. destruct H as [Ne Off]. apply negb_true_iff in Ne, Off.
    unfold segment_ends in Xq. cbn [fst snd] in Xq. rewrite Pa, Pb in Xq. apply conv_two in Xq.
    destruct Xq as (t & Ht & Et).
    destruct (times_place d r w a positive_w Sa) as [Sta Ta].
    destruct (times_place d r w b positive_w Sb) as [Stb Tb].
    assert (Pw := IZR_lt _ _ positive_w). pose proof unit_positive as Pr.
    assert (On : on_segment (times w a) (times w b) q = true); [|congruence].
    apply (on_segment_complete d (r / IZR w) (times w a) (times w b) q t); try assumption.
    - now apply Rdiv_lt_0_compat.
    - intros E. assert (same_place a b = true); [|congruence]. apply (same_place_place M a b Sa Sb).
      rewrite <- Ta, <- Tb. unfold place_of. now rewrite E.
    - rewrite Ta, Tb. exact Et. }
  assert (Pg : forallb (off_polygon q w) polygons_listed = true ->
    In X (map polygon_points (domain_polygons P)) -> False).
  { clear H. intros H I. apply in_map_iff in I. destruct I as (z & <- & I). apply in_map_iff in I.
    destruct I as (f & <- & If).
    rewrite forallb_forall in H. apply (known_off d D known f q w If shape_q positive_w);
      [apply H; now apply in_map|assumption]. }
  unfold wall_cells in IX. destruct d as [|[|[|n]]]; auto.
Qed.
End Ways.

Lemma given_proper : proper_domain P.
Proof.
  split.
  - intros E. cbn [domain_of_certificate domain_polygons].
    destruct about_parts as (_ & _ & [->|D3] & _); [reflexivity|].
    rewrite (dimension_d M) in D3. rewrite E in D3. discriminate.
  - intros f If. cbn [domain_of_certificate domain_polygons] in If. apply in_map_iff in If.
    destruct If as (g & <- & Ig).
    now apply (known_planes d D known).
Qed.
End Given.

(** ** Of polygons *)

Lemma known_in_space D : check_about space_predicates D = Accepted -> polygons_known 3 D.
Proof.
  intros A. pose proof (unit_positive D A) as U. pose proof (shape D A) as Sh.
  pose proof (spots_of_mesh (d := 3) D) as Sp. split.
  - intros f If. now apply polygon_normal, Sh.
  - intros f u Y q w If. now apply (in_piece D U Sp f (Sh f If)).
  - intros f u Y q w q' w' s If. now apply (in_piece_between D U Sp f (Sh f If)).
  - intros f q w If. now apply (off_polygon_sound D U Sp f (Sh f If)).
  - intros f q If C. apply (polygon_covered _ Sp D eq_refl f (Sh f If)) in C.
    destruct C as (u & e & E & K & C).
    destruct (mark_of (plane_mesh f) (plane_part f) true Enclosed _
      (plane_part_accepted _ _ _ (plane_ok _ f (Sh f If))) u e E) as (m & Em & Km & _).
    unfold numbered in E, Em. exists (pred (Pos.to_nat u)), e, m. repeat split; try assumption.
    congruence.
Qed.
Lemma known_in_the_plane D : check_about plane_predicates D = Accepted -> polygons_known 2 D.
Proof.
  intros A. destruct (about_parts D A) as (_ & _ & [E|E] & _); [|discriminate].
  split; intros f *; rewrite E; intros [].
Qed.
