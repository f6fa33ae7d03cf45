(** * Extraction: the checker becomes an OCaml program

    Integers become Zarith's (that is, GMP's); the checker only adds, subtracts, multiplies and
    compares them, it never takes one apart.  Positive numbers, the keys of maps, stay the binary
    numerals of Coq, and natural numbers, which count the vertices of a simplex, those of Peano;
    words become OCaml's strings. *)
From Coq Require Import ZArith FMapPositive.
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNativeString.
From Circumspect Require Import Checker Settling Refutation.

Extract Inductive positive => "Big.numeral" [ "Big.XI" "Big.XO" "Big.XH" ].
Extract Inductive Z => "Big.t"
  [ "Big.zero" "Big.of_numeral" "(fun n -> Big.neg (Big.of_numeral n))" ]
  "(fun _ _ _ _ -> assert false)".
Extract Inlined Constant Z.add => "Big.add".
Extract Inlined Constant Z.sub => "Big.sub".
Extract Inlined Constant Z.mul => "Big.mul".
Extract Inlined Constant Z.opp => "Big.neg".
Extract Inlined Constant Z.leb => "Big.leq".
Extract Inlined Constant Z.ltb => "Big.lt".
Extract Inlined Constant Z.eqb => "Big.equal".

(* The maps of the standard library come with a comparison of keys that is opaque; it is not used. *)
Set Warnings "-extraction-opaque-accessed".
Extraction "extracted.ml" check settle refute rule_of rule_name claim_name.
