(** * What an accepted certificate of points on a line, or in one place, says *)
From Coq Require Import Rbase Rfunctions Lra List Arith Lia ZArith Bool.
From Circumspect Require Import LineChecker Numbering.
From Circumspect Require Import Definitions Flats Vectors Affine Frame Faces Orientation Integers
  Accepted RefutationSigns Dimension Line.
Import ListNotations.
Open Scope R_scope.

(** ** One point *)

Lemma one_point {d} (p : point d) :
  of_dimension 0 [p] /\ flat_delaunay_triangulation 0 [p] [[p]].
Proof.
  assert (Ind : affinely_independent [p]).
  { apply dual_independent; [constructor; [intros []|constructor]|]. intros v [<-|[]].
    exists (fun _ => 1). split; [apply affine_const|]. split; [reflexivity|].
    intros w [<-|[]] N. congruence. }
  split; [split|split].
  - exists [p]. now repeat split; try apply incl_refl.
  - intros X I N. apply independent_NoDup in N. now apply (NoDup_incl_length N) in I.
  - split; [|split; [|split; [|split; [|split]]]].
    + intros t [<-|[]]. split; [constructor; [intros []|constructor]|reflexivity].
    + apply Separated.complex_of_simplices; [intros t [<-|[]]; assumption|].
      intros s t q [<-|[]] [<-|[]] C _. exists [p]. now repeat split; try apply incl_refl.
    + constructor; constructor.
    + intros t [<-|[]]. apply incl_refl.
    + intros q. split; [intros C; exists [p]; split; [now left|assumption]|].
      now intros (t & [<-|[]] & C).
    + intros q [<-|[]]. exists [p]. split; now left.
  - intros t [<-|[]]. exists p, 0.
    assert (Z : dist2 p p = 0) by (rewrite dist2_expand; unfold norm2; ring).
    split; [now intros v [<-|[]]|]. intros q [<-|[]]. lra.
Qed.

(** ** Several points *)

Section Sound.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis M : forall r, 0 < r -> measured orient pr r.
Variable c : line_certificate.
Notation r := (line_unit c).
Notation place := (@place_of d r).
Notation P := (line_points d c).
Notation T := (line_simplices d c).
Notation row t := (numbered (line_rows c) t).

Lemma lower_end_spec e k : lower_end e = Some k -> e = [k; Pos.succ k] \/ e = [Pos.succ k; k].
Proof.
  destruct e as [|i [|j [|? ?]]]; try discriminate. cbn.
  destruct (Pos.eqb_spec j (Pos.succ i)) as [->|]; [intros E; injection E as ->; now left|].
  destruct (Pos.eqb_spec i (Pos.succ j)) as [->|]; [intros E; injection E as ->; now right|].
  discriminate.
Qed.
Lemma joins_row t k : joins c t k = true -> exists e, row t = Some e /\ lower_end e = Some k.
Proof.
  unfold joins. rewrite table_find. destruct (row t) as [e|]; [|discriminate]. cbn. unfold id.
  destruct (lower_end e) as [i|] eqn:L; [|discriminate]. intros E. apply Pos.eqb_eq in E. subst i.
  now exists e.
Qed.

(** What the steps say of point number k + i + 1, which is member i of the list. *)
Lemma steps_spec X l : forall k from order, steps pr c X k from l order = Accepted ->
  length order = length l /\
  (forall s, In s l -> on_line pr X s = true /\ (from < along pr X s)%Z) /\
  (forall i j s q, (i < j)%nat -> nth_error l i = Some s -> nth_error l j = Some q ->
    (along pr X s < along pr X q)%Z) /\
  forall i t, nth_error order i = Some t -> exists e, row t = Some e /\
    lower_end e = Some (Pos.of_nat (Pos.to_nat k + i)).
Proof.
  induction l as [|s l IH]; intros k from [|t order] H; cbn [steps] in H; try discriminate.
  - split; [reflexivity|]. split; [intros s []|].
    split; [intros [|i] j s q _ E; discriminate|intros [|i] t E; discriminate].
  - cbv zeta in H. accepted. booleans. apply Z.ltb_lt in H1.
    destruct (IH _ _ _ H) as (L & O & In_ & J).
    split; [cbn; now rewrite L|]. split; [|split].
    + intros q [<-|Iq]; [now split|]. destruct (O q Iq). split; [assumption|lia].
    + intros [|i] [|j] q q' Lt E E'; [lia| |lia|].
      * injection E as <-. cbn in E'. apply nth_error_In in E'. now apply O.
      * apply (In_ i j); auto. lia.
    + intros [|i] u E.
      * injection E as <-. rewrite Nat.add_0_r, Pos2Nat.id. now apply joins_row.
      * destruct (J i u E) as (e & R & Le). exists e. split; [assumption|].
        rewrite Le. f_equal. lia.
