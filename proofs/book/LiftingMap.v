(** * The parabolic lifting map  (Book: Sections 2.3 and 4.2)

    The companion of a point p is the point of R^(d+1) above p at the height |p|^2.  A ball with
    centre c and squared radius r2 and the hyperplane <2c, p> + r2 - |c|^2 belong together: p is
    in the ball if and only if its companion is below the hyperplane.  Every hyperplane that is
    not vertical belongs to a ball.  So "Delaunay" means "has a witness plane", and what is proved
    for witness planes over arbitrary heights holds for Delaunay simplices, and for weighted ones.

    With a frame the witness plane of a d-simplex is known: it interpolates the heights of the
    vertices ([witness]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame.
Import ListNotations.
Open Scope R_scope.

Section LiftingMap.
Context {d : nat}.
Implicit Types (p c a : point d) (h w : point d -> R) (S X : list (point d)) (s f : simplex d).

(** The hyperplane that belongs to a ball. *)
Definition ball_plane c (r2 : R) : point d -> R := plane (scale 2 c) (r2 - norm2 c).

(** The height of the companion of p over the hyperplane is the power of p. *)
Lemma ball_plane_power c (r2 : R) p : norm2 p - ball_plane c r2 p = dist2 c p - r2.
Proof. unfold ball_plane, plane. rewrite dist2_expand, inner_scale. ring. Qed.

(** The Lifting Lemma: inside, on or outside is below, on or above. *)
Lemma lifting_lemma c (r2 : R) p :
  (dist2 c p < r2 <-> norm2 p < ball_plane c r2 p) /\
  (dist2 c p = r2 <-> norm2 p = ball_plane c r2 p) /\
  (r2 < dist2 c p <-> ball_plane c r2 p < norm2 p).
Proof. pose proof (ball_plane_power c r2 p). lra. Qed.

(** Every hyperplane that is not vertical belongs to a ball. *)
Lemma plane_ball a b : exists c r2, forall p, ball_plane c r2 p = plane a b p.
Proof.
  exists (scale (1/2) a), (b + norm2 (scale (1/2) a)). intros p. unfold ball_plane, plane.
  rewrite scale_scale. replace (2 * (1/2)) with 1 by lra. rewrite scale_one. ring.
Qed.

(** The ball is a circumball if and only if the hyperplane contains the lifted vertices. *)
Lemma circumball_plane s c (r2 : R) :
  circumball s c r2 <-> forall v, In v s -> ball_plane c r2 v = norm2 v.
Proof.
  split; intros H v Hv; specialize (H v Hv); pose proof (ball_plane_power c r2 v); lra.
Qed.
Lemma cospherical_coplanar X :
  (exists c r2, circumball X c r2) <-> exists a b, forall v, In v X -> plane a b v = norm2 v.
Proof.
  split.
  - intros (c & r2 & H). exists (scale 2 c), (r2 - norm2 c). now apply (circumball_plane X c r2).
  - intros (a & b & H). destruct (plane_ball a b) as (c & r2 & E). exists c, r2.
    apply circumball_plane. intros v Hv. rewrite E. auto.
Qed.

(** A simplex is Delaunay if and only if it has a witness plane over the paraboloid. *)
Theorem delaunay_witness_plane S s : delaunay S s <-> witness_plane norm2 S s.
Proof.
  split.
  - intros (c & r2 & C & E). exists (scale 2 c), (r2 - norm2 c).
    change (plane _ _) with (ball_plane c r2).
    split; [now apply circumball_plane|].
    intros p Hp. specialize (E p Hp). pose proof (ball_plane_power c r2 p). lra.
  - intros (a & b & C & E). destruct (plane_ball a b) as (c & r2 & Eq). exists c, r2. split.
    + apply circumball_plane. intros v Hv. rewrite Eq. auto.
    + intros p Hp. specialize (E p Hp). rewrite <- Eq in E.
      pose proof (ball_plane_power c r2 p). lra.
Qed.

(** A hyperplane through the lifted vertices, strictly below all other lifted points. *)
Definition strong_witness_plane h S s : Prop := exists a b,
  (forall v, In v s -> plane a b v = h v) /\
  (forall p, In p S -> plane a b p <= h p /\ (plane a b p = h p -> In p s)).

Theorem strongly_delaunay_witness_plane S s : incl s S ->
  (strongly_delaunay S s <-> strong_witness_plane norm2 S s).
Proof.
  intros I. split.
  - intros (c & r2 & C & E). exists (scale 2 c), (r2 - norm2 c).
    change (plane _ _) with (ball_plane c r2).
    assert (K : forall v, In v s -> ball_plane c r2 v = norm2 v) by now apply circumball_plane.
    split; [assumption|]. intros p Hp. pose proof (ball_plane_power c r2 p) as P. split.
    + destruct (Rle_lt_dec (dist2 c p) r2) as [L|L]; [|lra].
      rewrite (K p (E p Hp L)). lra.
    + intros Q. apply E; [assumption|lra].
  - intros (a & b & C & E). destruct (plane_ball a b) as (c & r2 & Eq). exists c, r2. split.
    + apply circumball_plane. intros v Hv. rewrite Eq. auto.
    + intros p Hp L. destruct (E p Hp) as [B Q]. rewrite <- Eq in B, Q. apply Q.
      pose proof (ball_plane_power c r2 p). lra.
Qed.
Lemma strong_witness_plane_weak h S s : strong_witness_plane h S s -> witness_plane h S s.
Proof. intros (a & b & C & E). exists a, b. split; [assumption|]. intros p Hp. now apply E. Qed.

(** Faces of simplices with witness planes have them; so faces of Delaunay simplices are. *)
Lemma witness_plane_face h S s f : incl f s -> witness_plane h S s -> witness_plane h S f.
Proof. intros I (a & b & C & E). exists a, b. auto. Qed.
Lemma delaunay_face S s f : incl f s -> delaunay S s -> delaunay S f.
Proof. rewrite !delaunay_witness_plane. apply witness_plane_face. Qed.

Lemma witness_plane_heights h k S s : incl s S -> (forall p, In p S -> h p = k p) ->
  witness_plane h S s -> witness_plane k S s.
Proof.
  intros I H (a & b & C & E). exists a, b. split.
  - intros v Hv. rewrite <- H by now apply I. auto.
  - intros p Hp. rewrite <- H by assumption. auto.
Qed.
(** Without weights, weighted Delaunay simplices are Delaunay simplices. *)
Lemma weighted_delaunay_unweighted S s : weighted_delaunay (fun _ => 0) S s <-> delaunay S s.
Proof.
  rewrite delaunay_witness_plane. unfold weighted_delaunay.
  split; intros (a & b & C & E); exists a, b;
    (split; intros p Hp; [rewrite (C p Hp)|specialize (E p Hp)]; lra).
Qed.

(** ** The witness plane of a simplex with a frame *)

(** It passes through the lifted vertices. *)
Definition witness h (t : frame d) p : R :=
  sum (Datatypes.S d) (fun i => bary t i p * h (vertex t i)).

Lemma witness_affine h t : affine (witness h t).
Proof.
  apply affine_sum. intros i Hi. apply in_seq_d in Hi.
  apply affine_ext with (fun p => h (vertex t i) * bary t i p); [intros; ring|].
  apply affine_scale. now apply bary_affine.
Qed.
Lemma witness_vertex h t i : (i <= d)%nat -> witness h t (vertex t i) = h (vertex t i).
Proof.
  intros Hi. unfold witness, sum. rewrite (sum_one _ _ i).
  - rewrite bary_own by assumption. ring.
  - apply seq_NoDup.
  - now apply in_seq_d.
  - intros k Hk N. apply in_seq_d in Hk. rewrite bary_other by assumption. ring.
Qed.
(** No other affine function does. *)
Lemma witness_unique h t (f : point d -> R) : affine f ->
  (forall i, (i <= d)%nat -> f (vertex t i) = h (vertex t i)) -> forall p, f p = witness h t p.
Proof.
  intros A H p. rewrite (interpolation t f p A). apply sum_ext. intros i Hi.
  rewrite H; [reflexivity|]. now apply in_seq_d.
Qed.

(** How far another affine function is above the witness plane. *)
Lemma above_witness h t (f : point d -> R) p : affine f ->
  f p - witness h t p =
    sum (Datatypes.S d) (fun i => bary t i p * (f (vertex t i) - h (vertex t i))).
Proof.
  intros A. rewrite (interpolation t f p A). unfold witness, sum.
  transitivity (sum_over (seq 0 (Datatypes.S d)) (fun i => bary t i p * f (vertex t i) +
    (-1) * (bary t i p * h (vertex t i)))).
  - rewrite sum_plus, sum_scale. ring.
  - apply sum_ext. intros; ring.
Qed.

(** A simplex has a witness plane if and only if this one has no lifted point below it. *)
Theorem witness_plane_witness h S t :
  witness_plane h S (vertices t) <-> forall p, In p S -> witness h t p <= h p.
Proof.
  split.
  - intros (a & b & C & E) p Hp. rewrite <- (witness_unique h t (plane a b)).
    + now apply E.
    + apply affine_plane.
    + intros i Hi. apply C, in_vertices. eauto.
  - intros H. destruct (witness_affine h t) as (a & b & E). exists a, b. split.
    + intros v Hv. apply in_vertices in Hv. destruct Hv as (i & Hi & ->). rewrite <- E.
      now apply witness_vertex.
    + intros p Hp. rewrite <- E. auto.
Qed.
Corollary delaunay_witness S t :
  delaunay S (vertices t) <-> forall p, In p S -> witness norm2 t p <= norm2 p.
Proof. rewrite delaunay_witness_plane. apply witness_plane_witness. Qed.

(** Every d-simplex has exactly one circumball; it contains the points whose companions are below
    the witness plane. *)
Theorem circumball_frame t : exists c r2, circumball (vertices t) c r2 /\
  forall p, ball_plane c r2 p = witness norm2 t p.
Proof.
  destruct (witness_affine norm2 t) as (a & b & E). destruct (plane_ball a b) as (c & r2 & Eq).
  exists c, r2. assert (K : forall p, ball_plane c r2 p = witness norm2 t p).
  { intros p. now rewrite Eq, E. }
  split; [|assumption]. apply circumball_plane. intros v Hv. rewrite K.
  apply in_vertices in Hv. destruct Hv as (i & Hi & ->). now apply witness_vertex.
Qed.
Theorem in_ball_below_witness t c (r2 : R) p : circumball (vertices t) c r2 ->
  (dist2 c p < r2 <-> norm2 p < witness norm2 t p).
Proof.
  intros C. rewrite <- (witness_unique norm2 t (ball_plane c r2)).
  - apply lifting_lemma.
  - apply affine_plane.
  - intros i Hi. apply circumball_plane with (s := vertices t); [assumption|].
    apply in_vertices. eauto.
Qed.
End LiftingMap.
