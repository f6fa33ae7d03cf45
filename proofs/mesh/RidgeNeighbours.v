(** * Every ridge of a hull facet has a hull facet on its other side

    A generic ray from o leaves conv S through the relative interior of a hull facet
    ([generic_exit]): where it leaves, it is on the hyperplane of some hull facet, in a simplex, and
    on no face of that simplex of dimension less than d-1.  Now let the ray pass a ridge of a hull
    facet closely, on the other side.  The cone that it is in has the ridge's projection z among
    its closed points, so it is the cone of a hull facet with that ridge ([ridge_neighbour]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Facets Matched Generic Mesh.
From Circumspect Require Import Adjacency Cone Caratheodory Ridges.
Import ListNotations.
Open Scope R_scope.

Section RidgeNeighbours.
Context {d : nat} {A : Type} (tets : list A) (geo : A -> frame d) (V : list (point d)).
Hypothesis two : (2 <= d)%nat.
Hypothesis agreeing : forall t u, In t tets -> In u tets -> agree (geo t) (geo u).
Hypothesis different : forall t u, In t tets -> In u tets ->
  same (vertices (geo t)) (vertices (geo u)) -> t = u.
Hypothesis in_V : forall t, In t tets -> incl (vertices (geo t)) V.
Notation hull_facet := (hull_facet tets geo (outer tets geo)).
Hypothesis support : supporting tets geo (outer tets geo) (fun p => In p V).
Variables (o : point d) (cone : A -> nat -> frame d).
Hypothesis interior : forall t i, hull_facet t i -> 0 < bary (geo t) i o.
Hypothesis cones : forall t i, hull_facet t i -> cone_of (geo t) i o (cone t i).

Lemma one_dimension : (1 <= d)%nat.
Proof. lia. Qed.
Lemma vertex_in_V t i : In t tets -> (i <= d)%nat -> In (vertex (geo t) i) V.
Proof. intros Ht Hi. apply (in_V t Ht), in_vertices. eauto. Qed.

(** The hull facets are finitely many. *)
Lemma hull_facet_list : exists L, forall t i, In (t, i) L <-> hull_facet t i.
Proof.
  assert (K : forall l : list (A * nat), (forall t i, In (t, i) l -> In t tets) ->
    exists L, forall t i, In (t, i) L <-> In (t, i) l /\ hull_facet t i).
  { induction l as [|[t i] l IH]; intros Hl; [exists []; intros; cbn; tauto|].
    destruct IH as (L & IH); [intros t' i' I; apply (Hl t' i'); now right|].
    assert (hull_facet t i \/ ~ hull_facet t i) as [Y|N].
    { assert (Ht : In t tets) by (apply (Hl t i); now left).
      destruct (le_dec i d) as [Hi|N]; [|right; intros (_ & Q & _); contradiction].
      destruct (adjacent_dec tets geo t i Ht) as [(u & j & Q)|Out]; [right|left; now split].
      intros (_ & _ & Out). exact (Out u j Q). }
    - exists ((t, i) :: L). intros t' i'. cbn [In]. rewrite IH. split; [|tauto].
      intros [E|]; [|tauto]. injection E as <- <-. auto.
    - exists L. intros t' i'. cbn [In]. rewrite IH. split; [tauto|].
      intros ([E|I] & F); [|tauto]. injection E as <- <-. contradiction. }
  destruct (K (list_prod tets (seq 0 (S d)))) as (L & HL).
  - intros t i I. now apply in_prod_iff in I.
  - exists L. intros t i. rewrite HL, in_prod_iff, in_seq_d. unfold Cone.hull_facet. tauto.
Qed.

(** ** Rays from o in general position *)

(** It is zero on a hyperplane through o that contains the face off vertices m and n. *)
Definition off_face u m n (p : point d) : R :=
  if Req_EM_T (bary (geo u) m o) 0 then bary (geo u) m p
  else bary (geo u) n o * bary (geo u) m p - bary (geo u) m o * bary (geo u) n p.
Definition generic_ray (y : point d) : Prop := forall u m n, In u tets -> (m <= d)%nat ->
  (n <= d)%nat -> m <> n -> forall s, 0 < s -> bary (geo u) m (mix o y s) = 0 ->
  bary (geo u) n (mix o y s) = 0 -> False.

Lemma generic_rays : exists F, (forall f, In f F -> affine f /\ exists p, f p <> 0) /\
  forall y, (forall f, In f F -> f y <> 0) -> generic_ray y.
Proof.
  set (I := list_prod tets (list_prod (seq 0 (S d)) (seq 0 (S d)))).
  set (J := filter (fun x => negb (Nat.eqb (fst (snd x)) (snd (snd x)))) I).
  exists (map (fun x => off_face (fst x) (fst (snd x)) (snd (snd x))) J). split.
  - intros f Hf. apply in_map_iff in Hf. destruct Hf as ([u [m n]] & <- & Hx).
    apply filter_In in Hx. destruct Hx as [Hx N]. unfold I in Hx. rewrite !in_prod_iff in Hx.
    destruct Hx as (Hu & Hm & Hn). apply in_seq_d in Hm, Hn. cbn [fst snd] in *.
    apply Bool.negb_true_iff, Nat.eqb_neq in N. unfold off_face.
    destruct (Req_EM_T (bary (geo u) m o) 0) as [Z|Z].
    + split; [now apply bary_affine|]. exists (vertex (geo u) m). rewrite bary_own by auto. lra.
    + split.
      * apply affine_ext with (fun p => bary (geo u) n o * bary (geo u) m p +
          (- bary (geo u) m o) * bary (geo u) n p); [intros; ring|].
        apply affine_combine; now apply bary_affine.
      * exists (vertex (geo u) n). rewrite bary_own, bary_other by auto. lra.
  - intros y G u m n Hu Hm Hn N s Ps Zm Zn. apply (G (off_face u m n)).
    + apply in_map_iff. exists (u, (m, n)). split; [reflexivity|]. apply filter_In. split.
      * unfold I. rewrite !in_prod_iff, !in_seq_d. auto.
      * apply Bool.negb_true_iff, Nat.eqb_neq. assumption.
    + rewrite affine_mix in Zm, Zn by now apply bary_affine. unfold off_face.
      destruct (Req_EM_T (bary (geo u) m o) 0) as [Z|Z].
      * rewrite Z in Zm. apply Rmult_eq_reg_l with s; lra.
      * apply Rmult_eq_reg_l with s; [|lra].
        transitivity (bary (geo u) n o * ((1 - s) * bary (geo u) m o + s * bary (geo u) m y) -
          bary (geo u) m o * ((1 - s) * bary (geo u) n o + s * bary (geo u) n y)); [ring|].
        rewrite Zm, Zn. ring.
Qed.

(** ** Where a ray leaves conv V *)

(** On the inner side of all hull facets is in a simplex. *)
Lemma covered p : tets <> [] -> (forall t i, hull_facet t i -> 0 <= bary (geo t) i p) ->
  exists u, In u tets /\ inside_closed (geo u) p.
Proof.
  intros NE I. apply (mesh_covers (complex_matched tets geo one_dimension agreeing different)
    vertex_in_V support p NE). intros t i Ht Hi O. apply I. now split.
Qed.

(** If a face of u off vertex m alone is on the hyperplane of a hull facet, it is a hull facet. *)
Lemma coplanar_outer t i u x : hull_facet t i -> In u tets -> inside_closed (geo u) x ->
  bary (geo t) i x = 0 ->
  (forall m n, (m <= d)%nat -> (n <= d)%nat -> m <> n -> bary (geo u) m x = 0 ->
     bary (geo u) n x = 0 -> False) ->
  exists m, hull_facet u m /\ bary (geo u) m x = 0 /\
    forall n, (n <= d)%nat -> n <> m -> 0 < bary (geo u) n x.
Proof.
  intros Ft Hu I Z Gen. pose proof Ft as (Ht & Hi & Out). set (B := bary (geo t) i) in *.
  assert (AB : affine B) by now apply bary_affine.
  assert (N : forall v n, In v tets -> (n <= d)%nat -> 0 <= B (vertex (geo v) n)).
  { intros v n Hv Hn. apply support; auto. now apply vertex_in_V. }
  assert (exists m, (m <= d)%nat /\ 0 < B (vertex (geo u) m)) as (m & Hm & Pm).
  { destruct (Exists_dec (fun k => 0 < B (vertex (geo u) k)) (seq 0 (S d))) as [X|X].
    - intros k. apply Rlt_dec.
    - apply Exists_exists in X. destruct X as (k & Hk & Pk). apply in_seq_d in Hk. eauto.
    - exfalso. pose proof (bary_own (geo t) i Hi) as E. fold B in E.
      rewrite (interpolation (geo u) B _ AB) in E. unfold sum in E.
      rewrite sum_zero in E; [lra|]. intros k Hk.
      destruct (Rlt_dec 0 (B (vertex (geo u) k))) as [Y|Y].
      + exfalso. apply X, Exists_exists. eauto.
      + apply in_seq_d in Hk. pose proof (N u k Hu Hk).
        replace (B (vertex (geo u) k)) with 0 by lra. ring. }
  assert (Zero : forall n, (n <= d)%nat -> bary (geo u) n x * B (vertex (geo u) n) = 0).
  { intros n Hn. assert (Q : 0 <= bary (geo u) n x * B (vertex (geo u) n)).
    { apply Rmult_le_pos; auto. }
    destruct (Rle_lt_or_eq_dec _ _ Q) as [Pos|]; [exfalso|congruence].
    rewrite (interpolation (geo u) B x AB) in Z.
    assert (0 < sum (S d) (fun k => bary (geo u) k x * B (vertex (geo u) k))); [|lra].
    apply sum_pos with n; auto; [|now apply in_seq_d].
    intros k Hk. apply in_seq_d in Hk. apply Rmult_le_pos; auto. }
  assert (Zm : bary (geo u) m x = 0).
  { pose proof (Zero m Hm) as E. apply Rmult_integral in E. destruct E; [assumption|lra]. }
  assert (Pos : forall n, (n <= d)%nat -> n <> m -> 0 < bary (geo u) n x).
  { intros n Hn Nm. destruct (Rle_lt_or_eq_dec _ _ (I n Hn)) as [|E]; [assumption|exfalso].
    now apply (Gen m n Hm Hn (fun E' => Nm (eq_sym E'))). }
  exists m. split; [|auto]. split; [assumption|]. split; [assumption|].
  intros v j (_ & Hv & O). pose proof O as (_ & Hj & _ & _ & Neg).
  pose proof (N v j Hv Hj) as Q.
  rewrite (interpolation (geo u) B _ AB) in Q. unfold sum in Q.
  rewrite (sum_one _ _ m) in Q; [nra|apply seq_NoDup|now apply in_seq_d|].
  intros n Hn Nm. apply in_seq_d in Hn. pose proof (Zero n Hn) as E. pose proof (Pos n Hn Nm).
  apply Rmult_integral in E. destruct E as [E|E]; [lra|]. rewrite E. ring.
Qed.

Theorem generic_exit y t0 i0 : generic_ray y -> hull_facet t0 i0 ->
  0 < progress (cone t0 i0) i0 y -> exists u j, hull_facet u j /\
    forall n, (n <= d)%nat -> n <> j -> 0 < bary (cone u j) n y.
Proof.
  intros Gen F0 P0. destruct hull_facet_list as (L & HL).
  destruct (smallest (fun x => - progress (cone (fst x) (snd x)) (snd x) y) L) as ([t i] & It & M).
  { intros E. apply HL in F0. rewrite E in F0. destruct F0. }
  apply HL in It. cbn [fst snd] in M.
  assert (P : 0 < progress (cone t i) i y).
  { specialize (M (t0, i0) (proj2 (HL t0 i0) F0)). cbn [fst snd] in M. lra. }
  pose proof It as (Ht & Hi & _). set (x := radial (cone t i) i o y).
  pose proof (Rinv_0_lt_compat _ P) as PI.
  destruct (covered x) as (u & Hu & I).
  { intros E. now rewrite E in Ht. }
  { intros v j Fv. specialize (M (v, j) (proj2 (HL v j) Fv)). cbn [fst snd] in M.
    pose proof Fv as (_ & Hj & _). unfold x, radial.
    rewrite (along_ray (geo v) (cone v j) j o Hj (cones v j Fv)).
    apply Rmult_le_pos; [left; now apply interior|].
    assert (/ progress (cone t i) i y * progress (cone v j) j y <=
      / progress (cone t i) i y * progress (cone t i) i y) by (apply Rmult_le_compat_l; lra).
    rewrite Rinv_l in H by lra. lra. }
  destruct (coplanar_outer t i u x It Hu I) as (m & Fm & Zm & Pos).
  { now apply (on_facet (geo t) (cone t i) i o Hi (cones t i It)). }
  { intros m n Hm Hn N. now apply (Gen u m n Hu Hm Hn N (/ progress (cone t i) i y)). }
  exists u, m. split; [assumption|]. intros n Hn N. pose proof Fm as (_ & Hm & _).
  pose proof (cone_bary _ _ _ _ Hm (cones u m Fm) n x Hn N) as E.
  pose proof (cone_height _ _ _ _ Hm (cones u m Fm) x) as Q. rewrite Zm in Q.
  pose proof (interior u m Fm). assert (Z : bary (cone u m) m x = 0).
  { symmetry in Q. apply Rmult_integral in Q. destruct Q; [assumption|lra]. }
  rewrite Z in E. pose proof (Pos n Hn N) as Pn. unfold x at 1 in E. unfold radial in E.
  rewrite affine_mix in E by now apply bary_affine.
  rewrite (cone_at_origin _ _ _ _ Hm (cones u m Fm) n Hn N) in E.
  apply Rmult_lt_reg_l with (/ progress (cone t i) i y); [assumption|lra].
Qed.

(** ** Across a ridge *)

Theorem ridge_neighbour t i k : hull_facet t i -> (k <= d)%nat -> k <> i ->
  exists u j l, hull_facet u j /\ ~ (t = u /\ i = j) /\ (l <= d)%nat /\ l <> j /\
    same (facet_of (cone t i) k) (facet_of (cone u j) l).
Proof.
  intros Ft Hk Nk. pose proof Ft as (Ht & Hi & _). set (c := cone t i).
  set (z := facet_centre c k). assert (C : cone_of (geo t) i o c) by now apply cones.
  assert (Zk : bary c k z = 0) by (apply bary_facet_centre; [lia|assumption]).
  assert (Pz : forall m, (m <= d)%nat -> m <> k -> 0 < bary c m z).
  { intros m Hm N. apply bary_facet_centre_other; auto. lia. }
  assert (Iz : inside_closed c z) by (apply facet_centre_closed; [lia|assumption]).
  (* a third vertex *)
  assert (exists m, (m <= d)%nat /\ m <> i /\ m <> k) as (m & Hm & Ni & Nm).
  { destruct (Nat.eq_dec i 0), (Nat.eq_dec k 0); [exists 1%nat| | |exists 0%nat]; try lia.
    - destruct (Nat.eq_dec k 1); [exists 2%nat|exists 1%nat]; lia.
    - destruct (Nat.eq_dec i 1); [exists 2%nat|exists 1%nat]; lia. }
  assert (Prz : 0 < progress c i z) by (apply (progress_positive c i m z); auto).
  destruct hull_facet_list as (L & HL). destruct generic_rays as (F & FA & FG).
  (* the cone coordinates that are negative at z *)
  set (I := list_prod L (seq 0 (S d))).
  set (f (x : (A * nat) * nat) p := - bary (cone (fst (fst x)) (snd (fst x))) (snd x) p).
  assert (Af : forall x, In x I -> affine (f x)).
  { intros [[u j] n] Hx. apply in_prod_iff in Hx. destruct Hx as (_ & Hn). apply in_seq_d in Hn.
    apply affine_opp. now apply bary_affine. }
  assert (Apr : affine (progress c i)).
  { apply affine_ext with (fun p => 1 * 1 + (-1) * bary c i p); [intros; unfold progress; ring|].
    apply (affine_combine (fun _ => 1)); [apply affine_const|now apply bary_affine]. }
  set (G := progress c i :: positive_at f z I).
  assert (HG : forall g, In g G -> affine g /\ 0 < g z).
  { intros g [<-|Hg]; [now split|]. now apply (positive_at_in f z I Af). }
  destruct (nearby G z (mix (vertex c k) z 2) HG) as (e & He & K).
  set (y0 := mix z (mix (vertex c k) z 2) e).
  assert (Ey : bary c k y0 = - e).
  { unfold y0. rewrite !affine_mix, Zk, bary_own by (auto || now apply bary_affine). ring. }
  destruct (general_position F ((fun p => - bary c k p) :: G) y0 FA) as (y & Yg & Yf).
  { intros g [<-|Hg]; [split; [now apply affine_opp, bary_affine|rewrite Ey; lra]|].
    split; [now apply HG|]. apply K; [lra|assumption]. }
  assert (Neg : bary c k y < 0).
  { specialize (Yg _ (or_introl eq_refl)). cbn beta in Yg. lra. }
  destruct (generic_exit y t i (FG y Yf) Ft) as (u & j & Fu & Pos).
  { apply Yg. right. now left. }
  pose proof Fu as (Hu & Hj & _). set (c' := cone u j) in *.
  assert (C' : cone_of (geo u) j o c') by now apply cones.
  assert (Iz' : inside_closed c' z).
  { intros n Hn. destruct (Nat.eq_dec n j) as [->|N].
    - pose proof (cone_height (geo u) c' j o Hj C' z) as E. pose proof (interior u j Fu) as B.
      assert (Q : 0 <= bary (geo u) j z).
      { apply (inside_pos c); [now apply bary_affine|assumption|]. intros l Hl.
        destruct (Nat.eq_dec l i) as [->|Nl].
        - rewrite (cone_apex (geo t) c i o Hi C). lra.
        - rewrite (cone_vertex (geo t) c i o C l Hl Nl).
          apply support; [assumption|assumption|apply Fu|now apply vertex_in_V]. }
      apply Rmult_le_reg_r with (bary (geo u) j o); [assumption|]. lra.
    - destruct (Rle_dec 0 (bary c' n z)) as [|X]; [assumption|exfalso].
      assert (0 < f ((u, j), n) y).
      { apply (positive_at_out f z I).
        - intros g Hg. apply Yg. right. now right.
        - apply in_prod_iff. split; [now apply HL|now apply in_seq_d].
        - unfold f. cbn [fst snd]. fold c'. lra. }
      unfold f in H. cbn [fst snd] in H. fold c' in H. specialize (Pos n Hn N). lra. }
  assert (Prz' : 0 < progress c' j z).
  { destruct (Exists_dec (fun n => n <> j /\ 0 < bary c' n z) (seq 0 (S d))) as [X|X].
    - intros n. destruct (Nat.eq_dec n j); [right; tauto|].
      destruct (Rlt_dec 0 (bary c' n z)); [left; auto|right; tauto].
    - apply Exists_exists in X. destruct X as (n & Hn & N & Pn). apply in_seq_d in Hn.
      now apply (progress_positive c' j n z).
    - exfalso. pose proof (Pz m Hm Nm) as Q.
      rewrite (interpolation c' (bary c m) z (bary_affine c m Hm)) in Q. unfold sum in Q.
      rewrite sum_zero in Q; [lra|]. intros n Hn. destruct (Nat.eq_dec n j) as [->|N].
      + rewrite (cone_apex (geo u) c' j o Hj C'), (cone_at_origin (geo t) c i o Hi C m Hm Ni). ring.
      + assert (~ 0 < bary c' n z) by (intros Y; apply X, Exists_exists; eauto).
        apply in_seq_d in Hn. pose proof (Iz' n Hn). replace (bary c' n z) with 0 by lra. ring. }
  assert (J : incl (facet_of c k) (vertices c')).
  { intros v Hv. apply (in_facet_of c k v Hk) in Hv. destruct Hv as (n & Hn & N & ->).
    destruct (Nat.eq_dec n i) as [->|Nn].
    - rewrite (cone_apex (geo t) c i o Hi C), <- (cone_apex (geo u) c' j o Hj C').
      apply in_vertices. eauto.
    - rewrite (cone_vertex (geo t) c i o C n Hn Nn).
      pose proof (cones_agree tets geo V agreeing in_V support o cone interior cones t i u j z n
        Ft Fu Iz Iz' Prz Prz' Hn Nn (Pz n Hn N)) as Q.
      apply (in_facet_of _ _ _ Hj) in Q. destruct Q as (l & Hl & Nl & ->).
      rewrite <- (cone_vertex (geo u) c' j o C' l Hl Nl). apply in_vertices. eauto. }
  destruct (facet_index c' (facet_of c k)) as (l & Hl & E);
    [now apply facet_of_NoDup|now apply facet_of_length|assumption|].
  exists u, j, l. split; [assumption|]. split; [|split; [assumption|split; [|assumption]]].
  - intros [<- <-]. specialize (Pos k Hk Nk). fold c in Pos. unfold c' in Pos. fold c in Pos. lra.
  - intros ->. apply (not_in_facet_of c' j Hj). apply E, in_facet_of; [assumption|].
    exists i. split; [assumption|]. split; [congruence|].
    now rewrite (cone_apex (geo t) c i o Hi C), (cone_apex (geo u) c' j o Hj C').
Qed.
End RidgeNeighbours.
