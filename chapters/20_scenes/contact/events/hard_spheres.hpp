/// @file
/// Hard, smooth balls from event to event: no step, no penetration, no energy gained.
///
/// Between two hits a ball's path is known, so nothing is computed there. Each ball keeps the time
/// of its own last hit and its state then; an event touches only those that take part. What only an
/// unneeded effect requires is neither stored nor computed: see HardSphereEffects.
///
/// What happens, and when, depends on the balls' states alone, not on the grid or on when the run
/// was stopped. So a grid and all pairs, one run and a resumed one, give the same bits.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <contact/events/earliest_queue.hpp>
#include <contact/events/hard_sphere_run.hpp>
#include <contact/events/hard_sphere_times.hpp>
#include <contact/invalid_argument.hpp>

namespace contact {

namespace detail {

/// Takes the place of a member that no effect needs. Numbered, since two empty members of one type
/// have two addresses.
template <int Number>
struct NotStored {};

template <bool Needed, class T, int Number>
using StoredIf = std::conditional_t<Needed, T, NotStored<Number>>;

}  // namespace detail

// [state]
/// A ball as it was at its last hit, with only the members that some effect needs.
template <HardSphereEffects E>
struct HardSphereState {
  Column<E.dimension> position = Column<E.dimension>::Zero();  ///< m
  Column<E.dimension> velocity = Column<E.dimension>::Zero();  ///< m/s
  double time = 0;                                             ///< of its last hit, s
  std::int32_t last = -1;                                      ///< what it hit last, or −1
  /// The wall on which it lies, or −1.
  [[no_unique_address]] detail::StoredIf<E.gravity, std::int32_t, 0> rests_on;
  /// Number of its last hits in a row that came sooner than the cutoff.
  [[no_unique_address]] detail::StoredIf<E.restitution, std::int32_t, 1> short_flights;
  [[no_unique_address]] detail::StoredIf<E.restitution, std::uint32_t, 2> material;  ///< row
  [[no_unique_address]] detail::StoredIf<E.sizes, double, 3> radius;                 ///< m
  [[no_unique_address]] detail::StoredIf<E.sizes, double, 4> mass;                   ///< kg
};
// [/state]

/// Balls, simulated with the effects E and no others. make_hard_spheres() makes one with the fewest
/// effects that a setup needs.
template <HardSphereEffects E>
class HardSpheres final : public HardSphereRun {
 public:
  static constexpr int dimension = E.dimension;  ///< of the motion
  using Point = Column<dimension>;               ///< m

  /// @param setup checked by require_hard_sphere_setup()
  /// @param axes the world's axes that are kept; the first `dimension` of them
  /// @throws std::invalid_argument if the setup is not valid, or needs an effect that E lacks
  explicit HardSpheres(const HardSphereSetup& setup,
                       const std::array<int, 3>& axes = std::array<int, 3>{0, 1, 2})
      : HardSphereRun(E, axes), moving_(moving_balls(setup)), queue_(moving_) {
    require_hard_sphere_setup(setup);
    require_effects(setup);
    gravity_ = kept(setup.gravity);
    cutoff_ = setup.cutoff;
    if constexpr (E.restitution) {
      restitution_ = setup.restitution;
      while (materials_ * materials_ < restitution_.size()) ++materials_;
    }
    radius_ = setup.balls.front().radius;
    mass_ = setup.balls.front().mass;
    aside_ = setup.balls.front().position;
    balls_.reserve(setup.balls.size());
    hits_.assign(setup.balls.size(), 0);
    for (const HardBall& ball : setup.balls) add(ball);
    for (const HardWall& wall : setup.walls) {
      const Point normal = kept(wall.normal);
      const double pull = normal.dot(gravity_);
      walls_.push_back({normal, gravity_ - normal * pull, wall.offset, wall.material});
    }
    predict_all();
  }

  /// Restores the states of a checkpoint(), earlier or later.
  void restore(const HardSphereCheckpoint& from) override {
    if (from.balls.size() != balls_.size()) {
      throw_invalid_argument("checkpoint", std::to_string(from.balls.size()) + " balls",
                             "this run has " + std::to_string(balls_.size()));
    }
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      const HardSphereCheckpoint::Ball& was = from.balls[i];
      State& ball = balls_[i];
      ball.position = kept(was.position);
      ball.velocity = kept(was.velocity);
      ball.time = was.time;
      ball.last = was.last;
      if constexpr (E.gravity) ball.rests_on = was.rests_on;
      if constexpr (E.restitution) ball.short_flights = was.short_flights;
    }
    now_ = from.now;
    simultaneous_ = from.simultaneous;
    counts_ = from.counts;
    predict_all();
  }

