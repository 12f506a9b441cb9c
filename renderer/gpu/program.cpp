#include "vesper/gpu/program.hpp"

#include "vesper/base/error.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <sstream>

namespace vesper::gpu {
namespace {

GLenum stage_kind(const std::string& name) {
  if (name.ends_with(".vert")) {
    return GL_VERTEX_SHADER;
  }
  return name.ends_with(".comp") ? GL_COMPUTE_SHADER : GL_FRAGMENT_SHADER;
}

std::string numbered(const std::string& text) {
  std::istringstream lines(text);
  std::string result;
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    result += fmt::format("{:5}  {}\n", number, line);
  }
  return result;
}

[[noreturn]] void fail(const std::string& stage, const std::string& log, const ShaderSource& source) {
  std::string files;
  for (std::size_t i = 0; i < source.files.size(); ++i) {
    files += fmt::format("{}{} = {}", i == 0 ? "" : ", ", i, source.files[i]);
  }
  throw Error(ErrorKind::gpu,
              fmt::format("shader does not compile (files {}):\n{}\n{}", files, log, numbered(source.text)),
              {stage, "", "Correct the source"});
}

/// A driver's log through its length query and its read function.
template <class Query, class Read> std::string driver_log(Query query, Read read, GLuint name) {
  GLint length = 0;
  query(name, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length) + 1, '\0');
  GLsizei written = 0;
  read(name, length, &written, log.data());
  log.resize(static_cast<std::size_t>(written));
  return log;
}

struct Shader {
  explicit Shader(GLenum kind) : name(glCreateShader(kind)) {}
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;
  ~Shader() { glDeleteShader(name); }
  GLuint name;
};

} // namespace

ProgramHandle build_program(const ShaderLibrary& library, const std::vector<std::string>& stages,
                            const std::vector<std::string>& defines) {
  ProgramHandle program(glCreateProgram());
  for (const std::string& stage : stages) {
    const ShaderSource source = library.stage(stage, defines);
    const Shader shader(stage_kind(stage));
    const char* text = source.text.c_str();
    glShaderSource(shader.name, 1, &text, nullptr);
    glCompileShader(shader.name);
    GLint compiled = 0;
    glGetShaderiv(shader.name, GL_COMPILE_STATUS, &compiled);
    if (compiled == 0) {
      fail(stage, driver_log(glGetShaderiv, glGetShaderInfoLog, shader.name), source);
    }
    glAttachShader(program.name(), shader.name);
  }
  glLinkProgram(program.name());
  GLint linked = 0;
  glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
  if (linked == 0) {
    throw Error(ErrorKind::gpu,
                "program does not link:\n" + driver_log(glGetProgramiv, glGetProgramInfoLog, program.name()),
                {stages.front(), "", "Correct the stages' interface"});
  }
  return program;
}

const ProgramHandle& ProgramVariants::get(const std::vector<std::string>& defines) {
  auto found = programs_.find(defines);
  if (found == programs_.end()) {
    found = programs_.emplace(defines, build_program(library_, stages_, defines)).first;
  }
  return found->second;
}

} // namespace vesper::gpu
