#pragma once

#include <rovio_sfm/Status.h>

#include <string>

// The outcomes of service calls; every reply carries one, with a sentence for people.
namespace rovio_sfm {

inline Status MakeStatus(uint8_t code, const std::string& message) {
  Status status;
  status.code = code;
  status.message = message;
  return status;
}

inline Status Ok(const std::string& message) { return MakeStatus(Status::OK, message); }
inline Status InvalidArgument(const std::string& message) {
  return MakeStatus(Status::INVALID_ARGUMENT, message);
}
inline Status NotFound(const std::string& message) {
  return MakeStatus(Status::NOT_FOUND, message);
}
inline Status FailedPrecondition(const std::string& message) {
  return MakeStatus(Status::FAILED_PRECONDITION, message);
}
inline Status AlreadyExists(const std::string& message) {
  return MakeStatus(Status::ALREADY_EXISTS, message);
}
inline Status Internal(const std::string& message) { return MakeStatus(Status::INTERNAL, message); }

}  // namespace rovio_sfm
