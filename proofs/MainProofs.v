(** * Proofs of what [MainTheorems.v] states, where they are longer than a line *)
From Coq Require Import String Rbase Rfunctions List ZArith.
From Circumspect Require Import Checker Settling ComplexChecker DomainRefutation WholeRefutation.
From Circumspect Require Import ImpossibleChecker MeshAlone AloneRefutation GiftWrapping Honest.
From Circumspect Require Import FlatRefutation Definitions Domains DomainRules Complexes Flats.
From Circumspect Require Import Periodic Hulls.
From Circumspect Require Uniqueness Soundness RefutationSound DomainSound Solid ImpossibleSound.
From Circumspect Require Completeness EveryTriangulation Separated MeshAloneSound AloneRefuted.
From Circumspect Require BuiltDelaunay AnyOrder Judged SettlingSound ComplexSound DomainRefuted.
From Circumspect Require WholeSound FlatRefuted.
Import ListNotations.
Open Scope R_scope.

Theorem refuted_not D c : refute D c = true -> spans (refuted_points D c) /\ ~ refuted_claim D c.
Proof.
  intros A. split; [now apply RefutationSound.refute_spans|now apply RefutationSound.refute_sound].
Qed.

Theorem domain_holds D c : check_domain D c = Accepted ->
  let P := domain_of_certificate (dimension_of D) c in
  let T := mesh_of_domain (dimension_of D) c in
  solid T /\ holds_of_complex (domain_claimed c) P T.
Proof.
  intros A. pose proof (DomainSound.check_domain_sound D c A) as H. cbv zeta in *.
  destruct (domain_claimed c);
    [apply Solid.solid_plc in H|apply Solid.solid_steiner in H|apply Solid.solid_conforming in H
    |apply Solid.solid_cdts in H|apply Solid.solid_steiner_cdts in H]; now destruct H.
Qed.

(** ** The names of rules *)

Lemma among s l : existsb (String.eqb s) l = true -> In s l.
Proof.
  intros H. apply existsb_exists in H. destruct H as (t & A & E). apply String.eqb_eq in E.
  now subst.
Qed.
Ltac listed := apply among; reflexivity.

Theorem rules_of_points D c : refute D c = true -> In (rule_name (rule_of (because c)))
  ["simplex.wrong-dimension"; "triangulation.unknown-vertex"; "simplex.repeated-vertex";
   "simplex.degenerate"; "complex.duplicate-simplex"; "complex.facet-overused"; "complex.overlap";
   "triangulation.covered-twice"; "triangulation.unused-point"; "triangulation.hull-not-convex";
   "triangulation.hull-not-closed"; "delaunay.vertex-in-ball"; "delaunay.facet-not-local";
   "weighted.point-below-plane"; "weighted.vertex-submerged"]%string.
Proof. intros _. destruct (because c); listed. Qed.

Theorem rules_of_domains D c : refute_domain D c = true -> In (domain_rule_name (domain_rule_of c))
  ["domain.vertex-missing"; "domain.steiner-forbidden"; "domain.segment-missing";
   "domain.vertex-in-edge"; "delaunay.no-empty-ball"; "simplex.wrong-dimension";
   "triangulation.unknown-vertex"; "simplex.repeated-vertex"; "simplex.degenerate";
   "complex.duplicate-simplex"; "complex.overlap"; "triangulation.covered-twice";
   "delaunay.vertex-in-ball"; "delaunay.facet-not-local"]%string.
Proof.
  intros A. unfold refute_domain, refute_domain_in in A. cbv zeta in A.
  apply andb_prop in A. destruct A as [_ A].
  unfold domain_rule_of. destruct (domain_because c); try solve [listed].
  apply andb_prop in A. destruct A as [A _].
  destruct (because (mesh_refuted c)); try discriminate; listed.
Qed.

Theorem rules_of_whole_domains D x : refute_whole D x = true ->
  In (domain_rule_name (whole_rule_of x))
  ["cdt.facet-not-local"; "cdt.visible-vertex-in-ball"; "cdt.dangling-not-delaunay";
   "domain.polygon-not-tiled"; "domain.uncovered"; "domain.outside";
   "domain.uncovered or domain.outside"; "triangulation.hull-not-convex";
   "triangulation.hull-not-closed"]%string.
Proof.
  intros A. unfold whole_rule_of. unfold refute_whole, refute_whole_in in A. cbv zeta in A.
  destruct (shown_by x) as [| | | | | |e| |]; try solve [listed]. apply andb_prop in A.
  destruct A as [_ A].
  cbn [whole_holds] in A. apply andb_prop in A. destruct A as [A _]. apply andb_prop in A.
  destruct A as [_ A].
  destruct e; try discriminate; listed.
Qed.

Theorem rules_of_flats D x : refute_flat D x = true ->
  In (rule_name (rule_of (because (flat_mesh x))))
  ["simplex.wrong-dimension"; "triangulation.unused-point"; "triangulation.hull-not-convex";
   "delaunay.vertex-in-ball"]%string.
