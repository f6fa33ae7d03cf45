(** * The main theorems: what [circumspect-verified] guarantees

    Every notion is one of [Definitions.v]; of domains, of [Domains.v] and [DomainRules.v]; of a
    mesh alone, of [Complexes.v]; of hulls, of points that do not span, of surfaces and of meshes
    that a lattice repeats, of [Hulls.v], [Flats.v], [Surfaces.v] and [Periodic.v].  [check], [refute], [check_domain] and so on are the
    functions that the program evaluates; how they decide ([checker/Checker.v],
    [refutation/Refutation.v], [domain/DomainChecker.v]) need not be read.  The proofs are
    elsewhere.  The theorems of the book stand in [BookTheorems.v].

    What a line of the program does not say:
    - whose points and simplices these are: they are those in the file, scaled by its P/Q.  Whether
      they are yours is compared by [circumspect-verified FILE MESH.node MESH.ele], which is not
      proved; so is what a domain is, with [DOMAIN.poly] too;
    - which of several Delaunay triangulations it is, unless it adds [unique] or [canonical];
    - that a domain is a piecewise linear complex, unless it adds [plc];
    - that each point in your list is a vertex, if the claim is about a domain: only simplices are
      looked at;
    - anything within a tolerance: nothing is proved of [check --within], which moves points; what
      is verified is of the coordinates in the file, as they are;
    - of a mesh alone, that it is a manifold, connected, closed or oriented;
    - of points that do not span, which of several Delaunay triangulations it is;
    - that a mesh is a CDT where a triangle in space dangles, unless all of the mesh in the
      certificate is Delaunay; that the domain is a piecewise linear complex where anything does;
      nor is a domain in which something dangles said to have no triangulation;
    - that some domain has a CDT: Theorem 4.9 (the CDT Theorem) is stated in [BookTheorems.v], and
      not proved; and of Proposition 4.11, that a CDT induces CDTs of the polygons, only what it
      says at their edges is stated there;
    - that a domain has a triangulation, where no proof is found that it has none: none is for a
      room within another, nor beyond 48 vertices;
    - that the program does what these functions do: this rests on Coq's kernel and extraction,
      on OCaml, GMP and Zarith, and on the reader of files in [ocaml/].
    Every claim and every rule of the program stands in docs/certificates.md beside its theorem, or
    with the reason why it has none; more is in README.md, "What is not covered". *)
From Coq Require Import String Rbase Rfunctions List ZArith.
From Circumspect Require Import Judge Checker Settling ComplexChecker DomainRefutation.
From Circumspect Require Import WholeRefutation ImpossibleChecker MeshAlone AloneRefutation.
From Circumspect Require Import HullChecker FlatChecker LineChecker FlatRefutation.
From Circumspect Require Import HullRefutation SurfaceRefutation PeriodicChecker GiftWrapping.
From Circumspect Require Import Honest Definitions Domains DomainRules Complexes Hulls Flats.
From Circumspect Require Import Surfaces Periodic.
From Circumspect Require MainProofs DanglingSound HullSound FlatSound LineSound FlatRefuted.
From Circumspect Require HullRefuted SurfaceSound SurfaceRefuted PeriodicSound PeriodicRefuted.
Import ListNotations.
Open Scope R_scope.

(** ** Soundness *)

(** An accepted certificate: its points are different, and its simplices are what it claims. *)
Theorem verified D c : check D c = Accepted ->
  let S := points_of_certificate (dimension_of D) c in
  let T := simplices_of_certificate (dimension_of D) c in
  NoDup S /\
  match claimed c with
  | Triangulation => triangulation S T
  | Delaunay => delaunay_triangulation S T
  | WeightedDelaunay => (exists w, weights_given (dimension_of D) c w) /\
      forall w, weights_given (dimension_of D) c w -> weighted_delaunay_triangulation w S T
  end.
Proof. apply Soundness.check_sound. Qed.

(** In the program the simplices of a certificate are rows of words ([checker/Packed.v] says of
    which certificate), and a quick check of them comes first; what it says holds is accepted, and
    settled as the certificate says. *)
Theorem verified_packed D p standing s : judge D p standing s = Holds ->
  check D (unpacked D p) = Accepted /\
  forall st, standing = Some st -> settle D (unpacked D p) st = Settled.
Proof. apply Judged.judge_holds. Qed.

(** For example the triangle of [Definitions.v]. *)
Example worked_triangle_accepted : check Plane worked_triangle = Accepted.
Proof. reflexivity. Qed.
Example worked_triangle_verified :
  let at_half x y := scale (1 / 2) (integer_point 2 [x; y]%Z) in
  delaunay_triangulation [at_half 0 0; at_half 0 1; at_half 2 0]%Z
    [[at_half 0 0; at_half 2 0; at_half 0 1]]%Z.
