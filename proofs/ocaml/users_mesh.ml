(* Is the mesh of a file the user's own, as it stands in MESH.node and MESH.ele, and in what MESH.face and MESH.edge add?  Points are
   compared by the user's index, exactly; simplices one by one in their order, by their vertices. *)
open Extracted
open Numbered_rows

exception Another of string  (* how the meshes differ *)

let differs source format =
  Printf.ksprintf (fun what -> raise (Another (Printf.sprintf "%d: %s" source.Text.line what))) format

(* The numbers of the points, none where an entry names no point, by the number of the simplex, from 0; and what its attributes are, if
   these matter. *)
type simplices = { count : int; vertices : int -> int option list; attributes : (int -> Big.t list) option }
let listed rows =
  let rows = Array.of_list rows in
  { count = Array.length rows; vertices = Array.get rows; attributes = None }

type mesh = {
  unit : Big.t * Big.t;
  d : int;
  weighted : bool;
  sites : site array;
  labels : Big.t option array;       (* none, of a point that is nobody's *)
  simplices : simplices;
  ordered : bool;                    (* are the vertices of a simplex in the user's order? *)
  dangling : int option list list option;  (* of a domain's mesh: all that is listed and is a face of no simplex *)
  cyclic : bool;                     (* may edges be listed as vertices, each the first of an edge whose second is the next? *)
}

let users_points mesh =
  Array.fold_left (fun n label -> if label = None then n else n + 1) 0 mesh.labels

(* Which point the user calls so, counted from 0. *)
let numbering labels =
  let n = Array.length labels in
  let least = Array.fold_left (fun least label -> match least, label with
      | Some a, Some b -> Some (Big.min a b)
      | None, one | one, None -> one) None labels in
  let least = Option.value least ~default:Big.zero in
  let place label = let i = Big.sub label least in if Big.fits_int i then Big.to_int i else -1 in
  let dense = Array.make (4 * n) (-1) in
  let others = Hashtbl.create 16 in
  Array.iteri (fun k -> Option.iter (fun label ->
      let i = place label in
      if i >= 0 && i < 4 * n then dense.(i) <- k else Hashtbl.replace others label k)) labels;
  fun label ->
    let i = place label in
    if i >= 0 && i < 4 * n then dense.(i) else Option.value (Hashtbl.find_opt others label) ~default:(-1)

(* Whether x times the unit is a double.  If the unit is a fraction of 2^k, that is so if the double times 2^k is an integer, and which. *)
let same_double (p, q) =
  let k = Big.numbits q - 1 in
  let exact x value = Q.equal (Q.make (Big.mul p x) q) (Q.of_float value) in
  if Big.sign q <= 0 || not (Big.equal q (Big.shift_left Big.one k)) then exact
  else fun x value ->
    let times = Float.ldexp value k in
    if Float.is_finite times then Float.is_integer times && Big.equal (Big.of_float times) (Big.mul p x)
    else exact x value

(* Gives back the numbering.  No point is listed twice: the indices of [rows] go up by one. *)
let compare_points ~exactly mesh source =
  let number_of = numbering mesh.labels in
  let p, q = mesh.unit in
  let same_double = same_double mesh.unit in
  let power_of n = let p = Big.pow p n and q = Big.pow q n in fun x -> Q.make (Big.mul p x) q in
  let scaled = power_of 1 and scaled_weight = power_of 2 in
  let header = header source "'POINTS DIMENSION [ATTRIBUTES [MARKERS]]'" 2 4 in
  markers source header.(3);
  rows source "point" header.(0) (fun index ->
      if header.(1) <> mesh.d then
        differs source "expected points of dimension %d, found %d" mesh.d header.(1);
      let k = number_of index in
      if k < 0 then differs source "found point %s, which the certificate does not list" (Big.to_string index);
      let site = mesh.sites.(k) in
      List.iteri (fun axis x ->
          let is_same = match read_number ~exactly source (Text.token source "a coordinate") with
            | Double value -> same_double x value
            | Fraction value -> Q.equal (scaled x) value in
          if not is_same then
            differs source "found another coordinate %d of point %s" (axis + 1) (Big.to_string index)) site.coordinates;
      if mesh.weighted then begin
        let weight = if header.(2) > 0 then number ~exactly source (Text.token source "a weight") else Q.zero in
        if not (Q.equal (scaled_weight site.weight) weight) then
          differs source "found another weight of point %s" (Big.to_string index)
      end;
      skip_numbers ~exactly source (if mesh.weighted then header.(2) - 1 else header.(2));
      skip_markers source header.(3));
  end_of_file source;
  let own = users_points mesh in
  if header.(0) <> own then differs source "expected %d points, found %d" own header.(0);
  number_of

(* Of as many as a row has: they are few. *)
let sort_entries (entries : int array) =
  for i = 1 to Array.length entries - 1 do
    let x = entries.(i) in
    let j = ref i in
    while !j > 0 && entries.(!j - 1) > x do entries.(!j) <- entries.(!j - 1); decr j done;
    entries.(!j) <- x
  done
let same_entries (found : int array) (expected : int array) =
  let n = Array.length found in
  let rec from i = i = n || (found.(i) = expected.(i) && from (i + 1)) in
  n = Array.length expected && from 0

(* The attributes of the simplex with this number, from 0. *)
let compare_attributes ~exactly mesh k source count =
  match mesh.simplices.attributes with
  | None -> skip_numbers ~exactly source count
  | Some attributes ->
    let expected = if k < mesh.simplices.count then attributes k else [] in
    if List.length expected <> count then
      differs source "expected %d attributes of simplex %d, found %d" (List.length expected) (k + 1) count;
    List.iteri (fun i x ->
        if not (Q.equal (Q.of_bigint x) (number ~exactly source (Text.token source "an attribute"))) then
          differs source "found another attribute %d of simplex %d" (i + 1) (k + 1)) expected

(* Gives back the rows that are too short for simplices of the mesh, with their lines: what they list may dangle. *)
let compare_simplices ~exactly mesh number_of source =
  let header = header source "'SIMPLICES VERTICES [ATTRIBUTES]'" 2 3 in
  let width = header.(1) in
  if width < 1 then Text.fail source "simplices of at least 1 vertex" (string_of_int width);
  let points = Array.length mesh.sites in
  let may_dangle = width <= mesh.d && mesh.dangling <> None && mesh.simplices.count = 0 in
  let short = ref [] and k = ref 0 in
  let compare_row found =
    if !k >= mesh.simplices.count then differs source "found more simplices than %d" !k;
    let expected = Array.of_list (List.map (function
        | Some n when n >= 1 && n <= points -> n - 1
        | _ -> -1) (mesh.simplices.vertices !k)) in
    if not mesh.ordered then (sort_entries found; sort_entries expected);
    if not (same_entries found expected) then differs source "found another simplex %d" (!k + 1);
    incr k in
  let is_cycle = mesh.cyclic && width = 1 in
  let cycle = ref [] in
  rows source "simplex" header.(0) (fun _ ->
      let found = Array.make (min width (String.length source.Text.text)) (-1) in
      for i = 0 to width - 1 do
        let v = number_of (integer64 source "a vertex") in
        if i < Array.length found then found.(i) <- v
      done;
      compare_attributes ~exactly mesh !k source header.(2);
      if may_dangle then short := (Array.to_list found, source.Text.line) :: !short
      else if is_cycle then cycle := found.(0) :: !cycle
      else compare_row found);
  end_of_file source;
  let cycle = Array.of_list (List.rev !cycle) in
  Array.iteri (fun i v -> compare_row [| v; cycle.((i + 1) mod Array.length cycle) |]) cycle;
  if !k < mesh.simplices.count then
    differs source "expected %d simplices, found %d" mesh.simplices.count header.(0);
  List.rev !short

(* The triangles and edges that MESH.face and MESH.edge list: each is a face of a simplex or dangles, and what dangles is
   listed. *)
module Faces = Set.Make (struct type t = int list let compare = compare end)
let rec faces_of = function
  | [] -> [ [] ]
  | v :: rest -> let others = faces_of rest in others @ List.map (List.cons v) others

(* Each with its line.  TetGen adds as many as three columns to those that the header announces. *)
let faces_listed number_of vertices source =
  let header = header source "'FACES [MARKERS]'" 1 2 in
  markers source header.(1);
  let faces = ref [] and additions = ref (-1) in
  rows source "face" header.(0) (fun _ ->
      let read _ =
        let v = number_of (integer64 source "a vertex") in
        if v < 0 then differs source "found a point that the certificate does not list";
        v in
      let known = List.init vertices read in
      skip_markers source header.(1);
      let added = ref 0 in
      while not (Text.at_end_of_line source) do skip_markers source 1; incr added done;
      if !additions < 0 then additions := min 3 !added;
      if !added <> !additions then
        Text.fail source (Printf.sprintf "%d columns" (1 + vertices + header.(1) + !additions))
          (string_of_int (1 + vertices + header.(1) + !added));
      faces := (known, source.Text.line) :: !faces);
  end_of_file source;
  List.rev !faces

(* [short] are the rows of MESH.ele that dangle; [listed] are the other files. *)
let compare_faces mesh dangling number_of short listed =
  let known row =
    let numbers = List.filter_map (function
        | Some n when n >= 1 && n <= Array.length mesh.sites -> Some (n - 1)
        | _ -> None) row in
    if List.length numbers = List.length row then Some (List.sort_uniq compare numbers) else None in
  let dangling = List.filter_map known dangling in
  let found = List.concat_map (fun (vertices, source) -> faces_listed number_of vertices source) listed in
  let found = List.rev (List.rev_map (fun (face, line) -> (List.sort_uniq compare face, line)) (short @ found)) in
  let left = ref (Faces.of_list (List.map fst found)) in
  List.iter (fun face -> if not (Faces.mem face !left) then
                raise (Another "0: expected a dangling triangle or edge that is not listed")) dangling;
  let remove row = List.iter (fun face -> left := Faces.remove face !left) (faces_of row) in
  List.iter remove dangling;
  let k = ref 0 in
  while not (Faces.is_empty !left) && !k < mesh.simplices.count do
    let row = mesh.simplices.vertices !k in
    if List.compare_length_with row (mesh.d + 1) <= 0 then Option.iter remove (known row);
    incr k
  done;
  List.iter (fun (face, line) -> if Faces.mem face !left then
                raise (Another (Printf.sprintf "%d: found a triangle or an edge that is a face of no simplex, and does not dangle" line)))
    found
