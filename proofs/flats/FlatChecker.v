(** * The checker of certificates of points of a plane in space

    [judge_flat] is extracted; [FlatSound.v] proves what its acceptance means.  In the picture of
    the plane a triangulation is a triangulation.  The ball of a triangle is not a circle there; but
    its lifted plane is one, over the heights that the points have in space. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export Judge Flats DomainChecker.
Import ListNotations.
Open Scope Z_scope.

Section Flat.
Variables (p : packed) (x : flat_certificate).

(** [point-in-plane]: without it the points in space would be others than those that are seen
    ([raised_seen]), or all be on one line.  [point-used]: a point is a vertex, also where
    weights are.  [weight-unseen]: without it the heights would be others ([height_unseen]). *)
Definition placed (e : point_entry) (z : Z) : bool :=
  inner_product (flat_normal x)
    (coordinates (with_unseen (unseen_axis x) (position e) z)) =? flat_offset x.
Definition check_seen (k : positive) (e : point_entry) (z : Z) : result :=
  require point_in_plane by placed e z at AtPoint k;
  require point_used by match home_vertex e with Some _ => true | None => false end at AtPoint k;
  require weight_unseen by match claimed (frame p) with
    | WeightedDelaunay => weight (position e) =? - (z * z)
    | _ => true
    end at AtPoint k;
  Accepted.
Fixpoint check_unseen (k : positive) (l : list point_entry) (zs : list Z) : result :=
  match l, zs with
  | [], [] => Accepted
  | e :: l', z :: zs' => match check_seen k e z with
                         | Accepted => check_unseen (Pos.succ k) l' zs'
                         | rejected => rejected
                         end
  | _, _ => Rejected point_in_plane (AtPoint k)
  end.
Definition check_flat : result :=
  require point_in_plane by
    Nat.ltb (unseen_axis x) 3 && Nat.eqb (length (flat_normal x)) 3 &&
    negb (nth (unseen_axis x) (flat_normal x) 0 =? 0) at Nowhere;
  require claim_of_mesh by
    match claimed (frame p) with Delaunay => false | _ => true end at Nowhere;
  check_unseen 1 (points (frame p)) (unseen x).

Definition judge_flat (s : Word.t) : verdict :=
  match judge Plane p None s with
  | Holds => match check_flat with Accepted => Holds | Rejected why where_ => Fails why where_ end
  | fails => fails
  end.
End Flat.
