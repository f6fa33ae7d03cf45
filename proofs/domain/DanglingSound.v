(** * Soundness: what the acceptance of a certificate means where something may dangle

    What it says of polygons and segments is what [DanglingMesh.v] asks for. *)
From Coq Require Import Rbase Rfunctions List Arith Lia ZArith Bool.
From Circumspect Require Import DomainChecker Numbering.
From Circumspect Require Import Orientation Integers Accepted KeptMesh KeptCells Pieces.
From Circumspect Require Import DanglingMesh Definitions Domains.
Import ListNotations.
Open Scope R_scope.

(** ** In the plane *)

Theorem plane_dangling c : check_dangling Plane c = Accepted ->
  holds_of_complex (domain_claimed c) (domain_of_certificate 2 c) (mesh_with_faces 2 c).
Proof.
  intros H. unfold check_dangling in H. cbv zeta in H. accepted.
  assert (K : kind c = Enclosed) by (destruct (kind c); [reflexivity|discriminate]).
  assert (No : polygons c = []) by (destruct (polygons c); [reflexivity|discriminate]).
  unfold mesh_with_faces, faces_of_domain. rewrite No. cbn [flat_map app].
  rename Heqr into Mesh. rename Heqr0 into Pa.
  assert (Walls : forall q, on_segments (part_segments 2 (whole_mesh c) (domain_part c)) q <->
    flagged_points (d := 2) (whole_mesh c) (domain_part c) q).
  { intros q. now apply (flagged_segments (kind c) (whole_mesh c) (domain_part c) Mesh Pa). }
  apply (dangling_claims oriented2 plane_computes (le_n 2) c Mesh true _ Pa K [] _)
    with (walls := on_segments (part_segments 2 (whole_mesh c) (domain_part c))).
  - intros x [].
  - reflexivity.
  - reflexivity.
  - cbn [domain_of_certificate domain_polygons]. rewrite No. intros f [].
  - intros s [].
  - exact Walls.
  - exists (part_steps 2 (whole_mesh c) (domain_part c)). split.
    + intros s Is. cbn [app]. apply in_or_app. now left.
    + intros q. split.
      * intros (a & b & I & C). apply in_map_iff in I. destruct I as (g & E & Ig).
        pose proof (segment_covered plane_computes _ Mesh _ true _ _ Pa g Ig q) as Co.
        rewrite E in Co. apply Co in C. destruct C as (y & Iy & C).
        exists (map (spot 2 (whole_mesh c)) y). split; [|assumption]. apply in_flat_map.
        exists g. split; [assumption|now apply in_map].
      * intros (s & Is & C). apply in_flat_map in Is. destruct Is as (g & Ig & Is).
        apply in_map_iff in Is. destruct Is as (y & <- & Iy).
        exists (fst (segment_ends 2 (whole_mesh c) g)), (snd (segment_ends 2 (whole_mesh c) g)).
        split; [rewrite <- surjective_pairing; now apply in_map|].
        apply (segment_covered plane_computes _ Mesh _ true _ _ Pa g Ig). eauto.
  - intros q. unfold region. cbn [domain_of_certificate what_it_fills]. rewrite K. reflexivity.
  - assumption.
  - assumption.
  - intros q W. apply Walls in W. destruct W as (a & b & I & C).
    exists (fun q => conv [fst (a, b); snd (a, b)] q). split; [|split; [exact C|]].
    + unfold cells. apply in_or_app. right. apply in_or_app. left.
      apply (in_map (fun ab q => conv [fst ab; snd ab] q)). exact I.
    + intros y Y. apply Walls. exists a, b. split; [exact I|exact Y].
  - intros _ s v [].
  - intros _ s [].
Qed.

(** ** In space *)

Section Space.
Variable c : domain_certificate.
Hypothesis accepts : check_dangling Space c = Accepted.
Notation mesh := (whole_mesh c).
Notation p := (domain_part c).
Notation P := (domain_of_certificate 3 c).
Notation shown := (shown_by_polygon (Table.of_list tables_of (polygons c))).
Let one_3 : (1 <= 3)%nat := le_S 1 2 (le_S 1 1 (le_n 1)).

