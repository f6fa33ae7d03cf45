(** * A quick check of the tetrahedra of a packed certificate

    Where [quick_simplex] is true the checker accepts the tetrahedron ([QuickTetrahedron.v]); where
    it is false nothing is said, and the checker proper decides ([Judge.v]).  A tetrahedron is
    looked at in words alone.  Its determinants are estimated: all edges are scaled so that the
    longest has about 27 binary digits, and of products no more than 31 are kept; the margins are
    what that can amount to ([Estimates.v]).  Where it is not certain on which side of a circumball
    an apex is, integers tell, of this apex alone.  Where another sign of a tetrahedron is not
    certain, or one of its conditions fails, it goes to [check_simplex]. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export PackedCheck.
From Circumspect Require Import Word.
Import ListNotations.

(** ** Estimates of determinants *)

(** Three words, each a coordinate. *)
Record arrow := Arrow { along_x : Word.t; along_y : Word.t; along_z : Word.t }.

Definition arrow_from (p q : arrow) : arrow :=
  Arrow (sub (along_x p) (along_x q)) (sub (along_y p) (along_y q)) (sub (along_z p) (along_z q)).
Definition dot (p q : arrow) : Word.t :=
  add (add (mul (along_x p) (along_x q)) (mul (along_y p) (along_y q)))
    (mul (along_z p) (along_z q)).
(** The cross product, without its last 26 digits. *)
Definition crossed (p q : arrow) : arrow :=
  Arrow (down26 (sub (mul (along_y p) (along_z q)) (mul (along_z p) (along_y q))))
    (down26 (sub (mul (along_z p) (along_x q)) (mul (along_x p) (along_z q))))
    (down26 (sub (mul (along_x p) (along_y q)) (mul (along_y p) (along_x q)))).

(** A word that no coordinate exceeds; how many digits it has; and whether none is greater than
    [most]. *)
Definition larger (x y : Word.t) : Word.t := if ltb x y then y else x.
Definition absolute (x : Word.t) : Word.t := if ltb x zero then sub zero x else x.
Definition largest (p : arrow) : Word.t :=
  larger (absolute (along_x p)) (larger (absolute (along_y p)) (absolute (along_z p))).
Definition at_most (most x : Word.t) : bool := leb (sub zero most) x && leb x most.
Definition inside (most : Word.t) (p : arrow) : bool :=
  at_most most (along_x p) && at_most most (along_y p) && at_most most (along_z p).

Definition c27 : Word.t := of_pos 27.
Definition c30 : Word.t := of_pos 30.
Definition c60 : Word.t := of_pos 60.

(** A coordinate of [n] digits with 27. *)
Definition level (n x : Word.t) : Word.t :=
  if leb n c27 then up x (sub c27 n) else down x (sub n c27).
Definition leveled (n : Word.t) (p : arrow) : arrow :=
  Arrow (level n (along_x p)) (level n (along_y p)) (level n (along_z p)).

(** What the errors can amount to, for the three signs below ([Estimates.v]). *)
Definition orientation_margin : Word.t := of_pos (22 * 2 ^ 28).
Definition side_margin : Word.t := of_pos (82 * 2 ^ 28).
Definition depth_margin : Word.t := of_pos (1024 * 2 ^ 28).

(** More things than these are not numbered by words here. *)
Definition many : Word.t := of_pos (2 ^ 58).
Definition known (most v : Word.t) : bool := leb one v && leb v most.
(** The same of a number that is no word. *)
Definition counted (most : Word.t) (k : positive) : bool :=
  known most (of_pos k) && Pos.eqb (to_pos (of_pos k)) k.
(** Without the last [s] digits of coordinates, differences of [n] digits will do: digits that were
    left out are none of those that are kept. *)
Definition fine (s n : Word.t) : bool := leb zero n && leb n c60 && (eqb s zero || leb c30 n).

(** ** In rows and in integers, whatever the dimension *)

Section Rows.
Variables (D : plane_or_space) (m : mesh) (count : Word.t) (rows : Word.words).

(** Corner number [a] of those but number [j] of the simplex whose row begins at [r]. *)
Definition other_corner (r j a : Word.t) : Word.t :=
  get rows (add r (if leb j a then add a one else a)).
Definition is_odd (j : Word.t) : bool := eqb j one || eqb j three.

(** [used], of a vertex. *)
Definition quick_used (k : positive) (e : point_entry) : bool :=
  counted count (home e) &&
  let r := row_of D (of_pos (home e)) in
  let is_k i := Pos.eqb (to_pos (get rows (add r i))) k in
  match home_vertex e, D with
  | Some 0%nat, _ => is_k zero
  | Some 1%nat, _ => is_k one
  | Some 2%nat, _ => is_k two
  | Some 3%nat, Space => is_k three
  | _, _ => false
  end.

(** Whether a point is below the witness plane of simplex [K], in integers; and what is asked of the
    certificate besides that it is accepted.  The plane is that of one simplex for all its walls. *)
Definition exact_plane (K : list positive) : option (list positive * list site * list Z) :=
  match find_all (points_of m) K with
  | Some X => Some (K, X, slope (predicates_of D) X)
  | None => None
  end.
Definition exactly_below (asked : option standing)
    (plane : option (list positive * list site * list Z)) (k : positive) : bool :=
  match plane, Table.find k (points_of m) with
  | Some (K, X, n), Some p =>
      let z := depth (predicates_of D) X n p in
      (z <? 0)%Z || (z =? 0)%Z && match asked with
                                  | None => true
                                  | Some Unique => false
                                  | Some Canonical => decided (predicates_of D) K X k p
                                  end
  | _, _ => false
  end.
End Rows.

(** The coordinates of the points without the last [s] binary digits, one after the other. *)
Definition places_of (s : Word.t) (l : list point_entry) : Word.words :=
  of_lists (fun e => map (shifted s) (coordinates (position e))) l.

Section Quick.
(** The mesh, the rows of its simplices; and the places of the points, and how many digits they are
    without. *)
Variables (m : mesh) (count points_count : Word.t) (rows places : Word.words) (s : Word.t).
(** The sample point the same way, and its denominator. *)
Variables (sample_place : arrow) (w : Word.t).
(** What is asked of the certificate besides that it is accepted. *)
Variable asked : option standing.

Definition arrow_to (v : Word.t) : arrow :=
  let k := mul three (sub v one) in
  Arrow (get places k) (get places (add k one)) (get places (add k two)).

(** ** Matched facets *)

(** The facets k0 k1 k2 and l0 l1 l2 differ by an even permutation, or by an odd one. *)
Definition rotated (k0 k1 k2 l0 l1 l2 : Word.t) : bool :=
  (eqb k0 l0 && eqb k1 l1 && eqb k2 l2) || (eqb k1 l0 && eqb k2 l1 && eqb k0 l2) ||
  (eqb k2 l0 && eqb k0 l1 && eqb k1 l2).
Definition reflected (k0 k1 k2 l0 l1 l2 : Word.t) : bool := rotated k0 k2 k1 l0 l1 l2.

(** [facet_matched] and [back_pointer] across facet [i] of simplex [t], whose other vertices are k0
    k1 k2; [apex_ok u v] says what is asked of vertex [v] of the simplex [u] there. *)
Definition quick_wall (t : positive) (i : Word.t) (i_is_odd : bool) (k0 k1 k2 x : Word.t)
    (apex_ok : Word.t -> Word.t -> bool) : bool :=
  if ltb x zero then names_hull m t (index i) (to_pos (sub zero x))
  else
    let u := down x three in
    let j := sub x (mul eight u) in
    let r := row_of Space u in
    known count u && leb j three &&
    eqb (get rows (add r (add four j))) (add (mul eight (of_pos t)) i) &&
    let v := get rows (add r j) in
    known points_count v && negb (eqb v k0) && negb (eqb v k1) && negb (eqb v k2) &&
    let l0 := other_corner rows r j zero in
    let l1 := other_corner rows r j one in
    let l2 := other_corner rows r j two in
    (if Bool.eqb i_is_odd (is_odd j) then reflected k0 k1 k2 l0 l1 l2
     else rotated k0 k1 k2 l0 l1 l2) &&
    apex_ok u v.

(** ** The sample point *)

Definition quick_outside (t : positive) (pa pd vw wu uv : arrow) (a : Word.t) : bool :=
  Pos.eqb t (start m) ||
  (eqb a zero || eqb a one || eqb a two || eqb a three) &&
  let base := if eqb a three then pa else pd in
  let q := Arrow (sub (along_x sample_place) (mul w (along_x base)))
    (sub (along_y sample_place) (mul w (along_y base)))
    (sub (along_z sample_place) (mul w (along_z base))) in
  let n := size (largest q) in
  fine s n && inside (up one n) q &&
  let q' := leveled n q in
  if eqb a zero then ltb (dot q' vw) (sub zero side_margin)
  else if eqb a one then ltb (dot q' wu) (sub zero side_margin)
  else if eqb a two then ltb (dot q' uv) (sub zero side_margin)
  else ltb side_margin (add (add (dot q' vw) (dot q' wu)) (dot q' uv)).

(** ** A tetrahedron *)

(** The point at [p] is below the witness plane: strictly outside the circumball. *)
Definition quick_below (n : Word.t) (pd slope : arrow) (det : Word.t) (p : arrow) : bool :=
  let e := arrow_from p pd in
  inside (up one (add n one)) e &&
  let e' := leveled n e in
  ltb (add (dot slope e') depth_margin) (mul det (down26 (dot e' e'))).

Definition slope_of (f g h : Word.t) (vw wu uv : arrow) : arrow :=
  let sum x y z := down28 (add (add (mul f x) (mul g y)) (mul h z)) in
  Arrow (sum (along_x vw) (along_x wu) (along_x uv)) (sum (along_y vw) (along_y wu) (along_y uv))
    (sum (along_z vw) (along_z wu) (along_z uv)).

Definition quick_simplex (t : positive) : bool :=
  let r := row_of Space (of_pos t) in
  let a := get rows (add r zero) in
  let b := get rows (add r one) in
  let c := get rows (add r two) in
  let d := get rows (add r three) in
  known points_count a && known points_count b && known points_count c && known points_count d &&
  negb (eqb a b) && negb (eqb a c) && negb (eqb a d) &&
  negb (eqb b c) && negb (eqb b d) && negb (eqb c d) &&
  let pa := arrow_to a in
  let pd := arrow_to d in
  let eu := arrow_from pa pd in
  let ev := arrow_from (arrow_to b) pd in
  let ew := arrow_from (arrow_to c) pd in
  let n := size (larger (largest eu) (larger (largest ev) (largest ew))) in
  let most := up one n in
  fine s n && inside most eu && inside most ev && inside most ew &&
  let u := leveled n eu in
  let v := leveled n ev in
  let w := leveled n ew in
  let vw := crossed v w in
  let wu := crossed w u in
  let uv := crossed u v in
  let det := dot u vw in
  ltb orientation_margin det &&
  quick_outside t pa pd vw wu uv (get rows (add r eight)) &&
  let below :=
    if delaunay_claimed m then
      let slope := slope_of (down26 (dot u u)) (down26 (dot v v)) (down26 (dot w w)) vw wu uv in
      let det' := down28 det in
      let plane := Table.once (fun _ =>
        exact_plane Space m [to_pos a; to_pos b; to_pos c; to_pos d]) in
      fun u v => negb (Pos.ltb t (to_pos u)) ||
        quick_below n pd slope det' (arrow_to v) ||
        exactly_below Space m asked (plane tt) (to_pos v)
    else fun _ _ => true in
  quick_wall t zero false b c d (get rows (add r four)) below &&
  quick_wall t one true a c d (get rows (add r five)) below &&
  quick_wall t two false a b d (get rows (add r six)) below &&
  quick_wall t three true a b c (get rows (add r seven)) below.

(** ** Hull facets

    As [check_hull] has it, but at ridges orientations are estimated first. *)

Definition quick_positive (pa pb pc pd : arrow) : bool :=
  let eu := arrow_from pa pd in
  let ev := arrow_from pb pd in
  let ew := arrow_from pc pd in
  let n := size (larger (largest eu) (larger (largest ev) (largest ew))) in
  let most := up one n in
  fine s n && inside most eu && inside most ev && inside most ew &&
  ltb orientation_margin (dot (leveled n eu) (crossed (leveled n ev) (leveled n ew))).
Definition place_at (k : positive) : arrow := arrow_to (of_pos k).
(** With vertex [v] in place of number [i] the tetrahedron is positive, too. *)
Definition quick_side (E : list positive) (i : nat) (v : positive) : bool :=
  match replace i v E with
  | [a; b; c; d] => forallb (counted points_count) [a; b; c; d] &&
      quick_positive (place_at a) (place_at b) (place_at c) (place_at d)
  | _ => false
  end.

Definition quick_ridge (h : positive) (i : nat) (E K : list positive) (X : list site) (a : nat)
  (r : positive * nat) : bool :=
  let '(g, b) := r in
  match Table.find g (hull_of m) with
  | None => false
  | Some f =>
      match Table.find (carrier f) (simplices_of m) with
      | None => false
      | Some u =>
          let L := remove (apex f) (corners u) in
          matched_ridge K L i (apex f) a b && ridge_points_back h a f b &&
          match nth_error L b with
          | None => false
          | Some v => match Table.find v (points_of m) with
                      | None => false
                      | Some p => quick_side E i v || locally_convex space_predicates i X p
                      end
          end
      end
  end.
Fixpoint every_index {A} (f : nat -> A -> bool) (k : nat) (l : list A) : bool :=
  match l with [] => true | a :: l' => f k a && every_index f (S k) l' end.
Definition quick_hull (h : positive) (f : hull_entry) : bool :=
  match Table.find (carrier f) (simplices_of m) with
  | None => false
  | Some e =>
      named_by_facet h (apex f) e &&
      match find_all (points_of m) (corners e) with
      | None => false
      | Some X =>
          inside_hull_facet space_predicates m (apex f) X && Nat.eqb (length (ridges f)) 3 &&
          every_index (quick_ridge h (apex f) (corners e) (remove (apex f) (corners e)) X) 0
            (ridges f)
      end
  end.
End Quick.
