#!/bin/bash
# The licences of all libraries travel with each artefact:
#   cmake/licences_test.sh COMMAND
# What COMMAND says that it is made of has a text in the archive, and all but what is not linked
# there in page and wheel.
set -euo pipefail

[ -d /usr/share/common-licenses ] || exit 77  # the texts are those that Debian has
command=${1:?usage: cmake/licences_test.sh COMMAND}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
  echo "licences_test: $1" >&2
  exit 1
}

# The library that a name in --version stands for, and a word that only its licence has.
licence_of() {
  case $1 in
    GMP) echo 'libgmp-dev GNU MP\|GMP' ;;
    MPFR) echo 'libmpfr-dev MPFR' ;;
    CGAL) echo 'libcgal-dev CGAL' ;;
    CaDiCaL) echo 'libcadical-dev Biere' ;;
    "{fmt}") echo 'libfmt-dev Zverovich' ;;
    CLI11) echo 'libcli11-dev Schreiner' ;;
    nlohmann/json) echo 'nlohmann-json3-dev Lohmann' ;;
    pugixml) echo 'libpugixml-dev Kapoulkine' ;;
    zlib) echo 'zlib1g-dev Adler' ;;
    # Page and wheel are built without these.
    zstd) [ "$artefact" != archive ] || echo 'libzstd-dev Facebook' ;;
    liblzma) [ "$artefact" != archive ] || echo 'liblzma-dev Collin' ;;
    oneTBB | "plain threads") ;;  # in no artefact: each has threads of its own, or links the user's
    *) fail "expected a library that this test knows, found $1 in --version: add its licence here and in licences.sh" ;;
  esac
}

"$command" --version | sed 's/^[^(]*(\(.*\)), commit .*/\1/; s/, /\n/g' >"$work/libraries"
[ "$(wc -l <"$work/libraries")" -ge 10 ] || fail "expected ten libraries in --version, found $(cat "$work/libraries")"
for artefact in archive page wheel; do
  "$here/licences.sh" $artefact "$work/$artefact"
  while read -r line; do
    [ "$line" = "plain threads" ] && name=$line || name=${line% *}
    licence=$(licence_of "$name")
    [ -n "$licence" ] || continue
    file=$work/$artefact/${licence%% *}
    grep -q "${licence#* }" "$file" || fail "$artefact: expected the licence of $name in ${file#"$work/"}"
  done <"$work/libraries"
  for file in 'libboost*-dev' libexpected-dev three.js GPL-3 LGPL-3; do
    compgen -G "$work/$artefact/$file" >/dev/null || fail "$artefact: expected $file"
  done
  [ $artefact != archive ] || [ -f "$work/archive/ocaml" -a -f "$work/archive/libzarith-ocaml-dev" ] || fail "expected OCaml's licences"
  grep -q "Boost Software License" "$work/$artefact"/libboost*-dev || fail "$artefact: expected the licence of Boost"
  # Every text that another refers to is there.
  grep -oh '/usr/share/common-licenses/[A-Za-z0-9.-]*[A-Za-z0-9]' "$work/$artefact"/* | sort -u | while read -r named; do
    [ ! -e "$named" ] || cmp -s "$named" "$work/$artefact/${named##*/}" || fail "$artefact: expected ${named##*/}"
  done
done
if "$here/licences.sh" sculpture "$work/none" 2>"$work/said"; then fail "expected that a sculpture is refused"; fi
grep -q "expected archive, command, page or wheel, found sculpture" "$work/said" || fail "expected to be told what there is"
echo "licences_test: archive, page and wheel have the licences of what is in them"
