(** * A broken rule refutes the claim about a domain *)
From Coq Require Import Rbase Rfunctions Lra Lia List Arith.
From Circumspect Require Import WholeRefutation.
From Circumspect Require Import Vectors Affine Frame Faces LiftingMap Breach HullBreach.
From Circumspect Require Import Combinations Solid Necessary Visible Covered ConstrainedLemma.
From Circumspect Require Import Definitions Domains DomainRules.
Import ListNotations.
Open Scope R_scope.

Section Refutes.
Context {d : nat}.
Implicit Types (P : domain d) (L M : list (list (option (point d)))).

(** ** What all claims have in common *)

Lemma claims_complexes c P K : holds_of_complex c P K -> steiner_triangulation P K.
Proof.
  destruct c; cbn; [intros [H _]|intros H|intros [H _]|intros [[H _] _]|intros [H _]]; exact H.
Qed.
Lemma claims_all c P L M : claims_of_domain c P L M -> exists A, (L ++ M)%list = map (map Some) A /\
  (forall t, In t A -> NoDup t /\ t <> []) /\ simplicial_complex (faces_of A) /\
  (forall v, In v (domain_vertices P) -> exists t, In t A /\ In v t) /\
  (forall X, In X (cells P) -> union_of_simplices A X) /\
  (forall q, underlying P q <-> exists t, In t A /\ conv t q).
Proof.
  intros (K & E & H). apply claims_complexes in H. destruct H as (D & _ & H). exists K.
  split; [assumption|].
  split; [|exact H]. intros t I. destruct (D t I) as (N & Ne & _). now split.
Qed.
Lemma some_rows L M (K : list (simplex d)) : (L ++ M)%list = map (map Some) K ->
  exists T U, K = (T ++ U)%list /\
  L = map (map Some) T /\ M = map (map Some) U.
Proof.
  intros E. symmetry in E. apply map_eq_app in E. destruct E as (T & U & -> & <- & <-).
  now exists T, U.
Qed.
(** Of the rows those of d-simplices are a complex of them. *)
Definition full_rows L := filter (fun r => Nat.eqb (length r) (S d)) L.
Lemma full_rows_map (K : list (simplex d)) : full_rows (map (map Some) K) = map (map Some)
  (filter full K).
Proof.
  unfold full_rows. induction K as [|s K IH]; [reflexivity|]. cbn [map filter]. rewrite map_length.
  unfold full at 1.
  destruct (Nat.eqb (length s) (S d)); cbn [map]; now rewrite IH.
Qed.
Lemma full_rows_in L s : listed L s -> length s = S d -> listed (full_rows L) s.
Proof.
  intros I E. apply filter_In. split; [assumption|]. rewrite map_length. now apply Nat.eqb_eq.
