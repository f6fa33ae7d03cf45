(* Lines of tokens: spaces separate, `#` begins a comment, empty lines are skipped. *)
exception Malformed of int * string  (* the line, and what was expected and found *)

type t = {
  text : string;
  mutable at : int;    (* the first byte not yet read *)
  mutable line : int;  (* the number of the line last read, from 1 *)
  lines : int;         (* how many there are: no valid number is greater *)
}

let of_string text =
  let lines = ref 1 in
  String.iter (fun c -> if c = '\n' then incr lines) text;
  { text; at = 0; line = 0; lines = !lines }

let fail source expected found =
  raise (Malformed (source.line, Printf.sprintf "expected %s, found %s" expected found))

(* What was found, short enough to print and without control characters. *)
let quote token =
  let cut n s = if String.length s <= n then s else String.sub s 0 n ^ "..." in
  "'" ^ cut 60 (String.escaped (cut 60 token)) ^ "'"

(* The tokens from [i] to [stop], the last first. *)
let rec split text i stop tokens =
  if i >= stop || text.[i] = '#' then tokens
  else if text.[i] = ' ' || text.[i] = '\t' || text.[i] = '\r' then split text (i + 1) stop tokens
  else begin
    let j = ref i in
    while !j < stop && not (String.contains " \t\r#" text.[!j]) do incr j done;
    split text !j stop (String.sub text i (!j - i) :: tokens)
  end

(* The tokens of the next line that has any; none at the end. *)
let rec next source =
  if source.at >= String.length source.text then None
  else begin
    let stop = match String.index_from_opt source.text source.at '\n' with
      | Some i -> i
      | None -> String.length source.text in
    let tokens = split source.text source.at stop [] in
    source.at <- stop + 1;
    source.line <- source.line + 1;
    if tokens = [] then next source else Some (List.rev tokens)
  end

let next_of source expected = match next source with
  | Some tokens -> tokens
  | None -> source.line <- source.line + 1; fail source expected "the end of the file"

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
