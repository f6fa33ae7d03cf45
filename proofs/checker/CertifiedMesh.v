(** * The mesh of an accepted certificate

    Simplices have frames, since their orientations are positive; facets and ridges that are
    matched are opposite.  So the certificate is a matched mesh ([certificate_matched]) with a
    sample point in one simplex only ([certificate_covered_once]) and a hull that is locally
    convex at its ridges ([certificate_convex_at_ridges]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith.
From Circumspect Require Import Checker Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Matched Cone.
From Circumspect Require Import Orientation Integers Incidence Accepted.
Import ListNotations.
Open Scope R_scope.

(** Finitely many things can be chosen at once. *)
Lemma finite_choice {A} (l : list positive) (P : positive -> A -> Prop) : l <> [] ->
  (forall k, In k l -> exists a, P k a) -> exists g, forall k, In k l -> P k (g k).
Proof.
  intros N. assert (G : forall a0 : A, (forall k, In k l -> exists a, P k a) ->
    exists g, forall k, In k l -> P k (g k)).
  { intros a0. clear N. induction l as [|k l' IH]; intros H.
    - exists (fun _ => a0). intros k [].
    - destruct IH as (g & G); [intros; apply H; now right|].
      destruct (H k (or_introl eq_refl)) as (a & Pa).
      exists (fun j => if Pos.eq_dec j k then a else g j). intros j Hj.
      destruct (Pos.eq_dec j k) as [->|Nj]; [assumption|]. apply G.
      destruct Hj; [congruence|auto]. }
  intros H. destruct l as [|k l']; [congruence|].
  destruct (H k (or_introl eq_refl)) as (a0 & _). now apply (G a0).
Qed.

Section CertifiedMesh.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis Or : oriented orient.
Hypothesis Co : computes orient pr.
Variable c : certificate.
Hypothesis accepts : check_in pr c = Accepted.

Notation r := (unit_of c).
Notation spot := (spot d c).
Notation entry t e := (numbered (simplices c) t = Some e).
Let dim_d : dimension pr = d := computes_dimension _ _ Co.

Lemma unit_power n : 0 < r ^ n.
Proof. apply pow_lt. exact (unit_positive accepts). Qed.

Lemma spots_sites t e : entry t e ->
  map spot (corners e) = map (place_of r) (sites_of (d := d) (c := c) e).
Proof.
  intros E. destruct (simplex_accepted dim_d accepts t e E) as (Known & _).
  unfold sites_of. rewrite map_map. apply map_ext_in. intros k Hk.
  destruct (Known k Hk) as (p & Ep). now apply spot_site with p.
Qed.
Lemma positive_orientation t e : entry t e -> 0 < orient (map spot (corners e)).
Proof.
  intros E. destruct (simplex_accepted dim_d accepts t e E) as (_ & P & _).
  rewrite (spots_sites t e E), (computes_orientation _ _ Co) by apply (sites_shaped dim_d accepts).
  apply IZR_lt in P. apply Rmult_lt_0_compat; [apply unit_power|assumption].
Qed.

Definition tets : list positive := numbers (simplices c).
Lemma in_tets t : In t tets <-> exists e, entry t e.
Proof. apply in_numbers. Qed.

Lemma frames_exist : exists geo : positive -> frame d, forall t e, entry t e ->
  lists (map spot (corners e)) (geo t).
Proof.
  destruct (finite_choice tets (fun t g => forall e, entry t e -> lists (map spot (corners e)) g))
    as (geo & G).
  - intros N. destruct (sample_accepted dim_d accepts) as (e & E & _).
    assert (I : In (sample_simplex c) tets) by (apply in_tets; eauto). now rewrite N in I.
  - intros t Ht. apply in_tets in Ht. destruct Ht as (e & E).
    pose proof (positive_orientation t e E) as P.
    destruct (lists_exists Or (map spot (corners e)) ltac:(lra)) as (g & L).
    exists g. intros e' E'. now replace e' with e by congruence.
  - exists geo. intros t e E. apply G; [|assumption]. apply in_tets. eauto.
Qed.

Section Geometry.
Variable geo : positive -> frame d.
Hypothesis frames : forall t e, entry t e -> lists (map spot (corners e)) (geo t).

Lemma corner_vertex t e i : entry t e -> (i <= d)%nat ->
  exists v, nth_error (corners e) i = Some v /\ vertex (geo t) i = spot v.
Proof.
  intros E Hi. destruct (frames t e E) as (L & V). specialize (V i Hi).
  destruct (nth_error (corners e) i) as [v|] eqn:N.
  - exists v. split; [reflexivity|]. rewrite (map_nth_error spot i _ N) in V. congruence.
  - apply nth_error_None in N. rewrite map_length in L. lia.
Qed.
Lemma vertices_in t i : In t tets -> (i <= d)%nat ->
  In (vertex (geo t) i) (points_of_certificate d c).
Proof.
  intros Ht Hi. apply in_tets in Ht. destruct Ht as (e & E).
  destruct (corner_vertex t e i E Hi) as (v & Ev & ->).
  destruct (simplex_accepted dim_d accepts t e E) as (Known & _).
  destruct (Known v (nth_error_In _ _ Ev)) as (p & Ep). now apply spot_in with p.
Qed.

(** [side] tells on which side of a facet a point is. *)
Lemma side_bary t e i s w : entry t e -> (i <= d)%nat -> well_shaped d s -> (0 < w)%Z ->
  exists q, 0 < q /\ IZR (side pr i (sites_of (d := d) (c := c) e) s w) =
                     q * bary (geo t) i (place_of (r / IZR w) s).
Proof.
  intros E Hi Hs Hw. pose proof (positive_orientation t e E) as P.
  pose proof (frames t e E) as L. pose proof (proj1 L) as Len.
  pose proof (frame_bary Or _ _ i (place_of (r / IZR w) s) L ltac:(lra) Hi) as B.
  rewrite (spots_sites t e E), map_length in Len.
  pose proof (computes_side _ _ Co r i _ s w (sites_shaped dim_d accepts (corners e)) Len Hi Hs Hw)
    as S. fold (sites_of (d := d) (c := c) e) in S.
  rewrite <- (spots_sites t e E), <- B in S. apply IZR_lt in Hw.
  exists (IZR w * orient (map spot (corners e)) / r ^ d). pose proof (unit_power d) as U. split.
  - apply Rdiv_lt_0_compat; [now apply Rmult_lt_0_compat|assumption].
  - apply Rmult_eq_reg_l with (r ^ d); [|lra]. rewrite <- S. field. lra.
Qed.

(** ** Matched facets *)

Definition adj (t : positive) (i : nat) (u : positive) (j : nat) : Prop :=
  exists e, entry t e /\ nth_error (walls e) i = Some (Neighbour u j).
Definition on_hull (t : positive) (i : nat) : Prop :=
  match numbered (simplices c) t with
  | Some e => match nth_error (walls e) i with Some (OnHull _) => True | _ => False end
  | None => False
  end.
Lemma on_hull_dec t i : {on_hull t i} + {~ on_hull t i}.
Proof.
  unfold on_hull. destruct (numbered (simplices c) t) as [e|]; [|now right].
  destruct (nth_error (walls e) i) as [[u j|h]|]; [now right|now left|now right].
Qed.
Lemma on_hull_spec t i : on_hull t i ->
  exists e h, entry t e /\ nth_error (walls e) i = Some (OnHull h).
Proof.
  unfold on_hull. destruct (numbered (simplices c) t) as [e|]; [|tauto].
  destruct (nth_error (walls e) i) as [[u j|h]|] eqn:W; try tauto. intros _. eauto.
Qed.
Lemma wall_index t e i : entry t e -> nth_error (walls e) i <> None -> (i <= d)%nat.
Proof.
  intros E N. apply nth_error_Some in N.
  destruct (simplex_accepted dim_d accepts t e E) as (_ & _ & L & _). lia.
Qed.
Lemma adj_sym t i u j : adj t i u j -> adj u j t i.
Proof.
  intros (e & E & W). destruct (neighbour_accepted dim_d accepts t e i u j E W)
    as (e' & E' & _ & B & _). now exists e'.
Qed.

Theorem certificate_matched : matched tets geo adj on_hull.
Proof.
  constructor.
  - intros t i u j _ (e & E & W). apply in_tets.
    destruct (neighbour_accepted dim_d accepts t e i u j E W) as (e' & E' & _). eauto.
  - intros t i u j _ (e & E & W).
    destruct (neighbour_accepted dim_d accepts t e i u j E W) as (e' & E' & M & _).
    apply (facets_opposite Or spot (corners e) (corners e')); eauto using positive_orientation.
    apply (wall_index t e); [assumption|congruence].
  - intros t i t' i' u j _ _ A A'. apply adj_sym in A, A'.
    destruct A as (e & E & W), A' as (e' & E' & W'). congruence.
  - intros t i Ht Hi. apply in_tets in Ht. destruct Ht as (e & E).
    destruct (simplex_accepted dim_d accepts t e E) as (_ & _ & L & _).
    destruct (nth_error (walls e) i) as [[u j|h]|] eqn:W.
    + left. exists u, j. now exists e.
    + right. unfold on_hull. now rewrite E, W.
    + apply nth_error_None in W. lia.
Qed.

(** ** The sample point *)

Definition o : point d := place_of (r / IZR (sample_denominator c)) (sample c).

Lemma sample_side t e i : entry t e -> (i <= d)%nat -> exists q, 0 < q /\
  IZR (side pr i (sites_of (d := d) (c := c) e) (sample c) (sample_denominator c)) =
  q * bary (geo t) i o.
Proof.
  intros E Hi. destruct (sample_accepted dim_d accepts) as (_ & _ & Hs & Hw & _).
  now apply side_bary.
Qed.
Theorem certificate_covered_once : covered_once tets geo o (sample_simplex c).
Proof.
  destruct (sample_accepted dim_d accepts) as (e & E & _ & _ & In_e).
  split; [apply in_tets; eauto|]. split.
  - intros i Hi. destruct (sample_side _ e i E Hi) as (q & Q & S).
    specialize (In_e i Hi). apply IZR_lt in In_e. nra.
  - intros t Ht N. apply in_tets in Ht. destruct Ht as (e' & E').
    destruct (simplex_accepted dim_d accepts t e' E') as (_ & _ & _ & Out & _).
    destruct (Out N) as (i & S).
    assert (Hi : (i <= d)%nat).
    { eapply (computes_side_index _ _ Co). intros Z. rewrite Z in S. lia. }
    exists i. split; [assumption|]. destruct (sample_side _ e' i E' Hi) as (q & Q & S').
    apply IZR_lt in S. nra.
Qed.

(** ** Hull facets and ridges *)

Definition ridge (t : positive) (i k : nat) (t' : positive) (i' k' : nat) : Prop :=
  exists h f a g f' b, numbered (hull c) h = Some f /\ carrier f = t /\ apex f = i /\
    nth_error (ridges f) a = Some (g, b) /\ k = skip i a /\
    numbered (hull c) g = Some f' /\ carrier f' = t' /\ apex f' = i' /\ k' = skip i' b.
Definition cone (t : positive) (i : nat) : frame d :=
  match le_dec i d, Req_EM_T (bary (geo t) i o) 0 with
  | left Hi, right N => proj1_sig (cone_exists (geo t) i o Hi N)
  | _, _ => geo t
  end.

Lemma hull_entry_of t i : hull_facet tets geo on_hull t i ->
  exists h f, numbered (hull c) h = Some f /\ carrier f = t /\ apex f = i.
Proof.
  intros (_ & _ & H). apply on_hull_spec in H. destruct H as (e & h & E & W).
  destruct (hull_wall_accepted dim_d accepts t e i h E W) as (f & F & C & A). eauto.
Qed.
Lemma hull_entry_facet h f : numbered (hull c) h = Some f ->
  hull_facet tets geo on_hull (carrier f) (apex f).
Proof.
  intros F. destruct (hull_accepted dim_d accepts h f F) as (e & E & W & _).
  split; [apply in_tets; eauto|]. split.
  - apply (wall_index (carrier f) e); [assumption|congruence].
  - unfold on_hull. now rewrite E, W.
Qed.
(** A hull facet has one entry only. *)
Lemma hull_entry_once h f g f' : numbered (hull c) h = Some f -> numbered (hull c) g = Some f' ->
  carrier f = carrier f' -> apex f = apex f' -> h = g.
Proof.
  intros F F' C A. destruct (hull_accepted dim_d accepts h f F) as (e & E & W & _).
  destruct (hull_accepted dim_d accepts g f' F') as (e' & E' & W' & _). congruence.
Qed.
Lemma hull_sample t i : hull_facet tets geo on_hull t i -> 0 < bary (geo t) i o.
Proof.
  intros H. destruct (hull_entry_of t i H) as (h & f & F & <- & <-).
  destruct (hull_accepted dim_d accepts h f F) as (e & E & W & S & _).
  assert (Hi : (apex f <= d)%nat) by (apply (wall_index (carrier f) e); [assumption|congruence]).
  destruct (sample_side _ e _ E Hi) as (q & Q & S'). apply IZR_lt in S. nra.
Qed.
Lemma cone_is_cone t i : hull_facet tets geo on_hull t i -> cone_of (geo t) i o (cone t i).
Proof.
  intros H. pose proof (hull_sample t i H) as P. destruct H as (_ & Hi & _). unfold cone.
  destruct (le_dec i d) as [L|]; [|contradiction].
  destruct (Req_EM_T (bary (geo t) i o) 0); [lra|]. apply proj2_sig.
Qed.
(** A ridge, seen from the entries of the two facets. *)
Lemma ridge_entries t i k t' i' k' : hull_facet tets geo on_hull t i ->
  ridge t i k t' i' k' -> exists h f e a g f' e' b,
    numbered (hull c) h = Some f /\ carrier f = t /\ apex f = i /\ entry t e /\
    numbered (hull c) g = Some f' /\ carrier f' = t' /\ apex f' = i' /\ entry t' e' /\
    k = skip i a /\ k' = skip i' b /\ (a < d)%nat /\ nth_error (ridges f') b = Some (h, a) /\
    matched_ridge (remove i (corners e)) (remove i' (corners e')) i i' a b = true /\
    forall v, nth_error (remove i' (corners e')) b = Some v ->
      (0 <= side pr i (sites_of (d := d) (c := c) e) (site_at d c v) 1)%Z.
Proof.
  intros H (h & f & a & g & f' & b & F & C & A & Rd & Ek & F' & C' & A' & Ek'). subst t i t' i'.
  destruct (hull_accepted dim_d accepts h f F) as (e & E & _ & _ & Len & _).
  destruct (ridge_accepted dim_d accepts h f e a g b F E Rd) as (f2 & e' & F2 & E' & M & B & Cv).
  rewrite F' in F2. injection F2 as <-.
  exists h, f, e, a, g, f', e', b. repeat (split; [assumption || reflexivity|]).
  split; [|now repeat split]. assert (N : nth_error (ridges f) a <> None) by congruence.
  apply nth_error_Some in N. lia.
Qed.

Theorem certificate_convex_at_ridges :
  convex_at_ridges tets geo adj on_hull o cone ridge.
Proof.
  constructor.
  - intros t i u j (_ & _ & H) _ A. apply adj_sym in A. destruct A as (e & E & W).
    unfold on_hull in H. now rewrite E, W in H.
  - exact hull_sample.
  - exact cone_is_cone.
  - intros t i k H Hk N. destruct (hull_entry_of t i H) as (h & f & F & C & A).
    destruct (hull_accepted dim_d accepts h f F) as (e & E & _ & _ & Len & _).
    destruct H as (_ & Hi & _). destruct (skip_onto i k d Hk Hi N) as (a & Ha & <-).
    destruct (nth_error (ridges f) a) as [[g b]|] eqn:Rd; [|apply nth_error_None in Rd; lia].
    destruct (ridge_accepted dim_d accepts h f e a g b F E Rd) as (f' & _ & F' & _).
    exists (carrier f'), (apex f'), (skip (apex f') b). exists h, f, a, g, f', b. auto 10.
  - intros t i k t' i' k' _ _ (h & f & a & g & f' & b & _ & _ & _ & _ & _ & F' & <- & <- & _).
    now apply hull_entry_facet with g.
  - intros t i k t' i' k' H _ Rd. destruct (ridge_entries t i k t' i' k' H Rd)
      as (h & f & e & a & g & f' & e' & b & F & C & A & E & F' & C' & A' & E' & -> & -> & Ha & _ &
          M & _).
    assert (H' : hull_facet tets geo on_hull t' i').
    { subst t' i'. now apply hull_entry_facet with g. }
    pose proof H as (_ & Hi & _). pose proof H' as (_ & Hi' & _).
    apply (ridges_opposite Or spot (corners e) (corners e') (geo t) (geo t') i i' a b _ _ o);
      eauto using positive_orientation, hull_sample, cone_is_cone.
  - intros t1 i1 k1 t2 i2 k2 t' i' k' H1 H2 _ _ R1 R2.
    destruct (ridge_entries _ _ _ _ _ _ H1 R1)
      as (h1 & f1 & e1 & a1 & g1 & f1' & e1' & b1 & F1 & C1 & A1 & _ & F1' & C1' & A1' & _ & _ &
          K1 & _ & B1 & _).
    destruct (ridge_entries _ _ _ _ _ _ H2 R2)
      as (h2 & f2 & e2 & a2 & g2 & f2' & e2' & b2 & F2 & C2 & A2 & _ & F2' & C2' & A2' & _ & _ &
          K2 & _ & B2 & _).
    assert (g1 = g2) by (apply (hull_entry_once g1 f1' g2 f2'); congruence). subst g2.
    assert (b1 = b2) by (apply (skip_inj i'); congruence). subst b2.
    assert (f1' = f2') by congruence. subst f2'. rewrite B1 in B2. injection B2 as <- <-.
    split; congruence.
  - intros t i k t' i' k' H _ Rd. destruct (ridge_entries t i k t' i' k' H Rd)
      as (h & f & e & a & g & f' & e' & b & F & C & A & E & F' & C' & A' & E' & -> & -> & Ha & B &
          M & Cv).
    assert (H' : hull_facet tets geo on_hull t' i').
    { subst t' i'. now apply hull_entry_facet with g. }
    pose proof H as (_ & Hi & _). pose proof H' as (_ & Hi' & _).
    assert (Hb : (b < d)%nat).
    { destruct (hull_accepted dim_d accepts g f' F') as (_ & _ & _ & _ & Len & _).
      assert (N : nth_error (ridges f') b <> None) by congruence.
      apply nth_error_Some in N. lia. }
    destruct (corner_vertex t' e' (skip i' b) E' (skip_le i' b d Hb)) as (v & Ev & ->).
    pose proof (frames t' e' E') as (L & _). rewrite map_length in L.
    specialize (Cv v). rewrite remove_nth in Cv by lia. specialize (Cv Ev).
    destruct (side_bary t e i (site_at d c v) 1 E Hi (site_shaped dim_d accepts v) ltac:(lia))
      as (q & Q & S).
    destruct (simplex_accepted dim_d accepts t' e' E') as (Known & _).
    destruct (Known v (nth_error_In _ _ Ev)) as (p & Ep).
    rewrite (spot_site d c v p Ep). replace (r / 1) with r in S by field.
    apply IZR_le in Cv. nra.
Qed.
End Geometry.
End CertifiedMesh.
