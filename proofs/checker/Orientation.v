(** * Orientation in the plane and in space

    The only place where determinants appear.  All that the other proofs need of them is in
    [oriented]: the orientation of a list of d+1 points changes its sign when two points change
    places, and if it is not zero the points have a frame, in which barycentric coordinate i of p
    is the orientation with p in the place of vertex i, divided by the orientation. *)
From Coq Require Import Rbase Rfunctions Lra Lia List.
From Coq Require Vector.
From Circumspect Require Import Checker Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame.
Import ListNotations.
Open Scope R_scope.

Record oriented {d : nat} (orient : list (point d) -> R) : Prop := {
  orient_length : forall X, orient X <> 0 -> length X = S d;
  orient_swap : alternating orient;
  orient_frame : forall X, orient X <> 0 -> exists t : frame d,
    (forall i, (i <= d)%nat -> nth_error X i = Some (vertex t i)) /\
    (forall i p, (i <= d)%nat -> bary t i p = orient (replace i p X) / orient X)
}.

(** To give a frame it is enough to know the coordinates up to a common factor. *)
Lemma frame_from {d : nat} (D : R) (v : nat -> point d) (b : nat -> point d -> R) : D <> 0 ->
  (forall i, (i <= d)%nat -> affine (b i)) ->
  (forall i k, (i <= d)%nat -> (k <= d)%nat -> b i (v k) = if Nat.eq_dec i k then D else 0) ->
  (forall a c p, D * plane a c p = sum (S d) (fun i => b i p * plane a c (v i))) ->
  exists t : frame d, (forall i, vertex t i = v i) /\ (forall i p, bary t i p = b i p / D).
