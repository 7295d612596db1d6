# From the charge to the injuries, on a head of some thousand elements.
set(_head scene/verification/head.prm)

contrecoup_add_application_test(stages scene_run FILE ${_head}
  BOUNDS "status == finished" "assumptions.energy_residual < 1e-3"
    "assumptions.injury_intracranial_pressure_peak > 1e5"
    "assumptions.injury_strain_95 < 0.05")
set(_brief "Scene/Forecast=false" "Scene/Report=false"
  "Anatomy/Output/Pictures=false")
contrecoup_add_application_test(runs scene_ranks,scene_sigkill FILE ${_head}
  RANKS 2 4 SET ${_brief} "Biomechanics/Elements/Precision=double"
    "Blast/Method/Precision=double" "Blast/Output/Fields=false"
    "Biomechanics/Output/Fields=false")
contrecoup_add_application_test(failing_stage scene_failure FILE ${_head}
  SET ${_brief})
# Elements so coarse that it is the blast that fills the disk.
contrecoup_add_application_test(full_disk scene_full_disk FILE ${_head}
  SET ${_brief} "Scene/Element size=0.005"
  "Biomechanics/Elements/Integration=full")

# scene_refuses(<name> <message> <arguments>)
function(scene_refuses name message)
  contrecoup_add_application_test(refuses_${name} refusal ${ARGN}
    FILE ${_head} MESSAGE "${message}")
endfunction()

scene_refuses(charge_in_body "is in the body" SET "Charge/Place=0, 0, 1")
scene_refuses(charge_below_ground "above 0, the ground"
  SET "Charge/Place=0.5, 0, -1")
scene_refuses(body_below_ground "below the ground" SET "Body/Shift=0, 0, 0")
scene_refuses(early_end "the blast reaches the body at"
  SET "Scene/End time=1e-5")
scene_refuses(no_symmetry "differ by"
  SET "Scene/Symmetry=y" "Body/Shift=0, 0.1, 1")
scene_refuses(unknown_entry "unknown entry" SET "Blast/Method/Limitr=mc")
scene_refuses(unknown_accuracy "balanced" SET "Scene/Accuracy=balancd")
scene_refuses(nothing_to_resume "holds no stage of a scene"
  ARGUMENTS "--resume")
scene_refuses(unwritable_output "output folder" OUTPUT "@FOLDER@/a_file/run")
