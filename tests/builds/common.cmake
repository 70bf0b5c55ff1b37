# configure(source argument...): a fresh build of `source` in WORK/build.
function(configure source)
  file(REMOVE_RECURSE ${WORK})
  execute_process(COMMAND ${CMAKE_COMMAND} -G Ninja -S ${source} -B ${WORK}/build -DCMAKE_CXX_COMPILER=${COMPILER}
    -DCMAKE_BUILD_TYPE=Debug ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# commands(target): what a build of it would run, as `commands` of the caller.
function(commands target)
  execute_process(COMMAND ninja -C ${WORK}/build -t commands ${target} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  set(commands "${text}" PARENT_SCOPE)
endfunction()
