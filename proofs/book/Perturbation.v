(** * Symbolic perturbation: one answer for every point set  (Book: Section 2.9)

    Give the points v_1, v_2, ... of S, in their order, the infinitesimal weights e, e^2, ...: lower
    the height of v_i by e^i.  How high a lifted point is above a witness plane is then a polynomial
    in e, and its sign for all small e > 0 is the sign of its first coefficient that is not zero
    ([lead]).  One e serves all the questions that can be asked about finitely many simplices
    ([one_epsilon]); no answer but for a vertex of the simplex itself is zero ([no_ties]); and so a
    point set has at most one triangulation whose simplices all pass ([canonical_unique]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Faces LiftingMap.
Import ListNotations.
Open Scope R_scope.

(** ** Polynomials, lowest coefficient first *)

Fixpoint evaluate (l : list R) (e : R) : R :=
  match l with [] => 0 | c :: l' => c + e * evaluate l' e end.
(** The first coefficient that is not zero; 0 if there is none. *)
Fixpoint lead (l : list R) : R :=
  match l with [] => 0 | c :: l' => if Req_EM_T c 0 then lead l' else c end.

Lemma evaluate_bounded l : exists B, 0 <= B /\ forall e, 0 < e < 1 -> Rabs (evaluate l e) <= B.
Proof.
  induction l as [|c l (B & HB & IH)].
  - exists 0. split; [lra|]. intros; simpl. rewrite Rabs_R0; lra.
  - exists (Rabs c + B). pose proof (Rabs_pos c). split; [lra|]. intros e He. simpl.
    eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult, (Rabs_right e) by lra.
    specialize (IH e He). pose proof (Rabs_pos (evaluate l e)). nra.
Qed.

Lemma lead_positive l : 0 < lead l ->
  exists e0, 0 < e0 /\ forall e, 0 < e < e0 -> 0 < evaluate l e.
Proof.
  induction l as [|c l IH]; simpl; [lra|]. destruct (Req_EM_T c 0) as [->|N]; intros H.
  - destruct (IH H) as (e0 & H0 & K). exists e0. split; [assumption|].
    intros e He. specialize (K e He). nra.
  - destruct (evaluate_bounded l) as (B & HB & K). exists (Rmin 1 (c / (B + 1))).
    assert (0 < c / (B+1)) by (apply Rdiv_lt_0_compat; lra).
    split; [apply Rmin_glb_lt; lra|]. intros e He.
    pose proof (Rmin_l 1 (c/(B+1))). pose proof (Rmin_r 1 (c/(B+1))).
    specialize (K e ltac:(lra)).
    assert (E : c / (B+1) * (B+1) = c) by (field; lra).
    assert (e * (B+1) < c) by nra.
    assert (- B <= evaluate l e) by (unfold Rabs in K; destruct (Rcase_abs (evaluate l e)); lra).
    nra.
Qed.

Lemma lead_opp l : lead (map Ropp l) = - lead l.
Proof.
  induction l as [|c l IH]; simpl; [ring|].
  destruct (Req_EM_T (- c) 0), (Req_EM_T c 0); try lra; auto.
Qed.
Lemma evaluate_opp l e : evaluate (map Ropp l) e = - evaluate l e.
Proof. induction l as [|c l IH]; simpl; [ring|]. rewrite IH. ring. Qed.

(** The sign of the leading coefficient is the sign of the value for all small e. *)
Theorem lead_sign l : exists e0, 0 < e0 /\ forall e, 0 < e < e0 ->
  (0 < lead l -> 0 < evaluate l e) /\ (lead l < 0 -> evaluate l e < 0) /\
  (lead l = 0 -> evaluate l e = 0).
Proof.
  destruct (Rtotal_order (lead l) 0) as [Neg|[Zero|Pos]].
  - destruct (lead_positive (map Ropp l)) as (e0 & P & K). { rewrite lead_opp. lra. }
    exists e0. split; [assumption|]. intros e He. specialize (K e He).
    rewrite evaluate_opp in K. repeat split; intros; lra.
  - exists 1. split; [lra|]. intros e _. repeat split; intros; try lra.
    clear H. induction l as [|c l IH]; simpl in *; [reflexivity|].
    destruct (Req_EM_T c 0) as [->|N]; [rewrite IH by assumption; ring | contradiction].
  - destruct (lead_positive l Pos) as (e0 & P & K). exists e0. split; [assumption|].
    intros e He. specialize (K e He). repeat split; intros; lra.
Qed.

(** One e serves finitely many polynomials. *)
Theorem one_epsilon (ls : list (list R)) : exists e0, 0 < e0 /\ forall e, 0 < e < e0 ->
  forall l, In l ls -> (0 < lead l -> 0 < evaluate l e) /\ (lead l < 0 -> evaluate l e < 0) /\
    (lead l = 0 -> evaluate l e = 0).
Proof.
  induction ls as [|l ls IH].
  - exists 1. split; [lra|]. intros e _ l [].
  - destruct IH as (e1 & P1 & K1). destruct (lead_sign l) as (e2 & P2 & K2).
    exists (Rmin e1 e2). split; [apply Rmin_glb_lt; assumption|]. intros e He l' [<-|Hl'].
    + apply K2. pose proof (Rmin_r e1 e2); lra.
    + apply K1; [pose proof (Rmin_l e1 e2); lra|assumption].
Qed.

Section Perturbation.
Context {d : nat}.
Implicit Types (t : frame d) (p v : point d) (h : point d -> R) (S : list (point d)).

(** How high the lifted point p is above the witness plane of t. *)
Definition above h t p : R := h p - witness h t p.

Lemma above_combine c e h k t p :
  above (fun q => c * h q + e * k q) t p = c * above h t p + e * above k t p.
Proof.
  unfold above, witness, sum. rewrite (sum_ext _ _ (fun i => c * (bary t i p * h (vertex t i)) +
    e * (bary t i p * k (vertex t i)))) by (intros; ring).
  rewrite sum_plus, !sum_scale. ring.
Qed.

Lemma above_ext h k t p : (forall q, h q = k q) -> above h t p = above k t p.
Proof.
  intros E. unfold above, witness, sum. rewrite E. f_equal. apply sum_ext. intros. now rewrite E.
Qed.

Definition at_point v p : R := if point_eq_dec p v then 1 else 0.

(** The heights, the point number i lowered by e^i. *)
Definition lowering S (e : R) p : R := evaluate (map (fun v => at_point v p) S) e.
Definition perturbed S h (e : R) p : R := h p - e * lowering S e p.

(** The polynomial whose value at e is the height above the perturbed witness plane. *)
Definition coefficients S h t p : list R :=
  above h t p :: map (fun v => - above (at_point v) t p) S.

Lemma above_zero t p : above (fun _ => 0) t p = 0.
Proof. unfold above, witness, sum. rewrite sum_zero; [ring|intros; ring]. Qed.

Theorem coefficients_evaluate S h t p e :
  evaluate (coefficients S h t p) e = above (perturbed S h e) t p.
Proof.
  unfold coefficients. cbn [evaluate].
  assert (E : evaluate (map (fun v => - above (at_point v) t p) S) e = - above (lowering S e) t p).
  { induction S as [|v S IH]; cbn [map evaluate].
    - rewrite (above_ext _ (fun _ => 0)), above_zero by reflexivity. ring.
    - rewrite IH, (above_ext (lowering (v :: S) e)
        (fun q => 1 * at_point v q + e * lowering S e q)), above_combine; [ring|].
      intros q. unfold lowering. cbn [map evaluate]. ring. }
  rewrite E, (above_ext (perturbed S h e) (fun q => 1 * h q + - e * lowering S e q)),
    above_combine; [ring|]. intros q. unfold perturbed. ring.
Qed.

(** These are the heights that [lowered] of Definitions.v speaks of. *)
Lemma lowering_at S e : NoDup S -> forall i p, nth_error S i = Some p -> lowering S e p = e ^ i.
Proof.
  intros N. induction N as [|v S Nv N IH]; intros [|i] p E; cbn in E; try discriminate;
    unfold lowering; cbn [map evaluate].
  - injection E as ->. unfold at_point at 1. destruct (point_eq_dec p p) as [_|]; [|contradiction].
    enough (Z : evaluate (map (fun v => at_point v p) S) e = 0) by (rewrite Z; cbn; ring).
    clear IH N. induction S as [|u S IH]; cbn [map evaluate]; [reflexivity|]. rewrite IH.
    + unfold at_point. destruct (point_eq_dec p u) as [->|]; [|ring]. destruct Nv. now left.
    + intros H. apply Nv. now right.
  - fold (lowering S e p). rewrite (IH i p E). unfold at_point.
    destruct (point_eq_dec p v) as [->|]; [|cbn; ring].
    destruct Nv. now apply nth_error_In in E.
Qed.
Theorem perturbed_lowered S h e : NoDup S -> lowered S h e (perturbed S h e).
Proof. intros N i p E. unfold perturbed. rewrite (lowering_at S e N i p E). cbn. ring. Qed.
Theorem lowered_perturbed S h e k : NoDup S -> lowered S h e k ->
  forall p, In p S -> k p = perturbed S h e p.
Proof.
  intros N L p Hp. apply In_nth_error in Hp. destruct Hp as (i & E).
  rewrite (L i p E). unfold perturbed. rewrite (lowering_at S e N i p E). cbn. ring.
Qed.

(** Ties are gone: only the vertices of t are on its perturbed witness plane. *)
Theorem no_ties S h t p : In p S -> ~ In p (vertices t) -> lead (coefficients S h t p) <> 0.
Proof.
  intros Hp Hn Z.
  assert (N : forall l c, In c l -> c <> 0 -> lead l <> 0).
  { clear. induction l as [|a l IH]; intros c Hc Nc; [destruct Hc|].
    destruct Hc as [->|Hc]; simpl.
    - destruct (Req_EM_T c 0); congruence.
    - destruct (Req_EM_T a 0); [eapply IH; eauto|assumption]. }
  apply (N (coefficients S h t p) (-1)); [right|lra|assumption].
  apply in_map_iff. exists p. split; [|assumption]. unfold above, witness, sum. rewrite sum_zero.
  - unfold at_point. destruct (point_eq_dec p p); [lra|contradiction].
  - intros i Hi. apply in_seq_d in Hi. unfold at_point.
    destruct (point_eq_dec (vertex t i) p) as [E|]; [|ring].
    exfalso. apply Hn. apply in_vertices. exists i. split; [assumption|now symmetry].
Qed.

(** A simplex passes if every other point is above its perturbed witness plane, symbolically. *)
Definition canonical S h t : Prop :=
  forall p, In p S -> ~ In p (vertices t) -> 0 < lead (coefficients S h t p).

(** Symbolic and numeric agree: for all small e, one e for all points and simplices. *)
Theorem perturbation_sound S h (ts : list (frame d)) : exists e0, 0 < e0 /\
  forall e, 0 < e < e0 -> forall t p, In t ts -> In p S ->
    (0 < lead (coefficients S h t p) <-> 0 < above (perturbed S h e) t p) /\
    (lead (coefficients S h t p) < 0 <-> above (perturbed S h e) t p < 0).
Proof.
  destruct (one_epsilon (flat_map (fun t => map (coefficients S h t) S) ts)) as (e0 & P & K).
  exists e0. split; [assumption|]. intros e He t p Ht Hp.
  destruct (K e He (coefficients S h t p)) as (K1 & K2 & K3).
  { apply in_flat_map. exists t. split; [assumption|]. now apply in_map. }
  rewrite coefficients_evaluate in *.
  destruct (Rtotal_order (lead (coefficients S h t p)) 0) as [N|[Z|Q]].
  - specialize (K2 N). split; split; intros; lra.
  - specialize (K3 Z). split; split; intros; lra.
  - specialize (K1 Q). split; split; intros; lra.
Qed.

(** A plane that is nowhere above the lifted vertices is, in the simplex, not above the lifted
    simplex; if it touches at an interior point, it passes through all lifted vertices. *)
Lemma plane_below h t f q : affine f -> inside t q ->
  (forall i, (i <= d)%nat -> f (vertex t i) <= h (vertex t i)) ->
  f q <= witness h t q /\
  (f q = witness h t q -> forall i, (i <= d)%nat -> f (vertex t i) = h (vertex t i)).
Proof.
  intros A I H.
  assert (E : witness h t q - f q =
              sum (Datatypes.S d) (fun i => bary t i q * (h (vertex t i) - f (vertex t i)))).
  { rewrite (interpolation t f q A). unfold witness, sum.
    rewrite (sum_ext _ (fun i => bary t i q * (h (vertex t i) - f (vertex t i)))
      (fun i => bary t i q * h (vertex t i) + (-1) * (bary t i q * f (vertex t i))))
      by (intros; ring).
    rewrite sum_plus, sum_scale. ring. }
  assert (N : forall i, In i (seq 0 (Datatypes.S d)) ->
              0 <= bary t i q * (h (vertex t i) - f (vertex t i))).
  { intros i Hi. apply in_seq_d in Hi. specialize (H i Hi). apply Rmult_le_pos; [left; auto|lra]. }
  pose proof (sum_nonneg _ _ N). fold (sum (Datatypes.S d)
    (fun i => bary t i q * (h (vertex t i) - f (vertex t i)))) in H0.
  split; [lra|]. intros Q i Hi.
  destruct (Rle_lt_or_eq_dec _ _ (H i Hi)) as [L|]; [exfalso|assumption].
  assert (0 < sum (Datatypes.S d) (fun i => bary t i q * (h (vertex t i) - f (vertex t i)))).
  { apply (sum_pos _ _ i N); [now apply in_seq_d|]. apply Rmult_lt_0_compat; [auto|lra]. }
  lra.
Qed.

Lemma above_vertex h t i : (i <= d)%nat -> above h t (vertex t i) = 0.
Proof.
  intros Hi. unfold above, witness, sum. rewrite (sum_one _ _ i).
  - rewrite bary_own by assumption. ring.
  - apply seq_NoDup.
  - now apply in_seq_d.
  - intros k Hk N. apply in_seq_d in Hk. rewrite bary_other by auto. ring.
Qed.

(** Two simplices that pass and share an interior point of the one are the same. *)
Lemma canonical_overlap S h t u q : incl (vertices t) S -> incl (vertices u) S ->
  canonical S h t -> canonical S h u -> inside t q -> inside_closed u q ->
  incl (vertices t) (vertices u).
Proof.
  intros IT IU CT CU Qt Qu.
  destruct (perturbation_sound S h [t; u]) as (e0 & P & K).
  specialize (K (e0 / 2) ltac:(lra)). set (k := perturbed S h (e0 / 2)) in *.
  assert (Strict : forall s, In s [t; u] -> canonical S h s -> forall p, In p S ->
            0 <= above k s p /\ (above k s p = 0 -> In p (vertices s))).
  { intros s Hs C p Hp. destruct (in_dec point_eq_dec p (vertices s)) as [I|N].
    - split; [|auto]. apply in_vertices in I. destruct I as (i & Hi & ->).
      rewrite above_vertex by assumption. lra.
    - pose proof (proj1 (proj1 (K s p Hs Hp)) (C p Hp N)). split; [lra|intros; lra]. }
  pose proof (Strict t (or_introl eq_refl) CT) as St.
  pose proof (Strict u (or_intror (or_introl eq_refl)) CU) as Su.
  assert (Vt : forall i, (i <= d)%nat -> In (vertex t i) S).
  { intros i Hi. apply IT, in_vertices. eauto. }
  assert (Vu : forall i, (i <= d)%nat -> In (vertex u i) S).
  { intros i Hi. apply IU, in_vertices. eauto. }
  destruct (plane_below k t (witness k u) q (witness_affine k u) Qt) as [L1 T1].
  { intros i Hi. pose proof (proj1 (Su _ (Vt i Hi))). unfold above in *. lra. }
  assert (L2 : witness k t q <= witness k u q).
  { assert (0 <= witness k u q - witness k t q); [|lra].
    apply (inside_pos u (fun p => witness k u p - witness k t p)); auto.
    - apply affine_ext with (fun p => 1 * witness k u p + (-1) * witness k t p);
        [intros; ring|]. apply affine_combine; apply witness_affine.
    - intros i Hi. pose proof (proj1 (St _ (Vu i Hi))).
      rewrite witness_vertex by assumption. unfold above in *. lra. }
  intros v Hv. apply in_vertices in Hv. destruct Hv as (i & Hi & ->).
  apply Su; [auto|]. specialize (T1 ltac:(lra) i Hi). unfold above. lra.
Qed.

(** A point set has at most one canonical triangulation. *)
Theorem canonical_unique S h T1 T2 : fills S T1 -> fills S T2 ->
  (forall s, In s T1 \/ In s T2 -> exists t, vertices t = s /\ canonical S h t) ->
  forall s, In s T1 -> exists u : simplex d, In u T2 /\ same s u.
Proof.
  intros (_ & _ & _ & V1 & U1) (_ & _ & _ & V2 & U2) C s Hs.
  destruct (C s (or_introl Hs)) as (fs & <- & Cs).
  pose proof (barycentre_inside fs) as I.
  assert (Q : conv S (barycentre fs)).
  { apply U1. exists (vertices fs). split; [assumption|]. apply conv_vertices.
    intros i Hi. left. now apply I. }
  apply U2 in Q. destruct Q as (t & Ht & Q).
  destruct (C t (or_intror Ht)) as (ft & <- & Ct). exists (vertices ft). split; [assumption|].
  assert (L : incl (vertices fs) (vertices ft)).
  { apply (canonical_overlap S h fs ft (barycentre fs)); auto. now apply conv_vertices. }
  split; [assumption|]. apply NoDup_length_incl; [apply vertices_NoDup| |assumption].
  rewrite !vertices_length. lia.
Qed.
End Perturbation.