Proof. apply (verified Plane worked_triangle eq_refl). Qed.

(** An accepted refutation: the points span R^d, and the claim is false of them, ... *)
Theorem verified_not D c : refute D c = true ->
  spans (refuted_points D c) /\ ~ refuted_claim D c.
Proof. apply MainProofs.refuted_not. Qed.

(** ... because it breaks the rule that is printed. *)
Theorem verified_rule D c w : refute D c = true ->
  (refuted c = WeightedDelaunay -> refuted_weights D c w) ->
  broken (refuted c) (lifted (refuted c) w) (refuted_points D c) (refuted_simplices D c)
    (rule_of (because c)).
Proof. apply RefutationSound.refute_breach. Qed.

(** An accepted certificate about a domain: its kept simplices are what it claims of the domain that
    its vertices, segments, polygons and hole points describe, and nothing dangles. *)
Theorem verified_domain D c : check_domain D c = Accepted ->
  let P := domain_of_certificate (dimension_of D) c in
  let T := mesh_of_domain (dimension_of D) c in
  solid T /\ holds_of_complex (domain_claimed c) P T.
Proof. apply MainProofs.domain_holds. Qed.

(** If the certificate says so ([dangling]), something may dangle: the complex also lists the
    vertices of the domain, the steps along its segments, and the pieces of its polygons. *)
Theorem verified_dangling D c : check_dangling D c = Accepted ->
  holds_of_complex (domain_claimed c) (domain_of_certificate (dimension_of D) c)
    (mesh_with_faces (dimension_of D) c).
Proof. apply DanglingSound.check_dangling_sound. Qed.

(** And if the certificate says so ([plc]), this domain is a piecewise linear complex
    (Definition 4.3). *)
Theorem verified_complex D c x : check_domain D c = Accepted -> check_complex D c x = Accepted ->
  piecewise_linear_complex (domain_of_certificate (dimension_of D) c).
Proof. apply ComplexSound.check_complex_sound. Qed.

(** An accepted refutation of a claim about a domain: whatever domain has the vertices and, among
    others, the segments of the refutation, the claim is false of it and the mesh, ... *)
Theorem verified_not_domain D c (P : domain (dimension_of D)) :
  refute_domain D c = true -> described D c P ->
  ~ claims_of_domain (domain_refuted c) P (refuted_simplices D (mesh_refuted c))
      (dangling_simplices D (mesh_refuted c) (dangling_refuted c)).
Proof. apply DomainRefuted.refute_domain_sound. Qed.

(** ... because it breaks the rule that is printed. *)
Theorem verified_domain_rule D c (P : domain (dimension_of D)) :
  refute_domain D c = true -> described D c P ->
  broken_of_domain P (refuted_simplices D (mesh_refuted c))
    (dangling_simplices D (mesh_refuted c) (dangling_refuted c))
    (domain_rule_of c).
Proof. apply DomainRefuted.refute_domain_rule. Qed.

(** The same of refutations that speak of the whole domain: it is that of the refutation. *)
Theorem verified_not_whole_domain D x : refute_whole D x = true ->
  ~ claims_of_domain (domain_claimed (about_domain x))
      (domain_of_certificate (dimension_of D) (about_domain x))
      (refuted_simplices D (mesh_against x))
      (dangling_simplices D (mesh_against x) (dangling_against x)).
Proof. apply WholeSound.refute_whole_sound. Qed.
Theorem verified_whole_domain_rule D x : refute_whole D x = true ->
  broken_of_domain (domain_of_certificate (dimension_of D) (about_domain x))
    (refuted_simplices D (mesh_against x))
    (dangling_simplices D (mesh_against x) (dangling_against x)) (whole_rule_of x).
Proof. apply WholeSound.refute_whole_rule. Qed.

(** Which rules these can be, by the names that are printed. *)
Theorem rules_of_points D c : refute D c = true -> In (rule_name (rule_of (because c)))
  ["simplex.wrong-dimension"; "triangulation.unknown-vertex"; "simplex.repeated-vertex";
   "simplex.degenerate"; "complex.duplicate-simplex"; "complex.facet-overused"; "complex.overlap";
   "triangulation.covered-twice"; "triangulation.unused-point"; "triangulation.hull-not-convex";
   "triangulation.hull-not-closed"; "delaunay.vertex-in-ball"; "delaunay.facet-not-local";
   "weighted.point-below-plane"; "weighted.vertex-submerged"]%string.
