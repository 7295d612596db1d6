# Runs in single precision, the default of scenes: loads on a body are the same to
# the last bit on 1, 2, 3 and 7 ranks, sums to their order, and a run on three ranks
# that is stopped or killed continues from its checkpoint.
contrecoup_add_application_test(single_body_runs
  ranks,parallel_resume,parallel_sigkill
  FILE blast/verification/body_sphere.prm
  SET "Method/Precision=single" "Domain/Initial refinement=1"
    "Time/Largest number of steps=30" "Output/Fields=false" "Pictures/Planes="
    "Output/History every steps=1" "Loads/Record=true"
    "Loads/Largest loss of peaks=1" "Initial state/Riemann/Position=-0.52"
  COMPARE history.csv probes.csv load_gauges.csv loads.h5 TOLERANCE 1e-12
  STOP_AFTER 10 RANKS 2 7 3 LABELS ranks)
# The step comes from the body's highest frequency, whose sums differ by 1e-8 with
# the order of ranks; injuries then differ by 8e-6.
contrecoup_add_application_test(single_phantom_runs ranks,parallel_sigkill
  FILE biomechanics/quickstart.prm
  SET "Elements/Precision=single" "Mesh/Element size=0.02"
    "Time/Largest number of steps=120" "Output/Fields=false"
    "Injury/Every steps=3"
  COMPARE injury.csv TOLERANCE 2e-5 STOP_AFTER 20 RANKS 2 7 3 LABELS ranks)
