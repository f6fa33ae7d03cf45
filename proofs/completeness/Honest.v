(** * Honest certificates

    A certificate says of each simplex, facet and ridge where its neighbour is.  It is honest if all
    that is so: pointers point at what has the same vertices, points are sorted, the sample point
    is inside its simplex.  No condition here says that simplices are not flat, that they do not
    overlap, that their union is convex, or that they are Delaunay; those are the claim's business.
    [Completeness.v] proves that an honest certificate is accepted if its claim is true. *)
From Coq Require Import Rbase Rfunctions List ZArith Sorting.Sorted.
From Circumspect Require Import Checker Numbering Definitions Orientation.
Import ListNotations.
Open Scope R_scope.

Section Simplices.
Context {d : nat}.
Implicit Types (s f : simplex d) (q : point d).

(** The point is in the simplex and in no proper face of it. *)
Definition strictly_inside s q : Prop := conv s q /\ forall f, incl f s -> conv f q -> incl s f.

(** A hyperplane through the vertices of [s] but number [i] has that vertex strictly on one side,
    and the point strictly on the other. *)
Definition beyond_facet s (i : nat) q : Prop := exists a b v,
  nth_error s i = Some v /\ 0 < plane a b v /\
  (forall k w, k <> i -> nth_error s k = Some w -> plane a b w = 0) /\ plane a b q < 0.
End Simplices.

(** The same numbers are in both lists. *)
Definition shared (K L : list positive) : Prop := forall k, In k K <-> In k L.

Section Certificate.
Context {d : nat}.
(** [orient X] is the orientation of the d+1 points X. *)
Variables (orient : list (point d) -> R) (c : certificate).
Notation point_at k e := (numbered (points c) k = Some e).
Notation simplex_at t s := (numbered (simplices c) t = Some s).
Notation hull_at h f := (numbered (hull c) h = Some f).
Notation spot := (spot d c).

Definition sample_point : point d := place_of (unit_of c / IZR (sample_denominator c)) (sample c).

(** Points and simplices are listed as they should be, whatever else the certificate says. *)
Record well_listed : Prop := {
  (* P and Q are positive *)
  listed_scale : (0 < numerator c)%Z /\ (0 < denominator c)%Z;
  (* points have d coordinates and are in lexicographic order, none twice *)
  listed_shape : Forall (fun p => length (coordinates p) = d) (map position (points c));
  listed_order : Sorted (fun p q => increasing p q = true) (map position (points c));
  (* vertices are points of the list, and listed with an orientation that is not negative *)
  listed_corners : forall t s k, simplex_at t s -> In k (corners s) -> exists e, point_at k e;
  listed_orientation : forall t s, simplex_at t s -> 0 <= orient (map spot (corners s))
}.

(** And what the certificate says of them is so. *)
Record honest : Prop := {
  honest_listed : well_listed;
  (* a point is the vertex of a simplex that it names; if there are weights it may be no vertex, and
     then it is in the closed simplex that it names *)
  honest_home : forall k e, point_at k e -> exists s, simplex_at (home e) s /\
    match home_vertex e with
    | Some i => nth_error (corners s) i = Some k
    | None => claimed c = WeightedDelaunay /\ conv (map spot (corners s)) (spot k)
    end;
  (* a facet names a facet of another simplex, with the same vertices, or, if there is none, a
     hull facet, which names it in return *)
  honest_walls : forall t s, simplex_at t s -> length (walls s) = S d;
  honest_neighbour : forall t s i u j, simplex_at t s ->
    nth_error (walls s) i = Some (Neighbour u j) ->
    t <> u /\ exists s', simplex_at u s' /\ shared (remove i (corners s)) (remove j (corners s'));
  honest_on_hull : forall t s i h, simplex_at t s -> nth_error (walls s) i = Some (OnHull h) ->
    (exists f, hull_at h f /\ carrier f = t /\ apex f = i) /\
    forall u s' j, simplex_at u s' -> t <> u ->
      ~ shared (remove i (corners s)) (remove j (corners s'));
  honest_hull : forall h f, hull_at h f -> exists s, simplex_at (carrier f) s /\
    nth_error (walls s) (apex f) = Some (OnHull h);
  (* a ridge names a ridge of another hull facet, with the same vertices *)
  honest_ridges : forall h f, hull_at h f -> length (ridges f) = d;
  honest_ridge : forall h f s a g b, hull_at h f -> simplex_at (carrier f) s ->
    nth_error (ridges f) a = Some (g, b) ->
    h <> g /\ exists f' s', hull_at g f' /\ simplex_at (carrier f') s' /\
      shared (remove a (remove (apex f) (corners s))) (remove b (remove (apex f') (corners s')));
  (* the sample point is strictly inside its simplex; if it is beyond facets of another simplex,
     then that simplex names one of them *)
  honest_sample_shape : length (coordinates (sample c)) = d /\ (0 < sample_denominator c)%Z;
  honest_sample : exists s, simplex_at (sample_simplex c) s /\
    strictly_inside (map spot (corners s)) sample_point;
  honest_away : forall t s, simplex_at t s -> t <> sample_simplex c ->
    (exists i, beyond_facet (map spot (corners s)) i sample_point) ->
    exists i, away s = Some i /\ beyond_facet (map spot (corners s)) i sample_point
}.
End Certificate.

(** ** For the plane and for space *)

Definition well_listed_certificate (D : plane_or_space) (c : certificate) : Prop :=
  match D with Plane => well_listed orient2 c | Space => well_listed orient3 c end.
Definition honest_certificate (D : plane_or_space) (c : certificate) : Prop :=
  match D with Plane => honest orient2 c | Space => honest orient3 c end.

(** What a certificate claims. *)
Definition claim_holds (d : nat) (c : certificate) : Prop :=
  let P := points_of_certificate d c in let T := simplices_of_certificate d c in
  match claimed c with
  | Triangulation => triangulation P T
  | Delaunay => delaunay_triangulation P T
  | WeightedDelaunay => exists w, weights_given d c w /\ weighted_delaunay_triangulation w P T
  end.

(** The same claim about the same points and simplices in the same order, whatever else the two
    certificates say. *)
Definition same_input (c c' : certificate) : Prop :=
  claimed c' = claimed c /\ numerator c' = numerator c /\ denominator c' = denominator c /\
  map position (points c') = map position (points c) /\
  map corners (simplices c') = map corners (simplices c).
