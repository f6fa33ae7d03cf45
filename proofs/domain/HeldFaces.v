(** * Faces of the mesh and what holds them

    Segments and polygons are unions of faces of a complex.  If two of them meet in a point, both
    contain the least face with this point; and one segment or polygon holds it, or it is a vertex
    of the domain ([common_face]).  So vertices and segments are a simplicial complex
    ([segments_complex]). *)
From Coq Require Import Rbase Rfunctions Lra List Arith Lia ZArith Bool.
From Circumspect Require Import ComplexChecker Numbering.
From Circumspect Require Import Vectors Affine Frame Matched Faces Facets Mesh Independence.
From Circumspect Require Import Combinations Orientation Integers Accepted CertifiedMesh Soundness.
From Circumspect Require Import KeptMesh KeptCells Definitions Domains.
Import ListNotations.
Open Scope R_scope.

(** ** Lists of numbers *)

Lemma least_of k l : In (least (k :: l)) (k :: l) /\ forall x, In x (k :: l) ->
  (least (k :: l) <= x)%positive.
Proof.
  unfold least. revert k. induction l as [|a l IH]; intros k.
  - split; [now left|]. intros x [<-|[]]. cbn. lia.
  - cbn [fold_left]. destruct (IH (lesser k a)) as [I M].
    assert (L : (lesser k a <= k)%positive /\ (lesser k a <= a)%positive /\
      (lesser k a = k \/ lesser k a = a)).
    { unfold lesser. destruct (Pos.ltb k a) eqn:E; [apply Pos.ltb_lt in E|apply Pos.ltb_ge in E];
        repeat split; try lia; auto. }
    destruct L as (L1 & L2 & L3). split.
    + destruct I as [I|I]; [|right; now right]. rewrite <- I.
      destruct L3 as [->| ->]; [now left|right; now left].
    + assert (G := M _ (or_introl eq_refl)). intros x [<-|[<-|Ix]]; [lia|lia|]. apply M. now right.
Qed.
Lemma least_same s t : (forall x, In x s <-> In x t) -> least s = least t.
Proof.
  intros E. destruct s as [|a s], t as [|b t]; [reflexivity| | |].
  - exfalso. apply (E b). now left.
  - exfalso. apply (E a). now left.
  - destruct (least_of a s) as [I M], (least_of b t) as [I' M'].
    apply E, M' in I. apply E, M in I'. lia.
Qed.
Lemma same_members_intro k l : (forall x, In x k <-> In x l) -> same_members k l = true.
Proof.
  intros E. unfold same_members. apply andb_true_intro.
  split; apply forallb_forall; intros x I; apply member_in, E, I.
Qed.
Lemma holder_same F s t : (forall x, In x s <-> In x t) -> holder_of F s = holder_of F t.
Proof.
  intros E. unfold holder_of. rewrite (least_same s t E).
  destruct (Table.find (least t) F) as [l|]; [|reflexivity].
  enough (X : find (fun e => same_members (least t :: others e) s) l =
    find (fun e => same_members (least t :: others e) t) l) by now rewrite X.
  induction l as [|e l IH]; [reflexivity|]. cbn [find]. rewrite IH.
  enough (X : same_members (least t :: others e) s = same_members (least t :: others e) t)
    by now rewrite X.
  apply Bool.eq_true_iff_eq. split; intros H; apply same_members_intro; intros x;
    rewrite (same_members_spec _ _ H x); [apply E|symmetry; apply E].
Qed.
Lemma filter_sublist (Q : positive -> bool) l : In (filter Q l) (sublists l).
Proof.
  induction l as [|k l IH]; [now left|]. cbn [filter sublists]. apply in_or_app.
  destruct (Q k); [left; now apply in_map|now right].