Qed.

Section Several.
Variables (first : site) (others : list site).
Hypothesis sites_are : line_sites c = first :: others.
Hypothesis some_others : others <> [].
Hypothesis unit_positive : 0 < r.
Hypothesis shaped_sites : Forall (well_shaped d) (line_sites c).
Hypothesis accepts : check_several pr c first others = Accepted.
Notation end_ := (last others first).
Notation X := (first :: end_ :: line_pads c).

Lemma last_in : In end_ others.
Proof.
  destruct (exists_last some_others) as (l & s & ->). rewrite last_last. apply in_or_app. right.
  now left.
Qed.
Lemma several_parts : forallb (shaped pr) (line_pads c) = true /\ right_length pr X = true /\
  proper pr X = true /\ steps pr c X 1 (along pr X first) others (line_order c) = Accepted /\
  each (check_joint c) 1 (line_rows c) = Accepted.
Proof.
  pose proof accepts as A. unfold check_several in A. cbv zeta in A. accepted. booleans. auto.
Qed.
Lemma several_steps : steps pr c X 1 (along pr X first) others (line_order c) = Accepted.
Proof. apply several_parts. Qed.
Lemma several_framed : exists t : frame d, framed orient pr r X t.
Proof.
  destruct several_parts as (Pa & Le & Pr & _). unfold right_length in Le.
  rewrite (dimension_d (M r unit_positive)) in Le. apply has_length_length in Le.
  apply (proper_framed (M r unit_positive)); auto.
  rewrite Forall_forall in *. intros s [<-|[<-|I]].
  - apply shaped_sites. rewrite sites_are. now left.
  - apply shaped_sites. rewrite sites_are. right. apply last_in.
  - rewrite forallb_forall in Pa. specialize (Pa s I). unfold shaped in Pa. apply Nat.eqb_eq in Pa.
    now rewrite (dimension_d (M r unit_positive)) in Pa.
Qed.

Section Framed.
Variable t : frame d.
Hypothesis F : framed orient pr r X t.
Let start := place first.
Let finish := place end_.
Notation x := (bary t 1).

Lemma dimension_one : (1 <= d)%nat.
Proof. pose proof (framed_length X t F) as L. cbn in L. lia. Qed.
Lemma shaped_site s : In s (line_sites c) -> well_shaped d s.
Proof. rewrite Forall_forall in shaped_sites. apply shaped_sites. Qed.
Lemma along_bary s : well_shaped d s -> IZR (along pr X s) =
  IZR (orientation pr X) * IZR (orientation pr X) * x (place s).
Proof.
  intros Hs. unfold along.
  rewrite (coordinate_sign_bary (M r unit_positive) X t F s 1 1 dimension_one Hs eq_refl).
  rewrite (place_over_one (r := r)). ring.
Qed.
Lemma along_less s q : well_shaped d s -> well_shaped d q -> (along pr X s < along pr X q)%Z ->
  x (place s) < x (place q).
Proof.
  intros Hs Hq L. apply IZR_lt in L. rewrite !along_bary in L by assumption.
  pose proof (square_positive X t F). nra.
Qed.
Lemma vertex_start : vertex t 0 = start /\ vertex t 1 = finish.
Proof.
  split; [apply (framed_vertex X t F 0 first)|apply (framed_vertex X t F 1 end_)]; reflexivity.
Qed.
Lemma first_on_line s i : In s (line_sites c) -> (2 <= i <= d)%nat ->
  coordinate_sign pr X s 1 i = 0%Z.
Proof.
  intros I Hi. destruct (steps_spec _ _ _ _ _ several_steps) as (_ & O & _).
  rewrite sites_are in I. destruct I as [<-|I].
  - apply eq_IZR. rewrite (coordinate_sign_bary (M r unit_positive) X t F first 1 i);
      [|lia| |reflexivity].
    + rewrite (place_over_one (r := r)). change (place first) with start.
      rewrite <- (proj1 vertex_start), bary_other by lia. ring.
    + apply shaped_site. rewrite sites_are. now left.
  - destruct (O s I) as [Z _]. unfold on_line in Z. rewrite forallb_forall in Z.
    apply Z.eqb_eq, Z. rewrite (dimension_d (M r unit_positive)). apply in_seq. lia.
