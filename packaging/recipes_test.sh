#!/bin/bash
# Are the recipes what their registries' tools read, and do they ask for what there is?
#   packaging/recipes_test.sh
#   packaging/recipes_test.sh --build ARCHIVE
# Ruby, Nix and PyYAML look at theirs where they are installed. With --build, the functions of
# PKGBUILD build and install from packed sources, and the Dockerfile's lines are carried out in a
# bare Debian 13 with ARCHIVE, that of `make dist`.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname "$here")
source "$here/bare_root.sh"

version=$(sed -n 's/^project(circumspect VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
sources=$work/circumspect-$version-source.tar.gz
recipes=$work/recipes
if [ "${1:-}" = --build ]; then
  git -C "$root" archive --format=tar.gz --prefix="circumspect-$version/" HEAD >"$sources"
else
  echo sources >"$sources"
fi
"$here/fill.sh" "$version" "$sources" "$recipes"
if grep -rn '@[A-Z0-9]*@' "$recipes"; then fail "expected that every recipe is filled in"; fi

quietly bash -n "$recipes/aur/PKGBUILD"
quietly python3 -c 'import ast, json, sys; json.load(open(sys.argv[1])); ast.parse(open(sys.argv[2]).read())' \
  "$recipes/vcpkg/vcpkg.json" "$recipes/conan/conanfile.py"
# vcpkg's own functions do nothing here.
cat >"$work/portfile.cmake" <<END
cmake_minimum_required(VERSION 3.25)
foreach(name download_distfile cmake_configure cmake_install cmake_config_fixup fixup_pkgconfig install_copyright)
  function(vcpkg_\${name})
  endfunction()
endforeach()
function(vcpkg_extract_source_archive variable)
  set(\${variable} "$work/nowhere" PARENT_SCOPE)
endfunction()
set(CURRENT_PACKAGES_DIR "$work/nowhere")
include("$recipes/vcpkg/portfile.cmake")
END
quietly cmake -P "$work/portfile.cmake"
if /usr/bin/python3 -c 'import yaml' 2>/dev/null; then
  quietly /usr/bin/python3 -c 'import sys, yaml; assert yaml.safe_load(open(sys.argv[1]))["package"]["version"] == sys.argv[2]' \
    "$recipes/conda/meta.yaml" "$version"
fi
if command -v ruby >/dev/null; then quietly ruby -c "$recipes/homebrew/circumspect.rb"; fi
if command -v nix-instantiate >/dev/null; then quietly nix-instantiate --parse "$recipes/nix/default.nix"; fi
# What they set and build, there is.
grep -rhoE 'CIRCUMSPECT_[A-Z_]+' "$recipes" | sort -u | while read -r name; do
  grep -q "option($name " "$root/CMakeLists.txt" || fail "expected an option $name in CMakeLists.txt, found none"
done
grep -rhoE 'circumspect_(cli|archive)' "$recipes" | sort -u | while read -r name; do
  grep -rqE "(add_executable|circumspect_add_archive)\($name " "$root/command/CMakeLists.txt" "$root/cmake/archives.cmake" ||
    fail "expected a target $name, found none"
done
if [ "${1:-}" != --build ]; then
  echo "recipes_test: the recipes can be read"
  exit 0
fi
archive=$(realpath "${2:?usage: packaging/recipes_test.sh --build ARCHIVE}")

export srcdir=$work/src pkgdir=$work/pkg
mkdir -p "$srcdir" "$pkgdir"
tar -C "$srcdir" -xzf "$sources"
quietly bash -euc 'source "$1/aur/PKGBUILD"; cd "$srcdir"; build; package' bash "$recipes"
quietly "$pkgdir/usr/bin/circumspect" check "$root/corpus/peers/tetgen/random-3d-500.1.ele"
for file in include/circumspect/circumspect.h lib/pkgconfig/circumspect-c.pc share/man/man1/circumspect-check.1 share/licenses/circumspect/LICENSE; do
  [ -f "$pkgdir/usr/$file" ] || fail "expected $file of PKGBUILD's package, found none"
done
echo "PKGBUILD builds and installs"

make_bare_root trixie
mkdir -p "$bare/opt" "$bare/work"
grep -q "^FROM debian:trixie-slim" "$recipes/Dockerfile" || fail "expected an image of Debian 13"
[ "$(basename "$archive")" = "$(sed -n 's/^ADD \([^ ]*\) .*/\1/p' "$recipes/Dockerfile")" ] || fail "expected the archive that the Dockerfile adds"
tar -C "$bare/opt" -xzf "$archive"
quietly inside "$(sed -n 's/^RUN //p' "$recipes/Dockerfile")"
cp "$root"/corpus/peers/tetgen/random-3d-500.1.* "$bare/work/"
entry=$(sed -n 's/^ENTRYPOINT \["\(.*\)"\]$/\1/p' "$recipes/Dockerfile")
quietly inside "export PATH=/usr/local/bin:\$PATH; cd /work && $entry check random-3d-500.1.ele && $entry certify random-3d-500.1.ele -o c && circumspect-verified c random-3d-500.1.node random-3d-500.1.ele"
grep -q "^verified: delaunay" "$work/log" || fail "expected a verified certificate in the image"
echo "the Dockerfile's image judges"
