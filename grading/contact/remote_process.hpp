/// @file
/// Where the near side gets the far side from: for remote.cpp and remote_process.cpp only.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace contact::remote {

/// A process with the student's code in it, on the other end of a socket.
class FarProcess {
 public:
  FarProcess() = default;
  FarProcess(const FarProcess&) = delete;
  FarProcess& operator=(const FarProcess&) = delete;
  virtual ~FarProcess() = default;

  /// Starts a new process and returns our end of its socket, which the caller closes.
  /// @param test for which it is, counted from 1
  /// @throws host::Stopped if none is available
  virtual int start(std::uint64_t test) = 0;
  /// Its end of the socket is closed: waits until it has ended, and says why.
  virtual std::string why_it_ended() = 0;
  /// Ends it, whatever it is doing.
  virtual void stop() = 0;
  /// Seconds that one call may wait for its answer; 0 if another process enforces the limit.
  virtual double patience() const = 0;
};

/// Asks the broker of CONTACT_BROKER for processes if there is one; else starts the program that
/// CONTACT_SERVER names (a path, or a JSON array of a command and its arguments).
std::unique_ptr<FarProcess> far_process();

/// A number from the environment, or `otherwise` if it is not there or is none.
std::uint64_t number_from_environment(const char* name, std::uint64_t otherwise);

}  // namespace contact::remote
