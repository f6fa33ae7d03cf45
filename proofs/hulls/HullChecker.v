(** * The checker of certificates of convex hulls

    [judge_hull] is extracted; [HullSound.v] proves what its acceptance means.  Every facet of the
    hull makes a cone with the summit, a point inside: the cones are a triangulation, which has a
    certificate as any other.  It is a weighted Delaunay triangulation if the summit is lowered, so
    that points of S that are not vertices need not be vertices of cones. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Judge Hulls.
From Circumspect Require Table.
Import ListNotations.
Open Scope Z_scope.

Section Hull.
Variables (D : plane_or_space) (p : packed) (k : positive) (X : list positive).

(** [summit-inside]: [X] are d + 1 points of S, and the summit is strictly inside their hull.
    Without it the summit could be on the boundary, whose facets there no cone has
    ([facets_reach]), or outside, and the points without it would have another hull
    ([conv_without_summit]). *)
Definition summit_is_inside : bool :=
  let pr := predicates_of D in
  let c := frame p in
  let place := Table.of_list (site_of (claimed c)) (points c) in
  match Table.find k place, find_all place X with
  | Some o, Some Y =>
      Nat.eqb (length Y) (S (dimension pr)) && (0 <? orientation pr Y) &&
      forallb (fun v => negb (Pos.eqb v k)) X &&
      forallb (fun i => 0 <? side pr i Y o 1) (seq 0 (S (dimension pr)))
  | _, _ => false
  end.

(** [cone-shown]: without it a simplex would be no cone, and have no facet of the hull
    ([over_each]). *)
Definition is_cone (e : simplex_entry) : bool := existsb (Pos.eqb k) (corners e).

Definition check_cones : result :=
  require summit_inside by summit_is_inside at AtPoint k;
  each_row D p (fun t e => require cone_shown by is_cone e at AtSimplex t; Accepted).

Definition judge_hull (s : Word.t) : verdict :=
  match judge D p None s with
  | Holds => match check_cones with Accepted => Holds | Rejected why where_ => Fails why where_ end
  | fails => fails
  end.
End Hull.
