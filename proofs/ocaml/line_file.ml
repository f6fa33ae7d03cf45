(* Certificates of points on a line, or of one point, as CERTIFICATE.md describes them, into the record that the proved checker
   reads. *)
open Extracted
open Reading

let section = Certificate_file.section
let listed = Certificate_file.listed

let read c =
  let line_numerator, line_denominator = scale c in
  let expected = "the coordinates of a point and a label" in
  let integer expected () = Text.read_integer c.source expected in
  let site expected = { coordinates = listed c.d (integer expected); weight = Big.zero } in
  let labels = ref [] in
  let line_sites = section c "points" expected (fun () ->
      let point = site expected in
      labels := Some (new_label c (integer expected ())) :: !labels;
      point) in
  let width = match line_sites with [ _ ] -> 1 | _ -> 2 in
  let number expected = Certificate_file.number c expected in
  let expected = "the numbers of the ends of an edge; of one point, its number" in
  let line_rows = section c "simplices" expected (fun () -> listed width (fun () -> number expected)) in
  let expected = "the number of a simplex" in
  let line_order = section c "order" expected (fun () -> number expected) in
  let expected = "coordinates" in
  let line_pads = section c "pads" expected (fun () -> site expected) in
  ending c;
  ({ line_numerator; line_denominator; line_sites; line_rows; line_order; line_pads }, List.rev !labels)
