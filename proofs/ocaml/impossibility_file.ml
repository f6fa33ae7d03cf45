(* What shows that a domain in space has no triangulation, or no CDT, as CERTIFICATE.md describes it, into the record that the
   proved checker reads: the domain is that of a certificate without simplices. *)
open Extracted
open Reading
open Domain_file

let fate c =
  let expected = "flat, free, or what pierces the candidate: vertex, segment or piece; or sees" in
  function
  | "flat" :: rest -> (Flat, rest)
  | "free" :: rest -> (MayBeChosen, rest)
  | "sees" :: rest ->
    let v, rest = number c expected rest in
    let q, rest = site c expected false rest in
    let w, rest = integer c expected rest in
    let plane tokens = match take c Reading.integer 4 expected tokens with
      | [ x; y; z; o ], rest -> (([ x; y; z ], o), rest)
      | _ -> assert false in
    (Encroached (v, q, w, all plane rest), [])
  | tokens -> let x, rest = domain_point c expected tokens in (Pierced x, rest)

let reason c =
  let expected = "covers, not-both or beside, and what CERTIFICATE.md asks for there" in
  function
  | "covers" :: rest -> let x, rest = domain_point c expected rest in (OneCovers x, rest)
  | "not-both" :: rest ->
    let (s, u), rest = pair (number c expected) (number c expected) rest in
    let q, rest = site c expected false rest in
    let w, rest = integer c expected rest in
    (NotBoth (s, u, q, w), rest)
  | "beside" :: rest ->
    let (s, i), rest = pair (number c expected) (place c expected) rest in
    let q, rest = site c expected false rest in
    let w, rest = integer c expected rest in
    (OneBeside (s, i, q, w, all (number c expected) rest), [])
  | token :: _ -> Text.fail c.source expected (Text.quote token)
  | [] -> assert false

(* Literals, a 0, and the numbers of clauses. *)
let step c =
  let expected = "literals, 0, and the numbers of clauses" in
  let rec literals found tokens =
    let n, rest = integer c expected tokens in
    let named n = named c (if Big.fits_int n then Big.to_int n else max_int) in
    if Big.sign n = 0 then (List.rev found, rest)
    else literals ((Big.sign n > 0, named (Big.abs n)) :: found) rest in
  fun tokens ->
    let derived, rest = literals [] tokens in
    ({ derived; hints = all (number c expected) rest }, [])

(* The candidates of n vertices; nothing if they are more than an integer of the machine can count. *)
let candidates n =
  let product = List.fold_left (fun p k -> Big.mul p (Big.of_int (n - k))) (Big.of_int 1) [ 0; 1; 2; 3 ] in
  Big.div product (Big.of_int 24)

let read c domain_claimed kind =
  let about = alone c domain_claimed kind (scale c) in
  let expected, rest = line c "mesh" "" in
  no_more c expected rest;
  let some_mesh = with_another_mesh c domain_claimed kind in
  let fates = section c "candidates" "what becomes of a candidate" (fate c) in
  let expected = candidates (List.length about.whole_mesh.points) in
  if not (Big.equal expected (Big.of_int (List.length fates))) then
    Text.fail c.source (Big.to_string expected ^ " candidates") (string_of_int (List.length fates));
  let reasons = section c "clauses" "a reason" (reason c) in
  let steps = section c "steps" "a step" (step c) in
  ending c;
  { about; some_mesh; fates; reasons; steps }
