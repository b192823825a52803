#include "broker.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

#include "../book/book.hpp"
#include "../contact/remote_broker.hpp"
#include "../contact/remote_frames.hpp"
#include "../run/stop_words.hpp"
#include "../sandbox/idle.hpp"

namespace contact::grading {

namespace {

using Clock = std::chrono::steady_clock;
using remote::BrokerReply;
using remote::BrokerRequest;

// How long a submission that has closed its socket may take to be gone.
constexpr std::chrono::seconds kPatience{5};

/// A descriptor that is closed when it goes.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    close();
    number_ = std::exchange(other.number_, -1);
    return *this;
  }
  [[nodiscard]] int get() const { return number_; }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

std::pair<Descriptor, Descriptor> socket_pair(int type) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, type | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw BookError(std::string("cannot make a socket: ") + std::strerror(errno));
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

std::string words_of(const BoxEnd& end, const BoxLimits& limits, double seconds) {
  if (end.out_of_memory)
    return "ran out of memory: it may use " + std::to_string(limits.memory_mb) + " MB";
  if (end.process.signal == 0 && end.process.exit_code == not_started)
    return "it could not be started, or ended by itself with exit code 127";
  return why_stopped(end.process, seconds);
}

}  // namespace

struct Broker::State {
  Loop& loop;
  const Machine& machine;
  const Seat& seat;
  const BoxSpec answer;
  AnswerTime& time;
  Descriptor ours;
  Descriptor judges;
  // Their close callbacks run on the loop, so they outlive this.
  uv_poll_t* poll = new uv_poll_t{};
  uv_timer_t* timer = new uv_timer_t{};
  std::unique_ptr<Box> box;
  // The box's own, from its start on.
  IdleClock idle;
  double idle_limit = 0.0;
  std::uint64_t test = 0;
  std::vector<Answered> answered;

  State(Loop& on, const Machine& here, const Seat& at, BoxSpec spec, AnswerTime& may_take)
      : loop(on), machine(here), seat(at), answer(std::move(spec)), time(may_take) {
    std::tie(ours, judges) = socket_pair(SOCK_SEQPACKET);
    uv_poll_init(loop.get(), poll, ours.get());
    // That something happened is enough: a turn of the loop ends, and serve() is called.
    uv_poll_start(poll, UV_READABLE, [](uv_poll_t*, int, int) {});
    uv_timer_init(loop.get(), timer);
    uv_timer_start(
        timer, [](uv_timer_t*) {}, 10, 10);
  }

  ~State() {
    uv_close(reinterpret_cast<uv_handle_t*>(poll),
             [](uv_handle_t* handle) { delete reinterpret_cast<uv_poll_t*>(handle); });
    uv_close(reinterpret_cast<uv_handle_t*>(timer),
             [](uv_handle_t* handle) { delete reinterpret_cast<uv_timer_t*>(handle); });
  }

  // One request, if there is one.
  std::optional<BrokerRequest> request() {
    BrokerRequest request;
    ssize_t size = 0;
    do {
      size = ::recv(ours.get(), &request, sizeof request, MSG_DONTWAIT);
    } while (size < 0 && errno == EINTR);
    if (size == static_cast<ssize_t>(sizeof request) && request.magic == remote::kBrokerMagic)
      return request;
    // The judge is gone, or is not what it was: its box will say so.
    if (size >= 0 || errno != EAGAIN) uv_poll_stop(poll);
    return std::nullopt;
  }

  void reply(BrokerReply::Kind kind, std::string_view words, int descriptor = -1) const {
    remote::send_reply(ours.get(), kind, words, descriptor);
  }

  void start(std::uint64_t for_test) {
    end_box();
    test = for_test;
    auto [near, far] = socket_pair(SOCK_STREAM);
    BoxSpec spec = answer;
    spec.descriptors.emplace_back(far.get(), remote::kServerDescriptor);
    box = std::make_unique<Box>(loop, machine, seat, std::move(spec));
    idle = IdleClock();
    idle_limit =
        time.idle_so_far < time.idle_seconds_in_all ? time.idle_seconds : time.idle_seconds / 10.0;
    reply(BrokerReply::Kind::given, {}, near.get());
  }

  void tell_why(const Box& judge) {
    if (box == nullptr) return reply(BrokerReply::Kind::words, "there is no program to answer");
    const Clock::time_point start = Clock::now();
    while (!box->ended() && Clock::now() - start < kPatience) {
      loop.run_once();
      watch(judge);
    }
    if (!box->ended()) {
      end_box();
      return reply(BrokerReply::Kind::words, "closed its connection");
    }
    end_box();
    const BoxEnd& end = answered.back().end;
    reply(BrokerReply::Kind::words,
          words_of(end, answer.limits,
                   end.process.ended == Ended::idle ? idle_limit : time.cpu_seconds));
  }

  void watch(const Box& judge) {
    if (box == nullptr || box->ended() || judge.ended()) return;
    // The kernel counts whole seconds; this is exact to a few milliseconds.
    if (box->cpu_seconds() > time.cpu_seconds) return box->end(Ended::time);
    const double before = idle.seconds();
    idle.sample({box->pid(), judge.pid()}, [&] {
      return box->has_unread_output() || judge.has_unread_output() || is_asked();
    });
    time.idle_so_far += idle.seconds() - before;
    if (idle.seconds() > idle_limit) box->end(Ended::idle);
  }

  // Whether the judge waits for a reply of ours, and not for an answer.
  [[nodiscard]] bool is_asked() const {
    char byte = 0;
    return ::recv(ours.get(), &byte, 1, MSG_DONTWAIT | MSG_PEEK) > 0;
  }

  void end_box() {
    if (box == nullptr) return;
    box->end(Ended::unwanted);
    answered.push_back({test, box->wait()});
    box.reset();
  }
};

Broker::Broker(Loop& loop, const Machine& machine, const Seat& seat, BoxSpec answer,
               AnswerTime& time)
    : state_(std::make_unique<State>(loop, machine, seat, std::move(answer), time)) {}

Broker::~Broker() = default;

int Broker::judge_end() const { return state_->judges.get(); }
void Broker::let_go_of_judge_end() { state_->judges.close(); }

void Broker::serve(const Box& judge) {
  while (const std::optional<BrokerRequest> request = state_->request()) {
    switch (request->kind) {
      case BrokerRequest::Kind::start:
        state_->start(request->test);
        break;
      case BrokerRequest::Kind::why:
        state_->tell_why(judge);
        break;
      case BrokerRequest::Kind::done:
        // It is waited for when the next is started, so that the judge need not.
        if (state_->box != nullptr) state_->box->end(Ended::unwanted);
        break;
    }
  }
  state_->watch(judge);
}

std::vector<Answered> Broker::finish() {
  state_->end_box();
  return std::move(state_->answered);
}

}  // namespace contact::grading
