(** * Each rule of refutations, once kept and once broken

    The first example of each rule is a refutation that [refute] accepts; the others it must not
    accept, since they would refute what is true or say what is false. *)
From Coq Require Import ZArith List.
From Circumspect Require Import Refutation.
Import ListNotations.
Open Scope Z_scope.

Definition at2 (x y : Z) : site := Site [x; y] 0.
Definition at3 (x y z : Z) : site := Site [x; y; z] 0.
Definition lists_of (l : list (list positive)) : list row := map (map Some) l.
Definition plane_mesh c points simplices e : bool :=
  refute Plane (Refutation c 1 2 points (lists_of simplices) [1; 2; 3]%positive e).
Definition space_mesh c points simplices e : bool :=
  refute Space (Refutation c 1 2 points (lists_of simplices) [1; 2; 3; 4]%positive e).

(** A square, with point 5 where point 1 is. *)
Definition square := [at2 0 0; at2 2 0; at2 2 2; at2 0 2; at2 0 0].
Definition halves : list (list positive) := [[1; 2; 3]; [1; 3; 4]]%positive.
Notation refutes c e := (plane_mesh c square halves e = true).
Notation refutes_not c e := (plane_mesh c square halves e = false).

Example size : plane_mesh Delaunay square [[1; 2]]%positive (WrongDimension 1) = true.
Proof. reflexivity. Qed.
Example size_right : refutes_not Delaunay (WrongDimension 1).
Proof. reflexivity. Qed.
Example no_such_simplex : refutes_not Delaunay (WrongDimension 3).
Proof. reflexivity. Qed.

Example unknown : plane_mesh Delaunay square [[1; 2; 6]]%positive (UnknownVertex 1 2) = true.
Proof. reflexivity. Qed.
Example unknown_negative :
  refute Plane (Refutation Delaunay 1 2 square [[Some 1%positive; None]] [1; 2; 3]%positive
    (UnknownVertex 1 1)) = true.
Proof. reflexivity. Qed.
Example known : refutes_not Delaunay (UnknownVertex 1 2).
Proof. reflexivity. Qed.
Example no_such_entry : refutes_not Delaunay (UnknownVertex 1 3).
Proof. reflexivity. Qed.

Example repeated : plane_mesh Delaunay square [[1; 2; 1]]%positive (RepeatedVertex 1 0 2) = true.
Proof. reflexivity. Qed.
Example repeats_itself : refutes_not Delaunay (RepeatedVertex 1 0 0).
Proof. reflexivity. Qed.

Example flat : plane_mesh Delaunay square [[1; 2; 5]]%positive (Degenerate 1) = true.
Proof. reflexivity. Qed.
Example not_flat : refutes_not Delaunay (Degenerate 1).
Proof. reflexivity. Qed.

(** The same simplex, in another order and by another number. *)
Example duplicate :
  plane_mesh Delaunay square [[1; 2; 3]; [3; 5; 2]]%positive (DuplicateSimplex 1 2) = true.
Proof. reflexivity. Qed.
Example duplicate_itself : refutes_not Delaunay (DuplicateSimplex 1 1).
Proof. reflexivity. Qed.
Example not_duplicate : refutes_not Delaunay (DuplicateSimplex 1 2).
Proof. reflexivity. Qed.

Definition book := [at2 0 0; at2 2 0; at2 1 2; at2 1 (-2); at2 1 4; at2 1 2].
Definition pages : list (list positive) := [[1; 2; 3]; [2; 1; 4]; [5; 1; 2]; [6; 2; 1]]%positive.
Example overuse : plane_mesh Triangulation book pages (FacetOverused 1 2 2 2 3 0) = true.
Proof. reflexivity. Qed.
Example used_twice : plane_mesh Triangulation book pages (FacetOverused 1 2 2 2 1 2) = false.
Proof. reflexivity. Qed.
(** Simplices 1 and 4 are the same. *)
Example used_twice_again : plane_mesh Triangulation book pages (FacetOverused 1 2 2 2 4 0) = false.
Proof. reflexivity. Qed.
Example other_facet : plane_mesh Triangulation book pages (FacetOverused 1 1 2 2 3 0) = false.
Proof. reflexivity. Qed.

(** The point (1, 1/2); the point (1, 0) is in the facet that the two share. *)
Example overlaps : plane_mesh Triangulation book pages (Overlap 1 3 (at2 2 1) 2) = true.
Proof. reflexivity. Qed.
Example upside_down :
  plane_mesh Triangulation book pages (Overlap 1 3 (at2 (-2) (-1)) (-2)) = false.
