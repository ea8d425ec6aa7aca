# Commits what a user builds into a repository of its own: -Dsource= -Drepository=
file(REMOVE_RECURSE ${repository})
foreach(part CMakeLists.txt LICENSE NOTICE THIRD_PARTY cmake src)
  file(COPY ${source}/${part} DESTINATION ${repository})
endforeach()
set(git git -C ${repository} -c user.name=tests -c user.email=tests@example.org)
execute_process(COMMAND ${git} init --quiet --initial-branch=main COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${git} add . COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${git} commit --quiet --message "What is to be fetched" COMMAND_ERROR_IS_FATAL ANY)
