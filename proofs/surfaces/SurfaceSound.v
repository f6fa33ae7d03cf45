(** * Soundness: an accepted certificate of a surface is about triangles that are intrinsically
    Delaunay *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Bool.
From Circumspect Require Import SurfaceChecker Numbering.
From Circumspect Require Import Definitions Vectors Faces Orientation Integers Accepted Soundness.
From Circumspect Require Import Angles EdgesInOrder.
From Circumspect Require Line.
Import ListNotations.
Open Scope R_scope.

(** ** The theorem, for either dimension *)

Section Sound.
Context {d : nat} {pr : predicates}.
Hypothesis dim_d : dimension pr = d.
Variable c : surface_certificate.
Hypothesis accepts : check_surface_in pr c = Accepted.
Notation bare := (bare_surface c).
Notation r := (unit_of bare).
Notation spot := (spot d bare).
Notation P := (points_of_certificate d bare).
Notation T := (simplices_of_certificate d bare).
Notation points_table := (Table.of_list position (surface_points c)).
Notation triangle t := (numbered (surface_triangles c) t).
Notation edge_at k := (numbered (surface_edges c) k).
Notation edge_number := (edge_number c).

Lemma surface_parts : 0 < r /\ check_points pr (surface_points c) = Accepted /\
  surface_triangles c <> [] /\ each (check_triangle c) 1 (surface_triangles c) = Accepted /\
  each (check_edge c) 1 (surface_edges c) = Accepted.
Proof.
  pose proof accepts as H. unfold check_surface_in in H. accepted. booleans.
  apply Z.ltb_lt in H0, H1. apply IZR_lt in H0, H1. split.
  { unfold unit_of. cbn. now apply Rdiv_lt_0_compat. }
  repeat (split; [reflexivity || assumption|]). split; [intros N; rewrite N in *; discriminate|].
  auto.
Qed.
Notation unit_positive := (proj1 surface_parts).

(** ** Points *)

Lemma surface_points_once : Forall (fun e => well_shaped d (position e)) (surface_points c) /\
  NoDup P.
Proof.
  pose proof surface_parts as (U & H & _). apply (checked_points dim_d) in H. destruct H as [F N].
  split; [assumption|]. unfold points_of_certificate. cbn. change (unit_of _) with r.
  revert F N. generalize (surface_points c). clear - U.
  induction l as [|e l IH]; intros F N; cbn in *; constructor; inversion_clear F; inversion_clear N;
    auto.
  intros I. apply in_map_iff in I. destruct I as (e' & E & I). apply H1. apply in_map_iff.
  exists e'. split; [|assumption]. rewrite Forall_forall in H0. apply (@place_inj d r); auto; lra.
Qed.

Definition known (k : positive) (s : site) : Prop := Table.find k points_table = Some s.
Lemma known_place k s : known k s -> spot k = place_of r s /\ well_shaped d s /\ In (spot k) P.
Proof.
  unfold known. rewrite table_find.
  destruct (numbered (surface_points c) k) as [e|] eqn:E; [|discriminate].
  intros H. injection H as <-. split; [now apply spot_numbered|].
  split; [|now apply spot_in with e].
  destruct surface_points_once as [F _]. rewrite Forall_forall in F. apply F.
  now apply numbered_in with k.
Qed.
Lemma known_inj k s l t : known k s -> known l t -> spot k = spot l -> k = l.
Proof.
  unfold known. rewrite !table_find.
  destruct (numbered (surface_points c) k) as [e|] eqn:E; [|discriminate].
  destruct (numbered (surface_points c) l) as [f|] eqn:F; [|discriminate]. intros _ _ S.
  assert (G : forall n g, numbered (surface_points c) n = Some g ->
    nth_error P (pred (Pos.to_nat n)) = Some (spot n)).
  { intros n g N. rewrite (spot_numbered d bare n g N). unfold points_of_certificate.
    exact (map_nth_error _ _ _ N). }
  assert (Eq : pred (Pos.to_nat k) = pred (Pos.to_nat l)); [|lia].
  apply (proj1 (NoDup_nth_error P) (proj2 surface_points_once)).
  - apply nth_error_Some. rewrite (G k e E). discriminate.
  - now rewrite (G k e E), (G l f F), S.
Qed.
Lemma find_all_known l : forall X, find_all points_table l = Some X -> Forall2 known l X.
Proof.
  induction l as [|k l IH]; intros X E; cbn [find_all] in E.
  - injection E as <-. constructor.
  - destruct (Table.find k points_table) as [s|] eqn:K; [|discriminate].
    destruct (find_all points_table l) as [Y|]; [|discriminate]. injection E as <-.
    constructor; auto.
Qed.

(** ** Triangles *)

(** The vertices are points that are on no line. *)
Definition triangle_is (e : triangle_entry) : Prop :=
  exists X, Forall2 known (triangle_vertices e) X /\ on_no_line X = true.
Lemma known_shaped K X : Forall2 known K X -> Forall (well_shaped d) X /\
  map spot K = map (place_of r) X /\ incl (map spot K) P.
Proof.
  induction 1 as [|k s K X Ks F (Sh & E & I)]; [repeat split; [constructor|intros p []]|].
  destruct (known_place k s Ks) as (Es & Ws & Is). split; [now constructor|].
  split; [cbn [map]; now rewrite Es, E|]. intros p [<-|Ip]; auto.
Qed.
Lemma triangle_proper e : triangle_is e -> length (triangle_vertices e) = 3%nat /\
  incl (map spot (triangle_vertices e)) P /\
  affinely_independent (map spot (triangle_vertices e)) /\ NoDup (triangle_vertices e).
Proof.
  intros (X & F & L). destruct (known_shaped _ _ F) as (W & E & I).
  apply (on_no_line_independent r unit_positive X W) in L. destruct L as [Le In_].
  split.
  { apply (f_equal (@length _)) in E. rewrite !map_length in E. congruence. }
  split; [assumption|].
  split; [now rewrite E|]. apply (NoDup_map_inv spot). rewrite E. now apply independent_NoDup.
Qed.
Lemma triangle_accepted t e : triangle t = Some e -> triangle_is e /\
  forall i, (i < 3)%nat -> exists k, edge_at k = Some (t, i).
Proof.
  intros E. pose proof surface_parts as (_ & _ & _ & H & _). apply (each_accepted _ _ H) in E.
  unfold check_triangle in E. cbv zeta in E. accepted. split.
  - apply find_all_known in Heqo. now exists l.
  - intros i Hi. rewrite forallb_forall in Heqb0.
    assert (S : edge_stands c t e i = true) by (apply Heqb0, (in_seq 3 0); lia).
    unfold edge_stands in S. destruct (nth_error (triangle_edges e) i) as [k|]; [|discriminate].
    destruct (Table.find k _) as [[u j]|] eqn:F; [|discriminate]. booleans. subst u j. exists k.
    rewrite table_find in F. destruct (edge_at k) as [[u j]|]; [|discriminate]. exact F.
Qed.
Lemma edge_number_split k x : edge_number k = Some x -> exists t e i o p q,
  edge_at k = Some (t, i) /\ triangle t = Some e /\
  split3 i (triangle_vertices e) = Some (o, p, q) /\ x = edge_between p q o.
Proof.
  unfold SurfaceChecker.edge_number. rewrite table_find.
  destruct (edge_at k) as [[t i]|]; [|discriminate]. cbn. rewrite table_find.
  destruct (triangle t) as [e|] eqn:E; [|discriminate]. cbn.
  destruct (split3 i _) as [[[o p] q]|] eqn:S; [|discriminate]. intros X. injection X as <-.
  exists t, e, i, o, p, q. auto.
Qed.
Lemma edge_of_triangle t e i o p q : triangle t = Some e ->
  split3 i (triangle_vertices e) = Some (o, p, q) ->
  exists k, edge_at k = Some (t, i) /\ edge_number k = Some (edge_between p q o).
Proof.
  intros E S. destruct (triangle_accepted t e E) as [_ K].
  destruct (split3_three _ _ _ _ _ S) as (_ & Hi & _). destruct (K i Hi) as (k & Ek).
  exists k. split; [assumption|]. unfold SurfaceChecker.edge_number.
  rewrite table_find, Ek. cbn [option_map id]. rewrite table_find, E. cbn [option_map id].
  unfold id. now rewrite S.
Qed.

(** ** What stands side by side *)

Lemma edges_ordered l : forall k x y, (k < l)%positive -> edge_number k = Some x ->
  edge_number l = Some y -> edge_before x y = true.
Proof.
  pose proof surface_parts as (_ & _ & _ & _ & H).
  assert (Next : forall k x y, edge_number k = Some x -> edge_number (Pos.succ k) = Some y ->
    edge_before x y = true).
  { intros k x y Ex Ey. destruct (edge_number_split k x Ex) as (t & e & i & o & p & q & Ek & _).
    pose proof (each_accepted _ _ H k _ Ek) as Ak. unfold check_edge in Ak.
    rewrite Ex, Ey in Ak. now accepted. }
  induction l as [|l IH] using Pos.peano_ind; intros k x y L Ex Ey; [lia|].
  destruct (Pos.eq_dec k l) as [->|N]; [eauto|].
  destruct (edge_number_split _ _ Ey) as (t & e & i & o & p & q & El & _).
  assert (exists ti, edge_at l = Some ti) as (ti & E).
  { destruct (edge_at l) as [ti|] eqn:E; [eauto|]. exfalso. unfold numbered in E, El.
    apply nth_error_None in E. assert (nth_error (surface_edges c) (pred (Pos.to_nat (Pos.succ l)))
      <> None) as B by congruence. apply nth_error_Some in B. lia. }
  pose proof (each_accepted _ _ H l _ E) as Al. unfold check_edge in Al.
  destruct (edge_number l) as [z|] eqn:Ez; [|discriminate].
  apply (edge_before_trans x z y); [|eauto]. apply (IH k x z); [lia|assumption|reflexivity].
Qed.
Lemma edge_once k l x : edge_number k = Some x -> edge_number l = Some x -> k = l.
Proof.
  intros Ek El. destruct (Pos.lt_total k l) as [L|[L|L]]; [|assumption|];
    [pose proof (edges_ordered l k x x L Ek El) as B|
     pose proof (edges_ordered k l x x L El Ek) as B];
    rewrite edge_before_itself in B; discriminate.
Qed.
Lemma two_in_order k l x y : edge_number k = Some x -> edge_number l = Some y ->
  same_edge x y = true -> (k < l)%positive ->
  (forall m z, edge_number m = Some z -> same_edge z x = true -> m = k \/ m = l) ->
  narrow c x y = true.
Proof.
  intros Ex Ey Sm L Two. pose proof surface_parts as (_ & _ & _ & _ & H).
  destruct (edge_number_split k x Ex) as (t & e & i & o & p & q & Ek & _).
  pose proof (each_accepted _ _ H k _ Ek) as Ak. unfold check_edge in Ak. rewrite Ex in Ak.
  assert (l = Pos.succ k) as ->.
  { destruct (Pos.eq_dec l (Pos.succ k)) as [|N]; [assumption|]. exfalso.
    destruct (edge_number (Pos.succ k)) as [z|] eqn:Ez.
    - assert (Sz : same_edge z x = true).
      { apply (edge_before_trans x z y); [| |assumption].
        - apply (edges_ordered (Pos.succ k) k); [lia|assumption|assumption].
        - apply (edges_ordered l (Pos.succ k)); [lia|assumption|assumption]. }
      destruct (Two _ _ Ez Sz); lia.
    - destruct (edge_number_split l y Ey) as (t' & e' & i' & o' & p' & q' & El & _).
      assert (exists ti, edge_at (Pos.succ k) = Some ti) as (ti & E).
      { destruct (edge_at (Pos.succ k)) as [ti|] eqn:E; [eauto|]. exfalso. unfold numbered in E, El.
        apply nth_error_None in E. assert (nth_error (surface_edges c) (pred (Pos.to_nat l))
          <> None) as B by congruence. apply nth_error_Some in B. lia. }
      pose proof (each_accepted _ _ H _ _ E) as As. unfold check_edge in As. rewrite Ez in As.
      discriminate. }
  rewrite Ey in Ak. accepted. rewrite !orb_true_iff, andb_true_iff in Heqb0.
  assert (Also : forall m, also c m x = true -> m = k \/ m = Pos.succ k).
  { intros m A. unfold also in A. destruct (edge_number m) as [z|] eqn:Ez; [|discriminate].
    now apply (Two m z). }
  destruct Heqb0 as [[[K|[K A]]|A]|K]; [|apply Also in A|apply Also in A|assumption].
  - now rewrite Sm in K.
  - apply negb_true_iff, Pos.eqb_neq in K. destruct A; lia.
  - destruct A; lia.
Qed.

(** The angles opposite an edge of two triangles, and of no third. *)
Lemma narrow_angles x y so sp sq so' : narrow c x y = true -> known (facing x) so ->
  known (low x) sp -> known (high x) sq -> known (facing y) so' ->
  (0 < snd (cotangent so sp sq))%Z -> (0 < snd (cotangent so' sp sq))%Z ->
  0 <= signed_cos2 (spot (facing x)) (spot (low x)) (spot (high x)) +
    signed_cos2 (spot (facing y)) (spot (low x)) (spot (high x)).
Proof.
  intros N Ko Kp Kq Ko' A B. unfold narrow in N. cbn [find_all] in N. unfold known in *.
  rewrite Ko, Ko', Kp, Kq in N. destruct (known_place _ _ Ko) as (-> & Wo & _).
  destruct (known_place _ _ Ko') as (-> & Wo' & _). destruct (known_place _ _ Kp) as (-> & Wp & _).
  destruct (known_place _ _ Kq) as (-> & Wq & _).
  apply (@angles_decided d r unit_positive) in N; try assumption.
  intros s [<-|[<-|[<-|[<-|[<-|[<-|[]]]]]]]; assumption.
Qed.
Lemma known_once k s s' : known k s -> known k s' -> s = s'.
Proof. unfold known. congruence. Qed.

Section Edge.
Variables (t u : positive) (e f : triangle_entry) (i j : nat) (a p q b p' q' : positive).
Hypotheses (different : t <> u) (Et : triangle t = Some e) (Eu : triangle u = Some f).
Hypothesis Sa : split3 i (triangle_vertices e) = Some (a, p, q).
Hypothesis Sb : split3 j (triangle_vertices f) = Some (b, p', q').
Hypothesis ends : p = p' /\ q = q' \/ p = q' /\ q = p'.
Hypothesis no_third : forall w g m o y z, triangle w = Some g ->
  split3 m (triangle_vertices g) = Some (o, y, z) -> (y = p /\ z = q \/ y = q /\ z = p) ->
  w = t \/ w = u.
Notation x := (edge_between p q a).
Notation y := (edge_between p' q' b).

Lemma apex_of w g m o y z : triangle w = Some g ->
  split3 m (triangle_vertices g) = Some (o, y, z) -> (y = p /\ z = q \/ y = q /\ z = p) ->
  w = t /\ o = a \/ w = u /\ o = b.
Proof.
  intros Eg S E. destruct (triangle_accepted w g Eg) as [G _].
  destruct (triangle_proper g G) as (_ & _ & _ & N).
  destruct (split3_three _ _ _ _ _ S) as (_ & _ & I & D). specialize (D N).
  destruct (no_third _ _ _ _ _ _ Eg S E) as [->| ->]; [left|right]; (split; [reflexivity|]).
  - assert (g = e) as -> by congruence.
    destruct (split3_three _ _ _ _ _ Sa) as (_ & _ & J & _). specialize (J o).
    destruct (proj1 J) as [K|[K|K]]; [apply I; now left|assumption| |]; exfalso;
      destruct D as (D1 & D2 & _), E as [[-> ->]|[-> ->]]; congruence.
  - assert (g = f) as -> by congruence.
    destruct (split3_three _ _ _ _ _ Sb) as (_ & _ & J & _). specialize (J o).
    destruct (proj1 J) as [K|[K|K]]; [apply I; now left|assumption| |]; exfalso;
      destruct D as (D1 & D2 & _), E as [[-> ->]|[-> ->]], ends as [[-> ->]|[-> ->]]; congruence.
Qed.
Lemma same_ends_x_y : same_edge x y = true.
Proof. now apply edge_between_same. Qed.

Lemma only_these k l : edge_number k = Some x -> edge_number l = Some y ->
  forall m z, edge_number m = Some z -> same_edge z x = true -> m = k \/ m = l.
Proof.
  intros Ex Ey m z Ez S. destruct (edge_number_split m z Ez) as (w & g & n & o & p2 & q2 & _ & Eg &
    Sg & ->).
  pose proof (proj2 (edge_between_same _ _ _ _ _ _) S) as E.
  destruct (apex_of w g n o p2 q2 Eg Sg E) as [[-> ->]|[-> ->]]; [left|right].
  - apply (edge_once m k x); [|assumption]. rewrite Ez. f_equal. apply same_edge_eq; [assumption|].
    now rewrite !edge_between_facing.
  - apply (edge_once m l y); [|assumption]. rewrite Ez. f_equal. apply same_edge_eq.
    + apply (same_edge_trans _ x); [assumption|apply same_ends_x_y].
    + now rewrite !edge_between_facing.
Qed.

Lemma narrow_ends z g m o y' z' : triangle z = Some g ->
  split3 m (triangle_vertices g) = Some (o, y', z') -> exists so sy sz,
  known o so /\ known y' sy /\ known z' sz /\ (0 < snd (cotangent so sy sz))%Z /\
  (0 < snd (cotangent so sz sy))%Z.
Proof.
  intros Eg S. destruct (triangle_accepted z g Eg) as [(X & F & L) _].
  destruct (split3_related _ _ _ _ _ _ _ F S) as (so & sy & sz & S' & Ko & Ky & Kz).
  exists so, sy, sz. repeat (split; [assumption|]). destruct (known_shaped _ _ F) as (W & _).
  apply (on_no_line_split r unit_positive X m so sy sz W L S').
Qed.

Lemma opposite_angles : 0 <= signed_cos2 (spot a) (spot p) (spot q) +
    signed_cos2 (spot b) (spot p) (spot q).
Proof.
  destruct (edge_of_triangle t e i a p q Et Sa) as (k & Ek & Ex).
  destruct (edge_of_triangle u f j b p' q' Eu Sb) as (l & El & Ey).
  assert (K : narrow c x y = true \/ narrow c y x = true).
  { destruct (Pos.lt_total k l) as [L|[->|L]].
    - left. apply (two_in_order k l); try assumption; [apply same_ends_x_y|].
      now apply only_these.
    - exfalso. apply different. congruence.
    - right. apply (two_in_order l k); try assumption.
      { rewrite same_edge_sym. apply same_ends_x_y. }
      intros m z Ez S. destruct (only_these k l Ex Ey m z Ez) as [->| ->]; auto.
      apply (same_edge_trans _ y); [assumption|]. rewrite same_edge_sym. apply same_ends_x_y. }
  destruct (narrow_ends t e i a p q Et Sa) as (sa & sp & sq & Ka & Kp & Kq & A & A').
  destruct (narrow_ends u f j b p' q' Eu Sb) as (sb & sp' & sq' & Kb & Kp' & Kq' & B & B').
  assert (E : sp = sp' /\ sq = sq' /\ p = p' /\ q = q' \/ sp = sq' /\ sq = sp' /\ p = q' /\ q = p').
  { destruct ends as [[E1 E2]|[E1 E2]]; [left|right]; subst p q;
      (split; [now apply (known_once _ _ _ Kp)|]);
      (split; [now apply (known_once _ _ _ Kq)|auto]). }
  clear Kp' Kq'. pose proof (edge_between_facing p q a) as Fx.
  pose proof (edge_between_facing p' q' b) as Fy.
  pose proof (edge_between_ends p q a) as Lx. pose proof (edge_between_ends p' q' b) as Ly.
  destruct K as [K|K].
  - pose proof (narrow_angles x y) as N. rewrite Fx, Fy in N.
    destruct Lx as [[Lx Hx]|[Lx Hx]]; rewrite Lx, Hx in N;
      destruct E as [(-> & -> & _)|(-> & -> & _)];
      [pose proof (N _ _ _ _ K Ka Kp Kq Kb)|pose proof (N _ _ _ _ K Ka Kp Kq Kb)|
       pose proof (N _ _ _ _ K Ka Kq Kp Kb)|pose proof (N _ _ _ _ K Ka Kq Kp Kb)];
      rewrite ?(angle_sym _ (spot q)) in *; auto.
  - pose proof (narrow_angles y x) as N. rewrite Fx, Fy in N. rewrite Rplus_comm.
    assert (Kp' : known p' sp') by (destruct E as [(<- & <- & <- & <-)|(<- & <- & <- & <-)]; auto).
    assert (Kq' : known q' sq') by (destruct E as [(<- & <- & <- & <-)|(<- & <- & <- & <-)]; auto).
    destruct Ly as [[Ly Hy]|[Ly Hy]]; rewrite Ly, Hy in N;
      [pose proof (N _ _ _ _ K Kb Kp' Kq' Ka B)|pose proof (N _ _ _ _ K Kb Kq' Kp' Ka B')];
      destruct E as [(<- & <- & <- & <-)|(<- & <- & <- & <-)];
      rewrite ?(angle_sym _ (spot q)) in *; auto.
Qed.
End Edge.

(** ** All together *)

Lemma triangle_of i s : nth_error T i = Some s ->
  exists t e, triangle t = Some e /\ i = pred (Pos.to_nat t) /\ s = map spot (triangle_vertices e).
Proof.
  unfold simplices_of_certificate. cbn. rewrite map_map. cbn. rewrite nth_error_map.
  destruct (nth_error (surface_triangles c) i) as [e|] eqn:E; [|discriminate].
  intros S. injection S as <-. exists (Pos.of_succ_nat i), e.
  unfold numbered. rewrite SuccNat2Pos.id_succ. auto.
Qed.
Lemma triangle_listed t e : triangle t = Some e ->
  nth_error T (pred (Pos.to_nat t)) = Some (map spot (triangle_vertices e)).
Proof.
  intros E. unfold simplices_of_certificate. cbn. rewrite map_map. cbn.
  exact (map_nth_error _ _ _ E).
Qed.
Lemma vertex_known_at t e k : triangle t = Some e -> In k (triangle_vertices e) ->
  exists s, known k s.
Proof.
  intros E I. destruct (triangle_accepted t e E) as [(X & F & _) _]. clear - F I.
  induction F; [destruct I|]. destruct I as [<-|I]; eauto.
Qed.
(** Where the points are the same, their numbers are. *)
Lemma split_numbers t e u f i o p q j o' p' q' : triangle t = Some e -> triangle u = Some f ->
  split3 i (triangle_vertices e) = Some (o, p, q) ->
  split3 j (triangle_vertices f) = Some (o', p', q') ->
  (spot p = spot p' -> p = p') /\ (spot q = spot q' -> q = q') /\ (spot p = spot q' -> p = q') /\
  (spot q = spot p' -> q = p') /\ (spot o = spot o' -> o = o').
Proof.
  intros Et Eu S S'. destruct (split3_three _ _ _ _ _ S) as (_ & _ & I & _).
  destruct (split3_three _ _ _ _ _ S') as (_ & _ & J & _).
  assert (K : forall k l, In k (triangle_vertices e) -> In l (triangle_vertices f) ->
    spot k = spot l -> k = l).
  { intros k l Ik Il. destruct (vertex_known_at t e k Et Ik) as (s & Ks).
    destruct (vertex_known_at u f l Eu Il) as (s' & Kl). now apply (known_inj _ s _ s'). }
  repeat split; apply K; [apply I|apply J|apply I|apply J|apply I|apply J|apply I|apply J|apply I|
    apply J]; auto.
Qed.

Lemma surface_angles i j s t p q a b : p <> q -> edge_of_two T i j p q ->
  nth_error T i = Some s -> nth_error T j = Some t -> opposite s p q a -> opposite t p q b ->
  0 <= signed_cos2 a p q +
    signed_cos2 b p q.
Proof.
  intros N [Dif Two] Es Et (Ia & Nap & Naq) (Ib & Nbp & Nbq).
  assert (Ip : In p s /\ In q s).
  { destruct (proj2 (Two i)) as (s' & E & I); [now left|].
    now injection (eq_trans (eq_sym Es) E) as ->. }
  assert (Jp : In p t /\ In q t).
  { destruct (proj2 (Two j)) as (t' & E & I); [now right|].
    now injection (eq_trans (eq_sym Et) E) as ->. }
  destruct (triangle_of i s Es) as (x & e & Ex & Ei & ->).
  destruct (triangle_of j t Et) as (y & f & Ey & Ej & ->).
  destruct (triangle_accepted x e Ex) as [Tx _]. destruct (triangle_proper e Tx) as (Lx & _).
  destruct (triangle_accepted y f Ey) as [Ty _]. destruct (triangle_proper f Ty) as (Ly & _).
  destruct (split3_of spot _ a p q Lx Ia (proj1 Ip) (proj2 Ip) Nap Naq N)
    as (n & ka & kp & kq & Sx & <- & Ends).
  destruct (split3_of spot _ b p q Ly Ib (proj1 Jp) (proj2 Jp) Nbp Nbq N)
    as (m & kb & lp & lq & Sy & <- & Ends').
  destruct (split_numbers x e y f n ka kp kq m kb lp lq Ex Ey Sx Sy) as (K1 & K2 & K3 & K4 & _).
  assert (G : 0 <= signed_cos2 (spot ka) (spot kp) (spot kq) +
    signed_cos2 (spot kb) (spot kp) (spot kq)).
  { apply (opposite_angles x y e f n m ka kp kq kb lp lq); try assumption.
    - intros ->. apply Dif. congruence.
    - destruct Ends as [[Ep Eq]|[Ep Eq]], Ends' as [[Fp Fq]|[Fp Fq]];
        [left|right|right|left]; split; (apply K1 || apply K2 || apply K3 || apply K4); congruence.
    - intros w g l o y' z' Eg Sg E.
      destruct (proj1 (Two (pred (Pos.to_nat w)))) as [H|H]; [|left; lia|right; lia].
      exists (map spot (triangle_vertices g)). split; [now apply triangle_listed|].
      destruct (split3_three _ _ _ _ _ Sg) as (_ & _ & I & _).
      assert (Iy : In (spot y') (map spot (triangle_vertices g))) by (apply in_map, I; auto).
      assert (Iz : In (spot z') (map spot (triangle_vertices g))) by (apply in_map, I; auto).
      destruct E as [[-> ->]|[-> ->]], Ends as [[<- <-]|[<- <-]]; auto. }
  destruct Ends as [[<- <-]|[<- <-]]; [assumption|].
  now rewrite (angle_sym (spot ka)), (angle_sym (spot kb)).
Qed.

Lemma surface_once : ForallOrdPairs (fun s t => ~ same s t) T.
Proof.
  apply Line.pairs_by_number. intros i j s t L Es Et [Inc _].
  destruct (triangle_of i s Es) as (x & e & Ex & Ei & ->).
  destruct (triangle_of j t Et) as (y & f & Ey & Ej & ->).
  destruct (triangle_accepted x e Ex) as [Tx _].
  destruct (triangle_proper e Tx) as (Lx & _ & In_ & Nx).
  destruct (triangle_accepted y f Ey) as [Ty _]. destruct (triangle_proper f Ty) as (Ly & _).
  apply independent_NoDup in In_.
  destruct (triangle_vertices e) as [|a [|p [|q [|? ?]]]] eqn:V; try discriminate.
  assert (Sx : split3 0 (triangle_vertices e) = Some (a, p, q)) by now rewrite V.
  cbn [map] in In_, Inc. inversion_clear In_ as [|? ? Na In1]. inversion_clear In1 as [|? ? Np _].
  assert (Q : exists m o y z, split3 m (triangle_vertices f) = Some (o, y, z) /\ spot o = spot a /\
    (spot y = spot p /\ spot z = spot q \/ spot y = spot q /\ spot z = spot p)).
  { apply (split3_of spot _ (spot a) (spot p) (spot q) Ly); try (apply Inc; cbn; tauto);
      intros E; (apply Na; left; congruence) || (apply Na; right; left; congruence) ||
      (apply Np; left; congruence). }
  destruct Q as (m & ka & kp & kq & Sy & Ka & Ends).
  destruct (split_numbers x e y f 0 a p q m ka kp kq Ex Ey Sx Sy) as (K1 & K2 & K3 & K4 & K5).
  specialize (K5 (eq_sym Ka)). subst ka.
  destruct (edge_of_triangle x e 0 a p q Ex Sx) as (k & Ek & Nk).
  destruct (edge_of_triangle y f m a kp kq Ey Sy) as (l & El & Nl).
  assert (E : edge_between p q a = edge_between kp kq a).
  { apply same_edge_eq; [|now rewrite !edge_between_facing]. apply edge_between_same.
    destruct Ends as [[E1 E2]|[E1 E2]]; [left|right]; auto. }
  rewrite E in Nk. pose proof (edge_once k l _ Nk Nl) as ->. rewrite Ek in El. injection El as El _.
  subst y. lia.
Qed.

Theorem surface_sound : intrinsically_delaunay P T.
Proof.
  constructor.
  - destruct surface_parts as (_ & _ & N & _). intros E. apply N.
    unfold simplices_of_certificate in E. cbn in E. rewrite map_map in E.
    now destruct (surface_triangles c).
  - intros s I. apply In_nth_error in I. destruct I as (i & E).
    destruct (triangle_of i s E) as (t & e & Et & _ & ->).
    destruct (triangle_accepted t e Et) as [Is _].
    destruct (triangle_proper e Is) as (L & I & In_ & _). rewrite map_length. auto.
  - apply surface_once.
  - apply surface_angles.
Qed.
End Sound.

Theorem check_surface_sound D c : check_surface D c = Accepted ->
  let S := points_of_certificate (dimension_of D) (bare_surface c) in
  NoDup S /\ intrinsically_delaunay S (simplices_of_certificate (dimension_of D) (bare_surface c)).
Proof.
  intros H. unfold check_surface in H.
  assert (E : dimension (predicates_of D) = dimension_of D) by now destruct D.
  split; [apply (surface_points_once E c H)|exact (surface_sound E c H)].
Qed.
