#!/bin/bash -eu
# SPDX-License-Identifier: Apache-2.0
# What OSS-Fuzz runs in its image: builds the targets with its engine, with the seeds, options and dictionary beside them.
for library in eigen expected fmt fast_float CLI11 json; do
  cmake -S "$SRC/$library" -B "$WORK/$library" -GNinja -DCMAKE_INSTALL_PREFIX="$WORK/installed" -DBUILD_TESTING=OFF \
    -DEXPECTED_BUILD_TESTS=OFF -DEXPECTED_BUILD_PACKAGE=OFF -DFMT_TEST=OFF -DFMT_DOC=OFF -DCLI11_BUILD_TESTS=OFF \
    -DCLI11_BUILD_EXAMPLES=OFF -DJSON_BuildTests=OFF
  cmake --build "$WORK/$library" --target install
done
cmake -S . -B "$WORK/build" -GNinja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-g1 -DCMAKE_PREFIX_PATH="$WORK/installed" \
  -DORISPLINE_TESTS=OFF -DORISPLINE_FUZZ_ENGINE="$LIB_FUZZING_ENGINE"
cmake --build "$WORK/build"
for program in "$WORK"/build/tests/fuzz/fuzz_*; do
  target=$(basename "$program")
  [ -f "tests/fuzz/oss-fuzz/$target.options" ] || continue
  cp "$program" "tests/fuzz/oss-fuzz/$target.options" "$OUT/"
  zip -qj "$OUT/${target}_seed_corpus.zip" tests/fuzz/corpus/"$target"/*
done
cp tests/fuzz/orispline.dict "$OUT/"
