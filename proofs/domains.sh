#!/bin/bash
# Certifies the meshes of corpus/domains, and has circumspect-verified read what proves the verdict,
# and compare it with the files:
#   proofs/domains.sh CIRCUMSPECT CIRCUMSPECT_VERIFIED
# A mesh that nothing proves (circumspect certify says so, exit code 2) is named; there is none.
set -euo pipefail
circumspect=$(realpath "$1")
verified=$(realpath "$2")
cd "$(dirname "${BASH_SOURCE[0]}")/../corpus/domains"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
accepted=0
refuted=0
rejections=0
compared=0
without=0
while IFS=$'\t' read -r mesh domain claim verdict; do
  case "$claim" in *--within*) continue ;; esac
  case "$domain" in *merge*) continue ;; esac
  code=0
  # shellcheck disable=SC2086  # the domain and the claim are followed by their options
  "$circumspect" certify "$mesh" --domain $domain --claim $claim --quiet \
    -o "$scratch/certificate" 2>"$scratch/why" || code=$?
  if [ "$code" -eq 2 ] && grep -qE 'there is no (certificate|refutation) of this mesh' "$scratch/why"; then
    echo "$mesh $claim: $(sed -nE 's/.*there is no (certificate|refutation) of this mesh: //p' "$scratch/why")"
    without=$((without + 1))
    continue
  fi
  if [ "$code" -ne "$([ "$verdict" = holds ]; echo $?)" ]; then
    echo "$mesh $domain $claim: exit code $code, $(cat "$scratch/why")" >&2
    exit 1
  fi
  own=()
  poly=${domain%% *}
  if [[ "$mesh $poly" == *.ele\ *.poly ]]; then own=("${mesh%.ele}.node" "$mesh" "$poly"); fi
  found=$("$verified" "$scratch/certificate" "${own[@]}") || true
  if [ "$verdict" = holds ]; then
    expected="verified: $claim, *; domain: *, plc, *"
    # The theorem about complexes does not speak of what dangles.
    if [[ "$(head -n 1 "$scratch/certificate")" == *" dangling"* ]]; then expected="verified: $claim, *; domain: *"; fi
    accepted=$((accepted + 1))
  else
    rule=${found#"verified: not ${claim%% *}, "}
    rule=${rule%%;*}
    # Of three simplices at a facet two are on one side of it: they overlap.
    case ",$verdict," in *,complex.facet-overused,*) verdict+=,complex.overlap ;; esac
    expected="one of the rules $verdict"
    for one in ${rule/ or / }; do
      if [[ ",$verdict," == *",$one,"* ]]; then expected="verified: not ${claim%% *}, *"; fi
    done
    refuted=$((refuted + 1))
  fi
  # shellcheck disable=SC2053  # a pattern
  if [[ "$found" != $expected ]]; then
    echo "$mesh $domain $claim: expected '$expected', found '$found'" >&2
    exit 1
  fi
  if [ "${#own[@]}" -gt 0 ]; then compared=$((compared + 1)); fi
done <expected.tsv
# No recursion is as deep as a list is long: a stack of 256 kB is enough for 16,000 simplices.
for many in "2 8000" "3 2500"; do
  dimension=${many% *}
  points=${many#* }
  "$circumspect" generate uniform --dimension "$dimension" --points "$points" -o "$scratch/many.node" --quiet
  "$circumspect" build delaunay "$scratch/many.node" -o "$scratch/many.ele" --quiet
  "$circumspect" certify "$scratch/many.ele" -o "$scratch/certificate" --quiet
  found=$(ulimit -s 256 && "$verified" "$scratch/certificate" "$scratch"/many.{node,ele}) || true
  [[ "$found" == "verified: delaunay, $points points, "* ]] || { echo "dimension $dimension: found '$found'" >&2; exit 1; }
done
# Whether the domain is a complex is asked in no more time than the mesh takes: 25,000 tetrahedra in
# 8 s of a slow processor.
cp two-rooms.poly "$scratch"
(cd "$scratch" && tetgen -pqQa0.0016 two-rooms.poly >/dev/null)
"$circumspect" certify "$scratch/two-rooms.1.ele" --domain two-rooms.poly --claim steiner-triangulation --quiet -o "$scratch/certificate"
found=$(ulimit -t 8 && "$verified" "$scratch/certificate" "$scratch"/two-rooms.1.{node,ele} two-rooms.poly) || true
[[ "$found" == "verified: steiner-triangulation, "*"domain: enclosed, plc, 12 vertices, "* ]] || { echo "many polygons: found '$found'" >&2; exit 1; }
# The teeth of a comb touch its hull in edges, which are none of the Delaunay triangulation of that
# face of the hull: what fills it has to have them all the same.
awk '{ print 2 * NF, 3, 0, 0
  for (k = 0; k < 2 * NF; ++k) { split($(k % NF + 1), p, ","); print k, p[1], p[2], k < NF ? 0 : 8 }
  print NF + 2, 0
  for (z = 0; z < 2; ++z) { printf "1 0\n%d", NF; for (k = 0; k < NF; ++k) printf " %d", k + z * NF; print "" }
  for (k = 0; k < NF; ++k) print "1 0\n" 4, k, (k + 1) % NF, (k + 1) % NF + NF, k + NF
  print "0\n0" }' <<<'0,0 20,0 20,10 18,5 16,10 14,6 12,10 10,5 8,10 6,5 4,10 2,6 0,10' >"$scratch/comb.poly"
