(** * The canonical triangulation is one of a set of points, not of a list

    The points of an accepted certificate are in lexicographic order.  So whoever lists the same
    points in another order, or in another unit, gets the same list ([same_lists]), hence the same
    canonical triangulation. *)
From Coq Require Import Rbase Rfunctions Lra Lia List ZArith Bool.
From Coq Require Vector.
From Circumspect Require Import Checker Settling Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Adjacency EveryPointSet.
From Circumspect Require Import Orientation Integers Incidence Accepted CertifiedMesh Soundness
  SettlingSound.
Import ListNotations.
Open Scope R_scope.

(** ** Lexicographic order *)

Fixpoint before (d : nat) : point d -> point d -> Prop :=
  match d with
  | O => fun _ _ => False
  | S n => fun p q => Vector.hd p < Vector.hd q \/ Vector.hd p = Vector.hd q /\
      before n (Vector.tl p) (Vector.tl q)
  end.
Lemma not_before_itself d : forall p : point d, ~ before d p p.
Proof.
  induction d as [|d IH]; intros p; cbn; [auto|]. intros [L|[_ B]]; [lra|now apply IH in B].
Qed.
Lemma before_not_after d : forall p q : point d, before d p q -> ~ before d q p.
Proof.
  induction d as [|d IH]; intros p q; cbn; [auto|]. intros [L|[E B]] [L'|[E' B']]; try lra.
  now apply (IH _ _ B).
Qed.

Lemma increasing_before (r : R) : 0 < r -> forall d k l, length k = d -> length l = d ->
  lexicographic k l = true ->
  before d (scale r (integer_point d k)) (scale r (integer_point d l)).
Proof.
  intros Pr. induction d as [|d IH]; intros [|x k] [|y l] K L E; try discriminate. cbn in E.
  cbn [before scale integer_point Vector.map Vector.hd Vector.tl hd tl]. apply orb_prop in E.
  destruct E as [E|E].
  - left. apply Z.ltb_lt, IZR_lt in E. cbn. nra.
  - right. booleans. apply Z.eqb_eq in H. subst y. split; [reflexivity|]. apply IH; auto.
Qed.

(** Lists in order with the same members are the same. *)
Lemma sorted_same {d} : forall l m : list (point d), ForallOrdPairs (before d) l ->
  ForallOrdPairs (before d) m ->
  (forall p, In p l <-> In p m) -> l = m.
Proof.
  induction l as [|p l IH]; intros [|q m] L M' E; auto.
  - destruct (proj2 (E q) (or_introl eq_refl)).
  - destruct (proj1 (E p) (or_introl eq_refl)).
  - inversion L as [|? ? Fp L']; subst. inversion M' as [|? ? Fq M'']; subst.
    rewrite Forall_forall in Fp, Fq.
    assert (p = q) as ->.
    { destruct (proj1 (E p) (or_introl eq_refl)) as [<-|Ip]; [reflexivity|].
      destruct (proj2 (E q) (or_introl eq_refl)) as [->|Iq]; [reflexivity|].
      destruct (before_not_after d p q (Fp q Iq) (Fq p Ip)). }
    f_equal. apply IH; [assumption..|]. intros x. split; intros I.
    + destruct (proj1 (E x) (or_intror I)) as [<-|J];
        [destruct (not_before_itself d q (Fp q I))|assumption].
    + destruct (proj2 (E x) (or_intror I)) as [<-|J];
        [destruct (not_before_itself d q (Fq q I))|assumption].
Qed.

Section Order.
Context {d : nat} {pr : predicates} {c : certificate}.
Hypothesis dimension_d : dimension pr = d.
Hypothesis accepts : check_in pr c = Accepted.

Theorem points_in_order : ForallOrdPairs (before d) (points_of_certificate d c).
Proof.
  pose proof (unit_positive accepts) as U. destruct (check_parts accepts) as (_ & H & _).
  unfold check_points in H.
  unfold points_of_certificate. destruct (points c) as [|e l]; [constructor|]. accepted.
  unfold shaped in Heqb. apply Nat.eqb_eq in Heqb. rewrite dimension_d in Heqb.
  assert (G : forall l k e, length (coordinates (position e)) = d ->
    points_increase pr k (position e) l = Accepted ->
    ForallOrdPairs (before d) (map (fun e => @place_of d (unit_of c) (position e)) (e :: l))).
  { clear e l Heqb H. induction l as [|e' l IH]; intros k e Le H.
    - repeat constructor.
    - destruct (increase_spec dimension_d _ k (position e) H) as [F _]. cbn [points_increase] in H.
      accepted.
      cbn [map]. constructor; [|apply (IH (Pos.succ k) e'); [|assumption]].
      + apply Forall_forall. intros q I.
        change (In q (map (fun e => @place_of d (unit_of c) (position e)) (e' :: l))) in I.
        apply in_map_iff in I. destruct I as (x & <- & I). rewrite Forall_forall in F.
        destruct (F x I) as [Sx Lx].
        apply increasing_before; auto.
      + rewrite Forall_forall in F. apply (F e'). now left. }
  now apply (G l 1%positive e).
Qed.
End Order.

Lemma accepted_order D c : check D c = Accepted ->
  ForallOrdPairs (before (dimension_of D)) (points_of_certificate (dimension_of D) c).
Proof. destruct D; intros A; exact (points_in_order eq_refl A). Qed.
Theorem same_lists D c c' : check D c = Accepted -> check D c' = Accepted ->
  (forall p, In p (points_of_certificate (dimension_of D) c) <->
    In p (points_of_certificate (dimension_of D) c')) ->
  points_of_certificate (dimension_of D) c = points_of_certificate (dimension_of D) c'.
Proof. intros A A' E. now apply sorted_same; [apply accepted_order|apply accepted_order|]. Qed.

Theorem canonical_any_order D c c' s s' : check D c = Accepted -> check D c' = Accepted ->
  settle D c s = Settled -> settle D c' s' = Settled -> claimed c = Delaunay ->
    claimed c' = Delaunay ->
  (forall p, In p (points_of_certificate (dimension_of D) c) <->
    In p (points_of_certificate (dimension_of D) c')) ->
  same_simplices (simplices_of_certificate (dimension_of D) c)
    (simplices_of_certificate (dimension_of D) c').
Proof.
  intros A A' Se Se' Cl Cl' E. pose proof (same_lists D c c' A A' E) as P.
  assert (Ca : canonical_triangulation (points_of_certificate (dimension_of D) c) norm2
    (simplices_of_certificate (dimension_of D) c)).
  { pose proof (settled_canonical D c A s (fun _ => 0) Se) as H. rewrite Cl in H. apply H.
    discriminate. }
  assert (Ca' : canonical_triangulation (points_of_certificate (dimension_of D) c) norm2
    (simplices_of_certificate (dimension_of D) c')).
  { rewrite P. pose proof (settled_canonical D c' A' s' (fun _ => 0) Se') as H. rewrite Cl' in H.
    apply H. discriminate. }
  destruct (check_sound D c A) as [N Tr]. rewrite Cl in Tr.
  apply (canonical_once (points_of_certificate (dimension_of D) c) norm2); auto.
  (* the sample is in a simplex *)
  assert (NE : exists t, In t (simplices_of_certificate (dimension_of D) c)).
  { assert (G : exists e, In e (Definitions.simplices c)).
    { assert (Sa : forall pr, check_in pr c = Accepted -> exists e, In e (Definitions.simplices c)).
      { intros pr H. destruct (check_parts H) as (_ & _ & _ & I & _). unfold inside_sample in I.
        apply andb_prop in I.
        destruct I as [_ I]. rewrite find_simplex in I.
        destruct (numbered (Definitions.simplices c) _) as [e|] eqn:F; [|discriminate].
        exists e. now apply numbered_in in F. }
      destruct D; apply (Sa _ A). }
    destruct G as (e & I). exists (map (spot (dimension_of D) c) (corners e)).
    now apply (in_map (fun e => map (spot _ c) (corners e))). }
  destruct NE as (t & It). pose proof (proj1 (proj1 Tr)) as F. exists t.
  pose proof F as (Le & _ & _ & V & _). split; [now apply V|]. split; [now apply Le|].
  destruct (fills_frame _ _ t F It) as (f & <-). apply vertices_independent.
Qed.