Qed.
Lemma sublist_incl l : forall s, In s (sublists l) -> incl s l.
Proof.
  induction l as [|k l IH]; intros s; cbn [sublists].
  - intros [<-|[]] x [].
  - intros I x Ix. apply in_app_or in I. destruct I as [I|I]; [|right; now apply (IH s)].
    apply in_map_iff in I. destruct I as (r & <- & I).
    destruct Ix as [<-|Ix]; [now left|right; now apply (IH r)].
Qed.

(** ** Two points *)

Lemma two_independent {d} (s : list (point d)) a b : NoDup s -> incl s [a; b] ->
  affinely_independent s.
Proof.
  intros N I. apply dual_independent; [assumption|]. intros v Iv.
  assert (One : forall o, v <> o -> exists f : point d -> R, affine f /\ f v = 1 /\ f o = 0).
  { intros o Vo. destruct (Req_dec (dist2 v o) 0) as [E|Z].
    { exfalso. apply Vo. apply norm2_zero in E. rewrite <- (minus_plus v o), E. apply origin_plus. }
    unfold dist2, norm2 in Z.
    exists (fun p => inner (scale (/ inner (minus v o) (minus v o)) (minus v o)) (minus p o)).
    split; [|split].
    - exists (scale (/ inner (minus v o) (minus v o)) (minus v o)),
        (- inner (scale (/ inner (minus v o) (minus v o)) (minus v o)) o).
      intros p. unfold plane. rewrite inner_minus_r. ring.
    - rewrite inner_scale. now field.
    - rewrite minus_self, inner_comm. apply inner_origin. }
  destruct (I v Iv) as [<-|[<-|[]]].
  - destruct (in_dec point_eq_dec b s) as [Ib|Nb].
    + destruct (point_eq_dec a b) as [E|Vo].
      * exists (fun _ => 1). split; [apply affine_const|]. split; [reflexivity|]. intros w Iw Nw.
        exfalso.
        destruct (I w Iw) as [<-|[<-|[]]]; congruence.
      * destruct (One b Vo) as (f & A & F1 & F0). exists f. split; [assumption|].
        split; [assumption|].
        intros w Iw Nw. destruct (I w Iw) as [<-|[<-|[]]]; [congruence|assumption].
    + exists (fun _ => 1). split; [apply affine_const|]. split; [reflexivity|]. intros w Iw Nw.
      exfalso.
      destruct (I w Iw) as [<-|[<-|[]]]; [congruence|contradiction].
  - destruct (point_eq_dec b a) as [E|Vo].
    + exists (fun _ => 1). split; [apply affine_const|]. split; [reflexivity|]. intros w Iw Nw.
      exfalso.
      destruct (I w Iw) as [<-|[<-|[]]]; congruence.
    + destruct (One a Vo) as (f & A & F1 & F0). exists f. split; [assumption|].
      split; [assumption|].
      intros w Iw Nw. destruct (I w Iw) as [<-|[<-|[]]]; [assumption|congruence].
Qed.

Section HeldFaces.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis Or : oriented orient.
Hypothesis Co : computes orient pr.
Hypothesis positive_d : (1 <= d)%nat.
Variable c : certificate.
Hypothesis accepts : check_in pr c = Accepted.
Variable p : part.
Variables (planar : bool) (kind : domain_kind).
Variable shown : list positive -> nat -> positive * positive -> bool.
Hypothesis part_accepts : check_part pr false planar kind c p shown = Accepted.

Notation spot := (spot d c).
Notation m := (mesh_of c).
Notation entry t e := (numbered (simplices c) t = Some e).
Notation roles_of := (Table.of_list Datatypes.id (roles p)).
Notation segments_of := (Table.of_list Datatypes.id (segments p)).
Let dim_d : dimension pr = d := computes_dimension _ _ Co.
Let parts := part_parts c p planar kind shown part_accepts.

(** ** The least face with a point *)

Definition face_at (s : list positive) (q : point d) : Prop :=
  exists t e, entry t e /\ incl s (corners e) /\ conv (map spot s) q.

