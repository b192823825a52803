// Eight points in the plane: the lecture's circle as it takes in one point after another, rounded,
// with the points that it misses; the circle around the centroid, and the smallest one.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/exact.hpp>
#include <contact/figure.hpp>
#include <contact/grown_sphere.hpp>
#include <contact/smallest_circle.hpp>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

using Point = contact::Vector2<double>;

constexpr std::size_t points_in_all = 8;

struct Input {
  Point p0, p1, p2, p3, p4, p5, p6, p7;  // m
  double taken;                          // how many points have been taken in, in the order
  double order;   // 0 as numbered, 1 reversed, 2 that of the smallest circle, 3 of the largest
  double single;  // 1: points are stored and the lecture's circle is computed in float
};

struct Output {
  double problem;
  double low, high;                         // the most distant pair of extremes: indices
  std::array<double, points_in_all> order;  // indices of the points, as they are taken in
  double start_radius, radius;  // the circle from this pair, and after `taken` points, m
  Point start_centre, centre;
  double grew;  // 1 if the last point taken in was outside; then the circle before it
  double radius_before;
  Point centre_before;
  double grown_radius;  // after all points
  Point grown_centre;
  std::array<double, points_in_all> missed;   // 1 for a point taken in that is outside, exactly
  std::array<double, points_in_all> outside;  // by how much, m
  double missed_count, missed_most;
  double centroid_radius, smallest_radius;
  Point centroid, smallest_centre;
  double support_count;
  std::array<double, 3> support;  // indices of the points that determine the smallest circle
  double grown_ratio, centroid_ratio, min_ratio, greatest_ratio;  // radius / smallest radius
  // For a reader's function that takes multiples of 1/8 up to 100: the lecture's sphere around the
  // points in the order of their numbers, certain to contain them; `whole` is 1 if all are such
  // multiples.
  double whole;
  contact::Vector3<double> sphere_centre;
  double sphere_radius;
  double grown_is_smallest, misses_in_double, centroid_is_larger;  // goals of questions
};

