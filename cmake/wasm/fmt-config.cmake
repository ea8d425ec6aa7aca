# The headers of fmt alone: its own package is one of the machine's processor, for the library that is compiled in it.
find_path(FMT_HEADERS fmt/format.h REQUIRED)
mark_as_advanced(FMT_HEADERS)
add_library(fmt::fmt-header-only INTERFACE IMPORTED GLOBAL)
set_target_properties(fmt::fmt-header-only PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${FMT_HEADERS}
                                                      INTERFACE_COMPILE_DEFINITIONS FMT_HEADER_ONLY=1)
