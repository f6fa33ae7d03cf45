(** * A domain that is given without a mesh, and what is checked of its points

    It is read as that of a certificate whose points are its vertices, and which has no simplices:
    what shows that a claim about it does not hold, or that it has no triangulation, speaks of it in
    these words.  [GivenSound.v] proves what acceptance means. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Refutation DomainChecker DomainRules DomainRefutation.
Import ListNotations.
Open Scope Z_scope.

(** A polygon, with its pieces, their marks and its points in tables. *)
Definition polygon_in_tables : Type :=
  polygon_entry * Table.t simplex_entry * Table.t mark * Table.t site.
Definition in_tables (f : polygon_entry) : polygon_in_tables :=
  (f, Table.of_list id (simplices (plane_mesh f)), Table.of_list id (marks (plane_part f)),
   Table.of_list position (points (plane_mesh f))).

(** A vertex, without a weight. *)
Definition bare (e : point_entry) : site := Site (coordinates (position e)) 0.

Section Given.
Variable pr : predicates.
Variable D : domain_certificate.
Notation c := (whole_mesh D).

(** [vertices-listed]: all points are vertices of the domain; [segment-linked] and [hole-inside] ask
    no more than that there is such a segment and such a point. *)
Definition check_corner (k : positive) (e : point_entry) (r : role) : result :=
  require vertices_listed by
    shaped pr (position e) && match r with Corner _ => true | Steiner _ => false end at AtPoint k;
      Accepted.
Definition check_ends (vertices : Table.t site) (k : positive) (s : segment_entry) : result :=
  require segment_linked by
    match Table.find (from s) vertices, Table.find (last (map reached (links s)) (from s)) vertices
      with
    | Some _, Some _ => true
    | _, _ => false
    end at AtSegment k; Accepted.
Definition check_hole_point (k : positive) (h : hole_entry) : result :=
  require hole_inside by shaped pr (hole_point h) && (0 <? hole_w h) at AtHole k; Accepted.
Definition check_about : result :=
  require scale by (0 <? numerator c) && (0 <? denominator c) at Nowhere;
  each_pair vertices_listed AtPoint check_corner 1 (points c) (roles (domain_part D)) ;;
  require polygon_flat by match polygons D with [] => true | _ => Nat.eqb (dimension pr) 3 end
    at Nowhere;
  each (check_ends (Table.of_list bare (points c))) 1 (segments (domain_part D)) ;;
  each check_hole_point 1 (holes (domain_part D)) ;;
  each (fun k f => in_polygon k (check_shape c (mesh_of c) f)) 1 (polygons D).

(** ** Its points *)

Variable S : Table.t site.                      (* the vertices *)
Variable segments_of : Table.t segment_entry.
Variable polygons_listed : list polygon_in_tables.
Variable polygons_of : Table.t polygon_in_tables.

(** A point q / w of a cell, and what shows of another point that it is not in the cell. *)
Record cell_point := CellPoint { cell_site : site; cell_w : Z; beside : site -> bool }.
(** Where the point of a polygon's plane is seen. *)
Definition seen (f : polygon_entry) (q : site) : site := Site (along_axis (axis f) q) 0.
Definition in_plane (f : polygon_entry) (q : site) (w : Z) : bool :=
  over f (along_axis (axis f) q) w (coordinates q).
Definition piece_of (pieces : Table.t simplex_entry) (points2 : Table.t site) (u : positive) :
  option (list site) :=
  match Table.find u pieces with Some e => find_all points2 (corners e) | None => None end.
(** The point is seen in none of the kept triangles, or is not in the plane. *)
Fixpoint off_pieces (points2 : Table.t site) (q : site) (w : Z) (l : list simplex_entry)
  (l' : list mark) : bool :=
  match l, l' with
  | e :: r, m :: r' =>
      (negb (kept m) ||
       match find_all points2 (corners e) with
       | Some Y => proper plane_predicates Y && existsb (beyond plane_predicates Y q w) [0; 1;
           2]%nat
       | None => false
       end) && off_pieces points2 q w r r'
  | _, _ => true
  end.
Definition off_polygon (q : site) (w : Z) (x : polygon_in_tables) : bool :=
  let '(f, _, _, points2) := x in
  negb (in_plane f q w) ||
  off_pieces points2 (seen f q) w (simplices (plane_mesh f)) (marks (plane_part f)).
Definition cell_point_of (x : domain_point) : option cell_point :=
  match x with
  | AtCorner k =>
      match Table.find k S with
      | Some v => Some (CellPoint v 1 (fun p => negb (same_place p v)))
      | None => None
      end
  | AlongSegment k q w =>
      match Table.find k segments_of with
      | None => None
      | Some s =>
          match Table.find (from s) S, Table.find (last (map reached (links s)) (from s)) S with
          | Some a, Some b =>
              if point_written pr q w && on_segment (times w a) (times w b) q
              then Some (CellPoint q w (fun p => negb (on_segment a b p)))
              else None
          | _, _ => None
          end
      end
  | InPiece k u q w =>
      match Table.find k polygons_of with
      | None => None
      | Some (f, pieces, marks2, points2) =>
          match piece_of pieces points2 u with
          | None => None
          | Some Y =>
              if point_written pr q w && kept_at marks2 u && in_plane f q w &&
                 proper plane_predicates Y && in_simplex plane_predicates Y (seen f q) w
              then Some (CellPoint q w (fun p => off_polygon p 1 (f, pieces, marks2, points2)))
              else None
          end
      end
  end.

(** ** What can be seen *)

(** The plane has the points K on one side, or in it, and the way from q / w to v on the other, but
    perhaps for v. *)
Definition parts_from (q : site) (w : Z) (v : site) (K : list site) (h : list Z * Z) : bool :=
  Nat.eqb (length (fst h)) (dimension pr) && (w * snd h <? inner_product (fst h) (coordinates q)) &&
  (snd h <=? inner_product (fst h) (coordinates v)) &&
  forallb (fun k => inner_product (fst h) (coordinates k) <=? snd h) K.
Fixpoint off_kept (off : list site -> bool) (above_of : Table.t positive) (l : list simplex_entry)
  (l' : list mark) : bool :=
  match l, l' with
  | e :: r, m :: r' =>
      (negb (kept m) ||
       match find_all S (named_above above_of (corners e)) with Some Y => off Y | None =>
         false end) &&
      off_kept off above_of r r'
  | _, _ => true
  end.
(** Each vertex, segment and kept triangle of a polygon is off. *)
Definition all_off (off : list site -> bool) : bool :=
  forallb (fun e => off [bare e]) (points c) &&
  forallb (fun s => match Table.find (from s) S, Table.find (last (map reached (links s)) (from s))
    S with
                    | Some a, Some b => off [a; b]
                    | _, _ => false
                    end) (segments (domain_part D)) &&
  forallb (fun f => off_kept off (Table.of_list id (above f)) (simplices (plane_mesh f))
    (marks (plane_part f)))
    (polygons D).
Definition sees (v q : site) (w : Z) (planes : list (list Z * Z)) : bool :=
  all_off (fun K => existsb (parts_from q w v K) planes).
(** The same for the way from q / w to q' / w', its end included. *)
Definition parts_leg (q : site) (w : Z) (q' : site) (w' : Z) (K : list site) (h : list Z * Z) :
  bool :=
  Nat.eqb (length (fst h)) (dimension pr) && (w * snd h <? inner_product (fst h) (coordinates q)) &&
  (w' * snd h <? inner_product (fst h) (coordinates q')) &&
  forallb (fun k => inner_product (fst h) (coordinates k) <=? snd h) K.
Definition clear_leg (q : site) (w : Z) (q' : site) (w' : Z) (planes : list (list Z * Z)) : bool :=
  point_written pr q' w' && all_off (fun K => existsb (parts_leg q w q' w' K) planes).

(** ** What is off *)

(** The point is in no wall. *)
Definition off_segment (q : site) (w : Z) (s : segment_entry) : bool :=
  match Table.find (from s) S, Table.find (last (map reached (links s)) (from s)) S with
  | Some a, Some b => negb (same_place a b) && negb (on_segment (times w a) (times w b) q)
  | _, _ => false
  end.
Definition off_walls (q : site) (w : Z) : bool :=
  match dimension pr with
  | 2%nat => forallb (off_segment q w) (segments (domain_part D))
  | _ => forallb (off_polygon q w) polygons_listed
  end.

(** The point is in the relative interior of facet i. *)
Definition inside_facet (X : list site) (i : nat) (q : site) (w : Z) : bool :=
  forallb (fun k => if Nat.eqb k i then coordinate_sign pr X q w k =? 0 else
    0 <? coordinate_sign pr X q w k)
    (corners_numbered pr).
End Given.
