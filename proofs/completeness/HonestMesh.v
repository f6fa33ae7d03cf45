(** * The mesh of an honest certificate

    What an honest certificate says of neighbours is what holds by [Adjacency.v]: shared vertices
    make opposite facets, and neighbours name each other; hull facets support conv S; the sample
    point is in one simplex only and inside all hull facets. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith.
From Circumspect Require Import Checker Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Facets Matched Adjacency.
From Circumspect Require Import Orientation Integers Incidence Honest Permutations ListedMesh.
Import ListNotations.
Open Scope R_scope.

Section HonestMesh.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis Co : computes orient pr.
Hypothesis positive_d : (1 <= d)%nat.
Variable c : certificate.
Hypothesis H : honest orient c.
Let HL : well_listed orient c := honest_listed _ _ H.
Notation P := (points_of_certificate d c).
Notation spot := (spot d c).
Notation simplex_at t s := (numbered (Definitions.simplices c) t = Some s).
Notation tets := (numbers (Definitions.simplices c)).
Variable geo : positive -> frame d.
Hypothesis G : described c geo.
Notation adjacent := (adjacent tets geo).
Notation outer := (outer tets geo).

Lemma wall_le t s i : simplex_at t s -> nth_error (walls s) i <> None -> (i <= d)%nat.
Proof.
  intros E N. apply nth_error_Some in N. rewrite (honest_walls _ _ H t s E) in N. lia.
Qed.

Lemma neighbour_adjacent t s i u j : simplex_at t s ->
  nth_error (walls s) i = Some (Neighbour u j) -> exists s', simplex_at u s' /\
    (i <= d)%nat /\ (j <= d)%nat /\ shared (remove i (corners s)) (remove j (corners s')) /\
    adjacent t i u j.
Proof.
  intros E W. assert (Hi : (i <= d)%nat) by (apply (wall_le t s); [assumption|congruence]).
  destruct (honest_neighbour _ _ H t s i u j E W) as (N & s' & E' & S). exists s'.
  pose proof (shared_index positive_d c geo G t s i u s' j E E' Hi S) as Hj.
  repeat (split; [assumption|]). split; [now apply (in_tets c) with s|].
  split; [now apply (in_tets c) with s'|].
  apply (shared_facet tets geo positive_d (described_agree _ _ G) (described_different _ _ G));
    eauto using in_tets. now apply (shared_facets Co positive_d c HL geo G t s i u s' j).
Qed.
Lemma on_hull_outer t s i h : simplex_at t s -> nth_error (walls s) i = Some (OnHull h) ->
  (i <= d)%nat /\ outer t i.
Proof.
  intros E W. assert (Hi : (i <= d)%nat) by (apply (wall_le t s); [assumption|congruence]).
  split; [assumption|]. intros u j (_ & Hu & O).
  apply in_numbers in Hu. destruct Hu as (s' & E'). pose proof O as (_ & Hj & _ & _ & Neg).
  apply (proj2 (honest_on_hull _ _ H t s i h E W) u s' j E').
  - intros <-. rewrite bary_vertex in Neg by assumption. destruct (Nat.eq_dec i j); lra.
  - apply (shared_facets Co positive_d c HL geo G t s i u s' j); auto. apply opposite_facets in O.
    tauto.
Qed.
Lemma neighbour_back t s i u s' j : simplex_at t s -> simplex_at u s' ->
  nth_error (walls s) i = Some (Neighbour u j) -> nth_error (walls s') j = Some (Neighbour t i).
Proof.
  intros E E' W. destruct (neighbour_adjacent t s i u j E W) as (s2 & E2 & Hi & Hj & _ & A).
  replace s2 with s' in * by congruence. clear s2 E2. apply adjacent_sym in A.
  destruct (nth_error (walls s') j) as [[t' i'|h]|] eqn:W'.
  - destruct (neighbour_adjacent u s' j t' i' E' W') as (s2 & E2 & _ & Hi' & _ & A').
    destruct A as (_ & Ht & O), A' as (_ & Ht' & O').
    assert (t = t') as <-.
    { apply (one_neighbour tets geo positive_d (described_agree _ _ G) (described_different _ _ G)
        t i t' i' u j); auto using opposite_sym. }
    do 2 f_equal. symmetry.
    apply opposite_facets in O, O'. destruct O as (_ & _ & [_ B] & _), O' as (_ & _ & [B' _] & _).
    destruct (Nat.eq_dec i i') as [|N]; [assumption|exfalso].
    apply (not_in_facet_of (geo t) i' Hi'). apply B', B, in_facet_of; [assumption|]. eauto.
  - exfalso. destruct (on_hull_outer u s' j h E' W') as [_ O]. exact (O t i A).
  - apply nth_error_None in W'. rewrite (honest_walls _ _ H u s' E') in W'. lia.
Qed.

(** ** The sample point *)

Notation o := (sample_point (d := d) c).

Lemma sample_covered_once : covered_once tets geo o (sample_simplex c).
Proof.
  destruct (honest_sample _ _ H) as (s & E & I).
  apply (complex_covered_once tets geo (described_agree _ _ G) (described_different _ _ G)).
  - now apply (in_tets c _ s).
  - now apply (strictly_inside_bary c geo G _ s).
Qed.
Lemma sample_inside_facet t i : In t tets -> (i <= d)%nat -> outer t i -> 0 < bary (geo t) i o.
Proof.
  destruct sample_covered_once as (H0 & I & _).
  exact (inside_facet positive_d c geo G (sample_simplex c) o t i H0 I).
Qed.
End HonestMesh.
