(** * An accepted refutation of a mesh alone: its simplices form no complex *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Bool.
From Circumspect Require Import AloneRefutation Numbering.
From Circumspect Require Import Vectors Affine Frame Faces Independence Separated Breach.
From Circumspect Require Import Definitions Complexes Orientation Integers RefutationSigns
  CallerMesh RefutationSound.
Import ListNotations.
Open Scope R_scope.

(** ** A broken rule refutes the claim *)

Section Broken.
Context {d : nat}.
Implicit Types (S : list (point d)) (L : list (list (option (point d)))) (T : list (simplex d))
  (s t f : simplex d).

Lemma listed_in T s : listed (map (map Some) T) s -> In s T.
Proof.
  intros I. unfold listed in I. apply in_map_iff in I. destruct I as (t & E & It).
  assert (t = s) as <-; [|assumption]. clear It. revert s E.
  induction t as [|p t IH]; intros [|q s] E; try discriminate; auto.
  cbn in E. injection E as -> E. f_equal. auto.
Qed.
Lemma meeting S T s t q : simplices_form_a_complex S T -> In s T -> In t T -> conv s q ->
  conv t q ->
  exists f, incl f s /\ incl f t /\ conv f q.
Proof.
  intros H Is It Cs Ct.
  destruct (ForallOrdPairs_In (meeting_in_faces S T H) s t Is It) as [->|[M|M]].
  - exists t. split; [apply incl_refl|]. split; [apply incl_refl|assumption].
  - now apply M.
  - destruct (M q Ct Cs) as (f & A & B & C). eauto.
Qed.

Theorem broken_no_complex S L r : broken_of_complex S L r ->
  match r with
  | OfPoints r => In r [triangulation_unknown_vertex; simplex_repeated_vertex; simplex_degenerate;
      complex_duplicate_simplex;
      complex_overlap; triangulation_unused_point]
  | _ => True
  end -> ~ claims_complex S L.
Proof.
  intros B K (T & -> & H). pose proof (independent_vertices S T H) as Ind.
  destruct r as [r| | |]; cbn [broken_of_complex] in B.
  - destruct K as [<-|[<-|[<-|[<-|[<-|[<-|[]]]]]]]; cbn [broken] in B.
    + destruct B as (r & I & N). apply in_map_iff in I. destruct I as (t & <- & _).
      apply in_map_iff in N.
      destruct N as (p & E & _). discriminate.
    + destruct B as (r & i & j & p & I & N & A & A'). apply in_map_iff in I.
      destruct I as (t & <- & It).
      rewrite nth_error_map in A, A'. destruct (Ind t It) as [_ In_].
      destruct (nth_error t i) as [x|] eqn:Ei; [|discriminate].
      destruct (nth_error t j) as [y|] eqn:Ej; [|discriminate].
      cbn in A, A'. injection A as ->. injection A' as ->. apply N.
      apply (proj1 (NoDup_nth_error t) (independent_NoDup t In_));
        [apply nth_error_Some; congruence|congruence].
    + destruct B as (s & I & N). apply N. apply Ind. now apply listed_in.
    + destruct B as (L1 & L2 & L3 & s & t & E & _ & _ & Sm). pose proof (none_twice S T H) as O.
      clear - E Sm O.
      revert T E O. induction L1 as [|x L1 IH]; intros [|y T] E O; try discriminate; cbn in E.
      * injection E as E1 E. inversion O as [|? ? F O']; subst. rewrite Forall_forall in F.
        assert (Iy : In (map Some t) (map (map Some) T)) by (rewrite E; apply in_or_app; right;
          now left).
        assert (y = s) as -> by (apply (f_equal (fun z => [z])) in E1; symmetry in E1;
          assert (listed (map (map Some) [y]) s) by (unfold listed; cbn; left; injection E1;
            congruence);
          apply listed_in in H; destruct H as [->|[]]; reflexivity).
        apply (F t); [now apply listed_in|assumption].
      * injection E as _ E. inversion O; subst. eauto.
    + destruct B as (s & t & q & Ls & Lt & Cs & Ct & N). apply listed_in in Ls, Lt.
      destruct (meeting S T s t q H Ls Lt Cs Ct) as (f & A & B & C). now apply (N f).
    + destruct B as (p & I & N). destruct (points_used S T H p I) as (t & It & Ip).
      apply (N (map Some t)); [now apply in_map|].
      now apply in_map.
  - destruct B as (s & t & f & v & (Ls & _ & _) & (Lt & _ & Indt) & Lv & Iv & Nv & If & _ & St).
    apply listed_in in Ls, Lt.
    destruct v as [|p [|? ?]]; try discriminate. assert (Ip : In p [p]) by now left.
    destruct (St p Ip) as [C _].
    destruct (meeting S T s t p H Ls Lt (conv_incl f s p If C) (conv_point t p (Iv p Ip)))
      as (g & Gs & Gt & Cg).
    pose proof (independent_meet t g [p] p Indt Gt Iv Cg (conv_point [p] p Ip)) as C'.
    destruct (meet g [p]) as [|x m] eqn:E; [now apply conv_empty in C'|].
    assert (Ix : In x (meet g [p])) by (rewrite E; now left). apply in_meet in Ix.
    destruct Ix as [Ix [<-|[]]].
    apply (Nv p Ip). now apply Gs.
  - destruct B as (s & t & f & g & q & (Ls & _ & Inds) & (Lt & _ & Indt) & If & Ig & Dis & _ & _ &
      [Cf Mf] & [Cg Mg]).
    apply listed_in in Ls, Lt.
    destruct (meeting S T s t q H Ls Lt (conv_incl f s q If Cf) (conv_incl g t q Ig Cg))
      as (e & Es & Et & Ce).
    pose proof (independent_meet t g e q Indt Ig Et Cg Ce) as C1.
    assert (G1 : incl g e).
    { intros x Ix. apply (Mg (meet g e)) in Ix; [now apply in_meet in Ix| |assumption]. intros y Iy.
      now apply in_meet in Iy. }
    pose proof (independent_meet s f g q Inds If (incl_tran G1 Es) Cf Cg) as C2.
    destruct (meet f g) as [|x m] eqn:E; [now apply conv_empty in C2|].
    assert (Ix : In x (meet f g)) by (rewrite E; now left). apply in_meet in Ix. now apply (Dis x).
  - apply B. exact (points_once S T H).
Qed.
End Broken.

(** ** What the evidence shows *)

Section Shown.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis M : forall r, 0 < r -> measured orient pr r.
Variable x : complex_refutation.
Notation m := (mesh_alone x).
Notation r := (refuted_unit m).
Hypothesis accepted : refute_alone_in pr x = true.
Notation places := (map (@place_of d r)).

Lemma carrier_strictly (t : frame d) q : inside_closed t q -> strictly_inside (Faces.carrier t q) q.
Proof.
  intros I. split; [now apply conv_carrier|]. intros f If C v Iv. apply in_carrier in Iv.
  destruct Iv as (i & Hi & Pi & ->).
  apply (conv_face t f q) in C; [now apply C|].
  apply incl_tran with (Faces.carrier t q); [assumption|apply carrier_incl].
Qed.
Lemma strictly_same (f g : simplex d) q : same f g -> strictly_inside f q -> strictly_inside g q.
Proof.
  intros [A B] [C Mi]. split; [now apply (conv_incl f)|]. intros e Ie Ce.
  apply incl_tran with f; [assumption|].
  apply Mi; [now apply incl_tran with g|assumption].
Qed.

Section Pair.
Hypothesis unit_positive : 0 < r.
Hypothesis shaped_sites : Forall (well_shaped d) (sites m).
Let find_site := find_id (sites m).
Let find_row := find_id (rows m).

(** The two simplices, with the carriers of the point. *)
Lemma both_shown t u q w f : in_both pr (Table.of_list id (sites m)) (Table.of_list id (rows m)) t u
  q w f = true ->
  exists X Y, f X Y = true /\ Forall (well_shaped d) X /\ Forall (well_shaped d) Y /\
    listed_simplex (@caller_rows d r (sites m) (rows m)) (places X) /\
      listed_simplex (@caller_rows d r (sites m) (rows m)) (places Y) /\
    incl (carrier_of pr X q w) X /\ incl (carrier_of pr Y q w) Y /\
    strictly_inside (places (carrier_of pr X q w)) (@place_over d r q w) /\
    strictly_inside (places (carrier_of pr Y q w)) (@place_over d r q w).
Proof.
  intros H. unfold in_both in H.
  apply (proper_at_in (M r unit_positive) (sites m) (rows m) _ _ shaped_sites find_site find_row) in
    H.
  destruct H as (X & a & Fa & IX & LX & H).
  apply (proper_at_in (M r unit_positive) (sites m) (rows m) _ _ shaped_sites find_site find_row) in
    H.
  destruct H as (Y & b & Fb & IY & LY & H). rewrite !andb_true_iff in H.
  destruct H as [[[W Ia] Ib] Hf].
  unfold point_written in W. apply andb_prop in W. destruct W as [Sq Pw]. unfold shaped in Sq.
  apply Nat.eqb_eq in Sq.
  rewrite (dimension_d (M r unit_positive)) in Sq. apply Z.ltb_lt in Pw.
  assert (In_ : forall X a, framed orient pr r X a -> in_simplex pr X q w = true ->
    inside_closed a (place_over r q w)).
  { intros Z z Fz Iz i Hi. unfold in_simplex in Iz. rewrite forallb_forall in Iz.
    apply (coordinate_nonnegative (M r unit_positive) Z z Fz q w i Hi Sq Pw). apply Iz.
    unfold corners_numbered.
    rewrite (dimension_d (M r unit_positive)). now apply in_seq_d. }
  assert (Li : forall Z z, framed orient pr r Z z ->
    listed (@caller_rows d r (sites m) (rows m)) (places Z) ->
    listed_simplex (@caller_rows d r (sites m) (rows m)) (places Z)).
  { intros Z z Fz Lz. split; [assumption|]. rewrite <- (framed_vertices _ _ Fz).
    split; [apply vertices_length|apply vertices_independent]. }
  assert (St : forall Z z, framed orient pr r Z z -> in_simplex pr Z q w = true ->
    strictly_inside (places (carrier_of pr Z q w)) (place_over r q w)).
  { intros Z z Fz Iz. apply (strictly_same (Faces.carrier z (place_over r q w))).
    - destruct (carrier_of_carrier (M r unit_positive) Z z Fz q w Sq Pw). now split.
    - apply carrier_strictly. now apply (In_ Z). }
  exists X, Y. repeat split; try (now eapply framed_shaped; eassumption);
    try (now eapply Li; eassumption);
    try apply carrier_of_incl; try (now eapply Li; eassumption); try assumption;
      try (now eapply St; eassumption).
Qed.
Lemma none_among_spec (X Y : list site) : Forall (well_shaped d) X -> Forall (well_shaped d) Y ->
  none_among X Y = true ->
  forall p, In p (places X) -> ~ In p (places Y).
Proof.
  intros HX HY N p I J. unfold none_among in N. rewrite forallb_forall in N.
  rewrite Forall_forall in HX, HY.
  apply in_map_iff in I, J. destruct I as (a & <- & Ia), J as (b & E & Ib). specialize (N a Ia).
  apply negb_true_iff in N. enough (existsb (same_place a) Y = true) by congruence.
  apply existsb_exists. exists b.
  split; [assumption|]. apply (same_place_place (M r unit_positive)); auto.
Qed.
Lemma several_length (X : list site) : several X = true -> (2 <= length (places X))%nat.
Proof. rewrite map_length. destruct X as [|a [|b X]]; cbn; try discriminate. lia. Qed.
End Pair.

Theorem refute_alone_broken : broken_of_complex (@caller_points d r (sites m))
  (@caller_rows d r (sites m) (rows m)) (complex_rule_of x) /\
  match complex_rule_of x with
  | OfPoints r => In r [triangulation_unknown_vertex; simplex_repeated_vertex; simplex_degenerate;
      complex_duplicate_simplex;
      complex_overlap; triangulation_unused_point]
  | _ => True
  end.
Proof.
  pose proof accepted as A. unfold refute_alone_in in A. cbv zeta in A. unfold complex_rule_of.
  destruct (against x) as [|t u q w|t u q w|p q].
  - destruct (refuted m) eqn:E; try discriminate. apply andb_prop in A. destruct A as [C A]. split.
    + pose proof (accepted_breach M m A (fun _ => 0)) as B. rewrite E in B. apply B. discriminate.
    + destruct (because m); try discriminate; cbn; tauto.
  - apply andb_prop in A. destruct A as [A Sh]. rewrite !andb_true_iff in A.
    destruct A as [[Pn Pd] Ss].
    apply Z.ltb_lt, IZR_lt in Pn, Pd.
    assert (Pr : 0 < r) by (unfold refuted_unit; now apply Rdiv_lt_0_compat).
    assert (Ws : Forall (well_shaped d) (sites m)).
    { apply Forall_forall. intros s I. rewrite forallb_forall in Ss. specialize (Ss s I).
      unfold shaped in Ss.
      apply Nat.eqb_eq in Ss. rewrite (dimension_d (M r Pr)) in Ss. exact Ss. }
    split; [|exact I]. cbn [broken_of_complex shown_against] in *.
    destruct (both_shown Pr Ws _ _ _ _ _ Sh) as (X & Y & F & HX & HY & LX & LY & CX & CY & SX & SY).
    rewrite !andb_true_iff in F. destruct F as [[Se Si] No].
    exists (places X), (places Y), (places (carrier_of pr X q w)), (places (carrier_of pr Y q w)).
    split; [assumption|]. split; [assumption|].
    destruct (carrier_of pr Y q w) as [|v [|? ?]] eqn:EY; try discriminate. cbn [map length].
    split; [reflexivity|].
    split; [exact (incl_map (@place_of d r) CY)|].
    split; [apply (none_among_spec Pr [v] X); [exact (incl_Forall CY HY)|assumption|assumption]|].
    split; [now apply incl_map|]. split; [now apply several_length|].
    intros p [<-|[]]. assert (E : @place_over d r q w = place_of r v).
    { destruct SY as [C _]. cbn [map] in C. apply affine_separate. intros g Ag.
      assert (G : forall c, 0 <= c * g (place_over r q w) + - (c * g (place_of r v)) * 1).
      { intros c.
        apply (affine_conv (fun p => c * g p + - (c * g (place_of r v)) * 1) [place_of r v]);
          [| |exact C].
        - apply (affine_combine g (fun _ => 1)); [assumption|apply affine_const].
        - intros p [<-|[]]. lra. }
      pose proof (G 1). pose proof (G (-1)). lra. }
    now rewrite <- E.
  - apply andb_prop in A. destruct A as [A Sh]. rewrite !andb_true_iff in A.
    destruct A as [[Pn Pd] Ss].
    apply Z.ltb_lt, IZR_lt in Pn, Pd.
    assert (Pr : 0 < r) by (unfold refuted_unit; now apply Rdiv_lt_0_compat).
    assert (Ws : Forall (well_shaped d) (sites m)).
    { apply Forall_forall. intros s I. rewrite forallb_forall in Ss. specialize (Ss s I).
      unfold shaped in Ss.
      apply Nat.eqb_eq in Ss. rewrite (dimension_d (M r Pr)) in Ss. exact Ss. }
    split; [|exact I]. cbn [broken_of_complex shown_against] in *.
    destruct (both_shown Pr Ws _ _ _ _ _ Sh) as (X & Y & F & HX & HY & LX & LY & CX & CY & SX & SY).
    rewrite !andb_true_iff in F. destruct F as [[Se Sf] No].
    exists (places X), (places Y), (places (carrier_of pr X q w)), (places (carrier_of pr Y q w)),
      (@place_over d r q w).
    split; [assumption|]. split; [assumption|]. split; [now apply incl_map|].
    split; [now apply incl_map|].
    split; [|split; [now apply several_length|split; [now apply several_length|now split]]].
    apply (none_among_spec Pr); [eapply incl_Forall; eassumption|eapply incl_Forall;
      eassumption|assumption].
  - apply andb_prop in A. destruct A as [A Sh]. rewrite !andb_true_iff in A.
    destruct A as [[Pn Pd] Ss].
    split; [|exact I]. cbn [broken_of_complex shown_against] in *. apply andb_prop in Sh.
    destruct Sh as [N Sh].
    apply negb_true_iff, Pos.eqb_neq in N. unfold point_at in Sh. rewrite !table_find in Sh.
    destruct (numbered (sites m) p) as [a|] eqn:Ea; [|discriminate]. cbn in Sh.
    destruct (numbered (sites m) q) as [b|] eqn:Eb; [|discriminate]. cbn in Sh.
    unfold same_place in Sh. apply (same_numbers_eq (coordinates a)) in Sh. unfold id in Sh.
    intros Nd. unfold caller_points in Nd. unfold numbered in Ea, Eb.
    assert (E : place_of r a = place_of (d := d) r b) by (unfold place_of; now rewrite Sh).
    assert (pred (Pos.to_nat p) = pred (Pos.to_nat q)); [|lia].
    apply (proj1 (NoDup_nth_error _) Nd).
    + rewrite map_length. apply nth_error_Some. congruence.
    + rewrite (map_nth_error _ _ _ Ea), (map_nth_error _ _ _ Eb). now f_equal.
Qed.
End Shown.

(** Whatever is accepted: the claim is false, because the rule is broken. *)
Theorem refute_alone_rule D x : refute_alone D x = true ->
  broken_of_complex (refuted_points D (mesh_alone x)) (refuted_simplices D (mesh_alone x))
    (complex_rule_of x) /\
  ~ claims_complex (refuted_points D (mesh_alone x)) (refuted_simplices D (mesh_alone x)).
Proof.
  intros A.
  assert (B : broken_of_complex (refuted_points D (mesh_alone x))
    (refuted_simplices D (mesh_alone x)) (complex_rule_of x) /\
    match complex_rule_of x with
    | OfPoints r => In r [triangulation_unknown_vertex; simplex_repeated_vertex; simplex_degenerate;
        complex_duplicate_simplex;
        complex_overlap; triangulation_unused_point]
    | _ => True
    end).
  { destruct D;
      [exact (refute_alone_broken measured_plane x A)|exact
      (refute_alone_broken measured_space x A)]. }
  destruct B as [B K]. split; [assumption|]. now apply (broken_no_complex _ _ _ B).
Qed.
