#include <contact/plan/plan_rules.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <contact/aabb.hpp>
#include <contact/broad_phase_cost.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/plan/plan_costs.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <contact/vector.hpp>

namespace contact {

// [grid-cost]
CONTACT_SCENES_INLINE PairSearchCost pair_search_cost(std::span<const Aabb<double>> boxes) {
  PairSearchCost of;
  const BoxProfile profile = profile_of(boxes);
  of.all = cost::box_test * static_cast<double>(pair_count(profile.count));
  of.cells = cost::grid;
  if (boxes.empty()) return of;
  const double edge = grid_for(boxes).cell_edge;
  const double entries = std::min(expected_grid_entries(profile, edge),
                                  static_cast<double>(profile.count * max_cells_of_a_box));
  const double depth = sorting_depth(static_cast<std::uint64_t>(entries));
  // Of pairs closer than an edge, about half share a cell.
  of.cells += cost::grid_sorting * entries * (1 + depth / 2);
  of.cells += cost::box_test * sampled_pairs(boxes, edge) / 2;
  return of;
}
// [/grid-cost]

namespace detail {

CONTACT_SCENES_INLINE std::vector<Aabb<double>> first_boxes(const Scene& scene, double h) {
  std::vector<Aabb<double>> boxes;
  for (const SceneBody& body : scene.bodies) {
    if (is_half_space(body)) continue;
    const Vector3<double> reach = Vector3<double>::Constant(outer_radius(body.shape));
    Vector3<double> end = body.position;
    if (body.moves) end += body.velocity * h;
    boxes.push_back({body.position.cwiseMin(end) - reach, body.position.cwiseMax(end) + reach});
    const double size =
        std::max(boxes.back().low.cwiseAbs().maxCoeff(), boxes.back().high.cwiseAbs().maxCoeff());
    if (!(size < 0x1p300)) return {};
  }
  const auto key = [](const Aabb<double>& box) {
    return std::array{box.low.x(),  box.low.y(),  box.low.z(),
                      box.high.x(), box.high.y(), box.high.z()};
  };
  std::sort(boxes.begin(), boxes.end(),
            [&](const Aabb<double>& a, const Aabb<double>& b) { return key(a) < key(b); });
  return boxes;
}

}  // namespace detail

/// A broad phase never changes a result, so this is a question of cost alone: of comparing all
/// bounding boxes of the bodies' paths, or of sorting them into cells and comparing neighbours. In
/// an event-driven run a ball is tested twice after each hit, and cells cost a crossing now and
/// then: few balls test all others.
CONTACT_SCENES_INLINE Decision plan_broad_phase(const PlanInput& q) {
  // [broad-phase-rule]
  const std::string why =
      "A broad phase changes no result; it is left out where it costs more than it saves.";
  Proof few{why, {}};
  if (q.events) {
    double balls = 0;
    for (const SceneBody& body : q.scene->bodies) balls += is_half_space(body) ? 0 : 1;
    few.conditions = {{"balls", balls, Relation::at_most, double{cost::max_balls_without_cells},
                       "that test all others at less cost", ""}};
  } else {
    const PairSearchCost search = pair_search_cost(detail::first_boxes(*q.scene, q.step));
    few.conditions = {{"instructions to compare every pair", search.all, Relation::at_most,
                       search.cells,
                       "instructions to sort bodies into cells and compare neighbours", ""}};
  }
  return decide(Effect::broad_phase,
                {few, {"Where nothing can meet, there is no pair to test.", {nothing_meets(q)}}},
                "Sorting bodies into cells costs less than testing every pair.");
  // [/broad-phase-rule]
}

}  // namespace contact
