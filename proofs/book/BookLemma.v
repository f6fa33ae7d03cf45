(** * Lemma 4.1, the Delaunay Lemma, for every triangulation

    A triangulation, by its definition, is a matched mesh ([Adjacency.v]); a facet that is locally
    Delaunay gives the local condition across it ([locally_witnessed_above]); and then nothing is
    below a witness plane ([DelaunayLemma.v]).  The other directions are easy: a circumball of a
    simplex is one of its faces, and an empty ball contains no vertex of two simplices.

    Again heights first.  A point that is not a vertex has to be accounted for: it is not below the
    plane of a simplex that it is in.  Vertices are. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Matched Generic Mesh Facets.
From Circumspect Require Import Adjacency LiftingMap DelaunayLemma.
Import ListNotations.
Open Scope R_scope.

(** ** One facet between two simplices *)
Section Facet.
Context {d : nat} (h : point d -> R).
Implicit Types (t u : frame d).

(** Some plane contains the lifted facet and has no lifted vertex of the two below it ... *)
Definition plane_between t i u : Prop := exists a b,
  (forall v, In v (facet_of t i) -> plane a b v = h v) /\
  forall v, In v (vertices t) \/ In v (vertices u) -> plane a b v <= h v.

(** ... if and only if the apex of u is not below the witness plane of t.  (Section 4.2:
    "Equivalently, the open circumball of t contains no vertex of u.") *)
Theorem locally_witnessed_above t i u j : opposite t i u j ->
  (plane_between t i u <-> locally_above h t u j).
Proof.
  intros O. pose proof O as (Hi & Hj & _ & UT & N). split.
  - intros (a & b & On & Low). unfold locally_above.
    pose proof (above_witness h t (plane a b) (vertex u j) (affine_plane a b)) as E.
    unfold sum in E. rewrite (sum_one _ _ i) in E.
    + assert (plane a b (vertex t i) <= h (vertex t i)).
      { apply Low. left. apply in_vertices. eauto. }
      assert (plane a b (vertex u j) <= h (vertex u j)).
      { apply Low. right. apply in_vertices. eauto. }
      nra.
    + apply seq_NoDup.
    + now apply in_seq_d.
    + intros k Hk Nk. apply in_seq_d in Hk. rewrite On; [ring|]. apply in_facet_of; eauto.
  - intros L. destruct (witness_affine h t) as (a & b & E). exists a, b.
    assert (V : forall k, (k <= d)%nat -> plane a b (vertex t k) = h (vertex t k)).
    { intros k Hk. rewrite <- E. now apply witness_vertex. }
    split.
    + intros v Hv. apply in_facet_of in Hv; [|assumption]. destruct Hv as (k & Hk & _ & ->). auto.
    + intros v [Hv|Hv]; apply in_vertices in Hv; destruct Hv as (l & Hl & ->).
      * rewrite V by assumption. lra.
      * destruct (Nat.eq_dec l j) as [->|Nl]; [rewrite <- E; exact L|].
        destruct (UT l Hl Nl) as (k & Hk & _ & ->). rewrite V by assumption. lra.
Qed.

Lemma opposite_different t i u j : opposite t i u j -> ~ same (vertices t) (vertices u).
Proof.
  intros (Hi & Hj & _ & _ & N) [_ UT].
  assert (In (vertex u j) (vertices t)) as V by (apply UT, in_vertices; eauto).
  apply in_vertices in V. destruct V as (k & Hk & E). rewrite E, bary_vertex in N by assumption.
  destruct (Nat.eq_dec i k); lra.
Qed.
End Facet.

Section BookLemma.
Context {d : nat}.
Hypothesis positive : (1 <= d)%nat.
Implicit Types (p q v : point d) (h : point d -> R) (S : list (point d)) (s t f : simplex d)
  (T : list (simplex d)).

(** A facet is locally witnessed if it is a face of fewer than two d-simplices, or has a plane
    that no lifted vertex of the two is below. *)
Definition locally_witnessed h T f : Prop :=
  forall s t, In s T -> In t T -> incl f s -> incl f t -> ~ same s t ->
    witness_plane h (s ++ t) f.

Lemma locally_delaunay_witnessed T f : locally_delaunay T f <-> locally_witnessed norm2 T f.
Proof.
  assert (E : forall s t, (exists c r2, circumball f c r2 /\
      forall v, In v s \/ In v t -> ~ dist2 c v < r2) <-> witness_plane norm2 (s ++ t) f).
  { intros s t. rewrite <- delaunay_witness_plane.
    split; intros (c & r2 & C & B); exists c, r2; (split; [assumption|]); intros v Hv; apply B;
      now apply in_app_iff. }
  split; intros H s t Hs Ht Is It N; apply E; now apply (H s t).
Qed.

(** The point p is in a simplex and not below its plane. *)
Definition carried h T p : Prop := exists t, In t T /\ conv t p /\ witness_plane h [p] t.

Theorem delaunay_lemma_heights h S T : fills S T -> (forall p, In p S -> carried h T p) ->
  ((forall t, In t T -> witness_plane h S t) <-> (forall f, facet T f -> witness_plane h S f)) /\
  ((forall t, In t T -> witness_plane h S t) <-> (forall f, facet T f -> locally_witnessed h T f)).
Proof.
  intros F Carried. pose proof F as (_ & _ & _ & V & _).
  assert (One : (forall t, In t T -> witness_plane h S t) ->
    forall f, facet T f -> witness_plane h S f).
  { intros W f (_ & _ & t & Ht & I). apply (witness_plane_face h S t); auto. }
  assert (Two : (forall f, facet T f -> witness_plane h S f) ->
    forall f, facet T f -> locally_witnessed h T f).
  { intros W f Hf s t Hs Ht _ _ _. destruct (W f Hf) as (a & b & O & B). exists a, b.
    split; [assumption|]. intros p Hp. apply B. apply in_app_or in Hp.
    destruct Hp; [now apply (V s)|now apply (V t)]. }
  assert (Three : (forall f, facet T f -> locally_witnessed h T f) ->
    forall t, In t T -> witness_plane h S t).
  { intros L t Ht. assert (Ne : T <> []) by (now intros ->).
    destruct (triangulation_matched S T positive F Ne) as (geo & G & M & Sup & Once).
    set (tets := seq 0 (length T)) in *.
    assert (Idx : forall k, In k tets -> (k < length T)%nat).
    { intros k Hk. apply in_seq in Hk. lia. }
    assert (Mem : forall k, In k tets -> In (vertices (geo k)) T).
    { intros k Hk. rewrite G by auto. apply nth_In. auto. }
    assert (Name : forall s, In s T -> exists k, In k tets /\ vertices (geo k) = s).
    { intros s Hs. destruct (In_nth T s [] Hs) as (k & Hk & E). exists k.
      split; [apply in_seq; lia|]. now rewrite G. }
    assert (Vin : forall k i, In k tets -> (i <= d)%nat -> In (vertex (geo k) i) S).
    { intros k i Hk Hi. apply (V _ (Mem k Hk)), in_vertices. eauto. }
    destruct (Name t Ht) as (k & Hk & <-).
    apply (mesh_witness_plane M Vin Sup Nat.eq_dec (Once k (barycentre (geo k)) Hk
      (barycentre_inside (geo k)))); [| |assumption].
    - intros a i b j Ha (_ & Hb & O). apply (locally_witnessed_above h (geo a) i); [assumption|].
      assert (Hi : (i <= d)%nat) by apply O.
      destruct (L (facet_of (geo a) i)) with (s := vertices (geo a)) (t := vertices (geo b))
        as (x & y & On & Low); auto.
      + split; [now apply facet_of_NoDup|]. split; [now apply facet_of_length|].
        exists (vertices (geo a)). split; [auto|now apply facet_of_incl].
      + now apply facet_of_incl.
      + apply opposite_facets in O. destruct O as (_ & Hj & [I _] & _).
        apply incl_tran with (facet_of (geo b) j); [assumption|now apply facet_of_incl].
      + now apply (opposite_different (geo a) i (geo b) j).
      + exists x, y. split; [assumption|]. intros v Hv. apply Low. now apply in_or_app.
    - intros p Hp. right. destruct (Carried p Hp) as (s & Hs & C & W).
      destruct (Name s Hs) as (u & Hu & <-). exists u. split; [assumption|].
      split; [now apply conv_vertices|].
      apply (proj1 (witness_plane_witness h [p] (geo u)) W). now left. }
  split; split; auto.
Qed.

(** Vertices are carried; and if all simplices have witness planes, everything is. *)
Lemma vertices_carried h S T : triangulation S T -> forall p, In p S -> carried h T p.
Proof.
  intros [F All] p Hp. destruct (All p Hp) as (t & Ht & I). exists t. split; [assumption|].
  split; [now apply conv_point|]. destruct (fills_frame S T t F Ht) as (u & <-).
  apply witness_plane_witness. intros q [<-|[]]. apply in_vertices in I.
  destruct I as (i & Hi & ->). rewrite witness_vertex by assumption. lra.
Qed.
Lemma witnessed_carried h S T : fills S T -> (forall t, In t T -> witness_plane h S t) ->
  forall p, In p S -> carried h T p.
Proof.
  intros (_ & _ & _ & _ & U) W p Hp. destruct (proj1 (U p) (conv_point S p Hp)) as (t & Ht & C).
  exists t. split; [assumption|]. split; [assumption|]. destruct (W t Ht) as (a & b & O & B).
  exists a, b. split; [assumption|]. intros q [<-|[]]. auto.
Qed.

(** ** Lemma 4.1 (Delaunay Lemma) *)

(** Let T be a triangulation of S.  Every d-simplex is Delaunay if and only if every facet is
    Delaunay, and if and only if every facet is locally Delaunay. *)
Theorem lemma_4_1 S T : triangulation S T ->
  ((forall t, In t T -> delaunay S t) <-> (forall f, facet T f -> delaunay S f)) /\
  ((forall t, In t T -> delaunay S t) <-> (forall f, facet T f -> locally_delaunay T f)).
Proof.
  intros H.
  destruct (delaunay_lemma_heights norm2 S T (proj1 H) (vertices_carried norm2 S T H)) as [A B].
  assert (E1 : (forall t, In t T -> delaunay S t) <->
               (forall t, In t T -> witness_plane norm2 S t)).
  { split; intros K t Ht; apply delaunay_witness_plane; auto. }
  assert (E2 : (forall f, facet T f -> delaunay S f) <->
               (forall f, facet T f -> witness_plane norm2 S f)).
  { split; intros K t Ht; apply delaunay_witness_plane; auto. }
  assert (E3 : (forall f, facet T f -> locally_delaunay T f) <->
               (forall f, facet T f -> locally_witnessed norm2 T f)).
  { split; intros K t Ht; apply locally_delaunay_witnessed; auto. }
  rewrite E1, E2, E3. now split.
Qed.
Corollary delaunay_triangulation_local S T : delaunay_triangulation S T <->
  triangulation S T /\ forall f, facet T f -> locally_delaunay T f.
Proof. split; intros [H D]; (split; [assumption|]); now apply (lemma_4_1 S T H). Qed.

(** For weighted points: T is a weighted Delaunay triangulation of S if and only if it fills
    conv S, every facet is locally witnessed, and every submerged point is on or above the witness
    plane of a simplex that it is in. *)
Corollary weighted_delaunay_triangulation_local (w : point d -> R) S T :
  weighted_delaunay_triangulation w S T <->
  fills S T /\ (forall p, In p S -> carried (fun p => norm2 p - w p) T p) /\
  forall f, facet T f -> locally_witnessed (fun p => norm2 p - w p) T f.
Proof.
  split.
  - intros [F W]. split; [assumption|].
    pose proof (witnessed_carried (fun p => norm2 p - w p) S T F W) as C. split; [assumption|].
    now apply (delaunay_lemma_heights _ S T F C).
  - intros (F & C & L). split; [assumption|]. now apply (delaunay_lemma_heights _ S T F C).
Qed.
End BookLemma.
