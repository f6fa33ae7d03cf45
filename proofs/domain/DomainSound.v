(** * Soundness: what the acceptance of a certificate about a domain means *)
From Coq Require Import Rbase Rfunctions Lra List Arith Lia ZArith Bool.
From Circumspect Require Import DomainChecker Numbering.
From Circumspect Require Import Frame Faces Orientation Integers Accepted Soundness.
From Circumspect Require Import CertifiedMesh KeptMesh KeptCells Constrained Pieces.
From Circumspect Require Import ConstrainedLemma Necessary.
From Circumspect Require Import Definitions Domains Solid.
Import ListNotations.
Open Scope R_scope.

Lemma steiner_from_cells {d} (P : domain d) (T : list (simplex d)) :
  (forall t, In t T -> NoDup t /\ length t = S d) /\ ForallOrdPairs (fun s t => ~ same s t) T /\
    simplicial_complex (faces_of T) ->
  (forall v, In v (domain_vertices P) -> exists t, In t T /\ In v t) ->
  (forall a b, In (a, b) (domain_segments P) -> union_of_simplices T (conv [a; b])) ->
  (forall f, In f (domain_polygons P) -> union_of_simplices T (polygon_points f)) ->
  (forall q, region P q <-> exists t, In t T /\ conv t q) -> solid_triangulation P T.
Proof.
  intros (Nd & Di & Cx) Vs Sg Pg Rg.
  assert (Full : forall t, In t T -> faces_of T t).
  { intros t It. destruct (Nd t It) as [N L]. split; [assumption|].
    split; [intros ->; discriminate|]. exists t. split; [assumption|apply incl_refl]. }
  assert (Un : forall X, In X (cells P) -> union_of_simplices T X).
  { unfold cells. intros X I. repeat (apply in_app_or in I; destruct I as [I|I]).
    - apply in_map_iff in I. destruct I as (v & <- & I). destruct (Vs v I) as (t & It & Iv).
      exists [[v]]. split.
      + intros s [<-|[]]. split; [constructor; [intros []|constructor]|].
        split; [discriminate|]. exists t. split; [assumption|]. now intros x [<-|[]].
      + intros q. split.
        * intros ->. exists [v]. split; [now left|]. now apply Combinations.conv_singleton.
        * intros (s & [<-|[]] & C). now apply Combinations.conv_singleton.
    - apply in_map_iff in I. destruct I as ((a, b) & <- & I). now apply Sg.
    - apply in_map_iff in I. destruct I as (f & <- & I). now apply Pg.
    - destruct I as [<-|[]]. exists T. split; [exact Full|exact Rg]. }
  repeat (split; [assumption|]). intros q. split.
  - intros (X & I & H). destruct (Un X I) as (F & HF & E). apply E in H. destruct H as (s & Is & C).
    destruct (HF s Is) as (_ & _ & t & It & J). exists t. split; [assumption|].
    now apply (conv_incl s).
  - intros H. exists (region P). split; [|now apply Rg]. unfold cells.
    apply in_or_app. right. apply in_or_app. right. apply in_or_app. right. now left.
Qed.

(** ** The claims *)

Section Claim.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis Or : oriented orient.
Hypothesis Co : computes orient pr.
Variable D : domain_certificate.
Notation c := (whole_mesh D).
Notation p := (domain_part D).
Notation T := (part_simplices d c p).
Hypothesis accepts : check_in pr c = Accepted.
Context {loose : bool}.
Variables (planar : bool) (shown : list positive -> nat -> positive * positive -> bool).
Hypothesis part_accepts : check_part pr loose planar (kind D) c p shown = Accepted.
Hypothesis positive_d : (1 <= d)%nat.
Hypothesis claim_accepts : check_claim pr shown D = Accepted.
Let members := kept_members Or Co c accepts p planar (kind D) shown part_accepts.
Let dim_d : dimension pr = d := computes_dimension _ _ Co.

Lemma corner_known t e k : numbered (simplices c) t = Some e -> In k (corners e) ->
  exists x, numbered (points c) k = Some x.
Proof. intros E I. destruct (simplex_accepted dim_d accepts t e E) as (Known & _). auto. Qed.

Lemma no_other_vertices : known_corners D = Accepted -> forall t v, In t T -> In v t ->
  In v (part_vertices d c p).
