# add_subdirectory(glint) in another project: `all` starts no Verilator.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
configure(${CMAKE_CURRENT_LIST_DIR}/subdirectory -DGLINT=${GLINT})
commands(all)
if(NOT commands MATCHES "-o user " OR commands MATCHES "verilate")
  message(FATAL_ERROR "the build lacks the user's program, or Verilates:\n${commands}")
endif()
