(** * Gift-wrapping returns the canonical triangulation

    Each simplex that is found is one of the canonical triangulation T, since beyond a facet of a
    simplex of T the scan is left with the apex of the neighbour ([scan_finds]).  When none is left
    whose facets were not crossed, all of T is found ([all_reached]).  The number of steps suffices,
    because different lists of d+1 points are found. *)
From Coq Require Import Rbase Rfunctions Lra Psatz Lia List Arith ZArith Bool.
From Circumspect Require Import GiftWrapping Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Facets Matched LiftingMap.
From Circumspect Require Import Orientation Integers RefutationSigns Perturbation EveryPointSet
  Exchange.
Import ListNotations.
Open Scope R_scope.

Section Signs.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates} {r : R}.
Hypothesis M : measured orient pr r.
Let unit_positive := measured_unit orient pr r M.
Variable P : list spotted.
Notation place p := (@place_of d r (snd p)).
Notation places X := (map (fun p : spotted => @place_of d r (snd p)) X).
Notation S := (places P).
Notation framed X t := (RefutationSigns.framed orient pr r (map snd X) t).
Hypothesis shaped_points : Forall (fun p : spotted => well_shaped d (snd p)) P.
Hypothesis numbers_differ : NoDup (map fst P).
Hypothesis places_differ : NoDup S.
Variable h : point d -> R.
Hypothesis heights : forall p, In p P -> h (place p) = @height_of d r (snd p).
Implicit Types (p v : spotted) (X Y : list spotted) (t u y : frame d).

Lemma spotted_number p v : In p P -> In v P -> fst p = fst v -> p = v.
Proof.
  intros Ip Iv E. destruct (In_nth P p p Ip) as (i & Hi & Ei), (In_nth P v p Iv) as (j & Hj & Ej).
  assert (i = j); [|congruence]. apply (proj1 (NoDup_nth (map fst P) (fst p)) numbers_differ);
    try (now rewrite map_length).
  rewrite (map_nth fst P p i), (map_nth fst P p j).
  change (fst (@nth spotted i P p) = fst (@nth spotted j P p)).
  now rewrite Ei, Ej.
Qed.
Lemma spotted_place p v : In p P -> In v P -> place p = place v -> p = v.
Proof.
  intros Ip Iv E. destruct (In_nth P p p Ip) as (i & Hi & Ei), (In_nth P v p Iv) as (j & Hj & Ej).
  assert (i = j); [|congruence]. apply (proj1 (NoDup_nth S (place p)) places_differ);
    try (now rewrite map_length).
  rewrite (map_nth (fun p : spotted => place p) P p i),
    (map_nth (fun p : spotted => place p) P p j), Ei, Ej. assumption.
Qed.
Lemma shaped_of p : In p P -> well_shaped d (snd p).
Proof. intros I. rewrite Forall_forall in shaped_points. auto. Qed.
Lemma shaped_list X : incl X P -> Forall (well_shaped d) (map snd X).
Proof.
  intros I. apply Forall_forall. intros s H. apply in_map_iff in H. destruct H as (p & <- & H).
  apply shaped_of. auto.
Qed.

Lemma framed_places X t : framed X t -> vertices t = places X.
Proof. intros F. rewrite (framed_vertices _ _ F). apply map_map. Qed.
Lemma framed_at X t i p : framed X t -> nth_error X i = Some p -> (i <= d)%nat /\
  vertex t i = place p.
Proof. intros F E. apply (framed_vertex (map snd X) t F i). now apply map_nth_error. Qed.
Lemma framed_nth X t i : framed X t -> (i <= d)%nat -> exists p, nth_error X i = Some p /\
  vertex t i = place p.
Proof.
  intros F Hi. pose proof (framed_length _ _ F) as L. rewrite map_length in L.
  destruct (nth_error X i) as [p|] eqn:E; [|apply nth_error_None in E; lia].
  exists p. split; [reflexivity|]. now apply (framed_at X t i).
