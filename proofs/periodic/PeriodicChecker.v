(** * The checker of certificates of meshes that a lattice repeats

    [check_periodic] and [refute_periodic] are extracted; [PeriodicSound.v] and [PeriodicRefuted.v]
    prove what their acceptance means.  A moved cell is that cell with moved points, so all is said
    in the words of [Refutation.v].  What is asked of infinitely many moves is asked of those within
    [reach]; the dual basis tells that the others are too far away ([everywhere]). *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Refutation DomainChecker Periodic.
From Circumspect Require Table.
Import ListNotations.
Open Scope Z_scope.

Fixpoint every {A} (f : positive -> A -> bool) (k : positive) (l : list A) : bool :=
  match l with [] => true | a :: l' => f k a && every f (Pos.succ k) l' end.

(** ** The lattice *)

Fixpoint add_numbers (k l : list Z) : list Z :=
  match k, l with x :: k', y :: l' => x + y :: add_numbers k' l' | _, _ => [] end.
Definition opposite_numbers : list Z -> list Z := map Z.opp.
Definition all_zero : list Z -> bool := forallb (Z.eqb 0).

(** The tables are those of the points, the cells and their links: they are made once. *)
Section Mesh.
Variables (pr : predicates) (m : periodic_mesh).
Variables (points_table : Table.t site) (cells_table : Table.t (list corner)).

(** [lattice-proper]: without it the vectors could be no basis, or others than the dual basis
    knows. *)
Definition of_dimension (l : list Z) : bool := Nat.eqb (length l) (dimension pr).
Definition numbered_rows (l : list (list Z)) := combine (seq 0 (length l)) l.
Definition proper_lattice : bool :=
  Nat.eqb (length (basis_rows m)) (dimension pr) && Nat.eqb (length (dual_rows m)) (dimension pr) &&
  forallb of_dimension (basis_rows m) && forallb of_dimension (dual_rows m) &&
  (0 <? dual_factor m) &&
  forallb (fun x => forallb (fun y => inner_product (snd x) (snd y) =?
    if Nat.eqb (fst x) (fst y) then dual_factor m else 0) (numbered_rows (basis_rows m)))
    (numbered_rows (dual_rows m)).

Definition shift_numbers (o p : list Z) : list Z :=
  fold_right (fun zb s => add_numbers (map (Z.mul (fst zb)) (snd zb)) s) p
    (combine o (basis_rows m)).
Definition shifted (o : list Z) (p : site) : site := Site (shift_numbers o (coordinates p)) 0.

(** [vertex-known] *)
Definition corner_site (k : corner) : option site :=
  if of_dimension (corner_offset k) then
    match Table.find (corner_point k) points_table with
    | Some p => Some (shifted (corner_offset k) p)
    | None => None
    end
  else None.
Fixpoint corner_sites (l : list corner) : option (list site) :=
  match l with
  | [] => Some []
  | k :: l' => match corner_site k, corner_sites l' with
               | Some p, Some X => Some (p :: X)
               | _, _ => None
               end
  end.
(** The d+1 corners of a cell. *)
Definition cell_sites (l : list corner) : option (list site) :=
  if right_length pr l then corner_sites l else None.
Definition cell_at (t : positive) (f : list site -> bool) : bool :=
  match Table.find t cells_table with
  | Some l => match cell_sites l with Some X => f X | None => false end
  | None => false
  end.

(** ** All moves *)

Fixpoint consecutive (z : Z) (l : list Z) : bool :=
  match l with [] => true | y :: l' => (y =? z + 1) && consecutive y l' end.
(** Along one vector of the dual basis: the multiples within reach at which the points [X] are not
    all on one side of q / w; nothing if they may be so beyond. *)
Definition not_apart (X : list site) (q : site) (w : Z) (n : list Z) : option (list Z) :=
  match reach m with
  | [] => None
  | z :: l =>
      let values := map (fun p => w * inner_product n (coordinates p)) X in
      let value := inner_product n (coordinates q) in
      let step := w * dual_factor m in
      let below k := forallb (fun x => x + k * step <? value) values in
      let above k := forallb (fun x => value <? x + k * step) values in
      if consecutive z l && below (z - 1) && above (last l z + 1)
      then Some (filter (fun k => negb (below k || above k)) (reach m)) else None
  end.
Fixpoint each_axis (X : list site) (q : site) (w : Z) (l : list (list Z)) :
    option (list (list Z)) :=
  match l with
  | [] => Some []
  | n :: l' => match not_apart X q w n, each_axis X q w l' with
               | Some k, Some r => Some (k :: r)
               | _, _ => None
               end
  end.
Fixpoint choices (l : list (list Z)) : list (list Z) :=
  match l with
  | [] => [[]]
  | k :: l' => flat_map (fun z => map (cons z) (choices l')) k
  end.
(** Wherever the points [X] are moved so that q / w may be in their hull, the test holds. *)
Definition everywhere (X : list site) (q : site) (w : Z) (test : list Z -> bool) : bool :=
  match each_axis X q w (dual_rows m) with
  | Some l => forallb test (choices l)
  | None => false
  end.

(** ** Certificates *)

Section Certificate.
Variables (c : periodic_certificate) (links_table : Table.t (list next_entry)).

