(** * Lists, numbered things and permutations, as the checker sees them

    Three small matters: things numbered from 1 are found where they stand in their list; [each]
    accepts only if it accepts every member; and a function of lists that changes its sign when
    two neighbouring members change places changes it under each odd permutation ([parity_sign]). *)
From Coq Require Import Rbase Rfunctions Lra ZArith List Bool Lia.
From Circumspect Require Import Checker.
Import ListNotations.

(** ** Numbered things *)

Lemma table_find {A B} (f : A -> B) (l : list A) k :
  Table.find k (Table.of_list f l) = option_map f (numbered l k).
Proof. apply nth_error_map. Qed.
Lemma find_id {A} (l : list A) k : Table.find k (Table.of_list id l) = numbered l k.
Proof. rewrite table_find. now destruct (numbered l k). Qed.

(** The numbers of the members. *)
Definition numbers {A} (l : list A) : list positive := map Pos.of_succ_nat (seq 0 (length l)).
Lemma in_numbers {A} (l : list A) k : In k (numbers l) <-> exists a, numbered l k = Some a.
Proof.
  unfold numbers, numbered. rewrite in_map_iff. split.
  - intros (i & <- & Hi). apply in_seq in Hi. rewrite SuccNat2Pos.id_succ. cbn.
    destruct (nth_error l i) eqn:E; [eauto|]. apply nth_error_None in E. lia.
  - intros (a & E). exists (pred (Pos.to_nat k)). split; [lia|]. apply in_seq.
    assert (nth_error l (pred (Pos.to_nat k)) <> None) by congruence.
    apply nth_error_Some in H. lia.
Qed.
Lemma numbers_NoDup {A} (l : list A) : NoDup (numbers l).
Proof.
  unfold numbers. generalize 0%nat at 1. induction (length l) as [|n IH]; intros s; cbn.
  - constructor.
  - constructor; [|apply IH]. rewrite in_map_iff. intros (i & E & Hi). apply in_seq in Hi. lia.
Qed.
Lemma map_numbers {A B} (l : list A) (f : A -> B) (g : positive -> B) :
  (forall k a, numbered l k = Some a -> g k = f a) -> map g (numbers l) = map f l.
