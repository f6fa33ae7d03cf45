(** * Cones over the facets of a hull

    If simplices with a common vertex, the summit, fill conv S, and the summit is inside of conv S,
    then their facets opposite it are the boundary of conv S.  A ray from the summit leaves conv S
    where it leaves the simplex that it is in ([facets_end]); and a point that is not on such a
    facet is inside, as the summit is ([facets_reach]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia Permutation.
From Circumspect Require Import Definitions Domains Hulls Vectors Affine Frame Faces Independence
  Combinations.
Import ListNotations.
Open Scope R_scope.

Lemma matched_left {A B} (R : A -> B -> Prop) l m b : Forall2 R l m -> In b m ->
  exists a, In a l /\ R a b.
Proof.
  induction 1 as [|a b' l m Rab F IH]; intros I; [destruct I|].
  destruct I as [<-|I].
  - exists a. split; [now left|assumption].
  - destruct (IH I) as (a' & Ia & Ra). exists a'. split; [now right|assumption].
Qed.
Lemma matched_right {A B} (R : A -> B -> Prop) l m a : Forall2 R l m -> In a l ->
  exists b, In b m /\ R a b.
Proof.
  induction 1 as [|a' b l m Rab F IH]; intros I; [destruct I|].
  destruct I as [<-|I].
  - exists b. split; [now left|assumption].
  - destruct (IH I) as (b' & Ib & Rb). exists b'. split; [now right|assumption].
Qed.
Lemma pairs_along {A B} (R : A -> B -> Prop) (P : A -> A -> Prop) (Q : B -> B -> Prop) l m :
  (forall a b a' b', R a b -> R a' b' -> P a a' -> Q b b') -> Forall2 R l m ->
  ForallOrdPairs P l -> ForallOrdPairs Q m.
Proof.
  intros G F. induction F as [|a b l m Rab F IH]; intros O; [constructor|].
  inversion O as [|a' l' Pa Pl]; subst. constructor; [|auto]. apply Forall_forall. intros b' Ib.
  destruct (matched_left R l m b' F Ib) as (a' & Ia & Ra). rewrite Forall_forall in Pa.
  exact (G a b a' b' Rab Ra (Pa a' Ia)).
Qed.

Section Cones.
Context {d : nat}.
Variables (S S' : list (point d)) (o : point d) (T H : list (simplex d)) (c : frame d).
Hypothesis fill : fills S' T.
Hypothesis without : forall p, In p S' <-> p = o \/ In p S.
Hypothesis over : Forall2 (fun t f => Permutation t (o :: f)) T H.
Hypothesis inner : inside c o.
Hypothesis corners_of_c : incl (vertices c) S.

Let complex : simplicial_complex (faces_of T) := proj1 (proj2 fill).

Lemma conv_without_summit q : conv S' q <-> conv S q.
Proof.
  split.
  - apply conv_conv. intros p I. apply without in I.
    destruct I as [E|I]; [rewrite E|now apply conv_point].
    apply (conv_incl (vertices c)); [assumption|]. apply conv_vertices. intros i Hi.
    left. now apply inner.
  - apply conv_incl. intros p I. apply without. now right.
Qed.
Lemma covered q : conv S q <-> exists t, In t T /\ conv t q.
Proof. rewrite <- conv_without_summit. apply fill. Qed.

(** A cone: its frame, and which vertex is the summit. *)
Lemma cone_frame t f : In t T -> Permutation t (o :: f) -> exists (u : frame d) i, (i <= d)%nat /\
  vertices u = t /\ vertex u i = o.
Proof.
  intros It P. pose proof fill as (L & _). destruct (L t It) as [N Len].
  destruct (frame_of t Len) as (u & V).
  { apply (proj1 complex). split; [assumption|]. split; [intros E; now rewrite E in Len|].
    exists t. split; [assumption|apply incl_refl]. }
  assert (Io : In o (vertices u)).
  { rewrite V. apply (Permutation_in o (Permutation_sym P)). now left. }
  apply in_vertices in Io. destruct Io as (i & Hi & E). exists u, i. auto.
Qed.
Lemma cone_facet t f : In t T -> Permutation t (o :: f) ->
  NoDup f /\ ~ In o f /\ length f = d /\ incl f t /\ incl f S.
Proof.
  intros It P. pose proof fill as (L & _ & _ & V & _). destruct (L t It) as [N Len].
  pose proof (Permutation_NoDup P N) as Nf. inversion Nf as [|o' f' Out Nf']; subst.
  assert (Inc : incl f t).
  { intros p I. apply (Permutation_in p (Permutation_sym P)). now right. }
  repeat split; try assumption.
  - apply Permutation_length in P. cbn in P. lia.
  - intros p I. destruct (proj1 (without p) (V t It p (Inc p I))) as [->|];
      [contradiction|assumption].
Qed.

(** Beyond its facet no cone goes on. *)
Lemma facets_end t f q s : In t T -> Permutation t (o :: f) -> conv f q -> 0 < s ->
  ~ conv S (between o q (1 + s)).
Proof.
  intros It P Cq Hs C. apply covered in C. destruct C as (t' & It' & C).
  destruct (matched_right _ _ _ _ over It') as (f' & If' & P').
  destruct (cone_frame t' f' It' P') as (u & i & Hi & V & Vi).
  rewrite <- V in C. apply conv_vertices in C.
  assert (B : forall k, (k <= d)%nat ->
    bary u k (between o q (1 + s)) = - s * bary u k o + (1 + s) * bary u k q).
  { intros k Hk. change (between (d := d)) with (mix (d := d)).
    rewrite affine_mix by now apply bary_affine. ring. }
  assert (Bi : 0 < bary u i q).
  { specialize (C i Hi). rewrite B, <- Vi, bary_own in C by assumption.
    apply Rmult_lt_reg_l with (1 + s); lra. }
  assert (Q : conv t' q).
  { rewrite <- V. apply conv_vertices. intros k Hk. destruct (Nat.eq_dec k i) as [->|N]; [lra|].
    specialize (C k Hk). rewrite B, <- Vi, bary_other in C by assumption.
    apply Rmult_le_reg_l with (1 + s); lra. }
  destruct (cone_facet t f It P) as (Nf & Out & _ & Inc & _).
  assert (Ff : faces_of T f).
  { split; [assumption|]. split; [intros ->; now apply conv_empty in Cq|].
    exists t. split; assumption. }
  assert (Ft : faces_of T t').
  { pose proof fill as (L & _). destruct (L t' It') as [N Len]. split; [assumption|].
    split; [intros E; now rewrite E in Len|]. exists t'. split; [assumption|apply incl_refl]. }
  pose proof complex as (_ & _ & M). destruct (M f t' Ff Ft) as (g & Gf & Gt & G).
  assert (Z : 0 <= - bary u i q); [|lra].
  apply (affine_conv (fun x => - bary u i x) g q); [now apply affine_opp, bary_affine| |auto].
  intros p Ip. pose proof (Gt p Ip) as I. rewrite <- V in I. apply in_vertices in I.
  destruct I as (k & Hk & ->). rewrite bary_other; [lra|assumption|assumption|].
  intros ->. apply Out. rewrite <- Vi. now apply Gf.
Qed.

Lemma affine_shifted (g : point d -> R) p q r : affine g ->
  g (plus p (minus r q)) = g p + g r - g q.
Proof.
  intros (a & b & E). rewrite !E. unfold plane. rewrite inner_plus_r, inner_minus_r. ring.
Qed.

(** Where a cone has a point that is not on its facet, all segments from there begin in conv S: the
    summit may be moved a little way in any direction. *)
Lemma facets_reach t f q r : In t T -> Permutation t (o :: f) -> conv t q ->
  conv f q \/ exists s, 0 < s <= 1 /\ conv S (between q r s).
Proof.
  intros It P Cq. destruct (cone_frame t f It P) as (u & i & Hi & V & Vi).
  rewrite <- V in Cq. apply conv_vertices in Cq. set (a := bary u i q).
  destruct (cone_facet t f It P) as (_ & _ & _ & _ & Inc).
  assert (Others : forall k, (k <= d)%nat -> k <> i -> In (vertex u k) f).
  { intros k Hk N. assert (I : In (vertex u k) (o :: f)).
    { apply (Permutation_in _ P). rewrite <- V. apply in_vertices. eauto. }
    destruct I as [E|I]; [|assumption]. destruct N. apply (vertex_inj u); congruence. }
  destruct (Rle_lt_or_eq_dec 0 a (Cq i Hi)) as [Pa|Z].
  2: { left. apply (conv_incl (carrier u q)); [|now apply conv_carrier].
    intros v Iv. apply in_carrier in Iv. destruct Iv as (k & Hk & Pk & ->).
    apply Others; [assumption|]. intros ->. fold a in Pk. lra. }
  right.
  assert (La : a <= 1).
  { assert (0 <= 1 - a); [|lra]. apply (inside_pos u (fun p => 1 - bary u i p)); [|assumption|].
    - apply affine_ext with (fun p => 1 * 1 + -1 * bary u i p); [intros; ring|].
      apply affine_combine; [apply affine_const|now apply bary_affine].
    - intros k Hk. rewrite bary_vertex by assumption. destruct (Nat.eq_dec i k); lra. }
  set (x := plus o (minus r q)).
  destruct (nearby (map (bary c) (seq 0 (Datatypes.S d))) o x) as (e & He & N).
  { intros g Ig. apply in_map_iff in Ig. destruct Ig as (k & <- & Ik). apply in_seq_d in Ik.
    split; [now apply bary_affine|now apply inner]. }
  set (z := mix o x e).
  assert (Cz : conv S z).
  { apply (conv_incl (vertices c)); [assumption|]. apply conv_vertices. intros k Hk. left.
    apply (N e); [lra|]. apply in_map, in_seq_d. exact Hk. }
  exists (a * e). split; [nra|].
  set (y k := if Nat.eq_dec k i then z else vertex u k).
  assert (E : between q r (a * e) =
    combination (map (fun k => (bary u k q, y k)) (seq 0 (Datatypes.S d)))).
  { apply affine_separate. intros g G. change (between (d := d)) with (mix (d := d)).
    rewrite affine_mix by assumption.
    rewrite affine_combination_map; [|assumption|exact (bary_sum u q)].
    rewrite (sum_ext _ _ (fun k => bary u k q * g (vertex u k) +
      (if Nat.eq_dec k i then a * (g z - g o) else 0))).
    - rewrite sum_plus. pose proof (interpolation u g q G) as Gq. unfold sum in Gq. rewrite <- Gq.
      rewrite (sum_one _ _ i); [|apply seq_NoDup|now apply in_seq_d|].
      + destruct (Nat.eq_dec i i); [|congruence]. unfold z. rewrite affine_mix by assumption.
        unfold x. rewrite affine_shifted by assumption. ring.
      + intros k _ Nk. now destruct (Nat.eq_dec k i).
    - intros k _. unfold y. destruct (Nat.eq_dec k i) as [->|]; [|ring]. fold a.
      rewrite Vi. ring. }
  rewrite E. apply (conv_conv (map y (seq 0 (Datatypes.S d)))).
  - intros p Ip. apply in_map_iff in Ip. destruct Ip as (k & <- & Ik). apply in_seq_d in Ik.
    unfold y. destruct (Nat.eq_dec k i); [assumption|]. apply conv_point, Inc. now apply Others.
  - eexists. split; [|split; [|reflexivity]].
    + intros b p I. apply in_map_iff in I. destruct I as (k & Ek & Ik). injection Ek as <- <-.
      split; [apply Cq; now apply in_seq_d|now apply in_map].
    + rewrite total_map. exact (bary_sum u q).
Qed.

Theorem cones_over_boundary : boundary_of_hull S H.
Proof.
  constructor.
  - intros f If. destruct (matched_left _ _ _ _ over If) as (t & It & P).
    destruct (cone_facet t f It P) as (N & _ & L & _ & I). auto.
  - assert (Sub : forall s, faces_of H s -> faces_of T s).
    { intros s (N & Ne & f & If & I). destruct (matched_left _ _ _ _ over If) as (t & It & P).
      split; [assumption|]. split; [assumption|]. exists t. split; [assumption|].
      destruct (cone_facet t f It P) as (_ & _ & _ & Inc & _).
      intros p Ip. apply Inc. now apply I. }
    pose proof complex as (Ind & Faces & Meet). split; [|split].
    + intros s F. apply Ind. now apply Sub.
    + intros s g (N & Ne & f & If & I) Ig Ng Neg. split; [assumption|]. split; [assumption|].
      exists f. split; [assumption|]. intros p Ip. apply I. now apply Ig.
    + intros s g Fs Fg. apply Meet; now apply Sub.
  - apply (pairs_along (fun t f => Permutation t (o :: f)) (fun s t => ~ same s t) _ T H);
      [|exact over|apply fill].
    intros t f t' f' P P' N [A B]. apply N. split; intros p I.
    + apply (Permutation_in p (Permutation_sym P')). apply (Permutation_in p P) in I.
      destruct I as [->|I]; [now left|right; now apply A].
    + apply (Permutation_in p (Permutation_sym P)). apply (Permutation_in p P') in I.
      destruct I as [->|I]; [now left|right; now apply B].
  - intros q. cbn. split.
    + intros (Cq & r & _ & R). apply covered in Cq. destruct Cq as (t & It & C).
      destruct (matched_right _ _ _ _ over It) as (f & If & P). exists f. split; [assumption|].
      destruct (facets_reach t f q r It P C) as [|(s & Hs & Cs)]; [assumption|exfalso].
      exact (R s Hs Cs).
    + intros (f & If & C). destruct (matched_left _ _ _ _ over If) as (t & It & P).
      destruct (cone_facet t f It P) as (_ & _ & _ & _ & I).
      split; [now apply (conv_incl f)|]. exists (between o q 2). split; [exact Logic.I|].
      intros s Hs. rewrite <- (between_end o q) at 1. rewrite between_between.
      replace ((1 - s) * 1 + s * 2) with (1 + s) by ring.
      apply (facets_end t f q s It P C). lra.
Qed.
End Cones.
