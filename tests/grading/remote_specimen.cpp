// A server that misbehaves as its argument says. remote_test.cpp asks it.
#include <sys/socket.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <string>
#include <vector>

#include <contact/remote_frames.hpp>

namespace {

using namespace contact::remote;

constexpr std::uint64_t kMaxBytes = std::uint64_t{64} << 20;

bool read_all(void* data, std::size_t size) {
  for (auto* at = static_cast<char*>(data); size > 0;) {
    const ssize_t n = read(kServerDescriptor, at, size);
    if (n <= 0) return false;
    at += n;
    size -= static_cast<std::size_t>(n);
  }
  return true;
}

void write_all(const void* data, std::size_t size) {
  if (write(kServerDescriptor, data, size) != static_cast<ssize_t>(size)) _exit(9);
}

void reply(Header header, const std::vector<char>& payload) {
  header.length = payload.size();
  write_all(&header, sizeof header);
  if (!payload.empty()) write_all(payload.data(), payload.size());
}

std::vector<char> frame(Header header, const std::vector<char>& payload) {
  header.length = payload.size();
  std::vector<char> bytes(sizeof header);
  std::memcpy(bytes.data(), &header, sizeof header);
  bytes.insert(bytes.end(), payload.begin(), payload.end());
  return bytes;
}

// A reply to a question that has not been asked yet, as good as one can be made.
void reply_ahead(std::uint64_t sequence) {
  Header header;
  header.fingerprint = 42;
  header.sequence = sequence;
  const std::vector<char> bytes = frame(header, std::vector<char>(sizeof(double)));
  write_all(bytes.data(), bytes.size());
}

}  // namespace

int main(int, char* argv[]) {
  const std::string how = argv[1];
  if (how == "leaves at once") return 0;
  if (how == "speaks first") write_all("hello", 5);
  if (how == "replies first") reply_ahead(1);
  Header header;
  while (read_all(&header, sizeof header)) {
    std::vector<char> payload(header.length);
    if (!read_all(payload.data(), payload.size())) return 1;
    header.kind = 0;
    if (how == "crashes") std::raise(SIGSEGV);
    if (how == "exits") _exit(3);
    if (how == "sleeps") sleep(60);
    if (how == "closes") {
      close(kServerDescriptor);
      sleep(60);
    }
    if (how == "another sequence") header.sequence += 1;
    if (how == "another contract") header.fingerprint += 1;
    if (how == "another magic") header.magic += 1;
    if (how == "unknown kind") header.kind = 99;
    if (how == "too few bytes") payload.pop_back();
    if (how == "too many bytes") payload.push_back(0);
    if (how == "in pieces") {
      for (const char byte : frame(header, payload)) {
        write_all(&byte, 1);
        usleep(1000);
      }
      continue;
    }
    if (how == "dribbles" || how == "dribbles slowly") {
      header.length = 1u << 20;
      write_all(&header, sizeof header);
      while (true) {
        write_all("x", 1);
        usleep(how == "dribbles" ? 100 : 100'000);
      }
    }
    if (how == "announces 64 MB") {
      header.length = kMaxBytes;
      write_all(&header, sizeof header);
      return 0;
    }
    if (how == "thinks") usleep(400'000);
    if (how == "more in one piece") {
      std::vector<char> bytes = frame(header, payload);
      bytes.push_back(0);
      write_all(bytes.data(), bytes.size());
      continue;
    }
    if (how == "large") payload.assign(101, 0);
    if (how == "throws at length") {
      header.kind = static_cast<std::uint32_t>(Reply::invalid_argument);
      const std::uint32_t length = 1u << 20;
      payload.assign(sizeof length + length, 'x');
      std::memcpy(payload.data(), &length, sizeof length);
    }
    if (how == "huge") {
      header.length = std::uint64_t{1} << 60;
      write_all(&header, sizeof header);
      continue;
    }
    if (how == "half an answer") {
      header.length = 1000;
      write_all(&header, sizeof header);
      return 0;
    }
    if (how == "throws") header.kind = static_cast<std::uint32_t>(Reply::invalid_argument);
    if (how == "not attempted") header.kind = static_cast<std::uint32_t>(Reply::not_attempted);
    reply(header, payload);
    if (how == "speaks again") write_all("more", 4);
    if (how == "replies ahead") reply_ahead(header.sequence + 1);
  }
  return 0;
}
