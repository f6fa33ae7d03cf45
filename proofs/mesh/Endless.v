(** * Meshes without end: infinitely many simplices, every facet matched

    [Mesh.v] is about finitely many simplices with a hull.  Here there are infinitely many, such as
    those that a lattice repeats, and no hull: every facet is matched.  Of what a walk needs, one
    thing has to be said anew: only finitely many simplices are near any finitely many points
    ([endless_near]).  A walk between points near them meets no others, so it is one through a
    finite mesh of which nothing else need be matched.  As before, if one sample point is in one
    simplex only, no two overlap, they meet face to face ([endless_agree]), they cover everything
    ([endless_cover]), and the Delaunay Lemma holds ([endless_below]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Matched Faces Walk Generic Mesh.
From Circumspect Require Import LiftingMap DelaunayLemma.
Import ListNotations.
Open Scope R_scope.

Section Endless.
Context {d : nat} {T : Type}.
Variables (geo : T -> frame d) (adj : T -> nat -> T -> nat -> Prop).

Record endless : Prop := {
  endless_matched : forall t i, (i <= d)%nat -> exists u j, adj t i u j;
  endless_opposite : forall t i u j, adj t i u j -> opposite (geo t) i (geo u) j;
  endless_once : forall t i t' i' u j, adj t i u j -> adj t' i' u j -> t = t';
  (* near given points, where some affine functions are positive, there are finitely many *)
  endless_near : forall X : list (point d), exists (K : list (point d -> R)) (tets : list T),
    (forall g, In g K -> affine g /\ forall x, In x X -> 0 < g x) /\
    forall t p, (forall g, In g K -> 0 < g p) -> inside_closed (geo t) p -> In t tets
}.
Hypothesis mesh : endless.
Hypothesis dec : forall a b : T, {a = b} + {a <> b}.

Section Near.
Variables (K : list (point d -> R)) (tets : list T).
Hypothesis K_affine : forall g, In g K -> affine g.
Hypothesis all_near : forall t p, (forall g, In g K -> 0 < g p) -> inside_closed (geo t) p ->
  In t tets.

(** Matched within the list; the other facets may be anything. *)
Definition adj_near (t : T) (i : nat) (u : T) (j : nat) : Prop := adj t i u j /\ In u tets.
Lemma near_matched : matched tets geo adj_near (fun _ _ => True).
Proof.
  constructor.
  - intros t i u j _ [_ I]. exact I.
  - intros t i u j _ [A _]. now apply (endless_opposite mesh).
  - intros t i t' i' u j _ _ [A _] [A' _]. now apply (endless_once mesh t i t' i' u j).
  - intros t i _ _. now right.
Qed.

Lemma passes_near x y t i s : (forall g, In g K -> 0 < g x /\ 0 < g y) -> In t tets ->
  mesh_passes geo x y t i s -> exists u j, adj_near t i u j.
Proof.
  intros Pos Ht (Ii & _ & Hs & Z & P). apply in_seq_d in Ii.
  destruct (endless_matched mesh t i Ii) as (u & j & A). exists u, j. split; [assumption|].
  pose proof (endless_opposite mesh t i u j A) as O.
  apply (all_near u (mix x y s)).
  - intros g Ig. rewrite (affine_mix g _ _ _ (K_affine g Ig)). destruct (Pos g Ig). nra.
  - intros l Hl. unfold coordinate in *. destruct (Nat.eq_dec l j) as [->|N].
    + destruct (opposite_multiple _ _ _ _ O) as (c & _ & ->). rewrite Z. lra.
    + left. apply (opposite_through (geo t) i (geo u) j); auto.
      intros k Hk. apply P. now apply in_seq_d.
Qed.

(** A walk within the region: [mesh_walk_passing] without a hull. *)
Theorem near_walk (Rl : T -> T -> Prop) x y t :
  (forall g, In g K -> 0 < g x /\ 0 < g y) -> mesh_generic tets geo y ->
  mesh_generic_pair tets geo x y -> In t tets -> inside (geo t) x ->
  (forall t, Rl t t) -> (forall a b c, Rl a b -> Rl b c -> Rl a c) ->
  (forall t i u j s, In t tets -> In u tets -> adj t i u j -> mesh_passes geo x y t i s ->
     0 < bary (geo u) j y -> Rl t u) ->
  exists t', In t' tets /\ inside (geo t') y /\ Rl t t'.
Proof.
  intros Pos Gy Gxy Ht Xt Refl Trans Cross.
  destruct (cells_walk (mesh_cells near_matched) Rl x y t Gy Gxy Ht) as (t' & Ht' & Yt' & R); auto.
  - now apply in_cell_inside.
  - intros a i s Ha. now apply passes_near.
  - intros a i u j s Ha Hu _ [A _] P Y. now apply (Cross a i u j s).
  - exists t'. split; [assumption|]. split; [now apply in_cell_inside|assumption].
Qed.

Lemma near_disjoint (o : point d) (t0 : T) : In t0 tets -> inside (geo t0) o ->
  (forall t, t <> t0 -> exists i, (i <= d)%nat /\ bary (geo t) i o < 0) ->
  forall t u p, (forall g, In g K -> 0 < g o /\ 0 < g p) -> In t tets -> In u tets ->
    inside (geo t) p -> inside (geo u) p -> t = u.
Proof.
  intros H0 O0 Out t u p Pos Ht Hu It Iu.
  apply (cells_disjoint (mesh_cells near_matched) dec o t0 K) with (y := p); auto;
    try now apply in_cell_inside.
  - intros a _ Na. destruct (Out a Na) as (i & Hi & Neg). exists i.
    split; [now apply in_seq_d|assumption].
  - intros x y a i s Pxy Ha _. now apply passes_near.
Qed.
End Near.

Variables (o : point d) (t0 : T).
Hypothesis sampled : inside (geo t0) o.
Hypothesis once : forall t, t <> t0 -> exists i, (i <= d)%nat /\ bary (geo t) i o < 0.

(** No two simplices overlap. *)
Theorem endless_disjoint t u p : inside (geo t) p -> inside (geo u) p -> t = u.
Proof.
  intros It Iu. destruct (endless_near mesh [o; p]) as (K & tets & HK & Near).
  assert (Po : forall g, In g K -> 0 < g o) by (intros g I; apply (HK g I); now left).
  assert (Pp : forall g, In g K -> 0 < g p) by (intros g I; apply (HK g I); right; now left).
  apply (near_disjoint K tets) with (o := o) (t0 := t0) (p := p); auto.
  - intros g I. now apply HK.
  - apply (Near t0 o Po). now apply inside_weaken.
  - apply (Near t p Pp). now apply inside_weaken.
  - apply (Near u p Pp). now apply inside_weaken.
Qed.

Lemma out_of_all (tets : list T) p : (exists t, In t tets /\ inside_closed (geo t) p) \/
  forall t, In t tets -> exists i, In i (facets (d := d) t) /\ bary (geo t) i p < 0.
Proof.
  induction tets as [|a l IH]; [right; intros t []|].
  destruct IH as [(t & I & C)|IH]; [left; exists t; split; [now right|assumption]|].
  destruct (Exists_dec (fun i => bary (geo a) i p < 0) (facets (d := d) a)) as [E|N].
  - intros i. apply Rlt_dec.
  - right. intros t [<-|I]; [now apply Exists_exists in E|auto].
  - left. exists a. split; [now left|]. intros i Hi.
    destruct (Rle_dec 0 (bary (geo a) i p)); [assumption|exfalso]. apply N, Exists_exists. exists i.
    split; [now apply in_seq_d|lra].
Qed.

(** Each point is in a simplex: a walk that ends near it would end in one. *)
Theorem endless_cover p : exists t, inside_closed (geo t) p.
Proof.
  destruct (endless_near mesh [o; p]) as (K & tets & HK & Near).
  assert (KA : forall g, In g K -> affine g) by (intros g I; now apply HK).
  assert (Po : forall g, In g K -> 0 < g o) by (intros g I; apply (HK g I); now left).
  assert (Pp : forall g, In g K -> 0 < g p) by (intros g I; apply (HK g I); right; now left).
  destruct (out_of_all tets p) as [(t & _ & C)|Out]; [now exists t|exfalso].
  pose proof (near_matched tets) as M.
  assert (H0 : In t0 tets) by (apply (Near t0 o Po); now apply inside_weaken).
  destruct (outside_functions (mesh_cells M) p (fun _ => True)) as (G & G1 & G2);
    [now left|intros t Ht _; now apply Out|].
  destruct (generic_near M K o t0 []) as (x & Xt & Px & _ & Gx & _); auto.
  { now apply inside_weaken. } { intros ? []. }
  destruct (pick_generic (mesh_cells M) (G ++ K) p [x]) as (z & Z1 & Z2 & Z3).
  { intros ? [<-|[]]. assumption. }
  { intros g Hg. apply in_app_or in Hg. destruct Hg as [Hg|Hg]; [now apply G1|auto]. }
  destruct (near_walk K tets KA Near (fun _ _ => True) x z t0) as (t & Ht & It & _); auto.
  - intros g I. split; [now apply Px|]. apply Z1, in_or_app. now right.
  - apply Z3. now left.
  - destruct (G2 z (fun g Hg => Z1 g (in_or_app _ _ _ (or_introl Hg))) t Ht Logic.I)
      as (i & Ii & Ni).
    apply in_seq_d in Ii. specialize (It i Ii). unfold coordinate in Ni. lra.
Qed.

(** A point of two simplices has the same carrier in both. *)
Theorem endless_agree t u : agree (geo t) (geo u).
Proof.
  intros q Qt Qu. destruct (endless_near mesh [q]) as (K & tets & HK & Near).
  assert (KA : forall g, In g K -> affine g) by (intros g I; now apply HK).
  assert (Pq : forall g, In g K -> 0 < g q) by (intros g I; apply (HK g I); now left).
  pose proof (near_matched tets) as M.
  pose proof (Near t q Pq Qt) as Ht. pose proof (Near u q Pq Qu) as Hu.
  destruct (generic_near M K q t []) as (x & Xi & Px & Xs & Xg & _); auto.
  { intros ? []. }
  destruct (generic_near M K q u [x]) as (y & Yi & Py & Ys & Yg & Yp); auto.
  { intros ? [<-|[]]; assumption. }
  destruct (near_walk K tets KA Near
      (fun a b => inside_closed (geo a) q -> inside_closed (geo b) q /\
      forall k, (k <= d)%nat -> 0 < bary (geo a) k q ->
        exists l, (l <= d)%nat /\ vertex (geo a) k = vertex (geo b) l /\ 0 < bary (geo b) l q)
    x y t) as (u' & Hu' & Yu' & C); auto.
  - apply Yp. now left.
  - intros a Q. split; [assumption|]. intros k Hk Pk. exists k. auto.
  - intros a b c Hab Hbc Q. destruct (Hab Q) as [Qb Sb]. destruct (Hbc Qb) as [Qc Sc].
    split; [assumption|]. intros k Hk Pk. destruct (Sb k Hk Pk) as (l & Hl & E & Pl).
    destruct (Sc l Hl Pl) as (m & Hm & E' & Pm). exists m. split; [assumption|]. split; congruence.
  - intros a i b j s Ha Hb A Ps _ Q.
    now apply (carrier_crossing M q x y s a i b j); [| |split| | | |].
  - rewrite <- (endless_disjoint u' u y) by assumption. now apply C.
Qed.

(** Over simplex u no witness plane is above that of u, if none is across a facet. *)
Theorem endless_below (h : point d -> R) t u p :
  (forall t i u j, adj t i u j -> locally_above h (geo t) (geo u) j) ->
  inside_closed (geo u) p -> witness h (geo t) p <= witness h (geo u) p.
Proof.
  intros local Q. destruct (Rle_dec (witness h (geo t) p) (witness h (geo u) p)) as [|Bad];
    [assumption|exfalso].
  set (g q := 1 * witness h (geo t) q + (-1) * witness h (geo u) q).
  assert (A : affine g) by (apply affine_combine; apply witness_affine).
  destruct (endless_near mesh [barycentre (geo t); p]) as (K & tets & HK & Near).
  assert (KA : forall g, In g K -> affine g) by (intros f I; now apply HK).
  assert (Pt : forall g, In g K -> 0 < g (barycentre (geo t)))
    by (intros f I; apply (HK f I); now left).
  assert (Pp : forall g, In g K -> 0 < g p) by (intros f I; apply (HK f I); right; now left).
  pose proof (near_matched tets) as M.
  assert (Qt : inside_closed (geo t) (barycentre (geo t)))
    by apply inside_weaken, barycentre_inside.
  pose proof (Near t _ Pt Qt) as Ht. pose proof (Near u p Pp Q) as Hu.
  destruct (generic_near M K (barycentre (geo t)) t []) as (x & Xt & Px & _ & Gx & _); auto.
  { intros ? []. }
  destruct (generic_near M (g :: K) p u [x]) as (y & Yu & Gy & _ & Ny & Nxy); auto.
  { intros f [<-|I]; [|auto]. split; [assumption|]. unfold g. lra. }
  { intros f [<-|[]]. assumption. }
  destruct (near_walk K tets KA Near (fun a b => witness h (geo a) y <= witness h (geo b) y) x y t)
    as (u' & Hu' & Yu' & W); auto.
  - intros f I. split; [now apply Px|]. apply Gy. now right.
  - apply Nxy. now left.
  - intros; lra.
  - intros; lra.
  - intros a i b j s Ha Hb Adj _ Pos.
    apply (witness_crossing h (geo a) i (geo b) j); [|now apply (local a i)|assumption].
    now apply (endless_opposite mesh).
  - assert (u' = u) as -> by now apply (endless_disjoint u' u y).
    specialize (Gy g (or_introl eq_refl)). unfold g in Gy. lra.
Qed.
End Endless.
