(* The user's own DOMAIN.poly, as Triangle and TetGen write it (docs/formats.md decides the grey zones), held against
   the domain that a certificate is about: the same vertices, by their exact coordinates, and between them the same
   segments, polygons, each with its own segments and hole points, and the same hole points. *)
open Extracted
open Numbered_rows
open Users_mesh

type place = Q.t list
type edge = int * int  (* of the vertices, the smaller first *)
module Edges = Set.Make (struct type t = edge let compare = compare end)

type points = (place * int) list * int * Big.t  (* with their lines; the dimension, and the index of the first *)
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
let list_header source expected =
  let given = header source expected 1 2 in
  markers source given.(1);
  (given.(0), given.(1))

let repeated n read = List.rev (let rec go n found = if n = 0 then found else go (n - 1) (read () :: found) in go n [])
let any_index source token = ignore (integer64_of source token : Big.t)

(* The points, or nothing if they are in a file of their own; the index of the first. *)
let listed_points ~exactly ~least source : points =
  let given = header source "'POINTS DIMENSION [ATTRIBUTES [MARKERS]]'" least 4 in
  let n = given.(0) and d = given.(1) in
  if n > 0 && d <> 2 && d <> 3 then Text.fail source "points of dimension 2 or 3" (string_of_int d);
  markers source given.(3);
  let first = ref Big.zero and found = ref [] in
  rows source "point" n (fun index ->
      if !found = [] then first := index;
      let coordinate _ = number ~exactly source (Text.token source "a coordinate") in
      let place = List.init d coordinate in
      skip_numbers ~exactly source given.(2);
      skip_markers source given.(3);
      found := (place, source.Text.line) :: !found);
  (List.rev !found, d, !first)
let points ~exactly source =
  let found = listed_points ~exactly ~least:2 source in
  end_of_file source;
  found

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
  let v = Big.sub (integer64_of source token) first in
  if Big.sign v < 0 || Big.geq v (Big.of_int count) then Text.fail source "a vertex of the file" (Text.quote token);
  Big.to_int v

(* A facet: a polygon, or if it has no area the segments that it lists. *)
let facet ~exactly source markers first count =
  let expected = "'POLYGONS [HOLES [MARKER]]'" in
  let tokens = Text.next_of source expected in
  let line = source.line in
  let counted i = match List.nth_opt tokens i with
    | Some token when Text.is_integer token && token.[0] <> '-' -> Text.count source token
    | None when i = 1 -> 0
    | _ -> Text.fail source expected "other numbers" in
  let lines_listed = counted 0 and gaps_listed = counted 1 in
  if lines_listed = 0 then Text.fail source "a facet of at least 1 polygon" "0";
  if List.length tokens > 2 + markers then Text.fail source expected "more numbers";
  List.iteri (fun i token -> if i = 2 then any_index source token) tokens;
  let polygon () =
    let tokens = Text.next_of source "a polygon" in
    let n = Text.count source (List.hd tokens) in
    if n = 0 then Text.fail source "a polygon of at least 1 corner" "0";
    let rec corners found left tokens =
      match tokens with
      | [] when left = 0 -> List.rev found
      | [] -> corners found left (Text.next_of source "corners of a polygon")
      | token :: _ when left = 0 -> Text.fail source "the end of the line" (Text.quote token)
      | token :: rest -> corners (vertex source first count token :: found) (left - 1) rest in
    without_repetitions (corners [] n (List.tl tokens)) in
  let lines = repeated lines_listed polygon in
  let gap () =
    let tokens = Text.next_of source "a hole of a facet" in
    if List.length tokens <> 4 then Text.fail source "4 columns" (string_of_int (List.length tokens));
    any_index source (List.hd tokens);
    coordinates ~exactly source 3 (List.tl tokens) in
  let gaps = repeated gaps_listed gap in
  let rim = Edges.of_list (List.concat_map edges_of_line lines) in
  let has_area = List.exists (fun line -> List.length line > 2) lines || gaps <> [] || has_cycle rim in
  (rim, if has_area then Some { rim; gaps; line } else None)

