(** * Generic points and generic segments in a mesh of cells

    A cell is the intersection of finitely many halfspaces: wall i of cell t is where the affine
    function [wall t i] vanishes, and t is where all of its functions are positive.  A simplex is
    one, with its barycentric coordinates; so is a cone over a simplex, or the part of a cone
    beyond a facet ([Hull.v]).  A point on no wall is found wherever finitely many affine functions
    are positive, and even one that makes a generic segment with points given before
    ([pick_generic]).  Along such segments one can walk ([cells_walk]), and if some point is in one
    cell only, no two cells overlap ([cells_disjoint]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Walk.
Import ListNotations.
Open Scope R_scope.

(** The functions of [f] that are positive at q, for finding points near q where they still are. *)
Definition positive_at {d : nat} {A} (f : A -> point d -> R) (q : point d) (l : list A) :
  list (point d -> R) := map f (filter (fun a => if Rlt_dec 0 (f a q) then true else false) l).

Lemma positive_at_in {d : nat} {A} (f : A -> point d -> R) q l :
  (forall a, In a l -> affine (f a)) -> forall g, In g (positive_at f q l) -> affine g /\ 0 < g q.
Proof.
  intros F g Hg. unfold positive_at in Hg. apply in_map_iff in Hg. destruct Hg as (a & <- & Ha).
  apply filter_In in Ha. destruct Ha as [I P]. destruct (Rlt_dec 0 (f a q)); [auto|discriminate].
Qed.
Lemma positive_at_out {d : nat} {A} (f : A -> point d -> R) q l z :
  (forall g, In g (positive_at f q l) -> 0 < g z) ->
  forall a, In a l -> 0 < f a q -> 0 < f a z.
Proof.
  intros X a I P. apply (X (f a)). unfold positive_at. apply in_map. apply filter_In.
  split; [assumption|]. destruct (Rlt_dec 0 (f a q)); [reflexivity|contradiction].
Qed.

Section Cells.
Context {d : nat} {T : Type}.

(** [tets] lists the cells, [idx t] the walls of t, [adj t i u j] says that wall i of t is matched
    with wall j of u, which faces the other way. *)
Record matched_cells (tets : list T) (idx : T -> list nat) (wall : T -> nat -> point d -> R)
    (adj : T -> nat -> T -> nat -> Prop) : Prop := {
  wall_affine : forall t i, In t tets -> In i (idx t) -> affine (wall t i);
  wall_proper : forall t i, In t tets -> In i (idx t) -> exists p, wall t i p <> 0;
  (* different walls of a cell are in different hyperplanes *)
  wall_transversal : forall t i j, In t tets -> In i (idx t) -> In j (idx t) -> i <> j ->
    exists p, wall t i p = 0 /\ wall t j p <> 0;
  wall_in : forall t i u j, In t tets -> In i (idx t) -> adj t i u j -> In u tets /\ In j (idx u);
  wall_opposite : forall t i u j, In t tets -> In i (idx t) -> adj t i u j ->
    exists c, 0 < c /\ forall p, wall u j p = - c * wall t i p;
  (* a point in the relative interior of a wall is in that of the wall matched with it *)
  wall_through : forall t i u j q, In t tets -> In i (idx t) -> adj t i u j -> wall t i q = 0 ->
    (forall k, In k (idx t) -> k <> i -> 0 < wall t k q) ->
    forall k, In k (idx u) -> k <> j -> 0 < wall u k q;
  wall_once : forall t i t' i' u j, In t tets -> In t' tets -> In i (idx t) -> In i' (idx t') ->
    adj t i u j -> adj t' i' u j -> t = t'
}.

Context {tets : list T} {idx : T -> list nat} {wall : T -> nat -> point d -> R}
  {adj : T -> nat -> T -> nat -> Prop}.
Hypothesis cells : matched_cells tets idx wall adj.

Definition on_no_wall (x : point d) : Prop :=
  forall t i, In t tets -> In i (idx t) -> wall t i x <> 0.
Definition generic_pair (x y : point d) : Prop :=
  forall t i j, In t tets -> In i (idx t) -> In j (idx t) -> i <> j ->
    wall t i x * wall t j y <> wall t j x * wall t i y.
Definition in_cell t (p : point d) : Prop := forall i, In i (idx t) -> 0 < wall t i p.

Lemma generic_pair_sym x y : generic_pair x y -> generic_pair y x.
Proof. intros G t i j Ht Ii Ij N E. apply (G t i j Ht Ii Ij N). lra. Qed.

(** ** Generic points *)

Definition all_walls : list (T * nat) := flat_map (fun t => map (pair t) (idx t)) tets.
Lemma in_all_walls t i : In (t, i) all_walls <-> In t tets /\ In i (idx t).
Proof.
  unfold all_walls. rewrite in_flat_map. split.
  - intros (t' & Ht & I). apply in_map_iff in I. destruct I as (i' & E & Ii).
    injection E as <- <-. auto.
  - intros [Ht Ii]. exists t. split; [assumption|]. now apply in_map.
Qed.

Definition wall_pairs : list (T * (nat * nat)) := flat_map (fun t => map (pair t)
  (filter (fun ij => negb (Nat.eqb (fst ij) (snd ij))) (list_prod (idx t) (idx t)))) tets.
Lemma in_wall_pairs t i j :
  In (t, (i, j)) wall_pairs <-> In t tets /\ In i (idx t) /\ In j (idx t) /\ i <> j.
Proof.
  unfold wall_pairs. rewrite in_flat_map. split.
  - intros (t' & Ht & I). apply in_map_iff in I. destruct I as (ij & E & I). injection E as <- ->.
    apply filter_In in I. destruct I as [I N]. apply in_prod_iff in I. cbn in N.
    apply Bool.negb_true_iff, Nat.eqb_neq in N. tauto.
  - intros (Ht & Ii & Ij & N). exists t. split; [assumption|]. apply in_map. apply filter_In.
    split; [now apply in_prod|]. cbn. now apply Bool.negb_true_iff, Nat.eqb_neq.
Qed.

Definition wall_functions : list (point d -> R) := map (fun q => wall (fst q) (snd q)) all_walls.
Definition pair_functions (x : point d) : list (point d -> R) :=
  map (fun q y => wall (fst q) (fst (snd q)) x * wall (fst q) (snd (snd q)) y +
    - wall (fst q) (snd (snd q)) x * wall (fst q) (fst (snd q)) y) wall_pairs.

Lemma wall_functions_proper f : In f wall_functions -> affine f /\ exists p, f p <> 0.
Proof.
  unfold wall_functions. rewrite in_map_iff. intros ([t i] & <- & Hq).
  apply in_all_walls in Hq. destruct Hq as [Ht Ii]. cbn.
  split; [now apply (wall_affine _ _ _ _ cells)|now apply (wall_proper _ _ _ _ cells)].
Qed.
Lemma pair_functions_proper x f : on_no_wall x -> In f (pair_functions x) ->
  affine f /\ exists p, f p <> 0.
Proof.
  intros Gx. unfold pair_functions. rewrite in_map_iff. intros ([t [i j]] & <- & Hq).
  apply in_wall_pairs in Hq. destruct Hq as (Ht & Ii & Ij & N). cbn [fst snd]. split.
  - apply affine_combine; now apply (wall_affine _ _ _ _ cells).
  - destruct (wall_transversal _ _ _ _ cells t i j Ht Ii Ij N) as (p & Z & P). exists p.
    rewrite Z. intros E. assert (E0 : wall t i x * wall t j p = 0) by lra.
    apply Rmult_integral in E0. specialize (Gx t i Ht Ii). tauto.
Qed.

(** Wherever finitely many affine functions are positive there is a point on no wall, which makes
    generic pairs with given points. *)
Theorem pick_generic (G : list (point d -> R)) y0 xs : (forall x, In x xs -> on_no_wall x) ->
  (forall g, In g G -> affine g /\ 0 < g y0) ->
  exists y, (forall g, In g G -> 0 < g y) /\ on_no_wall y /\
    forall x, In x xs -> generic_pair x y.
Proof.
  intros Hx HG.
  destruct (general_position (wall_functions ++ flat_map pair_functions xs) G y0)
    as (y & Y1 & Y2); auto.
  - intros f Hf. apply in_app_or in Hf. destruct Hf as [Hf|Hf]; [now apply wall_functions_proper|].
    apply in_flat_map in Hf. destruct Hf as (x & Ix & Hf).
    apply (pair_functions_proper x); auto.
  - exists y. split; [assumption|]. split.
    + intros t i Ht Ii. apply (Y2 (wall t i)). apply in_or_app; left.
      unfold wall_functions. apply in_map_iff. exists (t, i). split; [reflexivity|].
      now apply in_all_walls.
    + intros x Ix t i j Ht Ii Ij N E.
      apply (Y2 (fun y => wall t i x * wall t j y + - wall t j x * wall t i y)); [|lra].
      apply in_or_app; right. apply in_flat_map. exists x; split; [assumption|].
      unfold pair_functions. apply in_map_iff. exists (t, (i, j)). split; [reflexivity|].
      now apply in_wall_pairs.
Qed.

(** ** Functions that say where a point is *)

Definition cell_functions t : list (point d -> R) := map (wall t) (idx t).
Lemma cell_functions_in t y : In t tets -> in_cell t y ->
  forall g, In g (cell_functions t) -> affine g /\ 0 < g y.
Proof.
  intros Ht Hy g. unfold cell_functions. rewrite in_map_iff. intros (i & <- & Ii).
  split; [now apply (wall_affine _ _ _ _ cells)|now apply Hy].
Qed.
Lemma cell_functions_out t y : (forall g, In g (cell_functions t) -> 0 < g y) -> in_cell t y.
Proof. intros X i Ii. apply X. unfold cell_functions. now apply in_map. Qed.

(** Being outside finitely many closed cells persists nearby. *)
Lemma outside_functions x (Q : T -> Prop) (Qd : forall t, {Q t} + {~ Q t}) :
  (forall t, In t tets -> Q t -> exists i, In i (idx t) /\ wall t i x < 0) ->
  exists G : list (point d -> R), (forall g, In g G -> affine g /\ 0 < g x) /\
    forall z, (forall g, In g G -> 0 < g z) ->
      forall t, In t tets -> Q t -> exists i, In i (idx t) /\ wall t i z < 0.
Proof.
  intros X.
  set (wx := fun q z => wall (fst q) (snd q) x * wall (fst q) (snd q) z).
  exists (positive_at wx x all_walls). split.
  - apply positive_at_in. intros [t i] I. apply in_all_walls in I. destruct I as [Ht Ii].
    unfold wx; cbn [fst snd]. apply affine_scale. now apply (wall_affine _ _ _ _ cells).
  - intros z Hz t Ht Qt. destruct (X t Ht Qt) as (i & Ii & Neg). exists i. split; [assumption|].
    pose proof (positive_at_out wx x all_walls z Hz (t, i)) as P. unfold wx in P.
    cbn [fst snd] in P. rewrite in_all_walls in P. specialize (P (conj Ht Ii)). nra.
Qed.

(** Near q, every wall function that does not vanish at q has the sign it has at q. *)
Definition same_side (q z : point d) : Prop :=
  forall t i, In t tets -> In i (idx t) -> wall t i q <> 0 -> 0 < wall t i q * wall t i z.
Definition side_functions (q : point d) : list (point d -> R) :=
  positive_at (fun a z => wall (fst a) (snd a) q * wall (fst a) (snd a) z) q all_walls.
Lemma side_functions_in q g : In g (side_functions q) -> affine g /\ 0 < g q.
Proof.
  apply positive_at_in. intros [t i] I. apply in_all_walls in I. destruct I as [Ht Ii].
  cbn [fst snd]. apply affine_scale. now apply (wall_affine _ _ _ _ cells).
Qed.
Lemma side_functions_out q z : (forall g, In g (side_functions q) -> 0 < g z) -> same_side q z.
Proof.
  intros Hz t i Ht Ii N.
  apply (positive_at_out _ q all_walls z Hz (t, i)); [now apply in_all_walls|]. cbn [fst snd]. nra.
Qed.
Lemma same_side_pos q z t i : same_side q z -> In t tets -> In i (idx t) ->
  0 < wall t i q -> 0 < wall t i z.
Proof. intros X Ht Ii P. specialize (X t i Ht Ii ltac:(lra)). nra. Qed.
Lemma same_side_closed q z t i : same_side q z -> In t tets -> In i (idx t) ->
  0 < wall t i z -> 0 <= wall t i q.
Proof.
  intros X Ht Ii P. destruct (Rle_dec 0 (wall t i q)) as [|N]; [assumption|].
  specialize (X t i Ht Ii ltac:(lra)). nra.
Qed.

(** ** Walks *)

(** The segment xy leaves cell t at the point [mix x y s], through wall i and no other. *)
Definition passes (x y : point d) t i s : Prop :=
  In i (idx t) /\ wall t i y < 0 /\ 0 < s < 1 /\ wall t i (mix x y s) = 0 /\
  (forall k, In k (idx t) -> k <> i -> 0 < wall t k (mix x y s)).

Lemma passes_leaves x y t i s : In t tets ->
  leaves idx (fun t i => wall t i x) (fun t i => wall t i y) t i s <-> passes x y t i s.
Proof.
  intros Ht. unfold leaves, passes, along.
  assert (E : forall k, In k (idx t) ->
    wall t k (mix x y s) = (1 - s) * wall t k x + s * wall t k y).
  { intros k Ik. apply affine_mix. now apply (wall_affine _ _ _ _ cells). }
  split; intros (Ii & Hw & Hs & Z & P); rewrite (E i Ii) in *; repeat (split; [assumption|]);
    intros k Ik N; specialize (P k Ik N); rewrite (E k Ik) in *; assumption.
Qed.

Lemma generic_segment_cells x y : on_no_wall y -> generic_pair x y ->
  (forall t i s, In t tets -> passes x y t i s -> exists u j, adj t i u j) ->
  generic_segment tets idx (fun t i => wall t i x) (fun t i => wall t i y) adj.
Proof.
  intros Gy Gxy Open. constructor.
  - exact Gy.
  - intros t i j. apply Gxy.
  - apply (wall_in _ _ _ _ cells).
  - intros t i u j Ht Ii A. destruct (wall_opposite _ _ _ _ cells t i u j Ht Ii A) as (c & C & E).
    exists c. auto.
  - intros t i u j s Ht A Lv. apply passes_leaves in Lv; [|assumption].
    destruct Lv as (Ii & Hw & Hs & Z & P). intros k Ik N. unfold along.
    destruct (wall_in _ _ _ _ cells t i u j Ht Ii A) as [Hu _].
    rewrite <- (affine_mix (wall u k) x y s); [|now apply (wall_affine _ _ _ _ cells)].
    now apply (wall_through _ _ _ _ cells t i u j (mix x y s)).
  - intros t i s Ht Lv. apply (Open t i s Ht). now apply passes_leaves.
Qed.

(** What is reflexive and transitive and holds across each crossing holds from the first cell to
    one that contains y.  (Facets that must not be crossed can be excluded in [Open].) *)
Theorem cells_walk (Rl : T -> T -> Prop) x y t :
  on_no_wall y -> generic_pair x y -> In t tets -> in_cell t x ->
  (forall t i s, In t tets -> passes x y t i s -> exists u j, adj t i u j) ->
  (forall t, Rl t t) -> (forall a b c, Rl a b -> Rl b c -> Rl a c) ->
  (forall t i u j s, In t tets -> In u tets -> In j (idx u) -> adj t i u j -> passes x y t i s ->
     0 < wall u j y -> Rl t u) ->
  exists t', In t' tets /\ in_cell t' y /\ Rl t t'.
Proof.
  intros Gy Gxy Ht Xt Open Refl Trans Cross.
  apply (walk_monotone (generic_segment_cells x y Gy Gxy Open) Rl Refl Trans); auto.
  intros a i u j s Ha A Lv. apply passes_leaves in Lv; [|assumption].
  pose proof Lv as (Ii & Hw & _).
  destruct (wall_in _ _ _ _ cells a i u j Ha Ii A) as [Hu Ij].
  apply (Cross a i u j s Ha Hu Ij A Lv).
  destruct (wall_opposite _ _ _ _ cells a i u j Ha Ii A) as (c & C & ->). nra.
Qed.

(** No two cells overlap, if the sample point [o] is in the cell [t0] and in no other closed cell,
    and no segment that ends in [t0] leaves the mesh.  (Segments may be kept to where given affine
    functions are positive.) *)
Theorem cells_disjoint (dec : forall a b : T, {a = b} + {a <> b}) o t0 (K : list (point d -> R)) :
  In t0 tets -> in_cell t0 o ->
  (forall t, In t tets -> t <> t0 -> exists i, In i (idx t) /\ wall t i o < 0) ->
  (forall x y t i s, (forall g, In g K -> 0 < g x /\ 0 < g y) -> In t tets -> in_cell t0 y ->
     passes x y t i s -> exists u j, adj t i u j) ->
  forall t1 t2 y, (forall g, In g K -> affine g /\ 0 < g o /\ 0 < g y) ->
    In t1 tets -> In t2 tets -> in_cell t1 y -> in_cell t2 y -> t1 = t2.
Proof.
  intros Ht0 O0 Out Open t1 t2 y HK H1 H2 Y1 Y2.
  destruct (dec t1 t2) as [|N]; [assumption|exfalso].
  destruct (outside_functions o (fun t => t <> t0)) as (G & G1 & G2).
  { intros t. destruct (dec t t0); [right; intros X; now apply X|now left]. }
  { assumption. }
  destruct (pick_generic (cell_functions t0 ++ K ++ G) o []) as (z & Z1 & Z2 & _).
  { intros x []. }
  { intros g Hg. apply in_app_or in Hg. destruct Hg as [Hg|Hg]; [now apply (cell_functions_in t0)|].
    apply in_app_or in Hg. destruct Hg as [Hg|Hg]; [|auto]. destruct (HK g Hg) as (A & P & _).
    auto. }
  assert (Zin : in_cell t0 z) by (apply cell_functions_out; intros; apply Z1, in_or_app; now left).
  assert (Zout := G2 z (fun g Hg => Z1 g (in_or_app _ _ _ (or_intror (in_or_app _ _ _
    (or_intror Hg)))))).
  destruct (pick_generic (cell_functions t1 ++ cell_functions t2 ++ K) y [z])
    as (y' & W1 & W2 & W3).
  { intros x [<-|[]]; assumption. }
  { intros g Hg. apply in_app_or in Hg. destruct Hg as [Hg|Hg]; [now apply (cell_functions_in t1)|].
    apply in_app_or in Hg. destruct Hg as [Hg|Hg]; [now apply (cell_functions_in t2)|].
    destruct (HK g Hg) as (A & _ & P). auto. }
  assert (Gyz : generic_pair y' z) by (apply generic_pair_sym, W3; now left).
  assert (Kept : forall g, In g K -> 0 < g y' /\ 0 < g z).
  { intros g Hg. split; [apply W1|apply Z1]; apply in_or_app; right; apply in_or_app; auto. }
  destruct (walk_two (generic_segment_cells y' z Z2 Gyz
      (fun t i s Ht => Open y' z t i s Kept Ht Zin)))
    with (t1 := t1) (t2 := t2) as (a & b & Ia & Ib & Nab & Pa & Pb); auto.
  - intros a i b j u k Ia Ib Ii Ij. apply (wall_once _ _ _ _ cells a i b j u k); auto.
  - apply cell_functions_out; intros; apply W1, in_or_app; now left.
  - apply cell_functions_out; intros; apply W1, in_or_app; right; apply in_or_app; now left.
  - assert (a <> t0 \/ b <> t0) as [Na|Nb] by (destruct (dec a t0); [right|left]; congruence).
    + destruct (Zout a Ia Na) as (i & Ii & Hi). specialize (Pa i Ii). cbn in Pa. lra.
    + destruct (Zout b Ib Nb) as (i & Ii & Hi). specialize (Pb i Ii). cbn in Pb. lra.
Qed.
End Cells.
Arguments on_no_wall {d T} tets idx wall x.
Arguments generic_pair {d T} tets idx wall x y.
Arguments in_cell {d T} idx wall t p.
Arguments cell_functions {d T} idx wall t.
Arguments same_side {d T} tets idx wall q z.
Arguments side_functions {d T} tets idx wall q.
Arguments passes {d T} idx wall x y t i s.
