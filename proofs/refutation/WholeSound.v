(** * What the acceptance of a refutation means that speaks of the whole domain

    The domain is that of its vertices ([WholeRefuted.v]), or comes with another mesh of it. *)
From Coq Require Import Rbase Rfunctions Lra Psatz Lia List Arith ZArith Bool.
From Circumspect Require Import WholeRefutation Numbering.
From Circumspect Require Import Vectors Affine Frame Faces LiftingMap Breach.
From Circumspect Require Import Orientation Integers Accepted RefutationSigns CallerMesh
  EvidenceSound RefutationSound KeptMesh KeptCells.
From Circumspect Require Import Combinations Lists Necessary ConstrainedLemma DomainBroken Dangling
  DomainRefuted PolygonPoints GivenSound DomainSound WholeRefuted.
From Circumspect Require Import Definitions Domains DomainRules Solid.
Import ListNotations.
Open Scope R_scope.

(** ** Another mesh *)

Section Elsewhere.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis measured_all : forall r, 0 < r -> measured orient pr r.
Variable x : whole_refutation.
Notation m := (mesh_against x).
Notation dangles := (dangling_against x).
Notation D := (about_domain x).
Notation c := (whole_mesh D).

Lemma found_places l : forall X, find_all (Table.of_list bare (points c)) l = Some X ->
  map (spot d c) l = map (place_of (unit_of c)) X /\ length l = length X.
Proof.
  induction l as [|k l IH]; intros X E; cbn [find_all] in E; [injection E as <-; now split|].
  rewrite table_find in E. destruct (numbered (points c) k) as [e|] eqn:Ek; [|discriminate].
  cbn [option_map] in E.
  destruct (find_all _ l) as [Y|]; [|discriminate]. injection E as <-.
  destruct (IH Y eq_refl) as [El Ll].
  cbn [map length]. split; [|now rewrite Ll]. rewrite El. f_equal.
  now rewrite (spot_numbered d c k e Ek).
Qed.
Lemma in_kept_simplex_covered t q w : 0 < unit_of c -> well_shaped d q -> (0 < w)%Z ->
  in_kept_simplex pr D t q w = true ->
  exists s, In s (mesh_of_domain d D) /\ conv s (place_over (unit_of c) q w).
Proof.
  intros U Sq Pw H. pose proof (measured_all _ U) as M. unfold in_kept_simplex in H.
  rewrite !find_id in H.
  destruct (numbered (simplices c) t) as [e|] eqn:Ee; [|discriminate].
  destruct (numbered (marks (domain_part D)) t) as [k|] eqn:Ek; [|discriminate].
  rewrite !andb_true_iff in H. destruct H as [[K Ln] H].
  destruct (find_all _ (corners e)) as [X|] eqn:F; [|discriminate].
  rewrite !andb_true_iff in H. destruct H as [[Sh Pr] I]. destruct (found_places _ X F) as [E El].
  unfold right_length in Ln. apply has_length_length in Ln. rewrite (dimension_d M) in Ln.
  assert (SX : Forall (well_shaped d) X).
  { apply Forall_forall. intros p Ip. rewrite forallb_forall in Sh. specialize (Sh p Ip).
    apply Nat.eqb_eq in Sh.
    rewrite (dimension_d M) in Sh. exact Sh. }
  destruct (proper_framed M X SX) as (g & G); [congruence|assumption|].
  exists (map (spot d c) (corners e)). split.
  - unfold mesh_of_domain, part_simplices. apply in_flat_map. exists (e, k).
    split; [|cbn [fst snd]; rewrite K; now left].
    unfold numbered in *. apply nth_error_In with (pred (Pos.to_nat t)).
    now apply nth_error_combine.
  - rewrite E. now apply (in_simplex_conv M X g G q w Sq Pw).
Qed.
(** The same place in the unit of the caller. *)
Lemma other_unit (k l w : Z) (r s : R) q : well_shaped d q -> (0 < w)%Z -> (0 < k)%Z -> (0 < l)%Z ->
  0 < r ->
  r * IZR k = s * IZR l -> place_over (d := d) r (times k q) (w * l) = place_over s q w.
Proof.
  intros Sq Pw Pk Pl Pr E. unfold place_over.
  destruct (times_place d (s / IZR w) k q Pk Sq) as [_ T]. rewrite <- T. f_equal.
  apply IZR_lt in Pw, Pk, Pl. rewrite mult_IZR. apply (Rmult_eq_reg_r (IZR w * IZR l * IZR k));
    [|apply Rgt_not_eq; unfold Rgt; now repeat apply Rmult_lt_0_compat].
  replace (r / (IZR w * IZR l) * (IZR w * IZR l * IZR k)) with (r * IZR k) by (field; lra).
  rewrite E. field. lra.
