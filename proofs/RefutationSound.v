(** * What the acceptance of a refutation means

    The evidence of an accepted refutation is a breach of the caller's own points and simplices, in
    the words of [Breach.v] ([evidence_breach]); and so they are not what they claim to be
    ([refute_sound]).  Nothing is assumed of the caller's mesh. *)
From Coq Require Import Reals Lra Lia List Arith ZArith Bool.
From Circumspect Require Import Refutation Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Faces LiftingMap Breach.
From Circumspect Require Import Orientation Integers RefutationSigns Evidence.
Import ListNotations.
Open Scope R_scope.

(** ** The caller's points and simplices *)

Section Caller.
Context {d : nat}.
Context {orient : list (point d) -> R} {pr : predicates} {r : R}.
Hypothesis M : measured orient pr r.
Variables (P : list site) (l : list row) (S : PM.t site) (L : PM.t row).
Hypothesis shaped_points : Forall (well_shaped d) P.
Hypothesis find_point : forall k, PM.find k S = numbered P k.
Hypothesis find_row : forall t, PM.find t L = numbered l t.
Notation place := (@place_of d r).
Notation places := (map (@place_of d r)).
Notation framed := (framed orient pr r).
Notation caller_entry := (@caller_entry d r P).
Notation caller_rows := (@caller_rows d r P l).
Notation caller_points := (@caller_points d r P).

(** ** Entries and simplices *)

Lemma caller_named n : caller_entry n = option_map place (named S n).
Proof. destruct n as [k|]; [cbn; now rewrite find_point|reflexivity]. Qed.
Lemma named_in n p : named S n = Some p -> In p P.
Proof. destruct n as [k|]; [|discriminate]. cbn. rewrite find_point. apply numbered_in. Qed.

Lemma all_named_rows x X : all_named S x = Some X ->
  map caller_entry x = map Some (places X) /\ incl X P.
Proof.
  revert X. induction x as [|n x IH]; intros X E; cbn in E.
  - injection E as <-. split; [reflexivity|apply incl_nil_l].
  - destruct (named S n) as [p|] eqn:N; [|discriminate].
    destruct (all_named S x) as [Y|]; [|discriminate]. injection E as <-.
    destruct (IH Y eq_refl) as [Q I]. split.
    + cbn. now rewrite caller_named, N, Q.
    + intros q [<-|Hq]; [now apply named_in in N|auto].
Qed.

(** The d+1 known vertices of row x. *)
Record vertices_are (x : row) (X : list site) : Prop := {
  vertices_rows : map caller_entry x = map Some (places X);
  vertices_known : incl X P;
  vertices_number : length X = Datatypes.S d
}.
Lemma vertices_shaped x X : vertices_are x X -> Forall (well_shaped d) X.
Proof. intros [_ I _]. eapply incl_Forall; eauto. Qed.
Lemma simplex_of_vertices x X : simplex_of pr S x = Some X -> vertices_are x X.
Proof.
  unfold simplex_of, right_length. rewrite (dimension_d M).
  destruct (Nat.eqb_spec (length x) (Datatypes.S d)) as [N|]; [|discriminate].
  intros E. apply all_named_rows in E. destruct E as [E I]. constructor; auto.
  apply (f_equal (@length _)) in E. rewrite !map_length in E. congruence.
Qed.
Lemma proper_simplex_of_frame x X : proper_simplex_of pr S x = Some X ->
  vertices_are x X /\ exists t, framed X t.
Proof.
  unfold proper_simplex_of. destruct (simplex_of pr S x) as [Y|] eqn:E; [|discriminate].
  destruct (proper pr Y) eqn:Q; [|discriminate]. intros H. injection H as ->.
  apply simplex_of_vertices in E. split; [assumption|].
  apply proper_framed; auto; [now apply vertices_shaped in E|now destruct E].
Qed.

Lemma row_at_in t f : row_at L t f = true ->
  exists x, numbered l t = Some x /\ In (map caller_entry x) caller_rows /\ f x = true.
Proof.
  unfold row_at. rewrite find_row. destruct (numbered l t) as [x|] eqn:E; [|discriminate].
  intros H. exists x. split; [reflexivity|]. split; [|assumption].
  apply in_map. now apply numbered_in in E.
Qed.
Lemma entry_at_in t i f : entry_at L t i f = true ->
  exists x n, numbered l t = Some x /\ In (map caller_entry x) caller_rows /\
    nth_error x i = Some n /\ f n = true.
Proof.
  intros H. apply row_at_in in H. destruct H as (x & N & I & H).
  destruct (nth_error x i) as [n|] eqn:E; [|discriminate]. now exists x, n.
Qed.
Lemma simplex_at_in t f : simplex_at pr S L t f = true ->
  exists x X, numbered l t = Some x /\ vertices_are x X /\ listed caller_rows (places X) /\
    f X = true.
Proof.
  intros H. apply row_at_in in H. destruct H as (x & N & I & H).
  destruct (simplex_of pr S x) as [X|] eqn:E; [|discriminate]. apply simplex_of_vertices in E.
  exists x, X. repeat split; try apply E; auto. unfold listed. now rewrite <- (vertices_rows x X E).
Qed.
Lemma proper_at_in t f : proper_at pr S L t f = true ->
  exists X g, framed X g /\ incl X P /\ listed caller_rows (places X) /\ f X = true.
Proof.
  intros H. apply row_at_in in H. destruct H as (x & N & I & H).
  destruct (proper_simplex_of pr S x) as [X|] eqn:E; [|discriminate].
  apply proper_simplex_of_frame in E. destruct E as (E & g & G).
  exists X, g. repeat split; try apply E; try apply G; auto.
  unfold listed. now rewrite <- (vertices_rows x X E).
Qed.
Lemma proper_with_in K f : proper_with pr S K f = true ->
  exists X g, framed X g /\ incl X P /\ f X = true.
Proof.
  unfold proper_with. rewrite andb_true_iff. intros [_ H]. revert H.
  destruct (proper_simplex_of pr S (map Some K)) as [X|] eqn:E; [|discriminate].
  apply proper_simplex_of_frame in E. destruct E as (E & g & G). intros H.
  exists X, g. repeat split; try apply E; try apply G; auto.
Qed.
Lemma point_at_in k f : point_at S k f = true -> exists p, In p P /\ f p = true.
Proof.
  unfold point_at. rewrite find_point. destruct (numbered P k) as [p|] eqn:E; [|discriminate].
  intros H. exists p. split; [now apply numbered_in in E|assumption].
Qed.
Lemma caller_point p : In p P -> In (place p) caller_points.
Proof. apply in_map. Qed.
Lemma caller_incl X : incl X P -> incl (places X) caller_points.
Proof. apply incl_map. Qed.
Lemma shaped_in p : In p P -> well_shaped d p.
Proof. now apply Forall_forall. Qed.

(** ** The evidence is a breach *)

Lemma two_places {A} (m : list A) i j a b : nth_error m i = Some a -> nth_error m j = Some b ->
  (i < j)%nat -> exists m1 m2 m3, m = m1 ++ a :: m2 ++ b :: m3.
Proof.
  intros Ha Hb H. apply nth_error_split in Ha. destruct Ha as (m1 & m' & -> & <-).
  rewrite nth_error_app2 in Hb by lia. destruct (j - length m1)%nat as [|k] eqn:E; [lia|].
  cbn in Hb. apply nth_error_split in Hb. destruct Hb as (m2 & m3 & -> & _). now exists m1, m2, m3.
Qed.
Lemma duplicate_breach t u x y X Y : t <> u -> numbered l t = Some x -> numbered l u = Some y ->
  vertices_are x X -> vertices_are y Y -> same (places X) (places Y) ->
  duplicate_simplex caller_rows.
Proof.
  assert (G : forall i j x y X Y, nth_error l i = Some x -> nth_error l j = Some y -> (i < j)%nat ->
    vertices_are x X -> vertices_are y Y -> same (places X) (places Y) ->
    duplicate_simplex caller_rows).
  { clear. intros i j x y X Y Hx Hy H VX VY E.
    destruct (two_places l i j x y Hx Hy H) as (m1 & m2 & m3 & E').
    exists (map (map caller_entry) m1), (map (map caller_entry) m2), (map (map caller_entry) m3),
      (places X), (places Y). split; [|assumption]. unfold caller_rows.
    rewrite E', map_app. cbn [map]. rewrite map_app. cbn [map].
    now rewrite (vertices_rows x X VX), (vertices_rows y Y VY). }
  intros N Hx Hy VX VY [E1 E2]. unfold numbered in Hx, Hy.
  destruct (Nat.lt_trichotomy (pred (Pos.to_nat t)) (pred (Pos.to_nat u))) as [H|[H|H]].
  - apply (G _ _ x y X Y Hx Hy); auto. now split.
  - lia.
  - apply (G _ _ y x Y X Hy Hx); auto. now split.
Qed.

Lemma overlap_breach X Y a b q w : framed X a -> framed Y b -> listed caller_rows (places X) ->
  listed caller_rows (places Y) -> overlapping pr X Y q w = true -> overlap caller_rows.
Proof.
  intros FX FY LX LY O. unfold overlapping in O. rewrite !andb_true_iff, negb_true_iff in O.
  destruct O as [[[W IX] IY] N]. apply (written M) in W. destruct W as [Hq Hw].
  exists (places X), (places Y), (place_over r q w). split; [assumption|]. split; [assumption|].
  split; [now apply (in_simplex_conv M X a FX)|]. split; [now apply (in_simplex_conv M Y b FY)|].
  rewrite <- (framed_vertices X a FX), <- (framed_vertices Y b FY).
  apply carriers_overlap. intros E.
  assert (T : same_places (carrier_of pr X q w) (carrier_of pr Y q w) = true); [|congruence].
  assert (SX := framed_shaped X a FX). assert (SY := framed_shaped Y b FY).
  apply (same_places_same M).
  - eapply incl_Forall; [apply carrier_of_incl|assumption].
  - eapply incl_Forall; [apply carrier_of_incl|assumption].
  - destruct (carrier_of_carrier M X a FX q w Hq Hw) as [X1 X2].
    destruct (carrier_of_carrier M Y b FY q w Hq Hw) as [Y1 Y2]. destruct E as [E1 E2].
    split; eauto using incl_tran.
Qed.

Lemma overused_breach X Y Z a b c i j k : framed X a -> framed Y b -> framed Z c ->
  listed caller_rows (places X) -> listed caller_rows (places Y) ->
  listed caller_rows (places Z) -> overused pr X i Y j Z k = true -> facet_overused caller_rows.
Proof.
  intros FX FY FZ LX LY LZ O. unfold overused in O. rewrite !andb_true_iff in O.
  destruct O as [[[[SXY SYZ] NXY] NYZ] NXZ].
  apply (same_facet_shared M X Y a b FX FY) in SXY.
  apply (same_facet_shared M Y Z b c FY FZ) in SYZ.
  destruct SXY as (N & Len & IX & IY & SXY), SYZ as (_ & _ & _ & IZ & SYZ).
  exists (places X), (places Y), (places Z), (places (remove i X)).
  assert (SXZ : same (remove i (places X)) (remove k (places Z))).
  { destruct SXY, SYZ. split; eauto using incl_tran. }
  repeat (split; [eauto using (other_apex_different M)|]).
  rewrite remove_map. destruct SXZ as [SXZ _]. apply incl_tran with (1 := SXZ), remove_incl.
Qed.

Lemma hole_breach X a q w facets : framed X a -> incl X P -> hole pr S q w X l facets = true ->
  uncovered caller_points caller_rows.
Proof.
  intros FX IX H. unfold hole in H. rewrite !andb_true_iff in H. destruct H as [[W I] B].
  apply (written M) in W. destruct W as [Hq Hw]. exists (place_over r q w). split.
  - apply conv_incl with (places X); [now apply caller_incl|]. now apply (in_simplex_conv M X a FX).
  - intros s Hs. apply in_map_iff in Hs. destruct Hs as (x & E & Hx). clear - E Hx B Hq Hw
      M shaped_points find_point.
    revert facets B. induction l as [|y m IH]; intros facets B; [destruct Hx|].
    destruct facets as [|i facets]; [discriminate|]. cbn in B. apply andb_true_iff in B.
    destruct B as [By B]. destruct Hx as [->|Hx]; [|eauto].
    destruct (proper_simplex_of pr S x) as [Y|] eqn:EY; [|discriminate].
    apply proper_simplex_of_frame in EY. destruct EY as (V & b & FY).
    rewrite (vertices_rows x Y V) in E. apply map_some_inj in E. subst s.
    now apply (beyond_not_conv M Y b FY q w i).
Qed.

Lemma unused_breach p : In p P -> existsb (lists S p) l = false ->
  unused_point caller_points caller_rows.
Proof.
  intros Hp N. exists (place p). split; [now apply caller_point|]. intros s Hs I.
  apply in_map_iff in Hs. destruct Hs as (x & E & Hx).
  assert (T : existsb (lists S p) l = true); [|congruence].
  apply existsb_exists. exists x. split; [assumption|]. unfold lists. apply existsb_exists.
  rewrite <- E in I. apply in_map_iff in I. destruct I as (n & En & Hn).
  exists n. split; [assumption|]. rewrite caller_named in En.
  destruct (named S n) as [q|] eqn:Eq; [|discriminate]. injection En as En.
  apply (same_place_place M); auto.
  - now apply shaped_in.
  - apply shaped_in. now apply named_in in Eq.
Qed.

Variable h : point d -> R.
Hypothesis heights : heights_of r h P.
Lemma heights_among p X : In p P -> incl X P -> heights_of r h (p :: X).
Proof. intros Hp I q [<-|Hq]; apply heights; auto. Qed.

Lemma framed_simplex X a : framed X a -> listed caller_rows (places X) ->
  listed_simplex caller_rows (places X).
Proof.
  intros FX LX. split; [assumption|]. rewrite <- (framed_vertices X a FX).
  split; [apply vertices_length|apply vertices_independent].
Qed.
Lemma below_breach X a p : framed X a -> incl X P -> listed caller_rows (places X) -> In p P ->
  (0 <? below_sign pr X p)%Z = true -> point_below_plane h caller_points caller_rows.
Proof.
  intros FX IX LX Hp B. exists (places X), (place p). split; [now apply (framed_simplex X a)|].
  split; [now apply caller_point|]. rewrite <- (framed_vertices X a FX).
  apply below_all_planes.
  apply (below_witness M X a FX); auto using heights_among.
  now apply shaped_in.
Qed.

Lemma not_local_breach X Y a b i j : framed X a -> framed Y b -> incl X P -> incl Y P ->
  listed caller_rows (places X) -> listed caller_rows (places Y) ->
  not_local pr X i Y j = true -> facet_below_plane h caller_rows.
Proof.
  intros FX FY IX IY LX LY N. unfold not_local in N. apply andb_true_iff in N.
  destruct N as [SF B]. destruct (nth_error Y j) as [v|] eqn:Ev; [|discriminate].
  apply nth_error_In in Ev. apply (same_facet_shared M X Y a b FX FY) in SF.
  destruct SF as (N & Len & JX & JY & _).
  exists (places X), (places Y), (places (remove i X)), (place v).
  split; [now apply (framed_simplex X a)|].
  repeat (split; [assumption || now apply in_map|]).
  rewrite <- (framed_vertices X a FX). apply below_all_planes.
  apply (below_witness M X a FX); auto using heights_among.
  apply shaped_in. auto.
Qed.

Lemma submerged_breach Y i v X a : listed caller_rows (places Y) -> nth_error Y i = Some v ->
  framed X a -> incl X P -> incl Y P -> submerged pr X v = true ->
  vertex_submerged h caller_points caller_rows.
Proof.
  intros LY Ev FX IX IY Q. unfold submerged in Q. apply andb_true_iff in Q. destruct Q as [I B].
  apply nth_error_In in Ev. assert (Hv : well_shaped d v) by (apply shaped_in; auto).
  apply (in_simplex_conv M X a FX v 1 Hv eq_refl) in I. rewrite place_over_one in I.
  destruct I as [I C].
  exists (places Y), (place v), (places X). split; [assumption|]. split; [now apply in_map|].
  split; [now apply caller_incl|]. split; [assumption|].
  rewrite <- (framed_vertices X a FX). apply above_all_planes; [assumption|].
  apply (above_witness_plane M X a FX);
    auto using heights_among.
Qed.

(** All together.  Where the evidence is a ball the heights are those of the paraboloid. *)
Theorem evidence_breach c e : concerns e c = true -> (c = Delaunay -> h = norm2) ->
  holds pr S L l e = true -> breach c h caller_points caller_rows e.
Proof.
  intros Co D H. destruct e; cbn [holds breach] in *.
  - apply row_at_in in H. destruct H as (x & _ & I & H).
    exists (map caller_entry x). split; [assumption|].
    unfold right_length in H. apply negb_true_iff, Nat.eqb_neq in H. rewrite (dimension_d M) in H.
    now rewrite map_length.
  - apply entry_at_in in H. destruct H as (x & n & _ & I & E & H).
    exists (map caller_entry x). split; [assumption|]. apply nth_error_In in E.
    replace None with (caller_entry n); [now apply in_map|]. rewrite caller_named.
    now destruct (named S n).
  - apply andb_true_iff in H. destruct H as [N H]. apply negb_true_iff, Nat.eqb_neq in N.
    apply entry_at_in in H. destruct H as (x & m & Nx & I & Em & H).
    apply entry_at_in in H. destruct H as (y & n & Ny & _ & En & H).
    rewrite Nx in Ny. injection Ny as <-. unfold repeats in H.
    destruct m as [k|], n as [k'|]; try discriminate.
    apply andb_true_iff in H. destruct H as [Ek H]. apply Pos.eqb_eq in Ek. subst k'.
    unfold point_at in H. rewrite find_point in H.
    destruct (numbered P k) as [p|] eqn:Ep; [|discriminate].
    exists (map caller_entry x), i, j, (place p). split; [assumption|]. split; [assumption|].
    assert (Ec : caller_entry (Some k) = Some (place p)) by (cbn; now rewrite Ep).
    split; rewrite <- Ec; now apply map_nth_error.
  - apply simplex_at_in in H. destruct H as (x & X & _ & V & LX & H).
    exists (places X). split; [assumption|]. apply negb_true_iff in H.
    apply (flat_dependent M X); [|apply V|assumption].
    now apply vertices_shaped in V.
  - apply andb_true_iff in H. destruct H as [N H]. apply negb_true_iff, Pos.eqb_neq in N.
    apply simplex_at_in in H. destruct H as (x & X & Nx & VX & _ & H).
    apply simplex_at_in in H. destruct H as (y & Y & Ny & VY & _ & H).
    apply (duplicate_breach t u x y X Y); auto.
    apply (same_places_same M) in H; eauto using vertices_shaped.
  - apply proper_at_in in H. destruct H as (X & a & FX & _ & LX & H).
    apply proper_at_in in H. destruct H as (Y & b & FY & _ & LY & H).
    apply proper_at_in in H. destruct H as (Z & g & FZ & _ & LZ & H).
    exact (overused_breach X Y Z a b g i j k FX FY FZ LX LY LZ H).
  - apply proper_at_in in H. destruct H as (X & a & FX & _ & LX & H).
    apply proper_at_in in H. destruct H as (Y & b & FY & _ & LY & H).
    exact (overlap_breach X Y a b q w FX FY LX LY H).
  - apply point_at_in in H. destruct H as (q & Hq & H). apply negb_true_iff in H.
    exact (unused_breach q Hq H).
  - apply proper_with_in in H. destruct H as (Y & a & FY & IY & H).
    exact (hole_breach Y a q w facets FY IY H).
  - apply proper_at_in in H. destruct H as (X & a & FX & IX & LX & H).
    apply point_at_in in H. destruct H as (q & Hq & H).
    apply point_below_in_ball. destruct c; try discriminate. rewrite <- D by reflexivity.
    exact (below_breach X a q FX IX LX Hq H).
  - apply proper_at_in in H. destruct H as (X & a & FX & IX & LX & H).
    apply proper_at_in in H. destruct H as (Y & b & FY & IY & LY & H).
    assert (B := not_local_breach X Y a b i j FX FY IX IY LX LY H).
    destruct c; [discriminate| |assumption].
    apply facet_below_not_local. now rewrite <- D.
  - apply proper_at_in in H. destruct H as (X & a & FX & IX & LX & H).
    apply point_at_in in H. destruct H as (q & Hq & H). exact (below_breach X a q FX IX LX Hq H).
  - apply simplex_at_in in H. destruct H as (x & Y & _ & VY & LY & H).
    destruct (nth_error Y i) as [v|] eqn:Ev; [|discriminate].
    apply proper_with_in in H. destruct H as (Z & a & FZ & IZ & H).
    apply (submerged_breach Y i v Z a LY Ev FZ IZ); [apply VY|assumption].
Qed.
End Caller.

(** ** The whole *)

Section Whole.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis M : forall r, 0 < r -> measured orient pr r.
Variable c : refutation.
Hypothesis accepted : refute_in pr c = true.

Let r := refuted_unit c.
Let P := map (site_for (refuted c)) (sites c).

Lemma place_site_for p : @place_of d r (site_for (refuted c) p) = place_of r p.
Proof. unfold site_for. now destruct (weights_of (refuted c)). Qed.
Lemma points_site_for : @caller_points d r P = caller_points r (sites c).
Proof. unfold caller_points, P. rewrite map_map. apply map_ext, place_site_for. Qed.
Lemma rows_site_for : @caller_rows d r P (rows c) = caller_rows r (sites c) (rows c).
Proof.
  unfold caller_rows. apply map_ext. intros x. apply map_ext. intros [k|]; [|reflexivity].
  cbn. unfold P, numbered. rewrite nth_error_map.
  destruct (nth_error (sites c) _); [|reflexivity]. cbn. now rewrite place_site_for.
Qed.

Theorem accepted_breach (w : point d -> R) :
  (refuted c = WeightedDelaunay ->
   forall p, In p (sites c) -> w (place_of r p) = r ^ 2 * IZR (weight p)) ->
  concerns (because c) (refuted c) = true /\
  breach (refuted c) (lifted (refuted c) w) (caller_points r (sites c))
    (caller_rows r (sites c) (rows c)) (because c).
Proof.
  intros W. assert (A := accepted). unfold refute_in in A. rewrite !andb_true_iff in A.
  destruct A as [[[[Co Pn] Pd] Sh] H]. split; [assumption|].
  rewrite <- points_site_for, <- rows_site_for.
  apply Z.ltb_lt, IZR_lt in Pn, Pd.
  assert (Pr : 0 < r) by (unfold r, refuted_unit; now apply Rdiv_lt_0_compat).
  eapply (evidence_breach (M r Pr)); try eassumption.
  - apply Forall_forall. intros p Hp. apply in_map_iff in Hp. destruct Hp as (q & <- & Hq).
    rewrite forallb_forall in Sh. specialize (Sh q Hq). apply Nat.eqb_eq in Sh.
    rewrite (dimension_d (M r Pr)) in Sh.
    unfold well_shaped, site_for. now destruct (weights_of (refuted c)).
  - intros k. rewrite number_find. unfold P, numbered. now rewrite nth_error_map.
  - intros t. rewrite number_find. unfold numbered. now destruct (nth_error _ _).
  - intros p Hp. apply in_map_iff in Hp. destruct Hp as (q & <- & Hq).
    rewrite place_site_for. unfold height_of. rewrite place_site_for. unfold lifted, site_for.
    destruct (refuted c); cbn [weights_of weight]; [ring..|]. now rewrite W.
  - now intros ->.
Qed.

Theorem accepted_refuted (w : point d -> R) :
  (refuted c = WeightedDelaunay ->
   forall p, In p (sites c) -> w (place_of r p) = r ^ 2 * IZR (weight p)) ->
  ~ claims (refuted c) w (caller_points r (sites c)) (caller_rows r (sites c) (rows c)).
Proof. intros W. destruct (accepted_breach w W). eapply breach_refutes; eassumption. Qed.
End Whole.

(** What the caller has claimed is not so. *)
Theorem refute_sound D c : refute D c = true -> ~ refuted_claim D c.
Proof.
  intros A. unfold refuted_claim, refuted_weights, refuted_points, refuted_simplices.
  assert (H : forall w : point (dimension_of D) -> R, (refuted c = WeightedDelaunay -> forall p,
      In p (sites c) -> w (place_of (refuted_unit c) p) = refuted_unit c ^ 2 * IZR (weight p)) ->
    ~ claims (refuted c) w (caller_points (refuted_unit c) (sites c))
        (caller_rows (refuted_unit c) (sites c) (rows c))).
  { destruct D; cbn [dimension_of] in *; intros w.
    - now apply (accepted_refuted measured_plane c).
    - now apply (accepted_refuted measured_space c). }
  destruct (refuted c); cbn [claims] in H.
  - apply (H (fun _ => 0)). discriminate.
  - apply (H (fun _ => 0)). discriminate.
  - intros (w & W & C). now apply (H w).
Qed.

(** Why not: the evidence names a breach. *)
Theorem refute_breach D c (w : point (dimension_of D) -> R) : refute D c = true ->
  (refuted c = WeightedDelaunay -> refuted_weights D c w) ->
  breach (refuted c) (lifted (refuted c) w) (refuted_points D c) (refuted_simplices D c)
    (because c).
Proof.
  intros A W. unfold refuted_weights, refuted_points, refuted_simplices in *.
  destruct D; cbn [dimension_of] in *.
  - now apply (accepted_breach measured_plane c).
  - now apply (accepted_breach measured_space c).
Qed.
