(** * The checker of certificates about domains

    [check_domain] is extracted; [DomainSound.v] proves what its acceptance means.  The mesh of the
    whole hull is checked by [check_in]; here is what is checked besides, for each thing in constant
    time.  In space each polygon is seen along an axis, where it is a domain in the plane. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Domains Checker.
From Circumspect Require Table.
Import ListNotations.
Open Scope Z_scope.

(** The members of two lists of the same length, side by side. *)
Fixpoint each_pair {A B} (c : condition) (at_ : positive -> place) (f : positive -> A -> B ->
  result)
    (k : positive) (l : list A) (l' : list B) : result :=
  match l, l' with
  | [], [] => Accepted
  | a :: r, b :: r' =>
      match f k a b with Accepted => each_pair c at_ f (Pos.succ k) r r' | rejected => rejected end
  | _, _ => Rejected c (at_ k)
  end.
Definition member (k : positive) (l : list positive) : bool := existsb (Pos.eqb k) l.
Definition same_members (k l : list positive) : bool :=
  forallb (fun x => member x l) k && forallb (fun x => member x k) l.
Fixpoint same_integers (k l : list Z) : bool :=
  match k, l with
  | [], [] => true
  | x :: k', y :: l' => (x =? y) && same_integers k' l'
  | _, _ => false
  end.
Fixpoint inner_product (k l : list Z) : Z :=
  match k, l with x :: k', y :: l' => x * y + inner_product k' l' | _, _ => 0 end.
Fixpoint differences (k l : list Z) : list Z :=
  match k, l with x :: k', y :: l' => (x - y) :: differences k' l' | _, _ => [] end.

(** The point p is on the segment from a to b, which are different. *)
Definition on_segment (a b p : site) : bool :=
  let u := differences (coordinates b) (coordinates a) in
  let v := differences (coordinates p) (coordinates a) in
  let n := inner_product u v in
  let l := inner_product u u in
  (0 <? l) && (0 <=? n) && (n <=? l) && same_integers (map (Z.mul l) v) (map (Z.mul n) u).

Section Part.
Variable pr : predicates.
Variable m : mesh.
Variable loose : bool.                   (* may something dangle? *)
Variable planar : bool.                  (* is a wall part of a segment? *)
Variable kind : domain_kind.
Variable roles_of : Table.t role.
Variable holes_of : Table.t hole_entry.
Variable marks_of : Table.t mark.
(** What shows that facet I of a simplex with these corners is part of this wall. *)
Variable shown : list positive -> nat -> positive * positive -> bool.

Definition is_corner (k : positive) : bool :=
  match Table.find k roles_of with Some (Corner _) => true | _ => false end.
Definition kept_at (t : positive) : bool :=
  match Table.find t marks_of with Some e => kept e | None => false end.
Definition flag (e : mark) (i : nat) : option (positive * positive) :=
  match nth_error (flags e) i with Some f => f | None => None end.
Definition flagged_at (t : positive) (i : nat) : bool :=
  match Table.find t marks_of with
  | Some e => match flag e i with Some _ => true | None => false end
  | None => false
  end.

(** [role-shown] *)
Fixpoint weighed (w : list (Z * positive)) : option (Z * list Z) :=
  match w with
  | [] => Some (0, repeat 0 (dimension pr))
  | (a, k) :: w' =>
      match Table.find k (points_of m), weighed w' with
      | Some p, Some (n, l) =>
          if (0 <=? a) && is_corner k
          then Some (a + n, map (fun xy => a * fst xy + snd xy) (combine (coordinates p) l))
          else None
      | _, _ => None
      end
  end.
Definition check_role (k : positive) (e : point_entry) (r : role) : result :=
  require role_shown by
    match r with
    | Corner t => (loose || kept_at t) &&
        match Table.find t (simplices_of m) with Some s => member k (corners s) | None => false end
    | Steiner w =>
        match kind with
        | Enclosed => true
        | Hull => match weighed w with
                  | Some (n, l) => (0 <? n) &&
                      same_integers (map (Z.mul n) (coordinates (position e))) l
                  | None => false
                  end
        end
    end at AtPoint k; Accepted.

(** [segment-linked] *)
Definition has_facet (s : simplex_entry) (i : nat) : bool :=
  match nth_error (walls s) i with Some _ => true | None => false end.
Definition edge_of (t : positive) (i : nat) (u v : positive) : bool :=
  negb (Pos.eqb u v) && (loose || kept_at t) &&
  match Table.find t (simplices_of m) with
  | None => false
  | Some s =>
      member u (corners s) && member v (corners s) &&
      match planar, kind with
      | true, Enclosed => has_facet s i && flagged_at t i &&
          same_members (remove i (corners s)) [u; v]
      | _, _ => true
      end
  end.
Fixpoint linked (a b : site) (u : positive) (l : list link) : bool :=
  match l with
  | [] => true
  | s :: l' =>
      let v := reached s in
      edge_of (link_simplex s) (link_facet s) u v &&
      match Table.find v (points_of m) with Some p => on_segment a b p | None => false end &&
      linked a b v l'
  end.
Definition check_segment (k : positive) (s : segment_entry) : result :=
  let last_reached := last (map reached (links s)) (from s) in
  require segment_linked by
    is_corner (from s) && is_corner last_reached &&
    match Table.find (from s) (points_of m), Table.find last_reached (points_of m) with
    | Some a, Some b => on_segment a b b && linked a b (from s) (links s)
    | _, _ => false
    end at AtSegment k; Accepted.

(** [hole-inside]: the point is strictly inside a simplex that is not kept; or in one, and then each
    wall is looked at, for it must be on none. *)
Fixpoint all_sides (f : Z -> bool) (i : nat) (X : list site) (h : hole_entry) : bool :=
  match i with
  | O => true
  | S i' => f (side pr i' X (hole_point h) (hole_w h)) && all_sides f i' X h
  end.
Definition strictly_in : list site -> hole_entry -> bool := all_sides (Z.ltb 0) (S (dimension pr)).
Definition closed_in : list site -> hole_entry -> bool := all_sides (Z.leb 0) (S (dimension pr)).
Fixpoint off_facets (e : mark) (i : nat) (X : list site) (h : hole_entry) : bool :=
  match i with
  | O => true
  | S i' => match flag e i' with
            | Some _ => negb ((side pr i' X (hole_point h) (hole_w h) =? 0) && closed_in X h)
            | None => true
            end && off_facets e i' X h
  end.
Fixpoint off_walls (h : hole_entry) (l : list simplex_entry) (l' : list mark) : bool :=
  match l, l' with
  | s :: r, e :: r' =>
      match find_all (points_of m) (corners s) with
      | None => false
      | Some X => off_facets e (S (dimension pr)) X h && off_walls h r r'
      end
  | _, _ => true
  end.
Definition check_hole (l : list simplex_entry) (l' : list mark) (k : positive) (h : hole_entry) :
  result :=
  require hole_inside by
    negb (kept_at (hole_simplex h)) && shaped pr (hole_point h) && (0 <? hole_w h) &&
    match Table.find (hole_simplex h) (simplices_of m) with
    | None => false
    | Some e => match find_all (points_of m) (corners e) with
                | None => false
                | Some X => strictly_in X h || (closed_in X h && off_walls h l l')
                end
    end at AtHole k; Accepted.

(** [mark-consistent]: marks differ only across walls, and a wall has a kept simplex beside it, if
    it does not dangle. *)
Definition consistent (e : mark) (i : nat) (f : wall) : bool :=
  match f with
  | OnHull _ => match flag e i with Some _ => loose || kept e | None => negb (kept e) end
  | Neighbour u j =>
      match Table.find u marks_of with
      | None => false
      | Some e' => match flag e i, flag e' j with
                   | Some _, Some _ => loose || kept e || kept e'
                   | None, None => Bool.eqb (kept e) (kept e')
                   | _, _ => false
                   end
      end
  end.
Definition check_facet (t : positive) (K : list positive) (e : mark) (i : nat) (f : wall) :
  result :=
  require mark_consistent by consistent e i f at AtFacet t i;
  require wall_shown by match flag e i with Some w => shown K i w | None => true end at AtFacet t i;
  Accepted.
(** [way-out-shown] *)
Definition gets_out (t : positive) (s : simplex_entry) (e : mark) : bool :=
  let open_ i := match flag e i with Some _ => false | None => true end in
  kept e ||
  match way_out e with
  | InHole h => match Table.find h holes_of with
                | Some x => Pos.eqb (hole_simplex x) t
                | None => false
                end
  | OutOfHull i => open_ i && match nth_error (walls s) i with Some (OnHull _) => true | _ =>
      false end
  | Across i => open_ i &&
      match nth_error (walls s) i with
      | Some (Neighbour u _) =>
          match Table.find u marks_of with Some e' => Pos.ltb (rank e') (rank e) | None => false end
      | _ => false
      end
  end.
Definition check_mark (t : positive) (s : simplex_entry) (e : mark) : result :=
  match kind with
  | Hull => require mark_consistent by kept e at AtSimplex t; Accepted
  | Enclosed =>
      require way_out_shown by gets_out t s e at AtSimplex t;
      each_index (check_facet t (corners s) e) 0 (walls s)
  end.
End Part.

(** ** A domain in the plane, or the part of one in space that is like it *)

Definition check_part (pr : predicates) (loose planar : bool) (kind : domain_kind) (c : certificate)
    (p : part) (shown : list positive -> nat -> positive * positive -> bool) : result :=
  let m := mesh_of c in
  let roles_of := Table.of_list id (roles p) in
  let marks_of := Table.of_list id (marks p) in
  let holes_of := Table.of_list id (holes p) in
  require claim_of_mesh by negb (weights_of (claimed c)) at Nowhere;
  each_pair role_shown AtPoint (check_role pr m loose kind roles_of marks_of) 1 (points c)
    (roles p) ;;
  each (check_segment m loose planar kind roles_of marks_of) 1 (segments p) ;;
  each (check_hole pr m marks_of (simplices c) (marks p)) 1 (holes p) ;;
  each_pair mark_consistent AtSimplex (check_mark loose kind holes_of marks_of shown) 1
    (simplices c) (marks p).

(** In the plane a wall is part of segment K: both its vertices are on it. *)
Definition shown_by_segment (c : certificate) (p : part) : list positive -> nat ->
  positive * positive -> bool :=
  let m := mesh_of c in
  let segments_of := Table.of_list id (segments p) in
  fun K i w =>
    match Table.find (fst w) segments_of with
    | None => false
    | Some s =>
        match Table.find (from s) (points_of m),
              Table.find (last (map reached (links s)) (from s)) (points_of m) with
        | Some a, Some b => forallb (fun k =>
            match Table.find k (points_of m) with Some q => on_segment a b q | None => false end)
            (remove i K)
        | _, _ => false
        end
    end.
Definition check_in_plane (kind : domain_kind) (c : certificate) (p : part) : result :=
  check_in plane_predicates c ;;
  check_part plane_predicates false true kind c p (shown_by_segment c p).

(** ** Polygons *)

(** What remains of the coordinates if one looks along the axis. *)
Definition along_axis (i : nat) (s : site) : list Z := remove i (coordinates s).
(** The numbers of the points of the mesh above. *)
Definition named_above (above_of : Table.t positive) (l : list positive) : list positive :=
  match find_all above_of l with Some k => k | None => [] end.

Section Polygon.
Variable loose : bool.
Variable kind : domain_kind.
Variable c : certificate.
Variable m : mesh.
Variable marks_of : Table.t mark.
Variable f : polygon_entry.

(** [polygon-flat] *)
Definition over (q : list Z) (w : Z) (p : list Z) : bool :=
  (inner_product (normal f) p =? w * offset f) && Nat.eqb (length p) 3 &&
  same_integers (remove (axis f) p) q.
Definition check_above (k : positive) (e : point_entry) (j : positive) : result :=
  require polygon_flat by
    match Table.find j (points_of m) with
    | Some p => over (coordinates (position e)) 1 (coordinates p)
    | None => false
    end at AtPoint k; Accepted.
Definition check_seed (k : positive) (h : hole_entry) (s : site * Z) : result :=
  require polygon_flat by
    (hole_w h =? snd s) && over (coordinates (hole_point h)) (snd s) (coordinates (fst s))
    at AtHole k; Accepted.
(** [polygon-tiled] *)
Definition check_tile (above_of : Table.t positive) (k : positive) (se : simplex_entry * mark)
    (ti : positive * nat) : result :=
  require polygon_tiled by
    negb (kept (snd se)) ||
    ((loose || kept_at marks_of (fst ti)) &&
     match kind with Enclosed => flagged_at marks_of (fst ti) (snd ti) | Hull => true end &&
     match Table.find (fst ti) (simplices_of m) with
     | Some s => has_facet s (snd ti) &&
         same_members (named_above above_of (corners (fst se))) (remove (snd ti) (corners s))
     | None => false
     end) at AtSimplex k; Accepted.
Definition check_shape : result :=
  let p := plane_mesh f in
  require polygon_flat by
    (numerator p =? numerator c) && (denominator p =? denominator c) &&
    Nat.eqb (length (normal f)) 3 && Nat.ltb (axis f) 3 && negb (nth (axis f) (normal f) 0 =? 0)
    at Nowhere;
  check_in_plane Enclosed p (plane_part f) ;;
  each_pair polygon_flat AtPoint check_above 1 (points p) (above f) ;;
  each_pair polygon_flat AtHole check_seed 1 (holes (plane_part f)) (seeds f).
Definition check_polygon : result :=
  let p := plane_mesh f in
  check_shape ;;
  each_pair polygon_tiled AtSimplex (check_tile (Table.of_list id (above f))) 1
    (combine (simplices p) (marks (plane_part f))) (tiles f).
End Polygon.

(** In space a wall is piece U of polygon K. *)
Record polygon_tables := PolygonTables {
  pieces : Table.t simplex_entry; piece_marks : Table.t mark; aboves : Table.t positive }.
Definition tables_of (f : polygon_entry) : polygon_tables :=
  PolygonTables (Table.of_list id (simplices (plane_mesh f)))
    (Table.of_list id (marks (plane_part f))) (Table.of_list id (above f)).
Definition shown_by_polygon (P : Table.t polygon_tables) (K : list positive) (i : nat)
    (w : positive * positive) : bool :=
  match Table.find (fst w) P with
  | None => false
  | Some f =>
      kept_at (piece_marks f) (snd w) &&
      match Table.find (snd w) (pieces f) with
      | Some s => same_members (named_above (aboves f) (corners s)) (remove i K)
      | None => false
      end
  end.

(** ** The whole *)

(** [vertices-of-domain] *)
Definition known_corners (c : domain_certificate) : result :=
  let roles_of := Table.of_list id (roles (domain_part c)) in
  each_pair vertices_of_domain AtSimplex (fun t s e =>
    require vertices_of_domain by
      negb (kept e) || forallb (is_corner roles_of) (corners s) at AtSimplex t; Accepted) 1
    (simplices (whole_mesh c)) (marks (domain_part c)).
(** [facet-locally-delaunay], where both simplices are kept and the facet is in no wall. *)
Section Local.
Variable pr : predicates.
Variable m : mesh.
Definition check_local_facet (t : positive) (e : mark) (X : list site) (n : list Z) (i : nat)
  (f : wall) :
    result :=
  match f with
  | OnHull _ => Accepted
  | Neighbour u j =>
      match flag e i with
      | Some _ => Accepted
      | None =>
          if Pos.ltb t u then
            match Table.find u (simplices_of m) with
            | None => Rejected facet_matched (AtFacet t i)
            | Some s =>
                match nth_error (corners s) j with
                | None => Rejected facet_matched (AtFacet t i)
                | Some v =>
                    match Table.find v (points_of m) with
                    | None => Rejected vertex_known (AtSimplex u)
                    | Some p =>
                        require facet_locally_delaunay by apex_outside pr X n p at AtFacet t i;
                        Accepted
                    end
                end
            end
          else Accepted
      end
  end.
Definition check_local_simplex (t : positive) (s : simplex_entry) (e : mark) : result :=
  if kept e then
    match find_all (points_of m) (corners s) with
    | None => Rejected vertex_known (AtSimplex t)
    | Some X => each_index (check_local_facet t e X (slope pr X)) 0 (walls s)
    end
  else Accepted.
End Local.
(** Of a hull [check_part] does not look at flags. *)
Definition check_flags (shown : list positive -> nat -> positive * positive -> bool) (t : positive)
  (s : simplex_entry)
    (e : mark) : result :=
  each_index (fun i (_ : wall) =>
    require wall_shown by match flag e i with Some w => shown (corners s) i w | None =>
      true end at AtFacet t i; Accepted)
    0 (walls s).
Definition check_local (pr : predicates) (shown : list positive -> nat -> positive * positive ->
  bool) (c : domain_certificate) :
    result :=
  match kind c with
  | Enclosed => Accepted
  | Hull => each_pair mark_consistent AtSimplex (check_flags shown) 1 (simplices (whole_mesh c))
      (marks (domain_part c))
  end ;;
  each_pair mark_consistent AtSimplex (check_local_simplex pr (mesh_of (whole_mesh c))) 1
    (simplices (whole_mesh c)) (marks (domain_part c)).

Definition check_claim (pr : predicates) (shown : list positive -> nat -> positive * positive ->
  bool) (c : domain_certificate) :
    result :=
  match domain_claimed c with
  | PlcTriangulation => known_corners c
  | SteinerTriangulation => Accepted
  | ConformingDelaunay =>
      require claim_of_mesh by delaunay_of (claimed (whole_mesh c)) at Nowhere; Accepted
  | Cdt => known_corners c ;; check_local pr shown c
  | SteinerCdt => check_local pr shown c
  end.
Definition in_polygon (k : positive) (r : result) : result :=
  match r with Accepted => Accepted | Rejected c _ => Rejected c (AtPolygon k) end.

Definition check_domain (D : plane_or_space) (c : domain_certificate) : result :=
  let p := domain_part c in
  match D with
  | Plane =>
      require polygon_flat by match polygons c with [] => true | _ => false end at Nowhere;
      check_in_plane (kind c) (whole_mesh c) p ;;
      check_claim plane_predicates (shown_by_segment (whole_mesh c) p) c
  | Space =>
      let P := Table.of_list tables_of (polygons c) in
      let m := mesh_of (whole_mesh c) in
      let marks_of := Table.of_list id (marks p) in
      check_in space_predicates (whole_mesh c) ;;
      check_part space_predicates false false (kind c) (whole_mesh c) p (shown_by_polygon P) ;;
      each (fun k f => in_polygon k (check_polygon false (kind c) (whole_mesh c) m marks_of f)) 1
        (polygons c) ;;
      check_claim space_predicates (shown_by_polygon P) c
  end.

(** ** Where something dangles

    What dangles is a face of the mesh of the whole hull, beside simplices that are not kept: walls,
    steps of segments and vertices need no kept simplex. *)

(** [vertices-of-domain], of what may dangle. *)
Definition known_faces (c : domain_certificate) : result :=
  let roles_of := Table.of_list id (roles (domain_part c)) in
  each (fun k s =>
    require vertices_of_domain by
      forallb (is_corner roles_of) (from s :: map reached (links s)) at AtSegment k; Accepted) 1
    (segments (domain_part c)) ;;
  each (fun k f =>
    require vertices_of_domain by forallb (is_corner roles_of) (above f) at AtPolygon k; Accepted) 1
    (polygons c).
Definition check_faces (c : domain_certificate) : result :=
  match domain_claimed c with
  | PlcTriangulation | Cdt => known_faces c
  | _ => Accepted
  end.
(** A triangle that dangles has to be constrained Delaunay: it is Delaunay, if the whole mesh is. *)
Definition triangles_may_dangle (c : domain_certificate) : bool :=
  match domain_claimed c with
  | Cdt | SteinerCdt => delaunay_of (claimed (whole_mesh c))
  | _ => true
  end.

Definition check_dangling (D : plane_or_space) (c : domain_certificate) : result :=
  let p := domain_part c in
  require mark_consistent by match kind c with Enclosed => true | Hull => false end at Nowhere;
  match D with
  | Plane =>
      let shown := shown_by_segment (whole_mesh c) p in
      require polygon_flat by match polygons c with [] => true | _ => false end at Nowhere;
      check_in plane_predicates (whole_mesh c) ;;
      check_part plane_predicates true true (kind c) (whole_mesh c) p shown ;;
      check_claim plane_predicates shown c ;;
      check_faces c
  | Space =>
      let shown := shown_by_polygon (Table.of_list tables_of (polygons c)) in
      let m := mesh_of (whole_mesh c) in
      let marks_of := Table.of_list id (marks p) in
      check_in space_predicates (whole_mesh c) ;;
      check_part space_predicates true false (kind c) (whole_mesh c) p shown ;;
      each (fun k f => in_polygon k
        (check_polygon (triangles_may_dangle c) (kind c) (whole_mesh c) m marks_of f)) 1
        (polygons c) ;;
      check_claim space_predicates shown c ;;
      check_faces c
  end.
