(** * All of the canonical triangulation is found, and nothing else *)
From Coq Require Import Rbase Rfunctions Lra Psatz Lia List Arith ZArith Bool.
From Circumspect Require Import GiftWrapping Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Facets Matched Adjacency
  LiftingMap.
From Circumspect Require Import Orientation Integers RefutationSigns Perturbation EveryPointSet
  Exchange WrappingSound.
Import ListNotations.
Open Scope R_scope.

(** ** Lists of so many members *)

Fixpoint rows_of {A} (l : list A) (n : nat) : list (list A) :=
  match n with O => [[]] | S m => flat_map (fun a => map (cons a) (rows_of l m)) l end.
Lemma in_rows {A} (l : list A) : forall n X, length X = n -> incl X l -> In X (rows_of l n).
Proof.
  induction n as [|n IH]; intros [|a X] L I; try discriminate; [now left|]. cbn [rows_of].
  apply in_flat_map.
  exists a. split; [apply I; now left|]. apply in_map. apply IH; [now injection L|]. intros x Hx.
  apply I. now right.
Qed.
Lemma rows_length {A} (l : list A) n : length (rows_of l n) = (length l ^ n)%nat.
Proof.
  induction n as [|n IH]; [reflexivity|]. cbn [rows_of Nat.pow]. rewrite <- IH.
  generalize (rows_of l n). clear IH. intros m.
  induction l as [|a l IHl]; [reflexivity|]. cbn [flat_map length].
  rewrite app_length, map_length, IHl. lia.
Qed.
Lemma power_spec p n : Pos.to_nat (power p n) = (Pos.to_nat p ^ n)%nat.
Proof.
  induction n as [|n IH]; [reflexivity|]. cbn [power Nat.pow]. now rewrite Pos2Nat.inj_mul, IH.
Qed.

Section Whole.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates} {r : R}.
Hypothesis M : measured orient pr r.
Variable P : list spotted.
Notation place p := (@place_of d r (snd p)).
Notation places X := (map (fun p : spotted => @place_of d r (snd p)) X).
Notation Points := (places P).
Notation framed X t := (RefutationSigns.framed orient pr r (map snd X) t).
Hypothesis shaped_points : Forall (fun p : spotted => well_shaped d (snd p)) P.
Hypothesis numbers_differ : NoDup (map fst P).
Hypothesis places_differ : NoDup Points.
Variable h : point d -> R.
Hypothesis heights : forall p, In p P -> h (place p) = @height_of d r (snd p).
Implicit Types (p v : spotted) (X Y : list spotted) (t u y : frame d).

Hypothesis positive : (1 <= d)%nat.
Variable T : list (simplex d).
Hypothesis canonical_T : symbolic_triangulation Points h T.
Let filled : fills Points T := proj1 canonical_T.

Lemma canonical_same t u : same (vertices t) (vertices u) -> canonical Points h t ->
  canonical Points h u.
Proof.
  intros E C p Ip N. rewrite <- (coefficients_same Points h t u p E). apply C; [assumption|].
  intros H. apply N. now apply E.
Qed.
Lemma canonical_in_T u : In (vertices u) T -> canonical Points h u.
Proof.
  intros I. destruct (proj2 canonical_T _ I) as (t & E & C).
  apply (canonical_same t); [|assumption].
  rewrite E. split; apply incl_refl.
Qed.
Lemma spotted_of q : In q Points -> exists p, In p P /\ place p = q.
Proof. intros I. apply in_map_iff in I. destruct I as (p & E & Ip). eauto. Qed.

(** ** Neighbours *)

(** Facet i of t is a facet of whoever has the same vertices. *)
Lemma facet_elsewhere t x i : same (vertices t) (vertices x) -> (i <= d)%nat ->
  exists k, (k <= d)%nat /\
  same (facet_of t i) (facet_of x k) /\ forall q, bary t i q = bary x k q.
