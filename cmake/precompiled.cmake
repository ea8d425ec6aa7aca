# orispline_precompile(TARGET HEADERS...), or with REUSE_FROM TARGET in the place of the headers: headers of others are read
# once for all sources of a target, which takes a third off a first build. Not with ccache, which keeps no such results.
option(ORISPLINE_PRECOMPILE "Precompile headers where no compiler launcher is set" ${PROJECT_IS_TOP_LEVEL})
function(orispline_precompile target)
  if(NOT ORISPLINE_PRECOMPILE OR CMAKE_CXX_COMPILER_LAUNCHER)
    return()
  endif()
  if(ARGV1 STREQUAL REUSE_FROM)
    target_precompile_headers(${target} ${ARGN})
  else()
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
