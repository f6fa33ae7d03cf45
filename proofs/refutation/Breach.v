(** * Breaches: in which ways a list of simplices fails to be a Delaunay triangulation

    One definition for each rule that the oracle may report, in words about points alone, and for
    each the proof that a list that breaks the rule is not what it claims to be.  [L] lists the
    simplices as their author wrote them down: a vertex that names no point is [None].  A breach
    says that some simplices and points break the rule, not which; whoever has [S] and [L] can
    look.  Points are their coordinates: a point that is listed twice is one point. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Independence Adjacency
  LiftingMap.
Import ListNotations.
Open Scope R_scope.

Section Breach.
Context {d : nat}.
Implicit Types (S : list (point d)) (L : list (list (option (point d)))) (s t u f : simplex d).

(** What the three claims have in common. *)
Definition claims_to_fill S L : Prop := exists T, L = map (map Some) T /\ fills S T.

(** What they have in common with those about domains: no simplex twice, and a complex. *)
Definition claims_complex L : Prop := exists T, L = map (map Some) T /\
  (forall t, In t T -> NoDup t /\ length t = Datatypes.S d) /\ simplicial_complex (faces_of T) /\
  ForallOrdPairs (fun s t => ~ same s t) T.
Lemma claims_fill_complex S L : claims_to_fill S L -> claims_complex L.
Proof. intros (T & E & D & C & P & _). exists T. auto. Qed.

(** ** Each breach refutes the claim *)

Lemma claims_triangulation_fill S L : claims_triangulation S L -> claims_to_fill S L.
Proof. intros (T & E & F & _). now exists T. Qed.
Lemma claims_delaunay_triangulation S L : claims_delaunay S L -> claims_triangulation S L.
Proof. intros (T & E & F & _). now exists T. Qed.
Lemma claims_weighted_delaunay_fill w S L : claims_weighted_delaunay w S L -> claims_to_fill S L.
Proof. intros (T & E & F & _). now exists T. Qed.

Lemma in_listed T (r : list (option (point d))) : In r (map (map Some) T) ->
  exists t, r = map Some t /\ In t T.
Proof. rewrite in_map_iff. intros (t & <- & H). eauto. Qed.
Lemma map_some_inj s t : map (@Some (point d)) s = map Some t -> s = t.
Proof. revert t. induction s as [|p s IH]; intros [|q t] E; try discriminate; [reflexivity|].
  injection E as <- E. f_equal. auto. Qed.
Lemma listed_in T s : listed (map (map Some) T) s -> In s T.
Proof. intros H. apply in_listed in H. destruct H as (t & E & H). apply map_some_inj in E.
  now subst. Qed.

Lemma member_face T s : (forall s, In s T -> length s = Datatypes.S d) ->
  simplicial_complex (faces_of T) -> In s T -> NoDup s -> faces_of T s.
Proof.
  intros N C H D. split; [assumption|]. split; [|exists s; split; [assumption|apply incl_refl]].
  intros ->. specialize (N [] H). discriminate.
Qed.

Section Refuted.
Variables (S : list (point d)) (L : list (list (option (point d)))).

Theorem wrong_dimension_refutes : wrong_dimension L -> ~ claims_complex L.
Proof.
  intros (s & H & N) (T & -> & D & _). apply in_listed in H. destruct H as (t & -> & H).
  apply N. rewrite map_length. now apply D.
Qed.

Theorem unknown_vertex_refutes : unknown_vertex L -> ~ claims_complex L.
Proof.
  intros (s & H & N) (T & -> & _). apply in_listed in H. destruct H as (t & -> & _).
  apply in_map_iff in N. destruct N as (p & E & _). discriminate.
Qed.

Theorem unused_point_refutes : unused_point S L -> ~ claims_triangulation S L.
Proof.
  intros (p & Hp & N) (T & -> & _ & V). destruct (V p Hp) as (t & Ht & I).
  apply (N (map Some t)); now apply in_map.
Qed.

Theorem uncovered_point_refutes : uncovered_point S L -> ~ claims_to_fill S L.
Proof.
  intros (p & Hp & _ & N) (T & -> & _ & _ & _ & _ & U).
  destruct (proj1 (U p) (conv_point S p Hp)) as (t & Ht & C).
  apply (N t); [|assumption]. unfold listed. now apply in_map.
Qed.

Theorem vertex_in_ball_refutes : vertex_in_ball S L -> ~ claims_delaunay S L.
Proof.
  intros (s & p & [H _] & Hp & N) (T & -> & _ & D). apply listed_in in H.
  destruct (D s H) as (c & r2 & B & E). exact (E p Hp (N c r2 B)).
Qed.

Theorem facet_not_local_refutes : facet_not_local L -> ~ claims_delaunay S L.
Proof.
  intros (s & t & f & u & v & [Hs _] & Ht & _ & _ & _ & _ & _ & Hv & _ & N)
    (T & -> & ((_ & _ & _ & V & _) & _) & D).
  apply listed_in in Hs, Ht. destruct (D s Hs) as (c & r2 & B & E).
  exact (E v (V t Ht v Hv) (N c r2 B)).
Qed.

Theorem point_below_plane_refutes w : point_below_plane (fun p => norm2 p - w p) S L ->
  ~ claims_weighted_delaunay w S L.
Proof.
  intros (s & p & [H _] & Hp & N) (T & -> & _ & D). apply listed_in in H.
  destruct (D s H) as (a & b & B & E). specialize (N a b B). specialize (E p Hp). cbn in *. lra.
Qed.

Theorem facet_below_plane_refutes w : facet_below_plane (fun p => norm2 p - w p) L ->
  ~ claims_weighted_delaunay w S L.
Proof.
  intros (s & t & f & u & v & [Hs _] & Ht & _ & _ & _ & _ & _ & Hv & _ & N) (T & ->
    & (_ & _ & _ & V & _) & D).
  apply listed_in in Hs, Ht. destruct (D s Hs) as (a & b & B & E).
  specialize (N a b B). specialize (E v (V t Ht v Hv)). cbn in *. lra.
Qed.

Theorem vertex_submerged_refutes w : vertex_submerged (fun p => norm2 p - w p) S L ->
  ~ claims_weighted_delaunay w S L.
Proof.
  intros (s & v & X & H & Hv & HX & _ & N) (T & -> & _ & D). apply listed_in in H.
  destruct (D s H) as (a & b & B & E). specialize (B v Hv). cbn in *.
  specialize (N a b (fun p I => E p (HX p I))). lra.
Qed.

(** The breaches of a simplicial complex. *)

Theorem duplicate_simplex_refutes : duplicate_simplex L -> ~ claims_complex L.
Proof.
  intros (L1 & L2 & L3 & s & t & -> & _ & _ & E) (T & ET & _ & _ & P).
  symmetry in ET. apply map_eq_app in ET. destruct ET as (T1 & R & -> & <- & ET).
  apply map_eq_cons in ET. destruct ET as (s' & R' & -> & Es & ET).
  apply map_eq_app in ET. destruct ET as (T2 & R'' & -> & <- & ET).
  apply map_eq_cons in ET. destruct ET as (t' & T3 & -> & Et & _).
  apply map_some_inj in Es, Et. subst s' t'. clear - E P.
  induction T1 as [|x T1 IH]; cbn in P; inversion P as [|? ? F P']; subst; [|auto].
  apply (proj1 (Forall_forall _ _) F t); [|assumption]. apply in_or_app. right. now left.
Qed.

Theorem repeated_vertex_refutes : repeated_vertex L -> ~ claims_complex L.
Proof.
  intros (r & i & j & p & H & N & Hi & Hj) (T & -> & D & _). apply in_listed in H.
  destruct H as (t & -> & H). destruct (D t H) as [ND _]. apply N.
  rewrite nth_error_map in Hi, Hj.
  destruct (nth_error t i) eqn:Ei, (nth_error t j) eqn:Ej; try discriminate.
  apply (NoDup_nth_error t); [assumption| |].
  - apply nth_error_Some. congruence.
  - cbn in Hi, Hj. congruence.
Qed.

Theorem degenerate_refutes : degenerate L -> ~ claims_complex L.
Proof.
  intros (s & H & N) (T & -> & D & C & _). apply listed_in in H. apply N.
  apply C. apply member_face; auto; [intros; now apply D | now apply D].
Qed.

Theorem facet_overused_refutes : facet_overused L -> ~ claims_to_fill S L.
Proof.
  intros (s & t & u & f & Hs & Ht & Hu & Nst & Ntu & Nsu & Nf & Lf & Is & It & Iu) (T & -> & F).
  apply listed_in in Hs, Ht, Hu. destruct (Nat.eq_dec d 0) as [Z|P].
  - (* all points of R^0 are the same *)
    assert (E : forall p q : point d, p = q).
    { clear - Z. subst d. intros p q. pattern p. apply Vector.case0. pattern q.
      now apply Vector.case0. }
    destruct F as (D & _). destruct (D s Hs) as [_ Ls], (D t Ht) as [_ Lt].
    apply Nst. split; intros p Hp.
    + destruct t as [|q t]; [discriminate|]. left. apply E.
    + destruct s as [|q s]; [discriminate|]. left. apply E.
  - destruct (facet_of_two S T f s t u) as [E|[E|E]]; auto; lia.
Qed.

Theorem overlap_refutes : overlap L -> ~ claims_complex L.
Proof.
  intros (s & t & q & Hs & Ht & Cs & Ct & N) (T & -> & D & C & _). apply listed_in in Hs, Ht.
  assert (F : forall s, In s T -> faces_of T s).
  { intros r Hr. apply member_face; auto; [intros; now apply D | now apply D]. }
  destruct C as (_ & _ & M). destruct (M s t (F s Hs) (F t Ht)) as (f & Fs & Ft & I).
  exact (N f Fs Ft (I q Cs Ct)).
Qed.

Theorem covered_twice_refutes : covered_twice L -> ~ claims_complex L.
Proof.
  intros (s & t & q & [Hs _] & [Ht _] & N & [Cs Face] & Ct) (T & -> & D & C & _).
  apply listed_in in Hs, Ht.
  assert (F : forall s, In s T -> faces_of T s).
  { intros r Hr. apply member_face; auto; [intros; now apply D | now apply D]. }
  destruct C as (_ & _ & M). destruct (M s t (F s Hs) (F t Ht)) as (f & Fs & Ft & I).
  assert (E : incl s t) by (apply incl_tran with f; [now apply Face; [|apply I]|assumption]).
  apply N. split; [assumption|]. destruct (D s Hs) as [Ns Ls], (D t Ht) as [Nt Lt].
  apply NoDup_length_incl; [assumption|lia|assumption].
Qed.
End Refuted.

(** ** How breaches show in barycentric coordinates *)

Section Shown.
Variables (a b : frame d).

(** A point beyond a facet is not in the simplex. *)
Lemma beyond_outside i q : (i <= d)%nat -> bary a i q < 0 -> ~ conv (vertices a) q.
Proof. intros Hi N C. apply conv_vertices in C. specialize (C i Hi). lra. Qed.

(** A point of two simplices with different carriers is in no shared face. *)
Lemma shared_carrier f q : incl f (vertices a) -> incl f (vertices b) -> conv f q ->
  incl (carrier a q) (carrier b q).
Proof.
  intros Ia Ib C. apply (conv_face a f q Ia) in C. destruct C as [Qa C].
  intros v Hv. apply in_carrier in Hv. destruct Hv as (i & Hi & P & ->).
  pose proof (Ib _ (C i Hi P)) as V. apply in_vertices in V. destruct V as (k & Hk & E).
  apply in_carrier. exists k. split; [assumption|]. split; [|assumption].
  rewrite (interpolation a (bary b k) q (bary_affine b k Hk)).
  apply sum_pos with i; [|now apply in_seq_d|].
  - intros j Hj. apply in_seq_d in Hj.
    destruct (Rle_lt_or_eq_dec _ _ (Qa j Hj)) as [Pj| <-]; [|lra].
    apply Rmult_le_pos; [lra|].
    pose proof (Ib _ (C j Hj Pj)) as V. apply in_vertices in V. destruct V as (m & Hm & ->).
    rewrite bary_vertex by assumption. destruct (Nat.eq_dec k m); lra.
  - rewrite E, bary_own by assumption. lra.
Qed.

(** A lifted point below the witness plane. *)
Lemma below_all_planes h p : h p < witness h a p ->
  forall c e, (forall v, In v (vertices a) -> plane c e v = h v) -> h p < plane c e p.
Proof.
  intros B c e V. rewrite (witness_unique h a (plane c e)); [assumption|apply affine_plane|].
  intros i Hi. apply V, in_vertices. eauto.
Qed.

(** A lifted point above a lifted simplex. *)
Lemma above_all_planes h v : inside_closed a v -> witness h a v < h v ->
  forall c e, (forall p, In p (vertices a) -> plane c e p <= h p) -> plane c e v < h v.
Proof.
  intros I B c e V. pose proof (above_witness h a (plane c e) v (affine_plane _ _)) as E.
  assert (N : 0 <= sum (Datatypes.S d) (fun i =>
                     bary a i v * - (plane c e (vertex a i) - h (vertex a i)))).
  { apply sum_nonneg. intros i Hi. apply in_seq_d in Hi. apply Rmult_le_pos; [now apply I|].
    assert (plane c e (vertex a i) <= h (vertex a i)) by (apply V, in_vertices; eauto). lra. }
  unfold sum in E, N.
  rewrite (sum_ext _ _ (fun i => -1 * (bary a i v * (plane c e (vertex a i) - h (vertex a i)))))
    in N by (intros; ring).
  rewrite sum_scale in N. lra.
Qed.
End Shown.

(** The Lifting Lemma: below every hyperplane is in every ball. *)
Lemma below_in_balls s p : (forall a b, (forall v, In v s -> plane a b v = norm2 v) ->
  norm2 p < plane a b p) -> forall c r2, circumball s c r2 -> dist2 c p < r2.
Proof.
  intros B c r2 C. apply lifting_lemma. apply (B (scale 2 c) (r2 - norm2 c)).
  intros v Hv. now apply (circumball_plane s c r2).
Qed.
Lemma point_below_in_ball S L : point_below_plane norm2 S L -> vertex_in_ball S L.
Proof. intros (s & p & Hs & Hp & B). exists s, p. eauto using below_in_balls. Qed.
Lemma facet_below_not_local L : facet_below_plane norm2 L -> facet_not_local L.
Proof.
  intros (s & t & f & u & v & Hs & Ht & Nf & Lf & Is & It & Hu & Hv & O & B). exists s, t, f, u, v.
  repeat (split; [assumption|]). eauto using below_in_balls.
Qed.

Lemma carriers_overlap (a b : frame d) q : ~ same (carrier a q) (carrier b q) ->
  forall f, incl f (vertices a) -> incl f (vertices b) -> ~ conv f q.
Proof.
  intros N f Ia Ib C. apply N.
  split; [exact (shared_carrier a b f q Ia Ib C) | exact (shared_carrier b a f q Ib Ia C)].
Qed.
End Breach.
