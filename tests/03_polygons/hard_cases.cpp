// Recomputes the answers of hard_cases.json and checks which methods are right in which case.
#include "support/hard_cases.hpp"

#include <03_polygons/reference.hpp>
#include <cmath>
#include <contact/convex_polygon.hpp>
#include <limits>

using hard_cases::Case;
using hard_cases::Json;

namespace {

using namespace polygons;
using contact::PolygonWithHoles;
using contact::Segment;
using contact::SegmentCrossing;
using contact::SpacePolygon;

// ---------------------------------------------------------------- input

template <class S = double>
Polygon<S> polygon_of(const Case& c, const std::string& field = "polygon") {
  const std::vector<double> numbers = c.numbers(field);
  Polygon<S> polygon;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
    polygon.push_back({static_cast<S>(numbers[i]), static_cast<S>(numbers[i + 1])});
  }
  return polygon;
}
template <class S = double>
Vector2<S> point_of(const Case& c) {
  return polygon_of<S>(c, "point").at(0);
}
template <class S = double>
Segment2<S> segment_of(const Case& c, const std::string& field) {
  const Polygon<S> ends = polygon_of<S>(c, field);
  return {ends.at(0), ends.at(1)};
}
template <class S = double>
SpacePolygon<S> space_polygon_of(const Case& c, const std::string& field) {
  const std::vector<double> numbers = c.numbers(field);
  SpacePolygon<S> polygon;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    polygon.push_back({static_cast<S>(numbers[i]), static_cast<S>(numbers[i + 1]),
                       static_cast<S>(numbers[i + 2])});
  }
  return polygon;
}
Rule rule_of(const Case& c) { return c.has("non_zero") ? Rule::non_zero : Rule::even_odd; }

// ---------------------------------------------------------------- answers

std::string text(Where where) {
  return where == Where::inside ? "inside" : where == Where::on ? "on" : "outside";
}
std::string text(Meeting meeting) {
  switch (meeting) {
    case Meeting::none:
      return "none";
    case Meeting::crossing:
      return "crossing";
    case Meeting::touching:
      return "touching";
    case Meeting::overlapping:
      break;
  }
  return "overlapping";
}

Json where_answer(const Case& c) {
  const Exact2 p = exact(point_of(c));
  Where found = where(exact(polygon_of(c)), p, rule_of(c));
  if (found == Where::inside && c.has("hole")) {
    const Where hole = where(exact(polygon_of(c, "hole")), p, rule_of(c));
    found = hole == Where::inside ? Where::outside : hole == Where::on ? Where::on : Where::inside;
  }
  return {{"class", "a"}, {"where", text(found)}};
}

Json meeting_answer(const Case& c) {
  return {{"class", "a"},
          {"meeting", text(common(segment_of(c, "first"), segment_of(c, "second")).meeting)}};
}

Json point_answer(const Case& c) {
  const Common found = common(segment_of(c, "first"), segment_of(c, "second"));
  return {{"class", "a"},
          {"x", hard_cases::hex(oracle::nearest(found.first.x()))},
          {"y", hard_cases::hex(oracle::nearest(found.first.y()))}};
}

/// The common segment, or nothing.
Json overlap_answer(const Case& c) {
  const Common found = common(segment_of(c, "first"), segment_of(c, "second"));
  Json answer{{"class", "a"}, {"meeting", text(found.meeting)}};
  if (found.meeting == Meeting::none) return answer;
  for (const auto& [name, point] : {std::pair{"from", found.first}, std::pair{"to", found.last}}) {
    answer[name] = Json::array(
        {hard_cases::hex(oracle::nearest(point.x())), hard_cases::hex(oracle::nearest(point.y()))});
  }
  return answer;
}

Json edges_answer(const Case& c) {
  const Segment2<double> path = segment_of(c, "path");
  const auto edges = contact::perimeter_segments(polygon_of(c));
  std::vector<int> met;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (common(path, edges[i]).meeting != Meeting::none) met.push_back(static_cast<int>(i));
  }
  return {{"class", "a"}, {"edges", met}};
}

