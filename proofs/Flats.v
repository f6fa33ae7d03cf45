(** * Points of a plane in space: what claims say of them, and what their certificates hold

    The definitions of [Definitions.v] are about d-simplices.  Here are the same of simplices of a
    lower dimension k, for points whose affine hull has the dimension k: the book's k-dimensional
    point sets in R^d.  [CERTIFICATE.md] describes the files. *)
From Coq Require Import Rbase List ZArith.
From Circumspect Require Import Definitions.
Import ListNotations.
Open Scope R_scope.

Section Flat.
Context {d : nat}.
Variable k : nat.

(** The points lie where <n, p> = b, and k + 1 of them are affinely independent.  (For d = 3 and
    k = 2 this says that their affine hull is this plane.) *)
Definition lie_in_hyperplane (n : point d) (b : R) (S : list (point d)) : Prop :=
  n <> origin /\ (forall p, In p S -> inner n p = b) /\
  exists X, incl X S /\ length X = Datatypes.S k /\ affinely_independent X.

(** Definition 2.1, for a k-dimensional point set.  ([T] lists the k-simplices.) *)
Definition flat_triangulation (S : list (point d)) (T : list (simplex d)) : Prop :=
  (forall t, In t T -> NoDup t /\ length t = Datatypes.S k) /\
  simplicial_complex (faces_of T) /\
  ForallOrdPairs (fun s t => ~ same s t) T /\
  (forall t, In t T -> incl t S) /\
  (forall q, conv S q <-> exists t, In t T /\ conv t q) /\
  (forall p, In p S -> exists t, In t T /\ In p t).

(** Definition 4.1: every k-simplex is Delaunay.  (Its circumballs are balls of R^d.) *)
Definition flat_delaunay_triangulation (S : list (point d)) (T : list (simplex d)) : Prop :=
  flat_triangulation S T /\ forall t, In t T -> delaunay S t.
End Flat.

(** ** Certificates, as they stand in a file

    The points are seen along an axis, as points of the plane, and have a certificate there: of a
    triangulation, or of a weighted Delaunay triangulation in which each point has as its weight
    the square of what is not seen, negative.  Where all points are is the plane
    <flat_normal, p> = flat_offset. *)
Record flat_certificate := FlatCertificate {
  unseen_axis : nat;
  unseen : list Z;                 (* one a point *)
  flat_normal : list Z; flat_offset : Z
}.

(** The point with its third coordinate. *)
Definition with_unseen (i : nat) (s : site) (z : Z) : site :=
  Site match i, coordinates s with
       | O, l => z :: l
       | S O, x :: l => x :: z :: l
       | _, l => l ++ [z]
       end 0.

Section FlatCertificate.
Variables (c : certificate) (x : flat_certificate).
Definition flat_points : list (point 3) :=
  map (fun ez => place_of (unit_of c) (with_unseen (unseen_axis x) (position (fst ez)) (snd ez)))
    (combine (points c) (unseen x)).
Definition flat_simplices : list (simplex 3) :=
  map (fun e => map (fun k => nth (pred (Pos.to_nat k)) flat_points origin) (corners e))
    (simplices c).
End FlatCertificate.
