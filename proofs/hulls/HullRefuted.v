(** * What an accepted refutation of a convex hull says

    If points lie on both sides of a facet, one gets from a point inside of it nowhere out of their
    hull: on either side there is a d-simplex, of the facet and such a point.  And where no point is
    beyond a facet of a d-simplex of them, this facet is in the boundary. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Bool.
From Circumspect Require Import HullRefutation Numbering.
From Circumspect Require Import Definitions Domains Hulls Vectors Affine Frame Faces Orientation
  Integers RefutationSigns CallerMesh Breach.
From Circumspect Require MeshAloneSound.
Import ListNotations.
Open Scope R_scope.

Section Sides.
Context {d : nat}.
Variables (S : list (point d)) (f : simplex d) (a b : point d) (u v : frame d).
Hypotheses (Fu : vertices u = f ++ [a]) (Fv : vertices v = f ++ [b]).
Hypotheses (length_f : length f = d) (some_d : (0 < d)%nat).
Hypothesis other_side : bary u d b < 0.
Hypotheses (If : incl f S) (Ia : In a S) (Ib : In b S).

Lemma vertices_common : (forall i, (i < d)%nat -> vertex u i = vertex v i /\ In (vertex u i) f) /\
  vertex u d = a /\ vertex v d = b.
Proof.
  assert (At : forall (t : frame d) i, (i <= d)%nat -> vertex t i = nth i (vertices t) origin).
  { intros t i Hi. unfold vertices. rewrite (nth_indep _ origin (vertex t 0)), map_nth, seq_nth;
      [reflexivity|lia|rewrite map_length, seq_length; lia]. }
  split; [|split].
  - intros i Hi. rewrite !At, Fu, Fv, !app_nth1 by lia. split; [reflexivity|]. apply nth_In. lia.
  - rewrite At, Fu, app_nth2, length_f, Nat.sub_diag by lia. reflexivity.
  - rewrite At, Fv, app_nth2, length_f, Nat.sub_diag by lia. reflexivity.
Qed.

(** A point inside the facet: on the way from [a] through the middle of the simplex. *)
Lemma facet_inside : exists q, conv f q /\ bary u d q = 0 /\ bary v d q = 0 /\
  (forall i, (i < d)%nat -> 0 < bary u i q /\ bary v i q = bary u i q).
Proof.
  destruct vertices_common as (Com & Ea & Eb).
  set (k := / INR (Datatypes.S d)). assert (K : 0 < k < 1).
  { unfold k. assert (1 < INR (Datatypes.S d)) by (apply lt_1_INR; lia). split.
    - apply Rinv_0_lt_compat. lra.
    - rewrite <- Rinv_1. apply Rinv_lt_contravar; lra. }
  set (s := / (1 - k)). assert (E : s * (1 - k) = 1) by (unfold s; field; lra).
  assert (P : 0 < s) by (unfold s; apply Rinv_0_lt_compat; lra).
  set (q := mix a (barycentre u) s).
  assert (B : forall i, (i <= d)%nat -> bary u i q = (1 - s) * bary u i a + s * k).
  { intros i Hi. unfold q. rewrite (affine_mix _ _ _ _ (bary_affine u i Hi)).
    now rewrite bary_barycentre. }
  assert (Bd : bary u d q = 0).
  { rewrite B by lia. rewrite <- Ea, bary_own by lia. lra. }
  assert (Bi : forall i, (i < d)%nat -> bary u i q = s * k).
  { intros i Hi. rewrite B by lia. rewrite <- Ea, bary_other by lia. ring. }
  assert (V : forall i, (i <= d)%nat -> bary v i q =
    if Nat.eq_dec i d then 0 else bary u i q).
  { intros i Hi. rewrite (interpolation u (bary v i) q (bary_affine v i Hi)). unfold sum.
    assert (T : forall j, In j (seq 0 (Datatypes.S d)) ->
      bary u j q * bary v i (vertex u j) = if Nat.eq_dec j i then (if Nat.eq_dec i d then 0 else
        bary u i q) else 0).
    { intros j Hj. apply in_seq_d in Hj. destruct (Nat.eq_dec j d) as [->|N].
      - rewrite Bd. destruct (Nat.eq_dec d i) as [<-|]; [|ring].
        destruct (Nat.eq_dec d d); [ring|congruence].
      - rewrite (proj1 (Com j ltac:(lia))), bary_vertex by lia.
        destruct (Nat.eq_dec i j) as [<-|].
        + destruct (Nat.eq_dec i i), (Nat.eq_dec i d); congruence || ring.
        + destruct (Nat.eq_dec j i); [congruence|ring]. }
    rewrite (sum_ext _ _ _ T), (sum_one _ _ i); [|apply seq_NoDup|now apply in_seq_d|].
    - now destruct (Nat.eq_dec i i).
    - intros j _ N. destruct (Nat.eq_dec j i); congruence. }
  exists q. split.
  { apply (conv_incl (carrier u q)).
    - intros w Iw. apply in_carrier in Iw. destruct Iw as (i & Hi & Pi & ->).
      destruct (Nat.eq_dec i d) as [->|]; [lra|]. apply Com. lia.
    - apply conv_carrier. intros i Hi. destruct (Nat.eq_dec i d) as [->|]; [lra|].
      rewrite Bi by lia. nra. }
  split; [assumption|]. split; [rewrite V by lia; destruct (Nat.eq_dec d d); congruence|].
  intros i Hi. rewrite V, Bi by lia. destruct (Nat.eq_dec i d); [lia|]. split; [nra|reflexivity].
Qed.

(** The coordinates at [a] and at [b] have opposite signs. *)
Lemma opposite_coordinates r : bary u d r = bary v d r * bary u d b.
Proof.
  destruct vertices_common as (Com & _ & Eb).
  rewrite (interpolation v (bary u d) r (bary_affine u d (le_n d))). unfold sum.
  rewrite (sum_one _ _ d); [now rewrite Eb|apply seq_NoDup|now apply in_seq_d|].
  intros j Hj N. apply in_seq_d in Hj.
  rewrite <- (proj1 (Com j ltac:(lia))), bary_other by lia. ring.
Qed.

Lemma stays_inside (t : frame d) q r : incl (vertices t) S ->
  (forall i, (i < d)%nat -> 0 < bary t i q) ->
  bary t d q = 0 -> 0 <= bary t d r -> exists s, 0 < s <= 1 /\ conv S (between q r s).
Proof.
  intros I P Z R.
  destruct (nearby (map (bary t) (seq 0 d)) q r) as (e & He & N).
  { intros g Ig. apply in_map_iff in Ig. destruct Ig as (i & <- & Hi). apply in_seq in Hi.
    split; [apply bary_affine; lia|apply P; lia]. }
  exists e. split; [lra|]. change (between q r e) with (mix q r e).
  apply (conv_incl (vertices t)); [assumption|]. apply conv_vertices. intros i Hi.
  destruct (Nat.eq_dec i d) as [->|Ni].
  - rewrite (affine_mix _ _ _ _ (bary_affine t d Hi)), Z. nra.
  - left. apply (N e ltac:(lra)). apply in_map, in_seq. lia.
Qed.

Theorem no_boundary : exists q, conv f q /\
  ~ boundary (LinearCell d (fun _ => True) (conv S)) q.
Proof.
  destruct facet_inside as (q & C & Zu & Zv & P). exists q. split; [assumption|].
  intros (_ & r & _ & Out). cbn [cell_points] in Out.
  assert (Iu : incl (vertices u) S).
  { rewrite Fu. intros p I. apply in_app_or in I. destruct I as [I|[<-|[]]]; auto. }
  assert (Iv : incl (vertices v) S).
  { rewrite Fv. intros p I. apply in_app_or in I. destruct I as [I|[<-|[]]]; auto. }
  assert (Go : exists s, 0 < s <= 1 /\ conv S (between q r s)).
  { destruct (Rle_dec 0 (bary u d r)) as [H|H].
    - apply (stays_inside u); auto. intros i Hi. now apply P.
    - apply (stays_inside v); auto.
      + intros i Hi. destruct (P i Hi) as [A E]. now rewrite E.
      + apply Rnot_le_lt in H. rewrite opposite_coordinates in H. nra. }
  destruct Go as (s & Hs & Cs). now apply (Out s).
Qed.
End Sides.

(** Where no point is beyond a facet of a d-simplex, one gets out of the hull from each of its
    points, straight away from the vertex opposite. *)
Lemma facet_on_boundary {d} (S : list (point d)) (u : frame d) q : conv S q -> bary u d q = 0 ->
  (forall p, In p S -> 0 <= bary u d p) -> boundary (LinearCell d (fun _ => True) (conv S)) q.
Proof.
  intros C Z P. split; [exact C|]. exists (mix (vertex u d) q 2). split; [exact I|].
  intros s Hs Cs. cbn [cell_points] in Cs.
  assert (G : 0 <= bary u d (mix q (mix (vertex u d) q 2) s)).
  { apply (affine_conv (bary u d) S); [now apply bary_affine|exact P|exact Cs]. }
  rewrite !(affine_mix _ _ _ _ (bary_affine u d (le_n d))), Z, bary_own in G by lia. lra.
Qed.

Section Refuted.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis M : forall r, 0 < r -> measured orient pr r.
Hypothesis some_d : (0 < d)%nat.
Variables (m : refutation).
Notation r := (refuted_unit m).
Hypothesis U : 0 < r.
Hypothesis Sh : Forall (well_shaped d) (sites m).
Notation place := (@place_of d r).
Notation PS := (@caller_points d r (sites m)).
Notation LS := (@caller_rows d r (sites m) (rows m)).
Notation find_site := (find_id (sites m)).
Notation find_row := (find_id (rows m)).

Lemma replaced_last (X : list site) a b : replace (length X) b (X ++ [a]) = X ++ [b].
Proof. induction X as [|x X IH]; cbn; [reflexivity|]. now rewrite IH. Qed.

Theorem facet_shown t p q : row_at (Table.of_list id (rows m)) t (parted_by pr m p q) = true ->
  facet_not_supporting PS LS /\ ~ claims_hull PS LS.
Proof.
  intros A.
  apply (row_at_in (M r U) (sites m) (rows m) _ _ Sh find_site find_row) in A.
  destruct A as (row & _ & Ir & A). unfold parted_by in A. apply andb_prop in A.
  destruct A as [Len A]. rewrite (dimension_d (M r U)) in Len. apply has_length_length in Len.
  destruct (all_named _ row) as [f|] eqn:E; [|discriminate].
  apply (all_named_rows (M r U) (sites m) (rows m) _ (Table.of_list id (rows m))
    Sh find_site find_row) in E. destruct E as [E If].
  apply (point_at_in (M r U) (sites m) (rows m) _ _ Sh find_site find_row) in A.
  destruct A as (a & Ia & A).
  apply (point_at_in (M r U) (sites m) (rows m) _ _ Sh find_site find_row) in A.
  destruct A as (b & Ib & A). apply Z.ltb_lt in A.
  assert (Lf : length f = d).
  { apply (f_equal (@length _)) in E. rewrite !map_length in E. congruence. }
  assert (Fr : forall s, In s (sites m) -> orientation pr (f ++ [s]) <> 0%Z ->
    exists g : frame d, framed orient pr r (f ++ [s]) g).
  { intros s Is N. apply (proper_framed (M r U)).
    - apply Forall_app. split; [eapply incl_Forall; eassumption|]. constructor; [|constructor].
      rewrite Forall_forall in Sh. now apply Sh.
    - rewrite app_length, Lf. cbn. lia.
    - unfold proper. now apply negb_true_iff, Z.eqb_neq. }
  destruct (Fr a Ia ltac:(nia)) as (u & Fu). destruct (Fr b Ib ltac:(nia)) as (v & Fv).
  pose proof (framed_vertices _ _ Fu) as Vu. pose proof (framed_vertices _ _ Fv) as Vv.
  rewrite map_app in Vu, Vv. cbn [map] in Vu, Vv.
  assert (Side : bary u d (place b) < 0).
  { assert (Rp : replace d (place b) (map place (f ++ [a])) = map place (f ++ [b])).
    { pose proof (replaced_last f a b) as Rl. rewrite Lf in Rl. now rewrite <- replace_map, Rl. }
    rewrite (framed_bary _ _ Fu d (place b) (le_n d)), Rp.
    rewrite (orient_places (M r U) _ (framed_shaped _ _ Fu)),
      (orient_places (M r U) _ (framed_shaped _ _ Fv)).
    pose proof (power_positive (M r U) d) as Pp. apply IZR_lt in A. rewrite mult_IZR in A.
    pose proof (square_positive _ _ Fu) as Sq. set (x := IZR (orientation pr (f ++ [a]))) in *.
    set (y := IZR (orientation pr (f ++ [b]))) in *.
    assert (x <> 0) by (intros Z; rewrite Z in Sq; lra).
    replace (r ^ d * y / (r ^ d * x)) with (x * y / (x * x)) by (field; split; [assumption|lra]).
    apply Ropp_lt_cancel. rewrite Ropp_0, <- Ropp_div.
    apply Rdiv_lt_0_compat; lra. }
  assert (Lm : length (map place f) = d) by now rewrite map_length.
  assert (IfS : incl (map place f) PS) by now apply incl_map.
  assert (Ia' : In (place a) PS) by now apply in_map.
  assert (Ib' : In (place b) PS) by now apply in_map.
  split.
  - exists (map place f), (place a), (place b). split; [unfold listed; now rewrite <- E|].
    split; [assumption|]. split.
    { apply (face_independent u).
      - rewrite Vu. now apply incl_appl, incl_refl.
      - pose proof (vertices_NoDup u) as N. rewrite Vu in N.
        now apply MeshAloneSound.NoDup_front in N. }
    split; [assumption|]. split; [assumption|].
    destruct (vertices_common (map place f) (place a) (place b) u v Vu Vv Lm some_d)
      as (Com & Ea & _).
    destruct (bary_affine u d (le_n d)) as (n & c & Eg). unfold on_opposite_sides.
    exists n, c. rewrite <- !Eg.
    split; [|split; [rewrite <- Ea, bary_own by lia; lra|assumption]].
    intros w Iw. rewrite <- Eg. destruct (In_nth _ _ origin Iw) as (i & Hi & <-).
    assert (Ew : nth i (map place f) origin = vertex u i).
    { assert (Ev : nth i (vertices u) origin = vertex u i).
      { unfold vertices. rewrite (nth_indep _ origin (vertex u 0)), map_nth, seq_nth;
          [reflexivity|lia|rewrite map_length, seq_length; lia]. }
      rewrite <- Ev, Vu, app_nth1 by assumption. reflexivity. }
    rewrite Ew. apply bary_other; lia.
  - intros (H & EH & B).
    destruct (no_boundary PS (map place f) (place a) (place b) u v Vu Vv Lm some_d Side IfS Ia' Ib')
      as (c & Cc & Nb).
    apply Nb, (facets_cover PS H B). exists (map place f). split; [|assumption].
    apply listed_in. rewrite <- EH. unfold listed. now rewrite <- E.
Qed.

Lemma simplex_framed X : incl X (sites m) -> length X = Datatypes.S d -> proper pr X = true ->
  exists g : frame d, framed orient pr r X g.
Proof. intros I. apply (proper_framed (M r U)). eapply incl_Forall; eassumption. Qed.

(** A point that is in the hull of a row has no negative coordinate in a simplex that the row makes
    with another point, and that at the other point is zero. *)
Lemma off_points_off X q w f : incl X (sites m) -> incl f (sites m) -> length f = d ->
  well_shaped d q -> (0 < w)%Z -> off_points pr X q w f = true ->
  ~ conv (map place f) (place_over r q w).
Proof.
  intros IX If L Sq W H C. unfold off_points in H. apply existsb_exists in H.
  destruct H as (x & Ix & H). apply andb_prop in H. destruct H as [Pr H].
  destruct (simplex_framed (f ++ [x])) as (g & G).
  { apply incl_app; [assumption|]. intros s [<-|[]]. now apply IX. }
  { rewrite app_length, L. cbn. lia. }
  { assumption. }
  assert (V : forall v, In v (map place f) -> exists j, (j < d)%nat /\ v = vertex g j).
  { intros v Iv. apply in_map_iff in Iv. destruct Iv as (s & <- & Is).
    destruct (In_nth_error f s Is) as (j & Ej). exists j.
    assert (Hj : (j < length f)%nat) by (apply nth_error_Some; congruence).
    split; [lia|]. symmetry. apply (framed_vertex _ g G j s). now rewrite nth_error_app1. }
  apply orb_prop in H. destruct H as [H|H].
  - apply existsb_exists in H. destruct H as (i & Hi & H). unfold corners_numbered in Hi.
    rewrite (dimension_d (M r U)) in Hi. apply in_seq_d in Hi.
    apply (coordinate_negative (M r U) _ g G q w i Hi Sq W) in H.
    enough (0 <= bary g i (place_over r q w)) by lra.
    apply (affine_conv (bary g i) (map place f)); [now apply bary_affine| |assumption].
    intros v Iv. destruct (V v Iv) as (j & Hj & ->). rewrite bary_vertex by lia.
    destruct (Nat.eq_dec i j); lra.
  - rewrite (dimension_d (M r U)) in H.
    apply (coordinate_positive (M r U) _ g G q w d (le_n d) Sq W) in H.
    enough (0 <= - bary g d (place_over r q w)) by lra.
    apply (affine_conv (fun p => - bary g d p) (map place f));
      [now apply affine_opp, bary_affine| |assumption].
    intros v Iv. destruct (V v Iv) as (j & Hj & ->). rewrite bary_other by lia. lra.
Qed.

Theorem uncovered_shown X q w : incl X (sites m) -> in_no_facet pr m X q w = true ->
  hull_uncovered PS LS /\ ~ claims_hull PS LS.
Proof.
  intros IX A. unfold in_no_facet in A. rewrite !andb_true_iff in A.
  destruct A as [[[[[[Len Pr] Wr] In_] Zero] Sup] Rows].
  unfold right_length in Len. rewrite (dimension_d (M r U)) in Len, Zero, Sup.
  apply has_length_length in Len. destruct (written (M r U) q w Wr) as [Sq W].
  destruct (simplex_framed X IX Len Pr) as (g & G).
  destruct (in_simplex_conv (M r U) X g G q w Sq W In_) as [_ C].
  assert (Out : hull_uncovered PS LS).
  { exists (place_over r q w). split.
    - apply (facet_on_boundary PS g).
      + apply (conv_incl (map place X)); [now apply incl_map|assumption].
      + apply Z.eqb_eq in Zero.
        pose proof (coordinate_sign_bary (M r U) X g G q w d (le_n d) Sq W) as E.
        rewrite Zero in E. symmetry in E. apply Rmult_integral in E. destruct E as [E|E]; [|assumption].
        pose proof (square_positive X g G). apply IZR_lt in W. nra.
      + intros p Ip. apply in_map_iff in Ip. destruct Ip as (s & <- & Is).
        rewrite forallb_forall in Sup. rewrite <- place_over_one.
        apply (coordinate_nonnegative (M r U) X g G s 1 d (le_n d)); [|reflexivity|now apply Sup].
        rewrite Forall_forall in Sh. now apply Sh.
    - intros f Lf. unfold listed, caller_rows in Lf. apply in_map_iff in Lf.
      destruct Lf as (row & E & Ir). rewrite forallb_forall in Rows. specialize (Rows row Ir).
      unfold off_row in Rows. apply andb_prop in Rows. destruct Rows as [Lr Off].
      rewrite (dimension_d (M r U)) in Lr. apply has_length_length in Lr.
      destruct (all_named _ row) as [Y|] eqn:Ey; [|discriminate].
      apply (all_named_rows (M r U) (sites m) (rows m) _ (Table.of_list id (rows m))
        Sh find_site find_row) in Ey. destruct Ey as [Ey Iy].
      assert (f = map place Y) as ->.
      { apply (f_equal (map (fun o => match o with Some v => v | None => origin end))) in E.
        rewrite Ey, !map_map in E. rewrite map_id in E. symmetry. exact E. }
      apply (off_points_off X q w Y); try assumption.
      apply (f_equal (@length _)) in Ey. rewrite !map_length in Ey. congruence. }
  split; [assumption|]. destruct Out as (v & B & N). intros (H & EH & Hull).
  apply (facets_cover PS H Hull) in B. destruct B as (f & If & Cf). apply (N f); [|assumption].
  unfold listed. rewrite EH. now apply in_map.
Qed.

Theorem hull_shown e : shown_of_hull pr m e = true ->
  broken_of_hull e PS LS /\ ~ claims_hull PS LS.
Proof.
  destruct e as [t p q|X q w]; cbn [shown_of_hull broken_of_hull]; [apply facet_shown|].
  intros A. destruct (all_named _ (map Some X)) as [Y|] eqn:E; [|discriminate].
  apply (all_named_rows (M r U) (sites m) (rows m) _ (Table.of_list id (rows m))
    Sh find_site find_row) in E. now apply (uncovered_shown Y q w).
Qed.
End Refuted.

(** Whatever is accepted: the claim is false, because the rule is broken. *)
Theorem refute_hull_rule D x : refute_hull D x = true ->
  broken_of_hull (hull_because x) (refuted_points D (hull_mesh x))
    (refuted_simplices D (hull_mesh x)) /\
  ~ claims_hull (refuted_points D (hull_mesh x)) (refuted_simplices D (hull_mesh x)).
Proof.
  intros A. unfold refute_hull, refute_hull_in in A. rewrite !andb_true_iff in A.
  destruct A as [[[Pn Pd] Ss] A]. apply Z.ltb_lt, IZR_lt in Pn, Pd.
  assert (U : 0 < refuted_unit (hull_mesh x)) by now apply Rdiv_lt_0_compat.
  assert (Sh : Forall (well_shaped (dimension_of D)) (sites (hull_mesh x))).
  { apply Forall_forall. intros s I. rewrite forallb_forall in Ss. specialize (Ss s I).
    unfold shaped in Ss. apply Nat.eqb_eq in Ss. now destruct D. }
  destruct D.
  - exact (hull_shown measured_plane ltac:(cbn; lia) _ U Sh _ A).
  - exact (hull_shown measured_space ltac:(cbn; lia) _ U Sh _ A).
Qed.
