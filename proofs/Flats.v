(** * Points of a plane in space, of a line or of one place: what claims say of them, and what their
    certificates and refutations hold

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

(** [S] is a k-dimensional point set: k + 1 of its points are affinely independent, and no more. *)
Definition of_dimension (S : list (point d)) : Prop :=
  (exists X, incl X S /\ length X = Datatypes.S k /\ affinely_independent X) /\
  forall X, incl X S -> affinely_independent X -> (length X <= Datatypes.S k)%nat.

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

(** ** Rules that a mesh of such points may break

    [S] and [L] are as in [Definitions.v]; here a simplex lists k + 1 points. *)
Section FlatRules.
Context {d : nat}.
Variable k : nat.
Implicit Types (S : list (point d)) (L : list (list (option (point d)))).

Definition flat_wrong_dimension L : Prop :=
  exists r : list (option (point d)), In r L /\ length r <> Datatypes.S k.
(** A point in every open circumball, of R^d, of a simplex. *)
Definition flat_vertex_in_ball S L : Prop := exists s p, listed L s /\
  length s = Datatypes.S k /\ affinely_independent s /\ In p S /\
  forall c r2, circumball s c r2 -> dist2 c p < r2.
(** A point lies beyond a facet that only one simplex has: they are on different sides of a
    hyperplane through it. *)
Definition flat_hull_not_convex S L : Prop := exists s f v p, listed L s /\
  length s = Datatypes.S k /\ affinely_independent s /\ NoDup f /\ length f = k /\ incl f s /\
  (forall t, listed L t -> incl f t -> same s t) /\
  In v s /\ In p S /\ on_opposite_sides f v p.
(** Of the other rules nothing is said; of this one only on lines. *)
Definition broken_of_flat S L (r : rule) : Prop :=
  match r with
  | triangulation_hull_not_convex => k = 1%nat /\ flat_hull_not_convex S L
  | simplex_wrong_dimension => flat_wrong_dimension L
  | triangulation_unused_point => unused_point S L
  | delaunay_vertex_in_ball => flat_vertex_in_ball S L
  | _ => False
  end.
End FlatRules.

(** What is claimed of points of any dimension.  (Of weighted ones nothing is said here.) *)
Definition claims_flat {d} (c : claim) (S : list (point d)) (L : list (list (option (point d)))) :
  Prop := exists k T, of_dimension k S /\ L = map (map Some) T /\
  match c with
  | Delaunay => flat_delaunay_triangulation k S T
  | _ => flat_triangulation k S T
  end.

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

(** Points of a line, in their order along it, and the simplices, which join neighbours: the points
    with the numbers k and k + 1 are joined by simplex number k of [line_order].  The pads make a
    d-simplex of the first and the last point.  Of one point the simplex is this point. *)
Record line_certificate := LineCertificate {
  line_numerator : Z; line_denominator : Z;                    (* scale P Q *)
  line_sites : list site;
  line_rows : list (list positive);
  line_order : list positive;
  line_pads : list site
}.
Section LineCertificate.
Variables (d : nat) (c : line_certificate).
Definition line_unit : R := IZR (line_numerator c) / IZR (line_denominator c).
Definition line_points : list (point d) := map (place_of line_unit) (line_sites c).
Definition line_simplices : list (simplex d) :=
  map (map (fun k => nth (pred (Pos.to_nat k)) line_points origin)) (line_rows c).
End LineCertificate.

(** A refutation: the mesh, whose [basis] is k + 1 points that make a d-simplex with the pads; and,
    of a point in every ball, how it shows: the sum of the vertices and the point, each times its
    integer, is zero, as is the sum of these, and that of the squares of their norms is negative. *)
Record flat_refutation := FlatRefutation {
  flat_mesh : refutation; flat_pads : list site; ball_own : list Z; ball_other : Z }.
