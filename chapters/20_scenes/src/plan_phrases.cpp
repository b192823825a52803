#include "plan_phrases.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <contact/invalid_argument.hpp>
#include <contact/plan/plan_report.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/scene/compiled.hpp>

namespace contact::scenes {

namespace detail {

/// How a condition is said. `is` is its left side, where * stands for any words. In the sentences
/// {*} is what * stands for, {l} and {r} are the sides with their unit, {s} is the sign between
/// them, and {body|bodies} is the left side as a count, with its noun. Where the left side, or the
/// right one if the condition holds, has no bound, `unbounded` is said.
struct ConditionPhrase {
  std::string_view is;
  std::string_view fails;
  std::string_view holds;
  std::string_view unbounded;
};

/// The conditions of the planner's rules. A condition that is not here is said by its own words.
inline constexpr std::array condition_phrases{
    // Motion.
    ConditionPhrase{"size of gravity", "gravity is {l}", "there is no gravity", ""},
    ConditionPhrase{"gravity that no table cancels", "gravity is {l}",
                    "no gravity presses bodies together", ""},
    ConditionPhrase{"gravity along * that the table does not cancel", "gravity along {*} is {l}",
                    "a table cancels gravity along {*}", ""},
    ConditionPhrase{"gravity along *", "gravity along {*} is {l}", "no gravity along {*}", ""},
    ConditionPhrase{"moving bodies", "{body|bodies} can move", "nothing can move", ""},
    ConditionPhrase{"balls that do not lie exactly on a level floor",
                    "{ball does|balls do} not lie on a level floor",
                    "all balls lie exactly on a level floor", ""},
    ConditionPhrase{"moving bodies other than balls that lie exactly on a level floor",
                    "{moving body is|moving bodies are} no ball on a floor",
                    "every moving body is a ball on a level floor", ""},
    ConditionPhrase{"balls that sink into their floor", "{ball sinks|balls sink} into a soft floor",
                    "no ball sinks into its floor", ""},
    ConditionPhrase{"largest friction between bodies that may meet",
                    "there is friction: μ up to {l}", "bodies that may meet are smooth: μ = 0", ""},
    ConditionPhrase{"fastest motion along * at the beginning", "something moves along {*}: {l}",
                    "nothing moves along {*} at first", ""},
    ConditionPhrase{"largest angular velocity about another axis than *",
                    "something rotates, not about {*}: {l}", "nothing rotates, except about {*}",
                    ""},
    ConditionPhrase{"bodies or pairs not their own mirror image across *",
                    "{body or pair is|bodies or pairs are} not symmetric across {*}",
                    "every body is symmetric across {*}", ""},
    ConditionPhrase{"farthest that centres of bodies that may meet differ along *",
                    "centres differ along {*} by {l}", "all centres have the same {*}", ""},
    ConditionPhrase{"pairs of bodies that may meet", "{pair|pairs} of bodies may meet",
                    "no two bodies can meet", ""},
    ConditionPhrase{"moving bodies other than balls that may touch something",
                    "{body|bodies} other than balls may touch", "only balls can touch anything",
                    ""},
    ConditionPhrase{"moving bodies other than balls that rotate",
                    "{body rotates and is|bodies rotate and are} no ball",
                    "nothing but balls rotates", ""},
    ConditionPhrase{"moving bodies other than balls that * touch something",
                    "{body|bodies} other than balls may rotate",
                    "nothing but balls may rotate and touch", ""},
    ConditionPhrase{"largest difference between two moments of inertia of a body",
                    "moments of inertia differ: {l}", "each body's moments of inertia are equal",
                    ""},
    ConditionPhrase{"kinds of rotation that a gyroscopic term may change",
                    "the gyroscopic term may change rotation", "every angular velocity is constant",
                    ""},
    ConditionPhrase{"fall in the whole duration, ½ g T²", "the fall ½ g T² is {l}{s}{r}",
                    "the fall ½ g T² is {l}{s}{r}", "the fall ½ g T² has no bound"},
    ConditionPhrase{"largest displacement of a body's point by that, R ½ α T²",
                    "points are off by {l}{s}{r}", "points are off by {l}{s}{r}",
                    "how far points are off has no bound"},
    // Contacts.
    ConditionPhrase{"largest restitution of hard contacts that may occur",
                    "bodies rebound: e up to {l}", "nothing rebounds: e = 0", ""},
    ConditionPhrase{"pairs that may meet and are compliant",
                    "{pair that may meet is|pairs that may meet are} soft",
                    "nothing that may meet is soft", ""},
    ConditionPhrase{"compliant pairs that may meet",
                    "{pair that may meet is|pairs that may meet are} soft",
                    "nothing that may meet is soft", ""},
    ConditionPhrase{"compliant pairs that may meet beside hard ones",
                    "{soft pair|soft pairs} beside hard ones", "no soft pair beside hard ones", ""},
    ConditionPhrase{"compliant pairs, where a body may meet several",
                    "{pair is|pairs are} soft, among several",
                    "nothing soft where a body meets several", ""},
    ConditionPhrase{"pairs with friction, where a body may meet several or a fixed ball",
                    "{pair has|pairs have} friction, among several",
                    "no friction where a body meets several", ""},
    ConditionPhrase{"fixed balls that may be met while gravity acts",
                    "{fixed ball|fixed balls} may be grazed and pressed",
                    "gravity presses nothing on a fixed ball", ""},
    ConditionPhrase{
        "pairs that may meet other than balls that move, or a ball and a hard half-space",
        "{pair is|pairs are} not of ball and hard floor", "balls meet hard half-spaces only", ""},
    ConditionPhrase{"balls that touch a half-space at the beginning and do not separate",
                    "{ball touches|balls touch} a wall at the start",
                    "no ball touches a wall at the start", ""},
    ConditionPhrase{"pairs that touch at the start, or are hit at the same instant, beside others",
                    "{pair|pairs} may be hit at one instant", "no hits at one instant", ""},
    ConditionPhrase{"most bodies that one moving body may touch", "a body may touch {l} others",
                    "no body may touch more than one other", ""},
    ConditionPhrase{"hard contacts that may occur", "{hard contact|hard contacts} may occur",
                    "no hard contact can occur", ""},
    ConditionPhrase{"largest loss of speed, 1 − e, between bodies that may meet",
                    "impacts lose speed: 1 − e up to {l}", "all impacts are elastic: e = 1", ""},
    ConditionPhrase{"pairs that may meet other than balls and half-spaces",
                    "{pair is|pairs are} not of balls and half-spaces",
                    "only balls and half-spaces can meet", ""},
    ConditionPhrase{"kinds of pairs that touch at the beginning *",
                    "bodies touch from the beginning", "nothing touches at the beginning", ""},
    ConditionPhrase{"duration", "a ball may rest from t = {r} on", "no ball rests before t = {r}",
                    "no ball ever comes to rest"},
    ConditionPhrase{"height of a bounce that *", "bounces left out: {l}{s}{r}",
                    "bounces left out: {l}{s}{r}", ""},
    ConditionPhrase{"a bounce of no height", "no bounce may be left out",
                    "bounces below {r} are left out", ""},
    ConditionPhrase{"distance that a sleeping body would creep *", "a sleeper may creep {l}{s}{r}",
                    "a sleeper may creep {l}{s}{r}", ""},
    ConditionPhrase{"substep while a spring pushes", "a spring's substep: {l}{s}{r}",
                    "a spring's substep: {l}{s}{r}", ""},
    ConditionPhrase{"error of leapfrog at the end, estimated", "springs are off by {l}{s}{r}",
                    "springs are off by {l}{s}{r}", "springs: no error is estimated"},
    ConditionPhrase{"approach of * in a step", "approach in a step: {l}{s}{r}",
                    "approach in a step: {l}{s}{r}", "approach in a step has no bound"},
    ConditionPhrase{"error at the end by hits that are late, *", "late or missed hits: {l}{s}{r}",
                    "late or missed hits: {l}{s}{r}", "late or missed hits have no bound"},
    ConditionPhrase{"pairs that may meet and of which none is a half-space",
                    "{pair|pairs} without a half-space may meet", "bodies meet half-spaces only",
                    ""},
    ConditionPhrase{"pairs with vertices or edges that may meet, *",
                    "{pair|pairs} with edges may graze unseen", "no edge can graze another body",
                    ""},
    ConditionPhrase{"bodies that move", "{l} bodies move, more than {r}",
                    "{l} bodies move, at most {r}", ""},
    // Broad phase, time, horizon.
    ConditionPhrase{"balls", "{ball|balls}, more than {r}", "{ball|balls}, at most {r}", ""},
    ConditionPhrase{"instructions to compare every pair", "all pairs: {l}{s}{r} instructions",
                    "all pairs: {l}{s}{r} instructions", ""},
    ConditionPhrase{"fixed bodies that may be touched, other than half-spaces and balls",
                    "{fixed body is|fixed bodies are} no ball or half-space",
                    "every fixed body is a ball or half-space", ""},
    ConditionPhrase{"most impacts of one ball", "a ball may have {impact|impacts}",
                    "a ball has at most {impact|impacts}", "a ball's impacts have no bound"},
    ConditionPhrase{"pairs that may meet other than a ball and a hard half-space",
                    "{pair is|pairs are} not of ball and hard floor",
                    "balls meet hard half-spaces only", ""},
    ConditionPhrase{"steps between two impacts", "there are steps between impacts",
                    "from event to event there are no steps", ""},
    ConditionPhrase{"step times the stiffest spring's angular frequency",
                    "step × ω of a spring: {l}{s}{r}", "step × ω of a spring: {l}{s}{r}", ""},
    ConditionPhrase{"rounding error of a flight in float", "rounding in float: {l}{s}{r}",
                    "rounding in float: {l}{s}{r}", ""},
    ConditionPhrase{"numbers whose squares overflow or underflow in float",
                    "{number does|numbers do} not fit into float", "all numbers fit into float",
                    ""},
    ConditionPhrase{"half-spaces neither horizontal nor vertical, beside others",
                    "{half-space is|half-spaces are} oblique", "no half-space is oblique", ""},
    ConditionPhrase{"pairs with friction, where a body may meet several",
                    "{pair has|pairs have} friction, among several",
                    "no friction where a body meets several", ""},
    ConditionPhrase{"moving bodies that fall and bounce on the line",
                    "{body|bodies} may bounce on the line", "at most one bounces on the line", ""},
    ConditionPhrase{
        "pairs of half-spaces at an angle that a body at both may leave in two directions",
        "{corner|corners} of walls: the order of hits decides",
        "no order of hits decides in a corner", ""},
    ConditionPhrase{"* that rise to within 1 % of the energy at which they graze a ceiling",
                    "{body|bodies} may graze a ceiling", "nothing grazes a ceiling", ""},
    ConditionPhrase{
        "bodies that two others may hit at one instant, of different masses or with 0 < e < 1",
        "{body|bodies} may be hit from two sides at once", "no order of hits decides on the line",
        ""},
    ConditionPhrase{"growth of an ulp in the most oblique first hit, compared with 1/cos θ = 2",
                    "a first hit grazes: an ulp grows {l} × as much", "no first hit grazes", ""},
    ConditionPhrase{"first hits of one body at the same instant",
                    "a body's first hits may be at one instant", "no first hits at one instant",
                    ""},
    ConditionPhrase{"hits after the first ones that are more oblique than on average",
                    "a later hit may graze", "no later hit grazes", ""},
    ConditionPhrase{"the start", "a touch may come at t = {r}", "no touch before t = {r}", ""},
    ConditionPhrase{"time until an ulp has grown to *", "an ulp stays small until t = {l}",
                    "an ulp has grown by t = {l}", ""},
};

/// What a sentence that decides becomes in a summary: * stands for any words, {1} for those of the
/// first.
struct ReasonPhrase {
  std::string_view why;
  std::string_view said;
};

inline constexpr std::array reason_phrases{
    ReasonPhrase{"The scene is its own mirror image across * and across *, so that all motion is "
                 "along * and nothing rotates.",
                 "symmetry: all motion is along {3}"},
    ReasonPhrase{"The scene is its own mirror image across *; *",
                 "symmetry: nothing moves along {1}"},
    ReasonPhrase{"Every angular velocity stays along *, which *",
                 "symmetry: rotation about {1} only"},
    ReasonPhrase{"Nothing rotates, or only as a ball does.",
                 "nothing rotates, except smooth balls"},
    ReasonPhrase{"The contact force on a smooth ball *", "no torque acts on a smooth ball"},
    ReasonPhrase{"A level table without friction balances gravity.",
                 "a level table balances gravity"},
    ReasonPhrase{"Elastic balls leave with *", "elastic balls do not come to rest"},
    ReasonPhrase{"A body that never rests never sleeps. *", "what never rests never sleeps"},
    ReasonPhrase{"From event to event each impact *", "each impact is found at its time"},
    ReasonPhrase{"From event to event there are no steps.",
                 "from event to event there are no steps"},
    ReasonPhrase{"A step is asked for*", "a step is asked for"},
    ReasonPhrase{"The step is the one asked for.", "the step is the one asked for"},
    ReasonPhrase{"Elastic balls that never rest have finitely *",
                 "elastic balls have finitely many hits"},
    ReasonPhrase{"Nothing touches anything and flights *", "nothing touches, so any step does"},
    ReasonPhrase{"On a line no hit spreads paths; *", "on a line no hit spreads an error"},
    ReasonPhrase{"Flat walls do not spread *", "flat walls do not spread an error"},
    ReasonPhrase{"Not known: a rotating body *", "not known: edges rotate, and may touch"},
    ReasonPhrase{"Not proven: nothing moves at first, *", "not known: nothing moves at first"},
};

/// Whether a text has a pattern's words.
/// @param parts gets what each * stands for
CONTACT_SCENES_INLINE bool has_words(std::string_view text, std::string_view pattern,
                                     std::vector<std::string>& parts) {
  parts.clear();
  for (;;) {
    const std::size_t star = pattern.find('*');
    if (star == std::string_view::npos) return text == pattern;
    if (text.substr(0, star) != pattern.substr(0, star)) return false;
    text.remove_prefix(star);
    pattern.remove_prefix(star + 1);
    const std::string_view next = pattern.substr(0, pattern.find('*'));
    const std::size_t end = next.empty() ? text.size() : text.find(next);
    if (end == std::string_view::npos) return false;
    parts.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
  }
}

CONTACT_SCENES_INLINE std::string with_unit(double x, const std::string& unit) {
  return std::isfinite(x) && !unit.empty() ? plan_number(x) + " " + unit : plan_number(x);
}

CONTACT_SCENES_INLINE std::array<std::string, 2> sides_of(const Inequality& condition) {
  std::string left = with_unit(condition.left, condition.unit);
  std::string right = with_unit(condition.right, condition.unit);
  if (left == right && condition.left != condition.right && std::isfinite(condition.left)) {
    left = number_text(condition.left);
    right = number_text(condition.right);
    if (!condition.unit.empty()) right += " " + condition.unit;
  }
  return {left, right};
}

CONTACT_SCENES_INLINE const char* sign_of_sides(const Inequality& condition) {
  const bool held = contact::holds(condition);
  switch (condition.relation) {
    case Relation::less:
      return held ? " < " : " ≥ ";
    case Relation::at_most:
      return held ? " ≤ " : " > ";
    default:
      return held ? " = " : " ≠ ";
  }
}

CONTACT_SCENES_INLINE std::string filled(std::string_view phrase, const Inequality& condition,
                                         const std::string& any) {
  const auto [left, right] = sides_of(condition);
  std::string text;
  for (std::size_t at = 0; at < phrase.size();) {
    const std::size_t open = phrase.find('{', at);
    text += phrase.substr(at, open - at);
    if (open == std::string_view::npos) break;
    const std::size_t close = phrase.find('}', open);
    const std::string_view token = phrase.substr(open + 1, close - open - 1);
    const std::size_t bar = token.find('|');
    if (token == "l")
      text += left;
    else if (token == "r")
      text += right;
    else if (token == "s")
      text += sign_of_sides(condition);
    else if (token == "*")
      text += any;
    else
      text += left + " " +
              std::string(condition.left == 1 ? token.substr(0, bar) : token.substr(bar + 1));
    at = close + 1;
  }
  return text;
}

}  // namespace detail

CONTACT_SCENES_INLINE std::string condition_text(const Inequality& condition) {
  const bool held = contact::holds(condition);
  std::vector<std::string> parts;
  for (const detail::ConditionPhrase& phrase : detail::condition_phrases) {
    if (!detail::has_words(condition.left_is, phrase.is, parts)) continue;
    const bool bounded = std::isfinite(condition.left) && (std::isfinite(condition.right) || !held);
    const bool other = !bounded && !phrase.unbounded.empty();
    return detail::filled(other ? phrase.unbounded : (held ? phrase.holds : phrase.fails),
                          condition, parts.empty() ? "" : parts.front());
  }
  const auto [left, right] = detail::sides_of(condition);
  if (condition.relation != Relation::equal)
    return condition.left_is + ": " + left + detail::sign_of_sides(condition) + right;
  return condition.left_is + ": " + left + (held ? "" : ", not " + right);
}

CONTACT_SCENES_INLINE std::string reason_text(const Decision& decision) {
  std::vector<std::string> parts;
  for (const detail::ReasonPhrase& phrase : detail::reason_phrases) {
    if (!detail::has_words(decision.why, phrase.why, parts)) continue;
    std::string text(phrase.said);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const std::string token = '{' + std::to_string(k + 1) + '}';
      const std::size_t at = text.find(token);
      if (at != std::string::npos) text.replace(at, token.size(), parts[k]);
    }
    return text;
  }
  const Inequality* decides = nullptr;
  if (decision.proven) {
    // A comparison of two numbers says more than that something is absent.
    for (const Inequality& condition : decision.because) {
      const bool better = condition.relation != Relation::equal && std::isfinite(condition.right) &&
                          (decides == nullptr || decides->relation == Relation::equal);
      if (decides == nullptr || better) decides = &condition;
    }
  } else {
    // What the proof lacks that lacks least.
    std::size_t fewest = 0;
    for (const Proof& proof : decision.tried) {
      const Inequality* first = nullptr;
      std::size_t lacks = 0;
      for (const Inequality& condition : proof.conditions) {
        if (contact::holds(condition)) continue;
        if (first == nullptr) first = &condition;
        ++lacks;
      }
      // That bodies may meet is the least of reasons, where there is another.
      if (first != nullptr && first->left_is == "pairs of bodies that may meet") lacks += 100;
      if (first == nullptr || (decides != nullptr && lacks >= fewest)) continue;
      decides = first;
      fewest = lacks;
    }
    if (decision.value && !decision.because.empty()) {
      decides = &decision.because.back();
      for (const Inequality& condition : decision.because) {
        if (contact::holds(condition)) continue;
        decides = &condition;
        break;
      }
    }
  }
  if (decides != nullptr) return condition_text(*decides);
  return decision.because.empty() ? decision.why : condition_text(decision.because.front());
}

}  // namespace contact::scenes
