// Elastic discs on a table that is divided into cells, from event to event: what each predicts, and
// the tournament of the predictions.
#include <algorithm>
#include <contact/events/hard_spheres.hpp>
#include <contact/figure.hpp>
#include <tuple>

using Vector2 = Eigen::Matrix<double, 2, 1>;

constexpr std::size_t discs = 7;
constexpr std::size_t most = 24;   // events
constexpr std::size_t leaves = 8;  // of the tournament
constexpr std::size_t most_cells = 40;
constexpr double radius = 0.3;
constexpr double width = 4;
constexpr double height = 3;

struct Input {
  Vector2 position_a, position_b, position_c, position_d, position_e, position_f, position_g;  // m
  Vector2 velocity_a, velocity_b, velocity_c, velocity_d, velocity_e, velocity_f,
      velocity_g;  // m/s
  double event;    // how many events have been processed
};

struct Output {
  double problem;
  double event, time;                     // events processed, and when the last was, s
  std::array<Vector2, discs> start;       // m; discs that overlapped are pushed apart
  std::array<Vector2, discs> stored;      // m, as of the last hit
  std::array<Vector2, discs> now;         // m
  std::array<Vector2, discs> meeting;     // m, where the predicted hit would find it
  std::array<double, discs> hit_time;     // s, predicted; infinite: none
  std::array<double, discs> partner;      // another disc, 7 … 10: a wall; −1: none
  std::array<double, discs> is_void;      // 1: the partner was hit since
  std::array<double, discs> next_time;    // s, of the hit or of leaving the cell
  std::array<double, discs> crosses;      // 1: it leaves its cell first
  double kind, who, whom;                 // of the last event: 0: none, 1: hit, 2: crossing, 3:
                                          // void; and the two that took part
  double columns, rows, cell;             // cells, and their edge, m
  std::array<double, most_cells> seen;    // 1: in or next to an event's disc's cell; 2: searched
  std::array<double, 2 * leaves> winner;  // at each node of the tournament; −1: none
  std::array<double, 2 * leaves> played;  // how often a node was played after this event
  double matches;                         // after this event
  std::array<double, most> kinds, made_void;  // of the first events, as far as there are any
  double hits, crossings, voids;              // processed
  double tests, all_tests;                    // of pairs of discs: with cells, and without
  double two_at_once;  // goal: this is one of the first ten events, and makes two predictions void
};

namespace {

constexpr contact::HardSphereEffects with_cells{
    .dimension = 2, .gravity = false, .sizes = false, .restitution = false, .grid = true};
constexpr contact::HardSphereEffects all_pairs{
    .dimension = 2, .gravity = false, .sizes = false, .restitution = false, .grid = false};
using Run = contact::HardSpheres<with_cells>;
using Cell = std::array<std::int32_t, 2>;

struct LastHit final : contact::HardSphereObserver {
  contact::HardSphereHit hit;
  bool on_hit(const contact::HardSphereHit& seen) override {
    hit = seen;
    return true;
  }
};

/// Discs are moved into the table and apart. @return whether they have room
bool make_room(std::array<Vector2, discs>& x) {
  constexpr double room = 1e-6;
  for (int round = 0; round < 200; ++round) {
    bool apart = true;
    for (std::size_t i = 0; i < discs; ++i) {
      x[i].x() = std::clamp(x[i].x(), radius, width - radius);
      x[i].y() = std::clamp(x[i].y(), radius, height - radius);
    }
    for (std::size_t i = 0; i < discs; ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const Vector2 d = x[i] - x[k];
        const double distance = d.norm();
        if (distance >= 2 * radius) continue;
        apart = false;
        const Vector2 axis = distance > 0 ? Vector2(d / distance) : Vector2(1, 0);
        x[i] += axis * (radius - distance / 2 + room);
        x[k] -= axis * (radius - distance / 2 + room);
      }
    }
    if (apart) return true;
  }
  return false;
}

/// The cells that are searched for partners of a disc: all round its own, or only those that became
/// neighbours when it came from another one.
struct Searched {
  Cell low, high;
  bool has(const Cell& c) const {
    return c[0] >= low[0] && c[0] <= high[0] && c[1] >= low[1] && c[1] <= high[1];
  }
};

Searched around(const Run& run, std::size_t disc) {
  const Cell& at = run.cells().cell(disc);
  return {{at[0] - 1, at[1] - 1}, {at[0] + 1, at[1] + 1}};
}

