(** * What the acceptance of a refutation of a claim about a domain means *)
From Coq Require Import Rbase Rfunctions Lra Psatz Lia List Arith ZArith Bool.
From Circumspect Require Import DomainRefutation Numbering.
From Circumspect Require Import Definitions Domains DomainRules Vectors Affine Frame Faces
  LiftingMap Breach.
From Circumspect Require Import Orientation Integers RefutationSigns CallerMesh EvidenceSound Broken
  RefutationSound.
From Circumspect Require Import Combinations Soundness DomainBroken Dangling Balls.
From Circumspect Require KeptCells.
Import ListNotations.
Open Scope R_scope.

(** ** Points on segments are found to be on them *)

Lemma differences_between d : forall (A B P : list Z) t, length A = d -> length B = d ->
  length P = d ->
  integer_point d P = between (integer_point d A) (integer_point d B) t ->
  map IZR (differences P A) = map (fun z => t * IZR z) (differences B A).
Proof.
  induction d as [|d IH]; intros [|a A] [|b B] [|p P] t LA LB LP E; try discriminate;
    [reflexivity|].
  injection LA as LA. injection LB as LB. injection LP as LP. cbn [differences map].
  assert (Eh := f_equal Vector.hd E). assert (Et := f_equal Vector.tl E).
  cbn in Eh, Et. rewrite !minus_IZR. f_equal; [lra|]. now apply IH.
Qed.
Lemma inner_differences (u v : list Z) t : map IZR v = map (fun z => t * IZR z) u ->
  IZR (inner_product u v) = t * IZR (inner_product u u).
Proof.
  revert v. induction u as [|x u IH]; intros [|y v] E; try discriminate; cbn [inner_product];
    [cbn; ring|].
  cbn [map] in E. injection E as Ex E. rewrite !plus_IZR, !mult_IZR, (IH v E), Ex. ring.
Qed.
Lemma same_integers_refl l : same_integers l l = true.
Proof. induction l as [|x l IH]; [reflexivity|]. cbn. now rewrite Z.eqb_refl. Qed.
Lemma inner_nonneg u : (0 <= inner_product u u)%Z.
Proof. induction u as [|x u IH]; cbn; [lia|]. nia. Qed.

Lemma on_segment_complete d r a b p t : 0 < r -> well_shaped d a -> well_shaped d b ->
  well_shaped d p ->
  coordinates a <> coordinates b -> 0 <= t <= 1 ->
    @place_of d r p = between (place_of r a) (place_of r b) t ->
  on_segment a b p = true.
