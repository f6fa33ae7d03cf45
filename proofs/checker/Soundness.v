(** * Soundness: what the acceptance of a certificate means

    The mesh of the certificate is matched, with a hull that is locally convex; so its hull facets
    support all points ([Hull.v]) and it fills conv S ([Mesh.v]); with the last condition,
    [facet-locally-delaunay], it is Delaunay ([DelaunayLemma.v]).  The theorem is
    [check_sound], at the end. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith.
From Circumspect Require Import Checker Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Matched Hull LiftingMap.
From Circumspect Require Import DelaunayLemma Orientation Integers Incidence Accepted.
From Circumspect Require Import CertifiedMesh.
Import ListNotations.
Open Scope R_scope.

(** ** The caller's points are a set *)

Lemma place_inj {d} (r : R) s s' : r <> 0 -> well_shaped d s -> well_shaped d s' ->
  @place_of d r s = place_of r s' -> coordinates s = coordinates s'.
Proof.
  unfold well_shaped, place_of, scale. intros N. revert s s'.
  assert (G : forall d l l', length l = d -> length l' = d ->
    Vector.map (Rmult r) (integer_point d l) = Vector.map (Rmult r) (integer_point d l') -> l = l').
  { clear d. induction d as [|d IH]; intros [|x l] [|y l'] L L' E; try discriminate; auto.
    cbn in E. apply Vector.cons_inj in E. destruct E as [E F].
    apply Rmult_eq_reg_l in E; [|assumption]. apply eq_IZR in E. subst y. f_equal.
    apply IH; auto. }
  intros s s'. apply G.
Qed.

Section Points.
Context {d : nat} {pr : predicates} {c : certificate}.
Hypothesis dimension_d : dimension pr = d.
Hypothesis accepts : check_in pr c = Accepted.

Theorem points_distinct : NoDup (points_of_certificate d c).
Proof.
  destruct (points_shaped_distinct dimension_d accepts) as [F N].
  pose proof (unit_positive accepts).
  unfold points_of_certificate. induction (points c) as [|e l IH]; cbn in *; constructor.
  - inversion_clear F. inversion_clear N. intros I. apply in_map_iff in I.
    destruct I as (e' & E & I). apply H2. apply in_map_iff. exists e'. split; [|assumption].
    rewrite Forall_forall in H1. apply (@place_inj d (unit_of c)); auto; lra.
  - inversion_clear F. inversion_clear N. auto.
Qed.

(** There are such weights, since no point is listed twice. *)
Theorem weights_exist : exists w, weights_given d c w.
Proof.
  pose proof points_distinct as N. unfold weights_given. unfold points_of_certificate in N.
  set (f e := @place_of d (unit_of c) (position e)) in *.
  set (g e := unit_of c ^ 2 * IZR (weight (position e))).
  change (exists w, forall e, In e (points c) -> w (f e) = g e).
  induction (points c) as [|e l IH]; [exists (fun _ => 0); intros e []|].
  cbn in N. inversion_clear N. destruct (IH H0) as (w & W).
  assert (Z : forall p q : point d, dist2 p q = 0 <-> p = q).
  { intros p q. split.
    - intros E. apply norm2_zero in E. rewrite <- (minus_plus p q), E. apply origin_plus.
    - intros ->. unfold dist2. rewrite minus_self. unfold norm2. apply inner_origin. }
  exists (fun p => if Req_EM_T (dist2 p (f e)) 0 then g e else w p).
  intros e' [<-|I]; destruct (Req_EM_T _ 0) as [E|E]; auto.
  - destruct E. now apply Z.
  - apply Z in E. destruct H. rewrite <- E. now apply in_map.
Qed.
End Points.

(** ** The theorem, for either dimension *)

Section Soundness.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis Or : oriented orient.
Hypothesis Co : computes orient pr.
Variable c : certificate.
Hypothesis accepts : check_in pr c = Accepted.

Notation r := (unit_of c).
Notation spot := (spot d c).
Notation entry t e := (numbered (simplices c) t = Some e).
Notation tets := (tets c).
Notation adj := (adj c).
Notation points_of_c := (points_of_certificate d c).
Let dim_d : dimension pr = d := computes_dimension _ _ Co.

Section Geometry.
Variable geo : positive -> frame d.
Hypothesis frames : forall t e, entry t e -> lists (map spot (corners e)) (geo t).
Let mesh := certificate_matched Or Co c accepts geo frames.
Let once := certificate_covered_once Or Co c accepts geo frames.

(** [point-used]: every point is a vertex or submerged in a closed simplex. *)
Lemma point_cases p : In p points_of_c -> vertex_of tets geo p \/
  (weights_of (claimed c) = true /\ exists k e t s, numbered (points c) k = Some e /\
     p = place_of r (position e) /\ entry t s /\ inside_closed (geo t) p /\
     (depth pr (sites_of (d := d) (c := c) s) (slope pr (sites_of (d := d) (c := c) s))
        (position e) <= 0)%Z).
Proof.
  intros I. apply in_points in I. destruct I as (k & e & E & ->).
  destruct (point_accepted dim_d accepts k e E) as (s & Es & [K|(Cl & In_s & D)]).
  - left. rewrite <- (spot_numbered d c k e E). apply (in_map spot) in K.
    apply (lists_in _ (geo (home e)) _ (frames _ _ Es)) in K. destruct K as (i & Hi & V).
    exists (home e), i. split; [apply in_tets; eauto|auto].
  - right. split; [assumption|]. exists k, e, (home e), s. repeat (split; [auto|]); [|assumption].
    intros i Hi.
    assert (Sh : well_shaped d (position e)).
    { pose proof (site_shaped dim_d accepts k) as Sh. unfold site_at in Sh. rewrite E in Sh.
      unfold well_shaped in *. now rewrite coordinates_site_of in Sh. }
    destruct (side_bary Or Co c accepts geo frames (home e) s i (position e) 1 Es Hi Sh ltac:(lia))
      as (q & Q & S).
    specialize (In_s i Hi). apply IZR_le in In_s. replace (r / 1) with r in S by field. nra.
Qed.
Lemma point_in_simplex p : In p points_of_c -> exists t, In t tets /\ inside_closed (geo t) p.
Proof.
  intros I. destruct (point_cases p I)
    as [(t & i & Ht & Hi & ->)|(_ & k & e & t & s & _ & _ & Es & In_t & _)].
  - exists t. split; [assumption|]. intros l Hl. rewrite bary_vertex by assumption.
    destruct (Nat.eq_dec l i); lra.
  - exists t. split; [apply in_tets; eauto|assumption].
Qed.
(** ... so that the hull facets support them all. *)
Theorem certificate_supporting :
  supporting tets geo (on_hull c) (fun p => In p points_of_c).
Proof.
  apply (hull_supports Pos.eq_dec (on_hull_dec c) mesh once
    (certificate_convex_at_ridges Or Co c accepts geo frames)).
  exact point_in_simplex.
Qed.

(** Without submerged points, every point is a vertex. *)
Lemma point_vertex p : weights_of (claimed c) = false -> In p points_of_c ->
  vertex_of tets geo p.
Proof. intros W I. destruct (point_cases p I) as [V|(W' & _)]; [assumption|congruence]. Qed.

Lemma certificate_simplices :
  map (fun t => vertices (geo t)) tets = simplices_of_certificate d c.
Proof.
  apply map_numbers. intros t e E. apply lists_vertices. now apply frames.
Qed.

(** ** Heights *)

Variable h : point d -> R.
Hypothesis heights : forall k e, numbered (points c) k = Some e ->
  h (spot k) = @height_of d r (site_at d c k).

(** [depth] tells whether a lifted point is below a witness plane. *)
Lemma depth_witness t e p : entry t e -> well_shaped d p ->
  h (place_of r p) = @height_of d r p -> exists q, 0 < q /\
  IZR (depth pr (sites_of (d := d) (c := c) e) (slope pr (sites_of (d := d) (c := c) e)) p) =
  q * (witness h (geo t) (place_of r p) - h (place_of r p)).
Proof.
  intros E Sh Hp. pose proof (positive_orientation Co c accepts t e E) as P.
  pose proof (frames t e E) as L. pose proof (proj1 L) as Len. rewrite map_length in Len.
  set (X := sites_of e).
  assert (LX : length X = S d) by (unfold X, sites_of; now rewrite map_length).
  pose proof (computes_depth _ _ Co r X p (sites_shaped dim_d accepts (corners e)) LX Sh) as D.
  rewrite <- (spots_sites Co c accepts t e E : _ = map (place_of r) X) in D.
  assert (W : sum (S d) (fun i => orient (replace i (place_of r p) (map spot (corners e))) *
      @height_of d r (nth i X p)) =
    orient (map spot (corners e)) * witness h (geo t) (place_of r p)).
  { unfold witness, sum. rewrite <- sum_scale. apply sum_ext. intros i Hi. apply in_seq_d in Hi.
    rewrite <- (frame_bary Or _ (geo t) i (place_of r p) L ltac:(lra) Hi).
    destruct (corner_vertex Co c geo frames t e i E Hi) as (v & Ev & ->).
    destruct (simplex_accepted dim_d accepts t e E) as (Known & _).
    destruct (Known v (nth_error_In _ _ Ev)) as (q & Eq). rewrite (heights v q Eq).
    unfold X, sites_of. rewrite (nth_error_nth _ _ p (map_nth_error (site_at d c) i _ Ev)). ring. }
  rewrite W in D.
  pose proof (unit_power c accepts (d + 2)) as U.
  exists (orient (map spot (corners e)) / r ^ (d + 2)). split.
  - now apply Rdiv_lt_0_compat.
  - apply Rmult_eq_reg_l with (r ^ (d + 2)); [|lra]. rewrite <- D, <- Hp. field. lra.
Qed.

(** [facet-locally-delaunay], looked at from one of the two sides only. *)
Lemma certificate_local : delaunay_of (claimed c) = true -> forall t i u j,
  In t tets -> adj t i u j -> locally_above h (geo t) (geo u) j.
Proof.
  intros Cl.
  assert (K : forall t i u j, adj t i u j -> (t < u)%positive ->
    locally_above h (geo t) (geo u) j).
  { intros t i u j (e & E & W) Lt.
    destruct (neighbour_accepted dim_d accepts t e i u j E W) as (e' & E' & _ & B & D).
    assert (Hj : (j <= d)%nat).
    { apply (wall_index Co c accepts u e'); [assumption|congruence]. }
    destruct (corner_vertex Co c geo frames u e' j E' Hj) as (v & Ev & V).
    specialize (D Cl Lt v Ev). apply IZR_le in D. unfold locally_above. rewrite V.
    destruct (simplex_accepted dim_d accepts u e' E') as (Known & _).
    destruct (Known v (nth_error_In _ _ Ev)) as (p & Ep). pose proof (heights v p Ep) as Hv.
    rewrite (spot_site d c v p Ep) in *.
    destruct (depth_witness t e (site_at d c v) E (site_shaped dim_d accepts v) Hv) as (q & Q & S).
    nra. }
  intros t i u j Ht A. pose proof (matched_opposite _ _ _ _ mesh t i u j Ht A) as O.
  destruct (Pos.lt_total t u) as [Lt|[->|Gt]]; [now apply (K t i u j)| |].
  - destruct O as (Hi & Hj & _ & _ & Neg). rewrite bary_vertex in Neg by assumption.
    destruct (Nat.eq_dec i j); lra.
  - apply (locally_above_symmetric h (geo t) i (geo u) j O).
    apply (K u j t i); [|assumption]. now apply (adj_sym Co c accepts).
Qed.

(** A submerged point is not below the witness plane of its simplex. *)
Lemma point_accounted p : In p points_of_c -> accounted tets geo h p.
Proof.
  intros I. destruct (point_cases p I) as [V|(Cl & k & e & t & s & E & -> & Es & In_t & D)];
    [now left|right].
  exists t. split; [apply in_tets; eauto|]. split; [assumption|].
  pose proof (heights k e E) as H. rewrite (spot_numbered d c k e E) in H.
  assert (At : site_at d c k = position e).
  { unfold site_at, site_of. now rewrite E, Cl. }
  rewrite At in H. pose proof (site_shaped dim_d accepts k) as Sh. rewrite At in Sh.
  destruct (depth_witness t s (position e) Es Sh H) as (q & Q & S).
  apply IZR_le in D. nra.
Qed.
End Geometry.

Theorem check_in_sound : match claimed c with
  | Triangulation => triangulation points_of_c (simplices_of_certificate d c)
  | Delaunay => delaunay_triangulation points_of_c (simplices_of_certificate d c)
  | WeightedDelaunay => forall w, weights_given d c w ->
      weighted_delaunay_triangulation w points_of_c (simplices_of_certificate d c)
  end.
Proof.
  destruct (frames_exist Or Co c accepts) as (geo & frames).
  pose proof (certificate_matched Or Co c accepts geo frames) as Mesh.
  pose proof (certificate_covered_once Or Co c accepts geo frames) as Once.
  pose proof (certificate_supporting geo frames) as Sup.
  pose proof (vertices_in Co c accepts geo frames) as Vs.
  pose proof (numbers_NoDup (simplices c)) as N.
  rewrite <- (certificate_simplices geo frames).
  destruct (claimed c) eqn:Cl.
  - apply (mesh_triangulation points_of_c Mesh Vs Sup Pos.eq_dec N _ _ Once).
    intros p. apply (point_vertex geo frames). now rewrite Cl.
  - apply (mesh_delaunay_triangulation points_of_c Mesh Vs Sup Pos.eq_dec N _ _ Once).
    + intros p. apply (point_vertex geo frames). now rewrite Cl.
    + apply (certificate_local geo frames norm2); [|now rewrite Cl].
      intros k e E. rewrite (spot_site d c k e E). unfold height_of, site_at, site_of.
      rewrite E, Cl. cbn [weights_of weight]. ring.
  - intros w W.
    assert (Hs : forall k e, numbered (points c) k = Some e ->
      norm2 (spot k) - w (spot k) = @height_of d r (site_at d c k)).
    { intros k e E. rewrite (spot_numbered d c k e E), W by now apply numbered_in with k.
      unfold height_of, site_at, site_of. now rewrite E, Cl. }
    apply (mesh_weighted_delaunay_triangulation points_of_c Mesh Vs Sup Pos.eq_dec N _ _ Once).
    + intros p. apply (point_accounted geo frames (fun p => norm2 p - w p) Hs).
    + apply (certificate_local geo frames (fun p => norm2 p - w p) Hs). now rewrite Cl.
Qed.
End Soundness.

(** ** The theorem *)

(** If the checker accepts a certificate, the claim is true of the caller's points and simplices;
    and no point is listed twice. *)
Theorem check_sound D c : check D c = Accepted ->
  let S := points_of_certificate (dimension_of D) c in
  let T := simplices_of_certificate (dimension_of D) c in
  NoDup S /\
  match claimed c with
  | Triangulation => triangulation S T
  | Delaunay => delaunay_triangulation S T
  | WeightedDelaunay => (exists w, weights_given (dimension_of D) c w) /\
      forall w, weights_given (dimension_of D) c w ->
        weighted_delaunay_triangulation w S T
  end.
Proof.
  assert (G : forall d orient pr, @oriented d orient -> computes orient pr ->
    check_in pr c = Accepted ->
    let S := points_of_certificate d c in let T := simplices_of_certificate d c in
    NoDup S /\
    match claimed c with
    | Triangulation => triangulation S T
    | Delaunay => delaunay_triangulation S T
    | WeightedDelaunay => (exists w, weights_given d c w) /\
        forall w, weights_given d c w -> weighted_delaunay_triangulation w S T
    end).
  { intros d orient pr Or Co A S T. pose proof (computes_dimension _ _ Co) as Dim.
    split; [exact (points_distinct Dim A)|]. pose proof (check_in_sound Or Co c A) as Sound.
    destruct (claimed c); auto. split; [exact (weights_exist Dim A)|exact Sound]. }
  destruct D.
  - exact (G 2%nat _ _ oriented2 plane_computes).
  - exact (G 3%nat _ _ oriented3 space_computes).
Qed.
