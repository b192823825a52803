// A ball and a ray in the plane: where each method of the chapter has the ray enter and leave, from
// near and from far away, and what each takes for the outline of the ball.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/figure.hpp>
#include <contact/ray_sphere.hpp>
#include <optional>

using Point = contact::Vector2<double>;

struct Input {
  Point origin;      // o, where the ray starts if it is not moved, m
  Point through;     // q, a point ahead on the ray, m
  Point centre;      // of the ball, m
  double radius;     // m
  double far;        // k: the start is moved back by 10^k m, in quarters of k; 0: not moved
  double direction;  // 0: a unit vector; 1: from o to q, so that t = 1 at q; 2: as 1, and the
                     // segment ends there
  double method;     // 0 the book's, 1 the lecture's, 2 the textbook's, 3 by the nearest point
  double single;     // 1: stored and computed in float
};

constexpr int methods = 4;
constexpr int rays = 61;      // parallel ones, for the outline
constexpr double beyond = 1;  // how far the outer ones pass beside the ball, m

struct Output {
  double problem;
  double moved;       // m
  Point drawn_from;   // two points of the stored line, on both sides of the ball
  Point drawn_to;     //
  double meets;       // of the stored line, exactly: 0 misses, 1 touches, 2 crosses
  double hit;         // 1 if the ray or the segment meets the ball, exactly
  double inside;      // 1 if it starts inside
  double t;           // the book's, of the first hit
  Point point;        // of that, m, in the drawing
  Point normal;       // there; 0 if it starts inside
  double length;      // of the direction as stored, m
  double square;      // the two numbers that the chosen method compares, as it rounds them
  double compared;    //
  double difference;  // of both: the discriminant, or a quarter of it
  std::array<double, methods> finds;  // 1 if a method finds an entry and an exit of the line
  std::array<double, methods> says;   // 1 if by them the ray or the segment hits
  std::array<double, methods> wrong;  // 1 if that is wrong
  std::array<double, methods> entry;
  std::array<double, methods> exit;
  std::array<Point, methods> entry_at;  // m, in the drawing
  std::array<Point, methods> exit_at;
  std::array<double, methods> entry_past;  // how far ahead of o, m
  std::array<double, methods> exit_past;
  std::array<double, methods> off;  // of the entry from the book's, m
  // Parallel rays of the same length: what the chosen method finds of them.
  std::array<double, rays> ray_finds;
  std::array<double, rays> ray_wrong;  // 1 if it finds what is not there, or not what is there
  std::array<Point, rays> ray_entry;   // m; if it finds nothing, the point nearest to the centre
  std::array<Point, rays> ray_exit;
  double rays_wrong;  // how many
  double rays_off;    // largest error of an entry that was found rightly, m
  // For a reader's function: what is stored, and whether every good method gives the same.
  contact::Vector3<double> start, along, ball;
  double clear;            // 1 for a ray in double, r/4 or more from touching
  double hit_clear;        // 1 if it also hits
  double missed;           // goals of questions: the chosen method misses a ball that is hit,
  double found_wrongly;    // hits one that is missed,
  double entered_wrongly;  // has an entry that is off by 0.1 m or more
};

