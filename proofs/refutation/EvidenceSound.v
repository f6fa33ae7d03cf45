(** * Evidence that the checker accepts shows that the rule is broken

    One lemma for each kind of evidence; all together in [evidence_breach]. *)
From Coq Require Import Rbase Rfunctions Lra Lia List Arith ZArith Bool.
From Circumspect Require Import Refutation Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Faces LiftingMap Breach.
From Circumspect Require Import Orientation Integers RefutationSigns CallerMesh.
Import ListNotations.
Open Scope R_scope.

Section Caller.
Context {d : nat}.
Context {orient : list (point d) -> R} {pr : predicates} {r : R}.
Hypothesis M : measured orient pr r.
Variables (P : list site) (l : list row) (S : Table.t site) (L : Table.t row).
Hypothesis shaped_points : Forall (well_shaped d) P.
Hypothesis find_point : forall k, Table.find k S = numbered P k.
Hypothesis find_row : forall t, Table.find t L = numbered l t.
Notation place := (@place_of d r).
Notation places := (map (@place_of d r)).
Notation framed := (framed orient pr r).
Notation caller_entry := (@caller_entry d r P).
Notation caller_rows := (@caller_rows d r P l).
Notation caller_points := (@caller_points d r P).

(* What [CallerMesh.v] proves, for these points and simplices. *)
Notation vertices_are := (@vertices_are d r P).
Notation vertices_rows := (@vertices_rows d r P).
Let caller_named := CallerMesh.caller_named M P l S L shaped_points find_point find_row.
Let named_in := CallerMesh.named_in M P l S L shaped_points find_point find_row.
Let vertices_shaped := CallerMesh.vertices_shaped M P l S L shaped_points find_point find_row.
Let simplex_of_vertices :=
  CallerMesh.simplex_of_vertices M P l S L shaped_points find_point find_row.
Let proper_simplex_of_frame :=
  CallerMesh.proper_simplex_of_frame M P l S L shaped_points find_point find_row.
Let row_at_in := CallerMesh.row_at_in M P l S L shaped_points find_point find_row.
Let entry_at_in := CallerMesh.entry_at_in M P l S L shaped_points find_point find_row.
Let simplex_at_in := CallerMesh.simplex_at_in M P l S L shaped_points find_point find_row.
Let proper_at_in := CallerMesh.proper_at_in M P l S L shaped_points find_point find_row.
Let proper_with_in := CallerMesh.proper_with_in M P l S L shaped_points find_point find_row.
Let point_at_in := CallerMesh.point_at_in M P l S L shaped_points find_point find_row.
Let caller_point := CallerMesh.caller_point M P l S L shaped_points find_point find_row.
Let caller_incl := CallerMesh.caller_incl M P l S L shaped_points find_point find_row.
Let shaped_in := CallerMesh.shaped_in M P l S L shaped_points find_point find_row.

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
      (places X), (places Y).
      split; [|split; [|split; [|assumption]]]; [|rewrite map_length; apply VX|rewrite map_length;
        apply VY].
    unfold caller_rows.
    rewrite E', map_app. cbn [map]. rewrite map_app. cbn [map].
    now rewrite (vertices_rows x X VX), (vertices_rows y Y VY). }
  intros N Hx Hy VX VY [E1 E2]. unfold numbered in Hx, Hy.
  destruct (Nat.lt_trichotomy (pred (Pos.to_nat t)) (pred (Pos.to_nat u))) as [H|[H|H]].
  - apply (G _ _ x y X Y Hx Hy); auto. now split.
  - lia.
  - apply (G _ _ y x Y X Hy Hx); auto. now split.
Qed.

(** Where the carriers differ, the point is in no common face. *)
Lemma meets_beyond X Y a b q w : framed X a -> framed Y b -> overlapping pr X Y q w = true ->
  forall f, incl f (places X) -> incl f (places Y) -> ~ conv f (place_over r q w).
Proof.
  intros FX FY O. unfold overlapping in O. rewrite !andb_true_iff, negb_true_iff in O.
  destruct O as [[[W IX] IY] N]. apply (written M) in W. destruct W as [Hq Hw].
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
Lemma overlap_breach X Y a b q w : framed X a -> framed Y b -> listed caller_rows (places X) ->
  listed caller_rows (places Y) -> overlapping pr X Y q w = true -> overlap caller_rows.