Searched newly_around(const Run& run, std::size_t disc, const Cell& before) {
  Searched cells = around(run, disc);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::int32_t now = run.cells().cell(disc)[k];
    if (now > before[k]) cells.low[k] = now + 1;
    if (now < before[k]) cells.high[k] = now - 1;
  }
  return cells;
}

/// How many discs are tested in these cells.
double tests(const Run& run, std::size_t disc, const Searched& cells) {
  double count = 0;
  for (std::size_t i = 0; i < discs; ++i) count += i != disc && cells.has(run.cells().cell(i));
  return count;
}

/// What is shown of one event.
struct Event {
  double kind = 0;
  std::size_t who = 0, whom = 0;
  std::array<contact::HardSpherePrediction, discs> before;
  contact::EarliestQueue queue{discs};  // before
  Cell from{};                          // its cell before
  double made_void = 0;                 // predictions
};

/// The next event of a run. @return whether there was one
bool advance(Run& run, Event& event) {
  event.queue = run.queue();
  for (std::size_t i = 0; i < discs; ++i) event.before[i] = run.prediction(i);
  const std::size_t first = run.queue().first();
  event.who = event.whom = first;
  event.from = run.cells().cell(first);
  event.kind = event.before[first].crossing ? 2 : event.before[first].is_void ? 3 : 1;
  LastHit last;
  if (!run.advance_one_event(&last)) return false;
  if (event.kind == 1) {
    event.who = last.hit.ball;
    event.whom = last.hit.partner;
  }
  event.made_void = 0;
  for (std::size_t i = 0; i < discs; ++i)
    event.made_void += run.prediction(i).is_void && !event.before[i].is_void;
  return true;
}

/// Plays again the matches of a disc, and counts them by node.
void replay(contact::EarliestQueue& queue, std::size_t disc,
            const std::array<contact::HardSpherePrediction, discs>& by, Output& out) {
  const auto order = [&by](std::size_t i) {
    const auto self = static_cast<std::int32_t>(i);
    const auto two = by[i].crossing
                         ? std::pair(-1, self)
                         : std::pair(std::min(self, by[i].partner), std::max(self, by[i].partner));
    return std::tuple(by[i].time, two.first, two.second, self);
  };
  const contact::EarliestQueue before = queue;
  queue.update(disc, [&](std::size_t i, std::size_t k) { return order(i) < order(k); });
  for (std::size_t node = (leaves + disc) / 2; node >= 1; node /= 2) {
    ++out.played[node];
    // Without an opponent there is no match.
    out.matches += queue.winner(2 * node + 1) >= 0;
    const std::int32_t winner = queue.winner(node);
    if (winner == before.winner(node) && winner != static_cast<std::int32_t>(disc)) break;
  }
}

void show_state(const Run& run, Output& out) {
  const auto checkpoint = run.checkpoint();
  for (std::size_t i = 0; i < discs; ++i) {
    const auto& stored = checkpoint.balls[i];
    const contact::HardSpherePrediction next = run.prediction(i);
    out.stored[i] = stored.position.head<2>();
    out.now[i] = run.position(i).head<2>();
    out.hit_time[i] = next.hit_time;
    out.partner[i] = next.partner;
    out.is_void[i] = next.is_void;
    out.next_time[i] = next.time;
    out.crosses[i] = next.crossing;
    out.meeting[i] = out.now[i];
    if (next.partner >= 0)
      out.meeting[i] += stored.velocity.head<2>() * (next.hit_time - run.now());
  }
  for (std::size_t node = 1; node < 2 * leaves; ++node) out.winner[node] = run.queue().winner(node);
  out.time = run.now();
  const contact::HardSphereCounts did = run.counts();
  out.hits = static_cast<double>(did.hits);
  out.crossings = static_cast<double>(did.crossings);
  out.voids = static_cast<double>(did.stale);
}

