(** * Coordinates as words: what is left out

    A point of the quick check is three words, its coordinates without the last s binary digits; the
    difference of two points, levelled, estimates the true one ([edge_estimated],
    [sample_estimated]). *)
From Coq Require Import ZArith List Bool Lia.
From Circumspect Require Import Numbering Integers.
From Circumspect Require Import Quick Estimates.
From Circumspect Require Import Word.
Import ListNotations.
Open Scope Z_scope.

Ltac ands := repeat match goal with
  | H : _ && _ = true |- _ => apply andb_prop in H; destruct H
  end.

(** ** Words as numbers *)

Lemma leb_le' x y : leb x y = true -> x <= y.
Proof. apply Z.leb_le. Qed.
Lemma eqb_eq' x y : eqb x y = true -> x = y.
Proof. apply Z.eqb_eq. Qed.
Lemma many_is : many = 288230376151711744.
Proof. now apply of_pos_small. Qed.
Lemma wrap_range z : - 2 ^ 62 <= wrap z < 2 ^ 62.
Proof. unfold wrap. pose proof (Z.mod_pos_bound (z + 2 ^ 62) (2 ^ 63)). lia. Qed.
Lemma get_range l k : - 2 ^ 62 <= get l k < 2 ^ 62.
Proof. unfold get. destruct (0 <=? k); [apply wrap_range|lia]. Qed.
Lemma wrap_below z : 0 <= z -> wrap z <= z.
Proof. intros H. unfold wrap. pose proof (Z.mod_le (z + 2 ^ 62) (2 ^ 63)). lia. Qed.
Lemma of_to_pos x : 0 < x < 2 ^ 62 -> of_pos (to_pos x) = x.
Proof. intros H. unfold of_pos, to_pos. rewrite Z2Pos.id by lia. apply wrap_small. lia. Qed.
Lemma add_small x y z : x + y = z -> - 2 ^ 62 <= z < 2 ^ 62 -> add x y = z.
Proof. intros <- H. now apply wrap_small. Qed.
Lemma sub_small x y z : x - y = z -> - 2 ^ 62 <= z < 2 ^ 62 -> sub x y = z.
Proof. intros <- H. now apply wrap_small. Qed.
Lemma mul_small x y z : x * y = z -> - 2 ^ 62 <= z < 2 ^ 62 -> mul x y = z.
Proof. intros <- H. now apply wrap_small. Qed.

(** ** Points *)

(** The words of [P] are the coordinates of [q] without the last s digits. *)
Definition rounded (s : Z) (q : site) (P : arrow) : Prop :=
  exists x y z, q = Site [x; y; z] 0 /\ fits s x = true /\ fits s y = true /\ fits s z = true /\
    P = Arrow (Z.shiftr x s) (Z.shiftr y s) (Z.shiftr z s).

Lemma fits_spec s x : fits s x = true -> 0 <= s /\ - 2 ^ 58 <= Z.shiftr x s < 2 ^ 58.
Proof.
  unfold fits. intros H. ands. apply Z.leb_le in H, H1. apply Z.ltb_lt in H0. auto.
Qed.
(** What was left out. *)
Lemma shiftr_spec s x : 0 <= s -> 0 <= x - 2 ^ s * Z.shiftr x s < 2 ^ s /\
  (s = 0 -> x = Z.shiftr x s).
Proof.
  intros H. rewrite Z.shiftr_div_pow2 by assumption.
  pose proof (Z.pow_pos_nonneg 2 s ltac:(lia) H) as P.
  pose proof (Z.div_mod x (2 ^ s) ltac:(lia)). pose proof (Z.mod_pos_bound x (2 ^ s) P).
  split; [lia|]. intros ->. change (2 ^ 0) with 1. now rewrite Z.div_1_r.
Qed.

Section Points.
Variables (d : nat) (s : Z) (l : list point_entry).
Hypothesis shapes : Forall (fun e => well_shaped d (position e)) l.
Hypothesis all_fit : forallb (fun e => forallb (fits s) (coordinates (position e))) l = true.
Hypothesis few : count_of l <= 2 ^ 58.

Lemma nth_flat (i k : nat) : (k < d)%nat -> forall e, nth_error l i = Some e ->
  nth (d * i + k) (flat_map (fun e => coordinates (position e)) l) 0 = nth k
    (coordinates (position e)) 0.
