(** * On one side only: the boundary of what is kept

    From a point of the kept simplices one gets away at once through a facet beyond which none is
    kept.  Such a facet is in a wall, and a wall has all its facets so, or none: so the boundary of
    what is kept is a union of walls. *)
From Coq Require Import Rbase Rfunctions Lra List Arith Lia ZArith Bool.
From Circumspect Require Import ComplexChecker Numbering.
From Circumspect Require Import Vectors Affine Frame Matched Faces Facets Mesh Adjacency Enclosed
  Boundary.
From Circumspect Require Import Combinations Shadow Orientation Integers Accepted CertifiedMesh
  Soundness.
From Circumspect Require Import KeptMesh KeptCells Pieces Definitions Domains.
Import ListNotations.
Open Scope R_scope.

(** From [q] one gets at once out of [X], and stays in [flat]. *)
Definition leaving {d} (flat X : point d -> Prop) (q : point d) : Prop :=
  exists r, flat r /\ forall s, 0 < s <= 1 -> ~ X (between q r s).
Definition filled {d} (T : list (simplex d)) (q : point d) : Prop := exists t, In t T /\ conv t q.

Section Sides.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis Or : oriented orient.
Hypothesis Co : computes orient pr.
Hypothesis positive_d : (1 <= d)%nat.
Variable c : certificate.
Hypothesis accepts : check_in pr c = Accepted.
Variable p : part.
Variable planar : bool.
Variable shown : list positive -> nat -> positive * positive -> bool.
Hypothesis part_accepts : check_part pr false planar Enclosed c p shown = Accepted.

Notation spot := (spot d c).
Notation entry t e := (numbered (simplices c) t = Some e).
Notation marks_of := (Table.of_list Datatypes.id (marks p)).
Notation T := (part_simplices d c p).

Lemma leaving_facet q : filled T q -> leaving (fun _ => True) (filled T) q <->
  exists t e i, entry t e /\ (i <= d)%nat /\ kept_at marks_of t = true /\
    exposed_at marks_of e i = true /\
    conv (map spot (Checker.remove i (corners e))) q.
