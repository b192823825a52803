// What the comments of the headers say of directions and sizes of 0, infinities, NaN, and overflow.
#include <cmath>
#include <limits>
#include <vector>

#include <contact/ball_box.hpp>
#include <contact/exact_outward.hpp>
#include <contact/first_in_scene.hpp>
#include <contact/ray_kdop.hpp>
#include <contact/ray_sphere.hpp>

#include <catch2/catch_test_macros.hpp>

namespace degenerate_input {
using namespace contact;
using V = Vector3<double>;
using R = Ray<double>;
using Box = Aabb<double>;
using Tin = Cylinder<double>;
using Pill = Capsule<double>;
using Hat = Cone<double>;
using Ball = Sphere<double>;
using Wall = Triangle<double>;
using L = std::numeric_limits<double>;
constexpr double nan = L::quiet_NaN(), inf = L::infinity(), most = L::max();
const V o = V::Zero();
const Box box{o, {2, 2, 2}};
const OrientedBox<double> oriented{{1, 1, 1}, Matrix3<double>::Identity(), {1, 1, 1}};
const R across{{-1, 1, 1}, {1, 0, 0}}, slow{{-1, 1, 1}, {L::denorm_min(), 0, 0}};
const R at_rest{{1, 1, 1}, o}, outside{{5, 1, 1}, o}, no_numbers{{nan, nan, nan}, {nan, nan, nan}};
const R nan_origin{{nan, 1, 1}, {1, 0, 0}}, nan_direction{{-1, 1, 1}, {1, nan, 0}};
const R inf_origin{{-inf, 1, 1}, {1, 0, 0}}, inf_direction{{-1, 1, 1}, {inf, 0, 0}};

/// Whether a passage is that of a direction of 0 in a body.
bool endless(const auto& x) {
  return x && x->entry == -inf && x->exit == inf && x->entry_normal == o && x->exit_normal == o;
}
void check_none(const auto&... found) {
  ([&] { CHECK_FALSE(found.has_value()); }(), ...);
}
/// What every body with a right decision does; it contains (1, 1, 1) and not (5, 1, 1).
void check_body(const auto& body, double last_t) {
  CHECK(endless(passage(at_rest, body)));
  CHECK(first_hit(at_rest, body)->inside);
  CHECK(passage(slow, body)->entry == last_t);
  CHECK(first_hit(slow, body)->t == last_t);
  for (const R& ray : {outside, nan_origin, nan_direction, inf_origin, inf_direction})
    check_none(passage(ray, body), first_hit(ray, body));
}
void check_no_body(const auto& body) {
  for (const R& ray : {across, R{{-1, -1, -1}, {1, 1, 1}}, at_rest})
    check_none(passage(ray, body), first_hit(ray, body));
}

TEST_CASE("bodies of chapter 04 and degenerate lines") {
  const Tin tin{{{1, 1, 0}, {1, 1, 2}}, 1};
  const Ball ball{{1, 1, 1}, 1};
  check_body(box, inf);
  check_body(oriented, inf);
  check_body(Kdop<double>{{{1, 0, 0}, {0, 1, 0}}, {0, 0}, {2, 2}}, inf);
  check_body(ball, inf);
  check_body(tin, most);
  check_body(Pill{tin.core, 1}, most);
  check_body(Pill{{ball.centre, ball.centre}, 1}, most);
  check_body(Hat{tin.core.end, tin.core.start, 1}, most);
  CHECK(first_hit(slow, box)->point == V(0, 1, 1));
  CHECK(first_hit(slow, oriented)->point == V(inf, 1, 1));
  CHECK(first_hit(slow, ball)->point == V(0, 1, 1));
  CHECK(endless(passage_of_infinite_cylinder(R{{1, 1, 9}, o}, tin)));
  check_none(first_hit_open(at_rest, tin));
  CHECK(first_hit_open(R{{0, 1, 1}, o}, tin));
}

TEST_CASE("what is no body in chapter 04") {
  const Segment<double> path{{1, 1, 1}, {2, 1, 1}};
  for (const double bad : {nan, inf, -inf}) {
    check_no_body(Box{{bad, 0, 0}, {2, 2, 2}});
    check_no_body(Box{o, {2, bad, 2}});
    check_no_body(OrientedBox<double>{{1, bad, 1}, oriented.axes, {1, 1, 1}});
    check_no_body(Kdop<double>{{{1, 0, 0}}, {bad}, {1}});
  }
  check_no_body(Box{{2, 2, 2}, o});
  check_no_body(Kdop<double>{{{1, 0, 0}}, {2}, {1}});
  for (const double bad : {nan, inf, -1.0}) {
    const Tin tin{{{1, 1, 0}, {1, 1, 2}}, bad};
    check_no_body(tin);
    check_none(passage_of_infinite_cylinder(across, tin), first_hit_open(across, tin));
    check_no_body(Ball{{1, 1, 1}, bad});
    check_no_body(Pill{tin.core, bad});
    check_no_body(Hat{tin.core.end, tin.core.start, bad});
    check_none(ball_hits_enlarged_box(path, bad, box));
    CHECK_FALSE(is_ball(Ball{o, bad}));
  }
  CHECK(is_ball(Ball{o, 0}));
  check_no_body(Tin{{{1, 1, 1}, {1, 1, 1}}, 1});
  check_no_body(Hat{{1, 1, 1}, {1, 1, 1}, 1});
  check_none(ball_hits_enlarged_box(path, 1.0, Box{{2, 2, 2}, {1, 1, 1}}));
  CHECK(ball_hits_enlarged_box(path, 1.0, Box{o, {most, most, most}})->inside);
}

TEST_CASE("normals that are 0, and the side of a triangle, in chapter 04") {
  const R ray{{-1, 0.1, 0}, {49, 0, 0}};  // its rounded point is beside the core
  const V a{0, 0.1, -1}, b{0, 0.1, 1}, low{0, 0, -most}, high{0, 0, most};
  const Segment<double> path{{-7, 0.1, 0.2}, {49, 0.3, 0.4}};
  const Wall large{{0, -most, -most}, {0, most, -most}, {0, 0, most}};
  for (const auto& hit :
       {first_hit(ray, Tin{{a, b}, 0}), first_hit_open(ray, Tin{{a, b}, 0}),
        first_hit(ray, Pill{{a, b}, 0}), ball_first_hit(path, 0.0, Box{{0.1, 0, 0}, {1, 1, 1}}),
        first_hit(across, large), first_hit(across, Tin{{low, high}, 1}),
        first_hit(across, Pill{{low, high}, 1}), first_hit(across, Hat{low, high, 2.5})}) {
    CHECK((!hit->inside && hit->normal == o));
  }
  CHECK(std::abs(first_hit(ray, Hat{a, b, 0})->normal.norm() - 1) < 1e-12);
  const Wall wall{{0, -1, -1}, {0, 2, -1}, {0, -1, 2}}, flat{o, {0, 1, 1}, {0, 2, 2}};
  CHECK(first_hit(Segment<double>{{-1, -most, 0}, {1, most, 0}}, wall)->normal == V(-1, 0, 0));
  CHECK(first_hit(Segment<double>{{1, -most, 0}, {-1, most, 0}}, wall)->normal == V(1, 0, 0));
  CHECK(first_hit(R{{-1, 0, 0}, slow.direction}, wall)->t == most);
  check_none(first_hit(R{o, o}, wall), first_hit(R{o, {0, 1, 0}}, wall),
             first_hit(no_numbers, wall), first_hit(across, flat));
}

TEST_CASE("the formulas of the books and degenerate lines, in chapter 04") {
  for (const auto& by : {passage_by_slabs_with_division<double>,
                         passage_by_branchless_slabs<double>, passage_by_padded_slabs<double>}) {
    CHECK(endless(by(at_rest, box)));
    CHECK(by(outside, box)->entry == by(outside, box)->exit);
    CHECK(endless(by(no_numbers, box)));
    CHECK(by(inf_direction, box)->exit == 0);
    CHECK(by(slow, box)->entry == inf);
  }
  for (const R& ray : {at_rest, nan_origin}) CHECK(endless(passage_by_frame(ray, oriented)));
  const R half{{0.5, 0, 0}, o}, line{{-3, 0, 0}, {1, 0, 0}};
  CHECK(passage_by_lecture(half, Ball{o, 1})->exit == std::sqrt(0.75));
  CHECK(std::isnan(passage_by_textbook(half, Ball{o, 1})->entry));
  for (const auto& by : {passage_by_lecture<double>, passage_by_nearest_point<double>}) {
    CHECK(by(line, Ball{o, -1})->entry == 2);
    check_none(by(nan_origin, Ball{o, 1}), by(line, Ball{o, nan}));
  }
  const Segment<double> core{{-1, 0, 0}, {1, 0, 0}}, point{o, o};
  CHECK(passage_by_textbook(line, Tin{point, 1})->exit == inf);
  CHECK(std::isnan(passage_by_textbook(half, Tin{core, 1})->entry_normal.x()));
  for (const double r : {-1.0, nan}) CHECK(passage_by_textbook(line, Tin{core, r})->entry == 2);
  CHECK(capsule_hit_by_textbook(line, Pill{point, -1}) == 2);
  const Hat hat{core.start, core.end, 1};
  check_none(passage_by_nearest_point(half, Ball{o, 1}),
             capsule_hit_by_textbook(half, Pill{core, 1}),
             capsule_hit_by_textbook(line, Pill{core, nan}), passage_of_double_cone(half, hat),
             passage_of_double_cone(nan_origin, hat), passage_of_double_cone(line, Hat{o, o, 1}));
  CHECK(passage_of_double_cone(line, Hat{{-1, 0, 1}, {1, 0, -1}, -1}));
}

TEST_CASE("scenes and bullets with what is no body, chapter 04") {
  using P = Primitive<double>;
  const std::vector<P> scene{Ball{{nan, 1, 1}, 1}, Box{{nan, 0, 0}, {2, 2, 2}}, box};
  const std::span<const P> bodies(scene), empty;
  CHECK(first_in_scene<double>(across, bodies)->index == 2);
  CHECK(all_in_scene<double>(no_numbers, bodies).empty());
  check_none(first_in_scene<double>(across, empty), first_in_scene<double>(no_numbers, bodies));
  const detail::DoubleLine line(across);
  const P ball = Ball{{5, 1, 1}, 1}, missed = Ball{{5, 9, 1}, 1};
  CHECK_FALSE(entered_before<double>(line, {&scene[2], 0}, {&ball, 0}));
  CHECK(entered_before<double>(line, {&scene[2], inf}, {&ball, inf}));
  CHECK(entered_before<double>(line, {&missed, 1}, {&scene[2], 1}));
  const V inside{1, 1, 1}, far{-most, 1, 1}, step{std::nextafter(most, 0), 0, 0};
  for (const auto& bullet : {bullet_by_samples<double>, bullet_by_segments<double>}) {
    CHECK(bullet(inside, o, 1, bodies));
    check_none(bullet(inside, o, 0, bodies), bullet(inside, o, -3, bodies),
               bullet(V(nan, 1, 1), o, 3, bodies), bullet(V(-5, 1, 1), V(inf, 0, 0), 3, bodies),
               bullet(far, step, 2, bodies));  // the second step overflows
  }
  const std::vector<P> wall{Wall{{1, 0, 0}, {1, 3, 0}, {1, 0, 3}}};
  check_none(bullet_by_segments<double>(inside, o, 3, std::span<const P>(wall)));
}

TEST_CASE("a passage, numbers and slabs, chapter 04") {
  const auto between = [](double t, double u) { return Passage<double>{t, u, o, o, 0, 1}; };
  const Segment<double> longest{{-most, 0, 0}, {most, 0, 0}};
  check_none(first_hit(across, between(nan, 1)), first_hit(across, between(0, nan)));
  CHECK_FALSE(all_finite(first_hit(across, between(inf, inf))->point));
  CHECK_FALSE(all_finite(first_hit(longest, between(0.5, 1))->point));
  CHECK(ray_of(longest).direction.x() == inf);
  CHECK(exact_ray_of(longest).direction.x() == Exact(2.0) * Exact(most));
  CHECK((is_finite(longest) && !is_finite(nan_direction)));
  CHECK(upward<float>(-1e300) == std::numeric_limits<float>::lowest());
  CHECK(downward<float>(1e300) == std::numeric_limits<float>::max());
  using E = RunningError;
  CHECK((E(0.0) * E(nan)).is_zero());
  CHECK(E(inf).certain_sign() == 1);
  for (const E& x : {E(nan), E(most) + E(most), sqrt(E(-1.0))}) CHECK(x.certain_sign() == 0);
  CHECK(slab_times<E>(std::vector<Slab<E>>{}).meets);
  CHECK_FALSE(slab_times<E>(std::vector<Slab<E>>{{E(0.0), E(1.0), E(0.0)}}).bounded);
  CHECK_FALSE(slab_times<E>(std::vector<Slab<E>>{{E(nan), E(2.0), E(1.0)}}).sure);
  const OrientedBox<double> flat{{1, 1, 1}, Matrix3<double>::Ones(), {1, 1, 1}};
  for (const auto& slab : slabs_of<Exact>(across, flat)) CHECK(slab.high == slab.low);
  CHECK(endless(passage(across, Kdop<double>{{}, {}, {}})));
  CHECK(endless(passage(across, Kdop<double>{{{0, 0, 0}}, {-1}, {1}})));
  const std::vector<V> normals = kdop_normals<double>(14), ends{{most, most, most}};
  CHECK_FALSE(hits_kdop(R{ends[0], o}, kdop_of_points<double>(normals, ends)));
}
}  // namespace degenerate_input
