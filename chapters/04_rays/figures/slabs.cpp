// A ray and a box, seen along z: when the ray is in each of the three slabs, and from which starts
// the chosen method is wrong.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/figure.hpp>
#include <contact/ray_box.hpp>
#include <optional>

using Point = contact::Vector2<double>;

struct Input {
  Point low;                // two opposite corners of the box, x and y, m
  Point high;               //
  Point origin;             // o, where the ray starts, m
  Point through;            // q, to which t = 1 belongs, m
  std::array<double, 4> z;  // of both corners, of o and of q, m
  double segment;           // 1: it ends at q
  double method;            // 0 the book's, 1 with division, 2 branchless, 3 padded
  double divided;           // 10: everything is divided by 10 before it is stored, so that most
                            // numbers are rounded
  double single;            // 1: stored and computed in float
};

constexpr int methods = 4;
// The grid of starts: a quarter of a metre apart, around the origin.
constexpr int columns = 41, rows = 25, starts = columns * rows;

struct Output {
  double problem;
  Point box_low, box_high;  // m, in the drawing
  // Of x, y and z: the quotients as the scalar rounds them, and the interval of t in which the line
  // is in the slab: −∞ to ∞ or none where it is parallel to the faces.
  std::array<double, 3> first_quotient, second_quotient;
  std::array<double, 3> slab_some;  // 0 if the line is never in the slab
  std::array<double, 3> slab_entry, slab_exit;
  double passes;  // 1 if the line meets the box, exactly
  double entry, exit;
  double entry_axis, exit_axis;  // 0 x, 1 y, 2 z; −1 if none
  double hit;                    // of the ray or the segment, exactly
  double inside;
  double t;
  Point point, normal;                // of the first hit, in the drawing
  std::array<double, methods> says;   // 1 if by a method the ray or the segment hits
  std::array<double, methods> wrong;  // 1 if that is wrong
  std::array<double, methods> finds;  // 1 if it finds an interval; then
  std::array<double, methods> method_entry, method_exit;
  std::array<double, starts> seen;    // 1 if from this start the box is hit
  std::array<double, starts> missed;  // 1 if from this start the chosen method is wrong
  double starts_wrong;                // how many
  // For a reader's function: what is stored, and the axis of the face of the first hit, or −1.
  contact::Vector3<double> start, along, corner_low, corner_high;
  double axis;
  double clear;         // 1 for a ray that is stored in double as it is given
  double hit_clear;     // 1 if it also hits
  double in_a_face;     // goals of questions: a quotient is 0/0,
  double says_wrongly;  // the chosen method is wrong
};

namespace {

template <class S>
using Found = std::optional<contact::Passage<S>>;

template <class S>
Found<S> ask(int method, const contact::Ray<S>& ray, const contact::Aabb<S>& box) {
  switch (method) {
    case 1:
      return contact::passage_by_slabs_with_division(ray, box);
    case 2:
      return contact::passage_by_branchless_slabs(ray, box);
    case 3:
      return contact::passage_by_padded_slabs(ray, box);
    default:
      return contact::passage(ray, box);
  }
}

/// A ray or a segment as the figure stores it.
template <class S>
struct Path {
  contact::Ray<S> ray;
  contact::Segment<S> segment;
  bool ends;

  bool hits(const contact::Aabb<S>& box) const {
    return ends ? contact::hits_box(segment, box) : contact::hits_box(ray, box);
  }
  /// The book's decision is not made from rounded numbers.
  bool says(int method, const contact::Aabb<S>& box, const Found<S>& found) const {
    if (method == 0) return hits(box);
    if (!found) return false;
    return ends ? contact::first_hit(segment, *found).has_value()
                : contact::first_hit(ray, *found).has_value();
  }
};

template <class S>
Path<S> path(const contact::Vector3<double>& from, const contact::Vector3<double>& to, bool ends) {
  const contact::Segment<S> segment{from.cast<S>(), to.cast<S>()};
  return {contact::ray_of(segment), segment, ends};
}

template <class S>
void compute_in(const Input& in, Output& out) {
  const int method = in.method >= 1 && in.method < methods ? static_cast<int>(in.method) : 0;
  const double divided = in.divided == 10 ? 10 : 1;
  const bool ends = in.segment == 1;
  const auto space = [divided](const Point& p, double z) {
    return contact::Vector3<double>(p.x() / divided, p.y() / divided, z / divided);
  };
  const auto drawn = [divided](const contact::Vector3<S>& v) -> Point {
    return divided * v.template cast<double>().template head<2>();
  };
  const contact::Vector3<double> one = space(in.low, in.z[0]), other = space(in.high, in.z[1]);
  const contact::Aabb<S> box{one.cwiseMin(other).cast<S>(), one.cwiseMax(other).cast<S>()};
  const Path<S> given = path<S>(space(in.origin, in.z[2]), space(in.through, in.z[3]), ends);
  const contact::Ray<S>& ray = given.ray;
  out.box_low = drawn(box.low);
  out.box_high = drawn(box.high);

  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const S d = ray.direction(i);
    const S first = (box.low(i) - ray.origin(i)) / d, second = (box.high(i) - ray.origin(i)) / d;
    out.first_quotient[k] = double(first);
    out.second_quotient[k] = double(second);
    if (std::isnan(out.first_quotient[k]) || std::isnan(out.second_quotient[k])) out.in_a_face = 1;
    // What the line passes of this slab alone: the other two sides of the box are far away.
    contact::Aabb<S> slab = box;
    const contact::Ray<S> alone{ray.origin, contact::Vector3<S>::Unit(i) * d};
    for (int j = 0; j < 3; ++j) {
      if (j == i) continue;
      slab.low(j) = ray.origin(j) - S(1);
      slab.high(j) = ray.origin(j) + S(1);
    }
    if (const Found<S> part = contact::passage(alone, slab)) {
      out.slab_some[k] = 1;
      out.slab_entry[k] = double(part->entry);
      out.slab_exit[k] = double(part->exit);
    }
  }

