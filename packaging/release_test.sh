#!/bin/bash
# Does packaging/release.sh take what belongs to one commit, and notice where a second time differs?
#   packaging/release_test.sh
# Texts stand for what takes minutes to build.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
  echo "release_test: $1" >&2
  cat "$work/said" >&2
  exit 1
}

if [ ! -x /usr/bin/cargo ] || ! command -v dpkg-parsechangelog >/dev/null; then
  echo "release_test: without cargo and dpkg-dev, no release is collected"
  exit 0
fi
mkdir -p "$work/tree/debian"
cd "$work/tree"
cp -r "$root"/{rust,packaging,LICENSE,CMakeLists.txt,pyproject.toml} .
cp "$root/debian/changelog" debian/
version=$(sed -n 's/^project(circumspect VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
echo "## $version" >CHANGELOG.md
echo /build >.gitignore
export GIT_AUTHOR_NAME=n GIT_AUTHOR_EMAIL=e GIT_COMMITTER_NAME=n GIT_COMMITTER_EMAIL=e
git init -q && git add . && git commit -q -m one
mkdir -p build/{dist,wheel/dist,web,deb,ports/arm64}
for file in dist/circumspect-$version-linux-x86_64.tar.gz wheel/dist/circumspect-$version{-cp311-abi3-manylinux_2_34_x86_64.whl,.tar.gz} \
            web/circumspect-oracle-$version.tgz deb/circumspect_$version-1_amd64.deb \
            ports/arm64/circumspect{-$version-linux-aarch64.tar.gz,_$version-1_arm64.deb}; do
  echo "$file" >"build/$file"
done
git rev-parse --short=12 HEAD >build/ports/arm64/COMMIT

collects() { packaging/release.sh build/published >"$work/said" 2>&1; }
# refuses WORDS: and leaves what was collected
refuses() {
  if collects; then fail "expected: $1"; fi
  grep -qF "$1" "$work/said" || fail "expected: $1"
  (cd build/published && sha256sum --check --quiet SHA256SUMS) || fail "expected what was collected before"
}

collects || fail "expected a release"
[ "$(wc -l <build/published/SHA256SUMS)" = 9 ] || fail "expected nine files"
tar -xzOf "build/published/circumspect-$version.crate" "circumspect-$version/README.md" >"$work/readme"
if grep -n '](\.\./' "$work/readme"; then fail "expected links that the crate's page can follow"; fi
collects && grep -q "^the same bytes" "$work/said" || fail "expected the same bytes again"
echo other >>build/web/circumspect-oracle-$version.tgz
refuses "expected the bytes of the earlier run"
refuses "expected the bytes of the earlier run"  # and does not forget them
echo other >build/ports/arm64/COMMIT
refuses "expected what was made for arm64 of this commit"
echo >>LICENSE
refuses "expected a committed tree"
echo "release_test: what belongs to one commit is collected"
