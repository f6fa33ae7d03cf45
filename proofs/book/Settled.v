(** * Which Delaunay triangulation: the only one, or the canonical one

    If across every matched facet the apex is strictly above the witness plane, and every submerged
    point is, then so is every point but the vertices ([strictly_above]): lower one point by so
    little that nothing is below a plane yet, and use the Delaunay Lemma.  So the simplices are in
    every Delaunay triangulation (Proposition 4.3), and this one is the only one ([only_one]).  If
    they are above by the symbolic signs, then for all small e all simplices have witness planes
    over the perturbed heights ([perturbed_planes]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Matched Faces Mesh Adjacency.
From Circumspect Require Import LiftingMap DelaunayLemma Uniqueness Perturbation.
Import ListNotations.
Open Scope R_scope.

Section Settled.
Context {d : nat} {T : Type} {tets : list T} {geo : T -> frame d}
  {adj : T -> nat -> T -> nat -> Prop} {hull : T -> nat -> Prop} {X : list (point d)}.
Hypothesis mesh : matched tets geo adj hull.
Hypothesis vertices_in : forall t i, In t tets -> (i <= d)%nat -> In (vertex (geo t) i) X.
Hypothesis support : supporting tets geo hull (fun p => In p X).
Hypothesis dec : forall a b : T, {a = b} + {a <> b}.
Context {o : point d} {t0 : T}.
Hypothesis once : covered_once tets geo o t0.
Variable h : point d -> R.

(** What the checker sees of each facet, from one of its sides, and of each point that is no
    vertex. *)
Variable good : (point d -> R) -> T -> point d -> Prop.
Hypothesis good_facets : forall t i u j, In t tets -> adj t i u j ->
  good h t (vertex (geo u) j) \/ good h u (vertex (geo t) i).
Hypothesis good_points : forall p, In p X -> vertex_of tets geo p \/
  exists u, In u tets /\ inside_closed (geo u) p /\ good h u p.

(** Other heights k that are no less than the planes wherever it was good to be above them. *)
Lemma planes_of k : (forall t p, In t tets -> In p X -> good h t p -> witness k (geo t) p <= k p) ->
  forall t, In t tets -> witness_plane k X (vertices (geo t)).
Proof.
  intros K t Ht.
  assert (Local : forall t i u j, In t tets -> adj t i u j -> locally_above k (geo t) (geo u) j).
  { intros a i b j Ha A. pose proof (matched_in _ _ _ _ mesh a i b j Ha A) as Hb.
    pose proof (matched_opposite _ _ _ _ mesh a i b j Ha A) as O.
    pose proof O as (Hi & Hj & _).
    destruct (good_facets a i b j Ha A) as [G|G].
    - apply K; auto.
    - apply (locally_above_symmetric k (geo a) i (geo b) j O). apply K; auto. }
  apply (mesh_witness_plane mesh vertices_in support dec once Local); [|assumption].
  intros p Hp. destruct (good_points p Hp) as [V|(u & Hu & I & G)]; [now left|right].
  exists u. auto.
Qed.
End Settled.

Section Strict.
Context {d : nat} {T : Type} {tets : list T} {geo : T -> frame d}
  {adj : T -> nat -> T -> nat -> Prop} {hull : T -> nat -> Prop} {X : list (point d)}.
Hypothesis mesh : matched tets geo adj hull.
Hypothesis vertices_in : forall t i, In t tets -> (i <= d)%nat -> In (vertex (geo t) i) X.
Hypothesis support : supporting tets geo hull (fun p => In p X).
Hypothesis dec : forall a b : T, {a = b} + {a <> b}.
Context {o : point d} {t0 : T}.
Hypothesis once : covered_once tets geo o t0.
Variable h : point d -> R.

Definition strictly h t p : Prop := 0 < above h (geo t) p.
Definition symbolically h t p : Prop := 0 < lead (coefficients X h (geo t) p).

Theorem strictly_above :
  (forall t i u j, In t tets -> adj t i u j ->
     strictly h t (vertex (geo u) j) \/ strictly h u (vertex (geo t) i)) ->
  (forall p, In p X -> vertex_of tets geo p \/
     exists u, In u tets /\ inside_closed (geo u) p /\ strictly h u p) ->
  forall t p, In t tets -> In p X -> ~ In p (vertices (geo t)) -> strictly h t p.
Proof.
  intros Facets Points t p Ht Hp N.
  set (l := filter (fun a => if Rlt_dec 0 (above h (geo (fst a)) (snd a)) then true else false)
    (list_prod tets X)).
  destruct (small_slope l (fun a => above h (geo (fst a)) (snd a))
    (fun a => - above (at_point p) (geo (fst a)) (snd a))) as (e & He & K).
  { intros a Ha. apply filter_In in Ha. destruct Ha as [_ Ha].
    destruct (Rlt_dec 0 (above h (geo (fst a)) (snd a))); [lra|discriminate]. }
  specialize (K e ltac:(lra)). set (k q := 1 * h q + - e * at_point p q).
  assert (Ab : forall u q, above k (geo u) q = above h (geo u) q + e * - above (at_point p)
    (geo u) q).
  { intros u q. unfold k. rewrite above_combine. ring. }
  assert (W : witness_plane k X (vertices (geo t))).
  { apply (planes_of mesh vertices_in support dec once h strictly Facets Points k); [|assumption].
    intros u q Hu Hq S. assert (I : In (u, q) l).
    { apply filter_In. split; [now apply in_prod|]. cbn [fst snd]. unfold strictly in S.
      now destruct (Rlt_dec 0 (above h (geo u) q)). }
    specialize (K _ I). cbn [fst snd] in K. rewrite <- Ab in K. unfold above in K. lra. }
  pose proof (proj1 (witness_plane_witness k X (geo t)) W p Hp) as L.
  assert (P : 0 <= above k (geo t) p) by (unfold above; lra). rewrite Ab in P.
  assert (E : above (at_point p) (geo t) p = 1).
  { unfold above, witness, sum. rewrite sum_zero.
    - unfold at_point. destruct (point_eq_dec p p); [ring|contradiction].
    - intros i Hi. apply in_seq_d in Hi. unfold at_point.
      destruct (point_eq_dec (vertex (geo t) i) p) as [Ev|]; [|ring].
      exfalso. apply N, in_vertices. exists i. now split. }
  rewrite E in P. unfold strictly. lra.
Qed.

(** Every other triangulation whose simplices have witness planes has these simplices. *)
Theorem strictly_in U : (forall t p, In t tets -> In p X -> ~ In p (vertices (geo t)) ->
     strictly h t p) ->
  fills X U -> (forall u, In u U -> witness_plane h X u) ->
  forall t, In t tets -> faces_of U (vertices (geo t)).
Proof.
  intros St F W t Ht. apply (proposition_4_3_heights h X); try assumption.
  - destruct (witness_affine h (geo t)) as (a & b & E). exists a, b. split.
    + intros v Hv. apply in_vertices in Hv. destruct Hv as (i & Hi & ->).
      rewrite <- E. now apply witness_vertex.
    + intros p Hp. rewrite <- E. destruct (in_points p (vertices (geo t))) as [V|V].
      * split; [|auto]. apply in_vertices in V. destruct V as (i & Hi & ->).
        rewrite witness_vertex by assumption. lra.
      * specialize (St t p Ht Hp V). unfold strictly, above in St. split; intros; lra.
  - apply vertices_independent.
  - intros E. pose proof (vertices_length (geo t)) as L. rewrite E in L. discriminate.
  - intros v Hv. apply in_vertices in Hv. destruct Hv as (i & Hi & ->). auto.
Qed.

(** For all small e there are witness planes over the perturbed heights. *)
Theorem perturbed_planes :
  (forall t i u j, In t tets -> adj t i u j ->
     symbolically h t (vertex (geo u) j) \/ symbolically h u (vertex (geo t) i)) ->
  (forall p, In p X -> vertex_of tets geo p \/
     exists u, In u tets /\ inside_closed (geo u) p /\ symbolically h u p) ->
  exists e0, 0 < e0 /\ forall e, 0 < e < e0 -> forall t, In t tets ->
    witness_plane (perturbed X h e) X (vertices (geo t)).
Proof.
  intros Facets Points. destruct (perturbation_sound X h (map geo tets)) as (e0 & P & K).
  exists e0. split; [assumption|]. intros e He.
  apply (planes_of mesh vertices_in support dec once h symbolically Facets Points).
  intros t p Ht Hp S. destruct (K e He (geo t) p) as [[Pos _] _]; [now apply in_map|assumption|].
  specialize (Pos S). unfold above in Pos. lra.
Qed.
End Strict.

(** If all simplices of one triangulation are in another, then all of the other are in the first. *)
Theorem filled_same {d : nat} (S : list (point d)) T U : fills S T -> fills S U ->
  (forall t, In t T -> faces_of U t) -> same_simplices T U.
Proof.
  intros FT FU I.
  assert (K : forall t, In t T -> exists u : simplex d, In u U /\ same t u).
  { intros t Ht. destruct (I t Ht) as (N & _ & u & Hu & Iu). exists u. split; [assumption|].
    split; [assumption|]. destruct FT as (LT & _), FU as (LU & _).
    destruct (LT t Ht) as [_ Lt], (LU u Hu) as [_ Lu].
    apply NoDup_length_incl; [assumption|lia|assumption]. }
  split; [assumption|]. intros u Hu. destruct (fills_frame S U u FU Hu) as (fu & Eu).
  set (q := barycentre fu). pose proof (barycentre_inside fu) as Iq. fold q in Iq.
  assert (Cq : conv u q). { rewrite <- Eu. apply conv_vertices. intros i Hi. left. auto. }
  pose proof FU as (LU & (_ & _ & MU) & _ & VU & CU). pose proof FT as (_ & _ & _ & _ & CT).
  destruct (proj1 (CT q)) as (t & Ht & Ct).
  { apply CU. eauto. }
  exists t. split; [assumption|]. destruct (K t Ht) as (u' & Hu' & S').
  assert (C' : conv u' q) by now apply (conv_same t u' q).
  assert (Fu : forall s, In s U -> faces_of U s).
  { intros s Hs. destruct (LU s Hs) as [N L]. split; [assumption|]. split; [now intros ->|].
    exists s. split; [assumption|apply incl_refl]. }
  destruct (MU u u' (Fu u Hu) (Fu u' Hu')) as (f & If & If' & Cf). specialize (Cf q Cq C').
  assert (Iuf : incl u f).
  { rewrite <- Eu in *. apply (conv_face fu f q If) in Cf. destruct Cf as [_ Cf].
    intros v Hv. apply in_vertices in Hv. destruct Hv as (i & Hi & ->). auto. }
  destruct (LU u Hu) as [Nu Lu], (LU u' Hu') as [Nu' Lu'].
  assert (incl u u') by now apply incl_tran with f.
  assert (incl u' u) by (apply NoDup_length_incl; [assumption|lia|assumption]).
  destruct S' as [S1 S2]. split; eapply incl_tran; eassumption.
Qed.
