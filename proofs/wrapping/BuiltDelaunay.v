(** * What [wrap] returns is the canonical Delaunay triangulation *)
From Coq Require Import Rbase Rfunctions Lra Psatz Lia List Arith ZArith Bool.
From Circumspect Require Import GiftWrapping Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Faces LiftingMap.
From Circumspect Require Import Orientation Integers RefutationSigns Perturbation EveryPointSet
  WrappingSound Wrapped.
Import ListNotations.
Open Scope R_scope.

(** ** The same simplices, listed otherwise *)

Section Same.
Context {d : nat}.
Implicit Types (S : list (point d)) (T F : list (simplex d)).
Variables (S : list (point d)) (T F : list (simplex d)).
Hypothesis alike : same_simplices T F.

Lemma same_faces s : faces_of T s <-> faces_of F s.
Proof.
  split; intros (N & Ne & t & I & Inc); (split; [assumption|]; split; [assumption|]).
  - destruct (proj1 alike t I) as (u & J & Sm & _). exists u. split; [assumption|].
    now apply incl_tran with t.
  - destruct (proj2 alike t I) as (u & J & Sm & _). exists u. split; [assumption|].
    now apply incl_tran with t.
Qed.
Lemma fills_same : fills S T -> (forall f, In f F -> NoDup f /\ length f = Datatypes.S d) ->
  ForallOrdPairs (fun s t => ~ same s t) F -> fills S F.
Proof.
  intros (L & (I & C & M) & _ & V & U) LF Once. split; [assumption|].
  split; [|split; [assumption|split]].
  - split; [|split].
    + intros s H. apply I. now apply same_faces.
    + intros s f H. rewrite <- same_faces in *. now apply C.
    + intros s t Hs Ht. apply M; now apply same_faces.
  - intros f If. destruct (proj2 alike f If) as (t & It & Sm & _). apply incl_tran with t; auto.
  - intros q. rewrite U. split; intros (t & It & Ct).
    + destruct (proj1 alike t It) as (f & If & Sm). exists f. split; [assumption|].
      now apply (conv_same t).
    + destruct (proj2 alike t It) as (f & If & Sm). exists f. split; [assumption|].
      now apply (conv_same t).
Qed.
Lemma of_same (Q : simplex d -> Prop) : (forall s t, same s t -> Q s -> Q t) ->
  (forall t, In t T -> Q t) -> forall f, In f F -> Q f.
Proof.
  intros E H f If. destruct (proj2 alike f If) as (t & It & A & B). apply (E t); [now split|auto].
Qed.
Lemma canonical_same_simplices h : canonical_triangulation S h T -> fills S F ->
  canonical_triangulation S h F.
Proof.
  intros (_ & e0 & P & K) Fi. split; [assumption|]. exists e0. split; [assumption|].
  intros e k He L.
  apply (of_same (witness_plane k S)); [|now apply (K e)].
  intros s t [_ B] (a & b & On & Be). exists a, b. split; [|assumption]. intros v Hv. apply On.
  auto.
Qed.
Lemma delaunay_same_simplices : delaunay_triangulation S T -> fills S F ->
  delaunay_triangulation S F.
Proof.
  intros [[_ Used] De] Fi. split; [split; [assumption|]|].
  - intros p Ip. destruct (Used p Ip) as (t & It & Pt).
    destruct (proj1 alike t It) as (f & If & A & _). exists f. auto.
  - apply (of_same (delaunay S)); [|assumption]. intros s t [_ B] (o & r2 & Ci & Em). exists o, r2.
    split; [|assumption]. intros v Hv. apply Ci. auto.
Qed.
End Same.

(** ** The points by their numbers *)

Lemma numbered_from_one_in (l : list site) p : In p (numbered_from_one l) <->
  exists s, numbered l (fst p) = Some s /\ snd p = Site (coordinates s) 0.
