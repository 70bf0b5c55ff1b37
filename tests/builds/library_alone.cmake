# Without CLI11 and nlohmann-json there is the library, and its installation, which a shared library can be made of.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
configure(${GLINT} -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON -DCMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=ON
  -DGLINT_TESTS=OFF "-DCMAKE_CXX_FLAGS_DEBUG=-O0")
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build --target glint glint-c OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${WORK}/build --prefix ${WORK}/prefix OUTPUT_QUIET
  COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${WORK}/prefix ${WORK}.prefix)
configure(${CMAKE_CURRENT_LIST_DIR}/shared -DCMAKE_PREFIX_PATH=${WORK}.prefix)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/build/user OUTPUT_VARIABLE answer COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE ${WORK}.prefix)
if(NOT answer STREQUAL "1448\n")
  message(FATAL_ERROR "the shared library says '${answer}', not 1448")
endif()
