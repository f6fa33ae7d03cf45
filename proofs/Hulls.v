(** * Convex hulls: what the claim [convex-hull] says, and what its certificates and refutations
    hold

    docs/theory/questions.md has the same definition in words.  [CERTIFICATE.md] describes the
    files. *)
From Coq Require Import String Rbase List ZArith.
From Circumspect Require Import Definitions Domains.
Import ListNotations.
Open Scope R_scope.

Section Hull.
Context {d : nat}.

(** The simplices of [H] list d points of [S] each, and none is listed twice; they are the facets of
    a complex, and what they cover is the boundary of conv S.  A point of S may be no vertex. *)
Record boundary_of_hull (S : list (point d)) (H : list (simplex d)) : Prop := {
  facets_listed : forall f, In f H -> NoDup f /\ length f = d /\ incl f S;
  facets_form_a_complex : simplicial_complex (faces_of H);
  facets_once : ForallOrdPairs (fun f g => ~ same f g) H;
  facets_cover : forall q, boundary (LinearCell d (fun _ => True) (conv S)) q <->
    exists f, In f H /\ conv f q
}.
End Hull.

(** ** Rules that the facets may break

    [S] and [L] are as in [Definitions.v]. *)
Section Rules.
Context {d : nat}.
Implicit Types (S : list (point d)) (L : list (list (option (point d)))).
Definition claims_hull S L : Prop := exists H, L = map (map Some) H /\ boundary_of_hull S H.
(** Two points are on different sides of a listed facet. *)
Definition facet_not_supporting S L : Prop := exists f p q, listed L f /\ length f = d /\
  affinely_independent f /\ In p S /\ In q S /\ on_opposite_sides f p q.
(** A point of the boundary is in no listed facet. *)
Definition hull_uncovered S L : Prop := exists q,
  boundary (LinearCell d (fun _ => True) (conv S)) q /\ forall f, listed L f -> ~ conv f q.
End Rules.

(** Where to look: a simplex and two points; or d + 1 points, of which all but the last are on a
    hyperplane with no point beyond it, and the point q / w between these. *)
Inductive hull_evidence :=
  | OnBothSides (t p q : positive)
  | InNoFacet (X : list positive) (q : site) (w : Z).
Definition hull_rule_name (e : hull_evidence) : string :=
  match e with
  | OnBothSides _ _ _ => "hull.facet-not-supporting"
  | InNoFacet _ _ _ => "hull.uncovered"
  end%string.
Definition broken_of_hull {d} (e : hull_evidence) :
    list (point d) -> list (list (option (point d))) -> Prop :=
  match e with
  | OnBothSides _ _ _ => facet_not_supporting
  | InNoFacet _ _ _ => hull_uncovered
  end.
(** (The evidence and the basis of the mesh are not read.) *)
Record hull_refutation := HullRefutation { hull_mesh : refutation; hull_because : hull_evidence }.

(** ** Certificates, as they stand in a file

    The certificate of a weighted Delaunay triangulation, in which every simplex is a facet of the
    hull and the summit, point number [k].  The summit is not a point of S. *)
Section Cones.
Variables (d : nat) (c : certificate) (k : positive).

(** The points but the summit. *)
Definition points_below : list (point d) := map (fun e => place_of (unit_of c) (position e))
  (firstn (pred (Pos.to_nat k)) (points c) ++ skipn (Pos.to_nat k) (points c)).
(** The simplices without the summit. *)
Definition facets_below : list (simplex d) :=
  map (fun e => map (spot d c) (filter (fun v => negb (Pos.eqb v k)) (corners e))) (simplices c).
End Cones.
