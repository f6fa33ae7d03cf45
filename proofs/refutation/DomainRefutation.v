(** * The checker of refutations of claims about domains

    [refute_domain] is extracted; [DomainRefuted.v] proves what its acceptance means. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Refutation DomainChecker DomainRules.
Import ListNotations.
Open Scope Z_scope.

(** The evidence is about simplices alone, or about balls that have to be empty for the claim. *)
Definition of_mesh (e : evidence) (c : domain_claim) : bool :=
  match e with
  | WrongDimension _ | UnknownVertex _ _ | RepeatedVertex _ _ _ | Degenerate _ | DuplicateSimplex _ _
  | Overlap _ _ _ _ | CoveredTwice _ _ _ _ => true
  | FacetNotLocal _ _ _ _ => match c with ConformingDelaunay => true | _ => false end
  | _ => false
  end.
Definition only_vertices (c : domain_claim) : bool :=
  match c with PlcTriangulation | Cdt => true | _ => false end.

Section Evidence.
Variable pr : predicates.
Variable S : Table.t site.
Variable rows_of : Table.t row.
Variable l : list row.
Variable V : list site.
Variable V_of : Table.t site.
Variable segments_of : Table.t (positive * positive).

Definition times (w : Z) (p : site) : site := Site (map (Z.mul w) (coordinates p)) 0.
(** Of the simplices that contain the point, the least face that does is not in the segment. *)
Definition not_along (a b q : site) (w : Z) (x : row) : bool :=
  match proper_simplex_of pr S x with
  | Some X => negb (in_simplex pr X q w) ||
      existsb (fun v => negb (on_segment a b v)) (carrier_of pr X q w)
  | None => false
  end.
Definition holds_of_domain (e : domain_evidence) : bool :=
  match e with
  | VertexMissing k =>
      match Table.find k V_of with Some v => negb (existsb (lists S v) l) | None => false end
  | SteinerForbidden t i =>
      entry_at rows_of t i (fun n =>
        match named S n with Some p => negb (existsb (same_place p) V) | None => false end)
  | SegmentMissing k q w =>
      match Table.find k segments_of with
      | Some (i, j) =>
          match Table.find i V_of, Table.find j V_of with
          | Some a, Some b => point_written pr q w && on_segment (times w a) (times w b) q &&
              forallb (not_along a b q w) l
          | _, _ => false
          end
      | None => false
      end
  | VertexInEdge t i u j k s =>
      match Table.find s segments_of with
      | Some (m, n) =>
          match Table.find m V_of, Table.find n V_of with
          | Some a, Some b =>
              entry_at rows_of t i (fun x => match named S x with Some p => on_segment a b p &&
                simplex_at pr S rows_of u (fun X => match nth_error X j, nth_error X k with
                  | Some e, Some f => negb (same_place p e) && negb (same_place p f) && on_segment e f p
                  | _, _ => false
                  end) | None => false end)
          | _, _ => false
          end
      | None => false
      end
  | OfMesh => false
  end.
End Evidence.

Definition refute_domain_in (pr : predicates) (r : domain_refutation) : bool :=
  let m := mesh_refuted r in
  let S := Table.of_list (site_for (refuted m)) (sites m) in
  match domain_because r with
  | OfMesh => of_mesh (because m) (domain_refuted r) &&
      match refuted m with Delaunay => refute_in pr m | _ => false end
  | e =>
      match e with SteinerForbidden _ _ => only_vertices (domain_refuted r) | _ => true end &&
      (0 <? unit_numerator m) && (0 <? unit_denominator m) &&
      forallb (shaped pr) (sites m) && forallb (shaped pr) (vertices_given r) &&
      holds_of_domain pr S (Table.of_list id (rows m)) (rows m) (vertices_given r)
        (Table.of_list id (vertices_given r)) (Table.of_list id (segments_given r)) e
  end.
Definition refute_domain (D : plane_or_space) (r : domain_refutation) : bool :=
  refute_domain_in (predicates_of D) r.
