(** * The picture of a triangulation of a plane in space *)
From Coq Require Import Rbase Rfunctions Lra List Arith Lia.
From Circumspect Require Import DomainChecker.
From Circumspect Require Import Definitions Domains Flats Vectors Affine Faces Independence
  Orientation Combinations Shadow.
Import ListNotations.
Open Scope R_scope.

Section Picture.
Variables (i : nat) (n : point 3) (b : R).
Hypothesis seen : axis_of i n <> 0.
Notation up := (raised i n b).
Notation down := (shadow i).
Notation in_plane := (flat n b).

Lemma affine_down (f : point 2 -> R) : affine f -> affine (fun q => f (down q)).
Proof.
  intros (a & e & F). unfold shadow. destruct i as [|[|k]].
  - apply affine_ext with (2 := affine3 0 (abscissa a) (ordinate a) e). intros q. rewrite F.
    unfold plane. rewrite inner2. cbn. unfold ordinate, height. ring.
  - apply affine_ext with (2 := affine3 (abscissa a) 0 (ordinate a) e). intros q. rewrite F.
    unfold plane. rewrite inner2. cbn. unfold abscissa, ordinate, height. ring.
  - apply affine_ext with (2 := affine3 (abscissa a) (ordinate a) 0 e). intros q. rewrite F.
    unfold plane. rewrite inner2. cbn. unfold abscissa, ordinate. ring.
Qed.
Lemma up_injective p q : up p = up q -> p = q.
Proof. intros E. now rewrite <- (shadow_raised i n b p), E, shadow_raised. Qed.
Lemma NoDup_up X : NoDup X -> NoDup (map up X).
Proof.
  induction 1 as [|p X Out N IH]; cbn; constructor; [|assumption]. intros I.
  apply in_map_iff in I. destruct I as (q & E & Iq). apply up_injective in E. now subst.
Qed.
Lemma down_up X : map down (map up X) = X.
Proof.
  rewrite map_map. rewrite <- (map_id X) at 2. apply map_ext. intros p. apply shadow_raised.
Qed.

Lemma conv_up X q : conv (map up X) q <-> in_plane q /\ conv X (down q).
Proof.
  rewrite (conv_shadow i n b seen), down_up; [reflexivity|].
  intros x I. apply in_map_iff in I. destruct I as (p & <- & _). now apply raised_flat.
Qed.
Lemma independent_up X : affinely_independent X -> affinely_independent (map up X).
Proof.
  intros I. pose proof (independent_NoDup X I) as N. destruct (dual_functions X I) as (g & G).
  apply dual_independent; [now apply NoDup_up|].
  intros v Iv. apply in_map_iff in Iv. destruct Iv as (p & <- & Ip).
  destruct (In_nth X p origin Ip) as (k & Hk & Ek). destruct (G k Hk) as [A D].
  exists (fun q => g k (down q)). split; [now apply affine_down|]. split.
  - rewrite shadow_raised, <- Ek, D by assumption. destruct (Nat.eq_dec k k); congruence.
  - intros w Iw Nw. apply in_map_iff in Iw. destruct Iw as (q & <- & Iq). rewrite shadow_raised.
    destruct (In_nth X q origin Iq) as (m & Hm & Em). rewrite <- Em, D by assumption.
    destruct (Nat.eq_dec k m) as [->|]; [|reflexivity]. destruct Nw. congruence.
Qed.

(** A face of a simplex of the plane is the face of its picture. *)
Lemma face_up T s : faces_of (map (map up) T) s ->
  faces_of T (map down s) /\ map up (map down s) = s.
Proof.
  intros (N & Ne & t & It & Inc). apply in_map_iff in It. destruct It as (u & <- & Iu).
  assert (E : map up (map down s) = s).
  { rewrite map_map. rewrite <- (map_id s) at 2. apply map_ext_in. intros p Ip.
    apply raised_shadow; [assumption|]. apply Inc, in_map_iff in Ip. destruct Ip as (q & <- & _).
    now apply raised_flat. }
  split; [|exact E]. split; [|split].
  - apply (NoDup_map_inv up). now rewrite E.
  - intros Z. apply Ne. rewrite <- E, Z. reflexivity.
  - exists u. split; [assumption|]. intros p Ip. apply in_map_iff in Ip.
    destruct Ip as (q & <- & Iq). apply Inc, in_map_iff in Iq. destruct Iq as (p & <- & Ip).
    now rewrite shadow_raised.