Qed.
Lemma in_vertices_spotted X t p : framed X t -> incl X P -> In p P ->
  (In (place p) (vertices t) <-> In p X).
Proof.
  intros F I Ip. rewrite (framed_places X t F), in_map_iff. split.
  - intros (v & E & Iv). now rewrite <- (spotted_place v p (I v Iv) Ip E).
  - intros H. now exists p.
Qed.

Lemma place_in_spec X : forall k i, place_in k X = Some i -> exists v, nth_error X i = Some v /\
  fst v = k.
Proof.
  induction X as [|v X IH]; intros k i E; cbn in E; [discriminate|].
  destruct (Pos.eqb_spec k (fst v)) as [->|N].
  - injection E as <-. now exists v.
  - destruct (place_in k X) as [j|] eqn:F; [|discriminate]. injection E as <-. exact (IH k j F).
Qed.
Lemma place_in_none X : forall k, place_in k X = None -> forall v, In v X -> fst v <> k.
Proof.
  induction X as [|v X IH]; intros k E w I; [destruct I|]. cbn in E.
  destruct (Pos.eqb_spec k (fst v)) as [|N]; [discriminate|].
  destruct (place_in k X) eqn:F; [discriminate|]. destruct I as [<-|I]; [congruence|].
  now apply (IH k F).
Qed.
Lemma is_vertex_spec X p : incl X P -> In p P -> (is_vertex X p = true <-> In p X).
Proof.
  intros I Ip. unfold is_vertex. destruct (place_in (fst p) X) as [i|] eqn:E; split;
    try discriminate; auto.
  - intros _. destruct (place_in_spec X _ _ E) as (v & N & F). apply nth_error_In in N.
    now rewrite (spotted_number p v Ip (I v N)) by congruence.
  - intros Ix. destruct (place_in_none X _ E p Ix). reflexivity.
Qed.

(** ** The sign of the height *)

Section Height.
Variables (X : list spotted) (t : frame d).
Hypothesis F : framed X t.
Hypothesis known : incl X P.
Notation o2 := (IZR (orientation pr (map snd X)) * IZR (orientation pr (map snd X))).

Lemma o2_positive : 0 < o2.
Proof. exact (square_positive (map snd X) t F). Qed.
Lemma sign_bary p i : In p P -> (i <= d)%nat ->
  IZR (coordinate_sign pr (map snd X) (snd p) 1 i) = o2 * bary t i (place p).
Proof.
  intros Ip Hi.
  rewrite (coordinate_sign_bary M (map snd X) t F (snd p) 1 i Hi (shaped_of p Ip) ltac:(lia)).
  rewrite place_over_one. ring.
Qed.
Lemma is_beyond_spec p i : In p P -> (i <= d)%nat ->
  (is_beyond pr X i p = true <-> bary t i (place p) < 0).
Proof.
  intros Ip Hi. unfold is_beyond. rewrite Z.ltb_lt. pose proof (sign_bary p i Ip Hi) as E.
  pose proof o2_positive.
  split; intros L.
  - apply IZR_lt in L. rewrite E in L. nra.
  - apply lt_IZR. rewrite E. nra.
Qed.

Lemma first_nonzero_lead {A} (f : A -> Z) (g : A -> R) q l : 0 < q ->
  (forall a, In a l -> IZR (f a) = q * g a) ->
  IZR (first_nonzero f l) = q * lead (map g l).
Proof.
  intros Q H. induction l as [|a l IH]; cbn [first_nonzero map lead]; [ring|].
  pose proof (H a (or_introl eq_refl)) as E. specialize (IH (fun b I => H b (or_intror I))).
  destruct (Z.eqb_spec (f a) 0) as [Z0|Z0], (Req_EM_T (g a) 0) as [G|G]; auto.
  - rewrite Z0 in E. symmetry in E. apply Rmult_integral in E. destruct E; [lra|contradiction].
  - exfalso. apply Z0. apply eq_IZR. rewrite E, G. ring.
