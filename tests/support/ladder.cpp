// The native program of a ladder: rounds of timed passes, then a table or JSON, with an input for
// each method and family on which the method fails.
#include <support/ladder.hpp>

#include <sys/utsname.h>

#include <array>
#include <charconv>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <thread>

#ifndef CONTACT_COMPILER
#define CONTACT_COMPILER "unknown"
#endif
#ifndef CONTACT_FLAGS
#define CONTACT_FLAGS "unknown"
#endif

namespace {

using nlohmann::json;

struct Options {
  std::size_t size = 100000;
  std::size_t repeats = 9;
  std::string json_file;
  std::size_t never_wrong = 0;  // inputs a family; 0: the usual rounds
  std::size_t from = 0;
  bool help = false;
};

/// The options, or nothing after a complaint.
std::optional<Options> read(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view name = argv[i];
    if (name == "--help" || name == "-h") {
      options.help = true;
      return options;
    }
    const std::map<std::string_view, std::size_t*> numbers{{"--size", &options.size},
                                                           {"--repeats", &options.repeats},
                                                           {"--never-wrong", &options.never_wrong},
                                                           {"--from", &options.from}};
    const auto named = numbers.find(name);
    const bool known = named != numbers.end() || name == "--json";
    if (!known || i + 1 == argc) {
      std::fprintf(stderr, "%s: %s\n", argv[i], known ? "its value is missing" : "unknown option");
      return std::nullopt;
    }
    const std::string_view value = argv[++i];
    if (name == "--json") {
      options.json_file = value;
      continue;
    }
    const std::size_t least = name == "--from" ? 0 : 1;
    std::size_t& number = *named->second;
    const auto [end, problem] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (problem != std::errc() || end != value.data() + value.size() || number < least) {
      std::fprintf(stderr, "%s takes a whole number from %zu, not %s\n", argv[i - 1], least,
                   argv[i]);
      return std::nullopt;
    }
  }
  if (options.from > 0 && options.never_wrong == 0) {
    std::fprintf(stderr, "--from goes with --never-wrong: how many inputs are to be asked?\n");
    return std::nullopt;
  }
  return options;
}

/// The value of the first line that starts with key, without quotes.
std::string line_of(const char* file, std::string_view key, char separator) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(key)) continue;
    std::string value = line.substr(line.find(separator) + 1);
    std::erase(value, '"');
    value.erase(0, value.find_first_not_of(" \t"));
    return value;
  }
  return "";
}

json machine() {
  utsname system{};
  uname(&system);
  std::string cpu = line_of("/proc/cpuinfo", "model name", ':');
  if (cpu.empty()) cpu = system.machine;
  std::string os = line_of("/etc/os-release", "PRETTY_NAME", '=');
  if (os.empty()) os = std::string(system.sysname) + " " + system.release;
  return {{"cpu", cpu}, {"cores", std::thread::hardware_concurrency()}, {"os", os}};
}

