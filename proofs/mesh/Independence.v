(** * Independence: d+1 affinely independent points of R^d have a frame

    Dual affine functions are found one point at a time: subtract from an affine function the
    function that has the same values at the points before, and what remains vanishes at them
    ([dual_functions]).  They interpolate every affine function because an affine function that
    vanishes at d+1 affinely independent points vanishes everywhere: a point where it does not
    would make d+2 points without an affine dependency, but d+1 linear equations in d+2 unknowns
    always have a solution that is not zero ([dependency]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Coq Require Vector.
From Circumspect Require Import Definitions Vectors Affine Frame Faces.
Import ListNotations.
Open Scope R_scope.

(** ** More unknowns than equations *)

Lemma sum_app {A} (l m : list A) (f : A -> R) : sum_over (l ++ m) f = sum_over l f + sum_over m f.
Proof. induction l as [|a l IH]; cbn; [ring|]. rewrite IH. ring. Qed.

Lemma zero_or_not {A} (l : list A) (f : A -> R) :
  {k | In k l /\ f k <> 0} + {forall i, In i l -> f i = 0}.
Proof.
  induction l as [|a l IH]; [right; intros i []|].
  destruct (Req_EM_T (f a) 0) as [E|N].
  - destruct IH as [(k & Hk & Nk)|Z]; [left; exists k; split; [now right|assumption]|].
    right. intros i [<-|Hi]; auto.
  - left. exists a. split; [now left|assumption].
Qed.

(** The unknowns are named by the members of [l], the equations are sum over i of c(i) f(i) = 0
    for f in [F]. *)
Lemma solution (F : list (nat -> R)) : forall l : list nat, NoDup l -> (length F < length l)%nat ->
  exists c, (exists k, In k l /\ c k <> 0) /\
    forall f, In f F -> sum_over l (fun i => c i * f i) = 0.
Proof.
  assert (G : forall n F, length F = n -> forall l : list nat, NoDup l -> (n < length l)%nat ->
    exists c, (exists k, In k l /\ c k <> 0) /\
      forall f, In f F -> sum_over l (fun i => c i * f i) = 0).
  2: { intros l N L. now apply (G (length F)). }
  clear F. induction n as [|n IH]; intros F LF l N L.
  - destruct F; [|discriminate]. exists (fun _ => 1). split; [|intros f []].
    destruct l as [|k l]; [cbn in L; lia|]. exists k. split; [now left|lra].
  - destruct F as [|f F]; [discriminate|]. injection LF as LF.
    destruct (zero_or_not l f) as [(k & Hk & Nk)|Z].
    + (* eliminate the unknown k *)
      destruct (in_split k l Hk) as (l1 & l2 & ->).
      destruct (IH (map (fun g i => g i - g k / f k * f i) F)) with (l := l1 ++ l2)
        as (c & (m & Hm & Nm) & C).
      * now rewrite map_length.
      * now apply NoDup_remove_1 in N.
      * rewrite app_length in *. cbn in L. lia.
      * apply NoDup_remove_2 in N.
        set (ck := - sum_over (l1 ++ l2) (fun i => c i * f i) / f k).
        set (c' i := if Nat.eq_dec i k then ck else c i).
        assert (E : forall g : nat -> R, sum_over (l1 ++ k :: l2) (fun i => c' i * g i) =
          ck * g k + sum_over (l1 ++ l2) (fun i => c i * g i)).
        { intros g. rewrite !sum_app. cbn [sum_over].
          rewrite (sum_ext l1 (fun i => c' i * g i) (fun i => c i * g i)),
            (sum_ext l2 (fun i => c' i * g i) (fun i => c i * g i)).
          - unfold c' at 1. destruct (Nat.eq_dec k k); [ring|congruence].
          - intros i Hi. unfold c'. destruct (Nat.eq_dec i k) as [->|]; [|reflexivity].
            exfalso. apply N, in_or_app. now right.
          - intros i Hi. unfold c'. destruct (Nat.eq_dec i k) as [->|]; [|reflexivity].
            exfalso. apply N, in_or_app. now left. }
        exists c'. split.
        { exists m. split; [apply in_or_app; apply in_app_or in Hm; cbn; tauto|].
          unfold c'. destruct (Nat.eq_dec m k) as [->|]; [contradiction|assumption]. }
        intros g [<-|Hg]; rewrite E; [unfold ck; field; assumption|].
        pose proof (C _ (in_map _ F g Hg)) as Cg. cbn beta in Cg.
        rewrite (sum_ext _ _ (fun i => c i * g i + - (g k / f k) * (c i * f i))) in Cg
          by (intros; ring).
        rewrite sum_plus, sum_scale in Cg. unfold ck.
        transitivity (sum_over (l1 ++ l2) (fun i => c i * g i) +
          - (g k / f k) * sum_over (l1 ++ l2) (fun i => c i * f i)); [field; assumption|exact Cg].
    + (* an equation without unknowns *)
      destruct (IH F LF l N) as (c & K & C); [lia|]. exists c. split; [assumption|].
      intros g [<-|Hg]; [|auto]. apply sum_zero. intros i Hi. rewrite Z by assumption. ring.
Qed.

(** The d coordinates of a point. *)
Fixpoint coordinates (d : nat) : list (point d -> R) :=
  match d with
  | O => []
  | S n => (fun p => Vector.hd p) :: map (fun f p => f (Vector.tl p)) (coordinates n)
  end.
Lemma coordinates_length d : length (coordinates d) = d.
Proof.
  induction d as [|d IH]; [reflexivity|]. cbn [coordinates length]. rewrite map_length.
  now f_equal.
Qed.
Lemma coordinates_inner {d} (l : list nat) (c : nat -> R) :
  forall (x : nat -> point d) (a : point d),
  (forall f, In f (coordinates d) -> sum_over l (fun i => c i * f (x i)) = 0) ->
  sum_over l (fun i => c i * inner a (x i)) = 0.
Proof.
  induction d as [|d IH]; intros x a H.
  - apply sum_zero. intros i _. pattern a. apply Vector.case0. pattern (x i). apply Vector.case0.
    cbn. ring.
  - pattern a. apply Vector.caseS'. intros b a'.
    rewrite (sum_ext _ _ (fun i => b * (c i * Vector.hd (x i)) + c i * inner a' (Vector.tl (x i)))).
    + rewrite sum_plus, sum_scale, (IH (fun i => Vector.tl (x i))).
      * rewrite (H (fun p => Vector.hd p)); [ring|now left].
      * intros f Hf. apply (H (fun p => f (Vector.tl p))). right.
        now apply (in_map (fun f p => f (Vector.tl p))).
    + intros i _. pattern (x i). apply Vector.caseS'. intros y z. unfold inner. cbn. ring.
Qed.

Section Independence.
Context {d : nat}.
Implicit Types (p q : point d) (X : list (point d)).

(** d+2 points have an affine dependency. *)
Lemma dependency (x : nat -> point d) (l : list nat) : NoDup l -> (S d < length l)%nat ->
  exists c, (exists k, In k l /\ c k <> 0) /\
    forall f, affine f -> sum_over l (fun i => c i * f (x i)) = 0.
Proof.
  intros N L.
  destruct (solution ((fun _ => 1) :: map (fun f i => f (x i)) (coordinates d)) l N) as (c & K & C).
  - cbn [length]. now rewrite map_length, coordinates_length.
  - exists c. split; [assumption|]. intros f (a & b & F).
    rewrite (sum_ext _ _ (fun i => c i * inner a (x i) + b * (c i * 1))).
    + rewrite sum_plus, sum_scale, (C (fun _ => 1)) by now left.
      rewrite (coordinates_inner l c x a); [ring|]. intros g Hg.
      apply (C (fun i => g (x i))). right. now apply (in_map (fun f i => f (x i))).
    + intros i _. rewrite F. unfold plane. ring.
Qed.

Lemma independent_tail p X : affinely_independent (p :: X) -> affinely_independent X.
Proof.
  intros I a L T C c Hc. apply (I (0 :: a)); [cbn; now rewrite L | | |now right].
  - cbn [combine]. rewrite total_cons, T. ring.
  - cbn [combine]. rewrite combination_cons, C, scale_zero. apply plus_origin.
Qed.

(** [g] are dual to [X]: function i is 1 at point i and 0 at the others. *)
Definition dual X (g : nat -> point d -> R) : Prop := forall i, (i < length X)%nat ->
  affine (g i) /\ forall k, (k < length X)%nat ->
    g i (nth k X origin) = if Nat.eq_dec i k then 1 else 0.

(** The affine function with the same values as [h] at the points of [X]. *)
Definition interpolant X (g : nat -> point d -> R) (h : point d -> R) p :=
  sum (length X) (fun i => g i p * h (nth i X origin)).
Lemma interpolant_affine X g h : dual X g -> affine (interpolant X g h).
Proof.
  intros D. unfold interpolant, sum. apply affine_sum. intros i Hi. apply in_seq in Hi.
  apply affine_ext with (fun p => h (nth i X origin) * g i p); [intros; ring|].
  apply affine_scale. apply D. lia.
Qed.
Lemma interpolant_at X g h k : dual X g -> (k < length X)%nat ->
  interpolant X g h (nth k X origin) = h (nth k X origin).
Proof.
  intros D Hk. unfold interpolant, sum. rewrite (sum_one _ _ k).
  - destruct (D k Hk) as [_ E]. rewrite E by assumption.
    destruct (Nat.eq_dec k k); [ring|congruence].
  - apply seq_NoDup.
  - apply in_seq. lia.
  - intros i Hi N. apply in_seq in Hi. destruct (D i) as [_ E]; [lia|]. rewrite E by assumption.
    destruct (Nat.eq_dec i k); [congruence|ring].
Qed.

(** If every affine function were interpolated at p, then p would depend on [X]. *)
Lemma not_interpolated p X g : affinely_independent (p :: X) -> dual X g ->
  exists h, affine h /\ h p - interpolant X g h p <> 0.
Proof.
  intros I D.
  destruct (Req_dec (1 - interpolant X g (fun _ => 1) p) 0) as [One|N];
    [|exists (fun _ => 1); split; [apply affine_const|assumption]].
  set (a := map (fun i => g i p) (seq 0 (length X))).
  assert (AX : combine a X = map (fun k => (g k p, nth k X origin)) (seq 0 (length X)))
    by apply combine_positions.
  assert (One' : sum_over (seq 0 (length X)) (fun i => g i p) = 1).
  { unfold interpolant, sum in One. rewrite (sum_ext _ _ (fun i => g i p * 1)) by (intros; ring).
    lra. }
  assert (T : total (combine a X) = 1) by now rewrite AX, total_map.
  assert (E : forall h, affine h -> h (combination (combine a X)) = interpolant X g h p).
  { intros h H. rewrite AX. now rewrite affine_combination_map by assumption. }
  destruct (point_eq_dec p (combination (combine a X))) as [P|N].
  - exfalso. assert (-1 = 0); [|lra]. apply (I (-1 :: a)).
    + cbn. unfold a. now rewrite map_length, seq_length.
    + cbn [combine]. rewrite total_cons, T. ring.
    + cbn [combine]. rewrite combination_cons, <- P.
      rewrite <- (scale_one p) at 2. rewrite <- plus_scale.
      replace (-1 + 1) with 0 by lra. apply scale_zero.
    + now left.
  - set (q := combination (combine a X)) in *. exists (plane (minus p q) 0).
    split; [apply affine_plane|]. rewrite <- E by apply affine_plane. intros Z. apply N.
    unfold plane in Z.
    assert (Z' : norm2 (minus p q) = 0) by (unfold norm2; rewrite inner_minus_r; lra).
    apply norm2_zero in Z'. rewrite <- (minus_plus p q), Z'. apply origin_plus.
Qed.

Theorem dual_functions X : affinely_independent X -> exists g, dual X g.
Proof.
  induction X as [|p X IH]; intros I.
  - exists (fun _ _ => 0). intros i Hi. cbn in Hi. lia.
  - destruct (IH (independent_tail p X I)) as (g & D).
    destruct (not_interpolated p X g I D) as (h & H & N).
    set (r := h p - interpolant X g h p) in *.
    set (g0 q := / r * (h q - interpolant X g h q)).
    assert (A0 : affine g0).
    { unfold g0. apply affine_scale.
      apply affine_ext with (fun q => 1 * h q + -1 * interpolant X g h q); [intros; ring|].
      apply affine_combine; [assumption|now apply interpolant_affine]. }
    assert (P0 : g0 p = 1) by (unfold g0; fold r; field; assumption).
    assert (X0 : forall k, (k < length X)%nat -> g0 (nth k X origin) = 0).
    { intros k Hk. unfold g0. rewrite interpolant_at by assumption. ring. }
    exists (fun i q => match i with O => g0 q | S j => g j q - g j p * g0 q end).
    intros [|j] Hj; cbn [length] in Hj.
    + split; [assumption|]. intros [|k] Hk; cbn [nth length] in *.
      * destruct (Nat.eq_dec 0 0); [assumption|congruence].
      * rewrite X0 by lia. now destruct (Nat.eq_dec 0 (S k)).
    + destruct (D j) as [Aj Ej]; [lia|]. split.
      * apply affine_ext with (fun q => 1 * g j q + - g j p * g0 q); [intros; ring|].
        now apply affine_combine.
      * intros [|k] Hk; cbn [nth length] in *.
        -- rewrite P0. destruct (Nat.eq_dec (S j) 0); [discriminate|ring].
        -- rewrite X0, Ej by lia.
           destruct (Nat.eq_dec j k), (Nat.eq_dec (S j) (S k)); try lia; ring.
Qed.

(** An affine function that vanishes at d+1 affinely independent points is zero. *)
Lemma vanishes X g f p : length X = S d -> dual X g -> affine f ->
  (forall i, (i < length X)%nat -> f (nth i X origin) = 0) -> f p = 0.
Proof.
  intros L D F Z. destruct (Req_dec (f p) 0) as [|N]; [assumption|exfalso].
  set (x i := match i with O => p | S k => nth k X origin end).
  destruct (dependency x (seq 0 (S (length X)))) as (c & (k & Hk & Nk) & C).
  { apply seq_NoDup. }
  { rewrite seq_length. lia. }
  apply in_seq in Hk. apply Nk.
  assert (E : forall h, affine h ->
    c 0%nat * h p + sum_over (seq 1 (length X)) (fun i => c i * h (x i)) = 0).
  { intros h H. exact (C h H). }
  assert (C0 : c 0%nat = 0).
  { pose proof (E f F) as E0. rewrite sum_zero in E0.
    - apply (Rmult_eq_reg_r (f p)); [lra|assumption].
    - intros [|i] Hi; apply in_seq in Hi; [lia|]. cbn [x]. rewrite Z by lia. ring. }
  destruct k as [|k]; [assumption|]. destruct (D k) as [Ak Ek]; [lia|].
  pose proof (E (g k) Ak) as Eg. rewrite C0, (sum_one _ _ (S k)) in Eg.
  - cbn [x] in Eg. rewrite Ek in Eg by lia. destruct (Nat.eq_dec k k); [lra|congruence].
  - apply seq_NoDup.
  - apply in_seq. lia.
  - intros [|i] Hi Ni; apply in_seq in Hi; [lia|]. cbn [x]. rewrite Ek by lia.
    destruct (Nat.eq_dec k i); [congruence|ring].
Qed.

(** d+1 affinely independent points of R^d are the vertices of a simplex with a frame. *)
Theorem frame_of X : length X = S d -> affinely_independent X -> exists t : frame d, vertices t = X.
Proof.
  intros L I. destruct (dual_functions X I) as (g & D).
  unshelve eexists (Frame d (fun i => nth i X origin) g _ _ _).
  - intros i Hi. apply D. lia.
  - intros i k Hi Hk. apply D; lia.
  - intros f p F. assert (E : f p - interpolant X g f p = 0).
    { apply (vanishes X g (fun q => f q - interpolant X g f q) p L D).
      - apply affine_ext with (fun q => 1 * f q + -1 * interpolant X g f q); [intros; ring|].
        apply affine_combine; [assumption|now apply interpolant_affine].
      - intros i Hi. rewrite interpolant_at by assumption. ring. }
    unfold interpolant in E. rewrite L in E. lra.
  - unfold vertices. cbn [vertex]. rewrite <- L.
    clear. induction X as [|p X IH]; [reflexivity|]. cbn [length seq map nth]. f_equal.
    rewrite <- seq_shift, map_map. exact IH.
Qed.

(** The barycentric coordinates are determined by the vertices. *)
Lemma bary_unique (t u : frame d) i k : (i <= d)%nat -> (k <= d)%nat ->
  same (vertices t) (vertices u) -> vertex t i = vertex u k -> forall p, bary t i p = bary u k p.
Proof.
  intros Hi Hk [TU UT] E p. rewrite (interpolation u (bary t i) p (bary_affine t i Hi)).
  unfold sum. rewrite (sum_one _ _ k); [|apply seq_NoDup|now apply in_seq_d|].
  - rewrite <- E, bary_own by assumption. ring.
  - intros m Hm N. apply in_seq_d in Hm.
    assert (V : In (vertex u m) (vertices t)) by (apply UT, in_vertices; eauto).
    apply in_vertices in V. destruct V as (j & Hj & Ej). rewrite Ej, bary_other; auto; [ring|].
    intros ->. apply N. apply (vertex_inj u); congruence.
Qed.
End Independence.
