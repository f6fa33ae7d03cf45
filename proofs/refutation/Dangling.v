(** * What may dangle, as the checker of refutations finds it

    A mesh whose triangles and edges are made d-simplices has all simplices of the caller's among
    its faces ([fuller]); and a point in one of these is found to be in the part of it that is the
    caller's ([own_found]). *)
From Coq Require Import Rbase Rfunctions Lra Lia List Arith ZArith Bool.
From Circumspect Require Import DomainRefutation Numbering.
From Circumspect Require Import Definitions Domains DomainRules Vectors Affine Frame Faces
  LiftingMap Breach.
From Circumspect Require Import Orientation Integers RefutationSigns CallerMesh EvidenceSound
  RefutationSound.
Import ListNotations.
Open Scope R_scope.

(** ** Rules that hold of the caller's mesh if they hold of the fuller one *)

Section Fuller.
Context {d : nat}.
Implicit Types (P : domain d) (L : list (list (option (point d)))).
Definition fuller_than L' L : Prop := forall s : simplex d, listed L s -> exists t, listed L' t /\
  incl s t.
Variables (L' L : list (list (option (point d)))).
Hypothesis fuller : fuller_than L' L.

Lemma segment_missing_of_fuller P : segment_missing P L' -> segment_missing P L.
Proof.
  intros (a & b & q & I & C & N). exists a, b, q. split; [assumption|]. split; [assumption|].
  intros s f Ls If. destruct (fuller s Ls) as (t & Lt & St).
  apply (N t); [assumption|now apply incl_tran with s].
Qed.
Lemma polygon_not_tiled_of_fuller P : polygon_not_tiled P L' -> polygon_not_tiled P L.
Proof.
  intros (f & q & I & C & N). exists f, q. split; [assumption|]. split; [assumption|].
  intros s g Ls Ig. destruct (fuller s Ls) as (t & Lt & St).
  apply (N t); [assumption|now apply incl_tran with s].
Qed.
Lemma in_none_of_fuller q : (forall s, listed L' s -> ~ conv s q) -> forall s, listed L s ->
  ~ conv s q.
Proof.
  intros N s Ls C. destruct (fuller s Ls) as (t & Lt & St). apply (N t Lt). now apply (conv_incl s).
Qed.
End Fuller.

Lemma incl_firstn {A} n (l : list A) : incl (firstn n l) l.
Proof. intros a I. rewrite <- (firstn_skipn n l). apply in_or_app. now left. Qed.

Lemma appended_app {A} (l l' : list A) : appended l l' = l ++ l'.
Proof. unfold appended, rev'. now rewrite !rev_append_rev, app_nil_r, rev_involutive. Qed.
Lemma mapped_map {A B} (f : A -> B) l : mapped f l = map f l.
Proof.
  assert (G : forall made, mapped_onto f l made = rev (map f l) ++ made).
  { induction l as [|a l IH]; intros made; cbn [mapped_onto map rev]; [reflexivity|].
    now rewrite IH, <- app_assoc. }
  unfold mapped, rev'. now rewrite G, rev_append_rev, !app_nil_r, rev_involutive.
Qed.

(** ** Rows that are made full *)

Section Rows.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis M : forall r, 0 < r -> measured orient pr r.
Variables (m : refutation) (x : dangling_part).
Notation r := (refuted_unit m).
Hypothesis unit_positive : 0 < r.
Hypothesis delaunay : refuted m = Delaunay.
Hypothesis shaped_sites : forallb (shaped pr) (sites (padded m x)) = true.
Notation L := (@caller_rows d r (sites m) (rows m)).
Notation U := (@caller_rows d r (sites m) (map fst (dangling x))).
Notation entry := (@caller_entry d r (sites m)).
Notation entry' := (@caller_entry d r (sites m ++ pads x)).

Lemma listed_rows : @caller_rows d r (sites (as_listed m x)) (rows (as_listed m x)) = L ++ U.
Proof.
  unfold caller_rows. cbn [rows as_listed with_rows sites].
  now rewrite appended_app, mapped_map, map_app.
Qed.
Lemma padded_sites : sites (padded m x) = sites m ++ pads x.
Proof. apply appended_app. Qed.
Lemma entry_padded n p : entry n = Some p -> entry' n = Some p.
Proof.
  destruct n as [k|]; [|discriminate]. cbn. unfold numbered. intros E.
  rewrite nth_error_app1; [assumption|]. apply nth_error_Some. intros N. now rewrite N in E.
Qed.
Lemma entries_padded a : forall s, map entry a = map Some s -> map entry' a = map Some s.
Proof.
  induction a as [|n a IH]; intros [|p s] E; try discriminate; [reflexivity|]. cbn [map] in *.
  injection E as E1 E2.
  f_equal; [now apply entry_padded|now apply IH].
Qed.
Lemma known_entry S n : known_in (Table.of_list (site_for Delaunay) S) n = true ->
  exists p, @caller_entry d r S n = Some p.
Proof.
  unfold known_in. destruct n as [k|]; [|discriminate]. cbn. rewrite table_find.
  destruct (numbered S k) as [p|]; cbn; [intros _; now exists (place_of r p)|discriminate].
Qed.
Lemma known_entries S b : forallb (known_in (Table.of_list (site_for Delaunay) S)) b = true ->
  exists s, map (@caller_entry d r S) b = map Some s.
Proof.
  induction b as [|n b IH]; cbn [forallb]; intros H; [now exists []|]. apply andb_prop in H.
  destruct H as [H1 H2].
  destruct (known_entry S n H1) as (p & E). destruct (IH H2) as (s & Es). exists (p :: s). cbn.
  now rewrite E, Es.
Qed.

Lemma fuller : pads_known m x = true ->
  fuller_than (@caller_rows d r (sites (padded m x)) (rows (padded m x))) (L ++ U).
Proof.
  intros K s Ls. unfold listed in *. unfold caller_rows in *. rewrite padded_sites.
  cbn [padded with_rows rows].
  rewrite appended_app, mapped_map, map_app.
  apply in_app_or in Ls. destruct Ls as [I|I]; apply in_map_iff in I; destruct I as (a & E & I).
  - exists s. split; [|apply incl_refl]. apply in_or_app. left. rewrite <- (entries_padded a s E).
    now apply in_map.
  - apply in_map_iff in I. destruct I as ((a' & b) & Ea & I). cbn in Ea. subst a'.
    unfold pads_known in K. cbv zeta in K. rewrite forallb_forall in K. specialize (K _ I).
    cbn [snd] in K.
    destruct (known_entries _ b K) as (t & Et). exists (s ++ t).
    split; [|now apply incl_appl, incl_refl].
    apply in_or_app. right. rewrite map_app, <- (entries_padded a s E). rewrite padded_sites in Et.
    rewrite <- Et, <- map_app.
    apply (in_map (map entry')), (in_map (fun ab => fst ab ++ snd ab) _ (a, b)), I.
Qed.

(** ** What is the caller's of a full simplex *)

Notation S' := (Table.of_list (site_for Delaunay) (sites (padded m x))).
Notation framed := (framed orient pr r).
Notation places := (map (@place_of d r)).
Lemma padded_shaped : Forall (well_shaped d) (map (site_for Delaunay) (sites (padded m x))).
Proof.
  pose proof (RefutationSound.sites_shaped M (padded m x) unit_positive shaped_sites) as H.
  cbn in H. now rewrite delaunay in H.
Qed.
Lemma padded_found k : Table.find k S' = numbered (map (site_for Delaunay) (sites (padded m x))) k.
Proof. rewrite table_find. unfold numbered. now rewrite nth_error_map. Qed.
Lemma entry_site_for S n : @caller_entry d r (map (site_for Delaunay) S) n = caller_entry r S n.
Proof.
  destruct n as [k|]; [|reflexivity]. cbn. unfold numbered. rewrite nth_error_map.
  now destruct (nth_error S _).
Qed.

Lemma own_found_known t f : own_simplex_at m x pr t f = true -> exists X g n, framed X g /\
  listed (L ++ U) (places (firstn n X)) /\ f X n = true /\
    incl X (map (site_for Delaunay) (sites (padded m x))).
Proof.
  unfold own_simplex_at, own_at. rewrite table_find, appended_app, mapped_map. intros H.
  destruct (numbered _ t) as [(a, b)|] eqn:E; [|discriminate]. cbn [option_map Datatypes.id] in H.
  apply numbered_in in E.
  apply andb_prop in H. destruct H as [K H].
  destruct (proper_simplex_of pr S' (a ++ b)) as [X|] eqn:Px; [|discriminate].
  apply (proper_simplex_of_frame (M r unit_positive) _ (rows m) _ _ padded_shaped padded_found
    (rows_found m)) in Px.
  destruct Px as (Vx & g & G). exists X, g, (length a). split; [assumption|].
  split; [|split; [assumption|exact (vertices_known _ _ _ Vx)]].
  pose proof (vertices_rows _ _ X Vx) as Er.
  rewrite (map_ext _ _ (entry_site_for (sites (padded m x)))), padded_sites in Er.
  destruct (known_entries _ a K) as (s & Es). pose proof (entries_padded a s Es) as Es'.
  assert (Ef : s = places (firstn (length a) X)).
  { apply map_some_inj. rewrite <- Es'. apply (f_equal (firstn (length a))) in Er.
    rewrite map_app, firstn_app, map_length, Nat.sub_diag, firstn_O, app_nil_r in Er.
    rewrite firstn_all2 in Er by (now rewrite map_length). rewrite Er. now rewrite !firstn_map. }
  rewrite <- Ef. unfold listed. rewrite <- Es. unfold caller_rows. rewrite <- map_app.
  apply (in_map (map entry)).
  apply in_app_or in E. apply in_or_app. destruct E as [E|E].
  - left. apply in_map_iff in E. destruct E as (y & [= <- _] & I). exact I.
  - right. now apply (in_map fst _ (a, b)).
Qed.

Lemma own_found t f : own_simplex_at m x pr t f = true -> exists X g n, framed X g /\
  listed (L ++ U) (places (firstn n X)) /\ f X n = true.
Proof.
  intros H. apply own_found_known in H. destruct H as (X & g & n & G & LX & F & _).
  now exists X, g, n.
Qed.
Lemma in_own_conv X g n q w : framed X g -> well_shaped d q -> (0 < w)%Z ->
  in_own pr X n q w = true ->
  conv (places (firstn n X)) (place_over r q w).
Proof.
  intros G Sq Pw H. unfold in_own in H. apply andb_prop in H. destruct H as [I H].
  destruct (in_simplex_conv (M r unit_positive) X g G q w Sq Pw I) as [Ic _].
  apply (conv_incl (carrier g (place_over r q w))); [|now apply conv_carrier].
  intros v Iv. apply (carrier_of_carrier (M r unit_positive) X g G q w Sq Pw) in Iv.
  apply in_map_iff in Iv. destruct Iv as (p & <- & Ip).
  pose proof (carrier_of_incl (pr := pr) X q w p Ip) as IX.
  rewrite forallb_forall in H. specialize (H p Ip). apply existsb_exists in H.
  destruct H as (y & Iy & E).
  apply in_map_iff. exists y. split; [|assumption]. symmetry.
  pose proof (framed_shaped X g G) as Sh. rewrite Forall_forall in Sh.
  apply (same_place_place (M r unit_positive));
    [now apply Sh|apply Sh; now apply (incl_firstn n)|assumption].
Qed.

Lemma overlap_found t u q w : overlap_of_all m x pr t u q w = true -> overlap (L ++ U).
Proof.
  intros H. unfold overlap_of_all in H. apply own_found in H.
  destruct H as (X & g & i & G & LX & H).
  apply andb_prop in H. destruct H as [OX H]. apply own_found in H.
  destruct H as (Y & h & j & Fh & LY & H).
  apply andb_prop in H. destruct H as [OY O].
  assert (Wr : point_written pr q w = true).
  { unfold overlapping in O. rewrite !andb_true_iff in O. apply O. }
  apply (written (M r unit_positive)) in Wr. destruct Wr as [Sq Pw].
  exists (places (firstn i X)), (places (firstn j Y)), (place_over r q w). split; [assumption|].
  split; [assumption|].
  split; [now apply (in_own_conv X g)|]. split; [now apply (in_own_conv Y h)|].
  intros f Fx Fy. apply (meets_beyond (M r unit_positive) X Y g h q w G Fh O).
  - apply incl_tran with (1 := Fx). apply incl_map. intros p. apply (incl_firstn i).
  - apply incl_tran with (1 := Fy). apply incl_map. intros p. apply (incl_firstn j).
Qed.
End Rows.
