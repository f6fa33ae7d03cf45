#!/bin/bash
# Packs an archive again without times, owners and modes that depend on who made it:
#   packaging/same_bytes.sh ARCHIVE.tar.gz FOLDER
# FOLDER gets an archive of the same name: the same sources make the same bytes. The only time in it
# is SOURCE_DATE_EPOCH.
set -euo pipefail
archive=${1:?usage: packaging/same_bytes.sh ARCHIVE.tar.gz FOLDER}
folder=${2:?usage: packaging/same_bytes.sh ARCHIVE.tar.gz FOLDER}
: "${SOURCE_DATE_EPOCH:?expected the time of the sources in SOURCE_DATE_EPOCH}"
unpacked=$(mktemp -d)
trap 'rm -rf "$unpacked"' EXIT
tar -C "$unpacked" -xzf "$archive"
mkdir -p "$folder"
tar -C "$unpacked" --format=gnu --owner=0 --group=0 --numeric-owner --mode=u+rwX,go=rX --sort=name \
  --mtime="@$SOURCE_DATE_EPOCH" -cf - . --transform='s|^\./||' | gzip -9n >"$folder/${archive##*/}"
