(** * Completeness: no certificate is rejected for its geometry

    If the certificate is honest ([Honest.v]) and its claim is true, then each number that the
    checker computes has the sign that it asks for.  Simplices are not flat, since vertices are
    affinely independent; the sample point is beyond some facet of every other simplex, since it
    is in no other; it is inside the hull facets, and ridges are convex, since hull facets support
    all points; and no lifted point is below a witness plane.  The theorem is [check_complete]. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Bool.
From Circumspect Require Import Checker Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Facets Matched Adjacency.
From Circumspect Require Import Cone LiftingMap Orientation Integers Incidence Accepted.
From Circumspect Require Import Honest Permutations Determinants ListedMesh HonestMesh HonestHull.
Import ListNotations.
Open Scope R_scope.

(** ** Acceptance of lists *)

Lemma accept_each {A} (f : positive -> A -> result) l :
  (forall k a, numbered l k = Some a -> f k a = Accepted) -> each f 1 l = Accepted.
Proof.
  intros N. assert (K : forall l k0,
    (forall i a, nth_error l i = Some a -> f (Pos.of_succ_nat i + k0 - 1)%positive a = Accepted) ->
    each f k0 l = Accepted).
  { clear l N. induction l as [|a l IH]; intros k0 N; cbn [each]; [reflexivity|].
    pose proof (N O a eq_refl) as A0.
    replace (Pos.of_succ_nat 0 + k0 - 1)%positive with k0 in A0 by lia. rewrite A0.
    apply IH. intros i b Hb. rewrite <- (N (S i) b Hb). f_equal. lia. }
  apply K. intros i a Ha. apply N. unfold numbered.
  replace (pred (Pos.to_nat (Pos.of_succ_nat i + 1 - 1))) with i by lia. exact Ha.
Qed.
Lemma accept_each_index {A} (f : nat -> A -> result) l :
  (forall i a, nth_error l i = Some a -> f i a = Accepted) -> each_index f 0 l = Accepted.
Proof.
  intros N. assert (K : forall l k0,
    (forall i a, nth_error l i = Some a -> f (k0 + i)%nat a = Accepted) ->
    each_index f k0 l = Accepted).
  { clear l N. induction l as [|a l IH]; intros k0 N; cbn [each_index]; [reflexivity|].
    pose proof (N O a eq_refl) as A0. rewrite Nat.add_0_r in A0. rewrite A0.
    apply IH. intros i b Hb. rewrite <- (N (S i) b Hb). f_equal. lia. }
  apply K. exact N.
Qed.

Section Completeness.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis Or : oriented orient.
Hypothesis Co : computes orient pr.
Hypothesis not_flat : forall X (t : frame d), lists X t -> orient X <> 0.
Hypothesis positive_d : (1 <= d)%nat.
Variable c : certificate.
Hypothesis H : honest orient c.
Let HL : well_listed orient c := honest_listed _ _ H.
Notation P := (points_of_certificate d c).
Notation r := (unit_of c).
Notation spot := (spot d c).
Notation point_at k e := (numbered (points c) k = Some e).
Notation simplex_at t s := (numbered (Definitions.simplices c) t = Some s).
Notation hull_at h f := (numbered (Definitions.hull c) h = Some f).
Notation tets := (numbers (Definitions.simplices c)).
Notation m := (mesh_of c).
Notation o := (sample_point (d := d) c).
Notation sites s := (sites_of (d := d) (c := c) s).
Let dim_d : dimension pr = d := computes_dimension _ _ Co.

Variable geo : positive -> frame d.
Hypothesis G : described c geo.
(** The claim, in terms of heights. *)
Variable h : point d -> R.
Hypothesis heights : delaunay_of (claimed c) = true ->
  forall k e, point_at k e -> h (spot k) = @height_of d r (site_at d c k).
Hypothesis nothing_below : delaunay_of (claimed c) = true ->
  forall t p, In t tets -> In p P -> witness h (geo t) p <= h p.

Lemma find_known l : (forall k, In k l -> exists e, point_at k e) ->
  find_all (points_of m) l = Some (map (site_at d c) l).
Proof.
  induction l as [|k l IH]; intros K; cbn [find_all map]; [reflexivity|].
  rewrite find_point. destruct (K k (or_introl eq_refl)) as (e & E). rewrite E. cbn [option_map].
  rewrite IH by (intros; apply K; now right). unfold site_at at 2. now rewrite E.
Qed.
Lemma find_corners t s : simplex_at t s -> find_all (points_of m) (corners s) = Some (sites s).
Proof. intros E. apply find_known. intros k. apply (corner_known c HL t s k E). Qed.
Lemma find_corner k e : point_at k e -> Table.find k (points_of m) = Some (site_at d c k).
Proof. intros E. rewrite find_point. unfold site_at. now rewrite E. Qed.

(** [side] and [depth] have the right signs. *)
Lemma side_closed t s i p : simplex_at t s -> (i <= d)%nat -> well_shaped d p ->
  0 <= bary (geo t) i (place_of r p) -> (0 <= side pr i (sites s) p 1)%Z.
Proof.
  intros E Hi Sh B.
  destruct (listed_side Or Co not_flat c HL geo G t s i p 1 E Hi Sh ltac:(lia)) as (q & Q & S).
  replace (r / 1) with r in S by field. apply le_IZR. rewrite S. apply Rmult_le_pos; lra.
Qed.
Lemma side_sample t s i : simplex_at t s -> (i <= d)%nat -> exists q, 0 < q /\
  IZR (side pr i (sites s) (sample c) (sample_denominator c)) = q * bary (geo t) i o.
Proof.
  intros E Hi. destruct (honest_sample_shape _ _ H) as [Sh W].
  exact (listed_side Or Co not_flat c HL geo G t s i (sample c) _ E Hi Sh W).
Qed.
Lemma depth_low t s k e : delaunay_of (claimed c) = true -> simplex_at t s -> point_at k e ->
  (depth pr (sites s) (slope pr (sites s)) (site_at d c k) <= 0)%Z.
Proof.
  intros Cl E Ek. pose proof (heights Cl k e Ek) as Hk.
  pose proof (nothing_below Cl t (spot k) (in_tets c t s E) (spot_in d c k e Ek)) as L.
  rewrite (spot_site d c k e Ek) in Hk, L.
  destruct (listed_depth Or Co not_flat c HL geo G h t s (site_at d c k) (heights Cl) E
    (listed_site c HL k) Hk) as (q & Q & S).
  apply le_IZR. rewrite S. nra.
Qed.

(** [point-used] *)
Lemma point_complete k e : point_at k e -> check_point pr m k e = Accepted.
Proof.
  intros E. unfold check_point. replace (used pr m k e) with true; [reflexivity|symmetry].
  destruct (honest_home _ _ H k e E) as (s & Es & K). unfold used. rewrite find_simplex, Es.
  destruct (home_vertex e) as [i|]; [rewrite K; apply Pos.eqb_refl|]. destruct K as (Cl & C).
  change (weights_claimed m) with (weights_of (claimed c)). rewrite (find_corners (home e) s Es).
  assert (At : site_at d c k = position e) by (unfold site_at, site_of; now rewrite E, Cl).
  pose proof (listed_site c HL k) as Sh. rewrite At in Sh.
  rewrite Cl. cbn [weights_of andb]. apply andb_true_intro. split.
  - assert (I : forall n, (n <= S d)%nat -> in_closed pr n (sites s) (position e) = true).
    { induction n as [|n IH]; intros Hn; cbn [in_closed]; [reflexivity|].
      apply andb_true_intro. split; [|apply IH; lia]. apply Z.leb_le.
      apply (side_closed (home e) s); try assumption; [lia|].
      rewrite (spot_numbered d c k e E) in C.
      rewrite <- (lists_vertices _ _ (described_frame _ _ G _ s Es)) in C.
      apply conv_vertices in C. apply C. lia. }
    rewrite dim_d. apply I. lia.
  - apply Z.leb_le. rewrite <- At. apply (depth_low (home e) s k e); auto. now rewrite Cl.
Qed.

(** [sample-inside] *)
Lemma sample_complete : inside_sample pr m = true.
Proof.
  destruct (honest_sample _ _ H) as (s & E & I). destruct (honest_sample_shape _ _ H) as [Sh W].
  unfold inside_sample. change (sample_of m) with (sample c).
  change (sample_w m) with (sample_denominator c). change (start m) with (sample_simplex c).
  rewrite find_simplex, E, (find_corners _ s E).
  apply andb_true_intro; split; [apply andb_true_intro; split|].
  - unfold shaped. rewrite dim_d. now apply Nat.eqb_eq.
  - now apply Z.ltb_lt.
  - assert (K : forall n, (n <= S d)%nat -> in_open pr m n (sites s) = true).
    { induction n as [|n IH]; intros Hn; cbn [in_open]; [reflexivity|].
      apply andb_true_intro. split; [|apply IH; lia]. apply Z.ltb_lt.
      destruct (side_sample _ s n E ltac:(lia)) as (q & Q & S).
      pose proof (strictly_inside_bary c geo G _ s o E I n ltac:(lia)) as B.
      apply lt_IZR. change (sample_of m) with (sample c).
      change (sample_w m) with (sample_denominator c). rewrite S. now apply Rmult_lt_0_compat. }
    rewrite dim_d. apply K. lia.
Qed.

(** [sample-outside] *)
Lemma outside_complete t s : simplex_at t s -> outside_sample pr m t (sites s) (away s) = true.
Proof.
  intros E. unfold outside_sample. change (start m) with (sample_simplex c).
  destruct (Pos.eqb_spec t (sample_simplex c)) as [|N]; [reflexivity|]. cbn [orb].
  destruct (sample_covered_once c H geo G) as (_ & _ & Out).
  destruct (Out t (in_tets c t s E) N) as (i & Hi & B).
  destruct (honest_away _ _ H t s E N) as (j & -> & Bj).
  - exists i. now apply (beyond_bary positive_d c geo G t s i o E).
  - apply (beyond_bary positive_d c geo G t s j o E) in Bj. destruct Bj as (Hj & Bj).
    destruct (side_sample t s j E Hj) as (q & Q & S). apply Z.ltb_lt, lt_IZR.
    change (sample_of m) with (sample c). change (sample_w m) with (sample_denominator c).
    rewrite S. nra.
Qed.

(** [facet-matched], [back-pointer], [facet-locally-delaunay], [hull-pointer] *)
Lemma wall_complete t s i w : simplex_at t s -> nth_error (walls s) i = Some w ->
  check_wall pr m t (corners s) (sites s)
    (if delaunay_of (claimed c) then slope pr (sites s) else []) i w = Accepted.
Proof.
  intros E W. destruct w as [u j|g]; cbn [check_wall].
  - destruct (neighbour_adjacent Co positive_d c H geo G t s i u j E W)
      as (s' & E' & Hi & Hj & S & _ & _ & O).
    rewrite find_simplex, E'.
    rewrite (opposite_matched Or spot (corners s) (corners s') (geo t) (geo u) i j
      (described_frame _ _ G t s E) (described_frame _ _ G u s' E')
      (positive_listed not_flat c HL geo G t s E) (positive_listed not_flat c HL geo G u s' E')
      (corners_NoDup c geo G t s E) (corners_NoDup c geo G u s' E') Hi Hj S)
      by apply O.
    unfold points_back.
    rewrite (neighbour_back Co positive_d c H geo G t s i u s' j E E' W).
    rewrite Pos.eqb_refl, Nat.eqb_refl. cbn [andb].
    change (delaunay_claimed m) with (delaunay_of (claimed c)).
    destruct (bool_dec (delaunay_of (claimed c)) true) as [Cl|Cl];
      [rewrite Cl; cbv iota|apply not_true_is_false in Cl; now rewrite Cl].
    destruct (Pos.ltb t u); [|reflexivity]. cbn [andb].
    destruct (listed_corner_of c geo G u s' j E' Hj) as (v & Ev & _). rewrite Ev.
    destruct (corner_known c HL u s' v E' (nth_error_In _ _ Ev)) as (e & Ek).
    rewrite (find_corner v e Ek). unfold apex_outside.
    pose proof (depth_low t s v e Cl E Ek) as L. apply Z.leb_le in L. now rewrite L.
  - destruct (honest_on_hull _ _ H t s i g E W) as ((f & Ef & C & A) & _).
    unfold names_hull. rewrite find_hull, Ef, C, A, Pos.eqb_refl, Nat.eqb_refl. reflexivity.
Qed.

(** [vertex-known], [simplex-positive] *)
Lemma simplex_complete t s : simplex_at t s -> check_simplex pr m t s = Accepted.
Proof.
  intros E. unfold check_simplex. rewrite (find_corners t s E).
  assert (0 < orientation pr (sites s))%Z as Pos.
  { pose proof (positive_listed not_flat c HL geo G t s E) as O.
    rewrite (listed_spots c HL t s E), (computes_orientation _ _ Co) in O by apply (listed_sites c
      HL).
    pose proof (pow_lt r d (listed_unit c HL)). apply lt_IZR. nra. }
  unfold positive_simplex. apply Z.ltb_lt in Pos. rewrite Pos.
  rewrite dim_d, (honest_walls _ _ H t s E), Nat.eqb_refl, (outside_complete t s E). cbv zeta.
  apply accept_each_index. intros i w W. now apply wall_complete.
Qed.

(** [ridge-matched], [ridge-back-pointer], [hull-locally-convex] *)
Lemma ridge_complete g f s a q : hull_at g f -> simplex_at (Definitions.carrier f) s ->
  nth_error (ridges f) a = Some q ->
  check_ridge pr m g (apex f) (remove (apex f) (corners s)) (sites s) a q = Accepted.
Proof.
  intros Ef E Er. destruct q as [g' b]. unfold check_ridge.
  destruct (ridge_named Co positive_d c H geo G g f s a g' b Ef E Er)
    as (f' & s' & Ef' & E' & Ha & Hb & S & _).
  rewrite find_hull, Ef', find_simplex, E'. cbv zeta.
  rewrite (ridge_matched Or Co not_flat positive_d c H geo G g f s a g' b f' s' Ef E Er Ef' E').
  unfold ridge_points_back.
  rewrite (ridge_back Co positive_d c H geo G g f s a g' b f' Ef E Er Ef').
  rewrite Pos.eqb_refl, Nat.eqb_refl. cbn [andb].
  destruct (entry_facet Co positive_d c H geo G g f Ef) as (_ & _ & _ & Ft).
  destruct (entry_facet Co positive_d c H geo G g' f' Ef') as (_ & _ & _ & Fu).
  pose proof Ft as (Ht & Hi & O). pose proof Fu as (_ & Hj & _).
  pose proof (corners_length c geo G _ s' E') as L.
  rewrite remove_nth by lia.
  destruct (listed_corner_of c geo G _ s' (skip (apex f') b) E' (skip_le _ _ _ Hb)) as (v & Ev & _).
  rewrite Ev. destruct (corner_known c HL _ s' v E' (nth_error_In _ _ Ev)) as (e & Ek).
  rewrite (find_corner v e Ek). unfold Checker.locally_convex.
  assert (0 <= side pr (apex f) (sites s) (site_at d c v) 1)%Z as Q.
  { apply (side_closed (Definitions.carrier f) s); auto; [apply (listed_site c HL)|].
    rewrite <- (spot_site d c v e Ek).
    apply (hull_supported positive_d c geo G); auto. now apply spot_in with e. }
  apply Z.leb_le in Q. now rewrite Q.
Qed.

(** [hull-pointer], [sample-inside-hull] *)
Lemma hull_complete g f : hull_at g f -> check_hull pr m g f = Accepted.
Proof.
  intros Ef. destruct (entry_facet Co positive_d c H geo G g f Ef) as (s & E & W & Ft).
  unfold check_hull. rewrite find_simplex, E. unfold named_by_facet. rewrite W, Pos.eqb_refl.
  rewrite (find_corners _ s E). unfold inside_hull_facet.
  assert (0 < side pr (apex f) (sites s) (sample_of m) (sample_w m))%Z as Q.
  { destruct (side_sample _ s (apex f) E) as (q & Q & S); [apply Ft|].
    apply lt_IZR. change (sample_of m) with (sample c).
    change (sample_w m) with (sample_denominator c). rewrite S.
    apply Rmult_lt_0_compat; [assumption|].
    exact (facet_sample positive_d c H geo G _ _ Ft). }
  apply Z.ltb_lt in Q. rewrite Q, dim_d, (honest_ridges _ _ H g f Ef), Nat.eqb_refl.
  apply accept_each_index. intros a q Er. now apply ridge_complete.
Qed.

Theorem check_in_complete : check_in pr c = Accepted.
Proof.
  unfold check_in. destruct (listed_scale _ _ HL) as [N D]. unfold scaled.
  apply Z.ltb_lt in N, D. rewrite N, D. cbn [andb]. cbv zeta.
  rewrite (points_accepted Co c HL), (accept_each _ _ point_complete), sample_complete.
  rewrite (accept_each _ _ simplex_complete). apply accept_each, hull_complete.
Qed.
End Completeness.

(** ** The theorem *)

Theorem honest_accepted {d : nat} {orient : list (point d) -> R} {pr : predicates} c :
  oriented orient -> computes orient pr ->
  (forall X (t : frame d), lists X t -> orient X <> 0) -> (1 <= d)%nat ->
  honest orient c -> claim_holds d c -> check_in pr c = Accepted.
Proof.
  intros Or Co NF D H Claim. unfold claim_holds in Claim. cbv zeta in Claim.
  assert (F : fills (points_of_certificate d c) (simplices_of_certificate d c)).
  { destruct (claimed c); [apply Claim..|]. destruct Claim as (w & _ & F & _). exact F. }
  assert (Some : simplices_of_certificate d c <> []).
  { destruct (honest_sample _ _ H) as (s & E & _). apply (in_simplex_list (d := d)) in E. intros N.
    rewrite N in E. destruct E. }
  destruct (description D c F Some) as (geo & G).
  assert (Vs : forall t, In t (numbers (Definitions.simplices c)) ->
    In (vertices (geo t)) (simplices_of_certificate d c)).
  { intros t Ht. apply in_numbers in Ht. destruct Ht as (s & E).
    rewrite (lists_vertices _ _ (described_frame _ _ G t s E)). now apply in_simplex_list with t. }
  destruct (claimed c) eqn:Cl.
  - apply (check_in_complete Or Co NF D c H geo G (fun _ => 0)); rewrite Cl; discriminate.
  - apply (check_in_complete Or Co NF D c H geo G norm2); intros _.
    + intros k e E. rewrite (spot_site d c k e E). unfold height_of, site_at, site_of.
      rewrite E, Cl. cbn [weights_of weight]. ring.
    + intros t p Ht Hp. apply (delaunay_witness (points_of_certificate d c)); [|assumption].
      now apply Claim, Vs.
  - destruct Claim as (w & W & _ & Wd).
    apply (check_in_complete Or Co NF D c H geo G (fun p => norm2 p - w p)); intros _.
    + intros k e E. rewrite (spot_numbered d c k e E), W by now apply numbered_in with k.
      unfold height_of, site_at, site_of. now rewrite E, Cl.
    + intros t p Ht Hp.
      apply (proj1 (witness_plane_witness (fun p => norm2 p - w p) (points_of_certificate d c)
        (geo t)) (Wd _ (Vs t Ht)) p Hp).
Qed.

Theorem check_complete D c : honest_certificate D c -> claim_holds (dimension_of D) c ->
  check D c = Accepted.
Proof.
  destruct D; intros H C.
  - apply (honest_accepted c oriented2 plane_computes not_flat2); auto.
  - apply (honest_accepted c oriented3 space_computes not_flat3); auto; cbn; lia.
Qed.
