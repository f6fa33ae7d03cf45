(** * Surfaces: what the claim [surface-delaunay] says, and what its certificates and refutations
    hold

    docs/theory/questions.md has the same definition in words: triangles are intrinsically Delaunay
    if the angles opposite each edge of two of them have a sum of at most pi.  [CERTIFICATE.md]
    describes the files. *)
From Coq Require Import Rbase Rfunctions List ZArith.
From Circumspect Require Import Definitions.
Import ListNotations.
Open Scope R_scope.

Section Surface.
Context {d : nat}.
Implicit Types (S : list (point d)) (T : list (simplex d)).

(** Of the lists [L], numbered from 0, those with the numbers [i] and [j] have both members [p] and
    [q], and no others have: the edge pq is in two triangles. *)
Definition edge_of_two {A} (L : list (list A)) (i j : nat) (p q : A) : Prop := i <> j /\
  forall k, (exists r, nth_error L k = Some r /\ In p r /\ In q r) <-> k = i \/ k = j.

(** The angle at [o] of the triangle o, p, q has the cosine <p - o, q - o> / (|p - o| |q - o|).
    This is its square, with its sign: it grows with the cosine, and falls with the angle. *)
Definition signed_cos2 (o p q : point d) : R :=
  let x := inner (minus p o) (minus q o) in x * Rabs x / (dist2 p o * dist2 q o).

(** [o] is the vertex of the triangle [t] opposite its edge pq. *)
Definition opposite (t : simplex d) (p q o : point d) : Prop := In o t /\ o <> p /\ o <> q.

(** Each of [T] lists three points of [S] that are on no line, and none is listed twice; at an edge
    of two triangles, the angles A and B opposite have a sum of at most pi: A <= pi - B, so
    cos A >= - cos B, and so their squares with their signs.  Edges of one triangle and of more than
    two are asked nothing, nor do the triangles have to be embedded. *)
Record intrinsically_delaunay S T : Prop := {
  some_triangle : T <> [];
  triangles_proper : forall t, In t T -> incl t S /\ length t = 3%nat /\ affinely_independent t;
  triangles_once : ForallOrdPairs (fun s t => ~ same s t) T;
  angles_small : forall i j s t p q a b, p <> q -> edge_of_two T i j p q ->
    nth_error T i = Some s -> nth_error T j = Some t -> opposite s p q a -> opposite t p q b ->
    0 <= signed_cos2 a p q + signed_cos2 b p q
}.

End Surface.

Section Rule.
Context {d : nat}.
(** What is claimed of the simplices as their author wrote them down ([Definitions.v]), and the rule
    that an edge may break: it is in two triangles, and the sum is more than pi. *)
Definition claims_surface (S : list (point d)) (L : list (list (option (point d)))) : Prop :=
  exists T, L = map (map Some) T /\ intrinsically_delaunay S T.
Definition edge_not_delaunay (L : list (list (option (point d)))) : Prop :=
  exists i j s t p q a b, p <> q /\ edge_of_two L i j (Some p) (Some q) /\
  nth_error L i = Some (map Some s) /\ nth_error L j = Some (map Some t) /\
  length s = 3%nat /\ length t = 3%nat /\ affinely_independent s /\ affinely_independent t /\
  opposite s p q a /\ opposite t p q b /\ signed_cos2 a p q + signed_cos2 b p q < 0.
End Rule.

(** ** Certificates, as they stand in a file *)

(** The numbers of the vertices; and, for the edge opposite each, where it stands among the
    edges. *)
Record triangle_entry := TriangleEntry {
  triangle_vertices : list positive; triangle_edges : list positive }.
(** The edges are those of each triangle, by the triangle and the number of the vertex opposite. *)
Record surface_certificate := SurfaceCertificate {
  surface_numerator : Z; surface_denominator : Z;              (* scale P Q *)
  surface_points : list point_entry;                           (* where they are *)
  surface_triangles : list triangle_entry;
  surface_edges : list (positive * nat)
}.

(** Its points and triangles are those of a certificate without the rest. *)
Definition bare_surface (c : surface_certificate) : certificate :=
  Certificate Triangulation (surface_numerator c) (surface_denominator c) (surface_points c)
    (map (fun e => SimplexEntry (triangle_vertices e) [] None) (surface_triangles c)) []
    1 (Site [] 0) 1.

(** A refutation: the mesh, and two triangles, by their numbers and those of their vertices opposite
    the edge.  (Its evidence and its basis are not read.) *)
Record surface_refutation := SurfaceRefutation {
  surface_mesh : refutation; one_side : positive * nat; other_side : positive * nat }.