Proof.
  intros A. apply FlatRefuted.refute_flat_rule in A. destruct A as [(k & _ & B) _].
  destruct (because (flat_mesh x)); try contradiction; listed.
Qed.

(** ** What there is not, and what there is once *)

Theorem impossible x : check_impossible x = Accepted ->
  let P := domain_of_certificate 3 (about x) in
  match domain_claimed (about x) with
  | Cdt => forall K, ~ cdt P K
  | _ => forall K, ~ plc_triangulation P K
  end.
Proof.
  intros A. cbv zeta. pose proof (fun K => ImpossibleSound.check_impossible_sound x K A) as H.
  destruct (domain_claimed (about x)); intros K Tr; try (apply (H K Tr); discriminate).
  now apply (H K (proj1 Tr)).
Qed.

Theorem generic_once D c c' : check D c = Accepted -> check D c' = Accepted ->
  claimed c = Delaunay -> claimed c' = Delaunay ->
  points_of_certificate (dimension_of D) c = points_of_certificate (dimension_of D) c' ->
  generic (points_of_certificate (dimension_of D) c) ->
  forall s, faces_of (simplices_of_certificate (dimension_of D) c) s <->
            faces_of (simplices_of_certificate (dimension_of D) c') s.
Proof.
  intros A A' E E' P G. apply Soundness.check_sound in A, A'. rewrite E in A. rewrite E' in A'.
  rewrite <- P in A'. now apply (Uniqueness.theorem_4_4 (points_of_certificate (dimension_of D) c)).
Qed.

(** ** Completeness *)

Theorem complete D c : honest_certificate D c ->
  (check D c = Accepted <-> claim_holds (dimension_of D) c).
Proof.
  intros H. split; [|now apply Completeness.check_complete].
  intros A. apply Soundness.check_sound in A. destruct A as (_ & A). unfold claim_holds. cbv zeta.
  destruct (claimed c); [exact A|exact A|]. destruct A as ((w & W) & A). exists w. auto.
Qed.

(** ** Meshes alone and those that a lattice repeats, and gift-wrapping *)

Theorem mesh_alone_holds D c : check_alone D c = Accepted ->
  let S := points_of_certificate (dimension_of D) (bare_certificate c) in
  let T := simplices_of_certificate (dimension_of D) (bare_certificate c) in
  simplices_form_a_complex S T /\ simplicial_complex (faces_of T).
Proof.
  intros A. cbv zeta. pose proof (MeshAloneSound.check_alone_sound D c A) as H.
  split; [exact H|exact (Separated.a_complex_indeed _ _ H)].
Qed.
Theorem some_unused_hold D c : check_some_unused D c = Accepted ->
  let S := points_of_certificate (dimension_of D) (bare_certificate c) in
  let T := simplices_of_certificate (dimension_of D) (bare_certificate c) in
  simplices_meet_in_faces S T /\ simplicial_complex (faces_of T).
Proof.
  intros A. cbv zeta. pose proof (MeshAloneSound.check_some_unused_sound D c A) as H.
  split; [exact H|exact (Separated.a_complex_indeed _ _ H)].
Qed.
Theorem rules_of_complexes D x : refute_alone D x = true ->
  In (rule_of_complex_name (complex_rule_of x))
  ["triangulation.unknown-vertex"; "simplex.repeated-vertex"; "simplex.degenerate";
   "complex.duplicate-simplex"; "complex.overlap"; "triangulation.unused-point";
   "complex.hanging-vertex"; "complex.faces-cross"; "complex.points-equal"]%string.
Proof.
  intros A. unfold complex_rule_of. unfold refute_alone, refute_alone_in in A. cbv zeta in A.
  destruct (against x); try solve [listed]. destruct (refuted (mesh_alone x)); try discriminate.
  apply andb_prop in A. destruct A as [A _].
  destruct (because (mesh_alone x)); try discriminate; listed.
Qed.
Theorem rules_of_hulls x : In (hull_rule_name (hull_because x))
  ["hull.facet-not-supporting"; "hull.uncovered"]%string.
Proof. destruct (hull_because x); listed. Qed.
Theorem rules_of_periodic x : In (periodic_rule_name (periodic_because x))
  ["simplex.degenerate"; "complex.duplicate-simplex"; "complex.not-closed";
   "triangulation.covered-twice"; "triangulation.unused-point"; "delaunay.vertex-in-ball"]%string.
Proof. destruct (periodic_because x); listed. Qed.
Theorem wrapped D (r : R) (l : list site) L : 0 < r -> wrap D l = Some L ->
  let S : list (point (dimension_of D)) := caller_points r l in
  NoDup S /\ spans S /\ exists T, caller_rows r l (map (map Some) L) = map (map Some) T /\
    delaunay_triangulation S T /\ canonical_triangulation S norm2 T.
Proof. apply BuiltDelaunay.wrap_sound. Qed.