/// The face of least penetration, in fractions: squares of depths are compared.
Json face_answer(const Case& c) {
  const ExactPolygon first = exact(polygon_of(c, "first")), second = exact(polygon_of(c, "second"));
  std::vector<bool> hit_first(first.size(), false), hit_second(second.size(), false);
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t j = 0; j < second.size(); ++j) {
      const Common found = common(first[i], first[(i + 1) % first.size()], second[j],
                                  second[(j + 1) % second.size()]);
      if (found.meeting == Meeting::none) continue;
      hit_first[i] = hit_second[j] = true;
    }
  }
  std::optional<Rational> least;
  Json answer{{"class", "a"}};
  for (const bool of_first : {false, true}) {
    const ExactPolygon &own = of_first ? first : second, &other = of_first ? second : first;
    const std::vector<bool>& other_hit = of_first ? hit_second : hit_first;
    std::vector<Exact2> points;
    for (std::size_t i = 0; i < other.size(); ++i) {
      const bool end = other_hit[i] || other_hit[(i + other.size() - 1) % other.size()];
      if (end || where(own, other[i], Rule::even_odd) != Where::outside) {
        points.push_back(other[i]);
      }
    }
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (!(of_first ? hit_first : hit_second)[i]) continue;
      const Exact2 edge = own[(i + 1) % own.size()] - own[i];
      Rational depth = 0;
      for (const Exact2& p : points) {
        depth = std::max<Rational>(depth, cross(edge, p - own[i]));
      }
      const Rational squared = depth * depth / edge.dot(edge);
      if (least && squared >= *least) continue;
      least = squared;
      answer["face_of"] = of_first ? "first" : "second";
      answer["edge"] = i;
    }
  }
  return answer;
}

Json space_answer(const Case& c) {
  const SpacePolygon<double> polygon = space_polygon_of(c, "polygon");
  const SpacePolygon<double> ends = space_polygon_of(c, "path");
  std::vector<oracle::Vector> v;
  for (const auto& x : polygon) v.push_back(oracle::exact(x));
  const oracle::Vector start = oracle::exact(ends.at(0)), along = oracle::exact(ends.at(1)) - start;
  oracle::Vector normal(0, 0, 0);
  for (std::size_t i = 0; i < v.size(); ++i) normal += v[i].cross(v[(i + 1) % v.size()]);
  const Rational from = normal.dot(start - v[0]), to = normal.dot(start + along - v[0]);
  Where found = Where::outside;
  if (oracle::sign(from) * oracle::sign(to) <= 0 && from != to) {
    const oracle::Vector axis = along.x() != 0 ? oracle::Vector(0, 0, 1) : oracle::Vector(1, 0, 0);
    const oracle::Vector right = along.cross(axis), up = along.cross(right);
    ExactPolygon view;
    for (const auto& x : v) view.push_back({right.dot(x - start), up.dot(x - start)});
    found = where(view, Exact2(0, 0), Rule::even_odd);
  }
  return {{"class", "a"}, {"where", text(found)}};
}

// ---------------------------------------------------------------- methods

/// Adds a method of points in polygons: method(polygon, point, rule) in the arithmetic of S.
template <class S, class Method>
void point_method(hard_cases::Runner& runner, const std::string& question, const std::string& name,
                  Method method) {
  runner.method(question, name, [method](const Case& c, const Json& answer) {
    const Vector2<S> p = point_of<S>(c);
    Where found = method(polygon_of<S>(c), p, rule_of(c));
    if (found == Where::inside && c.has("hole")) {
      const Where hole = method(polygon_of<S>(c, "hole"), p, rule_of(c));
      found = hole == Where::inside ? Where::outside
              : hole == Where::on   ? Where::on
                                    : Where::inside;
    }
    return answer.at("where") == text(found);
  });
}

/// Bisection with rounded orientations.
Where rounded_bisection(const Polygon<double>& polygon, const Vector2<double>& p) {
  const std::size_t n = polygon.size();
  std::size_t low = 1, high = n - 1;
  const auto side_of = [&](std::size_t i) {
    return contact::orientation<double>(polygon[0], polygon[i], p);
  };
  if (side_of(1) < 0 || side_of(n - 1) > 0) return Where::outside;
  while (low + 1 < high) {
    const std::size_t middle = (low + high) / 2;
    (side_of(middle) >= 0 ? low : high) = middle;
  }
  const double beyond = contact::orientation<double>(polygon[low], polygon[high], p);
  if (beyond < 0) return Where::outside;
  const bool on =
      beyond == 0 || (low == 1 && side_of(1) == 0) || (high == n - 1 && side_of(high) == 0);
  return on ? Where::on : Where::inside;
}

/// Edge tests that count a distance below a tolerance as on.
Where edges_with_tolerance(const Polygon<double>& polygon, const Vector2<double>& p) {
  constexpr double tolerance = 1e-9;
  Where found = Where::inside;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2<double>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double distance = contact::orientation<double>(a, b, p) / (b - a).norm();
    if (!(distance >= -tolerance)) return Where::outside;
    if (distance <= tolerance) found = Where::on;
  }
  return found;
}

