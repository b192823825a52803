/// @file
/// Where bodies of several boxes rest on each other: exact answers, and methods as they are often
/// written.
#pragma once

#include <algorithm>
#include <contact/compound_contacts.hpp>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "hard_regions.hpp"
#include "support/hard_cases.hpp"

namespace hard_pieces {

using namespace hard_regions;
using hard_regions::Body;
using hard_regions::Box;
using hard_regions::Hull;

/// "a_pieces": six numbers for each box, its centre and half lengths.
inline std::vector<Body> pieces(const Case& c, const std::string& name) {
  std::vector<Body> all;
  const std::vector<double> numbers = c.numbers(name + "_pieces");
  for (std::size_t i = 0; i + 5 < numbers.size(); i += 6) {
    Box b;
    b.centre = {numbers[i], numbers[i + 1], numbers[i + 2]};
    b.half_lengths = {numbers[i + 3], numbers[i + 4], numbers[i + 5]};
    all.push_back(of_box(b));
  }
  return all;
}

inline contact::CompoundBody<double> compound(const std::vector<Body>& all) {
  contact::CompoundBody<double> body;
  for (const Body& piece : all) {
    Hull hull;
    hull.vertices = piece.vertices;
    body.pieces.push_back(hull);
  }
  return body;
}
/// All vertices of the outline of the points are the wanted ones, and no two points coincide.
inline bool right_pieces(const Case& c, const Found& f, const Json& answer) {
  const double room = 0x1p-20 * c.number("size");
  Points<Rational> exact;
  for (std::size_t i = 0; i < f.at.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (gap(f.at[i], f.at[k]) <= room) return false;
    }
    exact.push_back({oracle::exact(f.at[i][0]), oracle::exact(f.at[i][1])});
  }
  return right(c, {f.normals, simplified(exact, room)}, answer);
}

inline void add(hard_cases::Runner& runner) {
  runner.question("pieces", [](const Case& c) {
    const Side s = side(c);
    const std::vector<Body> on = pieces(c, "b");
    const Body* highest = &on[0];
    for (const Body& b : on) {
      if (top<Rational>(b, s).second > top<Rational>(*highest, s).second) highest = &b;
    }
    Points<Rational> all;
    for (const Body& a : pieces(c, "a")) {
      for (const Body& b : on) {
        if (top<Rational>(b, s).second < top<Rational>(*highest, s).second - Rational(0x1p-20)) {
          continue;
        }
        for (const auto& p : region<Rational>(a, b, s, c.number("margin"))) all.push_back(p);
      }
    }
    return Json{{"class", "a"}, {"at", listed(simplified(all, 0x1p-20 * c.number("size")))}};
  });
  using All = const std::vector<Body>&;
  const auto method = [&runner](const char* name, auto find) {
    runner.method("pieces", name, [find](const Case& c, const Json& answer) {
      return right_pieces(c, find(pieces(c, "a"), pieces(c, "b"), side(c), c.number("margin")),
                          answer);
    });
  };
  const auto pairs = [](All a, All b, double margin) {
    std::vector<Manifold> found;
    for (const Body& one : a) {
      for (const Body& other : b) {
        Manifold m = manifold(one, other, margin);
        if (!m.points.empty()) found.push_back(m);
      }
    }
    return found;
  };
  const auto add = [](Found& f, const Manifold& m, const Side& s, bool once) {
    f.normals.push_back(m.normal);
    for (const auto& p : m.points) {
      const Point<double> here = s.flat<double>(p.point);
      const bool known = std::any_of(f.at.begin(), f.at.end(),
                                     [&](const auto& q) { return gap(here, q) <= 1e-9; });
      if (!once || !known) f.at.push_back(here);
    }
  };
  method("all pairs of pieces", [=](All a, All b, const Side& s, double margin) {
    Found f;
    for (const Manifold& m : pairs(a, b, margin)) add(f, m, s, false);
    return f;
  });
  method("all pairs, equal points once", [=](All a, All b, const Side& s, double margin) {
    Found f;
    for (const Manifold& m : pairs(a, b, margin)) add(f, m, s, true);
    return f;
  });
  method("the deepest pair alone", [=](All a, All b, const Side& s, double margin) {
    Found f;
    const Manifold* best = nullptr;
    double deepest = std::numeric_limits<double>::infinity();
    const std::vector<Manifold> all = pairs(a, b, margin);
    for (const Manifold& m : all) {
      for (const auto& p : m.points) {
        if (p.distance < deepest) best = &m;
        deepest = std::min(deepest, p.distance);
      }
    }
    if (best != nullptr) add(f, *best, s, true);
    return f;
  });
  method("the hull of each body", [=](All a, All b, const Side& s, double margin) {
    const auto whole = [](All all) {
      Body made;
      for (const Body& piece : all) {
        made.vertices.insert(made.vertices.end(), piece.vertices.begin(), piece.vertices.end());
      }
      Hull hull;
      hull.vertices = made.vertices;
      made.shape = hull;
      return made;
    };
    Found f;
    const Manifold m = manifold(whole(a), whole(b), margin);
    if (!m.points.empty()) add(f, m, s, true);
    return f;
  });
  method("book", [=](All a, All b, const Side& s, double margin) {
    Found f;
    for (const auto& pair : contact::compound_contacts(compound(a), compound(b), margin)) {
      add(f, pair.manifold, s, false);
    }
    return f;
  });
}

}  // namespace hard_pieces
