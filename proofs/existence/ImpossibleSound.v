(** * Soundness: a domain that [check_impossible] accepts has no triangulation

    Of a triangulation one would know which candidates are chosen: each of its simplices is a candidate, and one that may be
    chosen.  Then each clause holds ([Necessary.v]), and nothing satisfies all of them ([Rup.v]). *)
From Coq Require Import Reals Lra Psatz List Arith Lia ZArith Bool.
From Circumspect Require Import ImpossibleChecker Enumeration Numbering.
From Circumspect Require Import Vectors Affine Frame Faces Facets LiftingMap Necessary Visible Breach.
From Circumspect Require Import Orientation Integers Accepted RefutationSigns.
From Circumspect Require Import Combinations KeptMesh KeptCells Polygons DomainRefuted PolygonPoints.
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
  intros Sq Pw C. apply conv_vertices in C. pose proof (square_positive X g F). apply IZR_lt in Pw as PwR.
  apply forallb_forall. intros i Hi. unfold corners_numbered in Hi. rewrite (dimension_d M) in Hi. apply in_seq_d in Hi.
  apply Z.leb_le, le_IZR. rewrite (coordinate_sign_bary M X g F q w i Hi Sq Pw).
  specialize (C i Hi). apply Rmult_le_pos; [nra|assumption].
Qed.
Lemma negative_beyond q w i : well_shaped d q -> (0 < w)%Z -> (i <= d)%nat -> bary g i (place_over r q w) < 0 ->
  beyond pr X q w i = true.
Proof.
  intros Sq Pw Hi N. pose proof (square_positive X g F). apply IZR_lt in Pw as PwR.
  unfold beyond. rewrite (dimension_d M). apply andb_true_intro. split; [apply Nat.ltb_lt; lia|].
  apply Z.ltb_lt, lt_IZR. rewrite (coordinate_sign_bary M X g F q w i Hi Sq Pw).
  assert (0 < IZR w * (IZR (orientation pr X) * IZR (orientation pr X))) by (apply Rmult_lt_0_compat; assumption). nra.
Qed.
Lemma zero_sign q w i : well_shaped d q -> (0 < w)%Z -> (i <= d)%nat -> coordinate_sign pr X q w i = 0%Z ->
  bary g i (place_over r q w) = 0.
Proof.
  intros Sq Pw Hi Z. pose proof (coordinate_sign_bary M X g F q w i Hi Sq Pw) as E. rewrite Z in E.
  pose proof (square_positive X g F). apply IZR_lt in Pw as PwR.
  assert (0 < IZR w * (IZR (orientation pr X) * IZR (orientation pr X))) by (apply Rmult_lt_0_compat; assumption).
  symmetry in E. apply Rmult_integral in E. destruct E; [lra|assumption].
Qed.
End Signs.

Section Impossible.
Variable x : impossibility.
Hypothesis accepts : check_impossible x = Accepted.
Notation D := (about x).
Notation c := (whole_mesh D).
Notation P := (domain_of_certificate 3 D).
Notation spot := (spot 3 c).
Notation r := (unit_of c).
Notation pr := space_predicates.
Notation vertices_of := (Table.of_list bare (points c)).
Notation segments_of := (Table.of_list Datatypes.id (segments (domain_part D))).
Notation polygons_listed := (map in_tables (polygons D)).
Notation polygons_of := (Table.of_list Datatypes.id polygons_listed).
Notation candidates := (sublists 4 (numbered_from 1 (points c))).
Notation candidates_of := (Table.of_list Datatypes.id candidates).
Notation fates_of := (Table.of_list Datatypes.id (fates x)).
Notation clause_of := (clause_of D vertices_of segments_of polygons_listed polygons_of candidates candidates_of fates_of).
Notation cell_point_of := (cell_point_of vertices_of segments_of polygons_of).

Lemma parts : check_about D = Accepted /\
  each_pair fate_shown AtCandidate (check_fate D vertices_of segments_of polygons_of) 1 candidates (fates x) = Accepted /\
  exists l, refuted_clauses l (steps x) = true /\ forall y, In y l -> exists s, In s (reasons x) /\ clause_of s = Some y.
Proof.
  pose proof accepts as H. unfold check_impossible in H. cbv zeta in H.
  destruct (check_about D); [|discriminate]. split; [reflexivity|].
  destruct (each_pair fate_shown _ _ _ _ _); [|discriminate]. split; [reflexivity|].
  destruct (clauses_of _ _ _ _ _ _ _ _ _ _) as [l|] eqn:E; [|discriminate].
  destruct (refuted_clauses l (steps x)) eqn:Rf; [|discriminate]. exists l. split; [assumption|].
  now apply (clauses_in _ _ _ _ _ _ _ _ _ _ _ E).
Qed.

(** ** The domain *)

