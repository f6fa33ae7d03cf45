(** * What an accepted refutation of points that do not span says *)
From Coq Require Import Rbase Rfunctions Lra List Arith Lia ZArith Bool.
From Circumspect Require Import FlatRefutation Numbering.
From Circumspect Require Import Definitions Flats Vectors Affine Frame Faces Orientation Integers
  RefutationSigns Breach CallerMesh EvidenceSound Dimension.
From Circumspect Require Balls MeshAloneSound.
Import ListNotations.
Open Scope R_scope.

(** ** A broken rule refutes the claim *)

Lemma broken_flat_no_claim {d} k c (S : list (point d)) L rule : of_dimension k S ->
  (rule = delaunay_vertex_in_ball -> c = Delaunay) -> broken_of_flat k S L rule ->
  ~ claims_flat c S L.
Proof.
  intros Dim Del B (k' & T & Dim' & -> & H).
  assert (k' = k) as -> by now apply (dimension_once _ _ S).
  assert (Tr : flat_triangulation k S T) by (destruct c; [assumption|apply H|assumption]).
  destruct Tr as (Len & _ & _ & _ & _ & Used). destruct rule; try contradiction.
  - destruct B as (r & Ir & N). apply in_map_iff in Ir. destruct Ir as (t & <- & It).
    apply N. rewrite map_length. now apply Len.
  - destruct B as (p & Ip & N). destruct (Used p Ip) as (t & It & J).
    apply (N (map Some t)); now apply in_map.
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

Theorem refute_flat_broken : exists k, of_dimension k PS /\
  broken_of_flat k PS LS (rule_of (because m)) /\
  (rule_of (because m) = delaunay_vertex_in_ball -> refuted m = Delaunay).
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
  exists (pred (length B)). split; [|split].
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
    + destruct (refuted m) eqn:Er; try discriminate.
      apply (point_at_in (M r U) (sites m) (rows m) _ _ Ss find_site find_row) in Sh.
      destruct Sh as (q & Iq & Sh).
      apply (row_at_in (M r U) (sites m) (rows m) _ _ Ss find_site find_row) in Sh.
      destruct Sh as (row & _ & Ir & H).
      destruct (ball_shown_flat (length B) q row U Ss Sp Rl Iq Ir H); [assumption|contradiction].
  - intros Eb. unfold shown_of_flat in Sh. destruct (because m); try discriminate.
    now destruct (refuted m).
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
      refuted (flat_mesh x) = Delaunay)).
  { destruct D; [exact (refute_flat_broken measured_plane x A)
                |exact (refute_flat_broken measured_space x A)]. }
  destruct B as (k & Dim & B & C). split; [eauto|]. exact (broken_flat_no_claim k _ _ _ _ Dim C B).
Qed.
