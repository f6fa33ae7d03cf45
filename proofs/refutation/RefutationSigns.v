(** * What the signs in a refutation mean for the caller's points

    A refutation does not say which way a simplex is oriented: its signs are those of products
    with the orientation, and so they are the signs of barycentric coordinates and of heights above
    witness planes.  A simplex whose orientation is zero is degenerate, since the orientation of
    a simplex with a frame is not zero. *)
From Coq Require Import Rbase Rfunctions Lra Psatz Lia List Arith ZArith Bool.
From Coq Require Vector.
From Circumspect Require Import Refutation Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Independence LiftingMap.
From Circumspect Require Import Orientation Integers Spans Breach.
Import ListNotations.
Open Scope R_scope.

(** ** Lists *)

(** The vertices of a facet. *)
Lemma remove_incl {A} i (m : list A) : incl (remove i m) m.
Proof.
  revert i. induction m as [|a m IH]; intros [|i] b; cbn; auto. intros [->|H]; [now left|].
  right. now apply (IH i).
Qed.
Lemma remove_NoDup {A} i (m : list A) : NoDup m -> NoDup (remove i m).
Proof.
  intros N. revert i. induction N as [|a m Na N IH]; intros [|i]; cbn; auto; constructor; auto.
  intros H. now apply remove_incl in H.
Qed.
Lemma remove_absent {A} i (m : list A) a : NoDup m -> nth_error m i = Some a -> ~ In a (remove i m).
Proof.
  intros N. revert i. induction N as [|b m Nb N IH]; intros [|i] E; cbn in *; try discriminate.
  - now injection E as ->.
  - intros [->|H]; [|now apply (IH i)]. apply nth_error_In in E. contradiction.
Qed.
Lemma remove_present {A} i (m : list A) a b : nth_error m i = Some a -> In b m -> b <> a ->
  In b (remove i m).
Proof.
  revert i. induction m as [|c m IH]; intros [|i] E Hb N; cbn in *; try discriminate.
  - injection E as ->. destruct Hb; [congruence|assumption].
  - destruct Hb as [->|Hb]; [now left|]. right. now apply IH.
Qed.

Lemma has_length_length {A} n (m : list A) : has_length n m = true <-> length m = n.
Proof.
  revert n. induction m as [|a m IH]; intros [|n]; cbn; try (split; congruence).
  rewrite IH. split; congruence.
Qed.

(** The members of a list with their positions. *)
Lemma in_indexed {A} (m : list A) : forall n i x, In (i, x) (combine (seq n (length m)) m) <->
  (n <= i)%nat /\ nth_error m (i - n) = Some x.
Proof.
  induction m as [|c m IH]; intros n i x; cbn [length seq combine].
  - split; [intros []|]. intros [_ E]. destruct (i - n)%nat; discriminate.
  - cbn [In]. rewrite IH. split.
    + intros [E|[H E]].
      * injection E as <- <-. now rewrite Nat.sub_diag.
      * split; [lia|]. now replace (i - n)%nat with (Datatypes.S (i - Datatypes.S n)) by lia.
    + intros [H E]. destruct (Nat.eq_dec i n) as [->|N].
      * rewrite Nat.sub_diag in E. injection E as <-. now left.
      * right. split; [lia|].
        now replace (i - n)%nat with (Datatypes.S (i - Datatypes.S n)) in E by lia.
Qed.

(** What is needed of the determinants: [orient] of the caller's points is what [pr] computes, up to
    powers of the unit r. *)
Record measured {d : nat} (orient : list (point d) -> R) (pr : predicates) (r : R) : Prop := {
  measured_oriented : oriented orient;
  measured_computed : computes orient pr;
  measured_spans : forall t : frame d, orient (vertices t) <> 0;
  measured_unit : 0 < r
}.
Lemma measured_plane r : 0 < r -> measured orient2 plane_predicates r.
Proof. constructor; auto using oriented2, plane_computes, spans2. Qed.
Lemma measured_space r : 0 < r -> measured orient3 space_predicates r.
Proof. constructor; auto using oriented3, space_computes, spans3. Qed.

