(** * What an accepted certificate of a convex hull says *)
From Coq Require Import Rbase Rfunctions Lra Lia List ZArith Bool Permutation.
From Circumspect Require Import HullChecker Numbering.
From Circumspect Require Import Definitions Domains Hulls Vectors Affine Frame Faces Orientation
  Integers Incidence Accepted Soundness PackedCheck Judged Cones.
Import ListNotations.
Open Scope R_scope.

Lemma none_taken (l : list positive) k : ~ In k l -> filter (fun v => negb (Pos.eqb v k)) l = l.
Proof.
  induction l as [|v l IH]; intros N; [reflexivity|]. cbn [filter].
  destruct (Pos.eqb_spec v k) as [->|_]; [destruct N; now left|]. cbn [negb]. f_equal. apply IH.
  intros I. apply N. now right.
Qed.
Lemma taken_out (l : list positive) k : NoDup l -> In k l ->
  Permutation l (k :: filter (fun v => negb (Pos.eqb v k)) l).
Proof.
  induction l as [|v l IH]; intros N I; [destruct I|]. inversion N as [|v' l' Out N']; subst.
  cbn [filter]. destruct (Pos.eqb_spec v k) as [->|Nv]; cbn [negb].
  - now rewrite none_taken.
  - destruct I as [E|I]; [contradiction|]. etransitivity; [apply perm_skip, (IH N' I)|].
    apply perm_swap.
Qed.

Section Lists.
Variables (d : nat) (c : certificate) (k : positive).
Notation S' := (points_of_certificate d c).
Notation T := (simplices_of_certificate d c).
Notation S := (points_below d c k).
Notation H := (facets_below d c k).
Notation o := (Definitions.spot d c k).

(** The summit stands between the others. *)
Lemma summit_out e : numbered (points c) k = Some e -> Permutation S' (o :: S).
Proof.
  intros E. rewrite (spot_numbered d c k e E). unfold numbered in E.
  destruct (nth_error_split _ _ E) as (l1 & l2 & El & L).
  unfold points_of_certificate, points_below. rewrite El, <- L.
  rewrite firstn_app, Nat.sub_diag, firstn_all, firstn_O, app_nil_r.
  replace (Pos.to_nat k) with (Datatypes.S (length l1)) by lia.
  replace (skipn (Datatypes.S (length l1)) (l1 ++ e :: l2)) with l2.
  - rewrite !map_app. cbn [map]. symmetry. apply Permutation_middle.
  - rewrite skipn_app, skipn_all2, Nat.sub_succ_l, Nat.sub_diag by lia. reflexivity.
Qed.

Lemma over_each : (forall t e, numbered (simplices c) t = Some e -> In k (corners e)) ->
  (forall t, In t T -> NoDup t) -> Forall2 (fun t f => Permutation t (o :: f)) T H.
Proof.
  intros Cones N. unfold simplices_of_certificate, facets_below in *.
  assert (G : forall e, In e (simplices c) -> In k (corners e) /\ NoDup (corners e)).
  { intros e I. split.
    - apply in_numbered in I. destruct I as (t & E). now apply (Cones t).
    - apply (NoDup_map_inv (Definitions.spot d c)). apply N. apply in_map_iff. eauto. }
  clear Cones N. induction (simplices c) as [|e l IH]; cbn [map]; constructor.
  - destruct (G e (or_introl eq_refl)) as [I N].
    exact (Permutation_map (Definitions.spot d c) (taken_out (corners e) k N I)).
  - apply IH. intros e' I. apply G. now right.
Qed.
End Lists.

Section Hull.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis Or : oriented orient.
Hypothesis Co : computes orient pr.
Variable c : certificate.
Hypothesis accepts : check_in pr c = Accepted.
Variables (k : positive) (X : list positive).
Notation S' := (points_of_certificate d c).
Notation S := (points_below d c k).
Notation o := (Definitions.spot d c k).
Let dim_d : dimension pr = d := computes_dimension _ _ Co.
Let r := unit_of c.

(** [summit-inside] *)
Lemma summit_frame p Y : Table.find k (points_of (mesh_of c)) = Some p ->
  find_all (points_of (mesh_of c)) X = Some Y -> length Y = Datatypes.S (dimension pr) ->
  (0 < orientation pr Y)%Z -> forallb (fun v => negb (Pos.eqb v k)) X = true ->
  forallb (fun i => (0 <? side pr i Y p 1)%Z) (seq 0 (Datatypes.S (dimension pr))) = true ->
  NoDup S' -> exists t : Frame.frame d, Frame.inside t o /\ incl (vertices t) S.
Proof.
  intros Fk FX L P Others Sides N.
  destruct (find_point_site (d := d) k p Fk) as (<- & e & E).
  destruct (find_all_sites (d := d) X Y FX) as [-> Known].
  pose proof (sites_shaped dim_d accepts X) as Sh.
  set (Y := map (site_at d c) X) in *.
  pose proof (computes_orientation _ _ Co r Y Sh) as O. apply IZR_lt in P.
  assert (Pr : 0 < r ^ d) by apply pow_lt, (unit_positive accepts).
  assert (Po : 0 < orient (map (place_of r) Y)) by (rewrite O; now apply Rmult_lt_0_compat).
  destruct (lists_exists Or _ (Rgt_not_eq _ _ Po)) as (t & Lt). exists t. split.
  - intros i Hi.
    rewrite forallb_forall in Sides. rewrite dim_d in Sides.
    specialize (Sides i (proj2 (in_seq_d i) Hi)). apply Z.ltb_lt, IZR_lt in Sides.
    rewrite dim_d in L.
    pose proof (computes_side _ _ Co r i Y (site_at d c k) 1 Sh L Hi (site_shaped dim_d accepts k)
      eq_refl) as Si.
    pose proof (frame_bary Or _ t i o Lt (Rgt_not_eq _ _ Po) Hi) as B.
    rewrite Rmult_1_l in Si. unfold Rdiv in Si. rewrite Rinv_1, Rmult_1_r in Si.
    pose proof (spot_site d c k e E) as Es. change (unit_of c) with r in Es.
    rewrite <- Es, <- B in Si.
    apply Rmult_lt_reg_r with (orient (map (place_of r) Y)); [assumption|].
    rewrite Rmult_0_l, Si. now apply Rmult_lt_0_compat.
  - intros v Iv. apply in_vertices in Iv. destruct Iv as (i & Hi & ->).
    destruct Lt as (_ & V). specialize (V i Hi). apply nth_error_In in V.
    unfold Y in V. rewrite map_map in V. apply in_map_iff in V. destruct V as (v & Ev & Iv).
    destruct (Known v Iv) as (e' & E'). pose proof (spot_site d c v e' E') as Ev'.
    change (unit_of c) with r in Ev'. rewrite <- Ev' in Ev.
    rewrite forallb_forall in Others. specialize (Others v Iv).
    apply negb_true_iff, Pos.eqb_neq in Others.
    assert (I : In (vertex t i) (o :: S)).
    { apply (Permutation_in _ (summit_out d c k e E)). rewrite <- Ev.
      now apply (spot_in d c v e'). }
    destruct I as [Eo|]; [exfalso|assumption]. apply Others.
    rewrite <- Ev in Eo. rewrite (spot_numbered d c k e E), (spot_numbered d c v e' E') in Eo.
    assert (Nth : pred (Pos.to_nat k) = pred (Pos.to_nat v)); [|lia].
    pose proof (map_nth_error (fun e => @place_of d (unit_of c) (position e)) _ _ E) as M.
    pose proof (map_nth_error (fun e => @place_of d (unit_of c) (position e)) _ _ E') as M'.
    rewrite NoDup_nth_error in N. apply N.
    + apply nth_error_Some. unfold points_of_certificate. now rewrite M.
    + unfold points_of_certificate. rewrite M, M'. now f_equal.
Qed.
End Hull.

Lemma filled D c : check D c = Accepted ->
  NoDup (points_of_certificate (dimension_of D) c) /\
  fills (points_of_certificate (dimension_of D) c) (simplices_of_certificate (dimension_of D) c).
Proof.
  intros A. destruct (check_sound D c A) as [N F]. split; [assumption|].
  destruct (claimed c); [apply F|apply F|]. destruct F as ((w & W) & F). apply (F w W).
Qed.

Theorem judge_hull_sound D p k X s : judge_hull D p k X s = Holds ->
  let c := unpacked D p in
  let S := points_below (dimension_of D) c k in
  NoDup S /\ spans S /\ boundary_of_hull S (facets_below (dimension_of D) c k).
Proof.
  intros A. cbv zeta. unfold judge_hull in A.
  destruct (judge D p None s) eqn:J; try discriminate.
  destruct (judge_holds D p None s J) as [Ac _]. clear J.
  unfold check_cones in A.
  destruct (summit_is_inside D p k X) eqn:In_; [|discriminate].
  destruct (each_row D p _) eqn:Rows; [|discriminate]. clear A.
  rewrite each_row_is in Rows.
  assert (Cones : forall t e, numbered (simplices (unpacked D p)) t = Some e -> In k (corners e)).
  { intros t e E. apply (each_accepted _ _ Rows) in E.
    destruct (is_cone k e) eqn:C; [|discriminate].
    apply existsb_exists in C. destruct C as (v & I & Ev). apply Pos.eqb_eq in Ev. now subst. }
  destruct (filled D _ Ac) as [N F].
  assert (G : forall orient, @oriented (dimension_of D) orient ->
    computes orient (predicates_of D) -> exists e (t : Frame.frame (dimension_of D)),
    numbered (points (unpacked D p)) k = Some e /\
    Frame.inside t (Definitions.spot (dimension_of D) (unpacked D p) k) /\
    incl (vertices t) (points_below (dimension_of D) (unpacked D p) k)).
  { intros orient Or Co. unfold summit_is_inside in In_. cbv zeta in In_.
    change (Table.of_list (site_of (claimed (frame p))) (points (frame p)))
      with (points_of (mesh_of (unpacked D p))) in In_.
    destruct (Table.find k _) as [q|] eqn:Fk; [|discriminate].
    destruct (find_all _ X) as [Y|] eqn:FX; [|discriminate]. booleans. apply Z.ltb_lt in H2.
    destruct (@find_point_site (dimension_of D) (unpacked D p) k q Fk) as (_ & e & E).
    destruct (summit_frame Or Co _ Ac k X q Y Fk FX ltac:(assumption) ltac:(assumption)
      ltac:(assumption) ltac:(assumption) N) as (t & I & V).
    exists e, t. auto. }
  assert (G' : exists e (t : Frame.frame (dimension_of D)),
    numbered (points (unpacked D p)) k = Some e /\
    Frame.inside t (Definitions.spot (dimension_of D) (unpacked D p) k) /\
    incl (vertices t) (points_below (dimension_of D) (unpacked D p) k)).
  { destruct D; [apply (G _ oriented2 plane_computes)|apply (G _ oriented3 space_computes)]. }
  clear G. destruct G' as (e & t & E & I & V).
  pose proof (summit_out (dimension_of D) (unpacked D p) k e E) as P. split; [|split].
  - apply (Permutation_NoDup P) in N. now inversion N.
  - exists (vertices t). split; [assumption|]. split; [apply vertices_length|].
    apply vertices_independent.
  - apply (cones_over_boundary _ (points_of_certificate (dimension_of D) (unpacked D p))
      (Definitions.spot (dimension_of D) (unpacked D p) k) _ _ t F).
    + intros q. split; intros Iq.
      * apply (Permutation_in q P) in Iq. destruct Iq as [<-|Iq]; auto.
      * apply (Permutation_in q (Permutation_sym P)). destruct Iq as [->|Iq]; [now left|now right].
    + apply over_each; [assumption|]. intros s' Is. now apply F.
    + assumption.
    + assumption.
Qed.
