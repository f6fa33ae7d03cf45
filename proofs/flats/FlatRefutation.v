(** * The checker of refutations of points that do not span

    [refute_flat] is extracted; [FlatRefuted.v] proves what its acceptance means.  Some of the
    points and the pads make a d-simplex, and the pads have no part in any point: so the points have
    the dimension that they are said to have. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export DomainRefutation Flats.
From Circumspect Require Table.
Import ListNotations.
Open Scope Z_scope.

Section Flat.
Variables (pr : predicates) (x : flat_refutation).
Let m := flat_mesh x.
Let points_table := Table.of_list id (sites m).
Let rows_table := Table.of_list id (rows m).

Definition in_flat (X : list site) (n : nat) (p : site) : bool :=
  forallb (fun i => coordinate_sign pr X p 1 i =? 0)
    (seq n (Datatypes.S (dimension pr) - n)).

(** The row lists [n] points, which with the pads make a d-simplex, and point p is in every ball. *)
Definition in_every_ball (n : nat) (p : site) (r : row) : bool :=
  has_length n r &&
  match all_named points_table r with
  | Some X => proper pr (X ++ flat_pads x) &&
      no_ball pr (combine (ball_own x) X) [(ball_other x, p)]
  | None => false
  end.
(** The row lists two points, and no other lists the one that is not entry i; there the simplex
    ends, and point p is beyond. *)
Definition no_other_row (X f : list site) (r : row) : bool :=
  negb (forallb (fun p => lists points_table p r) f) ||
  match all_named points_table r with Some Y => same_places X Y | None => false end.
Definition ends_before (i : nat) (p : site) (r : row) : bool :=
  has_length 2 r &&
  match all_named points_table r with
  | Some X => let Y := X ++ flat_pads x in
      proper pr Y && Nat.ltb i 2 && (coordinate_sign pr Y p 1 i <? 0) &&
      forallb (no_other_row X (remove i X)) (rows m)
  | None => false
  end.
Definition shown_of_flat (n : nat) : bool :=
  match because m, refuted m with
  | HullNotConvex t i p, _ => Nat.eqb n 2 && point_at points_table p (fun q =>
      row_at rows_table t (ends_before i q))
  | WrongDimension t, _ => row_at rows_table t (fun r => negb (has_length n r))
  | UnusedPoint p, _ => point_at points_table p (fun q =>
      negb (existsb (lists points_table q) (rows m)))
  | VertexInBall t p, Delaunay => point_at points_table p (fun q =>
      row_at rows_table t (in_every_ball n q))
  | _, _ => false
  end.

Definition refute_flat_in : bool :=
  match refuted m with WeightedDelaunay => false | _ => true end &&
  (0 <? unit_numerator m) && (0 <? unit_denominator m) &&
  forallb (shaped pr) (sites m) && forallb (shaped pr) (flat_pads x) &&
  match all_named points_table (map Some (basis m)) with
  | Some B => let n := length B in let X := B ++ flat_pads x in
      negb (Nat.eqb n 0) && right_length pr X && proper pr X &&
      forallb (in_flat X n) (sites m) && shown_of_flat n
  | None => false
  end.
End Flat.

Definition refute_flat (D : plane_or_space) (x : flat_refutation) : bool :=
  refute_flat_in (predicates_of D) x.
