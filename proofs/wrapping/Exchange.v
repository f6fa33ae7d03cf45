(** * Across a facet: of all points beyond it, the lowest is the apex  (Book: Section 5.6)

    Let two simplices have all vertices but one in common, the others on one side of the common
    facet.  If the first is canonical, then its own apex is, symbolically, below the witness plane
    of the second ([apex_is_lower]).  So whoever looks at the points beyond a facet of a canonical
    triangulation, one by one, and keeps the lower one, is left with the apex of the neighbour
    ([neighbour_beyond]); and from one simplex he gets to all others across facets
    ([all_reached]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Facets Matched Walk Generic
  Mesh LiftingMap.
From Circumspect Require Import DelaunayLemma Adjacency Perturbation EveryPointSet.
Import ListNotations.
Open Scope R_scope.

Section Exchange.
Context {d : nat}.
Implicit Types (t u y : frame d) (p v : point d) (g : point d -> R) (S : list (point d))
  (T : list (simplex d)).

(** All vertices of y but number k are vertices of u. *)
Definition but_one (y : frame d) (k : nat) (u : frame d) : Prop := (k <= d)%nat /\
  forall m, (m <= d)%nat -> m <> k -> exists l, (l <= d)%nat /\ vertex y m = vertex u l.

Lemma planes_differ g y k u p : but_one y k u ->
  witness g y p - witness g u p = bary y k p * above g u (vertex y k).
Proof.
  intros [Hk B]. pose proof (above_witness g y (witness g u) p (witness_affine g u)) as E.
  unfold sum in E.
  rewrite (sum_one _ _ k) in E; [unfold above; lra|apply seq_NoDup|now apply in_seq_d|].
  intros m Hm N. apply in_seq_d in Hm. destruct (B m Hm N) as (l & Hl & ->).
  rewrite witness_vertex by assumption. ring.
Qed.
Lemma apex_above g y k u j : but_one y k u -> (j <= d)%nat ->
  above g y (vertex u j) = - bary y k (vertex u j) * above g u (vertex y k).
Proof.
  intros B Hj. pose proof (planes_differ g y k u (vertex u j) B) as E.
  rewrite witness_vertex in E by assumption.
  change (above g y (vertex u j)) with (g (vertex u j) - witness g y (vertex u j)). lra.
Qed.

Lemma lead_scale c l : c <> 0 -> lead (map (Rmult c) l) = c * lead l.
Proof.
  intros N. induction l as [|a l IH]; cbn [map lead]; [ring|].
  destruct (Req_EM_T (c * a) 0) as [Z|Z], (Req_EM_T a 0) as [Y|Y]; auto.
  - apply Rmult_integral in Z. destruct Z; contradiction.
  - subst a. rewrite Rmult_0_r in Z. contradiction.
Qed.
Theorem apex_is_lower S h y k u j : but_one y k u -> (j <= d)%nat -> 0 < bary y k (vertex u j) ->
  canonical S h u -> In (vertex y k) S -> ~ In (vertex y k) (vertices u) ->
  lead (coefficients S h y (vertex u j)) < 0.
Proof.
  intros B Hj Pos C I N. specialize (C _ I N).
  assert (E : coefficients S h y (vertex u j) =
    map (Rmult (- bary y k (vertex u j))) (coefficients S h u (vertex y k))).
  { unfold coefficients. cbn [map]. rewrite map_map. f_equal; [now apply apex_above|].
    apply map_ext. intros v. rewrite (apex_above (at_point v) y k u j B Hj). ring. }
  rewrite E, lead_scale by lra. nra.
Qed.
End Exchange.

Lemma frame_same {d} (t u : frame d) k p : vertices t = vertices u -> (k <= d)%nat ->
  vertex t k = vertex u k /\ bary t k p = bary u k p.
Proof.
  intros E Hk. assert (V : forall m, (m <= d)%nat -> vertex t m = vertex u m).
  { intros m Hm. unfold vertices in E. apply (f_equal (fun l => nth m l (vertex t 0))) in E.
    rewrite map_nth in E.
    rewrite (nth_indep _ _ (vertex u 0)) in E by (rewrite map_length, seq_length; lia).
    now rewrite map_nth, !seq_nth in E by lia. }
  split; [now apply V|]. rewrite (interpolation u (bary t k) p (bary_affine t k Hk)). unfold sum.
  rewrite (sum_one _ _ k); [|apply seq_NoDup|now apply in_seq_d|].
  - rewrite <- V, bary_own by assumption. ring.
  - intros m Hm N. apply in_seq_d in Hm. rewrite <- V, bary_other by auto. ring.
Qed.

(** ** In a triangulation *)

Section Triangulation.
Context {d : nat}.
Implicit Types (t u : frame d) (p : point d).
Hypothesis positive : (1 <= d)%nat.
Variables (S : list (point d)) (T : list (simplex d)).
Hypothesis filled : fills S T.

(** If there is a point of S beyond facet i of a simplex of T, then there is a neighbour. *)
Theorem neighbour_beyond t i p : In (vertices t) T -> (i <= d)%nat -> In p S -> bary t i p < 0 ->
  exists u j, In (vertices u) T /\ opposite t i u j.
Proof.
  intros It Hi Ip Neg. assert (NE : T <> []) by (now intros E; rewrite E in It).
  destruct (triangulation_matched S T positive filled NE) as (geo & G & M & Su & _).
  destruct (In_nth T (vertices t) [] It) as (a & Ha & Ea). pose proof (G a Ha) as Ga.
  rewrite Ea in Ga.
  assert (Ia : In a (seq 0 (length T))) by (apply in_seq; lia).
  destruct (matched_or_hull _ _ _ _ M a i Ia Hi) as [(u & j & _ & Iu & O)|O].
  - exists (geo u), j. apply in_seq in Iu. split; [rewrite G by lia; apply nth_In; lia|].
    destruct O as (_ & Hj & TU & UT & O). split; [assumption|]. split; [assumption|].
    destruct (frame_same (geo a) t i (vertex (geo u) j) Ga Hi) as [_ B]. rewrite B in O.
    split; [|split; [|assumption]].
    + intros k Hk N. destruct (TU k Hk N) as (l & Hl & Nl & E). exists l. split; [assumption|].
      split; [assumption|].
      rewrite <- E. symmetry. now apply (frame_same (geo a) t k p Ga).
    + intros l Hl N. destruct (UT l Hl N) as (k & Hk & Nk & E). exists k. split; [assumption|].
      split; [assumption|].
      rewrite E. now apply (frame_same (geo a) t k p Ga).
  - pose proof (Su a i Ia Hi O p Ip) as P. destruct (frame_same (geo a) t i p Ga Hi) as [_ B]. lra.
Qed.

(** What holds of a simplex of T, and passes from each to its neighbours, holds of all. *)
Theorem all_reached (Q : simplex d -> Prop) : (exists s, In s T /\ Q s) ->
  (forall t u i j, In (vertices t) T -> In (vertices u) T -> opposite t i u j -> Q (vertices t) ->
    Q (vertices u)) ->
  forall s, In s T -> Q s.
Proof.
  intros (s0 & I0 & Q0) St s Is. assert (NE : T <> []) by (now intros E; rewrite E in Is).
  destruct (triangulation_matched S T positive filled NE) as (geo & G & M & Su & On).
  destruct (In_nth T s0 [] I0) as (a & Ha & Ea). destruct (In_nth T s [] Is) as (b & Hb & Eb).
  rewrite <- G in Ea, Eb by assumption.
  set (tets := seq 0 (length T)) in *.
  assert (Ia : In a tets) by (apply in_seq; lia). assert (Ib : In b tets) by (apply in_seq; lia).
  assert (In_T : forall t : nat, In t tets -> In (vertices (geo t)) T).
  { intros t It. apply in_seq in It. rewrite G by lia. apply nth_In. lia. }
  assert (Vs : forall (t : nat) i, In t tets -> (i <= d)%nat -> In (vertex (geo t) i) S).
  { intros t i It Hi. destruct filled as (_ & _ & _ & V & _).
    apply (V (vertices (geo t)) (In_T t It)).
    apply in_vertices. eauto. }
  destruct (generic_near M [] (barycentre (geo a)) a []) as (x & Xa & _ & _ & Gx & _).
  { assumption. } { apply inside_weaken, barycentre_inside. } { intros f []. } { intros f []. }
  destruct (generic_near M [] (barycentre (geo b)) b [x]) as (y & Yb & _ & _ & Gy & Gxy).
  { assumption. } { apply inside_weaken, barycentre_inside. } { intros f []. } { intros f [<-|[]].
    assumption. }
  destruct (mesh_walk M (fun t u : nat => Q (vertices (geo t)) -> Q (vertices (geo u))) x y a)
    as (c & Ic & Yc & R); auto.
  - apply Gxy. now left.
  - apply (inside_inside_hull Vs Su b); [assumption|]. now apply inside_weaken.
  - intros t i u j It Iu (_ & _ & O) _ Qt. apply (St (geo t) (geo u) i j); auto.
  - rewrite Ea in R. rewrite <- Eb. destruct (On b y Ib Yb) as (_ & _ & Other).
    destruct (Nat.eq_dec c b) as [->|N]; [now apply R|]. destruct (Other c Ic N) as (i & Hi & Neg).
    specialize (Yc i Hi). lra.
Qed.
End Triangulation.