  out.start = ray.origin.template cast<double>();
  out.along = ray.direction.template cast<double>();
  out.corner_low = box.low.template cast<double>();
  out.corner_high = box.high.template cast<double>();
  out.entry_axis = out.exit_axis = out.axis = -1;
  out.hit = given.hits(box) ? 1 : 0;
  if (const auto hit =
          ends ? contact::first_hit(given.segment, box) : contact::first_hit(ray, box)) {
    out.inside = hit->inside ? 1 : 0;
    out.t = double(hit->t);
    if (hit->face >= 0) out.axis = hit->face / 2;
    out.point = drawn(hit->point);
    out.normal = hit->normal.template cast<double>().template head<2>();
  }
  out.clear = !ends && in.divided != 10 && in.single != 1 ? 1 : 0;
  out.hit_clear = out.clear != 0 && out.hit != 0 ? 1 : 0;
  for (int i = 0; i < methods; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Found<S> found = ask(i, ray, box);
    if (found) {
      out.finds[k] = 1;
      out.method_entry[k] = double(found->entry);
      out.method_exit[k] = double(found->exit);
    }
    out.says[k] = given.says(i, box, found) ? 1 : 0;
    out.wrong[k] = out.says[k] != out.hit ? 1 : 0;
    if (i == 0 && found) {
      out.passes = 1;
      out.entry = double(found->entry);
      out.exit = double(found->exit);
      if (found->entry_face >= 0) out.entry_axis = found->entry_face / 2;
      if (found->exit_face >= 0) out.exit_axis = found->exit_face / 2;
    }
  }
  out.says_wrongly = out.wrong[static_cast<std::size_t>(method)];

  const Point ahead = in.through - in.origin;
  for (int i = 0; i < starts; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Point from(0.25 * (i % columns - columns / 2), 0.25 * (i / columns - rows / 2));
    const Path<S> each = path<S>(space(from, in.z[2]), space(from + ahead, in.z[3]), ends);
    const bool hit = each.hits(box);
    out.seen[k] = hit ? 1 : 0;
    out.missed[k] = each.says(method, box, ask(method, each.ray, box)) != hit ? 1 : 0;
    out.starts_wrong += out.missed[k];
  }
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  const double largest = in.single == 1 ? 1e15 : 1e100;
  for (const auto* v : {&in.low, &in.high, &in.origin, &in.through}) {
    if (v->cwiseAbs().maxCoeff() > largest) out.problem = contact::figure::too_large;
  }
  for (const double z : in.z) {
    if (std::abs(z) > largest) out.problem = contact::figure::too_large;
  }
  if (in.origin == in.through && in.z[2] == in.z[3]) out.problem = contact::figure::zero_direction;
  if (out.problem != 0) return out;
  in.single == 1 ? compute_in<float>(in, out) : compute_in<double>(in, out);
  return out;
}

FIGURE(Input, FIELDS(low, high, origin, through, z, segment, method, divided, single), Output,
       FIELDS(problem, box_low, box_high, first_quotient, second_quotient, slab_some, slab_entry,
              slab_exit, passes, entry, exit, entry_axis, exit_axis, hit, inside, t, point, normal,
              says, wrong, finds, method_entry, method_exit, seen, missed, starts_wrong, start,
              along, corner_low, corner_high, axis, clear, hit_clear, in_a_face, says_wrongly))
