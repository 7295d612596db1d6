# One rank and two agree, stopped runs continue as if without interruption, and a
# full disk harms no checkpoint. The scenes are shortened shipped files; the front
# passes the probe.
set(_hot_ball FILE blast/showcase/hot_ball.prm)
set(_short "Time/Largest number of steps=12" "Output/History every steps=1"
  "Adaptation/Largest level=2" "Adaptation/Interval=2"
  "Probes/Points=0.2, 0.1, 0.8")
set(_tables COMPARE history.csv probes.csv)

# The results of a run with maps and probes do not depend on ranks, and a stop,
# a signal, a kill, a full disk, a limit to the size of files and a checkpoint
# of another build do not change them. The momentum of a symmetric explosion is
# round-off. Maps are kept in single precision, whose last bit, 2^-23 of a value,
# follows the round-off of the gas.
set(_gauges "Output/Maps=true" "Probes/Lines=0,0,0 : 1,0,0.5 : 11"
  "Probes/Gauge planes=-0.4,-0.4,0.75 : 0.4,0.4,0.75 : 9, 9")
set(_all COMPARE history.csv probes.csv fields/*.vti fields/gauges_*.csv)
set(_near TOLERANCE 1e-10 "fields/*_maps.vti:*=1.2e-7"
  "momentum*=1e-9 absolute")
contrecoup_add_application_test(hot_ball
  regression,ranks,resume,sigterm,sigkill,disk,quota,other_build,parallel_disk
  ${_hot_ball} SET ${_short} ${_gauges} "Output/Checkpoint every steps=4"
  ${_all} ${_near} RANKS 2 3 CORES 1 STOP_AFTER 4 7)
contrecoup_add_application_test(hot_ball_on_2
  parallel_resume,parallel_sigterm,parallel_sigkill ${_hot_ball}
  SET ${_short} ${_gauges} ${_all} ${_near} STOP_AFTER 7)
contrecoup_add_application_test(hot_ball_galerkin ranks,resume ${_hot_ball}
  SET ${_short} "Method/Scheme=discontinuous galerkin" "Method/Degree=2"
  COMPARE history.csv probes.csv fields/*.vti ${_near} CORES 1 STOP_AFTER 7)
contrecoup_add_application_test(hot_ball_single
  ranks,resume,parallel_resume,parallel_sigkill ${_hot_ball}
  SET ${_short} "Method/Precision=single" ${_gauges} ${_all} RANKS 2 7 3
  TOLERANCE 1e-7 "momentum*=1e-9 absolute" STOP_AFTER 7)
# So with what the blast would do to people, whose chests move on with the run.
contrecoup_add_application_test(people regression,ranks,resume
  FILE blast/showcase/people.prm SET "Adaptation/Largest level=2"
  "Adaptation/Limit far/Largest level=2" "Time/Largest number of steps=160"
  "Output/History every steps=10" "Output/Pictures=false"
  "Probes/Points=0.5, 0.2" "Probes/Lines=0,0 : 1,0 : 11"
  "Probes/Gauge planes=0,0 : 1,0.5 : 5, 3" COMPARE history.csv probe_injury.csv
  fields/gauges_line_1.csv fields/gauges_plane_1.vti
  TOLERANCE 1e-7 "momentum*=1e-6 absolute" CORES 1 STOP_AFTER 120)
contrecoup_add_application_test(ranks_sedov_2d ranks
  FILE blast/verification/sedov_2d.prm
  SET "Time/Largest number of steps=40" TOLERANCE 1e-10)

# Meshes in 1-D live on each rank, and only the first one writes files.
contrecoup_add_application_test(fields_1d_on_two_ranks bounds
  FILE blast/verification/sod.prm MPI 2 SET "Output/Fields=true"
  "Time/Largest number of steps=10" BOUNDS "status == finished")
contrecoup_add_application_test(probes_1d ranks
  FILE blast/verification/kingery_bulmash.prm
  SET "Domain/Coarse leaves=50" "Probes/Points=0.25" "Time/End time=5e-4"
    "Output/History every steps=10" "Output/Fields=false"
  COMPARE history.csv probes.csv probe_injury.csv TOLERANCE 1e-12 RANKS 2 4
  CORES 1)

# Quiet leaves, skipped or computed, give the same results. They are skipped in
# batches, fewer where processors have more lanes: 0.77 with four numbers in
# double precision, 0.67 with eight.
foreach(_ranks 1 2)
  contrecoup_add_application_test(quiet_leaves_on_${_ranks} same ${_hot_ball}
    MPI ${_ranks} SET ${_short} "Domain/Initial refinement=2"
    "Adaptation/Smallest level=2" "Adaptation/Largest level=3"
    "Output/Checkpoint every steps=6"
    VARY "Method/Skip quiet leaves=true|false" ${_tables}
    BOUNDS "checks.skipped_updates > 0.6")
endforeach()

contrecoup_add_application_test(resume_sod resume
  FILE blast/verification/sod.prm STOP_AFTER 33)
contrecoup_add_application_test(resume_galerkin resume
  FILE blast/verification/sod.prm SET "Method/Scheme=discontinuous galerkin"
  "Method/Degree=2" STOP_AFTER 33)
contrecoup_add_application_test(resume_products resume
  FILE blast/verification/tnt_air.prm STOP_AFTER 50)

# An explosion in a closed box conserves mass and energy while its mesh adapts.
foreach(_ranks 1 2)
  contrecoup_add_application_test(conserves_on_${_ranks} bounds ${_hot_ball}
    MPI ${_ranks} SET "Boundaries/x low=wall" "Boundaries/x high=wall"
    "Boundaries/y low=wall" "Boundaries/y high=wall" "Boundaries/z high=wall"
    "Domain/Upper corner=0.3, 0.3, 1.05" "Domain/Lower corner=-0.3, -0.3, 0.45"
    "Domain/Coarse leaves=1, 1, 1" "Probes/Points="
    "Time/Largest number of steps=150" "Output/Fields=false"
    BOUNDS "conservation.mass_relative_change < 1e-12"
    "conservation.energy_relative_change < 1e-12")
endforeach()

contrecoup_add_application_test(pictures_1d pictures
  FILE blast/verification/sod.prm SET "Output/Pictures=true"
  COMPARE history.png profiles.png)
contrecoup_add_application_test(pictures_3d pictures ${_hot_ball} MPI 2 CORES 1
  SET ${_short} ${_gauges} "Output/Pictures=true" COMPARE history.png probes.png
  plane_y_0_pressure.png plane_y_0_density.png plane_y_0_pressure_lowest.png
  plane_y_0_maps.png gauges_line_1.png gauges_plane_1_maps.png)

# Readers besides ParaView, in two and three dimensions.
foreach(_file sedov_2d sedov_3d)
  contrecoup_add_application_test(vtu_${_file} foreign_reader
    FILE blast/verification/${_file}.prm
    SET "Time/Largest number of steps=2" "Output/Fields=true")
endforeach()
