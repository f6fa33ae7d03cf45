(** * Rules of domains: everything that the theorems about refutations of claims about domains speak of

    The words of Definitions.v and Domains.v go on here.  A refutation is the caller's mesh and what it
    says of the domain: its vertices and some of its segments.  Whatever else the domain has, the claim is
    false of it.  At the end is what shows that a domain has no triangulation.  Nothing is proved here. *)
From Coq Require Import String Reals List ZArith.
From Circumspect Require Import Definitions Domains.
Import ListNotations.
Open Scope R_scope.

(** ** Refutations, as they stand in a file *)

(** What shows a broken rule; simplices, points, vertices and segments are counted from 1, the entries of a
    simplex from 0. *)
Inductive domain_evidence :=
  | VertexMissing (v : positive)                     (* of the domain *)
  | SteinerForbidden (t : positive) (i : nat)
  | SegmentMissing (k : positive) (q : site) (w : Z) (* the point q / w of segment K *)
  | OfMesh.                                          (* the evidence that is about the mesh alone *)
Record domain_refutation := DomainRefutation {
  domain_refuted : domain_claim;
  mesh_refuted : refutation;          (* the caller's points, simplices and, for [OfMesh], evidence *)
  vertices_given : list site;
  segments_given : list (positive * positive);
  domain_because : domain_evidence
}.

Inductive domain_rule :=
  | domain_vertex_missing | domain_steiner_forbidden | domain_segment_missing | mesh_rule (r : rule).
Definition domain_rule_of (c : domain_refutation) : domain_rule :=
  match domain_because c with
  | VertexMissing _ => domain_vertex_missing
  | SteinerForbidden _ _ => domain_steiner_forbidden
  | SegmentMissing _ _ _ => domain_segment_missing
  | OfMesh => mesh_rule (rule_of (because (mesh_refuted c)))
  end.
Definition domain_rule_name (r : domain_rule) : string :=
  match r with
  | domain_vertex_missing => "domain.vertex-missing"
  | domain_steiner_forbidden => "domain.steiner-forbidden"
  | domain_segment_missing => "domain.segment-missing"
  | mesh_rule r => rule_name r
  end%string.

(** ** The rules *)

Section Rules.
Context {d : nat}.
Implicit Types (P : domain d) (L : list (list (option (point d)))).

(** What is claimed: all vertices are known, and of the simplices the claim holds. *)
Definition claims_of_domain (c : domain_claim) P L : Prop :=
  exists T, L = map (map Some) T /\
  match c with
  | PlcTriangulation => plc_triangulation P T
  | SteinerTriangulation => steiner_triangulation P T
  | ConformingDelaunay => conforming_delaunay P T
  | Cdt => cdt P T
  | SteinerCdt => steiner_cdt P T
  end.

(** A vertex of the domain is a vertex of no simplex. *)
Definition vertex_missing P L : Prop := exists v, In v (domain_vertices P) /\
  forall r : list (option (point d)), In r L -> ~ In (Some v) r.
(** A vertex of a simplex is none of the domain. *)
Definition steiner_forbidden P L : Prop := exists (r : list (option (point d))) v,
  In r L /\ In (Some v) r /\ ~ In v (domain_vertices P).
(** A point of a segment is in no face, of a simplex of the mesh, that is in the segment. *)
Definition segment_missing P L : Prop := exists a b q, In (a, b) (domain_segments P) /\ conv [a; b] q /\
  forall s f, listed L s -> incl f s -> conv f q -> ~ within (conv f) (conv [a; b]).

(** The rule is broken; of the mesh's own rules those of simplices alone are used, and one about balls. *)
Definition broken_of_domain P L (r : domain_rule) : Prop :=
  match r with
  | domain_vertex_missing => vertex_missing P L
  | domain_steiner_forbidden => steiner_forbidden P L
  | domain_segment_missing => segment_missing P L
  | mesh_rule r => broken Delaunay norm2 [] L r
  end.
End Rules.

(** ** What the files are about *)

Section Refuted.
Variables (D : plane_or_space) (c : domain_refutation).
Notation r := (refuted_unit (mesh_refuted c)).
Definition vertex_given (k : positive) : option (point (dimension_of D)) :=
  option_map (place_of r) (numbered (vertices_given c) k).
(** The domain has these vertices, and among its segments these. *)
Definition described (P : domain (dimension_of D)) : Prop :=
  (forall v, In v (domain_vertices P) <-> In v (map (place_of r) (vertices_given c))) /\
  forall j k a b, In (j, k) (segments_given c) -> vertex_given j = Some a -> vertex_given k = Some b ->
    In (a, b) (domain_segments P).
End Refuted.

(** ** That a domain in space has no triangulation, or no CDT, as it stands in a file

    Which of the two is what the certificate claims to the contrary.  The domain is that of a certificate whose points are its vertices, and which has no simplices.  Candidates
    are all sets of four vertices, in lexicographic order. *)

(** A point of the domain: vertex K; the point q / w of segment K, or of triangle U of polygon K. *)
Inductive domain_point :=
  | AtCorner (k : positive)
  | AlongSegment (k : positive) (q : site) (w : Z)
  | InPiece (k u : positive) (q : site) (w : Z).
(** The four points are in a plane; a cell with this point is no union of faces of the candidate; it is not constrained
    Delaunay, for from its point q / w one sees vertex V, in its ball (planes <n, p> = o part the way from all cells); or nothing of that. *)
Inductive fate :=
  | Flat | Pierced (x : domain_point)
  | Encroached (v : positive) (q : site) (w : Z) (planes : list (list Z * Z))
  | MayBeChosen.
(** Why a clause holds of every triangulation: one of its simplices contains the point; two candidates overlap at
    the point q / w; or candidate S has a neighbour across its facet I, with the point q / w, in no wall: one of these. *)
Inductive reason :=
  | OneCovers (x : domain_point)
  | NotBoth (s u : positive) (q : site) (w : Z)
  | OneBeside (s : positive) (i : nat) (q : site) (w : Z) (l : list positive).
(** Candidate K is chosen, or is not. *)
Definition literal := (bool * positive)%type.
Definition clause := list literal.
(** A clause that follows from others, by their numbers. *)
Record proof_step := ProofStep { derived : clause; hints : list positive }.
Record impossibility := Impossibility {
  about : domain_certificate; fates : list fate; reasons : list reason; steps : list proof_step }.
