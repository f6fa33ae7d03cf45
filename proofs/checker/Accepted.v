(** * What an accepted certificate says

    Acceptance is taken apart: each condition of [Checker.v] is turned into a statement about the
    points, simplices and hull facets of the certificate.  Geometry begins in [Soundness.v]. *)
From Coq Require Import Rbase Rfunctions Lra Lia List ZArith Bool Sorting.Sorted.
From Circumspect Require Import Checker Numbering.
From Circumspect Require Import Definitions Orientation Integers.
Import ListNotations.
Open Scope R_scope.

(** Take hypotheses [... = Accepted] apart. *)
Ltac accepted := repeat match goal with
  | H : (if ?b then _ else _) = Accepted |- _ => destruct b eqn:?; [|discriminate H]
  | H : match ?x with _ => _ end = Accepted |- _ => destruct x eqn:?; try discriminate H
  end.
Ltac booleans := repeat match goal with
  | H : _ && _ = true |- _ => apply andb_prop in H; destruct H
  | H : Pos.eqb _ _ = true |- _ => apply Pos.eqb_eq in H
  | H : Nat.eqb _ _ = true |- _ => apply Nat.eqb_eq in H
  end.

(** ** The points of a certificate *)

Section Points.
Variables (d : nat) (c : certificate).
Notation unit_of := (unit_of c).
Notation points_of_certificate := (points_of_certificate d c).
Notation spot := (spot d c).

(** The site with number [k]. *)
Definition site_at (k : positive) : site :=
  match numbered (points c) k with
  | Some e => site_of (claimed c) e
  | None => Site (repeat 0%Z d) 0
  end.

Lemma spot_numbered k e : numbered (points c) k = Some e ->
  spot k = place_of unit_of (position e).
Proof.
  unfold numbered, Definitions.spot, Definitions.points_of_certificate. intros E.
  apply (map_nth_error (fun e => @place_of d unit_of (position e))) in E.
  now apply nth_error_nth.
Qed.
Lemma spot_in k e : numbered (points c) k = Some e -> In (spot k) points_of_certificate.
Proof.
  intros E. rewrite (spot_numbered k e E). apply in_map_iff. exists e.
  split; [reflexivity|]. now apply numbered_in with k.
Qed.
Lemma in_points p : In p points_of_certificate -> exists k e, numbered (points c) k = Some e /\
  p = place_of unit_of (position e).
Proof.
  intros I. apply in_map_iff in I. destruct I as (e & <- & I). apply in_numbered in I.
  destruct I as (k & E). eauto.
Qed.
Lemma coordinates_site_of cl e : coordinates (site_of cl e) = coordinates (position e).
Proof. unfold site_of. now destruct (weights_of cl). Qed.
Lemma place_site_of (r : R) cl e : @place_of d r (site_of cl e) = place_of r (position e).
Proof. unfold place_of. now rewrite coordinates_site_of. Qed.
Lemma spot_site k e : numbered (points c) k = Some e -> spot k = place_of unit_of (site_at k).
Proof.
  intros E. rewrite (spot_numbered k e E). unfold site_at. rewrite E. symmetry.
  apply place_site_of.
Qed.
End Points.

(** ** The conditions *)

Section Accepted.
Context {d : nat} {pr : predicates} {c : certificate}.
Hypothesis dimension_d : dimension pr = d.
Hypothesis accepts : check_in pr c = Accepted.
Notation m := (mesh_of c).

Lemma find_point k : Table.find k (points_of m) =
  option_map (site_of (claimed c)) (numbered (points c) k).
Proof. apply table_find. Qed.
Lemma find_simplex k : Table.find k (simplices_of m) = numbered (simplices c) k.
Proof. cbn. rewrite table_find. now destruct (numbered (simplices c) k). Qed.
Lemma find_hull k : Table.find k (hull_of m) = numbered (hull c) k.
Proof. cbn. rewrite table_find. now destruct (numbered (hull c) k). Qed.

Lemma find_point_site k p : Table.find k (points_of m) = Some p ->
  site_at d c k = p /\ exists e, numbered (points c) k = Some e.
