// Recomputes the answers of hard_cases.json and checks which methods are right in which case.
#include "support/hard_cases.hpp"

#include <algorithm>
#include <cmath>
#include <contact/convex_hull.hpp>
#include <contact/gift_wrapping.hpp>
#include <contact/hull_2d.hpp>
#include <map>
#include <set>

using hard_cases::Case;
using hard_cases::Json;

namespace {

using contact::Hull;
using contact::Vector2;
using contact::Vector3;
using oracle::Rational;

template <int Size>
std::vector<Eigen::Matrix<double, Size, 1>> points_of(const Case& c) {
  const std::vector<double> numbers = c.numbers("points");
  std::vector<Eigen::Matrix<double, Size, 1>> points(numbers.size() / Size);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    points[i / Size](static_cast<Eigen::Index>(i % Size)) = numbers[i];
  }
  return points;
}

/// A point is a vertex of the hull in the plane if a line through it has all other points strictly
/// on one side: decided in fractions.
bool is_vertex(const std::vector<Vector2<Rational>>& points, std::size_t i) {
  std::vector<Vector2<Rational>> others;
  for (std::size_t j = 0; j < points.size(); ++j) {
    if (points[j] != points[i]) others.push_back(points[j] - points[i]);
    if (j < i && points[j] == points[i]) return false;
  }
  // It is in the hull of the others if it is on a segment or in a triangle of them.
  const auto cross = [](const auto& u, const auto& v) { return contact::cross2<Rational>(u, v); };
  for (const auto& u : others) {
    for (const auto& v : others) {
      const Rational between = cross(u, v);
      if (between == 0 && u.dot(v) < 0) return false;
      if (between <= 0) continue;
      for (const auto& w : others) {
        if (cross(v, w) >= 0 && cross(w, u) >= 0 && cross(v, w) + cross(w, u) > 0) return false;
      }
    }
  }
  return true;
}

Json flat_answer(const Case& c) {
  std::vector<Vector2<Rational>> points;
  for (const auto& p : points_of<2>(c))
    points.push_back({oracle::exact(p.x()), oracle::exact(p.y())});
  std::vector<int> corners;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_vertex(points, i)) corners.push_back(static_cast<int>(i));
  }
  return {{"class", "a"}, {"vertices", corners}};
}

bool right_flat(const Json& answer, std::vector<int> got) {
  std::sort(got.begin(), got.end());
  return answer.at("vertices").get<std::vector<int>>() == got;
}

template <class S>
std::vector<Vector2<S>> narrowed(const std::vector<Vector2<double>>& points) {
  std::vector<Vector2<S>> result;
  for (const auto& p : points) result.push_back(p.template cast<S>());
  return result;
}

/// Graham's scan with angles about the lowest point, by atan2, with ties in any order.
std::vector<int> by_angles(const std::vector<Vector2<double>>& points) {
  if (points.size() < 3) return contact::convex_hull_2d(points);
  const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int i, int j) {
    return at(i).y() != at(j).y() ? at(i).y() < at(j).y() : at(i).x() < at(j).x();
  });
  const Vector2<double> pivot = at(order[0]);
  const auto angle = [&](int i) {
    return std::atan2(at(i).y() - pivot.y(), at(i).x() - pivot.x());
  };
  std::stable_sort(order.begin() + 1, order.end(),
                   [&](int i, int j) { return angle(i) < angle(j); });
  std::vector<int> hull;
  for (const int i : order) {
    while (hull.size() >= 2 &&
           contact::orientation<double>(at(hull[hull.size() - 2]), at(hull.back()), at(i)) <= 0) {
      hull.pop_back();
    }
    hull.push_back(i);
  }
  return hull;
}

/// The hull by trying every plane through three points, in fractions.
Json solid_answer(const Case& c) {
  const auto points = points_of<3>(c);
  std::vector<oracle::Vector> exact;
  std::vector<int> kept;  // the first of equal points
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::find(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i), points[i]) ==
        points.begin() + static_cast<std::ptrdiff_t>(i)) {
      kept.push_back(static_cast<int>(i));
      exact.push_back(oracle::exact(points[i]));
    }
  }
  const std::size_t n = kept.size();
  int dimension = n == 0 ? -1 : n == 1 ? 0 : 1;
  std::set<std::vector<std::size_t>> planes;  // by the points in them
  std::set<int> corners;
  bool solid = false;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        const oracle::Vector normal =
            (exact[j] - exact[i]).cross(oracle::Vector(exact[k] - exact[i]));
        if (normal.x() == 0 && normal.y() == 0 && normal.z() == 0) continue;
        dimension = std::max(dimension, 2);
        bool front = false, behind = false;
        std::vector<std::size_t> flat;
        for (std::size_t l = 0; l < n; ++l) {
          const int side = oracle::sign(normal.dot(exact[l] - exact[i]));
          front = front || side > 0;
          behind = behind || side < 0;
          if (side == 0) flat.push_back(l);
        }
        solid = solid || front || behind;
        if (front && behind) continue;
        if (!planes.insert(flat).second) continue;
        const int drop = normal.x() != 0 ? 0 : normal.y() != 0 ? 1 : 2;
        std::vector<Vector2<Rational>> view;
        for (const std::size_t l : flat)
          view.push_back(contact::drop_dimension<Rational>(exact[l], drop));
        for (std::size_t l = 0; l < view.size(); ++l) {
          if (is_vertex(view, l)) corners.insert(kept[flat[l]]);
        }
      }
    }
  }
  Json answer{{"class", "a"}};
  if (solid) dimension = 3;
  answer["dimension"] = dimension;
  std::size_t vertex_count = corners.size();
  if (dimension == 0) vertex_count = 1;
  if (dimension == 1) vertex_count = 2;
  answer["vertices"] = vertex_count;
  answer["faces"] = dimension == 3   ? planes.size()
                    : dimension == 2 ? std::size_t(2)
                                     : std::size_t(0);
  return answer;
}

