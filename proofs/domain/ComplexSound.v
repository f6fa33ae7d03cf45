(** * Soundness: the domain of an accepted certificate is a piecewise linear complex

    In the plane and in space the conditions of [HeldCells.v] are what the checker has looked at. *)
From Coq Require Import Rbase Rfunctions Lra List Arith Lia ZArith Bool.
From Circumspect Require Import ComplexChecker Numbering.
From Circumspect Require Import Vectors Affine Frame Faces Combinations Shadow Orientation Integers
  Accepted.
From Circumspect Require Import KeptMesh KeptCells Pieces HeldFaces HeldCells Sides Definitions
  Domains.
Import ListNotations.
Open Scope R_scope.

Lemma filled_face {d} (T : list (simplex d)) X q : union_of_simplices T X -> X q -> filled T q.
Proof.
  intros (L & HL & E) H. apply E in H. destruct H as (s & Is & C).
  destruct (HL s Is) as (_ & _ & t & It & J).
  exists t. split; [assumption|]. now apply (conv_incl s).
Qed.
Lemma leaving_ext {d} (flat X Y : point d -> Prop) q : (forall x, X x <-> Y x) ->
  leaving flat X q -> leaving flat Y q.
Proof.
  intros E (r & R & H). exists r. split; [assumption|]. intros s Hs N. apply (H s Hs). now apply E.
Qed.
Lemma ends_set {d} c (s : segment_entry) a b : (forall x, In x [a; b] <->
  In x [from s; last_reached s]) ->
  forall q, conv [spot d c a; spot d c b] q <->
    conv [fst (segment_ends d c s); snd (segment_ends d c s)] q.
Proof.
  intros E q. change [spot d c a; spot d c b] with (map (spot d c) [a; b]).
  change [fst (segment_ends d c s); snd (segment_ends d c s)]
    with (map (spot d c) [from s; last_reached s]).
  apply conv_same. split; intros v Iv; apply in_map_iff in Iv; destruct Iv as (k & <- & Ik);
    now apply in_map, E.
Qed.

Section Plane.
Variables (c : domain_certificate) (x : complex_part).
Hypothesis accepts : check_domain Plane c = Accepted.
Hypothesis complex_accepts : check_complex Plane c x = Accepted.
Notation P := (domain_of_certificate 2 c).
Notation T := (part_simplices 2 (whole_mesh c) (domain_part c)).

