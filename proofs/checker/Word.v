(** * Words: integers of 63 bits

    To the proofs a word is an integer, and what comes of words is wrapped round to 63 bits, as
    OCaml's [int] does on machines of 64 bits.  The extracted program has [int] instead, and for
    lists of words arrays of memory without pointers ([ocaml/word.ml], [ocaml/words.ml]): that these
    do the same is trusted, and tested.  That nothing is in fact wrapped round where a sign is told,
    is proved ([Estimates.v]). *)
From Coq Require Import ZArith List Bool.
Import ListNotations.
Open Scope Z_scope.

Definition t := Z.
Definition wrap (z : Z) : t := (z + 2 ^ 62) mod 2 ^ 63 - 2 ^ 62.

Definition zero : t := 0.
Definition one : t := 1.
Definition two : t := 2.
Definition three : t := 3.
Definition four : t := 4.
Definition five : t := 5.
Definition six : t := 6.
Definition seven : t := 7.
Definition eight : t := 8.
Definition nine : t := 9.
Definition add (x y : t) : t := wrap (x + y).
Definition sub (x y : t) : t := wrap (x - y).
Definition mul (x y : t) : t := wrap (x * y).
Definition ltb (x y : t) : bool := x <? y.
Definition leb (x y : t) : bool := x <=? y.
Definition eqb (x y : t) : bool := x =? y.
(** Shifts: [x] times or divided by a power of two.  Where [k] is none of 0 ... 62 the result is
    0. *)
Definition up (x k : t) : t := if (0 <=? k) && (k <=? 62) then wrap (x * 2 ^ k) else 0.
Definition down (x k : t) : t := if (0 <=? k) && (k <=? 62) then x / 2 ^ k else 0.
Definition down26 (x : t) : t := x / 2 ^ 26.
Definition down28 (x : t) : t := x / 2 ^ 28.
(** The number of binary digits of a positive word; of others 0. *)
Definition size (x : t) : t := if x <=? 0 then 0 else Z.log2 x + 1.

(** Words as the numbers of things, and the other way round. *)
Definition of_pos (p : positive) : t := wrap (Zpos p).
Definition to_pos (x : t) : positive := Z.to_pos x.
Definition index (x : t) : nat := Z.to_nat x.
(** An integer without its last [s] binary digits, if what is left is small; else 0. *)
Definition fits (s : t) (z : Z) : bool :=
  (0 <=? s) && (s <=? 2 ^ 20) && (- 2 ^ 58 <=? Z.shiftr z s) && (Z.shiftr z s <? 2 ^ 58).
Definition shifted (s : t) (z : Z) : t := if fits s z then Z.shiftr z s else 0.
(** The numbers from 1 to [n]; and whether each passes. *)
Definition upto (n : t) : list positive := map Pos.of_succ_nat (seq 0 (Z.to_nat n)).
Definition all (n : t) (f : positive -> bool) : bool := forallb f (upto n).

(** How many things there are. *)
Definition count_of {A} (l : list A) : t := wrap (Z.of_nat (length l)).

(** ** Lists of words, counted from 0; where there is none there is a 0. *)
Definition words := list t.
Definition of_lists {A} (f : A -> list t) (l : list A) : words := flat_map f l.
Definition get (l : words) (k : t) : t := if 0 <=? k then wrap (nth (Z.to_nat k) l 0) else 0.