Proof.
  intros Sm Hi. destruct (facet_index x (facet_of t i)) as (k & Hk & Fi).
  { now apply facet_of_NoDup. } { now apply facet_of_length. }
  { intros v Hv. apply Sm. now apply (facet_of_incl t i Hi). }
  exists k. split; [assumption|]. split; [assumption|].
  assert (V : vertex x k = vertex t i).
  { assert (Iv : In (vertex t i) (vertices x)) by (apply Sm, in_vertices; eauto).
    apply in_vertices in Iv. destruct Iv as (l & Hl & E).
    destruct (Nat.eq_dec l k) as [->|N]; [now symmetry|].
    exfalso. apply (not_in_facet_of t i Hi). apply Fi. apply (in_facet_of x k _ Hk). eauto. }
  intros q. rewrite (facet_multiple t i x k Hi Hk Fi q), V, bary_own by assumption. ring.
Qed.
Lemma opposite_elsewhere t x i u j : same (vertices t) (vertices x) -> opposite t i u j ->
  exists k, opposite x k u j.
Proof.
  intros Sm O. apply opposite_facets in O. destruct O as (Hi & Hj & Sf & O).
  destruct (facet_elsewhere t x i Sm Hi) as (k & Hk & Fi & B). exists k. apply opposite_facets.
  split; [assumption|]. split; [assumption|]. split; [|now rewrite <- B].
  destruct Fi, Sf. split; eapply incl_tran; eassumption.
Qed.
Lemma neighbour_of_same t s i p : In s T -> same (vertices t) s -> (i <= d)%nat -> In p P ->
  bary t i (place p) < 0 ->
  exists u j, In (vertices u) T /\ opposite t i u j.
