(** * Adjacency: a triangulation is a matched mesh

    The definition of a triangulation speaks of faces, unions and convex hulls.  From it follows
    what a linear-time checker looks at: each facet is shared with one other simplex, on its other
    side ([one_side], [shared_facet]), or all points lie on its inner side ([facet_supports]).

    Two simplices on the same side of a shared facet would share interior points near it.  If some
    point p of S lies beyond a facet, then the points just beyond the facet's centre, towards p, are
    in conv S, hence in simplices of the triangulation; they are finitely many, so one of them
    contains the centre too.  It meets the first in a shared face that contains the centre, so that
    face is the facet. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Matched Faces Independence Facets.
Import ListNotations.
Open Scope R_scope.

(** ** Simplices with frames that make up a complex and cover conv S *)
Section Adjacency.
Context {d : nat} {A : Type} (tets : list A) (geo : A -> frame d) (V : list (point d)).
Hypothesis positive : (1 <= d)%nat.
Hypothesis agreeing : forall t u, In t tets -> In u tets -> agree (geo t) (geo u).
Hypothesis different : forall t u, In t tets -> In u tets ->
  same (vertices (geo t)) (vertices (geo u)) -> t = u.

(** An interior point of a simplex is in no other. *)
Lemma inside_once t u y : In t tets -> In u tets -> inside (geo t) y -> inside_closed (geo u) y ->
  t = u.
Proof.
  intros Ht Hu It Iu. apply different; [assumption..|].
  assert (H : incl (vertices (geo t)) (vertices (geo u))).
  { intros v Hv. apply in_vertices in Hv. destruct Hv as (i & Hi & ->).
    destruct (agreeing t u Ht Hu y (fun k Hk => Rlt_le _ _ (It k Hk)) Iu i Hi (It i Hi))
      as (k & Hk & -> & _). apply in_vertices. eauto. }
  split; [assumption|]. apply NoDup_length_incl; [apply vertices_NoDup| |assumption].
  rewrite !vertices_length. constructor.
Qed.

(** At most one simplex lies on each side of a facet ... *)
Lemma one_side t i u j : In t tets -> In u tets -> (i <= d)%nat -> (j <= d)%nat ->
  same (facet_of (geo t) i) (facet_of (geo u) j) -> 0 < bary (geo t) i (vertex (geo u) j) -> t = u.
Proof.
  intros Ht Hu Hi Hj E P.
  destruct (same_side_overlap (geo t) i (geo u) j positive Hi Hj E P) as (y & It & Iu).
  apply (inside_once t u y); auto. intros k Hk. left. auto.
Qed.
(** ... so two simplices that share a facet lie on opposite sides of it ... *)
Theorem shared_facet t i u j : In t tets -> In u tets -> t <> u -> (i <= d)%nat -> (j <= d)%nat ->
  same (facet_of (geo t) i) (facet_of (geo u) j) -> opposite (geo t) i (geo u) j.
Proof.
  intros Ht Hu N Hi Hj E. apply opposite_facets. split; [assumption|]. split; [assumption|].
  split; [assumption|]. pose proof (facet_multiple_nonzero _ _ _ _ Hi Hj E).
  destruct (Rlt_dec 0 (bary (geo t) i (vertex (geo u) j))) as [P|NP]; [|lra].
  exfalso. apply N. now apply (one_side t i u j).
Qed.
(** ... and no facet has two neighbours. *)
Lemma one_neighbour t i t' i' u j : In t tets -> In t' tets ->
  opposite (geo t) i (geo u) j -> opposite (geo t') i' (geo u) j -> t = t'.
Proof.
  intros Ht Ht' O O'. destruct (opposite_multiple _ _ _ _ O) as (c & C & M).
  destruct (opposite_multiple _ _ _ _ O') as (c' & C' & M').
  apply opposite_facets in O, O'. destruct O as (Hi & Hj & [TU UT] & _).
  destruct O' as (Hi' & _ & [TU' UT'] & _).
  apply (one_side t i t' i'); try assumption.
  - split; [now apply incl_tran with (facet_of (geo u) j)|].
    now apply incl_tran with (facet_of (geo u) j).
  - pose proof (M (vertex (geo t') i')) as E. rewrite M', bary_own in E by assumption. nra.
Qed.

(** [adjacent t i u j]: facet i of t is facet j of u; [outer t i]: it is no other's. *)
Definition adjacent t i u j : Prop := In t tets /\ In u tets /\ opposite (geo t) i (geo u) j.
Definition outer t i : Prop := forall u j, ~ adjacent t i u j.

Lemma adjacent_sym t i u j : adjacent t i u j -> adjacent u j t i.
Proof. intros (Ht & Hu & O). unfold adjacent. auto using opposite_sym. Qed.
Lemma adjacent_dec t i : In t tets -> (exists u j, adjacent t i u j) \/ outer t i.
Proof.
  intros Ht.
  destruct (Exists_dec (fun u => Exists (fun j => opposite (geo t) i (geo u) j) (seq 0 (S d))) tets)
    as [X|N].
  - intros u. apply Exists_dec. intros j. apply opposite_dec.
  - left. apply Exists_exists in X. destruct X as (u & Hu & X). apply Exists_exists in X.
    destruct X as (j & _ & O). exists u, j. split; auto.
  - right. intros u j (_ & Hu & O). apply N, Exists_exists. exists u. split; [assumption|].
    apply Exists_exists. exists j. split; [|assumption]. apply in_seq_d. apply O.
Qed.

Theorem complex_matched : matched tets geo adjacent outer.
Proof.
  split.
  - intros t i u j _ (_ & Hu & _). assumption.
  - intros t i u j _ (_ & _ & O). assumption.
  - intros t i t' i' u j Ht Ht' (_ & _ & O) (_ & _ & O'). now apply (one_neighbour t i t' i' u j).
  - intros t i Ht _. now apply adjacent_dec.
Qed.

(** Every interior point of a simplex is covered once. *)
Theorem complex_covered_once t o : In t tets -> inside (geo t) o -> covered_once tets geo o t.
Proof.
  intros Ht I. split; [assumption|]. split; [assumption|]. intros u Hu N.
  destruct (Forall_dec (fun i => 0 <= bary (geo u) i o)) with (l := seq 0 (S d)) as [F|F].
  - intros i. apply Rle_dec.
  - exfalso. apply N. symmetry. apply (inside_once t u o); try assumption.
    intros i Hi. apply in_seq_d in Hi. now apply (proj1 (Forall_forall _ _) F).
  - apply neg_Forall_Exists_neg in F; [|intros; apply Rle_dec].
    apply Exists_exists in F. destruct F as (i & Hi & L). exists i.
    split; [now apply in_seq_d|lra].
Qed.

(** ** Facets without a neighbour support conv V *)
Hypothesis in_V : forall t, In t tets -> incl (vertices (geo t)) V.
Hypothesis covering : forall q, conv V q -> exists t, In t tets /\ inside_closed (geo t) q.

(** Either a simplex contains q and leads from there towards p, or the points just beyond q
    towards p are in no simplex. *)
Lemma towards q p (l : list A) :
  (exists u, In u l /\ inside_closed (geo u) q /\
     forall k, (k <= d)%nat -> bary (geo u) k q = 0 -> 0 <= bary (geo u) k p) \/
  (exists e0, 0 < e0 < 1 /\ forall e, 0 < e <= e0 -> forall u, In u l ->
     ~ inside_closed (geo u) (mix q p e)).
Proof.
  induction l as [|u l IH]; [right; exists (1/2); split; [lra|intros e _ u []]|].
  destruct IH as [(u' & Hu' & I)|(e0 & He0 & K)]; [left; exists u'; split; [now right|assumption]|].
  set (good k := 0 < bary (geo u) k q \/ bary (geo u) k q = 0 /\ 0 <= bary (geo u) k p).
  assert (good_dec : forall k, {good k} + {~ good k}).
  { intros k. unfold good. destruct (Rlt_dec 0 (bary (geo u) k q)); [left; auto|].
    destruct (Req_EM_T (bary (geo u) k q) 0), (Rle_dec 0 (bary (geo u) k p));
      (left; tauto) || (right; tauto). }
  destruct (Forall_dec good good_dec (seq 0 (S d))) as [F|F].
  - left. rewrite Forall_forall in F. exists u. split; [now left|].
    split; intros k Hk; apply in_seq_d, F in Hk; destruct Hk as [L|[E L]]; lra.
  - right. apply neg_Forall_Exists_neg in F; [|assumption].
    apply Exists_exists in F. destruct F as (k & Hk & N). apply in_seq_d in Hk.
    assert (exists e1, 0 < e1 < 1 /\ forall e, 0 < e <= e1 -> bary (geo u) k (mix q p e) < 0)
      as (e1 & He1 & K1).
    { destruct (Rlt_dec (bary (geo u) k q) 0) as [L|NL].
      - destruct (nearby [fun x => - bary (geo u) k x] q p) as (e1 & He1 & K1).
        { intros g [<-|[]]. split; [now apply affine_opp, bary_affine|lra]. }
        exists e1. split; [assumption|]. intros e He.
        specialize (K1 e ltac:(lra) _ (or_introl eq_refl)). cbn beta in K1. lra.
      - exists (1/2). split; [lra|]. intros e He. rewrite affine_mix by now apply bary_affine.
        unfold good in N. assert (bary (geo u) k q = 0) as -> by lra.
        assert (bary (geo u) k p < 0) by lra. nra. }
    exists (Rmin e0 e1). pose proof (Rmin_l e0 e1). pose proof (Rmin_r e0 e1). split.
    + split; [apply Rmin_glb_lt|]; lra.
    + intros e He u' [<-|Hu'] I; [|apply (K e ltac:(lra) u' Hu' I)].
      specialize (I k Hk). specialize (K1 e ltac:(lra)). lra.
Qed.

(** A simplex that contains the centre of a facet has the facet. *)
Lemma centre_facet t i u : In t tets -> In u tets -> (i <= d)%nat ->
  inside_closed (geo u) (facet_centre (geo t) i) ->
  exists j, (j <= d)%nat /\ same (facet_of (geo t) i) (facet_of (geo u) j).
Proof.
  intros Ht Hu Hi I. apply facet_index; [now apply facet_of_NoDup|now apply facet_of_length|].
  intros v Hv. apply (in_facet_of _ _ _ Hi) in Hv. destruct Hv as (k & Hk & N & ->).
  destruct (agreeing t u Ht Hu _ (facet_centre_closed (geo t) i positive Hi) I k Hk)
    as (l & Hl & -> & _); [now apply bary_facet_centre_other|]. apply in_vertices. eauto.
Qed.

Theorem facet_supports : supporting tets geo outer (fun p => In p V).
Proof.
  intros t i Ht Hi O p Hp. destruct (Rle_dec 0 (bary (geo t) i p)) as [|N]; [assumption|exfalso].
  set (q := facet_centre (geo t) i).
  assert (Z : bary (geo t) i q = 0) by now apply bary_facet_centre.
  destruct (towards q p tets) as [(u & Hu & I & K)|(e & He & K)].
  - destruct (centre_facet t i u Ht Hu Hi I) as (j & Hj & E). apply (O u j).
    split; [assumption|]. split; [assumption|]. apply opposite_facets.
    split; [assumption|]. split; [assumption|]. split; [assumption|].
    pose proof (facet_multiple_nonzero _ _ _ _ Hi Hj E) as NZ.
    pose proof (facet_multiple _ _ _ _ Hi Hj E) as M.
    assert (Zu : bary (geo u) j q = 0).
    { pose proof (M q) as Mq. rewrite Z in Mq. symmetry in Mq. apply Rmult_integral in Mq.
      destruct Mq; [contradiction|assumption]. }
    pose proof (K j Hj Zu) as Pj. pose proof (M p) as Mp. nra.
  - assert (C : conv V q).
    { apply (conv_incl (vertices (geo t))); [now apply in_V|].
      apply conv_vertices. now apply facet_centre_closed. }
    destruct (covering (mix q p e)) as (u & Hu & I); [apply conv_mix; auto; lra|].
    apply (K e ltac:(lra) u Hu I).
Qed.
End Adjacency.

(** ** Triangulations by their definition *)
Section Triangulation.
Context {d : nat}.
Implicit Types (S : list (point d)) (T : list (simplex d)).

Lemma fills_frame S T s : fills S T -> In s T -> exists t : frame d, vertices t = s.
Proof.
  intros (L & (I & _ & _) & _) Hs. destruct (L s Hs) as [N Ls]. apply frame_of; [assumption|].
  apply I. split; [assumption|]. split; [|exists s; split; [assumption|apply incl_refl]].
  intros ->. discriminate.
Qed.

Lemma fills_geo S T : fills S T -> T <> [] ->
  exists geo : nat -> frame d, forall t, (t < length T)%nat -> vertices (geo t) = nth t T [].
Proof.
  intros F NE.
  assert (H : exists ts : list (frame d), map vertices ts = T).
  { assert (H : forall s, In s T -> exists t : frame d, vertices t = s).
    { intros s Hs. now apply (fills_frame S T). }
    clear F NE. induction T as [|s T IH]; [now exists []|].
    destruct (H s) as (t & <-); [now left|]. destruct IH as (ts & <-).
    { intros s Hs. apply H. now right. }
    now exists (t :: ts). }
  destruct H as (ts & <-). destruct ts as [|t0 ts]; [contradiction|].
  exists (fun i => nth i (t0 :: ts) t0). intros i Hi.
  transitivity (nth i (map vertices (t0 :: ts)) (vertices t0)).
  - symmetry. apply map_nth.
  - now apply nth_indep.
Qed.

Lemma ordered_pairs {B} (R : B -> B -> Prop) (l : list B) (x : B) i j : ForallOrdPairs R l ->
  (i < j)%nat -> (j < length l)%nat -> R (nth i l x) (nth j l x).
Proof.
  intros F. revert i j. induction F as [|a l Fa F IH]; intros i j Hij Hj; [cbn in Hj; lia|].
  destruct j as [|j]; [lia|]. cbn [length nth] in *. destruct i as [|i].
  - rewrite Forall_forall in Fa. apply Fa, nth_In. lia.
  - apply IH; lia.
Qed.

(** What [fills] says about the frames. *)
Record framed S T (geo : nat -> frame d) : Prop := {
  framed_vertices : forall t, (t < length T)%nat -> vertices (geo t) = nth t T [];
  framed_agree : forall t u, In t (seq 0 (length T)) -> In u (seq 0 (length T)) ->
    agree (geo t) (geo u);
  framed_different : forall t u, In t (seq 0 (length T)) -> In u (seq 0 (length T)) ->
    same (vertices (geo t)) (vertices (geo u)) -> t = u;
  framed_in : forall t, In t (seq 0 (length T)) -> incl (vertices (geo t)) S;
  framed_covering : forall q, conv S q -> exists t, In t (seq 0 (length T)) /\
    inside_closed (geo t) q
}.

Lemma fills_framed S T : fills S T -> T <> [] -> exists geo, framed S T geo.
Proof.
  intros F NE. destruct (fills_geo S T F NE) as (geo & G). exists geo.
  destruct F as (L & (_ & _ & M) & D & V & U). split; [assumption|..].
  - intros t u Ht Hu. apply in_seq in Ht, Hu.
    assert (K : forall k, (k < length T)%nat -> faces_of T (vertices (geo k))).
    { intros k Hk. rewrite G by assumption. pose proof (nth_In T [] Hk) as I.
      destruct (L _ I) as [N Ls]. split; [assumption|]. split; [|eauto using incl_refl].
      intros E. rewrite E in Ls. discriminate. }
    destruct (M _ _ (K t ltac:(lia)) (K u ltac:(lia))) as (f & It & Iu & C).
    now apply meet_agree with f.
  - intros t u Ht Hu E. apply in_seq in Ht, Hu. rewrite !G in E by lia.
    destruct (lt_eq_lt_dec t u) as [[C|C]|C]; [exfalso| assumption |exfalso].
    + apply (ordered_pairs _ T [] t u D C); [lia|assumption].
    + apply (ordered_pairs _ T [] u t D C); [lia|]. destruct E. now split.
  - intros t Ht. apply in_seq in Ht. rewrite G by lia. apply V, nth_In. lia.
  - intros q C. apply U in C. destruct C as (s & Hs & C).
    destruct (In_nth T s [] Hs) as (t & Ht & E). exists t. split; [apply in_seq; lia|].
    apply conv_vertices. now rewrite G, E.
Qed.

(** A triangulation is a matched mesh whose hull facets support conv S, and in which every interior
    point of a simplex is covered once. *)
Theorem triangulation_matched S T : (1 <= d)%nat -> fills S T -> T <> [] ->
  exists geo : nat -> frame d,
    (forall t, (t < length T)%nat -> vertices (geo t) = nth t T []) /\
    let tets := seq 0 (length T) in
    matched tets geo (adjacent tets geo) (outer tets geo) /\
    supporting tets geo (outer tets geo) (fun p => In p S) /\
    (forall t o, In t tets -> inside (geo t) o -> covered_once tets geo o t).
Proof.
  intros P F NE. destruct (fills_framed S T F NE) as (geo & [G A D V C]). exists geo.
  split; [assumption|]. cbv zeta. split; [|split].
  - now apply complex_matched.
  - now apply facet_supports.
  - intros t o. now apply complex_covered_once.
Qed.

(** Two simplices that share a facet lie on opposite sides of it. *)
Theorem facet_between S T f s t : (1 <= d)%nat -> fills S T -> NoDup f -> length f = d ->
  In s T -> In t T -> incl f s -> incl f t -> ~ same s t ->
  exists (a b : frame d) i j, vertices a = s /\ vertices b = t /\ same f (facet_of a i) /\
    same f (facet_of b j) /\ opposite a i b j.
Proof.
  intros P F N L Hs Ht Is It NS.
  destruct (fills_framed S T F) as (geo & [G A D _ _]); [now intros ->|].
  destruct (In_nth T s [] Hs) as (a & Ha & Ea). destruct (In_nth T t [] Ht) as (b & Hb & Eb).
  rewrite <- G in Ea, Eb by assumption.
  destruct (facet_index (geo a) f N L) as (i & Hi & Fi); [now rewrite Ea|].
  destruct (facet_index (geo b) f N L) as (j & Hj & Fj); [now rewrite Eb|].
  exists (geo a), (geo b), i, j. repeat (split; [assumption|]).
  apply (shared_facet (seq 0 (length T)) geo P A D); try assumption; try (apply in_seq; lia).
  - intros ->. apply NS. rewrite <- Ea, Eb. split; apply incl_refl.
  - destruct Fi, Fj. split; eapply incl_tran; eassumption.
Qed.

(** A facet is a face of at most two simplices. *)
Theorem facet_of_two S T f s t u : (1 <= d)%nat -> fills S T -> NoDup f -> length f = d ->
  In s T -> In t T -> In u T -> incl f s -> incl f t -> incl f u ->
  same s t \/ same s u \/ same t u.
Proof.
  intros P F N L Hs Ht Hu Is It Iu.
  destruct (fills_framed S T F) as (geo & [G A D _ _]); [now intros ->|].
  destruct (In_nth T s [] Hs) as (a & Ha & Ea). destruct (In_nth T t [] Ht) as (b & Hb & Eb).
  destruct (In_nth T u [] Hu) as (c & Hc & Ec).
  destruct (Nat.eq_dec a b) as [<-|Nab]; [left; rewrite <- Ea, Eb; split; apply incl_refl|].
  destruct (Nat.eq_dec a c) as [<-|Nac]; [right; left; rewrite <- Ea, Ec; split; apply incl_refl|].
  destruct (Nat.eq_dec b c) as [<-|Nbc]; [right; right; rewrite <- Eb, Ec; split; apply incl_refl|].
  exfalso. rewrite <- G in Ea, Eb, Ec by assumption.
  destruct (facet_index (geo a) f N L) as (i & Hi & Fi); [now rewrite Ea|].
  destruct (facet_index (geo b) f N L) as (j & Hj & Fj); [now rewrite Eb|].
  destruct (facet_index (geo c) f N L) as (k & Hk & Fk); [now rewrite Ec|].
  assert (X : forall x y, (x < length T)%nat -> (y < length T)%nat -> x <> y ->
    forall l m, (l <= d)%nat -> (m <= d)%nat -> same f (facet_of (geo x) l) ->
    same f (facet_of (geo y) m) -> opposite (geo x) l (geo y) m).
  { intros x y Hx Hy Nxy l m Hl Hm [] [].
    apply (shared_facet (seq 0 (length T)) geo P A D); try assumption; try (apply in_seq; lia).
    split; eapply incl_tran; eassumption. }
  apply Nab. apply (one_neighbour (seq 0 (length T)) geo P A D a i b j c k);
    try (apply in_seq; lia); apply X; auto.
Qed.
End Triangulation.
