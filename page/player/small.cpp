// The code that reads, plans and reports, in one file that is compiled for size.

#include <src/json_tree.cpp>
#include <src/plan.cpp>
#include <src/plan_bounds.cpp>
#include <src/plan_contact.cpp>
#include <src/plan_expected.cpp>
#include <src/plan_horizon.cpp>
#include <src/plan_hypotheses.cpp>
#include <src/plan_json.cpp>
#include <src/plan_motion.cpp>
#include <src/plan_pairs.cpp>
#include <src/plan_phrases.cpp>
#include <src/plan_savings.cpp>
#include <src/plan_shapes.cpp>
#include <src/plan_spreading.cpp>
#include <src/plan_text.cpp>
#include <src/plan_time.cpp>
#include <src/plan_types.cpp>
#include <src/scene.cpp>
#include <src/scene_check.cpp>
#include <src/scene_reader.cpp>
#include <src/scene_solids.cpp>

#include "player.cpp"
