(** * Triangles of a CDT in a polygon  (Book: Proposition 4.11, at an edge)

    Two triangles of the mesh that share an edge are in a polygon, and the edge is in no segment.
    From inside a tetrahedron over the first, near the middle m of the edge, one sees the apex v of
    the second: no other polygon has a point between m and v, else they would meet in more than
    segments. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Domains DomainRules Vectors Affine Frame Matched Faces
  Facets Generic.
From Circumspect Require Import Independence Adjacency Combinations Solid Necessary Visible Sight
  ConstrainedLemma.
Import ListNotations.
Open Scope R_scope.

Section Edge.
Variables (P : domain 3) (T : list (simplex 3)) (f : polygon 3) (a b v1 v : point 3).
Hypothesis proper : proper_domain P.
Hypothesis plc : piecewise_linear_complex P.
Hypothesis triangulates : solid_triangulation P T.
Hypothesis is_polygon : In f (domain_polygons P).
Hypothesis first_face : faces_of T [a; b; v1].
Hypothesis first_in : within (conv [a; b; v1]) (polygon_points f).
Hypothesis second_face : faces_of T [a; b; v].
Hypothesis second_in : within (conv [a; b; v]) (polygon_points f).
Hypothesis in_no_segment : forall p q, In (p, q) (domain_segments P) ->
  ~ within (conv [a; b]) (conv [p; q]).
Variable ts : list (frame 3).
Hypothesis are : map vertices ts = T.
Variables (t : frame 3) (i : nat).
Hypothesis member : In t ts.
Hypothesis index : (i <= 3)%nat.
Hypothesis facet_is : same (facet_of t i) [a; b; v1].
Notation height := (bary t i).
Notation m := (mix a b (1 / 2)).

Lemma height_affine : affine height.
Proof. now apply bary_affine. Qed.
Lemma height_facet p : In p [a; b; v1] -> height p = 0.
Proof.
  intros I. apply facet_is in I. apply in_facet_of in I; [|assumption].
  destruct I as (k & Hk & N & ->).
  now apply bary_other; auto.
Qed.
(** The polygon is in the plane of the facet. *)
Lemma height_polygon p : polygon_points f p -> height p = 0.
Proof.
  intros Fp. set (g y := inner (plane_normal f) y + - plane_offset f).
  assert (A : affine g) by (exists (plane_normal f), (- plane_offset f); intros y; reflexivity).
  assert (Zf : forall y, polygon_points f y -> g y = 0).
  { intros y [Fl _]. unfold g. rewrite Fl. ring. }
  assert (E : forall y, g y = bary t i y * g (vertex t i)).
  { intros y. rewrite (interpolation t g y A). unfold sum.
    refine (eq_trans (sum_one (seq 0 4) (fun k => bary t k y * g (vertex t k)) i _ _ _) eq_refl).
    - apply seq_NoDup.
    - now apply in_seq_d.
    - intros k Hk N. apply in_seq_d in Hk. rewrite (Zf (vertex t k)); [ring|].
      apply first_in, conv_point, facet_is, in_facet_of; eauto. }
  assert (N : g (vertex t i) <> 0).
  { intros Z. apply (proj2 proper f is_polygon). apply norm2_zero. unfold norm2.
    pose proof (E (plane_normal f)) as E1. pose proof (E origin) as E0. rewrite Z in E0, E1.
    unfold g in E0, E1.
    rewrite inner_origin_r in E0. lra. }
  pose proof (E p) as Ep. rewrite (Zf p Fp) in Ep. symmetry in Ep. apply Rmult_integral in Ep.
  destruct Ep; [assumption|contradiction].
Qed.

Lemma different : a <> b.
Proof.
  destruct first_face as (N & _). apply NoDup_cons_iff in N. destruct N as [I _]. intros ->.
  apply I. now left.
Qed.
Lemma middle_in X : incl [a; b] X -> conv X m.
Proof.
  intros I. apply (conv_incl [a; b]); [assumption|]. apply conv_two. exists (1 / 2).
  split; [lra|reflexivity].
Qed.
(** A face with a point between m and v, v excepted, has the edge. *)
Lemma face_has_edge s r : faces_of T s -> 0 <= r < 1 -> conv s (mix m v r) -> incl [a; b] s.
Proof.
  intros Fs Hr C. destruct second_face as (Nd & _ & u0 & Iu & Ie). rewrite <- are in Iu.
  apply in_map_iff in Iu.
  destruct Iu as (u & <- & Iu). destruct (meets P T triangulates) as (_ & _ & M).
  destruct (M s [a; b; v] Fs second_face) as (g & Gs & Ge & K).
  assert (Cz : conv [a; b; v] (mix m v r)).
  { apply conv_mix; [apply middle_in; intros y [<-|[<-|[]]]; cbn; auto|cbn; auto|lra]. }
  specialize (K _ C Cz). apply (conv_face u) in K; [|eauto using incl_tran]. destruct K as [_ K].
  apply NoDup_cons_iff in Nd. destruct Nd as [Na Nb]. apply NoDup_cons_iff in Nb.
  destruct Nb as [Nbv _].
  assert (Ia : In a (vertices u)) by (apply Ie; cbn; auto).
  assert (Ib : In b (vertices u)) by (apply Ie; cbn; auto).
  assert (Iv : In v (vertices u)) by (apply Ie; cbn; auto).
  apply in_vertices in Ia, Ib, Iv. destruct Ia as (j & Hj & Ej), Ib as (k & Hk & Ek),
    Iv as (l & Hl & El).
  assert (Value : forall n, (n <= 3)%nat -> bary u n (mix m v r) =
    (1 - r) * (1 / 2 * bary u n a + 1 / 2 * bary u n b) + r * bary u n v).
  { intros n Hn. rewrite !affine_mix by now apply bary_affine. lra. }
  assert (jk : j <> k) by (intros ->; apply Na; left; congruence).
  assert (jl : j <> l) by (intros ->; apply Na; right; left; congruence).
  assert (kl : k <> l) by (intros ->; apply Nbv; left; congruence).
  intros y [<-|[<-|[]]]; apply Gs.
  - rewrite Ej. apply K; [assumption|]. rewrite Value by assumption.
    rewrite Ej, Ek, El, bary_own, !bary_other by auto. lra.
  - rewrite Ek. apply K; [assumption|]. rewrite Value by assumption.
    rewrite Ej, Ek, El, bary_own, !bary_other by auto. lra.
Qed.
Lemma edge_face : faces_of T [a; b].
Proof.
  destruct first_face as (N & _ & u & Iu & I). apply NoDup_cons_iff in N. destruct N as [Na Nb].
  apply NoDup_cons_iff in Nb. destruct Nb as [Nbv _].
  split; [|split; [discriminate|exists u; split; [assumption|intros y [<-|[<-|[]]]; apply I; cbn;
    auto]]].
  constructor; [|repeat constructor; now intros []]. intros [E|[]]. now apply different.
Qed.
Lemma cell_has_edge X : In X (cells P) -> X m -> within (conv [a; b]) X.
Proof.
  intros IX Xm. destruct (union_of_cell P T triangulates X IX) as (F & HF & E). apply E in Xm.
  destruct Xm as (s & Is & Cs).
  assert (I : incl [a; b] s).
  { apply (face_has_edge s 0); [now apply HF|lra|]. replace (mix m v 0) with m; [assumption|].
    apply affine_separate. intros g A. rewrite !affine_mix by assumption. ring. }
  intros y Cy. apply E. exists s. split; [assumption|]. now apply (conv_incl [a; b]).
Qed.
(** Only the segment's ends and the segment itself are in a line: such a face is in the plane. *)
Lemma face_with_edge_flat s X : In X (low_cells P) -> within (conv s) X -> incl [a; b] s ->
  forall w, In w s -> height w = 0.
Proof.
  intros IX W I w Iw. destruct (Req_dec (height w) 0) as [|N]; [assumption|exfalso].
  assert (Wa : X a) by (apply W, conv_point, I; cbn; auto).
  assert (Wb : X b) by (apply W, conv_point, I; cbn; auto).
  assert (NoVertex : forall p, In p (domain_vertices P) -> p <> m).
  { intros p Ip ->. pose proof (cell_has_edge (fun q => q = m)) as H.
    assert (IC : In (fun q => q = m) (cells P)).
    { unfold cells. apply in_or_app. left. now apply (in_map (fun v q => q = v)). }
    specialize (H IC eq_refl). apply different.
    rewrite (H a (conv_point [a; b] a (or_introl eq_refl))). symmetry. apply H, conv_point. cbn.
    auto. }
  unfold low_cells in IX. apply in_app_or in IX.
  destruct IX as [IX|IX]; [|apply in_app_or in IX; destruct IX as [IX|IX]].
  - apply in_map_iff in IX. destruct IX as (p & <- & _). apply different. congruence.
  - apply in_map_iff in IX. destruct IX as ((p, q) & <- & Is). apply (in_no_segment p q Is).
    intros y Cy.
    apply W. now apply (conv_incl [a; b]).
  - apply in_map_iff in IX. destruct IX as (g & <- & Ig).
    set (cf := LinearCell 2 (fun q => inner (plane_normal f) q = plane_offset f)
      (polygon_points f)).
    set (cg := LinearCell 2 (fun q => inner (plane_normal g) q = plane_offset g)
      (polygon_points g)).
    assert (In_cells : forall h, In h (domain_polygons P) ->
      In (LinearCell 2 (fun q => inner (plane_normal h) q = plane_offset h) (polygon_points h))
        (linear_cells P)).
    { intros h Ih. unfold linear_cells. apply in_or_app. right. apply in_or_app. right.
      apply in_or_app. left.
      now apply (in_map (fun h => LinearCell 2 (fun q => inner (plane_normal h) q = plane_offset h)
        (polygon_points h))). }
    destruct (meeting_cells P plc cf cg m) as (h & Ih & Hm & Hf & Hg & Dim).
    + now apply In_cells.
    + now apply In_cells.
    + intros [_ Sub]. apply N, height_polygon, Sub, W. now apply conv_point.
    + apply first_in, middle_in. intros y [<-|[<-|[]]]; cbn; auto.
    + now apply W, middle_in.
    + assert (D : (cell_dimension h < 2)%nat) by (destruct Dim; assumption). clear Dim.
      unfold linear_cells in Ih. apply in_app_or in Ih.
      destruct Ih as [Ih|Ih]; [|apply in_app_or in Ih; destruct Ih as [Ih|Ih]].
      * apply in_map_iff in Ih. destruct Ih as (p & <- & Ip). cbn in Hm.
        exact (NoVertex p Ip (eq_sym Hm)).
      * apply in_map_iff in Ih. destruct Ih as ((p, q) & <- & Is).
        apply (in_no_segment p q Is), (cell_has_edge (conv [p; q])).
        -- unfold cells. apply in_or_app. right. apply in_or_app. left.
           apply (in_map (fun ab q => conv [fst ab; snd ab] q) _ (p, q) Is).
        -- exact Hm.
      * apply in_app_or in Ih. destruct Ih as [Ih|Ih].
        -- apply in_map_iff in Ih. destruct Ih as (k & <- & _). cbn in D. lia.
        -- destruct (what_it_fills P); [|destruct Ih]. destruct Ih as [<-|[]]. cbn in D. lia.
Qed.

(** ** From near m one sees v *)

Notation x e := (mix m (barycentre t) e).
Lemma above e r : 0 < e <= 1 -> 0 <= r < 1 -> 0 < height (mix (x e) v r).
Proof.
  intros He Hr. rewrite !affine_mix by apply height_affine.
  rewrite (height_facet a), (height_facet b) by (cbn; auto).
  rewrite (height_polygon v) by (apply second_in, conv_point; cbn; auto).
  pose proof (barycentre_inside t i index).
  assert (0 < (1 - r) * (e * height (barycentre t))) by (apply Rmult_lt_0_compat; nra). lra.
Qed.
(** A function that is negative at m, and not positive at v, keeps small ways off. *)
Lemma kept_off (g : point 3 -> R) : affine g -> g m < 0 -> g v <= 0 -> exists e0, 0 < e0 < 1 /\
  forall e r, 0 < e <= e0 -> 0 <= r < 1 -> g (mix (x e) v r) < 0.
Proof.
  intros A Nm Nv. destruct (nearby [fun y => - g y] m (barycentre t)) as (e0 & He & K).
  { intros h [<-|[]]. split; [now apply affine_opp|lra]. }
  exists e0. split; [assumption|]. intros e r E Hr.
  specialize (K e ltac:(lra) _ (or_introl eq_refl)). cbn beta in K.
  rewrite affine_mix by assumption. nra.
Qed.
Lemma face_kept_off s X : faces_of T s -> In X (low_cells P) -> within (conv s) X ->
  ~ ~ exists e0, 0 < e0 < 1 /\
  forall e r, 0 < e <= e0 -> 0 <= r < 1 -> ~ conv s (mix (x e) v r).
Proof.
  intros Fs IX W Not.
  assert (EM : ~ ~ ((exists r, 0 <= r < 1 /\ conv s (mix m v r)) \/ ~ exists r, 0 <= r < 1 /\
    conv s (mix m v r))) by tauto.
  apply EM. clear EM. intros [(r & Hr & C)|NM].
  { pose proof (face_with_edge_flat s X IX W (face_has_edge s r Fs Hr C)) as Z. apply Not.
    exists (1 / 2). split; [lra|].
    intros e q He Hq Cs. pose proof (above e q ltac:(lra) Hq) as Ab.
    assert (0 <= - height (mix (x e) v q)); [|lra].
    apply (affine_conv (fun y => - height y) s); [apply affine_opp, height_affine| |assumption].
    intros w Iw. rewrite (Z w Iw). lra. }
  destruct Fs as (_ & _ & u0 & Iu & Is). rewrite <- are in Iu. apply in_map_iff in Iu.
  destruct Iu as (u & <- & Iu).
  set (fs := map (fun k y => bary u k y) (seq 0 4) ++
    flat_map (fun k => if in_points (vertex u k) s then [] else [fun y => - bary u k y]) (seq 0 4)).
  assert (Aff : forall g, In g fs -> affine g).
  { intros g Ig. unfold fs in Ig. apply in_app_or in Ig. destruct Ig as [Ig|Ig].
    - apply in_map_iff in Ig. destruct Ig as (k & <- & Hk). apply bary_affine. now apply in_seq_d.
    - apply in_flat_map in Ig. destruct Ig as (k & Hk & Ig).
      destruct (in_points (vertex u k) s); [destruct Ig|].
      destruct Ig as [<-|[]]. apply affine_opp, bary_affine. now apply in_seq_d. }
  assert (Conv : forall y, conv s y <-> forall g, In g fs -> 0 <= g y).
  { intros y. rewrite (conv_face u s y Is). split.
    - intros [Cl Car] g Ig. unfold fs in Ig. apply in_app_or in Ig. destruct Ig as [Ig|Ig].
      + apply in_map_iff in Ig. destruct Ig as (k & <- & Hk). apply Cl. now apply in_seq_d.
      + apply in_flat_map in Ig. destruct Ig as (k & Hk & Ig).
        destruct (in_points (vertex u k) s) as [|N]; [destruct Ig|].
        destruct Ig as [<-|[]]. destruct (Rlt_dec 0 (bary u k y)) as [L|]; [|lra]. exfalso.
        apply N, Car; [now apply in_seq_d|assumption].
    - intros H. split.
      + intros k Hk. apply (H (fun y => bary u k y)). unfold fs. apply in_or_app. left.
        apply (in_map (fun k y => bary u k y)). now apply in_seq_d.
      + intros k Hk L. destruct (in_points (vertex u k) s) as [|N]; [assumption|exfalso].
        assert (0 <= - bary u k y); [|lra]. apply (H (fun y => - bary u k y)). unfold fs.
        apply in_or_app. right.
        apply in_flat_map. exists k. split; [now apply in_seq_d|].
        destruct (in_points (vertex u k) s); [contradiction|now left]. }
  assert (Off : forall g, affine g -> (forall y, conv s y -> 0 <= g y) -> g m < 0 -> g v <= 0 ->
    False).
  { intros g A Pos Nm Nv. destruct (kept_off g A Nm Nv) as (e0 & He & K). apply Not. exists e0.
    split; [assumption|].
    intros e r E Hr Cs. specialize (K e r E Hr). specialize (Pos _ Cs). lra. }
  destruct (Exists_dec (fun g : point 3 -> R => g m < 0 /\ g v <= 0) fs) as [Ex|Nx].
  { intros g. destruct (Rlt_dec (g m) 0); [|right; tauto].
    destruct (Rle_dec (g v) 0); [left; tauto|right; tauto]. }
  { apply Exists_exists in Ex. destruct Ex as (g & Ig & Nm & Nv). apply (Off g); auto. intros y Cy.
    now apply Conv. }
  destruct (Exists_dec (fun g : point 3 -> R => g v < 0) fs) as [Ev|Nv].
  { intros g. apply Rlt_dec. }
  - (* v is not in the face: two functions keep the whole way off *)
    destruct (two_suffice (fun g : point 3 -> R => g m) (fun g => g v) fs)
      as (g & h & c & e & Ig & Ih & Pc & Pe & Nm & Nv).
    + intros r Hr. destruct (Exists_dec (fun g : point 3 -> R => (1 - r) * g m + r * g v < 0) fs)
        as [Y|N].
      { intros g. apply Rlt_dec. } { apply Exists_exists in Y. destruct Y as (g & Ig & L). eauto. }
      exfalso. assert (C : conv s (mix m v r)).
      { apply Conv. intros g Ig. rewrite affine_mix by auto.
        destruct (Rle_dec 0 ((1 - r) * g m + r * g v)) as [|L]; [assumption|].
        exfalso. apply N, Exists_exists. exists g. split; [assumption|lra]. }
      destruct (Req_dec r 1) as [->|Nr]; [|apply NM; exists r; split; [lra|assumption]].
      apply Exists_exists in Ev. destruct Ev as (g & Ig & L).
      apply Conv with (g := g) in C; [|assumption].
      rewrite affine_mix in C by auto. lra.
    + apply (Off (fun y => c * g y + e * h y)); [apply affine_combine; auto| |assumption|lra].
      intros y Cy. pose proof (proj1 (Conv y) Cy g Ig). pose proof (proj1 (Conv y) Cy h Ih). nra.
  - (* v is in it: then so is what is near v on the way *)
    destruct (nearby (filter (fun g => if Rlt_dec 0 (g v) then true else false) fs) v m)
      as (e & He & K).
    { intros g Ig. apply filter_In in Ig. destruct Ig as [Ig L].
      destruct (Rlt_dec 0 (g v)); [auto|discriminate]. }
    apply NM. exists (1 - e). split; [lra|]. replace (mix m v (1 - e)) with (mix v m e).
    2: { apply affine_separate. intros g A. rewrite !affine_mix by assumption. ring. }
    apply Conv. intros g Ig. destruct (Rlt_dec 0 (g v)) as [L|L].
    + left. apply (K e ltac:(lra)). apply filter_In. split; [assumption|].
      now destruct (Rlt_dec 0 (g v)).
    + rewrite affine_mix by auto. assert (0 <= g v).
      { destruct (Rle_dec 0 (g v)) as [|N]; [assumption|]. exfalso. apply Nv, Exists_exists.
        exists g. split; [assumption|lra]. }
      assert (0 <= g m).
      { destruct (Rle_dec 0 (g m)) as [|N]; [assumption|]. exfalso. apply Nx, Exists_exists.
        exists g. split; [assumption|lra]. }
      nra.
Qed.
Lemma all_kept_off L : (forall X, In X L -> In X (low_cells P)) -> ~ ~ exists e0, 0 < e0 < 1 /\
  forall X e r, In X L -> 0 < e <= e0 -> 0 <= r < 1 -> ~ X (mix (x e) v r).
Proof.
  induction L as [|X L IH]; intros HL Not; [apply Not; exists (1 / 2); split;
    [lra|intros X e r []]|].
  apply IH; [intros; apply HL; now right|]. intros (e1 & H1 & K1).
  destruct (union_of_cell P T triangulates X) as (F & HF & E); [apply low_or_region; left; apply HL;
    now left|].
  assert (W : forall s, In s F -> within (conv s) X) by (intros s Is y Cy; apply E; eauto).
  assert (KF : ~ ~ exists e0, 0 < e0 < 1 /\ forall s e r, In s F -> 0 < e <= e0 -> 0 <= r < 1 ->
    ~ conv s (mix (x e) v r)).
  { clear E.
    induction F as [|s F IHF]; intros N; [apply N; exists (1 / 2); split; [lra|intros s e r []]|].
    apply IHF; [intros; apply HF; now right|intros; apply W; now right|]. intros (e2 & H2 & K2).
    apply (face_kept_off s X (HF s (or_introl eq_refl)) (HL X (or_introl eq_refl))
      (W s (or_introl eq_refl))). intros (e3 & H3 & K3).
    apply N. exists (Rmin e2 e3). pose proof (Rmin_l e2 e3). pose proof (Rmin_r e2 e3).
    split; [split; [apply Rmin_glb_lt; lra|lra]|].
    intros s' e r [<-|Is] He Hr; [apply K3; lra|apply K2; auto; lra]. }
  apply KF. intros (e2 & H2 & K2). apply Not. exists (Rmin e1 e2). pose proof (Rmin_l e1 e2).
  pose proof (Rmin_r e1 e2).
  split; [split; [apply Rmin_glb_lt; lra|lra]|].
  intros Y e r [<-|IY] He Hr Yz; [|apply (K1 Y e r); auto; lra].
  apply E in Yz. destruct Yz as (s & Is & C). apply (K2 s e r Is); [lra|assumption|assumption].
Qed.
Theorem seen_over_edge : ~ ~ exists y, inside t y /\ visible P y v.
Proof.
  intros Not. apply (all_kept_off (low_cells P)); [auto|]. intros (e & He & K). apply Not.
  exists (x e).
  assert (Ix : inside t (x e)).
  { intros k Hk. rewrite affine_mix by now apply bary_affine.
    pose proof (barycentre_inside t k Hk) as B.
    assert (Cm : conv (vertices t) m).
    { apply middle_in. intros y Iy. apply (facet_of_incl t i index), facet_is.
      destruct Iy as [<-|[<-|[]]]; cbn; auto. }
    apply conv_vertices in Cm. specialize (Cm k Hk). nra. }
  split; [assumption|]. apply (Visible.seen P T triangulates (vertices t)).
  - now apply (framed_member T ts are).
  - apply conv_vertices. intros k Hk. left. now apply Ix.
  - intros H.
    apply (vertex_in_hull (le_S _ _ (le_n 2)) P T (concat T) proper triangulates (fun w =>
      in_concat T w) ts are v); [|assumption].
    destruct second_face as (_ & _ & u & Iu & I). apply in_concat. exists u. split; [assumption|].
    apply I. cbn. auto.
  - intros X IX r Hr. change (between (d := 3)) with (mix (d := 3)). apply K; auto. lra.
Qed.
End Edge.

(** Every circumball of the tetrahedron over the first triangle that visibility leaves empty has not
    v in it. *)
Theorem polygon_edge_local (P : domain 3) T V f a b v1 v : proper_domain P ->
  piecewise_linear_complex P ->
  solid_triangulation P T -> mesh_vertices T V ->
    (forall t, In t T -> constrained_delaunay V P t) ->
  In f (domain_polygons P) -> (forall p q, In (p, q) (domain_segments P) ->
    ~ within (conv [a; b]) (conv [p; q])) ->
  faces_of T [a; b; v1] -> within (conv [a; b; v1]) (polygon_points f) ->
  faces_of T [a; b; v] -> within (conv [a; b; v]) (polygon_points f) ->
  exists c r2, circumball [a; b; v1] c r2 /\ ~ dist2 c v < r2.
Proof.
  intros Pr Plc St Ve Cd If Ns F1 W1 F2 W2. destruct (all_framed P T St) as (ts & are).
  pose proof F1 as (Nd & _ & t0 & It & I). pose proof It as It'. rewrite <- are in It'.
  apply in_map_iff in It'.
  destruct It' as (t & <- & It'). destruct (facet_index t [a; b; v1] Nd eq_refl I) as (i & Hi & E).
  destruct (Cd _ It) as (_ & _ & c & r2 & C & Empty). exists c, r2.
  split; [intros p Ip; apply C; auto|]. intros L.
  assert (S : same (facet_of t i) [a; b; v1]) by (destruct E; now split).
  apply (seen_over_edge P T f a b v1 v Pr Plc St If F1 W1 F2 W2 Ns ts are t i It' Hi S).
  intros (y & Iy & Vis).
  apply (Empty v y); auto; [|now apply inside_strictly]. apply Ve.
  destruct F2 as (_ & _ & u & Iu & I2).
  exists u. split; [assumption|]. apply I2. cbn. auto.
Qed.
