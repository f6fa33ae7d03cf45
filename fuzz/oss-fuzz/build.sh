#!/bin/bash -eu
# Builds the fuzz targets in an OSS-Fuzz or ClusterFuzzLite container: into $OUT, each with its
# seeds and its dictionary. $CXX, $CXXFLAGS and $LIB_FUZZING_ENGINE are given.
: "${SRC:?}" "${OUT:?}" "${WORK:?}"

cmake -S "$SRC/circumspect" -B "$WORK/build" -G Ninja \
  -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCIRCUMSPECT_BUILD_TESTS=OFF -DCIRCUMSPECT_BUILD_FUZZERS=ON
for source in "$SRC"/circumspect/fuzz/targets/*_fuzz.cpp; do
  target=$(basename "$source" .cpp)
  cmake --build "$WORK/build" --target "$target"
  cp "$WORK/build/fuzz/$target" "$OUT/"
  (cd "$SRC/circumspect/fuzz/targets/seeds/$target" && zip -q -r "$OUT/${target}_seed_corpus.zip" .)
  dictionary=$SRC/circumspect/fuzz/targets/$target.dict
  [ ! -f "$dictionary" ] || cp "$dictionary" "$OUT/"
done
# The libraries that the targets load, beside them: the machines that run them have none.
mkdir -p "$OUT/lib"
for target in "$OUT"/*_fuzz; do
  ldd "$target" | awk '/(gmp|mpfr|fmt|cadical|zstd|lzma)/ { print $3 }' | xargs -r cp -L -t "$OUT/lib"
  patchelf --set-rpath '$ORIGIN/lib' "$target"
done
