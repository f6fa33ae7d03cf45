(** * The checker of refutations

    [refute] is extracted beside [check]; [RefutationSound.v] proves what its acceptance means.  A
    refutation is the caller's own mesh and what is wrong with it: one line that says where to
    look, as CERTIFICATE.md describes it.  The mesh may be anything; only the lines that the
    evidence names are held to any shape.  Nothing is searched: the time is linear. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Predicates Checker.
Import ListNotations.
Open Scope Z_scope.

(** Different numbers may name equal points, and where the evidence speaks of points and simplices
    that are the same or different, their coordinates are compared. *)

(** The claims that the evidence refutes. *)
Definition concerns (e : evidence) (c : claim) : bool :=
  match e, c with
  | UnusedPoint _, WeightedDelaunay => false
  | UncoveredPoint _ _, WeightedDelaunay => true
  | UncoveredPoint _ _, _ => false
  | VertexInBall _ _, Delaunay => true
  | VertexInBall _ _, _ => false
  | FacetNotLocal _ _ _ _, Triangulation => false
  | PointBelowPlane _ _, WeightedDelaunay => true
  | PointBelowPlane _ _, _ => false
  | VertexSubmerged _ _ _, WeightedDelaunay => true
  | VertexSubmerged _ _ _, _ => false
  | _, _ => true
  end.

(** ** Points and simplices *)

Fixpoint same_numbers (k l : list Z) : bool :=
  match k, l with
  | [], [] => true
  | x :: k', y :: l' => (x =? y) && same_numbers k' l'
  | _, _ => false
  end.
(** The points are equal, whatever their weights. *)
Definition same_place (p q : site) : bool := same_numbers (coordinates p) (coordinates q).
Definition all_among (X Y : list site) : bool := forallb (fun p => existsb (same_place p) Y) X.
Definition same_places (X Y : list site) : bool := all_among X Y && all_among Y X.

Section Evidence.
Variable pr : predicates.
Variable S : Table.t site.

(** The point that an entry names. *)
Definition named (n : option positive) : option site :=
  match n with Some k => Table.find k S | None => None end.
Fixpoint all_named (r : row) : option (list site) :=
  match r with
  | [] => Some []
  | n :: r' => match named n, all_named r' with
               | Some p, Some X => Some (p :: X)
               | _, _ => None
               end
  end.
(** Nothing beyond the first n + 1 entries is looked at. *)
Fixpoint has_length {A} (n : nat) (l : list A) : bool :=
  match l, n with
  | [], O => true
  | _ :: l', Datatypes.S n' => has_length n' l'
  | _, _ => false
  end.
Definition right_length {A} (l : list A) : bool := has_length (Datatypes.S (dimension pr)) l.
(** The d+1 vertices of a simplex that has them.  The length comes first: the recursion that looks
    the names up is then d+1 deep, however many entries the caller has written. *)
Definition simplex_of (r : row) : option (list site) :=
  if right_length r then all_named r else None.
(** The same, for a simplex that is not degenerate. *)
Definition proper (X : list site) : bool := negb (orientation pr X =? 0).
Definition proper_simplex_of (r : row) : option (list site) :=
  match simplex_of r with
  | Some X => if proper X then Some X else None
  | None => None
  end.

(** A number with the sign of barycentric coordinate i of the point q / w. *)
Definition coordinate_sign (X : list site) (q : site) (w : Z) (i : nat) : Z :=
  orientation pr X * side pr i X q w.
Definition corners_numbered : list nat := seq 0 (Datatypes.S (dimension pr)).
Definition in_simplex (X : list site) (q : site) (w : Z) : bool :=
  forallb (fun i => 0 <=? coordinate_sign X q w i) corners_numbered.
Definition strictly_in_simplex (X : list site) (q : site) (w : Z) : bool :=
  forallb (fun i => 0 <? coordinate_sign X q w i) corners_numbered.
(** The vertices with positive coordinates. *)
Definition carrier_of (X : list site) (q : site) (w : Z) : list site :=
  map snd (filter (fun iv => 0 <? coordinate_sign X q w (fst iv)) (combine corners_numbered X)).
Definition beyond (X : list site) (q : site) (w : Z) (i : nat) : bool :=
  Nat.ltb i (Datatypes.S (dimension pr)) && (coordinate_sign X q w i <? 0).
(** A number with the sign of how far the lifted point p is below the witness plane of X. *)
Definition below_sign (X : list site) (p : site) : Z :=
  orientation pr X * depth pr X (slope pr X) p.

(** A point of the text, with its denominator. *)
Definition point_written (q : site) (w : Z) : bool := shaped pr q && (0 <? w).

(** The facets opposite vertices i and j have the same vertices. *)
Definition same_facet (X : list site) (i : nat) (Y : list site) (j : nat) : bool :=
  Nat.ltb i (Datatypes.S (dimension pr)) && Nat.ltb j (Datatypes.S (dimension pr)) &&
  same_places (remove i X) (remove j Y).
(** Vertices i and j are different points. *)
Definition other_apex (X : list site) (i : nat) (Y : list site) (j : nat) : bool :=
  match nth_error X i, nth_error Y j with
  | Some p, Some q => negb (same_place p q)
  | _, _ => false
  end.

(** ** What the evidence says *)

Definition overused (X : list site) (i : nat) (Y : list site) (j : nat) (Z : list site) (k : nat) :=
  same_facet X i Y j && same_facet Y j Z k &&
  other_apex X i Y j && other_apex Y j Z k && other_apex X i Z k.

Definition overlapping (X Y : list site) (q : site) (w : Z) : bool :=
  point_written q w && in_simplex X q w && in_simplex Y q w &&
  negb (same_places (carrier_of X q w) (carrier_of Y q w)).

Definition twice (X Y : list site) (q : site) (w : Z) : bool :=
  point_written q w && strictly_in_simplex X q w && in_simplex Y q w && negb (same_places X Y).

Fixpoint all_beyond (q : site) (w : Z) (l : list row) (facets : list nat) : bool :=
  match l, facets with
  | [], [] => true
  | r :: l', i :: facets' =>
      match proper_simplex_of r with Some X => beyond X q w i | None => false end &&
      all_beyond q w l' facets'
  | _, _ => false
  end.

Definition not_local (X : list site) (i : nat) (Y : list site) (j : nat) : bool :=
  same_facet X i Y j &&
  match nth_error Y j with
  | Some v => beyond X v 1 i && (0 <? below_sign X v)
  | None => false
  end.

Definition submerged (X : list site) (v : site) : bool :=
  in_simplex X v 1 && (below_sign X v <? 0).

Definition lists (p : site) (r : row) : bool :=
  existsb (fun n => match named n with Some q => same_place p q | None => false end) r.

(** [f] is a facet of [X]; every row that lists all its points is a simplex with the vertices
    [X]. *)
Definition no_other (X f : list site) (r : row) : bool :=
  negb (forallb (fun p => lists p r) f) ||
  match simplex_of r with Some Y => same_places X Y | None => false end.
Definition on_boundary (l : list row) (X : list site) (i : nat) : bool :=
  Nat.ltb i (Datatypes.S (dimension pr)) && forallb (no_other X (remove i X)) l.

(** The points of the first list that are in both others. *)
Definition in_all_three (f g h : list site) : list site :=
  filter (fun p => existsb (same_place p) g && existsb (same_place p) h) f.
(** Three facets are different and share d - 1 points. *)
Definition on_ridge (f g h : list site) : bool :=
  negb (same_places f g) && negb (same_places g h) && negb (same_places f h) &&
  match dimension pr with
  | O => false
  | Datatypes.S n => has_length n (in_all_three f g h)
  end.

Variable L : Table.t row.

Definition row_at (t : positive) (f : row -> bool) : bool :=
  match Table.find t L with Some r => f r | None => false end.
Definition entry_at (t : positive) (i : nat) (f : option positive -> bool) : bool :=
  row_at t (fun r => match nth_error r i with Some n => f n | None => false end).
Definition simplex_at (t : positive) (f : list site -> bool) : bool :=
  row_at t (fun r => match simplex_of r with Some X => f X | None => false end).
Definition proper_at (t : positive) (f : list site -> bool) : bool :=
  row_at t (fun r => match proper_simplex_of r with Some X => f X | None => false end).
Definition point_at (p : positive) (f : site -> bool) : bool :=
  match Table.find p S with Some q => f q | None => false end.
(** A simplex that is not degenerate, of points of the list. *)
Definition proper_with (X : list positive) (f : list site -> bool) : bool :=
  right_length X &&
  match proper_simplex_of (map Some X) with Some Y => f Y | None => false end.

Definition repeats (m n : option positive) : bool :=
  match m, n with
  | Some k, Some l => Pos.eqb k l && point_at k (fun _ => true)
  | _, _ => false
  end.

Definition holds (l : list row) (e : evidence) : bool :=
  match e with
  | WrongDimension t =>
      row_at t (fun r => negb (right_length r))
  | UnknownVertex t i =>
      entry_at t i (fun n => match named n with Some _ => false | None => true end)
  | RepeatedVertex t i j =>
      negb (Nat.eqb i j) && entry_at t i (fun m => entry_at t j (repeats m))
  | Degenerate t => simplex_at t (fun X => negb (proper X))
  | DuplicateSimplex t u =>
      negb (Pos.eqb t u) && simplex_at t (fun X => simplex_at u (same_places X))
  | FacetOverused t i u j v k =>
      proper_at t (fun X => proper_at u (fun Y => proper_at v (fun Z => overused X i Y j Z k)))
  | Overlap t u q w => proper_at t (fun X => proper_at u (fun Y => overlapping X Y q w))
  | CoveredTwice t u q w => proper_at t (fun X => proper_at u (fun Y => twice X Y q w))
  | UnusedPoint p => point_at p (fun q => negb (existsb (lists q) l))
  | UncoveredPoint p facets => point_at p (fun q => all_beyond q 1 l facets)
  | HullNotConvex t i p =>
      proper_at t (fun X => point_at p (fun q => on_boundary l X i && beyond X q 1 i))
  | HullNotClosed t i u j v k =>
      proper_at t (fun X => proper_at u (fun Y => proper_at v (fun Z =>
        on_boundary l X i && on_boundary l Y j && on_boundary l Z k &&
        on_ridge (remove i X) (remove j Y) (remove k Z))))
  | VertexInBall t p | PointBelowPlane t p =>
      proper_at t (fun X => point_at p (fun q => 0 <? below_sign X q))
  | FacetNotLocal t i u j => proper_at t (fun X => proper_at u (fun Y => not_local X i Y j))
  | VertexSubmerged t i X =>
      simplex_at t (fun Y => match nth_error Y i with
                             | Some v => proper_with X (fun Z => submerged Z v)
                             | None => false
                             end)
  end.
End Evidence.

(** ** The whole *)

(** The point, with its weight if that counts. *)
Definition site_for (c : claim) (p : site) : site :=
  if weights_of c then p else Site (coordinates p) 0.

(** The points span R^d: without it the caller could mean a triangulation of lower dimension. *)
Definition refute_in (pr : predicates) (r : refutation) : bool :=
  let S := Table.of_list (site_for (refuted r)) (sites r) in
  concerns (because r) (refuted r) &&
  (0 <? unit_numerator r) && (0 <? unit_denominator r) &&
  forallb (shaped pr) (sites r) &&
  proper_with pr S (basis r) (fun _ => true) &&
  holds pr S (Table.of_list id (rows r)) (rows r) (because r).

Definition refute (D : plane_or_space) (r : refutation) : bool := refute_in (predicates_of D) r.
