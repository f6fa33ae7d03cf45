(* Certificates, as CERTIFICATE.md describes them, into the record that the proved checker reads. *)
open Extracted
open Reading

(* `T J` or `- H`. *)
let wall c expected = function
  | "-" :: rest ->
    let h, rest = take c number 1 expected rest in
    (OnHull (List.hd h), rest)
  | tokens ->
    let (t, j), rest = pair c expected number index tokens in
    (Neighbour (t, j), rest)

(* The certificate, and the labels of its points. *)
let read c claimed =
  let numerator, denominator = scale c in
  let expected = "the coordinates of a point, its simplex, its vertex there and a label" in
  let points = section c "points" expected (fun tokens ->
      let position, rest = site c expected c.weighted tokens in
      let (home, home_vertex), rest = pair c expected number (unless_dash index) rest in
      let label, rest = label c expected rest in
      (({ position; home; home_vertex }, label), rest)) in
  let expected = "the vertices of a simplex, what is across its facets, and a facet or '-'" in
  let simplices = section c "simplices" expected (fun tokens ->
      let corners, rest = take c number (c.d + 1) expected tokens in
      let walls, rest = times (c.d + 1) (wall c expected) rest in
      let away, rest = take c (unless_dash index) 1 expected rest in
      ({ corners; walls; away = List.hd away }, rest)) in
  let expected = "a simplex, a facet, and what is across the ridges" in
  let hull = section c "hull" expected (fun tokens ->
      let (carrier, apex), rest = pair c expected number index tokens in
      let ridges, rest = times c.d (pair c expected number index) rest in
      ({ carrier; apex; ridges }, rest)) in
  let expected, tokens = line c "sample" "SIMPLEX COORDINATES W" in
  let simplex, rest = take c number 1 expected tokens in
  let sample, rest = site c expected false rest in
  let sample_denominator, rest = take c integer 1 expected rest in
  no_more c expected rest;
  ending c;
  let labels = List.rev (List.rev_map snd points) in
  let points = List.rev (List.rev_map fst points) in
  ({ claimed; numerator; denominator; points; simplices; hull; sample_simplex = List.hd simplex;
     sample; sample_denominator = List.hd sample_denominator }, labels)
