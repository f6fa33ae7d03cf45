(** * The triangulation of points on a line

    Points of a line have a number, how far along it they are; the simplices join neighbours.  These
    are a triangulation, and Delaunay: no point lies between two neighbours, so none is in the ball
    on which they are opposite points. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Flats Vectors Affine Frame Faces Separated.
Import ListNotations.
Open Scope R_scope.

Lemma pairs_by_number {A} (R : A -> A -> Prop) l :
  (forall i j a b, (i < j)%nat -> nth_error l i = Some a -> nth_error l j = Some b -> R a b) ->
  ForallOrdPairs R l.
Proof.
  induction l as [|a l IH]; intros H; constructor.
  - apply Forall_forall. intros b I. apply In_nth_error in I. destruct I as (j & E).
    apply (H 0%nat (S j)); [lia|reflexivity|exact E].
  - apply IH. intros i j x y L Ex Ey. apply (H (S i) (S j)); [lia|exact Ex|exact Ey].
Qed.

Section Mix.
Context {d : nat}.
Implicit Types (p q a b : point d).

Lemma dist2_mix a b u v : dist2 (mix a b u) (mix a b v) = (u - v) * (u - v) * dist2 a b.
Proof.
  rewrite !dist2_expand. unfold mix, norm2.
  repeat rewrite ?inner_plus, ?inner_plus_r, ?inner_scale, ?inner_scale_r. rewrite (inner_comm b a).
  ring.
Qed.
Lemma mix_start a b : mix a b 0 = a.
Proof. apply affine_separate. intros f A. rewrite (affine_mix f a b 0 A). ring. Qed.
Lemma mix_end a b : mix a b 1 = b.
Proof. apply affine_separate. intros f A. rewrite (affine_mix f a b 1 A). ring. Qed.
Lemma conv_pair a b s : 0 <= s <= 1 -> conv [a; b] (mix a b s).
Proof. intros H. apply conv_mix; [apply conv_point; now left|now right; left|assumption]. Qed.
End Mix.

Section Line.
Context {d : nat} (S : list (point d)) (T : list (simplex d)) (x : point d -> R) (a e : point d).
Hypothesis affine_x : affine x.
Hypothesis on_line : forall p, conv S p -> p = mix a e (x p).
Hypothesis increasing : forall i j p q, (i < j)%nat -> nth_error S i = Some p ->
  nth_error S j = Some q -> x p < x q.
Hypothesis several : (2 <= length S)%nat.
(** [p] and [q] are neighbours. *)
Definition neighbours (k : nat) (p q : point d) : Prop :=
  nth_error S k = Some p /\ nth_error S (Datatypes.S k) = Some q.
Hypothesis joined : forall t, In t T ->
  exists k p q, neighbours k p q /\ (t = [p; q] \/ t = [q; p]).
Hypothesis all_joined : forall k p q, neighbours k p q -> exists t, In t T /\ same t [p; q].
Hypothesis once : forall i j s t k p q, nth_error T i = Some s -> nth_error T j = Some t ->
  neighbours k p q -> same s [p; q] -> same t [p; q] -> i = j.

Lemma x_injective p q : conv S p -> conv S q -> x p = x q -> p = q.
Proof. intros P Q E. rewrite (on_line p P), (on_line q Q). now rewrite E. Qed.
Lemma in_line p : In p S -> conv S p.
Proof. apply conv_point. Qed.
Lemma neighbours_in k p q : neighbours k p q -> In p S /\ In q S /\ x p < x q.
Proof.
  intros [P Q]. split; [now apply nth_error_In in P|]. split; [now apply nth_error_In in Q|].
  apply (increasing k (Datatypes.S k)); auto.
Qed.
Lemma pair_same t (p q : point d) : t = [p; q] \/ t = [q; p] -> same t [p; q].
Proof. intros [->| ->]; split; intros v [<-|[<-|[]]]; cbn; auto. Qed.

(** A point between two neighbours, by how far it is between them. *)
Lemma part_way p q r : In p S -> In q S -> conv S r -> x p < x q ->
  r = mix p q ((x r - x p) / (x q - x p)).
Proof.
  intros P Q R L. apply affine_separate. intros f A.
  assert (F : forall v, conv S v -> f v = (1 - x v) * f a + x v * f e).
  { intros v C. rewrite (on_line v C) at 1. now apply affine_mix. }
  rewrite (affine_mix f) by assumption.
  rewrite (F r R), (F p (in_line p P)), (F q (in_line q Q)). field. lra.
Qed.

Lemma pair_independent (p q : point d) : x p <> x q -> affinely_independent [p; q].
Proof.
  intros N. assert (G : forall u v, x u <> x v -> affine (fun r => (x r - x v) / (x u - x v))).
  { intros u v Nu. apply affine_ext with (fun r => / (x u - x v) * x r + (- x v / (x u - x v)) * 1).
    - intros r. field. lra.
    - apply (affine_combine x (fun _ => 1)); [assumption|apply affine_const]. }
  apply dual_independent.
  - constructor; [intros [->|[]]; now apply N|]. constructor; [intros []|constructor].
  - intros v [<-|[<-|[]]].
    + exists (fun r => (x r - x q) / (x p - x q)). split; [now apply G|].
      split; [field; lra|]. intros w [<-|[<-|[]]] W; [congruence|field; lra].
    + exists (fun r => (x r - x p) / (x q - x p)). split; [apply G; congruence|].
      split; [field; lra|]. intros w [<-|[<-|[]]] W; [field; lra|congruence].
Qed.

(** Each simplex joins a point and the next one. *)
Lemma joined_pair t : In t T -> exists k p q, neighbours k p q /\ same t [p; q] /\
  affinely_independent t /\ length t = 2%nat.
Proof.
  intros I. destruct (joined t I) as (k & p & q & N & E). exists k, p, q.
  destruct (neighbours_in k p q N) as (_ & _ & L).
  split; [assumption|]. split; [now apply pair_same|].
  destruct E as [->| ->]; (split; [apply pair_independent; lra|reflexivity]).
Qed.

(** One pair is before the other, and at most the end of one is the start of the other. *)
Lemma before_meet k p q l r u t s y : neighbours k p q -> neighbours l r u -> (k < l)%nat ->
  same s [p; q] -> same t [r; u] -> conv s y -> conv t y ->
  exists f, incl f s /\ incl f t /\ conv f y.
Proof.
  intros N N' L Es Et Cs Ct. destruct (neighbours_in k p q N) as (Ip & Iq & Lp).
  destruct (neighbours_in l r u N') as (Ir & Iu & Lr).
  assert (B : x q <= x r).
  { destruct N as [_ Nq], N' as [Nr _]. destruct (Nat.eq_dec (Datatypes.S k) l) as [<-|D].
    - right. congruence.
    - left. apply (increasing (Datatypes.S k) l); [lia|assumption|assumption]. }
  exists (meet s t). split; [intros v Iv; now apply in_meet in Iv|].
  split; [intros v Iv; now apply in_meet in Iv|].
  apply (parted_meet s t (fun v => -1 * x v + x r * 1)); [| | | |assumption|assumption].
  - apply (affine_combine x (fun _ => 1)); [assumption|apply affine_const].
  - intros v Iv. apply (proj1 Es) in Iv. destruct Iv as [<-|[<-|[]]]; lra.
  - intros v Iv Z. apply (proj1 Es) in Iv. apply (proj2 Et).
    assert (E : v = r); [|subst v; now left].
    destruct Iv as [<-|[<-|[]]]; apply x_injective; auto using in_line; lra.
  - intros v Iv. apply (proj1 Et) in Iv. destruct Iv as [<-|[<-|[]]]; lra.
Qed.

Lemma line_complex : simplicial_complex (faces_of T).
Proof.
  apply complex_of_simplices.
  - intros t I. now destruct (joined_pair t I) as (_ & _ & _ & _ & _ & In_ & _).
  - intros s t y Is It Cs Ct. destruct (joined_pair s Is) as (k & p & q & N & Es & _).
    destruct (joined_pair t It) as (l & r & u & N' & Et & _).
    destruct (Nat.lt_total k l) as [L|[<-|L]].
    + now apply (before_meet k p q l r u t s y).
    + exists s. split; [apply incl_refl|]. split; [|assumption].
      assert (p = r /\ q = u) as [<- <-] by (destruct N, N'; split; congruence).
      apply incl_tran with [p; q]; [apply Es|apply Et].
    + destruct (before_meet l r u k p q s t y) as (f & A & B & C); eauto.
Qed.

(** What is so of all points is so of all that are between them. *)
Lemma first_last i p y : nth_error S i = Some p -> conv S y ->
  (i = 0%nat -> x p <= x y) /\ (Datatypes.S i = length S -> x y <= x p).
Proof.
  intros P C.
  assert (F : forall c, (forall q, In q S -> 0 <= c * x q + - (c * x p) * 1) ->
    0 <= c * x y + - (c * x p) * 1).
  { intros c H. apply (affine_conv (fun v => c * x v + - (c * x p) * 1) S); [|assumption..].
    apply (affine_combine x (fun _ => 1)); [assumption|apply affine_const]. }
  split; intros E.
  - assert (0 <= 1 * x y + - (1 * x p) * 1); [|lra]. apply F. intros q Iq.
    apply In_nth_error in Iq. destruct Iq as (j & Q). destruct (Nat.eq_dec i j) as [<-|D].
    + assert (q = p) as -> by congruence. lra.
    + pose proof (increasing i j p q ltac:(lia) P Q). lra.
  - assert (0 <= -1 * x y + - (-1 * x p) * 1); [|lra]. apply F. intros q Iq.
    apply In_nth_error in Iq. destruct Iq as (j & Q). destruct (Nat.eq_dec i j) as [<-|D].
    + assert (q = p) as -> by congruence. lra.
    + assert (j < length S)%nat by (apply nth_error_Some; congruence).
      pose proof (increasing j i q p ltac:(lia) Q P). lra.
Qed.
Lemma listed_at i : (i < length S)%nat -> exists p, nth_error S i = Some p.
Proof.
  intros H. destruct (nth_error S i) as [p|] eqn:E; [eauto|]. apply nth_error_None in E. lia.
Qed.

(** Two neighbours with a point between them. *)
Lemma neighbours_around y : conv S y -> exists k p q, neighbours k p q /\ x p <= x y <= x q.
Proof.
  intros C. assert (G : forall n, (n < length S)%nat ->
    (exists k p q, neighbours k p q /\ x p <= x y <= x q) \/
    forall p, nth_error S n = Some p -> x p <= x y).
  { induction n as [|n IH]; intros H; [right; intros p P; now apply (first_last 0 p y)|].
    destruct (IH ltac:(lia)) as [D|D]; [now left|].
    destruct (listed_at n ltac:(lia)) as (p & P). destruct (listed_at _ H) as (q & Q).
    destruct (Rle_dec (x y) (x q)) as [L|L].
    - left. exists n, p, q. split; [now split|]. split; [now apply D|assumption].
    - right. intros r R. assert (r = q) as -> by congruence. lra. }
  destruct (listed_at (length S - 2) ltac:(lia)) as (p & P).
  destruct (listed_at (length S - 1) ltac:(lia)) as (q & Q).
  destruct (G (length S - 1)%nat ltac:(lia)) as [D|D]; [assumption|].
  exists (length S - 2)%nat, p, q. split.
  - split; [assumption|]. now replace (Datatypes.S (length S - 2)) with (length S - 1)%nat by lia.
  - split; [|apply (first_last _ q y Q C); lia].
    pose proof (increasing (length S - 2) (length S - 1) p q ltac:(lia) P Q).
    specialize (D q Q). lra.
Qed.

Theorem line_triangulation : flat_triangulation 1 S T.
Proof.
  split; [|split; [|split; [|split; [|split]]]].
  - intros t I. destruct (joined_pair t I) as (_ & _ & _ & _ & _ & In_ & L).
    split; [now apply independent_NoDup|assumption].
  - apply line_complex.
  - apply pairs_by_number. intros i j s t L Es Et Sm.
    destruct (joined_pair s (nth_error_In _ _ Es)) as (k & p & q & N & E & _).
    assert (i = j); [|lia]. apply (once i j s t k p q); auto. destruct Sm as [A B], E as [A' B'].
    split; [now apply incl_tran with s|now apply incl_tran with s].
  - intros t I v Iv. destruct (joined_pair t I) as (k & p & q & N & E & _).
    destruct (neighbours_in k p q N) as (Ip & Iq & _).
    apply (proj1 E) in Iv. destruct Iv as [<-|[<-|[]]]; assumption.
  - intros y. split.
    + intros C. destruct (neighbours_around y C) as (k & p & q & N & B).
      destruct (neighbours_in k p q N) as (Ip & Iq & L).
      destruct (all_joined k p q N) as (t & It & E). exists t. split; [assumption|].
      apply (conv_incl [p; q]); [apply E|]. rewrite (part_way p q y) by assumption.
      apply conv_pair. split.
      * apply Rmult_le_pos; [lra|]. left. apply Rinv_0_lt_compat. lra.
      * apply (Rmult_le_reg_r (x q - x p)); [lra|]. unfold Rdiv.
        rewrite Rmult_assoc, Rinv_l; lra.
    + intros (t & It & C). apply (conv_incl t); [|assumption]. intros v Iv.
      destruct (joined_pair t It) as (k & p & q & N & E & _).
      destruct (neighbours_in k p q N) as (Ip & Iq & _).
      apply (proj1 E) in Iv. destruct Iv as [<-|[<-|[]]]; assumption.
  - intros p I. apply In_nth_error in I. destruct I as (i & P).
    assert (Hi : (i < length S)%nat) by (apply nth_error_Some; congruence).
    assert (K : exists k q r, neighbours k q r /\ (p = q \/ p = r)).
    { destruct (Nat.eq_dec (Datatypes.S i) (length S)) as [L|L].
      - destruct (listed_at (pred i) ltac:(lia)) as (q & Q). exists (pred i), q, p.
        split; [|now right]. split; [assumption|]. now replace (Datatypes.S (pred i)) with i by lia.
      - destruct (listed_at (Datatypes.S i) ltac:(lia)) as (r & R). exists i, p, r.
        split; [now split|now left]. }
    destruct K as (k & q & r & N & E). destruct (all_joined k q r N) as (t & It & [_ Sm]).
    exists t. split; [assumption|]. apply Sm. destruct E as [->| ->]; cbn; auto.
Qed.

Theorem line_delaunay : flat_delaunay_triangulation 1 S T.
Proof.
  split; [apply line_triangulation|]. intros t It.
  destruct (joined_pair t It) as (k & p & q & N & E & _).
  destruct (neighbours_in k p q N) as (Ip & Iq & L).
  exists (mix p q (1 / 2)), (1 / 4 * dist2 p q). split.
  - intros v Iv. apply (proj1 E) in Iv. destruct Iv as [<-|[<-|[]]].
    + rewrite <- (mix_start p q) at 2. rewrite dist2_mix. field.
    + rewrite <- (mix_end p q) at 2. rewrite dist2_mix. field.
  - intros r Ir. rewrite (part_way p q r Ip Iq (in_line r Ir) L), dist2_mix.
    set (s := (x r - x p) / (x q - x p)). pose proof (norm2_nonneg (minus p q)) as D.
    change (0 <= dist2 p q) in D. assert (Out : s <= 0 \/ 1 <= s).
    { apply In_nth_error in Ir. destruct Ir as (i & R). destruct N as [P Q].
      assert (Inv : 0 < / (x q - x p)) by (apply Rinv_0_lt_compat; lra).
      destruct (Nat.lt_total i k) as [H|[->|H]].
      - left. pose proof (increasing i k r p H R P). unfold s, Rdiv. nra.
      - left. assert (r = p) as -> by congruence. unfold s. right. field. lra.
      - right. apply (Rmult_le_reg_r (x q - x p)); [lra|]. unfold s, Rdiv.
        rewrite Rmult_assoc, Rinv_l by lra. destruct (Nat.eq_dec i (Datatypes.S k)) as [->|].
        + assert (r = q) as -> by congruence. lra.
        + pose proof (increasing (Datatypes.S k) i q r ltac:(lia) Q R). lra. }
    assert (1 / 4 <= (1 / 2 - s) * (1 / 2 - s)) by (destruct Out; nra). nra.
Qed.
End Line.
