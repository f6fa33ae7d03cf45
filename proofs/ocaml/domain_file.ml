(* Certificates about domains, as CERTIFICATE.md describes them, into the record that the proved checker
   reads. *)
open Extracted
open Reading

let one read tokens = match read tokens with
  | [ value ], rest -> (value, rest)
  | _ -> assert false
let number c expected = one (take c number 1 expected)
let integer c expected = one (take c integer 1 expected)
(* Vertices and facets: greater numbers than d name nothing. *)
let place c expected tokens =
  let values, rest = take c count 1 expected tokens in
  (natural (min (List.hd values) (c.d + 1)), rest)

(* As many things as the line holds. *)
let rec all read tokens =
  if tokens = [] then [] else let value, rest = read tokens in value :: all read rest

let pair first second tokens =
  let a, rest = first tokens in
  let b, rest = second rest in
  ((a, b), rest)

let role c =
  let expected = "a simplex, or '-' and integers with points" in
  section c "roles" expected (function
      | "-" :: tokens -> (Steiner (all (pair (integer c expected) (number c expected)) tokens), [])
      | tokens -> let t, rest = number c expected tokens in (Corner t, rest))

let segment c =
  let expected = "a point, then points, each with a simplex and a facet" in
  section c "segments" expected (fun tokens ->
      let from, rest = number c expected tokens in
      let link tokens =
        let reached, rest = number c expected tokens in
        let (link_simplex, link_facet), rest =
          pair (number c expected) (place c expected) rest in
        ({ reached; link_simplex; link_facet }, rest) in
      ({ from; links = all link rest }, []))

let hole c =
  let expected = "a simplex, coordinates and a denominator" in
  section c "holes" expected (fun tokens ->
      let hole_simplex, rest = number c expected tokens in
      let hole_point, rest = site c expected false rest in
      let hole_w, rest = integer c expected rest in
      ({ hole_point; hole_w; hole_simplex }, rest))

let mark c =
  let expected = "'+' or '-', what the facets are part of, and after '-' a way out and a rank" in
  let flag = function
    | "-" :: rest -> (None, rest)
    | tokens -> let w, rest = pair (number c expected) (number c expected) tokens in (Some w, rest) in
  let rec flags n tokens =
    if n = 0 then ([], tokens)
    else
      let one, rest = flag tokens in
      let others, rest = flags (n - 1) rest in
      (one :: others, rest) in
  section c "marks" expected (function
      | "+" :: tokens ->
        let flags, rest = flags (c.d + 1) tokens in
        ({ kept = true; flags; way_out = OutOfHull O; rank = 1 }, rest)
      | "-" :: tokens ->
        let flags, rest = flags (c.d + 1) tokens in
        let way_out, rest = match rest with
          | "hole" :: rest -> let h, rest = number c expected rest in (InHole h, rest)
          | "out" :: rest -> let i, rest = place c expected rest in (OutOfHull i, rest)
          | "across" :: rest -> let i, rest = place c expected rest in (Across i, rest)
          | token :: _ -> Text.fail c.source "hole, out or across" (Text.quote token)
          | [] -> Text.fail c.source "hole, out or across" "the end of the line" in
        let rank, rest = take c count 1 expected rest in
        ({ kept = false; flags; way_out; rank = max 1 (List.hd rank) }, rest)
      | token :: _ -> Text.fail c.source "'+' or '-'" (Text.quote token)
      | [] -> assert false)

let part c =
  let roles = role c in
  let segments = segment c in
  let holes = hole c in
  { roles; segments; holes; marks = mark c }

let polygon c =
  let expected, tokens = line c "polygon" "A B C OFFSET AXIS" in
  let normal, rest = take c Reading.integer 3 expected tokens in
  let offset, rest = integer c expected rest in
  let axis, rest = place c expected rest in
  no_more c expected rest;
  let plane = { c with d = 2; labels = no_labels_of_part () } in
  let plane_mesh, _ = Certificate_file.body plane Triangulation in
  let plane_mesh = Certificate_file.in_lists Plane plane_mesh in
  let plane_part = part plane in
  let expected = "the number of a point" in
  let above = section c "above" expected (number c expected) in
  let expected = "a simplex and a facet, or '-'" in
  let tiles = section c "tiles" expected (function
      | "-" :: rest -> ((named c max_int, O), rest)
      | tokens -> pair (number c expected) (place c expected) tokens) in
  let expected = "coordinates and a denominator" in
  let seeds = section c "seeds" expected (pair (site c expected false) (integer c expected)) in
  { normal; offset; axis; plane_mesh; plane_part; above; tiles; seeds }

