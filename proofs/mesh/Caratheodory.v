(** * Caratheodory's Theorem, and the simplices that points of S span

    A point of conv S is a convex combination of d+1 points of S ([caratheodory]): among more
    points there is an affine dependency, along which one coefficient can be made zero.

    d+1 points are the vertices of a d-simplex, or all in one hyperplane ([frame_or_flat]): replace
    the vertices of some d-simplex by them, one after another, as long as it goes.  So finitely
    many simplices and finitely many hyperplanes ([all_frames]) know everything about S, and a
    point of conv S on none of the hyperplanes is in the interior of some simplex. *)
From Coq Require Import Rbase Rfunctions Lra Psatz List Arith Lia.
From Circumspect Require Import Definitions Vectors Affine Frame Faces Independence Matched Cone.
Import ListNotations.
Open Scope R_scope.

Lemma smallest {A} (f : A -> R) (l : list A) : l <> [] ->
  exists i, In i l /\ forall k, In k l -> f i <= f k.
Proof.
  induction l as [|a l IH]; [congruence|intros _]. destruct l as [|b l'].
  - exists a. split; [now left|]. intros k [->|[]]. lra.
  - destruct IH as (i & Hi & M); [congruence|]. destruct (Rle_dec (f a) (f i)).
    + exists a. split; [now left|]. intros k [->|Hk]; [lra|]. specialize (M k Hk). lra.
    + exists i. split; [now right|]. intros k [->|Hk]; [lra|]. auto.
Qed.
Lemma sum_over_app {A} (f : A -> R) l m : sum_over (l ++ m) f = sum_over l f + sum_over m f.
Proof. induction l as [|a l IH]; cbn [app sum_over]; [ring|]. rewrite IH. ring. Qed.

(** A sum that is positive has a positive term. *)
Lemma positive_term {A} (l : list A) (f : A -> R) : 0 < sum_over l f ->
  exists i, In i l /\ 0 < f i.
Proof.
  induction l as [|a l IH]; cbn [sum_over]; intros P; [lra|].
  destruct (Rlt_dec 0 (f a)); [exists a; split; [now left|assumption]|].
  destruct IH as (i & Hi & Pi); [lra|]. exists i. split; [now right|assumption].
Qed.

Section Caratheodory.
Context {d : nat}.
Implicit Types (p q v : point d) (S X : list (point d)) (t u : frame d).

(** Some d+1 of the points x(i), i in [l], are enough. *)
Lemma caratheodory_indices (x : nat -> point d) : forall n l, length l = n -> NoDup l ->
  forall a : nat -> R, (forall i, In i l -> 0 <= a i) ->
  exists l' a', incl l' l /\ (length l' <= Datatypes.S d)%nat /\ (forall i, In i l' -> 0 <= a' i) /\
    forall f, affine f -> sum_over l' (fun i => a' i * f (x i)) =
                          sum_over l (fun i => a i * f (x i)).