Lemma about_parts : 0 < r /\
  each_pair vertices_listed AtPoint check_corner 1 (points c) (roles (domain_part D)) = Accepted /\
  forall f, In f (polygons D) -> check_shape c (mesh_of c) f = Accepted.
Proof.
  destruct parts as (H & _). unfold check_about in H. accepted. split; [|split; [reflexivity|]].
  - apply andb_prop in Heqb. destruct Heqb as [N E]. apply Z.ltb_lt, IZR_lt in N, E.
    unfold unit_of. now apply Rdiv_lt_0_compat.
  - intros f I. apply in_numbered in I. destruct I as (k & K). apply (each_accepted _ _ H) in K.
    unfold in_polygon in K. destruct (check_shape c (mesh_of c) f); [reflexivity|discriminate].
Qed.
Lemma unit_positive : 0 < r.
Proof. apply about_parts. Qed.
Lemma shape f : In f (polygons D) -> check_shape c (mesh_of c) f = Accepted.
Proof. apply about_parts. Qed.
Let M : measured orient3 pr r := measured_space r unit_positive.
Notation framed := (framed orient3 pr r).

Lemma vertex_spec k p : Table.find k vertices_of = Some p ->
  spot k = place_of r p /\ well_shaped 3 p /\ In (spot k) (domain_vertices P).
Proof.
  rewrite table_find. destruct (numbered (points c) k) as [e|] eqn:E; [|discriminate].
  cbn [option_map]. intros H. injection H as <-. split; [now apply spot_numbered|].
  destruct about_parts as (_ & A & _). apply each_pair_accepted in A. destruct A as [L A].
  destruct (numbered_beside _ _ _ _ L E) as (ro & Ro). specialize (A k e ro E Ro). unfold check_corner in A. accepted.
  apply andb_prop in Heqb. destruct Heqb as [Sh Co]. unfold shaped in Sh. apply Nat.eqb_eq in Sh.
  split; [exact Sh|]. cbn [domain_of_certificate domain_vertices]. unfold part_vertices. apply in_flat_map.
  exists (e, ro). split.
  - unfold numbered in *. apply nth_error_In with (pred (Pos.to_nat k)). now apply nth_error_combine.
  - cbn [fst snd]. destruct ro; [|discriminate]. left. symmetry. now apply spot_numbered.
Qed.
Lemma vertex_found v : In v (domain_vertices P) -> exists k p, numbered (points c) k = Some p /\ v = spot k.
Proof.
  cbn [domain_of_certificate domain_vertices]. unfold part_vertices. rewrite in_flat_map.
  intros ((e & ro) & I & H). cbn [fst snd] in H. apply in_combine_l in I. apply in_numbered in I.
  destruct I as (k & K). exists k, e. split; [assumption|]. destruct ro; [|destruct H].
  destruct H as [<-|[]]. symmetry. now apply spot_numbered.
Qed.
Lemma find_vertex k e : numbered (points c) k = Some e -> Table.find k vertices_of = Some (bare e).
Proof. intros E. rewrite table_find, E. reflexivity. Qed.
Lemma vertex_height k p : Table.find k vertices_of = Some p -> norm2 (place_of (d := 3) r p) = height_of (d := 3) r p.
Proof.
  rewrite table_find. destruct (numbered (points c) k) as [e|]; [|discriminate]. intros H. injection H as <-.
  unfold height_of. cbn [bare weight]. ring.
Qed.
Lemma find_vertices K X : find_all vertices_of K = Some X ->
  map (place_of r) X = map spot K /\ Forall (well_shaped 3) X /\ length X = length K /\
  forall p, In p X -> norm2 (place_of (d := 3) r p) = height_of (d := 3) r p.
Proof.
  revert X. induction K as [|k K IH]; intros X E; cbn [find_all] in E.
  - injection E as <-. repeat split; [constructor|]. intros p [].
  - destruct (Table.find k vertices_of) as [p|] eqn:Fp; [|discriminate].
    destruct (find_all vertices_of K) as [Y|]; [|discriminate]. injection E as <-.
    destruct (IH Y eq_refl) as (Pl & Sh & L & Hy). destruct (vertex_spec k p Fp) as (S & W & _).
    cbn [map length]. rewrite Pl, S, L. repeat split; [now constructor|].
    intros y [<-|Iy]; [exact (vertex_height k p Fp)|auto].
Qed.
Lemma spots_of_mesh j q : Table.find j (points_of (mesh_of c)) = Some q -> spot j = place_of r q.
Proof.
  rewrite (find_point (c := c)). destruct (numbered (points c) j) as [e|] eqn:E; [|discriminate].
  intros H. injection H as <-. rewrite (spot_numbered 3 c j e E). symmetry. apply place_site_of.
Qed.

(** ** Points of cells *)