Proof.
  rewrite find_point. unfold site_at. destruct (numbered (points c) k) as [e|]; [|discriminate].
  intros E. cbn in E. injection E as <-. eauto.
Qed.
Lemma find_all_sites l X : find_all (points_of m) l = Some X ->
  X = map (site_at d c) l /\ forall k, In k l -> exists e, numbered (points c) k = Some e.
Proof.
  revert X. induction l as [|k l IH]; intros X E; cbn [find_all] in E.
  - injection E as <-. split; [reflexivity|intros k []].
  - destruct (Table.find k (points_of m)) as [p|] eqn:F; [|discriminate].
    destruct (find_all (points_of m) l) as [Y|]; [|discriminate]. injection E as <-.
    apply find_point_site in F. destruct F as [<- Ex].
    destruct (IH Y eq_refl) as [-> All]. split; [reflexivity|].
    intros j [<-|I]; auto.
Qed.

Lemma check_parts : scaled c = true /\ check_points pr (points c) = Accepted /\
  each (check_point pr m) 1 (points c) = Accepted /\ inside_sample pr m = true /\
  each (check_simplex pr m) 1 (simplices c) = Accepted /\
  each (check_hull pr m) 1 (hull c) = Accepted.
Proof. pose proof accepts as H. unfold check_in in H. cbv zeta in H. accepted. auto 10. Qed.

(** [scale] *)
Lemma unit_positive : 0 < unit_of c.
Proof.
  destruct check_parts as (H & _). unfold scaled in H. booleans.
  apply Z.ltb_lt in H, H0. apply IZR_lt in H, H0. unfold unit_of. now apply Rdiv_lt_0_compat.
Qed.

(** [points-increasing] *)
Lemma lexicographic_first (p q : list Z) : lexicographic p q = true -> p <> q /\
  forall r, lexicographic q r = true -> lexicographic p r = true.
Proof.
  revert q. induction p as [|x p IH]; intros [|y q] H; try discriminate. cbn in H.
  apply orb_prop in H. destruct H as [H|H]; booleans.
  - apply Z.ltb_lt in H. split; [intros E; injection E; lia|]. intros [|z r] R; [discriminate|].
    cbn in *. apply orb_prop in R. apply orb_true_intro. left. apply Z.ltb_lt.
    destruct R as [R|R]; [apply Z.ltb_lt in R; lia|]. booleans. apply Z.eqb_eq in H0. lia.
  - apply Z.eqb_eq in H. subst y. destruct (IH q H0) as [N T]. split; [congruence|].
    intros [|z r] R; [discriminate|]. cbn in *. apply orb_prop in R. apply orb_true_intro.
    destruct R as [R|R]; [now left|]. booleans. right. rewrite (T r H1), H. reflexivity.
Qed.

Lemma increase_spec l : forall k p, points_increase pr k p l = Accepted ->
  Forall (fun e => well_shaped d (position e) /\
    lexicographic (coordinates p) (coordinates (position e)) = true) l /\
  NoDup (map (fun e => coordinates (position e)) l).
Proof.
  induction l as [|e l IH]; intros k p H; cbn [points_increase] in H.
  - split; constructor.
  - accepted. booleans. apply IH in H. destruct H as [F N].
    unfold shaped in H0. unfold increasing in H1. booleans. rewrite dimension_d in H0.
    pose proof (lexicographic_first _ _ H1) as [_ T]. split.
    + constructor; [now split|]. eapply Forall_impl; [|exact F]. cbn. intros e' [A B]. auto.
    + cbn. constructor; [|assumption]. intros I. apply in_map_iff in I.
      destruct I as (e' & E & I). rewrite Forall_forall in F. destruct (F e' I) as [_ B].
      apply lexicographic_first in B. destruct B as [B _]. congruence.
Qed.
Lemma checked_points l : check_points pr l = Accepted ->
  Forall (fun e => well_shaped d (position e)) l /\
    NoDup (map (fun e => coordinates (position e)) l).
