(** * What the tree of boxes tells: every two simplices of its leaves are parted *)
From Coq Require Import List ZArith Bool Lia Arith.
From Circumspect Require Import MeshAlone Accepted.
Import ListNotations.
Open Scope Z_scope.

Section Boxes.
Variable d : nat.

(** ** Points in boxes *)

Definition in_box (b : box) (p : list Z) : Prop := Forall2 (fun i x => fst i <= x <= snd i) b p.
Lemma in_box_length b p : in_box b p -> length b = length p.
Proof. intros F. now induction F; cbn; [|f_equal]. Qed.

Lemma around_left b c p : in_box b p -> length c = length b -> in_box (around b c) p.
Proof.
  intros F. revert c. induction F as [|(l, h) x b p I F IH]; intros [|(m, k) c] L; try discriminate;
    cbn; constructor.
  - cbn in *. destruct (Z.leb_spec l m), (Z.leb_spec h k); cbn; lia.
  - apply IH. cbn in L. lia.
Qed.
Lemma around_right b c p : in_box c p -> length b = length c -> in_box (around b c) p.
Proof.
  intros F. revert b. induction F as [|(m, k) x c p I F IH]; intros [|(l, h) b] L; try discriminate;
    cbn; constructor.
  - cbn in *. destruct (Z.leb_spec l m), (Z.leb_spec h k); cbn; lia.
  - apply IH. cbn in L. lia.
Qed.
Lemma around_length b c n : length b = n -> length c = n -> length (around b c) = n.
Proof.
  revert c n. induction b as [|(l, h) b IH]; intros [|(m, k) c] [|n] B C; try discriminate; cbn;
    auto.
Qed.

