# cmake -DGLINT=.. -DTESTBENCH=.. -DUNIT=lobe|effect -DNAME=.. -DPROFILE=.. -DFOLDER=.. -P check_testbench.cmake
# The C test bench passes on the vectors of the tool, and fails on everything that it should fail on.
set(top glint_${NAME}_${PROFILE})
if(UNIT STREQUAL "effect")
  set(top glint_effect_${NAME}_${PROFILE})
endif()
set(good ${FOLDER}/${top}.tv)
set(file ${FOLDER}/${top}_edited.tv)
file(REMOVE ${good} ${file})
execute_process(COMMAND ${GLINT} vectors --${UNIT} ${NAME} --profile ${PROFILE} --count 10000 --seed 1 --format tv -o ${FOLDER}
  COMMAND_ERROR_IS_FATAL ANY)

# expect(STATUS REGEX ARGUMENT...): the exit status, and what standard output or standard error must say.
function(expect status regex)
  execute_process(COMMAND ${TESTBENCH} ${ARGN} WORKING_DIRECTORY ${FOLDER}
    RESULT_VARIABLE got OUTPUT_VARIABLE output ERROR_VARIABLE error)
  if(NOT got STREQUAL "${status}")
    message(FATAL_ERROR "glint-hls-tb ${ARGN}: exit status ${got}, expected ${status}\n${output}${error}")
  endif()
  if(NOT "${output}${error}" MATCHES "${regex}")
    message(FATAL_ERROR "glint-hls-tb ${ARGN}: expected '${regex}' in\n${output}${error}")
  endif()
  math(EXPR count "${count} + 1")
  set(count ${count} PARENT_SCOPE)
endfunction()
set(count 0)

expect(0 "10000 vectors, 0 mismatches" ${top} ${good})
expect(0 "10000 vectors, 0 mismatches" ${top})  # the default file

# One number of line 5000 changed: y by one, then clamped.
file(STRINGS ${good} lines)
list(GET lines 4999 line)
if(NOT line MATCHES "^([-0-9 ]+) ([0-9]+) ([01])$")
  message(FATAL_ERROR "${good}:5000: '${line}' is not a vector")
endif()
set(input "${CMAKE_MATCH_1}")
math(EXPR other_y "${CMAKE_MATCH_2} ^ 1")
math(EXPR other_clamped "${CMAKE_MATCH_3} ^ 1")
foreach(edited "${input} ${other_y} ${CMAKE_MATCH_3}" "${input} ${CMAKE_MATCH_2} ${other_clamped}")
  set(changed ${lines})
  list(REMOVE_AT changed 4999)
  list(INSERT changed 4999 "${edited}")
  list(JOIN changed "\n" text)
  file(WRITE ${file} "${text}\n")
  expect(1 "line 5000: .*: got .*10000 vectors, 1 mismatches" ${top} ${file})
endforeach()

# Malformed lines, each after a good one.
set(all_bad "" "1" "1 2 3" "${line} 0" "${input} ${CMAKE_MATCH_2} 2" "n cos_code y clamped" "1,0,0,0" "${input} 0x10 0" "${input} 0.5 0"
  "${line} end" "${input} 4294967296 0")
if(UNIT STREQUAL "lobe")
  list(APPEND all_bad "65536 0 0 0" "-1 0 0 0" "1 4294967296 0 0")
endif()
foreach(bad IN LISTS all_bad)
  file(WRITE ${file} "${line}\n${bad}\n")
  expect(2 ":2: '${bad}' is not a vector" ${top} ${file})
endforeach()

file(WRITE ${file} "")
expect(1 "0 vectors, 0 mismatches.*has no vectors" ${top} ${file})
file(REMOVE ${file})
expect(2 "cannot read '.*': No such file" ${top} ${file})
expect(2 "cannot read" ${top} ${FOLDER})
expect(2 "'glint_bps_p9' is not here.*one of: glint_[a-z0-9_]+_p12" glint_bps_p9 ${good})
expect(2 "usage" ${top} ${good} ${good})
message(STATUS "${count} runs of the test bench behaved")
