(** * The caller's points and simplices, as the checker finds them

    Rows that name d+1 known points are simplices of the caller's list; those that are not
    degenerate have frames.  Nothing is assumed of the caller's mesh. *)
From Coq Require Import Rbase Rfunctions Lra Lia List Arith ZArith Bool.
From Circumspect Require Import Refutation Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Faces LiftingMap Breach.
From Circumspect Require Import Orientation Integers RefutationSigns.
Import ListNotations.
Open Scope R_scope.

Section Caller.
Context {d : nat}.
Context {orient : list (point d) -> R} {pr : predicates} {r : R}.
Hypothesis M : measured orient pr r.
Variables (P : list site) (l : list row) (S : Table.t site) (L : Table.t row).
Hypothesis shaped_points : Forall (well_shaped d) P.
Hypothesis find_point : forall k, Table.find k S = numbered P k.
Hypothesis find_row : forall t, Table.find t L = numbered l t.
Notation place := (@place_of d r).
Notation places := (map (@place_of d r)).
Notation framed := (framed orient pr r).
Notation caller_entry := (@caller_entry d r P).
Notation caller_rows := (@caller_rows d r P l).
Notation caller_points := (@caller_points d r P).
(* So that all lemmas have the same arguments. *)
Set Default Proof Using "All".

(** ** Entries and simplices *)

Lemma caller_named n : caller_entry n = option_map place (named S n).
Proof. destruct n as [k|]; [cbn; now rewrite find_point|reflexivity]. Qed.
Lemma named_in n p : named S n = Some p -> In p P.
Proof. destruct n as [k|]; [|discriminate]. cbn. rewrite find_point. apply numbered_in. Qed.

Lemma all_named_rows x X : all_named S x = Some X ->
  map caller_entry x = map Some (places X) /\ incl X P.
Proof.
  revert X. induction x as [|n x IH]; intros X E; cbn in E.
  - injection E as <-. split; [reflexivity|apply incl_nil_l].
  - destruct (named S n) as [p|] eqn:N; [|discriminate].
    destruct (all_named S x) as [Y|]; [|discriminate]. injection E as <-.
    destruct (IH Y eq_refl) as [Q I]. split.
    + cbn. now rewrite caller_named, N, Q.
    + intros q [<-|Hq]; [now apply named_in in N|auto].
Qed.

(** The d+1 known vertices of row x. *)
Record vertices_are (x : row) (X : list site) : Prop := {
  vertices_rows : map caller_entry x = map Some (places X);
  vertices_known : incl X P;
  vertices_number : length X = Datatypes.S d
}.
Lemma vertices_shaped x X : vertices_are x X -> Forall (well_shaped d) X.
Proof. intros [_ I _]. eapply incl_Forall; eauto. Qed.
Lemma simplex_of_vertices x X : simplex_of pr S x = Some X -> vertices_are x X.
Proof.
  unfold simplex_of, right_length. rewrite (dimension_d M).
  destruct (has_length (Datatypes.S d) x) eqn:N; [|discriminate]. apply has_length_length in N.
  intros E. apply all_named_rows in E. destruct E as [E I]. constructor; auto.
  apply (f_equal (@length _)) in E. rewrite !map_length in E. congruence.
Qed.
Lemma proper_simplex_of_frame x X : proper_simplex_of pr S x = Some X ->
  vertices_are x X /\ exists t, framed X t.
Proof.
  unfold proper_simplex_of. destruct (simplex_of pr S x) as [Y|] eqn:E; [|discriminate].
  destruct (proper pr Y) eqn:Q; [|discriminate]. intros H. injection H as ->.
  apply simplex_of_vertices in E. split; [assumption|].
  apply proper_framed; auto; [now apply vertices_shaped in E|now destruct E].
Qed.

Lemma row_at_in t f : row_at L t f = true ->
  exists x, numbered l t = Some x /\ In (map caller_entry x) caller_rows /\ f x = true.
Proof.
  unfold row_at. rewrite find_row. destruct (numbered l t) as [x|] eqn:E; [|discriminate].
  intros H. exists x. split; [reflexivity|]. split; [|assumption].
  apply in_map. now apply numbered_in in E.
Qed.
Lemma entry_at_in t i f : entry_at L t i f = true ->
  exists x n, numbered l t = Some x /\ In (map caller_entry x) caller_rows /\
    nth_error x i = Some n /\ f n = true.
Proof.
  intros H. apply row_at_in in H. destruct H as (x & N & I & H).
  destruct (nth_error x i) as [n|] eqn:E; [|discriminate]. now exists x, n.
Qed.
Lemma simplex_at_in t f : simplex_at pr S L t f = true ->
  exists x X, numbered l t = Some x /\ vertices_are x X /\ listed caller_rows (places X) /\
    f X = true.
Proof.
  intros H. apply row_at_in in H. destruct H as (x & N & I & H).
  destruct (simplex_of pr S x) as [X|] eqn:E; [|discriminate]. apply simplex_of_vertices in E.
  exists x, X. repeat split; try apply E; auto. unfold listed. now rewrite <- (vertices_rows x X E).
Qed.
Lemma proper_at_in t f : proper_at pr S L t f = true ->
  exists X g, framed X g /\ incl X P /\ listed caller_rows (places X) /\ f X = true.
Proof.
  intros H. apply row_at_in in H. destruct H as (x & N & I & H).
  destruct (proper_simplex_of pr S x) as [X|] eqn:E; [|discriminate].
  apply proper_simplex_of_frame in E. destruct E as (E & g & G).
  exists X, g. repeat split; try apply E; try apply G; auto.
  unfold listed. now rewrite <- (vertices_rows x X E).
Qed.
Lemma proper_with_in K f : proper_with pr S K f = true ->
  exists X g, framed X g /\ incl X P /\ f X = true.
Proof.
  unfold proper_with. rewrite andb_true_iff. intros [_ H]. revert H.
  destruct (proper_simplex_of pr S (map Some K)) as [X|] eqn:E; [|discriminate].
  apply proper_simplex_of_frame in E. destruct E as (E & g & G). intros H.
  exists X, g. repeat split; try apply E; try apply G; auto.
Qed.
Lemma basis_spans K : proper_with pr S K (fun _ => true) = true -> spans caller_points.
Proof.
  intros H. apply proper_with_in in H. destruct H as (X & g & FX & IX & _). exists (places X).
  split; [now apply incl_map|]. rewrite <- (framed_vertices X g FX).
  split; [apply vertices_length|apply vertices_independent].
Qed.
Lemma point_at_in k f : point_at S k f = true -> exists p, In p P /\ f p = true.
Proof.
  unfold point_at. rewrite find_point. destruct (numbered P k) as [p|] eqn:E; [|discriminate].
  intros H. exists p. split; [now apply numbered_in in E|assumption].
Qed.
Lemma caller_point p : In p P -> In (place p) caller_points.
Proof. apply in_map. Qed.
Lemma caller_incl X : incl X P -> incl (places X) caller_points.
Proof. apply incl_map. Qed.
Lemma shaped_in p : In p P -> well_shaped d p.
Proof. now apply Forall_forall. Qed.
End Caller.
