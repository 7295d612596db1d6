# Errors of the shipped verification files against exact solutions. A bound is
# either required (Sod, the orders, conservation) or the error of the method
# when the test was written and a tenth more, so that no change makes it worse
# unseen. Long files are shortened, by coarser meshes.
set(_folder blast/verification)
set(_galerkin "Method/Scheme=discontinuous galerkin"
  "Method/Time stepping=ssp rk3")

# blast_verifies(<name> <file> <bounds> [<overrides>...])
function(blast_verifies name file bounds)
  contrecoup_add_application_test(${name} bounds FILE ${_folder}/${file}.prm
    SET "Output/Fields=false" ${ARGN} BOUNDS "status == finished" ${bounds}
    LABELS verification TIMEOUT 300)
endfunction()

# What leaves no wall stays to round-off.
set(_closed "conservation.mass_relative_change < 1e-12"
  "conservation.energy_relative_change < 1e-12")

blast_verifies(sod sod "errors.density_L1 < 2.4e-3;${_closed}")
blast_verifies(sod_van_leer sod "errors.density_L1 < 2.7e-3;${_closed}"
  "Method/Limiter=van leer")
blast_verifies(toro_1 toro_1 "errors.density_L1 < 3.2e-3")
blast_verifies(toro_2 toro_2 "errors.density_L1 < 3.7e-3")
blast_verifies(toro_3 toro_3 "errors.density_L1 < 7.4e-2;${_closed}")
blast_verifies(toro_4 toro_4 "errors.density_L1 < 0.29")
blast_verifies(toro_5 toro_5 "errors.density_L1 < 2.9e-2")
blast_verifies(leblanc leblanc "errors.density_L1 < 7.5e-4;${_closed}")
blast_verifies(jwl_shyue jwl_shyue "errors.density_L1 < 2.6e-2;${_closed}")
blast_verifies(tnt_air tnt_air "errors.density_L1 < 3.9;${_closed}")
blast_verifies(noh_1d noh_1d "errors.density_L1 < 9.4e-3")
blast_verifies(noh_2d noh_2d "errors.density_L1 < 2.0e-2")
blast_verifies(sedov_1d sedov_1d "errors.density_L1 < 2.7e-2;${_closed}")
blast_verifies(sedov_2d sedov_2d "errors.density_L1 < 6.0e-2;${_closed}")

# The smooth vortex shows the order of a method; in the L1 norm k + 0.8 is
# required of degree k.
foreach(_degree 1 2 3)
  math(EXPR _coarse "7 - ${_degree}")
  math(EXPR _fine "8 - ${_degree}")
  contrecoup_add_application_test(vortex_degree_${_degree} convergence
    FILE ${_folder}/vortex.prm
    SET "Output/Fields=false" "Output/History every steps=100" ${_galerkin}
    "Method/Degree=${_degree}" "Method/Blending=false" "Time/End time=2"
    VARY "Domain/Initial refinement=${_coarse}|${_fine}"
    ERROR errors.density_L1 ORDER ${_degree}.8 LABELS verification)
endforeach()
contrecoup_add_application_test(vortex_finite_volume convergence
  FILE ${_folder}/vortex.prm
  SET "Output/Fields=false" "Output/History every steps=100"
  "Method/Scheme=finite volume" "Time/End time=2"
  VARY "Domain/Initial refinement=3|4" ERROR errors.density_L1 ORDER 1.8
  LABELS verification)