Qed.

Lemma coefficient_spec p v : In p P -> ~ In p X -> In v P ->
  IZR (coefficient pr X p v) = o2 * - above (at_point (place v)) t (place p).
Proof.
  intros Ip Np Iv. unfold coefficient.
  assert (A : above (at_point (place v)) t (place p) = at_point (place v) (place p) -
    sum_over (seq 0 (Datatypes.S d)) (fun l => bary t l (place p) * at_point (place v)
      (vertex t l))) by reflexivity.
  destruct (Pos.eqb_spec (fst v) (fst p)) as [E|N].
  - rewrite (spotted_number v p Iv Ip E) in *. rewrite opp_IZR, mult_IZR, A.
    rewrite (sum_zero _ (fun l => bary t l (place p) * at_point (place p) (vertex t l))).
    + unfold at_point. destruct (point_eq_dec (place p) (place p)); [ring|contradiction].
    + intros l Hl. apply in_seq_d in Hl. unfold at_point.
      destruct (point_eq_dec (vertex t l) (place p)) as [V|]; [|ring].
      exfalso. apply Np. apply (in_vertices_spotted X t p F known Ip). rewrite <- V.
      apply in_vertices. eauto.
  - assert (D : at_point (place v) (place p) = 0).
    { unfold at_point. destruct (point_eq_dec (place p) (place v)) as [V|]; [|reflexivity].
      exfalso. apply N. now rewrite (spotted_place p v Ip Iv V). }
    destruct (place_in (fst v) X) as [i|] eqn:E.
    + destruct (place_in_spec X _ _ E) as (w & Nw & Fw). pose proof (nth_error_In _ _ Nw) as Iw.
      rewrite (spotted_number w v (known w Iw) Iv Fw) in Nw.
      destruct (framed_at X t i v F Nw) as [Hi V].
      rewrite sign_bary, A, D by assumption. rewrite (sum_one _ _ i).
      * rewrite V. unfold at_point.
        destruct (point_eq_dec (place v) (place v)); [ring|contradiction].
      * apply seq_NoDup.
      * now apply in_seq_d.
      * intros l Hl Nl. apply in_seq_d in Hl. unfold at_point.
        destruct (point_eq_dec (vertex t l) (place v)) as [W|]; [|ring].
        exfalso. apply Nl. rewrite <- V in W. now apply (vertex_inj t).
    + rewrite A, D, (sum_zero _ (fun l => bary t l (place p) * at_point (place v) (vertex t l)));
        [ring|].
      intros l Hl. apply in_seq_d in Hl. unfold at_point.
      destruct (point_eq_dec (vertex t l) (place v)) as [V|]; [|ring].
      exfalso. destruct (framed_nth X t l F Hl) as (w & Nw & Vw). apply nth_error_In in Nw.
      apply (place_in_none X _ E w Nw). rewrite Vw in V.
      now rewrite (spotted_place w v (known w Nw) Iv V).
Qed.

Theorem height_sign_spec p : In p P -> ~ In p X -> exists q, 0 < q /\
  IZR (height_sign pr P X p) = q * lead (coefficients S h t (place p)).
