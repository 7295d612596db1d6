# Meshes of any hexahedra and quadrilaterals, from generators and files.
set(_vortex blast/verification/mapped_vortex.prm)
set(_ball blast/verification/mapped_ball.prm)
set(_ring blast/verification/curved_ring.prm)
set(_shell "Domain/Dimension=3" "Time/End time=0.3"
  "Domain/Generator arguments=0, 0, 0 : 1 : 2 : 6 : false"
  "Initial state/Expression/Density=(1+0.018*(x^2+y^2))^2.5"
  "Initial state/Expression/Pressure=(1+0.018*(x^2+y^2))^3.5/1.4"
  "Initial state/Expression/Velocity x=-0.3*y"
  "Initial state/Expression/Velocity y=0.3*x")
set(_meshes ${PROJECT_SOURCE_DIR}/parameter_files/blast/meshes)
set(_galerkin "Method/Scheme=discontinuous galerkin"
  "Method/Time stepping=ssp rk3")
set(_brief "Output/Fields=false" "Output/History every steps=100")
set(_steps_20 "Time/Largest number of steps=20" "Output/History every steps=1")
set(_small "Domain/Initial refinement=1" ${_steps_20})
# Finer leaves, which hang on their neighbours.
set(_band "Adaptation/Fine box levels=1"
  "Adaptation/Fine box lower corner=-5, -1.25"
  "Adaptation/Fine box upper corner=5, 1.25")
set(_octant "Adaptation/Fine box levels=1"
  "Adaptation/Fine box lower corner=-0.2, -0.2, -0.2"
  "Adaptation/Fine box upper corner=1, 1, 1"
  "Domain/Generator arguments=0, 0, 0 : 1 : false")
set(_uniform "Initial state/Kind=uniform" "Reference/Kind=initial"
  "Boundaries/By id=0: initial" "Initial state/Background/Density=1.4"
  "Initial state/Background/Pressure=1" "Output/Fields=false"
  "Time/Largest number of steps=20")
set(_unchanged "status == finished" "errors.density_Linf < 1e-12"
  "errors.velocity_Linf < 1e-12" "errors.pressure_Linf < 1e-12")

contrecoup_add_application_test(mapped_vortex convergence FILE ${_vortex}
  SET ${_brief} "Time/End time=2" VARY "Domain/Initial refinement=1|2"
  ERROR errors.density_L1 ORDER 1.8 LABELS verification)
contrecoup_add_application_test(mapped_vortex_hanging convergence
  FILE ${_vortex} SET ${_brief} ${_band} "Time/End time=2"
  VARY "Domain/Initial refinement=1|2" ERROR errors.density_L1 ORDER 1.8
  LABELS verification)
# Orders measured: 1.99, 3.12 and 4.02; with hanging faces 2.00, 3.06 and 3.96.
foreach(_case "1|0.5|1.8|3|4" "2|1|2.8|2|3" "3|1|3.8|2|3")
  string(REPLACE "|" ";" _case ${_case})
  list(GET _case 0 _degree)
  list(GET _case 1 _end)
  list(GET _case 2 _order)
  list(GET _case 3 _coarse)
  list(GET _case 4 _fine)
  contrecoup_add_application_test(mapped_vortex_degree_${_degree} convergence
    FILE ${_vortex} SET ${_brief} ${_galerkin} "Method/Degree=${_degree}"
    "Method/Blending=false" "Time/End time=${_end}"
    VARY "Domain/Initial refinement=${_coarse}|${_fine}"
    ERROR errors.density_L1 ORDER ${_order} LABELS verification)
  contrecoup_add_application_test(mapped_vortex_hanging_degree_${_degree}
    convergence FILE ${_vortex} SET ${_brief} ${_band} ${_galerkin}
    "Method/Degree=${_degree}" "Method/Blending=false" "Time/End time=${_end}"
    VARY "Domain/Initial refinement=${_coarse}|${_fine}"
    ERROR errors.density_L1 ORDER ${_order} LABELS verification)
endforeach()
# Orders measured: 1.96, 3.09 and 4.01.
set(_half_ring "Adaptation/Fine box levels=1"
  "Adaptation/Fine box lower corner=-2, -2"
  "Adaptation/Fine box upper corner=0.1, 2")
foreach(_degree 1 2 3)
  set(_curved ${_ring} SET ${_brief} "Method/Degree=${_degree}")
  set(_required VARY "Domain/Initial refinement=1|2"
    ERROR errors.density_L1 ORDER ${_degree}.8 LABELS verification)
  contrecoup_add_application_test(curved_ring_degree_${_degree} convergence
    FILE ${_curved} ${_required})
  contrecoup_add_application_test(curved_ring_hanging_degree_${_degree}
    convergence FILE ${_curved} ${_half_ring} ${_required})