Lemma space_conditions : kind c = Enclosed /\ check_in space_predicates mesh = Accepted /\
  check_part space_predicates true false (kind c) mesh p shown = Accepted /\
  (forall k f, numbered (polygons c) k = Some f -> check_polygon (triangles_may_dangle c) (kind c)
    mesh (mesh_of mesh) (mark_table p) f = Accepted) /\
  check_claim space_predicates shown c = Accepted /\ check_faces c = Accepted.
Proof.
  pose proof accepts as H. unfold check_dangling in H. cbv zeta in H. accepted.
  split; [destruct (kind c); [reflexivity|discriminate]|].
  split; [assumption || reflexivity|]. split; [assumption || reflexivity|]. split.
  - intros k f E.
    match goal with G : each _ 1 (polygons c) = Accepted |- _ => apply
      (each_accepted _ _ G) in E end.
    unfold in_polygon in E. destruct (check_polygon _ _ _ _ _ f); [reflexivity|discriminate].
  - split; [assumption || reflexivity|assumption].
Qed.
Let K := proj1 space_conditions.
Let Mesh := proj1 (proj2 space_conditions).
Let Pa := proj1 (proj2 (proj2 space_conditions)).
Let Poly := proj1 (proj2 (proj2 (proj2 space_conditions))).

Lemma polygon_entry_of f : In f (domain_polygons P) -> exists k g,
  numbered (polygons c) k = Some g /\ f = polygon_of 3 c g.
Proof.
  intros I. apply in_map_iff in I. destruct I as (g & <- & I). apply in_numbered in I.
  destruct I as (k & E). eauto.
Qed.
Lemma piece_entry s : In s (flat_map (pieces_of 3 c) (polygons c)) -> exists k g,
  numbered (polygons c) k = Some g /\ In s (pieces_of 3 c g).
Proof.
  intros I. apply in_flat_map in I. destruct I as (g & I & Is). apply in_numbered in I.
  destruct I as (k & E). eauto.
Qed.
Lemma pieces_of_polygon k g q : numbered (polygons c) k = Some g ->
  polygon_points (polygon_of 3 c g) q <-> exists s, In s (pieces_of 3 c g) /\ conv s q.
Proof. intros E. exact (pieces_cover (kind c) mesh p Mesh c eq_refl g (Poly k g E) q). Qed.
Lemma piece_facet k g s : numbered (polygons c) k = Some g -> In s (pieces_of 3 c g) ->
  NoDup s /\ length s = 3%nat /\ exists t i e, numbered (simplices mesh) t = Some e /\
    (triangles_may_dangle c = false -> kept_at (mark_table p) t = true) /\ (i <= 3)%nat /\
    (kind c = Enclosed -> flagged_at (mark_table p) t i = true) /\
    same s (map (spot 3 mesh) (Checker.remove i (corners e))).
Proof. intros E. exact (piece_in_facet (kind c) mesh p Mesh c eq_refl g (Poly k g E) s). Qed.
Lemma facet_corners i e : incl (map (spot 3 mesh) (Checker.remove i (corners e)))
  (map (spot 3 mesh) (corners e)).
Proof.
  intros v Iv. apply in_map_iff in Iv. destruct Iv as (j & <- & Ij). apply in_map.
  apply in_remove in Ij. destruct Ij as (a & _ & Ij). now apply nth_error_In with a.
Qed.
Lemma polygons_flagged q : (exists f, In f (domain_polygons P) /\ polygon_points f q) <->
  flagged_points (d := 3) mesh p q.
Proof.
  split.
  - intros (f & I & H). destruct (polygon_entry_of f I) as (k & g & E & ->).
    exact (polygon_flagged (kind c) mesh p Mesh c eq_refl g (Poly k g E) q K H).
  - intros (t & e & i & E & Hi & Fl & C).
    destruct (flagged_is_shown oriented3 space_computes one_3 _ Mesh _ false _ _ Pa t e i K E Hi Fl)
      as (w & Sh).
    destruct (shown_piece c Mesh (triangles_may_dangle c) Poly _ i w Sh) as (g & Ig & W).
    exists (polygon_of 3 c g). split; [now apply (in_map (polygon_of 3 c))|now apply W].
Qed.
Lemma polygons_listed q : (exists f, In f (domain_polygons P) /\ polygon_points f q) <->
  exists s, In s (flat_map (pieces_of 3 c) (polygons c)) /\ conv s q.
