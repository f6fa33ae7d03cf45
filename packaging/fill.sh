#!/bin/bash
# Writes the recipes for a release, with its version and the checksums of its sources:
#   packaging/fill.sh VERSION SOURCES.tar.gz FOLDER
set -euo pipefail
version=${1:?usage: packaging/fill.sh VERSION SOURCES.tar.gz FOLDER}
sources=${2:?usage: packaging/fill.sh VERSION SOURCES.tar.gz FOLDER}
folder=${3:?usage: packaging/fill.sh VERSION SOURCES.tar.gz FOLDER}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
sum256=$(sha256sum <"$sources" | cut -d' ' -f1)
sum512=$(sha512sum <"$sources" | cut -d' ' -f1)
mkdir -p "$folder"
cp -r "$here/recipes/." "$folder/"
find "$folder" -type f -exec sed -i "s/@VERSION@/$version/g; s/@SHA256@/$sum256/g; s/@SHA512@/$sum512/g" {} +
