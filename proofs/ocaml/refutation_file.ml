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

(* The refutation, and the labels of its points. *)
let read c refuted rule =
  let unit_numerator, unit_denominator = scale c in
  let expected = "the coordinates of a point and a label" in
  let sites = section c "points" expected (fun tokens ->
      let position, rest = site c expected c.weighted tokens in
      let label, rest = label c expected rest in
      ((position, label), rest)) in
  let labels = List.rev (List.rev_map snd sites) in
  let sites = List.rev (List.rev_map fst sites) in
  let rows = section c "simplices" "a simplex" (simplex c) in
  let expected, tokens = line c "spans" "POINTS" in
  let basis, rest = take c number (c.d + 1) expected tokens in
  no_more c expected rest;
  let _, tokens = line c "because" "EVIDENCE" in
  let because = evidence c refuted rule rows tokens in
  ending c;
  ({ refuted; unit_numerator; unit_denominator; sites; rows; basis; because }, labels)
