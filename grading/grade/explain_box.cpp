#include "explain_box.hpp"

#include <exception>
#include <filesystem>

#include <sys/mman.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include "run_keys.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

// The question as a file without a name, from whose start the box reads.
class QuestionFile {
 public:
  explicit QuestionFile(const std::string& bytes)
      : descriptor_(::memfd_create("question", MFD_CLOEXEC)) {
    std::size_t written = 0;
    while (descriptor_ >= 0 && written < bytes.size()) {
      const ssize_t count = ::write(descriptor_, bytes.data() + written, bytes.size() - written);
      if (count <= 0) break;
      written += static_cast<std::size_t>(count);
    }
    if (descriptor_ >= 0 && written == bytes.size() && ::lseek(descriptor_, 0, SEEK_SET) == 0)
      return;
    if (descriptor_ >= 0) ::close(descriptor_);
    throw BookError("a compiler's messages cannot be handed on to be explained");
  }
  ~QuestionFile() { ::close(descriptor_); }
  QuestionFile(const QuestionFile&) = delete;
  QuestionFile& operator=(const QuestionFile&) = delete;
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

BoxSpec explain_box(const QuestionFile& question) {
  BoxSpec spec;
  spec.kind = BoxKind::answer;
  spec.command = {"/explain"};
  spec.read_only = {{own_program().parent_path() / "contact-explain", "/explain"}};
  spec.descriptors = {{question.descriptor(), 0}};
  spec.limits.cpu_seconds = explain_cpu_seconds;
  spec.limits.wall_seconds = explain_wall_seconds;
  spec.limits.memory_mb = explain_memory_mb;
  spec.limits.processes = 1;
  spec.limits.output_bytes = max_told_bytes;
  spec.limits.files = 0;
  return spec;
}

}  // namespace

Explained explain_in_box(Loop& loop, const Machine& machine, const Seat& seat,
                         const ExplainRequest& request) {
  const QuestionFile question(to_bytes(request));
  const BoxEnd end = run_box(loop, machine, seat, explain_box(question));
  if (end.process.succeeded()) {
    try {
      Explained said = explained_from_json(nlohmann::json::parse(end.process.output));
      if (said.error.has_value() == request.failed) {
        if (said.error) said.error->full = request.log;
        return said;
      }
    } catch (const std::exception&) {
      // What came back is no answer: the compiler's own words are told.
    }
  }
  return unexplained(request.log, request.failed, request.file);
}

}  // namespace contact::grading
