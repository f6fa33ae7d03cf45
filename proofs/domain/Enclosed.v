(** * What walls enclose is what the marked simplices cover

    A mesh fills conv S, some of its facets are walls, and its simplices are marked: [marked] or
    not. Marks differ only across walls, no facet of the hull that is not a wall belongs to an inner
    simplex, and from each simplex that is not inner one gets, through facets that are not walls, to
    the outside or to a hole.  Then the walls enclose themselves and the inner simplices, and
    nothing else ([enclosed_inner]).

    A simplex that is not inner is left by a path of segments from centre to centre.  For the
    converse one follows a segment that meets no wall: where it is in an inner simplex, all
    simplices there are inner ([marked_alike], by a walk around the point as in [Mesh.v]), and one
    of them holds what comes next ([leads_on]).  It leaves finitely many simplices
    ([stays_inner]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Domains Vectors Affine Frame Matched Faces Facets Walk
  Generic Mesh Adjacency.
Import ListNotations.
Open Scope R_scope.

(** Simplices that meet face to face, none listed twice, and fill conv V. *)
Record filling {d : nat} {A : Type} (tets : list A) (geo : A -> frame d) (V : list (point d)) :
  Prop := {
  filling_agree : forall t u, In t tets -> In u tets -> agree (geo t) (geo u);
  filling_different : forall t u, In t tets -> In u tets ->
    same (vertices (geo t)) (vertices (geo u)) -> t = u;
  filling_in : forall t, In t tets -> incl (vertices (geo t)) V;
  filling_covers : forall q, conv V q -> exists t, In t tets /\ inside_closed (geo t) q;
  filling_some : tets <> []
}.

Section Enclosed.
Context {d : nat} {A : Type} (tets : list A) (geo : A -> frame d) (V : list (point d)).
Hypothesis positive : (1 <= d)%nat.
Hypothesis fills_hull : filling tets geo V.
Let agreeing := filling_agree tets geo V fills_hull.
Let different := filling_different tets geo V fills_hull.
Let in_V := filling_in tets geo V fills_hull.
Let covering := filling_covers tets geo V fills_hull.
Let some := filling_some tets geo V fills_hull.

Notation adj := (adjacent tets geo).
Notation outer := (outer tets geo).
Let mesh := complex_matched tets geo positive agreeing different.
Let supports := facet_supports tets geo V positive agreeing in_V covering.

Definition on_facet t i q : Prop := bary (geo t) i q = 0 /\ inside_closed (geo t) q.

Notation everywhere := (fun _ : point d => True).
Variable wall : A -> nat -> Prop.
Variable walls : point d -> Prop.
Hypothesis walls_are : forall q,
  walls q <-> exists t i, In t tets /\ (i <= d)%nat /\ wall t i /\ on_facet t i q.
Hypothesis walls_dec : forall q, walls q \/ ~ walls q.
Hypothesis wall_both : forall t i u j, adj t i u j -> wall t i -> wall u j.

Variable marked : A -> bool.
Hypothesis passage : forall t i u j, adj t i u j -> ~ wall t i -> marked t = marked u.
Hypothesis closed_off : forall t i, In t tets -> (i <= d)%nat -> outer t i -> marked t = true ->
  wall t i.

Lemma vertex_in t i : In t tets -> (i <= d)%nat -> In (vertex (geo t) i) V.
Proof. intros Ht Hi. apply (in_V t Ht), in_vertices. eauto. Qed.

(** ** Around a point that is on no wall *)

Section Around.
Variable z : point d.
Hypothesis off : ~ walls z.

Lemma no_wall_at t i : In t tets -> (i <= d)%nat -> on_facet t i z -> ~ wall t i.
Proof. intros Ht Hi O W. apply off, walls_are. exists t, i. auto. Qed.

(** Where a segment near z leaves a simplex that contains z, it does so through a facet with z. *)
Lemma passes_at x y t i s : mesh_same_side tets geo z x -> mesh_same_side tets geo z y ->
  In t tets -> mesh_passes geo x y t i s -> on_facet t i z.
Proof.
  intros Sx Sy Ht (Ii & _ & Hs & Z & Pos).
  assert (Sz : mesh_same_side tets geo z (mix x y s)).
  { intros a k Ha Ik N. specialize (Sx a k Ha Ik N). specialize (Sy a k Ha Ik N).
    rewrite (affine_mix (coordinate geo a k)) by now apply (wall_affine _ _ _ _ (mesh_cells mesh)).
    nra. }
  unfold coordinate in Z.
  assert (Zq : bary (geo t) i z = 0).
  { destruct (Req_dec (bary (geo t) i z) 0) as [|N]; [assumption|].
    specialize (Sz t i Ht Ii N). unfold coordinate in Sz. rewrite Z in Sz. lra. }
  split; [assumption|]. intros k Hk. destruct (Nat.eq_dec k i) as [->|N]; [rewrite Zq; lra|].
  apply (same_side_closed z (mix x y s) t k Sz Ht); [now apply in_seq_d|].
  apply Pos; [now apply in_seq_d|assumption].
Qed.

Lemma marked_alike t u : In t tets -> In u tets -> inside_closed (geo t) z ->
  inside_closed (geo u) z -> marked t = marked u.
Proof.
  intros Ht Hu Qt Qu.
  destruct (generic_near mesh [] z t []) as (x & Xi & _ & Xs & Xg & _); auto.
  { intros g []. } { intros ? []. }
  destruct (generic_near mesh [] z u [x]) as (y & Yi & _ & Ys & Yg & Yp); auto.
  { intros g []. } { intros ? [<-|[]]; assumption. }
  destruct (mesh_walk_passing mesh (fun a b => marked a = marked b) x y t) as (u' & Hu' & Yu' & C);
    auto.
  - apply Yp. now left.
  - intros a i Ha Hi O. apply (inside_pos (geo u)); [now apply bary_affine| |].
    + intros k Hk. left. now apply Yi.
    + intros k Hk. apply (supports a i Ha Hi O). now apply vertex_in.
  - congruence.
  - intros a i b j s Ha Hb Ad Ps _. apply (passage a i b j Ad). apply no_wall_at; [assumption| |].
    + apply in_seq_d. apply Ps.
    + now apply (passes_at x y a i s).
  - rewrite C. f_equal. apply (inside_once tets geo agreeing different u' u y Hu' Hu Yu').
    intros k Hk. left. now apply Yi.
Qed.

(** From an inner simplex at z one gets a little towards y in an inner simplex. *)
Lemma leads_on t y : In t tets -> inside_closed (geo t) z -> marked t = true ->
  exists u, In u tets /\ marked u = true /\ inside_closed (geo u) z /\
    forall k, (k <= d)%nat -> bary (geo u) k z = 0 -> 0 <= bary (geo u) k y.
Proof.
  intros Ht Zt Mt. destruct (towards geo z y tets) as [(u & Hu & I & Lead)|(e0 & He & K)].
  { exists u. rewrite (marked_alike u t) by assumption. auto. }
  exfalso.
  destruct (nearby (side_functions tets (facets (d := d)) (coordinate geo) z) z y)
    as (e1 & He1 & Near).
  { intros g Hg. now apply (side_functions_in (mesh_cells mesh) z). }
  set (e := Rmin e0 e1). assert (E : 0 < e <= e0 /\ e <= e1).
  { unfold e. pose proof (Rmin_l e0 e1). pose proof (Rmin_r e0 e1).
    repeat split; try lra. apply Rmin_glb_lt; lra. }
  set (p := mix z y e) in *.
  assert (Out : forall u, In u tets -> True -> exists i, In i (facets (d := d) u) /\
    coordinate geo u i p < 0).
  { intros u Hu _. unfold facets.
    destruct (Exists_dec (fun i => bary (geo u) i p < 0) (seq 0 (S d))) as [X|N].
    { intros i. apply Rlt_dec. } { now apply Exists_exists in X. }
    exfalso. apply (K e (proj1 E) u Hu). intros k Hk.
    destruct (Rle_dec 0 (bary (geo u) k p)) as [|L]; [assumption|exfalso].
    apply N, Exists_exists. exists k. split; [now apply in_seq_d|lra]. }
  destruct (outside_functions (mesh_cells mesh) p (fun _ => True)) as (G & G1 & G2); auto.
  destruct (generic_near mesh [] z t []) as (x & Xi & _ & Xs & Xg & _); auto.
  { intros g []. } { intros ? []. }
  destruct (pick_generic (mesh_cells mesh) (G ++ side_functions tets (facets (d := d))
    (coordinate geo) z) p [x])
    as (w & W1 & W2 & W3).
  { intros ? [<-|[]]; assumption. }
  { intros g Hg. apply in_app_or in Hg. destruct Hg as [Hg|Hg]; [now apply G1|].
    split; [now apply (side_functions_in (mesh_cells mesh) z)|]. apply Near; [lra|assumption]. }
  assert (Ws : mesh_same_side tets geo z w)
    by (apply side_functions_out; intros; apply W1, in_or_app; now right).
  destruct (cells_walk (mesh_cells mesh) (fun _ _ => True) x w t) as (u & Hu & Wu & _); auto.
  - apply W3. now left.
  - now apply in_cell_inside.
  - intros a i s Ha Ps. destruct (adjacent_dec tets geo a i Ha) as [Ad|O]; [assumption|exfalso].
    pose proof (passes_at x w a i s Xs Ws Ha Ps) as F.
    assert (Hi : (i <= d)%nat) by (apply in_seq_d; apply Ps).
    apply (no_wall_at a i Ha Hi F). apply closed_off; try assumption.
    rewrite <- Mt. apply marked_alike; try assumption. apply F.
  - destruct (G2 w (fun g Hg => W1 g (in_or_app _ _ _ (or_introl Hg))) u Hu Logic.I)
      as (i & Ii & Ni).
    apply in_cell_inside in Wu. apply in_seq_d in Ii. specialize (Wu i Ii).
    unfold coordinate in Ni. lra.
Qed.
End Around.

(** ** A segment that meets no wall does not leave the inner simplices *)

Definition in_inner q : Prop := exists t, In t tets /\ marked t = true /\ inside_closed (geo t) q.

Lemma between_mix (x y : point d) s : between x y s = mix x y s.
Proof. reflexivity. Qed.

Lemma stays_inner x y : clear walls x y -> in_inner x -> in_inner y.
Proof.
  intros Cl X.
  set (moment (q : A * nat) := let '(t, k) := q in
    bary (geo t) k x / (bary (geo t) k x - bary (geo t) k y)).
  set (pairs := flat_map (fun t => map (pair t) (seq 0 (S d))) tets).
  assert (Pairs : forall t k, In t tets -> (k <= d)%nat -> In (t, k) pairs).
  { intros t k Ht Hk. apply in_flat_map. exists t. split; [assumption|].
    apply in_map. now apply in_seq_d. }
  assert (G : forall n s, (later moment s pairs < n)%nat -> 0 <= s <= 1 -> in_inner (mix x y s) ->
    in_inner y).
  { induction n as [|n IH]; [lia|]. intros s Ln Hs (t & Ht & Mt & It).
    set (z := mix x y s) in *.
    destruct (leads_on z) with (t := t) (y := y) as (u & Hu & Mu & Iu & Lead); auto.
    { apply (Cl s Hs). }
    set (neg := filter (fun k => if Rlt_dec (bary (geo u) k y) 0 then true else false)
      (seq 0 (S d))).
    assert (Neg : forall k, In k neg <-> (k <= d)%nat /\ bary (geo u) k y < 0).
    { intros k. unfold neg. rewrite filter_In, in_seq_d.
      destruct (Rlt_dec (bary (geo u) k y) 0); intuition discriminate. }
    destruct neg as [|k0 l] eqn:En.
    { exists u. repeat (split; [assumption|]). intros k Hk.
      destruct (Rle_dec 0 (bary (geo u) k y)) as [|L]; [assumption|exfalso].
      apply (proj2 (Neg k)). split; [assumption|lra]. }
    destruct (smallest (fun k => moment (u, k)) (k0 :: l)) as (k & Hk & Least); [discriminate|].
    apply Neg in Hk. destruct Hk as [Hk Yk].
    assert (Zk : forall i, bary (geo u) i z = (1 - s) * bary (geo u) i x + s * bary (geo u) i y \/
      ~ (i <= d)%nat).
    { intros i. destruct (le_lt_dec i d) as [Hi|]; [left|right; lia].
      unfold z. now apply affine_mix, bary_affine. }
    assert (Facts : forall i, (i <= d)%nat -> bary (geo u) i y < 0 ->
      0 < bary (geo u) i x - bary (geo u) i y /\ s < moment (u, i) /\ moment (u, i) < 1 /\
      moment (u, i) * (bary (geo u) i x - bary (geo u) i y) = bary (geo u) i x).
    { intros i Hi Yi. pose proof (Iu i Hi) as Pz.
      destruct (Zk i) as [Ez|]; [|contradiction].
      assert (Pz' : 0 < bary (geo u) i z).
      { destruct (Rle_lt_or_eq_dec _ _ Pz) as [|E]; [assumption|].
        symmetry in E. specialize (Lead i Hi E). lra. }
      set (bx := bary (geo u) i x) in *. set (by_ := bary (geo u) i y) in *.
      rewrite Ez in Pz'. assert (D : 0 < bx - by_) by nra.
      assert (Em : moment (u, i) * (bx - by_) = bx) by (unfold moment; fold bx by_; field; lra).
      repeat split; [assumption| | |assumption]; nra. }
    destruct (Facts k Hk Yk) as (Dk & Mk & Mk1 & Ek).
    apply (IH (moment (u, k))); [|lra|].
    - apply Nat.lt_le_trans with (later moment s pairs); [|lia].
      apply (later_lt moment s (moment (u, k)) pairs (u, k)); [assumption|now apply Pairs|lra].
    - exists u. repeat (split; [assumption|]). intros i Hi.
      rewrite affine_mix by now apply bary_affine.
      set (m := moment (u, k)) in *.
      destruct (Rlt_dec (bary (geo u) i y) 0) as [Yi|Ni].
      + destruct (Facts i Hi Yi) as (Di & Mi & Mi1 & Ei).
        assert (m <= moment (u, i)) by (apply Least; now apply Neg). nra.
      + pose proof (Iu i Hi) as Pz. destruct (Zk i) as [Ez|]; [|contradiction]. rewrite Ez in Pz.
        assert (R : m * 1 = m) by ring.
        (* mix x y m is between z and y *)
        set (bx := bary (geo u) i x) in *. set (by_ := bary (geo u) i y) in *.
        assert (0 <= by_) by lra.
        destruct (Rle_dec 0 bx) as [Px|Nx]; [nra|].
        assert (s * (by_ - bx) <= m * (by_ - bx)) by (apply Rmult_le_compat_r; lra). nra. }
  apply (G (Datatypes.S (later moment 0 pairs)) 0); [lia|lra|].
  destruct X as (t & Ht & Mt & It). exists t. repeat (split; [assumption|]).
  intros k Hk. rewrite affine_mix by now apply bary_affine. specialize (It k Hk). lra.
Qed.

Lemma stays_connected x y : connected everywhere walls x y -> in_inner x -> in_inner y.
Proof. intros C X. induction C as [|y z C IH _ Cl]; [assumption|]. now apply (stays_inner y z). Qed.

(** ** Inner simplices are bounded *)

Lemma conv_bounded r q : (forall v, In v V -> norm2 v <= r) -> conv V q -> norm2 q <= r.
Proof.
  intros B C.
  assert (K : 0 <= (norm2 q + r) / 2 - inner q q); [|unfold norm2 in *; lra].
  apply (affine_conv (fun p => (norm2 q + r) / 2 - inner q p) V q); [| |assumption].
  - exists (scale (-1) q), ((norm2 q + r) / 2). intros p. unfold plane. rewrite inner_scale. ring.
  - intros v Hv. specialize (B v Hv). pose proof (norm2_nonneg (minus q v)) as N.
    change (norm2 (minus q v)) with (dist2 q v) in N. rewrite dist2_expand in N. lra.
Qed.
Lemma V_bounded : exists r, forall v, In v V -> norm2 v <= r.
Proof.
  clear. induction V as [|v l (r & H)]; [exists 0; intros v []|].
  exists (Rmax r (norm2 v)). pose proof (Rmax_l r (norm2 v)). pose proof (Rmax_r r (norm2 v)).
  intros w [<-|Hw]; [assumption|]. specialize (H w Hw). lra.
Qed.
Lemma in_conv t q : In t tets -> inside_closed (geo t) q -> conv V q.
Proof.
  intros Ht I. apply (conv_incl (vertices (geo t))); [now apply in_V|]. now apply conv_vertices.
Qed.
Lemma inner_not_unbounded x : in_inner x -> ~ unbounded everywhere walls x.
Proof.
  intros X U. destruct V_bounded as (r & B). destruct (U r) as (y & C & L).
  destruct (stays_connected x y C X) as (t & Ht & _ & I).
  pose proof (conv_bounded r y B (in_conv t y Ht I)). lra.
Qed.

(** ** From a simplex that is not inner one gets out *)

Variable holes : list (point d).
Hypothesis holes_in : forall h, In h holes -> ~ walls h /\ exists t, In t tets /\
  marked t = false /\
  inside_closed (geo t) h.
Variable rank : A -> nat.
Hypothesis way_out : forall t, In t tets -> marked t = false ->
  (exists h, In h holes /\ inside_closed (geo t) h) \/
  (exists i, (i <= d)%nat /\ outer t i /\ ~ wall t i) \/
  (exists i u j, adj t i u j /\ ~ wall t i /\ (rank u < rank t)%nat).

Lemma inside_off t q : In t tets -> inside (geo t) q -> ~ walls q.
Proof.
  intros Ht I W. apply walls_are in W. destruct W as (u & i & Hu & Hi & _ & Z & C).
  assert (t = u) as -> by now apply (inside_once tets geo agreeing different t u q).
  specialize (I i Hi). lra.
Qed.
(** The centre of a facet that is not a wall is on no wall. *)
Lemma centre_off t i : In t tets -> (i <= d)%nat -> ~ wall t i -> ~ walls (facet_centre (geo t) i).
Proof.
  intros Ht Hi N W. apply walls_are in W. destruct W as (u & k & Hu & Hk & Wu & Z & C).
  destruct (centre_facet tets geo positive agreeing t i u Ht Hu Hi C) as (j & Hj & Same).
  assert (k = j) as ->.
  { destruct (Nat.eq_dec k j) as [|NE]; [assumption|exfalso].
    pose proof (facet_interior (geo t) i (geo u) j (facet_centre (geo t) i) Hi Hj Same
      (bary_facet_centre (geo t) i positive Hi)) as F.
    assert (0 < bary (geo u) k (facet_centre (geo t) i)); [|lra]. apply F; [|assumption|assumption].
    intros l Hl Nl. now apply bary_facet_centre_other. }
  destruct (adjacent_dec tets geo t i Ht) as [(a & b & Ad)|O].
  - (* the neighbour has the facet as well: it is u, or u is t *)
    pose proof Ad as (_ & Ha & Op). pose proof Op as Op'. apply opposite_facets in Op'.
    destruct Op' as (_ & Hb & Same' & _).
    assert (Same'' : same (facet_of (geo u) j) (facet_of (geo a) b)).
    { destruct Same, Same'. split; eapply incl_tran; eassumption. }
    destruct (Req_EM_T (bary (geo u) j (vertex (geo a) b)) 0) as [E|E].
    { now apply (facet_multiple_nonzero (geo u) j (geo a) b Hj Hb) in E. }
    destruct (Rlt_dec 0 (bary (geo u) j (vertex (geo a) b))) as [P|P].
    + assert (u = a) as ->
        by now apply (one_side tets geo positive agreeing different u j a b).
      (* then the facets are one *)
      assert (j = b) as ->.
      { destruct (Nat.eq_dec j b) as [|NE]; [assumption|exfalso].
        apply (not_in_facet_of (geo a) j Hj). apply Same''. apply in_facet_of; [assumption|].
        exists j. auto. }
      apply N. apply (wall_both a b t i); [|assumption]. now apply adjacent_sym.
    + assert (Op'' : opposite (geo u) j (geo a) b).
      { apply opposite_facets. repeat (split; [assumption|]). lra. }
      assert (u = t) as ->.
      { apply (one_neighbour tets geo positive agreeing different u j t i a b); assumption. }
      assert (j = i) as ->; [|contradiction].
      destruct (Nat.eq_dec j i) as [|NE]; [assumption|exfalso].
      apply (not_in_facet_of (geo t) j Hj). apply Same. apply in_facet_of; [assumption|].
      exists j. auto.
  - (* no neighbour: u is t *)
    assert (t = u) as ->.
    { destruct (Req_EM_T (bary (geo t) i (vertex (geo u) j)) 0) as [E|E].
      { now apply (facet_multiple_nonzero (geo t) i (geo u) j Hi Hj) in E. }
      destruct (Rlt_dec 0 (bary (geo t) i (vertex (geo u) j))) as [P|P].
      - now apply (one_side tets geo positive agreeing different t i u j).
      - exfalso. apply (O u j). split; [assumption|]. split; [assumption|].
        apply opposite_facets. repeat (split; [assumption|]). lra. }
    assert (j = i) as ->; [|contradiction].
    destruct (Nat.eq_dec j i) as [|NE]; [assumption|exfalso].
    apply (not_in_facet_of (geo u) j Hj). apply Same. apply in_facet_of; [assumption|].
    exists j. auto.
Qed.

(** Paths. *)
Lemma clear_into t q p : In t tets -> inside_closed (geo t) q -> ~ walls q -> inside (geo t) p ->
  clear walls q p.
Proof.
  intros Ht Q Off P s Hs. destruct (Req_dec s 0) as [->|N].
  - replace (between q p 0) with q; [assumption|].
    apply affine_separate. intros f F. rewrite between_mix, affine_mix by assumption. ring.
  - apply (inside_off t); [assumption|]. intros i Hi.
    rewrite between_mix, affine_mix by now apply bary_affine.
    specialize (Q i Hi). specialize (P i Hi). nra.
Qed.
Lemma clear_back x y : clear walls x y -> clear walls y x.
Proof.
  intros C s Hs. rewrite between_mix. replace (mix y x s) with (between x y (1 - s)).
  - apply C. lra.
  - apply affine_separate. intros f F. rewrite between_mix, !affine_mix by assumption. ring.
Qed.
Lemma connected_trans x y z : connected everywhere walls x y -> connected everywhere walls y z ->
  connected everywhere walls x z.
Proof. intros X Y. induction Y as [|u w Y IH _ C]; [assumption|]. now apply further with u. Qed.
Lemma connected_clear x y : clear walls x y -> connected everywhere walls x y.
Proof. intros C. apply further with x; [apply here|exact Logic.I|assumption]. Qed.

(** Beyond a facet of the hull there are no walls, as far as one goes. *)
Definition away t i (q : point d) r :=
  plus q (scale r (minus (facet_centre (geo t) i) (vertex (geo t) i))).
Lemma bary_away t i q r : (i <= d)%nat -> bary (geo t) i (away t i q r) = bary (geo t) i q - r.
Proof.
  intros Hi. destruct (bary_affine (geo t) i Hi) as (a & b & E).
  pose proof (bary_facet_centre (geo t) i positive Hi) as Z.
  pose proof (bary_own (geo t) i Hi) as O.
  rewrite E in Z, O. rewrite !E. unfold plane, away in *.
  rewrite inner_plus_r, inner_scale_r, inner_minus_r.
  replace (inner a (facet_centre (geo t) i) - inner a (vertex (geo t) i)) with (-1) by lra. ring.
Qed.
Lemma beyond_off t i q : In t tets -> (i <= d)%nat -> outer t i -> bary (geo t) i q < 0 ->
  ~ walls q.
Proof.
  intros Ht Hi O N W. apply walls_are in W. destruct W as (u & k & Hu & _ & _ & _ & C).
  assert (0 <= bary (geo t) i q); [|lra].
  apply (inside_pos (geo u)); [now apply bary_affine|assumption|].
  intros l Hl. apply (supports t i Ht Hi O). now apply vertex_in.
Qed.
Lemma beyond_unbounded t i q : In t tets -> (i <= d)%nat -> outer t i -> bary (geo t) i q <= 0 ->
  ~ walls q -> unbounded everywhere walls q.
Proof.
  intros Ht Hi O N Off r.
  set (w := minus (facet_centre (geo t) i) (vertex (geo t) i)).
  assert (Cl : forall b, 0 <= b -> clear walls q (away t i q b)).
  { intros b Hb s Hs. rewrite between_mix.
    replace (mix q (away t i q b) s) with (away t i q (s * b)).
    - destruct (Req_dec (s * b) 0) as [->|NZ].
      + replace (away t i q 0) with q; [assumption|]. unfold away.
        now rewrite scale_zero, plus_origin.
      + apply (beyond_off t i); try assumption. rewrite bary_away by assumption. nra.
    - unfold away, mix. rewrite scale_plus, scale_scale, plus_assoc, <- plus_scale.
      replace (1 - s + s) with 1 by ring. now rewrite scale_one. }
  assert (W : 0 < norm2 w).
  { destruct (Rle_lt_or_eq_dec _ _ (norm2_nonneg w)) as [|E]; [assumption|exfalso].
    symmetry in E. apply norm2_zero in E.
    pose proof (bary_away t i q 1 Hi) as B. unfold away in B. fold w in B.
    rewrite E, scale_origin, plus_origin in B. lra. }
  (* |q + b w|^2 >= b (2 <q, w> + b |w|^2) *)
  set (b := (Rabs r + 1 + 2 * Rabs (inner q w)) / norm2 w + 1).
  assert (Pa : 0 <= Rabs r) by apply Rabs_pos.
  assert (Pi : 0 <= Rabs (inner q w)) by apply Rabs_pos.
  assert (B1 : 1 <= b).
  { unfold b. assert (0 <= (Rabs r + 1 + 2 * Rabs (inner q w)) / norm2 w); [|lra].
    apply Rmult_le_pos; [lra|]. left. now apply Rinv_0_lt_compat. }
  assert (B2 : Rabs r + 1 + 2 * Rabs (inner q w) <= b * norm2 w).
  { unfold b. rewrite Rmult_plus_distr_r. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  exists (away t i q b). split; [apply connected_clear, Cl; lra|].
  assert (E : norm2 (away t i q b) = norm2 q + b * (2 * inner q w + b * norm2 w)).
  { unfold away. fold w. unfold norm2.
    repeat rewrite ?inner_plus, ?inner_plus_r, ?inner_scale, ?inner_scale_r.
    rewrite (inner_comm w q). ring. }
  rewrite E. pose proof (norm2_nonneg q). pose proof (Rle_abs r).
  pose proof (Rle_abs (- inner q w)) as M. rewrite Rabs_Ropp in M. nra.
Qed.

Lemma gets_out n : forall t, In t tets -> marked t = false -> (rank t < n)%nat ->
  unbounded everywhere walls (barycentre (geo t)) \/
  exists h, In h holes /\ connected everywhere walls (barycentre (geo t)) h.
Proof.
  induction n as [|n IH]; [lia|]. intros t Ht Mt Rk.
  pose proof (barycentre_inside (geo t)) as B.
  assert (Bc : inside_closed (geo t) (barycentre (geo t))) by (intros i Hi; left; now apply B).
  pose proof (inside_off t _ Ht B) as Off.
  destruct (way_out t Ht Mt) as [(h & Hh & I)|[(i & Hi & O & N)|(i & u & j & Ad & N & L)]].
  - right. exists h. split; [assumption|]. apply connected_clear, clear_back.
    apply (clear_into t); auto. now apply holes_in.
  - left. intros r.
    pose proof (centre_off t i Ht Hi N) as Foff.
    destruct (beyond_unbounded t i (facet_centre (geo t) i) Ht Hi O) with (r := r) as (y & C & Y).
    { rewrite bary_facet_centre by assumption. lra. } { assumption. }
    exists y. split; [|assumption]. apply connected_trans with (facet_centre (geo t) i);
      [|assumption].
    apply connected_clear, clear_back. apply (clear_into t); auto. now apply facet_centre_closed.
  - pose proof Ad as (_ & Hu & Op). pose proof Op as (Hi & Hj & _).
    pose proof (centre_off t i Ht Hi N) as Foff.
    assert (Step : connected everywhere walls (barycentre (geo t)) (barycentre (geo u))).
    { apply connected_trans with (facet_centre (geo t) i).
      - apply connected_clear, clear_back. apply (clear_into t); auto.
        now apply facet_centre_closed.
      - apply connected_clear. apply (clear_into u); auto; [|apply barycentre_inside].
        intros l Hl. destruct (Nat.eq_dec l j) as [->|Nl].
        + destruct (opposite_multiple _ _ _ _ Op) as (c & _ & ->).
          rewrite bary_facet_centre by assumption. lra.
        + left. apply (opposite_through (geo t) i (geo u) j); auto.
          * now apply bary_facet_centre.
          * intros k Hk Nk. now apply bary_facet_centre_other. }
    destruct (IH u Hu) as [U|(h & Hh & C)]; [|lia| |].
    + rewrite <- Mt. symmetry. now apply (passage t i u j).
    + left. intros r. destruct (U r) as (y & C & Y). exists y. split; [|assumption].
      now apply connected_trans with (barycentre (geo u)).
    + right. exists h. split; [assumption|]. now apply connected_trans with (barycentre (geo u)).
Qed.

Lemma covered_or_beyond q : (exists t, In t tets /\ inside_closed (geo t) q) \/
  exists t i, In t tets /\ (i <= d)%nat /\ outer t i /\ bary (geo t) i q < 0.
Proof.
  assert (K : forall l : list (A * nat), (forall t i, In (t, i) l -> In t tets) ->
    (exists t i, In (t, i) l /\ outer t i /\ bary (geo t) i q < 0) \/
    (forall t i, In (t, i) l -> outer t i -> 0 <= bary (geo t) i q)).
  { induction l as [|(t, i) l IH]; intros Dom; [right; intros t i []|].
    destruct IH as [(u & k & I & O & L)|IH]; [intros; apply (Dom t0 i0); now right| |].
    { left. exists u, k. split; [now right|auto]. }
    destruct (Rlt_dec (bary (geo t) i q) 0) as [L|L].
    - destruct (adjacent_dec tets geo t i (Dom t i (or_introl eq_refl))) as [(u & j & Ad)|O].
      + right. intros a k [E|I] O; [|now apply IH]. injection E as <- <-. exfalso.
        now apply (O u j).
      + left. exists t, i. split; [now left|auto].
    - right. intros a k [E|I] O; [injection E as <- <-; lra|now apply IH]. }
  assert (FL : forall t i, In (t, i) (flat_map (fun t => map (pair t) (seq 0 (S d))) tets) <->
    In t tets /\ (i <= d)%nat).
  { intros t i. rewrite in_flat_map. split.
    - intros (a & Ha & I). apply in_map_iff in I. destruct I as (k & E & Hk).
      injection E as <- <-. split; [assumption|now apply in_seq_d].
    - intros [Ht Hi]. exists t. split; [assumption|]. apply in_map. now apply in_seq_d. }
  destruct (K (flat_map (fun t => map (pair t) (seq 0 (S d))) tets)) as [(t & i & I & O & L)|N].
  - intros t i I. now apply FL in I.
  - right. apply FL in I. exists t, i. tauto.
  - left. apply (mesh_covers mesh vertex_in supports q some).
    intros t i Ht Hi O. apply N; [now apply FL|assumption].
Qed.

Theorem enclosed_inner q : enclosed everywhere walls holes q <-> walls q \/ in_inner q.
Proof.
  split.
  - intros (_ & [W|(B & H)]); [now left|].
    destruct (walls_dec q) as [W|Off]; [now left|right].
    destruct (covered_or_beyond q) as [(t & Ht & I)|(t & i & Ht & Hi & O & L)].
    + destruct (marked t) eqn:Mt; [exists t; auto|exfalso].
      assert (C : connected everywhere walls q (barycentre (geo t))).
      { apply connected_clear. apply (clear_into t); auto. apply barycentre_inside. }
      destruct (gets_out (S (rank t)) t Ht Mt) as [U|(h & Hh & C')]; [lia| |].
      * apply B. intros r. destruct (U r) as (y & C' & Y). exists y. split; [|assumption].
        now apply connected_trans with (barycentre (geo t)).
      * apply (H h Hh). now apply connected_trans with (barycentre (geo t)).
    + exfalso. apply B. apply (beyond_unbounded t i); auto. lra.
  - intros H. split; [exact Logic.I|]. destruct H as [W|I]; [now left|].
    destruct (walls_dec q) as [W|Off]; [now left|right].
    split; [now apply inner_not_unbounded|].
    intros h Hh C. destruct (stays_connected q h C I) as (t & Ht & Mt & It).
    destruct (holes_in h Hh) as (Offh & u & Hu & Mu & Iu).
    rewrite (marked_alike h Offh u t Hu Ht Iu It) in Mu. congruence.
Qed.
End Enclosed.
