(** * The checker of certificates of a mesh alone

    [check_alone] is extracted; [MeshAloneSound.v] proves what its acceptance means.  Every two
    simplices are parted by a hyperplane.  Most are far apart: the boxes of a tree tell it.  Of the
    others most are parted by the hyperplane of a facet; for the rest the certificate names one. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Checker DomainChecker Complexes.
From Circumspect Require Table.
Import ListNotations.
Open Scope Z_scope.

(** ** Hyperplanes *)

(** Where <n, p> = o. *)
Definition hyperplane := (list Z * Z)%type.
Definition value (h : hyperplane) (p : list Z) : Z := inner_product (fst h) p - snd h.
Definition opposite_of (h : hyperplane) : hyperplane := (map Z.opp (fst h), - snd h).

Definition plane_through (X : list (list Z)) : hyperplane :=
  match X with
  | [[x; y]; [u; v]] => let n := [y - v; u - x] in (n, inner_product n [x; y])
  | [[a; b; c]; [x; y; z]; [u; v; w]] =>
      let '(l, m, n) := cross3 (x - a, y - b, z - c) (u - a, v - b, w - c) in
        ([l; m; n], l * a + m * b + n * c)
  | _ => ([], 0)
  end.
(** Through all vertices but number i, which is on the side where it is negative.  (Nothing depends
    on this being so.) *)
Definition facet_plane (X : list (list Z)) (i : nat) : hyperplane :=
  let h := plane_through (remove i X) in
  if 0 <? value h (nth i X []) then opposite_of h else h.
(** The hyperplanes of the facets; or, of a simplex in a hyperplane, this one, which has two
    sides. *)
Definition own_planes (d : nat) (X : list (list Z)) : list hyperplane :=
  let n := length X in
  if Nat.eqb n (S d) then map (facet_plane X) (seq 0 n)
  else if Nat.eqb n d then let h := plane_through X in [h; opposite_of h] else [].

(** ** Simplices, and the boxes around them *)

Record cell := Cell {
  cell_number : positive;
  corner_places : list (positive * list Z);                    (* the vertices, by their numbers *)
  planes_of : list hyperplane;
  parted_from : list (positive * hyperplane)
}.
Definition among (k : positive) (B : list (positive * list Z)) : bool :=
  existsb (fun v => Pos.eqb k (fst v)) B.

(** [simplices-parted]: nowhere negative on A, nowhere positive on B, and where it is zero on A
    there is a vertex of B. *)
Definition parts (h : hyperplane) (d : nat) (A B : list (positive * list Z)) : bool :=
  Nat.eqb (length (fst h)) d &&
  forallb (fun v => let x := value h (snd v) in (0 <? x) || ((x =? 0) && among (fst v) B)) A &&
  forallb (fun v => value h (snd v) <=? 0) B.

Definition parted (d : nat) (a b : cell) : bool :=
  let A := corner_places a in
  let B := corner_places b in
  negb (forallb (fun v => among (fst v) B) A) &&
  (existsb (fun h => parts h d B A) (planes_of a) ||
    existsb (fun h => parts h d A B) (planes_of b) ||
   existsb (fun uh => Pos.eqb (fst uh) (cell_number b) && parts (snd uh) d A B) (parted_from a) ||
   existsb (fun uh => Pos.eqb (fst uh) (cell_number a) && parts (snd uh) d B A) (parted_from b)).

(** A box: an interval for each coordinate. *)
Definition box := list (Z * Z).
Fixpoint around (b c : box) : box :=
  match b, c with
  | (l, h) :: b', (m, k) :: c' => (if l <=? m then l else m, if h <=? k then k else h) :: around b'
      c'
  | _, _ => []
  end.
Fixpoint box_of (X : list (list Z)) : box :=
  match X with
  | [] => []
  | [p] => map (fun x => (x, x)) p
  | p :: X' => around (map (fun x => (x, x)) p) (box_of X')
  end.
Fixpoint apart (b c : box) : bool :=
  match b, c with
  | (l, h) :: b', (m, k) :: c' => (h <? m) || (k <? l) || apart b' c'
  | _, _ => false
  end.

(** ** The tree *)

Inductive tree := Leaf (b : box) (a : cell) | Node (b : box) (l r : tree).
Definition box_around (t : tree) : box := match t with Leaf b _ | Node b _ _ => b end.
Definition joined (l r : tree) : tree := Node (around (box_around l) (box_around r)) l r.

