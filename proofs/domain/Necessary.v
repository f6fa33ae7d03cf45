(** * What every triangulation of a domain has to do

    Each point of the domain is in a simplex.  A simplex that contains a point of a cell has this
    point in a face that is in the cell ([cell_respected]); two that have a point in common have the
    same carrier of it ([carriers_agree]).  Across a facet that is in no wall of what is enclosed,
    or that is not on the hull, there is another simplex ([neighbour]).  Nothing is said of what
    suffices: a refutation does not need it. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Domains DomainRules Vectors Affine Frame Matched Faces
  Facets Independence Adjacency.
From Circumspect Require Import Combinations Solid.
Import ListNotations.
Open Scope R_scope.

Lemma walls_are_cells {d} (P : domain d) q : walls_of P q <-> exists X, In X (wall_cells P) /\ X q.
Proof.
  assert (S : on_segments (domain_segments P) q <->
    exists X, In X (map (fun ab q => conv [fst ab; snd ab] q) (domain_segments P)) /\ X q).
  { split.
    - intros (a & b & I & C). exists (fun q => conv [a; b] q). split; [|assumption].
      apply in_map_iff. exists (a, b). auto.
    - intros (X & IX & C). apply in_map_iff in IX. destruct IX as ((a, b) & <- & I). exists a, b.
      auto. }
  assert (F : (exists f, In f (domain_polygons P) /\ polygon_points f q) <->
    exists X, In X (map polygon_points (domain_polygons P)) /\ X q).
  { split.
    - intros (f & If & Q). exists (polygon_points f). split; [now apply in_map|assumption].
    - intros (X & IX & Q). apply in_map_iff in IX. destruct IX as (f & <- & If). eauto. }
  unfold walls_of, wall_cells. destruct d as [|[|[|n]]]; assumption.
Qed.
Lemma low_or_region {d} (P : domain d) X : In X (cells P) <-> In X (low_cells P) \/ X = region P.
Proof. unfold cells, low_cells. rewrite !in_app_iff. cbn [In]. intuition. Qed.
Lemma walls_low {d} (P : domain d) X : In X (wall_cells P) -> In X (low_cells P).
Proof.
  unfold wall_cells, low_cells. rewrite !in_app_iff. destruct d as [|[|[|n]]]; auto.
Qed.

(** What is enclosed does not end where there is no wall. *)
Lemma enclosed_along {d} (W : point d -> Prop) holes x y : enclosed (fun _ => True) W holes x ->
  clear W x y ->
  enclosed (fun _ => True) W holes y.
Proof.
  intros [_ [Wx|[Nu Nh]]] Cl.
  { exfalso. apply (Cl 0); [lra|]. now rewrite between_start. }
  assert (Co : forall z, connected (fun _ => True) W y z -> connected (fun _ => True) W x z).
  { intros z C. induction C as [|u z C IH _ Cx].
    - apply further with x; [apply here|exact I|exact Cl].
    - now apply further with u. }
  split; [exact I|]. right. split.
  - intros Un. apply Nu. intros r. destruct (Un r) as (z & C & L). exists z. auto.
  - intros h Ih C. apply (Nh h Ih). auto.
Qed.

Section Necessary.
Context {d : nat}.
Variables (P : domain d) (T : list (simplex d)).
Hypothesis triangulates : solid_triangulation P T.

Lemma members t : In t T -> NoDup t /\ length t = S d.
Proof. apply triangulates. Qed.
Lemma meets : simplicial_complex (faces_of T).
Proof. apply triangulates. Qed.
Lemma member_face t : In t T -> faces_of T t.
Proof.
  intros I. destruct (members t I) as [N L]. split; [assumption|].
  split; [intros ->; discriminate|]. exists t. split; [assumption|apply incl_refl].
Qed.
Lemma covers q : underlying P q <-> exists t, In t T /\ conv t q.
Proof. apply triangulates. Qed.
Lemma union_of_cell X : In X (cells P) -> union_of_simplices T X.
Proof. apply triangulates. Qed.

(** ** Cells and pairs of simplices *)

Theorem cell_has_face X t (g : frame d) q : In X (cells P) -> X q -> In t T ->
  same (vertices g) t ->
  conv (vertices g) q -> forall y, conv (carrier g q) y -> X y.
Proof.
  intros IX Xq It [GT TG] C y Cy. destruct (union_of_cell X IX) as (F & HF & E).
  apply E in Xq. destruct Xq as (s & Is & Cs). destruct meets as (_ & _ & M).
  destruct (M s t (HF s Is) (member_face t It)) as (f & Fs & Ft & Cf).
  assert (C' : conv f q) by (apply Cf; [assumption|now apply (conv_incl (vertices g))]).
  apply (conv_face g f q) in C'; [|now apply incl_tran with t].
  apply E. exists s. split; [assumption|]. apply (conv_incl (carrier g q)); [|assumption].
  intros v Iv. apply in_carrier in Iv. destruct Iv as (i & Hi & Pi & ->). apply Fs, C'; assumption.
Qed.
Theorem cell_respected X t (g : frame d) q : In X (cells P) -> X q -> In t T ->
  same (vertices g) t ->
  conv (vertices g) q -> forall v, In v (carrier g q) -> X v.
Proof.
  intros IX Xq It G C v Iv. apply (cell_has_face X t g q IX Xq It G C). now apply conv_point.
Qed.
Theorem carriers_agree t u (g h : frame d) q : In t T -> In u T -> same (vertices g) t ->
  same (vertices h) u ->
  conv (vertices g) q -> conv (vertices h) q -> incl (carrier g q) (carrier h q).
Proof.
  intros It Iu [GT TG] [HU UH] Cg Ch. destruct meets as (_ & _ & M).
  destruct (M t u (member_face t It) (member_face u Iu)) as (f & Ft & Fu & Cf).
  assert (C : conv f q) by (apply Cf;
    [now apply (conv_incl (vertices g))|now apply (conv_incl (vertices h))]).
  apply (conv_face g f q) in C; [|now apply incl_tran with t]. destruct C as [Ig Pg].
  assert (K : incl (carrier g q) (vertices h)).
  { intros v Iv. apply in_carrier in Iv. destruct Iv as (i & Hi & Pi & ->).
    apply UH, Fu, Pg; assumption. }
  assert (A : agree h g).
  { apply (meet_agree h g f); [now apply incl_tran with u|now apply incl_tran with t|].
    intros y Ch' Cg'.
    apply Cf; [now apply (conv_incl (vertices g))|now apply (conv_incl (vertices h))]. }
  assert (B : agree g h).
  { apply (meet_agree g h f); [now apply incl_tran with t|now apply incl_tran with u|].
    intros y Cg' Ch'.
    apply Cf; [now apply (conv_incl (vertices g))|now apply (conv_incl (vertices h))]. }
  intros v Iv. apply in_carrier in Iv. destruct Iv as (i & Hi & Pi & ->).
  destruct (B q Ig (proj1 (conv_vertices h q) Ch) i Hi Pi) as (k & Hk & E & Pk).
  apply in_carrier. exists k. auto.
Qed.

(** ** The simplices, with their frames *)

Lemma all_framed : exists ts : list (frame d), map vertices ts = T.
Proof.
  assert (H : forall s, In s T -> exists t : frame d, vertices t = s).
  { intros s I. apply frame_of; [now apply members|]. apply (proj1 meets). now apply member_face. }
  clear triangulates. induction T as [|s U IH]; [now exists []|].
  destruct (H s) as (t & <-); [now left|].
  destruct IH as (ts & <-); [intros s I; apply H; now right|].
  now exists (t :: ts).
Qed.

Section Framed.
Variable ts : list (frame d).
Hypothesis are : map vertices ts = T.
Lemma framed_member t : In t ts -> In (vertices t) T.
Proof. rewrite <- are. apply in_map. Qed.
Lemma frames_agree t u : In t ts -> In u ts -> agree t u.
Proof.
  intros It Iu. destruct meets as (_ & _ & M).
  destruct (M _ _ (member_face _ (framed_member t It)) (member_face _ (framed_member u Iu)))
    as (f & Ft & Fu & C).
  now apply meet_agree with f.
Qed.
Lemma frames_different t u : In t ts -> In u ts -> same (vertices t) (vertices u) -> t = u.
Proof.
  intros It Iu E. destruct (In_nth ts t t It) as (i & Hi & Ei).
  destruct (In_nth ts u t Iu) as (j & Hj & Ej).
  assert (D : ForallOrdPairs (fun s r => ~ same s r) T) by apply triangulates.
  assert (Nth : forall k, nth k T (vertices t) = vertices (nth k ts t)) by (intros k;
    rewrite <- are; apply map_nth).
  assert (L : length T = length ts) by (rewrite <- are; apply map_length).
  destruct (lt_eq_lt_dec i j) as [[C|C]|C].
  - exfalso. apply (ordered_pairs _ T (vertices t) i j D C); [lia|]. now rewrite !Nth, Ei, Ej.
  - subst j. congruence.
  - exfalso. apply (ordered_pairs _ T (vertices t) j i D C); [lia|]. rewrite !Nth, Ei, Ej.
    destruct E. now split.
Qed.
Notation tri_adjacent := (adjacent ts (fun t => t)).
Notation tri_outer := (outer ts (fun t => t)).

(** A point in the relative interior of facet i, which leads into another simplex. *)
Definition in_facet (t : frame d) i z : Prop := bary t i z = 0 /\ forall k, (k <= d)%nat ->
  k <> i -> 0 < bary t k z.
Lemma in_facet_closed t i z : in_facet t i z -> inside_closed t z.
Proof. intros [Z Pk] k Hk. destruct (Nat.eq_dec k i) as [->|N]; [lra|]. left. auto. Qed.
Lemma leads_to_neighbour t i z p u : In t ts -> In u ts -> (i <= d)%nat -> in_facet t i z ->
  bary t i p < 0 ->
  inside_closed u z -> (forall k, (k <= d)%nat -> bary u k z = 0 -> 0 <= bary u k p) ->
    exists j, tri_adjacent t i u j.
Proof.
  intros It Iu Hi [Z Pz] Np Cu Lead.
  destruct (facet_index u (facet_of t i)) as (j & Hj & E).
  - now apply facet_of_NoDup.
  - now apply facet_of_length.
  - intros v Hv. apply (in_facet_of _ _ _ Hi) in Hv. destruct Hv as (k & Hk & N & ->).
    destruct (frames_agree t u It Iu z (in_facet_closed t i z (conj Z Pz)) Cu k Hk (Pz k Hk N))
      as (l & Hl & -> & _).
    apply in_vertices. eauto.
  - exists j. split; [assumption|]. split; [assumption|]. apply opposite_facets.
    split; [assumption|]. split; [assumption|]. split; [assumption|].
    pose proof (facet_multiple_nonzero _ _ _ _ Hi Hj E) as NZ.
    pose proof (facet_multiple _ _ _ _ Hi Hj E) as M.
    assert (Zu : bary u j z = 0).
    { pose proof (M z) as Mz. rewrite Z in Mz. symmetry in Mz. apply Rmult_integral in Mz.
      destruct Mz; [contradiction|assumption]. }
    pose proof (Lead j Hj Zu) as Pj. pose proof (M p) as Mp. nra.
Qed.

(** ** Cells of lower dimension *)

Lemma three_off_a_line (t : frame d) k l m a b : (k <= d)%nat -> (l <= d)%nat -> (m <= d)%nat ->
  k <> l -> k <> m -> l <> m -> ~ (conv [a; b] (vertex t k) /\ conv [a; b] (vertex t l) /\
    conv [a; b] (vertex t m)).
Proof.
  intros Hk Hl Hm Nkl Nkm Nlm (Ck & Cl & Cm). apply conv_two in Ck, Cl, Cm.
  destruct Ck as (r & _ & Er), Cl as (s & _ & Es), Cm as (w & _ & Ew).
  change (between (d := d)) with (mix (d := d)) in *.
  assert (F := bary_affine t k Hk). pose proof (bary_own t k Hk) as O.
  rewrite Er, affine_mix in O by assumption.
  pose proof (bary_other t k l Hk Hl Nkl) as Zl. rewrite Es, affine_mix in Zl by assumption.
  pose proof (bary_other t k m Hk Hm Nkm) as Zm. rewrite Ew, affine_mix in Zm by assumption.
  assert (Nsw : s <> w) by (intros ->; apply Nlm, (vertex_inj t l m Hl Hm); congruence).
  set (x := bary t k a) in *. set (y := bary t k b) in *.
  assert (Z : (s - w) * (y - x) = 0) by lra. apply Rmult_integral in Z. destruct Z as [Z|Z]; [lra|].
  assert (y = x) by lra. nra.
Qed.

Hypothesis two : (2 <= d)%nat.
Hypothesis proper : proper_domain P.

(** They miss the interiors of the simplices, *)
Theorem low_misses_interior X t x : In X (low_cells P) -> In t ts -> inside t x -> ~ X x.
Proof.
  intros IX It Ix Xx. assert (All : forall k, (k <= d)%nat -> X (vertex t k)).
  { intros k Hk. apply (cell_respected X (vertices t) t x); try assumption.
    - apply low_or_region. now left.
    - now apply framed_member.
    - split; apply incl_refl.
    - apply conv_vertices. intros j Hj. left. now apply Ix.
    - apply in_carrier. exists k. split; [assumption|]. split; [now apply Ix|reflexivity]. }
  unfold low_cells in IX. apply in_app_or in IX.
  destruct IX as [IX|IX]; [|apply in_app_or in IX; destruct IX as [IX|IX]].
  - apply in_map_iff in IX. destruct IX as (v & <- & _).
    assert (0 = 1)%nat; [|discriminate]. apply (vertex_inj t 0 1); [lia|lia|].
    now rewrite (All 0%nat), (All 1%nat) by lia.
  - apply in_map_iff in IX. destruct IX as ((a, b) & <- & _).
    apply (three_off_a_line t 0 1 2 a b); try lia; [discriminate..|]. repeat split; apply All; lia.
  - apply in_map_iff in IX. destruct IX as (f & <- & If). apply (proj2 proper f If).
    set (g y := inner (plane_normal f) y + - plane_offset f).
    assert (A : affine g) by (exists (plane_normal f), (- plane_offset f); intros y; reflexivity).
    assert (Z : forall y, g y = 0).
    { intros y. rewrite (interpolation t g y A). unfold sum. rewrite (sum_ext _ _ (fun _ => 0 * 0)).
      - rewrite sum_scale. ring.
      - intros k Hk. apply in_seq_d in Hk. destruct (All k Hk) as [F _]. unfold g. rewrite F. ring.
        }
    apply norm2_zero. unfold norm2. pose proof (Z (plane_normal f)) as Z1.
    pose proof (Z origin) as Z0.
    unfold g in Z0, Z1. rewrite inner_origin_r in Z0. lra.
Qed.
(** and of those that meet the inside of a facet only walls do, which have it all. *)
Theorem low_in_facet X t i z : In X (low_cells P) -> In t ts -> (i <= d)%nat -> in_facet t i z ->
  X z ->
  In X (wall_cells P) /\ within (conv (facet_of t i)) X.
Proof.
  intros IX It Hi Fz Xz.
  assert (Sub : within (conv (facet_of t i)) X).
  { intros y Cy. apply (cell_has_face X (vertices t) t z); try assumption.
    - apply low_or_region. now left.
    - now apply framed_member.
    - split; apply incl_refl.
    - now apply conv_vertices, in_facet_closed with i.
    - apply (conv_incl (facet_of t i)); [|assumption]. intros v Iv.
      apply in_facet_of in Iv; [|assumption].
      destruct Iv as (k & Hk & N & ->). apply in_carrier. exists k. split; [assumption|].
      split; [now apply Fz|reflexivity]. }
  split; [|assumption].
  assert (Res : forall k, (k <= d)%nat -> k <> i -> X (vertex t k)).
  { intros k Hk N. apply Sub, conv_point, in_facet_of; [assumption|]. exists k. auto. }
  assert (Two : exists k l, (k <= d)%nat /\ (l <= d)%nat /\ k <> i /\ l <> i /\ k <> l).
  { destruct i as [|[|n]]; [exists 1%nat, 2%nat|exists 0%nat, 2%nat|exists 0%nat, 1%nat]; lia. }
  destruct Two as (k & l & Hk & Hl & Nk & Nl & Nkl).
  unfold low_cells in IX. apply in_app_or in IX.
  destruct IX as [IX|IX]; [|apply in_app_or in IX; destruct IX as [IX|IX]].
  - apply in_map_iff in IX. destruct IX as (v & <- & _). exfalso.
    apply Nkl, (vertex_inj t k l Hk Hl).
    now rewrite (Res k Hk Nk), (Res l Hl Nl).
  - unfold wall_cells. destruct (Nat.eq_dec d 2) as [E|N2].
    { clear - IX E. destruct d as [|[|[|n]]]; try discriminate E. assumption. }
    exfalso. apply in_map_iff in IX. destruct IX as ((a, b) & <- & _).
    assert (Three : exists m, (m <= d)%nat /\ m <> i /\ m <> k /\ m <> l).
    { assert (exists m, (m <= 3)%nat /\ m <> i /\ m <> k /\ m <> l) as (m & Hm & H);
        [|exists m; split; [lia|assumption]].
      assert (Off : forall m, ~ In m [i; k; l] -> m <> i /\ m <> k /\ m <> l).
      { intros m N. repeat split; intros ->; apply N; cbn; auto. }
      destruct (in_dec Nat.eq_dec 0%nat [i; k; l]) as [I0|N]; [|exists 0%nat; auto with arith].
      destruct (in_dec Nat.eq_dec 1%nat [i; k; l]) as [I1|N]; [|exists 1%nat; auto with arith].
      destruct (in_dec Nat.eq_dec 2%nat [i; k; l]) as [I2|N]; [|exists 2%nat; auto with arith].
      exists 3%nat. split; [lia|]. apply Off. intros I3.
      assert (L : (length [0; 1; 2; 3] <= length [i; k; l])%nat);
        [|cbn in L; lia].
      apply NoDup_incl_length; [repeat constructor; cbn; lia|].
      intros x [<-|[<-|[<-|[<-|[]]]]]; assumption. }
    destruct Three as (m & Hm & Nm & Nmk & Nml).
    apply (three_off_a_line t k l m a b); auto.
  - unfold wall_cells. destruct (Nat.eq_dec d 2) as [E|N2].
    { rewrite (proj1 proper E) in IX. destruct IX. }
    clear - IX N2. destruct d as [|[|[|n]]]; [assumption|assumption|lia|assumption].
Qed.

(** ** On the hull *)

Lemma neighbour_in_hull t i p : (forall t v, In t T -> In v t -> In v (domain_vertices P)) ->
  what_it_fills P = Hull -> In t ts -> (i <= d)%nat -> In p (domain_vertices P) ->
  bary t i p < 0 -> exists u j, tri_adjacent t i u j.
Proof.
  intros Vertices K It Hi Ip Np. destruct (adjacent_dec ts (fun t => t) t i It) as [A|O];
    [assumption|exfalso].
  assert (0 <= bary t i p); [|lra].
  apply (facet_supports ts (fun t => t) (domain_vertices P) ltac:(lia) frames_agree);
    try assumption.
  - intros u Iu v Iv. now apply (Vertices (vertices u)); [apply framed_member|].
  - intros q C. destruct (proj1 (covers q)) as (s & Is & Cs).
    { exists (region P). split; [|unfold region; now rewrite K]. unfold cells.
      apply in_or_app. right. apply in_or_app. right. apply in_or_app. right. now left. }
    rewrite <- are in Is. apply in_map_iff in Is. destruct Is as (u & <- & Iu).
    exists u. split; [assumption|]. now apply conv_vertices.
Qed.

(** ** Beside what is enclosed *)

(** Near a point that is not in it a union of faces has no points. *)
Lemma off_a_face f z p : faces_of T f -> ~ conv f z ->
  exists e0, 0 < e0 /\ forall e, 0 <= e <= e0 -> ~ conv f (mix z p e).
Proof.
  intros (_ & _ & s & Is & If) N. rewrite <- are in Is. apply in_map_iff in Is.
  destruct Is as (u & <- & Iu).
  set (fits k := 0 <= bary u k z /\ (bary u k z = 0 \/ In (vertex u k) f)).
  assert (dec : forall k, {fits k} + {~ fits k}).
  { intros k. unfold fits. destruct (Rle_dec 0 (bary u k z)); [|right; tauto].
    destruct (Req_EM_T (bary u k z) 0); [left; auto|].
    destruct (in_points (vertex u k) f); [left; auto|right; tauto]. }
  destruct (Forall_dec fits dec (seq 0 (S d))) as [F|F].
  - exfalso. apply N, (conv_face u f z If). rewrite Forall_forall in F. split.
    + intros k Hk. apply in_seq_d, F in Hk. apply Hk.
    + intros k Hk Pk. apply in_seq_d, F in Hk. destruct Hk as (_ & [E|E]); [lra|assumption].
  - apply neg_Forall_Exists_neg in F; [|assumption]. apply Exists_exists in F.
    destruct F as (k & Hk & Nk).
    apply in_seq_d in Hk. destruct (Rlt_dec (bary u k z) 0) as [L|L].
    + destruct (nearby [fun x => - bary u k x] z p) as (e0 & He & K).
      { intros g [<-|[]]. split; [now apply affine_opp, bary_affine|lra]. }
      exists e0. split; [lra|]. intros e E C. specialize (K e E _ (or_introl eq_refl)).
      cbn beta in K.
      apply (conv_face u f _ If) in C. destruct C as [I _]. specialize (I k Hk). lra.
    + destruct (nearby [bary u k] z p) as (e0 & He & K).
      { intros g [<-|[]]. split; [now apply bary_affine|]. unfold fits in Nk.
        destruct (Req_EM_T (bary u k z) 0); [exfalso; apply Nk; lra|lra]. }
      exists e0. split; [lra|]. intros e E C. specialize (K e E _ (or_introl eq_refl)).
      apply (conv_face u f _ If) in C. destruct C as [_ I]. apply Nk. split; [lra|]. right.
      now apply I.
Qed.
Lemma off_a_union X z p : union_of_simplices T X -> ~ X z ->
  exists e0, 0 < e0 /\ forall e, 0 <= e <= e0 -> ~ X (mix z p e).
Proof.
  intros (F & HF & E) N.
  assert (G : exists e0, 0 < e0 /\ forall e, 0 <= e <= e0 -> forall f, In f F ->
    ~ conv f (mix z p e)).
  { assert (NF : forall f, In f F -> ~ conv f z) by (intros f If C; apply N, E; eauto).
    clear E N. induction F as [|f F IH]; [exists 1; split; [lra|intros e _ f []]|].
    destruct IH as (e0 & P0 & K0); [intros; apply HF; now right|intros; apply NF; now right|].
    destruct (off_a_face f z p (HF f (or_introl eq_refl)) (NF f (or_introl eq_refl)))
      as (e1 & P1 & K1).
    exists (Rmin e0 e1). split; [now apply Rmin_glb_lt|]. intros e He. pose proof (Rmin_l e0 e1).
    pose proof (Rmin_r e0 e1).
    intros g [<-|Ig]; [apply K1; lra|apply K0; [lra|assumption]]. }
  destruct G as (e0 & P0 & K). exists e0. split; [assumption|]. intros e He Xe. apply E in Xe.
  destruct Xe as (f & If & C). now apply (K e He f If).
Qed.

Lemma off_all (L : list (point d -> Prop)) z p : (forall X, In X L -> union_of_simplices T X) ->
  (forall X, In X L -> ~ X z) -> exists e0, 0 < e0 /\ forall e, 0 <= e <= e0 -> forall X, In X L ->
    ~ X (mix z p e).
Proof.
  induction L as [|X L IH]; intros U N; [exists 1; split; [lra|intros e _ X []]|].
  destruct IH as (e0 & P0 & K0); [intros; apply U; now right|intros; apply N; now right|].
  destruct (off_a_union X z p (U X (or_introl eq_refl)) (N X (or_introl eq_refl)))
    as (e1 & P1 & K1).
  exists (Rmin e0 e1). split; [now apply Rmin_glb_lt|]. intros e He. pose proof (Rmin_l e0 e1).
  pose proof (Rmin_r e0 e1).
  intros Y [<-|I]; [apply K1; lra|apply K0; [lra|assumption]].
Qed.

Theorem neighbour_in_enclosed t i z : what_it_fills P = Enclosed -> In t ts -> (i <= d)%nat ->
  in_facet t i z ->
  (forall X, In X (wall_cells P) -> ~ X z) -> exists u j, tri_adjacent t i u j.
Proof.
  intros K It Hi Fz Off. pose proof (in_facet_closed t i z Fz) as Cz.
  set (p := mix (vertex t i) z 2).
  assert (Np : bary t i p < 0).
  { unfold p. rewrite affine_mix by now apply bary_affine. rewrite bary_own by assumption.
    destruct Fz as [-> _]. lra. }
  destruct (towards (fun t => t) z p ts) as [(u & Iu & I & Lead)|(e0 & He & Out)].
  { destruct (leads_to_neighbour t i z p u It Iu Hi Fz Np I Lead) as (j & A). eauto. }
  exfalso.
  assert (R : region P z).
  { assert (U : underlying P z).
    { apply covers. exists (vertices t). split; [now apply framed_member|now apply conv_vertices]. }
    destruct U as (X & IX & Xz). apply low_or_region in IX.
    destruct IX as [IX| ->]; [exfalso|assumption].
    apply (Off X); [|assumption]. now apply (low_in_facet X t i z). }
  destruct (off_all (wall_cells P) z p) as (e1 & P1 & Clear).
  { intros X IX. apply union_of_cell, low_or_region. left. now apply walls_low. }
  { assumption. }
  set (e := Rmin e0 e1). assert (E : 0 < e /\ e <= e0 /\ e <= e1).
  { unfold e. pose proof (Rmin_l e0 e1). pose proof (Rmin_r e0 e1).
    split; [apply Rmin_glb_lt; lra|lra]. }
  set (y := mix z p e).
  assert (Cl : clear (walls_of P) z y).
  { intros s Hs W. apply walls_are_cells in W. destruct W as (X & IX & Xs).
    apply (Clear (s * e)) with X; [nra|assumption|]. replace (mix z p (s * e)) with (between z y s);
      [assumption|].
    change (between (d := d)) with (mix (d := d)). apply affine_separate. intros f F. unfold y.
    rewrite !affine_mix by assumption. ring. }
  assert (R' : region P y).
  { unfold region in *. rewrite K in *. now apply (enclosed_along _ _ z). }
  destruct (proj1 (covers y)) as (s & Is & Cs).
  { exists (region P). split; [|assumption]. apply low_or_region. now right. }
  rewrite <- are in Is. apply in_map_iff in Is. destruct Is as (u & <- & Iu).
  apply (Out e) with u; [lra|assumption|]. now apply conv_vertices.
Qed.
End Framed.

(** What is across, as simplices: [g] has the vertices of a member, and its facet i has another. *)
Theorem neighbour t (g : frame d) i z : (2 <= d)%nat -> proper_domain P ->
  (forall t v, In t T -> In v t -> In v (domain_vertices P)) -> In t T -> same (vertices g) t ->
    (i <= d)%nat -> in_facet g i z ->
  (what_it_fills P = Hull -> exists p, In p (domain_vertices P) /\ bary g i p < 0) ->
  (what_it_fills P = Enclosed -> forall X, In X (wall_cells P) -> ~ X z) ->
  exists u w, In u T /\ In w (domain_vertices P) /\ bary g i w < 0 /\ same u (w :: facet_of g i).
Proof.
  intros Two Pr Given It E Hi [Fz Fp] InHull InEnclosed. destruct all_framed as (ts & are).
  rewrite <- are in It. apply in_map_iff in It. destruct It as (h & <- & Ih).
  assert (V : In (vertex g i) (vertices h)) by (apply E, in_vertices; eauto).
  apply in_vertices in V. destruct V as (m & Hm & Vm).
  pose proof (bary_unique g h i m Hi Hm E Vm) as B.
  assert (Fh : in_facet h m z).
  { split; [now rewrite <- B|]. intros k Hk N.
    assert (V : In (vertex h k) (vertices g)) by (apply E, in_vertices; eauto).
    apply in_vertices in V. destruct V as (j & Hj & Vj).
    rewrite <- (bary_unique g h j k Hj Hk E (eq_sym Vj)). apply Fp; [assumption|].
    intros ->. apply N, (vertex_inj h); congruence. }
  assert (A : exists u j, adjacent ts (fun t => t) h m u j).
  { destruct (what_it_fills P) eqn:K.
    - apply (neighbour_in_enclosed ts are Two Pr h m z K Ih Hm Fh). auto.
    - destruct (InHull eq_refl) as (p & Ip & Np).
      apply (neighbour_in_hull ts are Two h m p Given K Ih Hm Ip).
      now rewrite <- B. }
  destruct A as (u & j & _ & Iu & O). pose proof O as (_ & Hj & _).
  exists (vertices u), (vertex u j). split; [now apply framed_member with ts|]. split; [|split].
  - apply (Given (vertices u)); [now apply framed_member with ts|]. apply in_vertices. eauto.
  - rewrite B. apply O.
  - destruct O as (_ & _ & HU & UH & _). split.
    + intros v Iv. apply in_vertices in Iv. destruct Iv as (l & Hl & ->).
      destruct (Nat.eq_dec l j) as [->|N]; [now left|right].
      destruct (UH l Hl N) as (k & Hk & Nk & ->). apply in_facet_of; [assumption|].
      assert (V : In (vertex h k) (vertices g)) by (apply E, in_vertices; eauto).
      apply in_vertices in V. destruct V as (n & Hn & Vn). exists n. split; [assumption|].
      split; [|assumption].
      intros ->. apply Nk, (vertex_inj h); congruence.
    + intros v [<-|Iv]; [apply in_vertices; eauto|]. apply (in_facet_of _ _ _ Hi) in Iv.
      destruct Iv as (n & Hn & Nn & ->).
      assert (V : In (vertex g n) (vertices h)) by (apply E, in_vertices; eauto).
      apply in_vertices in V. destruct V as (k & Hk & Vk). rewrite Vk.
      destruct (HU k Hk) as (l & Hl & _ & ->); [|apply in_vertices; eauto].
      intros ->. apply Nn, (vertex_inj g); congruence.
Qed.
End Necessary.
