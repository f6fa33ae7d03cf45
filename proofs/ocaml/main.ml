(* circumspect-verified FILE: checks a certificate or a refutation, prints one line.
   Exit: 0 verified, 1 rejected, 2 usage, 3 malformed or unreadable. *)
open Extracted

let usage = "usage: circumspect-verified FILE   (a certificate or refutation that `circumspect \
certify` wrote; `-` is standard input)"

let read_all channel =
  let buffer = Buffer.create 65536 in
  let chunk = Bytes.create 65536 in
  let rec go () =
    let n = input channel chunk 0 (Bytes.length chunk) in
    if n > 0 then (Buffer.add_subbytes buffer chunk 0 n; go ()) in
  go ();
  Buffer.contents buffer

let read_file name =
  if name = "-" then (set_binary_mode_in stdin true; read_all stdin)
  else begin
    let channel = open_in_bin name in
    Fun.protect ~finally:(fun () -> close_in_noerr channel) (fun () -> read_all channel)
  end

let condition = function
  | Scale -> "scale" | Points_increasing -> "points-increasing" | Point_used -> "point-used"
  | Vertex_known -> "vertex-known" | Simplex_positive -> "simplex-positive"
  | Facet_matched -> "facet-matched" | Back_pointer -> "back-pointer"
  | Hull_pointer -> "hull-pointer" | Ridge_matched -> "ridge-matched"
  | Ridge_back_pointer -> "ridge-back-pointer" | Hull_locally_convex -> "hull-locally-convex"
  | Sample_inside -> "sample-inside" | Sample_outside -> "sample-outside"
  | Sample_inside_hull -> "sample-inside-hull"
  | Facet_locally_delaunay -> "facet-locally-delaunay"

let place =
  let n numeral = Big.to_string (Big.of_numeral numeral) in
  function
  | Nowhere -> ""
  | AtPoint k -> ", point " ^ n k
  | AtSimplex t -> ", simplex " ^ n t
  | AtFacet (t, i) -> Printf.sprintf ", simplex %s, facet %d" (n t) i
  | AtHull h -> ", hull facet " ^ n h
  | AtRidge (h, a) -> Printf.sprintf ", hull facet %s, ridge %d" (n h) a

let claims =
  [ "triangulation", Triangulation; "delaunay", Delaunay; "weighted-delaunay", WeightedDelaunay ]

(* CLAIM and D of the first line. *)
let context source claim dimension =
  let claimed = match List.assoc_opt claim claims with
    | Some claimed -> claimed
    | None ->
      Text.fail source "triangulation, delaunay or weighted-delaunay" (Text.quote claim) in
  let space, d = match dimension with
    | "2" -> (Plane, 2)
    | "3" -> (Space, 3)
    | _ -> Text.fail source "the dimension, 2 or 3" (Text.quote dimension) in
  ({ Reading.source; numeral = Reading.numerals source; d; weighted = claimed = WeightedDelaunay },
   claimed, space)

let counts d points simplices =
  Printf.sprintf "%d points, %d %s" points simplices (if d = 2 then "triangles" else "tetrahedra")

(* The line to print, and the exit code. *)
let verdict source =
  let first = "'circumspect-certificate 1 CLAIM D' or 'circumspect-refutation 1 CLAIM D RULE'" in
  match Text.next_of source first with
  | [ "circumspect-certificate"; "1"; claim; dimension ] ->
    let c, claimed, space = context source claim dimension in
    let certificate = Certificate_file.read c claimed in
    (match check space certificate with
     | Accepted ->
       (Printf.sprintf "verified: %s, %s" claim
          (counts c.d (List.length certificate.points) (List.length certificate.simplices)), 0)
     | Rejected (why, where) -> ("rejected: " ^ condition why ^ place where, 1))
  | [ "circumspect-refutation"; "1"; claim; dimension; rule ] ->
    let c, claimed, space = context source claim dimension in
    let refutation = Refutation_file.read c claimed rule in
    if refute space refutation then
      (Printf.sprintf "verified: not %s, %s" claim rule, 0)
    else ("rejected: the evidence does not show " ^ rule, 1)
  | tokens -> Text.fail source first (Text.quote (String.concat " " tokens))

let () =
  (* Little of what is read becomes garbage: collect seldom. *)
  Gc.set { (Gc.get ()) with Gc.space_overhead = 400; minor_heap_size = 1 lsl 20 };
  let name = match Sys.argv with
    | [| _; ("-h" | "--help") |] -> print_endline usage; exit 0
    | [| _; name |] -> name
    | _ -> prerr_endline usage; exit 2 in
  let malformed message = (Printf.sprintf "malformed: %s%s" name message, 3) in
  let line, code =
    match verdict (Text.of_string (read_file name)) with
    | result -> result
    | exception Text.Malformed (line, message) -> malformed (Printf.sprintf ":%d: %s" line message)
    | exception Sys_error message -> (Printf.sprintf "malformed: cannot read %s" message, 3)
    | exception Out_of_memory -> malformed ": too large for the memory of this machine"
    | exception Stack_overflow -> malformed ": a line is too long for the stack" in
  print_endline line;
  exit code
