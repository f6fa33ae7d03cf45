(** * Lists, as the checker of domains sees them: side by side, their members, what is left *)
From Coq Require Import List Arith Lia ZArith Bool.
From Circumspect Require Import DomainChecker Numbering.
Import ListNotations.

Lemma each_pair_accepted {A B} c at_ (f : positive -> A -> B -> result) l l' :
  each_pair c at_ f 1 l l' = Accepted -> length l = length l' /\
  forall k a b, numbered l k = Some a -> numbered l' k = Some b -> f k a b = Accepted.
Proof.
  assert (G : forall l l' k0, each_pair c at_ f k0 l l' = Accepted -> length l = length l' /\
    forall i a b, nth_error l i = Some a -> nth_error l' i = Some b ->
    f (Pos.of_succ_nat i + k0 - 1)%positive a b = Accepted).
  { clear. induction l as [|x l IH]; intros [|y l'] k0 E; cbn in E; try discriminate.
    { split; [reflexivity|]. intros [|i]; discriminate. }
    destruct (f k0 x y) eqn:F; [|discriminate]. destruct (IH l' _ E) as [L H].
    split; [cbn; congruence|].
    intros [|i] a b N N'; cbn in N, N'.
    - injection N as <-. injection N' as <-.
      replace (Pos.of_succ_nat 0 + k0 - 1)%positive with k0 by lia. exact F.
    - replace (Pos.of_succ_nat (S i) + k0 - 1)%positive
        with (Pos.of_succ_nat i + Pos.succ k0 - 1)%positive by lia. eauto. }
  intros E. destruct (G l l' 1%positive E) as [L H]. split; [assumption|].
  intros k a b N N'. rewrite <- (H _ a b N N'). f_equal. lia.
Qed.
Lemma numbered_beside {A B} (l : list A) (l' : list B) k a : length l = length l' ->
  numbered l k = Some a -> exists b, numbered l' k = Some b.
Proof.
  unfold numbered. intros L N. destruct (nth_error l' (pred (Pos.to_nat k))) as [b|] eqn:E;
    [eauto|].
  apply nth_error_None in E. assert (K : nth_error l (pred (Pos.to_nat k)) <> None) by congruence.
  apply nth_error_Some in K. lia.
Qed.
Lemma in_remove {A} i (l : list A) x :
  In x (Checker.remove i l) <-> exists k, k <> i /\ nth_error l k = Some x.
Proof.
  revert i. induction l as [|a l IH]; intros i.
  - destruct i; cbn; (split; [intros []|intros (k & _ & E); destruct k; discriminate]).
  - destruct i as [|i]; cbn [Checker.remove].
    + split.
      * intros I. apply In_nth_error in I. destruct I as (k & E). exists (S k). auto.
      * intros ([|k] & N & E); [congruence|]. cbn in E. now apply nth_error_In with k.
    + cbn [In]. rewrite IH. split.
      * intros [<-|(k & N & E)]; [exists 0%nat; auto|]. exists (S k). auto.
      * intros ([|k] & N & E); [left; cbn in E; congruence|]. right. exists k. auto.
Qed.
Lemma member_in k l : member k l = true <-> In k l.
Proof.
  unfold member. rewrite existsb_exists. split.
  - intros (x & I & E). apply Pos.eqb_eq in E. now subst.
  - intros I. exists k. split; [assumption|apply Pos.eqb_refl].
Qed.
Lemma same_members_spec k l : same_members k l = true -> forall x, In x k <-> In x l.
Proof.
  unfold same_members. intros H x. apply andb_prop in H. destruct H as [H K].
  rewrite forallb_forall in H, K. split; intros I; apply member_in; auto.
Qed.
Lemma finite_dec {A} (Q : A -> Prop) (l : list A) : (forall x, In x l -> Q x \/ ~ Q x) ->
  (exists x, In x l /\ Q x) \/ ~ exists x, In x l /\ Q x.
Proof.
  induction l as [|a l IH]; intros D; [right; intros (x & [] & _)|].
  destruct (D a (or_introl eq_refl)) as [Y|N]; [left; exists a; split; [now left|assumption]|].
  destruct IH as [(x & I & Y)|M]; [intros; apply D; now right| |].
  - left. exists x. split; [now right|assumption].
  - right. intros (x & [<-|I] & Y); [contradiction|]. apply M. eauto.
Qed.
Lemma flat_map_kept {A B C} (g : A -> C) (keep : B -> bool) (G : positive -> C) (K : positive ->
  bool)
    (l : list A) (l' : list B) : length l = length l' ->
  (forall k a, numbered l k = Some a -> G k = g a) ->
  (forall k b, numbered l' k = Some b -> K k = keep b) ->
  flat_map (fun ab => if keep (snd ab) then [g (fst ab)] else []) (combine l l') =
  map G (filter K (numbers l)).
Proof.
  unfold numbers. intros L HG HK.
  assert (X : forall l l' s, length l = length l' ->
    (forall i a, nth_error l i = Some a -> G (Pos.of_succ_nat (s + i)) = g a) ->
    (forall i b, nth_error l' i = Some b -> K (Pos.of_succ_nat (s + i)) = keep b) ->
    flat_map (fun ab => if keep (snd ab) then [g (fst ab)] else []) (combine l l') =
    map G (filter K (map Pos.of_succ_nat (seq s (length l))))).
  { clear. induction l as [|a l IH]; intros [|b l'] s L HG HK; try discriminate; [reflexivity|].
    cbn [combine flat_map length seq map filter fst snd].
    pose proof (HK 0%nat b eq_refl) as Kb. rewrite Nat.add_0_r in Kb. rewrite Kb.
    rewrite (IH l' (S s)); [|injection L as L; exact L| |].
    - destruct (keep b); [|reflexivity]. cbn [map app].
      pose proof (HG 0%nat a eq_refl) as Ga. rewrite Nat.add_0_r in Ga. now rewrite Ga.
    - intros i x E. rewrite <- (HG (S i) x E). do 2 f_equal. lia.
    - intros i x E. rewrite <- (HK (S i) x E). do 2 f_equal. lia. }
  apply X; [assumption| |]; intros i x E; [apply HG|apply HK]; unfold numbered;
    now rewrite SuccNat2Pos.id_succ.
Qed.
