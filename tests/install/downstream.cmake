# Installs BUILD into FOLDER, builds two codes against it and checks what they print.
file(REMOVE_RECURSE ${FOLDER})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${FOLDER}/prefix
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

# Builds the project of a folder of SOURCE against the installed package, runs its program and wants `expected`.
function(check_downstream folder expected)
  get_filename_component(name ${folder} NAME)
  foreach(command "-S;${SOURCE}/${folder};-B;${FOLDER}/${name};-G;${GENERATOR};-DCMAKE_PREFIX_PATH=${FOLDER}/prefix"
      "--build;${FOLDER}/${name}")
    execute_process(COMMAND ${CMAKE_COMMAND} ${command} COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  execute_process(COMMAND ${FOLDER}/${name}/${name} ${ARGN} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
  message("${printed}")
  if(NOT printed MATCHES "${expected}")
    message(FATAL_ERROR "${name}: expected ${expected}")
  endif()
endfunction()

check_downstream(examples/library_user "resultant 0.0000 0.0000")
check_downstream(tests/install/engine_user "completed 1, steps 1"
  ${SOURCE}/examples/compression/implicit.json ${FOLDER}/results)
