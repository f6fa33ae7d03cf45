(** * Sight: the walk of the Constrained Delaunay Lemma  (Book: Lemma 4.10, (iii) => (i))

    A complex of d-simplices, in which some facets are walls ([wall]): at least all facets that have
    no neighbour.  Heights are arbitrary; across every facet that is not a wall the neighbour's apex
    is not below the witness plane.  If the vertex p can be seen from a point x of simplex t - the
    segment stays in the complex and touches no wall before p - then p is not below t's witness
    plane. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Matched Faces Walk Generic Mesh.
From Circumspect Require Import Adjacency LiftingMap DelaunayLemma Enclosed.
Import ListNotations.
Open Scope R_scope.

(** ** Finitely many affine functions: at each point of a segment one of them is negative *)

(** [f u w]: values at the two ends.  A sum of two of them is negative on the whole segment. *)
Lemma two_suffice {A} (u w : A -> R) (l : list A) :
  (forall s, 0 <= s <= 1 -> exists a, In a l /\ (1 - s) * u a + s * w a < 0) ->
  exists a b c e, In a l /\ In b l /\ 0 <= c /\ 0 <= e /\
    c * u a + e * u b < 0 /\ c * w a + e * w b < 0.
Proof.
  intros H.
  destruct (Exists_dec (fun a => u a < 0 /\ w a < 0) l) as [X|N].
  { intros a. destruct (Rlt_dec (u a) 0), (Rlt_dec (w a) 0); (left; tauto) || (right; tauto). }
  { apply Exists_exists in X. destruct X as (a & Ha & U & W). exists a, a, 1, 0.
    repeat split; auto; lra. }
  assert (Both : forall a, In a l -> u a < 0 -> 0 <= w a).
  { intros a Ha U. destruct (Rlt_dec (w a) 0) as [W|]; [|lra]. exfalso. apply N, Exists_exists.
    exists a. auto. }
  set (neg := filter (fun a => if Rlt_dec (u a) 0 then true else false) l).
  assert (Neg : forall a, In a neg <-> In a l /\ u a < 0).
  { intros a. unfold neg. rewrite filter_In. destruct (Rlt_dec (u a) 0); intuition discriminate. }
  assert (Ne : neg <> []).
  { destruct (H 0 ltac:(lra)) as (a & Ha & V). intros E.
    assert (I : In a neg) by (apply Neg; split; [assumption|lra]). rewrite E in I. destruct I. }
  (* the one whose negative part reaches farthest *)
  destruct (smallest (fun a => - (u a / (u a - w a))) neg Ne) as (a & Ha & Far).
  apply Neg in Ha. destruct Ha as [Ha Ua]. pose proof (Both a Ha Ua) as Wa.
  set (r := u a / (u a - w a)) in *.
  assert (Er : r * (w a - u a) = - u a) by (unfold r; field; lra).
  assert (Hr : 0 < r <= 1) by (split; nra).
  destruct (H r ltac:(lra)) as (b & Hb & V).
  assert (Ub : 0 <= u b).
  { destruct (Rlt_dec (u b) 0) as [L|]; [exfalso|lra]. pose proof (Both b Hb L) as Wb.
    assert (I : In b neg) by now apply Neg. specialize (Far b I). cbn beta in Far.
    set (q := u b / (u b - w b)) in *.
    assert (Eq : q * (w b - u b) = - u b) by (unfold q; field; lra). nra. }
  assert (Wb : w b < 0) by nra.
  assert (D : w a * u b - u a * w b < 0).
  { assert (K : (w a - u a) * ((1 - r) * u b + r * w b) < 0) by nra.
    replace ((w a - u a) * ((1 - r) * u b + r * w b)) with
      (u b * ((w a - u a) - r * (w a - u a)) + w b * (r * (w a - u a))) in K by ring.
    rewrite Er in K. nra. }
  exists a, b, (u b - w b), (w a - u a). repeat split; auto; nra.
Qed.

Lemma mix_swap {d} (p q : point d) s : mix p q s = mix q p (1 - s).
Proof. unfold mix. rewrite plus_comm. now replace (1 - (1 - s)) with s by ring. Qed.
Lemma mix_mix {d} (x p : point d) s r : mix x (mix x p r) s = mix x p (s * r).
Proof.
  apply affine_separate. intros f A. rewrite !affine_mix by assumption. ring.
Qed.

Section Sight.
Context {d : nat} {A : Type} (tets : list A) (geo : A -> frame d).
Hypothesis positive : (1 <= d)%nat.
Hypothesis agreeing : forall t u, In t tets -> In u tets -> agree (geo t) (geo u).
Hypothesis different : forall t u, In t tets -> In u tets ->
  same (vertices (geo t)) (vertices (geo u)) -> t = u.

Notation adj := (adjacent tets geo).
Notation outer := (outer tets geo).

(** Facets that block the sight: all that have no neighbour, and whatever else. *)
Variable wall : A -> nat -> Prop.
Hypothesis outer_wall : forall t i, In t tets -> (i <= d)%nat -> outer t i -> wall t i.

Notation on_facet := (on_facet geo).

(** p can be seen from x: the segment is in the complex, and meets no wall before p. *)
Definition sees x p : Prop := forall s, 0 <= s < 1 ->
  (exists t, In t tets /\ inside_closed (geo t) (mix x p s)) /\
  (forall t i, In t tets -> (i <= d)%nat -> wall t i -> ~ on_facet t i (mix x p s)).

(** A facet that a segment misses is separated from it. *)
Lemma separated t i x y : (i <= d)%nat ->
  (forall s, 0 <= s <= 1 -> ~ on_facet t i (mix x y s)) ->
  exists g, affine g /\ g x < 0 /\ g y < 0 /\ forall q, on_facet t i q -> 0 <= g q.
Proof.
  intros Hi Miss.
  set (fs := (fun q => - bary (geo t) i q) :: map (bary (geo t)) (seq 0 (S d))).
  assert (Aff : forall f, In f fs -> affine f).
  { intros f [<-|Hf]; [now apply affine_opp, bary_affine|]. apply in_map_iff in Hf.
    destruct Hf as (k & <- & Hk). apply bary_affine. now apply in_seq_d. }
  assert (Non : forall f q, In f fs -> on_facet t i q -> 0 <= f q).
  { intros f q [<-|Hf] [Z I]; [lra|]. apply in_map_iff in Hf. destruct Hf as (k & <- & Hk).
    apply I. now apply in_seq_d. }
  destruct (two_suffice (fun f : point d -> R => f x) (fun f => f y) fs)
    as (a & b & c & e & Ha & Hb & C & E & X & Y).
  - intros s Hs. specialize (Miss s Hs). set (q := mix x y s) in *.
    assert (W : exists f, In f fs /\ f q < 0).
    { destruct (Rlt_dec 0 (bary (geo t) i q)) as [P|NP].
      { exists (fun q => - bary (geo t) i q). split; [now left|lra]. }
      destruct (Exists_dec (fun k => bary (geo t) k q < 0) (seq 0 (S d))) as [Ex|N].
      { intros k. apply Rlt_dec. }
      { apply Exists_exists in Ex. destruct Ex as (k & Hk & L). exists (bary (geo t) k).
        split; [right; now apply in_map|assumption]. }
      exfalso. apply Miss.
      assert (I : inside_closed (geo t) q).
      { intros k Hk. destruct (Rle_dec 0 (bary (geo t) k q)) as [|L]; [assumption|exfalso].
        apply N, Exists_exists. exists k. split; [now apply in_seq_d|lra]. }
      split; [|assumption]. specialize (I i Hi). lra. }
    destruct W as (f & Hf & L). exists f. split; [assumption|].
    unfold q in L. now rewrite affine_mix in L by auto.
  - exists (fun q => c * a q + e * b q). split; [apply affine_combine; auto|].
    split; [assumption|]. split; [assumption|]. intros q Q.
    pose proof (Non a q Ha Q). pose proof (Non b q Hb Q). nra.
Qed.

(** All walls that a segment misses. *)
Lemma all_separated x y (l : list (A * nat)) :
  (forall t i, In (t, i) l -> In t tets /\ (i <= d)%nat) ->
  (forall t i, In (t, i) l -> wall t i -> forall s, 0 <= s <= 1 -> ~ on_facet t i (mix x y s)) ->
  ~ ~ exists G : list (point d -> R), (forall g, In g G -> affine g /\ 0 < g x /\ 0 < g y) /\
    forall t i, In (t, i) l -> wall t i -> exists g, In g G /\ forall q, on_facet t i q -> g q <= 0.
Proof.
  induction l as [|(t, i) l IH]; intros Dom Miss.
  { intros N. apply N. exists []. split; [intros g []|intros t i []]. }
  intros N. apply IH.
  { intros; apply Dom; now right. } { intros a k H. apply Miss. now right. }
  intros (G & G1 & G2). assert (D : ~ ~ (wall t i \/ ~ wall t i)) by tauto.
  apply D. intros [W|NW]; apply N.
  - destruct (Dom t i (or_introl eq_refl)) as [_ Hi].
    destruct (separated t i x y Hi (Miss t i (or_introl eq_refl) W)) as (g & Ag & X & Y & F).
    exists ((fun q => - g q) :: G). split.
    + intros f [<-|Hf]; [|now apply G1]. split; [now apply affine_opp|lra].
    + intros a k [E|H] Wa.
      * injection E as <- <-. exists (fun q => - g q). split; [now left|].
        intros q Q. specialize (F q Q). lra.
      * destruct (G2 a k H Wa) as (f & Hf & Q). exists f. split; [now right|assumption].
  - exists G. split; [assumption|]. intros a k [E|H] Wa; [|now apply G2].
    injection E as <- <-. contradiction.
Qed.

Variable h : point d -> R.
Hypothesis local : forall t i u j, In t tets -> adj t i u j -> ~ wall t i ->
  locally_above h (geo t) (geo u) j.

Let mesh := complex_matched tets geo positive agreeing different.

(** What can be seen from inside a simplex is not below its witness plane. *)
Theorem visible_vertex_above t x p : In t tets -> inside_closed (geo t) x -> vertex_of tets geo p ->
  sees x p -> witness h (geo t) p <= h p.
Proof.
  intros Ht Xt (a0 & i0 & Ha0 & Hi0 & Ep) See.
  destruct (Rle_dec (witness h (geo t) p) (h p)) as [|Bad]; [assumption|exfalso].
  (* the simplex u that the segment ends in *)
  destruct (towards geo p x tets) as [(u & Hu & Pu & Lead)|(e & He & K)].
  2: { destruct (See (1 - e)) as [(a & Ha & I) _]; [lra|]. rewrite mix_swap in I.
       replace (1 - (1 - e)) with e in I by ring. exact (K e ltac:(lra) a Ha I). }
  assert (Pv : witness h (geo u) p = h p).
  { assert (Pa : inside_closed (geo a0) p).
    { intros k Hk. rewrite Ep, bary_vertex by assumption. destruct (Nat.eq_dec k i0); lra. }
    destruct (agreeing a0 u Ha0 Hu p Pa Pu i0 Hi0) as (k & Hk & E & _).
    { rewrite Ep, bary_own by assumption. lra. }
    rewrite Ep, E. now apply witness_vertex. }
  set (g q := 1 * witness h (geo t) q + (-1) * witness h (geo u) q).
  assert (Ag : affine g) by (apply affine_combine; apply witness_affine).
  (* a point p1 of the segment in u, near p *)
  destruct (nearby (g :: positive_at (fun k => bary (geo u) k) p (seq 0 (S d))) p x)
    as (e & He & Near).
  { intros f [<-|Hf]; [split; [assumption|unfold g; lra]|].
    revert f Hf. apply positive_at_in. intros k Hk. apply bary_affine. now apply in_seq_d. }
  set (p1 := mix p x e). specialize (Near e ltac:(lra)). fold p1 in Near.
  assert (P1u : inside_closed (geo u) p1).
  { intros k Hk. destruct (Req_dec (bary (geo u) k p) 0) as [Z|NZ].
    - specialize (Lead k Hk Z). unfold p1. rewrite affine_mix, Z by now apply bary_affine. nra.
    - left. apply (positive_at_out (fun k => bary (geo u) k) p (seq 0 (S d)) p1).
      + intros f Hf. apply Near. now right.
      + now apply in_seq_d.
      + specialize (Pu k Hk). lra. }
  assert (Along : forall s, mix x p1 s = mix x p (s * (1 - e))).
  { intros s. unfold p1. rewrite (mix_swap p x). apply mix_mix. }
  (* all walls are away from the segment from x to p1 *)
  set (facet_list := flat_map (fun a => map (pair a) (seq 0 (S d))) tets).
  assert (FL : forall a i, In (a, i) facet_list <-> In a tets /\ (i <= d)%nat).
  { intros a i. unfold facet_list. rewrite in_flat_map. split.
    - intros (b & Hb & I). apply in_map_iff in I. destruct I as (k & E & Hk).
      injection E as <- <-. split; [assumption|now apply in_seq_d].
    - intros [Ha Hi]. exists a. split; [assumption|]. apply in_map. now apply in_seq_d. }
  apply (all_separated x p1 facet_list).
  { intros a i. apply FL. }
  { intros a i I W s Hs. apply FL in I. rewrite Along. apply (See (s * (1 - e))); try tauto.
    split; nra. }
  intros (G & G1 & G2).
  (* a generic segment near it *)
  destruct (generic_near mesh G x t []) as (x' & Xt' & Gx' & _ & Nx & _).
  { assumption. } { assumption. }
  { intros f Hf. split; apply (G1 f Hf). } { intros f []. }
  destruct (generic_near mesh (g :: G) p1 u [x']) as (y & Yu & Gy & _ & Ny & Nxy).
  { assumption. } { assumption. }
  { intros f [<-|Hf]; [split; [assumption|apply Near; now left]|]. split; apply (G1 f Hf). }
  { intros f [<-|[]]. assumption. }
  assert (Free : forall a i s, In a tets -> mesh_passes geo x' y a i s -> ~ wall a i).
  { intros a i s Ha (Ii & _ & Hs & Z & Pos) W. apply in_seq_d in Ii.
    destruct (G2 a i (proj2 (FL a i) (conj Ha Ii)) W) as (f & Hf & Q).
    assert (F : f (mix x' y s) <= 0).
    { apply Q. split; [exact Z|]. intros k Hk. destruct (Nat.eq_dec k i) as [->|N].
      - unfold coordinate in Z. lra.
      - left. apply (Pos k); [now apply in_seq_d|assumption]. }
    rewrite affine_mix in F by apply (G1 f Hf).
    specialize (Gx' f Hf). specialize (Gy f (or_intror Hf)). nra. }
  destruct (cells_walk (mesh_cells mesh)
    (fun a b => witness h (geo a) y <= witness h (geo b) y) x' y t) as (u' & Hu' & Yu' & W); auto.
  - apply Nxy. now left.
  - now apply in_cell_inside.
  - intros a i s Ha P. destruct (adjacent_dec tets geo a i Ha) as [Adj|O]; [assumption|exfalso].
    apply (Free a i s Ha P). apply outer_wall; try assumption. apply in_seq_d. apply P.
  - intros; lra.
  - intros; lra.
  - intros a i b j s Ha Hb _ Adj P Pos. apply (witness_crossing h (geo a) i (geo b) j).
    + apply Adj.
    + apply (local a i); auto. now apply (Free a i s).
    + assumption.
  - apply in_cell_inside in Yu'.
    assert (u' = u) as ->.
    { apply (inside_once tets geo agreeing different u' u y); auto.
      intros k Hk. left. now apply Yu. }
    specialize (Gy g (or_introl eq_refl)). unfold g in Gy. lra.
Qed.
End Sight.
