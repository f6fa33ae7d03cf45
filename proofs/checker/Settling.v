(** * The only Delaunay triangulation, or the canonical one

    Of an accepted certificate these two further checks look at the same facets and points once
    more.  [Unique]: every apex is strictly outside the circumball of the simplex on the other side,
    every submerged point strictly above the witness plane.  [Canonical]: where one is on it, the
    perturbation decides: the first point, in the order of the list, that has a coefficient is a
    vertex of the simplex, with a positive barycentric coordinate of the apex. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Checker.
Import ListNotations.
Open Scope Z_scope.

Inductive standing := Canonical | Unique.

(** The first rejection; or no rejection. *)
Inductive settlement := Settled | Unsettled (p : place).

Section Settling.
Variables (pr : predicates) (m : mesh) (s : standing).

(** Vertex v, number [i] of the simplex, precedes point k, and p has a positive coordinate there; at
    vertices that precede v it has none. *)
Definition first_positive (K : list positive) (X : list site) (k : positive) (p : site)
    (vi : positive * nat) : bool :=
  Pos.ltb (fst vi) k && (0 <? side pr (snd vi) X p 1) &&
  forallb (fun uj => negb (Pos.ltb (fst uj) (fst vi)) || (side pr (snd uj) X p 1 =? 0))
    (combine K (seq 0 (length K))).
Definition decided (K : list positive) (X : list site) (k : positive) (p : site) : bool :=
  existsb (first_positive K X k p) (combine K (seq 0 (length K))).
Definition settled (K : list positive) (X : list site) (n : list Z) (k : positive) (p : site) :
  bool :=
  let z := depth pr X n p in
  (z <? 0) ||
  match s with Unique => false | Canonical => (z =? 0) && decided K X k p end.

Definition settled_wall (t : positive) (K : list positive) (X : list site) (n : list Z) (f : wall) :
    bool :=
  match f with
  | OnHull _ => true
  | Neighbour u j =>
      negb (Pos.ltb t u) ||
      match Table.find u (simplices_of m) with
      | None => false
      | Some e => match nth_error (corners e) j with
                  | None => false
                  | Some v => match Table.find v (points_of m) with
                              | None => false
                              | Some p => settled K X n v p
                              end
                  end
      end
  end.
Definition settled_simplex (t : positive) (e : simplex_entry) : bool :=
  match find_all (points_of m) (corners e) with
  | None => false
  | Some X => let n := slope pr X in forallb (settled_wall t (corners e) X n) (walls e)
  end.
Definition settled_point (k : positive) (e : point_entry) : bool :=
  match home_vertex e with
  | Some _ => true
  | None => match Table.find (home e) (simplices_of m) with
            | None => false
            | Some t => match find_all (points_of m) (corners t) with
                        | None => false
                        | Some X => settled (corners t) X (slope pr X) k (position e)
                        end
            end
  end.
End Settling.

Fixpoint all_settled {A} (f : positive -> A -> bool) (at_ : positive -> place) (k : positive)
    (l : list A) : settlement :=
  match l with
  | [] => Settled
  | a :: l' => if f k a then all_settled f at_ (Pos.succ k) l' else Unsettled (at_ k)
  end.
Definition settle_in (pr : predicates) (c : certificate) (s : standing) : settlement :=
  let m := mesh_of c in
  if delaunay_of (claimed c) then
    match all_settled (settled_simplex pr m s) AtSimplex 1 (simplices c) with
    | Settled => all_settled (settled_point pr m s) AtPoint 1 (points c)
    | unsettled => unsettled
    end
  else Unsettled Nowhere.
Definition settle (D : plane_or_space) (c : certificate) (s : standing) : settlement :=
  settle_in (predicates_of D) c s.
