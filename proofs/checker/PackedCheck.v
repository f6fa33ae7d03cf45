(** * The checker, with simplices as rows of words

    [check_packed] and [settle_packed] are extracted.  They are [check] and [settle] of the
    certificate that is packed ([check_packed_is], [settle_packed_is]), but of its simplices only
    the one that is looked at is ever made: so millions need no more room than their rows, and no
    recursion is as deep as the list is long. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Checker Settling Packed.
From Circumspect Require Word Table.
Import ListNotations.

Definition is_accepted (r : result) : bool := match r with Accepted => true | _ => false end.

(** The tables of [mesh_of (unpacked D p)]; a simplex is made when it is looked for. *)
Definition packed_mesh (D : plane_or_space) (p : packed) : mesh :=
  let c := frame p in
  Mesh (delaunay_of (claimed c)) (weights_of (claimed c))
    (Table.of_list (site_of (claimed c)) (points c))
    (Table.tabulate (simplex_count p) (entry_of D (rows_of p)))
    (Table.of_list id (hull c))
    (sample_simplex c) (sample c) (sample_denominator c).

Section Rows.
Variables (D : plane_or_space) (p : packed).
Notation entry := (entry_of D (rows_of p)).

(** Which of them is rejected is asked only if one is. *)
Definition each_row (f : positive -> simplex_entry -> result) : result :=
  if Word.all (simplex_count p) (fun t => is_accepted (f t (entry t))) then Accepted
  else each (fun _ t => f t (entry t)) 1 (Word.upto (simplex_count p)).
Definition settled_rows (f : positive -> simplex_entry -> bool) : settlement :=
  if Word.all (simplex_count p) (fun t => f t (entry t)) then Settled
  else all_settled (fun _ t => f t (entry t)) AtSimplex 1 (Word.upto (simplex_count p)).

Definition check_packed : result :=
  let c := frame p in
  let pr := predicates_of D in
  let m := packed_mesh D p in
  require Checker.scale by scaled c at Nowhere;
  check_points pr (points c) ;;
  each (check_point pr m) 1 (points c) ;;
  (require sample_inside by inside_sample pr m at Nowhere; each_row (check_simplex pr m)) ;;
  each (check_hull pr m) 1 (hull c).
Definition settle_packed (s : standing) : settlement :=
  let c := frame p in
  let pr := predicates_of D in
  let m := packed_mesh D p in
  if delaunay_of (claimed c) then
    match settled_rows (settled_simplex pr m s) with
    | Settled => all_settled (settled_point pr m s) AtPoint 1 (points c)
    | unsettled => unsettled
    end
  else Unsettled Nowhere.

(** ** They are what they say *)

Lemma packed_mesh_is : packed_mesh D p = mesh_of (unpacked D p).
Proof.
  unfold packed_mesh, mesh_of, unpacked.
  cbn [claimed points simplices hull sample_simplex sample sample_denominator].
  unfold Table.of_list at 3, Table.tabulate. now rewrite map_map.
Qed.
Lemma each_numbers (f : positive -> simplex_entry -> result) : forall n a k,
  each f (Pos.of_succ_nat a) (map entry (map Pos.of_succ_nat (seq a n))) =
  each (fun _ t => f t (entry t)) k (map Pos.of_succ_nat (seq a n)).
Proof.
  induction n as [|n IH]; intros a k; [reflexivity|]. cbn [seq map each].
  destruct (f (Pos.of_succ_nat a) (entry (Pos.of_succ_nat a))); [|reflexivity].
  exact (IH (S a) (Pos.succ k)).
Qed.
Lemma settled_numbers (f : positive -> simplex_entry -> bool) : forall n a,
  all_settled f AtSimplex (Pos.of_succ_nat a) (map entry (map Pos.of_succ_nat (seq a n))) =
  all_settled (fun _ t => f t (entry t)) AtSimplex (Pos.of_succ_nat a)
    (map Pos.of_succ_nat (seq a n)).
Proof.
  induction n as [|n IH]; intros a; [reflexivity|]. cbn [seq map all_settled].
  destruct (f (Pos.of_succ_nat a) (entry (Pos.of_succ_nat a))); [|reflexivity]. exact (IH (S a)).
Qed.
Lemma each_row_is f : each_row f = each f 1 (map entry (Word.upto (simplex_count p))).
Proof.
  unfold Word.upto. etransitivity; [|symmetry; exact (each_numbers f _ 0%nat 1%positive)].
  unfold each_row. destruct (Word.all _ _) eqn:A; [|reflexivity]. unfold Word.all, Word.upto in A.
  revert A. generalize (map Pos.of_succ_nat (seq 0 (Z.to_nat (simplex_count p)))), 1%positive.
  clear.
  induction l as [|t l IH]; intros k A; [reflexivity|]. cbn in A |- *. apply andb_prop in A.
  destruct A as [A1 A2].
  destruct (f t (entry t)); [|discriminate]. now apply IH.
Qed.
Lemma settled_rows_are f : settled_rows f = all_settled f AtSimplex 1
  (map entry (Word.upto (simplex_count p))).
Proof.
  unfold Word.upto. etransitivity; [|symmetry; exact (settled_numbers f _ 0%nat)].
  unfold settled_rows. destruct (Word.all _ _) eqn:A; [|reflexivity].
  unfold Word.all, Word.upto in A.
  revert A. change (Pos.of_succ_nat 0) with 1%positive.
  generalize (map Pos.of_succ_nat (seq 0 (Z.to_nat (simplex_count p)))), 1%positive. clear.
  induction l as [|t l IH]; intros k A; [reflexivity|]. cbn in A |- *. apply andb_prop in A.
  destruct A as [A1 A2].
  rewrite A1. now apply IH.
Qed.
Theorem check_packed_is : check_packed = check D (unpacked D p).
Proof.
  unfold check_packed, check, check_in. cbv zeta. rewrite <- packed_mesh_is, each_row_is.
  reflexivity.
Qed.
Theorem settle_packed_is s : settle_packed s = settle D (unpacked D p) s.
Proof.
  unfold settle_packed, settle, settle_in. cbv zeta. rewrite <- packed_mesh_is, settled_rows_are.
  reflexivity.
Qed.
End Rows.
