(** * The checker of refutations of convex hulls

    [refute_hull] is extracted; [HullRefuted.v] proves what its acceptance means. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Refutation Hulls.
From Circumspect Require Table.
Import ListNotations.
Open Scope Z_scope.

Section Evidence.
Variables (pr : predicates) (m : refutation).
Let points_table := Table.of_list id (sites m).

(** The row lists d points, and points p and q are on different sides of them. *)
Definition parted_by (p q : positive) (r : row) : bool :=
  has_length (dimension pr) r &&
  match all_named points_table r with
  | Some f => point_at points_table p (fun a => point_at points_table q (fun b =>
      orientation pr (f ++ [a]) * orientation pr (f ++ [b]) <? 0))
  | None => false
  end.

(** The point q / w is not in the hull of d points: with one of [X] they make a simplex, and it is
    beyond a facet of it, or off theirs. *)
Definition off_points (X : list site) (q : site) (w : Z) (f : list site) : bool :=
  existsb (fun x => let Y := f ++ [x] in proper pr Y &&
    (existsb (fun i => coordinate_sign pr Y q w i <? 0) (corners_numbered pr) ||
      (0 <? coordinate_sign pr Y q w (dimension pr)))) X.
Definition off_row (X : list site) (q : site) (w : Z) (r : row) : bool :=
  has_length (dimension pr) r &&
  match all_named points_table r with Some f => off_points X q w f | None => false end.
(** It is in a facet of the simplex [X] that has all points on one side, and in no row. *)
Definition in_no_facet (X : list site) (q : site) (w : Z) : bool :=
  right_length pr X && proper pr X && point_written pr q w && in_simplex pr X q w &&
  (coordinate_sign pr X q w (dimension pr) =? 0) &&
  forallb (fun s => 0 <=? coordinate_sign pr X s 1 (dimension pr)) (sites m) &&
  forallb (off_row X q w) (rows m).

Definition shown_of_hull (e : hull_evidence) : bool :=
  match e with
  | OnBothSides t p q => row_at (Table.of_list id (rows m)) t (parted_by p q)
  | InNoFacet X q w =>
      match all_named points_table (map Some X) with Some Y => in_no_facet Y q w | None => false end
  end.
Definition refute_hull_in (e : hull_evidence) : bool :=
  (0 <? unit_numerator m) && (0 <? unit_denominator m) && forallb (shaped pr) (sites m) &&
  shown_of_hull e.
End Evidence.

Definition refute_hull (D : plane_or_space) (x : hull_refutation) : bool :=
  refute_hull_in (predicates_of D) (hull_mesh x) (hull_because x).