Proof.
  intros K. clear all_fit few. revert i.
  induction l as [|e' l' IH]; intros [|i] e E; try discriminate.
  - injection E as ->. cbn [flat_map]. apply Forall_inv in shapes. unfold well_shaped in shapes.
    rewrite Nat.mul_0_r. apply app_nth1. cbn [Nat.add]. lia.
  - cbn [flat_map]. pose proof (Forall_inv shapes) as Sh. unfold well_shaped in Sh.
    rewrite app_nth2 by lia. rewrite Sh. replace (d * S i + k - d)%nat with (d * i + k)%nat by lia.
    apply IH; [now apply Forall_inv_tail in shapes|exact E].
Qed.
Lemma shifted_zero : shifted s 0 = 0.
Proof. unfold shifted. now rewrite Z.shiftr_0_l, Tauto.if_same. Qed.

Lemma known_spec most v : known most v = true -> 1 <= v <= most.
Proof. unfold known. intros H. ands. apply leb_le' in H, H0. auto. Qed.

Lemma get_place v k e : 1 <= v <= count_of l -> 0 <= k < Z.of_nat d ->
  nth_error l (Z.to_nat (v - 1)) = Some e ->
  get (places_of s l) (Z.of_nat d * (v - 1) + k) =
    Z.shiftr (nth (Z.to_nat k) (coordinates (position e)) 0) s.
Proof.
  intros Hv Hk E. unfold get.
  assert (G : (0 <=? Z.of_nat d * (v - 1) + k) = true) by (apply Z.leb_le; nia). rewrite G.
  assert (P : places_of s l = map (shifted s) (flat_map (fun e => coordinates (position e)) l)).
  { clear. unfold places_of, of_lists. induction l as [|e' l' IH]; [reflexivity|].
    cbn [flat_map]. now rewrite IH, map_app. }
  rewrite P.
  assert (M : forall i zs, nth i (map (shifted s) zs) 0 = shifted s (nth i zs 0))
    by (intros i zs; rewrite <- (map_nth (shifted s)), shifted_zero; reflexivity).
  rewrite M. clear M.
  replace (Z.to_nat (Z.of_nat d * (v - 1) + k)) with (d * Z.to_nat (v - 1) + Z.to_nat k)%nat by nia.
  rewrite (nth_flat (Z.to_nat (v - 1)) (Z.to_nat k) ltac:(lia) e E).
  assert (F : fits s (nth (Z.to_nat k) (coordinates (position e)) 0) = true).
  { rewrite forallb_forall in all_fit. specialize (all_fit e (nth_error_In _ _ E)).
    rewrite forallb_forall in all_fit. apply all_fit. apply nth_In.
    rewrite Forall_forall in shapes. specialize (shapes e (nth_error_In _ _ E)).
    unfold well_shaped in shapes. lia. }
  unfold shifted. rewrite F. apply wrap_small. apply fits_spec in F. lia.
Qed.

Lemma known_entry cl v : weights_of cl = false -> known (count_of l) v = true ->
  exists e, nth_error l (Z.to_nat (v - 1)) = Some e /\
    Table.find (to_pos v) (Table.of_list (site_of cl) l) =
      Some (Site (coordinates (position e)) 0) /\
    length (coordinates (position e)) = d /\ forallb (fits s) (coordinates (position e)) = true.
Proof.
  intros Cl K. apply known_spec in K.
  assert (B : v <= Z.of_nat (length l))
    by (pose proof (wrap_below (Z.of_nat (length l)) ltac:(lia)); unfold count_of in K; lia).
  assert (X : (Z.to_nat (v - 1) < length l)%nat) by lia.
  destruct (nth_error l (Z.to_nat (v - 1))) as [e|] eqn:E; [|apply nth_error_None in E; lia].
  exists e. split; [reflexivity|]. split; [|split].
  - rewrite table_find. unfold numbered, to_pos.
    replace (pred (Pos.to_nat (Z.to_pos v))) with (Z.to_nat (v - 1)).
    + rewrite E. unfold site_of. now rewrite Cl.
    + rewrite <- Z2Nat.inj_pos, Z2Pos.id by lia. lia.
  - rewrite Forall_forall in shapes. apply (shapes e).
    now apply nth_error_In with (Z.to_nat (v - 1)).
  - rewrite forallb_forall in all_fit. apply all_fit.
    now apply nth_error_In with (Z.to_nat (v - 1)).
