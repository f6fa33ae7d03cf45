(** * Extraction: the checker becomes an OCaml program

    Integers become Zarith's (that is, GMP's); the checker only adds, subtracts, multiplies and
    compares them, it never takes one apart.  Positive numbers, by which things are found in tables,
    become OCaml's integers: they number things that are in memory, far fewer than 2^62, and
    the reader of files sees to it that the others do ([ocaml/reading.ml]).  Natural numbers, which
    count the vertices of a simplex, stay Peano's; words become OCaml's strings; tables become
    arrays. *)
From Coq Require Import ZArith.
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNativeString.
From Circumspect Require Import Judge ComplexChecker DomainRefutation WholeRefutation
  ImpossibleChecker.
From Circumspect Require Import MeshAlone AloneRefutation GiftWrapping HullChecker FlatChecker.
From Circumspect Require Import SurfaceRefutation LineChecker FlatRefutation HullRefutation.
From Circumspect Require Import PeriodicChecker.

Extract Inductive positive => "int" [ "(fun n -> 2 * n + 1)" "(fun n -> 2 * n)" "1" ]
  "(fun more twice one n -> if n = 1 then one () else if n land 1 = 1 then more (n / 2) else twice (n / 2))".
Extract Inlined Constant Pos.eqb => "Int.equal".
Extract Inlined Constant Pos.ltb => "Big.less".
Extract Inlined Constant Pos.succ => "Int.succ".
Extract Constant Table.t "'a" => "'a Table.t".
Extract Constant Table.of_list => "Table.of_list".
Extract Constant Table.find => "Table.find".
Extract Constant Table.tabulate => "Table.tabulate".
Extract Constant Table.once => "Table.once".

Extract Inlined Constant Word.t => "int".
Extract Inlined Constant Word.zero => "0".
Extract Inlined Constant Word.one => "1".
Extract Inlined Constant Word.two => "2".
Extract Inlined Constant Word.three => "3".
Extract Inlined Constant Word.four => "4".
Extract Inlined Constant Word.five => "5".
Extract Inlined Constant Word.six => "6".
Extract Inlined Constant Word.seven => "7".
Extract Inlined Constant Word.eight => "8".
Extract Inlined Constant Word.nine => "9".
Extract Inlined Constant Word.add => "(+)".
Extract Inlined Constant Word.sub => "(-)".
Extract Inlined Constant Word.mul => "( * )".
Extract Inlined Constant Word.ltb => "Word.less".
Extract Inlined Constant Word.leb => "Word.at_most".
Extract Inlined Constant Word.eqb => "Word.equal".
Extract Inlined Constant Word.up => "Word.up".
Extract Inlined Constant Word.down => "Word.down".
Extract Inlined Constant Word.down26 => "Word.down26".
Extract Inlined Constant Word.down28 => "Word.down28".
Extract Inlined Constant Word.size => "Word.size".
Extract Inlined Constant Word.of_pos => "(fun p -> p)".
Extract Inlined Constant Word.to_pos => "Word.to_pos".
Extract Inlined Constant Word.index => "(Word.natural O (fun n -> S n))".
Extract Inlined Constant Word.fits => "Word.fits".
Extract Inlined Constant Word.shifted => "Word.shifted".
Extract Inlined Constant Word.upto => "Word.upto".
Extract Inlined Constant Word.all => "Word.all".
Extract Inlined Constant Word.count_of => "List.length".
Extract Inlined Constant Word.words => "Words.t".
Extract Inlined Constant Word.of_lists => "Words.of_lists".
Extract Inlined Constant Word.get => "Words.get".

Extract Inductive Z => "Big.t" [ "Big.zero" "Big.of_int" "(fun n -> Big.of_int (- n))" ]
  "(fun _ _ _ _ -> assert false)".
Extract Inlined Constant Z.add => "Big.add".
Extract Inlined Constant Z.sub => "Big.sub".
Extract Inlined Constant Z.mul => "Big.mul".
Extract Inlined Constant Z.opp => "Big.neg".
Extract Inlined Constant Z.leb => "Big.leq".
Extract Inlined Constant Z.ltb => "Big.lt".
Extract Inlined Constant Z.eqb => "Big.equal".

Extraction "extracted.ml" judge refute rule_of rule_name claim_name
  check_domain check_dangling check_complex check_alone check_some_unused refute_alone complex_rule_of rule_of_complex_name
    domain_claim_name refute_domain domain_rule_of domain_rule_name
  refute_whole whole_rule_of check_impossible wrap judge_hull judge_flat check_surface
  check_line refute_flat refute_hull refute_surface check_periodic refute_periodic
  periodic_rule_name hull_rule_name.
