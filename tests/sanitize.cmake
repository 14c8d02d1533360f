# Builds preset sanitize and runs its unit tests.
foreach(command "${CMAKE_COMMAND};--preset;sanitize" "${CMAKE_COMMAND};--build;--preset;sanitize"
    "${CMAKE_CTEST_COMMAND};--preset;sanitize")
  execute_process(COMMAND ${command} WORKING_DIRECTORY ${SOURCE} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
