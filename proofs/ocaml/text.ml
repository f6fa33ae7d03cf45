(* Lines of tokens: spaces separate, `#` begins a comment, empty lines are skipped.  A line is read as
   the list of its tokens ([next]), or token by token from where the cursor stands ([start_line], ...):
   the millions of lines of a certificate leave no garbage behind. *)
exception Malformed of int * string  (* the line, and what was expected and found *)

type t = {
  text : string;
  mutable at : int;    (* the first byte not yet read *)
  mutable line : int;  (* the number of the line that is being read, from 1 *)
  most : int;          (* lines there are no more: no valid number is greater *)
}

let of_string text = { text; at = 0; line = 0; most = String.length text + 1 }

let fail source expected found =
  raise (Malformed (source.line, Printf.sprintf "expected %s, found %s" expected found))

(* What was found, short enough to print and without control characters. *)
let quote token =
  let cut n s = if String.length s <= n then s else String.sub s 0 n ^ "..." in
  "'" ^ cut 60 (String.escaped (cut 60 token)) ^ "'"

let is_blank c = c = ' ' || c = '\t' || c = '\r' [@@inline]
let ends_token c = is_blank c || c = '#' || c = '\n' [@@inline]

(* The byte at i; the end of the text is the end of a line. *)
let byte source i =
  if i < String.length source.text then String.unsafe_get source.text i else '\n' [@@inline]

(* The first byte of the next token of this line, or what ends the line. *)
let rec skip_blanks source =
  if is_blank (byte source source.at) then begin
    source.at <- source.at + 1;
    skip_blanks source
  end

let at_end_of_line source =
  skip_blanks source;
  let c = byte source source.at in
  c = '\n' || c = '#'

let skip_line source =
  match String.index_from_opt source.text source.at '\n' with
  | Some i -> source.at <- i + 1
  | None -> source.at <- String.length source.text

(* The cursor to the first token of the next line that has any; whether there is one. *)
let rec found_line source =
  if source.at >= String.length source.text then false
  else begin
    source.line <- source.line + 1;
    if at_end_of_line source then (skip_line source; found_line source) else true
  end
let start_line source expected =
  if not (found_line source) then begin
    source.line <- source.line + 1;
    fail source expected "the end of the file"
  end

(* The next token of the line that is being read. *)
let token source expected =
  if at_end_of_line source then fail source expected "the end of the line";
  let first = source.at in
  let stop = ref first in
  while not (ends_token (byte source !stop)) do incr stop done;
  source.at <- !stop;
  String.sub source.text first (!stop - first)

let end_line source expected =
  if not (at_end_of_line source) then
    fail source (expected ^ " and no more") (quote (token source expected));
  skip_line source

(* The tokens of the next line that has any; none at the end. *)
let next source =
  if not (found_line source) then None
  else begin
    let rec tokens read_so_far =
      if at_end_of_line source then (skip_line source; Some (List.rev read_so_far))
      else tokens (token source "" :: read_so_far) in
    tokens []
  end
let next_of source expected =
  start_line source expected;
  let rec tokens read_so_far =
    if at_end_of_line source then (skip_line source; List.rev read_so_far)
    else tokens (token source "" :: read_so_far) in
  tokens []

(* Does the next line that has any tokens begin with this one? *)
let is_next source word =
  let { at; line; _ } = source in
  let found = found_line source && token source "" = word in
  source.at <- at;
  source.line <- line;
  found

let is_integer token =
  let n = String.length token in
  let first = if n > 0 && token.[0] = '-' then 1 else 0 in
  let rec digits i = i = n || (token.[i] >= '0' && token.[i] <= '9' && digits (i + 1)) in
  n > first && digits first

let integer source token =
  if is_integer token then Big.of_string token else fail source "an integer" (quote token)

(* A number of 62 bits without sign. *)
let count source token =
  let expected = "a number from 0 to 4611686018427387903" in
  if not (is_integer token) || token.[0] = '-' then fail source expected (quote token)
  else match int_of_string_opt ("0u" ^ token) with
    | Some n when n >= 0 -> n
    | _ -> fail source expected (quote token)

(* The number that the at most 18 digits from [i] make, and where they end; or where something else is,
   -1: then the token is read as a string, by the functions above. *)
let rec few_digits source i stop n =
  let c = byte source i in
  if c >= '0' && c <= '9' then
    if i >= stop then -1
    else few_digits source (i + 1) stop (10 * n + Char.code c - Char.code '0')
  else if ends_token c then (source.at <- i; n)
  else -1

let read_count source expected =
  if at_end_of_line source then fail source expected "the end of the line";
  let first = source.at in
  let c = byte source first in
  let n = if c >= '0' && c <= '9' then few_digits source first (first + 18) 0 else -1 in
  if n >= 0 then n else (source.at <- first; count source (token source expected))

let read_integer source expected =
  if at_end_of_line source then fail source expected "the end of the line";
  let first = source.at in
  let negative = byte source first = '-' in
  let start = if negative then first + 1 else first in
  let c = byte source start in
  let n = if c >= '0' && c <= '9' then few_digits source start (start + 18) 0 else -1 in
  if n >= 0 then Big.of_int (if negative then - n else n)
  else (source.at <- first; integer source (token source expected))

(* Whether the next token is `-`; then it has been read. *)
let read_dash source expected =
  if at_end_of_line source then fail source expected "the end of the line";
  byte source source.at = '-' && ends_token (byte source (source.at + 1)) &&
  (source.at <- source.at + 1; true)
