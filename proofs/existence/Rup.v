(** * Clauses, and proofs that nothing satisfies them

    A proof is a list of clauses, each with the numbers of earlier ones: if all of its literals are
    false, each of these in turn has at most one literal that is not, which then is true, until one
    has none (reverse unit propagation, E. Goldberg and Y. Novikov 2003).  So each clause follows
    from those before it, and at the end the empty one. *)
From Coq Require Import List Bool PArith FMapPositive.
From Circumspect Require Import DomainRules.
Import ListNotations.

Definition assignment := PositiveMap.t bool.
Definition known := PositiveMap.t clause.

Definition is_false (m : assignment) (l : literal) : bool :=
  match PositiveMap.find (snd l) m with Some b => negb (Bool.eqb b (fst l)) | None => false end.
Definition left_over (m : assignment) (c : clause) : clause :=
  filter (fun l => negb (is_false m l)) c.
Fixpoint propagates (K : known) (m : assignment) (hints : list positive) : bool :=
  match hints with
  | [] => false
  | h :: rest =>
      match PositiveMap.find h K with
      | None => false
      | Some c =>
          match left_over m c with
          | [] => true
          | [l] => propagates K (PositiveMap.add (snd l) (fst l) m) rest
          | _ => false
          end
      end
  end.
Definition negated (c : clause) : assignment :=
  fold_right (fun l m => PositiveMap.add (snd l) (negb (fst l)) m) (PositiveMap.empty bool) c.
(** [n] is the number of the next clause. *)
Fixpoint refuted_by (K : known) (n : positive) (proof : list proof_step) : bool :=
  match proof with
  | [] => false
  | s :: rest =>
      propagates K (negated (derived s)) (hints s) &&
      match derived s with
      | [] => true
      | _ => refuted_by (PositiveMap.add n (derived s) K) (Pos.succ n) rest
      end
  end.
Fixpoint listed_from (n : positive) (l : list clause) (K : known) : known * positive :=
  match l with
  | [] => (K, n)
  | c :: rest => listed_from (Pos.succ n) rest (PositiveMap.add n c K)
  end.
Definition refuted_clauses (l : list clause) (proof : list proof_step) : bool :=
  let (K, n) := listed_from 1 l (PositiveMap.empty clause) in refuted_by K n proof.

(** ** Soundness *)

Section Satisfied.
Variable truth : positive -> bool.
Definition is_true (l : literal) : Prop := truth (snd l) = fst l.
Definition satisfied (c : clause) : Prop := exists l, In l c /\ is_true l.
Definition all_satisfied (K : known) : Prop := forall h c, PositiveMap.find h K = Some c ->
  satisfied c.
Definition consistent (m : assignment) : Prop := forall x b, PositiveMap.find x m = Some b ->
  truth x = b.

Lemma consistent_add m x : consistent m -> consistent (PositiveMap.add x (truth x) m).
Proof.
  intros C y b H. destruct (Pos.eq_dec x y) as [<-|N].
  - rewrite PositiveMap.gss in H. congruence.
  - rewrite PositiveMap.gso in H by congruence. auto.
Qed.
Lemma propagates_sound K hints : forall m, all_satisfied K -> consistent m ->
  propagates K m hints = false.
Proof.
  induction hints as [|h rest IH]; intros m A C; [reflexivity|]. cbn [propagates].
  destruct (PositiveMap.find h K) as [c|] eqn:E; [|reflexivity].
  destruct (A h c E) as (l & I & Tl).
  assert (L : In l (left_over m c)).
  { unfold left_over. apply filter_In. split; [assumption|]. unfold is_false.
    destruct (PositiveMap.find (snd l) m) as [b|] eqn:F; [|reflexivity].
    rewrite negb_involutive. apply eqb_true_iff. rewrite <- (C _ _ F). exact Tl. }
  destruct (left_over m c) as [|x [|y r]]; [destruct L| |reflexivity].
  destruct L as [->|[]]. apply IH; [assumption|]. unfold is_true in Tl. rewrite <- Tl.
  now apply consistent_add.
Qed.
Lemma satisfied_dec c : satisfied c \/ forall l, In l c -> truth (snd l) = negb (fst l).
Proof.
  induction c as [|l c [S|N]].
  - right. intros l [].
  - left. destruct S as (x & I & Tx). exists x. split; [now right|assumption].
  - destruct (Bool.bool_dec (truth (snd l)) (fst l)) as [E|E].
    + left. exists l. split; [now left|exact E].
    + right. intros x [<-|I]; [|now apply N]. now destruct (truth (snd l)), (fst l).
Qed.
Lemma negated_consistent c : (forall l, In l c -> truth (snd l) = negb (fst l)) ->
  consistent (negated c).
Proof.
  induction c as [|l c IH]; intros N.
  - intros x b H. cbn in H. now rewrite PositiveMap.gempty in H.
  - change (consistent (PositiveMap.add (snd l) (negb (fst l)) (negated c))).
    rewrite <- (N l (or_introl eq_refl)). apply consistent_add, IH.
    intros x I. apply N. now right.
Qed.
Lemma refuted_by_sound proof : forall K n, all_satisfied K -> refuted_by K n proof = false.
Proof.
  induction proof as [|s rest IH]; intros K n A; [reflexivity|]. cbn [refuted_by].
  destruct (satisfied_dec (derived s)) as [S|N].
  - apply andb_false_intro2. destruct (derived s) as [|l c] eqn:E; [destruct S as (l & [] & _)|].
    apply IH. intros h x H. destruct (Pos.eq_dec n h) as [<-|Ne].
    + rewrite PositiveMap.gss in H. injection H as <-. assumption.
    + rewrite PositiveMap.gso in H by congruence. now apply (A h).
  - now rewrite (propagates_sound K (hints s) (negated (derived s)) A (negated_consistent _ N)).
Qed.
Lemma listed_satisfied l : forall n K, all_satisfied K -> (forall c, In c l -> satisfied c) ->
  all_satisfied (fst (listed_from n l K)).
Proof.
  induction l as [|c l IH]; intros n K A S; [assumption|]. cbn [listed_from].
  apply IH; [|intros; apply S; now right].
  intros h x H. destruct (Pos.eq_dec n h) as [<-|Ne].
  - rewrite PositiveMap.gss in H. injection H as <-. apply S. now left.
  - rewrite PositiveMap.gso in H by congruence. now apply (A h).
Qed.
End Satisfied.

Theorem refuted_clauses_sound l proof (truth : positive -> bool) : refuted_clauses l proof = true ->
  ~ forall c, In c l -> satisfied truth c.
Proof.
  unfold refuted_clauses. intros R S.
  pose proof (listed_satisfied truth l 1 (PositiveMap.empty clause)
    (fun h c H => match eq_ind None (fun o => match o with None => True | Some _ => False end) I _
       (eq_trans (eq_sym (PositiveMap.gempty clause h)) H) with end) S) as A.
  destruct (listed_from 1 l (PositiveMap.empty clause)) as [K n]. cbn [fst] in A.
  now rewrite (refuted_by_sound truth proof K n A) in R.
Qed.
