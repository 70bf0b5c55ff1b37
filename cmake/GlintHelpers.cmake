# glint_own_code(target): our own code is compiled with every warning, as an error where GLINT_WERROR says so.
function(glint_own_code target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion $<$<BOOL:${GLINT_WERROR}>:-Werror>)
endfunction()

# glint_words(target): our own code that handles words and files. At -O1 it compiles in two thirds of the time.
function(glint_words target)
  glint_own_code(${target})
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# glint_registry(out file macro): the names in a registry, in its order.
function(glint_registry out file macro)
  set(registry ${PROJECT_SOURCE_DIR}/model/include/glint/${file})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${registry})
  file(STRINGS ${registry} lines REGEX "^${macro}\\([a-z0-9_]+\\)$")
  list(TRANSFORM lines REPLACE "^${macro}\\((.*)\\)$" "\\1")
  set(${out} ${lines} PARENT_SCOPE)
endfunction()

function(glint_lobes out)
  glint_registry(names lobes.def GLINT_LOBE)
  set(${out} ${names} PARENT_SCOPE)
endfunction()

function(glint_effects out)
  glint_registry(names effects.def GLINT_EFFECT)
  set(${out} ${names} PARENT_SCOPE)
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

# glint_generated_verilog(out rtl lobe profile): the folder with the wrappers of a profile. Those of the shipped profiles
# are committed; those of a custom one are emitted now, by a `glint` built for the purpose.
function(glint_generated_verilog out rtl lobe profile)
  if(NOT profile MATCHES ",")
    set(${out} ${rtl}/generated PARENT_SCOPE)
    return()
  endif()
  glint_emit_now(--lobe ${lobe} --profile ${profile})
  set(${out} ${PROJECT_BINARY_DIR}/generated PARENT_SCOPE)
endfunction()

# glint_generated_effect(out rtl effect lobe profile module): the file of the wrapper, emitted now where it is not among the
# committed ones.
function(glint_generated_effect out rtl effect lobe profile module)
  if(EXISTS ${rtl}/generated/${module}.v)
    set(${out} ${rtl}/generated/${module}.v PARENT_SCOPE)
    return()
  endif()
  # That of another lobe differs in its name alone (tests/unit/emit_test.cpp).
  string(REPLACE "," "_" name ${profile})
  set(of_bps glint_effect_${effect}_bps_${name})
  if(lobe AND EXISTS ${rtl}/generated/${of_bps}.v)
    file(READ ${rtl}/generated/${of_bps}.v text)
    string(REPLACE "_bps_" "_${lobe}_" text "${text}")
    string(REPLACE "--lobe bps " "--lobe ${lobe} " text "${text}")
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/${module}.v CONTENT "@text@" @ONLY)
    set(${out} ${PROJECT_BINARY_DIR}/generated/${module}.v PARENT_SCOPE)
    return()
  endif()
  set(choice "")
  if(lobe)
    set(choice --lobe ${lobe})
  endif()
  glint_emit_now(--effect ${effect} ${choice} --profile ${profile})
  set(${out} ${PROJECT_BINARY_DIR}/generated/${module}.v PARENT_SCOPE)
endfunction()

# glint_emit_now(arguments...): Verilog into generated/ of the build.
function(glint_emit_now)
  set(tool ${PROJECT_BINARY_DIR}/emit-tool)
  if(NOT EXISTS ${tool}/glint)
    message(STATUS "Building glint for the wrappers of custom profiles")
    execute_process(COMMAND ${CMAKE_COMMAND} -S ${PROJECT_SOURCE_DIR} -B ${tool} -DGLINT_COSIM=OFF -DGLINT_TESTS=OFF
      -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DCMAKE_BUILD_TYPE=Release OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  endif()
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${tool} --target glint-cli OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${tool}/glint emit ${ARGN} --target verilog -o ${PROJECT_BINARY_DIR}/generated
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()