Proof.
  intros Ip Np. pose proof o2_positive as O.
  assert (H : heights_of r h (snd p :: map snd X)).
  { intros s [<-|I]; [now apply heights|]. apply in_map_iff in I. destruct I as (v & <- & I).
    apply heights. auto. }
  pose proof (below_sign_witness M (map snd X) t F h (snd p) H (shaped_of p Ip)) as W.
  assert (R2 : 0 < r ^ 2) by (apply pow_lt; exact unit_positive).
  assert (E : r ^ 2 * IZR (- below_sign pr (map snd X) (snd p)) = o2 * above h t (place p)).
  { rewrite opp_IZR. change (above h t (place p)) with (h (place p) - witness h t (place p)). nra. }
  unfold height_sign, coefficients. cbn [lead].
  destruct (Z.eqb_spec (below_sign pr (map snd X) (snd p)) 0) as [Z0|Z0].
  - rewrite Z0 in E. cbn in E. destruct (Req_EM_T (above h t (place p)) 0) as [A|A].
    + exists o2. split; [assumption|]. rewrite map_map.
      apply (first_nonzero_lead _ (fun v : spotted => - above (at_point (place v)) t (place p)));
        [assumption|].
      intros v Iv. now apply coefficient_spec.
    + exfalso. apply A. assert (o2 * above h t (place p) = 0) by lra. apply Rmult_integral in H0.
      destruct H0; [lra|assumption].
  - destruct (Req_EM_T (above h t (place p)) 0) as [A|A].
    + exfalso. apply Z0. apply eq_IZR. rewrite A, opp_IZR in E. nra.
    + exists (o2 / r ^ 2). split; [now apply Rdiv_lt_0_compat|].
      apply Rmult_eq_reg_l with (r ^ 2); [|lra]. rewrite E. field. lra.
Qed.
End Height.

(** ** Replacing a vertex *)

Lemma replaced_known X i b : incl X P -> In b P -> incl (replace i b X) P.
Proof.
  intros I Ib p H. apply In_nth_error in H. destruct H as (k & E).
  destruct (Nat.eq_dec k i) as [->|N].
  - destruct (Nat.lt_ge_cases i (length X)) as [L|L].
    + rewrite replace_same in E by assumption. injection E as <-. assumption.
    + exfalso. assert (K : (i < length (replace i b X))%nat) by (apply nth_error_Some; congruence).
      rewrite replace_length in K. lia.
  - rewrite replace_other in E by assumption. apply I. now apply nth_error_In in E.
Qed.
Lemma replaced_framed X t i b : framed X t -> incl X P -> In b P -> (i <= d)%nat ->
  bary t i (place b) <> 0 ->
  exists y, framed (replace i b X) y /\ vertex y i = place b /\ (forall k, (k <= d)%nat -> k <> i ->
    vertex y k = vertex t k).
Proof.
  intros F I Ib Hi N. pose proof (framed_length _ _ F) as L. rewrite map_length in L.
  pose proof (shaped_list _ (replaced_known X i b I Ib)) as Sh.
  assert (Pr : proper pr (map snd (replace i b X)) = true).
  { unfold proper. apply negb_true_iff, Z.eqb_neq. intros Z0.
    rewrite (framed_bary _ _ F i (place b) Hi) in N. apply N. unfold Rdiv.
    replace (orient (replace i (place b) (map (place_of r) (map snd X)))) with 0; [ring|].
    rewrite <- replace_map, <- replace_map, (orient_places M _ Sh), Z0. ring. }
  destruct (proper_framed M (map snd (replace i b X)) Sh) as (y & Fy);
    [now rewrite map_length, replace_length|assumption|].
  exists y. split; [assumption|]. split.
  - apply (framed_at (replace i b X) y i b Fy). apply replace_same. lia.
  - intros k Hk Nk. destruct (framed_nth X t k F Hk) as (p & E & ->).
    apply (framed_at (replace i b X) y k p Fy). now rewrite replace_other.
Qed.

(** ** The scan finds the apex of the neighbour *)

Section Scan.
Variables (X : list spotted) (t : frame d) (i : nat) (u : frame d) (j : nat) (V : spotted).
Hypothesis F : framed X t.
Hypothesis known : incl X P.
Hypothesis neighbour : opposite t i u j.
Hypothesis passes_u : canonical S h u.
Hypothesis apex_V : In V P /\ place V = vertex u j.

