#pragma once

// Numbers with units, as a reader types them. units.json lists the units; the page reads the same
// list (page/web/src/quantity.ts). tests/cli/support/quantities.json has cases that both must
// answer alike.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace contact::grading {

struct Quantity {
  double value = 0.0;
  std::string unit;
};

/// "−1.5 m/s" as a number and a unit; nothing if it does not begin with a number.
std::optional<Quantity> parse_quantity(std::string_view text);

/// Whether these are the same unit, written in one way or another: m/s², m s^-2, m·s⁻².
bool same_unit(std::string_view one, std::string_view other);

/// The units that can be converted into each other.
class Units {
 public:
  /// @throws std::exception if the file cannot be read or is not a list of units.
  explicit Units(const std::filesystem::path& file);

  /// The number that this quantity has in another unit; nothing if that measures something else.
  [[nodiscard]] std::optional<double> in_unit(const Quantity& quantity,
                                              std::string_view wanted) const;

 private:
  struct Unit {
    double factor = 1.0;
    std::string of;
  };
  struct Measure {
    double factor = 1.0;
    /// Of the units that no other is made of.
    std::map<std::string, int> powers;
  };
  [[nodiscard]] Measure measure(std::string_view unit) const;

  std::map<std::string, Unit> units_;
};

}  // namespace contact::grading
