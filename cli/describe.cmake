# Writes what the command says of itself to man and to shells, under the names of their places: -Dcommand= -Dfolder=
file(REMOVE_RECURSE ${folder}/man ${folder}/completions)
execute_process(COMMAND ${command} help --manual-pages ${folder}/man COMMAND_ERROR_IS_FATAL ANY)
file(MAKE_DIRECTORY ${folder}/completions)
foreach(script bash:orispline zsh:_orispline fish:orispline.fish)
  string(REGEX MATCH "(.+):(.+)" script ${script})
  execute_process(COMMAND ${command} completion ${CMAKE_MATCH_1} OUTPUT_FILE ${folder}/completions/${CMAKE_MATCH_2} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
