#!/bin/bash
# Certifies the meshes of corpus/domains of which a claim holds, and has
# circumspect-verified read them, and compare them with the files:  proofs/domains.sh CIRCUMSPECT CIRCUMSPECT_VERIFIED
# A mesh may have no certificate: circumspect certify says so, exit code 2. None is rejected.
set -euo pipefail
circumspect=$(realpath "$1")
verified=$(realpath "$2")
cd "$(dirname "${BASH_SOURCE[0]}")/../corpus/domains"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
accepted=0
compared=0
without=0
while IFS=$'\t' read -r mesh domain claim verdict; do
  case "$claim:$verdict" in
    *" "*) continue ;;  # options of the check
    *:holds) ;;
    *) continue ;;
  esac
  # shellcheck disable=SC2086  # the domain is followed by its options
  if "$circumspect" certify "$mesh" --domain $domain --claim "$claim" --quiet \
    -o "$scratch/certificate" 2>"$scratch/why"; then
    own=()
    poly=${domain%% *}
    if [[ "$mesh $poly" == *.ele\ *.poly ]]; then own=("${mesh%.ele}.node" "$mesh" "$poly"); fi
    found=$("$verified" "$scratch/certificate" "${own[@]}") || true
    if [[ "$found" != "verified: $claim, "*"; domain: "*", plc, "* ]]; then
      echo "$mesh $domain $claim: expected 'verified: $claim' and 'plc', found '$found'" >&2
      exit 1
    fi
    accepted=$((accepted + 1))
    if [ "${#own[@]}" -gt 0 ]; then compared=$((compared + 1)); fi
  elif [ $? -eq 2 ] && grep -q 'there is no certificate of this mesh' "$scratch/why"; then
    echo "$mesh $claim: $(sed -n 's/.*there is no certificate of this mesh: //p' "$scratch/why")"
    without=$((without + 1))
  else
    echo "$mesh $domain $claim: $(cat "$scratch/why")" >&2
    exit 1
  fi
done <expected.tsv
echo "domains: $accepted certificates verified, $compared of them about files that were compared; of $without meshes there is none"
[ "$accepted" -ge 100 ] && [ "$compared" -ge 100 ]
