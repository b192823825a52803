/// @file
/// The book's tests of two bounding volumes compared with those of other programs.
#pragma once

#include <algorithm>
#include <array>
#include <contact/aabb.hpp>
#include <contact/ray_kdop.hpp>
#include <contact/slab_volumes.hpp>
#include <contact/volumes_meet.hpp>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "../comparison.hpp"
#include "peers.hpp"
#include "volume_pairs.hpp"
#include "volume_scenes.hpp"

namespace compare_pairs {

using volume_scenes::Point;

// ---------------------------------------------------------------- two volumes

using peers::Answers;
using PairMethod = comparison::Method<Answers>;

/// Says which pairs of volumes may meet.
template <class Volume, class Meet>
PairMethod pair_method(const char* name, const std::vector<std::array<Volume, 2>>& pairs,
                       Meet meet) {
  return {name, [&pairs, meet](Answers& answers) {
            for (std::size_t i = 0; i < pairs.size(); ++i) {
              answers[i] = meet(pairs[i][0], pairs[i][1]) ? 1 : 0;
            }
          }};
}
template <class Volume>
void add(std::vector<PairMethod>& methods, const std::vector<std::array<Volume, 2>>& pairs,
         const std::vector<peers::PairTest<Volume>>& tests) {
  for (const auto& test : tests) methods.push_back({test.name, test.prepare(pairs)});
}

inline void compare_answers(const std::string& title, const std::vector<signed char>& right,
                            const std::vector<PairMethod>& methods, int runs) {
  const auto count = [&right](const Answers& answers, signed char of, char said) {
    std::size_t counted = 0;
    for (std::size_t i = 0; i < right.size(); ++i) counted += right[i] == of && answers[i] == said;
    return counted;
  };
  std::vector<comparison::Fault<Answers>> faults{
      {"missed", [&](const Answers& answers) { return count(answers, 1, 0); }}};
  if (std::count(right.begin(), right.end(), -1) > 0) {
    faults = {{"may meet", [&](const Answers& answers) { return count(answers, -1, 1); }}};
  } else if (std::count(right.begin(), right.end(), 0) > 0) {
    faults.push_back({"invented", [&](const Answers& answers) { return count(answers, 0, 1); }});
  }
  comparison::compare<Answers>(
      title + ", " + std::to_string(right.size()) + " pairs, " +
          std::to_string(std::count(right.begin(), right.end(), 1)) + " surely meet",
      "ns a pair", static_cast<double>(right.size()), methods, faults, runs, Answers(right.size()));
}

template <class Volume, class Draw>
volume_pairs::Pairs<Volume> drawn(std::string title, std::size_t count, std::uint64_t seed,
                                  const Draw& draw) {
  volume_pairs::Pairs<Volume> all{std::move(title), {}, {}};
  generators::Random random(seed);
  for (std::size_t i = 0; i < count; ++i) {
    all.pairs.push_back(draw(random));
    all.right.push_back(volume_pairs::meet(all.pairs.back()) ? 1 : 0);
  }
  return all;
}

inline bool rounded_spheres_meet(const contact::Sphere<double>& a,
                                 const contact::Sphere<double>& b) {
  return (a.centre - b.centre).norm() <= a.radius + b.radius;
}

inline void compare_spheres(std::size_t count, int runs) {
  for (const bool touching : {false, true}) {
    const auto all = drawn<contact::Sphere<double>>(
        touching ? "spheres, touching but for rounding" : "spheres, random", count, 1,
        [touching](auto& random) { return volume_pairs::spheres(random, touching); });
    compare_answers(
        all.title, all.right,
        {pair_method("Contact Hours", all.pairs,
                     [](const auto& a, const auto& b) { return contact::may_meet(a, b); }),
         pair_method("distance, rounded", all.pairs, rounded_spheres_meet)},
        runs);
  }
}

inline void compare_limits(std::size_t count, int runs) {
  for (const bool touching : {false, true}) {
    const auto all = drawn<peers::Limits>(
        touching ? "axis-aligned boxes, touching or an ulp apart" : "axis-aligned boxes, random",
        count, 2, [touching](auto& random) { return volume_pairs::limits(random, touching); });
    std::vector<std::array<contact::Aabb<double>, 2>> boxes;
    const auto vector = [](const peers::Numbers& p) { return Point(p[0], p[1], p[2]); };
    for (const auto& [a, b] : all.pairs) {
      boxes.push_back({{{vector(a.low), vector(a.high)}, {vector(b.low), vector(b.high)}}});
    }
    std::vector<PairMethod> methods{
        pair_method("Contact Hours", boxes,
                    [](const auto& a, const auto& b) { return contact::may_meet(a, b); })};
#ifdef CONTACT_HAS_BULLET
    add(methods, all.pairs, peers::bullet_limits_pairs());
#endif
#ifdef CONTACT_HAS_COAL
    add(methods, all.pairs, peers::coal_limits_pairs());
#endif
    compare_answers(all.title, all.right, methods, runs);
  }
}

inline void compare_boxes(std::size_t count, int runs) {
  using volume_pairs::Contact;
  const std::array<std::pair<Contact, const char*>, 4> families{
      {{Contact::none, "oriented boxes, random"},
       {Contact::corner_on_face, "oriented boxes, a corner on a face but for rounding"},
       {Contact::edge_on_edge, "oriented boxes, an edge on an edge but for rounding"},
       {Contact::parallel, "oriented boxes, parallel, touching but for rounding"}}};
  for (const auto& [how, title] : families) {
    const auto all = drawn<volume_pairs::Box>(
        title, count, 3, [how = how](auto& random) { return volume_pairs::boxes(random, how); });
    std::vector<std::array<peers::Box, 2>> plain;
    for (const auto& [a, b] : all.pairs) {
      plain.push_back({volume_pairs::plain(a), volume_pairs::plain(b)});
    }
    std::vector<PairMethod> methods{
        pair_method("Contact Hours", all.pairs,
                    [](const auto& a, const auto& b) { return contact::may_meet(a, b); })};
#ifdef CONTACT_HAS_COAL
    add(methods, plain, peers::coal_box_pairs());
#endif
    compare_answers(all.title, all.right, methods, runs);
  }
}

inline void compare_slabs(std::size_t count, int runs) {
  for (const bool touching : {false, true}) {
    const std::string title = touching ? "k-DOPs of bodies with a common point of two edges"
                                       : "k-DOPs of bodies of 20 points, random";
    generators::Random random(4);
    std::vector<std::array<peers::Points, 2>> plain;
    std::array<std::vector<std::array<contact::Kdop<double>, 2>>, 3> dops;
    constexpr std::array<int, 3> sizes{14, 18, 26};
    for (std::size_t i = 0; i < count; ++i) {
      const auto pair = volume_pairs::bodies(random, touching);
      plain.push_back({volume_pairs::plain(pair[0]), volume_pairs::plain(pair[1])});
      for (std::size_t k = 0; k < sizes.size(); ++k) {
        const auto normals = contact::kdop_normals<double>(sizes[k]);
        dops[k].push_back({contact::kdop_of_points<double>(normals, pair[0]),
                           contact::kdop_of_points<double>(normals, pair[1])});
      }
    }
    constexpr std::array<const char*, 3> names{"Contact Hours, 14-DOP", "Contact Hours, 18-DOP",
                                               "Contact Hours, 26-DOP"};
    std::vector<PairMethod> methods;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      methods.push_back(pair_method(
          names[k], dops[k], [](const auto& a, const auto& b) { return contact::may_meet(a, b); }));
    }
#ifdef CONTACT_HAS_COAL
    add(methods, plain, peers::coal_kdop_pairs());
#endif
    compare_answers(title, std::vector<signed char>(count, touching ? 1 : -1), methods, runs);
  }
}

}  // namespace compare_pairs
