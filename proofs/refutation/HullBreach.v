(** * What is wrong with a boundary: a point beyond it, or a ridge of three of its facets

    A facet of one simplex only supports all points of a triangulation ([Adjacency.v]), and no three
    such facets share a ridge ([Ridges.v]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Matched Faces Facets Adjacency.
From Circumspect Require Import Cone Ridges Breach.
Import ListNotations.
Open Scope R_scope.

Section HullBreach.
Context {d : nat}.
Implicit Types (S : list (point d)) (T : list (simplex d)) (s f : simplex d).

(** A facet of the boundary is an outer facet of one of the frames. *)
Lemma boundary_outer S T geo s f : framed S T geo -> boundary_facet (map (map Some) T) s f ->
  exists t i, hull_facet (seq 0 (length T)) geo (outer (seq 0 (length T)) geo) t i /\
    vertices (geo t) = s /\ same f (facet_of (geo t) i).
Proof.
  intros [G _ Dif _ _] ((Hs & _) & N & L & I & Only). apply listed_in in Hs.
  destruct (In_nth T s [] Hs) as (t & Ht & E). rewrite <- G in E by assumption.
  destruct (facet_index (geo t) f N L) as (i & Hi & F); [now rewrite E|].
  exists t, i. split; [|now split]. split; [apply in_seq; lia|]. split; [assumption|].
  intros u j (_ & Hu & O). apply opposite_facets in O. destruct O as (_ & Hj & [O _] & Neg).
  pose proof Hu as Hu'. apply in_seq in Hu'.
  assert (u = t) as ->.
  { symmetry. apply Dif; [apply in_seq; lia|assumption|]. rewrite E, (G u) by lia. apply Only.
    - unfold listed. apply in_map, nth_In. lia.
    - rewrite <- G by lia. apply incl_tran with (facet_of (geo t) i); [apply F|].
      apply incl_tran with (1 := O). now apply facet_of_incl. }
  rewrite bary_vertex in Neg by assumption. destruct (Nat.eq_dec i j); lra.
Qed.

(** A plane that is zero on a facet is a multiple of the coordinate of its opposite vertex. *)
Lemma plane_on_facet (t : frame d) i f a b p : (i <= d)%nat -> same f (facet_of t i) ->
  (forall v, In v f -> plane a b v = 0) -> plane a b p = bary t i p * plane a b (vertex t i).
Proof.
  intros Hi [_ F] Z. rewrite (interpolation t (plane a b) p (affine_plane a b)) at 1. unfold sum.
  rewrite (sum_one _ _ i); [reflexivity|apply seq_NoDup|now apply in_seq_d|].
  intros k Hk Nk. apply in_seq_d in Hk. rewrite Z; [ring|]. apply F, in_facet_of; eauto.
Qed.

Variables (S : list (point d)) (L : list (list (option (point d)))).

Theorem hull_not_convex_refutes : hull_not_convex S L -> ~ claims_to_fill S L.
Proof.
  intros (s & f & v & p & B & Hv & Hp & a & b & Z & Pv & Np) (T & -> & F).
  assert (NE : T <> []). { intros ->. destruct B as ((B & _) & _). destruct B. }
  destruct (Nat.eq_dec d 0) as [D|D].
  { assert (E : forall p q : point d, p = q).
    { clear - D. subst d. intros p q. pattern p. apply Vector.case0. pattern q.
      now apply Vector.case0. }
    rewrite (E p v) in Np. lra. }
  destruct (fills_framed S T F NE) as (geo & G).
  destruct (boundary_outer S T geo s f G B) as (t & i & (Ht & Hi & O) & E & Fi).
  destruct G as [_ A Dif V C].
  pose proof (facet_supports (seq 0 (length T)) geo S ltac:(lia) A V C t i Ht Hi O p Hp) as Sup.
  rewrite (plane_on_facet (geo t) i f a b _ Hi Fi Z) in Pv.
  rewrite (plane_on_facet (geo t) i f a b _ Hi Fi Z) in Np.
  rewrite <- E in Hv. apply in_vertices in Hv. destruct Hv as (k & Hk & ->).
  rewrite bary_vertex in Pv by assumption. destruct (Nat.eq_dec i k); nra.
Qed.

Theorem hull_not_closed_refutes : hull_not_closed L -> ~ claims_to_fill S L.
Proof.
  intros (r & s1 & s2 & s3 & f1 & f2 & f3 & B1 & B2 & B3 & N12 & N23 & N13 & Nr & Lr & I1 & I2 & I3)
    (T & -> & F).
  assert (NE : T <> []). { intros ->. destruct B1 as ((B1 & _) & _). destruct B1. }
  assert (D : (1 <= d)%nat) by lia.
  destruct (fills_framed S T F NE) as (geo & G).
  destruct (boundary_outer S T geo s1 f1 G B1) as (t1 & i1 & H1 & _ & F1).
  destruct (boundary_outer S T geo s2 f2 G B2) as (t2 & i2 & H2 & _ & F2).
  destruct (boundary_outer S T geo s3 f3 G B3) as (t3 & i3 & H3 & _ & F3).
  destruct G as [_ A Dif V C]. set (tets := seq 0 (length T)) in *.
  pose proof (facet_supports tets geo S D A V C) as Sup.
  set (o := barycentre (geo t1)).
  assert (Inner : forall t i, hull_facet tets geo (outer tets geo) t i -> 0 < bary (geo t) i o).
  { intros t i (Ht & Hi & O). apply strictly_inner with (u := geo t1); [assumption| |].
    - apply barycentre_inside.
    - intros k Hk. apply (Sup t i Ht Hi O), (V t1); [apply H1|]. apply in_vertices. eauto. }
  set (cone t i := cone_over (geo t) i o).
  assert (Cones : forall t i, hull_facet tets geo (outer tets geo) t i ->
    cone_of (geo t) i o (cone t i)).
  { intros t i H. pose proof (Inner t i H). apply cone_over_cone; [apply H|lra]. }
  assert (Wall : forall t i f, hull_facet tets geo (outer tets geo) t i ->
    same f (facet_of (geo t) i) -> incl r f ->
    exists k, (k <= d)%nat /\ same (o :: r) (facet_of (cone t i) k)).
  { intros t i f H Fi Ir. pose proof H as (_ & Hi & _). pose proof (Cones t i H) as Co.
    apply facet_index.
    - constructor; [|assumption]. intros X. apply Ir, Fi in X.
      apply in_facet_of in X; [|assumption]. destruct X as (k & Hk & Nk & E).
      pose proof (Inner t i H) as P. rewrite E, bary_other in P by auto. lra.
    - cbn. lia.
    - intros v [<-|Hv].
      + apply in_vertices. exists i. split; [assumption|]. symmetry.
        now apply (cone_apex (geo t) (cone t i) i).
      + apply Ir, Fi in Hv. apply in_facet_of in Hv; [|assumption].
        destruct Hv as (k & Hk & Nk & ->). apply in_vertices. exists k. split; [assumption|].
        symmetry. now apply (cone_vertex (geo t) (cone t i) i o). }
  destruct (Wall t1 i1 f1 H1 F1 I1) as (k1 & K1 & W1).
  destruct (Wall t2 i2 f2 H2 F2 I2) as (k2 & K2 & W2).
  destruct (Wall t3 i3 f3 H3 F3 I3) as (k3 & K3 & W3).
  assert (Same : forall f g h : simplex d, same f g -> same f h -> same g h).
  { intros f g h [] []. split; eapply incl_tran; eassumption. }
  assert (Sides : forall t i k u j l f g, hull_facet tets geo (outer tets geo) t i ->
    hull_facet tets geo (outer tets geo) u j -> same f (facet_of (geo t) i) ->
    same g (facet_of (geo u) j) -> ~ same f g -> (k <= d)%nat -> (l <= d)%nat ->
    same (o :: r) (facet_of (cone t i) k) -> same (o :: r) (facet_of (cone u j) l) ->
    opposite (cone t i) k (cone u j) l).
  { intros t i k u j l f g Ht Hu Ft Fu N Hk Hl Wt Wu.
    apply (ridge_sides tets geo S D A Dif V Sup o cone Inner Cones); auto.
    - intros [-> ->]. apply N. destruct Ft, Fu. split; eapply incl_tran; eassumption.
    - now apply (Same (o :: r)). }
  destruct (ridge_of_two tets geo S D A Dif V Sup o cone Inner Cones t1 i1 k1 t3 i3 k3 t2 i2 k2 H1
    H3)
    as (-> & -> & _).
  - now apply (Sides t1 i1 k1 t2 i2 k2 f1 f2).
  - apply (Sides t3 i3 k3 t2 i2 k2 f3 f2); auto. intros [X Y]. apply N23. now split.
  - apply N13. destruct F1, F3. split; eapply incl_tran; eassumption.
Qed.
End HullBreach.
