(** * Frames: a d-simplex with its barycentric coordinates

    The proofs know a d-simplex by its d+1 vertices and by d+1 affine functions, the barycentric
    coordinates: coordinate i is 1 at vertex i and 0 at the others, and every affine function is
    interpolated by them from its values at the vertices.  A point is in the simplex if no
    coordinate is negative, in its interior if all are positive. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine.
Import ListNotations.
Open Scope R_scope.

Record frame (d : nat) := Frame {
  vertex : nat -> point d;
  bary : nat -> point d -> R;
  bary_affine : forall i, (i <= d)%nat -> affine (bary i);
  bary_vertex : forall i k, (i <= d)%nat -> (k <= d)%nat ->
    bary i (vertex k) = if Nat.eq_dec i k then 1 else 0;
  interpolation : forall f p, affine f ->
    f p = sum (S d) (fun i => bary i p * f (vertex i))
}.
Arguments vertex {d}. Arguments bary {d}. Arguments bary_affine {d}. Arguments bary_vertex {d}.
Arguments interpolation {d}.

Section Frame.
Context {d : nat}.
Implicit Types (t : frame d) (p q : point d).

Definition vertices t : simplex d := map (vertex t) (seq 0 (S d)).

Definition inside t p : Prop := forall i, (i <= d)%nat -> 0 < bary t i p.
Definition inside_closed t p : Prop := forall i, (i <= d)%nat -> 0 <= bary t i p.

Lemma in_seq_d i : In i (seq 0 (S d)) <-> (i <= d)%nat.
Proof. rewrite in_seq. lia. Qed.
Lemma in_vertices t v : In v (vertices t) <-> exists i, (i <= d)%nat /\ v = vertex t i.
Proof. unfold vertices. rewrite in_map_iff. split.
  - intros (i & <- & Hi). apply in_seq_d in Hi. eauto.
  - intros (i & Hi & ->). exists i. split; [reflexivity|]. now apply in_seq_d. Qed.
Lemma vertices_length t : length (vertices t) = S d.
Proof. unfold vertices. now rewrite map_length, seq_length. Qed.

Lemma bary_own t i : (i <= d)%nat -> bary t i (vertex t i) = 1.
Proof. intros. rewrite bary_vertex by assumption. destruct (Nat.eq_dec i i); congruence. Qed.
Lemma bary_other t i k : (i <= d)%nat -> (k <= d)%nat -> i <> k -> bary t i (vertex t k) = 0.
Proof. intros. rewrite bary_vertex by assumption. destruct (Nat.eq_dec i k); congruence. Qed.
Lemma bary_sum t p : sum (S d) (fun i => bary t i p) = 1.
Proof. pose proof (interpolation t (fun _ => 1) p (affine_const 1)) as E. cbn beta in E.
  rewrite E at 1. apply sum_ext. intros; ring. Qed.

Lemma vertex_inj t i k : (i <= d)%nat -> (k <= d)%nat -> vertex t i = vertex t k -> i = k.
Proof. intros Hi Hk E. pose proof (bary_own t i Hi) as O. rewrite E in O.
  rewrite bary_vertex in O by assumption. destruct (Nat.eq_dec i k); [assumption|lra]. Qed.
Lemma vertices_NoDup t : NoDup (vertices t).
Proof.
  unfold vertices.
  assert (H : forall i, In i (seq 0 (S d)) -> (i <= d)%nat) by (intros; now apply in_seq_d).
  pose proof (seq_NoDup (S d) 0) as N. induction N as [|i l Ni N IH]; cbn; constructor.
  - intros Hi. apply in_map_iff in Hi. destruct Hi as (k & E & Hk). apply Ni.
    apply vertex_inj in E; [now subst | apply H; now right | apply H; now left].
  - apply IH. intros; apply H; now right.
Qed.

(** The sum over the vertices is the value of an affine function, the sum of non-negative terms. *)
Lemma inside_pos t f p : affine f -> inside_closed t p ->
  (forall i, (i <= d)%nat -> 0 <= f (vertex t i)) -> 0 <= f p.
Proof.
  intros A I H. rewrite (interpolation t f p A). apply sum_nonneg. intros i Hi.
  apply in_seq_d in Hi. apply Rmult_le_pos; auto.
Qed.

(** A d-simplex is the convex hull of its vertices. *)
Theorem conv_vertices t q : conv (vertices t) q <-> inside_closed t q.
Proof.
  split.
  - intros C i Hi. apply (affine_conv (bary t i) (vertices t));
      [now apply bary_affine| |assumption].
    intros p Hp. apply in_vertices in Hp. destruct Hp as (k & Hk & ->).
    rewrite bary_vertex by assumption. destruct (Nat.eq_dec i k); lra.
  - intros I. exists (map (fun i => (bary t i q, vertex t i)) (seq 0 (S d))).
    assert (T : total (map (fun i => (bary t i q, vertex t i)) (seq 0 (S d))) = 1).
    { rewrite <- (bary_sum t q). unfold sum. induction (seq 0 (S d)) as [|i l IH]; [reflexivity|].
      cbn [map sum_over]. rewrite total_cons. now rewrite IH. }
    split; [|split; [exact T|]].
    + intros a p Hp. apply in_map_iff in Hp. destruct Hp as (i & E & Hi). injection E as <- <-.
      apply in_seq_d in Hi. split; [now apply I|]. apply in_vertices. eauto.
    + apply affine_separate. intros f A. rewrite (affine_combination f _ A T).
      rewrite (interpolation t f q A). unfold sum.
      clear. induction (seq 0 (S d)) as [|i l IH]; [reflexivity|].
      cbn [map sum_over fst snd]. now rewrite IH.
Qed.

Lemma sum_over_const {A} (l : list A) c : sum_over l (fun _ => c) = INR (length l) * c.
Proof.
  induction l as [|a l IH]; cbn [sum_over length]; [simpl; ring|]. rewrite IH, S_INR. ring.
Qed.

(** A point in the interior: all coordinates are the same. *)
Definition barycentre t : point d :=
  combination (map (fun i => (/ INR (S d), vertex t i)) (seq 0 (S d))).
Lemma bary_barycentre t i : (i <= d)%nat -> bary t i (barycentre t) = / INR (S d).
Proof.
  intros Hi. assert (P : 0 < INR (S d)) by (apply lt_0_INR; lia).
  assert (G : forall l, total (map (fun i => (/ INR (S d), vertex t i)) l) =
                   INR (length l) * / INR (S d)).
  { induction l as [|k l IH]; [simpl; ring|]. cbn [map length].
    rewrite total_cons, IH, (S_INR (length l)).
    ring. }
  unfold barycentre. rewrite affine_combination.
  - rewrite (sum_one _ _ (/ INR (S d), vertex t i)).
    + cbn [fst snd]. rewrite bary_own by assumption. ring.
    + pose proof (vertices_NoDup t) as N. unfold vertices in N.
      apply NoDup_map_inv with (f := snd). rewrite map_map. exact N.
    + apply in_map_iff. exists i. split; [reflexivity|now apply in_seq_d].
    + intros ap H NE. apply in_map_iff in H. destruct H as (k & <- & Hk). apply in_seq_d in Hk.
      cbn [fst snd]. rewrite bary_other; [ring|assumption..|]. now intros ->.
  - now apply bary_affine.
  - rewrite G, seq_length. field. lra.
Qed.
Lemma barycentre_inside t : inside t (barycentre t).
Proof.
  intros i Hi. rewrite bary_barycentre by assumption. apply Rinv_0_lt_compat, lt_0_INR. lia.
Qed.
End Frame.
