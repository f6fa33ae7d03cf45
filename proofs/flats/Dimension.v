(** * The dimension of a point set, shown by a d-simplex

    If some vertices of a d-simplex are points of a set, and the others have no part in any point of
    it, then the set has the dimension of the face that these vertices span: more points than these
    are affinely dependent, since there are too few coordinates. *)
From Coq Require Import Rbase Rfunctions Lra List Arith Lia ZArith.
From Circumspect Require Import FlatRefutation.
From Circumspect Require Import Definitions Flats Vectors Affine Frame Faces Independence
  Integers RefutationSigns.
From Circumspect Require MeshAloneSound.
Import ListNotations.
Open Scope R_scope.

Section Dimension.
Context {d : nat}.

Lemma sums_exchanged {A B} (l : list A) (m : list B) (c : A -> R) (b : B -> A -> R) (f : B -> R) :
  sum_over l (fun j => c j * sum_over m (fun i => b i j * f i)) =
  sum_over m (fun i => f i * sum_over l (fun j => c j * b i j)).
Proof.
  induction m as [|i m IH]; cbn [sum_over].
  - apply sum_zero. intros; ring.
  - rewrite <- IH, <- sum_scale, <- sum_plus. apply sum_ext. intros; ring.
Qed.

Theorem dimension_shown (t : frame d) k (S : list (point d)) : (k <= d)%nat ->
  (forall i, (i <= k)%nat -> In (vertex t i) S) ->
  (forall p i, In p S -> (k < i <= d)%nat -> bary t i p = 0) -> of_dimension k S.
Proof.
  intros K V Z. split.
  - exists (map (vertex t) (seq 0 (Datatypes.S k))). split; [|split].
    + intros p I. apply in_map_iff in I. destruct I as (i & <- & Hi). apply in_seq in Hi.
      apply V. lia.
    + now rewrite map_length, seq_length.
    + apply (face_independent t).
      * intros p I. apply in_map_iff in I. destruct I as (i & <- & Hi). apply in_seq in Hi.
        apply in_vertices. exists i. split; [lia|reflexivity].
      * pose proof (vertices_NoDup t) as N. unfold vertices in N.
        replace (Datatypes.S d) with (Datatypes.S k + (d - k))%nat in N by lia.
        rewrite seq_app, map_app in N. now apply MeshAloneSound.NoDup_front in N.
  - intros X I Ind. destruct (le_lt_dec (length X) (Datatypes.S k)) as [|L]; [assumption|exfalso].
    destruct (dual_functions X Ind) as (g & D).
    destruct (solution (map (fun i j => bary t i (nth j X origin)) (seq 0 (Datatypes.S k)))
      (seq 0 (length X))) as (c & (j & Hj & N) & C);
      [apply seq_NoDup|now rewrite map_length, !seq_length|].
    apply in_seq in Hj. destruct (D j ltac:(lia)) as [A E].
    assert (Sum : sum_over (seq 0 (length X)) (fun n => c n * g j (nth n X origin)) = 0).
    { rewrite (sum_ext _ _ (fun n => c n * sum_over (seq 0 (Datatypes.S k)) (fun i =>
        bary t i (nth n X origin) * g j (vertex t i)))).
      - rewrite sums_exchanged. apply sum_zero. intros i Hi.
        rewrite (C (fun n => bary t i (nth n X origin))); [ring|].
        apply (in_map (fun i n => bary t i (nth n X origin))). assumption.
      - intros n Hn. apply in_seq in Hn. f_equal. rewrite (interpolation t (g j) _ A). unfold sum.
        replace (Datatypes.S d) with (Datatypes.S k + (d - k))%nat by lia.
        rewrite seq_app, sum_app, (sum_zero (seq (0 + Datatypes.S k) _)); [ring|].
        intros i Hi. apply in_seq in Hi. rewrite Z; [ring|apply I, nth_In; lia|lia]. }
    rewrite (sum_one _ _ j) in Sum; [|apply seq_NoDup|apply in_seq; lia|].
    + rewrite E in Sum by lia. destruct (Nat.eq_dec j j); [|congruence]. lra.
    + intros n Hn Nn. apply in_seq in Hn. rewrite E by lia.
      destruct (Nat.eq_dec j n); [congruence|ring].
Qed.
Lemma dimension_once k l (S : list (point d)) : of_dimension k S -> of_dimension l S -> k = l.
Proof.
  intros [(X & IX & LX & NX) UX] [(Y & IY & LY & NY) UY].
  pose proof (UX Y IY NY). pose proof (UY X IX NX). lia.
Qed.
End Dimension.

(** The same with the integers of the checkers. *)
Section Shown.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates} {r : R}.
Hypothesis M : measured orient pr r.
Notation place := (@place_of d r).

Lemma sign_zero X (t : frame d) i s : framed orient pr r X t -> (i <= d)%nat -> well_shaped d s ->
  coordinate_sign pr X s 1 i = 0%Z -> bary t i (place s) = 0.
Proof.
  intros F Hi Hs E. pose proof (coordinate_sign_bary M X t F s 1 i Hi Hs eq_refl) as B.
  rewrite E, (place_over_one (r := r)) in B. pose proof (square_positive X t F) as P. nra.
Qed.

Lemma dimension_signs B pads (t : frame d) (P : list site) : framed orient pr r (B ++ pads) t ->
  B <> [] -> (length B <= Datatypes.S d)%nat -> incl B P -> Forall (well_shaped d) P ->
  (forall s i, In s P -> (length B <= i <= d)%nat -> coordinate_sign pr (B ++ pads) s 1 i = 0%Z) ->
  of_dimension (pred (length B)) (map place P).
Proof.
  intros F Ne L I Sh Z. assert (0 < length B)%nat by (destruct B; [easy|cbn; lia]).
  apply (dimension_shown t); [lia| |].
  - intros i Hi. destruct (nth_error B i) as [s|] eqn:E; [|apply nth_error_None in E; lia].
    assert (E' : nth_error (B ++ pads) i = Some s) by (rewrite nth_error_app1 by lia; assumption).
    destruct (framed_vertex (B ++ pads) t F i s E') as [_ ->]. apply in_map, I.
    now apply nth_error_In in E.
  - intros p i Ip Hi. apply in_map_iff in Ip. destruct Ip as (s & <- & Is).
    rewrite Forall_forall in Sh. apply (sign_zero (B ++ pads)); auto; [lia|].
    apply Z; [assumption|lia].
Qed.
End Shown.
