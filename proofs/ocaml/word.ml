(* What checker/Word.v says of words, with OCaml's integers: they have 63 bits here, or nothing begins. *)
let () = assert (Sys.int_size = 63)

let less (x : int) (y : int) = x < y [@@inline]
let at_most (x : int) (y : int) = x <= y [@@inline]
let equal (x : int) (y : int) = x = y [@@inline]

let up x k = if k >= 0 && k <= 62 then x lsl k else 0 [@@inline]
let down x k = if k >= 0 && k <= 62 then x asr k else 0 [@@inline]

let down26 x = x asr 26 [@@inline]
let down28 x = x asr 28 [@@inline]

let size x =
  let rec go x n =
    if x >= 65536 then go (x lsr 16) (n + 16) else if x >= 256 then go (x lsr 8) (n + 8)
    else if x >= 16 then go (x lsr 4) (n + 4) else if x > 0 then go (x lsr 1) (n + 1) else n in
  if x <= 0 then 0 else go x 0

let to_pos x = if x < 1 then 1 else x [@@inline]

(* Peano's numerals, which count the vertices of a simplex: short, and shared. *)
let natural zero next n =
  let rec go n made = if n <= 0 then made else go (n - 1) (next made) in
  go n zero

let most = 1 lsl 58
let fits s z =
  s >= 0 && s <= 1 lsl 20 &&
  let z = if s = 0 then z else Z.shift_right z s in
  Z.fits_int z && (let x = Z.to_int z in x >= - most && x < most)
let shifted s z = if fits s z then Z.to_int (if s = 0 then z else Z.shift_right z s) else 0

let upto n =
  let rec go k numbers = if k < 1 then numbers else go (k - 1) (k :: numbers) in
  go n []
let all n f =
  let rec go k = k > n || (f k && go (k + 1)) in
  go 1
