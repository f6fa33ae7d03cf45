(* Is the mesh of a file the user's own, as it stands in MESH.node and MESH.ele?  Points are compared by
   the user's index, exactly; simplices one by one in their order, by their vertices. *)
open Extracted

exception Another of string  (* how the meshes differ *)

let differs source format =
  Printf.ksprintf (fun what -> raise (Another (Printf.sprintf "%d: %s" source.Text.line what))) format

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

(* The nearest double, unless decimals are taken at their word. *)
let number ~exactly source token =
  match String.index_opt token '/' with
  | Some i ->
    let over = Text.integer source (String.sub token 0 i) in
    let under = Text.integer source (String.sub token (i + 1) (String.length token - i - 1)) in
    if Big.sign under <= 0 then Text.fail source "a positive denominator" (Text.quote token);
    Q.make over under
  | None ->
    let negative, figures, power = decimal source token in
    if exactly then begin
      let value = Q.of_bigint (Big.of_string figures) in
      let scaled = if power >= 0 then Q.mul value (Q.of_bigint (Big.pow (Big.of_int 10) power))
        else Q.div value (Q.of_bigint (Big.pow (Big.of_int 10) (-power))) in
      if negative then Q.neg scaled else scaled
    end else begin
      let value = float_of_string token in
      if Float.is_finite value then Q.of_float value
      else Text.fail source "a number that a double can hold" (Text.quote token)
    end

let natural source token = Text.count source token

(* The header, with as many zeros as it leaves out, and the rows; each has `columns header` tokens. *)
let rows source expected least most columns read =
  let header = List.map (natural source) (Text.next_of source expected) in
  let given = List.length header in
  if given < least || given > most then
    Text.fail source expected (string_of_int given ^ " numbers");
  let header = Array.of_list (header @ List.init (most - given) (fun _ -> 0)) in
  let width = columns header in
  for row = 0 to header.(0) - 1 do
    let tokens = Text.next_of source (Printf.sprintf "row %d of %d" (row + 1) header.(0)) in
    if List.length tokens <> width then
      Text.fail source (string_of_int width ^ " columns") (string_of_int (List.length tokens));
    read header row tokens
  done;
  match Text.next source with
  | None -> header
  | Some tokens -> Text.fail source "the end of the file" (Text.quote (List.hd tokens))

type mesh = {
  unit : Big.t * Big.t;
  d : int;
  weighted : bool;
  sites : site array;
  labels : Big.t array;
  simplices : int option list list;  (* the numbers of the points; none, where it names no point *)
  ordered : bool;                    (* are the vertices of a simplex in the user's order? *)
  dangling : int option list list option;  (* of a refutation: all that is listed and is a face of no simplex *)
}

let compare_points ~exactly mesh source =
  let number_of = Hashtbl.create (2 * Array.length mesh.labels) in
  Array.iteri (fun k label -> Hashtbl.replace number_of label k) mesh.labels;
  let p, q = mesh.unit in
  let scaled power x = Q.make (Big.mul (Big.pow p power) x) (Big.pow q power) in
  let same power x token = Q.equal (scaled power x) (number ~exactly source token) in
  let seen = Array.make (Array.length mesh.sites) false in
  let header = rows source "'POINTS DIMENSION [ATTRIBUTES [MARKERS]]'" 2 4
      (fun header -> 1 + header.(1) + header.(2) + header.(3)) (fun header _ tokens ->
        if header.(1) <> mesh.d then
          differs source "expected points of dimension %d, found %d" mesh.d header.(1);
        let index = List.hd tokens and tokens = Array.of_list (List.tl tokens) in
        match Hashtbl.find_opt number_of (Text.integer source index) with
        | None -> differs source "found point %s, which the certificate does not list" index
        | Some k ->
          if seen.(k) then differs source "found point %s twice" index;
          seen.(k) <- true;
          let site = mesh.sites.(k) in
          List.iteri (fun axis x -> if not (same 1 x tokens.(axis)) then
                         differs source "found another coordinate %d of point %s" (axis + 1) index)
            site.coordinates;
          let weight = if header.(2) > 0 then tokens.(mesh.d) else "0" in
          if mesh.weighted && not (same 2 site.weight weight) then
            differs source "found another weight of point %s" index) in
  if header.(0) <> Array.length mesh.sites then
    differs source "expected %d points, found %d" (Array.length mesh.sites) header.(0);
  number_of

let compare_simplices mesh number_of source =
  let left = ref mesh.simplices in
  let arranged row = if mesh.ordered then row else List.sort compare row in
  let header = rows source "'SIMPLICES VERTICES [ATTRIBUTES]'" 2 3
      (fun header -> 1 + header.(1) + header.(2)) (fun header row tokens ->
        let vertices = List.filteri (fun i _ -> i < header.(1)) (List.tl tokens) in
        let found = List.map (fun token ->
            Hashtbl.find_opt number_of (Text.integer source token)) vertices in
        match !left with
        | expected :: rest ->
          let expected = List.map (function
              | Some n when n >= 1 && n <= Array.length mesh.sites -> Some (n - 1)
              | _ -> None) expected in
          if arranged found <> arranged expected then
            differs source "found another simplex %d" (row + 1);
          left := rest
        | [] -> differs source "found more simplices than %d" row) in
  if !left <> [] then
    differs source "expected %d simplices, found %d" (List.length mesh.simplices) header.(0)

(* The triangles and edges that MESH.face and MESH.edge list: each is a face of a simplex or dangles, and what dangles is
   listed. *)
module Faces = Set.Make (struct type t = int list let compare = compare end)
let rec faces_of = function
  | [] -> [ [] ]
  | v :: rest -> let others = faces_of rest in others @ List.map (List.cons v) others
let compare_faces mesh dangling number_of listed =
  let known row =
    let numbers = List.filter_map (function
        | Some n when n >= 1 && n <= Array.length mesh.sites -> Some (n - 1)
        | _ -> None) row in
    if List.length numbers = List.length row then Some (List.sort_uniq compare numbers) else None in
  let dangling = List.filter_map known dangling in
  let found = List.concat_map (fun (vertices, source) ->
      let faces = ref [] in
      let expected = "'FACES [MARKERS]'" in
      let count = Text.count source (List.hd (Text.next_of source expected)) in
      for row = 1 to count do
        let tokens = Text.next_of source (Printf.sprintf "row %d of %d" row count) in
        if List.length tokens <= vertices then
          Text.fail source (string_of_int (vertices + 1) ^ " columns") (string_of_int (List.length tokens));
        let numbers = List.filteri (fun i _ -> i < vertices) (List.tl tokens) in
        let known = List.filter_map (fun token -> Hashtbl.find_opt number_of (Text.integer source token)) numbers in
        if List.length known <> vertices then differs source "found a point that the certificate does not list";
        faces := (List.sort_uniq compare known, source.Text.line) :: !faces
      done;
      !faces) listed in
  let left = ref (Faces.of_list (List.map fst found)) in
  List.iter (fun face -> if not (Faces.mem face !left) then
                raise (Another "0: expected a dangling triangle or edge that is not listed")) dangling;
  let remove row = List.iter (fun face -> left := Faces.remove face !left) (faces_of row) in
  List.iter remove dangling;
  if not (Faces.is_empty !left) then
    List.iter (fun row -> if List.length row <= mesh.d + 1 then Option.iter remove (known row)) mesh.simplices;
  List.iter (fun (face, line) -> if Faces.mem face !left then
                raise (Another (Printf.sprintf "%d: found a triangle or an edge that is a face of no simplex, and does not dangle" line)))
    (List.rev found)
