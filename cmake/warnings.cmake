# Warnings for our own targets only; the presets turn them into errors.
add_library(orispline_warnings INTERFACE)
target_compile_options(
  orispline_warnings
  INTERFACE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall;-Wextra;-Wconversion;-Wshadow;-Wdouble-promotion>)
# GCC 12 alone sees overlaps where there are none, in `"text" + std::string` (its bug 105651).
target_compile_options(
  orispline_warnings
  INTERFACE $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,12>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>)
