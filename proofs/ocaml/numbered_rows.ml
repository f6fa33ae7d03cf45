(* Triangle's and TetGen's rows, as docs/formats.md describes them: after a header of counts, rows that are numbered by integers which go
   up by one from the first, and each has exactly the columns that the header announces.  Columns that nothing is about are
   read, too: they have to be numbers. *)

let digits = String.for_all (fun c -> c >= '0' && c <= '9')

(* -12.5e-3 as its sign, its digits without the point, and the power of ten they are multiplied with. *)
let decimal source token =
  let fail () = Text.fail source "a decimal or a fraction" (Text.quote token) in
  let small text = match int_of_string_opt text with
    | Some n when abs n <= 10000 -> n
    | _ -> fail () in
  let n = String.length token in
  let negative = n > 0 && token.[0] = '-' in
  let first = if n > 0 && (negative || token.[0] = '+') then 1 else 0 in
  let mark = match String.index_opt (String.lowercase_ascii token) 'e' with Some i -> i | None -> n in
  let exponent = if mark = n then 0 else begin
      let text = String.sub token (mark + 1) (n - mark - 1) in
      let sign = text <> "" && (text.[0] = '-' || text.[0] = '+') in
      let number = if sign then String.sub text 1 (String.length text - 1) else text in
      if number = "" || not (digits number) then fail ();
      (if text.[0] = '-' then -1 else 1) * small ("0u" ^ number)
    end in
  let mantissa = String.sub token first (mark - first) in
  let whole, part = match String.index_opt mantissa '.' with
    | Some i -> (String.sub mantissa 0 i, String.sub mantissa (i + 1) (String.length mantissa - i - 1))
    | None -> (mantissa, "") in
  if whole ^ part = "" || not (digits (whole ^ part)) || n > 10000 then fail ();
  (negative, whole ^ part, exponent - String.length part)

(* Nothing but a sign, digits and a point among them: this is how most numbers are written. *)
let is_plain token =
  let n = String.length token in
  let rec goes_on i digits points =
    if i = n then digits > 0 && points < 2
    else match token.[i] with
      | '0' .. '9' -> goes_on (i + 1) (digits + 1) points
      | '.' -> goes_on (i + 1) digits (points + 1)
      | _ -> false in
  n <= 10000 && goes_on (if n > 0 && (token.[0] = '-' || token.[0] = '+') then 1 else 0) 0 0

(* A decimal is the nearest double, unless decimals are taken at their word. *)
type number = Double of float | Fraction of Q.t

let read_number ~exactly source token =
  let double () =
    let value = float_of_string token in
    if Float.is_finite value then Double value
    else Text.fail source "a number that a double can hold" (Text.quote token) in
  if not exactly && is_plain token then double ()
  else match String.index_opt token '/' with
    | Some i ->
      let over = Text.integer source (String.sub token 0 i) in
      let under = Text.integer source (String.sub token (i + 1) (String.length token - i - 1)) in
      if Big.sign under <= 0 then Text.fail source "a positive denominator" (Text.quote token);
      Fraction (Q.make over under)
    | None ->
      let negative, figures, power = decimal source token in
      if exactly then begin
        let value = Q.of_bigint (Big.of_string figures) in
        let scaled = if power >= 0 then Q.mul value (Q.of_bigint (Big.pow (Big.of_int 10) power))
          else Q.div value (Q.of_bigint (Big.pow (Big.of_int 10) (-power))) in
        Fraction (if negative then Q.neg scaled else scaled)
      end else double ()
let number ~exactly source token = match read_number ~exactly source token with
  | Double value -> Q.of_float value
  | Fraction value -> value

(* An index, a marker: an integer of 64 bits. *)
let fitting source n =
  if Big.fits_int64 n then n else Text.fail source "an integer of 64 bits" (Text.quote (Big.to_string n))
let integer64 source expected = fitting source (Text.read_integer source expected)
let integer64_of source token = fitting source (Text.integer source token)

(* From [least] to [most] counts, with as many zeros as are left out. *)
let header source expected least most =
  let given = List.map (Text.count source) (Text.next_of source expected) in
  if List.length given < least || List.length given > most then
    Text.fail source expected (string_of_int (List.length given) ^ " numbers");
  Array.of_list (given @ List.init (most - List.length given) (fun _ -> 0))
(* The last count of a header, of markers. *)
let markers source count =
  if count > 1 then Text.fail source "0 or 1 markers" (string_of_int count)

(* Each row, from the column after its index on, by [read]. *)
let rows source what count read =
  let first = ref Big.zero in
  for row = 0 to count - 1 do
    if not (Text.found_line source) then begin
      source.Text.line <- source.Text.line + 1;
      Text.fail source (Printf.sprintf "%s %d of %d" what (row + 1) count) "the end of the file"
    end;
    let index = integer64 source "an index" in
    if row = 0 then first := index
    else if not (Big.equal index (Big.add !first (Big.of_int row))) then
      Text.fail source (Printf.sprintf "the index %s, one more than the line before" (Big.to_string (Big.add !first (Big.of_int row))))
        (Big.to_string index);
    read index;
    Text.end_line source "as many columns as the header announces"
  done
let end_of_file source =
  match Text.next source with
  | None -> ()
  | Some tokens -> Text.fail source "the end of the file" (Text.quote (List.hd tokens))

(* The columns of attributes and markers. *)
let skip_numbers ~exactly source count =
  for _ = 1 to count do ignore (number ~exactly source (Text.token source "an attribute") : Q.t) done
let skip_markers source count =
  for _ = 1 to count do ignore (integer64 source "a marker" : Big.t) done
