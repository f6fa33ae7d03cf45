(** * The verdict on a packed certificate

    [judge] is extracted.  Where [quick] is true the certificate is accepted ([Judged.v]); where it
    is false nothing is said, and the checker proper decides. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export PackedCheck.
From Circumspect Require Import Word Quick QuickPlane.
Import ListNotations.

Section Quickly.
Variables (D : plane_or_space) (p : packed) (asked : option standing) (s : Word.t).
Notation c := (frame p).
Notation pr := (predicates_of D).

(** What is asked of a simplex besides that it is accepted. *)
Definition settled_as (m : mesh) (t : positive) (e : simplex_entry) : bool :=
  match asked with None => true | Some st => settled_simplex pr m st t e end.

(** Words have room for the coordinates, and number all things. *)
Definition words_suffice : bool :=
  negb (weights_of (claimed c)) &&
  match asked with None => true | Some _ => delaunay_of (claimed c) end &&
  scaled c && is_accepted (check_points pr (points c)) &&
  forallb (fun e => forallb (fits s) (coordinates (position e))) (points c) &&
  forallb (fits s) (coordinates (sample c)) && fits zero (sample_denominator c) &&
  leb (shifted zero (sample_denominator c)) eight &&
  leb (simplex_count p) many && leb (count_of (points c)) many.

(** All is accepted: quickly, where that says so, or else by the checker proper. *)
Definition each_quickly (m : mesh) (simplex : positive -> bool)
    (hull_facet : positive -> hull_entry -> bool) : bool :=
  is_accepted (each (fun k e => if quick_used D (simplex_count p) (rows_of p) k e then Accepted else
    check_point pr m k e) 1 (points c)) &&
  inside_sample pr m &&
  all (simplex_count p) (fun t => simplex t ||
    let e := entry_of D (rows_of p) t in
    is_accepted (check_simplex pr m t e) && settled_as m t e) &&
  is_accepted (each (fun h f => if hull_facet h f then Accepted else check_hull pr m h f) 1
    (hull c)).

Definition arrow_of (q : site) : arrow :=
  match coordinates q with
  | [x; y; z] => Arrow (shifted s x) (shifted s y) (shifted s z)
  | _ => Arrow zero zero zero
  end.
Definition step_of (q : site) : step :=
  match coordinates q with
  | [x; y] => Step (shifted s x) (shifted s y)
  | _ => Step zero zero
  end.

Definition quick : bool :=
  words_suffice &&
  let m := packed_mesh D p in
  let count := simplex_count p in
  let points_count := count_of (points c) in
  let rows := rows_of p in
  let places := places_of s (points c) in
  let w := shifted zero (sample_denominator c) in
  match D with
  | Plane =>
      each_quickly m
        (quick_triangle m count points_count rows places s (step_of (sample c)) w asked)
        (fun _ _ => false)
  | Space =>
      each_quickly m
        (quick_simplex m count points_count rows places s (arrow_of (sample c)) w asked)
        (quick_hull m points_count places s)
  end.
End Quickly.

Inductive verdict := Holds | Fails (c : condition) (p : place) | NotSettled (p : place).

Definition judge (D : plane_or_space) (p : packed) (asked : option standing) (s : Word.t) :
  verdict :=
  if quick D p asked s then Holds
  else
    match check_packed D p with
    | Rejected why where_ => Fails why where_
    | Accepted => match asked with
                  | None => Holds
                  | Some st => match settle_packed D p st with
                               | Settled => Holds
                               | Unsettled where_ => NotSettled where_
                               end
                  end
    end.