Qed.
Lemma zero_beyond p i : conv P p -> (2 <= i <= d)%nat -> bary t i p = 0.
Proof.
  intros C Hi. assert (Z : forall q, In q P -> bary t i q = 0).
  { intros q I. apply in_map_iff in I. destruct I as (s & <- & I).
    apply (sign_zero (M r unit_positive) X); [assumption|lia|now apply shaped_site|].
    now apply first_on_line. }
  pose proof (bary_affine t i ltac:(lia)) as A.
  pose proof (affine_conv (bary t i) P p A (fun q I => Req_le_sym _ _ (Z q I)) C).
  pose proof (affine_conv (fun q => - bary t i q) P p (affine_opp _ A)) as B.
  assert (0 <= - bary t i p); [|lra]. apply B; [|assumption]. intros q I. rewrite (Z q I). lra.
Qed.
Lemma mixed p : conv P p -> p = mix start finish (x p).
Proof.
  intros C. apply affine_separate. intros f A. rewrite (affine_mix f) by assumption.
  assert (Two : forall g, sum (Datatypes.S d) (fun i => bary t i p * g i) =
    bary t 0 p * g 0%nat + x p * g 1%nat).
  { intros g. unfold sum. replace (Datatypes.S d) with (2 + (d - 1))%nat
      by (pose proof dimension_one; lia).
    cbn [Nat.add seq sum_over]. rewrite (sum_zero (seq 2 (d - 1))); [ring|].
    intros i Hi. apply in_seq in Hi. rewrite zero_beyond by (assumption || lia). ring. }
  rewrite (interpolation t f p A), (Two (fun i => f (vertex t i))).
  assert (One : sum (Datatypes.S d) (fun i => bary t i p * 1) = 1).
  { transitivity (sum (Datatypes.S d) (fun i => bary t i p)); [|apply bary_sum].
    unfold sum. apply sum_ext. intros; ring. }
  rewrite (Two (fun _ => 1)) in One. destruct vertex_start as [-> ->].
  replace (bary t 0 p) with (1 - x p) by lra. ring.
Qed.

Lemma points_increase i j p q : (i < j)%nat -> nth_error P i = Some p -> nth_error P j = Some q ->
  x p < x q.
Proof.
  intros L Ep Eq. unfold line_points in *. rewrite nth_error_map in Ep, Eq.
  destruct (nth_error (line_sites c) i) as [s|] eqn:Es; [|discriminate]. injection Ep as <-.
  destruct (nth_error (line_sites c) j) as [u|] eqn:Eu; [|discriminate]. injection Eq as <-.
  apply along_less; [now apply shaped_site, (nth_error_In _ i)
    |now apply shaped_site, (nth_error_In _ j)|].
  destruct (steps_spec _ _ _ _ _ several_steps) as (_ & O & In_ & _).
  rewrite sites_are in Es, Eu. destruct i as [|i], j as [|j]; try lia; cbn in Es, Eu.
  - injection Es as <-. apply nth_error_In in Eu. now apply O.
  - apply (In_ i j); auto. lia.
Qed.

(** ** The simplices *)

Lemma pair_at k p q : neighbours P k p q -> let n := Pos.of_succ_nat k in
  nth (pred (Pos.to_nat n)) P origin = p /\ nth (pred (Pos.to_nat (Pos.succ n))) P origin = q.
Proof.
  intros [Ep Eq]. cbv zeta. rewrite SuccNat2Pos.id_succ, Pos2Nat.inj_succ, SuccNat2Pos.id_succ.
  cbn [pred]. split; now apply nth_error_nth.
Qed.
Lemma joint_accepted u e : row u = Some e -> exists k, lower_end e = Some k /\
  numbered (line_order c) k = Some u.
Proof.
  intros E. pose proof (each_accepted _ _ (proj2 (proj2 (proj2 (proj2 several_parts)))) u e E) as A.
  unfold check_joint in A. accepted. destruct (lower_end e) as [k|]; [|discriminate]. exists k.
  split; [reflexivity|]. rewrite table_find in Heqb.
  destruct (numbered (line_order c) k) as [v|]; [|discriminate]. cbn in Heqb. unfold id in Heqb.
  apply Pos.eqb_eq in Heqb. now subst v.
Qed.
Lemma points_length : length P = Datatypes.S (length (line_order c)).
Proof.
  destruct (steps_spec _ _ _ _ _ several_steps) as (L & _). unfold line_points.
  rewrite map_length, sites_are. cbn. now rewrite L.
