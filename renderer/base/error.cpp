#include "vesper/base/error.hpp"

#include <utility>

namespace vesper {
namespace {

std::string compose(const std::string& message, const ErrorContext& context) {
  std::string text;
  if (!context.file.empty()) {
    text += context.file + ": ";
  }
  if (!context.place.empty()) {
    text += context.place + ": ";
  }
  text += message;
  if (!context.remedy.empty()) {
    text += ". " + context.remedy;
  }
  return text;
}

} // namespace

Error::Error(ErrorKind kind, const std::string& message, ErrorContext context)
    : std::runtime_error(compose(message, context)), kind_(kind), message_(message), context_(std::move(context)) {}

} // namespace vesper
