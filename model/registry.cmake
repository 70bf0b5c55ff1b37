# The registry of lobes and of effects: a name a line. CMake finds the files of each by its name, and registry.cpp has the lists
# as macros: docs/adding-a-lobe.md, docs/adding-an-effect.md.
set(GLINT_ALL_LOBES
  bps
  schlick
  cubic
  cayley
  cosine_power
  quadratic
  polynomial
  taylor
  blinn_phong
  spherical_gaussian
  gauss
  decay
)
set(GLINT_ALL_EFFECTS
  ambient
  lambert
  phong
  blinn_phong
  tint
  oren_nayar
  ward
  cook_torrance
  cook_torrance_modified
  shade
  cosine
  pixel
  lobe_select
  bps_vectors
  blinn_phong_vectors
)

# glint_registry(target lobes effects): registry.cpp in this target holds them.
function(glint_registry target lobes effects)
  list(TRANSFORM lobes REPLACE "(.+)" "GLINT_LOBE(\\1)")
  list(TRANSFORM effects REPLACE "(.+)" "GLINT_EFFECT(\\1)")
  list(JOIN lobes " " lobes)
  list(JOIN effects " " effects)
  target_compile_definitions(${target} PRIVATE "GLINT_ALL_LOBES=${lobes}" "GLINT_ALL_EFFECTS=${effects}")
endfunction()
