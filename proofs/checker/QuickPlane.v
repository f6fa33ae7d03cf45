(** * A quick check of the triangles of a packed certificate

    As [Quick.v] has it of tetrahedra.  In the plane words have room for more digits: of a product
    26 are left out only where it is multiplied once more. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Quick.
From Circumspect Require Import Word.
Import ListNotations.

(** ** Estimates of determinants *)

(** Two words, each a coordinate. *)
Record step := Step { east : Word.t; north : Word.t }.

Definition step_from (p q : step) : step :=
  Step (sub (east p) (east q)) (sub (north p) (north q)).
Definition turn (p q : step) : Word.t :=
  sub (mul (east p) (north q)) (mul (north p) (east q)).
Definition square (p : step) : Word.t :=
  add (mul (east p) (east p)) (mul (north p) (north p)).
Definition longest (p : step) : Word.t := larger (absolute (east p)) (absolute (north p)).
Definition in_square (most : Word.t) (p : step) : bool :=
  at_most most (east p) && at_most most (north p).
Definition leveled_step (n : Word.t) (p : step) : step :=
  Step (level n (east p)) (level n (north p)).

(** What the errors can amount to, for the three signs below ([QuickTriangle.v]). *)
Definition turn_margin : Word.t := of_pos (3 * 2 ^ 28).
Definition away_margin : Word.t := of_pos (7 * 2 ^ 28).
Definition circle_margin : Word.t := of_pos (256 * 2 ^ 28).

Section Plane.
(** As in [Quick.v]. *)
Variables (m : mesh) (count points_count : Word.t) (rows places : Word.words) (s : Word.t).
Variables (sample_place : step) (w : Word.t).
Variable asked : option standing.

Definition step_to (v : Word.t) : step :=
  let k := mul two (sub v one) in Step (get places k) (get places (add k one)).

(** [facet_matched] and [back_pointer] across side [i] of triangle [t], whose ends are k0 k1;
    [apex_ok u v] says what is asked of vertex [v] of the triangle [u] there. *)
Definition quick_side_wall (t : positive) (i : Word.t) (i_is_odd : bool) (k0 k1 x : Word.t)
    (apex_ok : Word.t -> Word.t -> bool) : bool :=
  if ltb x zero then names_hull m t (index i) (to_pos (sub zero x))
  else
    let u := down x three in
    let j := sub x (mul eight u) in
    let r := row_of Plane u in
    known count u && leb j two &&
    eqb (get rows (add r (add three j))) (add (mul eight (of_pos t)) i) &&
    let v := get rows (add r j) in
    known points_count v && negb (eqb v k0) && negb (eqb v k1) &&
    let l0 := other_corner rows r j zero in
    let l1 := other_corner rows r j one in
    (if Bool.eqb i_is_odd (is_odd j) then eqb k0 l1 && eqb k1 l0 else eqb k0 l0 && eqb k1 l1) &&
    apex_ok u v.

Definition quick_away (t : positive) (pa pc u v : step) (a : Word.t) : bool :=
  Pos.eqb t (start m) ||
  (eqb a zero || eqb a one || eqb a two) &&
  let base := if eqb a two then pa else pc in
  let q := Step (sub (east sample_place) (mul w (east base)))
    (sub (north sample_place) (mul w (north base))) in
  let n := size (longest q) in
  fine s n && in_square (up one n) q &&
  let q' := leveled_step n q in
  ltb (if eqb a zero then turn q' v else if eqb a one then turn u q' else turn (step_from v u) q')
    (sub zero away_margin).

(** The point at [p] is below the witness plane: strictly outside the circumcircle. *)
Definition quick_beyond (n : Word.t) (pc slope : step) (det : Word.t) (p : step) : bool :=
  let e := step_from p pc in
  in_square (up one (add n one)) e &&
  let e' := leveled_step n e in
  ltb (add (add (mul (east slope) (east e')) (mul (north slope) (north e'))) circle_margin)
    (mul det (down26 (square e'))).

Definition slope_at (h k : Word.t) (u v : step) : step :=
  Step (down26 (sub (mul h (north v)) (mul k (north u))))
    (down26 (sub (mul k (east u)) (mul h (east v)))).

Definition quick_triangle (t : positive) : bool :=
  let r := row_of Plane (of_pos t) in
  let a := get rows (add r zero) in
  let b := get rows (add r one) in
  let c := get rows (add r two) in
  known points_count a && known points_count b && known points_count c &&
  negb (eqb a b) && negb (eqb a c) && negb (eqb b c) &&
  let pa := step_to a in
  let pc := step_to c in
  let eu := step_from pa pc in
  let ev := step_from (step_to b) pc in
  let n := size (larger (longest eu) (longest ev)) in
  let most := up one n in
  fine s n && in_square most eu && in_square most ev &&
  let u := leveled_step n eu in
  let v := leveled_step n ev in
  let det := turn u v in
  ltb turn_margin det &&
  quick_away t pa pc u v (get rows (add r six)) &&
  let below :=
    if delaunay_claimed m then
      let slope := slope_at (down26 (square u)) (down26 (square v)) u v in
      let det' := down26 det in
      let plane := Table.once (fun _ => exact_plane Plane m [to_pos a; to_pos b; to_pos c]) in
      fun u v => negb (Pos.ltb t (to_pos u)) ||
        quick_beyond n pc slope det' (step_to v) ||
        exactly_below Plane m asked (plane tt) (to_pos v)
    else fun _ _ => true in
  quick_side_wall t zero false b c (get rows (add r three)) below &&
  quick_side_wall t one true a c (get rows (add r four)) below &&
  quick_side_wall t two false a b (get rows (add r five)) below.
End Plane.
