(** * The Constrained Delaunay Lemma, for the kept simplices  (Book: Lemma 4.10, (iii) => (i))

    If across each facet that is in no wall the neighbour's apex is not in the circumball, then no
    vertex that can be seen from inside a simplex is ([Sight.v]); and each simplex respects the
    domain, for its cells are unions of simplices. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Bool.
From Circumspect Require Import DomainChecker Numbering.
From Circumspect Require Import Vectors Affine Frame Matched Faces Facets Mesh LiftingMap
  DelaunayLemma.
From Circumspect Require Import Adjacency Enclosed Combinations Sight.
From Circumspect Require Import Orientation Integers Incidence Accepted CertifiedMesh Soundness.
From Circumspect Require Import KeptMesh KeptCells ConstrainedLemma Necessary DomainRules
  Definitions Domains Solid.
Import ListNotations.
Open Scope R_scope.

Section Constrained.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis Or : oriented orient.
Hypothesis Co : computes orient pr.
Hypothesis positive_d : (1 <= d)%nat.
Variable D : domain_certificate.
Notation c := (whole_mesh D).
Notation p := (domain_part D).
Hypothesis accepts : check_in pr c = Accepted.
Context {loose : bool}.
Variables (planar : bool) (shown : list positive -> nat -> positive * positive -> bool).
Hypothesis part_accepts : check_part pr loose planar (kind D) c p shown = Accepted.
Hypothesis local_accepts : check_local pr shown D = Accepted.
Notation r := (unit_of c).
Notation spot := (spot d c).
Notation entry t e := (numbered (simplices c) t = Some e).
Notation marks_of := (Table.of_list Datatypes.id (marks p)).
Notation T := (part_simplices d c p).
Let dim_d : dimension pr = d := computes_dimension _ _ Co.

Lemma local_parts : each_pair mark_consistent AtSimplex
  (check_local_simplex pr (mesh_of c)) 1 (simplices c) (marks p) = Accepted.
Proof. pose proof local_accepts as H. unfold check_local in H. destruct (kind D); now accepted. Qed.
(** Of a hull, too, a flag is shown. *)
Lemma hull_flag_shown t e i : kind D = Hull -> entry t e -> (i <= d)%nat ->
  flagged_at marks_of t i = true ->
  exists w, shown (corners e) i w = true.
Proof.
  intros K E Hi F. pose proof local_accepts as H. unfold check_local in H. rewrite K in H.
  destruct (each_pair _ _ (check_flags shown) _ _ _) eqn:Fl; [|discriminate]. clear H.
  destruct (wall_exists Co positive_d c accepts t e i E Hi) as (f & W).
  destruct (mark_of c p planar (kind D) shown part_accepts t e E) as (k & Ek & _).
  apply each_pair_accepted in Fl. destruct Fl as [_ Fl]. specialize (Fl t e k E Ek).
  unfold check_flags in Fl.
  apply (each_index_accepted _ _ Fl) in W. cbn beta in W. accepted.
  apply (wall_at_flag p t k i Ek) in F. destruct F as (w & Fw). rewrite Fw in *. now exists w.
Qed.

Section Geometry.
Variable geo : positive -> frame d.
Hypothesis frames : forall t e, entry t e -> lists (map spot (corners e)) (geo t).
Let agreeing := filling_agree _ _ _ (certificate_fills Or Co c accepts geo frames).
Let different := filling_different _ _ _ (certificate_fills Or Co c accepts geo frames).

Definition kept_tets : list positive := filter (kept_at marks_of) (tets c).
Lemma in_kept_tets t : In t kept_tets <-> In t (tets c) /\ kept_at marks_of t = true.
Proof. apply filter_In. Qed.
Let agreeing' : forall t u, In t kept_tets -> In u kept_tets -> agree (geo t) (geo u).
Proof. intros t u Ht Hu. apply in_kept_tets in Ht, Hu. now apply agreeing. Qed.
Let different' : forall t u, In t kept_tets -> In u kept_tets ->
  same (vertices (geo t)) (vertices (geo u)) -> t = u.
Proof. intros t u Ht Hu. apply in_kept_tets in Ht, Hu. now apply different. Qed.

Lemma heights k e : numbered (points c) k = Some e ->
  norm2 (spot k) = @height_of d r (site_at d c k).
Proof.
  intros E. rewrite (spot_site d c k e E). unfold height_of, site_at, site_of. rewrite E.
  destruct (part_parts c p planar (kind D) shown part_accepts) as (W & _). rewrite W. cbn [weight].
  ring.
Qed.

(** The facet is looked at from the simplex of the smaller number. *)
Lemma looked_at t i u j : adjacent kept_tets geo t i u j -> ~ wall_at p t i -> (t < u)%positive ->
  locally_above norm2 (geo t) (geo u) j.
Proof.
  intros (Ht & Hu & O) N Lt. apply in_kept_tets in Ht, Hu.
  destruct Ht as [Ht Kt], Hu as [Hu Ku]. pose proof O as (Hi & Hj & _).
  assert (A : adj c t i u j).
  { apply (adjacent_adj Or Co positive_d c accepts geo frames). split; [assumption|]. now split. }
  destruct A as (e & E & W).
  destruct (mark_of c p planar (kind D) shown part_accepts t e E) as (k & Ek & Kk & _).
  pose proof local_parts as L. apply each_pair_accepted in L. destruct L as [_ L].
  specialize (L t e k E Ek). unfold check_local_simplex in L. rewrite <- Kk, Kt in L.
  destruct (find_all (points_of (mesh_of c)) (corners e)) as [X|] eqn:FX; [|discriminate].
  apply (find_all_sites (d := d)) in FX. destruct FX as [-> _].
  apply (each_index_accepted _ _ L) in W. cbn [check_local_facet] in W.
  rewrite (wall_at_flag p t k i Ek) in N. destruct (flag k i) as [w|]; [destruct N; eauto|].
  apply Pos.ltb_lt in Lt. rewrite Lt in W. rewrite (find_simplex (c := c)) in W.
  apply in_tets in Hu. destruct Hu as (e' & E'). rewrite E' in W.
  destruct (corner_vertex Co c geo frames u e' j E' Hj) as (v & Ev & Vv). rewrite Ev in W. accepted.
  apply (find_point_site (d := d)) in Heqo. destruct Heqo as [<- (x & Ex)].
  unfold apex_outside in *. apply Z.leb_le, IZR_le in Heqb.
  unfold locally_above. rewrite Vv, (spot_site d c v x Ex).
  pose proof (heights v x Ex) as Hv. rewrite (spot_site d c v x Ex) in Hv.
  destruct (depth_witness Or Co c accepts geo frames norm2 heights t e (site_at d c v) E
    (site_shaped dim_d accepts v) Hv) as (q & Q & S).
  unfold sites_of in S. nra.
Qed.
Lemma never_itself t i j : ~ adjacent kept_tets geo t i t j.
Proof.
  intros (_ & _ & Hi & Hj & _ & _ & Neg). rewrite bary_vertex in Neg by assumption.
  destruct (Nat.eq_dec i j); lra.
Qed.

(** ** Of a hull *)

Theorem kept_constrained_hull (P : domain d) (V : list (point d)) : (2 <= d)%nat ->
  proper_domain P -> what_it_fills P = Hull ->
  solid_triangulation P T ->
  (forall t e i, entry t e -> (i <= d)%nat -> flagged_at marks_of t i = true ->
    exists X, In X (wall_cells P) /\ within (conv (map spot (Checker.remove i (corners e)))) X) ->
  (forall v, In v V <-> exists t, In t T /\ In v t) -> forall t, In t T ->
    constrained_delaunay V P t.
Proof.
  intros Two Pr K St Fl HV. apply (local_constrained_hull Two P T V Pr St HV K).
  intros f (Nf & Lf & _) NW s t Is It Fs Ft NS.
  apply (in_kept c p planar (kind D) shown part_accepts geo frames) in Is, It.
  destruct Is as (a & e & E & Ka & ->), It as (b & e' & E' & Kb & ->).
  rewrite <- (entry_vertices c geo frames a e E), <- (entry_vertices c geo frames b e' E') in *.
  destruct (facet_index (geo a) f Nf Lf Fs) as (i & Hi & Ei).
  destruct (facet_index (geo b) f Nf Lf Ft) as (j & Hj & Ej).
  assert (Ia : In a kept_tets) by (apply in_kept_tets; split; [apply in_tets; eauto|assumption]).
  assert (Ib : In b kept_tets) by (apply in_kept_tets; split; [apply in_tets; eauto|assumption]).
  assert (O : opposite (geo a) i (geo b) j).
  { apply (shared_facet kept_tets geo positive_d agreeing' different'); auto.
    - intros ->. apply NS. split; apply incl_refl.
    - destruct Ei, Ej. split; eauto using incl_tran. }
  assert (Free : forall u x l, entry u x -> (l <= d)%nat -> same f (facet_of (geo u) l) ->
    ~ wall_at p u l).
  { intros u x l Ex Hl El W. destruct (Fl u x l Ex Hl W) as (X & IX & In_). apply (NW X IX).
    intros q Cq. apply In_.
    apply (on_facet_entry Co positive_d c geo frames u x l q Ex Hl).
    apply on_facet_conv; [assumption..|].
    apply (conv_incl f); [apply El|assumption]. }
  assert (A : adjacent kept_tets geo a i b j) by (split; [assumption|now split]).
  assert (Above : locally_above norm2 (geo a) (geo b) j).
  { destruct (Pos.lt_total a b) as [Lt|[->|Gt]].
    - apply (looked_at a i b j A); [|assumption]. now apply (Free a e).
    - now apply never_itself in A.
    - apply (locally_above_symmetric norm2 (geo a) i (geo b) j O),
        (looked_at b j a i (adjacent_sym _ _ _ _ _ _ A)); [|assumption].
      now apply (Free b e'). }
  destruct (circumball_frame (geo a)) as (o & r2 & C & _). exists o, r2.
  split; [intros v Iv; apply C; auto|].
  intros v [Iv|Iv] L; [rewrite (C v Iv) in L; lra|]. apply in_vertices in Iv.
  destruct Iv as (k & Hk & ->).
  destruct (Nat.eq_dec k j) as [->|N].
  - apply (in_ball_below_witness _ _ _ _ C) in L. unfold locally_above in Above. lra.
  - rewrite C in L; [lra|]. apply Fs, Ej, in_facet_of; [assumption|]. eauto.
Qed.

(** ** Of what is enclosed *)

Hypothesis is_enclosed : kind D = Enclosed.
Lemma kept_outer_wall t i : In t kept_tets -> (i <= d)%nat -> outer kept_tets geo t i ->
  wall_at p t i.
Proof.
  intros Ht Hi O. apply in_kept_tets in Ht. destruct Ht as [Ht K].
  unfold wall_at. destruct (flagged_at marks_of t i) eqn:F; [reflexivity|exfalso].
  assert (N : ~ wall_at p t i) by (unfold wall_at; congruence).
  destruct (adjacent_dec (tets c) geo t i Ht) as [(u & j & A)|O'].
  - pose proof (same_across Or Co positive_d c accepts p planar (kind D) shown part_accepts geo
      frames
      is_enclosed t i u j A N) as S.
    destruct A as (_ & Hu & Op). apply (O u j). split; [now apply in_kept_tets|].
    split; [|assumption].
    apply in_kept_tets. split; [assumption|congruence].
  - apply N.
    now apply (kept_closed_off Or Co positive_d c accepts p planar (kind D) shown part_accepts
      geo frames is_enclosed).
Qed.

Lemma kept_local t i u j : In t kept_tets -> adjacent kept_tets geo t i u j -> ~ wall_at p t i ->
  locally_above norm2 (geo t) (geo u) j.
Proof.
  intros Ht A N. destruct (Pos.lt_total t u) as [Lt|[->|Gt]]; [now apply (looked_at t i u j)| |].
  - now apply never_itself in A.
  - pose proof A as (_ & _ & O). apply (locally_above_symmetric norm2 (geo t) i (geo u) j O).
    apply (looked_at u j t i); [now apply adjacent_sym| |assumption]. intros W. apply N.
    apply (wall_in_both Or Co positive_d c accepts p planar (kind D) shown part_accepts geo frames
      is_enclosed u j t i); [|assumption].
    apply adjacent_sym. destruct A as (Ht' & Hu & _). apply in_kept_tets in Ht', Hu. now split.
Qed.

(** What is visible is seen: the segment leaves neither the kept simplices nor meets a wall. *)
Lemma visible_sees (P : domain d) t x v :
  (forall q, walls_in c p geo q -> exists X, In X (cells P) /\ X q /\ forall y, X y ->
    walls_in c p geo y) ->
  In t kept_tets -> inside (geo t) x -> visible P x v ->
  sees kept_tets geo (wall_at p) x v.
Proof.
  intros Wa Ht I [Sub Resp]. pose proof Ht as Ht'. apply in_kept_tets in Ht'.
  destruct Ht' as [It Kt].
  assert (Off : forall s, 0 <= s < 1 -> ~ walls_in c p geo (mix x v s)).
  { intros s Hs W. assert (C : conv [x; v] (mix x v s)).
    { apply conv_two. exists s. split; [lra|reflexivity]. }
    destruct (Wa (mix x v s) W) as (X & IX & Xs & XW).
    assert (Off : forall y, inside (geo t) y -> ~ X y).
    { intros y Iy Xy. apply XW in Xy. destruct Xy as (b & k & Hb & Hk & _ & Z & Cl).
      assert (t = b) as <- by now apply (inside_once (tets c) geo agreeing different t b y).
      specialize (Iy k Hk). lra. }
    destruct (Resp X IX) as (F & HF & E).
    destruct (proj1 (E (mix x v s)) (conj Xs C)) as (f & If & Cf).
    assert (Fx : forall y, conv f y -> X y) by (intros y Cy; apply E; eauto).
    destruct (Faces.in_points x f) as [Ix|N].
    - apply (Off x I), Fx. now apply conv_point.
    - assert (Iv : incl f [v]).
      { intros y Hy. destruct (HF f If y Hy) as [<-|[<-|[]]]; [contradiction|now left]. }
      assert (Ev : mix x v s = v) by (apply conv_singleton; now apply (conv_incl f)).
      assert (x = v) as <-.
      { apply affine_separate. intros h A. pose proof (affine_mix h x v s A) as M. rewrite Ev in M.
        nra. }
      rewrite Ev in Cf. now apply (Off x I), Fx. }
  intros s Hs. split.
  - destruct (stays_inner (tets c) geo _ positive_d (certificate_fills Or Co c accepts geo frames)
      (wall_at p) (walls_in c p geo) (fun q => iff_refl _) (kept_at marks_of)
      (same_across Or Co positive_d c accepts p planar (kind D) shown part_accepts geo frames
        is_enclosed)
      (kept_closed_off Or Co positive_d c accepts p planar (kind D) shown part_accepts geo frames
        is_enclosed) x (mix x v s)) as (a & Ha & Ka & Ia).
    + intros q Hq W. change (between x (mix x v s) q) with (mix x (mix x v s) q) in W.
      rewrite mix_mix in W. revert W. apply Off. nra.
    + exists t. split; [assumption|]. split; [assumption|]. intros k Hk. left. now apply I.
    + exists a. split; [now apply in_kept_tets|assumption].
  - intros a i Ha Hi W O. apply in_kept_tets in Ha. apply (Off s Hs). exists a, i. tauto.
Qed.
(** So it is a vertex of a kept simplex, if it is one of the mesh. *)
Lemma seen_vertex x u i : In u (tets c) -> (i <= d)%nat ->
  sees kept_tets geo (wall_at p) x (vertex (geo u) i) -> vertex_of kept_tets geo (vertex (geo u) i).
Proof.
  intros Hu Hi See.
  destruct (towards geo (vertex (geo u) i) x kept_tets) as [(b & Hb & Ib & _)|(e & He & K)].
  - pose proof Hb as Hb'. apply in_kept_tets in Hb'. destruct Hb' as [Hb' _].
    assert (Iu : inside_closed (geo u) (vertex (geo u) i)).
    { intros k Hk. rewrite bary_vertex by assumption. destruct (Nat.eq_dec k i); lra. }
    destruct (agreeing u b Hu Hb' _ Iu Ib i Hi) as (k & Hk & E & _).
    { rewrite bary_own by assumption. lra. }
    exists b, k. auto.
  - destruct (See (1 - e)) as [(a & Ha & Ia) _]; [lra|]. rewrite mix_swap in Ia.
    replace (1 - (1 - e)) with e in Ia by ring. now destruct (K e ltac:(lra) a Ha).
Qed.

Theorem kept_constrained (P : domain d) (V : list (point d)) :
  (forall t, In t T -> respects P t /\ incl t V) ->
  (forall q, walls_in c p geo q -> exists X, In X (cells P) /\ X q /\ forall y, X y ->
    walls_in c p geo y) ->
  (forall v, In v V -> exists t i, In t (tets c) /\ (i <= d)%nat /\ v = vertex (geo t) i) ->
  forall t, In t T -> constrained_delaunay V P t.
Proof.
  intros Re Wa HV t It. split; [now apply Re|split; [now apply Re|]].
  apply (in_kept c p planar (kind D) shown part_accepts geo frames) in It.
  destruct It as (u & e & E & K & ->). rewrite <- (entry_vertices c geo frames u e E).
  destruct (circumball_frame (geo u)) as (o & r2 & C & _). exists o, r2.
  split; [assumption|].
  intros v x Iv Xi Vis L. apply strictly_inside_frame in Xi.
  apply (in_ball_below_witness _ _ _ _ C) in L. apply (Rlt_not_le _ _ L).
  assert (Hu : In u kept_tets) by (apply in_kept_tets; split; [apply in_tets; eauto|assumption]).
  pose proof (visible_sees P u x v Wa Hu Xi Vis) as See.
  apply (visible_vertex_above kept_tets geo positive_d agreeing' different'
    (wall_at p) kept_outer_wall
    norm2 kept_local u x v Hu (fun k Hk => Rlt_le _ _ (Xi k Hk))); [|assumption].
  destruct (HV v Iv) as (b & i & Hb & Hi & ->). now apply (seen_vertex x).
Qed.
End Geometry.
End Constrained.