Proof.
  intros Pr Sa Sb Sp Ne Ht E.
  assert (E' : integer_point d (coordinates p) = between (integer_point d (coordinates a))
    (integer_point d (coordinates b)) t).
  { apply (f_equal (scale (/ r))) in E. unfold place_of, between in *.
    rewrite scale_plus, !scale_scale in E.
    replace (/ r * r) with 1 in E by (field; lra). rewrite scale_one in E. rewrite E.
    f_equal; f_equal; field; lra. }
  pose proof (differences_between d _ _ _ t Sa Sb Sp E') as Df.
  unfold on_segment. cbv zeta. set (u := differences (coordinates b) (coordinates a)) in *.
  set (v := differences (coordinates p) (coordinates a)) in *.
  pose proof (inner_differences u v t Df) as In_. pose proof (inner_nonneg u) as Nn.
  assert (Pos : (0 < inner_product u u)%Z).
  { assert (Z0 : forall A B : list Z, length A = length B ->
      inner_product (differences B A) (differences B A) = 0%Z -> A = B).
    { induction A as [|x A IH]; intros [|y B] L Z; try discriminate; [reflexivity|]. cbn in Z.
      pose proof (inner_nonneg (differences B A)). injection L as L. assert (x = y) by nia. subst y.
      f_equal.
      apply IH; [assumption|nia]. }
    destruct (Z.eq_dec (inner_product u u) 0) as [Z|]; [|lia]. exfalso. apply Ne.
    apply Z0; [|exact Z].
    unfold well_shaped in Sa, Sb. congruence. }
  pose proof (IZR_lt _ _ Pos) as PosR.
  assert (B1 : (0 <= inner_product u v)%Z) by (apply le_IZR; rewrite In_; nra).
  assert (B2 : (inner_product u v <= inner_product u u)%Z) by (apply le_IZR; rewrite In_; nra).
  apply andb_true_intro. split.
  - rewrite (proj2 (Z.ltb_lt _ _) Pos), (proj2 (Z.leb_le _ _) B1), (proj2 (Z.leb_le _ _) B2).
    reflexivity.
  - replace (map (Z.mul (inner_product u u)) v) with (map (Z.mul (inner_product u v)) u);
      [apply same_integers_refl|].
    revert Df In_. generalize (inner_product u u) as l, (inner_product u v) as n. clearbody u v.
    clear. intros l n Df E.
    revert v Df. induction u as [|x u IH]; intros [|y v] Df; try discriminate; [reflexivity|].
    cbn [map] in Df. injection Df as Dx Df. cbn [map]. f_equal; [|now apply IH].
    apply eq_IZR. rewrite !mult_IZR, Dx, E. ring.
Qed.

Lemma on_segment_different a b q w : on_segment (times w a) (times w b) q = true ->
  coordinates a <> coordinates b.
Proof.
  intros On E. unfold on_segment, times in On. cbv zeta in On. cbn [coordinates] in On.
  rewrite E in On.
  repeat (apply andb_prop in On; destruct On as [On _]). apply Z.ltb_lt in On.
  assert (Z : forall l, inner_product (differences l l) (differences l l) = 0%Z).
  { induction l as [|x l IH]; [reflexivity|]. cbn. rewrite IH. lia. }
  rewrite Z in On. lia.
Qed.
Lemma times_place d r w x : (0 < w)%Z -> well_shaped d x ->
  well_shaped d (times w x) /\ @place_of d (r / IZR w) (times w x) = place_of r x.
Proof.
  intros Pw Sx. apply IZR_lt in Pw.
  split; [unfold well_shaped, times in *; cbn; now rewrite map_length|].
  unfold place_of, times. cbn [coordinates].
  rewrite (KeptCells.integer_multiple d w _ Sx), scale_scale.
  f_equal. field. lra.
Qed.

(** ** The evidence shows the rule *)

Lemma has_at_most_less {A} n : forall l : list A, has_at_most n l = false <-> (n < length l)%nat.
Proof.
  induction n as [|n IH]; intros [|a l]; cbn [has_at_most length]; try (split; [discriminate|lia]);
    [split; [lia|reflexivity]|].
  rewrite IH. lia.
Qed.

Section Shown.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis M : forall r, 0 < r -> measured orient pr r.
Variables (m : refutation) (c : domain_refutation).
Notation r := (refuted_unit m).
Variable P : domain d.
Hypothesis vertices_described : forall v, In v (domain_vertices P) <->
  In v (map (@place_of d r) (vertices_given c)).
Hypothesis segments_described : forall j k a b, In (j, k) (segments_given c) ->
  option_map (@place_of d r) (numbered (vertices_given c) j) = Some a ->
  option_map (@place_of d r) (numbered (vertices_given c) k) = Some b ->
    In (a, b) (domain_segments P).
Notation L := (@caller_rows d r (sites m) (rows m)).

Theorem shown_rule : shows_domain pr m c = true ->
  match domain_because c with
  | VertexMissing _ => vertex_missing P L
  | SteinerForbidden _ _ => steiner_forbidden P L
  | SegmentMissing _ _ _ => segment_missing P L
  | VertexInEdge _ _ _ _ _ _ => vertex_in_edge P L
  | NoEmptyBall _ _ _ | OfMesh => False
  end.
Proof.
  intros H. unfold shows_domain in H.
  destruct (domain_because c) as [k|t i|k q w|t i u j k s|u own others|] eqn:Be;
    [..|rewrite andb_false_r in H; discriminate|rewrite andb_false_r in H; discriminate].
  all: rewrite !andb_true_iff in H; destruct H as [[[[Pn Pd] Sh] Sv] H];
    apply Z.ltb_lt, IZR_lt in Pn, Pd;
    assert (Pr : 0 < r) by (unfold refuted_unit; now apply Rdiv_lt_0_compat);
    assert (ShV : forall v, In v (vertices_given c) -> well_shaped d v) by
      (intros v Iv; rewrite forallb_forall in Sv; specialize (Sv v Iv); unfold shaped in Sv;
       apply Nat.eqb_eq in Sv; now rewrite (dimension_d (M r Pr)) in Sv);
    pose proof (sites_shaped M m Pr Sh) as ShS; pose proof (sites_found m) as Fs;
    cbn [holds_of_domain] in *.
  - rewrite table_find in H. destruct (numbered (vertices_given c) k) as [v|] eqn:Ev;
      [|discriminate].
    cbn [option_map] in H. unfold Datatypes.id in H. apply numbered_in in Ev.
    apply negb_true_iff in H.
    exists (place_of r v). split; [apply vertices_described; now apply in_map|].
    rewrite <- (rows_site_for (d := d) m). intros s Hs I. apply in_map_iff in Hs.
    destruct Hs as (x & E & Hx).
    assert (T : existsb (lists (Table.of_list (site_for (refuted m)) (sites m)) v) (rows m) = true);
      [|congruence].
    apply existsb_exists. exists x. split; [assumption|]. unfold lists. apply existsb_exists.
    rewrite <- E in I. apply in_map_iff in I. destruct I as (n & En & Hn).
    exists n. split; [assumption|].
    rewrite (caller_named (M r Pr) _ (rows m) _ _ ShS Fs (rows_found m)) in En.
    destruct (named _ n) as [y|] eqn:Ey; [|discriminate]. injection En as En.
    apply (same_place_place (M r Pr)); [now apply ShV| |congruence].
    pose proof (proj1 (Forall_forall _ _) ShS) as All. apply All.
    now apply (named_in (M r Pr) _ (rows m) _ _ ShS Fs (rows_found m) n).
  - apply (entry_at_in (M r Pr) _ (rows m) _ _ ShS Fs (rows_found m)) in H.
    destruct H as (x & n & _ & I & En & H). destruct (named _ n) as [y|] eqn:Ey; [|discriminate].
    exists (map (@caller_entry d r (map (site_for (refuted m)) (sites m))) x), (place_of r y).
    rewrite <- (rows_site_for (d := d) m). split; [assumption|]. split.
    + apply nth_error_In in En.
      replace (Some (place_of r y)) with (@caller_entry d r (map (site_for (refuted m)) (sites m))
        n);
        [now apply in_map|].
      rewrite (caller_named (M r Pr) _ (rows m) _ _ ShS Fs (rows_found m)), Ey. reflexivity.
    + intros Iv. apply vertices_described, in_map_iff in Iv. destruct Iv as (v & E & Iv).
      apply negb_true_iff in H. assert (T : existsb (same_place y) (vertices_given c) = true);
        [|congruence].
      apply existsb_exists. exists v. split; [assumption|].
      apply (same_place_place (M r Pr)); [|now apply ShV|congruence].
      pose proof (proj1 (Forall_forall _ _) ShS) as All. apply All.
      now apply (named_in (M r Pr) _ (rows m) _ _ ShS Fs (rows_found m) n).
  - rewrite table_find in H. destruct (numbered (segments_given c) k) as [(i, j)|] eqn:Ek;
      [|discriminate].
    cbn [option_map] in H. unfold Datatypes.id in H. rewrite !table_find in H.
    destruct (numbered (vertices_given c) i) as [a|] eqn:Ea; [|discriminate].
    destruct (numbered (vertices_given c) j) as [b|] eqn:Eb; [|discriminate].
    cbn [option_map] in H. unfold Datatypes.id in H.
    rewrite !andb_true_iff in H. destruct H as [[Wr On] Al].
    pose proof (ShV a (numbered_in _ _ _ Ea)) as Sa.
    pose proof (ShV b (numbered_in _ _ _ Eb)) as Sb.
    unfold point_written in Wr. apply andb_true_iff in Wr. destruct Wr as [Sq Pw].
    unfold shaped in Sq. apply Nat.eqb_eq in Sq. rewrite (dimension_d (M r Pr)) in Sq.
    apply Z.ltb_lt in Pw. pose proof (IZR_lt _ _ Pw) as PwR.
    assert (Times : forall x, well_shaped d x -> well_shaped d (times w x) /\
      @place_of d (r / IZR w) (times w x) = place_of r x) by (intros; now apply times_place).
    destruct (Times a Sa) as [Sta Ta]. destruct (Times b Sb) as [Stb Tb].
    destruct (on_segment_between d (r / IZR w) _ _ q Sta Stb Sq On) as [Ht Eq].
    rewrite Ta, Tb in Eq.
    assert (Ne := on_segment_different a b q w On).
    exists (place_of r a), (place_of r b), (@place_over d r q w). split; [|split].
    + apply (segments_described i j); [now apply numbered_in with k| |];
        [now rewrite Ea|now rewrite Eb].
    + apply conv_two. exists (ratio (times w a) (times w b) q). split; [assumption|exact Eq].
    + intros s f Ls If Cf Wi. rewrite <- (rows_site_for (d := d) m) in Ls.
      apply in_map_iff in Ls. destruct Ls as (x & E & Ix). rewrite forallb_forall in Al.
      specialize (Al x Ix).
      unfold not_along in Al.
      destruct (proper_simplex_of pr _ x) as [X|] eqn:Px; [|discriminate].
      apply (proper_simplex_of_frame (M r Pr) _ (rows m) _ _ ShS Fs (rows_found m)) in Px.
      destruct Px as (Vx & g & G).
      pose proof (vertices_rows _ x X Vx) as Er. rewrite Er in E. apply map_some_inj in E. subst s.
      pose proof (framed_vertices X g G) as Vg. rewrite <- Vg in If.
      pose proof Cf as Cg. apply (conv_face g f _ If) in Cg. destruct Cg as [Ig Car].
      apply orb_true_iff in Al. destruct Al as [N|Al].
      * apply negb_true_iff in N. assert (T : in_simplex pr X q w = true); [|congruence].
        unfold in_simplex. apply forallb_forall. intros i0 Hi. unfold corners_numbered in Hi.
        rewrite (dimension_d (M r Pr)) in Hi. apply in_seq_d in Hi.
        apply Z.leb_le, le_IZR.
        rewrite (coordinate_sign_bary (M r Pr) X g G q w i0 Hi Sq Pw).
        pose proof (square_positive X g G). specialize (Ig i0 Hi).
        apply Rmult_le_pos; [apply Rmult_le_pos; lra|assumption].
      * apply existsb_exists in Al. destruct Al as (v & Iv & N). apply negb_true_iff in N.
        assert (Sv' : well_shaped d v).
        { apply carrier_of_incl in Iv. pose proof (framed_shaped X g G) as Sh'.
          rewrite Forall_forall in Sh'. now apply Sh'. }
        assert (Cv : In (place_of r v) (carrier g (@place_over d r q w))).
        { apply (carrier_of_carrier (M r Pr) X g G q w Sq Pw). now apply in_map. }
        apply in_carrier in Cv. destruct Cv as (i0 & Hi & Pi & Ev).
        pose proof (Car i0 Hi Pi) as Fv. rewrite <- Ev in Fv.
        pose proof (Wi _ (conv_point f _ Fv)) as Cv. apply conv_two in Cv.
        destruct Cv as (t & Ht' & Et).
        rewrite (on_segment_complete d r a b v t Pr Sa Sb Sv' Ne Ht' Et) in N. discriminate.
  - rewrite table_find in H. destruct (numbered (segments_given c) s) as [(m0, n0)|] eqn:Ek;
      [|discriminate].
    cbn [option_map] in H. unfold Datatypes.id in H. rewrite !table_find in H.
    destruct (numbered (vertices_given c) m0) as [a|] eqn:Ea; [|discriminate].
    destruct (numbered (vertices_given c) n0) as [b|] eqn:Eb; [|discriminate].
    cbn [option_map] in H. unfold Datatypes.id in H.
    pose proof (ShV a (numbered_in _ _ _ Ea)) as Sa.
    pose proof (ShV b (numbered_in _ _ _ Eb)) as Sb.
    apply (entry_at_in (M r Pr) _ (rows m) _ _ ShS Fs (rows_found m)) in H.
    destruct H as (x & n & _ & I & En & H). destruct (named _ n) as [p|] eqn:Ep; [|discriminate].
    apply andb_true_iff in H. destruct H as [On H].
    apply (row_at_in (M r Pr) _ (rows m) _ _ ShS Fs (rows_found m)) in H.
    destruct H as (y & _ & Iy & H).
    destruct (face_of pr _ y) as [X|] eqn:EX; [|discriminate].
    assert (LX : listed (@caller_rows d r (map (site_for (refuted m)) (sites m)) (rows m))
      (map (place_of r) X) /\
      incl X (map (site_for (refuted m)) (sites m))).
    { unfold face_of in EX. destruct (has_at_most _ y); [|discriminate].
      apply (all_named_rows (M r Pr) _ (rows m) _ _ ShS Fs (rows_found m)) in EX.
      destruct EX as [EX IX].
      split; [|assumption]. unfold listed. now rewrite <- EX. }
    clear EX Iy. destruct LX as [LX IX].
    destruct (nth_error X j) as [e|] eqn:Ee; [|discriminate].
    destruct (nth_error X k) as [f|] eqn:Ef; [|discriminate].
    rewrite !andb_true_iff in H. destruct H as [[Ne Nf] On']. apply negb_true_iff in Ne, Nf.
    apply nth_error_In in Ee, Ef. pose proof (proj1 (Forall_forall _ _) ShS) as All.
    assert (Ip := named_in (M r Pr) _ (rows m) _ _ ShS Fs (rows_found m) n p Ep).
    pose proof (All p Ip) as Sp. pose proof (All e (IX e Ee)) as Se.
    pose proof (All f (IX f Ef)) as Sf.
    destruct (on_segment_between d r a b p Sa Sb Sp On) as [Ht Eq].
    destruct (on_segment_between d r e f p Se Sf Sp On') as [Ht' Eq'].
    exists (map (@caller_entry d r (map (site_for (refuted m)) (sites m))) x), (map (place_of r) X),
      (place_of r p),
      (place_of r a), (place_of r b), (place_of r e), (place_of r f).
    rewrite <- (rows_site_for (d := d) m). split; [assumption|]. split; [|split; [assumption|]].
    + apply nth_error_In in En.
      replace (Some (place_of r p)) with (@caller_entry d r (map (site_for (refuted m)) (sites m))
        n);
        [now apply in_map|].
      rewrite (caller_named (M r Pr) _ (rows m) _ _ ShS Fs (rows_found m)), Ep. reflexivity.
    + split; [now apply in_map|]. split; [now apply in_map|].
      split; [intros E; apply (same_place_place (M r Pr)) in E; [congruence|assumption..]|].
      split; [intros E; apply (same_place_place (M r Pr)) in E; [congruence|assumption..]|].
      split; [apply conv_two; eexists; split; [exact Ht'|exact Eq']|].
      split; [|apply conv_two; eexists; split; [exact Ht|exact Eq]].
      apply (segments_described m0 n0); [now apply numbered_in with s| |];
        [now rewrite Ea|now rewrite Eb].
Qed.

(** A vertex of the mesh: one of its rows lists it. *)
Lemma listed_entry p : refuted m = Delaunay -> lists_in_mesh m p = true -> 0 < r ->
  forallb (shaped pr) (sites m) = true ->
  exists y, numbered (sites m) p = Some y /\ In (place_of r y) (entries L).
Proof.
  intros R Li Pr Sh. unfold lists_in_mesh, point_at in Li. cbv zeta in Li. rewrite <- R in Li.
  pose proof (sites_shaped M m Pr Sh) as ShS. pose proof (sites_found m) as Fs. rewrite Fs in Li.
  unfold numbered in Li. rewrite nth_error_map in Li.
  destruct (nth_error (sites m) _) as [y|] eqn:Ey; [|discriminate].
  cbn [option_map] in Li. exists y. split; [exact Ey|].
  apply existsb_exists in Li. destruct Li as (x & Ix & Li). unfold lists in Li.
  apply existsb_exists in Li.
  destruct Li as (n & In_ & Hn). destruct (named _ n) as [z|] eqn:En; [|discriminate].
  assert (Iz := named_in (M r Pr) _ (rows m) _ _ ShS Fs (rows_found m) n z En).
  assert (Iy : In (site_for (refuted m) y) (map (site_for (refuted m)) (sites m))) by (apply in_map;
    now apply nth_error_In in Ey).
  pose proof (proj1 (Forall_forall _ _) ShS) as All.
  apply (same_place_place (M r Pr)) in Hn; [|now apply All..].
  rewrite (place_site_for (d := d) m) in Hn.
  unfold entries. apply in_flat_map. exists (map (@caller_entry d r (sites m)) x).
  split; [now apply (in_map (map (@caller_entry d r (sites m))))|].
  apply in_flat_map. exists (Some (place_of r y)). split; [|now left]. apply in_map_iff. exists n.
  split; [|assumption].
  rewrite <- (entry_site_for m (sites m)), <- R.
  rewrite (caller_named (M r Pr) _ (rows m) _ _ ShS Fs (rows_found m)), En. cbn [option_map].
  now rewrite Hn.
Qed.
End Shown.

Section Accepted.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis M : forall r, 0 < r -> measured orient pr r.
Variable c : domain_refutation.
Notation m := (mesh_refuted c).
Notation x := (dangling_refuted c).
Notation r := (refuted_unit m).
Variable P : domain d.
Hypothesis vertices_described : forall v, In v (domain_vertices P) <->
  In v (map (@place_of d r) (vertices_given c)).
Hypothesis segments_described : forall j k a b, In (j, k) (segments_given c) ->
  option_map (@place_of d r) (numbered (vertices_given c) j) = Some a ->
  option_map (@place_of d r) (numbered (vertices_given c) k) = Some b ->
    In (a, b) (domain_segments P).
Notation L := (@caller_rows d r (sites m) (rows m)).
Notation U := (@caller_rows d r (sites m) (map fst (dangling x))).

(** A vertex of the domain. *)
Lemma given_entry k : refuted m = Delaunay -> 0 < r -> forallb (shaped pr) (sites m) = true ->
  forallb (shaped pr) (vertices_given c) = true -> given_in_mesh m (vertices_given c) k = true ->
  exists y, numbered (sites m) k = Some y /\ In (place_of r y) (domain_vertices P).
Proof.
  intros Rd Pr Sh Sv Li. unfold given_in_mesh, point_at in Li. rewrite table_find in Li.
  destruct (numbered (sites m) k) as [y|] eqn:Ey; [|discriminate]. exists y. split; [reflexivity|].
  apply vertices_described. cbn [option_map] in Li. apply existsb_exists in Li.
  destruct Li as (v & Iv & E).
  apply in_map_iff. exists v. split; [|assumption]. symmetry.
  rewrite <- (place_site_for (d := d) m y), Rd.
  rewrite forallb_forall in Sv, Sh. apply (same_place_place (M r Pr)); [| |assumption];
    unfold well_shaped.
  - specialize (Sh y (numbered_in _ _ _ Ey)). unfold shaped in Sh. apply Nat.eqb_eq in Sh.
    rewrite (dimension_d (M r Pr)) in Sh. exact Sh.
  - specialize (Sv v Iv). unfold shaped in Sv. apply Nat.eqb_eq in Sv.
    now rewrite (dimension_d (M r Pr)) in Sv.
Qed.

Theorem accepted_rule : refute_domain_in pr c = true -> broken_of_domain P L U (domain_rule_of c).
Proof.
  intros H. unfold refute_domain_in in H. cbv zeta in H. unfold domain_rule_of.
  apply andb_prop in H. destruct H as [R H].
  assert (Rd : refuted m = Delaunay) by (destruct (refuted m); try discriminate; reflexivity).
  clear R.
  pose proof (listed_rows (d := d) m x) as Rows.
  assert (Listed : shows_domain pr (as_listed m x) c = true -> match domain_because c with
    | VertexMissing _ => vertex_missing P (L ++ U) | SteinerForbidden _ _ =>
        steiner_forbidden P (L ++ U)
    | SegmentMissing _ _ _ => segment_missing P (L ++ U) | VertexInEdge _ _ _ _ _ _ =>
        vertex_in_edge P (L ++ U)
    | NoEmptyBall _ _ _ | OfMesh => False end).
  { intros K. pose proof (shown_rule M (as_listed m x) c P vertices_described segments_described K)
      as B.
    change (refuted_unit (as_listed m x)) with r in B. now rewrite Rows in B. }
  destruct (domain_because c) as [k|t i|k q w|t i u j k s|u own others|] eqn:Be;
    cbn [broken_of_domain].
  - now apply Listed.
  - apply andb_prop in H. now apply Listed.
  - apply andb_prop in H. destruct H as [K H].
    pose proof (shown_rule M (padded m x) c P vertices_described segments_described H) as B.
    rewrite Be in B.
    exact (segment_missing_of_fuller _ _ (fuller m x K) P B).
  - now apply Listed.
  - rewrite !andb_true_iff in H. destruct H as [[[[[[[_ Pn] Pd] Sh] Sv] _] Li] H].
    apply Z.ltb_lt, IZR_lt in Pn, Pd.
    assert (Pr : 0 < r) by (unfold refuted_unit; now apply Rdiv_lt_0_compat).
    apply (no_empty_ball_found M m x Pr Rd Sh P u own others H). intros k z I.
    rewrite forallb_forall in Li. specialize (Li (k, z) I).
    assert (Sh' : forallb (shaped pr) (sites (as_listed m x)) = true).
    { rewrite padded_sites, forallb_app in Sh. now apply andb_prop in Sh. }
    apply orb_prop in Li. destruct Li as [Li|Li].
    + destruct (given_entry k Rd Pr Sh' Sv Li) as (y & Ey & Iy). exists y. split; [exact Ey|].
      now right.
    + destruct (listed_entry M (as_listed m x) k Rd Li Pr Sh') as (y & Ey & Iy). exists y.
      split; [exact Ey|]. left.
      change (refuted_unit (as_listed m x)) with r in Iy. now rewrite Rows in Iy.
  - apply andb_prop in H. destruct H as [O H].
    assert (G : refute_in pr m = true -> broken Delaunay norm2 (@caller_points d r (sites m)) L
      (rule_of (because m))).
    { intros A. pose proof (accepted_breach M m A (fun _ => 0)) as [_ B];
        [rewrite Rd; discriminate|]. now rewrite Rd in B. }
    destruct (because m) eqn:Bm; try discriminate; cbn [rule_of broken broken_of_domain] in *;
      try exact (G H).
    + apply andb_prop in H. destruct H as [A H]. unfold refute_in in A. rewrite !andb_true_iff in A.
      destruct A as [[[[[_ Pn] Pd] _] _] _]. apply Z.ltb_lt, IZR_lt in Pn, Pd.
      assert (Pr : 0 < r) by (unfold refuted_unit; now apply Rdiv_lt_0_compat).
      unfold row_at in H. rewrite table_find in H. destruct (numbered (rows m) t) as [y|] eqn:Ey;
        [|discriminate].
      cbn [option_map] in H. unfold Datatypes.id in H. apply numbered_in in Ey.
      exists (map (@caller_entry d r (sites m)) y).
      split; [now apply (in_map (map (@caller_entry d r (sites m))))|].
      destruct y as [|n y]; [now left|right]. unfold no_simplex_row in H. apply negb_true_iff in H.
      rewrite (dimension_d (M r Pr)) in H. rewrite map_length. now apply has_at_most_less.
    + rewrite !andb_true_iff in H. destruct H as [[[Pn Pd] Sh] H]. apply Z.ltb_lt, IZR_lt in Pn, Pd.
      assert (Pr : 0 < r) by (unfold refuted_unit; now apply Rdiv_lt_0_compat).
      exact (overlap_found M m x Pr Rd Sh t u q w H).
    + apply andb_prop in H. destruct H as [A Li]. pose proof A as A'. unfold refute_in in A'.
      rewrite !andb_true_iff, Bm in A'.
      destruct A' as [[[[[_ Pn] Pd] Sh] _] Ho]. apply Z.ltb_lt, IZR_lt in Pn, Pd.
      assert (Pr : 0 < r) by (unfold refuted_unit; now apply Rdiv_lt_0_compat).
      assert (I : exists y, numbered (sites m) p = Some y /\
        In (place_of r y) (entries (L ++ U) ++ domain_vertices P)).
      { apply orb_prop in Li. destruct Li as [Li|Li].
        - destruct (listed_entry M (as_listed m x) p Rd Li Pr Sh) as (y & Ey & Iy). exists y.
          split; [exact Ey|].
          change (refuted_unit (as_listed m x)) with r in Iy. rewrite Rows in Iy. apply in_or_app.
          now left.
        - apply andb_prop in Li. destruct Li as [Li Sv].
          destruct (given_entry p Rd Pr Sh Sv Li) as (y & Ey & Iy).
          exists y. split; [exact Ey|]. apply in_or_app. now right. }
      destruct I as (y & Ey & Iy). cbn [holds] in Ho.
      pose proof (sites_shaped M m Pr Sh) as ShS. pose proof (sites_found m) as Fs.
      apply (proper_at_in (M r Pr) _ (rows m) _ _ ShS Fs (rows_found m)) in Ho.
      destruct Ho as (X & g & FX & IX & LX & Ho).
      unfold point_at in Ho. rewrite Fs in Ho. unfold numbered in Ho, Ey.
      rewrite nth_error_map in Ho.
      cbn [as_listed with_rows sites] in Ey. rewrite Ey in Ho. cbn [option_map] in Ho.
      assert (Sy : In (site_for (refuted m) y) (map (site_for (refuted m)) (sites m)))
        by (apply in_map; now apply nth_error_In in Ey).
      pose proof (proj1 (Forall_forall _ _) ShS) as All.
      exists (map (place_of r) X), (place_of r y). split; [|split; [exact Iy|]].
      * rewrite <- (rows_site_for (d := d) m). split; [assumption|].
        rewrite <- (framed_vertices X g FX).
        split; [apply vertices_length|apply vertices_independent].
      * rewrite <- (framed_vertices X g FX), <- (place_site_for (d := d) m y).
        apply below_in_balls, below_all_planes.
        apply (below_witness (M r Pr) X g FX); [|now apply All|assumption].
        intros z Iz. unfold height_of. rewrite Rd in *. unfold site_for in *.
        assert (Wz : weight z = 0%Z).
        { destruct Iz as [<-|Iz]; [reflexivity|]. specialize (IX z Iz). apply in_map_iff in IX.
          now destruct IX as (z' & <- & _). }
        rewrite Wz. ring.
Qed.
End Accepted.

(** ** The theorem *)

Theorem refute_domain_rule D c (P : domain (dimension_of D)) : refute_domain D c = true ->
  described D c P ->
  broken_of_domain P (refuted_simplices D (mesh_refuted c)) (dangling_simplices D (mesh_refuted c)
    (dangling_refuted c))
    (domain_rule_of c).
Proof.
  intros A (V & S). unfold refuted_simplices, dangling_simplices.
  destruct D; cbn [dimension_of] in *.
  - now apply (accepted_rule measured_plane c P V S).
  - now apply (accepted_rule measured_space c P V S).
Qed.
Theorem refute_domain_sound D c (P : domain (dimension_of D)) : refute_domain D c = true ->
  described D c P ->
  ~ claims_of_domain (domain_refuted c) P (refuted_simplices D (mesh_refuted c))
      (dangling_simplices D (mesh_refuted c) (dangling_refuted c)).
Proof.
  intros A De. pose proof (refute_domain_rule D c P A De) as B. unfold domain_rule_of in B.
  unfold refute_domain, refute_domain_in in A. cbv zeta in A. apply andb_prop in A.
  destruct A as [_ A].
  destruct (domain_because c) as [k|t i|k q w|t i u j k s|u own others|] eqn:Be;
    cbn [broken_of_domain] in B.
  - now apply vertex_missing_refutes.
  - apply steiner_forbidden_refutes; [|assumption]. now apply andb_prop in A.
  - now apply segment_missing_refutes.
  - now apply vertex_in_edge_refutes.
  - rewrite !andb_true_iff in A. destruct A as [[[[[[[C _] _] _] _] _] _] _].
    destruct (domain_refuted c); try discriminate.
    now apply no_empty_ball_refutes.
  - apply (mesh_rule_refutes _ _ _ _ (because (mesh_refuted c))); [|assumption].
    now apply andb_prop in A.
Qed.
