#include "events_or_steps.hpp"

namespace exercise {

Run plan_run(const Ball& /*ball*/, double /*duration*/, double /*tolerance*/, int /*budget*/) {
  contact::todo();
}

}  // namespace exercise