Qed.
End Points.

Lemma known_point s l cl v : Forall (fun e => well_shaped 3 (position e)) l ->
  forallb (fun e => forallb (fits s) (coordinates (position e))) l = true ->
  count_of l <= 2 ^ 58 -> weights_of cl = false -> known (count_of l) v = true ->
  exists q, Table.find (to_pos v) (Table.of_list (site_of cl) l) = Some q /\
    rounded s q (arrow_to (places_of s l) v).
Proof.
  intros Sh Fit Few Cl K. destruct (known_entry 3 s l Sh Fit cl v Cl K) as (e & E & F & L & Fe).
  apply known_spec in K.
  pose proof (fun k => get_place 3 s l Sh Fit Few v k e K) as G. change (Z.of_nat 3) with 3 in G.
  pose proof (G 0 ltac:(lia) E) as G0. pose proof (G 1 ltac:(lia) E) as G1.
  pose proof (G 2 ltac:(lia) E) as G2. clear G.
  eexists. split; [exact F|].
  destruct (coordinates (position e)) as [|x [|y [|z [|? ?]]]]; try discriminate L.
  exists x, y, z. cbn [forallb] in Fe. ands. repeat (split; [assumption || reflexivity|]).
  unfold arrow_to. rewrite (sub_small v one (v - 1) eq_refl) by lia.
  rewrite (mul_small three (v - 1) (3 * (v - 1) + 0)) by (unfold three; lia).
  rewrite (add_small _ one (3 * (v - 1) + 1)) by (unfold one; lia).
  rewrite (add_small _ two (3 * (v - 1) + 2)) by (unfold two; lia).
  now rewrite G0, G1, G2.
Qed.

(** ** Differences *)

Section Differences.
Variables (s n : Z).
Hypothesis fine_n : fine s n = true.
Notation F := (factor n).
Notation U := (unit s n).

Definition difference (p q : site) : vector := minus3 p q.

Lemma coordinate_difference x y : fits s x = true -> fits s y = true ->
  let w := sub (Z.shiftr x s) (Z.shiftr y s) in
  (s = 0 -> x - y = w) /\ Z.abs (x - y - 2 ^ s * w) <= 2 ^ s * 1.
Proof.
  intros Fx Fy w. apply fits_spec in Fx, Fy. destruct Fx as [Hs Bx], Fy as [_ By].
  pose proof (shiftr_spec s x Hs) as [X X']. pose proof (shiftr_spec s y Hs) as [Y Y'].
  assert (E : w = Z.shiftr x s - Z.shiftr y s) by (apply sub_small; [reflexivity|lia]).
  clearbody w. subst w. split; [intros Z0; specialize (X' Z0); specialize (Y' Z0); lia|].
  set (a := Z.shiftr x s) in *. set (b := Z.shiftr y s) in *. apply Z.abs_le. lia.
Qed.

Lemma at_most_spec most x : 0 <= most < 2 ^ 62 -> at_most most x = true -> Z.abs x <= most.
Proof.
  intros B. unfold at_most. intros H. ands. apply leb_le' in H, H0.
  rewrite (sub_small zero most (- most)) in H by (unfold zero; lia). lia.
Qed.
Lemma inside_spec most p : 0 <= most < 2 ^ 62 -> inside most p = true ->
  Z.abs (along_x p) <= most /\ Z.abs (along_y p) <= most /\ Z.abs (along_z p) <= most.
Proof. intros B. unfold inside. intros H. ands. auto using at_most_spec. Qed.

Lemma up_one k : 0 <= k <= 61 -> up one k = 2 ^ k /\ 0 <= 2 ^ k < 2 ^ 62.
Proof.
  intros H. assert (B : 0 <= 2 ^ k < 2 ^ 62).
  { split; [apply Z.pow_nonneg; lia|]. apply Z.pow_lt_mono_r; lia. }
  split; [|exact B]. unfold up.
  assert (G : (0 <=? k) && (k <=? 62) = true) by (apply andb_true_intro; split; apply Z.leb_le;
    lia).
  rewrite G. unfold one. rewrite Z.mul_1_l. apply wrap_small. lia.
Qed.

Lemma rounded_nonneg q P : rounded s q P -> 0 <= s.
Proof. intros (x & y & z & _ & Fx & _). now apply fits_spec in Fx. Qed.

