#!/bin/bash
# Puts the licences of everything that an artefact contains, but for its own, into a folder:
#   cmake/licences.sh archive|command|page|wheel FOLDER
# FOLDER has then one file for each library that is linked in, or whose headers are compiled in, and
# each of the licences that these files name. Debian says of each library who wrote it and under
# which licence; so the packages that the libraries come from have to be installed.
set -euo pipefail

artefact=${1:?usage: cmake/licences.sh archive|command|page|wheel FOLDER}
folder=${2:?usage: cmake/licences.sh archive|command|page|wheel FOLDER}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
documents=/usr/share/doc

# Debian's packages; the names of some have a version in them.
packages=(libgmp-dev libmpfr-dev libcgal-dev libexpected-dev libfmt-dev nlohmann-json3-dev libpugixml-dev zlib1g-dev
          'libboost[0-9]*-dev')
case $artefact in
  archive) packages+=(libzstd-dev liblzma-dev libcadical-dev libcli11-dev libc6-dev 'libstdc++-[0-9]*-dev' ocaml libzarith-ocaml-dev) ;;
  command) packages+=(libzstd-dev liblzma-dev libcadical-dev libcli11-dev libc6-dev 'libstdc++-[0-9]*-dev') ;;  # without circumspect-verified
  page) packages+=(libcadical-dev libcli11-dev emscripten) ;;
  wheel) packages+=(libcadical-dev libcli11-dev) ;;  # which the command brings along
  *) echo "cmake/licences.sh: expected archive, command, page or wheel, found $artefact" >&2; exit 2 ;;
esac

rm -rf "$folder"
mkdir -p "$folder"
for package in "${packages[@]}"; do
  file=$(compgen -G "$documents/$package/copyright" | sort -V | tail -n 1) || true
  if [ -z "$file" ]; then
    echo "cmake/licences.sh: expected the licence of a library in $documents/$package/copyright, found none:" \
         "install the package, or make this artefact on Debian" >&2
    exit 1
  fi
  name=$(basename "$(dirname "$file")")
  case $name in
    libboost*)  # 2 MB about all of Boost, whose licence asks for nothing where there are no sources
      awk 'BEGIN { RS = "" } /^License: BSL-1.0\n / { print; exit }' "$file" >"$folder/$name" ;;
    *) cp -L "$file" "$folder/$name" ;;
  esac
  [ -s "$folder/$name" ] || { echo "cmake/licences.sh: expected a licence in $file, found none" >&2; exit 1; }
done
# The page of --html is a part of the command, and has three.js in it, whose licence stands before
# it.
page=$root/oracle/picture/page/page.built.html
awk '/\/\*! With three\.js/ { found = 1; sub(/.*\/\*! /, "") } found && /^\*\// { exit } found' "$page" >"$folder/three.js"
grep -q "Permission is hereby granted" "$folder/three.js" ||
  { echo "cmake/licences.sh: expected the licence of three.js in $page, found none" >&2; exit 1; }
named=$(grep -oh '/usr/share/common-licenses/[A-Za-z0-9.-]*[A-Za-z0-9]' "$folder"/* | sort -u)
for file in $named; do
  if [ -f "$file" ]; then cp -L "$file" "$folder/"; fi
done