Proof. reflexivity. Qed.
Example meets : plane_mesh Triangulation book pages (Overlap 1 3 (at2 1 0) 1) = false.
Proof. reflexivity. Qed.
Example not_in_both : plane_mesh Triangulation book pages (Overlap 1 2 (at2 2 1) 2) = false.
Proof. reflexivity. Qed.
(** A vertex in the middle of an edge of the other triangle. *)
Example hangs : plane_mesh Triangulation [at2 0 0; at2 4 0; at2 2 2; at2 2 0; at2 2 (-2)]
  [[1; 2; 3]; [1; 5; 4]]%positive (Overlap 1 2 (at2 2 0) 1) = true.
Proof. reflexivity. Qed.

Example unused : plane_mesh Delaunay square [[1; 2; 3]]%positive (UnusedPoint 4) = true.
Proof. reflexivity. Qed.
Example used_under_another_number : refutes_not Delaunay (UnusedPoint 5).
Proof. reflexivity. Qed.
Example submerged_perhaps :
  plane_mesh WeightedDelaunay square [[1; 2; 3]]%positive (UnusedPoint 4) = false.
Proof. reflexivity. Qed.

(** A point of the interior of one in the other; not of the interior; the same simplex twice. *)
Example covers_twice : map (fun e => plane_mesh Triangulation book pages e)
  [CoveredTwice 1 3 (at2 2 1) 2; CoveredTwice 1 3 (at2 1 0) 1; CoveredTwice 1 4 (at2 2 1) 2;
   CoveredTwice 1 2 (at2 2 1) 2] = [true; false; false; false].
Proof. reflexivity. Qed.
(** A vertex in the middle of an edge: nothing is covered twice. *)
Definition junction := [at2 0 0; at2 4 0; at2 2 2; at2 2 (-2); at2 2 0].
Definition hanging : list (list positive) := [[1; 2; 3]; [1; 5; 4]; [5; 2; 4]]%positive.
Example not_twice : map (fun q => plane_mesh Triangulation junction hanging (CoveredTwice 1 2 q 1))
  [at2 1 0; at2 0 0; at2 2 0] = [false; false; false].
Proof. reflexivity. Qed.

(** Point 4 is beyond the diagonal; the other points are not, and the other edges have none. *)
Definition below_diagonal : list (list positive) := [[1; 2; 3]]%positive.
Example not_convex : map (fun e => plane_mesh Delaunay square below_diagonal e)
  [HullNotConvex 1 1 4; HullNotConvex 1 1 2; HullNotConvex 1 1 3; HullNotConvex 1 0 4;
   HullNotConvex 1 3 4] = [true; false; false; false; false].
Proof. reflexivity. Qed.
(** The edge is shared, by another number of one of its points. *)
Example convex : map (fun T => plane_mesh Delaunay square T (HullNotConvex 1 1 4))
  [halves; [[1; 2; 3]; [5; 3; 4]]; [[1; 2; 3]; [1; 3]]; [[1; 2; 3]; [2; 3; 5]]]%positive
  = [false; false; false; true].
Proof. reflexivity. Qed.
(** Point 1 is in four edges of the boundary; in a square only in two, which cannot be counted
    twice. *)
Example not_closed : map (fun e => plane_mesh Delaunay junction hanging e)
  [HullNotClosed 1 1 1 2 2 1; HullNotClosed 1 1 1 2 1 1; HullNotClosed 1 0 1 2 2 1]
  = [true; false; false].
Proof. reflexivity. Qed.
Example closed : map (fun e => plane_mesh Delaunay square halves e)
  [HullNotClosed 1 2 2 1 1 1; HullNotClosed 1 2 2 1 1 2; HullNotClosed 1 2 2 1 2 0]
  = [false; false; false].
Proof. reflexivity. Qed.
(** With weights a point must be covered: point 4 is beyond facet 1. *)
Example not_covered : map (fun f => plane_mesh WeightedDelaunay square below_diagonal
  (UncoveredPoint 4 f)) [[1%nat]; [0%nat]; []; [3%nat]; [1; 1]%nat]
  = [true; false; false; false; false].
Proof. reflexivity. Qed.
Example covered_on_the_edge : plane_mesh WeightedDelaunay square below_diagonal
  (UncoveredPoint 5 [1%nat]) = false.
Proof. reflexivity. Qed.

(** The shorter diagonal is the Delaunay one; the triangles are turned either way. *)
Definition kite := [at2 0 0; at2 2 (-1); at2 4 0; at2 2 1].
Definition long_diagonal : list (list positive) := [[1; 2; 3]; [1; 3; 4]]%positive.
Definition mirrored : list (list positive) := [[2; 1; 3]; [1; 4; 3]]%positive.
Example in_ball : map (fun T => plane_mesh Delaunay kite T (VertexInBall 1 4))
  [long_diagonal; mirrored] = [true; true].
