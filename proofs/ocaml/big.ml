(* Integers: Zarith's, under a name that Coq's module Z does not hide in the extracted code. *)
include Z

let less (a : int) (b : int) = a < b
