(** * What the kept simplices contain and fill

    For an accepted part: the kept simplices are a complex; the vertices of the domain are vertices
    of theirs; each segment is a union of edges; and they fill what their walls enclose, or the
    convex hull of the vertices. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Bool.
From Circumspect Require Import DomainChecker Numbering.
From Circumspect Require Import Vectors Affine Frame Matched Faces Facets Mesh.
From Circumspect Require Import Adjacency Combinations.
From Circumspect Require Import Orientation Integers Incidence Accepted CertifiedMesh.
From Circumspect Require Import KeptMesh Definitions Domains.
Import ListNotations.
Open Scope R_scope.

Lemma nth_error_combine {A B} (l : list A) (l' : list B) i a b :
  nth_error (combine l l') i = Some (a, b) <-> nth_error l i = Some a /\ nth_error l' i = Some b.
Proof.
  revert l' i. induction l as [|x l IH]; intros [|y l'] [|i]; cbn; try (intuition congruence).
  - apply IH.
Qed.

(** What walls enclose depends on their points alone. *)
Lemma enclosed_ext {d} (flat W W' : point d -> Prop) holes q : (forall x, W x <-> W' x) ->
  enclosed flat W holes q -> enclosed flat W' holes q.
Proof.
  intros E.
  assert (C : forall A B : point d -> Prop, (forall x, A x <-> B x) -> forall x y,
    connected flat A x y -> connected flat B x y).
  { intros A B H x y X. induction X as [|y z X IH F Cl]; [apply here|]. apply further with y; auto.
    intros s Hs N. apply H in N. exact (Cl s Hs N). }
  intros (F & H). split; [assumption|]. destruct H as [H|(N & H)]; [left; now apply E|right].
  split.
  - intros U. apply N. intros r. destruct (U r) as (y & X & L). exists y. split; [|assumption].
    apply (C W' W); [|assumption]. intros x. now rewrite E.
  - intros h Ih X. apply (H h Ih). apply (C W' W); [|assumption]. intros x. now rewrite E.
Qed.

Section KeptCells.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis Or : oriented orient.
Hypothesis Co : computes orient pr.
Hypothesis positive_d : (1 <= d)%nat.
Variable c : certificate.
Hypothesis accepts : check_in pr c = Accepted.
Variable p : part.
Context {loose : bool}.
Variables (planar : bool) (kind : domain_kind).
Variable shown : list positive -> nat -> positive * positive -> bool.
Hypothesis part_accepts : check_part pr loose planar kind c p shown = Accepted.

Notation r := (unit_of c).
Notation spot := (spot d c).
Notation m := (mesh_of c).
Notation entry t e := (numbered (simplices c) t = Some e).
Notation marks_of := (Table.of_list Datatypes.id (marks p)).
Notation roles_of := (Table.of_list Datatypes.id (roles p)).
Notation T := (part_simplices d c p).
Let dim_d : dimension pr = d := computes_dimension _ _ Co.
Let parts := part_parts c p planar kind shown part_accepts.

Lemma kept_exists : exists geo : positive -> frame d,
  forall t e, entry t e -> lists (map spot (corners e)) (geo t).
Proof. exact (frames_exist Or Co c accepts). Qed.

Lemma kept_members s : In s T <-> exists t e, entry t e /\ kept_at marks_of t = true /\
  s = map spot (corners e).
Proof.
  destruct kept_exists as (geo & F). now apply (in_kept c p planar kind shown part_accepts geo F).
Qed.

Theorem kept_complex : (forall t, In t T -> NoDup t /\ length t = S d) /\
  ForallOrdPairs (fun s t => ~ same s t) T /\ simplicial_complex (faces_of T).
Proof.
  destruct kept_exists as (geo & F).
  now apply (kept_complex_in Or Co c accepts p planar kind shown part_accepts geo F).
Qed.

(** ** Vertices *)

Lemma is_corner_role k : is_corner roles_of k = true <->
  exists t, numbered (roles p) k = Some (Corner t).
Proof.
  unfold is_corner. rewrite find_id. destruct (numbered (roles p) k) as [[t|w]|]; split;
    try discriminate; eauto; intros (u & E); discriminate.
Qed.
Lemma in_part_vertices v : In v (part_vertices d c p) <->
  exists k e t, numbered (points c) k = Some e /\ numbered (roles p) k = Some (Corner t) /\
    v = spot k.
Proof.
  unfold part_vertices. rewrite in_flat_map. split.
  - intros ((e & ro) & I & V). cbn [fst snd] in V. destruct ro as [t|w]; [|destruct V].
    destruct V as [<-|[]]. apply In_nth_error in I. destruct I as (i & I).
    apply nth_error_combine in I. destruct I as [Ie Ir]. exists (Pos.of_succ_nat i), e, t.
    assert (Ee : numbered (points c) (Pos.of_succ_nat i) = Some e).
    { unfold numbered. now rewrite SuccNat2Pos.id_succ. }
    split; [assumption|]. split; [unfold numbered; now rewrite SuccNat2Pos.id_succ|].
    symmetry. now apply spot_numbered.
  - intros (k & e & t & E & K & ->). exists (e, Corner t). split.
    + unfold numbered in E, K. apply nth_error_In with (pred (Pos.to_nat k)).
      now apply nth_error_combine.
    + cbn [fst snd]. left. symmetry. now apply spot_numbered.
Qed.
Lemma corner_in k : is_corner roles_of k = true ->
  (exists q, Table.find k (points_of m) = Some q) ->
  In (spot k) (part_vertices d c p).
Proof.
  intros C (q & Q). apply is_corner_role in C. destruct C as (t & C).
  rewrite (find_point (c := c)) in Q. destruct (numbered (points c) k) as [e|] eqn:E;
    [|discriminate].
  apply in_part_vertices. exists k, e, t. auto.
Qed.

Theorem vertices_kept v : loose = false -> In v (part_vertices d c p) -> exists t, In t T /\ In v t.
Proof.
  intros Tight I. apply in_part_vertices in I. destruct I as (k & e & t & E & K & ->).
  destruct parts as (_ & H & _). apply each_pair_accepted in H. destruct H as [_ H].
  specialize (H k e _ E K). unfold check_role in H. accepted. apply andb_prop in Heqb.
  destruct Heqb as [Kt M]. rewrite Tight in Kt. rewrite (find_simplex (c := c)) in M.
  destruct (numbered (simplices c) t) as [s|] eqn:Es; [|discriminate].
  exists (map spot (corners s)). split; [apply kept_members; eauto|].
  apply in_map. now apply member_in.
Qed.

(** ** Segments *)

Section Segment.
Variables (a b : site).
Hypothesis shape_a : well_shaped d a.
Hypothesis shape_b : well_shaped d b.
Notation A := (place_of r a).
Notation B := (place_of r b).
Definition ratio_of (k : positive) : R := ratio a b (site_at d c k).
Definition on_it (k : positive) : Prop :=
  0 <= ratio_of k <= 1 /\ spot k = between A B (ratio_of k).

Lemma on_segment_it k q : Table.find k (points_of m) = Some q -> on_segment a b q = true -> on_it k.
Proof.
  intros E O. destruct (point_known Co c accepts k q E) as (S & Sh & Q).
  destruct (on_segment_between d r a b q shape_a shape_b Sh O) as [H1 H2].
  unfold on_it, ratio_of. rewrite <- Q, S. auto.
Qed.
Lemma linked_edges l : forall u, on_it u ->
  linked m loose planar kind marks_of a b u l = true ->
  forall x, In x (edges_from u l) -> exists y z t i, x = [y; z] /\ on_it y /\ on_it z /\
    edge_of m loose planar kind marks_of t i y z = true.
Proof.
  induction l as [|s l IH]; intros u U L x I; [destruct I|]. cbn [linked] in L. cbv zeta in L.
  apply andb_prop in L. destruct L as [L L2]. apply andb_prop in L. destruct L as [Ed L1].
  destruct (Table.find (reached s) (points_of m)) as [q|] eqn:Q; [|discriminate].
  pose proof (on_segment_it _ _ Q L1) as V. destruct I as [<-|I].
  - exists u, (reached s), (link_simplex s), (link_facet s). auto.
  - now apply (IH (reached s) V L2).
Qed.
Lemma linked_covers l : forall u t, on_it u -> linked m loose planar kind marks_of a b u l = true ->
  l <> [] -> ratio_of u <= t -> t <= ratio_of (last (map reached l) u) ->
  exists x, In x (edges_from u l) /\ conv (map spot x) (between A B t).
Proof.
  induction l as [|s l IH]; intros u t U L NE H1 H2; [contradiction|].
  cbn [linked] in L. cbv zeta in L. apply andb_prop in L. destruct L as [L L2].
  apply andb_prop in L. destruct L as [Ed L1].
  destruct (Table.find (reached s) (points_of m)) as [q|] eqn:Q; [|discriminate].
  pose proof (on_segment_it _ _ Q L1) as V.
  destruct (Rle_dec t (ratio_of (reached s))) as [Le|Gt].
  - exists [u; reached s]. split; [now left|]. cbn [map]. destruct U as [_ ->], V as [_ ->].
    now apply conv_part.
  - destruct l as [|s' l]; [cbn in H2; lra|].
    destruct (IH (reached s) t V L2) as (x & I & C); [discriminate|lra| |].
    + change (last (map reached (s :: s' :: l)) u) with (last (map reached (s' :: l)) u) in H2.
      replace (last (map reached (s' :: l)) (reached s)) with (last (map reached (s' :: l)) u);
        [assumption|]. clear. revert s'. induction l as [|s2 l IH]; intros s'; [reflexivity|].
      apply (IH s2).
    + exists x. split; [now right|assumption].
Qed.
End Segment.

Lemma segment_checked n s : numbered (segments p) n = Some s -> exists a b,
  Table.find (from s) (points_of m) = Some a /\
  Table.find (last (map reached (links s)) (from s)) (points_of m) = Some b /\
  on_segment a b b = true /\ linked m loose planar kind marks_of a b (from s) (links s) = true.
Proof.
  intros E. destruct parts as (_ & _ & H & _). apply (each_accepted _ _ H) in E.
  unfold check_segment in E. cbv zeta in E. accepted. apply andb_prop in Heqb.
  destruct Heqb as [_ K].
  destruct (Table.find (from s) (points_of m)) as [a|]; [|discriminate].
  destruct (Table.find (last (map reached (links s)) (from s)) (points_of m)) as [b|];
    [|discriminate].
  apply andb_prop in K. destruct K. exists a, b. auto.
Qed.
Lemma edge_spec t i u v : edge_of m loose planar kind marks_of t i u v = true -> exists e, entry t
  e /\
  (loose = false -> kept_at marks_of t = true) /\ u <> v /\ In u (corners e) /\ In v (corners e) /\
  (planar = true -> kind = Enclosed -> (i <= d)%nat /\ flagged_at marks_of t i = true /\
     forall x, In x (Checker.remove i (corners e)) <-> In x [u; v]).
Proof.
  unfold edge_of. intros H. apply andb_prop in H. destruct H as [H K]. apply andb_prop in H.
  destruct H as [N Kt]. rewrite (find_simplex (c := c)) in K.
  destruct (numbered (simplices c) t) as [e|] eqn:E; [|discriminate]. exists e.
  apply andb_prop in K. destruct K as [K F]. apply andb_prop in K. destruct K as [U V].
  apply member_in in U, V. apply negb_true_iff, Pos.eqb_neq in N.
  split; [reflexivity|]. split; [now intros L; rewrite L in Kt|].
  repeat (split; [assumption || reflexivity|]). intros -> ->.
  apply andb_prop in F. destruct F as [F S]. apply andb_prop in F. destruct F as [Fa Fl].
  split; [|split; [assumption|now apply same_members_spec]].
  apply (wall_index Co c accepts t e); [assumption|]. unfold has_facet in Fa.
  destruct (nth_error (walls e) i); [discriminate|discriminate].
Qed.

(** A segment is what its steps cover. *)
Theorem segment_covered s : In s (segments p) -> forall q,
  conv [fst (segment_ends d c s); snd (segment_ends d c s)] q <->
    exists x, In x (edges_from (from s) (links s)) /\ conv (map spot x) q.
Proof.
  intros I. apply in_numbered in I. destruct I as (n & E).
  destruct (segment_checked n s E) as (a & b & Fa & Fb & O & L).
  destruct (point_known Co c accepts _ _ Fa) as (Sa & Ha & Qa).
  destruct (point_known Co c accepts _ _ Fb) as (Sb & Hb & Qb).
  unfold segment_ends. cbn [fst snd]. rewrite Sa, Sb.
  assert (Start : on_it a b (from s)).
  { unfold on_it, ratio_of. rewrite <- Qa, ratio_start, between_start, Sa. split; [lra|reflexivity].
    }
  intros q. split.
  - intros C. apply conv_two in C. destruct C as (t & Ht & ->).
    apply (linked_covers a b Ha Hb); try assumption.
    + intros N. rewrite N in Fb. change (last (map reached []) (from s)) with (from s) in Fb.
      rewrite Fb in Fa. injection Fa as ->.
      pose proof (ratio_end a a O) as R1. rewrite ratio_start in R1. lra.
    + unfold ratio_of. rewrite <- Qa, ratio_start. lra.
    + unfold ratio_of. rewrite <- Qb, ratio_end by assumption. lra.
  - intros (x & Ix & C).
    destruct (linked_edges a b Ha Hb _ _ Start L x Ix) as (y & z & t & i & ->
      & (Y1 & Y2) & (Z1 & Z2) & _).
    apply (conv_conv (map spot [y; z])); [|assumption]. intros v [<-|[<-|[]]].
    + rewrite Y2. apply conv_two. eauto.
    + rewrite Z2. apply conv_two. eauto.
Qed.
(** The steps are edges of kept simplices; in the plane, walls. *)
Lemma step_edge s x : In s (segments p) -> In x (edges_from (from s) (links s)) ->
  exists u l, x = [u; reached l] /\ In l (links s) /\
    edge_of m loose planar kind marks_of (link_simplex l) (link_facet l) u (reached l) = true.
Proof.
  intros I Ix. apply in_numbered in I. destruct I as (n & E).
  destruct (segment_checked n s E) as (a & b & _ & _ & _ & L). revert L Ix.
  generalize (from s) as u. induction (links s) as [|l r IH]; intros u L Ix; [destruct Ix|].
  cbn [linked] in L. cbv zeta in L. apply andb_prop in L. destruct L as [L L2].
  apply andb_prop in L. destruct L as [Ed _]. destruct Ix as [<-|Ix].
  - exists u, l. split; [reflexivity|]. split; [now left|assumption].
  - destruct (IH _ L2 Ix) as (v & k & -> & Ik & K). exists v, k. split; [reflexivity|].
    split; [now right|assumption].
Qed.
Theorem segment_edges s : In s (segments p) -> exists F : list (list positive),
  (forall x, In x F -> exists y z t i, x = [y; z] /\ edge_of m loose planar kind marks_of t i y z
    = true)
    /\
  forall q, conv [fst (segment_ends d c s); snd (segment_ends d c s)] q <->
    exists x, In x F /\ conv (map spot x) q.
Proof.
  intros I. exists (edges_from (from s) (links s)). split; [|now apply segment_covered].
  intros x Ix. destruct (step_edge s x I Ix) as (u & l & -> & _ & K). eauto 6.
Qed.
Theorem segment_union s : loose = false -> In s (segments p) ->
  union_of_simplices T (fun q => conv [fst (segment_ends d c s); snd (segment_ends d c s)] q).
Proof.
  intros Tight I. destruct (segment_edges s I) as (F & H & C). exists (map (map spot) F). split.
  - intros x Ix. apply in_map_iff in Ix. destruct Ix as (y & <- & Iy).
    destruct (H y Iy) as (u & v & t & i & -> & K). apply edge_spec in K.
    destruct K as (e & E & Kt & N & U & V & _). specialize (Kt Tight).
    destruct kept_exists as (geo & G).
    split; [|split; [discriminate|]].
    + constructor; [|constructor; [intros []|constructor]]. intros [X|[]].
      now apply (corner_spots Co positive_d c geo G t e u v E U V N).
    + exists (map spot (corners e)). split; [apply kept_members; eauto|].
      intros x [<-|[<-|[]]]; now apply in_map.
  - intros q. rewrite C. split; intros (x & Ix & Q).
    + exists (map spot x). split; [now apply in_map|assumption].
    + apply in_map_iff in Ix. destruct Ix as (y & <- & Iy). eauto.
Qed.

(** ** What they fill: enclosed by walls *)

Definition flagged_points (q : point d) : Prop := exists t e i, entry t e /\ (i <= d)%nat /\
  flagged_at marks_of t i = true /\ conv (map spot (Checker.remove i (corners e))) q.

Section Walls.
Variables (W : point d -> Prop) (geo : positive -> frame d).
Hypothesis G : forall t e, entry t e -> lists (map spot (corners e)) (geo t).
Hypothesis walls_flagged : forall x, W x <-> flagged_points x.

Lemma flagged_walls x : W x <-> walls_in c p geo x.
Proof.
  rewrite walls_flagged. split.
  - intros (t & e & i & E & Hi & F & C). exists t, i. split; [apply in_tets; eauto|].
    repeat (split; [assumption|]). now apply (on_facet_entry Co positive_d c geo G t e).
  - intros (t & i & Ht & Hi & F & O). apply in_tets in Ht. destruct Ht as (e & E). exists t, e, i.
    repeat (split; [assumption|]). now apply (on_facet_entry Co positive_d c geo G t e).
Qed.
Lemma kept_filled q : (exists t, In t (tets c) /\ kept_at marks_of t = true /\
  inside_closed (geo t) q) <-> exists t, In t T /\ conv t q.
Proof.
  split.
  - intros (t & Ht & Kt & I). apply in_tets in Ht. destruct Ht as (e & E).
    exists (map spot (corners e)). split; [apply kept_members; eauto|].
    rewrite <- (entry_vertices c geo G t e E). now apply conv_vertices.
  - intros (s & Is & C). apply kept_members in Is. destruct Is as (t & e & E & Kt & ->). exists t.
    split; [apply in_tets; eauto|]. split; [assumption|].
    rewrite <- (entry_vertices c geo G t e E) in C. now apply conv_vertices.
Qed.
Lemma enclosed_filled q : kind = Enclosed -> enclosed (fun _ => True) W (part_holes d c p) q <->
  W q \/ exists t, In t T /\ conv t q.
Proof.
  intros K. rewrite <- kept_filled, flagged_walls.
  rewrite <- (enclosed_walls Or Co positive_d c accepts p planar kind shown part_accepts geo G K).
  split; apply enclosed_ext; intros x; [|symmetry]; apply flagged_walls.
Qed.
End Walls.
Theorem walls_and_kept W q : kind = Enclosed -> (forall x, W x <-> flagged_points x) ->
  enclosed (fun _ => True) W (part_holes d c p) q <-> W q \/ exists t, In t T /\ conv t q.
Proof. intros K HW. destruct kept_exists as (geo & G). now apply (enclosed_filled W geo). Qed.
Theorem kept_enclosed W q : loose = false -> kind = Enclosed ->
  (forall x, W x <-> flagged_points x) ->
  enclosed (fun _ => True) W (part_holes d c p) q <-> exists t, In t T /\ conv t q.
Proof.
  intros Tight K HW. rewrite (walls_and_kept W q K HW). destruct kept_exists as (geo & G).
  split; [intros [X|X]; [|assumption]|now right].
  apply (kept_filled geo G), (walls_kept Or Co positive_d c accepts p planar kind shown part_accepts
    geo G K q Tight), (flagged_walls W geo G HW), X.
Qed.
Lemma flagged_is_shown t e i : kind = Enclosed -> entry t e -> (i <= d)%nat ->
  flagged_at marks_of t i = true -> exists w, shown (corners e) i w = true.
Proof.
  intros K E Hi F. destruct kept_exists as (geo & G).
  destruct (wall_exists Co positive_d c accepts t e i E Hi) as (f & W).
  destruct (facet_checked c p planar kind shown part_accepts K t e i f E W)
    as (k & Ek & _ & _ & _ & Sh).
  apply (wall_at_flag p t k i Ek) in F. destruct F as (w & Fw). exists w. now apply Sh.
Qed.

(** ** What they fill: the convex hull of the vertices *)

Lemma integer_combination : forall n a P L, length P = n -> length L = n ->
  integer_point n (map (fun xy => (a * fst xy + snd xy)%Z) (combine P L)) =
  plus (scale (IZR a) (integer_point n P)) (integer_point n L).
Proof.
  induction n as [|n IH]; intros a [|x P] [|y L] HP HL; try discriminate; [reflexivity|].
  injection HP as HP. injection HL as HL. cbn [combine map fst snd].
  change (Vector.cons R (IZR (a * x + y)) n
      (integer_point n (map (fun xy => (a * fst xy + snd xy)%Z) (combine P L))) =
    Vector.cons R (IZR a * IZR x + IZR y) n (plus (scale (IZR a) (integer_point n P))
      (integer_point n L))).
  rewrite (IH a P L HP HL). f_equal. now rewrite plus_IZR, mult_IZR.
Qed.
Lemma integer_zeros n : integer_point n (repeat 0%Z n) = origin.
Proof.
  induction n as [|n IH]; [reflexivity|].
  change (Vector.cons R 0 n (integer_point n (repeat 0%Z n)) = Vector.cons R 0 n origin).
  now rewrite IH.
Qed.
Lemma integer_multiple n a L : length L = n ->
  integer_point n (map (Z.mul a) L) = scale (IZR a) (integer_point n L).
Proof.
  revert L. induction n as [|n IH]; intros [|x L] H; try discriminate; [reflexivity|].
  injection H as H. cbn [map].
  change (Vector.cons R (IZR (a * x)) n (integer_point n (map (Z.mul a) L)) =
    Vector.cons R (IZR a * IZR x) n (scale (IZR a) (integer_point n L))).
  rewrite (IH L H). f_equal. apply mult_IZR.
Qed.
Lemma weighed_spec w : forall n l, weighed pr m roles_of w = Some (n, l) -> length l = d /\
  let L := map (fun ak => (IZR (fst ak), spot (snd ak))) w in
  (forall a x, In (a, x) L -> 0 <= a /\ In x (part_vertices d c p)) /\ total L = IZR n /\
  combination L = scale r (integer_point d l).
Proof.
  induction w as [|(a, k) w IH]; intros n l E; cbn [weighed] in E.
  - injection E as <- <-. split; [rewrite repeat_length; exact dim_d|]. split; [intros a x []|].
    split; [reflexivity|]. rewrite dim_d, integer_zeros. symmetry. apply scale_origin.
  - destruct (Table.find k (points_of m)) as [q|] eqn:Q; [|discriminate].
    destruct (weighed pr m roles_of w) as [[n' l']|]; [|discriminate].
    destruct ((0 <=? a)%Z && is_corner roles_of k) eqn:K; [|discriminate]. injection E as <- <-.
    apply andb_prop in K. destruct K as [Pa Ck]. apply Z.leb_le, IZR_le in Pa.
    destruct (IH n' l' eq_refl) as (Ll & M & Tm & Cm).
    destruct (point_known Co c accepts k q Q) as (Sk & Sh & _). split; [|split; [|split]].
    + rewrite map_length, combine_length, Ll. unfold well_shaped in Sh. rewrite Sh.
      apply Nat.min_id.
    + cbn [map fst snd]. intros b x [X|X]; [|now apply M]. injection X as <- <-.
      split; [assumption|]. apply corner_in; eauto.
    + cbn [map fst snd]. rewrite total_cons, Tm. symmetry. apply plus_IZR.
    + cbn [map fst snd]. rewrite combination_cons, Cm, Sk, (integer_combination d a _ _ Sh Ll).
      unfold place_of. rewrite scale_plus, !scale_scale. do 2 f_equal. ring.
Qed.

Theorem kept_hull q : kind = Hull -> conv (part_vertices d c p) q <-> exists t, In t T /\ conv t q.
Proof.
  intros K. destruct kept_exists as (geo & G).
  assert (All : forall t e, entry t e -> kept_at marks_of t = true).
  { intros t e E. destruct (mark_of c p planar kind shown part_accepts t e E) as (k & _ & Kt & C).
    unfold check_mark in C. rewrite K in C. accepted. now rewrite Kt. }
  split.
  - intros C. destruct (covering Or Co c accepts geo G q) as (t & Ht & I).
    + apply (conv_incl (part_vertices d c p)); [|assumption]. intros v Iv.
      apply in_part_vertices in Iv. destruct Iv as (k & e & t & E & _ & ->).
      now apply spot_in with e.
    + apply in_tets in Ht. destruct Ht as (e & E). exists (map spot (corners e)).
      split; [apply kept_members; exists t, e; repeat split; [exact E|exact (All t e E)]|].
      rewrite <- (entry_vertices c geo G t e E).
      now apply conv_vertices.
  - intros (s & Is & C). apply kept_members in Is. destruct Is as (t & e & E & _ & ->).
    apply (conv_conv (map spot (corners e))); [|assumption]. intros v Iv. apply in_map_iff in Iv.
    destruct Iv as (k & <- & Ik).
    destruct (simplex_accepted dim_d accepts t e E) as (Known & _).
    destruct (Known k Ik) as (x & X).
    destruct parts as (_ & H & _). apply each_pair_accepted in H. destruct H as [L H].
    destruct (numbered_beside _ _ _ _ L X) as (ro & Ro). specialize (H k x ro X Ro).
    unfold check_role in H. accepted. destruct ro as [u|w].
    + apply conv_point, in_part_vertices. exists k, x, u. auto.
    + rewrite K in Heqb. destruct (weighed pr m roles_of w) as [[n l]|] eqn:W; [|discriminate].
      apply andb_prop in Heqb. destruct Heqb as [Pn Eq]. apply Z.ltb_lt, IZR_lt in Pn.
      apply same_integers_spec in Eq. destruct (weighed_spec w n l W) as (_ & M & Tm & Cm).
      cbv zeta in *. set (L' := map _ w) in *.
      apply (conv_of_multiple L').
      * intros a y I. now apply (M a y).
      * lra.
      * rewrite Tm, Cm, <- Eq, (spot_numbered d c k x X).
        assert (Sh : length (coordinates (position x)) = d).
        { pose proof (site_shaped dim_d accepts k) as Sh. unfold site_at in Sh. rewrite X in Sh.
          unfold well_shaped in Sh. now rewrite coordinates_site_of in Sh. }
        rewrite (integer_multiple d n _ Sh). unfold place_of. rewrite !scale_scale. f_equal. ring.
      * intros a y I. now apply (M a y).
Qed.
End KeptCells.
