(** * Packed certificates: the simplices as rows of words

    Nearly all of a certificate is its simplices.  As records and lists one of them takes 300 bytes
    and more; here it is a row of 2 (d + 1) + 1 words.  [unpacked] says which certificate that
    is. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Definitions.
From Circumspect Require Word.
Import ListNotations.

Record packed := Packed {
  (* all but the simplices: its list of them is empty *)
  frame : certificate;
  simplex_count : Word.t;
  (* for each simplex: its vertices; its walls, 8 T + J for [Neighbour T J], and -H for [OnHull H];
     and S, or -1 for - *)
  rows_of : Word.words
}.

(** Where the row of a simplex begins, and what stands there. *)
Definition row_length (D : plane_or_space) : Word.t :=
  match D with Plane => Word.seven | Space => Word.nine end.
Definition row_of (D : plane_or_space) (t : Word.t) : Word.t :=
  Word.mul (row_length D) (Word.sub t Word.one).

Definition wall_of (x : Word.t) : wall :=
  if Word.ltb x Word.zero then OnHull (Word.to_pos (Word.sub Word.zero x))
  else let t := Word.down x Word.three in
       Neighbour (Word.to_pos t) (Word.index (Word.sub x (Word.mul Word.eight t))).
Definition away_of (x : Word.t) : option nat :=
  if Word.ltb x Word.zero then None else Some (Word.index x).

Definition corners_of (D : plane_or_space) (rows : Word.words) (t : positive) : list positive :=
  let r := row_of D (Word.of_pos t) in
  let corner k := Word.to_pos (Word.get rows (Word.add r k)) in
  match D with
  | Plane => [corner Word.zero; corner Word.one; corner Word.two]
  | Space => [corner Word.zero; corner Word.one; corner Word.two; corner Word.three]
  end.
Definition entry_of (D : plane_or_space) (rows : Word.words) (t : positive) : simplex_entry :=
  let r := row_of D (Word.of_pos t) in
  let cell k := Word.get rows (Word.add r k) in
  let wall k := wall_of (cell k) in
  match D with
  | Plane => SimplexEntry (corners_of D rows t)
      [wall Word.three; wall Word.four; wall Word.five] (away_of (cell Word.six))
  | Space => SimplexEntry (corners_of D rows t)
      [wall Word.four; wall Word.five; wall Word.six; wall Word.seven] (away_of (cell Word.eight))
  end.

Definition unpacked (D : plane_or_space) (p : packed) : certificate :=
  let c := frame p in
  Certificate (claimed c) (numerator c) (denominator c) (points c)
    (map (entry_of D (rows_of p)) (Word.upto (simplex_count p)))
    (hull c) (sample_simplex c) (sample c) (sample_denominator c).
