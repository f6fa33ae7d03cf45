(* Certificates of a mesh alone, as CERTIFICATE.md describes them, into the record that the proved checker reads. *)
open Extracted
open Reading

let section = Certificate_file.section
let listed = Certificate_file.listed
let number c expected = named c (Text.read_count c.source expected)

(* `simplices COUNT K`: K vertices each, and the points that make d + 1 of them. *)
let simplices c =
  let header, tokens = line c "simplices" "COUNT VERTICES" in
  let counts, rest = take c count 2 header tokens in
  no_more c header rest;
  let n, width = match counts with [ n; width ] -> (n, width) | _ -> assert false in
  if width < 1 || width > c.d + 1 then
    Text.fail c.source (Printf.sprintf "simplices of 1 to %d vertices" (c.d + 1)) (string_of_int width);
  let expected = "the vertices of a simplex, its place, points beside it, and hyperplanes that part it from others" in
  let integer () = Text.read_integer c.source expected in
  let rec partings read =
    if Text.at_end_of_line c.source then List.rev read
    else
      let other = number c expected in
      let normal = listed c.d integer in
      partings ((other, (normal, integer ())) :: read) in
  let cells = ref [] in
  for _ = 1 to n do
    Text.start_line c.source expected;
    let cell_vertices = listed width (fun () -> number c expected) in
    let cell_place = number c expected in
    let pad () = { coordinates = listed c.d integer; weight = Big.zero } in
    let cell_pads = listed (c.d + 1 - width) pad in
    let cell_parted = partings [] in
    Text.end_line c.source expected;
    cells := { cell_vertices; cell_place; cell_pads; cell_parted } :: !cells
  done;
  (width - 1, List.rev !cells)

let read c =
  let complex_numerator, complex_denominator = scale c in
  let complex_points, labels = Certificate_file.points c in
  let dimension, complex_cells = simplices c in
  let expected = "the number of a simplex" in
  let complex_order = section c "order" expected (fun () -> number c expected) in
  ending c;
  ({ complex_numerator; complex_denominator; complex_points; complex_dimension = natural dimension; complex_cells;
     complex_order }, labels)
