(** * From faces to cells

    If each face of the mesh in a segment or polygon is held by one of them ([HeldFaces.v]), then
    cells meet in cells; the boundary of a segment is its ends. *)
From Coq Require Import Rbase Rfunctions Lra List Arith Lia ZArith Bool.
From Circumspect Require Import ComplexChecker Numbering.
From Circumspect Require Import Vectors Affine Frame Faces Combinations Shadow Orientation Integers
  Accepted.
From Circumspect Require Import KeptMesh KeptCells Polygons HeldFaces Sides Definitions Domains.
Import ListNotations.
Open Scope R_scope.

(** ** The boundary of a segment *)

Lemma between_once {d} (a b : point d) s t : a <> b -> between a b s = between a b t -> s = t.
Proof.
  intros N E. destruct (Req_dec s t) as [|D]; [assumption|exfalso]. apply N.
  apply affine_separate. intros f A. pose proof (f_equal f E) as Ef.
  change (between (d := d)) with (mix (d := d)) in Ef. rewrite !affine_mix in Ef by assumption.
  assert ((s - t) * (f b - f a) = 0) by lra. apply Rmult_integral in H. lra.
Qed.
Definition segment_cell {d} (a b : point d) : linear_cell :=
  LinearCell (d := d) 1 (fun q => exists s, q = between a b s) (conv [a; b]).
Lemma conv_swap {d} (a b : point d) q : conv [a; b] q <-> conv [b; a] q.
Proof.
  apply conv_same.
  split; intros x [<-|[<-|[]]]; [right; now left|now left|right; now left|now left].
Qed.
Lemma boundary_of_segment {d} (a b : point d) q : a <> b -> boundary (segment_cell a b) q <->
  q = a \/ q = b.
