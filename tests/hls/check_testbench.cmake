# cmake -DGLINT=.. -DTESTBENCH=.. -DLOBE=.. -DPROFILE=.. -DFOLDER=.. -P check_testbench.cmake
# The C test bench passes on the vectors of the tool, and fails on everything that it should fail on.
set(top glint_${LOBE}_${PROFILE})
set(good ${FOLDER}/${top}.tv)
set(file ${FOLDER}/${LOBE}_${PROFILE}_edited.tv)
file(REMOVE ${good} ${file})
execute_process(COMMAND ${GLINT} vectors --lobe ${LOBE} --profile ${PROFILE} --count 10000 --seed 1 --format tv -o ${FOLDER}
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
if(NOT line MATCHES "^([0-9]+ -?[0-9]+) ([0-9]+) ([01])$")
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
  expect(1 "line 5000: n = .*10000 vectors, 1 mismatches" ${top} ${file})
endforeach()

# Malformed lines, each after a good one.
foreach(bad "" "1" "1 2 3" "1 0 0 0 0" "1 0 0 2" "1 0 -1 0" "1024 0 0 0" "-1 0 0 0" "1 4294967296 0 0" "n cos_code y clamped"
    "1,0,0,0" "1 0x10 0 0" "1 0.5 0 0" "1 0 0 0 end")
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
