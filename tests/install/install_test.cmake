# Installs the build into a folder of its own, builds the consumer against it, and runs both.
file(REMOVE_RECURSE ${WORK}/prefix ${WORK}/consumer)
set(flags "")
if(SANITIZERS)
  set(flags "-DCMAKE_CXX_FLAGS=-fsanitize=address,undefined")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/consumer -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/prefix
  -DCMAKE_CXX_COMPILER=${COMPILER} ${flags} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/consumer COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/consumer/consumer OUTPUT_VARIABLE consumer COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} -E echo "50 256901" COMMAND ${WORK}/prefix/bin/glint eval --profile p12 --stdin
  OUTPUT_VARIABLE tool COMMAND_ERROR_IS_FATAL ANY)
if(NOT consumer STREQUAL "1448\n" OR NOT tool STREQUAL "1448\n")
  message(FATAL_ERROR "the consumer says '${consumer}', the installed glint '${tool}', not 1448")
endif()
# The Verilog, where the page of tools says that it is, and in the tools that are here.
foreach(file LICENSE rtl/units.json rtl/Bender.yml rtl/glint_bps_p12.core rtl/generated/glint_bps_p12_pkg.vhd cost/data/fpga.json
    docs/contract.md bench/replay/replay.py bench/replay/replay_tb.v)
  if(NOT EXISTS ${WORK}/prefix/share/glint/${file})
    message(FATAL_ERROR "the installation has no share/glint/${file}")
  endif()
endforeach()
if(PYTHON)
  execute_process(COMMAND ${PYTHON} ${CMAKE_CURRENT_LIST_DIR}/packages_test.py ${WORK}/prefix COMMAND_ERROR_IS_FATAL ANY)
endif()
