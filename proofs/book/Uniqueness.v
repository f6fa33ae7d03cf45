(** * Strongly Delaunay simplices, and uniqueness  (Book: Prop. 4.2, 4.3, Theorem 4.4)

    Let two simplices have witness planes and share a point q.  Over the first its own plane is
    the higher one, because it carries the lifted vertices and nothing is below the other; over
    the second it is the other way round.  So the planes agree at q, and then at every vertex that
    has a part in q.  If the first plane carries no other lifted points than its vertices, the
    vertices that have a part in q are shared: q is in a shared face ([planes_meet]).

    Nothing depends on the heights.  With |p|^2 the statements are the book's; with other heights
    they hold for weighted and for perturbed points.  Every theorem is first about heights. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Independence LiftingMap.
Import ListNotations.
Open Scope R_scope.

Section Interiors.
Context {d : nat}.
Implicit Types (p q v : point d) (l : list (R * point d)) (s f : simplex d).

(** A point in the relative interior of s: every vertex has a part in it. *)
Definition relative_interior s q : Prop := exists l,
  (forall a p, In (a, p) l -> 0 < a /\ In p s) /\ (forall v, In v s -> exists a, In (a, v) l) /\
  total l = 1 /\ combination l = q.

Lemma relative_interior_conv s q : relative_interior s q -> conv s q.
Proof.
  intros (l & Pos & _ & Tot & Com). exists l. split; [|auto].
  intros a p I. destruct (Pos a p I). split; [lra|assumption].
Qed.
Lemma relative_interior_point s : s <> [] -> exists q, relative_interior s q.
Proof.
  intros N. set (n := INR (length s)).
  assert (P : 0 < n) by (apply lt_0_INR; destruct s; [congruence|cbn; lia]).
  exists (combination (map (fun v => (/ n, v)) s)), (map (fun v => (/ n, v)) s).
  split; [|split; [|split; [|reflexivity]]].
  - intros a p I. apply in_map_iff in I. destruct I as (v & E & I). injection E as <- <-.
    split; [now apply Rinv_0_lt_compat|assumption].
  - intros v I. exists (/ n). apply in_map_iff. eauto.
  - rewrite (total_map s (fun _ => / n)), sum_over_const. unfold n. field. fold n. lra.
Qed.
Lemma inside_relative_interior (t : frame d) q : inside t q -> relative_interior (vertices t) q.
Proof.
  intros I. exists (map (fun i => (bary t i q, vertex t i)) (seq 0 (Datatypes.S d))).
  assert (Tot : sum_over (seq 0 (Datatypes.S d)) (fun i => bary t i q) = 1) by apply bary_sum.
  split; [|split; [|split]].
  - intros a p H. apply in_map_iff in H. destruct H as (i & E & Hi). injection E as <- <-.
    apply in_seq_d in Hi. split; [now apply I|]. apply in_vertices. eauto.
  - intros v Hv. apply in_vertices in Hv. destruct Hv as (i & Hi & ->). exists (bary t i q).
    apply in_map_iff. exists i. split; [reflexivity|]. now apply in_seq_d.
  - now rewrite total_map.
  - apply affine_separate. intros g G. rewrite affine_combination_map by assumption.
    now rewrite (interpolation t g q G).
Qed.

(** Only the whole simplex, of its faces, contains points of its relative interior: the barycentric
    coordinate of v is positive there, and zero on a face without v. *)
Lemma face_with_interior s f q : affinely_independent s -> relative_interior s q -> incl f s ->
  conv f q -> incl s f.
Proof.
  intros Ind (l & Pos & All & Tot & Com) If C v Hv.
  destruct (in_points v f) as [|N]; [assumption|exfalso].
  destruct (dual_functions s Ind) as (g & D). destruct (In_nth s v origin Hv) as (i & Hi & E).
  destruct (D i Hi) as [A B].
  assert (Own : g i v = 1).
  { rewrite <- E, (B i Hi). destruct (Nat.eq_dec i i); congruence. }
  assert (Other : forall p, In p s -> p <> v -> g i p = 0).
  { intros p Hp Np. destruct (In_nth s p origin Hp) as (k & Hk & <-). rewrite (B k Hk).
    destruct (Nat.eq_dec i k) as [<-|]; [contradiction|reflexivity]. }
  assert (0 <= - g i q).
  { apply (affine_conv (fun p => - g i p) f); [now apply affine_opp| |assumption].
    intros p Hp. rewrite Other; [lra|auto|congruence]. }
  assert (0 < g i q); [|lra].
  rewrite <- Com, (affine_combination (g i) l A Tot). destruct (All v Hv) as (a & I).
  apply sum_pos with (a, v); [|assumption|].
  - intros [b p] J. destruct (Pos b p J). cbn [fst snd].
    destruct (point_eq_dec p v) as [->|Np]; [rewrite Own|rewrite Other by assumption]; lra.
  - destruct (Pos a v I). cbn [fst snd]. rewrite Own. lra.
Qed.

(** Points with the coefficient zero do not matter. *)
Lemma drop_zeros (keep : R * point d -> bool) l :
  (forall a p, In (a, p) l -> keep (a, p) = false -> a = 0) ->
  total (filter keep l) = total l /\ combination (filter keep l) = combination l.
Proof.
  induction l as [|[a p] l IH]; intros H; [split; reflexivity|]. cbn [filter].
  destruct IH as [Et Ec]; [intros b q I; apply H; now right|].
  destruct (keep (a, p)) eqn:K.
  - now rewrite !total_cons, !combination_cons, Et, Ec.
  - rewrite !total_cons, !combination_cons, Et, Ec, (H a p (or_introl eq_refl) K), scale_zero.
    split; [ring|]. now rewrite origin_plus.
Qed.
End Interiors.

(** ** Heights *)
Section Planes.
Context {d : nat}.
Implicit Types (p q v : point d) (h : point d -> R) (S : list (point d)) (s t f : simplex d)
  (T U : list (simplex d)).

Lemma affine_plane_difference (a a' : point d) b b' :
  affine (fun p => 1 * plane a' b' p + (-1) * plane a b p).
Proof. apply affine_combine; apply affine_plane. Qed.

(** Terms that are not negative, with a sum that is not positive, are zero. *)
Lemma sum_terms_zero {A} (l : list A) g : (forall x, In x l -> 0 <= g x) -> sum_over l g <= 0 ->
  forall x, In x l -> g x = 0.
Proof.
  intros N L x I. destruct (Rle_lt_or_eq_dec _ _ (N x I)) as [P|]; [|congruence].
  pose proof (sum_pos l g x N I P). lra.
Qed.

(** A simplex with a plane that carries no other lifted points than its vertices, and another with
    a plane: they meet in the face that is spanned by the vertices they share. *)
Theorem planes_meet h S s t : strong_witness_plane h S s -> witness_plane h S t ->
  incl s S -> incl t S -> forall q, conv s q -> conv t q -> conv (meet t s) q.
Proof.
  intros (a & b & Os & Bs) (a' & b' & Ot & Bt) Is It q Cs (l & Hl & Tot & Com).
  set (g p := 1 * plane a' b' p + (-1) * plane a b p).
  assert (A : affine g) by apply affine_plane_difference.
  assert (Low : 0 <= - g q).
  { apply (affine_conv (fun p => - g p) s q); [now apply affine_opp| |assumption].
    intros v Hv. unfold g. rewrite (Os v Hv). specialize (Bt v (Is v Hv)). lra. }
  rewrite <- Com, (affine_combination g l A Tot) in Low.
  assert (Up : forall ap, In ap l -> 0 <= fst ap * g (snd ap)).
  { intros [c v] I. destruct (Hl c v I) as [Pc Hv]. cbn [fst snd].
    apply Rmult_le_pos; [assumption|].
    unfold g. rewrite (Ot v Hv). destruct (Bs v (It v Hv)). lra. }
  assert (Z := sum_terms_zero l _ Up ltac:(lra)).
  set (shared := fun ap : R * point d => if in_points (snd ap) s then true else false).
  destruct (drop_zeros shared l) as [Ft Fc].
  { intros c v I K. unfold shared in K. cbn in K. destruct (in_points v s) as [|N]; [discriminate|].
    specialize (Z (c, v) I). cbn [fst snd] in Z. apply Rmult_integral in Z.
    destruct Z as [Z|Z]; [assumption|exfalso]. apply N.
    destruct (Hl c v I) as [_ Hv]. destruct (Bs v (It v Hv)) as [_ E]. apply E.
    unfold g in Z. rewrite (Ot v Hv) in Z. lra. }
  exists (filter shared l). split; [|split; congruence].
  intros c v I. apply filter_In in I. destruct I as [I K]. unfold shared in K. cbn in K.
  destruct (in_points v s); [|discriminate]. destruct (Hl c v I). split; [assumption|].
  now apply in_meet.
Qed.

(** Proposition 4.2, for heights: two simplices, one with a strong witness plane, meet in a shared
    face, which may be empty. *)
Theorem proposition_4_2_heights h S s t : strong_witness_plane h S s -> witness_plane h S t ->
  incl s S -> incl t S ->
  exists f, incl f s /\ incl f t /\ forall q, (conv s q /\ conv t q) <-> conv f q.
Proof.
  intros Ws Wt Is It. exists (meet t s).
  assert (Ms : incl (meet t s) s) by (intros v Hv; now apply in_meet in Hv).
  assert (Mt : incl (meet t s) t) by (intros v Hv; now apply in_meet in Hv).
  split; [assumption|]. split; [assumption|]. intros q. split.
  - intros [Cs Ct]. now apply (planes_meet h S).
  - intros C. split; now apply (conv_incl (meet t s)).
Qed.

(** Proposition 4.3, for heights: every triangulation whose simplices have witness planes contains
    every simplex with a strong one.  (Not all points need be vertices.) *)
Theorem proposition_4_3_heights h S T s : fills S T -> (forall t, In t T -> witness_plane h S t) ->
  strong_witness_plane h S s -> affinely_independent s -> s <> [] -> incl s S -> faces_of T s.
Proof.
  intros (_ & _ & _ & V & U) W Ws Ind Ne Is.
  split; [now apply independent_NoDup|]. split; [assumption|].
  destruct (relative_interior_point s Ne) as (q & Q).
  assert (Cs : conv s q) by now apply relative_interior_conv.
  destruct (proj1 (U q) (conv_incl s S q Is Cs)) as (t & Ht & Ct). exists t.
  split; [assumption|].
  assert (Cm : conv (meet t s) q) by (apply (planes_meet h S); auto).
  intros v Hv. assert (I : In v (meet t s)); [|now apply in_meet in I].
  apply (face_with_interior s (meet t s) q); [assumption..| |assumption|assumption].
  intros x Hx. now apply in_meet in Hx.
Qed.

(** Definition 4.2 for heights: no d+2 lifted points in one hyperplane. *)
Definition generic_heights h S : Prop :=
  forall X, NoDup X -> incl X S -> length X = Datatypes.S (Datatypes.S d) ->
    ~ exists a b, forall v, In v X -> plane a b v = h v.

Lemma generic_heights_norm2 S : generic S <-> generic_heights norm2 S.
Proof.
  split; intros G X N I L.
  - rewrite <- cospherical_coplanar. now apply G.
  - rewrite cospherical_coplanar. now apply G.
Qed.

(** Then the witness planes of d-simplices are strong. *)
Lemma generic_strong h S t : generic_heights h S -> NoDup t -> length t = Datatypes.S d ->
  incl t S -> witness_plane h S t -> strong_witness_plane h S t.
Proof.
  intros G N L I (a & b & O & B). exists a, b. split; [assumption|]. intros p Hp.
  split; [now apply B|]. intros E. destruct (in_points p t) as [|Np]; [assumption|exfalso].
  apply (G (p :: t)).
  - now constructor.
  - now apply incl_cons.
  - cbn. now rewrite L.
  - exists a, b. intros v [<-|Hv]; auto.
Qed.

Lemma filled_independent S T t : fills S T -> In t T -> affinely_independent t.
Proof.
  intros (L & (Ind & _) & _) Ht. destruct (L t Ht) as [N Lt]. apply Ind. split; [assumption|].
  split; [now intros ->|]. exists t. split; [assumption|apply incl_refl].
Qed.

(** Theorem 4.4, for heights: the d-simplices of one are d-simplices of the other, ... *)
Theorem theorem_4_4_heights h S T U : generic_heights h S -> fills S T -> fills S U ->
  (forall t, In t T -> witness_plane h S t) -> (forall u, In u U -> witness_plane h S u) ->
  forall t, In t T -> exists u, In u U /\ same t u.
Proof.
  intros G FT FU WT WU t Ht. destruct FT as (L & FT'). destruct (L t Ht) as [N Lt].
  pose proof (filled_independent S T t (conj L FT') Ht) as Ind.
  destruct FT' as (_ & _ & V & _). specialize (V t Ht).
  destruct (proposition_4_3_heights h S U t) as (_ & _ & u & Hu & I); auto.
  - now apply generic_strong; auto.
  - now intros ->.
  - exists u. split; [assumption|]. split; [assumption|].
    destruct FU as (LU & _). destruct (LU u Hu) as [Nu Lu].
    apply NoDup_length_incl; [assumption|lia|assumption].
Qed.
(** ... and the complexes are the same. *)
Theorem generic_same_complex h S T U : generic_heights h S -> fills S T -> fills S U ->
  (forall t, In t T -> witness_plane h S t) -> (forall u, In u U -> witness_plane h S u) ->
  forall s, faces_of T s <-> faces_of U s.
Proof.
  assert (K : forall T U, generic_heights h S -> fills S T -> fills S U ->
    (forall t, In t T -> witness_plane h S t) -> (forall u, In u U -> witness_plane h S u) ->
    forall s, faces_of T s -> faces_of U s).
  { clear T U. intros T U G FT FU WT WU s (N & Ne & t & Ht & I).
    destruct (theorem_4_4_heights h S T U G FT FU WT WU t Ht) as (u & Hu & Iu & _).
    split; [assumption|]. split; [assumption|]. exists u. split; [assumption|].
    now apply incl_tran with t. }
  intros G FT FU WT WU s. split; now apply K.
Qed.

(** Two simplices whose interiors overlap have one plane (it is enough that the second contains a
    point of the relative interior of the first). *)
Theorem overlap_coplanar h S s t q : witness_plane h S s -> witness_plane h S t ->
  incl s S -> incl t S -> relative_interior s q -> conv t q ->
  exists a b, (forall v, In v s \/ In v t -> plane a b v = h v) /\
    forall p, In p S -> plane a b p <= h p.
Proof.
  intros (a & b & Os & Bs) (a' & b' & Ot & Bt) Is It (l & Pos & All & Tot & Com) Ct.
  exists a', b'. split; [|assumption].
  intros v [Hv|Hv]; [|auto].
  set (g p := 1 * plane a' b' p + (-1) * plane a b p).
  assert (A : affine g) by apply affine_plane_difference.
  assert (Up : 0 <= g q).
  { apply (affine_conv g t q); [assumption| |assumption]. intros w Hw. unfold g.
    rewrite (Ot w Hw). specialize (Bs w (It w Hw)). lra. }
  assert (E : - g q = sum_over l (fun ap => fst ap * - g (snd ap))).
  { rewrite <- Com. apply (affine_combination (fun p => - g p)); [|assumption].
    now apply affine_opp. }
  assert (Low : forall ap, In ap l -> 0 <= fst ap * - g (snd ap)).
  { intros [c w] I. destruct (Pos c w I) as [Pc Hw]. cbn [fst snd]. apply Rmult_le_pos; [lra|].
    unfold g. rewrite (Os w Hw). specialize (Bt w (Is w Hw)). lra. }
  destruct (All v Hv) as (c & I).
  pose proof (sum_terms_zero l _ Low ltac:(lra) (c, v) I) as Z. cbn [fst snd] in Z.
  destruct (Pos c v I) as [Pc _]. apply Rmult_integral in Z. destruct Z as [Z|Z]; [lra|].
  unfold g in Z. rewrite (Os v Hv) in Z. lra.
Qed.
(** ** Faces of simplices with strong witness planes *)

(** Terms that are positive, or zero with a positive slope, are positive for a small e. *)
Lemma small_slope {A} (l : list A) (x y : A -> R) :
  (forall i, In i l -> 0 <= x i /\ (x i = 0 -> 0 < y i)) ->
  exists e0, 0 < e0 /\ forall e, 0 < e <= e0 -> forall i, In i l -> 0 < x i + e * y i.
Proof.
  induction l as [|i l IH]; intros H; [exists 1; split; [lra|intros e _ i []]|].
  destruct IH as (e0 & He0 & K); [intros k Hk; apply H; now right|].
  destruct (H i (or_introl eq_refl)) as [X Y].
  assert (exists e1, 0 < e1 /\ forall e, 0 < e <= e1 -> 0 < x i + e * y i) as (e1 & He1 & K1).
  { destruct (Rle_lt_or_eq_dec _ _ X) as [P|Z].
    - set (m := Rabs (y i) + 1).
      assert (M : 0 < m /\ - m < y i).
      { unfold m, Rabs. destruct (Rcase_abs (y i)); lra. }
      exists (x i / m). assert (E : x i / m * m = x i) by (field; lra).
      split; [apply Rdiv_lt_0_compat; lra|]. intros e He. nra.
    - exists 1. split; [lra|]. intros e He. specialize (Y (eq_sym Z)). rewrite <- Z. nra. }
  exists (Rmin e0 e1). split; [now apply Rmin_glb_lt|]. intros e He k [<-|Hk].
  - apply K1. pose proof (Rmin_r e0 e1). lra.
  - apply (K e); [|assumption]. pose proof (Rmin_l e0 e1). lra.
Qed.

(** Tilt the plane a little, down at the vertices that the face has not. *)
Lemma strong_face h S (t : frame d) s : incl (vertices t) S -> incl s (vertices t) ->
  strong_witness_plane h S (vertices t) -> strong_witness_plane h S s.
Proof.
  intros It Is (a & b & O & B).
  set (g p := sum (Datatypes.S d) (fun i => if in_points (vertex t i) s then 0 else bary t i p)).
  assert (Ag : affine g).
  { apply affine_sum. intros i Hi. apply in_seq_d in Hi.
    destruct (in_points (vertex t i) s); [apply affine_const|now apply bary_affine]. }
  assert (Gv : forall i, (i <= d)%nat ->
    g (vertex t i) = if in_points (vertex t i) s then 0 else 1).
  { intros i Hi. unfold g, sum. rewrite (sum_one _ _ i).
    - now rewrite bary_own.
    - apply seq_NoDup.
    - now apply in_seq_d.
    - intros k Hk N. apply in_seq_d in Hk. rewrite bary_other by assumption.
      now destruct (in_points (vertex t k) s). }
  set (others := filter (fun p => if in_points p s then false else true) S).
  assert (In_others : forall p, In p others <-> In p S /\ ~ In p s).
  { intros p. unfold others. rewrite filter_In. destruct (in_points p s); intuition discriminate. }
  destruct (small_slope others (fun p => h p - plane a b p) g) as (e & He & K).
  { intros p Hp. apply In_others in Hp. destruct Hp as [Hp N]. destruct (B p Hp) as [L E].
    split; [lra|]. intros Z. assert (V : In p (vertices t)) by (apply E; lra).
    apply in_vertices in V. destruct V as (i & Hi & ->). rewrite Gv by assumption.
    destruct (in_points (vertex t i) s); [contradiction|lra]. }
  destruct (affine_combine (plane a b) g 1 (- e) (affine_plane a b) Ag) as (a' & b' & E).
  assert (On : forall v, In v s -> plane a' b' v = h v).
  { intros v Hv. rewrite <- E, (O v (Is v Hv)). pose proof (Is v Hv) as V. apply in_vertices in V.
    destruct V as (i & Hi & ->). rewrite Gv by assumption.
    destruct (in_points (vertex t i) s); [ring|contradiction]. }
  exists a', b'. split; [assumption|]. intros p Hp. destruct (in_points p s) as [I|N].
  - rewrite (On p I). split; [lra|auto].
  - specialize (K e ltac:(lra) p (proj2 (In_others p) (conj Hp N))). cbn beta in K.
    rewrite <- E. split; [lra|intros; lra].
Qed.

(** With generic heights the complex consists of the simplices with strong witness planes. *)
Theorem generic_complex_heights h S T : generic_heights h S -> fills S T ->
  (forall t, In t T -> witness_plane h S t) -> forall s, faces_of T s <->
    s <> [] /\ incl s S /\ affinely_independent s /\ strong_witness_plane h S s.
Proof.
  intros G F W s. split.
  - intros (N & Ne & t & Ht & I). pose proof F as (L & (Ind & _) & _ & V & _).
    split; [assumption|]. split; [apply incl_tran with t; auto|].
    split; [apply Ind; split; [assumption|]; split; [assumption|]; now exists t|].
    destruct (L t Ht) as [Nt Lt].
    destruct (frame_of t Lt (filled_independent S T t F Ht)) as (u & <-).
    apply (strong_face h S u); [auto|assumption|]. apply generic_strong; auto.
  - intros (Ne & I & Ind & Ws). now apply (proposition_4_3_heights h S T).
Qed.
End Planes.

(** ** Delaunay simplices: the heights are |p|^2 *)
Section Delaunay.
Context {d : nat}.
Implicit Types (p q v : point d) (S : list (point d)) (s t f : simplex d)
  (T U : list (simplex d)).

(** Proposition 4.2: a strongly Delaunay simplex and a Delaunay simplex meet in a shared face, or
    not at all (then [f] is empty). *)
Theorem proposition_4_2 S s t : incl s S -> incl t S -> strongly_delaunay S s -> delaunay S t ->
  exists f, incl f s /\ incl f t /\ forall q, (conv s q /\ conv t q) <-> conv f q.
Proof.
  intros Is It Ds Dt. apply (proposition_4_2_heights norm2 S); try assumption.
  - now apply strongly_delaunay_witness_plane.
  - now apply delaunay_witness_plane.
Qed.

(** Proposition 4.3: every Delaunay triangulation of S contains every strongly Delaunay simplex. *)
Theorem proposition_4_3 S T s : delaunay_triangulation S T ->
  incl s S -> s <> [] -> affinely_independent s -> strongly_delaunay S s -> faces_of T s.
Proof.
  intros ((F & _) & D) Is Ne Ind Ds. apply (proposition_4_3_heights norm2 S); try assumption.
  - intros t Ht. apply delaunay_witness_plane. auto.
  - now apply strongly_delaunay_witness_plane.
Qed.

(** Theorem 4.4: a generic point set has no more than one Delaunay triangulation.  (That it has
    one is in [Existence.v].) *)
Theorem theorem_4_4 S T U : generic S ->
  delaunay_triangulation S T -> delaunay_triangulation S U ->
  forall s, faces_of T s <-> faces_of U s.
Proof.
  intros G ((FT & _) & DT) ((FU & _) & DU).
  apply (generic_same_complex norm2 S); try assumption.
  - now apply generic_heights_norm2.
  - intros t Ht. apply delaunay_witness_plane. auto.
  - intros u Hu. apply delaunay_witness_plane. auto.
Qed.
Theorem theorem_4_4_simplices S T U : generic S ->
  delaunay_triangulation S T -> delaunay_triangulation S U ->
  forall t, In t T -> exists u, In u U /\ same t u.
Proof.
  intros G ((FT & _) & DT) ((FU & _) & DU).
  apply (theorem_4_4_heights norm2 S); try assumption.
  - now apply generic_heights_norm2.
  - intros t Ht. apply delaunay_witness_plane. auto.
  - intros u Hu. apply delaunay_witness_plane. auto.
Qed.

(** Section 4.2: it is "composed of every strongly Delaunay simplex". *)
Theorem generic_delaunay_complex S T : generic S -> delaunay_triangulation S T ->
  forall s, faces_of T s <->
    s <> [] /\ incl s S /\ affinely_independent s /\ strongly_delaunay S s.
Proof.
  intros G ((F & _) & D) s. rewrite (generic_complex_heights norm2 S T).
  - split; intros (Ne & I & Ind & X); repeat (split; [assumption|]);
      now apply strongly_delaunay_witness_plane.
  - now apply generic_heights_norm2.
  - assumption.
  - intros t Ht. apply delaunay_witness_plane. auto.
Qed.

(** Weighted points, which need not be vertices: with generic weights there is no more than one
    weighted Delaunay triangulation. *)
Theorem weighted_unique (w : point d -> R) S T U : generic_heights (fun p => norm2 p - w p) S ->
  weighted_delaunay_triangulation w S T -> weighted_delaunay_triangulation w S U ->
  forall s, faces_of T s <-> faces_of U s.
Proof.
  intros G (FT & DT) (FU & DU). now apply (generic_same_complex (fun p => norm2 p - w p) S).
Qed.

(** In general Delaunay triangulations differ in cospherical points only: two Delaunay simplices
    whose interiors overlap have a common empty circumball. *)
Theorem overlap_cospherical S s t q : incl s S -> incl t S -> delaunay S s -> delaunay S t ->
  relative_interior s q -> conv t q ->
  exists c r2, circumball s c r2 /\ circumball t c r2 /\ forall p, In p S -> ~ dist2 c p < r2.
Proof.
  rewrite !delaunay_witness_plane. intros Is It Ds Dt Q C.
  destruct (overlap_coplanar norm2 S s t q) as (a & b & O & B); try assumption.
  assert (D : delaunay S (s ++ t)).
  { apply delaunay_witness_plane. exists a, b. split; [|assumption]. intros v Hv. apply O.
    now apply in_app_or. }
  destruct D as (c & r2 & O' & B'). exists c, r2.
  split; [|split; [|assumption]]; intros v Hv; apply O', in_or_app; auto.
Qed.
End Delaunay.
