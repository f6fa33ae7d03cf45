(** * Local convexity is global: the linear-time conditions on the hull suffice

    A mesh in which every facet is matched or a hull facet, with a sample point o that is inside
    one simplex only and strictly on the inner side of every hull facet, and with hull facets that
    are locally convex at their ridges, has supporting hull facets: no vertex of the mesh is
    strictly outside one ([local_convexity_is_global]).  The idea of the proof:

    1. Add to the simplices, for each hull facet, an outer cell: the part of the cone from o over
       the facet that is beyond the facet.  In this mesh of cells every wall is matched, so one can
       walk from anywhere to anywhere.  The sample point is in one cell only; hence no two cells
       overlap ([outer_cells_disjoint], by [cells_disjoint]).
    2. The whole cones are a mesh of cells, too, with a ridge for each wall.  Walk over them from
       the cone of a hull facet to a generic point y: because ridges are convex, y is at least as
       far beyond the facet of the last cone as it is beyond the facet of the first, measured by
       the function that is 0 at o and 1 on the facet ([cones_walk]).
    3. If a vertex of some simplex were strictly outside a hull facet, so would be a generic point
       y of the simplex nearby, and the walk from the cone of that facet to y would end in a cone
       with y beyond its facet: y would be in an outer cell and in a simplex, against 1.

    All conditions are used.  Where the proof stops without them, and what would then be accepted:
    - [matched_opposite]: [cells_opposite], the walk would not leave a simplex through the facet;
    - [matched_once]: [cells_once], two walks may merge;
    - [matched_or_hull]: [cells_open], the walk stops at a facet;
    - [covered_once]: [outer_cells_disjoint], both walks may end, in two simplices.  (The fan that
      winds twice around its centre meets all other conditions, with o near the centre.)
    - [sample_inner]: [outer_cells_disjoint], one of the walks may end in an outer cell; and
      [cones_walk], where a convex ridge may be crossed towards a lower facet.  (The same fan, with
      o where it covers the plane once, strictly outside one of its edges.)
    - [hull_unmatched]: [cells_once], for a simplex and an outer cell beyond the same facet.  (A
      mesh that calls hull also the boundary of a convex part that contains o.)
    - [ridge_matched]: [cones_walk] and [cells_open].  (A star-shaped mesh that leaves the ridges
      at which it is not convex unmatched.)
    - [ridge_opposite]: [mesh_of_cones] and [cells_opposite].  (A hull that is folded back at a
      ridge; if it is folded in the hyperplane of a facet it is even locally convex there.)
    - [ridge_hull]: [ridge_index_of], the walk may leave the list of cells;
    - [ridge_once]: [cells_once], two walks through outer cells may merge;
    - [locally_convex]: [cones_walk].  (A star-shaped mesh that is not convex.) *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Matched Walk Generic Cone.
Import ListNotations.
Open Scope R_scope.

Section Hull.
Context {d : nat} {T : Type}.
Hypothesis T_dec : forall t u : T, {t = u} + {t <> u}.
Variables (tets : list T) (geo : T -> frame d) (adj : T -> nat -> T -> nat -> Prop)
  (hull : T -> nat -> Prop).
Hypothesis hull_dec : forall t i, {hull t i} + {~ hull t i}.
Variables (o : point d) (t0 : T) (cone : T -> nat -> frame d)
  (ridge : T -> nat -> nat -> T -> nat -> nat -> Prop).
Hypothesis M : matched tets geo adj hull.
Hypothesis O : covered_once tets geo o t0.
Hypothesis X : convex_at_ridges tets geo adj hull o cone ridge.
Notation facet := (hull_facet tets geo hull).

Definition hull_facets : list (T * nat) :=
  filter (fun a => if hull_dec (fst a) (snd a) then true else false)
    (list_prod tets (seq 0 (S d))).
Lemma in_hull_facets t i : In (t, i) hull_facets <-> facet t i.
Proof.
  unfold hull_facets, hull_facet. rewrite filter_In, in_prod_iff, in_seq_d. cbn [fst snd].
  destruct (hull_dec t i); intuition congruence.
Qed.

(** What the conditions say of a matched ridge. *)
Lemma ridge_index_of t i k t' i' k' : facet t i -> k <> i -> ridge t i k t' i' k' ->
  facet t' i' /\ (k <= d)%nat /\ (k' <= d)%nat /\ k' <> i'.
Proof.
  intros H N R. pose proof (ridge_hull _ _ _ _ _ _ _ X _ _ _ _ _ _ H N R) as H'.
  pose proof (ridge_opposite _ _ _ _ _ _ _ X _ _ _ _ _ _ H N R) as P.
  split; [assumption|]. split; [apply P|]. split; [apply P|].
  apply (ridge_index (geo t) (geo t') (cone t i) (cone t' i') i i' k k' o); auto;
    try apply (hull_cone _ _ _ _ _ _ _ X); auto; [apply H|apply H'].
Qed.
Lemma ridge_through_of t i k t' i' k' q : facet t i -> k <> i -> ridge t i k t' i' k' ->
  bary (cone t i) k q = 0 ->
  (forall l, (l <= d)%nat -> l <> i -> l <> k -> 0 < bary (cone t i) l q) ->
  bary (cone t' i') i' q = bary (cone t i) i q /\
  forall l, (l <= d)%nat -> l <> i' -> l <> k' -> 0 < bary (cone t' i') l q.
Proof.
  intros H N R. pose proof (ridge_hull _ _ _ _ _ _ _ X _ _ _ _ _ _ H N R) as H'.
  apply (ridge_through (geo t) (geo t')) with (o := o); auto;
    try apply (hull_cone _ _ _ _ _ _ _ X); auto; [apply H|apply H'|].
  now apply (ridge_opposite _ _ _ _ _ _ _ X).
Qed.

(** ** The mesh of cones *)

Definition cone_walls (a : T * nat) : list nat :=
  filter (fun k => if Nat.eq_dec k (snd a) then false else true) (seq 0 (S d)).
Lemma in_cone_walls a k : In k (cone_walls a) <-> (k <= d)%nat /\ k <> snd a.
Proof.
  unfold cone_walls. rewrite filter_In, in_seq_d.
  destruct (Nat.eq_dec k (snd a)); intuition congruence.
Qed.
Definition cone_wall (a : T * nat) : nat -> point d -> R := bary (cone (fst a) (snd a)).
Definition cone_adj (a : T * nat) k (b : T * nat) l : Prop :=
  ridge (fst a) (snd a) k (fst b) (snd b) l.

Lemma mesh_of_cones : matched_cells hull_facets cone_walls cone_wall cone_adj.
Proof.
  constructor.
  - intros a k _ Ik. apply in_cone_walls in Ik. now apply bary_affine.
  - intros a k _ Ik. apply in_cone_walls in Ik.
    exists (vertex (cone (fst a) (snd a)) k). unfold cone_wall. rewrite bary_own by tauto. lra.
  - intros a k l _ Ik Il N. apply in_cone_walls in Ik, Il.
    exists (vertex (cone (fst a) (snd a)) l). unfold cone_wall.
    rewrite bary_own, bary_other by tauto. lra.
  - intros [t i] k [t' i'] l Ia Ik A. apply in_hull_facets in Ia. apply in_cone_walls in Ik.
    cbn [fst snd] in *. destruct (ridge_index_of t i k t' i' l Ia (proj2 Ik) A) as (H' & _ & K).
    split; [now apply in_hull_facets|now apply in_cone_walls].
  - intros [t i] k [t' i'] l Ia Ik A. apply in_hull_facets in Ia. apply in_cone_walls in Ik.
    apply opposite_multiple. now apply (ridge_opposite _ _ _ _ _ _ _ X).
  - intros [t i] k [t' i'] l q Ia Ik A Z P. apply in_hull_facets in Ia. apply in_cone_walls in Ik.
    unfold cone_wall, cone_adj in *. cbn [fst snd] in *.
    destruct (ridge_through_of t i k t' i' l q Ia (proj2 Ik) A Z) as [_ Q].
    { intros m Hm Ni Nk. apply P; [now apply in_cone_walls|assumption]. }
    intros m Im Nm. apply in_cone_walls in Im. now apply Q.
  - intros [t i] k [u j] m [t' i'] l Ia Ib Ik Im A B. apply in_hull_facets in Ia, Ib.
    apply in_cone_walls in Ik, Im. cbn [fst snd] in *.
    destruct (ridge_once _ _ _ _ _ _ _ X t i k u j m t' i' l) as [-> ->]; tauto.
Qed.

Theorem cones_walk t i x y : facet t i ->
  on_no_wall hull_facets cone_walls cone_wall y ->
  generic_pair hull_facets cone_walls cone_wall x y ->
  in_cell cone_walls cone_wall (t, i) x ->
  exists t' i', facet t' i' /\ in_cell cone_walls cone_wall (t', i') y /\
    bary (cone t' i') i' y <= bary (cone t i) i y.
Proof.
  intros H Gy Gxy Hx.
  destruct (cells_walk mesh_of_cones (fun a b => bary (cone (fst b) (snd b)) (snd b) y <=
    bary (cone (fst a) (snd a)) (snd a) y) x y (t, i)) as ([t' i'] & H' & Y & Le); auto.
  - now apply in_hull_facets.
  - intros [u j] k s Ia (Ik & _). apply in_hull_facets in Ia. apply in_cone_walls in Ik.
    destruct (ridge_matched _ _ _ _ _ _ _ X u j k Ia (proj1 Ik) (proj2 Ik)) as (t' & i' & k' & R).
    now exists (t', i'), k'.
  - intros; lra.
  - intros a b c P Q. cbn in *. lra.
  - intros [u j] k [u' j'] l s Ia Ib _ A (Ik & _) P. apply in_hull_facets in Ia, Ib.
    apply in_cone_walls in Ik. unfold cone_wall, cone_adj in *. cbn [fst snd] in *.
    apply (ridge_convex (geo u) (geo u') (cone u j) (cone u' j') j j' k l o);
      try apply (hull_cone _ _ _ _ _ _ _ X); auto; try (apply Ia || apply Ib); try tauto.
    + apply (ridge_opposite _ _ _ _ _ _ _ X); tauto.
    + now apply (sample_inner _ _ _ _ _ _ _ X).
    + apply (locally_convex _ _ _ _ _ _ _ X u j k u' j' l); tauto.
  - exists t', i'. split; [now apply in_hull_facets|]. now split.
Qed.

(** ** The mesh of simplices and outer cells *)

Definition all_cells : list (T + T * nat) := map inl tets ++ map inr hull_facets.
Definition cell_walls (c : T + T * nat) : list nat := seq 0 (S d).
Definition cell_wall (c : T + T * nat) (k : nat) (p : point d) : R :=
  match c with
  | inl t => bary (geo t) k p
  | inr (t, i) => if Nat.eq_dec k i then - bary (geo t) i p else bary (cone t i) k p
  end.
Definition cell_adj (c : T + T * nat) (k : nat) (c' : T + T * nat) (l : nat) : Prop :=
  match c, c' with
  | inl t, inl u => adj t k u l
  | inl t, inr (u, j) => t = u /\ hull t k /\ j = k /\ l = k
  | inr (t, i), inl u => t = u /\ k = i /\ l = i
  | inr (t, i), inr (u, j) => k <> i /\ ridge t i k u j l
  end.

Lemma in_simplices t : In (inl t) all_cells <-> In t tets.
Proof.
  unfold all_cells. rewrite in_app_iff, !in_map_iff. split.
  - intros [(u & [= ->] & H)|(u & [=] & _)]. assumption.
  - intros H. left. eauto.
Qed.
Lemma in_outer t i : In (inr (t, i)) all_cells <-> facet t i.
Proof.
  unfold all_cells. rewrite in_app_iff, !in_map_iff, <- in_hull_facets. split.
  - intros [(u & [=] & _)|(u & [= ->] & H)]. assumption.
  - intros H. right. eauto.
Qed.

Ltac cases c t i Ic := destruct c as [t | [t i]];
  [apply in_simplices in Ic | apply in_outer in Ic]; unfold cell_adj, cell_wall in *.

(** Where the cone meets the facet, its coordinates are those of the simplex. *)
Lemma cone_on_facet t i k q : facet t i -> (k <= d)%nat -> k <> i -> bary (geo t) i q = 0 ->
  bary (cone t i) k q = bary (geo t) k q.
Proof.
  intros H Hk N Z. pose proof (hull_cone _ _ _ _ _ _ _ X t i H) as C.
  pose proof (sample_inner _ _ _ _ _ _ _ X t i H) as P. destruct H as (_ & Hi & _).
  rewrite (cone_bary (geo t) (cone t i) i o Hi C k q Hk N).
  pose proof (cone_height (geo t) (cone t i) i o Hi C q) as E. rewrite Z in E.
  assert (bary (cone t i) i q = 0) as ->; [|ring].
  symmetry in E. apply Rmult_integral in E. destruct E; [assumption|lra].
Qed.

Lemma outer_height t i q : facet t i ->
  bary (geo t) i q = bary (cone t i) i q * bary (geo t) i o.
Proof.
  intros H. apply cone_height; [apply H|]. now apply (hull_cone _ _ _ _ _ _ _ X).
Qed.

Lemma cells_proper c k : In c all_cells -> In k (cell_walls c) -> exists p, cell_wall c k p <> 0.
Proof.
  intros Ic Ik. apply in_seq_d in Ik. cases c t i Ic.
  - exists (vertex (geo t) k). rewrite bary_own by assumption. lra.
  - destruct (Nat.eq_dec k i) as [->|N].
    + exists o. pose proof (sample_inner _ _ _ _ _ _ _ X t i Ic). lra.
    + exists (vertex (cone t i) k). rewrite bary_own by assumption. lra.
Qed.
Lemma cells_transversal c k l : In c all_cells -> In k (cell_walls c) -> In l (cell_walls c) ->
  k <> l -> exists p, cell_wall c k p = 0 /\ cell_wall c l p <> 0.
Proof.
  intros Ic Ik Il N. apply in_seq_d in Ik, Il. cases c t i Ic.
  - exists (vertex (geo t) l). rewrite bary_own, bary_other by auto. lra.
  - exists (vertex (cone t i) l). rewrite (outer_height t i) by assumption.
    pose proof (sample_inner _ _ _ _ _ _ _ X t i Ic) as P. pose proof Ic as (_ & Hi & _).
    destruct (Nat.eq_dec k i) as [->|Nk], (Nat.eq_dec l i) as [->|Nl]; try congruence.
    + rewrite bary_own, bary_other by auto. lra.
    + rewrite bary_own, bary_other by auto. lra.
    + rewrite bary_own, bary_other by auto. lra.
Qed.

Lemma cells_in c k c' l : In c all_cells -> In k (cell_walls c) -> cell_adj c k c' l ->
  In c' all_cells /\ In l (cell_walls c').
Proof.
  intros Ic Ik A. unfold cell_walls in *. rewrite in_seq_d in *.
  cases c t i Ic; destruct c' as [u|[u j]]; rewrite ?in_simplices, ?in_outer.
  - split; [now apply (matched_in _ _ _ _ M t k u l)|].
    apply (matched_opposite _ _ _ _ M t k u l Ic A).
  - destruct A as (<- & H & -> & ->). now repeat split.
  - destruct A as (<- & -> & ->). split; [apply Ic|assumption].
  - destruct A as (N & R). destruct (ridge_index_of t i k u j l Ic N R). tauto.
Qed.
Lemma cells_opposite c k c' l : In c all_cells -> cell_adj c k c' l ->
  exists m, 0 < m /\ forall p, cell_wall c' l p = - m * cell_wall c k p.
Proof.
  intros Ic A. cases c t i Ic; destruct c' as [u|[u j]].
  - apply opposite_multiple. now apply (matched_opposite _ _ _ _ M).
  - destruct A as (<- & H & -> & ->). exists 1. split; [lra|]. intros p.
    destruct (Nat.eq_dec k k); [ring|congruence].
  - destruct A as (<- & -> & ->). exists 1. split; [lra|]. intros p.
    destruct (Nat.eq_dec i i); [ring|congruence].
  - destruct A as (N & R). destruct (ridge_index_of t i k u j l Ic N R) as (_ & _ & _ & N').
    destruct (Nat.eq_dec k i), (Nat.eq_dec l j); try congruence.
    apply opposite_multiple. now apply (ridge_opposite _ _ _ _ _ _ _ X).
Qed.
Lemma cells_through c k c' l q : In c all_cells -> In k (cell_walls c) -> cell_adj c k c' l ->
  cell_wall c k q = 0 -> (forall m, In m (cell_walls c) -> m <> k -> 0 < cell_wall c m q) ->
  forall m, In m (cell_walls c') -> m <> l -> 0 < cell_wall c' m q.
Proof.
  intros Ic Ik A Z P m Im Nm. unfold cell_walls in *. rewrite in_seq_d in Ik, Im.
  assert (P' : forall m, (m <= d)%nat -> m <> k -> 0 < cell_wall c m q)
    by (intros; apply P; [now apply in_seq_d|assumption]). clear P.
  cases c t i Ic; destruct c' as [u|[u j]].
  - apply (opposite_through (geo t) k (geo u) l); auto. now apply (matched_opposite _ _ _ _ M).
  - destruct A as (<- & H & -> & ->). destruct (Nat.eq_dec m k); [congruence|].
    rewrite cone_on_facet; auto. now repeat split.
  - destruct A as (<- & -> & ->). specialize (P' m Im Nm). destruct (Nat.eq_dec i i); [|congruence].
    destruct (Nat.eq_dec m i); [congruence|]. rewrite cone_on_facet in P'; auto. lra.
  - destruct A as (N & R). destruct (Nat.eq_dec k i) as [|_]; [congruence|].
    destruct (ridge_index_of t i k u j l Ic N R) as (Ic' & _).
    destruct (ridge_through_of t i k u j l q Ic N R Z) as [E Q].
    { intros a Ha Ni Nk. specialize (P' a Ha Nk). destruct (Nat.eq_dec a i); congruence. }
    destruct (Nat.eq_dec m j) as [->|Nj]; [|now apply Q].
    pose proof Ic as (_ & Hi & _). specialize (P' i Hi (not_eq_sym N)).
    destruct (Nat.eq_dec i i); [|congruence].
    pose proof (sample_inner _ _ _ _ _ _ _ X t i Ic) as B.
    pose proof (sample_inner _ _ _ _ _ _ _ X u j Ic') as B'.
    rewrite (outer_height t i) in P' by assumption. rewrite (outer_height u j), E by assumption.
    assert (bary (cone t i) i q < 0) by nra. nra.
Qed.
Lemma cells_once c1 k1 c2 k2 c' l : In c1 all_cells -> In c2 all_cells ->
  cell_adj c1 k1 c' l -> cell_adj c2 k2 c' l -> c1 = c2.
Proof.
  intros I1 I2 A B. cases c1 t i I1; cases c2 u j I2; destruct c' as [v|[v n]].
  - f_equal. now apply (matched_once _ _ _ _ M t k1 u k2 v l).
  - destruct A as (-> & _), B as (-> & _). reflexivity.
  - destruct B as (<- & -> & ->). destruct (hull_unmatched _ _ _ _ _ _ _ X u j t k1 I2 I1 A).
  - destruct A as (<- & H & -> & ->), B as (N & R).
    destruct (ridge_index_of u j k2 t k1 k1 I2 N R) as (_ & _ & _ & N'). congruence.
  - destruct A as (<- & -> & ->). destruct (hull_unmatched _ _ _ _ _ _ _ X t i u k2 I1 I2 B).
  - destruct B as (<- & H & -> & ->), A as (N & R).
    destruct (ridge_index_of t i k1 u k2 k2 I1 N R) as (_ & _ & _ & N'). congruence.
  - destruct A as (-> & -> & ->), B as (-> & -> & ->). reflexivity.
  - destruct A as (N & R), B as (N' & R').
    destruct (ridge_once _ _ _ _ _ _ _ X t i k1 u j k2 v n l) as [-> ->]; auto.
Qed.

Lemma mesh_of_cells : matched_cells all_cells cell_walls cell_wall cell_adj.
Proof.
  constructor.
  - intros c k Ic Ik. apply in_seq_d in Ik. cases c t i Ic.
    + now apply bary_affine.
    + destruct (Nat.eq_dec k i) as [->|N]; [apply affine_opp|]; now apply bary_affine.
  - exact cells_proper.
  - exact cells_transversal.
  - exact cells_in.
  - intros c k c' l Ic _. now apply cells_opposite.
  - exact cells_through.
  - intros c1 k1 c2 k2 c' l I1 I2 _ _. now apply cells_once.
Qed.

(** Every wall of every cell is matched. *)
Lemma cells_open c k : In c all_cells -> In k (cell_walls c) -> exists c' l, cell_adj c k c' l.
Proof.
  intros Ic Ik. apply in_seq_d in Ik. cases c t i Ic.
  - destruct (matched_or_hull _ _ _ _ M t k Ic Ik) as [(u & j & A)|H].
    + now exists (inl u), j.
    + now exists (inr (t, k)), k.
  - destruct (Nat.eq_dec k i) as [->|N].
    + now exists (inl t), i.
    + destruct (ridge_matched _ _ _ _ _ _ _ X t i k Ic Ik N) as (u & j & l & R).
      now exists (inr (u, j)), l.
Qed.

(** No two of the simplices and outer cells overlap. *)
Theorem outer_cells_disjoint c1 c2 y : In c1 all_cells -> In c2 all_cells ->
  in_cell cell_walls cell_wall c1 y -> in_cell cell_walls cell_wall c2 y -> c1 = c2.
Proof.
  destruct O as (H0 & I0 & Out).
  apply (cells_disjoint mesh_of_cells) with (o := o) (t0 := inl t0) (K := []).
  - intros a b. repeat decide equality.
  - now apply in_simplices.
  - intros k Ik. apply in_seq_d in Ik. now apply I0.
  - intros c Ic N. cases c t i Ic.
    + destruct (Out t Ic) as (i & Hi & P); [congruence|]. exists i.
      split; [now apply in_seq_d|assumption].
    + exists i. split; [apply in_seq_d, Ic|]. destruct (Nat.eq_dec i i); [|congruence].
      pose proof (sample_inner _ _ _ _ _ _ _ X t i Ic). lra.
  - intros x z c k s _ Ic _ (Ik & _). now apply cells_open.
  - intros g [].
Qed.

(** ** Conclusion *)

(** A simplex and the part of a cone beyond its facet have no generic point in common. *)
Lemma simplex_beyond_none t u i y : In t tets -> facet u i -> inside (geo t) y ->
  in_cell cone_walls cone_wall (u, i) y -> bary (geo u) i y < 0 -> False.
Proof.
  intros Ht Hu Yt Yu B.
  assert (E : inl t = inr (u, i) :> T + T * nat); [|discriminate].
  apply (outer_cells_disjoint _ _ y); [now apply in_simplices|now apply in_outer| |].
  - intros k Ik. apply in_seq_d in Ik. now apply Yt.
  - intros k Ik. apply in_seq_d in Ik. cbn. destruct (Nat.eq_dec k i) as [->|N]; [lra|].
    apply (Yu k). now apply in_cone_walls.
Qed.

Theorem local_convexity_is_global : supporting tets geo hull (vertex_of tets geo).
Proof.
  intros t i Ht Hi Hti p (u & j & Hu & Hj & ->).
  assert (H : facet t i) by now repeat split.
  set (p := vertex (geo u) j).
  destruct (Rle_dec 0 (bary (geo t) i p)) as [|B]; [assumption|exfalso].
  assert (P : 0 < bary (geo t) i o) by now apply (sample_inner _ _ _ _ _ _ _ X).
  (* a generic point x of the cone *)
  destruct (pick_generic mesh_of_cones (cell_functions cone_walls cone_wall (t, i))
    (barycentre (cone t i)) []) as (x & X1 & X2 & _).
  { intros ? []. }
  { apply (cell_functions_in mesh_of_cones); [now apply in_hull_facets|]. intros k Ik.
    apply in_cone_walls in Ik. now apply barycentre_inside. }
  apply cell_functions_out in X1.
  (* a generic point y of the simplex, near p and so beyond the facet *)
  set (beyond := fun q => - bary (geo t) i q).
  assert (Ab : affine beyond) by (apply affine_opp; now apply bary_affine).
  destruct (nearby [beyond] p (barycentre (geo u))) as (e & He & K).
  { intros g [<-|[]]. split; [assumption|]. unfold beyond. lra. }
  destruct (pick_generic mesh_of_cones (beyond :: map (bary (geo u)) (seq 0 (S d)))
    (mix p (barycentre (geo u)) e) [x]) as (y & Y1 & Y2 & Y3).
  { intros ? [<-|[]]. assumption. }
  { intros g [<-|Hg].
    - split; [assumption|]. apply (K e); [lra|now left].
    - apply in_map_iff in Hg. destruct Hg as (k & <- & Hk). apply in_seq_d in Hk.
      pose proof (bary_affine (geo u) k Hk) as A. split; [assumption|].
      rewrite (affine_mix _ _ _ _ A). pose proof (barycentre_inside (geo u) k Hk) as Q.
      assert (0 <= bary (geo u) k p).
      { unfold p. rewrite bary_vertex by assumption. destruct (Nat.eq_dec k j); lra. }
      nra. }
  assert (Yu : inside (geo u) y).
  { intros k Hk. apply Y1. right. apply in_map. now apply in_seq_d. }
  assert (Yt : bary (geo t) i y < 0).
  { pose proof (Y1 beyond (or_introl eq_refl)) as Q. unfold beyond in Q. lra. }
  (* walk from x to y *)
  destruct (cones_walk t i x y H Y2 (Y3 x (or_introl eq_refl)) X1) as (t' & i' & H' & Y' & Le).
  apply (simplex_beyond_none u t' i' y Hu H' Yu Y').
  pose proof (sample_inner _ _ _ _ _ _ _ X t' i' H') as P'.
  rewrite (outer_height t i) in Yt by assumption. rewrite (outer_height t' i') by assumption.
  assert (bary (cone t i) i y < 0) by nra. nra.
Qed.

(** The points of a set are not strictly outside any hull facet either, if each of them is a vertex
    or in some closed simplex, as submerged points are. *)
Corollary hull_supports (P : point d -> Prop) :
  (forall p, P p -> exists t, In t tets /\ inside_closed (geo t) p) -> supporting tets geo hull P.
Proof.
  intros In_some t i Ht Hi H p Pp. destruct (In_some p Pp) as (u & Hu & I).
  apply (inside_pos (geo u) (bary (geo t) i)); [now apply bary_affine|assumption|].
  intros k Hk. apply (local_convexity_is_global t i Ht Hi H). now exists u, k.
Qed.
End Hull.
Arguments local_convexity_is_global {d T} T_dec {tets geo adj hull} hull_dec {o t0 cone ridge}
  _ _ _.
Arguments hull_supports {d T} T_dec {tets geo adj hull} hull_dec {o t0 cone ridge}
  _ _ _ P _.