(cd "$scratch" && tetgen -pqQ comb.poly >/dev/null)
"$circumspect" certify "$scratch/comb.1.ele" --domain "$scratch/comb.poly" --claim steiner-triangulation --quiet -o "$scratch/certificate"
found=$("$verified" "$scratch/certificate" "$scratch"/comb.1.{node,ele} "$scratch/comb.poly") || true
[[ "$found" == "verified: steiner-triangulation, "*"domain: enclosed, plc, 26 vertices, "* ]] || { echo "a comb: found '$found'" >&2; exit 1; }
# What is around a mesh may have points that are nobody's. They are none of the mesh, and its own
# are not these.
own=(accept/one-triangle-in-space.{node,ele,poly})
"$circumspect" certify "${own[1]}" --domain "${own[2]}" --domain-kind enclosed --claim plc-triangulation --quiet \
  -o "$scratch/certificate"
grep -q ' -$' <(sed -n '/^points/,/^simplices/p' "$scratch/certificate")
for mutant in 's/^$//=verified: plc-triangulation, 3 points, *' \
  '1,/^simplices/s/ -$/ 99/=rejected: another mesh, *: expected 4 points, found 3' \
  '1,/^simplices/s/ 2$/ -/=rejected: another mesh, *: found point 2, which the certificate does not list'; do
  sed "${mutant%%=*}" "$scratch/certificate" >"$scratch/mutant"
  found=$("$verified" "$scratch/mutant" "${own[@]}") || true
  # shellcheck disable=SC2053  # a pattern
  [[ "$found" == ${mutant#*=} ]] || { echo "one triangle with ${mutant%%=*}: expected '${mutant#*=}', found '$found'" >&2; exit 1; }
done
# Triangles in space without a tetrahedron dangle, also where they stand in MESH.ele.
printf '4 3\n0 0 0 0\n1 3 0 0\n2 0 3 0\n3 0 0 3\n' >"$scratch/open.node"
printf '1 3\n0 0 1 2\n' >"$scratch/open.ele"
printf '0 3\n2\n1\n3 0 1 2\n1\n3 0 1 3\n0\n' >"$scratch/open.poly"
"$circumspect" certify "$scratch/open.ele" --domain "$scratch/open.poly" --claim cdt --fill enclosed --quiet \
  -o "$scratch/certificate" || [ $? -eq 1 ]
for mesh in "verified: not cdt, domain.segment-missing; 1 dangling face; *:0 1 2" "rejected: another mesh, *open.ele:0: *:0 1 3"; do
  printf '1 3\n0 %s\n' "${mesh##*:}" >"$scratch/open.ele"
  found=$("$verified" "$scratch/certificate" "$scratch"/open.{node,ele,poly}) || true
  # shellcheck disable=SC2053  # a pattern
  [[ "$found" == ${mesh%:*} ]] || { echo "triangles in space: expected '${mesh%:*}', found '$found'" >&2; exit 1; }
done
# Domains without a triangulation or a CDT, and what does not show it: a piece or a point elsewhere,
# a candidate that is said to be free, another vertex, planes left out, the other claim.
for none in triangulation:figure-4-10-schonhardt triangulation:exercise-5-5-closed \
  triangulation:figure-4-12-three-segments CDT:figure-4-15-encircled-segment CDT:schonhardt-with-centre CDT:two-triangles; do
  domain=${none#*:}
  what=${none%%:*}
  "$circumspect" inspect "$domain.poly" --refutations "$scratch/$domain" --quiet
  proof="$scratch/$domain-${what,,}.proof"
  found=$("$verified" "$proof" "$domain.poly") || true
  if [[ "$found" != "verified: no $what without Steiner points; domain: enclosed, "* ]]; then
    echo "$domain: found '$found'" >&2
    exit 1
  fi
  rejected() {  # what is expected, and a line of sed
    sed "$2" "$proof" >"$scratch/mutant"
    if cmp -s "$proof" "$scratch/mutant"; then return; fi
    found=$("$verified" "$scratch/mutant") || true
    if [[ "$found" != "rejected: $1"* ]]; then
      echo "$domain with $2: expected 'rejected: $1', found '$found'" >&2
      exit 1
    fi
    rejections=$((rejections + 1))
  }
  rejected fate-shown 's/^piece \([0-9]*\) 1 /piece \1 2 /'
  rejected fate-shown 's/^piece \([0-9]*\) /piece 1\1 /'
  rejected fate-shown 's/^\(piece .*\) \([0-9]*\)$/\1 1\2/'
  rejected clauses-refuted '/^segment [0-9]* [-0-9]* [-0-9]* [-0-9]* [0-9]*$/s/.*/free/'
  rejected fate-shown '1s/ cdt / plc-triangulation /'
  rejected fate-shown 's/^sees [0-9]*/sees 99/'
  rejected fate-shown 's/^\(sees [0-9]*\) [-0-9]* /\1 9999999 /'
  rejected fate-shown 's/^\(sees\( [-0-9]*\)\{5\}\) .*/\1/'
done
[ "$rejections" -ge 15 ]
echo "domains: $accepted certificates and $refuted refutations verified, $compared of them about files that were compared; \
of $without meshes there is none"
[ "$accepted" -ge 165 ] && [ "$refuted" -ge 80 ] && [ "$compared" -ge 227 ] && [ "$without" -eq 0 ]
