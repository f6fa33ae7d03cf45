(** * The checker of certificates of surfaces

    [check_surface] is extracted; [SurfaceSound.v] proves what its acceptance means.  All edges of
    all triangles are in one list, in order: those that are the same edge stand side by side.  So
    each edge is compared with its neighbours in the list, and nothing is searched. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Checker DomainChecker Surfaces.
From Circumspect Require Table.
Import ListNotations.
Open Scope Z_scope.

(** ** Angles *)

(** The cotangent of the angle at [o] between the ways to [p] and [q] is x / sqrt a. *)
Definition cotangent (o p q : site) : Z * Z :=
  let u := differences (coordinates p) (coordinates o) in
  let v := differences (coordinates q) (coordinates o) in
  let x := inner_product u v in (x, inner_product u u * inner_product v v - x * x).

(** x / sqrt a + y / sqrt b is not negative: if x and y have opposite signs, squares tell it. *)
Definition at_most_pi (A B : Z * Z) : bool :=
  let '(x, a) := A in let '(y, b) := B in
  if 0 <=? x then (0 <=? y) || (y * y * a <=? x * x * b)
  else (0 <=? y) && (x * x * b <=? y * y * a).

Definition on_no_line (X : list site) : bool :=
  match X with [o; p; q] => 0 <? snd (cotangent o p q) | _ => false end.

(** The vertex with number [i], and the others. *)
Definition split3 {A} (i : nat) (X : list A) : option (A * A * A) :=
  match X, i with
  | [x; y; z], 0%nat => Some (x, y, z)
  | [x; y; z], 1%nat => Some (y, x, z)
  | [x; y; z], 2%nat => Some (z, x, y)
  | _, _ => None
  end.

(** ** Certificates *)

(** An edge of a triangle, by the numbers of its ends, the lower one first, and the vertex
    opposite. *)
Record edge := Edge { low : positive; high : positive; facing : positive }.
Definition same_edge (x y : edge) : bool := Pos.eqb (low x) (low y) && Pos.eqb (high x) (high y).
Definition edge_before (x y : edge) : bool :=
  Pos.ltb (low x) (low y) || (Pos.eqb (low x) (low y) &&
  (Pos.ltb (high x) (high y) || (Pos.eqb (high x) (high y) && Pos.ltb (facing x) (facing y)))).

Section Surface.
Variables (pr : predicates) (c : surface_certificate).
Let points_table := Table.of_list position (surface_points c).
Let triangles_table := Table.of_list id (surface_triangles c).
Let edges_table := Table.of_list id (surface_edges c).

(** [vertex-known]; [simplex-proper]: without it a triangle could be flat; [edge-listed]: or one
    that has an edge in common with another would not be looked at ([edge_number]). *)
Definition edge_stands (t : positive) (e : triangle_entry) (i : nat) : bool :=
  match nth_error (triangle_edges e) i with
  | None => false
  | Some k => match Table.find k edges_table with
              | Some (u, j) => Pos.eqb u t && Nat.eqb j i
              | None => false
              end
  end.
Definition check_triangle (t : positive) (e : triangle_entry) : result :=
  match find_all points_table (triangle_vertices e) with
  | None => Rejected vertex_known (AtSimplex t)
  | Some X =>
      require simplex_proper by on_no_line X at AtSimplex t;
      require edge_listed by forallb (edge_stands t e) [0; 1; 2]%nat at AtSimplex t; Accepted
  end.

Definition edge_number (k : positive) : option edge :=
  match Table.find k edges_table with
  | None => None
  | Some (t, i) =>
      match Table.find t triangles_table with
      | None => None
      | Some e => match split3 i (triangle_vertices e) with
                  | None => None
                  | Some (o, p, q) => Some (if Pos.ltb p q then Edge p q o else Edge q p o)
                  end
      end
  end.
Definition also (k : positive) (x : edge) : bool :=
  match edge_number k with Some y => same_edge y x | None => false end.
(** The angles opposite the edge, in its two triangles. *)
Definition narrow (x y : edge) : bool :=
  match find_all points_table [facing x; facing y; low x; high x] with
  | Some [a; b; p; q] => at_most_pi (cotangent a p q) (cotangent b p q)
  | _ => false
  end.

(** [edges-increasing]: without it the triangles of an edge could be apart in the list, and a
    triangle be listed twice ([two_in_order]).  [edge-delaunay] is what is claimed of an edge that
    neither the one before nor the one after these two is. *)
Definition check_edge (k : positive) (_ : positive * nat) : result :=
  match edge_number k with
  | None => Rejected edge_listed (AtEdge k)
  | Some x =>
      match edge_number (Pos.succ k) with
      | None => Accepted
      | Some y =>
          require edges_increasing by edge_before x y at AtEdge k;
          require edge_delaunay by
            negb (same_edge x y) || (negb (Pos.eqb k 1) && also (Pos.pred k) x) ||
            also (Pos.succ (Pos.succ k)) x || narrow x y at AtEdge k;
          Accepted
      end
  end.

Definition check_surface_in : result :=
  require Checker.scale by (0 <? surface_numerator c) && (0 <? surface_denominator c) at Nowhere;
  check_points pr (surface_points c) ;;
  (require simplex_listed by match surface_triangles c with [] => false | _ => true end at Nowhere;
   each check_triangle 1 (surface_triangles c)) ;;
  each check_edge 1 (surface_edges c).
End Surface.

Definition check_surface (D : plane_or_space) (c : surface_certificate) : result :=
  check_surface_in (predicates_of D) c.