  /// @name See HardSphereRun
  /// @{
  HardSphereCheckpoint checkpoint() const override {
    HardSphereCheckpoint to;
    to.now = now_;
    to.simultaneous = simultaneous_;
    to.counts = counts_;
    for (const State& ball : balls_) {
      HardSphereCheckpoint::Ball is;
      is.position = spread(ball.position);
      is.velocity = spread(ball.velocity);
      is.time = ball.time;
      is.last = ball.last;
      if constexpr (E.gravity) is.rests_on = ball.rests_on;
      if constexpr (E.restitution) is.short_flights = ball.short_flights;
      to.balls.push_back(is);
    }
    return to;
  }

  // [run]
  HardSphereEnd advance(double until, std::uint64_t budget, HardSphereObserver* observer) override {
    for (;;) {
      const std::size_t i = queue_.first();
      const double time = plan_time(i);
      if (!(time <= until)) {
        now_ = std::max(now_, until);
        return HardSphereEnd::reached;
      }
      if (crosses_first(i)) {
        cross(i, time);
        continue;
      }
      const std::int32_t partner = plans_[i].partner;
      const bool is_ball = partner < static_cast<std::int32_t>(balls_.size());
      const auto other = static_cast<std::size_t>(partner);
      if (is_ball && hits_[other] != plans_[i].partner_hits) {
        ++counts_.stale;
        predict(i);
        queue_.update(i, comes_first());
        continue;
      }
      // [/run]
      if (budget-- == 0) return HardSphereEnd::out_of_events;
      const bool new_time = time > now_;
      simultaneous_ = new_time ? 0 : simultaneous_ + 1;
      now_ = std::max(now_, time);
      // Of two balls the one with the lower index is the first, whichever had planned the hit.
      const std::size_t first = is_ball ? std::min(i, other) : i;
      const std::size_t second = is_ball ? std::max(i, other) : other;
      const Point change =
          is_ball ? hit_ball(first, second, time) : hit_wall(first, second - balls_.size(), time);
      after_hit(first);
      if (is_ball && second < moving_) after_hit(second);
      ++counts_.hits;
      const bool second_too = is_ball && second < moving_ && endless(second);
      if (endless(first) || second_too) {
        counts_.endless_ball = endless(first) ? first : second;
        counts_.endless_partner = static_cast<std::int32_t>(endless(first) ? second : first);
        return HardSphereEnd::endless_hits;
      }
      if (observer == nullptr) continue;
      if (!observer->on_hit({time, first, second, spread(change * mass(balls_[first]))}))
        return HardSphereEnd::stopped;
    }
  }
  /// @cond
  using HardSphereRun::advance;
  /// @endcond

  /// Processes the next event alone, of whichever kind, and stops at its time. One after another,
  /// these calls do what advance() does, with the same bits.
  /// @return whether there was an event
  bool advance_one_event(HardSphereObserver* observer = nullptr) {
    const std::size_t i = queue_.first();
    const HardSpherePrediction next = prediction(i);
    if (next.time == never) return false;
    if (next.crossing) {
      cross(i, next.time);
    } else if (next.is_void) {
      now_ = std::max(now_, next.time);
      ++counts_.stale;
      predict(i);
      queue_.update(i, comes_first());
    } else {
      // An observer that wants no more ends advance() right after the hit.
      struct Once final : HardSphereObserver {
        HardSphereObserver* to = nullptr;
        bool on_hit(const HardSphereHit& hit) override {
          if (to != nullptr) to->on_hit(hit);
          return false;
        }
      } once;
      once.to = observer;
      advance(next.time, 1, &once);
    }
    return true;
  }

