#include "vesper/gpu/objects.hpp"

#include "vesper/base/error.hpp"

#include <array>
#include <bit>
#include <epoxy/gl.h>
#include <fmt/format.h>

namespace vesper::gpu {

void delete_buffer(unsigned int name) { glDeleteBuffers(1, &name); }
void delete_texture(unsigned int name) { glDeleteTextures(1, &name); }
void delete_vertex_array(unsigned int name) { glDeleteVertexArrays(1, &name); }
void delete_framebuffer(unsigned int name) { glDeleteFramebuffers(1, &name); }
void delete_program(unsigned int name) { glDeleteProgram(name); }

Buffer make_static_buffer(std::span<const std::byte> data) {
  GLuint name = 0;
  glCreateBuffers(1, &name);
  Buffer buffer(name);
  glNamedBufferStorage(name, static_cast<GLsizeiptr>(data.size()), data.data(), 0);
  require_no_error("creating a buffer");
  return buffer;
}

Buffer make_dynamic_buffer(std::size_t size) {
  GLuint name = 0;
  glCreateBuffers(1, &name);
  Buffer buffer(name);
  glNamedBufferStorage(name, static_cast<GLsizeiptr>(size), nullptr, GL_DYNAMIC_STORAGE_BIT);
  require_no_error("creating a buffer");
  return buffer;
}

void update_buffer(const Buffer& buffer, std::span<const std::byte> data) {
  glNamedBufferSubData(buffer.name(), 0, static_cast<GLsizeiptr>(data.size()), data.data());
}

void clear_buffer(const Buffer& buffer) {
  glClearNamedBufferData(buffer.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

VertexArray make_vertex_array() {
  GLuint name = 0;
  glCreateVertexArrays(1, &name);
  return VertexArray(name);
}

unsigned int gl_format(PixelFormat format) {
  switch (format) {
  case PixelFormat::rgba32f:
    return GL_RGBA32F;
  case PixelFormat::rgba16:
    return GL_RGBA16;
  case PixelFormat::rgba8:
    break;
  }
  return GL_RGBA8;
}

Texture make_texture(int width, int height, PixelFormat format) {
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &name);
  Texture texture(name);
  glTextureStorage2D(name, 1, gl_format(format), width, height);
  require_no_error("creating a texture");
  return texture;
}

Texture make_row_texture(std::span<const float> rgba) {
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_1D, 1, &name);
  Texture texture(name);
  const auto width = static_cast<GLsizei>(rgba.size() / 4);
  glTextureStorage1D(name, 1, GL_RGBA32F, width);
  glTextureSubImage1D(name, 0, 0, width, GL_RGBA, GL_FLOAT, rgba.data());
  require_no_error("creating a texture");
  return texture;
}

Texture make_table_texture(int width, std::span<const float> rgba) {
  const auto height = static_cast<GLsizei>(rgba.size() / 4) / width;
  Texture texture = make_texture(width, height, PixelFormat::rgba32f);
  glTextureSubImage2D(texture.name(), 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, rgba.data());
  require_no_error("filling a texture");
  return texture;
}

Texture make_buffer_texture(const Buffer& buffer, int channels) {
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_BUFFER, 1, &name);
  Texture texture(name);
  glTextureBuffer(name, channels == 1 ? GL_R32F : GL_RGBA32F, buffer.name());
  require_no_error("creating a buffer texture");
  return texture;
}

Texture make_volume_texture(int width, int height, int depth) {
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_3D, 1, &name);
  Texture texture(name);
  glTextureStorage3D(name, 1, GL_RGBA32F, width, height, depth);
  require_no_error("creating a texture");
  return texture;
}

Texture make_cube_texture(int side) {
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_CUBE_MAP, 1, &name);
  Texture texture(name);
  glTextureStorage2D(name, static_cast<GLsizei>(std::bit_width(static_cast<unsigned int>(side))), GL_RGBA32F, side,
                     side);
  glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  require_no_error("creating a cube texture");
  return texture;
}

void fill_cube_texture(const Texture& texture, int level, int side, std::span<const float> rgba) {
  constexpr std::array<GLint, 6> face_of_opengl{0, 1, 2, 3, 5, 4};
  const std::size_t face_floats = rgba.size() / face_of_opengl.size();
  for (std::size_t face = 0; face < face_of_opengl.size(); ++face) {
    glTextureSubImage3D(texture.name(), level, 0, 0, face_of_opengl.at(face), side, side, 1, GL_RGBA, GL_FLOAT,
                        &rgba[face * face_floats]);
  }
  require_no_error("filling a cube texture");
}

void interpolate(const Texture& texture) {
  glTextureParameteri(texture.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(texture.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(texture.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(texture.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

Framebuffer make_framebuffer(const Texture& color, const Texture* second) {
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  Framebuffer framebuffer(name);
  glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, color.name(), 0);
  if (second != nullptr) {
    glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT1, second->name(), 0);
  }
  if (glCheckNamedFramebufferStatus(name, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw Error(ErrorKind::gpu, "the driver cannot draw into a 32-bit float framebuffer",
                {"", "", "Use another driver, or Mesa's software renderer"});
  }
  return framebuffer;
}

void draw_into(const Framebuffer& framebuffer, Attachments attachments) {
  constexpr std::array<GLenum, 2> outputs{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  switch (attachments) {
  case Attachments::first:
    glNamedFramebufferDrawBuffers(framebuffer.name(), 1, outputs.data());
    break;
  case Attachments::both:
    glNamedFramebufferDrawBuffers(framebuffer.name(), 2, outputs.data());
    break;
  case Attachments::second:
    glNamedFramebufferDrawBuffers(framebuffer.name(), 1, &outputs[1]);
    break;
  }
}

void read_image(unsigned int unit, const Texture& texture, int level, unsigned int format) {
  glBindImageTexture(unit, texture.name(), level, GL_FALSE, 0, GL_READ_ONLY, format);
}

void write_image(unsigned int unit, const Texture& texture, int level, unsigned int format) {
  glBindImageTexture(unit, texture.name(), level, GL_FALSE, 0, GL_WRITE_ONLY, format);
}

int largest_texture_side() {
  GLint side = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side);
  return side;
}

int largest_cube_side() {
  GLint side = 0;
  glGetIntegerv(GL_MAX_CUBE_MAP_TEXTURE_SIZE, &side);
  return side;
}

void require_no_error(const char* where) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) {
    return;
  }
  throw Error(
      ErrorKind::gpu, fmt::format("OpenGL error 0x{:04x} while {}", error, where),
      {"", "", error == GL_OUT_OF_MEMORY ? "Ask for a smaller picture" : "Please report it with the driver's name"});
}

void finish() { glFinish(); }

} // namespace vesper::gpu