Section Signs.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates} {r : R}.
Hypothesis M : measured orient pr r.
Let is_oriented := measured_oriented orient pr r M.
Let is_computed := measured_computed orient pr r M.
Let spans := measured_spans orient pr r M.
Let unit_positive := measured_unit orient pr r M.
Lemma dimension_d : dimension pr = d.
Proof. exact (computes_dimension orient pr is_computed). Qed.
Implicit Types (X Y : list site) (p q : site) (h : point d -> R).
Notation place := (@place_of d r).
Notation places := (map (@place_of d r)).
Notation shaped_all := (Forall (well_shaped d)).

(** ** Equal points *)

Lemma integer_point_inj n : forall k l : list Z, length k = n -> length l = n ->
  integer_point n k = integer_point n l -> k = l.
Proof.
  induction n as [|n IH]; intros [|x k] [|y l] K L E; try discriminate; [reflexivity|].
  cbn in E. assert (Ex := f_equal Vector.hd E). assert (Et := f_equal Vector.tl E).
  cbn in Ex, Et. apply eq_IZR in Ex. f_equal; [assumption|]. apply IH; cbn in *; congruence.
Qed.
Lemma same_numbers_eq k l : same_numbers k l = true <-> k = l.
Proof.
  revert l. induction k as [|x k IH]; intros [|y l]; cbn; try (split; congruence).
  rewrite andb_true_iff, IH, Z.eqb_eq. split; [intros [-> ->]; reflexivity|].
  intros E. now injection E.
Qed.
Lemma same_place_place p q : well_shaped d p -> well_shaped d q ->
  (same_place p q = true <-> place p = place q).
Proof.
  intros Hp Hq. unfold same_place. rewrite same_numbers_eq. split.
  - intros E. unfold place_of. now rewrite E.
  - intros E. apply (integer_point_inj d); [assumption..|].
    assert (F := f_equal (scale (/ r)) E). unfold place_of in F.
    rewrite !scale_scale, Rinv_l, !scale_one in F by lra. exact F.
Qed.
Lemma all_among_incl X Y : shaped_all X -> shaped_all Y ->
  (all_among X Y = true <-> incl (places X) (places Y)).
Proof.
  intros HX HY. unfold all_among. rewrite forallb_forall. rewrite Forall_forall in HX, HY. split.
  - intros A v Hv. apply in_map_iff in Hv. destruct Hv as (p & <- & Hp).
    specialize (A p Hp). apply existsb_exists in A. destruct A as (q & Hq & E).
    apply same_place_place in E; auto. rewrite E. now apply in_map.
  - intros I p Hp. apply existsb_exists. assert (H := I _ (in_map _ X p Hp)).
    apply in_map_iff in H. destruct H as (q & E & Hq). exists q. split; [assumption|].
    apply same_place_place; auto.
Qed.
Lemma same_places_same X Y : shaped_all X -> shaped_all Y ->
  (same_places X Y = true <-> same (places X) (places Y)).
Proof.
  intros HX HY. unfold same_places. rewrite andb_true_iff, !all_among_incl by assumption.
  reflexivity.
Qed.

(** ** Simplices *)

(** The simplex [X] of d+1 points, not degenerate, and the frame that it has. *)
Record framed X (t : frame d) : Prop := {
  framed_shaped : shaped_all X;
  framed_length : length X = S d;
  framed_vertices : vertices t = places X;
  framed_orientation : orientation pr X <> 0%Z;
  framed_bary : forall i v, (i <= d)%nat ->
    bary t i v = orient (replace i v (places X)) / orient (places X)
}.

Lemma orient_places X : shaped_all X -> orient (places X) = r ^ d * IZR (orientation pr X).
Proof. intros. now apply (computes_orientation orient pr is_computed). Qed.
Lemma power_positive n : 0 < r ^ n.
Proof. now apply pow_lt. Qed.

