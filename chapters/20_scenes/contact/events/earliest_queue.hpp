/// @file
/// The earliest of n slots, by a tournament tree: when a slot changes, only the matches on its path
/// to the root are played again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace contact {

/// A tournament tree over the slots 0 … n − 1. It stores the winners, not the times: the caller
/// says which of two slots comes first.
///
/// An update costs at most log₂ n comparisons, and stops where it changes nothing. Four bytes for
/// each of 2n nodes (n rounded up to a power of two).
class EarliestQueue {
 public:
  /// @param slots how many, at least 1
  explicit EarliestQueue(std::size_t slots) {
    while (leaves_ < slots) leaves_ *= 2;
    winner_.assign(2 * leaves_, none);
    for (std::size_t i = 0; i < slots; ++i) winner_[leaves_ + i] = static_cast<std::int32_t>(i);
  }

  /// Plays every match. @param before before(i, k): whether slot i comes before slot k; an order
  /// without ties
  template <class Before>
  void play_all(const Before& before) {
    for (std::size_t node = leaves_ - 1; node >= 1; --node) winner_[node] = match(node, before);
  }

  // [queue]
  /// Plays the matches of a slot whose time has changed.
  template <class Before>
  void update(std::size_t slot, const Before& before) {
    for (std::size_t node = (leaves_ + slot) / 2; node >= 1; node /= 2) {
      const std::int32_t winner = match(node, before);
      // Another slot had won here, and wins again: nothing changes above.
      if (winner == winner_[node] && winner != static_cast<std::int32_t>(slot)) return;
      winner_[node] = winner;
    }
  }

  /// The slot that comes first.
  std::size_t first() const { return static_cast<std::size_t>(winner_[1]); }
  // [/queue]

  /// The number of leaves: the slots' number, at least 2, rounded up to a power of two. Slot i is
  /// node leaves() + i; node n plays its match between nodes 2 n and 2 n + 1, and node 1 is the
  /// root.
  std::size_t leaves() const { return leaves_; }
  /// The slot that has won at a node, or −1 if none is below it.
  /// @param node from 1 to 2 leaves() − 1
  std::int32_t winner(std::size_t node) const { return winner_[node]; }

  /// Bytes that it holds.
  std::size_t bytes() const { return winner_.capacity() * sizeof(std::int32_t); }

 private:
  static constexpr std::int32_t none = -1;

  template <class Before>
  std::int32_t match(std::size_t node, const Before& before) const {
    const std::int32_t left = winner_[2 * node];
    const std::int32_t right = winner_[2 * node + 1];
    if (right == none) return left;
    if (left == none) return right;
    return before(static_cast<std::size_t>(right), static_cast<std::size_t>(left)) ? right : left;
  }

  std::size_t leaves_ = 2;
  std::vector<std::int32_t> winner_;
};

}  // namespace contact
