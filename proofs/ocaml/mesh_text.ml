(* The mesh that a file is about, for whoever wants to compare it with his own: points by label, with
   their coordinates (and weights) in the caller's unit; simplices by the labels of their vertices. *)
open Extracted

let point (p, q) weighted site label =
  let scaled power x =
    let unit_to n = Q.make (Big.pow p n) (Big.pow q n) in
    Q.to_string (Q.mul (Q.of_bigint x) (unit_to power)) in
  let weight = if weighted then [ scaled 2 site.weight ] else [] in
  Big.to_string label :: List.map (scaled 1) site.coordinates @ weight

(* `find` gives the label of a vertex; one that names no point has none. *)
let simplex labels vertices =
  List.rev (List.rev_map (fun v -> match v with
      | Some n when n >= 1 && n <= Array.length labels -> Big.to_string labels.(n - 1)
      | _ -> "?") vertices)

(* The simplices come last first. *)
let print unit weighted sites labels simplices =
  let line tokens = print_endline (String.concat " " tokens) in
  line [ "points"; string_of_int (List.length sites) ];
  List.iter2 (fun site label -> line (point unit weighted site label)) sites labels;
  line [ "simplices"; string_of_int (List.length simplices) ];
  let labels = Array.of_list labels in
  List.iter (fun vertices -> line (simplex labels vertices)) (List.rev simplices)