Proof. apply MainProofs.rules_of_points. Qed.
Theorem rules_of_domains D c : refute_domain D c = true -> In (domain_rule_name (domain_rule_of c))
  ["domain.vertex-missing"; "domain.steiner-forbidden"; "domain.segment-missing";
   "domain.vertex-in-edge"; "delaunay.no-empty-ball"; "simplex.wrong-dimension";
   "triangulation.unknown-vertex"; "simplex.repeated-vertex"; "simplex.degenerate";
   "complex.duplicate-simplex"; "complex.overlap"; "triangulation.covered-twice";
   "delaunay.vertex-in-ball"; "delaunay.facet-not-local"]%string.
Proof. apply MainProofs.rules_of_domains. Qed.
Theorem rules_of_whole_domains D x : refute_whole D x = true ->
  In (domain_rule_name (whole_rule_of x))
  ["cdt.facet-not-local"; "cdt.visible-vertex-in-ball"; "cdt.dangling-not-delaunay";
   "domain.polygon-not-tiled"; "domain.uncovered"; "domain.outside";
   "domain.uncovered or domain.outside"; "triangulation.hull-not-convex";
   "triangulation.hull-not-closed"]%string.
Proof. apply MainProofs.rules_of_whole_domains. Qed.

(** What is accepted as a proof that a domain in space has no triangulation (Definition 4.4), or no
    CDT (Definition 4.7): it has none, whatever dangles. *)
Theorem verified_impossible x : check_impossible x = Accepted ->
  let P := domain_of_certificate 3 (about x) in
  match domain_claimed (about x) with
  | Cdt => forall K, ~ cdt P K
  | _ => forall K, ~ plc_triangulation P K
  end.
Proof. apply MainProofs.impossible. Qed.

(** What is printed beside the claim if the certificate says so: [unique] and [canonical]. The order
    of the points is that of the certificate, which is lexicographic ([points-increasing]). *)
Theorem verified_unique D c U : check D c = Accepted -> settle D c Unique = Settled ->
  let S := points_of_certificate (dimension_of D) c in
  match claimed c with
  | Triangulation => False
  | Delaunay => delaunay_triangulation S U
  | WeightedDelaunay => exists w, weights_given (dimension_of D) c w /\
      weighted_delaunay_triangulation w S U
  end -> same_simplices (simplices_of_certificate (dimension_of D) c) U.
Proof. exact (fun A Se H => SettlingSound.settled_unique D c A U Se H). Qed.

Theorem verified_canonical D c s w : check D c = Accepted -> settle D c s = Settled ->
  (claimed c = WeightedDelaunay -> weights_given (dimension_of D) c w) ->
  canonical_triangulation (points_of_certificate (dimension_of D) c) (lifted (claimed c) w)
    (simplices_of_certificate (dimension_of D) c).
Proof. exact (fun A Se W => SettlingSound.settled_canonical D c A s w Se W). Qed.

(** Two accepted certificates of one generic point set are about the same simplices. (That the
    points are generic is not in a certificate. If they are not, several triangulations may be
    Delaunay, and each has its certificate.) *)
