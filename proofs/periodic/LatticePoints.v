(** * Points that a lattice moves, and moves that are too far

    A moved site is where its place is moved to ([place_shifted]).  The dual basis tells by which
    multiples a lattice vector moves ([dual_shift]), so those within reach that the checker tries
    are all that matter ([everywhere_sound]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Bool.
From Circumspect Require Import PeriodicChecker Numbering Definitions Vectors Affine Frame Faces.
From Circumspect Require Import Walk Orientation Integers RefutationSigns.
From Circumspect Require Balls.
Import ListNotations.
Open Scope R_scope.

Section Lists.
Lemma add_length n : forall k l, length k = n -> length l = n -> length (add_numbers k l) = n.
Proof.
  induction n as [|n IH]; intros [|x k] [|y l] K L; try discriminate; [reflexivity|].
  cbn in *. f_equal. apply IH; lia.
Qed.
Lemma add_nth n : forall k l, length k = n -> length l = n ->
  forall a, nth a (add_numbers k l) 0%Z = (nth a k 0 + nth a l 0)%Z.
Proof.
  induction n as [|n IH]; intros [|x k] [|y l] K L a; try discriminate; [now destruct a|].
  destruct a as [|a]; [reflexivity|]. cbn in *. apply IH; lia.
Qed.
Lemma numbers_ext n (k l : list Z) : length k = n -> length l = n ->
  (forall a, (a < n)%nat -> nth a k 0%Z = nth a l 0%Z) -> k = l.
Proof. intros K L H. apply (nth_ext _ _ 0%Z 0%Z); [congruence|]. intros a Ha. apply H. lia. Qed.
Lemma zero_nth l : all_zero l = true -> forall a, nth a l 0%Z = 0%Z.
Proof.
  unfold all_zero. rewrite forallb_forall. intros H a.
  destruct (nth_in_or_default a l 0%Z) as [I|E]; [|exact E]. specialize (H _ I).
  apply Z.eqb_eq in H. congruence.
Qed.
Lemma zeros_all n : all_zero (repeat 0%Z n) = true.
Proof. induction n; [reflexivity|assumption]. Qed.

Lemma opposite_zero l : all_zero (add_numbers (opposite_numbers l) l) = true.
Proof.
  unfold opposite_numbers. induction l as [|z l IH]; [reflexivity|].
  apply andb_true_intro. split; [apply Z.eqb_eq; lia|exact IH].
Qed.

Lemma in_choices : forall (l : list (list Z)) o, length o = length l ->
  (forall a, (a < length l)%nat -> In (nth a o 0%Z) (nth a l [])) -> In o (choices l).
Proof.
  induction l as [|k l IH]; intros [|z o] L H; try discriminate; [now left|].
  cbn [choices]. apply in_flat_map. exists z. split; [apply (H 0%nat); cbn; lia|].
  apply in_map, IH; [now injection L|]. intros a Ha. apply (H (S a)). cbn. lia.
Qed.
Lemma last_default {A} (l : list A) x y z : last (x :: l) y = last (x :: l) z.
Proof. revert x. induction l as [|w l IH]; intros x; [reflexivity|]. apply (IH w). Qed.
Lemma consecutive_in : forall l z k, consecutive z l = true ->
  (z <= k <= last l z)%Z -> In k (z :: l).
Proof.
  induction l as [|y l IH]; intros z k C H; [cbn in H; left; lia|].
  cbn [consecutive] in C. apply andb_prop in C. destruct C as [E C]. apply Z.eqb_eq in E.
  destruct (Z.eq_dec k z) as [->|N]; [now left|right]. subst y. apply IH; [assumption|].
  split; [lia|]. destruct l as [|x l]; [cbn in *; lia|].
  rewrite (last_default l x _ z). apply H.
Qed.
End Lists.

(** The combination of vectors, seen by a linear function. *)
Lemma inner_combine {d} (c : point d) (a : list R) (X : list (point d)) : length a = length X ->
  inner c (combination (combine a X)) =
    sum (length X) (fun k => nth k a 0 * inner c (nth k X origin)).
Proof.
  intros L. replace a with (map (fun k => nth k a 0) (seq 0 (length X))) at 1.
  - rewrite combine_positions. unfold sum. induction (seq 0 (length X)) as [|k l IH].
    + apply inner_origin_r.
    + cbn [map sum_over]. rewrite combination_cons, inner_plus_r, inner_scale_r, IH. reflexivity.
  - apply nth_ext with (d := 0) (d' := 0); [now rewrite map_length, seq_length|].
    intros k Hk. rewrite map_length, seq_length in Hk.
    rewrite (nth_indep _ 0 (nth 0 a 0)), (map_nth (fun k => nth k a 0)), seq_nth by
      (rewrite ?map_length, ?seq_length; lia). reflexivity.
Qed.
(** Where an affine function is positive at all points, it is on their hull. *)
Lemma positive_conv {d} (f : point d -> R) X q : affine f -> (forall p, In p X -> 0 < f p) ->
  conv X q -> 0 < f q.
Proof.
  intros A H C. destruct X as [|x X]; [now apply conv_empty in C|].
  destruct (smallest f (x :: X)) as (p & Ip & Min); [discriminate|].
  assert (0 <= f q - f p); [|specialize (H p Ip); lra].
  apply (affine_conv (fun y => f y - f p) (x :: X)); [|intros y Iy; specialize (Min y Iy); lra|
    assumption].
  apply (affine_ext (fun y => 1 * f y + (-1) * f p)); [intros; ring|].
  now apply (affine_combine f (fun _ => f p) 1 (-1) A), affine_const.
Qed.

Section Lattice.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Variable m : periodic_mesh.
Notation r := (periodic_unit m).
Hypothesis M : measured orient pr r.
Hypothesis proper : proper_periodic pr m = true.
Hypothesis lattice : proper_lattice pr m = true.
Notation place := (@place_of d r).
Notation places := (map (@place_of d r)).
Notation B := (lattice_of d m).
Definition shift (o : list Z) : point d := combination (combine (map IZR o) B).

(* So that all lemmas have the same arguments. *)
Set Default Proof Using "All".

Lemma unit_positive : 0 < r.
Proof. exact (measured_unit orient pr r M). Qed.
Lemma lattice_parts : length (basis_rows m) = d /\ length (dual_rows m) = d /\
  Forall (fun b => length b = d) (basis_rows m) /\ Forall (fun n => length n = d) (dual_rows m) /\
  (0 < dual_factor m)%Z /\
  forall a b, (a < d)%nat -> (b < d)%nat ->
    inner_product (nth a (dual_rows m) []) (nth b (basis_rows m) []) =
      if Nat.eq_dec a b then dual_factor m else 0%Z.
Proof.
  pose proof lattice as H. unfold proper_lattice in H. rewrite !andb_true_iff in H.
  destruct H as [[[[[Lb Ld] Fb] Fd] Pd] H]. apply Nat.eqb_eq in Lb, Ld. apply Z.ltb_lt in Pd.
  rewrite (dimension_d M) in Lb, Ld. split; [assumption|]. split; [assumption|].
  assert (Fl : forall l, forallb (of_dimension pr) l = true -> Forall (fun b => length b = d) l).
  { intros l F. apply Forall_forall. intros b I. rewrite forallb_forall in F. specialize (F b I).
    unfold of_dimension in F. apply Nat.eqb_eq in F. now rewrite (dimension_d M) in F. }
  split; [now apply Fl|]. split; [now apply Fl|]. split; [assumption|].
  intros a b Ha Hb. rewrite forallb_forall in H.
  assert (In_rows : forall l k, (k < length l)%nat -> In (k, nth k l []) (numbered_rows l)).
  { intros l k Hk. unfold numbered_rows. apply in_indexed. split; [lia|]. rewrite Nat.sub_0_r.
    now apply nth_error_nth'. }
  specialize (H _ (In_rows (dual_rows m) a ltac:(lia))). rewrite forallb_forall in H.
  specialize (H _ (In_rows (basis_rows m) b ltac:(lia))). cbn [fst snd] in H.
  apply Z.eqb_eq in H. rewrite H. destruct (Nat.eqb_spec a b), (Nat.eq_dec a b); congruence.
Qed.
Lemma lattice_length : length B = d.
Proof. unfold lattice_of. rewrite map_length. now destruct lattice_parts. Qed.
Lemma lattice_nth b : (b < d)%nat ->
  nth b B origin = scale r (integer_point d (nth b (basis_rows m) [])).
Proof.
  intros Hb. destruct lattice_parts as (Lb & _). unfold lattice_of.
  rewrite (nth_indep _ origin (scale r (integer_point d []))) by (rewrite map_length; lia).
  apply (map_nth (fun b => scale r (integer_point d b))).
Qed.
Lemma sites_shaped : Forall (well_shaped d) (periodic_sites m).
Proof.
  pose proof proper as H. unfold proper_periodic in H. rewrite !andb_true_iff in H.
  destruct H as [_ H]. apply Forall_forall. intros s I. rewrite forallb_forall in H.
  specialize (H s I). unfold shaped in H. apply Nat.eqb_eq in H. now rewrite (dimension_d M) in H.
Qed.

(** ** Moved sites *)

Lemma integer_sum n : forall k l, length k = n -> length l = n ->
  integer_point n (add_numbers k l) = plus (integer_point n k) (integer_point n l).
Proof.
  clear. induction n as [|n IH]; intros [|x k] [|y l] K L; try discriminate; [reflexivity|].
  cbn [add_numbers integer_point hd tl]. unfold plus in *. cbn [Vector.map2].
  cbn. rewrite plus_IZR. f_equal. apply IH; cbn in *; lia.
Qed.
Lemma integer_multiple n z : forall k, length k = n ->
  integer_point n (map (Z.mul z) k) = scale (IZR z) (integer_point n k).
Proof.
  clear. induction n as [|n IH]; intros [|x k] K; try discriminate; [reflexivity|].
  cbn [map integer_point hd tl]. unfold scale in *. cbn. rewrite mult_IZR. f_equal.
  apply IH. cbn in *. lia.
Qed.
Lemma shifted_rows (rows : list (list Z)) p : Forall (fun b => length b = d) rows ->
  length p = d -> forall o,
  let s := fold_right (fun zb s => add_numbers (map (Z.mul (fst zb)) (snd zb)) s) p
    (combine o rows) in
  length s = d /\ scale r (integer_point d s) =
    plus (combination (combine (map IZR o) (map (fun b => scale r (integer_point d b)) rows)))
      (scale r (integer_point d p)).
Proof.
  intros F Lp. induction F as [|b rows Lb F IH]; intros o.
  - destruct o; cbn; (split; [assumption|now rewrite origin_plus]).
  - destruct o as [|z o]; [cbn; split; [assumption|now rewrite origin_plus]|].
    destruct (IH o) as [Ls E]. cbn [combine fold_right map fst snd]. split.
    + apply add_length; [now rewrite map_length|assumption].
    + rewrite integer_sum, integer_multiple by (rewrite ?map_length; assumption).
      rewrite scale_plus, E, combination_cons, plus_assoc, !scale_scale. f_equal. f_equal. f_equal.
      ring.
Qed.
Lemma place_shifted o p : well_shaped d p ->
  well_shaped d (shifted m o p) /\ place (shifted m o p) = plus (shift o) (place p).
Proof.
  intros S. destruct lattice_parts as (_ & _ & F & _).
  apply (shifted_rows (basis_rows m) (coordinates p) F S o).
Qed.
Lemma shifted_all o X : Forall (well_shaped d) X ->
  Forall (well_shaped d) (map (shifted m o) X) /\
  places (map (shifted m o) X) = moved (shift o) (places X).
Proof.
  intros F. unfold moved. induction F as [|p X S F [G E]]; [split; [constructor|reflexivity]|].
  destruct (place_shifted o p S) as [S' P]. split; [now constructor|]. cbn [map]. now rewrite P, E.
Qed.

(** ** The dual basis *)

Definition dual (a : nat) : point d :=
  scale (/ (r * IZR (dual_factor m))) (integer_point d (nth a (dual_rows m) [])).
Lemma factor_positive : 0 < IZR (dual_factor m).
Proof. destruct lattice_parts as (_ & _ & _ & _ & P & _). now apply IZR_lt. Qed.
Lemma dual_length a : (a < d)%nat -> length (nth a (dual_rows m) []) = d.
Proof.
  intros Ha. destruct lattice_parts as (_ & Ld & _ & F & _). rewrite Forall_forall in F.
  apply F, nth_In. lia.
Qed.
Lemma dual_scaled a (u : R) k : (a < d)%nat -> length k = d ->
  inner (dual a) (scale u (integer_point d k)) =
    u / r * (IZR (inner_product (nth a (dual_rows m) []) k) / IZR (dual_factor m)).
Proof.
  intros Ha L. unfold dual. rewrite inner_scale, inner_scale_r, Balls.inner_of_integers
    by (assumption || now apply dual_length).
  pose proof unit_positive. pose proof factor_positive. field. lra.
Qed.
Lemma dual_combination a (x : list R) : (a < d)%nat -> length x = d ->
  inner (dual a) (combination (combine x B)) = nth a x 0.
Proof.
  intros Ha L. pose proof lattice_length as LB. rewrite inner_combine by congruence.
  unfold sum. rewrite LB. rewrite (sum_one _ _ a).
  - replace (inner (dual a) (nth a B origin)) with 1; [ring|].
    destruct lattice_parts as (Lb & _ & F & _ & _ & D). rewrite lattice_nth by lia.
    rewrite Forall_forall in F. rewrite dual_scaled by (assumption || apply F, nth_In; lia).
    rewrite D by assumption. destruct (Nat.eq_dec a a); [|congruence].
    pose proof unit_positive. pose proof factor_positive. field. lra.
  - apply seq_NoDup.
  - apply in_seq. lia.
  - intros b Ib N. apply in_seq in Ib. apply Rmult_eq_0_compat_l.
    destruct lattice_parts as (Lb & _ & F & _ & _ & D). rewrite lattice_nth by lia.
    rewrite Forall_forall in F. rewrite dual_scaled by (assumption || apply F, nth_In; lia).
    rewrite D by lia. destruct (Nat.eq_dec a b); [congruence|].
    pose proof unit_positive. pose proof factor_positive. field. lra.
Qed.
Lemma dual_shift a o : (a < d)%nat -> length o = d -> inner (dual a) (shift o) = IZR (nth a o 0%Z).
Proof.
  intros Ha L. unfold shift. rewrite dual_combination by (rewrite ?map_length; assumption).
  change 0 with (IZR 0). now rewrite map_nth.
Qed.
Lemma shift_inj o o' : length o = d -> length o' = d -> shift o = shift o' -> o = o'.
Proof.
  intros L L' E. apply (numbers_ext d); [assumption..|]. intros a Ha. apply eq_IZR.
  rewrite <- !dual_shift by assumption. now rewrite E.
Qed.
Lemma basis_independent : basis_of_space B.
Proof.
  split; [apply lattice_length|]. intros x L E c I. rewrite lattice_length in L.
  destruct (In_nth _ _ 0 I) as (a & Ha & <-). rewrite L in Ha.
  rewrite <- (dual_combination a x Ha L), E. apply inner_origin_r.
Qed.
Lemma shift_zero o : all_zero o = true -> shift o = origin.
Proof.
  unfold shift. generalize B. clear. induction o as [|z o IH]; intros [|b l] H; try reflexivity.
  cbn [map combine]. unfold all_zero in H. cbn [forallb] in H. apply andb_prop in H.
  destruct H as [Z H]. apply Z.eqb_eq in Z. subst z. rewrite combination_cons.
  rewrite IH by assumption. now rewrite scale_zero, plus_origin.
Qed.
Lemma shift_sum o o' : length o = d -> length o' = d ->
  shift (add_numbers o o') = plus (shift o) (shift o').
Proof.
  intros L L'. rewrite <- lattice_length in L, L'. unfold shift. revert o o' L L'. generalize B.
  clear. induction l as [|b l IH]; intros [|x o] [|y o'] L L'; try discriminate.
  - symmetry. apply plus_origin.
  - cbn [add_numbers map combine]. rewrite !combination_cons, IH by (cbn in *; lia).
    rewrite plus_IZR, plus_scale, <- !plus_assoc. f_equal. rewrite !plus_assoc. f_equal.
    apply plus_comm.
Qed.
Lemma shift_vector o : length o = d -> lattice_vector B (shift o).
Proof. intros L. exists o. split; [|reflexivity]. now rewrite lattice_length. Qed.
Lemma vector_shift v : lattice_vector B v -> exists o, length o = d /\ v = shift o.
Proof. intros (o & L & E). exists o. split; [|exact E]. now rewrite <- lattice_length. Qed.

(** ** All moves *)

Section Everywhere.
Variables (X : list site) (q : site) (w : Z).
Hypothesis X_shaped : Forall (well_shaped d) X.
Hypothesis q_shaped : well_shaped d q.
Hypothesis w_positive : (0 < w)%Z.

Lemma axis_value a p o : (a < d)%nat -> length o = d -> In p X ->
  inner (dual a) (plus (shift o) (place p)) - inner (dual a) (place_of (r / IZR w) q) =
    IZR (w * inner_product (nth a (dual_rows m) []) (coordinates p)
      + nth a o 0%Z * (w * dual_factor m)
      - inner_product (nth a (dual_rows m) []) (coordinates q)) / (IZR w * IZR (dual_factor m)).
Proof.
  intros Ha L I. rewrite Forall_forall in X_shaped. rewrite inner_plus_r, dual_shift by assumption.
  unfold place_of. rewrite !dual_scaled by (assumption || now apply X_shaped).
  rewrite minus_IZR, plus_IZR, !mult_IZR. pose proof unit_positive. pose proof factor_positive.
  apply IZR_lt in w_positive. field. lra.
Qed.
Lemma not_apart_in a k o : (a < d)%nat -> length o = d ->
  not_apart m X q w (nth a (dual_rows m) []) = Some k ->
  conv (moved (shift o) (places X)) (place_of (r / IZR w) q) -> In (nth a o 0%Z) k.
Proof.
  intros Ha L E C. unfold not_apart in E. destruct (reach m) as [|z l] eqn:Er; [discriminate|].
  set (n := nth a (dual_rows m) []) in *. set (z0 := nth a o 0%Z).
  set (values := map _ X) in E. set (value := inner_product n (coordinates q)) in E.
  set (step := (w * dual_factor m)%Z) in E.
  assert (St : (0 < step)%Z) by (destruct lattice_parts as (_ & _ & _ & _ & P & _); nia).
  assert (Rs : 0 < IZR w * IZR (dual_factor m)).
  { rewrite <- mult_IZR. now apply IZR_lt. }
  assert (Low : forall k', (z0 <= k')%Z ->
    forallb (fun x => (x + k' * step <? value)%Z) values = true -> False).
  { intros k' Le F. rewrite forallb_forall in F.
    set (f y := inner (dual a) (place_of (r / IZR w) q) - inner (dual a) y).
    assert (0 < f (place_of (r / IZR w) q)); [|unfold f in *; lra].
    apply (positive_conv f (moved (shift o) (places X))); [|intros y Iy|assumption].
    - exists (scale (-1) (dual a)), (inner (dual a) (place_of (r / IZR w) q)). intros y.
      unfold f, plane. rewrite inner_scale. ring.
    - apply in_map_iff in Iy. destruct Iy as (y' & <- & Iy). apply in_map_iff in Iy.
      destruct Iy as (p & <- & Ip).
      specialize (F _ (in_map (fun p => (w * inner_product n (coordinates p))%Z) X p Ip)).
      apply Z.ltb_lt in F. pose proof (axis_value a p o Ha L Ip) as V. fold n z0 value step in V.
      assert (N : (w * inner_product n (coordinates p) + z0 * step - value < 0)%Z) by nia.
      apply IZR_lt in N. unfold f.
      enough (0 < - (IZR (w * inner_product n (coordinates p) + z0 * step - value)
        / (IZR w * IZR (dual_factor m)))) by lra.
      rewrite <- Ropp_div. apply Rdiv_lt_0_compat; lra. }
  assert (High : forall k', (k' <= z0)%Z ->
    forallb (fun x => (value <? x + k' * step)%Z) values = true -> False).
  { intros k' Le F. rewrite forallb_forall in F.
    set (f y := inner (dual a) y - inner (dual a) (place_of (r / IZR w) q)).
    assert (0 < f (place_of (r / IZR w) q)); [|unfold f in *; lra].
    apply (positive_conv f (moved (shift o) (places X))); [|intros y Iy|assumption].
    - exists (dual a), (- inner (dual a) (place_of (r / IZR w) q)). intros y.
      unfold f, plane. ring.
    - apply in_map_iff in Iy. destruct Iy as (y' & <- & Iy). apply in_map_iff in Iy.
      destruct Iy as (p & <- & Ip).
      specialize (F _ (in_map (fun p => (w * inner_product n (coordinates p))%Z) X p Ip)).
      apply Z.ltb_lt in F. unfold f. rewrite (axis_value a p o Ha L Ip). fold n z0 value step.
      assert (N : (0 < w * inner_product n (coordinates p) + z0 * step - value)%Z) by nia.
      apply IZR_lt in N. now apply Rdiv_lt_0_compat. }
  destruct (consecutive z l) eqn:Co; [|discriminate]. cbn [andb] in E.
  destruct (forallb (fun x => (x + (z - 1) * step <? value)%Z) values) eqn:E1; [|discriminate].
  destruct (forallb (fun x => (value <? x + (last l z + 1) * step)%Z) values) eqn:E2;
    [|discriminate].
  apply (f_equal (fun x => match x with Some y => y | None => [] end)) in E.
  cbv beta iota delta [andb] in E. rewrite <- E. fold z0. apply filter_In. split.
  - apply consecutive_in; [assumption|]. split.
    + destruct (Z_le_gt_dec z z0); [assumption|exfalso]. apply (Low (z - 1)%Z); [lia|assumption].
    + destruct (Z_le_gt_dec z0 (last l z)); [assumption|exfalso].
      apply (High (last l z + 1)%Z); [lia|assumption].
  - apply negb_true_iff, orb_false_iff.
    split; apply not_true_iff_false; intros F; [apply (Low z0)|apply (High z0)]; auto; lia.
Qed.

Theorem everywhere_sound test o : everywhere m X q w test = true -> length o = d ->
  conv (moved (shift o) (places X)) (place_of (r / IZR w) q) -> test o = true.
Proof.
  intros E L C. unfold everywhere in E.
  destruct (each_axis m X q w (dual_rows m)) as [l|] eqn:Ea; [|discriminate].
  rewrite forallb_forall in E. apply E.
  assert (G : forall rows l', each_axis m X q w rows = Some l' -> length l' = length rows /\
    forall a, (a < length rows)%nat -> not_apart m X q w (nth a rows []) = Some (nth a l' [])).
  { clear. induction rows as [|n rows IH]; intros l' H; cbn [each_axis] in H.
    - injection H as <-. split; [reflexivity|]. intros a Ha. cbn in Ha. lia.
    - destruct (not_apart m X q w n) as [k|] eqn:N; [|discriminate].
      destruct (each_axis m X q w rows) as [l|]; [|discriminate]. injection H as <-.
      destruct (IH l eq_refl) as [Ll H]. split; [cbn; now rewrite Ll|].
      intros [|a] Ha; [exact N|]. apply H. cbn in Ha. lia. }
  destruct (G _ _ Ea) as [Ll H]. destruct lattice_parts as (_ & Ld & _). rewrite Ld in *.
  apply in_choices; [congruence|]. rewrite Ll. intros a Ha.
  apply (not_apart_in a _ o Ha L); [now apply H|assumption].
Qed.
End Everywhere.

(** ** Finitely many moves are near *)

Lemma bounded (L : list R) : exists z : Z, forall x, In x L -> - IZR z < x < IZR z.
Proof.
  clear. induction L as [|x L (z & H)]; [exists 0%Z; intros x []|].
  exists (Z.max z (up (Rabs x))). intros y [<-|I].
  - pose proof (archimed (Rabs x)) as [A _]. pose proof (IZR_le _ _ (Z.le_max_r z (up (Rabs x)))).
    unfold Rabs in *. destruct (Rcase_abs x); lra.
  - specialize (H y I). pose proof (IZR_le _ _ (Z.le_max_l z (up (Rabs x)))). lra.
Qed.
Lemma dual_affine a z : affine (fun p => inner (dual a) p + z).
Proof. exists (dual a), z. reflexivity. Qed.
Lemma dual_affine_opp a z : affine (fun p => - inner (dual a) p + z).
Proof. exists (scale (-1) (dual a)), z. intros p. unfold plane. rewrite inner_scale. ring. Qed.
(** By the coordinates in the lattice. *)
Lemma near_moved (T : list (simplex d)) (X : list (point d)) :
  exists (K : list (point d -> R)) (L : list (list Z)),
  (forall f, In f K -> affine f /\ forall x, In x X -> 0 < f x) /\
  forall t o p, In t T -> length o = d -> (forall f, In f K -> 0 < f p) ->
    conv (moved (shift o) t) p -> In o L.
Proof.
  destruct (bounded (flat_map (fun x => map (fun a => inner (dual a) x) (seq 0 d)) X)) as (z & Z).
  destruct (bounded (flat_map (fun v => map (fun a => inner (dual a) v) (seq 0 d)) (concat T)))
    as (e & E).
  set (n := (z + e)%Z).
  set (range := map (fun i => (Z.of_nat i - n)%Z) (seq 0 (Z.to_nat (2 * n + 1)))).
  exists (flat_map (fun a => [fun p => - inner (dual a) p + IZR z;
    fun p => inner (dual a) p + IZR z]) (seq 0 d)), (choices (repeat range d)). split.
  - intros f I. apply in_flat_map in I. destruct I as (a & Ia & I).
    split; [destruct I as [<-|[<-|[]]]; [apply dual_affine_opp|apply dual_affine]|].
    intros x Ix. assert (Bx : - IZR z < inner (dual a) x < IZR z).
    { apply Z, in_flat_map. exists x. split; [assumption|].
      now apply (in_map (fun a => inner (dual a) x)). }
    destruct I as [<-|[<-|[]]]; lra.
  - intros t o p It Lo Hp C.
    apply in_choices; [now rewrite repeat_length|]. rewrite repeat_length. intros a Ha.
    rewrite nth_indep with (d' := range) by now rewrite repeat_length. rewrite nth_repeat.
    assert (Ia : In a (seq 0 d)) by (apply in_seq; lia).
    assert (Bp : - IZR z < inner (dual a) p < IZR z).
    { pose proof (Hp (fun p => - inner (dual a) p + IZR z)) as H1.
      pose proof (Hp (fun p => inner (dual a) p + IZR z)) as H2.
      specialize (H1 ltac:(apply in_flat_map; exists a; split; [assumption|now left])).
      specialize (H2 ltac:(apply in_flat_map; exists a; split; [assumption|right; now left])).
      lra. }
    set (oa := nth a o 0%Z).
    assert (V : forall v, In v (moved (shift o) t) ->
      IZR oa - IZR e < inner (dual a) v < IZR oa + IZR e).
    { intros v Iv. apply in_map_iff in Iv. destruct Iv as (v' & <- & Iv).
      rewrite inner_plus_r, dual_shift by assumption. fold oa.
      assert (- IZR e < inner (dual a) v' < IZR e); [|lra].
      apply E, in_flat_map. exists v'. split; [apply in_concat; eauto|].
      now apply (in_map (fun a => inner (dual a) v')). }
    pose proof (positive_conv _ (moved (shift o) t) p (dual_affine a (- (IZR oa - IZR e)))) as P1.
    pose proof (positive_conv _ (moved (shift o) t) p (dual_affine_opp a (IZR oa + IZR e))) as P2.
    specialize (P1 ltac:(intros v Iv; specialize (V v Iv); lra) C).
    specialize (P2 ltac:(intros v Iv; specialize (V v Iv); lra) C).
    assert (U : (oa < n)%Z) by (apply lt_IZR; unfold n; rewrite plus_IZR; lra).
    assert (W : (- n < oa)%Z) by (apply lt_IZR; unfold n; rewrite opp_IZR, plus_IZR; lra).
    unfold range. apply in_map_iff. exists (Z.to_nat (oa + n)). split; [|apply in_seq]; lia.
Qed.
End Lattice.
