// The right run tests all pairs before each hit and has no queue. It counts in 1/1680 of a metre
// and of a second, and is exact: tiles of equal mass exchange velocities, so along each axis they
// follow straight lines whose coordinates at time 0 are multiples of 0.5 m, and two of them meet
// at a multiple of 0.5 s over a difference of velocities, which is at most 8; 840 is divisible by
// all numbers up to 8. The given code must be wrong by 0.01 m, far more than its rounding errors.
#include "break_the_queue.hpp"
#include "queue_of_hits.hpp"

#include <support/break_it.hpp>

namespace {

using namespace contact::testing;
using exercise::Tiles;
using Whole = std::int64_t;

constexpr Whole kOne = 1680;
constexpr Whole kEnd = 10 * kOne;

struct WholeTile {
  std::array<Whole, 2> position, velocity;
};

struct WholeHit {
  Whole time;
  std::size_t first, second;

  bool is_of(std::size_t i) const { return first == i || second == i; }
  bool is_of(std::size_t i, std::size_t k) const { return is_of(i) && is_of(k) && i != k; }
};

/// A prediction of which the partner, and not the owner, is hit before its time.
struct Void {
  std::size_t owner, partner;
  Whole since, time;
};

struct RightRun {
  std::vector<WholeHit> hits;
  std::vector<Void> voids;
  std::vector<WholeTile> tiles;
  bool corners = false;       ///< two tiles touch at their corners alone
  bool simultaneous = false;  ///< two hits happen at the same time
  bool at_the_end = false;    ///< a hit happens at the end
};

struct Meeting {
  Whole after;
  bool at_corners;
};

std::optional<Meeting> meeting(const WholeTile& a, const WholeTile& b, std::size_t axis) {
  const auto distance = [&](std::size_t k) { return b.position[k] - a.position[k]; };
  const auto velocity = [&](std::size_t k) { return b.velocity[k] - a.velocity[k]; };
  const Whole gap = std::abs(distance(axis)) - kOne;
  const Whole closing = distance(axis) > 0 ? -velocity(axis) : velocity(axis);
  if (gap < 0 || closing <= 0) return std::nullopt;
  const Whole after = gap / closing;
  const Whole offset = std::abs(distance(1 - axis) + velocity(1 - axis) * after);
  if (offset > kOne) return std::nullopt;
  return Meeting{after, offset == kOne};
}

void advance(std::vector<WholeTile>& tiles, Whole time) {
  for (WholeTile& tile : tiles)
    for (std::size_t k = 0; k < 2; ++k) tile.position[k] += tile.velocity[k] * time;
}

std::vector<WholeTile> whole_tiles(const Tiles& tiles) {
  std::vector<WholeTile> whole(tiles.positions.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      whole[i].position[k] = static_cast<Whole>(2 * tiles.positions[i][axis]) * kOne / 2;
      whole[i].velocity[k] = static_cast<Whole>(tiles.velocities[i][axis]);
    }
  }
  return whole;
}

/// The run, up to `until` or to the first meeting that the rules exclude.
RightRun right_run(const Tiles& start, Whole until = kEnd) {
  RightRun run;
  std::vector<WholeTile>& tiles = run.tiles = whole_tiles(start);
  const std::size_t count = tiles.size();
  std::vector<Whole> last(count, 0);  // time of the last hit of each
  Whole now = 0;
  while (true) {
    WholeHit next{until + 1, 0, 0};
    std::size_t along = 0, together = 0;
    bool corners = false;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = i + 1; k < count; ++k) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
          const auto found = meeting(tiles[i], tiles[k], axis);
          if (!found || now + found->after > next.time) continue;
          if (now + found->after < next.time) corners = false, together = 0;
          next = {now + found->after, i, k};
          along = axis;
          corners = corners || found->at_corners;
          ++together;
        }
      }
    }
    if (next.time > until) break;
    run.corners = corners;
    run.simultaneous = !corners && together > 1;
    run.at_the_end = next.time == kEnd;
    if (run.corners || run.simultaneous || run.at_the_end) break;
    advance(tiles, next.time - now);
    now = next.time;
    for (std::size_t owner = 0; owner < count; ++owner) {
      for (const std::size_t partner : {next.first, next.second}) {
        if (next.is_of(owner) || last[owner] < last[partner]) continue;
        for (std::size_t axis = 0; axis < 2; ++axis) {
          const auto expected = meeting(tiles[owner], tiles[partner], axis);
          if (expected && !expected->at_corners)
            run.voids.push_back({owner, partner, now, now + expected->after});
        }
      }
    }
    std::swap(tiles[next.first].velocity[along], tiles[next.second].velocity[along]);
    last[next.first] = last[next.second] = now;
    run.hits.push_back(next);
  }
  advance(tiles, until - now);
  return run;
}

// ---------------------------------------------------------------- where the given code is wrong

