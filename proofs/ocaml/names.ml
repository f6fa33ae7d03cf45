(* What conditions, places, claims and kinds of domains are called, in certificates and in answers. *)
open Extracted

let condition = function
  | Scale -> "scale" | Points_increasing -> "points-increasing" | Point_used -> "point-used"
  | Vertex_known -> "vertex-known" | Simplex_positive -> "simplex-positive"
  | Facet_matched -> "facet-matched" | Back_pointer -> "back-pointer"
  | Hull_pointer -> "hull-pointer" | Ridge_matched -> "ridge-matched"
  | Ridge_back_pointer -> "ridge-back-pointer" | Hull_locally_convex -> "hull-locally-convex"
  | Sample_inside -> "sample-inside" | Sample_outside -> "sample-outside"
  | Sample_inside_hull -> "sample-inside-hull"
  | Facet_locally_delaunay -> "facet-locally-delaunay"
  | Claim_of_mesh -> "claim-of-mesh" | Role_shown -> "role-shown"
  | Segment_linked -> "segment-linked" | Hole_inside -> "hole-inside"
  | Mark_consistent -> "mark-consistent" | Wall_shown -> "wall-shown"
  | Way_out_shown -> "way-out-shown" | Polygon_flat -> "polygon-flat"
  | Polygon_tiled -> "polygon-tiled" | Vertices_of_domain -> "vertices-of-domain"
  | Face_held -> "face-held" | Segment_in_polygon -> "segment-in-polygon"
  | Rim_listed -> "rim-listed" | One_sided_shown -> "one-sided-shown"
  | Simplex_proper -> "simplex-proper" | Simplex_listed -> "simplex-listed"
  | Simplices_parted -> "simplices-parted"
  | Summit_inside -> "summit-inside" | Cone_shown -> "cone-shown"
  | Edge_listed -> "edge-listed" | Edges_increasing -> "edges-increasing" | Edge_delaunay -> "edge-delaunay"
  | Lattice_proper -> "lattice-proper"
  | Point_in_plane -> "point-in-plane" | Weight_unseen -> "weight-unseen"
  | Vertices_listed -> "vertices-listed" | Mesh_of_the_domain -> "mesh-of-the-domain"
  | Fate_shown -> "fate-shown"
  | Reason_shown -> "reason-shown" | Clauses_refuted -> "clauses-refuted"

let place =
  let n = string_of_int in
  function
  | Nowhere -> ""
  | AtPoint k -> ", point " ^ n k
  | AtSimplex t -> ", simplex " ^ n t
  | AtFacet (t, i) -> Printf.sprintf ", simplex %s, facet %d" (n t) (Reading.of_natural i)
  | AtHull h -> ", hull facet " ^ n h
  | AtSegment k -> ", segment " ^ n k
  | AtHole k -> ", hole " ^ n k
  | AtPolygon k -> ", polygon " ^ n k
  | AtEdge k -> ", edge " ^ n k
  | AtCandidate k -> ", candidate " ^ n k
  | AtReason k -> ", clause " ^ n k
  | AtRidge (h, a) -> Printf.sprintf ", hull facet %s, ridge %d" (n h) (Reading.of_natural a)

let claims = List.map (fun claim -> (claim_name claim, claim)) [ Triangulation; Delaunay; WeightedDelaunay ]

let domain_claims = List.map (fun claim -> (domain_claim_name claim, claim))
    [ PlcTriangulation; SteinerTriangulation; ConformingDelaunay; Cdt; SteinerCdt ]
let kinds = [ "enclosed", Enclosed; "hull", Hull ]

let complex = "complex"
let convex_hull = "convex-hull"
let surface_delaunay = "surface-delaunay"
let periodic_delaunay = "periodic-delaunay"
