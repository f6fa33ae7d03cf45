(* What the two kinds of files have in common; see CERTIFICATE.md. *)
open Extracted

(* The labels that were read: a bit for each that is less than the bytes of the file, as nearly all are, and the others. *)
type labels = { small : Bytes.t; others : (Big.t, unit) Hashtbl.t }
let no_labels (source : Text.t) =
  { small = Bytes.make (String.length source.text / 8 + 1) '\000'; others = Hashtbl.create 16 }
(* Of one part of a file, which may have many. *)
let no_labels_of_part () = { small = Bytes.empty; others = Hashtbl.create 64 }

type context = { source : Text.t; d : int; weighted : bool; labels : labels }

(* Peano's numerals, which count the vertices of a simplex: each is made of the one before it, once. *)
let naturals = ref [| O |]
let natural n =
  let n = max 0 n in
  let known = Array.length !naturals in
  if n >= known then begin
    let more = Array.make (max (n + 1) (2 * known)) O in
    Array.blit !naturals 0 more 0 known;
    for k = known to Array.length more - 1 do more.(k) <- S more.(k - 1) done;
    naturals := more
  end;
  !naturals.(n)
let of_natural n =
  let rec go counted = function O -> counted | S n -> go (counted + 1) n in
  go 0 n

let count c token = Text.count c.source token
(* A number greater than any thing that the file can list names nothing, and is replaced by the least
   such. *)
let named c n = let beyond = c.source.Text.most + 1 in if n < 1 || n > beyond then beyond else n
let number c token = named c (count c token)
let integer c token = Text.integer c.source token
(* An entry of a simplex as its author wrote it: there are no more than bytes in the file. *)
let position c token = natural (min (count c token) (String.length c.source.text))

(* The first [n] tokens, each read, and the others; a line may have millions. *)
let take c read n expected tokens =
  let rec go n read_so_far tokens =
    if n = 0 then (List.rev read_so_far, tokens)
    else match tokens with
      | token :: rest -> go (n - 1) (read c token :: read_so_far) rest
      | [] -> Text.fail c.source expected "the end of the line" in
  go n [] tokens

let site c expected weighted tokens =
  let coordinates, rest = take c integer c.d expected tokens in
  let weights, rest = take c integer (if weighted then 1 else 0) expected rest in
  ({ coordinates; weight = (match weights with [ w ] -> w | _ -> Big.zero) }, rest)

let no_more c expected = function
  | [] -> ()
  | token :: _ -> Text.fail c.source (expected ^ " and no more") (Text.quote token)

(* A line that begins with the word [name]: its other tokens. *)
let line c name rest_expected =
  let expected = "'" ^ String.trim (name ^ " " ^ rest_expected) ^ "'" in
  match Text.next_of c.source expected with
  | word :: rest when word = name -> (expected, rest)
  | word :: _ -> Text.fail c.source expected (Text.quote word)
  | [] -> assert false

(* By which index the user knows a point; no two points have the same. *)
exception Repeated_label of string
let is_new { small; others } label =
  let place = if Big.fits_int label then Big.to_int label / 8 else -1 in
  if Big.sign label >= 0 && place >= 0 && place < Bytes.length small then begin
    let bits = Char.code (Bytes.get small place) and bit = 1 lsl (Big.to_int label land 7) in
    Bytes.set small place (Char.chr (bits lor bit));
    bits land bit = 0
  end else begin
    let known = Hashtbl.mem others label in
    if not known then Hashtbl.add others label ();
    not known
  end
let new_label c label =
  if not (is_new c.labels label) then raise (Repeated_label (Big.to_string label));
  label
let label c expected tokens =
  let values, rest = take c integer 1 expected tokens in
  (new_label c (List.hd values), rest)

(* `NAME COUNT` and that many lines. *)
let section c name expected read =
  let header, tokens = line c name "COUNT" in
  let counts, rest = take c count 1 header tokens in
  no_more c header rest;
  let rec lines n read_so_far =
    if n = 0 then List.rev read_so_far
    else begin
      let tokens = Text.next_of c.source expected in
      let value, rest = read tokens in
      no_more c expected rest;
      lines (n - 1) (value :: read_so_far)
    end in
  lines (List.hd counts) []

let scale c =
  let expected, tokens = line c "scale" "P Q" in
  match take c integer 2 expected tokens with
  | [ p; q ], rest -> no_more c expected rest; (p, q)
  | _ -> assert false

let ending c =
  let expected, rest = line c "end" "" in
  no_more c expected rest;
  match Text.next c.source with
  | None -> ()
  | Some tokens -> Text.fail c.source "nothing after 'end'" (Text.quote (List.hd tokens))
