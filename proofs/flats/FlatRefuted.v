(** * What an accepted refutation of points that do not span says *)
From Coq Require Import Rbase Rfunctions Lra List Arith Lia ZArith Bool.
From Circumspect Require Import FlatRefutation Numbering.
From Circumspect Require Import Definitions Flats Vectors Affine Frame Faces Orientation Integers
  RefutationSigns Breach CallerMesh EvidenceSound Dimension Separated.
From Circumspect Require Balls MeshAloneSound.
Import ListNotations.
Open Scope R_scope.

(** ** Where the simplices of a line end

    Near a vertex where one simplex ends, and no other begins, points that go on are in no
    simplex. *)
Section Ending.
Context {d : nat}.
Variables (S : list (point d)) (T : list (simplex d)) (x g : point d -> R) (a e : point d).
Hypothesis Tr : flat_triangulation 1 S T.
Hypothesis affine_x : affine x.
Hypothesis on_line : forall q, In q S -> q = mix a e (x q).
Variables (s : simplex d) (u v p : point d).
Hypotheses (Is : In s T) (Iu : In u s) (Iv : In v s) (Ip : In p S).
Hypothesis affine_g : affine g.
Hypotheses (Gv : g v = 0) (Gu : 0 < g u) (Gp : g p < 0).
Hypothesis alone : forall t, In t T -> In v t -> same s t.

Lemma apart_from_vertex (l : list (point d)) :
  exists c, 0 < c /\ forall w, In w l -> x w <> x v -> c <= Rabs (x w - x v).
Proof.
  induction l as [|w l (c & C & H)]; [exists 1; split; [lra|intros w []]|].
  destruct (Req_dec (x w) (x v)) as [E|N].
  - exists c. split; [assumption|]. intros q [<-|I] Nq; [contradiction|auto].
  - exists (Rmin c (Rabs (x w - x v))). split.
    + apply Rmin_pos; [assumption|]. apply Rabs_pos_lt. lra.
    + intros q [<-|I] Nq; [apply Rmin_r|]. apply Rle_trans with c; [apply Rmin_l|auto].
Qed.

Lemma all_of_line f q : affine f -> In q S -> f q = (1 - x q) * f a + x q * f e.
Proof. intros A I. rewrite (on_line q I) at 1. now apply affine_mix. Qed.
(** A vertex is in no simplex but those that have it. *)
Lemma between_two t w z : In v S -> In t T -> In w t -> In z t -> x w <= x v <= x z ->
  x w < x z -> In v t.
Proof.
  intros IS It Iw Iz B L. destruct Tr as (_ & (_ & _ & Meet) & _ & Inc & _).
  assert (C : conv t v).
  { apply (conv_incl [w; z]); [intros q [<-|[<-|[]]]; assumption|]. set (k := (x v - x w) / (x z - x w)).
    assert (Inv : 0 < / (x z - x w)) by (apply Rinv_0_lt_compat; lra).
    assert (E : v = mix w z k).
    { apply affine_separate. intros f A. rewrite (affine_mix f) by assumption.
      rewrite (all_of_line f v A IS), (all_of_line f w A), (all_of_line f z A)
        by now apply (Inc t It).
      unfold k. field. lra. }
    rewrite E. apply conv_mix; [apply conv_point; now left|now right; left|].
    unfold k, Rdiv. split; [apply Rmult_le_pos; lra|].
    apply (Rmult_le_reg_r (x z - x w)); [lra|]. rewrite Rmult_assoc, Rinv_l; lra. }
  destruct (Meet [v] t) as (f & F1 & F2 & F3).
  - split; [repeat constructor; intros []|]. split; [discriminate|]. exists s.
    split; [assumption|]. intros q [<-|[]]. assumption.
  - split; [apply Tr, It|]. split; [now intros ->|]. exists t.
    split; [assumption|apply incl_refl].
  - specialize (F3 v (conv_point [v] v (or_introl eq_refl)) C).
    destruct f as [|b f]; [now apply conv_empty in F3|].
    destruct (F1 b (or_introl eq_refl)) as [<-|[]]. apply F2. now left.
Qed.

