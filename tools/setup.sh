#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Provides what the given groups need: tools/setup.sh [build] [test] [check] [tidy] [site] [bench] [python] [spark] [wasm] [deb]; without a group: build test.
# Installs with apt what is missing; where that is not possible it names the missing packages. With --missing before the
# groups it names them, and installs nothing.
set -eu

# The one list of packages: group, Debian's name, the command, header or module of Python that proves it is there.
# A name that ends in '?' is welcome but not needed.
packages='
build g++                c++
build ccache?            ccache
build cmake              cmake
build ninja-build        ninja
build libeigen3-dev      Eigen/Core
build libexpected-dev    tl/expected.hpp
build libfmt-dev         fmt/format.h
build libfast-float-dev  fast_float/fast_float.h
build libcli11-dev       CLI/CLI.hpp
build nlohmann-json3-dev nlohmann/json.hpp
build libmeshoptimizer-dev? meshoptimizer.h
test  libgtest-dev       gtest/gtest.h
test  librapidcheck-dev  rapidcheck.h
test  clang              clang++
test  python3            python3
test  pkg-config?        pkg-config
test  clang-format-14?   clang-format-14
test  universal-ctags?   ctags
test  nodejs?            node
test  npm?               npm
test  chromium?          chromium
test  chromium-headless-shell? chromium-headless-shell
check clang              clang++
check libclang-rt-dev?   fuzzer/FuzzedDataProvider.h
check gcovr              gcovr
tidy  clang              clang++
tidy  clang-tidy-22      run-clang-tidy-22
site  doxygen?           doxygen
python python3           python3
python python3-dev?      python3-config
python python3-venv?     import:ensurepip
spark openjdk-17-jre-headless? java
wasm  clang-22?          clang++-22
wasm  lld-22?            wasm-ld-22
wasm  llvm-22?           llvm-ar-22
wasm  libc++-22-dev-wasm32? wasm32-wasi/c++/v1/version
wasm  libclang-rt-22-dev-wasm32? ../lib/wasi/libclang_rt.builtins-wasm32.a
wasm  wasi-libc?         wasm32-wasi/stdlib.h
wasm  libsimde-dev?      simde/x86/sse2.h
wasm  nodejs?            node
deb   dpkg-dev           dpkg-buildpackage
deb   debhelper          dh
deb   fakeroot           fakeroot
deb   python3            python3
deb   lintian?           lintian
deb   man-db?            man
deb   mandoc?            mandoc
deb   abigail-tools?     abidw
bench libbenchmark-dev   benchmark/benchmark.h
bench libglm-dev         glm/glm.hpp
bench python3            python3
'
names_only=no
[ "${1:-}" != --missing ] || { names_only=yes; shift; }
groups=${*:-build test}

is_there() {
  case "$1" in import:*) python3 -c "import ${1#import:}" 2>/dev/null && return || return 1 ;; esac
  command -v "$1" >/dev/null && return
  for prefix in $(echo "${CMAKE_PREFIX_PATH:-}" | tr ':;' '  ') /usr /usr/local /opt/homebrew; do
    for place in "$prefix/include" "$prefix/include/eigen3" "$prefix"/lib/llvm-*/lib/clang/*/include; do
      [ ! -f "$place/$1" ] || return 0
    done
  done
  return 1
}

missing() {
  echo "$packages" | while read -r group package proof; do
    case " $groups " in *" $group "*) is_there "$proof" || echo "$package" ;; esac
  done
}

needed() { grep -v '?$' || true; }

can_install() { command -v apt-get >/dev/null && { [ "$(id -u)" -eq 0 ] || command -v sudo >/dev/null; }; }

apt() {
  set -- env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=600 "$@"
  [ "$(id -u)" -eq 0 ] || set -- sudo "$@"
  "$@"
}

# What apt does not know is left out, so that one name missing from a distribution does not keep the others away.
install() {
  [ -z "$(missing | needed)" ] || apt update || true
  known=$(for package in $(missing | tr -d '?'); do
    apt-cache show "$package" >/dev/null 2>&1 && echo "$package"
  done || true)
  [ -z "$known" ] || apt install -y --no-install-recommends $known || true
}

[ -n "$(missing)" ] || exit 0
[ "$names_only" = no ] || { echo $(missing | tr -d '?'); exit 0; }
if can_install; then install; fi
absent=$(missing)
[ -z "$absent" ] || echo "setup: not here (Debian's names of the packages):" $(echo "$absent" | tr -d '?') >&2
[ -z "$(echo "$absent" | needed)" ] || { echo "setup: install them, then try again" >&2; exit 1; }
