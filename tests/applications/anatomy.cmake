# Bodies: whole runs, and bad input.
#
# Committed tables and meshes are met to rounding; meshes are written in single
# precision.
set(_rounding 1e-9 "*.vtu:*=2e-7")
contrecoup_add_application_test(quickstart bounds
  FILE anatomy/quickstart.prm SET "Output/Pictures=false"
  BOUNDS "status == finished" "connected_components == 1"
    "errors.whole_body_volume < 1.65e-3" "errors.brain_volume < 0.0345"
    "smallest_scaled_jacobian > 0.999" "height > 1.75"
    "center_of_gravity.2 > 0.978" "center_of_gravity.2 < 0.982")
contrecoup_add_application_test(organs bounds
  FILE anatomy/quickstart.prm
  SET "Output/Pictures=false" "Mesh/Element size=0.005"
  BOUNDS "references_held == 6" "errors.whole_body_volume < 1.41e-3"
    "errors.mass < 0.0146" "errors.brain_volume < 0.0278"
    "errors.heart_volume < 3.48e-4" "errors.liver_volume < 4.28e-3"
    "errors.lungs_volume < 0.0112" "errors.skeleton_volume < 0.0109"
    "connected_components == 1")
contrecoup_add_application_test(pictures pictures
  FILE anatomy/quickstart.prm SET "Mesh/Element size=0.015"
  COMPARE body.png cuts.png quality.png)
contrecoup_add_application_test(coarse bounds
  FILE anatomy/quickstart.prm
  SET "Body/Kind=shape" "Body/Shape/Size=0.1" "Mesh/Element size=0.1"
    "Output/Pictures=false" "Output/Gmsh=true" "Output/Distance spacing=0.05"
  BOUNDS "cells == 8")

# Readers besides ParaView.
contrecoup_add_application_test(vtu foreign_reader
  FILE anatomy/quickstart.prm SET "Output/Pictures=false" "Mesh/Element size=0.02"
    "Mesh/Coarsening levels=1")
# A head for head_impact, and as a body of one's own hexahedra.
contrecoup_add_application_test(head_mesh bounds
  FILE anatomy/quickstart.prm
  SET "Output/Pictures=false" "Output/Surface=false" "Output/Gmsh=true"
    "Body/Kind=shape" "Body/Shape/Shape=layered head" "Body/Shape/Size=0.05"
    "Body/Shape/Layers=0.02, 0.01" "Mesh/Element size=0.01"
    "Body/Shape/Tissues=brain, cerebrospinal fluid, skeleton"
  BOUNDS "connected_components == 1" "cells > 1900")
set_tests_properties(anatomy_head_mesh PROPERTIES FIXTURES_SETUP head_mesh)

contrecoup_add_refusal(refuses_thin_man anatomy/quickstart.prm "body mass index of 14.6"
  "Body/Phantom/Mass=45")
contrecoup_add_refusal(refuses_fine_mesh anatomy/quickstart.prm "elements of 1e-05 m"
  "Mesh/Element size=1e-5")
contrecoup_add_refusal(refuses_coarse_mesh anatomy/quickstart.prm
  "no element has its centre in the body" "Body/Kind=shape" "Body/Shape/Size=0.001"
  "Mesh/Element size=0.1")
contrecoup_add_application_test(refuses_resume refusal
  FILE anatomy/quickstart.prm ARGUMENTS --resume
  MESSAGE "anatomy has no steps to go on with")
contrecoup_add_refusal(refuses_unknown_tissue anatomy/quickstart.prm
  "did you mean \"brain\"" "Body/Kind=shape" "Body/Shape/Tissues=brian")

contrecoup_add_application_test(flawed_box bounds,regression
  FILE anatomy/extremes/flawed_box.prm SET "Output/Pictures=false"
  BOUNDS "volume < 0.0240001" "volume > 0.0239999" "cells == 3000"
    "connected_components == 1"
  COMPARE quality.csv mesh.vtu TOLERANCE ${_rounding})
contrecoup_add_application_test(needle bounds
  FILE anatomy/extremes/needle.prm SET "Output/Pictures=false"
  BOUNDS "cells == 3200" "connected_components == 1")
contrecoup_add_refusal(refuses_large_holes anatomy/extremes/flawed_box.prm
  "Body/Surface/Largest holes allows 1 %" "Body/Surface/Largest holes=0.01")
contrecoup_add_refusal(refuses_organs_in_a_box anatomy/extremes/flawed_box.prm
  "the surface must be that of one person from the soles to the vertex"
  "Body/Surface/Organs=phantom" "Body/Scale=4")
contrecoup_add_refusal(refuses_unknown_facing anatomy/extremes/flawed_box.prm
  "allowed: found, or a number from -360 to 360" "Body/Surface/Facing=north")
contrecoup_add_refusal(refuses_missing_surface anatomy/quickstart.prm
  "there is no such file" "Body/Kind=surface" "Body/Surface/File=/nowhere/body.stl")

# Hexahedra of one's own, in mm.
set(_two_cubes "Body/Kind=mesh" "Body/Mesh/Unit=mm"
  "Body/Mesh/File=${CMAKE_CURRENT_SOURCE_DIR}/meshes/two_cubes.msh")
contrecoup_add_application_test(own_mesh bounds
  FILE anatomy/quickstart.prm
  SET ${_two_cubes} "Body/Mesh/Tissues=inside: brain@SEMICOLON@ 2: skull = skeleton"
    "Output/Pictures=false"
  BOUNDS "cells == 2" "facets == 10" "parts == 2" "connected_components == 1"
    "volume > 1.999999e-6" "volume < 2.000001e-6")
contrecoup_add_refusal(refuses_coarsening_of_own_mesh anatomy/quickstart.prm
  "Body/Kind = mesh has its own hexahedra" ${_two_cubes} "Body/Mesh/Tissues=1-2: brain"
  "Mesh/Coarsening levels=1")

# Images that Debian's mricron-data ships.
contrecoup_add_application_test(colin_head bounds
  FILE anatomy/showcase/colin_head.prm NEEDS ${_images}/ch2.nii.gz
  SET "Output/Pictures=false" "Mesh/Element size=0.005"
  BOUNDS "connected_components == 1" "volume > 0.0039" "volume < 0.0045")
contrecoup_add_application_test(atlas_brain bounds
  FILE anatomy/showcase/atlas_brain.prm NEEDS ${_images}/ch2.nii.gz
  SET "Output/Pictures=false"
  BOUNDS "parts == 2" "volume > 0.00147" "volume < 0.00149")
contrecoup_add_refusal(refuses_missing_image anatomy/quickstart.prm
  "there is no such file" "Body/Kind=image" "Body/Image/File=/nowhere/a.nii"
  "Body/Image/Labels=1: brain")

contrecoup_add_application_test(graded bounds,regression
  FILE anatomy/quickstart.prm
  SET "Output/Pictures=false" "Mesh/Element size=0.008"
    "Mesh/Coarsening levels=2" "Mesh/Smoothing iterations=20"
  BOUNDS "smallest_scaled_jacobian > 0.1999999" "connected_components == 1"
    "errors.whole_body_volume < 3.49e-3" "hanging_nodes > 24400"
  COMPARE quality.csv parts.csv hanging_nodes.csv mesh.vtu surface.vtu
  TOLERANCE ${_rounding})
