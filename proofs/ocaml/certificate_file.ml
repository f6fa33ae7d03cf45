(* Certificates, as CERTIFICATE.md describes them, into the records that the proved checker reads. *)
open Extracted
open Reading

(* What may stand in millions of places is made once. *)
let naturals = Array.init 6 natural
let some_naturals = Array.map Option.some naturals

(* Vertices, facets and ridges: greater numbers than d name nothing. *)
let place c expected = min (Text.read_count c.source expected) (c.d + 1)
let index c expected = naturals.(place c expected)
let number c expected = named c (Text.read_count c.source expected)
let unless_dash c expected =
  if Text.read_dash c.source expected then None else some_naturals.(place c expected)

(* Things are read in their order, however the list is built. *)
let rec listed n read = if n = 0 then [] else let thing = read () in thing :: listed (n - 1) read

(* `NAME COUNT`, and that many lines, each by what [reader] makes of how many there are. *)
let counted_lines c name expected reader =
  let header, tokens = line c name "COUNT" in
  let counts, rest = take c count 1 header tokens in
  no_more c header rest;
  let read = reader (List.hd counts) in
  for _ = 1 to List.hd counts do
    Text.start_line c.source expected;
    read ();
    Text.end_line c.source expected
  done
let section c name expected read =
  let things = ref [] in
  counted_lines c name expected (fun _ () -> things := read () :: !things);
  List.rev !things

(* The row of a simplex, as checker/Packed.v describes it. *)
let simplex c expected rows =
  for _ = 0 to c.d do Words.add rows (number c expected) done;
  for _ = 0 to c.d do
    Words.add rows
      (if Text.read_dash c.source expected then - number c expected
       else
         let t = number c expected in
         8 * t + place c expected)
  done;
  Words.add rows (if Text.read_dash c.source expected then -1 else place c expected)

(* The points, and their labels: none, where it may be that a point is nobody's. *)
let points ?(some_are_nobodys = false) c =
  let expected = "the coordinates of a point, its simplex, its vertex there and a label" in
  let integer () = Text.read_integer c.source expected in
  let labels = ref [] in
  let points = section c "points" expected (fun () ->
      let coordinates = listed c.d integer in
      let weight = if c.weighted then integer () else Big.zero in
      let home = number c expected in
      let home_vertex = unless_dash c expected in
      let is_nobodys = some_are_nobodys && Text.read_dash c.source expected in
      labels := (if is_nobodys then None else Some (new_label c (integer ()))) :: !labels;
      { position = { coordinates; weight }; home; home_vertex }) in
  (points, List.rev !labels)

(* The certificate up to its sample point, and the labels of its points. *)
let body ?some_are_nobodys c claimed =
  let numerator, denominator = scale c in
  let points, labels = points ?some_are_nobodys c in
  let expected = "the vertices of a simplex, what is across its facets, and a facet or '-'" in
  let simplex_count = ref 0 and rows = ref (Words.growing 0) in
  counted_lines c "simplices" expected (fun count ->
      (* Every word takes two bytes of text at least. *)
      let most = String.length c.source.text / 2 in
      simplex_count := count;
      rows := Words.growing (min most (min most count * (2 * c.d + 3)));
      let rows = !rows in
      fun () -> simplex c expected rows);
  let expected = "a simplex, a facet, and what is across the ridges" in
  let ridge () = let g = number c expected in (g, index c expected) in
  let hull = section c "hull" expected (fun () ->
      let carrier = number c expected in
      let apex = index c expected in
      { carrier; apex; ridges = listed c.d ridge }) in
  let expected, tokens = line c "sample" "SIMPLEX COORDINATES W" in
  let simplex, rest = take c Reading.number 1 expected tokens in
  let sample, rest = site c expected false rest in
  let sample_denominator, rest = take c Reading.integer 1 expected rest in
  no_more c expected rest;
  let frame = { claimed; numerator; denominator; points; simplices = []; hull;
                sample_simplex = List.hd simplex; sample; sample_denominator = List.hd sample_denominator } in
  ({ frame; simplex_count = !simplex_count; rows_of = Words.grown !rows }, labels)

(* The same with lists and records for rows, as the checker of domains reads it. *)
let in_lists space packed =
  let simplices = List.rev (List.rev_map (entry_of space packed.rows_of) (Word.upto packed.simplex_count)) in
  { packed.frame with simplices }

let read c claimed =
  let read = body c claimed in
  ending c;
  read

(* Of a convex hull: also which point is the summit, and which points it is inside of. The summit is nobody's, and the others
   are the user's. *)
let read_hull c claimed =
  let (packed, labels) = body ~some_are_nobodys:true c claimed in
  let expected, tokens = line c "summit" "POINT VERTICES" in
  let numbers, rest = take c Reading.number (c.d + 2) expected tokens in
  no_more c expected rest;
  let summit = List.hd numbers in
  List.iteri (fun k label -> if (label = None) <> (k + 1 = summit) then
                 Text.fail c.source "'-' for the label of the summit, and of no other point" (string_of_int (k + 1))) labels;
  ending c;
  (packed, labels, summit, List.tl numbers)

(* Of points of a plane in space: also what is not seen of them. *)
let read_flat c claimed =
  let packed, labels = body c claimed in
  let expected, tokens = line c "flat" "AXIS NORMAL OFFSET" in
  let axes, rest = take c count 1 expected tokens in
  let flat_normal, rest = take c Reading.integer 3 expected rest in
  let offsets, rest = take c Reading.integer 1 expected rest in
  no_more c expected rest;
  let expected = "a coordinate" in
  let unseen = section c "unseen" expected (fun () -> Text.read_integer c.source expected) in
  ending c;
  (packed, labels, { unseen_axis = natural (min 3 (List.hd axes)); unseen; flat_normal; flat_offset = List.hd offsets })

(* How many binary digits of the coordinates the quick check leaves out, so that they are words: any number is sound. *)
let digits_left_out (frame : certificate) =
  let digits most (q : site) = List.fold_left (fun most x -> max most (Big.numbits x)) most q.coordinates in
  max 0 (List.fold_left (fun most e -> digits most e.position) (digits 0 frame.sample) frame.points - 58)
