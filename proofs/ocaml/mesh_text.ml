(* The mesh that a file is about, as the JSON that `circumspect compare` reads: points in the caller's
   unit, and simplices by their vertices.  Points stand in the order of their labels. *)
open Extracted

let quoted x = "\"" ^ x ^ "\""
let listed items = "[" ^ String.concat ", " items ^ "]"
let print_each count item =
  for i = 0 to count - 1 do print_string (if i = 0 then "\n" else ",\n"); print_string (item i) done
let print_lines items = let items = Array.of_list items in print_each (Array.length items) (Array.get items)

(* Prints all lines but the last, and returns that.  Where labels are those of consecutive numbers, vertices have them too; else they count from 1. *)
let print (mesh : Users_mesh.mesh) =
  let p, q = mesh.unit in
  let unit_to n = Q.make (Big.pow p n) (Big.pow q n) in
  let scaled power =
    let factor = unit_to power in
    fun x -> quoted (Q.to_string (Q.mul (Q.of_bigint x) factor)) in
  let label k = Option.get mesh.labels.(k) in
  let own = List.filter (fun k -> mesh.labels.(k) <> None) (List.init (Array.length mesh.sites) Fun.id) in
  let order = Array.of_list own in
  let n = Array.length order in
  Array.sort (fun k l -> Big.compare (label k) (label l)) order;
  let place = Array.make (Array.length mesh.sites) 0 in
  Array.iteri (fun i k -> place.(k) <- i) order;
  let first = if n = 0 then Big.one else label order.(0) in
  let consecutive = Big.fits_int first && n > 0 &&
    Big.equal (label order.(n - 1)) (Big.add first (Big.of_int (n - 1))) in
  let first = if consecutive then Big.to_int first else 1 in
  let sites = List.map (fun k -> mesh.sites.(k)) (Array.to_list order) in
  Printf.printf "{\"circumspect\": 1, \"dimension\": %d, \"first_index\": %d,\n\"points\": ["
    mesh.d first;
  print_lines (List.rev (List.rev_map (fun site ->
      listed (List.map (scaled 1) site.coordinates)) sites));
  if mesh.weighted then begin
    print_string "],\n\"weights\": [";
    print_lines (List.rev (List.rev_map (fun site -> scaled 2 site.weight) sites))
  end;
  print_string "],\n\"simplices\": [";
  let vertex = function
    | Some v when v >= 1 && v <= Array.length place -> string_of_int (first + place.(v - 1))
    | _ -> string_of_int (first + n) in
  print_each mesh.simplices.count (fun k -> listed (List.rev (List.rev_map vertex (mesh.simplices.vertices k))));
  (match mesh.dangling with
   | Some (_ :: _ as dangling) ->
     print_string "],\n\"faces\": [";
     print_lines (List.rev (List.rev_map (fun row -> listed (List.map vertex row)) dangling))
   | Some [] | None -> ());
  "]}"
