(** * Soundness: an accepted certificate of a mesh alone is about a complex *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Bool.
From Circumspect Require Import MeshAlone Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Orientation Integers
  Incidence Accepted.
From Circumspect Require Import Soundness Separated BoxesSound.
From Circumspect Require Balls.
Import ListNotations.
Open Scope R_scope.

(** ** Hyperplanes *)

Section Values.
Context {d : nat} (r : R).
Hypothesis unit_positive : 0 < r.

(** The affine function of a hyperplane. *)
Definition height_over (h : hyperplane) (p : point d) : R :=
  inner (integer_point d (fst h)) p - r * IZR (snd h).
Lemma height_over_affine h : affine (height_over h).
Proof.
  exists (integer_point d (fst h)), (- (r * IZR (snd h))). intros p. unfold height_over, plane.
  ring.
Qed.
Lemma height_over_at h (s : site) : length (fst h) = d -> well_shaped d s ->
  height_over h (place_of r s) = r * IZR (value h (coordinates s)).
Proof.
  intros L W. unfold height_over, place_of, value.
  rewrite inner_scale_r, (Balls.inner_of_integers _ _ _ L W), minus_IZR. ring.
Qed.

(** One coordinate. *)
Definition axis (i : nat) : list Z := map (fun k => if Nat.eqb k i then 1%Z else 0%Z) (seq 0 d).
Lemma axis_value i p : length p = d -> (i < d)%nat -> inner_product (axis i) p = nth i p 0%Z.
Proof.
  unfold axis. assert (G : forall n p m, length p = n -> (m <= i < m + n)%nat ->
    inner_product (map (fun k => if Nat.eqb k i then 1%Z else 0%Z) (seq m n)) p = nth
      (i - m) p 0%Z).
  { clear. induction n as [|n IH]; intros [|x p] m L H; try discriminate; try lia.
    assert (Zero : forall n p m, (i < m)%nat ->
      inner_product (map (fun k => if Nat.eqb k i then 1%Z else 0%Z) (seq m n)) p = 0%Z).
    { clear. induction n as [|n IH]; intros [|x p] m H; try reflexivity.
      cbn [seq map inner_product].
      rewrite IH by lia. destruct (Nat.eqb_spec m i); lia. }
    cbn [seq map inner_product]. destruct (Nat.eqb_spec m i) as [->|N].
    - rewrite Zero by lia. rewrite Nat.sub_diag. cbn [nth]. lia.
    - rewrite (IH p (S m)) by (cbn in L; lia). replace (i - m)%nat with (S (i - S m)) by lia.
      cbn [nth]. lia. }
  intros L H. rewrite (G d p 0%nat L) by lia. now rewrite Nat.sub_0_r.
Qed.
Lemma axis_length i : length (axis i) = d.
Proof. unfold axis. now rewrite map_length, seq_length. Qed.
End Values.

Lemma NoDup_front {A} (l m : list A) : NoDup (l ++ m) -> NoDup l.
Proof.
  induction l as [|a l IH]; cbn; intros N; constructor; inversion_clear N; auto. intros I.
  apply H, in_or_app. now left.
Qed.

(** ** The theorem, for either dimension *)

Section Sound.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis Or : oriented orient.
Hypothesis Co : computes orient pr.
Variables (unused_allowed : bool) (c : complex_certificate).
Hypothesis accepts : check_alone_in pr unused_allowed c = Accepted.
Let dim_d : dimension pr = d := computes_dimension _ _ Co.
Notation bare := (bare_certificate c).
Notation r := (unit_of bare).
Notation spot := (spot d bare).
Notation P := (points_of_certificate d bare).
Notation T := (simplices_of_certificate d bare).
Notation points_table := (Table.of_list position (complex_points c)).

Lemma parts_accepted : 0 < r /\ check_points pr (complex_points c) = Accepted /\
  each (vertex_used unused_allowed c) 1 (complex_points c) = Accepted /\ complex_cells c <> [] /\
  each (check_cell pr c) 1 (complex_cells c) = Accepted /\
  exists l t, leaves_of pr c [] (complex_order c) = Some l /\ grown 62 l = Some t /\
    all_parted (dimension pr) t = Accepted.
Proof.
  pose proof accepts as H. unfold check_alone_in in H. cbv zeta in H. accepted. booleans.
  apply Z.ltb_lt in H0, H1. apply IZR_lt in H0, H1. split.
  { unfold unit_of. cbn. now apply Rdiv_lt_0_compat. }
  repeat (split; [reflexivity || assumption|]). split; [intros N; rewrite N in *; discriminate|].
  split; [reflexivity || assumption|]. exists l, t. auto.
Qed.
Notation unit_positive := (proj1 parts_accepted).

(** ** Points *)

Lemma shaped_distinct : Forall (fun e => well_shaped d (position e)) (complex_points c) /\
  NoDup (map (fun e => coordinates (position e)) (complex_points c)).
Proof. destruct parts_accepted as (_ & H & _). now apply (checked_points dim_d). Qed.
Lemma alone_points_once : NoDup P.
Proof.
  destruct shaped_distinct as [F N]. pose proof unit_positive as U. unfold points_of_certificate.
  cbn.
  change (unit_of _) with r. revert F N. generalize (complex_points c). clear - U.
  induction l as [|e l IH]; intros F N; cbn in *; constructor; inversion_clear F; inversion_clear N;
    auto.
  intros I. apply in_map_iff in I. destruct I as (e' & E & I). apply H1. apply in_map_iff.
  exists e'. split; [|assumption]. rewrite Forall_forall in H0. apply (@place_inj d r); auto; lra.
Qed.

Lemma find_place k s : Table.find k points_table = Some s ->
  spot k = place_of r s /\ well_shaped d s /\ In (spot k) P.
Proof.
  rewrite table_find. destruct (numbered (complex_points c) k) as [e|] eqn:E; [|discriminate].
  intros H. injection H as <-. split; [now apply spot_numbered|].
  split; [|now apply spot_in with e].
  destruct shaped_distinct as [F _]. rewrite Forall_forall in F. apply F.
  now apply numbered_in with k.
Qed.
Lemma find_places l : forall X, find_all points_table l = Some X ->
  map spot l = map (place_of r) X /\ Forall (well_shaped d) X /\ incl (map spot l) P /\
    length X = length l.
Proof.
  induction l as [|k l IH]; intros X E; cbn [find_all] in E.
  - injection E as <-. repeat split; [constructor|intros p []].
  - destruct (Table.find k points_table) as [s|] eqn:K; [|discriminate].
    destruct (find_all points_table l) as [Y|]; [|discriminate]. injection E as <-.
    destruct (IH Y eq_refl) as (A & B & C & L). destruct (find_place k s K) as (Pk & Sk & Ik).
    cbn [map length]. split; [congruence|]. split; [now constructor|]. split; [|congruence].
    intros p [<-|I]; auto.
Qed.

Lemma alone_points_used p : unused_allowed = false -> In p P -> exists t, In t T /\ In p t.
Proof.
  intros Un I. apply in_points in I. destruct I as (k & e & E & ->). cbn in E.
  destruct parts_accepted as (_ & _ & H & _). pose proof (each_accepted _ _ H k e E) as V.
  unfold vertex_used in V. accepted. destruct (home_vertex e) as [i|]; [|congruence].
  destruct (Table.find (home e) _) as [t|] eqn:F; [|discriminate].
  destruct (nth_error (cell_vertices t) i) as [v|] eqn:N; [|discriminate]. booleans. subst v.
  rewrite table_find in F. destruct (numbered (complex_cells c) (home e)) as [t'|] eqn:M;
    [|discriminate].
  injection F as <-. exists (map spot (cell_vertices t')). split.
  - unfold simplices_of_certificate. cbn. rewrite map_map. cbn. apply in_map_iff. exists t'.
    split; [reflexivity|].
    now apply numbered_in with (home e).
  - rewrite <- (spot_numbered d bare k e E). apply in_map. now apply nth_error_In with i.
Qed.

(** ** Simplices *)

Notation entry t e := (numbered (complex_cells c) t = Some e).
Lemma cell_accepted t e : entry t e -> exists X, find_all points_table (cell_vertices e) = Some X /\
  length X = S (complex_dimension c) /\ affinely_independent (map spot (cell_vertices e)) /\
  In t (complex_order c).
Proof.
  intros E. destruct parts_accepted as (U & _ & _ & _ & H & _).
  pose proof (each_accepted _ _ H t e E) as V.
  unfold check_cell in V. accepted. booleans. exists l. split; [reflexivity|]. split; [assumption|].
  split.
  - destruct (find_places _ _ Heqo) as (Pl & Sh & _ & _).
    apply negb_true_iff, Z.eqb_neq in H1. rewrite forallb_forall in H2.
    assert (Sh' : Forall (well_shaped d) (l ++ cell_pads e)).
    { apply Forall_app. split; [assumption|]. apply Forall_forall. intros s I. specialize (H2 s I).
      unfold shaped in H2. booleans. unfold well_shaped. congruence. }
    destruct (lists_exists Or (map (place_of r) (l ++ cell_pads e))) as (f & L).
    { rewrite (computes_orientation _ _ Co) by assumption. apply Rmult_integral_contrapositive.
      split.
      - apply pow_nonzero. lra.
      - now apply not_0_IZR. }
    pose proof (vertices_NoDup f) as N. apply lists_vertices in L. rewrite L, map_app in N.
    apply (face_independent f).
    + rewrite L, map_app, Pl. intros p I. apply in_or_app. now left.
    + rewrite Pl. now apply NoDup_front in N.
  - destruct (Table.find (cell_place e) _) as [t'|] eqn:F; [|discriminate]. booleans. subst t'.
    rewrite table_find in F. destruct (numbered (complex_order c) (cell_place e)) as [t'|] eqn:M;
      [|discriminate].
    injection F as F. unfold id in F. subst t'. now apply numbered_in with (cell_place e).
Qed.
Lemma in_alone t : In t T <-> exists k e, entry k e /\ t = map spot (cell_vertices e).
Proof.
  unfold simplices_of_certificate. cbn. rewrite map_map, in_map_iff. cbn. split.
  - intros (e & <- & I). apply in_numbered in I. destruct I as (k & E). eauto.
  - intros (k & e & E & ->). exists e. split; [reflexivity|]. now apply numbered_in with k.
Qed.

(** ** The leaves *)

(** A leaf shows the simplex with its number. *)
Definition shows (a : cell) (k : positive) : Prop := exists e X, entry k e /\
  find_all points_table (cell_vertices e) = Some X /\ cell_number a = k /\
  corner_places a = combine (cell_vertices e) (map coordinates X).
Lemma leaf_of_spec k t : leaf_of pr c k = Some t -> boxed d t /\ exists a, leaf t a /\ shows a k.
Proof.
  unfold leaf_of. rewrite table_find. destruct (numbered (complex_cells c) k) as [e|] eqn:E;
    [|discriminate].
  unfold id. cbn [option_map]. destruct (find_all points_table (cell_vertices e)) as [X|] eqn:F;
    [|discriminate].
  intros H. injection H as <-. destruct (find_places _ _ F) as (_ & Sh & _ & L). split.
  - assert (Sh' : Forall (fun p => length p = d) (map coordinates X)).
    { apply Forall_forall. intros p I. apply in_map_iff in I. destruct I as (s & <- & I).
      rewrite Forall_forall in Sh. now apply Sh. }
    destruct (cell_accepted k e E) as (X' & F' & LX & _). rewrite F in F'. injection F' as <-.
    split; [|exact I]. cbn [box_around]. split.
    + apply own_box_length; [assumption|]. intros Em. apply map_eq_nil in Em. now rewrite Em in LX.
    + cbn [leaf]. intros a p <- I. apply (in_own_box d); [assumption|]. unfold places in I.
      cbn [corner_places] in I.
      apply in_map_iff in I. destruct I as ((v, q) & <- & I). now apply in_combine_r in I.
  - eexists. split; [reflexivity|]. exists e, X. cbn. auto.
Qed.
Lemma leaves_of_spec l : forall made M, leaves_of pr c made l = Some M ->
  (forall t, In t made -> boxed d t) -> (forall t, In t M -> boxed d t) /\
  (forall t, In t made -> In t M) /\ forall k, In k l -> exists t a, In t M /\ leaf t a /\
    shows a k.
Proof.
  induction l as [|k l IH]; intros made M E B; cbn [leaves_of] in E.
  - injection E as <-. split; [assumption|]. split; [auto|intros k []].
  - destruct (leaf_of pr c k) as [t|] eqn:F; [|discriminate].
    destruct (leaf_of_spec k t F) as (Bt & a & La & Sa).
    destruct (IH _ _ E) as (B' & K & H); [intros u [<-|I]; auto|]. split; [assumption|]. split.
    + intros u I. apply K. now right.
    + intros j [<-|I]; [|auto]. exists t, a. split; [apply K; now left|auto].
Qed.
Lemma every_two_leaves : forall j k, In j (complex_order c) -> In k (complex_order c) -> j <> k ->
  exists a b, shows a j /\ shows b k /\ (kept_apart d a b \/ kept_apart d b a).
Proof.
  intros j k Ij Ik N. destruct parts_accepted as (_ & _ & _ & _ & _ & l & t & E & G & A).
  rewrite dim_d in A.
  assert (No : forall u, In u [] -> boxed d u) by (intros u []).
  destruct (leaves_of_spec _ _ _ E No) as (B & _ & H).
  destruct (grown_spec d _ _ _ G B) as (Bt & K).
  destruct (H j Ij) as (u & a & Iu & La & Sa). destruct (H k Ik) as (v & b & Iv & Lb & Sb).
  exists a, b.
  split; [assumption|]. split; [assumption|].
  destruct (all_parted_spec d t Bt A a b (K u a Iu La) (K v b Iv Lb)) as [E'|O]; [|assumption].
  exfalso. apply N. destruct Sa as (? & ? & _ & _ & <- & _), Sb as (? & ? & _ & _ & <- & _).
  now rewrite E'.
Qed.

(** ** Two leaves *)

Definition points_of (a : cell) : simplex d := map (fun v => spot (fst v)) (corner_places a).
Lemma shows_points a k e : shows a k -> entry k e -> points_of a = map spot (cell_vertices e).
Proof.
  intros (e' & X & E' & F & _ & C) E. replace e' with e in * by congruence. unfold points_of.
  rewrite C.
  destruct (find_places _ _ F) as (_ & _ & _ & L).
  assert (L' : length (map coordinates X) = length (cell_vertices e))
    by (now rewrite map_length). revert L'. generalize (map coordinates X). clear.
  induction (cell_vertices e) as [|v l IH]; intros [|x X] L; try discriminate; cbn; [reflexivity|].
  f_equal.
  apply IH. cbn in L. lia.
Qed.
Lemma shows_corner a k v : shows a k -> In v (corner_places a) ->
  exists s, spot (fst v) = place_of r s /\ well_shaped d s /\ snd v = coordinates s.
Proof.
  intros (e & X & _ & F & _ & C) I. rewrite C in I. clear C. revert X F I.
  induction (cell_vertices e) as [|w l IH]; intros X F I; [destruct I|]. cbn [find_all] in F.
  destruct (Table.find w points_table) as [s|] eqn:W; [|discriminate].
  destruct (find_all points_table l) as [Y|]; [|discriminate]. injection F as <-.
  destruct I as [<-|I]; [|eauto].
  destruct (find_place w s W) as (A & B & _). exists s. auto.
Qed.

Lemma among_in k B : among k B = true -> exists v, In v B /\ fst v = k.
Proof.
  intros H. apply existsb_exists in H. destruct H as (v & I & E). booleans. exists v. auto.
Qed.
Lemma corner_value a k v h : shows a k -> In v (corner_places a) -> length (fst h) = d ->
  height_over r h (spot (fst v)) = r * IZR (value h (snd v)).
Proof.
  intros Sa I L. destruct (shows_corner a k v Sa I) as (s & -> & W & ->). now apply height_over_at.
Qed.

Lemma parts_meet a b j k h : shows a j -> shows b k ->
  parts h d (corner_places a) (corner_places b) = true ->
  forall q, conv (points_of a) q -> conv (points_of b) q ->
    conv (meet (points_of a) (points_of b)) q.
Proof.
  intros Sa Sb H q. pose proof unit_positive as U. unfold parts in H. cbv zeta in H.
  apply andb_prop in H. destruct H as [H B]. apply andb_prop in H. destruct H as [L A].
  apply Nat.eqb_eq in L.
  rewrite forallb_forall in A, B.
  apply (parted_meet _ _ (height_over r h)); [apply height_over_affine|..].
  - intros p I. apply in_map_iff in I. destruct I as (v & <- & I).
    rewrite (corner_value a j) by assumption.
    specialize (A v I). apply orb_prop in A. destruct A as [A|A].
    + apply Z.ltb_lt, IZR_lt in A. nra.
    + booleans. apply Z.eqb_eq in H. rewrite H. lra.
  - intros p I E. apply in_map_iff in I. destruct I as (v & <- & I).
    rewrite (corner_value a j) in E by assumption.
    specialize (A v I). apply orb_prop in A. destruct A as [A|A].
    + apply Z.ltb_lt, IZR_lt in A. exfalso. nra.
    + apply andb_prop in A. destruct A as [_ A]. apply among_in in A. destruct A as (w & Iw & <-).
      apply in_map_iff. eauto.
  - intros p I. apply in_map_iff in I. destruct I as (v & <- & I).
    rewrite (corner_value b k) by assumption.
    specialize (B v I). apply Z.leb_le, IZR_le in B. nra.
Qed.

Definition meet_in_face (s t : simplex d) : Prop :=
  ~ same s t /\ forall q, conv s q -> conv t q -> exists f, incl f s /\ incl f t /\ conv f q.
Lemma meet_in_face_sym s t : meet_in_face s t -> meet_in_face t s.
Proof.
  intros [N M]. split; [intros [A B]; apply N; now split|]. intros q A B.
  destruct (M q B A) as (f & F & G & C). eauto.
Qed.
Lemma meet_incl (s t : simplex d) : incl (meet s t) s /\ incl (meet s t) t.
Proof. split; intros p I; now apply in_meet in I. Qed.

Lemma spots_different v w a j b k : shows a j -> shows b k -> In v (corner_places a) ->
  In w (corner_places b) ->
  spot (fst v) = spot (fst w) -> fst v = fst w.
Proof.
  assert (K : forall a j v, shows a j -> In v (corner_places a) ->
    exists e, numbered (complex_points c) (fst v) = Some e).
  { clear. intros a j v (e & X & _ & F & _ & C) I. rewrite C in I. clear C. revert X F I.
    induction (cell_vertices e) as [|u l IH]; intros X F I; [destruct I|]. cbn [find_all] in F.
    destruct (Table.find u points_table) as [s|] eqn:W; [|discriminate].
    destruct (find_all points_table l) as [Y|]; [|discriminate]. injection F as <-.
    destruct I as [<-|I]; [|eauto].
    rewrite table_find in W. cbn. destruct (numbered (complex_points c) u); [eauto|discriminate]. }
  intros Sa Sb Iv Iw E. destruct (K a j v Sa Iv) as (e & Ne), (K b k w Sb Iw) as (e' & Ne').
  rewrite (spot_numbered d bare _ e Ne), (spot_numbered d bare _ e' Ne') in E.
  pose proof unit_positive as U.
  destruct shaped_distinct as [F N]. rewrite Forall_forall in F.
  apply place_inj in E; [|lra|now apply F; apply numbered_in with (fst v)|now apply F;
    apply numbered_in with (fst w)].
  unfold numbered in Ne, Ne'. apply (map_nth_error (fun e => coordinates (position e))) in Ne, Ne'.
  rewrite E in Ne. rewrite <- Ne' in Ne.
  assert (pred (Pos.to_nat (fst v)) = pred (Pos.to_nat (fst w))).
  { apply (proj1 (NoDup_nth_error _) N); [|assumption]. apply nth_error_Some. congruence. }
  lia.
Qed.

Lemma kept_apart_meet a b j k : shows a j -> shows b k -> kept_apart d a b ->
  meet_in_face (points_of a) (points_of b).
Proof.
  intros Sa Sb H. assert (Out : forall s t q, conv (meet s t) q -> exists f : simplex d, incl f s /\
    incl f t /\ conv f q).
  { intros s t q C. exists (meet s t). destruct (meet_incl s t). auto. }
  assert (Ne : forall x n, shows x n -> exists v, In v (corner_places x)).
  { intros x n (e & X & E & F & _ & C). destruct (cell_accepted n e E) as (Y & F' & L & _).
    rewrite F in F'.
    injection F' as <-. destruct (find_places _ _ F) as (_ & _ & _ & L'). rewrite C.
    destruct X as [|s X]; [discriminate|]. destruct (cell_vertices e) as [|v l]; [discriminate|].
    eexists. now left. }
  destruct H as [H|(i & m & H)].
  - unfold parted in H. cbv zeta in H. apply andb_prop in H. destruct H as [Df H]. split.
    + intros [Inc _]. apply negb_true_iff in Df.
      enough (forallb (fun v => among (fst v) (corner_places b)) (corner_places a) = true)
        by congruence. apply forallb_forall. intros v Iv.
      assert (I : In (spot (fst v)) (points_of b)) by (apply Inc, in_map_iff; eauto).
      apply in_map_iff in I. destruct I as (w & E & Iw). apply existsb_exists. exists w.
      split; [assumption|].
      apply Pos.eqb_eq. symmetry. now apply (spots_different w v b k a j).
    + intros q Ca Cb. rewrite !orb_true_iff in H.
      destruct H as [[[H|H]|H]|H]; apply existsb_exists in H; destruct H as (h & _ & H).
      * destruct (Out _ _ _ (parts_meet b a k j h Sb Sa H q Cb Ca)) as (f & A & B & C). eauto.
      * apply Out. now apply (parts_meet a b j k h).
      * apply andb_prop in H. destruct H as [_ H]. apply Out.
        now apply (parts_meet a b j k (snd h)).
      * apply andb_prop in H. destruct H as [_ H].
        destruct (Out _ _ _ (parts_meet b a k j (snd h) Sb Sa H q Cb Ca)) as (f & A & B & C). eauto.
  - assert (No : forall x y n n', shows x n -> shows y n' -> below d i m (places x) (places y) ->
      forall q, conv (points_of x) q -> conv (points_of y) q -> False).
    { clear - accepts Co Or dim_d. intros x y n n' Sx Sy (Hi & X & Y) q Cx Cy.
      pose proof unit_positive as U.
      set (h := (@axis d i, m)). assert (L : length (fst h) = d) by apply axis_length.
      assert (V : forall z l v, shows z l -> In v (corner_places z) ->
        height_over r h (spot (fst v)) = r * (IZR (nth i (snd v) 0%Z) - IZR m)).
      { intros z l v Sz I. rewrite (corner_value z l) by assumption. unfold value, h. cbn [fst snd].
        destruct (shows_corner z l v Sz I) as (s & _ & W & ->). rewrite axis_value by assumption.
        now rewrite minus_IZR. }
      assert (0 <= - height_over r h q).
      { apply (affine_conv (fun p => - height_over r h p) (points_of x));
          [apply affine_opp, height_over_affine| |assumption].
        intros p I. apply in_map_iff in I. destruct I as (v & <- & I). rewrite (V x n v Sx I).
        specialize (X (snd v) (in_map snd _ _ I)). apply IZR_le in X. nra. }
      assert (C : conv (meet (points_of y) []) q).
      { apply conv_meet; [assumption|]. intros p I _. exists (height_over r h).
        split; [apply height_over_affine|].
        assert (Pos : forall p, In p (points_of y) -> 0 < height_over r h p).
        { clear p I. intros p I. apply in_map_iff in I. destruct I as (v & <- & I).
          rewrite (V y n' v Sy I).
          specialize (Y (snd v) (in_map snd _ _ I)). apply IZR_lt in Y. nra. }
        split; [intros p' I'; left; auto|]. split; [auto|lra]. }
      apply (conv_empty q). apply (conv_incl (meet (points_of y) [])); [|assumption].
      intros p I. now apply in_meet in I. }
    assert (No' : forall q, conv (points_of a) q -> conv (points_of b) q -> False).
    { intros q Ca Cb.
      destruct H as [H|H]; [now apply (No a b j k Sa Sb H q)|now apply (No b a k j Sb Sa H q)]. }
    split; [|intros q Ca Cb; destruct (No' q Ca Cb)]. intros Sm. destruct (Ne a j Sa) as (v & Iv).
    assert (I : In (spot (fst v)) (points_of a)) by (apply in_map_iff; eauto).
    apply (No' (spot (fst v))); apply conv_point; [assumption|]. now apply (proj1 Sm).
Qed.

(** ** The whole *)

Lemma every_two_meet : ForallOrdPairs meet_in_face T.
Proof.
  assert (G : forall l n, (forall i e, nth_error l i = Some e -> entry (Pos.of_succ_nat (n + i)) e)
    ->
    ForallOrdPairs meet_in_face (map (fun e => map spot (cell_vertices e)) l)).
  { induction l as [|e l IH]; intros n H; cbn [map]; constructor.
    - apply Forall_forall. intros t I. apply in_map_iff in I. destruct I as (e' & <- & I).
      apply In_nth_error in I. destruct I as (i & N).
      pose proof (H 0%nat e eq_refl) as E. pose proof (H (S i) e' N) as E'.
      destruct (cell_accepted _ _ E) as (_ & _ & _ & _ & O),
        (cell_accepted _ _ E') as (_ & _ & _ & _ & O').
      destruct (every_two_leaves _ _ O O') as (a & b & Sa & Sb & K); [lia|].
      rewrite <- (shows_points a _ e Sa E), <- (shows_points b _ e' Sb E').
      destruct K as [K|K]; [now apply (kept_apart_meet a b _ _ Sa Sb)|].
      apply meet_in_face_sym. now apply (kept_apart_meet b a _ _ Sb Sa).
    - apply (IH (S n)). intros i e' N. rewrite <- (H (S i) e' N). f_equal. lia. }
  unfold simplices_of_certificate. cbn. rewrite map_map. cbn. apply (G _ 0%nat). intros i e N.
  unfold numbered.
  now rewrite SuccNat2Pos.id_succ.
Qed.
Theorem check_alone_in_sound : simplices_meet_in_faces P T.
Proof.
  constructor.
  - destruct parts_accepted as (_ & _ & _ & N & _). unfold simplices_of_certificate. cbn.
    destruct (complex_cells c); [congruence|discriminate].
  - exists (complex_dimension c). intros t I. apply in_alone in I. destruct I as (k & e & E & ->).
    destruct (cell_accepted k e E) as (X & F & L & _).
    destruct (find_places _ _ F) as (_ & _ & _ & L').
    rewrite map_length. congruence.
  - intros t I. apply in_alone in I. destruct I as (k & e & E & ->).
    destruct (cell_accepted k e E) as (X & F & L & Ind & _). split; [|assumption].
    now apply (find_places _ _ F).
  - pose proof every_two_meet as H. clear - H.
    induction H as [|s l F H IH]; constructor; [|assumption].
    eapply Forall_impl; [|exact F]. now intros t [N _].
  - pose proof every_two_meet as H. clear - H.
    induction H as [|s l F H IH]; constructor; [|assumption].
    eapply Forall_impl; [|exact F]. now intros t [_ M].
  - exact alone_points_once.
Qed.
End Sound.

Theorem check_some_unused_sound D c : check_some_unused D c = Accepted ->
  simplices_meet_in_faces (points_of_certificate (dimension_of D) (bare_certificate c))
    (simplices_of_certificate (dimension_of D) (bare_certificate c)).
Proof.
  destruct D; intros A.
  - exact (check_alone_in_sound oriented2 plane_computes true c A).
  - exact (check_alone_in_sound oriented3 space_computes true c A).
Qed.
Theorem check_alone_sound D c : check_alone D c = Accepted ->
  simplices_form_a_complex (points_of_certificate (dimension_of D) (bare_certificate c))
    (simplices_of_certificate (dimension_of D) (bare_certificate c)).
Proof.
  destruct D; intros A; split.
  - exact (check_alone_in_sound oriented2 plane_computes false c A).
  - intros p. now apply (alone_points_used false c A).
  - exact (check_alone_in_sound oriented3 space_computes false c A).
  - intros p. now apply (alone_points_used false c A).
Qed.
