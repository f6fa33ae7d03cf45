(** * What a certificate says, in the caller's coordinates

    The theorems of [Soundness.v] are about these points, simplices and weights: the integer points
    of the certificate times P/Q, lists of them, and the integer weights times (P/Q)^2. *)
From Coq Require Import Reals List ZArith.
From Coq Require Vector.
From Circumspect Require Import Checker Definitions.
Import ListNotations.
Open Scope R_scope.

Definition dimension_of (D : plane_or_space) : nat := match D with Plane => 2 | Space => 3 end.

(** The first d of the integers, as a point; and [r] times the point. *)
Fixpoint integer_point (d : nat) (l : list Z) : point d :=
  match d with
  | O => Vector.nil R
  | S d' => Vector.cons R (IZR (hd 0%Z l)) d' (integer_point d' (tl l))
  end.
Definition place_of {d : nat} (r : R) (s : site) : point d :=
  scale r (integer_point d (coordinates s)).

Section Certificate.
Variables (d : nat) (c : certificate).

(** P/Q *)
Definition unit_of : R := IZR (numerator c) / IZR (denominator c).

Definition points_of_certificate : list (point d) :=
  map (fun e => place_of unit_of (position e)) (points c).

(** The point with number [k], counted from 1.  (A number that names no point would mean the origin;
    accepted certificates have none.) *)
Definition spot (k : positive) : point d :=
  nth (pred (Pos.to_nat k)) points_of_certificate origin.

Definition simplices_of_certificate : list (simplex d) :=
  map (fun e => map spot (corners e)) (simplices c).

(** The function [w] gives the points the weights of the certificate. *)
Definition weights_given (w : point d -> R) : Prop := forall e, In e (points c) ->
  w (place_of unit_of (position e)) = unit_of ^ 2 * IZR (weight (position e)).
End Certificate.
