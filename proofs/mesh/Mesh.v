(** * A matched mesh is a simplicial complex that fills the convex hull

    The simplices of a matched mesh ([Matched.v]) are cells whose walls are their facets, so one
    can walk through them along generic segments ([Generic.v]).  If the hull facets support the
    vertices and one sample point is in one simplex only:
    - no two simplices overlap ([mesh_disjoint]): walks to the sample point from two different
      simplices with a common point would end in two different simplices;
    - each point on the inner side of the hull facets is in a simplex ([mesh_covers]): a walk from
      the sample point ends near it;
    - simplices meet face to face ([mesh_face_to_face]): let q be in two simplices; a walk from one
      to the other close to q crosses only facets that contain the carrier of q.
    So the simplices and their faces form a complex that fills conv S ([mesh_fills]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Matched Faces Walk Generic.
Import ListNotations.
Open Scope R_scope.

Section Mesh.
Context {d : nat} {T : Type} {tets : list T} {geo : T -> frame d}
  {adj : T -> nat -> T -> nat -> Prop} {hull : T -> nat -> Prop}.
Hypothesis mesh : matched tets geo adj hull.

(** The walls of a simplex are its facets. *)
Definition facets (t : T) : list nat := seq 0 (S d).
Definition coordinate (t : T) : nat -> point d -> R := bary (geo t).

Theorem mesh_cells : matched_cells tets facets coordinate adj.
Proof.
  constructor; unfold facets, coordinate.
  - intros t i _ Hi. apply in_seq_d in Hi. now apply bary_affine.
  - intros t i _ Hi. apply in_seq_d in Hi. exists (vertex (geo t) i). rewrite bary_own; auto; lra.
  - intros t i j _ Hi Hj N. apply in_seq_d in Hi, Hj. exists (vertex (geo t) j).
    rewrite bary_other, bary_own by auto. split; lra.
  - intros t i u j Ht _ A. pose proof (matched_opposite _ _ _ _ mesh t i u j Ht A) as (_ & Hj & _).
    split; [now apply (matched_in _ _ _ _ mesh t i u j)|now apply in_seq_d].
  - intros t i u j Ht _ A. apply opposite_multiple. now apply (matched_opposite _ _ _ _ mesh).
  - intros t i u j q Ht _ A Z P l Hl. apply in_seq_d in Hl.
    apply (opposite_through (geo t) i); [now apply (matched_opposite _ _ _ _ mesh)|assumption| |];
      [|assumption]. intros k Hk. apply P. now apply in_seq_d.
  - intros t i t' i' u j Ht Ht' _ _. now apply (matched_once _ _ _ _ mesh).
Qed.

Lemma in_cell_inside t p : in_cell facets coordinate t p <-> inside (geo t) p.
Proof. split; intros H i Hi; apply H; now apply in_seq_d. Qed.

(** Points on no facet's hyperplane, and pairs of them whose segment meets no two facets of a
    simplex at once. *)
Definition mesh_generic := on_no_wall tets facets coordinate.
Definition mesh_generic_pair := generic_pair tets facets coordinate.
(** The segment xy leaves the simplex t at [mix x y s] through its facet i. *)
Definition mesh_passes := passes facets coordinate.

(** All coordinates that do not vanish at q have the same signs at z. *)
Definition mesh_same_side := same_side tets facets coordinate.

Lemma generic_inside t p : In t tets -> mesh_generic p -> inside_closed (geo t) p ->
  inside (geo t) p.
Proof.
  intros Ht G I i Hi. pose proof (G t i Ht (proj2 (in_seq_d i) Hi)) as N. unfold coordinate in N.
  specialize (I i Hi). lra.
Qed.

(** Near any point of a simplex there are generic points in its interior. *)
Theorem generic_near (G : list (point d -> R)) q t xs : In t tets -> inside_closed (geo t) q ->
  (forall g, In g G -> affine g /\ 0 < g q) -> (forall x, In x xs -> mesh_generic x) ->
  exists y, inside (geo t) y /\ (forall g, In g G -> 0 < g y) /\ mesh_same_side q y /\
    mesh_generic y /\ forall x, In x xs -> mesh_generic_pair x y.
Proof.
  intros Ht Qt HG Hxs. set (sides := side_functions tets facets coordinate q).
  assert (HGS : forall g, In g (G ++ sides) -> affine g /\ 0 < g q).
  { intros g Hg. apply in_app_or in Hg. destruct Hg as [Hg|Hg]; [auto|].
    now apply (side_functions_in mesh_cells q). }
  destruct (nearby (G ++ sides) q (barycentre (geo t)) HGS) as (e & He & K).
  destruct (pick_generic mesh_cells (cell_functions facets coordinate t ++ G ++ sides)
    (mix q (barycentre (geo t)) e) xs Hxs) as (y & Y1 & Y2 & Y3).
  - intros g Hg. apply in_app_or in Hg. destruct Hg as [Hg|Hg].
    + apply (cell_functions_in mesh_cells t); [assumption| |assumption]. apply in_cell_inside.
      intros i Hi. rewrite (affine_mix _ _ _ _ (bary_affine (geo t) i Hi)).
      pose proof (barycentre_inside (geo t) i Hi). specialize (Qt i Hi). nra.
    + split; [now apply HGS|]. apply K; [lra|assumption].
  - exists y. split; [|split; [|split; [|split]]]; auto.
    + apply in_cell_inside, cell_functions_out. intros; apply Y1, in_or_app; now left.
    + intros; apply Y1, in_or_app; right; apply in_or_app; now left.
    + apply side_functions_out. intros; apply Y1, in_or_app; right; apply in_or_app; now right.
Qed.

(** ** Walks *)

Definition inside_hull (p : point d) : Prop :=
  forall t i, In t tets -> (i <= d)%nat -> hull t i -> 0 <= bary (geo t) i p.

Lemma passes_matched x y t i s : inside_hull y -> In t tets -> mesh_passes x y t i s ->
  exists u j, adj t i u j.
Proof.
  intros Hy Ht (Ii & Neg & _). unfold coordinate in Neg. apply in_seq_d in Ii.
  destruct (matched_or_hull _ _ _ _ mesh t i Ht Ii) as [A|H]; [assumption|].
  specialize (Hy t i Ht Ii H). lra.
Qed.

(** What is reflexive and transitive and holds across each crossing from t to u holds from a
    simplex that contains x to one that contains y.  What [mesh_passes] adds may be ignored, or
    used to know where the crossing is: on the segment, in the relative interior of the facet. *)
Theorem mesh_walk_passing (Rl : T -> T -> Prop) x y t :
  mesh_generic y -> mesh_generic_pair x y -> inside_hull y -> In t tets -> inside (geo t) x ->
  (forall t, Rl t t) -> (forall a b c, Rl a b -> Rl b c -> Rl a c) ->
  (forall t i u j s, In t tets -> In u tets -> adj t i u j -> mesh_passes x y t i s ->
     0 < bary (geo u) j y -> Rl t u) ->
  exists t', In t' tets /\ inside (geo t') y /\ Rl t t'.
Proof.
  intros Gy Gxy Hy Ht Xt Refl Trans Cross.
  destruct (cells_walk mesh_cells Rl x y t Gy Gxy Ht) as (t' & Ht' & Yt' & R); auto.
  - now apply in_cell_inside.
  - intros a i s Ha. now apply passes_matched.
  - intros a i u j s Ha Hu _ A P Pos. now apply (Cross a i u j s).
  - exists t'. split; [assumption|]. split; [now apply in_cell_inside|assumption].
Qed.

Theorem mesh_walk (Rl : T -> T -> Prop) x y t :
  mesh_generic y -> mesh_generic_pair x y -> inside_hull y -> In t tets -> inside (geo t) x ->
  (forall t, Rl t t) -> (forall a b c, Rl a b -> Rl b c -> Rl a c) ->
  (forall t i u j, In t tets -> In u tets -> adj t i u j -> 0 < bary (geo u) j y -> Rl t u) ->
  exists t', In t' tets /\ inside (geo t') y /\ Rl t t'.
Proof.
  intros Gy Gxy Hy Ht Xt Refl Trans Cross.
  apply (mesh_walk_passing Rl x y t); auto. intros a i u j s Ha Hu A _.
  now apply (Cross a i u j).
Qed.

(** ** The hull facets support the vertices *)

Context {P : point d -> Prop}.
Hypothesis vertices_in : forall t i, In t tets -> (i <= d)%nat -> P (vertex (geo t) i).
Hypothesis support : supporting tets geo hull P.

Lemma inside_inside_hull t p : In t tets -> inside_closed (geo t) p -> inside_hull p.
Proof.
  intros Ht I u i Hu Hi H. apply (inside_pos (geo t)); [now apply bary_affine|assumption|].
  intros k Hk. apply (support u i Hu Hi H). auto.
Qed.
Lemma inside_weaken t p : inside (geo t) p -> inside_closed (geo t) p.
Proof. intros I i Hi. left. auto. Qed.

(** Each point on the inner side of all hull facets is in a simplex. *)
Theorem mesh_covers p : tets <> [] -> inside_hull p ->
  exists t, In t tets /\ inside_closed (geo t) p.
Proof.
  intros Ne Hp.
  assert (Dec : forall t, inside_closed (geo t) p \/
    exists i, In i (facets t) /\ coordinate t i p < 0).
  { intros t. unfold inside_closed.
    destruct (Exists_dec (fun i => bary (geo t) i p < 0) (facets t)) as [E|N].
    - intros i. apply Rlt_dec.
    - right. now apply Exists_exists in E.
    - left. intros i Hi. destruct (Rle_dec 0 (bary (geo t) i p)); [assumption|exfalso].
      apply N, Exists_exists. exists i. split; [now apply in_seq_d|lra]. }
  assert (All : forall l, (exists t, In t l /\ inside_closed (geo t) p) \/
    (forall t, In t l -> exists i, In i (facets t) /\ coordinate t i p < 0)).
  { induction l as [|a l IH]; [right; intros t []|].
    destruct (Dec a) as [I|O]; [left; exists a; split; [now left|assumption]|].
    destruct IH as [(t & ? & ?)|IH]; [left; exists t; split; [now right|assumption]|].
    right. intros t [<-|Ht]; auto. }
  destruct (All tets) as [|Out]; [assumption|exfalso]. clear Dec All.
  assert (exists t0, In t0 tets) as (t0 & Ht0).
  { destruct tets as [|t0 l]; [congruence|]. exists t0. now left. }
  destruct (outside_functions mesh_cells p (fun _ => True)) as (G & G1 & G2); auto.
  destruct (generic_near [] (barycentre (geo t0)) t0 []) as (x & Xt & _ & _ & Gx & _).
  { assumption. } { apply inside_weaken, barycentre_inside. } { intros g []. } { intros g []. }
  destruct (nearby G p x G1) as (e & He & K).
  set (z0 := mix p x e). set (sides := side_functions tets facets coordinate z0).
  destruct (pick_generic mesh_cells (G ++ sides) z0 [x]) as (z & Z1 & Z2 & Z3).
  { intros ? [<-|[]]; assumption. }
  { intros g Hg. apply in_app_or in Hg. destruct Hg as [Hg|Hg].
    - split; [now apply G1|]. apply K; [lra|assumption].
    - now apply (side_functions_in mesh_cells z0). }
  assert (Zs : mesh_same_side z0 z)
    by (apply side_functions_out; intros; apply Z1, in_or_app; now right).
  assert (Hz : inside_hull z).
  { intros t i Ht Hi H. left. apply (same_side_pos z0 z t i Zs Ht); [now apply in_seq_d|].
    unfold coordinate, z0. rewrite (affine_mix _ _ _ _ (bary_affine (geo t) i Hi)).
    pose proof (Hp t i Ht Hi H) as Pp.
    pose proof (inside_inside_hull t0 x Ht0 (inside_weaken t0 x Xt) t i Ht Hi H) as Px.
    pose proof (Gx t i Ht (proj2 (in_seq_d i) Hi)) as Nx. unfold coordinate in Nx.
    assert (0 < bary (geo t) i x) by lra. nra. }
  destruct (mesh_walk (fun _ _ => True) x z t0) as (t & Ht & It & _); auto.
  { apply Z3. now left. }
  destruct (G2 z (fun g Hg => Z1 g (in_or_app _ _ _ (or_introl Hg))) t Ht Logic.I) as (i & Ii & Ni).
  apply in_seq_d in Ii. specialize (It i Ii). unfold coordinate in Ni. lra.
Qed.

(** ** No simplices overlap *)

Hypothesis dec : forall a b : T, {a = b} + {a <> b}.
Context {o : point d} {t0 : T}.
Hypothesis once : covered_once tets geo o t0.

Theorem mesh_disjoint t u p : In t tets -> In u tets -> inside (geo t) p -> inside (geo u) p ->
  t = u.
Proof.
  intros Ht Hu It Iu. destruct once as (Ht0 & O0 & Out).
  apply (cells_disjoint mesh_cells dec o t0 []) with (y := p); auto;
    try now apply in_cell_inside.
  - intros a Ha Na. destruct (Out a Ha Na) as (i & Hi & Neg). exists i.
    split; [now apply in_seq_d|assumption].
  - intros x y a i s _ Ha Y. apply in_cell_inside in Y. apply passes_matched; [|assumption].
    apply (inside_inside_hull t0); [assumption|now apply inside_weaken].
  - intros g [].
Qed.

(** In one step of the walk: what the carrier of q is in t, it is in u. *)
Lemma carrier_crossing q x y s t i u j : In t tets -> In u tets -> adj t i u j ->
  mesh_same_side q x -> mesh_same_side q y -> mesh_passes x y t i s ->
  inside_closed (geo t) q ->
  inside_closed (geo u) q /\ forall k, (k <= d)%nat -> 0 < bary (geo t) k q ->
    exists l, (l <= d)%nat /\ vertex (geo t) k = vertex (geo u) l /\ 0 < bary (geo u) l q.
Proof.
  intros Ht Hu A Sx Sy (Ii & _ & Hs & Z & Pos) Q. apply in_seq_d in Ii.
  pose proof (matched_opposite _ _ _ _ mesh t i u j Ht A) as O.
  assert (Sz : mesh_same_side q (mix x y s)).
  { intros a k Ha Ik N. specialize (Sx a k Ha Ik N). specialize (Sy a k Ha Ik N).
    rewrite (affine_mix (coordinate a k)) by now apply (wall_affine _ _ _ _ mesh_cells). nra. }
  unfold coordinate in Z.
  assert (Zq : bary (geo t) i q = 0).
  { destruct (Req_dec (bary (geo t) i q) 0) as [|N]; [assumption|].
    specialize (Sz t i Ht (proj2 (in_seq_d i) Ii) N). unfold coordinate in Sz.
    rewrite Z in Sz. lra. }
  assert (Qu : inside_closed (geo u) q).
  { intros l Hl. destruct (Nat.eq_dec l j) as [->|N].
    - destruct (opposite_multiple _ _ _ _ O) as (c & _ & ->). rewrite Zq. lra.
    - apply (same_side_closed q (mix x y s) u l Sz Hu); [now apply in_seq_d|].
      apply (opposite_through (geo t) i (geo u) j); auto.
      intros k Hk. apply Pos. now apply in_seq_d. }
  split; [assumption|]. intros k Hk Pk. assert (Nk : k <> i) by (intros ->; lra).
  destruct O as (_ & _ & TU & _). destruct (TU k Hk Nk) as (l & Hl & _ & E). exists l.
  split; [assumption|]. split; [assumption|].
  rewrite (interpolation (geo t) (bary (geo u) l) q (bary_affine (geo u) l Hl)).
  apply sum_pos with k; [|now apply in_seq_d|rewrite E, bary_own; auto; lra].
  intros m Hm. apply in_seq_d in Hm. destruct (Nat.eq_dec m i) as [->|Nm]; [rewrite Zq; lra|].
  apply Rmult_le_pos; [now apply Q|]. destruct (TU m Hm Nm) as (m' & Hm' & _ & ->).
  rewrite bary_vertex by assumption. destruct (Nat.eq_dec l m'); lra.
Qed.

(** A point of two simplices has the same carrier in both. *)
Theorem mesh_face_to_face t u : In t tets -> In u tets -> agree (geo t) (geo u).
Proof.
  intros Ht Hu q Qt Qu.
  destruct (generic_near [] q t []) as (x & Xi & _ & Xs & Xg & _); auto.
  { intros g []. } { intros ? []. }
  destruct (generic_near [] q u [x]) as (y & Yi & _ & Ys & Yg & Yp); auto.
  { intros g []. } { intros ? [<-|[]]; assumption. }
  destruct (mesh_walk_passing (fun a b => inside_closed (geo a) q -> inside_closed (geo b) q /\
      forall k, (k <= d)%nat -> 0 < bary (geo a) k q ->
        exists l, (l <= d)%nat /\ vertex (geo a) k = vertex (geo b) l /\ 0 < bary (geo b) l q)
    x y t) as (u' & Hu' & Yu' & C); auto.
  - apply Yp. now left.
  - apply (inside_inside_hull u); [assumption|now apply inside_weaken].
  - intros a Q. split; [assumption|]. intros k Hk Pk. exists k. auto.
  - intros a b c Hab Hbc Q. destruct (Hab Q) as [Qb Sb]. destruct (Hbc Qb) as [Qc Sc].
    split; [assumption|]. intros k Hk Pk. destruct (Sb k Hk Pk) as (l & Hl & E & Pl).
    destruct (Sc l Hl Pl) as (m & Hm & E' & Pm). exists m. split; [assumption|]. split; congruence.
  - intros a i b j s Ha Hb A Ps _ Q. now apply (carrier_crossing q x y s a i b j).
  - rewrite <- (mesh_disjoint u' u y) by assumption. now apply C.
Qed.

(** Simplices with the same vertices are the same. *)
Lemma mesh_simplices_different t u : In t tets -> In u tets ->
  same (vertices (geo t)) (vertices (geo u)) -> t = u.
Proof.
  intros Ht Hu E.
  destruct (generic_near [] (barycentre (geo t)) t []) as (y & Y & _ & _ & G & _); auto.
  { apply inside_weaken, barycentre_inside. } { intros g []. } { intros ? []. }
  apply (mesh_disjoint t u y); auto. apply generic_inside; [assumption..|].
  apply conv_vertices. apply (conv_same (vertices (geo t))); [assumption|].
  now apply conv_vertices, inside_weaken.
Qed.
End Mesh.
Arguments facets {d T} t.
Arguments coordinate {d T} geo t.
Arguments mesh_generic {d T} tets geo x.
Arguments mesh_generic_pair {d T} tets geo x y.
Arguments mesh_passes {d T} geo x y t i s.
Arguments mesh_same_side {d T} tets geo q z.
Arguments inside_hull {d T} tets geo hull p.

(** The simplices of a matched mesh with supporting hull facets and a point that is covered once
    form, with their faces, a complex whose union is conv S. *)
Theorem mesh_fills {d : nat} {T : Type} {tets : list T} {geo : T -> frame d}
    {adj : T -> nat -> T -> nat -> Prop} {hull : T -> nat -> Prop}
    (X : list (point d)) (o : point d) (t0 : T) :
  (forall a b : T, {a = b} + {a <> b}) -> NoDup tets -> matched tets geo adj hull ->
  (forall t i, In t tets -> (i <= d)%nat -> In (vertex (geo t) i) X) ->
  supporting tets geo hull (fun p => In p X) -> covered_once tets geo o t0 ->
  fills X (map (fun t => vertices (geo t)) tets).
Proof.
  intros dec N M V Sup O. change (map _ tets) with (simplices tets geo).
  split; [|split; [|split; [|split]]].
  - apply simplices_length.
  - apply frames_complex. intros; now apply (mesh_face_to_face M V Sup dec O).
  - apply simplices_different; [assumption|]. now apply (mesh_simplices_different M V Sup dec O).
  - intros s Hs v Hv. apply in_simplices in Hs. destruct Hs as (t & Ht & ->).
    apply in_vertices in Hv. destruct Hv as (i & Hi & ->). auto.
  - intros q. split.
    + intros C. destruct (mesh_covers M V Sup q) as (t & Ht & I).
      * intros E. destruct O as [H _]. now rewrite E in H.
      * intros t i Ht Hi H. apply (affine_conv (bary (geo t) i) X); auto.
        now apply bary_affine.
      * exists (vertices (geo t)). split; [apply in_simplices; eauto|now apply conv_vertices].
    + intros (s & Hs & C). apply in_simplices in Hs. destruct Hs as (t & Ht & ->).
      apply (conv_incl (vertices (geo t))); [|assumption]. intros v Hv. apply in_vertices in Hv.
      destruct Hv as (i & Hi & ->). auto.
Qed.
