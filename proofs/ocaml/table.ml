(* What checker/Table.v says of lists, with arrays, and functions: thing number k, counted from 1. *)
type 'a t = { size : int; thing : int -> 'a option }

let of_list f l =
  let table = Array.make (List.length l) None in
  List.iteri (fun i a -> table.(i) <- Some (f a)) l;
  { size = Array.length table; thing = fun k -> Array.unsafe_get table (k - 1) }

let tabulate n f = { size = n; thing = fun k -> Some (f k) }

let once f = let made = lazy (f ()) in fun () -> Lazy.force made

let find k table = if k >= 1 && k <= table.size then table.thing k else None
