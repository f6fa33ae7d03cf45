(** * What the main theorems rest on: the output is compared with assumptions.expected *)
From Circumspect Require Import MainTheorems BookTheorems.

(* Everything that MainTheorems.v and BookTheorems.v state, in one term: so its assumptions are
   those of all. *)
Definition beside {A} (_ : A) (_ : unit) : unit := tt.
Infix "&" := beside (at level 60, right associativity).
Definition everything : unit :=
  @verified & @verified_packed & @verified_not & @verified_rule & @verified_domain &
  @verified_dangling & @verified_complex & @verified_not_domain & @verified_domain_rule &
  @verified_not_whole_domain & @verified_whole_domain_rule & @rules_of_points &
  @rules_of_domains & @rules_of_whole_domains & @verified_impossible & @verified_unique &
  @verified_canonical & @verified_generic & @verified_any_order & @verified_mesh_alone &
  @verified_some_unused &
  @verified_not_complex & @rules_of_complexes & @verified_hull & @verified_not_hull &
  @rules_of_hulls & @verified_flat & @verified_line & @verified_not_flat & @rules_of_flats &
  @verified_surface & @verified_not_surface & @verified_periodic & @verified_not_periodic &
  @rules_of_periodic & @built_delaunay & @built_always & @verified_complete &
  @certificate_exists & @lifting_lemma & @delaunay_lemma & @proposition_4_2 & @proposition_4_3 &
  @theorem_4_4 & @canonical & @canonical_once & @perturbation_sound & @one_interpolation_error &
  @proposition_4_5 & @proposition_4_5_heights & @proposition_4_5_norms &
  @one_min_containment_ball & @proposition_4_6 & @proposition_4_7 & @constrained_delaunay_lemma &
  @proposition_4_11_at_edges & @proposition_4_12 & @proposition_4_13 & @proposition_4_13_balls &
  @conv_halfspaces & tt.
Print Assumptions everything.
