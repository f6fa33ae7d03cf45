#!/bin/bash
# Compiles GMP and MPFR for shared libraries, which Debian's archives are not, from Debian's
# sources:
#   packaging/wheel_libraries.sh FOLDER
# FOLDER/lib has the archives and FOLDER/include the headers. GMP chooses its code when it runs, so
# that every processor will do. Nothing outside FOLDER is changed. A second call does nothing unless
# this script has changed.
set -euo pipefail
mkdir -p "${1:?usage: packaging/wheel_libraries.sh FOLDER}"
folder=$(realpath "$1")
script=$(realpath "${BASH_SOURCE[0]}")
log=$folder/libraries.log
cmp -s "$script" "$folder/.complete" && exit 0
rm -rf "${folder:?}"/{sources,include,lib,.complete}
mkdir -p "$folder"/{sources,apt/lists/partial,apt/archives/partial}
: >"$log"
trap 'status=$?; if [ $status -ne 0 ]; then tail -n 30 "$log"; echo "packaging/wheel_libraries.sh failed; $log has it all"; fi >&2' EXIT

# Debian's sources, by a list of our own: most systems have no line deb-src, and need not get one.
release=$(. /etc/os-release && echo "$VERSION_CODENAME")
printf 'deb-src http://deb.debian.org/debian %s main\n' "$release" >"$folder/apt/sources.list"
apt=(apt-get -q -o Acquire::Retries=3 -o Dir::Etc::sourcelist="$folder/apt/sources.list" -o Dir::Etc::sourceparts=-
     -o Dir::State::lists="$folder/apt/lists" -o Dir::Cache="$folder/apt" -o APT::Sandbox::User="$(id -un)")
echo "fetching the sources of GMP and MPFR from Debian"
"${apt[@]}" update >>"$log" 2>&1
(cd "$folder/sources" && "${apt[@]}" source --download-only gmp mpfr4) >>"$log" 2>&1
for description in "$folder"/sources/*.dsc; do
  name=$(basename "${description%%_*}")
  dpkg-source --no-check -x "$description" "$folder/sources/$name" >>"$log" 2>&1
done

echo "compiling GMP and MPFR"
mkdir -p "$folder/sources/gmp/doc" && touch "$folder/sources/gmp/doc/Makefile.in"  # Debian leaves the manual out
own=(--prefix="$folder" --libdir="$folder/lib" --disable-shared --enable-static --with-pic)
(cd "$folder/sources/gmp"
 parts=(SUBDIRS="mpn mpz mpq mpf printf scanf rand cxx")
 ./configure "${own[@]}" --enable-fat --enable-cxx
 make -j "${JOBS:-$(nproc)}" "${parts[@]}"
 make "${parts[@]}" install
 cd "$folder/sources/mpfr4"
 ./configure "${own[@]}" --with-gmp="$folder" --enable-thread-safe
 make -j "${JOBS:-$(nproc)}" -C src
 make -C src install) >>"$log" 2>&1
cp "$script" "$folder/.complete"