using Vectors = std::vector<Eigen::Vector2d>;

given::Run given_run(const Tiles& start) {
  return given::run(start.positions, start.velocities, 10);
}

Vectors right_positions(const Tiles& start) {
  Vectors positions;
  for (const WholeTile& tile : right_run(start).tiles)
    positions.emplace_back(static_cast<double>(tile.position[0]) / kOne,
                           static_cast<double>(tile.position[1]) / kOne);
  return positions;
}

double error(const Tiles& start) {
  const Vectors given = given_run(start).positions, right = right_positions(start);
  double most = 0;
  for (std::size_t i = 0; i < given.size(); ++i)
    most = std::max(most, (given[i] - right[i]).norm());
  return most;
}

bool is_wrong(const Tiles& start) { return error(start) > 0.01; }

/// The first hit of the given code that does not happen.
std::optional<given::Hit> first_wrong_hit(const Tiles& start) {
  const std::vector<given::Hit> hits = given_run(start).hits;
  const std::vector<WholeHit> right = right_run(start).hits;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (i == right.size() || !right[i].is_of(hits[i].first, hits[i].second) ||
        std::abs(hits[i].time * kOne - static_cast<double>(right[i].time)) > 0.01)
      return hits[i];
  }
  return std::nullopt;
}

/// Whether two tiles hit each other after the given time in s.
bool hit_after(const Tiles& start, std::size_t i, std::size_t k, double time) {
  const std::vector<WholeHit> hits = right_run(start).hits;
  return std::any_of(hits.begin(), hits.end(), [&](const WholeHit& hit) {
    return hit.is_of(i, k) && static_cast<double>(hit.time) > time * kOne + 0.01;
  });
}

/// Whether the two tiles of the first wrong hit hit each other later.
bool is_too_early(const Tiles& start) {
  const auto hit = first_wrong_hit(start);
  return hit && hit_after(start, hit->first, hit->second, hit->time);
}

/// Whether the two tiles of the first wrong hit never hit each other.
bool never_happens(const Tiles& start) {
  const auto hit = first_wrong_hit(start);
  return hit && !hit_after(start, hit->first, hit->second, -1);
}

bool same_number_of_hits(const Tiles& start) {
  return given_run(start).hits.size() == right_run(start).hits.size();
}

/// Twice the kinetic energy per mass.
double sum_of_squares(const Vectors& velocities) {
  double sum = 0;
  for (const Eigen::Vector2d& velocity : velocities) sum += velocity.squaredNorm();
  return sum;
}

/// What the given code says of the start, in sentences.
std::string told(const Tiles& start) {
  const std::size_t counted = given_run(start).hits.size();
  std::string text = "The code counts " + std::to_string(counted) + " hits, and there are " +
                     std::to_string(right_run(start).hits.size()) + ".";
  const auto hit = first_wrong_hit(start);
  if (!hit) return text;
  const auto time = static_cast<Whole>(std::llround(hit->time * kOne));
  const std::vector<WholeTile> then = right_run(start, time).tiles;
  std::array<double, 2> apart{};
  for (std::size_t k = 0; k < 2; ++k) {
    const Whole distance = then[hit->first].position[k] - then[hit->second].position[k];
    apart[k] = static_cast<double>(std::max<Whole>(0, std::abs(distance) - kOne)) / kOne;
  }
  text += " Its first wrong hit is one of tiles " + std::to_string(hit->first) + " and " +
          std::to_string(hit->second) + " after " + contact::text_of(hit->time, {.digits = 3}) +
          " s, when they are " + contact::text_of(std::hypot(apart[0], apart[1]), {.digits = 3}) +
          " m apart.";
  if (sum_of_squares(start.velocities) == sum_of_squares(given_run(start).velocities))
    text += " The kinetic energy is right all the same.";
  return text;
}

auto judged(bool (*asked_for)(const Tiles&)) {
  return [asked_for](const Tiles& start) {
    return Judged{is_wrong(start) && asked_for(start),
                  contact::text_of(given_run(start).positions, {.digits = 4}),
                  contact::text_of(right_positions(start), {.digits = 4}), told(start)};
  };
}

// ---------------------------------------------------------------- what was not found

bool is_void_within(const Void& one) { return one.time < kEnd; }

bool no_prediction_is_void(const Tiles& start) { return right_run(start).voids.empty(); }

bool all_void_after_the_end(const Tiles& start) {
  const std::vector<Void> voids = right_run(start).voids;
  return std::none_of(voids.begin(), voids.end(), is_void_within);
}

/// Whether all tiles are in one row, or in one column, and stay there.
bool in_one_row(const Tiles& start) {
  const std::vector<WholeTile> tiles = whole_tiles(start);
  const auto same = [&](std::size_t k) {
    return std::all_of(tiles.begin(), tiles.end(), [&](const WholeTile& tile) {
      return tile.position[k] == tiles[0].position[k] && tile.velocity[k] == tiles[0].velocity[k];
    });
  };
  return same(0) || same(1);
}

