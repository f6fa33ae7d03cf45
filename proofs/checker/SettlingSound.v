(** * What it means that an accepted certificate is settled

    The tests of [Settling.v] are the hypotheses of [book/Settled.v]: strictly above the witness
    plane, or above it by the first coefficient that is not zero. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Bool.
From Circumspect Require EveryPointSet.
From Circumspect Require Import Faces Settling Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Matched Hull LiftingMap.
From Circumspect Require Import DelaunayLemma Perturbation Settled.
From Circumspect Require Import Orientation Integers Incidence Accepted CertifiedMesh Soundness.
Import ListNotations.
Open Scope R_scope.

Lemma all_settled_each {A} (f : positive -> A -> bool) at_ l : all_settled f at_ 1 l = Settled ->
  forall k a, numbered l k = Some a -> f k a = true.
Proof.
  assert (G : forall l k0, all_settled f at_ k0 l = Settled -> forall i a, nth_error l i = Some a ->
    f (Pos.of_succ_nat i + k0 - 1)%positive a = true).
  { clear l. induction l as [|b l IH]; intros k0 E i a N; [destruct i; discriminate|].
    cbn in E. destruct (f k0 b) eqn:F; [|discriminate]. destruct i as [|i]; cbn in N.
    - injection N as <-. replace (Pos.of_succ_nat 0 + k0 - 1)%positive with k0 by lia. exact F.
    - replace (Pos.of_succ_nat (S i) + k0 - 1)%positive
        with (Pos.of_succ_nat i + Pos.succ k0 - 1)%positive by lia. eauto. }
  intros E k a N. replace k with (Pos.of_succ_nat (pred (Pos.to_nat k)) + 1 - 1)%positive by lia.
  eauto.
Qed.

(** The first coefficient that is not zero. *)
Lemma lead_at l : forall j c, nth_error l j = Some c -> c <> 0 ->
  (forall i x, (i < j)%nat -> nth_error l i = Some x -> x = 0) -> lead l = c.
Proof.
  induction l as [|a l IH]; intros [|j] c E N Z; cbn in E; try discriminate; cbn [lead].
  - injection E as ->. destruct (Req_EM_T c 0); [contradiction|reflexivity].
  - assert (a = 0) as -> by (apply (Z 0%nat); [lia|reflexivity]).
    destruct (Req_EM_T 0 0); [|congruence]. apply (IH j); auto.
    intros i x Hi Ex. apply (Z (S i)); [lia|assumption].
Qed.

(** The members of a list with their positions. *)
Lemma in_positions {A} (l : list A) : forall n i x, In (x, i) (combine l (seq n (length l))) <->
  (n <= i)%nat /\ nth_error l (i - n) = Some x.
Proof.
  induction l as [|a l IH]; intros n i x; cbn [length seq combine].
  - split; [intros []|]. intros [_ E]. destruct (i - n)%nat; discriminate.
  - cbn [In]. rewrite IH. split.
    + intros [E|[H E]].
      * injection E as <- <-. now rewrite Nat.sub_diag.
      * split; [lia|]. now replace (i - n)%nat with (S (i - S n)) by lia.
    + intros [H E]. destruct (Nat.eq_dec i n) as [->|N].
      * rewrite Nat.sub_diag in E. injection E as <-. now left.
      * right. split; [lia|]. now replace (i - n)%nat with (S (i - S n)) in E by lia.
Qed.

Section Settled.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis Or : oriented orient.
Hypothesis Co : computes orient pr.
Variable c : certificate.
Hypothesis accepts : check_in pr c = Accepted.
Variable s : standing.
Hypothesis settles : settle_in pr c s = Settled.

Notation r := (unit_of c).
Notation spot := (spot d c).
Notation entry t e := (numbered (simplices c) t = Some e).
Notation tets := (tets c).
Notation adj := (adj c).
Notation S := (points_of_certificate d c).
Notation m := (mesh_of c).
Let dim_d : dimension pr = d := computes_dimension _ _ Co.

Lemma settled_parts : delaunay_of (claimed c) = true /\
  (forall t e, entry t e -> settled_simplex pr m s t e = true) /\
  (forall k e, numbered (points c) k = Some e -> settled_point pr m s k e = true).
Proof.
  pose proof settles as A. unfold settle_in in A. cbv zeta in A.
  destruct (delaunay_of (claimed c)); [|discriminate]. split; [reflexivity|].
  destruct (all_settled (settled_simplex pr m s) AtSimplex 1 (simplices c)) eqn:E; [|discriminate].
  split; [exact (all_settled_each _ _ _ E)|exact (all_settled_each _ _ _ A)].
Qed.

Section Geometry.
Variable geo : positive -> frame d.
Hypothesis frames : forall t e, entry t e -> lists (map spot (corners e)) (geo t).
Variable h : point d -> R.
Hypothesis heights : forall k e, numbered (points c) k = Some e ->
  h (spot k) = @height_of d r (site_at d c k).

Lemma spots_differ k l e e' : numbered (points c) k = Some e -> numbered (points c) l = Some e' ->
  spot k = spot l -> k = l.
Proof.
  intros Ek El E. pose proof (points_distinct dim_d accepts) as N.
  assert (Len : forall k e, numbered (points c) k = Some e -> (pred (Pos.to_nat k) < length S)%nat).
  { intros k0 e0 E0. unfold points_of_certificate. rewrite map_length. apply nth_error_Some.
    unfold numbered in E0. congruence. }
  pose proof (proj1 (NoDup_nth S origin) N _ _ (Len k e Ek) (Len l e' El) E). lia.
Qed.

(** The sign of a coordinate. *)
Lemma side_sign t e i k p : entry t e -> (i <= d)%nat -> numbered (points c) k = Some p ->
  exists q, 0 < q /\
    IZR (side pr i (sites_of (d := d) (c := c) e) (site_at d c k) 1) = q * bary (geo t) i (spot k).
Proof.
  intros E Hi Ek.
  destruct (side_bary Or Co c accepts geo frames t e i (site_at d c k) 1 E Hi
    (site_shaped dim_d accepts k) ltac:(lia)) as (q & Q & Eq).
  exists q. split; [assumption|]. rewrite (spot_site d c k p Ek).
  now replace (r / 1) with r in Eq by field.
Qed.

Notation sites e := (sites_of (d := d) (c := c) e).

(** Both standings mean: above by the first coefficient; [Unique] also: strictly above. *)
Lemma settled_good t e k p : entry t e -> numbered (points c) k = Some p ->
  settled pr s (corners e) (sites e) (slope pr (sites e)) k (site_at d c k) = true ->
  0 < lead (coefficients S h (geo t) (spot k)) /\ (s = Unique -> 0 < above h (geo t) (spot k)).
Proof.
  intros E Ek G. unfold settled in G. cbv zeta in G.
  assert (Hk : h (place_of r (site_at d c k)) = @height_of d r (site_at d c k)).
  { rewrite <- (spot_site d c k p Ek). now apply (heights k p). }
  destruct (depth_witness Or Co c accepts geo frames h heights t e (site_at d c k) E
    (site_shaped dim_d accepts k) Hk) as (q & Q & Eq).
  rewrite <- (spot_site d c k p Ek) in Eq.
  set (z := depth pr (sites e) (slope pr (sites e)) (site_at d c k)) in *.
  assert (Strict : (z < 0)%Z -> 0 < above h (geo t) (spot k)).
  { intros N. apply IZR_lt in N. unfold above. nra. }
  apply orb_true_iff in G. destruct G as [G|G].
  { apply Z.ltb_lt in G. specialize (Strict G). split; [|auto]. unfold coefficients. cbn [lead].
    destruct (Req_EM_T (above h (geo t) (spot k)) 0); lra. }
  destruct s; [|discriminate]. split; [|discriminate].
  apply andb_true_iff in G. destruct G as [Z D]. apply Z.eqb_eq in Z. rewrite Z in Eq.
  assert (Zero : above h (geo t) (spot k) = 0) by (unfold above; nra).
  unfold decided in D. apply existsb_exists in D. destruct D as ((v & i) & I & F).
  unfold first_positive in F. cbn [fst snd] in F. rewrite !andb_true_iff, forallb_forall in F.
  destruct F as [[Lt Pos] First]. apply Pos.ltb_lt in Lt. apply Z.ltb_lt in Pos.
  destruct (simplex_accepted dim_d accepts t e E) as (Known & _).
  pose proof (proj1 (frames t e E)) as Len. rewrite map_length in Len.
  assert (At : forall u j, In (u, j) (combine (corners e) (seq 0 (length (corners e)))) <->
    nth_error (corners e) j = Some u).
  { intros u j. rewrite in_positions, Nat.sub_0_r. split; [tauto|]. split; [lia|assumption]. }
  apply At in I.
  assert (Hi : (i <= d)%nat).
  { assert (H : (i < length (corners e))%nat) by (apply nth_error_Some; congruence). lia. }
  destruct (Known v (nth_error_In _ _ I)) as (pv & Ev).
  assert (Vi : vertex (geo t) i = spot v).
  { destruct (corner_vertex Co c geo frames t e i E Hi) as (v' & Ev' & ->). congruence. }
  destruct (side_sign t e i k p E Hi Ek) as (qi & Qi & Si). apply IZR_lt in Pos. rewrite Si in Pos.
  assert (Bi : 0 < bary (geo t) i (spot k)) by nra.
  (* the coefficients, in the order of the points *)
  assert (Coefficient : forall w pw, numbered (points c) w = Some pw -> (w < k)%positive ->
    - above (at_point (spot w)) (geo t) (spot k) =
    sum (Datatypes.S d) (fun l => bary (geo t) l (spot k) * at_point (spot w) (vertex (geo t) l))).
  { intros w pw Ew Hw. unfold above, witness. unfold at_point at 1.
    destruct (point_eq_dec (spot k) (spot w)) as [X|]; [|ring].
    apply (spots_differ k w p pw Ek Ew) in X. lia. }
  assert (Lead : lead (coefficients S h (geo t) (spot k)) = bary (geo t) i (spot k)); [|lra].
  apply (lead_at _ (Datatypes.S (pred (Pos.to_nat v)))); [|lra|].
  - unfold coefficients. cbn [nth_error]. rewrite nth_error_map.
    assert (N : nth_error S (pred (Pos.to_nat v)) = Some (spot v)).
    { rewrite (spot_numbered d c v pv Ev). unfold points_of_certificate.
      exact (map_nth_error (fun e => place_of r (position e)) _ _ Ev). }
    rewrite N. cbn [option_map]. f_equal. rewrite (Coefficient v pv Ev Lt). unfold sum.
    rewrite (sum_one _ _ i); [|apply seq_NoDup|now apply in_seq_d|].
    + rewrite Vi. unfold at_point. destruct (point_eq_dec (spot v) (spot v)); [ring|contradiction].
    + intros l Hl Nl. apply in_seq_d in Hl. unfold at_point.
      destruct (point_eq_dec (vertex (geo t) l) (spot v)) as [X|]; [|ring].
      rewrite <- Vi in X. apply vertex_inj in X; auto. contradiction.
  - intros [|j] x Hj Ex.
    + unfold coefficients in Ex. cbn in Ex. injection Ex as <-. assumption.
    + unfold coefficients in Ex. cbn [nth_error] in Ex. rewrite nth_error_map in Ex.
      destruct (nth_error S j) as [y|] eqn:Ey; [|discriminate]. cbn in Ex. injection Ex as <-.
      set (w := Pos.of_succ_nat j).
      assert (Ew : exists pw, numbered (points c) w = Some pw /\ y = spot w).
      { unfold numbered, w. rewrite SuccNat2Pos.id_succ. cbn [pred].
        unfold points_of_certificate in Ey. rewrite nth_error_map in Ey.
        destruct (nth_error (points c) j) as [pw|] eqn:Ep; [|discriminate].
        exists pw. split; [reflexivity|]. cbn in Ey. injection Ey as <-. symmetry.
        apply spot_numbered. unfold numbered. now rewrite SuccNat2Pos.id_succ. }
      destruct Ew as (pw & Ew & ->).
      rewrite (Coefficient w pw Ew) by (unfold w; lia).
      unfold sum. apply sum_zero. intros l Hl. apply in_seq_d in Hl. unfold at_point.
      destruct (point_eq_dec (vertex (geo t) l) (spot w)) as [X|]; [|ring].
      destruct (corner_vertex Co c geo frames t e l E Hl) as (u & Eu & Vu). rewrite Vu in X.
      destruct (Known u (nth_error_In _ _ Eu)) as (pu & Epu).
      apply (spots_differ u w pu pw Epu Ew) in X. subst u.
      specialize (First (w, l) (proj2 (At w l) Eu)). cbn [fst snd] in First.
      apply orb_true_iff in First. destruct First as [First|First].
      * exfalso. apply negb_true_iff, Pos.ltb_ge in First. unfold w in First. lia.
      * apply Z.eqb_eq in First. destruct (side_sign t e l k p E Hl Ek) as (ql & Ql & Sl).
        rewrite First in Sl. assert (bary (geo t) l (spot k) = 0) as -> by nra. ring.
Qed.

(** What is settled of a facet and of a point. *)
Definition good t p : Prop :=
  0 < lead (coefficients S h (geo t) p) /\ (s = Unique -> 0 < above h (geo t) p).

Lemma good_facets t i u j : In t tets -> adj t i u j ->
  good t (vertex (geo u) j) \/ good u (vertex (geo t) i).
Proof.
  assert (K : forall t i u j, adj t i u j -> (t < u)%positive -> good t (vertex (geo u) j)).
  { clear t i u j. intros t i u j (e & E & W) Lt. destruct settled_parts as (_ & Simplices & _).
    specialize (Simplices t e E). unfold settled_simplex in Simplices.
    destruct (find_all (points_of m) (corners e)) as [X|] eqn:F; [|discriminate].
    apply (find_all_sites (d := d)) in F. destruct F as [-> _]. cbv zeta in Simplices.
    rewrite forallb_forall in Simplices. specialize (Simplices _ (nth_error_In _ _ W)).
    cbn [settled_wall] in Simplices. apply Pos.ltb_lt in Lt. rewrite Lt in Simplices.
    cbn [negb orb] in Simplices. rewrite find_simplex in Simplices.
    destruct (neighbour_accepted dim_d accepts t e i u j E W) as (e' & E' & _ & B & _).
    rewrite E' in Simplices.
    assert (Hj : (j <= d)%nat) by (apply (wall_index Co c accepts u e'); [assumption|congruence]).
    destruct (corner_vertex Co c geo frames u e' j E' Hj) as (v & Ev & ->).
    rewrite Ev in Simplices. destruct (simplex_accepted dim_d accepts u e' E') as (Known & _).
    destruct (Known v (nth_error_In _ _ Ev)) as (p & Ep).
    destruct (Table.find v (points_of m)) as [q|] eqn:Fv; [|discriminate].
    apply (find_point_site (d := d)) in Fv. destruct Fv as [<- _].
    now apply (settled_good t e v p). }
  intros Ht A. pose proof (matched_opposite _ _ _ _
    (certificate_matched Or Co c accepts geo frames) t i u j Ht A) as O.
  destruct (Pos.lt_total t u) as [Lt|[->|Gt]]; [left; now apply (K t i u j)| |].
  - destruct O as (Hi & Hj & _ & _ & Neg). rewrite bary_vertex in Neg by assumption.
    destruct (Nat.eq_dec i j); lra.
  - right. apply (K u j t i); [|assumption]. now apply (adj_sym Co c accepts).
Qed.

Lemma good_points p : In p S -> vertex_of tets geo p \/
  exists u, In u tets /\ inside_closed (geo u) p /\ good u p.
Proof.
  intros I. apply in_points in I. destruct I as (k & e & E & ->).
  rewrite <- (spot_numbered d c k e E).
  destruct (point_accepted dim_d accepts k e E) as (f & Ef & [K|(Cl & In_f & _)]).
  - left. apply (in_map spot) in K.
    apply (lists_in _ (geo (home e)) _ (frames _ _ Ef)) in K. destruct K as (i & Hi & V).
    exists (home e), i. split; [apply in_tets; eauto|auto].
  - destruct settled_parts as (_ & _ & Points). specialize (Points k e E).
    unfold settled_point in Points.
    destruct (home_vertex e) as [i|] eqn:Hv.
    + left. destruct (check_parts accepts) as (_ & _ & H & _).
      apply (each_accepted _ _ H) in E. unfold check_point in E.
      destruct (used pr m k e) eqn:U; [|discriminate]. unfold used in U.
      rewrite find_simplex, Ef, Hv in U.
      destruct (nth_error (corners f) i) as [v|] eqn:N; [|discriminate].
      apply Pos.eqb_eq in U. subst v. apply nth_error_In, (in_map spot) in N.
      apply (lists_in _ (geo (home e)) _ (frames _ _ Ef)) in N. destruct N as (l & Hl & V).
      exists (home e), l. split; [apply in_tets; eauto|auto].
    + right. rewrite find_simplex, Ef in Points.
      destruct (find_all (points_of m) (corners f)) as [X|] eqn:F; [|discriminate].
      apply (find_all_sites (d := d)) in F. destruct F as [-> _].
      assert (At : site_at d c k = position e) by (unfold site_at, site_of; now rewrite E, Cl).
      exists (home e). split; [apply in_tets; eauto|]. split.
      * intros i Hi. specialize (In_f i Hi). rewrite <- At in In_f. apply IZR_le in In_f.
        destruct (side_sign (home e) f i k e Ef Hi E) as (q & Q & Eq). nra.
      * apply (settled_good (home e) f k e Ef E). now rewrite At.
Qed.

Notation T := (simplices_of_certificate d c).
Notation mesh := (certificate_matched Or Co c accepts geo frames).
Notation once := (certificate_covered_once Or Co c accepts geo frames).
Notation support := (certificate_supporting Or Co c accepts geo frames).
Notation vertices_are_points := (vertices_in Co c accepts geo frames).

Lemma perturbed_all : exists e0, 0 < e0 /\ forall e, 0 < e < e0 -> forall t, In t T ->
  witness_plane (perturbed S h e) S t.
Proof.
  destruct (perturbed_planes mesh vertices_are_points support Pos.eq_dec once h) as (e0 & P & K).
  - intros t i u j Ht A. destruct (good_facets t i u j Ht A) as [[G _]|[G _]]; [now left|now right].
  - intros p Hp. destruct (good_points p Hp) as [V|(u & Hu & I & [G _])]; [now left|right].
    now exists u.
  - exists e0. split; [assumption|]. intros e He t Ht.
    rewrite <- (certificate_simplices c geo frames) in Ht.
    apply in_map_iff in Ht. destruct Ht as (k & <- & Hk). now apply (K e).
Qed.

Lemma unique_all U : s = Unique -> fills S T -> fills S U ->
  (forall u, In u U -> witness_plane h S u) -> same_simplices T U.
Proof.
  intros Us FT FU W. apply (filled_same S T U FT FU). intros t Ht.
  rewrite <- (certificate_simplices c geo frames) in Ht.
  apply in_map_iff in Ht. destruct Ht as (k & <- & Hk).
  apply (strictly_in (tets := tets) (geo := geo) vertices_are_points h U); try assumption.
  apply (strictly_above mesh vertices_are_points support Pos.eq_dec once h).
  - intros a i u j Ha A. destruct (good_facets a i u j Ha A) as [[_ G]|[_ G]];
      [left|right]; now apply G.
  - intros p Hp. destruct (good_points p Hp) as [V|(u & Hu & I & [_ G])]; [now left|right].
    exists u. repeat split; auto. now apply G.
Qed.
End Geometry.
End Settled.

(** ** The theorems *)

Section Whole.
Variables (D : plane_or_space) (c : certificate).
Hypothesis accepts : check D c = Accepted.
Notation d := (dimension_of D).
Notation S := (points_of_certificate d c).
Notation T := (simplices_of_certificate d c).

Lemma settled_whole s (w : point d -> R) : settle D c s = Settled ->
  (claimed c = WeightedDelaunay -> weights_given d c w) ->
  canonical_triangulation S (lifted (claimed c) w) T /\
  (s = Unique -> forall U, fills S U ->
     (forall u, In u U -> witness_plane (lifted (claimed c) w) S u) -> same_simplices T U).
Proof.
  intros Se W. destruct (check_sound D c accepts) as [N Claim].
  assert (F : fills S T).
  { destruct (claimed c); [apply Claim..|].
    destruct Claim as ((w0 & W0) & Claim). now apply (Claim w0 W0). }
  assert (G : forall d orient pr, @oriented d orient -> computes orient pr ->
    check_in pr c = Accepted -> settle_in pr c s = Settled ->
    NoDup (points_of_certificate d c) ->
    fills (points_of_certificate d c) (simplices_of_certificate d c) ->
    forall w : point d -> R, (claimed c = WeightedDelaunay -> weights_given d c w) ->
    canonical_triangulation (points_of_certificate d c) (lifted (claimed c) w)
      (simplices_of_certificate d c) /\
    (s = Unique -> forall U, fills (points_of_certificate d c) U ->
      (forall u, In u U -> witness_plane (lifted (claimed c) w) (points_of_certificate d c) u) ->
      same_simplices (simplices_of_certificate d c) U)).
  { clear w W Se F N Claim accepts D. intros d orient pr Or Co A Se N F w W.
    destruct (frames_exist Or Co c A) as (geo & frames).
    destruct (settled_parts c s Se) as (Cl & _).
    assert (Hs : forall k e, numbered (points c) k = Some e ->
      lifted (claimed c) w (spot d c k) = @height_of d (unit_of c) (site_at d c k)).
    { intros k e E. unfold height_of, site_at, site_of. rewrite E.
      destruct (claimed c); [discriminate| |]; cbn [lifted weights_of weight].
      - rewrite (spot_numbered d c k e E). unfold place_of. cbn [coordinates]. ring.
      - rewrite (spot_numbered d c k e E), W;
          [reflexivity|reflexivity|now apply numbered_in with k]. }
    split.
    - split; [assumption|].
      destruct (perturbed_all Or Co c A s Se geo frames _ Hs) as (e0 & P & K).
      exists e0. split; [assumption|]. intros e k He L t Ht.
      apply (EveryPointSet.witness_plane_ext (perturbed (points_of_certificate d c)
        (lifted (claimed c) w) e)).
      + destruct F as (_ & _ & _ & V & _). now apply V.
      + intros p Hp. symmetry. now apply lowered_perturbed.
      + now apply K.
    - intros Us U FU Wu. now apply (unique_all Or Co c A s Se geo frames _ Hs U Us F FU). }
  destruct D.
  - exact (G 2%nat _ _ oriented2 plane_computes accepts Se N F w W).
  - exact (G 3%nat _ _ oriented3 space_computes accepts Se N F w W).
Qed.

(** The canonical one, whichever of the two is claimed. *)
Theorem settled_canonical s (w : point d -> R) : settle D c s = Settled ->
  (claimed c = WeightedDelaunay -> weights_given d c w) ->
  canonical_triangulation S (lifted (claimed c) w) T.
Proof. intros Se W. now apply (settled_whole s w). Qed.

(** The only one. *)
Theorem settled_unique U : settle D c Unique = Settled ->
  match claimed c with
  | Triangulation => False
  | Delaunay => delaunay_triangulation S U
  | WeightedDelaunay => exists w, weights_given d c w /\ weighted_delaunay_triangulation w S U
  end -> same_simplices T U.
Proof.
  intros Se H. destruct (claimed c) eqn:Cl; [contradiction| |].
  - destruct (settled_whole Unique (fun _ => 0) Se) as [_ K]; [congruence|]. rewrite Cl in K.
    destruct H as ((F & _) & De). apply (K eq_refl U F). intros u Hu.
    apply delaunay_witness_plane. auto.
  - destruct H as (w & W & F & De). destruct (settled_whole Unique w Se) as [_ K]; [auto|].
    rewrite Cl in K. apply (K eq_refl U F). exact De.
Qed.
End Whole.
