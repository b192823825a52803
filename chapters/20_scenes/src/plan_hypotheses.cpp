#include <contact/plan/plan_hypotheses.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <contact/invalid_argument.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/scene/compiled.hpp>

namespace contact {

namespace detail {

inline constexpr std::array<ProofClaim, 9> claim_table{{
    {"weightless", "No force presses bodies together, so a lasting contact carries no force."},
    {"only-springs",
     "Bodies that never touch, or only through springs, never rest on a hard contact."},
    {"elastic-balls",
     "Elastic balls leave with the normal speed with which they came. It is 0 only in a graze, and "
     "then no force presses them together."},
    {"last-bounce",
     "The bounces on a half-space end at t₁ + 2 e w/(g (1 − e)), and the scene ends before."},
    {"one-contact",
     "A ball touches another body at one point; with one partner it has one contact."},
    {"mirror",
     "The laws of motion are symmetric under reflection: a scene that is its own mirror "
     "image stays so, and nothing moves along that axis."},
    {"flat-walls", "Flat walls do not spread neighbouring paths; rounding errors only add up."},
    {"one-line", "On a line no hit spreads paths; rounding errors only add up."},
    {"first-hits", "Until the horizon an ulp does not grow to the tolerance."},
}};

// [hypotheses]
inline constexpr std::array<Hypothesis, 35> hypothesis_table{{
    {"weightless/no-gravity", "gravity that no table cancels", Relation::equal, "none", "m/s²",
     "Gravity presses a ball on its floor.", "ball_on_floor"},
    {"weightless/no-turning-shapes",
     "moving bodies other than balls that may rotate and touch something", Relation::equal, "none",
     "", "A rod that rotates pushes a ball along its side.", "rod_pushes_ball"},
    {"weightless/no-springs", "compliant pairs that may meet", Relation::equal, "none", "",
     "A soft ball presses a hard one against a wall for half an oscillation.", "spring_presses"},
    {"only-springs/no-hard-pairs", "hard contacts that may occur", Relation::equal, "none", "",
     "A hard floor carries a ball's weight.", "ball_on_floor"},
    {"elastic-balls/elastic", "largest loss of speed, 1 − e, between bodies that may meet",
     Relation::equal, "elastic", "", "With e < 1 the bounces on a floor end.", "lossy_bounces"},
    {"elastic-balls/only-balls", "pairs that may meet other than balls and half-spaces",
     Relation::equal, "none", "",
     "A box has several contacts. No scene: bodies of other shapes never count as apart, so the "
     "next hypothesis fails too.",
     ""},
    {"elastic-balls/apart", "kinds of pairs that touch at the beginning and do not separate",
     Relation::equal, "none", "", "An elastic ball that lies on a floor stays there.",
     "elastic_ball_on_floor"},
    {"elastic-balls/smooth-beside-others",
     "pairs with friction, where a body may meet several or a fixed ball", Relation::equal, "none",
     "",
     "What is normal at one wall of a V is tangential at the other, where friction takes it: the "
     "bounces end.",
     "rough_v"},
    {"elastic-balls/no-springs", "compliant pairs that may meet beside hard ones", Relation::equal,
     "none", "", "The damper of a soft ball takes the energy of the elastic one under it.",
     "damped_on_elastic"},
    {"elastic-balls/no-fixed-balls", "fixed balls that may be met while gravity acts",
     Relation::equal, "none", "",
     "A ball that rises and grazes a fixed one with v² = g R cos θ is then pressed onto it.",
     "graze_then_press"},
    {"last-bounce/ends-before", "duration", Relation::less,
     "earliest time at which a ball can rest", "s", "After its last bounce a ball rests.",
     "lossy_bounces"},
    {"last-bounce/one-partner", "most bodies that one moving body may touch", Relation::at_most,
     "one", "", "A ceiling takes speed too, so the ball rests earlier.", "under_a_ceiling"},
    {"last-bounce/only-half-spaces",
     "pairs that may meet other than balls that move, or a ball and a hard half-space",
     Relation::equal, "none", "", "The formula is not that of a ball on a box.", "ball_on_box"},
    {"last-bounce/apart", "balls that touch a half-space at the beginning and do not separate",
     Relation::equal, "none", "",
     "A ball that starts an ulp too deep may be too slow to come out of the floor.", "an_ulp_deep"},
    {"one-contact/one-partner", "most bodies that one moving body may touch", Relation::at_most,
     "one contact", "", "A ball is hit from both sides at the same instant.",
     "hit_from_both_sides"},
    {"one-contact/only-balls", "moving bodies other than balls that may touch something",
     Relation::equal, "none", "", "A box lands on four vertices at once.", "four_vertices"},
    {"mirror/no-gravity", "gravity along the axis", Relation::equal, "none", "m/s²",
     "Gravity moves bodies along the axis.", "falls_out_of_plane"},
    {"mirror/no-velocity", "fastest motion along the axis at the beginning", Relation::equal,
     "none", "m/s", "It moves along the axis already.", "flies_out_of_plane"},
    {"mirror/no-rotation", "largest angular velocity about another axis", Relation::equal, "none",
     "rad/s", "Friction on a floor turns rotation into motion along the axis.",
     "rolls_out_of_plane"},
    {"mirror/mirrored-shapes", "bodies or pairs not their own mirror image", Relation::equal,
     "none", "", "An oblique wall reflects along the axis.", "oblique_wall"},
    {"mirror/common-plane", "farthest that centres of bodies that may meet differ along the axis",
     Relation::equal, "one common plane", "m", "A hit above the centre deflects along the axis.",
     "off_centre"},
    {"flat-walls/no-round-pairs", "pairs that may meet and of which none is a half-space",
     Relation::equal, "none", "", "A round post spreads paths like a lens.", "ball_among_posts"},
    {"flat-walls/no-turning-shapes",
     "moving bodies other than balls that rotate and may touch "
     "something",
     Relation::equal, "none", "", "A die may land on another vertex than its twin.", "elastic_die"},
    {"flat-walls/level-walls", "half-spaces neither horizontal nor vertical, beside others",
     Relation::equal, "none", "",
     "A ball that falls between two slopes comes back beside its last position.", "two_slopes"},
    {"flat-walls/smooth-beside-others", "pairs with friction, where a body may meet several",
     Relation::equal, "none", "",
     "In a corner with friction, also a square one, the order of hits decides.", "rough_corner"},
    {"flat-walls/no-springs-beside-others", "compliant pairs, where a body may meet several",
     Relation::equal, "none", "",
     "Between soft walls two may push at once, and for how long depends on the path.",
     "soft_triangle"},
    {"flat-walls/square-corners",
     "pairs of half-spaces at an angle that a body at both may leave in two directions",
     Relation::equal, "none", "",
     "In a corner, which wall is first decides, unless its angle divides π and no speed is lost.",
     "into_a_corner"},
    {"flat-walls/no-grazed-ceiling",
     "balls that rise to within 1 % of the energy at which they graze a ceiling", Relation::equal,
     "none", "", "A bounce that grazes a ceiling is shorter by the root of an ulp.",
     "grazes_a_ceiling"},
    {"one-line/one-falls", "moving bodies that fall and bounce on the line", Relation::at_most,
     "one alone", "", "Two different masses that bounce on each other and a floor spread paths.",
     "two_fall_on_a_line"},
    {"one-line/no-springs-beside-others", "compliant pairs, where a body may meet several",
     Relation::equal, "none", "", "Five soft balls between two soft walls spread paths.",
     "five_soft_balls"},
    {"one-line/equal-or-alone",
     "bodies that two others may hit at one instant, of different masses or with 0 < e < 1",
     Relation::equal, "none", "",
     "Which of two hits is first decides. (Equal elastic balls exchange velocities, so their order "
     "does not matter; with e = 0 all stay together.)",
     "three_masses_at_once"},
    {"one-line/no-grazed-ceiling",
     "bodies that rise to within 1 % of the energy at which they graze a ceiling", Relation::equal,
     "none", "", "A bounce that grazes a ceiling is shorter by the root of an ulp.",
     "grazes_a_ceiling"},
    {"first-hits/obliqueness",
     "growth of an ulp in the most oblique first hit, compared with 1/cos θ = 2", Relation::at_most,
     "included in the horizon", "",
     "A hit that grazes a post spreads two paths by the root of an ulp.", "grazes_a_post"},
    {"first-hits/not-at-once", "first hits of one body at the same instant", Relation::equal,
     "none before the horizon", "", "Which of two hits is first decides.", "two_posts_at_once"},
    {"first-hits/typical", "hits after the first ones that are more oblique than on average",
     Relation::equal, "none", "",
     "A later hit may graze: beyond one hit the horizon is an estimate and the plan says so. No "
     "scene: nothing is claimed.",
     ""},
}};
// [/hypotheses]

}  // namespace detail

CONTACT_SCENES_INLINE std::span<const ProofClaim> proof_claims() { return detail::claim_table; }

CONTACT_SCENES_INLINE std::span<const Hypothesis> proof_hypotheses() {
  return detail::hypothesis_table;
}

CONTACT_SCENES_INLINE std::string proof_claim(std::string_view id) {
  for (const ProofClaim& one : detail::claim_table) {
    if (one.id == id) return std::string(one.claim);
  }
  throw_invalid_argument("proof", std::string(id), "is not in the table");
}

CONTACT_SCENES_INLINE const Hypothesis& proof_hypothesis(std::string_view id) {
  for (const Hypothesis& one : detail::hypothesis_table) {
    if (one.id == id) return one;
  }
  throw_invalid_argument("hypothesis", std::string(id), "is not in the table");
}

// [required]
CONTACT_SCENES_INLINE Inequality required(std::string_view id, double left, double right,
                                          const std::vector<std::string>& dropped) {
  const Hypothesis& one = proof_hypothesis(id);
  Inequality condition{
      std::string(one.condition), left,  one.relation, right, std::string(one.right_is),
      std::string(one.unit),      one.id};
  if (std::find(dropped.begin(), dropped.end(), id) == dropped.end()) return condition;
  condition.relation = Relation::at_most;
  condition.right = std::numeric_limits<double>::infinity();
  condition.right_is = "dropped";
  return condition;
}
// [/required]

}  // namespace contact