Qed.
End Elsewhere.

Theorem elsewhere_rule D x t q w : covered_elsewhere D x t q w = true ->
  uncovered (domain_of_certificate (dimension_of D) (about_domain x))
    (refuted_simplices D (mesh_against x) ++ dangling_simplices D (mesh_against x)
      (dangling_against x)).
Proof.
  intros H. unfold covered_elsewhere in H. cbv zeta in H. rewrite !andb_true_iff in H.
  destruct H as [[[[[[[[[Rf Un] Ud] Nc] Dc] Sh] Wr] Ch] Ke] Al].
  assert (R : refuted (mesh_against x) = Delaunay) by (destruct (refuted _); try discriminate;
    reflexivity). clear Rf.
  assert (A : check_domain D (as_steiner (about_domain x)) = Accepted)
    by (destruct (check_domain _ _); [reflexivity|discriminate]).
  clear Ch. pose proof (check_domain_sound D _ A) as St. cbn [as_steiner domain_claimed] in St.
  assert (G : forall d orient pr, (forall r, 0 < r -> @measured d orient pr r) -> forall P T,
    P = domain_of_certificate d (about_domain x) -> T = mesh_of_domain d (about_domain x) ->
      solid_triangulation P T ->
    forallb (shaped pr) (sites (padded (mesh_against x) (dangling_against x))) = true ->
      point_written pr q w = true ->
    in_kept_simplex pr (about_domain x) t q w = true ->
    all_of (mesh_against x) (dangling_against x) (fun S => misses pr S
      (times (numerator (whole_mesh (about_domain x)) * unit_denominator (mesh_against x)) q)
      (w * (denominator (whole_mesh (about_domain x)) * unit_numerator (mesh_against x)))) = true ->
    uncovered P (@caller_rows d (refuted_unit (mesh_against x)) (sites (mesh_against x))
      (rows (mesh_against x)) ++
      @caller_rows d (refuted_unit (mesh_against x)) (sites (mesh_against x))
        (map fst (dangling (dangling_against x))))).
  { clear - Un Ud Nc Dc R. intros d orient pr M P T EP ET St Sh Wr Ke Al.
    apply Z.ltb_lt in Un, Ud, Nc, Dc.
    assert (Un' := IZR_lt _ _ Un). assert (Ud' := IZR_lt _ _ Ud). assert (Nc' := IZR_lt _ _ Nc).
    assert (Dc' := IZR_lt _ _ Dc).
    assert (Pm : 0 < refuted_unit (mesh_against x)) by (unfold refuted_unit;
      now apply Rdiv_lt_0_compat).
    assert (Pc : 0 < unit_of (whole_mesh (about_domain x))) by (unfold unit_of;
      now apply Rdiv_lt_0_compat).
    apply (written (M _ Pm)) in Wr. destruct Wr as [Sq Pw].
    destruct (in_kept_simplex_covered M x t q w Pc Sq Pw Ke) as (s & Is & Cs).
    exists (place_over (unit_of (whole_mesh (about_domain x))) q w). split.
    { apply St. exists s. rewrite ET. now split. }
    set (k := (numerator (whole_mesh (about_domain x)) * unit_denominator (mesh_against x))%Z) in *.
    set (l := (denominator (whole_mesh (about_domain x)) * unit_numerator (mesh_against x))%Z) in *.
    assert (Pk : (0 < k)%Z) by (unfold k; lia). assert (Pl : (0 < l)%Z) by (unfold l; lia).
    rewrite <- (other_unit (d := d) k l w (refuted_unit (mesh_against x))
      (unit_of (whole_mesh (about_domain x))) q Sq Pw Pk Pl Pm).
    2: { unfold k, l, refuted_unit, unit_of. rewrite !mult_IZR. field. lra. }
    unfold all_of in Al. apply andb_prop in Al. destruct Al as [Kn Al].
    apply (in_none_of_fuller _ _ (fuller (mesh_against x) (dangling_against x) Kn)).
    apply (missed M (padded (mesh_against x) (dangling_against x)) Pm R Sh); [exact Al| |lia].
    destruct (times_place d 1 k q Pk Sq) as [S' _]. exact S'. }
  unfold refuted_simplices, dangling_simplices. destruct D; cbn [dimension_of predicates_of] in *.
  - now apply (G 2%nat _ _ measured_plane _ (mesh_of_domain 2 (about_domain x))).
  - now apply (G 3%nat _ _ measured_space _ (mesh_of_domain 3 (about_domain x))).
Qed.

(** ** The theorems *)

Theorem refute_whole_rule D x : refute_whole D x = true ->
  broken_of_domain (domain_of_certificate (dimension_of D) (about_domain x))
    (refuted_simplices D (mesh_against x))
    (dangling_simplices D (mesh_against x) (dangling_against x)) (whole_rule_of x).
Proof.
  intros A. unfold refute_whole in A.
  assert (Usual : refute_whole_in (predicates_of D) x = true ->
    broken_of_domain (domain_of_certificate (dimension_of D) (about_domain x))
    (refuted_simplices D (mesh_against x)) (dangling_simplices D (mesh_against x)
      (dangling_against x)) (whole_rule_of x)).
  { clear A. intros A. unfold refuted_simplices, dangling_simplices.
    destruct D; cbn [dimension_of] in *.
    - now apply (shown_whole_rule measured_plane x known_in_the_plane).
    - now apply (shown_whole_rule measured_space x known_in_space). }
  destruct (shown_by x) eqn:E; try exact (Usual A). unfold whole_rule_of. rewrite E.
  cbn [broken_of_domain].
  now apply (elsewhere_rule D x t q w).
Qed.
Theorem refute_whole_sound D x : refute_whole D x = true ->
  ~ claims_of_domain (domain_claimed (about_domain x)) (domain_of_certificate (dimension_of D)
    (about_domain x))
      (refuted_simplices D (mesh_against x)) (dangling_simplices D (mesh_against x)
        (dangling_against x)).
Proof.
  intros A. pose proof (refute_whole_rule D x A) as B.
  destruct (match shown_by x with CoveredElsewhere _ _ _ => true | _ => false end) eqn:Ce.
  { unfold whole_rule_of in B. destruct (shown_by x); try discriminate. now apply uncovered_refutes.
    }
  assert (A' : refute_whole_in (predicates_of D) x = true) by (unfold refute_whole in A;
    now destruct (shown_by x)). clear A. rename A' into A.
  assert (Pr : proper_domain (domain_of_certificate (dimension_of D) (about_domain x))).
  { destruct D; cbn [dimension_of] in *.
    - now apply (shown_whole_rule measured_plane x known_in_the_plane).
    - now apply (shown_whole_rule measured_space x known_in_space). }
  assert (Two : (2 <= dimension_of D)%nat) by (destruct D; cbn; lia).
  assert (Alone : nothing_dangles (predicates_of D) (mesh_against x) (dangling_against x) = true ->
    dangling_simplices D (mesh_against x) (dangling_against x) = [] /\
      all_full (refuted_simplices D (mesh_against x))).
  { unfold nothing_dangles, dangling_simplices. destruct (dangling _); [|discriminate]. intros Fu.
    split; [reflexivity|].
    intros r I. apply in_map_iff in I. destruct I as (y & <- & Iy). rewrite map_length.
    rewrite forallb_forall in Fu.
    specialize (Fu y Iy). apply has_length_length in Fu. rewrite Fu. now destruct D. }
  unfold refute_whole_in in A. cbv zeta in A. apply andb_prop in A. destruct A as [_ A].
  unfold whole_rule_of in B. destruct (shown_by x); cbn [broken_of_domain] in B;
    cbn [whole_holds] in A.
  - rewrite !andb_true_iff in A. destruct Alone as [-> Fu]; [apply A|].
    apply constrained_facet_refutes; try assumption. apply A.
  - rewrite !andb_true_iff in A. destruct Alone as [-> Fu]; [apply A|].
    apply visible_vertex_refutes; try assumption. apply A.
  - now apply polygon_not_tiled_refutes.
  - now apply uncovered_refutes.
  - now apply outside_refutes.
  - intros C. apply B.
    split; [intros U; exact (uncovered_refutes _ _ _ _ U C)|intros U;
      exact (outside_refutes _ _ _ _ U C)].
  - rewrite !andb_true_iff in A. destruct A as [[[K Al] E] _]. destruct (Alone Al) as [Em Fu].
    rewrite Em in *.
    apply (hull_rule_refutes _ _ _ e); try assumption; [cbn [domain_of_certificate what_it_fills];
      now destruct (kind (about_domain x))|].
    now destruct e.
  - discriminate.
  - rewrite !andb_true_iff in A. destruct A as [[[[Cl K] _] _] _].
    apply dangling_refutes; try assumption. cbn [domain_of_certificate what_it_fills].
    now destruct (kind (about_domain x)).
Qed.
