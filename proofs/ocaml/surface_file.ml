(* Certificates of surfaces, as CERTIFICATE.md describes them, into the record that the proved checker reads. *)
open Extracted
open Reading

let section = Certificate_file.section
let listed = Certificate_file.listed

(* The points: where they are, and labels. *)
let points c =
  let expected = "the coordinates of a point and a label" in
  let integer () = Text.read_integer c.source expected in
  let labels = ref [] in
  let points = section c "points" expected (fun () ->
      let coordinates = listed c.d integer in
      labels := Some (new_label c (integer ())) :: !labels;
      { position = { coordinates; weight = Big.zero }; home = 1; home_vertex = None }) in
  (points, List.rev !labels)

let read c =
  let surface_numerator, surface_denominator = scale c in
  let surface_points, labels = points c in
  let expected = "the vertices of a triangle, and the numbers of its edges" in
  let number expected = Certificate_file.number c expected in
  let surface_triangles = section c "triangles" expected (fun () ->
      let triangle_vertices = listed 3 (fun () -> number expected) in
      { triangle_vertices; triangle_edges = listed 3 (fun () -> number expected) }) in
  let expected = "a triangle and one of its vertices" in
  let surface_edges = section c "edges" expected (fun () ->
      let t = number expected in
      (t, Certificate_file.naturals.(min (Text.read_count c.source expected) 3))) in
  ending c;
  ({ surface_numerator; surface_denominator; surface_points; surface_triangles; surface_edges }, labels)