Lemma cell_point_spec y z : cell_point_of y = Some z ->
  well_shaped 3 (cell_site z) /\ (0 < cell_w z)%Z /\
  exists X, In X (cells P) /\ X (place_over r (cell_site z) (cell_w z)) /\
    forall p, well_shaped 3 p -> beside z p = true -> ~ X (place_of r p).
Proof.
  destruct y as [k|k q w|k u q w]; cbn [ImpossibleChecker.cell_point_of]; intros H.
  - destruct (Table.find k vertices_of) as [v|] eqn:E; [|discriminate]. injection H as <-. cbn [cell_site cell_w beside].
    destruct (vertex_spec k v E) as (S & W & I). split; [assumption|]. split; [lia|].
    exists (fun q => q = spot k). split; [|split].
    + unfold cells. apply in_or_app. left. now apply (in_map (fun v q => q = v)).
    + now rewrite place_over_one.
    + intros p Sp B E'. apply negb_true_iff in B. rewrite S in E'. apply (same_place_place M p v Sp W) in E'. congruence.
  - rewrite find_id in H. destruct (numbered (segments (domain_part D)) k) as [s|] eqn:Es; [|discriminate].
    destruct (Table.find (from s) vertices_of) as [a|] eqn:Ea; [|discriminate].
    destruct (Table.find (last (map reached (links s)) (from s)) vertices_of) as [b|] eqn:Eb; [|discriminate].
    destruct (point_written pr q w && on_segment (times w a) (times w b) q) eqn:B; [|discriminate].
    injection H as <-. cbn [cell_site cell_w beside]. apply andb_prop in B. destruct B as [Wr On].
    apply (written M) in Wr. destruct Wr as [Sq Pw]. split; [assumption|]. split; [assumption|].
    destruct (vertex_spec _ a Ea) as (Pa & Sa & _). destruct (vertex_spec _ b Eb) as (Pb & Sb & _).
    exists (fun q => conv [fst (segment_ends 3 c s); snd (segment_ends 3 c s)] q). split; [|split].
    + unfold cells. apply in_or_app. right. apply in_or_app. left.
      apply (in_map (fun ab q => conv [fst ab; snd ab] q)). apply in_map. now apply numbered_in with k.
    + unfold segment_ends. cbn [fst snd]. rewrite Pa, Pb.
      destruct (times_place 3 r w a Pw Sa) as [Sta Ta]. destruct (times_place 3 r w b Pw Sb) as [Stb Tb].
      destruct (on_segment_between 3 (r / IZR w) _ _ q Sta Stb Sq On) as [Ht Eq]. rewrite Ta, Tb in Eq.
      apply conv_two. eexists. split; [exact Ht|exact Eq].
    + intros p Sp B C. unfold segment_ends in C. cbn [fst snd] in C. rewrite Pa, Pb in C. apply conv_two in C.
      destruct C as (t & Ht & Et). apply negb_true_iff in B.
      rewrite (on_segment_complete 3 r a b p t unit_positive Sa Sb Sp (on_segment_different a b q w On) Ht Et) in B. discriminate.
  - rewrite find_id in H. unfold numbered in H. destruct (nth_error polygons_listed (pred (Pos.to_nat k))) as [y|] eqn:Ef; [|discriminate].
    apply nth_error_In, in_map_iff in Ef. destruct Ef as (f & <- & If). unfold in_tables in H. cbv beta iota in H.
    destruct (piece_of _ _ u) as [Y|] eqn:Pi; [|discriminate].
    match type of H with (if ?b then _ else _) = _ => destruct b eqn:B; [|discriminate] end.
    injection H as <-. cbn [cell_site cell_w beside]. do 4 (apply andb_prop in B; let K := fresh in destruct B as [B K]).
    apply (written M) in B. destruct B as [Sq Pw]. split; [assumption|]. split; [assumption|].
    exists (polygon_points (polygon_of 3 D f)). split; [|split].
    + unfold cells. apply in_or_app. right. apply in_or_app. right. apply in_or_app. left. now apply in_map, in_map.
    + now apply (in_piece D unit_positive spots_of_mesh f (shape f If) u Y).
    + intros p Sp B C. apply negb_true_iff in B. pose proof (polygon_is_flat c D eq_refl f _ C) as F.
      rewrite <- (place_over_one (r := r)) in F. rewrite (flat_in_plane D unit_positive f (shape f If) p 1 eq_refl Sp F) in B. discriminate.
Qed.

(** ** What can be seen *)

Section Seen.
Variables (v q : site) (w : Z) (planes : list (list Z * Z)).
Hypothesis shape_v : well_shaped 3 v.
Hypothesis shape_q : well_shaped 3 q.
Hypothesis positive_w : (0 < w)%Z.
Notation way s := (between (place_over (d := 3) r q w) (place_of (d := 3) r v) s).
Lemma parted K s : Forall (well_shaped 3) K -> existsb (parts_from q w v K) planes = true -> 0 <= s < 1 ->
  ~ conv (map (place_of r) K) (way s).
