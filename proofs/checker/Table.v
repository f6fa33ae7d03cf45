(** * Tables: things that are found by their numbers

    To the proofs a table is the list of the things, numbered from 1.  The extracted program has
    arrays instead ([ocaml/table.ml]), so that finding takes no longer than looking, and functions
    that make a thing when it is looked for or asked for: that they do the same is trusted, and
    tested. *)
From Coq Require Import List PArith.
From Circumspect Require Import Definitions.
From Circumspect Require Word.
Import ListNotations.

Definition t (A : Type) := list A.
Definition of_list {A B} (f : A -> B) (l : list A) : t B := map f l.
Definition find {A} (k : positive) (m : t A) : option A := numbered m k.
(** What is made when it is asked for, the program makes once. *)
Definition once {A} (f : unit -> A) : unit -> A := f.
Definition tabulate {A} (n : Word.t) (f : positive -> A) : t A := map f (Word.upto n).
