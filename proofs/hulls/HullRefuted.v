(** * What an accepted refutation of a convex hull says

    If points lie on both sides of a facet, one gets from a point inside of it nowhere out of their
    hull: on either side there is a d-simplex, of the facet and such a point. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Bool.
From Circumspect Require Import HullRefutation Numbering.
From Circumspect Require Import Definitions Domains Hulls Vectors Affine Frame Faces Orientation
  Integers RefutationSigns CallerMesh Breach.
From Circumspect Require MeshAloneSound.
Import ListNotations.
Open Scope R_scope.

Section Sides.
Context {d : nat}.
Variables (S : list (point d)) (f : simplex d) (a b : point d) (u v : frame d).
Hypotheses (Fu : vertices u = f ++ [a]) (Fv : vertices v = f ++ [b]).
Hypotheses (length_f : length f = d) (some_d : (0 < d)%nat).
Hypothesis other_side : bary u d b < 0.
Hypotheses (If : incl f S) (Ia : In a S) (Ib : In b S).

Lemma vertices_common : (forall i, (i < d)%nat -> vertex u i = vertex v i /\ In (vertex u i) f) /\
  vertex u d = a /\ vertex v d = b.
Proof.
  assert (At : forall (t : frame d) i, (i <= d)%nat -> vertex t i = nth i (vertices t) origin).
  { intros t i Hi. unfold vertices. rewrite (nth_indep _ origin (vertex t 0)), map_nth, seq_nth;
      [reflexivity|lia|rewrite map_length, seq_length; lia]. }
  split; [|split].
  - intros i Hi. rewrite !At, Fu, Fv, !app_nth1 by lia. split; [reflexivity|]. apply nth_In. lia.
  - rewrite At, Fu, app_nth2, length_f, Nat.sub_diag by lia. reflexivity.
  - rewrite At, Fv, app_nth2, length_f, Nat.sub_diag by lia. reflexivity.
Qed.

(** A point inside the facet: on the way from [a] through the middle of the simplex. *)
Lemma facet_inside : exists q, conv f q /\ bary u d q = 0 /\ bary v d q = 0 /\
  (forall i, (i < d)%nat -> 0 < bary u i q /\ bary v i q = bary u i q).
Proof.
  destruct vertices_common as (Com & Ea & Eb).
  set (k := / INR (Datatypes.S d)). assert (K : 0 < k < 1).
  { unfold k. assert (1 < INR (Datatypes.S d)) by (apply lt_1_INR; lia). split.
    - apply Rinv_0_lt_compat. lra.
    - rewrite <- Rinv_1. apply Rinv_lt_contravar; lra. }
  set (s := / (1 - k)). assert (E : s * (1 - k) = 1) by (unfold s; field; lra).
  assert (P : 0 < s) by (unfold s; apply Rinv_0_lt_compat; lra).
  set (q := mix a (barycentre u) s).
  assert (B : forall i, (i <= d)%nat -> bary u i q = (1 - s) * bary u i a + s * k).
  { intros i Hi. unfold q. rewrite (affine_mix _ _ _ _ (bary_affine u i Hi)).
    now rewrite bary_barycentre. }
  assert (Bd : bary u d q = 0).
  { rewrite B by lia. rewrite <- Ea, bary_own by lia. lra. }
  assert (Bi : forall i, (i < d)%nat -> bary u i q = s * k).
  { intros i Hi. rewrite B by lia. rewrite <- Ea, bary_other by lia. ring. }
  assert (V : forall i, (i <= d)%nat -> bary v i q =
    if Nat.eq_dec i d then 0 else bary u i q).
  { intros i Hi. rewrite (interpolation u (bary v i) q (bary_affine v i Hi)). unfold sum.
    assert (T : forall j, In j (seq 0 (Datatypes.S d)) ->
      bary u j q * bary v i (vertex u j) = if Nat.eq_dec j i then (if Nat.eq_dec i d then 0 else
        bary u i q) else 0).
    { intros j Hj. apply in_seq_d in Hj. destruct (Nat.eq_dec j d) as [->|N].
      - rewrite Bd. destruct (Nat.eq_dec d i) as [<-|]; [|ring].
        destruct (Nat.eq_dec d d); [ring|congruence].
      - rewrite (proj1 (Com j ltac:(lia))), bary_vertex by lia.
        destruct (Nat.eq_dec i j) as [<-|].
        + destruct (Nat.eq_dec i i), (Nat.eq_dec i d); congruence || ring.
        + destruct (Nat.eq_dec j i); [congruence|ring]. }
    rewrite (sum_ext _ _ _ T), (sum_one _ _ i); [|apply seq_NoDup|now apply in_seq_d|].
    - now destruct (Nat.eq_dec i i).
    - intros j _ N. destruct (Nat.eq_dec j i); congruence. }
  exists q. split.
  { apply (conv_incl (carrier u q)).
    - intros w Iw. apply in_carrier in Iw. destruct Iw as (i & Hi & Pi & ->).
      destruct (Nat.eq_dec i d) as [->|]; [lra|]. apply Com. lia.
    - apply conv_carrier. intros i Hi. destruct (Nat.eq_dec i d) as [->|]; [lra|].
      rewrite Bi by lia. nra. }
  split; [assumption|]. split; [rewrite V by lia; destruct (Nat.eq_dec d d); congruence|].
  intros i Hi. rewrite V, Bi by lia. destruct (Nat.eq_dec i d); [lia|]. split; [nra|reflexivity].
Qed.

(** The coordinates at [a] and at [b] have opposite signs. *)
Lemma opposite_coordinates r : bary u d r = bary v d r * bary u d b.
Proof.
  destruct vertices_common as (Com & _ & Eb).
  rewrite (interpolation v (bary u d) r (bary_affine u d (le_n d))). unfold sum.
  rewrite (sum_one _ _ d); [now rewrite Eb|apply seq_NoDup|now apply in_seq_d|].
  intros j Hj N. apply in_seq_d in Hj.
  rewrite <- (proj1 (Com j ltac:(lia))), bary_other by lia. ring.
Qed.

Lemma stays_inside (t : frame d) q r : incl (vertices t) S ->
  (forall i, (i < d)%nat -> 0 < bary t i q) ->
  bary t d q = 0 -> 0 <= bary t d r -> exists s, 0 < s <= 1 /\ conv S (between q r s).
Proof.
  intros I P Z R.
  destruct (nearby (map (bary t) (seq 0 d)) q r) as (e & He & N).
  { intros g Ig. apply in_map_iff in Ig. destruct Ig as (i & <- & Hi). apply in_seq in Hi.
    split; [apply bary_affine; lia|apply P; lia]. }
  exists e. split; [lra|]. change (between q r e) with (mix q r e).
  apply (conv_incl (vertices t)); [assumption|]. apply conv_vertices. intros i Hi.
  destruct (Nat.eq_dec i d) as [->|Ni].
  - rewrite (affine_mix _ _ _ _ (bary_affine t d Hi)), Z. nra.
  - left. apply (N e ltac:(lra)). apply in_map, in_seq. lia.
Qed.

Theorem no_boundary : exists q, conv f q /\
  ~ boundary (LinearCell d (fun _ => True) (conv S)) q.
Proof.
  destruct facet_inside as (q & C & Zu & Zv & P). exists q. split; [assumption|].
  intros (_ & r & _ & Out). cbn [cell_points] in Out.
  assert (Iu : incl (vertices u) S).
  { rewrite Fu. intros p I. apply in_app_or in I. destruct I as [I|[<-|[]]]; auto. }
  assert (Iv : incl (vertices v) S).
  { rewrite Fv. intros p I. apply in_app_or in I. destruct I as [I|[<-|[]]]; auto. }
  assert (Go : exists s, 0 < s <= 1 /\ conv S (between q r s)).
  { destruct (Rle_dec 0 (bary u d r)) as [H|H].
    - apply (stays_inside u); auto. intros i Hi. now apply P.
    - apply (stays_inside v); auto.
      + intros i Hi. destruct (P i Hi) as [A E]. now rewrite E.
      + apply Rnot_le_lt in H. rewrite opposite_coordinates in H. nra. }
  destruct Go as (s & Hs & Cs). now apply (Out s).
Qed.
End Sides.

Section Refuted.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis M : forall r, 0 < r -> measured orient pr r.
Hypothesis some_d : (0 < d)%nat.
Variables (m : refutation) (t p q : positive).
Notation r := (refuted_unit m).
Hypothesis accepted : refute_hull_in pr m t p q = true.
Notation place := (@place_of d r).
Notation PS := (@caller_points d r (sites m)).
Notation LS := (@caller_rows d r (sites m) (rows m)).
Notation find_site := (find_id (sites m)).
Notation find_row := (find_id (rows m)).

Lemma replaced_last (X : list site) a b : replace (length X) b (X ++ [a]) = X ++ [b].
Proof. induction X as [|x X IH]; cbn; [reflexivity|]. now rewrite IH. Qed.

Theorem facet_shown : facet_not_supporting PS LS /\ ~ claims_hull PS LS.
Proof.
  pose proof accepted as A. unfold refute_hull_in in A. rewrite !andb_true_iff in A.
  destruct A as [[[Pn Pd] Ss] A]. apply Z.ltb_lt, IZR_lt in Pn, Pd.
  assert (U : 0 < r) by (unfold refuted_unit; now apply Rdiv_lt_0_compat).
  assert (Sh : Forall (well_shaped d) (sites m)).
  { apply Forall_forall. intros s I. rewrite forallb_forall in Ss. specialize (Ss s I).
    unfold shaped in Ss. apply Nat.eqb_eq in Ss. now rewrite (dimension_d (M r U)) in Ss. }
  apply (row_at_in (M r U) (sites m) (rows m) _ _ Sh find_site find_row) in A.
  destruct A as (row & _ & Ir & A). unfold parted_by in A. apply andb_prop in A.
  destruct A as [Len A]. rewrite (dimension_d (M r U)) in Len. apply has_length_length in Len.
  destruct (all_named _ row) as [f|] eqn:E; [|discriminate].
  apply (all_named_rows (M r U) (sites m) (rows m) _ (Table.of_list id (rows m))
    Sh find_site find_row) in E. destruct E as [E If].
  apply (point_at_in (M r U) (sites m) (rows m) _ _ Sh find_site find_row) in A.
  destruct A as (a & Ia & A).
  apply (point_at_in (M r U) (sites m) (rows m) _ _ Sh find_site find_row) in A.
  destruct A as (b & Ib & A). apply Z.ltb_lt in A.
  assert (Lf : length f = d).
  { apply (f_equal (@length _)) in E. rewrite !map_length in E. congruence. }
  assert (Fr : forall s, In s (sites m) -> orientation pr (f ++ [s]) <> 0%Z ->
    exists g : frame d, framed orient pr r (f ++ [s]) g).
  { intros s Is N. apply (proper_framed (M r U)).
    - apply Forall_app. split; [eapply incl_Forall; eassumption|]. constructor; [|constructor].
      rewrite Forall_forall in Sh. now apply Sh.
    - rewrite app_length, Lf. cbn. lia.
    - unfold proper. now apply negb_true_iff, Z.eqb_neq. }
  destruct (Fr a Ia ltac:(nia)) as (u & Fu). destruct (Fr b Ib ltac:(nia)) as (v & Fv).
  pose proof (framed_vertices _ _ Fu) as Vu. pose proof (framed_vertices _ _ Fv) as Vv.
  rewrite map_app in Vu, Vv. cbn [map] in Vu, Vv.
  assert (Side : bary u d (place b) < 0).
  { assert (Rp : replace d (place b) (map place (f ++ [a])) = map place (f ++ [b])).
    { pose proof (replaced_last f a b) as Rl. rewrite Lf in Rl. now rewrite <- replace_map, Rl. }
    rewrite (framed_bary _ _ Fu d (place b) (le_n d)), Rp.
    rewrite (orient_places (M r U) _ (framed_shaped _ _ Fu)),
      (orient_places (M r U) _ (framed_shaped _ _ Fv)).
    pose proof (power_positive (M r U) d) as Pp. apply IZR_lt in A. rewrite mult_IZR in A.
    pose proof (square_positive _ _ Fu) as Sq. set (x := IZR (orientation pr (f ++ [a]))) in *.
    set (y := IZR (orientation pr (f ++ [b]))) in *.
    assert (x <> 0) by (intros Z; rewrite Z in Sq; lra).
    replace (r ^ d * y / (r ^ d * x)) with (x * y / (x * x)) by (field; split; [assumption|lra]).
    apply Ropp_lt_cancel. rewrite Ropp_0, <- Ropp_div.
    apply Rdiv_lt_0_compat; lra. }
  assert (Lm : length (map place f) = d) by now rewrite map_length.
  assert (IfS : incl (map place f) PS) by now apply incl_map.
  assert (Ia' : In (place a) PS) by now apply in_map.
  assert (Ib' : In (place b) PS) by now apply in_map.
  split.
  - exists (map place f), (place a), (place b). split; [unfold listed; now rewrite <- E|].
    split; [assumption|]. split.
    { apply (face_independent u).
      - rewrite Vu. now apply incl_appl, incl_refl.
      - pose proof (vertices_NoDup u) as N. rewrite Vu in N.
        now apply MeshAloneSound.NoDup_front in N. }
    split; [assumption|]. split; [assumption|].
    destruct (vertices_common (map place f) (place a) (place b) u v Vu Vv Lm some_d)
      as (Com & Ea & _).
    destruct (bary_affine u d (le_n d)) as (n & c & Eg). unfold on_opposite_sides.
    exists n, c. rewrite <- !Eg.
    split; [|split; [rewrite <- Ea, bary_own by lia; lra|assumption]].
    intros w Iw. rewrite <- Eg. destruct (In_nth _ _ origin Iw) as (i & Hi & <-).
    assert (Ew : nth i (map place f) origin = vertex u i).
    { assert (Ev : nth i (vertices u) origin = vertex u i).
      { unfold vertices. rewrite (nth_indep _ origin (vertex u 0)), map_nth, seq_nth;
          [reflexivity|lia|rewrite map_length, seq_length; lia]. }
      rewrite <- Ev, Vu, app_nth1 by assumption. reflexivity. }
    rewrite Ew. apply bary_other; lia.
  - intros (H & EH & B).
    destruct (no_boundary PS (map place f) (place a) (place b) u v Vu Vv Lm some_d Side IfS Ia' Ib')
      as (c & Cc & Nb).
    apply Nb, (facets_cover PS H B). exists (map place f). split; [|assumption].
    apply listed_in. rewrite <- EH. unfold listed. now rewrite <- E.
Qed.
End Refuted.

(** Whatever is accepted: the claim is false, because the rule is broken. *)
Theorem refute_hull_rule D x : refute_hull D x = true ->
  facet_not_supporting (refuted_points D (hull_mesh x)) (refuted_simplices D (hull_mesh x)) /\
  ~ claims_hull (refuted_points D (hull_mesh x)) (refuted_simplices D (hull_mesh x)).
Proof.
  intros A. destruct D.
  - exact (facet_shown measured_plane ltac:(cbn; lia) _ _ _ _ A).
  - exact (facet_shown measured_space ltac:(cbn; lia) _ _ _ _ A).
Qed.
