(** * Where the verdict is that it holds, the checker accepts

    So everything that is proved of accepted certificates holds ([judge_holds]). *)
From Coq Require Import ZArith List Bool Lia.
From Circumspect Require Import Numbering Accepted Integers.
From Circumspect Require Import Judge Quick QuickPlane Estimates Rounded QuickSound.
From Circumspect Require Import QuickTetrahedron QuickTriangle.
From Circumspect Require Import Word.
Import ListNotations.
Open Scope Z_scope.

Lemma is_accepted_spec r : is_accepted r = true -> r = Accepted.
Proof. now destruct r. Qed.
Lemma each_weaker {A} (f g : positive -> A -> result) (l : list A) :
  (forall k a, f k a = Accepted -> g k a = Accepted) ->
  forall k, each f k l = Accepted -> each g k l = Accepted.
Proof.
  intros H. induction l as [|a l IH]; intros k E; cbn [each] in *; [reflexivity|].
  destruct (f k a) eqn:Fa; [|discriminate]. rewrite (H k a Fa). now apply IH.
Qed.


Section Judged.
Variables (D : plane_or_space) (p : packed) (asked : option standing) (s : Word.t).
Notation c := (frame p).
Notation pr := (predicates_of D).
Notation m := (packed_mesh D p).
Notation rows := (rows_of p).

(** What [words_suffice] says, besides [within_words]. *)
Record sufficient : Prop := {
  delaunay_where_asked : forall st, asked = Some st -> delaunay_of (claimed c) = true;
  is_scaled : scaled c = true;
  points_pass : check_points pr (points c) = Accepted;
  sample_fits : forallb (fits s) (coordinates (sample c)) = true;
  same_denominator : shifted zero (sample_denominator c) = sample_denominator c;
  small_denominator : sample_denominator c <= 8
}.
Lemma shaped_points l : check_points pr l = Accepted ->
  Forall (fun e => well_shaped (dimension pr) (position e)) l.
Proof.
  destruct l as [|e l]; [constructor|]. cbn [check_points].
  destruct (shaped pr (position e)) eqn:Se; [|discriminate]. intros H.
  constructor; [now apply Nat.eqb_eq|].
  destruct D; apply (@increase_spec _ _ eq_refl) in H; destruct H as [H _];
    (eapply Forall_impl; [|exact H]); cbn; tauto.
Qed.
Lemma words_suffice_spec : words_suffice D p asked s = true -> within_words D p s /\ sufficient.
Proof.
  intros H. unfold words_suffice in H. ands.
  match goal with A : is_accepted (check_points _ _) = true |- _ => apply is_accepted_spec in A end.
  repeat match goal with A : leb _ _ = true |- _ => apply leb_le' in A end. rewrite many_is in *.
  match goal with A : negb _ = true |- _ => apply negb_true_iff in A end.
  assert (W : shifted zero (sample_denominator c) = sample_denominator c)
    by (unfold shifted; match goal with A : fits zero _ = true |- _ => rewrite A end;
      apply Z.shiftr_0_r).
  split; constructor; try assumption.
  - now apply shaped_points.
  - now intros st ->.
  - unfold eight in *. lia.
Qed.

Section Each.
Variables (simplex : positive -> bool) (hull_facet : positive -> hull_entry -> bool).
Hypotheses (in_words : within_words D p s) (enough : sufficient).
Hypothesis simplex_right : inside_sample pr m = true -> forall t, Zpos t <= simplex_count p ->
  simplex t = true -> check_simplex pr m t (entry_of D rows t) = Accepted /\
  (delaunay_claimed m = true -> forall st, asked = Some st ->
    settled_simplex pr m st t (entry_of D rows t) = true).
Hypothesis hull_facet_right : forall h f, hull_facet h f = true -> check_hull pr m h f = Accepted.

Lemma points_settled st : forall l k, each (check_point pr m) k l = Accepted ->
  all_settled (settled_point pr m st) AtPoint k l = Settled.
Proof.
  induction l as [|e l IH]; intros k E; cbn [each all_settled] in *; [reflexivity|].
  destruct (check_point pr m k e) eqn:Ck; [|discriminate]. unfold check_point in Ck.
  destruct (used pr m k e) eqn:Us; [|discriminate]. unfold used in Us. unfold settled_point.
  destruct (Table.find (home e) (simplices_of m)); [|discriminate].
  destruct (home_vertex e); [now apply IH|].
  change (weights_claimed m) with (weights_of (claimed c)) in Us.
  now rewrite (unweighted _ _ _ in_words) in Us.
Qed.

Lemma each_quickly_sound : each_quickly D p asked m simplex hull_facet = true ->
  check D (unpacked D p) = Accepted /\
  forall st, asked = Some st -> settle D (unpacked D p) st = Settled.
