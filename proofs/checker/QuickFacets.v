(** * Facets that the quick check of tetrahedra finds matched

    [rotated] and [reflected] say what [matched_facet] says. *)
From Coq Require Import ZArith List Bool Lia.
From Circumspect Require Import Numbering Accepted.
From Circumspect Require Import Quick Rounded QuickSound.
From Circumspect Require Import Word.
Import ListNotations.
Open Scope Z_scope.

Section Matched.
Variables (k0 k1 k2 v : positive).
Hypotheses (N01 : k0 <> k1) (N02 : k0 <> k2) (N12 : k1 <> k2) (V0 : v <> k0) (V1 : v <> k1)
  (V2 : v <> k2).

Ltac different x y := let E := fresh in
  assert (E : (x =? y)%positive = false) by (apply Pos.eqb_neq; congruence); rewrite E; clear E.
Ltac compare_all := cbn; repeat (match goal with
  | |- context [(?a =? ?a)%positive] => rewrite (Pos.eqb_refl a)
  | |- context [(?a =? ?b)%positive] => different a b
  end; cbn); try reflexivity.

Definition at_place (i : nat) (a : positive) (l : list positive) : list positive :=
  firstn i l ++ a :: skipn i l.
(** For each of the places, and each of the rotations, the lists are compared. *)
Ltac compare_each Hi Hj X E :=
  repeat match goal with H : (?i <= 3)%nat |- _ => do 4 (try destruct i as [|i]); try lia;
    clear H end;
  try discriminate X; clear X;
  destruct E as [(<- & <- & <-)|[(<- & <- & <-)|(<- & <- & <-)]]; unfold matched_facet, at_place;
    compare_all.

Lemma matched_odd i j l0 l1 l2 a : (i <= 3)%nat -> (j <= 3)%nat ->
  xorb (Nat.odd i) (Nat.odd j) = true ->
  (k0 = l0 /\ k1 = l1 /\ k2 = l2) \/ (k1 = l0 /\ k2 = l1 /\ k0 = l2) \/
    (k2 = l0 /\ k0 = l1 /\ k1 = l2) ->
  matched_facet (at_place i a [k0; k1; k2]) (at_place j v [l0; l1; l2]) i j = true.
Proof. intros Hi Hj X E. compare_each Hi Hj X E. Qed.
Lemma matched_even i j l0 l1 l2 a : (i <= 3)%nat -> (j <= 3)%nat ->
  xorb (Nat.odd i) (Nat.odd j) = false ->
  (k0 = l0 /\ k2 = l1 /\ k1 = l2) \/ (k2 = l0 /\ k1 = l1 /\ k0 = l2) \/
    (k1 = l0 /\ k0 = l1 /\ k2 = l2) ->
  matched_facet (at_place i a [k0; k1; k2]) (at_place j v [l0; l1; l2]) i j = true.
Proof. intros Hi Hj X E. compare_each Hi Hj X E. Qed.
End Matched.
Lemma rotated_spec k0 k1 k2 l0 l1 l2 : rotated k0 k1 k2 l0 l1 l2 = true ->
  (k0 = l0 /\ k1 = l1 /\ k2 = l2) \/ (k1 = l0 /\ k2 = l1 /\ k0 = l2) \/
    (k2 = l0 /\ k0 = l1 /\ k1 = l2).
Proof.
  unfold rotated. intros H. repeat (apply orb_prop in H; destruct H as [H|H]); ands;
    repeat match goal with H : eqb _ _ = true |- _ => apply eqb_eq' in H end; auto 6.
Qed.

(** The two simplices on both sides of a facet. *)
Lemma matched_across i j i_is_odd k0 k1 k2 l0 l1 l2 v a : 0 <= i <= 3 ->
  j = 0 \/ j = 1 \/ j = 2 \/ j = 3 -> i_is_odd = Nat.odd (Z.to_nat i) ->
  0 < k0 -> 0 < k1 -> 0 < k2 -> k0 <> k1 -> k0 <> k2 -> k1 <> k2 ->
  0 < v -> v <> k0 -> v <> k1 -> v <> k2 ->
  (if Bool.eqb i_is_odd (is_odd j) then reflected k0 k1 k2 l0 l1 l2
   else rotated k0 k1 k2 l0 l1 l2) = true ->
  matched_facet (at_place (Z.to_nat i) a [to_pos k0; to_pos k1; to_pos k2])
    (at_place (Z.to_nat j) (to_pos v) [to_pos l0; to_pos l1; to_pos l2]) (Z.to_nat i) (Z.to_nat j) =
    true.
Proof.
  intros Hi J Odd P0 P1 P2 N01 N02 N12 Pv V0 V1 V2 H.
  apply unlike_pos in N01, N02, N12, V0, V1, V2; try assumption.
  assert (Hi' : (Z.to_nat i <= 3)%nat) by lia. assert (Hj' : (Z.to_nat j <= 3)%nat) by lia.
  assert (Oj : is_odd j = Nat.odd (Z.to_nat j))
    by (clear - J; destruct J as [->|[->|[->| ->]]]; reflexivity).
  rewrite Odd, Oj in H.
  destruct (Bool.eqb (Nat.odd (Z.to_nat i)) (Nat.odd (Z.to_nat j))) eqn:Q.
  - apply (matched_even _ _ _ _ N01 N02 N12 V0 V1 V2 _ _ _ _ _ _ Hi' Hj');
      [clear - Q; destruct (Nat.odd (Z.to_nat i)), (Nat.odd (Z.to_nat j)); easy|].
    unfold reflected in H. apply rotated_spec in H.
    destruct H as [(-> & -> & ->)|[(-> & -> & ->)|(-> & -> & ->)]]; auto.
  - apply (matched_odd _ _ _ _ N01 N02 N12 V0 V1 V2 _ _ _ _ _ _ Hi' Hj');
      [clear - Q; destruct (Nat.odd (Z.to_nat i)), (Nat.odd (Z.to_nat j)); easy|].
    apply rotated_spec in H.
    destruct H as [(-> & -> & ->)|[(-> & -> & ->)|(-> & -> & ->)]]; auto.
Qed.