namespace {

template <class S>
using Found = std::optional<contact::Passage<S>>;

template <class S>
Found<S> ask(int method, const contact::Ray<S>& ray, const contact::Sphere<S>& ball) {
  switch (method) {
    case 1:
      return contact::passage_by_lecture(ray, ball);
    case 2:
      return contact::passage_by_textbook(ray, ball);
    case 3:
      return contact::passage_by_nearest_point(ray, ball);
    default:
      return contact::passage(ray, ball);
  }
}

template <class S>
contact::Vector3<S> stored(const Point& p) {
  return contact::Vector3<double>(p.x(), p.y(), 0).cast<S>();
}

template <class S>
Point plane(const contact::Vector3<S>& v) {
  return v.template cast<double>().template head<2>();
}

/// The point with a given t, for the drawing: in double, from the ball's centre.
template <class S>
Point at(const contact::Ray<S>& ray, double t, const contact::Sphere<S>& ball) {
  const Point centre = plane(ball.centre);
  return centre + ((plane(ray.origin) - centre) + t * plane(ray.direction));
}

/// The point of the line that is nearest to the centre, for the drawing.
template <class S>
Point nearest(const contact::Ray<S>& ray, const contact::Sphere<S>& ball) {
  const Point centre = plane(ball.centre), away = plane(ray.origin) - centre;
  const Point along = plane(ray.direction).normalized();
  const Point normal(-along.y(), along.x());
  return centre + normal.dot(away) * normal;
}

/// 10^k for k in quarters.
double power_of_ten(double k) {
  constexpr std::array<double, 4> quarter{1, 1.7782794100389228, 3.1622776601683795,
                                          5.623413251903491};
  const int quarters = static_cast<int>(4 * k);
  double power = quarter[static_cast<std::size_t>(quarters % 4)];
  for (int i = 0; i < quarters / 4; ++i) power *= 10;
  return power;
}

/// The two numbers whose difference decides, as the method rounds them.
template <class S>
void compare(int method, const contact::Ray<S>& ray, const contact::Sphere<S>& ball, Output& out) {
  const contact::Vector3<S> m = ray.origin - ball.centre;
  const contact::Vector3<S>& d = ray.direction;
  const S r2 = ball.radius * ball.radius;
  S square, compared;
  if (method == 1) {
    square = d.dot(m) * d.dot(m);
    compared = m.dot(m) - r2;
  } else if (method == 2) {
    const S b = S(2) * d.dot(m);
    square = b * b;
    compared = S(4) * d.dot(d) * (m.dot(m) - r2);
  } else {
    const contact::Vector3<S> across = m - d * (d.dot(m) / d.dot(d));
    square = r2;
    compared = across.dot(across);
  }
  out.square = double(square);
  out.compared = double(compared);
  out.difference = double(S(square - compared));
}

template <class S>
void outline(int method, const contact::Ray<S>& ray, const contact::Sphere<S>& ball, double back,
             Output& out) {
  const Point centre = plane(ball.centre), along = plane(ray.direction).normalized();
  const Point normal(-along.y(), along.x());
  const double half_width = double(ball.radius) + beyond;
  for (int i = 0; i < rays; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double beside = half_width * (2 * i - (rays - 1)) / (rays - 1);
    const contact::Ray<S> one{stored<S>(centre + beside * normal - back * along), ray.direction};
    const bool there = contact::sphere_crossing(one, ball) != contact::LineMeets::misses;
    const Found<S> found = ask(method, one, ball);
    out.ray_finds[k] = found ? 1 : 0;
    out.ray_wrong[k] = there != found.has_value() ? 1 : 0;
    out.rays_wrong += out.ray_wrong[k];
    if (!found) {
      out.ray_entry[k] = out.ray_exit[k] = nearest(one, ball);
      continue;
    }
    out.ray_entry[k] = at(one, double(found->entry), ball);
    out.ray_exit[k] = at(one, double(found->exit), ball);
    const Found<S> right = contact::passage(one, ball);
    if (right) {
      const double off = (double(found->entry) - double(right->entry)) * out.length;
      out.rays_off = std::max(out.rays_off, std::abs(off));
    }
  }
}

template <class S>
void compute_in(const Input& in, Output& out) {
  const int method = in.method >= 1 && in.method < methods ? static_cast<int>(in.method) : 0;
  const Point ahead = in.through - in.origin;
  const Point unit = ahead / std::sqrt(ahead.squaredNorm());
  const contact::Sphere<S> ball{stored<S>(in.centre), S(in.radius)};
  const contact::Segment<S> segment{stored<S>(in.origin - out.moved * unit), stored<S>(in.through)};
  const bool ends = in.direction == 2;
  const contact::Ray<S> ray =
      ends ? contact::ray_of(segment)
           : contact::Ray<S>{segment.start, stored<S>(in.direction == 1 ? ahead : unit)};
  const auto first = [&](const contact::Passage<S>& passage) {
    return ends ? contact::first_hit(segment, passage) : contact::first_hit(ray, passage);
  };

  out.length = std::sqrt(plane(ray.direction).squaredNorm());
  if (!(out.length > 0)) {  // the ends of the segment were rounded to one point
    out.problem = contact::figure::zero_direction;
    return;
  }
  const Point foot = nearest(ray, ball), along = plane(ray.direction) / out.length;
  const double drawn = 30 + (foot - in.origin).norm();
  out.drawn_from = foot - drawn * along;
  out.drawn_to = foot + drawn * along;
  out.meets = double(static_cast<int>(contact::sphere_crossing(ray, ball)));
  out.hit = (ends ? contact::hits_sphere(segment, ball) : contact::hits_sphere(ray, ball)) ? 1 : 0;
  if (const auto hit = ends ? contact::first_hit(segment, ball) : contact::first_hit(ray, ball)) {
    out.inside = hit->inside ? 1 : 0;
    out.t = double(hit->t);
    out.point = at(ray, out.t, ball);
    out.normal = plane(hit->normal);
  }

  out.start = ray.origin.template cast<double>();
  out.along = ray.direction.template cast<double>();
  out.ball = ball.centre.template cast<double>();
  const double radius = double(ball.radius);
  const double distance = (foot - plane(ball.centre)).norm();
  out.clear = !ends && in.single != 1 && std::abs(distance - radius) >= radius / 4 &&
                      out.moved <= 1e9 * radius
                  ? 1
                  : 0;
  out.hit_clear = out.clear != 0 && out.hit != 0 ? 1 : 0;

  for (int i = 0; i < methods; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Found<S> found = ask(i, ray, ball);
    if (found) {
      out.finds[k] = 1;
      out.says[k] = first(*found) ? 1 : 0;
      out.entry[k] = double(found->entry);
      out.exit[k] = double(found->exit);
      out.entry_at[k] = at(ray, out.entry[k], ball);
      out.exit_at[k] = at(ray, out.exit[k], ball);
      out.entry_past[k] = unit.dot(out.entry_at[k] - in.origin);
      out.exit_past[k] = unit.dot(out.exit_at[k] - in.origin);
      if (out.finds[0] != 0) out.off[k] = std::abs(out.entry[k] - out.entry[0]) * out.length;
    }
    // The book's decision is not made from its rounded t.
    if (i == 0) out.says[0] = out.hit;
    out.wrong[k] = out.says[k] != out.hit ? 1 : 0;
  }
  compare(method, ray, ball, out);
  const double back = plane(contact::Vector3<S>(ball.centre - ray.origin)).dot(along);
  outline(method, ray, ball, back, out);

  const auto chosen = static_cast<std::size_t>(method);
  out.missed = out.hit != 0 && out.says[chosen] == 0 ? 1 : 0;
  out.found_wrongly = out.hit == 0 && out.says[chosen] != 0 ? 1 : 0;
  out.entered_wrongly = out.finds[chosen] != 0 && out.off[chosen] >= 0.1 ? 1 : 0;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  for (const auto* v : {&in.origin, &in.through, &in.centre}) {
    if (v->cwiseAbs().maxCoeff() > (in.single == 1 ? 1e9 : 1e18))
      out.problem = contact::figure::too_large;
  }
  if (in.radius > 1e6) out.problem = contact::figure::too_large;
  if (!(in.radius > 0)) out.problem = contact::figure::not_positive;
  if (!((in.through - in.origin).cwiseAbs().maxCoeff() > 1e-6))
    out.problem = contact::figure::zero_direction;
  if (out.problem != 0) return out;
  const double k = std::clamp(in.far, 0.0, in.single == 1 ? 7.0 : 12.0);
  if (k > 0) out.moved = power_of_ten(k);
  in.single == 1 ? compute_in<float>(in, out) : compute_in<double>(in, out);
  return out;
}

FIGURE(Input, FIELDS(origin, through, centre, radius, far, direction, method, single), Output,
       FIELDS(problem, moved, drawn_from, drawn_to, meets, hit, inside, t, point, normal, length,
              square, compared, difference, finds, says, wrong, entry, exit, entry_at, exit_at,
              entry_past, exit_past, off, ray_finds, ray_wrong, ray_entry, ray_exit, rays_wrong,
              rays_off, start, along, ball, clear, hit_clear, missed, found_wrongly,
              entered_wrongly))
