# orispline_precompile(TARGET HEADERS...), or with REUSE_FROM TARGET in the place of the headers: headers of others are read
# once for all sources of a target, which takes a third off a first build of the tests. Not with ccache, which keeps no such
# results, and not in releases: GCC 12 then warns of what its optimiser does to the standard library.
option(ORISPLINE_PRECOMPILE "Precompile headers in builds of the type Debug without a compiler launcher" ${PROJECT_IS_TOP_LEVEL})
function(orispline_precompile target)
  if(NOT ORISPLINE_PRECOMPILE OR CMAKE_CXX_COMPILER_LAUNCHER OR NOT CMAKE_BUILD_TYPE STREQUAL Debug)
    return()
  endif()
  if(ARGV1 STREQUAL REUSE_FROM)
    target_precompile_headers(${target} ${ARGN})
  else()
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
