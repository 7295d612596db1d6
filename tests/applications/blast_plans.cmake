# Promises of presets, and assumptions of runs.

# Stated errors and costs of presets.
contrecoup_add_application_test(presets presets
  FILE blast/presets/height_of_burst.prm COMPARE fast balanced accurate)

# The message names a missing file and the file that includes it.
contrecoup_add_application_test(refuses_missing_include refusal
  FILE blast/verification/sod.prm CONTENT "include no_such.prm"
  MESSAGE "no_such.prm\": there is no such file")

# The plan and its audit. The run reports a domain that ends too early, and
# Domain/Size = by time corrects it.
set(_short_domain "Domain/Upper corner=2.2" "Domain/Coarse leaves=55"
  "Time/End time=0.008" "Output/Fields=false")
contrecoup_add_application_test(audit_finds_reflection bounds
  FILE blast/verification/kingery_bulmash.prm SET ${_short_domain}
  MESSAGE "WARNING: reflection" BOUNDS "assumptions.reflection.holds == False"
  "assumptions.reflection.estimate < 2.85e-3")
contrecoup_add_application_test(domain_by_time bounds
  FILE blast/verification/kingery_bulmash.prm
  SET ${_short_domain} "Domain/Size=by time"
  BOUNDS "assumptions.reflection.holds == True"
  "assumptions.reflection.measured > 8.08e-3"
  "assumptions.gravity.holds == True" "assumptions.viscosity.holds == True"
  "assumptions.quiet_leaves.measured > 0.214"
  "assumptions.equation_of_state.estimate > 0.683"
  "assumptions.equation_of_state.measured < 1e-12")
# A run that ends, or is stopped, before the blast is at the last probe.
contrecoup_add_application_test(unreached_probe bounds
  FILE blast/verification/kingery_bulmash.prm
  SET "Time/End time=7e-4" "Output/Fields=false"
  MESSAGE "not reached by a blast or its peak: probe 4, where nothing is measured"
  BOUNDS "results.probe_3_cut_off > 0.5")
contrecoup_add_application_test(unreached_probe_of_stop bounds
  FILE blast/verification/kingery_bulmash.prm
  SET "Time/Steps in this run=3" "Output/Fields=false"
  MESSAGE "not reached by a blast or its peak: all 4 probes, where nothing is measured"
  BOUNDS "status == stopped")
# With a body and a first stage in 1-D and 2-D, in single precision and without
# probes: the change of loads by a domain larger by three coarse leaves, with
# cells of 80 mm, and by the given one.
contrecoup_add_application_test(domain_by_time_body domain
  FILE blast/quickstart_human.prm SET "Rigid body/Levels=1"
  "Adaptation/Largest level=1"
  "Adaptation/Limit not at the body/Largest level=1"
  "Adaptation/Limit fireball/Largest level=0" "Adaptation/Limit far away/Largest level=0" "First stage/Cell size=0.04"
  "First stage/Levels=1" "First stage/Spherical cell size=0.004"
  "Domain/Lower corner=-0.64, 0, 0" "Domain/Upper corner=5.12, 1.92, 1.92"
  "Domain/Coarse leaves=9, 3, 3" "Probes/Points=" "Reference/Kind=none"
  "Pictures/Planes=" "Output/Fields=false" "Output/Pictures=false"
  "Time/End time=0.0032"
  BOUNDS "difference < 0.0163" "short_difference > 0.235")
contrecoup_add_application_test(audit_of_stages bounds
  FILE blast/presets/height_of_burst.prm
  SET "Adaptation/Largest level=2" "First stage/Cell size=0.004"
  BOUNDS "assumptions.first_stage.holds == True"
  "assumptions.first_stage.measured > 1.02"
  "assumptions.equation_of_state.estimate > 0.683"
  "assumptions.reflection.holds == True")
contrecoup_add_application_test(refuses_domain_by_time refusal
  FILE blast/verification/sod.prm ARGUMENTS --set "Domain/Size=by time"
  MESSAGE "Domain/Size = by time needs")