using Points = std::vector<Vector3<double>>;

/// Whether three points span a plane with no point in front of it.
bool supports(const Points& points, int a, int b, int c) {
  const auto at = [&points](int i) { return points[static_cast<std::size_t>(i)]; };
  return !contact::are_collinear(at(a), at(b), at(c)) &&
         std::all_of(points.begin(), points.end(), [&](const Vector3<double>& p) {
           return contact::orient_3d(at(a), at(b), at(c), p) <= 0;
         });
}

/// Faces that close and have no point in front are those of the hull; the counts then say whether
/// their vertices are the right ones.
bool right_hull(const Json& answer, const Points& points, const Hull& hull) {
  bool right = hull.closed && hull.dimension == answer.at("dimension").get<int>() &&
               hull.vertices.size() == answer.at("vertices").get<std::size_t>() &&
               hull.face_count() == answer.at("faces").get<int>();
  for (int f = 0; right && f < hull.face_count(); ++f) {
    const auto face = hull.face(f);
    right = supports(points, face[0], face[1], face[2]);
  }
  return right;
}

/// Triangles only: right if they close, have no point in front, and have the right vertices.
bool right_wrapping(const Json& answer, const Points& points, const contact::Wrapping& wrapping) {
  std::set<int> corners;
  for (const auto& t : wrapping.triangles) corners.insert(t.begin(), t.end());
  const std::size_t count = answer.at("vertices").get<std::size_t>();
  return wrapping.closed && answer.at("dimension") == 3 && corners.size() == count &&
         wrapping.triangles.size() == 2 * count - 4 &&
         std::all_of(wrapping.triangles.begin(), wrapping.triangles.end(),
                     [&points](const auto& t) { return supports(points, t[0], t[1], t[2]); });
}

/// A method for points in space, with the function that judges it.
template <class Method, class Judge>
auto judged(Method method, Judge judge) {
  return [method, judge](const Case& c, const Json& answer) {
    const Points points = points_of<3>(c);
    return judge(answer, points, method(points));
  };
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("08_convex_hull");

  runner.question("hull_2d", flat_answer);
  runner.method("hull_2d", "float", [](const Case& c, const Json& answer) {
    return right_flat(answer, contact::convex_hull_2d_rounded(narrowed<float>(points_of<2>(c))));
  });
  runner.method("hull_2d", "double", [](const Case& c, const Json& answer) {
    return right_flat(answer, contact::convex_hull_2d_rounded(points_of<2>(c)));
  });
  runner.method("hull_2d", "double, epsilon 1e-6", [](const Case& c, const Json& answer) {
    return right_flat(answer, contact::convex_hull_2d_rounded(points_of<2>(c), 1e-6));
  });
  runner.method("hull_2d", "angles by atan2", [](const Case& c, const Json& answer) {
    return right_flat(answer, by_angles(points_of<2>(c)));
  });
  runner.method("hull_2d", "exact", [](const Case& c, const Json& answer) {
    return right_flat(answer, contact::convex_hull_2d(points_of<2>(c)));
  });

  runner.question("hull_3d", solid_answer);
  runner.method("hull_3d", "wrapping, angles as on the slide",
                judged(
                    [](const Points& p) {
                      return contact::wrap_by_angles<double>(p, contact::FoldAngle::unsigned_);
                    },
                    right_wrapping));
  runner.method("hull_3d", "wrapping, signed angles",
                judged(
                    [](const Points& p) {
                      return contact::wrap_by_angles<double>(p, contact::FoldAngle::signed_);
                    },
                    right_wrapping));
  runner.method(
      "hull_3d", "wrapping, double",
      judged(
          [](const Points& p) { return contact::gift_wrap_with<contact::RoundedSides<double>>(p); },
          right_hull));
  runner.method("hull_3d", "incremental, float",
                judged(
                    [](const Points& p) {
                      return contact::convex_hull_with<contact::RoundedSides<float>>(p);
                    },
                    right_hull));
  runner.method("hull_3d", "incremental, double",
                judged(
                    [](const Points& p) {
                      return contact::convex_hull_with<contact::RoundedSides<double>>(p);
                    },
                    right_hull));
  runner.method("hull_3d", "incremental, epsilon 1e-6",
                judged(
                    [](const Points& p) {
                      return contact::convex_hull_with<contact::RoundedSides<double>>(p, 1e-6);
                    },
                    right_hull));
  runner.method("hull_3d", "wrapping, exact",
                judged([](const Points& p) { return contact::gift_wrap(p); }, right_hull));
  runner.method("hull_3d", "incremental, exact",
                judged([](const Points& p) { return contact::convex_hull(p); }, right_hull));
  return runner.run(argc, argv);
}
