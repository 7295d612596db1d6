# The tables of shortened shipped files agree with the committed ones. The
# tolerances leave room for other processors' rounding, which shocks and
# limiters enlarge, and for the round-off in what symmetry makes zero.
#
# blast_regresses(<name> <file> <tolerance> <steps> [<overrides>...])
function(blast_regresses name file tolerance steps)
  contrecoup_add_application_test(regression_${name} regression
    FILE blast/${file}.prm SET "Output/Fields=false"
    "Output/History every steps=5" "Time/Largest number of steps=${steps}"
    ${ARGN} TOLERANCE "${tolerance}" LABELS verification TIMEOUT 120)
endfunction()

blast_regresses(sod verification/sod "-r 1e-8 -a 1e-12" 60)
blast_regresses(sod_galerkin verification/sod "-r 1e-8 -a 1e-12" 60
  "Method/Scheme=discontinuous galerkin" "Method/Time stepping=ssp rk3")
blast_regresses(tnt_air verification/tnt_air "-r 1e-7 -a 1e-9" 60)
blast_regresses(point_source verification/point_source "-r 1e-7 -a 1e-9" 100
  "Adaptation/Largest level=6" "Initial state/Sedov/Radius=0.05")
blast_regresses(vortex verification/vortex "-r 1e-9 -a 1e-9" 20
  "Domain/Initial refinement=3")
blast_regresses(noh_3d verification/noh_3d "-r 1e-7 -a 1e-9" 20
  "Domain/Initial refinement=2")
# Both stages; the second begins with step 121.
blast_regresses(height_of_burst showcase/height_of_burst "-r 1e-6 -a 1e-6" 150
  "First stage/Cell size=0.005" "First stage/Hand over at=radius"
  "First stage/Radius=0.4" "Adaptation/Largest level=3")
blast_regresses(hot_ball showcase/hot_ball "-r 1e-6 -a 1e-6" 15
  "Adaptation/Largest level=2")
