(** * A mesh alone: what the claim [complex] says, and what its certificates hold

    docs/theory/complex.md has the same definition in words.  [CERTIFICATE.md] describes the files. *)
From Coq Require Import Rbase List ZArith.
From Circumspect Require Import Definitions.
Import ListNotations.
Open Scope R_scope.

Section Complex.
Context {d : nat}.

(** The simplices of [T] list k + 1 points of [S] each, none is listed twice, no vertex is repeated and none is flat
    (its vertices are affinely independent); any two simplices s and t, as sets of vertices, meet in conv(s ∩ t) and nowhere
    else; no point is listed twice, and each is a vertex.  There is a simplex, or the claim would hold for nothing. *)
Record simplices_form_a_complex (S : list (point d)) (T : list (simplex d)) : Prop := {
  some_simplex : T <> [];
  of_one_dimension : exists k, forall t, In t T -> length t = Datatypes.S k;
  independent_vertices : forall t, In t T -> incl t S /\ affinely_independent t;
  none_twice : ForallOrdPairs (fun s t => ~ same s t) T;
  meeting_in_faces : ForallOrdPairs (fun s t => forall q, conv s q -> conv t q ->
    exists f, incl f s /\ incl f t /\ conv f q) T;
  points_once : NoDup S;
  points_used : forall p, In p S -> exists t, In t T /\ In p t
}.
End Complex.

(** ** Certificates, as they stand in a file *)

(** The numbers of the vertices; where the simplex stands in the order; points that make d + 1 affinely independent ones of
    the vertices; and for some other simplices, by their numbers, a hyperplane <n, p> = o that parts the two. *)
Record cell_entry := CellEntry {
  cell_vertices : list positive; cell_place : positive; cell_pads : list site;
  cell_parted : list (positive * (list Z * Z)) }.
Record complex_certificate := ComplexCertificate {
  complex_numerator : Z; complex_denominator : Z;              (* scale P Q *)
  complex_points : list point_entry;
  complex_dimension : nat;                                     (* k *)
  complex_cells : list cell_entry;
  complex_order : list positive                                (* simplices that are near one another, side by side *)
}.

(** Its points and simplices are those of a certificate without the rest. *)
Definition bare_certificate (c : complex_certificate) : certificate :=
  Certificate Triangulation (complex_numerator c) (complex_denominator c) (complex_points c)
    (map (fun e => SimplexEntry (cell_vertices e) [] None) (complex_cells c)) [] 1 (Site [] 0) 1.
