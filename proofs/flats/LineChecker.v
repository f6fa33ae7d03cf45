(** * The checker of certificates of points on a line, or in one place

    [check_line] is extracted; [LineSound.v] proves what its acceptance means.  On a line there is
    one triangulation, which joins neighbours; so there are no balls to look at. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Refutation Flats.
From Circumspect Require Table.
Import ListNotations.
Open Scope Z_scope.

Section Line.
Variables (pr : predicates) (c : line_certificate).
Let order_table := Table.of_list id (line_order c).
Let rows_table := Table.of_list id (line_rows c).

(** A number that grows along the line from the first vertex of [X] to the second. *)
Definition along (X : list site) (s : site) : Z := coordinate_sign pr X s 1 1.
(** The point is on the line: the pads have no part in it. *)
Definition on_line (X : list site) (s : site) : bool :=
  forallb (fun i => coordinate_sign pr X s 1 i =? 0) (seq 2 (pred (dimension pr))).

(** The lower number of two neighbours. *)
Definition lower_end (e : list positive) : option positive :=
  match e with
  | [i; j] => if Pos.eqb j (Pos.succ i) then Some i
              else if Pos.eqb i (Pos.succ j) then Some j else None
  | _ => None
  end.
(** [simplex-listed]: without it a simplex could join others than neighbours, or be listed twice. *)
Definition check_joint (t : positive) (e : list positive) : result :=
  require simplex_listed by
    match lower_end e with
    | Some k => match Table.find k order_table with Some u => Pos.eqb u t | None => false end
    | None => false
    end at AtSimplex t;
  Accepted.
Definition joins (t k : positive) : bool :=
  match Table.find t rows_table with
  | Some e => match lower_end e with Some i => Pos.eqb i k | None => false end
  | None => false
  end.

(** [points-increasing]: without it the points could be off the line, or others lie between two that
    are joined.  [edge-listed]: without it two neighbours could be joined by nothing.  Point number
    [k] is [from] along the line, and the others come after it. *)
Fixpoint steps (X : list site) (k : positive) (from : Z) (l : list site) (order : list positive) :
  result :=
  match l, order with
  | [], [] => Accepted
  | s :: l', t :: order' =>
      let x := along X s in
      require points_increasing by on_line X s && (from <? x) at AtPoint (Pos.succ k);
      require edge_listed by joins t k at AtEdge k;
      steps X (Pos.succ k) x l' order'
  | _, _ => Rejected edge_listed (AtEdge k)
  end.

Definition check_several (first : site) (others : list site) : result :=
  let X := first :: last others first :: line_pads c in
  require simplex_proper by
    forallb (shaped pr) (line_pads c) && right_length pr X && proper pr X at Nowhere;
  steps X 1 (along X first) others (line_order c) ;;
  each check_joint 1 (line_rows c).

Definition check_line_in : result :=
  require Checker.scale by (0 <? line_numerator c) && (0 <? line_denominator c) at Nowhere;
  require vertex_known by forallb (shaped pr) (line_sites c) at Nowhere;
  match line_sites c with
  | [] => Rejected simplex_listed Nowhere
  | [_] => require simplex_listed by
      match line_rows c with [[k]] => Pos.eqb k 1 | _ => false end at Nowhere; Accepted
  | first :: others => check_several first others
  end.
End Line.

Definition check_line (D : plane_or_space) (c : line_certificate) : result :=
  check_line_in (predicates_of D) c.
