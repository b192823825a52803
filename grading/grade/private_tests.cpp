#include "private_tests.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "private_build.hpp"
#include "private_folder.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

using nlohmann::json;

const PrivateExercise* PrivateTests::of(const std::string& exercise) const {
  const auto found = std::find_if(exercises.begin(), exercises.end(),
                                  [&](const PrivateExercise& p) { return p.exercise == exercise; });
  return found == exercises.end() ? nullptr : &*found;
}

PrivateTests load_private_tests(Loop& loop, const Book& book, const BuildDescription& build,
                                const Machine& machine, const PrivateTestsPlace& place) {
  try {
    check_apart(place.folder, place.submissions);
    check_unreadable(machine, place);
    const std::vector<PrivateFolder> all = read_private_folder(book, fs::canonical(place.folder));
    PrivateTests tests;
    for (const PrivateFolder& folder : all)
      tests.exercises.push_back(private_exercise(loop, book, build, folder, place.cache));
    return tests;
  } catch (const fs::filesystem_error& error) {
    throw BookError(std::string("private tests: ") + error.what());
  }
}

Exercise with_private_tests(const Exercise& exercise, const PrivateTests& tests) {
  Exercise whole = exercise;
  if (const PrivateExercise* more = tests.of(exercise.id()))
    whole.tests.insert(whole.tests.end(), more->tests.begin(), more->tests.end());
  return whole;
}

json to_json(const PrivateTests& tests) {
  json list = json::array();
  for (const PrivateExercise& exercise : tests.exercises) {
    json specs = json::array();
    for (const TestSpec& test : exercise.tests)
      specs.push_back({{"name", test.name},
                       {"points", test.points},
                       {"requires", test.needs},
                       {"visibility", key(test.visibility)}});
    list.push_back({{"exercise", exercise.exercise},
                    {"program", exercise.program.string()},
                    {"fingerprint", exercise.fingerprint},
                    {"tests", std::move(specs)}});
  }
  return list;
}

PrivateTests private_tests_from_json(const json& list) {
  PrivateTests tests;
  for (const json& entry : list) {
    PrivateExercise exercise;
    exercise.exercise = entry.at("exercise").get<std::string>();
    exercise.program = entry.at("program").get<std::string>();
    exercise.fingerprint = entry.at("fingerprint").get<std::string>();
    for (const json& spec : entry.at("tests")) {
      TestSpec test{spec.at("name").get<std::string>(), spec.at("points").get<double>(),
                    spec.at("requires").get<std::vector<std::string>>(), Visibility::hidden, true};
      if (const auto seen = visibility_from_key(spec.at("visibility").get<std::string>()))
        test.visibility = *seen;
      exercise.tests.push_back(std::move(test));
    }
    tests.exercises.push_back(std::move(exercise));
  }
  return tests;
}

}  // namespace contact::grading