Lemma beyond_apex : bary t i (place V) < 0.
Proof. destruct neighbour as (_ & _ & _ & _ & N). destruct apex_V as [_ ->]. exact N. Qed.
Lemma not_in_facet p : In p P -> bary t i (place p) < 0 -> p <> V -> ~ In (place p) (vertices u).
Proof.
  intros Ip Neg N H. destruct neighbour as (Hi & Hj & TU & UT & _). apply in_vertices in H.
  destruct H as (l & Hl & E).
  destruct (Nat.eq_dec l j) as [->|Nl].
  - apply N. apply spotted_place; [assumption|apply apex_V|]. destruct apex_V as [_ ->]. assumption.
  - destruct (UT l Hl Nl) as (k & Hk & Nk & Ek). rewrite E, Ek, bary_other in Neg by auto. lra.
Qed.
(** The simplices that are compared. *)
Lemma compared b : In b P -> bary t i (place b) < 0 -> exists y, framed (replace i b X) y /\
  but_one y i u /\
  vertex y i = place b /\ (forall p, In p P -> bary t i (place p) < 0 -> p <> b ->
    ~ In p (replace i b X)) /\
  0 < bary y i (place V).
Proof.
  intros Ib Neg. destruct neighbour as (Hi & Hj & TU & UT & _).
  destruct (replaced_framed X t i b F known Ib Hi ltac:(lra)) as (y & Fy & Vy & Oy). exists y.
  split; [assumption|].
  split; [split; [assumption|]|split; [assumption|split]].
  - intros m Hm Nm. destruct (TU m Hm Nm) as (l & Hl & _ & E). exists l. split; [assumption|].
    now rewrite Oy.
  - intros p Ip Np N H. apply (in_vertices_spotted _ y p Fy (replaced_known X i b known Ib) Ip) in
      H.
    apply in_vertices in H. destruct H as (k & Hk & E). destruct (Nat.eq_dec k i) as [->|Nk].
    + apply N. apply spotted_place; [assumption..|]. congruence.
    + rewrite E, Oy, bary_other in Np by auto. lra.
  - (* bary t i = bary t i (place b) * bary y i *)
    assert (E : bary t i (place V) = bary y i (place V) * bary t i (place b)).
    { rewrite (interpolation y (bary t i) (place V) (bary_affine t i Hi)). unfold sum.
      rewrite (sum_one _ _ i).
      - now rewrite Vy.
      - apply seq_NoDup.
      - now apply in_seq_d.
      - intros k Hk Nk. apply in_seq_d in Hk. rewrite Oy, bary_other by auto. ring. }
    pose proof beyond_apex. nra.
Qed.
Lemma apex_below b : In b P -> bary t i (place b) < 0 -> b <> V ->
  (height_sign pr P (replace i b X) V < 0)%Z.
Proof.
  intros Ib Neg N. destruct (compared b Ib Neg) as (y & Fy & B & Vy & Out & Pos).
  destruct apex_V as [IV EV].
  destruct (height_sign_spec (replace i b X) y Fy (replaced_known X i b known Ib) V IV)
    as (q & Q & E).
  { apply Out; [assumption|apply beyond_apex|congruence]. }
  apply lt_IZR. rewrite E, EV. rewrite EV in Pos.
  assert (L : lead (coefficients S h y (vertex u j)) < 0); [|nra].
  destruct neighbour as (_ & Hj & _).
  apply (apex_is_lower S h y i u j); auto.
  - rewrite Vy. now apply (in_map (fun p => place p)).
  - rewrite Vy. now apply not_in_facet.
Qed.
Lemma others_above p : In p P -> bary t i (place p) < 0 -> p <> V ->
  (0 < height_sign pr P (replace i V X) p)%Z.
Proof.
  intros Ip Neg N. destruct apex_V as [IV EV].
  destruct (compared V IV beyond_apex) as (y & Fy & B & Vy & Out & _).
  destruct (height_sign_spec (replace i V X) y Fy (replaced_known X i V known IV) p Ip)
    as (q & Q & E); [now apply Out|].
  apply lt_IZR. rewrite E. assert (Sm : same (vertices y) (vertices u)).
  { assert (I : incl (vertices y) (vertices u)).
    { intros v H. apply in_vertices in H. destruct H as (k & Hk & ->). apply in_vertices.
      destruct neighbour as (_ & Hj & _).
      destruct (Nat.eq_dec k i) as [->|Nk]; [exists j; split; [assumption|congruence]|].
      destruct B as [_ B].
      destruct (B k Hk Nk) as (l & Hl & El). eauto. }
    split; [assumption|].
    apply NoDup_length_incl; [apply vertices_NoDup|rewrite !vertices_length; lia|assumption]. }
  rewrite (coefficients_same S h y u (place p) Sm).
  specialize (passes_u (place p) (in_map (fun p => place p) _ _ Ip) (not_in_facet p Ip Neg N)). nra.
