// The one exception type of the library.
#pragma once

#include <stdexcept>
#include <string>

namespace vesper {

/// What went wrong, as far as a caller can act on it.
enum class ErrorKind {
  argument, ///< a value given by the caller is out of its range
  input,    ///< the contents of a file are wrong
  file,     ///< a file cannot be opened, read or written
  gpu,      ///< OpenGL or its context failed
};

/// Where an error was found and what to do about it. Empty members are left out of the text.
struct ErrorContext {
  std::string file;   ///< the file's path as the caller gave it
  std::string place;  ///< "line 12, column 103", "byte 40", "accessor 3", ...
  std::string remedy; ///< a full sentence that tells the user what to do
};

/// An error with its place and its remedy.
///
/// `what()` reads "file: place: message. remedy". Libraries throw it and never print or exit; programs turn it
/// into text on standard error and an exit status.
class Error : public std::runtime_error {
public:
  Error(ErrorKind kind, const std::string& message, ErrorContext context = {});

  [[nodiscard]] ErrorKind kind() const noexcept { return kind_; }
  [[nodiscard]] const std::string& message() const noexcept { return message_; }
  [[nodiscard]] const ErrorContext& context() const noexcept { return context_; }

private:
  ErrorKind kind_;
  std::string message_;
  ErrorContext context_;
};

} // namespace vesper
