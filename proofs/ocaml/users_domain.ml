(* The user's own DOMAIN.poly, as Triangle and TetGen write it (docs/formats.md decides the grey zones), held against
   the domain that a certificate is about: the same vertices, by their exact coordinates, and between them the same
   segments, polygons, each with its own segments and hole points, and the same hole points. *)
open Extracted
open Users_mesh

type place = Q.t list
type edge = int * int  (* of the vertices, the smaller first *)
module Edges = Set.Make (struct type t = edge let compare = compare end)

type points = (place * int) list * int * int  (* with their lines; the dimension, and the index of the first *)
type polygon = { rim : Edges.t; gaps : place list; line : int }
type domain = {
  vertices : (place * int) list;  (* and the line *)
  segments : (edge * int) list;
  polygons : polygon list;
  holes : (place * int) list;
}

let edge u v = (min u v, max u v)
let same_place = List.equal Q.equal
let shown place = String.concat " " (List.map Q.to_string place)

(* The file. *)

let coordinates ~exactly source d tokens =
  List.map (number ~exactly source) (List.filteri (fun i _ -> i < d) tokens)

(* The count, and at most one marker, with which a list begins. *)
let header source expected =
  match List.map (natural source) (Text.next_of source expected) with
  | [ n ] -> (n, 0)
  | [ n; markers ] when markers <= 1 -> (n, markers)
  | _ -> Text.fail source expected "other numbers"

let repeated n read = List.rev (let rec go n found = if n = 0 then found else go (n - 1) (read () :: found) in go n [])

(* The points, or nothing if they are in a file of their own; the index of the first. *)
let points ~exactly source : points =
  let expected = "'POINTS DIMENSION [ATTRIBUTES [MARKERS]]'" in
  let given = List.map (natural source) (Text.next_of source expected) in
  let field i = Option.value (List.nth_opt given i) ~default:0 in
  let n = field 0 and d = field 1 in
  if n > 0 && d <> 2 && d <> 3 then Text.fail source "points of dimension 2 or 3" (string_of_int d);
  let first = ref 0 in
  let width = 1 + d + field 2 + field 3 in
  let row = ref 0 in
  let read () =
    let tokens = Text.next_of source (Printf.sprintf "point %d of %d" (!row + 1) n) in
    if List.length tokens <> width then
      Text.fail source (string_of_int width ^ " columns") (string_of_int (List.length tokens));
    let index = natural source (List.hd tokens) in
    if !row = 0 then first := index;
    if index <> !first + !row then
      Text.fail source (Printf.sprintf "the index %d" (!first + !row)) (string_of_int index);
    incr row;
    (coordinates ~exactly source d (List.tl tokens), source.line) in
  let rows = repeated n read in
  (rows, d, !first)

(* Corners without those that repeat the one before them; the last counts as before the first. *)
let without_repetitions corners =
  let rec go = function
    | a :: (b :: _ as rest) when a = b -> go rest
    | a :: rest -> a :: go rest
    | [] -> [] in
  let rec trimmed first = function
    | [ last ] when last = first -> []
    | a :: rest -> a :: trimmed first rest
    | [] -> [] in
  match go corners with
  | first :: (_ :: _ as rest) -> first :: trimmed first rest
  | few -> few

let edges_of_line = function
  | [] | [ _ ] -> []
  | first :: _ as corners ->
    List.map2 edge corners (List.tl corners @ [ first ])

let has_cycle edges =
  let parent = Hashtbl.create 16 in
  let rec root v = match Hashtbl.find_opt parent v with Some u -> root u | None -> v in
  Edges.exists (fun (u, v) ->
      let u = root u and v = root v in
      u = v || (Hashtbl.add parent u v; false)) edges

let vertex source first count token =
  let v = natural source token - first in
  if v < 0 || v >= count then Text.fail source "a vertex of the file" (Text.quote token) else v

