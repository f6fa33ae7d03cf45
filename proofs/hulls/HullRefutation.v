(** * The checker of refutations of convex hulls

    [refute_hull] is extracted; [HullRefuted.v] proves what its acceptance means. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Refutation Hulls.
From Circumspect Require Table.
Import ListNotations.
Open Scope Z_scope.

Section Evidence.
Variables (pr : predicates) (m : refutation) (t p q : positive).
Let points_table := Table.of_list id (sites m).

(** The row lists d points, and points p and q are on different sides of them. *)
Definition parted_by (r : row) : bool :=
  has_length (dimension pr) r &&
  match all_named points_table r with
  | Some f => point_at points_table p (fun a => point_at points_table q (fun b =>
      orientation pr (f ++ [a]) * orientation pr (f ++ [b]) <? 0))
  | None => false
  end.
Definition refute_hull_in : bool :=
  (0 <? unit_numerator m) && (0 <? unit_denominator m) && forallb (shaped pr) (sites m) &&
  row_at (Table.of_list id (rows m)) t parted_by.
End Evidence.

Definition refute_hull (D : plane_or_space) (x : hull_refutation) : bool :=
  refute_hull_in (predicates_of D) (hull_mesh x) (hull_facet x) (one_beyond x) (other_beyond x).