Theorem goes_on : False.
Proof.
  pose proof Tr as (Len & _ & _ & Inc & Cover & _).
  assert (Sv : In v S) by now apply (Inc s Is).
  assert (Own : forall w, In w s -> 0 <= g w).
  { destruct (Len s Is) as [_ L]. clear - Iu Iv Gv Gu L.
    destruct s as [|b [|c [|]]]; try discriminate.
    intros w Iw. destruct Iu as [<-|[<-|[]]], Iv as [E|[E|[]]]; rewrite <- E in Gv;
      destruct Iw as [<-|[<-|[]]]; lra. }
  destruct (apart_from_vertex S) as (c & C & Far).
  assert (D : x p <> x v).
  { intros E. assert (p = v) as Q by (rewrite (on_line p Ip), (on_line v Sv); now rewrite E).
    rewrite Q in Gp. lra. }
  assert (Cp := Far p Ip D). set (m := Rabs (x p - x v)) in *.
  set (k := c / (2 * m)).
  assert (K : 0 < k <= 1 / 2).
  { unfold k. split; [apply Rdiv_lt_0_compat; lra|].
    apply (Rmult_le_reg_r (2 * m)); [lra|]. unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (Near : Rabs (k * (x p - x v)) < c).
  { rewrite Rabs_mult, (Rabs_pos_eq k) by lra. fold m. unfold k.
    replace (c / (2 * m) * m) with (c / 2) by (field; lra). lra. }
  set (y := mix v p k).
  assert (Xy : x y = x v + k * (x p - x v)) by (unfold y; rewrite affine_mix by assumption; ring).
  assert (Cy : conv S y) by (apply conv_mix; [now apply conv_point|assumption|lra]).
  apply Cover in Cy. destruct Cy as (t & It & Cy).
  assert (Out : ~ In v t).
  { intros It'. destruct (alone t It It') as [_ Sub].
    assert (0 <= g y) by (apply (affine_conv g t); auto).
    unfold y in *. rewrite affine_mix in * by assumption. nra. }
  destruct (Len t It) as [_ L]. destruct t as [|w [|z [|]]]; try discriminate.
  assert (Off : forall q, In q [w; z] -> c <= Rabs (x q - x v)).
  { intros q Iq. apply Far; [now apply (Inc _ It)|]. intros E. apply Out.
    assert (v = q) as ->; [|assumption].
    rewrite (on_line v Sv), (on_line q (Inc _ It q Iq)). now rewrite E. }
  pose proof (Off w (or_introl eq_refl)) as Ow.
  pose proof (Off z (or_intror (or_introl eq_refl))) as Oz.
  assert (Bound : forall b m, (forall q, In q [w; z] -> 0 <= b * x q + m * 1) ->
    0 <= b * x y + m * 1).
  { intros b m' H. apply (affine_conv (fun q => b * x q + m' * 1) [w; z]); [|assumption|assumption].
    apply (affine_combine x (fun _ => 1)); [assumption|apply affine_const]. }
  apply Rabs_def2 in Near. rewrite Xy in Bound.
  unfold Rabs in Ow, Oz. destruct (Rcase_abs (x w - x v)), (Rcase_abs (x z - x v)).
  - specialize (Bound (-1) (x v - c)). enough (0 <= -1 * (x v + k * (x p - x v)) + (x v - c) * 1)
      by lra. apply Bound. intros q [<-|[<-|[]]]; lra.
  - apply Out, (between_two _ w z); cbn; auto; lra.
  - apply Out, (between_two _ z w); cbn; auto; lra.
  - specialize (Bound 1 (- x v - c)). enough (0 <= 1 * (x v + k * (x p - x v)) + (- x v - c) * 1)
      by lra. apply Bound. intros q [<-|[<-|[]]]; lra.
Qed.
End Ending.

(** ** A broken rule refutes the claim *)

Definition lie_on_line {d} (S : list (point d)) : Prop := exists x a e, affine x /\
  forall q, In q S -> q = mix a e (x q).
Lemma broken_flat_no_claim {d} k c (S : list (point d)) L rule : of_dimension k S ->
  (rule = delaunay_vertex_in_ball -> c = Delaunay) ->
  (rule = triangulation_hull_not_convex -> lie_on_line S) ->
  broken_of_flat k S L rule -> ~ claims_flat c S L.