(* A facet: a polygon, or if it has no area the segments that it lists. *)
let facet ~exactly source markers first count =
  let counts = List.map (Text.integer source) (Text.next_of source "'POLYGONS [HOLES [MARKER]]'") in
  let line = source.line in
  let field i = match List.nth_opt counts i with
    | Some n when Big.fits_int n && Big.sign n >= 0 -> Big.to_int n
    | None when i = 1 -> 0
    | _ -> Text.fail source "'POLYGONS [HOLES [MARKER]]'" "other numbers" in
  if List.length counts > 2 + markers then Text.fail source "'POLYGONS [HOLES [MARKER]]'" "more numbers";
  let polygon () =
    let tokens = Text.next_of source "a polygon" in
    let n = natural source (List.hd tokens) in
    let rec corners found left tokens =
      match tokens with
      | [] when left = 0 -> List.rev found
      | [] -> corners found left (Text.next_of source "corners of a polygon")
      | token :: _ when left = 0 -> Text.fail source "the end of the line" (Text.quote token)
      | token :: rest -> corners (vertex source first count token :: found) (left - 1) rest in
    without_repetitions (corners [] n (List.tl tokens)) in
  let lines = repeated (field 0) polygon in
  let gap () =
    let tokens = Text.next_of source "a hole of a facet" in
    if List.length tokens <> 4 then Text.fail source "4 columns" (string_of_int (List.length tokens));
    coordinates ~exactly source 3 (List.tl tokens) in
  let gaps = repeated (field 1) gap in
  let rim = Edges.of_list (List.concat_map edges_of_line lines) in
  let has_area = List.exists (fun line -> List.length line > 2) lines || gaps <> [] || has_cycle rim in
  (rim, if has_area then Some { rim; gaps; line } else None)

let read ~exactly points_elsewhere source =
  let own, announced, first = points ~exactly source in
  let vertices, d, first = if own <> [] then (own, announced, first) else points_elsewhere () in
  let count = List.length vertices in
  let n, markers = header source (if d = 2 then "'SEGMENTS [MARKERS]'" else "'FACETS [MARKERS]'") in
  let segments, polygons =
    if d = 2 then
      let segment () = match Text.next_of source "a segment" with
        | _ :: u :: v :: rest when List.length rest = markers ->
          (edge (vertex source first count u) (vertex source first count v), source.Text.line)
        | tokens -> Text.fail source (string_of_int (3 + markers) ^ " columns")
                      (string_of_int (List.length tokens)) in
      (repeated n segment, [])
    else
      let facets = repeated n (fun () ->
          let found = facet ~exactly source markers first count in (found, source.Text.line)) in
      (List.concat_map (fun ((rim, _), line) -> List.map (fun e -> (e, line)) (Edges.elements rim)) facets,
       List.filter_map (fun ((_, polygon), _) -> polygon) facets) in
  let hole () =
    let tokens = Text.next_of source "a hole" in
    if List.length tokens <> 1 + d then
      Text.fail source (string_of_int (1 + d) ^ " columns") (string_of_int (List.length tokens));
    (coordinates ~exactly source d (List.tl tokens), source.Text.line) in
  let list_of read = match Text.next source with
    | None -> []
    | Some [ n ] -> repeated (natural source n) read
    | Some tokens -> Text.fail source "a number" (Text.quote (String.concat " " tokens)) in
  let holes = list_of hole in
  (* Regions give attributes to the elements of a mesh. *)
  let _ = list_of (fun () -> ignore (Text.next_of source "a region")) in
  (match Text.next source with
   | None -> ()
   | Some tokens -> Text.fail source "the end of the file" (Text.quote (List.hd tokens)));
  { vertices; segments; polygons; holes }

(* The domain of a certificate, its points by their numbers from 0. *)

let ratio (p, q) w x = Q.make (Big.mul p x) (Big.mul q w)
let place_of scale (site : site) w = List.map (ratio scale w) site.coordinates

let rec last_of from = function [] -> from | [ (link : link) ] -> link.reached | _ :: rest -> last_of from rest
let ends (s : segment_entry) = (s.from - 1, last_of s.from s.links - 1)

(* A hole point that a certificate may leave out: it is beyond all the points, where nothing is enclosed. *)
let beyond places place =
  let rec apart axis = function
    | [] -> false
    | x :: rest ->
      List.for_all (fun p -> Q.lt (List.nth p axis) x) places
      || List.for_all (fun p -> Q.gt (List.nth p axis) x) places || apart (axis + 1) rest in
  apart 0 place

(* What is in one list of places and not in the other. *)
let without places others = List.filter (fun p -> not (List.exists (same_place p) others)) places

let differs_at line format =
  Printf.ksprintf (fun what -> raise (Another (Printf.sprintf "%d: %s" line what))) format

(* Vertices, which are some of the places by their numbers, and segments between them; how the file's edges
   are called here. *)
