(** * Where the quick check is content, the checker accepts

    So everything that is proved of accepted certificates holds ([judge_holds]). *)
From Coq Require Import ZArith List Bool Lia.
From Circumspect Require Import Numbering Accepted Integers.
From Circumspect Require Import Quick Estimates Rounded.
From Circumspect Require Import Word.
Import ListNotations.
Open Scope Z_scope.

(** ** The numbers from 1 on *)

Lemma upto_spec n k : In k (upto n) <-> Zpos k <= n.
Proof.
  unfold upto. rewrite in_map_iff. split.
  - intros (i & <- & I). apply in_seq in I. lia.
  - intros H. exists (pred (Pos.to_nat k)). split; [lia|]. apply in_seq. lia.
Qed.
Lemma find_tabulated {A} n (f : positive -> A) k : Zpos k <= n ->
  Table.find k (Table.tabulate n f) = Some (f k).
Proof.
  intros H. unfold Table.find, Table.tabulate, upto, numbered. rewrite map_map, nth_error_map.
  assert (L : (pred (Pos.to_nat k) < length (seq 0 (Z.to_nat n)))%nat) by (rewrite seq_length; lia).
  rewrite (nth_error_nth' _ O L), seq_nth by (rewrite seq_length in L; exact L). cbn [option_map].
  do 2 f_equal. lia.
Qed.
Lemma each_upto {A} (g : positive -> A) (f : positive -> A -> result) n :
  (forall t, Zpos t <= n -> f t (g t) = Accepted) -> each f 1 (map g (upto n)) = Accepted.
Proof.
  intros H. assert (G : forall t, In t (upto n) -> f t (g t) = Accepted) by (intros t I; apply H;
    now apply upto_spec).
  clear H. revert G. unfold upto. change 1%positive with (Pos.of_succ_nat 0). generalize O.
  induction (Z.to_nat n) as [|N IH]; intros k G; cbn [seq map each]; [reflexivity|].
  rewrite G by now left. apply (IH (S k)). intros t I. apply G. now right.
Qed.
Lemma settled_upto {A} (g : positive -> A) (f : positive -> A -> bool) at_ n :
  (forall t, Zpos t <= n -> f t (g t) = true) -> all_settled f at_ 1 (map g (upto n)) = Settled.
Proof.
  intros H. assert (G : forall t, In t (upto n) -> f t (g t) = true) by (intros t I; apply H;
    now apply upto_spec).
  clear H. revert G. unfold upto. change 1%positive with (Pos.of_succ_nat 0). generalize O.
  induction (Z.to_nat n) as [|N IH]; intros k G; cbn [seq map all_settled]; [reflexivity|].
  rewrite G by now left. apply (IH (S k)). intros t I. apply G. now right.
Qed.

(** ** Matched facets *)

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

(** Name what a [let] names, and take conjunctions apart. *)
Ltac parts A := lazymatch type of A with
  | _ && _ = true => let B := fresh "A" in apply andb_prop in A; destruct A as [B A]; parts B
  | _ => idtac
  end.
Ltac open_lets H := repeat (cbv beta in H; lazymatch type of H with
  | (let x := ?v in @?b x) = true => let y := fresh x in pose (y := v); change (b y = true) in H
  | _ && _ = true => let A := fresh "A" in apply andb_prop in H; destruct H as [A H]; parts A
  end).

(** What [quick] asks of the points and of how many simplices there are. *)
Record within_words (p : packed) (s : Word.t) : Prop := {
  unweighted : weights_of (claimed (frame p)) = false;
  shapes : Forall (fun e => well_shaped 3 (position e)) (points (frame p));
  all_fit : forallb (fun e => forallb (fits s) (coordinates (position e))) (points (frame p)) =
    true;
  few_points : count_of (points (frame p)) <= 288230376151711744;
  few_simplices : simplex_count p <= 288230376151711744
}.

Section Simplices.
Variables (p : packed) (s : Word.t) (asked : option standing).
Hypothesis in_words : within_words p s.
Notation c := (frame p).
Notation pr := space_predicates.
Notation m := (packed_mesh Space p).
Notation N := (count_of (points c)).
Notation rows := (rows_of p).
Notation places := (of_list (shifted s) (flat_map (fun e => coordinates (position e)) (points c))).

Lemma point_known v : known N v = true ->
  exists q, Table.find (to_pos v) (points_of m) = Some q /\ rounded s q (arrow_to places v).
Proof.
  apply (known_point s (points c) (shapes _ _ in_words) (all_fit _ _ in_words)
    (few_points _ _ in_words) _ _ (unweighted _ _ in_words)).
Qed.

Lemma entry_corners u : 0 < u < 2 ^ 62 -> let r := row_of Space u in
  corners (entry_of Space rows (to_pos u)) = [to_pos (get rows (add r zero));
    to_pos (get rows (add r one));
    to_pos (get rows (add r two)); to_pos (get rows (add r three))].
Proof. intros H r. unfold entry_of. rewrite (of_to_pos u H). reflexivity. Qed.
Lemma entry_walls u : 0 < u < 2 ^ 62 -> let r := row_of Space u in
  walls (entry_of Space rows (to_pos u)) = [wall_of (get rows (add r four));
    wall_of (get rows (add r five));
    wall_of (get rows (add r six)); wall_of (get rows (add r seven))].
Proof. intros H r. unfold entry_of. rewrite (of_to_pos u H). reflexivity. Qed.

Lemma wall_back t i : Zpos t <= 288230376151711744 -> 0 <= i <= 3 ->
  wall_of (add (mul eight (of_pos t)) i) = Neighbour t (Z.to_nat i).
Proof.
  intros Ht Hi. unfold of_pos. rewrite wrap_small by lia.
  rewrite (mul_small eight (Zpos t) (8 * Zpos t)) by (unfold eight; lia).
  rewrite (add_small (8 * Zpos t) i (8 * Zpos t + i) eq_refl) by lia.
  unfold wall_of. assert (G : ltb (8 * Zpos t + i) zero = false) by (apply Z.ltb_ge; unfold zero;
    lia). rewrite G.
  assert (D : down (8 * Zpos t + i) three = Zpos t).
  { change (down (8 * Zpos t + i) three) with ((8 * Zpos t + i) / 8). symmetry.
    apply (Z.div_unique _ _ _ i); lia. }
  rewrite D. rewrite (mul_small eight (Zpos t) (8 * Zpos t)) by (unfold eight; lia).
  rewrite (sub_small _ (8 * Zpos t) i) by lia. reflexivity.
Qed.

Lemma small_sums : add zero one = 1 /\ add one one = 2 /\ add two one = 3 /\
  add four 0 = five - 1 /\ add four 1 = five /\ add four 2 = six /\ add four 3 = seven.
Proof.
  unfold add, zero, one, two, four, five, six, seven. rewrite !wrap_small by lia. repeat split.
Qed.

Lemma unlike x y : negb (eqb x y) = true -> x <> y.
Proof. intros H E. apply negb_true_iff in H. apply Z.eqb_neq in H. contradiction. Qed.
Lemma unlike_pos x y : 0 < x -> 0 < y -> x <> y -> to_pos x <> to_pos y.
Proof.
  intros Hx Hy NE E. apply NE. unfold to_pos in E. apply (f_equal Zpos) in E.
  rewrite !Z2Pos.id in E by lia. exact E.
Qed.

Lemma quick_wall_sound t i i_is_odd k0 k1 k2 x apex_ok K X n a :
  Zpos t <= simplex_count p -> 0 <= i <= 3 -> i_is_odd = Nat.odd (Z.to_nat i) ->
  0 < k0 -> 0 < k1 -> 0 < k2 -> k0 <> k1 -> k0 <> k2 -> k1 <> k2 ->
  K = at_place (Z.to_nat i) a [to_pos k0; to_pos k1; to_pos k2] ->
  - 2 ^ 62 <= x < 2 ^ 62 ->
  (forall u v q, apex_ok u v = true -> Table.find (to_pos v) (points_of m) = Some q ->
     rounded s q (arrow_to places v) -> delaunay_claimed m = true -> Pos.ltb t (to_pos u) = true ->
     depth pr X n q <= 0 /\ forall st, asked = Some st ->
       settled pr st K X n (to_pos v) q = true) ->
  quick_wall m (simplex_count p) N rows t i i_is_odd k0 k1 k2 x apex_ok = true ->
  check_wall pr m t K X n (Z.to_nat i) (wall_of x) = Accepted /\
  (delaunay_claimed m = true -> forall st, asked = Some st ->
    settled_wall pr m st t K X n (wall_of x) = true).
Proof.
  intros Ht Hi Odd P0 P1 P2 N01 N02 N12 -> Rx Deep H. cbv delta [quick_wall] in H. cbv beta in H.
  unfold wall_of.
  destruct (ltb x zero) eqn:Lx.
  { unfold check_wall. change (index i) with (Z.to_nat i) in H. rewrite H. split; reflexivity. }
  open_lets H.
  assert (K1 : known (simplex_count p) u = true) by assumption.
  assert (K2 : leb j three = true) by assumption.
  assert (K3 : eqb (get rows (add r (add four j))) (add (mul eight (of_pos t)) i) = true)
    by assumption.
  assert (K4 : known N v = true) by assumption.
  assert (K5 : negb (eqb v k0) = true) by assumption.
  assert (K6 : negb (eqb v k1) = true) by assumption.
  assert (K7 : negb (eqb v k2) = true) by assumption.
  assert (K8 : (if Bool.eqb i_is_odd (is_odd j) then reflected k0 k1 k2 l0 l1 l2 else
    rotated k0 k1 k2 l0 l1 l2) = true)
    by assumption.
  apply known_spec in K1. apply leb_le' in K2. apply eqb_eq' in K3.
  pose proof (known_spec _ _ K4) as Bv.
  apply unlike in K5, K6, K7.
  assert (X0' : 0 <= x) by (apply Z.ltb_ge in Lx; exact Lx).
  assert (Eu : u = x / 8) by reflexivity.
  assert (Bu : 0 <= x / 8 <= x) by (split; [apply Z.div_pos; lia|apply Z.div_le_upper_bound; lia]).
  assert (Ej : j = x mod 8).
  { unfold j. rewrite (mul_small eight u (8 * u)) by (unfold eight; pose proof (Z.mul_div_le x 8);
      lia).
    rewrite (sub_small x (8 * u) (x mod 8)) by (pose proof (Z.div_mod x 8);
      pose proof (Z.mod_pos_bound x 8); lia).
    reflexivity. }
  assert (Bj : 0 <= j <= 3) by (pose proof (Z.mod_pos_bound x 8); unfold three in K2; lia).
  assert (Ru : 0 < u < 2 ^ 62) by lia.
  fold u j. clearbody u j. clear Eu Ej Bu.
  assert (F : Table.find (to_pos u) (simplices_of m) = Some (entry_of Space rows (to_pos u))).
  { apply find_tabulated. unfold to_pos. clear - K1. rewrite Z2Pos.id by lia. lia. }
  pose proof (entry_corners u Ru) as Co. pose proof (entry_walls u Ru) as Wa. cbv zeta in Co, Wa.
  fold r in Co, Wa.
  destruct (point_known v) as (q & Fq & Rq); [assumption|].
  assert (D01 := unlike_pos _ _ P0 P1 N01). assert (D02 := unlike_pos _ _ P0 P2 N02).
  assert (D12 := unlike_pos _ _ P1 P2 N12).
  assert (Pv : 0 < v) by (clear - Bv; lia).
  assert (V0 := unlike_pos _ _ Pv P0 K5). assert (V1 := unlike_pos _ _ Pv P1 K6).
  assert (V2 := unlike_pos _ _ Pv P2 K7).
  assert (Hi' : (Z.to_nat i <= 3)%nat) by (clear - Hi; lia).
  assert (Hj' : (Z.to_nat j <= 3)%nat) by (clear - Bj; lia).
  assert (J : j = 0 \/ j = 1 \/ j = 2 \/ j = 3) by (clear - Bj; lia).
  pose proof (wall_back t i (Z.le_trans _ _ _ Ht (few_simplices _ _ in_words)) Hi) as Wb.
  pose proof small_sums as (S0 & S1 & S2 & S3 & S4 & S5 & S6). change (five - 1) with four in S3.
  assert (B : nth_error (walls (entry_of Space rows (to_pos u))) (Z.to_nat j) = Some
    (Neighbour t (Z.to_nat i)) /\
    corners (entry_of Space rows (to_pos u)) = at_place (Z.to_nat j) (to_pos v) [to_pos l0;
      to_pos l1; to_pos l2]).
  { rewrite Wa, Co. unfold v, l0, l1, l2, other_corner. rewrite <- Wb. rewrite <- K3.
    clear - J S0 S1 S2 S3 S4 S5 S6.
    destruct J as [->|[->|[->| ->]]];
    cbn [leb Z.leb zero one two three Z.compare Pos.compare Pos.compare_cont];
    rewrite ?S0, ?S1, ?S2, ?S3, ?S4, ?S5, ?S6; split; reflexivity. }
  destruct B as [Bw Bc].
  assert (Mf : matched_facet (at_place (Z.to_nat i) a [to_pos k0; to_pos k1; to_pos k2])
    (corners (entry_of Space rows (to_pos u))) (Z.to_nat i) (Z.to_nat j) = true).
  { rewrite Bc.
    assert (Oj : is_odd j = Nat.odd (Z.to_nat j))
      by (clear - J; destruct J as [->|[->|[->| ->]]]; reflexivity).
    rewrite Odd, Oj in K8.
    destruct (Bool.eqb (Nat.odd (Z.to_nat i)) (Nat.odd (Z.to_nat j))) eqn:Q.
    - apply (matched_even _ _ _ _ D01 D02 D12 V0 V1 V2 _ _ _ _ _ _ Hi' Hj');
        [clear - Q; destruct (Nat.odd (Z.to_nat i)), (Nat.odd (Z.to_nat j)); easy|].
      unfold reflected in K8. apply rotated_spec in K8.
      destruct K8 as [(-> & -> & ->)|[(-> & -> & ->)|(-> & -> & ->)]]; auto.
    - apply (matched_odd _ _ _ _ D01 D02 D12 V0 V1 V2 _ _ _ _ _ _ Hi' Hj');
        [clear - Q; destruct (Nat.odd (Z.to_nat i)), (Nat.odd (Z.to_nat j)); easy|].
      apply rotated_spec in K8.
      destruct K8 as [(-> & -> & ->)|[(-> & -> & ->)|(-> & -> & ->)]]; auto. }
  assert (Nv : nth_error (corners (entry_of Space rows (to_pos u))) (Z.to_nat j) = Some (to_pos v)).
  { rewrite Bc. clear - J. destruct J as [->|[->|[->| ->]]]; reflexivity. }
  change (index j) with (Z.to_nat j).
  split.
  - unfold check_wall. rewrite F, Mf. unfold points_back. rewrite Bw, Pos.eqb_refl, Nat.eqb_refl.
    cbn [andb].
    destruct (delaunay_claimed m && Pos.ltb t (to_pos u)) eqn:Q; [|reflexivity].
    apply andb_prop in Q. destruct Q as [Q1 Q2]. rewrite Nv, Fq. unfold apex_outside.
    destruct (Deep u v q H Fq Rq Q1 Q2) as [Z _]. apply Z.leb_le in Z. now rewrite Z.
  - intros Q1 st As. unfold settled_wall. destruct (Pos.ltb t (to_pos u)) eqn:Q2; [|reflexivity].
    cbn [negb orb].
    rewrite F, Nv, Fq. exact (proj2 (Deep u v q H Fq Rq Q1 Q2) st As).
Qed.
End Simplices.
