(** * The checker of refutations of claims about domains

    [refute_domain] is extracted; [DomainRefuted.v] proves what its acceptance means. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Refutation DomainChecker DomainRules.
Import ListNotations.
Open Scope Z_scope.

(** The evidence is about simplices alone, or about balls that have to be empty for the claim. *)
Definition of_mesh (e : evidence) (c : domain_claim) : bool :=
  match e with
  | WrongDimension _ | UnknownVertex _ _ | RepeatedVertex _ _ _ | Degenerate _ | DuplicateSimplex _
      _
  | Overlap _ _ _ _ | CoveredTwice _ _ _ _ => true
  | VertexInBall _ _ | FacetNotLocal _ _ _ _ => match c with ConformingDelaunay => true | _ =>
      false end
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

(** Nothing beyond the first n + 1 entries is looked at. *)
Fixpoint has_at_most {A} (n : nat) (l : list A) : bool :=
  match l, n with
  | [], _ => true
  | _ :: l', Datatypes.S n' => has_at_most n' l'
  | _, O => false
  end.
(** The vertices of a simplex that may dangle: there may be fewer than d+1. *)
Definition face_of (r : row) : option (list site) :=
  if has_at_most (Datatypes.S (dimension pr)) r then all_named S r else None.
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
                row_at rows_of u (fun y => match face_of y with
                  | Some X => match nth_error X j, nth_error X k with
                    | Some e, Some f => negb (same_place p e) && negb (same_place p f) &&
                        on_segment e f p
                    | _, _ => false
                    end
                  | None => false
                  end) | None => false end)
          | _, _ => false
          end
      | None => false
      end
  | NoEmptyBall _ _ _ | OfMesh => false
  end.
End Evidence.

(** ** What may dangle

    Its rows come after the simplices: as the caller has listed them, or made d-simplices by points
    on which the claim does not depend.  A point that is in none of these is in none of their
    faces. *)
(** Lists of millions, without recursion that is as deep. *)
Definition appended {A} (l l' : list A) : list A := rev_append (rev' l) l'.
Fixpoint mapped_onto {A B} (f : A -> B) (l : list A) (made : list B) : list B :=
  match l with [] => made | a :: l' => mapped_onto f l' (f a :: made) end.
Definition mapped {A B} (f : A -> B) (l : list A) : list B := rev' (mapped_onto f l []).

Section Dangling.
Variables (m : refutation) (x : dangling_part).
Definition with_rows (S : list site) (l : list row) : refutation :=
  Refutation (refuted m) (unit_numerator m) (unit_denominator m) S l (basis m) (because m).
Definition as_listed : refutation :=
  with_rows (sites m) (appended (rows m) (mapped fst (dangling x))).
Definition padded : refutation :=
  with_rows (appended (sites m) (pads x))
    (appended (rows m) (mapped (fun ab => fst ab ++ snd ab) (dangling x))).
Definition known_in (S : Table.t site) (n : option positive) : bool :=
  match named S n with Some _ => true | None => false end.
Definition pads_known : bool :=
  let S := Table.of_list (site_for Delaunay) (sites padded) in
  forallb (fun ab => forallb (known_in S) (snd ab)) (dangling x).

(** The simplex T, made full, and how many of its vertices are its own. *)
Definition own_at (pr : predicates) (S own : Table.t site) (entries : Table.t (row * row))
  (t : positive)
    (f : list site -> nat -> bool) : bool :=
  match Table.find t entries with
  | Some (a, b) => forallb (known_in own) a &&
      match proper_simplex_of pr S (a ++ b) with Some X => f X (length a) | None => false end
  | None => false
  end.
(** The point is in the hull of the first N vertices. *)
Definition in_own (pr : predicates) (X : list site) (n : nat) (q : site) (w : Z) : bool :=
  in_simplex pr X q w && forallb (fun v => existsb (same_place v) (firstn n X))
    (carrier_of pr X q w).
Definition own_simplex_at (pr : predicates) (t : positive) (f : list site -> nat -> bool) : bool :=
  own_at pr (Table.of_list (site_for Delaunay) (sites padded)) (Table.of_list (site_for Delaunay)
    (sites m))
    (Table.of_list id (appended (mapped (fun r => (r, [])) (rows m)) (dangling x))) t f.
(** No simplex lists all of these points. *)
Definition in_no_row (S : Table.t site) (X : list site) : bool :=
  forallb (fun y => negb (forallb (fun p => lists S p y) X)) (rows m).
Definition overlap_of_all (pr : predicates) (t u : positive) (q : site) (w : Z) : bool :=
  own_simplex_at pr t (fun X i => in_own pr X i q w &&
    own_simplex_at pr u (fun Y j => in_own pr Y j q w && overlapping pr X Y q w)).
End Dangling.