Proof.
  clear accepts. intros H. unfold check_points in H.
  destruct l as [|e l]; [split; constructor|]. accepted.
  apply increase_spec in H. destruct H as [F N]. unfold shaped in Heqb. booleans.
  rewrite dimension_d in Heqb. split.
  - constructor; [assumption|]. eapply Forall_impl; [|exact F]. cbn. tauto.
  - cbn. constructor; [|assumption]. intros I. apply in_map_iff in I.
    destruct I as (e' & E & I). rewrite Forall_forall in F. destruct (F e' I) as [_ B].
    apply lexicographic_first in B. destruct B as [B _]. congruence.
Qed.
Lemma points_shaped_distinct : Forall (fun e => well_shaped d (position e)) (points c) /\
  NoDup (map (fun e => coordinates (position e)) (points c)).
Proof. apply checked_points. now destruct check_parts as (_ & H & _). Qed.
Lemma site_shaped k : well_shaped d (site_at d c k).
Proof.
  unfold site_at. destruct (numbered (points c) k) as [e|] eqn:E.
  - unfold well_shaped. rewrite coordinates_site_of. apply numbered_in in E.
    destruct points_shaped_distinct as [F _]. rewrite Forall_forall in F. now apply F.
  - apply repeat_length.
Qed.
Lemma sites_shaped l : Forall (well_shaped d) (map (site_at d c) l).
Proof. apply Forall_forall. intros s I. apply in_map_iff in I. destruct I as (k & <- & _).
  apply site_shaped. Qed.

(** [vertex-known], [simplex-positive], [sample-outside]; and every wall is looked at. *)
Definition sites_of (e : simplex_entry) : list site := map (site_at d c) (corners e).

Lemma simplex_accepted t e : numbered (simplices c) t = Some e ->
  (forall k, In k (corners e) -> exists p, numbered (points c) k = Some p) /\
  (0 < orientation pr (sites_of e))%Z /\
  length (walls e) = S d /\
  (t <> sample_simplex c -> exists i,
     (side pr i (sites_of e) (sample c) (sample_denominator c) < 0)%Z) /\
  forall i f, nth_error (walls e) i = Some f -> check_wall pr m t (corners e) (sites_of e)
    (if delaunay_of (claimed c) then slope pr (sites_of e) else []) i f = Accepted.
Proof.
  intros E. destruct check_parts as (_ & _ & _ & _ & H & _).
  apply (each_accepted _ _ H) in E. unfold check_simplex in E. cbv zeta in E. accepted.
  apply find_all_sites in Heqo. destruct Heqo as [-> Known].
  fold (sites_of e) in *.
  unfold positive_simplex in *. booleans. apply Z.ltb_lt in Heqb.
  split; [assumption|]. split; [assumption|]. split; [congruence|]. split.
  - intros N. unfold outside_sample in *.
    match goal with H : _ || _ = true |- _ => apply orb_prop in H; destruct H as [K|K] end.
    + booleans. now destruct N.
    + destruct (away e) as [i|]; [|discriminate]. apply Z.ltb_lt in K. now exists i.
  - intros i f Ef. now apply (each_index_accepted _ _ E).
Qed.

