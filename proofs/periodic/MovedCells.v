(** * Moved frames and cells, and the cells of a mesh by their numbers

    The frame of a moved simplex is that of the simplex, moved.  Heights above its witness plane do
    not change ([moved_witness]): so what is checked of a cell where it is listed holds of it
    wherever the lattice moves it. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Bool.
From Circumspect Require Import PeriodicChecker Numbering Definitions Vectors Affine Frame Faces.
From Circumspect Require Import Matched LiftingMap.
From Circumspect Require Import Orientation Integers RefutationSigns LatticePoints.
Import ListNotations.
Open Scope R_scope.

(** ** Moved frames *)

Section Moved.
Context {d : nat}.
Implicit Types (g : frame d) (v p : point d).

Lemma moved_back v p : minus (plus v p) v = p.
Proof.
  unfold minus. rewrite (plus_comm v p), <- plus_assoc.
  replace (plus v (scale (-1) v)) with (@origin d); [apply plus_origin|].
  symmetry. apply minus_self.
Qed.
Lemma affine_moved f v : affine f -> affine (fun p => f (minus p v)).
Proof.
  intros (a & b & E). exists a, (b - inner a v). intros p. rewrite E. unfold plane.
  rewrite inner_minus_r. ring.
Qed.
Definition moved_frame g v : frame d.
Proof.
  refine (Frame d (fun i => plus v (vertex g i)) (fun i p => bary g i (minus p v)) _ _ _).
  - intros i Hi. apply (affine_moved (bary g i) v). now apply bary_affine.
  - intros i k Hi Hk. cbn beta. rewrite moved_back. now apply bary_vertex.
  - intros f p A. transitivity ((fun q => f (plus v q)) (minus p v)).
    + cbn beta. now rewrite plus_comm, minus_plus.
    + apply (interpolation g (fun q => f (plus v q)) (minus p v)). destruct A as (a & b & E).
      exists a, (b + inner a v). intros q. rewrite E. unfold plane. rewrite inner_plus_r. ring.
Defined.
Lemma moved_vertices g v : vertices (moved_frame g v) = moved v (vertices g).
Proof. unfold vertices, moved. now rewrite map_map. Qed.
Lemma moved_opposite g i g' j v : opposite g i g' j ->
  opposite (moved_frame g v) i (moved_frame g' v) j.
Proof.
  intros (Hi & Hj & TU & UT & Neg). split; [assumption|]. split; [assumption|].
  split; [|split; [|cbn [vertex bary moved_frame]; now rewrite moved_back]].
  - intros k Hk N. destruct (TU k Hk N) as (l & Hl & Nl & E). exists l.
    cbn [vertex moved_frame]. rewrite E. auto.
  - intros l Hl N. destruct (UT l Hl N) as (k & Hk & Nk & E). exists k.
    cbn [vertex moved_frame]. rewrite E. auto.
Qed.
(** Twice moved is moved by the sum. *)
Lemma moved_twice g i g' j v w : opposite g i (moved_frame (moved_frame g' w) v) j ->
  opposite g i (moved_frame g' (plus v w)) j.
Proof.
  intros (Hi & Hj & TU & UT & Neg). cbn [vertex bary moved_frame] in *.
  repeat split; auto; cbn [vertex bary moved_frame].
  - intros k Hk N. destruct (TU k Hk N) as (l & Hl & Nl & E). exists l.
    rewrite E, plus_assoc. auto.
  - intros l Hl N. destruct (UT l Hl N) as (k & Hk & Nk & E). exists k.
    rewrite <- E, plus_assoc. auto.
  - now rewrite <- plus_assoc.
Qed.
(** A move changes heights above a witness plane by nothing: those of the moved paraboloid differ
    from those of the paraboloid by an affine function. *)
Lemma moved_witness g v p :
  witness norm2 (moved_frame g v) (plus v p) - norm2 (plus v p) = witness norm2 g p - norm2 p.
Proof.
  assert (E : forall y, norm2 (plus v y) = norm2 y + plane (scale 2 v) (norm2 v) y).
  { intros y. unfold norm2, plane. rewrite inner_plus, !inner_plus_r, inner_scale,
      (inner_comm y v). ring. }
  unfold witness. rewrite E.
  rewrite (interpolation g (plane (scale 2 v) (norm2 v)) p (affine_plane _ _)).
  unfold sum. cbn [vertex bary moved_frame].
  rewrite (sum_ext _ _ (fun i => bary g i p * norm2 (vertex g i) +
    bary g i p * plane (scale 2 v) (norm2 v) (vertex g i))).
  - rewrite sum_plus. ring.
  - intros i _. rewrite moved_back, E. ring.
Qed.
Lemma frame_unique g g' i p : vertices g = vertices g' -> (i <= d)%nat -> bary g i p = bary g' i p.
Proof.
  intros E Hi. rewrite (interpolation g' (bary g i) p (bary_affine g i Hi)).
  assert (V : forall k, (k <= d)%nat -> vertex g' k = vertex g k).
  { intros k Hk. assert (N : forall h : frame d, nth k (vertices h) origin = vertex h k).
    { intros h. unfold vertices. rewrite (nth_indep _ origin (vertex h 0)), map_nth, seq_nth;
        [reflexivity|lia|rewrite map_length, seq_length; lia]. }
    rewrite <- (N g), <- (N g'). now rewrite E. }
  unfold sum. rewrite (sum_one _ _ i).
  - rewrite V, bary_own by assumption. ring.
  - apply seq_NoDup.
  - now apply in_seq_d.
  - intros k Ik N. apply in_seq_d in Ik. rewrite V, bary_other by auto. ring.
Qed.
End Moved.

Section Framed.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates} {r : R}.
Hypothesis M : measured orient pr r.
Lemma framed_any X t : Forall (well_shaped d) X -> length X = S d ->
  vertices t = map (place_of r) X -> framed orient pr r X t.
Proof.
  intros F L V.
  assert (N : orientation pr X <> 0%Z).
  { intros Z. apply (measured_spans _ _ _ M t). rewrite V, (orient_places M X F), Z. ring. }
  destruct (proper_framed M X F L) as (t' & Fr).
  { unfold proper. now apply negb_true_iff, Z.eqb_neq. }
  constructor; auto. intros i v Hi. rewrite <- (framed_bary _ _ Fr i v Hi).
  apply frame_unique; [|assumption]. now rewrite V, (framed_vertices _ _ Fr).
Qed.
Lemma off_facet X a i q : framed orient pr r X a -> (i <= d)%nat ->
  (In q (remove i (map (place_of r) X)) <-> exists k, (k <= d)%nat /\ k <> i /\ q = vertex a k).
Proof.
  intros F Hi. rewrite <- (framed_vertices _ _ F).
  assert (E : nth_error (vertices a) i = Some (vertex a i)).
  { unfold vertices. apply map_nth_error. rewrite (nth_error_nth' _ 0%nat)
      by (rewrite seq_length; lia). now rewrite seq_nth by lia. }
  split.
  - intros I. pose proof I as I'. apply remove_incl, in_vertices in I. destruct I as (k & Hk & ->).
    exists k. split; [assumption|]. split; [|reflexivity]. intros ->. revert I'.
    apply remove_absent; [apply vertices_NoDup|assumption].
  - intros (k & Hk & N & ->). apply remove_present with (vertex a i); [assumption| |].
    + apply in_vertices. eauto.
    + intros Ek. apply N. now apply (vertex_inj a).
Qed.
(** The facets that two simplices share, on different sides, as [same_facet] sees them. *)
Lemma facets_opposite X i a Y j b v : framed orient pr r X a -> framed orient pr r Y b ->
  same_facet pr X i Y j = true -> nth_error Y j = Some v -> (coordinate_sign pr X v 1 i < 0)%Z ->
  opposite a i b j.
Proof.
  intros FX FY SF Ev Neg. pose proof (same_facet_shared M X Y a b FX FY i j SF) as
    (_ & _ & _ & _ & Same).
  unfold same_facet in SF. rewrite !andb_true_iff, !Nat.ltb_lt, (dimension_d M) in SF.
  destruct SF as [[Hi Hj] _].
  destruct (framed_vertex Y b FY j v Ev) as [_ Vj].
  split; [lia|]. split; [lia|]. split; [|split].
  - intros k Hk N. assert (I : In (vertex a k) (remove i (map (place_of r) X)))
      by (apply (off_facet X a i); [assumption|lia|eauto]).
    apply Same, (off_facet Y b j) in I; [|assumption|lia]. exact I.
  - intros l Hl N. assert (I : In (vertex b l) (remove j (map (place_of r) Y)))
      by (apply (off_facet Y b j); [assumption|lia|eauto]).
    apply Same, (off_facet X a i) in I; [|assumption|lia]. exact I.
  - rewrite Vj, <- (place_over_one v). apply (coordinate_negative M X a FX); [lia| |lia|].
    + pose proof (framed_shaped Y b FY) as S. rewrite Forall_forall in S. apply S.
      now apply nth_error_In in Ev.
    + now apply Z.ltb_lt.
Qed.
End Framed.

(** ** Cells by their numbers *)

(** The functions of the checker, with the tables that it gives them. *)
Notation corner_site pr m := (PeriodicChecker.corner_site pr m (points_found m)).
Notation corner_sites pr m := (PeriodicChecker.corner_sites pr m (points_found m)).
Notation cell_sites pr m := (PeriodicChecker.cell_sites pr m (points_found m)).
Notation cell_at pr m := (PeriodicChecker.cell_at pr m (points_found m) (cells_found m)).

Lemma periodic_unit_positive pr m : proper_periodic pr m = true -> 0 < periodic_unit m.
Proof.
  intros H. unfold proper_periodic in H. rewrite !andb_true_iff in H. destruct H as [[P Q] _].
  apply Z.ltb_lt, IZR_lt in P, Q. unfold periodic_unit. now apply Rdiv_lt_0_compat.
Qed.
Lemma height_unweighted {d} (r : R) p : weight p = 0%Z ->
  norm2 (@place_of d r p) = @height_of d r p.
Proof. intros E. unfold height_of. rewrite E. ring. Qed.

Section Cells.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Variable m : periodic_mesh.
Notation r := (periodic_unit m).
Hypothesis M : measured orient pr r.
Hypothesis sane : proper_periodic pr m = true.
Hypothesis lattice : proper_lattice pr m = true.
Notation places := (map (@place_of d r)).
Notation shift := (@shift d m).
Notation B := (lattice_of d m).
Notation S := (periodic_points d m).
Notation place_k := (corner_place d m).

Lemma corner_known k p : corner_site pr m k = Some p -> length (corner_offset k) = d /\
  well_shaped d p /\ exists s, numbered (periodic_sites m) (corner_point k) = Some s /\
    p = shifted m (corner_offset k) s /\ place_of r p = place_k k /\
    place_k k = plus (shift (corner_offset k)) (place_of r s).
Proof.
  unfold PeriodicChecker.corner_site, points_found.
  destruct (of_dimension pr (corner_offset k)) eqn:L; [|discriminate].
  unfold of_dimension in L. apply Nat.eqb_eq in L. rewrite (dimension_d M) in L.
  rewrite find_id. destruct (numbered (periodic_sites m) (corner_point k)) as [s|] eqn:E;
    [|discriminate].
  intros H. injection H as <-. split; [assumption|].
  pose proof (sites_shaped m M sane lattice) as F. rewrite Forall_forall in F.
  pose proof (F s (numbered_in _ _ _ E)) as Sh.
  destruct (place_shifted m M sane lattice (corner_offset k) s Sh) as [Sh' P].
  split; [assumption|]. exists s. split; [reflexivity|]. split; [reflexivity|].
  assert (Pk : place_k k = plus (shift (corner_offset k)) (place_of r s)).
  { unfold corner_place, LatticePoints.shift. f_equal. unfold numbered in E.
    apply (map_nth_error (@place_of d r)) in E. now apply nth_error_nth. }
  split; [now rewrite Pk|assumption].
Qed.
Lemma corners_known : forall l X, corner_sites pr m l = Some X ->
  Forall (well_shaped d) X /\ map place_k l = places X /\ length X = length l /\
  forall k, In k l -> exists p, corner_site pr m k = Some p.
Proof.
  induction l as [|k l IH]; intros X E; cbn [PeriodicChecker.corner_sites] in E.
  - injection E as <-. repeat split; [constructor|]. intros k [].
  - destruct (corner_site pr m k) as [p|] eqn:Ek; [|discriminate].
    destruct (corner_sites pr m l) as [Y|]; [|discriminate]. injection E as <-.
    destruct (IH Y eq_refl) as (F & P & L & A).
    destruct (corner_known k p Ek) as (_ & Sh & s & _ & _ & Pk & _).
    split; [now constructor|]. split; [cbn; now rewrite Pk, P|]. split; [cbn; now rewrite L|].
    intros k' [<-|I]; [now exists p|auto].
Qed.
Lemma cell_known l X : cell_sites pr m l = Some X -> Forall (well_shaped d) X /\
  length X = Datatypes.S d /\ map place_k l = places X /\
  forall k, In k l -> exists p, corner_site pr m k = Some p.
Proof.
  unfold PeriodicChecker.cell_sites, right_length. rewrite (dimension_d M).
  destruct (has_length (Datatypes.S d) l) eqn:L; [|discriminate]. apply has_length_length in L.
  intros E. destruct (corners_known l X E) as (F & P & Le & A). repeat split; auto. congruence.
Qed.
Lemma cell_weights l X : cell_sites pr m l = Some X -> forall p, In p X -> weight p = 0%Z.
Proof.
  unfold PeriodicChecker.cell_sites. destruct (right_length pr l); [|discriminate]. revert X.
  induction l as [|x l IH]; intros X EX p Ip; cbn [PeriodicChecker.corner_sites] in EX.
  - injection EX as <-. destruct Ip.
  - destruct (corner_site pr m x) as [q|] eqn:Eq; [|discriminate].
    destruct (corner_sites pr m l) as [Y|]; [|discriminate]. injection EX as <-.
    destruct Ip as [<-|Ip]; [|now apply (IH Y)]. unfold PeriodicChecker.corner_site in Eq.
    destruct (of_dimension pr (corner_offset x)); [|discriminate].
    destruct (Table.find _ _); [|discriminate]. now injection Eq as <-.
Qed.
Lemma cell_at_known t f : cell_at pr m t f = true -> exists l X, numbered (cells m) t = Some l /\
  cell_sites pr m l = Some X /\ f X = true.
Proof.
  unfold PeriodicChecker.cell_at, cells_found. rewrite find_id.
  destruct (numbered (cells m) t) as [l|]; [|discriminate].
  destruct (cell_sites pr m l) as [X|] eqn:E; [|discriminate]. exists l, X. auto.
Qed.
(** A frame of a cell is one of the moved cell, when moved. *)
Lemma moved_framed X g o : Forall (well_shaped d) X -> length X = Datatypes.S d ->
  vertices g = places X ->
  framed orient pr r (map (shifted m o) X) (moved_frame g (shift o)).
Proof.
  intros F L V. destruct (shifted_all m M sane lattice o X F) as [F' E]. apply (framed_any M); auto.
  - now rewrite map_length.
  - now rewrite moved_vertices, V, E.
Qed.
Lemma numbered_place t l : numbered (cells m) t = Some l ->
  nth_error (periodic_cells d m) (pred (Pos.to_nat t)) = Some (map place_k l).
Proof. intros E. unfold periodic_cells, numbered in *. now apply map_nth_error. Qed.
Lemma place_numbered i s : nth_error (periodic_cells d m) i = Some s -> exists t l,
  i = pred (Pos.to_nat t) /\ numbered (cells m) t = Some l /\ s = map place_k l.
Proof.
  intros E. unfold periodic_cells in E. rewrite nth_error_map in E.
  destruct (nth_error (cells m) i) as [l|] eqn:El; [|discriminate]. injection E as <-.
  exists (Pos.of_succ_nat i), l. unfold numbered. rewrite SuccNat2Pos.id_succ. auto.
Qed.
End Cells.
