# The tables and fields of shortened shipped files agree with committed ones.
# The tolerances leave room for other processors' rounding, which shocks and
# limiters enlarge, and for the round-off of quantities that are zero by
# symmetry. Meshes are written in single precision.
#
# blast_regresses(<name> <file> <tolerance> <steps> COMPARE <files>
#   SET <overrides>...)
function(blast_regresses name file tolerance steps)
  cmake_parse_arguments(ARG "" "" "SET;COMPARE" ${ARGN})
  contrecoup_add_application_test(regression_${name} regression
    FILE blast/${file}.prm SET "Output/History every steps=5"
    "Time/Largest number of steps=${steps}" ${ARG_SET}
    COMPARE history.csv ${ARG_COMPARE}
    TOLERANCE ${tolerance} "fields/*.vtu:*=2e-7"
    LABELS verification)
endfunction()

set(_line COMPARE fields/fields_0001.vtu)
set(_planes COMPARE fields/plane_*.vti)
set(_resolution "Pictures/Resolution=64")
blast_regresses(sod verification/sod 1e-8 60 ${_line})
blast_regresses(sod_galerkin verification/sod 1e-8 60 ${_line}
  SET "Method/Scheme=discontinuous galerkin" "Method/Time stepping=ssp rk3")
blast_regresses(tnt_air verification/tnt_air 1e-7 60 ${_line})
blast_regresses(point_source verification/point_source 1e-7 100 ${_line}
  probes.csv SET "Adaptation/Largest level=6" "Initial state/Sedov/Radius=0.05")
blast_regresses(vortex verification/vortex "1e-9;momentum*=1e-9 absolute" 20
  ${_planes} SET "Domain/Initial refinement=3" "Pictures/Planes=all"
  ${_resolution})
blast_regresses(noh_3d verification/noh_3d 1e-7 20 ${_planes}
  SET "Domain/Initial refinement=2" "Pictures/Planes=z = 0.1" ${_resolution})
# Both stages; the second begins with step 121. The wave gets past the probe. The
# momentum along y is zero by symmetry: 3e-13 are round-off.
blast_regresses(height_of_burst showcase/height_of_burst
  "1e-6;momentum_y=1e-9 absolute" 150
  ${_planes} probes.csv SET "First stage/Cell size=0.005"
  "First stage/Hand over at=radius" "First stage/Radius=0.4"
  "Adaptation/Largest level=3" ${_resolution}
  "Probes/Points=0.3, 0.7")
