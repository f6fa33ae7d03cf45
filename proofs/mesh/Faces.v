(** * Faces: the faces of a simplex with a frame, and complexes of them

    A face of a simplex is known by some of its vertices; it consists of the points of the simplex
    whose other coordinates are zero ([conv_face]).  Vertices with dual affine functions are
    affinely independent.  If the points common to two simplices have the same carriers in both,
    then any face of the one and any face of the other meet in a shared face ([faces_meet]): this
    is what makes a mesh a simplicial complex ([frames_complex]). *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame.
Import ListNotations.
Open Scope R_scope.

Section Points.
Context {d : nat}.
Implicit Types (p q v : point d) (X Y : list (point d)).

(** Points are equal or not: this rests on the decidability of equality of real numbers, which
    the library derives from its axioms. *)
Lemma point_eq_dec p q : {p = q} + {p <> q}.
Proof.
  destruct (Req_EM_T (dist2 p q) 0) as [E|N].
  - left. apply norm2_zero in E. rewrite <- (minus_plus p q), E. apply origin_plus.
  - right. intros ->. apply N. unfold dist2. rewrite minus_self. apply inner_origin.
Qed.
Definition in_points p X : {In p X} + {~ In p X} := in_dec point_eq_dec p X.

(** The members of both. *)
Definition meet X Y := filter (fun p => if in_points p Y then true else false) X.
Lemma in_meet p X Y : In p (meet X Y) <-> In p X /\ In p Y.
Proof. unfold meet. rewrite filter_In. destruct (in_points p Y); intuition discriminate. Qed.

(** ** Convex hulls *)

Lemma conv_incl X Y q : incl X Y -> conv X q -> conv Y q.
Proof.
  intros I (l & Hl & T & C). exists l. split; [|split; assumption].
  intros a p H. destruct (Hl a p H). auto.
Qed.
Lemma conv_same X Y q : same X Y -> (conv X q <-> conv Y q).
Proof. intros [A B]. split; now apply conv_incl. Qed.
Lemma conv_point X p : In p X -> conv X p.
Proof.
  intros H. exists [(1, p)]. split; [|split].
  - intros a q [E|[]]. injection E as <- <-. split; [lra|assumption].
  - cbn. ring.
  - rewrite combination_cons, scale_one. apply plus_origin.
Qed.
Lemma conv_empty q : ~ conv [] q.
Proof.
  intros (l & Hl & T & _). destruct l as [|[a p] l]; [cbn in T; lra|].
  destruct (Hl a p (or_introl eq_refl)) as [_ []].
Qed.

(** The segment from a point of conv X to a member of X is in conv X. *)
Lemma conv_mix X q v e : conv X q -> In v X -> 0 <= e <= 1 -> conv X (mix q v e).
Proof.
  intros (l & L & H & <-) Hv He.
  exists ((e, v) :: map (fun av => ((1 - e) * fst av, snd av)) l). split; [|split].
  - intros a p [E|I].
    + injection E as <- <-. split; [lra|assumption].
    + apply in_map_iff in I. destruct I as ([a' p'] & E & I). injection E as <- <-.
      destruct (L _ _ I). split; [|assumption]. cbn. apply Rmult_le_pos; lra.
  - assert (T : total (map (fun av => ((1 - e) * fst av, snd av)) l) = (1 - e) * total l).
    { clear. induction l as [|[a p] l IH]; [cbn; ring|]. cbn [map fst snd].
      rewrite !total_cons, IH. ring. }
    rewrite total_cons, T, H. ring.
  - assert (C : combination (map (fun av => ((1 - e) * fst av, snd av)) l) =
                scale (1 - e) (combination l)).
    { clear. induction l as [|[a p] l IH].
      - symmetry. apply scale_origin.
      - cbn [map fst snd]. now rewrite !combination_cons, IH, scale_plus, scale_scale. }
    rewrite combination_cons, C. unfold mix. apply plus_comm.
Qed.

(** A combination of the points vertex(i), i in [l], in terms of the list of coefficients. *)
Lemma total_map {A} (l : list A) (c : A -> R) (v : A -> point d) :
  total (map (fun i => (c i, v i)) l) = sum_over l c.
Proof.
  induction l as [|i l IH]; [reflexivity|]. cbn [map sum_over]. now rewrite total_cons, IH.
Qed.
Lemma affine_combination_map {A} (l : list A) (c : A -> R) (v : A -> point d) (f : point d -> R) :
  affine f -> sum_over l c = 1 ->
  f (combination (map (fun i => (c i, v i)) l)) = sum_over l (fun i => c i * f (v i)).
Proof.
  intros F T. rewrite (affine_combination f) by (assumption || now rewrite total_map).
  clear. induction l as [|i l IH]; [reflexivity|]. cbn [map sum_over fst snd]. now rewrite IH.
Qed.

(** The combination of points with coefficients whose sum is zero. *)
Lemma affine_difference (f : point d -> R) l : affine f -> total l = 0 -> combination l = origin ->
  sum_over l (fun ap => fst ap * f (snd ap)) = 0.
Proof.
  intros (a & b & F) T C.
  assert (G : forall m, inner a (combination m) + total m * b =
                   sum_over m (fun ap => fst ap * f (snd ap))).
  { induction m as [|[c p] m IH].
    - cbn [sum_over total combination fold_right]. rewrite inner_origin_r. ring.
    - rewrite combination_cons, total_cons, inner_plus_r, inner_scale_r.
      cbn [sum_over fst snd]. rewrite <- IH, F. unfold plane. ring. }
  rewrite <- G, T, C, inner_origin_r. ring.
Qed.

(** Coefficients that are given by the position. *)
Lemma combine_positions (c : nat -> R) X : combine (map c (seq 0 (length X))) X =
  map (fun k => (c k, nth k X origin)) (seq 0 (length X)).
Proof.
  assert (M : forall m, combine (map c (seq m (length X))) X =
    map (fun k => (c k, nth (k - m) X origin)) (seq m (length X))).
  { induction X as [|p X IH]; intros m; [reflexivity|].
    cbn [length seq map combine]. rewrite Nat.sub_diag. cbn [nth]. f_equal. rewrite IH.
    apply map_ext_in. intros k Hk. apply in_seq in Hk.
    now replace (k - m)%nat with (S (k - S m)) by lia. }
  rewrite M. apply map_ext. intros k. now rewrite Nat.sub_0_r.
Qed.

(** ** Affine independence *)

(** Points are affinely independent if each has an affine function that is 1 at it and 0 at the
    others. *)
Lemma dual_independent X : NoDup X ->
  (forall v, In v X ->
     exists f, affine f /\ f v = 1 /\ forall w, In w X -> w <> v -> f w = 0) ->
  affinely_independent X.
Proof.
  intros N D a L T C c Hc.
  assert (exists v, In (c, v) (combine a X)) as (v & Hv).
  { clear - L Hc. revert X L. induction a as [|x a IH]; intros [|p X] L;
      try discriminate; [destruct Hc|]. destruct Hc as [->|Hc].
    - exists p. now left.
    - destruct (IH Hc X) as (v & Hv); [now injection L|]. exists v. now right. }
  destruct (D v (in_combine_r _ _ _ _ Hv)) as (f & F & One & Zero).
  pose proof (affine_difference f (combine a X) F T C) as E.
  rewrite (sum_one _ _ (c, v)) in E; [cbn in E; rewrite One in E; lra| |assumption|].
  - clear - N. revert a. induction N as [|p X Np N IH]; intros [|x a]; cbn; constructor; auto.
    intros H. now apply in_combine_r in H.
  - intros [x w] Hx Nx. cbn. destruct (point_eq_dec w v) as [->|Nw].
    + exfalso. apply Nx. f_equal. clear - N Hx Hv. revert a Hx Hv.
      induction N as [|p X Np N IH]; intros [|y a] Hx Hv; try destruct Hx as [Ex|Hx];
        try destruct Hv as [Ev|Hv]; try (now cbn in *).
      * congruence.
      * injection Ex as -> ->. now apply in_combine_r in Hv.
      * injection Ev as -> ->. now apply in_combine_r in Hx.
      * now apply (IH a).
    + rewrite (Zero w); [ring| |assumption]. exact (in_combine_r _ _ _ _ Hx).
Qed.

(** Affinely independent points are different. *)
Lemma independent_NoDup X : affinely_independent X -> NoDup X.
Proof.
  intros H. apply NoDup_nth with (d := origin). intros i j Hi Hj E.
  destruct (Nat.eq_dec i j) as [|N]; [assumption|exfalso].
  set (c k := if Nat.eq_dec k i then 1 else if Nat.eq_dec k j then -1 else 0).
  assert (S0 : forall n g, (forall k, k <> i -> k <> j -> g k = 0) -> (i < n)%nat -> (j < n)%nat ->
            sum n g = g i + g j).
  { intros n g Z Gi Gj. unfold sum.
    rewrite (sum_ext (seq 0 n) g (fun k => (if Nat.eq_dec k i then g i else 0) +
      (if Nat.eq_dec k j then g j else 0))).
    - rewrite sum_plus, (sum_one _ _ i), (sum_one _ (fun k => if Nat.eq_dec k j then _ else _) j);
        try apply seq_NoDup; try (apply in_seq; lia).
      + destruct (Nat.eq_dec i i), (Nat.eq_dec j j); congruence.
      + intros k _ K. now destruct (Nat.eq_dec k j).
      + intros k _ K. now destruct (Nat.eq_dec k i).
    - intros k _. destruct (Nat.eq_dec k i), (Nat.eq_dec k j); try congruence; subst; try ring.
      rewrite Z by assumption. ring. }
  pose proof (combine_positions c X) as M.
  assert (Ci : c i = 1) by (unfold c; destruct (Nat.eq_dec i i); congruence).
  assert (Cj : c j = -1).
  { unfold c. destruct (Nat.eq_dec j i), (Nat.eq_dec j j); congruence. }
  assert (Z : forall k, k <> i -> k <> j -> c k = 0).
  { intros k Ki Kj. unfold c. destruct (Nat.eq_dec k i), (Nat.eq_dec k j); congruence. }
  assert (T : total (combine (map c (seq 0 (length X))) X) = 0).
  { rewrite M, total_map. change (sum (length X) c = 0). rewrite S0, Ci, Cj by assumption. ring. }
  assert (O : combination (combine (map c (seq 0 (length X))) X) = origin).
  { apply affine_separate. intros f F. set (l := combine (map c (seq 0 (length X))) X) in *.
    clearbody l.
    assert (Eo : f (combination ((1, origin) :: l)) = f origin).
    { rewrite (affine_combination f); [|assumption|rewrite total_cons, T; ring].
      cbn [sum_over fst snd]. rewrite M.
      transitivity (1 * f origin + sum (length X) (fun k => c k * f (nth k X origin))).
      - f_equal. unfold sum. clear. induction (seq 0 (length X)) as [|k m IH]; [reflexivity|].
        cbn [map sum_over fst snd]. now rewrite IH.
      - rewrite S0, Ci, Cj, E; try assumption; [ring|]. intros. rewrite Z by assumption. ring. }
    now rewrite combination_cons, scale_one, origin_plus in Eo. }
  assert (1 = 0); [|lra].
  rewrite <- Ci. apply (H (map c (seq 0 (length X)))).
  - now rewrite map_length, seq_length.
  - exact T.
  - exact O.
  - apply in_map, in_seq. lia.
Qed.
End Points.

Section Faces.
Context {d : nat}.
Implicit Types (p q v : point d) (f s : list (point d)) (t u : frame d).

(** Different vertices of a simplex with a frame are affinely independent. *)
Lemma face_independent t f : incl f (vertices t) -> NoDup f -> affinely_independent f.
Proof.
  intros I N. apply dual_independent; [assumption|]. intros v Hv.
  apply I, in_vertices in Hv. destruct Hv as (i & Hi & ->). exists (bary t i).
  split; [now apply bary_affine|]. split; [now apply bary_own|].
  intros w Hw Nw. apply I, in_vertices in Hw. destruct Hw as (k & Hk & ->).
  apply bary_other; auto; congruence.
Qed.
Lemma vertices_independent t : affinely_independent (vertices t).
Proof. apply (face_independent t); [apply incl_refl | apply vertices_NoDup]. Qed.

(** The carrier of a point: the vertices at which its coordinate is positive. *)
Definition carrier_index t q i := if Rlt_dec 0 (bary t i q) then true else false.
Definition carrier t q : simplex d :=
  map (vertex t) (filter (carrier_index t q) (seq 0 (S d))).
Lemma in_carrier t q v :
  In v (carrier t q) <-> exists i, (i <= d)%nat /\ 0 < bary t i q /\ v = vertex t i.
Proof.
  unfold carrier. rewrite in_map_iff. split.
  - intros (i & <- & Hi). apply filter_In in Hi. destruct Hi as [Hi P]. apply in_seq_d in Hi.
    exists i. unfold carrier_index in P. destruct (Rlt_dec 0 (bary t i q)); [auto|discriminate].
  - intros (i & Hi & P & ->). exists i. split; [reflexivity|]. apply filter_In.
    split; [now apply in_seq_d|]. unfold carrier_index. now destruct (Rlt_dec 0 (bary t i q)).
Qed.
Lemma carrier_incl t q : incl (carrier t q) (vertices t).
Proof. intros v Hv. apply in_carrier in Hv. destruct Hv as (i & Hi & _ & ->).
  apply in_vertices. eauto. Qed.
Lemma conv_carrier t q : inside_closed t q -> conv (carrier t q) q.
Proof.
  intros I. set (l := filter (carrier_index t q) (seq 0 (S d))).
  assert (E : forall g, sum_over l (fun i => bary t i q * g i) =
                   sum (S d) (fun i => bary t i q * g i)).
  { intros g. unfold l, sum.
    assert (H : forall i, In i (seq 0 (S d)) -> 0 <= bary t i q).
    { intros i Hi. apply I. now apply in_seq_d. }
    induction (seq 0 (S d)) as [|i m IH]; [reflexivity|].
    cbn [filter]. unfold carrier_index at 1. destruct (Rlt_dec 0 (bary t i q)); cbn [sum_over];
      rewrite IH by (intros; apply H; now right); [reflexivity|].
    pose proof (H i (or_introl eq_refl)). replace (bary t i q) with 0 by lra. ring. }
  assert (T : sum_over l (fun i => bary t i q) = 1).
  { rewrite <- (bary_sum t q). rewrite (sum_ext l _ (fun i => bary t i q * 1)) by (intros; ring).
    rewrite E. apply sum_ext. intros; ring. }
  exists (map (fun i => (bary t i q, vertex t i)) l). split; [|split].
  - intros a p Hp. apply in_map_iff in Hp. destruct Hp as (i & X & Hi). injection X as <- <-.
    split; [|now apply in_map]. apply filter_In in Hi. apply I. now apply in_seq_d.
  - now rewrite total_map.
  - apply affine_separate. intros g G. rewrite affine_combination_map by assumption.
    rewrite (interpolation t g q G). apply E.
Qed.

(** A face consists of the points of the simplex with no positive coordinate at other vertices. *)
Theorem conv_face t f q : incl f (vertices t) ->
  (conv f q <-> inside_closed t q /\ forall i, (i <= d)%nat -> 0 < bary t i q -> In (vertex t i) f).
Proof.
  intros I. split.
  - intros C. split; [apply conv_vertices; now apply (conv_incl f)|].
    intros i Hi P. destruct (in_points (vertex t i) f) as [|N]; [assumption|exfalso].
    assert (0 <= - bary t i q); [|lra].
    apply (affine_conv (fun p => - bary t i p) f q); [|intros p Hp|assumption].
    + apply affine_opp. now apply bary_affine.
    + pose proof (I p Hp) as V. apply in_vertices in V. destruct V as (k & Hk & ->).
      rewrite bary_other; [lra|assumption|assumption|congruence].
  - intros [J H]. apply (conv_incl (carrier t q)); [|now apply conv_carrier].
    intros v Hv. apply in_carrier in Hv. destruct Hv as (i & Hi & P & ->). auto.
Qed.

(** Each point of both simplices has the same carrier in both: it is enough to say that the
    carrier in the first is among that in the second. *)
Definition agree t u : Prop := forall q, inside_closed t q -> inside_closed u q ->
  forall i, (i <= d)%nat -> 0 < bary t i q ->
    exists k, (k <= d)%nat /\ vertex t i = vertex u k /\ 0 < bary u k q.

(** Then any two faces of theirs meet in a shared face, or not at all. *)
Lemma faces_meet t u s r : agree t u -> incl s (vertices t) -> incl r (vertices u) ->
  exists f, incl f s /\ incl f r /\ forall q, conv s q -> conv r q -> conv f q.
Proof.
  intros A Is Ir. exists (meet s r). split; [|split].
  - intros p Hp. now apply in_meet in Hp.
  - intros p Hp. now apply in_meet in Hp.
  - intros q Cs Cr. apply (conv_face t); [intros p Hp; apply in_meet in Hp; now apply Is|].
    apply (conv_face t s q Is) in Cs. destruct Cs as [It Ps].
    apply (conv_face u r q Ir) in Cr. destruct Cr as [Iu Pr].
    split; [assumption|]. intros i Hi P. apply in_meet. split; [auto|].
    destruct (A q It Iu i Hi P) as (k & Hk & -> & Pk). auto.
Qed.

(** Conversely, if two simplices meet in a shared face, then they agree. *)
Lemma meet_agree t u f : incl f (vertices t) -> incl f (vertices u) ->
  (forall q, conv (vertices t) q -> conv (vertices u) q -> conv f q) -> agree t u.
Proof.
  intros It Iu M q Qt Qu i Hi P.
  assert (C : conv f q) by (apply M; now apply conv_vertices).
  apply (conv_face t f q It) in C. destruct C as [_ C].
  pose proof (Iu _ (C i Hi P)) as V. apply in_vertices in V. destruct V as (k & Hk & E).
  exists k. split; [assumption|]. split; [assumption|].
  rewrite (interpolation t (bary u k) q (bary_affine u k Hk)).
  apply sum_pos with i; [|now apply in_seq_d|].
  - intros j Hj. apply in_seq_d in Hj. pose proof (Qt j Hj) as Pj.
    destruct (Rle_lt_or_eq_dec _ _ Pj) as [Lj| <-]; [|lra].
    apply Rmult_le_pos; [assumption|].
    pose proof (Iu _ (C j Hj Lj)) as V. apply in_vertices in V. destruct V as (m & Hm & ->).
    rewrite bary_vertex by assumption. destruct (Nat.eq_dec k m); lra.
  - rewrite E, bary_own by assumption. lra.
Qed.

End Faces.

(** ** Complexes of simplices with frames *)
Section Complex.
Context {d : nat} {T : Type} (tets : list T) (geo : T -> frame d).
Definition simplices : list (simplex d) := map (fun t => vertices (geo t)) tets.

Lemma in_simplices s : In s simplices <-> exists t, In t tets /\ s = vertices (geo t).
Proof. unfold simplices. rewrite in_map_iff. split; intros (t & A & B); exists t; auto. Qed.

Theorem frames_complex :
  (forall t u, In t tets -> In u tets -> agree (geo t) (geo u)) ->
  simplicial_complex (faces_of simplices).
Proof.
  intros A. split; [|split].
  - intros s (N & _ & t & Ht & I). apply in_simplices in Ht. destruct Ht as (t' & _ & ->).
    now apply (face_independent (geo t')).
  - intros s f (_ & _ & t & Ht & I) If N E. split; [assumption|]. split; [assumption|].
    exists t. split; [assumption|]. now apply incl_tran with s.
  - intros s r (_ & _ & t & Ht & Is) (_ & _ & u & Hu & Ir).
    apply in_simplices in Ht, Hu. destruct Ht as (t' & Ht & ->), Hu as (u' & Hu & ->).
    now apply (faces_meet (geo t') (geo u')); [apply A| |].
Qed.

Lemma simplices_length s : In s simplices -> NoDup s /\ length s = S d.
Proof.
  intros H. apply in_simplices in H. destruct H as (t & _ & ->).
  split; [apply vertices_NoDup | apply vertices_length].
Qed.

Lemma simplices_different : NoDup tets ->
  (forall t u, In t tets -> In u tets -> same (vertices (geo t)) (vertices (geo u)) -> t = u) ->
  ForallOrdPairs (fun s r => ~ same s r) simplices.
Proof.
  intros N H. unfold simplices. induction N as [|t l Nt N IH]; cbn [map]; constructor.
  - apply Forall_forall. intros s Hs E. apply in_map_iff in Hs. destruct Hs as (u & <- & Hu).
    apply Nt. rewrite (H t u); auto; [now left|now right].
  - apply IH. intros; apply H; auto; now right.
Qed.
End Complex.
