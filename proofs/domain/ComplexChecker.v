(** * The checker of what shows that a domain is a piecewise linear complex (Definition 4.3)

    [check_complex] is extracted; [ComplexSound.v] proves what its acceptance means.  The
    certificate of the domain and its mesh is accepted already: so each segment and each polygon is
    a union of faces of the mesh, which is a complex.  Each of these faces is held by one segment or
    polygon, which the certificate names; so others meet only in what they share by name. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export DomainChecker.
Import ListNotations.
Open Scope Z_scope.

(** ** Faces, as lists of numbers *)

Definition lesser (a b : positive) : positive := if Pos.ltb a b then a else b.
Definition least (l : list positive) : positive :=
  match l with [] => 1%positive | k :: l' => fold_left lesser l' k end.
(** Lists with the same members have the same holder. *)
Definition holder_of (F : Table.t (list face_entry)) (s : list positive) : option holder :=
  match Table.find (least s) F with
  | None => None
  | Some l =>
      match find (fun e => same_members (least s :: others e) s) l with
      | Some e => Some (face_holder e)
      | None => None
      end
  end.
Fixpoint sublists (l : list positive) : list (list positive) :=
  match l with [] => [[]] | k :: l' => map (cons k) (sublists l') ++ sublists l' end.

Section Faces.
Variable m : mesh.
Variable roles_of : Table.t role.
Variable segments_of : Table.t segment_entry.
Variable F : Table.t (list face_entry).

Definition at_corner (s : list positive) : bool :=
  match s with [] => true | k :: s' => is_corner roles_of k && forallb (Pos.eqb k) s' end.
Definition last_reached (s : segment_entry) : positive := last (map reached (links s)) (from s).
(** The point is on the segment. *)
Definition lies_on (n k : positive) : bool :=
  match Table.find n segments_of with
  | None => false
  | Some s =>
      match Table.find (from s) (points_of m), Table.find (last_reached s) (points_of m),
            Table.find k (points_of m) with
      | Some a, Some b, Some p => on_segment a b p
      | _, _, _ => false
      end
  end.

(** [face-held]: a face of segment or polygon [w], in which the segments [inside] lie. *)
Definition held (w : holder) (inside : list positive) (s : list positive) : bool :=
  at_corner s ||
  match holder_of F s, w with
  | Some (InSegment k), InSegment j => Pos.eqb k j
  | Some (InSegment k), InPolygon _ => member k inside && forallb (lies_on k) s
  | Some (InPolygon k), InPolygon j => Pos.eqb k j
  | _, _ => false
  end.
Fixpoint steps_held (n u : positive) (l : list link) : bool :=
  match l with
  | [] => true
  | s :: l' =>
      forallb (held (InSegment n) []) (sublists [u; reached s]) &&
      match l' with [] => true | _ => negb (is_corner roles_of (reached s)) end &&
      steps_held n (reached s) l'
  end.
Definition check_steps (n : positive) (s : segment_entry) : result :=
  require face_held by steps_held n (from s) (links s) at AtSegment n; Accepted.
End Faces.

(** ** On one side only *)

(** Beyond facet [i] no simplex is kept. *)
Definition exposed_at (marks_of : Table.t mark) (e : simplex_entry) (i : nat) : bool :=
  match nth_error (walls e) i with
  | Some (Neighbour u _) => negb (kept_at marks_of u)
  | Some (OnHull _) => true
  | None => false
  end.
Section Sides.
Variable m : mesh.
Variable marks_of : Table.t mark.
Variable sides : Table.t bool.               (* of the walls *)

Definition sided (n t : positive) (i : nat) : bool :=
  match Table.find n sides, Table.find t (simplices_of m) with
  | Some b, Some e => Bool.eqb (exposed_at marks_of e i) b
  | _, _ => false
  end.
(** [one-sided-shown]: of the facets of a kept simplex, and of the links of a segment in the
    plane. *)
Definition check_sides (t : positive) (s : simplex_entry) (e : mark) : result :=
  if kept e then
    each_index (fun i f =>
      require one_sided_shown by
        match flag e i with Some w => sided (fst w) t i | None => true end at AtFacet t i;
          Accepted) 0 (walls s)
  else Accepted.
Definition check_links (n : positive) (s : segment_entry) : result :=
  require one_sided_shown by
    forallb (fun l => sided n (link_simplex l) (link_facet l)) (links s) at AtSegment n; Accepted.
End Sides.
Definition check_sides_of (c : certificate) (p : part) (sides : list bool) : result :=
  let m := mesh_of c in
  let marks_of := Table.of_list id (marks p) in
  let sides_of := Table.of_list id sides in
  each_pair one_sided_shown AtSimplex (check_sides m marks_of sides_of) 1 (simplices c) (marks p).