Proof.
  induction n as [|n IH]; intros l L N a Pos.
  - exists l, a. split; [apply incl_refl|]. split; [lia|]. auto.
  - destruct (le_lt_dec (length l) (Datatypes.S d)) as [Few|Many].
    { exists l, a. split; [apply incl_refl|]. auto. }
    destruct (dependency x l N Many) as (c & (k & Hk & Nk) & C).
    assert (exists c, (exists k, In k l /\ 0 < c k) /\ forall f, affine f ->
      sum_over l (fun i => c i * f (x i)) = 0) as (c' & (k' & Hk' & Pk') & C').
    { destruct (Rlt_dec 0 (c k)); [exists c; split; [exists k; auto|assumption]|].
      exists (fun i => - c i). split; [exists k; split; [assumption|lra]|]. intros f F.
      rewrite (sum_ext _ _ (fun i => -1 * (c i * f (x i)))) by (intros; ring).
      rewrite sum_scale, C by assumption. ring. }
    clear c k Hk Nk C. rename c' into c, C' into C.
    set (ups := filter (fun i => if Rlt_dec 0 (c i) then true else false) l).
    assert (Ups : forall i, In i ups <-> In i l /\ 0 < c i).
    { intros i. unfold ups. rewrite filter_In. destruct (Rlt_dec 0 (c i)); intuition discriminate. }
    destruct (smallest (fun i => a i / c i) ups) as (m & Hm & Min).
    { intros E. assert (In k' ups) as I by now apply Ups. now rewrite E in I. }
    apply Ups in Hm. destruct Hm as [Hm Pm]. set (r := a m / c m) in *.
    assert (Er : r * c m = a m) by (unfold r; field; lra).
    set (b i := a i - r * c i).
    assert (Bm : b m = 0) by (unfold b; lra).
    assert (R0 : 0 <= r).
    { unfold r. apply Rmult_le_pos; [auto|]. left. now apply Rinv_0_lt_compat. }
    assert (B : forall i, In i l -> 0 <= b i).
    { intros i Hi. unfold b. pose proof (Pos i Hi). destruct (Rlt_dec 0 (c i)) as [P|P].
      - specialize (Min i (proj2 (Ups i) (conj Hi P))).
        assert (E : a i / c i * c i = a i) by (field; lra). nra.
      - nra. }
    assert (Sum : forall f, affine f -> sum_over l (fun i => b i * f (x i)) =
                                        sum_over l (fun i => a i * f (x i))).
    { intros f F.
      rewrite (sum_ext _ _ (fun i => a i * f (x i) + - r * (c i * f (x i))))
        by (intros; unfold b; ring). rewrite sum_plus, sum_scale, (C f F). ring. }
    destruct (in_split m l Hm) as (l1 & l2 & E).
    assert (I : forall i, In i (l1 ++ l2) -> In i l).
    { intros i Hi. rewrite E. apply in_app_or in Hi. apply in_or_app.
      destruct Hi; [now left|right; now right]. }
    destruct (IH (l1 ++ l2)) with (a := b) as (l' & a' & I' & L' & Pos' & Sum').
    + rewrite E, app_length in L. rewrite app_length. cbn [length] in L. lia.
    + rewrite E in N. now apply NoDup_remove_1 in N.
    + auto.
    + exists l', a'. split; [intros i Hi; apply I; now apply I'|]. split; [assumption|].
      split; [assumption|]. intros f F. rewrite Sum', <- Sum by assumption.
      rewrite E, !sum_over_app. cbn [sum_over]. rewrite Bm. ring.
Qed.

Theorem caratheodory S q : conv S q ->
  exists X, incl X S /\ length X = Datatypes.S d /\ conv X q.
Proof.
  intros (l & Hl & Tot & Com).
  set (x i := snd (nth i l (0, origin))). set (a i := fst (nth i l (0, origin))).
  assert (Nth : forall i, In i (seq 0 (length l)) -> In (a i, x i) l).
  { intros i Hi. apply in_seq in Hi. unfold a, x. rewrite <- surjective_pairing.
    apply nth_In. lia. }
  assert (Map : map (fun i => (a i, x i)) (seq 0 (length l)) = l).
  { unfold a, x. clear. transitivity (map (fun i => nth i l (0, origin)) (seq 0 (length l))).
    - apply map_ext. intros. now rewrite <- surjective_pairing.
    - induction l as [|y l IH]; [reflexivity|]. cbn [length seq map nth]. f_equal.
      rewrite <- seq_shift, map_map. exact IH. }
  destruct (caratheodory_indices x (length l) (seq 0 (length l))) with (a := a)
    as (l' & a' & I & L & Pos & Sum).
  { apply seq_length. } { apply seq_NoDup. } { intros i Hi. apply (Hl _ (x i)). auto. }
  assert (TotA : sum_over (seq 0 (length l)) a = 1) by now rewrite <- (total_map _ a x), Map.
  assert (Q : forall f, affine f -> f q = sum_over (seq 0 (length l)) (fun i => a i * f (x i))).
  { intros f F. rewrite <- (affine_combination_map _ a x f F TotA), Map. now rewrite Com. }
  assert (Tot' : sum_over l' a' = 1).
  { pose proof (Sum (fun _ => 1) (affine_const 1)) as E.
    rewrite (sum_ext _ _ a') in E by (intros; ring). rewrite E.
    rewrite (sum_ext _ _ a) by (intros; ring). exact TotA. }
  assert (C : conv (map x l') q).
  { exists (map (fun i => (a' i, x i)) l'). split; [|split].
    - intros b p H. apply in_map_iff in H. destruct H as (i & E & Hi). injection E as <- <-.
      split; [auto|now apply in_map].
    - now rewrite total_map.
    - apply affine_separate. intros f F. rewrite affine_combination_map by assumption.
      now rewrite Sum, Q by assumption. }
  assert (IS : incl (map x l') S).
  { intros v Hv. apply in_map_iff in Hv. destruct Hv as (i & <- & Hi).
    apply (Hl (a i) (x i)). auto. }
  destruct l' as [|i l']; [cbn in Tot'; lra|].
  (* repeat a point until there are d+1 *)
  exists (map x (i :: l') ++ repeat (x i) (Datatypes.S d - length (i :: l'))). split; [|split].
  - intros v Hv. apply in_app_or in Hv. destruct Hv as [Hv|Hv]; [auto|].
    apply repeat_spec in Hv. subst v. apply IS. now left.
  - rewrite app_length, map_length, repeat_length. lia.
  - apply (conv_incl (map x (i :: l'))); [|assumption]. intros v Hv. apply in_or_app. now left.
Qed.

(** ** Simplices or hyperplanes *)

(** All points of X are in one hyperplane. *)
Definition flat X (f : point d -> R) : Prop :=
  affine f /\ (exists p, f p <> 0) /\ forall v, In v X -> f v = 0.

Definition undone (l : list nat) := filter (fun i => if in_dec Nat.eq_dec i l then false else true)
  (seq 0 (Datatypes.S d)).
Lemma in_undone l i : In i (undone l) <-> (i <= d)%nat /\ ~ In i l.
Proof.
  unfold undone. rewrite filter_In, in_seq_d. destruct (in_dec Nat.eq_dec i l);
    intuition discriminate.
Qed.
Lemma undone_length l : (Datatypes.S d - length l <= length (undone l))%nat.
Proof.
  assert (H : (length (seq 0 (Datatypes.S d)) <= length (l ++ undone l))%nat).
  { apply NoDup_incl_length; [apply seq_NoDup|]. intros i Hi. apply in_or_app.
    destruct (in_dec Nat.eq_dec i l); [now left|right]. apply in_undone.
    split; [now apply in_seq_d|assumption]. }
  rewrite seq_length, app_length in H. lia.
Qed.

(** The points of X are put at positions that are not done yet; those of P already are. *)
Lemma frame_or_flat_from X : forall (c : frame d) (l : list nat) P,
  length l = length P -> NoDup l -> (forall i, In i l -> (i <= d)%nat) ->
  (forall v, In v P <-> exists i, In i l /\ v = vertex c i) ->
  (length P + length X = Datatypes.S d)%nat ->
  (exists t, same (P ++ X) (vertices t)) \/ exists f, flat (P ++ X) f.
Proof.
  induction X as [|x X IH]; intros c l P L N Hl HP Len.
  - left. exists c. rewrite app_nil_r. split; intros v Hv.
    + apply HP in Hv. destruct Hv as (i & Hi & ->). apply in_vertices. eauto.
    + apply in_vertices in Hv. destruct Hv as (i & Hi & ->). apply HP. exists i.
      split; [|reflexivity]. destruct (in_dec Nat.eq_dec i l) as [|Ni]; [assumption|exfalso].
      assert (H : (length (i :: l) <= length (seq 0 (Datatypes.S d)))%nat).
      { apply NoDup_incl_length; [now constructor|].
        intros k [<-|Hk]; apply in_seq_d; auto. }
      rewrite seq_length in H. cbn [length] in *. lia.
  - destruct (Exists_dec (fun i => bary c i x <> 0) (undone l)) as [E|E].
    { intros i. destruct (Req_EM_T (bary c i x) 0); [right|left]; auto. }
    + apply Exists_exists in E. destruct E as (i & Hi & Z). apply in_undone in Hi.
      destruct Hi as [Hi Ni]. destruct (cone_exists c i x Hi Z) as (c' & C).
      assert (Keep : forall k, In k l -> vertex c' k = vertex c k).
      { intros k Hk. rewrite C by auto. destruct (Nat.eq_dec k i); [congruence|reflexivity]. }
      assert (New : vertex c' i = x).
      { rewrite C by assumption. now destruct (Nat.eq_dec i i). }
      destruct (IH c' (i :: l) (P ++ [x])) as [(t & T)|(f & F)].
      * rewrite app_length. cbn. lia.
      * now constructor.
      * intros k [<-|Hk]; auto.
      * intros v. rewrite in_app_iff, HP. split.
        -- intros [(k & Hk & ->)|[<-|[]]]; [exists k|exists i; split; [now left|auto]].
           split; [now right|symmetry; auto].
        -- intros (k & [<-|Hk] & ->); [right; left; auto|left; exists k; auto].
      * rewrite app_length. cbn in *. lia.
      * left. exists t. now rewrite <- app_assoc in T.
      * right. exists f. now rewrite <- app_assoc in F.
    + right.
      assert (Zero : forall i, In i (undone l) -> bary c i x = 0).
      { intros i Hi. destruct (Req_EM_T (bary c i x) 0) as [|Z]; [assumption|exfalso].
        apply E, Exists_exists. eauto. }
      destruct (solution (map (fun v i => bary c i v) X) (undone l)) as (e & (k & Hk & Nk) & Sol).
      { apply NoDup_filter, seq_NoDup. }
      { rewrite map_length. pose proof (undone_length l). cbn [length] in Len. lia. }
      exists (fun p => sum_over (undone l) (fun i => e i * bary c i p)). split; [|split].
      * apply affine_sum. intros i Hi. apply in_undone in Hi. apply affine_scale, bary_affine.
        apply Hi.
      * exists (vertex c k). pose proof Hk as Hk'. apply in_undone in Hk'.
        rewrite (sum_one _ _ k); [rewrite bary_own by apply Hk'; lra| |assumption|].
        -- apply NoDup_filter, seq_NoDup.
        -- intros i Hi Ni. apply in_undone in Hi.
           rewrite bary_other; [ring|apply Hi|apply Hk'|assumption].
      * intros v Hv. apply in_app_or in Hv. destruct Hv as [Hv|[<-|Hv]].
        -- apply HP in Hv. destruct Hv as (j & Hj & ->). apply sum_zero. intros i Hi.
           apply in_undone in Hi. destruct Hi as [Hi Ni]. rewrite bary_other; [ring|auto|auto|].
           now intros ->.
        -- apply sum_zero. intros i Hi. rewrite Zero by assumption. ring.
        -- apply (Sol (fun i => bary c i v)). now apply (in_map (fun v i => bary c i v)).
Qed.

Theorem frame_or_flat (t0 : frame d) X : length X = Datatypes.S d ->
  (exists t, same X (vertices t)) \/ exists f, flat X f.
Proof.
  intros L. apply (frame_or_flat_from X t0 [] []); auto.
  - constructor.
  - intros i [].
  - intros v. split; [intros []|intros (i & [] & _)].
Qed.

(** A simplex is not flat. *)
Lemma frame_not_flat t f : ~ flat (vertices t) f.
Proof.
  intros (F & (p & N) & Z). apply N. rewrite (interpolation t f p F). apply sum_zero.
  intros i Hi. apply in_seq_d in Hi. rewrite Z; [ring|]. apply in_vertices. eauto.
Qed.

(** All lists of n points of S. *)
Fixpoint tuples S (n : nat) : list (list (point d)) := match n with
  | O => [[]]
  | Datatypes.S m => flat_map (fun p => map (cons p) (tuples S m)) S
  end.
Lemma in_tuples S n X : In X (tuples S n) <-> incl X S /\ length X = n.
Proof.
  revert X. induction n as [|n IH]; intros X; cbn [tuples].
  - split; [intros [<-|[]]; split; [intros v []|reflexivity]|].
    intros [_ L]. destruct X; [now left|discriminate].
  - rewrite in_flat_map. split.
    + intros (p & Hp & H). apply in_map_iff in H. destruct H as (Y & <- & H). apply IH in H.
      destruct H as [I L]. split; [now apply incl_cons|]. cbn. now rewrite L.
    + intros [I L]. destruct X as [|p Y]; [discriminate|]. exists p. split; [apply I; now left|].
      apply in_map, IH. split; [intros v Hv; apply I; now right|]. now injection L.
Qed.

(** All simplices with vertices in S, and the hyperplanes of the other (d+1)-tuples. *)
Theorem all_frames S (t0 : frame d) : exists (ts : list (frame d)) (fs : list (point d -> R)),
  (forall t, In t ts -> incl (vertices t) S) /\
  (forall f, In f fs -> affine f /\ exists p, f p <> 0) /\
  forall X, incl X S -> length X = Datatypes.S d ->
    (exists t, In t ts /\ same X (vertices t)) \/ (exists f, In f fs /\ flat X f).
Proof.
  assert (H : forall l, (forall X, In X l -> incl X S /\ length X = Datatypes.S d) ->
    exists (ts : list (frame d)) (fs : list (point d -> R)),
    (forall t, In t ts -> incl (vertices t) S) /\
    (forall f, In f fs -> affine f /\ exists p, f p <> 0) /\
    forall X, In X l ->
      (exists t, In t ts /\ same X (vertices t)) \/ (exists f, In f fs /\ flat X f)).
  { induction l as [|X l IH]; intros H.
    - exists [], []. split; [intros t []|]. split; [intros f []|intros X []].
    - destruct IH as (ts & fs & V & P & K); [intros Y HY; apply H; now right|].
      destruct (H X (or_introl eq_refl)) as [I L].
      destruct (frame_or_flat t0 X L) as [(t & [A B])|(f & F)].
      + exists (t :: ts), fs. split; [|split; [assumption|]].
        * intros t' [<-|Ht]; [now apply incl_tran with X|auto].
        * intros Y [<-|HY]; [left; exists t; split; [now left|now split]|].
          destruct (K Y HY) as [(t' & Ht & E)|E]; [|now right].
          left. exists t'. split; [now right|assumption].
      + exists ts, (f :: fs). split; [assumption|split].
        * intros g [<-|Hg]; [|auto]. destruct F as (F & N & _). auto.
        * intros Y [<-|HY]; [right; exists f; split; [now left|assumption]|].
          destruct (K Y HY) as [E|(g & Hg & E)]; [now left|].
          right. exists g. split; [now right|assumption]. }
  destruct (H (tuples S (Datatypes.S d))) as (ts & fs & V & P & K).
  - intros X. apply in_tuples.
  - exists ts, fs. split; [assumption|]. split; [assumption|]. intros X I L. apply K.
    now apply in_tuples.
Qed.
End Caratheodory.