std::string now() {
  const std::time_t seconds = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

/// The processor's time, in nanoseconds: what other programs take meanwhile does not count.
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

double timed_pass(ladder::Experiment& experiment, std::size_t method) {
  const double start = processor_time();
  experiment.pass(method);
  return processor_time() - start;
}

// JSON has no NaN: no value is null.
json or_null(double x) { return std::isfinite(x) ? json(x) : json(nullptr); }

/// The shortest text that reads back as the same number.
std::string text(double x, bool in_float) {
  std::array<char, 32> digits{};
  char* const end = digits.data() + digits.size();
  const std::to_chars_result done = in_float
                                        ? std::to_chars(digits.data(), end, static_cast<float>(x))
                                        : std::to_chars(digits.data(), end, x);
  return {digits.data(), done.ptr};
}

json told(const ladder::Fact& fact) {
  std::string words = fact.words;
  for (const double x : fact.values) {
    if (!words.empty()) words += ' ';
    words += text(x, fact.in_float);
  }
  return {{"name", fact.name}, {"text", words}};
}

json told(const ladder::Failure& failure) {
  json facts = json::array();
  for (const ladder::Fact& fact : failure.example.facts) facts.push_back(told(fact));
  json result{{"input", failure.input},
              {"simplified", failure.simplified},
              {"error", or_null(failure.verdict.error)},
              {"facts", facts},
              {"note", failure.example.note}};
  if (failure.example.figure.empty()) return result;
  json fields = json::object();
  for (const ladder::Field& field : failure.example.fields) fields[field.name] = field.values;
  result["figure"] = failure.example.figure;
  result["fields"] = fields;
  return result;
}

bool has_errors(const std::vector<ladder::Judgement>& judged) {
  return std::any_of(judged.begin(), judged.end(),
                     [](const ladder::Judgement& each) { return each.error_max > 0; });
}
bool any_wrong(const std::vector<ladder::Judgement>& judged) {
  return std::any_of(judged.begin(), judged.end(),
                     [](const ladder::Judgement& each) { return each.wrong > 0; });
}

/// Asks the methods that are declared exact, block after block of other inputs.
/// @return 1 if one of them is wrong, or if there is none; 0 otherwise
int never_wrong(ladder::Experiment& experiment, const Options& options) {
  constexpr std::size_t block_size = 10000;
  const auto& methods = experiment.methods();
  const auto exact = [](const ladder::Method& method) { return method.exact; };
  if (std::none_of(methods.begin(), methods.end(), exact)) {
    std::fprintf(stderr, "no method is declared never wrong (.exact), so there is none to ask\n");
    return 1;
  }
  int exit_code = 0;
  std::printf("%s\n\n%-14s %-28s %9s %9s %9s\n", experiment.question().c_str(), "family", "method",
              "wrong", "undecided", "of");
  for (std::size_t family = 0; family < experiment.families().size(); ++family) {
    const ladder::Family& about = experiment.families()[family];
    std::map<std::size_t, ladder::Judgement> sums;
    for (std::size_t method = 0; method < methods.size(); ++method)
      if (methods[method].exact && methods[method].part == about.part) sums[method];
    std::size_t left = sums.empty() ? 0 : options.never_wrong;
    for (std::uint64_t block = options.from; left > 0; ++block) {
      experiment.prepare(family, std::min(left, block_size), block);
      for (auto& [method, sum] : sums) {
        experiment.pass(method);
        const ladder::Judgement judged = experiment.judge();
        sum.n += judged.n;
        sum.wrong += judged.wrong;
        sum.undecided += judged.undecided;
      }
      left -= std::min(left, block_size);  // a ladder may make fewer of a block
    }
    for (const auto& [method, sum] : sums) {
      std::printf("%-14s %-28s %9zu %9zu %9zu\n", about.id.c_str(), methods[method].id.c_str(),
                  sum.wrong, sum.undecided, sum.n);
      if (sum.wrong > 0) exit_code = 1;
    }
    std::fflush(stdout);
  }
  return exit_code;
}

}  // namespace

