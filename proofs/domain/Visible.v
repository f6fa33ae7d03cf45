(** * A vertex that can be seen from inside a simplex  (Book: Definitions 2.13, 4.6)

    If on the way from a point of a simplex to a vertex of the domain there is no point of a vertex,
    segment or polygon, but at its end, then the way is in what the domain fills, and it respects
    the domain. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Domains DomainRules Vectors Affine Frame Faces
  Independence.
From Circumspect Require Import Combinations Lists Solid Necessary.
Import ListNotations.
Open Scope R_scope.

Section Visible.
Context {d : nat}.
Variables (P : domain d) (T : list (simplex d)).
Hypothesis triangulates : solid_triangulation P T.

Lemma face_dec f q : faces_of T f -> conv f q \/ ~ conv f q.
Proof.
  intros (_ & _ & s & Is & If). destruct (all_framed P T triangulates) as (ts & are).
  rewrite <- are in Is. apply in_map_iff in Is. destruct Is as (u & <- & Iu).
  set (fits k := 0 <= bary u k q /\ (0 < bary u k q -> In (vertex u k) f)).
  destruct (Forall_dec fits) with (l := seq 0 (S d)) as [F|F].
  - intros k. unfold fits. destruct (Rle_dec 0 (bary u k q)); [|right; tauto].
    destruct (Rlt_dec 0 (bary u k q)); [|left; tauto].
    destruct (in_points (vertex u k) f); [left; tauto|right; tauto].
  - left. apply (conv_face u f q If). rewrite Forall_forall in F.
    split; intros k Hk; apply in_seq_d, F in Hk; apply Hk.
  - right. intros C. apply F, Forall_forall. intros k Hk. apply in_seq_d in Hk.
    apply (conv_face u f q If) in C.
    destruct C as [I C]. split; auto.
Qed.
Lemma cell_dec X q : In X (cells P) -> X q \/ ~ X q.
Proof.
  intros I. destruct (union_of_cell P T triangulates X I) as (F & HF & E).
  destruct (finite_dec (fun s => conv s q) F) as [Y|N].
  - intros s Is. apply face_dec, HF, Is.
  - left. now apply E.
  - right. intros Xq. now apply N, E.
Qed.


Variables (t : simplex d) (x v : point d).
Hypothesis member_t : In t T.
Hypothesis x_in : conv t x.
Hypothesis v_in : what_it_fills P = Hull -> conv (domain_vertices P) v.
Hypothesis off : forall X, In X (low_cells P) -> forall s, 0 <= s < 1 -> ~ X (between x v s).

Lemma start_low X : In X (low_cells P) -> ~ X x.
Proof. intros I H. apply (off X I 0); [lra|]. now rewrite between_start. Qed.
Lemma start_in_region : region P x.
Proof.
  destruct (proj2 (covers P T triangulates x)) as (X & IX & Xx); [eauto|].
  apply low_or_region in IX. destruct IX as [IX| ->]; [|assumption]. exfalso.
  now apply (start_low X IX).
Qed.
Lemma way_in_region s : 0 <= s <= 1 -> region P (between x v s).
Proof.
  intros Hs. pose proof start_in_region as R. unfold region in *. destruct (what_it_fills P) eqn:K.
  2: { apply conv_conv with [x; v]; [|apply conv_two; eauto]. intros p [<-|[<-|[]]]; auto. }
  assert (Off : forall r, 0 <= r < 1 -> ~ walls_of P (between x v r)).
  { intros r Hr W. apply walls_are_cells in W. destruct W as (X & IX & Xr).
    exact (off X (walls_low P X IX) r Hr Xr). }
  assert (Far : forall r e, between x (between x v r) e = between x v (e * r)).
  { intros r e. change (between (d := d)) with (mix (d := d)). apply affine_separate. intros f F.
    rewrite !affine_mix by assumption. ring. }
  destruct (Rlt_dec s 1) as [L|N].
  - apply (enclosed_along _ _ x); [assumption|]. intros e He. rewrite Far. apply Off. nra.
  - replace s with 1 by lra. rewrite between_end.
    destruct (finite_dec (fun X : point d -> Prop => X v) (wall_cells P)) as [Y|N'].
    + intros X IX. apply cell_dec, low_or_region. left. now apply walls_low.
    + split; [exact I|]. left. now apply walls_are_cells.
    + apply (enclosed_along _ _ x); [assumption|]. intros e He W. destruct (Rlt_dec e 1) as [Le|Ne].
      * apply (Off e); [lra|assumption].
      * replace e with 1 in W by lra. rewrite between_end in W. apply walls_are_cells in W.
        now apply N'.
Qed.

Theorem seen : visible P x v.
Proof.
  assert (Way : forall q, conv [x; v] q -> region P q).
  { intros q C. apply conv_two in C. destruct C as (s & Hs & ->). now apply way_in_region. }
  split.
  - intros q C. exists (region P). split; [apply low_or_region; now right|auto].
  - intros X IX. pose proof IX as IX'. apply low_or_region in IX. destruct IX as [IX| ->].
    + assert (Only : forall q, X q -> conv [x; v] q -> q = v).
      { intros q Xq C. apply conv_two in C. destruct C as (s & Hs & ->).
        destruct (Rlt_dec s 1) as [L|N].
        - exfalso. apply (off X IX s); [lra|assumption].
        - replace s with 1 by lra. apply between_end. }
      destruct (cell_dec X v IX') as [Y|N].
      * exists [[v]]. split.
        { intros f [<-|[]] y [<-|[]]. right. now left. }
        intros q. split.
        { intros [Xq C]. rewrite (Only q Xq C). exists [v]. split; [now left|].
          now apply conv_singleton. }
        intros (f & [<-|[]] & C). apply conv_singleton in C. subst q. split; [assumption|].
        apply conv_point. right. now left.
      * exists []. split; [intros f []|]. intros q. split; [|intros (f & [] & _)].
        intros [Xq C]. rewrite (Only q Xq C) in Xq. contradiction.
    + exists [[x; v]]. split; [intros f [<-|[]]; apply incl_refl|]. intros q. split.
      * intros [_ C]. exists [x; v]. split; [now left|assumption].
      * intros (f & [<-|[]] & C). auto.
Qed.
End Visible.