Proof.
  intros FX FY LX LY O. pose proof O as O'. unfold overlapping in O'. rewrite !andb_true_iff in O'.
  destruct O' as [[[W IX] IY] _]. apply (written M) in W. destruct W as [Hq Hw].
  exists (places X), (places Y), (place_over r q w). split; [assumption|]. split; [assumption|].
  split; [now apply (in_simplex_conv M X a FX)|]. split; [now apply (in_simplex_conv M Y b FY)|].
  now apply (meets_beyond X Y a b).
Qed.

Lemma framed_simplex X a : framed X a -> listed caller_rows (places X) ->
  listed_simplex caller_rows (places X).
Proof.
  intros FX LX. split; [assumption|]. rewrite <- (framed_vertices X a FX).
  split; [apply vertices_length|apply vertices_independent].
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

Lemma twice_breach X Y a b q w : framed X a -> framed Y b -> listed caller_rows (places X) ->
  listed caller_rows (places Y) -> twice pr X Y q w = true -> covered_twice caller_rows.
Proof.
  intros FX FY LX LY O. unfold twice in O. rewrite !andb_true_iff, negb_true_iff in O.
  destruct O as [[[W IX] IY] N]. apply (written M) in W. destruct W as [Hq Hw].
  exists (places X), (places Y), (place_over r q w).
  split; [now apply (framed_simplex X a)|]. split; [now apply (framed_simplex Y b)|].
  split; [|split].
  - intros E. apply (same_places_same M) in E; [congruence|exact (framed_shaped X a FX)|].
    exact (framed_shaped Y b FY).
  - now apply (strictly_in_simplex_inside M X a FX).
  - now apply (in_simplex_conv M Y b FY).
Qed.

Lemma all_beyond_each q w x m facets : all_beyond pr S q w m facets = true -> In x m ->
  exists Y i, proper_simplex_of pr S x = Some Y /\ beyond pr Y q w i = true.
Proof.
  revert facets. induction m as [|y m IH]; intros facets B Hx; [destruct Hx|].
  destruct facets as [|i facets]; [discriminate|]. cbn in B. apply andb_true_iff in B.
  destruct B as [By B]. destruct Hx as [->|Hx]; [|now apply (IH facets)].
  destruct (proper_simplex_of pr S x) as [Y|]; [|discriminate]. now exists Y, i.
Qed.
Lemma all_beyond_not_conv p facets : well_shaped d p -> all_beyond pr S p 1 l facets = true ->
  forall s, listed caller_rows s -> ~ conv s (place p).
Proof.
  intros Hp B s Hs. apply in_map_iff in Hs. destruct Hs as (x & E & Hx).
  destruct (all_beyond_each p 1 x l facets B Hx) as (Y & i & EY & By).
  apply proper_simplex_of_frame in EY. destruct EY as (V & b & FY).
  rewrite (vertices_rows x Y V) in E. apply map_some_inj in E. subst s.
  rewrite <- (place_over_one (r := r)). now apply (beyond_not_conv M Y b FY p 1 i).
Qed.
Lemma all_beyond_unused p facets : well_shaped d p -> all_beyond pr S p 1 l facets = true ->
  forall x : list (option (point d)), In x caller_rows -> ~ In (Some (place p)) x.
Proof.
  intros Hp B x Hx I. pose proof Hx as H. apply in_map_iff in H. destruct H as (y & E & Hy).
  destruct (all_beyond_each p 1 y l facets B Hy) as (Y & i & EY & _).
  apply proper_simplex_of_frame in EY. destruct EY as (V & _). subst x.
  rewrite (vertices_rows y Y V) in *. apply (all_beyond_not_conv p facets Hp B (places Y) Hx).
  apply conv_point. apply in_map_iff in I. destruct I as (v & E & Hv). injection E as ->.
  assumption.
Qed.

(** The facets of the boundary. *)
Lemma all_named_listed x (s : simplex d) : map caller_entry x = map Some s ->
  forall p, In p P -> In (place p) s -> lists S p x = true.
