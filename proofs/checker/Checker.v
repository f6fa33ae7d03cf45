(** * The checker of certificates

    [check] is the program that is extracted; [Soundness.v] proves what its acceptance means.  A
    certificate is what CERTIFICATE.md describes.  For every condition of that document there is a
    boolean function here; the comment at each names the condition and the lemma whose proof fails
    without it.  Nothing is searched: each test looks at one simplex and its neighbours, or at one
    hull facet and its neighbours, so the time is linear. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Predicates.
From Circumspect Require Table.
Import ListNotations.
Open Scope Z_scope.

(** ** Verdicts *)

Inductive condition :=
  | scale | points_increasing | point_used | vertex_known | simplex_positive | facet_matched
  | back_pointer | hull_pointer | ridge_matched | ridge_back_pointer | hull_locally_convex
  | sample_inside | sample_outside | sample_inside_hull | facet_locally_delaunay
  (* of domains only: domain/DomainChecker.v *)
  | claim_of_mesh | role_shown | segment_linked | hole_inside | mark_consistent | wall_shown
  | way_out_shown | polygon_flat | polygon_tiled | vertices_of_domain
  (* domain/ComplexChecker.v *)
  | face_held | segment_in_polygon | rim_listed | one_sided_shown
  (* alone/MeshAlone.v *)
  | simplex_proper | simplex_listed | simplices_parted
  (* hulls/HullChecker.v and flats/FlatChecker.v *)
  | summit_inside | cone_shown | point_in_plane | weight_unseen
  (* surfaces/SurfaceChecker.v *)
  | edge_listed | edges_increasing | edge_delaunay
  (* periodic/PeriodicChecker.v *)
  | lattice_proper
  (* existence/ImpossibleChecker.v *)
  | vertices_listed | mesh_of_the_domain | fate_shown | reason_shown | clauses_refuted.

Inductive place :=
  | Nowhere | AtPoint (k : positive) | AtSimplex (t : positive) | AtFacet (t : positive) (i : nat)
  | AtHull (h : positive) | AtRidge (h : positive) (a : nat)
  | AtSegment (k : positive) | AtHole (k : positive) | AtPolygon (k : positive)
  | AtEdge (k : positive)
  (* of what has no triangulation *)
  | AtCandidate (k : positive) | AtReason (k : positive).

Inductive result := Accepted | Rejected (c : condition) (p : place).

Notation "'require' c 'by' b 'at' p ; r" := (if b then r else Rejected c p)
  (at level 200, b at level 100, p at level 100, r at level 200).
Notation "r ;; s" := (match r with Accepted => s | rejected => rejected end)
  (at level 100, s at level 200, right associativity).

(** The first rejection of the items of a list, numbered from [k]. *)
Fixpoint each {A} (f : positive -> A -> result) (k : positive) (l : list A) : result :=
  match l with
  | [] => Accepted
  | a :: l' => match f k a with Accepted => each f (Pos.succ k) l' | rejected => rejected end
  end.
Fixpoint each_index {A} (f : nat -> A -> result) (k : nat) (l : list A) : result :=
  match l with
  | [] => Accepted
  | a :: l' => match f k a with Accepted => each_index f (S k) l' | rejected => rejected end
  end.

(** ** Lists, numbered things, permutations *)

Fixpoint replace {A} (i : nat) (a : A) (l : list A) : list A :=
  match l, i with
  | [], _ => []
  | _ :: l', O => a :: l'
  | b :: l', S i' => b :: replace i' a l'
  end.
Fixpoint remove {A} (i : nat) (l : list A) : list A :=
  match l, i with
  | [], _ => []
  | _ :: l', O => l'
  | b :: l', S i' => b :: remove i' l'
  end.

Fixpoint find_all {A} (m : Table.t A) (l : list positive) : option (list A) :=
  match l with
  | [] => Some []
  | k :: l' => match Table.find k m with
               | Some a => match find_all m l' with Some r => Some (a :: r) | None => None end
               | None => None
               end
  end.

(** Take [a] out of [l]: the rest, and whether an odd number of members stood before [a]. *)
Fixpoint pull (a : positive) (l : list positive) : option (bool * list positive) :=
  match l with
  | [] => None
  | b :: l' => if Pos.eqb a b then Some (false, l')
               else match pull a l' with Some (s, r) => Some (negb s, b :: r) | None => None end
  end.
