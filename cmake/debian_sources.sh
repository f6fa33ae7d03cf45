#!/bin/bash
# Fetches the sources of packages from this release of Debian, and unpacks each in
# FOLDER/sources/NAME:
#   cmake/debian_sources.sh FOLDER NAME…
# Nothing outside FOLDER is changed: the list of sources is one of our own, since most systems have
# no line deb-src.
set -euo pipefail
folder=$(realpath "${1:?usage: cmake/debian_sources.sh FOLDER NAME…}")
shift
mkdir -p "$folder"/{sources,apt/lists/partial,apt/archives/partial}
release=$(. /etc/os-release && echo "$VERSION_CODENAME")
printf 'deb-src http://deb.debian.org/debian %s main\n' "$release" >"$folder/apt/sources.list"
apt=(apt-get -q -o Acquire::Retries=3 -o Dir::Etc::sourcelist="$folder/apt/sources.list" -o Dir::Etc::sourceparts=-
     -o Dir::State::lists="$folder/apt/lists" -o Dir::Cache="$folder/apt" -o APT::Sandbox::User="$(id -un)")
"${apt[@]}" update
cd "$folder/sources"
"${apt[@]}" source --download-only "$@"
for description in *.dsc; do
  dpkg-source --no-check -x "$description" "$(basename "${description%%_*}")"
done