  /// A moving ball's next event, as stored: this and the next two calls change nothing.
  HardSpherePrediction prediction(std::size_t ball) const {
    const HitPlan& plan = plans_[ball];
    HardSpherePrediction seen;
    seen.time = plan_time(ball);
    seen.crossing = seen.time != never && crosses_first(ball);
    seen.hit_time = plan.hit_time;
    if (plan.hit_time == never) return seen;
    seen.partner = plan.partner;
    const auto other = static_cast<std::size_t>(plan.partner);
    seen.is_void = other < balls_.size() && hits_[other] != plan.partner_hits;
    return seen;
  }
  /// The tournament over the moving balls.
  const EarliestQueue& queue() const { return queue_; }
  /// The cells, and which ball is in which.
  const HardSphereCells<dimension>& cells() const requires(E.grid) { return cells_; }

  double now() const override { return now_; }
  std::size_t moving() const override { return moving_; }

  Vector3<double> position(std::size_t ball) const override {
    const State& b = balls_[ball];
    Vector3<double> x = aside_;
    const Point here = position_at(b, now_ - b.time, acceleration(ball));
    for (int k = 0; k < dimension; ++k) x(axes()[index(k)]) = here(k) + 0.0;  // no −0
    return x;
  }
  Vector3<double> velocity(std::size_t ball) const override {
    const State& b = balls_[ball];
    return spread(velocity_at(b, now_ - b.time, acceleration(ball)));
  }

  std::int32_t rests_on(std::size_t ball) const override {
    if constexpr (E.gravity) return balls_[ball].rests_on;
    (void)ball;
    return -1;
  }

  double energy() const override {
    double sum = 0;
    for (std::size_t i = 0; i < moving_; ++i) {
      const State& ball = balls_[i];
      const double after = now_ - ball.time;
      const Point x = position_at(ball, after, acceleration(i));
      const Point v = velocity_at(ball, after, acceleration(i));
      sum += mass(ball) * (v.dot(v) / 2 - gravity_.dot(x));
    }
    return sum;
  }

  HardSphereCounts counts() const override { return counts_; }

  std::size_t bytes() const override {
    std::size_t all = balls_.capacity() * sizeof(State) + plans_.capacity() * sizeof(Plan) +
                      walls_.capacity() * sizeof(Wall) + queue_.bytes();
    all += hits_.capacity() * sizeof(std::uint32_t) + restitution_.capacity() * sizeof(double);
    all += candidates_.capacity() * sizeof(Candidate);
    if constexpr (E.grid) all += cells_.bytes();
    if constexpr (!E.grid) all += all_balls_.capacity() * sizeof(std::int32_t);
    return all;
  }
  std::size_t bytes_per_state() const override { return sizeof(State); }
  /// @}

 private:
  using State = HardSphereState<E>;

  /// A ball's next event, as far as it is known. If its partner was hit since, it is invalid.
  struct HitPlan {
    double hit_time = never;         // s
    std::int32_t partner = -1;       // what it hits
    std::uint32_t partner_hits = 0;  // the partner's number of hits at the prediction
  };
  struct CellPlan : HitPlan {
    Crossing crossing;
  };
  using Plan = std::conditional_t<E.grid, CellPlan, HitPlan>;

  /// A ball that may be hit, as seen from `since` on.
  struct Candidate {
    Encounter met;
    double since = 0;        // s
    std::int32_t other = 0;  // its index
  };

  struct Wall {
    Point normal;
    Point slide;  // tangential component of gravity for a ball that lies on it, m/s²
    double offset;
    std::size_t material;
  };

  static constexpr std::size_t index(int k) { return static_cast<std::size_t>(k); }

  Point kept(const Vector3<double>& v) const {
    Point p;
    for (int k = 0; k < dimension; ++k) p(k) = v(axes()[index(k)]);
    return p;
  }
  Vector3<double> spread(const Point& p) const {
    Vector3<double> v = Vector3<double>::Zero();
    for (int k = 0; k < dimension; ++k) v(axes()[index(k)]) = p(k) + 0.0;
    return v;
  }

  void add(const HardBall& from) {
    State ball;
    ball.position = kept(from.position);
    ball.velocity = kept(from.velocity);
    if constexpr (E.gravity) ball.rests_on = -1;
    if constexpr (E.restitution) {
      ball.short_flights = 0;
      ball.material = static_cast<std::uint32_t>(from.material);
    }
    if constexpr (E.sizes) {
      ball.radius = from.radius;
      ball.mass = from.mass;
    }
    balls_.push_back(ball);
  }

