# glint_own_code(target): our own code is compiled with every warning, as an error where GLINT_WERROR says so.
function(glint_own_code target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion $<$<BOOL:${GLINT_WERROR}>:-Werror>)
endfunction()
