(** * Completing a list of points and simplices to a certificate: three preparations

    Lists are built member by member ([build]); the barycentre of a simplex is a quotient of
    integers ([sum_combination]); and what a certificate claims depends on its points and
    simplices alone ([same_input]). *)
From Coq Require Import Rbase Rfunctions Lra List Arith Lia ZArith Sorting.Sorted.
From Circumspect Require Import Checker Numbering.
From Circumspect Require Import Definitions Vectors Frame Integers Honest ListedMesh Completeness.
Import ListNotations.
Open Scope R_scope.

(** ** Lists that are built member by member *)

Lemma build_index {A} (Q : nat -> A -> Prop) n : (forall i, (i < n)%nat -> exists a, Q i a) ->
  exists l, length l = n /\ forall i a, nth_error l i = Some a -> Q i a.
Proof.
  induction n as [|n IH]; intros E.
  - exists []. split; [reflexivity|]. intros [|i] a N; discriminate.
  - destruct IH as (l & L & N); [intros; apply E; lia|]. destruct (E n ltac:(lia)) as (a & Qa).
    exists (l ++ [a]). split; [rewrite app_length, L; cbn; lia|]. intros i b Hb.
    destruct (lt_dec i n) as [Hi|Hi].
    + rewrite nth_error_app1 in Hb by lia. auto.
    + assert (i = n) as ->.
      { assert (K : nth_error (l ++ [a]) i <> None) by congruence. apply nth_error_Some in K.
        rewrite app_length in K. cbn in K. lia. }
      rewrite nth_error_app2 in Hb by lia. rewrite L, Nat.sub_diag in Hb. cbn in Hb. congruence.
Qed.
Lemma build {A B} (Q : positive -> A -> B -> Prop) (l : list A) :
  (forall k a, numbered l k = Some a -> exists b, Q k a b) ->
  exists l', length l' = length l /\
    forall k a b, numbered l k = Some a -> numbered l' k = Some b -> Q k a b.