(** Whether [k] is an odd permutation of [l]; [None] if it is none. *)
Fixpoint parity (k l : list positive) : option bool :=
  match k with
  | [] => match l with [] => Some false | _ => None end
  | a :: k' => match pull a l with
               | None => None
               | Some (s, l') => match parity k' l' with
                                 | Some s' => Some (xorb s s')
                                 | None => None
                                 end
               end
  end.

Fixpoint lexicographic (p q : list Z) : bool :=
  match p, q with
  | x :: p', y :: q' => (x <? y) || ((x =? y) && lexicographic p' q')
  | _, _ => false
  end.

(** The certificate, with its parts in tables.  Where the claim has no weights they are 0. *)
Record mesh := Mesh {
  delaunay_claimed : bool;
  weights_claimed : bool;
  points_of : Table.t site;
  simplices_of : Table.t simplex_entry;
  hull_of : Table.t hull_entry;
  start : positive;
  sample_of : site;
  sample_w : Z
}.
Section Conditions.
Variable pr : predicates.
Variable m : mesh.

(** ** Points *)

Definition shaped (p : site) : bool := Nat.eqb (length (coordinates p)) (dimension pr).

(** [points-increasing]: without it a point could be listed twice, and with two weights: S would be
    no set ([points_distinct]), the weight no function of the point ([weights_exist]). *)
Definition increasing (p q : site) : bool := lexicographic (coordinates p) (coordinates q).
Fixpoint points_increase (k : positive) (p : site) (l : list point_entry) : result :=
  match l with
  | [] => Accepted
  | e :: l' =>
      let q := position e in
      require points_increasing by shaped q && increasing p q at AtPoint k;
      points_increase (Pos.succ k) q l'
  end.

(** The point is in the closed simplex [X]. *)
Fixpoint in_closed (i : nat) (X : list site) (p : site) : bool :=
  match i with
  | O => true
  | S i' => (0 <=? side pr i' X p 1) && in_closed i' X p
  end.

(** [point-used]: without it a point of S need not be a vertex ([point_vertex]); it could be outside
    the hull facets ([certificate_supporting]), or inside a circumball, since the Delaunay Lemma
    speaks of vertices, and of points with a witness ([point_accounted]). *)
Definition used (k : positive) (e : point_entry) : bool :=
  match Table.find (home e) (simplices_of m) with
  | None => false
  | Some t =>
      match home_vertex e with
      | Some i => match nth_error (corners t) i with Some v => Pos.eqb v k | None => false end
      | None =>
          weights_claimed m &&
          match find_all (points_of m) (corners t) with
          | None => false
          | Some X => in_closed (S (dimension pr)) X (position e)
                      && (depth pr X (slope pr X) (position e) <=? 0)
          end
      end
  end.
Definition check_point (k : positive) (e : point_entry) : result :=
  require point_used by used k e at AtPoint k; Accepted.

(** ** Simplices *)

(** [vertex-known] is the success of [find_all]: without it a vertex need not be a point of S
    ([vertices_in]). *)

(** [simplex-positive]: without it a simplex could be flat and have no barycentric coordinates
    ([frames_exist]), or the permutations below could tell the wrong side ([facets_opposite]). *)
Definition positive_simplex (X : list site) : bool := 0 <? orientation pr X.

(** [facet-matched]: put the other simplex's apex in place of vertex i: the result must be the
    other simplex with the opposite orientation.  Without it a walk that leaves a simplex through
    the facet need not enter the other ([facets_opposite]). *)
Definition matched_facet (K L : list positive) (i j : nat) : bool :=
  match nth_error L j with
  | None => false
  | Some v => match parity (replace i v K) L with Some true => true | _ => false end
  end.

