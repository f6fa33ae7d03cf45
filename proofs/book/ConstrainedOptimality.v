(** * Constrained Delaunay triangulations: only one, and the best  (Book: Propositions 4.12, 4.13)

    Two simplices of two triangulations of a domain have an interior point in common.  From there
    one sees the vertices of both: so neither witness plane is above the other if both are
    constrained Delaunay, and the one that is is not above the other that need not be. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Domains DomainRules Vectors Affine Frame Matched Faces
  Facets Walk Generic Mesh.
From Circumspect Require Import Independence Adjacency LiftingMap DelaunayLemma Nearest Optimality.
From Circumspect Require Import Combinations Solid Necessary Visible ConstrainedLemma.
Import ListNotations.
Open Scope R_scope.

Lemma agree_witness {d} (t u : frame d) p h : agree t u -> inside_closed t p -> inside_closed u p ->
  witness h t p <= witness h u p.
Proof.
  intros Ag Pt Pu. pose proof (conv_carrier t p Pt) as C.
  apply (conv_le (carrier t p)); auto using witness_affine. intros v Hv. apply in_carrier in Hv.
  destruct Hv as (i & Hi & L & ->). destruct (Ag p Pt Pu i Hi L) as (k & Hk & E & _).
  rewrite (witness_vertex h t i Hi), E, witness_vertex by assumption. lra.
Qed.

Section Two.
Context {d : nat}.
Hypothesis two : (2 <= d)%nat.
Variable P : domain d.
Hypothesis proper : proper_domain P.
Notation V := (domain_vertices P).

Section Frames.
Variables (T U : list (simplex d)) (ts us : list (frame d)).
Hypothesis cdt_T : solid_cdt P T.
Hypothesis tri_U : solid_plc_triangulation P U.
Hypothesis are_T : map vertices ts = T.
Hypothesis are_U : map vertices us = U.
Let StT : solid_triangulation P T := proj1 (proj1 cdt_T).
Let StU : solid_triangulation P U := proj1 tri_U.
Let in_U u : In u us -> In (vertices u) U := framed_member U us are_U u.
Let in_T t : In t ts -> In (vertices t) T := framed_member T ts are_T t.

(** From inside a simplex one sees its vertices. *)
Lemma vertices_seen u y v : In u us -> inside u y -> In v (vertices u) -> visible P y v.
Proof.
  intros Iu Iy Iv. apply (Visible.seen P U StU (vertices u)).
  - now apply in_U.
  - apply conv_vertices. intros k Hk. left. now apply Iy.
  - intros _. apply conv_point. apply (proj2 tri_U (vertices u)); auto.
  - intros X IX s Hs. apply (low_misses_interior P U StU us are_U two proper X u _ IX Iu).
    intros k Hk. change (between (d := d)) with (mix (d := d)).
    rewrite affine_mix by now apply bary_affine.
    apply in_vertices in Iv. destruct Iv as (i & Hi & ->). rewrite bary_vertex by assumption.
    specialize (Iy k Hk).
    destruct (Nat.eq_dec k i); nra.
Qed.
Lemma vertex_not_below t u y v : In t ts -> In u us -> inside t y -> inside u y ->
  In v (vertices u) ->
  witness norm2 t v <= norm2 v.
Proof.
  intros It Iu Yt Yu Iv.
  destruct (proj2 cdt_T (vertices t) (in_T t It)) as (_ & _ & c & r2 & C & Empty).
  destruct (Rle_dec (witness norm2 t v) (norm2 v)) as [|N]; [assumption|exfalso]. apply (Empty v y).
  - apply (proj2 tri_U (vertices u)); auto.
  - now apply inside_strictly.
  - now apply (vertices_seen u y v).
  - apply (in_ball_below_witness t c r2 v C). lra.
Qed.
Lemma interior_witness_le t u y : In t ts -> In u us -> inside t y -> inside u y ->
  witness norm2 t y <= witness norm2 u y.
Proof.
  intros It Iu Yt Yu. apply (conv_le (vertices u)); try apply witness_affine.
  - intros v Iv. pose proof (vertex_not_below t u y v It Iu Yt Yu Iv) as L.
    apply in_vertices in Iv. destruct Iv as (i & Hi & ->).
    now rewrite (witness_vertex norm2 u) by assumption.
  - apply conv_vertices. intros i Hi. left. auto.
Qed.

(** The same where the simplices only touch. *)
Theorem witness_le t u p : In t ts -> In u us -> inside_closed t p -> inside_closed u p ->
  witness norm2 t p <= witness norm2 u p.
Proof.
  intros It Iu C C'. pose proof (complex_matched ts (fun t => t) ltac:(lia)
    (frames_agree P T StT ts are_T) (frames_different P T StT ts are_T)) as MT.
  set (z := barycentre u).
  assert (In_u : forall s, 0 < s <= 1 -> inside u (mix p z s)).
  { intros s Hs i Hi. rewrite affine_mix by now apply bary_affine. specialize (C' i Hi).
    pose proof (barycentre_inside u i Hi) as B. fold z in B. nra. }
  destruct (towards (fun t => t) p z ts) as [(m & Im & Pm & Lead)|(s & Hs & K)].
  2: { exfalso. destruct (proj1 (covers P T StT (mix p z s))) as (r & Hr & Cr).
       { apply (covers P U StU). exists (vertices u). split; [now apply in_U|]. apply conv_vertices.
         intros i Hi. left. apply In_u; [lra|assumption]. }
       rewrite <- are_T in Hr. apply in_map_iff in Hr. destruct Hr as (m & <- & Im).
       apply conv_vertices in Cr.
       exact (K s ltac:(lra) m Im Cr). }
  pose proof (agree_witness t m p norm2 (frames_agree P T StT ts are_T t m It Im) C Pm) as Le.
  enough (witness norm2 m p <= witness norm2 u p) by lra.
  destruct (Rle_dec (witness norm2 m p) (witness norm2 u p)) as [|Bad]; [assumption|exfalso].
  set (g q := 1 * witness norm2 m q + (-1) * witness norm2 u q).
  assert (Ag : affine g) by (apply affine_combine; apply witness_affine).
  destruct (nearby (g :: positive_at (fun i => bary m i) p (seq 0 (S d))) p z) as (s & Hs & Near).
  { intros f [<-|Hf]; [split; [assumption|unfold g; lra]|].
    revert f Hf. apply positive_at_in. intros i Hi. apply bary_affine. now apply in_seq_d. }
  specialize (Near s ltac:(lra)). set (p1 := mix p z s) in *.
  assert (P1 : inside_closed m p1).
  { intros i Hi. destruct (Req_dec (bary m i p) 0) as [Z|NZ].
    - specialize (Lead i Hi Z). unfold p1. rewrite affine_mix, Z by now apply bary_affine. nra.
    - left. apply (positive_at_out (fun i => bary m i) p (seq 0 (S d)) p1).
      + intros f Hf. apply Near. now right.
      + now apply in_seq_d.
      + specialize (Pm i Hi). lra. }
  destruct (generic_near MT (g :: map (bary u) (seq 0 (S d))) p1 m []) as (y & Ym & Gy & _).
  { assumption. } { assumption. }
  { intros f [<-|Hf]; [split; [assumption|apply Near; now left]|]. apply in_map_iff in Hf.
    destruct Hf as (i & <- & Hi). apply in_seq_d in Hi.
    split; [now apply bary_affine|]. apply In_u; [lra|assumption]. }
  { intros x []. }
  assert (Yu : inside u y).
  { intros i Hi. apply Gy. right. apply in_map. now apply in_seq_d. }
  pose proof (interior_witness_le m u y Im Iu Ym Yu) as W.
  specialize (Gy g (or_introl eq_refl)). unfold g in Gy. lra.
Qed.
(** A simplex of the one and one of the other that have interior points in common. *)
Lemma common_interior t : In t ts -> exists u y, In u us /\ inside t y /\ inside u y.
Proof.
  intros It. pose proof (complex_matched us (fun t => t) ltac:(lia)
    (frames_agree P U StU us are_U) (frames_different P U StU us are_U)) as MU.
  destruct (pick_generic (mesh_cells MU) (map (bary t) (seq 0 (S d))) (barycentre t) [])
    as (y & Y1 & Y2 & _).
  { intros x []. }
  { intros g Hg. apply in_map_iff in Hg. destruct Hg as (i & <- & Hi). apply in_seq_d in Hi.
    split; [now apply bary_affine|now apply barycentre_inside]. }
  assert (Yt : inside t y) by (intros i Hi; apply Y1, in_map; now apply in_seq_d).
  destruct (proj1 (covers P U StU y)) as (u & Hu & C).
  { apply (covers P T StT). exists (vertices t). split; [now apply in_T|]. apply conv_vertices.
    intros i Hi. left. auto. }
  rewrite <- are_U in Hu. apply in_map_iff in Hu. destruct Hu as (b & <- & Ib).
  apply conv_vertices in C.
  exists b, y. split; [assumption|]. split; [assumption|].
  now apply (generic_inside (tets := us) (geo := fun t => t)).
Qed.
End Frames.

(** ** Proposition 4.12 *)

Theorem generic_cdt T U : generic V -> solid_cdt P T -> solid_cdt P U -> forall t : simplex d,
  In t T -> exists u, In u U /\ same t u.
Proof.
  intros G CT CU s Is. destruct (all_framed P T (proj1 (proj1 CT))) as (ts & are_T).
  destruct (all_framed P U (proj1 (proj1 CU))) as (us & are_U).
  pose proof Is as Is'. rewrite <- are_T in Is'. apply in_map_iff in Is'.
  destruct Is' as (t & <- & It).
  destruct (common_interior T U ts us CT (proj1 CU) are_T are_U t It) as (u & y & Iu & Yt & Yu).
  pose proof (interior_witness_le T U ts us CT (proj1 CU) are_T are_U t u y It Iu Yt Yu) as L1.
  pose proof (interior_witness_le U T us ts CU (proj1 CT) are_U are_T u t y Iu It Yu Yt) as L2.
  assert (Ut : In (vertices u) U) by now apply (framed_member U us are_U).
  exists (vertices u). split; [assumption|].
  assert (I : incl (vertices u) (vertices t)).
  { intros v Hv. destruct (in_points v (vertices t)) as [|N]; [assumption|exfalso].
    assert (E : witness norm2 t v = norm2 v).
    { pose proof Hv as Hv'. apply in_vertices in Hv. destruct Hv as (i & Hi & ->).
      pose proof (above_witness norm2 u (witness norm2 t) y (witness_affine _ _)) as E.
      assert (Ter : forall j, In j (seq 0 (S d)) ->
        0 <= bary u j y * (norm2 (vertex u j) - witness norm2 t (vertex u j))).
      { intros j Hj. apply in_seq_d in Hj. apply Rmult_le_pos; [left; auto|].
        pose proof (vertex_not_below T U ts us CT (proj1 CU) are_T are_U t u y (vertex u j) It Iu Yt
          Yu) as B.
        specialize (B ltac:(apply in_vertices; eauto)). lra. }
      assert (Z : sum (S d) (fun j =>
        bary u j y * (norm2 (vertex u j) - witness norm2 t (vertex u j))) = 0).
      { unfold sum in *. rewrite (sum_ext _ _ (fun j => (-1) * (bary u j y *
          (witness norm2 t (vertex u j) - norm2 (vertex u j))))) by (intros; ring).
          rewrite sum_scale, <- E. lra. }
      destruct (Req_dec (witness norm2 t (vertex u i)) (norm2 (vertex u i))) as [|NE];
        [assumption|exfalso].
      assert (0 < sum (S d) (fun j =>
        bary u j y * (norm2 (vertex u j) - witness norm2 t (vertex u j)))); [|lra].
      apply (sum_pos _ _ i Ter); [now apply in_seq_d|]. apply Rmult_lt_0_compat; [auto|].
      pose proof (Ter i ltac:(now apply in_seq_d)). pose proof (Yu i Hi). nra. }
    apply (G (v :: vertices t)).
    - constructor; [assumption|apply vertices_NoDup].
    - intros w [<-|Hw];
        [now apply (proj2 (proj1 CU) (vertices u))|now apply (proj2 (proj1 CT) (vertices t))].
    - cbn [length]. now rewrite vertices_length.
    - destruct (circumball_frame t) as (c & r2 & C' & Pl). exists c, r2.
      intros w [<-|Hw]; [|now apply C']. pose proof (ball_plane_power c r2 v) as Pw.
      rewrite Pl, E in Pw. lra. }
  split; [|assumption]. apply NoDup_length_incl; [apply vertices_NoDup| |assumption].
  rewrite !vertices_length. constructor.
Qed.
Theorem proposition_4_12 T U : generic V -> solid_cdt P T -> solid_cdt P U -> same_simplices T U.
Proof. intros G CT CU. split; now apply generic_cdt. Qed.

(** ** Proposition 4.13 *)

Lemma interpolant (t : frame d) a b p : interpolates norm2 (vertices t) a b ->
  plane a b p = witness norm2 t p.
Proof.
  intros I. revert p. apply witness_unique; [apply affine_plane|]. intros i Hi.
  apply I, in_vertices. eauto.
Qed.
Theorem proposition_4_13_error T U p e e' : solid_cdt P T -> solid_plc_triangulation P U ->
  interpolation_error norm2 T p e -> interpolation_error norm2 U p e' -> e <= e'.
Proof.
  intros CT TU (t & a & b & It & C & I & ->) (u & a' & b' & Iu & C' & I' & ->).
  destruct (all_framed P T (proj1 (proj1 CT))) as (ts & are_T).
  destruct (all_framed P U (proj1 TU)) as (us & are_U).
  pose proof It as It'. rewrite <- are_T in It'. apply in_map_iff in It'.
  destruct It' as (g & <- & Ig).
  pose proof Iu as Iu'. rewrite <- are_U in Iu'. apply in_map_iff in Iu'.
  destruct Iu' as (h & <- & Ih).
  rewrite (interpolant g a b p I), (interpolant h a' b' p I'). apply conv_vertices in C, C'.
  pose proof (witness_le T U ts us CT TU are_T are_U g h p Ig Ih C C'). lra.
Qed.
(** For every simplex of a CDT each triangulation has one with a min-containment ball that is no
    smaller. *)
Theorem proposition_4_13_balls T U t c r2 : solid_cdt P T -> solid_plc_triangulation P U ->
  In t T -> min_containment_ball t c r2 ->
  exists u, In u U /\ forall c' r2', contains c' r2' u -> r2 <= r2'.
Proof.
  intros CT TU It [_ Least].
  destruct (all_framed P T (proj1 (proj1 CT))) as (ts & are_T).
  destruct (all_framed P U (proj1 TU)) as (us & are_U).
  pose proof It as It'. rewrite <- are_T in It'. apply in_map_iff in It'.
  destruct It' as (g & <- & Ig).
  destruct (circumball_frame g) as (o & R2 & O & Pl). destruct (nearest_point g o) as (q & Cq & Nq).
  destruct (proposition_4_6 (vertices g) o R2 q O Cq Nq) as [B _].
  destruct (proj1 (covers P U (proj1 TU) q)) as (u & Iu & Cu).
  { apply (covers P T (proj1 (proj1 CT))). eauto. }
  pose proof Iu as Iu'. rewrite <- are_U in Iu'. apply in_map_iff in Iu'.
  destruct Iu' as (h & <- & Ih).
  exists (vertices h). split; [assumption|]. intros c' r2' C'.
  destruct (Least q (R2 - dist2 o q) B) as [L _]. apply conv_vertices in Cq as Iq.
  pose proof (witness_le T U ts us CT TU are_T are_U g h q Ig Ih Iq (proj1 (conv_vertices h q) Cu))
    as W.
  pose proof (ball_plane_power o R2 q) as Po. rewrite Pl in Po.
  assert (K : witness norm2 h q <= plane (scale 2 c') (r2' - norm2 c') q).
  { apply (conv_le (vertices h)); [apply witness_affine|apply affine_plane| |assumption].
    intros v Iv. pose proof (C' v Iv) as D. apply in_vertices in Iv. destruct Iv as (i & Hi & ->).
    rewrite witness_vertex by assumption. pose proof (ball_plane_power c' r2' (vertex h i)) as Pw.
    unfold ball_plane in Pw. lra. }
  pose proof (ball_plane_power c' r2' q) as Pq. unfold ball_plane in Pq.
  pose proof (norm2_nonneg (minus c' q)) as Nn.
  fold (dist2 c' q) in Nn. lra.
Qed.
End Two.
