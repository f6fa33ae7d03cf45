(** * The checker of refutations of a mesh alone

    [refute_alone] is extracted; [AloneRefuted.v] proves what its acceptance means. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Refutation Complexes.
Import ListNotations.
Open Scope Z_scope.

(** Of a triangulation these rules are those of a complex, too. *)
Definition concerns_complexes (e : evidence) : bool :=
  match e with
  | UnknownVertex _ _ | RepeatedVertex _ _ _ | Degenerate _ | DuplicateSimplex _ _ | Overlap _ _ _ _
      | UnusedPoint _ => true
  | _ => false
  end.

Section Evidence.
Variables (pr : predicates) (S : Table.t site) (L : Table.t row).
Definition in_both (t u : positive) (q : site) (w : Z) (f : list site -> list site -> bool) :
  bool :=
  proper_at pr S L t (fun X => proper_at pr S L u (fun Y =>
    point_written pr q w && in_simplex pr X q w && in_simplex pr Y q w && f X Y)).
Definition none_among (X Y : list site) : bool :=
  forallb (fun p => negb (existsb (same_place p) Y)) X.
(** Two of the points at least. *)
Definition several (X : list site) : bool := match X with _ :: _ :: _ => true | _ => false end.
Definition single (X : list site) : bool := match X with [_] => true | _ => false end.

Definition shown_against (e : against_complex) : bool :=
  match e with
  | AsOfPoints => false
  | Hanging t u q w => in_both t u q w (fun X Y =>
      several (carrier_of pr X q w) && single (carrier_of pr Y q w) &&
        none_among (carrier_of pr Y q w) X)
  | Crossing t u q w => in_both t u q w (fun X Y =>
      several (carrier_of pr X q w) && several (carrier_of pr Y q w) &&
      none_among (carrier_of pr X q w) (carrier_of pr Y q w))
  | EqualPoints p q => negb (Pos.eqb p q) && point_at S p (fun a => point_at S q (same_place a))
  end.
End Evidence.

Definition refute_alone_in (pr : predicates) (x : complex_refutation) : bool :=
  let m := mesh_alone x in
  match against x with
  | AsOfPoints => match refuted m with Triangulation => concerns_complexes (because m) &&
      refute_in pr m | _ => false end
  | e => (0 <? unit_numerator m) && (0 <? unit_denominator m) && forallb (shaped pr) (sites m) &&
         shown_against pr (Table.of_list id (sites m)) (Table.of_list id (rows m)) e
  end.
Definition refute_alone (D : plane_or_space) (x : complex_refutation) : bool :=
  refute_alone_in (predicates_of D) x.

Definition complex_rule_of (x : complex_refutation) : rule_of_complex :=
  match against x with
  | AsOfPoints => OfPoints (rule_of (because (mesh_alone x)))
  | Hanging _ _ _ _ => HangingVertex
  | Crossing _ _ _ _ => FacesCross
  | EqualPoints _ _ => PointsEqual
  end.
