(* Refutations, as CERTIFICATE.md describes them, into the record that the proved checker reads. *)
open Extracted
open Reading

(* A vertex as its author wrote it: an integer, which names a point or does not. *)
let vertex c token =
  let v = integer c token in
  if Big.sign v <= 0 then None
  else Some (named c (if Big.fits_int v then Big.to_int v else max_int))

let simplex c tokens =
  let expected = "the number of vertices of a simplex and these vertices" in
  let sizes, rest = take c count 1 expected tokens in
  take c vertex (List.hd sizes) expected rest

(* Reads what follows `because`, by rule; which rule is then printed is the evidence's business. *)
let evidence c claimed rule simplices tokens =
  let expected = "what CERTIFICATE.md asks for as evidence of " ^ rule in
  let one read tokens =
    let values, rest = take c read 1 expected tokens in (List.hd values, rest) in
  let number = one number and position = one position and integer = one integer in
  let entry tokens =
    let t, rest = number tokens in
    let i, rest = position rest in
    ((t, i), rest) in
  let point tokens =
    let q, rest = site c expected false tokens in
    let w, rest = integer rest in
    ((q, w), rest) in
  let two_simplices tokens =
    let t, rest = number tokens in
    let u, rest = number rest in
    let (q, w), rest = point rest in
    ((t, u, q, w), rest) in
  let three_facets tokens =
    let (t, i), rest = entry tokens in
    let (u, j), rest = entry rest in
    let (v, k), rest = entry rest in
    ((t, i, u, j, v, k), rest) in
  let found, rest = match rule with
    | "simplex.wrong-dimension" ->
      let t, rest = number tokens in (WrongDimension t, rest)
    | "triangulation.unknown-vertex" ->
      let (t, i), rest = entry tokens in (UnknownVertex (t, i), rest)
    | "simplex.repeated-vertex" ->
      let (t, i), rest = entry tokens in
      let j, rest = position rest in (RepeatedVertex (t, i, j), rest)
    | "simplex.degenerate" ->
      let t, rest = number tokens in (Degenerate t, rest)
    | "complex.duplicate-simplex" ->
      let t, rest = number tokens in
      let u, rest = number rest in (DuplicateSimplex (t, u), rest)
    | "complex.facet-overused" ->
      let facets, rest = three_facets tokens in let t, i, u, j, v, k = facets in
      (FacetOverused (t, i, u, j, v, k), rest)
    | "complex.overlap" ->
      let (t, u, q, w), rest = two_simplices tokens in (Overlap (t, u, q, w), rest)
    | "triangulation.covered-twice" ->
      let (t, u, q, w), rest = two_simplices tokens in (CoveredTwice (t, u, q, w), rest)
    | "triangulation.unused-point" when claimed = WeightedDelaunay ->
      let p, rest = number tokens in
      let facets, rest = take c Reading.position (List.length simplices) expected rest in
      (UncoveredPoint (p, facets), rest)
    | "triangulation.unused-point" ->
      let p, rest = number tokens in (UnusedPoint p, rest)
    | "triangulation.hull-not-convex" ->
      let (t, i), rest = entry tokens in
      let p, rest = number rest in (HullNotConvex (t, i, p), rest)
    | "triangulation.hull-not-closed" ->
      let facets, rest = three_facets tokens in let t, i, u, j, v, k = facets in
      (HullNotClosed (t, i, u, j, v, k), rest)
    | "delaunay.vertex-in-ball" ->
      let t, rest = number tokens in
      let p, rest = number rest in (VertexInBall (t, p), rest)
    | "delaunay.facet-not-local" ->
      let (t, i), rest = entry tokens in
      let (u, j), rest = entry rest in (FacetNotLocal (t, i, u, j), rest)
    | "weighted.point-below-plane" ->
      let t, rest = number tokens in
      let p, rest = number rest in (PointBelowPlane (t, p), rest)
    | "weighted.vertex-submerged" ->
      let (t, i), rest = entry tokens in
      let corners, rest = take c Reading.number (c.d + 1) expected rest in
      (VertexSubmerged (t, i, corners), rest)
    | _ -> Text.fail c.source "a rule of CERTIFICATE.md" (Text.quote rule) in
  no_more c expected rest;
  found

(* The mesh, and the labels of its points; what it spans and [because] are not yet read. *)
let points_and_simplices c refuted =
  let unit_numerator, unit_denominator = scale c in
  let expected = "the coordinates of a point and a label" in
  let sites = section c "points" expected (fun tokens ->
      let position, rest = site c expected c.weighted tokens in
      let label, rest = label c expected rest in
      ((position, label), rest)) in
  let labels = List.rev (List.rev_map (fun (_, label) -> Some label) sites) in
  let sites = List.rev (List.rev_map fst sites) in
  let rows = section c "simplices" "a simplex" (simplex c) in
  let nothing = WrongDimension (named c max_int) in
  ({ refuted; unit_numerator; unit_denominator; sites; rows; basis = []; because = nothing }, labels)

(* The same with what it spans. *)
let mesh c refuted =
  let mesh, labels = points_and_simplices c refuted in
  let expected, tokens = line c "spans" "POINTS" in
  let basis, rest = take c number (c.d + 1) expected tokens in
  no_more c expected rest;
  ({ mesh with basis }, labels)

(* What may dangle, if there is such a section: points of no mesh, and triangles and edges, each with some of these
   points.  Its rows name points of the mesh, as those of simplices do. *)
let dangling c (mesh : refutation) =
  if not (Text.is_next c.Reading.source "pads") then { pads = []; dangling = [] }
  else begin
    let pads = section c "pads" "coordinates" (site c "coordinates" false) in
    let expected = "1 to " ^ string_of_int c.d ^ " vertices, and points that make them a simplex" in
    let points = List.length mesh.sites in
    let dangling = section c "dangling" expected (fun tokens ->
        let sizes, rest = take c count 1 expected tokens in
        let size = List.hd sizes in
        if size < 1 || size > c.d then Text.fail c.source expected (Text.quote (string_of_int size));
        let own, rest = take c vertex size expected rest in
        List.iter (function
            | Some k when k > points -> Text.fail c.source "a point of the mesh" (string_of_int k)
            | _ -> ()) own;
        let added, rest = take c vertex (c.d + 1 - size) expected rest in
        ((own, added), rest)) in
    { pads; dangling }
  end

(* The refutation, and the labels of its points. *)
let read c refuted rule =
  let mesh, labels = mesh c refuted in
  let _, tokens = line c "because" "EVIDENCE" in
  let because = evidence c refuted rule mesh.rows tokens in
  ending c;
  ({ mesh with because }, labels)

(* The same of points that do not span: some of them span what all do, and the pads add what is lacking. *)
let read_flat c refuted rule =
  let mesh, labels = points_and_simplices c refuted in
  let expected, tokens = line c "spans" "POINTS" in
  let lower = List.length tokens in
  if lower < 1 || lower > c.d then
    Text.fail c.source (Printf.sprintf "1 to %d points" c.d) (string_of_int lower);
  let basis, _ = take c number lower expected tokens in
  let flat_pads = section c "pads" "coordinates" (site c "coordinates" false) in
  let expected, tokens = line c "because" "EVIDENCE" in
  let because, ball_own, ball_other, rest = match rule with
    | "delaunay.vertex-in-ball" ->
      let numbers, rest = take c number 2 expected tokens in
      let ball_own, rest = take c integer lower expected rest in
      let ball_other, rest = take c integer 1 expected rest in
      (VertexInBall (List.hd numbers, List.nth numbers 1), ball_own, List.hd ball_other, rest)
    | "simplex.wrong-dimension" | "triangulation.unused-point" | "triangulation.hull-not-convex" ->
      (evidence c refuted rule mesh.rows tokens, [], Big.zero, [])
    | _ -> Text.fail c.source "a rule of CERTIFICATE.md for points that do not span" (Text.quote rule) in
  no_more c expected rest;
  ending c;
  ({ flat_mesh = { mesh with basis; because }; flat_pads; ball_own; ball_other }, labels)

(* The same of a convex hull: a facet and two points; or points that make a simplex, and a point of a facet of it. *)
let read_hull c rule =
  let hull_mesh, labels = points_and_simplices c Triangulation in
  let expected, tokens = line c "because" "EVIDENCE" in
  let hull_because, rest = match rule with
    | "hull.facet-not-supporting" ->
      let numbers, rest = take c number 3 expected tokens in
      (OnBothSides (List.nth numbers 0, List.nth numbers 1, List.nth numbers 2), rest)
    | "hull.uncovered" ->
      let corners, rest = take c number (c.d + 1) expected tokens in
      let q, rest = site c expected false rest in
      let w, rest = take c integer 1 expected rest in
      (InNoFacet (corners, q, List.hd w), rest)
    | _ -> Text.fail c.source "a rule of CERTIFICATE.md for convex hulls" (Text.quote rule) in
  no_more c expected rest;
  ending c;
  ({ hull_mesh; hull_because }, labels)

(* The same of a surface: two triangles and their vertices opposite the edge. *)
let read_surface c =
  let surface_mesh, labels = points_and_simplices c Triangulation in
  let expected, tokens = line c "because" "T I U J" in
  let side tokens =
    let t, rest = take c number 1 expected tokens in
    let i, rest = take c position 1 expected rest in
    ((List.hd t, List.hd i), rest) in
  let one_side, rest = side tokens in
  let other_side, rest = side rest in
  no_more c expected rest;
  ending c;
  ({ surface_mesh; one_side; other_side }, labels)

(* The same of a mesh alone. *)
let read_alone c rule =
  let mesh, labels = mesh c Triangulation in
  let expected, tokens = line c "because" "EVIDENCE" in
  let in_both () = match evidence c Triangulation "complex.overlap" mesh.rows tokens with
    | Overlap (t, u, q, w) -> (t, u, q, w)
    | _ -> assert false in
  let mesh_alone, against = match rule with
    | "complex.hanging-vertex" -> let t, u, q, w = in_both () in (mesh, Hanging (t, u, q, w))
    | "complex.faces-cross" -> let t, u, q, w = in_both () in (mesh, Crossing (t, u, q, w))
    | "complex.points-equal" ->
      (match take c number 2 expected tokens with
       | [ p; q ], rest -> no_more c expected rest; (mesh, EqualPoints (p, q))
       | _ -> assert false)
    | _ -> ({ mesh with because = evidence c Triangulation rule mesh.rows tokens }, AsOfPoints) in
  ending c;
  ({ mesh_alone; against }, labels)

(* The same of a claim about a domain. *)
let read_domain c domain_refuted rule =
  let mesh, labels = mesh c Delaunay in
  let dangling_refuted = dangling c mesh in
  let expected = "the coordinates of a vertex" in
  let vertices_given = section c "vertices" expected (site c expected false) in
  let expected = "two vertices" in
  let segments_given = section c "segments" expected (fun tokens ->
      match take c number 2 expected tokens with
      | [ j; k ], rest -> ((j, k), rest)
      | _ -> assert false) in
  let expected, tokens = line c "because" "EVIDENCE" in
  let number tokens = match take c number 1 expected tokens with
    | [ n ], rest -> (n, rest)
    | _ -> assert false in
  let integer tokens = match take c integer 1 expected tokens with
    | [ n ], rest -> (n, rest)
    | _ -> assert false in
  let position tokens = match take c position 1 expected tokens with
    | [ n ], rest -> (n, rest)
    | _ -> assert false in
  let (domain_because, because), rest = match rule with
    | "domain.vertex-missing" ->
      let v, rest = number tokens in ((VertexMissing v, mesh.because), rest)
    | "domain.steiner-forbidden" ->
      let t, rest = number tokens in
      let i, rest = position rest in ((SteinerForbidden (t, i), mesh.because), rest)
    | "domain.segment-missing" ->
      let k, rest = number tokens in
      let q, rest = site c expected false rest in
      let w, rest = integer rest in ((SegmentMissing (k, q, w), mesh.because), rest)
    | "domain.vertex-in-edge" ->
      let t, rest = number tokens in
      let i, rest = position rest in
      let u, rest = number rest in
      let j, rest = position rest in
      let k, rest = position rest in
      let s, rest = number rest in ((VertexInEdge (t, i, u, j, k, s), mesh.because), rest)
    | "delaunay.no-empty-ball" ->
      let u, rest = number tokens in
      let counts, rest = take c count 1 expected rest in
      let own, rest = take c Reading.integer (List.hd counts) expected rest in
      let rec pairs found = function
        | [] -> List.rev found
        | tokens ->
          let k, rest = number tokens in
          let z, rest = integer rest in pairs ((k, z) :: found) rest in
      ((NoEmptyBall (u, own, pairs [] rest), mesh.because), [])
    | _ -> ((OfMesh, evidence c Delaunay rule mesh.rows tokens), []) in
  no_more c expected rest;
  ending c;
  ({ domain_refuted; mesh_refuted = { mesh with because }; dangling_refuted; vertices_given; segments_given; domain_because },
   labels)

(* The same of a claim about a domain that is wholly in the file, of this kind. *)
let read_whole c claimed rule kind =
  let mesh_against, labels = mesh c Delaunay in
  let dangling_against = dangling c mesh_against in
  let about_domain =
    if rule = "domain.uncovered-inside" then Domain_file.with_another_mesh c claimed kind
    else Domain_file.alone c claimed kind (mesh_against.unit_numerator, mesh_against.unit_denominator) in
  let expected = "what CERTIFICATE.md asks for as evidence of " ^ rule in
  let number = Domain_file.number c expected and integer = Domain_file.integer c expected in
  let place = Domain_file.place c expected and pair = Domain_file.pair in
  let point tokens = pair (site c expected false) integer tokens in
  let plane tokens =
    let normal, rest = take c Reading.integer c.d expected tokens in
    let offset, rest = integer rest in
    ((normal, offset), rest) in
  let leg tokens =
    let (leg_end, leg_w), rest = point tokens in
    let counts, rest = take c count 1 expected rest in
    let rec planes n found tokens =
      if n = 0 then (List.rev found, tokens)
      else let one, rest = plane tokens in planes (n - 1) (one :: found) rest in
    let leg_planes, rest = planes (List.hd counts) [] rest in
    ({ leg_end; leg_w; leg_planes }, rest) in
  let _, tokens = line c "because" "EVIDENCE" in
  let shown_by, rest = match rule with
    | "cdt.facet-not-local" ->
      let (t, i), rest = pair number place tokens in
      let (u, j), rest = pair number place rest in
      let (q, w), rest = point rest in
      (FacetInNoWall (t, i, u, j, q, w), rest)
    | "cdt.visible-vertex-in-ball" ->
      let (t, v), rest = pair number number tokens in
      let (q, w), rest = point rest in
      (BallSeen (t, v, q, w, Domain_file.all plane rest), [])
    | "domain.polygon-not-tiled" ->
      let (k, u), rest = pair number number tokens in
      let (q, w), rest = point rest in
      (NotTiled (k, u, q, w), rest)
    | "domain.uncovered" -> let x, rest = Domain_file.domain_point c expected tokens in (NotCovered x, rest)
    | "domain.outside" ->
      let (t, (q, w)), rest = pair number point tokens in
      let counts, rest = take c count 1 expected rest in
      let rec legs n found tokens =
        if n = 0 then (List.rev found, tokens)
        else let one, rest = leg tokens in legs (n - 1) (one :: found) rest in
      let legs, rest = legs (List.hd counts) [] rest in
      (match rest with
       | "hole" :: rest -> let h, rest = number rest in (Strays (t, q, w, legs, IntoHole h), rest)
       | "beyond" :: rest -> let (n, o), rest = plane rest in (Strays (t, q, w, legs, Beyond (n, o)), rest)
       | token :: _ -> Text.fail c.source expected (Text.quote token)
       | [] -> Text.fail c.source expected "the end of the line")
    | "domain.uncovered-or-outside" ->
      let (t, (q, w)), rest = pair number point tokens in
      let l, rest = leg rest in
      (Gap (t, q, w, l), rest)
    | "domain.uncovered-inside" ->
      let t, rest = number tokens in
      let (q, w), rest = point rest in
      (CoveredElsewhere (t, q, w), rest)
    | "cdt.dangling-not-delaunay" ->
      let (u, v), rest = pair number number tokens in
      let own, rest = take c Reading.integer 3 expected rest in
      let other, rest = integer rest in
      let (k, (q, w)), rest = pair number point rest in
      let counts, rest = take c count 1 expected rest in
      let rec bends n found tokens =
        if n = 0 then (List.rev found, tokens)
        else let one, rest = pair number point tokens in bends (n - 1) (one :: found) rest in
      let bends, rest = bends (List.hd counts) [] rest in
      let last, rest = number rest in
      (DanglingSees (u, v, own, other, k, q, w, bends, last, Domain_file.all plane rest), [])
    | "triangulation.hull-not-convex" | "triangulation.hull-not-closed" ->
      (OfHull (evidence c Delaunay rule mesh_against.rows tokens), [])
    | _ -> Text.fail c.source "a rule of CERTIFICATE.md that speaks of the whole domain" (Text.quote rule) in
  no_more c expected rest;
  ending c;
  ({ mesh_against; dangling_against; about_domain; shown_by }, labels)
