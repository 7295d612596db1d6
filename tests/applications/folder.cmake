# Output folders: files of users stay, finished runs stay until --overwrite, one run
# at a time, exit codes of signals, full disks. The solvers share their run loop and
# their output folder: blast goes through all on one, two and three ranks, the others
# through what their own results and checkpoints decide. The scenes are as small as
# possible.
set(_sod FILE blast/verification/sod.prm SET "Output/Fields=true"
  "Output/Fields interval=0.1")
set(_ball FILE blast/showcase/hot_ball.prm SET "Adaptation/Largest level=2"
  "Output/History every steps=1" "Time/Largest number of steps=12")
set(_wave FILE biomechanics/verification/plane_wave.prm)
set(_shock FILE head_impact/verification/sod.prm SET
  "Output/Checkpoint at the end=true")
set(_long_wave ARGUMENTS --set "Time/End time=1e3" --set
  "Output/Checkpoint every steps=100")
set(_long_ball ARGUMENTS --set "Time/Largest number of steps=100000" --set
  "Output/Checkpoint every steps=5" --set "Output/Fields=false")
set(_long_shock ARGUMENTS --set "Time/End time=1e3" --set
  "Output/Checkpoint every steps=20")

# Twice to the end, once more with another value, in a folder of a user.
contrecoup_add_application_test(folder_finished folder_finished ${_sod}
  ARGUMENTS "Time/End time=0.1" TIMEOUT 60)
contrecoup_add_application_test(folder_finished_on_3 folder_finished ${_ball}
  MPI 3 CORES 1 ARGUMENTS "Time/Largest number of steps=6" TIMEOUT 120)
contrecoup_add_application_test(folder_finished folder_finished
  FILE anatomy/extremes/needle.prm SET "Output/Pictures=false"
  ARGUMENTS "Output/Gmsh=true" TIMEOUT 60)

# Stopped while it draws pictures.
contrecoup_add_application_test(folder_stop_in_drawing folder_stop_in_drawing
  FILE anatomy/extremes/needle.prm TIMEOUT 60)
contrecoup_add_application_test(folder_stop_in_drawing folder_stop_in_drawing
  FILE blast/verification/sod.prm SET "Output/Pictures=true" TIMEOUT 60)

# Files of a user where results would be.
contrecoup_add_application_test(folder_foreign folder_foreign ${_sod}
  COMPARE history.csv fields/fields_0000.vtu summary.json pictures/history.png
  checkpoint/0001/run.json TIMEOUT 60)
contrecoup_add_application_test(folder_foreign folder_foreign ${_wave}
  COMPARE history.csv fields/solid_0000.vtu injury.csv TIMEOUT 60)
contrecoup_add_application_test(folder_foreign folder_foreign ${_shock}
  COMPARE history.csv fields/ale_0000.vtu checkpoint/0001/run.json TIMEOUT 60)
contrecoup_add_application_test(folder_foreign folder_foreign
  FILE anatomy/extremes/needle.prm COMPARE mesh.vtu quality.csv
  pictures/cuts.png TIMEOUT 60)
contrecoup_add_application_test(folder_foreign folder_foreign
  FILE study/quickstart.prm COMPARE study.csv pictures/work_precision.svg
  TIMEOUT 120)
contrecoup_add_application_test(folder_foreign folder_foreign
  FILE scene/verification/head.prm COMPARE scene.json report.html
  blast/history.csv anatomy/mesh.vtu blast.prm TIMEOUT 120)

# Killed before there is anything to continue from, and begun by --resume.
contrecoup_add_application_test(folder_begins folder_begins ${_ball}
  ARGUMENTS --set "Time/End time=1e3" --set "Time/Largest number of steps=1000000"
  TIMEOUT 120)
contrecoup_add_application_test(folder_begins folder_begins
  FILE study/quickstart.prm TIMEOUT 120)

# Most of the time goes to waiting for mpirun and signals.
foreach(_ranks 1 2 3)
  contrecoup_add_application_test(folder_lock_on_${_ranks} folder_lock ${_ball}
    MPI ${_ranks} CORES 1 ${_long_ball} TIMEOUT 120)
  contrecoup_add_application_test(folder_signals_on_${_ranks} folder_signals
    ${_ball} MPI ${_ranks} CORES 1 ${_long_ball} COMPARE history.csv TIMEOUT 120)
  contrecoup_add_application_test(folder_read_only_on_${_ranks} folder_read_only
    ${_ball} MPI ${_ranks} CORES 1 ${_long_ball} TIMEOUT 120)
endforeach()
contrecoup_add_application_test(folder_signals_on_2 folder_signals ${_wave}
  MPI 2 CORES 1 ${_long_wave} COMPARE history.csv TIMEOUT 120)
