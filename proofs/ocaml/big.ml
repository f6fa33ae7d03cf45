(* Integers: Zarith's, under a name that Coq's module Z does not hide in the extracted code. *)
include Z

(* Coq writes an integer constant as a sign and a binary numeral; the checker contains 0 and 1. *)
type numeral = XI of numeral | XO of numeral | XH

let rec of_numeral = function
  | XH -> one
  | XO n -> shift_left (of_numeral n) 1
  | XI n -> succ (shift_left (of_numeral n) 1)
