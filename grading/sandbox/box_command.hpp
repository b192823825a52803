#pragma once

// The command line of contact-box for a box.

#include <string>
#include <utility>
#include <vector>

#include "box.hpp"
#include "seat.hpp"

namespace contact::grading {

/// Numbers of the descriptors that are for contact-box and bubblewrap, past all that a box is
/// given.
inline constexpr int report_descriptor = 20;
inline constexpr int filter_descriptor = 21;
inline constexpr int status_descriptor = 22;
inline constexpr int program_descriptor = 23;
inline constexpr int network_descriptor = 24;

/// Paths of the machine and what a box calls them.
class PathNames {
 public:
  void add(std::string machine, std::string box);
  /// The private /tmp, which only stands for itself: a path below /tmp in a command may be the
  /// machine's, of a book that lies there.
  void add_temporary(std::string machine);
  /// A word of a command line with the machine's paths in place of the box's.
  [[nodiscard]] std::string in_machine(const std::string& word) const;
  /// A text with the box's paths in place of the machine's.
  [[nodiscard]] std::string in_box(std::string text) const;

 private:
  std::vector<std::pair<std::string, std::string>> names_;
  std::string temporary_;
};

/// @param group of this box, or null
std::vector<std::string> command_in_namespaces(const Machine& machine, Seat::State& seat,
                                               const BoxGroup* group, const BoxSpec& spec);
/// @param names what the box calls paths of the machine, its private /tmp too
/// @param temporary the folder that stands for /tmp; empty if it has none
std::vector<std::string> command_without_namespaces(const Machine& machine, Seat::State& seat,
                                                    const BoxGroup* group, const BoxSpec& spec,
                                                    const PathNames& names,
                                                    const std::string& temporary);

}  // namespace contact::grading