Proof.
  intros E. destruct (build_index (fun i b => exists a, nth_error l i = Some a /\
    Q (Pos.of_succ_nat i) a b) (length l)) as (l' & L & N).
  - intros i Hi. destruct (nth_error l i) as [a|] eqn:Ea; [|apply nth_error_None in Ea; lia].
    destruct (E (Pos.of_succ_nat i) a) as (b & Qb).
    { unfold numbered. now rewrite SuccNat2Pos.id_succ. }
    eauto.
  - exists l'. split; [assumption|]. intros k a b Ha Hb. unfold numbered in *.
    destruct (N _ b Hb) as (a' & Ea' & Qb). replace a with a' by congruence.
    now replace (Pos.of_succ_nat (pred (Pos.to_nat k))) with k in Qb by lia.
Qed.
Lemma numbered_same_length {A B} (l : list A) (l' : list B) k a : length l = length l' ->
  numbered l k = Some a -> exists b, numbered l' k = Some b.
Proof.
  unfold numbered. intros L E. destruct (nth_error l' (pred (Pos.to_nat k))) as [b|] eqn:N;
    [eauto|].
  apply nth_error_None in N. assert (K : nth_error l (pred (Pos.to_nat k)) <> None) by congruence.
  apply nth_error_Some in K. lia.
Qed.
Lemma map_pointwise {A B C} (f : A -> C) (g : B -> C) (l : list A) (l' : list B) :
  length l' = length l ->
  (forall k a b, numbered l k = Some a -> numbered l' k = Some b -> g b = f a) ->
  map g l' = map f l.
Proof.
  revert l'. induction l as [|a l IH]; intros [|b l'] L E; try discriminate; [reflexivity|].
  cbn [map]. f_equal; [now apply (E 1%positive)|]. apply IH; [cbn in L; lia|].
  intros k x y Hx Hy. apply (E (Pos.succ k)); unfold numbered in *;
    replace (pred (Pos.to_nat (Pos.succ k))) with (S (pred (Pos.to_nat k))) by lia; assumption.
Qed.
Lemma numbered_NoDup {A} (l : list A) k k' a : NoDup l -> numbered l k = Some a ->
  numbered l k' = Some a -> k = k'.
Proof.
  unfold numbered. intros N E E'. assert (K : nth_error l (pred (Pos.to_nat k)) <> None) by
    congruence.
  apply nth_error_Some in K. rewrite NoDup_nth_error in N.
  specialize (N (pred (Pos.to_nat k)) (pred (Pos.to_nat k')) K ltac:(congruence)). lia.
Qed.

(** ** The barycentre, as a quotient of integers *)

Fixpoint add (p q : list Z) : list Z :=
  match p, q with x :: p', y :: q' => (x + y)%Z :: add p' q' | _, _ => [] end.
Definition sum_of (d : nat) (l : list site) : list Z :=
  fold_right (fun s z => add (coordinates s) z) (repeat 0%Z d) l.

Lemma add_length p q : length p = length q -> length (add p q) = length p.
Proof. revert q. induction p as [|x p IH]; intros [|y q] L; cbn in *; auto. Qed.
Lemma sum_length d l : Forall (well_shaped d) l -> length (sum_of d l) = d.
Proof.
  induction 1 as [|s l W _ IH]; [apply repeat_length|]. unfold well_shaped in W.
  change (length (add (coordinates s) (sum_of d l)) = d). rewrite add_length; congruence.
Qed.
Lemma integer_point_add d p q : length p = d -> length q = d ->
  integer_point d (add p q) = plus (integer_point d p) (integer_point d q).
Proof.
  revert p q. induction d as [|d IH]; intros [|x p] [|y q] L L'; try discriminate; [reflexivity|].
  cbn. rewrite plus_IZR. unfold plus. cbn. f_equal. apply IH; auto.
Qed.
Lemma integer_point_zero d : integer_point d (repeat 0%Z d) = origin.
Proof. induction d as [|d IH]; cbn; [reflexivity|]. rewrite IH. reflexivity. Qed.
Lemma sum_combination d (r w : R) l : Forall (well_shaped d) l ->
  scale (r / w) (integer_point d (sum_of d l)) =
  combination (map (fun s => (/ w, place_of r s)) l).
Proof.
  induction 1 as [|s l W F IH]; cbn [map].
  - cbn [sum_of fold_right]. rewrite integer_point_zero. apply scale_origin.
  - change (sum_of d (s :: l)) with (add (coordinates s) (sum_of d l)).
    rewrite integer_point_add; [|assumption|now apply sum_length].
    rewrite scale_plus, combination_cons, IH. unfold place_of.
    rewrite scale_scale. replace (/ w * r) with (r / w) by (unfold Rdiv; ring). reflexivity.
Qed.

(** ** The same points and simplices *)

Lemma numbered_map {A B} (f : A -> B) l k : numbered (map f l) k = option_map f (numbered l k).
Proof. apply nth_error_map. Qed.
Lemma numbered_same {A A' B} (f : A -> B) (g : A' -> B) l l' k a : map g l' = map f l ->
  numbered l k = Some a -> exists b, numbered l' k = Some b /\ g b = f a.
Proof.
  intros M E. pose proof (numbered_map g l' k) as X. rewrite M, numbered_map, E in X.
  destruct (numbered l' k) as [b|]; [|discriminate]. exists b. cbn in X. now injection X as ->.
Qed.

Section SameInput.
Variables (d : nat) (c c' : certificate).
Hypothesis Sm : same_input c c'.
Lemma same_unit : unit_of c' = unit_of c.
Proof. destruct Sm as (_ & N & D & _). unfold unit_of. now rewrite N, D. Qed.
Lemma same_points : points_of_certificate d c' = points_of_certificate d c.
Proof.
  destruct Sm as (_ & _ & _ & M & _). unfold points_of_certificate. rewrite same_unit.
  rewrite <- (map_map position (@place_of d (unit_of c))), M. apply map_map.
Qed.
Lemma same_spot k : spot d c' k = spot d c k.
Proof. unfold spot. now rewrite same_points. Qed.
Lemma same_simplices : simplices_of_certificate d c' = simplices_of_certificate d c.
Proof.
  destruct Sm as (_ & _ & _ & _ & M). unfold simplices_of_certificate.
  transitivity (map (map (spot d c)) (map corners (Definitions.simplices c'))).
  - rewrite map_map. apply map_ext. intros e. apply map_ext. apply same_spot.
  - rewrite M. apply map_map.
Qed.
Lemma same_numbers : numbers (Definitions.simplices c') = numbers (Definitions.simplices c).
Proof.
  destruct Sm as (_ & _ & _ & _ & M). unfold numbers.
  rewrite <- (map_length corners (Definitions.simplices c')), M, map_length. reflexivity.
Qed.
Lemma same_claim : claim_holds d c -> claim_holds d c'.
Proof.
  unfold claim_holds. rewrite same_points, same_simplices. destruct Sm as (-> & _ & _ & M & _).
  destruct (claimed c); auto. intros (w & W & T). exists w. split; [|assumption].
  intros e He. apply (in_map position) in He. rewrite M in He. apply in_map_iff in He.
  destruct He as (e' & <- & He). rewrite same_unit. now apply W.
Qed.
Lemma same_listed (orient : list (point d) -> R) : well_listed orient c -> well_listed orient c'.
Proof.
  intros [Sc Sh So Co Po]. destruct Sm as (_ & N & D & M & K).
  constructor; rewrite ?N, ?D, ?M; auto.
  - intros t s' k E I. destruct (numbered_same _ _ _ _ _ _ (eq_sym K) E) as (s & Es & Q).
    rewrite <- Q in I. destruct (Co t s k Es I) as (e & Ee).
    destruct (numbered_same _ _ _ _ _ _ M Ee) as (e' & Ee' & _). eauto.
  - intros t s' E. destruct (numbered_same _ _ _ _ _ _ (eq_sym K) E) as (s & Es & Q).
    rewrite <- Q, (map_ext _ _ same_spot). now apply (Po t).
Qed.
Lemma same_described geo : described (d := d) c geo -> described (d := d) c' geo.
Proof.
  intros [Fr A Df V Cv]. constructor; rewrite ?same_numbers, ?same_points; auto.
  intros t s' E. destruct Sm as (_ & _ & _ & _ & K).
  destruct (numbered_same _ _ _ _ _ _ (eq_sym K) E) as (s & Es & Q).
  rewrite <- Q, (map_ext _ _ same_spot). now apply Fr.
Qed.
End SameInput.