Proof.
  intros Sh H Hs C. apply existsb_exists in H. destruct H as ((n, o) & _ & H). unfold parts_from in H. cbn [fst snd] in H.
  apply andb_prop in H. destruct H as [H Ks]. apply andb_prop in H. destruct H as [H Hv]. apply andb_prop in H.
  destruct H as [Ln Hq]. apply Nat.eqb_eq in Ln. apply Z.ltb_lt, IZR_lt in Hq. apply Z.leb_le, IZR_le in Hv.
  rewrite mult_IZR in Hq. apply IZR_lt in positive_w as Pw. pose proof unit_positive as Ru.
  set (f y := inner (integer_point 3 n) y - r * IZR o).
  assert (A : affine f). { exists (integer_point 3 n), (- (r * IZR o)). intros y. unfold f, plane. ring. }
  assert (At : forall p, well_shaped 3 p -> f (place_of r p) = r * (IZR (inner_product n (coordinates p)) - IZR o)).
  { intros p Sp. unfold f, place_of. rewrite inner_scale_r, (inner_integer _ _ Ln Sp). ring. }
  assert (Fq : 0 < f (place_over r q w)).
  { unfold f, place_over, place_of. rewrite inner_scale_r, (inner_integer _ _ Ln shape_q).
    replace (r / IZR w * IZR (inner_product n (coordinates q)) - r * IZR o)
      with (r / IZR w * (IZR (inner_product n (coordinates q)) - IZR w * IZR o)) by (field; lra).
    apply Rmult_lt_0_compat; [now apply Rdiv_lt_0_compat|lra]. }
  assert (Fv : 0 <= f (place_of r v)) by (rewrite At by assumption; apply Rmult_le_pos; lra).
  assert (Fk : 0 <= - f (way s)).
  { apply (affine_conv (fun y => - f y) (map (place_of r) K)); [now apply affine_opp| |assumption].
    intros y Iy. apply in_map_iff in Iy. destruct Iy as (p & <- & Ip). rewrite forallb_forall in Ks. specialize (Ks p Ip).
    apply Z.leb_le, IZR_le in Ks. rewrite Forall_forall in Sh. rewrite At by auto. nra. }
  change (between (d := 3)) with (mix (d := 3)) in Fk. rewrite affine_mix in Fk by assumption. nra.
Qed.
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
Lemma way_off X s : sees D vertices_of v q w planes = true -> In X (low_cells P) -> 0 <= s < 1 -> ~ X (way s).
Proof.
  intros H IX Hs. unfold sees in H. apply andb_prop in H. destruct H as [H Pg]. apply andb_prop in H. destruct H as [Vx Sg].
  unfold low_cells in IX. apply in_app_or in IX. destruct IX as [IX|IX]; [|apply in_app_or in IX; destruct IX as [IX|IX]].
  - apply in_map_iff in IX. destruct IX as (y & <- & Iy). destruct (vertex_found y Iy) as (k & e & Ee & ->).
    destruct (vertex_spec k _ (find_vertex k e Ee)) as (Sp & W & _). rewrite forallb_forall in Vx.
    intros E. apply (parted [bare e] s); [now repeat constructor| |assumption|].
    + apply Vx. now apply numbered_in with k.
    + cbn [map]. apply conv_singleton. congruence.
  - apply in_map_iff in IX. destruct IX as (ab & <- & I). apply in_map_iff in I. destruct I as (g & <- & Ig).
    rewrite forallb_forall in Sg. specialize (Sg g Ig).
    destruct (Table.find (from g) vertices_of) as [a|] eqn:Ea; [|discriminate].
    destruct (Table.find (last (map reached (links g)) (from g)) vertices_of) as [b|] eqn:Eb; [|discriminate].
    destruct (vertex_spec _ a Ea) as (Pa & Sa & _). destruct (vertex_spec _ b Eb) as (Pb & Sb & _).
    unfold segment_ends. cbn [fst snd]. rewrite Pa, Pb. apply (parted [a; b] s); [now repeat constructor|assumption..].
  - apply in_map_iff in IX. destruct IX as (y & <- & I). apply in_map_iff in I. destruct I as (f & <- & If). intros C.
    apply (polygon_covered c spots_of_mesh D eq_refl f (shape f If)) in C. destruct C as (u & e & E & K & C).
    rewrite forallb_forall in Pg. specialize (Pg f If).
    destruct (mark_of (plane_mesh f) (plane_part f) true Enclosed _
      (plane_part_accepted _ _ _ (plane_ok c f (shape f If))) u e E) as (m & Em & Km & _).
    unfold numbered in E, Em. destruct (off_kept_numbered _ _ _ _ Pg _ e m E Em) as (Y & FY & Off); [congruence|].
    destruct (find_vertices _ Y FY) as (Pl & Sh & _). rewrite <- Pl in C. now apply (parted Y s) in C.
