// The side of the student's code. Nothing here can be trusted to stay as it is written: the
// student's code runs in the same process.

#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>

#include <contact/prelude.hpp>
#include <contact/remote.hpp>
#include <contact/remote_frames.hpp>

namespace contact {
namespace {

struct NotAttempted {};

bool read_all(void* data, std::size_t size) {
  auto* at = static_cast<std::uint8_t*>(data);
  while (size > 0) {
    const ssize_t n = read(remote::kServerDescriptor, at, size);
    if (n > 0) {
      at += n;
      size -= static_cast<std::size_t>(n);
    } else if (n == 0 || errno != EINTR) {
      return false;
    }
  }
  return true;
}

bool write_all(const Bytes& bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t n =
        send(remote::kServerDescriptor, bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL);
    if (n > 0) {
      at += static_cast<std::size_t>(n);
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

std::pair<remote::Reply, Bytes> answered(remote::Handler handler, const Bytes& arguments) {
  using remote::Reply;
  try {
    return {Reply::value, handler(arguments)};
  } catch (const NotAttempted&) {
    return {Reply::not_attempted, {}};
  } catch (const std::invalid_argument& error) {
    return {Reply::invalid_argument, to_bytes(std::string{error.what()})};
  } catch (const std::bad_alloc&) {
    return {Reply::out_of_memory, {}};
  } catch (const std::exception& error) {
    return {Reply::exception, to_bytes(std::string{error.what()})};
  } catch (...) {
    return {Reply::not_an_exception, {}};
  }
}

}  // namespace

void todo() { throw NotAttempted{}; }

int remote::serve(const Contract& contract, std::span<const Handler> handlers) {
  limit_resources();
  Header header;
  while (read_all(&header, sizeof header)) {
    if (header.magic != kMagic || header.fingerprint != contract.fingerprint ||
        header.kind >= handlers.size() || header.length > kMaxPayload) {
      std::fprintf(stderr, "%.*s: not a request for this contract\n",
                   static_cast<int>(contract.name.size()), contract.name.data());
      return 2;
    }
    Bytes arguments(header.length);
    if (!read_all(arguments.data(), arguments.size())) return 2;
    const auto [reply, payload] = answered(handlers[header.kind], arguments);
    // What was printed must not be lost if this process is killed next.
    std::cout.flush();
    std::fflush(stdout);
    header.kind = static_cast<std::uint32_t>(reply);
    header.length = payload.size();
    Bytes bytes(sizeof header);
    std::memcpy(bytes.data(), &header, sizeof header);
    bytes.insert(bytes.end(), payload.begin(), payload.end());
    if (!write_all(bytes)) return 2;
  }
  return 0;
}

}  // namespace contact
