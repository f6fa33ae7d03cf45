(** * The checker of what shows that a domain has no triangulation, or no CDT

    [check_impossible] is extracted; [ImpossibleSound.v] proves what its acceptance means.  The domain is read as that of
    a certificate.  Candidates are all sets of four of its vertices; of each it is said why it is in no triangulation, or that it may
    be.  Clauses about these, each with its reason, hold of every triangulation; together nothing satisfies them. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Refutation DomainChecker DomainRules DomainRefutation Rup.
Import ListNotations.
Open Scope Z_scope.

(** All lists of [n] of the numbers, in their order. *)
Fixpoint sublists (n : nat) (l : list positive) : list (list positive) :=
  match l with
  | [] => match n with O => [[]] | S _ => [] end
  | x :: rest => match n with
                 | O => [[]]
                 | S n' => map (cons x) (sublists n' rest) ++ sublists n rest
                 end
  end.
Fixpoint numbered_from {A} (k : positive) (l : list A) : list positive :=
  match l with [] => [] | _ :: rest => k :: numbered_from (Pos.succ k) rest end.

(** A polygon, with its pieces, their marks and its points in tables. *)
Definition polygon_in_tables : Type := polygon_entry * Table.t simplex_entry * Table.t mark * Table.t site.
Definition in_tables (f : polygon_entry) : polygon_in_tables :=
  (f, Table.of_list id (simplices (plane_mesh f)), Table.of_list id (marks (plane_part f)),
   Table.of_list position (points (plane_mesh f))).

(** A vertex, without a weight. *)
Definition bare (e : point_entry) : site := Site (coordinates (position e)) 0.

Section Impossible.
Variable D : domain_certificate.
Notation c := (whole_mesh D).
Notation pr := space_predicates.

(** ** The domain *)

(** [vertices-listed]: all points are vertices of the domain; [segment-linked] and [hole-inside] ask no more than that
    there is such a segment and such a point. *)
Definition check_corner (k : positive) (e : point_entry) (r : role) : result :=
  require vertices_listed by
    shaped pr (position e) && match r with Corner _ => true | Steiner _ => false end at AtPoint k; Accepted.
Definition check_ends (vertices : Table.t site) (k : positive) (s : segment_entry) : result :=
  require segment_linked by
    match Table.find (from s) vertices, Table.find (last (map reached (links s)) (from s)) vertices with
    | Some _, Some _ => true
    | _, _ => false
    end at AtSegment k; Accepted.
Definition check_hole_point (k : positive) (h : hole_entry) : result :=
  require hole_inside by shaped pr (hole_point h) && (0 <? hole_w h) at AtHole k; Accepted.
Definition check_about : result :=
  require scale by (0 <? numerator c) && (0 <? denominator c) at Nowhere;
  each_pair vertices_listed AtPoint check_corner 1 (points c) (roles (domain_part D)) ;;
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
Definition piece_of (pieces : Table.t simplex_entry) (points2 : Table.t site) (u : positive) : option (list site) :=
  match Table.find u pieces with Some e => find_all points2 (corners e) | None => None end.
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
              then Some (CellPoint q w (fun p => negb (in_plane f p 1)))
              else None
          end
      end
  end.

(** ** What can be seen *)

(** The plane has the points K on one side, or in it, and the way from q / w to v on the other, but perhaps for v. *)
Definition parts_from (q : site) (w : Z) (v : site) (K : list site) (h : list Z * Z) : bool :=
  Nat.eqb (length (fst h)) 3 && (w * snd h <? inner_product (fst h) (coordinates q)) &&
  (snd h <=? inner_product (fst h) (coordinates v)) &&
  forallb (fun k => inner_product (fst h) (coordinates k) <=? snd h) K.