int ladder::run_program(Experiment& experiment, const char* chapter, int argc, char** argv) {
  const std::optional<Options> options = read(argc, argv);
  if (!options || options->help) {
    std::fprintf(
        options ? stdout : stderr,
        "usage: %s [--size N] [--repeats R] [--json FILE]\n"
        "       %s --never-wrong N [--from K]\n%s\n"
        "  --size N     inputs a family, or what it has at most (100000)\n"
        "  --repeats R  timed passes; the medians and quartiles are over these (9)\n"
        "  --json FILE  write the results there as well\n"
        "  --never-wrong N  ask only the methods that by design are never wrong, N inputs a\n"
        "                   family (or of each block what the ladder makes at most), and end\n"
        "                   with 1 if one is wrong\n"
        "  --from K     begin with the inputs of block K, of 10,000 each (0)\n",
        argv[0], argv[0], experiment.question().c_str());
    return options ? 0 : 2;
  }
  if (options->never_wrong > 0) return never_wrong(experiment, *options);

  json results = json::array();
  json families = json::array();
  std::printf("%s\n\n%-14s %-28s %-8s %9s %9s %9s %9s  %s\n", experiment.question().c_str(),
              "family", "method", "scalar", "wrong", "of", "error", "largest", "ns (quartiles)");
  const auto& methods = experiment.methods();
  int exit_code = 0;
  for (std::size_t family = 0; family < experiment.families().size(); ++family) {
    const Family& about = experiment.families()[family];
    experiment.prepare(family, options->size, 0);
    families.push_back({{"id", about.id}, {"title", about.title}, {"n", options->size}});
    if (about.by_error) families.back()["by_error"] = true;
    if (!about.part.empty()) families.back()["part"] = about.part;
    std::vector<std::size_t> asked;
    for (std::size_t method = 0; method < methods.size(); ++method) {
      if (methods[method].part == about.part) asked.push_back(method);
    }

    // First every method once, to judge it and to warm up. Then in turns, so that a slow moment of
    // the machine does not fall on one method only.
    std::vector<Judgement> judged(methods.size());
    for (const std::size_t method : asked) {
      experiment.pass(method);
      judged[method] = experiment.judge();
      families.back()["n"] = judged[method].n;
    }
    // A family on which some method is wrong keeps wrong answers, the others the largest errors.
    const bool by_error = about.by_error || (!any_wrong(judged) && has_errors(judged));
    std::vector<std::optional<Failure>> failures(methods.size());
    for (const std::size_t method : asked) {
      if (methods[method].exact && judged[method].wrong > 0) {
        std::fprintf(stderr, "%s is declared exact, and is wrong on %zu of %zu inputs of %s\n",
                     methods[method].id.c_str(), judged[method].wrong, judged[method].n,
                     about.id.c_str());
        exit_code = 1;
      }
      if (by_error ? !(judged[method].error_max > 0) : judged[method].wrong == 0) continue;
      experiment.pass(method);
      failures[method] = experiment.failure(method, by_error);
    }
    std::vector<std::vector<double>> ns(methods.size());
    for (std::size_t repeat = 0; repeat < options->repeats; ++repeat) {
      for (const std::size_t method : asked) {
        const auto inputs = static_cast<double>(judged[method].n);
        ns[method].push_back(timed_pass(experiment, method) / inputs);
      }
    }
    for (const std::size_t method : asked) {
      const Judgement& verdict = judged[method];
      const Spread times = spread(ns[method]);
      results.push_back({{"family", about.id},
                         {"method", methods[method].id},
                         {"n", verdict.n},
                         {"wrong", verdict.wrong},
                         {"undecided", verdict.undecided},
                         {"error_median", or_null(verdict.error_median)},
                         {"error_max", or_null(verdict.error_max)},
                         {"ns_median", times.median},
                         {"ns_q1", times.q1},
                         {"ns_q3", times.q3},
                         {"repeats", options->repeats}});
      if (failures[method]) results.back()["failure"] = told(*failures[method]);
      std::printf("%-14s %-28s %-8s %9zu %9zu %9.1e %9.1e  %.1f (%.1f-%.1f)\n", about.id.c_str(),
                  methods[method].id.c_str(), methods[method].scalar.c_str(), verdict.wrong,
                  verdict.n, verdict.error_median, verdict.error_max, times.median, times.q1,
                  times.q3);
      std::fflush(stdout);
    }
  }

  if (!options->json_file.empty()) {
    json listed = json::array();
    for (const Method& method : methods) {
      listed.push_back({{"id", method.id},
                        {"title", method.title},
                        {"scalar", method.scalar},
                        {"exact", method.exact},
                        {"recommended", method.recommended}});
      if (!method.part.empty()) listed.back()["part"] = method.part;
    }
    std::ofstream out(options->json_file);
    out << json{{"ladder", chapter},
                {"question", experiment.question()},
                {"size", options->size},
                {"machine", machine()},
                {"compiler", CONTACT_COMPILER},
                {"flags", CONTACT_FLAGS},
                {"date", now()},
                {"families", families},
                {"methods", listed},
                {"results", results}}
               .dump(1)
        << "\n";
    if (!out.flush()) {
      std::fprintf(stderr, "%s: cannot be written\n", options->json_file.c_str());
      return 1;
    }
  }
  return exit_code;
}
