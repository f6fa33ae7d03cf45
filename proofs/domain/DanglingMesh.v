(** * Meshes in which something may dangle: faces of the mesh of the whole hull

    The kept simplices, the pieces of polygons, the steps along segments and the vertices of the
    domain are faces of one complex, the mesh of the whole hull.  Each cell is covered by some of
    them, and each of them is in a cell: so they are a Steiner triangulation ([steiner_from_faces]).
    What a kept simplex sees is a vertex of a kept one, for sight does not pass a wall
    ([Constrained.v]). *)
From Coq Require Import Rbase Rfunctions Lra List Arith Lia ZArith Bool.
From Circumspect Require Import DomainChecker Numbering.
From Circumspect Require Import Vectors Frame Faces Combinations Orientation Integers Accepted.
From Circumspect Require Import Soundness CertifiedMesh KeptMesh KeptCells Pieces.
From Circumspect Require Import ConstrainedLemma Constrained DomainSound Definitions Domains.
Import ListNotations.
Open Scope R_scope.

(** ** Faces of a complex that cover the cells *)

Lemma pairs_apart {d} (T R : list (simplex d)) : (forall t, In t T -> NoDup t /\ length t = S d) ->
  ForallOrdPairs (fun s t => ~ same s t) T -> (forall s, In s R -> (length s <= d)%nat) ->
  ForallOrdPairs (fun s t => length s = S d -> ~ same s t) (T ++ R).
Proof.
  intros K D L. induction T as [|t T IH]; cbn [app].
  - clear K D. induction R as [|s R IH]; constructor.
    + apply Forall_forall. intros u _ Ls. specialize (L s (or_introl eq_refl)). lia.
    + apply IH. intros u I. apply L. now right.
  - inversion D as [|? ? D1 D2]; subst. constructor; [|apply IH; [intros; apply K;
      now right|exact D2]].
    apply Forall_forall. intros u Iu _. apply in_app_or in Iu. destruct Iu as [Iu|Iu].
    + rewrite Forall_forall in D1. now apply D1.
    + intros [Sub _]. destruct (K t (or_introl eq_refl)) as [N Lt].
      pose proof (NoDup_incl_length N Sub). specialize (L u Iu). lia.
Qed.

Section Faces.
Context {d : nat}.
Variables (P : domain d) (A T R : list (simplex d)).
Hypothesis one_complex : simplicial_complex (faces_of A).
Hypothesis kept_shape : forall t, In t T -> NoDup t /\ length t = S d.
Hypothesis kept_once : ForallOrdPairs (fun s t => ~ same s t) T.
Hypothesis lower : forall s, In s R -> (length s <= d)%nat.
Hypothesis all_faces : forall s, In s (T ++ R) -> faces_of A s.
Hypothesis vertices_listed : forall v, In v (domain_vertices P) -> In [v] R.
Hypothesis cells_covered : forall X, In X (cells P) -> exists F, incl F (T ++ R) /\
  forall q, X q <-> exists s, In s F /\ conv s q.
Hypothesis in_cells : forall s q, In s (T ++ R) -> conv s q -> underlying P q.

Lemma listed_face s : In s (T ++ R) -> faces_of (T ++ R) s.
Proof.
  intros I. destruct (all_faces s I) as (N & E & _). split; [assumption|]. split; [assumption|].
  exists s. split; [assumption|apply incl_refl].