Proof.
  unfold numbered_from_one, numbered. destruct p as [k s0]. cbn [fst snd].
  assert (G : forall l n k s0,
    In (k, s0) (combine (map Pos.of_succ_nat (seq n (length l)))
    (map (fun s => Site (coordinates s) 0) l)) <->
    exists i s, k = Pos.of_succ_nat (n + i) /\ nth_error l i = Some s /\
      s0 = Site (coordinates s) 0).
  { clear. induction l as [|s l IH]; intros n k s0; cbn [length seq map combine].
    - split; [intros []|]. intros (i & s & _ & E & _). destruct i; discriminate.
    - cbn [In]. rewrite IH. split.
      + intros [E|(i & s' & -> & E & ->)].
        * injection E as <- <-. exists 0%nat, s. now rewrite Nat.add_0_r.
        * exists (S i), s'. now rewrite Nat.add_succ_r.
      + intros (i & s' & -> & E & ->). destruct i as [|i]; cbn in E.
        * injection E as ->. left. now rewrite Nat.add_0_r.
        * right. exists i, s'. now rewrite Nat.add_succ_r. }
  rewrite G. split.
  - intros (i & s & -> & E & ->). exists s. rewrite Nat.add_0_l, SuccNat2Pos.id_succ. auto.
  - intros (s & E & ->). exists (pred (Pos.to_nat k)), s. split; [|auto]. rewrite Nat.add_0_l. lia.
Qed.
Lemma combine_fst {A B} (l : list A) (m : list B) : length l = length m ->
  map fst (combine l m) = l.
Proof.
  revert m. induction l as [|a l IH]; intros [|b m] E; try discriminate; cbn; [reflexivity|].
  f_equal. apply IH. now injection E.
Qed.
Lemma combine_snd {A B} (l : list A) (m : list B) : length l = length m ->
  map snd (combine l m) = m.
Proof.
  revert m. induction l as [|a l IH]; intros [|b m] E; try discriminate; cbn; [reflexivity|].
  f_equal. apply IH. now injection E.
Qed.
Lemma numbered_once (l : list site) : NoDup (map fst (numbered_from_one l)).
Proof.
  unfold numbered_from_one. rewrite combine_fst by (now rewrite !map_length, seq_length).
  apply (numbers_NoDup l).
Qed.
Lemma numbered_places {d} (r : R) (l : list site) :
  map (fun p : spotted => @place_of d r (snd p)) (numbered_from_one l) = caller_points r l.
Proof.
  rewrite <- (map_map snd (@place_of d r)). unfold numbered_from_one.
  rewrite combine_snd by (now rewrite !map_length, seq_length). rewrite map_map. reflexivity.
Qed.

Lemma in_inserted o p l : forall q, In q (inserted o p l) <-> q = p \/ In q l.
Proof.
  induction l as [|a l IH]; intros q; cbn [inserted]; [cbn; intuition congruence|].
  destruct (_ <=? _)%Z; cbn [In]; [intuition congruence|]. rewrite IH. intuition congruence.
Qed.
Lemma in_by_distance o l q : In q (by_distance o l) <-> In q l.
Proof.
  induction l as [|a l IH]; [reflexivity|]. cbn [by_distance fold_right]. rewrite in_inserted.
  cbn [In]. unfold by_distance in IH. rewrite IH. intuition congruence.
Qed.

(** ** The theorem *)

Section Built.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates} {r : R}.
Hypothesis M : measured orient pr r.
Hypothesis d_positive : (1 <= d)%nat.
Variable l : list site.
Notation Points := (@caller_points d r l).
Hypothesis shaped_points : Forall (well_shaped d) l.
Hypothesis points_differ : NoDup Points.
Hypothesis points_span : spans Points.

Theorem wrapped_canonical Q : (forall q, In q Q <-> In q (numbered_from_one l)) -> exists L U,
  wrapped pr (numbered_from_one l) Q = Some L /\
    @caller_rows d r l (map (map Some) L) = map (map Some) U /\
  delaunay_triangulation Points U /\ canonical_triangulation Points norm2 U.
Proof.
  intros HQ. set (P := numbered_from_one l) in *.
  pose proof (numbered_places (d := d) r l) as Places. fold P in Places.
  destruct (every_point_set Points points_differ points_span) as (T & De & Ca & _).
  assert (Sy : symbolic_triangulation Points norm2 T) by (now apply symbolic_canonical).
  pose proof (proj1 Sy) as Fi.
  assert (Sh : Forall (fun p : spotted => well_shaped d (snd p)) P).
  { apply Forall_forall. intros p Ip. apply numbered_from_one_in in Ip. destruct Ip as (s & E & F).
    rewrite F.
    unfold well_shaped. cbn. rewrite Forall_forall in shaped_points. apply shaped_points.
    now apply numbered_in with (fst p). }
  assert (H : forall p, In p P -> norm2 (@place_of d r (snd p)) = @height_of d r (snd p)).
  { intros p Ip. apply numbered_from_one_in in Ip. destruct Ip as (s & _ & F). unfold height_of.
    rewrite F. cbn [weight]. ring. }
  pose proof points_differ as Nd. rewrite <- Places in Sy, Nd.
  assert (NE : T <> []).
  { destruct points_span as (X & I & L & _). destruct X as [|p X]; [discriminate|].
    assert (C : conv Points p) by (apply conv_point, I; now left).
    pose proof Fi as (_ & _ & _ & _ & U). apply U in C.
    destruct C as (t & It & _). now intros ->. }
  destruct (wrapped_all M P Sh (numbered_once l) Nd norm2 H d_positive T Sy Q)
    as (found & E & Each & Once & Same).
  { intros q I. now apply HQ. } { intros q I. now apply HQ. } { assumption. }
  exists (map (map fst) found),
    (map (fun X => map (fun p : spotted => @place_of d r (snd p)) X) found).
  split; [exact E|]. split.
  - unfold caller_rows. rewrite !map_map. apply map_ext_in. intros X IX. rewrite !map_map.
    apply map_ext_in. intros p Ip.
    destruct (Each X IX) as (I & _). specialize (I p Ip). apply numbered_from_one_in in I.
    destruct I as (s & F & G).
    cbn [caller_entry]. rewrite F. cbn [option_map]. f_equal. rewrite G. reflexivity.
  - set (U := map (fun X => map (fun p : spotted => @place_of d r (snd p)) X) found) in *.
    assert (FU : fills Points U).
    { apply (fills_same Points T U Same Fi); [|assumption]. intros f If. apply in_map_iff in If.
      destruct If as (X & <- & IX).
      destruct (Each X IX) as (_ & t & s & F & _). rewrite <- (framed_places X t F).
      split; [apply vertices_NoDup|apply vertices_length]. }
    split; [now apply (delaunay_same_simplices Points T U Same)|now apply
      (canonical_same_simplices Points T U Same)].
Qed.
End Built.

(** A simplex was found only if the points span. *)
Section Found.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates} {r : R}.
Hypothesis M : measured orient pr r.
Variable l : list site.
Hypothesis shaped_points : forallb (shaped pr) l = true.

Lemma shaped_sites : Forall (well_shaped d) l.
Proof.
  apply Forall_forall. intros s I. rewrite forallb_forall in shaped_points.
  specialize (shaped_points s I).
  unfold shaped in shaped_points. apply Nat.eqb_eq in shaped_points.
  rewrite (dimension_d M) in shaped_points. exact shaped_points.
Qed.
Lemma all_differ_spec : all_differ l = true <-> NoDup (@caller_points d r l).
Proof.
  pose proof shaped_sites as Sh. unfold caller_points. clear shaped_points.
  induction l as [|s m IH]; cbn [all_differ map]; [split; [constructor|reflexivity]|].
  apply Forall_cons_iff in Sh. destruct Sh as [Ss Sh].
  rewrite andb_true_iff, (IH Sh), negb_true_iff.
  assert (E : existsb (same_place s) m = true <-> In (@place_of d r s) (map (place_of r) m)).
  { rewrite existsb_exists, in_map_iff. rewrite Forall_forall in Sh.
    split; intros (q & A & B); exists q.
    - split; [symmetry; now apply (same_place_place M s q Ss (Sh q A))|assumption].
    - split; [assumption|]. now apply (same_place_place M s q Ss (Sh q B)). }
  split.
  - intros [A B]. constructor; [|assumption]. intros I. apply E in I. congruence.
  - intros N. inversion N as [|? ? Ni N']; subst. split; [|assumption].
    destruct (existsb (same_place s) m); [|reflexivity]. exfalso. apply Ni. now apply E.
Qed.
Lemma wrapped_spans Q L : (forall q, In q Q -> In q (numbered_from_one l)) ->
  wrapped pr (numbered_from_one l) Q = Some L -> spans (@caller_points d r l).
Proof.
  intros IQ E. unfold wrapped in E. destruct (search _ _ _ _ _) as [X|] eqn:Se; [|discriminate].
  destruct (search_some (pr := pr) _ (Datatypes.S (dimension pr)) Q IQ [] X ltac:(intros x []) Se)
    as [I A].
  unfold passes in A. rewrite !andb_true_iff in A. destruct A as [[Len Pr] _].
  unfold right_length in Len. apply has_length_length in Len. rewrite (dimension_d M) in Len.
  assert (Sh : Forall (well_shaped d) (map snd X)).
  { apply Forall_forall. intros s J. apply in_map_iff in J. destruct J as (p & <- & J).
    apply I in J.
    apply numbered_from_one_in in J. destruct J as (s & F & G). rewrite G. unfold well_shaped. cbn.
    pose proof shaped_sites as W. rewrite Forall_forall in W. apply W.
    now apply numbered_in with (fst p). }
  destruct (proper_framed M (map snd X) Sh) as (t & F); [now rewrite map_length|assumption|].
  exists (vertices t). split; [|split; [apply vertices_length|apply vertices_independent]].
  rewrite (framed_places X t F). intros q J. apply in_map_iff in J. destruct J as (p & <- & J).
  apply I in J.
  rewrite <- (numbered_places r l). now apply (in_map (fun p : spotted => @place_of d r (snd p))).
Qed.
End Found.

(** What is returned, if anything is; [r] is whatever unit the integers have. *)
Theorem wrap_sound D (r : R) (l : list site) L : 0 < r -> wrap D l = Some L -> let d :=
  dimension_of D in
  NoDup (@caller_points d r l) /\ spans (@caller_points d r l) /\
  exists U, @caller_rows d r l (map (map Some) L) = map (map Some) U /\
    delaunay_triangulation (@caller_points d r l) U /\
      canonical_triangulation (@caller_points d r l) norm2 U.
Proof.
  intros Pr E. assert (G : forall d orient pr, (1 <= d)%nat -> @measured d orient pr r -> forall o,
    forallb (shaped pr) l = true -> all_differ l = true ->
    wrapped pr (numbered_from_one l) (by_distance o (numbered_from_one l)) = Some L ->
    NoDup (@caller_points d r l) /\ spans (@caller_points d r l) /\
    exists U, @caller_rows d r l (map (map Some) L) = map (map Some) U /\
      delaunay_triangulation (@caller_points d r l) U /\
        canonical_triangulation (@caller_points d r l) norm2 U).
  { clear. intros d orient pr Pd M o Sh Df E. pose proof (proj1 (all_differ_spec M l Sh) Df) as Nd.
    assert (Sp : spans (@caller_points d r l)).
    { apply (wrapped_spans M l Sh _ L) in E; [assumption|]. intros q. apply in_by_distance. }
    split; [assumption|]. split; [assumption|].
    destruct (wrapped_canonical M Pd l (shaped_sites M l Sh) Nd Sp
      (by_distance o (numbered_from_one l)))
      as (L' & U & E' & H); [intros q; apply in_by_distance|]. exists U. congruence. }
  cbv zeta. unfold wrap in E. cbv zeta in E. destruct l as [|o l'] eqn:El; [discriminate|].
  rewrite <- El in *.
  destruct (forallb _ _ && all_differ l) eqn:B; [|discriminate]. apply andb_prop in B.
  destruct B as [Sh Df].
  destruct D; cbn [dimension_of predicates_of] in *.
  - apply (G 2%nat _ _ ltac:(lia) (measured_plane r Pr) o Sh Df E).
  - apply (G 3%nat _ _ ltac:(lia) (measured_space r Pr) o Sh Df E).
Qed.
(** It is, if the points are different and span the plane or space. *)
Theorem wrap_complete D (r : R) (l : list site) : 0 < r -> let d := dimension_of D in
  Forall (fun s => length (coordinates s) = d) l -> NoDup (@caller_points d r l) ->
    spans (@caller_points d r l) ->
  exists L, wrap D l = Some L.
Proof.
  intros Pr d Sh Nd Sp. unfold wrap. cbv zeta. destruct l as [|o l'] eqn:El.
  { exfalso. destruct Sp as (X & I & L & _). destruct X as [|p X]; [discriminate|].
    exact (I p (or_introl eq_refl)). }
  rewrite <- El in *. subst d.
  assert (G : forall d orient pr, (1 <= d)%nat -> @measured d orient pr r ->
    Forall (fun s => length (coordinates s) = d) l -> NoDup (@caller_points d r l) ->
      spans (@caller_points d r l) ->
    exists L, (if forallb (shaped pr) l && all_differ l
               then wrapped pr (numbered_from_one l) (by_distance o (numbered_from_one l)) else
                 None) = Some L).
  { clear. intros d orient pr Pd M Sh Nd Sp. assert (S' : forallb (shaped pr) l = true).
    { apply forallb_forall. intros s I. unfold shaped. apply Nat.eqb_eq. rewrite (dimension_d M).
      rewrite Forall_forall in Sh. now apply Sh. }
    rewrite S', (proj2 (all_differ_spec M l S') Nd). cbn [andb].
    destruct (wrapped_canonical M Pd l Sh Nd Sp (by_distance o (numbered_from_one l)))
      as (L & U & E & _);
      [intros q; apply in_by_distance|]. eauto. }
  destruct D; cbn [dimension_of predicates_of] in *.
  - apply (G 2%nat _ _ ltac:(lia) (measured_plane r Pr) Sh Nd Sp).
  - apply (G 3%nat _ _ ltac:(lia) (measured_space r Pr) Sh Nd Sp).
Qed.
