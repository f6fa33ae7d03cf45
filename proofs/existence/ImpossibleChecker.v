(** * The checker of what shows that a domain has no triangulation, or no CDT

    [check_impossible] is extracted; [ImpossibleSound.v] proves what its acceptance means.  The
    domain is read as that of a certificate.  Candidates are all sets of four of its vertices; of
    each it is said why it is in no triangulation, or that it may be.  Clauses about these, each
    with its reason, hold of every triangulation; together nothing satisfies them. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export GivenDomain WholeRefutation SameDomain Rup.
Import ListNotations.
Open Scope Z_scope.

(** All lists of [n] of the numbers, in their order. *)
Fixpoint sublists_of (n : nat) (l : list positive) : list (list positive) :=
  match l with
  | [] => match n with O => [[]] | S _ => [] end
  | x :: rest => match n with
                 | O => [[]]
                 | S n' => map (cons x) (sublists_of n' rest) ++ sublists_of n rest
                 end
  end.
Fixpoint numbered_from {A} (k : positive) (l : list A) : list positive :=
  match l with [] => [] | _ :: rest => k :: numbered_from (Pos.succ k) rest end.

Section Impossible.
Variable D : domain_certificate.
Notation c := (whole_mesh D).
Notation pr := space_predicates.
Variable S : Table.t site.                      (* the vertices *)
Variable segments_of : Table.t segment_entry.
Variable polygons_listed : list polygon_in_tables.
Variable polygons_of : Table.t polygon_in_tables.
Notation cell_point_of := (cell_point_of pr S segments_of polygons_of).

(** ** Candidates *)

(** [fate-shown] *)
Definition fate_holds (K : list positive) (e : fate) : bool :=
  match find_all S K with
  | None => false
  | Some X =>
      match e with
      | Flat => negb (proper pr X)
      | MayBeChosen => proper pr X
      | Pierced x => proper pr X &&
          match cell_point_of x with
          | None => false
          | Some y => in_simplex pr X (cell_site y) (cell_w y) &&
              existsb (beside y) (carrier_of pr X (cell_site y) (cell_w y))
          end
      | Encroached k q w planes =>
          match domain_claimed D with Cdt => true | _ => false end &&
          proper pr X && point_written pr q w && strictly_in_simplex pr X q w &&
          match Table.find k S with
          | Some v => (0 <? below_sign pr X v) && sees pr D S v q w planes
          | None => false
          end
      end
  end.
Definition check_fate (k : positive) (K : list positive) (e : fate) : result :=
  require fate_shown by fate_holds K e at AtCandidate k; Accepted.

Variable candidates : list (list positive).
Variable candidates_of : Table.t (list positive).
Variable fates_of : Table.t fate.
Definition may_be_chosen (k : positive) : bool :=
  match Table.find k fates_of with Some MayBeChosen => true | _ => false end.
(** The vertices of candidate K. *)
Definition candidate_at (k : positive) : option (list site) :=
  match Table.find k candidates_of with Some K => find_all S K | None => None end.

(** ** Clauses *)

Definition listed_beside (K : list positive) (X : list site) (i : nat) (l : list positive)
  (k : positive) (p : site) : bool :=
  negb (beyond pr X p 1 i) ||
  existsb (fun n => match Table.find n candidates_of with
                    | Some L => same_members L (k :: remove i K)
                    | None => false
                    end) l.
Fixpoint all_beside (K : list positive) (X : list site) (i : nat) (l : list positive) (k : positive)
    (points : list point_entry) : bool :=
  match points with
  | [] => true
  | e :: r => listed_beside K X i l k (bare e) && all_beside K X i l (Pos.succ k) r
  end.
(** The clause, if the reason is one. *)
Definition clause_of (r : reason) : option clause :=
  match r with
  | OneCovers x =>
      match cell_point_of x with
      | None => None
      | Some y => Some (map (pair true) (filter (fun k => may_be_chosen k &&
          match candidate_at k with
          | Some X => in_simplex pr X (cell_site y) (cell_w y)
          | None => false
          end) (numbered_from 1 candidates)))
      end
  | NotBoth s u q w =>
      match candidate_at s, candidate_at u with
      | Some X, Some Y =>
          if may_be_chosen s && may_be_chosen u && overlapping pr X Y q w
          then Some [(false, s); (false, u)] else None
      | _, _ => None
      end
  | OneBeside s i q w l =>
      match Table.find s candidates_of, candidate_at s with
      | Some K, Some X =>
          if may_be_chosen s && Nat.ltb i 4 && point_written pr q w && inside_facet pr X i q w &&
             match kind D with
             | Hull => existsb (fun e => beyond pr X (bare e) 1 i) (points c)
             | Enclosed => forallb (off_polygon q w) polygons_listed
             end &&
             all_beside K X i l 1 (points c)
          then Some ((false, s) :: map (pair true) (filter may_be_chosen l)) else None
      | _, _ => None
      end
  end.
(** The clauses, or the number of the first that has no reason. *)
Fixpoint clauses_of (k : positive) (l : list reason) : list clause + positive :=
  match l with
  | [] => inl []
  | r :: rest => match clause_of r with
                 | None => inr k
                 | Some x => match clauses_of (Pos.succ k) rest with
                             | inl y => inl (x :: y)
                             | inr n => inr n
                             end
                 end
  end.
End Impossible.

(** ** Nothing dangles

    [mesh-of-the-domain]: without it the tetrahedra of a triangulation need not cover the domain,
    for what dangles has none beside it ([check_impossible_sound]). *)
Definition check_mesh_of (D M : domain_certificate) : result :=
  check_domain Space (as_steiner M) ;;
  (require mesh_of_the_domain by same_domain D M at Nowhere; Accepted).

(** ** The whole

    [reason-shown], [clauses-refuted] *)
Definition check_impossible (x : impossibility) : result :=
  let D := about x in
  let S := Table.of_list bare (points (whole_mesh D)) in
  let segments_of := Table.of_list id (segments (domain_part D)) in
  let polygons_listed := map in_tables (polygons D) in
  let polygons_of := Table.of_list id polygons_listed in
  let candidates := sublists_of 4 (numbered_from 1 (points (whole_mesh D))) in
  let candidates_of := Table.of_list id candidates in
  let fates_of := Table.of_list id (fates x) in
  check_about space_predicates D ;;
  check_mesh_of D (some_mesh x) ;;
  each_pair fate_shown AtCandidate (check_fate D S segments_of polygons_of) 1 candidates
    (fates x) ;;
  match clauses_of D S segments_of polygons_listed polygons_of candidates candidates_of fates_of 1
    (reasons x) with
  | inr k => Rejected reason_shown (AtReason k)
  | inl l => require clauses_refuted by refuted_clauses l (steps x) at Nowhere; Accepted
  end.
