#include "measures.hpp"

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "../book/book.hpp"
#include "box.hpp"

namespace contact::grading {

namespace {

// A box in which contact-box itself tries something.
BoxSpec probe(const Machine& machine, const std::vector<std::string>& attempt,
              BoxKind kind = BoxKind::answer) {
  BoxSpec spec;
  spec.kind = kind;
  spec.command = {"/probe", "--probe"};
  spec.command.insert(spec.command.end(), attempt.begin(), attempt.end());
  spec.read_only = {{machine.launcher, "/probe"}};
  spec.limits.cpu_seconds = 2.0;
  spec.limits.wall_seconds = 10.0;
  spec.limits.memory_mb = 64;
  spec.limits.files_mb = 1;
  spec.limits.files = 8;
  spec.limits.processes = kind == BoxKind::compile ? 8 : 1;
  return spec;
}

// A socket listens here; a connection would succeed if the network were visible.
class Listener {
 public:
  Listener() : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    address_.sin_family = AF_INET;
    address_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address_;
    if (socket_ >= 0 &&
        ::bind(socket_, reinterpret_cast<const sockaddr*>(&address_), sizeof address_) == 0 &&
        ::listen(socket_, 1) == 0)
      ::getsockname(socket_, reinterpret_cast<sockaddr*>(&address_), &size);
  }
  ~Listener() {
    if (socket_ >= 0) ::close(socket_);
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  [[nodiscard]] std::string port() const { return std::to_string(ntohs(address_.sin_port)); }

 private:
  int socket_;
  sockaddr_in address_{};
};

class Examiner {
 public:
  Examiner(Loop& loop, const Machine& machine) : loop_(loop), machine_(machine), seat_(machine) {}

  BoxEnd run(const BoxSpec& spec) { return run_box(loop_, machine_, seat_, spec); }

  // Tries one thing; it holds if the attempt failed, or was ended by what is tried and not for
  // having taken too long. What is said is the same however busy the machine is.
  void attempt(const std::string& what, const std::string& tried, const BoxSpec& spec,
               bool timing = false) {
    Measure measure;
    measure.what = what;
    try {
      const BoxEnd end = run(spec);
      const bool timed = end.process.ended == Ended::time;
      const bool stopped =
          end.process.signal != 0 || end.process.exit_code == 0 || end.out_of_memory;
      measure.enforced = timed ? timing : stopped;
      measure.how = tried + (measure.enforced ? ": stopped" : ": nothing stopped it");
    } catch (const BookError& error) {
      measure.how = error.what();
    }
    measures.push_back(std::move(measure));
  }

  std::vector<Measure> measures;

 private:
  Loop& loop_;
  const Machine& machine_;
  Seat seat_;
};

std::string group_words(const Machine& machine) {
  switch (machine.control_groups) {
    case ControlGroups::v1:
      return "control groups (version 1)";
    case ControlGroups::v2:
      return "control groups (version 2)";
    case ControlGroups::none:
      break;
  }
  return "no control groups";
}

}  // namespace

std::optional<std::string> why_no_box(Loop& loop, const Machine& machine) {
  try {
    const BoxEnd end = Examiner(loop, machine).run(probe(machine, {"nothing"}));
    if (end.process.succeeded()) return std::nullopt;
    return "a box that does nothing ended with code " + std::to_string(end.process.exit_code) +
           " and signal " + std::to_string(end.process.signal) + ": " + end.process.errors;
  } catch (const BookError& error) {
    return error.what();
  }
}

std::vector<Measure> try_measures(Loop& loop, const Machine& machine,
                                  const std::string& why_not_full) {
  Examiner examiner(loop, machine);
  const Listener listener;
  const std::string self = std::to_string(::getpid());
  const auto answer = [&](const std::vector<std::string>& words) { return probe(machine, words); };
  const auto compiler = [&](const std::vector<std::string>& words) {
    return probe(machine, words, BoxKind::compile);
  };

  examiner.measures.push_back(
      {"namespaces of its own", machine.namespaces,
       machine.namespaces ? "bubblewrap made them for users, processes, files, network and messages"
                          : why_not_full});
  examiner.attempt("a submission is not root", "asked who it is", answer({"root"}));
  examiner.measures.push_back({"a user id for each worker", machine.own_user_ids,
                               machine.own_user_ids
                                   ? "this program may change its own"
                                   : "only root can; all boxes have the user id of this program"});
  examiner.attempt("a submission gains no rights", "mounted, traced, made a namespace, became root",
                   answer({"rights"}));
  examiner.attempt("a submission has no network", "connected to a port of this machine",
                   answer({"network", listener.port()}));
  examiner.attempt("a submission sees no other process", "sent this program a signal",
                   answer({"signal", self}));
  examiner.attempt("a submission reads no file of the machine", "opened /etc/passwd",
                   answer({"file", "/etc/passwd"}));
  examiner.attempt("a compiler reads only what it is given", "opened /etc/passwd",
                   compiler({"file", "/etc/passwd"}));
  examiner.attempt("a submission starts no process", "forked", answer({"fork"}));
  examiner.attempt("a submission gets no environment", "looked for variables",
                   answer({"environment"}));
  examiner.attempt("memory of a process is limited", "used 128 MB where 64 are allowed",
                   answer({"memory", "128"}));
  examiner.attempt(
      "memory of all processes of a box together is limited",
      "used 128 MB in four processes where 64 are allowed, with " + group_words(machine),
      compiler({"memory-together"}));
  examiner.attempt("the number of processes of a compiler is limited",
                   "started 64 processes where 8 are allowed", compiler({"fork-many", "64"}));
  examiner.attempt("the size of files is limited", "wrote 4 MB where 1 is allowed",
                   compiler({"file-size", "4", "/tmp"}));
  examiner.attempt("the number of files is limited", "made 64 files where 8 are allowed",
                   compiler({"files", "64", "/tmp"}));
  BoxSpec endless = answer({"spin"});
  endless.limits.cpu_seconds = 0.1;
  examiner.attempt("processor time is limited", "worked without end", endless, true);
  return std::move(examiner.measures);
}

}  // namespace contact::grading