Qed.
Lemma joint_neighbours u e : row u = Some e -> exists k p q, neighbours P k p q /\
  numbered (line_order c) (Pos.of_succ_nat k) = Some u /\
  let s := map (fun k => nth (pred (Pos.to_nat k)) P origin) e in s = [p; q] \/ s = [q; p].
Proof.
  intros E. destruct (joint_accepted u e E) as (n & L & O).
  assert (H : (Pos.to_nat n < length P)%nat).
  { rewrite points_length. assert (pred (Pos.to_nat n) < length (line_order c))%nat; [|lia].
    apply nth_error_Some. unfold numbered in O. congruence. }
  set (k := pred (Pos.to_nat n)). assert (En : n = Pos.of_succ_nat k) by (unfold k; lia).
  destruct (nth_error P k) as [p|] eqn:Ep; [|apply nth_error_None in Ep; lia].
  destruct (nth_error P (Datatypes.S k)) as [q|] eqn:Eq; [|apply nth_error_None in Eq; lia].
  assert (N : neighbours P k p q) by now split.
  exists k, p, q. split; [assumption|]. split; [now rewrite <- En|].
  destruct (pair_at k p q N) as [A B]. rewrite <- En in A, B. cbv zeta.
  apply lower_end_spec in L. destruct L as [->| ->]; cbn [map]; rewrite A, B; auto.
Qed.

