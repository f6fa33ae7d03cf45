(** * Soundness: a domain that [check_impossible] accepts has no triangulation

    Of a triangulation one would know which candidates are chosen: each of its simplices is a
    candidate, and one that may be chosen.  Then each clause holds ([Necessary.v]), and nothing
    satisfies all of them ([Rup.v]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Bool.
From Circumspect Require Import ImpossibleChecker Enumeration GivenSound Numbering.
From Circumspect Require DomainSound.
From Circumspect Require Import Vectors Affine Frame Faces Facets LiftingMap Necessary Visible
  Covered Breach.
From Circumspect Require Import Orientation Integers Accepted RefutationSigns.
From Circumspect Require Import Combinations KeptMesh KeptCells Polygons DomainRefuted
  PolygonPoints.
From Circumspect Require Import Definitions Domains DomainRules Solid.
Import ListNotations.
Open Scope R_scope.

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
Notation candidates := (sublists_of 4 (numbered_from 1 (points c))).
Notation candidates_of := (Table.of_list Datatypes.id candidates).
Notation fates_of := (Table.of_list Datatypes.id (fates x)).
Notation clause_of :=
  (clause_of D vertices_of segments_of polygons_listed polygons_of candidates candidates_of
  fates_of).
Notation cell_point_of := (cell_point_of pr vertices_of segments_of polygons_of).

Lemma parts : check_about pr D = Accepted /\ check_mesh_of D (some_mesh x) = Accepted /\
  each_pair fate_shown AtCandidate (check_fate D vertices_of segments_of polygons_of) 1 candidates
    (fates x) = Accepted /\
  exists l, refuted_clauses l (steps x) = true /\ forall y, In y l -> exists s, In s (reasons x) /\
    clause_of s = Some y.
Proof.
  pose proof accepts as H. unfold check_impossible in H. cbv zeta in H.
  destruct (check_about pr D); [|discriminate]. split; [reflexivity|].
  destruct (check_mesh_of D (some_mesh x)); [|discriminate]. split; [reflexivity|].
  destruct (each_pair fate_shown _ _ _ _ _); [|discriminate]. split; [reflexivity|].
  destruct (clauses_of _ _ _ _ _ _ _ _ _ _) as [l|] eqn:E; [|discriminate].
  destruct (refuted_clauses l (steps x)) eqn:Rf; [|discriminate]. exists l. split; [assumption|].
  now apply (clauses_in _ _ _ _ _ _ _ _ _ _ _ E).
Qed.

(** ** The domain *)

Lemma about_ok : check_about pr D = Accepted.
Proof. apply parts. Qed.
Let known := known_in_space D about_ok.
Let M : measured orient3 pr r := measured_space r (GivenSound.unit_positive D about_ok).
Notation framed := (framed orient3 pr r).
Let vertex_spec := GivenSound.vertex_spec measured_space D about_ok.
Let vertex_found v : In v (domain_vertices P) -> exists k p, numbered (points c) k = Some p /\
  v = spot k :=
  GivenSound.vertex_found (d := 3) D v.
Let find_vertex := GivenSound.find_vertex D.
Let vertex_height k p : Table.find k vertices_of = Some p ->
  norm2 (place_of (d := 3) r p) = height_of (d := 3) r p :=
  GivenSound.vertex_height (d := 3) D k p.
Let find_vertices := GivenSound.find_vertices measured_space D about_ok.
Let cell_point_spec := GivenSound.cell_point_spec measured_space D about_ok known.

(** ** Candidates *)

Variable T : list (simplex 3).
Hypothesis triangulates : solid_plc_triangulation P T.
Let st : solid_triangulation P T := proj1 triangulates.
Hypothesis constrained : domain_claimed D = Cdt -> forall t, In t T ->
  constrained_delaunay (domain_vertices P) P t.

Definition chosen k : Prop := exists K t, numbered candidates k = Some K /\ In t T /\
  same t (map spot K).
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

Lemma member_candidate t : In t T -> exists k, chosen k /\
  exists K, numbered candidates k = Some K /\ same t (map spot K).
Proof.
  intros It. destruct (Necessary.members P T st t It) as [Nd L].
  assert (H : exists ks, map spot ks = t /\ incl ks (numbers (points c))).
  { assert (V : forall v, In v t -> In v (domain_vertices P)) by (intros v Iv;
      now apply (proj2 triangulates t)).
    clear Nd L It. induction t as [|v t IH]; [now exists []|].
    destruct IH as (ks & <- & I); [intros; apply V; now right|].
    destruct (vertex_found v (V v (or_introl eq_refl))) as (k & e & E & ->). exists (k :: ks).
    split; [reflexivity|].
    intros j [<-|J]; [apply in_numbers; eauto|auto]. }
  destruct H as (ks & <- & I). rewrite map_length in L.
  destruct (some_sublist ks (numbers (points c)) (NoDup_map_inv _ _ Nd) (numbers_NoDup _) I)
    as (K & IK & E).
  rewrite L, <- numbered_from_numbers in IK. apply in_numbered in IK. destruct IK as (k & Ek).
  assert (S : same (map spot ks) (map spot K)).
  { split; apply incl_map; intros j J; now apply E. }
  exists k. split; [now exists K, (map spot ks)|eauto].
Qed.

Lemma chosen_frame k K t : numbered candidates k = Some K -> In t T -> same t (map spot K) ->
  may_be_chosen fates_of k = true /\ exists X g, candidate_at vertices_of candidates_of k = Some X
    /\
    find_all vertices_of K = Some X /\ framed X g /\ vertices g = map spot K.
Proof.
  intros E It S. destruct parts as (_ & _ & Fa & _). apply each_pair_accepted in Fa.
  destruct Fa as [L Fa].
  destruct (numbered_beside _ _ _ _ L E) as (e & Ee). specialize (Fa k K e E Ee).
  unfold check_fate in Fa. accepted.
  unfold fate_holds in Heqb. destruct (find_all vertices_of K) as [X|] eqn:FX; [|discriminate].
  destruct (find_vertices K X FX) as (Pl & Sh & LX & Hx).
  rewrite (sublists_length 4 _ K (numbered_in _ _ _ E)) in LX.
  destruct (Necessary.members P T st t It) as [Nd Lt].
  assert (Frame : proper pr X = true -> exists g, framed X g /\ vertices g = map spot K).
  { intros Pr. destruct (proper_framed M X Sh LX Pr) as (g & G). exists g. split; [assumption|].
    now rewrite (framed_vertices X g G). }
  destruct e as [|y|v q w planes|].
  - exfalso. apply negb_true_iff in Heqb. apply (flat_dependent M X Sh LX Heqb). rewrite Pl.
    destruct (Independence.frame_of t Lt) as (h & Vh).
    { apply (proj1 (Necessary.meets P T st)). now apply (Necessary.member_face P T st). }
    apply (face_independent h); [rewrite Vh; apply S|]. apply (NoDup_incl_NoDup Nd); [|apply S].
    now rewrite <- Pl, map_length, LX, Lt.
  - exfalso. apply andb_prop in Heqb. destruct Heqb as [Pr H].
    destruct (cell_point_of y) as [z|] eqn:Ey; [|discriminate].
    destruct (cell_point_spec y z Ey) as (Sq & Pw & X0 & [IX _] & Xq & Off). apply andb_prop in H.
    destruct H as [In_ B].
    destruct (Frame Pr) as (g & G & Vg). apply existsb_exists in B. destruct B as (p & Ip & B).
    assert (Sp : well_shaped 3 p) by (apply carrier_of_incl in Ip;
      now apply (proj1 (Forall_forall _ _) Sh)).
    apply (Off p Sp B).
    apply (cell_respected P T st X0 t g (place_over r (cell_site z) (cell_w z)) IX Xq It).
    + rewrite Vg. destruct S. now split.
    + rewrite (framed_vertices X g G). now apply (in_simplex_conv M X g G).
    + apply (carrier_of_carrier M X g G (cell_site z) (cell_w z) Sq Pw). now apply in_map.
  - exfalso. apply andb_prop in Heqb. destruct Heqb as [B V]. apply andb_prop in B.
    destruct B as [B In_].
    apply andb_prop in B. destruct B as [B Wr]. apply andb_prop in B. destruct B as [Cl Pr].
    destruct (domain_claimed D) eqn:Ecl; try discriminate. apply (written M) in Wr.
    destruct Wr as [Sq Pw].
    destruct (Table.find v vertices_of) as [y|] eqn:Ev; [|discriminate]. apply andb_prop in V.
    destruct V as [Be Se].
    apply Z.ltb_lt in Be. destruct (vertex_spec v y Ev) as (Py & Sy & Iy).
    destruct (Frame Pr) as (g & G & Vg).
    destruct (constrained eq_refl t It) as (_ & _ & o & r2 & Ci & Em).
    pose proof (strictly_in_simplex_inside M X g G q w Sq Pw In_) as [Cq Fq]. rewrite Pl in Cq, Fq.
    assert (Ct : conv t (place_over r q w)) by now apply (conv_same t (map spot K)).
    apply (Em (spot v) (place_over r q w) Iy).
    + split; [assumption|]. intros f Hf Cf. apply incl_tran with (map spot K); [apply S|].
      apply Fq; [|assumption].
      apply incl_tran with t; [assumption|apply S].
    + rewrite Py. apply (seen P T st t (place_over r q w) (place_of r y) It Ct).
      { intros _. rewrite <- Py. now apply conv_point. }
      intros X0 I0 s Hs. now apply (way_free measured_space D about_ok known q w Sq Pw y planes).
    + rewrite Py. apply (below_in_balls (vertices g)); [|intros p Ip; apply Ci; rewrite Vg in Ip;
        now apply S].
      apply below_all_planes.
      apply (below_witness M X g G norm2 y); [|assumption|now apply Z.ltb_lt].
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
    destruct (cell_point_spec z cp Ez) as (Sq & Pw & X0 & [IX _] & Xq & _).
    destruct (proj1 (covers P T st (place_over r (cell_site cp) (cell_w cp)))) as (t & It & C);
      [exists X0; auto|].
    destruct (member_candidate t It) as (k & Ck & K & Ek & Sk).
    destruct (chosen_frame k K t Ek It Sk) as (May & X & g & Ca & _ & G & Vg).
    exists (true, k). split; [|exact (truth_chosen k Ck)]. apply in_map, filter_In. split.
    + rewrite numbered_from_numbers. apply in_numbers. eauto.
    + rewrite May, Ca. cbn [andb]. apply (conv_in_simplex M X g G _ _ Sq Pw). rewrite Vg.
      now apply (conv_same t (map spot K)).
  - destruct (candidate_at _ _ s) as [X|] eqn:Cs; [|discriminate].
    destruct (candidate_at _ _ u) as [Y|] eqn:Cu; [|discriminate].
    destruct (may_be_chosen _ s && may_be_chosen _ u && overlapping pr X Y q w) eqn:B;
      [|discriminate]. injection H as <-.
    destruct (chosen_dec s) as [Hs|Ns].
    2: { exists (false, s). split; [now left|]. unfold is_true, truth. cbn [fst snd].
    now destruct (chosen_dec s). }
    destruct (chosen_dec u) as [Hu|Nu].
    2: { exists (false, u). split; [right; now left|]. unfold is_true, truth. cbn [fst snd].
    now destruct (chosen_dec u). }
    exfalso. destruct Hs as (K & t & Ek & It & St), Hu as (L & v & El & Iv & Sv).
    destruct (chosen_frame s K t Ek It St) as (_ & X' & g & Cs' & _ & G & Vg). rewrite Cs in Cs'.
    injection Cs' as <-.
    destruct (chosen_frame u L v El Iv Sv) as (_ & Y' & h & Cu' & _ & Hf & Vh). rewrite Cu in Cu'.
    injection Cu' as <-.
    apply andb_prop in B. destruct B as [_ O]. unfold overlapping in O.
    apply andb_prop in O. destruct O as [O N]. apply andb_prop in O. destruct O as [O Iy].
    apply andb_prop in O. destruct O as [Wr Ix].
    apply (written M) in Wr. destruct Wr as [Sq Pw]. apply negb_true_iff in N.
    assert (E : same_places (carrier_of pr X q w) (carrier_of pr Y q w) = true); [|congruence].
    assert (Gt : same (vertices g) t) by (rewrite Vg; destruct St; now split).
    assert (Hv : same (vertices h) v) by (rewrite Vh; destruct Sv; now split).
    assert (Cx : conv (vertices g) (place_over r q w)) by (rewrite (framed_vertices X g G);
      now apply (in_simplex_conv M X g G)).
    assert (Cy : conv (vertices h) (place_over r q w)) by (rewrite (framed_vertices Y h Hf);
      now apply (in_simplex_conv M Y h Hf)).
    apply (same_places_same M).
    + eapply incl_Forall; [apply carrier_of_incl|]. apply (framed_shaped X g G).
    + eapply incl_Forall; [apply carrier_of_incl|]. apply (framed_shaped Y h Hf).
    + destruct (carrier_of_carrier M X g G q w Sq Pw) as [X1 X2].
      destruct (carrier_of_carrier M Y h Hf q w Sq Pw) as [Y1 Y2].
      pose proof (carriers_agree P T st t v g h _ It Iv Gt Hv Cx Cy).
      pose proof (carriers_agree P T st v t h g _ Iv It Hv Gt Cy Cx). split; eauto using incl_tran.
  - rewrite find_id in H. destruct (numbered candidates s) as [K|] eqn:Ek; [|discriminate].
    destruct (candidate_at _ _ s) as [X|] eqn:Cs; [|discriminate].
    match type of H with (if ?b then _ else _) = _ => destruct b eqn:B; [|discriminate] end.
    injection H as <-.
    destruct (chosen_dec s) as [Hs|Ns].
    2: { exists (false, s). split; [now left|]. unfold is_true, truth. cbn [fst snd].
    now destruct (chosen_dec s). }
    destruct Hs as (K' & t & Ek' & It & St). rewrite Ek in Ek'. injection Ek' as <-.
    destruct (chosen_frame s K t Ek It St) as (_ & X' & g & Cs' & _ & G & Vg). rewrite Cs in Cs'.
    injection Cs' as <-.
    apply andb_prop in B. destruct B as [B All]. apply andb_prop in B. destruct B as [B Kd].
    apply andb_prop in B. destruct B as [B Fc]. apply andb_prop in B. destruct B as [B Wr].
    apply andb_prop in B. destruct B as [_ Hi]. apply Nat.ltb_lt in Hi.
    assert (Hi' : (i <= 3)%nat) by lia.
    apply (written M) in Wr. destruct Wr as [Sq Pw].
    assert (Gt : same (vertices g) t) by (rewrite Vg; destruct St; now split).
    assert (Fi : in_facet g i (place_over r q w)).
    { now apply (inside_facet_in M X g G). }
    destruct (neighbour P T st t g i (place_over r q w) ltac:(lia)
      (given_proper measured_space D about_ok known) (proj2 triangulates) It Gt Hi' Fi)
      as (u & v & Iu & Iv & Nv & Su).
    { cbn [domain_of_certificate what_it_fills]. intros Kh. rewrite Kh in Kd.
      apply existsb_exists in Kd.
      destruct Kd as (e & Ie & Be). apply in_numbered in Ie. destruct Ie as (k & Ee).
      destruct (vertex_spec k _ (find_vertex k e Ee)) as (Sp & W & Iv). exists (spot k).
      split; [assumption|].
      rewrite Sp, place_of_over. unfold beyond in Be. apply andb_prop in Be. destruct Be as [_ Be].
      now apply (coordinate_negative M X g G (bare e) 1 i Hi' W eq_refl). }
    { cbn [domain_of_certificate what_it_fills domain_polygons]. intros Ke f If. rewrite Ke in Kd.
      apply in_map_iff in If. destruct If as (f'' & <- & If). apply in_map_iff in If.
      destruct If as (f' & <- & If).
      rewrite forallb_forall in Kd. apply (known_off 3 D known f' q w If Sq Pw), Kd.
      now apply in_map. }
    destruct (vertex_found v Iv) as (k & e & Ee & ->).
    destruct (vertex_spec k _ (find_vertex k e Ee)) as (Sp & W & _).
    assert (Be : beyond pr X (bare e) 1 i = true).
    { apply (negative_beyond M X g G (bare e) 1 i W eq_refl Hi').
      now rewrite <- place_of_over, <- Sp. }
    pose proof Ee as Ne. unfold numbered in Ne.
    pose proof (all_beside_numbered _ _ _ _ _ _ _ All _ e Ne) as Lb.
    replace (Pos.of_succ_nat (pred (Pos.to_nat k)) + 1 - 1)%positive with k in Lb by lia.
    unfold listed_beside in Lb. rewrite Be in Lb. cbn [negb orb] in Lb. apply existsb_exists in Lb.
    destruct Lb as (m & Im & Lb). rewrite find_id in Lb.
    destruct (numbered candidates m) as [L|] eqn:El; [|discriminate].
    pose proof (same_members_spec _ _ Lb) as Mem.
    assert (Sl : same u (map spot L)).
    { assert (Facet : forall y, In y (facet_of g i) <-> In y (map spot (Checker.remove i K))).
      { intros y. rewrite (in_facet_of g i y Hi'), in_map_iff. split.
        - intros (j & Hj & Nj & ->).
          assert (N : nth_error (vertices g) j = Some (vertex g j)).
          { unfold vertices. rewrite (map_nth_error (vertex g) j (seq 0 4) (d := j));
              [reflexivity|].
            rewrite (nth_error_nth' _ 0%nat) by (rewrite seq_length; lia).
            now rewrite seq_nth by lia. }
          rewrite Vg, nth_error_map in N. destruct (nth_error K j) as [a|] eqn:Ea; [|discriminate].
          injection N as N. exists a. split; [assumption|]. apply Lists.in_remove. eauto.
        - intros (a & <- & Ia). apply Lists.in_remove in Ia. destruct Ia as (j & Nj & Ea).
          assert (Hj : (j <= 3)%nat).
          { assert (j < length K)%nat by (apply nth_error_Some; congruence).
            rewrite (sublists_length 4 _ K (numbered_in _ _ _ Ek)) in H. lia. }
          exists j. split; [assumption|]. split; [assumption|].
          assert (N : nth_error (map spot K) j = Some (spot a)) by now apply map_nth_error.
          rewrite <- Vg in N. unfold vertices in N.
          rewrite (map_nth_error (vertex g) j (seq 0 4) (d := j)) in N; [congruence|].
          rewrite (nth_error_nth' _ 0%nat) by (rewrite seq_length; lia). now rewrite seq_nth by lia.
          }
      destruct Su as [S1 S2]. split.
      - intros y Iy. apply S1 in Iy. destruct Iy as [<-|Iy].
        + apply in_map, Mem. now left.
        + apply Facet, in_map_iff in Iy. destruct Iy as (a & <- & Ia). apply in_map, Mem. now right.
      - intros y Iy. apply in_map_iff in Iy. destruct Iy as (a & <- & Ia). apply Mem in Ia.
        apply S2.
        destruct Ia as [<-|Ia]; [now left|right]. apply Facet. now apply in_map. }
    destruct (chosen_frame m L u El Iu Sl) as (May & _).
    exists (true, m). split; [right; now apply in_map, filter_In|]. apply truth_chosen.
    now exists L, u.
Qed.
End Impossible.

(** Some mesh of the domain has nothing dangling. *)
Lemma some_solid x : check_impossible x = Accepted ->
  exists M, solid_triangulation (domain_of_certificate 3 (about x)) M.
Proof.
  intros A. destruct (parts x A) as (_ & Me & _). unfold check_mesh_of in Me.
  destruct (check_domain Space (as_steiner (some_mesh x))) eqn:C; [|discriminate].
  destruct (same_domain (about x) (some_mesh x)) eqn:Sa; [|discriminate].
  exists (mesh_of_domain 3 (some_mesh x)). apply (solid_of_same _ _ _ (same_domain_sound 3 _ _ Sa)).
  exact (DomainSound.check_domain_sound Space _ C).
Qed.
Theorem check_impossible_sound x K : check_impossible x = Accepted ->
  plc_triangulation (domain_of_certificate 3 (about x)) K ->
  (domain_claimed (about x) = Cdt -> cdt (domain_of_certificate 3 (about x)) K) -> False.
Proof.
  intros A Tr Cd. destruct (some_solid x A) as (M & HM).
  destruct (parts x A) as (_ & _ & _ & l & R & H).
  set (T := filter Covered.full K).
  apply (refuted_clauses_sound l (steps x) (truth x T) R). intros y Iy.
  destruct (H y Iy) as (s & _ & E).
  apply (reason_satisfied x A T) with s; [now apply solid_part_plc with M| |assumption].
  intros Cl. now apply (solid_part_cdt _ M HM K (Cd Cl)).
Qed.
