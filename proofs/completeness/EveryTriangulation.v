(** * Every triangulation has an honest certificate

    What a certificate has to say is there to be said: a facet has a neighbour or is a hull facet
    ([Adjacency.v]); a ridge has a hull facet on its other side ([RidgeNeighbours.v]); the
    barycentre of any simplex can be the sample point.  So the points and simplices of a true claim
    can be completed to a certificate that is accepted ([certificate_exists]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Sorting.Sorted.
From Circumspect Require Import Checker Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Facets Matched Adjacency.
From Circumspect Require Import Cone Orientation Integers Incidence Accepted Honest Permutations.
From Circumspect Require Import Determinants ListedMesh Ridges RidgeNeighbours HonestHull.
From Circumspect Require Import Completeness Drafts.
Import ListNotations.
Open Scope R_scope.

(** ** The honest certificate *)

Section Construction.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis Co : computes orient pr.
Hypothesis two : (2 <= d)%nat.
Variable c : certificate.
Hypothesis HL : well_listed orient c.
Variable geo : positive -> frame d.
Hypothesis G : described c geo.
Notation P := (points_of_certificate d c).
Notation tets := (numbers (Definitions.simplices c)).
Variables (t0 : positive) (s0 : site) (w0 : Z).
Notation o := (@place_of d (unit_of c / IZR w0) s0).
Hypothesis H0 : In t0 tets.
Hypothesis I0 : inside (geo t0) o.
Hypothesis S0 : length (coordinates s0) = d /\ (0 < w0)%Z.
Hypothesis used : forall k e, numbered (points c) k = Some e ->
  exists t s, numbered (Definitions.simplices c) t = Some s /\
    ((exists i, nth_error (corners s) i = Some k) \/
     claimed c = WeightedDelaunay /\ conv (map (spot d c) (corners s)) (spot d c k)).

Let one : (1 <= d)%nat := one_dimension two.
Notation outer := (outer tets geo).
Notation facet := (hull_facet tets geo outer).
Notation cone t i := (cone_over (geo t) i o).

Lemma o_inner t i : facet t i -> 0 < bary (geo t) i o.
Proof. intros (Ht & Hi & O). exact (inside_facet one c geo G t0 o t i H0 I0 Ht Hi O). Qed.
Lemma o_cone t i : facet t i -> cone_of (geo t) i o (cone t i).
Proof. intros F. pose proof (o_inner t i F). apply cone_over_cone; [apply F|lra]. Qed.
Lemma supported : supporting tets geo outer (fun p => In p P).
Proof. intros t i Ht Hi O p Hp. exact (hull_supported one c geo G t i p Ht Hi O Hp). Qed.

(** What there is to be said of a wall and of a ridge, given the list [L] of the hull facets. *)
Definition wall_said (L : list (positive * nat)) t i w : Prop :=
  match w with
  | Neighbour u j => adjacent tets geo t i u j
  | OnHull h => numbered L h = Some (t, i)
  end.
Definition ridge_said (L : list (positive * nat)) t i a (q : positive * nat) : Prop :=
  exists u j, numbered L (fst q) = Some (u, j) /\ ~ (t = u /\ i = j) /\ (snd q < d)%nat /\
    same (facet_of (cone t i) (skip i a)) (facet_of (cone u j) (skip j (snd q))).

Lemma hull_list : exists L, NoDup L /\ forall t i, In (t, i) L <-> facet t i.
Proof.
  destruct (hull_facet_list tets geo) as (L & E).
  assert (D : forall x y : positive * nat, {x = y} + {x <> y}).
  { intros [t i] [u j]. destruct (Pos.eq_dec t u), (Nat.eq_dec i j);
      (left; congruence) || (right; congruence). }
  exists (nodup D L). split; [apply NoDup_nodup|]. intros t i. rewrite nodup_In. apply E.
Qed.
Lemma wall_exists L t i : (forall t i, In (t, i) L <-> facet t i) -> In t tets -> (i <= d)%nat ->
  exists w, wall_said L t i w.
Proof.
  intros HL' Ht Hi. destruct (adjacent_dec tets geo t i Ht) as [(u & j & A)|O].
  - now exists (Neighbour u j).
  - assert (I : In (t, i) L) by (apply HL'; now split).
    apply in_numbered in I. destruct I as (h & E). now exists (OnHull h).
Qed.
Lemma ridge_exists L t i a : (forall t i, In (t, i) L <-> facet t i) -> facet t i -> (a < d)%nat ->
  exists q, ridge_said L t i a q.
Proof.
  intros HL' F Ha. destruct (ridge_neighbour tets geo P two (described_agree _ _ G)
    (described_different _ _ G) (described_in _ _ G) supported o (fun t i => cone t i)
    o_inner o_cone t i (skip i a) F) as (u & j & l & Fu & N & Hl & Nl & E).
  { now apply skip_le. } { apply skip_ne. }
  pose proof Fu as (_ & Hj & _). destruct (skip_onto j l d Hl Hj Nl) as (b & Hb & <-).
  pose proof (proj2 (HL' u j) Fu) as I. apply in_numbered in I. destruct I as (g & Eg).
  exists (g, b), u, j. auto.
Qed.

Definition simplex_said L t (s s' : simplex_entry) : Prop :=
  corners s' = corners s /\ length (walls s') = S d /\
  (forall i w, nth_error (walls s') i = Some w -> wall_said L t i w) /\
  (t <> t0 -> exists i, away s' = Some i /\ (i <= d)%nat /\ bary (geo t) i o < 0).
Definition hull_said L (x : positive * nat) (f : hull_entry) : Prop :=
  Definitions.carrier f = fst x /\ apex f = snd x /\ length (ridges f) = d /\
  forall a q, nth_error (ridges f) a = Some q -> ridge_said L (fst x) (snd x) a q.
Definition point_said k (e e' : point_entry) : Prop := position e' = position e /\
  exists s, numbered (Definitions.simplices c) (home e') = Some s /\
    match home_vertex e' with
    | Some i => nth_error (corners s) i = Some k
    | None => claimed c = WeightedDelaunay /\ conv (map (spot d c) (corners s)) (spot d c k)
    end.

Lemma simplex_sayable L t s : (forall t i, In (t, i) L <-> facet t i) ->
  numbered (Definitions.simplices c) t = Some s -> exists s', simplex_said L t s s'.
Proof.
  intros HL' E. pose proof (in_tets c t s E) as Ht.
  destruct (build_index (wall_said L t) (S d)) as (ws & Lw & W).
  { intros i Hi. apply wall_exists; auto. lia. }
  assert (exists a, t <> t0 -> exists i, a = Some i /\ (i <= d)%nat /\ bary (geo t) i o < 0)
    as (a & A).
  { destruct (Pos.eq_dec t t0) as [->|N]; [exists None; congruence|].
    destruct (complex_covered_once tets geo (described_agree _ _ G) (described_different _ _ G)
      t0 o H0 I0) as (_ & _ & Out).
    destruct (Out t Ht N) as (i & Hi & B). exists (Some i). eauto. }
  now exists (SimplexEntry (corners s) ws a).
Qed.

Lemma parts_exist : exists L ps ss fs, NoDup L /\ (forall t i, In (t, i) L <-> facet t i) /\
  (length ps = length (points c) /\ forall k e e', numbered (points c) k = Some e ->
    numbered ps k = Some e' -> point_said k e e') /\
  (length ss = length (Definitions.simplices c) /\ forall t s s',
    numbered (Definitions.simplices c) t = Some s -> numbered ss t = Some s' ->
    simplex_said L t s s') /\
  (length fs = length L /\ forall h x f, numbered L h = Some x -> numbered fs h = Some f ->
    hull_said L x f).
Proof.
  destruct hull_list as (L & N & HL'). exists L.
  destruct (build point_said (points c)) as (ps & Lp & Pp).
  { intros k e E. destruct (used k e E) as (t & s & Es & [(i & Ei)|W]).
    - exists (PointEntry (position e) t (Some i)). split; [reflexivity|]. now exists s.
    - exists (PointEntry (position e) t None). split; [reflexivity|]. now exists s. }
  destruct (build (simplex_said L) (Definitions.simplices c)) as (ss & Ls & Ps).
  { intros t s E. now apply simplex_sayable. }
  destruct (build (fun _ => hull_said L) L) as (fs & Lf & Pf).
  { intros h [t i] E. apply numbered_in, HL' in E.
    destruct (build_index (ridge_said L t i) d) as (rs & Lr & R).
    { intros a Ha. now apply ridge_exists. }
    now exists (HullEntry t i rs). }
  exists ps, ss, fs. auto 10.
Qed.

Section Parts.
Variables (L : list (positive * nat)) (ps : list point_entry) (ss : list simplex_entry)
  (fs : list hull_entry).
Hypothesis NL : NoDup L.
Hypothesis HF : forall t i, In (t, i) L <-> facet t i.
Hypothesis Lp : length ps = length (points c).
Hypothesis Pp : forall k e e', numbered (points c) k = Some e -> numbered ps k = Some e' ->
  point_said k e e'.
Hypothesis Ls : length ss = length (Definitions.simplices c).
Hypothesis Ps : forall t s s', numbered (Definitions.simplices c) t = Some s ->
  numbered ss t = Some s' -> simplex_said L t s s'.
Hypothesis Lf : length fs = length L.
Hypothesis Pf : forall h x f, numbered L h = Some x -> numbered fs h = Some f -> hull_said L x f.

Definition completed : certificate :=
  Certificate (claimed c) (numerator c) (denominator c) ps ss fs t0 s0 w0.

Lemma completed_same : same_input c completed.
Proof.
  repeat split; cbn [completed points Definitions.simplices].
  - apply map_pointwise; [assumption|]. intros k e e' E E'. now apply (Pp k).
  - apply map_pointwise; [assumption|]. intros t s s' E E'. now apply (Ps t).
Qed.
Let G' : described (d := d) completed geo := same_described d c completed completed_same geo G.
Let HL2 : well_listed orient completed := same_listed d c completed completed_same orient HL.

Lemma said_simplex t s' : numbered ss t = Some s' -> exists s,
  numbered (Definitions.simplices c) t = Some s /\ simplex_said L t s s' /\ In t tets.
Proof.
  intros E. destruct (numbered_same_length ss (Definitions.simplices c) t s' Ls E) as (s & Es).
  exists s. split; [assumption|]. split; [now apply Ps|]. now apply (in_tets c t s).
Qed.
Lemma there_simplex t : In t tets -> exists s', numbered ss t = Some s'.
Proof.
  intros Ht. apply in_numbers in Ht. destruct Ht as (s & E).
  now apply (numbered_same_length (Definitions.simplices c) ss t s).
Qed.
Lemma said_hull h f : numbered fs h = Some f -> exists t i, numbered L h = Some (t, i) /\
  hull_said L (t, i) f /\ facet t i.
Proof.
  intros E. destruct (numbered_same_length fs L h f Lf E) as ([t i] & El). exists t, i.
  split; [assumption|]. split; [now apply (Pf h)|]. apply HF. now apply numbered_in with h.
Qed.
Lemma there_hull h x : numbered L h = Some x -> exists f, numbered fs h = Some f.
Proof. intros E. now apply (numbered_same_length L fs h x). Qed.

Lemma completed_sample : sample_point (d := d) completed = o.
Proof. reflexivity. Qed.

Lemma adjacent_irreflexive t i j : ~ adjacent tets geo t i t j.
Proof.
  intros (_ & _ & (Hi & Hj & _ & _ & N)). rewrite bary_vertex in N by assumption.
  destruct (Nat.eq_dec i j); lra.
Qed.

(** The sample point is not a vertex of a hull facet. *)
Lemma o_no_corner t i s' k : facet t i -> numbered ss t = Some s' ->
  In k (remove i (corners s')) -> spot d completed k <> o.
Proof.
  intros F E I Eq. pose proof F as (_ & Hi & _).
  assert (V : In (spot d completed k) (facet_of (geo t) i)).
  { apply (facet_corners one completed geo G' t s' i _ E Hi). now apply in_map. }
  apply (in_facet_of _ _ _ Hi) in V. destruct V as (l & Hl & N & V).
  pose proof (o_inner t i F) as B. rewrite <- Eq, V, bary_other in B by auto. lra.
Qed.
Lemma shared_ridge t i a u j b s s' : facet t i -> facet u j -> (a < d)%nat -> (b < d)%nat ->
  numbered ss t = Some s -> numbered ss u = Some s' ->
  incl (facet_of (cone t i) (skip i a)) (facet_of (cone u j) (skip j b)) ->
  forall k, In k (remove a (remove i (corners s))) -> In k (remove b (remove j (corners s'))).
Proof.
  intros Ft Fu Ha Hb E E' I k K. pose proof Ft as (_ & Hi & _). pose proof Fu as (_ & Hj & _).
  pose proof (described_frame _ _ G' t s E) as LK.
  pose proof (described_frame _ _ G' u s' E') as LU.
  assert (J : In (spot d completed k) (facet_of (cone u j) (skip j b))).
  { apply I, (ridge_of_cone _ _ _ _ a o _ LK Hi Ha (o_cone t i Ft)). right.
    rewrite <- !remove_map. now apply in_map. }
  apply (ridge_of_cone _ _ _ _ b o _ LU Hj Hb (o_cone u j Fu)) in J. destruct J as [J|J].
  - exfalso. apply (o_no_corner t i s k Ft E); [now apply in_remove with a|assumption].
  - rewrite <- !remove_map in J. apply in_map_iff in J. destruct J as (k' & Eq & J).
    replace k with k'; [assumption|].
    apply (corner_inj Co one completed HL2 u s' t s); try assumption.
    + apply in_remove with j. now apply in_remove with b.
    + apply in_remove with i. now apply in_remove with a.
Qed.

Theorem completed_honest : honest orient completed.
Proof.
  constructor.
  - exact HL2.
  - intros k e' E. destruct (numbered_same_length ps (points c) k e' Lp E) as (e & Ee).
    destruct (Pp k e e' Ee E) as (_ & s & Es & K).
    destruct (there_simplex (home e')) as (s' & Es'); [now apply (in_tets c _ s)|].
    exists s'. split; [assumption|]. destruct (Ps _ s s' Es Es') as (-> & _).
    destruct (home_vertex e'); [assumption|].
    rewrite (map_ext _ _ (same_spot d c completed completed_same)),
      (same_spot d c completed completed_same). exact K.
  - intros t s' E. destruct (said_simplex t s' E) as (s & _ & (_ & K & _) & _). exact K.
  - intros t s' i u j E W. destruct (said_simplex t s' E) as (s & _ & (_ & _ & K & _) & _).
    pose proof (K i _ W) as Adj. cbn [wall_said] in Adj. pose proof Adj as (_ & Hu & O).
    split; [intros <-; now apply (adjacent_irreflexive t i j)|].
    destruct (there_simplex u Hu) as (s2 & E2). exists s2. split; [assumption|].
    apply opposite_facets in O.
    apply (shared_facets Co one completed HL2 geo G' t s' i u s2 j E E2); tauto.
  - intros t s' i h E W. destruct (said_simplex t s' E) as (s & _ & (_ & _ & K & _) & Ht).
    pose proof (K i _ W) as N. cbn [wall_said] in N. split.
    + destruct (there_hull h _ N) as (f & Ef). exists f. split; [assumption|].
      destruct (Pf h _ f N Ef) as (C & A & _). auto.
    + pose proof (proj1 (HF t i) (numbered_in _ _ _ N)) as (_ & Hi & O).
      intros u s2 j E2 Nu S. pose proof (shared_index one completed geo G' t s' i u s2 j E E2 Hi S).
      apply (O u j). destruct (said_simplex u s2 E2) as (_ & _ & _ & Hu).
      split; [assumption|]. split; [assumption|].
      apply (shared_facet tets geo one (described_agree _ _ G) (described_different _ _ G)); auto.
      now apply (shared_facets Co one completed HL2 geo G' t s' i u s2 j).
  - intros h f E. destruct (said_hull h f E) as (t & i & El & (C & A & _) & F).
    cbn [fst snd] in C, A. rewrite C, A. pose proof F as (Ht & Hi & O).
    destruct (there_simplex t Ht) as (s' & Es'). exists s'. split; [assumption|].
    destruct (said_simplex t s' Es') as (s & _ & (_ & Lw & K & _) & _).
    destruct (nth_error (walls s') i) as [w|] eqn:W; [|apply nth_error_None in W; lia].
    pose proof (K i w W) as N. destruct w as [u j|h']; cbn [wall_said] in N.
    + exfalso. exact (O u j N).
    + do 2 f_equal. now apply (numbered_NoDup L h' h (t, i)).
  - intros h f E. destruct (said_hull h f E) as (t & i & _ & (_ & _ & K & _) & _). exact K.
  - intros h f s' a g b E Es W. destruct (said_hull h f E) as (t & i & El & (C & A & Lr & K) & F).
    cbn [fst snd] in *. rewrite C in Es. rewrite A.
    destruct (K a _ W) as (u & j & Eg & N & Hb & [I J]). cbn [fst snd] in *.
    assert (Ha : (a < d)%nat). { rewrite <- Lr. apply nth_error_Some. congruence. }
    assert (Fu : facet u j) by (apply HF; now apply numbered_in with g).
    split; [intros <-; apply N; split; congruence|].
    destruct (there_hull g _ Eg) as (f' & Ef'). destruct (Pf g _ f' Eg Ef') as (C' & A' & _).
    cbn [fst snd] in C', A'. destruct (there_simplex u) as (s2 & E2); [apply Fu|].
    exists f', s2. rewrite C', A'. split; [assumption|]. split; [assumption|].
    intros k. split.
    + now apply (shared_ridge t i a u j b s' s2).
    + now apply (shared_ridge u j b t i a s2 s').
  - exact S0.
  - destruct (there_simplex t0 H0) as (s & E). exists s. split; [assumption|].
    rewrite <- (lists_vertices _ _ (described_frame _ _ G' t0 s E)), completed_sample.
    assert (Cl : inside_closed (geo t0) o) by (intros i Hi; left; auto).
    split; [now apply conv_vertices|]. intros f I C v Hv.
    apply (conv_face (geo t0) f o I) in C. destruct C as (_ & C).
    apply in_vertices in Hv. destruct Hv as (i & Hi & ->). auto.
  - intros t s' E N _. destruct (said_simplex t s' E) as (s & _ & (_ & _ & _ & K) & _).
    destruct (K N) as (i & Ai & Hi & B). exists i. split; [assumption|].
    rewrite completed_sample. now apply (beyond_bary one completed geo G' t s' i o E).
Qed.
End Parts.

Theorem construction : exists c', same_input c c' /\ honest orient c'.
Proof.
  destruct parts_exist as (L & ps & ss & fs & NL & HF & (Lp & Pp) & (Ls & Ps) & Lf & Pf).
  exists (completed ps ss fs). split.
  - now apply (completed_same L ps ss fs).
  - now apply (completed_honest L ps ss fs).
Qed.
End Construction.

(** ** The theorem *)

Lemma claim_fills d c : claim_holds d c ->
  fills (points_of_certificate d c) (simplices_of_certificate d c).
Proof.
  unfold claim_holds. destruct (claimed c); intros C; [apply C|apply C|].
  destruct C as (w & _ & F & _). exact F.
Qed.

Section Existence.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis Co : computes orient pr.
Hypothesis two : (2 <= d)%nat.
Variable c : certificate.
Hypothesis HL : well_listed orient c.
Hypothesis claim : claim_holds d c.
Let one : (1 <= d)%nat := one_dimension two.

(** A simplex of the claim is a simplex of the certificate. *)
Lemma listed_simplex t : In t (simplices_of_certificate d c) -> exists k s,
  numbered (Definitions.simplices c) k = Some s /\ t = map (spot d c) (corners s).
Proof.
  intros I. apply in_map_iff in I. destruct I as (s & <- & I). apply in_numbered in I.
  destruct I as (k & E). eauto.
Qed.
Lemma points_used k e : numbered (points c) k = Some e ->
  exists t s, numbered (Definitions.simplices c) t = Some s /\
    ((exists i, nth_error (corners s) i = Some k) \/
     claimed c = WeightedDelaunay /\ conv (map (spot d c) (corners s)) (spot d c k)).
Proof.
  intros E. pose proof (spot_in d c k e E) as I.
  assert (V : triangulation (points_of_certificate d c) (simplices_of_certificate d c) ->
    exists t s, numbered (Definitions.simplices c) t = Some s /\
      exists i, nth_error (corners s) i = Some k).
  { intros (_ & V). destruct (V _ I) as (x & Hx & Ix).
    destruct (listed_simplex x Hx) as (t & s & Es & ->). exists t, s. split; [assumption|].
    apply in_map_iff in Ix. destruct Ix as (k' & Q & Ik).
    destruct (corner_known c HL t s k' Es Ik) as (e' & E').
    replace k with k' by exact (spot_inj Co one c HL k' e' k e E' E Q).
    now apply In_nth_error. }
  pose proof claim as C. pose proof (claim_fills d c claim) as F. unfold claim_holds in C.
  cbv zeta in C. destruct (claimed c).
  - destruct (V C) as (t & s & Es & X). exists t, s. auto.
  - destruct (V (proj1 C)) as (t & s & Es & X). exists t, s. auto.
  - destruct F as (_ & _ & _ & _ & U). pose proof (conv_point _ _ I) as Cp.
    apply U in Cp. destruct Cp as (x & Hx & Cx).
    destruct (listed_simplex x Hx) as (t & s & Es & ->). exists t, s. auto.
Qed.

Theorem honest_exists : points c <> [] -> exists c', same_input c c' /\ honest orient c'.
Proof.
  intros NE. pose proof (claim_fills d c claim) as F.
  assert (exists t, In t (simplices_of_certificate d c)) as (x & Hx).
  { destruct F as (_ & _ & _ & _ & U). destruct (points c) as [|e l] eqn:E; [congruence|].
    assert (I : In (place_of (unit_of c) (position e)) (points_of_certificate d c)).
    { unfold points_of_certificate. rewrite E. now left. }
    apply conv_point, U in I. destruct I as (t & Ht & _). eauto. }
  assert (Some : simplices_of_certificate d c <> []) by (intros E; now rewrite E in Hx).
  destruct (description one c F Some) as (geo & G).
  destruct (listed_simplex x Hx) as (t0 & s & Es & _).
  set (s0 := Site (sum_of d (sites_of (d := d) (c := c) s)) 0). set (w0 := Z.of_nat (S d)).
  assert (Eo : @place_of d (unit_of c / IZR w0) s0 = barycentre (geo t0)).
  { unfold s0. unfold place_of. cbn [coordinates].
    rewrite sum_combination by apply (listed_sites c HL).
    rewrite <- (map_map (@place_of d (unit_of c)) (fun p => (/ IZR w0, p))),
      <- (listed_spots c HL t0 s Es), <- (lists_vertices _ _ (described_frame _ _ G t0 s Es)).
    unfold vertices, barycentre. rewrite map_map. unfold w0. now rewrite <- INR_IZR_INZ. }
  apply (construction Co two c HL geo G t0 s0 w0).
  - now apply (in_tets c t0 s).
  - rewrite Eo. apply barycentre_inside.
  - split; [|unfold w0; lia]. unfold s0. cbn [coordinates]. apply sum_length, (listed_sites c HL).
  - exact points_used.
Qed.
End Existence.

Theorem certificate_exists D c : well_listed_certificate D c -> points c <> [] ->
  claim_holds (dimension_of D) c ->
  exists c', same_input c c' /\ honest_certificate D c' /\ check D c' = Accepted.
Proof.
  intros W NE C.
  assert (exists c', same_input c c' /\ honest_certificate D c') as (c' & Sm & H).
  { destruct D; cbn in *.
    - now apply (honest_exists plane_computes).
    - apply (honest_exists space_computes); auto. }
  exists c'. split; [assumption|]. split; [assumption|]. apply check_complete; [assumption|].
  now apply (same_claim _ c c' Sm).
Qed.