(* What shows that the domain is a piecewise linear complex; [polygons] of them in space. *)
let complex c polygons =
  let expected = "'-', or faces: segment or polygon, its number, and how many other vertices, and which" in
  let face tokens =
    let held = function
      | "segment" :: rest -> let k, rest = number c expected rest in (InSegment k, rest)
      | "polygon" :: rest -> let k, rest = number c expected rest in (InPolygon k, rest)
      | token :: _ -> Text.fail c.source "segment or polygon" (Text.quote token)
      | [] -> assert false in
    let face_holder, rest = held tokens in
    let counts, rest = take c count 1 expected rest in
    let others, rest = take c Reading.number (List.hd counts) expected rest in
    ({ others; face_holder }, rest) in
  let faces = section c "faces" expected (function
      | [ "-" ] -> ([], [])
      | tokens -> (all face tokens, [])) in
  let expected = "one or both" in
  let side = function
    | "one" :: rest -> (true, rest)
    | "both" :: rest -> (false, rest)
    | token :: _ -> Text.fail c.source expected (Text.quote token)
    | [] -> Text.fail c.source expected "the end of the line" in
  let one_sided = section c "sides" expected side in
  let polygon () =
    let expected = "the number of a segment, and one or both" in
    let rim_segments = section c "rim" expected (pair (number c expected) side) in
    let expected = "the number of a segment, and pieces of the polygon" in
    let segments_in = section c "inside" expected (fun tokens ->
        let k, rest = number c expected tokens in ((k, all (number c expected) rest), [])) in
    { rim_segments; segments_in } in
  let rec several n = if n = 0 then [] else let f = polygon () in f :: several (n - 1) in
  { faces; one_sided; polygon_parts = several polygons }

(* The mesh of a whole hull, and how the domain lies in it; and the labels of its points. *)
let body ?(is_delaunay = false) c domain_claimed kind =
  let claimed = if is_delaunay || domain_claimed = ConformingDelaunay then Delaunay else Triangulation in
  let packed, labels = Certificate_file.body ~some_are_nobodys:true c claimed in
  let whole_mesh = Certificate_file.in_lists (if c.d = 2 then Plane else Space) packed in
  let domain_part = part c in
  let polygons = if c.d = 2 then [] else begin
      let expected, tokens = line c "polygons" "COUNT" in
      let counts, rest = take c count 1 expected tokens in
      no_more c expected rest;
      let rec several n = if n = 0 then [] else let f = polygon c in f :: several (n - 1) in
      several (List.hd counts)
    end in
  ({ domain_claimed; kind; whole_mesh; domain_part; polygons }, labels)

(* The certificate, and the labels of its points; and what shows that the domain is a complex, if it says so. *)
let read c domain_claimed kind ~is_complex ~is_delaunay =
  let certificate, labels = body ~is_delaunay c domain_claimed kind in
  let complex = if is_complex then Some (complex c (List.length certificate.polygons)) else None in
  ending c;
  (certificate, complex, labels)

(* A domain with a mesh that is not the caller's: all that is claimed is that it is one of the domain. *)
let with_another_mesh c domain_claimed kind =
  let certificate, _ = body { c with labels = no_labels_of_part () } SteinerTriangulation kind in
  { certificate with domain_claimed }

(* A vertex; a point on a segment; or one in a piece of a polygon. *)
let domain_point c expected = function
  | "vertex" :: rest -> let k, rest = number c expected rest in (AtCorner k, rest)
  | "segment" :: rest ->
    let k, rest = number c expected rest in
    let q, rest = site c expected false rest in
    let w, rest = integer c expected rest in
    (AlongSegment (k, q, w), rest)
  | "piece" :: rest ->
    let (k, u), rest = pair (number c expected) (number c expected) rest in
    let q, rest = site c expected false rest in
    let w, rest = integer c expected rest in
    (InPiece (k, u, q, w), rest)
  | token :: _ -> Text.fail c.source expected (Text.quote token)
  | [] -> Text.fail c.source expected "the end of the line"

(* A domain without a mesh: the certificate has no simplices. *)
let alone c domain_claimed kind (numerator, denominator) =
  let expected = "the coordinates of a vertex" in
  let sites = section c "vertices" expected (site c expected false) in
  let expected = "two vertices" in
  let ends = section c "segments" expected (pair (number c expected) (number c expected)) in
  let expected = "coordinates and a denominator" in
  let holes = section c "holes" expected (fun tokens ->
      let hole_point, rest = site c expected false tokens in
      let hole_w, rest = integer c expected rest in
      ({ hole_point; hole_w; hole_simplex = 1 }, rest)) in
  let header, tokens = line c "polygons" "COUNT" in
  let counts, rest = take c count 1 header tokens in
  no_more c header rest;
  let rec several n found = if n = 0 then List.rev found else several (n - 1) (polygon c :: found) in
  let polygons = several (List.hd counts) [] in
  let nowhere = { coordinates = []; weight = Big.zero } in
  let whole_mesh =
    { claimed = Triangulation; numerator; denominator;
      points = List.map (fun position -> { position; home = 1; home_vertex = None }) sites;
      simplices = []; hull = []; sample_simplex = 1; sample = nowhere; sample_denominator = Big.of_int 1 } in
  let segments = List.map (fun (from, reached) ->
      { from; links = [ { reached; link_simplex = 1; link_facet = O } ] }) ends in
  let domain_part = { roles = List.map (fun _ -> Corner 1) sites; segments; holes; marks = [] } in
  { domain_claimed; kind; whole_mesh; domain_part; polygons }