Proof.
  intros Fq. destruct (frames_exist Or Co c accepts) as (geo & G).
  assert (Inner : forall x, in_inner (tets c) geo (kept_at marks_of) x <-> filled T x).
  { intros x. split.
    - intros (t & Ht & K & I). apply in_tets in Ht. destruct Ht as (e & E).
      exists (map spot (corners e)). split.
      + apply (kept_members Or Co c accepts p planar Enclosed shown part_accepts). eauto.
      + rewrite <- (entry_vertices c geo G t e E). now apply conv_vertices.
    - intros (s & I & C).
      apply (kept_members Or Co c accepts p planar Enclosed shown part_accepts) in I.
      destruct I as (t & e & E & K & ->). exists t. split; [apply in_tets; eauto|].
      split; [assumption|].
      rewrite <- (entry_vertices c geo G t e E) in C. now apply conv_vertices. }
  assert (Ex : forall t e i, entry t e -> (i <= d)%nat ->
    exposed (tets c) geo (kept_at marks_of) t i <-> exposed_at marks_of e i = true).
  { intros t e i E Hi. assert (Ht : In t (tets c)) by (apply in_tets; eauto).
    unfold exposed, exposed_at.
    destruct (wall_exists Co positive_d c accepts t e i E Hi) as (f & W). rewrite W.
    destruct f as [u j|h].
    - assert (A : adj c t i u j) by now exists e. split.
      + intros [O|(u' & j' & A' & K)].
        * exfalso. apply (O u j). now apply (adjacent_adj Or Co positive_d c accepts geo G).
        * apply (adjacent_adj Or Co positive_d c accepts geo G) in A'.
          destruct A' as (e' & E' & W').
          assert (e' = e) by congruence. subst e'. assert (u' = u) by congruence. subst u'.
          now rewrite K.
      + intros K. right. exists u, j. split; [|now apply negb_true_iff].
        now apply (adjacent_adj Or Co positive_d c accepts geo G).
    - split; [reflexivity|]. intros _. left.
      apply (outer_on_hull Or Co positive_d c accepts geo G t i Ht Hi).
      unfold on_hull. now rewrite E, W. }
  pose proof (boundary_facets (tets c) geo (points_of_certificate d c) positive_d
    (certificate_fills Or Co c accepts geo G) (kept_at marks_of) q (proj2 (Inner q) Fq)) as B.
  transitivity (exists r, forall s, 0 < s <= 1 ->
    ~ in_inner (tets c) geo (kept_at marks_of) (between q r s)).
  { split.
    - intros (r & _ & H). exists r. intros s Hs N. apply (H s Hs). now apply Inner.
    - intros (r & H). exists r. split; [exact Logic.I|]. intros s Hs N. apply (H s Hs).
      now apply Inner. }
  rewrite B. split.
  - intros (t & i & Ht & Hi & K & X & O). apply in_tets in Ht. destruct Ht as (e & E).
    exists t, e, i.
    split; [assumption|]. split; [assumption|]. split; [assumption|].
    split; [now apply (Ex t e i)|].
    now apply (on_facet_entry Co positive_d c geo G t e).
  - intros (t & e & i & E & Hi & K & X & C). exists t, i. split; [apply in_tets; eauto|].
    split; [assumption|].
    split; [assumption|]. split; [now apply (Ex t e i)|].
    now apply (on_facet_entry Co positive_d c geo G t e).
Qed.

Lemma exposed_flagged t e i : entry t e -> (i <= d)%nat -> kept_at marks_of t = true ->
  exposed_at marks_of e i = true -> exists k f w, numbered (marks p) t = Some k /\
    nth_error (walls e) i = Some f /\
    kept k = true /\ flag k i = Some w /\ shown (corners e) i w = true.
Proof.
  intros E Hi K X. destruct (wall_exists Co positive_d c accepts t e i E Hi) as (f & W).
  destruct (facet_checked c p planar Enclosed shown part_accepts eq_refl t e i f E W)
    as (k & Ek & Kt & C & _ & Sh).
  exists k, f. unfold exposed_at in X. rewrite W in X. rewrite Kt in K.
  destruct (flag k i) as [w|] eqn:Fl; [exists w; auto 6|exfalso].
  destruct f as [u j|h]; cbn [consistent] in C; rewrite Fl, K in C; [|discriminate].
  unfold kept_at in X. rewrite find_id in X, C.
  destruct (numbered (marks p) u) as [k'|]; [|discriminate].
  destruct (flag k' j); [discriminate|]. destruct (kept k'); discriminate.
Qed.

Variable sides : list bool.
Hypothesis sides_accept : check_sides_of c p sides = Accepted.
Notation sides_of := (Table.of_list Datatypes.id sides).

Lemma sided_spec n t e i : entry t e -> sided (mesh_of c) marks_of sides_of n t i = true ->
  numbered sides n = Some (exposed_at marks_of e i).
Proof.
  intros E H. unfold sided in H. rewrite find_id, (find_simplex (c := c)), E in H.
  destruct (numbered sides n) as [b|]; [|discriminate]. apply Bool.eqb_prop in H. now rewrite H.
Qed.
Lemma flagged_side t e i k f w : entry t e -> numbered (marks p) t = Some k ->
  nth_error (walls e) i = Some f ->
  kept k = true -> flag k i = Some w -> numbered sides (fst w) = Some (exposed_at marks_of e i).
Proof.
  intros E Ek W K Fl. pose proof sides_accept as H. unfold check_sides_of in H. cbv zeta in H.
  apply each_pair_accepted in H. destruct H as [_ H]. specialize (H t e k E Ek).
  unfold check_sides in H.
  rewrite K in H. apply (each_index_accepted _ _ H) in W. cbv beta in W. rewrite Fl in W. accepted.
  now apply (sided_spec (fst w) t e i).
Qed.
End Sides.

(** ** In the plane *)

Section Plane.
Variables (c : certificate) (p : part) (sides : list bool).
Hypothesis accepts : check_in_plane Enclosed c p = Accepted.
Hypothesis sides_accept : check_plane_sides c p sides = Accepted.
Let mesh_ok := plane_mesh_accepted _ _ _ accepts.
Let part_ok := plane_part_accepted _ _ _ accepts.
Let two : (1 <= 2)%nat := le_S 1 1 (le_n 1).
Notation T := (part_simplices 2 c p).

Theorem plane_boundary q : filled T q -> leaving (fun _ => True) (filled T) q ->
  exists n s, numbered (segments p) n = Some s /\
    conv [fst (segment_ends 2 c s); snd (segment_ends 2 c s)] q /\
    forall x, conv [fst (segment_ends 2 c s); snd (segment_ends 2 c s)] x ->
      filled T x /\ leaving (fun _ => True) (filled T) x.
Proof.
  assert (Both : check_sides_of c p sides = Accepted /\
    each (check_links (mesh_of c) (mark_table p) (Table.of_list Datatypes.id sides)) 1
      (segments p) = Accepted).
  { pose proof sides_accept as H. unfold check_plane_sides in H. accepted. auto. }
  destruct Both as [Sd Ln]. intros Fq L.
  apply (leaving_facet oriented2 plane_computes two c mesh_ok p true _ part_ok q Fq) in L.
  destruct L as (t & e & i & E & Hi & K & X & C).
  destruct (exposed_flagged plane_computes two c mesh_ok p true _ part_ok t e i E Hi K X)
    as (k & f & w & Ek & W & Kk & Fl & Sh).
  destruct (shown_segment _ _ _ accepts _ _ _ Sh) as (s & Es & In_s).
  exists (fst w), s. split; [assumption|]. split; [now apply In_s|].
  pose proof (flagged_side c p sides Sd t e i k f w E Ek W Kk Fl) as B. rewrite X in B.
  intros x Cx. assert (Is : In s (segments p)) by now apply numbered_in with (fst w).
  apply (segment_covered plane_computes c mesh_ok p true Enclosed _ part_ok s Is) in Cx.
  destruct Cx as (y & Iy & Cx).
  destruct (step_edge c p true Enclosed _ part_ok s y Is Iy) as (u & l & -> & Il & Ed).
  apply (edge_spec plane_computes c mesh_ok p true Enclosed _ part_ok) in Ed.
  destruct Ed as (e' & E' & K' & _ & _ & _ & Fl'). destruct (Fl' eq_refl eq_refl) as (Hi' & _ & M).
  assert (Cx' : conv (map (spot 2 c) (Checker.remove (link_facet l) (corners e'))) x).
  { apply (conv_incl (map (spot 2 c) [u; reached l])); [|assumption]. intros v Iv.
    apply in_map_iff in Iv. destruct Iv as (j & <- & Ij). now apply in_map, M. }
  assert (Fx : filled T x).
  { exists (map (spot 2 c) (corners e')). split.
    - apply (kept_members oriented2 plane_computes c mesh_ok p true Enclosed _ part_ok).
      exists (link_simplex l), e'. auto.
    - apply (conv_incl (map (spot 2 c) (Checker.remove (link_facet l) (corners e'))));
        [|assumption].
      intros v Iv. apply in_map_iff in Iv. destruct Iv as (j & <- & Ij). apply in_map.
      apply in_remove in Ij. destruct Ij as (a & _ & Ij). now apply nth_error_In with a. }
  split; [assumption|].
  apply (leaving_facet oriented2 plane_computes two c mesh_ok p true _ part_ok x Fx).
  exists (link_simplex l), e', (link_facet l). specialize (K' eq_refl).
  repeat (split; [assumption|]). split; [|assumption].
  apply (each_accepted _ _ Ln) in Es. unfold check_links in Es. accepted.
  rewrite forallb_forall in Heqb.
  specialize (Heqb l Il). apply (sided_spec c p sides _ _ e' _ E') in Heqb. congruence.
Qed.
End Plane.

(** ** Polygons *)

Section Polygon.
Variables (kind : domain_kind) (c : certificate) (p : part).
Hypothesis accepts : check_in space_predicates c = Accepted.
Variable D : domain_certificate.
Hypothesis of_D : whole_mesh D = c.
Variable f : polygon_entry.
Hypothesis polygon_accepts : check_polygon false kind c (mesh_of c) (mark_table p) f = Accepted.
Variable sides : list bool.
Hypothesis sides_accept : check_plane_sides (plane_mesh f) (plane_part f) sides = Accepted.
Notation P := (polygon_of 3 D f).
Notation in_plane := (fun q => inner (plane_normal P) q = plane_offset P).
Notation up := (spot_above 3 c f).

Lemma in_plane_flat q : in_plane q <->
  flat (integer_point 3 (normal f)) (unit_of c * IZR (offset f)) q.
Proof. unfold polygon_of. rewrite of_D. reflexivity. Qed.

Theorem polygon_boundary q : polygon_points P q -> leaving in_plane (polygon_points P) q ->
  exists n s, numbered (segments (plane_part f)) n = Some s /\
    conv [up (from s); up (last_reached s)] q /\
    forall x, conv [up (from s); up (last_reached s)] x ->
      polygon_points P x /\ leaving in_plane (polygon_points P) x.
Proof.
  set (n3 := integer_point 3 (normal f)). set (o3 := unit_of c * IZR (offset f)).
  set (sh := shadow (axis f)).
  pose proof (shape_ok kind c p f polygon_accepts) as shape.
  pose proof (polygon_seen c f shape) as Seen.
  assert (At : forall x, flat n3 o3 x -> polygon_points P x <->
    filled (part_simplices 2 (plane_mesh f) (plane_part f)) (sh x)).
  { intros x X. exact (polygon_at c (spots_known c accepts) D of_D f shape x X). }
  pose proof (polygon_is_flat c D of_D f) as Fl.
  intros Pq (r & Hr & Away). apply in_plane_flat in Hr. pose proof (Fl q Pq) as Fq.
  destruct (plane_boundary (plane_mesh f) (plane_part f) sides (plane_ok c f shape) sides_accept
    (sh q))
    as (n & s & E & C & H).
  { now apply At. }
  { exists (sh r). split; [exact Logic.I|]. intros s Hs N. apply (Away s Hs).
    apply At; [now apply flat_between|].
    unfold sh in *. now rewrite shadow_between. }
  assert (Rs : forall x, conv [up (from s); up (last_reached s)] x <->
    flat n3 o3 x /\ conv [fst (segment_ends 2 (plane_mesh f) s);
      snd (segment_ends 2 (plane_mesh f) s)] (sh x)).
  { apply (rim_segment c (spots_known c accepts) f shape s). now apply numbered_in with n. }
  exists n, s. split; [assumption|]. split; [now apply Rs|]. intros x Cx. apply Rs in Cx.
  destruct Cx as [Fx Cx].
  destruct (H (sh x) Cx) as [Px (r2 & _ & Away2)]. split; [now apply At|].
  exists (raised (axis f) n3 o3 r2).
  assert (Fr : flat n3 o3 (raised (axis f) n3 o3 r2)) by now apply raised_flat.
  split; [now apply in_plane_flat|]. intros s' Hs N. apply (Away2 s' Hs).
  apply (At (between x (raised (axis f) n3 o3 r2) s')) in N; [|now apply flat_between].
  unfold sh in N. rewrite shadow_between, shadow_raised in N. exact N.
Qed.
End Polygon.
