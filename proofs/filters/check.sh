#!/bin/sh
# Proves the error bounds of the filters in oracle/judge/fast with Gappa, in a few seconds; fails if
# one is not proved, if a constant is not that of the code, or if Gappa proves what it must not.
#     proofs/filters/check.sh [--certificates|--bounds] [FOLDER-WITH-SCRIPTS [HEADER]]
# With --certificates Coq checks Gappa's proofs (needs libcoq-gappa and libcoq-flocq). With --bounds
# Gappa is asked for what it must not prove of orientations alone: of circles and spheres that takes
# as long as the proofs. Nor does it prove again what is in proved.sha256: the scripts about
# spheres, as they were when they were proved.
set -eu
mode=${1:-}
case $mode in
  --certificates|--bounds) shift ;;
  *) mode= ;;
esac
here=$(cd "$(dirname "$0")" && pwd)
scripts=${1:-$here}
header=${2:-$here/../../oracle/judge/fast/predicates/filter.hpp}
nearby=$here/../../oracle/judge/fast/predicates/nearby.hpp
intervals=$here/../../kernel/boxes/interval.hpp
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
faults=0

fault() {
  echo "filters: $1" >&2
  faults=$((faults + 1))
}

command -v gappa >/dev/null || { echo "filters: gappa not found: apt-get install gappa" >&2; exit 2; }

# Proved: exit status 0, and nothing said; for Gappa trusts a rewriting that it cannot verify, with
# a warning.
proved() {
  gappa -Eno-auto-dichotomy "$1" >"$work/log" 2>&1 && [ ! -s "$work/log" ]
}

pinned() {
  (cd "$scripts" && grep " $1\$" proved.sha256 | sha256sum --check --status)
}

# Coq takes the certificate, and it rests on nothing but the axioms of the real numbers. The last
# lemma that Gappa writes is the statement.
certified() {
  gappa -Eno-auto-dichotomy -Bcoq "$1" >"$work/certificate.v" 2>"$work/log" || return 1
  lemma=$(sed -n 's/^Lemma \(l[0-9]*\) .*/\1/p' "$work/certificate.v" | tail -n 1)
  echo "Print Assumptions $lemma." >>"$work/certificate.v"
  coqc -q "$work/certificate.v" >"$work/log" 2>&1 || return 1
  ! sed -n 's/^\([A-Za-z][A-Za-z0-9_.]*\)\( :.*\)\{0,1\}$/\1/p' "$work/log" | grep -v -x \
    -e ClassicalDedekindReals.sig_forall_dec -e ClassicalDedekindReals.sig_not_dec \
    -e FunctionalExtensionality.functional_extensionality_dep
}

# Must not be proved: what the expression of sed makes of the script.
refused() {
  sed "$3" "$1" >"$work/mutant.gappa"
  if cmp -s "$1" "$work/mutant.gappa"; then
    fault "$(basename "$1"): the mutant '$2' changes nothing"
  elif gappa -Eno-auto-dichotomy "$work/mutant.gappa" >"$work/log" 2>&1; then
    fault "$(basename "$1"): proved although $2, so the proof proves nothing"
  elif ! grep -q 'some properties were not satisfied' "$work/log"; then
    fault "$(basename "$1"): the mutant '$2' is not a script: $(head -n 1 "$work/log")"
  fi
}

# The line `inline constexpr double kNAME = VALUE;  // FILE.gappa` names each script's constant.
sed -n 's/^inline constexpr double k[A-Za-z0-9]* = \(0x[^;]*\); *\/\/ \([a-z0-9_]*\.gappa\)$/\2 \1/p' \
  "$header" "$nearby" >"$work/bounds"
listed=$(cut -d ' ' -f 1 "$work/bounds" | sort)
found=$(cd "$scripts" && ls ./*.gappa | sed 's/^\.\///' | grep -v '^outward' | sort)
[ -n "$listed" ] && [ "$listed" = "$found" ] ||
  fault "the scripts are not those that $header and $nearby name"

of_difference='-\/ \([A-Z]*\) in \[-1b-53, 1b-53\]'
while read -r file constant; do
  script=$scripts/$file
  [ -f "$script" ] || continue
  grep -q "| <= $constant\$" "$script" ||
    fault "$file: bounds $(sed -n 's/.*| <= //p' "$script") where the code says $constant"
  case $file in
    in_sphere*) pinned "$file" || fault "$file: not the one of proved.sha256: run check.sh without --bounds, then sha256sum" ;;
  esac
  case $mode$file in --boundsin_sphere*) echo "filters: $file: error at most $constant: proved before"; continue ;; esac
  if proved "$script"; then
    echo "filters: $file: error at most $constant: proved"
  else
    fault "$file: not proved: $(head -n 1 "$work/log")"
  fi
  if [ "$mode" = --certificates ]; then
    if certified "$script"; then
      echo "filters: $file: Coq takes the certificate"
    else
      fault "$file: Coq does not take the certificate: $(grep -A1 Error "$work/log" | tr "\n" " ")"
    fi
  fi
  case $mode$file in --boundsin_*) continue ;; esac
  # The bounds are rounded up by less than one in 4,000, so that 0.999 of one is too little.
  less=$(python3 -c 'import sys; print("%.6e" % (0.999 * float.fromhex(sys.argv[1])))' "$constant")
  refused "$script" "the bound is 0.999 of it" "s/| <= .*/| <= $less/"
  case $file in in_sphere*) continue ;; esac  # which take seconds each
  refused "$script" "one difference may be 2" '0,/in \[-1, 1\]/s//in [-2, 2]/'
  case $file in *_nearby.gappa)
    refused "$script" "one difference is off by 2^-29" '0,/in \[-1b-30, 1b-30\]/s//in [-1b-29, 1b-29]/'
    continue ;;
  esac
  refused "$script" "one difference has 40 bits" "0,/$of_difference/s//-\\/ \\1 in [-1b-40, 1b-40]/"
  refused "$script" "underflow adds 2^-50" '0,/in \[-1b-125, 1b-125\]/s//in [-1b-50, 1b-50]/'
  refused "$script" "products keep 52 bits" 's/ \* \([a-z0-9]*\)) in \[-1b-53, 1b-53\]/ * \1) in [-1b-52, 1b-52]/'
done <"$work/bounds"

# Intervals: one operation, whose bounds are moved outward by a part 2^-51.
script=$scripts/outward.gappa
grep -q '^inline constexpr double kOutward = 0x1p-51;$' "$intervals" && grep -q 'w -/ 1b-51 in' "$script" ||
  fault "outward.gappa: speaks of another part than $intervals"
if proved "$script"; then
  echo "filters: outward.gappa: the bounds of an interval hold the exact result: proved"
else
  fault "outward.gappa: not proved: $(head -n 1 "$work/log")"
fi
if [ "$mode" = --certificates ]; then
  certified "$script" && echo "filters: outward.gappa: Coq takes the certificate" ||
    fault "outward.gappa: Coq does not take the certificate"
fi
refused "$script" "the part is 2^-53" 's/1b-51/1b-53/'
refused "$script" "results keep 51 bits" 's/0x1.fffffffffffffp-1/0x1.ffffffffffff8p-1/; s/0x1.00000000000008p0/0x1.0000000000008p0/'

[ "$faults" -eq 0 ] || exit 1