(** In the plane, of segments. *)
Definition check_plane_sides (c : certificate) (p : part) (sides : list bool) : result :=
  check_sides_of c p sides ;;
  each (check_links (mesh_of c) (Table.of_list id (marks p)) (Table.of_list id sides)) 1
    (segments p).

(** ** Polygons *)

(** The tables of the mesh are those of all polygons. *)
Section Polygon.
Variable m : mesh.
Variable marks_of : Table.t mark.
Variable F : Table.t (list face_entry).
Variable roles_of : Table.t role.
Variable segments_of : Table.t segment_entry.
Variable f : polygon_entry.
Notation part2 := (plane_part f).
Notation mesh2 := (plane_mesh f).

(** [rim-listed]: its own segments are segments of the domain. *)
Definition check_rim (above_of : Table.t positive) (n : positive) (s : segment_entry)
  (kb : positive * bool) :
    result :=
  require rim_listed by
    match Table.find (fst kb) segments_of, Table.find (from s) above_of,
      Table.find (last_reached s) above_of with
    | Some t, Some a, Some b => same_members [a; b] [from t; last_reached t]
    | _, _, _ => false
    end at AtSegment n; Accepted.
(** [segment-in-polygon] *)
Fixpoint steps_in (above_of : Table.t positive) (pieces_of : Table.t simplex_entry)
  (marks2 : Table.t mark)
    (u : positive) (l : list link) (ts : list positive) : bool :=
  match l, ts with
  | [], [] => true
  | s :: l', t :: ts' =>
      kept_at marks2 t &&
      match Table.find t pieces_of with
      | Some e => let k := named_above above_of (corners e) in member u k && member (reached s) k
      | None => false
      end && steps_in above_of pieces_of marks2 (reached s) l' ts'
  | _, _ => false
  end.
Definition check_segment_in above_of pieces_of marks2 (n : positive) (kt : positive * list positive)
  : result :=
  require segment_in_polygon by
    match Table.find (fst kt) segments_of with
    | Some s => steps_in above_of pieces_of marks2 (from s) (links s) (snd kt)
    | None => false
    end at AtSegment n; Accepted.
Definition check_piece above_of (k : positive) (inside : list positive) (t : positive)
  (s : simplex_entry)
    (e : mark) : result :=
  require face_held by
    negb (kept e) ||
    forallb (held m roles_of segments_of F (InPolygon k) inside)
      (sublists (named_above above_of (corners s))) at AtSimplex t; Accepted.
Definition check_polygon_part (k : positive) (x : polygon_faces) : result :=
  let above_of := Table.of_list id (above f) in
  let marks2 := Table.of_list id (marks part2) in
  let pieces_of := Table.of_list id (simplices mesh2) in
  each_pair rim_listed AtSegment (check_rim above_of) 1 (segments part2) (rim_segments x) ;;
  check_plane_sides mesh2 part2 (map snd (rim_segments x)) ;;
  each (check_segment_in above_of pieces_of marks2) 1 (segments_in x) ;;
  each_pair face_held AtSimplex (check_piece above_of k (map fst (segments_in x))) 1
    (simplices mesh2) (marks part2).
(** Its tiles, where the walls enclose the domain. *)
Definition check_tile_sides (sides_of : Table.t bool) (k : positive) : result :=
  each_pair one_sided_shown AtSimplex (fun u e ti =>
    require one_sided_shown by
      negb (kept e) || sided m marks_of sides_of k (fst ti) (snd ti) at AtSimplex u; Accepted) 1
    (marks part2) (tiles f).
End Polygon.

(** ** The whole *)

Definition check_complex (D : plane_or_space) (c : domain_certificate) (x : complex_part) :
  result :=
  let p := domain_part c in
  let mesh := whole_mesh c in
  let m := mesh_of mesh in
  let marks_of := Table.of_list id (marks p) in
  let sides_of := Table.of_list id (one_sided x) in
  let F := Table.of_list id (faces x) in
  let roles_of := Table.of_list id (roles p) in
  let segments_of := Table.of_list id (segments p) in
  let enclosed := match kind c with Enclosed => true | Hull => false end in
  each (check_steps m roles_of segments_of F) 1 (segments p) ;;
  match D with
  | Plane => if enclosed then check_plane_sides mesh p (one_sided x) else Accepted
  | Space =>
      (if enclosed then check_sides_of mesh p (one_sided x) else Accepted) ;;
      each_pair segment_in_polygon AtPolygon (fun k f y =>
        in_polygon k (
          check_polygon_part m F roles_of segments_of f k y ;;
          if enclosed then check_tile_sides m marks_of f sides_of k else Accepted)) 1
        (polygons c) (polygon_parts x)
  end.
