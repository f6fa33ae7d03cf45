(** * Simplices that dangle and have no empty circumball

    |p|^2 - 2 <c, p> + |c|^2 - r2, the power of p, is zero at the vertices of a simplex with the
    circumball (c, r2).  So if weights that are not negative off the simplex make the points and the
    weights sum up to nothing, and the squares to less, then the power is negative at one of the
    others.  (By the duality of linear programs there are such weights whenever no circumball is
    empty.) *)
From Coq Require Import Rbase Rfunctions Lra Lia List Arith ZArith Bool.
From Circumspect Require Import DomainRefutation Numbering.
From Circumspect Require Import Definitions Domains DomainRules Vectors Affine Frame Faces
  LiftingMap Breach.
From Circumspect Require Import Orientation Integers RefutationSigns CallerMesh EvidenceSound
  RefutationSound Dangling.
Import ListNotations.
Open Scope R_scope.

(** ** Sums *)

Definition real_sum (f : site -> R) (l : list (Z * site)) : R :=
  fold_right (fun zp s => IZR (fst zp) * f (snd zp) + s) 0 l.
Lemma real_sum_cons f z p l : real_sum f ((z, p) :: l) = IZR z * f p + real_sum f l.
Proof. reflexivity. Qed.
Lemma sum_of_real f l : IZR (sum_of f l) = real_sum (fun p => IZR (f p)) l.
Proof.
  induction l as [|(z, p) l IH]; [reflexivity|].
  rewrite real_sum_cons, <- IH, <- mult_IZR, <- plus_IZR. reflexivity.
Qed.
Lemma real_sum_app f l l' : real_sum f (l ++ l') = real_sum f l + real_sum f l'.
Proof.
  induction l as [|(z, p) l IH]; [change (real_sum f []) with 0; cbn [app]; ring|].
  cbn [app]. rewrite !real_sum_cons, IH. ring.
Qed.
Lemma real_sum_linear a b k f g l :
  real_sum (fun p => a * f p + b * g p + k) l = a * real_sum f l + b * real_sum g l + k * real_sum
    (fun _ => 1) l.
Proof. induction l as [|(z, p) l IH]; [cbn; ring|]. rewrite !real_sum_cons, IH. ring. Qed.
Lemma real_sum_ext f g l : (forall z p, In (z, p) l -> f p = g p) -> real_sum f l = real_sum g l.
Proof.
  induction l as [|(z, p) l IH]; intros E; [reflexivity|]. rewrite !real_sum_cons.
  rewrite (E z p) by now left. f_equal. apply IH. intros z' q I. apply (E z'). now right.
Qed.
Lemma inner_sum d : forall (c : point d) (f : site -> list Z) l,
  (forall j, (j < d)%nat -> real_sum (fun p => IZR (nth j (f p) 0%Z)) l = 0) ->
  real_sum (fun p => inner c (integer_point d (f p))) l = 0.
