#!/bin/bash
# Draws the images of README.md and docs/.
#   images.sh COMMAND FOLDER
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
command=$(realpath "$1")
mkdir -p "$2"
folder=$(realpath "$2")
pages=$(mktemp -d)
trap 'rm -rf "$pages"' EXIT
cards=()  # what image.mjs is to draw, in one run: Node takes as long to start as to draw ten of them
cd "$here/../../.."

# image NAME MESH [--exaggerate]: the first violation of a mesh of the corpus, which does not hold.
image() {
  "$command" check "corpus/$2" --quiet --html "$pages/$1" && return 1
  cards+=("$pages/$1" 1 "$folder/$1.svg" "${@:3}")
}
image vertex-in-ball reject/delaunay.facet-not-local.ele
image covered-twice peers/tetgen/hunted-tetgen-covered-twice-3d.1.ele --exaggerate

# Each page of docs/rules has the image of its own example, which breaks the rule or is at fault.
mkdir -p "$folder/rules"
for rule in docs/rules/*.md; do
  grep -q '^!\[' "$rule" || continue
  read -r -a words < <(sed -n 's/^\$ circumspect //p;T;q' "$rule")
  name=$(basename "$rule" .md)
  "$command" "${words[@]}" --quiet --html "$pages/$name" 2>/dev/null && exit 1
  cards+=("$pages/$name" 1 "$folder/rules/$name.svg")
done
node "$here/image.mjs" "${cards[@]}"
