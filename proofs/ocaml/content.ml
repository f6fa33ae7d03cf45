(* What a certificate, a refutation or a proof of impossibility is about, told by its first line; and what checking it says. *)
open Extracted
open Names

(* CLAIM and D of the first line. *)
let context source claims claim dimension =
  let claimed = match List.assoc_opt claim claims with
    | Some claimed -> claimed
    | None -> Text.fail source (String.concat " or " (complex :: convex_hull :: surface_delaunay :: periodic_delaunay :: List.map fst claims)) (Text.quote claim) in
  let space, d = match dimension with
    | "2" -> (Plane, 2)
    | "3" -> (Space, 3)
    | _ -> Text.fail source "the dimension, 2 or 3" (Text.quote dimension) in
  ({ Reading.source; d; weighted = claim = claim_name WeightedDelaunay;
     labels = Reading.no_labels source },
   claimed, space)

let counted n one several = Printf.sprintf "%d %s" n (if n = 1 then one else several)

let counts d points simplices =
  counted points "point" "points" ^ ", "
  ^ (if d = 2 then counted simplices "triangle" "triangles"
     else counted simplices "tetrahedron" "tetrahedra")

(* What a file is about, and what checking it says: the line to print, and the exit code. *)
type content = {
  mesh : Users_mesh.mesh Lazy.t;
  (* With a user's file, and hole points that it does not list. *)
  compare_domain : ((unit -> Users_domain.points) -> further_holes:Users_domain.place list -> exactly:bool -> Text.t -> unit) option;
  verdict : unit -> string * int }

(* Beyond the claim: is it the only such triangulation, or the canonical one? The first is both. *)
let standings = [ "unique", (Unique, ", unique, canonical"); "canonical", (Canonical, ", canonical") ]

let certificate (c : Reading.context) space claimed standing =
  let packed, labels = Certificate_file.read c claimed in
  let frame = packed.frame in
  (* What follows does not keep the context, which has the text of the file. *)
  let d = c.d and weighted = c.weighted in
  let mesh = lazy (
    let vertices k = List.map Option.some (corners_of space packed.rows_of (k + 1)) in
    { Users_mesh.unit = (frame.numerator, frame.denominator); d;
      weighted; labels = Array.of_list labels; ordered = false;
      sites = Array.of_list (List.rev (List.rev_map (fun e -> e.position) frame.points));
      simplices = { count = packed.simplex_count; vertices; attributes = None }; dangling = None; cyclic = false }) in
  let verdict () =
    let asked = Option.map (fun word -> fst (List.assoc word standings)) standing in
    match judge space packed asked (Certificate_file.digits_left_out frame) with
    | Fails (why, where) -> ("rejected: " ^ condition why ^ place where, 1)
    | NotSettled where -> ("rejected: " ^ Option.get standing ^ place where, 1)
    | Holds ->
      (Printf.sprintf "verified: %s, %s%s" (claim_name frame.claimed)
         (counts d (List.length frame.points) packed.simplex_count)
         (Option.fold standing ~none:"" ~some:(fun word -> snd (List.assoc word standings))), 0) in
  { mesh; compare_domain = None; verdict }

(* The boundary of the hull of the points but the summit: its facets make the simplices, each with the summit. *)
let hull (c : Reading.context) space cones =
  let packed, labels, summit, around = Certificate_file.read_hull c cones in
  let frame = packed.frame in
  let vertices k =
    List.filter_map (fun v -> if v = summit then None else Some (Some v)) (corners_of space packed.rows_of (k + 1)) in
  let mesh = lazy { Users_mesh.unit = (frame.numerator, frame.denominator); d = c.d; weighted = false;
                    labels = Array.of_list labels; ordered = false;
                    sites = Array.of_list (List.rev (List.rev_map (fun e -> e.position) frame.points));
                    simplices = { count = packed.simplex_count; vertices; attributes = None }; dangling = None; cyclic = c.d = 2 } in
  let verdict () = match judge_hull space packed summit around (Certificate_file.digits_left_out frame) with
    | Fails (why, where) -> ("rejected: " ^ condition why ^ place where, 1)
    | NotSettled _ -> assert false
    | Holds ->
      let one, several = if c.d = 2 then ("edge", "edges") else ("triangle", "triangles") in
      (Printf.sprintf "verified: %s, %s, %s" convex_hull
         (counted (List.length frame.points - 1) "point" "points") (counted packed.simplex_count one several), 0) in
  { mesh; compare_domain = None; verdict }

(* Points of a plane in space, and triangles there: the certificate is about their picture. *)
let flat (c : Reading.context) name seen =
  let packed, labels, unseen = Certificate_file.read_flat c seen in
  let frame = packed.frame in
  let vertices k = List.map Option.some (corners_of Plane packed.rows_of (k + 1)) in
  let site e z = with_unseen unseen.unseen_axis e.position z in
  let mesh = lazy { Users_mesh.unit = (frame.numerator, frame.denominator); d = 3; weighted = false;
                    labels = Array.of_list labels; ordered = false;
                    sites = Array.map2 site (Array.of_list frame.points) (Array.of_list unseen.unseen);
                    simplices = { count = packed.simplex_count; vertices; attributes = None }; dangling = None; cyclic = false } in
  let verdict () = match judge_flat packed unseen (Certificate_file.digits_left_out frame) with
    | Fails (why, where) -> ("rejected: " ^ condition why ^ place where, 1)
    | NotSettled _ -> assert false
    | Holds -> (Printf.sprintf "verified: %s, %s, in one plane" name
                  (counts 2 (List.length frame.points) packed.simplex_count), 0) in
  { mesh; compare_domain = None; verdict }

(* Points on a line, and the edges between neighbours; or one point, and its simplex. *)
let line (c : Reading.context) space name =
  let certificate, labels = Line_file.read c in
  let rows = Array.of_list certificate.line_rows in
  let vertices k = List.map Option.some rows.(k) in
  let mesh = lazy { Users_mesh.unit = (certificate.line_numerator, certificate.line_denominator); d = c.d; weighted = false;
                    labels = Array.of_list labels; ordered = false; sites = Array.of_list certificate.line_sites;
                    simplices = { count = Array.length rows; vertices; attributes = None }; dangling = None; cyclic = false } in
  let verdict () = match check_line space certificate with
    | Rejected (why, where) -> ("rejected: " ^ condition why ^ place where, 1)
    | Accepted ->
      let points = List.length labels in
      let simplices, where = if points = 1 then (counted 1 "vertex" "vertices", "in one place")
        else (counted (Array.length rows) "edge" "edges", "on one line") in
      (Printf.sprintf "verified: %s, %s, %s, %s" name (counted points "point" "points") simplices where, 0) in
  { mesh; compare_domain = None; verdict }

(* A mesh alone: its simplices may be of any dimension. *)
let mesh_alone (c : Reading.context) space ~unused_allowed =
  let certificate, labels = Complex_file.read c in
  let width = Reading.of_natural certificate.complex_dimension + 1 in
  let cells = Array.of_list certificate.complex_cells in
  let vertices k = List.map Option.some cells.(k).cell_vertices in
  let mesh = { Users_mesh.unit = (certificate.complex_numerator, certificate.complex_denominator); d = c.d;
               weighted = false; labels = Array.of_list labels; ordered = false;
               sites = Array.of_list (List.rev (List.rev_map (fun e -> e.position) certificate.complex_points));
               simplices = { count = Array.length cells; vertices; attributes = None }; dangling = None; cyclic = false } in
  let one, several = match width with
    | 1 -> ("point", "points") | 2 -> ("edge", "edges") | 3 -> ("triangle", "triangles")
    | _ -> ("tetrahedron", "tetrahedra") in
  let verdict () = match (if unused_allowed then check_some_unused else check_alone) space certificate with
    | Rejected (why, where) -> ("rejected: " ^ condition why ^ place where, 1)
    | Accepted ->
      let unused = List.length (List.filter (fun (e : point_entry) -> e.home_vertex = None) certificate.complex_points) in
      (Printf.sprintf "verified: %s, %s, %s%s" complex (counted (List.length labels) "point" "points")
         (counted (Array.length cells) one several)
         (if unused_allowed then Printf.sprintf ", %d unused" unused else ""), 0) in
  { mesh = lazy mesh; compare_domain = None; verdict }

(* Triangles, in the plane or in space, and the angles at their edges. *)
let surface (c : Reading.context) space =
  let certificate, labels = Surface_file.read c in
  let triangles = Array.of_list certificate.surface_triangles in
  let vertices k = List.map Option.some triangles.(k).triangle_vertices in
  let mesh = { Users_mesh.unit = (certificate.surface_numerator, certificate.surface_denominator); d = c.d;
               weighted = false; labels = Array.of_list labels; ordered = false;
               sites = Array.of_list (List.rev (List.rev_map (fun e -> e.position) certificate.surface_points));
               simplices = { count = Array.length triangles; vertices; attributes = None }; dangling = None; cyclic = false } in
  let verdict () = match check_surface space certificate with
    | Rejected (why, where) -> ("rejected: " ^ condition why ^ place where, 1)
    | Accepted ->
      (Printf.sprintf "verified: %s, %s" surface_delaunay (counts 2 (List.length labels) (Array.length triangles)), 0) in
  { mesh = lazy mesh; compare_domain = None; verdict }

(* Cells that a lattice repeats. *)
let periodic (c : Reading.context) labels m is_right words =
  let verdict () = match is_right () with
    | Some rejected -> ("rejected: " ^ rejected, 1)
    | None ->
      (Printf.sprintf "verified: %s; lattice: %s" (words (counts c.d (List.length labels) (List.length m.cells)))
         (Periodic_file.vectors m), 0) in
  { mesh = lazy (Periodic_file.users_mesh c.d labels m); compare_domain = None; verdict }

let periodic_certificate (c : Reading.context) space =
  let certificate, labels = Periodic_file.read c in
  periodic c labels certificate.periodic_mesh_of (fun () -> match check_periodic space certificate with
      | Accepted -> None
      | Rejected (why, where) -> Some (condition why ^ place where))
    (fun counted -> periodic_delaunay ^ ", " ^ counted)

let periodic_refutation (c : Reading.context) space rule =
  let refutation, labels = Periodic_file.read_refutation c rule in
  let rule = periodic_rule_name refutation.periodic_because in
  periodic c labels refutation.periodic_against
    (fun () -> if refute_periodic space refutation then None else Some ("the evidence does not show " ^ rule))
    (fun _ -> Printf.sprintf "not %s, %s" periodic_delaunay rule)

let how_many_dangle faces = match List.length faces with
  | 0 -> ""
  | n -> counted n "dangling face" "dangling faces" ^ "; "

(* Which kind a domain is, and how much it has of what. *)
let described (c : domain_certificate) ~is_complex =
  let part = c.domain_part in
  let vertices = List.length (List.filter (function Corner _ -> true | Steiner _ -> false) part.roles) in
  let some n one several = if n = 0 then "" else ", " ^ counted n one several in
  Printf.sprintf "domain: %s, %s%s%s%s%s" (fst (List.find (fun (_, k) -> k = c.kind) kinds))
    (if is_complex then "plc, " else "")
    (counted vertices "vertex" "vertices")
    (some (List.length part.segments) "segment" "segments")
    (some (List.length c.polygons) "polygon" "polygons")
    (some (List.length part.holes) "hole" "holes")

(* Of the steps along segments and the pieces of polygons those that are faces of no other simplex. *)
let faces_that_dangle (c : domain_certificate) simplices =
  let rec steps u = function
    | [] -> []
    | link :: links -> [ u; link.reached ] :: steps link.reached links in
  let pieces (f : polygon_entry) =
    let above = Array.of_list f.above in
    let named k = if k >= 1 && k <= Array.length above then Some above.(k - 1) else None in
    let rec kept (simplices : simplex_entry list) (marks : mark list) = match simplices, marks with
      | e :: simplices, mark :: marks ->
        (if mark.kept then [ List.filter_map named e.corners ] else []) @ kept simplices marks
      | _, _ -> [] in
    kept f.plane_mesh.simplices f.plane_part.marks in
  let module Faces = Users_mesh.Faces in
  let sorted = List.map (List.sort_uniq compare) in
  let pieces = Faces.of_list (sorted (List.concat_map pieces c.polygons)) in
  let steps = Faces.of_list (sorted (List.concat_map (fun s -> steps s.from s.links) c.domain_part.segments)) in
  let without = List.fold_left (fun left simplex ->
      List.fold_left (fun left face -> Faces.remove face left) left
        (Users_mesh.faces_of (List.sort_uniq compare simplex))) in
  let pieces = without pieces simplices in
  Faces.elements pieces @ Faces.elements (without (without steps simplices) (Faces.elements pieces))

(* The mesh is that of the kept simplices, and of what dangles.  The whole mesh may be said to be Delaunay. *)
let domain ?(is_delaunay = false) (c : Reading.context) space claimed kind ~is_complex ~dangles =
  let certificate, complex, labels = Domain_file.read c claimed kind ~is_complex ~is_delaunay in
  let whole = certificate.whole_mesh and part = certificate.domain_part in
  let rec kept_of found simplices marks = match simplices, marks with
    | (e : simplex_entry) :: simplices, (mark : mark) :: marks ->
      kept_of (if mark.kept then e.corners :: found else found) simplices marks
    | _, _ -> List.rev found in
  let kept = kept_of [] whole.simplices part.marks in
  let named = List.map (List.map Option.some) in
  let simplices = named kept in
  let dangling = lazy (if dangles then named (faces_that_dangle certificate kept) else []) in
  let mesh = { Users_mesh.unit = (whole.numerator, whole.denominator); d = c.d; weighted = false;
               labels = Array.of_list labels; ordered = false;
               sites = Array.of_list (List.rev (List.rev_map (fun e -> e.position) whole.points));
               simplices = Users_mesh.listed simplices; dangling = Some []; cyclic = false } in
  let check = if dangles then check_dangling else check_domain in
  let checked () = match check space certificate, complex with
    | Accepted, Some complex -> check_complex space certificate complex
    | result, _ -> result in
  let verdict () = match checked () with
    | Rejected (why, where) -> ("rejected: " ^ condition why ^ place where, 1)
    | Accepted ->
      (Printf.sprintf "verified: %s, %s; %s%s" (domain_claim_name claimed)
         (counts c.d (Users_mesh.users_points mesh) (List.length simplices))
         (how_many_dangle (Lazy.force dangling)) (described certificate ~is_complex), 0) in
  { mesh = lazy { mesh with dangling = Some (Lazy.force dangling); cyclic = false };
    compare_domain = Some (Users_domain.compare_domain mesh certificate); verdict }

(* The points of a domain that is given without a mesh: its vertices. *)
let vertices_of d (about : domain_certificate) =
  let whole = about.whole_mesh in
  let sites = Array.of_list (List.map (fun e -> e.position) whole.points) in
  { Users_mesh.unit = (whole.numerator, whole.denominator); d; weighted = false;
    labels = Array.init (Array.length sites) (fun k -> Some (Big.of_int k)); ordered = false; sites;
    simplices = Users_mesh.listed []; dangling = None; cyclic = false }

let impossibility (c : Reading.context) claimed kind =
  let impossibility = Impossibility_file.read c claimed kind in
  let about = impossibility.about in
  let mesh = vertices_of c.d about in
  let verdict () = match check_impossible impossibility with
    | Rejected (why, where) -> ("rejected: " ^ condition why ^ place where, 1)
    | Accepted ->
      ((if claimed = Cdt then "verified: no CDT" else "verified: no triangulation") ^ " without Steiner points; " ^ described about ~is_complex:false, 0) in
  { mesh = lazy mesh; compare_domain = Some (Users_domain.compare_domain mesh about); verdict }

let refutation (c : Reading.context) space claimed rule =
  let refutation, labels = Refutation_file.read c claimed rule in
  let mesh = { Users_mesh.unit = (refutation.unit_numerator, refutation.unit_denominator); d = c.d;
               weighted = c.weighted; labels = Array.of_list labels; ordered = true;
               sites = Array.of_list refutation.sites;
               simplices = Users_mesh.listed refutation.rows; dangling = None; cyclic = false } in
  let verdict () =
    let rule = rule_name (rule_of refutation.because) in
    if refute space refutation then
      (Printf.sprintf "verified: not %s, %s" (claim_name refutation.refuted) rule, 0)
    else ("rejected: the evidence does not show " ^ rule, 1) in
  { mesh = lazy mesh; compare_domain = None; verdict }

(* A refutation whose mesh is [about], by a function that says whether it is accepted. *)
let refutation_of_mesh d labels (about : refutation) name rule is_accepted =
  let mesh = { Users_mesh.unit = (about.unit_numerator, about.unit_denominator); d; weighted = false;
               labels = Array.of_list labels; ordered = true; sites = Array.of_list about.sites;
               simplices = Users_mesh.listed about.rows; dangling = None; cyclic = false } in
  let verdict () =
    if is_accepted () then (Printf.sprintf "verified: not %s, %s" name rule, 0)
    else ("rejected: the evidence does not show " ^ rule, 1) in
  { mesh = lazy mesh; compare_domain = None; verdict }

let flat_refutation (c : Reading.context) space claimed rule =
  let refutation, labels = Refutation_file.read_flat c claimed rule in
  refutation_of_mesh c.d labels refutation.flat_mesh (claim_name claimed)
    (rule_name (rule_of refutation.flat_mesh.because)) (fun () -> refute_flat space refutation)

let hull_refutation (c : Reading.context) space rule =
  let refutation, labels = Refutation_file.read_hull c rule in
  refutation_of_mesh c.d labels refutation.hull_mesh convex_hull (hull_rule_name refutation.hull_because)
    (fun () -> refute_hull space refutation)

let surface_rule = "surface.edge-not-delaunay"
let surface_refutation (c : Reading.context) space =
  let refutation, labels = Refutation_file.read_surface c in
  refutation_of_mesh c.d labels refutation.surface_mesh surface_delaunay surface_rule
    (fun () -> refute_surface space refutation)

let alone_refutation (c : Reading.context) space rule =
  let refutation, labels = Refutation_file.read_alone c rule in
  refutation_of_mesh c.d labels refutation.mesh_alone complex
    (rule_of_complex_name (complex_rule_of refutation)) (fun () -> refute_alone space refutation)

(* The triangles and edges that may be faces of no simplex. *)
let own_rows part = List.rev (List.rev_map fst part.dangling)
let domain_refutation (c : Reading.context) space claimed rule =
  let refutation, labels = Refutation_file.read_domain c claimed rule in
  let about = refutation.mesh_refuted in
  let mesh = { Users_mesh.unit = (about.unit_numerator, about.unit_denominator); d = c.d; weighted = false;
               labels = Array.of_list labels; ordered = true; sites = Array.of_list about.sites;
               simplices = Users_mesh.listed about.rows; dangling = Some (own_rows refutation.dangling_refuted); cyclic = false } in
  let verdict () =
    let rule = domain_rule_name (domain_rule_of refutation) in
    if refute_domain space refutation then
      (Printf.sprintf "verified: not %s, %s; %sdomain: %s, %s" (domain_claim_name claimed) rule
         (how_many_dangle refutation.dangling_refuted.dangling)
         (counted (List.length refutation.vertices_given) "vertex" "vertices")
         (counted (List.length refutation.segments_given) "segment" "segments"), 0)
    else ("rejected: the evidence does not show " ^ rule, 1) in
  { mesh = lazy mesh; compare_domain = Some (Users_domain.compare_refuted refutation); verdict }

let whole_refutation (c : Reading.context) space claimed rule kind =
  let refutation, labels = Refutation_file.read_whole c claimed rule kind in
  let against = refutation.mesh_against and about = refutation.about_domain in
  let mesh = { Users_mesh.unit = (against.unit_numerator, against.unit_denominator); d = c.d; weighted = false;
               labels = Array.of_list labels; ordered = true; sites = Array.of_list against.sites;
               simplices = Users_mesh.listed against.rows; dangling = Some (own_rows refutation.dangling_against); cyclic = false } in
  let verdict () =
    let rule = domain_rule_name (whole_rule_of refutation) in
    if refute_whole space refutation then
      (Printf.sprintf "verified: not %s, %s; %s%s" (domain_claim_name claimed) rule
         (how_many_dangle refutation.dangling_against.dangling) (described about ~is_complex:false), 0)
    else ("rejected: the evidence does not show " ^ rule, 1) in
  { mesh = lazy mesh; compare_domain = Some (Users_domain.compare_domain (vertices_of c.d about) about); verdict }

let read source =
  let first = "'circumspect-certificate 1 CLAIM D [unique or canonical, or enclosed or hull [plc, or dangling [delaunay]]]' or 'circumspect-refutation 2 CLAIM D RULE [enclosed or hull or flat]' or 'circumspect-impossibility 2 plc-triangulation or cdt 3 enclosed or hull'" in
  match Text.next_of source first with
  | [ "circumspect-certificate"; "1"; claim; dimension ] when claim = complex ->
    let c, (), space = context source [ (complex, ()) ] claim dimension in
    mesh_alone c space ~unused_allowed:false
  | [ "circumspect-certificate"; "1"; claim; dimension; "unused" ] when claim = complex ->
    let c, (), space = context source [ (complex, ()) ] claim dimension in
    mesh_alone c space ~unused_allowed:true
  | [ "circumspect-certificate"; "1"; claim; dimension ] when claim = surface_delaunay ->
    let c, (), space = context source [ (surface_delaunay, ()) ] claim dimension in
    surface c space
  | [ "circumspect-certificate"; "1"; claim; dimension ] when claim = periodic_delaunay ->
    let c, (), space = context source [ (periodic_delaunay, ()) ] claim dimension in
    periodic_certificate c space
  | [ "circumspect-certificate"; "1"; claim; dimension; cones ] when claim = convex_hull ->
    let c, claimed, space = context source claims cones dimension in
    hull c space claimed
  | [ "circumspect-certificate"; "1"; "triangulation"; "3"; "flat" ] ->
    let c, seen, _ = context source claims "triangulation" "2" in
    flat c "triangulation" seen
  | [ "circumspect-certificate"; "1"; "delaunay"; "3"; "flat" ] ->
    let c, seen, _ = context source claims "weighted-delaunay" "2" in
    flat c "delaunay" seen
  | [ "circumspect-certificate"; "1"; ("triangulation" | "delaunay" as claim); dimension; "line" ] ->
    let c, _, space = context source claims claim dimension in
    line c space claim
  | [ "circumspect-certificate"; "1"; claim; dimension ] ->
    let c, claimed, space = context source claims claim dimension in
    certificate c space claimed None
  | [ "circumspect-certificate"; "1"; claim; dimension; standing ]
    when List.mem_assoc standing standings ->
    let c, claimed, space = context source claims claim dimension in
    certificate c space claimed (Some standing)
  | [ "circumspect-certificate"; "1"; claim; dimension; kind ] when List.mem_assoc kind kinds ->
    let c, claimed, space = context source domain_claims claim dimension in
    domain c space claimed (List.assoc kind kinds) ~is_complex:false ~dangles:false
  | [ "circumspect-certificate"; "1"; claim; dimension; kind; "dangling" ] when List.mem_assoc kind kinds ->
    let c, claimed, space = context source domain_claims claim dimension in
    domain c space claimed (List.assoc kind kinds) ~is_complex:false ~dangles:true
  | [ "circumspect-certificate"; "1"; claim; dimension; kind; "dangling"; "delaunay" ] when List.mem_assoc kind kinds ->
    let c, claimed, space = context source domain_claims claim dimension in
    domain c space claimed (List.assoc kind kinds) ~is_delaunay:true ~is_complex:false ~dangles:true
  | [ "circumspect-certificate"; "1"; claim; dimension; kind; "plc" ] when List.mem_assoc kind kinds ->
    let c, claimed, space = context source domain_claims claim dimension in
    domain c space claimed (List.assoc kind kinds) ~is_complex:true ~dangles:false
  | [ "circumspect-refutation"; "2"; claim; dimension; rule ] when claim = complex ->
    let c, (), space = context source [ (complex, ()) ] claim dimension in
    alone_refutation c space rule
  | [ "circumspect-refutation"; "2"; claim; dimension; rule ] when claim = convex_hull ->
    let c, (), space = context source [ (convex_hull, ()) ] claim dimension in
    hull_refutation c space rule
  | [ "circumspect-refutation"; "2"; claim; dimension; rule ] when claim = surface_delaunay && rule = surface_rule ->
    let c, (), space = context source [ (surface_delaunay, ()) ] claim dimension in
    surface_refutation c space
  | [ "circumspect-refutation"; "2"; claim; dimension; rule ] when claim = periodic_delaunay ->
    let c, (), space = context source [ (periodic_delaunay, ()) ] claim dimension in
    periodic_refutation c space rule
  | [ "circumspect-refutation"; "2"; ("triangulation" | "delaunay" as claim); dimension; rule; "flat" ] ->
    let c, claimed, space = context source claims claim dimension in
    flat_refutation c space claimed rule
  | [ "circumspect-refutation"; "2"; claim; dimension; rule ] when List.mem_assoc claim domain_claims ->
    let c, claimed, space = context source domain_claims claim dimension in
    domain_refutation c space claimed rule
  | [ "circumspect-refutation"; "2"; claim; dimension; rule; kind ]
    when List.mem_assoc claim domain_claims && List.mem_assoc kind kinds ->
    let c, claimed, space = context source domain_claims claim dimension in
    whole_refutation c space claimed rule (List.assoc kind kinds)
  | [ "circumspect-refutation"; "2"; claim; dimension; rule ] ->
    let c, claimed, space = context source claims claim dimension in
    refutation c space claimed rule
  | [ "circumspect-impossibility"; "2"; ("plc-triangulation" | "cdt" as claim); "3"; kind ] when List.mem_assoc kind kinds ->
    let c, claimed, _ = context source domain_claims claim "3" in
    impossibility c claimed (List.assoc kind kinds)
  | tokens -> Text.fail source first (Text.quote (String.concat " " tokens))