Proof.
  intros H. unfold each_quickly in H. apply andb_prop in H. destruct H as [H Hull].
  apply andb_prop in H. destruct H as [H Simplices].
  apply andb_prop in H. destruct H as [Points In_].
  apply is_accepted_spec in Points, Hull.
  assert (Ep : each (check_point pr m) 1 (points c) = Accepted).
  { revert Points. apply each_weaker. intros k e E.
    destruct (quick_used D (simplex_count p) rows k e) eqn:Q; [|exact E].
    now apply (used_quickly D p). }
  assert (Eh : each (check_hull pr m) 1 (hull c) = Accepted).
  { revert Hull. apply each_weaker. intros h f E. destruct (hull_facet h f) eqn:Q; [|exact E].
    now apply hull_facet_right. }
  assert (Each : forall t, Zpos t <= simplex_count p ->
    check_simplex pr m t (entry_of D rows t) = Accepted /\
    forall st, asked = Some st -> settled_simplex pr m st t (entry_of D rows t) = true).
  { intros t Ht. unfold all in Simplices. rewrite forallb_forall in Simplices.
    specialize (Simplices t (proj2 (upto_spec _ _) Ht)). cbv zeta in Simplices.
    apply orb_prop in Simplices. destruct Simplices as [Q|Q].
    - destruct (simplex_right In_ t Ht Q) as [A S]. split; [exact A|]. intros st E.
      apply S; [exact (delaunay_where_asked enough st E)|exact E].
    - apply andb_prop in Q. destruct Q as [A S]. split; [now apply is_accepted_spec|].
      intros st E. unfold settled_as in S. now rewrite E in S. }
  split.
  - change (check D (unpacked D p)) with (check_in pr (unpacked D p)). unfold check_in.
    cbv zeta. rewrite <- packed_mesh_is.
    change (scaled (unpacked D p)) with (scaled c). rewrite (is_scaled enough).
    change (points (unpacked D p)) with (points c). rewrite (points_pass enough), Ep, In_.
    change (hull (unpacked D p)) with (hull c). rewrite Eh.
    change (simplices (unpacked D p)) with (map (entry_of D rows) (upto (simplex_count p))).
    rewrite each_upto; [reflexivity|]. intros t Ht. now apply Each.
  - intros st E. change (settle D (unpacked D p) st) with (settle_in pr (unpacked D p) st).
    unfold settle_in. cbv zeta. rewrite <- packed_mesh_is.
    change (claimed (unpacked D p)) with (claimed c). rewrite (delaunay_where_asked enough st E).
    change (simplices (unpacked D p)) with (map (entry_of D rows) (upto (simplex_count p))).
    rewrite settled_upto by (intros t Ht; now apply Each).
    change (points (unpacked D p)) with (points c). now apply points_settled.
Qed.
End Each.
End Judged.

(** The sample point has as many coordinates as others. *)
Lemma sample_shaped D p : inside_sample (predicates_of D) (packed_mesh D p) = true ->
  length (coordinates (sample (frame p))) = dimension (predicates_of D) /\
  0 < sample_denominator (frame p).
Proof.
  intros H. unfold inside_sample in H. ands. split; [now apply Nat.eqb_eq|now apply Z.ltb_lt].
Qed.
Lemma fitting s x : fits s x = true -> shifted s x = Z.shiftr x s.
Proof. intros F. unfold shifted. now rewrite F. Qed.

Theorem quick_sound D p asked s : quick D p asked s = true ->
  check D (unpacked D p) = Accepted /\
  forall st, asked = Some st -> settle D (unpacked D p) st = Settled.
Proof.
  intros H. unfold quick in H. apply andb_prop in H. destruct H as [Words H]. cbv zeta in H.
  destruct (words_suffice_spec D p asked s Words) as [In_words En].
  rewrite (same_denominator _ _ _ _ En) in H.
  pose proof (sample_fits _ _ _ _ En) as Fs. pose proof (small_denominator _ _ _ _ En) as Sw.
  pose proof (sample_shaped D p) as Sh.
  destruct D; refine (each_quickly_sound _ p asked s _ _ In_words En _ _ H).
  - intros I t Ht Q. destruct (Sh I) as [L Pw].
    destruct (coordinates (sample (frame p))) as [|x [|y [|? ?]]] eqn:Co; try discriminate L.
    cbn [forallb] in Fs. ands. unfold step_of in Q. rewrite Co, !fitting in Q by assumption.
    eapply triangle_here; eauto.
  - discriminate.
  - intros I t Ht Q. destruct (Sh I) as [L Pw].
    destruct (coordinates (sample (frame p))) as [|x [|y [|z [|? ?]]]] eqn:Co; try discriminate L.
    cbn [forallb] in Fs. ands. unfold arrow_of in Q. rewrite Co, !fitting in Q by assumption.
    eapply simplex_here; eauto.
  - exact (hull_here p s In_words).
Qed.

Theorem judge_holds D p asked s : judge D p asked s = Holds ->
  check D (unpacked D p) = Accepted /\
  forall st, asked = Some st -> settle D (unpacked D p) st = Settled.
Proof.
  unfold judge. intros H. destruct (quick D p asked s) eqn:Q; [now apply quick_sound with s|].
  rewrite check_packed_is in H. destruct (check D (unpacked D p)); [|discriminate].
  split; [reflexivity|]. intros st ->.
  rewrite settle_packed_is in H. now destruct (settle D (unpacked D p) st).
Qed.