Proof.
  induction d as [|d IH]; intros c f l H.
  - clear. induction l as [|(z, p) l IH]; [reflexivity|]. rewrite real_sum_cons, IH.
    pattern c. apply Vector.case0. cbn. ring.
  - revert H. apply (Vector.caseS' c). intros x c' H. pose proof (H 0%nat ltac:(lia)) as H0.
    specialize (IH c' (fun p => tl (f p)) l). rewrite <- (Rplus_0_r 0), <- IH at 1.
    + rewrite <- (Rmult_0_r x), <- H0.
      transitivity
        (real_sum (fun p => x * IZR (nth 0 (f p) 0%Z) + 1 * inner c' (integer_point d (tl (f p))) +
        0) l).
      * apply real_sum_ext. intros z p _. cbn [integer_point].
        change (x * IZR (hd 0%Z (f p)) + inner c' (integer_point d (tl (f p))) =
          x * IZR (nth 0 (f p) 0%Z) + 1 * inner c' (integer_point d (tl (f p))) + 0).
        assert (E : hd 0%Z (f p) = nth 0 (f p) 0%Z) by now destruct (f p). rewrite E. ring.
      * rewrite real_sum_linear. ring.
    + intros j Hj. rewrite <- (H (Datatypes.S j)) by lia. apply real_sum_ext. intros z p _.
      destruct (f p); cbn [tl nth]; [now destruct j|reflexivity].
Qed.
Lemma negative_part (f : site -> R) l : (forall z p, In (z, p) l -> (0 <= z)%Z) ->
  real_sum f l < 0 ->
  exists z p, In (z, p) l /\ f p < 0.
Proof.
  induction l as [|(z, p) l IH]; intros Nn N; [cbn in N; lra|]. rewrite real_sum_cons in N.
  destruct (Rlt_dec (f p) 0) as [F|F]; [exists z, p; split; [now left|assumption]|].
  destruct IH as (z' & q & I & F'); [intros z' q I; apply (Nn z' q); now right| |exists z', q;
    split; [now right|assumption]].
  pose proof (IZR_le _ _ (Nn z p (or_introl eq_refl))) as Nz.
  assert (0 <= IZR z * f p) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma inner_of_integers d : forall n p, length n = d -> length p = d ->
  inner (integer_point d n) (integer_point d p) = IZR (inner_product n p).
Proof.
  induction d as [|d IH]; intros [|x n] [|y p] Ln Lp; try discriminate; [reflexivity|].
  injection Ln as Ln. injection Lp as Lp. cbn [inner_product integer_point hd tl].
  rewrite plus_IZR, mult_IZR, <- (IH n p Ln Lp). reflexivity.
Qed.

(** ** One of the others is inside *)

Section Ball.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates} {r : R}.
Hypothesis M : measured orient pr r.
Hypothesis unit_positive : 0 < r.

Lemma power_of p (c : point d) r2 : well_shaped d p -> dist2 c (place_of r p) - r2 =
  r * r * IZR (inner_product (coordinates p) (coordinates p)) +
  -2 * r * inner c (integer_point d (coordinates p)) + (norm2 c - r2).
Proof.
  intros Sp. rewrite <- (inner_of_integers d _ _ Sp Sp). unfold dist2, norm2, minus, place_of.
  repeat rewrite ?inner_plus, ?inner_plus_r, ?inner_scale, ?inner_scale_r.
  rewrite (inner_comm (integer_point d _) c). ring.
Qed.
Lemma no_ball_inside own others c r2 : no_ball pr own others = true ->
  Forall (well_shaped d) (map snd (own ++ others)) ->
    circumball (map (place_of r) (map snd own)) c r2 ->
  exists z p, In (z, p) others /\ dist2 c (@place_of d r p) < r2.
Proof.
  intros H Sh Ci. unfold no_ball in H. rewrite !andb_true_iff in H. destruct H as [[[Nn To] Co] Sq].
  rewrite forallb_forall in Nn, Co. apply Z.eqb_eq in To. apply Z.ltb_lt in Sq.
  rewrite Forall_forall in Sh. set (F := fun p => dist2 c (@place_of d r p) - r2).
  assert (All : real_sum F (own ++ others) < 0).
  { rewrite (real_sum_ext F (fun p => r * r * IZR (inner_product (coordinates p) (coordinates p)) +
      -2 * r * inner c (integer_point d (coordinates p)) + (norm2 c - r2))).
    2:{ intros z p I. apply power_of, Sh. now apply (in_map snd _ (z, p)). }
    rewrite (real_sum_linear (r * r) (-2 * r) _ (fun p =>
      IZR (inner_product (coordinates p) (coordinates p)))).
    rewrite inner_sum.
    2:{ intros j Hj. specialize (Co j). rewrite (dimension_d M) in Co. rewrite Z.eqb_eq in Co.
        rewrite <- (sum_of_real (fun p => nth j (coordinates p) 0%Z)), Co; [reflexivity|].
        apply in_seq. lia. }
    rewrite <- (sum_of_real (fun _ => 1%Z)), To,
      <- (sum_of_real (fun p => inner_product (coordinates p) (coordinates p))).
    apply IZR_lt in Sq. assert (0 < r * r) by (now apply Rmult_lt_0_compat).
    assert (r * r * IZR (sum_of (fun p => inner_product (coordinates p) (coordinates p))
      (own ++ others)) < r * r * 0)
      by (now apply Rmult_lt_compat_l). lra. }
  rewrite real_sum_app in All. assert (Z0 : real_sum F own = 0).
  { rewrite (real_sum_ext F (fun _ => 0 * 1 + 0 * 1 + 0)).
    - rewrite (real_sum_linear 0 0 0 (fun _ => 1) (fun _ => 1)). ring.
    - intros z p I. unfold F. rewrite (Ci (place_of r p)); [ring|].
      now apply in_map, (in_map snd _ (z, p)). }
  destruct (negative_part F others) as (z & p & I & Fp); [|lra|].
  - intros z p I. specialize (Nn (z, p) I). now apply Z.leb_le.
  - exists z, p. split; [assumption|]. unfold F in Fp. lra.
Qed.
End Ball.

(** ** What is accepted *)

Section Accepted.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis M : forall r, 0 < r -> measured orient pr r.
Variables (m : refutation) (x : dangling_part).
Notation r := (refuted_unit m).
Hypothesis unit_positive : 0 < r.
Hypothesis delaunay : refuted m = Delaunay.
Hypothesis shaped_sites : forallb (shaped pr) (sites (padded m x)) = true.
Notation L := (@caller_rows d r (sites m) (rows m)).
Notation U := (@caller_rows d r (sites m) (map fst (dangling x))).
Notation PS := (map (site_for Delaunay) (sites (padded m x))).
Variable P : domain d.

Lemma weighted_points_found S others Y :
  (forall k, Table.find k S = numbered (map (site_for Delaunay) (sites m)) k) ->
  weighted_points S others = Some Y -> forall z p, In (z, p) Y -> exists k q, In (k, z) others /\
    numbered (sites m) k = Some q /\ p = site_for Delaunay q.
Proof.
  intros Fs. revert Y. induction others as [|(k, z') others IH]; intros Y E z p I;
    cbn [weighted_points] in E.
  - injection E as <-. destruct I.
  - rewrite Fs in E. destruct (numbered (map _ _) k) as [q|] eqn:Eq; [|discriminate].
    destruct (weighted_points S others) as [Y'|]; [|discriminate]. injection E as <-.
    destruct I as [I|I].
    + injection I as <- <-. unfold numbered in Eq. rewrite nth_error_map in Eq.
      fold (numbered (sites m) k) in Eq.
      destruct (numbered (sites m) k) as [q'|] eqn:Eq'; [|discriminate]. injection Eq as <-.
      exists k, q'. split; [now left|now split].
    + destruct (IH Y' eq_refl z p I) as (k' & q' & I' & H). exists k', q'.
      split; [now right|assumption].
Qed.

(** The simplex is none of the mesh, nor a face of one. *)
Lemma in_no_row_alone X n : incl X PS ->
  in_no_row m (Table.of_list (site_for Delaunay) (sites (padded m x))) (firstn n X) = true ->
  forall t, listed L t -> ~ incl (map (place_of r) (firstn n X)) t.
Proof.
  intros IX N t Lt It. apply in_map_iff in Lt. destruct Lt as (y & E & Iy). unfold in_no_row in N.
  rewrite forallb_forall in N.
  specialize (N y Iy). apply negb_true_iff in N. apply (entries_padded m x y t) in E.
  rewrite <- padded_sites in E.
  rewrite <- (map_ext _ _ (entry_site_for m (sites (padded m x)))) in E.
  assert (T : forallb (fun p => lists (Table.of_list (site_for Delaunay) (sites (padded m x))) p y)
    (firstn n X) = true); [|congruence].
  apply forallb_forall. intros p Ip.
  apply (all_named_listed (M r unit_positive) PS (rows m) _ (Table.of_list id (rows m))
    (padded_shaped M m x unit_positive delaunay shaped_sites)
    (padded_found m x) (rows_found m) y t E); [now apply IX, (incl_firstn n)|]. apply It.
    now apply in_map.
Qed.
Lemma own_independent X g n : RefutationSigns.framed orient pr r X g ->
  affinely_independent (map (@place_of d r) (firstn n X)).
Proof.
  intros G. pose proof (vertices_independent g) as Iv. rewrite (framed_vertices X g G) in Iv.
  apply (face_independent g).
  - rewrite (framed_vertices X g G). apply incl_map. intros p. apply incl_firstn.
  - pose proof (independent_NoDup _ Iv) as Nd. rewrite <- (firstn_skipn n X), map_app in Nd.
    clear - Nd.
    induction (map (place_of r) (firstn n X)) as [|a l IH]; [constructor|]. cbn [app] in Nd.
    inversion Nd as [|? ? Na Nl]. subst.
    constructor; [|now apply IH]. intros I. apply Na, in_or_app. now left.
Qed.

Theorem no_empty_ball_found u own others : ball_shown pr m x u own others = true ->
  (forall k z, In (k, z) others -> exists y, numbered (sites m) k = Some y /\
    (In (place_of r y) (entries (L ++ U)) \/ In (place_of r y) (domain_vertices P))) ->
  no_empty_ball P L U.
Proof.
  intros H Listed. unfold ball_shown in H. destruct (weighted_points _ others) as [Y|] eqn:Ey;
    [|discriminate].
  apply (own_found_known M m x unit_positive delaunay shaped_sites) in H.
  destruct H as (X & g & n & G & LX & H & IX).
  apply andb_prop in H. destruct H as [B N]. pose proof (framed_shaped X g G) as SX.
  rewrite Forall_forall in SX.
  pose proof (padded_shaped M m x unit_positive delaunay shaped_sites) as ShP.
  pose proof (M r unit_positive) as Mr.
  assert (In_ : forall p, In p (firstn n X) -> In p X) by (intros p; apply incl_firstn).
  pose proof (in_no_row_alone X n IX N) as Alone.
  exists (map (place_of r) (firstn n X)). split; [|split; [|split; [assumption|]]].
  - unfold listed in *. apply in_app_or in LX. destruct LX as [LX|LX]; [|assumption].
    destruct (Alone _ LX). apply incl_refl.
  - now apply (own_independent X g n).
  - intros c r2 Ci. destruct (no_ball_inside Mr unit_positive (combine own (firstn n X)) Y c r2 B)
      as (z & p & Ip & Dp).
    + rewrite map_app. apply Forall_app.
      split; apply Forall_forall; intros p Ip; apply in_map_iff in Ip;
        destruct Ip as ((z, q) & <- & Iq).
      * apply in_combine_r in Iq. now apply SX, In_.
      * destruct (weighted_points_found _ others Y (fun k => eq_trans (table_find _ _ _)
          (eq_sym (nth_error_map _ _ _))) Ey z q Iq)
          as (k & y & _ & Ek & ->). rewrite Forall_forall in ShP.
          apply ShP, (in_map (site_for Delaunay)). rewrite padded_sites. apply in_or_app. left.
        now apply numbered_in in Ek.
    + intros v Iv. apply in_map_iff in Iv. destruct Iv as (p & <- & Ip). apply in_map_iff in Ip.
      destruct Ip as ((z, q) & <- & Iq).
      apply in_combine_r in Iq. apply Ci. now apply in_map.
    + destruct (weighted_points_found _ others Y (fun k => eq_trans (table_find _ _ _)
        (eq_sym (nth_error_map _ _ _))) Ey z p Ip)
        as (k & y & Ik & Ek & ->). destruct (Listed k z Ik) as (y' & Ey' & Iy). rewrite Ek in Ey'.
        injection Ey' as <-.
      exists (place_of r y). split; [assumption|]. unfold place_of in *. exact Dp.
Qed.
End Accepted.