Qed.
Lemma faces_complex : simplicial_complex (faces_of (T ++ R)).
Proof.
  assert (Sub : forall s, faces_of (T ++ R) s -> faces_of A s).
  { intros s (N & E & t & It & Is). destruct (all_faces t It) as (_ & _ & u & Iu & It').
    split; [assumption|]. split; [assumption|]. exists u. split; [assumption|].
    now apply incl_tran with t. }
  destruct one_complex as (Ind & _ & Meet). split; [|split].
  - auto.
  - intros s f (_ & _ & t & It & Is) If N E. split; [assumption|]. split; [assumption|]. exists t.
    split; [assumption|]. now apply incl_tran with s.
  - auto.
Qed.
Lemma cells_unions X : In X (cells P) -> union_of_simplices (T ++ R) X.
Proof.
  intros IX. destruct (cells_covered X IX) as (F & IF & E). exists F. split; [|assumption].
  intros s Is. now apply listed_face, IF.
Qed.

Theorem steiner_from_faces : steiner_triangulation P (T ++ R).
Proof.
  split; [|split; [|split; [|split; [|split]]]].
  - intros s I. destruct (all_faces s I) as (N & E & _). split; [assumption|].
    split; [assumption|].
    apply in_app_or in I. destruct I as [I|I]; [apply kept_shape in I; lia|apply lower in I; lia].
  - now apply pairs_apart.
  - exact faces_complex.
  - intros v Iv. exists [v]. split; [apply in_or_app; right; auto|now left].
  - exact cells_unions.
  - intros q. split; [|intros (s & I & C); now apply (in_cells s)]. intros (X & IX & Xq).
    destruct (cells_covered X IX) as (F & IF & E). apply E in Xq. destruct Xq as (s & Is & C).
    exists s. split; [now apply IF|assumption].
Qed.
Lemma listed_respects s : In s (T ++ R) -> respects P s.
Proof.
  intros I. split; [intros q C; now apply (in_cells s)|]. intros X IX.
  apply (union_respected (T ++ R)); [exact faces_complex|now apply cells_unions|].
  now apply listed_face.
Qed.
End Faces.

(** ** An accepted certificate *)

Section Certified.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis Or : oriented orient.
Hypothesis Co : computes orient pr.
Hypothesis two_d : (2 <= d)%nat.
Let positive_d : (1 <= d)%nat := le_S_n _ _ (le_S _ _ two_d).
Variable D : domain_certificate.
Notation c := (whole_mesh D).
Notation p := (domain_part D).
Notation spot := (spot d c).
Notation entry t e := (numbered (simplices c) t = Some e).
Hypothesis accepts : check_in pr c = Accepted.
Variables (planar : bool) (shown : list positive -> nat -> positive * positive -> bool).
Hypothesis part_accepts : check_part pr true planar (kind D) c p shown = Accepted.
Hypothesis is_enclosed : kind D = Enclosed.
Notation A := (simplices_of_certificate d c).
Notation T := (part_simplices d c p).
Let dim_d : dimension pr = d := computes_dimension _ _ Co.
Let members := kept_members Or Co c accepts p planar (kind D) shown part_accepts.

(** Where a face of the mesh is. *)
Definition at_entry (s : simplex d) : Prop :=
  exists t e, entry t e /\ incl s (map spot (corners e)).
Lemma entry_in t e : entry t e -> In (map spot (corners e)) A.
Proof.
  intros E. unfold simplices_of_certificate.
  apply (in_map (fun e => map (Definitions.spot d c) (corners e))). now apply numbered_in with t.
Qed.
Lemma entry_face s : NoDup s -> s <> [] -> at_entry s -> faces_of A s.
Proof.
  intros N E (t & e & Ee & I). split; [assumption|]. split; [assumption|].
  exists (map spot (corners e)). split; [now apply entry_in with t|assumption].
Qed.
Lemma whole_triangulation : triangulation (points_of_certificate d c) A.
Proof.
  pose proof (check_in_sound Or Co c accepts) as H.
  destruct (part_parts c p planar (kind D) shown part_accepts) as (W & _).
  destruct (claimed c); [exact H|exact (proj1 H)|discriminate].
Qed.
Lemma whole_complex : simplicial_complex (faces_of A).
Proof. apply whole_triangulation. Qed.

Lemma kept_at_entry t : In t T -> NoDup t /\ t <> [] /\ at_entry t.
Proof.
  intros It. destruct (kept_complex Or Co c accepts p planar (kind D) shown part_accepts) as
    (Sh & _).
  destruct (Sh t It) as [N L]. split; [assumption|]. split; [now intros ->|].
  apply members in It. destruct It as (u & e & E & _ & ->). exists u, e.
  split; [assumption|apply incl_refl].
Qed.
Lemma step_at_entry x : In x (part_steps d c p) -> NoDup x /\ length x = 2%nat /\ at_entry x.
Proof.
  intros Ix. apply in_flat_map in Ix. destruct Ix as (s & Is & Ix). apply in_map_iff in Ix.
  destruct Ix as (y & <- & Iy).
  destruct (step_edge c p planar (kind D) shown part_accepts s y Is Iy) as (u & l & -> & _ & K).
  apply (edge_spec Co c accepts p planar (kind D) shown part_accepts) in K.
  destruct K as (e & E & _ & N & U & V & _). destruct (frames_exist Or Co c accepts) as (geo & G).
  split; [|split; [reflexivity|]].
  - constructor; [|constructor; [intros []|constructor]]. intros [X|[]].
    now apply (corner_spots Co positive_d c geo G _ e u (reached l) E U V N).
  - exists (link_simplex l), e. split; [assumption|]. intros v [<-|[<-|[]]]; now apply in_map.
Qed.
Lemma corner_at_entry v : In v (part_vertices d c p) -> at_entry [v].
Proof.
  intros I. apply (in_part_vertices c p planar (kind D) shown part_accepts) in I.
  destruct I as (k & e & t & E & K & ->).
  destruct (part_parts c p planar (kind D) shown part_accepts) as (_ & H & _).
  apply each_pair_accepted in H. destruct H as [_ H].
  specialize (H k e _ E K). unfold check_role in H. accepted. apply andb_prop in Heqb.
  destruct Heqb as [_ M]. rewrite (find_simplex (c := c)) in M.
  destruct (numbered (simplices c) t) as [s|] eqn:Es; [|discriminate].
  exists t, s. split; [assumption|]. intros y [<-|[]]. apply in_map. now apply member_in.
Qed.

(** The pieces of the polygons; in the plane there are none. *)
Variable F : list (simplex d).
Notation singles := (map (fun v : point d => [v]) (part_vertices d c p)).
Notation low := (F ++ part_steps d c p ++ singles).
Variable P : domain d.
Hypothesis pieces_at_entries : forall x, In x F -> NoDup x /\ x <> [] /\ (length x <= d)%nat /\
  at_entry x.
Hypothesis same_vertices : domain_vertices P = part_vertices d c p.
Hypothesis same_segments : domain_segments P = part_segments d c p.
Hypothesis polygons_covered : forall f, In f (domain_polygons P) -> exists L, incl L F /\
  forall q, polygon_points f q <-> exists s, In s L /\ conv s q.
Hypothesis pieces_in_polygons : forall s, In s F -> exists f, In f (domain_polygons P) /\
  within (conv s) (polygon_points f).
Variable walls : point d -> Prop.
Hypothesis walls_flagged : forall q, walls q <-> flagged_points (d := d) c p q.
Hypothesis walls_listed : exists L, incl L low /\
  forall q, walls q <-> exists s, In s L /\ conv s q.
Hypothesis region_is : forall q,
  region P q <-> enclosed (fun _ => True) walls (part_holes d c p) q.

Lemma listed_at_entry s : In s (T ++ low) -> NoDup s /\ s <> [] /\ at_entry s.
Proof.
  intros I. apply in_app_or in I. destruct I as [I|I]; [now apply kept_at_entry|].
  apply in_app_or in I. destruct I as [I|I]; [now apply pieces_at_entries in I|].
  apply in_app_or in I. destruct I as [I|I].
  - destruct (step_at_entry s I) as (N & L & H). split; [assumption|].
    split; [now intros ->|exact H].
  - apply in_map_iff in I. destruct I as (v & <- & Iv). split; [|split; [discriminate|]].
    + constructor; [intros []|constructor].
    + now apply corner_at_entry.
Qed.
Lemma listed_faces s : In s (T ++ low) -> faces_of A s.
Proof. intros I. destruct (listed_at_entry s I) as (N & E & H). now apply entry_face. Qed.
Lemma low_lengths s : In s low -> (length s <= d)%nat.
Proof.
  intros I. apply in_app_or in I. destruct I as [I|I]; [now apply pieces_at_entries in I|].
  apply in_app_or in I. destruct I as [I|I].
  - destruct (step_at_entry s I) as (_ & -> & _). exact two_d.
  - apply in_map_iff in I. destruct I as (v & <- & _). exact positive_d.
Qed.
Lemma region_filled q : region P q <-> walls q \/ exists t, In t T /\ conv t q.
Proof.
  rewrite region_is.
  exact (walls_and_kept Or Co positive_d c accepts p planar (kind D) shown part_accepts walls q
    is_enclosed walls_flagged).
Qed.
Lemma step_in_segment s : In s (part_steps d c p) -> exists a b, In (a, b) (domain_segments P) /\
  within (conv s) (conv [a; b]).
Proof.
  intros I. apply in_flat_map in I. destruct I as (g & Ig & I). apply in_map_iff in I.
  destruct I as (y & <- & Iy).
  exists (fst (segment_ends d c g)), (snd (segment_ends d c g)). rewrite same_segments. split.
  - rewrite <- surjective_pairing. now apply in_map.
  - intros q C. apply (segment_covered Co c accepts p planar (kind D) shown part_accepts g Ig).
    eauto.
Qed.
Lemma all_cells_covered X : In X (cells P) -> exists L, incl L (T ++ low) /\
  forall q, X q <-> exists s, In s L /\ conv s q.
Proof.
  unfold cells. intros IX. apply in_app_or in IX. destruct IX as [IX|IX].
  { apply in_map_iff in IX. destruct IX as (v & <- & Iv). exists [[v]]. split.
    - intros s [<-|[]]. rewrite !in_app_iff. right. right. right. apply in_map_iff. exists v.
      rewrite <- same_vertices. auto.
    - intros q. split.
      + intros ->. exists [v]. split; [now left|]. apply conv_point. now left.
      + intros (s & [<-|[]] & C). now apply conv_singleton. }
  apply in_app_or in IX. destruct IX as [IX|IX].
  { apply in_map_iff in IX. destruct IX as ((a, b) & <- & I). cbn [fst snd].
    rewrite same_segments in I. apply in_map_iff in I. destruct I as (g & E & Ig).
    exists (map (map spot) (edges_from (from g) (links g))). split.
    - intros s Is. rewrite !in_app_iff. right. right. left. apply in_flat_map. eauto.
    - intros q.
      pose proof (segment_covered Co c accepts p planar (kind D) shown part_accepts g Ig q) as H.
      rewrite E in H. cbn [fst snd] in H. rewrite H. split.
      + intros (y & Iy & C). exists (map spot y). split; [now apply in_map|assumption].
      + intros (s & Is & C). apply in_map_iff in Is. destruct Is as (y & <- & Iy). eauto. }
  apply in_app_or in IX. destruct IX as [IX|[<-|[]]].
  { apply in_map_iff in IX. destruct IX as (f & <- & If).
    destruct (polygons_covered f If) as (L & IL & E).
    exists L. split; [|assumption]. intros s Is. rewrite !in_app_iff. right. left. auto. }
  destruct walls_listed as (L & IL & E). exists (T ++ L). split.
  - intros s Is. apply in_or_app. apply in_app_or in Is.
    destruct Is as [Is|Is]; [now left|right; auto].
  - intros q. rewrite region_filled, E. split.
    + intros [(s & Is & C)|(s & Is & C)]; exists s; (split; [apply in_or_app; auto|assumption]).
    + intros (s & Is & C). apply in_app_or in Is. destruct Is; [right|left]; eauto.
Qed.
Lemma all_in_cells s q : In s (T ++ low) -> conv s q -> underlying P q.
Proof.
  intros I C. unfold underlying, cells. rewrite !in_app_iff in I. destruct I as [I|[I|[I|I]]].
  - exists (region P). split; [rewrite !in_app_iff; cbn [In]; auto|]. apply region_filled. eauto.
  - destruct (pieces_in_polygons s I) as (f & If & W). exists (polygon_points f).
    split; [rewrite !in_app_iff; right; right; left; now apply in_map|now apply W].
  - destruct (step_in_segment s I) as (a & b & Iab & W).
    exists (fun q => conv [fst (a, b); snd (a, b)] q).
    split; [|now apply W]. rewrite !in_app_iff. right. left.
    apply (in_map (fun ab q => conv [fst ab; snd ab] q)). exact Iab.
  - apply in_map_iff in I. destruct I as (v & <- & Iv). exists (fun q => q = v).
    split; [|now apply conv_singleton]. rewrite !in_app_iff. left.
    apply (in_map (fun v q => q = v)). now rewrite same_vertices.
Qed.

Let shapes := proj1 (kept_complex Or Co c accepts p planar (kind D) shown part_accepts).
Let once := proj1 (proj2 (kept_complex Or Co c accepts p planar (kind D) shown part_accepts)).
Lemma corners_listed v : In v (domain_vertices P) -> In [v] low.
Proof.
  intros Iv. rewrite !in_app_iff. right. right. apply in_map_iff. exists v.
  rewrite <- same_vertices.
  auto.
Qed.
Theorem dangling_steiner : steiner_triangulation P (T ++ low).
Proof.
  exact (steiner_from_faces P A T low whole_complex shapes once low_lengths listed_faces
    corners_listed
    all_cells_covered all_in_cells).
Qed.

(** ** The claims *)

Hypothesis claim_accepts : check_claim pr shown D = Accepted.

Lemma listed_delaunay : delaunay_of (claimed c) = true -> forall s, In s (T ++ low) ->
  delaunay (concat (T ++ low)) s.
Proof.
  intros Whole s Is. destruct (part_parts c p planar (kind D) shown part_accepts) as (W & _).
  pose proof (check_in_sound Or Co c accepts) as Sound.
  destruct (claimed c) eqn:Ec; try discriminate. destruct Sound as [((_ & _ & _ & Vs & _) & _) Del].
  destruct (listed_faces s Is) as (_ & _ & t & It & J). destruct (Del t It) as (o & r2 & C & Em).
  exists o, r2. split; [intros v Iv; apply C; auto|]. intros x Ix. apply Em.
  apply in_concat in Ix. destruct Ix as (u & Iu & Ix).
  destruct (listed_faces u Iu) as (_ & _ & t' & It' & J'). apply (Vs t' It'). auto.
Qed.
Lemma dangling_delaunay : domain_claimed D = ConformingDelaunay -> forall s, In s (T ++ low) ->
  delaunay (concat (T ++ low)) s.
Proof.
  intros Cl. pose proof claim_accepts as H. unfold check_claim in H. rewrite Cl in H. accepted.
  now apply listed_delaunay.
Qed.

Lemma kept_constrained_delaunay V : check_local pr shown D = Accepted ->
  (forall q, flagged_points (d := d) c p q -> exists X, In X (cells P) /\ X q /\ forall y, X y ->
    flagged_points (d := d) c p y) ->
  (forall v, In v V -> exists s, In s (T ++ low) /\ In v s) ->
  (forall t, In t T -> incl t V) -> forall t, In t T -> constrained_delaunay V P t.
Proof.
  intros L Wa HV TV. destruct (frames_exist Or Co c accepts) as (geo & G).
  pose proof (flagged_walls Co positive_d c p _ geo G (fun x => iff_refl _)) as E.
  apply (kept_constrained Or Co positive_d D accepts planar shown part_accepts L geo G is_enclosed
    P V).
  - intros t It. split; [|now apply TV].
    apply (listed_respects P A T low whole_complex listed_faces all_cells_covered
      all_in_cells). apply in_or_app. now left.
  - intros q W. apply E in W. destruct (Wa q W) as (X & IX & Xq & XW). exists X.
    split; [assumption|]. split; [assumption|]. intros y Xy. now apply E, XW.
  - intros v Iv. destruct (HV v Iv) as (s & Is & Ivs).
    destruct (listed_at_entry s Is) as (_ & _ & t & e & Ee & J). apply J in Ivs.
    rewrite <- (entry_vertices c geo G t e Ee) in Ivs. apply in_vertices in Ivs.
    destruct Ivs as (i & Hi & ->). exists t, i. split; [apply in_tets; eauto|auto].
Qed.
Lemma edge_ends l : forall u y k, In y (edges_from u l) -> In k y -> In k (u :: map reached l).
Proof.
  induction l as [|s l IH]; intros u y k Iy Ik; [destruct Iy|]. destruct Iy as [<-|Iy].
  - destruct Ik as [<-|[<-|[]]]; [now left|right; now left].
  - right. now apply (IH (reached s) y).
Qed.
(** The condition on the vertices of what may dangle. *)
Lemma faces_known : known_faces D = Accepted ->
  (forall s, In s (segments p) -> forall k, In k (from s :: map reached (links s)) ->
    is_corner (Table.of_list Datatypes.id (roles p)) k = true) /\
  (forall f, In f (polygons D) -> forall k, In k (above f) ->
    is_corner (Table.of_list Datatypes.id (roles p)) k = true).
Proof.
  intros H. unfold known_faces in H. cbv zeta in H. accepted. split.
  - intros s Is k Ik. apply in_numbered in Is. destruct Is as (n & E).
    apply (each_accepted _ _ Heqr) in E. cbn beta in E. accepted. rewrite forallb_forall in Heqb.
    now apply Heqb.
  - intros f If k Ik. apply in_numbered in If. destruct If as (n & E).
    apply (each_accepted _ _ H) in E. cbn beta in E. accepted. rewrite forallb_forall in Heqb.
    now apply Heqb.
Qed.
Lemma step_vertices : known_faces D = Accepted -> forall s v, In s (part_steps d c p) -> In v s ->
  In v (part_vertices d c p).
Proof.
  intros H s v Is Iv. destruct (faces_known H) as [St _]. apply in_flat_map in Is.
  destruct Is as (g & Ig & Is). apply in_map_iff in Is. destruct Is as (y & <- & Iy).
  apply in_map_iff in Iv. destruct Iv as (k & <- & Ik).
  apply (corner_in c p planar (kind D) shown part_accepts).
  - apply (St g Ig), (edge_ends _ _ y); assumption.
  - destruct (step_edge c p planar (kind D) shown part_accepts g y Ig Iy) as (u & l & -> & _ & X).
    apply (edge_spec Co c accepts p planar (kind D) shown part_accepts) in X.
    destruct X as (e & E & _ & _ & U & V & _).
    destruct (corner_known Co D accepts _ e k E) as (x & X).
    { destruct Ik as [<-|[<-|[]]]; assumption. }
    rewrite (find_point (c := c)), X. now eexists.
Qed.

Hypothesis faces_accept : check_faces D = Accepted.
Hypothesis walls_are_cells : forall q, flagged_points (d := d) c p q -> exists X, In X (cells P) /\
  X q /\ forall y, X y -> flagged_points (d := d) c p y.
Hypothesis piece_vertices : known_faces D = Accepted -> forall s v, In s F -> In v s ->
  In v (part_vertices d c p).
Hypothesis no_triangle_dangles : triangles_may_dangle D = false -> forall s, In s F ->
  exists t, In t T /\ incl s t.

Lemma all_known : known_corners D = Accepted -> known_faces D = Accepted ->
  forall s v, In s (T ++ low) -> In v s -> In v (domain_vertices P).
Proof.
  intros KC KF s v Is Iv. rewrite same_vertices. rewrite !in_app_iff in Is.
  destruct Is as [Is|[Is|[Is|Is]]].
  - now apply (no_other_vertices Or Co D accepts planar shown part_accepts KC s).
  - now apply (piece_vertices KF s).
  - now apply (step_vertices KF s).
  - apply in_map_iff in Is. destruct Is as (w & <- & Iw). now destruct Iv as [<-|[]].
Qed.
(** A triangle that dangles is Delaunay, then; else none does. *)
Lemma all_constrained V : triangles_may_dangle D = delaunay_of (claimed c) ->
  check_local pr shown D = Accepted ->
  (forall v, In v V -> exists s, In s (T ++ low) /\ In v s) ->
  (forall s, In s (T ++ low) -> incl s V) -> forall s, In s (T ++ low) ->
  has_to_be_constrained_delaunay (T ++ low) s -> constrained_delaunay V P s.
Proof.
  intros May Lo HV SV s Is Has. destruct (triangles_may_dangle D).
  { destruct (listed_delaunay (eq_sym May) s Is) as (o & r2 & C & Em). split; [now apply SV|].
    split; [exact (listed_respects P A T low whole_complex listed_faces all_cells_covered
      all_in_cells s Is)|].
    exists o, r2. split; [exact C|]. intros v x Iv _ _. apply Em.
    destruct (HV v Iv) as (u & Iu & Ivu). apply in_concat. eauto. }
  assert (TV : forall t, In t T -> incl t V)
    by (intros t It; apply SV, in_or_app; now left).
  assert (It : In s T).
  { apply in_app_or in Is. destruct Is as [Is|Is]; [assumption|exfalso].
    destruct Has as [L|[L Dangles]]; [pose proof (low_lengths s Is); lia|].
    rewrite !in_app_iff in Is. destruct Is as [Is|[Is|Is]].
    - destruct (no_triangle_dangles eq_refl s Is) as (t & It & J).
      apply (Dangles t); [apply in_or_app; now left|now apply shapes|assumption].
    - destruct (step_at_entry s Is) as (_ & L2 & _). lia.
    - apply in_map_iff in Is. destruct Is as (v & <- & _). discriminate. }
  now apply (kept_constrained_delaunay V).
Qed.
Theorem dangling_claims : holds_of_complex (domain_claimed D) P (T ++ low).
Proof.
  pose proof claim_accepts as Ch. pose proof faces_accept as Fa. pose proof dangling_steiner as St.
  unfold check_claim in Ch. unfold check_faces in Fa.
  destruct (domain_claimed D) eqn:Cl; cbn [holds_of_complex].
  - split; [assumption|]. now apply all_known.
  - assumption.
  - split; [assumption|]. now apply dangling_delaunay.
  - destruct (known_corners D) eqn:KC; [|discriminate].
    assert (Known : forall s v, In s (T ++ low) -> In v s -> In v (domain_vertices P))
      by now apply all_known.
    split; [now split|]. intros s Is.
    apply all_constrained; try assumption; [unfold triangles_may_dangle; now rewrite Cl|..].
    + intros v Iv. exists [v]. split; [|now left]. apply in_or_app. right. now apply corners_listed.
    + intros t It v Iv. now apply (Known t).
  - split; [assumption|]. intros s Is.
    apply all_constrained; try assumption; [unfold triangles_may_dangle; now rewrite Cl|..].
    + intros v Iv. apply in_concat in Iv. exact Iv.
    + intros t It v Iv. apply in_concat. now exists t.
Qed.
End Certified.
