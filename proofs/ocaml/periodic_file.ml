(* Meshes that a lattice repeats, certificates and refutations, as CERTIFICATE.md describes them, into the records that the proved
   checker reads. *)
open Extracted
open Reading

let section = Certificate_file.section
let listed = Certificate_file.listed
let number = Certificate_file.number

let integers c expected = listed c.d (fun () -> Text.read_integer c.source expected)
let place c expected = natural (Certificate_file.place c expected)

(* All moves by integers within reach are tried, along two or three vectors. *)
let most_reached = 64

(* The vectors, what they reach, points and cells; after each point what [of_point] reads, and after each cell what [of_cell] reads. *)
let mesh c of_point of_cell =
  let periodic_numerator, periodic_denominator = scale c in
  let expected = "the coordinates of a vector" in
  let basis_rows = section c "lattice" expected (fun () -> integers c expected) in
  let dual_rows = section c "dual" expected (fun () -> integers c expected) in
  let expected, tokens = line c "factor" "F" in
  let factors, rest = take c integer 1 expected tokens in
  no_more c expected rest;
  let expected, tokens = line c "reach" "Z..." in
  if List.compare_length_with tokens most_reached > 0 then
    Text.fail c.source (Printf.sprintf "at most %d integers" most_reached) (string_of_int (List.length tokens));
  let reach, _ = take c integer (List.length tokens) expected tokens in
  let expected = "the coordinates of a point and a label; in a certificate also, before the label, a cell and its vertex" in
  let labels = ref [] in
  let periodic_sites = section c "points" expected (fun () ->
      let coordinates = integers c expected in
      of_point expected;
      labels := Some (new_label c (Text.read_integer c.source expected)) :: !labels;
      { coordinates; weight = Big.zero }) in
  let expected = "the corners of a cell, each a point and its offset; in a certificate also, of each facet, a cell, its vertex opposite and its offset" in
  let cells = section c "cells" expected (fun () ->
      let corners = listed (c.d + 1) (fun () ->
          let corner_point = number c expected in
          { corner_point; corner_offset = integers c expected }) in
      of_cell expected;
      corners) in
  ({ periodic_numerator; periodic_denominator; basis_rows; dual_rows; dual_factor = List.hd factors; reach;
     periodic_sites; cells }, List.rev !labels)

let read c =
  let homes = ref [] and links = ref [] in
  let of_point expected =
    let t = number c expected in
    homes := (t, place c expected) :: !homes in
  let of_cell expected =
    links := listed (c.d + 1) (fun () ->
        let next_cell = number c expected in
        let next_facet = place c expected in
        { next_cell; next_facet; next_offset = integers c expected }) :: !links in
  let periodic_mesh_of, labels = mesh c of_point of_cell in
  let expected, tokens = line c "sample" (if c.d = 2 then "T x y w" else "T x y z w") in
  let starts, rest = take c Reading.number 1 expected tokens in
  let periodic_sample, rest = site c expected false rest in
  let denominators, rest = take c integer 1 expected rest in
  no_more c expected rest;
  ending c;
  ({ periodic_mesh_of; homes = List.rev !homes; cell_links = List.rev !links; periodic_start = List.hd starts;
     periodic_sample; periodic_sample_denominator = List.hd denominators }, labels)

let read_refutation c rule =
  let periodic_against, labels = mesh c ignore ignore in
  let expected, tokens = line c "because" ("and what CERTIFICATE.md asks for as evidence of " ^ rule) in
  let one read tokens = let values, rest = take c read 1 expected tokens in (List.hd values, rest) in
  let number = one Reading.number in
  let offset = take c integer c.d expected in
  let periodic_because, rest = match rule with
    | "simplex.degenerate" -> let t, rest = number tokens in (CellFlat t, rest)
    | "complex.duplicate-simplex" ->
      let t, rest = number tokens in
      let u, rest = number rest in
      let o, rest = offset rest in (CellRepeated (t, u, o), rest)
    | "complex.not-closed" ->
      let t, rest = number tokens in
      let i, rest = one position rest in (FacetOpen (t, i), rest)
    | "triangulation.covered-twice" ->
      let t, rest = number tokens in
      let u, rest = number rest in
      let o, rest = offset rest in
      let q, rest = site c expected false rest in
      let w, rest = one integer rest in (CellsOverlap (t, u, o, q, w), rest)
    | "triangulation.unused-point" -> let p, rest = number tokens in (PointLeftOut p, rest)
    | "delaunay.vertex-in-ball" ->
      let t, rest = number tokens in
      let p, rest = number rest in
      let o, rest = offset rest in (BallNotEmpty (t, p, o), rest)
    | _ -> Text.fail c.source "a rule that a refutation of periodic-delaunay shows" (Text.quote rule) in
  no_more c expected rest;
  ending c;
  ({ periodic_against; periodic_because }, labels)

(* The vectors, as `circumspect check --lattice` takes them: no file of the user has them. *)
let vectors m =
  let scaled x = Q.to_string (Q.make (Big.mul m.periodic_numerator x) m.periodic_denominator) in
  String.concat "," (List.map scaled (List.concat m.basis_rows))

(* Offsets are attributes in the user's file. *)
let users_mesh d labels m =
  let cells = Array.of_list m.cells in
  let vertices k = List.map (fun corner -> Some corner.corner_point) cells.(k) in
  let offsets k = List.concat_map (fun corner -> corner.corner_offset) cells.(k) in
  { Users_mesh.unit = (m.periodic_numerator, m.periodic_denominator); d; weighted = false;
    labels = Array.of_list labels; ordered = true; sites = Array.of_list m.periodic_sites;
    simplices = { count = Array.length cells; vertices; attributes = Some offsets }; dangling = None; cyclic = false }
