(** * The kept simplices of an accepted certificate

    The mesh of the whole hull fills it (Soundness.v); the kept simplices are a part of this
    complex. Here the conditions of DomainChecker.v are taken apart, and turned into statements
    about the kept simplices: which vertices and segments they contain, and what they fill. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Bool.
From Circumspect Require Import DomainChecker Numbering.
From Circumspect Require Export Lists.
From Circumspect Require Import Vectors Affine Frame Matched Faces Facets Mesh.
From Circumspect Require Import Adjacency Enclosed Combinations.
From Circumspect Require Import Orientation Integers Incidence Accepted CertifiedMesh Soundness.
From Circumspect Require Import Definitions Domains.
Import ListNotations.
Open Scope R_scope.

Section KeptMesh.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis Or : oriented orient.
Hypothesis Co : computes orient pr.
Hypothesis positive_d : (1 <= d)%nat.
Variable c : certificate.
Hypothesis accepts : check_in pr c = Accepted.
Variable p : part.
Context {loose : bool}.
Variables (planar : bool) (kind : domain_kind).
Variable shown : list positive -> nat -> positive * positive -> bool.
Hypothesis part_accepts : check_part pr loose planar kind c p shown = Accepted.

Notation r := (unit_of c).
Notation spot := (spot d c).
Notation m := (mesh_of c).
Notation entry t e := (numbered (simplices c) t = Some e).
Notation tets := (tets c).
Notation marks_of := (Table.of_list Datatypes.id (marks p)).
Notation roles_of := (Table.of_list Datatypes.id (roles p)).
Notation holes_of := (Table.of_list Datatypes.id (holes p)).
Notation T := (part_simplices d c p).
Let dim_d : dimension pr = d := computes_dimension _ _ Co.


(** ** The conditions *)

Lemma part_parts : weights_of (claimed c) = false /\
  each_pair role_shown AtPoint (check_role pr m loose kind roles_of marks_of) 1 (points c)
    (roles p) = Accepted /\
  each (check_segment m loose planar kind roles_of marks_of) 1 (segments p) = Accepted /\
  each (check_hole pr m marks_of (simplices c) (marks p)) 1 (holes p) = Accepted /\
  each_pair mark_consistent AtSimplex (check_mark loose kind holes_of marks_of shown) 1
    (simplices c) (marks p) = Accepted.
Proof.
  pose proof part_accepts as H. unfold check_part in H. cbv zeta in H. accepted.
  apply negb_true_iff in Heqb. auto.
Qed.
Lemma mark_of t e : entry t e -> exists k, numbered (marks p) t = Some k /\
  kept_at marks_of t = kept k /\ check_mark loose kind holes_of marks_of shown t e k = Accepted.
Proof.
  intros E. destruct part_parts as (_ & _ & _ & _ & H). apply each_pair_accepted in H.
  destruct H as [L H]. destruct (numbered_beside _ _ _ _ L E) as (k & K). exists k.
  split; [assumption|]. split; [|now apply H]. unfold kept_at. now rewrite find_id, K.
Qed.
Lemma kept_is_entry t : kept_at marks_of t = true -> exists e, entry t e.
Proof.
  unfold kept_at. rewrite find_id. destruct (numbered (marks p) t) as [k|] eqn:K; [|discriminate].
  intros _. destruct part_parts as (_ & _ & _ & _ & H). apply each_pair_accepted in H.
  destruct H as [L _]. symmetry in L. exact (numbered_beside _ _ _ _ L K).
Qed.
Lemma point_known k q : Table.find k (points_of m) = Some q ->
  spot k = place_of r q /\ well_shaped d q /\ q = site_at d c k.
Proof.
  intros E. apply (find_point_site (d := d)) in E. destruct E as (<- & e & E).
  split; [now apply spot_site with e|]. split; [now apply (site_shaped dim_d accepts)|reflexivity].
Qed.

Section Geometry.
Variable geo : positive -> frame d.
Hypothesis frames : forall t e, entry t e -> lists (map spot (corners e)) (geo t).

Let mesh := certificate_matched Or Co c accepts geo frames.
Let once := certificate_covered_once Or Co c accepts geo frames.
Let supporting_all := certificate_supporting Or Co c accepts geo frames.
Let vertices_all := vertices_in Co c accepts geo frames.
Let agreeing : forall t u, In t tets -> In u tets -> agree (geo t) (geo u) :=
  fun t u => mesh_face_to_face mesh vertices_all supporting_all Pos.eq_dec once t u.
Let different : forall t u, In t tets -> In u tets ->
  same (vertices (geo t)) (vertices (geo u)) -> t = u :=
  fun t u => mesh_simplices_different mesh vertices_all supporting_all Pos.eq_dec once t u.
Notation V := (points_of_certificate d c).

Lemma some_tets : tets <> [].
Proof. pose proof (proj1 once) as H. intros E. now rewrite E in H. Qed.
Lemma in_V t : In t tets -> incl (vertices (geo t)) V.
Proof. intros Ht v Hv. apply in_vertices in Hv. destruct Hv as (i & Hi & ->). auto. Qed.
Lemma covering q : conv V q -> exists t, In t tets /\ inside_closed (geo t) q.
Proof.
  intros C. apply (mesh_covers mesh vertices_all supporting_all q some_tets).
  intros t i Ht Hi H. apply (affine_conv (bary (geo t) i) V); [now apply bary_affine| |assumption].
  intros v Hv. now apply (supporting_all t i Ht Hi H).
Qed.

Lemma certificate_fills : filling tets geo V.
Proof.
  exact {| filling_agree := agreeing; filling_different := different; filling_in := in_V;
           filling_covers := covering; filling_some := some_tets |}.
Qed.

Lemma entry_vertices t e : entry t e -> vertices (geo t) = map spot (corners e).
Proof. intros E. apply lists_vertices. now apply frames. Qed.
Lemma corner_spots t e k j : entry t e -> In k (corners e) -> In j (corners e) -> k <> j ->
  spot k <> spot j.
Proof.
  intros E K J N S. apply In_nth_error in K, J. destruct K as (a & A), J as (b & B).
  destruct (frames t e E) as (L & F). rewrite map_length in L.
  assert (Ha : (a <= d)%nat). { assert (X : nth_error (corners e) a <> None) by congruence.
    apply nth_error_Some in X. lia. }
  assert (Hb : (b <= d)%nat). { assert (X : nth_error (corners e) b <> None) by congruence.
    apply nth_error_Some in X. lia. }
  assert (a = b); [|congruence].
  apply (vertex_inj (geo t)); try assumption.
  pose proof (F a Ha) as Fa. pose proof (F b Hb) as Fb.
  rewrite (map_nth_error spot a _ A) in Fa. rewrite (map_nth_error spot b _ B) in Fb. congruence.
Qed.

(** ** The kept simplices are a complex *)

Lemma kept_list : T = map (fun t => vertices (geo t)) (filter (kept_at marks_of) tets).
Proof.
  unfold part_simplices, CertifiedMesh.tets.
  apply (flat_map_kept (fun e => map spot (corners e)) kept (fun t => vertices (geo t))
    (kept_at marks_of)).
  - destruct part_parts as (_ & _ & _ & _ & H). now apply each_pair_accepted in H.
  - intros k e E. now apply entry_vertices.
  - intros k b E. unfold kept_at. now rewrite find_id, E.
Qed.
Lemma in_kept s : In s T <-> exists t e, entry t e /\ kept_at marks_of t = true /\
  s = map spot (corners e).
Proof.
  rewrite kept_list, in_map_iff. split.
  - intros (t & <- & I). apply filter_In in I. destruct I as [I K]. apply in_tets in I.
    destruct I as (e & E). exists t, e. rewrite (entry_vertices t e E). auto.
  - intros (t & e & E & K & ->). exists t. split; [now apply entry_vertices|].
    apply filter_In. split; [|assumption]. apply in_tets. eauto.
Qed.
Lemma kept_complex_in : (forall t, In t T -> NoDup t /\ length t = S d) /\
  ForallOrdPairs (fun s t => ~ same s t) T /\ simplicial_complex (faces_of T).
Proof.
  assert (F : forall t, In t (filter (kept_at marks_of) tets) -> In t tets).
  { intros t I. now apply filter_In in I. }
  rewrite kept_list. split; [|split].
  - apply simplices_length.
  - apply simplices_different; [apply NoDup_filter, numbers_NoDup|]. auto.
  - apply frames_complex. auto.
Qed.

Lemma facet_entry t e i : entry t e -> (i <= d)%nat ->
  same (facet_of (geo t) i) (map spot (Checker.remove i (corners e))).
Proof.
  intros E Hi. destruct (frames t e E) as (L & F). split; intros v Hv.
  - apply in_facet_of in Hv; [|assumption]. destruct Hv as (k & Hk & N & ->).
    destruct (corner_vertex Co c geo frames t e k E Hk) as (x & X & ->).
    apply in_map, in_remove. eauto.
  - apply in_map_iff in Hv. destruct Hv as (x & <- & I). apply in_remove in I.
    destruct I as (k & N & X). apply in_facet_of; [assumption|].
    assert (Hk : (k <= d)%nat). { rewrite map_length in L.
      assert (Y : nth_error (corners e) k <> None) by congruence. apply nth_error_Some in Y. lia. }
    exists k. repeat (split; [assumption|]). pose proof (F k Hk) as Fk.
    rewrite (map_nth_error spot k _ X) in Fk. congruence.
Qed.
Lemma on_facet_conv t i q : (i <= d)%nat -> on_facet geo t i q <-> conv (facet_of (geo t) i) q.
Proof.
  intros Hi. rewrite (conv_face (geo t) _ q (facet_of_incl (geo t) i Hi)). split.
  - intros [Z I]. split; [assumption|]. intros k Hk P. apply in_facet_of; [assumption|].
    exists k. repeat split; try assumption. intros ->. lra.
  - intros [I P]. split; [|assumption]. specialize (I i Hi).
    destruct (Rle_lt_or_eq_dec _ _ I) as [L|E]; [exfalso|now symmetry].
    now apply (not_in_facet_of (geo t) i Hi), P.
Qed.
Lemma on_facet_entry t e i q : entry t e -> (i <= d)%nat ->
  on_facet geo t i q <-> conv (map spot (Checker.remove i (corners e))) q.
Proof.
  intros E Hi. rewrite (on_facet_conv t i q Hi). apply conv_same. now apply facet_entry.
Qed.

(** ** Adjacency is what the certificate says *)

Lemma adjacent_adj t i u j : adjacent tets geo t i u j <-> adj c t i u j.
Proof.
  split.
  - intros (Ht & Hu & O). pose proof O as (Hi & Hj & _).
    destruct (matched_or_hull _ _ _ _ mesh t i Ht Hi) as [(u' & j' & A)|H].
    + pose proof (matched_in _ _ _ _ mesh t i u' j' Ht A) as Hu'.
      pose proof (matched_opposite _ _ _ _ mesh t i u' j' Ht A) as O'.
      assert (u = u').
      { apply (one_neighbour tets geo positive_d agreeing different u j u' j' t i Hu Hu');
          now apply opposite_sym. }
      subst u'. assert (Ej : j = j'); [|rewrite Ej; exact A].
      destruct (Nat.eq_dec j j') as [|N]; [assumption|exfalso].
      pose proof O' as (_ & Hj' & _). apply opposite_facets in O, O'.
      destruct O as (_ & _ & [S1 S2] & _), O' as (_ & _ & [S1' S2'] & _).
      apply (not_in_facet_of (geo u) j Hj). apply S1, S2'. apply in_facet_of; [assumption|].
      exists j. auto.
    + exfalso. pose proof O as (_ & _ & _ & _ & N).
      pose proof (supporting_all t i Ht Hi H (vertex (geo u) j) (vertices_all u j Hu Hj)). lra.
  - intros A. assert (Ht : In t tets).
    { destruct A as (e & E & _). apply in_tets. eauto. }
    split; [assumption|]. split; [now apply (matched_in _ _ _ _ mesh t i u j)|].
    now apply (matched_opposite _ _ _ _ mesh).
Qed.
Lemma outer_on_hull t i : In t tets -> (i <= d)%nat -> outer tets geo t i <-> on_hull c t i.
Proof.
  intros Ht Hi. split.
  - intros O. destruct (matched_or_hull _ _ _ _ mesh t i Ht Hi) as [(u & j & A)|H]; [|assumption].
    apply adjacent_adj in A. now apply O in A.
  - intros H u j A. apply adjacent_adj in A. destruct A as (e & E & W).
    unfold on_hull in H. now rewrite E, W in H.
Qed.

(** ** Walls *)

Definition wall_at (t : positive) (i : nat) : Prop := flagged_at marks_of t i = true.
Definition walls_in (q : point d) : Prop := exists t i, In t tets /\ (i <= d)%nat /\ wall_at t i /\
  on_facet geo t i q.

Lemma wall_at_flag t k i : numbered (marks p) t = Some k ->
  (wall_at t i <-> exists w, flag k i = Some w).
Proof.
  intros K. unfold wall_at, flagged_at. rewrite find_id, K. destruct (flag k i) as [w|].
  - split; eauto.
  - split; [discriminate|]. intros (w & W). discriminate.
Qed.

Lemma walls_in_dec q : walls_in q \/ ~ walls_in q.
Proof.
  destruct (finite_dec (fun ti => wall_at (fst ti) (snd ti) /\ on_facet geo (fst ti) (snd ti) q)
    (flat_map (fun t => map (pair t) (seq 0 (S d))) tets)) as [((t & i) & I & W & O)|N].
  - intros (t, i) _. cbn [fst snd]. unfold wall_at.
    destruct (flagged_at marks_of t i); [|right; intros [X _]; discriminate].
    unfold on_facet. destruct (Req_EM_T (bary (geo t) i q) 0) as [Z|Z]; [|right; tauto].
    destruct (Forall_dec (fun k => 0 <= bary (geo t) k q) (fun k => Rle_dec _ _) (seq 0 (S d)))
      as [F|F]; rewrite Forall_forall in F.
    + left. repeat split; auto. intros k Hk. apply F. now apply in_seq_d.
    + right. intros (_ & _ & I). apply F. intros k Hk. apply I. now apply in_seq_d.
  - left. apply in_flat_map in I. destruct I as (a & Ha & I). apply in_map_iff in I.
    destruct I as (k & E & Hk). injection E as <- <-. apply in_seq_d in Hk. exists a, k. auto.
  - right. intros (t & i & Ht & Hi & W & O). apply N. exists (t, i). split; [|auto].
    apply in_flat_map. exists t. split; [assumption|]. apply in_map. now apply in_seq_d.
Qed.

Section Enclosed.
Hypothesis is_enclosed : kind = Enclosed.

(** What the marks of a simplex and of its neighbour are. *)
Lemma facet_checked t e i f : entry t e -> nth_error (walls e) i = Some f -> exists k,
  numbered (marks p) t = Some k /\ kept_at marks_of t = kept k /\
    consistent loose marks_of k i f = true /\
  DomainChecker.gets_out holes_of marks_of t e k = true /\
  (forall w, flag k i = Some w -> shown (corners e) i w = true).
Proof.
  intros E W. destruct (mark_of t e E) as (k & K & Kt & Ck). exists k.
  split; [assumption|]. split; [assumption|].
  unfold check_mark in Ck. rewrite is_enclosed in Ck. accepted.
  apply (each_index_accepted _ _ Ck) in W. unfold check_facet in W. accepted.
  split; [assumption || reflexivity|]. split; [assumption || reflexivity|].
  intros w Fw. now rewrite Fw in Heqb1.
Qed.
Lemma wall_exists t e i : entry t e -> (i <= d)%nat -> exists f, nth_error (walls e) i = Some f.
Proof.
  intros E Hi. destruct (simplex_accepted dim_d accepts t e E) as (_ & _ & L & _).
  destruct (nth_error (walls e) i) as [f|] eqn:W; [eauto|]. apply nth_error_None in W. lia.
Qed.
Lemma across_checked t i u j : adj c t i u j -> exists k k', numbered (marks p) t = Some k /\
  numbered (marks p) u = Some k' /\ kept_at marks_of t = kept k /\ kept_at marks_of u = kept k' /\
  match flag k i, flag k' j with
  | Some _, Some _ => loose || kept k || kept k'
  | None, None => Bool.eqb (kept k) (kept k')
  | _, _ => false
  end = true.
Proof.
  intros (e & E & W). destruct (facet_checked t e i _ E W) as (k & K & Kt & C & _).
  cbn [consistent] in C. rewrite find_id in C.
  destruct (numbered (marks p) u) as [k'|] eqn:K'; [|discriminate]. exists k, k'.
  split; [assumption|]. split; [reflexivity|]. split; [assumption|]. split; [|assumption].
  unfold kept_at. now rewrite find_id, K'.
Qed.

Lemma wall_in_both t i u j : adjacent tets geo t i u j -> wall_at t i -> wall_at u j.
Proof.
  intros A W. apply adjacent_adj in A.
  destruct (across_checked t i u j A) as (k & k' & K & K' & _ & _ & C).
  apply (wall_at_flag t k i K) in W. destruct W as (w & F). rewrite F in C.
  apply (wall_at_flag u k' j K'). destruct (flag k' j) as [w'|]; [eauto|discriminate].
Qed.
Lemma same_across t i u j : adjacent tets geo t i u j -> ~ wall_at t i ->
  kept_at marks_of t = kept_at marks_of u.
Proof.
  intros A N. apply adjacent_adj in A.
  destruct (across_checked t i u j A) as (k & k' & K & K' & Kt & Ku & C). rewrite Kt, Ku.
  rewrite (wall_at_flag t k i K) in N. destruct (flag k i) as [w|]; [destruct N; eauto|].
  destruct (flag k' j); [discriminate|]. now apply Bool.eqb_prop.
Qed.
Lemma kept_closed_off t i : In t tets -> (i <= d)%nat -> outer tets geo t i ->
  kept_at marks_of t = true -> wall_at t i.
Proof.
  intros Ht Hi O Kp. apply (outer_on_hull t i Ht Hi) in O. apply on_hull_spec in O.
  destruct O as (e & h & E & W). destruct (facet_checked t e i _ E W) as (k & K & Kt & C & _).
  apply (wall_at_flag t k i K). cbn [consistent] in C.
  destruct (flag k i) as [w|]; [eauto|]. rewrite <- Kt, Kp in C. discriminate.
Qed.

(** A wall has a kept simplex beside it, if nothing dangles. *)
Lemma walls_kept q : loose = false -> walls_in q ->
  exists t, In t tets /\ kept_at marks_of t = true /\ inside_closed (geo t) q.
Proof.
  intros Tight (t & i & Ht & Hi & W & Z & I). pose proof Ht as Ht'. apply in_tets in Ht'.
  destruct Ht' as (e & E). destruct (wall_exists t e i E Hi) as (f & F).
  destruct (facet_checked t e i f E F) as (k & K & Kt & C & _).
  apply (wall_at_flag t k i K) in W. destruct W as (w & Fw).
  destruct f as [u j|h].
  - assert (A : adj c t i u j) by now exists e.
    destruct (across_checked t i u j A) as (k1 & k' & K1 & K' & _ & Ku & C').
    assert (k1 = k) by congruence. subst k1. rewrite Fw in C'.
    destruct (flag k' j); [|discriminate]. rewrite Tight in C'. apply orb_prop in C'.
    destruct C' as [C'|C'].
    + exists t. rewrite Kt. auto.
    + apply adjacent_adj in A. pose proof A as (_ & Hu & O). exists u. rewrite Ku.
      split; [assumption|]. split; [assumption|]. apply opposite_facets in O.
      destruct O as (_ & Hj & S & _).
      apply (on_facet_conv u j q Hj). apply (conv_same _ _ q S). now apply on_facet_conv.
  - cbn [consistent] in C. rewrite Fw, Tight in C. exists t. rewrite Kt. auto.
Qed.

Lemma all_sides_spec f h X : all_sides pr f (S (dimension pr)) X h = true ->
  forall i, (i <= d)%nat -> f (side pr i X (hole_point h) (hole_w h)) = true.
Proof.
  rewrite dim_d.
  assert (G : forall n, all_sides pr f n X h = true -> forall i, (i < n)%nat ->
    f (side pr i X (hole_point h) (hole_w h)) = true).
  { induction n as [|n IH]; intros Q i Hi; [lia|]. cbn [all_sides] in Q. apply andb_prop in Q.
    destruct Q as [Q Q']. destruct (Nat.eq_dec i n) as [->|N]; [exact Q|apply IH; auto; lia]. }
  intros Q i Hi. apply (G _ Q). lia.
Qed.
Lemma all_sides_intro f h X : (forall i, (i <= d)%nat ->
    f (side pr i X (hole_point h) (hole_w h)) = true) ->
      all_sides pr f (S (dimension pr)) X h = true.
Proof.
  rewrite dim_d. intros H. assert (G : forall n, (n <= S d)%nat -> all_sides pr f n X h = true).
  { induction n as [|n IH]; intros L; [reflexivity|]. cbn [all_sides]. rewrite H by lia.
    rewrite IH by lia. reflexivity. }
  apply G. lia.
Qed.
Lemma off_facets_spec e X h : off_facets pr e (S (dimension pr)) X h = true ->
  forall i w, (i <= d)%nat ->
  flag e i = Some w -> side pr i X (hole_point h) (hole_w h) = 0%Z -> closed_in pr X h = false.
Proof.
  rewrite dim_d.
  assert (G : forall n, off_facets pr e n X h = true -> forall i w, (i < n)%nat ->
    flag e i = Some w -> side pr i X (hole_point h) (hole_w h) = 0%Z -> closed_in pr X h = false).
  { induction n as [|n IH]; intros Q i w Hi F Z0; [lia|]. cbn [off_facets] in Q.
    apply andb_prop in Q.
    destruct Q as [Q Q']. destruct (Nat.eq_dec i n) as [->|N]; [|apply (IH Q' i w); auto; lia].
    rewrite F, Z0 in Q. cbn [Z.eqb andb] in Q. now apply negb_true_iff in Q. }
  intros Q i w Hi. apply (G _ Q i w). lia.
Qed.
Lemma off_walls_spec h l l' t s e : off_walls pr m h l l' = true -> numbered l t = Some s ->
  numbered l' t = Some e -> exists X, find_all (points_of m) (corners s) = Some X /\
    off_facets pr e (S (dimension pr)) X h = true.
Proof.
  unfold numbered. generalize (pred (Pos.to_nat t)) as j. clear. revert l'.
  induction l as [|x l IH]; intros [|y l'] [|j] O N N'; try discriminate; cbn [off_walls] in O;
    destruct (find_all (points_of m) (corners x)) as [X|] eqn:F; try discriminate;
    apply andb_prop in O; destruct O as [O1 O2].
  - injection N as <-. injection N' as <-. eauto.
  - eapply IH; eassumption.
Qed.
Lemma hole_checked n h : numbered (holes p) n = Some h ->
  kept_at marks_of (hole_simplex h) = false /\ In (hole_simplex h) tets /\
  inside_closed (geo (hole_simplex h)) (seed_point d c (hole_point h) (hole_w h)) /\
  ~ walls_in (seed_point d c (hole_point h) (hole_w h)).
Proof.
  intros E. destruct part_parts as (_ & _ & _ & H & _). apply (each_accepted _ _ H) in E.
  unfold check_hole in E. accepted.
  repeat (apply andb_prop in Heqb; let K := fresh in destruct Heqb as [Heqb K]).
  apply negb_true_iff in Heqb. apply Z.ltb_lt in H1.
  unfold shaped in H2. apply Nat.eqb_eq in H2. rewrite dim_d in H2.
  rewrite (find_simplex (c := c)) in H0.
  destruct (numbered (simplices c) (hole_simplex h)) as [e|] eqn:Es; [|discriminate].
  assert (Ht : In (hole_simplex h) tets) by (apply in_tets; eauto).
  split; [assumption|]. split; [assumption|].
  destruct (find_all (points_of m) (corners e)) as [X|] eqn:Fa; [|discriminate].
  apply (find_all_sites (d := d)) in Fa. destruct Fa as [-> _].
  set (q := seed_point d c (hole_point h) (hole_w h)).
  assert (Side : forall t e' i, entry t e' -> (i <= d)%nat -> exists a, 0 < a /\
    IZR (side pr i (map (site_at d c) (corners e')) (hole_point h) (hole_w h)) = a * bary
      (geo t) i q).
  { intros t e' i E' Hi.
    exact (side_bary Or Co c accepts geo frames t e' i (hole_point h) (hole_w h) E' Hi H2 H1). }
  apply orb_prop in H0. destruct H0 as [H0|H0].
  - assert (Is : inside (geo (hole_simplex h)) q).
    { intros i Hi. pose proof (all_sides_spec _ _ _ H0 i Hi) as S. apply Z.ltb_lt, IZR_lt in S.
      destruct (Side _ e i Es Hi) as (a & A & Eq). nra. }
    split; [intros i Hi; left; now apply Is|]. intros (t & i & It & Hi & _ & Z0 & C).
    pose proof (inside_once tets geo agreeing different (hole_simplex h) t q Ht It Is C) as Eq.
    specialize (Is i Hi). rewrite Eq in Is. lra.
  - apply andb_prop in H0. destruct H0 as [Cl Off]. split.
    + intros i Hi. pose proof (all_sides_spec _ _ _ Cl i Hi) as S. apply Z.leb_le, IZR_le in S.
      destruct (Side _ e i Es Hi) as (a & A & Eq). nra.
    + intros (t & i & It & Hi & W & Z0 & C). apply in_tets in It. destruct It as (e' & E').
      destruct (mark_of t e' E') as (k & K & _).
      destruct (off_walls_spec h _ _ _ _ _ Off E' K) as (X & Fx & Of).
      apply (find_all_sites (d := d)) in Fx. destruct Fx as [-> _].
      apply (wall_at_flag t k i K) in W. destruct W as (w & F).
      assert (S0 : side pr i (map (site_at d c) (corners e')) (hole_point h) (hole_w h) = 0%Z).
      { destruct (Side t e' i E' Hi) as (a & _ & Eq). rewrite Z0, Rmult_0_r in Eq.
        now apply eq_IZR in Eq. }
      pose proof (off_facets_spec k _ h Of i w Hi F S0) as N. unfold closed_in in N.
      rewrite all_sides_intro in N; [discriminate|]. intros l Hl. apply Z.leb_le, le_IZR.
      destruct (Side t e' l E' Hl) as (a & A & ->). specialize (C l Hl). nra.
Qed.

Definition rank_of (t : positive) : nat :=
  match numbered (marks p) t with Some k => Pos.to_nat (rank k) | None => 0 end.

Theorem enclosed_walls q :
  enclosed (fun _ => True) walls_in (part_holes d c p) q <-> walls_in q \/
  exists t, In t tets /\ kept_at marks_of t = true /\ inside_closed (geo t) q.
Proof.
  rewrite (enclosed_inner tets geo V positive_d certificate_fills
    wall_at walls_in (fun q => iff_refl _) walls_in_dec wall_in_both (kept_at marks_of) same_across
    kept_closed_off (part_holes d c p)) with (rank := rank_of).
  - reflexivity.
  - intros x Hx. apply in_map_iff in Hx. destruct Hx as (h & <- & I). apply in_numbered in I.
    destruct I as (n & N). destruct (hole_checked n h N) as (K & It & Is & Off).
    split; [assumption|]. exists (hole_simplex h). auto.
  - intros t Ht Kf. apply in_tets in Ht. destruct Ht as (e & E).
    destruct (mark_of t e E) as (k & K & Kt & Ck). unfold check_mark in Ck.
    rewrite is_enclosed in Ck.
    accepted. unfold DomainChecker.gets_out in Heqb. rewrite <- Kt, Kf in Heqb. cbn [orb] in Heqb.
    assert (Open : forall i, match flag k i with Some _ => false | None => true end = true ->
      ~ wall_at t i).
    { intros i O. rewrite (wall_at_flag t k i K). intros (w & W). now rewrite W in O. }
    destruct (way_out k) as [h|i|i].
    + rewrite find_id in Heqb. destruct (numbered (holes p) h) as [x|] eqn:X; [|discriminate].
      apply Pos.eqb_eq in Heqb. destruct (hole_checked h x X) as (_ & _ & Is & _).
      rewrite Heqb in Is.
      left. exists (seed_point d c (hole_point x) (hole_w x)). split; [|assumption].
      apply (in_map (fun h => seed_point d c (hole_point h) (hole_w h))).
      now apply numbered_in with h.
    + apply andb_prop in Heqb. destruct Heqb as [O W].
      destruct (nth_error (walls e) i) as [[|h]|] eqn:Ew; try discriminate.
      assert (Hi : (i <= d)%nat) by (apply (wall_index Co c accepts t e); [assumption|congruence]).
      right. left. exists i. split; [assumption|]. split; [|now apply Open].
      apply outer_on_hull; [apply in_tets; eauto|assumption|]. unfold on_hull. now rewrite E, Ew.
    + apply andb_prop in Heqb. destruct Heqb as [O W].
      destruct (nth_error (walls e) i) as [[u j|]|] eqn:Ew; try discriminate.
      rewrite find_id in W. destruct (numbered (marks p) u) as [k'|] eqn:K'; [|discriminate].
      apply Pos.ltb_lt in W. right. right. exists i, u, j. split; [|split; [now apply Open|]].
      * apply adjacent_adj. now exists e.
      * unfold rank_of. rewrite K, K'. lia.
Qed.
Theorem enclosed_kept q : loose = false ->
  enclosed (fun _ => True) walls_in (part_holes d c p) q <->
  exists t, In t tets /\ kept_at marks_of t = true /\ inside_closed (geo t) q.
Proof.
  intros Tight. rewrite enclosed_walls.
  split; [intros [W|I]; [now apply walls_kept|assumption]|now right].
Qed.
End Enclosed.
End Geometry.
End KeptMesh.
