(** * Two certificates about one domain

    A domain without a mesh, and a mesh of it, stand in the same file: [same_domain] is extracted,
    and says that both describe the same domain, up to the order of its vertices. *)
From Coq Require Import Rbase Rfunctions List ZArith Bool.
From Circumspect Require Export DomainChecker GivenDomain.
From Circumspect Require Import Numbering Faces Accepted KeptMesh Combinations Solid.
From Circumspect Require Import Definitions Domains.
Import ListNotations.
Open Scope Z_scope.

(** The members of two lists of the same length, side by side. *)
Fixpoint side_by_side {A B} (f : A -> B -> bool) (l : list A) (l' : list B) : bool :=
  match l, l' with
  | [], [] => true
  | a :: r, b :: r' => f a b && side_by_side f r r'
  | _, _ => false
  end.
Definition same_kind (k k' : domain_kind) : bool :=
  match k, k' with Enclosed, Enclosed | Hull, Hull => true | _, _ => false end.
Definition place_is (p q : site) : bool := same_integers (coordinates p) (coordinates q).
Definition end_of (s : segment_entry) : positive := last (map reached (links s)) (from s).
Definition corners_listed (D : domain_certificate) : list site :=
  flat_map (fun pr => match snd pr with Corner _ => [position (fst pr)] | Steiner _ => [] end)
    (combine (points (whole_mesh D)) (roles (domain_part D))).
Definition all_listed (l l' : list site) : bool := forallb (fun p => existsb (place_is p) l') l.

Section Same.
Variables D D' : domain_certificate.
Variables S S' : Table.t site.
Definition same_spot (k k' : positive) : bool :=
  match Table.find k S, Table.find k' S' with Some p, Some q => place_is p q | _, _ => false end.
Definition same_ends (s s' : segment_entry) : bool :=
  same_spot (from s) (from s') && same_spot (end_of s) (end_of s').
Definition same_above (up up' : Table.t positive) (k k' : positive) : bool :=
  match Table.find k up, Table.find k' up' with Some i, Some i' => same_spot i i' | _,
    _ => false end.
Definition same_rim (up up' : Table.t positive) (s s' : segment_entry) : bool :=
  same_above up up' (from s) (from s') && same_above up up' (end_of s) (end_of s').
Definition same_seed (x y : site * Z) : bool := place_is (fst x) (fst y) && (snd x =? snd y).
Definition same_polygon (f f' : polygon_entry) : bool :=
  same_integers (normal f) (normal f') && (offset f =? offset f') &&
  side_by_side (same_rim (Table.of_list id (above f)) (Table.of_list id (above f')))
    (segments (plane_part f)) (segments (plane_part f')) &&
  side_by_side same_seed (seeds f) (seeds f').
Definition same_hole (h h' : hole_entry) : bool :=
  place_is (hole_point h) (hole_point h') && (hole_w h =? hole_w h').
Definition same_cells : bool :=
  same_kind (kind D) (kind D') && (numerator (whole_mesh D) =? numerator (whole_mesh D')) &&
  (denominator (whole_mesh D) =? denominator (whole_mesh D')) &&
  all_listed (corners_listed D) (corners_listed D') &&
    all_listed (corners_listed D') (corners_listed D) &&
  side_by_side same_ends (segments (domain_part D)) (segments (domain_part D')) &&
  side_by_side same_polygon (polygons D) (polygons D') &&
  side_by_side same_hole (holes (domain_part D)) (holes (domain_part D')).
End Same.
Definition same_domain (D D' : domain_certificate) : bool :=
  same_cells D D' (Table.of_list bare (points (whole_mesh D)))
    (Table.of_list bare (points (whole_mesh D'))).

(** ** What it means *)

Open Scope R_scope.
Section Domains.
Context {d : nat}.
Implicit Types (P : domain d).

(** The order of the vertices does not matter, nor how often they are listed. *)
Record same_but_for_order P P' : Prop := {
  same_filling : what_it_fills P = what_it_fills P';
  same_vertices : forall v, In v (domain_vertices P) <-> In v (domain_vertices P');
  same_segments : domain_segments P = domain_segments P';
  same_polygons : domain_polygons P = domain_polygons P';
  same_holes : domain_holes P = domain_holes P'
}.
Lemma same_region P P' q : same_but_for_order P P' -> region P q <-> region P' q.
Proof.
  intros [K V E F H]. destruct P as [k vs es fs hs], P' as [k' vs' es' fs' hs']. cbn in *.
  subst k' es' fs' hs'.
  unfold region. cbn. destruct k; [|apply conv_same; split; intros v I; now apply V].
  assert (W : walls_of (Domain Enclosed vs es fs hs) = walls_of (Domain Enclosed vs' es fs hs))
    by (unfold walls_of; destruct d as [|[|[|n]]]; reflexivity).
  now rewrite W.
Qed.
Lemma cell_of_same P P' X : same_but_for_order P P' -> In X (cells P) ->
  exists X', In X' (cells P') /\ forall q, X q <-> X' q.
Proof.
  intros Sa I. unfold cells in *. apply in_app_or in I. destruct I as [I|I].
  { exists X. split; [|tauto]. apply in_or_app. left. apply in_map_iff in I.
    destruct I as (v & <- & I).
    apply (in_map (fun v q => q = v)). now apply (same_vertices P P' Sa). }
  apply in_app_or in I. destruct I as [I|I].
  { exists X. split; [|tauto]. apply in_or_app. right. apply in_or_app. left.
    now rewrite <- (same_segments P P' Sa). }
  apply in_app_or in I. destruct I as [I|[<-|[]]].
  { exists X. split; [|tauto]. apply in_or_app. right. apply in_or_app. right. apply in_or_app.
    left. now rewrite <- (same_polygons P P' Sa). }
  exists (region P'). split; [|intros q; now apply same_region].
  apply in_or_app. right. apply in_or_app. right. apply in_or_app. right. now left.
Qed.
Lemma underlying_same P P' q : same_but_for_order P P' -> underlying P q -> underlying P' q.
Proof.
  intros Sa (X & I & Xq). destruct (cell_of_same P P' X Sa I) as (X' & I' & E). exists X'.
  split; [assumption|now apply E].
Qed.
Lemma same_back P P' : same_but_for_order P P' -> same_but_for_order P' P.
Proof. intros [K V E F H]. split; try (symmetry; assumption). intros v. symmetry. apply V. Qed.
Theorem solid_of_same P P' T : same_but_for_order P P' -> solid_triangulation P' T ->
  solid_triangulation P T.
Proof.
  intros Sa (Dt & Di & Cx & V & Ce & Un). split; [assumption|]. split; [assumption|].
  split; [assumption|]. split; [|split].
  - intros v I. apply V. now apply (same_vertices P P' Sa).
  - intros X I. destruct (cell_of_same P P' X Sa I) as (X' & I' & E).
    destruct (Ce X' I') as (F & HF & EF).
    exists F. split; [assumption|]. intros q. now rewrite E.
  - intros q. rewrite <- Un. split; apply underlying_same; [assumption|now apply same_back].
Qed.
End Domains.

Lemma side_by_side_map {A B C} (f : A -> B -> bool) (g : A -> C) (h : B -> C) l l' :
  (forall a b, f a b = true -> g a = h b) -> side_by_side f l l' = true -> map g l = map h l'.
Proof.
  intros E. revert l'. induction l as [|a l IH]; intros [|b l'] H; try discriminate; [reflexivity|].
  cbn in H. apply andb_prop in H. destruct H as [H1 H2]. cbn. now rewrite (E a b H1), (IH l' H2).
Qed.

Section Sound.
Context {d : nat}.
Variables D D' : domain_certificate.
Hypothesis same : same_domain D D' = true.
Notation c := (whole_mesh D).
Notation c' := (whole_mesh D').

Lemma place_is_place (r : R) p q : place_is p q = true -> @place_of d r p = place_of r q.
Proof. intros H. apply same_integers_spec in H. unfold place_of. now rewrite H. Qed.
Lemma parts_same : kind D = kind D' /\ unit_of c = unit_of c' /\
  all_listed (corners_listed D) (corners_listed D') = true /\
    all_listed (corners_listed D') (corners_listed D) = true.
Proof.
  pose proof same as H. unfold same_domain, same_cells in H. rewrite !andb_true_iff in H.
  destruct H as [[[[[[[K N] De] V] V'] _] _] _]. apply Z.eqb_eq in N, De.
  split; [now destruct (kind D), (kind D')|]. split; [unfold unit_of; now rewrite N, De|now split].
Qed.
Lemma lists_same :
  side_by_side (same_ends (Table.of_list bare (points c)) (Table.of_list bare (points c')))
    (segments (domain_part D)) (segments (domain_part D')) = true /\
  side_by_side (same_polygon (Table.of_list bare (points c)) (Table.of_list bare (points c')))
    (polygons D) (polygons D') = true /\
  side_by_side same_hole (holes (domain_part D)) (holes (domain_part D')) = true.
Proof.
  pose proof same as H. unfold same_domain, same_cells in H. rewrite !andb_true_iff in H. tauto.
Qed.
Lemma spot_same k k' : same_spot (Table.of_list bare (points c)) (Table.of_list bare (points c')) k
  k' = true ->
  spot d c k = spot d c' k'.
Proof.
  unfold same_spot. rewrite !table_find. destruct (numbered (points c) k) as [e|] eqn:E;
    [|discriminate].
  destruct (numbered (points c') k') as [e'|] eqn:E'; [|discriminate]. cbn [option_map]. intros H.
  rewrite (spot_numbered d c k e E), (spot_numbered d c' k' e' E'), (proj1 (proj2 parts_same)).
  now apply place_is_place.
Qed.
Lemma corners_in v : In v (part_vertices d c (domain_part D)) <->
  In v (map (place_of (unit_of c)) (corners_listed D)).
Proof.
  unfold part_vertices, corners_listed. rewrite in_map_iff. split.
  - intros I. apply in_flat_map in I. destruct I as (er & Ie & Iv).
    destruct (snd er) eqn:Er; [|destruct Iv].
    destruct Iv as [<-|[]]. exists (position (fst er)). split; [reflexivity|]. apply in_flat_map.
    exists er. rewrite Er. split; [assumption|now left].
  - intros (p & <- & I). apply in_flat_map in I. destruct I as (er & Ie & Iv).
    destruct (snd er) eqn:Er; [|destruct Iv].
    destruct Iv as [<-|[]]. apply in_flat_map. exists er. rewrite Er. split; [assumption|now left].
Qed.
End Sound.

Lemma all_listed_places {d} r l l' : all_listed l l' = true ->
  incl (map (@place_of d r) l) (map (place_of r) l').
Proof.
  intros H v I. apply in_map_iff in I. destruct I as (p & <- & I). unfold all_listed in H.
  rewrite forallb_forall in H.
  specialize (H p I). apply existsb_exists in H. destruct H as (q & Iq & E).
  rewrite (place_is_place r p q E). now apply in_map.
Qed.

Theorem same_domain_sound d D D' : same_domain D D' = true ->
  same_but_for_order (domain_of_certificate d D) (domain_of_certificate d D').
Proof.
  intros H. destruct (parts_same D D' H) as (K & U & V & V').
  destruct (lists_same D D' H) as (E & F & Ho).
  split; cbn [domain_of_certificate what_it_fills domain_vertices domain_segments domain_polygons
    domain_holes].
  - exact K.
  - intros v. rewrite (corners_in D v), (corners_in D' v), U.
    split; apply all_listed_places; assumption.
  - unfold part_segments. apply (side_by_side_map _ _ _ _ _) with (2 := E). intros s s' Es.
    unfold same_ends in Es.
    apply andb_prop in Es. destruct Es as [E1 E2]. unfold segment_ends.
    f_equal; now apply spot_same.
  - apply (side_by_side_map _ _ _ _ _) with (2 := F). intros f f' Ef. unfold same_polygon in Ef.
    rewrite !andb_true_iff in Ef.
    destruct Ef as [[[N O] R] Se]. apply same_integers_spec in N. apply Z.eqb_eq in O.
    unfold polygon_of. rewrite N, O, U. f_equal.
    + apply (side_by_side_map _ _ _ _ _) with (2 := R). intros s s' Es. unfold same_rim in Es.
      apply andb_prop in Es. destruct Es as [E1 E2].
      assert (Up : forall k k', same_above (Table.of_list bare (points (whole_mesh D)))
        (Table.of_list bare (points (whole_mesh D')))
        (Table.of_list id (above f)) (Table.of_list id (above f')) k k' = true ->
        match numbered (above f) k with Some j => spot d (whole_mesh D) j | None => origin end =
        match numbered (above f') k' with Some j => spot d (whole_mesh D') j | None => origin end).
      { intros k k' Hk. unfold same_above in Hk. rewrite !find_id in Hk.
        destruct (numbered (above f) k); [|discriminate].
        destruct (numbered (above f') k'); [|discriminate]. now apply spot_same. }
      f_equal; now apply Up.
    + apply (side_by_side_map _ _ _ _ _) with (2 := Se). intros x y Es. unfold same_seed in Es.
      apply andb_prop in Es. destruct Es as [E1 E2].
      apply Z.eqb_eq in E2. unfold seed_point. rewrite E2, U. now apply place_is_place.
  - unfold part_holes. apply (side_by_side_map _ _ _ _ _) with (2 := Ho). intros h h' Eh.
    unfold same_hole in Eh. apply andb_prop in Eh.
    destruct Eh as [E1 E2]. apply Z.eqb_eq in E2. unfold seed_point. rewrite E2, U.
    now apply place_is_place.
Qed.