(** Each two neighbours become one, until there is one. *)
Fixpoint pair_up (made l : list tree) : list tree :=
  match l with
  | t :: u :: l' => pair_up (joined t u :: made) l'
  | [t] => t :: made
  | [] => made
  end.
Fixpoint grown (levels : nat) (l : list tree) : option tree :=
  match levels, l with
  | _, [t] => Some t
  | S n, _ :: _ => grown n (pair_up [] l)
  | _, _ => None
  end.

Section Tree.
Variable d : nat.
Definition parted_cells (a b : cell) : result :=
  require simplices_parted by parted d a b at AtSimplex (cell_number a); Accepted.
Fixpoint parted_from_all (b : box) (a : cell) (t : tree) : result :=
  if apart b (box_around t) then Accepted
  else match t with
       | Leaf _ c => parted_cells a c
       | Node _ l r => parted_from_all b a l ;; parted_from_all b a r
       end.
Fixpoint parted_trees (t u : tree) : result :=
  if apart (box_around t) (box_around u) then Accepted
  else match t with
       | Leaf b a => parted_from_all b a u
       | Node _ l r => parted_trees l u ;; parted_trees r u
       end.
Fixpoint all_parted (t : tree) : result :=
  match t with
  | Leaf _ _ => Accepted
  | Node _ l r => (all_parted l ;; all_parted r) ;; parted_trees l r
  end.
End Tree.

(** ** The whole *)

Section Alone.
Variables (pr : predicates) (unused_allowed : bool) (c : complex_certificate).
Let points_table := Table.of_list position (complex_points c).
Let cells_table := Table.of_list id (complex_cells c).
Let order_table := Table.of_list id (complex_order c).

(** [point-used]: a point is the vertex that it names, or it names none, if that is allowed. *)
Definition vertex_used (k : positive) (e : point_entry) : result :=
  require point_used by
    match home_vertex e with
    | None => unused_allowed
    | Some i =>
        match Table.find (home e) cells_table with
        | Some t => match nth_error (cell_vertices t) i with Some v => Pos.eqb v k | None =>
            false end
        | None => false
        end
    end at AtPoint k; Accepted.

(** [vertex-known]; [simplex-proper]: without it a simplex could be flat; [simplex-listed]: or not
    be looked at. *)
Definition check_cell (k : positive) (e : cell_entry) : result :=
  match find_all points_table (cell_vertices e) with
  | None => Rejected vertex_known (AtSimplex k)
  | Some X =>
      require simplex_proper by
        Nat.eqb (length X) (S (complex_dimension c)) && forallb (shaped pr) (cell_pads e) &&
        negb (orientation pr (X ++ cell_pads e) =? 0) at AtSimplex k;
      require simplex_listed by
        match Table.find (cell_place e) order_table with Some t => Pos.eqb t k | None =>
          false end at AtSimplex k;
      Accepted
  end.

Definition leaf_of (k : positive) : option tree :=
  match Table.find k cells_table with
  | None => None
  | Some e =>
      match find_all points_table (cell_vertices e) with
      | None => None
      | Some X =>
          let places := map coordinates X in
          Some (Leaf (box_of places)
                  (Cell k (combine (cell_vertices e) places) (own_planes (dimension pr) places)
                    (cell_parted e)))
      end
  end.
Fixpoint leaves_of (made : list tree) (l : list positive) : option (list tree) :=
  match l with
  | [] => Some made
  | k :: l' => match leaf_of k with Some t => leaves_of (t :: made) l' | None => None end
  end.

Definition check_alone_in : result :=
  require Checker.scale by (0 <? complex_numerator c) && (0 <? complex_denominator c) at Nowhere;
  check_points pr (complex_points c) ;;
  each vertex_used 1 (complex_points c) ;;
  (require simplex_listed by match complex_cells c with [] => false | _ => true end at Nowhere;
   each check_cell 1 (complex_cells c)) ;;
  match leaves_of [] (complex_order c) with
  | None => Rejected simplex_listed Nowhere
  | Some l => match grown 62 l with
              | None => Rejected simplex_listed Nowhere
              | Some t => all_parted (dimension pr) t
              end
  end.
End Alone.

Definition check_alone (D : plane_or_space) (c : complex_certificate) : result :=
  check_alone_in (predicates_of D) false c.
(** The same, where points may be no vertices. *)
Definition check_some_unused (D : plane_or_space) (c : complex_certificate) : result :=
  check_alone_in (predicates_of D) true c.
