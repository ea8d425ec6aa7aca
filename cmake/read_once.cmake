# orispline_read_once(TARGET GROUP): what nearly every source reads of Eigen and of the standard library is read once for all targets
# of a group, which have the same options. As with units, a source that forgets a header would not be noticed. GCC alone, whose files
# ccache knows; and never on behalf of a project that includes this one. Sources with options of their own read for themselves.
function(orispline_read_once target group)
  if(NOT (PROJECT_IS_TOP_LEVEL AND ORISPLINE_UNITS AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU"))
    return()
  endif()
  set_target_properties(${target} PROPERTIES PCH_WARN_INVALID OFF) # where an option differs after all, all is read as before
  set(reader orispline_read_for_${group})
  if(TARGET ${reader})
    target_precompile_headers(${target} REUSE_FROM ${reader})
    return()
  endif()
  # The options of the first of the group.
  set(file ${PROJECT_BINARY_DIR}/generated/nothing.cpp)
  file(CONFIGURE OUTPUT ${file} CONTENT "" @ONLY)
  add_library(${reader} OBJECT ${file})
  foreach(property COMPILE_OPTIONS CXX_EXTENSIONS POSITION_INDEPENDENT_CODE CXX_VISIBILITY_PRESET VISIBILITY_INLINES_HIDDEN)
    get_target_property(value ${target} ${property})
    if(NOT value STREQUAL "value-NOTFOUND")
      set_target_properties(${reader} PROPERTIES ${property} "${value}")
    endif()
  endforeach()
  target_link_libraries(${reader} PRIVATE orispline_headers orispline_fmt orispline_warnings)
  target_precompile_headers(
    ${reader} PRIVATE <Eigen/Core> <Eigen/Geometry> <algorithm> <array> <cmath> <filesystem> <functional> <limits> <map> <memory> <numbers>
                      <numeric> <optional> <set> <span> <string> <utility> <variant> <vector> <tl/expected.hpp> <orispline/base/formatted.hpp>)
  target_precompile_headers(${target} REUSE_FROM ${reader})
endfunction()
