#!/bin/bash
# Writes a version wherever one stands:
#   packaging/set_version.sh 0.2.0
# CMakeLists.txt has it, and all that is built reads it there. Cargo and what CI installs name it
# themselves (action/action_test.py holds them to CMakeLists.txt); debian/changelog gets an entry.
set -euo pipefail
version=${1:?usage: packaging/set_version.sh VERSION}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
[[ $version =~ ^[0-9]+\.[0-9]+\.[0-9]+$ ]] ||
  { echo "packaging/set_version.sh: expected a version such as 0.2.0, found '$version'" >&2; exit 2; }
sed -i "s/^project(circumspect VERSION [0-9.]*/project(circumspect VERSION $version/" CMakeLists.txt
sed -i "0,/^version = /s/^version = .*/version = \"$version\"/" rust/Cargo.toml
sed -i "s/circumspect==[0-9.]*[0-9]/circumspect==$version/" action.yml docs/gitlab-ci.yml docs/pre-commit-config.yaml
if ! head -n 1 debian/changelog | grep -qF "circumspect ($version-1)"; then
  author=$(sed -n 's/^Maintainer: //p' debian/control)
  { printf 'circumspect (%s-1) unstable; urgency=medium\n\n  * What is new is in CHANGELOG.md.\n\n -- %s  %s\n\n' \
      "$version" "$author" "$(date -R)"; cat debian/changelog; } >debian/changelog.new
  mv debian/changelog.new debian/changelog
fi
git --no-pager diff --stat