Qed.

Lemma scan_keeps l : forall best, incl l P -> (best = Some V \/ In V l) ->
  (forall b, best = Some b -> In b P /\ bary t i (place b) < 0) ->
    fold_left (lower pr P X i) l best = Some V.
Proof.
  assert (Dec : forall p q : spotted, In p P -> In q P -> p = q \/ p <> q).
  { intros p q Ip Iq. destruct (Pos.eq_dec (fst p) (fst q)) as [E|N];
      [left; now apply spotted_number|right; congruence]. }
  destruct neighbour as (Hi & _). destruct apex_V as [IV _].
  induction l as [|p l IH]; intros best I HV Hb; [destruct HV as [->|[]]; reflexivity|].
  cbn [fold_left].
  assert (Ip : In p P) by (apply I; now left).
  assert (Il : incl l P) by (intros x Hx; apply I; now right).
  unfold lower at 2. destruct (is_beyond pr X i p) eqn:By.
  - apply (is_beyond_spec X t F p i Ip Hi) in By.
    destruct best as [b|].
    + destruct (Hb b eq_refl) as [Ib Nb].
      destruct (Z.ltb_spec (height_sign pr P (replace i b X) p) 0) as [L|L].
      * apply IH; [assumption| |now intros b' E; injection E as <-].
        destruct HV as [E|[->|E]]; [injection E as ->|now left|now right].
        destruct (Dec p V Ip IV) as [->|N]; [now left|]. pose proof (others_above p Ip By N). lia.
      * apply IH; [assumption| |exact Hb]. destruct HV as [E|[->|E]]; [now left| |now right].
        destruct (Dec b V Ib IV) as [->|N]; [now left|]. pose proof (apex_below b Ib Nb N). lia.
    + apply IH; [assumption| |now intros b' E; injection E as <-].
      destruct HV as [E|[->|E]]; [discriminate|now left|now right].
  - apply IH; [assumption| |exact Hb]. destruct HV as [E|[->|E]]; [now left| |now right]. exfalso.
    pose proof beyond_apex as N. apply (is_beyond_spec X t F V i IV Hi) in N. congruence.
Qed.
Theorem scan_finds : apex_beyond pr P X i = Some V.
Proof.
  unfold apex_beyond. apply scan_keeps; [apply incl_refl|right; apply apex_V|discriminate].
Qed.
(** With it the simplex becomes the neighbour. *)
Theorem across_is_neighbour : exists y, framed (replace i V X) y /\ incl (replace i V X) P /\
  same (vertices y) (vertices u).
Proof.
  destruct apex_V as [IV EV]. destruct (compared V IV beyond_apex) as (y & Fy & B & Vy & _ & _).
  exists y.
  split; [assumption|]. split; [now apply replaced_known|].
  assert (I : incl (vertices y) (vertices u)).
  { intros v H. apply in_vertices in H. destruct H as (k & Hk & ->). apply in_vertices.
    destruct neighbour as (_ & Hj & _).
    destruct (Nat.eq_dec k i) as [->|Nk]; [exists j; split; [assumption|congruence]|].
    destruct B as [_ B].
    destruct (B k Hk Nk) as (l & Hl & El). eauto. }
  split; [assumption|].
  apply NoDup_length_incl; [apply vertices_NoDup|rewrite !vertices_length; lia|assumption].
Qed.
End Scan.
End Signs.
