(** * What the quick check finds of simplices, whatever their dimension

    What [Quick.v] and [QuickPlane.v] ask of a simplex is what [check_simplex] asks of it. *)
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

(** Name what a [let] names, and take conjunctions apart. *)
Ltac parts A := lazymatch type of A with
  | _ && _ = true => let B := fresh "A" in apply andb_prop in A; destruct A as [B A]; parts B
  | _ => idtac
  end.
Ltac open_lets H := repeat (cbv beta in H; lazymatch type of H with
  | (let x := ?v in @?b x) = true => let y := fresh x in pose (y := v); change (b y = true) in H
  | _ && _ = true => let A := fresh "A" in apply andb_prop in H; destruct H as [A H]; parts A
  end).

(** What [words_suffice] asks of the points and of how many simplices there are. *)
Record within_words (D : plane_or_space) (p : packed) (s : Word.t) : Prop := {
  unweighted : weights_of (claimed (frame p)) = false;
  shapes : Forall (fun e => well_shaped (dimension (predicates_of D)) (position e))
    (points (frame p));
  all_fit : forallb (fun e => forallb (fits s) (coordinates (position e))) (points (frame p)) =
    true;
  few_points : count_of (points (frame p)) <= 288230376151711744;
  few_simplices : simplex_count p <= 288230376151711744
}.

(** ** Numbers in rows *)

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

Lemma unlike x y : negb (eqb x y) = true -> x <> y.
Proof. intros H E. apply negb_true_iff in H. apply Z.eqb_neq in H. contradiction. Qed.
Lemma unlike_pos x y : 0 < x -> 0 < y -> x <> y -> to_pos x <> to_pos y.
Proof.
  intros Hx Hy NE E. apply NE. unfold to_pos in E. apply (f_equal Zpos) in E.
  rewrite !Z2Pos.id in E by lia. exact E.
Qed.
Lemma known_positive n v : known n v = true -> 0 < v.
Proof. intros K. apply known_spec in K. lia. Qed.
Lemma counted_spec n k : counted n k = true -> of_pos k = Zpos k /\ Zpos k <= n.
Proof.
  intros H. unfold counted in H. ands. apply known_spec in H. apply Pos.eqb_eq in H0.
  assert (E : of_pos k = Zpos k)
    by (unfold to_pos in H0; rewrite <- H0 at 2; now rewrite Z2Pos.id by lia).
  rewrite E in H. now split.
Qed.
(** Which simplex x is about, and which of its facets. *)
Lemma wall_parts x : 0 <= x < 2 ^ 62 ->
  0 <= down x three < 2 ^ 62 /\ sub x (mul eight (down x three)) = x mod 8 /\ 0 <= x mod 8.
Proof.
  intros H. change (down x three) with (x / 8).
  assert (B : 0 <= x / 8 <= x) by (split; [apply Z.div_pos; lia|apply Z.div_le_upper_bound; lia]).
  pose proof (Z.div_mod x 8). pose proof (Z.mod_pos_bound x 8).
  split; [lia|]. split; [|lia].
  rewrite (mul_small eight _ (8 * (x / 8))) by (unfold eight; lia).
  now rewrite (sub_small x _ (x mod 8)) by lia.
Qed.

(** ** Simplices *)

Section Simplices.
Variables (D : plane_or_space) (p : packed) (asked : option standing).
Notation pr := (predicates_of D).
Notation m := (packed_mesh D p).
Notation rows := (rows_of p).

Lemma find_simplex u : known (simplex_count p) u = true ->
  Table.find (to_pos u) (simplices_of m) = Some (entry_of D rows (to_pos u)).
Proof.
  intros K. apply known_spec in K. apply find_tabulated. unfold to_pos.
  rewrite Z2Pos.id by lia. lia.
Qed.

Lemma used_quickly k e : quick_used D (simplex_count p) rows k e = true ->
  check_point pr m k e = Accepted.
Proof.
  intros H. unfold quick_used in H. apply andb_prop in H. destruct H as [C H].
  apply counted_spec in C. destruct C as [_ C].
  assert (F : Table.find (home e) (simplices_of m) = Some (entry_of D rows (home e)))
    by now apply find_tabulated.
  unfold check_point, used. rewrite F. cbv zeta in H.
  destruct (home_vertex e) as [[|[|[|[|i]]]]|]; destruct D; try discriminate H;
    unfold entry_of, corners_of; cbn [corners nth_error]; now rewrite H.
Qed.