let segment source markers first count =
  match Text.next_of source "a segment" with
  | index :: u :: v :: rest when List.length rest = markers ->
    any_index source index;
    List.iter (any_index source) rest;
    let e = edge (vertex source first count u) (vertex source first count v) in
    if fst e = snd e then Text.fail source "another end than the first" (Text.quote v);
    (e, source.Text.line)
  | tokens -> Text.fail source (string_of_int (3 + markers) ^ " columns") (string_of_int (List.length tokens))
let hole ~exactly source d =
  let tokens = Text.next_of source "a hole" in
  if List.length tokens <> 1 + d then
    Text.fail source (string_of_int (1 + d) ^ " columns") (string_of_int (List.length tokens));
  any_index source (List.hd tokens);
  (coordinates ~exactly source d (List.tl tokens), source.Text.line)
(* Regions give attributes to the elements of a mesh. *)
let region ~exactly source d =
  let tokens = Text.next_of source "a region" in
  let n = List.length tokens in
  if n <> 2 + d && n <> 3 + d then
    Text.fail source (Printf.sprintf "%d or %d columns" (2 + d) (3 + d)) (string_of_int n);
  any_index source (List.hd tokens);
  List.iter (fun token -> ignore (number ~exactly source token : Q.t)) (List.tl tokens)

let read ~exactly points_elsewhere source =
  let own, announced, first = listed_points ~exactly ~least:1 source in
  let vertices, d, first = if own <> [] then (own, announced, first) else points_elsewhere () in
  if announced <> 0 && d <> announced then
    Text.fail source (Printf.sprintf "points of dimension %d" announced) (Printf.sprintf "dimension %d" d);
  let count = List.length vertices in
  let n, markers = list_header source (if d = 2 then "'SEGMENTS [MARKERS]'" else "'FACETS [MARKERS]'") in
  let segments, polygons =
    if d = 2 then (repeated n (fun () -> segment source markers first count), [])
    else
      let facets = repeated n (fun () ->
          let found = facet ~exactly source markers first count in (found, source.Text.line)) in
      (List.concat_map (fun ((rim, _), line) -> List.map (fun e -> (e, line)) (Edges.elements rim)) facets,
       List.filter_map (fun ((_, polygon), _) -> polygon) facets) in
  let list_of read = match Text.next source with
    | None -> None
    | Some [ n ] -> Some (repeated (Text.count source n) read)
    | Some tokens -> Text.fail source "a number" (Text.quote (String.concat " " tokens)) in
  let holes = match list_of (fun () -> hole ~exactly source d) with
    | Some holes -> holes
    | None when d = 2 -> Text.fail source "the number of holes" "the end of the file"
    | None -> [] in
  let _ = list_of (fun () -> region ~exactly source d) in
  end_of_file source;
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
let compare_refuted (c : domain_refutation) points_elsewhere ~further_holes:_ ~exactly source =
  let domain = read ~exactly points_elsewhere source in
  let scale = (c.mesh_refuted.unit_numerator, c.mesh_refuted.unit_denominator) in
  let places = Array.of_list (List.map (fun site -> place_of scale site Big.one) c.vertices_given) in
  let n = Array.length places in
  let expected = Edges.of_list (List.map (fun (j, k) ->
      if j > n || k > n then differs source "expected %d vertices, found a segment with another" n;
      edge (j - 1) (k - 1)) c.segments_given) in
  ignore (compare_segments places (List.init n Fun.id) expected domain source : edge -> edge)

let compare_domain mesh (c : domain_certificate) points_elsewhere ~further_holes ~exactly source =
  let domain = read ~exactly points_elsewhere source in
  let domain = { domain with holes = domain.holes @ List.map (fun hole -> (hole, 0)) further_holes } in
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
