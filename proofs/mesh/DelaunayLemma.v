(** * The Delaunay Lemma for matched meshes, over arbitrary heights  (Book: Lemma 4.1)

    Let every point have a height, and let every d-simplex carry its witness plane.  If across
    every matched facet the apex of the neighbour is not below the plane, then nothing is below
    any plane: walk from inside simplex t along a generic segment to a point y inside simplex u.
    Whenever a facet is crossed, the height at y of the plane does not decrease, because the
    planes on its two sides agree on the facet and the second is above the first beyond it
    ([witness_crossing]).  So over u the plane of t is not above that of u ([witness_below]), and
    so not above a vertex of u, nor above a submerged point that u carries.

    With the heights |p|^2 this is Lemma 4.1; with |p|^2 - w(p) it is the weighted lemma. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Matched Faces Walk Generic Mesh.
From Circumspect Require Import LiftingMap.
Import ListNotations.
Open Scope R_scope.

Section Crossing.
Context {d : nat} (h : point d -> R).
Implicit Types (t u : frame d) (p : point d).

(** Facet i of t is facet j of u, and the apex of u is not below the witness plane of t. *)
Definition locally_above t (u : frame d) (j : nat) : Prop :=
  witness h t (vertex u j) <= h (vertex u j).

(** The planes on the two sides of a facet differ by a multiple of the coordinate that vanishes
    on the facet. *)
Lemma witness_difference t i u j p : opposite t i u j ->
  witness h u p - witness h t p = bary u j p * (h (vertex u j) - witness h t (vertex u j)).
Proof.
  intros (Hi & Hj & TU & UT & _).
  pose proof (above_witness h u (witness h t) p (witness_affine h t)) as E.
  unfold sum in E. rewrite (sum_one _ _ j) in E; [lra|apply seq_NoDup|now apply in_seq_d|].
  intros l Hl N. apply in_seq_d in Hl. destruct (UT l Hl N) as (k & Hk & _ & ->).
  rewrite witness_vertex by assumption. ring.
Qed.

Lemma witness_crossing t i u j y : opposite t i u j -> locally_above t u j -> 0 < bary u j y ->
  witness h t y <= witness h u y.
Proof.
  intros O L P. pose proof (witness_difference t i u j y O) as E. unfold locally_above in L. nra.
Qed.

(** It is the same to say that the apex of t is not below the witness plane of u: one test for
    each facet is enough. *)
Theorem locally_above_symmetric t i u j : opposite t i u j ->
  (locally_above t u j <-> locally_above u t i).
Proof.
  assert (K : forall t i u j, opposite t i u j -> locally_above t u j -> locally_above u t i).
  { clear t i u j. intros t i u j O L. pose proof (opposite_sym t i u j O) as (_ & Hi & _ & _ & N).
    pose proof (witness_difference t i u j (vertex t i) O) as E.
    rewrite witness_vertex in E by assumption. unfold locally_above in *. nra. }
  intros O. split; [now apply K|]. apply K. now apply opposite_sym.
Qed.
End Crossing.

Section DelaunayLemma.
Context {d : nat} {T : Type} {tets : list T} {geo : T -> frame d}
  {adj : T -> nat -> T -> nat -> Prop} {hull : T -> nat -> Prop} {P : point d -> Prop}.
Hypothesis mesh : matched tets geo adj hull.
Hypothesis vertices_in : forall t i, In t tets -> (i <= d)%nat -> P (vertex (geo t) i).
Hypothesis support : supporting tets geo hull P.
Hypothesis dec : forall a b : T, {a = b} + {a <> b}.
Context {o : point d} {t0 : T}.
Hypothesis once : covered_once tets geo o t0.

Context {h : point d -> R}.
Hypothesis local : forall t i u j, In t tets -> adj t i u j -> locally_above h (geo t) (geo u) j.

(** Over simplex u no witness plane is above that of u: together they are a convex function. *)
Theorem witness_below t u p : In t tets -> In u tets -> inside_closed (geo u) p ->
  witness h (geo t) p <= witness h (geo u) p.
Proof.
  intros Ht Hu I.
  destruct (Rle_dec (witness h (geo t) p) (witness h (geo u) p)) as [|Bad]; [assumption|exfalso].
  set (g q := 1 * witness h (geo t) q + (-1) * witness h (geo u) q).
  assert (A : affine g) by (apply affine_combine; apply witness_affine).
  destruct (generic_near mesh [] (barycentre (geo t)) t []) as (x & Xt & _ & _ & Gx & _).
  { assumption. } { apply inside_weaken, barycentre_inside. } { intros f []. } { intros f []. }
  destruct (generic_near mesh [g] p u [x]) as (y & Yu & Gy & _ & Ny & Nxy).
  { assumption. } { assumption. }
  { intros f [<-|[]]. split; [assumption|]. unfold g. lra. } { intros f [<-|[]]. assumption. }
  destruct (mesh_walk mesh (fun a b => witness h (geo a) y <= witness h (geo b) y) x y t)
    as (u' & Hu' & Yu' & W); auto.
  - apply Nxy. now left.
  - apply (inside_inside_hull vertices_in support u); [assumption|]. now apply inside_weaken.
  - intros; lra.
  - intros; lra.
  - intros a i b j Ha Hb Adj Pos. apply (witness_crossing h (geo a) i (geo b) j).
    + now apply (matched_opposite _ _ _ _ mesh).
    + now apply (local a i).
    + assumption.
  - assert (u' = u) as -> by now apply (mesh_disjoint mesh vertices_in support dec once u' u y).
    specialize (Gy g (or_introl eq_refl)). unfold g in Gy. lra.
Qed.

(** Nothing is below a witness plane: no vertex, ... *)
Corollary vertex_above t p : In t tets -> vertex_of tets geo p -> witness h (geo t) p <= h p.
Proof.
  intros Ht (u & i & Hu & Hi & ->). rewrite <- (witness_vertex h (geo u) i Hi).
  apply witness_below; [assumption..|]. intros k Hk. rewrite bary_vertex by assumption.
  destruct (Nat.eq_dec k i); lra.
Qed.

(** ... and no submerged point, if it is not below that of the simplex it is in. *)
Corollary submerged_above t u p : In t tets -> In u tets -> inside_closed (geo u) p ->
  witness h (geo u) p <= h p -> witness h (geo t) p <= h p.
Proof. intros Ht Hu I L. apply Rle_trans with (witness h (geo u) p); [|assumption].
  now apply witness_below. Qed.

(** A point is accounted for if it is a vertex, or submerged. *)
Definition accounted (p : point d) : Prop := vertex_of tets geo p \/
  exists u, In u tets /\ inside_closed (geo u) p /\ witness h (geo u) p <= h p.

Theorem mesh_witness_plane (X : list (point d)) t : (forall p, In p X -> accounted p) ->
  In t tets -> witness_plane h X (vertices (geo t)).
Proof.
  intros All Ht. apply witness_plane_witness. intros p Hp.
  destruct (All p Hp) as [V|(u & Hu & I & L)]; [now apply vertex_above|].
  now apply (submerged_above t u).
Qed.
End DelaunayLemma.
Arguments accounted {d T} tets geo h p.

(** ** What a checker of certificates needs *)
Section Certified.
Context {d : nat} {T : Type} {tets : list T} {geo : T -> frame d}
  {adj : T -> nat -> T -> nat -> Prop} {hull : T -> nat -> Prop}.
Variable X : list (point d).
Hypothesis mesh : matched tets geo adj hull.
Hypothesis vertices_in : forall t i, In t tets -> (i <= d)%nat -> In (vertex (geo t) i) X.
Hypothesis support : supporting tets geo hull (fun p => In p X).
Hypothesis dec : forall a b : T, {a = b} + {a <> b}.
Hypothesis no_twice : NoDup tets.
Variables (o : point d) (t0 : T).
Hypothesis once : covered_once tets geo o t0.

Theorem mesh_triangulation : (forall p, In p X -> vertex_of tets geo p) ->
  triangulation X (map (fun t => vertices (geo t)) tets).
Proof.
  intros All. split; [now apply (mesh_fills X o t0 dec no_twice mesh)|].
  intros p Hp. destruct (All p Hp) as (t & i & Ht & Hi & ->). exists (vertices (geo t)).
  split; [|apply in_vertices; eauto]. apply in_map_iff. eauto.
Qed.

Theorem mesh_delaunay_triangulation : (forall p, In p X -> vertex_of tets geo p) ->
  (forall t i u j, In t tets -> adj t i u j -> locally_above norm2 (geo t) (geo u) j) ->
  delaunay_triangulation X (map (fun t => vertices (geo t)) tets).
Proof.
  intros All L. split; [now apply mesh_triangulation|].
  intros s Hs. apply in_map_iff in Hs. destruct Hs as (t & <- & Ht).
  apply delaunay_witness_plane. apply (mesh_witness_plane mesh vertices_in support dec once L);
    [|assumption]. intros p Hp. left. auto.
Qed.

Theorem mesh_weighted_delaunay_triangulation (w : point d -> R) :
  (forall p, In p X -> accounted tets geo (fun p => norm2 p - w p) p) ->
  (forall t i u j, In t tets -> adj t i u j ->
     locally_above (fun p => norm2 p - w p) (geo t) (geo u) j) ->
  weighted_delaunay_triangulation w X (map (fun t => vertices (geo t)) tets).
Proof.
  intros All L. split; [now apply (mesh_fills X o t0 dec no_twice mesh)|].
  intros s Hs. apply in_map_iff in Hs. destruct Hs as (t & <- & Ht).
  now apply (mesh_witness_plane mesh vertices_in support dec once L).
Qed.
End Certified.