Lemma known t e k : entry t e -> In k (corners e) -> exists x, numbered (points c) k = Some x.
Proof. intros E I. destruct (simplex_accepted dim_d accepts t e E) as (K & _). auto. Qed.
Lemma spots_once k l e e' : numbered (points c) k = Some e -> numbered (points c) l = Some e' ->
  spot k = spot l -> k = l.
Proof.
  intros Ek El E. pose proof (points_distinct dim_d accepts) as N.
  assert (Len : forall k e, numbered (points c) k = Some e ->
    (pred (Pos.to_nat k) < length (points_of_certificate d c))%nat).
  { intros k0 e0 E0. unfold points_of_certificate. rewrite map_length. apply nth_error_Some.
    unfold numbered in E0. congruence. }
  pose proof (proj1 (NoDup_nth _ origin) N _ _ (Len k e Ek) (Len l e' El) E). lia.
Qed.

Lemma shared_face s s' q : face_at s q -> face_at s' q -> exists Q : positive -> bool,
  (forall x, In x (filter Q s) <-> In x (filter Q s')) /\ conv (map spot (filter Q s)) q.
Proof.
  intros (t & e & E & I & C) (u & e' & E' & I' & C').
  destruct (frames_exist Or Co c accepts) as (geo & G).
  assert (Ht : In t (tets c)) by (apply in_tets; eauto).
  assert (Hu : In u (tets c)) by (apply in_tets; eauto).
  pose proof (certificate_matched Or Co c accepts geo G) as mesh.
  pose proof (certificate_supporting Or Co c accepts geo G) as sup.
  pose proof (vertices_in Co c accepts geo G) as ver.
  pose proof (certificate_covered_once Or Co c accepts geo G) as once.
  assert (Agree : forall t u, In t (tets c) -> In u (tets c) -> agree (geo t) (geo u)).
  { intros a b Ha Hb. exact (mesh_face_to_face mesh ver sup Pos.eq_dec once a b Ha Hb). }
  assert (Ve : vertices (geo t) = map spot (corners e)) by now apply (entry_vertices c geo G).
  assert (Vu : vertices (geo u) = map spot (corners e')) by now apply (entry_vertices c geo G).
  assert (J : incl (map spot s) (vertices (geo t))).
  { rewrite Ve. intros v Iv. apply in_map_iff in Iv. destruct Iv as (k & <- & Ik).
    now apply in_map, I. }
  assert (J' : incl (map spot s') (vertices (geo u))).
  { rewrite Vu. intros v Iv. apply in_map_iff in Iv. destruct Iv as (k & <- & Ik).
    now apply in_map, I'. }
  pose proof C as K. apply (conv_face (geo t) _ q J) in K. destruct K as [Ct P].
  pose proof C' as K'. apply (conv_face (geo u) _ q J') in K'. destruct K' as [Cu P'].
  set (Car := Faces.carrier (geo t) q).
  exists (fun k => if in_dec point_eq_dec (spot k) Car then true else false). split.
  - assert (CarU : forall v, In v Car -> In v (Faces.carrier (geo u) q)).
    { intros v Iv. apply in_carrier in Iv. destruct Iv as (i & Hi & Pi & ->).
      destruct (Agree t u Ht Hu q Ct Cu i Hi Pi) as (j & Hj & -> & Pj). apply in_carrier. eauto. }
    assert (SubT : forall v, In v Car -> In v (map spot s)).
    { intros v Iv. apply in_carrier in Iv. destruct Iv as (i & Hi & Pi & ->). auto. }
    assert (SubU : forall v, In v Car -> In v (map spot s')).
    { intros v Iv. apply CarU, in_carrier in Iv. destruct Iv as (i & Hi & Pi & ->). auto. }
    assert (Half : forall a b ea eb r r', entry a ea -> entry b eb -> incl r (corners ea) ->
      incl r' (corners eb) ->
      (forall v, In v Car -> In v (map spot r')) ->
      forall x, In x (filter (fun k => if in_dec point_eq_dec (spot k) Car then true else false) r)
        ->
        In x (filter (fun k => if in_dec point_eq_dec (spot k) Car then true else false) r')).
    { intros a b ea eb r r' Ea Eb Ir Ir' Sub x Ix. apply filter_In in Ix. destruct Ix as [Ix Qx].
      destruct (in_dec point_eq_dec (spot x) Car) as [Ic|] eqn:Dec; [|discriminate].
      pose proof (Sub _ Ic) as Iy. apply in_map_iff in Iy. destruct Iy as (y & Y & Iy).
      destruct (known a ea x Ea (Ir x Ix)) as (px & Px).
      destruct (known b eb y Eb (Ir' y Iy)) as (py & Py).
      pose proof (spots_once y x py px Py Px Y). subst y. apply filter_In. split; [assumption|].
      now rewrite Dec. }
    intros x. split; [now apply (Half t u e e')|now apply (Half u t e' e)].
  - apply (conv_incl Car); [|now apply conv_carrier].
    intros v Iv. pose proof Iv as Iv'. apply in_carrier in Iv. destruct Iv as (i & Hi & Pi & ->).
    pose proof (P i Hi Pi) as Iy. apply in_map_iff in Iy. destruct Iy as (y & Y & Iy).
    rewrite <- Y. apply in_map, filter_In. split; [assumption|]. rewrite Y.
    now destruct (in_dec point_eq_dec _ Car).
Qed.

Lemma at_corner_spec s q : at_corner roles_of s = true -> conv (map spot s) q ->
  exists k, In k s /\ is_corner roles_of k = true /\ q = spot k.
Proof.
  destruct s as [|k s]; [intros _ C; now apply conv_empty in C|]. cbn [at_corner]. intros H C.
  apply andb_prop in H. destruct H as [H A]. exists k. split; [now left|]. split; [assumption|].
  rewrite forallb_forall in A. apply Combinations.conv_singleton.
  apply (conv_incl (map spot (k :: s))); [|assumption].
  intros v Iv. apply in_map_iff in Iv. destruct Iv as (x & <- & [<-|I]); [now left|].
  apply A, Pos.eqb_eq in I. subst x. now left.
Qed.

(** ** What holds it *)

Variable F : list (list face_entry).
Notation F_of := (Table.of_list Datatypes.id F).
Variable inside : holder -> list positive.

Definition ends_of (s : segment_entry) : simplex d :=
  [spot (from s); spot (last (map reached (links s)) (from s))].
Definition on_segment_number (n : positive) (q : point d) : Prop :=
  exists s, numbered (segments p) n = Some s /\ conv (ends_of s) q.
(** [h] is [w], or a segment in the polygon [w]; with the point. *)
Definition owns (w h : holder) (q : point d) : Prop := w = h \/
  exists k j, h = InSegment k /\ w = InPolygon j /\ In k (inside w) /\ on_segment_number k q.
Definition all_held (w : holder) (s : list positive) : Prop :=
  forall r, In r (sublists s) -> held m roles_of segments_of F_of w (inside w) r = true.

Lemma lies_on_spec n s q : forallb (lies_on m segments_of n) s = true -> conv (map spot s) q ->
  on_segment_number n q.
Proof.
  intros L C. destruct s as [|k0 s0]; [now apply conv_empty in C|]. set (s := k0 :: s0) in *.
  rewrite forallb_forall in L. pose proof (L k0 (or_introl eq_refl)) as L0. unfold lies_on in L0.
  rewrite find_id in L0. destruct (numbered (segments p) n) as [g|] eqn:E; [|discriminate].
  exists g.
  split; [exact E|]. unfold ends_of. apply (conv_conv (map spot s)); [|assumption]. intros v Iv.
  apply in_map_iff in Iv. destruct Iv as (k & <- & Ik). specialize (L k Ik). unfold lies_on in L.
  rewrite find_id, E in L. fold (last_reached g).
  destruct (Table.find (from g) (points_of m)) as [a|] eqn:Fa; [|discriminate].
  destruct (Table.find (last_reached g) (points_of m)) as [b|] eqn:Fb; [|discriminate].
  destruct (Table.find k (points_of m)) as [x|] eqn:Fx; [|discriminate].
  destruct (point_known Co c accepts _ _ Fa) as (Sa & Ha & _).
  destruct (point_known Co c accepts _ _ Fb) as (Sb & Hb & _).
  destruct (point_known Co c accepts _ _ Fx) as (Sx & Hx & _).
  rewrite Sa, Sb, Sx. apply conv_two. exists (ratio a b x). now apply on_segment_between.
Qed.

Theorem common_face w w' s s' q : face_at s q -> face_at s' q -> all_held w s -> all_held w' s' ->
  (exists k, In k s /\ In k s' /\ is_corner roles_of k = true /\ q = spot k) \/
  exists h, owns w h q /\ owns w' h q.
Proof.
  intros Fs Fs' H H'. destruct (shared_face s s' q Fs Fs') as (Q & E & C).
  assert (C' : conv (map spot (filter Q s')) q).
  { apply (conv_incl (map spot (filter Q s))); [|assumption]. intros v Iv. apply in_map_iff in Iv.
    destruct Iv as (k & <- & Ik). now apply in_map, E. }
  specialize (H _ (filter_sublist Q s)). specialize (H' _ (filter_sublist Q s')).
  unfold held in H, H'.
  destruct (at_corner roles_of (filter Q s)) eqn:A.
  { left. destruct (at_corner_spec _ q A C) as (k & Ik & Ck & Eq). exists k.
    split; [now apply filter_In in Ik|]. split; [apply E in Ik; now apply filter_In in Ik|]. auto. }
  destruct (at_corner roles_of (filter Q s')) eqn:A'.
  { left. destruct (at_corner_spec _ q A' C') as (k & Ik & Ck & Eq). exists k.
    split; [apply E in Ik; now apply filter_In in Ik|]. split; [now apply filter_In in Ik|]. auto. }
  right. cbn [orb] in H, H'. rewrite <- (holder_same F_of _ _ E) in H'.
  destruct (holder_of F_of (filter Q s)) as [h|]; [|discriminate]. exists h.
  assert (G : forall w r, conv (map spot r) q ->
    match h, w with
    | InSegment k, InSegment j => Pos.eqb k j
    | InSegment k, InPolygon _ => member k (inside w) && forallb (lies_on m segments_of k) r
    | InPolygon k, InPolygon j => Pos.eqb k j
    | _, _ => false
    end = true -> owns w h q).
  { intros v r Cr X. destruct h as [k|k], v as [j|j]; try discriminate.
    - left. apply Pos.eqb_eq in X. now subst.
    - right. exists k, j. apply andb_prop in X. destruct X as [X Y]. apply member_in in X.
      repeat (split; [reflexivity || assumption|]). now apply (lies_on_spec k r).
    - left. apply Pos.eqb_eq in X. now subst. }
  split; [now apply (G w (filter Q s))|now apply (G w' (filter Q s'))].
Qed.

(** ** Segments *)

Hypothesis no_inside : forall n, inside (InSegment n) = [].
Hypothesis steps_accept : each (check_steps m roles_of segments_of F_of) 1 (segments p) = Accepted.

Lemma steps_held_edge n x : forall l u, steps_held m roles_of segments_of F_of n u l = true ->
  In x (edges_from u l) -> exists y z, x = [y; z] /\ all_held (InSegment n) x /\
    (is_corner roles_of y = true -> y = u) /\
    (is_corner roles_of z = true -> z = last (map reached l) u).
Proof.
  induction l as [|s l IH]; intros u H I; [destruct I|]. cbn [steps_held] in H.
  apply andb_prop in H. destruct H as [H H2]. apply andb_prop in H. destruct H as [H0 H1].
  assert (L : l <> [] -> last (map reached (s :: l)) u = last (map reached l) (reached s)).
  { intros N. change (map reached (s :: l)) with (reached s :: map reached l).
    assert (M : map reached l <> []) by (destruct l; [contradiction|discriminate]). revert M. clear.
    generalize (reached s) as a. induction (map reached l) as [|b r IH]; intros a M;
      [contradiction|].
    destruct r as [|b' r]; [reflexivity|]. change (last (b :: b' :: r) u = last (b :: b' :: r) a).
    change (last (b' :: r) u = last (b' :: r) a). rewrite <- (IH a) by discriminate. reflexivity. }
  destruct I as [<-|I].
  - exists u, (reached s). split; [reflexivity|]. split; [|split; [auto|]].
    + intros r Ir. rewrite no_inside. rewrite forallb_forall in H0. now apply H0.
    + intros K. destruct l as [|s' l]; [reflexivity|]. rewrite K in H1. discriminate.
  - destruct (IH (reached s) H2 I) as (y & z & -> & Al & Y & Z). exists y, z.
    split; [reflexivity|]. split; [assumption|].
    assert (N : l <> []) by (intros ->; destruct I). split.
    + intros K. rewrite (Y K) in K. exfalso. destruct l; [contradiction|]. rewrite K in H1.
      discriminate.
    + intros K. rewrite (L N). auto.
Qed.

(** A point of a segment is on one of its steps. *)
Lemma segment_face n s q : numbered (segments p) n = Some s -> conv (ends_of s) q ->
  exists y z, face_at [y; z] q /\ all_held (InSegment n) [y; z] /\
    (is_corner roles_of y = true -> y = from s) /\
    (is_corner roles_of z = true -> z = last (map reached (links s)) (from s)).
Proof.
  intros E C. assert (I : In s (segments p)) by now apply numbered_in with n.
  apply (segment_covered Co c accepts p planar kind shown part_accepts s I) in C.
  destruct C as (x & Ix & C).
  destruct (step_edge c p planar kind shown part_accepts s x I Ix) as (u & l & -> & _ & Ed).
  apply (edge_spec Co c accepts p planar kind shown part_accepts) in Ed.
  destruct Ed as (e & Ee & _ & _ & Iu & Iv & _).
  pose proof (each_accepted _ _ steps_accept n s E) as H. unfold check_steps in H. accepted.
  destruct (steps_held_edge n _ _ _ Heqb Ix) as (y & z & X & Al & Y & Z). injection X as <- <-.
  exists u, (reached l). split; [|split; [exact Al|split; assumption]].
  exists (link_simplex l), e. split; [assumption|]. split; [|assumption]. now intros k [<-|[<-|[]]].
Qed.

Lemma corner_face k : is_corner roles_of k = true -> face_at [k] (spot k).
Proof.
  intros K. apply is_corner_role in K. destruct K as (t & R).
  destruct parts as (_ & H & _). apply each_pair_accepted in H. destruct H as [L H]. symmetry in L.
  destruct (numbered_beside _ _ _ _ L R) as (e & E). specialize (H k e _ E R).
  unfold check_role in H. accepted. apply andb_prop in Heqb. destruct Heqb as [_ M].
  rewrite (find_simplex (c := c)) in M. destruct (numbered (simplices c) t) as [s|] eqn:Es;
    [|discriminate].
  exists t, s. split; [assumption|]. split; [|apply conv_point; now left].
  intros x [<-|[]]. now apply member_in.
Qed.
Lemma corner_on_segment n s k : numbered (segments p) n = Some s -> is_corner roles_of k = true ->
  conv (ends_of s) (spot k) -> In (spot k) (ends_of s).
Proof.
  intros E K C. destruct (segment_face n s _ E C) as (y & z & Fa & _ & Y & Z).
  destruct (shared_face _ _ _ Fa (corner_face k K)) as (Q & Eq & Cq).
  destruct (filter Q [y; z]) as [|x l] eqn:Fl; [now apply conv_empty in Cq|].
  assert (Ix : In x (filter Q [y; z])) by (rewrite Fl; now left).
  pose proof (proj1 (Eq x) (or_introl eq_refl)) as Ik. apply filter_In in Ix, Ik.
  destruct Ik as [[<-|[]] _]. destruct Ix as [[<-|[<-|[]]] _]; unfold ends_of.
  - left. now rewrite <- (Y K).
  - right. left. now rewrite <- (Z K).
Qed.

(** ** Vertices and segments are a simplicial complex *)

Lemma ends_corners n s : numbered (segments p) n = Some s ->
  is_corner roles_of (from s) = true /\ is_corner roles_of (last (map reached (links s)) (from s)) =
    true.
Proof.
  intros E. destruct parts as (_ & _ & H & _). apply (each_accepted _ _ H) in E.
  unfold check_segment in E. cbv zeta in E. accepted.
  apply andb_prop in Heqb. destruct Heqb as [K _]. now apply andb_prop in K.
Qed.
Lemma corner_vertex k : is_corner roles_of k = true -> In (spot k) (part_vertices d c p).
Proof.
  intros K. apply (corner_in c p planar kind shown part_accepts); [assumption|].
  destruct (corner_face k K) as (t & e & E & I & _).
  destruct (known t e k E (I k (or_introl eq_refl))) as (x & X).
  rewrite (find_point (c := c)), X. now eexists.
Qed.
Lemma ends_vertices n s : numbered (segments p) n = Some s ->
  incl (ends_of s) (part_vertices d c p).
Proof. intros E v [<-|[<-|[]]]; apply corner_vertex; now apply (ends_corners n s). Qed.
Lemma vertex_corner v : In v (part_vertices d c p) -> exists k, is_corner roles_of k = true /\
  v = spot k.
Proof.
  intros I. apply (in_part_vertices c p planar kind shown part_accepts) in I.
  destruct I as (k & e & t & _ & R & ->). exists k.
  split; [|reflexivity]. apply is_corner_role. eauto.
Qed.
Lemma segment_numbered a b : In (a, b) (part_segments d c p) -> exists n s,
  numbered (segments p) n = Some s /\ [a; b] = ends_of s.
Proof.
  intros I. apply in_map_iff in I. destruct I as (s & E & I). apply in_numbered in I.
  destruct I as (n & N).
  exists n, s. split; [assumption|]. now injection E as <- <-.
Qed.

Theorem segments_complex : simplicial_complex (fun s : simplex d => NoDup s /\
  ((exists v, In v (part_vertices d c p) /\ same s [v]) \/
   exists a b, In (a, b) (part_segments d c p) /\ same s [a; b])).
Proof.
  split; [|split].
  - intros s (N & [(v & _ & I & _)|(a & b & _ & I & _)]).
    + apply (two_independent s v v N). intros x Ix. apply I in Ix. destruct Ix as [<-|[]]. now left.
    + now apply (two_independent s a b N).
  - intros s f (_ & K) I N NE. split; [assumption|]. destruct f as [|x f]; [contradiction|].
    destruct K as [(v & Iv & S & _)|(a & b & Iab & S & _)].
    + left. exists v. split; [assumption|]. split; [now apply incl_tran with s|].
      intros y [<-|[]]. destruct (S x (I x (or_introl eq_refl))) as [->|[]]. now left.
    + destruct (segment_numbered a b Iab) as (n & g & G & Eg).
      assert (V : forall y, In y [a; b] -> In y (part_vertices d c p)).
      { rewrite Eg. apply (ends_vertices n g G). }
      assert (J : incl (x :: f) [a; b]) by now apply incl_tran with s.
      destruct (in_dec point_eq_dec a (x :: f)) as [Ia|Na], (in_dec point_eq_dec b (x :: f))
        as [Ib|Nb].
      * right. exists a, b. split; [assumption|]. split; [assumption|]. now intros y [<-|[<-|[]]].
      * left. exists a. split; [apply V; now left|]. split; [|now intros y [<-|[]]].
        intros y Iy. destruct (J y Iy) as [<-|[<-|[]]]; [now left|contradiction].
      * left. exists b. split; [apply V; right; now left|]. split; [|now intros y [<-|[]]].
        intros y Iy. destruct (J y Iy) as [<-|[<-|[]]]; [contradiction|now left].
      * exfalso. destruct (J x (or_introl eq_refl)) as [<-|[<-|[]]]; [apply Na|apply Nb]; now left.
  - intros s t (_ & Ks) (_ & Kt). exists (meet s t).
    split; [intros v Iv; now apply in_meet in Iv|]. split; [intros v Iv; now apply in_meet in Iv|].
    intros q Cs Ct.
    assert (Single : forall r v, same r [v] -> conv r q -> q = v /\ In q r).
    { intros r v S C. apply (conv_same r [v] q S) in C. apply Combinations.conv_singleton in C.
      subst q.
      split; [reflexivity|]. apply S. now left. }
    assert (End : forall r a b v, In (a, b) (part_segments d c p) -> same r [a; b] -> conv r q ->
      In v (part_vertices d c p) -> q = v -> In q r).
    { intros r a b v I S C Iv ->. apply vertex_corner in Iv. destruct Iv as (k & K & ->).
      destruct (segment_numbered a b I) as (n & g & G & Eg). rewrite Eg in S. apply S.
      apply (corner_on_segment n g k G K). now apply (conv_same r (ends_of g) _ S). }
    assert (Both : In q s -> In q t -> conv (meet s t) q).
    { intros Is It. apply conv_point. now apply in_meet. }
    destruct Ks as [(v & Iv & Ss)|(a & b & I & Ss)], Kt as [(v' & Iv' & St)|(a' & b' & I' & St)].
    + apply Both; [now apply (Single s v)|now apply (Single t v')].
    + destruct (Single s v Ss Cs) as [Eq Iq]. apply Both; [assumption|]. now apply (End t a' b' v).
    + destruct (Single t v' St Ct) as [Eq Iq]. apply Both; [|assumption]. now apply (End s a b v').
    + destruct (segment_numbered a b I) as (n & g & G & Eg).
      destruct (segment_numbered a' b' I') as (n' & g' & G' & Eg').
      pose proof Cs as C1. pose proof Ct as C2. rewrite Eg in Ss. rewrite Eg' in St.
      apply (conv_same s _ q Ss) in C1. apply (conv_same t _ q St) in C2.
      destruct (segment_face n g q G C1) as (y & z & Fa & Al & Y & Z).
      destruct (segment_face n' g' q G' C2) as (y' & z' & Fa' & Al' & Y' & Z').
      destruct (common_face _ _ _ _ q Fa Fa' Al Al') as [(k & Ik & Ik' & K & Eq)|(h & O & O')].
      * pose proof (corner_vertex k K) as Vk.
        apply Both; [now apply (End s a b (spot k) I); rewrite ?Eg|].
        now apply (End t a' b' (spot k) I'); rewrite ?Eg'.
      * assert (n = n').
        { destruct O as [O|(k & j & _ & O & _)]; [|discriminate].
          destruct O' as [O'|(k & j & _ & O' & _)]; [|discriminate].
          congruence. }
        subst n'. assert (g' = g) by congruence. subst g'. apply (conv_incl s); [|assumption].
        intros v Iv. apply in_meet. split; [assumption|]. apply St. now apply Ss.
Qed.
End HeldFaces.
