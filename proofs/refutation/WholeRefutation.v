(** * The checker of refutations that speak of the whole domain

    [refute_whole] is extracted; [WholeSound.v] proves what its acceptance means. *)
From Coq Require Import ZArith List Bool.
From Circumspect Require Export GivenDomain.
Import ListNotations.
Open Scope Z_scope.

Section Whole.
Variable pr : predicates.
Variable D : domain_certificate.
Variable m : refutation.                        (* the caller's mesh, and what may dangle *)
Variable x : dangling_part.
Notation c := (whole_mesh D).
Definition given_vertices : Table.t site := Table.of_list bare (points c).
Definition given_polygons : list polygon_in_tables := map in_tables (polygons D).
Definition given_point : domain_point -> option cell_point :=
  cell_point_of pr given_vertices (Table.of_list id (segments (domain_part D)))
    (Table.of_list id given_polygons).

(** The simplex does not contain the point; or it does, and of the least face that does a vertex is
    off the cell. *)
Definition misses (S : Table.t site) (q : site) (w : Z) (x : row) : bool :=
  match proper_simplex_of pr S x with Some X => negb (in_simplex pr X q w) | None => false end.
Definition leaves (S : Table.t site) (y : cell_point) (x : row) : bool :=
  match proper_simplex_of pr S x with
  | Some X => negb (in_simplex pr X (cell_site y) (cell_w y)) ||
      existsb (beside y) (carrier_of pr X (cell_site y) (cell_w y))
  | None => false
  end.

(** Of all that is listed: what is true of the full simplices is true of their faces. *)
Definition site_table (m : refutation) : Table.t site :=
  Table.of_list (site_for Delaunay) (sites m).
Definition all_of (f : Table.t site -> row -> bool) : bool :=
  pads_known m x && forallb (f (site_table (padded m x))) (rows (padded m x)).
Definition in_simplex_of_all (t : positive) (q : site) (w : Z) : bool :=
  own_simplex_at m x pr t (fun X n => in_own pr X n q w).
(** Nothing dangles: no row is listed so, nor is one among the simplices too short. *)
Definition nothing_dangles : bool :=
  match dangling x with [] => forallb (right_length pr) (rows m) | _ => false end.
(** What dangles is listed with fewer vertices than a d-simplex has. *)
Definition shorter_rows : bool :=
  forallb (fun ab => has_at_most (dimension pr) (fst ab)) (dangling x).

(** Where the legs lead, if nothing is in their way. *)
Fixpoint at_the_end (q : site) (w : Z) (legs : list leg) : option (site * Z) :=
  match legs with
  | [] => Some (q, w)
  | a :: rest => if clear_leg pr D given_vertices q w (leg_end a) (leg_w a) (leg_planes a)
                 then at_the_end (leg_end a) (leg_w a) rest else None
  end.
Definition behind (n : list Z) (o : Z) (K : list site) : bool :=
  forallb (fun k => inner_product n (coordinates k) <=? o) K.
Definition is_outside (q : site) (w : Z) (legs : list leg) (out : way_off) : bool :=
  match out, legs, at_the_end q w legs with
  | IntoHole h, _ :: _, Some (e, v) =>
      match kind D with Enclosed => true | Hull => false end &&
      match Table.find h (Table.of_list id (holes (domain_part D))) with
      | Some x => same_place (times (hole_w x) e) (times v (hole_point x))
      | None => false
      end
  | Beyond n o, _, Some (e, v) =>
      match kind D, legs with Hull, _ :: _ => false | _, _ => true end &&
      Nat.eqb (length n) (dimension pr) && (0 <? inner_product n n) &&
        (v * o <? inner_product n (coordinates e)) &&
      all_off D given_vertices (behind n o)
  | _, _, _ => false
  end.

(** The way from q / w to v, in pieces of the polygon: from bend to bend, and from the last one in
    the last piece. *)
Definition is_in_piece (f : polygon_in_tables) (u : positive) (q : site) (w : Z) : bool :=
  let '(f, pieces, marks2, points2) := f in
  match piece_of pieces points2 u with
  | Some Y => point_written pr q w && kept_at marks2 u && in_plane f q w &&
      proper plane_predicates Y &&
      in_simplex plane_predicates Y (seen f q) w
  | None => false
  end.
Fixpoint stays (f : polygon_in_tables) (v q : site) (w : Z) (bends : list (positive * (site * Z)))
  (last : positive) : bool :=
  match bends with
  | [] => is_in_piece f last q w && is_in_piece f last v 1
  | (u, (q', w')) :: rest =>
      is_in_piece f u q w && is_in_piece f u q' w' &&
        on_segment (times w' q) (times (w * w') v) (times w q') &&
      stays f v q' w' rest last
  end.
(** The domain without polygon K. *)
Definition other_polygons (k : positive) : list polygon_entry :=
  firstn (pred (Pos.to_nat k)) (polygons D) ++ skipn (Pos.to_nat k) (polygons D).
Definition without_polygon (k : positive) : domain_certificate :=
  DomainCertificate (domain_claimed D) (kind D) (whole_mesh D) (domain_part D) (other_polygons k).
Definition seen_in_polygon (k : positive) (p q : site) (w : Z)
  (bends : list (positive * (site * Z))) (last : positive)
    (planes : list (list Z * Z)) : bool :=
  match Table.find k (Table.of_list id given_polygons) with
  | Some f => stays f p q w bends last &&
      match check_about pr (without_polygon k) with Accepted => true | Rejected _ _ => false end &&
      sees pr (without_polygon k) given_vertices p q w planes
  | None => false
  end.
(** Three of the vertices of the simplex that the pads make of it are its own, and the point is
    inside their triangle. *)
Definition in_dangling_triangle (X : list site) (n : nat) (q : site) (w : Z) : bool :=
  Nat.eqb n 3 && Nat.eqb (length (firstn n X)) 3 && in_own pr X n q w &&
    forallb (fun i => 0 <? coordinate_sign pr X q w i) [0; 1; 2]%nat &&
  in_no_row m (Table.of_list (site_for Delaunay) (sites (padded m x))) (firstn n X) && shorter_rows.

Definition whole_holds (e : whole_evidence) : bool :=
  match e with
  | FacetInNoWall t i u j q w =>
      match domain_claimed D with Cdt | SteinerCdt => true | _ => false end &&
        point_written pr q w && nothing_dangles &&
      proper_at pr (site_table m) (Table.of_list id (rows m)) t (fun X =>
        Nat.ltb i (Datatypes.S (dimension pr)) && inside_facet pr X i q w &&
        proper_at pr (site_table m) (Table.of_list id (rows m)) u (fun Y => not_local pr X i Y j))
          &&
      off_walls pr D given_vertices given_polygons q w
  | BallSeen t v q w planes =>
      match domain_claimed D with Cdt | SteinerCdt => true | _ => false end &&
        point_written pr q w && nothing_dangles &&
      proper_at pr (site_table m) (Table.of_list id (rows m)) t (fun X =>
        strictly_in_simplex pr X q w &&
        point_at (site_table m) v (fun p => (0 <? below_sign pr X p) &&
          existsb (lists (site_table m) p) (rows m) &&
          sees pr D given_vertices p q w planes))
  | NotTiled k u q w =>
      match given_point (InPiece k u q w) with Some y => all_of (fun S => leaves S y) | None =>
        false end
  | NotCovered z =>
      match given_point z with Some y => all_of (fun S => misses S (cell_site y) (cell_w y)) | None
        => false end
  | Strays t q w legs out =>
      point_written pr q w && in_simplex_of_all t q w && is_outside q w legs out
  | Gap t q w a =>
      match kind D with Enclosed => true | Hull => false end && point_written pr q w &&
      in_simplex_of_all t q w && clear_leg pr D given_vertices q w (leg_end a) (leg_w a)
        (leg_planes a) &&
      all_of (fun S => misses S (leg_end a) (leg_w a))
  | OfHull e =>
      match kind D with Hull => true | Enclosed => false end && nothing_dangles &&
      match e with HullNotConvex _ _ p => lists_in_mesh m p | HullNotClosed _ _ _ _ _ _ =>
        true | _ => false end &&
      holds pr (site_table m) (Table.of_list id (rows m)) (rows m) e
  | CoveredElsewhere _ _ _ => false
  | DanglingSees u v own z k q w bends last planes =>
      match domain_claimed D with Cdt | SteinerCdt => true | _ => false end &&
        match kind D with Enclosed => true | Hull => false end &&
      point_written pr q w && lists_in_mesh (as_listed m x) v &&
      point_at (site_table m) v (fun p =>
        own_simplex_at m x pr u (fun X n => in_dangling_triangle X n q w &&
          no_ball pr (combine own (firstn n X)) [(z, p)]) &&
        seen_in_polygon k p q w bends last planes)
  end.
End Whole.

(** The points of the mesh and of the domain are in the same unit. *)
Definition refute_whole_in (pr : predicates) (x : whole_refutation) : bool :=
  let m := mesh_against x in
  let D := about_domain x in
  match refuted m with Delaunay => true | _ => false end &&
  (unit_numerator m =? numerator (whole_mesh D)) &&
    (unit_denominator m =? denominator (whole_mesh D)) &&
  match check_about pr D with Accepted => true | Rejected _ _ => false end &&
  forallb (shaped pr) (sites (padded m (dangling_against x))) &&
    whole_holds pr D m (dangling_against x) (shown_by x).

(** ** Another mesh

    What is in a kept simplex of a certificate that is accepted is in its domain.  Its unit is its
    own. *)
Definition as_steiner (D : domain_certificate) : domain_certificate :=
  DomainCertificate SteinerTriangulation (kind D) (whole_mesh D) (domain_part D) (polygons D).
Definition in_kept_simplex (pr : predicates) (D : domain_certificate) (t : positive) (q : site)
  (w : Z) : bool :=
  match Table.find t (Table.of_list id (simplices (whole_mesh D))),
    Table.find t (Table.of_list id (marks (domain_part D))) with
  | Some e, Some k =>
      kept k && right_length pr (corners e) &&
      match find_all (Table.of_list bare (points (whole_mesh D))) (corners e) with
      | Some X => forallb (shaped pr) X && proper pr X && in_simplex pr X q w
      | None => false
      end
  | _, _ => false
  end.
Definition covered_elsewhere (D : plane_or_space) (x : whole_refutation) (t : positive) (q : site)
  (w : Z) : bool :=
  let m := mesh_against x in
  let c := whole_mesh (about_domain x) in
  match refuted m with Delaunay => true | _ => false end &&
  (0 <? unit_numerator m) && (0 <? unit_denominator m) && (0 <? numerator c) &&
    (0 <? denominator c) &&
  forallb (shaped (predicates_of D)) (sites (padded m (dangling_against x))) &&
    point_written (predicates_of D) q w &&
  match check_domain D (as_steiner (about_domain x)) with Accepted => true | Rejected _ _ =>
    false end &&
  in_kept_simplex (predicates_of D) (about_domain x) t q w &&
  all_of m (dangling_against x) (fun S => misses (predicates_of D) S
    (times (numerator c * unit_denominator m) q)
    (w * (denominator c * unit_numerator m))).
Definition refute_whole (D : plane_or_space) (x : whole_refutation) : bool :=
  match shown_by x with
  | CoveredElsewhere t q w => covered_elsewhere D x t q w
  | _ => refute_whole_in (predicates_of D) x
  end.
