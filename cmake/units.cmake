# orispline_units(TARGET [EXCEPT FOLDERS...]): where CMAKE_UNITY_BUILD is on, the sources of each folder are compiled as
# one unit, since reading the headers takes longer than translating the code behind them.
#
# EXCEPT: folders whose sources stay apart, such as the inner loops, which GCC inlines less in large units.
function(orispline_units target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "EXCEPT")
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    if(folder AND NOT IS_ABSOLUTE ${source} AND NOT folder IN_LIST arg_EXCEPT)
      string(MAKE_C_IDENTIFIER ${folder} unit)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${unit})
    endif()
  endforeach()
endfunction()