Qed.
Lemma claims_full c P L M : claims_of_domain c P L M -> claims_complex (full_rows L).
Proof.
  intros (K & E & H). apply claims_complexes in H. destruct H as (D & O & (Ai & Fa & Me) & _).
  apply some_rows in E. destruct E as (T & U & -> & -> & _). exists (filter full T).
  split; [apply full_rows_map|].
  assert (Full : forall t, In t (filter full T) -> In t T /\ length t = S d) by (intros t I;
    now apply in_full).
  assert (F : forall s, faces_of (filter full T) s -> faces_of (T ++ U) s).
  { intros s (N & Ne & t & I & J). split; [assumption|]. split; [assumption|]. exists t.
    split; [|assumption].
    apply in_or_app. left. now apply Full. }
  split; [|split].
  - intros t I. split; [|now apply Full]. apply (D t). apply in_or_app. left. now apply Full.
  - split; [intros s H; now apply Ai, F|]. split; [|intros s t Hs Ht; apply Me; now apply F].
    intros s f (_ & _ & t & I & J) Hf N Ne. split; [assumption|]. split; [assumption|]. exists t.
    split; [assumption|].
    now apply incl_tran with s.
  - apply (pairs_weaker (fun s t => length s = S d -> ~ same s t)); [|apply filtered_pairs].
    + intros s t Is _ H. apply H. now apply Full.
    + clear - O. induction T as [|t T IH]; [constructor|]. cbn [app] in O.
      inversion O as [|? ? F O']; subst. constructor; [|now apply IH].
      rewrite Forall_forall in *. intros b I. apply F. apply in_or_app. now left.
Qed.
(** Nothing dangles: each row is one of a d-simplex. *)
Definition all_full L : Prop := forall r : list (option (point d)), In r L -> length r = S d.
Lemma claims_alone c P L : all_full L -> claims_of_domain c P L [] ->
  exists T, L = map (map Some) T /\ solid_triangulation P T /\
  match c with
  | PlcTriangulation => forall t v, In t T -> In v t -> In v (domain_vertices P)
  | SteinerTriangulation => True
  | ConformingDelaunay => forall t, In t T -> delaunay (concat T) t
  | Cdt => (forall t v, In t T -> In v t -> In v (domain_vertices P)) /\ forall t, In t T ->
      constrained_delaunay (domain_vertices P) P t
  | SteinerCdt => forall t, In t T -> constrained_delaunay (concat T) P t
  end.
Proof.
  intros Full (T & E & H). rewrite app_nil_r in E. exists T. split; [assumption|].
  assert (So : solid T).
  { intros t I. rewrite <- (map_length Some). apply Full. rewrite E. now apply in_map. }
  pose proof (claims_complexes c P T H) as St. split; [now apply solid_steiner|].
  destruct c; cbn in H; [apply H|exact I|apply H|split; [apply H|]|]; intros t It; apply H;
    try assumption; left; now apply So.
Qed.

Section All.
Variables (c : domain_claim) (P : domain d) (L M : list (list (option (point d)))).

Lemma vertex_missing_refutes : vertex_missing P (L ++ M) -> ~ claims_of_domain c P L M.
Proof.
  intros (v & Iv & N) H. destruct (claims_all c P L M H) as (A & E & _ & _ & V & _). rewrite E in N.
  destruct (V v Iv) as (t & It & I). apply (N (map Some t)); now apply in_map.
Qed.
Lemma steiner_forbidden_refutes : only_vertices c = true -> steiner_forbidden P (L ++ M) ->
  ~ claims_of_domain c P L M.
Proof.
  intros O (r & v & Ir & Iv & N) (K & E & H). rewrite E in Ir. apply in_listed in Ir.
  destruct Ir as (t & -> & It). apply in_map_iff in Iv. destruct Iv as (x & Ex & Ix).
  injection Ex as ->. apply N.
  destruct c; try discriminate; [now apply (proj2 H t v)|now apply (proj2 (proj1 H) t v)].
Qed.
Lemma union_refutes X q : In X (cells P) -> X q ->
  (forall s f, listed (L ++ M) s -> incl f s -> conv f q -> ~ within (conv f) X) ->
    ~ claims_of_domain c P L M.
Proof.
  intros IX C N H. destruct (claims_all c P L M H) as (A & E & _ & _ & _ & U & _). rewrite E in N.
  destruct (U X IX) as (F & HF & EF). apply EF in C. destruct C as (s & Is & Cs).
  destruct (HF s Is) as (_ & _ & t & It & J).
  apply (N t s); try assumption; [unfold listed; now apply in_map|]. intros x Xx. apply EF. eauto.
Qed.
Lemma segment_missing_refutes : segment_missing P (L ++ M) -> ~ claims_of_domain c P L M.
Proof.
  intros (a & b & q & I & C & N). apply (union_refutes (conv [a; b]) q); [|assumption|assumption].
  unfold cells. apply in_or_app. right. apply in_or_app. left.
  apply (in_map (fun ab q => conv [fst ab; snd ab] q) _ (a, b) I).
Qed.
Lemma polygon_not_tiled_refutes : polygon_not_tiled P (L ++ M) -> ~ claims_of_domain c P L M.
Proof.
  intros (f & q & If & Fq & N).
  apply (union_refutes (polygon_points f) q); [|assumption|assumption].
  unfold cells. apply in_or_app. right. apply in_or_app. right. apply in_or_app. left.
  now apply in_map.
Qed.
Lemma uncovered_refutes : uncovered P (L ++ M) -> ~ claims_of_domain c P L M.
Proof.
  intros (q & U & N) H. destruct (claims_all c P L M H) as (A & E & _ & _ & _ & _ & Un).
  rewrite E in N.
  apply Un in U. destruct U as (t & It & C).
  apply (N t); [unfold listed; now apply in_map|assumption].
Qed.
Lemma outside_refutes : outside P (L ++ M) -> ~ claims_of_domain c P L M.
Proof.
  intros (s & q & Ls & C & N) H. destruct (claims_all c P L M H) as (A & E & _ & _ & _ & _ & Un).
  rewrite E in Ls.
  apply N, Un. exists s. split; [now apply listed_in|assumption].
Qed.
Lemma vertex_in_edge_refutes : vertex_in_edge P (L ++ M) -> ~ claims_of_domain c P L M.
Proof.
  intros (r & s & v & a & b & e & f & Ir & Iv & Ls & Ie & If & Ne & Nf & Cv & _) H.
  destruct (claims_all c P L M H) as (A & E & _ & (_ & _ & Me) & _). rewrite E in Ir, Ls.
  apply listed_in in Ls. apply in_listed in Ir.
  destruct Ir as (t & -> & It). apply in_map_iff in Iv. destruct Iv as (x & Ex & Ix).
  injection Ex as ->.
  assert (Nef : e <> f) by (intros ->; apply Ne, (conv_singleton f), (conv_incl [f; f]);
    [intros y [<-|[<-|[]]]; now left|assumption]).
  destruct (Me [v] [e; f]) as (g & Gv & Ge & C).
  - split; [repeat constructor; now intros []|]. split; [discriminate|]. exists t.
    split; [assumption|]. now intros y [<-|[]].
  - split; [constructor; [intros [X|[]]; now apply Nef|repeat constructor; now intros []]|].
    split; [discriminate|].
    exists s. split; [assumption|]. now intros y [<-|[<-|[]]].
  - specialize (C v (conv_point [v] v (or_introl eq_refl)) Cv).
    destruct g as [|y g]; [now apply (conv_empty v)|].
    destruct (Gv y (or_introl eq_refl)) as [<-|[]].
    destruct (Ge v (or_introl eq_refl)) as [X|[X|[]]]; congruence.
Qed.
Lemma overlap_of_all_refutes : overlap (L ++ M) -> ~ claims_of_domain c P L M.
Proof.
  intros (s & t & q & Ls & Lt & Cs & Ct & N) H.
  destruct (claims_all c P L M H) as (A & E & D & (_ & _ & Me) & _).
  rewrite E in Ls, Lt. apply listed_in in Ls, Lt.
  assert (F : forall s, In s A -> faces_of A s).
  { intros r Ir. destruct (D r Ir) as [ND NE]. split; [assumption|]. split; [assumption|]. exists r.
    split; [assumption|apply incl_refl]. }
  destruct (Me s t (F s Ls) (F t Lt)) as (f & Fs & Ft & I). exact (N f Fs Ft (I q Cs Ct)).
Qed.

(** A vertex of the mesh is a vertex of one of the simplices. *)
Lemma entries_concat (A : list (simplex d)) v : In v (entries (map (map Some) A)) ->
  In v (concat A).
Proof.
  intros I. unfold entries in I. apply in_flat_map in I. destruct I as (r & Ir & Iv).
  apply in_map_iff in Ir. destruct Ir as (t & <- & It).
  apply in_flat_map in Iv. destruct Iv as (x & Ix & Iv). apply in_map_iff in Ix.
  destruct Ix as (y & <- & Iy).
  destruct Iv as [<-|[]]. apply in_concat. eauto.
Qed.
Lemma no_empty_ball_refutes : no_empty_ball P L M -> ~ claims_of_domain ConformingDelaunay P L M.
Proof.
  intros (s & Ls & _ & _ & B) (K & E & (_ & _ & _ & V & _) & De).
  assert (Is : In s K) by (apply listed_in; rewrite <- E; unfold listed; apply in_or_app;
    now right).
  destruct (De s Is) as (o & r2 & Ci & Em).
  destruct (B o r2 Ci) as (v & Iv & N). rewrite E in Iv. apply (Em v); [|assumption].
  destruct Iv as [Iv|Iv]; [now apply entries_concat|]. destruct (V v Iv) as (t & It & I).
  apply in_concat. eauto.
Qed.

(** Of the mesh's own rules those about balls are of conforming Delaunay meshes. *)
Lemma mesh_rule_refutes e : of_mesh e c = true -> broken_of_domain P L M (mesh_rule (rule_of e)) ->
  ~ claims_of_domain c P L M.
Proof.
  intros O B H. pose proof (claims_full c P L M H) as Cx.
  destruct (claims_all c P L M H) as (A & E & D & (Ai & _ & _) & _).
  assert (Row : forall r, In r L -> exists t, r = map Some t /\ In t A).
  { intros r I. apply in_listed. rewrite <- E. apply in_or_app. now left. }
  destruct e; try discriminate; cbn in B.
  - destruct B as (r & I & B). destruct (Row r I) as (y & -> & It). rewrite map_length in B.
    destruct H as (K & EK & H). apply claims_complexes in H. destruct H as (DK & _).
    destruct (DK y) as (_ & Ne & Len).
    { apply listed_in. rewrite <- EK. unfold listed. apply in_or_app. now left. }
    destruct B as [B|B]; [|lia]. destruct y; [congruence|discriminate].
  - destruct B as (r & I & N). destruct (Row r I) as (y & -> & _). apply in_map_iff in N.
    destruct N as (p & X & _). discriminate.
  - destruct B as (r & k & l & p & I & N & Hi & Hj). destruct (Row r I) as (y & -> & It).
    destruct (D y It) as [ND _]. apply N.
    rewrite nth_error_map in Hi, Hj. cbn in Hi, Hj.
    destruct (nth_error y k) eqn:Ei, (nth_error y l) eqn:Ej; try discriminate. cbn in Hi, Hj.
    apply (NoDup_nth_error y); [assumption| |].
    + apply nth_error_Some. congruence.
    + congruence.
  - destruct B as (s & Ls & N). destruct (Row _ Ls) as (y & X & It). apply map_some_inj in X.
    subst y. apply N, Ai.
    destruct (D s It) as [ND NE]. split; [assumption|]. split; [assumption|]. exists s.
    split; [assumption|apply incl_refl].
  - apply (duplicate_simplex_refutes (full_rows L)); [|assumption].
    destruct B as (L1 & L2 & L3 & s & y & EL & Es & Ey & S).
    exists (full_rows L1), (full_rows L2), (full_rows L3), s, y.
    split; [|auto]. apply Nat.eqb_eq in Es, Ey. unfold full_rows. rewrite EL, filter_app.
    cbn [filter].
    rewrite map_length, Es, filter_app. cbn [filter]. now rewrite map_length, Ey.
  - now apply overlap_of_all_refutes.
  - apply (covered_twice_refutes (full_rows L)); [|assumption].
    destruct B as (s & y & z & (Ls & Es & Is) & (Lt & Et & It) & B). exists s, y, z.
    split; [split; [now apply full_rows_in|now split]|].
    split; [split; [now apply full_rows_in|now split]|assumption].
  - destruct c eqn:Ec; try discriminate. destruct H as (K & EK & (_ & _ & _ & V & _) & De).
    destruct B as (s & v & [Ls _] & Iv & N).
    assert (IsK : In s K) by (apply listed_in; rewrite <- EK; unfold listed; apply in_or_app;
      now left).
    destruct (De s IsK) as (o & r2 & Ci & Em).
    apply (Em v); [|exact (N o r2 Ci)]. apply in_app_or in Iv. destruct Iv as [Iv|Iv].
    + rewrite EK in Iv. now apply entries_concat.
    + destruct (V v Iv) as (y & Iy & I). apply in_concat. eauto.
  - destruct c eqn:Ec; try discriminate. destruct H as (K & EK & _ & De).
    destruct B as (s1 & s2 & f1 & u1 & v1 & [Hs _] & Ht & _ & _ & _ & _ & _ & Hv & _ & N).
    assert (InK : forall s, listed L s -> In s K) by (intros s Ls; apply listed_in; rewrite <- EK;
      unfold listed; apply in_or_app; now left).
    destruct (De s1 (InK s1 Hs)) as (o & r2 & Ci & Em).
    apply (Em v1); [|exact (N o r2 Ci)]. apply in_concat. exists s2.
    split; [now apply InK|assumption].
Qed.
End All.

(** ** Hulls *)

(** A mesh of a hull is one of its own vertices. *)
Lemma hull_filled c P L : (2 <= d)%nat -> proper_domain P -> what_it_fills P = Hull -> all_full L ->
  claims_of_domain c P L [] ->
  claims_to_fill (entries L) L.
Proof.
  intros D Pr K Fu H. destruct (claims_alone c P L Fu H) as (T & -> & St & _).
  assert (Ve : mesh_vertices T (concat T)) by (intros v; apply in_concat).
  destruct (all_framed P T St) as (ts & are).
  pose proof (vertex_in_hull D P T (concat T) Pr St Ve ts are) as InHull.
  exists T. split; [reflexivity|]. destruct St as (Dt & Di & Cx & Vx & _ & Un).
  assert (In_ : forall t, In t T -> incl t (entries (map (map Some) T))).
  { intros t It v Iv. unfold entries. apply in_flat_map. exists (map Some t).
    split; [now apply in_map|].
    apply in_flat_map. exists (Some v). split; [now apply in_map|now left]. }
  split; [assumption|]. split; [assumption|]. split; [assumption|]. split; [assumption|]. intros q.
  split.
  - intros C. apply Un. exists (region P). split; [apply low_or_region; now right|]. unfold region.
    rewrite K.
    apply (conv_conv (entries (map (map Some) T))); [|assumption]. intros p Ip.
    apply InHull; [now apply entries_concat|assumption].
  - intros (t & It & C). apply (conv_incl t); [now apply In_|assumption].
Qed.
Lemma hull_rule_refutes c P L e : (2 <= d)%nat -> proper_domain P -> what_it_fills P = Hull ->
  all_full L ->
  match e with HullNotConvex _ _ _ | HullNotClosed _ _ _ _ _ _ => True | _ => False end ->
  broken_of_domain P L [] (mesh_rule (rule_of e)) -> ~ claims_of_domain c P L [].
Proof.
  intros D Pr K Fu E B H. apply (hull_filled c P L D Pr K Fu) in H.
  destruct e; try contradiction; cbn in B; rewrite ?app_nil_r in B;
    [now apply (hull_not_convex_refutes (entries L) L)|now apply
      (hull_not_closed_refutes (entries L) L)].
Qed.

(** ** Constrained Delaunay *)

Definition about_cdt (c : domain_claim) : bool := match c with Cdt | SteinerCdt => true | _ =>
  false end.
Lemma claims_cdt c P L : about_cdt c = true -> all_full L -> claims_of_domain c P L [] ->
  exists T V, L = map (map Some) T /\
  solid_triangulation P T /\ mesh_vertices T V /\ forall t, In t T -> constrained_delaunay V P t.
Proof.
  intros A Fu H. destruct (claims_alone c P L Fu H) as (T & E & St & C).
  destruct c; try discriminate.
  - destruct C as [Given Cd]. exists T, (domain_vertices P). split; [assumption|].
    split; [assumption|].
    split; [|assumption]. intros v. split; [apply St|]. intros (t & It & Iv). now apply (Given t v).
  - exists T, (concat T). split; [assumption|]. split; [assumption|].
    split; [|assumption]. intros v. apply in_concat.
Qed.
Lemma constrained_facet_refutes c P L : (2 <= d)%nat -> proper_domain P -> about_cdt c = true ->
  all_full L ->
  constrained_facet_not_local P L -> ~ claims_of_domain c P L [].
Proof.
  intros D Pr A Fu (s & t & f & p & v & [Ls _] & Lt & Nf & Lf & Fs & Ft & Ip & Iv & O & B & NW) H.
  destruct (claims_cdt c P L A Fu H) as (T & V & -> & St & Ve & Cd). apply listed_in in Ls, Lt.
  destruct (Cd s Ls) as (_ & _ & o & r2 & Ci & Em). destruct O as (a & b & Z & Pp & Nv).
  assert (Nvf : ~ In v f) by (intros I; specialize (Z v I); lra).
  assert (Npf : ~ In p f) by (intros I; specialize (Z p I); lra).
  assert (NS : ~ same s t).
  { intros [_ TS]. destruct (proj1 St s Ls) as [_ Len].
    assert (K : (length (p :: v :: f) <= length s)%nat).
    { apply NoDup_incl_length.
      - constructor; [|now constructor]. intros [E|I]; [subst v; lra|contradiction].
      - intros y [<-|[<-|I]]; auto. }
    cbn [length] in K. lia. }
  destruct (apex_of_neighbour D P T V Pr St Ve f s t v Nf Lf NW Ls Lt Fs Ft NS Iv Nvf)
    as (x & Xi & Vis).
  apply (Em v x); [apply Ve; eauto|assumption|assumption|]. now apply B.
Qed.
Lemma polygon_in_walls P f q : proper_domain P -> In f (domain_polygons P) -> polygon_points f q ->
  walls_of P q.
Proof.
  intros [N _] If C. unfold walls_of. destruct d as [|[|[|n]]]; try (exists f; now split).
  rewrite N in If by reflexivity. destruct If.
Qed.
(** Of finitely many things each holds or does not: at least this cannot be refuted. *)
Lemma decided {A} (Q : A -> Prop) (l : list A) : ((forall a, In a l -> Q a \/ ~ Q a) -> False) ->
  False.
Proof.
  induction l as [|a l IH]; intros H; [apply H; intros a []|]. apply IH. intros K.
  apply H. intros b [<-|I]; [|now apply K]. right. intros Qa. apply H.
  intros b [<-|I]; [now left|now apply K].
Qed.
Lemma dangling_refutes c P L M : proper_domain P -> what_it_fills P = Enclosed ->
  about_cdt c = true ->
  dangling_not_delaunay P L M -> ~ claims_of_domain c P L M.
Proof.
  intros Pr K A (s & v & x & f & Ls & Len & _ & Alone & Iv & Xi & If & Way & Others & B)
    (C & E & Holds_C).
  assert (Is : In s C) by (apply listed_in; rewrite <- E; unfold listed; apply in_or_app;
    now right).
  rewrite E in Iv. apply entries_concat in Iv.
  assert (To : has_to_be_constrained_delaunay C s).
  { right. split; [assumption|]. intros t It Lt. apply Alone; [|assumption]. rewrite E.
    unfold listed. now apply in_map. }
  assert (Cw : exists V, In v V /\ constrained_delaunay V P s).
  { destruct c; try discriminate; destruct Holds_C as [Pl Cd].
    - exists (domain_vertices P). split; [|now apply Cd]. apply in_concat in Iv.
      destruct Iv as (t & It & Iv). now apply (proj2 Pl t).
    - exists (concat C). split; [assumption|]. now apply Cd. }
  destruct Cw as (V & IV & _ & _ & o & r2 & Ci & Em).
  apply (decided (fun X : point d -> Prop => X v) (low_cells P)). intros AtV.
  apply (decided (fun X : point d -> Prop => X x) (low_cells P)). intros AtX.
  apply (Em v x IV Xi); [|now apply B].
  assert (IX : In (polygon_points f) (cells P)).
  { unfold cells. apply in_or_app. right. apply in_or_app. right. apply in_or_app. left.
    now apply in_map. }
  assert (All : forall q, conv [x; v] q -> polygon_points f q).
  { intros q Cq. apply conv_two in Cq. destruct Cq as (e & He & ->). now apply Way. }
  assert (Whole : forall X : point d -> Prop, (forall q, conv [x; v] q -> X q) ->
    union_of_faces (fun q => X q /\ conv [x; v] q) [x; v]).
  { intros X H. exists [[x; v]]. split; [intros g [<-|[]]; apply incl_refl|]. intros q. split.
    - intros [_ Cq]. exists [x; v]. split; [now left|assumption].
    - intros (g & [<-|[]] & Cq). split; auto. }
  split; [intros q Cq; exists (polygon_points f); split; auto|].
  intros X JX. apply low_or_region in JX. destruct JX as [JX| ->].
  - destruct (AtX X JX) as [Xx|Nx].
    + rewrite (Others X 0 JX) by (try lra; now rewrite between_start). now apply Whole.
    + assert (Only : forall q, X q -> conv [x; v] q -> q = v).
      { intros q Xq Cq. apply conv_two in Cq. destruct Cq as (e & He & ->).
        destruct (Rlt_dec e 1) as [Le|Ne].
        - destruct Nx. rewrite (Others X e JX); [|lra|assumption]. rewrite <- (between_start x v).
          apply Way. lra.
        - replace e with 1 by lra. apply between_end. }
      destruct (AtV X JX) as [Xv|Nv].
      * exists [[v]]. split; [intros g [<-|[]] y [<-|[]]; right; now left|]. intros q. split.
        { intros [Xq Cq]. rewrite (Only q Xq Cq). exists [v]. split; [now left|].
          now apply conv_singleton. }
        intros (g & [<-|[]] & Cq). apply conv_singleton in Cq. subst q. split; [assumption|].
        apply conv_point. right. now left.
      * exists []. split; [intros g []|]. intros q. split; [|intros (g & [] & _)].
        intros [Xq Cq]. rewrite (Only q Xq Cq) in Xq. contradiction.
  - apply Whole. intros q Cq. unfold region. rewrite K. split; [exact I|]. left.
    now apply (polygon_in_walls P f q Pr If), All.
Qed.
Lemma visible_vertex_refutes c P L : (2 <= d)%nat -> proper_domain P -> about_cdt c = true ->
  all_full L ->
  visible_vertex_in_ball P L -> ~ claims_of_domain c P L [].
Proof.
  intros D Pr A Fu (s & v & x & [Ls _] & (r & Ir & Iv) & Xi & Off & B) H.
  destruct (claims_cdt c P L A Fu H) as (T & V & -> & St & Ve & Cd). apply listed_in in Ls.
  apply in_listed in Ir.
  destruct Ir as (t & -> & It). apply in_map_iff in Iv. destruct Iv as (y & E & Iy).
  injection E as ->.
  destruct (Cd s Ls) as (_ & _ & o & r2 & Ci & Em). assert (IV : In v V) by (apply Ve; eauto).
  apply (Em v x IV Xi); [|now apply B]. destruct (all_framed P T St) as (ts & are).
  apply (Visible.seen P T St s x v Ls (proj1 Xi)).
  - now apply (vertex_in_hull D P T V Pr St Ve ts are).
  - intros X IX e He. now apply Off.
Qed.
End Refutes.