Lemma own_box_length X : Forall (fun p => length p = d) X -> X <> [] -> length (box_of X) = d.
Proof.
  induction X as [|q X IH]; intros F N; [congruence|]. apply Forall_cons_iff in F.
  destruct F as [Lq F].
  destruct X as [|q' X]; [cbn [box_of]; now rewrite map_length|].
  change (length (around (map (fun x => (x, x)) q) (box_of (q' :: X))) = d).
  apply around_length; [now rewrite map_length|apply IH; [assumption|discriminate]].
Qed.
Lemma in_own_box X p : Forall (fun p => length p = d) X -> In p X -> in_box (box_of X) p.
Proof.
  induction X as [|q X IH]; intros F I; [destruct I|]. pose proof F as F'.
  apply Forall_cons_iff in F. destruct F as [Lq F].
  assert (Own : forall q : list Z, in_box (map (fun x => (x, x)) q) q).
  { clear. induction q as [|x q IH]; cbn; constructor; [cbn; lia|assumption]. }
  destruct X as [|q' X]; [destruct I as [<-|[]]; apply Own|].
  change (in_box (around (map (fun x => (x, x)) q) (box_of (q' :: X))) p).
  assert (Lm : length (map (fun x : Z => (x, x)) q) = d) by now rewrite map_length.
  assert (Lb : length (box_of (q' :: X)) = d) by now apply own_box_length.
  destruct I as [<-|I]; [apply around_left; [apply Own|congruence]|].
  apply around_right; [now apply IH|congruence].
Qed.

(** In one coordinate all of the one box is below all of the other. *)
Definition below (i : nat) (m : Z) (X Y : list (list Z)) : Prop :=
  (i < d)%nat /\ (forall p, In p X -> nth i p 0 <= m) /\ (forall p, In p Y -> m < nth i p 0).
Lemma apart_below b c : apart b c = true -> length b = d -> length c = d ->
  exists i m, (i < d)%nat /\
  ((forall p, in_box b p -> nth i p 0 <= m) /\ (forall p, in_box c p -> m < nth i p 0) \/
   (forall p, in_box c p -> nth i p 0 <= m) /\ (forall p, in_box b p -> m < nth i p 0)).
Proof.
  intros A B C. rewrite <- B in *. clear B. revert c A C.
  induction b as [|(l, h) b IH]; intros [|(m, k) c] A C; try discriminate.
  cbn in A. apply orb_prop in A. destruct A as [A|A]; [apply orb_prop in A; destruct A as [A|A]|].
  - apply Z.ltb_lt in A. exists 0%nat, h. split; [cbn; lia|left].
    split; intros p I; inversion I; subst; cbn in *; lia.
  - apply Z.ltb_lt in A. exists 0%nat, k. split; [cbn; lia|right].
    split; intros p I; inversion I; subst; cbn in *; lia.
  - destruct (IH c A) as (i & n & Hi & H); [cbn in C; lia|]. exists (S i), n. split; [cbn; lia|].
    destruct H as [[H K]|[H K]]; [left|right]; split; intros p I; inversion I; subst; cbn; auto.
Qed.

(** ** Trees *)

Fixpoint leaf (t : tree) (a : cell) : Prop :=
  match t with Leaf _ c => c = a | Node _ l r => leaf l a \/ leaf r a end.
Definition places (a : cell) : list (list Z) := map snd (corner_places a).
(** The boxes are around what is in them. *)
Definition boxed_in (b : box) (t : tree) : Prop :=
  length b = d /\ forall a p, leaf t a -> In p (places a) -> in_box b p.
Fixpoint boxed (t : tree) : Prop :=
  boxed_in (box_around t) t /\ match t with Leaf _ _ => True | Node _ l r => boxed l /\ boxed r end.
Lemma boxed_around t : boxed t -> boxed_in (box_around t) t.
Proof. destruct t; now intros []. Qed.

Lemma joined_boxed t u : boxed t -> boxed u -> boxed (joined t u).
Proof.
  intros T U. pose proof (boxed_around t T) as [Lt It]. pose proof (boxed_around u U) as [Lu Iu].
  split; [|now split]. split; [now apply around_length|]. cbn. intros a p [A|A] I.
  - apply around_left; [eauto|congruence].
  - apply around_right; [eauto|congruence].
Qed.
Lemma pair_up_spec l : forall made, (forall t, In t made \/ In t l -> boxed t) ->
  (forall t, In t (pair_up made l) -> boxed t) /\
  forall t a, (In t made \/ In t l) -> leaf t a -> exists u, In u (pair_up made l) /\ leaf u a.
Proof.
  assert (G : forall n l, (length l <= n)%nat -> forall made, (forall t, In t made \/ In t l ->
    boxed t) ->
    (forall t, In t (pair_up made l) -> boxed t) /\
    forall t a, (In t made \/ In t l) -> leaf t a -> exists u, In u (pair_up made l) /\ leaf u a).
  2:{ exact (G (length l) l (Nat.le_refl _)). }
  clear l. induction n as [|n IH]; intros [|t [|u l]] L made B; cbn in L; try lia; cbn [pair_up].
  1, 2: split; [auto|intros t a [I|[]] F; eauto].
  - split; [intros x [<-|I]; apply B; cbn; auto|]. intros x a [I|[<-|[]]] F; [exists x|exists t];
      cbn; auto.
  - destruct (IH l ltac:(lia) (joined t u :: made)) as [B' K].
    { intros x [[<-|I]|I]; [apply joined_boxed; apply B; cbn; auto|apply B; auto|apply B; cbn;
        auto]. }
    split; [exact B'|]. intros x a [I|[<-|[<-|I]]] F.
    + apply (K x); [left; now right|assumption].
    + apply (K (joined t u)); [left; now left|now left].
    + apply (K (joined t u)); [left; now left|now right].
    + apply (K x); [now right|assumption].
Qed.
Lemma grown_spec n : forall l t, grown n l = Some t -> (forall u, In u l -> boxed u) ->
  boxed t /\ forall u a, In u l -> leaf u a -> leaf t a.
Proof.
  induction n as [|n IH]; intros [|u [|v l]] t E B; try discriminate; cbn [grown] in E.
  1, 2: injection E as <-; split; [apply B; now left|intros x a [<-|[]]; auto].
  destruct (pair_up_spec (u :: v :: l) []) as [B' K]; [intros x [[]|I]; auto|].
  destruct (IH _ t E B') as [Bt K']. split; [assumption|]. intros x a I F.
  destruct (K x a (or_intror I) F) as (y & Iy & Fy). eauto.
Qed.

(** What is known of two simplices. *)
Definition kept_apart (a b : cell) : Prop := parted d a b = true \/
  exists i m, below i m (places a) (places b) \/ below i m (places b) (places a).
Lemma apart_kept b c t u a e : boxed_in b t -> boxed_in c u -> apart b c = true -> leaf t a ->
  leaf u e -> kept_apart a e.
Proof.
  intros [Lb B] [Lc C] A Fa Fe. destruct (apart_below b c A Lb Lc) as (i & m & Hi & H). right.
  exists i, m.
  destruct H as [[H K]|[H K]]; [left|right]; split; try assumption; split; intros p I; eauto.
Qed.
Lemma parted_from_all_spec b a u : boxed_in b (Leaf b a) -> boxed u ->
  parted_from_all d b a u = Accepted ->
  forall e, leaf u e -> kept_apart a e.
Proof.
  intros B. induction u as [c x|c l IHl r IHr]; intros U E e F; cbn [parted_from_all box_around] in
    E.
  - destruct (apart b c) eqn:A.
    + apply (apart_kept b c (Leaf b a) (Leaf c x)); auto;
        [now apply (boxed_around _ U)|reflexivity].
    + unfold parted_cells in E. accepted. cbn in F. subst. now left.
  - destruct (apart b c) eqn:A.
    + apply (apart_kept b c (Leaf b a) (Node c l r)); auto;
        [now apply (boxed_around _ U)|reflexivity].
    + destruct (parted_from_all d b a l) eqn:El; [|discriminate]. destruct U as (_ & Bl & Br).
      destruct F as [F|F]; auto.
Qed.
Lemma parted_trees_spec t u : boxed t -> boxed u -> parted_trees d t u = Accepted ->
  forall a e, leaf t a -> leaf u e -> kept_apart a e.
Proof.
  induction t as [b x|b l IHl r IHr]; intros T U E a e Fa Fe; cbn [parted_trees] in E.
  - destruct (apart _ _) eqn:A.
    + apply (apart_kept (box_around (Leaf b x)) (box_around u) (Leaf b x) u a e); auto;
        now apply boxed_around.
    + cbn in Fa. subst. apply (parted_from_all_spec b a u); auto. now apply (boxed_around _ T).
  - destruct (apart _ _) eqn:A.
    + apply (apart_kept (box_around (Node b l r)) (box_around u) (Node b l r) u a e); auto;
        now apply boxed_around.
    + destruct (parted_trees d l u) eqn:El; [|discriminate]. destruct T as (_ & Bl & Br).
      destruct Fa as [Fa|Fa]; eauto.
Qed.

Theorem all_parted_spec t : boxed t -> all_parted d t = Accepted ->
  forall a e, leaf t a -> leaf t e -> a = e \/ kept_apart a e \/ kept_apart e a.
Proof.
  induction t as [b x|b l IHl r IHr]; intros T E a e Fa Fe; cbn [all_parted] in E.
  - cbn in *. left. congruence.
  - destruct (all_parted d l) eqn:El; [|discriminate].
    destruct (all_parted d r) eqn:Er; [|discriminate].
    destruct T as (_ & Bl & Br). pose proof (parted_trees_spec l r Bl Br E) as P.
    destruct Fa as [Fa|Fa], Fe as [Fe|Fe]; auto.
Qed.
End Boxes.
