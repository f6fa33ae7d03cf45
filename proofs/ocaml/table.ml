(* What checker/Table.v says of lists, with arrays: thing number k, counted from 1. *)
type 'a t = 'a option array

let of_list f l =
  let table = Array.make (List.length l) None in
  List.iteri (fun i a -> table.(i) <- Some (f a)) l;
  table

let find k table = if k >= 1 && k <= Array.length table then Array.unsafe_get table (k - 1) else None
