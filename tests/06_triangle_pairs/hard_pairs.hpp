/// @file
/// The hard cases of whether two triangles meet: questions and methods.
#pragma once

#include <06_triangle_pairs/pair_truth.hpp>
#include <array>
#include <concepts>
#include <contact/drop_dimension.hpp>
#include <contact/orientation.hpp>
#include <contact/pair_methods.hpp>
#include <contact/pair_orientations.hpp>
#include <contact/triangles_meet.hpp>
#include <string>
#include <support/generators.hpp>
#include <support/hard_cases.hpp>

namespace hard_pairs {

using contact::Triangle;
using contact::Vector2;
using hard_cases::Case;
using hard_cases::Json;

// ---------------------------------------------------------------- input

template <std::floating_point S>
struct Pair {
  Triangle<S> first, second;
};
template <std::floating_point S>
Pair<S> pair_of(const Case& c) {
  return {generators::rounded<S>(c.triangle("first")),
          generators::rounded<S>(c.triangle("second"))};
}
/// A method in S answers cases whose input S can store.
template <std::floating_point S>
bool applies(const Case& c) {
  return std::same_as<S, double> || c.type() == "float";
}

/// A triangle with its vertices in the six orders.
template <std::floating_point S>
std::array<Triangle<S>, 6> orders(const Triangle<S>& t) {
  const auto& [a, b, c] = t;
  return {{{a, b, c}, {b, c, a}, {c, a, b}, {c, b, a}, {b, a, c}, {a, c, b}}};
}
/// Whether a method gives one answer for all 72 orders of the vertices and of the triangles.
template <std::floating_point S, class Meet>
bool in_all_orders(const Pair<S>& pair, const Meet& meet, bool answer) {
  for (const Triangle<S>& t : orders(pair.first)) {
    for (const Triangle<S>& u : orders(pair.second)) {
      if (meet(t, u) != answer || meet(u, t) != answer) return false;
    }
  }
  return true;
}

// ---------------------------------------------------------------- a rule as printed

/// Guigue and Devillers' decision in the plane with one rule as in their paper: where p₁ is beyond
/// both edges at r₂, the last test of one branch is [r₂, p₂, r₁] ≥ 0 instead of [q₁, r₁, p₂] ≥ 0.
/// All orientations are exact, so only the rule is wrong.
///
/// Source: https://github.com/llnl/axom/pull/273
namespace as_printed {

using P = Vector2<double>;
/// Counter-clockwise.
struct Flat {
  P p, q, r;
};

/// [a, b, c] ≥ 0.
inline bool left(const P& a, const P& b, const P& c) { return contact::orient_2d(a, b, c) >= 0; }
inline bool right(const P& a, const P& b, const P& c) { return contact::orient_2d(a, b, c) <= 0; }

/// p₁ is beyond the edge from r₂ to p₂.
inline bool beyond_edge(const Flat& s, const Flat& t) {
  if (left(t.r, t.p, s.q)) {
    if (left(s.p, t.p, s.q)) return left(s.p, s.q, t.r);
    return left(s.q, s.r, t.p) && left(s.r, s.p, t.p);
  }
  return left(t.r, t.p, s.r) && left(s.p, t.p, s.r) && (left(s.p, s.r, t.r) || left(s.q, s.r, t.r));
}
/// p₁ is beyond both edges at r₂.
inline bool beyond_vertex(const Flat& s, const Flat& t) {
  if (left(t.r, t.p, s.q)) {
    if (!right(t.r, t.q, s.q)) {
      return right(s.p, t.q, s.q) && right(t.r, t.q, s.r) && left(s.q, s.r, t.q);
    }
    if (!right(s.p, t.p, s.q)) return right(s.p, t.q, s.q);
    return left(s.p, t.p, s.r) && left(t.r, t.p, s.r);  // should be left(s.q, s.r, t.p)
  }
  if (!left(t.r, t.p, s.r)) return false;
  if (left(s.q, s.r, t.r)) return left(s.p, t.p, s.r);
  return left(s.q, s.r, t.q) && left(t.r, s.r, t.q);
}
inline bool in_plane(const Flat& s, const Flat& t) {
  const bool pq = left(t.p, t.q, s.p), qr = left(t.q, t.r, s.p), rp = left(t.r, t.p, s.p);
  const Flat from_q{t.q, t.r, t.p}, from_r{t.r, t.p, t.q};
  if (pq && qr) return rp || beyond_edge(s, t);
  if (pq) return rp ? beyond_edge(s, from_r) : beyond_vertex(s, t);
  if (!qr) return beyond_vertex(s, from_r);
  return rp ? beyond_edge(s, from_q) : beyond_vertex(s, from_q);
}

/// Triangles with area in one plane by these rules, all others by the book.
inline bool meet(const Triangle<double>& first, const Triangle<double>& second) {
  const auto view = contact::flat_view(second.a, second.b, second.c);
  const auto flat = [&view](const Triangle<double>& t) -> Flat {
    const auto drop = [&](const contact::Vector3<double>& v) {
      return contact::drop_dimension<double>(v, view.dropped);
    };
    const bool turns_left = contact::orient_2d(drop(t.a), drop(t.b), drop(t.c)) > 0;
    if (turns_left) return {drop(t.a), drop(t.b), drop(t.c)};
    return {drop(t.a), drop(t.c), drop(t.b)};
  };
  const auto on_plane = [&](const contact::Vector3<double>& v) {
    return contact::orient_3d(second.a, second.b, second.c, v) == 0;
  };
  const bool coplanar = view.orientation != 0 && on_plane(first.a) && on_plane(first.b) &&
                        on_plane(first.c) && !contact::are_collinear(first.a, first.b, first.c);
  if (!coplanar) return contact::triangles_meet(first, second);
  return in_plane(flat(first), flat(second));
}

}  // namespace as_printed

// ---------------------------------------------------------------- questions

/// Adds a method to both questions: the order as given, and all orders.
template <std::floating_point S, class Meet>
void add_method(hard_cases::Runner& runner, const std::string& name, const Meet& meet) {
  runner.method("pair", name, applies<S>, [meet](const Case& c, const Json& answer) {
    const Pair<S> pair = pair_of<S>(c);
    return meet(pair.first, pair.second) == answer.at("meet").get<bool>();
  });
  runner.method("orders", name, applies<S>, [meet](const Case& c, const Json& answer) {
    return in_all_orders(pair_of<S>(c), meet, answer.at("meet").get<bool>());
  });
}

template <std::floating_point S>
void add_rounded_methods(hard_cases::Runner& runner, const std::string& type) {
  using T = Triangle<S>;
  add_method<S>(runner, "steps, " + type,
                [](const T& t, const T& u) { return contact::meet_by_steps(t, u).meet; });
  add_method<S>(runner, "intervals, " + type,
                [](const T& t, const T& u) { return contact::meet_by_intervals(t, u); });
  add_method<S>(runner, "intervals within 1e-6, " + type,
                [](const T& t, const T& u) { return contact::meet_by_intervals(t, u, S(1e-6)); });
  add_method<S>(runner, "edges, " + type,
                [](const T& t, const T& u) { return contact::meet_by_edges(t, u); });
  add_method<S>(runner, "axes, " + type,
                [](const T& t, const T& u) { return contact::meet_by_axes(t, u); });
  add_method<S>(runner, "orientations, " + type,
                [](const T& t, const T& u) { return contact::meet_by_orientations(t, u); });
}

/// Adds them to a runner.
inline void add_questions(hard_cases::Runner& runner) {
  for (const char* question : {"pair", "orders"}) {
    runner.question(question, [](const Case& c) -> Json {
      return {{"class", "a"},
              {"meet", pair_truth::meet_exactly(c.triangle("first"), c.triangle("second"))}};
    });
  }
  add_rounded_methods<float>(runner, "float");
  add_rounded_methods<double>(runner, "double");
  add_method<double>(
      runner, "orientations, a rule as printed",
      [](const Triangle<double>& t, const Triangle<double>& u) { return as_printed::meet(t, u); });
  // Both types, where the input has both.
  const auto book = [](const Case& c, bool meet) {
    const auto decides = [](const auto& t, const auto& u) { return contact::triangles_meet(t, u); };
    return in_all_orders(pair_of<double>(c), decides, meet) &&
           (c.type() == "double" || in_all_orders(pair_of<float>(c), decides, meet)) &&
           contact::triangles_meet_unfiltered(c.triangle("first"), c.triangle("second")) == meet;
  };
  for (const char* question : {"pair", "orders"}) {
    runner.method(question, "the book, exact", [book](const Case& c, const Json& answer) {
      return book(c, answer.at("meet").get<bool>());
    });
  }
}

}  // namespace hard_pairs
