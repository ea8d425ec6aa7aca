# orispline_embedded(SOURCE FILE HEADER FUNCTION): SOURCE, made at build time, defines FUNCTION, with its namespaces, as
# HEADER declares it: the bytes of FILE in pieces.
set(orispline_embed ${CMAKE_CURRENT_LIST_DIR}/embed_text.cmake)
function(orispline_embedded source file header function)
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DINPUT=${file} -DHEADER=${header} -DFUNCTION=${function} -DOUTPUT=${source} -P ${orispline_embed}
    DEPENDS ${file} ${orispline_embed}
    VERBATIM)
endfunction()