Proof.
  split.
  - intros (f & I & H). destruct (polygon_entry_of f I) as (k & g & E & ->).
    apply (pieces_of_polygon k g q E) in H. destruct H as (s & Is & C). exists s.
    split; [|assumption]. apply in_flat_map. exists g.
    split; [now apply numbered_in with k|assumption].
  - intros (s & Is & C). destruct (piece_entry s Is) as (k & g & E & Ig).
    exists (polygon_of 3 c g).
    split; [apply (in_map (polygon_of 3 c)); now apply numbered_in with k|].
    apply (pieces_of_polygon k g q E). eauto.
Qed.

Theorem space_dangling : holds_of_complex (domain_claimed c) P (mesh_with_faces 3 c).
Proof.
  pose proof (proj1 (proj2 (proj2 (proj2 (proj2 space_conditions))))) as Cl.
  pose proof (proj2 (proj2 (proj2 (proj2 (proj2 space_conditions))))) as Fa.
  apply (dangling_claims oriented3 space_computes (le_S 2 2 (le_n 2)) c Mesh false _ Pa K
    (flat_map (pieces_of 3 c) (polygons c)) P)
    with (walls := fun q => exists f, In f (domain_polygons P) /\ polygon_points f q).
  - intros s Is. destruct (piece_entry s Is) as (k & g & E & Ig).
    destruct (piece_facet k g s E Ig) as (N & L & t & i & e & Ee & _ & _ & _ & S & _).
    split; [assumption|]. split; [now intros ->|]. split; [lia|]. exists t, e.
    split; [assumption|]. eapply incl_tran; [exact S|apply facet_corners].
  - reflexivity.
  - reflexivity.
  - intros f I. destruct (polygon_entry_of f I) as (k & g & E & ->). exists (pieces_of 3 c g).
    split; [|intros q; exact (pieces_of_polygon k g q E)]. intros s Is. apply in_flat_map.
    exists g. split; [now apply numbered_in with k|assumption].
  - intros s Is. destruct (piece_entry s Is) as (k & g & E & Ig). exists (polygon_of 3 c g).
    split; [apply (in_map (polygon_of 3 c)); now apply numbered_in with k|].
    intros q C. apply (pieces_of_polygon k g q E). eauto.
  - exact polygons_flagged.
  - exists (flat_map (pieces_of 3 c) (polygons c)). split; [|exact polygons_listed].
    intros s Is. apply in_or_app. now left.
  - intros q. unfold region. cbn [domain_of_certificate what_it_fills]. rewrite K. reflexivity.
  - exact Cl.
  - exact Fa.
  - intros q W. apply polygons_flagged in W. destruct W as (f & I & C). exists (polygon_points f).
    split; [|split; [exact C|]].
    + unfold cells. rewrite !in_app_iff. right. right. left. now apply in_map.
    + intros y Y. apply polygons_flagged. eauto.
  - intros KF s v Is Iv. destruct (piece_entry s Is) as (k & g & E & Ig).
    destruct (faces_known c KF) as [_ Ab].
    apply in_flat_map in Ig. destruct Ig as ((h & mk) & Ih & Ig). cbn [fst snd] in Ig.
    destruct (kept mk); [|destruct Ig]. destruct Ig as [<-|[]]. apply in_map_iff in Iv.
    destruct Iv as (j & <- & Ij). apply in_combine_l, in_numbered in Ih. destruct Ih as (n & En).
    destruct (piece_point c (triangles_may_dangle c) g (Poly k g E) n h j En Ij)
      as (i & Ei & -> & Q).
    apply (corner_in mesh p false (kind c) shown Pa); [|exact Q].
    apply (Ab g (numbered_in _ _ _ E)). now apply numbered_in with j.
  - intros Ti s Is. destruct (piece_entry s Is) as (k & g & E & Ig).
    destruct (piece_facet k g s E Ig) as (_ & _ & t & i & e & Ee & Kt & _ & _ & S & _).
    exists (map (spot 3 mesh) (corners e)). split.
    + apply (kept_members oriented3 space_computes mesh Mesh p false (kind c) _ Pa). exists t, e.
      auto.
    + eapply incl_tran; [exact S|apply facet_corners].
Qed.
End Space.

Theorem check_dangling_sound D c : check_dangling D c = Accepted ->
  holds_of_complex (domain_claimed c) (domain_of_certificate (dimension_of D) c)
    (mesh_with_faces (dimension_of D) c).
Proof. destruct D; [apply plane_dangling|apply space_dangling]. Qed.