(** [back-pointer]: without it two simplices could be matched with one facet of a third, so that two
    walks towards the sample point merge ([adj_sym], for [matched_once] and [hull_unmatched]); and
    the neighbour's apex could not be looked at from one side only ([certificate_local]). *)
Definition points_back (t : positive) (i : nat) (u : simplex_entry) (j : nat) : bool :=
  match nth_error (walls u) j with
  | Some (Neighbour t' i') => Pos.eqb t' t && Nat.eqb i' i
  | _ => false
  end.

(** [facet-locally-delaunay]: without it the witness planes that a walk passes need not get higher
    at its end: the Delaunay Lemma does not apply ([certificate_local]). *)
Definition apex_outside (X : list site) (n : list Z) (v : site) : bool :=
  depth pr X n v <=? 0.

(** [hull-pointer]: without it a facet that is not matched could escape the conditions on hull
    facets ([hull_entry_of]). *)
Definition names_hull (t : positive) (i : nat) (h : positive) : bool :=
  match Table.find h (hull_of m) with
  | Some e => Pos.eqb (carrier e) t && Nat.eqb (apex e) i
  | None => false
  end.

(** The apex of a neighbour is looked at from one of the two sides. *)
Definition check_wall (t : positive) (K : list positive) (X : list site) (n : list Z)
    (i : nat) (f : wall) : result :=
  match f with
  | OnHull h => require hull_pointer by names_hull t i h at AtFacet t i; Accepted
  | Neighbour u j =>
      match Table.find u (simplices_of m) with
      | None => Rejected facet_matched (AtFacet t i)
      | Some e =>
          require facet_matched by matched_facet K (corners e) i j at AtFacet t i;
          require back_pointer by points_back t i e j at AtFacet t i;
          if delaunay_claimed m && Pos.ltb t u then
            match nth_error (corners e) j with
            | None => Rejected facet_matched (AtFacet t i)
            | Some v =>
                match Table.find v (points_of m) with
                | None => Rejected vertex_known (AtSimplex u)
                | Some p =>
                    require facet_locally_delaunay by apex_outside X n p at AtFacet t i;
                    Accepted
                end
            end
          else Accepted
      end
  end.

(** [sample-outside]: without it the mesh could cover space twice ([certificate_covered_once]). *)
Definition outside_sample (t : positive) (X : list site) (s : option nat) : bool :=
  Pos.eqb t (start m) ||
  match s with Some i => side pr i X (sample_of m) (sample_w m) <? 0 | None => false end.

Definition check_simplex (t : positive) (e : simplex_entry) : result :=
  match find_all (points_of m) (corners e) with
  | None => Rejected vertex_known (AtSimplex t)
  | Some X =>
      require simplex_positive by positive_simplex X at AtSimplex t;
      require facet_matched by Nat.eqb (length (walls e)) (S (dimension pr)) at AtSimplex t;
      require sample_outside by outside_sample t X (away e) at AtSimplex t;
      let n := if delaunay_claimed m then slope pr X else [] in
      each_index (check_wall t (corners e) X n) 0 (walls e)
  end.

(** ** The sample point *)

Fixpoint in_open (i : nat) (X : list site) : bool :=
  match i with
  | O => true
  | S i' => (0 <? side pr i' X (sample_of m) (sample_w m)) && in_open i' X
  end.

(** [sample-inside]: without it walks towards the sample point need not have a common end; the
    mesh could be empty ([certificate_covered_once]). *)
Definition inside_sample : bool :=
  shaped (sample_of m) && (0 <? sample_w m) &&
  match Table.find (start m) (simplices_of m) with
  | None => false
  | Some e => match find_all (points_of m) (corners e) with
              | None => false
              | Some X => in_open (S (dimension pr)) X
              end
  end.

(** ** Hull facets *)

(** [hull-pointer], in return: without it a facet could have two entries with ridges that are
    matched differently ([hull_entry_once]), or be matched as well ([hull_entry_facet]). *)
