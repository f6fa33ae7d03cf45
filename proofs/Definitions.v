(** * Definitions: the words of the book, for points of R^d with any d

    Everything that [MainTheorems.v] says is said in these words.  Nothing here is proved, and
    nothing here mentions a checker.  Book: Cheng, Dey and Shewchuk, "Delaunay Mesh Generation";
    the numbers are those of its definitions and sections. *)
From Coq Require Import Reals List.
From Coq Require Vector.
Import ListNotations.
Open Scope R_scope.

(** ** Points *)

(** A point of R^d: its d coordinates. *)
Definition point (d : nat) := Vector.t R d.

Section Book.
Context {d : nat}.

Definition origin : point d := Vector.const 0 d.
Definition plus (p q : point d) : point d := Vector.map2 Rplus p q.
Definition scale (a : R) (p : point d) : point d := Vector.map (Rmult a) p.
Definition minus (p q : point d) : point d := plus p (scale (-1) q).
Definition inner (p q : point d) : R := Vector.fold_right2 (fun x y s => x * y + s) 0 d p q.

(** The squares of the norm and of the distance. *)
Definition norm2 (p : point d) : R := inner p p.
Definition dist2 (p q : point d) : R := norm2 (minus p q).

(** ** Convexity *)

(** The sum of the coefficients of [l], and the point that [l] combines. *)
Definition total (l : list (R * point d)) : R := fold_right (fun ap s => fst ap + s) 0 l.
Definition combination (l : list (R * point d)) : point d :=
  fold_right (fun ap s => plus (scale (fst ap) (snd ap)) s) origin l.

(** [conv X q]: the point [q] is in the convex hull of the points of [X].  (Section 1.3) *)
Definition conv (X : list (point d)) (q : point d) : Prop :=
  exists l, (forall a p, In (a, p) l -> 0 <= a /\ In p X) /\ total l = 1 /\ combination l = q.

(** No point of [X] is an affine combination of the others.  (Section 1.3) *)
Definition affinely_independent (X : list (point d)) : Prop :=
  forall a : list R, length a = length X ->
    total (combine a X) = 0 -> combination (combine a X) = origin -> forall c, In c a -> c = 0.

(** ** Simplices and complexes *)

(** A simplex is known by its vertices, listed in any order; the simplex itself is their convex
    hull.  Two lists with the same members are the same simplex. *)
Definition simplex := list (point d).
Definition same (s t : simplex) : Prop := incl s t /\ incl t s.

(** Definition 1.5: a simplicial complex is a set of simplices that contains every face of each
    of its simplices, and in which two simplices meet in a shared face or not at all.  ([f] may be
    empty, and then so is its convex hull.  The book's set is finite; all that follows is about the
    faces of a list, which are finitely many.) *)
Definition simplicial_complex (K : simplex -> Prop) : Prop :=
  (forall s, K s -> affinely_independent s) /\
  (forall s f, K s -> incl f s -> NoDup f -> f <> [] -> K f) /\
  (forall s t, K s -> K t ->
     exists f, incl f s /\ incl f t /\ forall q, conv s q -> conv t q -> conv f q).

(** The simplices of a list and all their faces. *)
Definition faces_of (T : list simplex) (s : simplex) : Prop :=
  NoDup s /\ s <> [] /\ exists t, In t T /\ incl s t.

(** ** Triangulations of a point set *)

(** [S] spans R^d: d+1 of its points are affinely independent.  Where the book speaks of a
    k-dimensional point set in R^d, k is d here: for points of a hyperplane it has triangulations
    of lower dimension, which are not spoken of. *)
Definition spans (S : list (point d)) : Prop :=
  exists X, incl X S /\ length X = Datatypes.S d /\ affinely_independent X.

(** The simplices of [T], each listed by its d+1 different vertices and none listed twice, are the
    d-simplices of a complex and fill conv S; all their vertices are in [S]. *)
Definition fills (S : list (point d)) (T : list simplex) : Prop :=
  (forall t, In t T -> NoDup t /\ length t = Datatypes.S d) /\
  simplicial_complex (faces_of T) /\
  ForallOrdPairs (fun s t => ~ same s t) T /\
  (forall t, In t T -> incl t S) /\
  (forall q, conv S q <-> exists t, In t T /\ conv t q).

(** Definition 2.1: a triangulation of S is a simplicial complex whose vertices are exactly the
    points of S and whose union is conv S.  ([T] lists the d-simplices.  S is meant to span R^d:
    if it does not, and is not empty, then it has no triangulation in this sense.) *)
Definition triangulation (S : list (point d)) (T : list simplex) : Prop :=
  fills S T /\ (forall p, In p S -> exists t, In t T /\ In p t).

(** ** Delaunay *)