Proof.
  intros H t v It Iv. unfold known_corners in H. apply each_pair_accepted in H. destruct H as [L H].
  apply members in It. destruct It as (u & e & E & K & ->). apply in_map_iff in Iv.
  destruct Iv as (k & <- & Ik).
  destruct (mark_of c p planar (kind D) shown part_accepts u e E) as (mk & Em & Km & _).
  specialize (H u e mk E Em). accepted. rewrite <- Km, K in Heqb. cbn [negb orb] in Heqb.
  rewrite forallb_forall in Heqb. apply (corner_in c p planar (kind D) shown part_accepts);
    [now apply Heqb|].
  destruct (corner_known u e k E Ik) as (x & X). rewrite (find_point (c := c)), X.
  now eexists.
Qed.

Lemma all_delaunay : domain_claimed D = ConformingDelaunay -> forall t, In t T ->
  delaunay (concat T) t.
Proof.
  intros Cl t It. pose proof claim_accepts as H. unfold check_claim in H. rewrite Cl in H. accepted.
  destruct (part_parts c p planar (kind D) shown part_accepts) as (W & _).
  pose proof (check_in_sound Or Co c accepts) as Sound.
  destruct (claimed c) eqn:Ec; try discriminate. destruct Sound as [_ Del].
  assert (It' : In t (simplices_of_certificate d c)).
  { apply members in It. destruct It as (u & e & E & _ & ->). unfold simplices_of_certificate.
    apply (in_map (fun e => map (spot d c) (corners e))). now apply numbered_in with u. }
  destruct (Del t It') as (o & r2 & C & Em). exists o, r2. split; [assumption|].
  intros x Ix. apply Em. apply in_concat in Ix. destruct Ix as (s & Is & Ix).
  apply members in Is. destruct Is as (u & e & E & _ & ->). apply in_map_iff in Ix.
  destruct Ix as (k & <- & Ik). destruct (corner_known u e k E Ik) as (y & Y).
  now apply spot_in with y.
Qed.

(** Each wall is a cell of the domain. *)
Definition walls_are_cells (P : domain d) : Prop := kind D = Enclosed ->
  forall q, flagged_points c p q ->
  exists X, In X (cells P) /\ X q /\ forall y, X y -> flagged_points c p y.

(** What is shown to be part of a wall is in one; this is all that is known of a hull. *)
Definition shown_in_walls (P : domain d) : Prop := kind D = Hull -> (2 <= d)%nat /\
  proper_domain P /\ what_it_fills P = Hull /\
  forall K i w, shown K i w = true -> exists X, In X (wall_cells P) /\
    within (conv (map (spot d c) (Checker.remove i K))) X.

Lemma constrained (P : domain d) V : check_local pr shown D = Accepted -> walls_are_cells P ->
  shown_in_walls P ->
  solid_triangulation P T -> (forall v, In v V <-> exists t, In t T /\ In v t) ->
  forall t, In t T -> constrained_delaunay V P t.
Proof.
  intros L Wa Sw St HV. destruct (frames_exist Or Co c accepts) as (geo & G).
  assert (K : kind D = Enclosed \/ kind D = Hull) by (destruct (kind D); auto). destruct K as [K|K].
  2: { destruct (Sw K) as (Two & Pr & Fi & In_).
       apply (kept_constrained_hull Or Co positive_d D accepts planar shown part_accepts L geo G P V
         Two Pr Fi St); [|assumption].
       intros t e i E Hi F.
       destruct (hull_flag_shown Co positive_d D accepts planar shown part_accepts L t e i K E Hi F)
         as (w & Sh). eauto. }
  assert (E : forall x, walls_in c p geo x <-> flagged_points c p x).
  { intros x. split.
    - intros (t & i & Ht & Hi & F & O). apply in_tets in Ht. destruct Ht as (e & E). exists t, e, i.
      repeat (split; [assumption|]). now apply (on_facet_entry Co positive_d c geo G t e).
    - intros (t & e & i & E & Hi & F & C). exists t, i. split; [apply in_tets; eauto|].
      repeat (split; [assumption|]). now apply (on_facet_entry Co positive_d c geo G t e). }
  apply (kept_constrained Or Co positive_d D accepts planar shown part_accepts L geo G K P V).
  { intros t It.
    split; [now apply (simplices_respect P T), (Necessary.member_face P T)|].
    intros v Iv. apply HV. eauto. }
  2: { intros v Iv. apply HV in Iv. destruct Iv as (s & Is & Iv).
       apply (in_kept c p planar (kind D) shown part_accepts geo G) in Is.
       destruct Is as (t & e & Ee & _ & ->). rewrite <- (entry_vertices c geo G t e Ee) in Iv.
       apply in_vertices in Iv. destruct Iv as (i & Hi & ->). exists t, i.
       split; [apply in_tets; eauto|auto]. }
  intros q W. apply E in W. destruct (Wa K q W) as (X & IX & Xq & XW).
  exists X. split; [assumption|]. split; [assumption|]. intros y Xy. now apply E, XW.
Qed.

Lemma claim_sound (P : domain d) : domain_vertices P = part_vertices d c p -> walls_are_cells P ->
  shown_in_walls P ->
  solid_triangulation P T ->
  match domain_claimed D with
  | PlcTriangulation => solid_plc_triangulation P T
  | SteinerTriangulation => solid_triangulation P T
  | ConformingDelaunay => solid_conforming_delaunay P T
  | Cdt => solid_cdt P T
  | SteinerCdt => solid_steiner_cdt P T
  end.
Proof.
  intros E Wa Sw St. pose proof claim_accepts as H. unfold check_claim in H.
  destruct (domain_claimed D) eqn:Cl.
  - split; [assumption|]. rewrite E. now apply no_other_vertices.
  - assumption.
  - split; [assumption|]. now apply all_delaunay.
  - destruct (known_corners D) eqn:K; [|discriminate]. split.
    + split; [assumption|]. rewrite E. now apply no_other_vertices.
    + apply (constrained P); try assumption. intros v. split.
      * intros Iv. destruct St as (_ & _ & _ & Vs & _). now apply Vs.
      * intros (t & It & Iv). rewrite E. now apply (no_other_vertices K t).
  - split; [assumption|]. apply (constrained P); try assumption. intros v. rewrite in_concat.
    reflexivity.
Qed.
End Claim.

(** ** The theorem *)

Theorem check_domain_sound D c : check_domain D c = Accepted ->
  let P := domain_of_certificate (dimension_of D) c in
  let T := mesh_of_domain (dimension_of D) c in
  match domain_claimed c with
  | PlcTriangulation => solid_plc_triangulation P T
  | SteinerTriangulation => solid_triangulation P T
  | ConformingDelaunay => solid_conforming_delaunay P T
  | Cdt => solid_cdt P T
  | SteinerCdt => solid_steiner_cdt P T
  end.
Proof.
  intros A. unfold check_domain in A. destruct D; cbn [dimension_of] in *; cbv zeta in *.
  - accepted. pose proof (plane_mesh_accepted _ _ _ Heqr) as Mesh.
    pose proof (plane_part_accepted _ _ _ Heqr) as Pa.
    apply (claim_sound oriented2 plane_computes c Mesh true _ Pa (le_S 1 1 (le_n 1)) A);
      [reflexivity| | |].
    { intros K q W. apply (segments_flagged _ _ _ Heqr q K) in W. destruct W as (a & b & I & C).
      exists (fun q => conv [fst (a, b); snd (a, b)] q). split; [|split; [exact C|]].
      - unfold cells. apply in_or_app. right. apply in_or_app. left.
        apply (in_map (fun ab q => conv [fst ab; snd ab] q)). exact I.
      - intros y Y. apply (segments_flagged _ _ _ Heqr y K). exists a, b. split; [exact I|exact Y].
        }
    { intros K. split; [apply le_n|]. split; [|split; [exact K|]].
      - split; intros; cbn [domain_of_certificate domain_polygons] in *; destruct (polygons c);
          try discriminate; [reflexivity|contradiction].
      - intros N i w Sh. destruct (shown_segment _ _ _ Heqr N i w Sh) as (s & Es & C).
        exists (fun q => conv [fst (segment_ends 2 (whole_mesh c) s);
          snd (segment_ends 2 (whole_mesh c) s)] q). split; [|exact C].
        unfold wall_cells. apply (in_map (fun ab q => conv [fst ab; snd ab] q)).
        cbn [domain_of_certificate domain_segments].
        apply in_map. now apply numbered_in with (fst w). }
    apply steiner_from_cells.
    + exact (kept_complex oriented2 plane_computes _ Mesh _ true _ _ Pa).
    + exact (fun v => vertices_kept oriented2 plane_computes _ Mesh _ true _ _ Pa v eq_refl).
    + intros a b I. apply in_map_iff in I. destruct I as (s & E & I).
      pose proof (segment_union oriented2 plane_computes (le_S 1 1 (le_n 1)) _ Mesh _ true _ _ Pa s
        eq_refl I) as U.
      rewrite E in U. exact U.
    + cbn [domain_of_certificate domain_polygons].
      destruct (polygons c); [intros f []|discriminate].
    + intros q. unfold region, domain_of_certificate. cbn [what_it_fills].
      destruct (kind c) eqn:K.
      * exact (plane_enclosed _ _ _ Heqr q eq_refl).
      * exact (kept_hull oriented2 plane_computes _ Mesh _ true _ _ Pa q eq_refl).
  - accepted. pose proof A as Cl. rename Heqr into Mesh. rename Heqr0 into Pa. rename Heqr1 into Pg.
    assert (Poly : forall k f, numbered (polygons c) k = Some f ->
      check_polygon false (kind c) (whole_mesh c)
      (mesh_of (whole_mesh c)) (mark_table (domain_part c)) f = Accepted).
    { intros k f E. apply (each_accepted _ _ Pg) in E. unfold in_polygon in E.
      destruct (check_polygon _ _ _ _ _ f); [reflexivity|discriminate]. }
    assert (Shown : forall N i w, shown_by_polygon (Table.of_list tables_of (polygons c)) N i w =
      true ->
      exists g, In g (polygons c) /\
        within (conv (map (spot 3 (whole_mesh c)) (Checker.remove i N)))
        (polygon_points (polygon_of 3 c g))).
    { exact (shown_piece c Mesh false Poly). }
    assert (Flagged : kind c = Enclosed ->
      forall x, flagged_points (d := 3) (whole_mesh c) (domain_part c) x <->
      exists f, In f (map (polygon_of 3 c) (polygons c)) /\ polygon_points f x).
    { intros K x. split.
      - intros (t & e & i & E & Hi & Fl & C).
        destruct (flagged_is_shown oriented3 space_computes (le_S 1 2 (le_S 1 1 (le_n 1))) _ Mesh _
          false _ _ Pa
          t e i K E Hi Fl) as (w & Sh).
        destruct (Shown _ i w Sh) as (g & Ig & W). exists (polygon_of 3 c g).
        split; [now apply in_map|now apply W].
      - intros (f & I & H). apply in_map_iff in I. destruct I as (g & <- & I).
        apply in_numbered in I.
        destruct I as (k & E).
        exact (polygon_flagged _ (whole_mesh c) (domain_part c) Mesh c eq_refl g (Poly k g E) x K
          H). }
    apply (claim_sound oriented3 space_computes c Mesh false _ Pa (le_S 1 2 (le_S 1 1 (le_n 1)))
      Cl);
      [reflexivity| | |].
    { intros K q W. apply (Flagged K) in W. destruct W as (f & I & C). exists (polygon_points f).
      split; [|split; [exact C|]].
      - unfold cells. apply in_or_app. right. apply in_or_app. right. apply in_or_app. left.
        now apply in_map.
      - intros y Y. apply (Flagged K). eauto. }
    { intros K. split; [apply le_S, le_n|]. split; [|split; [exact K|]].
      - split; [discriminate|]. intros f I. cbn [domain_of_certificate domain_polygons] in I.
        apply in_map_iff in I.
        destruct I as (g & <- & I). apply in_numbered in I. destruct I as (k & E).
        now apply polygon_normal, (shape_ok _ _ _ g (Poly k g E)).
      - intros N i w Sh. destruct (Shown N i w Sh) as (g & Ig & W).
        exists (polygon_points (polygon_of 3 c g)).
        split; [|exact W]. unfold wall_cells. apply in_map.
        cbn [domain_of_certificate domain_polygons]. now apply in_map. }
    apply steiner_from_cells.
    + exact (kept_complex oriented3 space_computes _ Mesh _ false _ _ Pa).
    + exact (fun v => vertices_kept oriented3 space_computes _ Mesh _ false _ _ Pa v eq_refl).
    + intros a b I. apply in_map_iff in I. destruct I as (s & E & I).
      pose proof (segment_union oriented3 space_computes (le_S 1 2 (le_S 1 1 (le_n 1))) _ Mesh _
        false _ _ Pa s eq_refl I)
        as U. rewrite E in U. exact U.
    + intros f I. apply in_map_iff in I. destruct I as (g & <- & I). apply in_numbered in I.
      destruct I as (k & E).
      exact (polygon_union (kind c) (whole_mesh c) (domain_part c) Mesh _ Pa c eq_refl g
        (Poly k g E) eq_refl).
    + intros q. unfold region, domain_of_certificate. cbn [what_it_fills].
      destruct (kind c) eqn:K.
      * apply (kept_enclosed oriented3 space_computes (le_S 1 2 (le_S 1 1 (le_n 1))) _ Mesh _ false
          _ _ Pa);
          [reflexivity|reflexivity|]. intros x. symmetry. apply Flagged. reflexivity.
      * exact (kept_hull oriented3 space_computes _ Mesh _ false _ _ Pa q eq_refl).
Qed.
