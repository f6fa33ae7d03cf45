(** * Every generic point set has a Delaunay triangulation  (Book: Theorem 4.4)

    Let the points of S span R^d and have generic heights.  The simplices with vertices in S whose
    witness planes have no lifted point below them fill conv S:
    - over a point z of conv S that is on none of the hyperplanes that points of S span, take the
      lowest of all lifted simplices.  If a lifted point p were below its plane, one vertex could
      be exchanged for p, and the new simplex would be lower over z ([descent]);
    - any other point of conv S is a limit of such points z, and there are finitely many simplices
      ([covering]);
    - two of them meet in a shared face, by Prop. 4.2.
    So a generic set has a Delaunay triangulation, and by [Uniqueness.v] only one. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Independence Matched Cone.
From Circumspect Require Import LiftingMap Uniqueness Caratheodory.
Import ListNotations.
Open Scope R_scope.

Section Existence.
Context {d : nat}.
Implicit Types (p q v z : point d) (h : point d -> R) (S X : list (point d)) (s : simplex d)
  (t u : frame d) (ts : list (frame d)) (fs : list (point d -> R)).

Lemma conv_convex S p q e : conv S p -> conv S q -> 0 <= e <= 1 -> conv S (mix p q e).
Proof.
  intros (l & Hl & Tl & Cl) (m & Hm & Tm & Cm) He.
  set (times a := map (fun bp : R * point d => (a * fst bp, snd bp))).
  assert (T : forall a n, total (times a n) = a * total n).
  { intros a. induction n as [|[b v] n IH]; [cbn; ring|]. cbn [times map fst snd].
    fold (times a n). rewrite !total_cons, IH. ring. }
  assert (C : forall a n, combination (times a n) = scale a (combination n)).
  { intros a. induction n as [|[b v] n IH]; [symmetry; apply scale_origin|].
    cbn [times map fst snd]. fold (times a n).
    now rewrite !combination_cons, IH, scale_plus, scale_scale. }
  assert (In_times : forall a n b v, In (b, v) (times a n) -> exists c, In (c, v) n /\ b = a * c).
  { intros a n b v I. apply in_map_iff in I. destruct I as ([c w] & E & I).
    injection E as <- <-. now exists c. }
  assert (TA : forall k n : list (R * point d), total (k ++ n) = total k + total n).
  { clear. induction k as [|[a p] k IH]; intros n; cbn [app]; [cbn; ring|].
    rewrite !total_cons, IH. ring. }
  assert (CA : forall k n : list (R * point d),
    combination (k ++ n) = plus (combination k) (combination n)).
  { clear. induction k as [|[a p] k IH]; intros n; cbn [app]; [symmetry; apply origin_plus|].
    now rewrite !combination_cons, IH, plus_assoc. }
  exists (times (1 - e) l ++ times e m). split; [|split].
  - intros b v I. apply in_app_or in I. destruct I as [I|I]; apply In_times in I;
      destruct I as (c & I & ->); [destruct (Hl c v I)|destruct (Hm c v I)];
      (split; [apply Rmult_le_pos; lra|assumption]).
  - rewrite TA, !T, Tl, Tm. ring.
  - rewrite CA, !C, Cl, Cm. reflexivity.
Qed.

Lemma inside_closed_dec t q :
  {inside_closed t q} + {exists i, (i <= d)%nat /\ bary t i q < 0}.
Proof.
  destruct (Forall_dec (fun i => 0 <= bary t i q) (fun i => Rle_dec 0 (bary t i q))
    (seq 0 (Datatypes.S d))) as [F|F].
  - left. intros i Hi. rewrite Forall_forall in F. now apply F, in_seq_d.
  - right. apply neg_Forall_Exists_neg in F; [|intros i; apply Rle_dec].
    apply Exists_exists in F. destruct F as (i & Hi & N). exists i.
    split; [now apply in_seq_d|lra].
Qed.

(** The witness plane does not depend on the order of the vertices. *)
Lemma witness_same h t u p : same (vertices t) (vertices u) -> witness h t p = witness h u p.
Proof.
  intros [_ UT]. apply witness_unique; [apply witness_affine|]. intros i Hi.
  assert (V : In (vertex u i) (vertices t)) by (apply UT, in_vertices; eauto).
  apply in_vertices in V. destruct V as (k & Hk & ->). now apply witness_vertex.
Qed.

(** If p is below the witness plane of t, over an interior point z of t there is a lower simplex:
    p replaces the vertex whose coordinate is the first to vanish on the way from z away from p. *)
Lemma descent h S t z p : inside t z -> incl (vertices t) S -> In p S -> h p < witness h t p ->
  exists u, incl (vertices u) S /\ inside_closed u z /\ witness h u z < witness h t z.
Proof.
  intros Z It Hp Low.
  set (ups := filter (fun i => if Rlt_dec 0 (bary t i p) then true else false)
    (seq 0 (Datatypes.S d))).
  assert (Ups : forall i, In i ups <-> (i <= d)%nat /\ 0 < bary t i p).
  { intros i. unfold ups. rewrite filter_In, in_seq_d.
    destruct (Rlt_dec 0 (bary t i p)); intuition discriminate. }
  destruct (smallest (fun i => bary t i z / bary t i p) ups) as (i & Hi & Min).
  { destruct (positive_term (seq 0 (Datatypes.S d)) (fun i => bary t i p)) as (i & Hi & P).
    - pose proof (bary_sum t p) as E. unfold sum in E. lra.
    - intros E. assert (I : In i ups) by (apply Ups; split; [now apply in_seq_d|assumption]).
      now rewrite E in I. }
  apply Ups in Hi. destruct Hi as [Hi Pi].
  destruct (cone_exists t i p Hi) as (u & C); [lra|].
  assert (Own : bary u i z * bary t i p = bary t i z).
  { symmetry. now apply (cone_height t u i p). }
  set (r := bary u i z) in *.
  assert (Er : r = bary t i z / bary t i p) by (rewrite <- Own; field; lra).
  assert (Pr : 0 < r).
  { rewrite Er. apply Rdiv_lt_0_compat; [now apply Z|assumption]. }
  exists u. split; [|split].
  - intros v Hv. apply in_vertices in Hv. destruct Hv as (k & Hk & ->). rewrite C by assumption.
    destruct (Nat.eq_dec k i); [assumption|]. apply It, in_vertices. eauto.
  - intros k Hk. destruct (Nat.eq_dec k i) as [->|N]; [fold r; lra|].
    rewrite (cone_bary t u i p Hi C k z Hk N). fold r. pose proof (Z k Hk) as Zk.
    destruct (Rlt_dec 0 (bary t k p)) as [P|P]; [|nra].
    specialize (Min k (proj2 (Ups k) (conj Hk P))). cbn beta in Min. rewrite <- Er in Min.
    assert (E : bary t k z / bary t k p * bary t k p = bary t k z) by (field; lra). nra.
  - pose proof (above_witness h u (witness h t) z (witness_affine h t)) as E.
    unfold sum in E. rewrite (sum_one _ _ i) in E; [|apply seq_NoDup|now apply in_seq_d|].
    + rewrite (C i Hi) in E. destruct (Nat.eq_dec i i); [|congruence]. fold r in E. nra.
    + intros k Hk N. apply in_seq_d in Hk. rewrite (C k Hk).
      destruct (Nat.eq_dec k i); [contradiction|]. rewrite witness_vertex by assumption. ring.
Qed.

(** ** All simplices and all hyperplanes *)
Section Spanned.
Context {S : list (point d)} {t0 : frame d} {ts : list (frame d)} {fs : list (point d -> R)}.
Context {h : point d -> R}.
Hypothesis spanning : incl (vertices t0) S.
Hypothesis vertices_in : forall t, In t ts -> incl (vertices t) S.
Hypothesis proper : forall f, In f fs -> affine f /\ exists p, f p <> 0.
Hypothesis complete : forall X, incl X S -> length X = Datatypes.S d ->
  (exists t, In t ts /\ same X (vertices t)) \/ (exists f, In f fs /\ flat X f).

Lemma listed u : incl (vertices u) S -> exists t, In t ts /\ same (vertices u) (vertices t).
Proof.
  intros I. destruct (complete (vertices u) I (vertices_length u)) as [|(f & _ & F)]; [assumption|].
  exfalso. now apply (frame_not_flat u f).
Qed.

Definition on_no_hyperplane z : Prop := (forall f, In f fs -> f z <> 0) /\
  forall t i, In t ts -> (i <= d)%nat -> bary t i z <> 0.

Lemma listed_inside t z : on_no_hyperplane z -> In t ts -> inside_closed t z -> inside t z.
Proof.
  intros [_ G] Ht I i Hi. pose proof (G t i Ht Hi). specialize (I i Hi). lra.
Qed.

(** Over such a point, the lowest simplex has no lifted point below its plane. *)
Lemma lowest z : on_no_hyperplane z -> conv S z ->
  exists t, In t ts /\ inside t z /\ forall p, In p S -> witness h t p <= h p.
Proof.
  intros G C.
  set (over := filter (fun t => if inside_closed_dec t z then true else false) ts).
  assert (Over : forall t, In t over <-> In t ts /\ inside_closed t z).
  { intros t. unfold over. rewrite filter_In.
    destruct (inside_closed_dec t z) as [I|(i & Hi & N)]; [intuition discriminate|].
    split; [intros []; discriminate|]. intros [_ I]. specialize (I i Hi). lra. }
  destruct (smallest (fun t => witness h t z) over) as (t & Ht & Min).
  { destruct (caratheodory S z C) as (X & I & L & CX).
    destruct (complete X I L) as [(t & Ht & E)|(f & Hf & F & _ & Z)].
    - intros N. assert (In t over) as B; [|now rewrite N in B].
      apply Over. split; [assumption|]. apply conv_vertices. now apply (conv_same X).
    - exfalso. apply (proj1 G f Hf).
      assert (0 <= f z) by (apply (affine_conv f X z F); [intros v Hv; rewrite Z; auto; lra|auto]).
      assert (0 <= - f z); [|lra].
      apply (affine_conv (fun p => - f p) X z); [now apply affine_opp| |assumption].
      intros v Hv. rewrite Z; auto; lra. }
  apply Over in Ht. destruct Ht as [Ht I]. pose proof (listed_inside t z G Ht I) as Z.
  exists t. split; [assumption|]. split; [assumption|]. intros p Hp.
  destruct (Rle_dec (witness h t p) (h p)) as [|Low]; [assumption|exfalso].
  destruct (descent h S t z p Z (vertices_in t Ht) Hp ltac:(lra)) as (u & Iu & Zu & Lu).
  destruct (listed u Iu) as (u' & Hu & E).
  assert (In u' over).
  { apply Over. split; [assumption|]. apply conv_vertices.
    apply (conv_same (vertices u)); [assumption|]. now apply conv_vertices. }
  specialize (Min u' H). rewrite <- (witness_same h u u' z E) in Min. lra.
Qed.

(** The simplices whose planes have no lifted point below them cover conv S. *)
Definition lower t : bool :=
  if Forall_dec (fun p => witness h t p <= h p) (fun p => Rle_dec (witness h t p) (h p)) S
  then true else false.
Lemma lower_spec t : lower t = true <-> forall p, In p S -> witness h t p <= h p.
Proof.
  unfold lower. destruct (Forall_dec _ _ S) as [F|F]; rewrite Forall_forall in F;
    intuition discriminate.
Qed.

Theorem covering q : conv S q -> exists t, In t ts /\ lower t = true /\ inside_closed t q.
Proof.
  intros Cq.
  (* otherwise q is strictly outside each of them, and so are all points nearby *)
  assert (H : forall l, (exists t, In t l /\ lower t = true /\ inside_closed t q) \/
    exists G : list (point d -> R), (forall g, In g G -> affine g /\ 0 < g q) /\
      forall t, In t l -> lower t = true -> exists i, (i <= d)%nat /\ In (fun z => - bary t i z) G).
  { induction l as [|t l IH]; [right; exists []; split; [intros g []|intros t []]|].
    destruct IH as [(u & Hu & X)|(G & P & K)]; [left; exists u; split; [now right|assumption]|].
    destruct (inside_closed_dec t q) as [I|(i & Hi & N)].
    - destruct (lower t) eqn:L; [left; exists t; split; [now left|auto]|].
      right. exists G. split; [assumption|]. intros u [<-|Hu] Lu; [congruence|auto].
    - right. exists ((fun z => - bary t i z) :: G). split.
      + intros g [<-|Hg]; [split; [now apply affine_opp, bary_affine|lra]|auto].
      + intros u [<-|Hu] Lu; [exists i; split; [assumption|now left]|].
        destruct (K u Hu Lu) as (k & Hk & J). exists k. split; [assumption|now right]. }
  destruct (H ts) as [|(G & P & K)]; [assumption|exfalso]. clear H.
  set (y := barycentre t0). destruct (nearby G q y P) as (e & He & Near).
  (* z = mix q y' e with y' in the interior of t0 *)
  set (back := map (fun i z => bary t0 i (mix q z (/ e))) (seq 0 (Datatypes.S d))).
  assert (Inv : forall z, mix q (mix q z (/ e)) e = z).
  { intros z. apply affine_separate. intros f F. rewrite !(affine_mix f) by assumption. field.
    lra. }
  assert (Inv' : mix q (mix q y e) (/ e) = y).
  { apply affine_separate. intros f F. rewrite !(affine_mix f) by assumption. field. lra. }
  destruct (general_position (fs ++ flat_map (fun t => map (bary t) (seq 0 (Datatypes.S d))) ts)
    (G ++ back) (mix q y e)) as (z & Z1 & Z2).
  - intros f Hf. apply in_app_or in Hf. destruct Hf as [Hf|Hf]; [auto|].
    apply in_flat_map in Hf. destruct Hf as (t & Ht & Hf). apply in_map_iff in Hf.
    destruct Hf as (i & <- & Hi). apply in_seq_d in Hi. split; [now apply bary_affine|].
    exists (vertex t i). rewrite bary_own by assumption. lra.
  - intros g Hg. apply in_app_or in Hg. destruct Hg as [Hg|Hg].
    + split; [now apply P|]. apply Near; [lra|assumption].
    + apply in_map_iff in Hg. destruct Hg as (i & <- & Hi). apply in_seq_d in Hi. split.
      * apply affine_ext with (fun z => (1 - / e) * (fun _ => bary t0 i q) z + / e * bary t0 i z).
        -- intros x. now rewrite (affine_mix (bary t0 i)) by now apply bary_affine.
        -- apply affine_combine; [apply affine_const|now apply bary_affine].
      * rewrite Inv'. now apply barycentre_inside.
  - assert (Gz : on_no_hyperplane z).
    { split; [intros f Hf; apply Z2, in_or_app; now left|]. intros t i Ht Hi. apply (Z2 (bary t i)).
      apply in_or_app. right. apply in_flat_map. exists t. split; [assumption|].
      apply in_map. now apply in_seq_d. }
    assert (Cz : conv S z).
    { rewrite <- (Inv z). apply conv_convex; [assumption| |lra].
      apply (conv_incl (vertices t0)); [assumption|]. apply conv_vertices. intros i Hi. left.
      apply (Z1 (fun z => bary t0 i (mix q z (/ e)))), in_or_app. right.
      apply (in_map (fun i z => bary t0 i (mix q z (/ e)))). now apply in_seq_d. }
    destruct (lowest z Gz Cz) as (t & Ht & I & L). apply lower_spec in L.
    destruct (K t Ht L) as (i & Hi & J).
    specialize (Z1 _ (in_or_app _ _ _ (or_introl J))). cbn beta in Z1. specialize (I i Hi). lra.
Qed.
End Spanned.

(** ** No simplex twice *)
Lemma same_dec (X Y : list (point d)) : {same X Y} + {~ same X Y}.
Proof.
  assert (I : forall X Y : list (point d), {incl X Y} + {~ incl X Y}).
  { clear. intros X Y. destruct (Forall_dec (fun v => In v Y) (fun v => in_points v Y) X) as [F|F];
      rewrite Forall_forall in F; [left|right]; assumption. }
  destruct (I X Y), (I Y X); [left; now split|right; intros []; contradiction..].
Qed.
Lemma without_repetition (l : list (frame d)) : exists m, incl m l /\
  ForallOrdPairs (fun s r => ~ same s r) (map vertices m) /\
  forall t, In t l -> exists u, In u m /\ same (vertices t) (vertices u).
Proof.
  induction l as [|t l (m & I & D & K)].
  - exists []. split; [intros t []|]. split; [constructor|intros t []].
  - destruct (Exists_dec (fun u => same (vertices t) (vertices u)) m (fun u => same_dec _ _))
      as [E|E].
    + exists m. split; [now apply incl_tl|]. split; [assumption|]. intros u [<-|Hu]; [|auto].
      now apply Exists_exists in E.
    + exists (t :: m). split; [|split].
      * intros u [<-|Hu]; [now left|right; auto].
      * cbn [map]. constructor; [|assumption]. apply Forall_forall. intros s Hs X.
        apply in_map_iff in Hs. destruct Hs as (u & <- & Hu). apply E, Exists_exists. eauto.
      * intros u [<-|Hu]; [exists t; split; [now left|split; apply incl_refl]|].
        destruct (K u Hu) as (w & Hw & X). exists w. split; [now right|assumption].
Qed.

(** Points with generic heights have a triangulation (perhaps of some of them) whose simplices
    have witness planes. *)
Theorem existence_heights h S : spans S -> generic_heights h S ->
  exists T, fills S T /\ forall s, In s T -> witness_plane h S s.
Proof.
  intros (X & IX & LX & Ind) G. destruct (frame_of X LX Ind) as (t0 & E0).
  assert (Sp : incl (vertices t0) S) by now rewrite E0.
  destruct (all_frames S t0) as (ts & fs & V & P & K).
  destruct (without_repetition (filter (lower (S := S) (h := h)) ts)) as (m & I & D & All).
  assert (W : forall t, In t m -> witness_plane h S (vertices t)).
  { intros t Ht. apply I, filter_In in Ht. destruct Ht as [Ht L]. apply witness_plane_witness.
    now apply lower_spec. }
  assert (Vm : forall t, In t m -> incl (vertices t) S).
  { intros t Ht. apply I, filter_In in Ht. now apply V. }
  assert (St : forall t, In t m -> strong_witness_plane h S (vertices t)).
  { intros t Ht. apply generic_strong; auto using vertices_NoDup, vertices_length. }
  exists (simplices m (fun t => t)).
  assert (Mem : forall s, In s (simplices m (fun t => t)) -> exists t, In t m /\ s = vertices t).
  { intros s Hs. now apply in_simplices in Hs. }
  split; [|intros s Hs; destruct (Mem s Hs) as (t & Ht & ->); auto].
  split; [apply simplices_length|]. split; [|split; [exact D|split]].
  - apply frames_complex. intros t u Ht Hu. apply (meet_agree t u (meet (vertices u) (vertices t))).
    + intros v Hv. now apply in_meet in Hv.
    + intros v Hv. now apply in_meet in Hv.
    + intros q. apply (planes_meet h S); auto.
  - intros s Hs. destruct (Mem s Hs) as (t & Ht & ->). auto.
  - intros q. split.
    + intros C. destruct (covering (h := h) Sp V P K q C) as (t & Ht & L & J).
      destruct (All t) as (u & Hu & E); [apply filter_In; now split|].
      exists (vertices u). split; [apply in_simplices; eauto|].
      apply (conv_same (vertices t)); [assumption|]. now apply conv_vertices.
    + intros (s & Hs & C). destruct (Mem s Hs) as (t & Ht & ->).
      now apply (conv_incl (vertices t)); auto.
Qed.

(** ** Delaunay *)

(** Section 4.2: "Every point in S is trivially a strongly Delaunay vertex." *)
Lemma strongly_delaunay_vertex S p : strongly_delaunay S [p].
Proof.
  exists p, 0. split.
  - intros v [<-|[]]. unfold dist2. rewrite minus_self. apply inner_origin.
  - intros q _ L. left. pose proof (norm2_nonneg (minus p q)) as N. unfold dist2 in L.
    assert (Z : norm2 (minus p q) = 0) by lra. apply norm2_zero in Z.
    rewrite <- (minus_plus p q), Z. apply origin_plus.
Qed.
Lemma point_independent p : affinely_independent [p].
Proof.
  intros [|a [|b l]] L T _ c Hc; try discriminate. cbn in T. destruct Hc as [<-|[]]. lra.
Qed.

Theorem existence S : spans S -> generic S -> exists T, delaunay_triangulation S T.
Proof.
  intros Sp G. apply generic_heights_norm2 in G.
  destruct (existence_heights norm2 S Sp G) as (T & F & W). exists T. split; [split|].
  - assumption.
  - intros p Hp. destruct (proposition_4_3_heights norm2 S T [p] F W) as (_ & _ & t & Ht & I).
    + apply strongly_delaunay_witness_plane; [intros v [<-|[]]; assumption|].
      apply strongly_delaunay_vertex.
    + apply point_independent.
    + discriminate.
    + intros v [<-|[]]. assumption.
    + exists t. split; [assumption|]. apply I. now left.
  - intros t Ht. apply delaunay_witness_plane. auto.
Qed.

(** Theorem 4.4: a generic point set has exactly one Delaunay triangulation, which consists of the
    strongly Delaunay simplices. *)
Theorem theorem_4_4_exactly_one S : spans S -> generic S -> exists T, delaunay_triangulation S T /\
  (forall s, faces_of T s <->
     s <> [] /\ incl s S /\ affinely_independent s /\ strongly_delaunay S s) /\
  forall U, delaunay_triangulation S U -> forall s, faces_of T s <-> faces_of U s.
Proof.
  intros Sp G. destruct (existence S Sp G) as (T & D). exists T. split; [assumption|]. split.
  - now apply generic_delaunay_complex.
  - intros U DU. now apply (theorem_4_4 S T U G).
Qed.
End Existence.