Proof.
  unfold numbers. intros H. rewrite map_map.
  assert (G : forall l' s,
    (forall i a, nth_error l' i = Some a -> g (Pos.of_succ_nat (s + i)) = f a) ->
    map (fun i => g (Pos.of_succ_nat i)) (seq s (length l')) = map f l').
  { induction l' as [|a l' IH]; intros s E; cbn; [reflexivity|]. f_equal.
    - rewrite <- (E O a eq_refl). do 2 f_equal. lia.
    - apply IH. intros i b Hi. rewrite <- (E (S i) b Hi). do 2 f_equal. lia. }
  apply G. intros i a Hi. apply H. unfold numbered. rewrite SuccNat2Pos.id_succ. exact Hi.
Qed.
Lemma numbered_in {A} (l : list A) k a : numbered l k = Some a -> In a l.
Proof. apply nth_error_In. Qed.
Lemma in_numbered {A} (l : list A) a : In a l -> exists k, numbered l k = Some a.
Proof.
  intros I. apply In_nth_error in I. destruct I as (i & E). exists (Pos.of_succ_nat i).
  unfold numbered. now rewrite SuccNat2Pos.id_succ.
Qed.

(** ** What acceptance of a list is *)

Lemma each_accepted {A} (f : positive -> A -> result) l : each f 1 l = Accepted ->
  forall k a, numbered l k = Some a -> f k a = Accepted.
Proof.
  assert (G : forall l k0, each f k0 l = Accepted -> forall i a, nth_error l i = Some a ->
    f (Pos.of_succ_nat i + k0 - 1)%positive a = Accepted).
  { clear l. induction l as [|b l IH]; intros k0 E i a N; [destruct i; discriminate|].
    cbn in E. destruct (f k0 b) eqn:F; [|discriminate]. destruct i as [|i]; cbn in N.
    - injection N as <-. replace (Pos.of_succ_nat 0 + k0 - 1)%positive with k0 by lia. exact F.
    - replace (Pos.of_succ_nat (S i) + k0 - 1)%positive
        with (Pos.of_succ_nat i + Pos.succ k0 - 1)%positive by lia. eauto. }
  intros E k a N. rewrite <- (G l 1%positive E _ a N). f_equal. lia.
Qed.
Lemma each_index_accepted {A} (f : nat -> A -> result) l : each_index f 0 l = Accepted ->
  forall i a, nth_error l i = Some a -> f i a = Accepted.
Proof.
  assert (G : forall l k0, each_index f k0 l = Accepted -> forall i a, nth_error l i = Some a ->
    f (k0 + i)%nat a = Accepted).
  { clear l. induction l as [|b l IH]; intros k0 E i a N; [destruct i; discriminate|].
    cbn in E. destruct (f k0 b) eqn:F; [|discriminate]. destruct i as [|i]; cbn in N.
    - injection N as <-. now rewrite Nat.add_0_r.
    - rewrite Nat.add_succ_r. apply (IH (S k0)); assumption. }
  intros E i a N. exact (G l O E i a N).
Qed.

(** ** Replacing and removing members *)

Lemma replace_length {A} i (a : A) l : length (replace i a l) = length l.
Proof. revert i. induction l; intros [|i]; cbn; auto. Qed.
Lemma replace_same {A} i (a : A) l : (i < length l)%nat -> nth_error (replace i a l) i = Some a.
Proof. revert i. induction l; intros [|i] H; cbn in *; try lia; auto. apply IHl. lia. Qed.
Lemma replace_other {A} i k (a : A) l : k <> i -> nth_error (replace i a l) k = nth_error l k.
Proof. revert i k. induction l; intros [|i] [|k] H; cbn; auto; congruence. Qed.
Lemma replace_map {A B} (f : A -> B) i a l : map f (replace i a l) = replace i (f a) (map f l).
Proof. revert i. induction l; intros [|i]; cbn; congruence. Qed.
Lemma remove_map {A B} (f : A -> B) i l : map f (remove i l) = remove i (map f l).
Proof. revert i. induction l; intros [|i]; cbn; congruence. Qed.

(** Member a of what is left when member i is removed was member [skip i a]. *)
Definition skip (i a : nat) : nat := if (a <? i)%nat then a else S a.
Lemma skip_S i a : skip (S i) (S a) = S (skip i a).
Proof. unfold skip. change (S a <? S i)%nat with (a <? i)%nat. now destruct (a <? i)%nat. Qed.
Lemma skip_ne i a : skip i a <> i.
Proof. unfold skip. destruct (Nat.ltb_spec a i); lia. Qed.
Lemma skip_inj i a b : skip i a = skip i b -> a = b.
Proof. unfold skip. destruct (Nat.ltb_spec a i), (Nat.ltb_spec b i); lia. Qed.
Lemma skip_onto i k n : (k <= n)%nat -> (i <= n)%nat -> k <> i ->
  exists a, (a < n)%nat /\ skip i a = k.
Proof.
  intros. destruct (Nat.ltb_spec k i); [exists k|exists (pred k)]; split; try lia;
    unfold skip; [destruct (Nat.ltb_spec k i)|destruct (Nat.ltb_spec (pred k) i)]; lia.
Qed.
Lemma skip_le i a n : (a < n)%nat -> (skip i a <= n)%nat.
Proof. unfold skip. destruct (a <? i)%nat; lia. Qed.
Lemma remove_nth {A} i (l : list A) a : (i < length l)%nat ->
  nth_error (remove i l) a = nth_error l (skip i a).
Proof.
  revert i a. induction l as [|b l IH]; intros [|i] a H; cbn in *; try lia.
  - reflexivity.
  - destruct a as [|a]; [reflexivity|]. rewrite skip_S. cbn. apply IH. lia.
Qed.
Lemma remove_length {A} i (l : list A) : (i < length l)%nat ->
  length l = S (length (remove i l)).
Proof. revert i. induction l; intros [|i] H; cbn in *; try lia. rewrite <- IHl; lia. Qed.
Lemma remove_replace {A} i a (x : A) l : (i < length l)%nat ->
  remove i (replace (skip i a) x l) = replace a x (remove i l).
Proof.
  revert i a. induction l as [|b l IH]; intros [|i] a H; cbn in *; try lia.
  - reflexivity.
  - destruct a as [|a]; [reflexivity|]. rewrite skip_S. cbn. f_equal. apply IH. lia.
Qed.
Lemma replace_replace {A} i k (x y : A) l : i <> k ->
  replace i x (replace k y l) = replace k y (replace i x l).
Proof. revert i k. induction l; intros [|i] [|k] H; cbn; f_equal; auto; congruence. Qed.
Lemma remove_replace_same {A} i (x : A) l : remove i (replace i x l) = remove i l.
Proof. revert i. induction l; intros [|i]; cbn; f_equal; auto. Qed.

Lemma in_replace {A} i (a : A) l : (i < length l)%nat ->
  forall x, In x (replace i a l) <-> x = a \/ In x (remove i l).
Proof.
  revert i. induction l as [|b l IH]; intros [|i] H x; cbn in *; try lia.
  - intuition.
  - rewrite IH by lia. intuition.
Qed.

(** ** Permutations and signs *)

Lemma find_all_spec {A} (m : Table.t A) l X : find_all m l = Some X ->
  length X = length l /\ forall i k, nth_error l i = Some k -> Table.find k m = nth_error X i.
Proof.
  revert X. induction l as [|k l IH]; intros X E; cbn in E.
  - injection E as <-. split; [reflexivity|]. intros [|i] k; discriminate.
  - destruct (Table.find k m) as [a|] eqn:F; [|discriminate].
    destruct (find_all m l) as [r|]; [|discriminate]. injection E as <-.
    destruct (IH r eq_refl) as [L N]. split; [cbn; congruence|].
    intros [|i] j Hj; cbn in *; [congruence|]. now apply N.
Qed.

Lemma pull_in a l s r : pull a l = Some (s, r) -> forall x, In x l <-> x = a \/ In x r.
Proof.
  revert s r. induction l as [|b l IH]; intros s r E x; cbn in E; [discriminate|].
  destruct (Pos.eqb_spec a b) as [->|N].
  - injection E as <- <-. cbn. intuition.
  - destruct (pull a l) as [[s' r']|]; [|discriminate]. injection E as <- <-. cbn.
    rewrite (IH s' r' eq_refl). intuition.
Qed.
Lemma parity_in k l s : parity k l = Some s -> forall x, In x k <-> In x l.
Proof.
  revert l s. induction k as [|a k IH]; intros l s E x; cbn in E.
  - destruct l; [tauto|discriminate].
  - destruct (pull a l) as [[s1 l']|] eqn:P; [|discriminate].
    destruct (parity k l') as [s2|] eqn:Q; [|discriminate].
    rewrite (pull_in _ _ _ _ P x). cbn. rewrite (IH l' s2 Q). intuition.
Qed.

Open Scope R_scope.
Definition sign (s : bool) : R := if s then -1 else 1.
Lemma sign_negb s : sign (negb s) = - sign s.
Proof. destruct s; cbn; lra. Qed.
Lemma sign_xorb s s' : sign (xorb s s') = sign s * sign s'.
Proof. destruct s, s'; cbn; lra. Qed.
Lemma sign_square s : sign s * sign s = 1.
Proof. destruct s; cbn; lra. Qed.

(** [f] changes its sign when two neighbouring members change places. *)
Definition alternating {A} (f : list A -> R) : Prop :=
  forall X a b Y, f (X ++ a :: b :: Y) = - f (X ++ b :: a :: Y).

Lemma alternating_map {A B} (g : A -> B) f : alternating f -> alternating (fun l => f (map g l)).
Proof. intros Al X a b Y. rewrite !map_app. apply Al. Qed.
Lemma alternating_cons {A} (a : A) f : alternating f -> alternating (fun l => f (a :: l)).
Proof. intros Al X b c Y. apply (Al (a :: X)). Qed.

Lemma pull_sign (f : list positive -> R) : alternating f ->
  forall a l s r, pull a l = Some (s, r) -> forall X, f (X ++ l) = sign s * f (X ++ a :: r).
Proof.
  intros Al a l. induction l as [|b l IH]; intros s r E X; cbn in E; [discriminate|].
  destruct (Pos.eqb_spec a b) as [->|N].
  - injection E as <- <-. cbn. ring.
  - destruct (pull a l) as [[s' r']|]; [|discriminate]. injection E as <- <-.
    rewrite sign_negb.
    replace (X ++ b :: l) with ((X ++ [b]) ++ l) by now rewrite <- app_assoc.
    rewrite (IH s' r' eq_refl), <- app_assoc. cbn. rewrite Al. ring.
Qed.
Theorem parity_sign (f : list positive -> R) : alternating f ->
  forall k l s, parity k l = Some s -> f k = sign s * f l.
Proof.
  intros Al.
  assert (G : forall k l s, parity k l = Some s -> forall X, f (X ++ k) = sign s * f (X ++ l)).
  { induction k as [|a k IH]; intros l s E X; cbn in E.
    - destruct l; [|discriminate]. injection E as <-. cbn. ring.
    - destruct (pull a l) as [[s1 l']|] eqn:P; [|discriminate].
      destruct (parity k l') as [s2|] eqn:Q; [|discriminate]. injection E as <-.
      rewrite (pull_sign f Al _ _ _ _ P X), sign_xorb.
      replace (X ++ a :: k) with ((X ++ [a]) ++ k) by now rewrite <- app_assoc.
      rewrite (IH _ _ Q), <- app_assoc. cbn.
      transitivity (sign s1 * sign s1 * sign s2 * f (X ++ a :: l')).
      + rewrite sign_square. ring.
      + destruct s1, s2; cbn; ring. }
  intros k l s E. exact (G k l s E []).
Qed.

(** Member i comes to the front past i others. *)
Lemma front_sign {A} (f : list A -> R) : alternating f ->
  forall i l a, (i < length l)%nat ->
  f (replace i a l) = sign (Nat.odd i) * f (a :: remove i l).
Proof.
  intros Al.
  assert (G : forall i l a, (i < length l)%nat -> forall X,
    f (X ++ replace i a l) = sign (Nat.odd i) * f (X ++ a :: remove i l)).
  { induction i as [|i IH]; intros [|b l] a H X; cbn [length] in H; try lia.
    - cbn. ring.
    - cbn [replace remove].
      replace (X ++ b :: replace i a l) with ((X ++ [b]) ++ replace i a l)
        by now rewrite <- app_assoc.
      rewrite IH by lia. rewrite <- app_assoc. cbn [app].
      rewrite Al, Nat.odd_succ, <- Nat.negb_odd, sign_negb. ring. }
  intros i l a H. exact (G i l a H []).
Qed.