Proof. reflexivity. Qed.
Example on_ball : map (fun p => plane_mesh Delaunay square halves (VertexInBall 1 p))
  [1; 4; 5]%positive = [false; false; false].
Proof. reflexivity. Qed.
Example only_delaunay : map (fun c => plane_mesh c kite long_diagonal (VertexInBall 1 4))
  [Triangulation; WeightedDelaunay] = [false; false].
Proof. reflexivity. Qed.

Example not_local : plane_mesh Delaunay kite long_diagonal (FacetNotLocal 1 1 2 2) = true.
Proof. reflexivity. Qed.
(** The apex is in the ball, but on the same side. *)
Example same_side : plane_mesh Delaunay [at2 0 0; at2 4 0; at2 2 4; at2 2 1]
  [[1; 2; 3]; [1; 2; 4]]%positive (FacetNotLocal 1 2 2 2) = false.
Proof. reflexivity. Qed.
Example not_shared : plane_mesh Delaunay kite long_diagonal (FacetNotLocal 1 0 2 2) = false.
Proof. reflexivity. Qed.

(** Weights: with them the long diagonal is right, and point 4 of the last triangle submerged. *)
Definition heavy := [Site [0; 0] 9; Site [2; -1] 0; Site [4; 0] 9; Site [2; 1] 0].
Example heavy_diagonal : map (fun e => plane_mesh WeightedDelaunay heavy long_diagonal e)
  [PointBelowPlane 1 4; FacetNotLocal 1 1 2 2] = [false; false].
Proof. reflexivity. Qed.
Example below : map (fun e => plane_mesh WeightedDelaunay kite long_diagonal e)
  [PointBelowPlane 1 4; FacetNotLocal 1 1 2 2] = [true; true].
Proof. reflexivity. Qed.
(** The claim has no weights, so these are not read. *)
Example weights_unread : plane_mesh Delaunay heavy long_diagonal (VertexInBall 1 4) = true.
Proof. reflexivity. Qed.

Definition sunken (w : Z) := [at2 0 0; at2 4 0; at2 0 4; Site [1; 1] w].
Definition fan : list (list positive) := [[1; 2; 4]; [2; 3; 4]; [3; 1; 4]]%positive.
Example vertex_above : map (fun w => plane_mesh WeightedDelaunay (sunken w) fan
  (VertexSubmerged 1 2 [2; 1; 3]%positive)) [-7; -6; 0] = [true; false; false].
Proof. reflexivity. Qed.

(** In space. *)
Definition corner := [at3 0 0 0; at3 2 0 0; at3 0 2 0; at3 0 0 2; at3 1 1 1; at3 2 2 2].
Example space_ball : map (fun p => space_mesh Delaunay corner [[1; 2; 3; 4]]%positive
  (VertexInBall 1 p)) [5; 6]%positive = [true; false].
Proof. reflexivity. Qed.
Example space_overlap : map (fun q =>
  space_mesh Delaunay corner [[2; 1; 3; 4]; [1; 2; 3; 5]]%positive (Overlap 1 2 q 4))
  [at3 2 2 1; at3 1 1 0; at3 1 1 4] = [true; false; false].
Proof. reflexivity. Qed.
Example space_boundary : map (fun i => space_mesh Delaunay corner [[2; 1; 3; 4]]%positive
  (HullNotConvex 1 i 6)) [0; 1; 2; 3]%nat = [false; true; false; false].
Proof. reflexivity. Qed.
(** Two tetrahedra that share an edge only: four facets of the boundary share it. *)
Example space_ridge : map (fun e => space_mesh Delaunay
  [at3 0 0 0; at3 0 0 1; at3 1 0 0; at3 0 1 0; at3 (-1) 0 0; at3 0 (-1) 0]
  [[1; 2; 3; 4]; [1; 2; 5; 6]]%positive e)
  [HullNotClosed 1 2 1 3 2 2; HullNotClosed 1 2 1 3 2 0] = [true; false].
Proof. reflexivity. Qed.
Example scale_not_positive : refute Plane (Refutation Delaunay 1 (-2) kite
  (lists_of long_diagonal) [1; 2; 3]%positive (VertexInBall 1 4)) = false.
Proof. reflexivity. Qed.
(** Three points on a line have a Delaunay triangulation: its two edges.  So nothing is refuted. *)
Example no_basis : map (fun b => refute Plane (Refutation Delaunay 1 1
  [at2 0 0; at2 1 0; at2 2 0] (lists_of [[1; 2]; [2; 3]]%positive) b (WrongDimension 1)))
  [[1; 2; 3]; [1; 2]; []; [1; 2; 4]]%positive = [false; false; false; false].
Proof. reflexivity. Qed.