  // State that an effect keeps for each ball if it is on, and once if it is off.
  double radius(const State& ball) const {
    if constexpr (E.sizes) return ball.radius;
    return radius_;
  }
  double mass(const State& ball) const {
    if constexpr (E.sizes) return ball.mass;
    return mass_;
  }
  double restitution(const State& ball, std::size_t material) const {
    if constexpr (E.restitution) return restitution_[ball.material * materials_ + material];
    return 1;
  }
  std::size_t material(const State& ball) const {
    if constexpr (E.restitution) return ball.material;
    return 0;
  }
  Point acceleration(std::size_t i) const {
    if constexpr (E.gravity) {
      if (i >= moving_) return Point::Zero();
      const std::int32_t wall = balls_[i].rests_on;
      return wall < 0 ? gravity_ : walls_[static_cast<std::size_t>(wall)].slide;
    } else {
      return Point::Zero();
    }
  }

  // [flight]
  [[gnu::always_inline]] static Point position_at(const State& ball, double after,
                                                  const Point& acceleration) {
    if constexpr (E.gravity)
      return detail::along<dimension>(ball.position, ball.velocity, after, acceleration,
                                      after * after / 2);
    else
      return detail::along<dimension>(ball.position, ball.velocity, after);
  }
  [[gnu::always_inline]] static Point velocity_at(const State& ball, double after,
                                                  const Point& acceleration) {
    if constexpr (E.gravity)
      return detail::along<dimension>(ball.velocity, acceleration, after);
    else
      return ball.velocity;
  }
  /// A ball's state at a later time.
  static void fly(State& ball, double to, const Point& acceleration) {
    const double after = to - ball.time;
    ball.position = position_at(ball, after, acceleration);
    ball.velocity = velocity_at(ball, after, acceleration);
    ball.time = to;
  }
  // [/flight]

  // [predict]
  /// Whether and when two balls meet: a function of their two states alone, the same for (i, k) and
  /// (k, i). The one with the earlier last hit is advanced to the time of the other. The most
  /// frequent call of all, so it is inlined.
  /// @param pull acceleration of both
  [[gnu::always_inline]] Candidate candidate(const State& a, const State& b, std::size_t k,
                                             const Point& pull) const {
    const double after = a.time - b.time;
    Point d;
    Point w;
    if (after >= 0) {
      w = detail::between<dimension>(a.velocity, velocity_at(b, after, pull));
      d = detail::between<dimension>(a.position, position_at(b, after, pull));
    } else {
      w = detail::between<dimension>(velocity_at(a, -after, pull), b.velocity);
      d = detail::between<dimension>(position_at(a, -after, pull), b.position);
    }
    return {encounter<dimension>(d, w, radius(a) + radius(b)), after >= 0 ? a.time : b.time,
            static_cast<std::int32_t>(k)};
  }

  /// When two balls meet of which gravity accelerates only one.
  double accelerated_meeting_time(std::size_t i, std::size_t k, bool just_hit) const {
    const bool first_is_later = balls_[i].time >= balls_[k].time;
    const State& late = balls_[first_is_later ? i : k];
    const State& early = balls_[first_is_later ? k : i];
    const Point of_late = acceleration(first_is_later ? i : k);
    const Point of_early = acceleration(first_is_later ? k : i);
    const double after = late.time - early.time;
    const Point d = late.position - position_at(early, after, of_early);
    const Point w = late.velocity - velocity_at(early, after, of_early);
    return late.time + accelerated_meeting<dimension>(d, w, of_late - of_early,
                                                      radius(late) + radius(early), just_hit);
  }

  /// @param a the one that moves
  /// @param pull its acceleration
  bool accelerate_differently(const State& a, const State& b, std::size_t k,
                              const Point& pull) const {
    if (k < moving_ && a.rests_on == b.rests_on) return false;
    return pull != acceleration(k);
  }