Proof.
  intros E p Hp I. unfold lists. apply existsb_exists.
  assert (I' : In (Some (place p)) (map caller_entry x)) by (rewrite E; now apply in_map).
  apply in_map_iff in I'. destruct I' as (n & En & Hn). exists n. split; [assumption|].
  rewrite caller_named in En. destruct (named S n) as [q|] eqn:Eq; [|discriminate].
  injection En as En. apply (same_place_place M); auto; apply shaped_in; auto.
  now apply named_in in Eq.
Qed.
Lemma boundary_breach X a i : framed X a -> incl X P -> listed caller_rows (places X) ->
  on_boundary pr S l X i = true -> (i <= d)%nat /\
  boundary_facet caller_rows (places X) (places (remove i X)).
Proof.
  intros FX IX LX B. unfold on_boundary in B. rewrite andb_true_iff, Nat.ltb_lt in B.
  rewrite (dimension_d M) in B. destruct B as [Hi B]. split; [lia|].
  split; [now apply (framed_simplex X a)|].
  split; [rewrite remove_map; apply remove_NoDup, (framed_NoDup X a FX)|].
  split.
  { rewrite map_length. pose proof (framed_length X a FX) as Len.
    pose proof (remove_length i X ltac:(lia)). lia. }
  split; [apply incl_map, remove_incl|].
  intros t Ht It. apply in_map_iff in Ht. destruct Ht as (x & E & Hx).
  rewrite forallb_forall in B. specialize (B x Hx). unfold no_other in B.
  apply orb_true_iff in B. destruct B as [B|B].
  - exfalso. apply negb_true_iff in B.
    assert (T : forallb (fun p => lists S p x) (remove i X) = true); [|congruence].
    apply forallb_forall. intros p Hp. apply (all_named_listed x t E).
    + apply remove_incl in Hp. now apply IX.
    + apply It. now apply in_map.
  - destruct (simplex_of pr S x) as [Y|] eqn:EY; [|discriminate].
    apply simplex_of_vertices in EY. rewrite (vertices_rows x Y EY) in E.
    apply map_some_inj in E. subst t.
    apply (same_places_same M) in B; auto; [exact (framed_shaped X a FX)|].
    now apply vertices_shaped in EY.
Qed.

Lemma beyond_opposite X a i p : framed X a -> In p P -> beyond pr X p 1 i = true ->
  exists v, In v (places X) /\ nth_error (places X) i = Some v /\
    on_opposite_sides (places (remove i X)) v (place p).
Proof.
  intros FX Hp B. unfold beyond in B. rewrite andb_true_iff, Nat.ltb_lt in B.
  rewrite (dimension_d M) in B. destruct B as [Hi B]. assert (Hi' : (i <= d)%nat) by lia.
  apply (coordinate_negative M X a FX p 1 i Hi' (shaped_in p Hp) eq_refl) in B.
  rewrite place_over_one in B.
  destruct (bary_affine a i Hi') as (n & c & E). exists (vertex a i).
  assert (V : nth_error (places X) i = Some (vertex a i)).
  { pose proof (framed_length X a FX) as Len. destruct (nth_error X i) as [v|] eqn:Ev.
    - destruct (framed_vertex X a FX i v Ev) as [_ ->]. now apply map_nth_error.
    - apply nth_error_None in Ev. lia. }
  split; [now apply nth_error_In in V|]. split; [assumption|]. exists n, c. split; [|split].
  - intros v Hv. rewrite <- E. rewrite remove_map in Hv.
    pose proof (remove_absent i (places X) _ (framed_NoDup X a FX) V) as N.
    pose proof (remove_incl i (places X) v Hv) as Hv'.
    rewrite <- (framed_vertices X a FX) in Hv'. apply in_vertices in Hv'.
    destruct Hv' as (k & Hk & ->). apply bary_other; auto. intros <-. contradiction.
  - rewrite <- E, bary_own by assumption. lra.
  - now rewrite <- E.
Qed.

Lemma convex_breach X a i p : framed X a -> incl X P -> listed caller_rows (places X) -> In p P ->
  on_boundary pr S l X i && beyond pr X p 1 i = true -> hull_not_convex caller_points caller_rows.
Proof.
  intros FX IX LX Hp H. apply andb_true_iff in H. destruct H as [B Be].
  apply (boundary_breach X a i FX IX LX) in B. destruct B as [_ B].
  apply (beyond_opposite X a i p FX Hp) in Be. destruct Be as (v & Hv & _ & O).
  exists (places X), (places (remove i X)), v, (place p).
  split; [assumption|]. split; [assumption|]. split; [now apply caller_point|assumption].
Qed.

Lemma closed_breach X Y Z a b c i j k : framed X a -> framed Y b -> framed Z c -> incl X P ->
  incl Y P -> incl Z P -> listed caller_rows (places X) -> listed caller_rows (places Y) ->
  listed caller_rows (places Z) ->
  on_boundary pr S l X i && on_boundary pr S l Y j && on_boundary pr S l Z k &&
    on_ridge pr (remove i X) (remove j Y) (remove k Z) = true -> hull_not_closed caller_rows.
Proof.
  intros FX FY FZ IX IY IZ LX LY LZ H. rewrite !andb_true_iff in H. destruct H as [[[BX BY] BZ] H].
  apply (boundary_breach X a i FX IX LX) in BX. apply (boundary_breach Y b j FY IY LY) in BY.
  apply (boundary_breach Z c k FZ IZ LZ) in BZ. destruct BX as [_ BX], BY as [_ BY], BZ as [_ BZ].
  assert (SX : Forall (well_shaped d) (remove i X)).
  { eapply incl_Forall; [apply remove_incl|exact (framed_shaped X a FX)]. }
  assert (SY : Forall (well_shaped d) (remove j Y)).
  { eapply incl_Forall; [apply remove_incl|exact (framed_shaped Y b FY)]. }
  assert (SZ : Forall (well_shaped d) (remove k Z)).
  { eapply incl_Forall; [apply remove_incl|exact (framed_shaped Z c FZ)]. }
  unfold on_ridge in H. rewrite !andb_true_iff, !negb_true_iff in H.
  destruct H as [[[N1 N2] N3] R]. rewrite (dimension_d M) in R.
  set (f := remove i X) in *. set (g := remove j Y) in *. set (h' := remove k Z) in *.
  set (q := in_all_three f g h') in *.
  assert (Iq : incl q f) by (unfold q, in_all_three; intros p Hp; now apply filter_In in Hp).
  assert (Sq : Forall (well_shaped d) q) by (eapply incl_Forall; eassumption).
  assert (Two : forall u, Forall (well_shaped d) u ->
    (forall p, In p q -> existsb (same_place p) u = true) -> incl (places q) (places u)).
  { intros u Su K v Hv. apply in_map_iff in Hv. destruct Hv as (p & <- & Hp).
    specialize (K p Hp). apply existsb_exists in K. destruct K as (p' & Hp' & K).
    apply (same_place_place M) in K.
    - rewrite K. now apply in_map.
    - rewrite Forall_forall in Sq. auto.
    - rewrite Forall_forall in Su. auto. }
  assert (Len : Datatypes.S (length q) = d).
  { clear - R. destruct d; [discriminate|]. apply has_length_length in R. now rewrite R. }
  exists (places q), (places X), (places Y), (places Z), (places f), (places g), (places h').
  repeat (split; [assumption|]).
  assert (Differ : forall u v, Forall (well_shaped d) u -> Forall (well_shaped d) v ->
    same_places u v = false ->
    ~ same (places u) (places v)).
  { intros u v Su Sv N E. apply (same_places_same M) in E; congruence. }
  repeat (split; [now apply Differ|]).
  split; [|split; [now rewrite map_length|]].
  - unfold q, in_all_three. destruct BX as (_ & NX & _). fold f in NX. clear - NX.
    induction f as [|p m IH]; cbn in *; [constructor|]. inversion_clear NX.
    destruct (existsb _ _ && existsb _ _); cbn; auto. constructor; auto. intros I. apply H.
    apply in_map_iff in I. destruct I as (p' & E & I). apply filter_In in I.
    rewrite <- E. now apply in_map.
  - split; [|split].
    + now apply incl_map.
    + apply Two; [assumption|]. intros p Hp. apply filter_In in Hp. destruct Hp as [_ Hp].
      now apply andb_true_iff in Hp.
    + apply Two; [assumption|]. intros p Hp. apply filter_In in Hp. destruct Hp as [_ Hp].
      now apply andb_true_iff in Hp.
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
  apply (same_place_place M); [now apply shaped_in| |congruence].
  apply shaped_in. now apply (named_in n q).
Qed.

Variable h : point d -> R.
Hypothesis heights : heights_of r h P.
Lemma heights_among p X : In p P -> incl X P -> heights_of r h (p :: X).
Proof. intros Hp I q [<-|Hq]; apply heights; auto. Qed.

Lemma below_breach X a p : framed X a -> incl X P -> listed caller_rows (places X) -> In p P ->
  (0 <? below_sign pr X p)%Z = true -> point_below_plane h caller_points caller_rows.
Proof.
  intros FX IX LX Hp B. exists (places X), (place p). split; [now apply (framed_simplex X a)|].
  split; [now apply caller_point|]. rewrite <- (framed_vertices X a FX).
  apply below_all_planes.
  apply (below_witness M X a FX); [now apply heights_among|now apply shaped_in|assumption].
Qed.

(** Of [facet_below_plane] the simplices, the facet and the apexes. *)
Lemma not_local_found X Y a b i j : framed X a -> framed Y b -> incl X P -> incl Y P ->
  listed caller_rows (places X) -> listed caller_rows (places Y) -> not_local pr X i Y j = true ->
  let f := places (remove i X) in exists u v,
  listed_simplex caller_rows (places X) /\ listed caller_rows (places Y) /\
  NoDup f /\ length f = d /\ incl f (places X) /\ incl f (places Y) /\
  In u (places X) /\ In v (places Y) /\ on_opposite_sides f u v /\
  forall e o, (forall q, In q (places X) -> plane e o q = h q) -> h v < plane e o v.
Proof.
  intros FX FY IX IY LX LY N. unfold not_local in N. apply andb_true_iff in N.
  destruct N as [SF B]. destruct (nth_error Y j) as [v|] eqn:Ev; [|discriminate].
  apply andb_true_iff in B. destruct B as [Be B].
  apply nth_error_In in Ev. apply (same_facet_shared M X Y a b FX FY) in SF.
  destruct SF as (N & Len & JX & JY & _).
  destruct (beyond_opposite X a i v FX (IY v Ev) Be) as (u & Hu & _ & O).
  exists u, (place v).
  split; [now apply (framed_simplex X a)|].
  repeat (split; [assumption || now apply in_map|]).
  rewrite <- (framed_vertices X a FX). apply below_all_planes.
  apply (below_witness M X a FX); [|apply (shaped_in v), IY; assumption|assumption].
  apply heights_among; [now apply IY|assumption].
Qed.
Lemma not_local_breach X Y a b i j : framed X a -> framed Y b -> incl X P -> incl Y P ->
  listed caller_rows (places X) -> listed caller_rows (places Y) ->
  not_local pr X i Y j = true -> facet_below_plane h caller_rows.
Proof.
  intros FX FY IX IY LX LY N.
  destruct (not_local_found X Y a b i j FX FY IX IY LX LY N) as (u & v & H).
  exists (places X), (places Y), (places (remove i X)), u, v. exact H.
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
  apply (above_witness_plane M X a FX); [|assumption|assumption].
  apply heights_among; [now apply IY|assumption].
Qed.

(** All together.  Where the evidence is a ball the heights are those of the paraboloid. *)
Theorem evidence_breach c e : concerns e c = true -> (c = Delaunay -> h = norm2) ->
  holds pr S L l e = true -> broken c h caller_points caller_rows (rule_of e).
Proof.
  intros Co D H. destruct e; cbn [holds broken rule_of] in *.
  - apply row_at_in in H. destruct H as (x & _ & I & H).
    exists (map caller_entry x). split; [assumption|].
    unfold right_length in H. rewrite (dimension_d M) in H. apply negb_true_iff in H.
    rewrite map_length. intros E. apply has_length_length in E. congruence.
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
  - apply proper_at_in in H. destruct H as (X & a & FX & _ & LX & H).
    apply proper_at_in in H. destruct H as (Y & b & FY & _ & LY & H).
    exact (twice_breach X Y a b q w FX FY LX LY H).
  - apply point_at_in in H. destruct H as (q & Hq & H). apply negb_true_iff in H.
    destruct c; try discriminate; exact (unused_breach q Hq H).
  - apply point_at_in in H. destruct H as (q & Hq & H). destruct c; try discriminate.
    exists (place q). split; [now apply caller_point|]. pose proof (shaped_in q Hq).
    split; [now apply (all_beyond_unused q facets)|now apply (all_beyond_not_conv q facets)].
  - apply proper_at_in in H. destruct H as (X & a & FX & IX & LX & H).
    apply point_at_in in H. destruct H as (q & Hq & H). exact (convex_breach X a i q FX IX LX Hq H).
  - apply proper_at_in in H. destruct H as (X & a & FX & IX & LX & H).
    apply proper_at_in in H. destruct H as (Y & b & FY & IY & LY & H).
    apply proper_at_in in H. destruct H as (Z & g & FZ & IZ & LZ & H).
    exact (closed_breach X Y Z a b g i j k FX FY FZ IX IY IZ LX LY LZ H).
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