Proof.
  intros N. unfold boundary, segment_cell. cbn [cell_points affine_hull]. split.
  - intros (C & r & (r0 & ->) & Away). apply conv_two in C. destruct C as (s0 & Hs & ->).
    destruct (Req_dec s0 0) as [->|Z]; [left; apply between_start|].
    destruct (Req_dec s0 1) as [->|O]; [right; apply between_end|]. exfalso.
    set (g := Rmin s0 (1 - s0)). assert (G : 0 < g <= s0 /\ g <= 1 - s0).
    { unfold g. pose proof (Rmin_l s0 (1 - s0)). pose proof (Rmin_r s0 (1 - s0)).
      repeat split; try lra. apply Rmin_glb_lt; lra. }
    set (k := 1 + Rabs (r0 - s0)).
    assert (K : 1 <= k) by (unfold k; pose proof (Rabs_pos (r0 - s0)); lra).
    assert (S : 0 < g / k <= 1 /\ (g / k) * k = g).
    { split; [split|field; lra].
      - apply Rmult_lt_0_compat; [lra|]. apply Rinv_0_lt_compat. lra.
      - apply Rmult_le_reg_r with k; [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
    destruct S as [S Eq]. apply (Away (g / k) S). rewrite between_between. apply conv_two.
    set (e := g / k) in *. exists ((1 - e) * s0 + e * r0). split; [|reflexivity].
    assert (B : Rabs (r0 - s0) <= k) by (unfold k; lra).
    pose proof (Rle_abs (r0 - s0)) as B1. pose proof (Rle_abs (- (r0 - s0))) as B2.
    rewrite Rabs_Ropp in B2.
    assert (e * (r0 - s0) <= e * k) by (apply Rmult_le_compat_l; lra).
    assert (e * (- (r0 - s0)) <= e * k) by (apply Rmult_le_compat_l; lra). lra.
  - assert (Out : forall r s, 0 < s <= 1 -> (r = -1 \/ r = 2) ->
      ~ conv [a; b] (between (between a b (if Req_EM_T r 2 then 1 else 0)) (between a b r) s)).
    { intros r s Hs Hr C. apply conv_two in C. destruct C as (u & Hu & E).
      rewrite between_between in E.
      apply between_once in E; [|assumption]. destruct (Req_EM_T r 2) as [->|NE]; [lra|].
      destruct Hr as [->|]; [lra|contradiction]. }
    intros [->| ->].
    + split; [apply conv_point; now left|]. exists (between a b (-1)). split; [now exists (-1)|].
      intros s Hs C. apply (Out (-1) s Hs (or_introl eq_refl)).
      destruct (Req_EM_T (-1) 2) as [X|_]; [lra|]. now rewrite between_start.
    + split; [apply conv_point; right; now left|]. exists (between a b 2). split; [now exists 2|].
      intros s Hs C. apply (Out 2 s Hs (or_intror eq_refl)).
      destruct (Req_EM_T 2 2) as [_|X]; [now rewrite between_end|lra].
Qed.

(** ** From faces to cells *)

Section Cells.
Context {d : nat} {orient : list (point d) -> R} {pr : predicates}.
Hypothesis Or : oriented orient.
Hypothesis Co : computes orient pr.
Hypothesis two_d : (2 <= d)%nat.
Let one_d : (1 <= d)%nat := Nat.le_trans 1 2 d (le_S 1 1 (le_n 1)) two_d.
Variable c : certificate.
Hypothesis accepts : check_in pr c = Accepted.
Variable p : part.
Variables (planar : bool) (kind : domain_kind).
Variable shown : list positive -> nat -> positive * positive -> bool.
Hypothesis part_accepts : check_part pr false planar kind c p shown = Accepted.
Variable F : list (list face_entry).
Variable inside : holder -> list positive.
Hypothesis no_inside : forall n, inside (InSegment n) = [].
Hypothesis steps_accept : each (check_steps (mesh_of c) (Table.of_list Datatypes.id (roles p))
  (Table.of_list Datatypes.id (segments p)) (Table.of_list Datatypes.id F)) 1 (segments p) =
    Accepted.
Variable P : domain d.
Hypothesis vertices_are : domain_vertices P = part_vertices d c p.
Hypothesis segments_are : domain_segments P = part_segments d c p.
(** The polygons by their numbers. *)
Variable number : positive -> polygon d -> Prop.
Hypothesis numbered_polygon : forall f, In f (domain_polygons P) -> exists k, number k f.
Hypothesis number_once : forall k f g, number k f -> number k g -> f = g.
Hypothesis polygon_face : forall k f q, number k f -> polygon_points f q -> exists s,
  face_at c s q /\ all_held c p F inside (InPolygon k) s.
Hypothesis polygon_segment : forall k f n s q, number k f -> In n (inside (InPolygon k)) ->
  numbered (segments p) n = Some s -> conv (ends_of c s) q -> polygon_points f q.
Hypothesis polygons_3 : domain_polygons P <> [] -> (3 <= d)%nat.
Hypothesis in_region : what_it_fills P = Enclosed -> forall f, In f (linear_cells P) ->
  within (cell_points f) (region P).

Notation vertex_cell := (fun v : point d => LinearCell 0 (fun q => q = v) (fun q => q = v)).
Notation polygon_cell := (fun f : polygon d =>
  LinearCell 2 (fun q => inner (plane_normal f) q = plane_offset f) (polygon_points f)).
Notation region_cell := (LinearCell d (fun _ => True) (region P)).

Lemma cell_cases f : In f (linear_cells P) ->
  (exists v, In v (domain_vertices P) /\ f = vertex_cell v) \/
  (exists n s, numbered (segments p) n = Some s /\
     In (spot d c (from s), spot d c (last_reached s)) (domain_segments P) /\
     f = segment_cell (spot d c (from s)) (spot d c (last_reached s))) \/
  (exists g, In g (domain_polygons P) /\ f = polygon_cell g) \/
  what_it_fills P = Enclosed /\ f = region_cell.
Proof using segments_are.
  clear in_region. unfold linear_cells. intros I.
  repeat (apply in_app_or in I; destruct I as [I|I]).
  - left. apply in_map_iff in I. destruct I as (v & <- & I). exists v. split; [exact I|reflexivity].
  - right. left. apply in_map_iff in I. destruct I as (ab & <- & I). pose proof I as J.
    rewrite segments_are in I. apply in_map_iff in I. destruct I as (s & E & I).
    apply in_numbered in I. destruct I as (n & N). exists n, s. split; [assumption|].
    subst ab. split; [exact J|reflexivity].
  - right. right. left. apply in_map_iff in I. destruct I as (g & <- & I). exists g.
    split; [exact I|reflexivity].
  - right. right. right. destruct (what_it_fills P); [|destruct I]. destruct I as [<-|[]].
    split; reflexivity.
Qed.
Lemma vertex_in v : In v (domain_vertices P) -> In (vertex_cell v) (linear_cells P).
Proof. intros I. unfold linear_cells. apply in_or_app. left. apply in_map_iff. eauto. Qed.
Lemma segment_in a b : In (a, b) (domain_segments P) -> In (segment_cell a b) (linear_cells P).
Proof.
  intros I. unfold linear_cells. apply in_or_app. right. apply in_or_app. left.
  apply in_map_iff. exists (a, b). auto.
Qed.
Lemma corner_cell k : is_corner (Table.of_list Datatypes.id (roles p)) k = true ->
  In (vertex_cell (spot d c k)) (linear_cells P).
Proof.
  intros K. apply vertex_in. rewrite vertices_are.
  now apply (corner_vertex Co c accepts p planar kind shown part_accepts).
Qed.
Lemma number_cell n s : numbered (segments p) n = Some s ->
  In (segment_cell (spot d c (from s)) (spot d c (last_reached s))) (linear_cells P).
Proof.
  intros N. apply segment_in. rewrite segments_are.
  change (In (segment_ends d c s) (part_segments d c p)). apply in_map.
  now apply numbered_in with n.
Qed.
Lemma ends_differ n s : numbered (segments p) n = Some s ->
  spot d c (from s) <> spot d c (last_reached s).
Proof.
  intros N E.
  destruct (segment_checked c p planar kind shown part_accepts n s N) as (a & b & Fa & Fb & O & _).
  destruct (point_known Co c accepts _ _ Fa) as (Sa & Ha & _).
  destruct (point_known Co c accepts _ _ Fb) as (Sb & Hb & _).
  pose proof (on_segment_between d (unit_of c) a b b Ha Hb Hb O) as [_ B].
  unfold last_reached in E. rewrite Sa, Sb in E.
  assert (Kb : forall k x, Table.find k (points_of (mesh_of c)) = Some x ->
    exists e, numbered (points c) k = Some e).
  { intros k x Fx. rewrite (find_point (c := c)) in Fx.
    destruct (numbered (points c) k); [eauto|discriminate]. }
  destruct (Kb _ _ Fa) as (ea & Ea). destruct (Kb _ _ Fb) as (eb & Eb).
  pose proof (spots_once Co one_d c accepts _ _ _ _ Ea Eb) as Once. rewrite Sa, Sb in Once.
  specialize (Once E).
  unfold last_reached in *. rewrite <- Once, Fa in Fb. injection Fb as <-.
  unfold on_segment in O. cbv zeta in O. apply andb_prop in O. destruct O as [O _].
  apply andb_prop in O. destruct O as [O _]. apply andb_prop in O. destruct O as [O _].
  apply Z.ltb_lt in O.
  assert (Z : forall l, inner_product (differences l l) (differences l l) = 0%Z).
  { induction l as [|x l IH]; [reflexivity|]. cbn. rewrite IH. lia. }
  rewrite Z in O. lia.
Qed.

(** What is held has faces. *)
Definition holds (w : holder) (f : linear_cell) : Prop :=
  match w with
  | InSegment n => exists s, numbered (segments p) n = Some s /\
      f = segment_cell (spot d c (from s)) (spot d c (last_reached s))
  | InPolygon k => exists g, number k g /\ f = polygon_cell g
  end.
Lemma holds_face w f q : holds w f -> cell_points f q -> exists s, face_at c s q /\
  all_held c p F inside w s.
Proof.
  destruct w as [n|k]; cbn [holds].
  - intros (s & N & ->) C.
    destruct (segment_face Co c accepts p planar kind shown part_accepts F inside no_inside
      steps_accept n s q N C)
      as (y & z & Fa & Al & _). eauto.
  - intros (g & K & ->) C. now apply (polygon_face k g).
Qed.
Lemma holds_once w f g : holds w f -> holds w g -> f = g.
Proof.
  destruct w as [n|k]; cbn [holds].
  - intros (s & N & ->) (t & N' & ->). assert (t = s) by congruence. now subst.
  - intros (x & K & ->) (y & K' & ->). now rewrite (number_once k x y K K').
Qed.
Lemma holds_dimension w f : holds w f ->
  cell_dimension f = match w with InSegment _ => 1%nat | InPolygon _ => 2%nat end.
Proof. destruct w; cbn [holds]; intros (x & _ & ->); reflexivity. Qed.
(** The segment in a polygon. *)
Lemma holds_inside k j f s : holds (InPolygon j) f -> In k (inside (InPolygon j)) ->
  numbered (segments p) k = Some s ->
  within (conv [spot d c (from s); spot d c (last_reached s)]) (cell_points f).
Proof. intros (g & K & ->) I N q C. exact (polygon_segment j g k s q K I N C). Qed.

Lemma meeting_held w w' f g q : holds w f -> holds w' g ->
  ~ (within (cell_points f) (cell_points g) /\ within (cell_points g) (cell_points f)) ->
  cell_points f q -> cell_points g q ->
  exists h, In h (linear_cells P) /\ cell_points h q /\
    within (cell_points h) (cell_points f) /\ within (cell_points h) (cell_points g) /\
    (cell_dimension h < cell_dimension f \/ cell_dimension h < cell_dimension g)%nat.
Proof.
  intros W W' N Fq Gq. destruct (holds_face w f q W Fq) as (s & Fs & Al).
  destruct (holds_face w' g q W' Gq) as (s' & Fs' & Al').
  destruct (common_face Or Co one_d c accepts p planar kind shown part_accepts F inside w w' s s' q
    Fs Fs' Al Al')
    as [(k & _ & _ & K & ->)|(h & O & O')].
  - exists (vertex_cell (spot d c k)). split; [now apply corner_cell|]. split; [reflexivity|].
    split; [now intros x ->|]. split; [now intros x ->|].
    rewrite (holds_dimension w f W). cbn. destruct w; lia.
  - assert (Same : w = w' -> False).
    { intros ->. rewrite (holds_once w' f g W W') in N. apply N. split; now intros x. }
    assert (One : forall k n, on_segment_number c p n q -> InSegment n = k ->
      exists t, numbered (segments p) n = Some t /\
        cell_points (segment_cell (spot d c (from t)) (spot d c (last_reached t))) q).
    { intros k n (t & T & C) _. exists t. split; [assumption|exact C]. }
    destruct O as [->|(k & j & -> & -> & I & On)], O' as [E'|(k' & j' & E' & -> & I' & On')].
    + exfalso. now apply Same.
    + (* a segment in the polygon g *) subst h. exists f. destruct W as (t & T & ->).
      split; [now apply (number_cell k')|]. split; [assumption|]. split; [now intros x|].
      split; [exact (holds_inside k' j' g t W' I' T)|]. rewrite (holds_dimension _ g W'). cbn. lia.
    + subst w'. exists g. destruct W' as (t & T & ->).
      split; [now apply (number_cell k)|]. split; [assumption|].
      split; [exact (holds_inside k j f t W I T)|]. split; [now intros x|].
      rewrite (holds_dimension _ f W). cbn. lia.
    + injection E' as <-. destruct On as (t & T & C).
      exists (segment_cell (spot d c (from t)) (spot d c (last_reached t))).
      split; [now apply (number_cell k)|]. split; [exact C|].
      split; [exact (holds_inside k j f t W I T)|]. split; [exact (holds_inside k j' g t W' I' T)|].
      rewrite (holds_dimension _ f W). cbn. lia.
Qed.

Theorem complex_from_faces :
  (forall f q, In f (domain_polygons P) -> boundary (polygon_cell f) q -> exists a b,
     In (a, b) (domain_segments P) /\ conv [a; b] q /\
       within (conv [a; b]) (boundary (polygon_cell f))) ->
  (what_it_fills P = Enclosed -> forall q, boundary region_cell q ->
    exists g, In g (linear_cells P) /\
     cell_points g q /\ within (cell_points g) (boundary region_cell)) ->
  piecewise_linear_complex P.
Proof.
  intros Bp Br. constructor.
  - rewrite vertices_are, segments_are.
    apply (segments_complex Or Co one_d c accepts p planar kind shown part_accepts F inside
      no_inside steps_accept).
  - intros f q I B.
    destruct (cell_cases f I) as [(v & _ & ->)|[(n & s & N & J & ->)|[(g & J & ->)|(En & ->)]]].
    + exfalso. destruct B as (Q & r & R & Away). cbn in Q, R, Away. subst q r.
      apply (Away 1 ltac:(lra)).
      apply between_end.
    + pose proof (ends_differ n s N) as Df. pose proof (boundary_of_segment _ _ q Df) as X.
      apply X in B.
      assert (V : forall v, In v (ends_of c s) -> In (vertex_cell v) (linear_cells P)).
      { intros v Iv. apply vertex_in. rewrite vertices_are.
        now apply (ends_vertices Co c accepts p planar kind shown part_accepts n s N). }
      exists (vertex_cell q). split; [apply V; destruct B as [->| ->]; [now left|right; now left]|].
      split; [reflexivity|]. intros x ->. now apply boundary_of_segment.
    + destruct (Bp g q J B) as (a & b & Iab & C & W). exists (segment_cell a b).
      split; [now apply segment_in|].
      split; [exact C|exact W].
    + now apply Br.
  - intros f g q If Ig N Fq Gq.
    assert (Vertex : forall v h, In v (domain_vertices P) -> q = v -> cell_points h q ->
      In h (linear_cells P) ->
      (0 < cell_dimension h)%nat -> exists k, In k (linear_cells P) /\ cell_points k q /\
        within (cell_points k) (fun x => x = v) /\ within (cell_points k) (cell_points h) /\
        (cell_dimension k < cell_dimension h)%nat).
    { intros v h Iv -> Hq Ih Dh. exists (vertex_cell v). split; [now apply vertex_in|].
      split; [reflexivity|].
      split; [now intros x|]. split; [now intros x ->|assumption]. }
    assert (Held : forall h, In h (linear_cells P) ->
      (exists v, In v (domain_vertices P) /\ h = vertex_cell v) \/
      (exists w, holds w h /\ (cell_dimension h < d)%nat) \/ what_it_fills P = Enclosed /\
        h = region_cell).
    { intros h Ih. destruct (cell_cases h Ih) as [X|[(n & s & M & _ & ->)|[(x & J & ->)|X]]]; auto.
      - right. left. exists (InSegment n). split; [exists s; auto|cbn; lia].
      - right. left. destruct (numbered_polygon x J) as (k & K). exists (InPolygon k).
        split; [exists x; auto|]. cbn. assert (3 <= d)%nat; [|lia]. apply polygons_3. intros E.
        rewrite E in J. destruct J. }
    destruct (Held f If) as [(v & Iv & Ef)|[(w & W & Df)|(En & Ef)]],
             (Held g Ig) as [(v' & Iv' & Eg)|[(w' & W' & Dg)|(En' & Eg)]].
    + exfalso. subst f g. cbn in Fq, Gq. subst. apply N. split; now intros x.
    + subst f. cbn in Fq. destruct (Vertex v g Iv Fq Gq Ig) as (k & K1 & K2 & K3 & K4 & K5).
      { rewrite (holds_dimension w' g W'). destruct w'; lia. }
      exists k. auto 6.
    + subst f. cbn in Fq. destruct (Vertex v g Iv Fq Gq Ig) as (k & K1 & K2 & K3 & K4 & K5);
        [subst g; cbn; lia|].
      exists k. auto 6.
    + subst g. cbn in Gq. destruct (Vertex v' f Iv' Gq Fq If) as (k & K1 & K2 & K3 & K4 & K5).
      { rewrite (holds_dimension w f W). destruct w; lia. }
      exists k. auto 6.
    + now apply (meeting_held w w').
    + exists f. split; [assumption|]. split; [assumption|]. split; [now intros x|].
      split; [subst g; now apply in_region|]. right. subst g. cbn. assumption.
    + subst g. cbn in Gq. destruct (Vertex v' f Iv' Gq Fq If) as (k & K1 & K2 & K3 & K4 & K5);
        [subst f; cbn; lia|].
      exists k. auto 6.
    + exists g. split; [assumption|]. split; [assumption|]. split; [subst f; now apply in_region|].
      split; [now intros x|]. left. subst f. cbn. assumption.
    + exfalso. subst f g. apply N. split; now intros x.
Qed.
End Cells.
