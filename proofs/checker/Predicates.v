(** * Integer predicates: the determinants that the checker evaluates

    The two dimensions differ in these functions alone; [Checker.v] is written for both.  All use
    nothing but sums and products of integers, which the extracted program computes with GMP.  The
    factors are differences of coordinates, so that small simplices make small numbers. *)
From Coq Require Import ZArith List.
From Circumspect Require Export Definitions.
Import ListNotations.
Open Scope Z_scope.

(** Vertices are counted from 0.  "Positive" simplices have d+1 vertices [X] whose orientation,
    det[v0 - vd; ...; v(d-1) - vd], is positive. *)
Record predicates := Predicates {
  (* d *)
  dimension : nat;
  orientation : list site -> Z;
  (* [side i X s w]: w times the orientation of X with vertex i replaced by the point s / w *)
  side : nat -> list site -> site -> Z -> Z;
  (* the hyperplane through the lifted vertices is q |-> <n, q - vd> / orientation + height of vd *)
  slope : list site -> list Z;
  (* [depth X (slope X) p]: the orientation of X times the height of the hyperplane above the
     lifted point p; without weights this is the in-ball determinant *)
  depth : list site -> list Z -> site -> Z
}.

(** ** The plane *)

Definition from2 (w : Z) (q p : site) : Z * Z :=
  match coordinates p, coordinates q with
  | [x; y], [x'; y'] => (x - w * x', y - w * y')
  | _, _ => (0, 0)
  end.
Definition minus2 (p q : site) : Z * Z :=
  match coordinates p, coordinates q with
  | [x; y], [x'; y'] => (x - x', y - y')
  | _, _ => (0, 0)
  end.
Definition det2 (u v : Z * Z) : Z :=
  let '(x, y) := u in let '(x', y') := v in x * y' - y * x'.
(** The height of p above q: the square of the distance, less the difference of the weights. *)
Definition height2 (u : Z * Z) (p q : site) : Z :=
  let '(x, y) := u in x * x + y * y - (weight p - weight q).

Definition orientation2 (X : list site) : Z :=
  match X with
  | [a; b; c] => det2 (minus2 a c) (minus2 b c)
  | _ => 0
  end.
Definition side2 (i : nat) (X : list site) (s : site) (w : Z) : Z :=
  match X, i with
  | [a; b; c], 0%nat => det2 (from2 w c s) (minus2 b c)
  | [a; b; c], 1%nat => det2 (minus2 a c) (from2 w c s)
  | [a; b; c], 2%nat => det2 (minus2 b a) (from2 w a s)
  | _, _ => 0
  end.
Definition slope2 (X : list site) : list Z :=
  match X with
  | [a; b; c] =>
      let u := minus2 a c in let v := minus2 b c in
      let h := height2 u a c in let k := height2 v b c in
      let '(ux, uy) := u in let '(vx, vy) := v in
      [ux * vy - uy * vx; h * vy - k * uy; k * ux - h * vx]
  | _ => []
  end.
Definition depth2 (X : list site) (n : list Z) (p : site) : Z :=
  match X, n with
  | [a; b; c], [det; nx; ny] =>
      let u := minus2 p c in
      let '(x, y) := u in nx * x + ny * y - det * height2 u p c
  | _, _ => 0
  end.

Definition plane_predicates : predicates :=
  Predicates 2 orientation2 side2 slope2 depth2.

(** ** Space *)

Definition from3 (w : Z) (q p : site) : Z * Z * Z :=
  match coordinates p, coordinates q with
  | [x; y; z], [x'; y'; z'] => (x - w * x', y - w * y', z - w * z')
  | _, _ => (0, 0, 0)
  end.
Definition minus3 (p q : site) : Z * Z * Z :=
  match coordinates p, coordinates q with
  | [x; y; z], [x'; y'; z'] => (x - x', y - y', z - z')
  | _, _ => (0, 0, 0)
  end.
Definition cross3 (u v : Z * Z * Z) : Z * Z * Z :=
  let '(x, y, z) := u in let '(x', y', z') := v in
  (y * z' - z * y', z * x' - x * z', x * y' - y * x').
Definition inner3 (u v : Z * Z * Z) : Z :=
  let '(x, y, z) := u in let '(x', y', z') := v in x * x' + y * y' + z * z'.
Definition det3 (u v w : Z * Z * Z) : Z := inner3 u (cross3 v w).
Definition height3 (u : Z * Z * Z) (p q : site) : Z := inner3 u u - (weight p - weight q).

Definition orientation3 (X : list site) : Z :=
  match X with
  | [a; b; c; d] => det3 (minus3 a d) (minus3 b d) (minus3 c d)
  | _ => 0
  end.
Definition side3 (i : nat) (X : list site) (s : site) (w : Z) : Z :=
  match X, i with
  | [a; b; c; d], 0%nat => det3 (from3 w d s) (minus3 b d) (minus3 c d)
  | [a; b; c; d], 1%nat => det3 (from3 w d s) (minus3 c d) (minus3 a d)
  | [a; b; c; d], 2%nat => det3 (from3 w d s) (minus3 a d) (minus3 b d)
  | [a; b; c; d], 3%nat => det3 (from3 w a s) (minus3 c a) (minus3 b a)
  | _, _ => 0
  end.
Definition slope3 (X : list site) : list Z :=
  match X with
  | [a; b; c; d] =>
      let u := minus3 a d in let v := minus3 b d in let w := minus3 c d in
      let f := height3 u a d in let g := height3 v b d in let h := height3 w c d in
      let vw := cross3 v w in
      let '(ux, uy, uz) := vw in
      let '(vx, vy, vz) := cross3 w u in
      let '(wx, wy, wz) := cross3 u v in
      [inner3 u vw; f * ux + g * vx + h * wx; f * uy + g * vy + h * wy; f * uz + g * vz + h * wz]
  | _ => []
  end.
Definition depth3 (X : list site) (n : list Z) (p : site) : Z :=
  match X, n with
  | [a; b; c; d], [det; nx; ny; nz] =>
      let u := minus3 p d in
      let '(x, y, z) := u in nx * x + ny * y + nz * z - det * height3 u p d
  | _, _ => 0
  end.

Definition space_predicates : predicates :=
  Predicates 3 orientation3 side3 slope3 depth3.
