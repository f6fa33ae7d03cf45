#!/bin/bash
# Collects what a release consists of, which the make targets before it have built:
#   packaging/release.sh FOLDER
# FOLDER gets the sources, the archives, the wheels, the packages for npm and Cargo and the Debian
# packages, of arm64 too if `make ports` has made them, with SHA256SUMS, and the recipes. The same
# commit makes the same bytes: where SHA256SUMS of an earlier run is there, whatever differs from it
# is a failure, and FOLDER stays as it was.
set -euo pipefail
folder=${1:?usage: packaging/release.sh FOLDER}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

fail() {
  echo "packaging/release.sh: $1" >&2
  exit 1
}

# Packed beside the tree, with the licence, and with links that its page can follow; the
# dependencies are Debian's, as in rust/test.sh.
crate_of_rust() {
  local copy=build/rust/crate
  rm -rf "$copy" && mkdir -p "$copy/.cargo"
  cp -r rust/. LICENSE "$copy/"
  sed -i "s|](\.\./|]($source/blob/v$version/|g" "$copy/README.md"
  printf '[source.crates-io]\nreplace-with = "debian"\n[source.debian]\ndirectory = "/usr/share/cargo/registry"\n' >"$copy/.cargo/config.toml"
  (cd "$copy" && CARGO_HOME=$root/build/rust/cargo CARGO_TARGET_DIR=$root/build/rust/target \
    /usr/bin/cargo package --quiet --no-verify --offline --allow-dirty)
}

source=$(sed -n 's/^Source = "\(.*\)"$/\1/p' pyproject.toml)
version=$(sed -n 's/^project(circumspect VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
[ -z "$(git status --porcelain)" ] || fail "expected a committed tree, found changes: a release is made of a commit"
grep -q "^## $version" CHANGELOG.md || fail "expected a heading '## $version' in CHANGELOG.md, found none"
[ "$(dpkg-parsechangelog -S Version)" = "$version-1" ] || fail "expected an entry for $version-1 in debian/changelog, found none"
commit=$(git rev-parse HEAD)
export SOURCE_DATE_EPOCH
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)

collected=$(mktemp -d)
trap 'rm -rf "$collected"' EXIT
git archive --format=tar --prefix="circumspect-$version/" HEAD | gzip -9n >"$collected/circumspect-$version-source.tar.gz"
crate_of_rust
for made in "build/dist/circumspect-$version-linux-*.tar.gz" "build/wheel/dist/circumspect-$version*.whl" "build/wheel/dist/circumspect-$version.tar.gz" \
            "build/web/circumspect-oracle-$version.tgz" "build/rust/target/package/circumspect-$version.crate" "build/deb/*_$version-1_*.deb"; do
  compgen -G "$made" >/dev/null || fail "expected $made, found none: \`make release\` builds all"
  # shellcheck disable=SC2086  # the names, each a word
  cp $made "$collected/"
done
if [ -d build/ports/arm64 ]; then
  [ "$(cat build/ports/arm64/COMMIT 2>/dev/null)" = "$(git rev-parse --short=12 HEAD)" ] ||
    fail "expected what was made for arm64 of this commit, found another's in build/ports/arm64: \`make ports\` makes it, or remove it"
  cp build/ports/arm64/*.{deb,tar.gz} "$collected/"
fi
(cd "$collected" && sha256sum -- *.* >SHA256SUMS)
packaging/fill.sh "$version" "$collected/circumspect-$version-source.tar.gz" "$collected/recipes"
echo "$commit" >"$collected/COMMIT"
if [ "$(cat "$folder/COMMIT" 2>/dev/null)" = "$commit" ]; then
  diff "$folder/SHA256SUMS" "$collected/SHA256SUMS" || fail "expected the bytes of the earlier run of this commit, found others"
  echo "the same bytes as the earlier run"
fi
mkdir -p "$folder"
rm -rf "${folder:?}"/*
cp -r "$collected"/. "$folder/"
cat "$folder/SHA256SUMS"