Theorem verified_generic D c c' : check D c = Accepted -> check D c' = Accepted ->
  claimed c = Delaunay -> claimed c' = Delaunay ->
  points_of_certificate (dimension_of D) c = points_of_certificate (dimension_of D) c' ->
  generic (points_of_certificate (dimension_of D) c) ->
  forall s, faces_of (simplices_of_certificate (dimension_of D) c) s <->
            faces_of (simplices_of_certificate (dimension_of D) c') s.
Proof. apply MainProofs.generic_once. Qed.

(** The points of a certificate are in order, so the canonical triangulation is one of a set of
    points, in whatever order they were listed. *)
Theorem verified_any_order D c c' s s' : check D c = Accepted -> check D c' = Accepted ->
  settle D c s = Settled -> settle D c' s' = Settled ->
  claimed c = Delaunay -> claimed c' = Delaunay ->
  (forall p, In p (points_of_certificate (dimension_of D) c) <->
             In p (points_of_certificate (dimension_of D) c')) ->
  same_simplices (simplices_of_certificate (dimension_of D) c)
    (simplices_of_certificate (dimension_of D) c').
Proof. apply AnyOrder.canonical_any_order. Qed.

(** ** A mesh alone *)

(** An accepted certificate of the claim [complex]: the simplices, of whatever dimension, form a
    complex in the sense of [Complexes.v]; and so they and their faces are a simplicial complex
    (Definition 1.5). *)
Theorem verified_mesh_alone D c : check_alone D c = Accepted ->
  let S := points_of_certificate (dimension_of D) (bare_certificate c) in
  let T := simplices_of_certificate (dimension_of D) (bare_certificate c) in
  simplices_form_a_complex S T /\ simplicial_complex (faces_of T).
Proof. apply MainProofs.mesh_alone_holds. Qed.
(** The same where the certificate lets points be no vertices ([unused]), as [--allow-unused]
    does. *)
Theorem verified_some_unused D c : check_some_unused D c = Accepted ->
  let S := points_of_certificate (dimension_of D) (bare_certificate c) in
  let T := simplices_of_certificate (dimension_of D) (bare_certificate c) in
  simplices_meet_in_faces S T /\ simplicial_complex (faces_of T).
Proof. apply MainProofs.some_unused_hold. Qed.

(** An accepted refutation: they do not, because they break the rule that is printed. *)
Theorem verified_not_complex D x : refute_alone D x = true ->
  broken_of_complex (refuted_points D (mesh_alone x)) (refuted_simplices D (mesh_alone x))
    (complex_rule_of x) /\
  ~ claims_complex (refuted_points D (mesh_alone x)) (refuted_simplices D (mesh_alone x)).
Proof. apply AloneRefuted.refute_alone_rule. Qed.
Theorem rules_of_complexes D x : refute_alone D x = true ->
  In (rule_of_complex_name (complex_rule_of x))
  ["triangulation.unknown-vertex"; "simplex.repeated-vertex"; "simplex.degenerate";
   "complex.duplicate-simplex"; "complex.overlap"; "triangulation.unused-point";
   "complex.hanging-vertex"; "complex.faces-cross"; "complex.points-equal"]%string.
Proof. apply MainProofs.rules_of_complexes. Qed.

(** ** Convex hulls, points that do not span, and surfaces *)

(** An accepted certificate of the claim [convex-hull]: the points but the summit, number [k], span
    the plane or space, and the simplices without the summit are the boundary of their hull. *)
Theorem verified_hull D p k X s : judge_hull D p k X s = Holds ->
  let c := unpacked D p in
  let S := points_below (dimension_of D) c k in
  NoDup S /\ spans S /\ boundary_of_hull S (facets_below (dimension_of D) c k).
Proof. apply HullSound.judge_hull_sound. Qed.
(** An accepted refutation of it: they are not, because the rule that is printed is broken. *)
Theorem verified_not_hull D x : refute_hull D x = true ->
  let S := refuted_points D (hull_mesh x) in let L := refuted_simplices D (hull_mesh x) in
  broken_of_hull (hull_because x) S L /\ ~ claims_hull S L.
Proof. apply HullRefuted.refute_hull_rule. Qed.
Theorem rules_of_hulls x : In (hull_rule_name (hull_because x))
  ["hull.facet-not-supporting"; "hull.uncovered"]%string.
Proof. apply MainProofs.rules_of_hulls. Qed.

(** An accepted certificate of points in space that lie in one plane: the triangles are a
    triangulation of these points, Delaunay if the certificate claims it. *)
Theorem verified_flat p x s : judge_flat p x s = Holds ->
  let c := unpacked Plane p in
  let S := flat_points c x in let T := flat_simplices c x in
  NoDup S /\
  lie_in_hyperplane 2 (integer_point 3 (flat_normal x)) (unit_of c * IZR (flat_offset x)) S /\
  match claimed c with
  | WeightedDelaunay => flat_delaunay_triangulation 2 S T
  | _ => flat_triangulation 2 S T
  end.
Proof. apply FlatSound.judge_flat_sound. Qed.

(** An accepted certificate of points on a line, or of one point: the simplices are a Delaunay
    triangulation of them.  (On a line there is one triangulation.) *)
Theorem verified_line D c : check_line D c = Accepted ->
  let S := line_points (dimension_of D) c in
  NoDup S /\ exists k, (k <= 1)%nat /\ of_dimension k S /\
    flat_delaunay_triangulation k S (line_simplices (dimension_of D) c).
Proof. apply LineSound.check_line_sound. Qed.

(** An accepted refutation of points that do not span: they have a dimension, and the claim is false
    of them, because the rule that is printed is broken. *)
Theorem verified_not_flat D x : refute_flat D x = true ->
  let S := refuted_points D (flat_mesh x) in let L := refuted_simplices D (flat_mesh x) in
  (exists k, of_dimension k S /\ broken_of_flat k S L (rule_of (because (flat_mesh x)))) /\
  ~ claims_flat (refuted (flat_mesh x)) S L.
Proof. apply FlatRefuted.refute_flat_rule. Qed.
Theorem rules_of_flats D x : refute_flat D x = true ->
  In (rule_name (rule_of (because (flat_mesh x))))
  ["simplex.wrong-dimension"; "triangulation.unused-point"; "triangulation.hull-not-convex";
   "delaunay.vertex-in-ball"]%string.
Proof. apply MainProofs.rules_of_flats. Qed.

(** An accepted certificate of the claim [surface-delaunay]: at each edge of two triangles, the
    angles opposite have a sum of at most pi. *)
Theorem verified_surface D c : check_surface D c = Accepted ->
  let S := points_of_certificate (dimension_of D) (bare_surface c) in
  NoDup S /\
  intrinsically_delaunay S (simplices_of_certificate (dimension_of D) (bare_surface c)).
Proof. apply SurfaceSound.check_surface_sound. Qed.
(** An accepted refutation of it: at an edge of two triangles the sum is more than pi, which is the
    rule that is printed, ["surface.edge-not-delaunay"]. *)
Theorem verified_not_surface D x : refute_surface D x = true ->
  edge_not_delaunay (refuted_simplices D (surface_mesh x)) /\
  ~ claims_surface (refuted_points D (surface_mesh x)) (refuted_simplices D (surface_mesh x)).
Proof. apply SurfaceRefuted.refute_surface_rule. Qed.

(** ** Meshes that a lattice repeats *)

(** An accepted certificate of the claim [periodic-delaunay]: moved by all of the lattice, the cells
    are a Delaunay triangulation of the points. *)
Theorem verified_periodic D c : check_periodic D c = Accepted ->
  let d := dimension_of D in let m := periodic_mesh_of c in
  periodic_delaunay (lattice_of d m) (periodic_points d m) (periodic_cells d m).
Proof. apply PeriodicSound.check_periodic_sound. Qed.
(** An accepted refutation of it: they are not, because the rule that is printed is broken. *)
Theorem verified_not_periodic D x : refute_periodic D x = true ->
  let d := dimension_of D in let m := periodic_against x in
  broken_in_periodic (periodic_because x) (lattice_of d m) (periodic_points d m)
    (periodic_cells d m) /\
  ~ periodic_delaunay (lattice_of d m) (periodic_points d m) (periodic_cells d m).
Proof. apply PeriodicRefuted.refute_periodic_rule. Qed.
Theorem rules_of_periodic x : In (periodic_rule_name (periodic_because x))
  ["simplex.degenerate"; "complex.duplicate-simplex"; "complex.not-closed";
   "triangulation.covered-twice"; "triangulation.unused-point"; "delaunay.vertex-in-ball"]%string.
Proof. apply MainProofs.rules_of_periodic. Qed.

(** ** A construction *)

(** What [circumspect-verified build delaunay] prints is made by gift-wrapping (Section 5.6): of the
    points [l], in whatever unit r, it is a Delaunay triangulation, and the canonical one. *)
Theorem built_delaunay D (r : R) (l : list site) L : 0 < r -> wrap D l = Some L ->
  let S : list (point (dimension_of D)) := caller_points r l in
  NoDup S /\ spans S /\ exists T, caller_rows r l (map (map Some) L) = map (map Some) T /\
    delaunay_triangulation S T /\ canonical_triangulation S norm2 T.
Proof. apply MainProofs.wrapped. Qed.
(** And it is made of every set of points that spans the plane or space. *)
Theorem built_always D (r : R) (l : list site) : 0 < r ->
  let S : list (point (dimension_of D)) := caller_points r l in
  Forall (fun s => length (coordinates s) = dimension_of D) l -> NoDup S -> spans S ->
  exists L, wrap D l = Some L.
Proof. apply BuiltDelaunay.wrap_complete. Qed.

(** ** Completeness: no correct mesh is rejected

    What an honest certificate is, is said in [completeness/Honest.v]. *)

(** An honest certificate, whose pointers point at what they should
    and whose sample point is inside its simplex, is accepted if and only if its claim is true: no
    test of a sign fails on a true claim. *)
Theorem verified_complete D c : honest_certificate D c ->
  (check D c = Accepted <-> claim_holds (dimension_of D) c).
Proof. apply MainProofs.complete. Qed.

(** And there is such a certificate. If the points of [c], at least one, are in order and its
    simplices list them with an orientation that is not negative, and what [c] claims of them is
    true, then some certificate of the same claim, points and simplices is honest, hence accepted.
    (That the program that writes certificates finds it is not proved.) *)
Theorem certificate_exists D c : well_listed_certificate D c -> points c <> [] ->
  claim_holds (dimension_of D) c ->
  exists c', same_input c c' /\ honest_certificate D c' /\ check D c' = Accepted.
Proof. apply EveryTriangulation.certificate_exists. Qed.