contrecoup_add_application_test(folder_signals_on_2 folder_signals ${_shock}
  MPI 2 CORES 1 ${_long_shock} COMPARE history.csv TIMEOUT 120)
contrecoup_add_application_test(folder_cache_on_3 folder_cache ${_ball} MPI 3
  CORES 1 TIMEOUT 600)
contrecoup_add_application_test(folder_ranks_fail folder_ranks_fail ${_ball}
  MPI 3 CORES 1 ${_long_ball} TIMEOUT 120)
contrecoup_add_application_test(folder_ranks folder_ranks ${_ball} MPI 2 CORES 1
  STOP_AFTER 6 ARGUMENTS "Method/Precision=single" TIMEOUT 120)
contrecoup_add_application_test(folder_ranks folder_ranks ${_wave} MPI 2 CORES 1
  STOP_AFTER 6 ARGUMENTS "Elements/Precision=single" TIMEOUT 120)
# head_impact has one precision; another scheme is refused as well.
contrecoup_add_application_test(folder_ranks folder_ranks ${_shock} MPI 2 CORES 1
  STOP_AFTER 6 ARGUMENTS "Scheme/Courant number=0.2" TIMEOUT 120)
contrecoup_add_application_test(folder_runs
  sigkill,disk,quota,other_build,parallel_disk,parallel_sigkill
  FILE head_impact/verification/sod.prm SET "Rezone/Kind=elastic"
  "Rezone/Interval=0.01" "Time/End time=10" "Time/Largest number of steps=60"
  "Output/Checkpoint every steps=30" "Output/History every steps=1"
  "Output/Fields=false" COMPARE history.csv probes.csv STOP_AFTER 20 RANKS 2 3
  TOLERANCE "1e-6" "energy_residual*=1e-15 absolute" TIMEOUT 300)

# Bodies: signals arrive while the cells of a fine grid are filled; a folder
# becomes read-only when it is locked and nothing is written; a disk is full.
contrecoup_add_application_test(folder_signals folder_signals
  FILE anatomy/quickstart.prm SET "Mesh/Element size=0.0025"
  "Output/Pictures=false" COMPARE lock TIMEOUT 300)
contrecoup_add_application_test(folder_read_only folder_read_only
  FILE anatomy/quickstart.prm SET "Mesh/Element size=0.01"
  "Output/Pictures=false" TIMEOUT 300)
contrecoup_add_application_test(full_disk disk_anew
  FILE anatomy/extremes/needle.prm RANKS 2 3 CORES 1 SET "Output/Pictures=false"
  "Output/Gmsh=true" COMPARE mesh.vtu mesh.msh surface.stl quality.csv
  TIMEOUT 120)

set(_head_loads FILE scene/verification/head.prm SET "Scene/Question=loads"
  "Scene/Accuracy=first look" "Scene/Cell size=0.04"
  "Scene/Forecast=false" "Scene/Report=false"
  "Anatomy/Output/Pictures=false" "Blast/Output/Fields=false")
contrecoup_add_application_test(folder_read_only_on_2 folder_read_only
  ${_head_loads} "Scene/End time=0.0005" MPI 2 CORES 1
  ARGUMENTS --set "Blast/Output/Checkpoint every steps=10" TIMEOUT 300)
contrecoup_add_application_test(folder_signals_on_2 folder_signals
  ${_head_loads} MPI 2 CORES 1
  ARGUMENTS --set "Blast/Output/Checkpoint every steps=10"
  COMPARE blast/history.csv TIMEOUT 300)
contrecoup_add_application_test(folder_signals_in_forecast
  folder_signals_in_forecast FILE scene/verification/head.prm TIMEOUT 300)
contrecoup_add_application_test(folder_cache folder_cache ${_head_loads}
  "Scene/End time=0.0005" "Scene/Report=true" COMPARE report.html TIMEOUT 300)
contrecoup_add_application_test(folder_no_report folder_no_report
  ${_head_loads} "Scene/End time=0.0005" "Scene/Report=true" TIMEOUT 300)
contrecoup_add_application_test(folder_stop_in_drawing folder_stop_in_drawing
  ${_head_loads} "Scene/End time=0.0005" "Scene/Report=true" TIMEOUT 300)
contrecoup_add_application_test(folder_default folder_default
  FILE scene/verification/head.prm TIMEOUT 300)
contrecoup_add_application_test(folder_begins folder_begins ${_head_loads}
  "Scene/End time=0.0005" "Scene/Forecast=true" TIMEOUT 300)
contrecoup_add_application_test(folder_stages folder_stages
  ${_head_loads}
  TIMEOUT 600)
