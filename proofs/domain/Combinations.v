(** * Combinations: hulls of hulls, images of hulls, and points of a segment in integers *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Bool.
From Coq Require Vector.
From Circumspect Require Import DomainChecker Integers.
From Circumspect Require Import Definitions Domains Vectors Affine Faces.
Import ListNotations.
Open Scope R_scope.

Section Hulls.
Context {d : nat}.
Implicit Types (X Y : list (point d)) (p q : point d).

Lemma total_app (l m : list (R * point d)) : total (l ++ m) = total l + total m.
Proof. induction l as [|[a p] l IH]; cbn [app]; [cbn; ring|]. rewrite !total_cons, IH. ring. Qed.
Lemma combination_app (l m : list (R * point d)) :
  combination (l ++ m) = plus (combination l) (combination m).
Proof.
  induction l as [|[a p] l IH]; cbn [app]; [symmetry; apply origin_plus|].
  now rewrite !combination_cons, IH, plus_assoc.
Qed.
Lemma total_scaled c (l : list (R * point d)) :
  total (map (fun ap => (c * fst ap, snd ap)) l) = c * total l.
Proof.
  induction l as [|[a p] l IH]; cbn [map fst snd]; [cbn; ring|]. rewrite !total_cons, IH. ring.
Qed.
Lemma combination_scaled c (l : list (R * point d)) :
  combination (map (fun ap => (c * fst ap, snd ap)) l) = scale c (combination l).
Proof.
  induction l as [|[a p] l IH]; cbn [map fst snd]; [symmetry; apply scale_origin|].
  now rewrite !combination_cons, IH, scale_plus, scale_scale.
Qed.

(** The hull of points of a hull is part of it. *)
Lemma conv_conv X Y q : (forall p, In p X -> conv Y p) -> conv X q -> conv Y q.
Proof.
  intros H (l & L & T & <-).
  assert (G : forall l, (forall a p, In (a, p) l -> 0 <= a /\ In p X) ->
    exists m, (forall a p, In (a, p) m -> 0 <= a /\ In p Y) /\ total m = total l /\
      combination m = combination l).
  { clear l L T. induction l as [|[a p] l IH]; intros L; [exists []; repeat split; contradiction|].
    destruct IH as (m & M & Tm & Cm); [intros; apply L; now right|].
    destruct (L a p (or_introl eq_refl)) as [Pa Ip]. destruct (H p Ip) as (k & K & Tk & Ck).
    exists (map (fun bp => (a * fst bp, snd bp)) k ++ m). split; [|split].
    - intros b v I. apply in_app_or in I. destruct I as [I|I]; [|now apply M].
      apply in_map_iff in I. destruct I as ((b', v') & E & I). injection E as <- <-.
      destruct (K b' v' I). split; [now apply Rmult_le_pos|assumption].
    - rewrite total_app, total_scaled, total_cons, Tk, Tm. ring.
    - rewrite combination_app, combination_scaled, combination_cons, Ck, Cm. reflexivity. }
  destruct (G l L) as (m & M & Tm & Cm). exists m. split; [assumption|].
  split; [congruence|assumption].
Qed.
(** A positive multiple of the point is combined. *)
Lemma conv_of_multiple (l : list (R * point d)) q : (forall a p, In (a, p) l -> 0 <= a) ->
  0 < total l ->
  scale (total l) q = combination l -> forall X, (forall a p, In (a, p) l -> In p X) -> conv X q.
Proof.
  intros P T E X I. exists (map (fun ap => (/ total l * fst ap, snd ap)) l). split; [|split].
  - intros a p H. apply in_map_iff in H. destruct H as ((a', p') & E' & H). injection E' as <- <-.
    split; [|now apply (I a')]. apply Rmult_le_pos; [|now apply (P a' p')].
    left. now apply Rinv_0_lt_compat.
  - rewrite total_scaled. field. lra.
  - rewrite combination_scaled, <- E, scale_scale, Rinv_l, scale_one by lra. reflexivity.
Qed.

(** ** Segments *)

Lemma conv_two (a b : point d) q : conv [a; b] q <-> exists s, 0 <= s <= 1 /\ q = between a b s.
Proof.
  split.
  - intros (l & L & T & <-).
    assert (G : forall l, (forall c p, In (c, p) l -> 0 <= c /\ In p [a; b]) ->
      exists u v, 0 <= u /\ 0 <= v /\ total l = u + v /\
        combination l = plus (scale u a) (scale v b)).
    { clear l L T. induction l as [|[c p] l IH]; intros L.
      { exists 0, 0. repeat split; try (cbn; lra). now rewrite !scale_zero, plus_origin. }
      destruct IH as (u & v & U & V & T & C); [intros; apply L; now right|].
      destruct (L c p (or_introl eq_refl)) as [Pc I]. rewrite total_cons, combination_cons, T, C.
      destruct I as [<-|[<-|[]]].
      - exists (c + u), v. repeat split; try lra. now rewrite plus_scale, plus_assoc.
      - exists u, (c + v). repeat split; try lra.
        rewrite plus_scale, plus_assoc, plus_assoc. f_equal. apply plus_comm. }
    destruct (G l L) as (u & v & U & V & T' & C). exists v. split; [lra|].
    rewrite C. unfold between. f_equal. f_equal. lra.
  - intros (s & S & ->). exists [(1 - s, a); (s, b)]. split; [|split].
    + intros c p [E|[E|[]]]; injection E as <- <-; (split; [lra|cbn; auto]).
    + cbn. ring.
    + rewrite !combination_cons. cbn. now rewrite plus_origin.
Qed.
Lemma between_between (a b : point d) s r t :
  between (between a b s) (between a b r) t = between a b ((1 - t) * s + t * r).
Proof.
  apply affine_separate. intros f F. change (between (d := d)) with (mix (d := d)).
  rewrite !affine_mix by assumption. ring.
Qed.
Lemma between_start (a b : point d) : between a b 0 = a.
Proof.
  apply affine_separate. intros f F. change (between (d := d)) with (mix (d := d)).
  rewrite affine_mix by assumption. ring.
Qed.
Lemma between_end (a b : point d) : between a b 1 = b.
Proof.
  apply affine_separate. intros f F. change (between (d := d)) with (mix (d := d)).
  rewrite affine_mix by assumption. ring.
Qed.
Lemma conv_part (a b : point d) s r t : s <= t <= r ->
  conv [between a b s; between a b r] (between a b t).
Proof.
  intros H. apply conv_two. destruct (Req_dec s r) as [E|N].
  - exists 0. split; [lra|]. rewrite between_start. f_equal. lra.
  - exists ((t - s) / (r - s)). split.
    + split.
      * apply Rmult_le_pos; [lra|]. left. apply Rinv_0_lt_compat. lra.
      * apply Rmult_le_reg_r with (r - s); [lra|]. unfold Rdiv.
        rewrite Rmult_assoc, Rinv_l by lra. lra.
    + rewrite between_between. f_equal. field. lra.
Qed.

Lemma conv_singleton (a : point d) q : conv [a] q <-> q = a.
Proof.
  split; [|intros ->; apply conv_point; now left].
  intros C.
  assert (C' : conv [a; a] q) by (apply (conv_incl [a]); [intros x [<-|[]]; now left|assumption]).
  apply conv_two in C'. destruct C' as (s & _ & ->). unfold between.
  rewrite <- plus_scale. replace (1 - s + s) with 1 by ring. apply scale_one.
Qed.
End Hulls.

(** ** Maps that keep the ratios on segments keep hulls *)

Section Maps.
Context {m n : nat} (f : point m -> point n).
Hypothesis keeps : forall x y s, f (between x y s) = between (f x) (f y) s.

Lemma conv_map X q : conv X q -> conv (map f X) (f q).
Proof.
  intros (l & L & T & <-).
  assert (G : forall l, (forall a p, In (a, p) l -> 0 <= a /\ In p X) -> 0 < total l ->
    conv (map f X) (f (scale (/ total l) (combination l)))).
  { clear l L T. induction l as [|[a p] l IH]; intros L P; [cbn in P; lra|].
    destruct (L a p (or_introl eq_refl)) as [Pa Ip].
    assert (L' : forall b q, In (b, q) l -> 0 <= b /\ In q X) by (intros; apply L; now right).
    assert (T0 : 0 <= total l).
    { clear - L'. induction l as [|[b q] l IH]; [cbn; lra|]. rewrite total_cons.
      destruct (L' b q (or_introl eq_refl)). assert (0 <= total l); [|lra].
      apply IH. intros; apply L'; now right. }
    rewrite total_cons, combination_cons in *.
    destruct (Rle_lt_or_eq_dec _ _ T0) as [Pl|Z].
    - (* between p and the rest *)
      specialize (IH L' Pl). set (q := scale (/ total l) (combination l)) in *.
      replace (scale (/ (a + total l)) (plus (scale a p) (combination l)))
        with (between q p (a / (a + total l))).
      + rewrite keeps. apply (conv_conv [f q; f p]).
        * intros v [<-|[<-|[]]]; [assumption|]. apply conv_point. now apply in_map.
        * apply conv_two. exists (a / (a + total l)). split; [|reflexivity]. split.
          -- apply Rmult_le_pos; [assumption|]. left. apply Rinv_0_lt_compat. lra.
          -- apply Rmult_le_reg_r with (a + total l); [lra|]. unfold Rdiv.
             rewrite Rmult_assoc, Rinv_l by lra. lra.
      + unfold between, q. rewrite scale_plus, !scale_scale.
        rewrite plus_comm. f_equal; f_equal; field; lra.
    - (* the rest has no weight *)
      assert (C : combination l = origin).
      { clear - L' Z. induction l as [|[b q] l IH]; [reflexivity|]. rewrite total_cons in Z.
        destruct (L' b q (or_introl eq_refl)) as [Pb _].
        assert (T0 : 0 <= total l).
        { clear - L'. assert (K : forall b q, In (b, q) l -> 0 <= b) by
            (intros; now apply (L' b0 q0); right). clear L'.
          induction l as [|[c x] l IH]; [cbn; lra|]. rewrite total_cons.
          pose proof (K c x (or_introl eq_refl)). assert (0 <= total l); [|lra].
          apply IH. intros y z I. apply (K y z). now right. }
        rewrite combination_cons, IH; [|intros; apply L'; now right|lra].
        replace b with 0 by lra. now rewrite scale_zero, plus_origin. }
      rewrite C, <- Z, plus_origin, scale_scale.
      replace (/ (a + 0) * a) with 1 by (field; lra). rewrite scale_one.
      apply conv_point. now apply in_map. }
  specialize (G l L). rewrite T in G. rewrite Rinv_1, scale_one in G. apply G. lra.
Qed.
End Maps.

(** ** In integers *)

Lemma same_integers_spec k l : same_integers k l = true -> k = l.
Proof.
  revert l. induction k as [|x k IH]; intros [|y l] H; try discriminate; [reflexivity|].
  cbn in H. apply andb_prop in H. destruct H as [E H]. apply Z.eqb_eq in E. f_equal; auto.
Qed.

Lemma integer_between d : forall A B P l n, length A = d -> length B = d -> length P = d ->
  map (Z.mul l) (differences P A) = map (Z.mul n) (differences B A) -> (0 < l)%Z ->
  integer_point d P = between (integer_point d A) (integer_point d B) (IZR n / IZR l).
Proof.
  induction d as [|d IH]; intros [|a A] [|b B] [|p P] l n LA LB LP E L; try discriminate.
  - reflexivity.
  - cbn [differences map] in E. injection E as E1 E2. injection LA as LA. injection LB as LB.
    injection LP as LP. pose proof (IZR_lt _ _ L) as L'.
    change (Vector.cons R (IZR p) d (integer_point d P) =
      Vector.cons R ((1 - IZR n / IZR l) * IZR a + IZR n / IZR l * IZR b) d
        (between (integer_point d A) (integer_point d B) (IZR n / IZR l))).
    f_equal.
    + apply (f_equal IZR) in E1. rewrite !mult_IZR, !minus_IZR in E1.
      apply Rmult_eq_reg_l with (IZR l); [|lra].
      replace (IZR l * ((1 - IZR n / IZR l) * IZR a + IZR n / IZR l * IZR b))
        with (IZR l * IZR a + IZR n * (IZR b - IZR a)) by (field; lra). lra.
    + exact (IH A B P l n LA LB LP E2 L).
Qed.

(** Where the point is on the segment. *)
Definition ratio (a b p : site) : R :=
  IZR (inner_product (differences (coordinates b) (coordinates a))
         (differences (coordinates p) (coordinates a))) /
  IZR (inner_product (differences (coordinates b) (coordinates a))
         (differences (coordinates b) (coordinates a))).

Lemma on_segment_between d (r : R) a b p : well_shaped d a -> well_shaped d b -> well_shaped d p ->
  on_segment a b p = true ->
  0 <= ratio a b p <= 1 /\ @place_of d r p = between (place_of r a) (place_of r b) (ratio a b p).
Proof.
  intros A B P H. unfold on_segment in H. cbv zeta in H.
  repeat (apply andb_prop in H; let K := fresh in destruct H as [H K]).
  apply same_integers_spec in H0. apply Z.leb_le in H1, H2. apply Z.ltb_lt in H.
  unfold ratio. set (n := inner_product _ (differences (coordinates p) _)) in *.
  set (l := inner_product _ (differences (coordinates b) _)) in *.
  apply IZR_lt in H as L. apply IZR_le in H1, H2. split.
  - split.
    + apply Rmult_le_pos; [assumption|]. left. now apply Rinv_0_lt_compat.
    + apply Rmult_le_reg_r with (IZR l); [assumption|]. unfold Rdiv.
      rewrite Rmult_assoc, Rinv_l by lra. lra.
  - unfold place_of. rewrite (integer_between d _ _ _ l n A B P H0 H).
    unfold between. rewrite scale_plus, !scale_scale. f_equal; f_equal; ring.
Qed.
Lemma ratio_end a b : on_segment a b b = true -> ratio a b b = 1.
Proof.
  unfold on_segment. cbv zeta. intros H.
  repeat (apply andb_prop in H; let K := fresh in destruct H as [H K]).
  apply Z.ltb_lt, IZR_lt in H. unfold ratio. field. lra.
Qed.
Lemma ratio_start a b : ratio a b a = 0.
Proof.
  unfold ratio. replace (inner_product _ (differences (coordinates a) (coordinates a))) with 0%Z.
  - unfold Rdiv. ring.
  - generalize (differences (coordinates b) (coordinates a)).
    induction (coordinates a) as [|x k IH]; intros [|y l]; cbn; try reflexivity. rewrite <- IH.
    ring.
Qed.
