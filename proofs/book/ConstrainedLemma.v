(** * The Constrained Delaunay Lemma  (Book: Lemma 4.10)

    What can be seen from a point of a simplex that is in no wall is not below the simplex's witness
    plane, if the facets in no wall are locally Delaunay ([Sight.v]): so these facets, and the
    simplices, are constrained Delaunay.  The other way round, from inside a facet in no wall one
    sees the apexes of the simplices that share it, and from inside the one, near the facet, the
    apex of the other ([Visible.v]).

    The domain need not be a piecewise linear complex: that it is what its walls enclose
    suffices. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Domains DomainRules Vectors Affine Frame Matched Faces
  Facets Independence Adjacency.
From Circumspect Require Import LiftingMap DelaunayLemma BookLemma.
From Circumspect Require Import Combinations Lists Solid Necessary Visible Sight.
Import ListNotations.
Open Scope R_scope.

(** ** Simplices respect what is a union of simplices *)

Lemma union_respected {d} (T : list (simplex d)) X t : simplicial_complex (faces_of T) ->
  union_of_simplices T X -> faces_of T t -> union_of_faces (fun q => X q /\ conv t q) t.
Proof.
  intros (_ & _ & M) (L & HL & E) Ht.
  assert (K : exists F, (forall f, In f F -> incl f t) /\
    forall q, (exists s, In s L /\ conv s q) /\ conv t q <-> exists f, In f F /\ conv f q).
  { clear E. induction L as [|s L IH].
    - exists []. split; [intros f []|]. intros q.
      split; [intros [(s & [] & _) _]|intros (f & [] & _)].
    - destruct IH as (F & IF & E); [intros; apply HL; now right|].
      destruct (M s t (HL s (or_introl eq_refl)) Ht) as (f & Is & It & C). exists (f :: F). split.
      + intros g [<-|Hg]; auto.
      + intros q. split.
        * intros [(r & [<-|Hr] & Cr) Ct]; [exists f; split; [now left|auto]|].
          destruct (proj1 (E q)) as (g & Hg & Cg); [split; eauto|]. exists g.
          split; [now right|assumption].
        * intros (g & [<-|Hg] & Cg).
          -- split; [|now apply (conv_incl f)]. exists s. split; [now left|now apply (conv_incl f)].
          -- destruct (proj2 (E q)) as [(r & Hr & Cr) Ct]; [eauto|]. split; [|assumption].
             exists r. split; [now right|assumption]. }
  destruct K as (F & IF & K). exists F. split; [assumption|]. intros q. rewrite <- K, E. tauto.
Qed.
Lemma simplices_respect {d} (P : domain d) T t : solid_triangulation P T -> faces_of T t ->
  respects P t.
Proof.
  intros (_ & _ & Cx & _ & Un & Eq) Ht. split.
  - intros q C. apply Eq. destruct Ht as (_ & _ & s & Is & I). exists s. split; [assumption|].
    now apply (conv_incl t).
  - intros X IX. apply (union_respected T); auto.
Qed.
Lemma strictly_inside_frame {d} (t : frame d) q : strictly_inside (vertices t) q -> inside t q.
Proof.
  intros [C N]. apply conv_vertices in C. pose proof (conv_carrier t q C) as K.
  pose proof (N _ (carrier_incl t q) K) as I. intros i Hi.
  assert (V : In (vertex t i) (Faces.carrier t q)) by (apply I, in_vertices; eauto).
  apply in_carrier in V. destruct V as (k & Hk & L & E). apply vertex_inj in E; auto. now subst.
Qed.

Lemma inside_strictly {d} (t : frame d) q : inside t q -> strictly_inside (vertices t) q.
Proof.
  intros I. split; [apply conv_vertices; intros i Hi; left; auto|]. intros f If C v Hv.
  apply (conv_face t f q If) in C. apply in_vertices in Hv. destruct Hv as (i & Hi & ->).
  apply C; auto.
Qed.

(** ** Inside a facet *)

Section InsideFacet.
Context {d : nat}.
Lemma centre_in_facet (t : frame d) i : (1 <= d)%nat -> (i <= d)%nat ->
  in_facet t i (facet_centre t i).
Proof.
  intros D Hi. split; [now apply bary_facet_centre|].
  intros k Hk N. apply bary_facet_centre_other; auto.
Qed.
Lemma conv_facet (t : frame d) i q : (i <= d)%nat -> bary t i q = 0 -> inside_closed t q ->
  conv (facet_of t i) q.
Proof.
  intros Hi Z I. apply (conv_incl (carrier t q)); [|now apply conv_carrier].
  intros v Hv. apply in_carrier in Hv. destruct Hv as (k & Hk & L & ->).
  apply in_facet_of; [assumption|]. exists k. repeat split; auto. intros ->. lra.
Qed.
(** A point of the facet that is in no smaller face. *)
Lemma strictly_in_facet (t : frame d) i q : (i <= d)%nat -> strictly_inside (facet_of t i) q ->
  in_facet t i q.
Proof.
  intros Hi [C Least]. pose proof C as C'. apply (conv_face t) in C'; [|now apply facet_of_incl].
  destruct C' as [I Car]. pose proof (conv_carrier t q I) as K.
  assert (Z : bary t i q = 0).
  { specialize (I i Hi). destruct (Req_dec (bary t i q) 0) as [|N]; [assumption|exfalso].
    apply (not_in_facet_of t i Hi), Car; [assumption|lra]. }
  split; [assumption|]. intros k Hk N.
  assert (Sub : incl (carrier t q) (facet_of t i)).
  { intros v Iv. apply in_carrier in Iv. destruct Iv as (m & Hm & Pm & ->). now apply Car. }
  assert (Iv : In (vertex t k) (carrier t q)) by (apply (Least _ Sub K), in_facet_of; eauto).
  apply in_carrier in Iv. destruct Iv as (m & Hm & Pm & E). apply vertex_inj in E; auto. now subst.
Qed.
Lemma in_facet_strictly (t : frame d) i q : (i <= d)%nat -> in_facet t i q ->
  strictly_inside (facet_of t i) q.
Proof.
  intros Hi Fq. split; [apply conv_facet; [assumption|apply Fq|now apply in_facet_closed with i]|].
  intros f If Cf v Iv. apply in_facet_of in Iv; [|assumption]. destruct Iv as (k & Hk & N & ->).
  apply (conv_face t) in Cf; [|now apply incl_tran with (facet_of t i); [|apply facet_of_incl]].
  apply Cf; [assumption|]. now apply Fq.
Qed.
End InsideFacet.

(** The vertices of the mesh are [V]. *)
Definition mesh_vertices {d} (T : list (simplex d)) (V : list (point d)) : Prop :=
  forall v, In v V <-> exists t, In t T /\ In v t.
Section Lemma_4_10.
Context {d : nat}.
Hypothesis two : (2 <= d)%nat.
Variables (P : domain d) (T : list (simplex d)) (V : list (point d)).
Hypothesis proper : proper_domain P.
Hypothesis triangulates : solid_triangulation P T.
Hypothesis vertices_of_mesh : mesh_vertices T V.

Section Framed.
Variable ts : list (frame d).
Hypothesis are : map vertices ts = T.
Let agreeing := frames_agree P T triangulates ts are.
Let different := frames_different P T triangulates ts are.
Let misses X t x := low_misses_interior P T triangulates ts are two proper X t x.
Let in_T t : In t ts -> In (vertices t) T := framed_member T ts are t.
Notation adj := (adjacent ts (fun t => t)).

Lemma framed s : In s T -> exists t, In t ts /\ vertices t = s.
Proof. rewrite <- are. intros I. apply in_map_iff in I. destruct I as (t & E & It). eauto. Qed.

(** The hull of the vertices contains those of the mesh. *)
Lemma vertex_in_hull v : In v V -> what_it_fills P = Hull -> conv (domain_vertices P) v.
Proof.
  intros Iv K. apply vertices_of_mesh in Iv. destruct Iv as (s & Is & Iv).
  destruct (framed s Is) as (t & It & <-). clear Is.
  assert (C : conv (vertices t) (barycentre t)).
  { apply conv_vertices. intros k Hk. left. now apply barycentre_inside. }
  destruct (proj2 (covers P T triangulates (barycentre t))) as (X & IX & Xb);
    [exists (vertices t); auto|].
  pose proof IX as IX'. apply low_or_region in IX'. destruct IX' as [IL|E].
  - exfalso. apply (misses X t (barycentre t) IL It); [apply barycentre_inside|assumption].
  - assert (R : region P v); [|unfold region in R; now rewrite K in R]. rewrite <- E.
    apply (cell_respected P T triangulates X (vertices t) t (barycentre t) IX Xb (in_T t It));
      [split; apply incl_refl|assumption|].
    apply in_vertices in Iv. destruct Iv as (k & Hk & ->). apply in_carrier. exists k.
    split; [assumption|].
    split; [now apply barycentre_inside|reflexivity].
Qed.

(** ** Walls *)

Definition wall (t : frame d) i : Prop := exists X, In X (wall_cells P) /\
  within (conv (facet_of t i)) X.
Lemma off_walls t i z X : In t ts -> (i <= d)%nat -> in_no_wall P (facet_of t i) ->
  in_facet t i z ->
  In X (low_cells P) -> ~ X z.
Proof.
  intros It Hi N Fz IX Xz.
  destruct (low_in_facet P T triangulates ts are two proper X t i z IX It Hi Fz Xz) as [W Sub].
  exact (N X W Sub).
Qed.
Lemma outer_wall t i : what_it_fills P = Enclosed -> In t ts -> (i <= d)%nat ->
  outer ts (fun t => t) t i -> wall t i.
Proof.
  intros K It Hi O. set (z := facet_centre t i).
  pose proof (centre_in_facet t i ltac:(lia) Hi) as Fz. fold z in Fz.
  destruct (finite_dec (fun X : point d -> Prop => X z) (wall_cells P)) as [(X & IX & Xz)|N].
  - intros X IX. apply (cell_dec P T triangulates), low_or_region. left. now apply walls_low.
  - exists X. apply (low_in_facet P T triangulates ts are two proper X t i z); auto.
    now apply walls_low.
  - exfalso. destruct (neighbour_in_enclosed P T triangulates ts are two proper t i z K It Hi Fz)
      as (u & j & A).
    + intros X IX Xz. apply N. eauto.
    + now apply (O u j).
Qed.

(** ** Seen by Definition 2.13, and along the walk *)

Lemma visible_sees t x v : In t ts -> (forall X, In X (low_cells P) -> ~ X x) -> visible P x v ->
  sees ts (fun t => t) wall x v.
Proof.
  intros It Off [Sub Resp] s Hs.
  assert (C : conv [x; v] (mix x v s)) by (apply conv_two; exists s; split; [lra|reflexivity]).
  split.
  - apply Sub, (covers P T triangulates) in C. destruct C as (u & Iu & Q).
    destruct (framed u Iu) as (a & Ia & <-).
    exists a. split; [assumption|]. now apply conv_vertices.
  - intros a i Ia Hi (X & IX & W) [Z Cl].
    pose proof (W _ (conv_facet a i _ Hi Z Cl)) as Xs. apply walls_low in IX.
    destruct (Resp X) as (F & HF & E); [apply low_or_region; now left|].
    destruct (proj1 (E (mix x v s)) (conj Xs C)) as (f & If & Cf).
    destruct (Faces.in_points x f) as [Ix|N].
    + apply (Off X IX). apply (E x). exists f. split; [assumption|now apply conv_point].
    + assert (Iv : incl f [v]).
      { intros y Hy. destruct (HF f If y Hy) as [<-|[<-|[]]]; [contradiction|now left]. }
      assert (Ev : mix x v s = v) by (apply conv_singleton; now apply (conv_incl f)).
      assert (x = v) as <-.
      { apply affine_separate. intros h A. pose proof (affine_mix h x v s A) as M. rewrite Ev in M.
        nra. }
      apply (Off X IX). now rewrite Ev in Xs.
Qed.

(** From a facet in no wall one sees the apex. *)
Lemma apex_from_facet t i z : In t ts -> (i <= d)%nat -> in_no_wall P (facet_of t i) ->
  in_facet t i z ->
  visible P z (vertex t i).
Proof.
  intros It Hi N Fz. assert (Iv : In (vertex t i) (vertices t)) by (apply in_vertices; eauto).
  apply (seen P T triangulates (vertices t)).
  - now apply in_T.
  - now apply conv_vertices, in_facet_closed with i.
  - apply vertex_in_hull, vertices_of_mesh. exists (vertices t). auto.
  - intros X IX s Hs. destruct (Req_dec s 0) as [->|Ns].
    + rewrite between_start. now apply (off_walls t i z X).
    + apply (misses X t _ IX It). intros k Hk. change (between (d := d)) with (mix (d := d)).
      rewrite affine_mix by now apply bary_affine. destruct (Nat.eq_dec k i) as [->|Nk].
      * rewrite (proj1 Fz), bary_own by assumption. lra.
      * rewrite bary_other by auto. pose proof (proj2 Fz k Hk Nk). nra.
Qed.
(** And from inside a simplex that of its neighbour. *)
Theorem apex_from_inside t i u j : In t ts -> In u ts -> opposite t i u j ->
  in_no_wall P (facet_of t i) ->
  exists x, inside t x /\ visible P x (vertex u j).
Proof.
  intros It Iu O N. pose proof O as (Hi & Hj & _ & _ & Neg).
  set (v := vertex u j) in *. set (q := facet_centre t i).
  pose proof (centre_in_facet t i ltac:(lia) Hi) as [Zq Pq]. fold q in Zq, Pq.
  destruct (opposite_multiple _ _ _ _ O) as (c & Pc & Mul).
  assert (Qu : forall m, (m <= d)%nat -> m <> j -> 0 < bary u m q) by now apply
    (opposite_through t i u j q O Zq Pq).
  assert (Zu : bary u j q = 0) by (rewrite Mul, Zq; ring).
  set (z := mix v q 2).
  destruct (nearby (map (bary t) (indices_but (d := d) i)) q z) as (e & He & K).
  { intros g Hg. apply in_map_iff in Hg. destruct Hg as (m & <- & Hm).
    apply in_indices_but in Hm; [|assumption]. destruct Hm as [Hm Nm].
    split; [now apply bary_affine|now apply Pq]. }
  specialize (K e ltac:(lra)). set (x := mix q z e) in *. exists x.
  assert (Xi : inside t x).
  { intros m Hm. destruct (Nat.eq_dec m i) as [->|Nm].
    - unfold x, z. rewrite !affine_mix, Zq by now apply bary_affine. nra.
    - apply K, in_map. now apply in_indices_but. }
  split; [assumption|].
  (* where the points of the segment are *)
  set (w s := s - (1 - s) * e).
  assert (Val : forall g s, affine g -> g (mix x v s) = (1 - w s) * g q + w s * g v).
  { intros g s A. unfold x, z, w. rewrite !affine_mix by assumption. ring. }
  assert (W1 : forall s, 0 <= s < 1 -> - e <= w s < 1) by (intros s Hs; unfold w; split; nra).
  apply (seen P T triangulates (vertices t)).
  - now apply in_T.
  - apply conv_vertices. intros m Hm. left. now apply Xi.
  - apply vertex_in_hull, vertices_of_mesh. exists (vertices u). split; [auto|]. apply in_vertices.
    eauto.
  - intros X IX s Hs. change (between (d := d)) with (mix (d := d)). specialize (W1 s Hs).
    destruct (Rtotal_order (w s) 0) as [L|[Z|G]].
    + apply (misses X t _ IX It). intros m Hm. rewrite Val by now apply bary_affine.
      destruct (Nat.eq_dec m i) as [->|Nm]; [rewrite Zq; nra|].
      (* between q and x *)
      pose proof (Xi m Hm) as Xm. pose proof (Pq m Hm Nm) as Qm.
      assert (Ex : bary t m x = (1 + e) * bary t m q - e * bary t m v).
      { unfold x, z. rewrite !affine_mix by now apply bary_affine. ring. }
      assert (H : 0 < (e + w s) * bary t m q + (- w s) * bary t m x) by nra.
      rewrite Ex in H. assert (Pe : 0 < e) by lra. nra.
    + replace (mix x v s) with q; [now apply (off_walls t i q X)|].
      apply affine_separate. intros g A. rewrite Val, Z by assumption. ring.
    + apply (misses X u _ IX Iu). intros m Hm. rewrite Val by now apply bary_affine. unfold v.
      destruct (Nat.eq_dec m j) as [->|Nm].
      * rewrite Zu, bary_own by assumption. lra.
      * rewrite bary_other by auto. pose proof (Qu m Hm Nm). nra.
Qed.

(** ** What can be seen is not below *)

Hypothesis local : forall f, facet T f -> in_no_wall P f -> locally_delaunay T f.
Lemma local_above a i b j : In a ts -> adj a i b j -> ~ wall a i -> locally_above norm2 a b j.
Proof.
  intros Ia A NW. pose proof A as (_ & Ib & O).
  apply (locally_witnessed_above norm2 a i); [assumption|].
  pose proof O as (Hi & Hj & _).
  assert (Fa : facet T (facet_of a i)).
  { split; [now apply facet_of_NoDup|]. split; [now apply facet_of_length|].
    exists (vertices a). split; [now apply in_T|now apply facet_of_incl]. }
  pose proof (local _ Fa) as LD.
  assert (NW' : in_no_wall P (facet_of a i)) by (intros X IX W; apply NW; exists X; auto).
  apply LD, locally_delaunay_witnessed in NW'.
  destruct (NW' (vertices a) (vertices b)) as (p & e & On & Low).
  + now apply in_T.
  + now apply in_T.
  + now apply facet_of_incl.
  + apply opposite_facets in O. destruct O as (_ & _ & [I _] & _).
    apply incl_tran with (facet_of b j); [assumption|now apply facet_of_incl].
  + now apply (opposite_different a i b j).
  + exists p, e. split; [assumption|]. intros w Hw. apply Low. now apply in_or_app.
Qed.
Lemma is_vertex v : In v V -> vertex_of ts (fun t => t) v.
Proof.
  intros Iv. apply vertices_of_mesh in Iv. destruct Iv as (s & Is & Iv).
  destruct (framed s Is) as (b & Ib & <-).
  apply in_vertices in Iv. destruct Iv as (i & Hi & ->). exists b, i. auto.
Qed.
(** Of a hull, from inside a simplex: no way from there runs along a facet that has no neighbour. *)
Lemma not_below_hull t x v c r2 : what_it_fills P = Hull -> In t ts -> inside t x ->
  In v V -> visible P x v -> circumball (vertices t) c r2 -> ~ dist2 c v < r2.
Proof.
  intros K It Ix Iv Vis Ci L. apply (in_ball_below_witness _ _ _ _ Ci) in L.
  apply (Rlt_not_le _ _ L).
  assert (Supports : supporting ts (fun t => t) (outer ts (fun t => t)) (fun p => In p V)).
  { apply (facet_supports ts (fun t => t) V ltac:(lia) agreeing).
    - intros a Ia y Iy. apply vertices_of_mesh. exists (vertices a). auto.
    - intros q C. destruct (proj1 (covers P T triangulates q)) as (s & Is & Cs).
      + exists (region P). split; [apply low_or_region; now right|]. unfold region. rewrite K.
        apply (conv_conv V); [|assumption]. intros y Iy. now apply vertex_in_hull.
      + destruct (framed s Is) as (a & Ia & <-). exists a.
        split; [assumption|now apply conv_vertices]. }
  apply (visible_vertex_above ts (fun t => t) ltac:(lia) agreeing different (fun a i => wall a i \/
    outer ts (fun t => t) a i)) with (x := x);
    [now right| |assumption|intros k Hk; left; now apply Ix|now apply is_vertex|].
  - intros a i b j Ia A N. apply (local_above a i); auto.
  - intros s Hs. destruct (visible_sees t x v It) with (s := s) as [In_ Off]; [|assumption..|].
    { intros X IX. now apply (misses X t x IX It). }
    split; [assumption|]. intros a i Ia Hi [W|O]; [now apply Off|]. intros [Z _].
    rewrite affine_mix in Z by now apply bary_affine. pose proof (Supports a i Ia Hi O v Iv) as Pv.
    enough (0 < bary a i x) by (destruct Hs; nra).
    apply (strictly_inner a i t x); try assumption. intros k Hk. apply (Supports a i Ia Hi O).
    apply vertices_of_mesh.
    exists (vertices t). split; [now apply in_T|]. apply in_vertices. eauto.
Qed.

Hypothesis enclosed : what_it_fills P = Enclosed.
Lemma not_below t x v c r2 : In t ts -> inside_closed t x -> (forall X, In X (low_cells P) ->
  ~ X x) ->
  In v V -> visible P x v -> circumball (vertices t) c r2 -> ~ dist2 c v < r2.
Proof.
  intros It Cx Off Iv Vis Ci L. apply (in_ball_below_witness _ _ _ _ Ci) in L.
  apply (Rlt_not_le _ _ L).
  apply (visible_vertex_above ts (fun t => t) ltac:(lia) agreeing different wall) with (x := x);
    auto.
  - intros a i Ia Hi O. now apply outer_wall.
  - intros a i b j Ia A NW. now apply (local_above a i).
  - now apply is_vertex.
  - now apply (visible_sees t).
Qed.
End Framed.

(** ** The three statements *)

Let face_respects f := simplices_respect P T f triangulates.
Lemma facet_face f : facet T f -> faces_of T f.
Proof.
  intros (Nf & Lf & t & It & If). split; [assumption|]. split; [|exists t; auto]. intros ->.
  cbn in Lf. lia.
Qed.
Lemma facet_vertices f : facet T f -> incl f V.
Proof. intros (_ & _ & t & It & If) v Iv. apply vertices_of_mesh. exists t. auto. Qed.

(** (iii) => (i) *)
Theorem local_constrained : what_it_fills P = Enclosed ->
  (forall f, facet T f -> in_no_wall P f -> locally_delaunay T f) -> forall t, In t T ->
    constrained_delaunay V P t.
Proof.
  intros K Loc t It. destruct (all_framed P T triangulates) as (ts & are). split; [|split].
  - intros v Iv. apply vertices_of_mesh. eauto.
  - apply face_respects. now apply (member_face P T triangulates).
  - destruct (framed ts are t It) as (u & Iu & <-).
    destruct (circumball_frame u) as (c & r2 & C & _).
    exists c, r2. split; [assumption|]. intros v x Iv Xi Vis. apply strictly_inside_frame in Xi.
    apply (not_below ts are Loc K u x v c r2); auto.
    + intros k Hk. left. now apply Xi.
    + intros X IX. now apply (low_misses_interior P T triangulates ts are two proper X u).
Qed.
Theorem local_constrained_hull : what_it_fills P = Hull ->
  (forall f, facet T f -> in_no_wall P f -> locally_delaunay T f) -> forall t, In t T ->
    constrained_delaunay V P t.
Proof.
  intros K Loc t It. destruct (all_framed P T triangulates) as (ts & are). split; [|split].
  - intros v Iv. apply vertices_of_mesh. eauto.
  - apply face_respects. now apply (member_face P T triangulates).
  - destruct (framed ts are t It) as (u & Iu & <-).
    destruct (circumball_frame u) as (c & r2 & C & _).
    exists c, r2. split; [assumption|]. intros v x Iv Xi Vis. apply strictly_inside_frame in Xi.
    now apply (not_below_hull ts are Loc u x v c r2).
Qed.
(** (iii) => (ii) *)
Theorem local_facets : what_it_fills P = Enclosed ->
  (forall f, facet T f -> in_no_wall P f -> locally_delaunay T f) ->
  forall f, facet T f -> in_no_wall P f -> constrained_delaunay V P f.
Proof.
  intros K Loc f Ff NW. destruct (all_framed P T triangulates) as (ts & are). split; [|split].
  - now apply facet_vertices.
  - now apply face_respects, facet_face.
  - destruct Ff as (Nf & Lf & t & It & If). destruct (framed ts are t It) as (u & Iu & <-).
    destruct (facet_index u f Nf Lf If) as (i & Hi & Ei).
    destruct (circumball_frame u) as (c & r2 & C & _). exists c, r2.
    split; [intros v Iv; apply C; auto|].
    assert (NW' : in_no_wall P (facet_of u i)).
    { intros X IX W. apply (NW X IX). intros q Cq. apply W.
      apply (conv_incl f); [apply Ei|assumption]. }
    intros v x Iv Xi Vis.
    assert (Fx : in_facet u i x).
    { apply strictly_in_facet; [assumption|]. destruct Xi as [Cx Least]. destruct Ei as [E1 E2].
      split.
      - now apply (conv_incl f).
      - intros g Ig Cg. apply incl_tran with f; [assumption|].
        apply Least; [now apply incl_tran with (facet_of u i)|assumption]. }
    apply (not_below ts are Loc K u x v c r2); auto.
    + now apply in_facet_closed with i.
    + intros X IX. now apply (off_walls ts are u i x X).
Qed.
(** (ii) => (iii) *)
Theorem facets_local : (forall f, facet T f -> in_no_wall P f -> constrained_delaunay V P f) ->
  forall f, facet T f -> in_no_wall P f -> locally_delaunay T f.
Proof.
  intros Cd f Ff NW s t Is It Fs Ft _. destruct (all_framed P T triangulates) as (ts & are).
  destruct (Cd f Ff NW) as (_ & _ & c & r2 & C & Empty). exists c, r2. split; [assumption|].
  assert (Each : forall a, In a T -> incl f a -> forall v, In v a -> ~ dist2 c v < r2).
  { intros a Ia Fa v Iv L. destruct (framed ts are a Ia) as (u & Iu & <-).
    destruct Ff as (Nf & Lf & _).
    destruct (facet_index u f Nf Lf Fa) as (i & Hi & E1 & E2). apply in_vertices in Iv.
    destruct Iv as (k & Hk & ->).
    destruct (Nat.eq_dec k i) as [->|N].
    - apply (Empty (vertex u i) (facet_centre u i)); [..|assumption].
      + apply vertices_of_mesh. exists (vertices u). split; [assumption|]. apply in_vertices. eauto.
      + destruct (in_facet_strictly u i (facet_centre u i) Hi (centre_in_facet u i ltac:(lia) Hi))
          as [Cx Least]. split.
        * now apply (conv_incl (facet_of u i)).
        * intros g Ig Cg. apply incl_tran with (facet_of u i); [assumption|].
          apply Least; [now apply incl_tran with f|assumption].
      + apply (apex_from_facet ts are u i); [assumption..| |apply centre_in_facet;
          [lia|assumption]].
        intros X IX W. apply (NW X IX). intros q Cq. apply W. now apply (conv_incl f).
    - rewrite (C (vertex u k)) in L; [lra|]. apply E2, in_facet_of; [assumption|]. eauto. }
  intros v [Iv|Iv]; [now apply (Each s)|now apply (Each t)].
Qed.
(** From inside a simplex, through a facet in no wall, one sees the apex of another. *)
Lemma apex_of_neighbour f s t v : NoDup f -> length f = d -> in_no_wall P f -> In s T -> In t T ->
  incl f s -> incl f t ->
  ~ same s t -> In v t -> ~ In v f -> exists x, strictly_inside s x /\ visible P x v.
Proof.
  intros Nf Lf NW Is It Fs Ft NS Iv Nv. destruct (all_framed P T triangulates) as (ts & are).
  destruct (framed ts are s Is) as (a & Ia & Ea). destruct (framed ts are t It) as (u & Iu & Eu).
  subst s t.
  destruct (facet_index a f Nf Lf Fs) as (i & Hi & Ei).
  destruct (facet_index u f Nf Lf Ft) as (j & Hj & Ej).
  assert (O : opposite a i u j).
  { apply (shared_facet ts (fun t => t) ltac:(lia) (frames_agree P T triangulates ts are)
      (frames_different P T triangulates ts are)); auto.
    - intros ->. apply NS. split; apply incl_refl.
    - destruct Ei, Ej. split; eauto using incl_tran. }
  assert (NW' : in_no_wall P (facet_of a i)).
  { intros X IX W. apply (NW X IX). intros q Cq. apply W.
    apply (conv_incl f); [apply Ei|assumption]. }
  apply in_vertices in Iv. destruct Iv as (l & Hl & ->). destruct (Nat.eq_dec l j) as [->|Nl].
  - destruct (apex_from_inside ts are a i u j Ia Iu O NW') as (x & Xi & Vis). exists x.
    split; [now apply inside_strictly|assumption].
  - exfalso. apply Nv, Ej, in_facet_of; eauto.
Qed.
(** (i) => (iii) *)
Theorem constrained_local : (forall t, In t T -> constrained_delaunay V P t) ->
  forall f, facet T f -> in_no_wall P f -> locally_delaunay T f.
Proof.
  intros Cd f (Nf & Lf & _) NW s t Is It Fs Ft NS.
  destruct (Cd _ Is) as (_ & _ & c & r2 & C & Empty). exists c, r2.
  split; [intros v Iv; apply C; auto|].
  intros v [Iv|Iv] L; [rewrite (C v Iv) in L; lra|]. destruct (Faces.in_points v f) as [I|N].
  - rewrite (C v (Fs v I)) in L. lra.
  - destruct (apex_of_neighbour f s t v Nf Lf NW Is It Fs Ft NS Iv N) as (x & Xi & Vis).
    apply (Empty v x); try assumption. apply vertices_of_mesh. eauto.
Qed.
End Lemma_4_10.