endforeach()
# Orders measured: 3.48 and 3.85.
foreach(_case "2|2.8" "3|3.4")
  string(REPLACE "|" ";" _case ${_case})
  list(GET _case 0 _degree)
  list(GET _case 1 _order)
  contrecoup_add_application_test(curved_shell_degree_${_degree} convergence
    FILE ${_ring} SET ${_brief} ${_shell} "Method/Degree=${_degree}"
    VARY "Domain/Initial refinement=1|2" ERROR errors.density_L1
    ORDER ${_order} LABELS verification)
endforeach()
# Bounds: the errors when the tests were written and a tenth more.
contrecoup_add_application_test(mapped_vortex_barth_jespersen bounds
  FILE ${_vortex} SET ${_brief} "Domain/Initial refinement=2"
  "Method/Gradient limiter=barth jespersen"
  BOUNDS "errors.density_L1 < 1.22e-4" LABELS verification)
contrecoup_add_application_test(mapped_vortex_venkatakrishnan bounds
  FILE ${_vortex} SET ${_brief} "Domain/Initial refinement=2"
  "Method/Gradient limiter=venkatakrishnan"
  BOUNDS "errors.density_L1 < 1.37e-4" LABELS verification)
contrecoup_add_application_test(mapped_wind_2d bounds FILE ${_vortex}
  SET ${_uniform} "Domain/Initial refinement=2"
  "Initial state/Background/Velocity=0.3,-0.5" BOUNDS ${_unchanged}
  LABELS verification)
contrecoup_add_application_test(mapped_wind_3d bounds FILE ${_ball}
  SET ${_uniform} "Domain/Mesh=file" "Domain/Initial refinement=1"
  "Domain/Mesh file=${_meshes}/distorted_cube.msh"
  "Initial state/Background/Velocity=0.3,-0.5,0.7" BOUNDS ${_unchanged}
  LABELS verification)
contrecoup_add_application_test(mapped_wind_hanging bounds FILE ${_ball}
  SET ${_uniform} ${_octant} "Domain/Mesh=file" "Domain/Initial refinement=1"
  "Domain/Mesh file=${_meshes}/distorted_cube.msh"
  "Initial state/Background/Velocity=0.3,-0.5,0.7" BOUNDS ${_unchanged}
  LABELS verification)
foreach(_degree 1 2 3)
  contrecoup_add_application_test(mapped_wind_hanging_degree_${_degree} bounds
    FILE ${_ball} SET ${_uniform} ${_octant} ${_galerkin}
    "Method/Degree=${_degree}" "Domain/Mesh=file"
    "Domain/Initial refinement=1"
    "Domain/Mesh file=${_meshes}/distorted_cube.msh"
    "Initial state/Background/Velocity=0.3,-0.5,0.7" BOUNDS ${_unchanged}
    LABELS verification)
  contrecoup_add_application_test(mapped_wind_2d_degree_${_degree} bounds
    FILE ${_vortex} SET ${_uniform} ${_galerkin} "Method/Degree=${_degree}"
    "Domain/Initial refinement=2"
    "Initial state/Background/Velocity=0.3,-0.5" BOUNDS ${_unchanged}
    LABELS verification)
  contrecoup_add_application_test(mapped_wind_3d_degree_${_degree} bounds
    FILE ${_ball} SET ${_uniform} ${_galerkin} "Method/Degree=${_degree}"
    "Domain/Mesh=file" "Domain/Initial refinement=1"
    "Domain/Mesh file=${_meshes}/distorted_cube.msh"
    "Initial state/Background/Velocity=0.3,-0.5,0.7" BOUNDS ${_unchanged}
    LABELS verification)
  contrecoup_add_application_test(mapped_shock_degree_${_degree} bounds
    FILE ${_ball} SET ${_galerkin} "Method/Degree=${_degree}"
    "Domain/Mesh=file" "Domain/Initial refinement=1"
    "Domain/Mesh file=${_meshes}/distorted_cube.msh" "Output/Fields=false"
    "Initial state/Region charge/Pressure=1000" "Time/End time=0.05"
    BOUNDS "status == finished"
    "conservation.mass_relative_change < 1e-12"
    "conservation.energy_relative_change < 1e-12" LABELS verification)
  contrecoup_add_application_test(curved_shock_degree_${_degree} bounds
    FILE ${_ball} SET ${_galerkin} "Method/Degree=${_degree}"
    "Domain/Initial refinement=1" "Output/Fields=false"
    "Initial state/Region charge/Pressure=1000" "Time/End time=0.05"
    BOUNDS "status == finished"
    "conservation.mass_relative_change < 1e-12"
    "conservation.energy_relative_change < 1e-12" LABELS verification)
endforeach()
foreach(_limiter "none" "barth jespersen" "venkatakrishnan")
  string(REPLACE " " "_" _name ${_limiter})
  contrecoup_add_application_test(mapped_ball_${_name} bounds FILE ${_ball}
    SET "Domain/Initial refinement=1" "Output/Fields=false"
    "Method/Gradient limiter=${_limiter}" BOUNDS "status == finished"
    "conservation.mass_relative_change < 1e-12"
    "conservation.energy_relative_change < 1e-12" LABELS verification)
