/// @file
/// Calling a contract's functions in another process.
///
/// Generated code names the symbols; everything else is deduced from their types. The proxy of a
/// contract defines its functions, for a program that runs tests: each sends its arguments and
/// waits for the value. The server of the contract is the `main` of the program that holds the
/// student's object.
///
/// A frame is a header and a payload. Both ends check everything they read. Any failure of the far
/// side (it crashes, ends, takes too long, sends unrequested bytes or bytes that are not a value)
/// becomes host::Stopped on the near side, and the next test gets a new process. A question has an
/// unpredictable number, so that a reply cannot be written before it.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>

#include <contact/host.hpp>
#include <contact/value_bytes.hpp>

namespace contact::remote {

/// Both ends must be of the same contract: the fingerprint is made from its declarations.
struct Contract {
  std::string_view name;
  std::uint64_t fingerprint;
};

/// Nothing that crosses is longer than this, in bytes.
inline constexpr std::size_t kMaxPayload = std::size_t{64} << 20;

/// Sends the arguments to a process with the student's code and returns the bytes of the value.
/// Throws what the student's function threw; calls todo() if it did; throws host::Stopped if there
/// was no answer.
///
/// Of the environment, CONTACT_BROKER is the descriptor of a broker that starts, limits and ends
/// such processes (remote_broker.hpp). Without it they are children of this one: CONTACT_SERVER
/// names the program (a path, or a JSON array of a command and its arguments), and an answer may
/// take CONTACT_CALL_SECONDS (10 unless told). CONTACT_ANSWER_BYTES bounds an answer, CONTACT_CALLS
/// the calls of a test.
Bytes exchange(const Contract& contract, std::uint32_t function, const Bytes& arguments);

/// Gives up the process and throws host::Stopped.
[[noreturn]] void stop_because(const std::string& reason);

/// What a proxy's function does.
template <class R, class... A>
R call(const Contract& contract, std::uint32_t function, const A&... arguments) {
  Bytes bytes;
  Writer writer(bytes);
  (writer.write(arguments), ...);
  const Bytes reply = exchange(contract, function, bytes);
  try {
    Reader reader(reply);
    R value = reader.read<R>();
    reader.finish();
    return value;
  } catch (const BadBytes& error) {
    stop_because("sent back something that is not a value: " + std::string{error.what()});
  }
}

using Handler = Bytes (*)(const Bytes& arguments);

namespace detail {

template <class>
struct Signature;
template <class R, class... A>
struct Signature<R (*)(A...)> {
  using Arguments = std::tuple<std::remove_cvref_t<A>...>;
  template <auto Function>
  static Bytes handle(const Bytes& bytes) {
    Reader reader(bytes);
    const Arguments arguments{
        reader.read<std::remove_cvref_t<A>>()...};  // braces: from left to right
    reader.finish();
    return to_bytes(std::apply(Function, arguments));
  }
};

}  // namespace detail

/// What a server does for one function.
template <auto Function>
inline constexpr Handler handler =
    &detail::Signature<decltype(Function)>::template handle<Function>;

/// Whether every type of a function may cross.
template <class F>
inline constexpr bool crosses = false;
template <class R, class... A>
inline constexpr bool crosses<R (*)(A...)> = Value<R> && (Value<std::remove_cvref_t<A>> && ...);

/// Answers requests from file descriptor 3 until it closes; what a server's main returns.
int serve(const Contract& contract, std::span<const Handler> handlers);

}  // namespace contact::remote
