#!/bin/bash
# What cmake/packages.sh installs on two releases of Debian, by programs that stand for Debian's.
set -euo pipefail

script=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/packages.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin"

fail() {
  echo "packages_test: $1" >&2
  exit 1
}

stand_in() {
  printf '#!/bin/bash\n%s\n' "$2" >"$work/bin/$1"
  chmod +x "$work/bin/$1"
}
# A package is installed, or known, if its name is a line of a file. apt's lists come with an
# update.
stand_in dpkg-query "grep -qxF -- \"\${@: -1}\" $work/installed && echo installed"
stand_in apt-cache "[ -f $work/updated ] && grep -qxF -- \"\$2\" $work/known && echo '  Candidate: 1.0' || echo '  Candidate: (none)'"
stand_in apt-get "case \" \$* \" in *' update '*) touch $work/updated ;; *' install '*) echo \"\$*\" >>$work/log ;; esac"
stand_in sudo 'exec "$@"'
export PATH=$work/bin:$PATH

# installs KNOWN…: what is installed for the tests where nothing is yet, and this is known beside
# the rest
installs() {
  rm -f "$work/log" "$work/updated"
  : >"$work/installed"
  printf '%s\n' doctest-dev clang "$@" >"$work/known"
  bash "$script" test >"$work/said" 2>&1 || { cat "$work/said"; fail "packages.sh failed"; }
  tr ' ' '\n' <"$work/log" >"$work/names"
}
has() { grep -qxF -- "$1" "$work/names" || fail "$2: expected $1 among $(tr '\n' ' ' <"$work/names")"; }
lacks() { ! grep -qxF -- "$1" "$work/names" || fail "$2: expected no $1"; }

installs clang-format-14 libclang-rt-14-dev libclang-rt-dev
has clang-format-14 "Debian 12"
has libclang-rt-14-dev "Debian 12"
lacks libclang-rt-dev "Debian 12"
installs libclang-rt-dev
has libclang-rt-dev "Debian 13"
lacks libclang-rt-14-dev "Debian 13"
lacks clang-format-14 "Debian 13"
has doctest-dev "Debian 13"
! grep -q '[|?]' "$work/names" || fail "expected names of packages, found $(grep '[|?]' "$work/names")"

# Where nothing is missing, or only what the release does not have, nothing is touched.
sed -n '/install$/,$p' "$work/names" | grep -v '^-' >"$work/installed"
rm -f "$work/log" "$work/updated"
bash "$script" test >"$work/said"
[ ! -e "$work/log" ] && [ ! -e "$work/updated" ] && [ ! -s "$work/said" ] || fail "expected nothing to be done, found $(cat "$work/said")"

if bash "$script" testt 2>"$work/said"; then fail "expected that testt is refused"; fi
grep -q "unknown purpose 'testt'" "$work/said" || fail "expected to be told the purposes"
echo "packages_test: what a release of Debian has is installed"
