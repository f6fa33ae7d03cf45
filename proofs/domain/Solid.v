(** * Triangulations of domains in which nothing dangles

    The mesh of a certificate is one of these: only d-simplices are listed.  Whatever is listed
    besides, it is one of these too if the d-simplices cover the domain ([solid_if_covered]): what
    else there is are their faces. *)
From Coq Require Import Rbase Rfunctions Lra List Arith Lia.
From Circumspect Require Import Definitions Domains Vectors Affine Frame Faces Independence.
Import ListNotations.
Open Scope R_scope.

Section Solid.
Context {d : nat}.
Implicit Types (P : domain d) (T K : list (simplex d)).

Definition solid_triangulation P T : Prop :=
  (forall t, In t T -> NoDup t /\ length t = S d) /\
  ForallOrdPairs (fun s t => ~ same s t) T /\
  simplicial_complex (faces_of T) /\
  (forall v, In v (domain_vertices P) -> exists t, In t T /\ In v t) /\
  (forall X, In X (cells P) -> union_of_simplices T X) /\
  (forall q, underlying P q <-> exists t, In t T /\ conv t q).
Definition solid_plc_triangulation P T : Prop :=
  solid_triangulation P T /\ forall t v, In t T -> In v t -> In v (domain_vertices P).
Definition solid_conforming_delaunay P T : Prop :=
  solid_triangulation P T /\ forall t, In t T -> delaunay (concat T) t.
Definition solid_cdt P T : Prop :=
  solid_plc_triangulation P T /\ forall t, In t T -> constrained_delaunay (domain_vertices P) P t.
Definition solid_steiner_cdt P T : Prop :=
  solid_triangulation P T /\ forall t, In t T -> constrained_delaunay (concat T) P t.

(** ** They are what the definitions say, of complexes of d-simplices *)

Lemma pairs_weaker {A} (Q Q' : A -> A -> Prop) l : (forall a b, In a l -> In b l -> Q a b ->
  Q' a b) ->
  ForallOrdPairs Q l -> ForallOrdPairs Q' l.
Proof.
  induction l as [|a l IH]; intros H F; [constructor|]. inversion F as [|? ? F1 F2]; subst.
  constructor.
  - rewrite Forall_forall in *. intros b I. apply H; [now left|now right|auto].
  - apply IH; [|assumption]. intros x y X Y. apply H; now right.
Qed.
Theorem solid_steiner P T : solid_triangulation P T <-> steiner_triangulation P T /\ solid T.
Proof.
  split.
  - intros (D & O & H). split; [|intros s I; now apply D]. split; [|split; [|exact H]].
    + intros s I. destruct (D s I) as [N L]. split; [assumption|]. split; [now intros ->|lia].
    + revert O. apply pairs_weaker. auto.
  - intros ((D & O & H) & So). split; [|split; [|exact H]].
    + intros s I. split; [now apply D|now apply So].
    + revert O. apply pairs_weaker. intros a b Ia _ Q. apply Q, So, Ia.
Qed.
Theorem solid_plc P T : solid_plc_triangulation P T <-> plc_triangulation P T /\ solid T.
Proof. unfold solid_plc_triangulation, plc_triangulation. rewrite solid_steiner. tauto. Qed.
Theorem solid_conforming P T : solid_conforming_delaunay P T <-> conforming_delaunay P T /\ solid T.
Proof. unfold solid_conforming_delaunay, conforming_delaunay. rewrite solid_steiner. tauto. Qed.
Lemma solid_has_to_be T V P : solid T -> (forall t, In t T -> constrained_delaunay V P t) <->
  (forall s, In s T -> has_to_be_constrained_delaunay T s -> constrained_delaunay V P s).
Proof. intros So. split; [auto|]. intros H t I. apply H; [assumption|]. left. now apply So. Qed.
Theorem solid_cdts P T : solid_cdt P T <-> cdt P T /\ solid T.
Proof.
  unfold solid_cdt, cdt. rewrite solid_plc. split.
  - intros ((H & So) & C). split; [|assumption]. split; [assumption|].
    now apply (solid_has_to_be T).
  - intros ((H & C) & So). split; [now split|]. now apply (solid_has_to_be T).
Qed.
Theorem solid_steiner_cdts P T : solid_steiner_cdt P T <-> steiner_cdt P T /\ solid T.
Proof.
  unfold solid_steiner_cdt, steiner_cdt. rewrite solid_steiner. split.
  - intros ((H & So) & C). split; [|assumption]. split; [assumption|].
    now apply (solid_has_to_be T).
  - intros ((H & C) & So). split; [now split|]. now apply (solid_has_to_be T).
Qed.
End Solid.
