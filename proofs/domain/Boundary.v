(** * The boundary of what the marked simplices cover

    From a point of the marked simplices one gets away from them at once if and only if it is on a
    facet of one of them that has no marked simplex beyond it ([boundary_facets]): otherwise all
    simplices around the point are marked, by the walk of [Enclosed.v], whose walls are here the
    facets where marks differ. *)
From Coq Require Import Rbase Rfunctions Lra List Arith Lia Bool.
From Circumspect Require Import Definitions Domains Vectors Affine Frame Matched Faces Facets
  Adjacency Enclosed.
Import ListNotations.
Open Scope R_scope.

Section Boundary.
Context {d : nat} {A : Type} (tets : list A) (geo : A -> frame d) (V : list (point d)).
Hypothesis positive : (1 <= d)%nat.
Hypothesis fills_hull : filling tets geo V.
Let agreeing := filling_agree tets geo V fills_hull.
Let different := filling_different tets geo V fills_hull.
Let in_V := filling_in tets geo V fills_hull.
Let covering := filling_covers tets geo V fills_hull.
Variable marked : A -> bool.

Notation adj := (adjacent tets geo).
Notation outer := (outer tets geo).
Notation on_facet := (on_facet geo).
Notation in_inner := (in_inner tets geo marked).
Let supports := facet_supports tets geo V positive agreeing in_V covering.

(** Beyond the facet is no marked simplex. *)
Definition exposed t i : Prop := outer t i \/ exists u j, adj t i u j /\ marked u = false.
(** One of the two simplices beside the facet is marked. *)
Definition differs t i : Prop := marked t = true /\ exposed t i \/
  marked t = false /\ exists u j, adj t i u j /\ marked u = true.

Lemma adjacent_back t i u j : adj t i u j -> adj u j t i.
Proof.
  intros (Ht & Hu & O). split; [assumption|]. split; [assumption|]. now apply opposite_sym.