/// Whether the two tiles of a void prediction hit each other at its time all the same.
bool void_hit_happens(const Tiles& start) {
  const RightRun run = right_run(start);
  return std::any_of(run.voids.begin(), run.voids.end(), [&](const Void& one) {
    return std::any_of(run.hits.begin(), run.hits.end(), [&](const WholeHit& hit) {
      return hit.is_of(one.owner, one.partner) && hit.time == one.time;
    });
  });
}

/// Whether the owner of each void prediction for a time before the end is hit before that time.
bool owners_hit_first(const Tiles& start) {
  const RightRun run = right_run(start);
  return std::all_of(run.voids.begin(), run.voids.end(), [&](const Void& one) {
    return !is_void_within(one) ||
           std::any_of(run.hits.begin(), run.hits.end(), [&](const WholeHit& hit) {
             return hit.is_of(one.owner) && hit.time > one.since && hit.time < one.time;
           });
  });
}

/// Whether the given code has a hit that does not happen, and ends with the right positions.
bool wrong_hit_without_effect(const Tiles& start) {
  return !is_wrong(start) && first_wrong_hit(start);
}

bool on_half_metres(const Tiles& tiles) {
  return std::all_of(tiles.positions.begin(), tiles.positions.end(), [](const Eigen::Vector2d& at) {
    return all_within(at, 20) && all_whole(Eigen::Vector2d(2 * at));
  });
}

bool none_touch(const Tiles& tiles) {
  for (std::size_t i = 0; i < tiles.positions.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if ((tiles.positions[i] - tiles.positions[k]).lpNorm<Eigen::Infinity>() <= 1) return false;
    }
  }
  return true;
}

BreakIt<Tiles> question(std::string_view text) {
  return break_it<Tiles>(text)
      .rule("there are as many velocities as positions, at most six",
            [](const Tiles& tiles) {
              return tiles.positions.size() <= 6 &&
                     tiles.velocities.size() == tiles.positions.size();
            })
      .rule("every coordinate is a multiple of 0.5 m from -20 to 20 m", on_half_metres)
      .rule("every component of a velocity is a whole number from -4 to 4 m/s",
            [](const Tiles& tiles) {
              return all_within(tiles.velocities, 4) && all_whole(tiles.velocities);
            })
      .rule("no two tiles touch at the start", none_touch)
      .rule("no two tiles touch at their corners alone",
            [](const Tiles& tiles) { return !right_run(tiles).corners; })
      .rule("no two hits happen at the same time",
            [](const Tiles& tiles) { return !right_run(tiles).simultaneous; })
      .rule("no hit happens at the end",
            [](const Tiles& tiles) { return !right_run(tiles).at_the_end; })
      .suspect_if("break-no-prediction-is-void", no_prediction_is_void)
      .suspect_if("break-tiles-in-one-row", in_one_row)
      .suspect_if("break-void-after-the-end", all_void_after_the_end)
      .suspect_if("break-hit-without-effect", wrong_hit_without_effect)
      .suspect_if("break-void-hit-happens",
                  [](const Tiles& tiles) { return !is_wrong(tiles) && void_hit_happens(tiles); })
      .suspect_if("break-owner-is-hit-first",
                  [](const Tiles& tiles) { return !is_wrong(tiles) && owners_hit_first(tiles); });
}

}  // namespace

TEST_CASE("three tiles end at wrong positions") {
  question("Of which three tiles does the code get the positions wrong?")
      .rule("there are exactly three tiles",
            [](const Tiles& tiles) { return tiles.positions.size() == 3; })
      .input("tiles", [] { return exercise::three_tiles(); })
      .judge(judged([](const Tiles&) { return true; }));
}

TEST_CASE("a hit that never happens takes the place of another") {
  question("Of which tiles is the number of hits right, and a hit among them that never happens?")
      .suspect_if("break-another-number-of-hits",
                  [](const Tiles& tiles) { return is_wrong(tiles) && !same_number_of_hits(tiles); })
      .suspect_if("break-the-two-do-hit",
                  [](const Tiles& tiles) { return is_wrong(tiles) && !never_happens(tiles); })
      .input("tiles", [] { return exercise::right_number_of_hits(); })
      .judge(judged(
          [](const Tiles& tiles) { return same_number_of_hits(tiles) && never_happens(tiles); }));
}

TEST_CASE("a hit that happens later comes too early") {
  question("Of which tiles does the first wrong hit happen later?")
      .suspect_if("break-the-two-do-not-hit-later",
                  [](const Tiles& tiles) { return is_wrong(tiles) && !is_too_early(tiles); })
      .input("tiles", [] { return exercise::too_early(); })
      .judge(judged(is_too_early));
}
