(** * A mesh alone: what the claim [complex] says, and what its certificates hold

    docs/theory/complex.md has the same definition in words.  [CERTIFICATE.md] describes the
    files. *)
From Coq Require Import String Rbase List ZArith.
From Circumspect Require Import Definitions.
Import ListNotations.
Open Scope R_scope.

Section Complex.
Context {d : nat}.

(** The simplices of [T] list k + 1 points of [S] each, none is listed twice, no vertex is repeated
    and none is flat (its vertices are affinely independent); any two simplices s and t, as sets of
    vertices, meet in conv(s ∩ t) and nowhere else; no point is listed twice.  There is a simplex,
    or the claim would hold for nothing. *)
Record simplices_meet_in_faces (S : list (point d)) (T : list (simplex d)) : Prop := {
  some_simplex : T <> [];
  of_one_dimension : exists k, forall t, In t T -> length t = Datatypes.S k;
  independent_vertices : forall t, In t T -> incl t S /\ affinely_independent t;
  none_twice : ForallOrdPairs (fun s t => ~ same s t) T;
  meeting_in_faces : ForallOrdPairs (fun s t => forall q, conv s q -> conv t q ->
    exists f, incl f s /\ incl f t /\ conv f q) T;
  points_once : NoDup S
}.
(** And each point is a vertex.  (With [--allow-unused] this is not asked.) *)
Record simplices_form_a_complex (S : list (point d)) (T : list (simplex d)) : Prop := {
  among_points :> simplices_meet_in_faces S T;
  points_used : forall p, In p S -> exists t, In t T /\ In p t
}.
End Complex.

(** ** Certificates, as they stand in a file *)

(** The numbers of the vertices; where the simplex stands in the order; points that make d + 1
    affinely independent ones of the vertices; and for some other simplices, by their numbers, a
    hyperplane <n, p> = o that parts the two. *)
Record cell_entry := CellEntry {
  cell_vertices : list positive; cell_place : positive; cell_pads : list site;
  cell_parted : list (positive * (list Z * Z)) }.
Record complex_certificate := ComplexCertificate {
  complex_numerator : Z; complex_denominator : Z;              (* scale P Q *)
  complex_points : list point_entry;
  complex_dimension : nat;                                     (* k *)
  complex_cells : list cell_entry;
  (* simplices that are near one another, side by side *)
  complex_order : list positive
}.

(** Its points and simplices are those of a certificate without the rest. *)
Definition bare_certificate (c : complex_certificate) : certificate :=
  Certificate Triangulation (complex_numerator c) (complex_denominator c) (complex_points c)
    (map (fun e => SimplexEntry (cell_vertices e) [] None) (complex_cells c)) [] 1 (Site [] 0) 1.

(** ** Rules that a mesh alone may break

    [S] and [L] are as in [Definitions.v], which has the other rules. *)
Section Rules.
Context {d : nat}.
Implicit Types (S : list (point d)) (L : list (list (option (point d)))).

Definition claims_complex S L : Prop := exists T, L = map (map Some) T /\
  simplices_form_a_complex S T.

Definition points_equal S : Prop := ~ NoDup S.
(** A vertex of one simplex, and not of the other, is inside a face of the other. *)
Definition hanging_vertex L : Prop := exists s t f v : list (point d), listed_simplex L s /\
  listed_simplex L t /\
  length v = 1%nat /\ incl v t /\ (forall p, In p v -> ~ In p s) /\ incl f s /\
    (2 <= length f)%nat /\
  forall p, In p v -> strictly_inside f p.
(** Faces of two simplices without a common vertex, each an edge at least, cross. *)
Definition faces_cross L : Prop := exists (s t f g : list (point d)) q, listed_simplex L s /\
  listed_simplex L t /\
  incl f s /\ incl g t /\ (forall p, In p f -> ~ In p g) /\ (2 <= length f)%nat /\
    (2 <= length g)%nat /\
  strictly_inside f q /\ strictly_inside g q.

Inductive rule_of_complex := OfPoints (r : rule) | HangingVertex | FacesCross | PointsEqual.
Definition rule_of_complex_name (r : rule_of_complex) : string :=
  match r with
  | OfPoints r => rule_name r
  | HangingVertex => "complex.hanging-vertex"
  | FacesCross => "complex.faces-cross"
  | PointsEqual => "complex.points-equal"
  end%string.
Definition broken_of_complex S L (r : rule_of_complex) : Prop :=
  match r with
  | OfPoints r => broken Triangulation norm2 S L r
  | HangingVertex => hanging_vertex L
  | FacesCross => faces_cross L
  | PointsEqual => points_equal S
  end.
End Rules.

(** A refutation of the claim: one that holds of the mesh as a triangulation; simplices T and U and
    a point q / w in both, as for [Overlap]; or the numbers of two points. *)
Inductive against_complex :=
  | AsOfPoints
  | Hanging (t u : positive) (q : site) (w : Z)
  | Crossing (t u : positive) (q : site) (w : Z)
  | EqualPoints (p q : positive).
Record complex_refutation :=
  ComplexRefutation { mesh_alone : refutation; against : against_complex }.