void show_event(const Run& run, const Event& event, Output& out) {
  out.kind = event.kind;
  out.who = static_cast<double>(event.who);
  out.whom = event.kind == 1   ? static_cast<double>(event.whom)
             : event.kind == 3 ? static_cast<double>(event.before[event.who].partner)
                               : -1;
  std::array<std::size_t, 2> changed{event.who, event.whom};
  const std::size_t count = event.kind == 1 && event.whom < discs ? 2 : 1;
  contact::EarliestQueue queue = event.queue;
  auto by = event.before;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t disc = changed[k];
    by[disc] = run.prediction(disc);
    replay(queue, disc, by, out);
    const Searched near = around(run, disc);
    const Searched now = event.kind == 2 ? newly_around(run, disc, event.from) : near;
    for (std::int32_t row = 0; row < out.rows; ++row) {
      for (std::int32_t column = 0; column < out.columns; ++column) {
        double& seen = out.seen[static_cast<std::size_t>(row * out.columns + column)];
        if (near.has({column, row})) seen = std::max(seen, 1.0);
        if (now.has({column, row})) seen = 2;
      }
    }
  }
}

/// The same hits without cells: each prediction tests all other discs.
double tests_without_cells(const contact::HardSphereSetup& setup, const Run& until) {
  contact::HardSpheres<all_pairs> run(setup);
  double predictions = discs;
  for (;;) {
    const auto next = run.prediction(run.queue().first());
    const bool done = run.counts().hits == until.counts().hits && !next.is_void;
    if (done || !(next.time <= until.now())) return predictions * (discs - 1);
    LastHit last;
    run.advance_one_event(&last);
    predictions += !next.is_void && last.hit.partner < discs ? 2 : 1;
  }
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  out.start = {in.position_a, in.position_b, in.position_c, in.position_d,
               in.position_e, in.position_f, in.position_g};
  const std::array<Vector2, discs> velocity{in.velocity_a, in.velocity_b, in.velocity_c,
                                            in.velocity_d, in.velocity_e, in.velocity_f,
                                            in.velocity_g};
  for (const Vector2& v : velocity)
    if (v.cwiseAbs().maxCoeff() > 20) out.problem = contact::figure::too_large;
  if (out.problem == 0 && !make_room(out.start)) out.problem = contact::figure::coincident_points;
  if (out.problem != 0) {
    out.start.fill(Vector2::Zero());
    return out;
  }
  contact::HardSphereSetup setup;
  for (std::size_t i = 0; i < discs; ++i) {
    setup.balls.push_back({.position = {out.start[i].x(), out.start[i].y(), 0},
                           .velocity = {velocity[i].x(), velocity[i].y(), 0},
                           .radius = radius,
                           .mass = 1});
  }
  setup.walls = {{{1, 0, 0}, 0}, {{-1, 0, 0}, -width}, {{0, 1, 0}, 0}, {{0, -1, 0}, -height}};

  Run run(setup);
  out.columns = static_cast<double>(run.cells().count(0));
  out.rows = static_cast<double>(run.cells().count(1));
  out.cell = run.cells().width();
  for (std::size_t i = 0; i < discs; ++i) out.tests += tests(run, i, around(run, i));
  show_state(run, out);
  out.all_tests = tests_without_cells(setup, run);
  const auto shown = static_cast<std::size_t>(
      std::nearbyint(std::clamp(in.event, 0.0, static_cast<double>(most))));
  Event event;
  for (std::size_t n = 1; n <= most && advance(run, event); ++n) {
    out.kinds[n - 1] = event.kind;
    out.made_void[n - 1] = event.made_void;
    if (n > shown) continue;
    const bool two = event.kind == 1 && event.whom < discs;
    out.tests +=
        tests(run, event.who,
              event.kind == 2 ? newly_around(run, event.who, event.from) : around(run, event.who));
    if (two) out.tests += tests(run, event.whom, around(run, event.whom));
    out.event = static_cast<double>(n);
    if (n < shown) continue;
    show_state(run, out);
    show_event(run, event, out);
    out.all_tests = tests_without_cells(setup, run);
    out.two_at_once = n <= 10 && event.made_void >= 2 ? 1 : 0;
  }
  return out;
}

FIGURE(Input,
       FIELDS(position_a, position_b, position_c, position_d, position_e, position_f, position_g,
              velocity_a, velocity_b, velocity_c, velocity_d, velocity_e, velocity_f, velocity_g,
              event),
       Output,
       FIELDS(problem, event, time, start, stored, now, meeting, hit_time, partner, is_void,
              next_time, crosses, kind, who, whom, columns, rows, cell, seen, winner, played,
              matches, kinds, made_void, hits, crossings, voids, tests, all_tests, two_at_once))