  /// @param pull acceleration of the ball
  [[gnu::always_inline]] Arrival wall_arrival(const State& ball, std::size_t w,
                                              const Point& pull) const {
    if constexpr (E.gravity)
      if (ball.rests_on == static_cast<std::int32_t>(w)) return {};
    const Wall& wall = walls_[w];
    double gap = detail::dot<dimension>(wall.normal, ball.position) - wall.offset - radius(ball);
    double velocity = detail::dot<dimension>(wall.normal, ball.velocity);
    if (ball.last == wall_id(w)) {  // just hit; rounding must not repeat it
      gap = 0;
      velocity = std::max(velocity, 0.0);
    }
    return arrival_at_plane(gap, velocity, detail::dot<dimension>(wall.normal, pull));
  }

  /// Keeps the earlier of a ball's plan and a hit at `time`; of two at the same time, the one with
  /// the lower indices.
  void offer(std::size_t i, double time, std::int32_t partner) {
    HitPlan& plan = plans_[i];
    if (time > plan.hit_time || time == never) return;
    const auto self = static_cast<std::int32_t>(i);
    if (time == plan.hit_time && std::minmax(self, plan.partner) <= std::minmax(self, partner))
      return;
    const bool is_ball = partner < static_cast<std::int32_t>(balls_.size());
    plan.hit_time = time;
    plan.partner = partner;
    plan.partner_hits = is_ball ? hits_[static_cast<std::size_t>(partner)] : 0;
  }

  /// Which of some balls a ball hits first. First those that it hits at all are collected, without
  /// branches that a processor cannot predict, and then the times are computed.
  void offer_hits(std::size_t i, std::span<const std::int32_t> others) {
    const State ball = balls_[i];
    const Point pull = acceleration(i);
    const auto self = static_cast<std::int32_t>(i);
    if (candidates_.size() <= others.size()) candidates_.resize(others.size() + 1);
    Candidate* end = candidates_.data();
    for (const std::int32_t other : others) {
      const auto k = static_cast<std::size_t>(other);
      const State& met = balls_[k];
      const bool just_hit = (ball.last == other) & (met.last == self);
      if constexpr (E.gravity) {
        if (accelerate_differently(ball, met, k, pull)) {
          offer(i, accelerated_meeting_time(i, k, just_hit), other);
          continue;
        }
      }
      // Both accelerate equally, so the relative path is straight: after a hit they do not meet
      // again. Relative to itself a ball does not move.
      *end = candidate(ball, met, k, pull);
      end += end->met.meets() & !just_hit;
    }
    for (const Candidate* c = candidates_.data(); c != end; ++c) {
      const double time = c->since + c->met.after();
      if (time <= plans_[i].hit_time) offer(i, time, c->other);
    }
  }

  /// Predicts all that a ball may hit, and when it leaves its cell.
  void predict(std::size_t i) {
    const State& ball = balls_[i];
    const Point pull = acceleration(i);
    plans_[i].hit_time = never;
    for (std::size_t w = 0; w < walls_.size(); ++w) {
      const double time = ball.time + wall_arrival(ball, w, pull).after;
      if (time <= plans_[i].hit_time) offer(i, time, wall_id(w));
    }
    if constexpr (E.grid) {
      // First which, then when: so that the memory of one is loaded while another is computed.
      offer_hits(i, cells_.near(i, fetch()));
    } else {
      offer_hits(i, all_balls_);
    }
  }
  auto fetch() const {
    return [this](std::size_t ball) { __builtin_prefetch(&balls_[ball]); };
  }
  void predict_crossing(std::size_t i) {
    if constexpr (E.grid) {
      const State& ball = balls_[i];
      plans_[i].crossing =
          cells_.next_crossing(i, ball.position, ball.velocity, acceleration(i), ball.time, now_);
    }
  }
  // [/predict]

  void predict_all() {
    plans_.assign(moving_, Plan());
    if constexpr (!E.grid) {
      all_balls_.resize(balls_.size());
      std::iota(all_balls_.begin(), all_balls_.end(), 0);
    } else {
      make_cells();
      for (std::size_t i = 0; i < balls_.size(); ++i)
        cells_.insert(i, position_at(balls_[i], now_ - balls_[i].time, acceleration(i)));
    }
    for (std::size_t i = 0; i < moving_; ++i) {
      predict(i);
      predict_crossing(i);
    }
    queue_.play_all(comes_first());
  }

