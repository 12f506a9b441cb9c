#include "vesper/gpu/shader_library.hpp"

#include "vesper/base/embedded.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/files.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <sstream>

namespace vesper {
extern const EmbeddedTable embedded_shaders;
} // namespace vesper

namespace vesper::gpu {

ShaderSource ShaderLibrary::stage(std::string_view name, const std::vector<std::string>& defines) const {
  ShaderSource source;
  source.text = "#version 450 core\n";
  for (const std::string& define : defines) {
    source.text += "#define " + define + "\n";
  }
  append(std::string(name), source);
  return source;
}

std::string ShaderLibrary::read(const std::string& name) const {
  if (folder_ && std::filesystem::exists(*folder_ / name)) {
    const Bytes bytes = read_file(*folder_ / name);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  const EmbeddedFile* file = embedded_shaders.find(name);
  if (file == nullptr) {
    throw Error(ErrorKind::gpu, fmt::format("shader file {} does not exist", name),
                {folder_ ? folder_->string() : std::string("embedded shaders"), "", "Check the include or the folder"});
  }
  return {reinterpret_cast<const char*>(file->data.data()), file->data.size()};
}

void ShaderLibrary::append(const std::string& name, ShaderSource& source) const {
  if (std::find(source.files.begin(), source.files.end(), name) != source.files.end()) {
    return;
  }
  const std::size_t index = source.files.size();
  source.files.push_back(name);
  std::istringstream lines(read(name));
  source.text += fmt::format("#line 1 {}\n", index);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    constexpr std::string_view directive = "#include \"";
    if (line.starts_with(directive)) {
      const std::size_t end = line.find('"', directive.size());
      append(line.substr(directive.size(), end - directive.size()), source);
      source.text += fmt::format("#line {} {}\n", number + 1, index);
    } else {
      source.text += line + "\n";
    }
  }
}

} // namespace vesper::gpu
