#!/bin/bash
# Is no product of the filters contracted with a sum, which the proofs of their bounds forbid? Looks
# at object code:
#   cmake/contraction_test.sh BUILD
#   cmake/contraction_test.sh --archives OBJDUMP ARCHIVE...
# The first compiles the filters with the flags of BUILD for a processor that has such instructions,
# and also with contraction allowed, so as to see that they would be found. The second looks at what
# was compiled for another machine, such as arm64, where every processor has them.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
  echo "contraction_test: $1" >&2
  exit 1
}

# contracted OBJDUMP FILE...: how many instructions multiply and add at once: vfmadd213sd (x86),
# fmadd, fnmsub, fmla (arm64), xvmaddadp (POWER), madbr (s390x)
contracted() {
  "$1" -d --no-show-raw-insn "${@:2}" >"$work/assembly"
  grep -q '>:$' "$work/assembly" || fail "expected functions in ${*:2}, found none"
  grep -cE '^ +[0-9a-f]+:\s+(vfn?m(add|sub)[0-9]|fn?m(add|sub)\s|fml[as]\s|xsn?m(add|sub)|xvn?m(add|sub)|m[as]db?r\s)' "$work/assembly" || true
}

if [ "${1:-}" = --archives ]; then
  objdump=$2
  shift 2
  found=$(contracted "$objdump" "$@")
  [ "$found" -eq 0 ] || fail "expected no fused multiply-add in $# archives, found $found"
  echo "contraction_test: none in $# archives"
  exit 0
fi

build=$(realpath "${1:?usage: cmake/contraction_test.sh BUILD}")
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
[ "$(uname -m)" = x86_64 ] || { echo "contraction_test: skipped: it knows flags for x86-64 alone"; exit 77; }
cat >"$work/filters.cpp" <<'END'
#include "oracle/judge/fast/predicates/predicates.hpp"
using namespace circumspect::fast;
int of(const SiteRow<3>& row, const Site<3>& query, Stages& stages) {
  return orientation<3>(row, stages) + ball_of<3, true>(row).contains(query, stages);
}
END
# The flags of the layer, without those that name its own files.
flags=$(python3 - "$build/compile_commands.json" <<'PYTHON'
import json
import sys

of_filters = [one["command"] for one in json.load(open(sys.argv[1])) if "circumspect_fast_predicates.dir" in one["command"]]
words = [word for word in of_filters[0].split() if word.startswith(("-O", "-f", "-std", "-D"))]
print(" ".join(word for word in words if not word.startswith("-fuse")))
PYTHON
)
grep -q -- -ffp-contract=off <<<"$flags" || fail "expected -ffp-contract=off among the flags, found $flags"
# compiled FLAG...: how many are in the filters
compiled() {
  g++ $flags -mfma "$@" -I "$root" -c "$work/filters.cpp" -o "$work/filters.o"
  contracted objdump "$work/filters.o"
}
found=$(compiled)
[ "$found" -eq 0 ] || fail "expected no fused multiply-add in the filters, found $found"
allowed=$(compiled -ffp-contract=fast)
[ "$allowed" -gt 10 ] || fail "expected to find them where they are allowed, found $allowed"
echo "contraction_test: none in the filters, $allowed where they are allowed"
