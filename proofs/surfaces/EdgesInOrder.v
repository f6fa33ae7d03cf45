(** * The order of the edges in a certificate of a surface *)
From Coq Require Import Bool Lia ZArith.
From Circumspect Require Import SurfaceChecker.

Lemma edge_before_trans x y z : edge_before x y = true -> edge_before y z = true ->
  edge_before x z = true /\ (same_edge x z = true -> same_edge y x = true).
Proof.
  unfold edge_before, same_edge.
  rewrite !orb_true_iff, !andb_true_iff, !orb_true_iff, !andb_true_iff,
    !Pos.ltb_lt, !Pos.eqb_eq. intuition lia.
Qed.
Lemma edge_before_itself x : edge_before x x = false.
Proof. unfold edge_before. now rewrite !Pos.ltb_irrefl, !andb_false_r. Qed.
Lemma same_edge_eq x y : same_edge x y = true -> facing x = facing y -> x = y.
Proof.
  unfold same_edge. destruct x, y. cbn. rewrite andb_true_iff, !Pos.eqb_eq.
  intros [-> ->] ->. reflexivity.
Qed.
Lemma same_edge_sym x y : same_edge x y = same_edge y x.
Proof. unfold same_edge. now rewrite (Pos.eqb_sym (low x)), (Pos.eqb_sym (high x)). Qed.
Lemma same_edge_trans x y z : same_edge x y = true -> same_edge y z = true -> same_edge x z = true.
Proof. unfold same_edge. rewrite !andb_true_iff, !Pos.eqb_eq. intuition congruence. Qed.

Definition edge_between (p q o : positive) : edge :=
  if Pos.ltb p q then Edge p q o else Edge q p o.
Lemma edge_between_same p q o p' q' o' :
  (p = p' /\ q = q' \/ p = q' /\ q = p') <->
  same_edge (edge_between p q o) (edge_between p' q' o') = true.
Proof.
  unfold edge_between, same_edge.
  destruct (Pos.ltb_spec p q), (Pos.ltb_spec p' q'); cbn; rewrite andb_true_iff, !Pos.eqb_eq; lia.
Qed.
Lemma edge_between_facing p q o : facing (edge_between p q o) = o.
Proof. unfold edge_between. now destruct (Pos.ltb p q). Qed.
Lemma edge_between_ends p q o :
  low (edge_between p q o) = p /\ high (edge_between p q o) = q \/
  low (edge_between p q o) = q /\ high (edge_between p q o) = p.
Proof. unfold edge_between. destruct (Pos.ltb p q); auto. Qed.
