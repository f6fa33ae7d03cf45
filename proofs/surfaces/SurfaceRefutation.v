(** * The checker of refutations of surfaces

    [refute_surface] is extracted; [SurfaceRefuted.v] proves what its acceptance means.  The
    evidence names an edge by two triangles; a look at each row tells that no third one has it. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Refutation SurfaceChecker.
From Circumspect Require Table.
Import ListNotations.
Open Scope Z_scope.

Section Evidence.
Variables (pr : predicates) (m : refutation).
Let points_table := Table.of_list id (sites m).
Let rows_table := Table.of_list id (rows m).

(** The row lists three points that are on no line: the one with number [i], and the others. *)
Definition side_at (ti : positive * nat) (f : site -> site -> site -> bool) : bool :=
  row_at rows_table (fst ti) (fun r => has_length 3 r &&
    match all_named points_table r with
    | Some X => on_no_line X &&
        match split3 (snd ti) X with Some (o, p, q) => f o p q | None => false end
    | None => false
    end).
Definition has_edge (p q : site) (r : row) : bool :=
  lists points_table p r && lists points_table q r.
(** Of the rows, numbered from [k], none but those with the numbers [t] and [u] has the edge. *)
Fixpoint no_third (t u : positive) (p q : site) (k : positive) (l : list row) : bool :=
  match l with
  | [] => true
  | r :: l' => (Pos.eqb k t || Pos.eqb k u || negb (has_edge p q r)) &&
               no_third t u p q (Pos.succ k) l'
  end.
Definition same_ends (p q p' q' : site) : bool :=
  same_place p p' && same_place q q' || same_place p q' && same_place q p'.

Definition wide_at (ti uj : positive * nat) : bool :=
  negb (Pos.eqb (fst ti) (fst uj)) &&
  side_at ti (fun a p q => side_at uj (fun b p' q' =>
    same_ends p q p' q' && negb (at_most_pi (cotangent a p q) (cotangent b p' q')) &&
    no_third (fst ti) (fst uj) p q 1 (rows m))).
Definition refute_surface_in (ti uj : positive * nat) : bool :=
  (0 <? unit_numerator m) && (0 <? unit_denominator m) && forallb (shaped pr) (sites m) &&
  wide_at ti uj.
End Evidence.

Definition refute_surface (D : plane_or_space) (x : surface_refutation) : bool :=
  refute_surface_in (predicates_of D) (surface_mesh x) (one_side x) (other_side x).