Proof.
  intros Is Sm Hi Ip Neg. destruct (fills_frame Points T s filled Is) as (t' & <-).
  destruct (facet_elsewhere t t' i Sm Hi) as (k & Hk & Fi & B). rewrite B in Neg.
  destruct (neighbour_beyond positive Points T filled t' k (place p) Is Hk
    (in_map (fun p : spotted => place p) _ _ Ip) Neg)
    as (u & j & Iu & O). exists u, j. split; [assumption|]. apply opposite_facets in O.
    destruct O as (_ & Hj & Sf & O).
  apply opposite_facets. split; [assumption|]. split; [assumption|]. split; [|now rewrite B].
  destruct Fi, Sf. split; eapply incl_tran; eassumption.
Qed.

Definition one_of_T X : Prop := incl X P /\ exists t s, framed X t /\ In s T /\ same (vertices t) s.
Lemma one_length X : one_of_T X -> length X = S d.
Proof.
  intros (_ & t & _ & F & _). pose proof (framed_length _ _ F) as L. now rewrite map_length in L.
Qed.

Lemma apex_of_neighbour X t i u j : incl X P -> framed X t -> In (vertices u) T ->
  opposite t i u j ->
  exists V, apex_beyond pr P X i = Some V /\ one_of_T (replace i V X) /\
    same (places (replace i V X)) (vertices u).
Proof.
  intros I F Iu O. destruct (spotted_of (vertex u j)) as (V & IV & EV).
  { destruct filled as (_ & _ & _ & Vs & _). apply (Vs _ Iu), in_vertices. exists j.
    split; [apply O|reflexivity]. }
  pose proof (canonical_in_T u Iu) as C. exists V. split.
  - exact (scan_finds M P shaped_points numbers_differ places_differ h heights X t i u j V F I O C
      (conj IV EV)).
  - destruct (across_is_neighbour M P shaped_points places_differ X t i u j V F I O (conj IV EV))
      as (y & Fy & Iy & Sy).
    split; [split; [assumption|]; now exists y, (vertices u)|].
    now rewrite <- (framed_places _ y Fy).
Qed.

Lemma apex_beyond_spec X i b : apex_beyond pr P X i = Some b -> In b P /\ is_beyond pr X i b = true.
Proof.
  unfold apex_beyond.
  assert (G : forall l best, incl l P -> (forall b, best = Some b -> In b P /\
    is_beyond pr X i b = true) ->
    forall b, fold_left (lower pr P X i) l best = Some b -> In b P /\ is_beyond pr X i b = true).
  { induction l as [|p l IH]; intros best I Hb c E; [now apply Hb|]. cbn [fold_left] in E.
    apply (IH (lower pr P X i best p)); [intros x Hx; apply I; now right| |assumption].
    intros e Ee. unfold lower in Ee. destruct (is_beyond pr X i p) eqn:By; [|now apply Hb].
    assert (Own : In p P /\ is_beyond pr X i p = true) by (split; [apply I; now left|assumption]).
    destruct best as [b'|]; [|injection Ee as <-; assumption].
    destruct (_ <? 0)%Z; [injection Ee as <-; assumption|now apply Hb]. }
  intros E. apply (G P None); [apply incl_refl|discriminate|assumption].
Qed.
Lemma neighbours_in_T X Y : one_of_T X -> In Y (neighbours pr P X) -> one_of_T Y.
Proof.
  intros (I & t & s & F & Is & Sm) H. unfold neighbours in H. apply in_flat_map in H.
  destruct H as (i & Hi & H).
  unfold corners_numbered in Hi. rewrite (dimension_d M) in Hi. apply in_seq_d in Hi.
  destruct (apex_beyond pr P X i) as [b|] eqn:E; [|destruct H]. destruct H as [<-|[]].
  destruct (apex_beyond_spec X i b E) as [Ib By].
  apply (is_beyond_spec M P shaped_points X t F b i Ib Hi) in By.
  destruct (neighbour_of_same t s i b Is Sm Hi Ib By) as (u & j & Iu & O).
  destruct (apex_of_neighbour X t i u j I F Iu O) as (V & E' & One & _). congruence.
Qed.
Lemma neighbour_listed X t u i j : incl X P -> framed X t -> In (vertices u) T ->
  opposite t i u j ->
  exists Y, In Y (neighbours pr P X) /\ one_of_T Y /\ same (places Y) (vertices u).
Proof.
  intros I F Iu O. destruct (apex_of_neighbour X t i u j I F Iu O) as (V & E & One & Sm).
  exists (replace i V X).
  split; [|now split]. unfold neighbours. apply in_flat_map. exists i. split.
  - unfold corners_numbered. rewrite (dimension_d M). apply in_seq_d. apply O.
  - rewrite E. now left.
Qed.

(** ** What was found *)

Lemma same_vertices_spec X Y : incl X P -> incl Y P ->
  (same_vertices X Y = true <-> same (places X) (places Y)).
Proof.
  intros IX IY. unfold same_vertices. rewrite andb_true_iff, !forallb_forall.
  assert (G : forall X Y, incl X P -> incl Y P -> ((forall v, In v X -> is_vertex Y v = true) <->
    incl (places X) (places Y))).
  { clear X Y IX IY. intros X Y IX IY. split.
    - intros H q Hq. apply in_map_iff in Hq. destruct Hq as (v & <- & Iv).
      apply (in_map (fun p : spotted => place p)).
      apply (is_vertex_spec P numbers_differ Y v IY (IX v Iv)). now apply H.
    - intros H v Iv. apply (is_vertex_spec P numbers_differ Y v IY (IX v Iv)).
      pose proof (H _ (in_map (fun p : spotted => place p) _ _ Iv)) as Q. apply in_map_iff in Q.
      destruct Q as (w & E & Iw).
      now rewrite <- (spotted_place P places_differ w v (IY w Iw) (IX v Iv) E). }
  unfold same. now rewrite (G X Y IX IY), (G Y X IY IX).
Qed.

Record so_far (st : state) (c : nat) : Prop := {
  each_of_T : forall X, In X (fst st) -> one_of_T X;
  open_found : incl (snd st) (fst st);
  found_once : ForallOrdPairs (fun X Y => same_vertices X Y = false) (fst st);
  crossed : forall X, In X (fst st) -> In X (snd st) \/
    forall Y, In Y (neighbours pr P X) -> exists Z, In Z (fst st) /\ same_vertices Y Z = true;
  counted : (c + length (snd st) = length (fst st))%nat
}.

Lemma same_vertices_self Y : incl Y P -> same_vertices Y Y = true.
Proof. intros I. apply (same_vertices_spec Y Y I I). split; apply incl_refl. Qed.
Lemma all_added l : forall st, (forall Y, In Y l -> one_of_T Y) ->
  (forall X, In X (fst st) -> one_of_T X) ->
  incl (snd st) (fst st) -> ForallOrdPairs (fun X Y => same_vertices X Y = false) (fst st) ->
  let st' := fold_left added l st in
  (forall X, In X (fst st') -> one_of_T X) /\ incl (snd st') (fst st') /\
  ForallOrdPairs (fun X Y => same_vertices X Y = false) (fst st') /\
  incl (fst st) (fst st') /\ incl (snd st) (snd st') /\
  (forall X, In X (fst st') -> In X (fst st) \/ In X (snd st')) /\
  (forall Y, In Y l -> exists Z, In Z (fst st') /\ same_vertices Y Z = true) /\
  (length (fst st') + length (snd st) = length (fst st) + length (snd st'))%nat.
Proof.
  induction l as [|Y l IH]; intros st Hl Hf Ho Hp; cbv zeta; cbn [fold_left].
  - split; [exact Hf|]. split; [exact Ho|]. split; [exact Hp|]. split; [apply incl_refl|].
    split; [apply incl_refl|].
    split; [intros X I; now left|]. split; [intros Y []|lia].
  - assert (OneY : one_of_T Y) by (apply Hl; now left).
    assert (Hl' : forall Y, In Y l -> one_of_T Y) by (intros; apply Hl; now right).
    destruct (existsb (same_vertices Y) (fst st)) eqn:E.
    + replace (added st Y) with st by (unfold added; now rewrite E).
      destruct (IH st Hl' Hf Ho Hp) as (A & B & C & D & F & G & K & L).
      repeat (split; [assumption|]). split; [|assumption].
      intros Z [<-|I]; [|now apply K]. apply existsb_exists in E. destruct E as (Z & IZ & E).
      exists Z. auto.
    + replace (added st Y) with (Y :: fst st, Y :: snd st) by (unfold added; now rewrite E).
      destruct (IH (Y :: fst st, Y :: snd st) Hl') as (A & B & C & D & F & G & K & L);
        cbn [fst snd] in *.
      * intros X [<-|I]; auto.
      * intros X [<-|I]; [now left|right; auto].
      * constructor; [|assumption]. apply Forall_forall. intros X I.
        destruct (same_vertices Y X) eqn:S'; [|reflexivity].
        rewrite <- E. symmetry. apply existsb_exists. eauto.
      * split; [assumption|]. split; [assumption|]. split; [assumption|].
        split; [intros X I; apply D; now right|]. split; [intros X I; apply F; now right|].
        split; [|split; [|cbn [length] in L; lia]].
        -- intros X I.
          destruct (G X I) as [[<-|J]|J]; [right; apply F; now left|now left|now right].
        -- intros Z [<-|I]; [|now apply K]. exists Y. split; [apply D; now left|].
          apply same_vertices_self, OneY.
Qed.
Lemma step_so_far st c : so_far st c -> snd st <> [] -> so_far (step pr P st) (S c).
Proof.
  intros [Hf Ho Hp Hc Hn] N. unfold step. destruct (snd st) as [|X q] eqn:Q; [contradiction|].
  destruct (all_added (neighbours pr P X) (fst st, q)) as (A & B & C & D & F & G & K & L);
    cbn [fst snd] in *; auto.
  - intros Y. apply neighbours_in_T. apply Hf, Ho. now left.
  - intros Y I. apply Ho. now right.
  - constructor; auto.
    + intros Z IZ. destruct (G Z IZ) as [J|J]; [|now left]. destruct (Hc Z J) as [[<-|J']|J'].
      * right. exact K.
      * left. now apply F.
      * right. intros Y IY. destruct (J' Y IY) as (W & IW & E). exists W. auto.
    + cbn [length] in Hn. lia.
Qed.
Lemma steps_so_far n : forall st c, so_far st c -> exists c', so_far (steps pr P n st) c' /\
  (snd (steps pr P n st) = [] \/ c' = (c + Pos.to_nat n)%nat).
Proof.
  assert (Stop : forall n st, snd st = [] -> steps pr P n st = st) by (intros [m|m|] st E; cbn;
    now rewrite E).
  induction n as [n IH|n IH|]; intros st c H; (destruct (snd st) as [|X q] eqn:E;
    [exists c; split; [|left]; rewrite Stop; assumption|]); cbn [steps]; rewrite E.
  - assert (N : snd st <> []) by congruence.
    destruct (IH _ _ (step_so_far st c H N)) as (c1 & H1 & O1).
    destruct (IH _ _ H1) as (c2 & H2 & O2). exists c2. split; [assumption|].
    destruct O2 as [O2|O2]; [now left|]. destruct O1 as [O1|O1]; [left; rewrite Stop; assumption|].
    right. rewrite Pos2Nat.inj_xI. lia.
  - destruct (IH _ _ H) as (c1 & H1 & O1). destruct (IH _ _ H1) as (c2 & H2 & O2). exists c2.
    split; [assumption|].
    destruct O2 as [O2|O2]; [now left|]. destruct O1 as [O1|O1]; [left; rewrite Stop; assumption|].
    right. rewrite Pos2Nat.inj_xO. lia.
  - exists (S c). split; [apply step_so_far; [assumption|congruence]|]. right. lia.
Qed.

(** There are no more than so many. *)
Lemma not_more st c : so_far st c -> (length (fst st) <= length P ^ S d)%nat.
Proof.
  intros [Hf _ Hp _ _]. rewrite <- rows_length. apply NoDup_incl_length.
  - clear - Hf Hp numbers_differ places_differ. induction Hp as [|X l Fx Hp IH]; constructor.
    + intros I. rewrite Forall_forall in Fx. specialize (Fx X I).
      rewrite same_vertices_self in Fx by (apply (Hf X); now left). discriminate.
    + apply IH. intros Y I. apply Hf. now right.
  - intros X I. pose proof (Hf X I) as One. apply in_rows; [now apply one_length|apply One].
Qed.

(** ** The first simplex *)

Lemma passes_spec X : incl X P -> passes pr P X = true -> one_of_T X.
Proof.
  intros I H. unfold passes in H. rewrite !andb_true_iff, forallb_forall in H.
  destruct H as [[L Pr] A].
  unfold right_length in L. apply has_length_length in L. rewrite (dimension_d M) in L.
  destruct (proper_framed M (map snd X) (shaped_list P shaped_points X I)) as (t & F);
    [now rewrite map_length|assumption|].
  split; [assumption|].
  assert (C : canonical Points h t).
  { intros q Iq N. destruct (spotted_of q Iq) as (p & Ip & <-).
    assert (Np : ~ In p X) by (intros J; apply N;
      now apply (in_vertices_spotted P places_differ X t p F I Ip)).
    specialize (A p Ip). apply orb_true_iff in A. destruct A as [A|A].
    - apply (is_vertex_spec P numbers_differ X p I Ip) in A. contradiction.
    - apply Z.ltb_lt, IZR_lt in A.
      destruct (height_sign_spec M P shaped_points numbers_differ places_differ h heights X t F I p
        Ip Np) as (k & K & E). nra. }
  assert (It : incl (vertices t) Points).
  { rewrite (framed_places X t F). intros q Hq. apply in_map_iff in Hq.
    destruct Hq as (v & <- & Iv).
    apply (in_map (fun p : spotted => place p)). auto. }
  assert (Q : conv Points (barycentre t)).
  { apply (conv_incl (vertices t)); [assumption|]. apply conv_vertices. intros i Hi. left.
    now apply barycentre_inside. }
  pose proof filled as (_ & _ & _ & Vs & U). apply U in Q. destruct Q as (s & Is & Q).
  destruct (fills_frame Points T s filled Is) as (u & <-). exists t, (vertices u).
  split; [assumption|]. split; [assumption|].
  assert (Inc : incl (vertices t) (vertices u)).
  { apply (canonical_overlap Points h t u (barycentre t)); auto.
    - now apply canonical_in_T.
    - apply barycentre_inside.
    - now apply conv_vertices. }
  split; [assumption|].
  apply NoDup_length_incl; [apply vertices_NoDup|rewrite !vertices_length; lia|assumption].
Qed.
Lemma T_passes s : In s T -> exists X, incl X P /\ length X = S d /\ passes pr P X = true.
Proof.
  intros Is. destruct (fills_frame Points T s filled Is) as (t & <-).
  assert (Vs : incl (vertices t) Points) by (destruct filled as (_ & _ & _ & Vs & _); auto).
  assert (E : exists X, incl X P /\ places X = vertices t).
  { revert Vs. generalize (vertices t). clear. intros l. induction l as [|q l IH]; intros I.
    - exists []. split; [intros x []|reflexivity].
    - destruct IH as (X & IX & EX); [intros x Hx; apply I; now right|].
      pose proof (I q (or_introl eq_refl)) as Iq. apply in_map_iff in Iq.
      destruct Iq as (p & Ep & Ip).
      exists (p :: X). split; [intros x [<-|Hx]; auto|]. cbn. now rewrite Ep, EX. }
  destruct E as (X & IX & EX). exists X. split; [assumption|].
  assert (L : length X = S d) by (rewrite <- (vertices_length t), <- EX; now rewrite map_length).
  split; [assumption|].
  assert (Pr : proper pr (map snd X) = true).
  { unfold proper. apply negb_true_iff, Z.eqb_neq. intros Z0.
    apply (measured_spans orient pr r M t). rewrite <- EX. rewrite <- (map_map snd (@place_of d r)).
    rewrite (orient_places M) by (now apply (shaped_list P shaped_points)). rewrite Z0. ring. }
  destruct (proper_framed M (map snd X) (shaped_list P shaped_points X IX)) as (u & F);
    [now rewrite map_length|assumption|].
  assert (C : canonical Points h u).
  { apply (canonical_same t); [|now apply canonical_in_T]. rewrite (framed_places X u F), EX.
    split; apply incl_refl. }
  unfold passes. rewrite !andb_true_iff, forallb_forall. split; [split; [|assumption]|].
  - unfold right_length. apply has_length_length. now rewrite (dimension_d M).
  - intros p Ip. destruct (is_vertex X p) eqn:V; [reflexivity|]. apply Z.ltb_lt.
    assert (Np : ~ In p X) by (intros J; apply (is_vertex_spec P numbers_differ X p IX Ip) in J;
      congruence).
    destruct (height_sign_spec M P shaped_points numbers_differ places_differ h heights X u F IX p
      Ip Np) as (k & K & E).
    apply lt_IZR. rewrite E.
    assert (N : ~ In (place p) (vertices u)) by (intros J; apply Np;
      now apply (in_vertices_spotted P places_differ X u p F IX Ip)).
    specialize (C _ (in_map (fun p : spotted => place p) _ _ Ip) N). nra.
Qed.

Lemma search_some n Q : incl Q P -> forall X Y, incl X P -> search pr P n Q X = Some Y ->
  incl Y P /\ passes pr P Y = true.
Proof.
  intros IQ. induction n as [|n IH]; intros X Y IX E; cbn [search] in E.
  - destruct (passes pr P X) eqn:A; [|discriminate]. injection E as <-. auto.
  - assert (G : forall l, incl l P ->
      (fix tried (l : list spotted) : option (list spotted) := match l with [] => None
      | p :: l' => match search pr P n Q (p :: X) with Some Y => Some Y | None =>
          tried l' end end) l = Some Y ->
      incl Y P /\ passes pr P Y = true); [|now apply (G Q)].
    induction l as [|p l IHl]; intros Il E'; [discriminate|].
    destruct (search pr P n Q (p :: X)) as [Z|] eqn:F.
    + injection E' as <-. apply (IH (p :: X)); [|assumption].
      intros x [<-|Hx]; [apply Il; now left|auto].
    + apply IHl; [intros x Hx; apply Il; now right|assumption].
Qed.
Lemma search_none n Q : forall X, search pr P n Q X = None -> forall Z, length Z = n -> incl Z Q ->
  passes pr P (rev Z ++ X) = false.
Proof.
  induction n as [|n IH]; intros X E Z L I; cbn [search] in E.
  - destruct Z; [|discriminate]. cbn. destruct (passes pr P X); [discriminate|reflexivity].
  - destruct Z as [|a Z]; [discriminate|]. cbn [rev]. rewrite <- app_assoc. cbn [app].
    assert (G : forall l, (fix tried (l : list spotted) : option (list spotted) := match l
      with [] => None
      | p :: l' => match search pr P n Q (p :: X) with Some Y => Some Y | None =>
          tried l' end end) l = None ->
      forall p, In p l -> search pr P n Q (p :: X) = None).
    { induction l as [|p l IHl]; intros E' q Iq; [destruct Iq|]. destruct Iq as [<-|Iq].
      - destruct (search pr P n Q (p :: X)); [discriminate|reflexivity].
      - destruct (search pr P n Q (p :: X)); [discriminate|]. now apply IHl. }
    apply IH; [apply (G Q E); apply I; now left|now injection L|]. intros x Hx. apply I. now right.
Qed.

(** ** All of it *)

Lemma steps_keep n : forall st X, In X (fst st) -> In X (fst (steps pr P n st)).
Proof.
  assert (One : forall st X, In X (fst st) -> In X (fst (step pr P st))).
  { intros st X I. unfold step. destruct (snd st) as [|Z q]; [assumption|].
    assert (G : forall l st, In X (fst st) -> In X (fst (fold_left added l st))).
    { induction l as [|Y l IHl]; intros st' I'; [assumption|]. cbn [fold_left]. apply IHl.
      unfold added.
      destruct (existsb _ _); [assumption|]. now right. }
    now apply G. }
  induction n as [n IH|n IH|]; intros st X I; cbn [steps]; destruct (snd st); auto.
Qed.
(** The steps suffice. *)
Lemma all_crossed X0 : one_of_T X0 -> incl X0 P -> exists found c,
  steps pr P (enough pr P) ([X0], [X0]) = (found, []) /\ so_far (found, []) c /\ In X0 found.
Proof.
  intros One0 I0. assert (Init : so_far ([X0], [X0]) 0).
  { constructor; cbn [fst snd]; auto using incl_refl.
    - now intros X [<-|[]].
    - repeat constructor. }
  destruct (steps_so_far (enough pr P) _ _ Init) as (c & H & O).
  pose proof (steps_keep (enough pr P) ([X0], [X0]) X0 (or_introl eq_refl)) as Keep.
  destruct (steps pr P (enough pr P) ([X0], [X0])) as [found open] eqn:St. cbn [fst snd] in O, Keep.
  assert (open = []) as ->; [|now exists found, c].
  destruct O as [O|O]; [assumption|]. exfalso. pose proof (not_more _ _ H) as L.
  pose proof (counted _ _ H) as K.
  cbn [fst snd] in *. unfold enough in O.
  rewrite power_spec, (dimension_d M), SuccNat2Pos.id_succ in O.
  assert (length P ^ S d < S (length P) ^ S d)%nat by (apply Nat.pow_lt_mono_l; lia). lia.
Qed.
(** With a simplex of T all of T is found. *)
Lemma all_of_T found c X0 : so_far (found, []) c -> In X0 found ->
  forall s, In s T -> exists s', In s' (map (fun X => places X) found) /\ same s s'.
Proof.
  intros H I0. pose proof (each_of_T _ _ H) as Each. cbn [fst] in Each.
  apply (all_reached positive Points T filled (fun s => exists s',
    In s' (map (fun X => places X) found) /\ same s s')).
  - destruct (Each X0 I0) as (_ & t & s & F & Is & Sm). exists s. split; [assumption|].
    exists (places X0). split; [now apply (in_map (fun X => places X))|].
    rewrite <- (framed_places X0 t F).
    destruct Sm. now split.
  - intros t u i j It Iu O (s' & Is' & Sm). apply in_map_iff in Is'. destruct Is' as (X & <- & IX).
    destruct (Each X IX) as (I & x & s & F & _ & _). rewrite <- (framed_places X x F) in Sm.
    destruct (opposite_elsewhere t x i u j Sm O) as (k & Ox).
    destruct (neighbour_listed X x u k j I F Iu Ox) as (Y & IY & OneY & SY).
    destruct (crossed _ _ H X IX) as [[]|Cr]. destruct (Cr Y IY) as (Z & IZ & SZ). cbn [fst] in IZ.
    exists (places Z). split; [now apply (in_map (fun X => places X))|].
    apply (same_vertices_spec Y Z) in SZ; [|apply OneY|now apply (Each Z)].
    destruct SY, SZ. split; eapply incl_tran; eassumption.
Qed.

Theorem wrapped_all Q : incl Q P -> incl P Q -> T <> [] -> exists found,
  wrapped pr P Q = Some (map (map fst) found) /\ (forall X, In X found -> one_of_T X) /\
  ForallOrdPairs (fun s t : simplex d => ~ same s t) (map (fun X => places X) found) /\
  same_simplices T (map (fun X => places X) found).
Proof.
  intros QP PQ NE. unfold wrapped. destruct (search pr P (S (dimension pr)) Q []) as [X0|] eqn:E.
  - destruct (search_some _ Q QP [] X0 ltac:(intros x []) E) as [I0 A0].
    pose proof (passes_spec X0 I0 A0) as One0.
    destruct (all_crossed X0 One0 I0) as (found & c & St & H & In0). rewrite St.
    exists found. split; [reflexivity|]. pose proof (each_of_T _ _ H) as Each. cbn [fst] in Each.
    split; [exact Each|]. split.
    + pose proof (found_once _ _ H) as Once. cbn [fst] in Once.
      clear - Once Each numbers_differ places_differ.
      induction Once as [|X l Fx Once IH]; cbn [map]; constructor.
      * apply Forall_forall. intros t It Sm. apply in_map_iff in It. destruct It as (Y & <- & IY).
        rewrite Forall_forall in Fx. specialize (Fx Y IY).
        apply (same_vertices_spec X Y) in Sm; [congruence|apply (Each X); now left|apply (Each Y);
          now right].
      * apply IH. intros Y IY. apply Each. now right.
    + split; [now apply (all_of_T found c X0)|].
      intros s' Is'. apply in_map_iff in Is'. destruct Is' as (X & <- & IX).
      destruct (Each X IX) as (_ & x & s & F & Is & Sm). exists s. split; [assumption|].
      now rewrite <- (framed_places X x F).
  - exfalso. destruct T as [|s l] eqn:ET; [contradiction|]. rewrite <- ET in *.
    destruct (T_passes s) as (X & IX & LX & A); [rewrite ET; now left|].
    assert (R : passes pr P (rev (rev X) ++ []) = false).
    { apply (search_none _ Q [] E (rev X)); [rewrite rev_length, (dimension_d M); assumption|].
      intros x Hx. apply PQ, IX. now apply in_rev. }
    rewrite rev_involutive, app_nil_r in R. congruence.
Qed.
End Whole.