namespace {

// The book's spheres are in space: the points are at z = 0, and so are all centres.
template <class S>
using Points = std::vector<contact::Vector3<S>>;
template <class S>
using Circle = contact::Sphere<S>;
using Order = std::array<std::size_t, points_in_all>;

template <class S>
Points<S> in_space(const std::vector<Point>& points) {
  Points<S> result;
  for (const Point& p : points) result.push_back({S(p.x()), S(p.y()), S(0)});
  return result;
}

template <class S>
Point centre_of(const Circle<S>& circle) {
  return circle.centre.template head<2>().template cast<double>();
}

/// The lecture's circle after 0 to 8 points of the order: circle k has taken in k of them. The last
/// one is that of contact::sphere_grown_as_given().
template <class S>
std::array<Circle<S>, points_in_all + 1> circles(const Points<S>& points, std::size_t low,
                                                 std::size_t high, const Order& order) {
  std::array<Circle<S>, points_in_all + 1> result;
  const contact::Vector3<S>&p = points[low], &q = points[high];
  result[0] = {p / 2 + q / 2, (q - p).norm() / 2};
  for (std::size_t k = 0; k < points_in_all; ++k) {
    result[k + 1] = result[k];
    contact::sphere_detail::grow(result[k + 1], points[order[k]]);
  }
  return result;
}

/// The orders of the six points beside the pair that give the smallest and the largest circle. The
/// pair comes first: it is on the circle at the start, and inside later.
struct Orders {
  Order least{}, greatest{};
  double min_radius = std::numeric_limits<double>::infinity(), greatest_radius = -1;
};

template <class S>
Orders all_orders(const Points<S>& points, std::size_t low, std::size_t high) {
  Orders found;
  Order order{};
  std::size_t next = 0;
  order[next++] = low;
  if (low != high) order[next++] = high;
  const auto rest = order.begin() + static_cast<std::ptrdiff_t>(next);
  for (std::size_t i = 0; i < points_in_all; ++i) {
    if (i != low && i != high) order[next++] = i;
  }
  do {
    const auto radius = double(circles(points, low, high, order).back().radius);
    if (radius < found.min_radius) {
      found.least = order;
      found.min_radius = radius;
    }
    if (radius > found.greatest_radius) {
      found.greatest = order;
      found.greatest_radius = radius;
    }
  } while (std::next_permutation(rest, order.end()));
  return found;
}

/// By how much a point is outside of a circle, decided exactly: (d² − r²) / (d + r), or 0.
template <class S>
double outside(const Circle<S>& circle, const contact::Vector3<S>& point) {
  using contact::Exact;
  const Exact x = Exact(double(point.x())) - Exact(double(circle.centre.x()));
  const Exact y = Exact(double(point.y())) - Exact(double(circle.centre.y()));
  const Exact r(double(circle.radius));
  const Exact more = x * x + y * y - r * r;
  if (more.sign() <= 0) return 0;
  const double distance = (point - circle.centre).template cast<double>().norm();
  return quotient<double>(more, Exact(distance + double(circle.radius)));
}

template <class S>
void compute_in(const Input& in, const std::vector<Point>& given, Output& out) {
  const Points<S> points = in_space<S>(given);
  const auto pair = contact::most_distant_extremes<S>(points);
  const auto low = static_cast<std::size_t>(pair.low), high = static_cast<std::size_t>(pair.high);
  out.low = pair.low;
  out.high = pair.high;

  const Orders orders = all_orders(points, low, high);
  Order order{};
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (in.order == 1) std::reverse(order.begin(), order.end());
  if (in.order == 2) order = orders.least;
  if (in.order == 3) order = orders.greatest;
  std::transform(order.begin(), order.end(), out.order.begin(),
                 [](std::size_t i) { return double(i); });

  const auto grown = circles(points, low, high, order);
  const auto taken = static_cast<std::size_t>(std::clamp(in.taken, 0.0, double(points_in_all)));
  const Circle<S>& now = grown[taken];
  out.start_centre = centre_of(grown[0]);
  out.start_radius = double(grown[0].radius);
  out.centre = centre_of(now);
  out.radius = double(now.radius);
  out.grown_centre = centre_of(grown.back());
  out.grown_radius = double(grown.back().radius);
  if (taken > 0 && grown[taken - 1].radius < now.radius) {
    out.grew = 1;
    out.centre_before = centre_of(grown[taken - 1]);
    out.radius_before = double(grown[taken - 1].radius);
  }

  std::vector<std::size_t> included(order.begin(),
                                    order.begin() + static_cast<std::ptrdiff_t>(taken));
  included.push_back(low);
  included.push_back(high);
  for (const std::size_t i : included) {
    out.outside[i] = outside(now, points[i]);
    out.missed[i] = out.outside[i] > 0 ? 1 : 0;
    out.missed_most = std::max(out.missed_most, out.outside[i]);
  }
  out.missed_count = std::accumulate(out.missed.begin(), out.missed.end(), 0.0);

  const double smallest = out.smallest_radius;
  const auto ratio = [smallest](double radius) { return smallest > 0 ? radius / smallest : 1; };
  out.grown_ratio = ratio(out.grown_radius);
  out.centroid_ratio = ratio(out.centroid_radius);
  out.min_ratio = ratio(orders.min_radius);
  out.greatest_ratio = ratio(orders.greatest_radius);
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  const std::vector<Point> points{in.p0, in.p1, in.p2, in.p3, in.p4, in.p5, in.p6, in.p7};
  for (const Point& p : points) {
    if (p.cwiseAbs().maxCoeff() > 1e6) out.problem = contact::figure::too_large;
  }
  if (out.problem != 0) return out;

  const auto smallest = contact::smallest_circle<double>(points);
  out.smallest_centre = smallest.circle.centre;
  out.smallest_radius = smallest.circle.radius;
  out.support_count = smallest.support_count;
  std::copy(smallest.support.begin(), smallest.support.end(), out.support.begin());

  const Circle<double> centroid = contact::centroid_sphere<double>(in_space<double>(points));
  out.centroid = centre_of(centroid);
  out.centroid_radius = centroid.radius;

  if (in.single != 0)
    compute_in<float>(in, points, out);
  else
    compute_in<double>(in, points, out);
  out.grown_is_smallest = out.grown_ratio <= 1.001 ? 1 : 0;
  out.centroid_is_larger = out.centroid_ratio >= 1.5 ? 1 : 0;
  out.misses_in_double = in.single == 0 && out.missed_count > 0 ? 1 : 0;

  out.whole = 1;
  for (const Point& p : points) {
    const Point eighths = 8 * p;
    if (eighths != eighths.array().round().matrix() || eighths.cwiseAbs().maxCoeff() > 800)
      out.whole = 0;
  }
  const Circle<double> sphere = contact::grown_sphere<double>(in_space<double>(points));
  out.sphere_centre = sphere.centre;
  out.sphere_radius = sphere.radius;
  return out;
}

FIGURE(Input, FIELDS(p0, p1, p2, p3, p4, p5, p6, p7, taken, order, single), Output,
       FIELDS(problem, low, high, order, start_radius, radius, start_centre, centre, grew,
              radius_before, centre_before, grown_radius, grown_centre, missed, outside,
              missed_count, missed_most, centroid_radius, smallest_radius, centroid,
              smallest_centre, support_count, support, grown_ratio, centroid_ratio, min_ratio,
              greatest_ratio, whole, sphere_centre, sphere_radius, grown_is_smallest,
              misses_in_double, centroid_is_larger))