Definition named_by_facet (h : positive) (i : nat) (e : simplex_entry) : bool :=
  match nth_error (walls e) i with Some (OnHull h') => Pos.eqb h' h | _ => false end.

(** [sample-inside-hull]: without it a walk to the sample point could leave the mesh, and there need
    be no cone from the sample point over the hull facet ([hull_sample]). *)
Definition inside_hull_facet (i : nat) (X : list site) : bool :=
  0 <? side pr i X (sample_of m) (sample_w m).

(** [ridge-matched]: [K] and [L] are the facets opposite vertices i and j.  In the simplices that
    arise when the sample point takes the place of these vertices, put the apex of the second in
    place of vertex a of the first: the result must be the second with the opposite orientation.
    Without it a walk over the cones need not enter the neighbouring cone ([ridges_opposite]). *)
Definition matched_ridge (K L : list positive) (i j a b : nat) : bool :=
  match nth_error L b with
  | None => false
  | Some v => match parity (replace a v K) L with
              | Some s => xorb s (xorb (Nat.odd i) (Nat.odd j))
              | None => false
              end
  end.

(** [ridge-back-pointer]: without it two cones could be matched with one facet of a third, so that
    walks merge ([ridge_once], in [certificate_convex_at_ridges]). *)
Definition ridge_points_back (h : positive) (a : nat) (g : hull_entry) (b : nat) : bool :=
  match nth_error (ridges g) b with
  | Some (h', a') => Pos.eqb h' h && Nat.eqb a' a
  | None => false
  end.

(** [hull-locally-convex]: without it the hull facets need not support conv S ([locally_convex] of
    Cone.v, in [certificate_convex_at_ridges]). *)
Definition locally_convex (i : nat) (X : list site) (v : site) : bool := 0 <=? side pr i X v 1.

Definition check_ridge (h : positive) (i : nat) (K : list positive) (X : list site) (a : nat)
    (r : positive * nat) : result :=
  let '(g, b) := r in
  match Table.find g (hull_of m) with
  | None => Rejected ridge_matched (AtRidge h a)
  | Some f =>
      match Table.find (carrier f) (simplices_of m) with
      | None => Rejected hull_pointer (AtHull g)
      | Some u =>
          let L := remove (apex f) (corners u) in
          require ridge_matched by matched_ridge K L i (apex f) a b at AtRidge h a;
          require ridge_back_pointer by ridge_points_back h a f b at AtRidge h a;
          match nth_error L b with
          | None => Rejected ridge_matched (AtRidge h a)
          | Some v =>
              match Table.find v (points_of m) with
              | None => Rejected vertex_known (AtSimplex (carrier f))
              | Some p =>
                  require hull_locally_convex by locally_convex i X p at AtRidge h a;
                  Accepted
              end
          end
      end
  end.

Definition check_hull (h : positive) (f : hull_entry) : result :=
  match Table.find (carrier f) (simplices_of m) with
  | None => Rejected hull_pointer (AtHull h)
  | Some e =>
      require hull_pointer by named_by_facet h (apex f) e at AtHull h;
      match find_all (points_of m) (corners e) with
      | None => Rejected vertex_known (AtSimplex (carrier f))
      | Some X =>
          require sample_inside_hull by inside_hull_facet (apex f) X at AtHull h;
          require ridge_matched by Nat.eqb (length (ridges f)) (dimension pr) at AtHull h;
          each_index (check_ridge h (apex f) (remove (apex f) (corners e)) X) 0 (ridges f)
      end
  end.
End Conditions.

(** ** The whole *)

Definition weights_of (c : claim) : bool :=
  match c with WeightedDelaunay => true | _ => false end.
Definition delaunay_of (c : claim) : bool :=
  match c with Triangulation => false | _ => true end.

(** The point, with its weight if that counts. *)
Definition site_of (c : claim) (e : point_entry) : site :=
  if weights_of c then position e else Site (coordinates (position e)) 0.
Definition mesh_of (c : certificate) : mesh :=
  Mesh (delaunay_of (claimed c)) (weights_of (claimed c))
    (Table.of_list (site_of (claimed c)) (points c))
    (Table.of_list id (simplices c))
    (Table.of_list id (hull c))
    (sample_simplex c) (sample c) (sample_denominator c).

(** [scale]: without it the caller's points could all be one, or mirror images ([unit_positive]). *)
Definition scaled (c : certificate) : bool := (0 <? numerator c) && (0 <? denominator c).

Definition check_points (pr : predicates) (l : list point_entry) : result :=
  match l with
  | [] => Accepted
  | e :: l' =>
      require points_increasing by shaped pr (position e) at AtPoint 1;
      points_increase pr 1 (position e) l'
  end.

Definition check_in (pr : predicates) (c : certificate) : result :=
  require scale by scaled c at Nowhere;
  let m := mesh_of c in
  check_points pr (points c) ;;
  each (check_point pr m) 1 (points c) ;;
  (require sample_inside by inside_sample pr m at Nowhere;
   each (check_simplex pr m) 1 (simplices c)) ;;
  each (check_hull pr m) 1 (hull c).

Definition predicates_of (D : plane_or_space) : predicates :=
  match D with Plane => plane_predicates | Space => space_predicates end.
Definition check (D : plane_or_space) (c : certificate) : result := check_in (predicates_of D) c.