(** What the wall of a simplex is. *)
Lemma neighbour_accepted t e i u j : numbered (simplices c) t = Some e ->
  nth_error (walls e) i = Some (Neighbour u j) ->
  exists e', numbered (simplices c) u = Some e' /\
    matched_facet (corners e) (corners e') i j = true /\
    nth_error (walls e') j = Some (Neighbour t i) /\
    (delaunay_of (claimed c) = true -> (t < u)%positive -> forall v,
       nth_error (corners e') j = Some v ->
       (depth pr (sites_of e) (slope pr (sites_of e)) (site_at d c v) <= 0)%Z).
Proof.
  intros Et Ew. destruct (simplex_accepted t e Et) as (_ & _ & _ & _ & W).
  specialize (W i _ Ew). cbn [check_wall] in W.
  rewrite find_simplex in W. destruct (numbered (simplices c) u) as [e'|]; [|discriminate].
  exists e'. split; [reflexivity|].
  destruct (matched_facet (corners e) (corners e') i j); [|discriminate].
  destruct (points_back t i e' j) eqn:B; [|discriminate]. split; [reflexivity|]. split.
  - unfold points_back in B. destruct (nth_error (walls e') j) as [[t' i'|h]|]; try discriminate.
    booleans. now subst.
  - intros D Lt v Ev. change (delaunay_claimed m) with (delaunay_of (claimed c)) in W.
    rewrite D in W. apply Pos.ltb_lt in Lt. rewrite Lt in W. cbn [andb] in W.
    rewrite Ev in W. accepted. apply find_point_site in Heqo. destruct Heqo as [-> _].
    now apply Z.leb_le.
Qed.
Lemma hull_wall_accepted t e i h : numbered (simplices c) t = Some e ->
  nth_error (walls e) i = Some (OnHull h) ->
  exists f, numbered (hull c) h = Some f /\ carrier f = t /\ apex f = i.
Proof.
  intros Et Ew. destruct (simplex_accepted t e Et) as (_ & _ & _ & _ & W).
  specialize (W i _ Ew). cbn [check_wall] in W. accepted. unfold names_hull in Heqb.
  rewrite find_hull in Heqb. destruct (numbered (hull c) h) as [f|]; [|discriminate].
  booleans. eauto.
Qed.

(** [hull-pointer], [sample-inside-hull]; and every ridge is looked at. *)
Lemma hull_accepted h f : numbered (hull c) h = Some f ->
  exists e, numbered (simplices c) (carrier f) = Some e /\
    nth_error (walls e) (apex f) = Some (OnHull h) /\
    (0 < side pr (apex f) (sites_of e) (sample c) (sample_denominator c))%Z /\
    length (ridges f) = d /\
    forall a r, nth_error (ridges f) a = Some r ->
      check_ridge pr m h (apex f) (remove (apex f) (corners e)) (sites_of e) a r = Accepted.
Proof.
  intros E. destruct check_parts as (_ & _ & _ & _ & _ & H).
  apply (each_accepted _ _ H) in E. unfold check_hull in E. rewrite find_simplex in E.
  destruct (numbered (simplices c) (carrier f)) as [e|]; [|discriminate].
  exists e. split; [reflexivity|]. accepted.
  apply find_all_sites in Heqo. destruct Heqo as [-> _]. fold (sites_of e) in *.
  unfold named_by_facet in *. unfold inside_hull_facet in *. split.
  - destruct (nth_error (walls e) (apex f)) as [[|h']|]; try discriminate. booleans. now subst.
  - split; [now apply Z.ltb_lt|]. booleans. split; [congruence|].
    intros a r Er. now apply (each_index_accepted _ _ E).
Qed.

(** [ridge-matched], [ridge-back-pointer], [hull-locally-convex] *)
Lemma ridge_accepted h f e a g b : numbered (hull c) h = Some f ->
  numbered (simplices c) (carrier f) = Some e -> nth_error (ridges f) a = Some (g, b) ->
  exists f' e', numbered (hull c) g = Some f' /\ numbered (simplices c) (carrier f') = Some e' /\
    matched_ridge (remove (apex f) (corners e)) (remove (apex f') (corners e'))
      (apex f) (apex f') a b = true /\
    nth_error (ridges f') b = Some (h, a) /\
    forall v, nth_error (remove (apex f') (corners e')) b = Some v ->
      (0 <= side pr (apex f) (sites_of e) (site_at d c v) 1)%Z.
Proof.
  intros Ef Ee Er. destruct (hull_accepted h f Ef) as (e0 & E0 & _ & _ & _ & R).
  rewrite Ee in E0. injection E0 as <-. specialize (R a _ Er). unfold check_ridge in R.
  rewrite find_hull in R. destruct (numbered (hull c) g) as [f'|]; [|discriminate].
  rewrite find_simplex in R.
  destruct (numbered (simplices c) (carrier f')) as [e'|] eqn:E'; [|discriminate].
  exists f', e'. split; [reflexivity|]. split; [exact E'|]. cbv zeta in R. accepted.
  split; [reflexivity|]. split.
  - unfold ridge_points_back in *. destruct (nth_error (ridges f') b) as [[h' a']|];
      [|discriminate]. booleans. now subst.
  - intros v' Ev. injection Ev as <-. apply find_point_site in Heqo0. destruct Heqo0 as [-> _].
    unfold Checker.locally_convex in *. now apply Z.leb_le.
Qed.

(** [sample-inside] *)
Lemma sample_accepted : exists e, numbered (simplices c) (sample_simplex c) = Some e /\
  well_shaped d (sample c) /\ (0 < sample_denominator c)%Z /\
  forall i, (i <= d)%nat -> (0 < side pr i (sites_of e) (sample c) (sample_denominator c))%Z.
Proof.
  destruct check_parts as (_ & _ & _ & H & _). unfold inside_sample in H.
  rewrite find_simplex in H. cbn [start sample_of sample_w mesh_of] in H.
  apply andb_prop in H. destruct H as [H K]. apply andb_prop in H. destruct H as [Sh W].
  unfold shaped in Sh. booleans. rewrite dimension_d in Sh. apply Z.ltb_lt in W.
  destruct (numbered (simplices c) (sample_simplex c)) as [e|]; [|discriminate].
  exists e. repeat (split; [auto|]).
  destruct (find_all (points_of m) (corners e)) as [X|] eqn:F; [|discriminate].
  apply find_all_sites in F. destruct F as [-> _]. fold (sites_of e) in K.
  rewrite dimension_d in K.
  assert (G : forall n, in_open pr m n (sites_of e) = true -> forall i, (i < n)%nat ->
    (0 < side pr i (sites_of e) (sample c) (sample_denominator c))%Z).
  { induction n as [|n IH]; intros Q i Hi; [lia|]. cbn [in_open] in Q. booleans.
    apply Z.ltb_lt in H. destruct (Nat.eq_dec i n) as [->|N]; [exact H|apply IH; auto; lia]. }
  intros i Hi. apply (G _ K). lia.
Qed.

(** [point-used] *)
Lemma point_accepted k p : numbered (points c) k = Some p ->
  exists e, numbered (simplices c) (home p) = Some e /\
    (In k (corners e) \/
     (weights_of (claimed c) = true /\
      (forall i, (i <= d)%nat -> (0 <= side pr i (sites_of e) (position p) 1)%Z) /\
      (depth pr (sites_of e) (slope pr (sites_of e)) (position p) <= 0)%Z)).
Proof.
  intros E. destruct check_parts as (_ & _ & H & _).
  apply (each_accepted _ _ H) in E. unfold check_point in E. accepted. unfold used in Heqb.
  rewrite find_simplex in Heqb.
  destruct (numbered (simplices c) (home p)) as [e|]; [|discriminate].
  exists e. split; [reflexivity|]. destruct (home_vertex p) as [i|].
  - left. destruct (nth_error (corners e) i) as [v|] eqn:N; [|discriminate]. booleans. subst v.
    now apply nth_error_In with i.
  - right. apply andb_prop in Heqb. destruct Heqb as [W Q]. split; [exact W|].
    destruct (find_all (points_of m) (corners e)) as [X|] eqn:F; [|discriminate].
    apply find_all_sites in F. destruct F as [-> _]. fold (sites_of e) in Q.
    apply andb_prop in Q. destruct Q as [Q D]. rewrite dimension_d in Q.
    split; [|now apply Z.leb_le].
    assert (G : forall n, in_closed pr n (sites_of e) (position p) = true ->
      forall i, (i < n)%nat -> (0 <= side pr i (sites_of e) (position p) 1)%Z).
    { induction n as [|n IH]; intros R i Hi; [lia|]. cbn [in_closed] in R. booleans.
      apply Z.leb_le in H0. destruct (Nat.eq_dec i n) as [->|N]; [exact H0|apply IH; auto; lia]. }
    intros i Hi. apply (G _ Q). lia.
Qed.
End Accepted.