Qed.
End Seen.

(** ** Candidates *)

Variable T : list (simplex 3).
Hypothesis triangulates : plc_triangulation P T.
Hypothesis constrained : domain_claimed D = Cdt -> forall t, In t T -> constrained_delaunay (domain_vertices P) P t.

Definition chosen k : Prop := exists K t, numbered candidates k = Some K /\ In t T /\ same t (map spot K).
Lemma chosen_dec k : {chosen k} + {~ chosen k}.
Proof.
  unfold chosen. destruct (numbered candidates k) as [K|]; [|right; now intros (K & t & E & _)].
  destruct (Exists_dec (fun t => same t (map spot K)) T) as [X|N].
  - intros t. apply same_dec.
  - left. apply Exists_exists in X. destruct X as (t & It & E). now exists K, t.
  - right. intros (K' & t & E & It & S). injection E as <-. apply N, Exists_exists. now exists t.
Qed.
Definition truth k : bool := if chosen_dec k then true else false.
Lemma truth_chosen k : chosen k -> truth k = true.
Proof. unfold truth. now destruct (chosen_dec k). Qed.

Lemma member_candidate t : In t T -> exists k, chosen k /\ exists K, numbered candidates k = Some K /\ same t (map spot K).
Proof.
  intros It. destruct (Necessary.members P T triangulates t It) as [Nd L].
  assert (H : exists ks, map spot ks = t /\ incl ks (numbers (points c))).
  { assert (V : forall v, In v t -> In v (domain_vertices P)) by (intros v Iv; now apply (vertex_of_domain P T triangulates t)).
    clear Nd L It. induction t as [|v t IH]; [now exists []|].
    destruct IH as (ks & <- & I); [intros; apply V; now right|].
    destruct (vertex_found v (V v (or_introl eq_refl))) as (k & e & E & ->). exists (k :: ks). split; [reflexivity|].
    intros j [<-|J]; [apply in_numbers; eauto|auto]. }
  destruct H as (ks & <- & I). rewrite map_length in L.
  destruct (some_sublist ks (numbers (points c)) (NoDup_map_inv _ _ Nd) (numbers_NoDup _) I) as (K & IK & E).
  rewrite L, <- numbered_from_numbers in IK. apply in_numbered in IK. destruct IK as (k & Ek).
  assert (S : same (map spot ks) (map spot K)).
  { split; apply incl_map; intros j J; now apply E. }
  exists k. split; [now exists K, (map spot ks)|eauto].
Qed.

Lemma chosen_frame k K t : numbered candidates k = Some K -> In t T -> same t (map spot K) ->
  may_be_chosen fates_of k = true /\ exists X g, candidate_at vertices_of candidates_of k = Some X /\
    find_all vertices_of K = Some X /\ framed X g /\ vertices g = map spot K.
Proof.
  intros E It S. destruct parts as (_ & Fa & _). apply each_pair_accepted in Fa. destruct Fa as [L Fa].
  destruct (numbered_beside _ _ _ _ L E) as (e & Ee). specialize (Fa k K e E Ee). unfold check_fate in Fa. accepted.
  unfold fate_holds in Heqb. destruct (find_all vertices_of K) as [X|] eqn:FX; [|discriminate].
  destruct (find_vertices K X FX) as (Pl & Sh & LX & Hx).
  rewrite (sublists_length 4 _ K (numbered_in _ _ _ E)) in LX.
  destruct (Necessary.members P T triangulates t It) as [Nd Lt].
  assert (Frame : proper pr X = true -> exists g, framed X g /\ vertices g = map spot K).
  { intros Pr. destruct (proper_framed M X Sh LX Pr) as (g & G). exists g. split; [assumption|].
    now rewrite (framed_vertices X g G). }
  destruct e as [|y|v q w planes|].
  - exfalso. apply negb_true_iff in Heqb. apply (flat_dependent M X Sh LX Heqb). rewrite Pl.
    destruct (Independence.frame_of t Lt) as (h & Vh).
    { apply (proj1 (Necessary.meets P T triangulates)). now apply (Necessary.member_face P T triangulates). }
    apply (face_independent h); [rewrite Vh; apply S|]. apply (NoDup_incl_NoDup Nd); [|apply S].
    now rewrite <- Pl, map_length, LX, Lt.
  - exfalso. apply andb_prop in Heqb. destruct Heqb as [Pr H].
    destruct (cell_point_of y) as [z|] eqn:Ey; [|discriminate].
    destruct (cell_point_spec y z Ey) as (Sq & Pw & X0 & IX & Xq & Off). apply andb_prop in H. destruct H as [In_ B].
    destruct (Frame Pr) as (g & G & Vg). apply existsb_exists in B. destruct B as (p & Ip & B).
    assert (Sp : well_shaped 3 p) by (apply carrier_of_incl in Ip; now apply (proj1 (Forall_forall _ _) Sh)).
    apply (Off p Sp B).
    apply (cell_respected P T triangulates X0 t g (place_over r (cell_site z) (cell_w z)) IX Xq It).
    + rewrite Vg. destruct S. now split.
    + rewrite (framed_vertices X g G). now apply (in_simplex_conv M X g G).
    + apply (carrier_of_carrier M X g G (cell_site z) (cell_w z) Sq Pw). now apply in_map.
  - exfalso. apply andb_prop in Heqb. destruct Heqb as [B V]. apply andb_prop in B. destruct B as [B In_].
    apply andb_prop in B. destruct B as [B Wr]. apply andb_prop in B. destruct B as [Cl Pr].
    destruct (domain_claimed D) eqn:Ecl; try discriminate. apply (written M) in Wr. destruct Wr as [Sq Pw].
    destruct (Table.find v vertices_of) as [y|] eqn:Ev; [|discriminate]. apply andb_prop in V. destruct V as [Be Se].
    apply Z.ltb_lt in Be. destruct (vertex_spec v y Ev) as (Py & Sy & Iy). destruct (Frame Pr) as (g & G & Vg).
    destruct (constrained eq_refl t It) as (_ & _ & o & r2 & Ci & Em).
    pose proof (strictly_in_simplex_inside M X g G q w Sq Pw In_) as [Cq Fq]. rewrite Pl in Cq, Fq.
    assert (Ct : conv t (place_over r q w)) by now apply (conv_same t (map spot K)).
    apply (Em (spot v) (place_over r q w) Iy).
    + split; [assumption|]. intros f Hf Cf. apply incl_tran with (map spot K); [apply S|]. apply Fq; [|assumption].
      apply incl_tran with t; [assumption|apply S].
    + rewrite Py. apply (seen (le_n 3) P T triangulates t (place_over r q w) (place_of r y) It Ct); [now rewrite <- Py|].
      intros X0 I0 s Hs. now apply (way_off y q w planes).
    + rewrite Py. apply (below_in_balls (vertices g)); [|intros p Ip; apply Ci; rewrite Vg in Ip; now apply S].
      apply below_all_planes. apply (below_witness M X g G norm2 y); [|assumption|now apply Z.ltb_lt].
      intros p [<-|Ip]; [exact (vertex_height v y Ev)|now apply Hx].
  - split; [unfold may_be_chosen; now rewrite find_id, Ee|]. destruct (Frame Heqb) as (g & G & Vg).
    exists X, g. unfold candidate_at. rewrite find_id, E. auto.
Qed.

(** ** Clauses *)

Lemma place_of_over p : place_of (d := 3) r p = place_over r p 1.
Proof. now rewrite place_over_one. Qed.

Lemma reason_satisfied s y : clause_of s = Some y -> satisfied truth y.
Proof.
  destruct s as [z|s u q w|s i q w l]; cbn [ImpossibleChecker.clause_of]; intros H.
  - destruct (cell_point_of z) as [cp|] eqn:Ez; [|discriminate]. injection H as <-.
    destruct (cell_point_spec z cp Ez) as (Sq & Pw & X0 & IX & Xq & _).
    destruct (proj1 (covers P T triangulates (place_over r (cell_site cp) (cell_w cp)))) as (t & It & C); [exists X0; auto|].
    destruct (member_candidate t It) as (k & Ck & K & Ek & Sk).
    destruct (chosen_frame k K t Ek It Sk) as (May & X & g & Ca & _ & G & Vg).
    exists (true, k). split; [|exact (truth_chosen k Ck)]. apply in_map, filter_In. split.
    + rewrite numbered_from_numbers. apply in_numbers. eauto.
    + rewrite May, Ca. cbn [andb]. apply (conv_in_simplex M X g G _ _ Sq Pw). rewrite Vg.
      now apply (conv_same t (map spot K)).
  - destruct (candidate_at _ _ s) as [X|] eqn:Cs; [|discriminate].
    destruct (candidate_at _ _ u) as [Y|] eqn:Cu; [|discriminate].
    destruct (may_be_chosen _ s && may_be_chosen _ u && overlapping pr X Y q w) eqn:B; [|discriminate]. injection H as <-.
    destruct (chosen_dec s) as [Hs|Ns].
    2: { exists (false, s). split; [now left|]. unfold is_true, truth. cbn [fst snd]. now destruct (chosen_dec s). }
    destruct (chosen_dec u) as [Hu|Nu].
    2: { exists (false, u). split; [right; now left|]. unfold is_true, truth. cbn [fst snd]. now destruct (chosen_dec u). }
    exfalso. destruct Hs as (K & t & Ek & It & St), Hu as (L & v & El & Iv & Sv).
    destruct (chosen_frame s K t Ek It St) as (_ & X' & g & Cs' & _ & G & Vg). rewrite Cs in Cs'. injection Cs' as <-.
    destruct (chosen_frame u L v El Iv Sv) as (_ & Y' & h & Cu' & _ & Hf & Vh). rewrite Cu in Cu'. injection Cu' as <-.
    apply andb_prop in B. destruct B as [_ O]. unfold overlapping in O.
    apply andb_prop in O. destruct O as [O N]. apply andb_prop in O. destruct O as [O Iy]. apply andb_prop in O. destruct O as [Wr Ix].
    apply (written M) in Wr. destruct Wr as [Sq Pw]. apply negb_true_iff in N.
    assert (E : same_places (carrier_of pr X q w) (carrier_of pr Y q w) = true); [|congruence].
    assert (Gt : same (vertices g) t) by (rewrite Vg; destruct St; now split).
    assert (Hv : same (vertices h) v) by (rewrite Vh; destruct Sv; now split).
    assert (Cx : conv (vertices g) (place_over r q w)) by (rewrite (framed_vertices X g G); now apply (in_simplex_conv M X g G)).
    assert (Cy : conv (vertices h) (place_over r q w)) by (rewrite (framed_vertices Y h Hf); now apply (in_simplex_conv M Y h Hf)).
    apply (same_places_same M).
    + eapply incl_Forall; [apply carrier_of_incl|]. apply (framed_shaped X g G).
    + eapply incl_Forall; [apply carrier_of_incl|]. apply (framed_shaped Y h Hf).
    + destruct (carrier_of_carrier M X g G q w Sq Pw) as [X1 X2]. destruct (carrier_of_carrier M Y h Hf q w Sq Pw) as [Y1 Y2].
      pose proof (carriers_agree P T triangulates t v g h _ It Iv Gt Hv Cx Cy).
      pose proof (carriers_agree P T triangulates v t h g _ Iv It Hv Gt Cy Cx). split; eauto using incl_tran.
  - rewrite find_id in H. destruct (numbered candidates s) as [K|] eqn:Ek; [|discriminate].
    destruct (candidate_at _ _ s) as [X|] eqn:Cs; [|discriminate].
    match type of H with (if ?b then _ else _) = _ => destruct b eqn:B; [|discriminate] end. injection H as <-.
    destruct (chosen_dec s) as [Hs|Ns].
    2: { exists (false, s). split; [now left|]. unfold is_true, truth. cbn [fst snd]. now destruct (chosen_dec s). }
    destruct Hs as (K' & t & Ek' & It & St). rewrite Ek in Ek'. injection Ek' as <-.
    destruct (chosen_frame s K t Ek It St) as (_ & X' & g & Cs' & _ & G & Vg). rewrite Cs in Cs'. injection Cs' as <-.
    apply andb_prop in B. destruct B as [B All]. apply andb_prop in B. destruct B as [B Kd].
    apply andb_prop in B. destruct B as [B Fc]. apply andb_prop in B. destruct B as [B Wr].
    apply andb_prop in B. destruct B as [_ Hi]. apply Nat.ltb_lt in Hi. assert (Hi' : (i <= 3)%nat) by lia.
    apply (written M) in Wr. destruct Wr as [Sq Pw].
    assert (Gt : same (vertices g) t) by (rewrite Vg; destruct St; now split).
    assert (Fi : in_facet g i (place_over r q w)).
    { unfold inside_facet in Fc. rewrite forallb_forall in Fc. unfold corners_numbered in Fc. split.
      - specialize (Fc i). rewrite Nat.eqb_refl in Fc. apply (zero_sign M X g G q w i Sq Pw Hi').
        apply Z.eqb_eq, Fc. now apply in_seq_d.
      - intros j Hj Nj. specialize (Fc j). apply Nat.eqb_neq in Nj. rewrite Nj in Fc.
        apply (coordinate_positive M X g G q w j Hj Sq Pw), Fc. now apply in_seq_d. }
    destruct (neighbour P T triangulates t g i (place_over r q w) (le_n 3) It Gt Hi' Fi) as (u & v & Iu & Iv & Nv & Su).
    { cbn [domain_of_certificate what_it_fills]. intros Kh. rewrite Kh in Kd. apply existsb_exists in Kd.
      destruct Kd as (e & Ie & Be). apply in_numbered in Ie. destruct Ie as (k & Ee).
      destruct (vertex_spec k _ (find_vertex k e Ee)) as (Sp & W & Iv). exists (spot k). split; [assumption|].
      rewrite Sp, place_of_over. unfold beyond in Be. apply andb_prop in Be. destruct Be as [_ Be].
      now apply (coordinate_negative M X g G (bare e) 1 i Hi' W eq_refl). }
    { cbn [domain_of_certificate what_it_fills domain_polygons]. intros Ke f If. rewrite Ke in Kd.
      apply in_map_iff in If. destruct If as (f' & <- & If). rewrite forallb_forall in Kd.
      apply (off_polygon_sound D unit_positive spots_of_mesh f' (shape f' If) q w Sq Pw), Kd. now apply in_map. }
    destruct (vertex_found v Iv) as (k & e & Ee & ->).
    destruct (vertex_spec k _ (find_vertex k e Ee)) as (Sp & W & _).
    assert (Be : beyond pr X (bare e) 1 i = true).
    { apply (negative_beyond M X g G (bare e) 1 i W eq_refl Hi'). now rewrite <- place_of_over, <- Sp. }
    pose proof Ee as Ne. unfold numbered in Ne. pose proof (all_beside_numbered _ _ _ _ _ _ _ All _ e Ne) as Lb.
    replace (Pos.of_succ_nat (pred (Pos.to_nat k)) + 1 - 1)%positive with k in Lb by lia.
    unfold listed_beside in Lb. rewrite Be in Lb. cbn [negb orb] in Lb. apply existsb_exists in Lb.
    destruct Lb as (m & Im & Lb). rewrite find_id in Lb. destruct (numbered candidates m) as [L|] eqn:El; [|discriminate].
    pose proof (same_members_spec _ _ Lb) as Mem.
    assert (Sl : same u (map spot L)).
    { assert (Facet : forall y, In y (facet_of g i) <-> In y (map spot (Checker.remove i K))).
      { intros y. rewrite (in_facet_of g i y Hi'), in_map_iff. split.
        - intros (j & Hj & Nj & ->).
          assert (N : nth_error (vertices g) j = Some (vertex g j)).
          { unfold vertices. rewrite (map_nth_error (vertex g) j (seq 0 4) (d := j)); [reflexivity|].
            rewrite (nth_error_nth' _ 0%nat) by (rewrite seq_length; lia). now rewrite seq_nth by lia. }
          rewrite Vg, nth_error_map in N. destruct (nth_error K j) as [a|] eqn:Ea; [|discriminate].
          injection N as N. exists a. split; [assumption|]. apply Lists.in_remove. eauto.
        - intros (a & <- & Ia). apply Lists.in_remove in Ia. destruct Ia as (j & Nj & Ea).
          assert (Hj : (j <= 3)%nat).
          { assert (j < length K)%nat by (apply nth_error_Some; congruence).
            rewrite (sublists_length 4 _ K (numbered_in _ _ _ Ek)) in H. lia. }
          exists j. split; [assumption|]. split; [assumption|].
          assert (N : nth_error (map spot K) j = Some (spot a)) by now apply map_nth_error.
          rewrite <- Vg in N. unfold vertices in N. rewrite (map_nth_error (vertex g) j (seq 0 4) (d := j)) in N; [congruence|].
          rewrite (nth_error_nth' _ 0%nat) by (rewrite seq_length; lia). now rewrite seq_nth by lia. }
      destruct Su as [S1 S2]. split.
      - intros y Iy. apply S1 in Iy. destruct Iy as [<-|Iy].
        + apply in_map, Mem. now left.
        + apply Facet, in_map_iff in Iy. destruct Iy as (a & <- & Ia). apply in_map, Mem. now right.
      - intros y Iy. apply in_map_iff in Iy. destruct Iy as (a & <- & Ia). apply Mem in Ia. apply S2.
        destruct Ia as [<-|Ia]; [now left|right]. apply Facet. now apply in_map. }
    destruct (chosen_frame m L u El Iu Sl) as (May & _).
    exists (true, m). split; [right; now apply in_map, filter_In|]. apply truth_chosen. now exists L, u.
Qed.
End Impossible.

Theorem check_impossible_sound x T : check_impossible x = Accepted -> plc_triangulation (domain_of_certificate 3 (about x)) T ->
  (domain_claimed (about x) = Cdt -> forall t, In t T ->
     constrained_delaunay (domain_vertices (domain_of_certificate 3 (about x))) (domain_of_certificate 3 (about x)) t) -> False.
Proof.
  intros A Tr Cd. destruct (parts x A) as (_ & _ & l & R & H).
  apply (refuted_clauses_sound l (steps x) (truth x T) R). intros y Iy. destruct (H y Iy) as (s & _ & E).
  now apply (reason_satisfied x A T Tr Cd s).
Qed.
