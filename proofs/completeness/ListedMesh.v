(** * Points and simplices of a certificate that fill conv S

    If the simplices of a certificate fill conv S they have frames ([description]), and none is
    flat.  The integers that the checker computes have the signs of barycentric coordinates
    ([listed_side], [listed_depth]), and facets are the same if their numbers are
    ([shared_facets]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Sorting.Sorted.
From Circumspect Require Import Checker Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Facets Matched Adjacency.
From Circumspect Require Import LiftingMap Orientation Integers Incidence Accepted Soundness.
From Circumspect Require Import Honest Permutations.
Import ListNotations.
Open Scope R_scope.

Lemma remove_length_pred {A} i (l : list A) n : length l = S n -> (i <= n)%nat ->
  length (remove i l) = n.
Proof. intros L Hi. pose proof (remove_length i l ltac:(lia)). lia. Qed.
Lemma remove_none {A} i (l : list A) : (length l <= i)%nat -> remove i l = l.
Proof. revert i. induction l as [|a l IH]; intros [|i] H; cbn in *; try lia; f_equal; auto.
  apply IH. lia. Qed.
Lemma in_remove {A} i (l : list A) x : In x (remove i l) -> In x l.
Proof.
  destruct (nth_error l i) as [a|] eqn:E.
  - intros I. apply (Permutation.Permutation_in x (Permutation.Permutation_sym
      (remove_perm i a l E))). now right.
  - apply nth_error_None in E. now rewrite remove_none.
Qed.

Section ListedMesh.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis Or : oriented orient.
Hypothesis Co : computes orient pr.
Hypothesis not_flat : forall X (t : frame d), lists X t -> orient X <> 0.
Hypothesis positive_d : (1 <= d)%nat.
Variable c : certificate.
Hypothesis H : well_listed orient c.
Notation P := (points_of_certificate d c).
Notation r := (unit_of c).
Notation spot := (spot d c).
Notation point_at k e := (numbered (points c) k = Some e).
Notation simplex_at t s := (numbered (Definitions.simplices c) t = Some s).
Notation tets := (numbers (Definitions.simplices c)).
Hypothesis F : fills P (simplices_of_certificate d c).
Hypothesis some : simplices_of_certificate d c <> [].

(** ** Points *)

Lemma listed_unit : 0 < r.
Proof.
  destruct (listed_scale _ _ H) as [N D]. apply IZR_lt in N, D. now apply Rdiv_lt_0_compat.
Qed.
Lemma listed_site k : well_shaped d (site_at d c k).
Proof.
  unfold site_at. destruct (numbered (points c) k) as [e|] eqn:E; [|apply repeat_length].
  unfold well_shaped. rewrite coordinates_site_of. apply numbered_in in E.
  pose proof (listed_shape _ _ H) as S. rewrite Forall_forall in S. apply S. now apply in_map.
Qed.
Lemma listed_sites l : Forall (well_shaped d) (map (site_at d c) l).
Proof.
  apply Forall_forall. intros s I. apply in_map_iff in I. destruct I as (k & <- & _).
  apply listed_site.
Qed.
Lemma points_accepted : check_points pr (points c) = Accepted.
Proof.
  pose proof (listed_shape _ _ H) as Sh. pose proof (listed_order _ _ H) as So.
  unfold check_points. destruct (points c) as [|e l]; [reflexivity|]. cbn [map] in Sh, So.
  assert (B : forall p, length (coordinates p) = d -> shaped pr p = true).
  { intros p L. unfold shaped. rewrite (computes_dimension _ _ Co). now apply Nat.eqb_eq. }
  apply Forall_cons_iff in Sh. destruct Sh as [She Sh]. rewrite B by assumption.
  clear She. generalize 1%positive as k. revert So. generalize (position e) as p. clear e.
  induction l as [|f l IH]; intros p So k; [reflexivity|].
  cbn [points_increase map] in *. apply Forall_cons_iff in Sh. destruct Sh as [Shf Sh].
  rewrite B by assumption. inversion_clear So as [|? ? So' R].
  inversion_clear R as [|? ? R']. rewrite R'. cbn [andb]. now apply IH.
Qed.
Lemma listed_distinct : NoDup P.
Proof.
  assert (N : NoDup (map (fun e => coordinates (position e)) (points c))).
  { pose proof points_accepted as A. unfold check_points in A.
    destruct (points c) as [|e l]; [constructor|].
    destruct (shaped pr (position e)); [|discriminate].
    apply (increase_spec (computes_dimension _ _ Co)) in A. destruct A as [A N].
    cbn. constructor; [|assumption]. intros I. apply in_map_iff in I. destruct I as (e' & E & I).
    rewrite Forall_forall in A. destruct (A e' I) as [_ B].
    apply (lexicographic_first (computes_dimension _ _ Co)) in B. destruct B as [B _]. congruence. }
  pose proof (listed_shape _ _ H) as Sh. pose proof listed_unit as U.
  unfold points_of_certificate. induction (points c) as [|e l IH]; cbn in *; constructor.
  - inversion_clear N. intros I. apply in_map_iff in I. destruct I as (e' & E & I).
    apply H0. apply in_map_iff. exists e'. split; [|assumption].
    inversion_clear Sh. rewrite Forall_forall in H3. apply (@place_inj d r); auto; try lra.
    apply H3. now apply in_map.
  - inversion_clear N. inversion_clear Sh. auto.
Qed.
Lemma spot_inj k e k' e' : point_at k e -> point_at k' e' -> spot k = spot k' -> k = k'.
Proof.
  intros E E' S. unfold Definitions.spot in S.
  assert (L : forall k e, point_at k e -> (pred (Pos.to_nat k) < length P)%nat).
  { intros j f Ef. unfold points_of_certificate. rewrite map_length. apply nth_error_Some.
    unfold numbered in Ef. congruence. }
  apply NoDup_nth in S; eauto using listed_distinct. lia.
Qed.

(** ** Simplices *)

Lemma corner_known t s k : simplex_at t s -> In k (corners s) -> exists e, point_at k e.
Proof. apply (listed_corners _ _ H). Qed.
Lemma corner_inj t s u s' k k' : simplex_at t s -> simplex_at u s' -> In k (corners s) ->
  In k' (corners s') -> spot k = spot k' -> k = k'.
Proof.
  intros E E' I I'. destruct (corner_known t s k E I) as (e & Ek).
  destruct (corner_known u s' k' E' I') as (e' & Ek'). now apply spot_inj with e e'.
Qed.
Lemma in_simplex_list t s : simplex_at t s ->
  In (map spot (corners s)) (simplices_of_certificate d c).
Proof.
  intros E. unfold simplices_of_certificate. apply in_map_iff. exists s.
  split; [reflexivity|]. now apply numbered_in with t.
Qed.

(** The frames of the simplices, and what [fills] says about them. *)
Record described (geo : positive -> frame d) : Prop := {
  described_frame : forall t s, simplex_at t s -> lists (map spot (corners s)) (geo t);
  described_agree : forall t u, In t tets -> In u tets -> agree (geo t) (geo u);
  described_different : forall t u, In t tets -> In u tets ->
    same (vertices (geo t)) (vertices (geo u)) -> t = u;
  described_in : forall t, In t tets -> incl (vertices (geo t)) P;
  described_covering : forall q, conv P q -> exists t, In t tets /\ inside_closed (geo t) q
}.

Lemma description : exists geo, described geo.
Proof.
  destruct (fills_framed P (simplices_of_certificate d c) F some) as (g & [V A D I C]).
  set (L := length (simplices_of_certificate d c)) in *.
  assert (EL : L = length (Definitions.simplices c)) by (unfold L, simplices_of_certificate; apply
    map_length).
  assert (Q : forall t, In t tets -> In (pred (Pos.to_nat t)) (seq 0 L)).
  { intros t Ht. apply in_numbers in Ht. destruct Ht as (s & E). apply in_seq. rewrite EL.
    split; [lia|]. apply nth_error_Some. unfold numbered in E. congruence. }
  exists (fun t => g (pred (Pos.to_nat t))). constructor.
  - intros t s E. assert (Ht : In t tets) by (apply in_numbers; eauto).
    apply Q, in_seq in Ht. specialize (V _ (proj2 Ht)).
    assert (N : nth (pred (Pos.to_nat t)) (simplices_of_certificate d c) [] = map spot (corners s)).
    { apply nth_error_nth. unfold simplices_of_certificate.
      now apply (map_nth_error (fun e => map spot (corners e))). }
    rewrite N in V. rewrite <- V. split; [apply vertices_length|].
    intros i Hi. unfold vertices. apply map_nth_error.
    rewrite (nth_error_nth' _ 0%nat) by (rewrite seq_length; lia). now rewrite seq_nth by lia.
  - auto.
  - intros t u Ht Hu S. pose proof (D _ _ (Q t Ht) (Q u Hu) S). lia.
  - auto.
  - intros q Cq. destruct (C q Cq) as (t & Ht & Iq). exists (Pos.of_succ_nat t).
    rewrite SuccNat2Pos.id_succ. split; [|assumption]. apply in_numbers. apply in_seq in Ht.
    destruct (nth_error (Definitions.simplices c) t) as [s|] eqn:E.
    + exists s. unfold numbered. now rewrite SuccNat2Pos.id_succ.
    + apply nth_error_None in E. lia.
Qed.

Section Geometry.
Variable geo : positive -> frame d.
Hypothesis G : described geo.

Lemma in_tets t s : simplex_at t s -> In t tets.
Proof. intros E. apply in_numbers. eauto. Qed.
Lemma corners_length t s : simplex_at t s -> length (corners s) = S d.
Proof. intros E. pose proof (proj1 (described_frame _ G t s E)) as L. now rewrite map_length in L.
Qed.
Lemma corners_NoDup t s : simplex_at t s -> NoDup (corners s).
Proof.
  intros E. apply NoDup_map_inv with (f := spot).
  rewrite <- (lists_vertices _ _ (described_frame _ G t s E)). apply vertices_NoDup.
Qed.
Lemma positive_listed t s : simplex_at t s -> 0 < orient (map spot (corners s)).
Proof.
  intros E. pose proof (listed_orientation _ _ H t s E).
  pose proof (not_flat _ _ (described_frame _ G t s E)). lra.
Qed.
Lemma listed_corner_of t s i : simplex_at t s -> (i <= d)%nat ->
  exists v, nth_error (corners s) i = Some v /\ vertex (geo t) i = spot v.
Proof. intros E Hi. exact (listed_corner spot _ _ i (described_frame _ G t s E) Hi). Qed.

Lemma listed_spots t s : simplex_at t s ->
  map spot (corners s) = map (place_of r) (sites_of (d := d) (c := c) s).
Proof.
  intros E. unfold sites_of. rewrite map_map. apply map_ext_in. intros k Hk.
  destruct (corner_known t s k E Hk) as (p & Ep). now apply spot_site with p.
Qed.
Lemma listed_side t s i p w : simplex_at t s -> (i <= d)%nat -> well_shaped d p -> (0 < w)%Z ->
  exists q, 0 < q /\ IZR (side pr i (sites_of (d := d) (c := c) s) p w) =
                     q * bary (geo t) i (place_of (r / IZR w) p).
Proof.
  intros E Hi Hs Hw. pose proof (positive_listed t s E) as O.
  pose proof (described_frame _ G t s E) as L. pose proof (proj1 L) as Len.
  pose proof (frame_bary Or _ _ i (place_of (r / IZR w) p) L ltac:(lra) Hi) as B.
  rewrite (listed_spots t s E), map_length in Len.
  pose proof (computes_side _ _ Co r i _ p w (listed_sites (corners s)) Len Hi Hs Hw) as S.
  fold (sites_of (d := d) (c := c) s) in S.
  rewrite <- (listed_spots t s E), <- B in S. apply IZR_lt in Hw.
  pose proof (pow_lt r d listed_unit) as U.
  exists (IZR w * orient (map spot (corners s)) / r ^ d). split.
  - apply Rdiv_lt_0_compat; [now apply Rmult_lt_0_compat|assumption].
  - apply Rmult_eq_reg_l with (r ^ d); [|lra]. rewrite <- S. field. lra.
Qed.
Lemma listed_depth (h : point d -> R) t s p :
  (forall k e, point_at k e -> h (spot k) = @height_of d r (site_at d c k)) ->
  simplex_at t s -> well_shaped d p -> h (place_of r p) = @height_of d r p -> exists q, 0 < q /\
  IZR (depth pr (sites_of (d := d) (c := c) s) (slope pr (sites_of (d := d) (c := c) s)) p) =
  q * (witness h (geo t) (place_of r p) - h (place_of r p)).
Proof.
  intros Hh E Sh Hp. pose proof (positive_listed t s E) as O.
  pose proof (described_frame _ G t s E) as L. pose proof (proj1 L) as Len.
  rewrite map_length in Len. set (X := sites_of s).
  assert (LX : length X = S d) by (unfold X, sites_of; now rewrite map_length).
  pose proof (computes_depth _ _ Co r X p (listed_sites (corners s)) LX Sh) as D.
  rewrite <- (listed_spots t s E : _ = map (place_of r) X) in D.
  assert (W : sum (S d) (fun i => orient (replace i (place_of r p) (map spot (corners s))) *
      @height_of d r (nth i X p)) =
    orient (map spot (corners s)) * witness h (geo t) (place_of r p)).
  { unfold witness, sum. rewrite <- sum_scale. apply sum_ext. intros i Hi. apply in_seq_d in Hi.
    rewrite <- (frame_bary Or _ (geo t) i (place_of r p) L ltac:(lra) Hi).
    destruct (listed_corner_of t s i E Hi) as (v & Ev & ->).
    destruct (corner_known t s v E (nth_error_In _ _ Ev)) as (q & Eq). rewrite (Hh v q Eq).
    unfold X, sites_of. rewrite (nth_error_nth _ _ p (map_nth_error (site_at d c) i _ Ev)). ring. }
  rewrite W in D. pose proof (pow_lt r (d + 2) listed_unit) as U.
  exists (orient (map spot (corners s)) / r ^ (d + 2)). split.
  - now apply Rdiv_lt_0_compat.
  - apply Rmult_eq_reg_l with (r ^ (d + 2)); [|lra]. rewrite <- D, <- Hp. field. lra.
Qed.

(** ** Facets *)

Lemma facet_corners t s i p : simplex_at t s -> (i <= d)%nat ->
  In p (facet_of (geo t) i) <-> In p (map spot (remove i (corners s))).
Proof.
  intros E Hi. pose proof (corners_length t s E) as L. rewrite (in_facet_of _ _ _ Hi), in_map_iff.
  split.
  - intros (k & Hk & N & ->). destruct (listed_corner_of t s k E Hk) as (v & Ev & ->). exists v.
    split; [reflexivity|]. destruct (skip_onto i k d Hk Hi N) as (a & Ha & <-).
    apply nth_error_In with a. rewrite remove_nth; [assumption|lia].
  - intros (v & <- & I). apply In_nth_error in I. destruct I as (a & Ea).
    assert (Ha : (a < d)%nat).
    { rewrite <- (remove_length_pred i (corners s) d L Hi). apply nth_error_Some. congruence. }
    rewrite remove_nth in Ea by lia. exists (skip i a).
    split; [now apply skip_le|]. split; [apply skip_ne|].
    destruct (listed_corner_of t s (skip i a) E (skip_le i a d Ha)) as (v' & Ev & ->). congruence.
Qed.
Lemma shared_facets t s i u s' j : simplex_at t s -> simplex_at u s' -> (i <= d)%nat ->
  (j <= d)%nat -> (shared (remove i (corners s)) (remove j (corners s')) <->
  same (facet_of (geo t) i) (facet_of (geo u) j)).
Proof.
  intros E E' Hi Hj. split.
  - intros S. split; intros p; rewrite (facet_corners t s i p E Hi), (facet_corners u s' j p E' Hj),
      !in_map_iff; intros (k & <- & I); exists k; split; auto; now apply S.
  - intros [A B] k. split; intros I.
    + assert (J : In (spot k) (facet_of (geo u) j)).
      { apply A, (facet_corners t s i _ E Hi). now apply in_map. }
      apply (facet_corners u s' j _ E' Hj), in_map_iff in J. destruct J as (k' & Q & J).
      replace k with k'; [assumption|].
      apply (corner_inj u s' t s); eauto using in_remove.
    + assert (J : In (spot k) (facet_of (geo t) i)).
      { apply B, (facet_corners u s' j _ E' Hj). now apply in_map. }
      apply (facet_corners t s i _ E Hi), in_map_iff in J. destruct J as (k' & Q & J).
      replace k with k'; [assumption|].
      apply (corner_inj t s u s'); eauto using in_remove.
Qed.
Lemma shared_index t s i u s' j : simplex_at t s -> simplex_at u s' -> (i <= d)%nat ->
  shared (remove i (corners s)) (remove j (corners s')) -> (j <= d)%nat.
Proof.
  intros E E' Hi S. destruct (le_dec j d) as [|N]; [assumption|exfalso].
  pose proof (corners_length u s' E') as L. rewrite (remove_none j) in S by lia.
  assert (I : incl (corners s') (remove i (corners s))) by (intros k; apply S).
  apply (NoDup_incl_length (corners_NoDup u s' E')) in I.
  rewrite (remove_length_pred i (corners s) d (corners_length t s E) Hi) in I. lia.
Qed.

(** ** The hull, and points inside and outside *)

Lemma hull_supported t i p : In t tets -> (i <= d)%nat -> outer tets geo t i -> In p P ->
  0 <= bary (geo t) i p.
Proof.
  intros Ht Hi O. apply (facet_supports tets geo P positive_d (described_agree _ G)
    (described_in _ G) (described_covering _ G)); assumption.
Qed.
Lemma beyond_bary t s i q : simplex_at t s ->
  (beyond_facet (map spot (corners s)) i q <-> (i <= d)%nat /\ bary (geo t) i q < 0).
Proof.
  intros E. pose proof (described_frame _ G t s E) as (L & V). split.
  - intros (a & b & v & Ev & Pv & Z & N).
    assert (Hi : (i <= d)%nat).
    { assert (K : nth_error (map spot (corners s)) i <> None) by congruence.
      apply nth_error_Some in K. lia. }
    split; [assumption|]. rewrite V in Ev by assumption. injection Ev as <-.
    rewrite (interpolation (geo t) (plane a b) q (affine_plane a b)) in N. unfold sum in N.
    rewrite (sum_one _ _ i) in N; [nra|apply seq_NoDup|now apply in_seq_d|].
    intros k Hk Nk. apply in_seq_d in Hk. rewrite (Z k (vertex (geo t) k)); auto. ring.
  - intros (Hi & N). destruct (bary_affine (geo t) i Hi) as (a & b & A).
    exists a, b, (vertex (geo t) i). rewrite <- !A. split; [auto|]. split.
    + rewrite bary_own by assumption. lra.
    + split; [|assumption]. intros k w Nk Ew.
      assert (Hk : (k <= d)%nat).
      { assert (K : nth_error (map spot (corners s)) k <> None) by congruence.
        apply nth_error_Some in K. lia. }
      rewrite V in Ew by assumption. injection Ew as <-. rewrite <- A. apply bary_other; auto.
Qed.
Lemma strictly_inside_bary t s q : simplex_at t s ->
  strictly_inside (map spot (corners s)) q -> inside (geo t) q.
Proof.
  intros E. rewrite <- (lists_vertices _ _ (described_frame _ G t s E)). intros (C & N) i Hi.
  pose proof (proj1 (conv_vertices (geo t) q) C) as I.
  destruct (Rle_lt_or_eq_dec _ _ (I i Hi)) as [|Z]; [assumption|exfalso].
  apply (not_in_facet_of (geo t) i Hi). apply (N (facet_of (geo t) i)).
  - now apply facet_of_incl.
  - apply (conv_face (geo t) _ q (facet_of_incl (geo t) i Hi)). split; [assumption|].
    intros k Hk Pk.
    apply in_facet_of; [assumption|]. exists k. split; [assumption|]. split; [|reflexivity].
    intros ->. lra.
  - apply in_vertices. eauto.
Qed.
(** A point strictly inside a simplex is strictly on the inner side of all hull facets. *)
Lemma inside_facet t0 o t i : In t0 tets -> inside (geo t0) o -> In t tets -> (i <= d)%nat ->
  outer tets geo t i -> 0 < bary (geo t) i o.
Proof.
  intros H0 I Ht Hi O. apply strictly_inner with (u := geo t0); [assumption..|].
  intros k Hk. apply hull_supported; auto. apply (described_in _ G t0 H0), in_vertices. eauto.
Qed.
End Geometry.
End ListedMesh.
