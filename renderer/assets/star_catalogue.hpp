// The layout of a star buffer: what catalogue tools write, files hold and the GPU reads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace vesper {

/// One star, in the order and units that the file and the vertex stage share. All directions are ICRS at the
/// catalogue's epoch.
struct StarRecord {
  std::array<float, 3> position;      ///< unit vector
  std::array<float, 3> proper_motion; ///< rad/year, tangent to the sphere at `position`, excludes radial motion
  float parallax;                     ///< rad, >= 0; 0 where unknown
  float radial_velocity;              ///< km/s, positive receding; 0 where unknown
  float illuminance;                  ///< lux above the atmosphere at normal incidence, > 0
  std::array<float, 4> color;         ///< X, Y, Z, S of the star for Y = 1 lux
  float variability;                  ///< peak-to-peak amplitude in V magnitudes; 0 for none or unknown
};
static_assert(sizeof(StarRecord) == 56 && offsetof(StarRecord, proper_motion) == 12 &&
              offsetof(StarRecord, parallax) == 24 && offsetof(StarRecord, radial_velocity) == 28 &&
              offsetof(StarRecord, illuminance) == 32 && offsetof(StarRecord, color) == 36 &&
              offsetof(StarRecord, variability) == 52);

/// What identifies a star outside the GPU. Parallel to the records.
struct StarIdentity {
  std::uint32_t hr = 0; ///< Harvard Revised (Bright Star Catalogue) number, 0 if none
  std::uint32_t hd = 0; ///< Henry Draper number, 0 if none
  float magnitude = 0;  ///< V above the atmosphere
  std::string name;     ///< Bayer or Flamsteed designation, "" if none
};

/// Where a product came from. Part of the file, so that a product can be traced and made again.
struct StarProvenance {
  std::string source;          ///< title of the catalogue with its reference
  std::string source_file;     ///< file name without folders
  std::string source_sha256;   ///< of the source file as read
  std::string tool;            ///< "vesper-catalog 0.1.0"
  std::string options;         ///< the options that shape the content, as on a command line
  std::string licence;         ///< of the content
  double epoch_jyear = 2000.0; ///< Julian year (TT) of positions
  std::uint64_t read = 0;      ///< entries in the source
  std::uint64_t kept = 0;      ///< entries in the product
  double illuminance_lux = 0;  ///< sum over kept stars, in double precision before rounding to floats
};

/// A star catalogue sorted by V magnitude (ties by HR number), so that "brighter than m" is a prefix. Illuminance falls
/// only nearly in step: stars of one magnitude differ in lux with their colour.
struct StarCatalogue {
  std::vector<StarRecord> stars;
  std::vector<StarIdentity> identities;
  StarProvenance provenance;
};

} // namespace vesper
