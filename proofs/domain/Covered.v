(** * Where some mesh of a domain has nothing dangling, nothing dangles in any complex of it

    Let the d-simplices of one mesh cover |P|.  Then those of every complex that fills |P| do: near
    a point that they miss there would be only simplices of lower dimension, and these are thin
    ([thin]).  So whatever else there is in the complex is a face of them, for it meets one of them
    inside ([face_of_full]).  This is why a proof that a domain has no triangulation looks at
    d-simplices alone. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Domains Vectors Affine Frame Faces Independence Lists
  Necessary Solid.
Import ListNotations.
Open Scope R_scope.

Section Thin.
Context {d : nat}.
Implicit Types (s f : simplex d) (q y : point d).

(** Fewer than d+1 points are in a hyperplane. *)
Lemma thin (g : frame d) s : (length s <= d)%nat ->
  exists f : point d -> R, affine f /\ (forall p, conv s p -> f p = 0) /\ exists p, f p <> 0.
Proof.
  intros L. destruct (solution (map (fun p i => bary g i p) s) (seq 0 (S d)) (seq_NoDup _ _))
    as (c & (k & Ik & Nk) & Z).
  { rewrite map_length, seq_length. lia. }
  apply in_seq_d in Ik. set (f p := sum_over (seq 0 (S d)) (fun i => c i * bary g i p)).
  assert (A : affine f).
  { apply affine_sum. intros i Hi. apply in_seq_d in Hi. now apply affine_scale, bary_affine. }
  assert (Z' : forall p, In p s -> f p = 0).
  { intros p I. apply (Z (fun i => bary g i p)). now apply (in_map (fun p i => bary g i p)). }
  exists f. split; [assumption|]. split.
  - intros p C. apply Rle_antisym.
    + enough (0 <= - f p) by lra. apply (affine_conv (fun p => - f p) s p (affine_opp f A));
        [|assumption].
      intros v I. rewrite (Z' v I). lra.
    + apply (affine_conv f s p A); [|assumption]. intros v I. rewrite (Z' v I). lra.
  - exists (vertex g k). unfold f. rewrite (sum_one _ _ k).
    + rewrite bary_own by assumption. lra.
    + apply seq_NoDup.
    + now apply in_seq_d.
    + intros i Hi N. apply in_seq_d in Hi. rewrite bary_other by assumption. ring.
Qed.

(** A point of a simplex that is in no proper face of it. *)
Lemma inner_point s : s <> [] -> affinely_independent s ->
  exists q, conv s q /\ forall f, incl f s -> conv f q -> incl s f.
Proof.
  intros Ne In_. destruct (dual_functions s In_) as (g & D).
  assert (P : 0 < / INR (length s)).
  { apply Rinv_0_lt_compat, lt_0_INR. destruct s; [congruence|cbn; lia]. }
  set (l := map (fun p => (/ INR (length s), p)) s).
  assert (T : total l = 1).
  { unfold l. rewrite total_map, sum_over_const, map_length || rewrite total_map.
    rewrite sum_over_const. field.
    apply not_0_INR. destruct s; [congruence|discriminate]. }
  exists (combination l). split.
  - exists l. split; [|now split]. intros a p I. unfold l in I. apply in_map_iff in I.
    destruct I as (v & [= <- <-] & I).
    split; [lra|assumption].
  - intros f If Cf v Iv. apply (In_nth _ _ origin) in Iv. destruct Iv as (i & Hi & <-).
    destruct (D i Hi) as [A E].
    destruct (in_points (nth i s origin) f) as [|N]; [assumption|exfalso].
    assert (Z : forall p, In p f -> g i p = 0).
    { intros p I. destruct (In_nth _ _ origin (If p I)) as (k & Hk & <-). rewrite E by assumption.
      destruct (Nat.eq_dec i k) as [->|]; [contradiction|reflexivity]. }
    assert (G : g i (combination l) = 0).
    { apply Rle_antisym.
      - enough (0 <= - g i (combination l)) by lra.
        apply (affine_conv (fun p => - g i p) f _ (affine_opp _ A)); [|assumption].
        intros p I. rewrite (Z p I). lra.
      - apply (affine_conv (g i) f _ A); [|assumption]. intros p I. rewrite (Z p I). lra. }
    rewrite (affine_combination _ l A T) in G.
    enough (0 < sum_over l (fun ap => fst ap * g i (snd ap))) by lra.
    apply sum_pos with (/ INR (length s), nth i s origin).
    + intros (a, p) I. unfold l in I. apply in_map_iff in I. destruct I as (v & [= <- <-] & I).
      cbn [fst snd].
      destruct (In_nth _ _ origin I) as (k & Hk & <-). rewrite E by assumption.
      destruct (Nat.eq_dec i k); lra.
    + unfold l. apply (in_map (fun p => (/ INR (length s), p))). now apply nth_In.
    + cbn [fst snd]. rewrite E by assumption. destruct (Nat.eq_dec i i); [lra|congruence].
Qed.
End Thin.

Section Covered.
Context {d : nat}.
Variables (P : domain d) (K : list (simplex d)).
Hypothesis triangulates : steiner_triangulation P K.
Definition full (s : simplex d) : bool := Nat.eqb (length s) (S d).
Notation T := (filter full K).

Lemma full_spec s : full s = true <-> length s = S d.
Proof. apply Nat.eqb_eq. Qed.
Lemma in_full s : In s T <-> In s K /\ length s = S d.
Proof. rewrite filter_In. now rewrite full_spec. Qed.
Lemma listed_face s : In s K -> faces_of K s.
Proof.
  intros I. destruct triangulates as (D & _). destruct (D s I) as (N & E & _). split; [assumption|].
  split; [assumption|].
  exists s. split; [assumption|apply incl_refl].
Qed.
Lemma listed_independent s : In s K -> affinely_independent s.
Proof. intros I. destruct triangulates as (_ & _ & (A & _) & _). now apply A, listed_face. Qed.

(** ** The d-simplices of a complex cover what those of another cover *)

(** Near [q], towards [y], there is nothing of a simplex: if it is a d-simplex, since it misses [q],
    else since it is thin. *)
Definition away (q y : point d) (s : simplex d) : Prop :=
  exists e0, 0 < e0 /\ forall e, 0 < e <= e0 -> ~ conv s (mix q y e).
Lemma away_from_full q y s : In s K -> length s = S d -> ~ conv s q -> away q y s.
Proof.
  intros I L N. destruct (frame_of s L (listed_independent s I)) as (t & <-).
  assert (B : exists k, (k <= d)%nat /\ bary t k q < 0).
  { destruct (Forall_Exists_dec (fun k => 0 <= bary t k q) (fun k => Rle_dec 0 (bary t k q))
      (seq 0 (S d))) as [F|E].
    - exfalso. apply N, conv_vertices. intros k Hk. rewrite Forall_forall in F.
      now apply F, in_seq_d.
    - apply Exists_exists in E. destruct E as (k & Ik & Nk). apply in_seq_d in Ik. exists k.
      split; [assumption|lra]. }
  destruct B as (k & Hk & Nk). destruct (nearby [fun p => - bary t k p] q y) as (e0 & He & H).
  { intros g [<-|[]]. split; [now apply affine_opp, bary_affine|lra]. }
  exists e0. split; [lra|]. intros e E C. specialize (H e ltac:(lra) _ (or_introl eq_refl)).
  cbn beta in H.
  apply conv_vertices in C. specialize (C k Hk). lra.
Qed.
Lemma away_from_thin q y s (f : point d -> R) : affine f -> (forall p, conv s p -> f p = 0) ->
  f y <> 0 -> away q y s.
Proof.
  intros A Z Ny. destruct (Req_dec (f q) 0) as [Eq|Nq].
  - exists 1. split; [lra|]. intros e He C. apply Z in C. rewrite (affine_mix f _ _ _ A), Eq in C.
    apply Ny. apply (Rmult_eq_reg_l e); lra.
  - destruct (nearby [fun p => f q * f p] q y) as (e0 & He & H).
    { intros g [<-|[]]. split; [now apply affine_scale|].
      destruct (Rtotal_order (f q) 0) as [|[|]]; nra. }
    exists e0. split; [lra|]. intros e E C. specialize (H e ltac:(lra) _ (or_introl eq_refl)).
    cbn beta in H.
    rewrite (Z _ C) in H. lra.
Qed.
Lemma away_from_all q y l : (forall s, In s l -> away q y s) ->
  exists e0, 0 < e0 /\ forall e, 0 < e <= e0 -> forall s, In s l -> ~ conv s (mix q y e).
Proof.
  induction l as [|s l IH]; intros H; [exists 1; split; [lra|intros e _ s []]|].
  destruct IH as (e0 & P0 & H0); [intros; apply H; now right|].
  destruct (H s (or_introl eq_refl)) as (e1 & P1 & H1).
  exists (Rmin e0 e1). split; [now apply Rmin_glb_lt|]. intros e He. pose proof (Rmin_l e0 e1).
  pose proof (Rmin_r e0 e1).
  intros r [<-|I]; [apply H1; lra|apply H0; [lra|assumption]].
Qed.
(** For each thin simplex of a list a function that vanishes on it. *)
Lemma thin_ones (g : frame d) l : exists F : list (point d -> R), (forall f, In f F -> affine f /\
  exists p, f p <> 0) /\
  forall s, In s l -> (length s <= d)%nat -> exists f, In f F /\ forall p, conv s p -> f p = 0.
Proof.
  induction l as [|s l (F & HF & H)]; [exists []; split; [intros f []|intros s []]|].
  destruct (le_dec (length s) d) as [L|N].
  - destruct (thin g s L) as (f & A & Z & E). exists (f :: F). split.
    + intros f' [<-|I]; [now split|now apply HF].
    + intros r [<-|I] L'; [exists f; split; [now left|assumption]|].
      destruct (H r I L') as (f' & I' & Z'). exists f'. split; [now right|assumption].
  - exists F. split; [assumption|]. intros r [<-|I] L; [contradiction|now apply H].
Qed.

Variable M : list (simplex d).
Hypothesis other_mesh : solid_triangulation P M.

Theorem full_cover q : underlying P q -> exists t, In t T /\ conv t q.
Proof.
  intros U. destruct (proj1 (covers P M other_mesh q) U) as (m & Im & Cm).
  destruct (members P M other_mesh m Im) as [_ Lm].
  destruct (frame_of m Lm) as (g & Vg).
  { apply (proj1 (meets P M other_mesh)). now apply (member_face P M other_mesh). }
  destruct (finite_dec (fun t => conv t q) T) as [X|N]; [|exact X|exfalso].
  { intros t It. apply in_full in It. destruct It as [It L].
    destruct (frame_of t L (listed_independent t It)) as (h & <-).
    destruct (Forall_dec (fun k => 0 <= bary h k q) (fun k => Rle_dec 0 (bary h k q)) (seq 0 (S d)))
      as [F|F].
    - left. apply conv_vertices. intros k Hk. rewrite Forall_forall in F. now apply F, in_seq_d.
    - right. intros C. apply F, Forall_forall. intros k Ik. apply in_seq_d in Ik.
      apply conv_vertices in C. now apply C. }
  destruct (thin_ones g K) as (F & HF & Thin).
  destruct (general_position F (map (bary g) (seq 0 (S d))) (barycentre g) HF)
    as (y & Inside & Off).
  { intros f I. apply in_map_iff in I. destruct I as (i & <- & I). apply in_seq_d in I.
    split; [now apply bary_affine|now apply barycentre_inside]. }
  destruct (away_from_all q y K) as (e0 & P0 & Away).
  { intros s Is. destruct triangulates as (D & _). destruct (D s Is) as (_ & _ & L).
    destruct (Nat.eq_dec (length s) (S d)) as [E|E].
    - apply (away_from_full q y s Is E). intros C. apply N. exists s.
      split; [now apply in_full|assumption].
    - destruct (Thin s Is ltac:(lia)) as (f & If & Z).
      apply (away_from_thin q y s f); [now apply HF|assumption|now apply Off]. }
  set (e := Rmin e0 1). assert (E : 0 < e /\ e <= e0 /\ e <= 1).
  { unfold e. pose proof (Rmin_l e0 1). pose proof (Rmin_r e0 1).
    split; [apply Rmin_glb_lt; lra|lra]. }
  assert (U' : underlying P (mix q y e)).
  { apply (covers P M other_mesh). exists m. split; [assumption|]. rewrite <- Vg in *.
    apply conv_vertices. apply conv_vertices in Cm.
    intros i Hi. rewrite affine_mix by now apply bary_affine. specialize (Cm i Hi).
    assert (0 < bary g i y) by (apply Inside; now apply in_map, in_seq_d). nra. }
  destruct triangulates as (_ & _ & _ & _ & _ & Un). apply Un in U'. destruct U' as (s & Is & C).
  apply (Away e) with s; [lra|assumption|assumption].
Qed.

(** ** So nothing dangles *)

Theorem face_of_full s : faces_of K s -> faces_of T s.
Proof.
  intros (N & E & u & Iu & Iu'). split; [assumption|]. split; [assumption|].
  pose proof (listed_face u Iu) as Fu. destruct (inner_point u) as (x & Cx & Inner);
    [apply Fu|now apply listed_independent|].
  destruct (full_cover x) as (t & It & Ct). { apply triangulates. now exists u. }
  exists t. split; [assumption|]. apply incl_tran with u; [assumption|].
  destruct triangulates as (_ & _ & (_ & _ & Me) & _). pose proof It as It'. apply in_full in It'.
  destruct (Me u t Fu (listed_face t (proj1 It'))) as (f & Fuf & Ft & C).
  apply incl_tran with f; [now apply Inner; [|apply C]|assumption].
Qed.
Lemma full_face s : faces_of T s -> faces_of K s.
Proof.
  intros (N & E & t & It & H). split; [assumption|]. split; [assumption|]. exists t.
  split; [now apply in_full in It|assumption].
Qed.
Lemma filtered_pairs {A} (Q : A -> A -> Prop) (f : A -> bool) l : ForallOrdPairs Q l ->
  ForallOrdPairs Q (filter f l).
Proof.
  induction 1 as [|a l F O IH]; [constructor|]. cbn [filter]. destruct (f a); [|assumption].
  constructor; [|assumption].
  rewrite Forall_forall in *. intros b I. apply filter_In in I. now apply F.
Qed.
Theorem solid_part : solid_triangulation P T.
Proof.
  pose proof triangulates as (D & O & (A & Fa & Me) & V & Ce & Un).
  split; [intros t It; apply in_full in It; destruct It as [It L]; split;
    [now apply D|assumption]|].
  split.
  { apply (pairs_weaker (fun s t => length s = S d -> ~ same s t)); [|now apply filtered_pairs].
    intros s t Is _ H. apply H. now apply in_full in Is. }
  split; [|split; [|split]].
  - split; [intros s H; now apply A, full_face|].
    split; [|intros s t Hs Ht; apply Me; now apply full_face].
    intros s f (_ & _ & t & It & J) Hf N E. split; [assumption|]. split; [assumption|]. exists t.
    split; [assumption|].
    now apply incl_tran with s.
  - intros v Iv. destruct (V v Iv) as (s & Is & I).
    destruct (face_of_full s (listed_face s Is)) as (_ & _ & t & It & J). exists t. auto.
  - intros X IX. destruct (Ce X IX) as (F & HF & E). exists F. split; [|assumption]. intros s Is.
    now apply face_of_full, HF.
  - intros q. split; [apply full_cover|]. intros (t & It & C). apply Un. exists t.
    split; [now apply in_full in It|assumption].
Qed.
End Covered.

Section Claims.
Context {d : nat}.
Variables (P : domain d) (M : list (simplex d)).
Hypothesis other_mesh : solid_triangulation P M.

Theorem solid_part_plc K : plc_triangulation P K -> solid_plc_triangulation P (filter full K).
Proof.
  intros [St V]. split; [now apply solid_part with M|]. intros t v It. apply in_full in It.
  now apply V.
Qed.
Theorem solid_part_cdt K : cdt P K -> solid_cdt P (filter full K).
Proof.
  intros [Pl C]. split; [now apply solid_part_plc|]. intros t It. apply in_full in It.
  destruct It as [It L].
  apply C; [assumption|now left].
Qed.
End Claims.