(** ** Balls

    With weights that are not negative but for the vertices of the simplex, points whose weights and
    weighted sum are zero, and the weighted sum of their squares is negative: every circumball of
    the simplex has one of the others inside. *)
Definition sum_of (f : site -> Z) (l : list (Z * site)) : Z :=
  fold_right (fun zp s => fst zp * f (snd zp) + s) 0 l.
Fixpoint weighted_points (S : Table.t site) (l : list (positive * Z)) : option (list (Z * site)) :=
  match l with
  | [] => Some []
  | (k, z) :: l' => match Table.find k S, weighted_points S l' with
                    | Some p, Some X => Some ((z, p) :: X)
                    | _, _ => None
                    end
  end.
Definition no_ball (pr : predicates) (own others : list (Z * site)) : bool :=
  let l := own ++ others in
  forallb (fun zp => 0 <=? fst zp) others && (sum_of (fun _ => 1) l =? 0) &&
  forallb (fun j => sum_of (fun p => nth j (coordinates p) 0) l =? 0) (seq 0 (dimension pr)) &&
  (sum_of (fun p => inner_product (coordinates p) (coordinates p)) l <? 0).
Definition ball_shown (pr : predicates) (m : refutation) (x : dangling_part) (u : positive)
  (own : list Z)
    (others : list (positive * Z)) : bool :=
  match weighted_points (Table.of_list (site_for Delaunay) (sites m)) others with
  | Some Y => own_simplex_at m x pr u (fun X n =>
      no_ball pr (combine own (firstn n X)) Y &&
      in_no_row m (Table.of_list (site_for Delaunay) (sites (padded m x))) (firstn n X))
  | None => false
  end.

(** With fewer vertices than d+1 a row may dangle. *)
Definition no_simplex_row (pr : predicates) (r : row) : bool :=
  match r with [] => true | _ => negb (has_at_most (Datatypes.S (dimension pr)) r) end.

(** Whatever dangles, the evidence is about these rows. *)
Definition shows_domain (pr : predicates) (m : refutation) (r : domain_refutation) : bool :=
  (0 <? unit_numerator m) && (0 <? unit_denominator m) &&
  forallb (shaped pr) (sites m) && forallb (shaped pr) (vertices_given r) &&
  holds_of_domain pr (Table.of_list (site_for (refuted m)) (sites m)) (Table.of_list id (rows m))
    (rows m) (vertices_given r)
    (Table.of_list id (vertices_given r)) (Table.of_list id (segments_given r)) (domain_because r).
Definition lists_in_mesh (m : refutation) (p : positive) : bool :=
  let S := Table.of_list (site_for Delaunay) (sites m) in
  point_at S p (fun q => existsb (lists S q) (rows m)).
Definition given_in_mesh (m : refutation) (V : list site) (p : positive) : bool :=
  point_at (Table.of_list (site_for Delaunay) (sites m)) p (fun q => existsb (same_place q) V).

Definition refute_domain_in (pr : predicates) (r : domain_refutation) : bool :=
  let m := mesh_refuted r in
  let x := dangling_refuted r in
  match refuted m with Delaunay => true | _ => false end &&
  match domain_because r with
  | OfMesh => of_mesh (because m) (domain_refuted r) &&
      match because m with
      | Overlap t u q w => (0 <? unit_numerator m) && (0 <? unit_denominator m) &&
          forallb (shaped pr) (sites (padded m x)) && overlap_of_all m x pr t u q w
      | VertexInBall t p => refute_in pr m && (lists_in_mesh (as_listed m x) p ||
          given_in_mesh m (vertices_given r) p && forallb (shaped pr) (vertices_given r))
      | WrongDimension t => refute_in pr m &&
          row_at (Table.of_list id (rows m)) t (no_simplex_row pr)
      | _ => refute_in pr m
      end
  | SteinerForbidden _ _ => only_vertices (domain_refuted r) && shows_domain pr (as_listed m x) r
  | SegmentMissing _ _ _ => pads_known m x && shows_domain pr (padded m x) r
  | NoEmptyBall u own others => match domain_refuted r with ConformingDelaunay => true | _ =>
      false end &&
      (0 <? unit_numerator m) && (0 <? unit_denominator m) &&
        forallb (shaped pr) (sites (padded m x)) &&
      forallb (shaped pr) (vertices_given r) && has_at_most (dimension pr + 2) others &&
      forallb (fun kz => given_in_mesh m (vertices_given r) (fst kz) ||
        lists_in_mesh (as_listed m x) (fst kz)) others &&
      ball_shown pr m x u own others
  | _ => shows_domain pr (as_listed m x) r
  end.
Definition refute_domain (D : plane_or_space) (r : domain_refutation) : bool :=
  refute_domain_in (predicates_of D) r.
