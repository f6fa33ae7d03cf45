(** * What an accepted refutation of a mesh that a lattice repeats says

    The rule is broken ([evidence_shows]), and so the claim is false ([broken_refutes]).  That an
    open facet refutes it needs a proof: beyond the facet there would be points as near as one likes
    to a point inside it, all of them in the finitely many cells that are near; so one of these has
    the point, and with it the facet ([open_refutes]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Bool.
From Circumspect Require Import PeriodicChecker Numbering Definitions Vectors Affine Frame Faces.
From Circumspect Require Import Independence LiftingMap Endless.
From Circumspect Require Import Orientation Integers RefutationSigns LatticePoints MovedCells.
From Circumspect Require ConstrainedLemma.
Import ListNotations.
Open Scope R_scope.

Section Open.
Context {d : nat}.

(** Near [q], towards [y], cells that miss [q] are missed. *)
Lemma miss_near (C : list (simplex d)) q y :
  (forall t, In t C -> length t = Datatypes.S d /\ affinely_independent t) ->
  exists e0, 0 < e0 < 1 /\ forall e, 0 <= e <= e0 -> forall t, In t C -> conv t (mix q y e) ->
    conv t q.
Proof.
  induction C as [|t C IH]; intros H; [exists (1 / 2); split; [lra|intros e _ t []]|].
  destruct IH as (e1 & P1 & H1); [intros; apply H; now right|].
  destruct (H t (or_introl eq_refl)) as [L I]. destruct (frame_of t L I) as (f & V).
  destruct (out_of_all (fun _ : unit => f) [tt] q) as [(u & _ & In_q)|Out].
  - exists e1. split; [assumption|]. intros e He s [<-|Is] Cs; [|now apply (H1 e He)].
    rewrite <- V. now apply conv_vertices.
  - destruct (Out tt (or_introl eq_refl)) as (k & Ik & Neg). apply in_seq_d in Ik.
    destruct (nearby [fun p => - bary f k p] q y) as (e2 & P2 & H2).
    { intros g [<-|[]]. split; [now apply affine_opp, bary_affine|lra]. }
    exists (Rmin e1 e2). pose proof (Rmin_l e1 e2). pose proof (Rmin_r e1 e2).
    split; [split; [apply Rmin_glb_lt|]; lra|]. intros e He s [<-|Is] Cs.
    + exfalso. rewrite <- V in Cs. apply conv_vertices in Cs. specialize (Cs k Ik).
      specialize (H2 e ltac:(lra) _ (or_introl eq_refl)). cbn beta in H2. lra.
    + apply (H1 e ltac:(lra)); assumption.
Qed.

(** A point inside the facet opposite vertex i, and one beyond it. *)
Lemma facet_point (a : frame d) i : (0 < d)%nat -> (i <= d)%nat -> exists q y, bary a i q = 0 /\
  bary a i y < 0 /\ forall k, (k <= d)%nat -> k <> i -> 0 < bary a k q.
Proof.
  intros D Hi. set (b := barycentre a). set (n := INR (Datatypes.S d)).
  assert (N : 1 < n) by (unfold n; rewrite S_INR; pose proof (lt_0_INR d D); lra).
  assert (V : forall k s, (k <= d)%nat -> bary a k (mix (vertex a i) b s) =
    (1 - s) * (if Nat.eq_dec k i then 1 else 0) + s * / n).
  { intros k s Hk. rewrite (affine_mix _ _ _ _ (bary_affine a k Hk)), bary_vertex by assumption.
    unfold b. now rewrite bary_barycentre. }
  set (s := n / (n - 1)).
  exists (mix (vertex a i) b s), (mix (vertex a i) b (s + 1)). rewrite !V by assumption.
  destruct (Nat.eq_dec i i) as [_|]; [|congruence]. split; [unfold s; field; lra|]. split.
  - replace ((1 - (s + 1)) * 1 + (s + 1) * / n) with (/ n - 1) by (unfold s; field; lra).
    pose proof (Rinv_lt_contravar 1 n ltac:(lra) N). rewrite Rinv_1 in *. lra.
  - intros k Hk Nk. rewrite V by assumption. destruct (Nat.eq_dec k i); [contradiction|].
    assert (0 < s) by (unfold s; apply Rdiv_lt_0_compat; lra).
    assert (0 < / n) by (apply Rinv_0_lt_compat; lra). nra.
Qed.
End Open.

Section Refuted.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Variable m : periodic_mesh.
Notation r := (periodic_unit m).
Hypothesis M : measured orient pr r.
Hypothesis sane : proper_periodic pr m = true.
Hypothesis lattice : proper_lattice pr m = true.
Hypothesis some_d : (0 < d)%nat.
Notation places := (map (@place_of d r)).
Notation shift := (@shift d m).
Notation B := (lattice_of d m).
Notation S := (periodic_points d m).
Notation T := (periodic_cells d m).

Theorem open_refutes : facet_open B T -> ~ periodic_delaunay B S T.
Proof.
  intros (i0 & s & f & Es & Ls & As & Nf & Lf & If & Only) H.
  destruct (frame_of s Ls As) as (a & Va).
  assert (E : exists i, (i <= d)%nat /\ forall k, (k <= d)%nat -> In (vertex a k) f -> k <> i).
  { destruct (Exists_dec (fun i => ~ In (vertex a i) f) (seq 0 (Datatypes.S d))) as [E|N].
    - intros i. destruct (in_points (vertex a i) f); [right; tauto|now left].
    - apply Exists_exists in E. destruct E as (i & Ii & Ni). apply in_seq_d in Ii. exists i.
      split; [assumption|]. intros k _ I ->. contradiction.
    - exfalso. assert (I : incl s f).
      { rewrite <- Va. intros v Iv. apply in_vertices in Iv. destruct Iv as (i & Hi & ->).
        destruct (in_points (vertex a i) f) as [|Ni]; [assumption|exfalso]. apply N.
        apply Exists_exists. exists i. split; [now apply in_seq_d|assumption]. }
      assert (Ns : NoDup s) by (rewrite <- Va; apply vertices_NoDup).
      pose proof (NoDup_incl_length Ns I). lia. }
  destruct E as (i & Hi & Off). destruct (facet_point a i some_d Hi) as (q & y & Zq & Ny & Pq).
  destruct (near_moved m M sane lattice T [q]) as (K & L & HK & Near).
  destruct (nearby K q y) as (e1 & P1 & H1).
  { intros g I. split; [now apply HK|]. apply (HK g I). now left. }
  destruct (miss_near (flat_map (fun t => map (fun o => moved (shift o) t) L) T) q y)
    as (e2 & P2 & H2).
  { intros t I. apply in_flat_map in I. destruct I as (t' & It & I). apply in_map_iff in I.
    destruct I as (o & <- & _). destruct (cells_proper _ _ _ H t' It) as [Lt At].
    destruct (frame_of t' Lt At) as (b & Vb). rewrite <- Vb, <- moved_vertices.
    split; [apply vertices_length|apply vertices_independent]. }
  set (e := Rmin e1 e2). pose proof (Rmin_l e1 e2). pose proof (Rmin_r e1 e2).
  assert (Pe : 0 < e) by (apply Rmin_glb_lt; lra). fold e in H0, H3.
  destruct (cells_cover _ _ _ H (mix q y e)) as (t & v & It & Lv & C).
  destruct (vector_shift m M sane lattice v Lv) as (o & Lo & ->).
  assert (Io : In o L) by (apply (Near t o (mix q y e)); auto; apply H1; lra).
  assert (Cq : conv (moved (shift o) t) q).
  { apply (H2 e); [lra| |assumption]. apply in_flat_map. exists t. split; [assumption|].
    now apply (in_map (fun o => moved (shift o) t)). }
  destruct (cells_meet _ _ _ H s t (shift o) (nth_error_In _ _ Es) It Lv) as (f' & Is & It' & Cf).
  assert (Qa : inside_closed a q).
  { intros k Hk. destruct (Nat.eq_dec k i) as [->|N]; [lra|]. left. now apply Pq. }
  assert (Cs : conv s q) by (rewrite <- Va; now apply conv_vertices).
  specialize (Cf q Cs Cq). rewrite <- Va in Is. apply (conv_face a f' q Is) in Cf.
  destruct Cf as [_ Cf]. destruct (In_nth_error _ _ It) as (j & Ej).
  destruct (Only j t (shift o) Ej Lv) as [-> Zo].
  { intros v Iv. apply It'. assert (Iv' := If v Iv). rewrite <- Va in Iv'. apply in_vertices in Iv'.
    destruct Iv' as (k & Hk & ->). apply Cf; [assumption|]. apply Pq; [assumption|].
    now apply (Off k Hk). }
  assert (t = s) by congruence. subst t. rewrite Zo in C.
  assert (E : moved origin s = s).
  { unfold moved. rewrite <- (map_id s) at 2. apply map_ext. apply origin_plus. }
  rewrite E, <- Va in C. apply conv_vertices in C. specialize (C i Hi).
  rewrite (affine_mix _ _ _ _ (bary_affine a i Hi)), Zq in C. nra.
Qed.

Theorem broken_refutes e : broken_in_periodic e B S T -> ~ periodic_delaunay B S T.
Proof.
  destruct e; cbn [broken_in_periodic].
  - intros (s & I & N) H. now apply N, (cells_proper _ _ _ H s).
  - intros (i & j & s & u' & v & Ei & Ej & Lv & Sm & N) H.
    destruct (cells_once _ _ _ H i j s u' v Ei Ej Lv Sm). contradiction.
  - exact open_refutes.
  - intros (i & j & s & u' & v & q' & Ei & Ej & Lv & [Cs Strict] & C & N) H.
    destruct (cells_meet _ _ _ H s u' v (nth_error_In _ _ Ei) (nth_error_In _ _ Ej) Lv)
      as (f & Is & It & Cf).
    assert (I : incl s (moved v u')).
    { apply (incl_tran (m := f)); [|assumption]. apply Strict; [assumption|now apply Cf]. }
    destruct (cells_proper _ _ _ H s (nth_error_In _ _ Ei)) as [Ls As].
    destruct (cells_proper _ _ _ H u' (nth_error_In _ _ Ej)) as [Lu _].
    assert (Sm : same s (moved v u')).
    { split; [assumption|]. apply NoDup_length_incl; [now apply independent_NoDup| |assumption].
      unfold moved. rewrite map_length. lia. }
    destruct (cells_once _ _ _ H i j s u' v Ei Ej Lv Sm). tauto.
  - intros (x & Ix & N) H. destruct (points_are_corners _ _ _ H x Ix) as (s & v & Is & Lv & I).
    now apply (N s v).
  - intros (s & x & v & Is & Ix & Lv & A) H.
    destruct (balls_empty _ _ _ H s Is) as (c & r2 & Ci & N). apply (N x v Ix Lv). now apply A.
Qed.

Notation cell t l := (numbered (cells m) t = Some l).
Notation shown e := (shown_in_periodic pr m (points_found m) (cells_found m) e).
Lemma cell_framed t f : cell_at pr m t f = true -> exists X, Forall (well_shaped d) X /\
  length X = Datatypes.S d /\ nth_error T (pred (Pos.to_nat t)) = Some (places X) /\
  (forall p, In p X -> weight p = 0%Z) /\ f X = true.
Proof.
  intros A. apply cell_at_known in A. destruct A as (l & X & E & EX & A).
  destruct (cell_known m M sane lattice l X EX) as (F & L & P & _). exists X.
  repeat split; auto.
  - rewrite (numbered_place m t l E). now rewrite P.
  - now apply (cell_weights m l X EX).
Qed.
Lemma of_dimension_length o : of_dimension pr o = true -> length o = d.
Proof. unfold of_dimension. rewrite (dimension_d M). apply Nat.eqb_eq. Qed.
Lemma numbers_differ t u : Pos.eqb t u = false -> pred (Pos.to_nat t) <> pred (Pos.to_nat u).
Proof.
  intros N E. apply Pos.eqb_neq in N. apply N, Pos2Nat.inj. pose proof (Pos2Nat.is_pos t).
  pose proof (Pos2Nat.is_pos u). lia.
Qed.
Lemma numbers_back t i : pred (Pos.to_nat t) = i -> t = Pos.of_succ_nat i.
Proof.
  intros <-. apply Pos2Nat.inj. rewrite SuccNat2Pos.id_succ. pose proof (Pos2Nat.is_pos t). lia.
Qed.
Lemma all_zero_of_shift o : length o = d -> shift o = origin -> all_zero o = true.
Proof.
  intros L E. rewrite <- (shift_zero m M sane lattice (repeat 0%Z d) (zeros_all d)) in E.
  apply (shift_inj m M sane lattice) in E; [|assumption|apply repeat_length]. subst o.
  apply zeros_all.
Qed.
Lemma every_nth {A} (f : positive -> A -> bool) : forall l k, every f k l = true ->
  forall i a, nth_error l i = Some a -> exists t, Pos.to_nat t = (Pos.to_nat k + i)%nat /\
    f t a = true.
Proof.
  induction l as [|x l IH]; intros k E i a Ei; [destruct i; discriminate|].
  cbn [every] in E. apply andb_prop in E. destruct E as [F E]. destruct i as [|i].
  - injection Ei as ->. exists k. split; [lia|assumption].
  - destruct (IH _ E i a Ei) as (t & Et & Ft). exists t. split; [|assumption].
    rewrite Et, Pos2Nat.inj_succ. lia.
Qed.

Lemma find_in_points p : Table.find p (points_found m) = numbered (periodic_sites m) p.
Proof. apply find_id. Qed.

Lemma open_shown t i : shown (FacetOpen t i) = true -> facet_open B T.
Proof.
  intros A. apply cell_framed in A. destruct A as (X & F & L & E & WX & A).
  rewrite !andb_true_iff, (dimension_d M), Nat.ltb_lt in A. destruct A as [[P Hi] A].
  destruct (proper_framed M X F L P) as (a & Fr).
  destruct (remove i X) as [|v f] eqn:Ef; [discriminate|].
  set (g := places (remove i X)).
  assert (Ig : incl g (places X)) by (unfold g; rewrite remove_map; apply remove_incl).
  exists (pred (Pos.to_nat t)), (places X), g. split; [assumption|].
  split; [now rewrite map_length|].
  split; [rewrite <- (framed_vertices _ _ Fr); apply vertices_independent|].
  split; [unfold g; rewrite remove_map; apply remove_NoDup, (framed_NoDup X a Fr)|].
  split.
  { unfold g. rewrite map_length. pose proof (remove_length i X). rewrite L in *. lia. }
  split; [assumption|]. intros j s w Ej Lw Is.
  destruct (vector_shift m M sane lattice w Lw) as (o & Lo & ->).
  apply (place_numbered m) in Ej. destruct Ej as (u & l & -> & Eu & ->).
  destruct (every_nth _ _ _ A (pred (Pos.to_nat u)) l Eu) as (u' & Nu & Au).
  assert (u' = u) by (apply Pos2Nat.inj; rewrite Nu; pose proof (Pos2Nat.is_pos u); cbn; lia).
  subst u'. destruct (cell_sites pr m l) as [Y|] eqn:EY; [|discriminate].
  destruct (cell_known m M sane lattice l Y EY) as (FY & _ & PY & _). rewrite PY in Is.
  assert (FR : Forall (well_shaped d) (remove i X)).
  { eapply incl_Forall; [apply remove_incl|exact F]. }
  assert (Sv : well_shaped d v) by (rewrite Ef in FR; now inversion FR).
  apply (everywhere_sound m M sane lattice Y v 1 FY Sv ltac:(lia)) with (o := o) in Au;
    [|assumption|].
  - destruct (shifted_all m M sane lattice o Y FY) as [FY' EY']. apply orb_prop in Au.
    destruct Au as [Au|Au].
    + apply andb_prop in Au. destruct Au as [Eq Z]. apply Pos.eqb_eq in Eq. subst u.
      split; [reflexivity|]. now apply (shift_zero m M sane lattice).
    + exfalso. apply negb_true_iff in Au.
      enough (all_among (remove i X) (map (shifted m o) Y) = true)
        by (rewrite <- Ef in Au; congruence).
      apply (all_among_incl M); auto. now rewrite EY'.
  - change (conv (moved (shift o) (places Y)) (@place_over d r v 1)). rewrite place_over_one.
    apply conv_point, Is. unfold g. rewrite Ef. now left.
Qed.

Lemma left_out_shown p : shown (PointLeftOut p) = true -> point_left_out B S T.
Proof.
  intros A. cbn [shown_in_periodic] in A. rewrite find_in_points in A.
  destruct (numbered (periodic_sites m) p) as [s|] eqn:Es; [|discriminate].
  assert (Is : In s (periodic_sites m)) by now apply numbered_in in Es.
  assert (Ss : well_shaped d s).
  { pose proof (sites_shaped m M sane lattice) as F. rewrite Forall_forall in F. now apply F. }
  exists (place_of r s). split; [now apply in_map|]. intros t w It Lw I.
  destruct (vector_shift m M sane lattice w Lw) as (o & Lo & ->).
  unfold periodic_cells in It. apply in_map_iff in It. destruct It as (l & <- & Il).
  rewrite forallb_forall in A. specialize (A l Il).
  destruct (corner_sites pr m l) as [Y|] eqn:EY; [|discriminate].
  destruct (corners_known m M sane lattice l Y EY) as (FY & PY & _). rewrite PY in I.
  apply in_map_iff in I. destruct I as (v & Ev & Iv). rewrite forallb_forall in A.
  specialize (A v Iv). assert (Sv : well_shaped d v) by (rewrite Forall_forall in FY; now apply FY).
  destruct (place_shifted m M sane lattice o s Ss) as [S' P'].
  apply (everywhere_sound m M sane lattice [s] v 1 ltac:(now constructor) Sv ltac:(lia))
    with (o := o) in A; [|assumption|].
  - apply negb_true_iff in A. enough (same_place (shifted m o s) v = true) by congruence.
    apply (same_place_place M); auto. now rewrite P'.
  - change (conv (moved (shift o) [place_of r s]) (@place_over d r v 1)).
    rewrite place_over_one, Ev. apply conv_point. now left.
Qed.

Theorem evidence_shows e : shown e = true -> broken_in_periodic e B S T.
Proof.
  destruct e; cbn [broken_in_periodic].
  - intros A. apply cell_framed in A. destruct A as (X & F & L & E & WX & A). exists (places X).
    split; [now apply nth_error_In in E|]. apply (flat_dependent M); auto.
    now apply negb_true_iff.
  - intros A. cbn [shown_in_periodic] in A. rewrite !andb_true_iff in A. destruct A as [[Lo N] A].
    apply of_dimension_length in Lo. apply negb_true_iff, numbers_differ in N.
    apply cell_framed in A. destruct A as (X & F & L & E & WX & A).
    apply cell_framed in A. destruct A as (Y & FY & LY & EY & _ & A).
    destruct (shifted_all m M sane lattice o Y FY) as [FY' EY'].
    apply (same_places_same M) in A; [|assumption|assumption]. rewrite EY' in A.
    exists (pred (Pos.to_nat t)), (pred (Pos.to_nat u)), (places X), (places Y), (shift o).
    repeat (split; [assumption || now apply (shift_vector m M sane lattice)|]). assumption.
  - apply open_shown.
  - intros A. cbn [shown_in_periodic] in A. rewrite !andb_true_iff in A.
    destruct A as [[[W Lo] N] A]. apply of_dimension_length in Lo.
    apply cell_framed in A. destruct A as (X & F & L & E & WX & A).
    apply cell_framed in A. destruct A as (Y & FY & LY & EY & _ & A).
    destruct (shifted_all m M sane lattice o Y FY) as [FY' EY'].
    rewrite !andb_true_iff in A. destruct A as [[[PX PY] In_X] In_Y].
    unfold point_written in W. apply andb_prop in W. destruct W as [Sq W].
    unfold shaped in Sq. apply Nat.eqb_eq in Sq. rewrite (dimension_d M) in Sq.
    apply Z.ltb_lt in W.
    destruct (proper_framed M X F L PX) as (a & Fa).
    destruct (proper_framed M _ FY' ltac:(now rewrite map_length) PY) as (b & Fb).
    exists (pred (Pos.to_nat t)), (pred (Pos.to_nat u)), (places X), (places Y), (shift o),
      (@place_over d r q w).
    split; [assumption|]. split; [assumption|].
    split; [now apply (shift_vector m M sane lattice)|].
    unfold strictly_in_simplex, in_simplex, corners_numbered in In_X, In_Y.
    rewrite (dimension_d M), forallb_forall in In_X, In_Y. split; [|split].
    + rewrite <- (framed_vertices _ _ Fa). apply ConstrainedLemma.inside_strictly. intros i Hi.
      apply (coordinate_positive M X a Fa); auto. now apply In_X, in_seq_d.
    + rewrite <- EY', <- (framed_vertices _ _ Fb). apply conv_vertices. intros i Hi.
      apply (coordinate_nonnegative M _ b Fb); auto. now apply In_Y, in_seq_d.
    + apply orb_prop in N. destruct N as [N|N]; apply negb_true_iff in N;
        [left; now apply numbers_differ|right].
      intros Z. now rewrite (all_zero_of_shift o Lo Z) in N.
  - apply left_out_shown.
  - intros A. cbn [shown_in_periodic] in A. apply andb_prop in A. destruct A as [Lo A].
    apply of_dimension_length in Lo. apply cell_framed in A.
    destruct A as (X & F & L & E & WX & A). apply andb_prop in A. destruct A as [P A].
    rewrite find_in_points in A.
    destruct (numbered (periodic_sites m) p) as [s|] eqn:Es; [|discriminate].
    assert (Is : In s (periodic_sites m)) by now apply numbered_in in Es.
    assert (Ss : well_shaped d s).
    { pose proof (sites_shaped m M sane lattice) as Fs. rewrite Forall_forall in Fs. now apply Fs. }
    destruct (place_shifted m M sane lattice o s Ss) as [S' P'].
    destruct (proper_framed M X F L P) as (a & Fa).
    exists (places X), (place_of r s), (shift o). split; [now apply nth_error_In in E|].
    split; [now apply in_map|]. split; [now apply (shift_vector m M sane lattice)|].
    intros c r2 C. rewrite <- (framed_vertices _ _ Fa) in C. rewrite <- P'.
    apply (in_ball_below_witness a c r2 _ C). apply (below_witness M X a Fa norm2); auto.
    intros y [<-|Iy]; apply height_unweighted; auto.
Qed.
End Refuted.

Theorem refute_periodic_rule D x : refute_periodic D x = true ->
  let d := dimension_of D in let m := periodic_against x in
  broken_in_periodic (periodic_because x) (lattice_of d m) (periodic_points d m)
    (periodic_cells d m) /\
  ~ periodic_delaunay (lattice_of d m) (periodic_points d m) (periodic_cells d m).
Proof.
  intros A. cbv zeta. unfold refute_periodic in A. cbv zeta in A. apply andb_prop in A.
  destruct A as [A A3]. apply andb_prop in A. destruct A as [A1 A2].
  assert (U : 0 < periodic_unit (periodic_against x)) by now apply periodic_unit_positive in A1.
  destruct D.
  - pose proof (evidence_shows _ (measured_plane _ U) A1 A2 ltac:(cbn; lia) _ A3) as H.
    split; [exact H|].
    exact (broken_refutes _ (measured_plane _ U) A1 A2 ltac:(cbn; lia) _ H).
  - pose proof (evidence_shows _ (measured_space _ U) A1 A2 ltac:(cbn; lia) _ A3) as H.
    split; [exact H|].
    exact (broken_refutes _ (measured_space _ U) A1 A2 ltac:(cbn; lia) _ H).
Qed.
