# Compiles for WebAssembly with its system interface, WASI, by Clang and the packages of the group `wasm` in tools/setup.sh.
#
# The same bits as elsewhere: Eigen takes its code for SSE 2, whose instructions SIMDe puts into those of WebAssembly. So
# Clang calls itself a GCC that Eigen knows to have them.
set(CMAKE_SYSTEM_NAME WASI)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR}) # Platform/WASI.cmake, for CMake older than 3.31
set(CMAKE_CXX_COMPILER clang++-22)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_AR llvm-ar-22)
set(CMAKE_RANLIB llvm-ranlib-22)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(fmt_DIR ${CMAKE_CURRENT_LIST_DIR}) # fmt-config.cmake
string(JOIN " " CMAKE_CXX_FLAGS_INIT
  -Wno-deprecated # Debian has no newer name of the target
  -msimd128 -fno-exceptions -ffp-contract=off -D__SSE__ -D__SSE2__ -fgnuc-version=5.99 -isystem ${CMAKE_CURRENT_LIST_DIR}/intrinsics)
set(CMAKE_EXE_LINKER_FLAGS_INIT --no-wasm-opt) # so that the same sources are the same program wherever it is linked
