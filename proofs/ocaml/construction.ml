(* The canonical Delaunay triangulation of the points of a .node file, by the gift-wrapping that is proved
   (wrapping/GiftWrapping.v): as rows of an .ele file, by the user's indices. *)
open Extracted

let lcm_of_denominators places =
  List.fold_left (fun common place -> List.fold_left (fun common x -> Big.lcm common (Q.den x)) common place) Big.one places

(* In lexicographic order: in this order the points are perturbed. *)
let compare_points (p, _, _) (q, _, _) = List.compare Q.compare p q

let delaunay ~exactly source =
  let listed, d, first = Users_domain.points ~exactly source in
  let indexed = List.mapi (fun i (place, line) -> (place, line, Big.add first (Big.of_int i))) listed in
  let points = List.sort compare_points indexed in
  let rec refuse_equal = function
    | (p, line, i) :: ((q, later, j) :: _ as rest) ->
      if List.equal Q.equal p q then begin
        source.Text.line <- max line later;
        Text.fail source "distinct points"
          (Printf.sprintf "point %s and point %s in one place" (Big.to_string i) (Big.to_string j))
      end;
      refuse_equal rest
    | _ -> () in
  refuse_equal points;
  let unit = lcm_of_denominators (List.map (fun (place, _, _) -> place) points) in
  let integer x = Big.mul (Q.num x) (Big.divexact unit (Q.den x)) in
  let sites = List.map (fun (place, _, _) -> { coordinates = List.map integer place; weight = Big.zero }) points in
  let indices = Array.of_list (List.map (fun (_, _, index) -> index) points) in
  match wrap (if d = 2 then Plane else Space) sites with
  | None ->
    Text.fail source (Printf.sprintf "points that span the %s" (if d = 2 then "plane" else "space"))
      (Printf.sprintf "%d points that do not" (List.length points))
  | Some simplices ->
    let row number simplex =
      String.concat " " (List.map Big.to_string
        (Big.add first (Big.of_int number) :: List.sort Big.compare (List.map (fun k -> indices.(k - 1)) simplex))) in
    let rows = List.mapi row simplices in
    String.concat "\n" (Printf.sprintf "%d %d" (List.length rows) (d + 1) :: rows)
