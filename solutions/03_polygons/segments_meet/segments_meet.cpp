#include "segments_meet.hpp"

namespace exercise {
namespace {

// Twice the signed area of the segment's ends and p: its sign is the side of the line on which p
// is.
double area(const Segment& s, const Eigen::Vector2d& p) {
  //? The cross product of ab and ap.
  //? gap: s.b.x() - s.a.x()
  return (s.b.x() - s.a.x()) * (p.y() - s.a.y()) - (s.b.y() - s.a.y()) * (p.x() - s.a.x());
}

// Whether one number is positive and the other negative.
bool opposite(double x, double y) {
  //? A product of numbers this large is rounded, but its sign is right.
  return x * y < 0;
}

// Whether p is on the segment, ends included.
bool is_on(const Segment& s, const Eigen::Vector2d& p) {
  //? On the line, and not beyond an end: from p, both ends are not in the same direction.
  //? gap: (p - s.a).dot(p - s.b) <= 0
  return area(s, p) == 0 && (p - s.a).dot(p - s.b) <= 0;
}

}  // namespace

Meeting segments_meet(const Segment& s, const Segment& t) {
  //? Each segment has its ends on different sides of the other's line.
  //? gap: opposite(area(s, t.a), area(s, t.b))
  if (opposite(area(s, t.a), area(s, t.b)) && opposite(area(t, s.a), area(t, s.b)))
    return Meeting::crossing;
  //? If they meet otherwise, what they have in common begins and ends with ends: all that are on
  //? the other segment, each once.
  //? gap: is_on(s, p)
  std::vector<Eigen::Vector2d> common;
  for (const Eigen::Vector2d& p : {t.a, t.b, s.a, s.b}) {
    const bool is_new = std::find(common.begin(), common.end(), p) == common.end();
    if (is_new && is_on(s, p) && is_on(t, p)) common.push_back(p);
  }
  //? No such point, one, or the two ends of the overlap.
  if (common.empty()) return Meeting::none;
  return common.size() == 1 ? Meeting::touching : Meeting::overlapping;
}

}  // namespace exercise
