(** * Extraction: the checker becomes an OCaml program

    Integers become Zarith's (that is, GMP's); the checker only adds, subtracts, multiplies and
    compares them, it never takes one apart.  Positive numbers, by which things are found in tables,
    become OCaml's integers: they number things that are in memory, far fewer than 2^62, and
    the reader of files sees to it that the others do ([ocaml/reading.ml]).  Natural numbers, which
    count the vertices of a simplex, stay Peano's; words become OCaml's strings; tables become
    arrays. *)
From Coq Require Import ZArith.
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNativeString.
From Circumspect Require Import Checker Settling ComplexChecker DomainRefutation WholeRefutation ImpossibleChecker.

Extract Inductive positive => "int" [ "(fun n -> 2 * n + 1)" "(fun n -> 2 * n)" "1" ]
  "(fun more twice one n -> if n = 1 then one () else if n land 1 = 1 then more (n / 2) else twice (n / 2))".
Extract Inlined Constant Pos.eqb => "Int.equal".
Extract Inlined Constant Pos.ltb => "Big.less".
Extract Inlined Constant Pos.succ => "Int.succ".
Extract Constant Table.t "'a" => "'a Table.t".
Extract Constant Table.of_list => "Table.of_list".
Extract Constant Table.find => "Table.find".

Extract Inductive Z => "Big.t" [ "Big.zero" "Big.of_int" "(fun n -> Big.of_int (- n))" ]
  "(fun _ _ _ _ -> assert false)".
Extract Inlined Constant Z.add => "Big.add".
Extract Inlined Constant Z.sub => "Big.sub".
Extract Inlined Constant Z.mul => "Big.mul".
Extract Inlined Constant Z.opp => "Big.neg".
Extract Inlined Constant Z.leb => "Big.leq".
Extract Inlined Constant Z.ltb => "Big.lt".
Extract Inlined Constant Z.eqb => "Big.equal".

Extraction "extracted.ml" check settle refute rule_of rule_name claim_name
  check_domain check_complex domain_claim_name refute_domain domain_rule_of domain_rule_name
  refute_whole whole_rule_of check_impossible.