Lemma doubled_small b : b = 1 \/ b = 2 -> 0 <= b * 2 ^ n < 2 ^ 62.
Proof.
  pose proof (fine_parts s n fine_n) as [Rn _]. pose proof (up_one n ltac:(lia)).
  pose proof (up_one (n + 1) ltac:(lia)). rewrite Z.pow_add_r in * by lia. intros [-> | ->]; lia.
Qed.
Lemma edge_coordinate x x' b : fits s x = true -> fits s x' = true -> (b = 1 \/ b = 2) ->
  let k := sub (Z.shiftr x s) (Z.shiftr x' s) in
  Z.abs k <= b * 2 ^ n -> estimate U (F * (x - x')) (b * 134217728) 1 (level n k).
Proof.
  intros Fx Fx' Hb k B. destruct (coordinate_difference x x' Fx Fx') as [X1 X2].
  apply (estimate_level s n fine_n _ k b 1);
    [now apply fits_spec in Fx|lia|lia|exact X1|exact X2|exact B].
Qed.
Lemma edge_estimated p q P Q b : rounded s p P -> rounded s q Q -> (b = 1 \/ b = 2) ->
  inside (b * 2 ^ n) (arrow_from P Q) = true ->
  estimated U (b * 134217728) 1 (times F (difference p q)) (leveled n (arrow_from P Q)).
Proof.
  intros (x & y & z & -> & Fx & Fy & Fz & ->) (x' & y' & z' & -> & Fx' & Fy' & Fz' & ->) Hb I.
  apply inside_spec in I; [|now apply doubled_small].
  cbn [arrow_from along_x along_y along_z] in I. destruct I as (Ix & Iy & Iz).
  split; [|split]; now apply edge_coordinate.
Qed.

(** The sample point, seen from a vertex: w times the difference. *)
Lemma sample_coordinate w x x' : 0 < w <= 8 -> fits s x = true -> fits s x' = true ->
  let k := sub (Z.shiftr x s) (mul w (Z.shiftr x' s)) in
  Z.abs k <= 2 ^ n -> estimate U (F * (x - w * x')) 134217728 2 (level n k).
Proof.
  intros Hw Fx Fx' k B. apply fits_spec in Fx, Fx'. destruct Fx as [Hs Bx], Fx' as [_ Bx'].
  pose proof (shiftr_spec s x Hs) as [X X']. pose proof (shiftr_spec s x' Hs) as [Y Y'].
  assert (E : k = Z.shiftr x s - w * Z.shiftr x' s).
  { unfold k. rewrite (mul_small w _ (w * Z.shiftr x' s) eq_refl) by nia.
    apply sub_small; [reflexivity|nia]. }
  clearbody k. change 134217728 with (1 * 134217728).
  apply (estimate_level s n fine_n _ k 1 8); [exact Hs|lia|lia| | |lia].
  - intros Z0. specialize (X' Z0). specialize (Y' Z0). rewrite E, <- X', <- Y'. reflexivity.
  - rewrite E. set (a := Z.shiftr x s) in *. set (b := Z.shiftr x' s) in *.
    replace (x - w * x' - 2 ^ s * (a - w * b)) with ((x - 2 ^ s * a) - w * (x' - 2 ^ s * b))
      by ring.
    apply Z.abs_le. nia.
Qed.
Lemma sample_estimated sample_site p P x y z w : 0 < w <= 8 -> rounded s p P ->
  coordinates sample_site = [x; y; z] ->
  fits s x = true -> fits s y = true -> fits s z = true ->
  let q := Arrow (sub (Z.shiftr x s) (mul w (along_x P))) (sub (Z.shiftr y s) (mul w (along_y P)))
    (sub (Z.shiftr z s) (mul w (along_z P))) in
  inside (2 ^ n) q = true ->
  estimated U 134217728 2 (times F (from3 w p sample_site)) (leveled n q).
Proof.
  intros Hw (x' & y' & z' & -> & Fx' & Fy' & Fz' & ->) Co Fx Fy Fz q I.
  apply inside_spec in I; [|rewrite <- (Z.mul_1_l (2 ^ n)); apply doubled_small; now left].
  destruct I as (Ix & Iy & Iz). unfold from3. rewrite Co. cbn [coordinates].
  split; [|split]; now apply sample_coordinate.
Qed.
End Differences.
