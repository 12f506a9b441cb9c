// The arrays of ERFA's C interface as vectors and matrices.
#pragma once

#include "vesper/base/vector.hpp"

namespace vesper {

[[nodiscard]] inline Vec3 vector_of(const double (&v)[3]) { return {v[0], v[1], v[2]}; }

/// ERFA's matrices are arrays of rows.
[[nodiscard]] inline Mat3 matrix_of(const double (&rows)[3][3]) {
  return glm::transpose(Mat3(vector_of(rows[0]), vector_of(rows[1]), vector_of(rows[2])));
}

} // namespace vesper