Proof.
  intros Dim Del Line B (k' & T & Dim' & -> & H).
  assert (k' = k) as -> by now apply (dimension_once _ _ S).
  assert (Tr : flat_triangulation k S T) by (destruct c; [assumption|apply H|assumption]).
  pose proof Tr as (Len & _ & _ & _ & _ & Used). destruct rule; try contradiction.
  - destruct B as (r & Ir & N). apply in_map_iff in Ir. destruct Ir as (t & <- & It).
    apply N. rewrite map_length. now apply Len.
  - destruct B as (p & Ip & N). destruct (Used p Ip) as (t & It & J).
    apply (N (map Some t)); now apply in_map.
  - destruct B as [-> (s & f & u & p & Ls & _ & _ & _ & Lf & If & Al & Iu & Ip & n & b & Z & U & P)].
    destruct (Line eq_refl) as (x & a & e & A & On).
    destruct f as [|v [|]]; try discriminate.
    apply (goes_on S T x (plane n b) a e Tr A On s u v p); auto using listed_in, affine_plane.
    + apply If. now left.
    + apply Z. now left.
    + intros t It Iv. apply Al; [now apply (in_map (map Some))|]. intros q [<-|[]]. assumption.
  - rewrite (Del eq_refl) in H. destruct H as [_ D].
    destruct B as (s & p & Ls & _ & _ & Ip & B).
    destruct (D s (listed_in T s Ls)) as (o & r2 & Ci & Em). apply (Em p Ip), B, Ci.
Qed.

(** ** What the evidence shows *)

Section Shown.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis M : forall r, 0 < r -> measured orient pr r.
Variable x : flat_refutation.
Notation m := (flat_mesh x).
Notation r := (refuted_unit m).
Hypothesis accepted : refute_flat_in pr x = true.
Notation place := (@place_of d r).
Notation PS := (@caller_points d r (sites m)).
Notation LS := (@caller_rows d r (sites m) (rows m)).

Notation find_site := (find_id (sites m)).
Notation find_row := (find_id (rows m)).
Lemma all_shaped l : 0 < r -> forallb (shaped pr) l = true -> Forall (well_shaped d) l.
Proof.
  intros U H. apply Forall_forall. intros s I. rewrite forallb_forall in H. specialize (H s I).
  unfold shaped in H. apply Nat.eqb_eq in H. now rewrite (dimension_d (M r U)) in H.
Qed.

Lemma ball_shown_flat n p row : 0 < r -> Forall (well_shaped d) (sites m) ->
  Forall (well_shaped d) (flat_pads x) -> (n + length (flat_pads x) = Datatypes.S d)%nat ->
  In p (sites m) -> In (map (@caller_entry d r (sites m)) row) LS ->
  in_every_ball pr x n p row = true -> flat_vertex_in_ball (pred n) PS LS \/ n = 0%nat.
Proof.
  intros U Sh Pa N Ip Ir H. unfold in_every_ball in H. apply andb_prop in H. destruct H as [Len H].
  apply has_length_length in Len. destruct (all_named _ row) as [X|] eqn:E; [|discriminate].
  apply andb_prop in H. destruct H as [Pr Nb].
  apply (all_named_rows (M r U) (sites m) (rows m) _ (Table.of_list id (rows m))
    Sh find_site find_row) in E. destruct E as [E IX].
  assert (LX : length X = n).
  { apply (f_equal (@length _)) in E. rewrite !map_length in E. congruence. }
  assert (ShX : Forall (well_shaped d) X) by (eapply incl_Forall; eassumption).
  destruct (proper_framed (M r U) (X ++ flat_pads x)) as (t & F);
    [now apply Forall_app|rewrite app_length; lia|assumption|].
  destruct n as [|k]; [now right|left]. exists (map place X), (place p).
  split; [unfold listed; now rewrite <- E|]. split; [now rewrite map_length|].
  split.
  { pose proof (framed_vertices _ t F) as V. pose proof (vertices_NoDup t) as Nd.
    rewrite V, map_app in Nd. apply (face_independent t).
    - rewrite V, map_app. now apply incl_appl, incl_refl.
    - now apply MeshAloneSound.NoDup_front in Nd. }
  split; [now apply in_map|]. intros c r2 Ci.
  assert (Sub : incl (map snd (combine (ball_own x) X)) X).
  { intros s I. apply in_map_iff in I. destruct I as ((z & s') & <- & I).
    now apply in_combine_r in I. }
  destruct (Balls.no_ball_inside (M r U) U _ _ c r2 Nb) as (z & q & [I|[]] & L).
  - rewrite map_app. apply Forall_app. split; [eapply incl_Forall; eassumption|].
    constructor; [|constructor]. rewrite Forall_forall in Sh. now apply Sh.
  - intros v Iv. apply Ci. revert v Iv. now apply incl_map.
  - injection I as _ <-. exact L.
Qed.

(** Where the coordinates but two are zero, a point is on the line of two vertices. *)
Lemma on_line_of (t : frame d) (S : list (point d)) : (1 <= d)%nat ->
  (forall q i, In q S -> (2 <= i <= d)%nat -> bary t i q = 0) -> lie_on_line S.
Proof.
  intros D H. exists (bary t 1), (vertex t 0), (vertex t 1). split; [now apply bary_affine|].
  intros q I. apply affine_separate. intros f A. rewrite (affine_mix f) by assumption.
  assert (Two : forall g, sum (Datatypes.S d) (fun i => bary t i q * g i) =
    bary t 0 q * g 0%nat + bary t 1 q * g 1%nat).
  { intros g. unfold sum. replace (Datatypes.S d) with (2 + (d - 1))%nat by lia.
    cbn [Nat.add seq sum_over]. rewrite (sum_zero (seq 2 (d - 1))); [ring|].
    intros i Hi. apply in_seq in Hi. rewrite H by (assumption || lia). ring. }
  pose proof (interpolation t (fun _ => 1) q (affine_const 1)) as O.
  cbn beta in O. rewrite (Two (fun _ => 1)) in O. rewrite (interpolation t f q A), (Two (fun i => f (vertex t i))).
  replace (bary t 0 q) with (1 - bary t 1 q) by lra. reflexivity.
Qed.

Lemma end_shown i p row : 0 < r -> Forall (well_shaped d) (sites m) ->
  Forall (well_shaped d) (flat_pads x) -> (2 + length (flat_pads x) = Datatypes.S d)%nat ->
  In p (sites m) -> In (map (@caller_entry d r (sites m)) row) LS ->
  ends_before pr x i p row = true -> flat_hull_not_convex 1 PS LS.
Proof.
  intros U Sh Pa N Ip Ir H. unfold ends_before in H. apply andb_prop in H. destruct H as [Len H].
  apply has_length_length in Len. destruct (all_named _ row) as [X|] eqn:E; [|discriminate].
  rewrite !andb_true_iff in H. destruct H as [[[Pr Hi] Be] No]. apply Nat.ltb_lt in Hi.
  apply (all_named_rows (M r U) (sites m) (rows m) _ (Table.of_list id (rows m))
    Sh find_site find_row) in E. destruct E as [E IX].
  assert (LX : length X = 2%nat).
  { apply (f_equal (@length _)) in E. rewrite !map_length in E. congruence. }
  assert (ShX : Forall (well_shaped d) X) by (eapply incl_Forall; eassumption).
  destruct (proper_framed (M r U) (X ++ flat_pads x)) as (t & F);
    [now apply Forall_app|rewrite app_length; lia|assumption|].
  assert (Alone : forall s', listed LS s' -> incl (map place (remove i X)) s' ->
    same (map place X) s').
  { intros s' Ls Inc. apply in_map_iff in Ls. destruct Ls as (row' & E' & Ir').
    rewrite forallb_forall in No. specialize (No row' Ir'). unfold no_other_row in No.
    apply orb_true_iff in No. destruct No as [No|No].
    - exfalso. apply negb_true_iff in No.
      assert (All : forallb (fun q => lists (Table.of_list id (sites m)) q row') (remove i X) = true);
        [|congruence].
      apply forallb_forall. intros q Iq.
      apply (all_named_listed (M r U) (sites m) (rows m) _ (Table.of_list id (rows m))
        Sh find_site find_row row' s' E').
      + apply IX. now apply remove_incl in Iq.
      + apply Inc. now apply in_map.
    - destruct (all_named _ row') as [Y|] eqn:EY; [|discriminate].
      apply (all_named_rows (M r U) (sites m) (rows m) _ (Table.of_list id (rows m))
        Sh find_site find_row) in EY. destruct EY as [EY IY].
      rewrite EY in E'. apply map_some_inj in E'. subst s'.
      apply (same_places_same (M r U)); auto. eapply incl_Forall; eassumption. }
  assert (Ind : affinely_independent (map place X)).
  { pose proof (framed_vertices _ t F) as V. pose proof (vertices_NoDup t) as Nd.
    rewrite V, map_app in Nd. apply (face_independent t).
    - rewrite V, map_app. now apply incl_appl, incl_refl.
    - now apply MeshAloneSound.NoDup_front in Nd. }
  assert (Hd : (i <= d)%nat) by lia.
  destruct (bary_affine t i Hd) as (n & b & Eg).
  assert (Neg : bary t i (place p) < 0).
  { rewrite <- place_over_one. apply (coordinate_negative (M r U) _ t F p 1 i Hd); auto; [|lia].
    rewrite Forall_forall in Sh. now apply Sh. }
  destruct X as [|b0 [|b1 [|]]]; try discriminate.
  pose proof (proj2 (framed_vertex _ t F 0 b0 eq_refl)) as V0.
  pose proof (proj2 (framed_vertex _ t F 1 b1 eq_refl)) as V1.
  assert (Sides : forall k j v w, (k <= d)%nat -> (j <= d)%nat -> k <> j -> i = k ->
    vertex t k = v -> vertex t j = w -> on_opposite_sides [w] v (place p)).
  { intros k j v w Hk Hj Nk -> <- <-. exists n, b. rewrite <- !Eg. rewrite bary_own by assumption.
    split; [|split; [lra|assumption]]. intros q [<-|[]]. rewrite <- Eg. now apply bary_other. }
  exists (map place [b0; b1]), (map place (remove i [b0; b1])),
    (place (if Nat.eq_dec i 0 then b0 else b1)), (place p).
  split; [unfold listed; now rewrite <- E|]. split; [reflexivity|]. split; [assumption|].
  destruct i as [|[|i]]; [| |lia]; cbn [remove map Nat.eq_dec nat_rect nat_rec] in *;
    (split; [repeat constructor; intros []|]); (split; [reflexivity|]);
    (split; [intros q [<-|[]]; cbn; auto|]); (split; [assumption|]);
    (split; [cbn; auto|]); (split; [now apply in_map|]).
  - now apply (Sides 0%nat 1%nat); try lia.
  - now apply (Sides 1%nat 0%nat); try lia.
Qed.

Theorem refute_flat_broken : exists k, of_dimension k PS /\
  broken_of_flat k PS LS (rule_of (because m)) /\
  (rule_of (because m) = delaunay_vertex_in_ball -> refuted m = Delaunay) /\
  (rule_of (because m) = triangulation_hull_not_convex -> lie_on_line PS).
Proof.
  pose proof accepted as A. unfold refute_flat_in in A. cbv zeta in A. rewrite !andb_true_iff in A.
  destruct A as [[[[[_ Pn] Pd] Ss] Sp] A]. apply Z.ltb_lt, IZR_lt in Pn, Pd.
  assert (U : 0 < r) by (unfold refuted_unit; now apply Rdiv_lt_0_compat).
  apply (all_shaped _ U) in Ss. apply (all_shaped _ U) in Sp.
  destruct (all_named _ (map Some (basis m))) as [B|] eqn:EB; [|discriminate].
  rewrite !andb_true_iff in A. destruct A as [[[[Ne Rl] Pr] Fl] Sh].
  apply (all_named_rows (M r U) (sites m) (rows m) _ (Table.of_list id (rows m))
    Ss find_site find_row) in EB. destruct EB as [_ IB].
  apply negb_true_iff, Nat.eqb_neq in Ne. unfold right_length in Rl.
  rewrite (dimension_d (M r U)) in Rl. apply has_length_length in Rl.
  assert (Bn : B <> []) by now intros ->.
  rewrite app_length in Rl.
  destruct (proper_framed (M r U) (B ++ flat_pads x)) as (t & F);
    [apply Forall_app; split; [eapply incl_Forall; eassumption|assumption]
    |rewrite app_length; lia|assumption|].
  exists (pred (length B)). split; [|split; [|split]].
  - apply (dimension_signs (M r U) B (flat_pads x) t); try assumption; [lia|].
    intros s i Is Hi. rewrite forallb_forall in Fl. specialize (Fl s Is). unfold in_flat in Fl.
    rewrite forallb_forall in Fl. apply Z.eqb_eq, Fl. rewrite (dimension_d (M r U)).
    apply in_seq. lia.
  - unfold shown_of_flat in Sh. destruct (because m) eqn:Eb; try discriminate;
      cbn [rule_of broken_of_flat].
    + apply (row_at_in (M r U) (sites m) (rows m) _ _ Ss find_site find_row) in Sh.
      destruct Sh as (row & _ & Ir & H). apply negb_true_iff in H.
      exists (map (@caller_entry d r (sites m)) row). split; [assumption|]. intros L.
      assert (T : has_length (length B) row = true); [|congruence].
      apply has_length_length. rewrite map_length in L. lia.
    + apply (point_at_in (M r U) (sites m) (rows m) _ _ Ss find_site find_row) in Sh.
      destruct Sh as (q & Iq & H). apply negb_true_iff in H.
      exact (unused_breach (M r U) (sites m) (rows m) _ _ Ss find_site find_row q Iq H).
    + apply andb_prop in Sh. destruct Sh as [Two Sh]. apply Nat.eqb_eq in Two. rewrite Two in *.
      split; [reflexivity|].
      apply (point_at_in (M r U) (sites m) (rows m) _ _ Ss find_site find_row) in Sh.
      destruct Sh as (q & Iq & Sh).
      apply (row_at_in (M r U) (sites m) (rows m) _ _ Ss find_site find_row) in Sh.
      destruct Sh as (row & _ & Ir & H). exact (end_shown i q row U Ss Sp Rl Iq Ir H).
    + destruct (refuted m) eqn:Er; try discriminate.
      apply (point_at_in (M r U) (sites m) (rows m) _ _ Ss find_site find_row) in Sh.
      destruct Sh as (q & Iq & Sh).
      apply (row_at_in (M r U) (sites m) (rows m) _ _ Ss find_site find_row) in Sh.
      destruct Sh as (row & _ & Ir & H).
      destruct (ball_shown_flat (length B) q row U Ss Sp Rl Iq Ir H); [assumption|contradiction].
  - intros Eb. unfold shown_of_flat in Sh. destruct (because m); try discriminate.
    now destruct (refuted m).
  - intros Eb. unfold shown_of_flat in Sh.
    assert (Two : length B = 2%nat).
    { destruct (because m); try discriminate. apply andb_prop in Sh. now apply Nat.eqb_eq. }
    apply (on_line_of t); [lia|]. intros q i Iq Hi. apply in_map_iff in Iq.
    destruct Iq as (s & <- & Is). apply (sign_zero (M r U) (B ++ flat_pads x)); auto; [lia| |].
    + rewrite Forall_forall in Ss. now apply Ss.
    + rewrite forallb_forall in Fl. specialize (Fl s Is). unfold in_flat in Fl.
      rewrite forallb_forall in Fl. apply Z.eqb_eq, Fl. rewrite (dimension_d (M r U)).
      apply in_seq. lia.
Qed.
End Shown.

(** Whatever is accepted: the points have a dimension, and the claim is false of them, because the
    rule is broken. *)
Theorem refute_flat_rule D x : refute_flat D x = true ->
  (exists k, of_dimension k (refuted_points D (flat_mesh x)) /\
    broken_of_flat k (refuted_points D (flat_mesh x)) (refuted_simplices D (flat_mesh x))
      (rule_of (because (flat_mesh x)))) /\
  ~ claims_flat (refuted (flat_mesh x)) (refuted_points D (flat_mesh x))
      (refuted_simplices D (flat_mesh x)).
Proof.
  intros A.
  assert (B : exists k, of_dimension k (refuted_points D (flat_mesh x)) /\
    broken_of_flat k (refuted_points D (flat_mesh x)) (refuted_simplices D (flat_mesh x))
      (rule_of (because (flat_mesh x))) /\
    (rule_of (because (flat_mesh x)) = delaunay_vertex_in_ball ->
      refuted (flat_mesh x) = Delaunay) /\
    (rule_of (because (flat_mesh x)) = triangulation_hull_not_convex ->
      lie_on_line (refuted_points D (flat_mesh x)))).
  { destruct D; [exact (refute_flat_broken measured_plane x A)
                |exact (refute_flat_broken measured_space x A)]. }
  destruct B as (k & Dim & B & C & O). split; [eauto|].
  exact (broken_flat_no_claim k _ _ _ _ Dim C O B).
Qed.