Fixpoint off_kept (off : list site -> bool) (above_of : Table.t positive) (l : list simplex_entry) (l' : list mark) : bool :=
  match l, l' with
  | e :: r, m :: r' =>
      (negb (kept m) ||
       match find_all S (named_above above_of (corners e)) with Some Y => off Y | None => false end) &&
      off_kept off above_of r r'
  | _, _ => true
  end.
Definition sees (v q : site) (w : Z) (planes : list (list Z * Z)) : bool :=
  let off K := existsb (parts_from q w v K) planes in
  forallb (fun e => off [bare e]) (points c) &&
  forallb (fun s => match Table.find (from s) S, Table.find (last (map reached (links s)) (from s)) S with
                    | Some a, Some b => off [a; b]
                    | _, _ => false
                    end) (segments (domain_part D)) &&
  forallb (fun f => off_kept off (Table.of_list id (above f)) (simplices (plane_mesh f)) (marks (plane_part f)))
    (polygons D).

(** ** Candidates *)

(** [fate-shown] *)
Definition fate_holds (K : list positive) (e : fate) : bool :=
  match find_all S K with
  | None => false
  | Some X =>
      match e with
      | Flat => negb (proper pr X)
      | MayBeChosen => proper pr X
      | Pierced x => proper pr X &&
          match cell_point_of x with
          | None => false
          | Some y => in_simplex pr X (cell_site y) (cell_w y) &&
              existsb (beside y) (carrier_of pr X (cell_site y) (cell_w y))
          end
      | Encroached k q w planes =>
          match domain_claimed D with Cdt => true | _ => false end &&
          proper pr X && point_written pr q w && strictly_in_simplex pr X q w &&
          match Table.find k S with
          | Some v => (0 <? below_sign pr X v) && sees v q w planes
          | None => false
          end
      end
  end.
Definition check_fate (k : positive) (K : list positive) (e : fate) : result :=
  require fate_shown by fate_holds K e at AtCandidate k; Accepted.

Variable candidates : list (list positive).
Variable candidates_of : Table.t (list positive).
Variable fates_of : Table.t fate.
Definition may_be_chosen (k : positive) : bool :=
  match Table.find k fates_of with Some MayBeChosen => true | _ => false end.
(** The vertices of candidate K. *)
Definition candidate_at (k : positive) : option (list site) :=
  match Table.find k candidates_of with Some K => find_all S K | None => None end.

(** ** Clauses *)

(** The point is seen in none of the kept triangles, or is not in the plane. *)
Fixpoint off_pieces (points2 : Table.t site) (q : site) (w : Z) (l : list simplex_entry) (l' : list mark) : bool :=
  match l, l' with
  | e :: r, m :: r' =>
      (negb (kept m) ||
       match find_all points2 (corners e) with
       | Some Y => proper plane_predicates Y && existsb (beyond plane_predicates Y q w) [0; 1; 2]%nat
       | None => false
       end) && off_pieces points2 q w r r'
  | _, _ => true
  end.
Definition off_polygon (q : site) (w : Z) (x : polygon_in_tables) : bool :=
  let '(f, _, _, points2) := x in
  negb (in_plane f q w) ||
  off_pieces points2 (seen f q) w (simplices (plane_mesh f)) (marks (plane_part f)).

(** The point is in the relative interior of facet i. *)
Definition inside_facet (X : list site) (i : nat) (q : site) (w : Z) : bool :=
  forallb (fun k => if Nat.eqb k i then coordinate_sign pr X q w k =? 0 else 0 <? coordinate_sign pr X q w k)
    (corners_numbered pr).
Definition listed_beside (K : list positive) (X : list site) (i : nat) (l : list positive) (k : positive) (p : site) : bool :=
  negb (beyond pr X p 1 i) ||
  existsb (fun n => match Table.find n candidates_of with
                    | Some L => same_members L (k :: remove i K)
                    | None => false
                    end) l.
Fixpoint all_beside (K : list positive) (X : list site) (i : nat) (l : list positive) (k : positive)
    (points : list point_entry) : bool :=
  match points with
  | [] => true
  | e :: r => listed_beside K X i l k (bare e) && all_beside K X i l (Pos.succ k) r
  end.
(** The clause, if the reason is one. *)
Definition clause_of (r : reason) : option clause :=
  match r with
  | OneCovers x =>
      match cell_point_of x with
      | None => None
      | Some y => Some (map (pair true) (filter (fun k => may_be_chosen k &&
          match candidate_at k with
          | Some X => in_simplex pr X (cell_site y) (cell_w y)
          | None => false
          end) (numbered_from 1 candidates)))
      end
  | NotBoth s u q w =>
      match candidate_at s, candidate_at u with
      | Some X, Some Y =>
          if may_be_chosen s && may_be_chosen u && overlapping pr X Y q w
          then Some [(false, s); (false, u)] else None
      | _, _ => None
      end
  | OneBeside s i q w l =>
      match Table.find s candidates_of, candidate_at s with
      | Some K, Some X =>
          if may_be_chosen s && Nat.ltb i 4 && point_written pr q w && inside_facet X i q w &&
             match kind D with
             | Hull => existsb (fun e => beyond pr X (bare e) 1 i) (points c)
             | Enclosed => forallb (off_polygon q w) polygons_listed
             end &&
             all_beside K X i l 1 (points c)
          then Some ((false, s) :: map (pair true) (filter may_be_chosen l)) else None
      | _, _ => None
      end
  end.
(** The clauses, or the number of the first that has no reason. *)
Fixpoint clauses_of (k : positive) (l : list reason) : list clause + positive :=
  match l with
  | [] => inl []
  | r :: rest => match clause_of r with
                 | None => inr k
                 | Some x => match clauses_of (Pos.succ k) rest with
                             | inl y => inl (x :: y)
                             | inr n => inr n
                             end
                 end
  end.
End Impossible.

(** ** The whole

    [reason-shown], [clauses-refuted] *)
Definition check_impossible (x : impossibility) : result :=
  let D := about x in
  let S := Table.of_list bare (points (whole_mesh D)) in
  let segments_of := Table.of_list id (segments (domain_part D)) in
  let polygons_listed := map in_tables (polygons D) in
  let polygons_of := Table.of_list id polygons_listed in
  let candidates := sublists 4 (numbered_from 1 (points (whole_mesh D))) in
  let candidates_of := Table.of_list id candidates in
  let fates_of := Table.of_list id (fates x) in
  check_about D ;;
  each_pair fate_shown AtCandidate (check_fate D S segments_of polygons_of) 1 candidates (fates x) ;;
  match clauses_of D S segments_of polygons_listed polygons_of candidates candidates_of fates_of 1 (reasons x) with
  | inr k => Rejected reason_shown (AtReason k)
  | inl l => require clauses_refuted by refuted_clauses l (steps x) at Nowhere; Accepted
  end.
