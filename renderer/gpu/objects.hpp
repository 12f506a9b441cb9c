// OpenGL objects that free themselves. Handles are plain integers, so that headers need no OpenGL.
#pragma once

#include <cstddef>
#include <span>
#include <utility>

namespace vesper::gpu {

/// Sole owner of an OpenGL name, freed by the kind's deleter.
template <void (*Delete)(unsigned int)> class Handle {
public:
  Handle() = default;
  explicit Handle(unsigned int name) : name_(name) {}
  Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    if (this != &other) {
      reset();
      name_ = std::exchange(other.name_, 0);
    }
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { reset(); }

  [[nodiscard]] unsigned int name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

private:
  void reset() {
    if (name_ != 0) {
      Delete(name_);
      name_ = 0;
    }
  }
  unsigned int name_ = 0;
};

void delete_buffer(unsigned int name);
void delete_texture(unsigned int name);
void delete_vertex_array(unsigned int name);
void delete_framebuffer(unsigned int name);
void delete_program(unsigned int name);

using Buffer = Handle<delete_buffer>;
using Texture = Handle<delete_texture>;
using VertexArray = Handle<delete_vertex_array>;
using Framebuffer = Handle<delete_framebuffer>;
using ProgramHandle = Handle<delete_program>;

/// A buffer of fixed contents.
[[nodiscard]] Buffer make_static_buffer(std::span<const std::byte> data);
/// A buffer of `size` bytes that update_buffer may rewrite.
[[nodiscard]] Buffer make_dynamic_buffer(std::size_t size);
void update_buffer(const Buffer& buffer, std::span<const std::byte> data);
/// Fills it with zeros.
void clear_buffer(const Buffer& buffer);

[[nodiscard]] VertexArray make_vertex_array();

/// 32-bit float RGBA (a strip of the frame) or RGBA of 16 or 8 bits (display pixels).
enum class PixelFormat { rgba32f, rgba16, rgba8 };
/// OpenGL's name for it.
[[nodiscard]] unsigned int gl_format(PixelFormat format);
/// Without mipmaps. Throws Error(gpu) when the driver has no room for it.
[[nodiscard]] Texture make_texture(int width, int height, PixelFormat format);
/// One row of RGBA texels of 32-bit floats, to be read with texelFetch.
[[nodiscard]] Texture make_row_texture(std::span<const float> rgba);
/// Rows of as many such texels each.
[[nodiscard]] Texture make_table_texture(int width, std::span<const float> rgba);
/// A buffer's contents as texels of 1 or 4 32-bit floats.
[[nodiscard]] Texture make_buffer_texture(const Buffer& buffer, int channels);
/// A volume of such texels without contents.
[[nodiscard]] Texture make_volume_texture(int width, int height, int depth);
/// Six square faces of RGBA texels of 32-bit floats without contents, with room for all mipmaps, to be read between
/// texels, mipmaps and faces.
[[nodiscard]] Texture make_cube_texture(int side);
/// Fills one of its mipmaps: texels in the order of shaders/lib/cube_map.glsl, to be looked up by its
/// opengl_cube_direction.
void fill_cube_texture(const Texture& texture, int level, int side, std::span<const float> rgba);
/// Has texture() interpolate linearly, up to the texels of the edges.
void interpolate(const Texture& texture);
/// \param second another attachment of the same size; none if null. Only the first is drawn into until draw_into().
[[nodiscard]] Framebuffer make_framebuffer(const Texture& color, const Texture* second = nullptr);
/// Which attachments the outputs of the fragment stages go to.
enum class Attachments { first, both, second };
void draw_into(const Framebuffer& framebuffer, Attachments attachments);

/// Binds a level of a texture as an image that shaders read from or write to, in one of OpenGL's formats.
void read_image(unsigned int unit, const Texture& texture, int level, unsigned int format);
void write_image(unsigned int unit, const Texture& texture, int level, unsigned int format);

/// Largest width and height of a texture.
[[nodiscard]] int largest_texture_side();
[[nodiscard]] int largest_cube_side();

/// Throws Error(gpu) if OpenGL has recorded an error since the last call.
void require_no_error(const char* where);

/// Waits until the GPU has done all it was told.
void finish();

} // namespace vesper::gpu