Proof.
  intros N A V I.
  assert (A' : forall i, (i <= d)%nat -> affine (fun p => b i p / D)).
  { intros i Hi. apply affine_ext with (fun p => / D * b i p); [intros; unfold Rdiv; ring|].
    apply affine_scale. auto. }
  assert (V' : forall i k, (i <= d)%nat -> (k <= d)%nat ->
    b i (v k) / D = if Nat.eq_dec i k then 1 else 0).
  { intros i k Hi Hk. rewrite V by assumption. destruct (Nat.eq_dec i k); now field. }
  assert (I' : forall f p, affine f -> f p = sum (S d) (fun i => b i p / D * f (v i))).
  { intros f p (a & c & E). apply Rmult_eq_reg_l with D; [|assumption]. rewrite E, I.
    unfold sum. rewrite <- sum_scale. apply sum_ext. intros i _. rewrite E. now field. }
  now exists (Frame d v (fun i p => b i p / D) A' V' I').
Qed.

(** ** The plane *)

Definition abscissa {d} (p : point (S d)) : R := Vector.hd p.
Definition ordinate {d} (p : point (S (S d))) : R := Vector.hd (Vector.tl p).

Lemma inner2 (p q : point 2) :
  inner p q = abscissa p * abscissa q + ordinate p * ordinate q.
Proof.
  pattern p. apply Vector.caseS'. intros x p'. pattern p'. apply Vector.caseS'. intros y p''.
  pattern q. apply Vector.caseS'. intros u q'. pattern q'. apply Vector.caseS'. intros v q''.
  pattern p''. apply Vector.case0. pattern q''. apply Vector.case0. cbn. ring.
Qed.

(** A polynomial of degree one in the coordinates is an affine function. *)
Lemma affine2 (a b c : R) : @affine 2 (fun p => a * abscissa p + b * ordinate p + c).
Proof.
  exists (Vector.cons _ a _ (Vector.cons _ b _ (Vector.nil _))), c. intros p.
  unfold plane. rewrite inner2. reflexivity.
Qed.

Definition orient2 (X : list (point 2)) : R :=
  match X with
  | [a; b; c] => (abscissa a - abscissa c) * (ordinate b - ordinate c) -
                 (ordinate a - ordinate c) * (abscissa b - abscissa c)
  | _ => 0
  end.

Theorem oriented2 : oriented orient2.
Proof.
  constructor.
  - intros [|a [|b [|c [|e X]]]]; cbn; intros N; try (now destruct N); reflexivity.
  - intros X a b Y. destruct X as [|x [|y [|z X]]], Y as [|u [|v Y]]; cbn; try ring;
      destruct X; cbn; ring.
  - intros [|v0 [|v1 [|v2 [|e X]]]] N; try (now destruct N).
    set (X := [v0; v1; v2]) in *.
    destruct (frame_from (orient2 X) (fun i => nth i X origin) (fun i p => orient2 (replace i p X)))
      as (t & V & B); auto.
    + intros i Hi. destruct i as [|[|[|i]]]; [| | |lia]; cbn.
      * apply affine_ext with (2 := affine2 (ordinate v1 - ordinate v2) (abscissa v2 - abscissa v1)
          (abscissa v1 * ordinate v2 - ordinate v1 * abscissa v2)). intros; ring.
      * apply affine_ext with (2 := affine2 (ordinate v2 - ordinate v0) (abscissa v0 - abscissa v2)
          (abscissa v2 * ordinate v0 - ordinate v2 * abscissa v0)). intros; ring.
      * apply affine_ext with (2 := affine2 (ordinate v0 - ordinate v1) (abscissa v1 - abscissa v0)
          (abscissa v0 * ordinate v1 - ordinate v0 * abscissa v1)). intros; ring.
    + intros i k Hi Hk. destruct i as [|[|[|i]]], k as [|[|[|k]]]; try lia; cbn; ring.
    + intros a c p. unfold plane, sum; cbn. rewrite !inner2. ring.
    + exists t. split.
      * intros i Hi. rewrite V. destruct i as [|[|[|i]]]; [| | |lia]; reflexivity.
      * intros; apply B.
Qed.

(** ** Space *)

Definition height {d} (p : point (S (S (S d)))) : R := Vector.hd (Vector.tl (Vector.tl p)).

Lemma inner_3 (p q : point 3) :
  inner p q = abscissa p * abscissa q + ordinate p * ordinate q + height p * height q.
Proof.
  transitivity (abscissa p * abscissa q + inner (Vector.tl p) (Vector.tl q)).
  - pattern p. apply Vector.caseS'. intros x p'. pattern q. apply Vector.caseS'. reflexivity.
  - rewrite inner2. unfold ordinate, height, abscissa. ring.
Qed.
Lemma affine3 (a b c e : R) :
  @affine 3 (fun p => a * abscissa p + b * ordinate p + c * height p + e).
Proof.
  exists (Vector.cons _ a _ (Vector.cons _ b _ (Vector.cons _ c _ (Vector.nil _)))), e. intros p.
  unfold plane. rewrite inner_3. reflexivity.
Qed.

Definition determinant (a1 a2 a3 b1 b2 b3 c1 c2 c3 : R) : R :=
  a1 * (b2 * c3 - b3 * c2) + a2 * (b3 * c1 - b1 * c3) + a3 * (b1 * c2 - b2 * c1).

Definition orient3 (X : list (point 3)) : R :=
  match X with
  | [a; b; c; d] => determinant
      (abscissa a - abscissa d) (ordinate a - ordinate d) (height a - height d)
      (abscissa b - abscissa d) (ordinate b - ordinate d) (height b - height d)
      (abscissa c - abscissa d) (ordinate c - ordinate d) (height c - height d)
  | _ => 0
  end.

(** The orientation is affine in each point. *)
Lemma orient3_affine i a b c e : (i <= 3)%nat ->
  affine (fun p => orient3 (replace i p [a; b; c; e])).
Proof.
  intros Hi.
  set (f := fun x y z => orient3 (replace i
    (Vector.cons _ x _ (Vector.cons _ y _ (Vector.cons _ z _ (Vector.nil _)))) [a; b; c; e])).
  apply affine_ext with (2 := affine3 (f 1 0 0 - f 0 0 0) (f 0 1 0 - f 0 0 0) (f 0 0 1 - f 0 0 0)
    (f 0 0 0)). intros p.
  unfold f, determinant. destruct i as [|[|[|[|i]]]]; [| | | |lia]; cbn; unfold determinant;
    cbn [abscissa ordinate height Vector.hd Vector.tl Vector.caseS]; cbn; ring.
Qed.

Theorem oriented3 : oriented orient3.
Proof.
  constructor.
  - intros [|a [|b [|c [|e [|f X]]]]]; cbn; intros N; try (now destruct N); reflexivity.
  - intros X a b Y.
    destruct X as [|x [|y [|z X]]], Y as [|u [|v [|w Y]]]; cbn; unfold determinant; try ring;
      destruct X; cbn; unfold determinant; try ring; destruct X; cbn; ring.
  - intros [|v0 [|v1 [|v2 [|v3 [|e X]]]]] N; try (now destruct N).
    set (X := [v0; v1; v2; v3]) in *.
    destruct (frame_from (orient3 X) (fun i => nth i X origin) (fun i p => orient3 (replace i p X)))
      as (t & V & B); auto.
    + intros; now apply orient3_affine.
    + intros i k Hi Hk. destruct i as [|[|[|[|i]]]], k as [|[|[|[|k]]]]; try lia; cbn;
        unfold determinant; ring.
    + intros a c p. unfold plane, sum; cbn. rewrite !inner_3. unfold determinant. ring.
    + exists t. split.
      * intros i Hi. rewrite V. destruct i as [|[|[|[|i]]]]; [| | | |lia]; reflexivity.
      * intros; apply B.
Qed.
