(** * Domains in the plane, and polygons in space

    In the plane the walls are the segments, and the kept triangles fill what they enclose.  A
    polygon in space is that of a domain in the plane, seen along an axis: its pieces are the facets
    of the mesh that are above its kept triangles. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia ZArith Bool.
From Circumspect Require Import DomainChecker Numbering.
From Circumspect Require Import Vectors Affine Frame Faces Combinations Shadow.
From Circumspect Require Import Orientation Integers Accepted.
From Circumspect Require Import KeptMesh KeptCells Definitions Domains.
Import ListNotations.
Open Scope R_scope.

Notation mark_table p := (Table.of_list Datatypes.id (marks p)).

(** ** The plane *)

Section Walls.
Context {loose : bool}.
Variables (kind : domain_kind) (c : certificate) (p : part).
Hypothesis mesh_ok : check_in plane_predicates c = Accepted.
Notation spot := (spot 2 c).
Hypothesis part_ok :
  check_part plane_predicates loose true kind c p (shown_by_segment c p) = Accepted.
Let two : (1 <= 2)%nat := le_S 1 1 (le_n 1).

(** What is shown to be part of a segment is on it. *)
Lemma shown_on_segment K i w : shown_by_segment c p K i w = true ->
  exists s, numbered (segments p) (fst w) = Some s /\
  forall q, conv (map spot (Checker.remove i K)) q ->
    conv [fst (segment_ends 2 c s); snd (segment_ends 2 c s)] q.
Proof.
  intros Sh. unfold shown_by_segment in Sh. cbv zeta in Sh. rewrite find_id in Sh.
  destruct (numbered (segments p) (fst w)) as [s|] eqn:Es; [|discriminate]. exists s.
  split; [exact eq_refl|].
  destruct (Table.find (from s) (points_of (mesh_of c))) as [a|] eqn:Fa; [|discriminate].
  destruct (Table.find (last (map reached (links s)) (from s)) (points_of (mesh_of c)))
    as [b|] eqn:Fb;
    [|discriminate].
  destruct (point_known plane_computes c mesh_ok _ _ Fa) as (Sa & Ha & _).
  destruct (point_known plane_computes c mesh_ok _ _ Fb) as (Sb & Hb & _).
  intros q C. apply (conv_conv (map spot (Checker.remove i K))); [|assumption].
  intros v Iv. apply in_map_iff in Iv. destruct Iv as (k & <- & Ik).
  rewrite forallb_forall in Sh. specialize (Sh k Ik).
  destruct (Table.find k (points_of (mesh_of c))) as [x|] eqn:Fx; [|discriminate].
  destruct (point_known plane_computes c mesh_ok _ _ Fx) as (Sx & Hx & _).
  unfold segment_ends. cbn [fst snd]. rewrite Sa, Sb, Sx. apply conv_two. exists (ratio a b x).
  now apply on_segment_between.
Qed.
Lemma flagged_segments q : kind = Enclosed ->
  on_segments (part_segments 2 c p) q <-> flagged_points (d := 2) c p q.
Proof.
  intros K. split.
  - intros (a & b & I & C). apply in_map_iff in I. destruct I as (s & E & I).
    destruct (segment_edges plane_computes c mesh_ok p true kind _ part_ok s I) as (F & H & X).
    rewrite E in X. cbn [fst snd] in X. apply X in C. destruct C as (x & Ix & C).
    destruct (H x Ix) as (y & z & t & i & -> & Ed).
    apply (edge_spec plane_computes c mesh_ok p true kind _ part_ok) in Ed.
    destruct Ed as (e & Ee & _ & _ & _ & _ & Fl). destruct (Fl eq_refl K) as (Hi & Fa & M).
    exists t, e, i. repeat (split; [assumption|]).
    apply (conv_incl (map spot [y; z])); [|assumption].
    intros v Iv. apply in_map_iff in Iv. destruct Iv as (k & <- & Ik). apply in_map. now apply M.
  - intros (t & e & i & E & Hi & Fl & C).
    destruct (flagged_is_shown oriented2 plane_computes two c mesh_ok p true kind _ part_ok t e i K
      E Hi Fl)
      as (w & Sh).
    destruct (shown_on_segment _ _ _ Sh) as (s & Es & In_s).
    exists (fst (segment_ends 2 c s)), (snd (segment_ends 2 c s)). split; [|now apply In_s].
    rewrite <- surjective_pairing. apply in_map. now apply numbered_in with (fst w).
Qed.
End Walls.

Section Plane.
Variables (kind : domain_kind) (c : certificate) (p : part).
Hypothesis accepts : check_in_plane kind c p = Accepted.
Notation T := (part_simplices 2 c p).

Lemma plane_mesh_accepted : check_in plane_predicates c = Accepted.
Proof. pose proof accepts as H. unfold check_in_plane in H. now accepted. Qed.
Lemma plane_part_accepted :
  check_part plane_predicates false true kind c p (shown_by_segment c p) = Accepted.
Proof. pose proof accepts as H. unfold check_in_plane in H. now accepted. Qed.
Let mesh_ok := plane_mesh_accepted.
Let part_ok := plane_part_accepted.
Let two : (1 <= 2)%nat := le_S 1 1 (le_n 1).

Definition shown_segment := shown_on_segment c p plane_mesh_accepted.
Definition segments_flagged := flagged_segments kind c p plane_mesh_accepted plane_part_accepted.

Theorem plane_enclosed q : kind = Enclosed ->
  enclosed (fun _ => True) (on_segments (part_segments 2 c p)) (part_holes 2 c p) q <->
  exists t, In t T /\ conv t q.
Proof.
  intros K. apply (kept_enclosed oriented2 plane_computes two c mesh_ok p true kind _ part_ok);
    [reflexivity|assumption|].
  intros x. now apply segments_flagged.
Qed.
End Plane.

(** ** Polygons *)

Lemma over_spec f q w p : over f q w p = true -> length (normal f) = 3%nat -> (axis f < 3)%nat ->
  forall r, inner (integer_point 3 (normal f)) (scale r (integer_point 3 p)) = r * IZR w * IZR
    (offset f) /\
    shadow (axis f) (scale r (integer_point 3 p)) = scale r (integer_point 2 q) /\ length p = 3%nat.
Proof.
  unfold over. intros H Ln Ax r. apply andb_prop in H. destruct H as [H S]. apply andb_prop in H.
  destruct H as [E L]. apply Nat.eqb_eq in L. apply same_integers_spec in S. apply Z.eqb_eq in E.
  destruct (normal f) as [|a [|b [|e [|? ?]]]]; try discriminate Ln.
  destruct p as [|x [|y [|z [|? ?]]]]; try discriminate L. split; [|split; [|reflexivity]].
  - apply (f_equal IZR) in E. cbn [inner_product] in E.
    rewrite ?plus_IZR, ?mult_IZR in E. rewrite inner_scale_r, inner_3.
    change (r * (IZR a * IZR x + IZR b * IZR y + IZR e * IZR z) = r * IZR w * IZR (offset f)).
    rewrite Rmult_assoc, <- E. ring.
  - subst q. destruct (axis f) as [|[|[|k]]]; [| | |lia]; apply point2_ext; reflexivity.
Qed.

(** Its shape: nothing is asked of the mesh but where its points are. *)
Section Shape.
Variable c : certificate.
Hypothesis spot_known : forall j q, Table.find j (points_of (mesh_of c)) = Some q ->
  Definitions.spot 3 c j = place_of (unit_of c) q.
Variable D : domain_certificate.
Hypothesis of_D : whole_mesh D = c.
Variable f : polygon_entry.
Hypothesis shape_accepts : check_shape c (mesh_of c) f = Accepted.

Notation spot := (spot 3 c).
Notation p2 := (plane_mesh f).
Notation part2 := (plane_part f).
Notation spot2 := (Definitions.spot 2 p2).
Notation n := (integer_point 3 (normal f)).
Notation o := (unit_of c * IZR (offset f)).
Notation sh := (shadow (axis f)).
Let three : (1 <= 3)%nat := le_S 1 2 (le_S 1 1 (le_n 1)).

Lemma polygon_parts : numerator p2 = numerator c /\ denominator p2 = denominator c /\
  length (normal f) = 3%nat /\ (axis f < 3)%nat /\ nth (axis f) (normal f) 0%Z <> 0%Z /\
  check_in_plane Enclosed p2 part2 = Accepted /\
  each_pair polygon_flat AtPoint (check_above (mesh_of c) f) 1 (points p2) (above f) = Accepted /\
  each_pair polygon_flat AtHole (check_seed f) 1 (holes part2) (seeds f) = Accepted.
Proof.
  pose proof shape_accepts as H. unfold check_shape in H. cbv zeta in H. accepted.
  repeat (apply andb_prop in Heqb; let K := fresh in destruct Heqb as [Heqb K]).
  apply Z.eqb_eq in Heqb, H3. apply Nat.eqb_eq in H2. apply Nat.ltb_lt in H1.
  apply negb_true_iff, Z.eqb_neq in H0. auto 12.
Qed.
Lemma plane_ok : check_in_plane Enclosed p2 part2 = Accepted.
Proof. apply polygon_parts. Qed.
Lemma same_unit : unit_of p2 = unit_of c.
Proof. destruct polygon_parts as (N & E & _). unfold unit_of. now rewrite N, E. Qed.
Lemma polygon_seen : axis_of (axis f) n <> 0.
Proof.
  destruct polygon_parts as (_ & _ & L & A & N & _).
  destruct (normal f) as [|a [|b [|e [|? ?]]]]; try discriminate L.
  intros Z. apply N. destruct (axis f) as [|[|[|k]]]; [| | |lia]; apply eq_IZR; exact Z.
Qed.

(** The point of the mesh above a point of the plane. *)
Lemma above_spec k e : numbered (points p2) k = Some e -> exists j, numbered (above f) k = Some j /\
  flat n o (spot j) /\ sh (spot j) = spot2 k.
Proof.
  intros E. destruct polygon_parts as (_ & _ & Ln & Ax & _ & _ & H & _).
  apply each_pair_accepted in H.
  destruct H as [L H]. destruct (numbered_beside _ _ _ _ L E) as (j & J). exists j.
  split; [assumption|]. specialize (H k e j E J). unfold check_above in H. accepted.
  destruct (Table.find j (points_of (mesh_of c))) as [q|] eqn:Q; [|discriminate].
  pose proof (spot_known j q Q) as S.
  destruct (over_spec f _ _ _ Heqb Ln Ax (unit_of c)) as (F & Sh & _).
  rewrite S. unfold flat, place_of. split; [rewrite F; ring|].
  rewrite Sh, (spot_numbered 2 p2 k e E), same_unit. reflexivity.
Qed.
Notation up := (spot_above 3 c f).
Lemma up_spec k q : Table.find k (points_of (mesh_of p2)) = Some q -> flat n o (up k) /\
  sh (up k) = spot2 k.
Proof.
  intros Q. rewrite (find_point (c := p2)) in Q. destruct (numbered (points p2) k) as [e|] eqn:E;
    [|discriminate].
  destruct (above_spec k e E) as (j & J & F). unfold spot_above. now rewrite J.
Qed.

(** One of its segments, and its picture. *)
Lemma rim_segment s : In s (segments part2) -> forall x,
  conv [up (from s); up (last (map reached (links s)) (from s))] x <->
  flat n o x /\ conv [fst (segment_ends 2 p2 s); snd (segment_ends 2 p2 s)] (sh x).
Proof.
  intros Is x. apply in_numbered in Is. destruct Is as (k & Ks).
  destruct (segment_checked p2 part2 true Enclosed _ (plane_part_accepted _ _ _ plane_ok) k s Ks)
    as (a & b & Fa & Fb & _).
  destruct (up_spec _ _ Fa) as [Fla Sa]. destruct (up_spec _ _ Fb) as [Flb Sb].
  rewrite (conv_shadow (axis f) n o polygon_seen).
  - cbn [map]. rewrite Sa, Sb. reflexivity.
  - intros y [<-|[<-|[]]]; assumption.
Qed.
Lemma rim_shadow q : flat n o q ->
  on_segments (rim (polygon_of 3 D f)) q <-> on_segments (part_segments 2 p2 part2) (sh q).
Proof.
  intros Q. unfold polygon_of. rewrite of_D. cbn [rim]. split.
  - intros (a & b & I & C). apply in_map_iff in I. destruct I as (s & E & Is). injection E as <- <-.
    apply (rim_segment s Is) in C. destruct C as [_ C]. eexists _, _. split; [|exact C].
    unfold part_segments. rewrite <- surjective_pairing. now apply in_map.
  - intros (a & b & I & C). apply in_map_iff in I. destruct I as (s & E & Is).
    exists (up (from s)), (up (last (map reached (links s)) (from s))). split.
    + apply in_map_iff. exists s. split; [reflexivity|assumption].
    + apply (rim_segment s Is). rewrite E. auto.
Qed.
Lemma seed_spec k h s : numbered (holes part2) k = Some h -> numbered (seeds f) k = Some s ->
  flat n o (seed_point 3 c (fst s) (snd s)) /\
  sh (seed_point 3 c (fst s) (snd s)) = seed_point 2 p2 (hole_point h) (hole_w h).
Proof.
  intros Hk Sk. destruct polygon_parts as (_ & _ & Ln & Ax & _ & Pl & _ & H).
  apply each_pair_accepted in H.
  destruct H as [_ H]. specialize (H k h s Hk Sk). unfold check_seed in H. accepted.
  apply andb_prop in Heqb. destruct Heqb as [W Ov]. apply Z.eqb_eq in W.
  assert (Pw : (0 < hole_w h)%Z).
  { pose proof (part_parts p2 part2 true Enclosed _ (plane_part_accepted _ _ _ Pl))
      as (_ & _ & _ & X & _).
    apply (each_accepted _ _ X) in Hk. unfold check_hole in Hk. accepted.
    repeat (apply andb_prop in Heqb; let K := fresh in destruct Heqb as [Heqb K]).
    now apply Z.ltb_lt. }
  rewrite W in Pw. apply IZR_lt in Pw.
  destruct (over_spec f _ _ _ Ov Ln Ax (unit_of c / IZR (snd s))) as (F & Sh & _).
  unfold seed_point, flat, place_of. split; [rewrite F; field; lra|]. now rewrite Sh, same_unit, W.
Qed.

(** The pieces. *)
Lemma named_spec u s : numbered (simplices p2) u = Some s ->
  let k := named_above (Table.of_list Datatypes.id (above f)) (corners s) in
  (forall x, In x (map spot k) -> flat n o x) /\ map sh (map spot k) = map spot2 (corners s).
Proof.
  intros E.
  destruct (simplex_accepted (d := 2) (pr := plane_predicates) eq_refl
    (plane_mesh_accepted _ _ _ plane_ok) u s E) as (Known & _).
  unfold named_above. revert Known. generalize (corners s) as l. clear E.
  assert (G : forall l, (forall k, In k l -> exists e, numbered (points p2) k = Some e) ->
    exists k, find_all (Table.of_list Datatypes.id (above f)) l = Some k /\
      (forall x, In x (map spot k) -> flat n o x) /\ map sh (map spot k) = map spot2 l).
  { induction l as [|x l IH]; intros Known.
    - exists []. split; [reflexivity|]. split; [intros x []|reflexivity].
    - destruct IH as (k & Fa & Fl & M); [intros; apply Known; now right|].
      destruct (Known x (or_introl eq_refl)) as (e & E).
      destruct (above_spec x e E) as (j & J & Fj & Sj). exists (j :: k).
      cbn [find_all]. rewrite find_id, J, Fa. split; [reflexivity|]. split.
      + intros y [<-|I]; auto.
      + cbn [map]. now rewrite Sj, M. }
  intros l Known. destruct (G l Known) as (k & -> & Fl & M). auto.
Qed.
(** A point of its plane is in it if the picture is in a kept triangle. *)
Lemma polygon_at x : flat n o x -> polygon_points (polygon_of 3 D f) x <->
  exists t, In t (part_simplices 2 p2 part2) /\ conv t (sh x).
Proof.
  intros X. rewrite <- (plane_enclosed Enclosed p2 part2 plane_ok (sh x) eq_refl).
  unfold polygon_points.
  apply (enclosed_shadow (axis f) (plane_normal (polygon_of 3 D f))
    (plane_offset (polygon_of 3 D f)));
    unfold polygon_of; rewrite ?of_D; cbn [plane_normal plane_offset gaps].
  - exact polygon_seen.
  - intros y Y. pose proof (rim_shadow y Y) as R. unfold polygon_of in R. now rewrite of_D in R.
  - destruct polygon_parts as (_ & _ & _ & _ & _ & _ & _ & H). apply each_pair_accepted in H.
    destruct H as [L _]. intros y Iy. apply in_map_iff in Iy. destruct Iy as (s & <- & Is).
    apply in_numbered in Is. destruct Is as (k & Sk). symmetry in L.
    destruct (numbered_beside _ _ _ _ L Sk) as (h & Hk). destruct (seed_spec k h s Hk Sk) as [F S].
    split; [exact F|]. rewrite S. unfold part_holes.
    apply (in_map (fun h => seed_point 2 p2 (hole_point h) (hole_w h))).
    now apply numbered_in with k.
  - destruct polygon_parts as (_ & _ & _ & _ & _ & _ & _ & H). apply each_pair_accepted in H.
    destruct H as [L _]. intros y Iy. apply in_map_iff in Iy. destruct Iy as (h & <- & Ih).
    apply in_numbered in Ih. destruct Ih as (k & Hk).
    destruct (numbered_beside _ _ _ _ L Hk) as (s & Sk). destruct (seed_spec k h s Hk Sk) as [F S].
    exists (seed_point 3 c (fst s) (snd s)). split; [|exact S].
    apply (in_map (fun s => seed_point 3 c (fst s) (snd s))). now apply numbered_in with k.
  - exact X.
Qed.
Lemma polygon_is_flat x : polygon_points (polygon_of 3 D f) x -> flat n o x.
Proof. intros (F & _). unfold polygon_of in F. rewrite of_D in F. exact F. Qed.

Theorem polygon_covered q : polygon_points (polygon_of 3 D f) q <->
  exists u s, numbered (simplices p2) u = Some s /\ kept_at (mark_table part2) u = true /\
    conv (map spot (named_above (Table.of_list Datatypes.id (above f)) (corners s))) q.
Proof.
  split.
  - intros H. pose proof (polygon_is_flat q H) as X. apply (polygon_at q X) in H.
    destruct H as (t & It & C).
    apply (kept_members oriented2 plane_computes p2 (plane_mesh_accepted _ _ _ plane_ok) part2 true
      Enclosed _
      (plane_part_accepted _ _ _ plane_ok)) in It.
    destruct It as (u & s & E & K & ->). exists u, s. split; [assumption|]. split; [assumption|].
    destruct (named_spec u s E) as [Fl M].
    apply (conv_shadow (axis f) n o polygon_seen _ q Fl). rewrite M. auto.
  - intros (u & s & E & K & C). destruct (named_spec u s E) as [Fl M].
    apply (conv_shadow (axis f) n o polygon_seen _ q Fl) in C. destruct C as [X C].
    apply (polygon_at q X).
    rewrite M in C. exists (map spot2 (corners s)). split; [|assumption].
    apply (kept_members oriented2 plane_computes p2 (plane_mesh_accepted _ _ _ plane_ok) part2 true
      Enclosed _
      (plane_part_accepted _ _ _ plane_ok)). eauto.
Qed.

End Shape.

(** Its plane is one. *)
Lemma polygon_normal D f : check_shape (whole_mesh D) (mesh_of (whole_mesh D)) f = Accepted ->
  plane_normal (polygon_of 3 D f) <> origin.
Proof.
  intros Sh. destruct (polygon_parts _ f Sh) as (_ & _ & Ln & Ax & Nz & _).
  cbn [polygon_of plane_normal]. destruct (normal f) as [|a [|b [|e [|? ?]]]]; try discriminate Ln.
  intros E. apply Nz. pose proof (f_equal Vector.hd E) as E0.
  pose proof (f_equal Vector.tl E) as E'.
  pose proof (f_equal Vector.hd E') as E1.
  pose proof (f_equal Vector.hd (f_equal Vector.tl E')) as E2.
  cbn in E0, E1, E2. apply eq_IZR in E0, E1, E2. subst.
  destruct (axis f) as [|[|[|k]]]; [reflexivity..|lia].
Qed.