Lemma plane_complex : piecewise_linear_complex P.
Proof.
  assert (A : check_in_plane (kind c) (whole_mesh c) (domain_part c) = Accepted /\ polygons c = []).
  { pose proof accepts as H. unfold check_domain in H. accepted.
    split; [assumption || reflexivity|].
    destruct (polygons c); [reflexivity|discriminate]. }
  destruct A as [Pl No]. pose proof (plane_mesh_accepted _ _ _ Pl) as Mesh.
  pose proof (plane_part_accepted _ _ _ Pl) as Pa.
  assert (B : each (check_steps (mesh_of (whole_mesh c))
    (Table.of_list Datatypes.id (roles (domain_part c)))
      (Table.of_list Datatypes.id (segments (domain_part c)))
        (Table.of_list Datatypes.id (faces x))) 1
      (segments (domain_part c)) = Accepted /\
    (kind c = Enclosed ->
      check_plane_sides (whole_mesh c) (domain_part c) (one_sided x) = Accepted)).
  { pose proof complex_accepts as H. unfold check_complex in H. cbv zeta in H.
    destruct (each _ _ _); [|discriminate]. split; [reflexivity|]. intros K. now rewrite K in H. }
  destruct B as [Steps Sides].
  assert (Rg : kind c = Enclosed -> forall q, region P q <-> filled T q).
  { intros K q. unfold region, domain_of_certificate. cbn [what_it_fills]. rewrite K.
    exact (plane_enclosed _ _ _ Pl q K). }
  apply (complex_from_faces oriented2 plane_computes (le_n 2) (whole_mesh c) Mesh (domain_part c)
    true (kind c) _ Pa
    (faces x) (fun _ => []) (fun _ => eq_refl) Steps P eq_refl eq_refl (fun _ _ => False));
    try (intros; contradiction).
  - intros f I. cbn in I. rewrite No in I. destruct I.
  - intros N. exfalso. apply N. cbn. now rewrite No.
  - intros K f If q Fq. change (kind c = Enclosed) in K.
    destruct (cell_cases (whole_mesh c) (domain_part c) P eq_refl f If)
      as [(v & Iv & ->)|[(n & s & N & _ & ->)|[(g & Ig & ->)|(_ & ->)]]].
    + cbn in Fq. subst q. apply (Rg K).
      destruct (vertices_kept oriented2 plane_computes _ Mesh _ true _ _ Pa v eq_refl Iv) as
        (t & It & J).
      exists t. split; [assumption|]. now apply conv_point.
    + apply (Rg K).
      apply (filled_face T _ q (segment_union oriented2 plane_computes (le_S 1 1 (le_n 1)) _ Mesh _
        true _ _ Pa s eq_refl (numbered_in _ _ _ N))).
      exact Fq.
    + cbn in Ig. rewrite No in Ig. destruct Ig.
    + exact Fq.
  - intros f q I. cbn in I. rewrite No in I. destruct I.
  - intros K q (Q & r & _ & Away). cbn [cell_points] in Q, Away. change (kind c = Enclosed) in K.
    specialize (Sides K). rewrite K in Pl.
    destruct (plane_boundary _ _ _ Pl Sides q) as (n & s & N & C & W).
    + now apply (Rg K).
    + exists r. split; [exact Logic.I|]. intros s Hs X. apply (Away s Hs). now apply (Rg K).
    + exists (segment_cell (spot 2 (whole_mesh c) (from s))
        (spot 2 (whole_mesh c) (last_reached s))).
      split; [now apply (number_cell (whole_mesh c) (domain_part c) P eq_refl n s)|].
      split; [exact C|].
      intros y Y. destruct (W y Y) as [Fy Ly]. split; [now apply (Rg K)|].
      apply (leaving_ext _ (filled T)); [|exact Ly]. intros z. symmetry. apply (Rg K).
Qed.
End Plane.

Section Space.
Variables (c : domain_certificate) (x : complex_part).
Hypothesis accepts : check_domain Space c = Accepted.
Hypothesis complex_accepts : check_complex Space c x = Accepted.
Notation P := (domain_of_certificate 3 c).
Notation T := (part_simplices 3 (whole_mesh c) (domain_part c)).
Notation tables := (Table.of_list tables_of (polygons c)).
Notation up_names f := (named_above (Table.of_list Datatypes.id (above f))).
Let one_3 : (1 <= 3)%nat := le_S 1 2 (le_S 1 1 (le_n 1)).

Definition segments_of_polygon (w : holder) : list positive :=
  match w with
  | InSegment _ => []
  | InPolygon k => match numbered (polygon_parts x) k with Some y =>
      map fst (segments_in y) | None => [] end
  end.
Definition polygon_number (k : positive) (f : polygon 3) : Prop :=
  exists g, numbered (polygons c) k = Some g /\ f = polygon_of 3 c g.

Lemma space_parts : check_in space_predicates (whole_mesh c) = Accepted /\
  check_part space_predicates false false (kind c) (whole_mesh c) (domain_part c)
    (shown_by_polygon tables) = Accepted /\
  forall k f, numbered (polygons c) k = Some f ->
    check_polygon false (kind c) (whole_mesh c) (mesh_of (whole_mesh c)) (mark_table
      (domain_part c)) f =
      Accepted.
Proof.
  pose proof accepts as H. unfold check_domain in H. cbv zeta in H. accepted.
  split; [assumption || reflexivity|]. split; [assumption || reflexivity|]. intros k f E.
  match goal with G : each _ 1 (polygons c) = Accepted |- _ => apply (each_accepted _ _ G) in E end.
  unfold in_polygon in E.
  destruct (check_polygon _ _ _ _ _ f); [reflexivity|discriminate].