/// Parameters with a tolerance on the range and on the denominator.
bool meet_with_tolerance(const Segment2<double>& s, const Segment2<double>& t) {
  constexpr double tolerance = 1e-9;
  const Vector2<double> along_s = s.b - s.a, along_t = t.b - t.a, between = t.a - s.a;
  const double denominator = contact::cross2<double>(along_s, along_t);
  if (std::abs(denominator) < tolerance) return false;
  const double f = contact::cross2<double>(between, along_t) / denominator;
  const double g = contact::cross2<double>(between, along_s) / denominator;
  return f >= -tolerance && f <= 1 + tolerance && g >= -tolerance && g <= 1 + tolerance;
}

/// Whether a coordinate is at most one ulp from the right one.
bool near_in_place(double got, const Json& right) {
  const double x = hard_cases::unhex(right);
  return std::abs(got - x) <= contact::ulp(x);
}

bool right_overlap(const SegmentCrossing<double>& found, const Json& answer) {
  if (answer.at("meeting") != text(found.meeting)) return false;
  if (found.meeting == Meeting::none) return true;
  const auto same = [](const Vector2<double>& p, const Json& q) {
    return p.x() == hard_cases::unhex(q.at(0)) && p.y() == hard_cases::unhex(q.at(1));
  };
  return same(found.overlap.a, answer.at("from")) && same(found.overlap.b, answer.at("to"));
}

/// What programs do that solve a + t (b − a) = c + u (d − c) by division and treat parallel
/// segments by comparing slopes and the ranges of x: y is not compared.
SegmentCrossing<double> overlap_by_slopes(const Segment2<double>& s, const Segment2<double>& t) {
  SegmentCrossing<double> found;
  const auto slope = [](const Segment2<double>& u) {
    return (u.b.y() - u.a.y()) / (u.b.x() - u.a.x());
  };
  const auto offset = [&slope](const Segment2<double>& u) { return u.a.y() - slope(u) * u.a.x(); };
  if (slope(s) != slope(t)) {
    if (const auto p = contact::crossing_by_slopes(s, t)) {
      const bool end = *p == s.a || *p == s.b || *p == t.a || *p == t.b;
      found.meeting = end ? Meeting::touching : Meeting::crossing;
      found.overlap = {*p, *p};
    }
    return found;
  }
  if (offset(s) != offset(t)) return found;
  const double low = std::max(std::min(s.a.x(), s.b.x()), std::min(t.a.x(), t.b.x()));
  const double high = std::min(std::max(s.a.x(), s.b.x()), std::max(t.a.x(), t.b.x()));
  if (low > high) return found;
  found.meeting = low == high ? Meeting::touching : Meeting::overlapping;
  const auto at = [&](double x) { return Vector2<double>(x, slope(s) * x + offset(s)); };
  found.overlap = {at(low), at(high)};
  if (s.a.x() > s.b.x()) std::swap(found.overlap.a, found.overlap.b);
  return found;
}

/// Adds a rule for the normal: right if it gives the face's normal at every pair of edges that
/// meet.
template <class Rule_>
void normal_method(hard_cases::Runner& runner, const std::string& name, Rule_ rule) {
  runner.method("face", name, [rule](const Case& c, const Json& answer) {
    const Polygon<double> first = polygon_of(c, "first"), second = polygon_of(c, "second");
    const auto contact = contact::perimeter_contact(first, second);
    const bool of_first = answer.at("face_of") == "first";
    const auto& edges = of_first ? contact.first : contact.second;
    const Vector2<double> outward =
        contact::right_normal(edges[answer.at("edge").get<std::size_t>()]);
    const Vector2<double> right = of_first ? Vector2<double>(-outward) : outward;
    bool all = true;
    for (const auto& hit : contact.found.hits) {
      all = all && rule(contact, hit).dot(right) > 1 - 1e-9;
    }
    return all;
  });
}

template <class S, class Method>
void space_method(hard_cases::Runner& runner, const std::string& name, Method method) {
  runner.method("wall", name, [method](const Case& c, const Json& answer) {
    const SpacePolygon<S> ends = space_polygon_of<S>(c, "path");
    const auto hit = method(Segment<S>{ends.at(0), ends.at(1)}, space_polygon_of<S>(c, "polygon"));
    return answer.at("where") == text(hit ? hit->where : Where::outside);
  });
}