Lemma listed_vertices (t : frame d) (s : simplex d) : length s = S d ->
  (forall i, (i <= d)%nat -> nth_error s i = Some (vertex t i)) -> vertices t = s.
Proof.
  intros L V. apply nth_ext with (d := vertex t 0) (d' := vertex t 0).
  - now rewrite vertices_length.
  - intros i Hi. rewrite vertices_length in Hi. unfold vertices. rewrite map_nth, seq_nth by lia.
    symmetry. apply nth_error_nth. apply V. lia.
Qed.
Lemma proper_framed X : shaped_all X -> length X = S d -> proper pr X = true ->
  exists t, framed X t.
Proof.
  intros HX L P. unfold proper in P. apply negb_true_iff, Z.eqb_neq in P.
  assert (N : orient (places X) <> 0).
  { rewrite orient_places by assumption. pose proof (power_positive d).
    apply Rmult_integral_contrapositive_currified; [lra|]. now apply IZR_neq. }
  destruct (orient_frame orient is_oriented _ N) as (t & V & B). exists t. split; auto.
  apply listed_vertices; [now rewrite map_length|assumption].
Qed.
(** An orientation that is zero is that of points that are not affinely independent. *)
Lemma flat_dependent X : shaped_all X -> length X = S d -> proper pr X = false ->
  ~ affinely_independent (places X).
Proof.
  intros HX L P I. unfold proper in P. apply negb_false_iff, Z.eqb_eq in P.
  destruct (frame_of (places X)) as (t & V); [now rewrite map_length|assumption|].
  apply (spans t). rewrite V, orient_places, P by assumption. ring.
Qed.

Section Framed.
Variables (X : list site) (t : frame d).
Hypothesis F : framed X t.

Lemma framed_vertex i p : nth_error X i = Some p -> (i <= d)%nat /\ vertex t i = place p.
Proof.
  intros E. assert (H : (i < length X)%nat) by (apply nth_error_Some; congruence).
  rewrite (framed_length X t F) in H. split; [lia|].
  assert (G : nth_error (vertices t) i = Some (place p))
    by (rewrite (framed_vertices X t F); now apply map_nth_error).
  unfold vertices in G. rewrite (map_nth_error (vertex t) i (seq 0 (S d)) (d := i)) in G;
    [congruence|].
  rewrite (nth_error_nth' _ 0%nat) by (rewrite seq_length; lia). now rewrite seq_nth by lia.
Qed.

Lemma square_positive : 0 < IZR (orientation pr X) * IZR (orientation pr X).
Proof.
  pose proof (IZR_neq _ _ (framed_orientation X t F)) as N.
  pose proof (Rlt_0_sqr _ N). unfold Rsqr in *. lra.
Qed.

(** ** Signs *)

(** The point q / w of the text. *)
Definition place_over q (w : Z) : point d := place_of (r / IZR w) q.
Lemma place_over_one q : place_over q 1 = place q.
Proof. unfold place_over. f_equal. field. Qed.

Lemma coordinate_sign_bary q w i : (i <= d)%nat -> well_shaped d q -> (0 < w)%Z ->
  IZR (coordinate_sign pr X q w i) =
    IZR w * (IZR (orientation pr X) * IZR (orientation pr X)) * bary t i (place_over q w).
Proof.
  intros Hi Hq Hw. destruct F as [HX L V O B]. rewrite B by assumption.
  pose proof (computes_side orient pr is_computed r i X q w HX L Hi Hq Hw) as E.
  unfold coordinate_sign, place_over. rewrite mult_IZR, orient_places by assumption.
  pose proof (power_positive d). pose proof (IZR_neq _ _ O).
  apply Rmult_eq_reg_l with (r ^ d); [|lra].
  transitivity (IZR (orientation pr X) * (r ^ d * IZR (side pr i X q w))); [ring|].
  rewrite <- E. field. lra.
Qed.
Lemma coordinate_positive q w i : (i <= d)%nat -> well_shaped d q -> (0 < w)%Z ->
  ((0 <? coordinate_sign pr X q w i)%Z = true <-> 0 < bary t i (place_over q w)).
Proof.
  intros Hi Hq Hw. pose proof (coordinate_sign_bary q w i Hi Hq Hw) as E.
  pose proof square_positive. pose proof (IZR_lt _ _ Hw).
  rewrite Z.ltb_lt. split; intros P.
  - apply IZR_lt in P. rewrite E in P.
    apply Rmult_lt_reg_l with (IZR w * (IZR (orientation pr X) * IZR (orientation pr X))); nra.
  - apply lt_IZR. rewrite E. apply Rmult_lt_0_compat; [nra|assumption].
Qed.
Lemma coordinate_nonnegative q w i : (i <= d)%nat -> well_shaped d q -> (0 < w)%Z ->
  (0 <=? coordinate_sign pr X q w i)%Z = true -> 0 <= bary t i (place_over q w).
Proof.
  intros Hi Hq Hw P. pose proof (coordinate_sign_bary q w i Hi Hq Hw) as E.
  pose proof square_positive. pose proof (IZR_lt _ _ Hw).
  apply Z.leb_le, IZR_le in P. rewrite E in P.
  apply Rmult_le_reg_l with (IZR w * (IZR (orientation pr X) * IZR (orientation pr X))); nra.
Qed.
Lemma coordinate_negative q w i : (i <= d)%nat -> well_shaped d q -> (0 < w)%Z ->
  (coordinate_sign pr X q w i <? 0)%Z = true -> bary t i (place_over q w) < 0.
Proof.
  intros Hi Hq Hw P. pose proof (coordinate_sign_bary q w i Hi Hq Hw) as E.
  pose proof square_positive. pose proof (IZR_lt _ _ Hw).
  apply Z.ltb_lt, IZR_lt in P. rewrite E in P.
  apply Rmult_lt_reg_l with (IZR w * (IZR (orientation pr X) * IZR (orientation pr X))); nra.
Qed.

(** Heights of the caller's points. *)
Definition heights_of h X : Prop := forall p, In p X -> h (place p) = @height_of d r p.

Lemma below_sign_witness h p : heights_of h (p :: X) -> well_shaped d p ->
  r ^ 2 * IZR (below_sign pr X p) =
    IZR (orientation pr X) * IZR (orientation pr X) * (witness h t (place p) - h (place p)).
Proof.
  intros H Hp. destruct F as [HX L V O B].
  pose proof (computes_depth orient pr is_computed r X p HX L Hp) as E.
  pose proof (power_positive d) as P. pose proof (IZR_neq _ _ O) as O'.
  assert (W : orient (places X) * witness h t (place p) = sum (S d)
            (fun i => orient (replace i (place p) (places X)) * @height_of d r (nth i X p))).
  { unfold witness, sum. rewrite <- sum_scale. apply sum_ext. intros i Hi. apply in_seq_d in Hi.
    rewrite B by assumption.
    assert (N : nth_error X i = Some (nth i X p)) by (apply nth_error_nth'; lia).
    destruct (framed_vertex i _ N) as [_ ->].
    rewrite H by (right; now apply nth_error_In in N).
    field. rewrite orient_places by assumption. nra. }
  rewrite <- W, <- (H p (or_introl eq_refl)), orient_places, pow_add in E by assumption.
  unfold below_sign. rewrite mult_IZR. apply Rmult_eq_reg_l with (r ^ d); [|lra].
  transitivity (IZR (orientation pr X) * (r ^ d * r ^ 2 * IZR (depth pr X (slope pr X) p)));
    [ring|]. rewrite <- E. ring.
Qed.
Lemma below_witness h p : heights_of h (p :: X) -> well_shaped d p ->
  (0 <? below_sign pr X p)%Z = true -> h (place p) < witness h t (place p).
Proof.
  intros H Hp P. pose proof (below_sign_witness h p H Hp) as E. pose proof square_positive.
  pose proof (power_positive 2). apply Z.ltb_lt, IZR_lt in P.
  assert (0 < witness h t (place p) - h (place p)); [|lra].
  apply Rmult_lt_reg_l with (IZR (orientation pr X) * IZR (orientation pr X)); nra.
Qed.
Lemma above_witness_plane h p : heights_of h (p :: X) -> well_shaped d p ->
  (below_sign pr X p <? 0)%Z = true -> witness h t (place p) < h (place p).
Proof.
  intros H Hp P. pose proof (below_sign_witness h p H Hp) as E. pose proof square_positive.
  pose proof (power_positive 2). apply Z.ltb_lt, IZR_lt in P.
  assert (0 < h (place p) - witness h t (place p)); [|lra].
  apply Rmult_lt_reg_l with (IZR (orientation pr X) * IZR (orientation pr X)); nra.
Qed.
End Framed.

(** ** What two simplices share, and where points are *)

Section Two.
Variables (X Y : list site) (a b : frame d).
Hypothesis FX : framed X a.
Hypothesis FY : framed Y b.
Lemma framed_NoDup Z t : framed Z t -> NoDup (places Z).
Proof. intros F. rewrite <- (framed_vertices Z t F). apply vertices_NoDup. Qed.

(** The facet that the two share. *)
Lemma same_facet_shared i j : same_facet pr X i Y j = true ->
  let f := places (remove i X) in NoDup f /\ length f = d /\
  incl f (places X) /\ incl f (places Y) /\ same (remove i (places X)) (remove j (places Y)).
Proof.
  unfold same_facet. rewrite dimension_d, !andb_true_iff, !Nat.ltb_lt.
  intros [[Hi Hj] E].
  apply same_places_same in E.
  - cbn zeta. rewrite !remove_map in *. split; [|split; [|split; [|split]]].
    + apply remove_NoDup, (framed_NoDup X a FX).
    + pose proof (framed_length X a FX) as N.
      pose proof (remove_length i (places X)) as Q. rewrite map_length, N in Q.
      specialize (Q Hi). lia.
    + apply remove_incl.
    + intros v Hv. apply E in Hv. now apply remove_incl in Hv.
    + assumption.
  - eapply incl_Forall; [apply remove_incl|]. apply FX.
  - eapply incl_Forall; [apply remove_incl|]. apply FY.
Qed.
(** If the vertices off the facet are different points, so are the simplices. *)
Lemma other_apex_different i j : same (remove i (places X)) (remove j (places Y)) ->
  other_apex X i Y j = true -> ~ same (places X) (places Y).
Proof.
  unfold other_apex. intros [_ E] A [S1 _].
  destruct (nth_error X i) as [p|] eqn:Hp; [|discriminate].
  destruct (nth_error Y j) as [q|] eqn:Hq; [|discriminate].
  apply negb_true_iff in A.
  assert (N : place p <> place q).
  { intros E'. apply same_place_place in E'; [congruence| |].
    - apply (proj1 (Forall_forall _ _) (framed_shaped X a FX)).
      now apply nth_error_In in Hp.
    - apply (proj1 (Forall_forall _ _) (framed_shaped Y b FY)).
      now apply nth_error_In in Hq. }
  apply (map_nth_error place) in Hp, Hq.
  assert (I : In (place p) (remove j (places Y))).
  { apply remove_present with (place q); auto. apply S1. now apply nth_error_In in Hp. }
  apply E in I. revert I. apply remove_absent; [now apply (framed_NoDup X a)|assumption].
Qed.

(** The members of [carrier_of] are the vertices with positive coordinates. *)
Lemma carrier_of_carrier q w : well_shaped d q -> (0 < w)%Z ->
  same (places (carrier_of pr X q w)) (carrier a (place_over q w)).
Proof.
  intros Hq Hw. unfold carrier_of, corners_numbered. rewrite dimension_d.
  rewrite <- (framed_length X a FX).
  split; intros v Hv.
  - apply in_map_iff in Hv. destruct Hv as (p & <- & Hp). apply in_map_iff in Hp.
    destruct Hp as ((i & p') & E & Hp). cbn in E. subst p'. apply filter_In in Hp.
    destruct Hp as [Hp Q]. apply in_indexed in Hp. destruct Hp as [_ N].
    rewrite Nat.sub_0_r in N. destruct (framed_vertex X a FX i p N) as [Hi <-].
    apply in_carrier. exists i. split; [assumption|]. split; [|reflexivity].
    now apply (coordinate_positive X a FX).
  - apply in_carrier in Hv. destruct Hv as (i & Hi & Q & ->).
    assert (N : exists p, nth_error X i = Some p).
    { destruct (nth_error X i) eqn:N; [eauto|]. apply nth_error_None in N.
      rewrite (framed_length X a FX) in N. lia. }
    destruct N as (p & N). destruct (framed_vertex X a FX i p N) as [_ ->].
    apply in_map. apply in_map_iff. exists (i, p). split; [reflexivity|]. apply filter_In.
    split; [apply in_indexed; split; [lia|now rewrite Nat.sub_0_r]|].
    now apply (coordinate_positive X a FX).
Qed.
Lemma carrier_of_incl q w : incl (carrier_of pr X q w) X.
Proof.
  intros p Hp. unfold carrier_of in Hp. apply in_map_iff in Hp. destruct Hp as ((i & p') & E & Hp).
  cbn in E. subst p'. apply filter_In in Hp. destruct Hp as [Hp _]. now apply in_combine_r in Hp.
Qed.

(** Points in and beyond the simplex. *)
Lemma in_simplex_conv q w : well_shaped d q -> (0 < w)%Z -> in_simplex pr X q w = true ->
  inside_closed a (place_over q w) /\ conv (places X) (place_over q w).
Proof.
  intros Hq Hw I. rewrite <- (framed_vertices X a FX), conv_vertices.
  assert (H : inside_closed a (place_over q w)); [|now split].
  intros i Hi. unfold in_simplex, corners_numbered in I. rewrite dimension_d, forallb_forall in I.
  apply (coordinate_nonnegative X a FX); auto.
  apply I, in_seq. lia.
Qed.
Lemma strictly_in_simplex_inside q w : well_shaped d q -> (0 < w)%Z ->
  strictly_in_simplex pr X q w = true -> strictly_inside (places X) (place_over q w).
Proof.
  intros Hq Hw I. rewrite <- (framed_vertices X a FX).
  assert (H : inside a (place_over q w)).
  { intros i Hi. unfold strictly_in_simplex in I. rewrite forallb_forall in I.
    apply (coordinate_positive X a FX q w i Hi Hq Hw), I. unfold corners_numbered.
    rewrite dimension_d. now apply in_seq_d. }
  split; [apply conv_vertices; intros i Hi; left; auto|].
  intros f If C v Hv. apply (conv_face a f _ If) in C. destruct C as [_ C].
  apply in_vertices in Hv. destruct Hv as (i & Hi & ->). auto.
Qed.

Lemma beyond_not_conv q w i : well_shaped d q -> (0 < w)%Z -> beyond pr X q w i = true ->
  ~ conv (places X) (place_over q w).
Proof.
  intros Hq Hw B. unfold beyond in B. rewrite dimension_d, andb_true_iff, Nat.ltb_lt in B.
  destruct B as [Hi B]. rewrite <- (framed_vertices X a FX).
  apply beyond_outside with i; [lia|].
  apply (coordinate_negative X a FX); auto. lia.
Qed.
Lemma written q w : point_written pr q w = true -> well_shaped d q /\ (0 < w)%Z.
Proof.
  unfold point_written, shaped. rewrite andb_true_iff, Nat.eqb_eq, Z.ltb_lt, dimension_d. auto.
Qed.
End Two.
End Signs.
Arguments place_over {d} r q w.
Arguments heights_of {d} r h X.
Arguments framed {d} orient pr r X t.