Qed.
Lemma neighbour_once t i u j u' j' : adj t i u j -> adj t i u' j' -> u = u'.
Proof.
  intros (_ & Hu & O) (Ht & Hu' & O').
  apply (one_neighbour tets geo positive agreeing different u j u' j' t i Hu Hu');
    now apply opposite_sym.
Qed.
Lemma differs_dec t i : In t tets -> differs t i \/ ~ differs t i.
Proof.
  intros Ht. unfold differs, exposed. destruct (adjacent_dec tets geo t i Ht) as [(u & j & Ad)|O].
  - destruct (marked t) eqn:Mt, (marked u) eqn:Mu.
    + right. intros [(_ & [O|(u' & j' & Ad' & N)])|(X & _)]; [now apply O in Ad| |discriminate].
      rewrite (neighbour_once t i u j u' j' Ad Ad') in Mu. congruence.
    + left. left. split; [reflexivity|]. right. eauto.
    + left. right. split; [reflexivity|]. eauto.
    + right. intros [(X & _)|(_ & u' & j' & Ad' & N)]; [discriminate|].
      rewrite (neighbour_once t i u j u' j' Ad Ad') in Mu. congruence.
  - destruct (marked t) eqn:Mt.
    + left. left. auto.
    + right. intros [(X & _)|(_ & u & j & Ad & _)]; [discriminate|now apply O in Ad].
Qed.

Definition rift (q : point d) : Prop := exists t i, In t tets /\ (i <= d)%nat /\ differs t i /\
  on_facet t i q.
Lemma facet_dec t i q : on_facet t i q \/ ~ on_facet t i q.
Proof.
  unfold Enclosed.on_facet. destruct (Req_EM_T (bary (geo t) i q) 0) as [Z|Z]; [|right; tauto].
  destruct (Forall_dec (fun k => 0 <= bary (geo t) k q) (fun k => Rle_dec _ _) (seq 0 (S d)))
    as [F|F]; rewrite Forall_forall in F.
  - left. split; [assumption|]. intros k Hk. apply F. now apply in_seq_d.
  - right. intros (_ & I). apply F. intros k Hk. apply I. now apply in_seq_d.
Qed.
Lemma rift_dec q : rift q \/ ~ rift q.
Proof.
  assert (D : forall l, incl l tets -> (exists t i, In t l /\ (i <= d)%nat /\ differs t i /\
    on_facet t i q) \/
    ~ exists t i, In t l /\ (i <= d)%nat /\ differs t i /\ on_facet t i q).
  { induction l as [|t l IH]; intros I; [right; intros (t & i & [] & _)|].
    assert (Ht : In t tets) by (apply I; now left).
    assert (One : forall n, (exists i, (i < n)%nat /\ differs t i /\ on_facet t i q) \/
      ~ exists i, (i < n)%nat /\ differs t i /\ on_facet t i q).
    { induction n as [|n [(i & Hi & X)|N]]; [right; intros (i & Hi & _); lia|left; exists i; split;
        [lia|assumption]|].
      destruct (differs_dec t n Ht) as [Y|Y]; [|right].
      - destruct (facet_dec t n q) as [Z|Z]; [left; exists n; auto|right].
        intros (i & Hi & X). destruct (Nat.eq_dec i n) as [->|]; [tauto|]. apply N. exists i.
        split; [lia|assumption].
      - intros (i & Hi & X). destruct (Nat.eq_dec i n) as [->|]; [tauto|]. apply N. exists i.
        split; [lia|assumption]. }
    destruct (One (S d)) as [(i & Hi & X)|N].
    - left. exists t, i. split; [now left|]. split; [lia|assumption].
    - destruct IH as [(u & i & Hu & X)|M]; [intros x Hx; apply I; now right| |].
      + left. exists u, i. split; [now right|assumption].
      + right. intros (u & i & [<-|Hu] & Hi & X); [apply N; exists i; split; [lia|assumption]|].
        apply M. exists u, i. auto. }
  apply (D tets). apply incl_refl.
Qed.

Lemma a_little_inside u q r : inside_closed (geo u) q ->
  (forall k, (k <= d)%nat -> bary (geo u) k q = 0 -> 0 <= bary (geo u) k r) ->
  exists s, 0 < s <= 1 /\ inside_closed (geo u) (mix q r s).
Proof.
  intros I L.
  destruct (nearby (map (bary (geo u)) (filter (fun k => if Rlt_dec 0 (bary (geo u) k q) then
    true else false)
    (seq 0 (S d)))) q r) as (e & He & K).
  { intros g Hg. apply in_map_iff in Hg. destruct Hg as (k & <- & Hk). apply filter_In in Hk.
    destruct Hk as [Hk P]. apply in_seq_d in Hk. split; [now apply bary_affine|].
    destruct (Rlt_dec 0 (bary (geo u) k q)); [assumption|discriminate]. }
  exists e. split; [lra|]. intros k Hk. destruct (Rlt_dec 0 (bary (geo u) k q)) as [P|P].
  - left. apply (K e ltac:(lra)). apply in_map, filter_In. split; [now apply in_seq_d|].
    destruct (Rlt_dec 0 (bary (geo u) k q)); [reflexivity|contradiction].
  - specialize (I k Hk). assert (Z : bary (geo u) k q = 0) by lra. specialize (L k Hk Z).
    rewrite affine_mix by now apply bary_affine. rewrite Z. nra.
Qed.

Theorem boundary_facets q : in_inner q ->
  (exists r, forall s, 0 < s <= 1 -> ~ in_inner (between q r s)) <->
  exists t i, In t tets /\ (i <= d)%nat /\ marked t = true /\ exposed t i /\ on_facet t i q.
Proof.
  intros (t0 & Ht0 & Mt0 & I0). split.
  - intros (r & Away). destruct (rift_dec q) as [(t & i & Ht & Hi & D & F)|N].
    + destruct D as [(M & E)|(M & u & j & Ad & Mu)]; [exists t, i; auto|].
      pose proof Ad as (_ & Hu & O). exists u, j. split; [assumption|].
      pose proof O as O'. apply opposite_facets in O'. destruct O' as (_ & Hj & S & _).
      split; [assumption|]. split; [assumption|]. split.
      * right. exists t, i. split; [now apply adjacent_back|assumption].
      * destruct F as [Z I]. apply conv_vertices in I.
        assert (C : conv (facet_of (geo t) i) q).
        { apply (conv_face (geo t) _ q (facet_of_incl (geo t) i Hi)).
          split; [now apply conv_vertices|].
          intros k Hk P. apply in_facet_of; [assumption|]. exists k. repeat split; try assumption.
          intros ->. lra. }
        apply (conv_same _ _ q S) in C.
        apply (conv_face (geo u) _ q (facet_of_incl (geo u) j Hj)) in C. destruct C as [Cu P].
        split; [|assumption]. specialize (Cu j Hj) as Pj.
        destruct (Rle_lt_or_eq_dec _ _ Pj) as [L|E]; [exfalso|now symmetry].
        now apply (not_in_facet_of (geo u) j Hj), P.
    + exfalso.
      destruct (leads_on tets geo V positive fills_hull differs rift
        (fun q => iff_refl _) marked) with (z := q) (t := t0) (y := r)
        as (u & Hu & Mu & Iu & L); auto.
      * intros t i u j Ad Nd. destruct (marked t) eqn:Mt, (marked u) eqn:Mu; try reflexivity;
          exfalso; apply Nd.
        -- left. split; [assumption|]. right. eauto.
        -- right. split; [assumption|]. eauto.
      * intros t i Ht Hi O Mt. left. split; [assumption|]. now left.
      * destruct (a_little_inside u q r Iu L) as (s & Hs & C). apply (Away s Hs). exists u. auto.
  - intros (t & i & Ht & Hi & Mt & E & (Z & I)). destruct E as [O|(u & j & Ad & Mu)].
    + exists (away geo t i q 1). intros s Hs (u & Hu & _ & C).
      assert (N : bary (geo t) i (between q (away geo t i q 1) s) = - s).
      { rewrite between_mix, affine_mix by now apply bary_affine.
        rewrite bary_away by assumption. rewrite Z. ring. }
      assert (0 <= bary (geo t) i (between q (away geo t i q 1) s)); [|lra].
      apply (inside_pos (geo u)); [now apply bary_affine|assumption|].
      intros l Hl. apply (supports t i Ht Hi O). now apply (vertex_in tets geo V fills_hull).
    + pose proof Ad as (_ & Hu & Op). exists (barycentre (geo u)). intros s Hs (v & Hv & Mv & C).
      assert (Iu : inside_closed (geo u) q).
      { pose proof Op as Op'. apply opposite_facets in Op'. destruct Op' as (_ & Hj & S & _).
        apply conv_vertices. apply (conv_incl (facet_of (geo u) j)); [now apply facet_of_incl|].
        apply (conv_same _ _ q S).
        apply (conv_face (geo t) _ q (facet_of_incl (geo t) i Hi)). split; [assumption|].
        intros k Hk P. apply in_facet_of; [assumption|]. exists k. repeat split; try assumption.
        intros ->. lra. }
      assert (In_u : inside (geo u) (between q (barycentre (geo u)) s)).
      { intros k Hk. rewrite between_mix, affine_mix by now apply bary_affine.
        pose proof (barycentre_inside (geo u) k Hk). specialize (Iu k Hk). nra. }
      rewrite (inside_once tets geo agreeing different u v _ Hu Hv In_u C) in Mu. congruence.
Qed.
End Boundary.
