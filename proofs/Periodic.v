(** * Meshes that a lattice repeats: what the claim [periodic-delaunay] says, and what its
    certificates and refutations hold

    docs/theory/questions.md has the same definition in words.  [CERTIFICATE.md] describes the
    files. *)
From Coq Require Import String Rbase Rfunctions List ZArith.
From Circumspect Require Import Definitions.
Import ListNotations.
Open Scope R_scope.

Section Periodic.
Context {d : nat}.
Implicit Types (B S : list (point d)) (T : list (simplex d)) (v : point d) (s t : simplex d).

(** The lattice of [B]: the sums of integer multiples of its vectors. *)
Definition lattice_vector B v : Prop :=
  exists o : list Z, length o = length B /\ v = combination (combine (map IZR o) B).
Definition basis_of_space B : Prop := length B = d /\ forall a : list R, length a = length B ->
  combination (combine a B) = origin -> forall c, In c a -> c = 0.
Definition moved v t : simplex d := map (plus v) t.

(** The lattice of [B] moves the points of [S] and the cells [T] to infinitely many places, and
    there the cells are a Delaunay triangulation of the points: no cell is flat, any two meet in the
    hull of common corners, no two are the same (not even a cell and itself, moved), together they
    are all of R^d, each point is a corner, and no open circumball of a cell has a point in it. *)
Record periodic_delaunay B S T : Prop := {
  lattice_spans : basis_of_space B;
  cells_proper : forall t, In t T -> length t = Datatypes.S d /\ affinely_independent t;
  corners_are_points : forall t c, In t T -> In c t ->
    exists p v, In p S /\ lattice_vector B v /\ c = plus v p;
  cells_meet : forall s t v, In s T -> In t T -> lattice_vector B v ->
    exists f, incl f s /\ incl f (moved v t) /\
      forall q, conv s q -> conv (moved v t) q -> conv f q;
  cells_once : forall i j s t v, nth_error T i = Some s -> nth_error T j = Some t ->
    lattice_vector B v -> same s (moved v t) -> i = j /\ v = origin;
  cells_cover : forall q, exists t v, In t T /\ lattice_vector B v /\ conv (moved v t) q;
  points_are_corners : forall p, In p S ->
    exists t v, In t T /\ lattice_vector B v /\ In (plus v p) t;
  balls_empty : forall t, In t T -> exists c r2, circumball t c r2 /\
    forall p v, In p S -> lattice_vector B v -> ~ dist2 c (plus v p) < r2
}.

(** ** Rules that the cells may break *)

Definition cell_flat T : Prop := exists t, In t T /\ ~ affinely_independent t.
(** Two cells are the same, but for a move; or a cell is listed twice. *)
Definition cell_repeated B T : Prop := exists i j s t v, nth_error T i = Some s /\
  nth_error T j = Some t /\ lattice_vector B v /\ same s (moved v t) /\ i <> j.
(** A facet of a cell is one of no other, and of this one, moved, neither. *)
Definition facet_open B T : Prop := exists i s f, nth_error T i = Some s /\
  length s = Datatypes.S d /\ affinely_independent s /\ NoDup f /\ length f = d /\ incl f s /\
  forall j t v, nth_error T j = Some t -> lattice_vector B v -> incl f (moved v t) ->
    j = i /\ v = origin.
(** A point of the interior of a cell is in another. *)
Definition cells_overlap B T : Prop := exists i j s t v q, nth_error T i = Some s /\
  nth_error T j = Some t /\ lattice_vector B v /\ strictly_inside s q /\ conv (moved v t) q /\
  (i <> j \/ v <> origin).
Definition point_left_out B S T : Prop := exists p, In p S /\
  forall t v, In t T -> lattice_vector B v -> ~ In (plus v p) t.
(** A point is in every open circumball of a cell. *)
Definition ball_not_empty B S T : Prop := exists t p v, In t T /\ In p S /\ lattice_vector B v /\
  forall c r2, circumball t c r2 -> dist2 c (plus v p) < r2.
End Periodic.

(** ** Certificates and refutations, as they stand in a file *)

(** A corner: a point, by its number, and by which multiples of the vectors it is moved. *)
Record corner := Corner { corner_point : positive; corner_offset : list Z }.
(** The vectors; those of the dual basis, times a number D; integers that follow each other: what is
    moved by others is too far away to matter; the points, and the corners of the cells. *)
Record periodic_mesh := PeriodicMesh {
  periodic_numerator : Z; periodic_denominator : Z;            (* scale P Q *)
  basis_rows : list (list Z);
  dual_rows : list (list Z); dual_factor : Z;
  reach : list Z;
  periodic_sites : list site;                                  (* the weight is not read *)
  cells : list (list corner)
}.
(** For each facet of a cell: the cell that has it, too, the number of its vertex opposite, and how
    that cell is moved. *)
Record next_entry := NextEntry { next_cell : positive; next_facet : nat; next_offset : list Z }.
(** For each point, a cell and the number of the vertex that it is; the links of each cell; a sample
    point, and the cell that it is in. *)
Record periodic_certificate := PeriodicCertificate {
  periodic_mesh_of : periodic_mesh;
  homes : list (positive * nat);
  cell_links : list (list next_entry);
  periodic_start : positive; periodic_sample : site; periodic_sample_denominator : Z
}.

Inductive periodic_evidence :=
  | CellFlat (t : positive)
  | CellRepeated (t u : positive) (o : list Z)
  | FacetOpen (t : positive) (i : nat)
  (* the point q / w *)
  | CellsOverlap (t u : positive) (o : list Z) (q : site) (w : Z)
  | PointLeftOut (p : positive)
  | BallNotEmpty (t p : positive) (o : list Z).
Record periodic_refutation := PeriodicRefutation {
  periodic_against : periodic_mesh; periodic_because : periodic_evidence }.
Definition periodic_rule_name (e : periodic_evidence) : string :=
  match e with
  | CellFlat _ => "simplex.degenerate"
  | CellRepeated _ _ _ => "complex.duplicate-simplex"
  | FacetOpen _ _ => "complex.not-closed"
  | CellsOverlap _ _ _ _ _ => "triangulation.covered-twice"
  | PointLeftOut _ => "triangulation.unused-point"
  | BallNotEmpty _ _ _ => "delaunay.vertex-in-ball"
  end%string.

Definition broken_in_periodic {d} (e : periodic_evidence) (B S : list (point d))
    (T : list (simplex d)) : Prop :=
  match e with
  | CellFlat _ => cell_flat T
  | CellRepeated _ _ _ => cell_repeated B T
  | FacetOpen _ _ => facet_open B T
  | CellsOverlap _ _ _ _ _ => cells_overlap B T
  | PointLeftOut _ => point_left_out B S T
  | BallNotEmpty _ _ _ => ball_not_empty B S T
  end.

Section Places.
Variables (d : nat) (m : periodic_mesh).

(** P/Q; the vectors and the points, in the caller's coordinates; and the cells.  (A number that
    names no point would mean the origin; what is accepted has none.) *)
Definition periodic_unit : R := IZR (periodic_numerator m) / IZR (periodic_denominator m).
Definition lattice_of : list (point d) :=
  map (fun b => scale periodic_unit (integer_point d b)) (basis_rows m).
Definition periodic_points : list (point d) := map (place_of periodic_unit) (periodic_sites m).
Definition corner_place (k : corner) : point d :=
  plus (combination (combine (map IZR (corner_offset k)) lattice_of))
    (nth (pred (Pos.to_nat (corner_point k))) periodic_points origin).
Definition periodic_cells : list (simplex d) := map (map corner_place) (cells m).
End Places.
