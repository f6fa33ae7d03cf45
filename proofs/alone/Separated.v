(** * Simplices that a hyperplane parts meet in a common face

    A function that is affine, nowhere negative on s and nowhere positive on t vanishes where the
    two meet; so what they have in common is in the face of s where it vanishes ([parted_meet]).
    And if any two simplices of a list meet in a common face, so do their faces: the simplices and
    their faces are a simplicial complex ([complex_of_simplices]). *)
From Coq Require Import Rbase Rfunctions Lra List Arith Lia.
From Circumspect Require Import Definitions Complexes Vectors Affine Frame Faces Independence.
Import ListNotations.
Open Scope R_scope.

Section Separated.
Context {d : nat}.
Implicit Types (p q v : point d) (s t f g : simplex d) (T : list (simplex d)).

Lemma positive_terms (l : list (R * point d)) :
  (forall a p, In (a, p) l -> 0 <= a) ->
  let m := filter (fun ap => if Rlt_dec 0 (fst ap) then true else false) l in
  total m = total l /\ combination m = combination l.
Proof.
  intros H. induction l as [|[a p] l IH]; [now split|]. cbn [filter fst].
  destruct IH as [E F]; [intros b q I; apply (H b q); now right|].
  pose proof (H a p (or_introl eq_refl)). destruct (Rlt_dec 0 a).
  - now rewrite !total_cons, !combination_cons, E, F.
  - assert (a = 0) as -> by lra. rewrite total_cons, combination_cons, scale_zero, E, F.
    split; [ring|].
    symmetry. apply origin_plus.
Qed.

(** A point of conv s is in the hull of the vertices that are also in t, if for each of the others a
    function says that it has no part in the point. *)
Lemma conv_meet s t q : conv s q ->
  (forall v, In v s -> ~ In v t -> exists g : point d -> R,
     affine g /\ (forall p, In p s -> 0 <= g p) /\ 0 < g v /\ g q <= 0) ->
  conv (meet s t) q.
Proof.
  intros (l & L & To & <-) H.
  destruct (positive_terms l) as [E F]; [intros a p I; now apply (L a p)|].
  set (m := filter _ l) in *. exists m. split; [|split; congruence].
  intros a p I. apply filter_In in I. destruct I as [I P]. cbn [fst] in P.
  destruct (Rlt_dec 0 a) as [Pa|]; [|discriminate]. destruct (L a p I) as [_ Ip]. split; [lra|].
  apply in_meet. split; [assumption|]. destruct (in_points p t) as [|N]; [assumption|exfalso].
  destruct (H p Ip N) as (g & A & Nn & Pv & Le). rewrite (affine_combination g l A To) in Le.
  assert (0 < sum_over l (fun ap => fst ap * g (snd ap))); [|lra].
  apply sum_pos with (a, p); [|assumption|cbn; nra].
  intros [b x] Ib. destruct (L b x Ib). cbn. apply Rmult_le_pos; auto.
Qed.

Theorem parted_meet s t (g : point d -> R) q : affine g -> (forall p, In p s -> 0 <= g p) ->
  (forall p, In p s -> g p = 0 -> In p t) -> (forall p, In p t -> g p <= 0) ->
  conv s q -> conv t q -> conv (meet s t) q.
Proof.
  intros A Ns Zs Nt Cs Ct. apply conv_meet; [assumption|]. intros v Iv N. exists g.
  split; [assumption|].
  split; [assumption|]. split.
  - destruct (Rle_lt_or_eq_dec _ _ (Ns v Iv)) as [|E]; [assumption|]. destruct N. auto.
  - assert (0 <= - g q); [|lra].
    apply (affine_conv (fun p => - g p) t); [now apply affine_opp| |assumption].
    intros p Ip. specialize (Nt p Ip). lra.
Qed.

(** Faces of one simplex. *)
Lemma independent_meet s f g q : affinely_independent s -> incl f s -> incl g s -> conv f q ->
  conv g q ->
  conv (meet f g) q.