(** The ball with centre [c] and squared radius [r2] is a circumball of [s]: its boundary passes
    through the vertices of [s].  (Definition 1.18) *)
Definition circumball (s : simplex) (c : point d) (r2 : R) : Prop :=
  forall v, In v s -> dist2 c v = r2.

(** Section 4.2: a simplex is Delaunay if some open circumball of it contains no point of S.  (Its
    vertices are meant to be points of S, which these definitions do not say; the theorems do.) *)
Definition delaunay (S : list (point d)) (s : simplex) : Prop :=
  exists c r2, circumball s c r2 /\ forall p, In p S -> ~ dist2 c p < r2.

(** Section 4.2: strongly Delaunay, if some closed one has none but the vertices of [s]. *)
Definition strongly_delaunay (S : list (point d)) (s : simplex) : Prop :=
  exists c r2, circumball s c r2 /\ forall p, In p S -> dist2 c p <= r2 -> In p s.

(** Definition 4.1. *)
Definition delaunay_triangulation (S : list (point d)) (T : list simplex) : Prop :=
  triangulation S T /\ forall t, In t T -> delaunay S t.

(** Definition 4.2, for a point set that spans R^d (the book's k is d): no d+2 points of S lie on
    the boundary of a single ball. *)
Definition generic (S : list (point d)) : Prop :=
  forall X, NoDup X -> incl X S -> length X = Datatypes.S (Datatypes.S d) ->
    ~ exists c r2, circumball X c r2.

(** Section 4.2: a facet is a (d-1)-simplex of the triangulation. *)
Definition facet (T : list simplex) (f : simplex) : Prop :=
  NoDup f /\ length f = d /\ exists t, In t T /\ incl f t.

(** Section 4.2: a facet is locally Delaunay if it is a face of fewer than two d-simplices, or it
    has an open circumball that contains no vertex of the two.  (In a triangulation no three
    d-simplices share a facet; of others this definition asks it of every two.) *)
Definition locally_delaunay (T : list simplex) (f : simplex) : Prop :=
  forall s t, In s T -> In t T -> incl f s -> incl f t -> ~ same s t ->
    exists c r2, circumball f c r2 /\ forall v, In v s \/ In v t -> ~ dist2 c v < r2.

(** ** Heights: weighted points and perturbed points *)

(** Section 2.8: a hyperplane that is not vertical is the graph of p |-> <a, p> + b. *)
Definition plane (a : point d) (b : R) (p : point d) : R := inner a p + b.

(** Section 2.8: lift each point p to the height [h p].  A hyperplane is a witness plane of a
    simplex if it contains the lifted vertices of the simplex and no lifted point of S is strictly
    below it.  A simplex that has one is weighted Delaunay for h(p) = |p|^2 - w(p). *)
Definition witness_plane (h : point d -> R) (S : list (point d)) (s : simplex) : Prop :=
  exists a b, (forall v, In v s -> plane a b v = h v) /\ (forall p, In p S -> plane a b p <= h p).

Definition weighted_delaunay (w : point d -> R) (S : list (point d)) (s : simplex) : Prop :=
  witness_plane (fun p => norm2 p - w p) S s.

(** Section 2.8: a weighted Delaunay triangulation fills conv S; a point of S that is not a vertex
    is submerged: its lifted companion is on or above every witness plane. *)
Definition weighted_delaunay_triangulation (w : point d -> R) (S : list (point d))
    (T : list simplex) : Prop :=
  fills S T /\ forall t, In t T -> weighted_delaunay w S t.

(** ** Optimality *)

(** The hyperplane (a, b) contains the lifted vertices of s: over s it is the interpolant of h. *)
Definition interpolates (h : point d -> R) (s : simplex) (a : point d) (b : R) : Prop :=
  forall v, In v s -> plane a b v = h v.

(** Section 4.3: [e] is the error at p of the piecewise linear function that interpolates h at the
    vertices of T.  (With h(p) = |p|^2 it is the book's e(p) = T^+(p) - |p|^2.) *)
Definition interpolation_error (h : point d -> R) (T : list simplex) (p : point d) (e : R) : Prop :=
  exists t a b, In t T /\ conv t p /\ interpolates h t a b /\ e = plane a b p - h p.

(** The closed ball with centre [c] and squared radius [r2] contains s. *)
Definition contains (c : point d) (r2 : R) (s : simplex) : Prop :=
  forall v, In v s -> dist2 c v <= r2.

(** Definition 1.20: the smallest closed ball that contains s. *)
Definition min_containment_ball (s : simplex) (c : point d) (r2 : R) : Prop :=
  contains c r2 s /\ forall c' r2', contains c' r2' s -> r2 <= r2' /\ (r2 = r2' -> c' = c).

End Book.
Arguments simplex d : clear implicits.
