(** * What the integer predicates compute

    The caller's points are the integer points times P/Q, here a real number r > 0, and the weights
    the integer weights times the square of r.  The integers of [Predicates.v] are then the
    orientations and depths of the caller's points up to a positive power of r ([computes]); this
    is shown by comparing polynomials. *)
From Coq Require Import Rbase Rfunctions Lra Lia List ZArith.
From Coq Require Vector.
From Circumspect Require Import Checker Numbering.
From Circumspect Require Import Definitions Vectors Affine Frame Orientation.
Import ListNotations.
Open Scope R_scope.

(** The height of the caller's point. *)
Definition height_of {d : nat} (r : R) (s : site) : R :=
  norm2 (@place_of d r s) - r ^ 2 * IZR (weight s).

Definition well_shaped (d : nat) (s : site) : Prop := length (coordinates s) = d.

Record computes {d : nat} (orient : list (point d) -> R) (pr : predicates) : Prop := {
  computes_dimension : dimension pr = d;
  computes_orientation : forall r X, Forall (well_shaped d) X ->
    orient (map (place_of r) X) = r ^ d * IZR (orientation pr X);
  computes_side : forall r i X s w, Forall (well_shaped d) X -> length X = S d -> (i <= d)%nat ->
    well_shaped d s -> (0 < w)%Z ->
    IZR w * orient (replace i (place_of (r / IZR w) s) (map (place_of r) X)) =
      r ^ d * IZR (side pr i X s w);
  computes_side_index : forall i X s w, side pr i X s w <> 0%Z -> (i <= d)%nat;
  computes_depth : forall r X p, Forall (well_shaped d) X -> length X = S d -> well_shaped d p ->
    sum (S d) (fun i => orient (replace i (place_of r p) (map (place_of r) X)) *
                        @height_of d r (nth i X p))
      - orient (map (place_of r) X) * @height_of d r p =
    r ^ (d + 2) * IZR (depth pr X (slope pr X) p)
}.

Lemma shape2 s : well_shaped 2 s -> exists x y w, s = Site [x; y] w.
Proof. destruct s as [[|x [|y [|z l]]] w]; try discriminate. now exists x, y, w. Qed.
Lemma shape3 s : well_shaped 3 s -> exists x y z w, s = Site [x; y; z] w.
Proof. destruct s as [[|x [|y [|z [|u l]]]] w]; try discriminate. now exists x, y, z, w. Qed.
Ltac shapes := repeat match goal with
  | H : Forall _ (_ :: _) |- _ => apply Forall_cons_iff in H; destruct H
  | H : well_shaped 2 ?s |- _ => apply shape2 in H; destruct H as (? & ? & ? & ->)
  | H : well_shaped 3 ?s |- _ => apply shape3 in H; destruct H as (? & ? & ? & ? & ->)
  end.
(** How IZR z is made of the IZR of the parts of z.  One rewriting, by a proof that is made at once,
    is ten times as fast as hundreds, one a part. *)
Ltac parts_of z := lazymatch z with
  | (?a + ?b)%Z => let p := parts_of a in let q := parts_of b in
      constr:(eq_trans (plus_IZR a b) (f_equal2 Rplus p q))
  | (?a - ?b)%Z => let p := parts_of a in let q := parts_of b in
      constr:(eq_trans (minus_IZR a b) (f_equal2 Rminus p q))
  | (?a * ?b)%Z => let p := parts_of a in let q := parts_of b in
      constr:(eq_trans (mult_IZR a b) (f_equal2 Rmult p q))
  | (- ?a)%Z => let p := parts_of a in constr:(eq_trans (opp_IZR a) (f_equal Ropp p))
  | _ => constr:(eq_refl (IZR z))
  end.
Ltac integers := repeat match goal with
  | |- context [IZR ?z] =>
      lazymatch z with
      | (_ + _)%Z => idtac | (_ - _)%Z => idtac | (_ * _)%Z => idtac | (- _)%Z => idtac
      end;
      let p := parts_of z in rewrite p
  end.

Lemma norm2_2 (p : point 2) : norm2 p = abscissa p * abscissa p + ordinate p * ordinate p.
Proof. apply inner2. Qed.
Lemma norm2_3 (p : point 3) :
  norm2 p = abscissa p * abscissa p + ordinate p * ordinate p + height p * height p.
Proof. apply inner_3. Qed.

Theorem plane_computes : computes orient2 plane_predicates.
Proof.
  constructor.
  - reflexivity.
  - intros r X Sh. destruct X as [|a [|b [|c [|e X]]]]; cbn [map orient2]; try (cbn; ring).
    shapes. cbn. integers. ring.
  - intros r i X s w Sh L Hi Hs Hw. apply IZR_lt in Hw.
    destruct X as [|a [|b [|c [|e X]]]]; try discriminate L.
    shapes. destruct i as [|[|[|i]]]; [| | |lia]; cbn; integers; field; lra.
  - intros [|[|[|i]]] X s w N; try lia. exfalso. apply N.
    destruct X as [|a [|b [|c [|e X]]]]; reflexivity.
  - intros r X p Sh L Hp. destruct X as [|a [|b [|c [|e X]]]]; try discriminate L.
    unfold height_of. shapes. unfold sum. cbn [seq sum_over nth]. rewrite !norm2_2.
    cbn. integers. ring.
Qed.

Theorem space_computes : computes orient3 space_predicates.
Proof.
  constructor.
  - reflexivity.
  - intros r X Sh. destruct X as [|a [|b [|c [|e [|f X]]]]]; cbn [map orient3]; try (cbn; ring).
    shapes. cbn. unfold determinant. integers. ring.
  - intros r i X s w Sh L Hi Hs Hw. apply IZR_lt in Hw.
    destruct X as [|a [|b [|c [|e [|f X]]]]]; try discriminate L.
    shapes. destruct i as [|[|[|[|i]]]]; [| | | |lia]; cbn; unfold determinant; integers; field;
      lra.
  - intros [|[|[|[|i]]]] X s w N; try lia. exfalso. apply N.
    destruct X as [|a [|b [|c [|e [|f X]]]]]; reflexivity.
  - intros r X p Sh L Hp. destruct X as [|a [|b [|c [|e [|f X]]]]]; try discriminate L.
    unfold height_of. shapes. unfold sum. cbn [seq sum_over nth]. rewrite !norm2_3.
    cbn. unfold determinant, height3. cbn. integers. ring.
Qed.