endforeach()

contrecoup_add_application_test(mapped_ball_runs ranks,resume FILE ${_ball}
  SET ${_small} COMPARE history.csv probes.csv
  TOLERANCE 1e-10 "momentum*=1e-12 absolute" CORES 1 STOP_AFTER 7)
contrecoup_add_application_test(mapped_hanging_runs ranks,resume FILE ${_ball}
  SET ${_small} ${_octant} COMPARE history.csv probes.csv
  TOLERANCE 1e-10 "momentum*=1e-12 absolute" CORES 1 STOP_AFTER 7)
contrecoup_add_application_test(mapped_hanging_galerkin_runs ranks,resume
  FILE ${_ball} SET ${_small} ${_octant} ${_galerkin} "Method/Degree=2"
  COMPARE history.csv probes.csv
  TOLERANCE 1e-10 "momentum*=1e-12 absolute" CORES 1 STOP_AFTER 7)
# A probe between the curved wall and the straight edge of its cell.
contrecoup_add_application_test(curved_runs ranks,resume FILE ${_ring}
  SET "Domain/Initial refinement=1" ${_half_ring} ${_steps_20}
  "Probes/Points=1.9518, 0.3882" COMPARE history.csv probes.csv
  TOLERANCE 1e-10 "momentum*=1e-12 absolute" CORES 1 STOP_AFTER 7)
contrecoup_add_application_test(mapped_single_runs ranks,resume FILE ${_ball}
  SET ${_small} ${_octant} "Method/Precision=single"
  COMPARE history.csv probes.csv
  TOLERANCE 1e-10 "momentum*=1e-12 absolute" CORES 1 STOP_AFTER 7)
contrecoup_add_application_test(ranks_mapped_file ranks FILE ${_vortex}
  SET "Domain/Initial refinement=2" ${_steps_20} COMPARE history.csv
  TOLERANCE 1e-10)
contrecoup_add_application_test(ranks_mapped_galerkin ranks FILE ${_ball}
  SET ${_small} ${_galerkin} COMPARE history.csv probes.csv
  TOLERANCE 1e-10 "momentum*=1e-12 absolute")
# Coarse cells in different orientations: which side of a face deal.II calls
# interior depends on the ranks.
contrecoup_add_application_test(ranks_mapped_galerkin_blending ranks
  FILE ${_ball} SET ${_small} ${_galerkin} "Domain/Mesh=file"
  "Domain/Mesh file=${_meshes}/distorted_cube.msh"
  "Initial state/Region charge/Pressure=1000" COMPARE history.csv
  TOLERANCE 1e-10 "momentum*=1e-12 absolute")

contrecoup_add_refusal(refuses_inverted_cell ${_vortex} "cell 1 with centre"
  "Domain/Mesh file=${CMAKE_CURRENT_SOURCE_DIR}/meshes/inverted_cell.msh")
contrecoup_add_refusal(refuses_inverted_refinement ${_ball}
  "refined 2 times, is inverted" "Domain/Generator arguments=0, 0, 0 : 1 : true")
contrecoup_add_refusal(refuses_inverted_curved_cell ${_ball}
  "set Method/Cell degree = 1 for straight cells" ${_galerkin}
  "Domain/Initial refinement=1" "Domain/Generator arguments=0, 0, 0 : 1 : true")
contrecoup_add_refusal(refuses_cell_degree ${_ring}
  "Method/Cell degree = 5: with Method/Degree = 3 in 2-D at most 4"
  "Method/Cell degree=5")
contrecoup_add_refusal(refuses_triangle ${_vortex} "quadrilaterals"
  "Domain/Mesh file=${CMAKE_CURRENT_SOURCE_DIR}/meshes/triangle.msh")
contrecoup_add_refusal(refuses_unknown_generator ${_ball} "Domain/Generator = hyper_bal"
  "Domain/Generator=hyper_bal")
contrecoup_add_refusal(refuses_galerkin_gradient_limiter ${_ball}
  "only none is available" ${_galerkin} "Method/Gradient limiter=barth jespersen")
contrecoup_add_refusal(refuses_mapped_adaptation ${_ball}
  "Adaptation/Active = true needs Domain/Mesh = box" "Adaptation/Active=true")
contrecoup_add_refusal(refuses_mapped_odd_subcells ${_ball}
  "Method/Subcells = 1 or an even number" ${_octant} "Method/Subcells=5")
contrecoup_add_refusal(refuses_unknown_boundary ${_vortex}
  "the mesh has no boundary 7, only 0" "Boundaries/By id=7: open")
contrecoup_add_refusal(refuses_box_side ${_vortex} "Boundaries/By id"
  "Boundaries/x low=open")
contrecoup_add_refusal(refuses_huge_mapped_mesh ${_ball} "of memory"
  "Domain/Initial refinement=9")
contrecoup_add_refusal(refuses_mapped_probe ${_ball} "is outside of the mesh"
  "Probes/Points=0.9,0.9,0")
