(** * What an accepted certificate of a mesh that a lattice repeats says

    The cells, moved by all of the lattice, are a mesh without end ([cells_endless]): a cell and its
    offset name each, its frame is that of the cell, moved, and its neighbours are those of the
    cell.  So [Endless.v] gives what the claim says, of infinitely many cells from finitely many. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Bool Eqdep_dec.
From Circumspect Require Import PeriodicChecker Numbering Definitions Vectors Affine Frame Faces.
From Circumspect Require Import Matched LiftingMap DelaunayLemma Mesh Endless.
From Circumspect Require Import Orientation Integers Accepted RefutationSigns LatticePoints
  MovedCells.
From Circumspect Require CertifiedMesh.
Import ListNotations.
Open Scope R_scope.

(** ** Certificates *)

Section Certificate.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Variable c : periodic_certificate.
Notation m := (periodic_mesh_of c).
Notation r := (periodic_unit m).
Hypothesis M : measured orient pr r.
Hypothesis sane : proper_periodic pr m = true.
Hypothesis lattice : proper_lattice pr m = true.
Hypothesis homes_accepted : check_homes (cells_found m) 1 (periodic_sites m) (homes c) = Accepted.
Hypothesis start_inside : inside_start pr m (points_found m) (cells_found m) c = true.
Hypothesis cells_accepted : each (check_periodic_cell pr m (points_found m) (cells_found m) c
    (Table.of_list id (cell_links c))) 1 (cells m) = Accepted.
Notation places := (map (@place_of d r)).
Notation shift := (@shift d m).
Notation B := (lattice_of d m).
Notation place_k := (corner_place d m).
Notation cell t l := (numbered (cells m) t = Some l).

Lemma cell_accepted t l : cell t l -> exists X k, cell_sites pr m l = Some X /\
  proper pr X = true /\ outside pr m c t X = true /\ numbered (cell_links c) t = Some k /\
  length k = S d /\
  forall i x, nth_error k i = Some x -> check_link pr m (points_found m) (cells_found m)
    (Table.of_list id (cell_links c)) t X i x = Accepted.
Proof.
  intros E. apply (each_accepted _ _ cells_accepted) in E. unfold check_periodic_cell in E.
  destruct (cell_sites pr m l) as [X|]; [|discriminate]. exists X.
  destruct (proper pr X); [|discriminate]. destruct (outside pr m c t X); [|discriminate].
  rewrite find_id in E. destruct (numbered (cell_links c) t) as [k|]; [|discriminate]. exists k.
  destruct (right_length pr k) eqn:L; [|discriminate]. unfold right_length in L.
  rewrite (dimension_d M) in L. apply has_length_length in L.
  repeat (split; [assumption || reflexivity|]). intros i x Ex.
  now apply (each_index_accepted _ _ E).
Qed.

(** Cells and where they are moved. *)
Definition is_cell (x : positive * list Z) : bool :=
  match numbered (cells m) (fst x) with Some _ => Nat.eqb (length (snd x)) d | None => false end.
Definition moved_cell := { x : positive * list Z | is_cell x = true }.
Lemma moved_cell_eq (t u : moved_cell) : proj1_sig t = proj1_sig u -> t = u.
Proof.
  destruct t as [x H], u as [y K]. cbn. intros <-. f_equal. apply UIP_dec, bool_dec.
Qed.
Lemma moved_cell_dec (t u : moved_cell) : {t = u} + {t <> u}.
Proof.
  assert (D : {proj1_sig t = proj1_sig u} + {proj1_sig t <> proj1_sig u})
    by repeat decide equality.
  destruct D as [E|N]; [left; now apply moved_cell_eq|right; congruence].
Qed.
Notation number t := (fst (proj1_sig t)).
Notation offset t := (snd (proj1_sig t)).
Lemma moved_cell_is (t : moved_cell) : (exists l, cell (number t) l) /\ length (offset t) = d.
Proof.
  destruct t as [[t o] H]. unfold is_cell in H. cbn in *.
  destruct (numbered (cells m) t); [|discriminate]. apply Nat.eqb_eq in H. eauto.
Qed.
Lemma moved_cell_of t o l : cell t l -> length o = d ->
  exists x : moved_cell, number x = t /\ offset x = o.
Proof.
  intros E L. assert (H : is_cell (t, o) = true)
    by (unfold is_cell; cbn; rewrite E; now apply Nat.eqb_eq).
  now exists (exist _ (t, o) H).
Qed.

Lemma start_cell : exists l X, cell (periodic_start c) l /\ cell_sites pr m l = Some X /\
  well_shaped d (periodic_sample c) /\ (0 < periodic_sample_denominator c)%Z /\
  strictly_in_simplex pr X (periodic_sample c) (periodic_sample_denominator c) = true.
Proof.
  pose proof start_inside as H. unfold inside_start in H. apply andb_prop in H.
  destruct H as [W H]. unfold point_written in W. apply andb_prop in W. destruct W as [W P].
  unfold shaped in W. apply Nat.eqb_eq in W. rewrite (dimension_d M) in W. apply Z.ltb_lt in P.
  apply cell_at_known in H. destruct H as (l & X & E & EX & H). exists l, X. auto.
Qed.
Lemma frames_exist : exists g : positive -> frame d, forall t l X, cell t l ->
  cell_sites pr m l = Some X -> framed orient pr r X (g t).
Proof.
  destruct (CertifiedMesh.finite_choice (numbers (cells m)) (fun t g => forall l X, cell t l ->
    cell_sites pr m l = Some X -> framed orient pr r X g)) as (g & G).
  - intros N. destruct start_cell as (l & X & E & _).
    assert (I : In (periodic_start c) (numbers (cells m))) by (apply in_numbers; eauto).
    now rewrite N in I.
  - intros t I. apply in_numbers in I. destruct I as (l & E).
    destruct (cell_accepted t l E) as (X & k & EX & P & _).
    destruct (cell_known m M sane lattice l X EX) as (F & L & _).
    destruct (proper_framed M X F L P) as (g & G). exists g. intros l' X' E' EX'. congruence.
  - exists g. intros t l X E. apply G; [|assumption]. apply in_numbers. eauto.
Qed.

Section Geometry.
Variable g : positive -> frame d.
Hypothesis frames : forall t l X, cell t l -> cell_sites pr m l = Some X ->
  framed orient pr r X (g t).
Definition geo (t : moved_cell) : frame d := moved_frame (g (number t)) (shift (offset t)).
Definition next (t : moved_cell) (i : nat) (u : moved_cell) (j : nat) : Prop := exists k o,
  (i <= d)%nat /\ numbered (cell_links c) (number t) = Some k /\
  nth_error k i = Some (NextEntry (number u) j o) /\ length o = d /\
  offset u = add_numbers (offset t) o.

Lemma geo_vertices t l : cell (number t) l ->
  vertices (geo t) = moved (shift (offset t)) (map place_k l).
Proof.
  intros E. destruct (cell_accepted _ l E) as (X & k & EX & _).
  destruct (cell_known m M sane lattice l X EX) as (_ & _ & P & _).
  unfold geo. rewrite moved_vertices, (framed_vertices _ _ (frames _ _ _ E EX)), P. reflexivity.
Qed.

(** What a link says of the two cells where they are. *)
Lemma link_accepted t l i k u j o : cell t l -> numbered (cell_links c) t = Some k ->
  nth_error k i = Some (NextEntry u j o) -> length o = d /\ (exists l', cell u l') /\
  (exists k', numbered (cell_links c) u = Some k' /\
     nth_error k' j = Some (NextEntry t i (opposite_numbers o))) /\
  opposite (g t) i (moved_frame (g u) (shift o)) j /\
  witness norm2 (g t) (vertex (moved_frame (g u) (shift o)) j) <=
    norm2 (vertex (moved_frame (g u) (shift o)) j).
Proof.
  intros E Ek Ei. destruct (cell_accepted t l E) as (X & k0 & EX & _ & _ & Ek0 & _ & A).
  assert (k0 = k) by congruence. subst k0. specialize (A i _ Ei). cbn [check_link] in A.
  destruct (of_dimension pr o && _) eqn:A1 in A; [|discriminate].
  destruct (links_back (Table.of_list id (cell_links c)) t i u j o) eqn:A2; [|discriminate].
  destruct (cell_at pr m u _) eqn:A3 in A; [|discriminate]. clear A.
  apply andb_prop in A1. destruct A1 as [Lo A1]. unfold of_dimension in Lo.
  apply Nat.eqb_eq in Lo. rewrite (dimension_d M) in Lo. split; [assumption|].
  apply cell_at_known in A1. destruct A1 as (l' & Y & E' & EY & A1). split; [eauto|].
  destruct (cell_known m M sane lattice l' Y EY) as (FY & LY & _).
  pose proof (frames u l' Y E' EY) as Fr'. pose proof (frames t l X E EX) as Fr.
  pose proof (moved_framed m M sane lattice Y (g u) o FY LY (framed_vertices _ _ Fr')) as FrM.
  split; [|split].
  - unfold links_back in A2. rewrite find_id in A2.
    destruct (numbered (cell_links c) u) as [k'|]; [|discriminate]. exists k'.
    split; [reflexivity|]. destruct (nth_error k' j) as [[t' i' o']|]; [|discriminate].
    rewrite !andb_true_iff in A2. destruct A2 as [[T I] O]. apply Pos.eqb_eq in T.
    apply Nat.eqb_eq in I. apply same_numbers_eq in O. congruence.
  - apply andb_prop in A1. destruct A1 as [SF A1].
    destruct (nth_error (map (shifted m o) Y) j) as [v|] eqn:Ev; [|discriminate].
    apply Z.ltb_lt in A1.
    now apply (facets_opposite M X i (g t) (map (shifted m o) Y) j _ v).
  - apply cell_at_known in A3. destruct A3 as (l2 & Y2 & E2 & EY2 & A3).
    assert (l2 = l') by congruence. subst l2. assert (Y2 = Y) by congruence. subst Y2.
    destruct (nth_error Y j) as [v|] eqn:Ev; [|discriminate]. apply Z.leb_le, IZR_le in A3.
    pose proof (map_nth_error (shifted m o) j Y Ev) as Ev'.
    destruct (framed_vertex _ _ FrM j _ Ev') as [_ ->].
    assert (Wz : forall p, In p (shifted m o v :: X) ->
      norm2 (@place_of d r p) = @height_of d r p).
    { intros p [<-|Ip]; apply height_unweighted; [reflexivity|].
      now apply (cell_weights m l X EX). }
    assert (Sv : well_shaped d (shifted m o v)).
    { pose proof (framed_shaped _ _ FrM) as F. rewrite Forall_forall in F. apply F.
      now apply nth_error_In in Ev'. }
    pose proof (below_sign_witness M X (g t) Fr norm2 (shifted m o v) Wz Sv) as W.
    pose proof (square_positive X (g t) Fr) as Q. pose proof (power_positive M 2) as P2.
    apply Rnot_lt_le. intros N.
    pose proof (Rmult_lt_0_compat _ _ Q (Rlt_Rminus _ _ N)) as G. nra.
Qed.

Lemma next_opposite t i u j : next t i u j -> opposite (geo t) i (geo u) j.
Proof.
  intros (k & o & Hi & Ek & Ei & Lo & Eo).
  destruct (moved_cell_is t) as [(l & E) Lt].
  destruct (link_accepted _ l i k _ j o E Ek Ei) as (_ & _ & _ & O & _).
  unfold geo. rewrite Eo, (shift_sum m M sane lattice) by assumption.
  apply moved_twice. now apply moved_opposite.
Qed.
Lemma next_local t i u j : next t i u j -> locally_above norm2 (geo t) (geo u) j.
Proof.
  intros (k & o & Hi & Ek & Ei & Lo & Eo).
  destruct (moved_cell_is t) as [(l & E) Lt].
  destruct (link_accepted _ l i k _ j o E Ek Ei) as (_ & _ & _ & _ & W).
  unfold locally_above, geo. rewrite Eo, (shift_sum m M sane lattice) by assumption.
  cbn [vertex moved_frame] in *. rewrite <- plus_assoc.
  pose proof (moved_witness (g (number t)) (shift (offset t))
    (plus (shift o) (vertex (g (number u)) j))).
  lra.
Qed.
Lemma next_once t i t' i' u j : next t i u j -> next t' i' u j -> t = t'.
Proof.
  intros (k & o & _ & Ek & Ei & Lo & Eo) (k' & o' & _ & Ek' & Ei' & Lo' & Eo').
  destruct (moved_cell_is t) as [(l & E) Lt]. destruct (moved_cell_is t') as [(l' & E') Lt'].
  destruct (link_accepted _ l i k _ j o E Ek Ei) as (_ & _ & (q & Eq & Ej) & _).
  destruct (link_accepted _ l' i' k' _ j o' E' Ek' Ei') as (_ & _ & (q' & Eq' & Ej') & _).
  assert (q' = q) by congruence. subst q'. rewrite Ej in Ej'. injection Ej' as En Ei2 Eopp.
  assert (o = o').
  { unfold opposite_numbers in Eopp. clear - Eopp. revert o' Eopp.
    induction o as [|z o IH]; intros [|z' o'] H; try discriminate; [reflexivity|].
    injection H as H1 H2. f_equal; [lia|now apply IH]. }
  subst o'. apply moved_cell_eq. apply injective_projections; [assumption|].
  apply (numbers_ext d); [assumption..|]. intros a _.
  pose proof (add_nth d (offset t) o Lt Lo a). pose proof (add_nth d (offset t') o Lt' Lo a).
  rewrite <- Eo in *. rewrite <- Eo' in *. lia.
Qed.
Lemma next_exists t i : (i <= d)%nat -> exists u j, next t i u j.
Proof.
  intros Hi. destruct (moved_cell_is t) as [(l & E) Lt].
  destruct (cell_accepted _ l E) as (X & k & _ & _ & _ & Ek & Lk & _).
  destruct (nth_error k i) as [[u j o]|] eqn:Ei; [|apply nth_error_None in Ei; lia].
  destruct (link_accepted _ l i k u j o E Ek Ei) as (Lo & (l' & E') & _).
  destruct (moved_cell_of u (add_numbers (offset t) o) l' E') as (x & Ex & Ox);
    [now apply add_length|].
  exists x, j, k, o. rewrite Ex, Ox. auto.
Qed.

(** ** Finitely many cells are near *)

Definition as_cells (l : list (positive * list Z)) : list moved_cell :=
  flat_map (fun x => match bool_dec (is_cell x) true with
    left H => [exist _ x H] | right _ => [] end) l.
Lemma in_as_cells (t : moved_cell) l : In (proj1_sig t) l -> In t (as_cells l).
Proof.
  intros I. unfold as_cells. apply in_flat_map. exists (proj1_sig t). split; [assumption|].
  destruct (bool_dec (is_cell (proj1_sig t)) true) as [H|N]; [|destruct t; contradiction].
  left. now apply moved_cell_eq.
Qed.
Lemma near_finite (X : list (point d)) : exists (K : list (point d -> R)) (tets : list moved_cell),
  (forall f, In f K -> affine f /\ forall x, In x X -> 0 < f x) /\
  forall t p, (forall f, In f K -> 0 < f p) -> inside_closed (geo t) p -> In t tets.
Proof.
  destruct (near_moved m M sane lattice (map (fun k => vertices (g k)) (numbers (cells m))) X)
    as (K & L & HK & Near).
  exists K, (as_cells (list_prod (numbers (cells m)) L)). split; [assumption|].
  intros t p Hp Q. apply in_as_cells. destruct (moved_cell_is t) as [(l & El) Lo].
  assert (I : In (number t) (numbers (cells m))) by (apply in_numbers; eauto).
  rewrite (surjective_pairing (proj1_sig t)). apply in_prod; [assumption|].
  apply (Near (vertices (g (number t))) _ p); auto.
  - now apply (in_map (fun k => vertices (g k))).
  - rewrite <- moved_vertices. now apply conv_vertices.
Qed.

Theorem cells_endless : endless geo next.
Proof.
  constructor.
  - intros t i. apply next_exists.
  - intros t i u j. apply next_opposite.
  - intros t i t' i' u j. apply next_once.
  - exact near_finite.
Qed.

(** ** The sample point *)

Definition sample_place : point d :=
  place_of (r / IZR (periodic_sample_denominator c)) (periodic_sample c).
Lemma zero_shift : shift (repeat 0%Z d) = origin.
Proof. apply (shift_zero m M sane lattice), zeros_all. Qed.
Lemma minus_origin (p : point d) : minus p origin = p.
Proof. unfold minus. rewrite scale_origin. apply plus_origin. Qed.

Lemma sampled : exists t0, inside (geo t0) sample_place /\
  forall t, t <> t0 -> exists i, (i <= d)%nat /\ bary (geo t) i sample_place < 0.
Proof.
  destruct start_cell as (l & X & E & EX & Sq & W & In_X).
  destruct (moved_cell_of (periodic_start c) (repeat 0%Z d) l E (repeat_length _ _))
    as (t0 & N0 & O0).
  exists t0. split.
  - intros i Hi. unfold geo. rewrite O0, zero_shift, N0. cbn [bary moved_frame].
    rewrite minus_origin. pose proof (frames _ l X E EX) as Fr.
    unfold strictly_in_simplex in In_X. rewrite forallb_forall in In_X.
    apply (coordinate_positive M X _ Fr); [assumption..|]. apply In_X.
    unfold corners_numbered. rewrite (dimension_d M). now apply in_seq_d.
  - intros t N. destruct (out_of_all geo [t] sample_place) as [(t' & [<-|[]] & C)|Out].
    + exfalso. destruct (moved_cell_is t) as [(k & Ek) Lo].
      destruct (cell_accepted _ k Ek) as (Y & q & EY & _ & O & _).
      destruct (cell_known m M sane lattice k Y EY) as (FY & LY & _).
      pose proof (frames _ k Y Ek EY) as Fr.
      pose proof (moved_framed m M sane lattice Y (g (number t)) (offset t) FY LY
        (framed_vertices _ _ Fr)) as FrM.
      unfold outside in O. cbv zeta in O.
      apply (everywhere_sound m M sane lattice Y _ _ FY Sq W) with (o := offset t) in O;
        [|assumption|].
      * apply orb_prop in O. destruct O as [O|O].
        -- apply andb_prop in O. destruct O as [T Z]. apply Pos.eqb_eq in T. apply N.
           apply moved_cell_eq. apply injective_projections; [congruence|]. rewrite O0.
           apply (numbers_ext d); [assumption|apply repeat_length|]. intros a _.
           rewrite (zero_nth _ Z), (zero_nth _ (zeros_all d)). reflexivity.
        -- apply existsb_exists in O. destruct O as (i & Ii & O).
           unfold corners_numbered in Ii. rewrite (dimension_d M) in Ii. apply in_seq_d in Ii.
           apply (coordinate_negative M _ _ FrM) in O; [|assumption..].
           specialize (C i Ii). unfold geo in C. unfold place_over in O. unfold sample_place in C.
           lra.
      * rewrite <- (framed_vertices _ _ Fr), <- moved_vertices.
        apply conv_vertices. exact C.
    + destruct (Out t (or_introl eq_refl)) as (i & Ii & Neg). apply in_seq_d in Ii. eauto.
Qed.

(** ** What the claim says *)

Lemma same_moved_cell t u : same (vertices (geo t)) (vertices (geo u)) -> t = u.
Proof.
  intros Sm. destruct sampled as (t0 & In0 & Out).
  apply (endless_disjoint geo next cells_endless moved_cell_dec sample_place t0 In0 Out t u
    (barycentre (geo t))); [apply barycentre_inside|].
  assert (C : inside_closed (geo u) (barycentre (geo t))).
  { apply conv_vertices. apply (conv_same (vertices (geo t))); [assumption|].
    now apply conv_vertices, inside_weaken, barycentre_inside. }
  intros k Hk. assert (I : In (vertex (geo u) k) (vertices (geo t)))
    by (apply Sm, in_vertices; eauto).
  apply in_vertices in I. destruct I as (i & Hi & Ei).
  destruct (endless_agree geo next cells_endless moved_cell_dec sample_place t0 In0 Out t u
    (barycentre (geo t))) with (i := i) as (k' & Hk' & E' & P); auto.
  - apply inside_weaken, barycentre_inside.
  - apply barycentre_inside. assumption.
  - replace k with k'; [assumption|]. apply (vertex_inj (geo u)); auto. congruence.
Qed.
Lemma home_found k p : numbered (periodic_sites m) k = Some p -> exists t l x,
  cell t l /\ In x l /\ corner_point x = k.
Proof.
  clear - homes_accepted. intros E.
  assert (G : forall P l k0, check_homes (cells_found m) k0 P l = Accepted ->
    forall n p, nth_error P n = Some p -> exists t r x, cell t r /\ In x r /\
      Pos.to_nat (corner_point x) = (Pos.to_nat k0 + n)%nat).
  { induction P as [|s P IH]; intros l k0 A n q En; [destruct n; discriminate|].
    destruct l as [|[t i] l]; [discriminate|]. cbn [check_homes] in A.
    destruct (Table.find t (cells_found m)) as [r|] eqn:Er; [|discriminate].
    destruct (nth_error r i) as [x|] eqn:Ex; [|discriminate].
    destruct (Pos.eqb (corner_point x) k0) eqn:Ek; [|discriminate]. apply Pos.eqb_eq in Ek.
    unfold cells_found in Er. rewrite find_id in Er. destruct n as [|n].
    - exists t, r, x. repeat split; [assumption|now apply nth_error_In in Ex|]. subst. lia.
    - destruct (IH l (Pos.succ k0) A n q En) as (t' & r' & x' & ? & ? & Q). exists t', r', x'.
      repeat split; auto. rewrite Q. rewrite Pos2Nat.inj_succ. lia. }
  destruct (G _ _ _ homes_accepted _ _ E) as (t & r & x & Ct & Ix & Q). exists t, r, x.
  repeat split; auto. apply Pos2Nat.inj. rewrite Q. pose proof (Pos2Nat.is_pos k). cbn. lia.
Qed.
Lemma home_corner p : In p (periodic_points d m) -> exists t l x, cell t l /\ In x l /\
  length (corner_offset x) = d /\ place_k x = plus (shift (corner_offset x)) p.
Proof.
  intros I. apply in_map_iff in I. destruct I as (s & <- & I). apply in_numbered in I.
  destruct I as (k & Ek). destruct (home_found k s Ek) as (t & l & x & E & Ix & Ex).
  destruct (cell_accepted t l E) as (X & q & EX & _).
  destruct (cell_known m M sane lattice l X EX) as (_ & _ & _ & A).
  destruct (A x Ix) as (y & Ey).
  destruct (corner_known m M sane lattice x y Ey) as (Lx & _ & s' & Es & _ & _ & Px).
  rewrite Ex in Es. assert (s' = s) by congruence. subst s'. exists t, l, x. auto.
Qed.
(** Every point, moved, is a vertex of a moved cell. *)
Lemma point_is_vertex p v : In p (periodic_points d m) -> lattice_vector B v ->
  exists t i, (i <= d)%nat /\ plus v p = vertex (geo t) i.
Proof.
  intros I L. destruct (home_corner p I) as (t & l & x & E & Ix & Lx & Px).
  apply (vector_shift m M sane lattice) in L. destruct L as (o & Lo & ->).
  set (back := opposite_numbers (corner_offset x)).
  assert (Lb : length back = d) by (unfold back, opposite_numbers; now rewrite map_length).
  destruct (moved_cell_of t (add_numbers o back) l E) as (u & Nu & Ou); [now apply add_length|].
  assert (In (plus (shift o) p) (vertices (geo u))).
  { rewrite (geo_vertices u l) by (rewrite Nu; assumption). unfold moved. apply in_map_iff.
    exists (corner_place d m x). split; [|now apply in_map]. rewrite Ou, Px.
    rewrite (shift_sum m M sane lattice), plus_assoc, <- (plus_assoc (shift o)) by assumption.
    rewrite <- (shift_sum m M sane lattice), (shift_zero m M sane lattice (add_numbers back _)),
      plus_origin; [reflexivity|apply opposite_zero|assumption|assumption]. }
  apply in_vertices in H. destruct H as (i & Hi & H). eauto.
Qed.

Theorem certificate_holds :
  periodic_delaunay B (periodic_points d m) (periodic_cells d m).
Proof.
  destruct sampled as (t0 & In0 & Out).
  assert (Listed : forall s, In s (periodic_cells d m) -> exists t l, cell t l /\
    s = map place_k l /\ vertices (g t) = s).
  { intros s I. unfold periodic_cells in I. apply in_map_iff in I. destruct I as (l & <- & I).
    apply in_numbered in I. destruct I as (t & E). exists t, l. split; [assumption|].
    split; [reflexivity|]. destruct (cell_accepted t l E) as (X & q & EX & _).
    destruct (cell_known m M sane lattice l X EX) as (_ & _ & P & _).
    now rewrite P, (framed_vertices _ _ (frames t l X E EX)). }
  assert (Of : forall t o l, cell t l -> length o = d -> exists u, number u = t /\ offset u = o /\
    vertices (geo u) = moved (shift o) (map place_k l)).
  { intros t o l E L. destruct (moved_cell_of t o l E L) as (u & Nu & Ou). exists u.
    split; [assumption|]. split; [assumption|]. rewrite (geo_vertices u l), Ou by now rewrite Nu.
    reflexivity. }
  assert (Still : forall s : simplex d, moved (shift (repeat 0%Z d)) s = s).
  { intros s. rewrite zero_shift. unfold moved. rewrite <- (map_id s) at 2. apply map_ext.
    apply origin_plus. }
  pose proof (vector_shift m M sane lattice) as Vs. constructor.
  - exact (basis_independent m M sane lattice).
  - intros s I. destruct (Listed s I) as (t & l & _ & _ & <-).
    split; [apply vertices_length|apply vertices_independent].
  - intros s x I Ix. destruct (Listed s I) as (t & l & E & -> & _). apply in_map_iff in Ix.
    destruct Ix as (k & <- & Ik). destruct (cell_accepted t l E) as (X & q & EX & _).
    destruct (cell_known m M sane lattice l X EX) as (_ & _ & _ & A). destruct (A k Ik) as (y & Ey).
    destruct (corner_known m M sane lattice k y Ey) as (Lx & _ & s' & Es & _ & _ & Px).
    exists (place_of r s'), (shift (corner_offset k)). split; [|split; [|assumption]].
    + apply in_map. now apply numbered_in in Es.
    + now apply (shift_vector m M sane lattice).
  - intros s t v Is It L. destruct (Vs v L) as (o & Lo & ->).
    destruct (Listed s Is) as (k & l & E & -> & _).
    destruct (Listed t It) as (k' & l' & E' & -> & _).
    destruct (Of k (repeat 0%Z d) l E (repeat_length _ _)) as (a & _ & _ & Va).
    destruct (Of k' o l' E' Lo) as (b & _ & _ & Vb). rewrite Still in Va. rewrite <- Va, <- Vb.
    apply (faces_meet (geo a) (geo b)); [|apply incl_refl|apply incl_refl].
    apply (endless_agree geo next cells_endless moved_cell_dec sample_place t0 In0 Out).
  - intros i j s t v Es Et L Sm. destruct (Vs v L) as (o & Lo & ->).
    apply (place_numbered m) in Es, Et. destruct Es as (k & l & -> & E & ->).
    destruct Et as (k' & l' & -> & E' & ->).
    destruct (Of k (repeat 0%Z d) l E (repeat_length _ _)) as (a & Na & Oa & Va).
    destruct (Of k' o l' E' Lo) as (b & Nb & Ob & Vb). rewrite Still in Va.
    assert (a = b) by (apply same_moved_cell; now rewrite Va, Vb). subst b.
    split; [congruence|]. rewrite <- Ob, Oa. apply zero_shift.
  - intros q. destruct (endless_cover geo next cells_endless sample_place t0 In0 q) as (t & C).
    destruct (moved_cell_is t) as [(l & E) Lo]. exists (map place_k l), (shift (offset t)).
    split; [unfold periodic_cells; apply in_map; now apply numbered_in in E|].
    split; [now apply (shift_vector m M sane lattice)|].
    rewrite <- (geo_vertices t l E). now apply conv_vertices.
  - intros p I. destruct (home_corner p I) as (t & l & x & E & Ix & Lx & Px).
    exists (map place_k l), (shift (corner_offset x)).
    split; [unfold periodic_cells; apply in_map; now apply numbered_in in E|].
    split; [now apply (shift_vector m M sane lattice)|]. rewrite <- Px. now apply in_map.
  - intros s Is. destruct (Listed s Is) as (k & l & E & -> & _).
    destruct (Of k (repeat 0%Z d) l E (repeat_length _ _)) as (a & _ & _ & Va). rewrite Still in Va.
    rewrite <- Va. destruct (circumball_frame (geo a)) as (x & r2 & Ci & Pl). exists x, r2.
    split; [assumption|]. intros p v Ip Lv Lt. apply (in_ball_below_witness _ _ _ _ Ci) in Lt.
    destruct (point_is_vertex p v Ip Lv) as (u & i & Hi & Ep).
    assert (witness norm2 (geo a) (plus v p) <= norm2 (plus v p)); [|lra].
    rewrite Ep. rewrite <- (witness_vertex norm2 (geo u) i Hi).
    apply (endless_below geo next cells_endless moved_cell_dec sample_place t0 In0 Out norm2 a u).
    + intros t i0 u0 j. apply next_local.
    + intros j Hj. rewrite bary_vertex by assumption. destruct (Nat.eq_dec j i); lra.
Qed.
End Geometry.

Theorem periodic_holds : periodic_delaunay B (periodic_points d m) (periodic_cells d m).
Proof. destruct frames_exist as (g & G). now apply (certificate_holds g). Qed.
End Certificate.

Theorem check_periodic_sound D c : check_periodic D c = Accepted ->
  let d := dimension_of D in let m := periodic_mesh_of c in
  periodic_delaunay (lattice_of d m) (periodic_points d m) (periodic_cells d m).
Proof.
  intros A. cbv zeta. unfold check_periodic in A. cbv zeta in A.
  destruct (proper_periodic _ _) eqn:A1; [|discriminate].
  destruct (proper_lattice _ _) eqn:A2; [|discriminate].
  destruct (check_homes _ _ _ _) eqn:A3; [|discriminate].
  destruct (inside_start _ _ _ _ _) eqn:A4; [|discriminate].
  assert (U : 0 < periodic_unit (periodic_mesh_of c)) by now apply periodic_unit_positive in A1.
  destruct D.
  - exact (periodic_holds c (measured_plane _ U) A1 A2 A3 A4 A).
  - exact (periodic_holds c (measured_space _ U) A1 A2 A3 A4 A).
Qed.
