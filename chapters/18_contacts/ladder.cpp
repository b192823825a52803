// Several contacts at once: the impulses of two contacts by one after the other, iterations, the
// four cases of complementarity in float and double, and exactly; and how many iterations a stack
// needs, from 0, from the impulses of the step before, with over-relaxation, and by an active set.
#include <support/ladder.hpp>

#include <18_contacts/measured_stack.hpp>
#include <18_contacts/measured_two.hpp>

namespace {

ladder::Parts experiment() {
  ladder::Parts parts("Several contacts at once: which impulses?");
  parts.add(measured_two::experiment());
  parts.add(measured_stack::experiment());
  return parts;
}

}  // namespace

LADDER(experiment)