Proof.
  intros I If Ig Cf Cg. destruct (dual_functions s I) as (h & D). apply conv_meet; [assumption|].
  intros v Iv N.
  destruct (In_nth s v origin (If v Iv)) as (i & Hi & <-). destruct (D i Hi) as [A E]. exists (h i).
  assert (V : forall p, In p s -> 0 <= h i p /\ (h i p = 0 \/ p = nth i s origin)).
  { intros p Ip. destruct (In_nth s p origin Ip) as (k & Hk & <-). rewrite (E k Hk).
    destruct (Nat.eq_dec i k) as [->|]; split; try lra; auto. }
  split; [assumption|]. split; [intros p Ip; now apply V, If|]. rewrite (E i Hi).
  destruct (Nat.eq_dec i i); [|congruence]. split; [lra|].
  assert (0 <= - h i q); [|lra].
  apply (affine_conv (fun p => - h i p) g); [now apply affine_opp| |assumption].
  intros p Ip. destruct (V p (Ig p Ip)) as [_ [->| ->]]; [lra|contradiction].
Qed.

Theorem complex_of_simplices T : (forall t, In t T -> affinely_independent t) ->
  (forall s t q, In s T -> In t T -> conv s q -> conv t q -> exists f, incl f s /\ incl f t /\
    conv f q) ->
  simplicial_complex (faces_of T).
Proof.
  intros I M. split; [|split].
  - intros s (N & _ & t & It & Is). apply dual_independent; [assumption|]. intros v Iv.
    destruct (dual_functions t (I t It)) as (h & D).
    destruct (In_nth t v origin (Is v Iv)) as (i & Hi & E).
    destruct (D i Hi) as [A V]. exists (h i). split; [assumption|]. split.
    + rewrite <- E, V by assumption. destruct (Nat.eq_dec i i); congruence.
    + intros w Iw Nw. destruct (In_nth t w origin (Is w Iw)) as (k & Hk & F).
      rewrite <- F, V by assumption.
      destruct (Nat.eq_dec i k) as [->|]; [congruence|reflexivity].
  - intros s f (_ & _ & t & It & Is) If N Ne. split; [assumption|]. split; [assumption|].
    exists t. split; [assumption|]. now apply incl_tran with s.
  - intros s r (_ & _ & t & It & Is) (_ & _ & u & Iu & Ir). exists (meet s r).
    split; [intros p Ip; now apply in_meet in Ip|]. split; [intros p Ip; now apply in_meet in Ip|].
    intros q Cs Cr. destruct (M t u q It Iu) as (f & Ft & Fu & Cf);
      [now apply (conv_incl s)|now apply (conv_incl r)|].
    pose proof (independent_meet t s f q (I t It) Is Ft Cs Cf) as C.
    assert (Iu' : incl (meet s f) u) by (intros p Ip; apply in_meet in Ip; now apply Fu).
    pose proof (independent_meet u r (meet s f) q (I u Iu) Ir Iu' Cr C) as C'.
    apply (conv_incl (meet r (meet s f))); [|assumption]. intros p Ip. apply in_meet in Ip.
    destruct Ip as [Ip Iq].
    apply in_meet in Iq. apply in_meet. tauto.
Qed.

(** The definition of the claim says that they are one. *)
Theorem a_complex_indeed S T : simplices_meet_in_faces S T -> simplicial_complex (faces_of T).
Proof.
  intros H. apply complex_of_simplices; [intros t It; now apply (independent_vertices S T H)|].
  pose proof (meeting_in_faces S T H) as F.
  assert (Self : forall t q, conv t q -> exists f, incl f t /\ incl f t /\ conv f q).
  { intros t q C. exists t. repeat split; [intros x; auto..|assumption]. }
  intros s t q Is It. pose proof (ForallOrdPairs_In F s t Is It) as [->|[M|M]]; intros Cs Ct.
  - now apply Self.
  - now apply M.
  - destruct (M q Ct Cs) as (f & A & B & C). eauto.
Qed.
End Separated.
