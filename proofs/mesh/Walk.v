(** * The walk along a segment, through cells and their walls

    Imagine a point that moves along a segment from x (time 0) to y (time 1) through a mesh of
    cells.  A cell is the intersection of finitely many halfspaces, its walls; [u t i] and [w t i]
    are the values at x and at y of the affine function of wall i of cell t, so that
    [along t i s] is its value at time s.  The segment is generic: it meets no two walls of a cell
    at once, and y is on no wall.  Where it leaves a cell through a wall, it enters the one matched
    with it, whose function is a negative multiple.  Each cell is left for good, since the moments
    at which walls are passed only grow: so the walk ends, in a cell that contains y.

    Then whatever relation holds from cell to cell across each crossing holds from the first cell
    to the last ([walk_monotone]), and if no wall is matched with two, two walks from different
    cells that contain x end in different cells ([walk_two]).  Nothing is assumed of how the cells
    lie: no topology is used.  (The idea is that of the proof of Lemma 4.1, the Delaunay Lemma.) *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
Import ListNotations.
Open Scope R_scope.

(** A list that is not empty has a smallest member. *)
Lemma smallest {A} (f : A -> R) (l : list A) : l <> [] ->
  exists i, In i l /\ forall k, In k l -> f i <= f k.
Proof.
  induction l as [|a l IH]; [congruence|intros _].
  destruct l as [|b l'].
  - exists a; split; [now left|]. intros k [->|[]]; lra.
  - destruct IH as (i & Hi & Hm); [congruence|].
    destruct (Rle_dec (f a) (f i)).
    + exists a; split; [now left|]. intros k [->|Hk]; [lra|]. specialize (Hm k Hk); lra.
    + exists i; split; [now right|]. intros k [->|Hk]; [lra|]. auto.
Qed.

(** How many members of [l] come later than s. *)
Definition later {A} (f : A -> R) (s : R) (l : list A) : nat :=
  length (filter (fun q => if Rlt_dec s (f q) then true else false) l).

Lemma later_le {A} (f : A -> R) s s' l : s <= s' -> (later f s' l <= later f s l)%nat.
Proof.
  intros; unfold later; induction l as [|a l IH]; simpl; [lia|].
  destruct (Rlt_dec s (f a)), (Rlt_dec s' (f a)); simpl; try lia; lra.
Qed.

Lemma later_lt {A} (f : A -> R) s s' l q : s < s' -> In q l -> s < f q <= s' ->
  (later f s' l < later f s l)%nat.
Proof.
  intros Hs Hq Hf; unfold later; induction l as [|a l IH]; [easy|].
  destruct Hq as [->|Hq].
  - simpl. destruct (Rlt_dec s (f q)); [|lra]. destruct (Rlt_dec s' (f q)); [lra|].
    simpl. pose proof (later_le f s s' l (Rlt_le _ _ Hs)). unfold later in H. lia.
  - specialize (IH Hq). simpl.
    destruct (Rlt_dec s (f a)), (Rlt_dec s' (f a)); simpl; try lia; lra.
Qed.

Definition along {T} (u w : T -> nat -> R) (t : T) (i : nat) (s : R) : R :=
  (1 - s) * u t i + s * w t i.

(** At time s the segment leaves cell t, through wall i and no other. *)
Definition leaves {T} (idx : T -> list nat) (u w : T -> nat -> R) (t : T) (i : nat) (s : R) :=
  In i (idx t) /\ w t i < 0 /\ 0 < s < 1 /\ along u w t i s = 0 /\
  (forall k, In k (idx t) -> k <> i -> 0 < along u w t k s).

(** [tets] lists the cells, [idx t] the walls of t; [adj t i t' j] matches wall i of t with wall j
    of t'. *)
Record generic_segment {T : Type} (tets : list T) (idx : T -> list nat) (u w : T -> nat -> R)
    (adj : T -> nat -> T -> nat -> Prop) : Prop := {
  (* y is on no wall *)
  segment_end : forall t i, In t tets -> In i (idx t) -> w t i <> 0;
  (* no two walls of a cell are met at once *)
  segment_once : forall t i j, In t tets -> In i (idx t) -> In j (idx t) -> i <> j ->
    u t i * w t j <> u t j * w t i;
  segment_in : forall t i t' j, In t tets -> In i (idx t) -> adj t i t' j ->
    In t' tets /\ In j (idx t');
  (* matched walls face opposite ways *)
  segment_opposite : forall t i t' j, In t tets -> In i (idx t) -> adj t i t' j ->
    exists c, 0 < c /\ u t' j = - c * u t i /\ w t' j = - c * w t i;
  (* what leaves a cell through a wall enters the other through the matched wall *)
  segment_through : forall t i t' j s, In t tets -> adj t i t' j -> leaves idx u w t i s ->
    forall k, In k (idx t') -> k <> j -> 0 < along u w t' k s;
  (* only a wall that the segment does cross must be matched *)
  segment_matched : forall t i s, In t tets -> leaves idx u w t i s -> exists t' j, adj t i t' j
}.

Section Walk.
Context {T : Type} {tets : list T} {idx : T -> list nat} {u w : T -> nat -> R}
  {adj : T -> nat -> T -> nat -> Prop}.
Hypothesis seg : generic_segment tets idx u w adj.
Notation along := (along u w).
Notation leaves := (leaves idx u w).

(** When the line through x and y meets wall i of t. *)
Definition moment (q : T * nat) := u (fst q) (snd q) / (u (fst q) (snd q) - w (fst q) (snd q)).

(** At time s the segment is in t, or enters it. *)
Definition enters t s :=
  forall i, In i (idx t) -> 0 <= along t i s /\ (along t i s = 0 -> u t i < w t i).

Lemma enters_inside t s : (forall k, In k (idx t) -> 0 < along t k s) -> enters t s.
Proof. intros H i Hi; specialize (H i Hi); split; lra. Qed.

Lemma along_moment t i : u t i - w t i <> 0 -> along t i (moment (t, i)) = 0.
Proof. intros; unfold Walk.along, moment; simpl; field; auto. Qed.

Lemma negative_wall t i s : 0 <= s < 1 -> w t i < 0 -> 0 <= along t i s ->
  (along t i s = 0 -> u t i < w t i) ->
  0 < u t i - w t i /\ s < moment (t, i) < 1 /\ along t i (moment (t, i)) = 0.
Proof.
  intros Hs Hw V V0.
  assert (D : 0 < u t i - w t i) by (unfold Walk.along in V; nra).
  pose proof (along_moment t i ltac:(lra)) as VR.
  assert (V' : 0 < along t i s).
  { destruct (Rle_lt_or_eq_dec _ _ V) as [|E]; [assumption|].
    symmetry in E. specialize (V0 E). lra. }
  repeat split; auto; unfold Walk.along in *; nra.
Qed.

Lemma same_moment a b a' b' r : 0 < r < 1 ->
  (1 - r) * a + r * b = 0 -> (1 - r) * a' + r * b' = 0 -> a * b' = a' * b.
Proof.
  intros Hr E E'.
  assert (a = - r * b / (1 - r)) as -> by (field_simplify_eq; lra).
  assert (a' = - r * b' / (1 - r)) as -> by (field_simplify_eq; lra).
  field. lra.
Qed.

(** From time s on the segment stays in t up to its end, or up to a wall through which it leaves. *)
Lemma exit t s : In t tets -> 0 <= s < 1 -> enters t s ->
  exists r, s < r <= 1 /\ (forall k r', In k (idx t) -> s < r' < r -> 0 < along t k r') /\
   ((r = 1 /\ forall k, In k (idx t) -> 0 < w t k) \/
    (exists i, r = moment (t, i) /\ leaves t i r)).
Proof.
  intros Ht Hs HI.
  set (neg := filter (fun i => if Rlt_dec (w t i) 0 then true else false) (idx t)).
  assert (Hneg : forall i, In i neg <-> In i (idx t) /\ w t i < 0).
  { intros i; unfold neg; rewrite filter_In.
    destruct (Rlt_dec (w t i) 0); intuition; try discriminate. }
  assert (Pos : forall k, In k (idx t) -> ~ w t k < 0 -> 0 < w t k).
  { intros k Ik N. pose proof (segment_end _ _ _ _ _ seg t k Ht Ik). lra. }
  assert (Stay : forall k r, In k (idx t) -> ~ w t k < 0 -> s < r <= 1 -> 0 < along t k r).
  { intros k r Ik N Hr. destruct (HI k Ik) as [V _]. specialize (Pos k Ik N).
    unfold Walk.along in *. nra. }
  destruct neg as [|i0 neg'] eqn:En.
  - assert (Hp : forall k, In k (idx t) -> ~ w t k < 0).
    { intros k Ik L. destruct (proj2 (Hneg k) (conj Ik L)). }
    exists 1. split; [lra|]. split; [|left; auto].
    intros k r' Ik Hr. apply Stay; auto; lra.
  - destruct (smallest (fun i => moment (t,i)) (i0 :: neg')) as (i & Hi & Hm); [congruence|].
    apply Hneg in Hi. destruct Hi as [Ii Hi].
    destruct (negative_wall t i s Hs Hi (proj1 (HI i Ii)) (proj2 (HI i Ii))) as (Di & Ri & Vi).
    exists (moment (t,i)). split; [lra|]. split.
    + intros k r' Ik Hr. destruct (Rlt_dec (w t k) 0) as [Lk|Lk]; [|apply Stay; auto; lra].
      destruct (negative_wall t k s Hs Lk (proj1 (HI k Ik)) (proj2 (HI k Ik))) as (Dk & Rk & Vk).
      specialize (Hm k ltac:(apply Hneg; auto)). unfold Walk.along in *. nra.
    + right. exists i. split; [reflexivity|]. repeat split; auto; try lra.
      intros k Ik Nk. destruct (Rlt_dec (w t k) 0) as [Lk|Lk]; [|apply Stay; auto; lra].
      destruct (negative_wall t k s Hs Lk (proj1 (HI k Ik)) (proj2 (HI k Ik))) as (Dk & Rk & Vk).
      specialize (Hm k ltac:(apply Hneg; auto)).
      assert (moment (t,i) <> moment (t,k)).
      { intros E. rewrite <- E in Vk.
        apply (segment_once _ _ _ _ _ seg t i k Ht Ii Ik); [congruence|].
        apply (same_moment _ _ _ _ (moment (t,i))); [lra|exact Vi|exact Vk]. }
      unfold Walk.along in *. nra.
Qed.

(** How many walls are still to be passed at time s, counting all walls of all cells. *)
Definition walls := flat_map (fun t => map (pair t) (idx t)) tets.
Definition ahead s := later moment s walls.

Lemma ahead_less t i s r : In t tets -> In i (idx t) -> s < r -> r = moment (t, i) ->
  (ahead r < ahead s)%nat.
Proof.
  intros Ht Hi Hs Hr. apply later_lt with (q := (t,i)); auto.
  - unfold walls. apply in_flat_map. exists t. split; [assumption|]. now apply in_map.
  - rewrite <- Hr; lra.
Qed.

(** Crossing a wall. *)
Lemma crossing t i r : In t tets -> leaves t i r ->
  exists t' j, In t' tets /\ In j (idx t') /\ adj t i t' j /\ enters t' r /\
    along t' j r = 0 /\ (forall k, In k (idx t') -> k <> j -> 0 < along t' k r).
Proof.
  intros Ht Lv. destruct (segment_matched _ _ _ _ _ seg t i r Ht Lv) as (t' & j & Ha).
  pose proof (segment_through _ _ _ _ _ seg t i t' j r Ht Ha Lv) as P.
  destruct Lv as (Ii & Hw & Hr & Hv & Hk).
  destruct (segment_in _ _ _ _ _ seg t i t' j Ht Ii Ha) as [Ht' Ij].
  destruct (segment_opposite _ _ _ _ _ seg t i t' j Ht Ii Ha) as (c & Pc & Eu & Ew).
  assert (Vj : along t' j r = 0).
  { unfold Walk.along in *. rewrite Eu, Ew. transitivity (- c * ((1 - r) * u t i + r * w t i));
      [ring|]. rewrite Hv. ring. }
  exists t', j. repeat (split; [assumption|]). split; [|split; assumption].
  intros k Ik. destruct (Nat.eq_dec k j) as [->|N].
  - split; [lra|]. intros _. rewrite Eu, Ew. unfold Walk.along in Hv. nra.
  - specialize (P k Ik N). split; lra.
Qed.

Section Monotone.
Variable Rl : T -> T -> Prop.
Hypothesis Rl_refl : forall t, Rl t t.
Hypothesis Rl_trans : forall a b c, Rl a b -> Rl b c -> Rl a c.
Hypothesis Rl_cross : forall t i t' j r, In t tets -> adj t i t' j -> leaves t i r -> Rl t t'.

Lemma walk_on : forall n t s, (ahead s <= n)%nat -> In t tets -> 0 <= s < 1 -> enters t s ->
  exists t', In t' tets /\ (forall k, In k (idx t') -> 0 < w t' k) /\ Rl t t'.
Proof.
  induction n as [n IH] using lt_wf_ind. intros t s Hn Ht Hs HI.
  destruct (exit t s Ht Hs HI) as (r & Hr & _ & [[-> Hp] | (i & Er & Lv)]).
  - exists t; repeat split; auto.
  - destruct (crossing t i r Ht Lv) as (t' & j & Ht' & _ & Ha & HI' & _).
    pose proof (ahead_less t i s r Ht (proj1 Lv) (proj1 Hr) Er).
    pose proof Lv as (_ & _ & Hr1 & _).
    destruct (IH (ahead r) ltac:(lia) t' r ltac:(lia) Ht' ltac:(lra) HI') as (t2 & ? & ? & ?).
    exists t2; repeat split; eauto.
Qed.

Theorem walk_monotone t : In t tets -> (forall i, In i (idx t) -> 0 < u t i) ->
  exists t', In t' tets /\ (forall k, In k (idx t') -> 0 < w t' k) /\ Rl t t'.
Proof.
  intros Ht X. apply (walk_on (ahead 0) t 0); auto; [lra|].
  apply enters_inside. intros k Ik. specialize (X k Ik). unfold Walk.along. lra.
Qed.
End Monotone.

(** ** Two walks *)

(** No wall is matched with two. *)
Hypothesis adj_once : forall t1 i1 t2 i2 t' j, In t1 tets -> In t2 tets ->
  In i1 (idx t1) -> In i2 (idx t2) -> adj t1 i1 t' j -> adj t2 i2 t' j -> t1 = t2.

Definition two_contain_end : Prop := exists t1 t2, In t1 tets /\ In t2 tets /\ t1 <> t2 /\
  (forall k, In k (idx t1) -> 0 < w t1 k) /\ (forall k, In k (idx t2) -> 0 < w t2 k).

(** The induction step, when one of the two cells is left before the other. *)
Lemma one_leaves n ta tb s ra rb i :
  (forall k, (k < n)%nat -> forall t1 t2 s, (ahead s <= k)%nat -> In t1 tets -> In t2 tets ->
     0 <= s < 1 -> enters t1 s -> enters t2 s -> t1 <> t2 -> two_contain_end) ->
  (ahead s <= n)%nat -> In ta tets -> In tb tets -> s < ra <= 1 -> ra < rb -> ta <> tb ->
  (forall k r', In k (idx tb) -> s < r' < rb -> 0 < along tb k r') ->
  ra = moment (ta, i) -> leaves ta i ra -> two_contain_end.
Proof.
  intros IH Hn Ha Hb Hra Hrb N Bb Er Lv.
  destruct (crossing ta i ra Ha Lv) as (t' & j & Ht' & Ij & _ & HI' & Vj & _).
  pose proof (ahead_less ta i s ra Ha (proj1 Lv) (proj1 Hra) Er).
  pose proof Lv as (_ & _ & Hr1 & _).
  assert (Pb : forall k, In k (idx tb) -> 0 < along tb k ra) by (intros; apply Bb; auto; lra).
  apply (IH (ahead ra) ltac:(lia) t' tb ra); auto; try lra.
  - apply enters_inside; auto.
  - intros ->. specialize (Pb j Ij). lra.
Qed.

Lemma two_walk_on : forall n t1 t2 s, (ahead s <= n)%nat -> In t1 tets -> In t2 tets ->
  0 <= s < 1 -> enters t1 s -> enters t2 s -> t1 <> t2 -> two_contain_end.
Proof.
  induction n as [n IH] using lt_wf_ind. intros t1 t2 s Hn H1 H2 Hs I1 I2 Hne.
  destruct (exit t1 s H1 Hs I1) as (r1 & Hr1 & B1 & E1).
  destruct (exit t2 s H2 Hs I2) as (r2 & Hr2 & B2 & E2).
  destruct (Rtotal_order r1 r2) as [Lt | [Eq | Gt]].
  - destruct E1 as [[-> _] | (i & Er & Lv)]; [lra|]. now apply (one_leaves n t1 t2 s r1 r2 i).
  - subst r2. destruct E1 as [[-> P1] | (i1 & R1 & L1)].
    + destruct E2 as [[_ P2] | (i2 & _ & (_ & _ & F & _))]; [|lra]. exists t1, t2; auto.
    + destruct E2 as [[-> _] | (i2 & _ & L2)]; [pose proof L1 as (_ & _ & F & _); lra|].
      destruct (crossing t1 i1 r1 H1 L1) as (t1' & j1 & T1 & J1 & A1 & E1 & Z1 & _).
      destruct (crossing t2 i2 r1 H2 L2) as (t2' & j2 & T2 & J2 & A2 & E2 & Z2 & P2).
      pose proof (ahead_less t1 i1 s r1 H1 (proj1 L1) (proj1 Hr1) R1).
      pose proof L1 as (_ & _ & Hr & _).
      apply (IH (ahead r1) ltac:(lia) t1' t2' r1); auto; try lra.
      intros ->. destruct (Nat.eq_dec j1 j2) as [->|N].
      * apply Hne. eapply (adj_once t1 i1 t2 i2); eauto; [apply (proj1 L1)|apply (proj1 L2)].
      * specialize (P2 j1 J1 N). lra.
  - destruct E2 as [[-> _] | (i & Er & Lv)]; [lra|].
    apply (one_leaves n t2 t1 s r2 r1 i); auto.
Qed.

(** Two different cells that contain the start of the segment: two that contain its end. *)
Theorem walk_two t1 t2 : In t1 tets -> In t2 tets -> t1 <> t2 ->
  (forall k, In k (idx t1) -> 0 < u t1 k) -> (forall k, In k (idx t2) -> 0 < u t2 k) ->
  two_contain_end.
Proof.
  intros H1 H2 N X1 X2. apply (two_walk_on (ahead 0) t1 t2 0); auto; try lra;
    apply enters_inside; intros k Ik; [specialize (X1 k Ik)|specialize (X2 k Ik)];
    unfold Walk.along; lra.
Qed.
End Walk.