Theorem several_delaunay : of_dimension 1 P /\ flat_delaunay_triangulation 1 P T.
Proof.
  split.
  - assert (D : of_dimension (pred (length [first; end_])) (map place (line_sites c))); [|exact D].
    apply (dimension_signs (M r unit_positive) [first; end_] (line_pads c) t).
    + exact F.
    + discriminate.
    + cbn. pose proof dimension_one. lia.
    + rewrite sites_are. intros s [<-|[<-|[]]]; [now left|right; apply last_in].
    + assumption.
    + intros s i I Hi. now apply first_on_line.
  - assert (Row : forall i s, nth_error T i = Some s -> exists e,
      row (Pos.of_succ_nat i) = Some e /\
      s = map (fun k => nth (pred (Pos.to_nat k)) P origin) e).
    { intros i s E. unfold line_simplices in E. rewrite nth_error_map in E. unfold numbered.
      rewrite SuccNat2Pos.id_succ. cbn [pred].
      destruct (nth_error (line_rows c) i) as [e|]; [|discriminate]. injection E as <-. eauto. }
    apply (line_delaunay P T x start finish).
    + apply bary_affine, dimension_one.
    + apply mixed.
    + apply points_increase.
    + rewrite points_length. destruct (steps_spec _ _ _ _ _ several_steps) as (L & _).
      rewrite L. destruct others; [contradiction|cbn; lia].
    + intros s I. apply In_nth_error in I. destruct I as (i & E).
      destruct (Row i s E) as (e & R & ->).
      destruct (joint_neighbours _ e R) as (k & p & q & N & _ & J). eauto.
    + intros k p q N.
      assert (H : (k < length (line_order c))%nat).
      { destruct N as [_ Q].
        assert (Datatypes.S k < length P)%nat by (apply nth_error_Some; congruence).
        rewrite points_length in H. lia. }
      destruct (nth_error (line_order c) k) as [u|] eqn:Eu; [|apply nth_error_None in Eu; lia].
      destruct (steps_spec _ _ _ _ _ several_steps) as (_ & _ & _ & J).
      destruct (J k u Eu) as (e & R & Le).
      exists (map (fun k => nth (pred (Pos.to_nat k)) P origin) e). split.
      * apply (in_map (map (fun k => nth (pred (Pos.to_nat k)) P origin))).
        now apply numbered_in with u.
      * replace (Pos.of_nat (Pos.to_nat 1 + k)) with (Pos.of_succ_nat k) in Le by lia.
        destruct (pair_at k p q N) as [A B]. apply lower_end_spec in Le.
        apply pair_same. destruct Le as [->| ->]; cbn [map]; rewrite A, B; auto.
    + intros i j s u k p q Es Eu N Ss Su.
      destruct (Row i s Es) as (e & R & ->). destruct (Row j u Eu) as (f & R' & ->).
      destruct (joint_neighbours _ e R) as (k1 & p1 & q1 & N1 & O1 & J1).
      destruct (joint_neighbours _ f R') as (k2 & p2 & q2 & N2 & O2 & J2).
      assert (Same : forall l v w s', neighbours P l v w -> s' = [v; w] \/ s' = [w; v] ->
        same s' [p; q] -> l = k).
      { intros l v w s' Nl E [Sm _]. apply pair_same in E.
        assert (Iv : In v [p; q]) by (apply Sm, E; now left).
        assert (Iw : In w [p; q]) by (apply Sm, E; right; now left).
        destruct Nl as [V W], N as [Vp Vq].
        assert (Once : forall a b y z, nth_error P a = Some y -> nth_error P b = Some z -> y = z ->
          a = b).
        { intros a b y z Ea Eb ->. destruct (Nat.lt_total a b) as [H|[H|H]]; [|assumption|];
            [pose proof (points_increase a b z z H Ea Eb)
            |pose proof (points_increase b a z z H Eb Ea)]; lra. }
        destruct Iv as [Iv|[Iv|[]]]; [now apply (Once l k v p)|].
        destruct Iw as [Iw|[Iw|[]]].
        - pose proof (Once _ _ _ _ V Vq (eq_sym Iv)).
          pose proof (Once _ _ _ _ W Vp (eq_sym Iw)). lia.
        - pose proof (Once _ _ _ _ V Vq (eq_sym Iv)).
          pose proof (Once _ _ _ _ W Vq (eq_sym Iw)). lia. }
      assert (k1 = k2) as <-
        by (rewrite (Same k1 p1 q1 _ N1 J1 Ss); symmetry; now apply (Same k2 p2 q2 _ N2 J2)).
      rewrite O1 in O2. injection O2 as O2. lia.
Qed.
End Framed.
End Several.

Theorem check_line_in_sound : check_line_in pr c = Accepted -> NoDup P /\
  exists k, (k <= 1)%nat /\ of_dimension k P /\ flat_delaunay_triangulation k P T.
Proof.
  intros H. unfold check_line_in in H.
  destruct ((0 <? line_numerator c)%Z && (0 <? line_denominator c)%Z) eqn:Sc; [|discriminate].
  destruct (forallb (shaped pr) (line_sites c)) eqn:Sh; [|discriminate].
  apply andb_prop in Sc. destruct Sc as [Pn Pd]. apply Z.ltb_lt, IZR_lt in Pn, Pd.
  assert (U : 0 < r) by (unfold line_unit; now apply Rdiv_lt_0_compat).
  assert (Ss : Forall (well_shaped d) (line_sites c)).
  { apply Forall_forall. intros s I. rewrite forallb_forall in Sh. specialize (Sh s I).
    unfold shaped in Sh. apply Nat.eqb_eq in Sh. now rewrite (dimension_d (M r U)) in Sh. }
  destruct (line_sites c) as [|first others] eqn:E; [discriminate|].
  destruct others as [|second others].
  - assert (R : line_rows c = [[1%positive]]).
    { revert H. destruct (line_rows c) as [|[|k [|? ?]] [|? ?]]; try discriminate.
      destruct (Pos.eqb_spec k 1) as [->|]; [reflexivity|discriminate]. }
    assert (EP : P = [place first]) by (unfold line_points; now rewrite E).
    assert (ET : T = [[place first]]) by (unfold line_simplices; now rewrite R, EP).
    rewrite EP, ET. split; [constructor; [intros []|constructor]|]. exists 0%nat.
    split; [lia|]. apply one_point.
  - rewrite <- E in Ss.
    assert (Ne : second :: others <> []) by discriminate.
    destruct (several_framed first (second :: others) E Ne U Ss H) as (t & F). split.
    + apply NoDup_nth_error. intros i j Hi Eq.
      destruct (nth_error P i) as [p|] eqn:Ep; [|apply nth_error_None in Ep; lia].
      symmetry in Eq. destruct (Nat.lt_total i j) as [L|[L|L]]; [|assumption|];
        [pose proof (points_increase first (second :: others) E U Ss H t F i j p p L Ep Eq)
        |pose proof (points_increase first (second :: others) E U Ss H t F j i p p L Eq Ep)]; lra.
    + exists 1%nat. split; [lia|].
      exact (several_delaunay first (second :: others) E Ne U Ss H t F).
Qed.
End Sound.

Theorem check_line_sound D c : check_line D c = Accepted ->
  let S := line_points (dimension_of D) c in
  NoDup S /\ exists k, (k <= 1)%nat /\ of_dimension k S /\
    flat_delaunay_triangulation k S (line_simplices (dimension_of D) c).
Proof.
  destruct D; [exact (check_line_in_sound measured_plane c)
              |exact (check_line_in_sound measured_space c)].
Qed.
