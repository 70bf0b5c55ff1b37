# glint_own_code(target): our own code is compiled with every warning, as an error where GLINT_WERROR says so.
function(glint_own_code target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion $<$<BOOL:${GLINT_WERROR}>:-Werror>)
endfunction()

# glint_few_at_a_time(target): GLINT_FILES_AT_A_TIME files are compiled as one, and what they include, and the templates that
# they share, once.
function(glint_few_at_a_time target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${GLINT_FILES_AT_A_TIME})
endfunction()

# glint_words(target file...): our own code that handles words and files: at -O0, and the headers of the libraries, which are
# most of it, read once for all such targets. It compiles in a third of the time. The files are those that speed is asked of.
function(glint_words target)
  glint_own_code(${target})
  target_compile_options(${target} PRIVATE $<$<NOT:$<CONFIG:Debug>>:-O0>)
  glint_few_at_a_time(${target})
  foreach(file IN LISTS ARGN)
    set_source_files_properties(${file} PROPERTIES COMPILE_OPTIONS $<$<CONFIG:Release>:-O2> SKIP_PRECOMPILE_HEADERS ON)
  endforeach()
  if(target STREQUAL "glint-io-command")
    target_precompile_headers(${target} PRIVATE <CLI/CLI.hpp> <fmt/format.h> <nlohmann/json.hpp> <algorithm> <filesystem>
      <fstream> <map> <memory> <set> <span> <string> <vector>)
  else()
    target_precompile_headers(${target} REUSE_FROM glint-io-command)
  endif()
endfunction()

# glint_script_test(name label timeout script argument...): a Python program beside the CMakeLists.txt; 77 skips it.
function(glint_script_test name label timeout script)
  add_test(NAME ${name} COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/${script} ${ARGN})
  set_tests_properties(${name} PROPERTIES LABELS "${label}" TIMEOUT ${timeout} SKIP_RETURN_CODE 77
    ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)
endfunction()

# glint_kernels(out): the HLS kernels of this build, `<lobe>` and `effect_<effect>`: those whose top functions are emitted.
function(glint_kernels out)
  file(GLOB emitted RELATIVE ${PROJECT_SOURCE_DIR}/hls/generated CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/hls/generated/*_p12.cpp)
  set(effects ${GLINT_EFFECTS})
  list(TRANSFORM effects PREPEND effect_)
  set(kernels "")
  foreach(kernel IN LISTS GLINT_LOBES effects)
    if(glint_${kernel}_p12.cpp IN_LIST emitted)
      list(APPEND kernels ${kernel})
    endif()
  endforeach()
  set(${out} ${kernels} PARENT_SCOPE)
endfunction()