Qed.
Let Mesh := proj1 space_parts.
Let Pa := proj1 (proj2 space_parts).
Let Poly := proj2 (proj2 space_parts).

Lemma complex_parts :
  each (check_steps (mesh_of (whole_mesh c)) (Table.of_list Datatypes.id (roles (domain_part c)))
    (Table.of_list Datatypes.id (segments (domain_part c))) (Table.of_list Datatypes.id (faces x)))
      1
    (segments (domain_part c)) = Accepted /\
  (kind c = Enclosed -> check_sides_of (whole_mesh c) (domain_part c) (one_sided x) = Accepted) /\
  forall k f, numbered (polygons c) k = Some f -> exists y, numbered (polygon_parts x) k = Some y /\
    check_polygon_part (mesh_of (whole_mesh c)) (Table.of_list Datatypes.id (faces x))
      (Table.of_list Datatypes.id (roles (domain_part c)))
        (Table.of_list Datatypes.id (segments (domain_part c))) f k y = Accepted /\
    (kind c = Enclosed ->
      check_tile_sides (mesh_of (whole_mesh c)) (Table.of_list Datatypes.id (marks (domain_part c)))
      f
      (Table.of_list Datatypes.id (one_sided x)) k = Accepted).
Proof.
  pose proof complex_accepts as H. unfold check_complex in H. cbv zeta in H.
  destruct (each _ _ _); [|discriminate]. split; [reflexivity|].
  destruct (if match kind c with Enclosed => true | Hull => false end then _ else _) eqn:Sd;
    [|discriminate]. split.
  - intros K. now rewrite K in Sd.
  - apply each_pair_accepted in H. destruct H as [L H]. intros k f E.
    destruct (numbered_beside _ _ _ _ L E) as (y & Y). exists y. split; [assumption|].
    specialize (H k f y E Y).
    unfold in_polygon in H. destruct (check_polygon_part _ _ _ _ f k y); [|discriminate].
    split; [reflexivity|].
    intros K. rewrite K in H. destruct (check_tile_sides _ _ f _ k); [reflexivity|discriminate].
Qed.

Lemma polygon_conditions k f y : numbered (polygons c) k = Some f ->
  numbered (polygon_parts x) k = Some y ->
  each_pair rim_listed AtSegment (check_rim (Table.of_list Datatypes.id (segments (domain_part c)))
    (Table.of_list Datatypes.id (above f))) 1 (segments (plane_part f)) (rim_segments y) = Accepted
      /\
  check_plane_sides (plane_mesh f) (plane_part f) (map snd (rim_segments y)) = Accepted /\
  each (check_segment_in (Table.of_list Datatypes.id (segments (domain_part c)))
    (Table.of_list Datatypes.id (above f))
    (Table.of_list Datatypes.id (simplices (plane_mesh f))) (mark_table (plane_part f))) 1
      (segments_in y) = Accepted /\
  each_pair face_held AtSimplex (check_piece (mesh_of (whole_mesh c))
    (Table.of_list Datatypes.id (faces x))
    (Table.of_list Datatypes.id (roles (domain_part c)))
      (Table.of_list Datatypes.id (segments (domain_part c)))
    (Table.of_list Datatypes.id (above f)) k (map fst (segments_in y))) 1
    (simplices (plane_mesh f)) (marks (plane_part f)) = Accepted.
