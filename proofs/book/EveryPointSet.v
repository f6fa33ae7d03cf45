(** * Every finite point set has a Delaunay triangulation  (Book: Sections 2.9 and 4.2)

    Lower the points of S by small powers of e ([Perturbation.v]).  For all small e > 0 the heights
    are generic: d+2 lifted points in a hyperplane make a polynomial in e vanish, which is not the
    zero polynomial ([generic_perturbed]).  So the perturbed points have a triangulation
    ([Existence.v]); and if e is small enough, its simplices pass the symbolic test, hence have
    witness planes over the heights that are not perturbed.  It is the only triangulation whose
    simplices pass ([canonical_unique]): one answer for every point set. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List ListDec Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Independence Adjacency.
From Circumspect Require Import Faces Perturbation LiftingMap Uniqueness Caratheodory Existence.
Import ListNotations.
Open Scope R_scope.

Section EveryPointSet.
Context {d : nat}.
Implicit Types (p q v : point d) (h : point d -> R) (S X : list (point d)) (s : simplex d)
  (t u : frame d) (T : list (simplex d)).

Lemma lead_nonzero l c : In c l -> c <> 0 -> lead l <> 0.
Proof.
  induction l as [|a l IH]; intros Hc Nc; [destruct Hc|]. cbn [lead].
  destruct Hc as [->|Hc]; destruct (Req_EM_T _ 0); auto; congruence.
Qed.
Lemma evaluate_sum {A B} (c : A -> R) (g : B -> A -> R) (l : list A) (m : list B) e :
  sum_over l (fun i => c i * evaluate (map (fun b => g b i) m) e) =
  evaluate (map (fun b => sum_over l (fun i => c i * g b i)) m) e.
Proof.
  induction m as [|b m IH]; cbn [map evaluate].
  - apply sum_zero. intros; ring.
  - rewrite <- IH, <- sum_scale, <- sum_plus. apply sum_ext. intros; ring.
Qed.

(** ** For all small e the perturbed heights are generic *)

(** A polynomial that vanishes whenever the lifted points of X are in a hyperplane. *)
Lemma hyperplane_polynomial S h X : NoDup X -> incl X S ->
  length X = Datatypes.S (Datatypes.S d) -> exists P, lead P <> 0 /\
  forall e a b, (forall v, In v X -> plane a b v = perturbed S h e v) -> evaluate P e = 0.
Proof.
  intros N I L. set (x i := nth i X origin).
  destruct (dependency x (seq 0 (length X))) as (c & (k & Hk & Nk) & C).
  { apply seq_NoDup. } { rewrite seq_length. lia. }
  exists (sum_over (seq 0 (length X)) (fun i => c i * h (x i)) ::
    map (fun v => -1 * sum_over (seq 0 (length X)) (fun i => c i * at_point v (x i))) S). split.
  - apply lead_nonzero with (-1 * c k); [|lra]. right. apply in_map_iff. exists (x k). split.
    + rewrite (sum_one _ _ k); [|apply seq_NoDup|assumption|].
      * unfold at_point. destruct (point_eq_dec (x k) (x k)); [ring|contradiction].
      * intros i Hi Ni. unfold at_point. destruct (point_eq_dec (x i) (x k)) as [E|]; [|ring].
        exfalso. apply in_seq in Hi, Hk. apply Ni. apply (NoDup_nth X origin); auto; lia.
    + apply I, nth_In. apply in_seq in Hk. lia.
  - intros e a b On. cbn [evaluate].
    pose proof (C (plane a b) (affine_plane a b)) as Z.
    rewrite (sum_ext _ _ (fun i => c i * h (x i) +
      - e * (c i * evaluate (map (fun v => at_point v (x i)) S) e))) in Z.
    + rewrite sum_plus, sum_scale, evaluate_sum in Z. rewrite <- Z.
      assert (E : forall (g : point d -> R) m, evaluate (map (fun v => -1 * g v) m) e =
        - evaluate (map g m) e).
      { intros g. induction m as [|v m IH]; cbn [map evaluate]; [ring|]. rewrite IH. ring. }
      rewrite E. ring.
    + intros i Hi. apply in_seq in Hi. rewrite On; [unfold perturbed, lowering; ring|].
      apply nth_In. lia.
Qed.

Theorem generic_perturbed S h : exists e0, 0 < e0 /\
  forall e, 0 < e < e0 -> generic_heights (perturbed S h e) S.
Proof.
  assert (H : forall l, (forall X, In X l -> incl X S /\ length X = Datatypes.S (Datatypes.S d)) ->
    exists Ps, (forall P, In P Ps -> lead P <> 0) /\ forall X, In X l -> NoDup X ->
      exists P, In P Ps /\ forall e a b,
        (forall v, In v X -> plane a b v = perturbed S h e v) -> evaluate P e = 0).
  { induction l as [|X l IH]; intros H; [exists []; split; intros P []|].
    destruct IH as (Ps & NZ & K); [intros Y HY; apply H; now right|].
    destruct (H X (or_introl eq_refl)) as [I L].
    assert (Dec : {NoDup X} + {~ NoDup X}) by apply (NoDup_dec point_eq_dec).
    destruct Dec as [N|N].
    - destruct (hyperplane_polynomial S h X N I L) as (P & Z & V). exists (P :: Ps). split.
      + intros Q [<-|HQ]; auto.
      + intros Y [<-|HY] NY; [exists P; split; [now left|assumption]|].
        destruct (K Y HY NY) as (Q & HQ & V'). exists Q. split; [now right|assumption].
    - exists Ps. split; [assumption|]. intros Y [<-|HY] NY; [contradiction|auto]. }
  destruct (H (tuples S (Datatypes.S (Datatypes.S d)))) as (Ps & NZ & K).
  { intros X. apply in_tuples. }
  destruct (one_epsilon Ps) as (e0 & P0 & E). exists e0. split; [assumption|].
  intros e He X N I L (a & b & On).
  destruct (K X) as (P & HP & V); [now apply in_tuples|assumption|].
  specialize (V e a b On). specialize (NZ P HP). destruct (E e He P HP) as (Pos & Neg & _).
  destruct (Rtotal_order (lead P) 0) as [X1|[X1|X1]]; [specialize (Neg X1); lra|contradiction|].
  specialize (Pos X1). lra.
Qed.

(** ** The symbolic test *)

(** It does not depend on the order of the vertices. *)
Lemma coefficients_same S h t u p : same (vertices t) (vertices u) ->
  coefficients S h t p = coefficients S h u p.
Proof.
  intros E. assert (A : forall k, above k t p = above k u p).
  { intros k. pose proof (witness_same k t u p E) as W. unfold above. now rewrite W. }
  unfold coefficients. rewrite A. f_equal. apply map_ext. intros v. now rewrite A.
Qed.

(** A simplex that passes has a witness plane over the heights that are not perturbed. *)
Theorem canonical_witness_plane S h t : canonical S h t -> witness_plane h S (vertices t).
Proof.
  intros C. apply witness_plane_witness. intros p Hp.
  destruct (in_points p (vertices t)) as [V|N].
  - apply in_vertices in V. destruct V as (i & Hi & ->).
    rewrite witness_vertex by assumption. lra.
  - specialize (C p Hp N). unfold coefficients in C. cbn [lead] in C.
    assert (E : above h t p = h p - witness h t p) by reflexivity.
    destruct (Req_EM_T (above h t p) 0); lra.
Qed.

(** For all small e the simplices that have a witness plane over the perturbed heights pass. *)
Theorem perturbed_canonical S h : spans S -> exists e0, 0 < e0 /\ forall e, 0 < e < e0 ->
  forall u, incl (vertices u) S -> witness_plane (perturbed S h e) S (vertices u) ->
    canonical S h u.
Proof.
  intros (X & IX & LX & Ind). destruct (frame_of X LX Ind) as (t0 & _).
  destruct (all_frames S t0) as (ts & fs & _ & _ & K).
  destruct (perturbation_sound S h ts) as (e0 & P0 & Sound). exists e0. split; [assumption|].
  intros e He u Iu W p Hp N. apply witness_plane_witness with (p := p) in W; [|assumption].
  destruct (K (vertices u) Iu (vertices_length u)) as [(t & Ht & E)|(f & _ & F)];
    [|now apply frame_not_flat in F].
  rewrite (coefficients_same S h u t p E).
  assert (Nt : ~ In p (vertices t)) by (intros I; apply N; now apply E).
  pose proof (no_ties S h t p Hp Nt) as NZ.
  destruct (Sound e He t p Ht Hp) as [_ Neg].
  destruct (Rtotal_order (lead (coefficients S h t p)) 0) as [L|[L|L]];
    [|contradiction|assumption].
  exfalso. apply Neg in L. rewrite (witness_same (perturbed S h e) u t p E) in W.
  assert (A : above (perturbed S h e) t p = perturbed S h e p - witness (perturbed S h e) t p)
    by reflexivity. lra.
Qed.

(** T has all its simplices pass the test. *)
Definition symbolic_triangulation S h T : Prop :=
  fills S T /\ forall s, In s T -> exists t, vertices t = s /\ canonical S h t.

(** It is the canonical triangulation of Definitions.v, which speaks of small numbers. *)
Lemma witness_plane_ext h k S s : incl s S -> (forall p, In p S -> h p = k p) ->
  witness_plane h S s -> witness_plane k S s.
Proof.
  intros I E (a & b & C & B). exists a, b. split.
  - intros v Hv. rewrite <- E by auto. auto.
  - intros p Hp. rewrite <- E by assumption. auto.
Qed.
Theorem symbolic_canonical S h T : NoDup S -> spans S ->
  (symbolic_triangulation S h T <-> canonical_triangulation S h T).
Proof.
  intros N Sp. split.
  - intros [F C]. split; [assumption|].
    assert (L : forall l, (forall s, In s l -> In s T) -> exists e0, 0 < e0 /\
      forall e, 0 < e < e0 ->
      forall s, In s l -> witness_plane (perturbed S h e) S s).
    { induction l as [|s l IH]; intros Hl; [exists 1; split; [lra|intros e _ s []]|].
      destruct IH as (e1 & P1 & K1); [intros; apply Hl; now right|].
      destruct (C s (Hl s (or_introl eq_refl))) as (t & <- & Ct).
      destruct (perturbation_sound S h [t]) as (e2 & P2 & K2).
      exists (Rmin e1 e2). split; [now apply Rmin_glb_lt|]. intros e He s' [<-|Hs'].
      - pose proof (Rmin_r e1 e2). apply witness_plane_witness. intros p Hp.
        destruct (in_points p (vertices t)) as [V|V].
        + apply in_vertices in V. destruct V as (i & Hi & ->).
          rewrite witness_vertex by assumption. lra.
        + destruct (K2 e ltac:(lra) t p (or_introl eq_refl) Hp) as [[K _] _].
          specialize (K (Ct p Hp V)). unfold above in K. lra.
      - pose proof (Rmin_l e1 e2). apply K1; [lra|assumption]. }
    destruct (L T (fun s H => H)) as (e0 & P & K). exists e0. split; [assumption|].
    intros e k He Lk s Hs. destruct F as (_ & _ & _ & V & _).
    apply (witness_plane_ext (perturbed S h e)); [now apply V| |now apply K].
    intros p Hp. symmetry. now apply lowered_perturbed.
  - intros [F (e0 & P & K)]. split; [assumption|].
    destruct (perturbed_canonical S h Sp) as (e1 & P1 & K1).
    intros s Hs. destruct (fills_frame S T s F Hs) as (t & <-). exists t. split; [reflexivity|].
    pose proof (Rmin_l e0 e1). pose proof (Rmin_r e0 e1). pose proof (Rmin_glb_lt _ _ _ P P1).
    apply (K1 (Rmin e0 e1 / 2)); [lra| |].
    + destruct F as (_ & _ & _ & V & _). now apply V.
    + apply (K (Rmin e0 e1 / 2)); [lra|now apply perturbed_lowered|assumption].
Qed.
(** There is only one. *)
Theorem canonical_once S h T U : NoDup S -> spans S -> canonical_triangulation S h T ->
  canonical_triangulation S h U -> same_simplices T U.
Proof.
  intros N Sp CT CU. apply symbolic_canonical in CT, CU; try assumption.
  destruct CT as [FT CT], CU as [FU CU]. split; intros s Hs.
  - apply (canonical_unique S h T U FT FU); [|assumption]. intros r [Hr|Hr]; auto.
  - apply (canonical_unique S h U T FU FT); [|assumption]. intros r [Hr|Hr]; auto.
Qed.

Lemma canonical_from_perturbed S h : spans S -> exists e0, 0 < e0 /\ forall e, 0 < e < e0 ->
  exists T, symbolic_triangulation S h T /\
    forall s, In s T -> witness_plane (perturbed S h e) S s.
Proof.
  intros Sp. destruct (generic_perturbed S h) as (e1 & P1 & Gen).
  destruct (perturbed_canonical S h Sp) as (e2 & P2 & Can).
  exists (Rmin e1 e2). split; [now apply Rmin_glb_lt|]. intros e He.
  pose proof (Rmin_l e1 e2). pose proof (Rmin_r e1 e2).
  destruct (existence_heights (perturbed S h e) S Sp) as (T & F & W); [apply Gen; lra|].
  exists T. split; [|assumption]. split; [assumption|]. intros s Hs.
  destruct (fills_frame S T s F Hs) as (t & E). exists t. split; [assumption|].
  apply (Can e); [lra| |rewrite E; auto]. rewrite E. destruct F as (_ & _ & _ & V & _). auto.
Qed.

(** With any heights there is exactly one canonical triangulation.  (Points may be submerged.) *)
Theorem canonical_exactly_one S h : spans S -> exists T, symbolic_triangulation S h T /\
  (forall s, In s T -> witness_plane h S s) /\
  forall U, symbolic_triangulation S h U ->
    (forall s, In s T -> exists r : simplex d, In r U /\ same s r) /\
    (forall s, In s U -> exists r : simplex d, In r T /\ same s r).
Proof.
  intros Sp. destruct (canonical_from_perturbed S h Sp) as (e0 & P0 & K).
  destruct (K (e0 / 2)) as (T & C & _); [lra|]. exists T. split; [assumption|].
  destruct C as [F C]. split.
  - intros s Hs. destruct (C s Hs) as (t & <- & Ct). now apply canonical_witness_plane.
  - intros U [FU CU]. split; intros s Hs.
    + apply (canonical_unique S h T U F FU); [|assumption]. intros r [Hr|Hr]; auto.
    + apply (canonical_unique S h U T FU F); [|assumption]. intros r [Hr|Hr]; auto.
Qed.

(** ** Delaunay triangulations *)

(** For all small e every point still has a plane of its own. *)
Lemma vertices_perturbed S : exists e0, 0 < e0 /\ forall e, 0 < e < e0 ->
  forall p, In p S -> strong_witness_plane (perturbed S norm2 e) S [p].
Proof.
  set (P p q := dist2 p q :: map (fun v => at_point v p + -1 * at_point v q) S).
  destruct (one_epsilon (map (fun pq => P (fst pq) (snd pq)) (list_prod S S))) as (e0 & P0 & K).
  exists e0. split; [assumption|]. intros e He p Hp.
  assert (Ev : forall q, evaluate (P p q) e =
    dist2 p q + e * (lowering S e p - lowering S e q)).
  { intros q. unfold P, lowering. cbn [evaluate]. f_equal. f_equal.
    induction S as [|v m IH] at 1 2 3; cbn [map evaluate]; [ring|]. rewrite IH. ring. }
  assert (Pl : forall q, perturbed S norm2 e q -
    plane (scale 2 p) (- norm2 p - e * lowering S e p) q = evaluate (P p q) e).
  { intros q. rewrite Ev, dist2_expand. unfold perturbed, plane. rewrite inner_scale. ring. }
  assert (Own : plane (scale 2 p) (- norm2 p - e * lowering S e p) p = perturbed S norm2 e p).
  { specialize (Pl p). rewrite Ev in Pl. unfold dist2 in Pl. rewrite minus_self in Pl.
    assert (Z : norm2 (@origin d) = 0) by apply inner_origin. rewrite Z in Pl. lra. }
  exists (scale 2 p), (- norm2 p - e * lowering S e p). split.
  - now intros v [<-|[]].
  - intros q Hq. destruct (point_eq_dec q p) as [->|N].
    + rewrite Own. split; [lra|]. intros _. now left.
    + assert (D : 0 < dist2 p q).
      { pose proof (norm2_nonneg (minus p q)) as D. fold (dist2 p q) in D.
        destruct (Req_dec (dist2 p q) 0) as [Z|]; [|lra]. apply norm2_zero in Z.
        exfalso. apply N. rewrite <- (minus_plus p q), Z. symmetry. apply origin_plus. }
      destruct (K e He (P p q)) as (Pos & _).
      { apply in_map_iff. exists (p, q). split; [reflexivity|]. now apply in_prod. }
      assert (0 < evaluate (P p q) e).
      { apply Pos. unfold P. cbn [lead]. destruct (Req_EM_T (dist2 p q) 0); lra. }
      specialize (Pl q). split; [lra|intros; lra].
Qed.

(** Every finite point set that spans R^d has a Delaunay triangulation; one of them is canonical,
    and no other is. *)
Theorem every_point_set_symbolic S : spans S -> exists T,
  delaunay_triangulation S T /\ symbolic_triangulation S norm2 T /\
  forall U, symbolic_triangulation S norm2 U ->
    (forall s, In s T -> exists r : simplex d, In r U /\ same s r) /\
    (forall s, In s U -> exists r : simplex d, In r T /\ same s r).
Proof.
  intros Sp. destruct (canonical_from_perturbed S norm2 Sp) as (e1 & P1 & K1).
  destruct (vertices_perturbed S) as (e2 & P2 & K2).
  set (e := Rmin e1 e2 / 2).
  assert (He : 0 < e < e1 /\ e < e2).
  { unfold e. pose proof (Rmin_l e1 e2). pose proof (Rmin_r e1 e2).
    pose proof (Rmin_glb_lt e1 e2 0 P1 P2). lra. }
  destruct (K1 e) as (T & [F C] & W); [lra|]. exists T. split; [split; [split|]|split].
  - assumption.
  - intros p Hp. destruct (proposition_4_3_heights (perturbed S norm2 e) S T [p] F W)
      as (_ & _ & t & Ht & I).
    + apply K2; [lra|assumption].
    + apply point_independent.
    + discriminate.
    + intros v [<-|[]]. assumption.
    + exists t. split; [assumption|]. apply I. now left.
  - intros s Hs. apply delaunay_witness_plane. destruct (C s Hs) as (t & <- & Ct).
    now apply canonical_witness_plane.
  - now split.
  - intros U [FU CU]. split.
    + apply (canonical_unique S norm2 T U F FU). intros r [Hr|Hr]; auto.
    + apply (canonical_unique S norm2 U T FU F). intros r [Hr|Hr]; auto.
Qed.
Theorem every_point_set S : NoDup S -> spans S -> exists T,
  delaunay_triangulation S T /\ canonical_triangulation S norm2 T /\
  forall U, canonical_triangulation S norm2 U -> same_simplices T U.
Proof.
  intros N Sp. destruct (every_point_set_symbolic S Sp) as (T & D & C & _).
  apply symbolic_canonical in C; try assumption. exists T. split; [assumption|].
  split; [assumption|]. intros U. now apply canonical_once.
Qed.
End EveryPointSet.