(** Across a facet. *)
Lemma neighbour_accepted t K X n i u j e v q : Table.find u (simplices_of m) = Some e ->
  matched_facet K (corners e) i j = true -> nth_error (walls e) j = Some (Neighbour t i) ->
  nth_error (corners e) j = Some v -> Table.find v (points_of m) = Some q ->
  (delaunay_claimed m = true -> Pos.ltb t u = true ->
     depth pr X n q <= 0 /\ forall st, asked = Some st -> settled pr st K X n v q = true) ->
  check_wall pr m t K X n i (Neighbour u j) = Accepted /\
  (delaunay_claimed m = true -> forall st, asked = Some st ->
    settled_wall pr m st t K X n (Neighbour u j) = true).
Proof.
  intros F Mf B Nv Fq Deep. split.
  - unfold check_wall. rewrite F, Mf. unfold points_back. rewrite B, Pos.eqb_refl, Nat.eqb_refl.
    cbn [andb].
    destruct (delaunay_claimed m && Pos.ltb t u) eqn:Q; [|reflexivity].
    apply andb_prop in Q. destruct Q as [Q1 Q2]. rewrite Nv, Fq. unfold apex_outside.
    destruct (Deep Q1 Q2) as [Z _]. apply Z.leb_le in Z. now rewrite Z.
  - intros Q1 st As. unfold settled_wall. destruct (Pos.ltb t u) eqn:Q2; [|reflexivity].
    cbn [negb orb]. rewrite F, Nv, Fq. exact (proj2 (Deep Q1 eq_refl) st As).
Qed.
Lemma below_enough K X k q quickly : find_all (points_of m) K = Some X ->
  Table.find k (points_of m) = Some q ->
  (quickly = true -> depth pr X (slope pr X) q < 0) ->
  quickly || exactly_below D m asked (exact_plane D m K) k = true ->
  depth pr X (slope pr X) q <= 0 /\
  forall st, asked = Some st -> settled pr st K X (slope pr X) k q = true.
Proof.
  intros Fs Fq Q B. unfold settled. apply orb_prop in B. destruct B as [B|B].
  - specialize (Q B). split; [lia|]. intros st _. apply Z.ltb_lt in Q. now rewrite Q.
  - unfold exactly_below, exact_plane in B. rewrite Fs, Fq in B.
    set (z := depth pr X _ q) in *. clearbody z. apply orb_prop in B. destruct B as [B|B].
    + split; [apply Z.ltb_lt in B; lia|]. intros st _. now rewrite B.
    + apply andb_prop in B. destruct B as [B E]. split; [apply Z.eqb_eq in B; lia|].
      intros st A. rewrite B, A in *. destruct st; [now rewrite E, orb_true_r|discriminate].
Qed.

Lemma each_index_all {A} (f : nat -> A -> result) (l : list A) : forall k,
  (forall i a, nth_error l i = Some a -> f (k + i)%nat a = Accepted) ->
  each_index f k l = Accepted.
Proof.
  induction l as [|a l IH]; intros k H; cbn [each_index]; [reflexivity|].
  pose proof (H 0%nat a eq_refl) as H0. rewrite Nat.add_0_r in H0. rewrite H0. apply IH.
  intros i b E. rewrite Nat.add_succ_comm. now apply H.
Qed.
Lemma simplex_accepted t e X : find_all (points_of m) (corners e) = Some X ->
  positive_simplex pr X = true -> length (walls e) = S (dimension pr) ->
  outside_sample pr m t X (away e) = true ->
  (forall n, (delaunay_claimed m = true -> n = slope pr X) ->
     forall i f, nth_error (walls e) i = Some f ->
     check_wall pr m t (corners e) X n i f = Accepted /\
     (delaunay_claimed m = true -> forall st, asked = Some st ->
        settled_wall pr m st t (corners e) X n f = true)) ->
  check_simplex pr m t e = Accepted /\
  (delaunay_claimed m = true -> forall st, asked = Some st ->
     settled_simplex pr m st t e = true).
Proof.
  intros Fs Po L Out Walls. split.
  - unfold check_simplex. rewrite Fs, Po, L, Nat.eqb_refl, Out.
    apply each_index_all. intros i f E. apply Walls; [|exact E]. intros Q. now rewrite Q.
  - intros Cl st As. unfold settled_simplex. rewrite Fs. apply forallb_forall. intros f I.
    apply In_nth_error in I. destruct I as (i & E).
    exact (proj2 (Walls _ (fun _ => eq_refl) i f E) Cl st As).
Qed.
End Simplices.