(** [back-pointer] *)
Definition links_back (t : positive) (i : nat) (u : positive) (j : nat) (o : list Z) : bool :=
  match Table.find u links_table with
  | Some l => match nth_error l j with
              | Some (NextEntry t' i' o') => Pos.eqb t' t && Nat.eqb i' i &&
                  same_numbers o' (opposite_numbers o)
              | None => false
              end
  | None => false
  end.
(** [facet-matched], [facet-locally-delaunay] *)
Definition check_link (t : positive) (X : list site) (i : nat) (k : next_entry) : result :=
  let '(NextEntry u j o) := k in
  require facet_matched by of_dimension o && cell_at u (fun Y =>
    let Y' := map (shifted o) Y in
    same_facet pr X i Y' j &&
    match nth_error Y' j with Some v => coordinate_sign pr X v 1 i <? 0 | None => false end)
    at AtFacet t i;
  require back_pointer by links_back t i u j o at AtFacet t i;
  require facet_locally_delaunay by cell_at u (fun Y =>
    match nth_error Y j with Some v => below_sign pr X (shifted o v) <=? 0 | None => false end)
    at AtFacet t i;
  Accepted.

(** [sample-outside]: no cell has the sample point, however moved, but the one that is said to. *)
Definition outside (t : positive) (X : list site) : bool :=
  let q := periodic_sample c in let w := periodic_sample_denominator c in
  everywhere X q w (fun o => (Pos.eqb t (periodic_start c) && all_zero o) ||
    existsb (fun i => coordinate_sign pr (map (shifted o) X) q w i <? 0) (corners_numbered pr)).

Definition check_periodic_cell (t : positive) (l : list corner) : result :=
  match cell_sites l with
  | None => Rejected vertex_known (AtSimplex t)
  | Some X =>
      require simplex_proper by proper pr X at AtSimplex t;
      require sample_outside by outside t X at AtSimplex t;
      match Table.find t links_table with
      | None => Rejected facet_matched (AtSimplex t)
      | Some k =>
          require facet_matched by right_length pr k at AtSimplex t;
          each_index (check_link t X) 0 k
      end
  end.

(** [sample-inside] *)
Definition inside_start : bool :=
  let q := periodic_sample c in let w := periodic_sample_denominator c in
  point_written pr q w && cell_at (periodic_start c) (fun X => strictly_in_simplex pr X q w).

(** [point-used] *)
Fixpoint check_homes (k : positive) (P : list site) (l : list (positive * nat)) : result :=
  match P, l with
  | [], _ => Accepted
  | p :: P', (t, i) :: l' =>
      require point_used by
        match Table.find t cells_table with
        | Some r => match nth_error r i with
                    | Some x => Pos.eqb (corner_point x) k
                    | None => false
                    end
        | None => false
        end at AtPoint k;
      check_homes (Pos.succ k) P' l'
  | _, _ => Rejected point_used (AtPoint k)
  end.
End Certificate.

Definition proper_periodic : bool :=
  (0 <? periodic_numerator m) && (0 <? periodic_denominator m) && forallb (shaped pr)
    (periodic_sites m).

(** ** Refutations *)

Definition shown_in_periodic (e : periodic_evidence) : bool :=
  match e with
  | CellFlat t => cell_at t (fun X => negb (proper pr X))
  | CellRepeated t u o => of_dimension o && negb (Pos.eqb t u) && cell_at t (fun X =>
      cell_at u (fun Y => same_places X (map (shifted o) Y)))
  (* some vertex of the facet is no vertex of the moved cell *)
  | FacetOpen t i => cell_at t (fun X => proper pr X && Nat.ltb i (S (dimension pr)) &&
      match remove i X with
      | [] => false
      | v :: _ =>
          every (fun u l => match cell_sites l with
            | Some Y => everywhere Y v 1 (fun o => (Pos.eqb u t && all_zero o) ||
                negb (all_among (remove i X) (map (shifted o) Y)))
            | None => false
            end) 1 (cells m)
      end)
  | CellsOverlap t u o q w => point_written pr q w && of_dimension o &&
      (negb (Pos.eqb t u) || negb (all_zero o)) && cell_at t (fun X => cell_at u (fun Y =>
        proper pr X && proper pr (map (shifted o) Y) && strictly_in_simplex pr X q w &&
        in_simplex pr (map (shifted o) Y) q w))
  | PointLeftOut p => match Table.find p points_table with
      | Some s => forallb (fun l => match corner_sites l with
          | Some Y => forallb (fun v =>
              everywhere [s] v 1 (fun o => negb (same_place (shifted o s) v))) Y
          | None => false
          end) (cells m)
      | None => false
      end
  | BallNotEmpty t p o => of_dimension o && cell_at t (fun X => proper pr X &&
      match Table.find p points_table with
      | Some s => 0 <? below_sign pr X (shifted o s)
      | None => false
      end)
  end.
End Mesh.

Definition points_found (m : periodic_mesh) := Table.of_list id (periodic_sites m).
Definition cells_found (m : periodic_mesh) := Table.of_list id (cells m).

Definition check_periodic (D : plane_or_space) (c : periodic_certificate) : result :=
  let pr := predicates_of D in let m := periodic_mesh_of c in
  let P := points_found m in let C := cells_found m in
  require scale by proper_periodic pr m at Nowhere;
  require lattice_proper by proper_lattice pr m at Nowhere;
  check_homes C 1 (periodic_sites m) (homes c) ;;
  (require sample_inside by inside_start pr m P C c at Nowhere;
   each (check_periodic_cell pr m P C c (Table.of_list id (cell_links c))) 1 (cells m)).

Definition refute_periodic (D : plane_or_space) (x : periodic_refutation) : bool :=
  let pr := predicates_of D in let m := periodic_against x in
  proper_periodic pr m && proper_lattice pr m &&
  shown_in_periodic pr m (points_found m) (cells_found m) (periodic_because x).