Proof.
  intros E Y. destruct complex_parts as (_ & _ & H). destruct (H k f E) as (y' & Y' & A & _).
  assert (y' = y) by congruence. subst y'. unfold check_polygon_part in A. cbv zeta in A. accepted.
  auto.
Qed.

Lemma piece_face k f q : numbered (polygons c) k = Some f -> polygon_points (polygon_of 3 c f) q ->
  exists s,
  face_at (whole_mesh c) s q /\
    all_held (whole_mesh c) (domain_part c) (faces x) segments_of_polygon (InPolygon k) s.
Proof.
  intros E Q. pose proof (Poly k f E) as Pk.
  apply (polygon_covered (whole_mesh c) (spots_known _ Mesh) c eq_refl f (shape_ok _ _ _ f Pk) q) in
    Q.
  destruct Q as (u & s & Es & Ks & C). exists (up_names f (corners s)). split.
  - destruct (tile_spec (kind c) (whole_mesh c) (domain_part c) Mesh f Pk u s Es Ks)
      as (t & i & e & Ee & _ & _ & _ & M).
    exists t, e. split; [assumption|]. split; [|assumption]. intros j Ij. apply M in Ij.
    apply in_remove in Ij.
    destruct Ij as (a & _ & Ij). now apply nth_error_In with a.
  - destruct complex_parts as (_ & _ & H). destruct (H k f E) as (y & Y & _).
    destruct (polygon_conditions k f y E Y) as (_ & _ & _ & Pc). apply each_pair_accepted in Pc.
    destruct Pc as [L Pc].
    destruct (numbered_beside _ _ _ _ L Es) as (mk & Mk). specialize (Pc u s mk Es Mk).
    unfold check_piece in Pc.
    accepted. unfold kept_at in Ks. rewrite find_id, Mk in Ks. rewrite Ks in Heqb.
    cbn [negb orb] in Heqb.
    rewrite forallb_forall in Heqb. intros r Ir. cbn [segments_of_polygon]. rewrite Y.
    now apply Heqb.
Qed.
Lemma steps_in_pieces f : forall l u ts, steps_in (Table.of_list Datatypes.id (above f))
    (Table.of_list Datatypes.id (simplices (plane_mesh f))) (mark_table (plane_part f)) u l ts =
      true ->
  forall z, In z (edges_from u l) -> exists t s, numbered (simplices (plane_mesh f)) t = Some s /\
    kept_at (mark_table (plane_part f)) t = true /\ incl z (up_names f (corners s)).
Proof.
  induction l as [|a l IH]; intros u [|t ts] H z Iz; try discriminate; [destruct Iz|].
  cbn [steps_in] in H. apply andb_prop in H. destruct H as [H H2]. apply andb_prop in H.
  destruct H as [K H].
  rewrite find_id in H. destruct (numbered (simplices (plane_mesh f)) t) as [s|] eqn:E;
    [|discriminate].
  cbv zeta in H. apply andb_prop in H. destruct H as [Iu Iv]. apply member_in in Iu, Iv.
  destruct Iz as [<-|Iz]; [|now apply (IH (reached a) ts H2)]. exists t, s. split; [assumption|].
  split; [assumption|]. now intros j [<-|[<-|[]]].
Qed.
Lemma segment_within k f n s q : numbered (polygons c) k = Some f ->
  In n (segments_of_polygon (InPolygon k)) ->
  numbered (segments (domain_part c)) n = Some s -> conv (ends_of (d := 3) (whole_mesh c) s) q ->
  polygon_points (polygon_of 3 c f) q.
Proof.
  intros E I N C. pose proof (Poly k f E) as Pk. cbn [segments_of_polygon] in I.
  destruct (numbered (polygon_parts x) k) as [y|] eqn:Y; [|destruct I].
  destruct (polygon_conditions k f y E Y) as (_ & _ & Si & _). apply in_map_iff in I.
  destruct I as (kt & <- & I).
  apply in_numbered in I. destruct I as (j & J). apply (each_accepted _ _ Si) in J.
  unfold check_segment_in in J.
  accepted. rewrite find_id, N in Heqb.
  apply (segment_covered space_computes _ Mesh _ false _ _ Pa s (numbered_in _ _ _ N)) in C.
  destruct C as (z & Iz & C).
  destruct (steps_in_pieces f _ _ _ Heqb z Iz) as (t & e & Ee & Kt & In_t).
  apply (polygon_covered (whole_mesh c) (spots_known _ Mesh) c eq_refl f (shape_ok _ _ _ f Pk) q).
  exists t, e.
  split; [assumption|]. split; [assumption|]. apply (conv_incl (map (spot 3 (whole_mesh c)) z));
    [|assumption].
  intros v Iv. apply in_map_iff in Iv. destruct Iv as (i & <- & Ii). now apply in_map, In_t.
Qed.
Lemma polygon_sides k f q : numbered (polygons c) k = Some f ->
  let F := LinearCell 2 (fun q => inner (plane_normal (polygon_of 3 c f)) q = plane_offset
    (polygon_of 3 c f))
    (polygon_points (polygon_of 3 c f)) in
  boundary F q -> exists a b, In (a, b) (part_segments 3 (whole_mesh c) (domain_part c)) /\
    conv [a; b] q /\
    within (conv [a; b]) (boundary F).
Proof.
  intros E F (Q & L). pose proof (Poly k f E) as Pk. destruct complex_parts as (_ & _ & H).
  destruct (H k f E) as (y & Y & _). destruct (polygon_conditions k f y E Y) as (Rim & Sd & _).
  destruct (polygon_boundary (kind c) (whole_mesh c) (domain_part c) Mesh c eq_refl f Pk _ Sd q Q L)
    as (n & s & N & C & W).
  apply each_pair_accepted in Rim. destruct Rim as [Ln Rim].
  destruct (numbered_beside _ _ _ _ Ln N) as (kb & B).
  specialize (Rim n s kb N B). unfold check_rim in Rim. accepted. rewrite !find_id in Heqb.
  destruct (numbered (segments (domain_part c)) (fst kb)) as [t|] eqn:Et; [|discriminate].
  destruct (numbered (above f) (from s)) as [a|] eqn:Ea; [|discriminate].
  destruct (numbered (above f) (last_reached s)) as [b|] eqn:Eb; [|discriminate].
  pose proof (ends_set (d := 3) (whole_mesh c) t a b (same_members_spec _ _ Heqb)) as Same.
  unfold spot_above in C, W. rewrite Ea, Eb in C, W.
  exists (fst (segment_ends 3 (whole_mesh c) t)), (snd (segment_ends 3 (whole_mesh c) t)). split.
  - rewrite <- surjective_pairing. apply in_map. now apply numbered_in with (fst kb).
  - split; [now apply Same|]. intros z Z. apply Same in Z. destruct (W z Z) as [Pz Lz].
    split; assumption.
Qed.

Lemma region_filled : kind c = Enclosed -> forall q, region P q <-> filled T q.
Proof.
  intros K q. unfold region, domain_of_certificate. cbn [what_it_fills]. rewrite K.
  apply (kept_enclosed oriented3 space_computes one_3 _ Mesh _ false _ _ Pa);
    [reflexivity|assumption|].
  intros y. symmetry. split.
  - intros (t & e & i & E & Hi & Fl & C).
    destruct (flagged_is_shown oriented3 space_computes one_3 _ Mesh _ false _ _ Pa t e i K E Hi Fl)
      as (w & Sh).
    unfold shown_by_polygon in Sh. rewrite table_find in Sh.
    destruct (numbered (polygons c) (fst w)) as [g|] eqn:G; [|discriminate]. cbn [option_map] in Sh.
    cbn [pieces piece_marks aboves tables_of] in Sh. rewrite find_id in Sh. apply andb_prop in Sh.
    destruct Sh as [Kt Sh].
    destruct (numbered (simplices (plane_mesh g)) (snd w)) as [s|] eqn:Es; [|discriminate].
    exists (polygon_of 3 c g). split; [apply in_map; now apply numbered_in with (fst w)|].
    apply (polygon_covered (whole_mesh c) (spots_known _ Mesh) c eq_refl g
      (shape_ok _ _ _ g (Poly _ g G)) y).
    exists (snd w), s. split; [assumption|]. split; [assumption|].
    apply (conv_incl (map (spot 3 (whole_mesh c)) (Checker.remove i (corners e)))); [|assumption].
    intros v Iv. apply in_map_iff in Iv. destruct Iv as (j & <- & Ij). apply in_map.
    now apply (same_members_spec _ _ Sh).
  - intros (f & I & H). apply in_map_iff in I. destruct I as (g & <- & I). apply in_numbered in I.
    destruct I as (k & E).
    exact (polygon_flagged (kind c) (whole_mesh c) (domain_part c) Mesh c eq_refl g (Poly k g E) y K
      H).
Qed.

Lemma region_sides : kind c = Enclosed -> forall q, region P q ->
  leaving (fun _ => True) (region P) q ->
  exists k f, numbered (polygons c) k = Some f /\ polygon_points (polygon_of 3 c f) q /\
    forall y, polygon_points (polygon_of 3 c f) y -> region P y /\
      leaving (fun _ => True) (region P) y.
Proof.
  intros K q Q L. pose proof (region_filled K) as Rg.
  pose proof Pa as Pe. rewrite K in Pe. destruct complex_parts as (_ & Sd & H). specialize (Sd K).
  apply (leaving_ext _ _ (filled T) _ Rg) in L.
  apply (leaving_facet oriented3 space_computes one_3 _ Mesh _ false _ Pe q (proj1 (Rg q) Q)) in L.
  destruct L as (t & e & i & E & Hi & Kt & X & C).
  destruct (exposed_flagged space_computes one_3 _ Mesh _ false _ Pe t e i E Hi Kt X)
    as (mk & w0 & w & Ek & W & Kk & Fl & Sh).
  pose proof (flagged_side _ _ _ Sd t e i mk w0 w E Ek W Kk Fl) as B. rewrite X in B.
  unfold shown_by_polygon in Sh. rewrite table_find in Sh.
  destruct (numbered (polygons c) (fst w)) as [g|] eqn:G; [|discriminate]. cbn [option_map] in Sh.
  cbn [pieces piece_marks aboves tables_of] in Sh. rewrite find_id in Sh. apply andb_prop in Sh.
  destruct Sh as [Ku Sh].
  destruct (numbered (simplices (plane_mesh g)) (snd w)) as [s|] eqn:Es; [|discriminate].
  exists (fst w), g. split; [assumption|]. pose proof (Poly _ g G) as Pk. split.
  - apply (polygon_covered (whole_mesh c) (spots_known _ Mesh) c eq_refl g (shape_ok _ _ _ g Pk) q).
    exists (snd w), s. split; [assumption|]. split; [assumption|].
    apply (conv_incl (map (spot 3 (whole_mesh c)) (Checker.remove i (corners e)))); [|assumption].
    intros v Iv. apply in_map_iff in Iv. destruct Iv as (j & <- & Ij). apply in_map.
    now apply (same_members_spec _ _ Sh).
  - intros y Y. destruct (H _ g G) as (_ & _ & _ & Tl). specialize (Tl K).
    apply (polygon_covered (whole_mesh c) (spots_known _ Mesh) c eq_refl g (shape_ok _ _ _ g Pk) y)
      in Y.
    destruct Y as (u & r & Er & Kr & Cy).
    destruct (tile_at (kind c) (whole_mesh c) (domain_part c) Mesh g Pk u r Er Kr)
      as (t' & i' & e' & Ti & E' & Kt' & Hi' & _ & M). specialize (Kt' eq_refl).
    assert (Cy' : conv (map (spot 3 (whole_mesh c)) (Checker.remove i' (corners e'))) y).
    { apply (conv_incl (map (spot 3 (whole_mesh c)) (up_names g (corners r)))); [|assumption].
      intros v Iv. apply in_map_iff in Iv. destruct Iv as (j & <- & Ij). now apply in_map, M. }
    assert (Fy : filled T y).
    { exists (map (spot 3 (whole_mesh c)) (corners e')). split.
      - apply (kept_members oriented3 space_computes _ Mesh _ false _ _ Pa). eauto.
      - apply (conv_incl (map (spot 3 (whole_mesh c)) (Checker.remove i' (corners e'))));
          [|assumption].
        intros v Iv. apply in_map_iff in Iv. destruct Iv as (j & <- & Ij). apply in_map.
        apply in_remove in Ij. destruct Ij as (a & _ & Ij). now apply nth_error_In with a. }
    split; [now apply Rg|]. apply (leaving_ext _ (filled T)); [intros z; symmetry; apply Rg|].
    apply (leaving_facet oriented3 space_computes one_3 _ Mesh _ false _ Pe y Fy).
    exists t', e', i'. repeat (split; [assumption|]). split; [|assumption].
    unfold check_tile_sides in Tl. cbv zeta in Tl. apply each_pair_accepted in Tl.
    destruct Tl as [_ Tl].
    unfold kept_at in Kr. rewrite find_id in Kr.
    destruct (numbered (marks (plane_part g)) u) as [mu|] eqn:Mu; [|discriminate].
    specialize (Tl u mu _ Mu Ti). cbv beta in Tl. accepted. rewrite Kr in Heqb.
    cbn [negb orb fst snd] in Heqb.
    apply (sided_spec _ _ (one_sided x) _ t' e' i' E') in Heqb. congruence.
Qed.

Lemma space_complex : piecewise_linear_complex P.
Proof.
  destruct complex_parts as (Steps & _ & _).
  apply (complex_from_faces oriented3 space_computes (le_S 2 2 (le_n 2)) (whole_mesh c) Mesh
    (domain_part c) false (kind c) _ Pa
    (faces x) segments_of_polygon (fun _ => eq_refl) Steps P eq_refl eq_refl polygon_number).
  - intros f I. apply in_map_iff in I. destruct I as (g & <- & I). apply in_numbered in I.
    destruct I as (k & E).
    exists k, g. auto.
  - intros k f g (a & A & ->) (b & B & ->). now replace b with a by congruence.
  - intros k f q (g & G & ->) Q. exact (piece_face k g q G Q).
  - intros k f n s q (g & G & ->) I N C. exact (segment_within k g n s q G I N C).
  - intros _. apply le_n.
  - intros K f If q Fq. change (kind c = Enclosed) in K.
    destruct (cell_cases (whole_mesh c) (domain_part c) P eq_refl f If)
      as [(v & Iv & ->)|[(n & s & N & _ & ->)|[(g & Ig & ->)|(_ & ->)]]].
    + cbn in Fq. subst q. apply (region_filled K).
      destruct (vertices_kept oriented3 space_computes _ Mesh _ false _ _ Pa v eq_refl Iv) as
        (t & It & J).
      exists t. split; [assumption|]. now apply conv_point.
    + apply (region_filled K).
      apply (filled_face T _ q (segment_union oriented3 space_computes one_3 _ Mesh _ false _ _ Pa s
        eq_refl (numbered_in _ _ _ N))).
      exact Fq.
    + apply in_map_iff in Ig. destruct Ig as (h & <- & Ih). apply in_numbered in Ih.
      destruct Ih as (k & E).
      apply (region_filled K).
      exact (filled_face T _ q (polygon_union (kind c) (whole_mesh c) (domain_part c) Mesh _ Pa c
        eq_refl h (Poly k h E) eq_refl) Fq).
    + exact Fq.
  - intros f q I B. apply in_map_iff in I. destruct I as (g & <- & I). apply in_numbered in I.
    destruct I as (k & E).
    exact (polygon_sides k g q E B).
  - intros K q (Q & L). change (kind c = Enclosed) in K.
    destruct (region_sides K q Q L) as (k & f & E & Pq & W).
    exists (LinearCell 2 (fun q => inner (plane_normal (polygon_of 3 c f)) q = plane_offset
      (polygon_of 3 c f))
      (polygon_points (polygon_of 3 c f))). split; [|split; [exact Pq|]].
    + unfold linear_cells. apply in_or_app. right. apply in_or_app. right. apply in_or_app. left.
      apply (in_map (fun f => LinearCell 2 (fun q => inner (plane_normal f) q = plane_offset f)
        (polygon_points f))).
      apply (in_map (polygon_of 3 c)). now apply numbered_in with k.
    + intros y Y. destruct (W y Y) as [Ry Ly]. split; assumption.
Qed.
End Space.

Theorem check_complex_sound D c x : check_domain D c = Accepted -> check_complex D c x = Accepted ->
  piecewise_linear_complex (domain_of_certificate (dimension_of D) c).
Proof. destruct D; [apply plane_complex|apply space_complex]. Qed.