Qed.
Lemma same_up s t : same (map up s) (map up t) -> same s t.
Proof.
  intros [A B]. split; intros p Ip; rewrite <- (shadow_raised i n b p).
  - apply (in_map up), A, in_map_iff in Ip. destruct Ip as (q & <- & Iq). now rewrite shadow_raised.
  - apply (in_map up), B, in_map_iff in Ip. destruct Ip as (q & <- & Iq). now rewrite shadow_raised.
Qed.
Lemma incl_up (s t : list (point 2)) : incl s t -> incl (map up s) (map up t).
Proof.
  intros I p Ip. apply in_map_iff in Ip. destruct Ip as (q & <- & Iq). now apply in_map, I.
Qed.

Theorem triangulation_up S T : triangulation S T ->
  flat_triangulation 2 (map up S) (map (map up) T).
Proof.
  intros ((L & (Ind & Fac & Meet) & Once & Vs & Cov) & Used).
  assert (Each : forall t, In t (map (map up) T) -> exists u, In u T /\ t = map up u).
  { intros t It. apply in_map_iff in It. destruct It as (u & <- & Iu). eauto. }
  repeat split.
  - destruct (Each t H) as (u & Iu & ->). apply NoDup_up. now apply L.
  - destruct (Each t H) as (u & Iu & ->). rewrite map_length. now apply L.
  - intros s F. destruct (face_up T s F) as [F' <-]. apply independent_up. now apply Ind.
  - assumption.
  - assumption.
  - destruct H as (_ & _ & t & It & I). exists t. split; [assumption|].
    intros p Ip. now apply I, H0.
  - intros s t Fs Ft. destruct (face_up T s Fs) as [Fs' <-]. destruct (face_up T t Ft) as [Ft' <-].
    destruct (Meet _ _ Fs' Ft') as (f & I & J & M). exists (map up f).
    split; [now apply incl_up|]. split; [now apply incl_up|]. intros q Cs Ct.
    apply conv_up in Cs, Ct. apply conv_up. split; [apply Cs|]. now apply M.
  - clear - Once seen. induction Once as [|t T Ht HT IH]; cbn [map]; constructor; [|assumption].
    apply Forall_forall. intros u Iu. apply in_map_iff in Iu. destruct Iu as (v & <- & Iv).
    rewrite Forall_forall in Ht. intros E. apply (Ht v Iv). now apply same_up.
  - intros t It. destruct (Each t It) as (u & Iu & ->). now apply incl_up, Vs.
  - intros C. apply conv_up in C. destruct C as [F C]. apply Cov in C. destruct C as (t & It & C).
    exists (map up t). split; [now apply in_map|]. apply conv_up. now split.
  - intros (t & It & C). destruct (Each t It) as (u & Iu & ->). apply conv_up in C.
    apply conv_up. split; [apply C|]. apply Cov. exists u. split; [assumption|apply C].
  - intros p Ip. apply in_map_iff in Ip. destruct Ip as (q & <- & Iq).
    destruct (Used q Iq) as (t & It & It'). exists (map up t). split; now apply in_map.
Qed.

(** The centre of a ball whose sphere is over this plane: half the slope, seen along the axis. *)
Definition centre_of (a : point 2) : point 3 :=
  match i with
  | O => triple_of 0 (abscissa a / 2) (ordinate a / 2)
  | 1%nat => triple_of (abscissa a / 2) 0 (ordinate a / 2)
  | _ => triple_of (abscissa a / 2) (ordinate a / 2) 0
  end.
Lemma centre_inner a q : 2 * inner (centre_of a) q = inner a (down q).
Proof.
  rewrite inner_3, inner2. unfold centre_of, shadow.
  destruct i as [|[|k]]; cbn; unfold abscissa, ordinate, height; cbn; field.
Qed.

Theorem delaunay_up S t : incl t S -> witness_plane (fun p => norm2 (up p)) S t ->
  delaunay (map up S) (map up t).
Proof.
  intros I (a & e & On & Below).
  exists (centre_of a), (norm2 (centre_of a) + e).
  assert (E : forall p, dist2 (centre_of a) (up p) =
    norm2 (centre_of a) + e + (norm2 (up p) - plane a e p)).
  { intros p. rewrite dist2_expand, centre_inner, shadow_raised. unfold plane. ring. }
  split.
  - intros v Iv. apply in_map_iff in Iv. destruct Iv as (p & <- & Ip). rewrite E, (On p Ip). ring.
  - intros v Iv. apply in_map_iff in Iv. destruct Iv as (p & <- & Ip). rewrite E.
    specialize (Below p Ip). cbv beta in Below. lra.
Qed.
End Picture.