template <class S>
Json meeting_text(const Segment2<S>& s, const Segment2<S>& t) {
  return text(contact::meet_rounded<S>(s, t));
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("03_polygons");

  runner.question("point_in_polygon", where_answer);
  const std::string points = "point_in_polygon";
  point_method<double>(runner, points, "angle sum", [](const auto& polygon, const auto& p, Rule) {
    return contact::where_by_angle_sum(polygon, p);
  });
  point_method<double>(runner, points, "quadrants", [](const auto& polygon, const auto& p, Rule) {
    return contact::where_by_quadrants(polygon, p);
  });
  point_method<double>(runner, points, "crossings with ends",
                       [](const auto& polygon, const auto& p, Rule) {
                         return contact::where_by_crossings_with_ends(polygon, p);
                       });
  point_method<double>(runner, points, "crossings", [](const auto& polygon, const auto& p, Rule) {
    return contact::where_by_crossings(polygon, p);
  });
  point_method<float>(runner, points, "crossings, float",
                      [](const auto& polygon, const auto& p, Rule) {
                        return contact::where_by_crossings(polygon, p);
                      });
  point_method<double>(runner, points, "scanline",
                       [](const auto& polygon, const auto& p, Rule rule) {
                         return contact::where_by_scanline(polygon, p, rule);
                       });
  runner.method(points, "exact winding number", [](const Case& c, const Json& answer) {
    PolygonWithHoles<double> polygon{polygon_of(c), {}};
    if (c.has("hole")) polygon.holes.push_back(polygon_of(c, "hole"));
    return answer.at("where") == text(contact::where(polygon, point_of(c), rule_of(c)));
  });

  runner.question("convex", where_answer);
  point_method<float>(
      runner, "convex", "edge tests, float",
      [](const auto& polygon, const auto& p, Rule) { return contact::where_by_edges(polygon, p); });
  point_method<double>(
      runner, "convex", "edge tests, double",
      [](const auto& polygon, const auto& p, Rule) { return contact::where_by_edges(polygon, p); });
  point_method<double>(
      runner, "convex", "edge tests, tolerance 1e-9",
      [](const auto& polygon, const auto& p, Rule) { return edges_with_tolerance(polygon, p); });
  point_method<double>(
      runner, "convex", "bisection, double",
      [](const auto& polygon, const auto& p, Rule) { return rounded_bisection(polygon, p); });
  point_method<double>(runner, "convex", "edge tests, exact",
                       [](const auto& polygon, const auto& p, Rule) {
                         return contact::where_by_edges_exact(polygon, p);
                       });
  point_method<double>(runner, "convex", "bisection, exact",
                       [](const auto& polygon, const auto& p, Rule) {
                         return contact::where_by_bisection(polygon, p);
                       });

  // The first three say whether the segments meet, and are judged by that.
  runner.question("segments", meeting_answer);
  runner.method("segments", "slopes", [](const Case& c, const Json& answer) {
    const auto p = contact::crossing_by_slopes(segment_of(c, "first"), segment_of(c, "second"));
    return p.has_value() == (answer.at("meeting") != "none");
  });
  runner.method("segments", "parameters", [](const Case& c, const Json& answer) {
    const auto p = contact::crossing_by_parameters(segment_of(c, "first"), segment_of(c, "second"));
    return p.has_value() == (answer.at("meeting") != "none");
  });
  runner.method("segments", "parameters, tolerance 1e-9", [](const Case& c, const Json& answer) {
    return meet_with_tolerance(segment_of(c, "first"), segment_of(c, "second")) ==
           (answer.at("meeting") != "none");
  });
  runner.method("segments", "orientations, float", [](const Case& c, const Json& answer) {
    return answer.at("meeting") ==
           meeting_text(segment_of<float>(c, "first"), segment_of<float>(c, "second"));
  });
  runner.method("segments", "orientations, double", [](const Case& c, const Json& answer) {
    return answer.at("meeting") == meeting_text(segment_of(c, "first"), segment_of(c, "second"));
  });
  runner.method("segments", "orientations, exact", [](const Case& c, const Json& answer) {
    return answer.at("meeting") ==
           text(contact::meet(segment_of(c, "first"), segment_of(c, "second")));
  });

  // Right if both coordinates are at most one ulp from the exact point's nearest double.
  runner.question("crossing_point", point_answer);
  const auto near_point = [](const Vector2<double>& p, const Json& answer) {
    return near_in_place(p.x(), answer.at("x")) && near_in_place(p.y(), answer.at("y"));
  };
  runner.method("crossing_point", "slopes", [near_point](const Case& c, const Json& answer) {
    const auto p = contact::crossing_by_slopes(segment_of(c, "first"), segment_of(c, "second"));
    return p.has_value() && near_point(*p, answer);
  });
  runner.method("crossing_point", "parameters", [near_point](const Case& c, const Json& answer) {
    const auto p = contact::crossing_by_parameters(segment_of(c, "first"), segment_of(c, "second"));
    return p.has_value() && near_point(p->point, answer);
  });
  // The book's own is right if it keeps its bound.
  runner.method("crossing_point", "within its bound", [](const Case& c, const Json& answer) {
    const auto p = contact::crossing(segment_of(c, "first"), segment_of(c, "second"));
    return std::abs(p.point.x() - hard_cases::unhex(answer.at("x"))) <= p.point_bound &&
           std::abs(p.point.y() - hard_cases::unhex(answer.at("y"))) <= p.point_bound;
  });
  runner.method("crossing_point", "to the last place", [](const Case& c, const Json& answer) {
    const auto p = contact::crossing_to_last_place(segment_of(c, "first"), segment_of(c, "second"));
    return p.point.x() == hard_cases::unhex(answer.at("x")) &&
           p.point.y() == hard_cases::unhex(answer.at("y"));
  });

  runner.question("overlap", overlap_answer);
  runner.method("overlap", "slopes and ranges of x", [](const Case& c, const Json& answer) {
    return right_overlap(overlap_by_slopes(segment_of(c, "first"), segment_of(c, "second")),
                         answer);
  });
  runner.method("overlap", "parameters", [](const Case& c, const Json& answer) {
    const auto p = contact::crossing_by_parameters(segment_of(c, "first"), segment_of(c, "second"));
    return right_overlap(p.value_or(SegmentCrossing<double>{}), answer);
  });
  runner.method("overlap", "exact", [](const Case& c, const Json& answer) {
    return right_overlap(contact::crossing(segment_of(c, "first"), segment_of(c, "second")),
                         answer);
  });

  runner.question("edges_on_path", edges_answer);
  const auto edges_by = [](const Case& c, const auto& meets) {
    const Segment2<double> path = segment_of(c, "path");
    const auto edges = contact::perimeter_segments(polygon_of(c));
    std::vector<int> met;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (meets(path, edges[i])) met.push_back(static_cast<int>(i));
    }
    return Json(met);
  };
  runner.method("edges_on_path", "line for ray", [edges_by](const Case& c, const Json& answer) {
    // The path's line in place of the path.
    return answer.at("edges") == edges_by(c, [](const auto& path, const auto& edge) {
             const double a = contact::orientation<double>(path.a, path.b, edge.a);
             const double b = contact::orientation<double>(path.a, path.b, edge.b);
             return a * b <= 0;
           });
  });
  runner.method("edges_on_path", "parameters", [edges_by](const Case& c, const Json& answer) {
    return answer.at("edges") == edges_by(c, [](const auto& path, const auto& edge) {
             return contact::crossing_by_parameters(path, edge).has_value();
           });
  });
  runner.method("edges_on_path", "exact", [](const Case& c, const Json& answer) {
    std::vector<int> met;
    for (const auto& hit : contact::edges_on_path(segment_of(c, "path"), polygon_of(c))) {
      met.push_back(hit.second);
    }
    return answer.at("edges") == Json(met);
  });

  runner.question("face", face_answer);
  normal_method(runner, "segment that was hit", [](const auto& contact, const auto& hit) {
    return contact::normal_of_hit_segment(contact, hit);
  });
  normal_method(runner, "nearer end", [](const auto& contact, const auto& hit) {
    return contact::normal_by_nearer_end(contact, hit);
  });
  normal_method(runner, "least penetration", [](const auto& contact, const auto&) {
    return contact::face_of_least_penetration(contact)->normal;
  });

  runner.question("wall", space_answer);
  space_method<float>(runner, "dropping, float", [](const auto& path, const auto& polygon) {
    return contact::intersect_polygon_by_dropping(path, polygon);
  });
  space_method<double>(runner, "dropping, double", [](const auto& path, const auto& polygon) {
    return contact::intersect_polygon_by_dropping(path, polygon);
  });
  space_method<double>(runner, "orientations, exact", [](const auto& path, const auto& polygon) {
    return contact::intersect_polygon(path, polygon);
  });
  return runner.run(argc, argv);
}
