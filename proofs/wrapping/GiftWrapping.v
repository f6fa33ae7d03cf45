(** * Gift-wrapping  (Book: Section 5.6)

    [wrap] is extracted; [WrappingSound.v] proves that it returns the canonical Delaunay
    triangulation of every point set that spans the plane or space.  It begins with any simplex that
    has every other point above its witness plane, and crosses facet after facet: beyond each it
    looks at all points and keeps the lower one.  Slow: the time is that of looking at all points
    from each facet, and more where many are cospherical. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Refutation.
Import ListNotations.
Open Scope Z_scope.

(** A point with its number. *)
Notation spotted := (positive * site)%type.

Section Wrapping.
Variable pr : predicates.
(** All points, in the order of their perturbation. *)
Variable P : list spotted.
Implicit Types (p v : spotted) (X Y : list spotted).

Fixpoint place_in (k : positive) X : option nat :=
  match X with
  | [] => None
  | v :: X' => if Pos.eqb k (fst v) then Some 0%nat else option_map S (place_in k X')
  end.
Definition is_vertex X p : bool := match place_in (fst p) X with Some _ => true | None => false end.

(** ** How high p is above the witness plane of X, symbolically: a number with that sign

    The coefficients of the polynomial in e, all times the square of the orientation. *)
Definition coefficient X p v : Z :=
  if Pos.eqb (fst v) (fst p) then - (orientation pr (map snd X) * orientation pr (map snd X))
  else match place_in (fst v) X with
       | Some i => coordinate_sign pr (map snd X) (snd p) 1 i
       | None => 0
       end.
Fixpoint first_nonzero {A} (f : A -> Z) (l : list A) : Z :=
  match l with [] => 0 | a :: l' => let z := f a in if z =? 0 then first_nonzero f l' else z end.
Definition height_sign X p : Z :=
  let z := below_sign pr (map snd X) (snd p) in
  if z =? 0 then first_nonzero (coefficient X p) P else - z.

(** ** Across a facet *)

Definition is_beyond X (i : nat) p : bool := coordinate_sign pr (map snd X) (snd p) 1 i <? 0.
Definition lower X (i : nat) (best : option spotted) p : option spotted :=
  if is_beyond X i p then
    match best with
    | None => Some p
    | Some b => if height_sign (replace i b X) p <? 0 then Some p else best
    end
  else best.
Definition apex_beyond X (i : nat) : option spotted := fold_left (lower X i) P None.
Definition neighbours X : list (list spotted) :=
  flat_map (fun i => match apex_beyond X i with Some b => [replace i b X] | None => [] end)
    (corners_numbered pr).

(** ** All of it *)

Definition same_vertices X Y : bool := forallb (is_vertex Y) X && forallb (is_vertex X) Y.
(** What was found, and of that whose facets have not been crossed yet. *)
Definition state := (list (list spotted) * list (list spotted))%type.
Definition added (st : state) Y : state :=
  if existsb (same_vertices Y) (fst st) then st else (Y :: fst st, Y :: snd st).
Definition step (st : state) : state :=
  match snd st with [] => st | X :: q => fold_left added (neighbours X) (fst st, q) end.
Fixpoint steps (n : positive) (st : state) : state :=
  match snd st with
  | [] => st
  | _ => match n with
         | xH => step st
         | xO n' => steps n' (steps n' st)
         | xI n' => steps n' (steps n' (step st))
         end
  end.

(** The first simplex, of [n] further points of [Q]. *)
Definition passes X : bool :=
  right_length pr X && proper pr (map snd X) && forallb (fun p => is_vertex X p ||
    (0 <? height_sign X p)) P.
Fixpoint search (n : nat) (Q : list spotted) X : option (list spotted) :=
  match n with
  | O => if passes X then Some X else None
  | S n' => (fix tried (l : list spotted) : option (list spotted) :=
      match l with
      | [] => None
      | p :: l' => match search n' Q (p :: X) with Some Y => Some Y | None => tried l' end
      end) Q
  end.

Fixpoint power (p : positive) (n : nat) : positive :=
  match n with O => xH | S n' => Pos.mul p (power p n') end.
(** There are no more simplices than these. *)
Definition enough : positive := power (Pos.of_succ_nat (length P)) (S (dimension pr)).
Definition wrapped (Q : list spotted) : option (list (list positive)) :=
  match search (S (dimension pr)) Q [] with
  | None => None
  | Some X => match steps enough ([X], [X]) with
              | (found, []) => Some (map (map fst) found)
              | _ => None
              end
  end.
End Wrapping.

(** [near] lists the same points, in the order in which they are tried for the first simplex. *)
Definition numbered_from_one (l : list site) : list spotted :=
  combine (map Pos.of_succ_nat (seq 0 (length l))) (map (fun s => Site (coordinates s) 0) l).
Definition squared_distance (p q : site) : Z :=
  fold_right (fun xy s => (fst xy - snd xy) * (fst xy - snd xy) + s) 0
    (combine (coordinates p) (coordinates q)).
Fixpoint inserted (o : site) (p : spotted) (l : list spotted) : list spotted :=
  match l with
  | [] => [p]
  | q :: l' => if squared_distance o (snd p) <=? squared_distance o (snd q) then p :: l else
      q :: inserted o p l'
  end.
Definition by_distance (o : site) (l : list spotted) : list spotted := fold_right (inserted o) [] l.
Fixpoint all_differ (l : list site) : bool :=
  match l with [] => true | s :: l' => negb (existsb (same_place s) l') && all_differ l' end.
(** Nothing if two points are equal, or if all lie in a line or a plane. *)
Definition wrap (D : plane_or_space) (l : list site) : option (list (list positive)) :=
  let pr := predicates_of D in
  let P := numbered_from_one l in
  match l with
  | [] => None
  | o :: _ => if forallb (shaped pr) l && all_differ l then wrapped pr P (by_distance o P) else None
  end.
