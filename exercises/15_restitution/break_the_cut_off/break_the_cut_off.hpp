/// @file
/// Exercise: balls whose bounces a cut-off ends too early.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A ball that is dropped on a floor.
struct Drop {
  double height;  ///< of the drop, m, from 1e-12 to 100
  double k;       ///< coefficient of restitution, from 0.001 to 0.99999
};

/// A drop for which given::rest_after_cut_off is wrong by more than 10 %, although k is at most
/// 0.5.
Drop weak_bounces();

/// A drop of a height from 1 m to 100 m for which given::rest_after_cut_off is wrong by more
/// than 10 %.
Drop from_high_up();

/// A drop from at most 1 m for which given::rest_after_cut_off is wrong by more than a minute.
Drop by_a_minute();

}  // namespace exercise
