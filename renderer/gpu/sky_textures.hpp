// The tables of the sky's light on the GPU.
#pragma once

#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/gpu/objects.hpp"

#include <cstddef>
#include <memory>

namespace vesper::gpu {

/// A copy of tables, made in parts so that a running sequence does not stall: about 12 MiB for the default size.
class SkyTextures {
public:
  /// Makes room. The two large tables are filled by upload().
  explicit SkyTextures(std::shared_ptr<const SkyTables> tables);

  /// Copies up to `bytes` more, but at least a row. True when all is there.
  bool upload(std::size_t bytes);

  [[nodiscard]] const std::shared_ptr<const SkyTables>& tables() const { return tables_; }
  [[nodiscard]] const Texture& other() const { return other_; }
  [[nodiscard]] const Texture& aerosol() const { return aerosol_; }
  [[nodiscard]] const Texture& transmittance() const { return transmittance_; }
  [[nodiscard]] const Texture& ground() const { return ground_; }
  /// For small tables: binds texture units 5 to 7 and the block of shaders/small_sky_block.glsl.
  void bind_small() const;

private:
  void upload_rows(std::size_t first, std::size_t count);

  std::shared_ptr<const SkyTables> tables_;
  std::size_t rows_done_ = 0; ///< of both tables, one after the other
  Texture other_;
  Texture aerosol_;
  Texture transmittance_;
  Texture ground_;
  Texture small_air_;
  Texture small_transmittance_;
  Texture small_multiple_;
  Buffer small_block_;
};

} // namespace vesper::gpu
