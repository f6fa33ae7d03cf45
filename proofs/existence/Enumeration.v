(** * What the checker of impossibility enumerates: sets of vertices, their numbers, and clauses *)
From Coq Require Import List Arith Lia PArith Bool.
From Circumspect Require Import ImpossibleChecker Numbering Faces Lists.
From Circumspect Require Import Definitions.
Import ListNotations.

Lemma sublists_length n l k : In k (sublists_of n l) -> length k = n.
Proof.
  revert n k. induction l as [|x l IH]; intros [|n] k; cbn [sublists_of].
  - intros [<-|[]]. reflexivity.
  - intros [].
  - intros [<-|[]]. reflexivity.
  - intros I. apply in_app_or in I. destruct I as [I|I]; [|now apply IH].
    apply in_map_iff in I. destruct I as (k' & <- & I). cbn. f_equal. now apply IH.
Qed.
Lemma filter_sublist (f : positive -> bool) l :
  In (filter f l) (sublists_of (length (filter f l)) l).
Proof.
  induction l as [|x l IH]; [now left|]. cbn [filter]. destruct (f x).
  - cbn [length sublists_of]. apply in_or_app. left. now apply in_map.
  - destruct (filter f l) as [|y k] eqn:E; [now left|]. cbn [length sublists_of] in *.
    apply in_or_app. now right.
Qed.
Lemma some_sublist ks l : NoDup ks -> NoDup l -> incl ks l ->
  exists k, In k (sublists_of (length ks) l) /\
  forall x, In x k <-> In x ks.
Proof.
  intros Nk Nl I. set (f x := member x ks). exists (filter f l).
  assert (E : forall x, In x (filter f l) <-> In x ks).
  { intros x. rewrite filter_In. unfold f. rewrite member_in. split; [tauto|]. auto. }
  split; [|exact E]. replace (length ks) with (length (filter f l)); [apply filter_sublist|].
  apply Nat.le_antisymm; apply NoDup_incl_length; try assumption.
  - now apply NoDup_filter.
  - intros x X. now apply E.
  - intros x X. now apply E.
Qed.
Lemma numbered_from_numbers {A} (l : list A) : numbered_from 1 l = numbers l.
Proof.
  unfold numbers. change 1%positive with (Pos.of_succ_nat 0). generalize 0%nat.
  induction l as [|a l IH]; intros s; [reflexivity|]. cbn [numbered_from length seq map]. f_equal.
  apply (IH (S s)).
Qed.
Lemma all_beside_numbered candidates_of K X i l points : forall k,
  all_beside candidates_of K X i l k points = true ->
  forall j e, nth_error points j = Some e ->
    listed_beside candidates_of K X i l (Pos.of_succ_nat j + k - 1)%positive (bare e) = true.
Proof.
  induction points as [|x points IH]; intros k H j e E; [destruct j; discriminate|].
  cbn [all_beside] in H. apply andb_prop in H. destruct H as [H R]. destruct j as [|j]; cbn in E.
  - injection E as <-. replace (Pos.of_succ_nat 0 + k - 1)%positive with k by lia. exact H.
  - replace (Pos.of_succ_nat (S j) + k - 1)%positive
      with (Pos.of_succ_nat j + Pos.succ k - 1)%positive by lia. eauto.
Qed.
Lemma clauses_in D S sg pl po ca co fo l : forall k c,
  clauses_of D S sg pl po ca co fo k l = inl c ->
  forall x, In x c -> exists r, In r l /\ clause_of D S sg pl po ca co fo r = Some x.
Proof.
  induction l as [|r l IH]; intros k c H x I; cbn [clauses_of] in H.
  - injection H as <-. destruct I.
  - destruct (clause_of D S sg pl po ca co fo r) as [y|] eqn:E; [|discriminate].
    destruct (clauses_of D S sg pl po ca co fo (Pos.succ k) l) as [z|] eqn:F; [|discriminate].
    injection H as <-. destruct I as [<-|I]; [exists r; split; [now left|assumption]|].
    destruct (IH _ z F x I) as (s & Is & Es). exists s. split; [now right|assumption].
Qed.
Lemma same_dec {d} (s t : simplex d) : {same s t} + {~ same s t}.
Proof.
  assert (K : forall a b : simplex d, {incl a b} + {~ incl a b}).
  { intros a b. destruct (Forall_dec (fun v => In v b) (fun v => Faces.in_points v b) a) as [F|F].
    - left. intros v Hv. now apply (proj1 (Forall_forall _ _) F).
    - right. intros I. apply F, Forall_forall. exact I. }
  destruct (K s t), (K t s); (left; split; assumption) || (right; intros []; contradiction).
Qed.
