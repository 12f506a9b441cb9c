#include "vesper/gpu/point_tiles.hpp"

#include <cstddef>
#include <cstdint>
#include <epoxy/gl.h>

namespace vesper::gpu {
namespace {

constexpr int tile_width = 16; // shaders/point_tiles.glsl
constexpr int tile_height = 4;
constexpr GLuint groups_across = 256;
constexpr GLuint boxes_binding = 0;
constexpr GLuint marks_binding = 1;
constexpr GLuint lists_binding = 5;
constexpr GLuint invocations = 64; // of a group that marks or lists

/// shaders/point_tiles.glsl in std430; the tiles follow.
struct TileList {
  std::array<std::uint32_t, 3> groups{groups_across, 0, 1};
  std::uint32_t count = 0;
};
struct ListsHead {
  std::array<TileList, 2> lists;
  std::uint32_t columns = 0;
  std::uint32_t all = 0;
};
static_assert(sizeof(TileList) == 16 && offsetof(ListsHead, columns) == 32);

int tiles_in(int pixels, int tile) { return (pixels + tile - 1) / tile; }

GLuint groups_for(std::size_t count) { return (static_cast<GLuint>(count) + invocations - 1) / invocations; }

} // namespace

PointTiles::PointTiles(const ShaderLibrary& library)
    : mark_(build_program(library, {"point_tiles_mark.comp"})),
      list_(build_program(library, {"point_tiles_list.comp"})) {}

void PointTiles::start(int width, int height) {
  const int columns = tiles_in(width, tile_width);
  const int rows = tiles_in(height, tile_height);
  if (columns != columns_ || rows != rows_) {
    columns_ = columns;
    rows_ = rows;
    const std::size_t bytes =
        sizeof(std::uint32_t) * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    marks_ = make_dynamic_buffer(bytes);
    lists_ = make_dynamic_buffer(sizeof(ListsHead) + bytes);
  }
  clear_buffer(marks_);
}

void PointTiles::mark(std::span<const Box> boxes) {
  if (!boxes.empty()) {
    mark(make_static_buffer(std::as_bytes(boxes)), boxes.size(), 0, 1);
  }
}

void PointTiles::mark(const Buffer& buffer, std::size_t count, std::size_t first, std::size_t stride) {
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  glProgramUniform1i(mark_.name(), 0, columns_);
  glProgramUniform3ui(mark_.name(), 1, static_cast<GLuint>(count), static_cast<GLuint>(first),
                      static_cast<GLuint>(stride));
  glUseProgram(mark_.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, boxes_binding, buffer.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, marks_binding, marks_.name());
  glDispatchCompute(groups_for(count), 1, 1);
}

void PointTiles::list(const Strip& strip) {
  ListsHead head;
  head.columns = static_cast<std::uint32_t>(columns_);
  head.all = head.columns * static_cast<std::uint32_t>(tiles_in(strip.rows, tile_height));
  glNamedBufferSubData(lists_.name(), 0, sizeof(head), &head);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  glProgramUniform1i(list_.name(), 0, strip.first_row);
  glProgramUniform1i(list_.name(), 1, rows_ - 1);
  glUseProgram(list_.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, marks_binding, marks_.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, lists_binding, lists_.name());
  glDispatchCompute(groups_for(head.all), 1, 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

void PointTiles::dispatch(bool with_points) const {
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, lists_.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, lists_binding, lists_.name());
  glDispatchComputeIndirect(with_points ? sizeof(TileList) : 0);
}

} // namespace vesper::gpu
