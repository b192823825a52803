#pragma once

// What a second run over the same submissions changed, and why. Nothing of the first is lost.

#include <optional>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include "run_state.hpp"

namespace contact::grading {

/// The results that an earlier run left in this folder; nothing if it left none.
/// @throws BookError if they are not understood
std::optional<nlohmann::json> earlier_results(const RunFolder& folder);

/// Whether marks that an earlier run left are of other submissions than these, and of none of them.
bool of_another_class(const nlohmann::json& earlier, const std::set<std::string>& submissions);

/// "contact-grade-changes/1": each mark of an exercise that moved, came or went, and why. One that
/// moved says what its unit depends on that is no longer the same; a submission that is refused
/// whole has no points in any exercise. What could not be graded has no mark.
nlohmann::json changes_between(const nlohmann::json& before, const nlohmann::json& after);

/// Saves files of this run's folder that are about to be replaced in RESULTS/earlier/DATE-TIME/.
class Earlier {
 public:
  explicit Earlier(const RunFolder& folder) : folder_(folder) {}
  /// @param file below RESULTS
  /// @param as where it is kept, below RESULTS/earlier/DATE-TIME
  void keep(const std::filesystem::path& file, const std::filesystem::path& as);
  /// Moves it there as it is, where it cannot be read.
  void put_away(const std::filesystem::path& file, const std::filesystem::path& as);
  /// Where; empty if nothing was kept.
  [[nodiscard]] const std::filesystem::path& place() const { return place_; }

 private:
  std::filesystem::path target(const std::filesystem::path& as);

  const RunFolder& folder_;
  std::filesystem::path place_;
};

/// Writes the results and, if there were others before, keeps those and writes changes.json first.
/// @returns the changes; nothing if there were no results before
std::optional<nlohmann::json> write_results(const RunFolder& folder, const nlohmann::json& results,
                                            Earlier& earlier);

}  // namespace contact::grading
