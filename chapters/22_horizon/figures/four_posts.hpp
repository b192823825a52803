// The room of the ball among four posts: for the figure, and for the ladder, whose inputs it shows.
#pragma once

#include <array>

namespace four_posts {

inline constexpr double ball_radius = 0.1;  // m
inline constexpr double width = 4;          // m, from x = 0
inline constexpr double height = 3;         // m, from y = 0
inline constexpr std::array<std::array<double, 2>, 4> posts{
    {{1.05, 0.8}, {2.9, 0.95}, {2, 1.75}, {0.95, 2.3}}};  // their centres, m
inline constexpr double least_post = 0.01;                // m, the radius
inline constexpr double largest_post = 0.4;               // m: the ball fits through everywhere

}  // namespace four_posts
