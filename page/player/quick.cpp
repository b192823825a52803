// The code of runs, in one file that is compiled for speed: in separate files, each would
// instantiate the same templates.

#include <src/free_flight_run.cpp>
#include <src/hard_sphere_compose.cpp>
#include <src/hard_sphere_run.cpp>
#include <src/hard_sphere_scene.cpp>
#include <src/hard_sphere_times.cpp>
#include <src/hull_contact.cpp>
#include <src/make_scene_run.cpp>
#include <src/scene_run.cpp>
#include <src/stage_contact_events.cpp>
#include <src/stage_contacts.cpp>
#include <src/stage_forces.cpp>
#include <src/stage_impacts.cpp>
#include <src/stage_motion.cpp>
#include <src/stage_pairs.cpp>
#include <src/stage_sleep.cpp>
#include <src/stage_time_of_impact.cpp>
#include <src/step_solver.cpp>
#include <src/stepped_run.cpp>
#include <src/stepped_setup.cpp>
#include <src/stepped_state.cpp>
#include <src/substep_motion.cpp>

#include "player_run.cpp"