let compare_segments places corners expected domain source =
  let number_of = Hashtbl.create (2 * Array.length places) in
  List.iter (fun k -> Hashtbl.replace number_of (shown places.(k)) k) corners;
  let seen = Hashtbl.create 64 in
  let numbers = Array.of_list (List.map (fun (place, line) ->
      match Hashtbl.find_opt number_of (shown place) with
      | None -> differs_at line "found the vertex (%s), which is none of the certificate's domain" (shown place)
      | Some k ->
        if Hashtbl.mem seen k then differs_at line "found the vertex (%s) twice" (shown place);
        Hashtbl.add seen k ();
        k) domain.vertices) in
  if Array.length numbers <> List.length corners then
    differs source "expected %d vertices, found %d" (List.length corners) (Array.length numbers);
  let renamed (u, v) = edge numbers.(u) numbers.(v) in
  let found = List.map (fun (e, line) -> (renamed e, line)) domain.segments in
  List.iter (fun (e, line) -> if not (Edges.mem e expected) then
                differs_at line "found the segment from (%s) to (%s), which is none of the certificate's domain"
                  (shown places.(fst e)) (shown places.(snd e))) found;
  let missing = Edges.diff expected (Edges.of_list (List.map fst found)) in
  (match Edges.min_elt_opt missing with
   | None -> ()
   | Some (u, v) -> differs source "expected the segment from (%s) to (%s), found none"
                      (shown places.(u)) (shown places.(v)));
  renamed

(* A refutation says of the domain which vertices and segments it has. *)
let compare_refuted (c : domain_refutation) points_elsewhere ~exactly source =
  let domain = read ~exactly points_elsewhere source in
  let scale = (c.mesh_refuted.unit_numerator, c.mesh_refuted.unit_denominator) in
  let places = Array.of_list (List.map (fun site -> place_of scale site Big.one) c.vertices_given) in
  let n = Array.length places in
  let expected = Edges.of_list (List.map (fun (j, k) ->
      if j > n || k > n then differs source "expected %d vertices, found a segment with another" n;
      edge (j - 1) (k - 1)) c.segments_given) in
  ignore (compare_segments places (List.init n Fun.id) expected domain source : edge -> edge)

let compare_domain mesh (c : domain_certificate) points_elsewhere ~exactly source =
  let domain = read ~exactly points_elsewhere source in
  let places = Array.map (fun site -> place_of mesh.unit site Big.one) mesh.sites in
  let corners = List.concat (List.mapi (fun k -> function Corner _ -> [ k ] | Steiner _ -> []) c.domain_part.roles) in
  let expected = Edges.of_list (List.map (fun s -> let u, v = ends s in edge u v) c.domain_part.segments) in
  let renamed = compare_segments places corners expected domain source in
  (* Each polygon by its segments: of those with the same, by its hole points. *)
  let left = Hashtbl.create 64 in
  List.iter (fun (f : polygon_entry) ->
      let above = Array.of_list f.above in
      let up k = above.(k) - 1 in
      let rim = Edges.of_list (List.map (fun s -> let u, v = ends s in edge (up u) (up v)) f.plane_part.segments) in
      let gaps = List.map (fun (site, w) -> place_of mesh.unit site w) f.seeds in
      let around = List.map (fun k -> places.(k - 1)) f.above in
      Hashtbl.add left (Edges.elements rim) (gaps, around)) c.polygons;
  List.iter (fun (polygon : polygon) ->
      let rim = Edges.elements (Edges.map renamed polygon.rim) in
      match Hashtbl.find_opt left rim with
      | None -> differs_at polygon.line "found a polygon that is none of the certificate's domain"
      | Some (gaps, around) ->
        Hashtbl.remove left rim;
        if without gaps polygon.gaps <> [] ||
           not (List.for_all (beyond around) (without polygon.gaps gaps)) then
          differs_at polygon.line "found a polygon with other holes") domain.polygons;
  if Hashtbl.length left > 0 then
    differs source "expected %d polygons, found %d" (List.length c.polygons) (List.length domain.polygons);
  (* A convex hull has no holes. *)
  if c.kind = Enclosed then begin
    let expected = List.map (fun h -> place_of mesh.unit h.hole_point h.hole_w) c.domain_part.holes in
    let found = List.map fst domain.holes in
    let around = Array.to_list places in
    List.iter (fun (place, line) ->
        if not (List.exists (same_place place) expected || beyond around place) then
          differs_at line "found the hole point (%s), which is none of the certificate's domain" (shown place))
      domain.holes;
    match without expected found with
    | [] -> ()
    | place :: _ -> differs source "expected the hole point (%s), found none" (shown place)
  end