  /// The grid over the walls' box, or without walls over the region that the balls' energy lets
  /// them reach at once.
  void make_cells() {
    constexpr double wide = std::numeric_limits<double>::max();
    Point low = Point::Constant(wide);
    Point high = Point::Constant(-wide);
    double widest = 0;
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      const State& ball = balls_[i];
      widest = std::max(widest, 2 * radius(ball));
      for (int k = 0; k < dimension; ++k) {
        const double x = ball.position(k);
        const double v = ball.velocity(k);
        const double g = gravity_(k);
        const double rise = g == 0 ? 0 : v * v / (2 * g);  // height of its apex, against gravity
        low(k) = std::min({low(k), x, x - rise});
        high(k) = std::max({high(k), x, x - rise});
      }
    }
    for (const Wall& wall : walls_) {
      for (int k = 0; k < dimension; ++k) {
        if (wall.normal(k) == 1) low(k) = std::min(high(k), wall.offset);
        if (wall.normal(k) == -1) high(k) = std::max(low(k), -wall.offset);
      }
    }
    cells_ = HardSphereCells<dimension>(low, high, widest, balls_.size());
  }

  /// The order of events: by time, then by the indices of those that take part.
  auto comes_first() const {
    return [this](std::size_t i, std::size_t k) {
      const double time_i = plan_time(i);
      const double time_k = plan_time(k);
      if (time_i != time_k) return time_i < time_k;
      const auto who_i = participants(i);
      const auto who_k = participants(k);
      return who_i != who_k ? who_i < who_k : i < k;
    };
  }
  double plan_time(std::size_t i) const {
    if constexpr (E.grid) return std::min(plans_[i].hit_time, plans_[i].crossing.time);
    return plans_[i].hit_time;
  }
  bool crosses_first(std::size_t i) const {
    if constexpr (E.grid) return plans_[i].crossing.time <= plans_[i].hit_time;
    return i >= moving_;
  }
  std::pair<std::int32_t, std::int32_t> participants(std::size_t i) const {
    const auto self = static_cast<std::int32_t>(i);
    if (crosses_first(i)) return {-1, self};
    return std::minmax(self, std::int32_t{plans_[i].partner});
  }
  std::int32_t wall_id(std::size_t w) const { return static_cast<std::int32_t>(balls_.size() + w); }

  void cross(std::size_t i, double time) {
    if constexpr (E.grid) {
      now_ = std::max(now_, time);
      ++counts_.crossings;
      const Crossing crossing = plans_[i].crossing;
      cells_.cross(i, crossing);
      offer_hits(i, cells_.newly_near(i, crossing, fetch()));
      predict_crossing(i);
      queue_.update(i, comes_first());
    }
  }

  // [hits]
  /// Two balls hit: the component of the relative velocity along the line of impact is reversed and
  /// multiplied by e. The impulse acts along the stored line of centres, so that momentum and, for
  /// e = 1, energy change by rounding only, wherever they are.
  /// @return the change of the first one's velocity
  Point hit_ball(std::size_t i, std::size_t k, double time) {
    State& a = balls_[i];
    State& b = balls_[k];
    record_flight(i, time);
    fly(a, time, acceleration(i));
    if (k < moving_) {
      record_flight(k, time);
      fly(b, time, acceleration(k));
    } else {
      b.time = time;
    }
    const Point d = b.position - a.position;
    const Point w = b.velocity - a.velocity;
    const double square = d.dot(d);
    const double radius_sum = radius(a) + radius(b);
    counts_.largest_overlap =
        std::max(counts_.largest_overlap, (radius_sum * radius_sum - square) / (2 * radius_sum));
    const double closing = d.dot(w);
    Point change = Point::Zero();
    if (closing < 0) {
      const double both = 1 + restitution(a, material(b));
      const double push = closing / square;
      const double share = k < moving_ ? mass(b) / (mass(a) + mass(b)) : 1;
      change = d * (both * share * push);
      a.velocity += change;
      if (k < moving_) b.velocity -= d * (both * (mass(a) / (mass(a) + mass(b))) * push);
    }
    a.last = static_cast<std::int32_t>(k);
    b.last = static_cast<std::int32_t>(i);
    leave_rest(a);
    if (k < moving_) leave_rest(b);
    return change;
  }

  /// A ball hits a wall. Its normal speed on arrival is a root of its energy.
  /// @return the change of its velocity
  Point hit_wall(std::size_t i, std::size_t w, double time) {
    State& ball = balls_[i];
    const Wall& wall = walls_[w];
    const Point pull = acceleration(i);
    const double speed = wall_arrival(ball, w, pull).speed;
    record_flight(i, time);
    fly(ball, time, pull);
    const double gap = wall.normal.dot(ball.position) - wall.offset - radius(ball);
    counts_.largest_overlap = std::max(counts_.largest_overlap, -gap);
    ball.position -= wall.normal * gap;
    const Point before = ball.velocity;
    const Point along = before - wall.normal * wall.normal.dot(before);
    const double leaving = restitution(ball, wall.material) * speed;
    ball.last = wall_id(w);
    if constexpr (E.gravity) {
      const double pressed = -wall.normal.dot(pull);
      if (pressed > 0 && 2 * leaving <= pressed * shortest_bounce(time)) {
        ball.velocity = along;
        ball.rests_on = static_cast<std::int32_t>(w);
        ++counts_.rests;
        counts_.rest_error += leaving * leaving / (2 * pressed);
        return ball.velocity - before;
      }
    }
    ball.velocity = along + wall.normal * leaving;
    leave_rest(ball);
    return ball.velocity - before;
  }
  // [/hits]

  /// A bounce ends at once if it is shorter than the cutoff, or than time can resolve.
  double shortest_bounce(double time) const {
    return std::max(cutoff_, 4 * std::numeric_limits<double>::epsilon() * time);
  }

  /// A ball that was pushed off its wall, or into it, flies again; one that was pushed tangentially
  /// stays.
  void leave_rest(State& ball) {
    if constexpr (E.gravity) {
      if (ball.rests_on < 0) return;
      if (walls_[static_cast<std::size_t>(ball.rests_on)].normal.dot(ball.velocity) != 0)
        ball.rests_on = -1;
    }
  }

  void record_flight(std::size_t i, double time) {
    if constexpr (E.restitution) {
      State& ball = balls_[i];
      ball.short_flights = time - ball.time < cutoff_ ? ball.short_flights + 1 : 0;
    }
    ++hits_[i];
  }

  void after_hit(std::size_t i) {
    predict(i);
    predict_crossing(i);
    queue_.update(i, comes_first());
  }

  /// Whether a ball hits too often: more than 1,000 short flights in a row, or at one instant a
  /// million hits of all balls (and a thousand for each).
  bool endless(std::size_t i) const {
    if constexpr (E.restitution)
      if (balls_[i].short_flights > 1000) return true;
    return simultaneous_ > 1000000 + 1000 * moving_;
  }

  void require_effects(const HardSphereSetup& setup) const {
    const auto refuse = [](const char* effect) {
      throw_invalid_argument(effect, "off", "this setup calls for it");
    };
    if (!E.gravity && !setup.gravity.isZero(0)) refuse("gravity");
    for (const double e : setup.restitution)
      if (!E.restitution && e != 1) refuse("restitution");
    for (std::size_t i = 0; i < setup.balls.size(); ++i) {
      const bool differs = setup.balls[i].radius != setup.balls.front().radius ||
                           (i < moving_ && setup.balls[i].mass != setup.balls.front().mass);
      if (!E.sizes && differs) refuse("sizes");
    }
  }

  std::size_t moving_ = 0;
  double now_ = 0;                  // s
  std::uint64_t simultaneous_ = 0;  // hits at the present instant
  double cutoff_ = 0;               // s
  double radius_ = 0;               // of every ball, if all are equal, m
  double mass_ = 0;                 // the same of masses, kg
  Point gravity_ = Point::Zero();
  Vector3<double> aside_ = Vector3<double>::Zero();  // common position along axes that are not kept
  std::size_t materials_ = 0;
  std::vector<double> restitution_;
  std::vector<State> balls_;
  std::vector<std::uint32_t> hits_;  // of each ball, with partner_hits
  [[no_unique_address]] detail::StoredIf<!E.grid, std::vector<std::int32_t>, 6> all_balls_;
  std::vector<Candidate> candidates_;
  std::vector<Wall> walls_;
  std::vector<Plan> plans_;
  EarliestQueue queue_;
  detail::StoredIf<E.grid, HardSphereCells<dimension>, 5> cells_;
  HardSphereCounts counts_;
};

}  // namespace contact
